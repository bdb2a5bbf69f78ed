"""What a sweep maximises: the least index, minus the length, the sorted indices, minus the factor of ε."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from manipplan.checks import Array
from manipplan.search.grid import Grid
from manipplan.search.sweep import Cells, Piece, Reached

Share = Callable[[Piece, Cells], None]


@dataclass(frozen=True, kw_only=True)
class Widest:
    """The least index of a path: W(b) = min(m(b), max over neighbours of W)."""

    def first(self, cells: Cells) -> Reached:
        return _reached(cells, cells.m)

    def step(self, old: Cells, reached: Reached, cells: Cells, grid: Grid, share: Share) -> tuple[Reached, NDArray[np.int32]]:
        from manipplan.search.kernels import widest_step

        value, source, top = _results(cells)

        def piece(first: int, last: int) -> None:
            widest_step(
                old.rows, reached.value, reached.top, old.start, cells.rows, cells.m, cells.start, first, last,
                grid.reach, grid.turns, grid.count, grid.wraps, value, source, top,
            )  # fmt: skip

        share(piece, cells)
        return Reached(value, top), source


@dataclass(frozen=True, kw_only=True)
class Shortest:
    """Minus the length Σ ‖Δq‖ of a path."""

    def first(self, cells: Cells) -> Reached:
        return _reached(cells, np.zeros(len(cells.ids)))

    def step(self, old: Cells, reached: Reached, cells: Cells, grid: Grid, share: Share) -> tuple[Reached, NDArray[np.int32]]:
        value, source, top = _shortest(old, reached, cells, grid, share, np.empty(0, np.int64))
        return Reached(value, top), source


@dataclass(frozen=True, kw_only=True)
class Lexicographic:
    """The indices of a path in ascending order, compared as words are; of equal ones the shorter path.

    An index that is added to two such vectors leaves their order as it is, so the best path to a candidate begins with the
    best path to one of its neighbours. Vectors are kept as whole numbers that are ordered as the indices are.
    """

    def first(self, cells: Cells) -> Reached:
        codes = _codes(cells.m)[:, np.newaxis]
        value = np.zeros(len(cells.ids))
        return _reached(cells, value)._replace(rank=_ranks(codes, value), vectors=codes)

    def step(self, old: Cells, reached: Reached, cells: Cells, grid: Grid, share: Share) -> tuple[Reached, NDArray[np.int32]]:
        assert reached.rank is not None and reached.vectors is not None
        value, source, top = _shortest(old, reached, cells, grid, share, reached.rank)
        before = reached.vectors[np.maximum(source, 0)]
        vectors = np.sort(np.column_stack([before, _codes(cells.m)]), axis=1)
        return Reached(value, top, _ranks(vectors, value), vectors), source


@dataclass(frozen=True, kw_only=True, eq=False)
class Closest:
    """Minus the factor by which `epsilon` (n,) has to be multiplied so that a path is continuous."""

    epsilon: Array

    def first(self, cells: Cells) -> Reached:
        return _reached(cells, np.zeros(len(cells.ids)))

    def step(self, old: Cells, reached: Reached, cells: Cells, grid: Grid, share: Share) -> tuple[Reached, NDArray[np.int32]]:
        from manipplan.search.kernels import closest_step

        value, source, top = _results(cells)
        epsilon = np.ascontiguousarray(self.epsilon[grid.order])

        def piece(first: int, last: int) -> None:
            closest_step(
                old.rows, reached.value, reached.top, old.start, cells.rows, epsilon, cells.start, first, last,
                grid.reach, grid.turns, grid.count, grid.wraps, value, source, top,
            )  # fmt: skip

        share(piece, cells)
        return Reached(value, top), source


def _results(cells: Cells) -> tuple[Array, NDArray[np.int32], Array]:
    count = len(cells.ids)
    return np.empty(count), np.empty(count, dtype=np.int32), np.empty(len(cells.start) - 1)


def _reached(cells: Cells, value: Array) -> Reached:
    from manipplan.search.cells import largest_of_each

    return Reached(value, largest_of_each(cells.start, value))


def _shortest(
    old: Cells, reached: Reached, cells: Cells, grid: Grid, share: Share, rank: NDArray[np.int64]
) -> tuple[Array, NDArray[np.int32], Array]:
    from manipplan.search.kernels import shortest_step

    value, source, top = _results(cells)

    def piece(first: int, last: int) -> None:
        shortest_step(
            old.rows, reached.value, reached.top, old.start, cells.rows, rank, len(rank) > 0, cells.start, first, last,
            grid.reach, grid.turns, grid.count, grid.wraps, value, source, top,
        )  # fmt: skip

    share(piece, cells)
    return value, source, top


def _codes(m: Array) -> NDArray[np.uint64]:
    """Whole numbers (k,) in the order of the indices; equal ones, 0 and -0 too, get equal numbers."""
    bits = (m + 0.0).view(np.uint64)
    sign = np.uint64(1 << 63)
    return np.where(bits & sign, ~bits, bits | sign)


def _ranks(vectors: NDArray[np.uint64], value: Array) -> NDArray[np.int64]:
    """Ranks (k,) of vectors (k, i), equal for equal ones; of those that are not reached -1."""
    rank = np.full(len(value), -1, dtype=np.int64)
    found = np.flatnonzero(value > -np.inf)
    # big-endian bytes compare as the numbers do, and one comparison of bytes is far quicker than i sorts of columns
    words = np.ascontiguousarray(vectors[found].astype(">u8")).view(f"S{8 * vectors.shape[1]}")[:, 0]
    rank[found] = np.unique(words, return_inverse=True)[1]
    return rank
