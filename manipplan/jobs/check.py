"""check: judges a trajectory, whoever made it."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np

from manipplan.collision.scene import Scene
from manipplan.constraints.constraint import Constraint, constraint_tuple
from manipplan.cost.objective import PathObjective
from manipplan.goals.goal import read_configuration
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.tolerance import BETWEEN, Tolerance
from manipplan.paths.trajectory import Trajectory
from manipplan.plans.measure import measure
from manipplan.plans.report import PathPart, Report
from manipplan.recordings.recording import read_motion
from manipplan.robots.limits import taken_to_limits
from manipplan.robots.robot import Robot
from manipplan.support.checks import ArrayLike, flag, instance, number
from manipplan.support.errors import InvalidInputError
from manipplan.support.progress import interruptible
from manipplan.support.workers import one_thread

#: Distance from a revolute joint's limits above which positions are not in radians [rad], and from a prismatic joint's above
#: which they are not in metres, as a multiple of its range.
FAR, FAR_RANGES = 2 * np.pi, 10.0
#: How many times too large velocities are whose unit, or that of the times, is wrong, and what the mistake is.
MISTAKES = {
    180 / np.pi: "velocities in degrees per second beside positions in radians",
    1e3: "times in milliseconds",
    1e6: "times in microseconds",
    1e9: "times in nanoseconds",
}
#: Largest relative difference from such a factor, and smallest correlation of given velocities with the changes of position.
NEARLY, CORRELATED = 0.02, 0.98


@interruptible()
@one_thread()
def check(
    robot: Robot,
    trajectory: Trajectory | str | Path,
    scene: Scene | None = None,
    *,
    start: ArrayLike | str | None = None,
    goal: ArrayLike | str | None = None,
    path: CartesianPath | None = None,
    path_begin: float = 0.0,
    path_parts: Sequence[PathPart] = (),
    tolerance: Tolerance | None = None,
    constraints: Sequence[Constraint] = (),
    clearance: float = 0.0,
    objective: PathObjective = PathObjective(),
    torque: bool = False,
    degrees: bool = False,
    columns: Mapping[str, str] | None = None,
) -> Report:
    """Judge a trajectory that was planned, retimed, edited, recorded, or made by other software.

    The cubic Hermite spline through its samples is judged at all times. Extremes of position, velocity, acceleration
    and jerk are exact; torque is sampled at both ends of each piece and six times between. Collisions are excluded by a proof
    for the whole motion; where the proof does not decide, by samples between which no joint moves more than 1e-3 rad or m.

    The jerk limits are checked where they are finite. A spline whose acceleration jumps exceeds every finite one; for a
    controller that does not mind, check ``robot.with_limits(jerk=np.inf)``.

    Args:
        robot: the arm.
        trajectory: a Trajectory, or the file of one: .csv, .json, .yaml or .npz, as `Trajectory.to_csv` and the others write.
            Its columns are matched with the robot's joints by their names. Where a continuous joint jumps by full turns, faster
            than five times its velocity limit, the positions without the jumps are judged.
        scene: obstacles; None: none. The arm is always checked against itself.
        start, goal: (n,) where the motion has to begin and end, to 1e-6 [rad or m], or the name of one of `robot.states`; None:
            anywhere. Outside a limit by at most `robot.limit_tolerance`, they are taken to it, as the report says. Of a goal,
            full turns of joints without limits do not count.
        path: path of the tool. The tool must not leave it, has to come past each of its poses, begin at the first and end at
            the last; the order in which it passes the others is not judged. Of a path through given poses, these are judged
            themselves: the tool has to come past each, and must not leave their polygon by more than an eighth of the piece or
            of one beside it. With an objective whose task leaves a motion of the tool free, such as Task.pointing(axis) or
            Task.position(), only the rest counts. None: the tool may move anywhere.
        path_begin: time from which the tool follows `path` [s], such as `path_begin` of a plan of `follow` with a lead-in.
        path_parts: the parts of the motion on which the tool follows `path`, where it leaves it between them: `report.along` of
            a plan of `follow` with interruptions. Together they have to cover the path; instead of `path_begin`.
        tolerance: maximum distance of the tool from `path`. Default: 0.1 mm and 1 mrad.
        constraints: what every configuration has to keep, as in `plan`; held joints keep their first value. Kept means down to
            -1e-6, proven for the whole motion but for those of your own classes, which are sampled.
        clearance: distance [m] to keep from obstacles and between the arm's own links.
        objective: power, task, measure, metric and floor of the g and the manipulability that are reported.
        torque: check the joints' effort limits as well.
        degrees: the angles of the motion are in degrees, and their velocities in degrees per second.
        columns: of a CSV file, the column of each joint and of "time", as for `Trajectory.from_csv`.

    Returns:
        The Report. A motion that does not pass raises nothing: `passed` is False, and `faults` says what is wrong.

    Raises:
        FileFormatError: the file is missing, or is not that of a trajectory.
        InvalidInputError: an argument is invalid; the trajectory has other joints, or its numbers seem to have another unit:
            positions more than a full turn outside the limits, or velocities that do not belong to the positions.
    """
    instance("robot", robot, Robot)
    motion = _motion(robot, trajectory, degrees=degrees, columns=columns)
    scene = instance("scene", scene if scene is not None else Scene(), Scene)
    ends = {name: read_configuration(name, q, robot) for name, q in (("start", start), ("goal", goal)) if q is not None}
    inside = {name: robot.configuration(name, q) for name, q in ends.items()}
    if path is not None and not isinstance(path, CartesianPath):
        raise InvalidInputError("path", path, "a CartesianPath")
    if path is None and tolerance is not None:
        raise InvalidInputError("tolerance", tolerance, "None without a path of the tool")
    along = _parts(motion, path, path_begin, path_parts)
    if tolerance is not None:
        instance("tolerance", tolerance, Tolerance)
    clearance = number("clearance", clearance, least=0.0)
    flag("torque", torque)
    report = measure(
        motion,
        scene.collision_model(robot),
        instance("objective", objective, PathObjective).integral(robot),
        start=inside.get("start"),
        goal=inside.get("goal"),
        workspace_path=path,
        along=along,
        tolerance=(tolerance or BETWEEN) if path is not None else None,
        constraints=constraint_tuple(constraints),
        clearance=clearance,
        torque=torque,
    )
    return replace(report, taken_to_limits=tuple(each for name, q in ends.items() for each in taken_to_limits(robot, name, q)))


def _parts(
    motion: Trajectory, path: CartesianPath | None, path_begin: float, path_parts: Sequence[PathPart]
) -> tuple[PathPart, ...]:
    """The parts of the motion on which the tool follows the path, which they have to cover."""
    begin = number("path_begin", path_begin, least=0.0)
    if not isinstance(path_parts, list | tuple) or not all(isinstance(part, PathPart) for part in path_parts):
        raise InvalidInputError("path_parts", path_parts, "a list of PathPart")
    for name, value in (("path_begin", begin), ("path_parts", path_parts)):
        if value and path is None:
            raise InvalidInputError(name, value, "none without a path of the tool")
    if begin >= motion.duration:
        raise InvalidInputError("path_begin", path_begin, f"a time before the end of the motion, {motion.duration:.6g} s")
    if not path_parts:
        return (PathPart(begin=begin, end=motion.duration),)
    if begin:
        raise InvalidInputError("path_begin", path_begin, "0 where path_parts tell when the path begins")
    for k, part in enumerate(path_parts):
        for name in ("begin", "end", "s_begin", "s_end"):
            number(f"path_parts[{k}].{name}", getattr(part, name), least=0.0)
    times = [time for part in path_parts for time in (part.begin, part.end)]
    steps = np.diff(times)
    if times[-1] > motion.duration * (1 + 1e-12) or (steps < 0).any() or (steps[::2] == 0).any():
        raise InvalidInputError("path_parts", times, f"increasing times from 0 to {motion.duration:.6g} s")
    shown = [(part.s_begin, part.s_end) for part in path_parts]
    first, last = shown[0][0], shown[-1][1]
    joined = all(one[1] == other[0] for one, other in pairwise(shown)) and all(begin < end for begin, end in shown)
    if not joined or abs(last - first - 1.0) > 1e-9 or first >= 1.0:
        raise InvalidInputError("path_parts", shown, "each beginning at the s where the one before ends, all together one path")
    if last > 1.0 and path is not None and not path.closes:
        raise InvalidInputError("path_parts", shown, "s from 0 to 1, as the path's last pose is not its first")
    return tuple(path_parts)


def _motion(robot: Robot, given: Trajectory | str | Path, *, degrees: bool, columns: Mapping[str, str] | None) -> Trajectory:
    """The trajectory with its columns in the robot's order, in plausible units."""
    motion = read_motion(robot, "trajectory", given, joints=None, degrees=degrees, columns=columns)
    _check_positions(robot, motion)
    _check_velocities(motion)
    return motion


