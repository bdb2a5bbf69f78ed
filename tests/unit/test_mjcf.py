"""Robots of MJCF files: MuJoCo's own kinematics, limits and contacts are the judge."""

import logging
import sys
from pathlib import Path

import mujoco
import numpy as np
import pinocchio as pin
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import manipplan as mp
from manipplan.robots import mjcf, mjcf_files

RADIANS = '<compiler angle="radian"/>'
#: Three links of 0.25, 0.35 and 0.3 m; each of the parts can be replaced.
ARM = """<mujoco>{compiler}{before}<worldbody>{world}<body name="base"><body name="a" pos="0 0 .1" {a}>
<joint name="j1" axis="0 0 1" range="-3 3" {j1}/>{ga}<body name="b" pos="0 0 .25" {b}><joint name="j2" axis="0 1 0" range="-2 2" {j2}/>
{gb}<body name="c" pos="0 0 .35" {c}><joint name="j3" axis="0 1 0" range="-2 2" {j3}/>{gc}{tip}</body></body></body></body>
</worldbody>{after}</mujoco>"""
LINKS = {
    "ga": '<geom name="ga" type="capsule" fromto="0 0 0 0 0 .2" size=".03"/>',
    "gb": '<geom name="gb" type="capsule" fromto="0 0 .08 0 0 .3" size=".03"/>',
    "gc": '<geom name="gc" type="capsule" fromto="0 0 .08 0 0 .2" size=".03"/>',
}
CUBE = "\n".join(
    [f"v {x} {y} {z}" for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    + ["f 1 2 4", "f 1 4 3", "f 5 7 8", "f 5 8 6", "f 1 5 6", "f 1 6 2", "f 3 4 8", "f 3 8 7", "f 1 3 7", "f 1 7 5"]
    + ["f 2 6 8", "f 2 8 4"]
)


def arm_text(**parts):
    names = ("before", "world", "a", "b", "c", "j1", "j2", "j3", "tip", "after")
    return ARM.format(**{"compiler": RADIANS, **dict.fromkeys(names, ""), **LINKS, **parts})


@pytest.fixture
def written(tmp_path):
    """Writes MJCF text to a file."""

    def write(text, name="arm.xml"):
        (tmp_path / name).write_text(text)
        return tmp_path / name

    return write


@pytest.fixture
def arm(written):
    """The file of the arm above."""
    return lambda **parts: written(arm_text(**parts))


class Judge:
    """MuJoCo's model of a file, posed by the names of joints."""

    def __init__(self, file):
        self.model = mujoco.MjModel.from_xml_path(str(file))
        self.data = mujoco.MjData(self.model)

    def place(self, robot, q):
        values = {**robot.locked, **dict(zip(robot.joint_names, q, strict=True))}
        for name, value in values.items():
            joint = self.model.joint(name)
            if len(joint.qposadr) == 1 and joint.type[0] in (2, 3):
                self.data.qpos[joint.qposadr[0]] = value
        mujoco.mj_kinematics(self.model, self.data)
        mujoco.mj_comPos(self.model, self.data)

    def contacts(self, robot, q):
        """Pairs of geoms (numbers) that touch, and the deepest overlap [m]."""
        self.place(robot, q)
        mujoco.mj_collision(self.model, self.data)
        found = [contact for contact in self.data.contact if contact.dist <= 0]
        return [tuple(contact.geom) for contact in found], max((-contact.dist for contact in found), default=0.0)

    def deepest(self, robot, path, step=2e-3):
        return max(self.contacts(robot, q)[1] for q in path(path.fine_samples(step)))


def judged(file, rng, **options):
    """The robot of a file, after a comparison of poses, bodies and limits with MuJoCo's."""
    robot = mp.Robot.from_mjcf(file, velocity=1.0, **options)
    compare(robot, Judge(file), rng)
    return robot


def compare(robot, judge, rng):
    model, data = judge.model, robot.model.createData()
    for q in [robot.neutral, *robot.random_configuration(rng, size=4)]:
        judge.place(robot, q)
        pin.framesForwardKinematics(robot.model, data, q)
        for frame, place in zip(robot.model.frames, data.oMf, strict=True):
            kinds = {pin.FrameType.BODY: ("body", "x"), pin.FrameType.OP_FRAME: ("site", "site_x")}
            if frame.type not in kinds:
                continue
            kind, prefix = kinds[frame.type]
            number = mujoco.mj_name2id(model, getattr(mujoco.mjtObj, f"mjOBJ_{kind.upper()}"), frame.name)
            if number >= 0:
                np.testing.assert_allclose(place.translation, getattr(judge.data, f"{prefix}pos")[number], atol=1e-9)
                np.testing.assert_allclose(place.rotation.ravel(), getattr(judge.data, f"{prefix}mat")[number], atol=1e-9)
        for item in robot.geometry.geometryObjects:
            number = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_GEOM, item.name)
            if number >= 0:
                place = data.oMi[item.parentJoint] * item.placement
                np.testing.assert_allclose(place.translation, judge.data.geom_xpos[number], atol=1e-9)
                np.testing.assert_allclose(place.rotation.ravel(), judge.data.geom_xmat[number], atol=1e-9)
    for k, name in enumerate(robot.joint_names):
        number = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, name)
        if number >= 0:
            expected = model.jnt_range[number] if model.jnt_limited[number] else (-np.inf, np.inf)
            np.testing.assert_array_equal([robot.limits.lower[k], robot.limits.upper[k]], expected)


def same_verdicts(robot, judge, rng, count=200):
    """Number of random postures in collision, the same ones by MuJoCo."""
    qs = robot.random_configuration(rng, size=count)
    ours = mp.Scene().in_collision(robot, qs)
    theirs = np.array([bool(judge.contacts(robot, q)[0]) for q in qs])
    np.testing.assert_array_equal(ours, theirs)
    return int(ours.sum())


# ---- defaults


@pytest.mark.slow
@pytest.mark.parametrize(
    "place",
    [
        'pos="0 .15 .22"',
        'quat=".5 .5 .5 .5"',
        'euler=".1 .2 .3"',
        'axisangle="0 2 0 .5"',
        'xyaxes="0 1 0 -1 0 1"',
        'zaxis="1 1 0"',
    ],
)
@pytest.mark.parametrize("kind", ["main", "class", "childclass", "nested"])
def test_places_in_defaults(arm, rng, place, kind):
    geom = f'<geom type="box" size=".02 .15 .02" {place}/>'
    nested = (
        f'<default class="outer"><geom type="box" size=".02 .15 .02"/><default class="tip"><geom {place}/></default></default>'
    )
    before = {"main": geom, "nested": nested}.get(kind, f'<default class="tip">{geom}</default>')
    chosen = {"main": "", "childclass": ""}.get(kind, 'class="tip"')
    body = (
        '<body name="hand" childclass="tip"><geom name="tip"/></body>'
        if kind == "childclass"
        else f'<geom name="tip" {chosen}/>'
    )
    links = {key: f'<geom name="{key}" size=".03"/>' for key in LINKS} if kind == "main" else LINKS
    file = arm(before=f"<default>{before}</default>", tip=f'{body}<body name="tcp" pos="0 0 .2"/>', **links)
    judged(file, rng, tool="tcp")


