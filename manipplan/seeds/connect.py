"""RRT-Connect in compiled code, which counts crossings of singularities: `connect.c` on the collision kernel."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from manipplan.seeds.motions import SIDE, Level, MotionCheck, P
from manipplan.seeds.task import PATIENCE, SeedTask
from manipplan.support.checks import Array
from manipplan.support.deadline import work_time

#: As in connect.c.
SEARCHING, FOUND, FULL = range(3)
#: Number of checks between two looks at the clock and for interrupts.
SLICE = 2000
#: Number of random shortcuts, and of those between two looks at the clock.
SHORTCUTS, SOME = 60, 10
#: Number of nodes of each tree for which there is room at first.
ROOM = 2048


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
        self.nodes = np.empty((2, ROOM, self.n))
        self.nodes[:, 0] = self.check.roots
        self.costs = np.zeros((2, ROOM))
        self.parents = np.full((2, ROOM), -1)
        self.sides = np.zeros((2, ROOM), dtype=SIDE)
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
            setattr(self.search, name, (P * 2)(*(each.ctypes.data for each in arrays)))
