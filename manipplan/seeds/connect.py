"""RRT-Connect in compiled code, which counts crossings of singularities: `connect.c` on the collision kernel."""

import ctypes
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np

from manipplan.collision.kernel import FREE, TOUCHING
from manipplan.collision.model import CollisionModel
from manipplan.kinematics.batch import BATCH
from manipplan.kinematics.sides import Sides
from manipplan.seeds.task import GRACE, SeedTask
from manipplan.support.checks import Array
from manipplan.support.compiling.native import native_code

#: As in connect.c.
SEARCHING, FOUND, FULL = range(3)
MOST_SIDES, MOST_JOINTS = 8, 64
#: Maximum length of an edge, and distance around start and goal from which every second configuration comes [rad or m].
RANGE, AROUND = 1.0, 1.0
#: Share of the distances of start and goal beyond the clearance that counts as margin, and margin per rad or m away from them.
SPARE, GROWTH = 0.9, 0.05
#: Number of checks between two looks at the clock and for interrupts.
SLICE = 2000
#: Number of random shortcuts, and of those between two looks at the clock.
SHORTCUTS, SOME = 60, 10
#: Number of nodes of each tree for which there is room at first.
ROOM = 2048
#: A number of crossings that no path has.
ANY = 1 << 40

_SIDE = np.dtype([("positive", np.uint8), ("known", np.uint8), ("changes", np.int64)], align=True)
_DECIDE = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.POINTER(ctypes.c_double), ctypes.c_double)
_P, _N, _D = ctypes.c_void_p, ctypes.c_long, ctypes.c_double
#: Result and arguments of the functions of connect.c.
SIGNATURES: dict[str, tuple[Any, ...]] = {
    "connect": (ctypes.c_int, _P, _N),
    "way": (_N, _P, _P),
    "skip": (_N, _P, _P, _P, _N),
    "shorten": (_N, _P, _P, _P, _N, _N),
}


class _Search(ctypes.Structure):
    """`Search` of connect.c."""

    _fields_ = [
        ("n", _N),
        *((name, _P) for name in ("low", "high", "near_low", "near_high", "world", "check", "decide")),
        *((name, _D) for name in ("clearance", "margin")),
        ("spare", _D * 2),
        *((name, _D) for name in ("growth", "step", "range")),
        ("sides", _N),
        *((name, _P) for name in ("values", "zero")),
        ("most_changes", _N),
        ("random", ctypes.c_uint64),
        ("room", _N),
        *((name, _P * 2) for name in ("node", "parent", "side")),
        ("size", _N * 2),
        ("met", _N * 2),
        ("turn", _N),
        ("checks", _N),
    ]


@cache
def _functions() -> dict[str, Callable[..., Any]] | None:
    """The compiled search; None where it cannot be compiled."""
    code = native_code(Path(__file__).with_name("connect.c"), "searches for paths")
    return None if code is None else code.functions("manipplan_", SIGNATURES)


def can_search(model: CollisionModel) -> bool:
    """Whether the compiled search is there for a robot among its obstacles."""
    return model.robot.n <= MOST_JOINTS and model.kernel_copy() is not None and _functions() is not None


@dataclass(frozen=True, kw_only=True, eq=False)
class TreeSearch:
    """A search by compiled code; only where `can_search`."""

    task: SeedTask

    def run(self, step: float, margin: float) -> Array | None:
        """Waypoints (k, n) of a path, or None when none was found.

        Motions are checked every `step` [rad or m], with `margin` [m] more than the clearance, but less near start and goal.
        """
        return _Run(self.task, step, margin).path()


