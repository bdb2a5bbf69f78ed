"""Seed paths among obstacles: found by OMPL, simplified, rounded, and proven collision-free.

OMPL only searches: its own motion check is coarse, so its path is accepted only after the whole curve is proven
collision-free or, where it comes too close to contact for a proof, checked at every milliradian.
"""

import logging
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from manipplan.collision.model import CollisionModel
from manipplan.collision.path_clearance import path_clearance
from manipplan.collision.scene import Scene
from manipplan.cost.integral import PathIntegral
from manipplan.cost.objective import PathObjective
from manipplan.paths.joint import SHORTEST, JointPath
from manipplan.paths.smooth import rounded
from manipplan.robots.robot import Robot
from manipplan.seeds.aspect import Aspect
from manipplan.seeds.objective import ompl_objective
from manipplan.seeds.seeding import OPTIMISING, Seeding
from manipplan.support.checks import Array, instance, number, whole_number
from manipplan.support.errors import InvalidInputError, PlanningError

log = logging.getLogger("manipplan")

#: Maximum time beyond the time limit for simplifying and rounding a path [s].
GRACE = 0.3
#: Maximum joint motion between two checks of a finished path [rad or m].
CHECK_STEP = 1e-3
#: Minimum distance of the ends beyond the clearance for a proof [m]; the proof's own tolerances take as much.
PROVABLE = 1e-4
#: Steps of OMPL's motion checks [rad or m] and their margins beyond the clearance [m], tried in turn until a path is proven.
MOTION_STEPS = ((0.02, 0.0), (0.008, 0.002), (0.003, 0.005))
#: OMPL has one random seed per process, so searches in several threads would not be repeatable.
_ONE_AT_A_TIME = threading.Lock()


def seed_path(
    robot: Robot,
    start: ArrayLike,
    goal: ArrayLike,
    scene: Scene | None = None,
    *,
    seeding: Seeding = Seeding(),
    objective: PathObjective | None = None,
    same_aspect: bool = False,
    checks: int = 50_000,
    clearance: float = 0.0,
) -> JointPath:
    """Find a collision-free path: the straight line if that is free, else a path from OMPL, simplified and rounded.

    Args:
        robot: the arm.
        start, goal: (n,) [rad or m].
        scene: obstacles; None: only self-collision is checked.
        seeding: planner, random seed and time limit; the other fields keep their defaults.
        objective: the cost that the optimising planners (RRTstar, InformedRRTstar, SORRTstar, BITstar) lower; None: the length.
            With an objective the straight line is returned only if no lower g is found, and the path is simplified only where
            that does not raise g. The other planners ignore it.
        same_aspect: only accept a path on which det J keeps its sign, so that it crosses no singularity of the objective's
            task. Requires an arm with as many joints as the task has rows, and the same sign at start and goal.
        checks: maximum number of configurations that an optimising planner checks, about 60 µs each.
        clearance: minimum distance [m] to every obstacle and between the arm's own links.

    Returns:
        A JointPath that is proven collision-free on the whole curve. If no such path is found, for instance because the start
        nearly touches something, one that is free at every milliradian. `scene.path_clearance` tells which.

    Raises:
        InvalidInputError: start or goal has a wrong length, is outside the limits, or in collision; `same_aspect` if det J
            does not have the same sign at start and goal.
        PlanningError: no collision-free path was found within the time limit or `checks`.
    """
    instance("robot", robot, Robot)
    _check_seeding(instance("seeding", seeding, Seeding))
    integral = instance("objective", objective if objective is not None else PathObjective(), PathObjective).integral(robot)
    lowers_g = objective is not None and seeding.planner_name in OPTIMISING
    planner, time_limit = seeding.planner_name, seeding.time_limit
    checks = whole_number("checks", checks, least=1)
    clearance = number("clearance", clearance, least=0.0)
    scene = instance("scene", scene if scene is not None else Scene(), Scene)
    model = scene.collision_model(robot)
    q_start = model.free_configuration("start", start, clearance)
    q_goal = model.free_configuration("goal", goal, clearance)
    check_apart(q_start, q_goal)
    kinematics = integral.kinematics
    aspect = Aspect.shared(kinematics, q_start, q_goal) if same_aspect else None
    if same_aspect and aspect is None:
        wanted = f"False: det J of the task {kinematics.task.name} has no sign, or not the same one at start and goal"
        raise InvalidInputError("same_aspect", True, wanted)
    search = _Search(
        model=model,
        start=q_start,
        goal=q_goal,
        planner=planner,
        seed=seeding.seed,
        clearance=clearance,
        integral=integral if lowers_g else None,
        aspect=aspect,
        checks=checks if planner in OPTIMISING else None,
        deadline=time.monotonic() + time_limit,
    )
    line = JointPath.line(q_start, q_goal)
    free = _acceptance(model, (q_start, q_goal), clearance)
    accept = free if aspect is None else lambda path: aspect.holds(path) and free(path)
    line_is_free = accept(line)
    if line_is_free and not lowers_g:
        return line
    cost = search.cost
    checked = None
    spare = 0.9 * (model.least_distance(np.array([q_start, q_goal]))[0] - clearance)
    for step, margin in MOTION_STEPS:
        waypoints = search.run(step, min(margin, spare))
        if waypoints is None:
            break
        found = _finished(waypoints, search.in_time(accept), accept, cost)
        if found is not None:
            return line if line_is_free and cost(line) <= cost(found) else found
        sharp = JointPath.through(waypoints)
        if checked is None and _is_free(model, sharp, clearance) and (aspect is None or aspect.holds(sharp)):
            checked = sharp
        log.info("the path is not proven free with OMPL's checks %g rad apart; checking finer", step)
    if line_is_free:
        return line
    if checked is not None:
        log.info("no path was proven collision-free in time; this one is free at every milliradian")
        return checked
    spent, remedy = f"in {time_limit:g} s", "allow more time (Seeding.time_limit)"
    if time.monotonic() < search.deadline and search.checks is not None:
        spent, remedy = f"with {checks} checks", "allow more of them (checks)"
    raise PlanningError(
        f"no path from start to goal was found by {planner} {spent}; "
        f"{remedy}, reduce the clearance, or check that the goal can be reached"
    )


