"""The search of guilamo2006, section IV: paths extended by backtracking from one start after the other.

The first start is the best candidate of the layer whose best is the smallest: no path can have a larger minimum. From it a path
is extended to the last layer, then from it to the first, each time to the continuous candidate with the largest manipulability
that is not below that of the start; where there is none, the search backtracks. If a start fails, the candidate with the next
lower manipulability of any layer is the next start. The first complete path is optimal, as each start is searched in full.

The paper does not say how the two halves share backtracking: here they share only the start, which is enough, as the two halves
are independent. Without memoisation the time of the search grows exponentially with the number of layers; memoised, it skips
the candidates that were dead ends for the same start.

Starts, branches and comparisons are those of the search as written. Here the continuous candidates of a candidate are computed
once, for all starts, so the time is not that of the paper's search.
"""

from bisect import bisect_left, bisect_right, insort
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np

import manipplan as mp

Array = np.ndarray[Any, np.dtype[np.float64]]


@dataclass(frozen=True, kw_only=True, eq=False)
class Found:
    """The path that the search found, with the paper's counts; where there is none, arrays are empty.

    Attributes:
        indices: the chosen candidate of each layer (L,).
        manipulability: manipulability at each position (L,).
        minimum: the smallest of these values; -inf where there is no path.
        start: layer and candidate of the last start.
        new_starts: number of starts tried.
        branches: number of candidates appended to a partial path.
        comparisons: number of pairs of configurations compared.
        end: "found", "not connected", or "gave up" after `most_branches`.
    """

    indices: list[int]
    manipulability: Array
    minimum: float
    start: tuple[int, int]
    new_starts: int
    branches: int
    comparisons: int
    end: Literal["found", "not connected", "gave up"]


def search(layers: mp.Layers, epsilon: float, *, memoised: bool, most_branches: int | None = None) -> Found:
    """The path with the largest minimum manipulability whose joints step by less than `epsilon` [rad or m].

    Args:
        layers: candidates with their manipulability, not closed.
        epsilon: bound on each joint's step between neighbouring layers.
        memoised: whether each start visits each candidate at most once.
        most_branches: maximum number of branches before the search gives up; None: no limit.
    """
    ranked = [np.argsort(-m, kind="stable") for m in layers.m]
    work = _Search(
        q=[np.ascontiguousarray(q[order].T) for q, order in zip(layers.q, ranked, strict=True)],
        descent=[(-m[order]).tolist() for m, order in zip(layers.m, ranked, strict=True)],
        continuous=layers.continuous,
        epsilon=epsilon,
        memoised=memoised,
        most_branches=np.inf if most_branches is None else most_branches,
    )
    path: list[int] | None = None
    end: Literal["found", "not connected", "gave up"] = "not connected"
    number = 0
    for number, (layer, rank) in enumerate(_starts(layers, ranked), start=1):  # noqa: B007  # used after the loop
        try:
            path = work.path_from(layer, rank)
        except _TooManyError:
            end = "gave up"
            break
        if path is not None:
            end = "found"
            break
    indices = [int(order[k]) for order, k in zip(ranked, path or [], strict=False)]
    m = np.array([each[k] for each, k in zip(layers.m, indices, strict=False)])
    return Found(
        indices=indices,
        manipulability=m,
        minimum=float(m.min(initial=np.inf)) if indices else -np.inf,
        start=(layer, int(ranked[layer][rank])),
        new_starts=number,
        branches=work.branches,
        comparisons=work.comparisons,
        end=end,
    )


def _starts(layers: mp.Layers, ranked: list[np.ndarray[Any, np.dtype[np.int64]]]) -> list[tuple[int, int]]:
    """Layer and rank of each start: the bound, then all candidates of at most its manipulability, in descending order."""
    m = np.concatenate([each[order] for each, order in zip(layers.m, ranked, strict=True)])
    layer = np.repeat(np.arange(len(ranked)), layers.sizes)
    offset = np.concatenate([[0], np.cumsum(layers.sizes)])
    first = offset[int(np.argmin([each.max() for each in layers.m]))]
    lower = np.argsort(-m, kind="stable")
    lower = np.concatenate([[first], lower[(m[lower] <= m[first]) & (lower != first)]])
    return list(zip(layer[lower].tolist(), (lower - offset[layer[lower]]).tolist(), strict=True))


