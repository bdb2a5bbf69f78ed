"""One search: grids, sweeps over open and closed layers, and a work counter."""

import heapq
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import chain, count, pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from manipplan.search.layers import Layers, step_limits
from manipplan.search.sweep import (
    SAMPLE,
    Cells,
    Closest,
    Grid,
    Longest,
    Reached,
    Subset,
    SweepObjective,
    SweepStage,
    ThreadPool,
    Trace,
    Widest,
    choose_grid,
    path_steps,
    sort_stage,
    sweep,
)
from manipplan.support.checks import Array
from manipplan.support.progress import Progress

#: Relaxation of the cycle for a set of first candidates: the key of the best path from the set back to the set (smaller is
#: better), its first and last candidate, and the path; None when there is none.
Relax = Callable[[NDArray[np.int64]], tuple[Any, int, int, Any] | None]


def best_cycle(q: Array, begins: NDArray[np.int64], relax: Relax) -> Any | None:
    """The best cycle through one of `begins`, candidates of the layer q (k, n); None when there is none. Exact.

    The best path that begins and ends anywhere in a set is at least as good as each cycle through a member of the set. If it
    ends where it begins, it is the best cycle of the set; else the set is split between its two ends. Sets are taken best
    first, and the first one whose path closes is the optimum. Each set takes one sweep: for n begins at most 2 n - 1 sweeps,
    typically a few tens for the minimum manipulability alone, more for the shortest cycle, whose bound is weaker.
    """
    order = count()  # among sets of equal keys the latest comes first, which is the smallest
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
        for part in _split(q, members, first, last):
            enter(part)
    return None


