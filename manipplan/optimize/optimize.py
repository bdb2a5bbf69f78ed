"""optimize_path: the joint path of minimum g between two configurations, among obstacles."""

from concurrent.futures import Executor
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from manipplan.collision.scene import Scene
from manipplan.cost.metric import metric_matrix
from manipplan.kinematics.kinematics import Kinematics
from manipplan.measures.measure import Measure
from manipplan.measures.names import MEASURES
from manipplan.optimize.basis import EndConditions, named_basis
from manipplan.optimize.homotopy import SolvePool, best_and_rivals, seed_classes, shifted_goals
from manipplan.optimize.problem import PathProblem, check_initial, initial_path, solve_local
from manipplan.optimize.result import PathResult, no_path
from manipplan.paths.joint import JointPath
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.robot import Robot
from manipplan.seeds.ompl import check_apart
from manipplan.support.checks import Array, finite_array, instance, number, random_seed, whole_number
from manipplan.support.errors import InvalidInputError, PlanningError, UnknownNameError
from manipplan.support.interrupts import interruptible
from manipplan.support.progress import Progress, teller
from manipplan.support.status import Status
from manipplan.symbolic.task import Task

#: Maximum degree: a higher one is slower and no better.
MOST_DEGREE = 20
#: Maximum number of coefficients per joint: time and memory of a solve grow with its square.
MOST_COEFFICIENTS = 200
#: Maximum number of first paths per goal.
MOST_SEEDS = 10_000
SHIFTS = ("none", "within-limits")


