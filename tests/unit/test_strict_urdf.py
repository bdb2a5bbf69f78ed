"""URDF and SRDF files with misspelt, doubled or missing parts: refused by name, where urdfdom reads something else in silence."""

import importlib.util
import logging
import re

import coal
import numpy as np
import pytest
import trimesh

import manipplan as mp
from manipplan.robots import urdf_files

ARM = """<robot name="arm">
  <link name="base"/>
  <link name="l1"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
    <collision><origin xyz="0.2 0 0"/><geometry><box size="0.3 0.1 0.1"/></geometry></collision></link>
  <link name="l2"><collision><geometry><sphere radius="0.05"/></geometry></collision></link>
  <joint name="j1" type="revolute"><parent link="base"/><child link="l1"/><origin xyz="0 0 0.5"/><axis xyz="0 0 1"/>
    <limit lower="-2" upper="2" velocity="1" effort="10"/></joint>
  <joint name="j2" type="prismatic"><parent link="l1"/><child link="l2"/><origin xyz="0.5 0 0"/><axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" velocity="1" effort="10"/></joint>
</robot>
"""


@pytest.fixture
def edited(tmp_path):
    """The file of the arm with some text replaced."""

    def write(*changes, name="arm.urdf"):
        text = ARM
        for old, new in changes:
            assert old in text
            text = text.replace(old, new, 1)
        (tmp_path / name).write_text(text, encoding="utf-8")
        return tmp_path / name

    return write


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("<axis xyz=", "<axis xyx=", "joint j1: <axis> has no attribute 'xyx'; did you mean xyz"),
        ('<axis xyz="0 0 1"/>', '<Axis xyz="0 0 1"/>', "joint j1: <Axis> is not an element of URDF; did you mean <axis>"),
        ('<axis xyz="0 0 1"/>', '<axis xyz="0 0 0"/>', "joint j1: <axis> needs xyz with 3 numbers, not all zero"),
        ('<axis xyz="0 0 1"/>', "<axis/>", "joint j1: <axis> needs xyz with 3 numbers"),
        ('<axis xyz="0 0 1"/>', '<axis xyz="0 0 1"/><axis xyz="1 0 0"/>', "joint j1: it has more than one <axis>"),
        ('<origin xyz="0 0 0.5"/>', '<origin xyx="0 0 0.5"/>', "joint j1: <origin> has no attribute 'xyx'"),
        ('<origin xyz="0 0 0.5"/>', '<origin XYZ="0 0 0.5"/>', "joint j1: <origin> has no attribute 'XYZ'; did you mean xyz"),
        ('<origin xyz="0 0 0.5"/>', '<Origin xyz="0 0 0.5"/>', "joint j1: <Origin> is not an element of URDF"),
        ('<origin xyz="0 0 0.5"/>', '<origin xyz="0 0 0.5"/><origin/>', "joint j1: it has more than one <origin>"),
        ('upper="2"', 'uper="2"', "joint j1: <limit> has no attribute 'uper'; did you mean upper"),
        ('upper="2"', 'max="2"', "joint j1: <limit> has no attribute 'max'; it has lower, upper"),
        ('<limit lower="-2"', "<limit/><limit lower='-2'", "joint j1: it has more than one <limit>"),
        ('<limit lower="-2" upper="2" velocity="1" effort="10"/>', "", "joint j1: a revolute joint needs a <limit>"),
        ('<limit lower="-1" upper="1" velocity="1" effort="10"/>', "", "joint j2: a prismatic joint needs a <limit>"),
        ('velocity="1" effort="10"', 'effort="10"', "joint j1: <limit> needs velocity with a number, not None"),
        ('velocity="1" effort="10"', 'velocity="1"', "joint j1: <limit> needs effort with a number, not None"),
        ('lower="-2"', 'lower="nan"', "joint j1: <limit> needs lower with a number, not 'nan'"),
        ('<parent link="base"/>', '<parent link="base"/><parent link="l2"/>', "joint j1: it has more than one <parent>"),
        ('<child link="l1"/>', '<child link="l1"/><child link="l2"/>', "joint j1: it has more than one <child>"),
        ('<parent link="base"/>', "", "joint j1: it needs a <parent>"),
        ('<parent link="base"/>', '<parent lnk="base"/>', "joint j1: <parent> has no attribute 'lnk'; did you mean link"),
        ('<parent link="base"/>', '<parent link="bse"/>', "joint j1: link: got 'bse'; allowed: did you mean base"),
        ('<parent link="l1"/>', '<parent link="l2"/>', "without a closed loop, unlike that of l2"),
        ('<child link="l2"/>', '<child link="l1"/>', "joint j2: link l1 is the child of joint j1 already"),
        ('<parent link="base"/>', '<parent link="l2"/>', "without a closed loop, unlike that of l1, l2"),
        ('<link name="base"/>', "", "joint j1: link: got 'base'"),
        ('<link name="base"/>', '<link name="base"/><link name="other"/>', "one root link, .* it has 2: base, other"),
        ('<link name="base"/>', '<link name="base"/><link name="base"/>', "link base: several links have this name"),
        ('<link name="base"/>', '<link name="base"/><link/>', "link number 2: it has no name"),
        ('name="j2"', 'name="j1"', "joint j1: several joints have this name"),
        ('type="revolute"', 'type="revolut"', "joint j1: type: got 'revolut'; allowed: did you mean revolute"),
        ('type="revolute"', "", "joint j1: type: got 'None'"),
        ('<robot name="arm">', "<robot>", "<robot> has a name"),
        ('<box size="0.3 0.1 0.1"/>', '<box sise="0.3 0.1 0.1"/>', "<box> has no attribute 'sise'; did you mean size"),
        ('<box size="0.3 0.1 0.1"/>', '<Box size="0.3 0.1 0.1"/>', "<Box> is not a shape of URDF"),
        ('<sphere radius="0.05"/>', '<sphere radius="0.05" length="1"/>', "<sphere> has no attribute 'length'; it has radius"),
        (
            '<sphere radius="0.05"/>',
            '<mesh filename="a.stl" scal="2 2 2"/>',
            "<mesh> has no attribute 'scal'; did you mean scale",
        ),
        ('<origin xyz="0.2 0 0"/>', '<orign xyz="0.2 0 0"/>', "collision element 1 of link l1: <orign> is not an element"),
    ],
)
def test_what_is_misspelt_doubled_or_missing(edited, capfd, old, new, message):
    with pytest.raises(mp.errors.FileFormatError, match=message) as caught:
        mp.load_robot(edited((old, new)))
    assert "arm.urdf" in str(caught.value)
    assert capfd.readouterr() == ("", "")  # urdfdom prints what it does not say


