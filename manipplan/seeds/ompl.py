"""Seed paths among obstacles by OMPL: found, simplified, rounded, and proven to be free.

OMPL is used for feasibility: its own check of a motion is coarse, so what it returns is only believed after the whole curve
was proven free, or, where it comes too near to something for that, checked at every milliradian.
"""

import logging
import threading
import time
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from manipplan.checks import Array, instance, number, whole_number
from manipplan.errors import InvalidInputError, PlanningError, UnknownNameError
from manipplan.paths.joint import SHORTEST, JointPath
from manipplan.paths.smooth import rounded
from manipplan.robots.collision import CollisionModel
from manipplan.robots.continuous import path_clearance
from manipplan.robots.robot import Robot
from manipplan.robots.scene import Scene

log = logging.getLogger("manipplan")

PLANNERS = ("RRTConnect", "RRTstar", "BITstar", "InformedRRTstar", "PRM", "KPIECE1")
#: No joint moves more than this between two checks of a finished path [rad or m].
CHECK_STEP = 1e-3
#: With an end nearer to something than this beyond the clearance [m] no proof is tried: its own tolerances take as much.
PROVABLE = 1e-4
#: OMPL's own motion checks, tried in turn until the fine check agrees [rad or m].
MOTION_STEPS = (0.02, 0.008, 0.003)
#: OMPL's random numbers come from one seed a process, so that searches of several threads would not repeat.
_ONE_AT_A_TIME = threading.Lock()


def seed_path(
    robot: Robot,
    start: ArrayLike,
    goal: ArrayLike,
    scene: Scene | None = None,
    planner: str = "RRTConnect",
    seed: int = 0,
    *,
    clearance: float = 0.0,
    time_limit: float = 10.0,
) -> JointPath:
    """A collision-free path from start to goal: straight when that is free, else planned, simplified and rounded.

    Args:
        robot: the arm.
        start, goal: (n,) [rad or m].
        scene: obstacles; None: the arm is only checked against itself.
        planner: one of PLANNERS.
        seed: the same seed gives the same path, as long as `time_limit` is not what ends the search.
        clearance: distance [m] to keep from every obstacle and between the arm's own links.
        time_limit: for the search [s].

    Returns:
        A JointPath that is proven free on the whole curve; where none was found that can be, such as from a start that nearly
        touches something, one that is free at every milliradian. `scene.path_clearance` tells.

    Raises:
        InvalidInputError: start or goal of wrong length, outside the limits, or in collision.
        PlanningError: no free path was found in time.
    """
    if planner not in PLANNERS:
        raise UnknownNameError("planner", str(planner), PLANNERS)
    seed = whole_number("seed", seed, least=0)
    clearance = number("clearance", clearance, least=0.0)
    time_limit = number("time_limit", time_limit, above=0.0)
    scene = instance("scene", scene if scene is not None else Scene(), Scene)
    model = scene.collision_model(robot)
    q_start = model.free_configuration("start", start, clearance)
    q_goal = model.free_configuration("goal", goal, clearance)
    check_apart(q_start, q_goal)
    line = JointPath.line(q_start, q_goal)
    accept = _acceptance(model, (q_start, q_goal), clearance)
    if accept(line):
        return line
    checked = None
    began = time.monotonic()
    for step in MOTION_STEPS:
        left = time_limit - (time.monotonic() - began)
        waypoints = _search(model, q_start, q_goal, planner, seed, clearance, left, step) if left > 0 else None
        if waypoints is None:
            break
        waypoints = _shortened(waypoints, accept)
        sharp = JointPath.through(waypoints)
        if accept(sharp):
            smooth = rounded(waypoints, accept)
            return smooth if accept(smooth) else sharp
        if checked is None and _is_free(model, sharp, clearance):
            checked = sharp
        log.info("the simplified path is not proven free with OMPL's checks %g rad apart; checking finer", step)
    if checked is not None:
        log.info("no path was proven free in time: this one is free at every milliradian")
        return checked
    raise PlanningError(
        f"no path from start to goal was found by {planner} in {time_limit:g} s; "
        "allow more time (time_limit), less clearance, or check that the goal can be reached"
    )


