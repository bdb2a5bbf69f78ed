"""The judge of motions that knows nothing of our primitives, planes and proofs: the arm's own collision meshes, in coal.

A motion is free when, sampled so that no joint moves more than STEP between samples, no mesh of a moving link touches an
obstacle at any sample.
"""

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

import manipplan as mp

#: Largest change of a joint between two samples [rad or m].
STEP = 1e-3


class MeshModel:
    """The meshes of an arm and the obstacles of a scene."""

    def __init__(self, robot: mp.Robot, scene: mp.Scene) -> None:
        self.model, self.data = robot.model, robot.model.createData()
        geometry = robot.geometry.copy()
        links = [
            k for k, each in enumerate(geometry.geometryObjects) if each.parentJoint > 0
        ]  # the base stands where it stands
        shapes = [(obstacle, k, shape) for obstacle in scene.obstacles for k, shape in enumerate(obstacle.shapes())]
        for obstacle, k, shape in shapes:
            name = f"obstacle {obstacle.name} {k}"
            added = geometry.addGeometryObject(pin.GeometryObject(name, 0, obstacle.pose, shape))
            for link in links:
                geometry.addCollisionPair(pin.CollisionPair(link, added))
        self.geometry, self.placed = geometry, geometry.createData()

    def is_free(self, q: NDArray[np.float64]) -> bool:
        """Whether no mesh touches an obstacle at any of the configurations (m, n) or (n,)."""
        parts = self.model, self.data, self.geometry, self.placed
        return not any(pin.computeCollisions(*parts, each, True) for each in np.atleast_2d(q))

    def motion_is_free(self, path: mp.JointPath) -> bool:
        """Whether no mesh touches an obstacle on a path, at samples as in the docstring of the module."""
        q = path(path.fine_samples(STEP))
        assert np.abs(np.diff(q, axis=0)).max() <= STEP * (1 + 1e-9)
        return self.is_free(q)
