"""Compiled Newton steps of timing with jerk limits against NumPy's, on random problems."""

import numpy as np
import pytest
from examples import examples
from hypothesis import given
from hypothesis import strategies as st
from test_compiled_paths import by_llvm

import manipplan as mp
from manipplan.timing import barrier
from manipplan.timing.arc import ArcLength
from manipplan.timing.barrier import Centring, fastest_motion, motion_inside
from manipplan.timing.dynamics import path_dynamics
from manipplan.timing.jerk import JerkProblem
from manipplan.timing.piece import first_grid
from manipplan.timing.segment import LimitsAlong, Segment

ARM = mp.planar_arm([1.0, 1.0, 1.0])
LLVM = by_llvm(barrier.__file__)
FUNCTIONS = {"compiler": barrier._calls(), "llvm": LLVM.functions("manipplan_", barrier.SIGNATURES)}


def random_problem(seed, ends=(0.0, 0.0), *, unlimited=0, torque=False, points=60):
    """A random path of one polynomial, with a segment of tighter limits; the first joints have no jerk limit."""
    rng = np.random.default_rng(seed)
    velocity, acceleration = rng.uniform(0.3, 5.0, (2, 3))
    jerk = acceleration * rng.uniform(3, 100)
    jerk[:unlimited] = np.inf
    limits = ARM.with_limits(velocity=velocity, acceleration=acceleration, effort=rng.uniform(60, 400)).limits
    limits = limits.with_changes({"jerk": jerk})
    curve = ArcLength(mp.JointPath(breaks=[0.0, 1.0], control=rng.normal(size=(1, rng.integers(2, 8), 3))), 0.0, 1.0)
    grid = first_grid(curve, points, np.empty(0), (ends[0] == 0, ends[1] == 0))
    part = Segment(begin=0.3, end=0.6, velocity=0.5, jerk=0.4)
    along = LimitsAlong(limits, (part,), np.array([[0.3, 0.6]]))
    asked = path_dynamics(curve, grid, along, ARM.model if torque else None, None)
    most = np.sqrt(asked.fastest[[0, -1]])
    start, end = (0.3 * share * speed for share, speed in zip(ends, most, strict=True))
    bounds = along.at(curve.s((grid[:-1] + grid[1:]) / 2))
    return JerkProblem(asked, bounds.jerk, start**2, end**2)


def both(monkeypatch, problem, functions):
    """The objects that take compiled steps, and NumPy's."""
    with monkeypatch.context() as context:
        context.setattr(barrier, "_calls", lambda: functions)
        compiled = Centring(problem)
        context.setattr(barrier, "_calls", lambda: None)
        return compiled, Centring(problem)


@pytest.fixture(params=FUNCTIONS)
def functions(request):
    assert FUNCTIONS[request.param] is not None
    return FUNCTIONS[request.param]


ENDS = [(0.0, 0.0), (0.1, 0.0), (0.0, 0.1), (0.1, 0.2)]


@pytest.mark.parametrize("ends", ENDS)
@pytest.mark.parametrize(("unlimited", "torque"), [(0, False), (1, False), (2, True)])
def test_compiled_steps_lead_where_numpy_s_do(monkeypatch, functions, ends, unlimited, torque):
    compared = 0
    for seed in range(4):
        problem = random_problem(seed, ends, unlimited=unlimited, torque=torque)
        compiled, numpy = both(monkeypatch, problem, functions)
        z = motion_inside(problem, None, numpy)
        if z is None:
            continue
        compared += 1
        found, expected = compiled.descended(z), numpy.descended(z)
        times = [problem.time(problem.slacks(problem.coefficients(each)).pace) for each in (found, expected)]
        assert times[0] == pytest.approx(times[1], rel=1e-9)
        np.testing.assert_allclose(found, expected, rtol=1e-3, atol=1e-9 * expected.max())
    assert compared


@examples(20)
@given(
    seed=st.integers(0, 2**32 - 1),
    ends=st.sampled_from(ENDS),
    unlimited=st.integers(0, 2),
    torque=st.booleans(),
    points=st.integers(20, 150),
)
def test_compiled_steps_lead_where_numpy_s_do_on_random_problems(seed, ends, unlimited, torque, points):
    problem = random_problem(seed, ends, unlimited=unlimited, torque=torque, points=points)
    with pytest.MonkeyPatch.context() as context:
        motions = [fastest_motion(problem)]
        context.setattr(barrier, "_calls", lambda: None)
        motions.append(fastest_motion(problem))
    assert (motions[0] is None) == (motions[1] is None)
    if motions[0] is not None:
        assert motions[0].steps.sum() == pytest.approx(motions[1].steps.sum(), rel=1e-9)


@pytest.mark.parametrize("points", [20, 39, 40, 41, 42, 43, 44, 45, 46, 47])
def test_llvm_s_code_gives_the_same_numbers(monkeypatch, points):
    """Bit by bit, as both do the same operations without contraction."""
    problem = random_problem(0, points=points)
    codes = [both(monkeypatch, problem, functions)[0] for functions in FUNCTIONS.values()]
    z = motion_inside(problem, None, codes[0])
    np.testing.assert_array_equal(*(code.descended(z) for code in codes))


def test_slowing_down_until_all_limits_hold(monkeypatch, functions):
    problem = random_problem(1)
    compiled, numpy = both(monkeypatch, problem, functions)
    z = np.full(len(problem.fastest) - 1, 10.0)
    np.testing.assert_allclose(compiled.entered(z, 0.8, 400), numpy.entered(z, 0.8, 400), rtol=1e-12)
    for code in (compiled, numpy):
        assert code.entered(z, 0.8, 3) is None
        assert code.entered(-z, 0.8, 50) is None
        assert code.entered(np.full_like(z, np.nan), 0.8, 50) is None
        with pytest.raises(ValueError, match="not inside"):
            code.descended(z)
    np.testing.assert_array_equal(z, 10.0)


def test_without_compiled_code_a_motion_is_the_same(monkeypatch):
    """Up to what rounding decides: whether a limit is exceeded by a digit, for which the motion is slowed down."""
    path, limits = mp.JointPath.line(np.zeros(3), np.ones(3)), ARM.with_limits(velocity=1.0, acceleration=2.0, jerk=20.0).limits
    durations = [mp.retime(path, ARM, limits=limits).duration]
    monkeypatch.setattr(barrier, "_calls", lambda: None)
    durations.append(mp.retime(path, ARM, limits=limits).duration)
    assert durations[0] == pytest.approx(durations[1], rel=1e-6)
