"""Coarse copies of crowded scenes: pieces around everything, few of them, and plans that begin among them."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial import ConvexHull

import manipplan as mp
from manipplan.collision.coarse import CELLS, PieceHull, coarse_scene
from manipplan.optimize.local import LocalSearch, Until

START, GOAL = np.array([-0.8, 0.4, 0, -1.6, 0, 2.0, 0.8]), np.array([0.8, 0.4, 0, -1.6, 0, 2.0, 0.8])


def plates(*boxes, spacing=0.01):
    """Points (k, 3) on the surfaces of boxes, each given by centre and size."""
    found = []
    for middle, size in boxes:
        steps = [np.linspace(-0.5, 0.5, max(2, int(np.ceil(edge / spacing)) + 1)) for edge in size]
        grid = np.stack(np.meshgrid(*steps, indexing="ij"), axis=-1).reshape(-1, 3)
        found.append(np.asarray(middle) + grid[np.abs(grid).max(axis=1) == 0.5] * size)
    return np.concatenate(found)


def pieces(scene):
    return [each for each in scene.obstacles if isinstance(each, PieceHull)]


def depth(scene, points):
    """How far points (k, 3) are inside the piece that contains them most deeply [m]; negative outside all pieces."""
    inside = [-(points @ hull.equations[:, :3].T + hull.equations[:, 3]).max(axis=1) for hull in hulls(scene)]
    return np.max(inside, axis=0)


def hulls(scene):
    return [ConvexHull(each.corners) for each in pieces(scene)]


def test_a_hollow_cloud_becomes_one_piece(panda):
    points = plates(((0.5, 0.0, 0.4), (0.3, 0.2, 0.4)))
    scene = coarse_scene(mp.Scene([mp.PointCloud(points=points, radius=0.004, name="crate")]), panda)
    assert len(pieces(scene)) == 1
    assert depth(scene, points).min() >= 0.004 - 1e-9
    assert depth(scene, np.array([[0.5, 0.0, 0.4]]))[0] > 0.09
    size = np.ptp(pieces(scene)[0].corners, axis=0)
    np.testing.assert_allclose(size, np.array([0.3, 0.2, 0.4]) + 0.008, atol=2e-3)


def test_a_turned_crate_keeps_its_size(panda):
    points = plates(((0.0, 0.0, 0.0), (0.3, 0.2, 0.4)))
    cloud = mp.PointCloud(points=points, radius=0.004, position=(0.5, 0.0, 0.4), rotation=(0.4, 0.5, 0.6))
    [hull] = hulls(coarse_scene(mp.Scene([cloud]), panda))
    assert hull.volume == pytest.approx(0.308 * 0.208 * 0.408, rel=0.02)


def test_an_open_bin_stays_open(panda):
    wall = 0.012
    sides = [((0.5 + x, y, 0.3), size) for x, y, size in (
        (-0.15, 0.0, (wall, 0.3, 0.2)), (0.15, 0.0, (wall, 0.3, 0.2)), (0.0, -0.15, (0.3, wall, 0.2)), (0.0, 0.15, (0.3, wall, 0.2))
    )]  # fmt: skip
    points = plates(*sides, ((0.5, 0.0, 0.2), (0.3, 0.3, wall)))
    scene = coarse_scene(mp.Scene([mp.PointCloud(points=points, radius=0.002)]), panda)
    assert len(pieces(scene)) == 5
    assert depth(scene, points).min() > 0
    inside = np.array([[0.5, 0.0, 0.3], [0.42, 0.08, 0.36], [0.57, -0.07, 0.27]])
    assert depth(scene, inside).max() < 0


@pytest.mark.slow
@pytest.mark.parametrize("make", [
    lambda place: mp.Box(size=(0.05, 0.04, 0.03), position=place, rotation=(0.3, 0.2, 0.1)),
    lambda place: mp.Sphere(radius=0.02, position=place),
    lambda place: mp.Capsule(radius=0.01, length=0.03, position=place, rotation=(1.0, 0.0, 0.0)),
    lambda place: mp.Cylinder(radius=0.01, length=0.03, position=place),
])  # fmt: skip
def test_pieces_contain_small_obstacles(panda, make):
    """Every corner of the boxes around the obstacles' shapes, pulled in to their surface, lies in a piece."""
    places = (0.5, 0.0, 0.4) + 0.035 * (np.array(list(np.ndindex(6, 5, 5))) - 2.0)
    scene = mp.Scene([make(place) for place in places])
    coarse = coarse_scene(scene, panda)
    assert len(coarse.obstacles) == len(pieces(coarse)) <= 4
    ways = np.random.default_rng(0).normal(size=(200, 3))
    for obstacle in scene.obstacles:
        [part] = obstacle.parts()
        hits = np.array([extreme(part.shape, obstacle.pose.rotation.T @ way) for way in ways])
        assert depth(coarse, hits @ obstacle.pose.rotation.T + obstacle.pose.translation).min() > -1e-9


