"""Write trajectories to ROS bags, for rviz and Foxglove, and read demonstrations from them; uses the package rosbags."""

from collections.abc import Iterator, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from manipplan.paths.trajectory import Trajectory, nanoseconds_of, ros_time, with_velocities
from manipplan.support.checks import Array, number, one_of
from manipplan.support.errors import FileFormatError, InvalidInputError, ManipplanError, MissingExtraError, UnknownNameError

TRAJECTORY, STATE = "trajectory_msgs/msg/JointTrajectory", "sensor_msgs/msg/JointState"
#: Topics that are written: the one to which ros2_control's trajectory controller subscribes, and the usual one of joint states.
TRAJECTORY_TOPIC, STATE_TOPIC = "/joint_trajectory_controller/joint_trajectory", "/joint_states"
STORAGES = ("mcap", "sqlite3")
#: Time of the first message [ns]: a stamp of zero means "no time" in ROS.
BEGIN = 10**9


def to_rosbag(trajectory: Trajectory, file: str | Path, *, storage: str = "mcap", rate: float = 100.0) -> None:
    """Write a ROS 2 bag with the motion as one JointTrajectory and as a stream of JointStates; see `Trajectory.to_rosbag`."""
    path = _new_folder(file)
    one_of("storage", storage, STORAGES)
    number("rate", rate, above=0.0, most=10_000.0)
    nanoseconds_of(trajectory)  # raises if ROS stamps cannot represent the sample times
    _rosbags()
    from rosbags.rosbag2 import StoragePlugin, Writer
    from rosbags.typesys import Stores, get_typestore

    store = get_typestore(Stores.LATEST)
    plugin = StoragePlugin.MCAP if storage == "mcap" else StoragePlugin.SQLITE3
    try:
        with TemporaryDirectory(prefix=f".{path.name}.", suffix=".part", dir=path.parent) as folder:
            part = Path(folder) / path.name
            with Writer(part, version=9, storage_plugin=plugin) as bag:
                command = bag.add_connection(TRAJECTORY_TOPIC, TRAJECTORY, typestore=store)
                stream = bag.add_connection(STATE_TOPIC, STATE, typestore=store)
                bag.write(command, BEGIN, store.serialize_cdr(_trajectory_message(trajectory, store), TRAJECTORY))
                for stamp, message in _state_messages(trajectory, store, rate):
                    bag.write(stream, stamp, store.serialize_cdr(message, STATE))
            part.rename(path)
    except (OSError, ValueError) as error:  # ValueError: a zero byte in the name
        said = getattr(error, "strerror", None) or str(error)
        raise InvalidInputError("file", str(path), f"a path that can be written ({said})") from error


def from_rosbag(file: str | Path, topic: str | None = None, *, joints: Sequence[str] | None = None) -> Trajectory:
    """Read the motion from one topic of a bag; see `Trajectory.from_rosbag`."""
    if not isinstance(file, str | Path):
        raise InvalidInputError("file", file, "the folder of a ROS 2 bag, or a ROS 1 .bag file")
    path = Path(file).expanduser()
    if path.suffix in (".mcap", ".db3") or not _exists(path):
        raise FileFormatError("file", str(path), "the folder of a ROS 2 bag, with its metadata.yaml, or a ROS 1 .bag file")
    if joints is not None and not (isinstance(joints, list | tuple) and joints and all(isinstance(j, str) for j in joints)):
        raise InvalidInputError("joints", joints, "a list of names")
    _rosbags()
    from rosbags.highlevel import AnyReader, AnyReaderError
    from rosbags.typesys import Stores, get_typestore

    try:
        with AnyReader([path], default_typestore=get_typestore(Stores.LATEST)) as bag:
            topics = {connection.topic: connection.msgtype for connection in bag.connections}
            chosen = _topic(path, topics, topic)
            connections = [connection for connection in bag.connections if connection.topic == chosen]
            messages = [
                (stamp, bag.deserialize(data, connection.msgtype)) for connection, stamp, data in bag.messages(connections)
            ]
    except ManipplanError:
        raise
    except Exception as error:  # rosbags decodes damaged bags unchecked and can raise any exception
        known = isinstance(error, AnyReaderError | OSError)
        reason = " ".join((str(error) if known else f"{type(error).__name__}: {error}").split())
        raise FileFormatError("file", str(path), f"a ROS bag that can be read ({reason[:200]})") from error
    where = f"{path}, {chosen}"
    names, t, q, qd = (_commands if topics[chosen] == TRAJECTORY else _collect)(where, messages, joints)
    return _motion(where, names, t, q, qd)


