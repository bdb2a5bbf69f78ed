"""Trajectories to files and back: CSV, JSON, ROS JointTrajectory in YAML, NumPy.

Tables of numbers in CSV files: every row has as many cells as the first, which names the columns.
"""

import csv
import io
import json
import re
import tokenize
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from manipplan.paths.trajectory import Trajectory
from manipplan.support.checks import Array, existing_file, one_of, text, texts, whole_number
from manipplan.support.data_files import read_json
from manipplan.support.errors import FileFormatError, InvalidInputError
from manipplan.support.files import write_bytes, write_text

#: Maximum size of a file [bytes].
LARGEST_TABLE = 64 * 2**20
#: A number as it is written in every language: no digits grouped by `_`, no decimal comma.
NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?|[+-]?(?:nan|inf|infinity)", re.IGNORECASE)


@dataclass(frozen=True, kw_only=True)
class Table:
    """The cells of a file: the names of its columns, and of each row the number of its line and the cells."""

    path: Path
    header: tuple[str, ...]
    rows: tuple[tuple[int, tuple[str, ...]], ...]

    @classmethod
    def read(cls, path: Path, *, comments: bool = False) -> "Table":
        """Read a file; with `comments`, lines that begin with # are left out.

        Raises FileFormatError for a file that is too large, is no text in UTF-8, is empty, or has a row with another number of
        cells than the first.
        """
        size = path.stat().st_size
        if size > LARGEST_TABLE:
            raise FileFormatError("file", f"{path} of {size:,} bytes", f"a CSV of at most {LARGEST_TABLE:,} bytes")
        try:
            with path.open(newline="", encoding="utf-8-sig") as stream:
                lines = list(_lines(csv.reader(stream, strict=True), comments=comments))
        except (csv.Error, UnicodeDecodeError) as error:
            raise FileFormatError("file", str(path), f"a text file (CSV); {error}") from error
        if not lines:
            raise FileFormatError("file", f"{path}, which is empty", "a CSV whose first line names the columns")
        (_, first), *rows = lines
        header = tuple(cell.removeprefix("#").strip() for cell in first)
        for line, row in rows:
            if len(row) != len(header):
                several = 1 < len(header) < len(row)
                more = "; a decimal comma makes two cells of a number: write 0.5" if several else f": {first[0]}"
                wanted = f"{len(header)} cells, as in the first row, which names the columns{more}"
                raise FileFormatError("file", f"{path}, row {line}, with {len(row)} cells", wanted)
        return cls(path=path, header=header, rows=tuple(rows))

    def column(self, names: Sequence[str], wanted: str) -> int:
        """Index of the only column with one of the names."""
        found = [k for k, column in enumerate(self.header) if column in names]
        if len(found) != 1:
            many, each = len(found) or "no", " or ".join(names)
            listed = ", ".join(self.header)
            raise FileFormatError("file", str(self.path), f"{wanted}; it has {many} column {each}, its columns are {listed}")
        return found[0]

    def numbers(self, columns: Sequence[int]) -> Array:
        """The cells of some columns as finite numbers (rows, columns); raises FileFormatError, which names row and column."""
        data = np.empty((len(self.rows), len(columns)))
        for k, (_, row) in enumerate(self.rows):
            for j, column in enumerate(columns):
                cell = row[column]
                if not NUMBER.fullmatch(cell):
                    raise FileFormatError("file", f"{self.name_cell(k, column)}: {cell}", "a number")
                data[k, j] = float(cell)
        for k, j in np.argwhere(~np.isfinite(data)).tolist():
            column = columns[j]
            got = f"{self.name_cell(k, column)}: {self.rows[k][1][column]}"
            raise FileFormatError("file", got, "a finite number, no NaN or inf")
        return data

    def name_cell(self, k: int, column: int) -> str:
        """Where a cell of row k is, in words."""
        return f"{self.path}, row {self.rows[k][0]}, {self.header[column]}"


