"""Trajectories to files and back: CSV, JSON, ROS JointTrajectory in YAML, NumPy."""

import csv
import io
import json
import tokenize
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from manipplan.paths.trajectory import Trajectory
from manipplan.support.checks import Array, existing_file, whole_number
from manipplan.support.errors import FileFormatError, InvalidInputError
from manipplan.support.files import write_bytes, write_text

FORMAT = "manipplan-trajectory"
VERSION = 1
#: Maximum duration [s]: ROS counts seconds in 32 bits, and the first message of a bag is stamped 1 s.
LONGEST = 2**31 - 2
#: Maximum size of an unpacked NumPy archive [bytes].
LARGEST = 2**30


def to_csv(trajectory: Trajectory, file: str | Path) -> None:
    """Write one row per sample: time [s], q_<joint> [rad or m], qd_<joint>, qdd_<joint>; all digits."""
    names = trajectory.joint_names
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(["time", *(f"{kind}_{name}" for kind in ("q", "qd", "qdd") for name in names)])
    rows = np.column_stack([trajectory.t, trajectory.q, trajectory.qd, trajectory(trajectory.t, 2)])
    writer.writerows([[repr(float(value)) for value in row] for row in rows])
    write_text(file, out.getvalue())


def from_csv(file: str | Path, *, joints: Sequence[str] | None = None) -> Trajectory:
    """Read `to_csv`'s file, or a recorded demonstration. Columns are found by name, in any order; others are ignored.

    Args:
        file: its first line names the columns: `time` or `t` [s], `q_<joint>` [rad or m], and `qd_<joint>` for all joints or
            none. Without velocities they come from the cubic spline through the positions. Times count from that of the first
            row.
        joints: names to read, in this order, such as `robot.joint_names`; their columns may lack the `q_`. Default: all
            `q_<joint>` columns, in their order.

    Raises FileFormatError for a missing column, a short row, a cell that is not a finite number, or a time that is not after
    the one before; the last three name the row.
    """
    path = existing_file("file", file)
    wanted = "a CSV with columns time, q_<joint>... (qd_<joint>... and others may follow, in any order)"

    def read() -> Trajectory:
        with path.open(newline="", encoding="utf-8-sig") as stream:
            reader = csv.reader(stream)
            (_, first), *rows = [(reader.line_num, row) for row in reader if row]
        header = [cell.strip().removeprefix("#").strip() for cell in first]
        names = _joints_of(path, header, wanted) if joints is None else list(joints)
        positions = [_column(path, header, (f"q_{name}", name) if joints is not None else (f"q_{name}",)) for name in names]
        speeds = [f"qd_{name}" for name in names if f"qd_{name}" in header]
        velocities = [_column(path, header, (f"qd_{name}",)) for name in names] if speeds else []
        columns = [_column(path, header, ("time", "t")), *positions, *velocities]
        data = _numbers(path, header, columns, rows)
        t, q = data[:, 0] - data[0, 0], data[:, 1 : 1 + len(names)]
        if velocities:
            return Trajectory(t=t, q=q, qd=data[:, 1 + len(names) :], joint_names=tuple(names))
        from scipy.interpolate import CubicSpline

        still = Trajectory(t=t, q=q, qd=np.zeros_like(q), joint_names=tuple(names))  # t and q are checked first
        return replace(still, qd=CubicSpline(t, q)(t, 1))

    return _reading(path, wanted, read)


def _joints_of(path: Path, header: list[str], wanted: str) -> list[str]:
    """The joints that have a column of positions."""
    names = [column.removeprefix("q_") for column in header if column.startswith("q_")]
    if not names or not all(names):
        raise FileFormatError("file", f"{path} with the first line {','.join(header)}", wanted)
    return names


def _column(path: Path, header: list[str], names: tuple[str, ...]) -> int:
    """Index of the only column with one of the names."""
    found = [k for k, column in enumerate(header) if column in names]
    if len(found) != 1:
        many, each = len(found) or "no", " or ".join(names)
        wanted = f"a CSV with columns time, q_<joint>...; it has {many} column {each}, its columns are {', '.join(header)}"
        raise FileFormatError("file", str(path), wanted)
    return found[0]


def _numbers(path: Path, header: list[str], columns: list[int], rows: list[tuple[int, list[str]]]) -> Array:
    """The cells of these columns of rows (line, cells) as finite numbers, with increasing times in the first column."""
    if len(rows) < 2:
        raise FileFormatError("file", f"{path} with {len(rows)} rows of numbers", "at least two")
    data = np.empty((len(rows), len(columns)))
    for k, (line, row) in enumerate(rows):
        if len(row) <= max(columns):
            wanted = f"at least {max(columns) + 1} cells, as in the first row"
            raise FileFormatError("file", f"{path}, row {line}, with {len(row)} cells", wanted)
        for j, column in enumerate(columns):
            try:
                data[k, j] = float(row[column])
            except ValueError as error:
                raise FileFormatError("file", f"{path}, row {line}, {header[column]}: {row[column]}", "a number") from error
    for k, j in np.argwhere(~np.isfinite(data)).tolist():
        got = f"{path}, row {rows[k][0]}, {header[columns[j]]}: {rows[k][1][columns[j]]}"
        raise FileFormatError("file", got, "a finite number, no NaN or inf")
    for k in np.flatnonzero(np.diff(data[:, 0]) <= 0).tolist():
        wanted = f"a time after that of row {rows[k][0]}, {float(data[k, 0])!r} s"
        got = f"{path}, row {rows[k + 1][0]}, {header[columns[0]]}: {rows[k + 1][1][columns[0]]}"
        raise FileFormatError("file", got, wanted)
    return data


