"""Trajectory: motion q(t) in time, piecewise cubic through samples of position and velocity, also in files.

Jumps of a full turn between the samples of a motion, where the positions of a joint were reported in (-π, π].
"""

import csv
import io
import json
import logging
import tokenize
import zipfile
import zlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import yaml
from numpy.typing import NDArray

from manipplan.paths.joint import MOST_ORDER, JointPath
from manipplan.paths.table import Table
from manipplan.robots.robot import Robot
from manipplan.support.checks import (
    Array,
    ArrayLike,
    distinct_names,
    existing_file,
    finite_array,
    number,
    number_array,
    one_of,
    text,
    texts,
    whole_number,
)
from manipplan.support.data_files import read_json, read_yaml
from manipplan.support.display import Pictured, one_line
from manipplan.support.errors import FileFormatError, InvalidInputError, UnknownNameError
from manipplan.support.files import write_bytes, write_text
from manipplan.support.memo import content_key

log = logging.getLogger("manipplan")

#: Shortest time between samples [s], and largest time [s], position [rad or m] and velocity [rad/s or m/s]: beyond these the
#: coefficients of the cubics overflow.
SHORTEST, LARGEST = 1e-12, 1e12
FORMAT = "manipplan-trajectory"
VERSION = 1
#: Maximum duration [s]: ROS counts seconds in 32 bits, and the first message of a bag is stamped 1 s.
LONGEST = 2**31 - 2
#: Maximum size of an unpacked NumPy archive [bytes].
LARGEST_NPZ = 2**27
#: Keys of a JointTrajectory, and of its points.
ROS_KEYS = ("header", "joint_names", "points")
POINT_KEYS = ("positions", "velocities", "accelerations", "effort", "time_from_start")


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class Trajectory(Pictured):
    """The cubic Hermite spline through samples, as joint trajectory controllers interpolate positions and velocities.

    Attributes:
        t: (k,) sample times [s], increasing from 0, k >= 2.
        q: (k, n) positions [rad or m].
        qd: (k, n) velocities [rad/s or m/s].
        joint_names: (n,) names in the order of the columns.

    Raises InvalidInputError, which names the sample and the joint, when times do not increase from 0 or a number is not finite.
    """

    t: Array
    q: Array
    qd: Array
    joint_names: tuple[str, ...]

    def __post_init__(self) -> None:
        t = _finite_samples("t", self.t, (None,))
        names = distinct_names("joint_names", self.joint_names, (number_array("q", self.q).shape or (0,))[-1])
        if len(t) < 2 or t[0] != 0:
            raise InvalidInputError("t", t, "at least two times, increasing from 0")
        if (np.diff(t) <= 0).any():
            k = int(np.argmax(np.diff(t) <= 0)) + 1
            raise InvalidInputError(f"t[{k}]", float(t[k]), f"a time after t[{k - 1}] = {float(t[k - 1])!r} s")
        if not (np.diff(t) >= SHORTEST).all() or t[-1] > LARGEST:
            raise InvalidInputError("t", t, f"times at least {SHORTEST:g} s apart, up to {LARGEST:g} s")
        shape = (len(t), len(names))
        object.__setattr__(self, "t", t)
        object.__setattr__(self, "q", _finite_samples("q", self.q, shape, names))
        object.__setattr__(self, "qd", _finite_samples("qd", self.qd, shape, names))
        object.__setattr__(self, "joint_names", names)

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.joint_names)

    @property
    def duration(self) -> float:
        """Time from first to last sample [s]."""
        return float(self.t[-1])

    @property
    def digest(self) -> str:
        """SHA-256 of samples and joint names, in hexadecimal digits: different for every other motion."""
        return content_key([self.t, self.q, self.qd, self.joint_names])

    def in_order(self, joint_names: Sequence[str]) -> "Trajectory":
        """The same motion with its columns in the order of these names.

        Raises UnknownNameError for a joint of the motion that is not among them, and InvalidInputError where one is missing.
        """
        joint_names = texts("joint_names", joint_names)
        if self.joint_names == joint_names:
            return self
        for name in self.joint_names:
            if name not in joint_names:
                raise UnknownNameError("trajectory.joint_names", name, joint_names)
        missing = [name for name in joint_names if name not in self.joint_names]
        if missing:
            wanted = f"a motion of the joints {', '.join(joint_names)}; {', '.join(missing)} is missing"
            raise InvalidInputError("trajectory.joint_names", ", ".join(self.joint_names), wanted)
        column = [self.joint_names.index(name) for name in joint_names]
        return replace(self, q=self.q[:, column], qd=self.qd[:, column], joint_names=tuple(joint_names))

    def named(self, joint_names: Sequence[str] | None) -> "Trajectory":
        """The same motion with other names of its joints, such as those of a controller, in the order of its columns."""
        if joint_names is None:
            return self
        return replace(self, joint_names=distinct_names("joint_names", joint_names, self.n))

    def segments(self) -> tuple[Array, Array]:
        """Widths (k - 1,) [s] and cubic coefficients (4, k - 1, n), lowest power first, in time from the segment's start."""
        h = np.diff(self.t)[:, None]
        step = np.diff(self.q, axis=0) / h
        first, last = self.qd[:-1], self.qd[1:]
        second = (3 * step - 2 * first - last) / h
        third = (first + last - 2 * step) / h**2
        return h[:, 0], np.stack([self.q[:-1], first, second, third])

    def __call__(self, t: ArrayLike, order: int = 0) -> Array:
        """q(t), or its derivative of the given order; t (...) in [0, duration] gives (..., n).

        The second derivative jumps at samples; there the value is that of the segment to the right.
        """
        t = number_array("t", t)
        if not ((t >= 0) & (t <= self.duration)).all():
            raise InvalidInputError("t", t, f"times from 0 to {self.duration:g} s")
        order = whole_number("order", order, least=0, most=MOST_ORDER)
        segment = np.clip(np.searchsorted(self.t, t, side="right") - 1, 0, len(self.t) - 2)
        coefficients = self.segments()[1]
        for _ in range(order):
            powers = np.arange(1, len(coefficients))[:, None, None]
            coefficients = powers * coefficients[1:]
        u = (t - self.t[segment])[..., None]
        value = np.zeros((*t.shape, self.n))
        for coefficient in coefficients[::-1]:
            value = value * u + coefficient[segment]
        return value

    def path(self) -> JointPath:
        """The same curve over s = t / duration, as a JointPath of cubic pieces."""
        h = np.diff(self.t)[:, None]
        control = np.stack(
            [self.q[:-1], self.q[:-1] + h * self.qd[:-1] / 3, self.q[1:] - h * self.qd[1:] / 3, self.q[1:]], axis=1
        )
        breaks = self.t / self.duration
        breaks[-1] = 1.0
        return JointPath(breaks=breaks, control=control)

    def slower(self, factor: float) -> "Trajectory":
        """The same motion in `factor` (>= 1) times the time; sample times in whole nanoseconds."""
        factor = number("factor", factor, least=1.0)
        t: Array = np.round(self.t * factor, 9)
        return Trajectory(t=t, q=self.q, qd=self.qd / factor, joint_names=self.joint_names)

    def to_csv(self, file: str | Path, *, joint_names: Sequence[str] | None = None) -> None:
        """Write one row per sample as CSV: time [s], q_<joint> [rad or m], qd_<joint>, qdd_<joint>; all digits.

        `joint_names`: the controller's names of the joints, as in `named`.
        """
        names = self.named(joint_names).joint_names
        out = io.StringIO()
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(["time", *(f"{kind}_{name}" for kind in ("q", "qd", "qdd") for name in names)])
        rows = np.column_stack([self.t, self.q, self.qd, self(self.t, 2)])
        writer.writerows([[repr(float(value)) for value in row] for row in rows])
        write_text(file, out.getvalue())

    def to_json(self, file: str | Path) -> None:
        """Write the samples as JSON: an object with format, version, joint_names, time, position and velocity."""
        data = {
            "format": FORMAT,
            "version": VERSION,
            "joint_names": list(self.joint_names),
            "time": self.t.tolist(),
            "position": self.q.tolist(),
            "velocity": self.qd.tolist(),
        }
        write_text(file, json.dumps(data) + "\n")

    def to_ros(self, file: str | Path, *, joint_names: Sequence[str] | None = None) -> None:
        """Write a ROS trajectory_msgs/JointTrajectory in YAML; its stamp is zero, which means "start immediately".

        `joint_names`: the controller's names of the joints, as in `named`.
        """
        times = [ros_time(nanoseconds) for nanoseconds in nanoseconds_of(self)]
        columns = [each.tolist() for each in (self.q, self.qd, self(self.t, 2))]
        points = [dict(zip(POINT_KEYS, (*row, [], time), strict=True)) for *row, time in zip(*columns, times, strict=True)]
        header = {"stamp": ros_time(0), "frame_id": ""}
        message = {"header": header, "joint_names": list(self.named(joint_names).joint_names), "points": points}
        dumper: Any = getattr(yaml, "CSafeDumper", yaml.SafeDumper)
        write_text(file, yaml.dump(message, Dumper=dumper, sort_keys=False, default_flow_style=None, width=1000))

    def to_npz(self, file: str | Path) -> None:
        """Write a NumPy archive with t, q, qd and joint_names."""
        names = np.array(self.joint_names)
        write_bytes(file, lambda stream: np.savez(stream, t=self.t, q=self.q, qd=self.qd, joint_names=names))

    def to_urscript(
        self,
        file: str | Path,
        *,
        rate: int = 500,
        name: str = "manipplan_motion",
        lookahead_time: float = 0.1,
        gain: float = 300.0,
        joint_names: Sequence[str] | None = None,
    ) -> None:
        """Write a URScript program that follows the motion by one servoj for each cycle of the controller.

        The program halts with a message unless every joint is within 0.01 rad of the first position.

        Args:
            file: where it is written.
            rate: 500 for e-Series, 125 for CB3 [Hz].
            name: of the function in the script.
            lookahead_time, gain: of servoj, 0.03 to 0.2 s and 100 to 2000.
            joint_names: the controller's names of this motion's joints, as in `named`.

        The joints are found by their names, as in ur_description, in any order.

        Raises InvalidInputError: other joints, a motion that does not begin and end at rest, joint values beyond 2 π, a speed
        above 2 π rad/s, more than 300,000 positions, or another argument is out of its range.
        """
        from manipplan.paths import controllers

        controllers.to_urscript(self.named(joint_names), file, rate=rate, name=name, lookahead_time=lookahead_time, gain=gain)

    def to_franka_csv(self, file: str | Path, *, joint_names: Sequence[str] | None = None) -> None:
        """Write a CSV table of time [s] and the seven joint positions [rad] at 1 kHz, for a Franka arm.

        `joint_names`: the controller's names of this motion's joints, as in `named`.

        The joints are found by their names, in any order: panda_joint1 to 7 or fer_joint1 to 7 of a Panda, fr3_joint1 to 7 of a
        Franka Research 3, whose largest velocity falls to zero towards its position limits.

        Raises InvalidInputError: other joints, positions outside the arm's limits, a motion that does not begin and end at
        rest or has more than 300,000 positions, or differences of neighbouring positions above the velocity, acceleration or
        jerk that libfranka accepts for that arm.
        """
        from manipplan.paths import controllers

        controllers.to_franka_csv(self.named(joint_names), file)

    def to_rosbag(
        self, file: str | Path, *, storage: str = "mcap", rate: float = 100.0, joint_names: Sequence[str] | None = None
    ) -> None:
        """Write a ROS 2 bag for `ros2 bag play`, rviz and Foxglove: the motion as a JointTrajectory and as JointStates.

        Args:
            file: folder of the bag; it must not exist yet.
            storage: "mcap" or "sqlite3".
            rate: of the JointStates [Hz]; each sample gets one as well.
            joint_names: the controller's names of this motion's joints, as in `named`.

        Raises:
            InvalidInputError: the folder exists or cannot be written, or another argument is not usable.
            MissingExtraError: rosbags is not installed.
        """
        from manipplan.paths import rosbag

        rosbag.to_rosbag(self.named(joint_names), file, storage=storage, rate=rate)

    @classmethod
    def from_rosbag(cls, file: str | Path, topic: str | None = None, *, joints: Sequence[str] | None = None) -> "Trajectory":
        """Read a recorded motion from a ROS bag: JointStates, or one JointTrajectory.

        Velocities that were not recorded come from the cubic spline through the positions.

        Args:
            file: the folder of a ROS 2 bag, or a ROS 1 .bag file.
            topic: its name; default: the only one with JointStates, else the only one with a JointTrajectory.
            joints: names to read, in this order, such as `robot.joint_names`. Default: all of the first message, in its order.

        Raises:
            FileFormatError: not a bag, stamps that do not increase, a joint without a position.
            InvalidInputError: no such topic or joint; several topics fit.
            MissingExtraError: rosbags is not installed.
        """
        from manipplan.paths import rosbag

        return rosbag.from_rosbag(file, topic, joints=joints)

    @classmethod
    def from_csv(
        cls,
        file: str | Path,
        *,
        joints: Sequence[str] | None = None,
        columns: Mapping[str, str] | None = None,
        degrees: bool | Sequence[str] = False,
    ) -> "Trajectory":
        """Read what `to_csv` wrote, or a recorded log. Columns are found by name, in any order; others are ignored.

        Args:
            file: its first line names the columns: `time` or `t` [s], `q_<joint>` [rad or m], and `qd_<joint>` for all joints
                or none. Without velocities they come from the cubic spline through the positions. Times count from that of the
                first row.
            joints: names to read, in this order, such as `robot.joint_names`; their columns may lack the `q_`. Default: those
                of `columns`, or all `q_<joint>` columns, in their order.
            columns: the column of the file for each joint, and for "time", where it has another name:
                ``{"time": "timestamp", "shoulder_pan_joint": "J1"}``.
            degrees: whether angles are in degrees; or the names of the joints whose are, where others are slides.

        Raises FileFormatError, which names the column or the row that is wrong: one that has more or fewer cells than the
        first, a cell that is not a finite number, or a time that is not after the one before.
        """
        path = existing_file("file", file)
        wanted = "a CSV with columns time, q_<joint>... (qd_<joint>... and others may follow, in any order)"
        if columns is not None and not isinstance(columns, Mapping):
            raise InvalidInputError("columns", columns, 'a mapping from names of joints, and "time", to columns of the file')
        where = {text("columns", key): text(f"columns[{key!r}]", column) for key, column in (columns or {}).items()}
        chosen = None if joints is None else texts("joints", joints)
        table = Table.read(path)
        names = chosen or tuple(name for name in where if name != "time") or _joints_of(table, wanted)
        for name in where:
            one_of("columns", name, ("time", *names))
        scaled = names if degrees is True else () if degrees is False else texts("degrees", degrees)
        for name in scaled:
            one_of("degrees", name, names)

        def named(name: str) -> tuple[str, ...]:
            return (where[name],) if name in where else (f"q_{name}", name) if joints is not None else (f"q_{name}",)

        positions = [table.column(named(name), wanted) for name in names]
        has_speeds = any(f"qd_{name}" in table.header for name in names)
        velocities = [table.column((f"qd_{name}",), wanted) for name in names] if has_speeds else []
        time = table.column((where["time"],) if "time" in where else ("time", "t"), wanted)
        if len(table.rows) < 2:
            raise FileFormatError("file", f"{path} with {len(table.rows)} rows of numbers", "at least two")
        data = table.numbers([time, *positions, *velocities])
        for k in np.flatnonzero(np.diff(data[:, 0]) <= 0).tolist():
            later = f"a time after that of row {table.rows[k][0]}, {float(data[k, 0])!r} s"
            raise FileFormatError("file", f"{table.name_cell(k + 1, time)}: {table.rows[k + 1][1][time]}", later)
        scale = np.where(np.isin(names, scaled), np.pi / 180, 1.0)
        q = data[:, 1 : 1 + len(names)] * scale
        qd = data[:, 1 + len(names) :] * scale if velocities else None
        with _reading(path, wanted):
            return with_velocities(data[:, 0] - data[0, 0], q, qd, names)

    @classmethod
    def from_json(cls, file: str | Path) -> "Trajectory":
        """Read what `to_json` wrote. Raises FileFormatError for another format or version."""
        path = existing_file("file", file)
        wanted = f"a JSON object with format {FORMAT!r} and version {VERSION}"
        with _reading(path, wanted):
            data = read_json("file", path)
            if not isinstance(data, dict) or (data.get("format"), data.get("version")) != (FORMAT, VERSION):
                raise FileFormatError("file", str(path), wanted)
            for key in data:
                one_of("key", key, ("format", "version", "joint_names", "time", "position", "velocity"))
            return cls(t=data["time"], q=data["position"], qd=data["velocity"], joint_names=data["joint_names"])

    @classmethod
    def from_ros(cls, file: str | Path) -> "Trajectory":
        """Read a JointTrajectory in YAML; velocities that it lacks come from the cubic spline through the positions.

        Raises FileFormatError when names, positions or times are missing, or a key is none of the message's.
        """
        path = existing_file("file", file)
        wanted = "a JointTrajectory in YAML: joint_names and points with positions and time_from_start"
        with _reading(path, wanted):
            message = read_yaml("file", path)
            if not isinstance(message, Mapping) or not isinstance(message.get("points"), list):
                raise FileFormatError("file", str(path), wanted)
            for key in message:
                one_of("key", key, ROS_KEYS)
            points, names = message["points"], texts("joint_names", message.get("joint_names"))
            for k, point in enumerate(points):
                if not isinstance(point, Mapping) or not {"positions", "time_from_start"} <= set(point):
                    raise InvalidInputError(f"points[{k}]", point, "a mapping with positions and time_from_start")
                for key in point:
                    one_of(f"points[{k}]", key, POINT_KEYS)
            timed = [bool(point.get("velocities")) for point in points]  # [] where there are none, as in ROS
            if any(timed) and not all(timed):
                k = timed.index(False)
                raise InvalidInputError(
                    f"points[{k}].velocities", points[k].get("velocities"), "velocities in all points or in none"
                )
            t = np.array([_seconds(point["time_from_start"]) for point in points])
            qd = [point["velocities"] for point in points] if any(timed) else None
            return with_velocities(t, [point["positions"] for point in points], qd, names)

    @classmethod
    def from_npz(cls, file: str | Path) -> "Trajectory":
        """Read what `to_npz` wrote. Raises FileFormatError for another archive, or one of more than 2^27 bytes unpacked."""
        path = existing_file("file", file)
        wanted = "a NumPy archive with t, q, qd and joint_names"
        with _reading(path, wanted):
            with zipfile.ZipFile(path) as archive:
                size = sum(each.file_size for each in archive.infolist())
            if size > LARGEST_NPZ:
                raise FileFormatError(
                    "file", f"{path} with {size:,} bytes of numbers", f"{wanted}, of at most {LARGEST_NPZ:,} bytes"
                )
            with np.load(path, allow_pickle=False) as data:
                return cls(t=data["t"], q=data["q"], qd=data["qd"], joint_names=tuple(data["joint_names"].tolist()))


