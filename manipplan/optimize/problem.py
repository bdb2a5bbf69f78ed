"""PathProblem: all arguments of the optimiser, and the best of the local optima near a first path."""

import logging
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

import numpy as np

from manipplan.collision.coarse import coarse_scene, without_pieces_at
from manipplan.collision.model import CollisionModel
from manipplan.collision.path_clearance import path_clearance
from manipplan.collision.scene import Scene
from manipplan.constraints.constraint import Constraint
from manipplan.constraints.constraint_set import ConstraintSet, figures, prove
from manipplan.cost.crossings import find_crossings, is_singular, least_crossings
from manipplan.cost.integral import ACCURACY, PathIntegral
from manipplan.cost.objective import PathObjective
from manipplan.optimize.descent import Ending
from manipplan.optimize.local import INSIDE, Candidate, LocalSearch, Until
from manipplan.optimize.program import PathProgram
from manipplan.optimize.result import PathResult, Step, make_result
from manipplan.paths.basis import EndConditions, PathShape, find_basis
from manipplan.paths.joint import JointPath
from manipplan.paths.trajectory import Trajectory, read_trajectory, unwrapped
from manipplan.robots.robot import Robot
from manipplan.seeds.seed import seed_path
from manipplan.seeds.seeding import MOST_SEEDS, OPTIMISING, Seeding, random_path
from manipplan.seeds.task import CHECK_STEP, PROVABLE
from manipplan.support.checks import Array
from manipplan.support.deadline import NEVER, Deadline, OutOfTimeError
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.support.memo import once_per_owner
from manipplan.support.progress import interruptible
from manipplan.support.status import Status
from manipplan.support.workers import one_thread

log = logging.getLogger("manipplan")

#: Share of the time limit that planners get which go on to lower the cost of their path.
OPTIMISING_SHARE = 0.5
#: Shortest time limit of a search, where hardly any time is left [s].
SHORTEST_SEARCH = 1e-3
#: Degrees above WARM_START_DEGREE also start from the optimum of that degree, or of the next lower multiple of STRIDE.
WARM_START_DEGREE, STRIDE = 6, 3
#: A later local optimum is preferred to an earlier one when its g is lower by more than this share.
TIE = 1e-5
#: A confirmed optimum is returned instead of the first path if its g is not above that one's by more than this share, which
#: covers where descents end; another path if it is not above by more than the accuracy of g.
CONFIRMED_TIE = 1e-6
#: Maximum number of further first paths without obstacles, where the best path crosses singularities more often than it must.
MORE_PATHS = 3


