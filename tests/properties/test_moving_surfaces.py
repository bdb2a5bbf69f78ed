"""Meshes that move, in the compiled kernel: against coal's own distances, by symmetry, and by finite differences."""

import coal
import numpy as np
import pinocchio as pin
import pytest
from coal_oracle import by_coal

from manipplan.collision.model import CollisionModel
from manipplan.collision.surfaces import triangle_tree
from manipplan.robots.limits import JointLimits
from manipplan.robots.robot import Robot


def ring():
    """Triangles (t, 3, 3) of a closed torus with radii 1 and 0.4."""
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, 25), np.linspace(0, 2 * np.pi, 13), indexing="ij")
    far = 1 + 0.4 * np.cos(v)
    corner = np.stack([far * np.cos(u), far * np.sin(u), 0.4 * np.sin(v)], axis=-1)
    corner[-1], corner[:, -1] = corner[0], corner[:, 0]
    a, b, c, d = corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]
    return np.concatenate([np.stack([a, b, c], axis=2), np.stack([a, c, d], axis=2)]).reshape(-1, 3, 3)


def surface(triangles):
    return triangle_tree(triangles.reshape(-1, 3), np.arange(3 * len(triangles)).reshape(-1, 3))


SHAPES = {
    "ring": lambda: surface(ring()),
    "cup": lambda: surface(ring()[::2]),
    "small ring": lambda: surface(0.1 * ring()),
    "box": lambda: coal.Box(0.3, 0.5, 0.2),
    "sphere": lambda: coal.Sphere(0.2),
    "drum": lambda: coal.Cylinder(0.2, 0.8),
    "floor": lambda: coal.Halfspace(np.array([0.0, 0.6, 0.8]), 0.1),
}
SOLID = ("ring", "small ring")
PAIRS = [
    (one, two, still)
    for one in SHAPES
    for two in SHAPES
    for still in (False, True)
    if {"ring", "cup", "small ring"} & {one, two} and one != "floor" and (two != "floor" or still)
]


def model_of(one, two, still=False):
    """Two bodies on six joints each, or the second one fixed."""
    model, geometry = pin.Model(), pin.GeometryModel()
    axes = [
        pin.JointModelPX,
        pin.JointModelPY,
        pin.JointModelPZ,
        pin.JointModelRX,
        pin.JointModelRY,
        pin.JointModelRZ,
    ]
    place = pin.SE3(pin.rpy.rpyToMatrix(0.3, 0.2, 0.1), np.array([0.1, 0.0, -0.2]))
    for number, name in enumerate((one, two)):
        joint = 0
        for k, kind in enumerate(() if number and still else axes):
            joint = model.addJoint(joint, kind(), pin.SE3.Identity(), f"{number}{k}")
        geometry.addGeometryObject(pin.GeometryObject(f"{number}", joint, 0, place, SHAPES[name]()))
    endless = np.full(model.nq, np.inf)
    limits = JointLimits(
        lower=-endless, upper=endless, velocity=endless, acceleration=endless, jerk=endless, effort=endless, sources={}
    )
    robot = Robot(name="two", model=model, geometry=geometry, tool="", limits=limits, neutral=np.zeros(model.nq))
    solids = [k for k, name in enumerate((one, two)) if name in SOLID]
    return CollisionModel(robot, geometry, np.array([[0, 1]]), {}, bodies=2, solids=solids)


def random_q(model, rng, count, wide=1.5):
    q = rng.uniform(-3, 3, (count, model.robot.n))
    for first in range(0, model.robot.n, 6):
        q[:, first : first + 3] = rng.uniform(-wide, wide, (count, 3)) / (1 + first / 6)
    return q


