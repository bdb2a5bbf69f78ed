"""optimize_path: the polynomial joint path of least g between two configurations, among obstacles."""

import itertools
import logging
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from manipplan.checks import Array, instance, number, whole_number
from manipplan.errors import InvalidInputError, PlanningError, UnknownNameError
from manipplan.interrupts import interruptible
from manipplan.kinematics.kinematics import Kinematics
from manipplan.measures.indices import Yoshikawa
from manipplan.measures.measure import Measure
from manipplan.measures.names import MEASURES
from manipplan.measures.task import Task
from manipplan.optimize.local import LocalSearch, Step
from manipplan.optimize.metric import metric_matrix
from manipplan.optimize.objective import PathCost, PathObjective
from manipplan.optimize.polish import polished
from manipplan.optimize.problem import PathProgram
from manipplan.paths.joint import JointPath
from manipplan.robots.collision import CollisionModel
from manipplan.robots.robot import Robot
from manipplan.robots.scene import Scene
from manipplan.seeds.ompl import CHECK_STEP, check_apart, seed_path
from manipplan.status import Status

log = logging.getLogger("manipplan")

SHIFTS = ("none", "within-limits")


@dataclass(frozen=True, kw_only=True)
class PathResult:
    """What `optimize_path` found.

    Attributes:
        path: the JointPath; the seed when `status` says so, None when there is none (NO_PATH, with throw=False).
        g: ∫ ‖q'‖_W / m^power ds on a fine rule: (6.6) in kth2012 with its exponent as a parameter.
        length: of the path in joint space [rad].
        min_manipulability: least index on a dense grid [measure.unit(task)], and `min_at`, the s where it is.
        power, task: the objective's exponent and the task whose index it holds.
        seed, seed_cost: the collision-free first path (straight without a scene) and its cost, for comparison.
        history: every solve, in order.
        status: Status.
        measure, metric: m, and W (n, n) or None for the identity.
    """

    path: JointPath | None
    g: float
    length: float
    min_manipulability: float
    min_at: float
    power: float
    task: Task
    seed: JointPath | None
    seed_cost: PathCost
    history: tuple[Step, ...]
    status: Status
    measure: Measure = field(default_factory=Yoshikawa)
    metric: Array | None = None


@interruptible()
def optimize_path(
    robot: Robot,
    start: ArrayLike,
    goal: ArrayLike,
    degree: int = 6,
    power: float = 1,
    task: Task | None = None,
    scene: Scene | None = None,
    initial: JointPath | None = None,
    shifts: str = "none",
    *,
    measure: Measure | str | None = None,
    metric: ArrayLike | None = None,
    clearance: float = 0.0,
    seed: int = 0,
    throw: bool = True,
) -> PathResult:
    """Find a path of `degree` from start to goal of low g = ∫ ‖q'‖_W / m^power ds [kth2012, ch. 6].

    The energy ∫ ‖q'‖_W² / m^(2 power) ds is minimised by IPOPT with exact Hessians, from the straight line and from the
    seed; over all curves it has the minima of g. From the best of these g itself is minimised, and reported on a finer
    rule. Joint limits hold on the whole curve. With a scene, the path is free at every milliradian: either optimised, or
    the seed.

    Args:
        robot: the arm.
        start, goal: (n,) inside the limits [rad or m].
        degree: of the polynomial, 1 to 20; 1 is the straight line.
        power: exponent p of the index, above 0 and at most 100.
        task: whose index counts; default `robot.default_task`.
        scene: obstacles; None: no collision is checked, not even of the arm with itself.
        initial: first path from start to goal; with a scene it must be free. Default: straight, or by `seed_path`.
        shifts: "within-limits" tries goals 2π away in each revolute joint too, and returns the best; the goal's pose is
            the same. That is up to 3 to the power of n solves. Not together with a scene or `initial`.
        measure: m, a name of `available_measures()` or a Measure that is at least zero and better when larger; default
            Yoshikawa's index.
        metric: W in ‖q'‖_W² = q'ᵀ W q', weights (n,) > 0 or a symmetric positive definite matrix (n, n); default identity.
        clearance: distance [m] to keep from obstacles and between the arm's own links.
        seed: for the planner of the first path.
        throw: raise PlanningError when no free path was found, or the path's index vanishes somewhere (g is infinite);
            False: return the result, whose status or g says so.

    Raises:
        InvalidInputError: an argument is not usable.
        PlanningError: with `throw`, no free seed was found, or every path found meets a singularity.
    """
    instance("robot", robot, Robot)
    if scene is not None:
        instance("scene", scene, Scene)
    if initial is not None:
        instance("initial", initial, JointPath)
    degree = whole_number("degree", degree, least=1, most=20)
    power = number("power", power, above=0.0, most=100.0)
    clearance = number("clearance", clearance, least=0.0)
    if shifts not in SHIFTS:
        raise UnknownNameError("shifts", str(shifts), SHIFTS)
    if shifts != "none" and (scene is not None or initial is not None):
        raise InvalidInputError("shifts", shifts, "'none' together with a scene or an initial path")
    q_start, q_goal = robot.configuration("start", start), robot.configuration("goal", goal)
    kinematics = robot.kinematics(task, measure=measure)
    check_task(kinematics)
    check_measure(kinematics)
    objective = PathObjective(kinematics=kinematics, power=power, metric=metric_matrix("metric", metric, robot.n))
    goals = [q_goal] if shifts == "none" else _shifted_goals(robot, q_start, q_goal)
    model = None if scene is None else scene.collision_model(robot)
    if model is not None:
        model.free_configuration("start", q_start, clearance)
        model.free_configuration("goal", q_goal, clearance)
    results = []
    for each in goals:
        try:
            first = _first_path(robot, q_start, each, scene, model, initial, clearance, seed)
        except PlanningError as error:
            failed = _no_path(objective)
            if throw:
                raise PlanningError(str(error), failed) from error
            return failed
        results.append(_optimize(objective, q_start, each, degree, first, model, clearance))
    best = min(results, key=lambda result: result.g)
    if throw and not np.isfinite(best.g):
        raise PlanningError(f"the index vanishes on the path at s = {best.min_at:.3f}, so g is infinite", best)
    return best


