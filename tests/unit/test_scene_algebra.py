"""Scenes are values: moved, joined, without an obstacle, with pairs that may touch."""

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp

POSE = pin.SE3(pin.exp3(np.array([0.3, -0.5, 0.7])), np.array([1.0, 2.0, 3.0]))


@pytest.fixture
def scene():
    return mp.Scene(
        [
            mp.Box(size=(0.2, 0.3, 0.4), position=(0.6, 0.1, 0.2), rotation=(0.1, 0.2, 0.3)),
            mp.Capsule(radius=0.1, length=0.4, position=(-0.4, 0.3, 0.5), name="post"),
            mp.Plane(position=(0.0, 0.0, -0.1)),
        ],
        allowed=[("post", "panda_hand")],
    )


@pytest.mark.parametrize("given", [POSE, POSE.homogeneous])
def test_a_scene_moves_as_a_whole(scene, given):
    moved = scene.at(given)
    for before, after in zip(scene.obstacles, moved.obstacles, strict=True):
        np.testing.assert_allclose((POSE * before.pose).homogeneous, after.pose.homogeneous, atol=1e-12)
    assert moved.names == scene.names == ("box0", "post", "plane2") and moved.allowed == scene.allowed


def test_there_and_back_gives_the_same_distances(panda, scene, rng):
    back = scene.at(POSE).at(POSE.inverse())
    for q in panda.random_configuration(rng, size=5):
        np.testing.assert_allclose(back.distances(panda, q), scene.distances(panda, q), atol=1e-9)


def test_scenes_add_up(panda, scene):
    other = mp.Scene([mp.Box(size=(1, 1, 0.1), position=(0, 0, -0.5)), mp.Sphere(radius=0.1)], allowed=[("box0", "post")])
    both = scene + other
    assert both.names == ("box0", "post", "plane2", "box3", "sphere4")
    assert both.allowed_names() == [["box3", "post"], ["panda_hand", "post"]]  # the second scene's box has another number
    with pytest.raises(mp.errors.InvalidInputError, match="'post'.*names that differ"):
        scene + scene
    with pytest.raises(TypeError):
        scene + 3


def test_obstacles_keep_their_names_when_one_goes(scene):
    left = scene.without("post")
    assert left.names == ("box0", "plane2") and not left.allowed
    assert left.without("box0").names == ("plane2",)
    assert scene.without().names == scene.names
    with pytest.raises(mp.errors.UnknownNameError, match="'pots'.*post"):
        scene.without("pots")


def test_numbers_avoid_names_that_are_taken():
    boxes = [mp.Box(size=(1, 1, 1)), mp.Box(size=(1, 1, 1), name="box0"), mp.Box(size=(1, 1, 1))]
    assert mp.Scene(boxes).names == ("box1", "box0", "box2")


def test_an_allowed_pair_is_not_checked(panda):
    hand = panda.kinematics().pose(panda.neutral)[:3, 3]
    near = mp.Scene([mp.Sphere(radius=0.02, position=hand + [0, 0, 0.02], name="part")])
    assert near.in_collision(panda, panda.neutral)
    links = {f"panda_{name}" for name in ("hand", "leftfinger", "rightfinger")}
    free = near
    for link in sorted(links):
        free = free.allow("part", link)
    assert not free.in_collision(panda, panda.neutral)
    model = free.collision_model(panda)
    dropped = {pair for pair, reason in model.dropped.items() if reason == "allowed in the scene"}
    assert dropped and all(second == "part" for _, second in dropped)
    assert {first.rpartition("_")[0] for first, _ in dropped} == links
    assert len(model.pair_names) == len(near.collision_model(panda).pair_names) - len(dropped)


def test_two_links_may_touch(panda):
    pair = ("panda_link0", "panda_hand")
    free, checked = mp.Scene(allowed=[pair]).collision_model(panda), mp.Scene().collision_model(panda)
    gone = set(checked.pair_names) - set(free.pair_names)
    assert gone and {free.dropped[each] for each in gone} == {"allowed in the scene"}


def test_a_name_means_one_thing(panda):
    """An allowed name that is both an obstacle and a link would free two pairs."""
    scene = mp.Scene([mp.Sphere(radius=0.1, name="panda_link1"), mp.Sphere(radius=0.1, name="table")])
    assert scene.collision_model(panda).pair_names
    with pytest.raises(mp.errors.InvalidInputError, match="'panda_link1'.*another name for the obstacle"):
        scene.allow("panda_link1", "table").collision_model(panda)


def test_the_same_scene_twice_at_two_places():
    shelf = mp.Scene([mp.Box(size=(1, 1, 1)), mp.Sphere(radius=1)])
    assert (shelf + shelf.at(POSE)).names == (shelf.at(POSE) + shelf).names == ("box0", "sphere1", "box2", "sphere3")


@pytest.mark.parametrize("pair", [("part", "panda_hnad"), ("prat", "panda_hand")])
def test_names_of_allowed_pairs_are_checked(panda, pair):
    scene = mp.Scene([mp.Sphere(radius=0.1, name="part")], allowed=[pair])
    for check in (scene.collision_model, lambda robot: controller_among(robot, scene)):
        with pytest.raises(mp.errors.UnknownNameError, match=r"allowed.*(panda_hand|part)"):
            check(panda)


@pytest.mark.parametrize("allowed", [["ab"], [("a",)], [("a", "a")], [("a", "b", "c")], [("a", 3)], [("a", "")], [3], 5, None])
def test_wrong_pairs(allowed):
    with pytest.raises(mp.errors.InvalidInputError, match="allowed.*pairs of two different names"):
        mp.Scene(allowed=allowed)


def controller_among(robot, scene):
    avoidance = mp.Avoidance(scene=scene, links=["panda_hand", "panda_link5"], itself=False)
    return mp.Controller(robot, mp.formulations.LogDrive(), dt=0.01, avoidance=avoidance, compiled=False)


def test_a_controller_ignores_allowed_pairs(panda):
    ball = mp.Sphere(radius=0.05, position=(0.6, 0.0, 0.5), name="ball")
    scenes = mp.Scene([ball]), mp.Scene([ball], allowed=[("ball", "panda_hand")])
    pairs = [controller_among(panda, each).pairs for each in scenes]
    gone = set(pairs[0]) - set(pairs[1])
    assert gone and all(second == "ball" and first.startswith("panda_hand") for first, second in gone)


def test_allowed_pairs_are_in_the_file(tmp_path, scene):
    scene.to_yaml(tmp_path / "scene.yaml")
    assert mp.Scene.from_yaml(tmp_path / "scene.yaml").allowed == scene.allowed
