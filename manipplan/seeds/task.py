"""SeedTask: what a search for a seed path is given."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from manipplan.collision.model import CollisionModel
from manipplan.constraints.constraint_set import ConstraintSet
from manipplan.kinematics.sides import SingularitySigns
from manipplan.support.checks import Array

#: Maximum time beyond the deadline for simplifying and rounding a path, as a share of the time limit, and at most [s].
GRACE, MOST_GRACE = 0.05, 0.3
#: Number of checks after which a search asks whether start and goal can be joined at all.
PATIENCE = 20_000
#: Ranges of joints above this count as unlimited [rad or m].
HUGE = 4 * np.pi + 1e-6


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
        deadline: in `work_time` [s].
        grace: time beyond it for simplifying and rounding a path [s].
        constraints: what is kept beside limits and clearance; None: nothing.
        why_unreachable: why no path joins start and goal; None where that is not proven.
    """

    model: CollisionModel
    start: Array
    goal: Array
    distances: tuple[float, float]
    seed: int
    clearance: float
    sides: SingularitySigns | None
    most_crossings: int | None
    checks: int | None
    deadline: float
    grace: float = 0.0
    constraints: ConstraintSet | None = None
    why_unreachable: Callable[[], str | None] = lambda: None

    @property
    def late(self) -> float:
        """When simplifying and rounding end, in `work_time` [s]."""
        return self.deadline + self.grace

    def bounds(self) -> tuple[Array, Array]:
        """Least and largest joint values (n,) of a search.

        These are the limits. A range that is infinite or HUGE is cut half a turn beyond start and goal, and that of a prismatic
        joint π m and the distance of start and goal beyond them. Held joints keep the value of the start.
        """
        robot = self.model.robot
        lower, upper = robot.limits.lower, robot.limits.upper
        beyond = np.pi + np.where([kind == "prismatic" for kind in robot.joint_types], np.abs(self.goal - self.start), 0.0)
        is_huge = ~(upper - lower <= HUGE)
        low = np.where(is_huge, np.maximum(np.minimum(self.start, self.goal) - beyond, lower), lower)
        high = np.where(is_huge, np.minimum(np.maximum(self.start, self.goal) + beyond, upper), upper)
        if self.constraints is not None:
            low, high = (np.where(self.constraints.held, self.start, each) for each in (low, high))
        return low, high
