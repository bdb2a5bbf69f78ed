"""Closed-form distances of capsules and spheres: against coal, brute force and what a distance must obey."""

from functools import cache

import casadi as ca
import coal
import numpy as np
import pytest
from examples import examples
from hypothesis import example, given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from manipplan.symbolic.machine_code import compiled
from manipplan.tracking.bodies import SymbolicBox, SymbolicCapsule, SymbolicPlane, nearest

FIRST = ["sphere", "capsule"]
SECOND = ["sphere", "capsule", "box", "plane"]
RADIUS, HALF = 0.12, (0.3, 0.2, 0.45)
RADII = {"sphere": 0.25, "capsule": 0.08, "box": 0.0, "plane": 0.0}
PAIRS = pytest.mark.parametrize(("first", "second"), [(f, s) for f in FIRST for s in SECOND])
X, Y, Z = np.eye(3)


@cache
def function(first, second, half=HALF):
    """(a, b, R, c, d) to (distance, normal, point, point); what a shape has no use for is ignored."""
    a, b, c, d = (ca.SX.sym(name, 3) for name in "abcd")
    rotation = ca.SX.sym("R", 3, 3)
    mine = SymbolicCapsule(start=a, end=b if first == "capsule" else None, radius=RADIUS)
    other = {
        "sphere": SymbolicCapsule(start=c, radius=RADII["sphere"]),
        "capsule": SymbolicCapsule(start=c, end=d, radius=RADII["capsule"]),
        "box": SymbolicBox(rotation=rotation, centre=c, half=half),
        "plane": SymbolicPlane(normal=rotation[:, 2], offset=ca.dot(rotation[:, 2], c)),
    }[second]
    found = nearest(mine, other)
    outputs = [found.distance, found.normal, found.first, found.second]
    return ca.Function(f"{first}_{second}", [a, b, rotation, c, d], outputs)


def evaluate(first, second, pairs, of=None):
    """Distances (k,), normals and points (k, 3) of k pairs."""
    a, b, rotation, c, d = pairs
    flat = np.concatenate(list(rotation), axis=1)
    distance, *vectors = (of or function(first, second))(a.T, b.T, flat, c.T, d.T)
    return np.array(distance)[0], *(np.array(v).T for v in vectors)


def random_pairs(rng, count, spread=1.0):
    a, c = rng.normal(scale=spread, size=(2, count, 3))
    b, d = a + rng.normal(scale=0.5, size=(count, 3)), c + rng.normal(scale=0.5, size=(count, 3))
    return a, b, Rotation.random(count, rng=rng).as_matrix(), c, d


def one(a, b=None, c=(0, 0, 0), d=(0, 0, 0), rotation=None):
    points = [np.array([p], dtype=float) for p in (a, a if b is None else b, c, d)]
    return points[0], points[1], np.array([np.eye(3) if rotation is None else rotation]), points[2], points[3]


def squared_to_core(second, pairs, point):
    """Squared distances (k,) of points (k, 3) from the second body's centre, axis, box, or signed height above the plane."""
    _, _, rotation, c, d = pairs
    if second == "sphere":
        return ((point - c) ** 2).sum(axis=1)
    if second == "capsule":
        axis = d - c
        square = (axis**2).sum(axis=1)
        t = np.clip(((point - c) * axis).sum(axis=1) / np.where(square > 0, square, 1), 0, 1)
        return ((point - c - t[:, None] * axis) ** 2).sum(axis=1)
    local = np.einsum("kji,kj->ki", rotation, point - c)
    if second == "box":
        return (np.maximum(np.abs(local) - HALF, 0) ** 2).sum(axis=1)
    return local[:, 2]


def brute_force(first, second, pairs):
    """Distances (k,) by golden sections: how far a point of the axis is from a convex body is convex along the axis."""
    a, b = pairs[0], pairs[1 if first == "capsule" else 0]
    low, high, golden = np.zeros(len(a)), np.ones(len(a)), (np.sqrt(5) - 1) / 2

    def at(s):
        return squared_to_core(second, pairs, a + s[:, None] * (b - a))

    for _ in range(80):
        left, right = high - golden * (high - low), low + golden * (high - low)
        lower = at(left) <= at(right)
        low, high = np.where(lower, low, left), np.where(lower, right, high)
    least = np.min([at(low), at(high), at(np.zeros(len(a))), at(np.ones(len(a)))], axis=0)
    return (least if second == "plane" else np.sqrt(least)) - RADIUS - RADII[second]


def coal_capsule(start, end, radius):
    turn = Rotation.align_vectors([end - start], [Z])[0].as_matrix()
    return coal.Capsule(radius, np.linalg.norm(end - start)), coal.Transform3s(turn, (start + end) / 2)


