"""Task: which motions of the tool count, and what length makes radians comparable with metres."""

from dataclasses import dataclass

import casadi as ca
import numpy as np
from numpy.typing import ArrayLike

from manipplan.checks import finite_array, number


@dataclass(frozen=True, kw_only=True)
class Task:
    """Rows of the tool's Jacobian: linear rows, then angular rows times `length` [m].

    Build one by `pose`, `position`, `orientation`, `planar` or `pointing`.

    Attributes:
        name: what it is called in reports.
        linear: rows, each a direction (3) in the world along which the tool's origin moves.
        angular: rows, each an axis (3) about which the tool turns; in the tool's frame when `in_tool`, else in the world.
        length: characteristic length [m] that weighs angular rows; 1.0 leaves the raw Jacobian.
        in_tool: whether the angular axes turn with the tool.
    """

    name: str
    linear: tuple[tuple[float, float, float], ...]
    angular: tuple[tuple[float, float, float], ...]
    length: float = 1.0
    in_tool: bool = False

    @classmethod
    def pose(cls, length: float = 0.5) -> "Task":
        """Position and orientation, 6 rows; angular rows times `length` [m] > 0."""
        return cls(name="pose", linear=_AXES, angular=_AXES, length=number("length", length, above=0.0))

    @classmethod
    def position(cls) -> "Task":
        """Position alone, 3 rows."""
        return cls(name="position", linear=_AXES, angular=())

    @classmethod
    def orientation(cls) -> "Task":
        """Orientation alone, 3 rows."""
        return cls(name="orientation", linear=(), angular=_AXES)

    @classmethod
    def planar(cls) -> "Task":
        """Position in the x-y plane, 2 rows: the index of the planar arm in [kth2012]."""
        return cls(name="planar", linear=_AXES[:2], angular=())

    @classmethod
    def pointing(cls, axis: ArrayLike = (0.0, 0.0, 1.0), length: float = 0.5) -> "Task":
        """Position and direction of a tool axis (3,) given in the tool's frame, 5 rows: rotation about it is free."""
        direction = finite_array("axis", axis, (3,))
        size = number("the length of axis", float(np.linalg.norm(direction)), above=1e-9)
        _, _, basis = np.linalg.svd((direction / size)[None, :])
        first, second = (tuple(float(x) for x in row) for row in basis[1:])
        return cls(
            name="pointing",
            linear=_AXES,
            angular=((first[0], first[1], first[2]), (second[0], second[1], second[2])),
            length=number("length", length, above=0.0),
            in_tool=True,
        )

    @property
    def rows(self) -> int:
        """Number m of task rows."""
        return len(self.linear) + len(self.angular)

    @property
    def unit(self) -> str:
        """Unit of the manipulability index: every row counts metres; with length 1 radians are left uncounted."""
        power = self.rows if self.length != 1.0 or not self.angular else len(self.linear)
        return "1" if power == 0 else f"m^{power}"

    def rows_of(self, jacobian: ca.SX, rotation: ca.SX) -> ca.SX:
        """The task's rows (m, n) of a (6, n) LOCAL_WORLD_ALIGNED Jacobian, for a tool with `rotation` (3, 3)."""
        linear = ca.DM(self.linear).reshape((len(self.linear), 3)) @ jacobian[:3, :]
        axes = ca.DM(self.angular).reshape((len(self.angular), 3))
        spin = (axes @ rotation.T if self.in_tool else axes) @ jacobian[3:, :]
        return ca.vertcat(linear, self.length * spin)


_AXES = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
