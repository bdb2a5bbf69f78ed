"""ROS messages and bags, read and written by rosbags, which knows the real definitions; and recordings that are not clean."""

import os
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
import yaml
from rosbags.highlevel import AnyReader
from rosbags.interfaces import Nodetype
from rosbags.rosbag1 import Writer as Writer1
from rosbags.rosbag2 import Reader, StoragePlugin, Writer
from rosbags.typesys import Stores, get_typestore

import manipplan as mp

STORE = get_typestore(Stores.ROS2_HUMBLE)
STATE, TRAJECTORY = "sensor_msgs/msg/JointState", "trajectory_msgs/msg/JointTrajectory"
NAMES = ("a", "b", "c")


@pytest.fixture
def motion(rng):
    return mp.Trajectory(
        t=np.concatenate([[0.0], np.cumsum(np.round(rng.uniform(0.02, 0.3, 11), 9))]).round(9),
        q=rng.normal(size=(12, 3)),
        qd=rng.normal(size=(12, 3)),
        joint_names=NAMES,
    )


def as_message(kind, value, store=STORE):
    """The message of a mapping, by the definition of its type: every field has to be there, and none beside it."""
    fields = dict(store.fielddefs[kind][1])
    assert set(value) == set(fields), kind
    return store.types[kind](**{name: as_field(fields[name], value[name], store) for name in fields})


def as_field(definition, value, store):
    node, what = definition
    if node == Nodetype.BASE:
        kinds = {"string": str, "float64": float, "int32": int, "uint32": int}
        assert isinstance(value, kinds[what[0]])
        return value
    if node == Nodetype.NAME:
        return as_message(what, value, store)
    items = [as_field(what[0], each, store) for each in value]
    return np.array(items, dtype=np.float64) if what[0][1] == ("float64", 0) else items


@pytest.mark.parametrize("distribution", [Stores.ROS2_FOXY, Stores.ROS2_HUMBLE, Stores.ROS2_JAZZY, Stores.LATEST])
def test_the_yaml_is_the_message_of_ros(motion, tmp_path, distribution):
    store = get_typestore(distribution)
    motion.to_ros(tmp_path / "motion.yaml")
    written = as_message(TRAJECTORY, yaml.safe_load((tmp_path / "motion.yaml").read_text()), store)
    message = store.deserialize_cdr(store.serialize_cdr(written, TRAJECTORY), TRAJECTORY)
    assert tuple(message.joint_names) == NAMES
    for k, point in enumerate(message.points):
        np.testing.assert_array_equal(point.positions, motion.q[k])
        np.testing.assert_array_equal(point.velocities, motion.qd[k])
        np.testing.assert_array_equal(point.accelerations, motion(motion.t[k], 2))
        assert point.time_from_start.sec + 1e-9 * point.time_from_start.nanosec == pytest.approx(motion.t[k], abs=1e-12)


def test_the_yaml_becomes_a_goal_as_the_page_says(motion, tmp_path):
    """docs/ros.md indents the file below `trajectory:` in a shell."""
    motion.to_ros(tmp_path / "motion.yaml")
    command = "echo 'trajectory:'; sed 's/^/  /' motion.yaml"
    goal = subprocess.run(["sh", "-c", command], cwd=tmp_path, check=True, capture_output=True, text=True).stdout
    assert as_message(TRAJECTORY, yaml.safe_load(goal)["trajectory"]).points[-1].positions.tolist() == motion.q[-1].tolist()


