"""Seed paths among obstacles: found by a search, simplified, rounded, and proven collision-free.

The motion checks of a search sample configurations, so its path is accepted only after the whole curve is proven collision-free
or, where it comes too close to contact for a proof, checked at every milliradian.
"""

import logging
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache, partial

import numpy as np

from manipplan.collision.scene import Scene
from manipplan.constraints.constraint import Constraint, constraint_tuple
from manipplan.constraints.constraint_set import ConstraintSet, check_ends
from manipplan.cost.crossings import least_crossings
from manipplan.cost.integral import PathIntegral
from manipplan.cost.objective import PathObjective
from manipplan.kinematics.factors import singularity_signs
from manipplan.kinematics.kinematics import Kinematics
from manipplan.paths.joint import JointPath, rounded
from manipplan.robots.robot import Robot
from manipplan.seeds.connect import MOST_JOINTS, StarSearch, TreeSearch, can_check
from manipplan.seeds.ompl import OmplSearch
from manipplan.seeds.reachable import why_unreachable
from manipplan.seeds.seeding import AUTO, OPTIMISING, STAR, OwnSearch, Seeding, fault_of, planner_name
from manipplan.seeds.task import (
    GRACE,
    LONGEST,
    MOST_GRACE,
    Level,
    SeedTask,
    acceptance,
    crossing_limit,
    is_free,
    keeps_constraints,
    looks_free,
)
from manipplan.support.checks import COINCIDENT, Array, ArrayLike, flag, instance, number, whole_number
from manipplan.support.deadline import work_time
from manipplan.support.errors import InvalidInputError, PlanningError

log = logging.getLogger("manipplan")

#: How the motions of a search are checked, one level after another; and shares of their steps, tried in turn until a path is
#: proven.
LEVELS = (
    Level(step=0.05, margin=0.02, checks=1000),
    Level(step=0.05, margin=0.01, checks=1000),
    Level(step=0.03, margin=0.005, checks=1000),
    Level(step=0.02, margin=0.002, checks=20_000),
    Level(step=0.02, margin=0.0),
)
FINER = (1.0, 0.3, 0.1)
#: The same with constraints, which change more between two checks than distances do.
CONSTRAINED_FINER = FINER[1:]
#: Checks of the search for a path with the fewest crossings, and of the one that allows `MORE` of them.
FEWEST_CHECKS, MORE_CHECKS, MORE = 100_000, 50_000, 2


