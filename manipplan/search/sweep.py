"""Sweeps of the dynamic program over the layers, and their objectives."""

from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from manipplan.search.grid import Grid
from manipplan.support.checks import Array

#: Minimum number of candidates of a layer that threads share.
SHARED = 8192
#: Minimum number of candidates that take part per stage.
LEAST = 512
#: Number of pieces of a layer per thread: pieces take unequal time.
PIECES = 4


class SweepStage(NamedTuple):
    """Candidates of one step of a sweep: q (k, n) [rad or m] and m (k,), contiguous."""

    q: Array
    m: Array


class Cells(NamedTuple):
    """Candidates of a stage sorted by cell: indices, configurations, manipulability, start of each cell."""

    ids: NDArray[np.int32]
    rows: Array
    m: Array
    start: NDArray[np.int32]


class Reached(NamedTuple):
    """State of a sweep at a stage: values (k,), largest value per cell, and ranks (k,) with the vectors they rank, or None.

    A value is -inf where no path leads. Larger is better; ranks, where there are any, are compared before values.
    """

    value: Array
    top: Array
    rank: NDArray[np.int64] | None = None
    vectors: NDArray[np.uint64] | None = None


#: Processes cells [first, last) of a stage.
Piece = Callable[[int, int], None]


#: Runs a piece on all cells of a stage, split among threads.
Share = Callable[[Piece, Cells], None]