def coal_second(second, rotation, c, d):
    if second == "capsule":
        return coal_capsule(c, d, RADII[second])
    shape = {
        "sphere": coal.Sphere(RADII["sphere"]),
        "box": coal.Box(*(2 * h for h in HALF)),
        "plane": coal.Halfspace(Z, 0.0),
    }[second]
    return shape, coal.Transform3s(rotation, c)


def coal_distances(first, second, pairs):
    request = coal.DistanceRequest()
    sphere = coal.Sphere(RADIUS)
    distances = []
    for a, b, *other in zip(*pairs, strict=True):
        mine = (sphere, coal.Transform3s(np.eye(3), a)) if first == "sphere" else coal_capsule(a, b, RADIUS)
        distances.append(coal.distance(*mine, *coal_second(second, *other), request, coal.DistanceResult()))
    return np.array(distances)


def awkward_pairs(rng, count):
    """Parallel to rounding or nearly, along the box's faces, touching, of no length, of lengths near every threshold."""
    values = [0, 0, 0, 1, -1, 0.3, -0.3, 0.2, -0.2, 0.45, -0.45, 2, 1e-6, 1e-8, -1e-9, 1e-12, 1e-160, -1e-300]
    points = rng.choice(values, size=(4, count, 3))
    off = rng.normal(size=points.shape) * 10.0 ** rng.uniform(-17, -3, size=(4, count, 1))
    a, b, c, d = points + off * rng.integers(2, size=(4, count, 1))
    parallel = c + (b - a) * rng.choice([1, -1, 0.5, 2], size=(count, 1)) + off[0] * rng.integers(2, size=(count, 1))
    d = np.where(rng.random((count, 1)) < 0.4, parallel, d)
    upright = rng.random((count, 1, 1)) < 0.6
    return a, b, np.where(upright, np.eye(3), Rotation.random(count, rng=rng).as_matrix()), c, d


def shifted(pairs, by):
    return pairs[0] + by, pairs[1] + by, *pairs[2:]


def core_outside(first, second, pairs, margin):
    """Whether the axis is farther than `margin` from the second body's axis or box; no matter for a plane."""
    return (second == "plane") | (brute_force(first, second, pairs) + RADIUS + RADII[second] > margin)


def assert_consistent(found):
    distance, normal, mine, other = found
    assert all(np.isfinite(values).all() for values in found)
    np.testing.assert_allclose(np.linalg.norm(normal, axis=1), 1, atol=1e-12)
    np.testing.assert_allclose(mine - other, distance[:, None] * normal, rtol=1e-12, atol=1e-11)


@pytest.mark.slow
@PAIRS
def test_equals_coal(first, second, rng):
    """Separated, overlapping, and with the axis of one inside the other: coal, too, is exact to 1e-14 for these."""
    pairs = random_pairs(rng, 2000, 0.3)
    expected = coal_distances(first, second, pairs)
    distance = evaluate(first, second, pairs)[0]
    inside = ~core_outside(first, second, pairs, 1e-9)
    assert (distance > 0).sum() > 300
    assert ((distance < -0.01) & ~inside).sum() > 30
    assert inside.sum() > 100 or second != "box"
    np.testing.assert_allclose(distance, expected, atol=1e-10)


@pytest.mark.slow
@PAIRS
def test_equals_brute_force(first, second, rng):
    for pairs, tolerance in ((random_pairs(rng, 3000), 1e-12), (awkward_pairs(rng, 6000), 1e-7)):
        expected = brute_force(first, second, pairs)
        counts = core_outside(first, second, pairs, 1e-8)
        np.testing.assert_allclose(evaluate(first, second, pairs)[0][counts], expected[counts], atol=tolerance)


@PAIRS
def test_nearest_points_lie_on_both_surfaces(first, second, rng):
    for pairs in (random_pairs(rng, 2000, 0.4), awkward_pairs(rng, 3000)):
        found = evaluate(first, second, pairs)
        assert_consistent(found)
        _, _, mine, other = found
        a, b, rotation, c, _ = pairs
        axis = (None, None, None, a, b if first == "capsule" else a)
        np.testing.assert_allclose(np.sqrt(squared_to_core("capsule", axis, mine)), RADIUS, atol=1e-7)
        if second == "box":
            local = np.einsum("kji,kj->ki", rotation, other - c)
            np.testing.assert_allclose((np.abs(local) - HALF).max(axis=1), 0, atol=1e-8)
        elif second == "plane":
            np.testing.assert_allclose(squared_to_core(second, pairs, other), 0, atol=1e-12)
        else:
            np.testing.assert_allclose(np.sqrt(squared_to_core(second, pairs, other)), RADII[second], atol=1e-7)


