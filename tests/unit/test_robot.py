"""Robots from URDF, MJCF and the catalogue: joints, limits, locking, and every wrong input."""

import dataclasses
import pickle

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.viz.viewer.bodies import appearance_of


def test_panda_has_seven_joints_and_locked_fingers(panda):
    assert panda.n == 7
    assert panda.joint_names == tuple(f"panda_joint{i}" for i in range(1, 8))
    assert set(panda.locked) == {"panda_finger_joint1", "panda_finger_joint2"}
    assert panda.tool == "panda_hand_tcp"
    np.testing.assert_allclose(panda.limits.velocity, [2.175] * 4 + [2.61] * 3)
    np.testing.assert_allclose(panda.limits.acceleration, [15, 7.5, 10, 12.5, 15, 20, 20])
    text = str(panda)
    assert "panda_joint4" in text
    assert "locked: panda_finger_joint1" in text


@pytest.mark.slow
def test_continuous_joints_are_plain_angles():
    kinova = mp.load_robot("kinova")
    assert (kinova.model.nq, kinova.model.nv) == (6, 6)
    assert kinova.joint_types.count("continuous") == 3
    assert np.isinf(kinova.limits.upper[0])


def test_from_urdf_defaults_to_all_joints_that_move_the_tool(two_link_urdf):
    robot = mp.Robot.from_urdf(two_link_urdf(), tool="tip")
    assert robot.joint_names == ("turn", "slide")
    assert robot.joint_types == ("revolute", "prismatic")
    np.testing.assert_allclose(robot.limits.acceleration, robot.limits.velocity / 0.2)
    assert "default" in robot.limits.sources["acceleration"]


def test_locking_holds_the_joint(two_link_urdf):
    free = mp.Robot.from_urdf(two_link_urdf(), tool="tip")
    held = mp.Robot.from_urdf(two_link_urdf(), tool="tip", joints=["turn"], locked={"slide": 0.2})
    at = free.kinematics(mp.Task.position()).pose([0.7, 0.2])
    np.testing.assert_allclose(held.kinematics(mp.Task.position()).pose([0.7]), at, atol=1e-14)


def test_a_joint_may_be_locked_outside_its_limits(caplog):
    """As in MotionBenchMaker's data, whose fingers are wider open than the description allows."""
    names = ("panda_finger_joint1", "panda_finger_joint2")
    gaps = []
    for opening in (0.04, 0.065):
        caplog.clear()
        robot = mp.load_robot("panda", locked=dict.fromkeys(names, opening))
        assert ("is locked at 0.065, outside its limits 0 to 0.04" in caplog.text) == (opening > 0.04)
        data = robot.model.createData()
        pin.framesForwardKinematics(robot.model, data, robot.neutral)
        left, right = (data.oMf[robot.model.getFrameId(f"panda_{side}finger")].translation for side in ("left", "right"))
        gaps.append(np.linalg.norm(left - right))
    np.testing.assert_allclose(gaps, [0.08, 0.13], atol=1e-9)


@pytest.mark.slow
def test_mjcf_arm(tmp_path):
    file = tmp_path / "arm.xml"
    file.write_text("""<mujoco model="two"><compiler angle="radian"/><worldbody><body name="upper">
      <joint name="a" type="hinge" axis="0 0 1" range="-1 1" limited="true"/>
      <geom type="capsule" size="0.05" fromto="0 0 0 0.5 0 0"/>
      <body name="fore" pos="0.5 0 0"><joint name="b" type="hinge" axis="0 1 0" range="-2 2" limited="true"/>
      <geom type="capsule" size="0.04" fromto="0 0 0 0.3 0 0"/></body></body></worldbody></mujoco>""")
    robot = mp.load_robot(file, tool="fore", velocity=2.0)
    assert robot.joint_names == ("a", "b")
    np.testing.assert_allclose(robot.limits.upper, [1, 2])
    np.testing.assert_allclose(robot.limits.velocity, [2, 2])
    np.testing.assert_allclose(
        robot.kinematics(mp.Task.position()).pose([np.pi / 6, 0.4])[:3, 3], [0.5 * np.sqrt(0.75), 0.25, 0]
    )


def test_limits_can_be_given(panda):
    slow = panda.with_limits(velocity=0.5, acceleration=np.arange(1.0, 8.0))
    np.testing.assert_allclose(slow.limits.velocity, 0.5)
    np.testing.assert_allclose(slow.limits.acceleration, np.arange(1.0, 8.0))
    np.testing.assert_allclose(slow.limits.upper, panda.limits.upper)
    assert slow.limits.sources["velocity"] == "given"


