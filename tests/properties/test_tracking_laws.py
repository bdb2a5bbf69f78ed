"""Laws of tracking: limits that are never exceeded, and what a step must not depend on."""

import casadi as ca
import numpy as np
import pytest
from chains import chain, kinds, seeds
from examples import examples
from hypothesis import example, given
from hypothesis import strategies as st

import manipplan as mp
from manipplan.robots.limits import JointLimits
from manipplan.tracking.bounds import limits_jerk, velocity_bounds
from manipplan.tracking.controller import Controller

JOINTS = 24
STEPS = 500
EPS = np.finfo(float).eps
#: Chosen where there is no limit.
FAST = 20.0


def random_limits(rng, dt, jerk):
    """Of many joints, finite or not, wide or narrow, fast or slow beside the time step."""

    def sometimes(values, share=0.2):
        return np.where(rng.random(JOINTS) < share, np.inf, values)

    width = 10 ** rng.uniform(-2, 1, JOINTS)
    middle = rng.uniform(-3, 3, JOINTS)
    velocity = 10 ** rng.uniform(-1, 1, JOINTS)
    acceleration = 10 ** rng.uniform(-1, 2, JOINTS)
    jerks = 2 * acceleration / dt * 10 ** rng.uniform(-3, 0, JOINTS) if jerk else np.full(JOINTS, np.inf)
    limits = JointLimits(
        lower=-sometimes(width - middle),
        upper=sometimes(width + middle),
        velocity=velocity if jerk else sometimes(velocity),
        acceleration=acceleration if jerk else sometimes(acceleration),
        jerk=jerks,
        effort=np.full(JOINTS, np.inf),
    )
    assert limits_jerk(limits, dt) == jerk
    return limits


def way_to_stop(velocity, change, dt):
    """Of joints that slow down by `change` from the next step on; `test_bounds` has it by adding up."""
    velocity = np.maximum(velocity - change, 0)
    steps = np.floor(velocity / change)
    return dt * ((steps + 1) * velocity - change * steps * (steps + 1) / 2)


def viable_state(rng, limits, dt):
    """A position inside, anywhere or at a limit, and a velocity from which the joint can stop, often the largest."""
    low, high = np.maximum(limits.lower, -10.0), np.minimum(limits.upper, 10.0)
    q = np.clip(low + (high - low) * np.clip(rng.uniform(-0.1, 1.1, JOINTS), 0, 1), limits.lower, limits.upper)
    sign = rng.choice([-1.0, 1.0], JOINTS)
    room = np.where(sign > 0, limits.upper - q, q - limits.lower)
    change = np.minimum(limits.acceleration * dt, 1e6)
    slow, fast = np.zeros(JOINTS), np.minimum(limits.velocity, FAST)
    for _ in range(50):
        middle = (slow + fast) / 2
        stops = way_to_stop(middle, change, dt) <= room
        slow, fast = np.where(stops, middle, slow), np.where(stops, fast, middle)
    return q, sign * slow * np.where(rng.random(JOINTS) < 0.5, 1.0, rng.random(JOINTS))


CHOICES = {
    "lower": lambda low, high, rng: low,
    "upper": lambda low, high, rng: high,
    "random": lambda low, high, rng: rng.uniform(low, high),
    "either": lambda low, high, rng: np.where(rng.random() < 0.05, low, high),
}


def follow(limits, state, dt, choice, rng):
    """Positions, velocities and accelerations of many steps inside the bounds, which are never empty."""
    symbols = [ca.SX.sym(name, JOINTS) for name in ("q", "v", "a")]
    bounds = ca.Function("bounds", symbols, velocity_bounds(*symbols, limits, dt))
    buffer, run = bounds.buffer()
    q, v, a = (np.array(each) for each in state)
    low, high = np.empty(JOINTS), np.empty(JOINTS)
    for i, values in enumerate((q, v, a)):
        buffer.set_arg(i, values.data)
    buffer.set_res(0, low.data)
    buffer.set_res(1, high.data)
    record = [[q.copy()], [v.copy()], [a.copy()]]
    for _ in range(STEPS):
        run()
        assert (low <= high + 1e-12 * limits.velocity.clip(max=1e3)).all()
        assert not np.isnan([low, high]).any()
        chosen = choice(np.maximum(low, -FAST), np.minimum(high, FAST), rng)
        a[:] = (chosen - v) / dt
        v[:] = chosen
        q += dt * v
        for values, each in zip(record, (q, v, a), strict=True):
            values.append(each.copy())
    return tuple(np.array(each) for each in record)


