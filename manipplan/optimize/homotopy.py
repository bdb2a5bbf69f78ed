"""Alternative paths: goals a turn away, seeds of several homotopy classes, their parallel solves, the best and its rivals.

Two free paths count as one class when the straight homotopy (1 - t) a(s) + t b(s) between them stays free on a grid. This is
conservative: paths of one class may count as two, and are then both solved. But a thin obstacle may be missed.
"""

import itertools
import logging
import pickle
import threading
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from functools import partial
from typing import TypeVar

import numpy as np

from manipplan.collision.model import CollisionModel
from manipplan.optimize.problem import TIE, PathProblem, plan_first_path, solve_local
from manipplan.optimize.result import NoPath, PathResult
from manipplan.paths.joint import JointPath
from manipplan.robots.configuration import nearest_turns
from manipplan.robots.robot import Robot
from manipplan.seeds.seeding import AS_GIVEN, NEAREST, random_path
from manipplan.support.checks import Array
from manipplan.support.deadline import NEVER, Deadline
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.support.progress import Progress, part, silent
from manipplan.support.status import Status

#: Number of places along two paths, and of stages between them, at which their homotopy is checked.
PATH_SAMPLES, STAGES = 80, 9
#: Two results are the same path when no joint differs by more than this at equal shares of their length [rad or m].
EQUAL_PATHS = 1e-2

log = logging.getLogger("manipplan")
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
        notify = part(self.notify, 0.0, 0.33)
        return self._each(
            _seed, [(start, goal, seed, self.deadline) for goal, seed in tasks], notify, "looking for a first path"
        )

    def solve_local(self, firsts: Sequence[FirstPath]) -> list[PathResult]:
        """The optimiser's result from each first path; the first one to each goal is solved from the straight line as well."""
        tasks = []
        for k, first in enumerate(firsts):
            known = any(_ends_together(first.path, other.path) for other in firsts[:k])
            tasks.append((first.path, not known, self.deadline))
        results = self._each(_solve, tasks, part(self.notify, 0.33, 1.0), "optimising the path")
        return [replace(result, first_paths=first.count) for result, first in zip(results, firsts, strict=False)]

    def _each(self, work: Callable[..., T], tasks: Sequence[tuple[object, ...]], notify: Progress, text: str) -> list[T]:
        made: list[Callable[[], T]]
        if self.executor is None:
            made = [partial(work, self.problem, *task) for task in tasks]
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
            if same_class(model, path, other.path, pool.problem.clearance):
                chosen[k] = replace(other, count=other.count + 1)
                break
        else:
            chosen.append(FirstPath(path=path, count=1))
    return chosen


def same_class(model: CollisionModel, first: JointPath, second: JointPath, clearance: float = 0.0) -> bool:
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
    kept: list[PathResult] = []
    for result in _best_first(results):
        same = next((k for k, other in enumerate(kept) if _coincide(result.path, other.path)), None)
        if same is None:
            kept.append(result)
        else:
            kept[same] = replace(kept[same], first_paths=kept[same].first_paths + result.first_paths)
    best = replace(kept[0], rivals=tuple(kept[1:]), missing=_missing(kept))
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
        turns.append([2 * np.pi * k for k in options if not _outside(robot, joint, goal[joint] + 2 * np.pi * k)])
    goals = [goal + np.array(shift) for shift in itertools.product(*turns)]
    return [each for each in goals if np.abs(each - start).max() > 1e-9]


def _outside(robot: Robot, joint: int, value: float) -> bool:
    return not robot.limits.lower[joint] <= value <= robot.limits.upper[joint]


def _coincide(first: JointPath | None, second: JointPath | None) -> bool:
    if first is None or second is None:
        return first is second
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


def _solve(problem: PathProblem, first: JointPath, straight: bool, deadline: Deadline) -> PathResult:
    return solve_local(problem, first.start, first.goal, first, straight=straight, deadline=deadline)


def _at_worker(work: Callable[..., T], packed: bytes, task: tuple[object, ...]) -> T:
    """Run in a worker's thread, which unpacks the problem once and keeps it, with what was built for it, for later tasks."""
    if getattr(_own, "packed", None) != packed:
        _own.problem, _own.packed = pickle.loads(packed), packed
    return work(_own.problem, *task)
