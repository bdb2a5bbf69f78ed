"""optimize_path: the polynomial joint path of least g between two configurations, among obstacles."""

import itertools
import logging
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from manipplan.checks import Array, instance, number, whole_number
from manipplan.errors import InvalidInputError, PlanningError, UnknownNameError
from manipplan.interrupts import interruptible
from manipplan.kinematics.kinematics import Kinematics
from manipplan.measures.task import Task
from manipplan.optimize import clearance as near
from manipplan.optimize.objective import PathCost, constant_speed, path_cost
from manipplan.optimize.problem import ClearanceRow, PathProgram
from manipplan.paths.joint import JointPath
from manipplan.robots.collision import CollisionModel
from manipplan.robots.robot import Robot
from manipplan.robots.scene import Scene
from manipplan.seeds.ompl import CHECK_STEP, check_apart, seed_path
from manipplan.status import Status

log = logging.getLogger("manipplan")

#: Rounds of solving and renewing clearance rows, from one first path.
ROUNDS = 8
#: Rounds end when one lowers g by less than this share.
SMALL_GAIN = 1e-2
#: Clearance rows are added at so many places a round, the deepest dips first.
NEW_PLACES = 10
#: More rows than this take longer than they are worth: the search ends with what it has.
MOST_ROWS = 500
SHIFTS = ("none", "within-limits")


@dataclass(frozen=True, kw_only=True)
class Step:
    """One solve of the optimiser: from which first path, its g, its clearance [m] and IPOPT's word."""

    first: str
    g: float
    clearance: float
    solver: str


@dataclass(frozen=True, kw_only=True)
class PathResult:
    """What `optimize_path` found.

    Attributes:
        path: the JointPath; the seed when `status` says so, None when there is none (NO_PATH, with throw=False).
        g: ∫ ‖q'‖ / m^power ds on a fine rule: (6.6) in kth2012 with its exponent as a parameter.
        length: of the path in joint space [rad].
        min_manipulability: least index on a dense grid [task.unit], and `min_at`, the s where it is.
        power, task: the objective's exponent and the task whose index it holds.
        seed, seed_cost: the collision-free first path (straight without a scene) and its cost, for comparison.
        history: every solve, in order.
        status: Status.
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


@dataclass(frozen=True, kw_only=True)
class _Candidate:
    path: JointPath
    cost: PathCost
    converged: bool


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
    clearance: float = 0.0,
    seed: int = 0,
    throw: bool = True,
) -> PathResult:
    """Find a path of `degree` from start to goal of low g = ∫ ‖q'‖ / m^power ds [kth2012, ch. 6].

    The energy ∫ ‖q'‖² / m^(2 power) ds is minimised by IPOPT with exact Hessians, from the straight line and from the
    seed; over all curves it has the minima of g. g itself is reported on a finer rule. Joint limits hold on the whole
    curve. With a scene, the path is free at every milliradian: either optimised, or the seed.

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
    kinematics = robot.kinematics(task)
    check_task(kinematics)
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
            failed = _no_path(kinematics.task, power)
            if throw:
                raise PlanningError(str(error), failed) from error
            return failed
        results.append(_optimize(kinematics, q_start, each, degree, power, first, model, clearance))
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


def _no_path(task: Task, power: float) -> PathResult:
    nothing = PathCost(g=np.inf, length=np.inf, min_manipulability=0.0, at=0.0)
    return PathResult(
        path=None,
        g=np.inf,
        length=np.inf,
        min_manipulability=0.0,
        min_at=0.0,
        power=power,
        task=task,
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
    kinematics: Kinematics,
    start: Array,
    goal: Array,
    degree: int,
    power: float,
    first: JointPath,
    model: CollisionModel | None,
    clearance: float,
) -> PathResult:
    first_cost = path_cost(first, kinematics, power)
    history: list[Step] = []
    found: list[_Candidate] = []
    is_line = len(first.control) == 1 and first.degree == 1
    if degree == 1:
        line = first if is_line else JointPath.line(start, goal)
        if is_line or model is None or model.path_is_free(line, CHECK_STEP, clearance):
            found.append(_Candidate(path=line, cost=path_cost(line, kinematics, power), converged=True))
    else:
        program = _program(kinematics, power, degree)
        search = _Search(program=program, start=start, goal=goal, model=model, clearance=clearance, history=history)
        found += search.unconstrained()
        if not (found and is_line):  # from a straight seed the same solve would come again
            found += search.from_safe_path(first)
    safe = model is None or bool(found)
    best = min(found, key=lambda candidate: candidate.cost.g, default=None)
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
        power=power,
        task=kinematics.task,
        seed=first,
        seed_cost=first_cost,
        history=tuple(history),
        status=status,
    )