@pytest.mark.slow
def test_an_obstacle_beside_a_geom_placed_by_a_default(arm):
    """A plan through it passed when the place was ignored."""
    tip = '<default><default class="tip"><geom type="box" size=".02 .15 .02" pos="0 .15 .22"/></default></default>'
    box = '<geom type="box" size=".03 .03 .03" pos=".16 .26 .87"/>'
    file = arm(before=tip, tip='<geom name="tip" class="tip"/><body name="tcp" pos="0 0 .2"/>')
    robot = mp.Robot.from_mjcf(file, velocity=1.0)
    scene = mp.Scene([mp.Box(size=(0.06, 0.06, 0.06), position=(0.16, 0.26, 0.87))])
    plan = mp.plan(robot, [0.1, -0.6, 0.5], [0.1, 0.9, 0.5], scene)
    with_box = arm(before=tip, world=box, tip='<geom name="tip" class="tip"/><body name="tcp" pos="0 0 .2"/>')
    assert Judge(with_box).deepest(robot, plan.path) == 0.0
    assert Judge(with_box).deepest(robot, mp.JointPath.line([0.1, -0.6, 0.5], [0.1, 0.9, 0.5])) > 1e-3


@pytest.mark.slow
@pytest.mark.parametrize("attribute", ['scale=".001 .002 .003"', 'refpos="0 0 .5"', 'refquat=".5 .5 .5 .5"', 'scale="-1 1 1"'])
@pytest.mark.parametrize("default", [True, False])
def test_meshes_are_where_mujoco_has_them(arm, rng, tmp_path, attribute, default):
    (tmp_path / "cube.obj").write_text(CUBE)
    if default and "scale" not in attribute:
        pytest.skip("MuJoCo has no such default")
    before = f"<default><mesh {attribute}/></default>" if default else ""
    before += f'<asset><mesh name="cube" file="cube.obj" {"" if default else attribute}/></asset>'
    file = arm(before=before, tip='<geom name="tip" type="mesh" mesh="cube" pos=".1 .2 .3" euler=".1 .2 .3"/>')
    robot, judge = judged(file, rng), Judge(file)
    item = robot.geometry.geometryObjects[robot.geometry.getGeometryId("tip")]
    judge.place(robot, robot.neutral)
    data = robot.model.createData()
    pin.forwardKinematics(robot.model, data, robot.neutral)
    place = data.oMi[item.parentJoint] * item.placement
    ours = np.array(item.geometry.vertices()) @ place.rotation.T + place.translation
    corners = np.array(np.meshgrid([-1, 1], [-1, 1], [-1, 1])).reshape(3, -1).T.astype(float)  # of the file, in its own frame
    if "scale" in attribute:
        corners = corners * [float(each) for each in attribute.split('"')[1].split()]
    if "refpos" in attribute:
        corners = corners - [0, 0, 0.5]
    body = judge.data.body("c")
    turn = mujoco_euler(0.1, 0.2, 0.3)
    expected = (corners @ turn.T + [0.1, 0.2, 0.3]) @ body.xmat.reshape(3, 3).T + body.xpos
    order = [each[np.lexsort(np.round(each, 6).T)] for each in (ours, expected)]
    np.testing.assert_allclose(*order, atol=1e-6)


def mujoco_euler(x, y, z):
    quat, matrix = np.zeros(4), np.zeros(9)
    mujoco.mju_euler2Quat(quat, np.array([x, y, z]), "xyz")
    mujoco.mju_quat2Mat(matrix, quat)
    return matrix.reshape(3, 3)


@pytest.mark.slow
def test_joint_places_in_defaults(arm, rng):
    judged(arm(before='<default><joint pos=".015 0 .02" axis="0 1 0"/></default>'), rng)


# ---- roots, world, references, orientations


@pytest.mark.slow
def test_a_free_root_stays_where_the_file_has_it(written, rng, caplog):
    with caplog.at_level(logging.INFO, logger="manipplan"):
        robot = judged(
            written(f"""<mujoco>{RADIANS}<worldbody><body name="a" pos="1 2 3" euler=".1 .2 .3"><freejoint name="f"/><geom size=".1"/>
            <body name="b" pos="1 0 0"><joint name="k" axis="0 1 0" range="-1 1"/><geom size=".1"/><body name="c" pos="0 0 1">
            <joint name="l" axis="1 0 0" range="-1 1"/><geom size=".1"/></body></body></body></worldbody></mujoco>"""),
            rng,
        )
    assert robot.joint_names == ("k", "l") and robot.locked == {}
    assert "the free joint of a, which stays where it is" in caplog.text
    moved = robot.at(pin.SE3(np.eye(3), np.array([0.0, 0.0, 1.0])))
    np.testing.assert_allclose(
        moved.kinematics(mp.Task.position(), compiled=False).pose([0.5, 0.1]),
        np.array(pin.SE3(np.eye(3), np.array([0.0, 0.0, 1.0])).homogeneous)
        @ robot.kinematics(mp.Task.position(), compiled=False).pose([0.5, 0.1]),
        atol=1e-12,
    )


POST = """<mujoco><compiler angle="radian"/><worldbody><geom name="post" type="box" size=".05 .05 .5" pos=".013 .52 .45"/>
<body name="base"><geom name="stand" type="cylinder" size=".06 .05"/>
 <body name="a" pos="0 0 .3"><joint name="j1" axis="0 0 1" range="-3 3"/><geom name="arm1" type="capsule" fromto=".1 0 0 .6 0 0" size=".03"/>
  <body name="b" pos=".6 0 .1"><joint name="j2" axis="0 0 1" range="-2.5 2.5"/><geom name="arm2" type="capsule" fromto=".05 0 0 .3 0 0" size=".03"/>
   <body name="c" pos=".3 0 .1"><joint name="j3" axis="0 0 1" range="-2.5 2.5"/><geom name="arm3" type="capsule" fromto=".05 0 0 .2 0 0" size=".02"/>
   <body name="tip" pos=".2 0 0"/></body></body></body></body></worldbody></mujoco>"""


