"""A coarse copy of a crowded scene: few convex pieces in place of its triangles, points and many small obstacles.

A path that starts inside one large body is pushed out of it. Among many small bodies it is pushed in different directions, and
a surface can push it to either side. So the first optimum is sought among the pieces. They only guide the search: every path
is proven in the scene itself.
"""

from dataclasses import dataclass
from functools import cached_property

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.scene import Scene
from manipplan.collision.shapes import Obstacle, Part, PointCloud
from manipplan.collision.world import core_of, mesh_triangles
from manipplan.robots.arms import farthest
from manipplan.robots.hulls import convex_hull, find_hull
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.memo import once_per_pair

#: A scene without surfaces (clouds and meshes that are not convex) is simplified if it has this number of small obstacles near
#: the robot. There are always fewer pieces, so that a coarse scene has no coarse scene of its own.
CROWD, MOST_PIECES = 100, 96
#: Edges of the grid's cells [m], tried in turn: pieces stick out of the obstacles by up to two cells.
CELLS = (0.02, 0.03, 0.045)
#: Maximum number of cells of the grid, and of sample points on all obstacles.
MOST_CELLS, MOST_SAMPLES = 8_000_000, 3_000_000
#: Maximum diagonal of boxes, diameter and length of other primitives, and diagonal of hulls that count as small [m].
SMALL_BOX, SMALL, SMALL_HULL = 0.2, 0.08, 0.04
#: Number of positions along each axis at which cuts are compared, and share of a box at which cells fill it.
CUTS, FULL = 48, 0.6
#: Largest vertical part of the unit normal of a face that counts as upright.
UPRIGHT = 1e-9
#: Maximum number of points by which upright frames are compared, and number of directions in which the outermost of them count.
MOST_TURNED, OUTLINE = 4000, 128
#: Margin around the samples of a piece, so that flat ones have a volume [m].
MARGIN = 5e-4
#: Directions of the faces of a piece in its frame (26, 3): along the axes and the diagonals of a cube [klosowski1998].
FACES = np.array([d for d in np.ndindex(3, 3, 3) if d != (1, 1, 1)], dtype=float) - 1
FACES /= np.linalg.norm(FACES, axis=1)[:, None]
CUBE = np.ones((3, 3, 3))
#: Maximum number of cells between the robot's base and the room in which it stands.
BESIDE = 10


@dataclass(frozen=True, kw_only=True, eq=False)
class PieceHull(Obstacle):
    """The convex hull of `corners` (k, 3) [m]."""

    corners: Array
    shape_name = "piece"

    def parts(self) -> list[Part]:
        return [Part(shape=convex_hull(self.corners).shape())]


@dataclass(frozen=True, kw_only=True, eq=False)
class _Balls:
    """Balls about points (k, 3) in the world with radii (k,) [m], which stand for an obstacle; whether it has a surface."""

    points: Array
    radii: Array
    has_surface: bool


@once_per_pair
def coarse_scene(scene: Scene, robot: Robot) -> Scene | None:
    """The scene with convex pieces in place of surfaces and small obstacles near the robot; None where it stays as it is.

    It stays as it is without surfaces and with few small obstacles, or where more than MOST_PIECES would be needed. Obstacles
    named in an allowed pair are kept.
    """
    named = frozenset[str]().union(*scene.allowed)
    middle, reach = _reach(robot)
    obstacles: list[Obstacle] = []
    crowd: list[_Balls] = []
    for name, obstacle in zip(scene.names, scene.obstacles, strict=True):
        balls = None if name in named else _balls(obstacle, middle, reach)
        if balls is None:
            obstacles.append(obstacle.called(name))
        elif len(balls.points):
            crowd.append(balls)
    if not any(each.has_surface for each in crowd) and len(crowd) < CROWD:
        return None
    points, radii = np.concatenate([each.points for each in crowd]), np.concatenate([each.radii for each in crowd])
    if len(points) > MOST_SAMPLES:
        return None
    prefix = "piece"
    while any(name.startswith(prefix) for name in (*scene.names, *robot.carried, *named)):
        prefix = f"coarse {prefix}"
    for cell in CELLS:
        pieces = _pieces(points, radii, cell, middle)
        if pieces is not None:
            obstacles += [PieceHull(corners=corners, name=f"{prefix} {k}") for k, corners in enumerate(pieces)]
            return Scene(obstacles, allowed=scene.allowed)
    return None


