"""Kernels of one step of the dynamic programme, from the candidates of a layer to those of the next.

All values are maximised. Candidates lie in the order of their cells (`sort_into_cells`); `previous` is -inf where a
candidate is not reached, `top` is the largest value of each cell, and cells first_cell to last_cell - 1 of the new layer
are worked on, so that threads share a layer. Results go into value, source (the place in the previous layer, -1 where
there is none) and new_top.
"""

import numpy as np

from manipplan.checks import Array
from manipplan.kernels import kernel
from manipplan.search.cells import Numbers, Truth, Whole
from manipplan.search.steps import TAU

#: Cells that adjoin a cell at most, itself among them.
ADJOINING = 27


@kernel
def cells_around(cell: int, count: Whole, wraps: Truth, top: Array, near: Whole) -> int:
    """The cells that adjoin `cell`, itself among them, and hold a value above -inf: the one with the largest value first.

    Fills near (ADJOINING,) and returns how many there are. `top` (cells,) holds the largest value of each cell.
    """
    size0, size1, size2 = count[0], count[1], count[2]
    c2 = cell % size2
    c1 = cell // size2 % size1
    c0 = cell // (size2 * size1)
    found = 0
    for k0 in range(3 if size0 > 1 else 1):
        a = c0 + (0, -1, 1)[k0]  # of equal values the own cell comes first: its candidates are the most likely neighbours
        if a < 0 or a >= size0:
            if not wraps[0]:
                continue
            a = (a + size0) % size0
        for k1 in range(3 if size1 > 1 else 1):
            b = c1 + (0, -1, 1)[k1]
            if b < 0 or b >= size1:
                if not wraps[1]:
                    continue
                b = (b + size1) % size1
            for k2 in range(3 if size2 > 1 else 1):
                c = c2 + (0, -1, 1)[k2]
                if c < 0 or c >= size2:
                    if not wraps[2]:
                        continue
                    c = (c + size2) % size2
                other = (a * size1 + b) * size2 + c
                value = top[other]
                if value > -np.inf:
                    place = found
                    while place > 0 and top[near[place - 1]] < value:
                        near[place] = near[place - 1]
                        place -= 1
                    near[place] = other
                    found += 1
    return found


@kernel
def step(a: float, b: float, turns: bool) -> float:
    """How far a joint turns or moves from a to b; one that turns without end by the shorter way."""
    d = b - a
    if turns:
        d -= TAU * np.floor(d / TAU + 0.5)
    return d


@kernel
def is_near(rows: Array, i: int, others: Array, k: int, reach: Array, turns: Truth) -> bool:
    """Whether each joint's step from rows[i] to others[k] is below its reach."""
    for j in range(rows.shape[1]):
        d = others[k, j] - rows[i, j]
        if not abs(d) < reach[j] and (not turns[j] or not abs(step(rows[i, j], others[k, j], True)) < reach[j]):
            return False
    return True


@kernel
def widest_step(
    old_rows: Array, previous: Array, top: Array, old_start: Numbers, rows: Array, m: Array, start: Numbers,
    first_cell: int, last_cell: int, reach: Array, turns: Truth, count: Whole, wraps: Truth,
    value: Array, source: Numbers, new_top: Array,
) -> None:  # fmt: skip
    """W(b) = min(m(b), max over neighbours a of W(a))."""
    near = np.empty(ADJOINING, np.int64)
    for cell in range(first_cell, last_cell):
        new_top[cell] = -np.inf
        begin, end = start[cell], start[cell + 1]
        if begin == end:
            continue
        adjoining = cells_around(cell, count, wraps, top, near)
        limit = top[near[0]] if adjoining > 0 else -np.inf
        highest = -np.inf
        for b in range(begin, end):
            enough = min(m[b], limit)
            best, where = -np.inf, -1
            for other in near[:adjoining]:
                if top[other] <= best or (where >= 0 and best >= enough):
                    break
                for a in range(old_start[other], old_start[other + 1]):
                    if previous[a] > best and is_near(old_rows, a, rows, b, reach, turns):
                        best, where = previous[a], a
                        if best >= enough:
                            break
            value[b] = min(m[b], best)
            source[b] = where
            highest = max(highest, value[b])
        new_top[cell] = highest


@kernel
def shortest_step(
    old_rows: Array, previous: Array, top: Array, old_start: Numbers, rows: Array, rank: Whole, ranked: bool, start: Numbers,
    first_cell: int, last_cell: int, reach: Array, turns: Truth, count: Whole, wraps: Truth,
    value: Array, source: Numbers, new_top: Array,
) -> None:  # fmt: skip
    """V(b) = max over neighbours a of V(a) - ‖step‖: minus the least length; of a higher `rank` (a) first, if ranked."""
    n = rows.shape[1]
    near = np.empty(ADJOINING, np.int64)
    for cell in range(first_cell, last_cell):
        new_top[cell] = -np.inf
        begin, end = start[cell], start[cell + 1]
        if begin == end:
            continue
        adjoining = cells_around(cell, count, wraps, top, near)
        highest = -np.inf
        for b in range(begin, end):
            best, where, best_rank = -np.inf, -1, -1
            for other in near[:adjoining]:
                if not ranked and top[other] <= best:
                    break
                for a in range(old_start[other], old_start[other + 1]):
                    if previous[a] == -np.inf:
                        continue
                    if ranked:
                        if rank[a] < best_rank or (rank[a] == best_rank and previous[a] <= best):
                            continue
                    elif previous[a] <= best:
                        continue
                    if not is_near(old_rows, a, rows, b, reach, turns):
                        continue
                    square = 0.0
                    for j in range(n):
                        d = step(old_rows[a, j], rows[b, j], turns[j])
                        square += d * d
                    length = previous[a] - np.sqrt(square)
                    if ranked and rank[a] > best_rank:
                        best, where, best_rank = length, a, rank[a]
                    elif length > best:
                        best, where = length, a
            value[b] = best
            source[b] = where
            highest = max(highest, best)
        new_top[cell] = highest


@kernel
def closest_step(
    old_rows: Array, previous: Array, top: Array, old_start: Numbers, rows: Array, epsilon: Array, start: Numbers,
    first_cell: int, last_cell: int, reach: Array, turns: Truth, count: Whole, wraps: Truth,
    value: Array, source: Numbers, new_top: Array,
) -> None:  # fmt: skip
    """V(b) = max over neighbours a of min(V(a), -max_j |step_j| / ε_j): minus the least factor of ε that connects."""
    n = rows.shape[1]
    near = np.empty(ADJOINING, np.int64)
    for cell in range(first_cell, last_cell):
        new_top[cell] = -np.inf
        begin, end = start[cell], start[cell + 1]
        if begin == end:
            continue
        adjoining = cells_around(cell, count, wraps, top, near)
        limit = top[near[0]] if adjoining > 0 else -np.inf
        highest = -np.inf
        for b in range(begin, end):
            best, where = -np.inf, -1
            for other in near[:adjoining]:
                if top[other] <= best or best == limit:
                    break
                for a in range(old_start[other], old_start[other + 1]):
                    if previous[a] <= best or not is_near(old_rows, a, rows, b, reach, turns):
                        continue
                    ratio = 0.0
                    for j in range(n):
                        ratio = max(ratio, abs(step(old_rows[a, j], rows[b, j], turns[j])) / epsilon[j])
                    if min(previous[a], -ratio) > best:
                        best, where = min(previous[a], -ratio), a
            value[b] = best
            source[b] = where
            highest = max(highest, best)
        new_top[cell] = highest