@PAIRS
def test_gradient_is_the_normal(first, second, rng):
    pairs = random_pairs(rng, 2000, 0.4)
    h = 1e-7
    difference = [evaluate(first, second, shifted(pairs, sign * h * e))[0] for e in (X, Y, Z) for sign in (1, -1)]
    gradient = np.array([plus - minus for plus, minus in zip(difference[::2], difference[1::2], strict=True)]).T / (2 * h)
    distance, normal, *_ = evaluate(first, second, pairs)
    # near an axis, or where two ways out of a box are as short, the normal turns within the step of the differences
    clear = core_outside(first, second, pairs, 0.03) | (second == "box")
    agrees = np.abs(gradient - normal).max(axis=1) < 2e-5
    assert (clear & (distance < 0)).sum() > 30
    assert agrees[clear].mean() > (0.998 if second == "box" else 0.9999)


@PAIRS
def test_moves_no_faster_than_the_body(first, second, rng):
    """|d(x + e) - d(x)| <= |e|, so that nothing jumps."""
    for pairs in (random_pairs(rng, 4000, 0.3), awkward_pairs(rng, 6000)):
        by = rng.normal(size=pairs[0].shape) * 10.0 ** rng.uniform(-10, -1, size=(len(pairs[0]), 1))
        change = evaluate(first, second, shifted(pairs, by))[0] - evaluate(first, second, pairs)[0]
        assert (np.abs(change) <= np.linalg.norm(by, axis=1) + 1e-7).all()


@PAIRS
def test_one_move_parts_overlapping_bodies(first, second, rng):
    """By the distance along the normal; with the bound on how fast the distance changes, no shorter move does."""
    for pairs in (random_pairs(rng, 2000, 0.2), awkward_pairs(rng, 6000)):
        distance, normal, *_ = evaluate(first, second, pairs)
        overlap = distance < 0
        assert overlap.sum() > 200
        moved = evaluate(first, second, shifted(pairs, -distance[:, None] * normal))[0]
        np.testing.assert_allclose(moved[overlap], 0, atol=1e-7)


@pytest.mark.parametrize("end", [1, -1])
def test_an_axis_through_a_plate_is_pulled_out(end):
    plate = function("capsule", "box", (1.0, 1.0, 0.02))
    pair = one([0.01, 0.03, -0.1 * end], [0.02, 0.02, 0.5 * end])
    distance, normal, mine, other = evaluate("capsule", "box", pair, plate)
    assert distance[0] == pytest.approx(-0.02 - 0.1 - RADIUS)
    np.testing.assert_allclose(normal[0], end * Z, atol=1e-12)
    np.testing.assert_allclose(mine[0], [0.01, 0.03, (-0.1 - RADIUS) * end], atol=1e-9)
    np.testing.assert_allclose(other[0], [0.01, 0.03, 0.02 * end], atol=1e-9)


def test_entering_the_box_does_not_jump():
    """An oblique capsule is lowered until its axis lies deep in the box."""
    for end in ([0.5, 0.1, 0.3], [1.0, 0.0, 0.001], [0.2, 0.9, 0.0], [0.0, 0.0, 0.7]):
        height = np.linspace(1.0, 0.2, 4001)
        a = height[:, None] * Z + [-0.1, -0.05, 0.0]
        zero = np.zeros_like(a)
        distance = evaluate("capsule", "box", (a, a + end, np.tile(np.eye(3), (len(a), 1, 1)), zero, zero))[0]
        assert distance[0] > 0 > -RADIUS > distance[-1]
        assert np.abs(np.diff(distance)).max() <= 1.001 * (height[0] - height[1])


@pytest.mark.parametrize(
    ("c", "d", "along"),
    [
        ((0, -1, 0), (0, 1, 0), [Z]),  # axes cross
        ((0, 0, 0), (0, 1, 0), [Z]),  # one ends on the other
        ((0, -1, -0.5), (0.5, 1, 0.5), [np.cross([2, 0, 0], [0.5, 2, 1])]),
        ((-0.5, 0, 0), (0.5, 0, 0), [Y, Z]),  # one in the other
        ((1, 0, 0), (2, 0, 0), [Y, Z]),  # end to end
        ((1, 0, 0), (-1, 0, 0), [Y, Z]),  # the same axis
        ((0.2, 0, 0), (0.2, 0, 0), [Y, Z]),  # of no length
    ],
)
def test_capsules_whose_axes_meet(c, d, along):
    pair = one([-1, 0, 0], [1, 0, 0], c, d)
    found = evaluate("capsule", "capsule", pair)
    assert_consistent(found)
    assert found[0][0] == pytest.approx(-RADIUS - RADII["capsule"], abs=1e-8)
    assert np.linalg.matrix_rank(np.vstack([*along, found[1]]), tol=1e-9) == len(along)