def with_velocities(t: Array, q: Any, qd: Any, joint_names: tuple[str, ...]) -> Trajectory:
    """The trajectory of samples; velocities that are not given come from the cubic spline through the positions."""
    if qd is not None:
        return Trajectory(t=t, q=q, qd=qd, joint_names=joint_names)
    from scipy.interpolate import CubicSpline

    still = Trajectory(t=t, q=q, qd=np.zeros(np.shape(q)), joint_names=joint_names)  # checks times and positions
    return replace(still, qd=CubicSpline(still.t, still.q)(still.t, 1))


def _joints_of(table: Table, wanted: str) -> tuple[str, ...]:
    """The joints that have a column of positions."""
    names = tuple(column.removeprefix("q_") for column in table.header if column.startswith("q_"))
    if not names or not all(names):
        raise FileFormatError("file", f"{table.path} with the first line {','.join(table.header)}", wanted)
    return names


def nanoseconds_of(trajectory: Trajectory) -> list[int]:
    """The sample times in whole nanoseconds, as ROS stores them.

    Raises InvalidInputError when two of them become equal, or when they are too large for ROS.
    """
    if trajectory.duration > LONGEST:
        raise InvalidInputError("trajectory.t", trajectory.duration, f"times up to {LONGEST} s: ROS counts seconds in 32 bits")
    stamps = [round(t * 1e9) for t in trajectory.t.tolist()]
    for before, after, t in zip(stamps, stamps[1:], trajectory.t[1:].tolist(), strict=False):
        if after <= before:
            raise InvalidInputError("trajectory.t", t, "times that differ after ROS's rounding to whole nanoseconds")
    return stamps