def _topic(path: Path, topics: dict[str, str], topic: str | None) -> str:
    """The requested topic; by default the only one with JointStates, else the only one with a JointTrajectory."""
    fitting = {name: kind for name, kind in topics.items() if kind in (STATE, TRAJECTORY)}
    if topic is not None:
        if not isinstance(topic, str) or topic not in fitting:
            raise UnknownNameError("topic", str(topic), fitting, empty=f"none: {path} has no JointState and no JointTrajectory")
        return topic
    for kind in (STATE, TRAJECTORY):
        found = [name for name in fitting if fitting[name] == kind]
        if len(found) == 1:
            return found[0]
        if found:
            raise InvalidInputError("topic", None, f"one of {', '.join(found)}: {path} has several topics of type {kind}")
    listed = ", ".join(f"{name} ({kind})" for name, kind in topics.items()) or "nothing"
    raise FileFormatError("file", str(path), f"a bag with a topic of type {STATE} or {TRAJECTORY}; this one has {listed}")


def _collect(
    where: str, messages: list[tuple[int, Any]], joints: Sequence[str] | None
) -> tuple[tuple[str, ...], Array, Array, Array | None]:
    """Names (n,), times (k,) [s], positions and, where every message has them, velocities (k, n) of JointStates.

    Times come from the headers, or from the bag if all header stamps are zero. Messages without any of the joints, such as
    those of a gripper that publishes on the same topic, are skipped.
    """
    names = tuple(joints) if joints is not None else tuple(messages[0][1].name) if messages else ()
    rows = []
    for k, (received, message) in enumerate(messages):
        index = {name: i for i, name in enumerate(message.name)}
        missing = [name for name in names if name not in index]
        if len(index) != len(message.name):
            raise FileFormatError("file", where, f"every joint once; message {k + 1} has {', '.join(message.name)}")
        if joints is None and set(index) != set(names):
            said = f"message {k + 1} has {', '.join(index) or 'no joint'}, and message 1 has {', '.join(names)}"
            raise FileFormatError("file", where, f"the same joints in all messages, but {said}; select joints with joints=")
        if len(missing) == len(names):
            continue
        if missing:
            raise FileFormatError(
                "file", where, f"all of {', '.join(names)} in every message; message {k + 1} lacks {', '.join(missing)}"
            )
        order = [index[name] for name in names]
        if len(message.position) != len(message.name):
            raise FileFormatError("file", where, f"a position for every joint; message {k + 1} has {len(message.position)}")
        stamp = message.header.stamp.sec * 10**9 + message.header.stamp.nanosec
        velocity = message.velocity[order] if len(message.velocity) == len(message.name) else None
        rows.append((stamp, received, message.position[order], velocity, k + 1))
    if not rows:
        known = {name for _, message in messages for name in message.name}
        if joints is not None and known:
            raise UnknownNameError("joints", names[0], known)
        raise FileFormatError("file", where, "at least two messages with positions")
    stamps = [row[0] for row in rows]
    if not any(stamps):  # "no time" in ROS 2; a single zero can be the start of a simulation
        stamps = [row[1] for row in rows]
    t = np.array([(stamp - stamps[0]) / 1e9 for stamp in stamps])
    late = np.flatnonzero(np.diff(t) <= 0)
    if len(late):
        k = int(late[0]) + 1
        earlier = t[k - 1] - t[k]
        relation = f"is stamped {earlier:.9f} s before" if earlier > 0 else "has the stamp of"
        said = f"message {rows[k][4]} {relation} message {rows[k - 1][4]}"
        raise FileFormatError("file", where, f"increasing stamps, but {said}; sort the bag, or record one source per topic")
    known_speed = all(velocity is not None and np.isfinite(velocity).all() for _, _, _, velocity, _ in rows)
    qd = np.array([velocity for _, _, _, velocity, _ in rows]) if known_speed else None
    return names, t, np.array([position for _, _, position, *_ in rows]), qd


