"""TiltLimit: an axis of the tool stays near a direction of the world, as that of a cup which must not spill."""

from dataclasses import dataclass

import casadi as ca
import numpy as np
from numpy.typing import ArrayLike

from manipplan.constraints.constraint import Constraint, SymbolicPose, tool_name
from manipplan.support.checks import Array, finite_array, number
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError

#: Smallest angle of a limit [rad], and smallest sine by which its row is scaled.
LEAST_ANGLE, LEAST_SINE = 1e-3, 0.05


@one_line
@dataclass(frozen=True)
class TiltLimit(Constraint):
    """An axis of the tool stays within an angle of a direction.

    Attributes:
        axis: (3,) in the tool's frame, of any length; kept with length 1.
        direction: (3,) in the world's frame, which is that of the base unless `robot.at` moved it; likewise.
        angle: largest angle between the two [rad], from 1e-3 to below π.
        tool: the tool frame of a robot with several; None: the first one.

    Raises InvalidInputError: an axis or direction of zero length, or another angle.
    """

    axis: ArrayLike
    direction: ArrayLike
    angle: float
    tool: str | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "axis", _unit("axis", self.axis))
        object.__setattr__(self, "direction", _unit("direction", self.direction))
        angle = number("angle", self.angle, least=LEAST_ANGLE)
        if angle >= np.pi:
            raise InvalidInputError("angle", angle, "an angle below π [rad]: any tool keeps a larger one")
        object.__setattr__(self, "angle", angle)
        tool_name(self.tool)

    @property
    def name(self) -> str:
        return f"tilt of {self.tool or 'tool'} axis {_shown(self.axis)} from {_shown(self.direction)}"

    @property
    def of_tool(self) -> str | None:
        return self.tool

    def rows(self, at: SymbolicPose) -> ca.SX:
        axis, direction = ca.DM(self.axis), ca.DM(self.direction)
        return (ca.dot(direction, at.rotation @ axis) - np.cos(self.angle)) / self._scale

    def tool_rows(self) -> Array:
        axis, direction = np.array(self.axis), np.array(self.direction)
        columns = (axis[:, None] * direction).ravel()
        return np.concatenate([np.zeros(3), columns, [-np.cos(self.angle)]])[None] / self._scale

    def figure(self, value: float) -> str:
        tilt = np.rad2deg(np.arccos(np.clip(value * self._scale + np.cos(self.angle), -1.0, 1.0)))
        return f"up to {tilt:.5g}°, allowed {np.rad2deg(self.angle):.5g}°"

    @property
    def _scale(self) -> float:
        """The slope of the cosine at the limit: the row is about the angle that is left [rad]."""
        sine = float(np.sin(self.angle))
        return sine if self.angle <= np.pi / 2 else max(sine, LEAST_SINE)


def contradiction(one: TiltLimit, other: TiltLimit) -> bool:
    """Whether no rotation of a tool keeps both limits."""
    axes, directions = (
        float(np.arccos(np.clip(np.dot(a, b), -1.0, 1.0)))
        for a, b in ((one.axis, other.axis), (one.direction, other.direction))
    )
    return abs(axes - directions) > one.angle + other.angle


def _unit(argument: str, vector: ArrayLike) -> tuple[float, ...]:
    array = finite_array(argument, vector, (3,))
    array = array / max(float(np.abs(array).max()), 1e-9)
    length = float(np.linalg.norm(array))
    if length < 1e-9:
        raise InvalidInputError(argument, vector, "a vector (3,) that is not zero")
    return tuple(float(each) for each in array / length)


def _shown(vector: ArrayLike) -> str:
    return "(" + ", ".join(f"{each:.4g}" for each in np.asarray(vector)) + ")"
