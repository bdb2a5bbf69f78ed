"""The fastest motion along a straight line, against closed forms and the general solver; time that grows with the pieces."""

import time

import numpy as np
import pytest
from examples import examples
from hypothesis import given
from hypothesis import strategies as st

import manipplan as mp
from manipplan.timing.verify import jerk_use, limit_use

ARM = mp.planar_arm([1.0, 1.0])
POSITIVE = st.floats(0.05, 50.0).map(lambda x: round(x, 4))


def limited(velocity, acceleration, jerk=np.inf):
    return ARM.with_limits(velocity=velocity, acceleration=acceleration, jerk=jerk)


def bang_bang(way, v, a):
    """The shortest time from rest to rest without limited jerk."""
    return way / v + v / a if way >= v * v / a else 2 * np.sqrt(way / a)


def fastest_with_jerk(way, v, a, j):
    """The shortest time with limited jerk, by bisection over the largest speed: an independent form."""

    def ramp(speed):
        return speed / a + a / j if speed * j >= a * a else 2 * np.sqrt(speed / j)

    if ramp(v) * v <= way:
        return way / v + ramp(v)
    low, high = 0.0, v
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if ramp(middle) * middle < way else (low, middle)
    return 2 * ramp(low)


@examples(300)
@given(way=st.floats(1e-5, 300.0), v=POSITIVE, a=POSITIVE)
def test_one_joint_without_limited_jerk(way, v, a):
    arm = limited(v, a)
    motion = mp.retime(mp.JointPath.line([0.0, 0.0], [way, 0.0]), arm)
    assert motion.duration == pytest.approx(bang_bang(way, v, a), rel=1e-4, abs=2e-4)
    use = limit_use(motion, arm.limits)
    assert use["velocity"].ratio <= 1 + 1e-12 and use["acceleration"].ratio <= 1 + 1e-12
    assert len(motion.t) <= min(3 + motion.duration / 0.02, 303) + 1


@examples(300)
@given(way=st.floats(1e-5, 300.0), v=POSITIVE, a=POSITIVE, j=st.floats(1.0, 500.0))
def test_one_joint_with_limited_jerk(way, v, a, j):
    arm = limited(v, a, j)
    motion = mp.retime(mp.JointPath.line([0.0, 0.0], [0.0, way]), arm)
    assert motion.duration == pytest.approx(fastest_with_jerk(way, v, a, j), rel=1e-4, abs=6e-4)
    use = limit_use(motion, arm.limits)
    assert use["velocity"].ratio <= 1 + 1e-12 and use["acceleration"].ratio <= 1 + 1e-12
    assert jerk_use(motion, arm.limits).ratio <= 1 + 1e-9
    assert len(motion.t) <= min(7 + motion.duration / 0.02, 307) + 1
    np.testing.assert_array_equal(motion.q[[0, -1]], [[0.0, 0.0], [0.0, way]])
    np.testing.assert_array_equal(motion.qd[[0, -1]], 0.0)


@examples(60)
@given(
    goal=st.tuples(*[st.floats(-3.0, 3.0).map(lambda x: round(x, 3))] * 2).filter(lambda x: max(map(abs, x)) > 1e-2),
    limits=st.tuples(*[POSITIVE] * 4),
    bends=st.integers(0, 3),
)
def test_several_joints_and_pieces_on_one_line(goal, limits, bends):
    """The slowest joint decides; pieces of one line, of any degree and pace, are one line."""
    velocity, acceleration = limits[:2], limits[2:]
    arm = limited(velocity, acceleration)
    share = np.linspace(0.0, 1.0, bends + 2) ** 2
    points = np.outer(share, goal)
    middle = points[:-1] + 0.3 * np.diff(points, axis=0)
    path = mp.JointPath(breaks=np.linspace(0, 1, bends + 2), control=np.stack([points[:-1], middle, points[1:]], axis=1))
    motion = mp.retime(path, arm)
    unit = np.abs(goal) / np.linalg.norm(goal)
    with np.errstate(divide="ignore"):
        v, a = (float(np.min(np.array(each) / unit)) for each in (velocity, acceleration))
    assert motion.duration == pytest.approx(bang_bang(float(np.linalg.norm(goal)), v, a), rel=1e-6)
    t = np.linspace(0.0, motion.duration, 50)
    across = np.array([-goal[1], goal[0]]) / np.linalg.norm(goal)
    assert np.abs(motion(t) @ across).max() < 1e-12


