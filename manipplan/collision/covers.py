"""Few convex bodies in place of a mesh: capsules and spheres around it, or convex pieces of it. They contain every triangle.

A surface is split into few parts, each enclosed by the capsule or sphere of smallest volume. Both are convex, so they contain a
triangle when they contain its corners: that is checked, not assumed.

Each convex piece contains its part of the mesh, and sticks out of it as little as their number allows. The mesh is cut by
planes, always the piece that sticks out most, and each piece is the convex hull of what lies on its side of the cuts. A closed
mesh is filled: the solid between cuts lies in the hull of its surface there and of the points inside it at which three cuts
meet.

How far a body sticks out of the shape that it stands for, measured at points on the body.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise
from operator import attrgetter

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.surfaces import winding_number
from manipplan.collision.world import Primitive, mesh_triangles, outside
from manipplan.robots.hulls import Hull, convex_hull, find_hull, outer_hull, sort_rows
from manipplan.robots.mesh_files import triangle_tree
from manipplan.support.checks import Array
from manipplan.support.errors import ManipplanError

#: Minimum share of the volume that a further cut must save, and maximum number of parts of a surface.
MIN_SAVING = 0.08
MAX_PARTS = 4
#: Margin by which every primitive is larger than the fit, so that rounding cannot leave a corner outside [m].
PADDING = 1e-6


def fit_capsules(triangles: Array) -> list[Primitive]:
    """Capsules and spheres that together contain `triangles` (t, 3, 3) [m].

    Raises ManipplanError if a triangle is not inside the primitive of its part.
    """
    triangles = subdivide(triangles)
    parts = [(triangles, enclose(triangles, boxes=False))]
    while len(parts) < MAX_PARTS:
        cuts = [_best_cut(part) for part, _ in parts]
        pieces = [[part[side] for side in cut] for (part, _), cut in zip(parts, cuts, strict=True)]
        enclosed = [[enclose(piece, boxes=False) for piece in pair if len(piece)] for pair in pieces]
        saved = [whole.volume - sum(p.volume for p in pair) for (_, whole), pair in zip(parts, enclosed, strict=True)]
        k = int(np.argmax(saved))
        if saved[k] < MIN_SAVING * sum(whole.volume for _, whole in parts):
            break
        parts[k : k + 1] = list(zip(pieces[k], enclosed[k], strict=True))
    for part, primitive in parts:
        excess = outside(primitive, part.reshape(-1, 3)).max()
        if excess > 0:
            raise ManipplanError(f"a fitted {type(primitive.shape).__name__} leaves up to {excess:g} m of its part outside")
    return [primitive for _, primitive in parts]


def enclose(triangles: Array, *, refine: bool = True, boxes: bool = True) -> Primitive:
    """The sphere, capsule or (with `boxes`) box of smallest volume found that contains `triangles` (t, 3, 3) [m]."""
    points = _hull_points(triangles.reshape(-1, 3))
    axes = np.linalg.svd(points - points.mean(axis=0), full_matrices=len(points) < 3)[2]  # (3, 3) also for two points
    axes[2] *= np.linalg.det(axes)
    capsule = min((_capsule(points, frame_along(axis)) for axis in axes), key=attrgetter("volume"))
    if refine:
        capsule = _fit_turned(_capsule, points, capsule)
    found = [capsule, _sphere(points)]
    if boxes:
        box = min((_box(points, frame) for frame in (np.eye(3), axes.T)), key=attrgetter("volume"))
        found.append(_fit_turned(_box, points, box) if refine else box)
    return min(found, key=attrgetter("volume"))


def _best_cut(triangles: Array) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Masks of the triangles on either side of the plane, normal to a principal axis, whose sides need the smallest volume.

    Planes are compared on a few hundred of the triangles; the best one cuts the whole part.
    """
    some = triangles[:: 1 + len(triangles) // 400]
    points = some.reshape(-1, 3)
    axes = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2]
    best = (np.inf, axes[0], 0.0)
    for axis in axes:
        along = some.mean(axis=1) @ axis
        for offset in np.quantile(along, [0.25, 0.4, 0.5, 0.6, 0.75]):
            left = along < offset
            volume = sum(enclose(some[side], refine=False, boxes=False).volume for side in (left, ~left) if side.any())
            if volume < best[0]:
                best = (volume, axis, float(offset))
    left = triangles.mean(axis=1) @ best[1] < best[2]
    return left, ~left


