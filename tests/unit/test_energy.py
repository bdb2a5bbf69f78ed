"""Minima of the energy among fixed clearance rows: derivatives of the rows, and the same optimum as SciPy's."""

import numpy as np
import pytest
from scipy.optimize import minimize

import manipplan as mp
from manipplan.cost.integral import PathIntegral
from manipplan.optimize import clearance as near
from manipplan.optimize import program as programs
from manipplan.optimize.program import PathProgram
from manipplan.optimize.rows import FixedRows
from manipplan.paths.basis import find_basis

START, GOAL = np.array([-0.6, 0.3, 0.0, -2.0, 0.0, 2.3, 0.8]), np.array([0.9, 0.2, -0.2, -2.1, 0.3, 2.2, 0.8])
POST = mp.Box(size=(0.1, 0.1, 0.6), position=(0.55, 0.0, 0.3), name="post")
NONE = np.zeros((7, 5))


@pytest.fixture(scope="module")
def program(panda):
    return PathProgram(PathIntegral(kinematics=panda.kinematics(), power=1.0), find_basis("legendre", 6))


@pytest.fixture(scope="module")
def rows(panda, program):
    """Rows of the post at the dips of the seed."""
    scene = mp.Scene([POST])
    model = scene.collision_model(panda)
    seed = mp.seed_path(panda, START, GOAL, scene, clearance=0.01)
    profile = near.distance_profile(model, seed(np.linspace(0.0, 1.0, near.DISTANCE_INTERVALS + 1)), 0.05)
    places = near.around(near.dips(profile, 0.05))
    assert places
    return near.rows_for(model, program.basis.path(START, GOAL, NONE), seed, places, 0.01)


def test_fixed_rows_have_exact_derivatives(program, rows, rng):
    curves, _ = program._curves(START, GOAL, NONE)
    source = FixedRows.of(program.row_functions, curves, rows)

    def fixed(z):
        return source.at(curves, z, curves.curve(z))

    z = rng.uniform(-0.3, 0.3, (5, 7))
    multipliers = rng.uniform(0.0, 1.0, len(rows.s)) * (rng.random(len(rows.s)) < 0.7)
    linear, steps = fixed(z).linear, 1e-6 * np.eye(35)
    np.testing.assert_allclose(linear.value, fixed(z).value, atol=1e-15)

    def moved(f, k):
        return (f(z + steps[k].reshape(z.shape)) - f(z - steps[k].reshape(z.shape))) / 2e-6

    slopes = np.array([moved(lambda at: fixed(at).value, k) for k in range(35)]).T
    np.testing.assert_allclose(linear.jacobian, slopes, atol=1e-8)
    bends = np.array([moved(lambda at: multipliers @ fixed(at).linear.jacobian, k) for k in range(35)])
    np.testing.assert_allclose(fixed(z).curvature(multipliers), bends, atol=1e-7)
    assert fixed(z).violation == max(-fixed(z).value.min(), 0.0)


@pytest.mark.parametrize("with_rows", [False, True])
def test_the_descent_finds_the_minimum_of_slsqp(program, rows, monkeypatch, with_rows):
    chosen = rows if with_rows else None
    monkeypatch.setattr(programs, "SOLVED_SPACING", 2.0**-40)
    ours = program.solve(START, GOAL, NONE, 0.0, chosen)
    curves, z = program._curves(START, GOAL, ours.coefficients)
    least = program._energy(START, GOAL, ours.coefficients, 0.0)

    def energy(flat):
        return program._energy(START, GOAL, (curves.directions @ flat.reshape(z.shape)).T, 0.0) / least

    def values(flat):
        here = flat.reshape(z.shape)
        return FixedRows.of(program.row_functions, curves, rows).at(curves, here, curves.curve(here)).value

    constraints = [{"type": "ineq", "fun": values}] if with_rows else []
    other = minimize(energy, np.zeros(z.size), method="SLSQP", constraints=constraints, options={"ftol": 1e-12})
    assert ours.converged and other.success
    np.testing.assert_allclose(z.ravel(), other.x, atol=2e-3)
    assert other.fun == pytest.approx(1.0, rel=1e-5)
    if with_rows:
        assert abs(values(z.ravel()).min()) < 1e-6, "a row is active, and none is violated"
