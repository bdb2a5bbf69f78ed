"""Sweeps of the dynamic program over the layers, and their objectives.

The compiled steps of the dynamic program: `sweep.c`.

Steps between neighbouring positions: their bound ε, their size, and configurations without jumps of 2π.

Grid: cells over up to three joints, wide enough that neighbours within ε lie in the same or in adjacent cells.
"""

import ctypes
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from manipplan.support.checks import LARGEST, Array, ArrayLike, number_array
from manipplan.support.errors import InvalidInputError
from manipplan.support.kernels import load_kernel, struct

#: The compiled steps.


@cache
def calls() -> Mapping[str, Callable[..., Any]]:
    """The functions of sweep.c, by their names without prefix; raises CompilerError where it cannot be compiled."""
    return load_kernel("sweep").functions()


def _grid(grid: "Grid") -> ctypes.Structure:
    """It points to the arrays of the grid, which has to outlive it."""
    names = ("joints", "low", "per", "count", "wraps", "order", "turns")
    return struct("sweep", "Grid")(n=len(grid.order), **{name: getattr(grid, name).ctypes.data for name in names})


def _cells(cells: "Cells") -> ctypes.Structure:
    return struct("sweep", "Cells")(**{name: array.ctypes.data for name, array in cells._asdict().items()})


def _values(value: Array, top: Array) -> ctypes.Structure:
    return struct("sweep", "Values")(value=value.ctypes.data, top=top.ctypes.data)


def sorted_into_cells(q: Array, m: Array, reach: Array, threshold: float, share: float, cap: float, grid: "Grid") -> "Cells":
    """The candidates q (k, n) with m (k,) >= threshold, sorted by cell, with m limited to `cap`; reach (n,) as in `SweepStage`.

    With a share below 1 about that share of them; the choice is pseudo-random but reproducible, and a smaller share is a subset
    of a larger one.
    """
    q, m = np.ascontiguousarray(q), np.ascontiguousarray(m)
    taken = np.empty(len(m) + 1, dtype=np.int32)
    k = calls()["taking_part"](m.ctypes.data, len(m), threshold, share, taken.ctypes.data)
    cells = Cells(
        np.empty(k, dtype=np.int32),
        np.empty((k, q.shape[1])),
        np.empty(k),
        np.empty(grid.cells + 1, dtype=np.int32),
        np.ascontiguousarray(reach[grid.order]),
    )
    cell, arrays, numbers = np.empty(k, dtype=np.int32), _cells(cells), _grid(grid)
    calls()["sort_into_cells"](
        ctypes.addressof(numbers),
        q.ctypes.data,
        m.ctypes.data,
        taken.ctypes.data,
        k,
        cap,
        cell.ctypes.data,
        ctypes.addressof(arrays),
    )
    return cells


def largest_of_each(start: NDArray[np.int32], value: Array) -> Array:
    """The largest value of each cell (cells,), -inf for an empty one; start (cells + 1,) of each cell."""
    top = np.empty(len(start) - 1)
    calls()["largest_of_each"](start.ctypes.data, len(top), value.ctypes.data, top.ctypes.data)
    return top


class StepKernel:
    """One step of a sweep, from candidates `old` with their values (k,) and tops per cell to `cells`; threads share it.

    Args:
        name: "widest", "shortest" or "closest".
        old, value, top: the previous stage, with the value of each candidate and the largest one of each cell.
        cells: the next stage.
        grid: of both.
        rank: (k,) of the previous stage for "shortest": candidates of a higher rank go first; None: all are equal.
        epsilon: (n,) for "closest", in the order of the grid.

    Attributes:
        value: (k,) of the next stage, -inf where no path leads.
        top: the largest value of each cell.
        source: (k,) index of the predecessor, -1 for none.
    """

    def __init__(
        self,
        name: str,
        old: "Cells",
        value: Array,
        top: Array,
        cells: "Cells",
        grid: "Grid",
        *,
        rank: NDArray[np.int64] | None = None,
        epsilon: Array | None = None,
    ) -> None:
        count = len(cells.ids)
        self.value, self.top = np.empty(count), np.empty(len(cells.start) - 1)
        self.source = np.empty(count, dtype=np.int32)
        self._call, self._grid = calls()[name], _grid(grid)
        self._owners = (old, value, top, cells, grid, rank, epsilon)
        self._step = struct("sweep", "Step")(
            **{"from": _cells(old)},
            grid=ctypes.addressof(self._grid),
            known=_values(value, top),
            to=_cells(cells),
            made=_values(self.value, self.top),
            source=self.source.ctypes.data,
            rank=None if rank is None else rank.ctypes.data,
            epsilon=None if epsilon is None else epsilon.ctypes.data,
        )

    def __call__(self, first: int, last: int) -> None:
        """Process cells first to last - 1."""
        self._call(ctypes.addressof(self._step), first, last)


TAU = 2 * np.pi
#: Smallest step that is allowed [rad or m].
LEAST_EPSILON = 1e-300


