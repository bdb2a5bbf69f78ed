"""Another tool frame, another place of the base, carried parts: each is a new robot, checked against plain geometry."""

import copy
import pickle

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.viz.viewer.bodies import appearance_of

OFFSET = pin.SE3(pin.exp3(np.array([0.4, -0.2, 0.9])), np.array([0.02, -0.03, 0.15]))
BASE = pin.SE3(pin.exp3(np.array([-0.3, 0.6, 1.2])), np.array([0.5, -0.7, 0.9]))

#: Two tetrahedra apart from each other, as one mesh.
CORNERS = 0.05 * np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])[[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]]
TWO = mp.Mesh(triangles=np.concatenate([CORNERS, CORNERS + 0.2]))


@pytest.fixture
def qs(panda, rng):
    return panda.random_configuration(rng, size=6)


def poses(robot, q):
    return robot.kinematics(compiled=False).pose(q)


@pytest.mark.slow
@pytest.mark.parametrize("given", [OFFSET, OFFSET.homogeneous])
def test_a_tool_frame_is_posed_in_the_one_before(panda, qs, given):
    tool = panda.with_tool(given, name="nozzle")
    assert tool.tool == "nozzle" and panda.tool == "panda_hand_tcp"
    np.testing.assert_allclose(poses(tool, qs), poses(panda, qs) @ OFFSET.homogeneous, atol=1e-12)
    twice = tool.with_tool(OFFSET, name="tip")
    np.testing.assert_allclose(poses(twice, qs), poses(panda, qs) @ (OFFSET * OFFSET).homogeneous, atol=1e-12)
    with pytest.raises(mp.errors.InvalidInputError, match="name: got 'nozzle'.*no link, frame"):
        tool.with_tool(OFFSET, name="nozzle")


@pytest.mark.slow
def test_the_base_stands_elsewhere(panda, qs):
    moved = panda.at(BASE)
    np.testing.assert_allclose(poses(moved, qs), BASE.homogeneous @ poses(panda, qs), atol=1e-12)
    np.testing.assert_allclose(poses(moved.at(np.eye(4)), qs), poses(panda, qs), atol=1e-12)  # the place, not a further motion
    np.testing.assert_allclose(moved.kinematics().manipulability(qs), panda.kinematics().manipulability(qs), rtol=1e-9)


def test_arm_and_scene_at_another_place_have_the_same_distances(panda, demo_problem, qs):
    scene = demo_problem.scene
    before = [scene.distances(panda, q) for q in qs]
    after = [scene.at(BASE).distances(panda.at(BASE), q) for q in qs]
    np.testing.assert_allclose(after, before, atol=1e-6)


@pytest.mark.slow
def test_every_solution_reaches_the_pose_in_the_world(panda):
    moved = panda.at(BASE).with_tool(OFFSET)
    pose = poses(moved, moved.neutral)
    found = mp.inverse_kinematics(moved, pose, [moved.neutral[6]])
    np.testing.assert_allclose(poses(moved, found.q), np.broadcast_to(pose, (len(found.q), 4, 4)), atol=1e-8)
    assert np.abs(found.q - moved.neutral).max(axis=1).min() < 1e-6


def test_a_planar_arm_stays_planar_in_its_plane(planar):
    turned = pin.SE3(pin.utils.rotate("z", 0.7), np.array([0.3, 0.4, 0.0]))
    assert planar.at(turned).planar
    with pytest.raises(mp.errors.InvalidInputError, match="pose in the x-y plane"):
        planar.at(BASE)
    q = np.array([0.3, -0.5, 0.8])
    x, y = turned.act(np.array([*planar.kinematics().pose(q)[:2, 3], 0.0]))[:2]
    np.testing.assert_allclose(planar.at(turned).kinematics().pose(q)[:2, 3], [x, y], atol=1e-12)


def test_a_carried_part_moves_with_the_tool(panda, qs):
    """Distances of a carried ball to a ball in the world are those of their centres."""
    part = mp.Sphere(radius=0.03, position=(0.1, 0.02, 0.12))
    ball = mp.Sphere(radius=0.05, position=(0.4, 0.3, 0.6), name="ball")
    carrying = panda.attach(part, name="workpiece")
    scene = mp.Scene([ball])
    pair = scene.collision_model(carrying).pair_names.index(("workpiece", "ball"))
    centres = poses(panda, qs) @ [*part.position, 1.0]
    expected = np.linalg.norm(centres[:, :3] - ball.position, axis=1) - 0.08
    np.testing.assert_allclose(scene.distances(carrying, qs)[:, pair], expected, atol=1e-6)
    assert not any("workpiece" in names for names in scene.collision_model(panda).pair_names)


