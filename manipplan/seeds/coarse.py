"""A coarse copy of a crowded scene: few convex pieces around its many triangles, points and small obstacles.

Inside one large body a path is pushed out of it. Inside a heap of small ones it is pushed in all directions, and the surface
of a solid, or of a cloud, pushes it either way. So a first path is optimised among the pieces. They are a means of search
only: every path is checked against the scene itself.
"""

from dataclasses import dataclass

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.primitives import core_of, mesh_triangles
from manipplan.collision.scene import Scene
from manipplan.collision.shapes import Obstacle, Part
from manipplan.robots.hulls import convex_hull
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.memo import once_per_owner

#: A scene with fewer triangles, points and small obstacles than this is not simplified.
CROWD = 100
#: Edges of the grid's cells [m], tried in turn: pieces stick out of the obstacles by up to two cells.
CELLS = (0.02, 0.03, 0.045)
#: Maximum number of pieces, and of cells of the grid.
MOST_PIECES, MOST_CELLS = 64, 8_000_000
#: A box with a larger diagonal, and another convex shape wider than the second value, stays as it is [m].
SMALL_BOX, SMALL = 0.2, 0.08
#: Number of positions along each axis at which cuts are compared, and share of a box at which cells fill it.
CUTS, FULL = 24, 0.7
#: Margin around the samples of a piece, so that flat ones have a volume [m].
MARGIN = 5e-4
#: Maximum number of points on the triangles of one mesh.
MOST_SAMPLES = 2_000_000
#: Directions of the faces of a piece in its frame (26, 3): along the axes and the diagonals of a cube.
FACES = np.array([d for d in np.ndindex(3, 3, 3) if d != (1, 1, 1)], dtype=float) - 1
FACES /= np.linalg.norm(FACES, axis=1)[:, None]


@dataclass(frozen=True, kw_only=True, eq=False)
class Piece(Obstacle):
    """The convex hull of `corners` (k, 3) [m]."""

    corners: Array
    shape_name = "piece"

    def parts(self) -> list[Part]:
        return [Part(shape=convex_hull(self.corners))]


@once_per_owner
def coarse_scene(scene: Scene, robot: Robot) -> Scene | None:
    """The scene with at most MOST_PIECES convex pieces in place of what is small and near the robot.

    None where the scene is simple as it is, or that many pieces do not suffice. Obstacles named in an allowed pair stay as they
    are.
    """
    named = frozenset[str]().union(*scene.allowed)
    kept: list[Obstacle] = []
    crowd: list[tuple[Array, Array]] = []
    count = 0
    for name, obstacle in zip(scene.names, scene.obstacles, strict=True):
        found = [] if name in named else [_samples(part, obstacle.pose) for part in obstacle.parts()]
        if found and all(each is not None for each in found):
            crowd += [each for each in found if each is not None]
            count += sum(len(each[0]) if len(each[0]) > CROWD else 1 for each in found if each is not None)
        else:
            kept.append(obstacle.called(name))
    if count < CROWD:
        return None
    points, radii = (np.concatenate(each) for each in zip(*crowd, strict=True))
    middle, reach = _reach(robot)
    near = np.linalg.norm(points - middle, axis=1) < reach + radii
    points, radii = points[near], radii[near]
    taken, prefix = (*scene.names, *robot.carried), "piece"
    while any(name.startswith(prefix) for name in taken):
        prefix = f"coarse {prefix}"
    for cell in CELLS:
        pieces = _pieces(points, radii, cell)
        if pieces is not None:
            kept += [Piece(corners=corners, name=f"{prefix} {k}") for k, corners in enumerate(pieces)]
            return Scene(kept, allowed=scene.allowed)
    return None


def _reach(robot: Robot) -> tuple[Array, float]:
    """A point of the robot and a distance from it that no body exceeds [m]."""
    placements = [robot.model.jointPlacements[k].translation for k in range(1, robot.model.njoints)]
    lengths = sum(float(np.linalg.norm(each)) for each in placements[1:])
    slides = np.maximum(np.abs(robot.limits.lower), np.abs(robot.limits.upper))[np.array(robot.joint_types) == "prismatic"]
    bodies = 0.0
    for item in robot.geometry.geometryObjects:
        item.geometry.computeLocalAABB()
        middle = item.placement.act(item.geometry.aabb_center)
        bodies = max(bodies, float(np.linalg.norm(middle)) + item.geometry.aabb_radius)
    return np.asarray(placements[0]), lengths + float(slides.sum()) + bodies


