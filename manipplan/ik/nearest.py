"""The configuration inside the limits that comes nearest to a pose: damped steps from many random starts."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from manipplan.ik.newton import descend, errors_to, random_near
from manipplan.kinematics.kinematics import Kinematics
from manipplan.paths.deviation import distances_between
from manipplan.robots.limits import JointLimits
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.display import one_line
from manipplan.symbolic.free_motion import FreeMotion

#: Number of random starts, and of the best ends from which the steps go on.
STARTS, BEST = 384, 16
#: Number of restarts, each with the initial damping.
RESTARTS = 4
#: Distance from a limit up to which a joint counts as being at it [rad or m].
AT_LIMIT = 1e-6
#: Position error above which it is tested whether the pose was given in millimetres [m].
FAR = 1.0


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class Nearest:
    """The configuration found that comes nearest to a pose: the norm of distance [m] and angle [rad] is the smallest.

    Attributes:
        q: (n,) inside the limits [rad or m].
        position, rotation: distance [m] and angle [rad] beyond what is allowed.
        stopped: names of the joints that are at a limit there.
    """

    q: Array
    position: float
    rotation: float
    stopped: tuple[str, ...]

    @property
    def away(self) -> str:
        """How far it is away."""
        return f"{1e3 * self.position:.4g} mm and {np.rad2deg(self.rotation):.3g}° away"

    def __str__(self) -> str:
        return self.away + (f", with {' and '.join(self.stopped)} at the limit" if self.stopped else "")


def millimetres_hint(pose: Array, away: float, away_from: Callable[[Array], float]) -> str:
    """What explains that a pose (4, 4) is out of reach by `away` [m], if it is within reach in millimetres; or ""."""
    if away < FAR:
        return ""
    scaled = np.array(pose)
    scaled[:3, 3] /= 1000
    hint = "; its position is within reach if it is in millimetres: divide it by 1000"
    return hint if away_from(scaled) < FAR / 1000 else ""


def nearest_to(kinematics: Kinematics, free: FreeMotion, pose: Array) -> Nearest:
    """The configuration nearest to what counts of a pose (4, 4); `kinematics` is of the whole pose."""
    robot = kinematics.robot
    starts = random_near(robot, pose, np.random.default_rng(0), STARTS, whole_pose=not free.turns.value)

    def missing(rows: NDArray[np.intp], q: Array) -> tuple[Array, Array]:
        return errors_to(kinematics, free, q, np.broadcast_to(pose, (len(rows), 4, 4)))

    q, _ = descend_to_best(robot.limits, missing, starts, np.zeros(robot.n, dtype=np.bool_))
    position, rotation = distances_between(kinematics.pose(q[None]), pose[None], free)
    return Nearest(q=q, position=float(position[0]), rotation=float(rotation[0]), stopped=stopped_at(robot, q))


def descend_to_best(
    limits: JointLimits,
    missing: Callable[[NDArray[np.intp], Array], tuple[Array, Array]],
    starts: Array,
    held: NDArray[np.bool_],
) -> tuple[Array, Array]:
    """The configuration (n,) that misses least after damped steps from starts (k, n), and what it misses (r,); as `descend`."""
    q, miss = descend(limits, missing, starts, held)
    for _ in range(RESTARTS):
        best = np.argsort((miss**2).sum(axis=1), kind="stable")[:BEST]
        q, miss = descend(limits, missing, q[best], held)
    least = int((miss**2).sum(axis=1).argmin())
    return q[least], miss[least]


def stopped_at(robot: Robot, q: Array) -> tuple[str, ...]:
    """Names of the joints that are at a limit at q (n,)."""
    limited = np.minimum(q - robot.limits.lower, robot.limits.upper - q) <= AT_LIMIT
    return tuple(name for name, at in zip(robot.joint_names, limited, strict=True) if at)
