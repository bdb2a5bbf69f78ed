"""Shapes as polygons and edges, for drawing obstacles and an arm's links.

Drawing in space: lit surfaces, skeletons and names on axes with projection="3d", and the limits of these axes.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import coal
import numpy as np
import pinocchio as pin

from manipplan.collision.scene import Scene
from manipplan.collision.shapes import Plane, PointCloud
from manipplan.collision.surfaces.shells import merge_corners
from manipplan.collision.world import core_of, mesh_triangles
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.memo import once_per_owner
from manipplan.viz import style

#: Number of flat faces around a round shape, and from pole to pole of a ball.
AROUND, UP = 28, 14
#: Number of directions whose extreme points make the hull that is drawn for a mesh.
DIRECTIONS = 50
#: Minimum angle between neighbouring faces of a hull at which the edge between them is drawn [rad].
CREASE = 0.35
#: Maximum number of triangles of a mesh among the obstacles, and of cubes of a cloud.
TRIANGLES, CUBES = 5000, 2000


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


def surface_of(shape: coal.CollisionGeometry) -> Surface:
    """The surface of a coal shape in its own frame; for a mesh, the hull of its extreme points in 50 directions.

    A shape of a type that occurs neither in scenes nor in URDF files is drawn as its bounding box.
    """
    if isinstance(shape, coal.Sphere):
        return _ball(np.full(3, shape.radius))
    if isinstance(shape, coal.Ellipsoid):
        return _ball(np.array(shape.radii))
    if isinstance(shape, coal.Capsule):
        up = np.linspace(-np.pi / 2, np.pi / 2, UP + 2 - UP % 2)  # an even number: the equator appears twice, once per end
        ends = np.repeat([-shape.halfLength, shape.halfLength], len(up) // 2)
        return _revolve(shape.radius * np.cos(up), shape.radius * np.sin(up) + ends, rings=(len(up) // 2 - 1, len(up) // 2))
    if isinstance(shape, coal.Cylinder):
        r, z = shape.radius, shape.halfLength
        return _revolve(np.array([0.0, r, r, 0.0]), np.array([-z, -z, z, z]), rings=(1, 2))
    points, _ = core_of(shape)
    if isinstance(shape, coal.BVHModelBase):
        if np.linalg.matrix_rank(points - points[0], tol=1e-9) < 3:  # a flat mesh has no hull
            return Surface(faces=tuple(mesh_triangles(shape)), edges=())
        points = points[np.unique((points @ _directions().T).argmax(axis=0))]
    return _hull(points)


def obstacle_surfaces(scene: Scene) -> Iterator[tuple[str, Surface]]:
    """Name and surface, in the world, of each bounded obstacle; for a mesh, all its parts together.

    A mesh that is not convex is drawn with at most about `TRIANGLES` triangles, a cloud as at most `CUBES` cubes.
    """
    for name, obstacle in zip(scene.names, scene.obstacles, strict=True):
        if isinstance(obstacle, PointCloud):
            yield name, _cubes(evenly_chosen(obstacle.kept, CUBES), obstacle.parts()[0].radius).placed(obstacle.pose)
        elif not isinstance(obstacle, Plane):
            shapes = obstacle.shapes()
            parts = [_mesh(each) if isinstance(each, coal.BVHModelBase) else surface_of(each) for each in shapes]
            yield name, joined(part.placed(obstacle.pose) for part in parts)


def evenly_chosen(points: Array, most: int) -> Array:
    """At most `most` of points (k, 3), at equal steps through them."""
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


def _ball(radii: Array) -> Surface:
    up = np.linspace(-np.pi / 2, np.pi / 2, UP + 1)
    unit = _revolve(np.cos(up), np.sin(up), rings=(UP // 2,))
    return Surface(faces=tuple(face * radii for face in unit.faces), edges=tuple(edge * radii for edge in unit.edges))


def _revolve(radius: Array, height: Array, *, rings: tuple[int, ...]) -> Surface:
    """The surface that points (radius, height) sweep about z, with edges along the circles of the points `rings`."""
    turn = np.linspace(0.0, 2 * np.pi, AROUND + 1)
    x, y = radius[:, None] * np.cos(turn), radius[:, None] * np.sin(turn)
    grid = np.stack([x, y, np.broadcast_to(height[:, None], x.shape)], axis=2)
    faces = []
    for i in range(len(grid) - 1):
        if height[i] == height[i + 1]:  # a flat end is one polygon
            faces.append(grid[i if radius[i] > radius[i + 1] else i + 1, :-1])
        else:
            faces += [np.array([grid[i, j], grid[i, j + 1], grid[i + 1, j + 1], grid[i + 1, j]]) for j in range(AROUND)]
    return Surface(faces=tuple(faces), edges=tuple(grid[ring] for ring in rings))


def _hull(points: Array) -> Surface:
    """The convex hull of points (k, 3): triangles, and edges where it bends."""
    from scipy.spatial import ConvexHull

    hull = ConvexHull(points)
    faces, normals = points[hull.simplices], hull.equations[:, :3]
    edges = []
    for face, (corners, beside) in enumerate(zip(hull.simplices, hull.neighbors, strict=True)):
        for k, other in enumerate(beside):  # the neighbour opposite to corner k
            if other > face and normals[face] @ normals[other] < np.cos(CREASE):
                edges.append(points[np.delete(corners, k)])
    return Surface(faces=tuple(faces), edges=tuple(edges))


def _mesh(mesh: coal.BVHModelBase) -> Surface:
    """The triangles of a mesh, and the edges where it bends or ends; corners in one cell of a grid are one if it has many."""
    triangles = mesh_triangles(mesh)
    corners, faces = merge_corners(triangles)
    cell = np.ptp(corners, axis=0).max() / 200
    while len(faces) > TRIANGLES:
        corners, faces = merge_corners((np.rint(corners / cell) * cell)[faces])
        faces = faces[np.unique(np.sort(faces, axis=1), axis=0, return_index=True)[1]]
        cell *= 1.3
    normals = np.cross(corners[faces[:, 1]] - corners[faces[:, 0]], corners[faces[:, 2]] - corners[faces[:, 0]])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    sides: dict[tuple[int, ...], list[int]] = {}
    for k, face in enumerate(faces.tolist()):
        for side in ((0, 1), (1, 2), (2, 0)):
            sides.setdefault(tuple(sorted(face[each] for each in side)), []).append(k)
    bends = np.cos(CREASE)
    edges = [side for side, beside in sides.items() if len(beside) != 2 or abs(normals[beside[0]] @ normals[beside[1]]) < bends]
    return Surface(faces=tuple(corners[faces]), edges=tuple(corners[list(edge)] for edge in edges))


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


#: Direction towards the light.
LIGHT = np.array([0.35, -0.5, 0.8])
#: Margin of the axes around their contents, and minimum side of the axes, as shares of the longest side.
MARGIN, LEAST = 0.04, 0.3
#: Drawing order of lines and names, above surfaces.
LINES, NAMES = 60, 70
#: Maximum distance between the ends of a closed tool path, as a share of its extent.
CLOSED = 0.05
#: Maximum difference of two tool paths that are drawn as one, as a share of their size.
EQUAL_PATHS = 1e-2


def draw_surface(ax: Any, surface: Surface, colour: str, *, alpha: float, edges: bool = False) -> None:
    """Draw a surface, lit from one side, on 3D axes, optionally with its edges."""
    from matplotlib.colors import to_rgb
    from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

    if not surface.faces:
        return
    shades = _brightness(surface.faces)[:, None] * to_rgb(colour)
    lit = np.concatenate([np.clip(shades, 0, 1), np.full((len(shades), 1), alpha)], axis=1)
    ax.add_collection3d(Poly3DCollection(_equal(surface.faces), facecolors=lit, edgecolors="none", linewidths=0))
    if edges and surface.edges:  # a cloud has none
        ax.add_collection3d(Line3DCollection(surface.edges, colors=colour, linewidths=0.8))


def draw_skeleton(ax: Any, points: Array, *, alpha: float = 1.0, colour: str = style.ARM) -> None:
    """Draw the lines between joints (k, 2) or (k, 3), and dots at all but the last."""
    ax.plot(*points.T, color=colour, linewidth=1.4, alpha=alpha, solid_capstyle="round", zorder=LINES)
    ax.plot(*points[:-1].T, "o", color=colour, markersize=2.5, alpha=alpha, zorder=LINES)


def draw_ways(ax: Any, ways: Mapping[str, Sequence[Array]]) -> None:
    """Draw the paths (k, 2) or (k, 3) of all tools in one or two motions by name; the second is the first's initial path.

    If both are the same, as along a workspace path that is followed, one line gets both names.
    """
    first, *others = (np.concatenate(each) for each in ways.values())
    if others and np.abs(others[0] - first).max() < EQUAL_PATHS * np.ptp(first, axis=0).max():
        ways = {" and ".join(ways): next(iter(ways.values()))}
    for (name, tools), colour, width in zip(ways.items(), (style.OPTIMUM, style.SEED), (2.0, 1.3), strict=False):
        label = f"{'tools' if len(tools) > 1 else 'tool'}, {name}"
        for k, way in enumerate(tools):
            ax.plot(*way.T, color=colour, linewidth=width, label=None if k else label, zorder=LINES)


def write(ax: Any, at: Array, text: str, colour: str) -> None:
    """Write a name at a point (2,) or (3,), with a white outline so that it is legible over the object it names."""
    from matplotlib.patheffects import withStroke

    rim = [withStroke(linewidth=2, foreground="white")]
    ax.text(*at, text, color=colour, fontsize=8, ha="center", va="bottom", zorder=NAMES, path_effects=rim)


def write_ends(ax: Any, way: Array) -> None:
    """Write "start" and "goal" at the ends of a tool path (k, 2) or (k, 3), or both in one label for a closed path."""
    if np.linalg.norm(way[-1] - way[0]) > CLOSED * np.ptp(way, axis=0).max():
        write(ax, way[0], "start", style.ARM)
        write(ax, way[-1], "goal", style.ARM)
    else:
        write(ax, way[0], "start and goal", style.ARM)


def look_at(ax: Any, seen: Iterable[Array], *, zoom: float = 1.0) -> None:
    """Set the limits of 3D axes around points, with the same scale along all three."""
    from matplotlib.ticker import MaxNLocator

    low, high = box_around(seen)
    for axis, side in zip((ax.xaxis, ax.yaxis, ax.zaxis), high - low, strict=True):
        axis.set_major_locator(MaxNLocator(max(3, round(7 * side / (high - low).max())), steps=[1, 2, 5, 10], prune="both"))
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    ax.set_box_aspect(high - low, zoom=zoom)
    ax.view_init(elev=22, azim=-55)
    style.name_axes(ax)


def points_of(surfaces: Iterable[Surface]) -> list[Array]:
    """Corners of the surfaces that have faces."""
    return [surface.points for surface in surfaces if surface.faces]


def box_around(seen: Iterable[Array]) -> tuple[Array, Array]:
    """Lower and upper corner of the axes that show all points (k, 3)."""
    points = np.concatenate(list(seen))
    low, high = points.min(axis=0), points.max(axis=0)
    longest = (high - low).max()
    spare = MARGIN * longest + np.maximum(LEAST * longest - (high - low), 0.0) / 2
    return low - spare, high + spare


def _equal(faces: tuple[Array, ...]) -> Array:
    """Polygons as one array (f, k, 3); polygons with fewer corners repeat some of them.

    From polygons of different sizes Matplotlib makes an array with uninitialised memory, and takes axis limits from it.
    """
    most = max(map(len, faces))
    return np.array([face[np.arange(most) * len(face) // most] for face in faces])


def _brightness(faces: tuple[Array, ...]) -> Array:
    """Brightness of each polygon, (k,), from the angle of its normal to the light, for either side."""
    normals = np.array([np.cross(face[1] - face[0], face[2] - face[1]) for face in faces])
    long = np.linalg.norm(normals, axis=1)
    facing = np.abs(normals @ LIGHT) / np.maximum(long * np.linalg.norm(LIGHT), 1e-15)
    return np.asarray(0.72 + 0.28 * facing)
