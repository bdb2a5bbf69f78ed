"""Shapes as surfaces: polygons and edges for pictures, and triangles for a browser."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.covers import frame_along
from manipplan.collision.scene import Scene
from manipplan.collision.shapes import Plane, PointCloud
from manipplan.collision.surfaces import components, merge_corners
from manipplan.collision.world import core_of, mesh_triangles
from manipplan.robots.hulls import convex_hull, find_hull
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.memo import once_per_owner

#: Number of flat faces around a round shape, a multiple of four, in a picture and in a browser; half as many from pole to pole.
AROUND, FINE = 28, 40
#: Number of directions whose extreme points make the hull that is drawn for a mesh.
DIRECTIONS = 50
#: Minimum angle between neighbouring faces at which the edge between them is drawn, and stays sharp under smooth shading [rad].
CREASE, SHARP = 0.35, 0.6
#: Maximum number of triangles of a mesh among the obstacles, and of cubes of a cloud.
TRIANGLES, CUBES = 5000, 2000
#: Maximum number of triangles per mesh: a browser without a graphics card can still animate two arms of ten links.
MOST = 4000
#: Number of decimals of corners [m] that are one where they agree.
DIGITS = 7
#: How often the size of the cells is halved in which corners become one.
HALVINGS = 12
#: Half the side of the square that is drawn for a plane in a browser [m].
PLANE = 1.5

Faces = NDArray[np.int64]


@dataclass(frozen=True, kw_only=True)
class Surface:
    """Polygons (k, 3) of a surface, and polylines (k, 3) along its edges [m]."""

    faces: tuple[Array, ...]
    edges: tuple[Array, ...]

    def placed(self, pose: pin.SE3) -> "Surface":
        """The surface in the frame in which `pose` is given."""

        def moved(lines: tuple[Array, ...]) -> tuple[Array, ...]:
            return tuple(line @ pose.rotation.T + pose.translation for line in lines)

        return Surface(faces=moved(self.faces), edges=moved(self.edges))

    @property
    def points(self) -> Array:
        """All corners (k, 3)."""
        return np.concatenate(self.faces)


def surface_of(shape: coal.CollisionGeometry, around: int = AROUND) -> Surface:
    """The surface of a coal shape in its own frame; for a mesh, the hull of its extreme points in 50 directions.

    `around`: number of flat faces around a round shape, a multiple of four. A shape of a type that occurs neither in scenes nor
    in URDF files is drawn as its bounding box.
    """
    if isinstance(shape, coal.Sphere | coal.Ellipsoid):
        up = np.linspace(-np.pi / 2, np.pi / 2, around // 2 + 1)
        radii = np.full(3, shape.radius) if isinstance(shape, coal.Sphere) else np.array(shape.radii)
        ball = _revolve(np.cos(up), np.sin(up), around, rings=(around // 4,))
        return Surface(faces=tuple(face * radii for face in ball.faces), edges=tuple(edge * radii for edge in ball.edges))
    if isinstance(shape, coal.Capsule):
        half = around // 4 + 1  # the equator appears twice, once per end
        up = np.linspace(-np.pi / 2, np.pi / 2, 2 * half)
        ends = np.repeat([-shape.halfLength, shape.halfLength], half)
        return _revolve(shape.radius * np.cos(up), shape.radius * np.sin(up) + ends, around, rings=(half - 1, half))
    if isinstance(shape, coal.Cylinder):
        r, z = shape.radius, shape.halfLength
        return _revolve(np.array([0.0, r, r, 0.0]), np.array([-z, -z, z, z]), around, rings=(1, 2))
    if isinstance(shape, coal.Cone):
        z = shape.halfLength
        return _revolve(np.array([0.0, shape.radius, 0.0]), np.array([-z, -z, z]), around, rings=(1,))
    points, _ = core_of(shape)
    if isinstance(shape, coal.BVHModelBase):
        if find_hull(points) is None:  # a flat mesh
            return Surface(faces=tuple(mesh_triangles(shape)), edges=())
        points = points[np.unique((points @ _directions().T).argmax(axis=0))]
    hull = convex_hull(points)
    sides, _, cosines = _sides(hull.corners, hull.faces)
    return _triangular(hull.corners, hull.faces, sides[cosines < np.cos(CREASE)])


def triangles_of(shape: coal.CollisionGeometry, most: int = MOST) -> tuple[Array, Faces]:
    """Vertices (v, 3) [m] in the shape's frame and faces (f, 3) for a browser.

    A mesh has at most `most` triangles. Vertices along sharp edges are separate on each side. A plane is a square.
    """
    if isinstance(shape, coal.Halfspace | coal.Plane):
        return _square(np.asarray(shape.n), float(shape.d))
    if isinstance(shape, coal.BVHModelBase):
        return faces_of(mesh_triangles(shape), most)
    polygons = surface_of(shape, FINE).faces
    fans = [
        np.array([face for face in polygons if len(face) == n])[:, [[0, k, k + 1] for k in range(1, n - 1)]]
        for n in {len(face) for face in polygons}
    ]
    return faces_of(np.concatenate([fan.reshape(-1, 3, 3) for fan in fans]))


def faces_of(triangles: Array, most: int | None = None) -> tuple[Array, Faces]:
    """Vertices (v, 3) and faces (f, 3) of triangles (t, 3, 3), at most `most`; sharp edges have vertices on each side."""
    [(vertices, faces)] = faces_of_parts([triangles], most)
    return vertices, faces


def faces_of_parts(parts: Sequence[Array], most: int | None = None) -> list[tuple[Array, Faces]]:
    """The same of the parts of one mesh, which stay joined where they meet; `most` triangles in all."""
    triangles = np.concatenate(parts)
    corners, place = np.unique(triangles.reshape(-1, 3).round(DIGITS), axis=0, return_inverse=True)
    faces, own = place.reshape(-1, 3), np.repeat(np.arange(len(parts)), [len(each) for each in parts])
    distinct = (faces != np.roll(faces, 1, axis=1)).all(axis=1)
    faces, own = faces[distinct], own[distinct]
    if most is not None and len(faces) > most:
        owners = np.full(len(corners), -1)
        owners[faces.ravel()] = np.repeat(own, 3)
        shared = np.zeros(len(corners), dtype=bool)
        shared[faces[owners[faces] != own[:, None]]] = True
        corners, faces, chosen = _with_fewer_faces(corners, faces, most, np.where(shared, -1, owners))
        own = own[chosen]
    return [_crease(corners, faces[own == k]) if (own == k).any() else (corners, faces[:0]) for k in range(len(parts))]


def _with_fewer_faces(
    corners: Array, faces: Faces, most: int, kinds: NDArray[np.int64] | None = None
) -> tuple[Array, Faces, Faces]:
    """At most `most` triangles: corners (k, 3) of one kind, of `kinds` (k,), in one cell of a grid become their mean.

    So nothing tears, unlike where edges are collapsed one by one: meshes of CAD programs consist of patches. Returns corners,
    faces, and which ones these were.
    """
    finest, coarsest = 0.0, float(np.ptp(corners, axis=0).max())
    fewer = corners, faces[:0], np.zeros(0, dtype=np.int64)
    for _ in range(HALVINGS):
        cell = (finest + coarsest) / 2
        cells = np.floor((corners - corners.min(axis=0)) / cell)
        if kinds is not None:
            cells = np.column_stack([cells, kinds])
        _, own = np.unique(cells, axis=0, return_inverse=True)
        moved = own.ravel()[faces]
        flat = (moved == np.roll(moved, 1, axis=1)).any(axis=1)
        begin = moved.argmin(axis=1)[:, None]
        turned = np.take_along_axis(moved, np.add(begin, [0, 1, 2]) % 3, axis=1)  # the smallest corner comes first
        chosen = np.flatnonzero(~flat)[np.unique(turned[~flat], axis=0, return_index=True)[1]]
        if len(chosen) > most:
            finest = cell
        else:
            number = np.bincount(own.ravel())
            means = [np.bincount(own.ravel(), each) / number for each in corners.T]
            coarsest, fewer = cell, (np.stack(means, axis=1), moved[chosen], chosen)
    return fewer


def obstacle_surfaces(scene: Scene) -> Iterator[tuple[str, Surface]]:
    """Name and surface, in the world, of each bounded obstacle; for a mesh, all its parts together.

    A mesh that is not convex is drawn with at most `TRIANGLES` triangles, a cloud as at most `CUBES` cubes.
    """
    for name, obstacle in zip(scene.names, scene.obstacles, strict=True):
        if isinstance(obstacle, PointCloud):
            yield name, _cubes(evenly_chosen(obstacle.kept, CUBES), obstacle.parts()[0].radius).placed(obstacle.pose)
        elif not isinstance(obstacle, Plane):
            shapes = obstacle.shapes()
            parts = [_mesh(each) if isinstance(each, coal.BVHModelBase) else surface_of(each) for each in shapes]
            yield name, joined(part.placed(obstacle.pose) for part in parts)


def evenly_chosen(points: Array, most: int) -> Array:
    """At most `most` of points (k, ...), at equal steps through them, with the first and the last."""
    return points if len(points) <= most else points[np.linspace(0, len(points) - 1, most).astype(int)]


def joined(parts: Iterable[Surface]) -> Surface:
    """Several surfaces as one."""
    parts = list(parts)
    return Surface(
        faces=tuple(face for part in parts for face in part.faces), edges=tuple(edge for part in parts for edge in part.edges)
    )


def plane_patches(scene: Scene, low: Array, high: Array) -> Iterator[tuple[str, Array]]:
    """Name of each plane that cuts the box from `low` to `high` (3,), and the polygon (k, 3) in which it cuts the box."""
    corners = np.array(np.meshgrid(*zip(low, high, strict=True), indexing="ij")).reshape(3, -1).T
    pairs = [(a, b) for a in range(8) for b in range(a + 1, 8) if np.count_nonzero(corners[a] != corners[b]) == 1]
    for name, obstacle in zip(scene.names, scene.obstacles, strict=True):
        if not isinstance(obstacle, Plane):
            continue
        frame = obstacle.pose
        height = (corners - frame.translation) @ frame.rotation[:, 2]
        cut = [
            corners[a] + height[a] / (height[a] - height[b]) * (corners[b] - corners[a])
            for a, b in pairs
            if height[a] * height[b] <= 0 and height[a] != height[b]
        ]
        if len(cut) >= 3:
            flat = (np.array(cut) - np.mean(cut, axis=0)) @ frame.rotation[:, :2]
            yield name, np.array(cut)[np.argsort(np.arctan2(flat[:, 1], flat[:, 0]))]


def feet_on_planes(scene: Scene, points: Array) -> Iterator[Array]:
    """Nearest point (3,) to the middle of points (k, 3) on each plane that is at most their extent away."""
    middle, size = points.mean(axis=0), np.ptp(points, axis=0).max()
    for obstacle in scene.obstacles:
        if isinstance(obstacle, Plane):
            normal = obstacle.pose.rotation[:, 2]
            height = normal @ (middle - obstacle.pose.translation)
            if abs(height) <= size:
                yield middle - height * normal


def arm_surfaces(robot: Robot, q: Array) -> list[Surface]:
    """The robot's collision bodies at q (n,), in the world, without unbounded planes such as the floor of an MJCF."""
    data = robot.model.createData()
    pin.forwardKinematics(robot.model, data, q)
    return [surface.placed(data.oMi[joint]) for joint, surface in _drawn_bodies(robot)]


