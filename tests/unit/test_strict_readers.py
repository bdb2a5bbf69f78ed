"""Files of motions, poses, scenes and settings are read as they are, or refused."""

import json
import string

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import manipplan as mp
from manipplan.paths.table import NUMBER
from manipplan.support.data_files import read_yaml

ARM = mp.planar_arm([1.0, 1.0])
HEAD = "time,q_joint1,q_joint2\n"


def written(folder, name, text):
    file = folder / name
    file.write_text(text, encoding="utf-8")
    return file


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("time,q_a\n0,0,5\n1,0,7", "row 2, with 3 cells.*2 cells.*decimal comma"),
        (HEAD + "0,0,0\n1,0,1,\n", "row 3, with 4 cells"),
        (HEAD + "0,0,0\n1,1_0,0\n", "row 3, q_joint1: 1_0.*a number"),
        (HEAD + "0,0,0\n1,0x1,0\n", "row 3, q_joint1: 0x1.*a number"),
        (HEAD + "0,0,0\n1,١,0\n", "row 3, q_joint1: .*a number"),
        (HEAD + "0,0,0\n1,true,0\n", "row 3, q_joint1: true.*a number"),
        (HEAD + "0,0,0\n1,1e400,0\n", "row 3, q_joint1: 1e400.*a finite number"),
        (HEAD + "0,0,0\n1,0", "row 3, with 2 cells.*3 cells"),
        (HEAD + '0,0,0\n1,"0,0\n', "row|CSV"),
        ("time [ms],q_joint1\n0,0\n1,0\n", "no column time or t"),
        ("time;q_joint1\n0;0\n1;0\n", "no column|first line"),
        ("time,time,q_joint1\n0,0,0\n1,1,1\n", "2 column time"),
    ],
)
def test_a_table_that_may_mean_something_else_is_refused(tmp_path, text, message):
    file = written(tmp_path, "motion.csv", text)
    with pytest.raises(mp.errors.FileFormatError, match=message):
        mp.Trajectory.from_csv(file)


def test_a_last_row_without_a_line_end_is_read(tmp_path):
    motion = mp.Trajectory.from_csv(written(tmp_path, "motion.csv", HEAD + "0,0,0\n1,1,2\n2,3,3"))
    np.testing.assert_array_equal(motion.q, [[0, 0], [1, 2], [3, 3]])


@given(st.text(string.printable, max_size=8))
def test_a_number_of_a_table_is_what_every_language_reads(text):
    """Judged by JSON's own grammar, with a sign, leading zeros and a bare point besides."""
    if NUMBER.fullmatch(text):
        assert "_" not in text and "," not in text and not set(text.lower()) - set("0123456789.+-einfaty")
        float(text)


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_every_number_that_is_written_is_read(value):
    assert NUMBER.fullmatch(repr(value))
    assert NUMBER.fullmatch(f"{value:.17g}")


def test_columns_and_degrees(tmp_path):
    file = written(tmp_path, "log.csv", "timestamp,J1,J2,J3,current\n5,0,90,180,1\n6,10,90,180,1\n7,20,90,180,1\n")
    names = {"time": "timestamp", "joint1": "J1", "joint2": "J3"}
    motion = mp.Trajectory.from_csv(file, columns=names, degrees=True)
    assert motion.joint_names == ("joint1", "joint2")
    np.testing.assert_allclose(motion.t, [0, 1, 2])
    np.testing.assert_allclose(np.rad2deg(motion.q), [[0, 180], [10, 180], [20, 180]])
    slide = mp.Trajectory.from_csv(file, joints=["joint2", "joint1"], columns=names, degrees=["joint1"])
    np.testing.assert_allclose(slide.q[:, 0], 180)
    np.testing.assert_allclose(np.rad2deg(slide.q[:, 1]), [0, 10, 20])
    report = mp.check(
        ARM, written(tmp_path, "log2.csv", "timestamp,J1,J2\n0,0,0\n1,5,10\n"), columns=names | {"joint2": "J2"}, degrees=True
    )
    assert report.duration == 1.0
    for options, message in (
        ({"columns": {"nope": "J1"}, "joints": ["joint1"]}, "columns: got 'nope'"),
        ({"columns": {"joint1": "J9"}}, "no column J9"),
        ({"columns": names, "degrees": ["J1"]}, "degrees: got 'J1'"),
        ({"columns": "J1"}, "columns: got 'J1'; allowed: a mapping"),
    ):
        with pytest.raises(mp.errors.InvalidInputError, match=message):
            mp.Trajectory.from_csv(file, **options)
    with pytest.raises(mp.errors.InvalidInputError, match="columns: .*None but for a CSV file"):
        mp.check(ARM, motion, columns=names)


