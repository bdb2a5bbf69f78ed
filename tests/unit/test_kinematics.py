"""Kinematics against Pinocchio, finite differences and published numbers."""

import copy
import ctypes
import pickle
import threading

import casadi as ca
import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.robots.model_tree import frame_index

GOLDEN = [0.0, -0.3, 0.0, -2.2, 0.0, 2.0, np.pi / 4]


@pytest.mark.slow
@pytest.mark.parametrize("name", mp.available_robots())
def test_pose_jacobian_and_index_equal_pinocchio(name, rng):
    robot = mp.load_robot(name)
    kinematics = robot.kinematics(mp.Task.pose(length=1.0))
    frame = frame_index(robot.model, robot.tool)
    data = robot.model.createData()
    q = robot.random_configuration(rng, size=100)
    pose, jacobian = kinematics.pose(q), kinematics.jacobian(q)
    index = kinematics.manipulability(q) if robot.n >= 6 and len(robot.tools) == 1 else None
    for k in range(len(q)):
        oracle = pin.computeFrameJacobian(robot.model, data, q[k], frame, pin.LOCAL_WORLD_ALIGNED)
        pin.framesForwardKinematics(robot.model, data, q[k])
        np.testing.assert_allclose(pose[k], data.oMf[frame].homogeneous, rtol=0, atol=1e-12)
        np.testing.assert_allclose(jacobian[k], oracle, rtol=0, atol=1e-12)
        if index is not None:
            assert index[k] == pytest.approx(np.prod(np.linalg.svd(oracle)[1]), abs=1e-12)


def test_published_indices_of_the_panda(panda):
    """Numbers that the Robotics Toolbox for Python holds in its tests, for the same posture and frame."""
    assert panda.kinematics(mp.Task.pose(1.0)).manipulability(GOLDEN) == pytest.approx(0.0838, abs=5e-5)
    assert panda.kinematics(mp.Task.position()).manipulability(GOLDEN) == pytest.approx(0.1438, abs=5e-5)
    assert panda.kinematics(mp.Task.orientation()).manipulability(GOLDEN) == pytest.approx(2.7456, abs=5e-5)


ROWS = np.random.default_rng(4).normal(size=(4, 6))
TASKS = [
    mp.Task.pose(0.3),
    mp.Task.position(),
    mp.Task.orientation(),
    mp.Task.planar(),
    mp.Task.pointing((1, 2, 2)),
    mp.Task.direction((1, 2, 3)),
    mp.Task.direction((1, 2, 3), frame="tool"),
    mp.Task.rotation((0, 1, 1), frame="tool"),
    mp.Task.custom(ROWS, length=0.4, name="custom_world"),
    mp.Task.custom(ROWS, frame="tool", length=0.4, name="custom_tool"),
]


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


@pytest.mark.parametrize("quantity", ["manipulability", "gradient", "hessian"])
def test_fewer_joints_than_rows_is_identically_zero(quantity):
    robot = mp.load_robot("so100")
    kinematics = robot.kinematics(mp.Task.pose())
    with pytest.raises(mp.errors.InvalidInputError, match="yoshikawa.*6 rows and 5 joints it is identically zero"):
        getattr(kinematics, quantity)(robot.neutral)
    assert kinematics.jacobian(robot.neutral).shape == (6, 5)


def test_shapes_of_batches(panda, rng):
    kinematics = panda.kinematics(mp.Task.position())
    q = rng.uniform(-1, 1, (2, 3, 7))
    assert kinematics.pose(q).shape == (2, 3, 4, 4)
    assert kinematics.jacobian(q).shape == (2, 3, 3, 7)
    assert kinematics.manipulability(q).shape == (2, 3)
    assert kinematics.gradient(q).shape == (2, 3, 7)
    assert kinematics.hessian(q).shape == (2, 3, 7, 7)
    np.testing.assert_allclose(kinematics.hessian(q)[1, 2], kinematics.hessian(q[1, 2]), rtol=0, atol=1e-13)
    assert kinematics.jacobian(np.empty((0, 7))).shape == (0, 3, 7)


@pytest.mark.parametrize("q", [np.zeros(6), [0.0] * 6 + [np.nan], [0.0] * 6 + [np.inf], "zeros", [None] * 7, 3.0])
def test_wrong_configurations(panda, q):
    with pytest.raises(mp.errors.InvalidInputError, match="q: got"):
        panda.kinematics().manipulability(q)