def test_a_part_is_checked_against_the_arm_but_not_against_the_hand(panda):
    rod = panda.attach(mp.Capsule(radius=0.01, length=1.0, position=(0, 0, 0.5)), name="rod")
    others = {name for pair in mp.Scene().collision_model(rod).pair_names for name in pair if "rod" in pair} - {"rod"}
    links = {name.split(".")[0] for name in others}
    assert {"panda_link1_0", "panda_link3_0", "panda_link5_0"} <= links
    assert not any("finger" in link or "hand" in link or "link7" in link for link in links)


def test_links_disabled_for_the_tool_are_not_disabled_for_the_part(panda):
    """The SRDF disables the hand against several links; what the hand carries has to be checked against them."""
    hand = mp.load_robot("panda", tool="panda_hand")
    assert any("panda_hand" in pair for pair in hand.disabled_pairs)
    rod = hand.attach(mp.Capsule(radius=0.01, length=1.0, position=(0, 0, 0.5)), name="rod")
    dropped = mp.Scene().collision_model(rod).dropped
    assert not any("rod" in pair for pair in dropped)


def test_a_part_that_is_inside_a_link_is_told(panda):
    """Links that touch everywhere are not checked; a carried part that does is."""
    long = panda.attach(mp.Box(size=(0.05, 0.05, 2.0)), name="beam")
    assert mp.Scene().in_collision(long, panda.neutral)
    with pytest.raises(mp.errors.InvalidInputError, match="beam.*overlap by"):
        mp.plan(long, panda.neutral, panda.neutral + 0.1)


def test_a_part_of_several_shapes(panda):
    robot = panda.attach(TWO, name="pair")
    scene = mp.Scene([mp.Sphere(radius=0.1, position=(0.5, 0, 0.5), name="ball")])

    def with_the_ball(scene):
        return [first for first, second in scene.collision_model(robot).pair_names if second == "ball" and "pair" in first]

    assert with_the_ball(scene) == ["pair.0", "pair.1"] and not with_the_ball(scene.allow("pair", "ball"))
    assert robot.detach("pair").geometry.ngeoms == panda.geometry.ngeoms
    assert list(panda.attach(mp.Sphere(radius=0.1, name="cup")).carried) == ["cup"]


@pytest.mark.slow
def test_the_floor_of_an_mjcf_stays(tmp_path):
    file = tmp_path / "arm.xml"
    file.write_text(
        "<mujoco><worldbody><geom name='floor' type='plane' size='1 1 1' pos='0 0 -1'/><body name='a'><joint name='i' type='hinge' "
        "axis='0 0 1' range='-1 1'/><geom size='.01'/><body name='b'><joint name='j' type='hinge' axis='0 1 0' range='-1 1'/>"
        "<geom type='sphere' size='0.1' pos='0.5 0 0'/></body></body></worldbody></mujoco>"
    )
    robot = mp.Robot.from_mjcf(file, tool="b", velocity=1.0)
    lifted = robot.at(pin.SE3(np.eye(3), np.array([0.0, 0.0, 0.3])))
    np.testing.assert_allclose(
        [mp.Scene().distances(each, [0.0, 0.0]).min() for each in (robot, lifted)], [0.9, 1.2], atol=1e-6
    )


def test_a_part_keeps_its_place_when_the_tool_changes(panda, qs):
    part = mp.Box(size=(0.05, 0.06, 0.1), position=(0.0, 0.01, 0.08), rotation=(0.1, 0.2, 0.3))
    scene = mp.Scene([mp.Box(size=(0.3, 0.3, 0.3), position=(0.5, 0.2, 0.4), name="box")])
    first, second = panda.attach(part).with_tool(OFFSET), panda.with_tool(OFFSET).attach(part.at(OFFSET.inverse()))
    np.testing.assert_allclose(scene.distances(first, qs), scene.distances(second, qs), atol=1e-9)
    np.testing.assert_allclose(
        first.carried["part"].solid.pose.homogeneous, second.carried["part"].solid.pose.homogeneous, atol=1e-12
    )


def test_detach_gives_the_arm_back(panda, demo_problem, qs):
    empty = panda.attach(mp.Sphere(radius=0.1, position=(0, 0, 0.1))).detach()
    assert demo_problem.scene.collision_model(empty).pair_names == demo_problem.scene.collision_model(panda).pair_names
    np.testing.assert_allclose(demo_problem.scene.distances(empty, qs), demo_problem.scene.distances(panda, qs), atol=1e-12)
    with pytest.raises(mp.errors.UnknownNameError, match="'prat'.*part"):
        panda.attach(mp.Sphere(radius=0.1)).detach("prat")
    with pytest.raises(mp.errors.UnknownNameError, match="carries nothing"):
        empty.detach()


