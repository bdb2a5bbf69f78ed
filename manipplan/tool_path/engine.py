"""ToolPathPlanner: the best joint path along a workspace path, searched, refined, and joined between its positions."""

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from manipplan.collision.model import CollisionModel
from manipplan.kinematics.factors import singularity_signs
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import BETWEEN, Tolerance, with_defaults
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.robot import Robot
from manipplan.search.layers import Layers
from manipplan.search.max_min import SearchResult, max_min_search, search_within
from manipplan.search.program import PoseRows, joint_path
from manipplan.search.refine import Refinement, refine
from manipplan.search.sampling import CandidateSampler, sample_layers
from manipplan.search.sweep import full_turns, path_steps
from manipplan.support.checks import Array, ArrayLike
from manipplan.support.deadline import NEVER, Deadline, TimeLimit, work_time
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.support.progress import Progress, silent
from manipplan.support.status import Failure
from manipplan.symbolic.free_motion import BoundedMotion
from manipplan.timing.constant_speed import SpeedDemand, SteadySpeed

#: Share of a tolerance that is used at the positions, and between them before knots are added: timing needs some of it, too.
AT_POSITIONS, IN_TUBE = 0.9, 0.97
#: The latter if no tolerance is given.
AT_KNOTS = 0.5


@dataclass(frozen=True, kw_only=True, eq=False)
class RefinedToolPath:
    """A joint path along a workspace path, over the same s.

    Attributes:
        search: the path found among the candidates.
        refinement: that path, refined.
        path: the spline through its configurations.
        seed: the same for the path that the search found.
        outside: in which intervals between positions (k,) the path does not follow the workspace path.
        touching: in which, or beside which, it touches a body.
        ending: time that timing and checks are likely to take [s].
        robot: the arm.
        demand: constant speed of the tool that is asked for; None: none.
        is_for_speed: whether it was chosen for the speed, beside the one with the largest minimum manipulability.
    """

    search: SearchResult
    refinement: Refinement
    path: JointPath
    seed: JointPath
    outside: NDArray[np.bool_]
    touching: NDArray[np.bool_]
    ending: float
    robot: Robot
    demand: SpeedDemand | None
    is_for_speed: bool

    @property
    def loose(self) -> NDArray[np.int64]:
        """The intervals between positions (k,), by where they begin, in which the path is outside or touches a body."""
        return np.flatnonzero(self.outside | self.touching)

    @property
    def steps_outside(self) -> tuple[NDArray[np.int64], Array]:
        """The intervals (k,) in which the path is outside, and the largest step of a joint in each that the search found."""
        steps = np.abs(path_steps(self.search.q, self.robot.continuous_joints, closed=len(self.outside) == len(self.search.q)))
        return np.flatnonzero(self.outside), steps.max(axis=1)[self.outside]

    @cached_property
    def fastest(self) -> tuple[float, float]:
        """An estimate of the fastest constant speed on it, where one is asked for [m/s], and the s where limits bind."""
        assert self.demand is not None
        return self.demand.fastest(self.path, self.robot)

    @cached_property
    def timed(self) -> tuple[Trajectory, SteadySpeed] | None:
        """The motion nearest to the speed that is asked for; None where none is, or limits are far from allowing it."""
        if self.demand is None or self.demand.is_hopeless(self.fastest[0]):
            return None
        with suppress(PlanningError):  # of other limits, which timing names in the end
            return self.demand.steadiest(self.path, self.robot, lambda: self.fastest[0])
        return None

    @property
    def steady(self) -> tuple[Trajectory, SteadySpeed] | None:
        """The motion with the speed that is asked for; None for none."""
        return self.timed if self.timed is not None and self.timed[1].is_steady else None

    @property
    def slowest_at(self) -> float:
        """The s at which limits make the tool slowest."""
        if self.timed is None:
            return self.fastest[1]
        s = np.linspace(0.0, 1.0, PLACES)
        motion, speed = self.timed
        return float(s[np.linalg.norm(self.path(s) - motion(np.array([speed.slowest_at])), axis=1).argmin()])

    @property
    def keeps_speed(self) -> bool:
        """Whether the tool has the constant speed that is asked for, or none is."""
        return self.demand is None or self.steady is not None

    def rank(self) -> tuple[bool, float]:
        """The better joint path for a tool speed has the larger one: it keeps the speed, or comes nearer to it."""
        return self.keeps_speed, self.refinement.refined if self.keeps_speed else self.fastest[0]


