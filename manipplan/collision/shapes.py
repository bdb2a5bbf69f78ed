"""The shapes of obstacles and of parts that an arm carries."""

import copy
from abc import ABC, abstractmethod
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar, Self

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import ArrayLike

from manipplan.collision import meshes
from manipplan.support.checks import Array, existing_file, finite_array, number, number_array, pose_matrix
from manipplan.support.errors import InvalidInputError


@dataclass(frozen=True, kw_only=True, eq=False)
class Obstacle(ABC):
    """A static obstacle. Its pose in the world: `position` (3,) [m] of its centre and `rotation`.

    `rotation` is None, a rotation matrix (3, 3), or roll, pitch and yaw (3,) [rad] as in URDF.
    """

    position: ArrayLike = (0.0, 0.0, 0.0)
    rotation: ArrayLike | None = None
    name: str = ""
    shape_name: ClassVar[str] = ""

    def __post_init__(self) -> None:
        if not isinstance(self.name, str):
            raise InvalidInputError(f"{type(self).__name__}.name", self.name, "text")
        object.__setattr__(self, "position", finite_array(self._argument("position"), self.position, (3,)))
        if self.rotation is not None:
            object.__setattr__(self, "rotation", self._rotation_matrix(self.rotation))
        for length in ("radius", "length"):
            if hasattr(self, length):
                object.__setattr__(self, length, number(self._argument(length), getattr(self, length), above=0.0))

    @property
    def pose(self) -> pin.SE3:
        """T_world_obstacle."""
        rotation = np.eye(3) if self.rotation is None else np.asarray(self.rotation)
        return pin.SE3(rotation, np.asarray(self.position))

    def at(self, pose: ArrayLike | pin.SE3) -> Self:
        """A copy moved by `pose`, (4, 4) or pin.SE3: T_world_obstacle becomes `pose` T_world_obstacle."""
        moved = pin.SE3(pose_matrix("pose", pose)) * self.pose
        position, rotation = finite_array("pose", moved.translation, (3,)), finite_array("pose", moved.rotation, (3, 3))
        return self._changed(position=position, rotation=rotation)

    def called(self, name: str) -> Self:
        """A copy with another name."""
        return self if name == self.name else self._changed(name=name)

    def _changed(self, **values: Any) -> Self:
        """A copy with other values, which are valid; the file of a mesh is not read again."""
        changed = copy.copy(self)
        for name, value in values.items():
            object.__setattr__(changed, name, value)
        return changed

    @abstractmethod
    def shapes(self) -> list[coal.CollisionGeometry]:
        """Convex coal shapes that make up the obstacle, in its own frame."""

    def _argument(self, name: str) -> str:
        return f"{self.name or type(self).__name__}.{name}"

    def _rotation_matrix(self, rotation: ArrayLike) -> Array:
        argument = self._argument("rotation")
        if number_array(argument, rotation).shape == (3,):
            return np.asarray(pin.rpy.rpyToMatrix(*finite_array(argument, rotation, (3,))))
        matrix = finite_array(argument, rotation, (3, 3))
        if not np.allclose(matrix @ matrix.T, np.eye(3), atol=1e-6) or np.linalg.det(matrix) < 0:
            raise InvalidInputError(argument, rotation, "a rotation matrix (3, 3), or roll, pitch, yaw (3,) [rad]")
        return matrix


@dataclass(frozen=True, kw_only=True, eq=False)
class Box(Obstacle):
    """A box with edges `size` (dx, dy, dz) [m]."""

    size: ArrayLike
    shape_name = "box"

    def __post_init__(self) -> None:
        super().__post_init__()
        size = finite_array(self._argument("size"), self.size, (3,))
        if not (size > 0).all():
            raise InvalidInputError(self._argument("size"), self.size, "three numbers above zero [m]")
        object.__setattr__(self, "size", size)

    def shapes(self) -> list[coal.CollisionGeometry]:
        return [coal.Box(np.asarray(self.size))]


@dataclass(frozen=True, kw_only=True, eq=False)
class Sphere(Obstacle):
    """A ball of `radius` [m]."""

    radius: float
    shape_name = "sphere"

    def shapes(self) -> list[coal.CollisionGeometry]:
        return [coal.Sphere(self.radius)]


@dataclass(frozen=True, kw_only=True, eq=False)
class Capsule(Obstacle):
    """A cylinder of `radius` and `length` [m] along z with a hemisphere at either end."""

    radius: float
    length: float
    shape_name = "capsule"

    def shapes(self) -> list[coal.CollisionGeometry]:
        return [coal.Capsule(self.radius, self.length)]


@dataclass(frozen=True, kw_only=True, eq=False)
class Cylinder(Obstacle):
    """A cylinder of `radius` and `length` [m] along z."""

    radius: float
    length: float
    shape_name = "cylinder"

    def shapes(self) -> list[coal.CollisionGeometry]:
        return [coal.Cylinder(self.radius, self.length)]


@dataclass(frozen=True, kw_only=True, eq=False)
class Plane(Obstacle):
    """The half-space below the x-y plane of its pose: a floor or, rotated, a wall."""

    shape_name = "plane"

    def shapes(self) -> list[coal.CollisionGeometry]:
        return [coal.Halfspace(np.array([0.0, 0.0, 1.0]), 0.0)]


@dataclass(frozen=True, kw_only=True, eq=False)
class Mesh(Obstacle):
    """A mesh from a file (STL, OBJ, DAE, ...) or from `triangles` (t, 3, 3); corners times `scale` are in metres.

    Every connected part is replaced by its convex hull, because a hollow surface would not collide with what is inside it: an
    open bin in one piece counts as filled.
    """

    file: str | Path | None = None
    triangles: ArrayLike | None = None
    scale: float = 1.0
    hulls: list[coal.CollisionGeometry] = field(init=False, repr=False)
    shape_name = "mesh"

    def __post_init__(self) -> None:
        super().__post_init__()
        object.__setattr__(self, "scale", number(self._argument("scale"), self.scale, above=0.0))
        if self.file is not None and self.triangles is None:
            object.__setattr__(self, "file", existing_file(self._argument("file"), self.file))
            hulls = meshes.hulls_of_file(self._argument("file"), Path(self.file), self.scale)
        elif self.triangles is not None and self.file is None:
            triangles = finite_array(self._argument("triangles"), self.triangles, (None, 3, 3))
            object.__setattr__(self, "triangles", triangles)
            hulls = meshes.hulls_of_triangles(self._argument("triangles"), self.scale * triangles)
        else:
            given = "neither" if self.file is None else "both"
            raise InvalidInputError(self._argument("file"), f"{given} of file and triangles", "one of them")
        object.__setattr__(self, "hulls", hulls)

    def shapes(self) -> list[coal.CollisionGeometry]:
        return self.hulls


OBSTACLES: dict[str, type[Obstacle]] = {kind.shape_name: kind for kind in (Box, Sphere, Capsule, Cylinder, Plane, Mesh)}