@pytest.mark.parametrize("jerk", [np.inf, 30.0])
def test_no_slower_than_the_general_solver(jerk):
    """A path that bends by 1e-9 rad is timed by the general solver."""
    arm = limited(2.0, 4.0, jerk)
    line = mp.retime(mp.JointPath.line([0.0, 0.0], [3.0, 1.0]), arm)
    control = np.array([[[0.0, 0.0], [1.0, 1 / 3 + 1e-9], [2.0, 2 / 3], [3.0, 1.0]]])
    bent = mp.retime(mp.JointPath(breaks=[0.0, 1.0], control=control), arm)
    assert len(bent.t) > 300 > len(line.t)
    assert line.duration <= bent.duration * (1 + 1e-9)
    assert bent.duration <= line.duration * 1.003


def test_a_line_that_goes_back_stops_where_it_turns():
    arm = limited(2.0, 4.0)
    control = np.array([[[0.0, 0.0], [2.0, 0.0]], [[2.0, 0.0], [1.0, 0.0]]])
    motion = mp.retime(mp.JointPath(breaks=[0.0, 0.5, 1.0], control=control), arm)
    assert motion.duration == pytest.approx(bang_bang(2.0, 2.0, 4.0) + bang_bang(1.0, 2.0, 4.0), rel=1e-6)


@pytest.mark.parametrize(
    "options",
    [{"segments": [mp.Segment(begin=0.2, end=0.4, velocity=0.5)]}, {"torque": True}, {"end_speed": 0.5}],
    ids=["segment", "torque", "end speed"],
)
def test_limits_that_change_along_a_line_take_the_general_solver(options):
    arm = limited(2.0, 4.0).with_limits(effort=1e3)
    motion = mp.retime(mp.JointPath.line([0.0, 0.0], [2.0, 1.0]), arm, **options)
    assert len(motion.t) > 300


@pytest.mark.slow
@pytest.mark.parametrize("jerk", [np.inf, 50.0])
def test_chords_of_a_circle_take_time_in_proportion(jerk):
    """F11 of reviews/field.md: 1,000 chords took 8.6 s, and four times as long for twice as many."""
    arm, seconds = limited(2.0, 4.0, jerk), []
    for count in (500, 2000):
        u = np.linspace(0.0, 2 * np.pi, count + 1)
        path = mp.JointPath.through(0.5 * np.column_stack([np.cos(u), np.sin(u)]))
        began = time.process_time()
        motion = mp.retime(path, arm)
        seconds.append(time.process_time() - began)
        chord = np.pi / count * np.abs(np.column_stack([np.sin((u[1:] + u[:-1]) / 2), np.cos((u[1:] + u[:-1]) / 2)]))
        unit = chord / np.linalg.norm(chord, axis=1)[:, None]
        way = 2 * 0.5 * np.sin(np.pi / count)
        ideal = sum(
            fastest_with_jerk(way, 2 / x, 4 / x, jerk / x) if jerk < 1e9 else bang_bang(way, 2 / x, 4 / x)
            for x in unit.max(axis=1)
        )
        assert motion.duration == pytest.approx(ideal, rel=1e-5)
        assert len(motion.t) <= 7 * count + 1 + motion.duration / 0.02
    assert seconds[1] < 8 * seconds[0]


def test_way_points_that_are_one_but_for_rounding_of_the_line():
    """F21 of reviews/field.md: a long line was 0.35 % slower than the closed form."""
    arm = limited(2.0, 4.0)
    for way in (2.0, 20.0, 200.0):
        assert mp.retime(mp.JointPath.line([0, 0], [way, 0]), arm).duration == pytest.approx(bang_bang(way, 2.0, 4.0), rel=1e-8)
