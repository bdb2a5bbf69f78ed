"""follow: a timed motion along a workspace path."""

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import replace
from typing import Literal, overload

import numpy as np
from numpy.typing import ArrayLike

from manipplan.collision.scene import Scene
from manipplan.cost.floor import floor_of
from manipplan.cost.integral import PathIntegral
from manipplan.cost.metric import metric_matrix
from manipplan.cost.objective import PathObjective, check_measure
from manipplan.jobs.following.course import Course, CourseFinder, nearest_pair
from manipplan.jobs.following.lead_in import Planner, choose_entry
from manipplan.jobs.goals.read import named_configuration
from manipplan.jobs.plan import plan
from manipplan.jobs.reports.along import PathPart
from manipplan.jobs.result import PartialPlan, Plan, check_failed, failed, finish
from manipplan.optimize.result import PathResult, make_result
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.deviation import deviation_at, deviation_from
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import Tolerance, with_defaults
from manipplan.paths.trajectory import Trajectory, joined
from manipplan.robots.arms import one_tool
from manipplan.robots.robot import Robot
from manipplan.search.max_min import max_min_search
from manipplan.search.sampling import sample_layers
from manipplan.search.steps import check_epsilon
from manipplan.seeds.seeding import Seeding
from manipplan.support.checks import Array, instance, number
from manipplan.support.compiling.native import compile_ahead
from manipplan.support.errors import PlanningError
from manipplan.support.interrupts import interruptible
from manipplan.support.progress import Progress, part, teller
from manipplan.support.status import Status
from manipplan.symbolic.task import Task
from manipplan.timing.retime import check_timing_limits, retime
from manipplan.timing.steady.retime_steady import retime_steady
from manipplan.timing.steady.speed import check_tool_speed, measure_speed

#: Clearance that candidates keep beyond the required one, for the motion between positions [m].
SPARE = 0.003
#: C sources of this job that are compiled while inverse kinematics is, at the first call ever.
SOURCES = ("collision/distances.c", "search/sweep.c", "cost/panels.c", "paths/curves.c", "timing/barrier.c")
#: Number of times at which the tool is compared with the path.
TIMES = 1500


@overload
def follow(
    robot: Robot,
    path: CartesianPath,
    scene: Scene | None = ...,
    *,
    start: ArrayLike | str | None = ...,
    tool_speed: float | None = ...,
    positions: int = ...,
    objective: PathObjective = ...,
    epsilon: ArrayLike = ...,
    samples: int | Sequence[int] | None = ...,
    tolerance: Tolerance | None = ...,
    clearance: float = ...,
    closed: bool = ...,
    torque: bool = ...,
    executor: Executor | None = ...,
    seed: int = ...,
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
    positions: int = ...,
    objective: PathObjective = ...,
    epsilon: ArrayLike = ...,
    samples: int | Sequence[int] | None = ...,
    tolerance: Tolerance | None = ...,
    clearance: float = ...,
    closed: bool = ...,
    torque: bool = ...,
    executor: Executor | None = ...,
    seed: int = ...,
    throw: bool,
    progress: Progress | None = ...,
) -> Plan | PartialPlan: ...