@pytest.mark.parametrize("storage", ["mcap", "sqlite3"])
def test_a_bag_holds_the_motion(motion, tmp_path, storage):
    motion.to_rosbag(tmp_path / "bag", storage=storage, rate=50.0)
    assert {file.suffix for file in (tmp_path / "bag").iterdir()} == {".yaml", ".mcap" if storage == "mcap" else ".db3"}
    with AnyReader([tmp_path / "bag"]) as bag:
        messages = [(each.msgtype, stamp, bag.deserialize(data, each.msgtype)) for each, stamp, data in bag.messages()]
    [command] = [message for kind, _, message in messages if kind == TRAJECTORY]
    np.testing.assert_array_equal([point.positions for point in command.points], motion.q)
    states = [(stamp, message) for kind, stamp, message in messages if kind == STATE]
    t = np.array([stamp - states[0][0] for stamp, _ in states]) / 1e9
    assert np.diff(t).max() <= 1 / 50 + 1e-9
    assert set(np.round(motion.t, 9)) <= set(np.round(t, 9))
    np.testing.assert_allclose([message.position for _, message in states], motion(t), atol=1e-12)
    np.testing.assert_allclose([message.velocity for _, message in states], motion(t, 1), atol=1e-12)
    for stamp, message in states:
        assert message.header.stamp.sec * 10**9 + message.header.stamp.nanosec == stamp > 0
        assert tuple(message.name) == NAMES


@pytest.mark.parametrize("storage", ["mcap", "sqlite3"])
def test_a_bag_comes_back(motion, tmp_path, storage):
    motion.to_rosbag(tmp_path / "bag", storage=storage)
    exact = mp.Trajectory.from_rosbag(tmp_path / "bag", "/joint_trajectory_controller/joint_trajectory")
    for name in ("t", "q", "qd", "joint_names"):
        np.testing.assert_array_equal(getattr(exact, name), getattr(motion, name))
    stream = mp.Trajectory.from_rosbag(tmp_path / "bag")
    t = np.linspace(0, motion.duration, 500)
    np.testing.assert_allclose(stream(t), motion(t), atol=1e-7)  # samples lie at whole nanoseconds


