"""RRT-Connect in compiled code, which counts crossings of singularities: `connect.c` on the collision kernel.

Its check of straight motions, one call for each motion, serves the planners of OMPL, too.

connect-star: our own RRT-Connect, which goes on to lower the cost of its path, its length or g, until its checks are used up.

The path is changed at random, by shortcuts and detours (`star.c`), until that gains little. Then new trees look for a path that
costs less than the best one [wilson2025]: a node is added only where its cost from its root allows such a path, and random
configurations come from the ellipsoid of shorter paths [gammell2014] where the cost is the length. Each search without success
is followed by one with twice as many checks, so that with more and more checks every cheaper path is found at last.
"""

import ctypes
from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

import numpy as np

from manipplan.collision.kernel import FREE, TOUCHING
from manipplan.collision.model import CollisionModel
from manipplan.constraints.constraint_set import POSE, ConstraintSet, OwnRows
from manipplan.cost.integral import PathIntegral, metric_matrix
from manipplan.kinematics.batch import BATCH
from manipplan.paths.rounding import gauss_rule
from manipplan.seeds.task import PATIENCE, Level, SeedTask
from manipplan.support.checks import Array
from manipplan.support.deadline import work_time
from manipplan.support.kernels import load_kernel, struct

#: Value to which a projection leads a row that is broken [rad or m], since edges between such configurations cut corners; at
#: most this share of the largest value that the row has at random configurations.
AIM, SHARE = 0.02, 0.2
#: Share of that which checked configurations keep, but no more than start and goal have: a path may come lower between them.
LEAST_ROW = 0.1
#: Number of random configurations at which these values are taken.
SAMPLES = 200
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
        self._callbacks: list[Any] = []
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
        constraints = None if task.constraints is None else self._search_constraints(task.constraints)
        self._q: Any = (ctypes.c_double * (2 * self.n))()
        self._owners = vectors, kernel, signs, constraints
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
            range=RANGE if constraints is None else CONSTRAINED_RANGE,
            constraints=None if constraints is None else ctypes.addressof(constraints[0]),
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

    def _search_constraints(self, constraints: ConstraintSet) -> tuple[ctypes.Structure, tuple[Any, ...]] | None:
        """`Constraints` of constraints.h, and everything that it points to; None where there are only held joints."""
        if not constraints.count:
            return None
        q = constraints.robot.random_configuration(np.random.default_rng(0), size=SAMPLES)
        aim = np.asarray(np.clip(SHARE * constraints.values(q).max(axis=0), 0.0, AIM))
        weights = np.ascontiguousarray(constraints.weights)
        least = np.minimum(LEAST_ROW * aim, constraints.values(self.roots).min(axis=0))
        work = np.empty(POSE + 6 * self.n + (constraints.count + 1) * (self.n + 1))
        tool, own = constraints.tool, constraints.own
        data = struct("connect", "Constraints")(
            n=self.n,
            rows=constraints.count,
            of_tool=len(weights),
            weights=weights.ctypes.data,
            tool=(0, 0) if tool is None else tool.kernel.batch,
            own=(0, 0) if own is None else self.guarded(_of_own(own)),
            least=least.ctypes.data,
            aim=aim.ctypes.data,
            work=work.ctypes.data,
        )
        return data, (weights, least, aim, work, tool)

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

    def guarded(self, function: Callable[[Array], Array]) -> tuple[int, int]:
        """The fields of a `Batch` of csrc/batch.h that calls a function of configurations (m, n).

        Its values are stored row by row; they have to be finite. An error of it is stored for `raise_failure`; the call then
        returns 1.
        """

        def answer(_: int, q: int, out: int, count: int) -> int:
            try:
                here: Array = np.ctypeslib.as_array((ctypes.c_double * (count * self.n)).from_address(q))
                values = function(here.reshape(count, self.n)).ravel()
                np.ctypeslib.as_array((ctypes.c_double * len(values)).from_address(out))[:] = values
                return int(not np.isfinite(values).all())
            except BaseException as error:
                self._failure = error
                return 1

        callback = BATCH(answer)
        self._callbacks.append(callback)
        return ctypes.cast(callback, ctypes.c_void_p).value or 0, 0

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


def _of_own(own: OwnRows) -> Callable[[Array], Array]:
    """The rows of a user's class, and then their gradients."""
    return lambda q: np.hstack([own.value.by_columns(q), own.gradient.by_columns(q)])


#: As in connect.c.
SEARCHING, FOUND, FULL = range(3)
#: Number of checks between two looks at the clock and for interrupts.
SLICE = 2000
#: Number of random shortcuts, and of those between two looks at the clock.
SHORTCUTS, SOME = 60, 10
#: Number of nodes of each tree for which there is room at first.
TREE_ROOM = 2048


