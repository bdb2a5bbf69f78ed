"""The lead-in: the free motion from the start to the path, and the choice of the configuration in which the path begins."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from manipplan.cost.integral import PathIntegral
from manipplan.jobs.following.course import Course, CourseFinder
from manipplan.jobs.following.transit import PlanTransit, Transit
from manipplan.jobs.goals.candidates import APART, TIE, GoalCandidate, measured
from manipplan.search.max_min import SearchResult, max_min_search
from manipplan.search.steps import steps_between
from manipplan.support.checks import Array
from manipplan.support.deadline import work_time
from manipplan.support.progress import Progress, part

#: Maximum number of motions that are planned, and of first configurations to which a lead-in is tried or only a path is found.
MOTIONS, TRIES, SEARCHES = 4, 8, 16
#: Gain in the minimum manipulability below which another first configuration is not tried, nor taken.
GAIN = 0.01
#: Time for all lead-ins [s], and share of what is left that one gets.
SECONDS, SHARE = 10.0, 0.75


@dataclass(frozen=True, kw_only=True, eq=False)
class Entry:
    """A way into the path: the lead-in, the course along the path, and the minimum manipulability of both."""

    lead_in: Transit
    course: Course
    minimum: float


@dataclass(frozen=True, kw_only=True, eq=False)
class EntryChoice:
    """The entry that was chosen, None where none was found, all first configurations, and why there is no entry."""

    entry: Entry | None
    candidates: tuple[GoalCandidate, ...]
    failure: str = ""


def choose_entry(
    finder: CourseFinder, first: SearchResult, start: Array, integral: PathIntegral, plan_transit: PlanTransit, tell: Progress
) -> EntryChoice:
    """The entry with the largest minimum manipulability of lead-in and course together.

    What the start and the best path from a first configuration allow bounds this minimum; it is 0 in another aspect than the
    start. Configurations are tried in the order of their bounds, of equal bounds those with the fewest crossings of
    singularities, then those with the better path, until no bound is above what was reached.

    Args:
        finder: of courses through the layers.
        first: the best path of all through them.
        start: (n,).
        integral: of the g and the manipulability that count.
        plan_transit: plans lead-ins.
        tell: called with the share done.
    """
    searches = best_courses(finder, first)
    most = float(integral.kinematics.manipulability(start))
    waiting: list[tuple[GoalCandidate, SearchResult]] = []
    done: list[GoalCandidate] = []
    best: Entry | None = None
    failure, planned, seconds, ahead = "", 0, SECONDS, np.inf
    while len(done) < TRIES and planned < MOTIONS and (seconds > 0 or best is None):
        while ahead * (1 - TIE) > max((row.bound for row, _ in waiting), default=-np.inf):
            found = next(searches, None)
            if found is None:
                ahead = -np.inf
                break
            found = _turned(found, start, finder.layers.continuous)
            row = measured(found.q[:1], [0], start, integral)[0]
            waiting.append((replace(row, bound=min(row.bound, found.minimum)), found))
            ahead = min(most, found.minimum)
        if not waiting:
            break
        k = max(range(len(waiting)), key=lambda k: _order(waiting[k][0]))
        row, found = waiting[k]
        if best is not None and row.bound <= best.minimum * (1 + GAIN):
            break
        del waiting[k]
        left = 0.5 ** len(done)  # of the share of the work
        course = finder.along(found, part(tell, 1 - left, 1 - 0.7 * left))
        began = work_time()
        lead_in = plan_transit(course.path.start, max(SHARE * seconds, SHARE), part(tell, 1 - 0.7 * left, 1 - 0.5 * left))
        seconds -= work_time() - began
        row = replace(row, q=course.path.start)
        if isinstance(lead_in, str):
            failure = failure or lead_in
            done.append(replace(row, status=f"left out: no lead-in: {lead_in}"))
            continue
        planned += 1
        least = min(lead_in.min_manipulability, integral.cost(course.path).min_manipulability)
        status = f"planned: minimum manipulability {least:.4g}"
        done.append(replace(row, min_manipulability=least, g=lead_in.g, status=status))
        if best is None or least > best.minimum * (1 + GAIN):
            done = [replace(each, chosen=False) for each in done]
            done[-1] = replace(done[-1], chosen=True)
            best = Entry(lead_in=lead_in, course=course, minimum=least)
    told = [replace(each, status=f"chosen, {each.status}") if each.chosen else each for each in done]
    kept = "" if best is None else f"; the motion keeps {best.minimum:.4g}"
    rest = [replace(row, status=f"left out: bound {row.bound:.4g}{kept}") for row, _ in waiting]
    if best is None:
        failure = f"no lead-in to any of the {len(done)} first configurations of the path that were tried; the first: {failure}"
    return EntryChoice(entry=best, candidates=(*told, *rest), failure="" if best is not None else failure)


def _order(row: GoalCandidate) -> tuple[float, int]:
    """What makes a first configuration the next one to be tried: the largest bound, to rounding, then the fewest crossings."""
    return float(f"{row.bound:.6g}"), -(row.least_crossings or 0)


def best_courses(finder: CourseFinder, first: SearchResult) -> Iterator[SearchResult]:
    """The best path of all, then the best of those that begin farther than APART from the beginnings before."""
    yield first
    layers, found = finder.layers, first
    for _ in range(SEARCHES - 1):
        away = np.abs(steps_between(found.q[0], layers.q[0], layers.continuous)).max(axis=1) > APART
        if not away.any():
            return
        begins = (np.ascontiguousarray(layers.q[0][away]), np.ascontiguousarray(layers.m[0][away]))
        layers = replace(layers, q=(begins[0], *layers.q[1:]), m=(begins[1], *layers.m[1:]))
        found = max_min_search(layers, first.epsilon, strict=first.strict, explain=False, throw=False)
        if not found.connected:
            return
        chosen = np.flatnonzero((finder.layers.q[0] == layers.q[0][found.indices[0]]).all(axis=1))[:1]
        yield replace(found, indices=np.concatenate([chosen, found.indices[1:]]))


def _turned(found: SearchResult, start: Array, continuous: NDArray[np.bool_]) -> SearchResult:
    """The same path, whose continuous joints begin less than half a turn from the start (n,)."""
    turns = np.where(continuous, 2 * np.pi * np.round((start - found.q[0]) / (2 * np.pi)), 0.0)
    return replace(found, q=found.q + turns)
