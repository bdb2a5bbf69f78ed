"""Obstacle shapes of the user: convex pieces and meshes, or a support function, enclosed by a polytope."""

import logging
from collections.abc import Callable, Sequence
from itertools import product
from typing import Any

import numpy as np

from manipplan.collision.surfaces.meshes import MeshPart, mesh_parts
from manipplan.robots.hulls import FARTHEST, convex_hull, find_hull, has_hull
from manipplan.support.checks import Array, finite_array, number, number_array
from manipplan.support.errors import InvalidInputError

log = logging.getLogger("manipplan")

#: Maximum number of pieces, and of directions in which a support function is asked.
MOST_PIECES, MOST_DIRECTIONS = 10_000, 1500
#: Default of the largest distance of a polytope's corners from the body of a support function [m]; and what it may be where
#: that takes too many directions, as a share of the body's size.
EXCESS, LARGEST_EXCESS = 1e-3, 0.01
#: By how much planes are moved out, so that rounding leaves nothing of the body outside, as a share of its size.
MOVED_OUT = 1e-9
#: By how much the point for a direction may be less far than one for another direction, as a share of the body's size.
INEXACT = 1e-6
#: Directions nearer to each other than this are one.
ONE = 1e-7
#: Share of the largest distance of a corner from which on corners are cut off in the same step; and share of a corner's
#: distance from which on a plane for another corner cuts enough of it off.
LARGE, CUT = 0.6, 0.3
#: Maximum number of steps to the nearest point of a hull, and gain below which they end, for bodies of size 1.
STEPS, NO_GAIN = 60, 1e-12


def own_parts(argument: str, shape: Any) -> list[MeshPart]:
    """The parts of an obstacle whose class has `pieces` or `support`, in its own frame; `argument` is its name for messages.

    Raises InvalidInputError when the class has none of them or both, or when what they return is not usable.
    """
    found = [name for name in ("pieces", "support") if callable(getattr(shape, name, None))]
    if len(found) != 1:
        has = "both pieces and support" if found else "neither pieces nor support"
        raise InvalidInputError(argument, f"{type(shape).__name__} with {has}", "a class with one of these methods")
    if found == ["support"]:
        given = getattr(shape, "excess", None)
        excess = None if given is None else number(f"{argument}.excess", given, above=0.0)
        return [_enclosed(f"{argument}.support", shape.support, excess)]
    argument = f"{argument}.pieces"
    pieces = _answer(argument, shape.pieces)
    if not isinstance(pieces, Sequence) or not 1 <= len(pieces) <= MOST_PIECES:
        wanted = f"a list of 1 to {MOST_PIECES:,} arrays: points (k, 3) of a convex piece, or triangles (t, 3, 3)"
        raise InvalidInputError(argument, pieces, wanted)
    return [part for k, piece in enumerate(pieces) for part in _parts_of(f"{argument}[{k}]", piece)]


def _answer(argument: str, method: Callable[..., Any], *given: Any) -> Any:
    """What a method of the user returns."""
    try:
        return method(*given)
    except Exception as error:  # whatever the user's class raises
        reason = f"a method that returns points; it raised {type(error).__name__}: {error}"
        raise InvalidInputError(argument, getattr(method, "__qualname__", method), reason) from error


def _parts_of(argument: str, piece: Any) -> list[MeshPart]:
    """The parts of one piece: the hull of points, or what triangles are."""
    if number_array(argument, piece).ndim == 3:
        return mesh_parts(argument, finite_array(argument, piece, (None, 3, 3), most=FARTHEST))
    points = finite_array(argument, piece, (None, 3), most=FARTHEST)
    hull = find_hull(points)
    if hull is None:
        wanted = "points whose hull has a volume; triangles (t, 3, 3) may be a surface"
        raise InvalidInputError(argument, f"{len(points)} points that are flat", wanted)
    return [MeshPart.of_hull(hull)]