@pytest.mark.parametrize(
    ("second", "pair"),
    [
        ("capsule", one([0.1, 0.2, 0.3], None, [0.1, 0.2, 0.3], [0.1, 0.2, 0.3])),
        ("sphere", one([0.1, 0.2, 0.3], None, [0.1, 0.2, 0.3])),
        ("box", one([0, 0, 0])),
        ("box", one([0.3, 0.2, 0.45])),
        ("box", one([0, 0.2, 0])),
    ],
)
@pytest.mark.parametrize("first", FIRST)
def test_points_that_coincide(first, second, pair):
    """A capsule of no length, and a sphere, on the other's centre, on a corner or on a face."""
    found = evaluate(first, second, pair)
    assert_consistent(found)
    depth = 0.2 if second == "box" and not pair[0].any() else 0.0
    assert found[0][0] == pytest.approx(-RADIUS - RADII[second] - depth)


@pytest.mark.parametrize("noise", [0.0, 1e-16, 1e-15])
def test_parallel_bodies_meet_in_the_middle(noise):
    """Rounding does not choose an end; it moves the point by a few hundredths of the length."""
    tilt = [0, noise, noise]
    for second, pair, middle in (
        ("capsule", one([-1, 0, 0], [1, 0, 0], [-3, 0, 0.5] + np.array(tilt), [3, 0, 0.5]), 0.0),
        ("capsule", one([1, 0, 0], [-1, 0, 0], [-0.5, 0, 0.5] + np.array(tilt), [0.4, 0, 0.5]), 0.0),
        ("box", one([-0.1, 0, 1], [2, 0, 1] + np.array(tilt)), 0.1),
        ("plane", one([-1, 0, 1], [3, 0, 1]), 1.0),
    ):
        _, _, mine, other = evaluate("capsule", second, pair)
        np.testing.assert_allclose([mine[0, 0], other[0, 0]], middle, atol=0.1)


@PAIRS
@examples(80)
@given(
    points=st.lists(
        st.sampled_from([0.0, 1.0, -1.0, 0.3, 0.45, 1e-9, 1e-150, -5e-324]) | st.floats(-1e6, 1e6), min_size=12, max_size=12
    ),
    angles=st.tuples(*[st.sampled_from([0.0, np.pi / 2, np.pi / 4]) | st.floats(-4, 4)] * 3),
)
@example(points=[0.0] * 12, angles=(0.0, 0.0, 0.0))
def test_finite_for_all_inputs(first, second, points, angles):
    a, b, c, d = np.reshape(points, (4, 3))
    pair = one(a, b, c, d, Rotation.from_rotvec(angles).as_matrix())
    distance, normal, mine, other = found = evaluate(first, second, pair)
    assert all(np.isfinite(values).all() for values in found)
    assert np.linalg.norm(normal) == pytest.approx(1, abs=1e-9)
    np.testing.assert_allclose(mine - other, distance * normal, atol=1e-8)


@pytest.mark.parametrize("second", SECOND)
def test_sparse_constants(second):
    """Obstacles that do not move are made of structural zeros."""
    a, b = ca.SX.sym("a", 3), ca.SX.sym("b", 3)
    origin, ahead = ca.SX(3, 1), ca.SX(ca.sparsify(ca.DM([0.0, 0.7, 0.0])))
    other = {
        "sphere": SymbolicCapsule(start=origin, radius=RADII["sphere"]),
        "capsule": SymbolicCapsule(start=origin, end=ahead, radius=RADII["capsule"]),
        "box": SymbolicBox(rotation=ca.SX.eye(3), centre=origin, half=HALF),
        "plane": SymbolicPlane(normal=ca.SX.eye(3)[:, 2], offset=ca.SX(1, 1)),
    }[second]
    for start, end in ((a, b), (a, None), (origin, b), (ahead, None)):
        found = nearest(SymbolicCapsule(start=start, end=end, radius=RADIUS), other)
        values = ca.Function("f", [a, b], [ca.densify(x) for x in vars(found).values()])([0.6, 0.1, 0.8], [0.5, 0.3, -0.2])
        numbers = {id(a): [0.6, 0.1, 0.8], id(b): [0.5, 0.3, -0.2], id(origin): [0, 0, 0], id(ahead): [0, 0.7, 0]}
        pair = one(numbers[id(start)], None if end is None else numbers[id(end)], d=(0, 0.7, 0))
        expected = evaluate("sphere" if end is None else "capsule", second, pair)
        for value, array in zip(values, expected, strict=True):
            np.testing.assert_allclose(np.array(value).ravel(), array.ravel(), atol=1e-12)


@pytest.mark.compiler
@pytest.mark.parametrize("second", ["capsule", "box"])
def test_compiled_equals_interpreted(second, rng):
    pairs = awkward_pairs(rng, 5000)
    library = compiled(function("capsule", second), "a test")
    found = evaluate("capsule", second, pairs, library)
    assert_consistent(found)
    np.testing.assert_allclose(found[0], evaluate("capsule", second, pairs)[0], atol=1e-7)