def _check_seeding(seeding: Seeding) -> None:
    """Raise InvalidInputError for options that concern several first paths, or a given one."""
    for name, value, only in (
        ("seeding.count", seeding.count, 1),
        ("seeding.shifts", seeding.shifts, "none"),
        ("seeding.initial", seeding.initial, None),
    ):
        if value != only:
            raise InvalidInputError(name, value, f"{only!r}: seed_path looks for one path; optimize_path takes the others")


def _finished(
    waypoints: Array,
    accept: Callable[[JointPath], bool],
    proven: Callable[[JointPath], bool],
    cost: Callable[[JointPath], float],
) -> JointPath | None:
    """The path through waypoints, simplified and rounded where that is accepted and costs no more; None if not `proven`."""
    simple = _shortened(waypoints, accept, cost)
    sharp = JointPath.through(simple)
    if not proven(sharp):
        return None
    smooth = rounded(simple, accept)
    return smooth if accept(smooth) and cost(smooth) <= cost(sharp) else sharp


def _acceptance(model: CollisionModel, ends: tuple[Array, Array], clearance: float) -> Callable[[JointPath], bool]:
    """The acceptance test of a seed: proven free, or free at every milliradian if an end is too near contact for a proof."""
    for q in ends:
        if model.least_distance(np.asarray(q)[None])[0] <= clearance + PROVABLE:
            log.info("start or goal is too close to contact for a proof; the seed is checked at every milliradian")
            return lambda path: _is_free(model, path, clearance)
    return lambda path: path_clearance(model, path, clearance=clearance, tolerance=None).proven


def _is_free(model: CollisionModel, path: JointPath, clearance: float) -> bool:
    """Whether the path is free at every milliradian, and the proof found no contact in between."""
    return (
        model.path_is_free(path, CHECK_STEP, clearance)
        and not path_clearance(model, path, clearance=clearance, tolerance=None).refuted
    )


def check_apart(start: Array, goal: Array) -> None:
    """Raise InvalidInputError if start and goal coincide."""
    if np.abs(goal - start).max() < SHORTEST:
        raise InvalidInputError("goal", goal.tolist(), f"a configuration that differs from start by {SHORTEST:g} or more")


