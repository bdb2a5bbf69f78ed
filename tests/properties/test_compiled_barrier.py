"""Compiled Newton steps of timing with jerk limits against NumPy's, on random problems."""

import numpy as np
import pytest
from barrier_oracle import NumpyCentring, slacks_of, time_of
from examples import examples
from hypothesis import given
from hypothesis import strategies as st

import manipplan as mp
from manipplan.support.kernels import kernel_by_llvm
from manipplan.timing import jerk, piece
from manipplan.timing.dynamics import ArcLength, path_dynamics
from manipplan.timing.jerk import Centring, JerkProblem, fastest_motion, motion_inside
from manipplan.timing.piece import first_grid
from manipplan.timing.stops import LimitsAlong, Segment

ARM, HEAVY = mp.planar_arm([1.0, 1.0, 1.0]), mp.load_robot("ur5")
LLVM = kernel_by_llvm("barrier")
FUNCTIONS = {"compiler": jerk._calls(), "llvm": LLVM.functions()}


def random_problem(seed, ends=(0.0, 0.0), *, unlimited=0, torque=False, effort=400.0, points=60):
    """A random path of one polynomial, with a segment of tighter limits; the first joints have no jerk limit."""
    rng = np.random.default_rng(seed)
    arm = HEAVY if torque else ARM
    velocity, acceleration = rng.uniform(0.3, 5.0, (2, arm.n))
    jerk = acceleration * rng.uniform(3, 100)
    jerk[:unlimited] = np.inf
    limits = arm.with_limits(velocity=velocity, acceleration=acceleration, effort=effort).limits
    limits = limits.with_changes({"jerk": jerk})
    curve = ArcLength(mp.JointPath(breaks=[0.0, 1.0], control=rng.normal(size=(1, rng.integers(2, 8), arm.n))), 0.0, 1.0)
    grid = first_grid(curve, points, np.empty(0), (ends[0] == 0, ends[1] == 0))
    part = Segment(begin=0.3, end=0.6, velocity=0.5, jerk=0.4)
    along = LimitsAlong(limits, (part,), np.array([[0.3, 0.6]]))
    asked = path_dynamics(curve, grid, along, arm.model if torque else None, None)
    most = np.sqrt(asked.fastest[[0, -1]])
    start, end = (0.3 * share * speed for share, speed in zip(ends, most, strict=True))
    bounds = along.at(curve.s((grid[:-1] + grid[1:]) / 2))
    return JerkProblem(asked, bounds.jerk, start**2, end**2)


def both(monkeypatch, problem, functions):
    """The objects that take compiled steps, and NumPy's."""
    with monkeypatch.context() as context:
        context.setattr(jerk, "_calls", lambda: functions)
        return Centring(problem), NumpyCentring(problem)


@pytest.fixture(params=FUNCTIONS)
def functions(request):
    assert FUNCTIONS[request.param] is not None
    return FUNCTIONS[request.param]


ENDS = [(0.0, 0.0), (0.1, 0.0), (0.0, 0.1), (0.1, 0.2)]


@pytest.mark.slow
@pytest.mark.parametrize("ends", ENDS)
@pytest.mark.parametrize(("unlimited", "torque"), [(0, False), (1, False), (2, True), (3, False)])
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
        times = [time_of(problem, slacks_of(problem, problem.coefficients(each)).pace) for each in (found, expected)]
        assert times[0] == pytest.approx(times[1], rel=1e-9)
        np.testing.assert_allclose(found, expected, rtol=1e-3, atol=1e-9 * expected.max())
    assert compared


@examples(20)
@given(
    seed=st.integers(0, 2**32 - 1),
    ends=st.sampled_from(ENDS),
    unlimited=st.integers(0, 3),
    torque=st.booleans(),
    points=st.integers(20, 150),
)
def test_compiled_steps_lead_where_numpy_s_do_on_random_problems(seed, ends, unlimited, torque, points):
    problem = random_problem(seed, ends, unlimited=unlimited, torque=torque, points=points)
    with pytest.MonkeyPatch.context() as context:
        motions = [fastest_motion(problem)]
        context.setattr(jerk, "Centring", NumpyCentring)
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
    monkeypatch.setattr(jerk, "Centring", NumpyCentring)
    durations.append(mp.retime(path, ARM, limits=limits).duration)
    assert durations[0] == pytest.approx(durations[1], rel=1e-6)


def test_a_problem_without_a_motion_has_none(functions, monkeypatch):
    """Gravity alone asks for more than the effort limits allow."""
    problem = random_problem(2, torque=True, effort=1e-3)
    assert np.abs(problem.constant).max() > 1
    for code in both(monkeypatch, problem, functions):
        assert motion_inside(problem, None, code) is None


@pytest.mark.slow
@pytest.mark.parametrize("compiled", [True, False])
def test_speeds_and_efforts_without_a_motion_are_refused_alike(monkeypatch, compiled):
    if not compiled:
        monkeypatch.setattr(jerk, "Centring", NumpyCentring)
    robot = mp.planar_arm([1.0, 1.0]).with_limits(velocity=[1.0, 2.0], acceleration=2.0, jerk=1.0)
    path = mp.JointPath.line([0.0, 0.0], [0.01, 0.0])
    for name in ("start_speed", "end_speed"):
        with pytest.raises(
            mp.errors.InvalidInputError, match=rf"{name}: got 0.19; allowed: a lower speed; no motion within the jerk"
        ):
            mp.retime(path, robot, **{name: 0.19})
    with pytest.raises(mp.errors.InvalidInputError, match=r"start_speed: got 0.5; allowed: 0 to 0.199.* slow down in time"):
        mp.retime(path, robot, start_speed=0.5)


def test_a_motion_that_is_never_within_the_limits_is_refused_with_the_reason(monkeypatch):
    """The reason is that without jerk limits, if there is one."""
    path = mp.JointPath(breaks=[0.0, 1.0], control=[[[0.0, 0.0, 0.0], [0.0, 1.0, 0.5], [1.0, 1.0, 1.0]]])
    arm = ARM.with_limits(velocity=1.0, acceleration=2.0, jerk=20.0)
    monkeypatch.setattr(piece, "fastest_motion", lambda *_: None)
    with pytest.raises(mp.errors.PlanningError, match="no motion within the jerk limits was found"):
        mp.retime(path, arm)

    def no_speeds(*_):
        raise mp.errors.PlanningError("the effort limit of joint2 allows no motion")

    monkeypatch.setattr(piece, "fastest_speeds", no_speeds)
    with pytest.raises(mp.errors.PlanningError, match="the effort limit of joint2 allows no motion"):
        mp.retime(path, arm)
