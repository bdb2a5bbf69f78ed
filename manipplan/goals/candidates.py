"""Configurations that reach a goal, what is known about motions to them before any is planned, and the choice among them."""

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from manipplan.collision.model import CollisionModel
from manipplan.constraints.constraint import ROW_TOLERANCE
from manipplan.constraints.constraint_set import ConstraintSet
from manipplan.cost.crossings import least_crossings_to
from manipplan.cost.integral import PathIntegral, speeds
from manipplan.goals.goal import PoseGoal, Target
from manipplan.goals.solutions import NearestToGoal, Reaching, beyond_limits, nearest, reaching, refined
from manipplan.goals.two_arms import reaching_tools
from manipplan.ik.form import closed_form
from manipplan.ik.newton import millimetres_hint
from manipplan.optimize.result import PathResult
from manipplan.robots.arms import has_few_joints
from manipplan.robots.limits import nearest_turns
from manipplan.robots.robot import Robot
from manipplan.support.checks import COINCIDENT, Array, read_only
from manipplan.support.deadline import NEVER, Deadline
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError, OutOfReachError
from manipplan.support.progress import Progress, part
from manipplan.support.status import Failure

#: Number of places of a straight line at which m is evaluated.
LINE_SAMPLES = 17


@dataclass(frozen=True, kw_only=True, eq=False)
class StraightLines:
    """Straight lines from one configuration to k others.

    Attributes:
        m, g: (k, LINE_SAMPLES) the measure on each, and (k,) of each, estimated.
        crossings: lower bound on the singularities that any path between its ends crosses; None for redundant arms.
        bound: (k,) upper bound on the minimum m of any path between its ends: the smaller m of both; 0 in another aspect.
    """

    m: Array
    g: Array
    crossings: list[int] | list[None]
    bound: Array


def straight_lines(start: Array, ends: Array, integral: PathIntegral) -> StraightLines:
    """The straight lines from start (n,) to ends (k, n)."""
    kinematics = integral.kinematics
    m = kinematics.manipulability(start + (ends[:, None] - start) * np.linspace(0.0, 1.0, LINE_SAMPLES)[:, None])
    with np.errstate(divide="ignore"):
        weights = 1.0 / np.hypot(m, integral.floor) ** integral.power
    g = speeds(ends - start, integral.metric) * (weights[:, 1:] + weights[:, :-1]).mean(axis=1) / 2
    crossings = least_crossings_to(kinematics, start, ends)
    bound = np.where([bool(each) for each in crossings], 0.0, np.minimum(m[:, 0], m[:, -1]))
    return StraightLines(m=m, g=g, crossings=crossings, bound=bound)


#: Two minima of m count as equal when they differ by less than this share; then g decides.
TIE = 1e-6
#: Number of the best solutions whose redundancy parameters are refined, and distance between them [rad or m].
REFINED, APART = 6, 0.5
#: Distance beyond the clearance that refined solutions keep, so that they are not pushed into contact [m].
MARGIN = 1e-3
#: What candidates say for which nothing else is known.
LEFT_OUT = "left out: its bound is too low"
#: Number of pairs of bodies and of goals that an error names.
NAMED = 3


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class GoalCandidate:
    """A configuration that reaches a goal, or would.

    Attributes:
        goal_index: index of the goal in the list, 0 for a single goal.
        q: (n,) [rad or m]; for a pose out of reach the nearest configuration found.
        manipulability: m at q; nan where the candidate cannot be used.
        bound: upper bound on the minimum manipulability of any motion to q: the smaller m of start and q; 0 in another aspect.
        straight_length: length of the straight line from the start [rad or m].
        straight_g, straight_min_manipulability: g and smallest m on it, estimated.
        least_crossings: lower bound on the singularities that any path to q crosses; None for redundant arms.
        min_manipulability, g: of the path that was planned; nan where none was.
        chosen: whether the motion goes to q.
        status: what was done with the candidate, or why it was left out.
    """

    goal_index: int
    q: Array
    manipulability: float = np.nan
    bound: float = np.nan
    straight_length: float = np.nan
    straight_g: float = np.nan
    straight_min_manipulability: float = np.nan
    least_crossings: int | None = None
    min_manipulability: float = np.nan
    g: float = np.nan
    chosen: bool = False
    status: str = LEFT_OUT

    @property
    def is_free(self) -> bool:
        """Whether the configuration is inside the limits, collision-free and reaches the goal."""
        return not np.isnan(self.manipulability)

    def __str__(self) -> str:
        return f"goal {self.goal_index}: {self.status}: {np.round(self.q, 4).tolist()}"


