"""The bodies of a robot as finely as a pair needs them: meshes as convex pieces, or as the solids and surfaces they are."""

from collections.abc import Iterator, Mapping

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.covers.pieces import MOST_PIECES
from manipplan.collision.covers.stored_fits import find_or_cut
from manipplan.collision.model import CollisionModel
from manipplan.collision.primitives import mesh_triangles
from manipplan.collision.surfaces.meshes import mesh_parts
from manipplan.robots.attached import number_names
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array

#: How finely a mesh is taken: by its triangles, or by at most this number of convex pieces, tried in turn.
MESH, FINE = 0, (12, 24, 48)
#: Distances above this need not be known to tell whether a pair touches [m].
TOUCHING = 1e-6
#: Total number of triangles of two meshes up to which they are compared as fast as pieces of them.
FEW_TRIANGLES = 100


class DescribedBodies:
    """The objects of a robot's geometry, each as finely as it is asked for.

    By its triangles a mesh has a part for each solid and one for all its open surfaces; convex solids are hulls.
    """

    def __init__(self, robot: Robot) -> None:
        self._robot = robot
        self._objects = list(robot.geometry.geometryObjects)
        self._parts: dict[tuple[int, int], list[tuple[coal.CollisionGeometry, bool, float]]] = {}

    def parts(self, origin: int, level: int) -> list[tuple[coal.CollisionGeometry, bool, float]]:
        """The shapes of an object; whether each is solid, and by how much it is known to stick out of the mesh [m]."""
        if (origin, level) not in self._parts:
            item = self._objects[origin]
            if not isinstance(item.geometry, coal.BVHModelBase):
                found = [(item.geometry, True, 0.0)]
            elif level == MESH:
                found = [(*part, 0.0) for part in mesh_parts(item.name, mesh_triangles(item.geometry))]
            else:
                pieces = find_or_cut(mesh_triangles(item.geometry), level)
                found = [(piece.hull.shape(), True, piece.excess) for piece in pieces]
            self._parts[origin, level] = found
        return self._parts[origin, level]

    def has_triangles(self, origin: int) -> bool:
        """Whether an object is no convex solid, so that convex pieces may stick out of it."""
        shapes = [shape for shape, _, _ in self.parts(origin, MESH)]
        return len(shapes) > 1 or any(isinstance(shape, coal.BVHModelBase) for shape in shapes)

    def finer(self, pair: tuple[int, int], many: int) -> Iterator[tuple[int, int]]:
        """Ways to take two objects by `many` pieces of one and few of the other, the fewest pairs first."""
        meshes = [k for k in (0, 1) if self.has_triangles(pair[k])]
        if sum(self._objects[pair[k]].geometry.num_tris for k in meshes) <= FEW_TRIANGLES:
            return
        meshes.sort(key=lambda k: -max(excess for _, _, excess in self.parts(pair[k], MOST_PIECES)))
        for few in (1, MOST_PIECES):
            for k in meshes:
                yield (many, few) if k == 0 else (few, many)

    def add_to(self, geometry: pin.GeometryModel, origin: int, level: int, excess: dict[str, float]) -> list[int]:
        """Add the parts of an object to a geometry, and their `excess`; returns their numbers there."""
        item, parts = self._objects[origin], self.parts(origin, level)
        names = number_names(f"{item.name}.{'mesh' if level == MESH else f'of{level}'}", len(parts))
        for name, (_, _, beyond) in zip(names, parts, strict=True):
            excess[name] = beyond
        return [
            geometry.addGeometryObject(pin.GeometryObject(name, item.parentJoint, item.parentFrame, item.placement, shape))
            for name, (shape, _, _) in zip(names, parts, strict=True)
        ]

    def solids(self, added: Mapping[tuple[int, int], list[int]]) -> frozenset[int]:
        """Of parts that were added, by object and level, the numbers of those that are surfaces and solid inside."""
        return frozenset(
            number
            for of, numbers in added.items()
            for number, (shape, closed, _) in zip(numbers, self.parts(*of), strict=True)
            if closed and isinstance(shape, coal.BVHModelBase)
        )

    def touching(self, pair: tuple[int, int], levels: tuple[int, int], samples: Array) -> NDArray[np.bool_]:
        """Whether two objects touch, taken so finely, at samples (m, n); (m,)."""
        geometry = pin.GeometryModel()
        ends = list(zip(pair, levels, strict=True))
        added = {each: self.add_to(geometry, *each, {}) for each in ends}
        for i in added[ends[0]]:
            for j in added[ends[1]]:
                geometry.addCollisionPair(pin.CollisionPair(i, j))
        model = CollisionModel(self._robot, geometry, {}, solids=self.solids(added))
        return np.asarray((model.distance_rows(samples, beyond=TOUCHING) <= 0).any(axis=1))
