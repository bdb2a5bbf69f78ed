"""Numbers with few bits, so that rounding errors of linear algebra do not decide where an iteration goes.

Processors add up in different orders, so results of a solver differ in their last digits. An iteration can amplify such
differences from step to step, until they lead to another local optimum. Rounded steps are the same on every processor, but
where a number lies just between two of the grid.
"""

import numpy as np
from numpy.typing import ArrayLike

from manipplan.checks import Array
from manipplan.paths.joint import JointPath

#: Configurations are rounded to multiples of this before bodies are measured: which points of two parallel faces are the
#: nearest hangs on their last bits. No distance changes by more than its own accuracy [rad or m].
FINE = 2.0**-36
#: Distances are rounded to multiples of this [m].
FINE_DISTANCE = 2.0**-40
#: Numbers that are found once by linear algebra, and used in all that follows, are rounded to multiples of this.
FIXED = 2.0**-42


def on_grid(values: Array, spacing: float) -> Array:
    """The nearest multiples of `spacing`."""
    return np.asarray(np.round(values / spacing) * spacing)


def configurations(path: JointPath, s: ArrayLike) -> Array:
    """The configurations (m, n) of a path at s (m,), on the fine grid."""
    return on_grid(path(s), FINE)


def product(left: Array, right: Array) -> Array:
    """The matrix product, with the same order of additions on every processor, which that of a BLAS has not."""
    return np.asarray(np.einsum("ij,jk->ik", left, right))


def gauss_rule(count: int) -> tuple[Array, Array]:
    """Gauss points on [-1, 1] and their weights, (count,) each, rounded: NumPy finds them as eigenvalues."""
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return on_grid(nodes, FIXED), on_grid(weights, FIXED)


def with_bits(values: Array, bits: int) -> Array:
    """The values on a grid such that the largest absolute one has about this number of bits."""
    largest = float(np.abs(values).max(initial=0.0))
    return on_grid(values, 2.0 ** (np.frexp(largest)[1] - bits)) if largest > 0 else values