@once_per_owner
def _drawn_bodies(robot: Robot) -> list[tuple[int, Surface]]:
    """The joint index of each body, and its surface in the frame of that joint."""
    endless = coal.Halfspace | coal.Plane
    objects = [each for each in robot.geometry.geometryObjects if not isinstance(each.geometry, endless)]
    return [(each.parentJoint, surface_of(each.geometry).placed(each.placement)) for each in objects]


def fit_camera(
    points: Array, ahead: Array, across: tuple[float, float], up: tuple[float, float], *, nearest: float
) -> tuple[Array, Array]:
    """Where a camera looks and where it is, (3,) each, so that points (k, 3) fill a part of its picture; z is up.

    Args:
        points: (k, 3) [m].
        ahead: (3,) direction in which the camera looks, of length 1, not upright.
        across, up: lower and upper end of the part, as tangents of the angle from the middle of the picture.
        nearest: minimum distance of the points from the camera [m].
    """
    right = np.cross(ahead, [0.0, 0.0, 1.0])
    right /= np.linalg.norm(right)
    axes = np.stack([right, np.cross(right, ahead), ahead])
    x, y, depth = (points @ axes.T).T
    # a point is inside where low ≤ (x - x₀) / (depth - d₀) ≤ high: of the camera x₀, y₀, d₀, with the largest d₀
    ends = [((v - low * depth).min(), (v - high * depth).max(), low, high) for v, (low, high) in ((x, across), (y, up))]
    begin = min(depth.min() - nearest, *((least - most) / (high - low) for least, most, low, high in ends))
    camera = np.array([*((least + most + (low + high) * begin) / 2 for least, most, low, high in ends), begin])
    target = np.array([*camera[:2], np.median(depth)])
    return target @ axes, camera @ axes


