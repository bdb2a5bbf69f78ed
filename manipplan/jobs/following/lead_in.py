"""The lead-in: the free motion from the start to the path, and the choice of the configuration in which the path begins."""

from dataclasses import dataclass, replace
from itertools import islice

import numpy as np

from manipplan.cost.integral import PathIntegral
from manipplan.jobs.following.course import RefinedToolPath, ToolPathPlanner
from manipplan.jobs.following.first_configurations import GAIN, FirstConfigurations
from manipplan.jobs.following.transit import PlanTransit, Transit
from manipplan.jobs.goals.candidates import GoalCandidate, measured
from manipplan.search.max_min import SearchResult
from manipplan.support.checks import Array
from manipplan.support.deadline import work_time
from manipplan.support.progress import Progress, part

#: Maximum number of motions that are planned, of first configurations to which a lead-in is tried, and of those listed.
MOTIONS, TRIES, LISTED = 4, 8, 16
#: Time for all lead-ins [s], and share of what is left that one gets.
SECONDS, SHARE = 10.0, 0.75


@dataclass(frozen=True, kw_only=True, eq=False)
class Entry:
    """A way into the path: the lead-in, the course along the path, and the minimum manipulability of both."""

    lead_in: Transit
    course: RefinedToolPath
    minimum: float


@dataclass(frozen=True, kw_only=True, eq=False)
class EntryChoice:
    """The entry that was chosen, None where none was found, all first configurations, and why there is no entry."""

    entry: Entry | None
    candidates: tuple[GoalCandidate, ...]
    failure: str = ""


def choose_entry(
    finder: ToolPathPlanner,
    first: SearchResult,
    start: Array,
    integral: PathIntegral,
    plan_transit: PlanTransit,
    tell: Progress,
) -> EntryChoice:
    """The entry with the largest minimum manipulability of lead-in and course together.

    What the start and the best path from a first configuration allow bounds this minimum; it is 0 in another aspect than the
    start. Configurations in the aspect of the start come first, those with the largest minimum on the straight line and the
    path before others, the nearer one of two that are nearly equal; others follow while their bounds are above what was
    reached.

    Args:
        finder: of courses through the layers.
        first: the best path of all through them.
        start: (n,).
        integral: of the g and the manipulability that count.
        plan_transit: plans lead-ins.
        tell: called with the share done.
    """
    configurations = FirstConfigurations(finder=finder, best=first, cap=float(integral.kinematics.manipulability(start)))
    waiting = list(islice(configurations.ranked(start, integral), LISTED))
    if finder.layers.closed and int(first.indices[0]) not in {index for _, index in waiting}:
        (row,) = measured(first.q[:1], [0], start, integral)  # others may have no motion that returns to them
        waiting.append((replace(row, bound=min(row.bound, first.minimum)), int(first.indices[0])))
    done: list[GoalCandidate] = []
    best: Entry | None = None
    failure, tried, planned, seconds = "", 0, 0, SECONDS
    while waiting and tried < TRIES and planned < MOTIONS and (seconds > 0 or best is None):
        if best is not None:
            better = [each for each in waiting if each[0].bound > best.minimum * (1 + GAIN)]
            if not better:
                break
        row, index = waiting[0] if best is None else better[0]
        waiting = [each for each in waiting if each[1] != index]
        found = configurations.motion(index)
        if not found.connected and index == first.indices[0]:
            found = first
        if not found.connected:  # a closed path, on which nothing returns to this configuration
            done.append(replace(row, status="left out: no motion along the path returns to it"))
            continue
        left = 0.5**tried  # of the share of the work
        tried += 1
        course = finder.along(_turned(found, row.q), part(tell, 1 - left, 1 - 0.7 * left))
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
    if best is None:
        failure = f"no lead-in to any of the {tried} first configurations of the path that were tried; the first: {failure}"
    rows = [*done, *(row for row, _ in waiting)]
    same = any(not each.least_crossings for each in rows)
    told = [_tried(each, same) if k < len(done) else _left_out(each, best) for k, each in enumerate(rows)]
    return EntryChoice(entry=best, candidates=tuple(told), failure="" if best is not None else failure)


def _tried(row: GoalCandidate, same: bool) -> GoalCandidate:
    """A candidate that was tried; `same`: whether there was one in the aspect of the start."""
    if not row.chosen:
        return row
    aspect = ""
    if row.least_crossings:
        why = "no lead-in was found to one in the same" if same else "no motion along the path begins in the same"
        aspect = f"; in another aspect than the start, since {why}"
    return replace(row, status=f"chosen, {row.status}{aspect}")


def _left_out(row: GoalCandidate, best: Entry | None) -> GoalCandidate:
    """A candidate that was not tried."""
    if best is not None and row.least_crossings and best.minimum > 0:
        return replace(row, status="left out: in another aspect than the start")
    kept = "" if best is None else f"; the motion keeps {best.minimum:.4g}"
    return replace(row, status=f"left out: bound {row.bound:.4g}{kept}")


def _turned(found: SearchResult, q: Array) -> SearchResult:
    """The same path by full turns of continuous joints, from q (n,)."""
    return replace(found, q=found.q + 2 * np.pi * np.round((q - found.q[0]) / (2 * np.pi)))