def assert_limits_hold(limits, q, v, dt):
    """To 1e-12, and what rounding of a position is worth in a velocity."""
    rounding = 4 * EPS * np.abs(q).max(axis=0) / dt
    scale = np.minimum(limits.velocity, np.abs(v).max(axis=0) + 1e-300)
    assert (limits.outside(q) <= 1e-12 * np.maximum(1, np.abs(q))).all()
    assert (np.abs(v) <= limits.velocity * (1 + 1e-12)).all()
    assert (np.abs(np.diff(v, axis=0)) <= limits.acceleration * dt + 1e-12 * scale + rounding).all()


@pytest.mark.slow
@examples(40)
@given(seeds, st.floats(1e-3, 0.05), st.sampled_from(sorted(CHOICES)))
def test_from_a_viable_state_no_choice_within_the_bounds_exceeds_a_limit(seed, dt, choice):
    rng = np.random.default_rng(seed)
    limits = random_limits(rng, dt, jerk=False)
    q, v = viable_state(rng, limits, dt)
    path, speed, _ = follow(limits, (q, v, np.zeros(JOINTS)), dt, CHOICES[choice], rng)
    assert_limits_hold(limits, path, speed, dt)


@pytest.mark.slow
@examples(40)
@given(seeds, st.floats(1e-3, 0.05), st.sampled_from(sorted(CHOICES)))
def test_from_rest_no_choice_within_the_bounds_exceeds_a_jerk_limit(seed, dt, choice):
    rng = np.random.default_rng(seed)
    limits = random_limits(rng, dt, jerk=True)
    q, _ = viable_state(rng, limits, dt)
    path, speed, acceleration = follow(limits, (q, np.zeros(JOINTS), np.zeros(JOINTS)), dt, CHOICES[choice], rng)
    assert_limits_hold(limits, path, speed, dt)
    jerk = np.diff(acceleration, axis=0) / dt
    rounding = 8 * EPS * np.abs(path).max(axis=0) / dt**3
    assert (np.abs(jerk) <= limits.jerk * (1 + 1e-9) + rounding).all()


# ---- what a step must not depend on


def free(robot):
    """The same arm without limits that could count."""
    return robot.with_limits(lower=-100.0, upper=100.0, velocity=1e6, acceleration=np.inf, jerk=np.inf)


def conditioned(robot, q):
    return np.linalg.svd(robot.kinematics().jacobian(q))[1][-1]


@pytest.mark.slow
@examples(10)
@given(seeds, kinds(6, 8))
def test_a_stiff_tracker_without_drive_is_the_pseudo_inverse(seed, prismatic):
    """(3) with Q_δ → ∞ is (2), on random arms."""
    robot, rng = free(chain(seed, prismatic)), np.random.default_rng(seed)
    general = Controller(robot, mp.formulations.General(), dt=0.01, approach=np.inf, compiled=False)
    driven = Controller(robot, mp.formulations.Equality(alpha=5e5), dt=0.01, approach=np.inf, compiled=False)
    classical = Controller(robot, mp.formulations.Classical(), dt=0.01, approach=np.inf, compiled=False)
    for _ in range(3):
        q = rng.uniform(-2, 2, robot.n)
        singular = conditioned(robot, q)
        if singular < 0.02:
            continue
        target = robot.kinematics().pose(q + 0.02 * rng.normal(size=robot.n))
        expected = classical.step(q, np.zeros(robot.n), target)
        near = 10 * np.abs(expected).max() / (1e8 * singular**2)
        np.testing.assert_allclose(general.step(q, np.zeros(robot.n), target, stiffness=1e8), expected, atol=near)
        np.testing.assert_allclose(driven.step(q, np.zeros(robot.n), target, stiffness=1e8, drive=0.0), expected, atol=near)


INVARIANT = [
    mp.formulations.LogDrive(),
    mp.formulations.Objective(alpha=2e3, sample_time=0.01),
    mp.formulations.Equality(alpha=5e5, sample_time=0.01),
]


def velocities(robot, formulation, q, steps=(0.01, 0.001)):
    """Of a step at each time step, with the target where the tool is."""
    target = robot.kinematics().pose(q)
    return [
        Controller(robot, formulation, dt=dt, compiled=False).step(q, np.zeros(robot.n), target, stiffness=10.0) for dt in steps
    ]