def _samples(part: Part, pose: pin.SE3) -> tuple[Array, Array] | None:
    """Points (k, 3) of a part in the world and the radius (k,) of the ball around each [m]; None where it stays as it is."""
    shape = part.shape
    if isinstance(shape, coal.BVHModelBase) and shape.num_tris:
        points = _spread(mesh_triangles(shape), CELLS[0])
        if points is None:
            return None
        radius = part.radius
    elif isinstance(shape, coal.Box):
        size = 2 * np.asarray(shape.halfSide)
        if np.linalg.norm(size) > SMALL_BOX:
            return None
        counts = np.ceil(size / (2 * CELLS[0])).astype(int) + 1
        points = (np.array(list(np.ndindex(*counts))) / (counts - 1) - 0.5) * size
        radius = part.radius
    elif isinstance(shape, coal.BVHModelBase | coal.ConvexBase | coal.Sphere | coal.Capsule | coal.Cylinder):
        points, radius = core_of(shape)
        radius += part.radius
        if not isinstance(shape, coal.BVHModelBase) and np.linalg.norm(np.ptp(points, axis=0)) + 2 * radius > SMALL:
            return None
    else:
        return None
    return points @ pose.rotation.T + pose.translation, np.full(len(points), radius)


def _spread(triangles: Array, spacing: float) -> Array | None:
    """Corners (k, 3) of triangles (t, 3, 3) and points on them, at most `spacing` [m] apart; None where there are too many."""
    found = []
    while len(triangles):
        found.append(triangles.reshape(-1, 3))
        if sum(map(len, found)) > MOST_SAMPLES:
            return None
        large = np.linalg.norm(triangles - np.roll(triangles, 1, axis=1), axis=2).max(axis=1) > spacing
        a, b, c = triangles[large].transpose(1, 0, 2)
        ab, bc, ca = (a + b) / 2, (b + c) / 2, (c + a) / 2
        triangles = np.concatenate([np.stack(each, axis=1) for each in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))])
    return np.concatenate(found)


def _pieces(points: Array, radii: Array, cell: float) -> list[Array] | None:
    """Corners (c, 3) of convex pieces around balls of `radii` (k,) about points (k, 3); None for too many pieces or cells."""
    if not len(points):
        return []
    grid = _Grid.of(points, radii, cell)
    if grid is None:
        return None
    open_parts, done = grid.groups(), list[Array]()
    while open_parts:
        if len(open_parts) + len(done) > MOST_PIECES:
            return None
        part = open_parts.pop()
        inside = np.isin(grid.owner, part)
        if not inside.any():
            continue
        hull = _Hull.of(points[inside], radii[inside])
        cut = _cut(grid.solid[part], cell, hull.frame) if grid.has_empty(hull) else None
        if cut is None:
            done.append(hull.corners())
        else:
            open_parts += [part[cut], part[~cut]]
    return done


