"""Kernel of the restart search of guilamo2006."""

from manipplan.checks import Array
from manipplan.kernels import kernel
from manipplan.search.cells import Truth, Whole
from manipplan.search.kernels import is_near

#: Places of the state that goes in and out of `search_restarts`.
PHASE, LEVEL, STARTS, BRANCHES, COMPARISONS, STATE = 0, 1, 2, 3, 4, 5
#: How a call ended.
UNFINISHED, FOUND, EXHAUSTED, TOO_MANY = 0, 1, 2, 3
#: Phases: the next start is to be taken, the path grows to the last layer, the path grows to the first one.
NEXT, UP, DOWN = 0, 1, 2


@kernel
def search_restarts(
    q: Array, m: Array, offset: Whole, starts: Whole, layer_of: Whole, reach: Array, turns: Truth, memoised: bool,
    most_branches: int, budget: int, state: Whole, path: Whole, pointer: Whole, seen: Whole,
) -> int:  # fmt: skip
    """Go on with the search for about `budget` comparisons of configurations.

    q (N, n), m (N,): candidates of all layers, each layer in descending order of its index; offset (L + 1,) where each
    begins. starts (N,): candidates in the order in which they start a path; layer_of (N,) their layers. state (STATE,),
    path (L,), pointer (L,) and seen (N,) are changed: where the search stands.
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
