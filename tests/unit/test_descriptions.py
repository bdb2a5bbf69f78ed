"""Descriptions that cannot be read as they were meant: no body of a robot is left out without an error."""

import mujoco
import numpy as np
import pytest

import manipplan as mp

SPHERE = '<collision><geometry><sphere radius="0.1"/></geometry></collision>'
GEOM = '<geom type="sphere" size="0.1"/>'


def collision(shape, origin=""):
    return f"<collision>{origin}<geometry>{shape}</geometry></collision>"


@pytest.fixture
def urdf(tmp_path):
    """A URDF of one revolute joint whose link holds the elements given."""

    def write(elements, *, joint="turn", link="arm", encoding="utf-8"):
        file = tmp_path / "arm.urdf"
        text = (
            f'<robot name="one"><link name="base"/><link name="{link}">{elements}</link><joint name="{joint}" type="revolute">'
            f'<parent link="base"/><child link="{link}"/><axis xyz="0 0 1"/>'
            '<limit lower="-1" upper="1" velocity="1" effort="1"/></joint></robot>'
        )
        file.write_text(text, encoding=encoding)
        return file

    return write


@pytest.fixture
def mjcf(tmp_path):
    """An MJCF file of one hinge whose body holds the elements given."""

    def write(elements, *, before="", after="", joint="turn"):
        file = tmp_path / "arm.xml"
        file.write_text(
            f'<mujoco>{before}<worldbody><body name="arm"><joint name="{joint}" axis="0 0 1"/>{elements}</body></worldbody>'
            f"{after}</mujoco>"
        )
        return file

    return write


@pytest.mark.parametrize(
    ("elements", "message"),
    [
        (collision('<cone radius="0.1" length="1"/>'), "collision element 1 of link arm: <cone> is not a shape"),
        (collision('<capsule radius="0.1"/>'), "<capsule> needs length with a number above zero, not None"),
        (SPHERE + collision('<cylinder radius="0.1"/>'), "element 2 of link arm: <cylinder> needs length with a number"),
        (collision('<cylinder radius="0,04" length="1"/>'), "radius with a number above zero, not '0,04'"),
        (collision('<sphere radius="nan"/>'), "not 'nan'"),
        (collision('<sphere radius="-0.1"/>'), "above zero, not '-0.1'"),
        (collision('<box size="0 0 1"/>'), "above zero, not '0 0 1'"),
        (collision('<box size="1 1"/>'), "<box> needs size with 3 numbers"),
        (collision('<mesh filename="a.stl" scale="1"/>'), "scale with 3 numbers other than zero, not '1'"),
        (collision('<mesh filename="a.stl" scale="1 1 0"/>'), "scale with 3 numbers other than zero"),
        (collision("<mesh/>"), "needs a filename"),
        (collision('<sphere radius="1"/>', '<origin xyz="0 0"/>'), "<origin> needs xyz with 3 numbers, not '0 0'"),
        (collision('<sphere radius="1"/>', '<origin rpy="0 0 a"/>'), "<origin> needs rpy with 3 numbers"),
        (collision('<sphere radius="1"/>', "<origin/><origin/>"), "more than one <origin>"),
        (collision('<sphere radius="1"/><sphere radius="2"/>'), "one <geometry> with one shape"),
        ("<collision/>", "one <geometry> with one shape"),
        (
            SPHERE + collision('<sphere radius="1_0"/>'),
            "element 2 of link arm: <sphere> needs radius with a number .* not '1_0'",
        ),
        (SPHERE + collision('<sphere radius="١"/>'), "<sphere> needs radius"),
        ('<inertial><mass value="a"/></inertial>', "inertial element of link arm: <mass> needs value with a number, not 'a'"),
        ('<inertial><mass value="1"/></inertial>', "it needs one <inertia>"),
        ('<inertial><mass value="1"/><inertia ixx="1"/></inertial>', "<inertia> needs ixy"),
    ],
)
def test_no_element_of_a_link_is_left_out(urdf, elements, message):
    with pytest.raises(mp.errors.FileFormatError, match=message):
        mp.load_robot(urdf(elements))


@pytest.mark.parametrize(
    ("elements", "count"),
    [("", 0), (SPHERE, 1), (SPHERE + collision('<box size="1 2 3"/>', '<origin rpy="0 1 0"/>'), 2)],
)
def test_bodies_of_a_link(urdf, elements, count):
    assert mp.load_robot(urdf(elements)).geometry.ngeoms == count


