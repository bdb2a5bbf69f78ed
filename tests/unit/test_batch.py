"""Many configurations at once: the same numbers as one by one, whatever evaluates them."""

import casadi as ca
import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.kinematics import batch
from manipplan.kinematics.batch import BATCH, BatchKernel, operations
from manipplan.support.compiler import find_compiler
from manipplan.support.kernels import kernel_by_llvm

COMPILED = [pytest.param(True, marks=pytest.mark.compiler), False]
QUANTITIES = ["pose", "jacobian", "manipulability", "gradient", "hessian"]


def one_by_one(kinematics, quantity, q):
    return np.array([getattr(kinematics, quantity)(each) for each in q])


@pytest.mark.slow
@pytest.mark.compiler
@pytest.mark.parametrize("quantity", QUANTITIES)
@pytest.mark.parametrize("task", [mp.Task.pose(), mp.Task.pointing(), mp.Task.position()], ids=lambda task: task.name)
def test_batch_equals_single(panda, quantity, task, rng):
    """Counts around the widths of vector registers, and one that threads share."""
    kinematics = panda.kinematics(task, compiled=True, threads=2)
    reference = panda.kinematics(task, compiled=False)
    q = panda.random_configuration(rng, size=37)
    single = one_by_one(reference, quantity, q)
    for count in (1, 2, 7, 8, 9, 15, 16, 17, 31, 33, 37):
        np.testing.assert_allclose(getattr(kinematics, quantity)(q[:count]), single[:count], rtol=1e-10, atol=1e-13)
    many = np.tile(q, (2000, 1))
    np.testing.assert_allclose(getattr(kinematics, quantity)(many)[-37:], single, rtol=1e-10, atol=1e-13)
    np.testing.assert_allclose(getattr(reference, quantity)(q), single, rtol=1e-10, atol=1e-13)


@pytest.mark.parametrize("compiled", COMPILED)
def test_layouts_and_kinds_of_numbers(panda, compiled, rng):
    kinematics = panda.kinematics(compiled=compiled)
    q = panda.random_configuration(rng, size=(20))
    expected = kinematics.manipulability(q)
    np.testing.assert_array_equal(kinematics.manipulability(np.asfortranarray(q)), expected)
    np.testing.assert_array_equal(kinematics.manipulability(q.tolist()), expected)
    np.testing.assert_array_equal(kinematics.manipulability(np.repeat(q, 2, axis=0)[::2]), expected)
    np.testing.assert_array_equal(kinematics.manipulability(q.reshape(4, 5, 7)), expected.reshape(4, 5))
    np.testing.assert_allclose(kinematics.manipulability(q.astype(np.float32)), expected, rtol=1e-4)
    np.testing.assert_allclose(
        kinematics.manipulability(np.ones((3, 7), dtype=int)), kinematics.manipulability(np.ones((3, 7)))
    )
    assert kinematics.manipulability(np.empty((0, 7))).shape == (0,)


@pytest.mark.parametrize("compiled", COMPILED)
@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
def test_what_is_not_finite_is_found(panda, compiled, bad):
    kinematics = panda.kinematics(compiled=compiled)
    for joint in range(7):
        q = np.zeros((19, 7))
        q[17, joint] = bad
        with pytest.raises(mp.errors.InvalidInputError, match="finite numbers"):
            kinematics.manipulability(q)


@pytest.mark.slow
@pytest.mark.compiler
def test_far_angles_and_prismatic_joints(rng):
    """Angles far from zero lose no digits, and lengths are not turned back."""
    robot = mp.load_robot("tiago")
    assert "prismatic" in robot.joint_types
    fast, slow = (robot.kinematics(mp.Task.pose(), compiled=compiled) for compiled in (True, False))
    q = robot.random_configuration(rng, size=40)
    q[::3] += 1e6
    q[1::3] *= 1e3
    np.testing.assert_allclose(fast.manipulability(q), slow.manipulability(q), rtol=1e-10)
    np.testing.assert_allclose(fast.pose(q), slow.pose(q), rtol=1e-12, atol=1e-12)