@pytest.mark.slow
def test_geoms_of_the_world_are_checked_against_the_first_link(written, rng):
    file = written(POST)
    robot, judge = judged(file, rng), Judge(file)
    assert 10 < same_verdicts(robot, judge, rng, 300) < 290
    pairs = [set(pair) for pair in mp.Scene().collision_model(robot).pair_names]
    assert {"post", "arm1"} in pairs and {"stand", "arm1"} not in pairs
    try:
        plan = mp.plan(robot, [0, 2, 0.5], [3, 2, 0.5], objective=mp.PathObjective(task=mp.Task.planar()))
    except mp.errors.PlanningError:
        return
    assert judge.deepest(robot, plan.path) == 0.0


@pytest.mark.slow
def test_a_wall_that_always_touches_is_not_dropped(written):
    """Links that overlap by their shapes are; a geom of the world is an obstacle."""
    file = written(POST.replace('pos=".013 .52 .45"', 'pos=".013 0 .45"').replace('fromto=".1 0 0', 'fromto="0 0 0'))
    robot = mp.Robot.from_mjcf(file, velocity=1.0)
    assert mp.Scene().in_collision(robot, robot.neutral)
    assert not mp.Scene().allow("post", "a").in_collision(robot, robot.neutral)


@pytest.mark.slow
def test_geoms_of_the_world_stay_where_they_are(written):
    robot = mp.Robot.from_mjcf(written(POST), velocity=1.0)
    lifted = robot.at(pin.SE3(np.eye(3), np.array([0.0, 0.0, 0.7])))
    place = {item.name: item.placement.translation[2] for item in lifted.geometry.geometryObjects}
    assert place["post"] == pytest.approx(0.45) and place["stand"] == pytest.approx(0.7)
    assert mp.Scene().in_collision(robot, [1.5, 0, 0]) and not mp.Scene().in_collision(lifted, [1.5, 0, 0])


@pytest.mark.slow
def test_references_shift_the_joint_and_not_its_limits(arm, rng):
    robot = judged(arm(j1='ref=".5"', j2='ref="-.3" type="slide"', j3='ref="1.5" pos=".1 0 .05"'), rng)
    np.testing.assert_array_equal(robot.limits.lower, [-3, -2, -2])


@pytest.mark.slow
def test_a_reference_shifts_no_limit(written, rng):
    robot = judged(
        written("""<mujoco><compiler angle="radian"/><worldbody><body name="a"><joint name="j" type="hinge" axis="0 0 1" range="0 2" ref="1"/>
        <geom size=".1"/><body name="c" pos="1 0 0"><geom size=".05"/></body></body></worldbody></mujoco>"""),
        rng,
        tool="c",
    )
    assert (robot.limits.lower[0], robot.limits.upper[0]) == (0.0, 2.0)


@pytest.mark.slow
def test_slides_are_in_metres_and_hinges_in_degrees(arm, rng):
    robot = judged(arm(compiler="", j2='type="slide"'), rng)
    np.testing.assert_allclose(robot.limits.upper, [np.deg2rad(3), 2, np.deg2rad(2)])


@pytest.mark.slow
def test_ranges_that_do_not_limit(arm, rng):
    robot = judged(arm(j1='limited="false"'), rng)
    assert np.isinf(robot.limits.upper[0]) and robot.joint_types[0] == "continuous"


@pytest.mark.slow
@pytest.mark.parametrize("sequence", ["XYZ", "ZYX", "xYz", "xyz", "zyx", "ZXz"])
def test_sequences_of_euler_angles(arm, rng, sequence):
    judged(arm(compiler=f'<compiler angle="radian" eulerseq="{sequence}"/>', b='euler=".4 .5 .6"'), rng)


@pytest.mark.slow
@pytest.mark.parametrize("turn", ['axisangle="0 2 0 .5"', 'quat="2 0 2 0"', 'xyaxes="2 1 0 0 3 1"', 'zaxis="1 2 3"'])
def test_orientations_of_any_length(arm, rng, turn):
    judged(arm(b=turn), rng)


# ---- names


@pytest.mark.slow
def test_names_that_joints_sites_and_bodies_share(arm, rng):
    finger = '<body name="f" pos="0 .02 .1"><joint name="grip" type="slide" range="0 .02"/><geom size=".01"/><site name="grip"/></body>'
    robot = judged(arm(tip=f'{finger}<body name="grip" pos="0 0 .1"><site name="j1" pos="0 0 .01"/></body>'), rng, tool="grip")
    assert robot.joint_names == ("j1", "j2", "j3") and robot.locked == {"grip": 0.0}
    site = mp.Robot.from_mjcf(arm(tip=finger), velocity=1.0, tool="grip")
    assert site.joint_names == ("j1", "j2", "j3", "grip")