def seed_path(
    robot: Robot,
    start: ArrayLike,
    goal: ArrayLike,
    scene: Scene | None = None,
    *,
    seeding: Seeding = Seeding(),
    objective: PathObjective | None = None,
    same_aspect: bool = False,
    fewest_crossings: bool = False,
    checks: int = 50_000,
    constraints: Sequence[Constraint] = (),
    clearance: float = 0.0,
) -> JointPath:
    """Find a collision-free path: the straight line if that is free, else the path of a planner, simplified and rounded.

    Args:
        robot: the arm.
        start, goal: (n,) [rad or m].
        scene: obstacles; None: only self-collision is checked.
        seeding: planner, random seed and time limit; the other fields keep their defaults.
        objective: the cost that the optimising planners (connect-star, RRTstar, InformedRRTstar, SORRTstar, BITstar) lower;
            None: the length.
            With an objective the straight line is returned only if no lower g is found, and the path is simplified only where
            that does not raise g. The other planners ignore it.
        same_aspect: only accept a path on which no factor of det J changes its sign, so that it crosses no singularity of the
            objective's task. Requires an arm with as many joints as the task has rows, and no crossing that is unavoidable.
        fewest_crossings: look first for a path that crosses singularities no more often than it must, then for one with two
            crossings more, and then for any. The planners of OMPL only tell paths without crossings from others. No effect on
            arms with more joints than the task has rows.
        checks: maximum number of configurations that an optimising planner checks, about 3 µs each; of connect-star, together
            with the random changes of its path.
        constraints: TiltLimit, PositionBox, HeldJoints or a Constraint of yours; only with the planner "auto".
        clearance: minimum distance [m] to every obstacle and between the arm's own links.

    Returns:
        A JointPath that is proven collision-free on the whole curve. If no such path is found, for instance because the start
        nearly touches something, one that is free at every milliradian. `scene.path_clearance` tells which.

    Raises:
        InvalidInputError: start or goal has a wrong length, is outside the limits, or in collision; they are the same, or more
            than 1000 rad or m apart in a joint; `same_aspect` if they are singular or lie in different aspects; a planner of
            your own raises an error, or returns something else than waypoints within the limits, from start to goal.
        PlanningError: no collision-free path was found within the time limit or `checks`, or there is none. Where that can be
            proven, which takes less than a second, the message says why and names the bodies.
    """
    instance("robot", robot, Robot)
    flag("same_aspect", same_aspect)
    flag("fewest_crossings", fewest_crossings)
    _check_seeding(instance("seeding", seeding, Seeding))
    integral = instance("objective", objective if objective is not None else PathObjective(), PathObjective).integral(robot)
    lowers_g = objective is not None and seeding.planner in OPTIMISING
    checks = whole_number("checks", checks, least=1)
    clearance = number("clearance", clearance, least=0.0)
    scene = instance("scene", scene if scene is not None else Scene(), Scene)
    model = scene.collision_model(robot)
    q_start = model.free_configuration("start", start, clearance)
    q_goal = model.free_configuration("goal", goal, clearance)
    check_apart(q_start, q_goal)
    compiled = can_check(model) and seeding.planner in ("auto", STAR)
    if seeding.planner == STAR and not compiled:
        raise InvalidInputError("seeding.planner", STAR, f"another one: it serves at most {MOST_JOINTS} joints")
    constraint_set = ConstraintSet.of(robot, constraints) if constraint_tuple(constraints) else None
    if constraint_set is not None:
        check_ends(constraint_set, q_start, q_goal)
        if seeding.planner != "auto":
            name = planner_name(seeding.planner)
            raise InvalidInputError("seeding.planner", name, "'auto': the other planners keep no constraints")
        if not compiled:
            raise InvalidInputError(
                "constraints", constraints, f"none: the search that keeps them serves at most {MOST_JOINTS} joints"
            )
    kinematics = integral.kinematics
    task = SeedTask(
        model=model,
        start=q_start,
        goal=q_goal,
        distances=(model.least_distance(q_start[None])[0], model.least_distance(q_goal[None])[0]),
        seed=seeding.seed,
        clearance=clearance,
        signs=singularity_signs(kinematics),
        most_crossings=None,
        checks=None,
        deadline=work_time() + seeding.time_limit,
        grace=min(GRACE * seeding.time_limit, MOST_GRACE),
        constraints=constraint_set,
    )
    task = replace(task, why_unreachable=cache(partial(why_unreachable, task)))
    finder = _Finder(
        seeding=seeding, integral=integral if lowers_g else None, checks=checks, compiled=compiled, free=acceptance(task)
    )
    if same_aspect:
        _check_aspect(task, kinematics)
        tasks = [replace(task, most_crossings=0)]
    else:
        tasks = _stages(task, kinematics, finder) if fewest_crossings else [task]
    for each in tasks:
        found = finder.find(each)
        if found is not None:
            return found
    raise PlanningError(task.why_unreachable() or finder.failure(task))


def _check_aspect(task: SeedTask, kinematics: Kinematics) -> None:
    """Raise InvalidInputError unless start and goal lie in one aspect, as far as the signs of det J's factors tell."""
    name = kinematics.task.name
    if task.signs is None:
        raise InvalidInputError("same_aspect", True, f"False: det J of the task {name} has no sign, since J is not square")
    singular = [end for end, q in (("start", task.start), ("goal", task.goal)) if task.signs.vanishing(q)]
    if singular:
        raise InvalidInputError("same_aspect", True, f"False: {' and '.join(singular)} is singular for the task {name}")
    if least_crossings(kinematics, task.start, task.goal):
        raise InvalidInputError("same_aspect", True, f"False: start and goal lie in different aspects of the task {name}")


