"""End conditions of a path beyond its ends themselves: derivatives by s that are fixed at s = 0 and s = 1."""

from dataclasses import dataclass

import numpy as np

from manipplan.checks import Array
from manipplan.errors import InvalidInputError
from manipplan.paths.joint import JointPath

#: A path has an end derivative when no joint is off by more than this share of it, or of the way.
TOLERANCE = 1e-6


@dataclass(frozen=True, kw_only=True, eq=False)
class EndConditions:
    """Derivatives q' (slope) and q'' (bend) by the parameter s, (n,) each [rad or m]; None: free.

    Each takes one coefficient of every joint: a path needs a degree of one more than there are conditions.
    """

    start_slope: Array | None = None
    goal_slope: Array | None = None
    start_bend: Array | None = None
    goal_bend: Array | None = None

    @property
    def pattern(self) -> tuple[tuple[float, int], ...]:
        """Which are fixed: place s and order of each."""
        return tuple((s, order) for s, order, value in self._all() if value is not None)

    def check_degree(self, degree: int) -> None:
        """Raise InvalidInputError for a degree below what the conditions need."""
        least = 1 + len(self.pattern)
        if degree < least:
            wanted = f"at least {least}: start and goal need one, and each of the {len(self.pattern)} end conditions one more"
            raise InvalidInputError("degree", degree, wanted)

    def met(self, coefficients: Array, start: Array, goal: Array) -> Array:
        """The coefficients (n, k - 1) of φ_j nearest to the given ones whose path meets the conditions."""
        rows = end_rows(self.pattern, coefficients.shape[1] + 1)
        line = {1: goal - start, 2: np.zeros_like(start)}
        wanted = [value - line[order] for _, order, value in self._all() if value is not None]
        if not wanted:
            return coefficients
        missing = np.column_stack(wanted) - coefficients @ rows.T
        return np.asarray(coefficients + np.linalg.lstsq(rows, missing.T, rcond=None)[0].T)

    def met_by(self, path: JointPath) -> bool:
        """Whether a path has these derivatives at its ends."""
        way = float(np.abs(path.goal - path.start).max())
        return all(
            np.abs(path(s, order) - value).max() <= TOLERANCE * max(way, float(np.abs(value).max()))
            for s, order, value in self._all()
            if value is not None
        )

    def _all(self) -> tuple[tuple[float, int, Array | None], ...]:
        return (
            (0.0, 1, self.start_slope),
            (1.0, 1, self.goal_slope),
            (0.0, 2, self.start_bend),
            (1.0, 2, self.goal_bend),
        )


def end_rows(pattern: tuple[tuple[float, int], ...], degree: int) -> Array:
    """φ_j' or φ_j'' at the ends, (c, degree - 1): φ_j' = P_j(2s - 1), and P_j'(±1) = (±1)^(j+1) j (j + 1) / 2."""
    j = np.arange(1, degree)
    rows = []
    for s, order in pattern:
        sign = np.ones(len(j)) if s == 1.0 else (-1.0) ** (j + order - 1)
        rows.append(sign * (j * (j + 1) if order == 2 else 1.0))
    return np.array(rows).reshape(len(pattern), len(j))


def free_directions(pattern: tuple[tuple[float, int], ...], degree: int) -> Array:
    """An orthonormal basis (degree - 1, f) of the changes of a joint's coefficients that keep the conditions."""
    rows = end_rows(pattern, degree)
    if not len(rows):
        return np.eye(degree - 1)
    return np.asarray(np.linalg.svd(rows)[2][len(rows) :].T)
