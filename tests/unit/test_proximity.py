"""Looks along a curve: the compiled search finds what a search by NumPy finds, and no place of a bracket is nearer."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import manipplan as mp
from manipplan.collision import proximity
from manipplan.collision.kernel import DistanceKernel
from manipplan.collision.proximity import (
    BOTTOM,
    BOTTOM_STEPS,
    CLOSE,
    DEEP,
    FARTHEST,
    INTERVALS,
    SPACING,
    DistanceSearch,
)
from manipplan.paths.joint import JointPath
from manipplan.paths.rounding import FINE, FINE_DISTANCE, on_grid

S = np.linspace(0.0, 1.0, INTERVALS + 1)
START, GOAL = [-0.6, 0.3, 0.0, -2.0, 0.0, 2.3, 0.8], [0.9, 0.2, -0.2, -2.1, 0.3, 2.2, 0.8]


@pytest.fixture(scope="module")
def through_a_post(panda):
    """A search, and a curve through a post."""
    scene = mp.Scene([mp.Box(size=(0.1, 0.1, 0.6), position=(0.45, 0.0, 0.3), name="post")])
    return DistanceSearch(scene.collision_model(panda)), JointPath.line(START, GOAL).curve()


def measured(search, curve, s, pairs):
    return on_grid(search.model.pair_distances(curve(np.asarray(s), FINE), pairs), FINE_DISTANCE)


def bottom(search, curve, pair, low, middle, high, distances):
    """Place and distance of the bottom in one bracket, one step after the other."""
    left, least, right = distances
    for step in range(BOTTOM_STEPS):
        if not high - low >= BOTTOM:
            break
        a, b = middle - low, high - middle
        change = longer = -a / 2 if a > b else b / 2
        with np.errstate(divide="ignore", invalid="ignore"):
            falls, rises = np.divide(left - least, a), np.divide(right - least, b)
            parabola = (b * falls - a * rises) / (2 * (falls + rises))
        if step % 3 < 2 and np.isfinite(parabola) and -a < parabola < b:
            change = parabola
        gap = max(0.02 * (a + b), BOTTOM / 4)
        change = np.copysign(gap, longer) if abs(change) < gap else change
        new = min(max(middle + change, low), high)
        value = measured(search, curve, [new], [pair])[0]
        end = (middle, least) if value < least else (new, value)
        if (value < least) == (new > middle):
            low, left = end
        else:
            high, right = end
        if value < least:
            middle, least = new, value
    return middle, least


def by_numpy(search, curve, target, band, known=()):
    """The places that a look finds: distance, s, pair, and whether it is a bottom, in order."""
    rows = on_grid(search.model.distance_rows(curve(S, FINE)), FINE_DISTANCE)
    most, found, brackets = target + FARTHEST, [], []
    for k, pair in zip(*np.nonzero(rows < target + max(band, FARTHEST)), strict=True):
        if rows[k, pair] >= (target + max(band, FARTHEST) if k % SPACING == 0 else most):
            continue
        if rows[k, pair] < target + CLOSE or (k % SPACING == 0 and rows[k, pair] < target + band):
            found.append((rows[k, pair], S[k], pair, False))
        here, last = min(rows[k, pair], most), k == INTERVALS
        before = min(rows[k - 1, pair], most) if k > 0 else np.inf
        after = min(rows[k + 1, pair], most) if not last else np.inf
        rise = max(side for side in (before, after) if np.isfinite(side)) - here
        if before >= here and after > here and here - rise < target + DEEP:
            brackets.append((pair, S[max(k - 1, 0)], S[k], S[min(k + 1, INTERVALS)]))
    brackets += [(pair, max(at - 1 / INTERVALS, 0.0), at, min(at + 1 / INTERVALS, 1.0)) for at, pair in known]
    for pair, *places in brackets:
        at, least = bottom(search, curve, pair, *places, measured(search, curve, places, [pair] * 3))
        found.append((least, at, pair, True))
    return sorted(found)


def same(found, wanted, exact=1e-11):
    assert len(found.s) == len(wanted)
    distances, s, pairs, is_bottom = zip(*wanted, strict=True)
    np.testing.assert_array_equal(found.pairs, pairs)
    np.testing.assert_array_equal(found.is_bottom, is_bottom)
    np.testing.assert_allclose(found.s, s, rtol=0, atol=1e-8)
    np.testing.assert_allclose(found.distances, distances, rtol=0, atol=exact)


@pytest.mark.parametrize("band", [2e-3, 0.02, 0.1])
@pytest.mark.parametrize("target", [0.0, 0.01])
def test_a_look_finds_what_numpy_finds(through_a_post, band, target):
    search, curve = through_a_post
    first = search.find_near(curve, target, band)
    known = [(0.0, int(first.pairs[0])), (0.3777, int(first.pairs[-1])), (1.0, int(first.pairs[0]))]
    found = search.find_near(curve, target, band, known)
    assert found.is_bottom.any() and not found.is_bottom.all()
    assert (np.diff(found.distances) >= 0).all() and found.least == found.distances[0] < -0.01
    same(found, by_numpy(search, curve, target, band, known))


def test_bottoms_are_the_nearest_places_of_their_brackets(through_a_post):
    search, curve = through_a_post
    found = search.find_near(curve, 0.0, 2e-3)
    bottoms = np.flatnonzero(found.is_bottom)
    assert len(bottoms) > 2
    for k in bottoms:
        fine = np.linspace(max(found.s[k] - 1 / INTERVALS, 0.0), min(found.s[k] + 1 / INTERVALS, 1.0), 201)
        distances = measured(search, curve, fine, np.full(len(fine), found.pairs[k]))
        inside = np.abs(fine - found.s[k]) < 0.4 / INTERVALS
        assert found.distances[k] <= distances[inside].min() + 1e-4  # depths of overlaps have several minima


@pytest.mark.slow
def test_bottoms_at_kinks_are_located(panda):
    """The arm turns about its base past an edge of a box, at 0.1 mm: its distance is first to one face, then to the other."""
    start, goal = np.array(START) * [0, 1, 1, 1, 1, 1, 1], np.array(START) * [0, 1, 1, 1, 1, 1, 1]
    start[0], goal[0] = -0.43, 0.57
    curve, dense = JointPath.line(start, goal).curve(), np.linspace(0.0, 1.0, 2001)
    turned, radius = Rotation.from_euler("z", 45, degrees=True).as_matrix(), 1.2
    for _ in range(12):  # towards the arm
        box = mp.Box(size=(0.1, 0.1, 2.0), position=(radius, 0.0, 0.5), rotation=turned, name="post")
        search = DistanceSearch(mp.Scene([box]).collision_model(panda))
        pairs = [k for k, names in enumerate(search.model.pair_names) if "post" in names]
        radius -= min(measured(search, curve, dense, np.full(len(dense), pair)).min() for pair in pairs) - 1e-4
    found = search.find_near(curve, 0.0, 2e-3)
    lowest = np.flatnonzero(found.is_bottom & np.isin(found.pairs, pairs))[0]
    near = found.s[lowest] + np.linspace(-2e-3, 2e-3, 4001)
    distances = measured(search, curve, near, np.full(len(near), found.pairs[lowest]))
    slopes = np.diff(distances) / np.diff(near)
    assert slopes[-1] > 0.05 and slopes[0] < -0.05, "no kink: this test needs another box"
    assert 5e-5 < found.distances[lowest] <= distances.min() + 1e-9


def test_there_is_room_for_many_near_places(through_a_post, monkeypatch):
    search, curve = through_a_post
    whole = by_numpy(search, curve, 0.0, 0.1)
    monkeypatch.setattr(proximity, "ROOM", 1)
    few = DistanceSearch(search.model)
    same(few.find_near(curve, 0.0, 0.1), whole)
    assert len(few.find_near(curve, 0.0, 0.1, [(0.5, whole[0][2])] * 50).s) == len(whole) + 50
    same(few.find_near(curve, 0.0, 0.1), whole)


@pytest.mark.parametrize("band", [2e-3, 0.1])
def test_coal_is_asked_where_the_kernel_cannot_tell(panda, band):
    """A cylinder that a link meets in its middle, and a mesh that it overlaps."""
    scene = mp.Scene([mp.Cylinder(radius=0.05, length=0.6, position=(0.45, 0.0, 0.3), name="post")])
    search, curve = DistanceSearch(scene.collision_model(panda)), JointPath.line(START, GOAL).curve()
    asked = []
    notify = search.model.pair_distances

    def listening(q, pairs, **options):
        asked.append(len(q))
        return notify(q, pairs, **options)

    search.model.pair_distances = listening
    found = search.find_near(curve, 0.0, band, [(0.5, 0)])
    assert sum(asked) > 0, "the kernel tells all distances: this test needs another scene"
    same(found, by_numpy(search, curve, 0.0, band, [(0.5, 0)]), exact=2e-6)  # coal's tolerance


def test_nothing_is_near_far_from_everything(panda):
    far = mp.Scene([mp.Sphere(radius=0.01, position=(5.0, 0.0, 0.0))]).collision_model(panda)
    still = JointPath.line(START, np.add(START, 0.01))
    found = DistanceSearch(far).find_near(still.curve(), -0.02, 1e-3)
    assert len(found.s) == 0 and found.least == np.inf


def test_searches_of_one_model_do_not_share_memory(through_a_post):
    search, curve = through_a_post
    other = DistanceSearch(search.model)
    assert isinstance(other._kernel, DistanceKernel) and other._kernel is not search._kernel
    first = search.find_near(curve, 0.0, 0.1)
    other.find_near(curve, 0.01, 2e-3)
    np.testing.assert_array_equal(first.distances, search.find_near(curve, 0.0, 0.1).distances)


@given(st.integers(0, 10_000))
@settings(max_examples=8, deadline=None)
def test_dips_of_single_points_of_a_cloud_are_found(panda, seed):
    """Points that stand side by side are passed one after another: each has its own dip, also where another one is nearer."""
    rng = np.random.default_rng(seed)
    curve = JointPath.line(START, GOAL).curve()
    middle = panda.kinematics().pose(curve(np.array([0.5])))[0, :3, 3]
    points = middle + [0.0, 0.0, -0.11] + np.column_stack([rng.uniform(-0.02, 0.02, (12, 2)), np.zeros(12)])
    cloud = mp.PointCloud(points=points, radius=1e-3, name="cloud")
    search = DistanceSearch(mp.Scene([cloud]).collision_model(panda))
    target = search.model.least_distance(curve(np.linspace(0.0, 1.0, 2001)))[0]
    found = search.find_near(curve, target, 2e-3)
    of_leaf = found.leaves >= 0
    assert of_leaf.any() and found.is_bottom[of_leaf].all()
    near = set(zip(found.pairs[of_leaf].tolist(), found.leaves[of_leaf].tolist(), strict=True))
    assert len(near) == of_leaf.sum() > 1
    fine = np.linspace(0.0, 1.0, 4001)
    for pair, leaf, s, distance in zip(
        *(each[of_leaf] for each in (found.pairs, found.leaves, found.s, found.distances)), strict=True
    ):
        around = fine[np.abs(fine - s) < 1.0 / INTERVALS]
        alone = search.model.witnesses(curve(around), np.full(len(around), pair), np.full(len(around), leaf)).distances
        assert alone.min() >= distance - 1e-6 and alone.min() <= distance + 1e-4
        whole = search.model.pair_distances(curve(np.array([s]), FINE), [pair])[0]
        assert whole <= distance + 1e-9