def extreme(shape, way):
    """The point of a convex shape that lies farthest along `way` (3,)."""
    name = type(shape).__name__
    if name == "Box":
        return np.sign(way) * shape.halfSide
    if name == "Cylinder":
        flat = np.r_[way[:2], 0.0]
        return shape.radius * flat / np.linalg.norm(flat) + np.array([0, 0, np.sign(way[2]) * shape.halfLength])
    length = getattr(shape, "halfLength", 0.0)
    return shape.radius * way / np.linalg.norm(way) + np.array([0, 0, np.sign(way[2]) * length])


def test_what_stays_as_it_is(panda):
    points = plates(((0.5, 0.0, 0.4), (0.2, 0.2, 0.2)))
    cloud, other = (
        mp.PointCloud(points=points, radius=0.01, name="cloud"),
        mp.PointCloud(points=points, radius=0.01, name="lid"),
    )
    table, floor = mp.Box(size=(1, 1, 0.1), position=(0, 0, -0.5), name="piece"), mp.Plane(position=(0, 0, -1), name="floor")
    small = [mp.Box(size=(0.1, 0.1, 0.1), position=(0.5, 0.2 * k, 0.4)) for k in range(10)]
    assert coarse_scene(mp.Scene(), panda) is None
    assert coarse_scene(mp.Scene([table, floor, *small]), panda) is None
    scene = mp.Scene([table, floor, cloud, other], allowed=[("lid", "panda_hand")])
    coarse = coarse_scene(scene, panda)
    assert coarse.names[:3] == ("piece", "floor", "lid")
    assert len(coarse.obstacles) == 4
    assert coarse.allowed == scene.allowed
    assert coarse_scene(scene, panda) is coarse


def test_what_is_out_of_reach_is_left_out(panda):
    points = plates(((20.0, 0.0, 0.4), (0.5, 0.5, 0.5)))
    scene = mp.Scene([mp.PointCloud(points=points, radius=0.01)])
    assert coarse_scene(scene, panda) is None
    both = scene + mp.Scene([mp.PointCloud(points=points - [19.5, 0.0, 0.0], radius=0.01)])
    assert len(coarse_scene(both, panda).obstacles) == 1
    pose = np.eye(4)
    pose[0, 3] = 19.5
    assert len(coarse_scene(scene, panda.at(pose)).obstacles) == 1


