"""Capsules and spheres around surfaces: they contain every triangle.

A surface is split into few parts, each enclosed by the capsule or sphere of smallest volume. Both are convex, so they contain a
triangle when they contain its corners: that is checked, not assumed.

How far a body sticks out of the shape that it stands for, measured at points on the body.
"""

from collections.abc import Callable

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.surfaces.shells import winding_number
from manipplan.collision.world import Primitive, mesh_triangles, outside
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
    capsule = min((_capsule(points, _frame(axis)) for axis in axes), key=_volume)
    if refine:
        capsule = _fit_turned(_capsule, points, capsule)
    found = [capsule, _sphere(points)]
    if boxes:
        box = min((_box(points, frame) for frame in (np.eye(3), axes.T)), key=_volume)
        found.append(_fit_turned(_box, points, box) if refine else box)
    return min(found, key=_volume)


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


def _volume(primitive: Primitive) -> float:
    return primitive.volume


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
    return min([start, turned(found.x)], key=_volume)


def _frame(z: Array) -> Array:
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
    """The largest distance [m] by which a capsule sticks out of `shape`, measured at SAMPLES points.

    Args:
        start, end: (3,) ends of its axis in the frame of the shape [m]; equal for a sphere.
        radius: [m].
        shape: that the capsule stands for; a mesh counts as solid where its triangles enclose a point.
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
    axis = (end - start) / length if length > 0 else np.array([0.0, 0.0, 1.0])
    side = np.cross(axis, np.eye(3)[np.abs(axis).argmin()])
    side /= np.linalg.norm(side)
    reach = length / 2 + radius
    # as on a ball, the area between two planes normal to the axis is that of the cylinder around it
    along = np.concatenate([reach * (2 * (np.arange(SAMPLES) + 0.5) / SAMPLES - 1), [-reach, reach]])
    beyond = np.maximum(np.abs(along) - length / 2, 0.0)
    around = np.sqrt(np.maximum(radius**2 - beyond**2, 0.0))
    turn = TURN * np.arange(len(along))
    circle = np.cos(turn)[:, None] * side + np.sin(turn)[:, None] * np.cross(axis, side)
    return np.asarray((start + end) / 2 + along[:, None] * axis + around[:, None] * circle)


def distances_to(points: Array, shape: coal.CollisionGeometry) -> Array:
    """Distances (k,) of points (k, 3) from a shape [m]; 0 inside it, but inside a mesh the distance from its surface."""
    # a box, since coal's distance of a sphere from a degenerate triangle is wrong
    point, still, request = coal.Box(1e-9, 1e-9, 1e-9), coal.Transform3s(), coal.DistanceRequest()
    found = [
        coal.distance(point, coal.Transform3s(np.eye(3), each), shape, still, request, coal.DistanceResult()) for each in points
    ]
    return np.asarray(np.maximum(found, 0.0))
