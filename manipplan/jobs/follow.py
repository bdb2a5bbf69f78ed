"""follow: a timed motion along a workspace path."""

from collections.abc import Iterator, Sequence
from concurrent.futures import Executor
from contextlib import suppress
from dataclasses import replace
from typing import Literal, overload

import numpy as np

from manipplan.collision.scene import Scene
from manipplan.cost.crossings import is_singular
from manipplan.cost.integral import PathIntegral, metric_matrix
from manipplan.cost.objective import PathObjective, check_measure, floor_of, idle_hint
from manipplan.goals.goal import read_configuration
from manipplan.ik.form import closed_form
from manipplan.ik.solver import Solver
from manipplan.jobs.plan import plan
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import Tolerance, with_defaults
from manipplan.paths.trajectory import Trajectory, joined
from manipplan.plans.measure import tool_distances
from manipplan.plans.report import VANISHING, PathPart, PlanReport
from manipplan.plans.result import PartialPlan, Plan, failed, finish
from manipplan.robots.arms import has_few_joints, one_tool
from manipplan.robots.limits import TakenToLimit, taken_to_limits
from manipplan.robots.robot import Robot
from manipplan.search.layers import SPARE_CLEARANCE, choose_positions
from manipplan.search.max_min import max_min_search
from manipplan.search.sampling import sample_layers
from manipplan.search.sweep import check_epsilon
from manipplan.seeds.seeding import AS_GIVEN, Seeding
from manipplan.support.checks import COINCIDENT, Array, ArrayLike, finite_array, flag, instance, number, whole_number
from manipplan.support.deadline import OutOfTimeError, TimeLimit, until
from manipplan.support.errors import InvalidInputError
from manipplan.support.progress import Progress, as_callback, interruptible, part, rising
from manipplan.support.status import Failure, Status
from manipplan.support.workers import one_thread
from manipplan.symbolic.free_motion import FreeMotion
from manipplan.symbolic.task import Task
from manipplan.timing.constant_speed import MOST_SLOWDOWN, STEADY, SpeedDemand, check_corners, check_tool_speed
from manipplan.timing.retime import check_timing_limits, retime
from manipplan.tool_path.engine import MORE_POSITIONS, SPACING, ToolPathPlanner
from manipplan.tool_path.gap import explain_gap
from manipplan.tool_path.parts import FollowingMotion, FoundPart, NotConnected, PartsFailure, PartsJoiner, find_parts
from manipplan.tool_path.transit import TransitPlanner

#: Minimum length of a retreat [m].
LEAST_RETREAT = 1e-3
#: Distances beyond the clearance that positions keep [m], one tried after the other.
SPARES = (1e-4, SPARE_CLEARANCE)
#: Share of the progress at which the motion is timed.
TIMING = 0.95
#: Number of poses that are compared to see whether a path moves the tool.
POSE_SAMPLES = 50
#: Number of samples of each of two parameters that are taken first, and share of the bound on every path's minimum
#: manipulability that a path among them has to reach; else as many as by default are taken.
FEWER_SAMPLES, ENOUGH = 48, 0.8
#: A tolerance is wide, and searched as a region about each pose, from this distance [m] or angle [rad] on.
WIDE = Tolerance(position=1e-3, rotation=0.01)
#: Share of a wide tolerance inside which its region is.
REGION = 0.85
#: Number of rows of a task that leaves nothing free.
ROWS_OF_POSE = 6


@overload
def follow(
    robot: Robot,
    path: CartesianPath,
    scene: Scene | None = ...,
    *,
    start: ArrayLike | str | None = ...,
    tool_speed: float | None = ...,
    slowdown: float = ...,
    positions: int | ArrayLike | None = ...,
    interruptions: int = ...,
    retreat: float | ArrayLike = ...,
    objective: PathObjective = ...,
    epsilon: ArrayLike = ...,
    samples: int | Sequence[int] | None = ...,
    tolerance: Tolerance | None = ...,
    clearance: float = ...,
    closed: bool = ...,
    torque: bool = ...,
    executor: Executor | None = ...,
    seeding: Seeding = ...,
    time_limit: float | None = ...,
    throw: Literal[True] = True,
    progress: Progress | None = ...,
) -> Plan: ...


