"""The bodies of a robot as finely as a pair needs them: meshes as convex pieces, or as the solids and surfaces they are."""

from collections.abc import Iterator, Sequence
from itertools import pairwise

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.covers.pieces import MOST_PIECES
from manipplan.collision.covers.stored_fits import find_or_cut, find_or_split
from manipplan.collision.model import CollisionModel
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
        self.robot = robot
        self.objects = list(robot.geometry.geometryObjects)
        self._parts: dict[tuple[int, int], list[tuple[coal.CollisionGeometry, bool, float]]] = {}

    def parts(self, origin: int, level: int) -> list[tuple[coal.CollisionGeometry, bool, float]]:
        """The shapes of an object; whether each is solid, and by how much it is known to stick out of the mesh [m]."""
        if (origin, level) not in self._parts:
            item = self.objects[origin]
            if not isinstance(item.geometry, coal.BVHModelBase):
                found = [(item.geometry, True, 0.0)]
            elif level == MESH:
                found = [(part.shape(), part.closed, 0.0) for part in find_or_split(item.geometry, item.name)]
            else:
                pieces = find_or_cut(item.geometry, f"{item.name}, body {origin + 1} of {len(self.objects)}", level)
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
        if sum(self.objects[pair[k]].geometry.num_tris for k in meshes) <= FEW_TRIANGLES:
            return
        meshes.sort(key=lambda k: -max(excess for _, _, excess in self.parts(pair[k], MOST_PIECES)))
        for few in (1, MOST_PIECES):
            for k in meshes:
                yield (many, few) if k == 0 else (few, many)

    def touching(self, pairs: Sequence[tuple[int, int]], levels: tuple[int, int], samples: Array) -> list[NDArray[np.bool_]]:
        """For each pair of objects, whether they touch, taken so finely, at samples (m, n); (m,)."""
        bodies, places, first = Bodies(self), list[tuple[int, int]](), list[int]()
        for pair in pairs:
            one, other = (bodies.numbers(*each) for each in zip(pair, levels, strict=True))
            first.append(len(places))
            places += [(i, j) for i in one for j in other]
        model = CollisionModel(
            self.robot, bodies.geometry, np.array(places, dtype=np.int64).reshape(-1, 2), {}, solids=bodies.solids
        )
        near = model.distance_rows(samples, beyond=TOUCHING) <= 0
        return [np.asarray(near[:, start:end].any(axis=1)) for start, end in pairwise([*first, len(places)])]


class Bodies:
    """Objects of a robot's geometry, each added as finely as it is asked for, once.

    Attributes:
        geometry: the bodies, without pairs.
        origins: the number of the object that each body represents.
        excess: by how much each body is known to stick out of its object [m], by name.
        solids: the numbers of the bodies that are surfaces and solid inside.
    """

    def __init__(self, described: DescribedBodies) -> None:
        self._described = described
        self._numbers: dict[tuple[int, int], list[int]] = {}
        self.geometry = pin.GeometryModel()
        self.origins: list[int] = []
        self.excess: dict[str, float] = {}
        self.solids: set[int] = set()

    def numbers(self, origin: int, level: int) -> list[int]:
        """The numbers of the bodies that an object is taken as; those that are not there yet are added."""
        item = self._described.objects[origin]
        if not isinstance(item.geometry, coal.BVHModelBase):
            level = MOST_PIECES
        if (origin, level) not in self._numbers:
            parts = self._described.parts(origin, level)
            kind = "" if level == MOST_PIECES else ".mesh" if level == MESH else f".of{level}"
            added = self._numbers[origin, level] = []
            for name, (shape, closed, beyond) in zip(number_names(f"{item.name}{kind}", len(parts)), parts, strict=True):
                body = pin.GeometryObject(name, item.parentJoint, item.parentFrame, item.placement, shape)
                added.append(self.geometry.addGeometryObject(body))
                self.origins.append(origin)
                self.excess[name] = beyond
                if closed and isinstance(shape, coal.BVHModelBase):
                    self.solids.add(added[-1])
        return self._numbers[origin, level]
