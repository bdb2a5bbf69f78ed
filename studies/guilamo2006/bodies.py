"""Outlines of a robot's links, projected onto a plane."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import pinocchio as pin
from scipy.spatial import ConvexHull

import manipplan as mp
from studies.guilamo2006.courses import Array


@dataclass(frozen=True, kw_only=True, eq=False)
class Bodies:
    """The links of a robot, each as the corners of its convex hull."""

    robot: mp.Robot

    @cached_property
    def corners(self) -> list[tuple[int, bool, Array]]:
        """For each geometry object: its number, whether the arm moves it, and its corners (k, 3) in its own frame."""
        found = []
        for number, each in enumerate(self.robot.geometry.geometryObjects):
            shape = each.geometry
            if hasattr(shape, "vertices"):
                points = np.array(shape.vertices()) * np.array(each.meshScale)
                points = points[ConvexHull(points).vertices]
            else:
                shape.computeLocalAABB()
                low, high = shape.aabb_local.min_, shape.aabb_local.max_
                points = np.array([[x, y, z] for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])])
            found.append((number, each.parentJoint > 0, points))
        return found

    def outlines(self, q: Array, axes: tuple[int, int]) -> list[tuple[bool, Array]]:
        """For each link: whether it moves, and the outline (k, 2) of its projection along the third axis; far links first."""
        model, geometry = self.robot.model, self.robot.geometry
        data, placed = model.createData(), pin.GeometryData(geometry)
        pin.updateGeometryPlacements(model, data, geometry, placed, q)
        depth = ({0, 1, 2} - set(axes)).pop()
        drawn = []
        for number, moves, corners in self.corners:
            place = placed.oMg[number]
            world = corners @ place.rotation.T + place.translation
            flat = world[:, axes]
            drawn.append((float(world[:, depth].mean()), moves, flat[ConvexHull(flat).vertices]))
        # seen from +x and from +z, and from the right side, -y
        drawn.sort(key=lambda each: each[0], reverse=depth == 1)
        return [(moves, flat) for _, moves, flat in drawn]

    def chain(self, q: Array, axes: tuple[int, int]) -> Array:
        """Origins of the joints and the tool (k, 2), projected."""
        data = self.robot.model.createData()
        pin.framesForwardKinematics(self.robot.model, data, q)
        origins = [data.oMi[k].translation for k in range(1, self.robot.model.njoints)]
        tool = data.oMf[self.robot.model.getFrameId(self.robot.tool)].translation
        return np.array([*origins, tool])[:, axes]
