"""Searches by the planners of OMPL; their motion check samples configurations."""

import threading
import time
from dataclasses import dataclass
from typing import Any

import numpy as np

from manipplan.cost.integral import PathIntegral
from manipplan.seeds.objective import ompl_objective
from manipplan.seeds.task import GRACE, SeedTask
from manipplan.support.checks import Array

#: Share of the distances of start and goal beyond the clearance up to which a margin is demanded.
SPARE = 0.9
#: OMPL has one random seed per process, so searches in several threads would not be repeatable.
_ONE_AT_A_TIME = threading.Lock()


@dataclass(frozen=True, kw_only=True, eq=False)
class OmplSearch:
    """A search by one of OMPL's planners.

    Attributes:
        planner: its name.
        integral: the cost; None: the length.
        checks: maximum number of checks of an optimising planner; None: the first path ends the search.
    """

    task: SeedTask
    planner: str
    integral: PathIntegral | None
    checks: int | None

    def run(self, step: float, margin: float) -> Array | None:
        """Waypoints (k, n) of OMPL's path, or None when none was found.

        Motions are checked every `step` [rad or m], with `margin` [m] more than the clearance.
        """
        with _ONE_AT_A_TIME:
            if time.monotonic() >= self.task.deadline:
                return None
            task = self.task
            spare = task.model.least_distance(np.array([task.start, task.goal]))[0] - task.clearance
            return self._run(step, task.clearance + min(margin, SPARE * spare))

    def _run(self, step: float, clearance: float) -> Array | None:
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
        done = 0
        late = task.deadline

        def is_valid(state: Any) -> bool:
            nonlocal done
            done += 1
            q = np.array(state[0:n])
            # past the deadline nothing is valid, so that a motion with many checks ends at once
            if time.monotonic() >= late or task.model.in_collision(q, clearance=clearance):
                return False
            return task.sides is None or task.most_crossings != 0 or task.sides.changes(np.array([task.start, q])) == 0

        def is_over() -> bool:
            return time.monotonic() >= task.deadline or (self.checks is not None and done >= self.checks)

        information.setStateValidityChecker(is_valid)
        information.setStateValidityCheckingResolution(step / float(space.getMaximumExtent()))
        information.setup()
        problem = base.ProblemDefinition(information)
        problem.setStartAndGoalStates(_state(space, task.start), _state(space, task.goal), 1e-9)
        if self.integral is not None:
            problem.setOptimizationObjective(ompl_objective(information, self.integral))
        solver = getattr(geometric, self.planner)(information)
        solver.setProblemDefinition(problem)
        solver.setup()
        solver.solve(base.PlannerTerminationCondition(is_over))
        if not problem.hasExactSolution():
            return None
        path = problem.getSolutionPath()
        if self.integral is None:
            late = task.deadline + GRACE
            simplifier = geometric.PathSimplifier(information)
            simplifier.reduceVertices(path)
            simplifier.partialShortcutPath(path)
            simplifier.collapseCloseVertices(path)
        points = np.array([path.getState(i)[0:n] for i in range(path.getStateCount())])
        points[0], points[-1] = task.start, task.goal
        return points


def _state(space: object, q: Array) -> object:
    state = space.allocState()  # type: ignore[attr-defined]  # ompl has no stubs
    state[0 : len(q)] = [float(x) for x in q]
    return state