@pytest.mark.parametrize("tag", ["colision", "Collision", "collisions", "a:collision", "visual_"])
def test_misspelt_elements_of_a_link(tmp_path, tag):
    """The body would be lost."""
    text = ARM.replace("<collision>", f"<{tag}>", 1).replace("</collision>", f"</{tag}>", 1)
    (tmp_path / "arm.urdf").write_text(text)
    wanted = "visual" if tag == "visual_" else "collision"
    with pytest.raises(mp.errors.FileFormatError, match=f"link l1: <{tag}> is not an element of URDF; did you mean <{wanted}>"):
        mp.load_robot(tmp_path / "arm.urdf")


@pytest.mark.parametrize(
    "element",
    [
        '<gazebo reference="l1"><material>Grey</material></gazebo>',
        '<gazebo:plugin name="x"/>',
        '<transmission name="t"><joint name="j1"/></transmission>',
        '<drake:joint name="j1"/>',
        "<drake:collision_filter_group/>",
        '<mujoco><compiler meshdir="."/></mujoco>',
        '<ros2_control name="x"><joint name="j1"/></ros2_control>',
        '<sensor name="s"/>',
        '<material name="grey"/>',
        "<self_collision_checking/>",
    ],
)
def test_elements_of_other_programs(edited, caplog, element):
    robot = mp.load_robot(edited(("</robot>", element + "</robot>")))
    assert robot.n == 2 and robot.geometry.ngeoms == 2 and not caplog.text


@pytest.mark.parametrize(
    ("old", "new"),
    [
        (
            "</joint>",
            '<dynamics damping="1"/><dynamics damping="a"/><calibration rising="0"/><safety_controller k_velocity="1"/></joint>',
        ),
        ("</collision>", "<material name='a'/><verbose value='x'/><surface/><drake:proximity_properties/></collision>"),
        ("</link>", "<contact><lateral_friction value='1'/></contact><self_filter/><gravity/></link>"),
        ('<axis xyz="0 0 1"/>', '<axis xyz="0 0 1" rpy="0 0 0"/>'),
        ('effort="10"/>', 'effort="10" acceleration="2" drake:acceleration="3" soft_lower_limit="0"/>'),
        ("<box", "<drake:declare_convex/><box"),
        (
            "</robot>",
            '<joint name="f" type="fixed"><parent link="l2"/><child link="t"/><axis xyz="0 0 0"/></joint><link name="t"/></robot>',
        ),
    ],
)
def test_what_changes_nothing(edited, caplog, old, new):
    robot = mp.load_robot(edited((old, new)))
    assert robot.n == 2 and robot.geometry.ngeoms == 2 and not caplog.text
    assert robot.limits.upper.tolist() == [2.0, 1.0]


