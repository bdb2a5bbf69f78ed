"""One search: grids, sweeps over open and closed layers, and a count of the work."""

import heapq
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import chain, count
from typing import Any

import numpy as np
from numpy.typing import NDArray

from manipplan.search.grid import SAMPLE, Grid, choose_grid
from manipplan.search.layers import Layers
from manipplan.search.steps import path_steps
from manipplan.search.sweep import Cells, Closest, Objective, Part, Stage, ThreadPool, Trace, Widest, sort_stage, sweep
from manipplan.support.checks import Array
from manipplan.support.progress import Progress

#: Relaxes the cycle for a set of begins: the key of the best path from the set back to the set (smaller is better), and
#: the first and last candidate of it; None when there is none.
Relax = Callable[[NDArray[np.int64]], tuple[Any, int, int, Any] | None]


def best_cycle(q: Array, begins: NDArray[np.int64], relax: Relax) -> Any | None:
    """The best cycle through one of `begins`, candidates of the layer q (k, n); None when there is none. Exact.

    A path that begins and ends somewhere in a set is at least as good as each cycle through a member of the set. So the best
    such path, if it ends where it begins, is the best cycle of the set; else the set is cut between its two ends. Sets are
    taken best first, and the first one whose path closes is the answer. Each set takes one sweep: for n begins at most
    2 n - 1, usually some tens when only the minimum manipulability counts, more for the shortest cycle, whose bound is weaker.
    """
    order = count()  # sets of equal keys: the latest first, which is the smallest
    waiting: list[tuple[Any, int, NDArray[np.int64], int, int, Any]] = []

    def enter(members: NDArray[np.int64]) -> None:
        found = relax(members) if len(members) else None
        if found is not None:
            key, first, last, path = found
            heapq.heappush(waiting, (key, -next(order), members, first, last, path))

    enter(begins)
    while waiting:
        _, _, members, first, last, path = heapq.heappop(waiting)
        if first == last:
            return path
        for part in _cut(q, members, first, last):
            enter(part)
    return None


