"""Laws of timing: verified limits, scaling of time, reversal, and no limit that makes a motion faster by being tighter."""

import re

import numpy as np
import pinocchio as pin
import pytest
from examples import examples
from hypothesis import assume, given
from hypothesis import strategies as st

import manipplan as mp
from manipplan.timing.constant_speed import SpeedDemand, limits_bound, standing

seeds = st.integers(0, 2**32 - 1)
ARM = mp.planar_arm([1.0, 1.0, 1.0])


def random_problem(seed, *, jerk, size=1.0):
    """A random path of two joined or one single polynomial, and limits of three joints."""
    rng = np.random.default_rng(seed)
    velocity, acceleration = rng.uniform(0.3, 5.0, (2, 3))
    limits = ARM.with_limits(velocity=velocity, acceleration=acceleration).limits
    if jerk:
        limits = limits.with_changes({"jerk": acceleration * rng.uniform(3, 100)})
    control = size * rng.normal(size=(rng.integers(1, 3), rng.integers(2, 7), 3))
    if len(control) == 2:
        control[1, 0] = control[0, -1]
    return mp.JointPath(breaks=np.linspace(0, 1, len(control) + 1), control=control), limits


def worst(trajectory, limits):
    """Largest demand over limit by samples alone."""
    h = np.diff(trajectory.t)[:, None]
    ends = [trajectory(trajectory.t[:-1] + share * h[:, 0], 2) for share in (0.0, 0.5)]
    inside = np.concatenate([trajectory(trajectory.t[:-1] + share * h[:, 0], 1) for share in np.linspace(0, 0.999, 9)])
    jerk = 2 * np.abs(ends[1] - ends[0]) / h / limits.jerk
    last = 2 * ends[1] - ends[0]
    acceleration = np.concatenate([ends[0], last]) / limits.acceleration
    return max((np.abs(inside) / limits.velocity).max(), np.abs(acceleration).max(), jerk.max())


@examples(40)
@given(seeds, st.booleans(), st.floats(-4, 3))
def test_limits_hold_from_tiny_to_huge_paths(seed, jerk, magnitude):
    path, limits = random_problem(seed, jerk=jerk, size=10**magnitude)
    trajectory = mp.retime(path, ARM, limits=limits)
    assert worst(trajectory, limits) <= 1 + 1e-6
    assert mp.jerk_use(trajectory, limits).ratio <= 1 + 1e-9
    ends = [path.start, path.goal]
    np.testing.assert_allclose(trajectory.q[[0, -1]], ends, atol=1e-9 * max(1, path.length))
    np.testing.assert_array_equal(trajectory.qd[[0, -1]], 0)


@examples(20)
@given(seeds, st.booleans(), st.floats(0.2, 20.0))
def test_time_scales_with_limits(seed, jerk, factor):
    """Velocities k, accelerations k² and jerks k³ times as large: the same motion in 1/k of the time."""
    path, limits = random_problem(seed, jerk=jerk)
    faster = limits.with_changes(
        {"velocity": factor * limits.velocity, "acceleration": factor**2 * limits.acceleration, "jerk": factor**3 * limits.jerk}
    )
    ratio = mp.retime(path, ARM, limits=limits).duration / mp.retime(path, ARM, limits=faster).duration
    np.testing.assert_allclose(ratio, factor, rtol=5e-3)


@examples(20)
@given(seeds, st.booleans())
def test_the_way_back_takes_as_long(seed, jerk):
    path, limits = random_problem(seed, jerk=jerk)
    back = path.backwards()
    ratio = mp.retime(path, ARM, limits=limits).duration / mp.retime(back, ARM, limits=limits).duration
    np.testing.assert_allclose(ratio, 1, rtol=1e-2)


@examples(20)
@given(seeds, st.booleans(), st.sampled_from(["velocity", "acceleration", "jerk"]), st.floats(0.1, 0.9))
def test_tighter_limits_never_make_it_faster(seed, jerk, kind, share):
    path, limits = random_problem(seed, jerk=jerk)
    tighter = limits.with_changes({kind: share * getattr(limits, kind)})
    assert mp.retime(path, ARM, limits=tighter).duration >= 0.99 * mp.retime(path, ARM, limits=limits).duration


@examples(20)
@given(seeds, st.floats(0.05, 0.5), st.floats(0.1, 0.5), st.floats(0.1, 1.0))
def test_a_segment_takes_between_the_whole_at_both_limits(seed, begin, width, share):
    path, limits = random_problem(seed, jerk=False)
    part = mp.Segment(begin=begin, end=begin + width, velocity=share, acceleration=share**2)
    everywhere = mp.Segment(begin=0.0, end=1.0, velocity=share, acceleration=share**2)
    free, held, slow = (mp.retime(path, ARM, limits=limits, segments=each).duration for each in ([], [part], [everywhere]))
    assert 0.99 * free <= held <= 1.01 * slow
    np.testing.assert_allclose(slow, free / share, rtol=1e-2)


ARMS = (
    mp.planar_arm([0.6, 0.4, 0.3]).with_limits(acceleration=5.0),
    *(mp.load_robot(each) for each in ("panda", "ur5", "xarm7")),
)


@pytest.mark.slow
@examples(25)
@given(seeds, st.sampled_from(ARMS), st.sampled_from([None, 50.0, np.inf]), st.floats(-3.0, 0.5))
def test_a_constant_speed_is_kept_or_the_fastest_is_named(seed, arm, jerk, magnitude):
    """On splines through random waypoints; the speeds by Pinocchio, from the samples of the motion."""
    rng = np.random.default_rng(seed)
    arm = arm if jerk is None else arm.with_limits(jerk=jerk)
    steps = rng.normal(size=(rng.integers(2, 6), arm.n)) * 0.25 + 0.3 * rng.normal(size=arm.n)
    path = mp.JointPath.spline(
        np.linspace(0, 1, len(steps) + 1), arm.neutral + np.vstack([0 * steps[:1], np.cumsum(steps, axis=0)])
    )
    assume(standing(path, arm) is None)
    bound = min(each.speed for each in limits_bound(path, arm))
    speed = 10**magnitude * bound
    try:
        motion, kept = SpeedDemand(speed=speed).timed(path, arm)
    except mp.errors.InvalidInputError as refused:
        assert magnitude > np.log10(0.7), "limits allow this speed"
        fastest = float(re.search(r"at most ([\d.e-]+) m/s, .* limit of \w+ allows no faster", refused.allowed).group(1))
        assert fastest > 0.5 * bound
        speed = 0.9 * fastest
        motion, kept = SpeedDemand(speed=speed).timed(path, arm)
    assert kept.is_steady and max(kept.ramps) <= 0.1 * kept.length
    data, frame = arm.model.createData(), arm.model.getFrameId(arm.tool)
    t = np.linspace(kept.begin, kept.end, 4001)
    speeds = []
    for q, qd in zip(motion(t), motion(t, 1), strict=True):
        pin.forwardKinematics(arm.model, data, q, qd)
        speeds.append(np.linalg.norm(pin.getFrameVelocity(arm.model, data, frame, pin.LOCAL).linear))
    assert min(speeds) >= 0.9899 * speed and max(speeds) <= speed * (1 + 1e-3)
    assert worst(motion, arm.limits) <= 1 + 1e-6