def steps_between(a: Array, b: Array, continuous: NDArray[np.bool_]) -> Array:
    """Steps from configurations a to b (..., n); continuous joints take the shorter way."""
    d = b - a
    return np.where(continuous, d - TAU * np.floor(d / TAU + 0.5), d)


def path_steps(q: Array, continuous: NDArray[np.bool_], *, closed: bool) -> Array:
    """Steps along the path q (L, n), including the closing step of a cycle: (L - 1, n) or (L, n)."""
    following = np.roll(q, -1, axis=0) if closed else q[1:]
    return steps_between(q if closed else q[:-1], following, continuous)


def path_length(q: Array, continuous: NDArray[np.bool_], *, closed: bool) -> float:
    """Σ ‖Δq‖ along the path q (L, n)."""
    return float(np.linalg.norm(path_steps(q, continuous, closed=closed), axis=1).sum())


def without_jumps(q: Array, continuous: NDArray[np.bool_]) -> Array:
    """The path q (L, n) with continuous joints unwrapped, starting at their first value."""
    steps = steps_between(q[:-1], q[1:], continuous)
    turned = np.vstack([q[:1], q[0] + np.cumsum(steps, axis=0)])
    return np.where(continuous, turned, q)


def within(q: Array, epsilon: Array, continuous: NDArray[np.bool_], *, strict: bool, closed: bool) -> bool:
    """Whether every step of the path q (L, n) is below ε, (n,) or one for each step, or, without `strict`, at most ε."""
    steps = np.abs(path_steps(q, continuous, closed=closed))
    return bool((steps < epsilon if strict else steps <= epsilon).all())


def full_turns(q: Array, continuous: NDArray[np.bool_]) -> Array:
    """Net rotation of each joint (n,) over the cycle q (L, n) [rad]: full turns of continuous joints, else 0."""
    return np.where(continuous, 2 * np.pi * np.round((q[-1] - q[0]) / (2 * np.pi)), 0.0)


def check_epsilon(value: ArrayLike, turns: NDArray[np.bool_], argument: str = "epsilon") -> Array:
    """`value`, one number or n of them, as read-only (n,): finite, above zero, below π for joints that turn, a mask (n,)."""
    n = len(turns)
    array = number_array(argument, value)
    if array.shape not in ((), (n,)):
        raise InvalidInputError(argument, value, f"one number or {n} of them, one per joint")
    if not ((array >= LEAST_EPSILON) & (array <= LARGEST)).all():
        raise InvalidInputError(argument, value, f"finite numbers above zero, {LEAST_EPSILON:g} to {LARGEST:g} [rad or m]")
    array = np.broadcast_to(array, (n,)).copy()
    if (array[turns] >= np.pi).any():
        raise InvalidInputError(argument, value, "below π for joints that turn")
    array.flags.writeable = False
    return array


def exclusive(epsilon: Array, *, strict: bool) -> Array:
    """Exclusive bound on each step (n,): with strict=False the next larger number, so that ε itself is allowed."""
    return epsilon if strict else np.nextafter(epsilon, np.inf)


#: Maximum number of joints that are hashed.
AXES = 3
#: Minimum number of cells of a hashed joint: three of them are searched anyway.
FEWEST = 4
#: Relative margin of the cell width over the largest step, so that rounding never puts neighbours two cells apart.
HAIR = 1e-6
#: Number of configurations from which the joints to hash are chosen.
SAMPLE = 4096


@dataclass(frozen=True, kw_only=True, eq=False)
class Grid:
    """Cells of equal width over three joints; a joint with a single cell is not hashed.

    Attributes:
        joints: (3,) joints that are hashed.
        low: (3,) lower edge of the first cell [rad or m].
        per: (3,) cells per rad or m.
        count: (3,) number of cells.
        wraps: (3,) whether the last cell is adjacent to the first.
        order: (n,) order in which joints are compared: joints that are not hashed come first, as they reject more pairs.
        turns: (n,) whether the joint is continuous, in that order.
    """

    joints: NDArray[np.int64]
    low: Array
    per: Array
    count: NDArray[np.int64]
    wraps: NDArray[np.bool_]
    order: NDArray[np.int64]
    turns: NDArray[np.bool_]

    @property
    def cells(self) -> int:
        """Number of cells."""
        return int(self.count.prod())