@pytest.mark.slow
def test_bodies_joints_and_geoms_without_names(written, rng):
    file = written(f"""<mujoco>{RADIANS}<worldbody><body><geom size=".05"/><body pos="0 0 .2"><joint axis="0 0 1" range="-1 1"/>
    <joint axis="0 1 0" range="-1 1"/><geom size=".05"/><geom size=".04" pos="0 0 .1"/><body pos=".3 0 0"><joint axis="1 0 0" range="-1 1"/>
    <geom size=".05"/><body name="body2"/><body name="tip" pos=".1 0 0"/></body></body></body></worldbody></mujoco>""")
    robot = mp.Robot.from_mjcf(file, velocity=1.0, tool="tip")
    assert robot.joint_names == ("body22_joint", "body22_joint2", "body3_joint")
    assert [item.name for item in robot.geometry.geometryObjects] == ["body1_0", "body22_0", "body22_1", "body3_0"]
    judge, data = Judge(file), robot.model.createData()
    for q in robot.random_configuration(rng, size=3):
        judge.data.qpos[:] = q
        mujoco.mj_kinematics(judge.model, judge.data)
        pin.framesForwardKinematics(robot.model, data, q)
        place = data.oMf[next(i for i, frame in enumerate(robot.model.frames) if frame.name == "tip")]
        np.testing.assert_allclose(place.translation, judge.data.body("tip").xpos, atol=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize("old", ['joint name="j1"', 'body name="a"', 'site name="s"'])
def test_nothing_is_called_as_pinocchio_calls_the_world(arm, old):
    file = arm(tip='<site name="s"/>')
    file.write_text(file.read_text().replace(old, f'{old.split()[0]} name="universe"'))
    with pytest.raises(mp.errors.FileFormatError, match="other names than 'universe'"):
        mp.Robot.from_mjcf(file, velocity=1.0)


# ---- pairs


FREE = {key: value.replace("/>", ' contype="0" conaffinity="0"/>') for key, value in LINKS.items()}


@pytest.mark.slow
def test_pairs_that_the_file_names_are_checked(arm, rng):
    file = arm(**FREE, after='<contact><pair geom1="ga" geom2="gc"/></contact>')
    robot = judged(file, rng)
    assert {item.name for item in robot.geometry.geometryObjects} == {"ga", "gc"}
    assert [set(pair) for pair in mp.Scene().collision_model(robot).pair_names] == [{"ga", "gc"}]
    assert judged(arm(**FREE), rng).geometry.ngeoms == 0


@pytest.mark.slow
@pytest.mark.parametrize("pair", ["", '<pair geom1="ga" geom2="gb"/>', '<pair geom1="ga" geom2="ball"/>'])
@pytest.mark.parametrize("exclude", ["", '<exclude body1="a" body2="c"/>', '<exclude body1="a" body2="hand"/>'])
@pytest.mark.parametrize("masks", ["", 'contype="2" conaffinity="2"', 'contype="0" conaffinity="3"', 'contype="4"'])
def test_the_pairs_are_mujoco_s(arm, rng, pair, exclude, masks):
    """A shorter arm that folds onto itself, with a hand fixed to its last link."""
    links = {key: value.replace(".08 0 0 .3", ".08 0 0 .2") for key, value in LINKS.items()}
    links["gc"] = links["gc"].replace("/>", f" {masks}/>")
    hand = '<body name="hand" pos="0 0 .25"><geom name="ball" size=".07"/></body>'
    file = arm(**links, tip=hand, after=f"<contact>{pair}{exclude}</contact>", j3='pos="0 0 0"')
    file.write_text(file.read_text().replace('range="-2 2"', 'range="-3 3"').replace('pos="0 0 .35"', 'pos="0 0 .25"'))
    robot, judge = mp.Robot.from_mjcf(file, velocity=1.0), Judge(file)
    model = mp.Scene().collision_model(robot)
    checked = {frozenset(pair) for pair in model.pair_names}
    names = [judge.model.geom(k).name for k in range(judge.model.ngeom)]
    for q in robot.random_configuration(rng, size=100):
        theirs = {frozenset((names[a], names[b])) for a, b in judge.contacts(robot, q)[0]}
        apart = dict(zip(map(frozenset, model.pair_names), model.distances(q), strict=True))
        assert {key for key, value in apart.items() if value <= 0} == theirs
        assert theirs <= checked


@pytest.mark.slow
def test_the_reasons_of_pairs_that_are_left_out(arm):
    file = arm(tip='<body name="hand"><geom name="ball" size=".02" contype="2" conaffinity="2"/></body>')
    dropped = mp.Scene().collision_model(mp.Robot.from_mjcf(file, velocity=1.0)).dropped
    reasons = {frozenset(pair): reason for pair, reason in dropped.items()}
    assert reasons[frozenset(("a", "b"))] == mjcf.ADJACENT
    assert reasons[frozenset(("a", "hand"))] == mjcf.MASKED


@pytest.mark.slow
def test_parents_are_checked_where_the_file_says_so(arm):
    file = arm(before='<option><flag filterparent="disable"/></option>')
    model = mp.Scene().collision_model(mp.Robot.from_mjcf(file, velocity=1.0))
    assert any({"ga", "gb"} == set(pair) for pair in model.pair_names) or ("a", "b") in model.dropped
    assert mjcf.ADJACENT not in model.dropped.values()


# ---- what MuJoCo expands


@pytest.mark.slow
def test_includes_frames_and_replicates(written, rng):
    written(
        '<mujoco><body name="c" pos="0 0 .2"><joint name="k" axis="1 0 0" range="-1 1"/><geom name="gc" size=".05"/></body></mujoco>',
        "c.xml",
    )
    robot = judged(
        written(f"""<mujoco>{RADIANS}<worldbody><frame pos="0 0 1" euler="0 0 1"><body name="a"><joint name="j" axis="0 1 0" range="-1 1"/>
        <geom name="ga" size=".05"/><frame pos=".1 0 0"><include file="c.xml"/></frame>
        <replicate count="3" offset="0 .2 0"><geom size=".02"/></replicate></body></frame></worldbody></mujoco>"""),
        rng,
    )
    assert robot.joint_names == ("j", "k") and robot.geometry.ngeoms == 5


@pytest.mark.slow
def test_several_joints_in_one_body(written, rng):
    robot = judged(
        written(f"""<mujoco>{RADIANS}<worldbody><body name="car" pos="0 0 .1"><joint name="x" type="slide" axis="1 0 0" range="-1 1"/>
        <joint name="y" type="slide" axis="0 1 0" range="-1 1"/><joint name="turn" axis="0 0 1" pos=".1 0 0" range="-3 3"/>
        <joint name="tilt" axis="1 1 0" pos="0 .2 .1" ref=".2" range="-1 1"/><geom size=".1"/><body name="tip" pos=".3 0 .2" euler="0 1 0"/>
        </body></worldbody></mujoco>"""),
        rng,
    )
    assert robot.joint_names == ("x", "y", "turn", "tilt")


@pytest.mark.slow
def test_several_bodies_in_the_world(arm, rng):
    table = '<body name="table" pos="1 0 0"><geom name="top" type="box" size=".2 .2 .05"/></body>'
    robot = judged(arm(world=table), rng, tool="c")
    assert robot.n == 3 and robot.geometry.ngeoms == 4


@pytest.mark.slow
def test_primitives_fitted_to_a_mesh(arm, rng, tmp_path):
    (tmp_path / "cube.obj").write_text(CUBE)
    asset = '<asset><mesh name="cube" file="cube.obj" scale=".01 .02 .03"/></asset>'
    robot = judged(arm(before=asset, tip='<geom name="tip" type="box" mesh="cube" pos="0 0 .1"/>'), rng)
    box = robot.geometry.geometryObjects[robot.geometry.getGeometryId("tip")].geometry
    np.testing.assert_allclose(sorted(np.array(box.halfSide)), [0.01, 0.02, 0.03], rtol=1e-6)


@pytest.mark.slow
def test_ball_joints_are_held(arm, rng):
    tip = '<body name="hand" pos="0 0 .1"><joint name="ball" type="ball"/><geom size=".02"/><body name="tcp" pos="0 0 .1"/></body>'
    with pytest.raises(mp.errors.UnsupportedJointError, match="ball"):
        mp.Robot.from_mjcf(arm(tip=tip), velocity=1.0, tool="tcp")
    assert judged(arm(tip=tip), rng, tool="tcp", joints=["j1", "j2", "j3"]).locked == {"ball": 0.0}


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["ball", "hinge"])
def test_the_chain_of_one_arm_beside_a_head(written, kind):
    def arm(name):
        upper = f'<joint name="{name}1" axis="0 0 1"/><geom size=".02"/>'
        fore = f'<joint name="{name}2" axis="0 1 0"/><geom size=".02"/><site name="{name}" pos="0 0 .1"/>'
        return f'<body>{upper}<body pos="0 0 .2">{fore}</body></body>'

    head = f'<body pos="0 1 0"><joint name="neck" type="{kind}"/><geom size=".02"/></body>'
    file = written(f"<mujoco><worldbody>{head}{arm('left')}{arm('right')}</worldbody></mujoco>")
    for name in ("left", "right"):
        assert mp.Robot.from_mjcf(file, velocity=1.0, tool=name).joint_names == (f"{name}1", f"{name}2")


