"""The search of guilamo2006, section IV: paths grown by back-tracking from one start after the other.

The first start is the best candidate of the layer whose best is the least: no path can have a higher minimum. From it a path
grows to the last layer, then from it to the first, each time to the continuous candidate with the highest index that is
not below the index of the start; where there is none, it goes back. If a start fails, the candidate with the next lower
index of any layer is the next one. The first path that is complete is optimal, for each start is searched in full.

The paper does not say how the two halves share back-tracking: here they share the start and nothing else, which is enough, as
either half is possible or not whatever the other one is. Without memory the search takes time that grows exponentially with
the number of layers; `memoised` remembers, for one start, the candidates that led nowhere.
"""

from dataclasses import dataclass
from enum import Enum

import numpy as np
from numpy.typing import ArrayLike, NDArray

from manipplan.search.layers import Layers
from manipplan.search.steps import check_epsilon, exclusive, without_jumps
from manipplan.support.checks import Array, instance, whole_number
from manipplan.support.errors import InvalidInputError, PlanningError

#: Comparisons between two moments at which the search can be interrupted.
BUDGET = 20_000_000


class GuilamoStatus(Enum):
    """How the search ended. The value is the text for people; `ok` tells whether the optimum was found."""

    FOUND = "found: the first complete path; none has a larger minimum manipulability"
    GAVE_UP = "failed: most_branches were made without a complete path; take max_min_search, or memoised=True"
    NOT_CONNECTED = "failed: every start failed, no continuous path leads through the layers; raise epsilon"

    @property
    def ok(self) -> bool:
        """Whether the path is the optimum."""
        return self is GuilamoStatus.FOUND


@dataclass(frozen=True, kw_only=True, eq=False)
class GuilamoResult:
    """The path that the restart search found, with the paper's counts; where there is none, arrays are empty.

    Attributes:
        q: configurations (L, n) [rad or m]; joints that turn without end go on beyond ±π.
        indices: the chosen candidate of each layer (L,).
        manipulability: index at each position (L,).
        minimum: the least of them; -inf where there is no path.
        start: layer and candidate of the last start.
        new_starts: starts that were tried.
        branches: candidates that were put into a growing path.
        comparisons: pairs of configurations that were compared.
        status: how the search ended.
    """

    q: Array
    indices: NDArray[np.int64]
    manipulability: Array
    minimum: float
    start: tuple[int, int]
    new_starts: int
    branches: int
    comparisons: int
    status: GuilamoStatus


def guilamo_search(
    layers: Layers,
    epsilon: ArrayLike,
    *,
    memoised: bool = False,
    strict: bool = True,
    most_branches: int | None = None,
    throw: bool = True,
) -> GuilamoResult:
    """Search by restarts as guilamo2006 does, section IV: exact, but slow where the optimum is well below the bound.

    Args:
        layers: candidates with their index, not closed.
        epsilon: what each joint's step between neighbouring layers has to be below [rad or m]: one number, or (n,).
        memoised: within one start, pass over candidates that were in the path before: each start takes at most one visit
            to each candidate.
        strict: with False, a step of exactly epsilon is allowed, too.
        most_branches: give up after so many; None never does.
        throw: raise PlanningError, which holds the result, if there is no path.

    Raises InvalidInputError for bad arguments, closed layers among them.
    """
    from manipplan.search.kernels import EXHAUSTED, FOUND, STATE, UNFINISHED, search_restarts

    instance("layers", layers, Layers)
    if layers.closed:
        raise InvalidInputError("layers", "closed layers", "open ones: the paper's search knows no cycles; take max_min_search")
    steps = check_epsilon(epsilon, layers.continuous)
    for name, value in {"memoised": memoised, "strict": strict, "throw": throw}.items():
        if not isinstance(value, bool | np.bool_):
            raise InvalidInputError(name, value, "True or False")
    most = np.iinfo(np.int64).max if most_branches is None else whole_number("most_branches", most_branches, least=0)
    orders = [np.argsort(-m, kind="stable") for m in layers.m]
    q = np.concatenate([each[order] for each, order in zip(layers.q, orders, strict=True)])
    m = np.concatenate([each[order] for each, order in zip(layers.m, orders, strict=True)])
    offset = np.concatenate([[0], np.cumsum(layers.sizes)])
    layer_of = np.repeat(np.arange(len(orders)), layers.sizes)
    first = offset[int(np.argmin([value.max() for value in layers.m]))]
    lower = np.argsort(-m, kind="stable")
    # a path's minimum manipulability is at most that of the first start; others of the same index can still be the start of one
    starts = np.concatenate([[first], lower[(m[lower] <= m[first]) & (lower != first)]])
    state = np.zeros(STATE, dtype=np.int64)
    path, pointer = np.zeros(len(orders), dtype=np.int64), np.zeros(len(orders), dtype=np.int64)
    seen = np.zeros(len(m), dtype=np.int64)
    reach, turns = np.array(exclusive(steps, strict=bool(strict))), np.array(layers.continuous)
    code = UNFINISHED
    while code == UNFINISHED:
        code = search_restarts(
            q, m, offset, starts, layer_of, reach, turns, bool(memoised), most, BUDGET, state, path, pointer, seen
        )
    names = {FOUND: GuilamoStatus.FOUND, EXHAUSTED: GuilamoStatus.NOT_CONNECTED}
    status = names.get(code, GuilamoStatus.GAVE_UP)
    _, _, new_starts, branches, comparisons = (int(each) for each in state)
    last = int(starts[max(new_starts, 1) - 1])
    found = [order[place - low] for order, place, low in zip(orders, path, offset[:-1], strict=True)] if status.ok else []
    result = GuilamoResult(
        q=without_jumps(q[path], layers.continuous) if status.ok else np.empty((0, layers.n)),
        indices=np.array(found, dtype=np.int64),
        manipulability=m[path] if status.ok else np.empty(0),
        minimum=float(m[path].min()) if status.ok else -np.inf,
        start=(int(layer_of[last]), int(orders[layer_of[last]][last - offset[layer_of[last]]])),
        new_starts=new_starts,
        branches=branches,
        comparisons=comparisons,
        status=status,
    )
    if throw and not status.ok:
        raise PlanningError(f"{status.value} ({new_starts} starts, {branches} branches)", result)
    return result