@interruptible()
def follow(
    robot: Robot,
    path: CartesianPath,
    scene: Scene | None = None,
    *,
    start: ArrayLike | str | None = None,
    tool_speed: float | None = None,
    positions: int = 50,
    objective: PathObjective = PathObjective(),
    epsilon: ArrayLike = 0.2,
    samples: int | Sequence[int] | None = None,
    tolerance: Tolerance | None = None,
    clearance: float = 0.0,
    closed: bool = False,
    torque: bool = False,
    executor: Executor | None = None,
    seed: int = 0,
    throw: bool = True,
    progress: Progress | None = None,
) -> Plan | PartialPlan:
    """Plan the motion along a workspace path with the largest minimum manipulability, timed and checked.

    All configurations at a number of positions are searched for the best continuous path. It is refined between the samples,
    joined by a spline that stays on the workspace path, timed, and checked independently.

    With a `start` the motion begins there. If the tool stands at the first pose of the path, to a quarter of the tolerance,
    the path begins in this configuration. Otherwise a lead-in, planned as by `plan`, leads to one in which the path begins,
    and stops there. It is chosen for the largest minimum manipulability of lead-in and path together: what the start and the
    best path from a configuration allow bounds it, so those with the largest bound are tried first, and no more where another
    could gain at most 1 %; at most four motions. `candidates` of the plan tells what was tried, and `path_begin` when the path
    begins.

    Args:
        robot: the arm.
        path: workspace path of the tool.
        scene: obstacles; None: none. The arm is always checked against itself.
        start: (n,) inside the limits and collision-free [rad or m], or the name of one of `robot.states`; None: the motion
            begins where the best motion along the path does.
        tool_speed: constant speed of the tool's origin along the path [m/s], kept to 1 % between a ramp at either end; None: as
            fast as the limits allow. The path must move the tool's origin everywhere.
        positions: number of positions at which configurations are enumerated.
        objective: its task, Task.pose() by default or Task.pointing(axis), and its measure define the manipulability whose
            minimum is maximised; power and metric only count in the g that is reported.
        epsilon: maximum step of a joint between neighbouring positions [rad or m], one number or (n,).
        samples: number of grid points of the redundancy; see `sample_layers`.
        tolerance: maximum deviation of the tool from the path. Default: 0.1 mm and 1 mrad between the positions, which are
            met exactly; a tolerance that gives only one of the two has the default for the other.
        clearance: distance [m] to keep from obstacles and between the arm's own links. The positions keep 3 mm more, for the
            motion between them.
        closed: the path returns to its start, and the motion to its first configuration.
        torque: keep the joints' effort limits as well.
        executor: runs the sampling of positions; see `sample_layers`.
        seed: of random starts, for arms without closed-form inverse kinematics.
        throw: raise PlanningError if no motion is found; False: return a PartialPlan, or a Plan with Status.CHECK_FAILED.
        progress: called with the fraction done in [0, 1] and a text.

    Raises:
        InvalidInputError: an argument is invalid, a position is out of reach or too near to a body, or the tool speed is not
            reached (also with throw=False); the message names the two bodies and their distance, or the fastest speed.
        UnknownNameError: no state has the name given as `start`; the nearest names are listed.
        PlanningError: no continuous motion, no lead-in, or none that passes its checks; its `result` is the Plan so far.
    """
    one_tool(instance("robot", robot, Robot), "following a path of the tool")
    scene = instance("scene", scene if scene is not None else Scene(), Scene)
    instance("objective", objective, PathObjective)
    metric = metric_matrix("metric", objective.metric, robot.n)
    if objective.measure is not None:
        check_measure(robot.kinematics(objective.task or Task.pose(), measure=objective.measure))
    if tolerance is not None:
        instance("tolerance", tolerance, Tolerance)
    for name, value in (("torque", torque), ("throw", throw)):
        instance(name, value, bool)
    tell = teller(progress)
    epsilon = check_epsilon(epsilon, robot.endless)
    clearance = number("clearance", clearance, least=0.0)
    check_timing_limits(robot.limits)
    q_start = None if start is None else named_configuration("start", start, robot)
    if tool_speed is not None:
        tool_speed = check_tool_speed(tool_speed, path)
    compile_ahead(*SOURCES)
    if q_start is not None:
        q_start = scene.collision_model(robot).free_configuration("start", q_start, clearance)
    layers = sample_layers(
        robot,
        path,
        positions,
        task=objective.task,
        measure=objective.measure,
        samples=samples,
        scene=scene,
        clearance=clearance,
        spare=SPARE,
        closed=closed,
        executor=executor,
        seed=seed,
        progress=part(tell, 0.0, 0.5),
    )
    assert layers.sampler is not None
    kinematics = layers.sampler.kinematics
    floor = floor_of(kinematics, objective.floor)
    integral = PathIntegral(kinematics=kinematics, power=objective.power, floor=floor, metric=metric)
    draft = PartialPlan(
        robot=robot, scene=scene, status=Status.NOT_CONNECTED, workspace_path=path, tolerance=with_defaults(tolerance)
    )
    finder = CourseFinder(path=path, layers=layers, tolerance=tolerance, samples=samples)
    stands = q_start is not None and finder.begins_at(q_start)
    if q_start is not None and stands:
        finder = finder.beginning(q_start)
    found = max_min_search(finder.layers, epsilon, throw=False, progress=part(tell, 0.5, 0.6))
    draft = replace(draft, search=found)
    if not found.connected:
        begin = "from the start, which is at the first pose of the path, " if stands else ""
        return failed(draft, throw, begin + found.message + finder.in_the_way(found))
    lead_in = None
    if q_start is None or stands:
        course = finder.along(found, part(tell, 0.6, 0.9), hold_start=stands)
    else:
        planner = _lead_ins(robot, q_start, scene, replace(objective, task=kinematics.task), clearance, torque, seed)
        choice = choose_entry(finder, found, q_start, integral, planner, part(tell, 0.6, 0.9))
        draft = replace(draft, candidates=choice.candidates)
        if choice.entry is None:
            return failed(replace(draft, status=Status.NO_PATH), throw, choice.failure)
        lead_in, course = choice.entry.lead_in, choice.entry.course
    result = _measured(lead_in, course, integral, scene, clearance)
    draft = replace(
        draft,
        status=Status.FOLLOWED,
        search=course.search,
        refinement=course.refinement,
        path=result.path,
        result=result,
    )
    tell(0.95, "timing the motion")
    try:
        if tool_speed is None:
            along = retime(course.path, robot, torque=torque)
        else:
            along = retime_steady(course.path, robot, tool_speed, torque=torque)
    except PlanningError as error:
        return failed(replace(draft, status=Status.NO_TIMING), throw, str(error))
    tell(0.97, "checking the result")
    made, fault = _checked(draft, result, course, lead_in, along, integral, tool_speed, clearance=clearance, torque=torque)
    if made.status is not Status.FOLLOWED:
        return failed(made, throw, fault)
    if fault:
        return check_failed(made, throw, fault)
    tell(1.0, "done")
    return made