def test_wrong_tasks(panda):
    with pytest.raises(mp.errors.InvalidInputError, match="length"):
        mp.Task.pose(length=0.0)
    with pytest.raises(mp.errors.InvalidInputError, match="axis"):
        mp.Task.pointing((0, 0, 0))
    with pytest.raises(mp.errors.InvalidInputError, match="task"):
        panda.kinematics("pose")
    with pytest.raises(mp.errors.UnknownNameError, match="chain"):
        panda.kinematics(backend="chian")
    with pytest.raises(mp.errors.UnknownNameError, match="world"):
        mp.Task.direction((1, 0, 0), frame="wrld")
    with pytest.raises(mp.errors.InvalidInputError, match="rows.*linearly independent"):
        mp.Task.custom([[1, 0, 0, 0, 0, 0], [2, 0, 0, 0, 0, 0]])
    with pytest.raises(mp.errors.InvalidInputError, match="compiled"):
        panda.kinematics(compiled="always")
    with pytest.raises(mp.errors.InvalidInputError, match="threads"):
        panda.kinematics(threads=0)
    with pytest.raises(mp.errors.UnknownNameError, match="gradient"):
        panda.kinematics().evaluator("gradiant")


def test_ellipsoid_holds_the_singular_values(panda):
    jacobian = panda.kinematics(mp.Task.position()).jacobian(GOLDEN)
    ellipsoid = mp.measures.velocity_ellipsoid(jacobian)
    np.testing.assert_allclose(
        ellipsoid.axes @ np.diag(ellipsoid.radii**2) @ ellipsoid.axes.T, jacobian @ jacobian.T, atol=1e-12
    )
    assert np.prod(ellipsoid.radii) == pytest.approx(0.1438, abs=5e-5)


@pytest.mark.parametrize("frame", ["world", "tool"])
def test_custom_rows_are_rows_of_the_jacobian_of_that_frame(panda, frame):
    kinematics = panda.kinematics(mp.Task.custom(ROWS, frame=frame, length=0.4))
    reference = pin.LOCAL_WORLD_ALIGNED if frame == "world" else pin.LOCAL
    data = panda.model.createData()
    oracle = pin.computeFrameJacobian(panda.model, data, np.array(GOLDEN), frame_index(panda.model, panda.tool), reference)
    oracle[3:] *= 0.4
    np.testing.assert_allclose(kinematics.jacobian(GOLDEN), ROWS @ oracle, atol=1e-14)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["panda", "ur5", "tiago", "talos_torso_right_arm", "kinova"])
def test_mass_matrix_equals_pinocchio(name, rng):
    robot = mp.load_robot(name)
    data = robot.model.createData()
    q = robot.random_configuration(rng, size=5)
    for each, mass in zip(q, robot.kinematics().mass_matrix(q), strict=True):
        upper = np.triu(pin.crba(robot.model, data, each))
        np.testing.assert_allclose(mass, upper + np.triu(upper, 1).T, atol=1e-12)


def oracle_gradient(robot, q):
    """(18) in dufour2020, with Pinocchio's kinematic Hessian, whose memory holds ∂J_ij/∂q_k column by column."""
    model, data, frame = robot.model, robot.model.createData(), frame_index(robot.model, robot.tool)
    pin.computeJointJacobians(model, data, q)
    pin.computeJointKinematicHessians(model, data)
    pin.updateFramePlacement(model, data, frame)
    jacobian = pin.getFrameJacobian(model, data, frame, pin.LOCAL_WORLD_ALIGNED)
    hessian = pin.getFrameKinematicHessian(model, data, frame, pin.LOCAL_WORLD_ALIGNED)
    derivative = hessian.ravel().reshape((6, robot.n, robot.n), order="F")
    inverse = np.linalg.inv(jacobian @ jacobian.T)
    m = np.sqrt(np.linalg.det(jacobian @ jacobian.T))
    return m * np.array([np.trace(inverse @ derivative[:, :, k] @ jacobian.T) for k in range(robot.n)])


@pytest.mark.slow
@pytest.mark.parametrize("name", ["panda", "xarm7", "baxter_left", "talos_torso_right_arm", "ur10"])
def test_gradient_and_hessian_equal_the_papers(name, rng):
    """(18) to rounding, (17) and (19) to the error of their differences."""
    robot = mp.load_robot(name)
    kinematics = robot.kinematics(mp.Task.pose(1.0))
    step = 1e-4
    for q in robot.random_configuration(rng, size=5):
        gradient, hessian = kinematics.gradient(q), kinematics.hessian(q)
        np.testing.assert_allclose(gradient, oracle_gradient(robot, q), rtol=1e-7, atol=1e-12)
        moves = step * np.eye(robot.n)

        def by_17(at, moves=moves):
            return (kinematics.manipulability(at + moves) - kinematics.manipulability(at - moves)) / (2 * step)

        by_19 = np.array([(by_17(q + move) - by_17(q - move)) / (2 * step) for move in moves])
        np.testing.assert_allclose(gradient, by_17(q), atol=1e-6)
        np.testing.assert_allclose(hessian, by_19, atol=1e-5 * max(1.0, np.abs(hessian).max()))