def _check_positions(robot: Robot, motion: Trajectory) -> None:
    """Raise InvalidInputError for positions that are far outside the limits, as those in another unit are."""
    limits = robot.limits
    prismatic = np.array([kind == "prismatic" for kind in robot.joint_types])
    far = np.where(prismatic, FAR_RANGES * (limits.upper - limits.lower), FAR)
    outside = limits.outside(motion.q)
    if not (outside > far).any():
        return
    row, joint = (int(k) for k in np.argwhere(outside > far)[0])
    unit, other = ("m", "millimetres") if prismatic[joint] else ("rad", "degrees")
    converted = np.where(prismatic, motion.q / 1e3 if prismatic[joint] else motion.q, np.deg2rad(motion.q))
    hint = f"; all positions are inside the limits if they are in {other}" if not limits.outside(converted).any() else ""
    raise InvalidInputError(
        f"trajectory.q[{row}, {joint}] ({robot.joint_names[joint]})",
        float(motion.q[row, joint]),
        f"positions in {unit}, near the limits {limits.lower[joint]:g} to {limits.upper[joint]:g} {unit}{hint}",
    )


def _check_velocities(motion: Trajectory) -> None:
    """Raise InvalidInputError for velocities that are a known factor too large for the positions and times."""
    given = (motion.qd[1:] + motion.qd[:-1]) / 2
    needed = np.diff(motion.q, axis=0) / np.diff(motion.t)[:, None]
    product, size = float((given * needed).sum()), float((needed**2).sum())
    if product <= 0 or product < CORRELATED * np.sqrt(size * float((given**2).sum())):
        return
    factor = product / size
    for mistake, reason in MISTAKES.items():
        if abs(factor / mistake - 1) < NEARLY:
            raise InvalidInputError(
                "trajectory.qd",
                f"velocities {factor:.4g} times as large as the positions change",
                f"radians or metres, seconds, and velocities in the same units; these look like {reason}",
            )