@dataclass(frozen=True, kw_only=True, eq=False)
class PathProblem:
    """All arguments of the optimiser except start and goal; it can be pickled and sent to another process.

    Attributes:
        robot, scene: the arm and its obstacles; None: nothing is checked for collision.
        objective: what is minimised, with the task, measure and metric of this robot.
        shape: the curves that are searched.
        seeding: how first paths are found; without `initial`.
        clearance: required distance [m].
        compiled: as in `Robot.kinematics`.
        given: the caller gave the first path, so the search also descends from it as it is.
        climbs: also start from the optimum of a lower degree, and where nothing is found search once more with more patience.
        compares: also find g of the nearby optimum without limits and obstacles.
        constraints: what is kept beside limits and clearance; needs a scene.
    """

    robot: Robot
    scene: Scene | None
    objective: PathObjective
    shape: PathShape
    seeding: Seeding
    clearance: float
    compiled: bool | str = "auto"
    given: bool = False
    climbs: bool = True
    compares: bool = False
    constraints: tuple[Constraint, ...] = ()

    def integral(self) -> PathIntegral:
        """The objective as an integral along paths of this process's robot."""
        return self.objective.integral(self.robot, compiled=self.compiled)

    @cached_property
    def ends(self) -> EndConditions:
        """The fixed derivatives at start and goal."""
        return self.shape.ends(self.robot.n)

    @cached_property
    def constraint_set(self) -> ConstraintSet | None:
        """The constraints for this robot; None without any."""
        return ConstraintSet.of(self.robot, self.constraints) if self.constraints else None

    def model(self) -> CollisionModel | None:
        """The collision model; None without a scene."""
        return None if self.scene is None else self.scene.collision_model(self.robot)

    def coarse(self) -> "PathProblem | None":
        """The same problem in the coarse copy of the scene; None where there is none."""
        scene = None if self.scene is None else coarse_scene(self.scene, self.robot)
        return None if scene is None else replace(self, scene=scene, given=False)

    def lower(self) -> "PathProblem | None":
        """The same problem in polynomials of a lower degree, whose optimum is a start for this one; None for low degrees."""
        if self.shape.pieces > 1:
            degree = WARM_START_DEGREE
        elif self.shape.degree > WARM_START_DEGREE:
            degree = max(WARM_START_DEGREE, STRIDE * ((self.shape.degree - 1) // STRIDE))
        else:
            return None
        if not self.climbs or not self.ends.possible(find_basis("legendre", degree)):
            return None
        basis = self.shape.basis if self.shape.pieces == 1 else "legendre"
        return replace(self, shape=replace(self.shape, basis=basis, degree=degree, pieces=1), compares=False)


@one_thread()
def solve_local(problem: PathProblem, first: JointPath, *, straight: bool = True, deadline: Deadline = NEVER) -> PathResult:
    """The best path near `first`, which is free and inside the limits, and with `straight` also near the straight line.

    After the deadline it is the best one that was found by then.
    """
    integral, model, clearance = problem.integral(), problem.model(), problem.clearance
    first_cost = integral.cost(first)
    history: list[Step] = []
    program = _program(problem, integral)
    search = LocalSearch(
        program=program,
        start=first.start,
        goal=first.goal,
        model=model,
        clearance=clearance,
        history=history,
        ends=problem.ends,
        repaces=problem.lower() is None,
        deadline=deadline,
        constraints=problem.constraint_set,
    )
    is_free = bool(program.free.size)
    interrupted = late = False
    try:
        with interruptible():
            found = _local_optima(problem, search, first, straight) if is_free else search.single_path()
            best = _best(found)
    except KeyboardInterrupt:
        interrupted = True
        best = _best(search.accepted)
    except OutOfTimeError:
        late = True
        best = _best(search.accepted)
    safe = model is None or best is not None
    fallback = problem.ends.met_by(first)
    same = CONFIRMED_TIE if best is not None and best.optimality.reached else ACCURACY
    if best is not None and (best.cost.g <= first_cost.g * (1 + same) or not fallback):
        path, cost = best.path, best.cost
        reached = Status.SHORTEST if integral.kinematics.measure.constant else Status.OPTIMAL
        unfinished = Status.OUT_OF_TIME if late else Status.STOPPED_EARLY
        status = reached if best.optimality.reached else unfinished
    else:
        path, cost = first, first_cost
        status = Status.SEED_OUT_OF_TIME if late else Status.SEED_IS_BETTER if safe else Status.SEED_IS_SAFE
        status = status if fallback else Status.ENDS_NOT_MET
    if status is not Status.ENDS_NOT_MET and is_singular(path, integral, cost):
        status = Status.SINGULAR
    unconstrained = np.nan
    if problem.compares and np.isfinite(cost.g) and not (interrupted or late):
        try:
            with interruptible():
                unconstrained = search.unconstrained_g(path)
        except KeyboardInterrupt:
            interrupted = True
    if interrupted:
        status = Status.INTERRUPTED
    log.info("optimize_path: g %.4g, seed %.4g, %d solves: %s", cost.g, first_cost.g, len(history), status.name)
    solvers = [best.solver] if best is not None and path is best.path and is_free else []
    solver = "; ".join(dict.fromkeys([*solvers, *([Ending.LATE.value] if late else [])]))
    return make_result(
        path,
        integral,
        cost=cost,
        seed=first,
        seed_cost=first_cost,
        model=model,
        clearance=clearance,
        status=status,
        solver=solver,
        optimality=best.optimality if best is not None and path is best.path else None,
        unconstrained_g=unconstrained,
        history=tuple(history),
        constraints=problem.constraint_set,
    )


def _local_optima(problem: PathProblem, search: LocalSearch, first: JointPath, straight: bool) -> list[Candidate]:
    """The local optima reached from several first paths, in this order.

    Among many small obstacles they are those near the optimum of a coarse problem instead.

    1. The straight line, with `straight` or where `first` is straight.
    2. The path `first`. For a given path, or with several pieces, the descent starts at the path itself. Otherwise, or if that
       gives no collision-free path, it starts at a path of low energy near it. Where nothing gave one, descents from the
       straight line and from the fit to the path are repeated with more patience.
    3. The optimum of a lower degree.
    4. Without obstacles, while the best path crosses singularities more often than the lower bound: paths through random
       configurations.
    """
    if (coarse := problem.coarse()) is not None:
        return _optima_among_many(problem, coarse, search, first, straight)
    is_line = len(first.control) == 1 and first.degree == 1
    found = search.from_straight_line() if straight or is_line else []
    if not (found and is_line):  # a straight first path would repeat the same solve
        at_first = problem.given or problem.shape.pieces > 1
        nearby = (search.nearest_to(first) if at_first else []) or search.from_safe_path(first)
        found += nearby
        if not found and problem.climbs:
            patient = replace(search, patient=True)
            found = patient.from_straight_line() or patient.nearest_to(first)
    lower = problem.lower() if search.until is Until.SETTLED else None
    if lower is not None:
        result = solve_local(lower, first, straight=straight, deadline=search.deadline)
        search.history.extend(result.history)
        if result.status.ok:
            found += search.embedded(result.path)
    if problem.scene is None and is_line and search.repaces:
        found += _with_fewer_crossings(problem, search, found)
    return found


def _with_fewer_crossings(problem: PathProblem, search: LocalSearch, found: Sequence[Candidate]) -> list[Candidate]:
    """Optima reached from paths through random configurations, until one crosses singularities as few times as possible."""
    least = least_crossings(search.program.kinematics, search.start, search.goal)
    if least is None:
        return []
    more: list[Candidate] = []
    for k in range(MORE_PATHS):
        best = _best([*found, *more])
        if best is None:
            break
        crossings = find_crossings(best.path, search.program.integral, best.cost)
        if sum(not each.at_end for each in crossings) <= least:
            break
        more += search.from_safe_path(random_path(problem.robot, search.start, search.goal, MOST_SEEDS + k))
    return more


def _optima_among_many(
    problem: PathProblem, coarse: PathProblem, search: LocalSearch, first: JointPath, straight: bool
) -> list[Candidate]:
    """The local optima near a given path, and near the optimum of the coarse problem.

    Without a given path and such an optimum, the one near `first`.
    """
    found = search.nearest_to(first) if problem.given else []
    near = replace(search, until=Until.OPTIMAL)
    optimum = _coarse_optimum(coarse, search, first, straight and not problem.given)
    if optimum is not None:
        found += near.from_optimum(optimum)
    if not found and not problem.given:
        found = near.nearest_to(first)
    return found


def _coarse_optimum(coarse: PathProblem, search: LocalSearch, first: JointPath, straight: bool) -> Candidate | None:
    """The best path of the coarse problem, without the pieces that start or goal touches; None where none is found.

    With `straight` a path is planned among the pieces where `first` touches them.
    """
    assert coarse.scene is not None
    ends = np.array([search.start, search.goal])
    coarse = replace(coarse, scene=without_pieces_at(coarse.scene, coarse.robot, ends, coarse.clearance + PROVABLE))
    brief = replace(search, model=coarse.model(), known=[], accepted=[], history=[], repaces=False, until=Until.PROVEN)
    if not brief.keeps(first):
        if not straight:
            return None
        try:
            first = plan_first_path(coarse, search.start, search.goal, coarse.seeding.seed, search.deadline)
        except PlanningError as error:
            log.info("among the pieces of the coarse scene: %s", error)
            return None
    optimum = _best(_local_optima(coarse, brief, first, straight))
    search.history.extend(replace(step, first=f"coarse {step.first}") for step in brief.history)
    return optimum


def plan_first_path(problem: PathProblem, start: Array, goal: Array, seed: int, deadline: Deadline = NEVER) -> JointPath:
    """A free first path of the planner with few singularities on it; raises PlanningError without any."""
    share = OPTIMISING_SHARE if problem.seeding.planner in OPTIMISING else 1.0  # they use up what they get
    limit = max(share * min(problem.seeding.time_limit, deadline.left), SHORTEST_SEARCH)
    return seed_path(
        problem.robot,
        start,
        goal,
        problem.scene,
        seeding=replace(problem.seeding, seed=seed, count=1, shifts="none", time_limit=limit),
        objective=problem.objective,
        fewest_crossings=True,
        clearance=problem.clearance,
        constraints=problem.constraints,
    )


def _best(found: Sequence[Candidate]) -> Candidate | None:
    """The candidate with the smallest g; of two that tie the earlier one, so that rounding does not decide."""
    best: Candidate | None = None
    for each in found:
        if best is None or each.cost.g < best.cost.g * (1 - TIE):
            best = each
    return best


def _program(problem: PathProblem, integral: PathIntegral) -> PathProgram:
    """The program of a problem, built once per robot, objective, basis and pattern of fixed derivatives."""
    kinematics, fixed, shape = integral.kinematics, problem.ends.pattern, problem.shape
    basis = (shape.basis, shape.degree, shape.pieces)
    metric = None if integral.metric is None else integral.metric.tobytes()
    key = (kinematics.task, kinematics.measure, kinematics.compiled, integral.power, integral.floor, metric, basis, fixed)
    programs = _programs(kinematics.robot)
    if key not in programs:
        programs[key] = PathProgram(integral, find_basis(*basis), fixed)
    return programs[key]


@once_per_owner
def _programs(_robot: Robot) -> dict[tuple[object, ...], PathProgram]:
    """The programs built for a robot so far."""
    return {}


def initial_path(robot: Robot, initial: JointPath | Trajectory | str | Path) -> JointPath:
    """A first path of any accepted type as a JointPath of this robot's joints."""
    if isinstance(initial, JointPath):
        path = initial
    else:
        motion = initial if isinstance(initial, Trajectory) else read_trajectory("initial", initial)
        if motion.joint_names != robot.joint_names:
            wanted = f"a motion of the joints {', '.join(robot.joint_names)}"
            raise InvalidInputError("initial", f"one of {', '.join(motion.joint_names)}", wanted)
        path = unwrapped(
            robot, motion, lambda row, joint: (f"initial.q[{row}, {joint}]", motion.q[row, joint]), fastest=1
        ).path()
    if path.n != robot.n:
        raise InvalidInputError("initial", f"a path of {path.n} joints", f"a path of the {robot.n} joints of {robot.name}")
    return path


def check_initial(problem: PathProblem, initial: JointPath, start: Array, goal: Array) -> None:
    """Raise InvalidInputError unless the first path goes from start to goal, inside the limits and collision-free."""
    robot, model = problem.robot, problem.model()
    for name, q, end in (("start", start, initial.start), ("goal", goal, initial.goal)):
        off = np.abs(end - q)
        if off.max() > 1e-9:
            got = f"a path whose {name} is {off.max():.3g} off at {robot.joint_names[int(off.argmax())]}"
            raise InvalidInputError("initial", got, "a path from start to goal")
    low, high = initial.bounds()
    for q in (low, high):
        robot.configuration("initial", q, tolerance=INSIDE)
    if model is None:
        return
    if problem.constraint_set is not None:
        constraint_proof = prove(problem.constraint_set, initial)
        if not constraint_proof.kept:
            worst = min(figures(problem.constraint_set, constraint_proof), key=lambda each: each.least)
            raise InvalidInputError(
                "initial", f"a path with {worst} at s = {worst.at:.4f}", "a path that keeps the constraints"
            )
    proof = path_clearance(model, initial, clearance=problem.clearance, tolerance=None)
    if proof.refuted:
        first, second = proof.pair
        apart = f"{proof.upper:.4g} m apart" if proof.upper > 0 else f"overlapping by {-proof.upper:.4g} m"
        wanted = f"free with a clearance of {problem.clearance:g} m"
        raise InvalidInputError(
            "initial", f"a path with {first} and {second} {apart} at s = {proof.at:.4f}", f"a path {wanted}"
        )
    if not (proof.proven or model.path_is_free(initial, CHECK_STEP, problem.clearance)):
        raise InvalidInputError("initial", "a path in collision", "a path that is free with the required clearance")
