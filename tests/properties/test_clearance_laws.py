"""No two bodies of any arm come nearer than the bound on their motion says."""

import functools

import numpy as np
import pytest
from examples import examples
from hypothesis import given
from hypothesis import strategies as st

import manipplan as mp
from manipplan.collision import path_clearance
from manipplan.collision.path_clearance import SLACK, BodyMotion
from manipplan.collision.path_clearance import _Intervals as Intervals
from manipplan.paths.joint import split
from manipplan.support.kernels import kernel_by_llvm

QUICK = ("panda", "ur5")  # which other tests need, too; most of the time is the fit of primitives
ARMS = [name if name in QUICK else pytest.param(name, marks=pytest.mark.long) for name in mp.available_robots()]


@functools.cache
def among_obstacles(robot):
    scene = mp.Scene(
        [
            mp.Box(size=(0.3, 0.3, 0.3), position=(0.9, 0.1, 0.5)),
            mp.Capsule(radius=0.1, length=0.5, position=(0.1, -0.8, 0.9), rotation=(0.3, 0.4, 0.0)),
            mp.Plane(position=(0.0, 0.0, -1.0)),
        ]
    )
    model = scene.collision_model(robot)
    return model, BodyMotion(model) if model.pair_names else None


@pytest.fixture(scope="module", params=ARMS)
def arm(request):
    return request.getfixturevalue(request.param) if request.param in QUICK else mp.load_robot(request.param)


@pytest.mark.slow
@examples(8, derandomize=True)
@given(seed=st.integers(0, 2**32 - 1), size=st.floats(-4.0, 0.0))
def test_distance_falls_no_more_than_the_bound(arm, seed, size):
    robot = arm
    model, reach = among_obstacles(arm)
    if reach is None:
        assert not any(item.parentJoint for item in robot.geometry.geometryObjects)
        return
    rng = np.random.default_rng(seed)
    q = robot.random_configuration(rng)
    change = 10**size * rng.uniform(-1, 1, robot.n) * (rng.random(robot.n) < 0.7)
    pairs = np.arange(len(model.pair_names))
    before, after = model.distances(q), model.distances(q + change)
    bound = reach.motion(q[None], np.abs(change)[None], np.zeros(len(pairs), dtype=int), pairs)
    apart = before > bound + SLACK
    assert (after[apart] > 0).all()
    assert (after[apart] >= (before - bound)[apart] - SLACK).all()


@examples(30, derandomize=True)
@given(seed=st.integers(0, 2**32 - 1), size=st.floats(-3.0, -0.3))
def test_distance_on_an_interval_stays_above_its_bounds(arm, seed, size):
    """Both bounds hold at 201 places of a curve of degree 4, for pairs with an obstacle and of the arm itself."""
    robot = arm
    model, reach = among_obstacles(arm)
    if reach is None:
        return
    rng = np.random.default_rng(seed)
    control = robot.random_configuration(rng) + 10**size * rng.uniform(-1, 1, (5, robot.n))
    left, right = split(control[None])
    on = Intervals.of(control[None], left, right)
    pairs = np.arange(len(model.pair_names))
    rows = np.zeros(len(pairs), dtype=int)
    motion, bend = reach.motion_and_bend(on.q, on.change, (on.speed, on.acceleration), rows, pairs)
    far = np.full(len(pairs), 10.0)
    distances, bounds = model.interval_bounds(on.q[rows], on.slope[rows], pairs, beyond=far, bends=bend, motions=motion)
    curve = mp.JointPath(breaks=np.array([0.0, 1.0]), control=control[None])
    along = model.distance_rows(curve(np.linspace(0.0, 1.0, 201)))
    np.testing.assert_allclose(distances, along[100], atol=1e-9)
    known = np.isfinite(bounds)
    assert known[distances > SLACK].all()  # no surfaces here
    assert (bounds[known] <= along.min(axis=0)[known] + SLACK).all()


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["cloud", "mesh"])
def test_distance_to_a_surface_stays_above_its_bound(panda, rng, kind):
    """All that is behind one of a few planes, or too far away, stays away: on intervals near a surface the proof succeeds so."""
    ticks = np.linspace(-0.6, 0.6, 61)
    corners = np.stack([*np.meshgrid(ticks, ticks, indexing="ij"), np.zeros((61, 61))], axis=-1)
    corners[..., 2] = -0.05 + 0.01 * np.sin(20 * corners[..., 0]) * np.cos(15 * corners[..., 1])
    if kind == "cloud":
        surface = mp.PointCloud(points=corners.reshape(-1, 3), radius=0.01, name="ground")
    else:
        a, b, c, d = corners[:-1, :-1], corners[1:, :-1], corners[1:, 1:], corners[:-1, 1:]
        triangles = np.concatenate([np.stack([a, b, c], axis=2), np.stack([a, c, d], axis=2)]).reshape(-1, 3, 3)
        surface = mp.Mesh(triangles=triangles, name="ground")
    model = mp.Scene([surface]).collision_model(panda)
    reach, pairs = BodyMotion(model), np.flatnonzero(["ground" in names for names in model.pair_names])
    rows, proven, near = np.zeros(len(pairs), dtype=int), 0, 0
    some = panda.random_configuration(rng, size=8000)
    apart = model.distance_rows(some, beyond=0.05)[:, pairs].min(axis=1)
    for q in some[(apart > 0.0) & (apart < 0.02)]:
        control = (
            q + np.linspace(-1.0, 1.0, 4)[:, None] * rng.uniform(-0.02, 0.02, panda.n) + rng.uniform(-3e-4, 3e-4, (4, panda.n))
        )
        on = Intervals.of(control[None], *split(control[None]))
        motion, bend = reach.motion_and_bend(on.q, on.change, (on.speed, on.acceleration), rows, pairs)
        beyond = motion + rng.uniform(0.0, 0.5) * motion
        distances, bounds = model.interval_bounds(on.q[rows], on.slope[rows], pairs, beyond=beyond, bends=bend, motions=motion)
        curve = mp.JointPath(breaks=np.array([0.0, 1.0]), control=control[None])
        least = model.distance_rows(curve(np.linspace(0.0, 1.0, 101)))[:, pairs].min(axis=0)
        known = np.isfinite(bounds)
        assert (bounds[known] <= least[known] + SLACK).all()
        proven += (known & (distances < beyond)).sum()
        near += ((distances < beyond) & (least > beyond - motion)).sum()
    assert near > 50 and proven > near / 2


@pytest.mark.parametrize("by", ["compiler", "llvm"])
def test_motion_is_the_same_by_numpy(arm, rng, monkeypatch, by):
    model, reach = among_obstacles(arm)
    if reach is None:
        return
    if by == "llvm":
        call = kernel_by_llvm("body_motion").functions()["motion_bounds"]
        monkeypatch.setattr(path_clearance, "_compiled", lambda: call)
    q, change = arm.random_configuration(rng, size=20), rng.uniform(0.0, 0.3, (20, arm.n))
    rows, pairs = np.sort(rng.integers(0, 20, 300)), rng.integers(0, len(model.pair_names), 300)
    found, slow = reach.motion(q, change, rows, pairs), reach._motion_by_numpy(q, change, rows, pairs)
    # a point on a joint's axis has a lever of 0 in one and the root of a rounding error, 1e-8, in the other
    np.testing.assert_allclose(found, slow, rtol=1e-12, atol=1e-7)