def choose_grid(sample: Array, extent: Array, reach: Array, continuous: NDArray[np.bool_], most: int) -> Grid:
    """The grid of at most `most` cells that separates the most pairs of `sample` (S, n).

    extent (2, n): smallest and largest joint values of all configurations; reach (n,): bound on all steps. Joints are added one
    by one; a joint triples the cells to search, so it has to leave less than a third of the pairs in a common cell.
    """
    n = sample.shape[1]
    low, high = extent
    rounding = 8 * np.finfo(np.float64).eps * np.maximum(np.abs(low), np.abs(high))
    with np.errstate(over="ignore"):
        width = reach * (1 + HAIR) + rounding
        span = np.where(continuous, TAU, high - low)
        full = np.where(continuous, np.floor(TAU / width), np.floor(span / width) + 1)
    joints: list[int] = []
    counts: list[int] = []
    key = np.zeros(len(sample), dtype=np.int64)
    together = _pairs(key)
    room = most
    while len(joints) < AXES and together > 0:
        best = (together / 3, -1, 0, key)
        for j in range(n):
            cells = int(min(full[j], room))
            if j in joints or cells < FEWEST or not np.isfinite(span[j]):
                continue
            share = (sample[:, j] - low[j]) / span[j] if not continuous[j] else sample[:, j] / TAU
            trial = key * cells + np.minimum((share % 1.0 if continuous[j] else share) * cells, cells - 1).astype(np.int64)
            left = _pairs(trial)
            if left < best[0]:
                best = (left, j, cells, trial)
        if best[1] < 0:
            break
        together, key = best[0], best[3]
        joints.append(best[1])
        counts.append(best[2])
        room //= best[2]
    hashed = np.array(joints + [0] * (AXES - len(joints)), dtype=np.int64)
    count = np.array(counts + [1] * (AXES - len(counts)), dtype=np.int64)
    wraps = continuous[hashed] & (count > 1)
    with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
        even = count / span[hashed]
    # an unhashed axis has one cell; cells that divide the span evenly are never narrower than `width`
    per = np.where(count == 1, 0.0, np.where(wraps, count / TAU, np.minimum(1 / width[hashed], even)))
    order = np.argsort([(j in joints) * 1e18 - min(full[j], 1e17) for j in range(n)], kind="stable")
    return Grid(
        joints=hashed,
        low=low[hashed].copy(),
        per=per,
        count=count,
        wraps=wraps,
        order=order.astype(np.int64),
        turns=np.ascontiguousarray(continuous[order]),
    )


def _pairs(key: NDArray[np.int64]) -> float:
    sizes = np.unique(key, return_counts=True)[1].astype(np.float64)
    return float((sizes * (sizes - 1)).sum())


#: Minimum number of candidates of a layer that threads share.
SHARED = 8192
#: Minimum number of candidates that take part per stage.
LEAST = 512
#: Number of pieces of a layer per thread: pieces take unequal time.
PIECES = 4


class SweepStage(NamedTuple):
    """Candidates of one step of a sweep, q (k, n) [rad or m] and m (k,), contiguous; reach (n,): bound on the step."""

    q: Array
    m: Array
    reach: Array


class Cells(NamedTuple):
    """Candidates of a stage sorted by cell: indices, configurations, manipulability, start of each cell, bound on the step."""

    ids: NDArray[np.int32]
    rows: Array
    m: Array
    start: NDArray[np.int32]
    reach: Array


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
    share = min(1.0, max(part.share, LEAST / len(stage.m)))
    return sorted_into_cells(stage.q, stage.m, stage.reach, part.threshold, share, part.cap, grid)


def sweep(
    stages: Iterable[Cells], grid: Grid, objective: SweepObjective, pool: ThreadPool, tick: Callable[[int], None]
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
        return _reach(cells, cells.m)

    def step(self, old: Cells, reached: Reached, cells: Cells, grid: Grid, share: Share) -> tuple[Reached, NDArray[np.int32]]:
        made = StepKernel("widest", old, reached.value, reached.top, cells, grid)
        share(made, cells)
        return Reached(made.value, made.top), made.source


@dataclass(frozen=True, kw_only=True)
class Shortest:
    """The negative length Σ ‖Δq‖ of a path."""

    def first(self, cells: Cells) -> Reached:
        return _reach(cells, np.zeros(len(cells.ids)))

    def step(self, old: Cells, reached: Reached, cells: Cells, grid: Grid, share: Share) -> tuple[Reached, NDArray[np.int32]]:
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
        return _reach(cells, value)._replace(rank=_ranks(codes, value), vectors=codes)

    def step(self, old: Cells, reached: Reached, cells: Cells, grid: Grid, share: Share) -> tuple[Reached, NDArray[np.int32]]:
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
        return _reach(cells, np.zeros(len(cells.ids)))

    def step(self, old: Cells, reached: Reached, cells: Cells, grid: Grid, share: Share) -> tuple[Reached, NDArray[np.int32]]:
        epsilon = np.ascontiguousarray(self.epsilon[grid.order])
        made = StepKernel("closest", old, reached.value, reached.top, cells, grid, epsilon=epsilon)
        share(made, cells)
        return Reached(made.value, made.top), made.source


@dataclass(frozen=True, kw_only=True)
class Longest:
    """The number of steps of the longest path to a candidate, which may begin at any stage."""

    def first(self, cells: Cells) -> Reached:
        return _reach(cells, np.zeros(len(cells.ids)))

    def step(self, old: Cells, reached: Reached, cells: Cells, grid: Grid, share: Share) -> tuple[Reached, NDArray[np.int32]]:
        alike = cells._replace(m=np.full(len(cells.ids), reached.top.max()))  # the manipulability does not limit a length
        made = StepKernel("widest", old, reached.value, reached.top, alike, grid)
        share(made, alike)
        return _reach(cells, np.maximum(made.value + 1.0, 0.0)), made.source


def _reach(cells: Cells, value: Array) -> Reached:
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