def _cut(q: Array, members: NDArray[np.int64], first: int, last: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Two parts of the set, `first` in one and `last` in the other, as equal in size as may be."""
    apart = np.abs(q[last] - q[first])
    j = int(apart.argmax())
    if apart[j] == 0:  # the same configuration twice
        below = members <= min(first, last)
        return members[below], members[~below]
    low, high = sorted((float(q[first, j]), float(q[last, j])))
    values = q[members, j]
    edge = min(max(float(np.median(values)), low), np.nextafter(high, low))
    return members[values <= edge], members[values > edge]


#: Called at most so often [s].
RATE = 0.1
#: Sorted layers of a cycle are kept for the next sweep up to this size [bytes].
KEPT = 256e6
#: Cells for each candidate of a layer, and at least.
CELLS, FEWEST_CELLS = 2, 64
#: The least factor of ε is found exactly once it is known up to this ratio.
CLOSE = 1.25


@dataclass(frozen=True, kw_only=True, eq=False)
class CandidatePath:
    """The chosen candidate of each layer (L,), and the value of the objective."""

    indices: NDArray[np.int64]
    value: float


class Search:
    """Searches of one set of layers. Counts its sweeps in `rounds`, and in `nodes` the candidates of the last one."""

    def __init__(self, layers: Layers, pool: ThreadPool, tell: Progress, *, work: float) -> None:
        self.layers = layers
        self.pool = pool
        self.rounds = 0
        self.nodes = 0
        self.tell = tell
        self._work = work  # candidates that are passed in the worst case
        self._passed = 0
        self._told = -np.inf

    def best(self, objective: Objective, part: Part, reach: Array, text: str) -> CandidatePath | None:
        """The path that the objective values most, of the candidates that take part, with steps below `reach` (n,)."""
        active = [int(np.count_nonzero(m >= part.threshold)) for m in self.layers.m]
        if min(active) == 0:
            return None
        grid = self._grid(reach, part.share * sum(active))
        if self.layers.closed:
            return self._cycle(objective, part, grid, text, active)
        stages = [Stage(q, m) for q, m in zip(self.layers.q, self.layers.m, strict=True)]
        trace = self._sweep(self._sorted(stages, part, grid), grid, objective, text)
        return CandidatePath(indices=trace.indices, value=trace.value) if len(trace.indices) else None

    def reached(self, reach: Array) -> int:
        """The first position that no path from position 0 reaches; L when all are."""
        stages = [Stage(q, np.zeros(len(q))) for q in self.layers.q]
        grid = self._grid(reach, self.layers.count)
        return self._sweep(self._sorted(stages, Part(), grid), grid, Widest(), "gaps").depth

    def minimum_manipulability(self, path: CandidatePath) -> float:
        """The minimum manipulability along the path."""
        return float(min(m[i] for m, i in zip(self.layers.m, path.indices, strict=True)))

    def least_epsilon(self, epsilon: Array) -> Array:
        """The least multiple of `epsilon` (n,) that connects the layers, which epsilon itself does not. Exact."""
        low, high = 1.0, np.inf
        alike = Part(cap=min(float(m.min()) for m in self.layers.m))  # any path will do
        while high > CLOSE * low:
            factor = 4 * low if np.isinf(high) else np.sqrt(low * high)
            path = self.best(Widest(), alike, factor * epsilon * (1 + 1e-12), "least epsilon")
            if path is None:
                low = factor
            else:
                high = float((np.abs(self.steps(path)) / epsilon).max())
                low = min(low, high)
        path = self.best(Closest(epsilon=epsilon), Part(), high * epsilon * (1 + 1e-12), "least epsilon")
        assert path is not None
        # a step is a number; the product that stands for it may be rounded below it
        least: Array = np.maximum(-path.value * epsilon, np.abs(self.steps(path)).max(axis=0))
        return least

    def steps(self, path: CandidatePath) -> Array:
        """Steps along the path: (L - 1, n), of a cycle (L, n)."""
        return path_steps(self.configurations(path), self.layers.continuous, closed=self.layers.closed)

    def configurations(self, path: CandidatePath) -> Array:
        """Configurations of the path (L, n), as the layers hold them."""
        return np.array([q[i] for q, i in zip(self.layers.q, path.indices, strict=True)])

    def _grid(self, reach: Array, active: float) -> Grid:
        q = self.layers.q[int(self.layers.sizes.argmax())]
        most = int(max(FEWEST_CELLS, CELLS * active / len(self.layers.q)))
        return choose_grid(q[:: max(1, len(q) // SAMPLE)], self.layers.extent, reach, self.layers.continuous, most)

    def _sorted(self, stages: list[Stage], part: Part, grid: Grid) -> Iterator[Cells]:
        return self.pool.ahead(lambda stage: sort_stage(stage, part, grid), stages)

    def _sweep(self, cells: Iterator[Cells], grid: Grid, objective: Objective, text: str) -> Trace:
        before = self._passed

        def tick(nodes: int) -> None:
            self._passed = before + nodes
            now = time.monotonic()
            if now - self._told > RATE:
                self._told = now
                self.tell(min(0.99, self._passed / self._work), text)

        trace = sweep(cells, grid, objective, self.pool, tick)
        self.rounds += 1
        self.nodes = trace.nodes
        return trace

    def _cycle(self, objective: Objective, part: Part, grid: Grid, text: str, active: list[int]) -> CandidatePath | None:
        layers, count = self.layers, len(self.layers.q)
        begin = int(np.argmin(active))  # the fewest begins
        turned = [(begin + i) % count for i in range(count)]
        inner = [Stage(layers.q[i], layers.m[i]) for i in turned[1:]]
        begins = np.sort(sort_stage(Stage(layers.q[begin], layers.m[begin]), part, grid).ids).astype(np.int64)
        kept: list[Cells] | None = None
        if part.share * sum(active) * 8 * (layers.n + 2) < KEPT:
            kept = list(self._sorted(inner, part, grid))

        whole = Part(threshold=part.threshold, cap=part.cap)

        def relax(members: NDArray[np.int64]) -> tuple[tuple[bytes, float], int, int, CandidatePath] | None:
            q = np.ascontiguousarray(layers.q[begin][members])
            first = sort_stage(Stage(q, layers.m[begin][members]), whole, grid)
            # it is there twice, and must count once
            last = sort_stage(Stage(q, np.full(len(members), np.inf)), Part(), grid)
            between = kept if kept is not None else self._sorted(inner, part, grid)
            trace = self._sweep(chain([first], between, [last]), grid, objective, text)
            if len(trace.indices) == 0:
                return None
            ends = members[trace.indices[[0, -1]]]
            indices = np.empty(count, dtype=np.int64)
            indices[turned] = [ends[0], *trace.indices[1:-1]]
            word = b"" if trace.vector is None else (~trace.vector).astype(">u8").tobytes()
            return (word, -trace.value), int(ends[0]), int(ends[1]), CandidatePath(indices=indices, value=trace.value)

        return best_cycle(layers.q[begin], begins, relax)
