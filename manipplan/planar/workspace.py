"""Reachable and dexterous workspace of the planar arm without joint limits: rings around the base."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from manipplan.planar.arm import PlanarArm
from manipplan.support.checks import configurations


@dataclass(frozen=True, kw_only=True)
class Annulus:
    """The ring inner <= ‖p‖ <= outer around the base; a disc when inner is 0.

    Attributes:
        inner: [m].
        outer: [m].
    """

    inner: float
    outer: float

    @property
    def area(self) -> float:
        """π (outer² - inner²) [m²]."""
        return math.pi * (self.outer**2 - self.inner**2)

    def contains(self, position: ArrayLike) -> np.ndarray:
        """(...,) whether positions (..., 2) [m] lie in it."""
        p = configurations("position", position, 2)
        radius = np.hypot(p[..., 0], p[..., 1])
        return np.asarray((radius >= self.inner) & (radius <= self.outer))


def reachable_annulus(arm: PlanarArm) -> Annulus:
    """The reachable workspace W_R (2.5) in kth2012: from max(0, 2 max l - Σ l) to Σ l."""
    total = math.fsum(arm.lengths)
    return Annulus(inner=max(0.0, math.fsum([2 * max(arm.lengths), *(-arm.lengths)])), outer=total)


def dexterous_annuli(arm: PlanarArm) -> tuple[Annulus, ...]:
    """The dexterous workspace W_D (2.6) in kth2012: positions that can be reached with every orientation.

    As φ makes a full turn, the last joint's distance from the base ranges from abs(R - l_n) to R + l_n; this range must lie
    in the ring [a, b] of the first n - 1 links. Hence R <= b - l_n together with R <= l_n - a or R >= l_n + a: an empty set,
    one ring, or a disc and a ring.
    """
    last, *others = arm.lengths[::-1].tolist()
    total = math.fsum(others)
    inner = max(0.0, math.fsum([2 * max(others), *(-x for x in others)]))
    parts = [(0.0, min(total - last, last - inner)), (last + inner, total - last)]
    if inner == 0.0:
        parts = [(0.0, total - last)]  # the two parts touch, or the second is empty
    return tuple(Annulus(inner=low, outer=high) for low, high in parts if low <= high)
