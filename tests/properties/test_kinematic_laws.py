"""Laws of kinematics and indices on random chains of two to nine revolute and prismatic joints."""

import numpy as np
import pinocchio as pin
import pytest
from chains import chain, joint_values, kinds, placements, seeds
from examples import examples
from hypothesis import given
from hypothesis import strategies as st

import manipplan as mp

POSE = mp.Task.pose(0.5)
few = examples(30)


def kinematics(robot, task=POSE, **options):
    return robot.kinematics(task, compiled=False, **options)


@pytest.mark.slow
@few
@given(seeds, kinds(2), st.data())
def test_pose_and_jacobian_equal_pinocchio(seed, prismatic, data):
    robot = chain(seed, prismatic)
    q = data.draw(joint_values(robot.n))
    work, frame = robot.model.createData(), robot.model.getFrameId("tool")
    oracle = pin.computeFrameJacobian(robot.model, work, q, frame, pin.LOCAL_WORLD_ALIGNED)
    pin.framesForwardKinematics(robot.model, work, q)
    ours = kinematics(robot, mp.Task.pose(1.0))
    np.testing.assert_allclose(ours.jacobian(q), oracle, atol=1e-12)
    np.testing.assert_allclose(ours.pose(q), work.oMf[frame].homogeneous, atol=1e-12)
    upper = np.triu(pin.crba(robot.model, work, q))
    np.testing.assert_allclose(ours.mass_matrix(q), upper + np.triu(upper, 1).T, atol=1e-11 * max(1.0, np.abs(upper).max()))


@pytest.mark.slow
@few
@given(seeds, kinds(6), placements(), st.sampled_from([POSE, mp.Task.position(), mp.Task.orientation()]), st.data())
def test_manipulability_does_not_depend_on_where_the_base_stands(seed, prismatic, base, task, data):
    there, here = chain(seed, prismatic, base=base), chain(seed, prismatic)
    q = data.draw(joint_values(here.n))
    np.testing.assert_allclose(
        kinematics(there, task).manipulability(q), kinematics(here, task).manipulability(q), rtol=1e-8, atol=1e-12
    )


@pytest.mark.parametrize("backend", ["chain", pytest.param("bridge", marks=pytest.mark.slow)])
@few
@given(seeds, kinds(6), placements(), st.data())
def test_pose_manipulability_does_not_depend_on_the_tool_offset(backend, seed, prismatic, tool, data):
    longer, plain = chain(seed, prismatic, tool=tool), chain(seed, prismatic)
    q = data.draw(joint_values(plain.n))
    expected = kinematics(plain).manipulability(q)
    np.testing.assert_allclose(kinematics(longer, backend=backend).manipulability(q), expected, rtol=1e-7, atol=1e-11)


@few
@given(seeds, st.integers(3, 8), st.floats(0.1, 10.0), st.data())
def test_position_index_scales_with_the_cube_of_the_lengths(seed, n, factor, data):
    small, large = chain(seed, [False] * n), chain(seed, [False] * n, scale=factor)
    q = data.draw(joint_values(n))
    position = mp.Task.position()
    expected = factor**3 * kinematics(small, position).manipulability(q)
    np.testing.assert_allclose(kinematics(large, position).manipulability(q), expected, rtol=1e-8, atol=1e-12)


@pytest.mark.slow
@few
@given(seeds, kinds(6), st.data())
def test_manipulability_lies_between_powers_of_the_singular_values(seed, prismatic, data):
    robot = chain(seed, prismatic)
    q = data.draw(joint_values(robot.n))
    ours = kinematics(robot)
    sigma = np.linalg.svd(ours.jacobian(q), compute_uv=False)
    index = ours.manipulability(q)
    assert sigma[-1] ** 6 * (1 - 1e-9) - 1e-12 <= index <= sigma[0] ** 6 * (1 + 1e-9)
    np.testing.assert_allclose(index, sigma.prod(), rtol=1e-8, atol=1e-12)
    np.testing.assert_allclose(kinematics(robot, measure="smallest_singular_value").manipulability(q), sigma[-1], atol=1e-12)


