"""Which pairs of links are checked, by the description alone: adjacent links, bodies on fixed joints, pairs that always touch."""

import logging
import re
import xml.etree.ElementTree as ET
from math import cos, pi, sin

import coal
import numpy as np
import pinocchio as pin
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import manipplan as mp
from manipplan.collision.self_collisions import LinkPair, SelfCollisions

LIMIT = '<limit lower="{}" upper="{}" velocity="2" effort="1"/>'


def joint(name, parent, child, axis, xyz="0 0 0", low=-3, high=3):
    return (
        f'<joint name="{name}" type="revolute"><parent link="{parent}"/><child link="{child}"/><origin xyz="{xyz}"/>'
        f'<axis xyz="{axis}"/>{LIMIT.format(low, high)}</joint>'
    )


def fixed(name, parent, child, xyz="0 0 0"):
    return f'<joint name="{name}" type="fixed"><parent link="{parent}"/><child link="{child}"/><origin xyz="{xyz}"/></joint>'


def body(size, xyz="0 0 0", rpy="0 0 0"):
    return f'<collision><origin xyz="{xyz}" rpy="{rpy}"/><geometry><box size="{size}"/></geometry></collision>'


def robot_of(folder, text, name="arm.urdf", **options):
    file = folder / name
    file.write_text(f'<robot name="arm">{text}</robot>')
    return mp.load_robot(file, **options)


BEFORE_THE_TOOL = (
    '<link name="base_link"/><link name="l1"/>'
    + joint("j1", "base_link", "l1", "0 0 1", "0 0 0.5")
    + joint("j2", "l1", "l2", "0 1 0", low=-2, high=2)
    + f'<link name="l2">{body("0.3 0.05 0.05", "0.15 0 0")}</link>'
    + joint("j3", "l2", "l3", "0 1 0", "0.4 0 0")
    + f'<link name="l3">{body("0.06 0.06 0.06")}</link>'
)
TOOL = body("0.04 0.04 0.35", "0 0 0.2")
BRACKET = BEFORE_THE_TOOL + f'<link name="tool">{TOOL}</link>' + fixed("jt", "l3", "tool", "0 0 0.05")


def test_a_tool_on_a_fixed_joint_is_checked_against_the_link_before_the_last_joint(tmp_path):
    """It was adjacent because the URDF fixes it to the flange: a plan went through the arm and passed."""
    robot = robot_of(tmp_path, BRACKET)
    assert ("l2", "tool") in {(pair.first, pair.second) for pair in robot.self_collisions.checked}
    with pytest.raises(mp.errors.PlanningError, match="tool_0 and l2_0"):
        mp.plan(robot, [0, 0, 0.8], [0.5, 0, -2.9])
    plan = mp.plan(robot, [0, 0, 0.8], [0.5, 0, -2.9], throw=False)
    assert plan.status is mp.Status.NO_PATH
    swept = np.linspace([0, 0, 0.8], [0.5, 0, -2.9], 200)
    assert mp.Scene().in_collision(robot, swept).any()
    speed = np.broadcast_to((swept[-1] - swept[0]) / 10, swept.shape)
    motion = mp.Trajectory(t=np.linspace(0, 10, 200), q=swept, qd=speed, joint_names=robot.joint_names)
    report = mp.check(robot, motion)
    assert not report.passed


@pytest.fixture
def same_part(tmp_path):
    """The arm with a part on its tool: fixed by the URDF, attached, and part of the tool's own body."""
    part = body("0.05 0.3 0.06", "0.02 0.1 0.3", "0.3 0.2 0.1")
    on_fixed_joint = robot_of(tmp_path, BRACKET + f'<link name="part">{part}</link>' + fixed("jp", "tool", "part"), tool="tool")
    shape = mp.Box(size=(0.05, 0.3, 0.06), position=(0.02, 0.1, 0.3), rotation=(0.3, 0.2, 0.1))
    attached = robot_of(tmp_path, BRACKET, "plain.urdf").attach(shape)
    welded = robot_of(tmp_path, BRACKET.replace(TOOL, TOOL + part), "welded.urdf")
    return on_fixed_joint, attached, welded


