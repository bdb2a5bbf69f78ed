"""No two bodies of any arm come nearer than the bound on their motion says."""

import functools

import numpy as np
import pytest
from examples import examples
from hypothesis import given
from hypothesis import strategies as st

import manipplan as mp
from manipplan.collision.body_motion import BodyMotion
from manipplan.collision.path_clearance import SLACK

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