def _enclosed(argument: str, support: Callable[[Array], Any], excess: float | None) -> MeshPart:
    """A polytope around the body of a support function, nowhere farther from it than `excess` [m]; None: the default.

    Its faces touch the body, which contains the hull of the points where they do. Where a corner is too far from that hull, the
    direction from the hull to the corner is asked next.
    """
    from scipy.spatial import HalfspaceIntersection

    grid = np.array([each for each in product((-1.0, 0.0, 1.0), repeat=3) if any(each)])
    directions, points = np.zeros((0, 3)), np.zeros((0, 3))
    new, flat = grid / np.linalg.norm(grid, axis=1, keepdims=True), 0
    while True:
        found = finite_array(argument, _answer(argument, support, new.copy()), (len(new), 3), most=FARTHEST)
        directions, points = np.concatenate([directions, new]), np.concatenate([points, found])
        if not has_hull(points):
            if flat == 3:
                raise InvalidInputError(argument, f"points {points[:3].tolist()}, ...", "points of a body with a volume")
            axes = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2]
            new, flat = np.concatenate([axes, -axes]), flat + 1  # across what the points span so far
            continue
        low, size = points.min(axis=0), float(np.ptp(points, axis=0).max())
        local = (points - low) / size
        planes = np.column_stack([directions, -_reach(argument, directions, local, points) - MOVED_OUT])
        polytope = HalfspaceIntersection(planes, local.mean(axis=0), qhull_options="Qt")
        corners = polytope.intersections
        nearest = _nearest_in_hull(corners, local, np.array(polytope.dual_facets))
        gaps = np.linalg.norm(corners - nearest, axis=1)
        gap = size * float(gaps.max())
        new = _cuts(corners, nearest, gaps, (EXCESS if excess is None else excess) / size)[: MOST_DIRECTIONS - len(directions)]
        new = new[(1 - new @ directions.T).min(axis=1) > ONE**2]
        if not len(new):
            break
    if gap > (max(EXCESS, LARGEST_EXCESS * size) if excess is None else excess):
        wanted = f"excess = {1.1 * gap:.2g} or more in the class: {len(directions)} planes are up to {gap:.2g} m from the body"
        raise InvalidInputError(argument, f"a body of {size:.3g} m with excess = {excess}", wanted)
    log.info("%s: %d planes enclose the body, at most %.3g mm away from it", argument, len(directions), 1e3 * gap)
    return MeshPart.of_hull(convex_hull(low + size * corners))


def _cuts(corners: Array, nearest: Array, gaps: Array, allowed: float) -> Array:
    """Directions (d, 3) of planes that cut off the corners (k, 3) with a gap above `allowed`, the largest gap first.

    A corner of which another plane cuts off a good part is left for later.
    """
    far = np.flatnonzero(gaps > max(allowed, LARGE * float(gaps.max())))
    far = far[np.argsort(-gaps[far], kind="stable")]
    chosen = []
    while len(far):
        first = far[0]
        normal = (corners[first] - nearest[first]) / gaps[first]
        chosen.append(normal)
        far = far[(corners[far] - nearest[first]) @ normal < CUT * gaps[far]]
    return np.array(chosen).reshape(-1, 3)


def _reach(argument: str, directions: Array, local: Array, points: Array) -> Array:
    """How far the body reaches in each direction (k,); raises InvalidInputError where another point is farther than its own."""
    reach = (directions @ local.T).max(axis=1)
    short = reach - np.einsum("ij,ij->i", directions, local)
    worst = int(short.argmax())
    if short[worst] > INEXACT:
        wanted = f"the point of the body that is farthest in its direction {directions[worst].tolist()}; another one is farther"
        raise InvalidInputError(argument, points[worst].tolist(), wanted)
    return np.asarray(reach)


def _nearest_in_hull(corners: Array, points: Array, start: Array) -> Array:
    """The point of the hull of points (p, 3) that is nearest to each of corners (k, 3) outside it; start (k, 3): point indices.

    As in GJK: the nearest point lies in a triangle of points, of which the point farthest towards the corner replaces one.
    """
    triangles, rows = points[start], np.arange(len(corners))
    nearest = _nearest_in_triangles(corners, triangles)
    for _ in range(STEPS):
        away = corners[rows] - nearest[rows]
        heights = away @ points.T
        best = heights.argmax(axis=1)
        gain = heights[np.arange(len(rows)), best] - np.einsum("ij,ij->i", away, nearest[rows])
        going = gain > NO_GAIN
        rows, best = rows[going], best[going]
        if not len(rows):
            break
        left = np.full(len(rows), np.inf)
        before = triangles[rows]
        for k in range(3):
            tried = before.copy()
            tried[:, k] = points[best]
            near = _nearest_in_triangles(corners[rows], tried)
            distance = np.linalg.norm(corners[rows] - near, axis=1)
            better = distance < left
            left[better], nearest[rows[better]], triangles[rows[better]] = distance[better], near[better], tried[better]
    return nearest


def _nearest_in_triangles(points: Array, triangles: Array) -> Array:
    """The point (k, 3) of each triangle (k, 3, 3) that is nearest to each of points (k, 3)."""
    best, least = np.zeros_like(points), np.full(len(points), np.inf)
    a, b, c = (triangles[:, k] for k in range(3))
    normal = np.cross(b - a, c - a)
    square = np.einsum("ij,ij->i", normal, normal)
    solid = square > 1e-24
    height = np.einsum("ij,ij->i", points - a, normal) / np.where(solid, square, 1.0)
    foot = points - height[:, None] * normal
    inside = solid.copy()
    for first, last in ((a, b), (b, c), (c, a)):
        inside &= np.einsum("ij,ij->i", np.cross(last - first, foot - first), normal) >= 0
        along = last - first
        length = np.einsum("ij,ij->i", along, along)
        share = np.clip(np.einsum("ij,ij->i", points - first, along) / np.where(length > 0, length, 1.0), 0.0, 1.0)
        near = first + share[:, None] * along
        distance = np.linalg.norm(points - near, axis=1)
        closer = distance < least
        best[closer], least[closer] = near[closer], distance[closer]
    best[inside] = foot[inside]
    return best