def test_the_same_part_gives_the_same_verdicts_however_it_is_joined(same_part, rng):
    q = same_part[0].random_configuration(rng, size=1000)
    verdicts = [mp.Scene().in_collision(robot, q) for robot in same_part]
    assert 50 < verdicts[0].sum() < 950
    np.testing.assert_array_equal(verdicts[0], verdicts[1])
    np.testing.assert_array_equal(verdicts[0], verdicts[2])
    # and those of boxes placed by Pinocchio from the file
    [file] = [same_part[0].source.file]
    model = pin.buildModelFromUrdf(str(file))
    geometry = pin.buildGeomFromUrdf(model, str(file), pin.GeometryType.COLLISION)
    names = [item.name for item in geometry.geometryObjects]
    for first in ("tool_0", "part_0"):
        geometry.addCollisionPair(pin.CollisionPair(names.index("l2_0"), names.index(first)))
    data, geometry_data = model.createData(), pin.GeometryData(geometry)
    expected = [pin.computeCollisions(model, data, geometry, geometry_data, each, True) for each in q]
    np.testing.assert_array_equal(verdicts[0], expected)


def test_a_table_on_the_base_is_checked_against_the_first_link(tmp_path):
    text = (
        f'<link name="base"/><link name="table">{body("0.1 2 0.2", "0.5 0 0.3")}</link>'
        + fixed("jt", "base", "table")
        + joint("j1", "base", "l1", "0 0 1")
        + f'<link name="l1">{body("0.6 0.05 0.05", "0.3 0 0.3")}</link>'
        + joint("j2", "l1", "l2", "0 1 0", "0.6 0 0.3")
        + '<link name="l2"/>'
    )
    robot = robot_of(tmp_path, text, tool="l2")
    np.testing.assert_array_equal(mp.Scene().in_collision(robot, [[0.0, 0.0], [1.57, 0.0]]), [True, False])


def ring_of_boxes():
    angles = np.arange(8) * pi / 4
    return "".join(body("0.02 0.07 0.05", f"{0.08 * cos(a)} {0.08 * sin(a)} 0", f"0 0 {a}") for a in angles)


def test_links_that_always_touch_with_other_bodies_each_time_are_left_out_as_a_whole(tmp_path, caplog):
    caplog.set_level(logging.INFO)
    text = (
        f'<link name="base"/><link name="l1">{ring_of_boxes()}</link><link name="l2"/><link name="l3">{ring_of_boxes()}</link>'
        + f'<link name="l4">{body("0.4 0.02 0.02", "0.2 0 0")}</link>'
        + joint("j1", "base", "l1", "0 0 1")
        + joint("j2", "l1", "l2", "0 0 1", "0 0 0.02")
        + joint("j3", "l2", "l3", "0 0 1")
        + joint("j4", "l3", "l4", "0 1 0", "0 0 0.1")
    )
    robot = robot_of(tmp_path, text)
    model = mp.Scene().collision_model(robot)
    assert model.dropped["l1", "l3"] == "touching at 201 of 201 configurations"
    assert sum("l1" in pair and "l3" in pair for pair in model.dropped) == 1
    assert not mp.Scene().in_collision(robot, robot.random_configuration(np.random.default_rng(0), size=100)).all()
    assert mp.plan(robot, [0, 0, 0, -0.5], [1, 1, 1, -1]).report.passed
    assert re.search("not checked, as they touch nearly everywhere .*: l1 and l3", caplog.text)


