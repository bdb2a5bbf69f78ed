"""The arm's clearance_search during a descent: where the path is near something, and the distances there."""

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from manipplan.collision.model import CollisionModel, Witnesses
from manipplan.collision.proximity import DistanceSearch, Place, ProximitySamples
from manipplan.optimize.clearance import columns
from manipplan.paths.joint import Curve
from manipplan.support.checks import Array

#: Margin kept beyond the required distance, so that the proof, whose bounds are not exact, succeeds [m].
MARGIN = 5e-5
#: Minimum distance in s between a place of the grid with a row and the bottom of a dip of the same pair.
APART = 1e-2
#: Maximum number of places with rows: bottoms of dips first, then the nearest.
MOST_PLACES = 80
#: Joint step of the finite differences for second derivatives of a distance [rad or m].
JOINT_STEP = 1e-4


@dataclass(kw_only=True, eq=False)
class ClearanceSearch:
    """Distances on paths that differ little from each other.

    Attributes:
        model: the arm among its obstacles.
        clearance: required distance [m].
        margin: margin kept beyond the required distance [m]; larger at first, as corners are rounder at a distance.
        always: places (s, pair) around which every path is searched for a dip, such as those where a proof failed.
    """

    model: CollisionModel
    clearance: float
    margin: float = MARGIN
    always: list[Place] = field(default_factory=list)

    @cached_property
    def _search(self) -> DistanceSearch:
        return DistanceSearch(self.model)

    @property
    def target(self) -> float:
        """The distance to keep [m]: the required one plus the margin."""
        return self.clearance + self.margin

    def find_near(self, curve: Curve, band: float) -> ProximitySamples:
        """Places on a curve where a pair is near, as `DistanceSearch.find_near` says."""
        return self._search.find_near(curve, self.target, band, self.always)

    def places(self, samples: ProximitySamples) -> NDArray[np.intp]:
        """The samples (r,) that get rows, bottoms of dips first."""
        bottoms, others = np.flatnonzero(samples.is_bottom), np.flatnonzero(~samples.is_bottom)
        if len(bottoms) and len(bottoms) < MOST_PLACES:
            along = 2 * samples.pairs + samples.s  # by pair, then place
            ordered = np.sort(along[bottoms])
            after = np.searchsorted(ordered, along[others])
            gaps = [np.abs(ordered[np.clip(after - k, 0, len(ordered) - 1)] - along[others]) for k in (0, 1)]
            others = others[np.minimum(*gaps) >= APART]
        return np.concatenate([bottoms, others])[:MOST_PLACES]

    def planes(self, found: Witnesses) -> Array:
        """Clearance rows (m, column_height(n)) of witnesses, each with the plane through the second body's point."""
        first, second = found.joints.T
        distances = found.radii[:, 0] + self.target
        return columns(self.model.robot.model.njoints - 1, first, found.points, second, found.normals, found.offsets, distances)

    def reversed_planes(self, found: Witnesses) -> Array:
        """As `planes`, with planes on the first bodies: better where a corner of the second faces a side of the first."""
        first, second = found.joints.T
        offsets, distances = (found.opposites * found.points).sum(axis=1) + found.radii[:, 0], found.radii[:, 1] + self.target
        return columns(self.model.robot.model.njoints - 1, second, found.others, first, found.opposites, offsets, distances)

    def hessians(self, q: Array, pairs: NDArray[np.intp], gradients: Array) -> Array:
        """Hessians (m, n, n) of the distances of pairs (m,) at q (m, n), where they have gradients (m, n), by differences."""
        m, n = q.shape
        moved = q[:, None] + JOINT_STEP * np.eye(n)
        found = self.model.witnesses(moved.reshape(-1, n), np.repeat(pairs, n))
        hessians = (found.gradients.reshape(m, n, n) - gradients[:, None]) / JOINT_STEP
        return np.asarray((hessians + hessians.transpose(0, 2, 1)) / 2)