def test_elements_that_nobody_knows_are_in_the_log(edited, caplog):
    mp.load_robot(edited(("</link>", "<weight/></link>"), ("</robot>", "<loop_joint/></robot>")))
    assert "elements that URDF does not have are passed over: <loop_joint> in <robot>, <weight> in <link>" in caplog.text


def test_numbers_reach_the_model_in_full(edited):
    file = edited(('xyz="0 0 0.5"', 'xyz=" 0 1e-3  0.12345678901234567 "'), ('upper="2"', 'upper=" 1.0000000000000002"'))
    robot = mp.load_robot(file)
    np.testing.assert_array_equal(robot.model.jointPlacements[1].translation, [0, 1e-3, 0.12345678901234567])
    assert robot.limits.upper[0] == 1.0000000000000002


def test_capsules(edited):
    robot = mp.load_robot(edited(('<box size="0.3 0.1 0.1"/>', '<capsule radius="0.1" length="0.4"/>')))
    capsule = robot.geometry.geometryObjects[0].geometry
    assert isinstance(capsule, coal.Capsule) and (capsule.radius, capsule.halfLength) == (0.1, 0.2)


@pytest.mark.parametrize("shape", ['<box size="0 0 0"/>', '<sphere radius="0"/>', '<cylinder radius="0" length="0.0"/>'])
def test_bodies_of_size_zero_are_left_out(edited, caplog, shape):
    robot = mp.load_robot(edited(('<sphere radius="0.05"/>', shape)))
    assert [item.name for item in robot.geometry.geometryObjects] == ["l1_0"]
    assert "collision element 1 of link l2 has size 0 and is left out" in caplog.text


def test_limits_below_zero(edited, caplog):
    robot = mp.load_robot(edited(('effort="10"', 'effort="-1"')))
    assert robot.limits.effort.tolist() == [np.inf, 10.0]
    assert "effort limits below zero count as no limit: joint j1 (-1.0)" in caplog.text
    with pytest.raises(mp.errors.InvalidInputError, match="velocity limit of j1"):
        mp.load_robot(edited(('velocity="1"', 'velocity="-1"')))
    assert "velocity limits below zero count as 0: joint j1 (-1.0)" in caplog.text
    assert mp.load_robot(edited(('velocity="1"', 'velocity="-1"')), velocity=2.0).limits.velocity.tolist() == [2.0, 2.0]


def test_bodies_from_visual_elements(edited, caplog):
    visual = '<visual><origin xyz="0.1 0 0"/><geometry><cylinder radius="0.1" length="0.2"/></geometry></visual></link>'
    file = edited(("</link>", visual))
    robot = mp.Robot.from_urdf(file, collision="visual")
    [body] = robot.geometry.geometryObjects
    assert (body.name, type(body.geometry)) == ("l1_0", coal.Cylinder)
    assert robot.source.load().geometry.ngeoms == 1 and mp.Robot.from_urdf(file).geometry.ngeoms == 2
    assert "nothing of the robot is checked" not in caplog.text
    bare = edited(*2 * [("<collision>", "<visual>"), ("</collision>", "</visual>")])
    assert mp.Robot.from_urdf(bare).geometry.ngeoms == 0
    assert "no link has a collision element, so nothing of the robot is checked; collision='visual'" in caplog.text
    with pytest.raises(mp.errors.UnknownNameError, match="collision: got 'visuals'; allowed: did you mean visual"):
        mp.Robot.from_urdf(file, collision="visuals")
    file = edited(("</link>", "<visual><geometry><cone/></geometry></visual></link>"))
    assert mp.Robot.from_urdf(file).geometry.ngeoms == 2
    with pytest.raises(mp.errors.FileFormatError, match="visual element 1 of link l1: <cone> is not a shape"):
        mp.Robot.from_urdf(file, collision="visual")