def _acceptance(model: CollisionModel, ends: tuple[Array, Array], clearance: float) -> Callable[[JointPath], bool]:
    """What a seed has to be: proven free; free at every milliradian where an end is so near to something that none can be."""
    for q in ends:
        if model.distances(q).min(initial=np.inf) <= clearance + PROVABLE:
            log.info("start or goal is too near to something for a proof: the seed is checked at every milliradian")
            return lambda path: _is_free(model, path, clearance)
    return lambda path: path_clearance(model, path, clearance=clearance, tolerance=None).proven


def _is_free(model: CollisionModel, path: JointPath, clearance: float) -> bool:
    """Whether the path is free at every milliradian, and was not met touching something in between."""
    return (
        model.path_is_free(path, CHECK_STEP, clearance)
        and not path_clearance(model, path, clearance=clearance, tolerance=None).refuted
    )


def check_apart(start: Array, goal: Array) -> None:
    """Raise InvalidInputError when there is no way to go between start and goal."""
    if np.abs(goal - start).max() < SHORTEST:
        raise InvalidInputError("goal", goal.tolist(), f"a configuration that differs from start by {SHORTEST:g} or more")


def _search(
    model: CollisionModel, start: Array, goal: Array, planner: str, seed: int, clearance: float, time_limit: float, step: float
) -> Array | None:
    """Waypoints (k, n) of OMPL's simplified path, or None when none was found."""
    with _ONE_AT_A_TIME:
        return _search_alone(model, start, goal, planner, seed, clearance, time_limit, step)


def _search_alone(
    model: CollisionModel, start: Array, goal: Array, planner: str, seed: int, clearance: float, time_limit: float, step: float
) -> Array | None:
    from ompl import base, geometric, util

    util.setLogLevel(util.LogLevel.LOG_NONE)
    util.RNG.setSeed(seed + 1)  # 0 would mean a random seed
    n = model.robot.n
    space = base.RealVectorStateSpace(n)
    bounds = base.RealVectorBounds(n)
    limits = model.robot.limits
    # a continuous joint is searched within a turn around start and goal
    low = np.where(np.isfinite(limits.lower), limits.lower, np.minimum(start, goal) - np.pi)
    high = np.where(np.isfinite(limits.upper), limits.upper, np.maximum(start, goal) + np.pi)
    for joint in range(n):
        bounds.setLow(joint, float(low[joint]))
        bounds.setHigh(joint, float(high[joint]))
    space.setBounds(bounds)
    information = base.SpaceInformation(space)
    information.setStateValidityChecker(lambda state: not model.in_collision(np.array(state[0:n]), clearance=clearance))
    information.setStateValidityCheckingResolution(step / float(space.getMaximumExtent()))
    information.setup()
    problem = base.ProblemDefinition(information)
    problem.setStartAndGoalStates(_state(space, start), _state(space, goal), 1e-9)
    solver = getattr(geometric, planner)(information)
    solver.setProblemDefinition(problem)
    solver.setup()
    solver.solve(time_limit)
    if not problem.hasExactSolution():
        return None
    path = problem.getSolutionPath()
    simplifier = geometric.PathSimplifier(information)
    simplifier.reduceVertices(path)
    simplifier.partialShortcutPath(path)
    simplifier.collapseCloseVertices(path)
    points = np.array([path.getState(i)[0:n] for i in range(path.getStateCount())])
    points[0], points[-1] = start, goal
    return np.asarray(points)


def _state(space: object, q: Array) -> object:
    state = space.allocState()  # type: ignore[attr-defined]  # ompl has no stubs
    state[0 : len(q)] = [float(x) for x in q]
    return state


def _shortened(waypoints: Array, accept: Callable[[JointPath], bool]) -> Array:
    """The waypoints without those that an accepted straight motion can skip, and without repeats."""
    points = [waypoints[0]]
    for point in waypoints[1:]:
        if np.abs(point - points[-1]).max() > 1e-9:
            points.append(point)
    k = 0
    while k + 2 < len(points):
        for far in range(len(points) - 1, k + 1, -1):
            if accept(JointPath.line(points[k], points[far])):
                del points[k + 1 : far]
                break
        k += 1
    return np.array(points)