@overload
def follow(
    robot: Robot,
    path: CartesianPath,
    scene: Scene | None = ...,
    *,
    start: ArrayLike | str | None = ...,
    tool_speed: float | None = ...,
    slowdown: float = ...,
    positions: int | ArrayLike | None = ...,
    interruptions: int = ...,
    retreat: float | ArrayLike = ...,
    objective: PathObjective = ...,
    epsilon: ArrayLike = ...,
    samples: int | Sequence[int] | None = ...,
    tolerance: Tolerance | None = ...,
    clearance: float = ...,
    closed: bool = ...,
    torque: bool = ...,
    executor: Executor | None = ...,
    seeding: Seeding = ...,
    time_limit: float | None = ...,
    throw: bool,
    progress: Progress | None = ...,
) -> Plan | PartialPlan: ...


@interruptible()
@one_thread()
def follow(
    robot: Robot,
    path: CartesianPath,
    scene: Scene | None = None,
    *,
    start: ArrayLike | str | None = None,
    tool_speed: float | None = None,
    slowdown: float = STEADY,
    positions: int | ArrayLike | None = None,
    interruptions: int = 0,
    retreat: float | ArrayLike = 0.05,
    objective: PathObjective = PathObjective(),
    epsilon: ArrayLike = 0.2,
    samples: int | Sequence[int] | None = None,
    tolerance: Tolerance | None = None,
    clearance: float = 0.0,
    closed: bool = False,
    torque: bool = False,
    executor: Executor | None = None,
    seeding: Seeding = Seeding(),
    time_limit: float | None = None,
    throw: bool = True,
    progress: Progress | None = None,
) -> Plan | PartialPlan:
    """Plan the motion along a workspace path with the largest minimum manipulability, timed and checked.

    All configurations at a number of positions are searched for the best continuous path. It is refined between the samples,
    joined by a spline that stays on the workspace path, timed, and checked independently.

    Samples are added where branches of configurations turn back or move fast. Positions are added where no motion leads on,
    where the motion leaves the path or touches a body between them, or where faster joints allow a larger minimum; the
    latter only while no joint moves more than 7° from one given pose to the next, if none does without it. If nothing
    connects even then, the tool may leave the path and come back to it in another configuration, if `interruptions` allows
    that. Their number is the smallest that the samples allow, which is proven for them. With that number the minimum
    manipulability on the path is the largest. At an interruption the tool retreats, a free motion follows, and the tool
    comes back to the pose where it left. `report.along` tells when.

    With a `start` the motion begins there. If the tool stands at the first pose of the path, to a quarter of the tolerance,
    the path begins in this configuration, if a motion along the path does. Otherwise a lead-in, planned as by `plan`, leads to
    one in which the path begins, and stops there. It is chosen for the largest minimum manipulability of lead-in and path
    together: what the start and the best path from a configuration allow bounds it, so those with the largest bound are tried
    first, and no more where another could gain at most 1 %; at most four motions. `candidates` of the plan tells what was
    tried, and `path_begin` when the path begins.

    Args:
        robot: the arm.
        path: workspace path of the tool.
        scene: obstacles; None: none. The arm is always checked against itself.
        start: (n,) inside the limits and collision-free [rad or m], or the name of one of `robot.states`; None: the motion
            begins where the best motion along the path does.
        tool_speed: constant speed of the tool's origin along the path [m/s], kept to `slowdown` between a ramp at either end;
            None: as fast as the limits allow. The path must move the tool's origin everywhere. The joint path is chosen for the
            speed where the tool does not have it on the one with the largest minimum manipulability.
        slowdown: share by which the tool may be slower than `tool_speed` where the arm's limits do not allow it, from 0.01 to
            0.99. `report.along` tells the smallest speed, and when.
        positions: number of positions at which configurations are enumerated, or their s (L,) from 0 to 1; None: at most 3 cm
            apart, where 1 rad counts as 10 cm, at poses of the path as far as possible, and down to an eighth of that where
            nothing connects, or a 64th where a single step has no motion. To given ones they are added only where the motion
            leaves the path or touches a body.
        interruptions: maximum number of interruptions. A closed path that is interrupted begins where that takes the fewest,
            and the way back to where it began counts as one. A path on which the tool does not have its constant speed
            is parted where limits demand it.
        retreat: straight way of the tool off the path and onto it again at an interruption [m]: a distance against the tool's
            z-axis, or a vector (3,) in the tool frame; 0 for none. A planar arm needs 0 or a vector with z = 0.
        objective: its task and its measure define the manipulability whose minimum is maximised; power and metric only count in
            the g that is reported. Task.pose(), the default, follows the poses; Task.pointing(axis), Task.position() and others
            leave a motion of the tool free.
        epsilon: maximum step of a joint between neighbouring positions [rad or m], one number or (n,); below π where it turns.
        samples: number of grid points of the redundancy; see `sample_layers`. With two parameters of an arm with a closed
            form 48 of each are tried first. On an arm with a closed form and one degree of redundancy more are added where
            joints of neighbouring ones differ by more than 0.05.
        tolerance: maximum deviation of the tool from the path. Default: 0.1 mm and 1 mrad between the positions, which are
            met exactly; a tolerance that gives only one of the two has the default for the other. From 1 mm or 0.01 rad on a
            second search takes a box inside it about each pose, as `Task.within` does, and the better motion is returned. It
            takes minutes on arms without closed-form inverse kinematics, where it is made only if the first finds no motion.
        clearance: distance [m] to keep from obstacles and between the arm's own links. The positions keep 0.1 mm more, for the
            motion between them, or 3 mm where that is too little.
        closed: the path returns to its start, and the motion to its first configuration.
        torque: keep the joints' effort limits as well.
        executor: runs the sampling of positions; see `sample_layers`.
        seeding: how free motions to the path and between its parts are planned, as for `plan`; its `time_limit` holds for all
            that lead to one part, its `seed` also for the random starts of arms without closed-form inverse kinematics.
            `shifts` and `initial` stay at their defaults.
        time_limit: time [s] after which what was found is timed, checked and returned, with a smaller minimum manipulability
            than it could have; None: none. Motions are improved while timing and checks are likely to end in time. Where no
            motion passed its checks by then, the status is NOT_IN_TIME. What is built once per robot or scene does not count.
        throw: raise PlanningError if no motion is found; False: return a PartialPlan, or a Plan with Status.CHECK_FAILED.
        progress: called with the fraction done in [0, 1] and a text.

    Raises:
        InvalidInputError: an argument is invalid, a position is out of reach or too near to a body, or the tool speed is not
            kept (also with throw=False); the message names the two bodies and their distance, or the fastest speed, and the
            place, joint and limit that allow no faster one. What a corner of the path rules out is refused before work starts.
        UnknownNameError: no state has the name given as `start`; the nearest names are listed.
        PlanningError: no continuous motion, no lead-in, or none that passes its checks; its `result` is the Plan so far.
    """
    limit = TimeLimit(time_limit, "sampling positions")
    one_tool(instance("robot", robot, Robot), "following a path of the tool")
    scene = instance("scene", scene if scene is not None else Scene(), Scene)
    if not isinstance(path, CartesianPath):
        raise InvalidInputError("path", path, "a CartesianPath, such as CartesianPath.through([pose, pose])")
    instance("objective", objective, PathObjective)
    instance("seeding", seeding, Seeding)
    if seeding.shifts != AS_GIVEN or seeding.initial is not None:
        name = "shifts" if seeding.shifts != AS_GIVEN else "initial"
        raise InvalidInputError(f"seeding.{name}", getattr(seeding, name), "its default: the path decides where a motion leads")
    metric = metric_matrix("metric", objective.metric, robot.n)
    if objective.measure is not None:
        check_measure(robot.kinematics(objective.task or Task.pose(), measure=objective.measure))
    if tolerance is not None:
        instance("tolerance", tolerance, Tolerance)
    for name, value in (("torque", torque), ("throw", throw)):
        flag(name, value)
    if objective.task is None and has_few_joints(robot) and not robot.planar:
        wanted = f"one with a task of at most {robot.n} rows, as {robot.name} has {robot.n} joints: mp.PathObjective(task=...)"
        if robot.n >= 3:
            wanted += (
                " with mp.Task.position() or, from five joints on, mp.Task.pointing(axis), which keeps the direction of a tool "
                "axis too"
            )
        raise InvalidInputError("objective", objective, wanted)
    notify = rising(as_callback(progress))
    epsilon = check_epsilon(epsilon, robot.turns)
    clearance = number("clearance", clearance, least=0.0)
    check_timing_limits(robot.limits)
    given = None if start is None else read_configuration("start", start, robot)
    slowdown = number("slowdown", slowdown, least=STEADY, most=MOST_SLOWDOWN)
    interruptions = whole_number("interruptions", interruptions, least=0)
    demand: SpeedDemand | None = None
    stops: tuple[float, ...] = ()
    if tool_speed is not None:
        tool_speed = check_tool_speed(tool_speed, path)
        position = with_defaults(tolerance).position
        assert position is not None
        shifts = () if objective.task is None else FreeMotion.of(objective.task, planar=robot.planar).shifts
        if not len(shifts):  # the tool passes all corners of the path, and rests only where it is interrupted
            stops = check_corners(tool_speed, path, robot, position=position, slowdown=slowdown, interruptions=interruptions)
        demand = SpeedDemand(speed=tool_speed, slowdown=slowdown, torque=torque)
    elif slowdown != STEADY:
        raise InvalidInputError("slowdown", slowdown, f"{STEADY:g} where no tool_speed is asked for")
    way = _retreat(retreat)
    if interruptions and robot.planar and way[2]:
        wanted = "0, or a vector (3,) with z = 0: the tool of a planar arm stays in its plane"
        raise InvalidInputError("retreat", retreat, wanted)
    deadline, say = limit.deadline, limit.noting(notify)
    q_start = None
    taken: tuple[TakenToLimit, ...] = ()
    if given is not None:
        q_start = scene.collision_model(robot).free_configuration("start", given, clearance)
        taken = taken_to_limits(robot, "start", given)

    def attempt(spare: float, say: Progress, task: Task | None, within: Tolerance | None) -> Plan | PartialPlan:
        """The motion whose positions keep a distance beyond the clearance, for a task and a tolerance of the search."""

        def sample(samples: int | Sequence[int] | None, notify: Progress) -> ToolPathPlanner:
            layers = sample_layers(
                robot,
                path,
                positions if positions is not None else choose_positions(path, closed=closed),
                task=task,
                measure=objective.measure,
                samples=samples,
                scene=scene,
                clearance=clearance,
                spare=spare,
                spacing=SPACING,
                closed=closed,
                near=q_start,
                executor=executor,
                seed=seeding.seed,
                progress=until(deadline, notify),
            )
            planner = ToolPathPlanner(
                path=path,
                layers=layers.inside(robot.limits),
                tolerance=within,
                samples=samples,
                deadline=deadline,
                check_ending=limit.check_ending,
            )
            return planner.at_speed(demand)

        def find_begin(planner: ToolPathPlanner) -> Array | None:
            """The start where it is at the first pose of the path."""
            return q_start if q_start is not None and planner.is_at_start(q_start) else None

        planner = None
        if samples is None and _has_two_parameters(robot, task):
            with suppress(InvalidInputError):  # of a position at which none of fewer samples is free
                fewer = sample(FEWER_SAMPLES, part(say, 0.0, 0.1))
                planner = fewer if fewer.reaches(ENOUGH, epsilon, find_begin(fewer)) else None
        if planner is None:
            planner = sample(samples, part(say, 0.1, 0.4))
        begin = find_begin(planner)
        sampler = planner.layers.sampler
        assert sampler is not None
        if max(float(m.max()) for m in planner.layers.m) < VANISHING:
            hint = idle_hint(sampler.kinematics)
            wanted = "a task whose rows are independent somewhere on the path: the arm is singular in every configuration there"
            wanted += f"; {hint}" if hint else ""
            raise InvalidInputError("objective", sampler.kinematics.task.name, wanted)

        kinematics = sampler.kinematics
        if task is not objective.task:  # the tool is compared with the poses themselves
            kinematics = robot.kinematics(objective.task or Task.pose(), measure=objective.measure, threads=1)
        floor = floor_of(kinematics, objective.floor)
        integral = PathIntegral(kinematics=kinematics, power=objective.power, floor=floor, metric=metric)
        allowed = with_defaults(tolerance)
        draft = PartialPlan(robot=robot, scene=scene, status=Status.NOT_CONNECTED, workspace_path=path, tolerance=allowed)

        def find_from(begin: Array | None) -> Iterator[list[FoundPart]] | NotConnected:
            limited = until(deadline, part(say, 0.4, 0.6))
            return find_parts(planner, epsilon, interruptions, limited, connects=positions is None, start=begin, stops=stops)

        parts = find_from(begin)
        if isinstance(parts, NotConnected) and begin is not None:
            others = find_from(None)
            if not isinstance(others, NotConnected):
                parts, begin = others, None
        if isinstance(parts, NotConnected):
            prefix = "" if begin is None else "from the start, which is at the first pose of the path, "
            search, where = parts.search, ""
            if positions is None:
                where = explain_gap(parts.planner, epsilon)
            else:  # the smallest epsilon of a closed path can take minutes
                search = max_min_search(parts.planner.layers, epsilon, explain=not closed, throw=False)
                where = search.message
            message = f"{prefix}{where}; {parts.message}{parts.planner.in_the_way(search)}"
            return failed(replace(draft, search=search), False, message)
        free_objective = replace(objective, task=kinematics.task)
        cut_short = False

        def plan_free(begin: Array, goal: Array, seconds: float, notify: Progress) -> tuple[JointPath, Trajectory] | Failure:
            nonlocal cut_short
            cut_short = cut_short or deadline.left < seeding.time_limit
            seconds = min(seconds, deadline.left)
            if seconds <= 0:
                return Failure(message="no time was left for a free motion")
            made = plan(
                robot,
                begin,
                goal,
                scene,
                objective=free_objective,
                seeding=replace(seeding, time_limit=seconds / seeding.count),
                clearance=clearance,
                torque=torque,
                throw=False,
                progress=notify,
            )
            return (
                (made.path, made.trajectory)
                if isinstance(made, Plan) and made.status.has_path
                else Failure(message=made.message)
            )

        transits = TransitPlanner(
            robot=robot,
            scene=scene,
            integral=integral,
            objective=free_objective,
            clearance=clearance,
            torque=torque,
            plan_free=plan_free,
            seconds=seeding.time_limit,
        )
        joiner = PartsJoiner(
            start=q_start, hold_start=begin is not None, closed=closed, way=way, transits=transits, notify=part(say, 0.6, 0.9)
        )
        motion = joiner.first_of(parts)
        draft = replace(draft, candidates=motion.candidates)
        if isinstance(motion, PartsFailure):
            status = Status.NOT_IN_TIME if cut_short else Status.NO_PATH
            return failed(replace(draft, search=motion.search, status=status), False, motion.message)
        still = all(each.refined.path.length < COINCIDENT for each in motion.parts)
        if still and np.ptp(path.sample(POSE_SAMPLES), axis=0).max() > COINCIDENT:
            wanted = "a task for which the arm has to move: one configuration meets what counts of all poses"
            raise InvalidInputError("objective", kinematics.task.name, wanted)
        result = motion.result(integral, scene, clearance)
        least = min((each.refined for each in motion.parts), key=lambda refined: refined.refinement.refined)
        is_followed = not is_singular(result.path, integral, integral.cost(result.path))
        draft = replace(
            draft,
            status=motion.status if is_followed else Status.SINGULAR,
            search=least.search,
            refinement=least.refinement,
            path=result.path,
            result=result,
        )

        def compare_with_path(report: PlanReport, trajectory: Trajectory) -> PlanReport:
            """The tool over its time with the whole path, and in order with its poses; its speeds."""
            kinematics = integral.kinematics
            deviation, passed_by = tool_distances(
                trajectory.path(), trajectory.duration, kinematics, path, report.along, allowed
            )
            in_order = [each.missed(kinematics, allowed) for each in motion.parts]
            missed = [deviation.excess(allowed, "time"), passed_by.excess(allowed, "poses"), *in_order]
            left = [f"{each}. {MORE_POSITIONS}" for each in missed if each]
            unsteady = [
                each.tool_speed for each in report.along if each.tool_speed is not None and not each.tool_speed.is_steady
            ]
            speeds = [f"the tool speed is not constant: {each}" for each in unsteady]
            return replace(report, deviation=deviation, faults=(*report.faults, *left, *speeds))

        ending = sum(each.refined.ending for each in motion.parts)

        def end(share: float, text: str) -> None:
            say(share, text)
            if share < 1:
                limit.check_ending(ending * (1 - share) / (1 - TIMING))

        return finish(
            draft,
            lambda: _time(motion, robot, integral, demand, torque=torque),
            taken=taken,
            clearance=clearance,
            torque=torque,
            throw=False,
            notify=end,
            begins=TIMING,
            amend=compare_with_path,
        )

    def search(say: Progress, task: Task | None, within: Tolerance | None) -> Plan | PartialPlan:
        """The motion, with more distance where it touches bodies between positions that nearly touch them."""
        followed = attempt(SPARES[0], say, task, within)
        report = followed.report
        if report is not None and not (report.passed or report.collision_free or deadline.passed):
            with suppress(InvalidInputError, OutOfTimeError):
                followed = attempt(SPARES[1], say, task, within)
        return followed

    wide = None if tolerance is None or robot.planar else _task_within(objective.task or Task.pose(), tolerance)
    first, second = (say, say) if wide is None else (part(say, 0.0, 0.5), part(say, 0.5, 1.0))
    try:
        followed = search(first, objective.task, tolerance)
    except OutOfTimeError:
        nothing = PartialPlan(
            robot=robot, scene=scene, status=Status.NOT_IN_TIME, workspace_path=path, tolerance=with_defaults(tolerance)
        )
        return failed(nothing, throw, limit.missed("motion along the path"))
    except InvalidInputError as error:
        if wide is None:
            raise
        try:
            followed = search(second, wide, None)
        except (InvalidInputError, OutOfTimeError):
            raise error from None
    else:
        has_motion = followed.status.has_path
        if wide is not None and not deadline.passed and not (has_motion and closed_form(robot) is None):
            with suppress(InvalidInputError, OutOfTimeError):
                followed = _better(followed, search(second, wide, None))
    return followed if followed.status.has_path else failed(followed, throw, followed.message)