@pytest.fixture
def motion():
    return mp.Trajectory(t=[0, 1, 2], q=[[0, 0], [0.1, 0], [0.3, 0]], qd=np.zeros((3, 2)), joint_names=("joint1", "joint2"))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda text: text.replace('"time": [', '"time": [0, 5, 9], "time": ['), "the key 'time' is repeated"),
        (lambda text: text.replace('"joint_names"', '"joint_names": ["x", "y"], "joint_names"'), "'joint_names' is repeated"),
        (lambda text: text.replace("0.1", "true"), "real numbers"),
        (lambda text: text.replace('"version"', '"unit": "degrees", "version"'), "key: got 'unit'"),
        (lambda text: text.replace("0.1", "NaN"), "NaN is no number of JSON"),
        (lambda text: text.replace("0.1", "1e999"), "finite"),
    ],
)
def test_a_trajectory_in_json_that_may_mean_something_else_is_refused(tmp_path, motion, change, message):
    motion.to_json(tmp_path / "motion.json")
    file = written(tmp_path, "motion.json", change((tmp_path / "motion.json").read_text()))
    with pytest.raises(mp.errors.FileFormatError, match=message):
        mp.Trajectory.from_json(file)


@pytest.mark.parametrize(
    "value", ["1:30", "010", "yes", "on", "1_0", "0b11", "2001-01-01", "-012", "1:30.5", "'1.0'", "true", "No"]
)
def test_ambiguous_values_of_yaml_are_refused(tmp_path, value):
    point = "- {positions: [%s, 0.0], velocities: [0, 0], time_from_start: {sec: %d, nanosec: 0}}\n"
    file = written(
        tmp_path, "motion.yaml", "joint_names: [joint1, joint2]\npoints:\n" + point % ("0.0", 0) + point % (value, 1)
    )
    with pytest.raises(mp.errors.FileFormatError, match="ambiguous|real numbers"):
        mp.Trajectory.from_ros(file)
    file = written(tmp_path, "scene.yaml", f"obstacles:\n- {{shape: sphere, radius: {value}}}\n")
    with pytest.raises(mp.errors.InvalidInputError, match="ambiguous|a finite number"):
        mp.Scene.from_yaml(file)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1e-3", 1e-3),  # a text in YAML 1.1
        ("0o17", 15),
        ("0xff", 255),
        (".5", 0.5),
        ("-0", 0),
        ("+3", 3),
        ("y", "y"),
        ("~", None),
        ("'yes'", "yes"),
        ("!!str 010", "010"),
        ("!!float 3", 3.0),
        (".inf", np.inf),
        ("True", True),
        ("a:b", "a:b"),
        ("1.2.3", "1.2.3"),
        ("192.168.0.1", "192.168.0.1"),
    ],
)
def test_yaml_by_the_rules_of_its_version_1_2(tmp_path, text, value):
    read = read_yaml("a", written(tmp_path, "a.yaml", f"a: {text}\n"))["a"]
    assert read == value and type(read) is type(value)