def test_other_limits_keep_the_posture_inside(panda):
    tight = panda.with_limits(lower=-0.05, upper=0.05)
    assert not tight.limits.outside(tight.neutral).any()


@pytest.mark.slow
def test_locking_does_not_hide_collisions(panda):
    """Links merge when joints are locked; what is adjacent is decided on the whole arm before."""
    locked = {f"panda_joint{i}": value for i, value in {1: 0.0, 2: 1.7, 3: 0.0, 5: 0.0, 6: 1.0, 7: 0.0}.items()}
    elbow = mp.load_robot("panda", joints=["panda_joint4"], locked=locked)
    angles = np.linspace(-3.0, -0.1, 40)
    whole = np.zeros((40, 7))
    whole[:, [1, 5]], whole[:, 3] = (1.7, 1.0), angles
    expected = mp.Scene().in_collision(panda, whole)
    assert expected.any()
    assert not expected.all()
    np.testing.assert_array_equal(mp.Scene().in_collision(elbow, angles[:, None]), expected)


def test_given_limits_stand_in_for_bad_ones(two_link_urdf):
    robot = mp.Robot.from_urdf(two_link_urdf(velocity="0"), tool="tip", velocity=1.0)
    np.testing.assert_allclose(robot.limits.velocity, 1.0)


@pytest.mark.parametrize("value", ["nan", "inf", "two"])
def test_wrong_numbers_in_an_srdf(two_link_urdf, tmp_path, value):
    srdf = tmp_path / "two.srdf"
    srdf.write_text(f'<robot name="two"><group_state name="a"><joint name="turn" value="{value}"/></group_state></robot>')
    with pytest.raises(mp.errors.FileFormatError, match="srdf.*joint values"):
        mp.Robot.from_urdf(two_link_urdf(), tool="tip", srdf=srdf)


def test_a_part_of_a_known_arm():
    assert mp.load_robot("ur5", joints=["elbow_joint", "wrist_1_joint", "wrist_2_joint"]).n == 3
    assert mp.load_robot("ur5", tool="wrist_1_link").n == 4


@pytest.mark.parametrize(
    "error",
    [
        mp.errors.InvalidInputError("a", 1, "b"),
        mp.errors.UnknownNameError("a", "pnada", ["panda"]),
        mp.errors.MissingExtraError("viser", "viewer"),
        mp.errors.PlanningError("no path", 3),
    ],
)
def test_errors_travel_between_processes(error):
    again = pickle.loads(pickle.dumps(error))
    assert (type(again), str(again), again.__dict__) == (type(error), str(error), error.__dict__)


def test_a_changed_copy_has_its_own_kinematics(panda):
    panda.kinematics()
    other = dataclasses.replace(panda, tool="panda_link4")
    assert np.abs(other.kinematics().pose(panda.neutral) - panda.kinematics().pose(panda.neutral)).max() > 0.1
    with pytest.raises(mp.errors.InvalidInputError, match="task: got 'self'"):
        panda.kinematics("self")


def test_another_tool_of_a_humanoid():
    robot = mp.load_robot("icub", tool="r_forearm")
    assert robot.tool == "r_forearm"
    assert robot.joint_names[0] == "r_shoulder_pitch"
    with pytest.raises(mp.errors.UnknownNameError, match="r_forearm"):
        mp.load_robot("icub", tool="r_foream")


def test_planar_arm_reaches_where_trigonometry_says(planar):
    q = np.array([0.3, 0.5, -1.1])
    angles = np.cumsum(q)
    expected = [np.cos(angles).sum(), np.sin(angles).sum(), 0.0]
    np.testing.assert_allclose(planar.kinematics().pose(q)[:3, 3], expected, atol=1e-14)


@pytest.mark.slow
@pytest.mark.parametrize("name", mp.available_robots())
def test_every_arm_of_the_catalogue_loads_with_a_free_usual_posture(name):
    robot = mp.load_robot(name)
    assert not robot.limits.outside(robot.neutral).any()
    assert robot.model.nq == robot.model.nv == robot.n == len(robot.joint_names)
    if name in ("panda", "ur5", "xarm7", "baxter_left", "icub"):  # the fit of primitives takes seconds an arm
        assert not mp.Scene().in_collision(robot, robot.neutral)


def test_unknown_robot_names_the_nearest():
    with pytest.raises(mp.errors.UnknownNameError, match=r"name: got 'pandas'.*panda"):
        mp.load_robot("pandas")


def test_missing_file_names_the_nearest(two_link_urdf):
    file = two_link_urdf(name="robot_arm.urdf")
    with pytest.raises(mp.errors.FileFormatError, match=r"did you mean robot_arm\.urdf"):
        mp.load_robot(file.replace("robot_arm", "robt_arm"))