def _has_two_parameters(robot: Robot, task: Task | None) -> bool:
    """Whether two parameters of closed-form inverse kinematics are sampled."""
    solver = Solver.of(robot, task=task, held=None, method="auto", seed=0)
    return solver.form is not None and len(solver.names) == 2 and solver.free.bounds is None


def _task_within(task: Task, tolerance: Tolerance) -> Task | None:
    """The task with a region about each pose inside a wide tolerance; None for narrow ones and other kinds of tasks."""
    wide = []
    for given, least in ((tolerance.position, WIDE.position), (tolerance.rotation, WIDE.rotation)):
        assert least is not None
        wide.append(REGION * given if given is not None and given >= least else 0.0)
    position, rotation = wide[0] / np.sqrt(3), min(wide[1], np.pi)
    if task.region is not None or not (position or rotation):
        return None
    if task.rows == ROWS_OF_POSE:
        return task.within(position=position, rotation=rotation / np.sqrt(3))
    if task.rows == ROWS_OF_POSE - 1 and task.free_axis is not None:
        least_cone = with_defaults(tolerance).rotation
        assert least_cone is not None
        return task.within(position=position, cone=rotation or REGION * min(least_cone, np.pi), axis=task.free_axis)
    return None


def _better(followed: Plan | PartialPlan, other: Plan | PartialPlan) -> Plan | PartialPlan:
    """The motion that passed its checks with fewer parts, or of as many with the larger minimum manipulability."""

    def rank(plan: Plan | PartialPlan) -> tuple[bool, int, float]:
        report = plan.report
        if report is None or not (plan.status.has_path and report.passed):
            return (False, 0, 0.0)
        return (True, -len(report.along), report.min_manipulability)

    return other if rank(other) > rank(followed) else followed


