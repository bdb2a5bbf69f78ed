"""Robots whose joints follow active ones, from kinematics to export.

The oracle is Pinocchio's model of the file, in which followers are independent and are placed by hand.
"""

import copy
import pickle

import coal
import numpy as np
import pinocchio as pin
import pytest
from follower_robots import ONE_TOOL, ROBOTS, written

import manipplan as mp


@pytest.fixture(scope="module")
def arms(tmp_path_factory):
    """File, robot and oracle by name."""
    folder = tmp_path_factory.mktemp("followers")
    made = {}

    def get(name):
        if name not in made:
            made[name] = written(folder, name)
        return made[name]

    return get


def samples(robot, count, seed=0):
    return robot.random_configuration(np.random.default_rng(seed), size=count)


# ---- model and kinematics


@pytest.mark.parametrize("name", ROBOTS)
def test_pose_and_jacobian_are_those_of_the_whole_file(arms, name):
    _, robot, whole = arms(name)
    assert robot.model.nq == robot.n == len(robot.joint_names) < whole.model.nq
    for each in (robot, pickle.loads(pickle.dumps(robot)), copy.deepcopy(robot), robot.with_limits(velocity=1.0)):
        for tool in robot.tools:
            joints = list(robot.joints_of(tool))
            kinematics = each.arm(tool).kinematics(mp.Task.pose(length=1.0), compiled=False)
            for q in samples(robot, 5):
                q = np.where(np.isin(np.arange(robot.n), joints), q, robot.neutral)
                np.testing.assert_allclose(kinematics.pose(q[joints]), whole.pose(q, tool), atol=1e-12)
                np.testing.assert_allclose(kinematics.jacobian(q[joints]), whole.jacobian(q, tool)[:, joints], atol=1e-12)


@pytest.mark.parametrize("compiled", [False, True])
@pytest.mark.parametrize("name", ONE_TOOL)
def test_derivatives_of_the_manipulability(arms, name, compiled):
    _, robot, whole = arms(name)
    task = mp.Task.pose(length=0.7) if robot.n >= 6 else mp.Task.position()
    kinematics = robot.kinematics(task, compiled=compiled)
    rows = np.diag([1, 1, 1, 0.7, 0.7, 0.7])[: task.rows]
    q = samples(robot, 4, seed=3)
    values = [np.sqrt(np.linalg.det((J := rows @ whole.jacobian(each, robot.tool)) @ J.T)) for each in q]
    np.testing.assert_allclose(kinematics.manipulability(q), values, rtol=1e-7, atol=1e-10)
    step, unit = 1e-5, np.eye(robot.n)
    by_value = [(kinematics.manipulability(q + step * e) - kinematics.manipulability(q - step * e)) / (2 * step) for e in unit]
    by_slope = [(kinematics.gradient(q + step * e) - kinematics.gradient(q - step * e)) / (2 * step) for e in unit]
    np.testing.assert_allclose(kinematics.gradient(q), np.transpose(by_value), atol=1e-6)
    np.testing.assert_allclose(kinematics.hessian(q), np.transpose(by_slope, (1, 2, 0)), atol=1e-5)


@pytest.mark.parametrize("name", ONE_TOOL)
def test_inverse_kinematics_finds_its_own_configuration(arms, name):
    _, robot, whole = arms(name)
    task = mp.Task.pose() if robot.n >= 6 else mp.Task.position()
    for q in samples(robot, 3, seed=1):
        pose = whole.pose(q, robot.tool)
        known = {"held": [robot.joint_names[0]], "parameters": q[:1]} if robot.n == 7 else {}
        found = mp.inverse_kinematics(robot, pose, task=task, **known)
        assert found.method == "newton" and found.complete.name == "STATISTICAL"
        for each in found.q:
            miss = whole.pose(each, robot.tool) - pose
            np.testing.assert_allclose(miss[:3] if task.rows == 6 else miss[:3, 3], 0.0, atol=1e-8)
            assert not robot.limits.outside(each).any()
        assert robot.n == 4 or np.abs(found.q - q).max(axis=1).min() < 1e-6
