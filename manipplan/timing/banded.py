"""A sum of functions of neighbouring unknowns to second order: a gradient, and a Hessian of five diagonals.

Rows are linear functions of up to three neighbours, y_i = Σ_m rows[m][i] c_i+m: a tuple of their coefficients, (k,) each, or
(k, r) for r rows at each place.
"""

import numpy as np

from manipplan.support.checks import Array

Rows = tuple[Array, ...]


class BandedModel:
    """Gradient and Hessian in unknowns c (count,), to which terms are added."""

    def __init__(self, count: int) -> None:
        self.gradient = np.zeros(count)
        #: the symmetric matrix from its diagonal on: [d, i] is entry (i, i + d)
        self.hessian = np.zeros((3, count))

    def add(self, rows: Rows, slope: Array, bend: Array, *, at: int = 0) -> None:
        """Add a function of each row by its first and second derivative there; the first row begins at c[at]."""
        count = len(rows[0])
        for m, row in enumerate(rows):
            self.gradient[at + m : at + m + count] += _product(slope, row)
            for j in range(m + 1):
                self.hessian[m - j, at + j : at + j + count] += _product(bend * row, rows[j])

    def barrier(self, slope: Rows, slack: Array, *, at: int = 0) -> None:
        """Add -log of slacks, linearised: their derivatives are the rows `slope`. An infinite slack adds nothing."""
        self.add(slope, -1 / slack, 1 / slack**2, at=at)

    def tie_ends(self, first: float, last: float) -> None:
        """Eliminate the outermost unknowns, which change `first` and `last` times as much as their neighbours."""
        g, H = self.gradient, self.hessian
        g[1] += first * g[0]
        H[0, 1] += 2 * first * H[1, 0] + first**2 * H[0, 0]
        H[1, 1] += first * H[2, 0]
        g[-2] += last * g[-1]
        H[0, -2] += 2 * last * H[1, -2] + last**2 * H[0, -1]
        H[1, -3] += last * H[2, -3]
        self.gradient, self.hessian = g[1:-1], H[:, 1:-1]

    def newton_step(self) -> tuple[Array, float]:
        """The step to the model's least value, and the Newton decrement: twice the fall."""
        from scipy.linalg import solveh_banded

        size = len(self.gradient)
        scale = 1 / np.sqrt(self.hessian[0])
        banded = np.zeros((min(3, size), size))
        banded[0] = 1.0 + 1e-14  # scaled to a unit diagonal, and kept positive definite
        for d in range(1, len(banded)):
            banded[d, :-d] = self.hessian[d, :-d] * (scale[:-d] * scale[d:])
        step = -scale * solveh_banded(banded, scale * self.gradient, lower=True, check_finite=False)
        return step, float(-self.gradient @ step)


def applied(rows: Rows, c: Array) -> Array:
    """The values of rows at c."""
    count = len(rows[0])
    parts = [row * (c[m : m + count] if row.ndim == 1 else c[m : m + count, None]) for m, row in enumerate(rows)]
    return np.asarray(sum(parts[1:], parts[0]))


def _product(left: Array, right: Array) -> Array:
    """left · right, summed over the rows at each place."""
    return left * right if left.ndim == 1 else np.asarray(np.einsum("kr,kr->k", left, right))