def _time(
    followed: FollowingMotion, robot: Robot, integral: PathIntegral, demand: SpeedDemand | None, *, torque: bool
) -> tuple[Trajectory, tuple[PathPart, ...]]:
    """The timed motion, and its parts along the path. Raises InvalidInputError for a speed, PlanningError for limits."""
    pieces: list[Trajectory] = []
    along: list[PathPart] = []
    clock = 0.0
    for each in followed.parts:
        if each.transit is not None:
            pieces.append(each.transit.trajectory)
            clock += each.transit.trajectory.duration
        path, speed = each.refined.path, None
        if demand is None:
            motion = retime(path, robot, torque=torque)
        elif each.refined.steady is not None:
            motion, speed = each.refined.steady
        else:
            motion, speed = demand.timed(path, robot, ends=(each.part.s_begin, each.part.s_end))
        speed = None if speed is None else speed.later(clock)
        pieces.append(motion)
        along.append(
            PathPart(
                begin=clock,
                end=clock + motion.duration,
                s_begin=each.part.s_begin,
                s_end=each.part.s_end,
                min_manipulability=integral.cost(motion.path()).min_manipulability,
                tool_speed=speed,
            )
        )
        clock += motion.duration
    if followed.back is not None:
        pieces.append(followed.back.trajectory)
    return joined(pieces), tuple(along)


def _retreat(value: float | ArrayLike) -> Array:
    """The way (3,) off the path in the tool frame [m]; raises InvalidInputError."""
    tool_z = np.array([0.0, 0.0, 1.0])
    along = isinstance(value, int | float | np.number)
    way = -number("retreat", value, least=0.0) * tool_z if along else finite_array("retreat", value, (3,))
    if 0 < np.linalg.norm(way) < LEAST_RETREAT:
        raise InvalidInputError("retreat", value, f"0 for none, or at least {1e3 * LEAST_RETREAT:g} mm")
    return way
