"""The lead-in: the free motion from the start to the path, and the choice of the configuration in which the path begins.

First configurations: those in which a motion along a path of the tool can begin, with what each of them allows.

With as many joints as task rows the configurations without a singularity between them form an aspect. A motion that stays in
one aspect crosses no singularity, so motions are searched in each aspect alone, and in all together only where none has one.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import islice

import numpy as np
from numpy.typing import NDArray

from manipplan.cost.integral import PathIntegral
from manipplan.goals.candidates import APART, GoalCandidate, rate_candidates, straight_lines
from manipplan.robots.robot import Robot
from manipplan.search.max_min import SearchResult, minimum_from_each, search_within
from manipplan.support.checks import COINCIDENT, Array
from manipplan.support.deadline import Deadline, OutOfTimeError, work_time
from manipplan.support.progress import Progress, part
from manipplan.support.status import Failure
from manipplan.tool_path.engine import RefinedToolPath, ToolPathPlanner
from manipplan.tool_path.transit import PlanTransit, Transit

#: Gain in the minimum manipulability below which another first configuration is not tried, nor taken.
GAIN = 0.01
#: Maximum number of first configurations to which motions are compared.
COMPARED = 20_000
#: Distance of a joint from which configurations are different postures [rad or m].
POSTURE = 1.5
#: Odd numbers by which the joints of configurations are made one number, the same for equal configurations.
KEYS = np.random.default_rng(0).integers(-(2**62), 2**62, size=64) | 1


@dataclass(frozen=True, kw_only=True, eq=False)
class FirstConfigurations:
    """The configurations at the first position of a path, with the best motions along the path that begin in them.

    Attributes:
        planner: of motions along the path.
        best: the best of all these motions.
        cap: a manipulability beyond which more does not count.
    """

    planner: ToolPathPlanner
    best: SearchResult
    cap: float = np.inf

    @cached_property
    def minimum(self) -> Array:
        """Largest minimum manipulability of a motion from each (k,), at most the cap; -inf where there is none.

        For a closed path the way back to the first configuration does not count, so that it is an upper bound.
        """
        return self._found[0]

    @cached_property
    def _found(self) -> tuple[Array, tuple[NDArray[np.int64], ...] | None]:
        """The minima, and the aspects of all candidates of each layer; None where motions do not stay in one."""
        aspects = self.planner.aspects
        if aspects is not None and ((minimum := self._minima(aspects)) > -np.inf).any():
            return minimum, aspects
        return self._minima(None), None

    def _minima(self, labels: tuple[NDArray[np.int64], ...] | None) -> Array:
        strict = self.best.strict
        return minimum_from_each(self.planner.layers, self.best.epsilon, labels=labels, strict=strict, cap=self.cap)

    def motion(self, k: int) -> SearchResult:
        """The best motion along the path from the k-th configuration; not connected where none returns to it."""
        layers, aspects = self.planner.layers, self._found[1]
        index = np.full(1, k)
        first = replace(
            layers, q=(np.ascontiguousarray(layers.q[0][index]), *layers.q[1:]), m=(layers.m[0][index], *layers.m[1:])
        )
        labels = None if aspects is None else (aspects[0][index], *aspects[1:])
        found = search_within(first, labels, self.best.epsilon, strict=self.best.strict)
        return replace(found, indices=np.concatenate([index, found.indices[1:]])) if found.connected else found

    def ranked(self, start: Array, integral: PathIntegral) -> Iterator[tuple[GoalCandidate, int]]:
        """The configurations and their indices, the best for a motion from start (n,) first, each farther than APART from those
        before.

        Those with the fewest crossings of singularities come first, then those on whose straight line and path the minimum is
        largest; of minima that differ by less than GAIN those with the smallest g. Continuous joints are turned to the nearest
        turn.
        """
        layers = self.planner.layers
        some = np.flatnonzero(self.minimum > -np.inf)
        q = layers.q[0][some]
        q = q + np.where(layers.continuous, 2 * np.pi * np.round((start - q) / (2 * np.pi)), 0.0)
        near = _compared(q, start, _steps(self.minimum[some]), integral.kinematics.robot.turns)
        some, q = some[near], q[near]
        lines = straight_lines(start, q, integral)
        crossings = np.array([each or 0 for each in lines.crossings])
        bound = np.minimum(lines.bound, self.minimum[some])
        order = np.lexsort((lines.g, _steps(np.minimum(bound, lines.m.min(axis=1))), crossings))
        while len(order):
            k = order[0]
            (row,) = rate_candidates(q[k : k + 1], [0], start, integral)
            yield replace(row, bound=float(bound[k])), int(some[k])
            order = order[np.abs(q[order] - q[k]).max(axis=1) > APART]

    def different(self, robot: Robot, most: int) -> list[int]:
        """The indices of the best configurations, each farther than APART from others but for full turns.

        Of each posture of the arm there is one first, so that those of the best do not displace all others.
        """
        q, some = self.planner.layers.q[0], np.flatnonzero(self.minimum > -np.inf)
        every = some[_first_of_alike(q[some], robot.turns, -self.minimum[some])]
        every = every[np.argsort(-self.minimum[every], kind="stable")]
        found: list[int] = []
        for apart in (POSTURE, APART):
            order = every
            for k in found:
                order = order[_distance(q[order], q[k], robot.turns) > apart]
            while len(order) and len(found) < most:
                found.append(int(order[0]))
                order = order[_distance(q[order], q[order[0]], robot.turns) > apart]
        return found

    def turned(self, robot: Robot, k: int) -> Array:
        """The k-th configuration and those that differ from it by full turns and allow as much, (t, n)."""
        away = self.planner.layers.q[0] - self.planner.layers.q[0][k]
        turns = np.round(away / (2 * np.pi)) * np.where(robot.turns, 2 * np.pi, 0.0)
        same = (np.abs(away - turns).max(axis=1) < COINCIDENT) & (self.minimum >= self.minimum[k] * (1 - COINCIDENT))
        return np.asarray(self.planner.layers.q[0][same])


def _compared(q: Array, start: Array, steps: Array, turns: NDArray[np.bool_]) -> NDArray[np.int64]:
    """Which of configurations (k, n) are compared: of those alike but for full turns the best, and of these the nearest.

    Each is better the fewer `steps` (k,) its minimum is below the largest one, of equal steps the nearer to the start (n,).
    """
    distance = np.linalg.norm(q - start, axis=1)
    first = _first_of_alike(q, turns, steps, distance)
    if len(first) <= COMPARED:
        return first
    best, near = np.lexsort((distance[first], steps[first])), np.argsort(distance[first], kind="stable")
    return first[np.union1d(best[: COMPARED // 2], near[: COMPARED // 2])]


def _first_of_alike(q: Array, turns: NDArray[np.bool_], *figures: Array) -> NDArray[np.int64]:
    """Of configurations (k, n) that are alike but for full turns the first by figures (k,), those that come first most."""
    alike = np.round(np.where(turns, q % (2 * np.pi), q) / COINCIDENT).astype(np.int64) @ KEYS[: q.shape[1]]
    order = np.lexsort((*figures[::-1], alike))
    return order[np.append(True, np.diff(alike[order]) != 0)] if len(order) else order


def _distance(q: Array, other: Array, turns: NDArray[np.bool_]) -> Array:
    """The largest distance (k,) of a joint of configurations (k, n) from another (n,), but for full turns."""
    away = q - other
    return np.asarray(np.abs(away - np.where(turns, 2 * np.pi * np.round(away / (2 * np.pi)), 0.0)).max(axis=1))


def _steps(minima: Array) -> Array:
    """How many shares of GAIN each of some minima (k,) is below the largest, rounded down."""
    most = minima.max(initial=0.0)
    if most <= 0:
        return np.zeros(len(minima))
    with np.errstate(divide="ignore"):
        return np.asarray(np.floor(np.log(most / np.maximum(minima, 0.0)) / np.log1p(GAIN)))


#: Maximum number of motions that are planned, of first configurations to which a lead-in is tried, and of those listed.
MOTIONS, TRIES, LISTED = 4, 8, 16
#: The second of these where the joint path is chosen for a tool speed, which takes several searches.
STEADY_TRIES = 2
#: Share of the time that is left that one lead-in gets.
SHARE = 0.75
#: Minimum time of one lead-in, where as much is left [s].
LEAST = 0.75


@dataclass(frozen=True, kw_only=True, eq=False)
class Entry:
    """A way into the path: the lead-in, the path along it, and the minimum manipulability of both."""

    lead_in: Transit
    refined: RefinedToolPath
    minimum: float


@dataclass(frozen=True, kw_only=True, eq=False)
class EntryChoice:
    """The entry that was chosen, None where none was found, all first configurations, and why there is no entry."""

    entry: Entry | None
    candidates: tuple[GoalCandidate, ...]
    failure: str = ""


def choose_entry(
    planner: ToolPathPlanner,
    first: SearchResult,
    start: Array,
    integral: PathIntegral,
    plan_transit: PlanTransit,
    seconds: float,
    notify: Progress,
    *,
    enough: float = np.inf,
    steady: Array | None = None,
) -> EntryChoice:
    """The entry with the largest minimum manipulability of lead-in and path together.

    What the start and the best path from a first configuration allow bounds this minimum; it is 0 in another aspect than the
    start. Configurations in the aspect of the start come first, those with the largest minimum on the straight line and the
    path before others, the nearer one of two that are nearly equal; others follow while their bounds are above what was
    reached.

    Args:
        planner: of motions through the layers.
        first: the best path of all through them.
        start: (n,).
        integral: of the g and the manipulability that count.
        plan_transit: plans lead-ins.
        seconds: time limit of all lead-ins together [s].
        notify: called with the share done.
        enough: the minimum manipulability of the motion before, beyond which more does not count.
        steady: (n,) the candidate in which the motion at a tool speed begins, where that is not the best one at any speed; it
            comes first, and few others after it.
    """
    configurations = FirstConfigurations(
        planner=planner, best=first, cap=min(float(integral.kinematics.manipulability(start)), enough)
    )
    waiting = list(islice(configurations.ranked(start, integral), LISTED))
    if planner.layers.closed and int(first.indices[0]) not in {index for _, index in waiting}:
        (row,) = rate_candidates(first.q[:1], [0], start, integral)  # others may have no motion that returns to them
        waiting.append((replace(row, bound=min(row.bound, first.minimum)), int(first.indices[0])))
    if steady is not None:
        k = int(np.abs(planner.layers.q[0] - steady).max(axis=1).argmin())
        (row,) = rate_candidates(planner.layers.q[0][k : k + 1], [0], start, integral)
        others = [each for each in waiting if each[1] != k]
        waiting = [next((each for each in waiting if each[1] == k), (row, k)), *others[: STEADY_TRIES - 1]]
    done: list[GoalCandidate] = []
    best: Entry | None = None
    deadline = planner.deadline
    planner = replace(planner, deadline=Deadline.within(deadline.left / 2))  # the other half is for lead-ins
    failure, tried, planned = "", 0, 0
    while waiting and tried < TRIES and planned < MOTIONS and (not tried or (seconds > 0 and not planner.deadline.passed)):
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
        try:
            refined = planner.closely_along(_turned(found, row.q), part(notify, 1 - left, 1 - 0.7 * left))
        except OutOfTimeError:
            if best is None:
                raise
            break
        if best is not None and best.refined.keeps_speed and not refined.keeps_speed:
            done.append(replace(row, status="left out: the tool does not keep its speed from it"))
            continue
        began = work_time()
        most = min(max(SHARE * seconds, min(LEAST, seconds)), deadline.left - refined.ending)
        lead_in = plan_transit(refined.path.start, most, part(notify, 1 - 0.7 * left, 1 - 0.5 * left))
        seconds -= work_time() - began
        row = replace(row, q=refined.path.start)
        if isinstance(lead_in, Failure):
            failure = failure or lead_in.message
            done.append(replace(row, status=f"left out: no lead-in: {lead_in.message}"))
            continue
        planned += 1
        least = min(lead_in.min_manipulability, integral.cost(refined.path).min_manipulability)
        status = f"planned: minimum manipulability {least:.4g}"
        done.append(replace(row, min_manipulability=least, g=lead_in.g, status=status))
        if best is None or refined.keeps_speed > best.refined.keeps_speed or least > best.minimum * (1 + GAIN):
            done = [replace(each, chosen=False) for each in done]
            done[-1] = replace(done[-1], chosen=True)
            best = Entry(lead_in=lead_in, refined=refined, minimum=least)
    if best is None:
        failure = f"no lead-in to any of the {tried} first configurations of the path that were tried; the first: {failure}"
    rows = [*done, *(row for row, _ in waiting)]
    same = any(not each.least_crossings for each in rows)
    candidates = [_tried(each, same) if k < len(done) else _left_out(each, best) for k, each in enumerate(rows)]
    return EntryChoice(entry=best, candidates=tuple(candidates), failure="" if best is not None else failure)


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
    note = "" if best is None else f"; the motion keeps {best.minimum:.4g}"
    return replace(row, status=f"left out: bound {row.bound:.4g}{note}")


def _turned(found: SearchResult, q: Array) -> SearchResult:
    """The same path by full turns of continuous joints, from q (n,)."""
    return replace(found, q=found.q + 2 * np.pi * np.round((q - found.q[0]) / (2 * np.pi)))