def _revolve(radius: Array, height: Array, around: int, *, rings: tuple[int, ...]) -> Surface:
    """The surface that points (radius, height) sweep about z, with edges along the circles of the points `rings`."""
    turn = np.linspace(0.0, 2 * np.pi, around + 1)
    x, y = radius[:, None] * np.cos(turn), radius[:, None] * np.sin(turn)
    grid = np.stack([x, y, np.broadcast_to(height[:, None], x.shape)], axis=2)
    faces = []
    for i in range(len(grid) - 1):
        if height[i] == height[i + 1]:  # a flat end is one polygon
            faces.append(grid[i, :-1] if radius[i] > radius[i + 1] else grid[i + 1, -1:0:-1])
        else:
            faces += list(np.stack([grid[i, :-1], grid[i, 1:], grid[i + 1, 1:], grid[i + 1, :-1]], axis=1))
    return Surface(faces=tuple(faces), edges=tuple(grid[ring] for ring in rings))


def _mesh(mesh: coal.BVHModelBase) -> Surface:
    """At most `TRIANGLES` triangles of a mesh, and the edges where it bends or ends."""
    corners, faces = merge_corners(mesh_triangles(mesh))
    if len(faces) > TRIANGLES:
        corners, faces, _ = _with_fewer_faces(corners, faces, TRIANGLES)
    sides, beside, cosines = _sides(corners, faces)
    ends = (beside < 0).any(axis=1)
    return _triangular(corners, faces, sides[ends | (np.abs(cosines) < np.cos(CREASE))])  # neighbours may face opposite ways


