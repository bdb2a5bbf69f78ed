"""Compiled evaluation of paths, and of integrals along them, against NumPy: bit by bit where both do the same operations."""

import copy
import pickle
from dataclasses import replace

import numpy as np
import pytest
from examples import examples
from hypothesis import given
from hypothesis import strategies as st
from numpy.polynomial import Polynomial

import manipplan as mp
from manipplan.cost import integral as integrals
from manipplan.cost import integral as panels
from manipplan.cost.integral import PathIntegral
from manipplan.paths import joint as curves
from manipplan.paths.basis import find_basis
from manipplan.paths.joint import MOST_DEGREE, Curve, JointPath, bernstein
from manipplan.support.kernels import kernel_by_llvm


def some_path(rng, pieces, degree, n):
    basis = find_basis("bspline" if pieces > 1 else "legendre", degree, pieces)
    start, goal = rng.uniform(-2.5, 2.5, (2, n))
    return basis.path(start, goal, rng.uniform(-2, 2, (n, basis.size)))


@pytest.fixture(params=["compiler", "llvm"])
def compiled(request, monkeypatch):
    if request.param == "llvm":
        found = {name: kernel_by_llvm(name) for name in ("curves", "panels")}
        calls, curve = found["panels"].functions(), found["curves"].functions(quick=("curve",))["curve"]
        monkeypatch.setattr(curves, "_call", lambda: curve)
        monkeypatch.setattr(panels, "_calls", lambda: calls)
        monkeypatch.setattr(panels, "load_kernel", found.get)
    return request.param


@pytest.mark.parametrize(("pieces", "degree", "n"), [(1, 1, 6), (1, 6, 7), (4, 5, 6), (8, 3, 2), (1, 20, 1), (32, 2, 9)])
def test_curves_are_the_same_by_numpy(compiled, rng, pieces, degree, n):
    path = some_path(rng, pieces, degree, n)
    s = np.concatenate([rng.random(300), path.breaks, np.nextafter(path.breaks, 0.5)])
    for order in range(degree + 2):
        curve = path.curve(order)
        assert curve.address
        for spacing in (0.0, 2.0**-36):
            np.testing.assert_array_equal(curve(s, spacing), curve._by_numpy(s, spacing))
        np.testing.assert_array_equal(path(s.reshape(-1, 1), order)[:, 0], path(s, order))
        np.testing.assert_array_equal(path(float(s[0]), order), path(s, order)[0])
    assert not path(s, degree + 1).any()


@examples(30, derandomize=True)
@given(seed=st.integers(0, 2**32 - 1), pieces=st.integers(1, 5), degree=st.integers(1, 12))
def test_curves_are_their_polynomials(seed, pieces, degree):
    """Against NumPy's polynomials through the control points' Bernstein basis, with uneven breaks."""
    rng = np.random.default_rng(seed)
    breaks = np.append(0.0, np.cumsum(rng.uniform(0.1, 1.0, pieces)))
    breaks /= breaks[-1]
    control = rng.standard_normal((pieces, degree + 1, 2))
    control[1:, 0] = control[:-1, -1]
    path = JointPath(breaks=breaks, control=control)
    low = Polynomial([0.0, 1.0])
    terms = [low**j * (1 - low) ** (degree - j) * curves._binomials(degree)[j] for j in range(degree + 1)]
    for piece in range(pieces):
        a, b = breaks[piece : piece + 2]
        u = rng.random(5) * 0.999
        for joint in range(2):
            whole = sum(c * term for c, term in zip(control[piece, :, joint], terms, strict=True))
            np.testing.assert_allclose(path(a + u * (b - a))[:, joint], whole(u), rtol=1e-6, atol=1e-6)
            slope = whole.deriv()(u) / (b - a)
            np.testing.assert_allclose(path(a + u * (b - a), 1)[:, joint], slope, rtol=1e-5, atol=1e-5 / (b - a))


def test_powers_are_products():
    """Not those of the C library, which differ in the last bit between processors."""
    u = np.array([0.1, 0.7, 1 / 3])
    expected = [[(1 - x) * (1 - x), 2 * x * (1 - x), x * x] for x in u]
    np.testing.assert_array_equal(bernstein(2, u), expected)
    np.testing.assert_allclose(bernstein(MOST_DEGREE, u).sum(axis=1), 1.0, rtol=1e-14)