@pytest.mark.compiler
def test_index_to_ten_digits_against_pinocchio(panda, rng):
    kinematics = panda.kinematics(mp.Task.pose(1.0), compiled=True)
    q = panda.random_configuration(rng, size=3000)
    data, frame = panda.model.createData(), panda.model.getFrameId(panda.tool)
    jacobians = [pin.computeFrameJacobian(panda.model, data, each, frame, pin.LOCAL_WORLD_ALIGNED) for each in q]
    oracle = np.prod(np.linalg.svd(np.array(jacobians), compute_uv=False), axis=1)
    np.testing.assert_allclose(kinematics.manipulability(q), oracle, rtol=1e-10)


@pytest.mark.slow
def test_without_compiler(no_compiler, rng):
    panda = mp.load_robot("panda")
    assert find_compiler() is None
    q = panda.random_configuration(rng, size=200)
    for quantity in QUANTITIES:
        expected = getattr(panda.kinematics(mp.Task.pose(), compiled=False), quantity)(q)
        np.testing.assert_allclose(getattr(panda.kinematics(mp.Task.pose()), quantity)(q), expected, rtol=1e-10, atol=1e-13)


@pytest.mark.slow
@pytest.mark.compiler
@pytest.mark.parametrize("measure", mp.measures.available_measures())
def test_every_measure_runs_in_a_kernel(measure, panda, rng):
    chosen = {"velocity_transmission": mp.measures.VelocityTransmission, "force_transmission": mp.measures.ForceTransmission}
    chosen = chosen[measure](direction=(1.0, 2.0, 3.0)) if measure in chosen else measure
    fast, slow = (panda.kinematics(mp.Task.position(), compiled=c, measure=chosen) for c in (True, False))
    q = panda.random_configuration(rng, size=20)
    np.testing.assert_allclose(fast.manipulability(q), slow.manipulability(q), rtol=1e-9)
    np.testing.assert_allclose(fast.gradient(q), slow.gradient(q), rtol=1e-7, atol=1e-9)


def values_of(kernel, q, outputs):
    out = np.full((len(q), outputs), np.nan)
    return out, kernel(np.ascontiguousarray(q), out)


@pytest.fixture
def every_operation():
    """A Function that uses each operation that kernels claim to know."""
    x = ca.SX.sym("x", 2)
    a, b = x[0], x[1]
    near = 0.9 * ca.sin(a)
    expressions = [a + b, a - b, a * b, a / b, -a, a**2, 2 * a, 1 / a, ca.sqrt(ca.fabs(a)), ca.fmin(a, b), ca.fmax(a, b)]
    expressions += [a < b, a <= b, a == b, a != b, ca.logic_not(a), ca.if_else(a < b, a, b), ca.logic_and(a, b)]
    expressions += [ca.logic_or(a, b), ca.sign(a), ca.floor(a), ca.ceil(a), ca.sinh(a), ca.cosh(a), ca.tanh(a), ca.tan(a)]
    expressions += [ca.exp(a), ca.log(ca.fabs(a)), ca.asin(near), ca.acos(near), ca.atan(a), ca.atan2(a, b)]
    expressions += [ca.fabs(a) ** b, ca.fabs(a) ** 1.5, ca.sin(a), ca.cos(b), ca.sin(1e7 * a), 3.0 + 0 * a]
    function = ca.Function("all", [x], [ca.densify(ca.vertcat(*expressions))])
    used = {function.instruction_id(k) for k in range(function.n_instructions())}
    assert set(operations()) - {ca.OP_ASSIGN} <= used
    return function


def test_every_operation_of_the_kernels(every_operation):
    """Against CasADi's virtual machine."""
    values = np.array([[-1.7, 0.3], [1.7, -0.3], [0.4, 0.4], [2.0, 1.0], [-0.2, -0.2], [0.0, 2.0]])
    expected = np.asarray(every_operation(ca.DM(values.T))).T
    found, is_finite = values_of(BatchKernel(every_operation, False, "a test"), values, every_operation.nnz_out(0))
    assert is_finite
    np.testing.assert_allclose(found, expected, rtol=1e-13, atol=1e-13)


