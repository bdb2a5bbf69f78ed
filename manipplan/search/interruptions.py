"""fewest_interruptions: where to lift off and to come back in another configuration if no path leads through all layers.

Any stretch of a connected part is connected. So the longest part from a position on, then the longest from its end on, and
so forth, are the fewest parts of an open path; those of a cycle are the fewest over all positions where it can begin. How far
parts reach takes one sweep: it finds the first position from which each position is reached.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from manipplan.kinematics.batch import all_cores
from manipplan.search.layers import Layers
from manipplan.search.max_min import THREADED
from manipplan.search.search import ThresholdSearch
from manipplan.search.sweep import Subset, ThreadPool, check_epsilon, exclusive
from manipplan.support.checks import Array, ArrayLike, flag, instance
from manipplan.support.display import one_line
from manipplan.support.errors import PlanningError
from manipplan.support.progress import Progress, as_callback

#: Number of values of m in the first sweep of the search for the largest minimum, and how it grows.
FIRST, GROWTH = 4096, 4
#: Where edges are tried between the first and the last position where they can be.
SHARES = (0.5, 0.25, 0.75, 0.0, 1.0)
#: Number of candidates visited in the worst case, as a multiple of all.
WORK = 16.0


@one_line
@dataclass(frozen=True, kw_only=True)
class Interruptions:
    """The fewest parts in which the positions of a path can be passed, each on a continuous path.

    Attributes:
        edges: where the parts begin and end, counted from 0: part i passes edges[i] to edges[i + 1], including both. The arm
            lifts off at the end of a part and comes back at the same position. Positions of a cycle count on beyond its last.
        minimum: the largest minimum manipulability of so few parts.
        others: other edges with as few parts and that minimum, for where the arm cannot lift off at these.
    """

    edges: tuple[int, ...]
    minimum: float
    others: tuple[tuple[int, ...], ...] = ()

    @property
    def parts(self) -> int:
        """Number of parts."""
        return len(self.edges) - 1


def fewest_interruptions(
    layers: Layers, epsilon: ArrayLike, *, strict: bool = True, progress: Progress | None = None
) -> Interruptions:
    """Split a path through the layers into the fewest parts, and of these find ones with the largest minimum manipulability.

    The result is exact, in float64. If several positions are possible for an interruption, the middle one is taken; `others`
    are some of the rest.

    Args:
        layers: candidates with their manipulability. Closed ones are passed once around, from the position that needs the
            fewest parts; only a cycle closes, so there is at least one interruption.
        epsilon, strict: as in `max_min_search`.
        progress: called with the share done in [0, 1] and a text.

    Raises:
        InvalidInputError: for bad arguments.
        PlanningError: two neighbouring positions have no candidates within epsilon, so that no interruption helps.
    """
    reach = _reach(layers, epsilon, strict)
    values = np.unique(np.concatenate(layers.m))
    values = values[values <= layers.bound]
    with _search(layers, progress) as search:

        def first_above(k: int) -> NDArray[np.int64]:
            return search.first_positions(Subset(threshold=values[k]), reach, f"interruptions with m >= {values[k]:.6g}")

        first = first_above(0)
        edges = _edges(first, closed=layers.closed)
        if not edges:
            raise PlanningError(_gap(search.first_positions(Subset(), reach, "gaps of the path"), len(layers.q)), None)
        # values[low] allows so few parts, values[high] does not; more and more values from above, then in turns the value next
        # to what the best paths of the parts reach, and half-way
        low, high, stride, next_to = 0, len(values), FIRST, False
        while high - low > 1:
            k = max(high - stride, high // 2) if not low else low + 1 if next_to else (low + high) // 2
            higher = first_above(k)
            found = _edges(higher, closed=layers.closed)
            if len(found) == len(edges):
                first, edges, next_to = higher, found, not next_to
                low = int(np.searchsorted(values, search.minimum_between(_between(first, edges, SHARES[0]), values[k], reach)))
            else:
                high, stride, next_to = k, GROWTH * stride, True
        if low:
            first = first_above(low)
            edges = _edges(first, closed=layers.closed)
    middle, *others = dict.fromkeys(_between(first, edges, share) for share in SHARES)
    return Interruptions(edges=middle, minimum=float(values[low]), others=tuple(others))


@dataclass(frozen=True, kw_only=True)
class Gaps:
    """Where no path leads on through layers.

    Attributes:
        ranges: for each gap the first and the last of the positions between which it has to be closed: the next path leads to
            the last one, and begins no earlier than beside the first one. Positions of a cycle count on beyond its last.
        parts: the number of parts that `fewest_interruptions` finds; None where a single step has no path.
    """

    ranges: tuple[tuple[int, int], ...]
    parts: int | None


def find_gaps(layers: Layers, epsilon: ArrayLike, *, progress: Progress | None = None) -> Gaps:
    """The gaps of a path through the layers, by one sweep; arguments as in `fewest_interruptions`."""
    with _search(layers, progress) as search:
        first = search.first_positions(Subset(), _reach(layers, epsilon, strict=True), "gaps of the path")
    edges = _edges(first, closed=layers.closed)
    ranges, begin, end = list[tuple[int, int]](), 0, len(first) - 1
    while (farthest := _farthest(first, begin)) < end:
        beyond = farthest + 1
        ranges.append((max(int(first[beyond]) - 1, 0), beyond))
        begin = max(farthest, begin + 1)
    return Gaps(ranges=tuple(ranges), parts=len(edges) - 1 if edges else None)


@contextmanager
def _search(layers: Layers, progress: Progress | None) -> Iterator[ThresholdSearch]:
    with ThreadPool(all_cores() if layers.count >= THREADED else 1) as pool:
        yield ThresholdSearch(layers, pool, as_callback(progress), work=WORK * layers.count)


def _reach(layers: Layers, epsilon: ArrayLike, strict: bool) -> Array:
    instance("layers", layers, Layers)
    return exclusive(check_epsilon(epsilon, layers.continuous), strict=flag("strict", strict))


def _edges(first: NDArray[np.int64], *, closed: bool) -> tuple[int, ...]:
    """Edges of the fewest parts, given the first position from which each is reached; () where a step has no path."""
    count = len(first) // 2 if closed else len(first)
    if (first[1:] == np.arange(1, len(first))).any():
        return ()
    if not closed:
        return tuple(_greedy(first, 0, count - 1))
    rounds = [_greedy(first, begin, begin + count) for begin in range(count)]
    fewest = min(map(len, rounds))
    # of several positions to begin at the one from which the last part could go on the farthest
    spare = [_farthest(first, each[-2]) - each[-1] if len(each) == fewest else -1 for each in rounds]
    return tuple(rounds[int(np.argmax(spare))])


def _farthest(first: NDArray[np.int64], begin: int) -> int:
    """The last position that a part from `begin` on reaches."""
    return int(np.searchsorted(first, begin, side="right")) - 1


def _greedy(first: NDArray[np.int64], begin: int, end: int) -> list[int]:
    """Edges of the fewest parts from `begin` to `end`, each as long as it can be."""
    edges = [begin]
    while edges[-1] < end:
        edges.append(min(_farthest(first, edges[-1]), end))
    return edges


def _between(first: NDArray[np.int64], edges: tuple[int, ...], share: float) -> tuple[int, ...]:
    """As many parts between the same ends, each edge at a share between the first and the last position where it can be."""
    earliest = list(edges)
    for i in range(len(edges) - 2, 0, -1):
        earliest[i] = int(first[earliest[i + 1]])
    chosen = [edges[0]]
    for begin in earliest[1:-1]:
        chosen.append(begin + int(share * (_farthest(first, chosen[-1]) - begin)))
    return (*chosen, edges[-1])


def _gap(first: NDArray[np.int64], count: int) -> str:
    """What is wrong where a step between two positions has no path."""
    k = int(np.flatnonzero(first[1:] == np.arange(1, len(first)))[0])
    return (
        f"no candidate of position {(k + 1) % count} can be reached from position {k % count}, so no interruption helps; "
        "use a larger epsilon, more positions or more samples"
    )
