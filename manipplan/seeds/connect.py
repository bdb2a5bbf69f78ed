"""RRT-Connect in compiled code, which counts crossings of singularities: `connect.c` on the collision kernel.

connect-star: our RRT-Connect, which goes on to lower the cost of its path, its length or g, until its checks are used up.

The path is changed at random, by shortcuts and detours (`star.c`), until that gains little. Then new trees look for a path that
costs less than the best one [wilson2025]: a node is added only where its cost from its root allows such a path, and random
configurations come from the ellipsoid of shorter paths [gammell2014] where the cost is the length. Each search without success
is followed by one with twice as many checks, so that with more and more checks every cheaper path is found at last.
"""

import ctypes
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from manipplan.cost.integral import PathIntegral, metric_matrix
from manipplan.paths.rounding import gauss_rule
from manipplan.seeds.motions import SIDE, Level, MotionCheck, called_back
from manipplan.seeds.ompl import LEAST, PANEL, POINTS
from manipplan.seeds.task import PATIENCE, SeedTask
from manipplan.support.checks import Array
from manipplan.support.compiling.declarations import struct
from manipplan.support.compiling.kernels import load_kernel
from manipplan.support.deadline import work_time

#: As in connect.c.
SEARCHING, FOUND, FULL = range(3)
#: Number of checks between two looks at the clock and for interrupts.
SLICE = 2000
#: Number of random shortcuts, and of those between two looks at the clock.
SHORTCUTS, SOME = 60, 10
#: Number of nodes of each tree for which there is room at first.
TREE_ROOM = 2048


@dataclass(frozen=True, kw_only=True, eq=False)
class TreeSearch:
    """A search by compiled code; only where `can_check`."""

    task: SeedTask

    def run(self, levels: Sequence[Level]) -> Array | None:
        """Waypoints (k, n) of a path, or None when none was found. Motions are checked as `levels` tell, one after another."""
        return Run(self.task, levels).path()