@pytest.mark.compiler
def test_machine_code_gives_the_same_bits(every_operation, rng):
    """Also the interpreter of machines without a compiler, whose vectors are shorter.

    Also for angles far from zero, whatever stands in the rows beside them, and for every count up to a few blocks.
    """
    slow, fast, by_llvm = (BatchKernel(every_operation, compiled, "a test") for compiled in (False, True, False))
    code = kernel_by_llvm("batch")
    by_llvm._run = BATCH(code.address("batch"))
    outputs = every_operation.nnz_out(0)
    q = rng.normal(size=(150, 2)) * 10.0 ** rng.integers(-3, 9, size=(150, 2))
    whole, _ = values_of(slow, q, outputs)
    for count in (1, 2, 7, 8, 9, 31, 32, 33, 64, 100, 150):
        for kernel in (slow, fast, by_llvm):
            found, is_finite = values_of(kernel, q[:count], outputs)
            assert is_finite and found.tobytes() == whole[:count].tobytes()
    mixed = values_of(slow, q[::-1], outputs)[0][::-1]
    assert np.ascontiguousarray(mixed).tobytes() == whole.tobytes()


@pytest.mark.compiler
def test_the_inverse_is_that_of_a_division(rng):
    """To the last bit on every processor, also where all bits of the fraction are ones, at zero and at infinity."""
    x = ca.SX.sym("x")
    function = ca.Function("inverse", [x], [1 / x])
    wide = np.exp(rng.uniform(-300, 300, size=100_000)) * rng.choice([-1.0, 1.0], size=100_000)
    ones = np.nextafter(2.0 ** np.arange(-1000, 1000.0), 0.0)
    q = np.concatenate([rng.uniform(0.5, 2.0, size=100_000), wide, ones, -ones, [0.0, -0.0, 1e-310, 5e-324, 1.79e308]])[:, None]
    with np.errstate(divide="ignore", over="ignore"):
        expected = 1 / q
    for compiled in (True, False):
        np.testing.assert_array_equal(values_of(BatchKernel(function, compiled, "a test"), q, 1)[0], expected)


@pytest.mark.slow
@pytest.mark.compiler
def test_machine_code_is_built_when_it_pays_off(monkeypatch, tmp_path, panda, rng):
    monkeypatch.setenv("MANIPPLAN_CACHE", str(tmp_path))
    function = panda.kinematics(mp.Task.pose()).symbolic.gradient
    monkeypatch.setattr(batch, "PAYS_OFF", 100 * function.n_instructions())
    kernel = BatchKernel(function, "auto", "a test")
    interpreter = kernel.batch[0]
    q = panda.random_configuration(rng, size=60)
    found = [values_of(kernel, q, 7)[0].tobytes() for _ in range(2)]
    assert kernel.batch[0] != interpreter and len(list(tmp_path.rglob("*.so"))) == 1
    assert {*found, values_of(kernel, q, 7)[0].tobytes()} == {found[0]}
    assert BatchKernel(function, "auto", "a test").batch[0] != interpreter  # that of an earlier kernel


@pytest.mark.compiler
def test_an_operation_that_kernels_do_not_know(panda, rng):
    """A user's own measure with an exotic function still works, in CasADi's virtual machine."""
    from manipplan.measures.measure import JacobianMeasure

    class Exotic(JacobianMeasure):
        name, formula, source = "exotic", "erf of the norm", "tests"

        def unit(self, task):
            return "1"

        def of(self, jacobian):
            return ca.erf(ca.norm_fro(jacobian))

    kinematics = panda.kinematics(measure=Exotic(), compiled=True)
    q = panda.random_configuration(rng, size=3)
    np.testing.assert_allclose(kinematics.manipulability(q), [kinematics.manipulability(each) for each in q])