def find_candidates(
    targets: Sequence[Target],
    start: Array,
    model: CollisionModel,
    integral: PathIntegral,
    clearance: float,
    constraints: ConstraintSet,
    deadline: Deadline = NEVER,
) -> list[GoalCandidate]:
    """All candidates of the goals: the free ones first, the best first, then those that cannot be used, with the reason.

    With held joints, poses are reached by steps of the other joints from `start` and from random configurations. Raises
    InvalidInputError where no candidate is free; the message counts the reasons. It is an OutOfReachError where no goal is
    reached at all, and OutOfTimeError after the deadline.
    """
    robot = model.robot
    targets = [each.of_tool(robot) for each in targets]
    given = {k: each.q for k, each in enumerate(targets) if each.q is not None}
    poses = {k: each.pose for k, each in enumerate(targets) if each.pose is not None}
    several = {k: each.tools for k, each in enumerate(targets) if each.tools is not None}
    rejected: list[GoalCandidate] = []
    missed: list[NearestToGoal] = []
    rows, goals = [], []
    for k, q in given.items():
        outside = robot.limits.outside(q)
        if (outside > 0).any():
            rejected.append(_outside(k, q, robot))
        else:
            rows.append(q)
            goals.append(k)
    held = constraints.held
    few = has_few_joints(robot)  # too few to reach every pose: samples of what is free about a goal are out of reach
    exact = {k: pose for k, pose in poses.items() if not few or (pose.axis is None and pose.tolerance is None)}
    solved = {} if held.any() else exact
    found = reaching(robot, solved, start)
    rejected += [_outside(k, q, robot) for k, q in beyond_limits(robot, solved)]
    far = [k for k in poses if not (found.goals == k).any()]
    thorough = not len(found.q) or closed_form(robot) is None  # a closed form misses hardly any in reach
    steps = nearest(robot, [poses[k] for k in far], start, held, thorough=thorough, deadline=deadline)
    for k, near in zip(far, steps, strict=True):
        if robot.own_ik is not None and k in solved:  # steps may reach what the user's solver leaves out on purpose
            status = f"left out: {robot.own_ik.name} returns no configuration inside the limits"
            rejected.append(GoalCandidate(goal_index=k, q=near.q, status=status))
            continue
        rows += list(nearest_turns(robot, near.reaching, start))
        goals += [k] * len(near.reaching)
        if not len(near.reaching):
            missed.append(near)
            rejected.append(GoalCandidate(goal_index=k, q=near.q, status=f"left out: {near}"))
    for k, tools in several.items():
        joined = reaching_tools(tools, start, model, integral, clearance, held)
        rows += list(joined.q)
        goals += [k] * len(joined.q)
        rejected += [GoalCandidate(goal_index=k, q=q, status=reason) for q, reason in joined.rejected]
    every = np.concatenate([np.array(rows).reshape(-1, robot.n), found.q])
    index = np.concatenate([np.array(goals, dtype=np.int64), found.goals])
    deadline.check()
    reasons = _reasons(every, start, model, clearance, constraints)
    free = np.array([not reason for reason in reasons], dtype=bool)
    rejected += [
        GoalCandidate(goal_index=int(k), q=q, status=reason)
        for k, q, reason in zip(index[~free], every[~free], np.array(reasons, dtype=object)[~free], strict=True)
    ]
    best = found.rows(np.flatnonzero(free[len(rows) :]))
    q, index = every[free], index[free]
    deadline.check()
    more, of = _refine(best, start, model, integral, clearance, constraints)
    q, index = np.concatenate([q, more]), np.concatenate([index, best.goals[of]])
    if not len(q):
        refusal = _nothing_free(targets, rejected, ", within the constraints" if constraints.constraints else "")
        if missed and len(missed) == len(rejected):
            argument, value, allowed = refusal
            if len(missed) == 1:
                goal = poses[far[0]]
                allowed += millimetres_hint(
                    goal.matrix,
                    missed[0].position,
                    lambda pose: next(iter(nearest(robot, [replace(goal, pose=pose)], start, held))).position,
                )
            raise OutOfReachError(
                argument, value, allowed, min(missed, key=lambda each: np.hypot(each.position, each.rotation))
            )
        raise InvalidInputError(*refusal)
    return [*ordered(rate_candidates(q, index.tolist(), start, integral)), *rejected]