@pytest.mark.slow
def test_a_file_without_bodies_is_refused(written):
    with pytest.raises(mp.errors.FileFormatError, match="at least one body"):
        mp.Robot.from_mjcf(written("<mujoco><worldbody><geom size='.1'/></worldbody></mujoco>"))


@pytest.mark.slow
def test_masses_forces_and_gravity(written):
    file = written("""<mujoco><option gravity="0 1 -5"/><worldbody><body name="a" pos="0 0 .3"><joint name="j" axis="0 1 0" pos="0 .1 0"
    armature=".3" actuatorfrcrange="-4 5"/><geom type="box" size=".1 .2 .3" pos=".1 0 0" euler="10 20 30"/><body name="b" pos=".5 0 0">
    <joint name="k" axis="0 0 1"/><geom type="capsule" size=".05 .2" pos="0 .1 .2"/></body></body></worldbody>
    <actuator><motor joint="k" gear="3" ctrlrange="-1 1" forcerange="-2 2"/></actuator></mujoco>""")
    robot = mp.Robot.from_mjcf(file, velocity=1.0)
    np.testing.assert_allclose(robot.limits.effort, [4, 6])
    judge = Judge(file)
    data, judge.data.qpos[:] = robot.model.createData(), [0.3, -0.8]
    mujoco.mj_forward(judge.model, judge.data)
    mass = np.zeros((2, 2))
    mujoco.mj_fullM(judge.model, judge.data, mass)
    np.testing.assert_allclose(pin.crba(robot.model, data, np.array([0.3, -0.8])), mass, rtol=1e-9)
    np.testing.assert_allclose(
        pin.computeGeneralizedGravity(robot.model, data, np.array([0.3, -0.8])), judge.data.qfrc_bias, rtol=1e-9
    )


@pytest.mark.slow
def test_height_fields_are_solid(written, tmp_path, rng):
    import struct

    heights = rng.uniform(0, 1, (6, 7)).astype(np.float32)
    (tmp_path / "hills.bin").write_bytes(struct.pack("<2i", 6, 7) + heights.tobytes())
    file = written(f"""<mujoco>{RADIANS}<asset><hfield name="hills" file="hills.bin" size="1 .8 .3 .1"/></asset><worldbody>
    <geom name="ground" type="hfield" hfield="hills" pos="0 0 -.2"/><body name="a"><joint name="x" type="slide" axis="1 0 0" range="-.9 .9"/>
    <joint name="y" type="slide" axis="0 1 0" range="-.7 .7"/><joint name="z" type="slide" axis="0 0 1" range="-.3 .4"/>
    <geom name="ball" size=".02"/></body></worldbody></mujoco>""")
    robot, judge = mp.Robot.from_mjcf(file, velocity=1.0), Judge(file)
    item = robot.geometry.geometryObjects[0]
    triangles = np.array(item.geometry.vertices())[
        [[t[0], t[1], t[2]] for t in map(item.geometry.tri_indices, range(item.geometry.num_tris))]
    ]
    volume = np.einsum("ij,ij->i", triangles[:, 0], np.cross(triangles[:, 1], triangles[:, 2])).sum() / 6
    spread = judge.model.hfield_data.reshape(6, 7)
    columns = sum(  # two triangular prisms per cell
        (spread[i, j] + spread[i, j + 1] + spread[i + 1, j + 1] + spread[i, j] + spread[i + 1, j + 1] + spread[i + 1, j]) / 6
        for i in range(5)
        for j in range(6)
    )
    assert volume == pytest.approx(2 * 1.6 * (0.1 + 0.3 * columns / 30), rel=1e-6)


# ---- couplings are tested in test_mimics.py; what is not taken over


@pytest.mark.slow
def test_what_is_not_taken_over_is_named(arm, caplog):
    after = """<tendon><fixed name="t"><joint joint="j1" coef="1"/></fixed></tendon><actuator><motor joint="j1"/></actuator>
    <equality><connect body1="a" body2="c" anchor="0 0 0"/></equality>"""
    mp.Robot.from_mjcf(arm(after=after), velocity=1.0)
    [record] = [each for each in caplog.records if "not taken over" in each.message]
    assert record.levelname == "WARNING"
    assert "1 <connect> of <equality>, 1 tendon, 1 actuator" in record.message


@pytest.mark.slow
def test_a_joint_with_two_leaders(arm):
    after = '<equality><joint joint1="j3" joint2="j2"/><joint joint1="j3" joint2="j1"/></equality>'
    with pytest.raises(mp.errors.FileFormatError, match="one <equality> per joint that follows; j3 follows"):
        mp.Robot.from_mjcf(arm(after=after), velocity=1.0, tool="b")


# ---- hostile files


def nested(count, depth):
    return f'<replicate count="{count}">' * depth + '<geom size=".1"/>' + "</replicate>" * depth


REFUSALS = {
    "replicate": (nested(1_000_000, 1), "at most 100000 elements, and more than that"),
    "nested": (nested(100, 6), "at most 100000 elements"),
    "included": ('<include file="many.xml"/>', "at most 100000 elements"),
    "bodies": (
        '<body><joint/><inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/></body>' * 1001,
        "at most 1000 joints and bodies, not 1001 and 1001",
    ),
    "geoms": ('<geom size=".1"/>' * 1001, "at most 1000 colliding geoms, not 1001"),
}


@pytest.mark.slow
@pytest.mark.parametrize("bomb", REFUSALS)
@pytest.mark.parametrize("read", [mp.Robot.from_mjcf, mp.Scene.from_mjcf], ids=["robot", "scene"])
def test_bombs(written, bomb, read):
    text, message = REFUSALS[bomb]
    written(f"<mujoco>{nested(1000, 2)}</mujoco>", "many.xml")
    file = written(f"<mujoco><worldbody>{text}</worldbody></mujoco>")
    if read == mp.Scene.from_mjcf and bomb in ("bodies", "geoms"):
        return  # obstacles may be many
    with pytest.raises(mp.errors.FileFormatError, match=message):
        read(file)


@pytest.mark.slow
def test_what_takes_too_long(written, monkeypatch):
    """What no count foresees ends at a limit of processor time."""
    monkeypatch.setattr(mjcf_files, "MOST_ELEMENTS", 10**12)
    monkeypatch.setattr(mjcf_files, "PROCESSOR", 3)
    file = written(f"<mujoco><worldbody>{nested(1_000_000, 1)}</worldbody></mujoco>")
    with pytest.raises(mp.errors.FileFormatError, match="takes MuJoCo more than 3 s"):
        mp.Robot.from_mjcf(file)


