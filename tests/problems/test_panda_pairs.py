"""Twenty random start and goal pairs of the Panda among five boxes, judged by code of this file alone."""

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp


def free_pairs(problem, count):
    """Random pairs, free of collision, between which RRTConnect finds a path."""
    rng = np.random.default_rng(7)
    robot, scene = problem.robot, problem.scene
    while count:
        start, goal = robot.random_configuration(rng, size=2)
        if scene.in_collision(robot, np.array([start, goal])).any():
            continue
        try:
            seed = mp.seed_path(robot, start, goal, scene, seeding=mp.Seeding(time_limit=3.0))
        except mp.errors.PlanningError:
            continue
        yield start, goal, seed
        count -= 1


def touches(problem, q):
    """Pinocchio on the meshes of the description, none of our primitives; self-collision pairs as in the SRDF."""
    robot = problem.robot
    geometry = robot.geometry.copy()
    bodies = list(geometry.geometryObjects)
    for i, first in enumerate(bodies):
        for j, second in enumerate(bodies[:i]):
            links = frozenset(robot.model.frames[item.parentFrame].name for item in (first, second))
            if first.parentJoint != second.parentJoint and links not in robot.disabled_pairs:
                geometry.addCollisionPair(pin.CollisionPair(j, i))
    for obstacle in problem.scene.obstacles:
        index = geometry.addGeometryObject(pin.GeometryObject("box", 0, 0, obstacle.pose, obstacle.shapes()[0]))
        for body, item in enumerate(bodies):
            if item.parentJoint > 0:
                geometry.addCollisionPair(pin.CollisionPair(body, index))
    data, geometry_data = robot.model.createData(), pin.GeometryData(geometry)
    return [pin.computeCollisions(robot.model, data, geometry, geometry_data, each, True) for each in q]


def g_of(robot, path):
    s = np.linspace(0, 1, 20_001)
    jacobian = robot.kinematics().jacobian(path(s))
    index = np.prod(np.linalg.svd(jacobian, compute_uv=False), axis=1)
    return np.trapezoid(np.linalg.norm(path(s, 1), axis=1) / index, s)


@pytest.mark.long
def test_twenty_pairs_on_the_meshes(demo_problem):
    for start, goal, _ in free_pairs(demo_problem, 20):
        plan = mp.plan(demo_problem.robot, start, goal, demo_problem.scene)
        assert not any(touches(demo_problem, plan.trajectory.path()(plan.trajectory.path().fine_samples(1e-3))))


def test_twenty_pairs(demo_problem):
    robot, optimised = demo_problem.robot, 0
    for start, goal, seed in free_pairs(demo_problem, 20):
        plan = mp.plan(robot, start, goal, demo_problem.scene)
        trajectory = plan.trajectory
        t = np.linspace(0, trajectory.duration, 20_001)
        q = trajectory(t)
        assert (q >= robot.limits.lower - 1e-6).all()
        assert (q <= robot.limits.upper + 1e-6).all()
        assert (np.abs(trajectory(t, 1)) <= robot.limits.velocity * (1 + 1e-6)).all()
        assert (np.abs(trajectory(t, 2)) <= robot.limits.acceleration * (1 + 1e-6)).all()
        np.testing.assert_allclose(q[[0, -1]], [start, goal], atol=1e-9)
        # at every 1 mrad on the primitives, at every 10 mrad on the meshes
        fine = trajectory.path()(trajectory.path().fine_samples(1e-3))
        assert np.abs(np.diff(fine, axis=0)).max() <= 1e-3
        assert not demo_problem.scene.in_collision(robot, fine).any()
        assert not any(touches(demo_problem, fine[::10]))
        assert g_of(robot, plan.path) <= g_of(robot, seed) * (1 + 1e-9)
        optimised += plan.status.ok
    assert optimised >= 12
