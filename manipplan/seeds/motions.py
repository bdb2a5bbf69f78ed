"""The check of straight motions in compiled code: `connect.c` on the collision kernel, one call for each motion.

The constraints of a search as its compiled code takes them: `Constraints` of constraints.h.
"""

import ctypes
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from manipplan.collision.kernel import FREE, TOUCHING
from manipplan.collision.model import CollisionModel
from manipplan.constraints.built_in import POSE
from manipplan.constraints.constraint_set import ConstraintSet, OwnRows
from manipplan.kinematics.batch import BATCH
from manipplan.seeds.task import SeedTask
from manipplan.support.checks import Array
from manipplan.support.compiling.declarations import struct
from manipplan.support.compiling.kernels import load_kernel
from manipplan.support.deadline import work_time

#: The compiled search.
#: Value to which a projection leads a row that is broken [rad or m], since edges between such configurations cut corners; at
#: most this share of the largest value that the row has at random configurations.
AIM, SHARE = 0.02, 0.2
#: Share of that which checked configurations keep, but no more than start and goal have: a path may come lower between them.
LEAST = 0.1
#: Number of those.
SAMPLES = 200


@dataclass(frozen=True, kw_only=True, eq=False)
class SearchConstraints:
    """Constraints for compiled code, with everything that it points to."""

    data: ctypes.Structure
    kept: tuple[Any, ...]

    @classmethod
    def of(
        cls, constraints: ConstraintSet, ends: Array, guarded: Callable[[Callable[[int, int, int], int]], Any]
    ) -> "SearchConstraints | None":
        """The rows of constraints; None where there are only held joints.

        `ends` (2, n) are start and goal, and `guarded` makes functions that C can call back.
        """
        if not constraints.count:
            return None
        n = constraints.robot.n
        weights, aim = np.ascontiguousarray(constraints.weights), _aim(constraints)
        least = np.minimum(LEAST * aim, constraints.values(ends).min(axis=0))
        work = np.empty(POSE + 6 * n + (constraints.count + 1) * (n + 1))
        tool, others = None, None
        if constraints.tool is not None:
            tool = constraints.tool.kernel
        if constraints.own is not None:
            others = guarded(_own(n, constraints.own))
        data = struct("connect", "Constraints")(
            n=n,
            rows=constraints.count,
            of_tool=len(weights),
            weights=weights.ctypes.data,
            tool=(0, 0) if tool is None else tool.batch,
            own=called_back(others),
            least=least.ctypes.data,
            aim=aim.ctypes.data,
            work=work.ctypes.data,
        )
        return cls(data=data, kept=(weights, least, aim, work, tool, others))

    @property
    def address(self) -> int:
        """Where the structure is."""
        return ctypes.addressof(self.data)


def _aim(constraints: ConstraintSet) -> Array:
    q = constraints.robot.random_configuration(np.random.default_rng(0), size=SAMPLES)
    return np.asarray(np.clip(SHARE * constraints.values(q).max(axis=0), 0.0, AIM))


def called_back(function: Any) -> tuple[int, int]:
    """The fields of a `Batch` of csrc/batch.h that calls a BATCH; None: of none."""
    return ctypes.cast(function, ctypes.c_void_p).value or 0, 0


def _own(n: int, own: OwnRows) -> Callable[[int, int, int], int]:
    """The rows of a user's class, and then their gradients, for n joints."""

    def values(q: int, out: int, count: int) -> int:
        here = _array(q, count, n)
        found = np.hstack([own.value.by_columns(here), own.gradient.by_columns(here)])
        _array(out, count, own.count * (n + 1))[:] = found
        return 0 if np.isfinite(found).all() else 1

    return values


def _array(address: int, rows: int, columns: int) -> Array:
    numbers: Array = np.ctypeslib.as_array((ctypes.c_double * (rows * columns)).from_address(address))
    return numbers.reshape(rows, columns)


#: As in connect.c.
MOST_JOINTS = 64
#: Maximum length of an edge, and with constraints, whose edges are nearly tangential to what they allow [rad or m].
RANGE, CONSTRAINED_RANGE = 1.0, 0.3
#: Share of the random configurations that come from a box around start and goal, and its maximum distance from them [rad or m].
NEAR, AROUND = 0.8, 3.0
#: Share of the distances of start and goal beyond the clearance that counts as margin, and margin per rad or m away from them.
SPARE, GROWTH = 0.9, 0.05
#: A number of crossings that no path has.
ANY = 1 << 40

SIDE = np.dtype([("positive", np.uint8), ("known", np.uint8), ("changes", np.int64)], align=True)
_DECIDE = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.POINTER(ctypes.c_double), ctypes.c_double)
#: Functions that hold the GIL: to release it would take longer than what they do.
QUICK = ("state", "motion_is_free")


@dataclass(frozen=True, kw_only=True)
class Level:
    """How motions are checked until `checks` further configurations were checked; the last level goes on.

    Attributes:
        step: maximum motion of a joint between two checks [rad or m].
        margin: distance beyond the clearance [m]; less near start and goal, where they have less.
        checks: number of configurations.
    """

    step: float
    margin: float
    checks: int = 0