def _lead_ins(
    robot: Robot, start: Array, scene: Scene, objective: PathObjective, clearance: float, torque: bool, seed: int
) -> Planner:
    """What plans lead-ins from a start (n,)."""

    def planned(goal: Array, seconds: float, tell: Progress) -> Plan | PartialPlan:
        seeding = Seeding(seed=seed, time_limit=seconds)
        return plan(
            robot,
            start,
            goal,
            scene,
            objective=objective,
            seeding=seeding,
            clearance=clearance,
            torque=torque,
            throw=False,
            progress=tell,
        )

    return planned


def _measured(lead_in: Plan | None, course: Course, integral: PathIntegral, scene: Scene, clearance: float) -> PathResult:
    """The figures of lead-in and course together, compared with those of the path that the search found."""
    path, seed = course.path, course.seed
    if lead_in is not None:
        control = seed.control.copy()
        control[0, 0] = path.start  # the seed begins where the lead-in ends
        seed = JointPath(breaks=seed.breaks, control=control)
        path, seed = (JointPath.joined([lead_in.path, each]) for each in (path, seed))
    return make_result(
        path,
        integral,
        cost=integral.cost(path),
        seed=seed,
        seed_cost=integral.cost(seed),
        model=scene.collision_model(integral.kinematics.robot),
        clearance=clearance,
        status=Status.FOLLOWED,
    )


def _checked(
    draft: PartialPlan,
    result: PathResult,
    course: Course,
    lead_in: Plan | None,
    along: Trajectory,
    integral: PathIntegral,
    tool_speed: float | None,
    *,
    clearance: float,
    torque: bool,
) -> tuple[Plan, str]:
    """The plan, measured on its trajectory, and what is wrong with it; its status tells of faults that any plan can have."""
    robot, path, tolerance = draft.robot, draft.workspace_path, draft.tolerance
    assert path is not None and tolerance is not None
    trajectory = along if lead_in is None else joined([lead_in.trajectory, along])
    begin = 0.0 if lead_in is None else lead_in.trajectory.duration
    pose, axis = integral.kinematics.pose, integral.kinematics.task.free_axis
    deviation = deviation_from(path, pose(trajectory(np.linspace(begin, trajectory.duration, TIMES))), axis)
    model = draft.scene.collision_model(robot)
    made = finish(
        replace(draft, deviation=deviation),
        result.path,
        trajectory,
        result,
        model,
        result.path.goal,
        clearance=clearance,
        torque=torque,
        jerk=True,
        throw=False,
    )
    speed = None if tool_speed is None else measure_speed(trajectory, robot, tool_speed, begin=begin)
    there = PathPart(begin=begin, min_manipulability=integral.cost(along.path()).min_manipulability, tool_speed=speed)
    made = replace(made, report=replace(made.report, along=there))
    s = np.linspace(0.0, 1.0, TIMES)
    if made.status is not Status.FOLLOWED:
        near = "" if made.report.collision_free else f"\n  {nearest_pair(model, course.path(s))}; take more positions"
        return made, f"{made.report}{near}"
    fault = deviation.excess(tolerance, "time") or deviation_at(path, s, pose(course.path(s)), axis).excess(tolerance, "path")
    fault = f"{fault}. Take more positions" if fault else ""
    if not fault and speed is not None and not speed.is_steady:
        fault = f"the tool speed is not constant: {speed}"
    return made, fault
