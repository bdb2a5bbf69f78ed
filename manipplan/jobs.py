"""The jobs: nothing but the wiring of the rooms."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from manipplan.checks import Array, instance, number, whole_number
from manipplan.errors import InvalidInputError, PlanningError
from manipplan.files import writable_folder, write_text
from manipplan.interrupts import interruptible
from manipplan.measures.task import Task
from manipplan.optimize.objective import path_cost
from manipplan.optimize.optimize import PathResult, check_task, optimize_path
from manipplan.paths.joint import JointPath
from manipplan.paths.report import Report
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.collision import CollisionModel
from manipplan.robots.robot import Robot
from manipplan.robots.scene import Scene
from manipplan.seeds.ompl import seed_path
from manipplan.status import Status
from manipplan.timing.retime import check_timing_limits, retime
from manipplan.timing.verify import limit_use
from manipplan.tracking.avoidance import Avoidance
from manipplan.tracking.controller import Controller
from manipplan.tracking.formulations import Formulation, LogDrive
from manipplan.tracking.relaxation import Stiffness, StiffnessProfile, Tolerance
from manipplan.tracking.track import HOLD, Tracking, along, follow_poses


@dataclass(frozen=True, kw_only=True)
class Plan:
    """A finished plan. With a status that failed, what could not be made is None and `message` says why.

    Attributes:
        robot, scene: what was planned for.
        status: how the path came about.
        path: the JointPath from start to goal.
        trajectory: the timed motion along it.
        report: its figures, measured on the trajectory.
        result: the optimiser's result, with seed and history; of `improve`, the motion beside the recorded one.
        tracking: what `improve` did, step by step.
        message: why it failed, when it did.
    """

    robot: Robot
    scene: Scene
    status: Status
    path: JointPath | None = None
    trajectory: Trajectory | None = None
    report: Report | None = None
    result: PathResult | None = None
    tracking: Tracking | None = None
    message: str = ""

    def save(self, folder: str | Path) -> list[Path]:
        """Write trajectory.csv, .json and .yaml (ROS), report.json, report.txt and plan.png; returns the files.

        Raises InvalidInputError when the folder cannot be written and PlanningError when there is no trajectory.
        """
        from manipplan.viz.plots import save_plan

        if self.trajectory is None or self.report is None:
            raise PlanningError(f"there is no trajectory to save: {self.status.value}", self)
        to = writable_folder("folder", folder)
        self.trajectory.to_csv(to / "trajectory.csv")
        self.trajectory.to_json(to / "trajectory.json")
        self.trajectory.to_ros(to / "trajectory.yaml")
        self.report.to_json(to / "report.json")
        write_text(to / "report.txt", f"{self.report}\n")
        save_plan(self, to / "plan.png")
        names = ("trajectory.csv", "trajectory.json", "trajectory.yaml", "report.json", "report.txt", "plan.png")
        return [to / name for name in names]


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
    say = progress or _silent
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
        return _failed(draft, throw, str(error))
    say("optimising the path")
    result = _optimised(robot, first, degree, power, task, scene, clearance)
    path = result.path or first
    draft = replace(draft, path=path, result=result, status=result.status)
    try:
        say("timing the motion")
        trajectory = retime(path, robot.limits, joint_names=robot.joint_names, torque_model=robot.model if torque else None)
    except PlanningError as error:
        return _failed(replace(draft, status=Status.NO_TIMING), throw, str(error))
    say("checking the result")
    return _checked(draft, trajectory, result, model, path.goal, clearance=clearance, torque=torque, throw=throw)


@interruptible()
def improve(
    robot: Robot,
    recorded: Trajectory | JointPath | str | Path,
    formulation: Formulation | None = None,
    *,
    dt: float = 0.01,
    duration: float | None = None,
    tolerance: Tolerance | None = Tolerance(position=0.02, rotation=0.2),  # noqa: B008
    stiffness: Stiffness | None = None,
    task: Task | None = None,
    scene: Scene | None = None,
    avoidance: Avoidance | None = None,
    throw: bool = True,
    progress: Callable[[str], None] | None = None,
) -> Plan:
    """A recorded or planned joint motion again, with a higher manipulability index, from its first to its last pose.

    The tool follows the recorded poses inside a tube, each at its time, while the formulation raises the index; the motion
    ends in the recorded last pose, in general with other joint angles. What comes out is checked as every plan.

    Args:
        robot: the arm.
        recorded: a Trajectory, the file of one (see `Trajectory.from_csv`), or a JointPath, which is timed by `retime`. A
            recording that exceeds the robot's limits is slowed down until it keeps them.
        formulation: Objective, Equality or LogDrive; default LogDrive().
        dt: time step [s].
        duration: slow the recording down, or speed it up, to this [s].
        tolerance: how far the tool may leave the recorded poses; None: as far as the stiffness lets it.
        stiffness: of the poses: a number, or a function of the share of the time. Default StiffnessProfile().
        task: rows that are followed, and whose index counts; default `robot.default_task`.
        scene: obstacles to check against, and to avoid unless `avoidance` says how.
        avoidance: what is kept away from on the way.
        throw: raise PlanningError where no motion can be had; False: return a Plan whose status says why.
        progress: called with a line of text as each step begins.

    Raises:
        InvalidInputError, FileFormatError: an argument is not usable (also with throw=False).
        PlanningError: the motion was not followed or failed its checks; its `result` is the Plan so far.
    """
    instance("robot", robot, Robot)
    scene = instance("scene", scene if scene is not None else Scene(), Scene)
    say = progress or _silent
    motion = _timed(robot, recorded, duration)
    if avoidance is None and scene.obstacles:
        avoidance = Avoidance(scene=scene)
    controller = Controller(
        robot, formulation or LogDrive(), dt, task=task, tolerance=tolerance, avoidance=avoidance, stiffness=HOLD
    )
    kinematics = robot.kinematics(controller.task)
    model = scene.collision_model(robot)
    say("following the recorded motion")
    steps = max(round(motion.duration / dt), 1)
    u = np.arange(steps + 1) / steps
    if stiffness is None:
        stiffness = StiffnessProfile()
    tracking = follow_poses(
        controller,
        robot.configuration("recorded", motion.q[0]),
        kinematics.pose(motion(u * motion.duration)),
        u,
        along(stiffness),
        (lambda _: tolerance) if tolerance is not None else None,
    )
    path, seed = tracking.trajectory().path(), motion.path()
    cost, recorded_cost = path_cost(path, kinematics, 1.0), path_cost(seed, kinematics, 1.0)
    higher = cost.min_manipulability > recorded_cost.min_manipulability or (
        tracking.manipulability.mean() > kinematics.manipulability(seed(u)).mean()
    )
    status = Status.IMPROVED if higher else Status.NOT_BETTER
    if not higher:
        path, cost = seed, recorded_cost
    result = PathResult(
        path=path,
        g=cost.g,
        length=cost.length,
        min_manipulability=cost.min_manipulability,
        min_at=cost.at,
        power=1.0,
        task=controller.task,
        seed=seed,
        seed_cost=recorded_cost,
        history=(),
        status=status,
    )
    draft = Plan(robot=robot, scene=scene, status=status, path=path, result=result, tracking=tracking)
    if higher and not tracking.status.ok:
        return _failed(replace(draft, status=Status.NOT_FOLLOWED), throw, f"{tracking.status.value}: {tracking.message}")
    say("checking the result")
    trajectory = tracking.trajectory() if higher else motion
    return _checked(draft, trajectory, result, model, trajectory.q[-1], clearance=0.0, torque=False, throw=throw)


def _timed(robot: Robot, recorded: Trajectory | JointPath | str | Path, duration: float | None) -> Trajectory:
    """The recorded motion within the robot's limits."""
    if isinstance(recorded, str | Path):
        recorded = Trajectory.from_csv(recorded)
    if isinstance(recorded, JointPath):
        recorded = retime(recorded, robot.limits, joint_names=robot.joint_names)
    motion = instance("recorded", recorded, Trajectory)
    if motion.joint_names != robot.joint_names:
        raise InvalidInputError("recorded", motion.joint_names, f"the joints of {robot.name}: {', '.join(robot.joint_names)}")
    if duration is not None:
        factor = number("duration", duration, above=0.0) / motion.duration
        motion = replace(motion, t=motion.t * factor, qd=motion.qd / factor)
    use = limit_use(motion, robot.limits)
    if use["position"].ratio > 0:
        raise InvalidInputError("recorded", use["position"].joint, "positions inside the limits, at all times")
    factor = max(use["velocity"].ratio, use["acceleration"].ratio ** 0.5, 1.0)
    return motion.slower(factor)


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
        if results[-1].status.ok:
            break
    return min(results, key=lambda result: (not result.status.ok, result.g))


def _checked(
    draft: Plan,
    trajectory: Trajectory,
    result: PathResult,
    model: CollisionModel,
    goal: Array,
    *,
    clearance: float,
    torque: bool,
    throw: bool,
) -> Plan:
    report = Report.of(trajectory, result, model, goal, clearance=clearance, torque=torque)
    finished = replace(draft, trajectory=trajectory, report=report)
    if report.passed:
        return finished
    report = replace(report, status=Status.CHECK_FAILED.value)
    return _failed(replace(finished, status=Status.CHECK_FAILED, report=report), throw, str(report))


def _silent(_: str) -> None:
    """Tell nobody."""


def _failed(plan: Plan, throw: bool, message: str) -> Plan:
    failed = replace(plan, message=message)
    if throw:
        raise PlanningError(message, failed)
    return failed