BODY = '<body name="a"><joint/><geom size=".1"/></body>'
LARGE = {
    "hfield": (
        '<hfield name="h" nrow="60000" ncol="60000" size="1 1 1 1"/>',
        "",
        "at most 250000 heights; h has 60000 x 60000",
    ),
    "mesh": ('<mesh name="h" builtin="plate" params="3000 3000"/>', "", "at most 500 steps; h has 3000 3000"),
    "flex": ("", '<flexcomp name="h" type="grid" count="300 300 1" spacing=".1 .1 .1" dim="2"/>', "at most 100000 elements"),
}


@pytest.mark.parametrize("kind", LARGE)
def test_large_assets(written, kind):
    asset, inside, message = LARGE[kind]
    file = written(f"<mujoco><asset>{asset}</asset><worldbody>{BODY}{inside}</worldbody></mujoco>")
    with pytest.raises(mp.errors.FileFormatError, match=message):
        mp.Robot.from_mjcf(file, velocity=1.0)


UNUSED = {
    "texture": '<asset><texture name="t" builtin="flat" type="2d" width="100000" height="100000"/></asset>',
    "missing": '<asset><texture name="t" type="cube" fileup="no.png"/><material name="m" texture="t"/></asset>',
    "channels": '<asset><texture name="t" type="2d" file="no.png" nchannel="4" gridsize="3 4" gridlayout=".U..LFRB.D.."/></asset>',
    "sensor": '<sensor><user dim="500000000" name="x"/></sensor>',
    "keys": '<size nkey="100000000"/><keyframe><key qpos="0.1"/></keyframe>',
    "numbers": '<size nuser_geom="100000000" nuserdata="100000000" memory="100G"/>',
    "contacts": '<size njmax="2000000000" nconmax="2000000000"/>',
}


@pytest.mark.slow
@pytest.mark.parametrize("kind", UNUSED)
def test_what_a_simulation_alone_needs_costs_nothing(written, kind):
    robot = mp.Robot.from_mjcf(written(f"<mujoco>{UNUSED[kind]}<worldbody>{BODY}</worldbody></mujoco>"), velocity=1.0)
    assert robot.n == 1


def test_a_large_height_field_is_refused(written):
    ground = '<geom name="ground" type="hfield" hfield="h"/>'
    file = written(
        f'<mujoco><asset><hfield name="h" nrow="600" ncol="600" size="1 1 1 1"/></asset><worldbody>{ground}'
        '<body name="a"><joint/><geom size=".1"/></body></worldbody></mujoco>'
    )
    with pytest.raises(mp.errors.FileFormatError, match=r"at most 250000 heights; h has 600 x 600"):
        mp.Robot.from_mjcf(file, velocity=1.0)


@pytest.mark.parametrize(
    ("sent", "told"),
    [("SIGSEGV", "MuJoCo ended by SIGSEGV"), ("SIGKILL", "memory is short"), ("SIGXCPU", r"more than \d+ s of the processor")],
)
def test_a_file_on_which_mujoco_ends(arm, monkeypatch, tmp_path, sent, told):
    """Whatever ends MuJoCo ends its own process only."""
    fake = tmp_path / "fake"
    (fake / "mujoco").mkdir(parents=True)
    (fake / "mujoco" / "__init__.py").write_text(f"import os, signal\nos.kill(os.getpid(), signal.{sent})")
    monkeypatch.syspath_prepend(fake)
    with pytest.raises(mp.errors.FileFormatError, match=told):
        mp.Robot.from_mjcf(arm(), velocity=1.0)


@pytest.mark.slow
def test_nothing_is_printed_or_written(arm, tmp_path, monkeypatch, capfd):
    monkeypatch.chdir(tmp_path)
    file = arm(tip='<geom type="mesh" mesh="none"/>')
    with pytest.raises(mp.errors.FileFormatError, match="MuJoCo says"):
        mp.Robot.from_mjcf(file, velocity=1.0)
    mp.Robot.from_mjcf(arm(), velocity=1.0)
    assert capfd.readouterr() == ("", "")
    assert [each.name for each in tmp_path.iterdir()] == ["arm.xml"]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("parts", "message"),
    [
        ({"gc": '<geom name="g"/>'}, "MuJoCo says: .*size 0 must be positive.*'g'"),
        ({"gc": '<geom size="0,04"/>'}, "bad format in attribute 'size'"),
        ({"gc": '<geom size="nan"/>'}, "nan size"),
        ({"gc": '<geom size=".1" pos="0 1"/>'}, "'pos' does not have enough data"),
        ({"gc": '<geom name="big" size="1e7"/>'}, "at most 1e\\+06 m; the sphere big"),
        ({"gc": '<geom name="big" size="1e90"/>'}, "finite numbers up to 1e\\+12"),
        ({"gc": '<include file="none.xml"/>'}, "none.xml"),
        ({"gc": ""}, "mass and inertia of moving bodies must be larger"),
        ({"after": '<contact><pair geom1="ga" geom2="none"/></contact>'}, "none"),
        ({"after": "<worldbody><body name='a'/></worldbody>"}, "repeated name 'a'"),
    ],
)
def test_wrong_files(arm, parts, message):
    with pytest.raises(mp.errors.FileFormatError, match=message):
        mp.Robot.from_mjcf(arm(**parts), velocity=1.0)


def test_without_mujoco_the_error_says_how_to_install_it(arm, monkeypatch):
    monkeypatch.setitem(sys.modules, "mujoco", None)
    with pytest.raises(mp.errors.MissingExtraError, match=r"pip install 'manipplan\[mujoco\]'"):
        mp.Robot.from_mjcf(arm())


@pytest.mark.slow
def test_what_is_drawn(arm):
    """The geoms of the groups that MuJoCo's viewer draws, in their colours."""
    from manipplan.viz.viewer.bodies import visual_geometry

    file = arm(
        before='<asset><material name="red" rgba="1 0 0 1"/></asset>',
        tip='<geom name="seen" size=".02" material="red" contype="0" conaffinity="0"/><geom name="hidden" size=".03" group="3"/>',
    )
    robot = mp.Robot.from_mjcf(file, velocity=1.0)
    geometry, reason = visual_geometry(robot)
    assert not reason
    colours = {item.name: item.meshColor.tolist() for item in geometry.geometryObjects}
    assert set(colours) == {"ga", "gb", "gc", "seen"} and colours["seen"] == [1, 0, 0, 1]


# ---- random trees


def numbers(low, high, count):
    """Millimetres: MuJoCo takes offsets below a micrometre for none."""
    return st.lists(st.floats(low, high, width=32), min_size=count, max_size=count).map(
        lambda all_: " ".join(f"{each:.3f}" for each in all_)
    )


def axes():
    return numbers(-1, 1, 3).filter(lambda text: np.linalg.norm([float(each) for each in text.split()]) > 0.1)