def optimize_path(
    robot: Robot,
    start: ArrayLike,
    goal: ArrayLike,
    degree: int = 6,
    power: float = 1,
    task: Task | None = None,
    scene: Scene | None = None,
    initial: JointPath | Trajectory | str | Path | None = None,
    shifts: str = "none",
    *,
    basis: str = "legendre",
    pieces: int = 1,
    measure: Measure | str | None = None,
    metric: ArrayLike | None = None,
    start_slope: ArrayLike | None = None,
    goal_slope: ArrayLike | None = None,
    start_bend: ArrayLike | None = None,
    goal_bend: ArrayLike | None = None,
    clearance: float = 0.0,
    seed: int = 0,
    seeds: int = 1,
    time_limit: float = 10.0,
    executor: Executor | None = None,
    compiled: bool | str = "auto",
    throw: bool = True,
    progress: Progress | None = None,
) -> PathResult:
    """Find the path from start to goal of minimum g = ∫ ‖q'‖_W / m^power ds, far from singularities [kth2012, ch. 6].

    The path is a polynomial of `degree`, or pieces of that degree. IPOPT minimises its energy ∫ ‖q'‖_W² / m^(2 power) ds until
    a collision-free path is found, once from the straight line and once from the seed. From there, sequential quadratic
    programming in a trust region [nocedal2006, ch. 18] minimises g itself with the true distances of the scene. Degrees above
    6 and paths of several pieces also start from the optimum of a lower degree. The path with the smallest g is returned; of
    two whose g differ by less than a share of 1e-5, the one found first. The optimum is local.

    Joint limits hold on the whole curve. With a scene, an optimised path is proven collision-free on the whole curve; a seed
    is proven too, or at least checked every milliradian. `certificate` holds the measured figures. Status.OPTIMAL means that
    the first-order conditions hold on the path: the projected gradient of g is at most 1e-3 per rad, relative to g;
    complementarity is at most 1e-5; active clearances are within 0.1 mm of the required one. If one of them does not hold,
    the status is STOPPED_EARLY.

    Args:
        robot: the arm.
        start, goal: (n,) inside the joint limits [rad or m].
        degree: of the polynomial, or of each of its pieces, 1 to 20; 1 in one piece is the straight line.
        power: exponent p of m, above 0 and at most 100.
        task: task whose manipulability counts; default `robot.default_task`.
        scene: obstacles. None: no collision is checked, not even of the arm with itself.
        initial: a first path from start to goal: a JointPath, a Trajectory, or a trajectory file (.csv, .json, .yaml, .npz),
            such as a recorded motion. With a scene it must be collision-free. The descent starts from the fit to it, so
            optimising a result again returns it. Default: the straight line, or with a scene `seed_path`.
        shifts: "within-limits" also tries goals 2π away in each revolute joint, at most 3 to the power of n of them, and
            returns the best path. Their pose is that of the goal. Not together with `initial`.
        basis: basis functions of the path. "legendre", "bernstein", "chebyshev" and "monomial" span the same polynomials and
            have the same optimum; "monomial" only up to about degree 14. "bspline" joins `pieces` with degree - 1 continuous
            derivatives, "composite" with one; both suit paths around many corners.
        pieces: number of pieces, of equal width in s, 1 to 32; more than 1 only with "bspline" and "composite". With
            "composite", pieces times (degree - 1) is at most 200.
        measure: m, a name from `available_measures()` or a Measure that is at least zero and better when larger. Default:
            Yoshikawa's manipulability.
        metric: W in ‖q'‖_W² = q'ᵀ W q': weights (n,) > 0, or a symmetric positive definite matrix (n, n). Default: identity.
        start_slope, goal_slope: q'(0) and q'(1), (n,), with respect to s [rad or m]. Default: free.
        start_bend, goal_bend: q''(0) and q''(1), (n,) [rad or m]. Default: free. Each slope or bend needs one more degree.
        clearance: minimum distance [m] from obstacles and between the arm's own links; needs a scene. An optimised path keeps
            0.05 mm more, so that the proof succeeds.
        seed: random seed of the planner of the first path; without a scene, of the random first paths.
        seeds: number of first paths per goal. With a scene the planner finds them, with `seed`, `seed` + 1 and so on, and of
            those joined by a collision-free straight homotopy only the best is optimised. Without a scene they are the
            straight line and paths through random configurations.
        time_limit: time limit of the planner per first path [s].
        executor: runs first paths and solves in parallel; the result does not depend on it. Default: in turn, in this process.
        compiled: True: objective, clearance rows and measure in machine code. It is compiled in a few seconds, once per robot,
            task, measure and metric, and kept in the user's cache folder. False: CasADi's virtual machine. "auto": machine
            code if there is a compiler, except for measures whose Hessian takes long to compile (singular values, dynamic).
            The path is the same.
        throw: raise PlanningError when no collision-free path is found, or m is zero on it, so that g is infinite. False:
            return the result, whose status or g shows this.
        progress: called with the completed share in [0, 1] and a text.

    Returns:
        The path with the smallest g. Its `rivals` are the results of other homotopy classes and goals. After an interrupt
        (Ctrl-C) the best checked path so far, with Status.INTERRUPTED. KeyboardInterrupt is raised instead during the search
        for first paths, during the final measurement of the path, and with an executor.

    Raises:
        InvalidInputError: an argument is invalid.
        CompilerError: `compiled` is True and there is no compiler, or it fails.
        PlanningError: with `throw`: no collision-free path was found, or every path that was found meets a singularity.
    """
    instance("robot", robot, Robot)
    if scene is not None:
        instance("scene", scene, Scene)
    recorded = None if initial is None else initial_path(robot, initial)
    degree = whole_number("degree", degree, least=1, most=MOST_DEGREE)
    size = named_basis(basis, degree, pieces).size
    if size > MOST_COEFFICIENTS:
        wanted = (
            f"fewer: with degree {degree} the basis {basis!r} has {size} coefficients per joint, of at most {MOST_COEFFICIENTS}"
        )
        raise InvalidInputError("pieces", pieces, wanted)
    power = number("power", power, above=0.0, most=100.0)
    clearance = number("clearance", clearance, least=0.0)
    if clearance > 0 and scene is None:
        raise InvalidInputError(
            "clearance", clearance, "0 without a scene, since nothing is checked then; scene=Scene() checks for self-collision"
        )
    if shifts not in SHIFTS:
        raise UnknownNameError("shifts", str(shifts), SHIFTS)
    if shifts != "none" and initial is not None:
        raise InvalidInputError("shifts", shifts, "'none' together with an initial path")
    seed, seeds = random_seed("seed", seed), whole_number("seeds", seeds, least=1, most=MOST_SEEDS)
    if seeds > 1 and initial is not None:
        raise InvalidInputError("seeds", seeds, "1 together with an initial path")
    time_limit = number("time_limit", time_limit, above=0.0)
    if executor is not None:
        instance("executor", executor, Executor)
    tell = teller(progress)
    q_start, q_goal = robot.configuration("start", start), robot.configuration("goal", goal)
    kinematics = robot.kinematics(task, measure=measure, compiled=compiled)
    check_task(kinematics)
    check_measure(kinematics)
    problem = PathProblem(
        given=recorded is not None,
        robot=robot,
        scene=scene,
        task=kinematics.task,
        measure=kinematics.measure,
        power=power,
        metric=metric_matrix("metric", metric, robot.n),
        basis=basis,
        degree=degree,
        pieces=int(pieces),
        clearance=clearance,
        time_limit=time_limit,
        ends=EndConditions(
            start_slope=_derivative("start_slope", start_slope, robot.n),
            goal_slope=_derivative("goal_slope", goal_slope, robot.n),
            start_bend=_derivative("start_bend", start_bend, robot.n),
            goal_bend=_derivative("goal_bend", goal_bend, robot.n),
        ),
        compiled=compiled,
    )
    goals = [q_goal] if shifts == "none" else shifted_goals(robot, q_start, q_goal)
    if scene is not None:
        tell(0.0, "preparing collision shapes")
    model = problem.model()
    if model is not None:
        model.free_configuration("start", q_start, clearance)
        model.free_configuration("goal", q_goal, clearance)
    for each in goals:
        check_apart(q_start, each)
    numbers = [seed if scene is not None else 0, *(seed + k for k in range(1, seeds))]  # without a scene, seed 0 is the line
    problem.ends.check_degree(lambda k: named_basis(basis, k, pieces), degree)
    pool = SolvePool(problem=problem, executor=executor, tell=tell)
    if recorded is not None:
        check_initial(problem, recorded, q_start, q_goal)
        firsts = [recorded]
    else:
        try:
            with interruptible():
                firsts = seed_classes(pool, q_start, goals, numbers)
        except PlanningError as error:
            failed = no_path(problem.objective())
            if throw:
                raise PlanningError(str(error), failed) from error
            return failed
    best = best_and_rivals(pool.solve_local(firsts))
    tell(1.0, "optimised")
    if throw and not np.isfinite(best.g) and best.status is not Status.INTERRUPTED:
        raise PlanningError(f"the manipulability is zero on the path at s = {best.min_at:.3f}, so g is infinite", best)
    return best


