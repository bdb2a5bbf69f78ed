"""plan: a motion from start to goal."""

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from typing import Literal, overload

import numpy as np

from manipplan.collision.scene import Scene
from manipplan.constraints.constraint import Constraint
from manipplan.constraints.constraint_set import ConstraintSet, check_start
from manipplan.cost.integral import PathCost, PathIntegral
from manipplan.cost.objective import PathObjective
from manipplan.goals.candidates import GoalCandidate, choose, find_candidates, rate_candidates
from manipplan.goals.goal import Goal, Target, read_configuration, read_goals
from manipplan.optimize.optimize import check_options, optimize_from, optimize_path, shift_goals
from manipplan.optimize.result import NoPath, PathResult
from manipplan.paths.basis import MOST_DEGREE, PathShape
from manipplan.paths.joint import JointPath
from manipplan.paths.trajectory import Trajectory
from manipplan.plans.report import PathPart, PlanReport, with_errors
from manipplan.plans.result import PartialPlan, Plan, failed, finish
from manipplan.robots.limits import taken_to_limits
from manipplan.robots.robot import Robot
from manipplan.seeds.seeding import AS_GIVEN, NEAREST, Seeding
from manipplan.support.checks import Array, ArrayLike, flag, instance, number
from manipplan.support.deadline import Deadline
from manipplan.support.errors import InvalidInputError
from manipplan.support.progress import Progress, as_callback, interruptible, part
from manipplan.support.status import Status
from manipplan.support.workers import one_thread
from manipplan.timing.retime import check_timing_limits, retime

#: Degrees that are added where a path of the given degree fails, and number of pieces of the cubic B-spline tried after that.
MORE_DEGREES, SPLINE_PIECES = 3, 8
#: Time kept for timing and checking the motion: share of the time limit, and minimum [s].
RESERVE, LEAST_RESERVE = 0.05, 0.05
#: Shortest time for a path, where hardly any is left [s].
SHORTEST_TIME = 1e-3
#: Duration of a motion that stands still [s].
STANDING = 1e-3


@overload
def plan(
    robot: Robot,
    start: ArrayLike | str,
    goal: Goal,
    scene: Scene | None = ...,
    *,
    constraints: Sequence[Constraint] = ...,
    objective: PathObjective = ...,
    shape: PathShape = ...,
    seeding: Seeding = ...,
    clearance: float = ...,
    torque: bool = ...,
    executor: Executor | None = ...,
    throw: Literal[True] = True,
    progress: Progress | None = ...,
) -> Plan: ...


@overload
def plan(
    robot: Robot,
    start: ArrayLike | str,
    goal: Goal,
    scene: Scene | None = ...,
    *,
    constraints: Sequence[Constraint] = ...,
    objective: PathObjective = ...,
    shape: PathShape = ...,
    seeding: Seeding = ...,
    clearance: float = ...,
    torque: bool = ...,
    executor: Executor | None = ...,
    throw: bool,
    progress: Progress | None = ...,
) -> Plan | PartialPlan: ...


