"""The quasi-Newton updates of the study of dufour2020, as control steps make them."""

import numpy as np
import pytest

import manipplan as mp
from studies.dufour2020.quasi_newton import QuasiNewton

GOLDEN = np.array([0.0, -0.3, 0.0, -2.2, 0.0, 2.0, np.pi / 4])


def controller(robot, update, **options):
    return mp.Controller(robot, QuasiNewton(1.0, update), dt=0.01, compiled=False, **options)


def learn(of, positions):
    """H_m after each position, from the memory of a step, and ∇m there."""
    memory, n, found = np.zeros(of.symbolic.nnz_in("memory")), of.robot.n, []
    for q in positions:
        rest = (np.zeros(n), np.zeros(n), np.eye(4), 1e4, 1.0, np.full(2, 1e12), np.zeros(0))
        memory = np.array(of.symbolic(q, *rest, memory)[2]).ravel()
        found.append((memory[: n * n].reshape(n, n), memory[n * n : n * n + n]))
    return found


def walk(rng, size=0.02):
    return GOLDEN + np.cumsum(size * rng.normal(size=(8, 7)), axis=0)


def test_bfgs_stays_negative_semidefinite(panda, rng):
    of = controller(panda, "bfgs")
    steps = learn(of, walk(rng))
    assert not steps[0][0].any()
    for hessian, _ in steps[1:]:
        assert np.abs(hessian).max() > 0.01
        assert np.linalg.eigvalsh(hessian)[-1] <= 1e-12 * np.abs(hessian).max()


def test_bfgs_satisfies_the_secant_equation_where_the_manipulability_is_concave_enough(panda, rng):
    """Undamped, H_m s = y; elsewhere Powell's damping gives way."""
    of = controller(panda, "bfgs")
    positions = walk(rng)
    steps = learn(of, positions)
    undamped = 0
    for k in range(1, len(steps)):
        s, y = positions[k] - positions[k - 1], steps[k][1] - steps[k - 1][1]
        before = steps[k - 1][0] if k > 1 else -np.linalg.norm(y) / np.linalg.norm(s) * np.eye(7)
        if -s @ y >= 0.2 * (-s @ before @ s):
            undamped += 1
            np.testing.assert_allclose(steps[k][0] @ s, y, atol=1e-10)
    assert undamped >= 2


def test_sr1_satisfies_the_secant_equation(panda, rng):
    of = controller(panda, "sr1")
    positions = walk(rng)
    steps = learn(of, positions)
    for k in range(1, len(steps)):
        np.testing.assert_allclose(steps[k][0] @ (positions[k] - positions[k - 1]), steps[k][1] - steps[k - 1][1], atol=1e-10)


def test_sr1_learns_a_constant_hessian_exactly():
    """After n independent steps; the manipulability of two links is sin, so each step is small beside its curvature."""
    arm = mp.planar_arm([1.0, 1.0, 1.0])
    of = controller(arm, "sr1", task=mp.Task.planar())
    q = np.array([0.3, 0.8, 0.7])
    positions = [q, *(q + 1e-5 * (np.arange(3) <= k) for k in range(3))]
    found = [h for h, _ in learn(of, positions)][-1]
    np.testing.assert_allclose(found, arm.kinematics(mp.Task.planar()).hessian(q), atol=1e-3)


def test_literal_bfgs_is_formula_20(panda, rng):
    """H ← (I - ρ s yᵀ) H (I - ρ y sᵀ) + ρ s sᵀ, from the identity, as printed."""
    of = controller(panda, "bfgs-literal")
    positions = walk(rng)
    steps = learn(of, positions)
    expected = np.eye(7)
    for k in range(1, len(steps)):
        s, y = positions[k] - positions[k - 1], steps[k][1] - steps[k - 1][1]
        rho = 1 / (y @ s)
        left = np.eye(7) - rho * np.outer(s, y)
        expected = left @ expected @ left.T + rho * np.outer(s, s)
        np.testing.assert_allclose(steps[k][0], expected, atol=1e-9 * np.abs(expected).max())


@pytest.mark.parametrize("update", ["bfgs", "sr1", "bfgs-literal"])
def test_what_was_learned_is_kept_while_the_arm_rests(panda, rng, update):
    of = controller(panda, update)
    positions = walk(rng)
    steps = learn(of, [*positions, positions[-1]])
    assert steps[-2][0].any()
    np.testing.assert_array_equal(steps[-1][0], steps[-2][0])