def write_states(folder, rows, *, topic="/joint_states", version=9, kinds=STORE):
    """A recording: rows of (seconds, names, positions, velocities), stamped by the header alone."""
    with Writer(folder, version=version, storage_plugin=StoragePlugin.SQLITE3) as bag:
        connection = bag.add_connection(topic, STATE, typestore=kinds)
        for k, (seconds, names, positions, velocities) in enumerate(rows):
            nanoseconds = round(seconds * 1e9)
            stamp = kinds.types["builtin_interfaces/msg/Time"](sec=nanoseconds // 10**9, nanosec=nanoseconds % 10**9)
            header = kinds.types["std_msgs/msg/Header"](stamp=stamp, frame_id="base")
            message = kinds.types[STATE](
                header=header, name=list(names), position=np.array(positions, float), velocity=np.array(velocities, float),
                effort=np.empty(0),
            )  # fmt: skip
            bag.write(connection, 5 * 10**9 + 10**7 * k, kinds.serialize_cdr(message, STATE))


def test_joints_are_found_by_name(tmp_path, rng):
    """The order changes from message to message, and a gripper publishes on the same topic."""
    t, q, qd = np.arange(8) * 0.1 + 3.0, rng.normal(size=(8, 3)), rng.normal(size=(8, 3))
    rows = []
    for k in range(8):
        order = rng.permutation(3)
        rows.append((t[k], [*np.array(NAMES)[order], "extra"], [*q[k, order], 9.0], [*qd[k, order], 9.0]))
        rows.append((t[k] + 0.05, ["finger"], [0.01], []))
    write_states(tmp_path / "bag", rows)
    found = mp.Trajectory.from_rosbag(tmp_path / "bag", joints=("c", "a", "b"))
    np.testing.assert_allclose(found.t, t - 3.0, atol=1e-9)
    np.testing.assert_array_equal(found.q, q[:, [2, 0, 1]])
    np.testing.assert_array_equal(found.qd, qd[:, [2, 0, 1]])
    with pytest.raises(
        mp.errors.FileFormatError, match=r"message 2 has finger, and message 1 has .*; select joints with joints="
    ):
        mp.Trajectory.from_rosbag(tmp_path / "bag")
    with pytest.raises(mp.errors.UnknownNameError, match=r"joints: got 'fingers'; allowed: did you mean finger"):
        mp.Trajectory.from_rosbag(tmp_path / "bag", joints=["fingers"])
    with pytest.raises(mp.errors.FileFormatError, match=r"all of a, finger in every message; message 1 lacks finger"):
        mp.Trajectory.from_rosbag(tmp_path / "bag", joints=["a", "finger"])


@pytest.mark.parametrize("velocities", [[], [np.nan, 0.0]])
def test_velocities_that_were_not_recorded_are_derived(tmp_path, velocities):
    t = np.linspace(0.0, 2.0, 60)
    q = np.column_stack([np.sin(t), t**2])
    write_states(tmp_path / "bag", [(each + 1, ("a", "b"), q[k], velocities) for k, each in enumerate(t)])
    found = mp.Trajectory.from_rosbag(tmp_path / "bag")
    np.testing.assert_allclose(found.qd, np.column_stack([np.cos(t), 2 * t]), atol=1e-4)


def test_without_a_header_stamp_the_bag_tells_the_time(tmp_path):
    write_states(tmp_path / "bag", [(0.0, "ab", [k, k], [1, 1]) for k in range(5)])
    np.testing.assert_allclose(mp.Trajectory.from_rosbag(tmp_path / "bag").t, np.arange(5) * 0.01, atol=1e-12)


@pytest.mark.parametrize(
    ("times", "relation"),
    [([1.0, 1.1, 1.1, 1.2], "has the stamp of"), ([1.0, 1.2, 1.1, 1.3], "is stamped 0.100000000 s before")],
)
def test_stamps_that_do_not_rise_are_told(tmp_path, times, relation):
    write_states(tmp_path / "bag", [(t, "ab", [0, 0], [0, 0]) for t in times])
    with pytest.raises(mp.errors.FileFormatError, match=f"increasing stamps, but message 3 {relation} message 2"):
        mp.Trajectory.from_rosbag(tmp_path / "bag")


def test_too_little_is_told(tmp_path):
    write_states(tmp_path / "none", [])
    write_states(tmp_path / "one", [(1.0, "ab", [0, 0], [0, 0])])
    write_states(tmp_path / "short", [(1.0, "ab", [0, 0], []), (1.1, "ab", [0], [])])
    write_states(tmp_path / "nan", [(1.0, "ab", [0, 0], []), (1.1, "ab", [0, np.nan], [])])
    with pytest.raises(mp.errors.FileFormatError, match="at least two messages"):
        mp.Trajectory.from_rosbag(tmp_path / "none")
    with pytest.raises(mp.errors.FileFormatError, match="at least two times"):
        mp.Trajectory.from_rosbag(tmp_path / "one")
    with pytest.raises(mp.errors.FileFormatError, match="a position for every joint; message 2 has 1"):
        mp.Trajectory.from_rosbag(tmp_path / "short")
    with pytest.raises(mp.errors.FileFormatError, match=r"q\[1, 1\] \(b\): got nan; allowed: a finite number"):
        mp.Trajectory.from_rosbag(tmp_path / "nan")


def test_the_topic_is_chosen_or_asked_for(motion, tmp_path):
    with Writer(tmp_path / "bag", version=9) as bag:
        for topic in ("/left/joint_states", "/right/joint_states"):
            bag.add_connection(topic, STATE, typestore=STORE)
        bag.add_connection("/chatter", "std_msgs/msg/String", typestore=STORE)
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"topic: got None; allowed: one of /left/joint_states, /right/joint_states"
    ):
        mp.Trajectory.from_rosbag(tmp_path / "bag")
    with pytest.raises(mp.errors.UnknownNameError, match=r"did you mean /left/joint_states"):
        mp.Trajectory.from_rosbag(tmp_path / "bag", "/left/joint_state")
    with Writer(tmp_path / "chat", version=9) as bag:
        bag.add_connection("/chatter", "std_msgs/msg/String", typestore=STORE)
    with pytest.raises(mp.errors.FileFormatError, match=r"this one has /chatter \(std_msgs/msg/String\)"):
        mp.Trajectory.from_rosbag(tmp_path / "chat")
    with pytest.raises(mp.errors.UnknownNameError, match="has no JointState"):
        mp.Trajectory.from_rosbag(tmp_path / "chat", "/chatter")
    motion.to_rosbag(tmp_path / "ours")
    command = "/joint_trajectory_controller/joint_trajectory"
    assert mp.Trajectory.from_rosbag(tmp_path / "ours", command, joints=["b"]).q.shape == (12, 1)
    with pytest.raises(mp.errors.UnknownNameError, match="joints: got 'd'"):
        mp.Trajectory.from_rosbag(tmp_path / "ours", command, joints=["d"])