class TreeSearch:
    """A search by compiled code; only where `can_check`. Motions are checked as `levels` tell, one after another."""

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
                self._grow()
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

    def _grow(self) -> None:
        """Make room for twice as many nodes."""
        arrays = self.nodes, self.parents, self.sides, self.costs
        self.nodes, self.parents, self.sides, self.costs = (np.concatenate([a, a], axis=1) for a in arrays)
        self._set_room()

    def _set_room(self) -> None:
        self.search.room = self.nodes.shape[1]
        named = {"node": self.nodes, "parent": self.parents, "side": self.sides, "cost": self.costs}
        for name, arrays in named.items():
            setattr(self.search, name, (ctypes.c_void_p * 2)(*(each.ctypes.data for each in arrays)))


#: Maximum length of the panels in which a motion is integrated [rad or m], and number of Gauss points per panel.
PANEL = 0.2
POINTS = 5
#: Lower bound on the manipulability in the cost: a motion through a singularity is expensive, but its cost is finite.
LEAST = 1e-12
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


class StarSearch(TreeSearch):
    """A search that lowers the cost of its path.

    Args:
        task: with the maximum number of checks; a random change of the path counts as one.
        levels: as above.
        integral: the cost; None: the length.
    """

    def __init__(self, task: SeedTask, levels: Sequence[Level], integral: PathIntegral | None) -> None:
        super().__init__(task, levels)
        self.integral = integral

    def path(self) -> Array | None:
        """Waypoints (k, n) of the best path that the checks and the time allow, or None when none was found."""
        found = super().path()
        if found is None:
            return None
        self.prepare()
        best, cost = self._change(found)
        checks = EXPLORE
        while not self._is_over():
            cheaper = self._cheaper(cost, checks)
            if cheaper is None:
                checks *= 2
                continue
            other, least = self._change(cheaper)
            if least < cost:
                best, cost = other, least
        return best

    def prepare(self) -> None:
        """Let the search count costs from now on."""
        search, task, integral = load_kernel("connect"), self.task, self.integral
        self.search.level = max(self.search.level, self.search.levels - 2)  # the last level's paths nearly touch
        self.search.levels = self.search.level + 1
        nodes, weights = gauss_rule(POINTS)
        metric = None if integral is None or integral.metric is None else metric_matrix("metric", integral.metric, self.n)
        self._owners = nodes, weights, metric, integral
        self.star = struct("star", "Star")(
            n=self.n,
            low=self.search.low,
            high=self.search.high,
            metric=None if metric is None else metric.ctypes.data,
            measure=(0, 0) if integral is None else _measure(integral, self.check),
            floor=0.0 if integral is None else integral.floor,
            power=1.0 if integral is None else integral.power,
            least=LEAST,
            panel=PANEL,
            points=POINTS,
            nodes=nodes.ctypes.data,
            weights=weights.ctypes.data,
            search=self.check.at,
            clear=search.address("clear"),
            allowed=search.address("allowed"),
            reach=REACH,
            random=task.seed,
        )
        self.star_at = ctypes.addressof(self.star)
        self.search.star, self.search.cost_of = self.star_at, load_kernel("star").address("edge_cost")
        self.search.rate = 1.0 if integral is None else 0.0  # the largest m of an arm is not known

    def _is_over(self) -> bool:
        checks = self.task.checks
        return work_time() >= self.task.deadline or (checks is not None and self.check.checks >= checks)

    def _change(self, way: Array) -> tuple[Array, float]:
        """A path (k, n) of lower cost by random changes, and its cost."""
        room = max(STAR_ROOM, len(way))
        points, work, count = np.empty((room, self.n)), np.empty((room, self.n)), len(way)
        points[:count] = way
        cost = self._cost(points[:count])
        while not self._is_over():
            count = _functions()["improve"](self.star_at, points.ctypes.data, work.ctypes.data, count, room, CHANGES)
            self.check.raise_failure()
            self.search.checks += CHANGES
            before, cost = cost, self._cost(points[:count])
            if cost > (1 - STALLED) * before:
                break
        return points[:count].copy(), cost

    def _cost(self, way: Array) -> float:
        cost = float(_functions()["way_cost"](self.star_at, way.ctypes.data, len(way)))
        self.check.raise_failure()
        return cost

    def _cheaper(self, cost: float, checks: int) -> Array | None:
        """A path (k, n) that costs less, found by new trees; None when none was found."""
        search, call, end = self.search, self.call, self.search.checks + checks
        search.size, search.bound, search.turn = (ctypes.c_long * 2)(1, 1), cost, 0
        while not self._is_over() and search.checks < end:
            left = min(SLICE, end - search.checks)
            if self.task.checks is not None:
                left = min(left, self.task.checks - search.checks)
            status = call["connect"](self.check.at, left)
            self.check.raise_failure()
            if status == FULL:
                self._grow()
            if status == FOUND:
                way = np.empty((call["way"](self.check.at, None), self.n))
                call["way"](self.check.at, way.ctypes.data)
                return way
        return None


def _measure(integral: PathIntegral, check: MotionCheck) -> tuple[int, int]:
    """The fields of a `Batch` of csrc/batch.h that gives m; one with operations that kernels do not know is called back."""
    kinematics = integral.kinematics
    batch = kinematics.batch_code("manipulability")
    return check.guarded(kinematics.manipulability) if batch is None else batch
