"""The nearest points of pairs of bodies, the direction between them, and the gradients of their distances."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from manipplan.support.checks import Array


@dataclass(frozen=True, kw_only=True, eq=False)
class Witnesses:
    """Two points fixed to the bodies of each of m pairs: the pair's distance is at most that of the points minus both `radii`.

    The point of a sphere or capsule lies on its centre or axis, that of any other body on its surface.

    Attributes:
        distances: (m,) signed distances [m].
        joints: (m, 2) indices of the joints that carry the two bodies (0: the world).
        normals: (m, 3) unit vectors from the second body to the first, in the frame of the second's joint. They lead out of a
            solid that the first body is in.
        opposites: (m, 3) the opposite vectors, in the frame of the first's joint.
        points, others: (m, 3) the points of the first and the second bodies, in the frames of their joints [m].
        radii: (m, 2) of the two bodies around their points [m]; 0 for points on the surface.
        gradients: (m, n) of the distances [m per rad or m].
    """

    distances: Array
    joints: NDArray[np.int64]
    normals: Array
    opposites: Array
    points: Array
    others: Array
    radii: Array
    gradients: Array

    @property
    def offsets(self) -> Array:
        """(m,) normals · p [m], with p the points of the second bodies' surfaces: these bodies lie below."""
        return np.asarray((self.normals * self.others).sum(axis=1) + self.radii[:, 1])
