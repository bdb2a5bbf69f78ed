"""Machine code of the path program, exact derivatives of what it minimises, and g where dips of the index are narrow."""

import subprocess
import sys

import casadi as ca
import numpy as np
import pytest

import manipplan as mp
from manipplan.cost.integral import PathIntegral
from manipplan.cost.objective import ENERGY_REGULARISATION, energy_density, length_density
from manipplan.kinematics.kinematics import steady
from manipplan.optimize.clearance import row_functions
from manipplan.symbolic import machine_code

START, GOAL = [0.0, 1.5, -2.0], [np.pi, -2.0, 2.0]


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.setenv("MANIPPLAN_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


def points(robot, rng, count=20):
    """Random q, v, and [g0, p, floor] as columns."""
    q = robot.random_configuration(rng, size=count).T
    return (
        q,
        rng.normal(size=q.shape),
        np.array([rng.uniform(1, 5, count), rng.uniform(0.5, 3, count), rng.choice([0.0, 0.01], count)]),
    )


@pytest.mark.slow
@pytest.mark.compiler
@pytest.mark.parametrize("density", [energy_density, length_density])
@pytest.mark.parametrize("name", ["panda", "ur5"])
def test_machine_code_equals_the_virtual_machine(density, name, rng):
    robot = mp.load_robot(name)
    at = points(robot, rng)
    fast, slow = (
        density(PathIntegral(kinematics=robot.kinematics(compiled=compiled), power=1.0)).functions for compiled in (True, False)
    )
    for one, other in zip(fast, slow, strict=True):  # bit by bit, so that it does not matter when it is built
        np.testing.assert_array_equal(np.array(one(*at)), np.array(other(*at)))


@pytest.mark.slow
@pytest.mark.compiler
def test_rows_in_machine_code_equal_the_virtual_machine(panda, rng):
    fast, slow = (row_functions(panda.kinematics(compiled=compiled)).functions for compiled in (True, False))
    for _ in range(10):
        column = np.concatenate([np.eye(8)[rng.integers(8)], np.eye(8)[rng.integers(8)], rng.normal(size=8)])
        q = panda.random_configuration(rng)
        for one, other in zip(fast, slow, strict=True):
            np.testing.assert_array_equal(np.array(one(q, column)), np.array(other(q, column)))


@pytest.mark.slow
@pytest.mark.compiler
def test_machine_code_is_built_once_it_pays_off(panda, folder, rng, monkeypatch):
    """With the same numbers before and after, and at once in another process."""
    monkeypatch.setattr(machine_code, "PAYS_OFF", 1e5)
    integral = PathIntegral(kinematics=panda.kinematics(), power=1.0)
    coded = energy_density(integral)
    q, v, numbers = (each.T.copy() for each in points(panda, rng, count=8))
    derivatives = coded.batches()[2]
    first = derivatives(q, v, numbers)
    assert not list(folder.glob("*.so"))
    for _ in range(10):
        np.testing.assert_array_equal(derivatives(q, v, numbers), first)
    assert len(list(folder.glob("*.so"))) == 1 and derivatives._pending is None
    value = coded.batches()[0]
    value(q, v, numbers)
    assert value._pending is None and len(list(folder.glob("*.so"))) == 1
    assert energy_density(integral).pending is None


def test_a_compiler_that_fails_later_is_reported_once(panda, folder, rng, monkeypatch):
    monkeypatch.setattr(machine_code, "PAYS_OFF", 0.0)
    coded = machine_code.CodedFunctions(
        functions=(panda.kinematics().symbolic.manipulability,),
        pending=machine_code.PendingCode([panda.kinematics().symbolic.manipulability], "a test"),
    )

    def fails(functions, subject):
        raise mp.errors.CompilerError(subject, "out of ideas")

    monkeypatch.setattr(machine_code, "compile_together", fails)
    monkeypatch.setattr(machine_code, "first_failure", lambda: True)
    (batch,) = coded.batches()
    q = panda.random_configuration(rng, size=3)
    with pytest.warns(mp.errors.CompilerWarning, match="out of ideas"):
        found = batch(q)
    np.testing.assert_array_equal(batch(q), found)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["panda", "ur5", "xarm7", "planar", "tiago"])
def test_the_density_is_speed_over_index(name, planar, rng):
    """Against Pinocchio's Jacobian: the middle view has the index of the tool's."""
    import pinocchio as pin

    robot = planar if name == "planar" else mp.load_robot(name)
    kinematics = robot.kinematics(mp.Task.planar() if name == "planar" else mp.Task.pose(length=0.5), compiled=False)
    energy, *_ = energy_density(PathIntegral(kinematics=kinematics, power=1.0)).functions
    rows = np.array([1, 1, 1, 0.5, 0.5, 0.5])
    data = robot.model.createData()
    for q, v in zip(robot.random_configuration(rng, size=20), rng.normal(size=(20, robot.n)), strict=True):
        if name == "planar":
            index = kinematics.manipulability(q)
        else:
            if robot.model.nq != robot.n:
                pytest.skip("angles stored otherwise")
            frame = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
            jacobian = pin.computeFrameJacobian(robot.model, data, q, robot.model.getFrameId(robot.tool), frame)
            index = np.prod(np.linalg.svd(rows[:, None] * jacobian, compute_uv=False))
        if index > 1e-3:
            assert float(energy(q, v, [1.0, 1.0, 0.0])) == pytest.approx(v @ v / index**2, rel=1e-5)


