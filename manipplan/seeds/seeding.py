"""Seeding: how first paths are found.

First paths without obstacles: the straight line, and paths through random configurations.

A planner of your own for first paths: the problem that it is given, and the checks of its answer.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from manipplan.collision.model import apart_text
from manipplan.collision.path_clearance import path_clearance
from manipplan.paths.joint import JointPath
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.robot import Robot
from manipplan.seeds.task import LONGEST, Level, SeedTask, crossing_limit
from manipplan.support import checks
from manipplan.support.checks import Array, ArrayLike, number, one_of, random_seed, whole_number
from manipplan.support.deadline import OutOfTimeError, work_time
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError

#: Planners that stop at the first path. PRM and PRM* are excluded: they search in a thread of their own, which waits for
#: Python's lock while the search waits for that thread, and their runs are not repeatable.
FEASIBLE = ("RRTConnect", "RRT", "KPIECE1", "BKPIECE1", "LBKPIECE1")
#: Our own planner that continues to lower the cost.
STAR = "connect-star"
#: Planners that continue to lower the cost until `checks` or `time_limit` is used up.
OPTIMISING = (STAR, "RRTstar", "InformedRRTstar", "SORRTstar", "BITstar")
PLANNERS = FEASIBLE + OPTIMISING
#: The planner of OMPL that "auto" takes for more joints than our own serves.
AUTO = "RRTConnect"
#: Full turns of a goal: as given, the nearest to the start, or all inside the limits.
AS_GIVEN, NEAREST, WITHIN_LIMITS = SHIFTS = ("none", "nearest", "within-limits")
#: Maximum number of first paths per goal.
MOST_SEEDS = 10_000


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class Seeding:
    """How first paths are found, from which the optimiser descends.

    Attributes:
        planner: what searches among obstacles: "auto", our compiled RRT-Connect; "connect-star", the same with a search that
            goes on to lower the path's cost; or a planner of OMPL: RRTConnect, RRT, KPIECE1, BKPIECE1, LBKPIECE1, and RRTstar,
            InformedRRTstar, SORRTstar and BITstar, which lower their path's cost. Or a planner of your own: a function or an
            object that is called with a `PlannerProblem`, and returns waypoints (k, n) or None.
        seed: random seed of the planner; without a scene, of the random first paths. The same seed gives the same path, on any
            machine, unless `time_limit` ends the search.
        count: number of first paths per goal. With a scene the planner finds them, with `seed`, `seed` + 1 and so on. Paths
            joined by a collision-free straight homotopy form a class. The first path is optimised, and of each class without it
            the path of smallest g, so more first paths never give a larger g. Without a scene they are the straight line and
            paths through random configurations. `PathResult.missing` estimates how likely one more leads to a new path.
        time_limit: time limit per first path [s], for finding and optimising it; `plan` and `optimize_path` take at most this
            times the number of first paths, without the time for what is built once per machine, process, robot or scene.
            `plan` times what was found by then.
        shifts: full turns of a goal that is a configuration, whose posture is the same. "none": as it is given. "nearest": the
            short way, each revolute joint ends at the turn nearest to the start that its limits allow; of a joint without
            limits any 2 π k counts. "within-limits": goals 2π away in each revolute joint are tried, too, at most 3 to the
            power of n of them, and the best path is returned; `plan` divides its time among them. Not together with `initial`.
        initial: a first path from start to goal: a JointPath, a Trajectory, or a trajectory file (.csv, .json, .yaml, .npz),
            such as a recorded motion. With a scene it must be collision-free. The descent starts from the fit to it, so
            optimising a result again returns it. None: the straight line, or with a scene a path of the planner.
    """

    planner: "str | Planner" = "auto"
    seed: int = 0
    count: int = 1
    time_limit: float = 10.0
    shifts: str = "none"
    initial: JointPath | Trajectory | str | Path | None = None

    def __post_init__(self) -> None:
        if isinstance(self.planner, type) or not callable(self.planner):
            names = ("auto", *PLANNERS)
            if not isinstance(self.planner, str):
                wanted = f"one of {', '.join(names)}, or a function of a PlannerProblem"
                raise InvalidInputError("planner", self.planner, wanted)
            one_of("planner", self.planner, names)
        one_of("shifts", self.shifts, SHIFTS)
        object.__setattr__(self, "seed", random_seed("seed", self.seed))
        object.__setattr__(self, "count", whole_number("count", self.count, least=1, most=MOST_SEEDS))
        object.__setattr__(self, "time_limit", number("time_limit", self.time_limit, above=0.0))
        if self.initial is not None and not isinstance(self.initial, JointPath | Trajectory | str | Path):
            raise InvalidInputError("initial", self.initial, "a JointPath, a Trajectory, or the path of a trajectory file")
        if self.initial is not None and self.shifts != "none":
            raise InvalidInputError("shifts", self.shifts, "'none' together with an initial path")
        if self.initial is not None and self.count > 1:
            raise InvalidInputError("count", self.count, "1 together with an initial path")


def random_path(robot: Robot, start: Array, goal: Array, seed: int) -> JointPath:
    """The straight line for seed 0, else a path through a random configuration within half a turn of its middle per joint."""
    if seed == 0:
        return JointPath.line(start, goal)
    via = (start + goal) / 2 + np.random.default_rng(seed).uniform(-np.pi, np.pi, robot.n)
    return JointPath.through(np.stack([start, np.clip(via, robot.limits.lower, robot.limits.upper), goal]))


#: Maximum number of waypoints.
MOST_WAYPOINTS = 10_000
#: Maximum distance of the first and the last waypoint from start and goal, and of any from the limits [rad or m].
AT_END = 1e-6


@dataclass(frozen=True, kw_only=True, eq=False)
class PlannerProblem:
    """The argument of a planner of your own: start and goal, a box of joint values, and collision checks.

    The planner is a function, or an object that can be called, with this problem as its only argument. It returns waypoints
    (k, n) [rad or m], from start to goal, between which the arm moves straight; or None if it finds none.

    Attributes:
        random: random numbers, from `Seeding.seed`; with them alone the planner's path is repeatable.
        step: maximum motion of a joint between two samples of `motion_is_free` [rad or m]. If a path is not proven free between
            them, the planner is called again with a smaller step and other random numbers, three times in all.
    """

    random: np.random.Generator
    step: float
    _task: SeedTask = field(repr=False)

    @property
    def robot(self) -> Robot:
        """The arm."""
        return self._task.model.robot

    @property
    def start(self) -> Array:
        """(n,) [rad or m]."""
        return self._task.start.copy()

    @property
    def goal(self) -> Array:
        """(n,) [rad or m]."""
        return self._task.goal.copy()

    @property
    def lower(self) -> Array:
        """Least joint values (n,) [rad or m]: the limits; of a joint without them half a turn below start and goal."""
        return self._task.bounds()[0]

    @property
    def upper(self) -> Array:
        """Largest joint values (n,) [rad or m], as `lower`."""
        return self._task.bounds()[1]

    @property
    def time_left(self) -> float:
        """Time until the planner has to return [s], at least 0. Later `is_free` and `motion_is_free` raise, which ends it."""
        return max(self._task.deadline - work_time(), 0.0)

    def is_free(self, q: ArrayLike) -> NDArray[np.bool_]:
        """Whether configurations q (..., n) are between `lower` and `upper` and keep the clearance; (...).

        Raises InvalidInputError when q has another shape, or is not finite.
        """
        self._check_time()
        rows = checks.configurations("q", q, self.robot.n)
        return self._free(rows.reshape(-1, self.robot.n)).reshape(rows.shape[:-1])

    def motion_is_free(self, first: ArrayLike, last: ArrayLike) -> bool:
        """Whether the straight motion from `first` (n,) to `last` (n,) is free, at samples at most `step` apart.

        Raises InvalidInputError when one has another shape, or is not finite.
        """
        self._check_time()
        ends = np.array([checks.finite_array(name, q, (self.robot.n,)) for name, q in (("first", first), ("last", last))])
        if not self._free(ends).all():
            return False
        count = int(np.ceil(np.abs(ends[1] - ends[0]).max() / self.step))
        return bool(self._free(ends[0] + np.arange(1, count)[:, None] / max(count, 1) * (ends[1] - ends[0])).all())

    def _free(self, q: Array) -> NDArray[np.bool_]:
        """Whether configurations (m, n) are free; (m,)."""
        low, high = self._task.bounds()
        free: NDArray[np.bool_] = np.all((q >= low - AT_END) & (q <= high + AT_END), axis=1)
        free[free] = ~self._task.model.in_collision_rows(q[free], clearance=self._task.clearance)
        return free

    def _check_time(self) -> None:
        if work_time() >= self._task.deadline:
            raise OutOfTimeError


#: Waypoints (k, n) from start to goal, or None.
Planner: TypeAlias = Callable[[PlannerProblem], ArrayLike | None]


def planner_name(planner: str | Planner) -> str:
    """What messages call a planner: its name; of one of your own that of its function or class."""
    if isinstance(planner, str):
        return planner
    return f"the planner {getattr(planner, '__qualname__', type(planner).__qualname__)}"


class OwnSearch:
    """A search by a planner of the user."""

    def __init__(self, task: SeedTask, planner: Planner) -> None:
        self._task, self._planner = task, planner
        self._random = np.random.default_rng(task.seed)

    def run(self, levels: Sequence[Level]) -> Array | None:
        """Waypoints (k, n) of the planner's path, or None; motions are checked as the last level tells."""
        if work_time() >= self._task.deadline:
            return None
        name = planner_name(self._planner)
        try:
            answer = self._planner(PlannerProblem(random=self._random, step=levels[-1].step, _task=self._task))
        except OutOfTimeError:
            return None
        except Exception as error:  # whatever the user's function raises
            reason = f"one that returns waypoints (k, n) or None; it raised {type(error).__name__}: {error}"
            raise InvalidInputError("seeding.planner", name, reason) from error
        return None if answer is None else self._checked(f"waypoints of {name}", answer)

    def _checked(self, argument: str, answer: ArrayLike) -> Array:
        """The waypoints with start and goal as they are; raises InvalidInputError unless they lead from one to the other."""
        task, robot = self._task, self._task.model.robot
        points = checks.finite_array(argument, answer, (None, robot.n)).copy()
        if not 2 <= len(points) <= MOST_WAYPOINTS:
            raise InvalidInputError(argument, f"{len(points)} waypoints", f"2 to {MOST_WAYPOINTS} of them, from start to goal")
        for k, end, q in ((0, "start", task.start), (len(points) - 1, "goal", task.goal)):
            if np.abs(points[k] - q).max() > AT_END:
                raise InvalidInputError(f"{argument}[{k}]", points[k].tolist(), f"the {end} {q.tolist()}")
        points[0], points[-1] = task.start, task.goal
        outside = np.argwhere((points < robot.limits.lower - AT_END) | (points > robot.limits.upper + AT_END))
        if len(outside):
            k, joint = (int(each) for each in outside[0])
            within = f"{robot.limits.lower[joint]:g} to {robot.limits.upper[joint]:g}"
            raise InvalidInputError(f"{argument}[{k}]", float(points[k, joint]), f"{within} for {robot.joint_names[joint]}")
        if np.abs(np.diff(points, axis=0)).sum(axis=0).max() > LONGEST:
            raise InvalidInputError(argument, points, f"at most {LONGEST:g} rad or m of motion of each joint")
        points[1:-1] = np.clip(points[1:-1], robot.limits.lower, robot.limits.upper)
        return points


def fault_of(task: SeedTask, waypoints: Array) -> str:
    """What is wrong with the straight motions through waypoints (k, n), which are not accepted."""
    path = JointPath.through(waypoints)
    proof = path_clearance(task.model, path, clearance=task.clearance, tolerance=None)
    if not proof.refuted:
        return "it is not proven free" if crossing_limit(task)(path) else "it crosses a singularity"
    bodies = f"{' and '.join(proof.pair)} {apart_text(proof.upper)}"
    return f"{bodies} at q = {np.round(path(proof.at), 4).tolist()}; a clearance of {1e3 * task.clearance:g} mm is required"