@cache
def functions() -> dict[str, Callable[..., Any]]:
    """The functions of connect.c."""
    return load_kernel("connect").functions(quick=QUICK)


def can_check(model: CollisionModel) -> bool:
    """Whether the compiled check serves a robot among its obstacles."""
    return model.robot.n <= MOST_JOINTS


class MotionCheck:
    """Checks configurations and straight motions of a search; only where `can_check`. Not safe to share between threads.

    Attributes:
        data: `Search` of connect.c, with room for nothing but the roots of both trees.
        deadline: in `work_time` [s]; past it, what only coal can decide counts as touching.
    """

    def __init__(self, task: SeedTask, levels: Sequence[Level]) -> None:
        model, kernel = task.model, task.model.kernel_copy()
        self.call, self._task, self.n = functions(), task, model.robot.n
        self.deadline = task.deadline
        self._failure: BaseException | None = None
        low, high = task.bounds()
        signs = task.signs if task.most_crossings is not None else None
        vectors: dict[str, Any] = {"low": low, "high": high, "zero": np.zeros(0) if signs is None else signs.zero}
        vectors |= {"step": [each.step for each in levels], "margin": [each.margin for each in levels]}
        vectors = {name: np.ascontiguousarray(vector, dtype=float) for name, vector in vectors.items()}
        vectors["until"] = np.cumsum([each.checks for each in levels])
        self.roots = np.array([task.start, task.goal], dtype=float)
        self.root_sides = np.zeros(2, dtype=SIDE)
        if signs is not None:
            bits = 1 << np.arange(len(signs.names))
            for root, values in zip(self.root_sides, signs.values(self.roots), strict=True):
                root["positive"], root["known"] = bits[values >= signs.zero].sum(), bits[np.abs(values) >= signs.zero].sum()
        self._decide = _DECIDE(self._ask)
        self._constraints = None
        if task.constraints is not None:
            self._constraints = SearchConstraints.of(task.constraints, self.roots, self.guarded)
        self._q: Any = (ctypes.c_double * (2 * self.n))()
        self._kept = vectors, kernel, signs
        self.data = struct("connect", "Search")(
            n=self.n,
            near=NEAR,
            around=AROUND,
            world=kernel.world,
            check=kernel.address("check_one"),
            decide=ctypes.cast(self._decide, ctypes.c_void_p),
            clearance=task.clearance,
            levels=len(levels),
            spare=(ctypes.c_double * 2)(*(SPARE * (distance - task.clearance) for distance in task.distances)),
            growth=GROWTH,
            range=RANGE if self._constraints is None else CONSTRAINED_RANGE,
            constraints=None if self._constraints is None else self._constraints.address,
            sides=0 if signs is None else len(signs.names),
            values=(0, 0) if signs is None else signs.kernel.batch,
            most_changes=ANY if task.most_crossings is None else task.most_crossings,
            bound=np.inf,
            random=task.seed,
            size=(ctypes.c_long * 2)(1, 1),
            node=(ctypes.c_void_p * 2)(*(each.ctypes.data for each in self.roots)),
            side=(ctypes.c_void_p * 2)(*(self.root_sides[k : k + 1].ctypes.data for k in range(2))),
            **{name: vector.ctypes.data for name, vector in vectors.items()},
        )
        self.at = ctypes.addressof(self.data)
        self._places = ctypes.addressof(self._q), ctypes.addressof(self._q) + self.n * ctypes.sizeof(ctypes.c_double)

    @property
    def checks(self) -> int:
        """Number of configurations checked for collision."""
        return int(self.data.checks)

    def configuration(self, q: list[float]) -> bool:
        """Whether a configuration of n joint values [rad or m] is free."""
        self._q[: self.n] = q
        found = self.call["state"](self.at, self._places[0])
        self.raise_failure()
        return bool(found)

    def motion(self, first: list[float], last: list[float]) -> bool:
        """Whether the straight motion from one configuration, which is free, to another is free."""
        self._q[: self.n], self._q[self.n :] = first, last
        found = self.call["motion_is_free"](self.at, *self._places)
        self.raise_failure()
        return bool(found)

    def raise_failure(self) -> None:
        """Raise the error of an answer of coal: C cannot pass it on."""
        if self._failure is not None:
            raise self._failure

    def guarded(self, values: Callable[[int, int, int], int]) -> Any:
        """A function that C calls back: an error is kept for `raise_failure`, and the answer is then 1."""

        def answer(_: int, q: int, out: int, count: int) -> int:
            try:
                return values(q, out, count)
            except BaseException as error:
                self._failure = error
                return 1

        return BATCH(answer)

    def _ask(self, q: Any, clearance: float) -> int:
        """Whether a configuration that the kernel cannot judge is free."""
        try:
            if work_time() >= self.deadline:
                return TOUCHING
            here: Array = np.array(q[: self.n])
            return TOUCHING if self._task.model.in_collision(here, clearance=clearance) else FREE
        except BaseException as error:
            self._failure = error
            return TOUCHING