@pytest.mark.parametrize("before", ["\n", "\ufeff", "\ufeff\n\n  "])
def test_what_ros_s_parser_takes(edited, before):
    file = edited(("</robot>", "<gazebo:sensor/><gazebo:plugin a:b='1'/></robot>"))
    file.write_text(f'{before}<?xml version="1.0"?>\n{file.read_text()}', encoding="utf-8")
    assert mp.load_robot(file).n == 2


XACRO = 'xmlns:xacro="http://ros.org/wiki/xacro"'


@pytest.mark.parametrize(
    ("changes", "upper"),
    [
        ([("</robot>", f'<xacro:property {XACRO} name="a" value="1"/></robot>')], 2.0),
        ([("<robot ", f"<robot {XACRO} "), ('upper="2"', 'upper="${1 + 0.5}"')], 1.5),
        ([("<robot ", f"<robot {XACRO} ")], 2.0),
    ],
)
def test_a_urdf_with_elements_of_xacro_is_expanded(edited, monkeypatch, changes, upper):
    file = edited(*changes)
    assert mp.load_robot(file).limits.upper[0] == upper
    monkeypatch.setattr(urdf_files.importlib.util, "find_spec", lambda name: None)
    if len(changes) == 1 and changes[0][0] == "<robot ":  # the xmlns alone expands to nothing
        assert mp.load_robot(file).n == 2
    else:
        with pytest.raises(mp.errors.MissingExtraError, match=r"pip install 'manipplan\[xacro\]'"):
            mp.load_robot(file)


def test_arguments_of_a_urdf_with_xacro(edited):
    file = edited(
        ("<robot ", f"<robot {XACRO} "), ("<link", '<xacro:arg name="u" default="1"/><link'), ('upper="2"', 'upper="$(arg u)"')
    )
    assert mp.load_robot(file, arguments={"u": 0.5}).limits.upper[0] == 0.5
    assert importlib.util.find_spec("xacro") is not None


def test_a_prefix_xacro_without_a_namespace(edited, caplog):
    assert mp.load_robot(edited(("</robot>", '<xacro:property name="a" value="1"/></robot>'))).n == 2
    assert "1 elements <xacro:...> are passed over: the file has no xmlns:xacro" in caplog.text


SRDF = """<robot name="arm"><group name="g"><joint name="j1"/></group>
  <group_state name="up" group="g"><joint name="j1" value="1"/><joint name="j2" value="0.5"/></group_state>
  <disable_collisions link1="base" link2="l2" reason="Never"/><virtual_joint name="v" type="floating"/></robot>"""


def with_srdf(edited, tmp_path, old, new):
    assert old in SRDF
    (tmp_path / "arm.srdf").write_text(SRDF.replace(old, new, 1))
    return mp.Robot.from_urdf(edited(), srdf=tmp_path / "arm.srdf")


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("link2=", "lnk2=", "link1, link2 and a reason, not with link1, lnk2, reason"),
        ('link2="l2"', 'link2="l2" reson="x"', "not with link1, link2, reson, reason"),
        ('link2="l2"', "", "link1, link2 and a reason"),
        ("<disable_collisions", "<disable_collision", "<disable_collision>: did you mean <disable_collisions>"),
        ('value="1"', 'value="0.1 0.2"', "one number per joint; j1 of the state up is '0.1 0.2'"),
        ('value="1"', 'value="nan"', "one number per joint; j1 of the state up is 'nan'"),
        ('value="1"', 'val="1"', "one number per joint; j1 of the state up is None"),
        ('<joint name="j2" value', '<joint name="j1" value', "one value per joint of a state; j1 of up is 1 and '0.5'"),
        ("<disable", '<group_state name="up" group="g"/><disable', "each state of a group once; up is there twice"),
    ],
)
def test_srdf_files_that_are_refused(edited, tmp_path, old, new, message):
    with pytest.raises(mp.errors.FileFormatError, match=message) as caught:
        with_srdf(edited, tmp_path, old, new)
    assert "arm.srdf" in str(caught.value)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('link2="l2"', 'link2="l3"', "links in <disable_collisions> that the robot does not have: l3"),
        ('joint name="j2" value', 'joint name="j3" value', "joints in <group_state> that the robot does not have: j3"),
        ('robot name="arm"', 'robot name="leg"', "is for the robot leg, not for arm"),
    ],
)
def test_srdf_files_with_names_of_another_robot(edited, tmp_path, caplog, old, new, message):
    with caplog.at_level(logging.INFO):
        with_srdf(edited, tmp_path, old, new)
    [record] = [each for each in caplog.records if message in each.getMessage()]
    assert (record.levelno == logging.WARNING) == ("links" in message)  # that pair is checked