def test_a_mirrored_mesh_is_read(urdf, tmp_path):
    (tmp_path / "m.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
    robot = mp.load_robot(urdf(collision(f'<mesh filename="{tmp_path}/m.obj" scale="1 -1 1"/>')))
    assert np.array(robot.geometry.geometryObjects[0].geometry.vertices()).min(axis=0)[1] == -1


def test_a_mesh_with_a_vertex_that_is_not_finite(urdf, tmp_path):
    (tmp_path / "m.obj").write_text("v 0 0 nan\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
    with pytest.raises(mp.errors.FileFormatError, match=r"finite vertices within .*, unlike .*m\.obj of arm_0"):
        mp.load_robot(urdf(collision(f'<mesh filename="{tmp_path}/m.obj"/>')))


@pytest.mark.slow
def test_the_number_of_bodies_is_bounded(urdf, mjcf):
    assert mp.load_robot(urdf(SPHERE * 200)).geometry.ngeoms == 200
    with pytest.raises(mp.errors.FileFormatError, match="at most 1000 collision elements, not 1001"):
        mp.load_robot(urdf(SPHERE * 1001))
    with pytest.raises(mp.errors.FileFormatError, match="at most 1000 colliding geoms, not 3000"):
        mp.load_robot(mjcf(GEOM * 3000), velocity=1.0)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("before", "elements", "count"),
    [
        ("", GEOM + '<geom size="0.1" contype="0" conaffinity="0"/>', 1),
        ("", GEOM + '<geom size="0.1" contype="0"/>', 2),
        ('<default><geom contype="0" conaffinity="0"/></default>', GEOM, 0),
        ('<default class="main"><geom type="box" size="1 1 1"/></default>', "<geom/>", 1),
        (
            '<default><default class="v"><geom contype="0" conaffinity="0"/><default class="w"><geom conaffinity="1"/></default>'
            "</default></default>",
            f'<geom class="v" size="1"/><body name="b" childclass="v">{GEOM}<body name="c">{GEOM}<geom class="w" size="1"/></body>'
            "</body>",
            1,
        ),
        ("", GEOM + '<geom type="box" size="0.1" fromto="0 0 0 0 0 1"/>', 2),
    ],
)
def test_geoms_for_collision(mjcf, before, elements, count):
    assert mp.load_robot(mjcf(elements, before=before), tool="arm", velocity=1.0).geometry.ngeoms == count


def test_a_joint_called_as_the_world(urdf, mjcf):
    for file in (urdf(SPHERE, joint="universe"), mjcf(GEOM, joint="universe")):
        with pytest.raises(mp.errors.FileFormatError, match="joints.* with other names than 'universe'"):
            mp.load_robot(file, velocity=1.0)


def test_descriptions_are_in_utf_8(urdf):
    assert mp.load_robot(urdf(SPHERE, link="bras_é")).tool == "bras_é"
    with pytest.raises(mp.errors.FileFormatError, match="XML in UTF-8"):
        mp.load_robot(urdf(SPHERE, link="bras_é", encoding="latin-1"))
    file = urdf(SPHERE)
    file.write_text('<?xml version="1.0" encoding="nobodys"?>' + file.read_text())
    with pytest.raises(mp.errors.FileFormatError, match="XML in UTF-8"):
        mp.load_robot(file)


def test_deep_descriptions(urdf, mjcf):
    deep = "".join(f'<body name="b{i}">' for i in range(10_000)) + "</body>" * 10_000
    with pytest.raises(mp.errors.FileFormatError, match="elements nested at most 500 deep"):
        mp.load_robot(mjcf(deep), velocity=1.0)
    file = urdf(SPHERE)
    joints = "".join(
        f'<link name="l{i}"/><joint name="j{i}" type="fixed"><parent link="{f"l{i - 1}" if i else "arm"}"/><child link="l{i}"/></joint>'
        for i in range(600)
    )
    file.write_text(file.read_text().replace("</robot>", joints + "</robot>"))
    with pytest.raises(mp.errors.FileFormatError, match="at most 500 links in one chain"):
        mp.load_robot(file)


@pytest.mark.slow
@pytest.mark.parametrize("joint", ["", "<joint name='i' type='hinge' axis='1 0 0' range='-1 1'/>"], ids=["fixed", "hinge"])
@pytest.mark.parametrize(
    "place", ["pos='0.1 0.2 1'", "pos='0 0 1' euler='0 0 90'", "quat='0.5 0.5 0.5 0.5'", "pos='1 0 0' axisangle='0 1 0 30'", ""]
)
def test_the_first_body_of_an_mjcf_stands_where_mujoco_has_it(tmp_path, joint, place):
    file = tmp_path / "arm.xml"
    file.write_text(
        f"<mujoco><worldbody><geom name='floor' type='plane' size='1 1 1' pos='0 0 -2'/><body name='a' {place}>{joint}"
        "<geom type='box' size='.1 .2 .3' pos='0 0.1 0'/><body name='b' pos='0.3 0 0'><joint name='j' type='hinge' axis='0 0 1' "
        "range='-1 1'/><geom type='sphere' size='.05' pos='0.1 0 0'/><body name='c' pos='0.4 0 0' euler='20 0 0'><joint name='k' "
        "type='slide' axis='0 1 0' range='-1 1'/><geom name='tip' type='capsule' size='.05 .1' pos='0.3 0 0'/></body></body></body>"
        "</worldbody></mujoco>"
    )
    robot = mp.Robot.from_mjcf(file, tool="c", velocity=1.0)
    model = mujoco.MjModel.from_xml_path(str(file))
    data = mujoco.MjData(model)
    for q in robot.random_configuration(np.random.default_rng(0), size=4):
        data.qpos[:] = q
        mujoco.mj_forward(model, data)
        pose = robot.kinematics(mp.Task.position(), compiled=False).pose(q)
        np.testing.assert_allclose(pose[:3, 3], data.body("c").xpos, atol=1e-9)
        np.testing.assert_allclose(pose[:3, :3], data.body("c").xmat.reshape(3, 3), atol=1e-9)
        ours = mp.Scene().collision_model(robot)
        pair = next(
            k
            for k, names in enumerate(ours.pair_names)
            if set(names) == {"cGeom_0", "floor"} or ("tip" in names and "floor" in names)
        )
        theirs = mujoco.mj_geomDistance(model, data, model.geom("tip").id, model.geom("floor").id, 10.0, None)
        assert ours.distances(q)[pair] == pytest.approx(theirs, abs=1e-6)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            '<axis xyz="0 0 1"/>',
            '<axis xyz="0 0 nan"/>',
            "joint turn: <axis> needs xyz with 3 numbers, not all zero, not '0 0 nan'",
        ),
        ('<axis xyz="0 0 1"/>', '<axis xyz="0 0 1e308"/>', "joint turn: <axis> needs xyz"),
        ("<axis", '<origin xyz="0 0 1e308"/><axis', "joint turn: <origin> needs xyz with 3 numbers"),
        ("<axis", '<origin rpy="0 0"/><axis', "joint turn: <origin> needs rpy with 3 numbers"),
    ],
)
def test_places_of_joints(urdf, old, new, message):
    file = urdf(SPHERE)
    file.write_text(file.read_text().replace(old, new))
    with pytest.raises(mp.errors.FileFormatError, match=message):
        mp.load_robot(file)


