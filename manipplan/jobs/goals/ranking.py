"""Ranking: which of the configurations that reach a goal of several tools are better, for the robot and for each arm alone."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from manipplan.cost.integral import PathIntegral
from manipplan.jobs.goals.own_arm import OfTool
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array


@dataclass(frozen=True, kw_only=True, eq=False)
class Ranking:
    """Orders configurations by manipulability, of which more than at the start (n,) counts as equal, then by nearness to it."""

    robot: Robot
    start: Array
    integral: PathIntegral

    def whole(self, q: Array) -> NDArray[np.int64]:
        """The order of configurations (k, n), the best first."""
        return self._order(self.integral.kinematics.manipulability(np.vstack([self.start, q])), q)

    def of_tool(self, tool: str, q: Array) -> NDArray[np.int64]:
        """The same by the arm of one tool alone."""
        return self._order(self._figures(tool, np.vstack([self.start, q])), q)

    def places(self, places: Array, found: Mapping[str, OfTool]) -> NDArray[np.int64]:
        """The order of the places (p, n) at which every tool has a solution: the first one first, then the best."""
        least = np.full(len(places), np.inf)
        for tool, each in found.items():
            figures, best = self._figures(tool, np.vstack([self.start, each.q])), np.full(len(places), -np.inf)
            np.maximum.at(best, each.place, np.minimum(figures[1:], figures[0]))
            least = np.minimum(least, best)
        order = np.lexsort((np.linalg.norm(places - self.start, axis=1), -least.round(12), np.arange(len(places)) > 0))
        return np.asarray(order[np.isfinite(least[order])])

    def _figures(self, tool: str, q: Array) -> Array:
        """Manipulability of one arm at q (k, n); zero where that of the robot is not made of those of its arms."""
        kinematics, joints = self.integral.kinematics, list(self.robot.joints_of(tool))
        if not kinematics.measure.over_tools:
            return np.zeros(len(q))
        one = self.robot.arm(tool).kinematics(kinematics.task, measure=kinematics.measure.of_one_tool(), threads=1)
        return one.manipulability(q[:, joints])

    def _order(self, figures: Array, q: Array) -> NDArray[np.int64]:
        """The order of q (k, n) by figures (1 + k,), the first of which is that of the start."""
        capped = np.minimum(figures[1:], figures[0])
        return np.lexsort((np.linalg.norm(q - self.start, axis=1), -capped.round(12)))
