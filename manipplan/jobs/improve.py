"""improve: a recorded motion without its noise and with higher manipulability, in the same time."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Literal, overload

from manipplan.collision.scene import Scene
from manipplan.cost.objective import PathObjective
from manipplan.optimize.result import make_result
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import Tolerance
from manipplan.paths.trajectory import Trajectory
from manipplan.plans.report import MotionFigures
from manipplan.plans.result import PartialPlan, Plan, failed, finish
from manipplan.recordings.inside import Tube, best_motion, blocked
from manipplan.recordings.recording import noise_beyond_limits, read_recording, smooth
from manipplan.robots.robot import Robot
from manipplan.support.checks import flag, instance, number
from manipplan.support.deadline import NEVER, Deadline
from manipplan.support.errors import InvalidInputError
from manipplan.support.progress import Progress, as_callback, interruptible
from manipplan.support.status import Status
from manipplan.support.workers import one_thread

#: Residual of the smooth motion that is small enough, as a share of the tolerance [rad per m or rad].
ENOUGH = 0.01


@overload
def improve(
    robot: Robot,
    recorded: Trajectory | JointPath | str | Path,
    scene: Scene | None = ...,
    *,
    duration: float | None = ...,
    tolerance: Tolerance = ...,
    objective: PathObjective = ...,
    clearance: float = ...,
    degrees: bool = ...,
    columns: Mapping[str, str] | None = ...,
    time_limit: float | None = ...,
    throw: Literal[True] = True,
    progress: Progress | None = ...,
) -> Plan: ...


@overload
def improve(
    robot: Robot,
    recorded: Trajectory | JointPath | str | Path,
    scene: Scene | None = ...,
    *,
    duration: float | None = ...,
    tolerance: Tolerance = ...,
    objective: PathObjective = ...,
    clearance: float = ...,
    degrees: bool = ...,
    columns: Mapping[str, str] | None = ...,
    time_limit: float | None = ...,
    throw: bool,
    progress: Progress | None = ...,
) -> Plan | PartialPlan: ...


@interruptible()
@one_thread()
def improve(
    robot: Robot,
    recorded: Trajectory | JointPath | str | Path,
    scene: Scene | None = None,
    *,
    duration: float | None = None,
    tolerance: Tolerance = Tolerance(position=0.02, rotation=0.2),
    objective: PathObjective = PathObjective(),
    clearance: float = 0.0,
    degrees: bool = False,
    columns: Mapping[str, str] | None = None,
    time_limit: float | None = None,
    throw: bool = True,
    progress: Progress | None = None,
) -> Plan | PartialPlan:
    """Make a recorded motion smooth and raise its manipulability, inside a tube around it and in the same time.

    The motion begins and ends in the recorded configurations: at rest, unless the recording moves there at more than 5 % of its
    largest speed. In between it is a cubic spline with continuous acceleration that lowers g and the jerk, while the tool stays
    within the tolerance of the recorded pose of the same share of the time. It is checked like every plan, and its report holds
    the `comparison` of both motions.

    The status is IMPROVED if the minimum or the mean manipulability rose by at least 0.1 %, the minimum did not fall, and
    neither g nor the jerk rose (the jerk may where `duration` is shorter than recorded). Otherwise it is NOT_BETTER, and the
    motion is the smoothed recording. Where the time limit ended the search before a better motion was found, the smoothed
    recording has the status SMOOTHED_OUT_OF_TIME.

    Args:
        robot: the arm.
        recorded: a Trajectory, the file of one, or a JointPath, which is timed by `retime` and a quarter slower. The columns of
            a CSV file are found by the names of the robot's joints, in any order; others are ignored (`Trajectory.from_csv`).
            Positions up to 0.01 rad or m, or `robot.limit_tolerance` if it is more, outside the limits count as noise, and the
            report names them. Where a continuous joint jumps by full turns, as one that is reported in (-π, π] does, the
            positions as driven count.
        scene: obstacles to avoid.
        duration: of the motion [s]; None: that of the recording.
        tolerance: largest distance of the tool from the recorded pose. What the objective's task leaves free does not count.
        objective: the objective whose g is lowered; its measure is the manipulability.
        clearance: distance [m] to keep from obstacles and between the arm's own links.
        degrees: the angles of the recording are in degrees, and their velocities in degrees per second.
        columns: of a CSV file, the column of each joint and of "time", as for `Trajectory.from_csv`.
        time_limit: time after which the search ends [s]; None: no limit. The best motion that was proven by then is returned.
            The recording without its noise is proven in any case, also if that takes longer. What is built once for a robot or
            a scene does not count.
        throw: raise PlanningError if no motion is found; False: return a PartialPlan, or a Plan with Status.CHECK_FAILED.
        progress: called with the fraction done in [0, 1] and a text.

    Raises:
        InvalidInputError, FileFormatError: an argument is invalid, also with throw=False. The message names row, joint and
            value of a recorded number, the shortest duration if the limits do not allow the one that is asked for, and the
            smallest tolerance if the noise exceeds it.
        PlanningError: the tube leaves no motion clear of collisions, none was proven in time, or the motion failed its checks;
            `result` is the Plan so far.
    """
    instance("robot", robot, Robot)
    scene = instance("scene", scene if scene is not None else Scene(), Scene)
    instance("tolerance", tolerance, Tolerance)
    instance("objective", objective, PathObjective)
    if objective.task is not None and objective.task.region is not None:
        raise InvalidInputError("objective", objective.task.name, "a task without a region: the tolerance is about each pose")
    flag("throw", throw)
    clearance = number("clearance", clearance, least=0.0)
    if duration is not None:
        duration = number("duration", duration, above=0.0)
    deadline = NEVER if time_limit is None else Deadline.within(number("time_limit", time_limit, above=0.0))
    notify = as_callback(progress)
    motion = read_recording(robot, recorded, degrees=degrees, columns=columns)
    integral, model = objective.integral(robot), scene.collision_model(robot)
    draft = PartialPlan(robot=robot, scene=scene, status=Status.NOT_FOLLOWED, tolerance=tolerance)
    notify(0.1, "smoothing the recording")
    parts = [part for part in (tolerance.position, tolerance.rotation) if part is not None]
    curve = smooth(motion, robot.limits, ENOUGH * min(parts))
    for name, end in (("recorded start", curve.ends.start), ("recorded goal", curve.ends.goal)):
        model.free_configuration(name, end, clearance)
    reason = blocked(model, motion, tolerance, integral.kinematics.task, clearance)
    if reason:
        return failed(draft, throw, f"{Status.NOT_FOLLOWED.value}: {reason}")
    tube = Tube(
        recorded=motion,
        figures=MotionFigures.of(motion, integral),
        integral=integral,
        model=model,
        tolerance=tolerance,
        clearance=clearance,
        duration=duration or motion.duration,
        deadline=deadline,
    )
    notify(0.2, "raising the manipulability")
    found = best_motion(tube, curve)
    if found is None and deadline.passed:
        return failed(replace(draft, status=Status.NOT_IN_TIME), throw, f"{Status.NOT_IN_TIME.value}; got {time_limit:g} s")
    if found is None:
        bodies, row = model.nearest_bodies(motion.q)
        return failed(draft, throw, f"{Status.NOT_FOLLOWED.value}: on the recording {bodies} at {motion.t[row]:.3f} s")
    trajectory, comparison = found.motion, found.comparison
    if found.out_of_time:
        text = f"the time limit of {time_limit:g} s ended the search; this is the best motion that was proven by then"
        draft = replace(draft, message=text)
    unchanged = Status.SMOOTHED_OUT_OF_TIME if found.out_of_time else Status.NOT_BETTER
    status = Status.IMPROVED if comparison.better else unchanged
    path, seed = trajectory.path(), motion.path()
    result = make_result(
        path,
        integral,
        cost=integral.cost(path),
        seed=seed,
        seed_cost=integral.cost(seed),
        model=model,
        clearance=clearance,
        status=status,
    )
    return finish(
        replace(draft, status=status, path=path, result=result),
        lambda: (trajectory, ()),
        goal=curve.ends.goal,
        taken=noise_beyond_limits(robot, motion),
        clearance=clearance,
        torque=False,
        throw=throw,
        notify=notify,
        begins=0.8,
        amend=lambda report, _: replace(report, comparison=comparison),
    )