@dataclass(frozen=True, kw_only=True, eq=False)
class _Search:
    """A search with OMPL.

    Attributes:
        integral: the cost; None: the length.
        aspect: the aspect to stay in; None: any.
        checks: maximum number of checks of an optimising planner; None: the first path ends the search.
        deadline: of the search, in time.monotonic() [s].
    """

    model: CollisionModel
    start: Array
    goal: Array
    planner: str
    seed: int
    clearance: float
    integral: PathIntegral | None
    aspect: Aspect | None
    checks: int | None
    deadline: float

    def cost(self, path: JointPath) -> float:
        """The cost that the search lowers, for any path."""
        return path.length if self.integral is None else self.integral.cost(path).g

    def in_time(self, accept: Callable[[JointPath], bool]) -> Callable[[JointPath], bool]:
        """The same test, but paths that come too late are rejected."""
        return lambda path: time.monotonic() < self.deadline + GRACE and accept(path)

    def run(self, step: float, margin: float) -> Array | None:
        """Waypoints (k, n) of OMPL's path, or None when none was found.

        Motions are checked every `step` [rad or m], with `margin` [m] more than the clearance.
        """
        with _ONE_AT_A_TIME:
            return self._run(step, self.clearance + margin) if time.monotonic() < self.deadline else None

    def _run(self, step: float, clearance: float) -> Array | None:
        from ompl import base, geometric, util

        util.setLogLevel(util.LogLevel.LOG_NONE)
        util.RNG.setSeed(self.seed + 1)  # 0 would mean a random seed
        n = self.model.robot.n
        space = base.RealVectorStateSpace(n)
        bounds = base.RealVectorBounds(n)
        limits = self.model.robot.limits
        # a continuous joint is searched up to half a turn beyond start and goal
        low = np.where(np.isfinite(limits.lower), limits.lower, np.minimum(self.start, self.goal) - np.pi)
        high = np.where(np.isfinite(limits.upper), limits.upper, np.maximum(self.start, self.goal) + np.pi)
        for joint in range(n):
            bounds.setLow(joint, float(low[joint]))
            bounds.setHigh(joint, float(high[joint]))
        space.setBounds(bounds)
        information = base.SpaceInformation(space)
        done = 0
        late = self.deadline

        def is_valid(state: Any) -> bool:
            nonlocal done
            done += 1
            q = np.array(state[0:n])
            # past the deadline nothing is valid, so that a motion with many checks ends at once
            if time.monotonic() >= late or self.model.in_collision(q, clearance=clearance):
                return False
            return self.aspect is None or self.aspect.has(q)

        def is_over() -> bool:
            return time.monotonic() >= self.deadline or (self.checks is not None and done >= self.checks)

        information.setStateValidityChecker(is_valid)
        information.setStateValidityCheckingResolution(step / float(space.getMaximumExtent()))
        information.setup()
        problem = base.ProblemDefinition(information)
        problem.setStartAndGoalStates(_state(space, self.start), _state(space, self.goal), 1e-9)
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
            late = self.deadline + GRACE
            simplifier = geometric.PathSimplifier(information)
            simplifier.reduceVertices(path)
            simplifier.partialShortcutPath(path)
            simplifier.collapseCloseVertices(path)
        points = np.array([path.getState(i)[0:n] for i in range(path.getStateCount())])
        points[0], points[-1] = self.start, self.goal
        apart = np.abs(np.diff(points, axis=0)).max(axis=1) > 1e-9
        return np.asarray(points[np.append(apart, True)] if apart[-1] else np.vstack([points[:-1][apart], points[-1:]]))


def _state(space: object, q: Array) -> object:
    state = space.allocState()  # type: ignore[attr-defined]  # ompl has no stubs
    state[0 : len(q)] = [float(x) for x in q]
    return state


def _shortened(waypoints: Array, accept: Callable[[JointPath], bool], cost: Callable[[JointPath], float]) -> Array:
    """The waypoints without those that an accepted straight motion of no higher cost can skip."""
    points = list(waypoints)
    k = 0
    while k + 2 < len(points):
        for far in range(len(points) - 1, k + 1, -1):
            skip = JointPath.line(points[k], points[far])
            if cost(skip) <= cost(JointPath.through(points[k : far + 1])) and accept(skip):
                del points[k + 1 : far]
                break
        k += 1
    return np.array(points)
