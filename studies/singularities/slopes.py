"""g of straight paths that cross none to three singularities, over a series of floors."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import ellipkinc

import manipplan as mp

Array = NDArray[np.float64]

#: Floors ε, as shares of the largest m on the path that crosses nothing.
SHARES = np.logspace(-2, -6, 9)
#: Motion of the first joint of the planar arm per radian of the second.
FIRST = 0.5
#: Second joint of the planar arm at the start, and its motion besides half a turn per crossing [rad].
BEGIN, MORE = 0.4, 0.6
#: Start of the UR5, and goals that the straight line reaches without a crossing, through the singularity of the wrist, through
#: those of shoulder and elbow, and through all three, which lie apart [rad].
START = (0.3, -1.2, 1.2, -0.8, 0.9, 0.2)
GOALS = (
    (0.6, -1.4, 1.6, -0.9, 1.3, 0.4),
    (0.6, -0.6, 1.6, -0.9, -0.9, 0.4),
    (0.6, -2.4, -0.5, -0.9, 1.3, 0.4),
    (0.6, -1.4, -0.5, -0.9, -0.9, 0.4),
)


@dataclass(frozen=True, kw_only=True)
class Series:
    """g of one path over the floors.

    Attributes:
        arm: name of the robot.
        floors: ε (k,) [unit of m].
        g: (k,).
        finite: g less the cost of all crossings, (k,).
        crossings: those of the smallest floor.
        exact: g in closed form, (k,); None where there is none.
    """

    arm: str
    floors: Array
    g: Array
    finite: Array
    crossings: tuple[mp.results.Crossing, ...]
    exact: Array | None = None

    @property
    def slope(self) -> float:
        """Slope of g over log(1 / ε) between the two smallest floors."""
        return float((self.g[-1] - self.g[-2]) / np.log(self.floors[-2] / self.floors[-1]))

    @property
    def derived(self) -> float:
        """The slope that follows from the steepness of the crossings: Σ 2 / σ."""
        return float(sum(2 / each.steepness for each in self.crossings))

    @property
    def error(self) -> float:
        """Largest relative difference of g from the closed form; nan without one."""
        return float(np.nan if self.exact is None else np.abs(self.g / self.exact - 1).max())


def planar() -> list[Series]:
    """Two unit links: m = |sin θ₂|, so that g_ε is an elliptic integral of the first kind."""
    robot = mp.planar_arm([1.0, 1.0])
    found = []
    for count in range(4):
        end = BEGIN + MORE + count * np.pi
        goal = (FIRST * (end - BEGIN), end)
        # ∫ dθ / sqrt(sin²θ + ε²) = F(θ | -1 / ε²) / ε
        exact = [np.hypot(1, FIRST) * float(ellipkinc(end, -(e**-2)) - ellipkinc(BEGIN, -(e**-2))) / e for e in SHARES]
        found.append(_series(robot, (0.0, BEGIN), goal, SHARES, np.array(exact)))
    return found


def spatial() -> list[Series]:
    """The UR5, whose det J is a product of the factors of shoulder, elbow and wrist."""
    robot = mp.load_robot("ur5")
    largest = robot.kinematics().manipulability(mp.JointPath.line(START, GOALS[0])(np.linspace(0, 1, 101))).max()
    return [_series(robot, START, goal, largest * SHARES) for goal in GOALS]


def _series(
    robot: mp.Robot, start: Sequence[float], goal: Sequence[float], floors: Array, exact: Array | None = None
) -> Series:
    line = mp.PathShape(degree=1)
    found = [
        mp.optimize_path(robot, start, goal, objective=mp.PathObjective(floor=float(floor)), shape=line).certificate
        for floor in floors
    ]
    return Series(
        arm=robot.name,
        floors=floors,
        g=np.array([each.g for each in found]),
        finite=np.array([each.finite_g for each in found]),
        crossings=found[-1].crossings,
        exact=exact,
    )