@interruptible()
@one_thread()
def plan(
    robot: Robot,
    start: ArrayLike | str,
    goal: Goal,
    scene: Scene | None = None,
    *,
    constraints: Sequence[Constraint] = (),
    objective: PathObjective = PathObjective(),
    shape: PathShape = PathShape(),
    seeding: Seeding = Seeding(),
    clearance: float = 0.0,
    torque: bool = False,
    executor: Executor | None = None,
    throw: bool = True,
    progress: Progress | None = None,
) -> Plan | PartialPlan:
    """Plan a motion from start to goal: collision-free, far from singularities, timed, and checked when finished.

    A planner finds a first path, and the path optimiser searches for a local optimum of g near it (see `optimize_path`). If no
    path of this `shape` is collision-free with a lower g than the first path, a polynomial of three more degrees is tried, then
    a cubic B-spline of eight pieces, which starts from the fit to the first path. If that fails too, the first path itself is
    timed, and the status says so. A path that is checked but not at its optimum is timed with Status.STOPPED_EARLY;
    where the time limit was the cause, the status says so: OUT_OF_TIME, or SEED_OUT_OF_TIME for the first path.

    A pose is reached by many configurations, and a list holds several goals. All solutions of inverse kinematics inside the
    limits are candidates: at samples of the redundancy parameters, of the angle about a free axis and of the inside of a
    tolerance; of full turns the nearest to the start. Those in collision are left out. No motion to a candidate has a larger
    minimum manipulability than the smaller one of start and candidate, so those with the largest bound are planned first, of
    equal bounds that of the smallest g on the straight line, and no more where no other bound is above what was reached; at
    most four paths. The path of the largest minimum manipulability is timed and, of two that differ by less than a share of
    1e-6, that of the smaller g. With as many joints as task rows a candidate in another aspect than the start is planned only
    if none in the same one is free or has a path. `candidates` of the plan tells what was left out, and why.

    If the arm is at a goal already, the motion stands still, with Status.AT_GOAL.

    The call takes at most `Seeding.time_limit` for each first path, 10 s by default. What is built once per machine, process,
    robot or scene, such as code and collision models, does not count. The candidates share the time. What was found by then is
    timed.

    Args:
        robot: the arm.
        start: (n,) inside the limits and collision-free [rad or m], or the name of one of `robot.states`. Outside a limit by at
            most `robot.limit_tolerance`, it is taken to the limit, as the report says; so is a goal.
        goal: as `start`; or a pose of the tool in the world, (4, 4) or pin.SE3; or a `PoseGoal`, with a free axis or a
            tolerance; or, for a robot with several tools, a mapping from tools to these two, where the arm of a tool that is
            not named ends where it began; or a list of these, such as a set of grasps.
        scene: obstacles; None: none. The arm is always checked against itself.
        constraints: what every configuration of the motion keeps: `TiltLimit` for a level tool, `PositionBox`, `HeldJoints`, or
            a `Constraint` of your own. Start and goal have to keep them, too; of a pose or a list, candidates that do not are
            left out. Those of the first three classes are proven on the whole motion.
        objective: power, task, measure, metric and floor of g = ∫ ‖q'‖_W / (m² + floor²)^(power/2) ds.
        shape: degree, basis, pieces and end derivatives of the path.
        seeding: how first paths are found, or a given one, for a goal that is one configuration.
        clearance: distance [m] to keep from obstacles and between the arm's own links.
        torque: keep the joints' effort limits as well.
        executor: runs first paths and solves in parallel. Default: one after the other, in this process.
        throw: raise PlanningError if no trajectory is found; False: return a PartialPlan, or a Plan with Status.CHECK_FAILED.
        progress: called with the fraction done in [0, 1] and a text.

    Raises:
        InvalidInputError: an argument is invalid (also with throw=False): of a list, the message names the entry. No goal can
            be reached inside the limits and collision-free: the message says how far a pose is out of reach, or what collides.
        UnknownNameError: no state has that name; the nearest names are listed.
        PlanningError: no collision-free path, or no motion within the limits; its `result` is the Plan so far.
    """
    flag("torque", torque)
    flag("throw", throw)
    notify = as_callback(progress)
    found = find_path(
        robot,
        start,
        goal,
        scene,
        constraints=constraints,
        objective=objective,
        shape=shape,
        seeding=seeding,
        clearance=clearance,
        executor=executor,
        progress=notify,
    )
    draft, path, reached = found.draft, found.draft.path, found.reached
    if path is None or reached is None:
        return failed(draft, throw, draft.message)

    def time() -> tuple[Trajectory, tuple[PathPart, ...]]:
        stands = draft.status is Status.AT_GOAL
        return _stay(path.start, robot) if stands else retime(path, robot, torque=torque), ()

    def compare_with_goal(report: PlanReport, trajectory: Trajectory) -> PlanReport:
        q = trajectory.q[-1]
        missed = reached.missed_by(robot, q)
        faults = (*report.faults, missed) if missed else report.faults
        errors = {tool: goal.errors(robot, q, tool) for tool, goal in (reached.tools or {}).items()}
        return replace(report, tools=with_errors(report.tools, errors, "goal"), faults=faults)

    return finish(
        draft,
        time,
        taken=(*taken_to_limits(robot, "start", read_configuration("start", start, robot)), *reached.taken),
        clearance=clearance,
        torque=torque,
        throw=throw,
        notify=notify,
        begins=0.8,
        amend=compare_with_goal,
    )


@dataclass(frozen=True, kw_only=True, eq=False)
class FoundPath:
    """A path from start to goal, and what it reaches.

    Attributes:
        draft: the plan so far, with path and result, or with the message why there is none.
        reached: the goal that the path ends at; None without a path.
    """

    draft: PartialPlan
    reached: Target | None = None


