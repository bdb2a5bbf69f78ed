"""Rounding to few bits, so that rounding errors of linear algebra do not change what an iteration does.

Processors add up in different orders, so results of a solver differ in their last digits. An iteration can amplify such
differences from step to step, until they lead to another local optimum. Rounded steps are the same on every processor,
except where a number lies halfway between two points of the grid.
"""

from functools import cache
from math import frexp

import numpy as np

from manipplan.paths.joint import JointPath
from manipplan.support.checks import Array, ArrayLike

#: Grid spacing of configurations before distances are computed [rad or m]: the nearest points of two parallel faces depend on
#: the last bits. No distance changes by more than its own accuracy.
FINE = 2.0**-36
#: Grid spacing of distances [m].
FINE_DISTANCE = 2.0**-40
#: Grid spacing of numbers that linear algebra computes once and all later steps use.
FIXED = 2.0**-42


def on_grid(values: Array, spacing: float) -> Array:
    """The nearest multiples of `spacing`."""
    return np.asarray(np.rint(values / spacing) * spacing)


def configurations(path: JointPath, s: ArrayLike) -> Array:
    """The configurations (m, n) of a path at s (m,), on the fine grid."""
    return path.curve()(np.asarray(s, dtype=float), FINE)


def product(left: Array, right: Array) -> Array:
    """The matrix product, with the same order of additions on every processor, which a BLAS does not guarantee."""
    return np.asarray(np.einsum("ij,jk->ik", left, right))


@cache
def gauss_rule(count: int) -> tuple[Array, Array]:
    """Gauss points on [-1, 1] and their weights, (count,) each, rounded: NumPy computes them as eigenvalues. Read-only."""
    nodes, weights = (on_grid(each, FIXED) for each in np.polynomial.legendre.leggauss(count))
    nodes.flags.writeable = weights.flags.writeable = False
    return nodes, weights


def with_bits(values: Array, bits: int) -> Array:
    """The values, rounded so that the largest absolute value has about `bits` bits."""
    largest = float(np.abs(values).max(initial=0.0))
    return on_grid(values, 2.0 ** (frexp(largest)[1] - bits)) if largest > 0 else values