def without_pieces_at(scene: Scene, robot: Robot, q: Array, clearance: float) -> Scene:
    """A coarse scene without the pieces that are nearer than `clearance` [m] at the configurations q (m, n)."""
    model = scene.collision_model(robot)
    near = model.near_pairs(q, clearance)
    touching = {name for pair in np.unique(near.pairs) for name in model.pair_names[pair]}
    pieces = {name for name, obstacle in zip(scene.names, scene.obstacles, strict=True) if isinstance(obstacle, PieceHull)}
    return scene.without(*sorted(touching & pieces)) if touching & pieces else scene


def _reach(robot: Robot) -> tuple[Array, float]:
    """A point of the robot, and the distance from it within which all its moving bodies stay [m].

    It is inf with a prismatic joint without limits.
    """
    model = robot.model
    middle = np.asarray(model.jointPlacements[1].translation)
    offsets = [model.jointPlacements[k].translation - (0.0 if model.parents[k] else middle) for k in range(1, model.njoints)]
    lengths = sum(float(np.linalg.norm(each)) for each in offsets)
    tree = robot.tree
    slides = farthest(robot, tree)[tree.slides]
    bodies = 0.0
    for item in robot.geometry.geometryObjects:
        if item.parentJoint > 0:
            item.geometry.computeLocalAABB()
            centre = item.placement.act(item.geometry.aabb_center)
            bodies = max(bodies, float(np.linalg.norm(centre)) + item.geometry.aabb_radius)
    return middle, lengths + float(slides.sum()) + bodies


def _balls(obstacle: Obstacle, middle: Array, reach: float) -> _Balls | None:
    """The balls within `reach` [m] of a point (3,) that stand for an obstacle; None where it stays as it is."""
    points, radii = [np.empty((0, 3))], [np.empty(0)]
    parts = obstacle.parts()
    for part in parts:
        samples: Array | None
        radius = part.radius
        if isinstance(obstacle, PointCloud):
            samples = _to_world(obstacle.kept, obstacle.pose)
        elif isinstance(part.shape, coal.BVHModelBase):
            samples = _spread(_to_world(mesh_triangles(part.shape), obstacle.pose), middle, reach)
        else:
            local, radius = _small(part)
            samples = None if local is None else _to_world(local, obstacle.pose)
        if samples is None:
            return None
        samples = samples[np.linalg.norm(samples - middle, axis=1) < reach + radius]
        points.append(samples)
        radii.append(np.full(len(samples), radius))
    has_surface = any(isinstance(part.shape, coal.BVHModelBase) for part in parts)
    return _Balls(points=np.concatenate(points), radii=np.concatenate(radii), has_surface=has_surface)


def _to_world(points: Array, pose: pin.SE3) -> Array:
    return np.asarray(points @ pose.rotation.T + pose.translation)


def _small(part: Part) -> tuple[Array | None, float]:
    """Points (k, 3), at most a cell apart, and the radius [m] of balls about them that fill a part; None for a large one."""
    shape = part.shape
    if isinstance(shape, coal.Box):
        size = 2 * np.asarray(shape.halfSide)
        if np.linalg.norm(size) + 2 * part.radius > SMALL_BOX:
            return None, part.radius
        counts = np.ceil(size / CELLS[0]).astype(int) + 1
        lines = [np.linspace(-edge / 2, edge / 2, count) for edge, count in zip(size, counts, strict=True)]
        return np.stack(np.meshgrid(*lines, indexing="ij"), axis=-1).reshape(-1, 3), part.radius
    if not isinstance(shape, coal.ConvexBase | coal.Sphere | coal.Capsule | coal.Cylinder):
        return None, part.radius
    points, radius = core_of(shape)
    radius += part.radius
    length, most = float(np.linalg.norm(np.ptp(points, axis=0))), SMALL_HULL if isinstance(shape, coal.ConvexBase) else SMALL
    if length + 2 * radius > most:
        return None, radius
    if len(points) == 2:
        along = np.linspace(0.0, 1.0, int(np.ceil(length / CELLS[0])) + 1)[:, None]
        points = points[0] + along * (points[1] - points[0])
    return points, radius