def optimize_from(
    robot: Robot,
    first: JointPath,
    *,
    scene: Scene | None,
    degree: int,
    basis: str,
    pieces: int,
    power: float,
    task: Task | None,
    measure: Measure | str | None,
    metric: ArrayLike | None,
    clearance: float,
) -> PathResult:
    """As `optimize_path`, with a first path known to be collision-free and no start from the optimum of a lower degree."""
    kinematics = robot.kinematics(task, measure=measure)
    problem = PathProblem(
        robot=robot,
        scene=scene,
        task=kinematics.task,
        measure=kinematics.measure,
        power=power,
        metric=metric_matrix("metric", metric, robot.n),
        basis=basis,
        degree=degree,
        pieces=pieces,
        clearance=clearance,
        time_limit=np.inf,
        given=True,
        climbs=False,
    )
    return solve_local(problem, first.start, first.goal, first)


def check_task(kinematics: Kinematics) -> None:
    """Raise InvalidInputError when the task has more rows than the arm has joints."""
    task, n = kinematics.task, kinematics.robot.n
    if task.rows > n:
        raise InvalidInputError(
            "task", task.name, f"at most {n} rows; with more rows than joints the manipulability is identically zero"
        )


def check_measure(kinematics: Kinematics) -> None:
    """Raise InvalidInputError for a measure that can be negative, or is better when smaller."""
    measure = kinematics.measure
    if not measure.grows:
        usable = [name for name, kind in MEASURES.items() if kind.grows]
        wanted = f"a measure that is at least zero and better when larger: {', '.join(usable)}, or a custom one"
        raise InvalidInputError("measure", measure.name, wanted)
    measure.check(kinematics.task.rows, kinematics.robot.n)


def _derivative(argument: str, value: ArrayLike | None, n: int) -> Array | None:
    return None if value is None else finite_array(argument, value, (n,))
