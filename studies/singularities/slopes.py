"""g of straight paths that cross none to three singularities, over a series of floors."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import ellipkinc

import manipplan as mp
from manipplan.cost.crossings import Crossing, find_crossings
from manipplan.cost.integral import PathIntegral

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
    crossings: tuple[Crossing, ...]
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
        path = mp.JointPath.line([0.0, BEGIN], [FIRST * (end - BEGIN), end])
        # ∫ dθ / sqrt(sin²θ + ε²) = F(θ | -1 / ε²) / ε
        exact = [np.hypot(1, FIRST) * float(ellipkinc(end, -(e**-2)) - ellipkinc(BEGIN, -(e**-2))) / e for e in SHARES]
        found.append(_series(robot, path, SHARES, np.array(exact)))
    return found


def spatial() -> list[Series]:
    """The UR5, whose det J is a product of the factors of shoulder, elbow and wrist."""
    robot = mp.load_robot("ur5")
    largest = robot.kinematics().manipulability(mp.JointPath.line(START, GOALS[0])(np.linspace(0, 1, 101))).max()
    return [_series(robot, mp.JointPath.line(START, goal), largest * SHARES) for goal in GOALS]


def _series(robot: mp.Robot, path: mp.JointPath, floors: Array, exact: Array | None = None) -> Series:
    g, finite = [], []
    crossings: tuple[Crossing, ...] = ()
    for floor in floors:
        integral = PathIntegral(kinematics=robot.kinematics(), power=1.0, floor=float(floor))
        cost = integral.cost(path)
        crossings = find_crossings(path, integral, cost)
        g.append(cost.g)
        finite.append(cost.g - sum(each.cost for each in crossings))
    return Series(arm=robot.name, floors=floors, g=np.array(g), finite=np.array(finite), crossings=crossings, exact=exact)