def test_unknown_frame_names_the_nearest(two_link_urdf):
    with pytest.raises(mp.errors.UnknownNameError, match=r"tool: got 'tipp'.*tip"):
        mp.Robot.from_urdf(two_link_urdf(), tool="tipp")


def test_the_frame_beside_the_fingers_is_the_tool(two_link_urdf):
    assert mp.Robot.from_urdf(two_link_urdf()).tool == "tip"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("<robot name='x'><link name='a'>", "well-formed XML"),
        ("<model/>", "root is <robot>, not <model>"),
        ("<robot name='x'/>", "at least one <link>"),
        ("<robot name='x'><link name='a'/><link name='b'/></robot>", "one root link, .* it has 2: a, b"),
    ],
)
def test_malformed_urdf(tmp_path, text, message):
    file = tmp_path / "bad.urdf"
    file.write_text(text)
    with pytest.raises(mp.errors.FileFormatError, match=message):
        mp.load_robot(file)


def test_missing_mesh_is_named(tmp_path):
    file = tmp_path / "mesh.urdf"
    file.write_text(
        "<robot name='x'><link name='a'><collision><geometry><mesh filename='package://no/such.stl'/></geometry></collision>"
        "</link></robot>"
    )
    with pytest.raises(mp.errors.FileFormatError, match="package_dirs"):
        mp.load_robot(file)


def test_a_package_in_a_folder_of_another_name(tmp_path, caplog):
    """The mesh is found, also when a saved robot is read again; without meshes only the primitives remain."""
    (tmp_path / "parts").mkdir()
    corners = ["0 0 0", "1 0 0", "0 1 0", "0 0 1"]
    faces = ["1 3 2", "1 2 4", "1 4 3", "2 3 4"]
    (tmp_path / "parts" / "m.obj").write_text("".join([f"v {each}\n" for each in corners] + [f"f {each}\n" for each in faces]))
    (tmp_path / "robot").mkdir()
    file = tmp_path / "robot" / "arm.urdf"
    mesh = "<collision><geometry><mesh filename='package://arm_description/m.obj'/></geometry></collision>"
    ball = "<collision><geometry><sphere radius='0.1'/></geometry></collision>"
    file.write_text(
        f"<robot name='arm'><link name='a'/><link name='b'>{mesh}{ball}</link><joint name='j' type='revolute'><parent link='a'/>"
        "<child link='b'/><axis xyz='0 0 1'/><limit lower='-1' upper='1' velocity='1' effort='1'/></joint></robot>"
    )
    packages = {"arm_description": tmp_path / "parts"}
    robot = mp.Robot.from_urdf(file, packages=packages)
    assert [item.name for item in robot.geometry.geometryObjects] == ["b_0", "b_1"] and not caplog.text
    again = robot.source.load()
    assert again.geometry.ngeoms == 2 and again.source == robot.source
    assert appearance_of(robot).origin.startswith("collision geometry (the description has no visual")
    bare = mp.Robot.from_urdf(file, meshes=False)
    assert bare.geometry.ngeoms == 1 and "1 collision meshes are left out" in caplog.text
    assert bare.source.load().geometry.ngeoms == 1
    with pytest.raises(
        mp.errors.FileFormatError, match="packages= gives the folder of a package, .*meshes=False leaves the meshes out"
    ):
        mp.Robot.from_urdf(file)
    with pytest.raises(mp.errors.InvalidInputError, match=r"packages\['arm_description'\].*an existing folder"):
        mp.Robot.from_urdf(file, packages={"arm_description": tmp_path / "nowhere"})
    for options in ({"packages": 3}, {"package_dirs": 5}, {"packages": packages, "locked": 5}):
        with pytest.raises(mp.errors.InvalidInputError, match="packages: got 3|package_dirs: got 5|locked: got 5"):
            mp.Robot.from_urdf(file, **options)


def test_floating_joint_is_named(tmp_path):
    file = tmp_path / "float.urdf"
    file.write_text(
        "<robot name='x'><link name='a'/><link name='b'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' "
        "ixz='0' iyz='0'/></inertial></link><joint name='drift' type='floating'><parent link='a'/><child link='b'/></joint></robot>"
    )
    with pytest.raises(mp.errors.UnsupportedJointError, match="drift"):
        mp.load_robot(file)