@pytest.mark.slow
def test_a_part_is_lifted_from_a_table(panda):
    """What stands on the table becomes carried: it may touch the table, but nothing else."""
    q = panda.neutral
    tool = poses(panda, q)
    table = mp.Box(size=(0.2, 0.2, 0.02), position=tool[:3, 3] - [0, 0, 0.11], name="table")
    part = mp.Box(size=(0.03, 0.03, 0.1), position=tool[:3, 3] - [0, 0, 0.05], name="part")
    scene = mp.Scene([table, part])
    carrying = panda.attach(part.at(np.linalg.inv(tool)))
    with pytest.raises(mp.errors.InvalidInputError, match=r"scene without 'part'.*scene.without\('part'\)"):
        scene.in_collision(carrying, q)
    world = scene.without("part")
    assert world.in_collision(carrying, q) and not world.allow("part", "table").in_collision(carrying, q)
    plan = mp.plan(carrying, q, q + [0.6, 0, 0, 0, 0, 0, 0], world.allow("part", "table"))
    assert plan.report.passed
    near = mp.Scene([*world.obstacles, mp.Sphere(radius=0.05, position=tool[:3, 3] - [0, 0, 0.05], name="ball")])
    assert near.allow("part", "table").in_collision(carrying, q)


@pytest.mark.slow
def test_a_part_that_needs_room_changes_the_plan(panda):
    """The plan of an arm that carries a rod keeps the rod clear, as coal sees the rod alone."""
    start, goal = panda.neutral, panda.neutral + [1.4, 0, 0, 0, 0, 0, 0]
    free = mp.plan(panda, start, goal).path
    rod = mp.Capsule(radius=0.01, length=0.3, position=(0, 0, 0.15))
    post = mp.Sphere(radius=0.05, position=(poses(panda, free(0.5)) @ [0, 0, 0.25, 1])[:3], name="post")
    plan = mp.plan(panda.attach(rod, name="rod"), start, goal, mp.Scene([post]))

    def least(path):
        q = path(path.fine_samples(1e-3))
        ends = [(poses(panda, q) @ [0, 0, z, 1])[:, :3] for z in (0.0, 0.3)]
        along = ends[1] - ends[0]
        share = np.clip(np.einsum("ki,ki->k", post.position - ends[0], along) / np.einsum("ki,ki->k", along, along), 0, 1)
        return (np.linalg.norm(ends[0] + share[:, None] * along - post.position, axis=1) - 0.06).min()

    assert plan.report.passed and least(plan.path) > 0 > least(free)


@pytest.mark.slow
@pytest.mark.parametrize("copied", [copy.deepcopy, lambda robot: pickle.loads(pickle.dumps(robot))])
def test_copies_keep_what_was_changed(panda, qs, copied):
    robot = panda.at(BASE).with_tool(OFFSET).attach(mp.Sphere(radius=0.1, position=(0, 0, 0.1)), name="ball")
    twin = copied(robot)
    np.testing.assert_array_equal(poses(twin, qs), poses(robot, qs))
    assert list(twin.carried) == ["ball"] and "carried: ball" in str(twin)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda robot: robot.with_tool(np.zeros((4, 4))), "pose: .*rotation"),
        (lambda robot: robot.with_tool(np.eye(3)), r"pose: .*\(4, 4\)"),
        (lambda robot: robot.with_tool(np.eye(4), name="panda_hand"), "name: got 'panda_hand'"),
        (lambda robot: robot.with_tool(np.eye(4), name=""), "name"),
        (lambda robot: robot.with_tool(np.eye(4), name="a\nb"), "name"),
        (lambda robot: robot.at(np.full((4, 4), np.nan)), "pose: .*finite"),
        (lambda robot: robot.attach(mp.Plane()), "shape: .*a bounded shape"),
        (lambda robot: robot.attach(3), "shape: got 3.*such as Box"),
        (lambda robot: robot.attach(mp.Box), "shape: .*such as Box"),
        (lambda robot: robot.attach(TWO, name="a").attach(mp.Sphere(radius=1), name="a"), "name: got 'a'"),
        (lambda robot: robot.attach(mp.Sphere(radius=1), name="a").with_tool(np.eye(4), name="a"), "name: got 'a'"),
        (lambda robot: robot.detach(["part"]), "name"),
        (lambda robot: robot.attach(mp.Sphere(radius=1), name="panda_link3"), "name: got 'panda_link3'"),
        (lambda robot: robot.attach(mp.Sphere(radius=1)).attach(mp.Sphere(radius=1)), "name: got 'part'"),
        (lambda robot: robot.attach(mp.Sphere(radius=1), name=7), "name"),
    ],
)
def test_wrong_arguments(panda, call, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        call(panda)


@pytest.mark.slow
def test_what_is_drawn_has_the_part_and_the_base(panda):
    robot = panda.at(BASE).attach(mp.Sphere(radius=0.1, position=(0, 0, 0.2)), name="ball")
    before, after = (appearance_of(each).bodies for each in (panda, robot))
    assert [body.name for body in after] == [*(body.name for body in before), "ball"]
    still = [k for k, body in enumerate(before) if body.joint == 0]
    assert still
    for k, (old, new) in enumerate(zip(before, after, strict=False)):
        place = BASE if k in still else pin.SE3.Identity()
        np.testing.assert_allclose(new.vertices, old.vertices @ place.rotation.T + place.translation, atol=1e-9)
