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
    """The kernel for pairs of bodies.

    Args:
        robot: the arm.
        objects: its bodies and the obstacles.
        pairs: (k, 2) indices of those that are checked.
        radii: (g,) added all around each object [m].
        closed: the objects that are surfaces and solid inside.
    """
    code = load_kernel("distances")
    return DistanceKernel(code, world_arrays(_functions(code)["tree"], robot, objects, pairs, radii, closed))


class DistanceKernel:
    """Checks of one collision model by compiled code. Threads take turns, since it holds working memory; `copy` has its own."""

    def __init__(self, code: Kernel, arrays: Mapping[str, NDArray[Any]]) -> None:
        self._code, self._call = code, _functions(code)
        joints, self._n, self._bodies = len(arrays["axes"]), int(arrays["leader"].max(initial=-1)) + 1, arrays["pair_bodies"]
        self._arrays = dict(arrays) | {
            "frames": np.empty((joints + 1, 12)),
            "centres": arrays["ball"][:, :3].copy(),
            "least": np.full(len(self._bodies), np.inf),
            "found": np.empty(len(self._bodies), dtype=np.int64),
            "guess": np.zeros((len(self._bodies), GUESS)),
        }
        numbers = {
            "n": joints,
            "entries": self._n,
            "bodies": len(arrays["joint"]),
            "selves": len(arrays["self"]),
            "movers": len(arrays["mover"]),
            "groups": len(arrays["group"]),
            "pairs": len(self._bodies),
            "top": int(arrays["top"][0]),
        }
        pointers = {name: array.ctypes.data for name, array in self._arrays.items() if name not in ("pair_bodies", "top")}
        self._world = struct("distances", "World")(**numbers, **pointers)
        self._at = ctypes.addressof(self._world)
        self._lock = threading.Lock()
        self._q = np.zeros(self._n)
        self._q_at, self._check_one = self._q.ctypes.data, self._call["check_one"]

    @property
    def world(self) -> int:
        """The address of `World` of distances.c, for compiled code that uses it while no other thread does."""
        return self._at

    @property
    def n(self) -> int:
        """Length of a configuration."""
        return self._n

    @property
    def pairs(self) -> int:
        """Number of pairs."""
        return len(self._bodies)

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
            return int(self._check_one(self._at, self._q_at, clearance))

    def check_rows(self, q: Array, clearance: float) -> NDArray[np.int8]:
        """The same for every row of q (m, n)."""
        q = np.ascontiguousarray(q, dtype=float)
        verdicts = np.empty(len(q), dtype=np.int8)
        with self._lock:
            self._call["check"](self._at, q.ctypes.data, len(q), clearance, verdicts.ctypes.data)
        return verdicts

    def distances(self, q: Array, reach: Array) -> Array:
        """Distances (m, k) of all pairs at q (m, n), cut off at `reach` (m,) >= 0 [m]; nan where this kernel cannot tell."""
        q, reach = np.ascontiguousarray(q, dtype=float), np.ascontiguousarray(reach, dtype=float)
        found = np.empty((len(q), len(self._bodies)))
        with self._lock:
            self._call["distances"](self._at, q.ctypes.data, len(q), reach.ctypes.data, found.ctypes.data)
        return found

    def near(self, q: Array, reach: Array) -> tuple[Numbers, Array]:
        """row * pairs + pair and distance of all that is nearer than `reach` (m,) >= 0 [m] at q (m, n), in this order.

        The distance is nan where this kernel cannot tell.
        """
        q, reach, room = np.ascontiguousarray(q, dtype=float), np.ascontiguousarray(reach, dtype=float), ROOM * len(q)
        while True:
            where, found = np.empty(room, dtype=np.int64), np.empty(room)
            arguments = (q.ctypes.data, len(q), reach.ctypes.data, room, where.ctypes.data, found.ctypes.data)
            with self._lock:
                count = int(self._call["near"](self._at, *arguments))
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
        with self._lock:
            known = self._call["least"](self._at, q.ctypes.data, len(q), reach, coarse, *results)
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
        arrays = [np.ascontiguousarray(each[order], dtype=float) for each in (q, slopes, reach, bends, motions)]
        inputs, bodies = [each.ctypes.data for each in arrays], self.bodies(pairs[order])
        found, bound = np.empty(len(q)), np.empty(len(q))
        with self._lock:
            self._call["intervals"](
                self._at, *inputs[:2], len(q), bodies.ctypes.data, *inputs[2:], found.ctypes.data, bound.ctypes.data
            )
        found[order], bound[order] = found.copy(), bound.copy()
        return found, bound

    def witnesses(self, q: Array, pairs: Numbers, leaves: Numbers) -> Array:
        """For pairs (m,) at q (m, n), (m, 13 + n): as `manipplan_witnesses` says; nan where this kernel cannot tell."""
        order = np.argsort(pairs, kind="stable")
        q, bodies, leaves = (
            np.ascontiguousarray(q[order], dtype=float),
            self.bodies(pairs[order]),
            np.ascontiguousarray(leaves[order]),
        )
        found = np.empty((len(q), 13 + self._n))
        with self._lock:
            self._call["witnesses"](self._at, q.ctypes.data, len(q), bodies.ctypes.data, leaves.ctypes.data, found.ctypes.data)
        found[order] = found.copy()
        return found

    def nearest_triangle(self, q: Array, pair: int) -> Array | None:
        """Corners (3, 3) of the triangle of a pair's second body nearest to the first at q (n,); None if it has none."""
        one = np.ascontiguousarray(q, dtype=float)[None]
        leaf = int(self._pairs(one, self._bodies[pair : pair + 1], np.full(1, np.inf))[1][0])
        return self._arrays["corners"][leaf].reshape(3, 3) if leaf >= 0 else None

    def _pairs(self, q: Array, bodies: Numbers, reach: Array) -> tuple[Array, Numbers]:
        found, leaf, reach = np.empty(len(q)), np.empty(len(q), dtype=np.int64), np.ascontiguousarray(reach, dtype=float)
        arguments = (q.ctypes.data, len(q), bodies.ctypes.data, reach.ctypes.data, found.ctypes.data, leaf.ctypes.data)
        with self._lock:
            self._call["pairs"](self._at, *arguments)
        return found, leaf