@pytest.mark.slow
@pytest.mark.parametrize("formulation", INVARIANT, ids=str)
def test_the_velocity_does_not_depend_on_the_time_step(panda, formulation, rng):
    robot = free(panda)
    for q in panda.random_configuration(rng, size=3):
        slow, fast = velocities(robot, formulation, q)
        assert np.abs(slow).max() > 1e-4
        np.testing.assert_allclose(fast, slow, rtol=1e-9, atol=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize("formulation", [mp.formulations.Objective(alpha=2e3), mp.formulations.Equality(alpha=5e5)], ids=str)
def test_with_the_paper_s_alpha_it_does(panda, formulation):
    slow, fast = velocities(free(panda), formulation, panda.neutral)
    assert np.abs(fast - slow).max() > 0.1 * np.abs(slow).max()


@pytest.mark.slow
def test_the_velocity_of_log_drive_does_not_depend_on_the_unit_of_manipulability(panda):
    """With rows twice as long, Q_δ a quarter and r twice, all of the cost is the same; Equality's is not."""
    robot, target = free(panda), panda.kinematics().pose(panda.neutral)
    answers = {}
    for name, make in (
        ("log", lambda r: mp.formulations.LogDrive(regularisation=r)),
        ("equality", lambda _: mp.formulations.Equality(alpha=5e5)),
    ):
        for scale in (1.0, 2.0):
            rows = scale * np.eye(6)
            rows[3:] *= 0.25
            task = mp.Task.custom(rows, length=0.25, name=f"scaled{scale:g}")
            of = Controller(robot, make(1e-3 * scale), dt=0.01, task=task, compiled=False)
            answers[name, scale] = of.step(panda.neutral, np.zeros(7), target, stiffness=10.0 / scale**2)
    np.testing.assert_allclose(answers["log", 2.0], answers["log", 1.0], rtol=1e-6, atol=1e-9)
    assert np.abs(answers["equality", 2.0] - answers["equality", 1.0]).max() > 1e-3


@pytest.mark.slow
def test_the_velocity_of_log_drive_does_not_depend_on_the_unit_of_its_measure(planar, rng):
    """Weights four times as large double the Frobenius norm; with r doubled, the step is the same. Equality's is not."""
    robot = free(planar)
    for q in planar.random_configuration(rng, size=3):
        target, found = robot.kinematics().pose(q), {}
        for scale in (1.0, 2.0):
            for formulation in (mp.formulations.LogDrive(regularisation=0.5 * scale), mp.formulations.Equality(alpha=1e3)):
                of = Controller(
                    robot, formulation, dt=0.01, measure=mp.measures.FrobeniusNorm(weights=scale**2), compiled=False
                )
                found[type(formulation), scale] = of.step(q, np.zeros(3), target, stiffness=10.0)
        log, equality = mp.formulations.LogDrive, mp.formulations.Equality
        assert np.abs(found[log, 1.0]).max() > 1e-3
        np.testing.assert_allclose(found[log, 2.0], found[log, 1.0], rtol=1e-6, atol=1e-9)
        assert np.abs(found[equality, 2.0] - found[equality, 1.0]).max() > 1e-3


# ---- whatever comes in


NUMBERS = st.sampled_from([0.0, 1.0, -1.0, 1e-300, 1e6, -1e12, np.inf, np.nan]) | st.floats(-1e3, 1e3)


@pytest.mark.slow
@examples(60)
@given(
    target=st.lists(NUMBERS, min_size=16, max_size=16),
    stiffness=NUMBERS | st.floats(1e-3, 1e9),
    drive=NUMBERS,
    seed=seeds,
)
@example(target=[0.0] * 16, stiffness=1.0, drive=1.0, seed=0)
def test_nothing_that_a_step_is_given_exceeds_a_limit(planar, target, stiffness, drive, seed):
    """Targets that are no poses, and numbers that are none."""
    controller = PLANAR.setdefault("controller", Controller(planar, mp.formulations.LogDrive(), dt=0.01, compiled=False))
    controller.reset()
    rng, limits = np.random.default_rng(seed), planar.limits
    q, qd = planar.random_configuration(rng), np.zeros(3)
    for k in range(10):
        pose = np.reshape(target, (4, 4)) if k % 3 else planar.kinematics().pose(q)
        before, qd = qd, controller.step(q, qd, pose, stiffness=stiffness, drive=drive)
        q = q + 0.01 * qd
        assert np.isfinite(qd).all()
        assert not limits.outside(q).any()
        assert (np.abs(qd) <= limits.velocity * (1 + 1e-12)).all()
        assert (np.abs(qd - before) <= 0.01 * limits.acceleration * (1 + 1e-9)).all()


PLANAR: dict = {}