def _stages(task: SeedTask, kinematics: Kinematics, finder: "_Finder") -> list[SeedTask]:
    """Searches that allow more and more crossings, each but the last one with a limit."""
    least = least_crossings(kinematics, task.start, task.goal)
    if least is None or callable(finder.seeding.planner):
        return [task]
    if not finder.compiled:
        half = task.deadline - finder.seeding.time_limit / 2
        return ([replace(task, most_crossings=0, deadline=half)] if least == 0 else []) + [task]
    return [
        replace(task, most_crossings=least, checks=FEWEST_CHECKS),
        replace(task, most_crossings=least + MORE, checks=MORE_CHECKS),
        task,
    ]


@dataclass(kw_only=True, eq=False)
class _Finder:
    """Finds the path of a task.

    Attributes:
        seeding: planner and time limit.
        integral: the cost that the search lowers; None: the length.
        checks: maximum number of checks of an optimising planner.
        compiled: search by our own compiled code, not by OMPL.
        free: the acceptance test.
        spent: the number of checks, not the time limit, ended the search.
        fault: what is wrong with the last path of a planner of the user; "" without any.
    """

    seeding: Seeding
    integral: PathIntegral | None
    checks: int
    compiled: bool
    free: Callable[[JointPath], bool]
    spent: bool = False
    fault: str = ""

    def cost(self, path: JointPath) -> float:
        """The cost that the search lowers, for any path."""
        return path.length if self.integral is None else self.integral.cost(path).g

    def find(self, task: SeedTask) -> JointPath | None:
        """The path of a search; None if none is found in time."""
        line = JointPath.line(task.start, task.goal)
        is_allowed, cost = crossing_limit(task), self.cost

        def accept(path: JointPath) -> bool:
            return is_allowed(path) and self.free(path)

        def accept_in_time(path: JointPath) -> bool:
            return work_time() < task.late and accept(path)

        line_is_free = accept(line)
        if line_is_free and self.integral is None:
            return line
        checked = None
        for found in self._waypoints(task):
            apart = np.abs(np.diff(found, axis=0)).max(axis=1) > 1e-9
            waypoints = np.vstack([found[:-1][apart], found[-1:]])
            if not keeps_constraints(task, JointPath.through(waypoints)):
                continue
            is_short = self.compiled or callable(self.seeding.planner)  # a planner of the user decides itself
            points = waypoints if is_short else _shorten(waypoints, accept_in_time, cost)
            path = self._smooth(points, accept, lambda path: looks_free(task, path))
            if path is None and accept(JointPath.through(points)):
                path = _round_corners(points, accept_in_time, cost)
            if path is not None:
                return line if line_is_free and cost(line) <= cost(path) else path
            sharp = JointPath.through(waypoints)
            if checked is None and is_allowed(sharp) and is_free(task, sharp):
                checked = sharp
            if callable(self.seeding.planner):
                self.fault = f"returned a path of {len(found)} waypoints, but {fault_of(task, waypoints)}"
        self.spent = work_time() < task.deadline
        if line_is_free:
            return line
        if checked is not None:
            log.info("no path was proven collision-free in time; this one is free at every milliradian")
        return checked

    def _smooth(
        self, points: Array, accept: Callable[[JointPath], bool], is_free: Callable[[JointPath], bool]
    ) -> JointPath | None:
        """The path with corners as wide as `is_free` allows, if that is accepted and costs no more; one proof is enough."""
        path = rounded(points, is_free)
        is_cheap = self.integral is None or self.cost(path) <= self.cost(JointPath.through(points))  # it is never longer
        return path if is_cheap and accept(path) else None

    @property
    def planner(self) -> str:
        """The name of the planner, with that of OMPL for "auto"."""
        return AUTO if self.seeding.planner == "auto" else planner_name(self.seeding.planner)

    def _search(self, task: SeedTask) -> tuple[Callable[[Sequence[Level]], Array | None], Sequence[Level]]:
        """The search for waypoints (k, n), and the levels of its motion checks."""
        if callable(self.seeding.planner):
            return OwnSearch(task, self.seeding.planner).run, LEVELS[-1:]
        if self.planner == STAR:
            limited = replace(task, checks=self.checks if task.checks is None else min(self.checks, task.checks))
            return (lambda levels: StarSearch(limited, levels, self.integral).path()), LEVELS
        if self.compiled:
            return (lambda levels: TreeSearch(task, levels).path()), LEVELS
        optimises = self.planner in OPTIMISING  # it does not check a motion again
        limited = replace(task, checks=self.checks) if optimises else task
        search = OmplSearch(task=limited, planner=self.planner, integral=self.integral)
        return search.run, LEVELS[-1:] if optimises else LEVELS

    def _waypoints(self, task: SeedTask) -> Iterator[Array]:
        """The paths (k, n) of searches with finer and finer motion checks."""
        search, levels = self._search(task)
        for share in FINER if task.constraints is None else CONSTRAINED_FINER:
            waypoints = search([replace(level, step=share * level.step) for level in levels])
            if waypoints is None:
                return
            yield waypoints
            log.info("the path is not proven free; looking for another one with checks nearer to each other")

    def failure(self, task: SeedTask) -> str:
        """Why no path of a task was found."""
        limit, is_auto = self.seeding.time_limit, self.compiled and self.seeding.planner == "auto"
        if self.fault:
            return f"{self.planner} {self.fault}"
        spent, remedy = f"in {limit:g} s", "allow more time (Seeding.time_limit)"
        if self.spent and self.planner in OPTIMISING:
            spent, remedy = f"with {self.checks} checks", "allow more of them (checks)"
        elif self.spent and task.constraints is not None:
            spent, remedy = "that keeps the constraints also between its checks", "give them more width"
        elif self.spent and callable(self.seeding.planner):
            spent, remedy = "(it returned None)", "let it search longer"
        widen = there = ""
        if task.constraints is not None:
            widen = f", widen the constraints ({'; '.join(each.name for each in task.constraints.constraints)})"
        distance, _, nearest = task.model.least_distance(task.goal[None])
        if nearest >= 0:
            first, second = task.model.pair_names[nearest]
            there = f": there {first} and {second} are the nearest bodies, {1e3 * distance:.3g} mm apart"
        return (
            f"no path from start to goal was found by {'RRT-Connect' if is_auto else self.planner} {spent}; "
            f"{remedy}, reduce the clearance{widen}, or check that the goal can be reached{there}"
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


def _round_corners(waypoints: Array, accept: Callable[[JointPath], bool], cost: Callable[[JointPath], float]) -> JointPath:
    """The path through waypoints, with rounded corners where that is accepted and costs no more."""
    sharp, smooth = JointPath.through(waypoints), rounded(waypoints, accept)
    return smooth if accept(smooth) and cost(smooth) <= cost(sharp) else sharp


def check_apart(start: Array, goal: Array) -> None:
    """Raise InvalidInputError if start and goal coincide, or are so far apart that a path cannot be checked."""
    motion = np.abs(goal - start)
    if motion.max() < COINCIDENT:
        raise InvalidInputError("goal", goal.tolist(), f"a configuration that differs from start by {COINCIDENT:g} or more")
    if motion.max() > LONGEST:
        joint = int(motion.argmax())
        allowed = f"{start[joint] - LONGEST:g} to {start[joint] + LONGEST:g}: at most {LONGEST:g} rad or m from start"
        raise InvalidInputError(f"goal[{joint}]", float(goal[joint]), allowed)


def _shorten(waypoints: Array, accept: Callable[[JointPath], bool], cost: Callable[[JointPath], float]) -> Array:
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
