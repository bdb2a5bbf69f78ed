"""The parts of a workspace path along which there are continuous motions: all of it or, where none is, the fewest."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import pairwise

from numpy.typing import ArrayLike

from manipplan.jobs.following.course import ToolPathPlanner
from manipplan.search.interruptions import fewest_interruptions, fewest_parts
from manipplan.search.max_min import SearchResult, max_min_search
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError
from manipplan.support.progress import Progress, part


@dataclass(frozen=True, kw_only=True, eq=False)
class FoundPart:
    """A part of a workspace path, and a motion along it.

    Attributes:
        s_begin, s_end: where on the path it begins and ends; beyond 1 where it goes on around a closed one.
        finder: of courses along it.
        found: the best motion through its positions.
    """

    s_begin: float
    s_end: float
    finder: ToolPathPlanner
    found: SearchResult


#: Makes the finder of a path again with finer samples; None where there are none. Raises InvalidInputError where they cannot be
#: had, since more positions show a place out of reach or beside a body, or more samples need too much memory.
Finer = Callable[[Progress], ToolPathPlanner | None]


def find_parts(
    finder: ToolPathPlanner, finer: Finer, epsilon: ArrayLike, most: int, tell: Progress, *, start: Array | None = None
) -> Iterator[list[FoundPart]] | SearchResult:
    """The fewest parts, with the largest minimum manipulability; the result of the search where the interruptions are too many.

    As many parts with other edges follow, for where the arm cannot leave the path at the edges of the first.

    Where no motion through the samples is continuous, finer ones are tried before the path is cut.

    Args:
        finder: of courses along the whole path.
        finer: see Finer.
        epsilon: as in `max_min_search`.
        most: maximum number of interruptions.
        tell: called with the share done.
        start: (n,) at the first pose of the path, where the motion begins. An interrupted motion around a closed path begins
            elsewhere.
    """
    tried: list[ToolPathPlanner] = []
    no_finer = ""
    for k, samples in enumerate((lambda _: finder, finer)):
        try:
            each = samples(part(tell, 0.2, 0.5))
        except InvalidInputError as error:  # about positions and samples that the caller did not give
            no_finer, each = f"; finer samples: {error}", None
        if each is None:
            continue
        begun = each if start is None else each.starting_at(start)
        search = part(tell, 0.5 * k, 0.5 * k + 0.2)
        found = max_min_search(begun.layers, epsilon, explain=False, throw=False, progress=search)
        if found.connected:
            return iter([[FoundPart(s_begin=0.0, s_end=1.0, finder=begun, found=found)]])
        tried.append(each if each.layers.closed else begun)
    counts = [(fewest_parts(each.layers, epsilon, progress=part(tell, 0.7, 0.8)), each) for each in tried]
    possible = [(parts, each) for parts, each in counts if parts is not None]
    if not possible:
        found = _unconnected(finder, epsilon, start)
        return replace(found, message=found.message + no_finer)
    parts, best = min(possible, key=lambda each: each[0])
    interruptions = parts if best.layers.closed else parts - 1
    if interruptions > most:
        times, them = ("1 interruption", "it") if interruptions == 1 else (f"{interruptions} interruptions", "them")
        allowed = f"interruptions={most} does not allow {them}" if most else f"interruptions={interruptions} allows {them}"
        found = _unconnected(finder, epsilon, start)
        return replace(found, message=f"{found.message}; with {times} there is a motion: {allowed}{no_finer}")
    fewest = fewest_interruptions(best.layers, epsilon, progress=part(tell, 0.8, 0.9))
    return ([_part(best, *ends, epsilon) for ends in pairwise(edges)] for edges in (fewest.edges, *fewest.others))


def _unconnected(finder: ToolPathPlanner, epsilon: ArrayLike, start: Array | None) -> SearchResult:
    """The result of the search that finds no path, with the smallest epsilon unless finding it can take minutes."""
    begun = finder if start is None else finder.starting_at(start)
    return max_min_search(begun.layers, epsilon, explain=not finder.layers.closed, throw=False)


def _part(finder: ToolPathPlanner, first: int, last: int, epsilon: ArrayLike) -> FoundPart:
    """The part from one position to another."""
    of_part, s = finder.between(first, last), finder.layers.s
    assert s is not None
    count = len(s)
    return FoundPart(
        s_begin=float(s[first % count]) + first // count,
        s_end=float(s[last % count]) + last // count,
        finder=of_part,
        found=max_min_search(of_part.layers, epsilon),
    )
