"""The bodies of a robot as its description has them: each mesh as the solids and surfaces that its triangles are."""

from collections.abc import Sequence

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.primitives import mesh_triangles
from manipplan.collision.surfaces.meshes import mesh_parts
from manipplan.robots.attached import number_names
from manipplan.robots.robot import Robot


class DescribedBodies:
    """The parts of the objects of a robot's geometry, each found when it is first needed.

    A mesh has a part for each solid and one for all its open surfaces; convex solids are hulls, the others trees of triangles.
    """

    def __init__(self, robot: Robot) -> None:
        self._robot = robot
        self._objects = list(robot.geometry.geometryObjects)
        self._parts: dict[int, list[tuple[coal.CollisionGeometry, bool]]] = {}

    def parts(self, origin: int) -> list[tuple[coal.CollisionGeometry, bool]]:
        """The shapes of an object, and whether each of them is solid."""
        if origin not in self._parts:
            item = self._objects[origin]
            is_mesh = isinstance(item.geometry, coal.BVHModelBase)
            self._parts[origin] = mesh_parts(item.name, mesh_triangles(item.geometry)) if is_mesh else [(item.geometry, True)]
        return self._parts[origin]

    def has_triangles(self, origin: int) -> bool:
        """Whether a part of an object is no convex solid, so that convex pieces may stick out of it."""
        return len(self.parts(origin)) > 1 or any(isinstance(shape, coal.BVHModelBase) for shape, _ in self.parts(origin))

    def add_to(
        self, geometry: pin.GeometryModel, origins: list[int], wanted: Sequence[int]
    ) -> tuple[dict[int, list[int]], frozenset[int]]:
        """Add the parts of the `wanted` objects to a geometry, and the objects that they represent to its `origins`.

        Returns the numbers of the parts of each, and of those that are surfaces and solid inside.
        """
        added: dict[int, list[int]] = {}
        solids = set()
        for origin in wanted:
            item, parts = self._objects[origin], self.parts(origin)
            added[origin] = []
            for name, (shape, closed) in zip(number_names(f"{item.name}.mesh", len(parts)), parts, strict=True):
                part = pin.GeometryObject(name, item.parentJoint, item.parentFrame, item.placement, shape)
                number = geometry.addGeometryObject(part)
                origins.append(origin)
                added[origin].append(number)
                if closed and isinstance(shape, coal.BVHModelBase):
                    solids.add(number)
        return added, frozenset(solids)

    def model(self, pairs: Sequence[tuple[int, int]]) -> tuple[pin.GeometryModel, NDArray[np.int64], frozenset[int]]:
        """A geometry of the objects in `pairs` with all pairs of their parts.

        Also the number in `pairs` that each of its pairs stands for (k,), and the parts that are surfaces and solid inside.
        """
        geometry = pin.GeometryModel()
        added, solids = self.add_to(geometry, [], sorted({origin for pair in pairs for origin in pair}))
        numbers = []
        for number, (first, second) in enumerate(pairs):
            for i in added[first]:
                for j in added[second]:
                    geometry.addCollisionPair(pin.CollisionPair(i, j))
                    numbers.append(number)
        return geometry, np.array(numbers, dtype=np.int64), solids
