"""improve: repeats a recorded motion with higher manipulability."""

from dataclasses import replace
from pathlib import Path
from typing import Literal, overload

import numpy as np

from manipplan.collision.scene import Scene
from manipplan.cost.objective import PathObjective
from manipplan.jobs.result import PartialPlan, Plan, failed, finish
from manipplan.optimize.result import make_result
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import Stiffness, StiffnessProfile, Tolerance
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.robot import Robot
from manipplan.support.checks import instance, number
from manipplan.support.errors import InvalidInputError
from manipplan.support.interrupts import interruptible
from manipplan.support.progress import Progress, teller
from manipplan.support.status import Status
from manipplan.timing.retime import retime
from manipplan.timing.verify import limit_use
from manipplan.tracking.avoidance import Avoidance
from manipplan.tracking.controller import Controller
from manipplan.tracking.formulations import Formulation, LogDrive
from manipplan.tracking.track import HOLD, along, follow_poses, step_count


@overload
def improve(
    robot: Robot,
    recorded: Trajectory | JointPath | str | Path,
    scene: Scene | None = ...,
    *,
    formulation: Formulation | None = ...,
    objective: PathObjective = ...,
    dt: float = ...,
    duration: float | None = ...,
    tolerance: Tolerance | None = ...,
    stiffness: Stiffness | None = ...,
    avoidance: Avoidance | None = ...,
    throw: Literal[True] = True,
    progress: Progress | None = ...,
) -> Plan: ...


@overload
def improve(
    robot: Robot,
    recorded: Trajectory | JointPath | str | Path,
    scene: Scene | None = ...,
    *,
    formulation: Formulation | None = ...,
    objective: PathObjective = ...,
    dt: float = ...,
    duration: float | None = ...,
    tolerance: Tolerance | None = ...,
    stiffness: Stiffness | None = ...,
    avoidance: Avoidance | None = ...,
    throw: bool,
    progress: Progress | None = ...,
) -> Plan | PartialPlan: ...


@interruptible()
def improve(
    robot: Robot,
    recorded: Trajectory | JointPath | str | Path,
    scene: Scene | None = None,
    *,
    formulation: Formulation | None = None,
    objective: PathObjective = PathObjective(),
    dt: float = 0.01,
    duration: float | None = None,
    tolerance: Tolerance | None = Tolerance(position=0.02, rotation=0.2),
    stiffness: Stiffness | None = None,
    avoidance: Avoidance | None = None,
    throw: bool = True,
    progress: Progress | None = None,
) -> Plan | PartialPlan:
    """Repeat a recorded or planned joint motion with higher manipulability, from its first to its last pose.

    The tool follows the recorded poses inside a tube, each at its time, while the formulation raises manipulability; the
    motion ends in the last recorded pose, in general with other joint angles. The result is checked like every plan.

    Args:
        robot: the arm.
        recorded: a Trajectory, the file of one (see `Trajectory.from_csv`), or a JointPath, which is timed by `retime`. A
            recording that exceeds the robot's limits is slowed down until it keeps them.
        scene: obstacles to check against, and to avoid if `avoidance` is not given.
        formulation: Objective, Equality or LogDrive of `manipplan.formulations`; default LogDrive().
        objective: its task is tracked, default `robot.default_task`; its measure is raised; power, metric and floor only count
            in the g that is reported.
        dt: time step [s].
        duration: new duration of the recording, slower or faster [s].
        tolerance: maximum deviation of the tool from the recorded poses; None: limited only by the stiffness.
        stiffness: of the poses: a number, or a function of the share of the time. Default StiffnessProfile().
        avoidance: collision avoidance on the way.
        throw: raise PlanningError if no motion is found; False: return a PartialPlan, or a Plan with Status.CHECK_FAILED.
        progress: called with the fraction done in [0, 1] and a text.

    Raises:
        InvalidInputError, FileFormatError: an argument is invalid (also with throw=False).
        PlanningError: the motion was not followed or failed its checks; its `result` is the Plan so far.
    """
    instance("robot", robot, Robot)
    scene = instance("scene", scene if scene is not None else Scene(), Scene)
    instance("objective", objective, PathObjective)
    tell = teller(progress)
    motion = _timed(robot, recorded, duration)
    if avoidance is None and scene.obstacles:
        avoidance = Avoidance(scene=scene)
    controller = Controller(
        robot,
        formulation or LogDrive(),
        dt=dt,
        task=objective.task,
        measure=objective.measure,
        tolerance=tolerance,
        avoidance=avoidance,
        stiffness=HOLD,
    )
    integral = replace(objective, task=controller.task).integral(robot)
    kinematics = integral.kinematics
    model = scene.collision_model(robot)
    tell(0.1, "following the recorded motion")
    steps = step_count(float(np.round(motion.duration / dt)))
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
    cost, recorded_cost = integral.cost(path), integral.cost(seed)
    higher = cost.min_manipulability > recorded_cost.min_manipulability or (
        tracking.manipulability.mean() > kinematics.manipulability(seed(u)).mean()
    )
    status = Status.IMPROVED if higher else Status.NOT_BETTER
    result = make_result(
        path if higher else seed,
        integral,
        cost=cost if higher else recorded_cost,
        seed=seed,
        seed_cost=recorded_cost,
        model=model,
        clearance=0.0,
        status=status,
    )
    draft = PartialPlan(
        robot=robot,
        scene=scene,
        status=status,
        path=result.path,
        result=result,
        tracking=tracking,
        tolerance=tolerance,
    )
    if higher and not tracking.status.ok:
        return failed(replace(draft, status=Status.NOT_FOLLOWED), throw, f"{Status.NOT_FOLLOWED.value} ({tracking.message})")
    tell(0.8, "checking the result")
    trajectory = tracking.trajectory() if higher else motion
    made = finish(
        draft, result.path, trajectory, result, model, trajectory.q[-1], clearance=0.0, torque=False, jerk=False, throw=throw
    )
    tell(1.0, "done")
    return made


def _timed(robot: Robot, recorded: Trajectory | JointPath | str | Path, duration: float | None) -> Trajectory:
    """The recorded motion within the robot's limits."""
    if isinstance(recorded, str | Path):
        recorded = Trajectory.from_csv(recorded)
    if isinstance(recorded, JointPath):
        recorded = retime(recorded, robot)
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
