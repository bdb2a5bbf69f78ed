"""How far bodies stick out of what they stand for: against closed forms, and against meshes measured another way."""

import coal
import numpy as np
import pinocchio as pin
import pytest
import trimesh

import manipplan as mp
from manipplan.collision.covers import SAMPLES, capsule_excess, capsule_points
from manipplan.collision.world import mesh_triangles
from manipplan.tracking.bodies import CapsuleBodies


def as_mesh(shape):
    """A trimesh as coal's mesh."""
    mesh = coal.BVHModelOBBRSS()
    mesh.beginModel(len(shape.faces), len(shape.vertices))
    mesh.addVertices(np.array(shape.vertices))
    mesh.addTriangles(np.array(shape.faces))
    mesh.endModel()
    return mesh


@pytest.mark.parametrize("length", [0.0, 0.05, 0.7])
def test_points_are_on_the_capsule_and_evenly_spread(length):
    start = np.array([0.1, -0.2, 0.3])
    axis = np.array([2.0, -1.0, 2.0]) / 3
    end, radius = start + length * axis, 0.08
    points = capsule_points(start, end, radius)
    nearest = start + np.clip((points - start) @ axis, 0.0, length)[:, None] * axis
    np.testing.assert_allclose(np.linalg.norm(points - nearest, axis=1), radius, atol=1e-12)
    poles = np.array([start, end]) + radius * np.outer([-1, 1], axis if length else [0, 0, 1])
    np.testing.assert_allclose(points[-2:], poles, atol=1e-12)
    apart = np.linalg.norm(points[:, None] - points[None], axis=2)[:SAMPLES, :SAMPLES]
    np.fill_diagonal(apart, np.inf)
    area = 2 * np.pi * radius * (length + 2 * radius)
    nearest = apart.min(axis=1) / np.sqrt(area / SAMPLES)
    assert nearest.min() > 0.5 and nearest.max() < 1.3


@pytest.mark.parametrize("meshed", [False, True])
def test_a_ball_around_a_cube(meshed):
    """It sticks out the most above the middle of each face: by (√3 - 1)/2 of the edge."""
    cube = as_mesh(trimesh.creation.box((0.2, 0.2, 0.2))) if meshed else coal.Box(0.2, 0.2, 0.2)
    exact = 0.1 * (np.sqrt(3) - 1)
    assert exact - 1e-3 < capsule_excess(np.zeros(3), np.zeros(3), 0.1 * np.sqrt(3), cube) <= exact + 1e-6


def test_a_capsule_around_a_cylinder_and_itself():
    ends = np.array([[0.0, 0.0, -0.3], [0.0, 0.0, 0.3]])
    assert capsule_excess(*ends, 0.1, coal.Cylinder(0.1, 0.6)) == pytest.approx(0.1, abs=1e-6)  # its poles
    assert capsule_excess(*ends, 0.1, coal.Capsule(0.1, 0.6)) == pytest.approx(0.0, abs=1e-6)


def test_what_is_inside_a_mesh_does_not_stick_out():
    """One of two capsules that overlap in a bar ends in its middle; inside, its pole is 0.1 m from the surface."""
    bar = as_mesh(trimesh.creation.box((0.2, 0.2, 2.0)))
    inner = np.array([[0.0, 0.0, -0.05], [0.0, 0.0, 0.05]])
    assert capsule_excess(*inner, 0.05, bar) == 0.0
    assert capsule_excess(inner[0], np.array([0.0, 0.0, 1.0]), 0.05, bar) == pytest.approx(0.05, abs=1e-6)