def rate_candidates(q: Array, goals: Sequence[int], start: Array, integral: PathIntegral) -> list[GoalCandidate]:
    """Candidates with all figures, for free configurations (k, n) and the indices of their goals."""
    lines = straight_lines(start, q, integral)
    return [
        GoalCandidate(
            goal_index=goals[k],
            q=read_only(q[k].copy()),
            manipulability=float(lines.m[k, -1]),
            bound=float(lines.bound[k]),
            straight_length=float(np.linalg.norm(q[k] - start)),
            straight_g=float(lines.g[k]),
            straight_min_manipulability=float(lines.m[k].min()),
            least_crossings=lines.crossings[k],
        )
        for k in range(len(q))
    ]


def ordered(free: Sequence[GoalCandidate]) -> list[GoalCandidate]:
    """Free candidates, the best first: fewest crossings, then the largest bound; of equal bounds the smallest g."""
    left = sorted(free, key=lambda each: (each.least_crossings or 0, -each.bound))
    done: list[GoalCandidate] = []
    while left:
        first = left[0]
        count = 0
        while count < len(left) and _ties(first, left[count]):
            count += 1
        done += sorted(left[:count], key=lambda each: each.straight_g)
        left = left[count:]
    return done


def _ties(first: GoalCandidate, other: GoalCandidate) -> bool:
    return (first.least_crossings or 0) == (other.least_crossings or 0) and other.bound >= first.bound * (1 - TIE)


def _outside(goal: int, q: Array, robot: Robot) -> GoalCandidate:
    """The candidate of a configuration (n,) outside the limits."""
    outside = robot.limits.outside(q)
    joint = int(outside.argmax())
    unit = "m" if robot.joint_types[joint] == "prismatic" else "rad"
    reason = f"left out: {robot.joint_names[joint]} is {outside[joint]:.3g} {unit} outside its limits"
    return GoalCandidate(goal_index=goal, q=read_only(q.copy()), status=reason)


def _refine(
    found: Reaching, start: Array, model: CollisionModel, integral: PathIntegral, clearance: float, constraints: ConstraintSet
) -> tuple[Array, NDArray[np.int64]]:
    """Further configurations (k, n) with a larger bound than the best of those found, and the rows they begin at."""
    if not len(found.q):
        return np.zeros((0, model.robot.n)), np.zeros(0, dtype=np.int64)
    kinematics = integral.kinematics
    enough = float(kinematics.manipulability(start[None])[0])

    def figure(q: Array) -> Array:
        rejected = model.in_collision_rows(q, clearance=clearance + MARGIN)
        rejected |= constraints.values(q).min(axis=1, initial=0.0) < 0
        return np.where(rejected, -np.inf, kinematics.manipulability(q))

    m = kinematics.manipulability(found.q)
    if m.max() >= enough:
        return np.zeros((0, model.robot.n)), np.zeros(0, dtype=np.int64)
    best: list[int] = []
    for k in np.argsort(-m, kind="stable"):
        if all(np.abs(found.q[k] - found.q[j]).max() > APART or found.goals[k] != found.goals[j] for j in best):
            best.append(int(k))
        if len(best) == REFINED:
            break
    rows = np.array(best, dtype=np.int64)
    q, of = refined(model.robot, found.rows(rows), start, figure, enough)
    return q, rows[of]


