"""optimize_path: the joint path of minimum g between two configurations, among obstacles."""

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import replace
from typing import Literal, overload

import numpy as np

from manipplan.collision.scene import Scene
from manipplan.constraints.constraint import Constraint, constraint_tuple
from manipplan.constraints.constraint_set import check_ends
from manipplan.cost.objective import PathObjective, idle_hint
from manipplan.optimize.homotopy import FirstPath, SolvePool, best_and_rivals, seed_classes, shift_goals
from manipplan.optimize.problem import PathProblem, check_initial, initial_path, solve_local
from manipplan.optimize.result import NoPath, PathResult
from manipplan.paths.basis import PathShape
from manipplan.paths.joint import JointPath
from manipplan.robots.robot import Robot
from manipplan.seeds.seed import check_apart
from manipplan.seeds.seeding import Seeding
from manipplan.support.checks import ArrayLike, flag, instance, number
from manipplan.support.deadline import Deadline
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.support.progress import Progress, as_callback, interruptible
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
    """Find the path from start to goal of minimum g, far from singularities [kth2012, ch. 6].

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
            code if there is a compiler, except for measures whose Hessian takes long to compile (singular values, dynamic).
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
    return solve_local(problem, first.start, first.goal, first, deadline=deadline)


def check_options(objective: PathObjective, shape: PathShape, seeding: Seeding) -> None:
    """Raise InvalidInputError for options of another type."""
    instance("objective", objective, PathObjective)
    instance("shape", shape, PathShape)
    instance("seeding", seeding, Seeding)
