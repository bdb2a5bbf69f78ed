"""The compiled search by restarts: `restarts.c`."""

import ctypes
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from manipplan.support.checks import Array
from manipplan.support.compiling.native import needed_code

#: Return status of a call; as in restarts.c.
UNFINISHED, FOUND, EXHAUSTED, TOO_MANY = 0, 1, 2, 3

_P, _N = ctypes.c_void_p, ctypes.c_long


class _Problem(ctypes.Structure):
    """`Problem` of restarts.c."""

    _fields_ = [
        *((name, _N) for name in ("n", "layers", "count")),
        *((name, _P) for name in ("q", "m", "offset", "starts", "layer_of", "reach", "turns")),
        *((name, _N) for name in ("starting", "memoised", "most_branches")),
    ]


class _State(ctypes.Structure):
    """`State` of restarts.c."""

    _fields_ = [
        *((name, _N) for name in ("phase", "level", "starts", "branches", "comparisons")),
        *((name, _P) for name in ("path", "pointer", "seen")),
    ]


@cache
def _call() -> Callable[..., int]:
    code = needed_code(Path(__file__).with_name("restarts.c"), "searches by restarts")
    return code.functions("manipplan_", {"restarts": (_N, _P, _N, _P)})["restarts"]


class RestartSearch:
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
        arrays: tuple[NDArray[Any], ...] = tuple(np.ascontiguousarray(each) for each in (q, m, offset, starts, layer_of, reach))
        self._arrays = (*arrays, np.ascontiguousarray(turns))
        addresses = (each.ctypes.data for each in self._arrays)
        self._problem = _Problem(q.shape[1], layers, len(m), *addresses, len(starts), memoised, most_branches)
        self.path, self._pointer = np.zeros(layers, dtype=np.int64), np.zeros(layers, dtype=np.int64)
        self._seen = np.zeros(len(m), dtype=np.int64)
        self._state = _State(0, 0, 0, 0, 0, *(each.ctypes.data for each in (self.path, self._pointer, self._seen)))

    def __call__(self, budget: int) -> int:
        """Continue for about `budget` comparisons of configurations; returns UNFINISHED, FOUND, EXHAUSTED or TOO_MANY."""
        return _call()(ctypes.addressof(self._problem), budget, ctypes.addressof(self._state))

    @property
    def counts(self) -> tuple[int, int, int]:
        """Numbers of starts, branches and comparisons so far."""
        return self._state.starts, self._state.branches, self._state.comparisons