class SweepObjective(Protocol):
    """SweepObjective that a sweep maximises: values of the first stage, and the step from one stage to the next."""

    def first(self, cells: Cells) -> Reached:
        """Values of the first stage."""

    def step(
        self, old: Cells, reached: Reached, cells: Cells, grid: Grid, share: Callable[[Piece, Cells], None]
    ) -> tuple[Reached, NDArray[np.int32]]:
        """Values of the next stage, and the index (k,) of each predecessor in the old stage, -1 for none."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Trace:
    """A finished sweep.

    Attributes:
        indices: candidate of each stage on the best path, (stages,); empty when the last stage is not reached.
        value: value of the best path; -inf when there is none.
        vector: the vector that ranks the best path, (stages,) ascending codes, or None.
        depth: number of stages that were reached.
        nodes: number of candidates that took part.
    """

    indices: NDArray[np.int64]
    value: float
    vector: NDArray[np.uint64] | None
    depth: int
    nodes: int


class ThreadPool:
    """Threads that share the work; with one thread, the caller does it."""

    def __init__(self, threads: int) -> None:
        self.threads = threads
        self._pool = ThreadPoolExecutor(threads) if threads > 1 else None

    def __enter__(self) -> "ThreadPool":
        return self

    def __exit__(self, *error: object) -> None:
        if self._pool is not None:
            self._pool.shutdown(cancel_futures=True)

    def share(self, piece: Piece, cells: Cells) -> None:
        """Run `piece` over all cells of a stage."""
        last = len(cells.start) - 1
        if self._pool is None or len(cells.ids) < SHARED:
            piece(0, last)
            return
        edges = np.searchsorted(cells.start, np.linspace(0, len(cells.ids), PIECES * self.threads + 1)[1:-1])
        edges = np.concatenate([[0], edges, [last]])
        for done in [self._pool.submit(piece, int(a), int(b)) for a, b in pairwise(edges) if b > a]:
            done.result()

    def ahead(self, work: Callable[[Any], Cells], items: Sequence[Any]) -> Iterator[Cells]:
        """Results of `work` in order, computed a few items ahead."""
        if self._pool is None:
            yield from map(work, items)
            return
        waiting: deque[Future[Cells]] = deque()
        following = iter(items)
        try:
            for _ in range(self.threads):
                waiting.extend(self._pool.submit(work, item) for item in _next(following))
            while waiting:
                cells = waiting.popleft().result()
                waiting.extend(self._pool.submit(work, item) for item in _next(following))
                yield cells
        finally:
            for future in waiting:
                future.cancel()


@dataclass(frozen=True, kw_only=True)
class Subset:
    """The candidates that take part in a sweep: those with m >= threshold, or a `share` of them; m is limited to `cap`.

    At least LEAST candidates of each stage take part, whatever the share is.
    """

    threshold: float = -np.inf
    share: float = 1.0
    cap: float = np.inf


def sort_stage(stage: SweepStage, part: Subset, grid: Grid) -> Cells:
    """The candidates of a stage that take part, sorted by cell."""
    from manipplan.search.kernels import sorted_into_cells

    share = min(1.0, max(part.share, LEAST / len(stage.m)))
    return sorted_into_cells(stage.q, stage.m, part.threshold, share, part.cap, grid)


def sweep(
    stages: Iterable[Cells],
    grid: Grid,
    objective: SweepObjective,
    pool: ThreadPool,
    tick: Callable[[int], None],
) -> Trace:
    """One pass from the first stage to the last; after each, tick is called with the number of its candidates."""
    ids: list[NDArray[np.int32]] = []
    sources: list[NDArray[np.int32]] = []
    old: Cells | None = None
    reached = Reached(np.empty(0), np.empty(0))
    nodes = 0
    for cells in stages:
        nodes += len(cells.ids)
        if old is None:
            reached, source = objective.first(cells), np.full(len(cells.ids), -1, dtype=np.int32)
        else:
            reached, source = objective.step(old, reached, cells, grid, pool.share)
        if not (reached.top > -np.inf).any():
            return Trace(indices=np.empty(0, np.int64), value=-np.inf, vector=None, depth=len(ids), nodes=nodes)
        ids.append(cells.ids)
        sources.append(source)
        old = cells
        tick(len(cells.ids))
    end = _last(reached)
    vector = None if reached.vectors is None else reached.vectors[end]
    indices = np.empty(len(ids), dtype=np.int64)
    place = end
    for i in range(len(ids) - 1, -1, -1):
        indices[i] = ids[i][place]
        place = int(sources[i][place])
    return Trace(indices=indices, value=float(reached.value[end]), vector=vector, depth=len(ids), nodes=nodes)


def _next(items: Iterator[Any]) -> list[Any]:
    for item in items:
        return [item]
    return []


def _last(reached: Reached) -> int:
    if reached.rank is None:
        return int(reached.value.argmax())
    found = np.where(reached.value > -np.inf, reached.rank, -1)
    highest = np.flatnonzero(found == found.max())
    return int(highest[reached.value[highest].argmax()])


@dataclass(frozen=True, kw_only=True)
class Widest:
    """The minimum manipulability of a path: W(b) = min(m(b), max over neighbours of W)."""

    def first(self, cells: Cells) -> Reached:
        return _reached(cells, cells.m)

    def step(self, old: Cells, reached: Reached, cells: Cells, grid: Grid, share: Share) -> tuple[Reached, NDArray[np.int32]]:
        from manipplan.search.kernels import StepKernel

        made = StepKernel("widest", old, reached.value, reached.top, cells, grid)
        share(made, cells)
        return Reached(made.value, made.top), made.source


@dataclass(frozen=True, kw_only=True)
class Shortest:
    """The negative length Σ ‖Δq‖ of a path."""

    def first(self, cells: Cells) -> Reached:
        return _reached(cells, np.zeros(len(cells.ids)))

    def step(self, old: Cells, reached: Reached, cells: Cells, grid: Grid, share: Share) -> tuple[Reached, NDArray[np.int32]]:
        from manipplan.search.kernels import StepKernel

        made = StepKernel("shortest", old, reached.value, reached.top, cells, grid)
        share(made, cells)
        return Reached(made.value, made.top), made.source


@dataclass(frozen=True, kw_only=True)
class Lexicographic:
    """The manipulability values of a path in ascending order, compared lexicographically; on ties the shorter path.

    Adding one value to two such vectors does not change their order, so the best path to a candidate extends the best path
    to one of its neighbours. Vectors are stored as integers in the order of the values.
    """

    def first(self, cells: Cells) -> Reached:
        codes = _codes(cells.m)[:, np.newaxis]
        value = np.zeros(len(cells.ids))
        return _reached(cells, value)._replace(rank=_ranks(codes, value), vectors=codes)

    def step(self, old: Cells, reached: Reached, cells: Cells, grid: Grid, share: Share) -> tuple[Reached, NDArray[np.int32]]:
        from manipplan.search.kernels import StepKernel

        assert reached.rank is not None and reached.vectors is not None
        made = StepKernel("shortest", old, reached.value, reached.top, cells, grid, rank=reached.rank)
        share(made, cells)
        before = reached.vectors[np.maximum(made.source, 0)]
        vectors = np.sort(np.column_stack([before, _codes(cells.m)]), axis=1)
        return Reached(made.value, made.top, _ranks(vectors, made.value), vectors), made.source


@dataclass(frozen=True, kw_only=True, eq=False)
class Closest:
    """The negative factor by which `epsilon` (n,) has to be multiplied so that a path is continuous."""

    epsilon: Array

    def first(self, cells: Cells) -> Reached:
        return _reached(cells, np.zeros(len(cells.ids)))

    def step(self, old: Cells, reached: Reached, cells: Cells, grid: Grid, share: Share) -> tuple[Reached, NDArray[np.int32]]:
        from manipplan.search.kernels import StepKernel

        epsilon = np.ascontiguousarray(self.epsilon[grid.order])
        made = StepKernel("closest", old, reached.value, reached.top, cells, grid, epsilon=epsilon)
        share(made, cells)
        return Reached(made.value, made.top), made.source


@dataclass(frozen=True, kw_only=True)
class Longest:
    """The number of steps of the longest path to a candidate, which may begin at any stage."""

    def first(self, cells: Cells) -> Reached:
        return _reached(cells, np.zeros(len(cells.ids)))

    def step(self, old: Cells, reached: Reached, cells: Cells, grid: Grid, share: Share) -> tuple[Reached, NDArray[np.int32]]:
        from manipplan.search.kernels import StepKernel

        alike = cells._replace(m=np.full(len(cells.ids), reached.top.max()))  # the manipulability does not limit a length
        made = StepKernel("widest", old, reached.value, reached.top, alike, grid)
        share(made, alike)
        return _reached(cells, np.maximum(made.value + 1.0, 0.0)), made.source


def _reached(cells: Cells, value: Array) -> Reached:
    from manipplan.search.kernels import largest_of_each

    return Reached(value, largest_of_each(cells.start, value))


def _codes(m: Array) -> NDArray[np.uint64]:
    """Integers (k,) in the order of the values m; equal values, also 0 and -0, get equal integers."""
    bits = (m + 0.0).view(np.uint64)
    sign = np.uint64(1 << 63)
    return np.where(bits & sign, ~bits, bits | sign)


def _ranks(vectors: NDArray[np.uint64], value: Array) -> NDArray[np.int64]:
    """Ranks (k,) of vectors (k, i), equal for equal vectors; -1 for candidates that are not reached."""
    rank = np.full(len(value), -1, dtype=np.int64)
    found = np.flatnonzero(value > -np.inf)
    # big-endian bytes compare as the integers do, and one byte-wise sort is far faster than i sorts of columns
    words = np.ascontiguousarray(vectors[found].astype(">u8")).view(f"S{8 * vectors.shape[1]}")[:, 0]
    rank[found] = np.unique(words, return_inverse=True)[1]
    return rank