def test_a_whole_srdf(edited, tmp_path, caplog):
    robot = with_srdf(
        edited,
        tmp_path,
        "<disable",
        '<group_state name="up" group="h"><joint name="v" value="0 0 0 0 0 0 1"/></group_state><disable',
    )
    assert robot.states["up"].tolist() == [1.0, 0.5] and not caplog.text


@pytest.mark.slow
def test_the_catalogue_says_nothing(caplog):
    """One SRDF serves three arms of UR; that of Baxter has joints that the description lacks."""
    pytest.importorskip("example_robot_data")
    with caplog.at_level(logging.WARNING):
        for name in ("ur3", "baxter", "icub"):
            mp.load_robot(name)
    assert not caplog.text


@pytest.mark.parametrize(
    ("old", "new", "named"),
    [
        ('lower="-2" upper="2"', 'lower="-170" upper="2"', 'joint j1: lower="-170"'),
        ('<origin xyz="0 0 0.5"/>', '<origin xyz="0 0 0.5" rpy="0 90 0"/>', 'joint j1: rpy="0 90 0"'),
        ('<origin xyz="0.2 0 0"/>', '<origin xyz="0.2 0 0" rpy="-45 0 0"/>', 'collision element 1 of link l1: rpy="-45 0 0"'),
        ('lower="-2" upper="2"', 'lower="-12.6" upper="25"', None),
        ('lower="-2" upper="2"', 'lower="-1e16" upper="1e16"', None),
        ('lower="-1" upper="1"', 'lower="-90" upper="90"', None),  # a slide, in metres
    ],
)
def test_angles_that_look_like_degrees_are_in_the_log(edited, caplog, old, new, named):
    mp.load_robot(edited((old, new)))
    warnings = [each.getMessage() for each in caplog.records if each.levelno >= logging.WARNING]
    assert any(named in each and "radians" in each for each in warnings) if named else not warnings


def test_a_urdf_is_no_srdf(edited):
    file = edited()
    with pytest.raises(mp.errors.FileFormatError, match="srdf: .*an SRDF; this file has <link> elements"):
        mp.load_robot(file, srdf=file)


def test_a_kind_of_joint_that_is_like_none_gets_the_list(edited):
    with pytest.raises(
        mp.errors.FileFormatError, match="joint j1: type: got 'rotational'; allowed: one of continuous, fixed, .*revolute"
    ):
        mp.load_robot(edited(('type="revolute"', 'type="rotational"')))


def test_a_state_outside_the_limits_is_in_the_log(edited, tmp_path, caplog):
    state = '<group_state name="home"><joint name="j1" value="90"/><joint name="j2" value="0.5"/></group_state>'
    (tmp_path / "arm.srdf").write_text(f'<robot name="arm">{state}</robot>')
    mp.load_robot(edited(), srdf=tmp_path / "arm.srdf")
    assert "state home of the SRDF is outside the limits: j1 is 90" in caplog.text


