"""Cycles: best-first branch and bound over the candidates that a cycle can begin with."""

import heapq
from collections.abc import Callable
from itertools import count
from typing import Any

import numpy as np
from numpy.typing import NDArray

from manipplan.checks import Array

#: Relaxes the cycle for a set of begins: the key of the best path from the set back to the set (smaller is better), and
#: the first and last candidate of it; None when there is none.
Relax = Callable[[NDArray[np.int64]], tuple[Any, int, int, Any] | None]


def best_cycle(q: Array, begins: NDArray[np.int64], relax: Relax) -> Any | None:
    """The best cycle through one of `begins`, candidates of the layer q (k, n); None when there is none. Exact.

    A path that begins and ends somewhere in a set is at least as good as each cycle through a member of the set. So the best
    such path, if it ends where it begins, is the best cycle of the set; else the set is cut between its two ends. Sets are
    taken best first, and the first one whose path closes is the answer. Each set takes one sweep: for n begins at most
    2 n - 1, mostly some tens when only the least index counts, more for the shortest cycle, whose bound is less sharp.
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
