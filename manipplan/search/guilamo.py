"""The search of guilamo2006, section IV: paths extended by backtracking from one start after the other.

The first start is the best candidate of the layer whose best is the smallest: no path can have a larger minimum. From it a path
is extended to the last layer, then from it to the first, each time to the continuous candidate with the largest manipulability
that is not below that of the start; where there is none, the search backtracks. If a start fails, the candidate with the next
lower manipulability of any layer is the next start. The first complete path is optimal, as each start is searched in full.

The paper does not say how the two halves share backtracking: here they share only the start, which is enough, as the two halves
are independent. Without memoisation the time of the search grows exponentially with the number of layers; `memoised` remembers,
for one start, the candidates that were dead ends.
"""

import ctypes
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from manipplan.search.layers import Layers
from manipplan.search.sweep import check_epsilon, exclusive, without_jumps
from manipplan.support.checks import Array, ArrayLike, instance, whole_number
from manipplan.support.compiling.declarations import struct
from manipplan.support.compiling.kernels import load_kernel
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.support.status import Status

#: Number of comparisons between two points at which the search can be interrupted.
BUDGET = 20_000_000


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class GuilamoResult:
    """The path that the restart search found, with the paper's counts; where there is none, arrays are empty.

    Attributes:
        q: configurations (L, n) [rad or m]; continuous joints are unwrapped beyond ±π.
        indices: the chosen candidate of each layer (L,).
        manipulability: manipulability at each position (L,).
        minimum: the smallest of these values; -inf where there is no path.
        start: layer and candidate of the last start.
        new_starts: number of starts tried.
        branches: number of candidates appended to a partial path.
        comparisons: number of pairs of configurations compared.
        status: return status.
    """

    q: Array
    indices: NDArray[np.int64]
    manipulability: Array
    minimum: float
    start: tuple[int, int]
    new_starts: int
    branches: int
    comparisons: int
    status: Status


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
        layers: candidates with their manipulability, not closed.
        epsilon: bound below which each joint's step between neighbouring layers has to be [rad or m]: one number, or (n,).
        memoised: within one start, skip candidates that were in the path before: each start visits each candidate at most
            once.
        strict: with False, a step of exactly epsilon is allowed as well.
        most_branches: maximum number of branches before the search gives up; None: no limit.
        throw: raise PlanningError, which holds the result, if there is no path.

    Raises InvalidInputError for bad arguments, including closed layers.
    """
    instance("layers", layers, Layers)
    if layers.closed:
        raise InvalidInputError("layers", "closed layers", "open layers; for cycles use max_min_search")
    steps = check_epsilon(epsilon, layers.continuous)
    for name, value in {"memoised": memoised, "strict": strict, "throw": throw}.items():
        if not isinstance(value, bool | np.bool_):
            raise InvalidInputError(name, value, "True or False")
    most = int(np.iinfo(np.int64).max) if most_branches is None else whole_number("most_branches", most_branches, least=0)
    orders = [np.argsort(-m, kind="stable") for m in layers.m]
    q = np.concatenate([each[order] for each, order in zip(layers.q, orders, strict=True)])
    m = np.concatenate([each[order] for each, order in zip(layers.m, orders, strict=True)])
    offset = np.concatenate([[0], np.cumsum(layers.sizes)])
    layer_of = np.repeat(np.arange(len(orders)), layers.sizes)
    first = offset[int(np.argmin([value.max() for value in layers.m]))]
    lower = np.argsort(-m, kind="stable")
    # a path's minimum manipulability is at most that of the first start; others of equal manipulability can be its start, too
    starts = np.concatenate([[first], lower[(m[lower] <= m[first]) & (lower != first)]])
    search = Restarts(
        q,
        m,
        offset=offset,
        starts=starts,
        layer_of=layer_of,
        reach=exclusive(steps, strict=bool(strict)),
        turns=layers.continuous,
        memoised=bool(memoised),
        most_branches=most,
    )
    code = UNFINISHED
    while code == UNFINISHED:
        code = search(BUDGET)
    names = {FOUND: Status.PROVEN_OPTIMAL, EXHAUSTED: Status.NOT_CONNECTED}
    status = names.get(code, Status.GAVE_UP)
    path, (new_starts, branches, comparisons) = search.path, search.counts
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


#: Return status of a call of `Restarts`; as in restarts.c.
UNFINISHED, FOUND, EXHAUSTED, TOO_MANY = 0, 1, 2, 3


@cache
def _call() -> Callable[..., int]:
    return load_kernel("restarts").functions()["restarts"]


class Restarts:
    """A search by restarts in progress.

    Args:
        q, m: (N, n), (N,) candidates of all layers, each layer in descending order of manipulability.
        offset: (L + 1,) start of each layer.
        starts: candidates in the order in which they start a path.
        layer_of: (N,) their layers.
        reach: (n,) upper bound on a step, exclusive.
        turns: (n,) whether each joint is continuous.
        memoised: whether a candidate that was in the path before is skipped, within one start.
        most_branches: maximum number of branches.

    Attributes:
        path: (L,) the candidate of each layer once a path is found.
    """

    def __init__(
        self,
        q: Array,
        m: Array,
        *,
        offset: NDArray[np.int64],
        starts: NDArray[np.int64],
        layer_of: NDArray[np.int64],
        reach: Array,
        turns: NDArray[np.bool_],
        memoised: bool,
        most_branches: int,
    ) -> None:
        layers = len(offset) - 1
        arrays = {"q": q, "m": m, "offset": offset, "starts": starts, "layer_of": layer_of, "reach": reach, "turns": turns}
        self._arrays = {name: np.ascontiguousarray(array) for name, array in arrays.items()}
        self._problem = struct("restarts", "Problem")(
            n=q.shape[1],
            layers=layers,
            count=len(m),
            starting=len(starts),
            memoised=memoised,
            most_branches=most_branches,
            **{name: array.ctypes.data for name, array in self._arrays.items()},
        )
        self.path, self._pointer = np.zeros(layers, dtype=np.int64), np.zeros(layers, dtype=np.int64)
        self._seen = np.zeros(len(m), dtype=np.int64)
        places = {"path": self.path.ctypes.data, "pointer": self._pointer.ctypes.data, "seen": self._seen.ctypes.data}
        self._state = struct("restarts", "State")(**places)

    def __call__(self, budget: int) -> int:
        """Continue for about `budget` comparisons of configurations; returns UNFINISHED, FOUND, EXHAUSTED or TOO_MANY."""
        return _call()(ctypes.addressof(self._problem), budget, ctypes.addressof(self._state))

    @property
    def counts(self) -> tuple[int, int, int]:
        """Numbers of starts, branches and comparisons so far."""
        return self._state.starts, self._state.branches, self._state.comparisons
