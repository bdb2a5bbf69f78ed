"""Inverse kinematics and workspaces of the planar arm against brute force."""

import itertools

import numpy as np
import pytest
from scipy.spatial import cKDTree

import manipplan as mp
from manipplan import planar

UNIT = planar.PlanarArm([1.0, 1.0, 1.0])
H = np.pi / 2
#: Three links and angle limits: the thesis' (5.6), one-sided ones, a joint that turns freely.
LIMITED = [
    ([1.0, 1.0, 1.0], [-H, -H, -H], [H, H, H]),
    ([1.0, 0.6, 0.3], [-0.4, 0.2, -2.0], [1.1, 2.4, 0.5]),
    ([0.5, 0.8, 0.4], [-np.inf, -2.5, 0.3], [np.inf, 0.0, 1.9]),
]


def test_pose_postures_reach_the_pose_and_are_all(rng):
    arm = planar.PlanarArm([0.8, 0.5, 0.3])
    for q in rng.uniform(-np.pi, np.pi, (200, 3)):
        found = planar.pose_postures(arm, arm.position(q), float(arm.orientation(q)))
        assert found.shape == (2, 3)
        assert found[0, 1] > 0 > found[1, 1]
        np.testing.assert_allclose(arm.position(found), np.tile(arm.position(q), (2, 1)), atol=1e-12)
        np.testing.assert_allclose(np.exp(1j * arm.orientation(found)), np.exp(1j * arm.orientation(q)), atol=1e-12)
        assert np.abs(np.exp(1j * found) - np.exp(1j * q)).max(axis=1).min() < 1e-7  # q itself is one of them


def test_postures_at_the_border_and_beyond():
    two, arm = planar.PlanarArm([1.0, 0.4]), planar.PlanarArm([1.0, 1.0, 0.5])
    assert len(planar.two_link_postures(two, [1.41, 0])) == 0
    assert len(planar.two_link_postures(two, [0.3, 0.3])) == 0
    np.testing.assert_allclose(planar.two_link_postures(two, [0, 1.4]), [[H, 0]], atol=1e-7)
    np.testing.assert_allclose(planar.two_link_postures(two, [0.6, 0]), [[0, np.pi]], atol=1e-7)
    assert len(planar.pose_postures(arm, [2.6, 0], 0.0)) == 0
    folded = planar.pose_postures(arm, [0.5, 0.0], 0.0)  # the third joint falls on the base
    np.testing.assert_allclose(arm.position(folded), [[0.5, 0]], atol=1e-12)


@pytest.mark.slow
def test_the_family_of_a_position_by_scanning(rng):
    for lengths in ([1.0, 1.0, 1.0], [1.0, 0.3, 0.5], [0.2, 0.9, 0.4], [0.3, 0.3, 2.0]):
        arm = planar.PlanarArm(lengths)
        for radius in rng.uniform(0, arm.lengths.sum() * 1.05, 12):
            direction = rng.uniform(-np.pi, np.pi)
            family = planar.position_family(arm, radius * np.array([np.cos(direction), np.sin(direction)]))
            phi = np.linspace(-np.pi, np.pi, 721)
            inside = [any(b <= p + k <= e for b, e in family.orientations for k in (-2 * np.pi, 0, 2 * np.pi)) for p in phi]
            assert inside == [len(family(p)) > 0 for p in phi]


@pytest.mark.slow
def test_reachable_annulus_by_sampling(rng):
    for lengths in ([1.0, 1.0, 1.0], [2.0, 0.3, 0.4], [0.2, 0.5, 1.6, 0.3]):
        arm = planar.PlanarArm(lengths)
        ring = planar.reachable_annulus(arm)
        position = arm.position(rng.uniform(-np.pi, np.pi, (300_000, arm.n)))
        assert ring.contains(position * (1 - 1e-12 * np.sign(np.hypot(*position.T) - ring.inner - 1e-9))[:, None]).all()
        radius = np.hypot(*position.T)
        bins = np.histogram(radius, bins=25, range=(ring.inner, ring.outer))[0]
        assert (bins > 0).all()
        assert planar.reachable_radii(arm) == pytest.approx((ring.inner, ring.outer))


