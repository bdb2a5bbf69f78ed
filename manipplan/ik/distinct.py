"""Duplicate solutions: at a double root a closed form gives the same configuration twice."""

import numpy as np
from numpy.typing import NDArray

from manipplan.ik.native import calls, real, whole
from manipplan.support.checks import Array
from manipplan.support.tolerances import SAME


def distinct(q: Array, source: NDArray[np.int64]) -> NDArray[np.int64]:
    """Indices of the rows of q (k, n), only the first of those of one sample that differ by less than `SAME`."""
    order = np.argsort(source, kind="stable")
    q, source, keep = real(q[order]), whole(source[order]), np.empty(len(order), dtype=np.bool_)
    calls()["first_ones"](q.ctypes.data, source.ctypes.data, *q.shape, SAME, keep.ctypes.data)
    return order[keep]