def check_task(kinematics: Kinematics) -> None:
    """Raise InvalidInputError when the task has more rows than the arm has joints."""
    task, n = kinematics.task, kinematics.robot.n
    if task.rows > n:
        raise InvalidInputError(
            "task", task.name, f"at most {n} rows; with more rows than joints the index is identically zero"
        )


def check_measure(kinematics: Kinematics) -> None:
    """Raise InvalidInputError for a measure that can be negative, or is better when smaller."""
    measure = kinematics.measure
    if not measure.grows:
        usable = [name for name, kind in MEASURES.items() if kind.grows]
        wanted = f"a measure that is at least zero and better when larger: {', '.join(usable)}, or one of your own"
        raise InvalidInputError("measure", measure.name, wanted)
    measure.check(kinematics.task.rows, kinematics.robot.n)


def _no_path(objective: PathObjective) -> PathResult:
    nothing = PathCost(g=np.inf, length=np.inf, min_manipulability=0.0, at=0.0)
    return PathResult(
        path=None,
        g=np.inf,
        length=np.inf,
        min_manipulability=0.0,
        min_at=0.0,
        power=objective.power,
        task=objective.kinematics.task,
        measure=objective.kinematics.measure,
        metric=objective.metric,
        seed=None,
        seed_cost=nothing,
        history=(),
        status=Status.NO_PATH,
    )


def _first_path(
    robot: Robot,
    start: Array,
    goal: Array,
    scene: Scene | None,
    model: CollisionModel | None,
    initial: JointPath | None,
    clearance: float,
    seed: int,
) -> JointPath:
    check_apart(start, goal)
    if initial is None:
        if model is None:
            return JointPath.line(start, goal)
        return seed_path(robot, start, goal, scene, seed=seed, clearance=clearance)
    if initial.n != robot.n or np.abs(initial.start - start).max() > 1e-9 or np.abs(initial.goal - goal).max() > 1e-9:
        raise InvalidInputError("initial", f"a path of {initial.n} joints", "a path from start to goal")
    low, high = initial.bounds()
    for q in (low, high):
        robot.configuration("initial", q, tolerance=1e-9)
    if model is not None and not model.path_is_free(initial, CHECK_STEP, clearance):
        raise InvalidInputError("initial", "a path in collision", "a path that is free with the demanded clearance")
    return initial


def _shifted_goals(robot: Robot, start: Array, goal: Array) -> list[Array]:
    """The goal and all that differ from it by a turn in some revolute joints, inside the limits."""
    turns = []
    for joint, kind in enumerate(robot.joint_types):
        options = (0,) if kind == "prismatic" else (-1, 0, 1)
        turns.append([2 * np.pi * k for k in options if not _outside(robot, joint, goal[joint] + 2 * np.pi * k)])
    goals = [goal + np.array(shift) for shift in itertools.product(*turns)]
    return [each for each in goals if np.abs(each - start).max() > 1e-9]


def _outside(robot: Robot, joint: int, value: float) -> bool:
    return not robot.limits.lower[joint] <= value <= robot.limits.upper[joint]


def _optimize(
    objective: PathObjective,
    start: Array,
    goal: Array,
    degree: int,
    first: JointPath,
    model: CollisionModel | None,
    clearance: float,
) -> PathResult:
    first_cost = objective.cost(first)
    history: list[Step] = []
    program = _program(objective, degree)
    search = LocalSearch(program=program, start=start, goal=goal, model=model, clearance=clearance, history=history)
    is_line = len(first.control) == 1 and first.degree == 1
    found = search.line() if degree == 1 else search.unconstrained()
    if degree > 1 and not (found and is_line):  # from a straight seed the same solve would come again
        found += search.from_safe_path(first)
    safe = model is None or bool(found)
    best = min(found, key=lambda candidate: candidate.cost.g, default=None)
    if best is not None and degree > 1:
        best = polished(search, best)
    if best is not None and best.cost.g <= first_cost.g:
        path, cost = best.path, best.cost
        status = Status.OPTIMAL if best.converged else Status.STOPPED_EARLY
    else:
        path, cost = first, first_cost
        status = Status.SEED_IS_BETTER if safe else Status.SEED_IS_SAFE
    if not np.isfinite(cost.g):
        status = Status.SINGULAR
    log.info("optimize_path: g %.4g, seed %.4g, %d solves: %s", cost.g, first_cost.g, len(history), status.name)
    return PathResult(
        path=path,
        g=cost.g,
        length=cost.length,
        min_manipulability=cost.min_manipulability,
        min_at=cost.at,
        power=objective.power,
        task=objective.kinematics.task,
        measure=objective.kinematics.measure,
        metric=objective.metric,
        seed=first,
        seed_cost=first_cost,
        history=tuple(history),
        status=status,
    )


def _program(objective: PathObjective, degree: int) -> PathProgram:
    kinematics = objective.kinematics
    metric = None if objective.metric is None else objective.metric.tobytes()
    key = ("path program", kinematics.task, kinematics.measure, objective.power, metric, degree)
    cache = kinematics.robot.cache
    if key not in cache:
        cache[key] = PathProgram(objective, degree)
    program: PathProgram = cache[key]
    return program