def _spread(triangles: Array, middle: Array, reach: float) -> Array | None:
    """Points (k, 3), at most a cell apart, on triangles (t, 3, 3) within `reach` [m] of a point (3,); None for too many."""
    found, count = [np.empty((0, 3))], 0
    while len(triangles):
        centre = triangles.mean(axis=1)
        size = np.linalg.norm(triangles - centre[:, None], axis=2).max(axis=1)
        triangles = triangles[np.linalg.norm(centre - middle, axis=1) < reach + size]
        edges = np.linalg.norm(triangles - np.roll(triangles, 1, axis=1), axis=2).max(axis=1)
        large = edges > CELLS[0]
        found.append(triangles[~large].reshape(-1, 3))
        count += len(found[-1])
        if count + 12 * int(large.sum()) > MOST_SAMPLES:
            return None
        a, b, c = triangles[large].transpose(1, 0, 2)
        ab, bc, ca = (a + b) / 2, (b + c) / 2, (c + a) / 2
        triangles = np.concatenate([np.stack(each, axis=1) for each in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))])
    return np.concatenate(found)


def _pieces(points: Array, radii: Array, cell: float, middle: Array) -> list[Array] | None:
    """Corners (c, 3) of convex pieces around balls of `radii` (k,) about points (k, 3); None for too many pieces or cells."""
    if not len(points):
        return []
    grid = _BallGrid.of(points, radii, cell, middle)
    if grid is None or grid.groups > MOST_PIECES:
        return None
    open_parts = [np.flatnonzero(grid.group == number) for number in range(1, grid.groups + 1)]
    done: list[Array] = []
    while open_parts:
        if len(open_parts) + len(done) > MOST_PIECES:
            return None
        part = open_parts.pop()
        own = np.zeros(len(grid.solid), dtype=bool)
        own[part] = True
        inside = np.flatnonzero(own[grid.owner])
        if not len(inside):
            continue
        hull = _Polytope.of(points[inside], radii[inside])
        corners = hull.corners()
        cut = _find_cut(grid.solid[part], cell, hull.frames) if grid.has_empty(hull, corners) else None
        if cut is not None:
            open_parts += [part[cut], part[~cut]]
        elif find_hull(corners) is not None:
            done.append(corners)
        else:
            return None
    return done