@dataclass(frozen=True, kw_only=True, eq=False)
class _Grid:
    """Cells of a grid around balls.

    Attributes:
        low, cell: corner (3,) and edge of the cells [m].
        filled: (nx, ny, nz) cells that hold something, their neighbours, and what these enclose.
        solid: (c, 3) centres of the cells that hold something or are enclosed.
        group: (c,) number of the connected group of filled cells to which each belongs.
        owner: (k,) index of the solid cell of each ball's centre.
    """

    low: Array
    cell: float
    filled: NDArray[np.bool_]
    solid: Array
    group: NDArray[np.intp]
    owner: NDArray[np.intp]

    @classmethod
    def of(cls, points: Array, radii: Array, cell: float) -> "_Grid | None":
        from scipy import ndimage

        wide = radii > cell / 2
        sides = [points[wide] + sign * radii[wide, None] * axis for sign in (1, -1) for axis in np.eye(3)]
        around = np.concatenate([points, *sides])
        low = around.min(axis=0) - 3 * cell
        shape = np.ceil((around.max(axis=0) + 3 * cell - low) / cell).astype(int)
        if np.prod(shape.astype(float)) > MOST_CELLS:
            return None
        filled, cube = np.zeros(shape, dtype=bool), np.ones((3, 3, 3))
        filled[tuple(((around - low) / cell).astype(int).T)] = True
        filled = ndimage.binary_fill_holes(ndimage.binary_dilation(filled, cube))
        solid = ndimage.binary_erosion(filled, cube)
        where = np.argwhere(solid)
        number = np.full(shape, -1, dtype=np.intp)
        number[solid] = np.arange(len(where))
        return cls(
            low=low,
            cell=cell,
            filled=filled,
            solid=low + cell * (where + 0.5),
            group=ndimage.label(filled, cube)[0][solid],
            owner=number[tuple(((points - low) / cell).astype(int).T)],
        )

    def groups(self) -> list[NDArray[np.intp]]:
        """The indices of the solid cells in each connected group."""
        return [np.flatnonzero(self.group == number) for number in np.unique(self.group)]

    def has_empty(self, piece: "_Hull") -> bool:
        """Whether the centre of a cell that is not filled lies within half a cell of a hull."""
        first = np.maximum((piece.low - self.cell - self.low) // self.cell, 0).astype(int)
        last = ((piece.high + self.cell - self.low) // self.cell).astype(int)
        inside = self.filled[tuple(slice(a, b + 1) for a, b in zip(first, last, strict=True))]
        left = self.low + self.cell * (np.argwhere(~inside) + first + 0.5)
        for face, offset in zip(piece.faces, piece.offsets, strict=True):
            left = left[left @ face <= offset + self.cell / 2]
        return len(left) > 0


@dataclass(frozen=True, kw_only=True, eq=False)
class _Hull:
    """The hull faces · x <= offsets of balls, with FACES in the better of two frames.

    Attributes:
        frame: (3, 3) axes of the frame as rows.
        faces, offsets: unit normals (26, 3) and offsets (26,) [m].
        inner: (3,) a point inside.
        low, high: (3,) bounds of the balls [m].
    """

    frame: Array
    faces: Array
    offsets: Array
    inner: Array
    low: Array
    high: Array

    @classmethod
    def of(cls, points: Array, radii: Array) -> "_Hull":
        inner = points.mean(axis=0)
        frames = (np.eye(3), np.linalg.svd(points - inner, full_matrices=len(points) < 3)[2])
        frame = min(frames, key=lambda axes: float(np.prod(np.ptp(points @ axes.T, axis=0) + MARGIN)))
        faces = FACES @ frame
        offsets = np.array([(points @ face + radii).max() for face in faces]) + MARGIN
        low, high = (points - radii[:, None]).min(axis=0), (points + radii[:, None]).max(axis=0)
        return cls(frame=frame, faces=faces, offsets=offsets, inner=inner, low=low, high=high)

    def corners(self) -> Array:
        """Its corners (k, 3)."""
        from scipy.spatial import HalfspaceIntersection

        around = np.column_stack([self.faces, self.faces @ self.inner - self.offsets])
        return np.asarray(HalfspaceIntersection(around, np.zeros(3)).intersections + self.inner)


def _cut(solid: Array, cell: float, frame: Array) -> NDArray[np.bool_] | None:
    """Which cells (k, 3) lie on one side of the best plane normal to an axis of the frame; None for a single cell.

    The box around a side counts unless the cells fill it. The best plane is that with the smallest volume that counts, and of
    these the one with the smallest boxes.
    """
    best, least = None, (np.inf, np.inf)
    for axis in frame:
        along = solid @ axis
        low, width = along.min(), np.ptp(along)
        for offset in low + width * (np.arange(CUTS) + 0.5) / CUTS:
            below = along <= offset
            if below.all() or not below.any():
                continue
            boxes = np.array([np.prod(np.ptp(solid[side] @ frame.T, axis=0) + cell) for side in (below, ~below)])
            counts = np.array([below.sum(), (~below).sum()]) * cell**3
            volume = (float(boxes[counts < FULL * boxes].sum()), float(boxes.sum()))
            if volume < least:
                best, least = below, volume
    return best