def _reasons(q: Array, start: Array, model: CollisionModel, clearance: float, constraints: ConstraintSet) -> list[str]:
    """Why each configuration (k, n) cannot be used; "" for those that can."""
    reasons = [""] * len(q)
    if not len(q):
        return reasons
    touching = np.flatnonzero(model.in_collision_rows(q, clearance=clearance))
    near = model.near_pairs(q[touching], max(clearance, 1e-9))
    for k in touching:
        reasons[k] = "left out: in collision"
    for row in np.unique(near.rows):
        of_row = np.flatnonzero(near.rows == row)
        worst = of_row[near.distances[of_row].argmin()]
        first, second = model.pair_names[near.pairs[worst]]
        verb = "collides with" if near.distances[worst] <= 0 else f"is {1e3 * near.distances[worst]:.2g} mm from"
        reasons[touching[row]] = f"left out: {first} {verb} {second}"
    for k in np.flatnonzero(constraints.values(q).min(axis=1, initial=0.0) < -ROW_TOLERANCE):
        reasons[k] = f"left out: it breaks {constraints.broken(q[k])}"
    for k in np.flatnonzero(np.abs(q - start)[:, constraints.held].max(axis=1, initial=0.0) > 0):
        moved = constraints.moved(start, q[k])
        reasons[k] = f"left out: {moved}" if moved else reasons[k]
    for k in np.flatnonzero(np.abs(q - start).max(axis=1) < COINCIDENT):
        reasons[k] = "left out: it is the start itself"
    return reasons


def _nothing_free(targets: Sequence[Target], rejected: Sequence[GoalCandidate], also: str) -> tuple[str, object, str]:
    """Argument, value and what is allowed, where no goal can be used."""
    if len(targets) == 1:
        argument, value = targets[0].argument, _describe(targets[0])
    else:
        argument, value = targets[0].argument.partition("[")[0], f"{len(targets)} goals of which none can be used"
    counts = Counter(each.status.removeprefix("left out: ") for each in rejected)
    if len(rejected) == 1:
        reasons = next(iter(counts))
    else:
        named = [f"{count} x {reason}" for reason, count in counts.most_common(NAMED)]
        rest = len(rejected) - sum(count for _, count in counts.most_common(NAMED))
        reasons = f"of {len(rejected)} configurations, " + "; ".join([*named, *([f"{rest} for other reasons"] if rest else [])])
    return argument, value, f"a goal that can be reached inside the limits{also} and collision-free: {reasons}"


def _describe(target: Target) -> object:
    if target.q is not None:
        return target.q.tolist()
    if target.tools is not None:
        return {tool: pose.matrix.tolist() for tool, pose in target.tools.items()}
    assert isinstance(target.pose, PoseGoal)
    return target.pose.matrix.tolist()


#: Maximum number of paths that are planned, and of candidates to which one is tried.
PATHS, TRIES = 4, 8
#: Share of the remaining time that one candidate gets while there are others.
SHARE = 0.75

#: Plans a path to a configuration (n,) within a time [s]: the result, or a Failure with the reason.
Planner = Callable[[Array, float, Progress], PathResult | Failure]


@dataclass(frozen=True, kw_only=True, eq=False)
class GoalChoice:
    """The path that was chosen, None where none was found, and all candidates with what became of them.

    Attributes:
        failures: for each candidate that was tried without success, in their order, why there is no path to it.
    """

    result: PathResult | None
    candidates: tuple[GoalCandidate, ...]
    failures: tuple[str, ...]

    @property
    def goal_index(self) -> int:
        """Index of the goal that the chosen path reaches; 0 where there is none."""
        return next((each.goal_index for each in self.candidates if each.chosen), 0)

    @property
    def failure(self) -> str:
        """Why there is no path."""
        first = self.failures[0] if self.failures else "the time limit ended the search"
        if len(self.candidates) == 1:
            return first
        return f"no path to any of the {len(self.failures)} candidates tried; the first: {first}"


def choose(candidates: Sequence[GoalCandidate], planner: Planner, deadline: Deadline, notify: Progress) -> GoalChoice:
    """The motion of the largest minimum manipulability and, of those that tie, of the smallest g.

    Candidates are tried in their order. After the first path only those are tried whose bound is above its minimum
    manipulability: first the one nearest to it, then the others, at most PATHS paths in all. Each candidate gets SHARE of
    the time that is left, the last one all of it.
    """
    search = _Search(rows=list(candidates), tried=[], paths={}, failures={})
    if len(candidates) == 1:
        search.take(0, planner(candidates[0].q, deadline.left, notify))
        return search.choice()
    while (k := search.following()) is not None and not (search.tried and deadline.passed):
        only = sum(each.is_free for each in candidates) == 1 or len(search.paths) == PATHS - 1
        share = deadline.left * (1.0 if only else SHARE)
        done = len(search.tried) / (len(search.tried) + 1)
        found = planner(candidates[k].q, share, part(notify, done, (2 * done + 1) / 3 if not only else 1.0))
        search.take(k, found)
    return search.choice()