@dataclass(frozen=True, kw_only=True, eq=False)
class _BallGrid:
    """Cells of a grid around balls.

    Attributes:
        low, cell: corner (3,) and edge of the cells [m].
        filled: (nx, ny, nz) cells that hold something, their neighbours, and what these enclose, except around the robot.
        solid: (c, 3) centres of the cells that hold something or are enclosed.
        group: (c,) number, from 1, of the connected group of filled cells to which each belongs.
        groups: number of these groups.
        owner: (k,) index of the solid cell of each ball's centre.
    """

    low: Array
    cell: float
    filled: NDArray[np.bool_]
    solid: Array
    group: NDArray[np.intp]
    groups: int
    owner: NDArray[np.intp]

    @classmethod
    def of(cls, points: Array, radii: Array, cell: float, middle: Array) -> "_BallGrid | None":
        from scipy import ndimage

        wide = radii > cell / 2
        sides = [points[wide] + sign * radii[wide, None] * axis for sign in (1, -1) for axis in np.eye(3)]
        around = np.concatenate([points, *sides])
        low = around.min(axis=0) - 3 * cell
        shape = np.ceil((around.max(axis=0) + 3 * cell - low) / cell)
        if np.prod(shape) > MOST_CELLS:
            return None
        filled = np.zeros(shape.astype(int), dtype=bool)
        filled[tuple(((around - low) / cell).astype(int).T)] = True
        filled = _with_enclosed(ndimage.binary_dilation(filled, CUBE), (middle - low) / cell)
        solid = ndimage.binary_erosion(filled, CUBE)
        where, number = np.argwhere(solid), np.full(filled.shape, -1, dtype=np.intp)
        number[solid] = np.arange(len(where))
        label, groups = ndimage.label(filled, CUBE)
        return cls(
            low=low,
            cell=cell,
            filled=filled,
            solid=low + cell * (where + 0.5),
            group=label[solid],
            groups=groups,
            owner=number[tuple(((points - low) / cell).astype(int).T)],
        )

    def has_empty(self, hull: "_Polytope", corners: Array) -> bool:
        """Whether the centre of a cell that is not filled lies within half a cell of a hull with these corners (c, 3)."""
        first = np.maximum((corners.min(axis=0) - self.low) // self.cell - 1, 0).astype(int)
        last = np.minimum((corners.max(axis=0) - self.low) // self.cell + 2, self.filled.shape).astype(int)
        x, y = (self.low[i] + self.cell * (np.arange(first[i], last[i]) + 0.5) for i in range(2))
        # of each column of cells: z times the third number of a face is at most its room
        room = (
            (hull.offsets + self.cell / 2)[:, None, None]
            - hull.faces[:, 0, None, None] * x[:, None]
            - hull.faces[:, 1, None, None] * y
        )
        rise = hull.faces[:, 2, None, None]
        up, down = (np.flatnonzero(sign * hull.faces[:, 2] > UPRIGHT) for sign in (1, -1))
        upright = np.abs(hull.faces[:, 2]) <= UPRIGHT
        high, low = (room[up] / rise[up]).min(axis=0), (room[down] / rise[down]).max(axis=0)
        ends = [(each - self.low[2]) / self.cell - 0.5 for each in (low, high)]
        begin = np.clip(np.ceil(ends[0]), first[2], last[2]).astype(int)
        end = np.maximum(np.clip(np.floor(ends[1]) + 1, first[2], last[2]).astype(int), begin)
        empty = self._empty_below[first[0] : last[0], first[1] : last[1]]
        counts = np.take_along_axis(empty, end[..., None], 2) - np.take_along_axis(empty, begin[..., None], 2)
        return bool(((counts[..., 0] > 0) & (room[upright] >= 0).all(axis=0)).any())

    @cached_property
    def _empty_below(self) -> NDArray[np.int32]:
        """Number of cells (nx, ny, nz + 1) of each column that are not filled, below each of its cells."""
        counts = np.zeros(np.add(self.filled.shape, (0, 0, 1)), dtype=np.int32)
        np.cumsum(~self.filled, axis=2, out=counts[:, :, 1:])
        return counts


def _with_enclosed(filled: NDArray[np.bool_], middle: Array) -> NDArray[np.bool_]:
    """The filled cells and those that they enclose, except for the room in which the robot stands, nearest to `middle` (3,)."""
    from scipy import ndimage

    rooms, _ = ndimage.label(~filled)
    first = np.clip(middle - BESIDE, 0, filled.shape).astype(int)
    last = np.clip(middle + BESIDE, 0, filled.shape).astype(int)
    window = rooms[tuple(slice(a, b) for a, b in zip(first, last, strict=True))]
    empty = np.argwhere(window > 0)
    enclosed = rooms != rooms[0, 0, 0]
    if len(empty):
        nearest = empty[np.argmin(((empty + first + 0.5 - middle) ** 2).sum(axis=1))]
        enclosed &= rooms != window[tuple(nearest)]
    return np.asarray(enclosed)


@dataclass(frozen=True, kw_only=True, eq=False)
class _Polytope:
    """The hull faces · x <= offsets of balls, with FACES in the best of three frames.

    Attributes:
        frames: (3, 3, 3) the frames that were compared, with their axes as rows.
        faces, offsets: unit normals (26, 3) and offsets (26,) [m].
        inner: (3,) a point inside.
    """

    frames: Array
    faces: Array
    offsets: Array
    inner: Array

    @classmethod
    def of(cls, points: Array, radii: Array) -> "_Polytope":
        inner = points.mean(axis=0)
        centred = points - inner
        frames = np.array([np.eye(3), _upright(points), np.linalg.eigh(centred.T @ centred)[1].T])
        columns = np.ascontiguousarray(points.T)  # extremes along a row are found much faster than along a column
        frame = min(frames, key=lambda axes: round(float(np.prod(np.ptp(axes @ columns, axis=1) + MARGIN)), 9))
        faces = FACES @ frame
        offsets = np.array([(face @ columns + radii).max() for face in faces]) + MARGIN
        return cls(frames=frames, faces=faces, offsets=offsets, inner=inner)

    def corners(self) -> Array:
        """Its corners (k, 3)."""
        from scipy.spatial import HalfspaceIntersection

        around = np.column_stack([self.faces, self.faces @ self.inner - self.offsets])
        return np.asarray(HalfspaceIntersection(around, np.zeros(3)).intersections + self.inner)


def _upright(points: Array) -> Array:
    """The frame (3, 3) with a vertical axis in which the box around points (k, 3) has the smallest base, to 0.05°."""
    plan = points[:: 1 + len(points) // MOST_TURNED, :2]
    turns = np.linspace(0.0, 2 * np.pi, OUTLINE, endpoint=False)
    plan = plan[np.argmax(np.array([np.cos(turns), np.sin(turns)]).T @ plan.T, axis=1)]
    angle = 0.0
    for turns in (np.arange(0.0, 90.0), np.arange(-1.0, 1.0, 0.05)):
        angles = np.radians(turns) + angle
        along = np.array([np.cos(angles), np.sin(angles)])
        base = np.ptp(plan @ along, axis=0) * np.ptp(plan @ np.array([-along[1], along[0]]), axis=0)
        angle = angles[int(np.argmin(np.round(base, 9)))]
    return np.array([[np.cos(angle), np.sin(angle), 0.0], [-np.sin(angle), np.cos(angle), 0.0], [0.0, 0.0, 1.0]])


def _find_cut(solid: Array, cell: float, frames: Array) -> NDArray[np.bool_] | None:
    """Which cells (k, 3) lie on one side of the best plane normal to an axis of the frames (f, 3, 3); None for a single cell.

    The box around a side counts unless the cells fill it. The best plane is that with the smallest volume that counts, and of
    these the one with the smallest boxes.
    """
    best: NDArray[np.bool_] | None = None
    smallest_volumes = [np.inf, np.inf]
    for local in solid @ frames.transpose(0, 2, 1):
        columns = np.ascontiguousarray(local.T)
        for along in columns:
            low, length = along.min(), np.ptp(along)
            if not length > 0:
                continue
            slice_of = np.clip(np.ceil((along - low) / length * CUTS - 0.5), 0, CUTS).astype(np.int16)
            counts = np.bincount(slice_of, minlength=CUTS + 1)
            filled = np.flatnonzero(counts)
            if len(filled) < 2:
                continue
            below = np.cumsum(counts[filled])
            ordered = columns[:, np.argsort(slice_of, kind="stable")]
            first = np.append(0, below[:-1])
            least, most = np.minimum.reduceat(ordered, first, axis=1), np.maximum.reduceat(ordered, first, axis=1)
            sizes = _sizes(least, most)[:, :-1], _sizes(least[:, ::-1], most[:, ::-1])[:, -2::-1]
            boxes = np.prod(np.array(sizes) + cell, axis=1)
            is_filled = np.array([below[:-1], len(solid) - below[:-1]]) * cell**3 >= FULL * boxes
            volumes = np.round([np.where(is_filled, 0.0, boxes).sum(axis=0), boxes.sum(axis=0)], 9)
            smallest = int(np.lexsort(volumes[::-1])[0])
            if volumes[:, smallest].tolist() < smallest_volumes:
                best, smallest_volumes = slice_of <= filled[smallest], volumes[:, smallest].tolist()
    return best


def _sizes(least: Array, most: Array) -> Array:
    """Edges (3, k) of the boxes around the first 1, 2, ... k boxes with these corners (3, k)."""
    return np.asarray(np.maximum.accumulate(most, axis=1) - np.minimum.accumulate(least, axis=1))