@pytest.mark.parametrize("task", TASKS, ids=lambda task: task.name)
def test_derivatives_equal_automatic_differentiation(panda, task, rng):
    symbolic = panda.kinematics(task).symbolic
    q = symbolic.chain.q
    jacobian = symbolic.posture.jacobian
    index = ca.sqrt(ca.det(jacobian @ jacobian.T))
    hessian, gradient = ca.hessian(index, q)
    automatic = ca.Function("automatic", [q], [gradient, hessian])
    for at in panda.random_configuration(rng, size=5):
        slope, bend = (np.asarray(each) for each in automatic(at))
        np.testing.assert_allclose(symbolic.gradient(at), slope, rtol=1e-6, atol=1e-10)
        np.testing.assert_allclose(symbolic.hessian(at), bend, rtol=1e-6, atol=1e-8)


@pytest.mark.parametrize("compiled", [pytest.param(True, marks=pytest.mark.compiler), False])
def test_derivatives_are_finite_on_a_singularity(compiled):
    """A stretched planar arm, and a UR5 with its wrist straight."""
    planar = mp.planar_arm([1.0, 1.0, 1.0])
    ur5 = mp.load_robot("ur5")
    for robot, q in ((planar, [0.4, 0.0, 0.0]), (ur5, [0.3, -1.0, 1.0, 0.5, 0.0, 0.2])):
        kinematics = robot.kinematics(compiled=compiled)
        assert kinematics.manipulability(q) == pytest.approx(0.0, abs=1e-15)
        assert np.isfinite(kinematics.gradient(q)).all()
        assert np.isfinite(kinematics.hessian(q)).all()


def test_a_larger_regularisation_smooths_the_kink(planar):
    """With ρ the curvature across a singularity is that of sqrt(q² + ρ²): proportional to 1/ρ."""
    bends = [
        np.abs(planar.kinematics(measure=mp.measures.Yoshikawa(regularisation=rho)).hessian([0.4, 0.0, 0.0])).max()
        for rho in (1e-3, 1e-2)
    ]
    assert bends[0] == pytest.approx(10 * bends[1], rel=1e-3)


@pytest.mark.parametrize("compiled", [pytest.param(True, marks=pytest.mark.compiler), False])
def test_evaluator_gives_the_same_as_the_methods(panda, compiled, rng):
    kinematics = panda.kinematics(mp.Task.pose(), compiled=compiled)
    names = ("pose", "jacobian", "manipulability", "gradient", "hessian")
    evaluate = kinematics.evaluator(*names)
    for q in panda.random_configuration(rng, size=3):
        for name, value in zip(names, evaluate(q), strict=True):
            np.testing.assert_allclose(value, getattr(kinematics, name)(q), rtol=1e-12, atol=1e-13)
    np.testing.assert_array_equal(evaluate(list(q))[1], evaluate(q.astype(np.float64))[1])
    assert evaluate(q)[1] is evaluate(np.zeros(7))[1]  # a view that the next call overwrites
    assert kinematics.jacobian(q) is not kinematics.jacobian(q)
    for wrong in (np.zeros(6), np.zeros((1, 7)), np.full(7, np.nan), np.r_[np.zeros(6), np.inf], "zeros", 1.0, None):
        with pytest.raises(mp.errors.InvalidInputError, match="q: got"):
            evaluate(wrong)


def test_threads_that_share_kinematics_get_their_own_results(panda, rng):
    kinematics = panda.kinematics()
    q = panda.random_configuration(rng, size=4)
    wanted = kinematics.jacobian(q)
    wrong = np.zeros(4)

    def work(i):
        for _ in range(2000):
            wrong[i] += np.abs(kinematics.jacobian(q[i]) - wanted[i]).max() > 1e-9

    threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong.any()


def test_kinematics_survive_pickle_and_copy(panda):
    kinematics = panda.kinematics(mp.Task.position(), measure="isotropy")
    for again in (pickle.loads(pickle.dumps(kinematics)), copy.deepcopy(kinematics)):
        assert again.manipulability(GOLDEN) == kinematics.manipulability(GOLDEN)
        assert again.measure == kinematics.measure


def test_a_continuous_joint_about_any_axis(tmp_path):
    file = tmp_path / "one.urdf"
    file.write_text(
        '<robot name="one"><link name="base"/><link name="tip"/><joint name="j" type="continuous"><parent link="base"/>'
        '<child link="tip"/><axis xyz="0.6 0.8 0"/><limit effort="1" velocity="1"/></joint></robot>'
    )
    robot = mp.Robot.from_urdf(file)
    np.testing.assert_allclose(robot.kinematics(mp.Task.orientation()).jacobian([0.3])[:, 0], [0.6, 0.8, 0.0], atol=1e-15)


def test_doubles_of_another_buffer_format_are_taken(panda):
    q = np.ctypeslib.as_array((ctypes.c_double * 7)(*GOLDEN))
    np.testing.assert_array_equal(panda.kinematics().pose(q), panda.kinematics().pose(GOLDEN))
