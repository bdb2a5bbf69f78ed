"""A recorded motion in the robot's joints and units; what cannot be one is named by its row, joint and value."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from manipplan.paths.export import READERS, Table, from_csv, read_trajectory
from manipplan.paths.joint import JointPath
from manipplan.paths.trajectory import JUMP, TOO_FAST, Trajectory, unwrapped
from manipplan.robots.limits import NO_DEGREES, TakenToLimit, limits_missed
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, flag
from manipplan.support.errors import InvalidInputError
from manipplan.timing.retime import retime

#: Largest distance outside a joint limit that counts as noise [rad or m].
OUTSIDE = 0.01
#: Multiple of its largest speed at which an arm was driven.
DRIVEN = 1.0
#: How much slower than the limits allow a path is timed: at the limits there is no room for smoother motions.
SLOWER = 1.25
#: Smallest motion of a joint [rad or m].
STILL = 1e-6


def read_motion(
    robot: Robot,
    argument: str,
    given: Trajectory | str | Path,
    *,
    joints: Sequence[str] | None,
    degrees: bool,
    columns: Mapping[str, str] | None,
    fastest: float = TOO_FAST,
) -> Trajectory:
    """A motion, or the file of one, with its columns in the robot's order, in rad and m, without jumps by full turns.

    `joints`, `columns`: as for `Trajectory.from_csv`; `fastest`: as for `unwrapped`. With `degrees` the angles of all revolute
    joints are converted.
    """
    degrees = flag("degrees", degrees)
    entries = ValueNames(
        argument=argument, file=Path(given) if isinstance(given, str | Path) else None, degrees=degrees, robot=robot
    )
    is_csv = isinstance(given, str | Path) and Path(given).suffix.lower() == ".csv"
    if columns is not None and not is_csv:
        raise InvalidInputError("columns", columns, "None but for a CSV file")
    if isinstance(given, str | Path):
        given = from_csv(given, joints=joints, columns=columns) if is_csv else read_trajectory(argument, given)
    if not isinstance(given, Trajectory):
        raise InvalidInputError(argument, given, f"a Trajectory, or the path of a trajectory file ({', '.join(READERS)})")
    for name in given.joint_names:
        if name in robot.locked:
            wanted = f"the joints {', '.join(robot.joint_names)} alone; {name} is locked at {robot.locked[name]:g}"
            raise InvalidInputError(f"{argument}.joint_names", name, wanted)
    motion = given.in_order(robot.joint_names)
    if degrees:
        scale = np.where([kind == "prismatic" for kind in robot.joint_types], 1.0, np.pi / 180)
        motion = replace(motion, q=motion.q * scale, qd=motion.qd * scale)

    def place(row: int, joint: int) -> tuple[str, float]:
        return entries.name(row, joint), entries.value(float(motion.q[row, joint]), joint)

    return unwrapped(robot, motion, place, fastest=fastest)


def read_recording(
    robot: Robot,
    recorded: Trajectory | JointPath | str | Path,
    *,
    degrees: bool,
    columns: Mapping[str, str] | None = None,
) -> Trajectory:
    """The recorded motion, its columns in the robot's order; see `improve`."""
    file = Path(recorded) if isinstance(recorded, str | Path) else None
    if isinstance(recorded, JointPath):
        if flag("degrees", degrees):
            raise InvalidInputError("degrees", degrees, "False with a JointPath, which is in radians")
        if recorded.n != robot.n:
            raise InvalidInputError(
                "recorded", f"a path of {recorded.n} joints", f"a path of the {robot.n} joints of {robot.name}"
            )
        recorded = retime(recorded, robot).slower(SLOWER)
    motion = read_motion(
        robot, "recorded", recorded, joints=robot.joint_names, degrees=degrees, columns=columns, fastest=DRIVEN
    )
    _check(robot, motion, ValueNames(argument="recorded", file=file, degrees=degrees, robot=robot))
    return motion


def noise_beyond_limits(robot: Robot, motion: Trajectory) -> tuple[TakenToLimit, ...]:
    """The joints of a recording that are outside a limit, where they are farthest."""
    outside = robot.limits.outside(motion.q)
    rows = outside.argmax(axis=0)
    return tuple(
        TakenToLimit.of(robot, f"recorded.q[{rows[joint]}, {joint}]", joint, float(motion.q[rows[joint], joint]))
        for joint in np.flatnonzero(outside.max(axis=0) > 0).tolist()
    )


class ValueNames:
    """Names and values of single numbers of a motion, as its user gave them."""

    def __init__(self, *, argument: str, file: Path | None, degrees: bool, robot: Robot) -> None:
        self.argument, self.file, self.robot = argument, file, robot
        self.degrees = np.array([degrees and kind != "prismatic" for kind in robot.joint_types])

    def name(self, row: int, joint: int) -> str:
        """Name of a position."""
        name = self.robot.joint_names[joint]
        if self.file is None or self.file.suffix.lower() != ".csv":
            return f"{self.argument}.q[{row}, {joint}] ({name})"
        return f"{self.argument}: {self.file}, row {Table.read(self.file).rows[row][0]}, {name}"

    def value(self, q: float, joint: int) -> float:
        """A position in the unit of the recording."""
        return float(np.rad2deg(q)) if self.degrees[joint] else float(q)


def _check(robot: Robot, motion: Trajectory, entries: ValueNames) -> None:
    """Raise InvalidInputError for positions that the robot cannot have had, or that do not change."""
    limits, names = robot.limits, robot.joint_names
    outside, allowed = limits.outside(motion.q), max(OUTSIDE, robot.limit_tolerance)
    if (outside > allowed).any():
        row, joint = (int(k) for k in np.argwhere(outside > allowed)[0])
        far = bool((outside > NO_DEGREES).any())
        prismatic = robot.joint_types[joint] == "prismatic"
        unit = "m" if prismatic else "rad"
        hint = ""
        if entries.degrees[joint] and not limits.outside(np.rad2deg(motion.q)).any():
            hint = "; all positions are inside the limits if they are in radians: leave degrees=True (--degrees) out"
        if far and not prismatic and not entries.degrees.any() and not limits.outside(_from_degrees(robot, motion.q)).any():
            hint = "; all positions are inside the limits if they are in degrees: say degrees=True (--degrees)"
        value, low, high = (entries.value(each[joint], joint) for each in (motion.q[row], limits.lower, limits.upper))
        missed = limits_missed(low, high, value, "°" if entries.degrees[joint] else unit)
        raise InvalidInputError(entries.name(row, joint), value, f"positions inside the limits {missed}{hint}")
    step = np.abs(np.diff(motion.q, axis=0))
    jumps = (step > JUMP) & (step > TOO_FAST * limits.velocity * np.diff(motion.t)[:, None])
    if jumps.any():
        row, joint = (int(k) for k in np.argwhere(jumps)[0])
        raise InvalidInputError(
            entries.name(row + 1, joint),
            entries.value(motion.q[row + 1, joint], joint),
            f"a position that {names[joint]} reaches at {limits.velocity[joint]:g} per second from "
            f"{entries.value(motion.q[row, joint], joint):g}, {1e3 * float(motion.t[row + 1] - motion.t[row]):.4g} ms before",
        )
    if np.ptp(motion.q, axis=0).max() < STILL:
        raise InvalidInputError("recorded", "a motion in which no joint moves", "a motion")


def _from_degrees(robot: Robot, q: Array) -> Array:
    """Positions with those of the revolute joints taken as degrees."""
    return np.where([kind == "prismatic" for kind in robot.joint_types], q, np.deg2rad(q))
