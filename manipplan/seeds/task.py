"""SeedTask: what a search for a seed path is given.

Which paths are accepted as seeds: proven free, within constraints, with no more crossings of singularities than allowed.
"""

import logging
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from manipplan.collision.model import CollisionModel
from manipplan.collision.path_clearance import path_clearance
from manipplan.constraints.constraint import ROW_TOLERANCE
from manipplan.constraints.constraint_set import ConstraintSet, prove
from manipplan.kinematics.factors import SingularitySigns
from manipplan.paths.joint import JointPath
from manipplan.support.checks import Array

log = logging.getLogger("manipplan")

#: Maximum time beyond the deadline for simplifying and rounding a path, as a share of the time limit, and at most [s].
GRACE, MOST_GRACE = 0.05, 0.3
#: Number of checks after which a search asks whether start and goal can be joined at all.
PATIENCE = 20_000
#: Ranges of joints above this count as unlimited [rad or m].
HUGE = 4 * np.pi + 1e-6
#: Maximum motion of a joint from start to goal [rad or m]: a path is checked in steps of down to a thousandth of that unit.
LONGEST = 1000.0


@dataclass(frozen=True, kw_only=True)
class Level:
    """How motions are checked until `checks` further configurations were checked; the last level goes on.

    Attributes:
        step: maximum motion of a joint between two checks [rad or m].
        margin: distance beyond the clearance [m]; less near start and goal, where they have less.
        checks: number of configurations.
    """

    step: float
    margin: float
    checks: int = 0


@dataclass(frozen=True, kw_only=True, eq=False)
class SeedTask:
    """A search from start to goal.

    Attributes:
        model: the robot among its obstacles.
        start, goal: (n,) [rad or m].
        distances: smallest distance of two bodies at start and at goal [m].
        seed: random seed.
        clearance: minimum distance [m] between bodies.
        signs: the functions whose changes of sign count as crossings of singularities; None: they do not count.
        most_crossings: maximum number of them on the path; None: any number.
        checks: maximum number of configurations checked for collision; None: any number.
        deadline: in `work_time` [s].
        grace: time beyond it for simplifying and rounding a path, and for telling why there is none [s].
        constraints: what is kept beside limits and clearance; None: nothing.
        why_unreachable: why no path joins start and goal; None where that is not proven.
    """

    model: CollisionModel
    start: Array
    goal: Array
    distances: tuple[float, float]
    seed: int
    clearance: float
    signs: SingularitySigns | None
    most_crossings: int | None
    checks: int | None
    deadline: float
    grace: float = 0.0
    constraints: ConstraintSet | None = None
    why_unreachable: Callable[[], str | None] = lambda: None

    @property
    def late(self) -> float:
        """When what may go on beyond the deadline ends, in `work_time` [s]."""
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


#: Maximum joint motion between two checks of a finished path [rad or m].
CHECK_STEP = 1e-3
#: The same for the first test of a path, before its proof; it begins with every FIRST-th configuration.
TEST_STEP, FIRST = 0.05, 8
#: Maximum joint motion between two configurations whose signs of the singularities are compared [rad or m].
SIGNS_STEP = 5e-3
#: Minimum distance of the ends beyond the clearance for a proof [m]; the proof's own tolerances take as much.
PROVABLE = 1e-4


def acceptance(task: SeedTask) -> Callable[[JointPath], bool]:
    """The acceptance test of a seed: proven free, or free at every milliradian if an end is too near contact for a proof.

    Samples are tested first: that refutes most paths that are not free in much less time.
    """
    if min(task.distances) <= task.clearance + PROVABLE:
        log.info("start or goal is too close to contact for a proof; the seed is checked at every milliradian")
        return lambda path: looks_free(task, path) and keeps_constraints(task, path) and is_free(task, path)

    def is_proven(path: JointPath) -> bool:
        if not (looks_free(task, path) and keeps_constraints(task, path)):
            return False
        return path_clearance(task.model, path, clearance=task.clearance, tolerance=None).proven

    return is_proven


def crossing_limit(task: SeedTask) -> Callable[[JointPath], bool]:
    """Whether a path crosses singularities no more often than allowed."""
    signs, most = task.signs, task.most_crossings
    if signs is None or most is None:
        return lambda _: True
    return lambda path: signs.changes(configurations(path, SIGNS_STEP)) <= most


def keeps_constraints(task: SeedTask, path: JointPath) -> bool:
    """Whether the path keeps the constraints everywhere, as `prove` says."""
    return task.constraints is None or prove(task.constraints, path).kept


def looks_free(task: SeedTask, path: JointPath) -> bool:
    """Whether the path is free and keeps the constraints at samples."""
    q = configurations(path, TEST_STEP)
    if task.constraints is not None and task.constraints.values(q).min(initial=0.0) < -ROW_TOLERANCE:
        return False
    few = q[FIRST // 2 :: FIRST]
    return not any(task.model.in_collision_rows(rows, clearance=task.clearance).any() for rows in (few, q))


def is_free(task: SeedTask, path: JointPath) -> bool:
    """Whether the path is free at every milliradian, and the proof found no contact in between."""
    return (
        task.model.path_is_free(path, CHECK_STEP, task.clearance)
        and not path_clearance(task.model, path, clearance=task.clearance, tolerance=None).refuted
    )


def configurations(path: JointPath, step: float) -> Array:
    """Configurations (m, n) along a path; between neighbours no joint moves by more than `step` [rad or m].

    In a Bernstein piece no joint is faster than the degree times the largest difference of neighbouring control points.
    """
    most = path.degree * np.abs(np.diff(path.control, axis=1)).max(axis=(1, 2))
    counts = np.maximum(1, np.ceil(most / step)).astype(int)
    first = np.cumsum(counts) - counts
    share = (np.arange(counts.sum()) - np.repeat(first, counts)) / np.repeat(counts, counts)
    s = np.repeat(path.breaks[:-1], counts) + share * np.repeat(np.diff(path.breaks), counts)
    return path(np.append(s, 1.0))