def test_curves_of_high_degree(rng):
    control = np.repeat(rng.standard_normal((1, 1, 3)), MOST_DEGREE + 2, axis=1)
    curve = Curve(np.array([0.0, 1.0]), control)
    assert curve.address == 0
    np.testing.assert_allclose(curve(rng.random(20)), control[0, :20], rtol=1e-12)


@pytest.mark.parametrize("degree", [3, MOST_DEGREE + 1])
def test_parameters_outside_the_path_are_refused(rng, degree):
    path = some_path(rng, 1, degree, 2)
    for s in (-1e-9, [0.5, 1.0000001], np.array([[0.2, np.nan]]), np.inf):
        with pytest.raises(mp.errors.InvalidInputError, match="s: got"):
            path(s)
    for order in (-1, 1.5, True, "1"):
        with pytest.raises(mp.errors.InvalidInputError, match="order"):
            path(0.5, order)
    assert path(np.empty((0, 3))).shape == (0, 3, 2)


def test_a_path_that_was_evaluated_can_be_copied(rng):
    path = some_path(rng, 4, 5, 6)
    values = path(0.3), path(0.3, 1)
    for other in (pickle.loads(pickle.dumps(path)), copy.deepcopy(path)):
        assert other.curve().address != path.curve().address
        np.testing.assert_array_equal((other(0.3), other(0.3, 1)), values)


def by_numpy(monkeypatch, call, *arguments):
    """What a function returns without compiled integrals."""
    with monkeypatch.context() as context:
        context.setattr(integrals.Panels, "of", lambda *_: None)
        return call(*arguments)


@pytest.mark.compiler
@pytest.mark.parametrize("name", ["panda", "ur5"])
@pytest.mark.parametrize("power", [1, 2.0])
def test_integrals_are_the_same_by_numpy(request, compiled, rng, monkeypatch, name, power):
    robot = request.getfixturevalue(name)
    kinematics = robot.kinematics(compiled=True)
    for floor in (0.0, 1e-4, 1e-2):
        integral = PathIntegral(kinematics=kinematics, power=power, floor=floor)
        for pieces, degree in ((1, 6), (4, 5), (9, 3)):
            path = some_path(rng, pieces, degree, robot.n)
            assert integral._panels(path) is not None
            fine = integral.fine_panels(path)
            np.testing.assert_array_equal(fine, by_numpy(monkeypatch, integral.fine_panels, path))
            assert integral.on_panels(path, fine) == by_numpy(monkeypatch, integral.on_panels, path, fine)
            cost, by_hand = integral.cost(path), by_numpy(monkeypatch, integral.cost, path)
            assert cost.g == pytest.approx(by_hand.g, rel=1e-14)  # summed in another order
            assert replace(cost, g=0.0) == replace(by_hand, g=0.0)


@pytest.mark.compiler
def test_more_panels_than_there_is_room_for(ur5, rng, monkeypatch):
    integral = PathIntegral(kinematics=ur5.kinematics(compiled=True), power=1, floor=1e-6)
    path = some_path(rng, 8, 6, 6)
    monkeypatch.setattr(panels, "ROOM", 3)
    fine = integral.fine_panels(path)
    assert len(fine) > 14
    np.testing.assert_array_equal(fine, by_numpy(monkeypatch, integral.fine_panels, path))


@pytest.mark.compiler
def test_integrals_that_are_not_compiled(ur5, rng):
    """Other powers, a metric, and kinematics without machine code are left to NumPy."""
    path, usual = some_path(rng, 2, 4, 6), ur5.kinematics(compiled=True)
    for options in (
        {"power": 0.5},
        {"power": 1, "metric": np.eye(6)},
        {"power": 1, "kinematics": ur5.kinematics(compiled=False)},
    ):
        assert PathIntegral(**{"kinematics": usual, "floor": 1e-3} | options)._panels(path) is None
    with_metric = PathIntegral(kinematics=usual, power=1, floor=1e-3, metric=np.eye(6))
    without = PathIntegral(kinematics=usual, power=1, floor=1e-3)
    assert with_metric.cost(path).g == pytest.approx(without.cost(path).g, rel=1e-9)
