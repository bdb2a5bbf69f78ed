"""optimize_path: the joint path of minimum g between two configurations, among obstacles.

Alternative paths: goals a turn away, seeds of several homotopy classes, their parallel solves, the best and its rivals. Two
free paths count as one class when the straight homotopy (1 - t) a(s) + t b(s) between them stays free on a grid. This is
conservative: paths of one class may count as two, and are then both solved. But a thin obstacle may be missed.
"""

import itertools
import pickle
import threading
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from functools import partial
from typing import Literal, TypeVar, overload

import numpy as np

from manipplan.collision.model import CollisionModel
from manipplan.collision.scene import Scene
from manipplan.constraints.constraint import Constraint, constraint_tuple
from manipplan.constraints.constraint_set import check_ends
from manipplan.cost.objective import PathObjective, idle_hint
from manipplan.optimize.problem import TIE, PathProblem, check_initial, initial_path, plan_first_path, solve_local
from manipplan.optimize.result import NoPath, PathResult
from manipplan.paths.basis import PathShape
from manipplan.paths.joint import JointPath
from manipplan.robots.limits import nearest_turns
from manipplan.robots.robot import Robot
from manipplan.seeds.seed import check_apart
from manipplan.seeds.seeding import AS_GIVEN, NEAREST, Seeding, random_path
from manipplan.support.checks import Array, ArrayLike, flag, instance, number
from manipplan.support.deadline import NEVER, Deadline
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.support.progress import Progress, as_callback, interruptible, part, silent
from manipplan.support.status import Status


@overload
def optimize_path(
    robot: Robot,
    start: ArrayLike,
    goal: ArrayLike,
    scene: Scene | None = ...,
    *,
    objective: PathObjective = ...,
    shape: PathShape = ...,
    seeding: Seeding = ...,
    constraints: Sequence[Constraint] = ...,
    clearance: float = ...,
    executor: Executor | None = ...,
    compare: bool = ...,
    compiled: bool | str = ...,
    throw: Literal[True] = True,
    progress: Progress | None = ...,
) -> PathResult: ...


@overload
def optimize_path(
    robot: Robot,
    start: ArrayLike,
    goal: ArrayLike,
    scene: Scene | None = ...,
    *,
    objective: PathObjective = ...,
    shape: PathShape = ...,
    seeding: Seeding = ...,
    constraints: Sequence[Constraint] = ...,
    clearance: float = ...,
    executor: Executor | None = ...,
    compare: bool = ...,
    compiled: bool | str = ...,
    throw: bool,
    progress: Progress | None = ...,
) -> PathResult | NoPath: ...


