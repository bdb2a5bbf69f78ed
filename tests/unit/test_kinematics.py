"""Kinematics against Pinocchio, finite differences and published numbers."""

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.robots.description import frame_index

GOLDEN = [0.0, -0.3, 0.0, -2.2, 0.0, 2.0, np.pi / 4]


@pytest.mark.parametrize("name", mp.available_robots())
def test_pose_jacobian_and_index_equal_pinocchio(name, rng):
    robot = mp.load_robot(name)
    kinematics = robot.kinematics(mp.Task.pose(length=1.0))
    frame = frame_index(robot.model, robot.tool)
    data = robot.model.createData()
    q = robot.random_configuration(rng, size=100)
    pose, jacobian, index = kinematics.pose(q), kinematics.jacobian(q), kinematics.manipulability(q)
    for k in range(len(q)):
        oracle = pin.computeFrameJacobian(robot.model, data, q[k], frame, pin.LOCAL_WORLD_ALIGNED)
        pin.framesForwardKinematics(robot.model, data, q[k])
        np.testing.assert_allclose(pose[k], data.oMf[frame].homogeneous, rtol=0, atol=1e-12)
        np.testing.assert_allclose(jacobian[k], oracle, rtol=0, atol=1e-12)
        by_singular_values = np.prod(np.linalg.svd(oracle)[1]) if robot.n >= 6 else 0.0
        assert index[k] == pytest.approx(by_singular_values, abs=1e-12)


def test_published_indices_of_the_panda(panda):
    """Numbers that the Robotics Toolbox for Python holds in its tests, for the same posture and frame."""
    assert panda.kinematics(mp.Task.pose(1.0)).manipulability(GOLDEN) == pytest.approx(0.0838, abs=5e-5)
    assert panda.kinematics(mp.Task.position()).manipulability(GOLDEN) == pytest.approx(0.1438, abs=5e-5)
    assert panda.kinematics(mp.Task.orientation()).manipulability(GOLDEN) == pytest.approx(2.7456, abs=5e-5)


TASKS = [mp.Task.pose(0.3), mp.Task.position(), mp.Task.orientation(), mp.Task.planar(), mp.Task.pointing((1, 2, 2))]


@pytest.mark.parametrize("task", TASKS, ids=lambda task: task.name)
def test_derivatives_equal_central_differences(panda, task, rng):
    kinematics = panda.kinematics(task)
    step = 1e-5
    for q in panda.random_configuration(rng, size=5):
        moved = q + step * np.concatenate([np.eye(7), -np.eye(7)])
        values = kinematics.manipulability(moved)
        slopes = kinematics.gradient(moved)
        scale = np.abs(kinematics.gradient(q)).max()
        np.testing.assert_allclose(kinematics.gradient(q), (values[:7] - values[7:]) / (2 * step), atol=1e-7 * max(scale, 1))
        numeric = (slopes[:7] - slopes[7:]) / (2 * step)
        np.testing.assert_allclose(kinematics.hessian(q), numeric, atol=1e-6 * max(np.abs(numeric).max(), 1))


def test_index_is_the_root_of_the_determinant(panda, rng):
    kinematics = panda.kinematics(mp.Task.pose(0.5))
    for q in panda.random_configuration(rng, size=20):
        jacobian = kinematics.jacobian(q)
        assert kinematics.manipulability(q) == pytest.approx(np.sqrt(np.linalg.det(jacobian @ jacobian.T)), rel=1e-6)


def test_length_scales_the_angular_rows(panda):
    raw = panda.kinematics(mp.Task.pose(1.0)).jacobian(GOLDEN)
    scaled = panda.kinematics(mp.Task.pose(0.25)).jacobian(GOLDEN)
    np.testing.assert_allclose(scaled[:3], raw[:3])
    np.testing.assert_allclose(scaled[3:], 0.25 * raw[3:])
    assert mp.Task.pose(0.25).unit == "m^6"
    assert mp.Task.pose(1.0).unit == "m^3"


def test_pointing_leaves_the_rotation_about_the_axis_out(panda):
    """Rows equal those of the Jacobian in the tool's frame without its z row: an orthonormal change of the other two."""
    pointing = panda.kinematics(mp.Task.pointing((0, 0, 1), length=1.0))
    full = panda.kinematics(mp.Task.pose(1.0)).jacobian(GOLDEN)
    rotation = pointing.pose(GOLDEN)[:3, :3]
    in_tool = (rotation.T @ full[3:])[:2]
    expected = np.sqrt(np.linalg.det(np.vstack([full[:3], in_tool]) @ np.vstack([full[:3], in_tool]).T))
    assert pointing.manipulability(GOLDEN) == pytest.approx(expected, rel=1e-9)


def test_singular_posture_gives_zero_not_nan(planar):
    kinematics = planar.kinematics()
    assert kinematics.manipulability([0.4, 0.0, 0.0]) == pytest.approx(0.0, abs=1e-15)
    assert np.isfinite(kinematics.gradient([0.4, 0.0, 0.0])).all()


def test_fewer_joints_than_rows_is_identically_zero():
    robot = mp.load_robot("so100")
    assert robot.kinematics(mp.Task.pose()).manipulability(robot.neutral) == 0.0


def test_shapes_of_batches(panda, rng):
    kinematics = panda.kinematics(mp.Task.position())
    q = rng.uniform(-1, 1, (2, 3, 7))
    assert kinematics.pose(q).shape == (2, 3, 4, 4)
    assert kinematics.jacobian(q).shape == (2, 3, 3, 7)
    assert kinematics.manipulability(q).shape == (2, 3)
    assert kinematics.gradient(q).shape == (2, 3, 7)
    assert kinematics.hessian(q).shape == (2, 3, 7, 7)
    np.testing.assert_array_equal(kinematics.hessian(q)[1, 2], kinematics.hessian(q[1, 2]))
    assert kinematics.jacobian(np.empty((0, 7))).shape == (0, 3, 7)


@pytest.mark.parametrize("q", [np.zeros(6), [0.0] * 6 + [np.nan], [0.0] * 6 + [np.inf], "zeros", [None] * 7, 3.0])
def test_wrong_configurations(panda, q):
    with pytest.raises(mp.InvalidInputError, match="q: got"):
        panda.kinematics().manipulability(q)


def test_wrong_tasks(panda):
    with pytest.raises(mp.InvalidInputError, match="length"):
        mp.Task.pose(length=0.0)
    with pytest.raises(mp.InvalidInputError, match="axis"):
        mp.Task.pointing((0, 0, 0))
    with pytest.raises(mp.InvalidInputError, match="task"):
        panda.kinematics("pose")
    with pytest.raises(mp.UnknownNameError, match="chain"):
        panda.kinematics(backend="chian")


def test_ellipsoid_holds_the_singular_values(panda):
    jacobian = panda.kinematics(mp.Task.position()).jacobian(GOLDEN)
    ellipsoid = mp.velocity_ellipsoid(jacobian)
    np.testing.assert_allclose(
        ellipsoid.axes @ np.diag(ellipsoid.radii**2) @ ellipsoid.axes.T, jacobian @ jacobian.T, atol=1e-12
    )
    assert np.prod(ellipsoid.radii) == pytest.approx(0.1438, abs=5e-5)
