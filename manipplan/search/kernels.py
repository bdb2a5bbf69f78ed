"""Compiled kernels of the searches: cells, one step of the dynamic program, and the paper's restarts.

A step goes from the candidates of one layer to those of the next. All values are maximised. Candidates are sorted by cell
(`sort_into_cells`). `previous` is -inf where a candidate is not reached, `top` is the largest value of each cell. Threads share
a layer: each works on cells first_cell to last_cell - 1. Results are written to value, source (the index in the previous layer,
-1 where there is none) and new_top.
"""

import numpy as np
from numpy.typing import NDArray

from manipplan.search.steps import TAU
from manipplan.support.checks import Array
from manipplan.support.compiling.kernels import kernel

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
        # compared as floats: a very large value would overflow an integer
        place = min(max(place, 0.0), size - 1.0)
        cell = cell * size + int(place)
    return cell


@kernel
def taking_part(m: Array, threshold: float, share: float) -> Numbers:
    """Indices of the candidates with m >= threshold; with a share below 1, of about that share of them.

    The choice is pseudo-random but reproducible, and a smaller share is a subset of a larger one.
    """
    taken = np.empty(len(m) + 1, dtype=np.int32)
    count = 0
    if share >= 1.0:
        for i in range(len(m)):  # always written: a branch would be mispredicted too often
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
    """The candidates of a layer that take part, sorted by cell.

    Returns their indices (k,), configurations (k, n) with joints in the given order, manipulability (k,) limited to `cap`, and
    the start of each cell (cells + 1,). Runs in time linear in candidates and cells.
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
    """The largest value of each cell (cells,), -inf for an empty one."""
    top = np.full(len(start) - 1, -np.inf)
    for cell in range(len(top)):
        for b in range(start[cell], start[cell + 1]):
            top[cell] = max(top[cell], value[b])
    return top


#: Maximum number of cells around a cell, including itself.
ADJOINING = 27


@kernel
def cells_around(cell: int, count: Whole, wraps: Truth, top: Array, near: Whole) -> int:
    """The cells around `cell`, including itself, that hold a value above -inf, in descending order of their largest value.

    Fills near (ADJOINING,) and returns their number. `top` (cells,) holds the largest value of each cell.
    """
    size0, size1, size2 = count[0], count[1], count[2]
    c2 = cell % size2
    c1 = cell // size2 % size1
    c0 = cell // (size2 * size1)
    found = 0
    for k0 in range(3 if size0 > 1 else 1):
        a = c0 + (0, -1, 1)[k0]  # on ties the cell itself comes first: its candidates are the most likely neighbours
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
    """Displacement of a joint from a to b; the shorter way for a continuous joint."""
    d = b - a
    if turns:
        d -= TAU * np.floor(d / TAU + 0.5)
    return d


@kernel
def is_near(rows: Array, i: int, others: Array, k: int, reach: Array, turns: Truth) -> bool:
    """Whether each joint's step from rows[i] to others[k] is below its limit `reach`."""
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
    """V(b) = max over neighbours a of V(a) - ‖step‖: the negative minimum length; if ranked, a higher `rank` (a) goes first."""
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
    """V(b) = max over neighbours a of min(V(a), -max_j |step_j| / ε_j): the negative smallest factor of ε that connects."""
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


#: Entries of the state array of `search_restarts`.
PHASE, LEVEL, STARTS, BRANCHES, COMPARISONS, STATE = 0, 1, 2, 3, 4, 5
#: Return status of a call.
UNFINISHED, FOUND, EXHAUSTED, TOO_MANY = 0, 1, 2, 3
#: Phases: take the next start, extend the path to the last layer, extend the path to the first layer.
NEXT, UP, DOWN = 0, 1, 2


@kernel
def search_restarts(
    q: Array, m: Array, offset: Whole, starts: Whole, layer_of: Whole, reach: Array, turns: Truth, memoised: bool,
    most_branches: int, budget: int, state: Whole, path: Whole, pointer: Whole, seen: Whole,
) -> int:  # fmt: skip
    """Continue the search for about `budget` comparisons of configurations.

    q (N, n), m (N,): candidates of all layers, each layer in descending order of manipulability; offset (L + 1,): start of each
    layer. starts (N,): candidates in the order in which they start a path; layer_of (N,): their layers. state (STATE,),
    path (L,), pointer (L,) and seen (N,) hold the state of the search and are updated.
    """
    layers = len(offset) - 1
    stop = state[COMPARISONS] + budget
    while state[COMPARISONS] < stop:
        if state[PHASE] == NEXT:
            if state[STARTS] == len(starts):
                return EXHAUSTED
            start = starts[state[STARTS]]
            state[STARTS] += 1
            level = layer_of[start]
            path[level] = start
            state[LEVEL] = level
            state[PHASE] = UP
            if level < layers - 1:
                pointer[level + 1] = offset[level + 1]
        start = starts[state[STARTS] - 1]
        first, least = layer_of[start], m[start]
        level = state[LEVEL]
        if state[PHASE] == UP and level == layers - 1:
            state[PHASE], state[LEVEL], level = DOWN, first, first
            if first > 0:
                pointer[first - 1] = offset[first - 1]
        if state[PHASE] == DOWN and level == 0:
            return FOUND
        following = level + 1 if state[PHASE] == UP else level - 1
        i, here = pointer[following], path[level]
        end = offset[following + 1]
        found = False
        while i < end and m[i] >= least:
            if not memoised or seen[i] != state[STARTS]:
                state[COMPARISONS] += 1
                if is_near(q, here, q, i, reach, turns):
                    found = True
                    break
            i += 1
        if found:
            if state[BRANCHES] >= most_branches:
                pointer[following] = i
                return TOO_MANY
            pointer[following] = i + 1
            path[following] = i
            seen[i] = state[STARTS]
            state[BRANCHES] += 1
            state[LEVEL] = following
            beyond = following + 1 if state[PHASE] == UP else following - 1
            if 0 <= beyond < layers:
                pointer[beyond] = offset[beyond]
        elif level == first:  # this half has no path: the start fails
            state[PHASE] = NEXT
        else:
            state[LEVEL] = level - 1 if state[PHASE] == UP else level + 1
    return UNFINISHED