def _split(q: Array, members: NDArray[np.int64], first: int, last: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Two parts of the set, as equal in size as possible, with `first` in one and `last` in the other."""
    apart = np.abs(q[last] - q[first])
    j = int(apart.argmax())
    if apart[j] == 0:  # two candidates with the same configuration
        below = members <= min(first, last)
        return members[below], members[~below]
    low, high = sorted((float(q[first, j]), float(q[last, j])))
    values = q[members, j]
    edge = min(max(float(np.median(values)), low), np.nextafter(high, low))
    return members[values <= edge], members[values > edge]


#: Minimum time between progress calls [s].
RATE = 0.05
#: Maximum memory of the sorted layers of a cycle that are kept for the next sweep [bytes].
CACHE_BYTES = 256e6
#: Number of cells per candidate of a layer, and minimum number of cells.
CELLS, FEWEST_CELLS = 2, 64
#: Ratio of the bounds on the smallest factor of ε at which the bisection stops and the exact search starts.
CLOSE = 1.25


@dataclass(frozen=True, kw_only=True, eq=False)
class CandidatePath:
    """The chosen candidate of each layer (L,), and the value of the objective."""

    indices: NDArray[np.int64]
    value: float


class ThresholdSearch:
    """Searches of one set of layers. `rounds` counts its sweeps, `nodes` the candidates of the last sweep."""

    def __init__(self, layers: Layers, pool: ThreadPool, notify: Progress, *, work: float) -> None:
        self.layers = layers
        self.pool = pool
        self.rounds = 0
        self.nodes = 0
        self.notify = notify
        self._work = work  # number of candidates visited in the worst case
        self._passed = 0
        self._told = -np.inf

    def best(self, objective: SweepObjective, part: Subset, reach: Array, text: str) -> CandidatePath | None:
        """The best path for the objective through the candidates that take part; steps are below `reach` (n,) and the pace."""
        active = [int(np.count_nonzero(m >= part.threshold)) for m in self.layers.m]
        if min(active) == 0:
            return None
        grid = self._grid(reach, part.share * sum(active))
        if self.layers.closed:
            return self._cycle(objective, part, grid, reach, text, active)
        trace = self._sweep(self._sort(self._stages(reach), part, grid), grid, objective, text)
        return CandidatePath(indices=trace.indices, value=trace.value) if len(trace.indices) else None

    def reached(self, reach: Array) -> int:
        """The first position that no path from position 0 reaches; L when all are reached."""
        stages = [each._replace(m=np.zeros(len(each.m))) for each in self._stages(reach)]
        grid = self._grid(reach, self.layers.count)
        return self._sweep(self._sort(stages, Subset(), grid), grid, Widest(), "gaps of the path").depth

    def first_positions(self, part: Subset, reach: Array, text: str) -> NDArray[np.int64]:
        """For each position (L,), the first one from which a path leads to it; for a cycle (2 L,), twice around it.

        No layer may be empty of candidates that take part.
        """
        layers = self.layers
        stages = self._stages(reach) * (2 if layers.closed else 1)
        grid = self._grid(reach, sum(int(np.count_nonzero(m >= part.threshold)) for m in layers.m))
        lengths = np.zeros(len(stages), dtype=np.int64)  # number of steps of the longest path to each position
        old: Cells | None = None
        reached = Reached(np.empty(0), np.empty(0))
        for k, cells in enumerate(self._sort(stages, part, grid)):
            reached = Longest().first(cells) if old is None else Longest().step(old, reached, cells, grid, self.pool.share)[0]
            lengths[k] = reached.value.max()
            old = cells
            self._tick(len(cells.ids), text)
        self.rounds += 1
        return np.arange(len(stages)) - lengths

    def minimum_between(self, edges: Sequence[int], least: float, reach: Array) -> float:
        """The largest minimum manipulability of paths from each of `edges`, positions, to the next; -inf if below `least`.

        Positions of a cycle count on beyond its last.
        """
        part = Subset(threshold=least)
        stages = self._stages(reach) * (2 if self.layers.closed else 1)
        grid = self._grid(reach, sum(int(np.count_nonzero(m >= least)) for m in self.layers.m))
        best = np.inf
        for first, last in pairwise(edges):
            some = self._sort(stages[first : last + 1], part, grid)
            best = min(best, self._sweep(some, grid, Widest(), "parts").value)
        return best

    def last_values(self, part: Subset, reach: Array) -> Array:
        """The largest minimum manipulability of a path to each candidate of the last layer (k,); -inf where none leads."""
        if len(self.layers.q) == 1:
            return self.layers.m[0]
        stages = self._stages(reach)
        grid = self._grid(reach, self.layers.count)
        values, objective = np.full(len(stages[-1].m), -np.inf), Widest()
        old: Cells | None = None
        reached = Reached(np.empty(0), np.empty(0))
        for cells in self._sort(stages, part, grid):
            reached = objective.first(cells) if old is None else objective.step(old, reached, cells, grid, self.pool.share)[0]
            if not (reached.top > -np.inf).any():
                return values
            old = cells
            self._tick(len(cells.ids), "values")
        assert old is not None
        values[old.ids] = reached.value
        return values

    def minimum_manipulability(self, path: CandidatePath) -> float:
        """The minimum manipulability along the path."""
        return float(min(m[i] for m, i in zip(self.layers.m, path.indices, strict=True)))

    def least_epsilon(self, epsilon: Array) -> Array:
        """The smallest multiple of `epsilon` (n,) that connects the layers, where epsilon itself does not. Exact."""
        low, high = 1.0, np.inf
        alike = Subset(cap=min(float(m.min()) for m in self.layers.m))  # any path is enough
        while high > CLOSE * low:
            factor = 4 * low if np.isinf(high) else np.sqrt(low * high)
            path = self.best(Widest(), alike, factor * epsilon * (1 + 1e-12), "smallest epsilon")
            if path is None:
                low = factor
            else:
                high = float((np.abs(self.steps(path)) / epsilon).max())
                low = min(low, high)
        path = self.best(Closest(epsilon=epsilon), Subset(), high * epsilon * (1 + 1e-12), "smallest epsilon")
        assert path is not None
        # the product of factor and epsilon may be rounded below the actual step
        least: Array = np.maximum(-path.value * epsilon, np.abs(self.steps(path)).max(axis=0))
        return least

    def steps(self, path: CandidatePath) -> Array:
        """Steps along the path: (L - 1, n), or (L, n) for a cycle."""
        return path_steps(self.configurations(path), self.layers.continuous, closed=self.layers.closed)

    def configurations(self, path: CandidatePath) -> Array:
        """Configurations of the path (L, n), as stored in the layers."""
        return np.array([q[i] for q, i in zip(self.layers.q, path.indices, strict=True)])

    def _stages(self, reach: Array) -> list[SweepStage]:
        """The layers, each with the bound on the step to it from the one before."""
        limits, layers = step_limits(self.layers, reach), self.layers
        return [SweepStage(q, m, limits[k - 1]) for k, (q, m) in enumerate(zip(layers.q, layers.m, strict=True))]

    def _grid(self, reach: Array, active: float) -> Grid:
        q = self.layers.q[int(self.layers.sizes.argmax())]
        most = int(max(FEWEST_CELLS, CELLS * active / len(self.layers.q)))
        widest = step_limits(self.layers, reach).max(axis=0)
        return choose_grid(q[:: max(1, len(q) // SAMPLE)], self.layers.extent, widest, self.layers.continuous, most)

    def _sort(self, stages: list[SweepStage], part: Subset, grid: Grid) -> Iterator[Cells]:
        return self.pool.ahead(lambda stage: sort_stage(stage, part, grid), stages)

    def _sweep(self, cells: Iterator[Cells], grid: Grid, objective: SweepObjective, text: str) -> Trace:
        trace = sweep(cells, grid, objective, self.pool, lambda nodes: self._tick(nodes, text))
        self.rounds += 1
        self.nodes = trace.nodes
        return trace

    def _tick(self, nodes: int, text: str) -> None:
        """Count the candidates of a stage."""
        self._passed += nodes
        now = time.monotonic()
        if now - self._told > RATE:
            self._told = now
            self.notify(min(0.99, self._passed / self._work), text)

    def _cycle(
        self, objective: SweepObjective, part: Subset, grid: Grid, reach: Array, text: str, active: list[int]
    ) -> CandidatePath | None:
        layers, count, stages = self.layers, len(self.layers.q), self._stages(reach)
        begin = int(np.argmin(active))  # the layer with the fewest first candidates
        turned = [(begin + i) % count for i in range(count)]
        inner = [stages[i] for i in turned[1:]]
        begins = np.sort(sort_stage(stages[begin], part, grid).ids).astype(np.int64)
        sorted_cells: list[Cells] | None = None
        if part.share * sum(active) * 8 * (layers.n + 2) < CACHE_BYTES:
            sorted_cells = list(self._sort(inner, part, grid))

        whole = Subset(threshold=part.threshold, cap=part.cap)

        def relax(members: NDArray[np.int64]) -> tuple[tuple[bytes, float], int, int, CandidatePath] | None:
            q = np.ascontiguousarray(layers.q[begin][members])
            own = SweepStage(q, layers.m[begin][members], stages[begin].reach)
            first = sort_stage(own, whole, grid)
            # the layer is passed twice and must count once
            last = sort_stage(own._replace(m=np.full(len(members), np.inf)), Subset(), grid)
            between = sorted_cells if sorted_cells is not None else self._sort(inner, part, grid)
            trace = self._sweep(chain([first], between, [last]), grid, objective, text)
            if len(trace.indices) == 0:
                return None
            ends = members[trace.indices[[0, -1]]]
            indices = np.empty(count, dtype=np.int64)
            indices[turned] = [ends[0], *trace.indices[1:-1]]
            word = b"" if trace.vector is None else (~trace.vector).astype(">u8").tobytes()
            return (word, -trace.value), int(ends[0]), int(ends[1]), CandidatePath(indices=indices, value=trace.value)

        return best_cycle(layers.q[begin], begins, relax)