class Run:
    """The data of one search."""

    def __init__(self, task: SeedTask, levels: Sequence[Level]) -> None:
        self.task, self.check = task, MotionCheck(task, levels)
        self.n, self.search, self.call = self.check.n, self.check.data, self.check.call
        self.nodes = np.empty((2, TREE_ROOM, self.n))
        self.nodes[:, 0] = self.check.roots
        self.costs = np.zeros((2, TREE_ROOM))
        self.parents = np.full((2, TREE_ROOM), -1)
        self.sides = np.zeros((2, TREE_ROOM), dtype=SIDE)
        self.sides[:, 0] = self.check.root_sides
        self._set_room()

    def path(self) -> Array | None:
        """Waypoints (k, n), or None when none was found in time, or there is none."""
        task, at, call = self.task, self.check.at, self.call
        assert call is not None
        status = SEARCHING
        while status != FOUND:
            left = SLICE if task.checks is None else min(SLICE, task.checks - self.check.checks)
            if left <= 0 or work_time() >= task.deadline:
                return None
            if self.check.checks >= PATIENCE and task.why_unreachable() is not None:
                return None
            status = call["connect"](at, left)
            self.check.raise_failure()
            if status == FULL:
                self.grow()
        self.check.deadline = task.late
        count = call["way"](at, None)
        way = np.empty((count + SHORTCUTS, self.n))
        work = np.empty_like(way)
        call["way"](at, way.ctypes.data)
        count = call["skip"](at, way.ctypes.data, work.ctypes.data, count)
        for _ in range(SHORTCUTS // SOME):
            if work_time() < task.late:
                count = call["shorten"](at, way.ctypes.data, work.ctypes.data, count, SOME)
        count = call["skip"](at, way.ctypes.data, work.ctypes.data, count)
        self.check.raise_failure()
        return way[:count].copy()

    def grow(self) -> None:
        """Make room for twice as many nodes."""
        arrays = self.nodes, self.parents, self.sides, self.costs
        self.nodes, self.parents, self.sides, self.costs = (np.concatenate([a, a], axis=1) for a in arrays)
        self._set_room()

    def _set_room(self) -> None:
        self.search.room = self.nodes.shape[1]
        named = {"node": self.nodes, "parent": self.parents, "side": self.sides, "cost": self.costs}
        for name, arrays in named.items():
            setattr(self.search, name, (ctypes.c_void_p * 2)(*(each.ctypes.data for each in arrays)))


#: Number of random changes between two looks at the clock, and their gain below which new trees are grown.
CHANGES, STALLED = 200, 0.002
#: Maximum number of waypoints.
STAR_ROOM = 64
#: Number of checks of the first search for a cheaper path.
EXPLORE = 2000
#: Maximum distance of a detour, as a share of the length of what it replaces.
REACH = 0.5


@cache
def _functions() -> dict[str, Callable[..., Any]]:
    return load_kernel("star").functions()


@dataclass(frozen=True, kw_only=True, eq=False)
class StarSearch:
    """A search by compiled code that lowers the cost of its path; only where `can_check`.

    Attributes:
        task: with the maximum number of checks; a random change of the path counts as one.
        integral: the cost; None: the length.
    """

    task: SeedTask
    integral: PathIntegral | None

    def run(self, levels: Sequence[Level]) -> Array | None:
        """Waypoints (k, n) of the best path, or None when none was found. Motions are checked as `levels` tell."""
        run = Run(self.task, levels)
        found = run.path()
        return None if found is None else _Best(run, self.task, self.integral).lowered(found)


class _Best:
    """Lowers the cost of a first path."""

    def __init__(self, run: Run, task: SeedTask, integral: PathIntegral | None) -> None:
        search = load_kernel("connect")
        self.run, self.task, self.search, self.n = run, task, run.search, run.n
        self.search.level = max(self.search.level, self.search.levels - 2)  # the last level's paths nearly touch
        self.search.levels = self.search.level + 1
        nodes, weights = gauss_rule(POINTS)
        metric = None if integral is None or integral.metric is None else metric_matrix("metric", integral.metric, run.n)
        measure, owner = ((0, 0), None) if integral is None else _measure(integral, run.check)
        self._kept = nodes, weights, metric, owner
        self.star = struct("star", "Star")(
            n=run.n,
            low=self.search.low,
            high=self.search.high,
            metric=None if metric is None else metric.ctypes.data,
            measure=measure,
            floor=0.0 if integral is None else integral.floor,
            power=1.0 if integral is None else integral.power,
            least=LEAST,
            panel=PANEL,
            points=POINTS,
            nodes=nodes.ctypes.data,
            weights=weights.ctypes.data,
            search=run.check.at,
            clear=search.address("clear"),
            allowed=search.address("allowed"),
            reach=REACH,
            random=task.seed,
        )
        self.at = ctypes.addressof(self.star)
        self.search.star, self.search.cost_of = self.at, load_kernel("star").address("edge_cost")
        self.search.rate = 1.0 if integral is None else 0.0  # the largest m of an arm is not known

    def lowered(self, way: Array) -> Array:
        """The best path (k, n) that the checks and the time allow."""
        best, cost = self._change(way)
        checks = EXPLORE
        while not self._is_over():
            found = self._cheaper(cost, checks)
            if found is None:
                checks *= 2
                continue
            other, least = self._change(found)
            if least < cost:
                best, cost = other, least
        return best

    def _is_over(self) -> bool:
        checks = self.task.checks
        return work_time() >= self.task.deadline or (checks is not None and self.run.check.checks >= checks)

    def _change(self, way: Array) -> tuple[Array, float]:
        """A path (k, n) of lower cost by random changes, and its cost."""
        room = max(STAR_ROOM, len(way))
        points, work, count = np.empty((room, self.n)), np.empty((room, self.n)), len(way)
        points[:count] = way
        cost = self._cost(points[:count])
        while not self._is_over():
            count = _functions()["improve"](self.at, points.ctypes.data, work.ctypes.data, count, room, CHANGES)
            self.run.check.raise_failure()
            self.search.checks += CHANGES
            before, cost = cost, self._cost(points[:count])
            if cost > (1 - STALLED) * before:
                break
        return points[:count].copy(), cost

    def _cost(self, way: Array) -> float:
        cost = float(_functions()["way_cost"](self.at, way.ctypes.data, len(way)))
        self.run.check.raise_failure()
        return cost

    def _cheaper(self, cost: float, checks: int) -> Array | None:
        """A path (k, n) that costs less, found by new trees; None when none was found."""
        search, call, end = self.search, self.run.call, self.search.checks + checks
        assert call is not None
        search.size, search.bound, search.turn = (ctypes.c_long * 2)(1, 1), cost, 0
        while not self._is_over() and search.checks < end:
            left = min(SLICE, end - search.checks)
            if self.task.checks is not None:
                left = min(left, self.task.checks - search.checks)
            status = call["connect"](self.run.check.at, left)
            self.run.check.raise_failure()
            if status == FULL:
                self.run.grow()
            if status == FOUND:
                way = np.empty((call["way"](self.run.check.at, None), self.n))
                call["way"](self.run.check.at, way.ctypes.data)
                return way
        return None


def _measure(integral: PathIntegral, check: MotionCheck) -> tuple[tuple[int, int], object]:
    """The fields of a `Batch` of csrc/batch.h that gives m, and what has to live as long.

    A measure with operations that kernels do not know is called back.
    """
    kinematics = integral.kinematics
    batch = kinematics.batch_code("manipulability")
    if batch is not None:
        return batch, kinematics
    n = kinematics.robot.n

    def values(q: int, out: int, count: int) -> int:
        here = np.ctypeslib.as_array((ctypes.c_double * (count * n)).from_address(q)).reshape(count, n)
        found = np.ctypeslib.as_array((ctypes.c_double * count).from_address(out))
        found[:] = kinematics.manipulability(here)
        return int(not np.isfinite(found).all())

    function = check.guarded(values)
    return called_back(function), function
