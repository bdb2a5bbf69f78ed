"""Seeding: how first paths are found.

First paths without obstacles: the straight line, and paths through random configurations.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from manipplan.paths.joint import JointPath
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.robot import Robot
from manipplan.seeds.own import Planner
from manipplan.support.checks import Array, number, one_of, random_seed, whole_number
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
#: The planner of OMPL that "auto" takes where our own cannot be compiled.
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

    planner: str | Planner = "auto"
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
