"""The gallery's page on MuJoCo: its model has Pinocchio's dynamics, and the exported motion can be followed."""

from pathlib import Path

import mujoco
import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp

PAGE = next((Path(__file__).parents[2] / "docs" / "examples").rglob("plot_mujoco_playback.py"))


@pytest.mark.slow
def test_mass_matrix_and_gravity_are_pinocchio_s(page, rng):
    model = page["model"]
    robot = mp.load_robot("panda", locked=dict.fromkeys(page["robot"].locked, 0.0))  # fingers closed, as the page fixes them
    data, theirs = robot.model.createData(), mujoco.MjData(model)
    for q in robot.random_configuration(rng, size=20):
        theirs.qpos[:], theirs.qvel[:] = q, rng.normal(size=robot.n)
        mujoco.mj_forward(model, theirs)
        pin.crba(robot.model, data, q)
        np.testing.assert_allclose(page["mass_matrix"](model, q), data.M, atol=1e-12)
        np.testing.assert_allclose(theirs.qfrc_bias, pin.rnea(robot.model, data, q, theirs.qvel, np.zeros(7)), atol=1e-10)
        np.testing.assert_allclose(theirs.qfrc_gravcomp, pin.computeGeneralizedGravity(robot.model, data, q), atol=1e-10)


@pytest.mark.slow
def test_the_torques_of_the_run_are_those_of_inverse_dynamics(page):
    """With feed-forward the arm is where the plan says, so its torques are Pinocchio's for the planned motion."""
    robot, plan = page["robot"], page["plan"]
    times, errors, torques = page["runs"]["optimised, with feed-forward"]
    data = robot.model.createData()
    at = times[50:-50:37]
    wanted = [pin.rnea(robot.model, data, *(plan.trajectory(t, order) for order in range(3))) for t in at]
    apart = np.abs(torques[50:-50:37] - wanted) / robot.limits.effort
    assert apart.max() < 0.05
    assert np.abs(errors).max() < 1e-3


@pytest.mark.slow
def test_errors_and_torques_stay_in_bounds(page):
    limits = page["robot"].limits
    for times, errors, torques in page["runs"].values():
        assert len(times) > 1000
        assert np.abs(errors).max() < 0.03
        assert (np.abs(torques) <= limits.effort).all()
