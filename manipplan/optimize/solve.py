"""One solve from a start to a goal: local optima, polish, and the choice between them and the seed."""

import logging
from dataclasses import dataclass, field

import numpy as np

from manipplan.checks import Array
from manipplan.interrupts import interruptible
from manipplan.measures.measure import Measure
from manipplan.measures.task import Task
from manipplan.optimize.basis import named_basis
from manipplan.optimize.ends import EndConditions
from manipplan.optimize.local import LocalSearch, Step
from manipplan.optimize.objective import ACCURACY, PathObjective
from manipplan.optimize.polish import polished
from manipplan.optimize.problem import PathProgram
from manipplan.optimize.result import PathResult, measured
from manipplan.paths.joint import JointPath
from manipplan.robots.collision import CollisionModel
from manipplan.robots.robot import Robot
from manipplan.robots.scene import Scene
from manipplan.status import Status

log = logging.getLogger("manipplan")


@dataclass(frozen=True, kw_only=True, eq=False)
class PathProblem:
    """What is asked of the optimiser but for start and goal; it can be pickled and sent to another process.

    Attributes:
        robot, scene: the arm and its obstacles; None: nothing is checked for collision.
        task, measure, power, metric: of the objective.
        basis, degree, pieces: a name of BASES, the degree of its pieces, and how many there are.
        clearance: to keep [m].
        time_limit: of the planner [s].
        ends: fixed derivatives at start and goal.
        compiled: as in `Robot.kinematics`.
    """

    robot: Robot
    scene: Scene | None
    task: Task
    measure: Measure
    power: float
    metric: Array | None
    basis: str
    degree: int
    pieces: int
    clearance: float
    time_limit: float
    ends: EndConditions = field(default_factory=EndConditions)
    compiled: bool | str = "auto"

    def objective(self) -> PathObjective:
        """The objective for this process' robot."""
        kinematics = self.robot.kinematics(self.task, measure=self.measure, compiled=self.compiled)
        return PathObjective(kinematics=kinematics, power=self.power, metric=self.metric)

    def model(self) -> CollisionModel | None:
        """The collision model; None without a scene."""
        return None if self.scene is None else self.scene.collision_model(self.robot)


def solved(problem: PathProblem, start: Array, goal: Array, first: JointPath, *, straight: bool = True) -> PathResult:
    """The best path near `first`, which is free and inside the limits, and with `straight` near the straight line."""
    objective, model, clearance = problem.objective(), problem.model(), problem.clearance
    first_cost = objective.cost(first)
    history: list[Step] = []
    program = _program(problem, objective)
    search = LocalSearch(
        program=program, start=start, goal=goal, model=model, clearance=clearance, history=history, ends=problem.ends
    )
    is_line = len(first.control) == 1 and first.degree == 1
    is_free = bool(program.free.size)
    interrupted = False
    try:
        with interruptible():
            found = search.only_one() if not is_free else search.unconstrained() if straight or is_line else []
            if is_free and not (found and is_line):  # from a straight seed the same solve would come again
                by_steps = model is not None and len(program.basis.breaks) > 2
                found += search.by_steps(first) if by_steps else search.from_safe_path(first)
            best = min(found, key=lambda candidate: candidate.cost.g, default=None)
            if best is not None and is_free:
                best = polished(search, best)
    except KeyboardInterrupt:
        interrupted = True
        best = min(search.accepted, key=lambda candidate: candidate.cost.g, default=None)
    safe = model is None or best is not None
    fallback = problem.ends.met_by(first)
    # two that differ by less than g is measured to are as good
    if best is not None and (best.cost.g <= first_cost.g * (1 + ACCURACY) or not fallback):
        path, cost = best.path, best.cost
        status = Status.OPTIMAL if best.converged else Status.STOPPED_EARLY
    else:
        path, cost = first, first_cost
        status = Status.SEED_IS_BETTER if safe else Status.SEED_IS_SAFE
        status = status if fallback else Status.ENDS_NOT_MET
    if not np.isfinite(cost.g) and status is not Status.ENDS_NOT_MET:
        status = Status.SINGULAR
    unconstrained = np.nan
    if np.isfinite(cost.g) and not interrupted:
        try:
            with interruptible():
                unconstrained = search.unconstrained_g(path)
        except KeyboardInterrupt:
            interrupted = True
    if interrupted:
        status = Status.INTERRUPTED
    log.info("optimize_path: g %.4g, seed %.4g, %d solves: %s", cost.g, first_cost.g, len(history), status.name)
    solver = best.solver if best is not None and path is best.path and is_free else ""
    return measured(
        path,
        objective,
        cost=cost,
        seed=first,
        seed_cost=first_cost,
        model=model,
        clearance=clearance,
        status=status,
        solver=solver,
        unconstrained_g=unconstrained,
        history=tuple(history),
    )


def _program(problem: PathProblem, objective: PathObjective) -> PathProgram:
    kinematics, fixed = objective.kinematics, problem.ends.pattern
    basis = (problem.basis, problem.degree, problem.pieces)
    metric = None if objective.metric is None else objective.metric.tobytes()
    key = ("path program", kinematics.task, kinematics.measure, kinematics.compiled, objective.power, metric, basis, fixed)
    cache = kinematics.robot.cache
    if key not in cache:
        cache[key] = PathProgram(objective, named_basis(*basis), fixed)
    program: PathProgram = cache[key]
    return program
