"""Duplicate solutions: at a double root a closed form gives the same configuration twice."""

import numpy as np
from numpy.typing import NDArray

from manipplan.support.checks import Array
from manipplan.support.compiling.kernels import kernel

#: Configurations of one sample that differ by less than this are the same [rad or m].
SAME = 1e-6


def distinct(q: Array, source: NDArray[np.int64]) -> NDArray[np.int64]:
    """Indices of the rows of q (k, n), only the first of those of one sample that differ by less than `SAME`."""
    order = np.argsort(source, kind="stable")
    return order[_first_ones(np.ascontiguousarray(q[order]), source[order])]


@kernel
def _first_ones(q: Array, source: NDArray[np.int64]) -> NDArray[np.bool_]:
    keep = np.ones(len(q), dtype=np.bool_)
    for row in range(len(q)):
        other = row - 1
        while other >= 0 and source[other] == source[row] and keep[row]:
            k = 0
            while k < q.shape[1] and abs(q[row, k] - q[other, k]) < SAME:
                k += 1
            keep[row] = k < q.shape[1] or not keep[other]
            other -= 1
    return keep
