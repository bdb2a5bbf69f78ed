"""Convex pieces contain the mesh and, where it is closed, its inside."""

import coal
import numpy as np
import pytest
from scipy.spatial import ConvexHull

import manipplan as mp
from manipplan.collision.covers import GOOD, MOST_PIECES, _CutPart, _WholeMesh, convex_pieces
from manipplan.collision.surfaces import winding_number
from manipplan.collision.world import mesh_triangles


def in_some_piece(points, pieces, margin=1e-7):
    """Whether each point (k, 3) lies in one of the pieces."""
    inside = np.zeros(len(points), dtype=bool)
    for piece in pieces:
        planes = ConvexHull(piece.hull.corners).equations
        inside |= (points @ planes[:, :3].T + planes[:, 3] <= margin).all(axis=1)
    return inside


def points_on(triangles, rng, count):
    corners = triangles[rng.integers(len(triangles), size=count)]
    return np.einsum("kc,kci->ki", rng.dirichlet([1, 1, 1], count), corners)


def points_inside(triangles, rng, count):
    low, high = triangles.min(axis=(0, 1)), triangles.max(axis=(0, 1))
    points = rng.uniform(low, high, (count, 3))
    return points[np.abs(winding_number(triangles, points)) > 0.5]


def box(low, high):
    """The triangles of a box."""
    corner = np.array(np.meshgrid(*zip(low, high, strict=True), indexing="ij")).reshape(3, -1).T
    hull = ConvexHull(corner)
    outward = np.einsum(
        "ki,ki->k", np.cross(*np.moveaxis(np.diff(corner[hull.simplices], axis=1), 1, 0)), hull.equations[:, :3]
    )
    return np.where(outward[:, None, None] > 0, corner[hull.simplices], corner[hull.simplices[:, ::-1]])


def star():
    """Three crossed bars, as one mesh."""
    long, thin = 0.2, 0.04
    sizes = [(long, thin, thin), (thin, long, thin), (thin, thin, long)]
    return np.concatenate([box(-np.array(size), np.array(size)) for size in sizes])


def links(name):
    robot = mp.load_robot(name)
    return {
        item.name: mesh_triangles(item.geometry)
        for item in robot.geometry.geometryObjects
        if isinstance(item.geometry, coal.BVHModelBase) and item.parentJoint > 0
    }


@pytest.mark.slow
@pytest.mark.parametrize("mesh", ["star", "ur5 wrist_1_link_0", "ur5 shoulder_link_0", "ur3 wrist_1_link_0"])
def test_surface_and_inside_lie_in_the_pieces(mesh, rng):
    triangles = star() if mesh == "star" else links(mesh.split()[0])[mesh.split()[1]]
    pieces = convex_pieces(triangles)
    assert 1 < len(pieces) <= MOST_PIECES
    inside = points_inside(triangles, rng, 3000)
    assert len(inside) > 100
    assert in_some_piece(inside, pieces).all()
    assert in_some_piece(points_on(triangles, rng, 2000), pieces).all()


def test_a_convex_mesh_is_one_piece_without_excess():
    for triangles in links("panda").values():
        [piece] = convex_pieces(triangles)
        assert piece.excess < 4e-4
        assert in_some_piece(triangles.reshape(-1, 3), [piece]).all()


def test_excess_is_what_sticks_out():
    """Two boxes that form an L, cut at their corner: nothing sticks out. Their hull sticks out by the corner's distance."""
    ell = np.concatenate([box((0, 0, 0), (0.3, 0.05, 0.05)), box((0, 0, 0), (0.05, 0.3, 0.05))])
    pieces = convex_pieces(ell)
    assert 1 < len(pieces) <= MOST_PIECES and max(piece.excess for piece in pieces) <= 5 * GOOD
    whole = ConvexHull(ell.reshape(-1, 3)).volume
    assert sum(ConvexHull(piece.hull.corners).volume for piece in pieces) < 0.5 * whole


def test_a_flat_mesh_gets_a_little_thickness():
    square = np.array([[[0, 0, 0], [0.2, 0, 0], [0, 0.2, 0]], [[0.2, 0, 0], [0.2, 0.2, 0], [0, 0.2, 0]]], dtype=float)
    [piece] = convex_pieces(square)
    assert in_some_piece(square.reshape(-1, 3), [piece]).all()
    assert 0 < np.ptp(piece.hull.corners[:, 2]) < 1e-3


def test_a_part_without_triangles_is_not_cut():
    """A cell inside a mesh that is no solid: pieces of the iCub's arm failed there."""
    triangles = box([-0.1] * 3, [0.1] * 3)
    cuts = tuple((sign * axis, 0.05) for axis in np.eye(3) for sign in (1.0, -1.0))
    corners = 0.05 * np.array(np.meshgrid(*[[-1, 1]] * 3)).reshape(3, -1).T
    assert _CutPart(_WholeMesh(triangles), np.empty((0, 3, 3)), corners, cuts).best_cut(0.0) is None


def ring(inner, outer, length, sides=96):
    """A tube along x of which both ends are open polygons."""
    angle = 2 * np.pi * np.arange(sides + 1) / sides
    rims = [
        np.column_stack([np.full(sides + 1, x), r * np.cos(angle), r * np.sin(angle)])
        for r, x in ((inner, -length / 2), (outer, -length / 2), (outer, length / 2), (inner, length / 2))
    ]
    quads = [(a[k], a[k + 1], b[k + 1], b[k]) for a, b in zip(rims, rims[1:] + rims[:1], strict=True) for k in range(sides)]
    return np.array([[[a, b, c], [a, c, d]] for a, b, c, d in quads]).reshape(-1, 3, 3)


@pytest.mark.slow
@pytest.mark.parametrize(("inner", "outer", "length"), [(0.05, 0.065, 0.15), (0.041, 0.05, 0.2), (0.06, 0.08, 0.04)])
def test_sectors_of_a_tube_stick_into_its_hole_by_their_chords(inner, outer, length, rng):
    mesh, most = ring(inner, outer, length), 24
    found = convex_pieces(mesh, most)
    assert len(found) <= most
    assert in_some_piece(points_on(mesh, rng, 1000), found).all() and in_some_piece(points_inside(mesh, rng, 1000), found).all()
    chord = inner * np.cos(np.pi / most)
    angle = rng.uniform(-np.pi, np.pi, 500)
    hole = np.column_stack(
        [rng.uniform(-length / 2, length / 2, 500), chord * 0.99 * np.cos(angle), chord * 0.99 * np.sin(angle)]
    )
    assert not in_some_piece(hole, found).any()