def subdivide(triangles: Array) -> Array:
    """The same surface as triangles with edges of at most an eighth of its size, so that the parts overlap little."""
    size = np.linalg.norm(np.ptp(triangles.reshape(-1, 3), axis=0)) / 8
    small = []
    while len(triangles):
        edges = np.roll(triangles, -1, axis=1) - triangles
        length = np.linalg.norm(edges, axis=2)
        long = length.max(axis=1) > size
        small.append(triangles[~long])
        triangles, length = triangles[long], length[long]
        # split at the middle of the longest edge
        first = length.argmax(axis=1)
        row = np.arange(len(triangles))
        a, b, c = (triangles[row, (first + k) % 3] for k in range(3))
        middle = (a + b) / 2
        triangles = np.concatenate([np.stack([a, middle, c], axis=1), np.stack([middle, b, c], axis=1)])
    return np.concatenate(small)


def _hull_points(points: Array) -> Array:
    from scipy.spatial import ConvexHull, QhullError

    try:
        return np.asarray(points[ConvexHull(points).vertices])
    except (QhullError, ValueError):  # flat or fewer than four points: all of them count
        return points


def _fit_turned(fit: Callable[[Array, Array], Primitive], points: Array, start: Primitive) -> Primitive:
    """The fit of smallest volume over all rotations near that of `start`."""
    from scipy.optimize import minimize

    frame = start.placement.rotation

    def turned(x: Array) -> Primitive:
        return fit(points, frame @ pin.exp3(x))

    found = minimize(
        lambda x: turned(x).volume,
        np.zeros(3),
        method="Nelder-Mead",
        options={"maxfev": 120, "initial_simplex": 0.3 * np.vstack([np.zeros(3), np.eye(3)]), "xatol": 1e-3, "fatol": 1e-9},
    )
    return min([start, turned(found.x)], key=attrgetter("volume"))


def frame_along(z: Array) -> Array:
    """A frame (3, 3), its axes as columns, with z along a vector (3,)."""
    z = z / np.linalg.norm(z)
    x = np.cross(z, np.eye(3)[np.argmin(np.abs(z))])
    x /= np.linalg.norm(x)
    return np.column_stack([x, np.cross(z, x), z])


def _sphere(points: Array) -> Primitive:
    centre = _ball_centre(points)
    radius = float(np.linalg.norm(points - centre, axis=1).max()) + PADDING
    return Primitive(shape=coal.Sphere(radius), placement=pin.SE3(np.eye(3), centre), volume=4 / 3 * np.pi * radius**3)


def _capsule(points: Array, frame: Array) -> Primitive:
    local = points @ frame
    centre = _ball_centre(local[:, :2])
    square = ((local[:, :2] - centre) ** 2).sum(axis=1)
    radius = float(np.sqrt(square.max()))
    reach = np.sqrt(np.maximum(radius**2 - square, 0.0))
    low, high = float((local[:, 2] + reach).min()), float((local[:, 2] - reach).max())
    if low > high:  # one ball contains all points
        low = high = (low + high) / 2
    half = (high - low) / 2
    radius += PADDING
    placement = pin.SE3(frame, frame @ np.array([*centre, (low + high) / 2]))
    volume = np.pi * radius**2 * (2 * half + 4 / 3 * radius)
    return Primitive(shape=coal.Capsule(radius, 2 * half), placement=placement, volume=volume)