@pytest.mark.slow
@given(
    st.recursive(
        st.none()
        | st.booleans()
        | st.integers()
        | st.floats(allow_nan=False, allow_infinity=False)
        | st.text(string.printable),
        lambda inner: (
            st.lists(inner, max_size=4) | st.dictionaries(st.text(string.ascii_letters, min_size=1), inner, max_size=4)
        ),
        max_leaves=12,
    )
)
def test_json_is_yaml(tmp_path_factory, value):
    """Every JSON text is YAML 1.2 with the same value, judged by the standard library's reader."""
    file = tmp_path_factory.mktemp("a") / "a.yaml"
    file.write_text(json.dumps(value), encoding="utf-8")
    assert read_yaml("a", file) == value


@pytest.mark.parametrize(
    ("points", "message"),
    [
        (
            "- {positions: [0, 0], velocity: [0, 0], time_from_start: {sec: 0, nanosec: 0}}",
            r"points\[0\]: got 'velocity'.*velocities",
        ),
        ("- {positions: [0, 0]}", r"points\[0\]: .*time_from_start"),
        ("- 3", r"points\[0\]: got 3"),
    ],
)
def test_points_of_ros_have_the_keys_of_the_message(tmp_path, points, message):
    with pytest.raises(mp.errors.FileFormatError, match=message):
        mp.Trajectory.from_ros(written(tmp_path, "motion.yaml", f"joint_names: [a, b]\npoints:\n{points}\n"))


def test_a_ros_message_without_velocities_is_read_as_a_table(tmp_path):
    for velocities in ("", "velocities: [], "):
        point = "- {positions: [%s, 0.0], " + velocities + "time_from_start: {sec: %d, nanosec: 0}}\n"
        ros = written(tmp_path, "m.yaml", "joint_names: [a, b]\npoints:\n" + "".join(point % (0.1 * k**2, k) for k in range(4)))
        table = written(tmp_path, "m.csv", "time,q_a,q_b\n" + "".join(f"{k},{0.1 * k**2},0.0\n" for k in range(4)))
        np.testing.assert_allclose(mp.Trajectory.from_ros(ros).qd, mp.Trajectory.from_csv(table).qd, atol=1e-12)
    mixed = ros.read_text().replace("velocities: [], ", "velocities: [0, 0], ", 1)
    with pytest.raises(mp.errors.FileFormatError, match=r"points\[1\].velocities: .*in all points or in none"):
        mp.Trajectory.from_ros(written(tmp_path, "mixed.yaml", mixed))


def test_a_mesh_named_by_package_stays_in_it(tmp_path):
    inside = tmp_path / "package"
    inside.mkdir()
    written(tmp_path, "x.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    text = "world:\n  collision_objects:\n  - {id: a, meshes: [{resource: 'package://p/../x.obj'}], mesh_poses: [{position: {x: 0}}]}\n"
    with pytest.raises(mp.errors.InvalidInputError, match="stays inside its package|meshes|resource"):
        mp.Scene.from_moveit(written(tmp_path, "scene.yaml", text), packages={"p": inside})


def test_names_for_a_controller(tmp_path):
    q = np.array([0.0, -1.5, 1.2, -1.0, -1.5, 0.0])
    own = mp.retime(mp.JointPath.line(q, q + 0.2), mp.load_robot("ur5"))
    arm = own.named([f"axis{k}" for k in range(6)])
    with pytest.raises(mp.errors.InvalidInputError, match="joint_names"):
        arm.to_urscript(tmp_path / "a.script")
    arm.to_urscript(tmp_path / "a.script", joint_names=own.joint_names)
    own.to_urscript(tmp_path / "b.script")
    assert (tmp_path / "a.script").read_text() == (tmp_path / "b.script").read_text()
    arm.to_ros(tmp_path / "a.yaml", joint_names=own.joint_names)
    assert mp.Trajectory.from_ros(tmp_path / "a.yaml").joint_names == own.joint_names
    for names in (["a"] * 6, ["a"], "abcdef"):
        with pytest.raises(mp.errors.InvalidInputError, match="joint_names"):
            arm.named(names)