@pytest.mark.slow
@pytest.mark.parametrize(("one", "two", "still"), PAIRS)
def test_distances_and_verdicts_are_coal_s(one, two, still, rng):
    """To 1e-9 where they are apart, in sign where they touch; coal is asked for none of them."""
    model = model_of(one, two, still)
    q = random_q(model, rng, 60)
    expected = by_coal(model).distance_rows(q)[:, 0]
    found = model._kernel.distances(q, np.full(len(q), np.inf))[:, 0]
    apart = expected > 0
    np.testing.assert_allclose(found[apart], expected[apart], rtol=0, atol=1e-9)
    assert (found[~apart] <= 0).all() and apart.sum() + ("floor" in (one, two)) * len(q) > 0
    reach = np.linspace(0, 0.5, len(q))
    np.testing.assert_allclose(
        np.minimum(model._kernel.distances(q, reach)[:, 0], reach), np.minimum(found, reach), rtol=0, atol=1e-9
    )
    np.testing.assert_allclose(model.pair_distances(q, np.zeros(len(q), dtype=int)), found, rtol=0, atol=1e-9)
    for clearance in (0.0, 0.05):
        clear = np.abs(found - clearance) > 1e-8
        np.testing.assert_array_equal(model.in_collision_rows(q, clearance=clearance)[clear], (found < clearance)[clear])
    least, row, _ = model.least_distance(q)
    assert least == pytest.approx(found.min(), abs=1e-9) and found[row] == pytest.approx(least, abs=1e-9)
    near = model.near_pairs(q, 0.1)
    np.testing.assert_array_equal(near.rows, np.flatnonzero(found < 0.1))


@pytest.mark.parametrize(("one", "two"), [("ring", "cup"), ("ring", "box"), ("small ring", "ring"), ("drum", "cup")])
def test_the_order_of_two_bodies_does_not_matter(one, two, rng):
    model, turned = model_of(one, two), model_of(two, one)
    q = random_q(model, rng, 60)
    other = np.concatenate([q[:, 6:], q[:, :6]], axis=1)
    np.testing.assert_allclose(turned.distance_rows(other), model.distance_rows(q), rtol=0, atol=1e-9)
    np.testing.assert_array_equal(turned.in_collision_rows(other), model.in_collision_rows(q))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("one", "two", "still"),
    [
        ("ring", "cup", False),
        ("ring", "ring", False),
        ("ring", "box", False),
        ("sphere", "ring", False),
        ("small ring", "ring", True),
    ],
)
def test_gradients_by_finite_differences(one, two, still, rng):
    """Where bodies are apart, overlap, and one is inside the other; not where the nearest or deepest parts jump."""
    model, step, compared = model_of(one, two, still), 1e-5, {True: 0, False: 0}
    n, pair = model.robot.n, np.zeros(1, dtype=int)
    for q in random_q(model, rng, 60):
        at = model.distances(q)[0]
        sides = np.array([[model.distances(q + step * e)[0], model.distances(q - step * e)[0]] for e in np.eye(n)])
        if (np.abs(sides.sum(axis=1) - 2 * at) > 1e-8).any() or abs(at) < 1e-4:
            continue
        found = model.witnesses(q[None], pair)
        assert found.distances[0] == pytest.approx(at, abs=1e-9)
        np.testing.assert_allclose(found.gradients[0], (sides[:, 0] - sides[:, 1]) / (2 * step), atol=1e-3)
        compared[bool(at > 0)] += 1
    assert compared[True] > 2 and compared[True] + compared[False] > 10


def test_no_distance_of_meshes_is_asked_of_coal(rng, monkeypatch):
    for name in ("_distance", "_witness", "_touches"):
        monkeypatch.setattr(CollisionModel, name, lambda *_: pytest.fail("coal was asked"))
    model = model_of("ring", "small ring")
    q = random_q(model, rng, 200)
    distances = model.distance_rows(q)[:, 0]
    model.in_collision_rows(q, clearance=0.1)
    far = np.abs(distances) > 1e-5
    assert far.sum() > 100 and (distances < 0).any() and (distances > 0).any()
    assert len(model.witnesses(q[far], np.zeros(far.sum(), dtype=int)).distances) == far.sum()


@pytest.mark.parametrize("compiled", [True, False])
@pytest.mark.parametrize("still", [True, False])
@pytest.mark.parametrize(
    ("one", "two"), [("small ring", "ring"), ("ring", "small ring"), ("sphere", "ring"), ("ring", "sphere")]
)
def test_what_is_inside_a_solid_touches(one, two, still, compiled):
    """In the tube of the ring it touches, in its hole it does not; the signed distance says how far it is inside."""
    model = model_of(one, two, still)
    model = model if compiled else by_coal(model)
    place = pin.rpy.rpyToMatrix(0.3, 0.2, 0.1)  # of both bodies on their joints
    for x, inside in ((1.0, True), (0.0, False), (3.0, False)):
        q = np.zeros(model.robot.n)
        q[:3] = (-1 if one == "ring" else 1) * place @ [x, 0.0, 0.0]
        [distance] = model.distances(q)
        assert model.in_collision(q) is inside and bool(distance < 0) is inside
        if inside:
            assert distance < -0.1
