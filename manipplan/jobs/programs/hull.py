"""Convex hulls of places, also flat ones, and how far other places are beyond them."""

from dataclasses import dataclass

import numpy as np

from manipplan.support.checks import Array

#: Weight of the sum of shares in the distances that are minimised; places are scaled to the size of the hull.
WEIGHT = 1e3
#: Smallest size to which places are scaled [m].
SMALLEST = 1e-4


@dataclass(frozen=True, kw_only=True, eq=False)
class BlendHull:
    """The convex hull of places.

    Attributes:
        places: (k, 3) [m].
        size: largest distance of one of them from the first [m].
    """

    places: Array
    size: float

    @classmethod
    def of(cls, places: Array) -> "BlendHull":
        """The hull of places (k, 3)."""
        return cls(places=places, size=max(float(np.linalg.norm(places - places[0], axis=1).max()), SMALLEST))

    def beyond(self, places: Array) -> Array:
        """The vectors (k, 3) from the nearest place of the hull to each of some places (k, 3) [m]; zero for those inside."""
        from scipy.optimize import nnls

        made = np.zeros(places.shape)
        goal = np.array([0.0, 0.0, 0.0, WEIGHT])
        for row, place in enumerate(places):
            columns = np.vstack([(self.places - place).T / self.size, np.full(len(self.places), WEIGHT)])
            shares, _ = nnls(columns, goal)
            made[row] = place - shares @ self.places / shares.sum()
        return made