def test_the_steady_view_has_true_derivatives(panda, rng):
    """Also with a ρ that matters: by CasADi's own differentiation."""
    from manipplan.symbolic.motion import Factor, log_gradient, log_hessian

    chain = panda.kinematics().symbolic.chain
    jacobian, motion = steady(chain, mp.Task.pose(length=0.5))
    factor = Factor.of(jacobian, 1e3 * ENERGY_REGULARISATION)
    bend, slope = ca.hessian(ca.log(factor.manipulability), chain.q)
    error = ca.Function("error", [chain.q], [slope - log_gradient(factor, motion), bend - log_hessian(factor, motion)])
    for q in panda.random_configuration(rng, size=10):
        for each in error(q):
            np.testing.assert_allclose(each, 0.0, atol=1e-8)


@pytest.mark.slow
@pytest.mark.compiler
def test_paths_are_the_same_compiled_or_not(panda, rng):
    start, goal = panda.random_configuration(rng, size=2)
    fast, slow = (
        mp.optimize_path(panda, start, goal, shape=mp.PathShape(degree=5), compiled=compiled) for compiled in (True, False)
    )
    assert fast.status is mp.Status.OPTIMAL
    assert fast.g == pytest.approx(slow.g, rel=1e-9)
    assert fast.g < 0.99 * fast.seed_cost.g
    np.testing.assert_allclose(fast.path.control, slow.path.control, atol=5e-3)  # g is flat along re-parametrisations


@pytest.mark.usefixtures("no_compiler", "folder")
def test_without_a_compiler():
    arm = mp.planar_arm([1.0, 1.0, 1.0])
    assert mp.optimize_path(arm, START, GOAL, objective=mp.PathObjective(power=2)).status is mp.Status.OPTIMAL
    with pytest.raises(mp.errors.CompilerError, match="there is no C compiler; install one with: "):
        mp.optimize_path(arm, START, GOAL, objective=mp.PathObjective(power=2), compiled=True)


def test_compiled_has_to_be_known(planar):
    with pytest.raises(mp.errors.InvalidInputError, match="compiled.*'auto', True or False"):
        mp.optimize_path(planar, START, GOAL, compiled="yes")


@pytest.mark.slow
@pytest.mark.compiler
def test_a_second_process_and_another_power_and_degree_find_the_library(folder):
    code = (
        "import manipplan as mp; arm = mp.planar_arm([1.0, 1.0, 1.0]);"
        "shape, objective = mp.PathShape(degree={}), mp.PathObjective(power={});"
        "ends = [0.0, 1.5, -2.0], [3.1, -2.0, 2.0];"
        "print(mp.optimize_path(arm, *ends, shape=shape, objective=objective, compiled=True).g)"
    )

    def files_after(degree, power):
        subprocess.run([sys.executable, "-c", code.format(degree, power)], capture_output=True, check=True)
        return {each: each.stat().st_mtime_ns for each in folder.iterdir()}

    before = files_after(4, 1)
    assert before
    assert files_after(6, 2) == before


def test_g_sees_a_dip_that_gauss_points_pass_by():
    """The two-link arm's index is |sin q2|: past the stretched arm at a distance e, g = ∫ ds / (sin²(...))^(1/2) is known."""
    arm = mp.planar_arm([1.0, 1.0])
    path = mp.JointPath.line([0.0, 1e-7], [0.0, 1.0])
    exact = np.log(np.tan(0.5)) - np.log(np.tan(0.5e-7))  # ∫ dq / sin q
    assert mp.path_cost(path, arm.kinematics(mp.Task.planar()), 1.0).g == pytest.approx(exact, rel=1e-9)


@pytest.mark.slow
def test_a_polish_believes_no_coarse_rule(panda):
    """Pairs of the thousand on which a rule of 120 points let the path through a dip that it did not see."""
    rng = np.random.default_rng(2012)
    pairs = [panda.random_configuration(rng, size=2) for _ in range(81)]
    for k in (20, 80):
        result = mp.optimize_path(panda, *pairs[k], shape=mp.PathShape(degree=5), objective=mp.PathObjective(floor=0.0))
        s, weights = result.path.quadrature(panels=4000)
        plain = weights @ (np.linalg.norm(result.path(s, 1), axis=1) / panda.kinematics().manipulability(result.path(s)))
        assert result.g == pytest.approx(plain, rel=1e-6)
        assert result.g < 0.999 * result.history[0].g