def _box(points: Array, frame: Array) -> Primitive:
    local = points @ frame
    low, high = local.min(axis=0), local.max(axis=0)
    side = high - low + 2 * PADDING
    placement = pin.SE3(frame, frame @ ((low + high) / 2))
    return Primitive(shape=coal.Box(*side), placement=placement, volume=float(side.prod()))


def _ball_centre(points: Array) -> Array:
    """Approximate centre of the smallest ball around `points`, by steps towards the farthest point [badoiu2003]."""
    centre = (points.min(axis=0) + points.max(axis=0)) / 2
    for k in range(12):
        far = points[np.argmax(((points - centre) ** 2).sum(axis=1))]
        centre = centre + (far - centre) / (k + 2)
    return np.asarray(centre)


#: Number of points on a capsule at which its excess is measured, besides its two poles.
SAMPLES = 400
#: Number of points that are tested at a time for whether they are inside.
BLOCK = 32
#: Angle about the axis from one point of a capsule to the next [rad]: the golden angle spreads them evenly.
TURN = np.pi * (3 - 5**0.5)


def capsule_excess(start: Array, end: Array, radius: float, shape: coal.CollisionGeometry) -> float:
    """The largest distance by which a capsule of `radius` sticks out of `shape`, measured at SAMPLES points [m].

    The ends (3,) of its axis are in the frame of the shape, and equal for a sphere. A mesh counts as solid where its triangles
    enclose a point.
    """
    points = capsule_points(start, end, radius)
    distances = distances_to(points, shape)
    order = np.argsort(-distances)
    if not isinstance(shape, coal.BVHModelBase):
        return float(distances[order[0]])
    triangles = mesh_triangles(shape)
    for k in range(0, len(order), BLOCK):
        some = order[k : k + BLOCK]
        outside = np.abs(winding_number(triangles, points[some])) < 0.5
        if outside.any():
            return float(distances[some[outside.argmax()]])
    return 0.0


def capsule_points(start: Array, end: Array, radius: float) -> Array:
    """SAMPLES points spread evenly over a capsule, and its two poles (k, 3) [m]."""
    length = float(np.linalg.norm(end - start))
    side, up, axis = frame_along(end - start if length > 0 else np.array([0.0, 0.0, 1.0])).T
    reach = length / 2 + radius
    # as on a ball, the area between two planes normal to the axis is that of the cylinder around it
    along = np.concatenate([reach * (2 * (np.arange(SAMPLES) + 0.5) / SAMPLES - 1), [-reach, reach]])
    beyond = np.maximum(np.abs(along) - length / 2, 0.0)
    around = np.sqrt(np.maximum(radius**2 - beyond**2, 0.0))
    turn = TURN * np.arange(len(along))
    circle = np.cos(turn)[:, None] * side + np.sin(turn)[:, None] * up
    return np.asarray((start + end) / 2 + along[:, None] * axis + around[:, None] * circle)


def distances_to(points: Array, shape: coal.CollisionGeometry) -> Array:
    """Distances (k,) of points (k, 3) from a shape [m]; 0 inside it, but inside a mesh the distance from its surface."""
    # a box, since coal's distance of a sphere from a degenerate triangle is wrong
    point, still, request = coal.Box(1e-9, 1e-9, 1e-9), coal.Transform3s(), coal.DistanceRequest()
    found = [
        coal.distance(point, coal.Transform3s(np.eye(3), each), shape, still, request, coal.DistanceResult()) for each in points
    ]
    return np.asarray(np.maximum(found, 0.0))


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
        self._surface = triangle_tree(triangles.reshape(-1, 3), np.arange(3 * len(triangles)).reshape(-1, 3))

    def excess(self, faces: Array, cuts: Sequence[Plane]) -> tuple[float, Array]:
        """The largest distance of sampled points on `faces` (f, 3, 3) outside the mesh [m], and that point.

        A point of a hull is outside the mesh or on it, except on a cut, where it may be inside.
        """
        points = _sample(faces)
        distances = distances_to(points, self._surface)
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