def optimize_path(
    robot: Robot,
    start: ArrayLike,
    goal: ArrayLike,
    scene: Scene | None = None,
    *,
    objective: PathObjective = PathObjective(),
    shape: PathShape = PathShape(),
    seeding: Seeding = Seeding(),
    constraints: Sequence[Constraint] = (),
    clearance: float = 0.0,
    executor: Executor | None = None,
    compare: bool = False,
    compiled: bool | str = "auto",
    throw: bool = True,
    progress: Progress | None = None,
) -> PathResult | NoPath:
    """Find a path of low g from start to goal, far from singularities [kth2012, chapter 6].

    g = ∫ ‖q'‖_W / (m² + floor²)^(power/2) ds is finite on paths through singularities, too, and `certificate` names them.
    The path is a polynomial, or a spline of several pieces. Sequential quadratic programming in a trust region [nocedal2006,
    ch. 18] minimises its energy, ∫ of the square of the same, from the straight line without obstacles and from the seed among
    planes between the bodies. From there it minimises g itself with the true distances of the scene. Among clouds, meshes that
    are not convex or 100 or more small obstacles, this is done in a coarse copy of the scene first, and then near the path
    found there. Degrees above 6 and paths of several pieces also start from the optimum of a lower degree. The path with the
    smallest g is returned; of two whose g differ by less than a share of 1e-5, the one found first. The optimum is local.

    Joint limits hold on the whole curve. With a scene, an optimised path is proven collision-free on the whole curve; a seed
    is proven too, or at least checked every milliradian. `certificate` holds the measured figures. Status.OPTIMAL means that
    the first-order conditions hold on the path: the projected gradient of g is at most 1e-3 per rad, relative to g;
    complementarity is at most 1e-5; active clearances are within 0.1 mm of the required one. If one of them does not hold,
    the status is STOPPED_EARLY. Where the time limit, `Seeding.time_limit` for each first path, ends the descents, it is
    OUT_OF_TIME, or SEED_OUT_OF_TIME for the first path: then the result depends on the speed of the machine.

    Args:
        robot: the arm.
        start, goal: (n,) inside the joint limits [rad or m].
        scene: obstacles. None: no collision is checked, not even of the arm with itself.
        objective: power, task, measure, metric and floor of g.
        shape: degree, basis, pieces and end derivatives of the path.
        seeding: how first paths are found, or a given one.
        constraints: TiltLimit, PositionBox, HeldJoints or a Constraint of yours, kept on the whole path; they need a scene.
        clearance: minimum distance [m] from obstacles and between the arm's own links; needs a scene. An optimised path keeps
            0.05 mm more, so that the proof succeeds, and along clouds and meshes up to 3 mm more.
        executor: runs first paths and solves in parallel; the result does not depend on it. Default: in turn, in this process.
        compare: also search for the optimum near the path without limits and obstacles; the certificate's `gap` tells what
            these cost. It takes about 0.1 s.
        compiled: True: objective, clearance rows and measure in machine code. It is compiled in a few seconds, once per robot,
            task, measure and metric, and kept in the user's cache folder. False: CasADi's virtual machine. "auto": machine
            code if there is a compiler, built once that pays off, except for measures whose Hessian takes long to compile
            (singular values, dynamic).
            The path is the same.
        throw: raise PlanningError when no collision-free path is found or, without a floor, m is zero on it, so that g is
            infinite. False: return a NoPath, or the result with Status.SINGULAR.
        progress: called with the completed share in [0, 1] and a text.

    Returns:
        The path with the smallest g. Its `rivals` are the results of other homotopy classes and goals. After an interrupt
        (Ctrl-C) the best checked path so far, with Status.INTERRUPTED. KeyboardInterrupt is raised instead during the search
        for first paths, during the final measurement of the path, and with an executor.

    Raises:
        InvalidInputError: an argument is invalid.
        CompilerError: `compiled` is True and there is no compiler, or it fails.
        PlanningError: with `throw`: no collision-free path was found, or g is infinite without a floor.
    """
    instance("robot", robot, Robot)
    flag("compare", compare)
    flag("throw", throw)
    if scene is not None:
        instance("scene", scene, Scene)
    check_options(objective, shape, seeding)
    shape.ends(robot.n)  # raises for derivatives that do not fit
    recorded = None if seeding.initial is None else initial_path(robot, seeding.initial)
    clearance = number("clearance", clearance, least=0.0)
    if clearance > 0 and scene is None:
        raise InvalidInputError(
            "clearance", clearance, "0 without a scene, since nothing is checked then; scene=Scene() checks for self-collision"
        )
    constraints = constraint_tuple(constraints)
    if constraints and scene is None:
        raise InvalidInputError("constraints", constraints, "none without a scene; scene=mp.Scene() checks for self-collision")
    if executor is not None:
        instance("executor", executor, Executor)
    notify = as_callback(progress)
    q_start, q_goal = robot.configuration("start", start), robot.configuration("goal", goal)
    if recorded is not None:  # full turns of a continuous joint are those of the first path
        q_goal = q_goal + np.where(robot.continuous_joints, 2 * np.pi * np.round((recorded.goal - q_goal) / (2 * np.pi)), 0.0)
    goals = shift_goals(robot, q_start, q_goal, seeding.shifts)
    q_goal = goals[0] if len(goals) == 1 else q_goal
    objective = objective.resolved(robot, compiled=compiled)
    deadline = Deadline.within(seeding.time_limit * seeding.count * len(goals))
    problem = PathProblem(
        robot=robot,
        scene=scene,
        objective=objective,
        shape=shape,
        seeding=replace(seeding, initial=None),
        clearance=clearance,
        compiled=compiled,
        given=recorded is not None,
        compares=compare,
        constraints=constraints,
    )
    if problem.constraint_set is not None:
        check_ends(problem.constraint_set, q_start, q_goal)
    if scene is not None:
        notify(0.0, "preparing collision shapes")
    model = problem.model()
    if model is not None:
        model.free_configuration("start", q_start, clearance)
        model.free_configuration("goal", q_goal, clearance)
    for each in goals:
        check_apart(q_start, each)
    first = seeding.seed if scene is not None else 0  # without a scene, seed 0 is the straight line
    numbers = [first, *(seeding.seed + k for k in range(1, seeding.count))]
    pool = SolvePool(problem=problem, executor=executor, notify=notify, deadline=deadline)
    if recorded is not None:
        check_initial(problem, recorded, q_start, q_goal)
        firsts = [FirstPath(path=recorded, count=1)]
    else:
        try:
            with interruptible():
                firsts = seed_classes(pool, q_start, goals, numbers)
        except PlanningError as error:
            if throw or not isinstance(error.result, NoPath):
                raise
            return error.result
    best = best_and_rivals(pool.solve_local(firsts))
    notify(1.0, "optimised")
    if throw and not np.isfinite(best.g) and best.status is not Status.INTERRUPTED:
        hint = idle_hint(objective.kinematics(robot, compiled=compiled))
        reason = f"the manipulability is zero on the path at s = {best.min_at:.3f}, so g is infinite"
        raise PlanningError(f"{reason}: {hint}" if hint else reason, best)
    return best