#: Largest step of a joint from one given pose to the next on a calm motion [rad or m], as in CppFlow's rule.
CALM = np.deg2rad(7.0)
#: Share of it that a search may use, as joints move faster between positions than from one to the next.
CALM_SHARE = 0.93
#: What can be done where the tool leaves the path, or bodies touch, between the positions.
MORE_POSITIONS = "Take more positions"
#: By how much steps of a refined path may be longer than those of the path that the search found, a factor of the latter and at
#: least the second [rad or m], where it would jump to another branch of solutions, as where the arm is almost stretched.
JUMPS = 2.0, 0.02
#: Steps in halves of an interval in which a joint path leaves the workspace path, as a share of the step in the whole one.
SHORTER = 0.75
#: How often positions are added where a joint path is loose between them, and number of configurations between them at which
#: that is seen.
CLOSER, BETWEEN_POSITIONS = 5, 12
#: Largest step of a joint between neighbouring samples of an arm with one degree of redundancy [rad or m].
SPACING = 0.05
#: Time for a refinement that may take none [s].
SHORTEST = 1e-3
#: Time that timing and checks of a motion take [s], at least, for each second in which its path is joined, and for regions.
ENDING, ENDING_OF_JOINING, ENDING_OF_REGIONS = 0.3, 25.0, 1.5
#: How many times this time is left for them while a motion is improved, as timing takes longer near singularities.
RESERVED = 1.5
#: Maximum number of configurations at a position from which steps lead to others, and error of these [m, rad].
SEEDS = 50
EXACT = 1e-10
#: Share to which the slowest joints with which the tool can have its speed are found, factor by which they can be slower at
#: most, and number of joint paths tried between those and the ones that are as fast as they may be.
CLOSE, SLOWEST, BETWEEN_PACES = 1.03, 1e6, 2
#: Share of the minimum manipulability of the best joint path at any speed that is enough.
ENOUGH = 0.95
#: Number of places among which the one is found at which the tool is slowest.
PLACES = 2001


