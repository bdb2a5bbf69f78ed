"""SeedTask: what a search for a seed path is given."""

from dataclasses import dataclass

import numpy as np

from manipplan.collision.model import CollisionModel
from manipplan.kinematics.sides import Sides
from manipplan.support.checks import Array

#: Maximum time beyond the deadline for simplifying and rounding a path, as a share of the time limit, and at most [s].
GRACE, MOST_GRACE = 0.05, 0.3


@dataclass(frozen=True, kw_only=True, eq=False)
class SeedTask:
    """A search from start to goal.

    Attributes:
        model: the robot among its obstacles.
        start, goal: (n,) [rad or m].
        distances: smallest distance of two bodies at start and at goal [m].
        seed: random seed.
        clearance: minimum distance [m] between bodies.
        sides: the functions whose changes of sign count as crossings of singularities; None: they do not count.
        most_crossings: maximum number of them on the path; None: any number.
        checks: maximum number of configurations checked for collision; None: any number.
        deadline: in time.monotonic() [s].
        grace: time beyond it for simplifying and rounding a path [s].
    """

    model: CollisionModel
    start: Array
    goal: Array
    distances: tuple[float, float]
    seed: int
    clearance: float
    sides: Sides | None
    most_crossings: int | None
    checks: int | None
    deadline: float
    grace: float = 0.0

    @property
    def late(self) -> float:
        """When simplifying and rounding end, in time.monotonic() [s]."""
        return self.deadline + self.grace

    def bounds(self) -> tuple[Array, Array]:
        """Least and largest joint values (n,): the limits; of continuous joints, half a turn beyond start and goal."""
        limits = self.model.robot.limits
        low = np.where(np.isfinite(limits.lower), limits.lower, np.minimum(self.start, self.goal) - np.pi)
        high = np.where(np.isfinite(limits.upper), limits.upper, np.maximum(self.start, self.goal) + np.pi)
        return low, high