@pytest.mark.slow
@pytest.mark.parametrize("lengths", [[1, 1, 1], [1.0, 0.7, 0.5], [0.9, 0.2, 0.3], [0.5, 0.6, 1.5], [0.7, 0.7, 0.9, 0.4]])
def test_dexterous_workspace_by_sampling(lengths, rng):
    """Postures thrown at random fill every orientation at the radii of the dexterous workspace, and only there."""
    arm = planar.PlanarArm(lengths)
    q = rng.uniform(-np.pi, np.pi, (2_000_000, arm.n))
    position = arm.position(q)
    relative = np.mod(arm.orientation(q) - np.arctan2(position[:, 1], position[:, 0]), 2 * np.pi)
    edges = np.linspace(0, arm.lengths.sum(), 61)
    filled = np.histogram2d(np.hypot(*position.T), relative, bins=(edges, 72))[0] > 0
    rings = planar.dexterous_annuli(arm)
    for low, high, row in zip(edges, edges[1:], filled, strict=False):
        if any(ring.inner <= low and high <= ring.outer for ring in rings):
            assert row.all()
        near = edges[1]  # beside a ring the gap in the orientations is still narrower than the bins
        if not any(ring.inner - near < high and low < ring.outer + near for ring in rings):
            assert not row.all()
    kept = sum(ring.area for ring in rings)
    assert kept <= planar.reachable_annulus(arm).area


def test_two_links_are_dexterous_at_most_at_the_base():
    assert planar.dexterous_annuli(planar.PlanarArm([1.0, 0.5])) == ()
    assert planar.dexterous_annuli(planar.PlanarArm([0.5, 0.5])) == (planar.Annulus(inner=0.0, outer=0.0),)


def throw(arm, lower, upper, count, rng):
    low, high = np.where(np.isinf(lower), -np.pi, lower), np.where(np.isinf(upper), np.pi, upper)
    return rng.uniform(low, high, (count, arm.n))


@pytest.mark.slow
@pytest.mark.parametrize(("lengths", "lower", "upper"), LIMITED)
def test_reach_under_limits_by_sampling(lengths, lower, upper, rng):
    arm = planar.PlanarArm(lengths)
    q = throw(arm, lower, upper, 400_000, rng)
    tree = cKDTree(arm.position(q))
    assert all(planar.is_reachable(arm, p, lower, upper) for p in arm.position(q[:150]))
    size = arm.lengths.sum()
    places = rng.uniform(-size, size, (300, 2))
    distance = tree.query(places)[0]
    reachable = np.array([planar.is_reachable(arm, p, lower, upper) for p in places])
    assert distance[reachable].max() < 0.05 * size  # a sample lies near
    arcs = planar.workspace_boundary(arm, lower, upper)
    dense = np.concatenate([arc(np.linspace(0, 1, 20_000)) for arc in arcs])
    np.testing.assert_array_less(cKDTree(dense).query(places[~reachable])[0] - 1e-4, distance[~reachable])
    # no sample lies nearer to a place out of reach than the boundary does
    radii = np.hypot(*arm.position(q).T)
    least, most = planar.reachable_radii(arm, lower, upper)
    assert least - 1e-9 <= radii.min() < least + 0.03 * size
    assert most - 0.03 * size < radii.max() <= most + 1e-9


@pytest.mark.slow
@pytest.mark.parametrize(("lengths", "lower", "upper"), LIMITED)
def test_the_boundary_parts_what_is_reached_from_what_is_not(lengths, lower, upper, rng):
    """Along straight lines, reachable changes only at a crossing of the boundary's arcs."""
    arm = planar.PlanarArm(lengths)
    arcs = planar.workspace_boundary(arm, lower, upper)
    size = arm.lengths.sum()
    tree = cKDTree(np.concatenate([arc(np.linspace(0, 1, 2000)) for arc in arcs]))
    changes = 0
    for _ in range(25):
        a, b = rng.uniform(-size, size, (2, 2))
        line = a + np.linspace(0, 1, 60)[:, None] * (b - a)
        state = np.array([planar.is_reachable(arm, p, lower, upper) for p in line])
        step = np.linalg.norm(b - a) / 59
        for k in np.flatnonzero(state[1:] != state[:-1]):
            changes += 1
            assert tree.query((line[k] + line[k + 1]) / 2)[0] <= step / 2 + 0.005 * size
    assert changes > 5