@dataclass(frozen=True, kw_only=True, eq=False)
class ToolPathPlanner:
    """The candidates along one workspace path, and how near to it the tool stays.

    Attributes:
        path: the workspace path.
        layers: candidates at its positions, with their sampler.
        tolerance: what was asked for, of which the refinement makes use; None: the default.
        samples: number of grid points of the redundancy, as in `sample_layers`.
        allowed: largest error between the positions, which are met exactly, where no refinement makes use of it; None: see
            `tolerance`.
        halvings: how often the distance between two positions was halved, for each of them; None: never.
        deadline: by which motions are improved, timed and checked.
        check_ending: called with the time [s] that timing and checks of a motion are likely to take, before it is improved.
        has_fixed_positions: whether no positions can be added, since the candidates of these were chosen one by one.
        demand: constant speed of the tool that is asked for; None: none.
    """

    path: CartesianPath
    layers: Layers
    tolerance: Tolerance | None = None
    samples: int | Sequence[int] | None = None
    allowed: Tolerance | None = None
    halvings: NDArray[np.int64] | None = None
    deadline: Deadline = NEVER
    check_ending: Callable[[float], None] = TimeLimit(None, "").check_ending
    has_fixed_positions: bool = False
    demand: SpeedDemand | None = None

    @property
    def _sampler(self) -> CandidateSampler:
        assert self.layers.sampler is not None
        return self.layers.sampler

    @property
    def robot(self) -> Robot:
        """The arm."""
        return self._sampler.spec.robot

    @property
    def has_several_parameters(self) -> bool:
        """Whether a configuration is likely to be no sample, so that samples around it can connect it."""
        return self._sampler.solver.has_several_parameters

    def is_at_start(self, q: Array) -> bool:
        """Whether the tool stands at the first pose at q (n,): near enough for a spline that goes on inside the tolerance."""
        rows = PoseRows(self._sampler.kinematics)
        wide = rows.box(_shares(self.tolerance, AT_POSITIONS**2, AT_KNOTS * AT_POSITIONS))
        return bool((np.abs(rows.errors(q[None], self.path(np.zeros(1)))) <= wide).all())

    def starting_at(self, q: Array) -> "ToolPathPlanner":
        """The same with q (n,) as only candidate at the first position, at the pose that it reaches.

        Where steps from one position to the next lead from it is added to the candidates of the others; not with an inverse
        kinematics of the user, which may leave postures out on purpose.
        """
        assert self.layers.poses is not None
        kinematics, poses = self._sampler.kinematics, self.layers.poses.copy()
        poses[0] = kinematics.pose(q)
        first = replace(
            self.layers,
            q=(np.array(q[None]), *self.layers.q[1:]),
            m=(np.array([float(kinematics.manipulability(q))]), *self.layers.m[1:]),
            poses=poses,
        )
        return replace(self, layers=first)._with_steps_from(0, np.inf, self._sampler.solver.move_to)

    def continued(self, positions: Sequence[int], epsilon: ArrayLike, progress: Progress) -> "ToolPathPlanner":
        """The same with configurations to which steps below epsilon lead from some at these positions, forward and backward.

        They connect positions where samples of several parameters are too far apart.
        """
        planner = self
        for k in positions:
            planner = planner._with_steps_from(k, epsilon, self._sampler.solver.search_from, progress)
        return planner

    def _with_steps_from(
        self,
        position: int,
        epsilon: ArrayLike,
        steps: Callable[[Array, Array, float], tuple[Array, Array]],
        progress: Progress = silent,
    ) -> "ToolPathPlanner":
        """The same with configurations at other positions, to which steps below epsilon lead from some at this one.

        Not with an inverse kinematics of the user, which may leave postures out on purpose.
        """
        layers, solver = self.layers, self._sampler.solver
        assert layers.poses is not None
        if solver.own is not None:
            return self
        q, m = list(layers.q), list(layers.m)
        seeds = q[position][np.unique(np.linspace(0, len(q[position]) - 1, SEEDS).astype(np.int64))]
        found, owners = [seeds[:0]], list[int]()
        for way in (range(position + 1, len(q)), range(position - 1, -1, -1)):
            at = seeds
            for k in way:
                progress(0.0, f"small steps from position {position}")
                moved, miss = steps(at, layers.poses[k], EXACT)
                at = moved[(miss <= EXACT) & (np.abs(moved - at) < epsilon).all(axis=1)]
                if not len(at):
                    break
                found.append(at)
                owners += [k] * len(at)
        more = np.concatenate(found)
        free = self._sampler.free(more)
        more, of = more[free], np.array(owners, dtype=np.int64)[free]
        values = self._sampler.kinematics.manipulability(more)
        for k in np.unique(of):
            q[k], m[k] = np.vstack([q[k], more[of == k]]), np.append(m[k], values[of == k])
        return replace(self, layers=replace(layers, q=tuple(q), m=tuple(m), turn_middles=None))

    def at_speed(self, demand: SpeedDemand | None, slower: float = 1.0) -> "ToolPathPlanner":
        """The same for a constant speed of the tool: only with steps on which no joint is too fast.

        `slower`: factor by which joints are slower than their limits. All steps are allowed where the tool is free to leave the
        path, so that its way is not known.
        """
        pace = None
        if demand is not None and not len(self._sampler.solver.free.shifts):
            pace = demand.joint_pace(self.robot) / slower
        return replace(self, demand=demand, layers=replace(self.layers, joint_pace=pace))

    @property
    def aspects(self) -> tuple[NDArray[np.int64], ...] | None:
        """A number for the signs of the factors of det J at all candidates of each layer; None where J is not square."""
        signs = singularity_signs(self._sampler.kinematics)
        if signs is None:
            return None
        powers = 2 ** np.arange(len(signs.names))
        return tuple((signs.values(q) >= 0) @ powers for q in self.layers.q)

    def with_pose_step(self, step: float | None) -> "ToolPathPlanner":
        """The same with steps on which no joint moves more than this from one given pose to the next [rad or m]; None: any."""
        return replace(self, layers=replace(self.layers, pose_step=step))

    def at_any_pace(self) -> "ToolPathPlanner":
        """The same with all steps, also those on which joints move too fast for a tool speed, or too far."""
        return replace(self, layers=replace(self.layers, joint_pace=None, pose_step=None, longest=None))

    def intervals(self, halvings: int, among: NDArray[np.int64]) -> NDArray[np.int64]:
        """Those of `among` (k,) of the intervals between positions that were halved less often, by where they begin."""
        return among[self._halvings[among] < halvings]

    def pieces(self, halvings: int) -> NDArray[np.int64]:
        """Into how many pieces each interval between positions (k,) can be divided, halved so often in all."""
        return 2 ** np.maximum(halvings - self._halvings, 0)

    @property
    def _halvings(self) -> NDArray[np.int64]:
        if self.halvings is not None:
            return self.halvings
        return np.zeros(len(self.layers.q) - (not self.layers.closed), dtype=np.int64)

    def halved(self, intervals: NDArray[np.int64], progress: Progress) -> "ToolPathPlanner":
        """The same with a position half-way in each of the intervals, which begin at positions `intervals` (k,)."""
        pieces = np.ones_like(self._halvings)
        pieces[intervals] = 2
        return self.divided(pieces, progress)

    def with_shorter_steps(self, intervals: NDArray[np.int64], steps: Array) -> "ToolPathPlanner":
        """The same with shorter steps in intervals (k,) than those of a path found, (k,) [rad or m].

        So that halves of an interval, in which a path found leads from one branch of solutions to another, are not passed so.
        """
        longest = self.layers.longest
        longest = np.full(len(self._halvings), np.inf) if longest is None else longest.copy()
        longest[intervals] = np.minimum(longest[intervals], SHORTER * steps)
        return replace(self, layers=replace(self.layers, longest=longest))

    def divided(self, pieces: NDArray[np.int64], progress: Progress) -> "ToolPathPlanner":
        """The same with each interval between positions divided into a number of equal pieces (k,), powers of 2."""
        assert self.layers.s is not None
        s = np.append(self.layers.s, 1.0)
        between = [np.linspace(s[k], s[k + 1], count + 1)[1:-1] for k, count in enumerate(pieces)]
        return self.with_positions(np.concatenate(between), progress)

    def with_positions(self, s: Array, progress: Progress) -> "ToolPathPlanner":
        """The same with positions at s (k,), ascending, too, which are between those there are."""
        assert self.layers.sampling is not None and self.layers.s is not None
        intervals = np.searchsorted(self.layers.s, s) - 1
        layers = self.layers.sampling.with_positions(self.layers, s, progress)
        added = np.bincount(intervals, minlength=len(self._halvings))
        halvings = self._halvings + np.ceil(np.log2(added + 1)).astype(np.int64)
        halvings = np.insert(halvings, intervals + 1, halvings[intervals])
        return replace(self, layers=layers.inside(self._sampler.spec.robot.limits), halvings=halvings)

    def beside(self, model: CollisionModel, joints: Sequence[int], q: Array, clearance: float) -> "ToolPathPlanner":
        """The same with only the candidates, of `joints` of a robot, that are free where its others are as in q (L, n).

        Raises PlanningError, which names the position, where there is none.
        """
        free_q, free_m = [], []
        for k, (own, values) in enumerate(zip(self.layers.q, self.layers.m, strict=True)):
            whole = np.repeat(q[k : k + 1], len(own), axis=0)
            whole[:, joints] = own
            free = ~model.in_collision_rows(whole, clearance=clearance)
            if not free.any():
                bodies, _ = model.nearest_bodies(whole)
                tool = self._sampler.spec.robot.tool
                wanted = f"at position {k} of {len(q)} every configuration of {tool} is in the way of the other arms"
                raise PlanningError(f"{wanted}: {bodies}")
            free_q.append(np.ascontiguousarray(own[free]))
            free_m.append(values[free])
        return replace(self, layers=replace(self.layers, q=tuple(free_q), m=tuple(free_m)), has_fixed_positions=True)

    def search(
        self, epsilon: ArrayLike, *, strict: bool = True, explain: bool = False, progress: Progress | None = None
    ) -> "tuple[ToolPathPlanner, SearchResult]":
        """The planner and what `max_min_search` finds; with all steps where nothing is found within their bounds."""
        found = max_min_search(self.layers, epsilon, strict=strict, explain=explain, throw=False, progress=progress)
        bounds = self.layers.joint_pace, self.layers.pose_step, self.layers.longest
        if found.connected or all(each is None for each in bounds):
            return self, found
        return self.at_any_pace().search(epsilon, strict=strict, explain=explain)

    def is_calm(self, found: SearchResult) -> bool:
        """Whether no joint moves more than CALM from one given pose of the path to the next, on a path found."""
        s, q, knots = self.layers.s, found.q, self.path.knots
        assert s is not None
        if self.layers.closed:
            s, q = np.append(s, 1.0), np.vstack([q, q[0] + full_turns(q, self.layers.continuous)])
        at_poses = np.column_stack([np.interp(knots, s, each) for each in q.T])
        return bool(np.abs(np.diff(at_poses, axis=0)).max() <= CALM)

    def reaches(self, share: float, epsilon: ArrayLike, start: Array | None = None) -> bool:
        """Whether the best motion, from a start (n,) at the first pose, reaches a share of the bound on all minima."""
        planner = self if start is None else self.starting_at(start)
        found = max_min_search(planner.layers, epsilon, prefer="first", explain=False, throw=False)
        return found.connected and found.minimum >= share * found.bound

    def best(
        self, epsilon: ArrayLike, *, hold_start: bool = False, explain: bool = True, progress: Progress = silent
    ) -> RefinedToolPath | Failure:
        """The joint path with the largest minimum manipulability, or why there is none; see `max_min_search` and `along`."""
        planner, found = self.search(epsilon, explain=explain, progress=progress)
        if not found.connected:
            return Failure(message=found.message)
        return planner.closely_along(found, progress, hold_start=hold_start)

    def best_from(self, q: Array, epsilon: ArrayLike, progress: Progress = silent) -> JointPath | Failure:
        """The same from q (n,), inside the limits also between the positions."""
        found = self.starting_at(q).best(epsilon, hold_start=True, explain=False, progress=progress)
        if isinstance(found, Failure):
            return found
        outside = outside_limits(found.path, self.robot)
        return Failure(message=outside) if outside else found.path

    def between(self, first: int, last: int) -> "ToolPathPlanner":
        """The same for the part of the path from one position to another, which may be beyond the last one of a closed path."""
        layers = self.layers
        assert layers.s is not None and layers.poses is not None
        turned = np.arange(first, last + 1)
        k, s = turned % len(layers.q), layers.s[turned % len(layers.q)] + turned // len(layers.q)
        begin, end = float(s[0]), float(s[-1])
        path = self.path.part(begin, end)
        some = replace(
            layers,
            sampling=None if layers.sampling is None else replace(layers.sampling, path=path),
            q=tuple(layers.q[i] for i in k),
            m=tuple(layers.m[i] for i in k),
            closed=False,
            s=np.concatenate([[0.0], (s[1:-1] - begin) / (end - begin), [1.0]]),
            poses=layers.poses[k],
            longest=None if layers.longest is None else layers.longest[k[:-1]],
        )
        return replace(self, path=path, layers=some, halvings=self._halvings[k[:-1]])

    def along(self, found: SearchResult, progress: Progress, *, hold_start: bool = False) -> RefinedToolPath:
        """The joint path through the positions of a path that the search found; `hold_start` keeps its first configuration.

        Joints are faster between positions than from one to the next, and accelerate. So where the tool does not keep the speed
        that is asked for, others are searched on which the joints are slower: first the slowest with which anything connects,
        then, where that keeps the speed, ones between for a larger minimum manipulability. Where none keeps it the fastest one
        is returned.
        """
        made = best = self._along(found, progress, hold_start=hold_start)
        demand, first, begin = self.demand, found.indices[:1], found.q[0]
        pace, layers = None if demand is None else self.at_speed(demand).layers.joint_pace, self.layers
        if demand is None or pace is None or made.keeps_speed:
            return made
        aspects = self.aspects
        if aspects is not None and len({int(each[k]) for each, k in zip(aspects, found.indices, strict=True)}) > 1:
            aspects = None
        if hold_start:
            layers = replace(layers, q=(layers.q[0][first], *layers.q[1:]), m=(layers.m[0][first], *layers.m[1:]))
            aspects = None if aspects is None else (aspects[0][first], *aspects[1:])

        def search(slower: float, prefer: Literal["shortest", "first"] = "shortest") -> SearchResult:
            slow = replace(layers, joint_pace=pace / slower)
            return search_within(slow, aspects, found.epsilon, prefer=prefer, strict=found.strict)

        low, high = 0.0, _largest(lambda slower: search(slower, "first").connected)
        for k in range(1 + BETWEEN_PACES):
            slower = high if not k else float(np.sqrt(low * high))
            enough = not best.keeps_speed or best.refinement.refined > ENOUGH * made.refinement.refined
            if self.deadline.left < made.ending or (k and enough) or high < CLOSE * low:
                break
            again = search(slower)
            if not again.connected:  # closed paths are searched for anything that connects by another rule
                break
            if hold_start:
                again = replace(again, q=again.q + 2 * np.pi * np.round((begin - again.q[0]) / (2 * np.pi)))
            other = self._along(again, progress, hold_start=hold_start, layers=replace(layers, joint_pace=pace / slower))
            low, high = (max(low, min(1.0, high)), slower) if other.keeps_speed else (slower, high)
            best = max(best, other, key=RefinedToolPath.rank)
        return best

    def _along(
        self, found: SearchResult, progress: Progress, *, hold_start: bool = False, layers: Layers | None = None
    ) -> RefinedToolPath:
        """The same for the path that the search found alone; `layers` of the search."""
        inner = self.tolerance.scaled(AT_POSITIONS) if self.tolerance is not None else None
        seed, seed_is_inside, ending = self._seed_of(found, hold_start=hold_start)
        self.check_ending(ending)
        layers, is_for_speed = layers or self.layers, layers is not None
        for bounded in (layers, replace(layers, longest=self._without_jumps(found))):
            limit = None if np.isinf(self.deadline.at) else max(self.deadline.left - RESERVED * ending, SHORTEST)
            refined = refine(bounded, found, tolerance=inner, hold_start=hold_start, time_limit=limit, progress=progress)
            path, is_inside = self._joined(refined.q, self.tolerance, hold_start=hold_start)
            if not (seed_is_inside & ~is_inside).any():
                break
        return RefinedToolPath(
            search=found,
            refinement=refined,
            path=path,
            seed=seed,
            touching=self._touching(path),
            outside=~is_inside,
            ending=ending,
            robot=self.robot,
            demand=self.demand,
            is_for_speed=is_for_speed,
        )

    def _without_jumps(self, found: SearchResult) -> Array:
        """Bounds on the steps (k,) of a refined path that stays on the branches of a path found."""
        factor, least = JUMPS
        steps = np.abs(path_steps(found.q, self.layers.continuous, closed=self.layers.closed)).max(axis=1)
        return np.asarray(np.maximum(factor * steps, least))

    def _seed_of(self, found: SearchResult, *, hold_start: bool) -> tuple[JointPath, NDArray[np.bool_], float]:
        """The joint path through the candidates of a path found, and in which intervals it follows the workspace path.

        Also returns the time that timing and checks are likely to take [s]. Pieces of intervals in which it does not follow do
        not count for that: there are many, until positions between make them few.
        """
        began = work_time()
        seed, is_inside = self._joined(found.q, None, hold_start=hold_start)
        joining = work_time() - began
        assert self.layers.s is not None
        of_pieces = np.searchsorted(self.layers.s, (seed.breaks[:-1] + seed.breaks[1:]) / 2) - 1
        ending = ENDING + ENDING_OF_JOINING * joining * float(is_inside[of_pieces].mean())
        if isinstance(self._sampler.kinematics.free_motion, BoundedMotion):
            ending += ENDING_OF_REGIONS
        return seed, is_inside, ending

    def improving_until(self, found: SearchResult) -> Deadline:
        """The time by which a path that was found has to be timed and checked to end by the deadline."""
        if np.isinf(self.deadline.at):
            return NEVER
        *_, ending = self._seed_of(found, hold_start=False)
        return Deadline(at=self.deadline.at - RESERVED * ending)

    def closely_along(self, found: SearchResult, progress: Progress, *, hold_start: bool = False) -> RefinedToolPath:
        """The same with more positions where it is loose between those there are, from the same first configuration."""
        made, layers = self.along(found, progress, hold_start=hold_start), self.layers
        begin, first = made.search.q[0], made.search.indices[:1]
        alone = replace(layers, q=(layers.q[0][first], *layers.q[1:]), m=(layers.m[0][first], *layers.m[1:]))
        planner = replace(self, layers=alone)
        for k in range(CLOSER):
            if not len(made.loose) or self.has_fixed_positions or self.deadline.left < made.ending:
                break
            if k:
                planner = planner.with_shorter_steps(*made.steps_outside)
            try:
                planner = planner.halved(made.loose, silent)
            except InvalidInputError:  # no configuration keeps what candidates have to spare there
                break
            planner, found = planner.search(found.epsilon, strict=found.strict)
            if not found.connected:
                break
            found = replace(found, q=found.q + 2 * np.pi * np.round((begin - found.q[0]) / (2 * np.pi)))
            made = planner.along(found, progress, hold_start=hold_start)
        return made

    def _touching(self, path: JointPath) -> NDArray[np.bool_]:
        """In which intervals between positions, or beside which, a joint path comes too near to a body."""
        sampler, s = self._sampler, self.layers.s
        assert s is not None
        ends = np.append(s, 1.0) if self.layers.closed else s
        if sampler.collision is None:
            return np.zeros(len(ends) - 1, dtype=np.bool_)
        between = ends[:-1, None] + np.diff(ends)[:, None] * (np.arange(BETWEEN_POSITIONS) + 0.5) / BETWEEN_POSITIONS
        clearance = sampler.spec.clearance - sampler.spec.spare / 2
        touches = np.asarray(sampler.collision.in_collision_rows(path(between.ravel()), clearance=clearance))
        touched = np.asarray(touches.reshape(between.shape).any(axis=1))
        beside = np.roll(touched, 1) | np.roll(touched, -1)
        if not self.layers.closed:
            beside[0], beside[-1] = touched[:2].any(), touched[-2:].any()
        return np.asarray(touched | beside)

    def in_the_way(self, found: SearchResult) -> str:
        """Where no path was found: the bodies that are in the way, if there is a path without them, for a message."""
        sampler = self._sampler
        assert self.layers.s is not None
        if sampler.collision is None:
            return ""
        spec = sampler.spec
        through = sample_layers(
            spec.robot,
            self.path,
            self.layers.s,
            task=spec.task,
            measure=spec.measure,
            samples=self.samples,
            collisions=False,
            closed=self.layers.closed,
            spacing=None if self.layers.sampling is None else self.layers.sampling.spacing,
            seed=spec.seed,
        )
        if len(self.layers.q[0]) == 1:
            through = replace(self, layers=through).starting_at(self.layers.q[0][0]).layers
        free = max_min_search(through, found.epsilon, strict=found.strict, explain=False, throw=False)
        if not free.connected:
            return ""
        needed = f", and {1e3 * spec.clearance:.4g} mm are needed" if spec.clearance else ""
        return f"; without bodies in the way there is a motion, on which {nearest_pair(sampler.collision, free.q)}{needed}"

    def _joined(self, q: Array, tolerance: Tolerance | None, *, hold_start: bool) -> tuple[JointPath, NDArray[np.bool_]]:
        """The joint path through q (L, n), and in which intervals it follows the workspace path.

        With a tolerance they are joined as they are while their spline stays inside it.
        """
        layers = self.layers
        assert layers.s is not None
        rows, s = PoseRows(self._sampler.kinematics), layers.s
        allowed = rows.box(self.allowed or _shares(tolerance, IN_TUBE, AT_KNOTS))
        tube = None
        if tolerance is not None:
            tube = tolerance.scaled(AT_POSITIONS / np.sqrt(3))  # inside the box of the rows
        if layers.closed:
            s, q = np.append(s, 1.0), np.vstack([q, q[0] + full_turns(q, layers.continuous)])  # the way back to the start
        return joint_path(
            self._sampler.solver,
            rows,
            self.path,
            s,
            q,
            closed=layers.closed,
            allowed=allowed,
            most=allowed if self.allowed is not None or tolerance is not None else rows.box(BETWEEN.scaled(IN_TUBE)),
            tube=tube,
            hold_start=hold_start,
        )