def test_older_bags(tmp_path):
    """ROS 2 bags without message definitions, and ROS 1 bags."""
    rows = [(1 + 0.1 * k, "ab", [k, 2 * k], [10, 20]) for k in range(4)]
    write_states(tmp_path / "humble", rows, version=8)
    np.testing.assert_array_equal(mp.Trajectory.from_rosbag(tmp_path / "humble").q[:, 1], [0, 2, 4, 6])
    store = get_typestore(Stores.ROS1_NOETIC)
    with Writer1(tmp_path / "noetic.bag") as bag:
        connection = bag.add_connection("/joint_states", STATE, typestore=store)
        for k, (seconds, names, positions, velocities) in enumerate(rows):
            stamp = store.types["builtin_interfaces/msg/Time"](sec=1, nanosec=round((seconds - 1) * 1e9))
            header = store.types["std_msgs/msg/Header"](seq=k, stamp=stamp, frame_id="")
            message = store.types[STATE](
                header=header, name=list(names), position=np.array(positions, float), velocity=np.array(velocities, float),
                effort=np.empty(0),
            )  # fmt: skip
            bag.write(connection, k, store.serialize_ros1(message, STATE))
    found = mp.Trajectory.from_rosbag(tmp_path / "noetic.bag")
    np.testing.assert_allclose(found.t, [0.0, 0.1, 0.2, 0.3], atol=1e-9)
    np.testing.assert_array_equal(found.q[:, 1], [0, 2, 4, 6])


@pytest.mark.slow
def test_a_recording_is_improved(planar, tmp_path):
    t = np.linspace(0.0, 3.0, 61)
    u = 3 * (t / 3) ** 2 - 2 * (t / 3) ** 3
    start, goal = np.array([0.3, 0.5, 0.6]), np.array([1.0, 0.4, 0.8])
    q = start + u[:, None] * (goal - start)
    names = planar.joint_names[::-1]
    write_states(tmp_path / "bag", [(each + 1, [*names, "grip"], [*q[k, ::-1], 0], []) for k, each in enumerate(t)])
    recorded = mp.Trajectory.from_rosbag(tmp_path / "bag", joints=planar.joint_names)
    plan = mp.improve(planar, recorded)
    np.testing.assert_allclose(plan.trajectory.q[0], start, atol=1e-9)
    assert plan.status in (mp.Status.IMPROVED, mp.Status.NOT_BETTER)


@pytest.mark.parametrize("content", ["", "rosbag2_bagfile_information: {}", "{"])
def test_what_is_no_bag_is_told(tmp_path, content):
    (tmp_path / "folder").mkdir()
    (tmp_path / "folder" / "metadata.yaml").write_text(content)
    (tmp_path / "file.bag").write_text(content)
    for file in (tmp_path / "folder", tmp_path / "file.bag"):
        with pytest.raises(mp.errors.FileFormatError, match="a ROS bag that can be read"):
            mp.Trajectory.from_rosbag(file)


