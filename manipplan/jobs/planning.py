"""plan: from start to goal."""

from collections.abc import Callable
from dataclasses import replace

from numpy.typing import ArrayLike

from manipplan.checks import instance, number, whole_number
from manipplan.errors import PlanningError
from manipplan.interrupts import interruptible
from manipplan.jobs.result import Plan, checked, failed, silent
from manipplan.measures.task import Task
from manipplan.optimize.optimize import check_task, optimize_path
from manipplan.optimize.result import PathResult
from manipplan.paths.joint import JointPath
from manipplan.robots.robot import Robot
from manipplan.robots.scene import Scene
from manipplan.seeds.ompl import seed_path
from manipplan.status import Status
from manipplan.timing.retime import check_timing_limits, retime


@interruptible()
def plan(
    robot: Robot,
    start: ArrayLike,
    goal: ArrayLike,
    scene: Scene | None = None,
    *,
    task: Task | None = None,
    power: float = 1.0,
    degree: int = 6,
    clearance: float = 0.0,
    torque: bool = False,
    seed: int = 0,
    time_limit: float = 10.0,
    throw: bool = True,
    progress: Callable[[str], None] | None = None,
) -> Plan:
    """From start to goal: a collision-free path far from singularities, timed, and checked again when finished.

    A seed is found by OMPL and improved by the path optimiser; where no polynomial of `degree`, or of three degrees
    more, stays clear, the seed itself is timed and the status says so.

    Args:
        robot: the arm.
        start, goal: (n,) inside the limits and free [rad or m].
        scene: obstacles; None: none. The arm is always checked against itself.
        task: whose manipulability index counts; default `robot.default_task`.
        power: exponent of the index in g = ∫ ‖q'‖ / m^power ds.
        degree: of the path's polynomial.
        clearance: distance [m] to keep from obstacles and between the arm's own links.
        torque: limit the motion by the joints' effort, too.
        seed: of the planner; the same seed gives the same plan.
        time_limit: for the planner's search [s].
        throw: raise PlanningError where no trajectory can be had; False: return a Plan whose status says why.
        progress: called with a line of text as each step begins.

    Raises:
        InvalidInputError: an argument is not usable (also with throw=False).
        PlanningError: no free path, or no motion within the limits; its `result` is the Plan so far.
    """
    scene = instance("scene", scene if scene is not None else Scene(), Scene)
    degree = whole_number("degree", degree, least=1, most=20)
    say = progress or silent
    power = number("power", power, above=0.0, most=100.0)
    time_limit = number("time_limit", time_limit, above=0.0)
    seed = whole_number("seed", seed, least=0)
    instance("robot", robot, Robot)
    check_task(robot.kinematics(task))
    check_timing_limits(robot.limits)
    for argument, q in (("start", start), ("goal", goal)):
        robot.configuration(argument, q)
    clearance = number("clearance", clearance, least=0.0)
    say("preparing collision shapes")
    model = scene.collision_model(robot)
    draft = Plan(robot=robot, scene=scene, status=Status.NO_PATH)
    try:
        say("looking for a collision-free seed path")
        first = seed_path(robot, start, goal, scene, seed=seed, clearance=clearance, time_limit=time_limit)
    except PlanningError as error:
        return failed(draft, throw, str(error))
    say("optimising the path")
    result = _optimised(robot, first, degree, power, task, scene, clearance)
    path = result.path or first
    draft = replace(draft, path=path, result=result, status=result.status)
    try:
        say("timing the motion")
        trajectory = retime(path, robot.limits, joint_names=robot.joint_names, torque_model=robot.model if torque else None)
    except PlanningError as error:
        return failed(replace(draft, status=Status.NO_TIMING), throw, str(error))
    say("checking the result")
    return checked(draft, trajectory, result, model, path.goal, clearance=clearance, torque=torque, throw=throw)


def _optimised(
    robot: Robot, first: JointPath, degree: int, power: float, task: Task | None, scene: Scene, clearance: float
) -> PathResult:
    results = []
    for each in (degree, min(degree + 3, 20)):
        results.append(
            optimize_path(
                robot, first.start, first.goal, each, power, task, scene, initial=first, clearance=clearance, throw=False
            )
        )
        if results[-1].status is Status.INTERRUPTED:
            raise KeyboardInterrupt
        if results[-1].status.ok:
            break
    return min(results, key=lambda result: (not result.status.ok, result.g))