def _shares(tolerance: Tolerance | None, given: float, default: float) -> Tolerance:
    """A share of the parts of a tolerance that are given, and another one of the default for others."""
    return with_defaults(None if tolerance is None else tolerance.scaled(given), BETWEEN.scaled(default))


def _largest(connects: Callable[[float], bool]) -> float:
    """The largest factor at which anything connects, to a share, by bisection."""
    low, high = (1.0, np.inf) if connects(1.0) else (0.0, 1.0)
    while high > CLOSE * low and high > 1 / SLOWEST and low < SLOWEST:
        factor = 2 * low if np.isinf(high) else high / 2 if not low else float(np.sqrt(low * high))
        low, high = (factor, high) if connects(factor) else (low, factor)
    return low or high


def outside_limits(path: JointPath, robot: Robot) -> str:
    """Which joint of a path leaves its limits between the positions that were searched; "" where none does."""
    outside = robot.limits.outside(np.array(path.bounds())).max(axis=0)
    joint = int(outside.argmax())
    return f"{robot.joint_names[joint]} is {outside[joint]:.2g} outside its limits" if outside[joint] > 0 else ""


def nearest_pair(model: CollisionModel, q: Array) -> str:
    """The nearest two bodies at configurations (k, n) along a path, and at which share of it."""
    bodies, row = model.nearest_bodies(q)
    return f"{bodies} at {row / max(len(q) - 1, 1):.2f} of the path"
