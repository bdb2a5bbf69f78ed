"""The compiled kernel that decides collisions and measures distances: `distances.c`, with the arrays of one collision model."""

import ctypes
import threading
from collections.abc import Callable, Collection, Mapping, Sequence
from functools import cache
from typing import Any

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.world import Numbers, world_arrays
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.kernels import Kernel, load_kernel, struct

#: As in distances.c.
FREE, TOUCHING, UNDECIDED = range(3)
#: Numbers that are kept per pair from one configuration to the next; as in distances.c.
GUESS = 22
#: Initial room for near pairs per configuration.
ROOM = 64


@cache
def _functions(code: Kernel) -> Mapping[str, Callable[..., Any]]:
    return code.functions(quick=("check_one",))


def kernel_of(
    robot: Robot, objects: Sequence[pin.GeometryObject], pairs: Numbers, radii: Array, closed: Collection[int]
) -> "DistanceKernel":
    """The kernel for pairs (k, 2) of an arm's bodies and obstacles, the objects (g).

    `radii` (g,) are added all around each [m]; `closed` are the indices of surfaces that are solid inside.
    """
    code = load_kernel("distances")
    return DistanceKernel(code, world_arrays(_functions(code)["tree"], robot, objects, pairs, radii, closed))


class DistanceKernel:
    """Checks of one collision model by compiled code. Threads take turns, since it holds working memory; `copy` has its own.

    Attributes:
        n: length of a configuration.
        pairs: number of pairs.
        world: the address of `World` of distances.c, for compiled code that uses it while no other thread does.
    """

    def __init__(self, code: Kernel, arrays: Mapping[str, NDArray[Any]]) -> None:
        self._code, self._call = code, _functions(code)
        joints, self.n, self._bodies = len(arrays["axes"]), int(arrays["leader"].max(initial=-1)) + 1, arrays["pair_bodies"]
        self.pairs = len(self._bodies)
        self._arrays = dict(arrays) | {
            "frames": np.empty((joints + 1, 12)),
            "centres": arrays["ball"][:, :3].copy(),
            "least": np.full(self.pairs, np.inf),
            "found": np.empty(self.pairs, dtype=np.int64),
            "guess": np.zeros((self.pairs, GUESS)),
        }
        numbers = {
            "n": joints,
            "entries": self.n,
            "bodies": len(arrays["joint"]),
            "blocks": len(arrays["block"]),
            "movers": len(arrays["mover"]),
            "groups": len(arrays["group"]),
            "pairs": self.pairs,
            "top": int(arrays["top"][0]),
        }
        pointers = {name: array.ctypes.data for name, array in self._arrays.items() if name not in ("pair_bodies", "top")}
        self._world = struct("distances", "World")(**numbers, **pointers)
        self.world = ctypes.addressof(self._world)
        self._lock = threading.Lock()
        self._q = np.zeros(self.n)
        self._q_at, self._check_one = self._q.ctypes.data, self._call["check_one"]

    def address(self, name: str) -> int:
        """The address of the function `manipplan_` and a name."""
        return self._code.address(name)

    def bodies(self, pairs: Numbers) -> Numbers:
        """The two bodies (m, 2) of pairs (m,), as `manipplan_pairs` takes them."""
        return np.ascontiguousarray(self._bodies[pairs])

    def copy(self) -> "DistanceKernel":
        """The same with its own working memory, for another thread."""
        return DistanceKernel(self._code, self._arrays)

    def check(self, q: Array, clearance: float) -> int:
        """FREE, TOUCHING or UNDECIDED at q (n,): whether any pair is as near as `clearance` [m]."""
        with self._lock:
            self._q[:] = q
            return int(self._check_one(self.world, self._q_at, clearance))

    def _run(self, name: str, *arguments: Any) -> Any:
        """Call a function of distances.c with the world; it gets the addresses of arrays."""
        given = [each.ctypes.data if isinstance(each, np.ndarray) else each for each in arguments]
        with self._lock:
            return self._call[name](self.world, *given)

    def check_rows(self, q: Array, clearance: float) -> NDArray[np.int8]:
        """The same for every row of q (m, n)."""
        q, verdicts = np.ascontiguousarray(q, dtype=float), np.empty(len(q), dtype=np.int8)
        self._run("check", q, len(q), clearance, verdicts)
        return verdicts

    def distances(self, q: Array, reach: Array) -> Array:
        """Distances (m, k) of all pairs at q (m, n), cut off at `reach` (m,) >= 0 [m]; nan where this kernel cannot tell."""
        q, reach = np.ascontiguousarray(q, dtype=float), np.ascontiguousarray(reach, dtype=float)
        found = np.empty((len(q), self.pairs))
        self._run("distances", q, len(q), reach, found)
        return found

    def near(self, q: Array, reach: Array) -> tuple[Numbers, Array]:
        """row * pairs + pair and distance of all that is nearer than `reach` (m,) >= 0 [m] at q (m, n), in this order.

        The distance is nan where this kernel cannot tell.
        """
        q, reach, room = np.ascontiguousarray(q, dtype=float), np.ascontiguousarray(reach, dtype=float), ROOM * len(q)
        while True:
            where, found = np.empty(room, dtype=np.int64), np.empty(room)
            count = int(self._run("near", q, len(q), reach, room, where, found))
            if count <= room:
                order = np.argsort(where[:count], kind="stable")
                return where[:count][order], found[:count][order]
            room = count

    def least(self, q: Array, reach: float, coarse: int) -> tuple[float, int, int] | None:
        """The smallest distance [m] at all q (m, n), its row and its pair; None where this kernel cannot tell.

        The pair is -1 where all distances are above `reach` [m]. Every `coarse`-th row is measured first.
        """
        q, least, row, pair = np.ascontiguousarray(q, dtype=float), ctypes.c_double(), ctypes.c_long(), ctypes.c_long()
        results = [ctypes.addressof(each) for each in (least, row, pair)]
        known = self._run("least", q, len(q), reach, coarse, *results)
        return (least.value, row.value, pair.value) if known else None

    def pair_distances(self, q: Array, pairs: Numbers, reach: Array) -> Array:
        """Distance (m,) of one pair at each configuration: of pairs (m,) at q (m, n), cut off at `reach` (m,) >= 0 [m].

        nan where this kernel cannot tell.
        """
        return self._pairs(np.ascontiguousarray(q, dtype=float), self.bodies(pairs), reach)[0]

    def interval_bounds(
        self, q: Array, slopes: Array, pairs: Numbers, reach: Array, bends: Array, motions: Array
    ) -> tuple[Array, Array]:
        """The same, with lower bounds (m,) of the distances while the joints move, as `manipplan_intervals` says."""
        order = np.argsort(pairs, kind="stable")  # the nearest triangle of a pair is a first guess for the next
        q, slopes, *others = (np.ascontiguousarray(each[order], dtype=float) for each in (q, slopes, reach, bends, motions))
        found, bound = np.empty(len(q)), np.empty(len(q))
        self._run("intervals", q, slopes, len(q), self.bodies(pairs[order]), *others, found, bound)
        found[order], bound[order] = found.copy(), bound.copy()
        return found, bound

    def witnesses(self, q: Array, pairs: Numbers, leaves: Numbers) -> Array:
        """For pairs (m,) at q (m, n), (m, 13 + n): as `manipplan_witnesses` says; nan where this kernel cannot tell."""
        order = np.argsort(pairs, kind="stable")
        q, leaves = np.ascontiguousarray(q[order], dtype=float), np.ascontiguousarray(leaves[order])
        found = np.empty((len(q), 13 + self.n))
        self._run("witnesses", q, len(q), self.bodies(pairs[order]), leaves, found)
        found[order] = found.copy()
        return found

    def nearest_triangle(self, q: Array, pair: int) -> Array | None:
        """Corners (3, 3) of the triangle of a pair's second body nearest to the first at q (n,); None if it has none."""
        one = np.ascontiguousarray(q, dtype=float)[None]
        leaf = int(self._pairs(one, self._bodies[pair : pair + 1], np.full(1, np.inf))[1][0])
        return self._arrays["corners"][leaf].reshape(3, 3) if leaf >= 0 else None

    def _pairs(self, q: Array, bodies: Numbers, reach: Array) -> tuple[Array, Numbers]:
        found, leaf = np.empty(len(q)), np.empty(len(q), dtype=np.int64)
        self._run("pairs", q, len(q), bodies, np.ascontiguousarray(reach, dtype=float), found, leaf)
        return found, leaf
