"""Points that are one but for rounding make no corner, no stop and no bow."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import manipplan as mp
from manipplan.paths.tolerance import distinct
from manipplan.timing.stops import MovingPath, stops

ARM = mp.planar_arm([1.0, 1.0]).with_limits(velocity=2.0, acceleration=4.0)
GAPS = st.floats(-15, -6.1).map(lambda exponent: 10**exponent)
SEEDS = st.integers(0, 10**6)


@pytest.mark.parametrize("gap", [0.0, 1e-12, 1e-10, 1e-9, 1e-8, 1e-7, 9e-7])
def test_a_repeated_waypoint_makes_no_stop(gap):
    """F09 of the field reports: 1 rad at 4 rad/s² from rest to rest takes 1 s."""
    way = [[0, 0], [0.5, 0.1], [0.5 + gap, 0.1], [1, 0.2]]
    assert mp.retime(mp.JointPath.through(way), ARM).duration == pytest.approx(1.0, abs=1e-5)


@settings(max_examples=25, deadline=None)
@given(SEEDS, GAPS, st.integers(2, 8), st.integers(1, 7))
def test_repeated_points_are_one(seed, gap, count, n):
    rng = np.random.default_rng(seed)
    points = np.cumsum(rng.uniform(0.01, 0.5, (count, n)), axis=0)
    again = []
    for point in points:
        again += [point, *(point + gap * rng.uniform(-0.5, 0.5, n) / np.sqrt(n) for _ in range(rng.integers(0, 3)))]
    again[-1] = points[-1]
    path = mp.JointPath.through(again)
    assert len(path.breaks) == count
    np.testing.assert_allclose(path(mp.JointPath.through(points).breaks), points, atol=2e-6)
    np.testing.assert_array_equal([path.start, path.goal], [points[0], points[-1]])


@given(st.lists(st.floats(0, 1e-5), min_size=1, max_size=40))
def test_what_is_kept_is_apart_and_stands_for_the_rest(values):
    x = np.cumsum(values)
    kept = distinct(len(x), lambda i, j: np.abs(x[i] - x[j]))
    assert kept[0] == 0 and (np.diff(kept) > 0).all()
    assert (np.diff(x[kept]) >= 1e-6).all()
    assert np.abs(x[:, None] - x[kept]).min(axis=1).max() < 2e-6
    assert kept[-1] == len(x) - 1 or x[-1] - x[0] < 1e-6


@settings(max_examples=20, deadline=None)
@given(SEEDS, GAPS, st.sampled_from([1, 3]))
def test_pieces_that_stand_still_are_left_out(seed, gap, degree):
    """A path from a file, or made piece by piece, with pieces as short as rounding, also at its ends."""
    rng = np.random.default_rng(seed)
    ends = np.array([[0.0, 0.0], [0.3, 0.06], [0.7, 0.14], [1.0, 0.2]])
    points = []
    for end in ends:
        points += [end, end + gap * rng.uniform(-0.5, 0.5, 2)]
    points = np.array(points)
    share = np.linspace(0, 1, degree + 1)[:, None]
    control = np.array([a + share * (b - a) for a, b in itertools.pairwise(points)])
    path = mp.JointPath(breaks=np.linspace(0, 1, len(points)), control=control)
    course = MovingPath(path)
    assert stops(course.path, 1e-6) == [0.0, 1.0]
    np.testing.assert_array_equal([course.path.start, course.path.goal], [path.start, path.goal])
    motion = mp.retime(path, ARM)
    assert motion.duration == pytest.approx(1.0, abs=1e-3)
    np.testing.assert_allclose(motion.q[[0, -1]], [path.start, path.goal], atol=1e-12)


def test_many_short_pieces_are_not_lost():
    """Each piece is one with the one before, but all together are not."""
    points = np.linspace([0, 0], [4e-5, 2e-5], 100)
    path = mp.JointPath(breaks=np.linspace(0, 1, 100), control=np.stack([points[:-1], points[1:]], axis=1))
    course = MovingPath(path)
    assert course.path.length == pytest.approx(path.length, rel=1e-6)
    assert len(mp.JointPath.through(points).breaks) > 10


@settings(max_examples=20, deadline=None)
@given(SEEDS, GAPS)
def test_a_spline_takes_knots_that_are_one_as_one(seed, gap):
    rng = np.random.default_rng(seed)
    s = np.linspace(0, 1, 6)
    q = np.cumsum(rng.normal(scale=0.3, size=(6, 3)), axis=0)
    more = np.insert(s, 3, s[2] + gap), np.insert(q, 3, q[2] + gap * rng.uniform(-0.5, 0.5, 3), axis=0)
    one, other = mp.JointPath.spline(s, q), mp.JointPath.spline(*more)
    t = np.linspace(0, 1, 300)
    np.testing.assert_allclose(other(t), one(t), atol=1e-5)


@pytest.mark.parametrize("way", [[[0, 0], [0, 0]], [[0, 0], [1e-8, 0], [0, 1e-9]], [[0.1, 0.2]]])
def test_one_point_is_no_path(way):
    with pytest.raises(mp.errors.InvalidInputError, match="waypoints: .*at least two points"):
        mp.JointPath.through(way)