def optimize_from(
    robot: Robot,
    first: JointPath,
    scene: Scene | None,
    *,
    objective: PathObjective,
    shape: PathShape,
    constraints: Sequence[Constraint],
    clearance: float,
    deadline: Deadline,
) -> PathResult:
    """As `optimize_path`, with a first path known to be collision-free and no start from the optimum of a lower degree."""
    problem = PathProblem(
        robot=robot,
        scene=scene,
        objective=objective.resolved(robot),
        shape=shape,
        seeding=Seeding(),
        clearance=clearance,
        given=True,
        climbs=False,
        constraints=tuple(constraints),
    )
    return solve_local(problem, first, deadline=deadline)


def check_options(objective: PathObjective, shape: PathShape, seeding: Seeding) -> None:
    """Raise InvalidInputError for options of another type."""
    instance("objective", objective, PathObjective)
    instance("shape", shape, PathShape)
    instance("seeding", seeding, Seeding)


#: Number of places along two paths, and of stages between them, at which their homotopy is checked.
PATH_SAMPLES, STAGES = 80, 9
#: Two results are the same path when no joint differs by more than this at equal shares of their length [rad or m].
EQUAL_PATHS = 1e-2

T = TypeVar("T")
_own = threading.local()


@dataclass(frozen=True, kw_only=True)
class FirstPath:
    """A path to solve from, and the number of first paths of its class."""

    path: JointPath
    count: int


@dataclass(frozen=True, kw_only=True, eq=False)
class SolvePool:
    """Runs the tasks of one problem, in this process or on an executor, whose workers each have their own robot.

    The search for first paths reports progress 0 to 0.33.
    """

    problem: PathProblem
    executor: Executor | None = None
    notify: Progress = silent
    deadline: Deadline = NEVER

    def seeds(self, start: Array, tasks: Sequence[tuple[Array, int]]) -> list[JointPath | NoPath]:
        """A free first path per goal (n,) and seed."""
        wanted = [{"start": start, "goal": goal, "seed": seed, "deadline": self.deadline} for goal, seed in tasks]
        return self._each(_seed, wanted, part(self.notify, 0.0, 0.33), "looking for a first path")

    def solve_local(self, firsts: Sequence[FirstPath]) -> list[PathResult]:
        """The optimiser's result from each first path; the first one to each goal is solved from the straight line as well."""
        tasks: list[dict[str, object]] = []
        for k, first in enumerate(firsts):
            known = any(_ends_together(first.path, other.path) for other in firsts[:k])
            tasks.append({"first": first.path, "straight": not known, "deadline": self.deadline})
        results = self._each(solve_local, tasks, part(self.notify, 0.33, 1.0), "optimising the path")
        return [replace(result, first_paths=first.count) for result, first in zip(results, firsts, strict=False)]

    def _each(self, work: Callable[..., T], tasks: Sequence[dict[str, object]], notify: Progress, text: str) -> list[T]:
        made: list[Callable[[], T]]
        if self.executor is None:
            made = [partial(work, self.problem, **task) for task in tasks]
        else:
            packed = pickle.dumps(self.problem)
            try:
                made = [self.executor.submit(_at_worker, work, packed, task).result for task in tasks]
            except RuntimeError as error:  # it was shut down, or one of its processes died
                raise InvalidInputError("executor", self.executor, f"an executor that takes work ({error})") from error
        results = []
        for k, result in enumerate(made):
            notify(k / len(made), text if len(made) == 1 else f"{text}: {k} of {len(made)}")
            results.append(result())
            if isinstance(results[-1], PathResult) and results[-1].status is Status.INTERRUPTED:
                break
        return results


def seed_classes(pool: SolvePool, start: Array, goals: Sequence[Array], seeds: Iterable[int]) -> list[FirstPath]:
    """First paths to solve from: for each goal the first one that was found, and of every other class the one of smallest g.

    The first one is always among them, so that more seeds never give a larger g. Raises PlanningError when there is none to
    any goal.
    """
    tasks = list(itertools.product(goals, seeds))
    found = pool.seeds(start, tasks)
    of_goal = [goal for (goal, _), path in zip(tasks, found, strict=True) if isinstance(path, JointPath)]
    paths = [path for path in found if isinstance(path, JointPath)]
    if not paths:
        failure = next(each for each in found if isinstance(each, NoPath))
        raise PlanningError(failure.message, failure)
    model = pool.problem.model()
    if model is None or len(paths) == 1:
        return [FirstPath(path=path, count=1) for path in paths]
    integral = pool.problem.integral()
    is_first = [not any(goal is other for other in of_goal[:k]) for k, goal in enumerate(of_goal)]
    order = sorted(range(len(paths)), key=lambda k: (not is_first[k], integral.cost(paths[k]).g))
    chosen: list[FirstPath] = []
    for path in (paths[k] for k in order):
        for k, other in enumerate(chosen):
            if are_homotopic(model, path, other.path, pool.problem.clearance):
                chosen[k] = replace(other, count=other.count + 1)
                break
        else:
            chosen.append(FirstPath(path=path, count=1))
    return chosen