@dataclass(kw_only=True, eq=False)
class _Search:
    """The state of a search: the candidates, those tried, and by the index of a candidate its path, or why it has none."""

    rows: list[GoalCandidate]
    tried: list[int]
    paths: dict[int, PathResult]
    failures: dict[int, str]

    @property
    def best(self) -> int | None:
        """The index of the best candidate with a path."""
        best: int | None = None
        for k, path in self.paths.items():
            if best is None or _is_better(path, self.paths[best]):
                best = k
        return best

    def following(self) -> int | None:
        """The candidate to be tried next; None where none can be better, or enough were tried."""
        if len(self.paths) >= PATHS or len(self.tried) >= TRIES:
            return None
        left = [k for k, each in enumerate(self.rows) if each.is_free and k not in self.tried and self._can_win(each)]
        if not left:
            return None
        best = self.best
        if best is not None and len(self.paths) == 1:
            return min(left, key=lambda k: self.rows[k].straight_length)
        others = [k for k in left if all(self._apart(k, j) for j in self.tried)]
        if best is None:  # the nearby ones may still give a path
            others = others or left
        return others[0] if others else None

    def _can_win(self, candidate: GoalCandidate) -> bool:
        best = self.best
        return best is None or candidate.bound > self.paths[best].min_manipulability * (1 + TIE)

    def _apart(self, first: int, second: int) -> bool:
        a, b = self.rows[first], self.rows[second]
        return a.goal_index != b.goal_index or bool(np.abs(a.q - b.q).max() > APART)

    def take(self, k: int, found: PathResult | Failure) -> None:
        """Take what planning to a candidate gave."""
        self.tried.append(k)
        if isinstance(found, Failure):
            self.failures[k] = found.message
            self.rows[k] = replace(self.rows[k], status=f"left out: no path: {found.message}")
            return
        self.paths[k] = found
        least, g = found.min_manipulability, found.g
        status = f"planned: minimum manipulability {least:.4g}, g {g:.4g}"
        self.rows[k] = replace(self.rows[k], q=found.path.goal, status=status, min_manipulability=least, g=g)

    def choice(self) -> GoalChoice:
        """The best path, and what became of every candidate."""
        best = self.best
        rows = [self._with_outcome(k, best) for k in range(len(self.rows))]
        failures = tuple(self.failures[k] for k in sorted(self.failures))
        return GoalChoice(result=None if best is None else self.paths[best], candidates=tuple(rows), failures=failures)

    def _with_outcome(self, k: int, best: int | None) -> GoalCandidate:
        row = self.rows[k]
        if best is not None and k == best:
            aspect = ""
            if row.least_crossings:
                same = any(each.is_free and not each.least_crossings for each in self.rows)
                why = "no path was found to one in the same" if same else "none in the same is free"
                aspect = f"; in another aspect than the start, since {why}"
            return replace(row, chosen=True, status=f"chosen, {row.status}{aspect}")
        if not row.is_free or k in self.tried:
            return row
        if best is None:
            return replace(row, status="left out: the time or the number of tries was used up")
        minimum = self.paths[best].min_manipulability
        if row.least_crossings and not self.rows[best].least_crossings:
            return replace(row, status="left out: in another aspect than the start")
        if row.bound > minimum * (1 + TIE):
            return replace(row, status=f"left out: bound {row.bound:.4g}, but enough were tried, or it is near one of those")
        return replace(row, status=f"left out: bound {row.bound:.4g} is not above {minimum:.4g}, which the motion keeps")


def _is_better(path: PathResult, other: PathResult) -> bool:
    """Whether a path has the larger minimum manipulability or, where the two tie, the smaller g."""
    least, most = sorted((path.min_manipulability, other.min_manipulability))
    if least >= most * (1 - TIE):
        return path.g < other.g
    return path.min_manipulability > other.min_manipulability