def test_too_many_pieces(panda, rng):
    """Points all over, far from each other: no few pieces contain them and nothing else."""
    places = rng.uniform(-0.8, 0.8, (400, 3))
    assert coarse_scene(mp.Scene([mp.PointCloud(points=places, radius=CELLS[0])]), panda) is None


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["cloud", "mesh", "boxes"])
def test_plans_among_many_are_those_around_the_body_that_they_form(panda, kind):
    """The straight path goes through a crate: the hollow and the split one are passed as the solid one is."""
    middle, size = np.array([0.55, 0.0, 0.45]), np.array([0.12, 0.12, 0.5])
    solid = mp.plan(panda, START, GOAL, mp.Scene([mp.Box(size=size, position=middle)]))
    if kind == "cloud":
        crowd = [mp.PointCloud(points=plates((middle, size - 4e-3), spacing=5e-3), radius=2e-3)]
    elif kind == "mesh":
        steps = np.stack(np.meshgrid(*[[-0.5, 0.5]] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
        hull = ConvexHull(steps * size)
        notch = np.array([0.02, 0.02, 0.05])  # a second shell, so that the mesh as a whole is not convex
        triangles = np.concatenate(
            [hull.points[hull.simplices], hull.points[hull.simplices] / size * notch + [0.0, 0.0, -0.275]]
        )
        crowd = [mp.Mesh(triangles=triangles, position=middle)]
    else:
        cells = (np.array(list(np.ndindex(4, 4, 10))) + 0.5) / (4, 4, 10) - 0.5
        crowd = [mp.Box(size=size / (4, 4, 10), position=middle + cell * size) for cell in cells]
    scene = mp.Scene(crowd)
    found = mp.plan(panda, START, GOAL, scene)
    assert found.status.ok
    assert scene.path_clearance(panda, found.path).proven
    assert found.result.g == pytest.approx(solid.result.g, rel=0.01)


@pytest.mark.slow
def test_a_start_beside_a_cloud_is_no_obstacle_to_planning(panda):
    """The start is free, but touches the piece around the cloud's corner: the plan begins at the path that OMPL found."""
    hand = panda.kinematics().pose(START)
    plate = plates(((0.0, 0.0, 0.05), (0.1, 0.1, 0.02)))  # in front of the fingers
    cloud = mp.PointCloud(points=plate, radius=6e-3).at(hand)
    far = float(mp.Scene([cloud]).distances(panda, START).min())
    scene = mp.Scene([mp.PointCloud(points=plate - [0.0, 0.0, far - 3e-4], radius=6e-3).at(hand)])
    assert not scene.in_collision(panda, START)
    assert coarse_scene(scene, panda).in_collision(panda, START)
    found = mp.plan(panda, START, GOAL, scene)
    assert found.status.has_path
    assert scene.path_clearance(panda, found.path).proven


@pytest.mark.slow
def test_the_room_around_the_robot_stays_open(panda):
    """A closed cell of points around the robot: its walls are pieces, its inside is not."""
    room = mp.Scene([mp.PointCloud(points=plates(((0.0, 0.0, 0.5), (1.6, 1.6, 1.6)), spacing=0.02), radius=0.01)])
    coarse = coarse_scene(room, panda)
    assert len(pieces(coarse)) >= 6
    assert not coarse.in_collision(panda, START)


def test_a_robot_without_bounds_and_scenes_that_are_odd(panda):
    """Bodies that do not move, an endless floor and points far away change nothing."""
    points = plates(((0.5, 0.0, 0.4), (0.2, 0.2, 0.2)))
    cloud = mp.PointCloud(points=points, radius=0.01)
    far = mp.PointCloud(points=points + [1e5, 0.0, 0.0], radius=0.01, name="far")
    wide = mp.PointCloud(points=[[0.5, 0.0, 0.4]], radius=0.2, name="ball")
    for scene in (mp.Scene([cloud, far]), mp.Scene([cloud, mp.Plane(position=(0.0, 0.0, -1.0))])):
        assert len(pieces(coarse_scene(scene, panda))) == 1
    assert depth(coarse_scene(mp.Scene([wide]), panda), np.array([[0.5, 0.0, 0.4], [0.5, 0.19, 0.4]])).max() > 0


def test_sticks_are_covered_along_their_length(panda):
    sticks = [mp.Capsule(radius=0.005, length=0.065, position=(0.4, 0.005 * k - 0.25, 0.4)) for k in range(100)]
    coarse = coarse_scene(mp.Scene(sticks), panda)
    assert len(pieces(coarse)) == 1
    along = np.array([[0.4, 0.0, 0.4 + z] for z in np.linspace(-0.037, 0.037, 9)])
    assert depth(coarse, along).min() > 0


@pytest.mark.slow
def test_several_first_paths_and_given_ones_in_a_crowd(panda):
    """Each is solved, and a given path that touches a piece, or that the planner did not find, is no error."""
    points = plates(((0.55, 0.0, 0.45), (0.1, 0.1, 0.5)))
    scene = mp.Scene([mp.PointCloud(points=points, radius=6e-3)])
    several = mp.optimize_path(panda, START, GOAL, scene, seeding=mp.Seeding(count=2))
    assert several.status.ok
    again = mp.optimize_path(panda, START, GOAL, scene, seeding=mp.Seeding(initial=several.path))
    assert again.g <= several.g * (1 + 1e-6)
    for path in (several.path, again.path):
        assert scene.path_clearance(panda, path).proven
    assert any(step.first.startswith("coarse") for step in several.history)


@pytest.mark.slow
def test_the_coarse_optimum_stands_in_where_no_descent_succeeds(panda, monkeypatch):
    """It is proven in the scene itself, and not called optimal there."""
    points = plates(((0.55, 0.0, 0.45), (0.1, 0.1, 0.5)))
    scene = mp.Scene([mp.PointCloud(points=points, radius=6e-3)])
    descend = LocalSearch.descend

    def fails_in_the_scene(self, name, coefficients, **options):
        return None if name in ("coarse", "path") else descend(self, name, coefficients, **options)

    monkeypatch.setattr(LocalSearch, "descend", fails_in_the_scene)
    result = mp.optimize_path(panda, START, GOAL, scene)
    assert result.status is mp.Status.STOPPED_EARLY
    assert scene.path_clearance(panda, result.path).proven
    monkeypatch.setattr(LocalSearch, "keeps", lambda *_: False)
    assert mp.optimize_path(panda, START, GOAL, scene).status is mp.Status.SEED_IS_SAFE


@pytest.mark.slow
def test_margins_grow_where_proofs_fail_again_and_again(panda, monkeypatch):
    """After two failures the kept distance is 0.09 mm, and the path still meets the first-order conditions."""
    points = plates(((0.55, 0.0, 0.45), (0.1, 0.1, 0.5)))
    scene = mp.Scene([mp.PointCloud(points=points, radius=6e-3)])
    proof, failures = LocalSearch.proof, []

    def fails_twice(self, path, margin=0.0):
        found = proof(self, path, margin)
        if self.until is Until.OPTIMAL and len(failures) < 2:
            failures.append(found)
            return replace(found, lower=found.lower - 1e-3)
        return found

    monkeypatch.setattr(LocalSearch, "proof", fails_twice)
    result = mp.optimize_path(panda, START, GOAL, scene)
    assert len(failures) == 2
    assert result.status.ok
    assert scene.path_clearance(panda, result.path, clearance=6e-5).proven
