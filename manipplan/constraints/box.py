"""PositionBox: the tool's point stays inside a box."""

from dataclasses import dataclass

import casadi as ca
import numpy as np
import pinocchio as pin
from numpy.typing import ArrayLike

from manipplan.constraints.constraint import Constraint, SymbolicPose, tool_name
from manipplan.support.checks import Array, number_array, pose_matrix
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError

#: Smallest width of a box [m].
LEAST_WIDTH = 1e-3


@one_line
@dataclass(frozen=True)
class PositionBox(Constraint):
    """The origin of the tool frame stays inside a box.

    Attributes:
        lower, upper: (3,) corners in the frame of `pose` [m], at least 1e-3 m apart; -inf and inf leave a side open.
        pose: (4, 4) or pin.SE3 of the box's frame in the world; None: the world's own.
        tool: the tool frame of a robot with several; None: the first one.

    Raises InvalidInputError: a box without an inside, or without any wall.
    """

    lower: ArrayLike
    upper: ArrayLike
    pose: ArrayLike | pin.SE3 | None = None
    tool: str | None = None

    def __post_init__(self) -> None:
        for name in ("lower", "upper"):
            given = getattr(self, name)
            array = number_array(name, given)
            if array.shape != (3,) or np.isnan(array).any():
                raise InvalidInputError(name, given, "three numbers [m]; -inf and inf leave a side open")
            object.__setattr__(self, name, tuple(array.tolist()))
        lower, upper = np.array(self.lower), np.array(self.upper)
        for axis, low, high in zip("xyz", lower, upper, strict=True):
            if not high - low >= LEAST_WIDTH:
                wanted = f"a box whose upper {axis} is at least {LEAST_WIDTH:g} m above the lower one"
                raise InvalidInputError("upper", f"{axis} from {low:g} to {high:g}", wanted)
        if not np.isfinite(np.concatenate([lower, upper])).any():
            raise InvalidInputError("upper", list(upper), "a box with at least one wall")
        if self.pose is not None:
            matrix = pose_matrix("pose", self.pose)
            object.__setattr__(self, "pose", tuple(tuple(float(each) for each in row) for row in matrix))
        tool_name(self.tool)

    @property
    def name(self) -> str:
        sides = zip("xyz", np.asarray(self.lower), np.asarray(self.upper), strict=True)
        walls = [f"{axis} {low:g} to {high:g}" for axis, low, high in sides if np.isfinite([low, high]).any()]
        frame = "" if self.pose is None else ", in its frame"
        return f"{self.tool or 'tool'} position {', '.join(walls)} m{frame}"

    @property
    def of_tool(self) -> str | None:
        return self.tool

    def rows(self, at: SymbolicPose) -> ca.SX:
        walls = self.tool_rows()
        return ca.DM(walls[:, :3]) @ at.position + ca.DM(walls[:, -1])

    def tool_rows(self) -> Array:
        frame = np.eye(4) if self.pose is None else np.array(self.pose)
        rows = []
        for axis, low, high in zip(frame[:3, :3].T, np.asarray(self.lower), np.asarray(self.upper), strict=True):
            at = float(axis @ frame[:3, 3])
            rows += [[*axis, *[0.0] * 9, -at - low]] if np.isfinite(low) else []
            rows += [[*-axis, *[0.0] * 9, at + high]] if np.isfinite(high) else []
        return np.array(rows)

    def figure(self, value: float) -> str:
        return f"{1e3 * value:.4g} mm inside" if value >= 0 else f"{-1e3 * value:.4g} mm outside"
