"""The shapes of obstacles and of parts that an arm carries.

Obstacle shapes of the user: convex pieces and meshes, or a support function, enclosed by a polytope.
"""

import copy
import logging
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial
from itertools import product
from pathlib import Path
from typing import Any, ClassVar, Literal, Self

import coal
import numpy as np
import pinocchio as pin

from manipplan.collision import clouds, surfaces
from manipplan.collision.surfaces import MeshPart, mesh_parts
from manipplan.collision.world import mesh_triangles
from manipplan.robots.hulls import FARTHEST, convex_hull, find_hull
from manipplan.robots.mesh_files import triangle_tree
from manipplan.support.checks import (
    Array,
    ArrayLike,
    existing_file,
    finite_array,
    number,
    number_array,
    pose_matrix,
    rotation_matrix,
    text,
)
from manipplan.support.errors import FileFormatError, InvalidInputError

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
        if find_hull(points) is None:
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


#: Largest angle of an obstacle's roll, pitch and yaw: larger ones are probably degrees [rad].
MOST_RADIANS = 8 * np.pi


@dataclass(frozen=True, kw_only=True, eq=False)
class Part:
    """A part of an obstacle, in its frame.

    Attributes:
        shape: a coal shape: Box, Sphere, Capsule, Cylinder, Halfspace, a convex hull, or BVHModelOBBRSS for triangles.
        radius: distance around the shape that belongs to the part as well [m].
        closed: whether what is inside the shape is solid; False for surfaces and points. The triangles of a closed
            BVHModelOBBRSS face outward, and inward around cavities: where their winding number is not 0, the part is solid.
    """

    shape: coal.CollisionGeometry
    radius: float = 0.0
    closed: bool = True

    def __post_init__(self) -> None:
        if not isinstance(self.shape, coal.CollisionGeometry):
            raise InvalidInputError("shape", self.shape, "a shape of coal, such as coal.Box")
        number("radius", self.radius, least=0.0)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the triangles of a tree, not the tree: coal writes 1.7 kB for each."""
        if isinstance(self.shape, coal.BVHModelBase):
            return _part_of_triangles, (mesh_triangles(self.shape), self.radius, self.closed)
        return partial(Part, shape=self.shape, radius=self.radius, closed=self.closed), ()


def _part_of_triangles(triangles: Array, radius: float, closed: bool) -> Part:
    return Part(shape=triangle_tree(*surfaces.merge_corners(triangles)), radius=radius, closed=closed)


@dataclass(frozen=True, kw_only=True, eq=False)
class Obstacle:
    """A static obstacle; derive from it to write a shape of your own. `position` (3,) [m] and `rotation` are its pose.

    `rotation` is None, a rotation matrix (3, 3), or roll, pitch and yaw (3,) [rad] as in URDF. No position, size or corner is
    beyond `FARTHEST`.

    A class of your own is a frozen dataclass with one of two methods, which speak of the shape in its own frame [m]:

    - `pieces()` returns a list of solids: points (k, 3), whose convex hull is one, or triangles (t, 3, 3), as for `Mesh`.
    - `support(directions)` returns for unit vectors (k, 3) the points (k, 3) of a convex body that are farthest in them. A
      polytope that contains the body takes its place, no point of which is farther from it than the attribute `excess` [m] of
      the class. Without this attribute that is 1 mm, or more for a large round body; the log says how much.
    """

    position: ArrayLike = (0.0, 0.0, 0.0)
    rotation: ArrayLike | None = None
    name: str = ""
    shape_name: ClassVar[str] = ""

    def __init_subclass__(cls, **options: Any) -> None:
        super().__init_subclass__(**options)
        methods = [name for name in ("pieces", "support") if callable(vars(cls).get(name))]
        if methods and cls.parts is not Obstacle.parts:
            raise InvalidInputError(
                cls.__name__, f"a kind of {cls.__mro__[1].__name__} with {methods[0]}()", "one of mp.Obstacle"
            )

    def __post_init__(self) -> None:
        if not isinstance(self.name, str):
            raise InvalidInputError(f"{type(self).__name__}.name", self.name, "text")
        object.__setattr__(self, "position", finite_array(self._argument("position"), self.position, (3,), most=FARTHEST))
        if self.rotation is not None:
            object.__setattr__(self, "rotation", self._rotation_matrix(self.rotation))
        for length in ("radius", "length"):
            if hasattr(self, length):
                value = number(self._argument(length), getattr(self, length), above=0.0, most=FARTHEST)
                object.__setattr__(self, length, value)

    @property
    def pose(self) -> pin.SE3:
        """T_world_obstacle."""
        rotation = np.eye(3) if self.rotation is None else np.asarray(self.rotation)
        return pin.SE3(rotation, np.asarray(self.position))

    def at(self, pose: ArrayLike | pin.SE3) -> Self:
        """A copy moved by `pose`, (4, 4) or pin.SE3: T_world_obstacle becomes `pose` T_world_obstacle."""
        moved = pin.SE3(pose_matrix("pose", pose)) * self.pose
        position = finite_array("pose", moved.translation, (3,), most=FARTHEST)
        rotation = finite_array("pose", moved.rotation, (3, 3))
        return self._change(position=position, rotation=rotation)

    def called(self, name: str) -> Self:
        """A copy with another name."""
        return self if text("name", name) == self.name else self._change(name=name)

    def _change(self, **values: Any) -> Self:
        """A copy with other values, which are valid; the file of a mesh is not read again."""
        changed = copy.copy(self)
        for name, value in values.items():
            object.__setattr__(changed, name, value)
        return changed

    def parts(self) -> list[Part]:
        """The parts that make up the obstacle, in its own frame; of a class of your own by its `pieces` or `support`.

        Raises InvalidInputError, which names the obstacle, when what these return is not usable.
        """
        made: tuple[Part, ...] | None = vars(self).get("_made")
        if made is None:
            found = own_parts(self.name or type(self).__name__, self)
            made = tuple(Part(shape=part.shape(), closed=part.closed) for part in found)
            object.__setattr__(self, "_made", made)
        return list(made)

    def shapes(self) -> list[coal.CollisionGeometry]:
        """The coal shapes of `parts`."""
        return [part.shape for part in self.parts()]

    def _argument(self, name: str) -> str:
        return f"{self.name or type(self).__name__}.{name}"

    def _rotation_matrix(self, rotation: ArrayLike) -> Array:
        argument = self._argument("rotation")
        if number_array(argument, rotation).shape == (3,):
            angles = finite_array(argument, rotation, (3,))
            if np.abs(angles).max() > MOST_RADIANS:
                wanted = f"roll, pitch, yaw up to {MOST_RADIANS:.4g} rad; for degrees np.deg2rad({angles.tolist()})"
                raise InvalidInputError(argument, angles.tolist(), wanted)
            return np.asarray(pin.rpy.rpyToMatrix(*angles))
        return rotation_matrix(argument, rotation, "a rotation matrix (3, 3), or roll, pitch, yaw (3,) [rad]")


@dataclass(frozen=True, kw_only=True, eq=False)
class Box(Obstacle):
    """A box with edges `size` (dx, dy, dz) [m]; `position` is its centre."""

    size: ArrayLike
    shape_name = "box"

    def __post_init__(self) -> None:
        super().__post_init__()
        size = finite_array(self._argument("size"), self.size, (3,), most=FARTHEST)
        if not (size > 0).all():
            raise InvalidInputError(self._argument("size"), self.size, "three numbers above zero [m]")
        object.__setattr__(self, "size", size)

    def parts(self) -> list[Part]:
        return [Part(shape=coal.Box(np.asarray(self.size)))]


@dataclass(frozen=True, kw_only=True, eq=False)
class Sphere(Obstacle):
    """A ball of `radius` [m]; `position` is its centre."""

    radius: float
    shape_name = "sphere"

    def parts(self) -> list[Part]:
        return [Part(shape=coal.Sphere(self.radius))]


@dataclass(frozen=True, kw_only=True, eq=False)
class Capsule(Obstacle):
    """A cylinder of `radius` and `length` [m] along z with a hemisphere at either end; `position` is its centre."""

    radius: float
    length: float
    shape_name = "capsule"

    def parts(self) -> list[Part]:
        return [Part(shape=coal.Capsule(self.radius, self.length))]


@dataclass(frozen=True, kw_only=True, eq=False)
class Cylinder(Obstacle):
    """A cylinder of `radius` and `length` [m] along z; `position` is its centre."""

    radius: float
    length: float
    shape_name = "cylinder"

    def parts(self) -> list[Part]:
        return [Part(shape=coal.Cylinder(self.radius, self.length))]


@dataclass(frozen=True, kw_only=True, eq=False)
class Plane(Obstacle):
    """The half-space below the x-y plane of its pose: a floor or, rotated, a wall."""

    shape_name = "plane"

    def parts(self) -> list[Part]:
        return [Part(shape=coal.Halfspace(np.array([0.0, 0.0, 1.0]), 0.0))]


@dataclass(frozen=True, kw_only=True, eq=False)
class Mesh(Obstacle):
    """Triangles of a file (STL, OBJ, PLY, DAE, glTF, GLB), or `triangles` (t, 3, 3); their numbers times `scale` are metres.

    Triangles that enclose a volume are a solid; shells inside it that face inward are its cavities. All others are surfaces
    without thickness: an open bin is empty, and a body in it is free. Corners within 1e-9 m are one, triangles without an
    area are left out, and a closed part that is inside out is turned.

    Args:
        file: its objects are read together, with the transforms of its scene. Polygons are split into triangles. Units and
            vertical axes that DAE and glTF files state are not applied, unlike the unit of a mesh of a URDF: `scale` and `up`
            say them. A difference is logged as a warning. glTF needs `pip install 'manipplan[mesh]'`.
        triangles: corners of each triangle; outward sides are not needed, except around cavities.
        scale: metres per unit of the file.
        up: its vertical axis, which becomes z: "z" or "y".
        fill: "hull" replaces each part connected by corners by its convex hull, so an open bin counts as filled: less
            exact, and faster. None does not.

    Raises:
        FileFormatError: the file is missing or broken, or has no triangle with an area or corners beyond 1e6 m.
        InvalidInputError: another argument is invalid, or a part that is to be filled is flat.
        MissingExtraError: trimesh is needed for glTF and is not installed.
    """

    file: str | Path | None = None
    triangles: ArrayLike | None = None
    scale: float = 1.0
    up: Literal["z", "y"] = "z"
    fill: Literal["hull"] | None = None
    built: tuple[Part, ...] = field(init=False, repr=False)
    shape_name = "mesh"

    def __post_init__(self) -> None:
        super().__post_init__()
        object.__setattr__(self, "scale", number(self._argument("scale"), self.scale, above=0.0))
        for name, allowed in (("up", ("z", "y")), ("fill", (None, "hull"))):
            given = getattr(self, name)
            if not (given is None or isinstance(given, str)) or given not in allowed:
                raise InvalidInputError(self._argument(name), given, " or ".join(map(repr, allowed)))
        if (self.file is None) == (self.triangles is None):
            given = "neither" if self.file is None else "both"
            raise InvalidInputError(self._argument("file"), f"{given} of file and triangles", "one of them")
        if self.file is None:
            argument = self._argument("triangles")
            given_triangles = finite_array(
                argument, self.triangles if self.triangles is not None else (), (None, 3, 3), most=np.inf
            )
            object.__setattr__(self, "triangles", given_triangles)
            object.__setattr__(self, "built", self._build(argument, given_triangles))
            return
        argument = self._argument("file")
        object.__setattr__(self, "file", existing_file(argument, self.file))
        read = surfaces.triangles_of_file(argument, Path(self.file), self.scale, self.up)
        try:
            object.__setattr__(self, "built", self._build(argument, read))
        except InvalidInputError as error:
            raise FileFormatError(argument, f"{self.file}: {error.value}", error.allowed) from error

    def parts(self) -> list[Part]:
        return list(self.built)

    def _build(self, argument: str, triangles: Array) -> tuple[Part, ...]:
        placed = surfaces.placed_triangles(argument, triangles, self.scale, self.up)
        found = (surfaces.hull_parts if self.fill == "hull" else surfaces.mesh_parts)(argument, placed)
        return tuple(Part(shape=part.shape(), closed=part.closed) for part in found)


@dataclass(frozen=True, kw_only=True, eq=False)
class PointCloud(Obstacle):
    """Balls of `radius` [m] about points, such as those of a depth camera.

    Args:
        points: (k, 3) [m] in the frame of `position` and `rotation`.
        file: in place of `points`, a file with them: PLY, PCD, NPY or NPZ (one array, or one named points). Points that are
            not finite, which are invalid in such files, are left out.
        radius: it depends on the sensor, so it has no default: half the distance between neighbouring points plus their error,
            or more. Between smaller balls a thin object can pass.
        spacing: thins the points: of those in one cube of this edge [m] one is kept, and the radius of all balls grows by
            √3 spacing, so that they cover all that was covered. 0 keeps all.

    Raises:
        FileFormatError: the file is missing or broken, or has more than 5,000,000 points.
        InvalidInputError: an argument is invalid, there is no point, more than 500,000 are left, or one lies beyond 1e6 m.
    """

    points: ArrayLike | None = None
    file: str | Path | None = None
    radius: float
    spacing: float = 0.0
    built: clouds.Points = field(init=False, repr=False)
    shape_name = "cloud"

    def __post_init__(self) -> None:
        super().__post_init__()
        object.__setattr__(self, "spacing", number(self._argument("spacing"), self.spacing, least=0.0))
        if (self.file is None) == (self.points is None):
            given = "neither" if self.file is None else "both"
            raise InvalidInputError(self._argument("points"), f"{given} of points and file", "one of them")
        if self.file is None:
            argument = self._argument("points")
            points = finite_array(argument, self.points if self.points is not None else (), (None, 3), most=np.inf)
            object.__setattr__(self, "points", points)
        else:
            argument = self._argument("file")
            object.__setattr__(self, "file", existing_file(argument, self.file))
            points = clouds.read_points(argument, Path(self.file))
        try:
            thinned = clouds.thinned(argument, points, self.spacing)
        except InvalidInputError as error:
            if self.file is None:
                raise
            raise FileFormatError(argument, f"{self.file}: {error.value}", error.allowed) from error
        object.__setattr__(self, "built", clouds.Points(thinned))

    @classmethod
    def from_file(cls, file: str | Path, *, radius: float, spacing: float = 0.0, **options: Any) -> Self:
        """The points of a file (PLY, PCD, NPY, NPZ); further options are position, rotation and name."""
        return cls(file=file, radius=radius, spacing=spacing, **options)

    @classmethod
    def from_depth(
        cls,
        image: ArrayLike,
        intrinsics: ArrayLike,
        *,
        radius: float,
        pose: ArrayLike | pin.SE3 | None = None,
        farthest: float = np.inf,
        spacing: float = 0.0,
        name: str = "",
    ) -> Self:
        """The points that a depth camera sees.

        Args:
            image: (h, w) distance of each pixel along the optical axis [m]; pixels of 0, NaN, inf or less than 0 are invalid
                and left out. Divide an image in millimetres by 1000.
            intrinsics: (fx, fy, cx, cy) [pixels], or the matrix (3, 3) that holds them.
            radius: of the balls, as in `PointCloud`.
            pose: T_world_camera, (4, 4) or pin.SE3; the camera looks along z, x points right and y down in the image.
            farthest: depth beyond which points are left out [m].
            spacing: thins the points, as in `PointCloud`.
            name: name of the obstacle.

        Raises InvalidInputError when an argument is invalid or no pixel is valid.
        """
        points = clouds.depth_points(image, intrinsics, farthest)
        cloud = cls(points=points, radius=radius, spacing=spacing, name=name)
        return cloud if pose is None else cloud.at(pose)

    @property
    def kept(self) -> Array:
        """The points (k, 3) that count, in the cloud's frame [m]: all, or those left by `spacing`."""
        return self.built.points

    def parts(self) -> list[Part]:
        return [Part(shape=self.built.tree(), radius=self.radius + np.sqrt(3.0) * self.spacing, closed=False)]


#: Maximum number of obstacles of a scene.
MOST_OBSTACLES = 10_000


def check_obstacles(argument: str, count: int) -> None:
    """Raise InvalidInputError for more obstacles than a scene may have, before they are made."""
    if count > MOST_OBSTACLES:
        raise InvalidInputError(
            argument, f"{count:,} obstacles", f"at most {MOST_OBSTACLES:,}; a Mesh or a PointCloud holds many"
        )


OBSTACLES: dict[str, type[Obstacle]] = {
    kind.shape_name: kind for kind in (Box, Sphere, Capsule, Cylinder, Plane, Mesh, PointCloud)
}


def is_own(obstacle: Obstacle) -> bool:
    """Whether the parts of an obstacle come from a method of the user."""
    return type(obstacle).parts is Obstacle.parts