class _TooManyError(Exception):
    """The search has as many branches as are allowed."""


@dataclass(kw_only=True, eq=False)
class _Search:
    """The counts of a search, and what it remembers. Candidates of a layer are numbered by rank.

    Attributes:
        q: configurations (n, k_i) of each layer.
        descent: their manipulability with the opposite sign, ascending.
        seen: ranks of each layer that were in the path from the present start, ascending; where memoised.
        near: by candidate and neighbouring layer, the ranks there that are continuous, and the number of ranks compared.
    """

    q: list[Array]
    descent: list[list[float]]
    continuous: np.ndarray[Any, np.dtype[np.bool_]]
    epsilon: float
    memoised: bool
    most_branches: float
    branches: int = 0
    comparisons: int = 0
    seen: dict[int, list[int]] = field(default_factory=dict)
    near: dict[tuple[int, int, int], tuple[list[int], int]] = field(default_factory=dict)

    def path_from(self, layer: int, rank: int) -> list[int] | None:
        """The rank in each layer of a path through one candidate, none of which has a lower manipulability; None: no path."""
        self.seen = {}
        upwards = self._extend(layer, rank, len(self.q) - 1, 1)
        downwards = None if upwards is None else self._extend(layer, rank, 0, -1)
        return None if upwards is None or downwards is None else [*downwards[::-1], rank, *upwards]

    def _extend(self, layer: int, rank: int, last: int, ahead: int) -> list[int] | None:
        """The ranks from the layer after `layer` to the `last`; None: no path."""
        least = self.descent[layer][rank]
        path, pointers = [rank], [0]
        while layer != last:
            following = layer + ahead
            end = bisect_right(self.descent[following], least)
            found = self._next(layer, path[-1], following, pointers[-1], end)
            if found is None:
                path.pop()
                pointers.pop()
                if not path:
                    return None
                layer -= ahead
                continue
            if self.branches >= self.most_branches:
                raise _TooManyError
            self.branches += 1
            pointers[-1] = found + 1
            if self.memoised:
                insort(self.seen.setdefault(following, []), found)
            path.append(found)
            pointers.append(0)
            layer = following
        return path[1:]

    def _next(self, layer: int, rank: int, following: int, begin: int, end: int) -> int | None:
        """The first continuous candidate from rank `begin` on, below `end`, that is not left out; counts the comparisons."""
        seen = self.seen.get(following, [])
        near = self._near(layer, rank, following, end)
        k = bisect_left(near, begin)
        while k < len(near) and near[k] < end and _holds(seen, near[k]):
            k += 1
        found = near[k] if k < len(near) and near[k] < end else None
        stop = end if found is None else found + 1
        self.comparisons += max(stop - begin, 0) - (bisect_left(seen, stop) - bisect_left(seen, begin))
        return found

    def _near(self, layer: int, rank: int, following: int, end: int) -> list[int]:
        """Ranks of the layer `following` that are continuous with a candidate: all below `end`, and perhaps some beyond."""
        near, compared = self.near.get((layer, rank, following), ([], 0))
        if compared < end:
            target = self.q[following]
            upto = min(target.shape[1], max(end, 2 * compared))
            ranks = np.arange(compared, upto)
            for here, there, turns in zip(self.q[layer][:, rank], target, self.continuous, strict=True):
                step = there[ranks] - here
                size = np.abs(step)
                if turns:
                    size = np.minimum(size, np.abs(step - 2 * np.pi * np.floor(step / (2 * np.pi) + 0.5)))
                ranks = ranks[size < self.epsilon]
            near = [*near, *ranks.tolist()]
            self.near[layer, rank, following] = near, upto
        return near


def _holds(ascending: list[int], value: int) -> bool:
    k = bisect_left(ascending, value)
    return k < len(ascending) and ascending[k] == value