@pytest.mark.slow
@few
@given(seeds, st.integers(6, 9), st.data())
def test_manipulability_is_zero_when_rank_drops(seed, n, data):
    """With more than three sliding joints the others cannot turn the tool in all directions."""
    robot = chain(seed, [False, False] + [True] * (n - 2))
    q = data.draw(joint_values(n))
    ours = kinematics(robot)
    assert np.linalg.matrix_rank(ours.jacobian(q)) < 6
    assert ours.manipulability(q) == pytest.approx(0.0, abs=1e-14)
    assert np.isfinite(ours.gradient(q)).all()
    assert np.isfinite(ours.hessian(q)).all()


@pytest.mark.slow
@few
@given(seeds, kinds(3), st.lists(st.integers(0, 5), min_size=1, max_size=6, unique=True), st.data())
def test_rows_of_a_task_are_rows_of_the_jacobian(seed, prismatic, chosen, data):
    robot = chain(seed, prismatic)
    q = data.draw(joint_values(robot.n))
    rows = np.eye(6)[chosen]
    full = kinematics(robot, mp.Task.pose(1.0)).jacobian(q)
    part = kinematics(robot, mp.Task.custom(rows)).jacobian(q)
    np.testing.assert_allclose(part, full[chosen], atol=1e-14)


@pytest.mark.slow
@few
@given(seeds, kinds(6), st.sampled_from([POSE, mp.Task.pointing(), mp.Task.position()]), st.data())
def test_derivatives_on_random_chains(seed, prismatic, task, data):
    """Against central differences, where the index is not next to its kink at zero."""
    robot = chain(seed, prismatic)
    q = data.draw(joint_values(robot.n))
    ours = kinematics(robot, task)
    step = 1e-5
    moves = step * np.eye(robot.n)
    values = ours.manipulability(np.concatenate([q + moves, q - moves]))
    sigma = np.linalg.svd(ours.jacobian(q), compute_uv=False)
    if sigma[-1] < 0.02 * sigma[0]:
        return
    slope = (values[: robot.n] - values[robot.n :]) / (2 * step)
    np.testing.assert_allclose(ours.gradient(q), slope, atol=1e-6 * max(np.abs(slope).max(), float(values.max())))
    slopes = ours.gradient(np.concatenate([q + moves, q - moves]))
    bend = (slopes[: robot.n] - slopes[robot.n :]) / (2 * step)
    np.testing.assert_allclose(ours.hessian(q), bend, atol=1e-5 * max(np.abs(bend).max(), float(values.max())))


@pytest.mark.slow
@few
@given(seeds, kinds(2, 7), st.data())
def test_backends_agree(seed, prismatic, data):
    robot = chain(seed, prismatic)
    q = data.draw(joint_values(robot.n))
    task = mp.Task.pose(1.0)
    left, right = kinematics(robot, task), kinematics(robot, task, backend="bridge")
    np.testing.assert_allclose(left.jacobian(q), right.jacobian(q), atol=1e-12)
    np.testing.assert_allclose(left.pose(q), right.pose(q), atol=1e-12)


@pytest.mark.slow
@examples(5)
@given(seeds, kinds(6), st.data())
def test_batch_equals_single_in_machine_code(seed, prismatic, data):
    robot = chain(seed, prismatic)
    q = np.array([data.draw(joint_values(robot.n)) for _ in range(3)])
    fast, slow = robot.kinematics(POSE, compiled=True), kinematics(robot)
    for quantity in ("pose", "jacobian", "manipulability", "gradient"):
        expected = np.array([getattr(slow, quantity)(each) for each in q])
        scale = max(1.0, np.abs(expected).max())
        np.testing.assert_allclose(getattr(fast, quantity)(q), expected, atol=1e-9 * scale)