@one_thread()
def find_path(
    robot: Robot,
    start: ArrayLike | str,
    goal: Goal,
    scene: Scene | None = None,
    *,
    constraints: Sequence[Constraint],
    objective: PathObjective,
    shape: PathShape,
    seeding: Seeding,
    clearance: float,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> FoundPath:
    """The path that `plan` times. Raises what `plan` raises for invalid arguments."""
    instance("robot", robot, Robot)
    check_options(objective, shape, seeding)
    limit = seeding.time_limit
    reserve = max(RESERVE * limit, min(LEAST_RESERVE, limit / 2))
    deadline = Deadline.within((limit - reserve) * seeding.count)
    scene = instance("scene", scene if scene is not None else Scene(), Scene)
    notify = as_callback(progress)
    targets, is_list = read_goals("goal", goal, robot)
    q_start = robot.configuration("start", read_configuration("start", start, robot))
    if seeding.shifts != AS_GIVEN:
        targets = tuple(replace(each, turns=True) for each in targets)
    if seeding.shifts == NEAREST:
        targets = tuple(each.nearest(robot, q_start) for each in targets)
    constraint_set = ConstraintSet.of(robot, constraints)
    check_start(constraint_set, q_start)
    check_timing_limits(robot.limits)
    draft = PartialPlan(robot=robot, scene=scene, status=Status.NO_PATH, constraints=constraint_set.constraints)

    def path_to(q: Array, seconds: float, notify: Progress) -> PathResult | NoPath:
        """The path to a configuration, which may be singular, within a time for all its first paths [s]."""
        shifts = seeding.shifts if all(each.q is not None for each in targets) else AS_GIVEN
        paths = len(shift_goals(robot, q_start, q, shifts)) * seeding.count
        found = optimize_path(
            robot,
            q_start,
            q,
            scene,
            constraints=constraint_set.constraints,
            objective=objective,
            shape=shape,
            seeding=replace(seeding, shifts=shifts, time_limit=max(seconds / max(paths, 1), SHORTEST_TIME)),
            clearance=clearance,
            executor=executor,
            throw=False,
            progress=notify,
        )
        if found.status is Status.INTERRUPTED:
            raise KeyboardInterrupt
        return found

    integral = objective.integral(robot)
    there = next((k for k, each in enumerate(targets) if not each.of_tool(robot).missed_by(robot, q_start)), None)
    if there is not None and not shape.has_slopes:
        scene.collision_model(robot).free_configuration("start", q_start, number("clearance", clearance, least=0.0))
        at_goal = replace(draft, goal_index=there)
        return FoundPath(draft=_standing(at_goal, q_start, integral), reached=targets[there])
    if targets[0].q is not None and not is_list:
        candidates = rate_candidates(targets[0].q[None], [0], q_start, integral)
    else:
        if seeding.initial is not None:
            raise InvalidInputError("seeding.initial", seeding.initial, "None: a goal with a first path is one configuration")
        notify(0.0, "preparing collision shapes")
        model = scene.collision_model(robot)
        model.free_configuration("start", q_start, number("clearance", clearance, least=0.0))
        candidates = find_candidates(targets, q_start, model, integral, clearance, constraint_set)
    choice = choose(candidates, path_to, deadline, part(notify, 0.0, 0.6))
    draft = replace(draft, candidates=choice.candidates, goal_index=choice.goal_index)
    if choice.result is None:
        return FoundPath(draft=replace(draft, message=choice.failure))
    result = choice.result
    for other in _other_shapes(shape):
        descended = result.certificate is not None and np.isfinite(result.certificate.projected_gradient)
        crosses = not np.isfinite(result.g)  # another degree crosses the same singularity
        if (descended and result.status.ok) or crosses:
            break
        if deadline.passed:
            result = result if result.status.ok else _out_of_time(result)
            break
        notify(0.6, f"{other.basis} of degree {other.degree}")
        more = optimize_from(
            robot,
            result.seed,
            scene,
            objective=objective,
            shape=other,
            constraints=constraint_set.constraints,
            clearance=clearance,
            deadline=deadline,
        )
        if more.status is Status.INTERRUPTED:
            raise KeyboardInterrupt
        result = min(result, more, key=lambda each: (not each.status.ok, each.g))
    draft = replace(draft, path=result.path, result=result, status=result.status)
    return FoundPath(draft=draft, reached=targets[draft.goal_index])


def _standing(draft: PartialPlan, q: Array, integral: PathIntegral) -> PartialPlan:
    """The plan of an arm that stands in a goal already, at q (n,)."""
    path = JointPath(breaks=np.array([0.0, 1.0]), control=np.array([[q, q]]))
    least = float(integral.kinematics.manipulability(q))
    result = PathResult(
        path=path,
        g=0.0,
        length=0.0,
        min_manipulability=least,
        min_at=0.0,
        power=integral.power,
        task=integral.kinematics.task,
        seed=path,
        seed_cost=PathCost(g=0.0, length=0.0, min_manipulability=least, at=0.0),
        history=(),
        status=Status.AT_GOAL,
        measure=integral.kinematics.measure,
        metric=integral.metric,
        floor=integral.floor,
    )
    chosen = GoalCandidate(
        goal_index=draft.goal_index,
        q=q,
        manipulability=least,
        bound=least,
        straight_length=0.0,
        straight_g=0.0,
        straight_min_manipulability=least,
        min_manipulability=least,
        g=0.0,
        chosen=True,
        status="chosen: the arm stands there",
    )
    return replace(draft, path=path, result=result, status=result.status, candidates=(chosen,))


def _stay(q: Array, robot: Robot) -> Trajectory:
    """A motion that stays at q (n,)."""
    return Trajectory(t=np.array([0.0, STANDING]), q=np.array([q, q]), qd=np.zeros((2, len(q))), joint_names=robot.joint_names)


def _out_of_time(result: PathResult) -> PathResult:
    """The first path as result, where the time limit left no time for another shape."""
    status = Status.SEED_OUT_OF_TIME
    certificate = None if result.certificate is None else replace(result.certificate, status=status)
    return replace(result, status=status, certificate=certificate)


def _other_shapes(shape: PathShape) -> tuple[PathShape, ...]:
    """The shapes that are tried in turn where `shape` gives no path, with the same derivatives at start and goal."""
    higher = replace(shape, basis="legendre", degree=min(shape.degree + MORE_DEGREES, MOST_DEGREE), pieces=1)
    return higher, replace(shape, basis="bspline", degree=3, pieces=SPLINE_PIECES)