@st.composite
def places(draw):
    kind = draw(st.sampled_from(["", "quat", "euler", "axisangle", "zaxis"]))
    turn = {
        "": st.just(""),
        "quat": numbers(0.125, 1, 4),
        "euler": numbers(-3, 3, 3),
        "axisangle": st.tuples(axes(), numbers(-3, 3, 1)).map(" ".join),
        "zaxis": axes(),
    }[kind]
    return f'pos="{draw(numbers(-1, 1, 3))}"' + (f' {kind}="{draw(turn)}"' if kind else "")


@st.composite
def joints(draw, number):
    kind = draw(st.sampled_from(["", 'type="hinge"', 'type="slide"']))
    low = draw(st.floats(-3, 0))
    parts = [f'name="j{number}"', kind]
    parts += [f'axis="{draw(axes())}"'] if draw(st.booleans()) else []
    parts += [f'pos="{draw(numbers(-0.5, 0.5, 3))}"'] if draw(st.booleans()) else []
    parts += [f'range="{low:.5g} {low + draw(st.floats(0.1, 3)):.5g}"'] if draw(st.booleans()) else []
    parts += [f'ref="{draw(st.floats(-1, 1)):.5g}"'] if draw(st.booleans()) else []
    parts += [draw(st.sampled_from(['limited="false"', 'class="k"', ""]))]
    return f"<joint {' '.join(parts)}/>"


@st.composite
def bodies(draw, counter, depth=0):
    number = counter["bodies"] = counter["bodies"] + 1
    inner = ""
    for _ in range(draw(st.integers(0 if depth else 1, 3))):
        counter["joints"] += 1
        inner += draw(joints(counter["joints"]))
    if depth == 0 and draw(st.booleans()):
        inner = "<freejoint/>"
    shape = draw(st.sampled_from(['size=".1"', 'type="box" size=".1 .2 .3"', 'class="v"', 'type="capsule" size=".1 .2"']))
    inner += f'<geom name="g{number}" {shape} {draw(places())}/><site name="s{number}" {draw(places())}/>'
    for _ in range(draw(st.integers(0, 2)) if depth < 3 else 0):
        child = draw(bodies(counter, depth + 1))
        inner += f"<frame {draw(places())}>{child}</frame>" if draw(st.booleans()) else child
    chosen = draw(st.sampled_from(["", 'childclass="v"', 'childclass="k"']))
    return f'<body name="b{number}" {chosen} {draw(places())}>{inner}</body>'


@st.composite
def trees(draw):
    """The text of an MJCF file, and of the body that it includes."""
    counter = {"bodies": 0, "joints": 0}
    angle, sequence = draw(st.sampled_from(["radian", "degree"])), draw(st.sampled_from(["xyz", "XYZ", "zYx", "ZYZ"]))
    defaults = f"""<default><geom {draw(places())}/><joint axis="{draw(axes())}"/><default class="v"><geom type="box" size=".1 .1 .2" {draw(places())}/>
    <joint pos="{draw(numbers(-0.5, 0.5, 3))}"/><default class="k"><joint type="slide" range="-.5 1"/></default></default></default>"""
    included = draw(bodies(counter))
    rest = "".join(draw(bodies(counter)) for _ in range(draw(st.integers(0, 2))))
    text = f"""<mujoco><compiler angle="{angle}" eulerseq="{sequence}"/>{defaults}<worldbody><geom name="wall" type="box" size="1 1 1" pos="5 0 0"/>
    <include file="part.xml"/>{rest}</worldbody></mujoco>"""
    return text, f"<mujoco>{included}</mujoco>"


@pytest.mark.slow
@given(texts=trees(), seed=st.integers(0, 2**32 - 1))
@settings(max_examples=60, deadline=None, suppress_health_check=list(HealthCheck))
def test_random_trees(tmp_path_factory, texts, seed):
    folder = tmp_path_factory.mktemp("tree")
    file = folder / "tree.xml"
    file.write_text(texts[0])
    (folder / "part.xml").write_text(texts[1])
    with pytest.MonkeyPatch.context() as patch:  # without a process of its own
        patch.setattr(mjcf, "compile_mjcf", lambda each: mujoco.MjModel.from_xml_path(str(each)))
        whole = mjcf.read_mjcf(Path(file))
        tools = [frame.name for frame in whole.model.frames if frame.type == pin.FrameType.BODY and frame.parentJoint > 0]
        if not tools:
            return
        robot = mp.Robot.from_mjcf(file, tool=tools[-1], velocity=1.0)
    rng, judge = np.random.default_rng(seed), Judge(file)
    compare(robot, judge, rng)
    for name in list(whole.model.names)[1:]:
        joint, number = whole.model.joints[whole.model.getJointId(name)], judge.model.joint(name).id
        expected = judge.model.jnt_range[number] if judge.model.jnt_limited[number] else (-np.inf, np.inf)
        np.testing.assert_array_equal(
            [whole.model.lowerPositionLimit[joint.idx_q], whole.model.upperPositionLimit[joint.idx_q]], expected
        )
    assert sum(each.mass for each in whole.model.inertias) <= judge.model.body_mass.sum() * (1 + 1e-12)


@pytest.mark.slow
def test_a_mesh_in_millimetres_is_refused(tmp_path):
    """Without scale="0.001 0.001 0.001" a body of 100 mm is 100 m long."""
    corners = [(x, y, z) for x in (0, 100) for y in (0, 100) for z in (0, 100)]
    faces = [(1, 2, 4), (1, 4, 3), (5, 7, 8), (5, 8, 6), (1, 5, 6), (1, 6, 2), (3, 4, 8), (3, 8, 7), (1, 3, 7), (1, 7, 5)]
    lines = [f"v {x} {y} {z}" for x, y, z in corners] + [f"f {a} {b} {c}" for a, b, c in [*faces, (2, 6, 8), (2, 8, 4)]]
    (tmp_path / "cube.obj").write_text("\n".join(lines))
    text = (
        '<mujoco><asset><mesh name="cube" file="cube.obj"{}/></asset><worldbody><body name="a"><joint name="j" axis="0 0 1"/>'
        '<geom name="part" type="mesh" mesh="cube"/><body name="tcp" pos="0.3 0 0"/></body></worldbody></mujoco>'
    )
    (tmp_path / "arm.xml").write_text(text.format(""))
    with pytest.raises(mp.errors.FileFormatError, match=r"part of link a \(mesh\) is 100 m long.*scale=\"0.001"):
        mp.load_robot(tmp_path / "arm.xml")
    (tmp_path / "arm.xml").write_text(text.format(' scale="0.001 0.001 0.001"'))
    assert mp.load_robot(tmp_path / "arm.xml", tool="tcp").n == 1


