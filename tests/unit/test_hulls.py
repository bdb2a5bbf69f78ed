"""Convex hulls of any corners: fine, flat, tiny, huge and all of these at once."""

import coal
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import manipplan as mp
from manipplan.collision.covers import convex_pieces
from manipplan.robots.hulls import convex_hull, find_hull, outer_hull


def support(points, directions):
    return (points @ directions.T).max(axis=0)


def directions(rng):
    found = rng.normal(size=(500, 3))
    return found / np.linalg.norm(found, axis=1)[:, None]


@pytest.mark.slow
@settings(max_examples=200, deadline=None)
@given(seed=st.integers(0, 10**6), low=st.integers(-13, 2), high=st.integers(-3, 5), count=st.integers(4, 300))
def test_corners_of_any_size_give_a_body_that_contains_them(seed, low, high, count):
    rng = np.random.default_rng(seed)
    points = directions(rng)[rng.integers(0, 500, count)] * 10 ** rng.uniform(low, max(low, high), (count, 1))
    if find_hull(points) is None:
        return
    size, towards = np.ptp(points, axis=0).max(), directions(rng)
    exact = convex_hull(points)
    outer = outer_hull(exact)
    assert outer.fits_coal
    outer.shape()
    np.testing.assert_allclose(support(exact.corners, towards), support(points, towards), atol=1e-9 * size)
    beyond = support(outer.corners, towards) - support(points, towards)
    assert beyond.min() > -1e-9 * size and beyond.max() < 1e-3 * size
    # the triangles face outward and close the body
    a, b, c = np.moveaxis(outer.triangles - outer.corners.mean(axis=0), 1, 0)
    assert np.einsum("ti,ti->", a, np.cross(b, c)) > 0


@pytest.mark.slow
@pytest.mark.parametrize("sides", [3, 200, 255, 256, 300, 1000, 5000])
@pytest.mark.parametrize("tip", [0.0, 1.0, 0.5])
def test_cones_and_cylinders_of_any_number_of_sides(sides, tip):
    """A cone, a cylinder and a frustum: the excess is small, and coal's distances are those of the outer body."""
    angles = np.linspace(0, 2 * np.pi, sides, endpoint=False)
    rim = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(sides)])
    points = 0.1 * np.concatenate([rim, rim * [tip, tip, 1] + [0, 0, 3]])
    hull = outer_hull(convex_hull(np.unique(points, axis=0)))
    assert hull.fits_coal
    towards = directions(np.random.default_rng(0))
    beyond = support(hull.corners, towards) - support(points, towards)
    assert beyond.min() > -1e-12 and beyond.max() < 1e-3
    ball = coal.Transform3s(np.eye(3), np.array([0.5, 0.0, 0.15]))
    request = coal.DistanceRequest()
    request.gjk_tolerance = 1e-10
    found = coal.distance(hull.shape(), coal.Transform3s(), coal.Sphere(0.01), ball, request, coal.DistanceResult())
    exact = coal.Cylinder(0.1, 0.3) if tip == 1.0 else None
    if exact is not None and sides >= 200:
        middle = coal.Transform3s(np.eye(3), np.array([0.0, 0.0, 0.15]))
        assert found == pytest.approx(
            coal.distance(exact, middle, coal.Sphere(0.01), ball, request, coal.DistanceResult()), abs=1e-3
        )


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize(("low", "high"), [(-12, 5), (-8, 5), (-12, 2), (-6, 3)])
def test_triangles_whose_sizes_differ_by_many_orders_end_no_process(tmp_path, seed, low, high):
    """Thirty triangles of a link with corners from 1e-12 to 1e5 m ended the process in coal's hull."""
    rng = np.random.default_rng(seed)
    corners = directions(rng)[:90] * 10 ** rng.uniform(low, high, (90, 1))
    pieces = convex_pieces(corners.reshape(30, 3, 3))
    towards = directions(rng)
    everything = np.concatenate([piece.hull.corners for piece in pieces])
    assert (support(everything, towards) >= support(corners, towards) - 1e-9 * 10**high).all()
    for piece in pieces:
        piece.hull.shape()


def test_an_obstacle_with_a_fine_tip_stays_exact():
    """A convex mesh that coal does not take as a hull is checked by its triangles, as a solid."""
    angles = np.linspace(0, 2 * np.pi, 400, endpoint=False)
    rim = np.column_stack([0.2 * np.cos(angles), 0.2 * np.sin(angles), np.zeros(400)])
    after, tip = np.roll(rim, -1, axis=0), np.broadcast_to([0.0, 0.0, 0.4], rim.shape)
    triangles = np.concatenate([np.stack([rim, after, tip], axis=1), np.stack([rim, 0 * rim, after], axis=1)])
    for mesh in (mp.Mesh(triangles=triangles), mp.Mesh(triangles=triangles, fill="hull")):
        [part] = mesh.parts()
        assert part.closed and isinstance(part.shape, coal.BVHModelBase)
        arm = mp.planar_arm([0.5, 0.5, 0.5])
        scene = mp.Scene([mesh.at([[1, 0, 0, 1.0], [0, 1, 0, 0], [0, 0, 1, -0.05], [0, 0, 0, 1]])])
        assert scene.in_collision(arm, [0.0, 0.0, 0.0]) and not scene.in_collision(arm, [1.5, 0.0, 0.0])
