"""Reaching into hollow solids: free inside the cavity, touching inside the wall, and no path passes through a thin wall."""

import itertools

import numpy as np
import pytest

import manipplan as mp

DOWN = np.array([0.0, -0.3, 0.0, -2.2, 0.0, 1.9, 0.785])


def skin(rings):
    """Triangles (t, 3, 3) of the closed surface through rings of corners, with a lid at each end."""
    triangles = []
    for ring, following in itertools.pairwise(rings):
        for k, (a, d) in enumerate(zip(ring, following, strict=True)):
            triangles += [[a, ring[k - 1], following[k - 1]], [a, following[k - 1], d]]
    for lid in (rings[0], rings[-1][::-1]):
        triangles += [[lid[0], lid[1], lid[2]], [lid[0], lid[2], lid[3]]]
    return np.array(triangles, dtype=float)


def rectangle(z, half):
    return [[-half, -half, z], [half, -half, z], [half, half, z], [-half, half, z]]


def bin_around(point, wall, *, half=0.2, height=0.25):
    """A bin, open at the top, with `point` in the middle of its cavity; a wall of 0 is a surface."""
    low, high = point[2] - height / 2, point[2] + height / 2
    outside = [rectangle(low - wall, half + wall), rectangle(high, half + wall)]
    triangles = skin([*outside, rectangle(high, half), rectangle(low, half)]) if wall else skin([*outside])[:-2]
    return mp.Mesh(triangles=triangles + [point[0], point[1], 0.0], name="bin")


@pytest.fixture
def tool(panda):
    return panda.kinematics().pose(DOWN)[:3, 3]


@pytest.mark.parametrize("wall", [0.0, 0.002, 0.03])
def test_an_open_bin_is_free_inside_and_its_wall_is_not(panda, tool, wall):
    bin_ = bin_around(tool, wall)
    assert [part.closed for part in bin_.parts()] == [wall > 0]
    inside = mp.Scene([bin_])
    assert not inside.in_collision(panda, DOWN) and inside.distances(panda, DOWN).min() > 0.01
    assert mp.Scene([mp.Mesh(triangles=bin_.triangles, fill="hull")]).in_collision(panda, DOWN)
    beside = mp.Scene([bin_.at([[1, 0, 0, 0.2], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])])  # the wall at the tool
    assert beside.in_collision(panda, DOWN) and beside.distances(panda, DOWN).min() <= 0


@pytest.mark.parametrize("compiled", [True, False])
@pytest.mark.parametrize(
    "part", [mp.Sphere(radius=0.01), mp.Box(size=(0.02, 0.01, 0.03)), mp.Capsule(radius=0.005, length=0.02)]
)
def test_a_part_wholly_inside_a_thick_wall_touches(panda, tool, part, compiled, request):
    """The part touches no triangle: only the inside of the solid tells."""
    if not compiled:
        request.getfixturevalue("no_compiler")
    wall = 0.1
    carrying = panda.attach(part.at([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0.3], [0, 0, 0, 1]]), name="part")
    held = tool + 0.3 * panda.kinematics().pose(DOWN)[:3, 2]
    solid = bin_around(held, wall)
    others = [link for link in (frame.name for frame in panda.model.frames) if link.startswith("panda_")]
    for shift, inside in (((0.0, 0.0, 0.0), False), ((0.2 + wall / 2, 0.0, 0.0), True), ((0.0, 0.0, 0.125 + wall / 2), True)):
        pose = np.eye(4)
        pose[:3, 3] = shift
        scene = mp.Scene([solid.at(pose)])
        for name in dict.fromkeys(others):
            scene = scene.allow(name, "bin") if panda.model.existBodyName(name) else scene
        column = scene.collision_model(carrying).pair_names.index(("part", "bin"))
        assert scene.in_collision(carrying, DOWN) is inside
        assert (scene.distances(carrying, DOWN)[column] < 0) is np.bool_(inside)


@pytest.mark.parametrize("wall", [0.0, 0.0005, 0.03])
def test_no_path_through_a_wall_is_proven(panda, tool, wall):
    """From the middle of the bin to beside it: both ends are free, and the wall is between them."""
    bin_ = bin_around(tool, wall)
    scene = mp.Scene([bin_])
    beside = next(
        q
        for turn in np.linspace(0.3, 2.0, 18)
        if not scene.in_collision(panda, q := DOWN + np.array([turn, 0, 0, 0, 0, 0, 0]))
        and np.linalg.norm(panda.kinematics().pose(q)[:2, 3] - tool[:2]) > 0.3
    )
    line = mp.JointPath.line(DOWN, beside)
    proof = scene.path_clearance(panda, line)
    assert not scene.in_collision(panda, DOWN) and not scene.in_collision(panda, beside)
    assert not proof.proven and proof.refuted and proof.lower <= 0
    assert bool(proof.pair) and "bin" in proof.pair[1]