@pytest.mark.slow
def test_the_capsules_of_an_arm_against_its_meshes():
    """The excess of every capsule of a UR5, measured by trimesh at points of its own."""
    robot = mp.load_robot("ur5")
    bodies = CapsuleBodies.of(robot)
    assert bodies.excess == max(body.excess for body in bodies.items)
    compared = 0
    for body in bodies.items:
        if not isinstance(body.geometry.geometry, coal.BVHModelBase):
            continue
        mesh = trimesh.Trimesh(**dict(zip(("vertices", "faces"), whole(body.geometry), strict=True)))
        along = pin.Quaternion.FromTwoVectors(np.array([0.0, 0.0, 1.0]), body.end - body.start).matrix()
        shape = trimesh.creation.capsule(height=np.linalg.norm(body.end - body.start), radius=body.radius, count=(24, 24))
        shape.apply_translation(-shape.bounds.mean(axis=0))
        points = np.asarray(trimesh.sample.sample_surface(shape, 500, seed=0)[0]) @ along.T + (body.start + body.end) / 2
        apart = np.concatenate([trimesh.proximity.closest_point_naive(mesh, some)[1] for some in np.split(points, 20)])
        outside = ~inside(mesh, points)
        assert body.excess == pytest.approx(apart[outside].max(), abs=4e-3), body
        compared += 1
    assert compared >= 6


def whole(item):
    triangles = mesh_triangles(item.geometry) @ item.placement.rotation.T + item.placement.translation
    return triangles.reshape(-1, 3), np.arange(3 * len(triangles)).reshape(-1, 3)


def inside(mesh, points):
    """Whether a ray from each point passes an odd number of triangles, in most of three directions."""
    odd = np.zeros(len(points), dtype=int)
    for direction in np.array([[0.31, 0.52, 0.8], [-0.7, 0.2, 0.5], [0.1, -0.8, -0.4]]):
        a, b, c = np.moveaxis(np.asarray(mesh.triangles), 1, 0)
        u, v = b - a, c - a
        h = np.cross(direction, v)
        scale = 1.0 / np.where(np.abs(np.einsum("ij,ij->i", u, h)) < 1e-15, np.inf, np.einsum("ij,ij->i", u, h))
        for k, point in enumerate(points):
            s = point - a
            first = scale * np.einsum("ij,ij->i", s, h)
            other = np.cross(s, u)
            second, depth = scale * (other @ direction), scale * np.einsum("ij,ij->i", v, other)
            hits = (first >= 0) & (second >= 0) & (first + second <= 1) & (depth > 0) & (scale != 0)
            odd[k] += np.count_nonzero(hits) % 2
    return odd >= 2


def test_bodies_say_how_far_they_stick_out(tmp_path):
    file = tmp_path / "arm.urdf"
    file.write_text("""<robot name="arm"><link name="base"/><link name="b"><collision><origin xyz="0 0 0.3"/><geometry>
      <cylinder radius="0.05" length="0.4"/></geometry></collision></link><joint name="x" type="revolute"><parent link="base"/>
      <child link="b"/><axis xyz="1 0 0"/><limit lower="-1" upper="1" velocity="1" effort="1"/></joint></robot>""")
    bodies = CapsuleBodies.of(mp.load_robot(file))
    [body] = bodies.items
    assert body.excess == pytest.approx(0.05, abs=1e-6)
    assert repr(body) == "CapsuleBody('b_0', radius=50 mm, excess=50 mm)"
    assert repr(bodies) == "CapsuleBodies(1 bodies, 0 pairs, excess=50 mm)"


def test_a_collision_model_says_what_it_checks(tmp_path):
    arm = mp.planar_arm([1.0, 1.0, 1.0])
    scene = mp.Scene([mp.Box(size=(0.2, 0.2, 0.2), position=(5, 0, 0)), mp.Sphere(radius=0.1, position=(5, 1, 0))])
    model = scene.collision_model(arm)
    counts = f"{model.bodies} bodies, 2 parts of obstacles, {len(model.pair_names)} pairs"
    assert repr(model) == f"CollisionModel({arm.name!r}, {counts}, excess up to 0.0 mm)"


@pytest.mark.slow
def test_described_meshes_are_no_obstacles():
    """For pairs whose pieces are too coarse, a model also holds the meshes of the description."""
    model = mp.Scene().collision_model(mp.load_robot("icub"))
    assert model.geometry.ngeoms > model.bodies
    assert " 0 parts of obstacles, " in repr(model)
    assert f"up to {1e3 * max(model.excess.values()):.1f} mm" in repr(model)