def test_a_clearance_that_own_links_never_have_comes_with_the_remedy(tmp_path):
    """A collar turns 5 mm above the link before the one that carries it."""
    text = (
        f'<link name="base"/><link name="l1">{body("0.1 0.1 0.1")}</link><link name="l2"/><link name="l3">{body("0.1 0.1 0.1")}</link>'
        + joint("j1", "base", "l1", "0 0 1")
        + joint("j2", "l1", "l2", "0 0 1")
        + joint("j3", "l2", "l3", "0 0 1", "0 0 0.105")
    )
    robot, scene = robot_of(tmp_path, text), mp.Scene([mp.Sphere(radius=0.1, position=(0.155, 0.0, 0.0), name="ball")])
    wanted = r"required clearance is 0.01 m; these links of the arm are nearer than that at 100% of .*: ask for less, or .*'l1', 'l3'"
    with pytest.raises(mp.errors.InvalidInputError, match=wanted):
        mp.plan(robot, [0, 0, 0], [1, 1, 1], clearance=0.01)
    assert mp.plan(robot, [0, 0, 0], [1, 1, 1], mp.Scene().allow("l1", "l3"), clearance=0.01).report.passed
    with pytest.raises(mp.errors.InvalidInputError, match=r"ball are 0.005 m apart, but the required clearance is 0.01 m$"):
        mp.plan(robot, [0, 0, 0], [1, 1, 1], scene.allow("l1", "l3"), clearance=0.01)


TELESCOPE = (
    f'<link name="base"/><link name="l1">{body("0.2 0.2 1.0")}</link><link name="l2"/><link name="l3">{body("0.1 0.1 1.0")}</link>'
    + joint("j1", "base", "l1", "0 0 1")
    + joint("j2", "l1", "l2", "0 1 0", "0 0 0.7", -0.6, 0.6)
    + joint("j3", "l2", "l3", "1 0 0", "0 0 0.3", -0.5, 0.5)
)


def test_a_pair_that_touches_often_comes_with_the_line_that_allows_it(tmp_path):
    robot = robot_of(tmp_path, TELESCOPE)
    [pair] = robot.self_collisions.checked
    assert {pair.first, pair.second} == {"l1", "l3"} and 0.3 < pair.contact < 0.95
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"touch at \d+% of random.*scene.allow\('l1', 'l3'\).*to_srdf"
    ) as error:
        mp.plan(robot, [0, 0, 0], [1, 0.1, 0.1])
    assert "scene.allow" in str(error.value)
    allowed = mp.Scene().allow("l1", "l3")
    assert not allowed.in_collision(robot, np.zeros(3))
    file = tmp_path / "arm.srdf"
    robot.self_collisions.to_srdf(file, touching=0.3)
    again = mp.load_robot(tmp_path / "arm.urdf", srdf=file)
    assert not mp.Scene().in_collision(again, np.zeros(3))
    robot.self_collisions.to_srdf(file)
    assert mp.Scene().in_collision(mp.load_robot(tmp_path / "arm.urdf", srdf=file), np.zeros(3))
    for wrong in (0.0, 1.5, np.nan, "0.5"):
        with pytest.raises(mp.errors.InvalidInputError, match="touching"):
            robot.self_collisions.to_srdf(file, touching=wrong)


def test_many_touching_pairs_are_printed_in_part(tmp_path):
    pair = LinkPair(first="a", second="b", reason="", checked=True, contact=0.5)
    text = str(SelfCollisions(robot=robot_of(tmp_path, TELESCOPE), pairs=(pair,) * 45))
    assert text.count("a - b: touching") == 30 and "... and 15 more that touch less often; .checked has all" in text
    assert "... and" not in str(SelfCollisions(robot=robot_of(tmp_path, TELESCOPE), pairs=(pair,) * 30))


def test_the_srdf_has_all_pairs_that_are_left_out(tmp_path):
    robot = robot_of(tmp_path, BRACKET)
    robot.self_collisions.to_srdf(tmp_path / "arm.srdf")
    pairs = {
        frozenset((each.get("link1"), each.get("link2"))): each.get("reason")
        for each in ET.parse(tmp_path / "arm.srdf").getroot().iter("disable_collisions")
    }
    assert pairs == {frozenset(("l2", "l3")): "Adjacent", frozenset(("l3", "tool")): "Fixed"}
    assert "1 checked, 2 left out" in str(robot.self_collisions)
    reasons = {str(pair).partition(": ")[2] for pair in robot.self_collisions.left_out}
    assert reasons == {"parent and child link of one joint", "no joint between them moves"}


