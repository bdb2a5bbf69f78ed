"""Convex pieces in place of a mesh: each contains its part of the mesh, and sticks out of it as little as their number allows.

The mesh is cut by planes, always the piece that sticks out most, and each piece is the convex hull of what lies on its side of
the cuts. A closed mesh is filled: the solid between cuts lies in the hull of its surface there and of the points inside it at
which three cuts meet.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise

import coal
import numpy as np

from manipplan.collision.covers.fitting import subdivide
from manipplan.collision.surfaces.shells import winding_number
from manipplan.robots.hulls import Hull, convex_hull, find_hull, outer_hull, sort_rows
from manipplan.support.checks import Array

#: A piece that sticks out of the mesh by no more than this is not cut again [m].
GOOD = 2e-3
#: Maximum number of pieces of a mesh.
MOST_PIECES = 6
#: Maximum number of points on the surface of a piece at which its excess is measured.
MOST_SAMPLES = 400
#: Maximum number of points on the mesh by which cuts are compared, and the share of the width at either end without cuts.
MOST_POINTS, END = 400, 0.05
#: Positions of the cuts that are compared, as shares of the width along an axis.
CUTS = (0.25, 0.5, 0.75)
#: Many pieces come from cuts across lengths of at least this share of the largest: slices of a ring are as full as the ring.
LONG = 0.8
#: A flat or tiny part is thickened by this to a body with a volume [m].
THICKNESS = 1e-4

#: Normal and offset of a cut; the part lies where normal · x <= offset.
Plane = tuple[Array, float]


@dataclass(frozen=True, kw_only=True)
class Piece:
    """A convex piece of a mesh.

    Attributes:
        hull: what it fills.
        excess: the farthest that it sticks out of the mesh at the points where that was measured [m].
    """

    hull: Hull
    excess: float


def convex_pieces(triangles: Array, most: int = MOST_PIECES) -> list[Piece]:
    """At most `most` convex pieces that contain `triangles` (t, 3, 3) [m] and, if they are closed, their inside."""
    mesh = _WholeMesh(triangles)
    found = _cut_up(mesh, [_CutPart(mesh, triangles, np.empty((0, 3)), ())], most)
    if most > MOST_PIECES:
        for count in (most, most // 2):
            around = _cut_up(mesh, _sectors(mesh, triangles, count), most)
            found = min(found, around, key=lambda parts: sum(_volume(part.hull.corners) for part in parts))
    return [part.piece() for part in found]


def _cut_up(mesh: "_WholeMesh", open_pieces: list["_CutPart"], most: int) -> list["_CutPart"]:
    """Cut the part that sticks out most until none does, or there are `most`."""
    done: list[_CutPart] = []
    while open_pieces and len(open_pieces) + len(done) < most:
        part = open_pieces.pop(int(np.argmax([each.excess for each in open_pieces])))
        cut = part.best_cut(LONG if most > MOST_PIECES else 0.0) if part.excess > GOOD else None
        if cut is None:
            done.append(part)
            continue
        axis, offset = cut
        for sign in (1.0, -1.0):
            side, cuts = _clip(part.triangles, sign * axis, sign * offset), (*part.cuts, (sign * axis, sign * offset))
            inner = mesh.inner_corners(cuts)
            if len(side) or len(inner) > 3:
                open_pieces.append(_CutPart(mesh, side, inner, cuts))
    return [*done, *open_pieces]


def _sectors(mesh: "_WholeMesh", triangles: Array, count: int) -> list["_CutPart"]:
    """`count` equal sectors of a mesh around the main axis through its middle for which they need the smallest volume.

    A tube has the same hull as its halves together, so that single cuts do not find sectors.
    """
    points = triangles.reshape(-1, 3)
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    angles = 2 * np.pi * np.arange(count + 1) / count
    best: list[tuple[Array, tuple[Plane, ...]]] = []
    least = np.inf
    for k in range(3):
        normals = np.zeros((count + 1, 3))
        normals[:, k - 2], normals[:, k - 1] = -np.sin(angles), np.cos(angles)
        sectors: list[tuple[Array, tuple[Plane, ...]]] = []
        for start, end in pairwise(normals):
            cuts = ((-start, float(-start @ middle)), (end, float(end @ middle)))
            side = triangles
            for axis, offset in cuts:
                side = _clip(side, axis, offset)
            if len(side):
                sectors.append((side, cuts))
        volume = sum(_volume(side.reshape(-1, 3)) for side, _ in sectors)
        if volume < least:
            best, least = sectors, volume
    return [_CutPart(mesh, side, np.empty((0, 3)), cuts) for side, cuts in best]


class _CutPart:
    """The part of a mesh between some cuts, by its triangles (t, 3, 3) and its corners inside the mesh (c, 3), and its hull."""

    def __init__(self, mesh: "_WholeMesh", triangles: Array, inner: Array, cuts: tuple[Plane, ...]) -> None:
        self.triangles, self.cuts = triangles, cuts
        points = np.concatenate([triangles.reshape(-1, 3), inner])
        points = points[sort_rows(points)]
        hull = find_hull(points)
        if hull is None:
            box = np.array(np.meshgrid(*[[-THICKNESS / 2, THICKNESS / 2]] * 3)).reshape(3, -1).T
            hull = convex_hull((points[:, None] + box).reshape(-1, 3))
        self.hull, self._mesh = hull, mesh
        self.excess, self._worst = mesh.excess(self.hull.triangles, cuts)

    def piece(self) -> Piece:
        """The part as a body that coal takes."""
        hull = outer_hull(self.hull)
        excess = self.excess if hull is self.hull else self._mesh.excess(hull.triangles, self.cuts)[0]
        return Piece(hull=hull, excess=excess)

    def best_cut(self, long: float) -> Plane | None:
        """The plane, normal to a main axis, whose sides need the smallest volume; None if the part is too small to cut.

        Only across axes along which the part is longer than the share `long` of its largest length.
        """
        if not len(self.triangles):
            return None
        points = subdivide(self.triangles).mean(axis=1)
        points = np.concatenate(
            [points[:: 1 + len(points) // MOST_POINTS], self.hull.corners[:: 1 + len(self.hull.corners) // MOST_POINTS]]
        )
        axes = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2]
        best, least = None, np.inf
        longest = np.ptp(points @ np.array([*axes, *np.eye(3)]).T, axis=0).max()
        for axis in [*axes, *np.eye(3)]:
            along = points @ axis
            low, width = along.min(), np.ptp(along)
            if width < long * longest:
                continue
            for offset in [*(low + width * np.array(CUTS)), float(self._worst @ axis)]:
                if not END * width < offset - low < (1 - END) * width:
                    continue
                volume = 0.0
                for side in sorted((points[along <= offset], points[along >= offset]), key=len, reverse=True):
                    volume += _volume(side) if volume < least else 0.0
                if volume < least:
                    best, least = (np.asarray(axis), float(offset)), volume
        return best


class _WholeMesh:
    """A whole mesh, from which distances are measured."""

    def __init__(self, triangles: Array) -> None:
        self._triangles = triangles
        self._surface = coal.BVHModelOBBRSS()
        self._surface.beginModel(len(triangles), 3 * len(triangles))
        self._surface.addVertices(triangles.reshape(-1, 3))
        self._surface.addTriangles(np.arange(3 * len(triangles)).reshape(-1, 3))
        self._surface.endModel()
        # a box, since coal's distance of a sphere from a degenerate triangle is wrong
        self._point, self._pose, self._still = coal.Box(1e-9, 1e-9, 1e-9), coal.Transform3s(), coal.Transform3s()
        self._request, self._result = coal.DistanceRequest(), coal.DistanceResult()

    def excess(self, faces: Array, cuts: Sequence[Plane]) -> tuple[float, Array]:
        """The largest distance of sampled points on `faces` (f, 3, 3) outside the mesh [m], and that point.

        A point of a hull is outside the mesh or on it, except on a cut, where it may be inside.
        """
        points = _sample(faces)
        distances = np.array([self._distance(point) for point in points])
        on_cut = np.zeros(len(points), dtype=bool)
        for axis, offset in cuts:
            on_cut |= np.abs(points @ axis - offset) < 1e-7
        for worst in np.argsort(-distances):
            if not (on_cut[worst] and distances[worst] > GOOD and self._contains(points[worst])):
                return float(distances[worst]), points[worst]
        return 0.0, points[0]

    def inner_corners(self, cuts: Sequence[Plane]) -> Array:
        """Points (k, 3) inside the mesh where three cuts meet: corners of the solid between the cuts, on no triangle."""
        found = [np.empty((0, 3))]
        for three in combinations(cuts, 3):
            normals, offsets = np.array([axis for axis, _ in three]), np.array([offset for _, offset in three])
            if abs(np.linalg.det(normals)) < 1e-6:
                continue
            point = np.linalg.solve(normals, offsets)
            if all(axis @ point <= offset + 1e-9 for axis, offset in cuts) and self._contains(point):
                found.append(point[None])
        return np.concatenate(found)

    def _contains(self, point: Array) -> bool:
        return bool(abs(winding_number(self._triangles, point[None])[0]) > 0.5)

    def _distance(self, point: Array) -> float:
        self._pose.setTranslation(point)
        self._result.clear()
        return float(coal.distance(self._point, self._pose, self._surface, self._still, self._request, self._result))


def _sample(faces: Array) -> Array:
    """Points (k, 3) spread evenly over triangles (f, 3, 3), the same in every run."""
    area = np.linalg.norm(np.cross(faces[:, 1] - faces[:, 0], faces[:, 2] - faces[:, 0]), axis=1)
    share = (np.arange(MOST_SAMPLES) + 0.5) / MOST_SAMPLES
    chosen = np.searchsorted(np.cumsum(area) / area.sum(), share).clip(max=len(faces) - 1)
    u, v = np.random.default_rng(0).random((2, MOST_SAMPLES))
    u, v = np.where(u + v > 1, 1 - u, u), np.where(u + v > 1, 1 - v, v)
    corner, second, third = (faces[chosen, k] for k in range(3))
    return np.asarray(corner + u[:, None] * (second - corner) + v[:, None] * (third - corner))


def _volume(points: Array) -> float:
    """Volume of the hull of points (k, 3) [m³]; 0 for flat ones."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        return float(ConvexHull(points).volume) if len(points) > 3 else 0.0
    except QhullError:
        return 0.0


def _clip(triangles: Array, normal: Array, offset: float) -> Array:
    """The parts of triangles (t, 3, 3) with normal · x <= offset, as triangles."""
    height = triangles @ normal - offset
    below = height <= 0
    count = below.sum(axis=1)
    found = [triangles[count == 3]]
    for number in (1, 2):
        chosen = count == number
        corners, heights = triangles[chosen], height[chosen]
        # the corner that is alone on its side comes first
        alone = below[chosen] if number == 1 else ~below[chosen]
        order = (alone.argmax(axis=1)[:, None] + np.arange(3)) % 3
        corners, heights = np.take_along_axis(corners, order[:, :, None], 1), np.take_along_axis(heights, order, 1)
        cut = [
            corners[:, 0] + (heights[:, 0] / (heights[:, 0] - heights[:, k]))[:, None] * (corners[:, k] - corners[:, 0])
            for k in (1, 2)
        ]
        if number == 1:
            found.append(np.stack([corners[:, 0], *cut], axis=1))
        else:
            found.append(np.stack([cut[0], corners[:, 1], corners[:, 2]], axis=1))
            found.append(np.stack([cut[0], corners[:, 2], cut[1]], axis=1))
    return np.concatenate(found)