def are_homotopic(model: CollisionModel, first: JointPath, second: JointPath, clearance: float = 0.0) -> bool:
    """Whether the straight homotopy between two paths of the same ends is free of collision on a grid."""
    if np.abs(first.goal - second.goal).max() > 1e-9:
        return False
    a, b = _even(first), _even(second)
    return not any(
        model.in_collision((1 - t) * q + t * r, clearance=clearance)
        for t in np.linspace(0.0, 1.0, STAGES + 2)[1:-1]
        for q, r in zip(a, b, strict=True)
    )


def best_and_rivals(results: Sequence[PathResult]) -> PathResult:
    """The result with the smallest g, with the others as its rivals, best first, each path once.

    Of results whose g tie the earlier one comes first, so that rounding does not decide. The estimate of what is missing is
    that of Good and Turing [good1953].
    """
    classes: list[PathResult] = []
    for result in _best_first(results):
        known = next((k for k, other in enumerate(classes) if _coincide(result.path, other.path)), None)
        if known is None:
            classes.append(result)
        else:
            classes[known] = replace(classes[known], first_paths=classes[known].first_paths + result.first_paths)
    best = replace(classes[0], rivals=tuple(classes[1:]), missing=_missing(classes))
    if any(result.status is Status.INTERRUPTED for result in results):
        best = replace(best, status=Status.INTERRUPTED)
    return best


def _missing(results: Sequence[PathResult]) -> float:
    """The share of first paths whose result no other one to the same goal led to; nan where no goal has several."""
    all_paths = singles = 0
    for result in results:
        of_goal = sum(other.first_paths for other in results if _ends_together(result.path, other.path))
        if of_goal > 1:
            all_paths += result.first_paths
            singles += result.first_paths == 1
    return singles / all_paths if all_paths else np.nan


def _ends_together(first: JointPath, second: JointPath) -> bool:
    return bool(np.abs(first.goal - second.goal).max() < EQUAL_PATHS)


def _best_first(results: Sequence[PathResult]) -> list[PathResult]:
    left, ordered = list(results), []
    while left:
        least = min(each.g for each in left)
        first = next(k for k, each in enumerate(left) if each.g <= least * (1 + TIE))
        ordered.append(left.pop(first))
    return ordered


def shift_goals(robot: Robot, start: Array, goal: Array, shifts: str) -> list[Array]:
    """The full turns of a goal that `Seeding.shifts` asks for: for all of them, by one turn in some revolute joints."""
    if shifts == AS_GIVEN:
        return [goal]
    if shifts == NEAREST:
        return [nearest_turns(robot, goal[None], start)[0]]
    turns = []
    for joint, can_turn in enumerate(robot.turns.tolist()):
        options = (-1, 0, 1) if can_turn else (0,)
        low, high = robot.limits.lower[joint], robot.limits.upper[joint]
        turns.append([2 * np.pi * k for k in options if low <= goal[joint] + 2 * np.pi * k <= high])
    goals = [goal + np.array(shift) for shift in itertools.product(*turns)]
    return [each for each in goals if np.abs(each - start).max() > 1e-9]


def _coincide(first: JointPath, second: JointPath) -> bool:
    return bool(np.abs(_even(first) - _even(second)).max() < EQUAL_PATHS)


def _even(path: JointPath) -> Array:
    """Configurations (PATH_SAMPLES, n) at equal shares of the path's length."""
    s = np.linspace(0.0, 1.0, 1001)
    gained = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(path(s), axis=0), axis=1))])
    return path(np.interp(np.linspace(0.0, gained[-1], PATH_SAMPLES), gained, s))


def _seed(problem: PathProblem, start: Array, goal: Array, seed: int, deadline: Deadline) -> JointPath | NoPath:
    if problem.scene is None:
        return random_path(problem.robot, start, goal, seed)
    try:
        return plan_first_path(problem, start, goal, seed, deadline)
    except PlanningError as error:
        return NoPath(message=str(error))


def _at_worker(work: Callable[..., T], packed: bytes, task: dict[str, object]) -> T:
    """Run in a worker's thread, which unpacks the problem once and keeps it, with what was built for it, for later tasks."""
    if getattr(_own, "packed", None) != packed:
        _own.problem, _own.packed = pickle.loads(packed), packed
    return work(_own.problem, **task)