@pytest.mark.slow
@settings(max_examples=25, deadline=None)
@given(st.integers(0, 10**6))
@example(577)
def test_random_trees_are_checked_as_by_pinocchio_and_coal(tmp_path_factory, seed):
    """Links with boxes on revolute and fixed joints; adjacent are the parent and the child link of one joint and no others."""
    rng, folder = np.random.default_rng(seed), tmp_path_factory.mktemp("trees")
    links = ["base"]
    parts = [f'<link name="base">{body("0.1 0.1 0.1")}</link>']
    for k in range(int(rng.integers(4, 9))):
        parent = links[int(rng.integers(max(0, len(links) - 3), len(links)))]
        size, place, shift = (
            " ".join(map(str, values)) for values in (rng.uniform(0.02, 0.2, 3), *rng.uniform(-0.2, 0.2, (2, 3)))
        )
        parts.append(f'<link name="l{k}">{body(size, shift) if rng.random() < 0.8 else ""}</link>')
        axis = ("1 0 0", "0 1 0", "0 0 1")[int(rng.integers(3))]
        turns = k < 2 or rng.random() < 0.5
        parts.append(joint(f"j{k}", parent, f"l{k}", axis, place) if turns else fixed(f"j{k}", parent, f"l{k}", place))
        links.append(f"l{k}")
    file = folder / "tree.urdf"
    file.write_text(f'<robot name="tree">{"".join(parts)}</robot>')
    model = pin.buildModelFromUrdf(str(file))
    last = model.njoints - 1
    tool = next(frame.name for frame in model.frames if frame.parentJoint == last and frame.type == pin.FrameType.BODY)
    robot = mp.load_robot(file, tool=tool)
    geometry = pin.buildGeomFromUrdf(model, str(file), pin.GeometryType.COLLISION)
    joined = {
        frozenset((each.find("parent").get("link"), each.find("child").get("link")))
        for each in ET.parse(file).getroot().iter("joint")
    }
    objects = list(geometry.geometryObjects)
    left_out = {frozenset((pair.first, pair.second)) for pair in robot.self_collisions.left_out}
    names = []
    for j, second in enumerate(objects):
        for i, first in enumerate(objects[:j]):
            pair = frozenset(model.frames[each.parentFrame].name for each in (first, second))
            moving = set(model.supports[first.parentJoint]) ^ set(model.supports[second.parentJoint])
            active = {model.getJointId(name) for name in robot.joint_names}
            if pair in joined or not moving & active:
                assert pair in left_out
                continue
            names.append(pair)
            geometry.addCollisionPair(pin.CollisionPair(i, j))
    data, geometry_data = model.createData(), pin.GeometryData(geometry)
    q = robot.random_configuration(rng, size=100)
    whole = np.zeros((100, model.nq))
    whole[:, [model.joints[model.getJointId(name)].idx_q for name in robot.joint_names]] = q
    for name, value in robot.locked.items():
        whole[:, model.joints[model.getJointId(name)].idx_q] = value
    touching = np.zeros((100, len(names)), dtype=bool)
    for k, each in enumerate(whole):
        pin.computeDistances(
            model, data, geometry, geometry_data, each
        )  # coal's yes or no misses overlaps of 2 mm of two boxes
        touching[k] = [result.min_distance <= 0 for result in geometry_data.distanceResults]
    always = [pair in left_out for pair in names]
    assert (touching[:, always].mean(axis=0) > 0.85).all()
    np.testing.assert_array_equal(mp.Scene().in_collision(robot, q), touching[:, ~np.array(always, dtype=bool)].any(axis=1))