@pytest.mark.parametrize("kind", ["planar", "floating"])
@pytest.mark.parametrize("where", [0, 1, 3])
def test_joints_of_several_numbers_leave_the_chain_as_it_is(tmp_path, kind, where):
    text, parents = "<robot name='x'><link name='base'/>", ["base"]
    for k in range(4):
        limit = "<limit lower='-1' upper='1' velocity='1' effort='1'/>"
        text += (
            f"<link name='l{k}'/><joint name='j{k}' type='{kind if k == where else 'revolute'}'><parent link='{parents[-1]}'/>"
            f"<child link='l{k}'/><origin xyz='0 0 0.2'/><axis xyz='0 {k % 2} {(k + 1) % 2}'/>{limit}</joint>"
        )
        parents.append(f"l{k}")
    # a body that drifts, before and after the arm by its name
    for name in ("a", "z"):
        text += f"<link name='{name}'/><joint name='{name}' type='{kind}'><parent link='base'/><child link='{name}'/></joint>"
    file = tmp_path / "x.urdf"
    file.write_text(text + "</robot>")
    with pytest.raises(mp.errors.UnsupportedJointError, match=f"j{where}"):
        mp.Robot.from_urdf(file, tool="l3")
    others = [f"j{k}" for k in range(4) if k != where]
    robot = mp.Robot.from_urdf(file, tool="l3", joints=others)
    assert robot.joint_names == tuple(others) and set(robot.locked) == {f"j{where}", "a", "z"}
    turned = [robot.kinematics(mp.Task.pose(length=1.0)).jacobian(np.zeros(3))[3:, k] for k in range(3)]
    np.testing.assert_allclose(turned, [[0, k % 2, (k + 1) % 2] for k in range(4) if k != where], atol=1e-12)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"joints": ["trun"]}, "joints: got 'trun'.*did you mean turn"),
        ({"joints": ["slide", "turn"]}, "from base to tool: turn, slide"),
        ({"joints": ["finger"]}, "joints that move the tool tip"),
        ({"joints": []}, "at least one joint"),
        ({"locked": {"turn": 0.1}}, "locked"),
        ({"joints": ["turn"], "locked": {"slide": np.nan}}, "finite"),
        ({"joints": ["turn"], "locked": {"slide": [1.0]}}, "a finite number"),
        ({"velocity": 0.0}, r"limits\.velocity: got .*above zero"),
        ({"acceleration": [1.0, -2.0]}, r"limits\.acceleration: got .*above zero"),
        ({"acceleration": [1.0, 2.0, 3.0]}, "one number or 2"),
        ({"lower": [0.0, np.nan]}, "no NaN"),
        ({"lower": [3.0, 0.0]}, "below limits.upper"),
        ({"speed": 1.0}, "limit: got 'speed'"),
        ({"neutral": [0.0, 5.0]}, "inside the position limits"),
    ],
)
def test_wrong_options(two_link_urdf, options, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.Robot.from_urdf(two_link_urdf(), tool="tip", **options)


def test_zero_velocity_in_the_file_is_an_error(two_link_urdf):
    with pytest.raises(mp.errors.InvalidInputError, match=r"velocity limit of turn.*above zero"):
        mp.Robot.from_urdf(two_link_urdf(velocity="0"), tool="tip")


@pytest.mark.parametrize("lengths", [[1.0], [1.0, 0.0], [1.0, -1.0], [1.0, np.nan], "abc", [[1.0, 1.0]]])
def test_wrong_lengths(lengths):
    with pytest.raises(mp.errors.InvalidInputError, match="lengths"):
        mp.planar_arm(lengths)


def test_unaligned_axis_turns_like_pinocchio(two_link_urdf):
    robot = mp.Robot.from_urdf(two_link_urdf(axis="0 0.6 0.8"), tool="tip")
    q = np.array([0.9, 0.1])
    data = robot.model.createData()
    pin.framesForwardKinematics(robot.model, data, q)
    oracle = data.oMf[robot.model.getFrameId("tip")].homogeneous
    np.testing.assert_allclose(robot.kinematics(mp.Task.position()).pose(q), oracle, atol=1e-14)


@pytest.mark.slow
def test_a_used_robot_can_be_pickled(panda):
    panda.kinematics()
    mp.Scene().in_collision(panda, panda.neutral)
    again = pickle.loads(pickle.dumps(panda))
    np.testing.assert_array_equal(again.kinematics().pose(panda.neutral), panda.kinematics().pose(panda.neutral))


@pytest.mark.parametrize("name", [None, 3, ["panda"]])
def test_a_name_has_to_be_text(name):
    with pytest.raises(mp.errors.InvalidInputError, match="name: got"):
        mp.load_robot(name)


def test_a_velocity_limit_near_the_largest_number(two_link_urdf):
    """The acceleration that would reach it in 0.2 s is no number, and so no limit."""
    limits = mp.Robot.from_urdf(two_link_urdf(velocity="1e308"), tool="tip").limits
    assert limits.velocity[0] == 1e308
    assert np.isinf(limits.acceleration[0])
