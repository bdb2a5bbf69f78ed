"""Relaxation: how stiffly a controller holds its path, and how far it may leave the path.

Points that are one but for rounding: of neighbours nearer than `COINCIDENT` a path keeps one.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from manipplan.support.checks import COINCIDENT, Array, number
from manipplan.support.errors import InvalidInputError
from manipplan.symbolic.task import Task


@dataclass(frozen=True, kw_only=True)
class StiffnessProfile:
    """f_e of Q_δ = f_e I in (3): high at both ends of a path, low in between, by two polynomials (figure 1 of dufour2020).

    f_e(u) = low + (high - low) abs(1 - 2u)^degree for u in [0, 1], the fraction of the time.

    Attributes:
        high: Q_high at the ends; the paper uses 1e4 to 1e5.
        low: Q_low in the middle; the paper uses 1 to 10.
        degree: of the polynomials; the higher it is, the shorter the stiff phases.
    """

    high: float = 1e4
    low: float = 1.0
    degree: float = 6.0

    def __post_init__(self) -> None:
        number("low", self.low, above=0.0)
        number("high", self.high, least=self.low)
        number("degree", self.degree, least=1.0)

    def __call__(self, u: float) -> float:
        """The stiffness at the fraction u of the time."""
        u = number("u", u, least=0.0, most=1.0)
        return float(self.low + (self.high - self.low) * abs(1 - 2 * u) ** self.degree)


#: A constant stiffness, or a function of the fraction of the time.
Stiffness = float | Callable[[float], float]


#: Smallest tolerance [m, rad]: a fraction of it is the rounding error of the kinematics.
SMALLEST = 1e-9


@dataclass(frozen=True, kw_only=True)
class Tolerance:
    """A tube around the path: how far the tool may leave its target.

    Attributes:
        position: maximum distance [m], at least 1e-9; None: no limit.
        rotation: maximum angle [rad], at least 1e-9; None: no limit.
    """

    position: float | None = None
    rotation: float | None = None

    def __post_init__(self) -> None:
        for name in ("position", "rotation"):
            if getattr(self, name) is not None:
                number(name, getattr(self, name), least=SMALLEST)
        if self.position is None and self.rotation is None:
            raise InvalidInputError("tolerance", None, "a position [m], a rotation [rad], or both")

    def scaled(self, factor: float) -> "Tolerance":
        """A tolerance `factor` times as large, and at least the smallest there is."""
        factor = number("factor", factor, above=0.0)
        position, rotation = (None if part is None else max(factor * part, SMALLEST) for part in (self.position, self.rotation))
        return Tolerance(position=position, rotation=rotation)


#: Default tolerance of the tool on a path.
BETWEEN = Tolerance(position=1e-4, rotation=1e-3)


def with_defaults(tolerance: Tolerance | None, defaults: Tolerance = BETWEEN) -> Tolerance:
    """The tolerance, with the default for a missing part."""
    if tolerance is None:
        return defaults
    position = defaults.position if tolerance.position is None else tolerance.position
    return Tolerance(position=position, rotation=defaults.rotation if tolerance.rotation is None else tolerance.rotation)


def row_shares(task: Task) -> tuple[list[float], list[float]]:
    """Bounds on each row of `task` for tolerances of 1 m and of 1 rad, in the row's unit; 0: a row of the other kind.

    The bounds form a box. If the rows are orthogonal, it lies inside the ball of the tolerance.

    Raises InvalidInputError for a row that mixes translation and rotation.
    """
    rows = np.array([*task.world_rows, *task.tool_rows])
    moves, turns = np.linalg.norm(rows[:, :3], axis=1), np.linalg.norm(rows[:, 3:], axis=1)
    if (moves * turns).any():
        raise InvalidInputError("tolerance", task.name, "a task whose rows are translations or rotations, not both in one")
    position = moves / np.sqrt(max(int(np.count_nonzero(moves)), 1))
    rotation = task.length * turns / np.sqrt(max(int(np.count_nonzero(turns)), 1))
    return position.tolist(), rotation.tolist()


Distances = Callable[[NDArray[np.intp], NDArray[np.intp]], Array]


def distinct(count: int, apart: Distances, most: float = COINCIDENT) -> NDArray[np.intp]:
    """Indices of the points of a sequence that are `most` or more apart from the one chosen before, with the last point.

    `apart` gives the distances of points i and j (k,). The first point and the last one are kept; [0] where all are one.
    """
    every = np.arange(count)
    if (apart(every[:-1], every[1:]) >= most).all():
        return every

    def is_far(first: int, second: int) -> bool:
        return bool(apart(np.array([first]), np.array([second]))[0] >= most)

    chosen = [0]
    for k in range(1, count):
        if is_far(chosen[-1], k):
            chosen.append(k)
    while len(chosen) > 1 and chosen[-1] != count - 1 and not is_far(chosen[-1], count - 1):
        chosen.pop()  # the last point stands for it
    if chosen[-1] != count - 1 and is_far(chosen[-1], count - 1):
        chosen.append(count - 1)
    return np.array(chosen)