def test_the_number_of_joints_is_bounded(urdf):
    file = urdf(SPHERE)
    more = "".join(
        f'<link name="l{i}"/><joint name="j{i}" type="fixed"><parent link="base"/><child link="l{i}"/></joint>'
        for i in range(1000)
    )
    file.write_text(file.read_text().replace("</robot>", f"{more}</robot>"))
    with pytest.raises(mp.errors.FileFormatError, match="at most 1000 joints, not 1001"):
        mp.load_robot(file)


def test_a_fixed_joint_called_as_another_link(tmp_path):
    """Pinocchio looks up the frame below a locked joint by name alone."""
    file = tmp_path / "arm.urdf"
    file.write_text(
        '<robot name="a"><link name="base"/><link name="arm"/><link name="tip"/><link name="right"/>'
        '<joint name="turn" type="revolute"><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>'
        '<limit lower="-1" upper="1" velocity="1" effort="1"/></joint>'
        '<joint name="right" type="fixed"><parent link="arm"/><child link="tip"/><origin xyz="1 0 0"/></joint>'
        '<joint name="slide" type="prismatic"><parent link="arm"/><child link="right"/><axis xyz="0 1 0"/>'
        '<limit lower="0" upper="1" velocity="1" effort="1"/></joint></robot>'
    )
    robot = mp.Robot.from_urdf(file, tool="tip")
    assert robot.locked == {"slide": 0.0}
    assert [frame.name for frame in robot.model.frames].count("right") == 2
    np.testing.assert_allclose(robot.kinematics(mp.Task.position(), compiled=False).pose([0.0])[:3, 3], [1, 0, 0], atol=1e-12)


def test_the_number_of_active_joints_is_bounded(urdf):
    assert mp.planar_arm([0.1] * 100).n == 100
    with pytest.raises(mp.errors.InvalidInputError, match="lengths: got '101 lengths'; allowed: at most 100"):
        mp.planar_arm([0.1] * 101)
    file = urdf(SPHERE)
    more = "".join(
        f'<link name="l{i}"/><joint name="j{i}" type="revolute"><parent link="{f"l{i - 1}" if i else "arm"}"/>'
        f'<child link="l{i}"/><limit lower="-1" upper="1" velocity="1" effort="1"/></joint>'
        for i in range(100)
    )
    file.write_text(file.read_text().replace("</robot>", f"{more}</robot>"))
    with pytest.raises(mp.errors.InvalidInputError, match="joints: got '101 joints'; allowed: at most 100 active joints"):
        mp.load_robot(file)
    assert mp.Robot.from_urdf(file, tool="l3").n == 5