def test_limits_that_the_file_does_not_give_have_no_source(edited):
    robot = mp.load_robot(edited(('effort="10"', 'effort="0"'), ('effort="10"', 'effort="0"')))
    assert np.isinf(robot.limits.effort).all()
    assert robot.limits.sources["effort"] == "none in the URDF; effort= gives them"


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"tool": "base"}, "tool: got 'base'; allowed: a frame that a joint moves"),
        (
            {"locked": {"j1": 0.0}},
            r"locked\['j1'\]: got 0.0; allowed: joints that are not active; j1 is active, as it moves the tool: joints= without",
        ),
        ({"locked": {"j3": 0.0}}, "locked: got 'j3'; allowed: one of j1, j2"),
    ],
)
def test_joints_and_tools_that_cannot_be(edited, options, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.load_robot(edited(), **options)


def test_a_misspelt_locked_joint_is_the_nearest_of_all_joints():
    with pytest.raises(
        mp.errors.UnknownNameError, match=r"locked: got 'panda_jont1'; allowed: did you mean panda_joint1, .*\?"
    ):
        mp.load_robot("panda", locked={"panda_jont1": 0.0})


@pytest.mark.parametrize("size", [(30.0, 0.1, 0.1), (0.1, 0.1, 200.0)])
def test_a_part_in_another_unit_is_refused(edited, size):
    robot = mp.load_robot(edited())
    assert robot.attach(mp.Box(size=np.minimum(size, 4.0), name="rod")).carried
    with pytest.raises(mp.errors.InvalidInputError, match=f"rod is {max(size):g} m long. Is it in another unit"):
        robot.attach(mp.Box(size=size, name="rod"))


@pytest.mark.parametrize("count", [3, 6, 7])
def test_a_goal_of_as_many_numbers_as_a_pose_says_how_poses_are_given(edited, count):
    with pytest.raises(
        mp.errors.InvalidInputError, match=rf"goal: .*pose of the tool as a \(4, 4\) matrix.*not {count} numbers"
    ):
        mp.plan(mp.load_robot(edited()), [0.0, 0.0], [0.1] * count)


@pytest.mark.parametrize(
    "goal", [np.array(0.5), [[0.1], [0.1, 0.2], 0.3], np.zeros((3, 2, 2))], ids=("number", "ragged", "block")
)
def test_goals_of_odd_shapes_are_refused(edited, goal):
    with pytest.raises(mp.errors.InvalidInputError, match="goal"):
        mp.plan(mp.load_robot(edited()), [0.0, 0.0], goal)


def test_an_allowed_pair_with_a_wrong_name_is_named(edited):
    scene = mp.Scene([mp.Sphere(radius=0.1, position=(0, 0, 3), name="ball")]).allow("ball", "l22")
    with pytest.raises(mp.errors.UnknownNameError, match="allowed pair ball - l22: got 'l22'; allowed: did you mean l2?"):
        scene.in_collision(mp.load_robot(edited()), [0.0, 0.0])


@pytest.mark.parametrize(
    ("edit", "said"),
    [
        (
            ('velocity="2"', 'velocity="150"'),
            'speeds above 100 rad/s are in degrees per second, or stand for no limit: .*"150"',
        ),
        (('velocity="2"', 'velocity="100"'), ""),
        (('upper="2"', 'upper="628.318531"'), ""),
        (('upper="2"', 'upper="170"'), 'these look like degrees: joint turn: upper="170"'),
        (('upper="2" ', ""), "a URDF's limit that is not given is 0, here of joint turn: upper"),
        (
            ('size="0.1 0.1 0.1"', 'size="0.1 0.1 3"'),
            r"beside an arm of 1 m these look like another unit: far_0 of link far is 3 m",
        ),
        (('size="0.1 0.1 0.1"', 'size="0.1 0.1 1.5"'), ""),
    ],
)
def test_odd_values_are_in_the_log(tmp_path, caplog, edit, said):
    text = """<robot name="arm"><link name="base"/><link name="far"><collision><geometry><box size="0.1 0.1 0.1"/></geometry>
    </collision></link><link name="tip"/><joint name="turn" type="revolute"><parent link="base"/><child link="far"/>
    <axis xyz="0 0 1"/><limit lower="-2" upper="2" velocity="2" effort="1"/></joint>
    <joint name="end" type="fixed"><origin xyz="1 0 0"/><parent link="far"/><child link="tip"/></joint></robot>"""
    assert edit[0] in text
    (tmp_path / "arm.urdf").write_text(text.replace(*edit))
    with caplog.at_level(logging.WARNING):
        mp.Robot.from_urdf(tmp_path / "arm.urdf")
    assert re.search(said, caplog.text) if said else not caplog.text


def test_a_mesh_far_too_small_is_in_the_log(tmp_path, caplog):
    trimesh.creation.box((0.2, 0.1, 0.1)).export(tmp_path / "link.stl")
    text = """<robot name="arm"><link name="base"/><link name="far"><collision><geometry>
    <mesh filename="link.stl" scale="{0} {0} {0}"/></geometry></collision></link><link name="tip"/>
    <joint name="turn" type="revolute"><parent link="base"/><child link="far"/>
    <axis xyz="0 0 1"/><limit lower="-2" upper="2" velocity="2" effort="1"/></joint>
    <joint name="end" type="fixed"><origin xyz="1 0 0"/><parent link="far"/><child link="tip"/></joint></robot>"""
    for scale, said in ((1, ""), (0.001, "these look like another unit: far_0 of link far is 0.0002 m long")):
        (tmp_path / "arm.urdf").write_text(text.format(scale))
        with caplog.at_level(logging.WARNING):
            mp.Robot.from_urdf(tmp_path / "arm.urdf")
        assert said in caplog.text and bool(said) == bool(caplog.text)
