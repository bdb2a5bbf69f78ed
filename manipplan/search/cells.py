"""Kernels that sort candidates into cells."""

import numpy as np
from numpy.typing import NDArray

from manipplan.checks import Array
from manipplan.kernels import kernel
from manipplan.search.steps import TAU

Whole = NDArray[np.int64]
Numbers = NDArray[np.int32]
Truth = NDArray[np.bool_]


@kernel
def cell_of(q: Array, i: int, joints: Whole, low: Array, per: Array, count: Whole, wraps: Truth) -> int:
    """The cell of row i of q (k, n)."""
    cell = 0
    for axis in range(3):
        size = count[axis]
        if size == 1:
            continue
        x = q[i, joints[axis]]
        if wraps[axis]:
            x /= TAU
            place = (x - np.floor(x)) * size
        else:
            place = (x - low[axis]) * per[axis]
        # compared as numbers with a point: a huge one would not fit an integer
        place = min(max(place, 0.0), size - 1.0)
        cell = cell * size + int(place)
    return cell


@kernel
def taking_part(m: Array, threshold: float, share: float) -> Numbers:
    """Numbers of the candidates with m >= threshold; with a share below 1, of about that share of them.

    The choice is random in effect but always the same, and a smaller share is part of a larger one.
    """
    taken = np.empty(len(m) + 1, dtype=np.int32)
    count = 0
    if share >= 1.0:
        for i in range(len(m)):  # written in any case: a branch would be guessed wrong too often
            taken[count] = i
            count += m[i] >= threshold
    else:
        below = np.uint64(share * 2.0**32)
        for i in range(len(m)):
            taken[count] = i
            mixed = (np.uint64(i) ^ (np.uint64(i) >> np.uint64(15))) * np.uint64(0x9E3779B97F4A7C15)
            count += (m[i] >= threshold) & ((mixed >> np.uint64(32)) < below)
    return taken[:count]


@kernel
def sort_into_cells(
    q: Array, m: Array, threshold: float, share: float, cap: float,
    joints: Whole, low: Array, per: Array, count: Whole, wraps: Truth, order: Whole,
) -> tuple[Numbers, Array, Array, Numbers]:  # fmt: skip
    """The candidates of a layer that take part, in the order of their cells.

    Returns their numbers (k,), configurations (k, n) with joints in the given order, indices (k,) of `cap` at most, and where
    each cell begins (cells + 1,). Takes time in proportion to candidates and cells.
    """
    n = q.shape[1]
    cells = count[0] * count[1] * count[2]
    taken = taking_part(m, threshold, share)
    active = len(taken)
    cell = np.empty(active, dtype=np.int32)
    start = np.zeros(cells + 1, dtype=np.int32)
    for k in range(active):
        c = cell_of(q, taken[k], joints, low, per, count, wraps)
        cell[k] = c
        start[c + 1] += 1
    for c in range(cells):
        start[c + 1] += start[c]
    following = start[:-1].copy()
    ids = np.empty(active, dtype=np.int32)
    rows = np.empty((active, n))
    values = np.empty(active)
    for k in range(active):
        i, place = taken[k], following[cell[k]]
        following[cell[k]] += 1
        ids[place] = i
        values[place] = min(m[i], cap)
        for j in range(n):
            rows[place, j] = q[i, order[j]]
    return ids, rows, values, start


@kernel
def largest_of_each(start: Numbers, value: Array) -> Array:
    """The largest value of each cell (cells,), -inf of an empty one."""
    top = np.full(len(start) - 1, -np.inf)
    for cell in range(len(top)):
        for b in range(start[cell], start[cell + 1]):
            top[cell] = max(top[cell], value[b])
    return top