def _lines(reader: Iterator[list[str]], *, comments: bool) -> Iterator[tuple[int, tuple[str, ...]]]:
    """Number and cells of each line that is not empty."""
    for cells in reader:
        row = tuple(cell.strip() for cell in cells)
        if any(row) and not (comments and row[0].startswith("#")):
            yield reader.line_num, row  # type: ignore[attr-defined]  # of csv.reader


FORMAT = "manipplan-trajectory"
VERSION = 1
#: Maximum duration [s]: ROS counts seconds in 32 bits, and the first message of a bag is stamped 1 s.
LONGEST = 2**31 - 2
#: Maximum size of an unpacked NumPy archive [bytes].
LARGEST_NPZ = 2**27
#: Keys of a JointTrajectory, and of its points.
ROS_KEYS = ("header", "joint_names", "points")
POINT_KEYS = ("positions", "velocities", "accelerations", "effort", "time_from_start")


def to_csv(trajectory: Trajectory, file: str | Path) -> None:
    """Write one row per sample: time [s], q_<joint> [rad or m], qd_<joint>, qdd_<joint>; all digits."""
    names = trajectory.joint_names
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(["time", *(f"{kind}_{name}" for kind in ("q", "qd", "qdd") for name in names)])
    rows = np.column_stack([trajectory.t, trajectory.q, trajectory.qd, trajectory(trajectory.t, 2)])
    writer.writerows([[repr(float(value)) for value in row] for row in rows])
    write_text(file, out.getvalue())


def from_csv(
    file: str | Path,
    *,
    joints: Sequence[str] | None = None,
    columns: Mapping[str, str] | None = None,
    degrees: bool | Sequence[str] = False,
) -> Trajectory:
    """Read `to_csv`'s file, or a recorded demonstration; see `Trajectory.from_csv`."""
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
    return _reading(path, wanted, lambda: with_velocities(data[:, 0] - data[0, 0], q, qd, names))


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
        data = read_json("file", path)
        if not isinstance(data, dict) or (data.get("format"), data.get("version")) != (FORMAT, VERSION):
            raise FileFormatError("file", str(path), wanted)
        for key in data:
            one_of("key", key, ("format", "version", "joint_names", "time", "position", "velocity"))
        return Trajectory(t=data["time"], q=data["position"], qd=data["velocity"], joint_names=data["joint_names"])

    return _reading(path, wanted, read)


def to_ros(trajectory: Trajectory, file: str | Path) -> None:
    """Write a trajectory_msgs/JointTrajectory with positions, velocities, accelerations and time_from_start.

    Its stamp is zero, which controllers take as "start immediately".
    """
    import yaml

    times = [ros_time(nanoseconds) for nanoseconds in nanoseconds_of(trajectory)]
    columns = [each.tolist() for each in (trajectory.q, trajectory.qd, trajectory(trajectory.t, 2))]
    points = [dict(zip(POINT_KEYS, (*row, [], time), strict=True)) for *row, time in zip(*columns, times, strict=True)]
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
    """Read a JointTrajectory in YAML.

    Velocities that are not there come from the cubic spline through the positions. Raises FileFormatError when names, positions
    or times are missing, or a key is none of the message's.
    """
    from manipplan.support.data_files import read_yaml

    path = existing_file("file", file)
    wanted = "a JointTrajectory in YAML: joint_names and points with positions and time_from_start"

    def read() -> Trajectory:
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
    """Read `to_npz`'s file. Raises FileFormatError for another archive, or one of more than `LARGEST_NPZ` bytes unpacked."""
    import zipfile

    path = existing_file("file", file)
    wanted = "a NumPy archive with t, q, qd and joint_names"

    def read() -> Trajectory:
        with zipfile.ZipFile(path) as archive:
            size = sum(each.file_size for each in archive.infolist())
        if size > LARGEST_NPZ:
            raise FileFormatError(
                "file", f"{path} with {size:,} bytes of numbers", f"{wanted}, of at most {LARGEST_NPZ:,} bytes"
            )
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