@pytest.mark.slow
@pytest.mark.parametrize(("lengths", "lower", "upper"), LIMITED)
def test_orientations_under_limits_by_scanning(lengths, lower, upper, rng):
    arm = planar.PlanarArm(lengths)
    low, high = (np.array(limit, dtype=float) for limit in (lower, upper))
    gaps = []
    for q in throw(arm, lower, upper, 1000, rng):
        position = arm.position(q)
        intervals = planar.reachable_orientations(arm, position, lower, upper)
        assert any(abs(np.mod(arm.orientation(q) - b + 1e-9, 2 * np.pi) - 1e-9) <= e - b + 1e-9 for b, e in intervals)
        gaps += [b - e for (_, e), (b, _) in itertools.pairwise(sorted(intervals))]
        ends = [end + side for interval in intervals for end in interval for side in (-1e-6, 1e-6)]
        for phi in [*rng.uniform(-np.pi, np.pi, 10), *ends]:
            rows = planar.pose_postures(arm, position, phi)
            shifted = rows[:, None] + 2 * np.pi * np.arange(-2, 3)[None, :, None]
            truth = bool(((shifted >= low) & (shifted <= high)).any(axis=1).all(axis=-1).any())
            assert truth == any(np.mod(phi - b, 2 * np.pi) <= e - b for b, e in intervals)
    assert not gaps or min(gaps) > 0


def test_dexterous_under_limits():
    assert planar.is_dexterous(UNIT, [0.5, 0.0])
    assert planar.is_dexterous(UNIT, [0.0, 0.999])
    assert not planar.is_dexterous(UNIT, [0.0, 1.001])
    assert not planar.is_dexterous(UNIT, [0.0, 1.5], -H, H)


def test_equal_links_folded_onto_each_other(rng):
    """There one orientation belongs to a whole circle of θ_1: each of them is found under tight limits, none beside."""
    arm, two = planar.PlanarArm([0.7, 0.7, 0.4]), planar.PlanarArm([0.7, 0.7])
    for first, third in rng.uniform(-9, 9, (50, 2)):
        q = np.array([first, np.pi, third])
        tight, beside = np.full(3, 1e-3), np.array([0.0, 0.0, 2e-3])
        assert planar.is_reachable(arm, arm.position(q), q - tight, q + tight)
        assert not planar.is_reachable(arm, arm.position(q), q - tight + 2 * beside, q + tight + 2 * beside)
        assert planar.is_reachable(two, two.position(q[:2]), q[:2] - 1e-3, q[:2] + 1e-3)
    assert not planar.is_reachable(two, [0.0, 0.0], -1.0, 1.0)


def test_the_thesis_limits_leave_radii_from_1_to_3():
    """Section 5.5 in kth2012: "R in [1, 3]"."""
    assert planar.reachable_radii(UNIT, -H, H) == pytest.approx((1.0, 3.0), abs=1e-12)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: planar.pose_postures(planar.PlanarArm([1, 1]), [1, 1], 0.0), "3 links"),
        (lambda: planar.two_link_postures(UNIT, [1, 1]), "2 links"),
        (lambda: planar.pose_postures(UNIT, [1, np.nan], 0.0), "position: got"),
        (lambda: planar.pose_postures(UNIT, [1, 1], np.inf), "orientation: got"),
        (lambda: planar.is_reachable(planar.PlanarArm([1] * 4), [1, 1]), "2 to 3 links"),
        (lambda: planar.workspace_boundary(UNIT, 1.0, -1.0), "lower, upper: got"),
        (lambda: planar.workspace_boundary(UNIT, [0.0, 0.0], 1.0), "lower: got"),
        (lambda: planar.reachable_radii(UNIT, np.nan, 1.0), "lower: got"),
    ],
)
def test_wrong_arguments(call, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        call()