def _triangular(corners: Array, faces: Faces, edges: Faces) -> Surface:
    """The surface of triangles (f, 3) and edges (e, 2) between corners (k, 3)."""
    return Surface(faces=tuple(corners[faces]), edges=tuple(corners[edges]))


def _sides(corners: Array, faces: Faces) -> tuple[Faces, Faces, Array]:
    """The sides of triangles (f, 3), each once.

    Returns their ends (s, 2), the two triangles beside each (s, 2), -1 where there are not two, and the cosine of the angle
    between the normals of these two (s,).
    """
    ends = np.sort(faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    sides, index, count = np.unique(ends, axis=0, return_inverse=True, return_counts=True)
    last = np.cumsum(count) - 1
    beside = (np.argsort(index.ravel(), kind="stable") // 3)[np.stack([last - count + 1, last], axis=1)]
    normals = np.cross(corners[faces[:, 1]] - corners[faces[:, 0]], corners[faces[:, 2]] - corners[faces[:, 0]])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    cosines = np.einsum("si,si->s", *normals[beside].swapaxes(0, 1))
    beside[count != 2] = -1
    return sides, beside, cosines


def _crease(vertices: Array, faces: Faces) -> tuple[Array, Faces]:
    """The same triangles, with separate vertices on the two sides of a sharp edge."""
    _, beside, cosines = _sides(vertices, faces)
    smooth = beside[(beside >= 0).all(axis=1) & (cosines > np.cos(SHARP))]
    corners = np.stack([faces.ravel(), np.repeat(components(smooth, len(faces)), 3)], axis=1)
    chosen, index = np.unique(corners, axis=0, return_inverse=True)
    return vertices[chosen[:, 0]], index.reshape(-1, 3)


def _square(normal: Array, offset: float) -> tuple[Array, Faces]:
    """A square in the plane normal · x = offset."""
    first, second, normal = frame_along(normal).T
    corners = [offset * normal + PLANE * (a * first + b * second) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    return np.array(corners), np.array([[0, 1, 2], [0, 2, 3]])


def _cubes(points: Array, radius: float) -> Surface:
    """A cube about each of points (k, 3), as large as the ball of `radius` [m]."""
    corners = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    sides = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
    faces = points[:, None, None] + (np.pi / 6) ** (1 / 3) * radius * corners[sides]
    return Surface(faces=tuple(faces.reshape(-1, 4, 3)), edges=())


def _directions() -> Array:
    """Unit vectors spread over the sphere along a spiral (DIRECTIONS, 3)."""
    k = np.arange(DIRECTIONS) + 0.5
    z, turn = 1 - 2 * k / DIRECTIONS, np.pi * (1 + 5**0.5) * k
    return np.stack([np.sqrt(1 - z**2) * np.cos(turn), np.sqrt(1 - z**2) * np.sin(turn), z], axis=1)
