"""End conditions of a path beyond its ends themselves: derivatives by s that are fixed at s = 0 and s = 1."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from manipplan.checks import Array
from manipplan.errors import InvalidInputError
from manipplan.optimize.basis import Basis
from manipplan.optimize.rounding import FIXED, on_grid
from manipplan.paths.joint import JointPath

#: A path has an end derivative when no joint is off by more than this share of it, or of the way.
TOLERANCE = 1e-6
#: Slopes of integrated Legendre polynomials come out orthogonal to this.
ORTHOGONAL = 1e-10


@dataclass(frozen=True, kw_only=True, eq=False)
class EndConditions:
    """Derivatives q' (slope) and q'' (bend) by the parameter s, (n,) each [rad or m]; None: free.

    Each takes one coefficient of every joint: one piece needs a degree of one more than there are conditions.
    """

    start_slope: Array | None = None
    goal_slope: Array | None = None
    start_bend: Array | None = None
    goal_bend: Array | None = None

    @property
    def pattern(self) -> tuple[tuple[float, int], ...]:
        """Which are fixed: place s and order of each."""
        return tuple((s, order) for s, order, value in self._all() if value is not None)

    def check_degree(self, basis_of: Callable[[int], Basis], degree: int) -> None:
        """Raise InvalidInputError for a degree below what the conditions need in the basis, given by `basis_of` a degree."""
        if self.possible(basis_of(degree)):
            return
        count = len(self.pattern)
        least = next(k for k in range(degree + 1, degree + 2 + count) if self.possible(basis_of(k)))
        wanted = f"at least {least}: start and goal need one, and each of the {count} end conditions one more"
        if len(basis_of(degree).breaks) > 2:
            wanted = f"at least {least} for these {count} end conditions and so many pieces"
        raise InvalidInputError("degree", degree, wanted)

    def possible(self, basis: Basis) -> bool:
        """Whether a path in the basis can have these derivatives."""
        rows = end_rows(self.pattern, basis)
        return not len(rows) or (basis.size > 0 and int(np.linalg.matrix_rank(rows)) == len(rows))

    def met(self, basis: Basis, coefficients: Array, start: Array, goal: Array) -> Array:
        """The coefficients (n, size) of the path that meets the conditions and whose slopes are nearest to those given."""
        line = {1: goal - start, 2: np.zeros_like(start)}
        wanted = [value - line[order] for _, order, value in self._all() if value is not None]
        if not wanted:
            return coefficients
        rows, across = end_rows(self.pattern, basis), orthonormal(basis)
        missing = np.column_stack(wanted) - coefficients @ rows.T
        return np.asarray(coefficients + (across @ np.linalg.lstsq(rows @ across, missing.T, rcond=None)[0]).T)

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


def end_rows(pattern: tuple[tuple[float, int], ...], basis: Basis) -> Array:
    """φ_j' or φ_j'' at the ends, (c, size)."""
    rows = [basis.values(np.array([s]), order)[0] for s, order in pattern]
    return np.array(rows).reshape(len(pattern), basis.size)


def free_directions(pattern: tuple[tuple[float, int], ...], basis: Basis) -> Array:
    """Directions (size, f) of a joint's coefficients that keep the conditions, and whose slopes are orthogonal.

    IPOPT adds multiples of the identity to the Hessian, which so mean the same in every basis; so do the trust region of the
    descent and the norm of its gradient.
    """
    across = orthonormal(basis)
    if pattern:
        return np.asarray(across @ np.linalg.svd(end_rows(pattern, basis) @ across)[2][len(pattern) :].T)
    are_orthogonal = np.allclose(across, np.diag(np.diag(across)), rtol=0, atol=ORTHOGONAL)  # Legendre
    return np.eye(basis.size) if are_orthogonal else on_grid(across, FIXED)


def orthonormal(basis: Basis) -> Array:
    """The matrix (size, size) of coefficients whose functions ψ have ∫ ψ_i' ψ_j' ds = 1 for i = j, else 0."""
    s, weights = basis.gauss(basis.degree)
    return np.asarray(np.linalg.inv(np.linalg.qr(np.sqrt(weights)[:, None] * basis.values(s, 1)).R))
