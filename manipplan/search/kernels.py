"""The compiled steps of the dynamic program: `sweep.c`."""

import ctypes
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from manipplan.support.checks import Array
from manipplan.support.compiling.native import needed_code

if TYPE_CHECKING:
    from manipplan.search.grid import Grid
    from manipplan.search.sweep import Cells

_P, _N, _D = ctypes.c_void_p, ctypes.c_long, ctypes.c_double
#: Result and arguments of the functions of sweep.c.
SIGNATURES: dict[str, tuple[Any, ...]] = {
    "taking_part": (_N, _P, _N, _D, _D, _P),
    "sort_into_cells": (None, _P, _P, _P, _P, _N, _D, _P, _P),
    "largest_of_each": (None, _P, _N, _P, _P),
    "widest": (None, _P, _N, _N),
    "shortest": (None, _P, _N, _N),
    "closest": (None, _P, _N, _N),
}


@cache
def calls() -> Mapping[str, Callable[..., Any]]:
    """The functions of sweep.c, by their names without prefix; raises CompilerError where it cannot be compiled."""
    return needed_code(Path(__file__).with_name("sweep.c"), "searches through layers").functions("manipplan_", SIGNATURES)


class _GridStruct(ctypes.Structure):
    """`Grid` of sweep.c."""

    _fields_ = [("n", _N), *((name, _P) for name in ("joints", "low", "per", "count", "wraps", "order", "reach", "turns"))]


class _CellsStruct(ctypes.Structure):
    """`Cells` of sweep.c."""

    _fields_ = [(name, _P) for name in ("ids", "rows", "m", "start")]


class _StepStruct(ctypes.Structure):
    """`Step` of sweep.c."""

    _fields_ = [
        ("grid", _P),
        ("from", _CellsStruct),
        ("known", 2 * _P),
        ("to", _CellsStruct),
        ("made", 2 * _P),
        *((name, _P) for name in ("source", "rank", "epsilon")),
    ]


def _grid(grid: "Grid") -> _GridStruct:
    """It points to the arrays of the grid, which has to outlive it."""
    arrays = (grid.joints, grid.low, grid.per, grid.count, grid.wraps, grid.order, grid.reach, grid.turns)
    return _GridStruct(len(grid.order), *(each.ctypes.data for each in arrays))


def _cells(cells: "Cells") -> _CellsStruct:
    return _CellsStruct(*(each.ctypes.data for each in cells))


def sorted_into_cells(q: Array, m: Array, threshold: float, share: float, cap: float, grid: "Grid") -> "Cells":
    """The candidates q (k, n) with m (k,) >= threshold, sorted by cell, with m limited to `cap`.

    With a share below 1 about that share of them; the choice is pseudo-random but reproducible, and a smaller share is a subset
    of a larger one.
    """
    from manipplan.search.sweep import Cells

    q, m = np.ascontiguousarray(q), np.ascontiguousarray(m)
    taken = np.empty(len(m) + 1, dtype=np.int32)
    k = calls()["taking_part"](m.ctypes.data, len(m), threshold, share, taken.ctypes.data)
    cells = Cells(np.empty(k, dtype=np.int32), np.empty((k, q.shape[1])), np.empty(k), np.empty(grid.cells + 1, dtype=np.int32))
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
        self._kept = (old, value, top, cells, grid, rank, epsilon)
        self._step = _StepStruct(
            ctypes.addressof(self._grid),
            _cells(old),
            (2 * _P)(value.ctypes.data, top.ctypes.data),
            _cells(cells),
            (2 * _P)(self.value.ctypes.data, self.top.ctypes.data),
            self.source.ctypes.data,
            None if rank is None else rank.ctypes.data,
            None if epsilon is None else epsilon.ctypes.data,
        )

    def __call__(self, first: int, last: int) -> None:
        """Process cells first to last - 1."""
        self._call(ctypes.addressof(self._step), first, last)