def test_wrong_arguments_are_told(motion, tmp_path):
    with pytest.raises(mp.errors.FileFormatError, match=r"the folder of a ROS 2 bag"):
        mp.Trajectory.from_rosbag(tmp_path / "nowhere")
    motion.to_rosbag(tmp_path / "bag")
    with pytest.raises(mp.errors.FileFormatError, match=r"the folder of a ROS 2 bag, with its metadata.yaml"):
        mp.Trajectory.from_rosbag(tmp_path / "bag" / "bag.mcap")
    with pytest.raises(mp.errors.InvalidInputError, match="never overwritten"):
        motion.to_rosbag(tmp_path / "bag")
    with pytest.raises(mp.errors.InvalidInputError, match="a path that can be written"):
        motion.to_rosbag(tmp_path / "no" / "folder")
    for wrong, message in (
        ({"storage": "zip"}, "storage: got 'zip'"),
        ({"rate": 0}, "rate: got 0"),
        ({"rate": np.nan}, "rate"),
    ):
        with pytest.raises(mp.errors.InvalidInputError, match=message):
            motion.to_rosbag(tmp_path / "other", **wrong)
    for wrong in ("abc", [], [1]):
        with pytest.raises(mp.errors.InvalidInputError, match="joints: got"):
            mp.Trajectory.from_rosbag(tmp_path / "bag", joints=wrong)
    with pytest.raises(mp.errors.InvalidInputError, match="file: got 3"):
        mp.Trajectory.from_rosbag(3)
    with pytest.raises(mp.errors.InvalidInputError, match="file: got 3"):
        motion.to_rosbag(3)
    assert {each.name for each in tmp_path.iterdir()} == {"bag"}


def test_without_rosbags_the_line_that_installs_it_is_told(motion, tmp_path, monkeypatch):
    motion.to_rosbag(tmp_path / "bag")
    monkeypatch.setitem(sys.modules, "rosbags.highlevel", None)
    for call in (lambda: motion.to_rosbag(tmp_path / "more"), lambda: mp.Trajectory.from_rosbag(tmp_path / "bag")):
        with pytest.raises(mp.errors.MissingExtraError, match=r"pip install 'manipplan\[ros\]'"):
            call()
    assert not (tmp_path / "more").exists()


@pytest.mark.slow
def test_a_killed_write_leaves_no_bag(tmp_path):
    script = (
        "import sys, numpy as np, manipplan as mp\n"
        "t = np.linspace(0, 1, 50000)\n"
        "motion = mp.Trajectory(t=t, q=np.zeros((50000, 7)), qd=np.zeros((50000, 7)), joint_names=list('abcdefg'))\n"
        "print('ready', flush=True)\n"
        "motion.to_rosbag(sys.argv[1] + '/bag')\n"
    )
    child = subprocess.Popen([sys.executable, "-c", script, str(tmp_path)], stdout=subprocess.PIPE, text=True)
    assert child.stdout.readline() == "ready\n"
    deadline = time.monotonic() + 30
    while not list(tmp_path.rglob("bag.mcap")) and time.monotonic() < deadline:
        time.sleep(0.01)
    os.kill(child.pid, signal.SIGKILL)
    child.wait()
    child.stdout.close()
    [part] = tmp_path.iterdir()
    assert part.name.startswith(".bag.")
    assert list(part.rglob("bag.mcap"))
    mp.Trajectory(t=[0.0, 1.0], q=[[0], [1]], qd=[[0], [0]], joint_names=["a"]).to_rosbag(tmp_path / "bag")
    with Reader(tmp_path / "bag") as bag:
        assert bag.message_count == 102


@pytest.mark.parametrize(
    ("t", "message"), [([0, 1e-10], "whole nanoseconds"), ([0, 1, 1 + 2e-10], "whole"), ([0, 2.0**31], "32 bits")]
)
def test_times_that_ros_cannot_tell_are_refused(tmp_path, t, message):
    """Written all the same, they would be a message that no reader takes."""
    motion = mp.Trajectory(t=t, q=np.zeros((len(t), 1)), qd=np.zeros((len(t), 1)), joint_names=("a",))
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        motion.to_ros(tmp_path / "motion.yaml")
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        motion.to_rosbag(tmp_path / "bag")
    assert list(tmp_path.iterdir()) == []