def to_json(trajectory: Trajectory, file: str | Path) -> None:
    """Write an object with format, version, joint_names, time, position and velocity."""
    data = {
        "format": FORMAT,
        "version": VERSION,
        "joint_names": list(trajectory.joint_names),
        "time": trajectory.t.tolist(),
        "position": trajectory.q.tolist(),
        "velocity": trajectory.qd.tolist(),
    }
    write_text(file, json.dumps(data) + "\n")


def from_json(file: str | Path) -> Trajectory:
    """Read `to_json`'s file. Raises FileFormatError for another format or version."""
    path = existing_file("file", file)
    wanted = f"a JSON object with format {FORMAT!r} and version {VERSION}"

    def read() -> Trajectory:
        data = json.loads(path.read_text())
        if not isinstance(data, dict) or (data.get("format"), data.get("version")) != (FORMAT, VERSION):
            raise FileFormatError("file", str(path), wanted)
        return Trajectory(t=data["time"], q=data["position"], qd=data["velocity"], joint_names=data["joint_names"])

    return _reading(path, wanted, read)


def to_ros(trajectory: Trajectory, file: str | Path) -> None:
    """Write a trajectory_msgs/JointTrajectory with positions, velocities, accelerations and time_from_start.

    Its stamp is zero, which controllers take as "start immediately".
    """
    import yaml

    points = []
    columns = (nanoseconds_of(trajectory), trajectory.q, trajectory.qd, trajectory(trajectory.t, 2))
    for nanoseconds, q, qd, qdd in zip(*columns, strict=True):
        points.append(
            {
                "positions": q.tolist(),
                "velocities": qd.tolist(),
                "accelerations": qdd.tolist(),
                "effort": [],
                "time_from_start": ros_time(nanoseconds),
            }
        )
    header = {"stamp": ros_time(0), "frame_id": ""}
    message = {"header": header, "joint_names": list(trajectory.joint_names), "points": points}
    dumper: Any = getattr(yaml, "CSafeDumper", yaml.SafeDumper)
    write_text(file, yaml.dump(message, Dumper=dumper, sort_keys=False, default_flow_style=None, width=1000))


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


def from_ros(file: str | Path) -> Trajectory:
    """Read a JointTrajectory in YAML. Raises FileFormatError when names, positions, velocities or times are missing."""
    from manipplan.support.yaml_files import read_yaml

    path = existing_file("file", file)
    wanted = "a JointTrajectory in YAML: joint_names and points with positions, velocities and time_from_start"

    def read() -> Trajectory:
        message = read_yaml("file", path)
        if not isinstance(message, Mapping):
            raise FileFormatError("file", str(path), wanted)
        return Trajectory(
            t=np.array([_seconds(point["time_from_start"]) for point in message["points"]]),
            q=np.array([point["positions"] for point in message["points"]], dtype=float),
            qd=np.array([point["velocities"] for point in message["points"]], dtype=float),
            joint_names=message["joint_names"],
        )

    return _reading(path, wanted, read)


def _seconds(stamp: Mapping[str, Any]) -> float:
    """ROS's Duration in seconds."""
    sec = whole_number("time_from_start.sec", stamp["sec"], least=0, most=2**31 - 1)
    nanosec = whole_number("time_from_start.nanosec", stamp["nanosec"], least=0, most=10**9 - 1)
    return (sec * 10**9 + nanosec) / 1e9


def to_npz(trajectory: Trajectory, file: str | Path) -> None:
    """Write a NumPy archive with t, q, qd and joint_names."""
    names = np.array(trajectory.joint_names)
    write_bytes(file, lambda stream: np.savez(stream, t=trajectory.t, q=trajectory.q, qd=trajectory.qd, joint_names=names))


def from_npz(file: str | Path) -> Trajectory:
    """Read `to_npz`'s file. Raises FileFormatError for another archive, or one of more than `LARGEST` bytes unpacked."""
    import zipfile

    path = existing_file("file", file)
    wanted = "a NumPy archive with t, q, qd and joint_names"

    def read() -> Trajectory:
        with zipfile.ZipFile(path) as archive:
            size = sum(each.file_size for each in archive.infolist())
        if size > LARGEST:
            raise FileFormatError("file", f"{path} with {size:,} bytes of numbers", f"{wanted}, of at most {LARGEST:,} bytes")
        with np.load(path, allow_pickle=False) as data:
            return Trajectory(t=data["t"], q=data["q"], qd=data["qd"], joint_names=tuple(data["joint_names"].tolist()))

    return _reading(path, wanted, read)


#: Readers of trajectory files, by file extension.
READERS = {".csv": from_csv, ".json": from_json, ".yaml": from_ros, ".yml": from_ros, ".npz": from_npz}


def read_trajectory(argument: str, file: str | Path) -> Trajectory:
    """Read a trajectory file by its extension. Raises FileFormatError for another extension, and as its reader does."""
    read = READERS.get(Path(file).suffix.lower())
    if read is None:
        raise FileFormatError(argument, str(file), f"a trajectory file: {', '.join(READERS)}")
    return read(file)


def _reading(path: Path, wanted: str, read: Callable[[], Trajectory]) -> Trajectory:
    """Return the result of `read`; an exception of the libraries becomes a FileFormatError."""
    import zipfile
    import zlib

    try:
        return read()
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