@pytest.mark.slow
def test_a_part_inside_a_closed_mesh_touches(tmp_path):
    """The cabinet is a cube of 12 triangles: what is wholly inside it was free, with a clearance of 102 mm."""
    corners = [(x, y, z) for x in (-0.25, 0.25) for y in (-0.25, 0.25) for z in (-0.25, 0.25)]
    faces = [(1, 2, 4), (1, 4, 3), (5, 7, 8), (5, 8, 6), (1, 5, 6), (1, 6, 2), (3, 4, 8), (3, 8, 7), (1, 3, 7), (1, 7, 5)]
    lines = [f"v {x} {y} {z}" for x, y, z in corners] + [f"f {a} {b} {c}" for a, b, c in [*faces, (2, 6, 8), (2, 8, 4)]]
    (tmp_path / "cube.obj").write_text("\n".join(lines))
    mass = '<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>'
    file = tmp_path / "cabinet.xml"
    file.write_text(
        '<mujoco><compiler angle="radian"/><asset><mesh name="cube" file="cube.obj"/></asset><worldbody><body name="base">'
        '<geom name="cabinet" type="mesh" mesh="cube" pos=".6 0 .5"/>'
        f'<body name="a" pos="0 0 .5"><joint name="j1" axis="0 0 1" range="-1 1"/>{mass}'
        f'<body name="b" pos=".1 0 0"><joint name="j2" axis="0 1 0" range="-1 1"/>{mass}'
        '<body name="c" pos=".2 0 0"><joint name="j3" type="slide" axis="1 0 0" range="0 .5"/>'
        '<geom name="tip" type="sphere" size=".03" pos=".1 0 0"/><body name="tcp" pos=".1 0 0"/></body></body></body></body>'
        "</worldbody></mujoco>"
    )
    robot = mp.load_robot(file, velocity=1.0)
    model = mujoco.MjModel.from_xml_path(str(file))
    data, q = mujoco.MjData(model), robot.random_configuration(np.random.default_rng(0), size=400)
    touching = []
    for each in q:
        data.qpos[:] = each
        mujoco.mj_fwdPosition(model, data)
        touching.append(any(contact.dist <= 0 for contact in data.contact))
    assert 50 < sum(touching) < 350
    np.testing.assert_array_equal(mp.Scene().in_collision(robot, q), touching)
    with pytest.raises(mp.errors.InvalidInputError, match="tip and cabinet overlap"):
        mp.plan(robot, [-0.15, 0, 0.25], [0.15, 0.1, 0.3])


@pytest.mark.slow
@pytest.mark.parametrize(
    ("sites", "tool"),
    [
        (("attachment_site",), "attachment_site"),
        (("imu", "ee_site", "camera_tool"), "ee_site"),
        (("pinch", "attachment_site"), "pinch"),
        (("grasp_site", "tcp_site", "pinch"), "tcp_site"),
        (("hand/pinch", "other"), "hand/pinch"),
        (("pinch_site", "left/pinch"), None),
        (("marker", "base_site"), None),
    ],
)
def test_the_name_of_a_site_on_the_last_body_makes_it_the_tool(arm, caplog, sites, tool):
    """Menagerie's arms have sites at the flange or between the fingers; the choice is in the log."""
    tips = "".join(f'<site name="{name}" pos="0 {0.01 * k} .1"/>' for k, name in enumerate(sites))
    body = mp.Robot.from_mjcf(arm(tip="")).tool
    with caplog.at_level(logging.INFO, "manipplan"):
        robot = mp.Robot.from_mjcf(file := arm(tip=tips))
    assert robot.tool == (tool or body)
    what = f"site {tool} of the body {body}" if tool is not None else f"body {body}"
    assert f"the tool is the {what}; sites that move with it: {', '.join(sites)}" in caplog.text
    assert mp.Robot.from_mjcf(file, tool=body).tool == body
    model = mujoco.MjModel.from_xml_path(str(file))
    data = mujoco.MjData(model)
    data.qpos[:] = q = robot.random_configuration(np.random.default_rng(0))
    mujoco.mj_kinematics(model, data)
    place = data.site(tool).xpos if tool is not None else data.body(body).xpos
    np.testing.assert_allclose(robot.kinematics(compiled=False).pose(q)[:3, 3], place, atol=1e-12)


@pytest.mark.slow
def test_a_site_on_another_body_or_with_the_name_of_a_body_is_not_the_tool(arm):
    plain = arm(tip="")
    body = mp.Robot.from_mjcf(plain).tool
    named = arm(tip='<site name="attachment_site" pos="0 0 .1"/><body name="tcp" pos="0 0 .2"><geom size=".01"/></body>')
    assert mp.Robot.from_mjcf(named).tool == "tcp"
    same = arm(tip=f'<site name="{body}" pos="0 0 .1"/>')
    assert mp.Robot.from_mjcf(same).tool == body


@pytest.mark.slow
def test_limits_that_an_mjcf_file_does_not_give_have_no_source(arm):
    robot = mp.Robot.from_mjcf(arm(tip=""))
    assert robot.limits.sources["velocity"] == "none in the MJCF; velocity= gives them"
    assert robot.limits.sources["acceleration"].startswith("none, as there are no velocity limits")


@pytest.mark.slow
@pytest.mark.parametrize(("mask", "dropped"), [("", True), ('contype="0" conaffinity="0"', False)])
def test_bodies_that_always_touch_are_left_out_with_all_their_geoms(written, mask, dropped, rng):
    """The hubs always overlap; fin and blade touch at some turns. Of a hub with masks of 0 the blade is checked alone."""
    file = written(
        f"""<mujoco><compiler angle="radian"/><worldbody><body name="base">
        <body name="a"><joint name="j1" axis="0 0 1" range="-3 3"/><geom name="a_hub" size=".06"/>
         <geom name="fin" type="box" size=".05 .02 .05" pos=".3 0 0"/>
        <body name="b" pos="0 0 .01"><joint name="j2" axis="0 0 1" range="-3 3"/><inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>
        <body name="c" pos="0 0 .01"><joint name="j3" axis="0 0 1" range="-3 3"/><geom name="c_hub" size=".06" {mask}/>
         <geom name="blade" type="box" size=".05 .02 .05" pos=".3 0 0"/></body></body></body></body></worldbody></mujoco>"""
    )
    robot = mp.Robot.from_mjcf(file, velocity=1.0)
    left_out = {frozenset((pair.first, pair.second)): pair.reason for pair in robot.self_collisions.left_out}
    assert ("touching at 201 of 201" in left_out.get(frozenset("ac"), "")) == dropped
    q = robot.random_configuration(rng, size=300)
    judge = Judge(file)
    touching = [bool(judge.contacts(robot, each)[0]) for each in q]
    assert all(touching) == dropped and any(touching)
    np.testing.assert_array_equal(mp.Scene().in_collision(robot, q), np.zeros(300) if dropped else touching)