@dataclass(frozen=True, kw_only=True)
class _Search:
    """Solves of one program between one start and goal; what it returns is inside the limits and free."""

    program: PathProgram
    start: Array
    goal: Array
    model: CollisionModel | None
    clearance: float
    history: list[Step]

    def unconstrained(self) -> list[_Candidate]:
        """The optimum as if nothing were in the way, from the straight line; used when it is free."""
        guess = np.zeros((self.program.n, self.program.degree - 1))
        candidate, _, _ = self._solve("straight", guess, [])
        return [candidate] if candidate else []

    def from_safe_path(self, first: JointPath) -> list[_Candidate]:
        """From the fit to a free path: solve, look where the result comes near something, renew rows there, repeat."""
        s = constant_speed(first, self.program.kinematics, self.program.power, near.PLACES + 1)
        even = np.linspace(0.0, 1.0, len(s))
        places: list[near.Place] = []
        if self.model is not None:
            places = near.dips(near.distance_profile(self.model, first(s)), self.clearance + near.NEAR)
        coefficients = self.program.fit(first, s)
        found: list[_Candidate] = []
        for _ in range(ROUNDS):
            rows: list[ClearanceRow] = []
            if self.model is not None:
                path = self.program.path(self.start, self.goal, coefficients)
                rows = near.rows_for(self.model, path, lambda at: first(np.interp(at, even, s)), places, self.clearance)
            if len(rows) > MOST_ROWS:
                break
            candidate, coefficients, distances = self._solve("seed", coefficients, rows)
            if candidate is not None:
                found.append(candidate)
                if len(found) > 1 and found[-2].cost.g - candidate.cost.g < SMALL_GAIN * candidate.cost.g:
                    break
            if candidate is not None and not places:
                break
            more = near.merged(places, near.around(near.dips(distances, self.clearance)[:NEW_PLACES]))
            if candidate is None and len(more) == len(places):  # it touches something between the places looked at
                more = near.merged(places, near.around(near.dips(distances, self.clearance + near.SPARE)[:NEW_PLACES]))
            places = more
        return found

    @interruptible()
    def _solve(self, name: str, guess: Array, rows: list[ClearanceRow]) -> tuple[_Candidate | None, Array, Array]:
        """The candidate when the solution is inside the limits and free, its coefficients, and its distance profile."""
        solution = self.program.solve(self.start, self.goal, guess, rows)
        path = self.program.path(self.start, self.goal, solution.coefficients)
        cost = path_cost(path, self.program.kinematics, self.program.power)
        distances = np.full((near.PLACES + 1, 1), np.inf)
        if self.model is not None:
            distances = near.distance_profile(self.model, path(np.linspace(0.0, 1.0, near.PLACES + 1)))
        least = float(distances.min(initial=np.inf))
        self.history.append(Step(first=name, g=cost.g, clearance=least, solver=solution.status))
        free = self.model is None or (least > self.clearance and self.model.path_is_free(path, CHECK_STEP, self.clearance))
        if not (free and _inside_limits(self.program.kinematics.robot, path)):
            return None, solution.coefficients, distances
        converged = solution.status == "Solve_Succeeded"
        return _Candidate(path=path, cost=cost, converged=converged), solution.coefficients, distances


def _inside_limits(robot: Robot, path: JointPath) -> bool:
    low, high = path.bounds()
    return not (robot.limits.outside(low) > 1e-7).any() and not (robot.limits.outside(high) > 1e-7).any()


def _program(kinematics: Kinematics, power: float, degree: int) -> PathProgram:
    cache = kinematics.robot.cache
    key = ("path program", kinematics.task, power, degree)
    if key not in cache:
        cache[key] = PathProgram(kinematics, power, degree)
    program: PathProgram = cache[key]
    return program