def test_a_joint_that_is_there_twice_is_told(tmp_path):
    write_states(tmp_path / "bag", [(1 + 0.1 * k, ["a", "a", "b"], [k, 2 * k, 3], []) for k in range(3)])
    for joints in (None, ["a", "b"]):
        with pytest.raises(mp.errors.FileFormatError, match="every joint once; message 1 has a, a, b"):
            mp.Trajectory.from_rosbag(tmp_path / "bag", joints=joints)


def test_a_simulation_begins_at_zero(tmp_path):
    """Its first stamp is zero; the others are of the same clock, not of the bag's."""
    write_states(tmp_path / "bag", [(0.1 * k, "a", [k], [1]) for k in range(4)])
    np.testing.assert_allclose(mp.Trajectory.from_rosbag(tmp_path / "bag").t, [0, 0.1, 0.2, 0.3], atol=1e-9)


def test_a_damaged_bag_is_told(motion, tmp_path, rng):
    motion.to_rosbag(tmp_path / "bag")
    [file] = (tmp_path / "bag").glob("*.mcap")
    for damaged in (file, tmp_path / "bag" / "metadata.yaml"):
        whole = damaged.read_bytes()
        for _ in range(10):
            data = np.frombuffer(whole, np.uint8).copy()
            data[rng.integers(0, len(data), len(data) // 100)] = rng.integers(128, 256)
            damaged.write_bytes(data.tobytes())
            with pytest.raises(mp.errors.FileFormatError):
                mp.Trajectory.from_rosbag(tmp_path / "bag")
        damaged.write_bytes(whole)


@pytest.mark.parametrize("joints", [{"a", "b"}, 7, np.array(["a", "b"]), iter("ab")])
def test_joints_are_a_list(motion, tmp_path, joints):
    motion.to_rosbag(tmp_path / "bag")
    with pytest.raises(mp.errors.InvalidInputError, match="joints: got .* a list of names"):
        mp.Trajectory.from_rosbag(tmp_path / "bag", joints=joints)


def test_topics_and_places_that_are_none(motion, tmp_path):
    motion.to_rosbag(tmp_path / "bag")
    with pytest.raises(mp.errors.UnknownNameError, match="topic"):
        mp.Trajectory.from_rosbag(tmp_path / "bag", ["/joint_states"])
    for name in ("x" * 300, "a\0b"):
        for write in (motion.to_rosbag, motion.to_ros, motion.to_csv):
            with pytest.raises(mp.errors.InvalidInputError, match="file: got .*can be"):
                write(tmp_path / name)
        with pytest.raises(mp.errors.FileFormatError, match="an existing file"):
            mp.Trajectory.from_ros(tmp_path / name)


def test_names_in_one_text_are_no_list(motion, tmp_path):
    motion.to_ros(tmp_path / "motion.yaml")
    motion.to_json(tmp_path / "motion.json")
    yaml_text, json_text = (tmp_path / "motion.yaml").read_text(), (tmp_path / "motion.json").read_text()
    (tmp_path / "motion.yaml").write_text(yaml_text.replace("joint_names: [a, b, c]", "joint_names: abc"))
    (tmp_path / "motion.json").write_text(json_text.replace('["a", "b", "c"]', '"abc"'))
    for read, name in ((mp.Trajectory.from_ros, "motion.yaml"), (mp.Trajectory.from_json, "motion.json")):
        with pytest.raises(mp.errors.FileFormatError, match="joint_names: got 'abc'"):
            read(tmp_path / name)
    (tmp_path / "motion.json").write_text("[" * 100_000)
    with pytest.raises(mp.errors.FileFormatError, match="recursion"):
        mp.Trajectory.from_json(tmp_path / "motion.json")