class _Run:
    """The data of one search."""

    def __init__(self, task: SeedTask, step: float, margin: float) -> None:
        model = task.model
        functions, kernel = _functions(), model.kernel_copy()
        assert functions is not None and kernel is not None
        self.task, self.call, self.n = task, functions, model.robot.n
        self.failure: BaseException | None = None
        low, high = task.bounds()
        first, last = np.minimum(task.start, task.goal), np.maximum(task.start, task.goal)
        vectors = {"low": low, "high": high}
        vectors |= {"near_low": np.maximum(low, first - AROUND), "near_high": np.minimum(high, last + AROUND)}
        sides = task.sides if task.most_crossings is not None else None
        count = 0 if sides is None else len(sides.names)
        vectors["zero"] = np.zeros(0) if sides is None else sides.zero
        self.nodes = np.empty((2, ROOM, self.n))
        self.nodes[:, 0] = task.start, task.goal
        self.parents = np.full((2, ROOM), -1)
        self.sides = np.zeros((2, ROOM), dtype=_SIDE)
        if sides is not None:
            for tree, values in enumerate(sides.values(self.nodes[:, 0])):
                bits = 1 << np.arange(count)
                self.sides[tree, 0] = bits[values >= sides.zero].sum(), bits[np.abs(values) >= sides.zero].sum(), 0
        self._decide = _DECIDE(self._ask)
        self._values = _batch(sides)
        self._kept = {name: np.ascontiguousarray(vector, dtype=float) for name, vector in vectors.items()}, kernel
        self.search = _Search(
            n=self.n,
            world=kernel.world,
            check=kernel.check_address,
            decide=ctypes.cast(self._decide, ctypes.c_void_p),
            clearance=task.clearance,
            margin=margin,
            spare=(_D * 2)(*(SPARE * (model.least_distance(q[None])[0] - task.clearance) for q in (task.start, task.goal))),
            growth=GROWTH,
            step=step,
            range=RANGE,
            sides=count,
            values=None if self._values is None else ctypes.cast(self._values, ctypes.c_void_p),
            most_changes=ANY if task.most_crossings is None else task.most_crossings,
            random=task.seed,
            size=(_N * 2)(1, 1),
            **{name: vector.ctypes.data for name, vector in self._kept[0].items()},
        )
        self._set_room()

    def path(self) -> Array | None:
        """Waypoints (k, n), or None when none was found in time."""
        task, at = self.task, ctypes.addressof(self.search)
        status = SEARCHING
        while status != FOUND:
            left = SLICE if task.checks is None else min(SLICE, task.checks - self.search.checks)
            if left <= 0 or time.monotonic() >= task.deadline:
                return None
            status = self.call["connect"](at, left)
            if self.failure is not None:
                raise self.failure
            if status == FULL:
                self._grow()
        count = self.call["way"](at, None)
        way = np.empty((count + SHORTCUTS, self.n))
        work = np.empty_like(way)
        self.call["way"](at, way.ctypes.data)
        count = self.call["skip"](at, way.ctypes.data, work.ctypes.data, count)
        for _ in range(SHORTCUTS // SOME):
            if time.monotonic() < task.deadline + GRACE:
                count = self.call["shorten"](at, way.ctypes.data, work.ctypes.data, count, SOME)
        count = self.call["skip"](at, way.ctypes.data, work.ctypes.data, count)
        if self.failure is not None:
            raise self.failure
        return way[:count].copy()

    def _ask(self, q: Any, clearance: float) -> int:
        """Whether a configuration that the kernel cannot judge is free; an error is kept, since C cannot pass it on."""
        try:
            here = np.array(q[: self.n])
            return TOUCHING if self.task.model.in_collision(here, clearance=clearance) else FREE
        except BaseException as error:
            self.failure = error
            return TOUCHING

    def _grow(self) -> None:
        self.nodes, self.parents, self.sides = (np.concatenate([a, a], axis=1) for a in (self.nodes, self.parents, self.sides))
        self._set_room()

    def _set_room(self) -> None:
        self.search.room = self.nodes.shape[1]
        for name, arrays in (("node", self.nodes), ("parent", self.parents), ("side", self.sides)):
            setattr(self.search, name, (_P * 2)(*(each.ctypes.data for each in arrays)))


def _batch(sides: Sides | None) -> Any:
    """The values of the sides as a C function; without a compiler CasADi's virtual machine, called back, evaluates them."""
    if sides is None:
        return None
    if sides.kernel is not None:
        return sides.kernel.run

    def values(q: int, out: int, count: int) -> int:
        n, number = sides.function.nnz_in(0), len(sides.names)
        here = np.ctypeslib.as_array((ctypes.c_double * (count * n)).from_address(q)).reshape(count, n)
        found = np.ctypeslib.as_array((ctypes.c_double * (count * number)).from_address(out)).reshape(count, number)
        found[:] = np.array(sides.function(ca.DM(here.T))).T
        return 0

    return BATCH(values)
