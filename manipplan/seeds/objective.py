"""The path cost g for OMPL's optimising planners, integrated along straight motions."""

import numpy as np

from manipplan.cost.integral import PathIntegral, speeds
from manipplan.support.checks import Array

#: Maximum length of the panels in which a motion is integrated [rad or m], and number of Gauss points per panel.
PANEL = 0.2
POINTS = 5
#: Lower bound on the manipulability in the cost: a motion through a singularity is expensive, but its cost is finite.
LEAST = 1e-12


def motion_cost(integral: PathIntegral, first: Array, second: Array) -> float:
    """g of the straight motion between two configurations (n,): (6.6) in kth2012, with the floor of the objective."""
    length = float(np.linalg.norm(second - first))
    if length == 0.0:
        return 0.0
    nodes, weights = _rule(int(np.ceil(length / PANEL)))
    m = integral.kinematics.manipulability(first + nodes[:, None] * (second - first))
    speed = float(speeds((second - first)[None], integral.metric)[0])
    return float(speed * (weights @ np.maximum(np.hypot(m, integral.floor), LEAST) ** -integral.power))


def ompl_objective(information: object, integral: PathIntegral) -> object:
    """An OptimizationObjective of OMPL whose cost of a motion is `motion_cost`.

    It has no lower bound on the cost to the goal, so OMPL uses zero: the maximum manipulability of an arm is not known, and a
    planner that relies on a wrong bound discards the best paths.
    """
    from ompl import base

    n = integral.kinematics.robot.n

    class ManipulabilityObjective(base.OptimizationObjective):  # type: ignore[misc]  # ompl has no stubs
        """Not a subclass of StateCostIntegralObjective, whose overridden methods the bindings never call."""

        def stateCost(self, state: object) -> object:  # noqa: N802  # OMPL's name
            m = float(integral.kinematics.manipulability(_configuration(state, n)))
            return base.Cost(max(float(np.hypot(m, integral.floor)), LEAST) ** -integral.power)

        def motionCost(self, first: object, second: object) -> object:  # noqa: N802  # OMPL's name
            return base.Cost(motion_cost(integral, _configuration(first, n), _configuration(second, n)))

    return ManipulabilityObjective(information)


def _configuration(state: object, n: int) -> Array:
    return np.array(state[0:n])  # type: ignore[index]  # ompl has no stubs


def _rule(panels: int) -> tuple[Array, Array]:
    """Gauss points and weights (m,) over [0, 1] in equal panels."""
    x, w = np.polynomial.legendre.leggauss(POINTS)
    nodes = (np.arange(panels)[:, None] + (x + 1) / 2) / panels
    return nodes.ravel(), np.tile(w / 2, panels) / panels
