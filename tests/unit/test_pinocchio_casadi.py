"""Pinocchio's own CasADi algorithms through the compiled bridge, against Pinocchio's numbers and our chain."""

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.robots.model_tree import frame_index
from manipplan.support.compiler import find_compiler
from manipplan.symbolic.backends import _bridge, bindings_installed

pytestmark = pytest.mark.slow  # the bridge is compiled for minutes the first time

ARMS = [*mp.available_robots(), "planar"]


def arm(name):
    return mp.planar_arm([1.0, 0.8, 0.6, 0.4]) if name == "planar" else mp.load_robot(name)


@pytest.mark.parametrize("name", ARMS)
def test_functions_equal_pinocchio(name, rng):
    robot = arm(name)
    functions = mp.pinocchio_casadi(robot, source="bridge")
    model, data, n = robot.model, robot.model.createData(), robot.n
    frame = frame_index(model, robot.tool)
    for _ in range(5):
        q = robot.random_configuration(rng)
        qd, qdd = rng.normal(size=(2, n))
        torque = pin.rnea(model, data, q, qd, qdd)
        upper = np.triu(pin.crba(model, data, q))
        mass = upper + np.triu(upper, 1).T
        scale = max(1.0, np.abs(torque).max())
        np.testing.assert_allclose(np.asarray(functions.mass_matrix(q)), mass, atol=1e-12 * max(1.0, np.abs(mass).max()))
        np.testing.assert_allclose(np.asarray(functions.rnea(q, qd, qdd)).ravel(), torque, atol=1e-12 * scale)
        np.testing.assert_allclose(np.asarray(functions.aba(q, qd, torque)).ravel(), qdd, atol=1e-7 * np.linalg.cond(mass))
        jacobian = pin.computeFrameJacobian(model, data, q, frame, pin.LOCAL_WORLD_ALIGNED)
        pin.framesForwardKinematics(model, data, q)
        np.testing.assert_allclose(np.asarray(functions.jacobian(q)), jacobian, atol=1e-12)
        np.testing.assert_allclose(np.asarray(functions.pose(q)), data.oMf[frame].homogeneous, atol=1e-12)


@pytest.mark.parametrize("name", ARMS)
def test_backends_agree(name, rng):
    robot = arm(name)
    task = mp.Task.pose(0.5) if robot.n >= 6 else robot.default_task
    ours, theirs = (robot.kinematics(task, backend=backend, compiled=False) for backend in ("chain", "bridge"))
    q = robot.random_configuration(rng, size=20)
    for quantity in ("pose", "jacobian", "manipulability", "mass_matrix"):
        left, right = getattr(ours, quantity)(q), getattr(theirs, quantity)(q)
        np.testing.assert_allclose(left, right, rtol=1e-12, atol=1e-12)
    for quantity in ("gradient", "hessian"):
        left, right = getattr(ours, quantity)(q), getattr(theirs, quantity)(q)
        np.testing.assert_allclose(left, right, rtol=1e-7, atol=1e-10)


def test_second_call_gives_the_same_object(panda):
    assert mp.pinocchio_casadi(panda, source="bridge") is mp.pinocchio_casadi(panda, source="bridge")


def test_functions_can_be_differentiated(panda):
    """What a symbolic scalar is for: the derivative of rnea with respect to qdd is the mass matrix."""
    functions = mp.pinocchio_casadi(panda, source="bridge")
    slope = functions.rnea.factory("slope", ["q", "qd", "qdd"], ["jac:tau:qdd"])
    q = panda.neutral
    np.testing.assert_allclose(np.asarray(slope(q, np.zeros(7), np.ones(7))), np.asarray(functions.mass_matrix(q)), atol=1e-12)


def test_no_cpp_compiler_is_told_with_the_line_that_installs_it(panda, monkeypatch):
    monkeypatch.setenv("CXX", "")
    find_compiler.cache_clear()
    _bridge.cache_clear()
    with pytest.raises(mp.errors.CompilerError, match="there is no C\\+\\+ compiler; install one with: "):
        mp.pinocchio_casadi(mp.planar_arm([1.0, 1.0]), source="bridge")
    monkeypatch.undo()
    find_compiler.cache_clear()


def test_wrong_arguments(panda):
    with pytest.raises(mp.errors.UnknownNameError, match="bridge"):
        mp.pinocchio_casadi(panda, source="brige")
    with pytest.raises(mp.errors.InvalidInputError, match="robot"):
        mp.pinocchio_casadi("panda")
    if not bindings_installed():
        with pytest.raises(mp.errors.InvalidInputError, match="has no pinocchio.casadi"):
            panda.kinematics(backend="bindings")