def _commands(
    where: str, messages: list[tuple[int, Any]], joints: Sequence[str] | None
) -> tuple[tuple[str, ...], Array, Array, Array | None]:
    """The same as `_collect`, for the only JointTrajectory of a topic."""
    if len(messages) != 1:
        raise FileFormatError("file", where, f"one JointTrajectory; the topic has {len(messages)}")
    message = messages[0][1]
    known = list(message.joint_names)
    if len(set(known)) != len(known):
        raise FileFormatError("file", where, f"every joint once; the trajectory has {', '.join(known)}")
    names = tuple(joints) if joints is not None else tuple(known)
    for name in names:
        if name not in known:
            raise UnknownNameError("joints", name, known)
    order = [known.index(name) for name in names]
    for k, point in enumerate(message.points):
        if len(point.positions) != len(known):
            raise FileFormatError("file", where, f"a position for every joint; point {k + 1} has {len(point.positions)}")
    stamps = [point.time_from_start.sec * 10**9 + point.time_from_start.nanosec for point in message.points]
    t = np.array([stamp / 1e9 for stamp in stamps])
    q = np.array([point.positions[order] for point in message.points])
    full = all(len(point.velocities) == len(known) for point in message.points)
    return names, t, q, np.array([point.velocities[order] for point in message.points]) if full else None


def _motion(where: str, names: tuple[str, ...], t: Array, q: Array, qd: Array | None) -> Trajectory:
    """The trajectory; velocities that were not recorded come from the cubic spline through the positions."""
    try:
        return with_velocities(t, q, qd, names)
    except InvalidInputError as error:
        raise FileFormatError("file", where, f"a recorded motion; {error}") from error


def _trajectory_message(trajectory: Trajectory, store: Any) -> Any:
    """The trajectory as one JointTrajectory message of rosbags' type store."""
    kinds = store.types
    point, duration = kinds["trajectory_msgs/msg/JointTrajectoryPoint"], kinds["builtin_interfaces/msg/Duration"]
    columns = (nanoseconds_of(trajectory), trajectory.q, trajectory.qd, trajectory(trajectory.t, 2))
    points = [
        point(
            positions=np.array(q),
            velocities=np.array(qd),
            accelerations=np.array(qdd),
            effort=np.empty(0),
            time_from_start=duration(**ros_time(nanoseconds)),
        )
        for nanoseconds, q, qd, qdd in zip(*columns, strict=True)
    ]
    header = kinds["std_msgs/msg/Header"](stamp=kinds["builtin_interfaces/msg/Time"](**ros_time(0)), frame_id="")
    return kinds[TRAJECTORY](header=header, joint_names=list(trajectory.joint_names), points=points)


def _state_messages(trajectory: Trajectory, store: Any, rate: float) -> Iterator[tuple[int, Any]]:
    """Stamps [ns] and JointState messages, at `rate` [Hz] and at the samples, so that the cubics in between stay the same."""
    kinds = store.types
    even = np.arange(0.0, trajectory.duration, 1 / rate)
    stamps = np.unique(np.round(np.concatenate([even, trajectory.t]) * 1e9).astype(np.int64))
    at = np.clip(stamps / 1e9, 0.0, trajectory.duration)
    for stamp, q, qd in zip(stamps.tolist(), trajectory(at), trajectory(at, 1), strict=True):
        time = kinds["builtin_interfaces/msg/Time"](**ros_time(BEGIN + stamp))
        header = kinds["std_msgs/msg/Header"](stamp=time, frame_id="")
        names = list(trajectory.joint_names)
        yield BEGIN + stamp, kinds[STATE](header=header, name=names, position=q, velocity=qd, effort=np.empty(0))


def _new_folder(file: str | Path) -> Path:
    if not isinstance(file, str | Path):
        raise InvalidInputError("file", file, "the path of a folder")
    path = Path(file).expanduser()
    if _exists(path):
        raise InvalidInputError("file", str(path), "a path that does not exist yet: the folder of a bag is never overwritten")
    return path


def _exists(path: Path) -> bool:
    try:
        return path.exists()
    except OSError as error:  # a name that is too long
        raise InvalidInputError("file", str(path), f"a path that can be used ({error.strerror})") from error


def _rosbags() -> None:
    try:
        import rosbags.highlevel  # noqa: F401  # checks that it is installed
    except ImportError as error:
        raise MissingExtraError("rosbags", "ros") from error