@pytest.mark.parametrize("sides", [250, 254, 255, 256, 300, 1000])
@pytest.mark.parametrize("height", [0.0, 0.1])
def test_a_link_with_a_fine_cone_or_cylinder_can_be_planned_for(tmp_path, sides, height):
    """Coal's hulls allow 254 neighbours of a corner: the tip of a cone has more, and so has a corner of a flat end."""
    angles = np.linspace(0, 2 * np.pi, sides, endpoint=False)
    rim = np.column_stack([0.05 * np.cos(angles), 0.05 * np.sin(angles), 0 * angles])
    top = rim + [0, 0, height] if height else np.array([[0, 0, 0.1]])
    after = np.roll(np.arange(sides), -1)
    if height:
        sheets = [[rim, rim[after], top], [rim[after], top[after], top], [rim, 0 * rim, rim[after]]]
        sheets += [[top, top[after], 0 * top + [0, 0, height]]]
    else:
        sheets = [[rim, rim[after], np.repeat(top, sides, 0)], [rim, 0 * rim, rim[after]]]
    triangles = np.concatenate([np.stack(sheet, axis=1) for sheet in sheets])
    record = np.zeros(len(triangles), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
    record["corners"] = triangles
    (tmp_path / "fine.stl").write_bytes(bytes(80) + len(record).to_bytes(4, "little") + record.tobytes())
    mesh = f'<collision><geometry><mesh filename="{tmp_path / "fine.stl"}"/></geometry></collision>'
    robot = robot_of(tmp_path, BEFORE_THE_TOOL + f'<link name="tool">{mesh}</link>' + fixed("jt", "l3", "tool"))
    wall = mp.Scene([mp.Box(size=(0.2, 0.2, 1.2), position=(0.614, 0.436, 0.5))])
    model = wall.collision_model(robot)
    assert max(model.excess.values()) < 3e-4
    for q in robot.random_configuration(np.random.default_rng(0), size=50):
        data = robot.model.createData()
        pin.framesForwardKinematics(robot.model, data, q)
        place = data.oMf[robot.model.getFrameId("tool")]
        corners = triangles.reshape(-1, 3) @ place.rotation.T + place.translation
        inside = (np.abs(corners - [0.614, 0.436, 0.5]) < [0.1, 0.1, 0.6]).all(axis=1).any()
        if inside:
            assert wall.in_collision(robot, q)
    assert mp.plan(robot, [0, 0, 0], [0.3, 0.2, 0.1], wall).report.passed


def test_a_part_carried_by_the_arm_may_have_any_form(panda, rng):
    """A ring that is carried is checked as pieces: each touches what the triangles touch."""
    angles = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    circle = np.column_stack([np.cos(angles), np.sin(angles), 0 * angles])
    sheets = []
    corners = [0.2 * circle, 0.2 * circle + [0, 0, 0.03], 0.15 * circle + [0, 0, 0.03], 0.15 * circle]
    after = np.roll(np.arange(24), -1)
    for k in range(4):
        a, b = corners[k], corners[(k + 1) % 4]
        sheets += [np.stack([a, a[after], b], axis=1), np.stack([a[after], b[after], b], axis=1)]
    ring = mp.Mesh(triangles=np.concatenate(sheets), position=(0, 0, 0.1), name="ring")
    robot = panda.attach(ring)
    ball = mp.Scene([mp.Sphere(radius=0.04, position=(0.45, 0.0, 0.35), name="ball")])
    [part] = ring.parts()
    touching = 0
    for q in robot.random_configuration(rng, size=300):
        pose = robot.kinematics().pose(q) @ ring.pose.homogeneous
        place = coal.Transform3s(pose[:3, :3], pose[:3, 3])
        centre = coal.Transform3s(np.eye(3), np.array([0.45, 0.0, 0.35]))
        apart = coal.distance(part.shape, place, coal.Sphere(0.04), centre, coal.DistanceRequest(), coal.DistanceResult())
        ours = [
            d
            for d, names in zip(ball.distances(robot, q), ball.collision_model(robot).pair_names, strict=True)
            if "ring" in names[0] and names[1] == "ball"
        ]
        assert min(ours) <= apart + 1e-6
        assert min(ours) >= apart - 0.03
        touching += apart <= 0
    assert robot.detach("ring").carried == {}