def ros_time(nanoseconds: int) -> dict[str, int]:
    """The fields of ROS's Time and Duration."""
    return {"sec": nanoseconds // 10**9, "nanosec": nanoseconds % 10**9}


def _seconds(stamp: Mapping[str, Any]) -> float:
    """ROS's Duration in seconds."""
    sec = whole_number("time_from_start.sec", stamp["sec"], least=0, most=2**31 - 1)
    nanosec = whole_number("time_from_start.nanosec", stamp["nanosec"], least=0, most=10**9 - 1)
    return (sec * 10**9 + nanosec) / 1e9


@contextmanager
def _reading(path: Path, wanted: str) -> Iterator[None]:
    """An exception of the libraries that read a file becomes a FileFormatError."""
    try:
        yield
    except FileFormatError:
        raise
    except InvalidInputError as error:
        raise FileFormatError("file", str(path), f"{wanted}; {error}") from error
    except (
        ArithmeticError,
        AttributeError,
        EOFError,
        LookupError,
        MemoryError,
        OSError,
        RuntimeError,  # an encrypted archive, an unknown compression, nesting that is too deep
        SyntaxError,  # a damaged array header, or a zero byte in it
        TypeError,
        ValueError,
        csv.Error,
        tokenize.TokenError,
        zipfile.BadZipFile,
        zlib.error,
    ) as error:
        reason = " ".join(f"{type(error).__name__}: {error}".split())[:160]
        raise FileFormatError("file", str(path), f"{wanted} ({reason})") from error


#: Readers of trajectory files, by file extension.
READERS = {
    ".csv": Trajectory.from_csv,
    ".json": Trajectory.from_json,
    ".yaml": Trajectory.from_ros,
    ".yml": Trajectory.from_ros,
    ".npz": Trajectory.from_npz,
}


def read_trajectory(argument: str, file: str | Path) -> Trajectory:
    """Read a trajectory file by its extension. Raises FileFormatError for another extension, and as its reader does."""
    read = READERS.get(Path(file).suffix.lower())
    if read is None:
        raise FileFormatError(argument, str(file), f"a trajectory file: {', '.join(READERS)}")
    return read(file)


def _finite_samples(argument: str, value: ArrayLike, shape: tuple[int | None, ...], names: Sequence[str] = ()) -> Array:
    """`value` as a read-only array; what is not finite is named by its sample and its joint."""
    array = number_array(argument, value)
    wrong = np.argwhere(~np.isfinite(array))
    if array.ndim == len(shape) and len(wrong):
        joint = f" ({names[wrong[0, 1]]})" if array.ndim == 2 and wrong[0, 1] < len(names) else ""
        index = ", ".join(map(str, wrong[0]))
        raise InvalidInputError(f"{argument}[{index}]{joint}", float(array[tuple(wrong[0])]), "a finite number, no NaN or inf")
    return finite_array(argument, array, shape, most=LARGEST if names else np.inf)


def joined(parts: Sequence[Trajectory]) -> Trajectory:
    """Concatenate trajectories, each of which begins where the previous one ends."""
    if len(parts) == 1:
        return parts[0]
    t, q, qd = [parts[0].t], [parts[0].q], [parts[0].qd]
    for part in parts[1:]:
        t.append(part.t[1:] + t[-1][-1])
        q.append(part.q[1:])
        qd.append(part.qd[1:])
    return Trajectory(t=np.concatenate(t), q=np.concatenate(q), qd=np.concatenate(qd), joint_names=parts[0].joint_names)


#: Largest step between two samples that noise makes [rad or m], and the multiple of a joint's largest speed that no motion has.
JUMP, TOO_FAST = 0.05, 5.0


def unwrapped(
    robot: Robot, motion: Trajectory, describe: Callable[[int, int], tuple[str, float]], *, fastest: float
) -> Trajectory:
    """The motion as it was driven, where continuous joints jump by full turns from one sample to the next.

    A step of more than half a turn is such a jump where the joint cannot move so far in the time between the samples, but can
    without the full turns. Velocities that belong to the jump, as those of a spline through it do, are replaced by those of the
    cubic spline through the positions as driven.

    Args:
        robot: its joints are the columns of the motion.
        motion: as recorded.
        describe: name and value of a position, by its row and joint, for messages.
        fastest: multiple of its largest speed beyond which a joint cannot move; where it has no such limit, the largest speed
            between the other samples counts.

    Raises InvalidInputError for such a jump of a joint that is not continuous.
    """
    jumps = _full_turns(robot, motion, fastest)
    if not jumps.any():
        return motion
    wrong = np.argwhere((jumps != 0) & ~robot.continuous_joints)
    if len(wrong):
        row, joint = (int(k) for k in wrong[0])
        name, limits = robot.joint_names[joint], robot.limits
        argument, value = describe(row + 1, joint)
        step, dt = (float(each[row + 1] - each[row]) for each in (motion.q[:, joint], motion.t))
        wanted = (
            f"a position that {name} reaches in {1e3 * dt:.4g} ms: it jumps by {step:.6g} rad, about "
            f"{_turns(int(jumps[row, joint]))}, and is not continuous (limits {limits.lower[joint]:.6g} to "
            f"{limits.upper[joint]:.6g} rad). If it was recorded in (-π, π], numpy.unwrap gives its positions as driven"
        )
        raise InvalidInputError(argument, value, wanted)
    q = motion.q.copy()
    q[1:] -= 2 * np.pi * np.cumsum(jumps, axis=0)
    qd = motion.qd.copy()
    for joint in np.flatnonzero(jumps.any(axis=0)).tolist():
        log.info("%s: %d jumps by full turns taken out", robot.joint_names[joint], np.count_nonzero(jumps[:, joint]))
        if _belong_to_jumps(motion, joint, jumps[:, joint]):
            from scipy.interpolate import CubicSpline

            qd[:, joint] = CubicSpline(motion.t, q[:, joint])(motion.t, 1)
    return replace(motion, q=q, qd=qd)


def _full_turns(robot: Robot, motion: Trajectory, fastest: float) -> NDArray[np.int64]:
    """The full turns by which revolute joints jump from each sample to the next (k - 1, n)."""
    step, dt = np.diff(motion.q, axis=0), np.diff(motion.t)[:, None]
    turns = np.round(step / (2 * np.pi))
    turns[:, [kind == "prismatic" for kind in robot.joint_types]] = 0
    fastest_seen = np.where(turns == 0, np.abs(step) / dt, -np.inf).max(axis=0)
    fastest_seen = np.where(np.isneginf(fastest_seen), np.inf, fastest_seen)
    reach = fastest * np.where(np.isfinite(robot.limits.velocity), robot.limits.velocity, fastest_seen) * dt
    rest = np.abs(step - 2 * np.pi * turns)
    is_jump = (np.abs(step) > reach) & (rest <= np.maximum(reach, JUMP))
    return np.where(is_jump, turns, 0).astype(np.int64)


def _belong_to_jumps(motion: Trajectory, joint: int, jumps: NDArray[np.int64]) -> bool:
    """Whether the velocities at some jump differ from the slope without it by more than a quarter of the jump's own.

    Those of a spline differ by nearly all of it, central differences by half of it.
    """
    rows = np.flatnonzero(jumps)
    dt = motion.t[rows + 1] - motion.t[rows]
    given: Array = (motion.qd[rows, joint] + motion.qd[rows + 1, joint]) / 2 * dt
    driven = motion.q[rows + 1, joint] - motion.q[rows, joint] - 2 * np.pi * jumps[rows]
    return bool((np.abs(given - driven) > np.pi / 2 * np.abs(jumps[rows])).any())


def _turns(count: int) -> str:
    return "a full turn" if abs(count) == 1 else f"{abs(count)} full turns"
