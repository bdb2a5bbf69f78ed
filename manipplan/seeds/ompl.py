"""Searches by the planners of OMPL. Each motion is checked by one call of the compiled check of straight motions.

The path cost g for OMPL's optimising planners, integrated along straight motions.
"""

import threading
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from manipplan.cost.integral import PathIntegral, speeds
from manipplan.paths.rounding import gauss_rule
from manipplan.seeds.connect import LEAST, PANEL, POINTS, RANGE, SPARE, MotionCheck, can_check
from manipplan.seeds.seeding import FEASIBLE
from manipplan.seeds.task import PATIENCE, Level, SeedTask
from manipplan.support.checks import Array
from manipplan.support.deadline import work_time


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
    x, w = gauss_rule(POINTS)
    nodes = (np.arange(panels)[:, None] + (x + 1) / 2) / panels
    return nodes.ravel(), np.tile(w / 2, panels) / panels


#: OMPL has one random seed per process, so searches in several threads would not be repeatable.
_ONE_AT_A_TIME = threading.Lock()


@dataclass(frozen=True, kw_only=True, eq=False)
class OmplSearch:
    """A search by one of OMPL's planners.

    Attributes:
        planner: its name.
        integral: the cost; None: the length.
    """

    task: SeedTask
    planner: str
    integral: PathIntegral | None

    def run(self, levels: Sequence[Level]) -> Array | None:
        """Waypoints (k, n) of OMPL's path, or None when none was found.

        Motions are checked as `levels` tell, one after another; with more than MOST_JOINTS joints only as the last one tells.
        """
        with _ONE_AT_A_TIME:
            if work_time() >= self.task.deadline:
                return None
            compiled, last = can_check(self.task.model), levels[-1]
            return self._run(_Compiled(self.task, levels) if compiled else _Sampled(self.task, last.margin), last.step)

    def _run(self, check: "_Compiled | _Sampled", step: float) -> Array | None:
        from ompl import base, geometric, util

        task = self.task
        util.setLogLevel(util.LogLevel.LOG_NONE)
        util.RNG.setSeed(task.seed + 1)  # 0 would mean a random seed
        n = task.model.robot.n
        space = base.RealVectorStateSpace(n)
        bounds = base.RealVectorBounds(n)
        low, high = task.bounds()
        for joint in range(n):
            bounds.setLow(joint, float(low[joint]))
            bounds.setHigh(joint, float(high[joint]))
        space.setBounds(bounds)
        information = base.SpaceInformation(space)
        information.setStateValidityChecker(check.is_valid)
        information.setStateValidityCheckingResolution(step / float(space.getMaximumExtent()))
        validator = check.validator(information)
        if validator is not None:
            information.setMotionValidator(validator)
        information.setup()

        def is_over() -> bool:
            if work_time() >= task.deadline or (task.checks is not None and check.checks >= task.checks):
                return True
            return check.checks >= PATIENCE and task.why_unreachable() is not None

        problem = base.ProblemDefinition(information)
        problem.setStartAndGoalStates(_state(space, task.start), _state(space, task.goal), 1e-9)
        if self.integral is not None:
            problem.setOptimizationObjective(ompl_objective(information, self.integral))
        solver = getattr(geometric, self.planner)(information)
        if self.planner in FEASIBLE:  # by default a fifth of the space's extent, with two to four times as many checks
            solver.setRange(RANGE)
        solver.setProblemDefinition(problem)
        solver.setup()
        solver.solve(base.PlannerTerminationCondition(is_over))
        if not problem.hasExactSolution():
            return None
        path = problem.getSolutionPath()
        if self.integral is None:
            check.deadline = task.late
            simplifier = geometric.PathSimplifier(information)
            simplifier.reduceVertices(path)
            simplifier.partialShortcutPath(path)
            simplifier.collapseCloseVertices(path)
        points = np.array([path.getState(i)[0:n] for i in range(path.getStateCount())])
        points[0], points[-1] = task.start, task.goal
        return points


class _Compiled(MotionCheck):
    """The compiled check for OMPL. Past its deadline nothing is valid, so that a search ends soon."""

    def __init__(self, task: SeedTask, levels: Sequence[Level]) -> None:
        if task.most_crossings != 0:  # a motion alone cannot tell how many crossings its path has
            task = replace(task, most_crossings=None)
        super().__init__(task, levels)

    def is_valid(self, state: Any) -> bool:
        """Whether a configuration is free."""
        return work_time() < self.deadline and self.configuration(state[0 : self.n])

    def validator(self, information: object) -> object:
        """The MotionValidator of OMPL that asks the compiled check. No planner of ours asks where a motion becomes invalid."""
        from ompl import base

        check, n = self, self.n

        class Motions(base.MotionValidator):  # type: ignore[misc]  # ompl has no stubs
            def checkMotion(self, first: Any, last: Any) -> bool:  # noqa: N802  # OMPL's name
                return work_time() < check.deadline and check.motion(first[0:n], last[0:n])

        return Motions(information)


class _Sampled:
    """The check for more than MOST_JOINTS joints: OMPL asks for one configuration after the other.

    Attributes:
        deadline: past it nothing is valid, so that a search ends soon; in `work_time` [s].
        checks: number of configurations checked.
    """

    def __init__(self, task: SeedTask, margin: float) -> None:
        spare = min(task.distances) - task.clearance
        self._task, self._n, self._clearance = task, task.model.robot.n, task.clearance + min(margin, SPARE * spare)
        self.deadline, self.checks = task.deadline, 0

    def is_valid(self, state: Any) -> bool:
        """Whether a configuration is free."""
        task, q = self._task, np.array(state[0 : self._n])
        self.checks += 1
        if work_time() >= self.deadline or task.model.in_collision(q, clearance=self._clearance):
            return False
        return task.signs is None or task.most_crossings != 0 or task.signs.changes(np.array([task.start, q])) == 0

    def validator(self, _information: object) -> None:
        """None: OMPL's own check of motions, in steps, is used."""


def _state(space: object, q: Array) -> object:
    state = space.allocState()  # type: ignore[attr-defined]  # ompl has no stubs
    state[0 : len(q)] = [float(x) for x in q]
    return state
