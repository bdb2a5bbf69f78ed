"""The path cost g for OMPL's optimising planners: ∫ ‖q'‖ / m^p along straight motions."""

import numpy as np

from manipplan.kinematics.kinematics import Kinematics
from manipplan.support.checks import Array

#: Maximum length of the panels in which a motion is integrated [rad or m], and number of Gauss points per panel.
PANEL = 0.2
POINTS = 5
#: Lower bound on the manipulability in the cost: a motion through a singularity is expensive, but its cost is finite.
LEAST = 1e-12


def motion_cost(kinematics: Kinematics, power: float, first: Array, second: Array) -> float:
    """∫ ‖q'‖ / m^p ds along the straight motion between two configurations (n,): (6.6) in kth2012."""
    length = float(np.linalg.norm(second - first))
    if length == 0.0:
        return 0.0
    nodes, weights = _rule(int(np.ceil(length / PANEL)))
    index = kinematics.manipulability(first + nodes[:, None] * (second - first))
    return float(length * (weights @ np.maximum(index, LEAST) ** -power))


def index_objective(information: object, kinematics: Kinematics, power: float) -> object:
    """An OptimizationObjective of OMPL whose cost of a motion is `motion_cost`.

    It has no lower bound on the cost to the goal, so OMPL uses zero: the maximum manipulability of an arm is not known, and a
    planner that relies on a wrong bound discards the best paths.
    """
    from ompl import base

    n = kinematics.robot.n

    class IndexObjective(base.OptimizationObjective):  # type: ignore[misc]  # ompl has no stubs
        """Not a subclass of StateCostIntegralObjective, whose overridden methods the bindings never call."""

        def stateCost(self, state: object) -> object:  # noqa: N802  # OMPL's name
            index = float(kinematics.manipulability(_configuration(state, n)))
            return base.Cost(max(index, LEAST) ** -power)

        def motionCost(self, first: object, second: object) -> object:  # noqa: N802  # OMPL's name
            return base.Cost(motion_cost(kinematics, power, _configuration(first, n), _configuration(second, n)))

    return IndexObjective(information)


def _configuration(state: object, n: int) -> Array:
    return np.array(state[0:n])  # type: ignore[index]  # ompl has no stubs


def _rule(panels: int) -> tuple[Array, Array]:
    """Gauss points and weights (m,) over [0, 1] in equal panels."""
    x, w = np.polynomial.legendre.leggauss(POINTS)
    nodes = (np.arange(panels)[:, None] + (x + 1) / 2) / panels
    return nodes.ravel(), np.tile(w / 2, panels) / panels
