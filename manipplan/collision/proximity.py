"""Where pairs of bodies are near along a curve, by the compiled `near_pairs.c`; coal tells what the kernel cannot."""

import ctypes
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from manipplan.collision.model import CollisionModel
from manipplan.paths.joint import Curve
from manipplan.paths.rounding import FINE, FINE_DISTANCE, on_grid
from manipplan.support.checks import Array
from manipplan.support.kernels import load_kernel, struct

#: Number of intervals of the grid along the curve. A band around the target is only searched at every SPACING-th place.
INTERVALS, SPACING = 160, 4
#: Distance above the target at which distances are cut off [m]; at every SPACING-th place a wider band raises it.
FARTHEST = 0.03
#: Distance above the target below which dips are located [m].
DEEP = 1e-3
#: Distance above the target below which every place of the grid is returned [m].
CLOSE = 2e-3
#: Maximum number of dips that are located, the lowest: a turning part with many corners, close to another, has hundreds.
MOST_DIPS = 160
#: Maximum number of triangles or points of a surface whose dips are located where it is near, and how much farther than the
#: nearest they may be [m]. As a path moves one of them becomes the nearest, and the body's distance has a kink there.
MOST_LEAVES, FARTHER = 8, 1e-3
#: Accuracy of the place of a bottom in s.
BOTTOM = 1e-6
#: Maximum number of steps to the bottom of a dip. Where the nearest features change at the bottom, it is a kink that is rounded
#: over 1e-4 of s only, and a gradient from beside it is that of one feature alone.
BOTTOM_STEPS = 40
#: As in near_pairs.c.
ASKING, MORE_ROOM = -1, -2
#: Initial room for near pairs per place of the grid.
ROOM = 16

_BRACKET = np.dtype(
    [
        *((name, float) for name in ("low", "middle", "high", "left", "least", "right", "next", "found")),
        *((name, int) for name in ("steps", "pair", "leaf")),
    ]
)
_FOUND = np.dtype([("distance", float), ("s", float), ("pair", int), ("leaf", int), ("is_bottom", int)])

Place = tuple[float, int]


@cache
def _call() -> Callable[..., int]:
    return load_kernel("near_pairs").functions()["near_pairs"]


@dataclass(frozen=True, kw_only=True)
class ProximitySamples:
    """Distances measured on one curve, the smallest first; (k,) each.

    Attributes:
        distances: signed distances [m].
        s: places on the curve.
        pairs: indices of the pairs.
        leaves: the triangle or point of a surface that the distance is to; -1: the nearest, or the body is no surface.
        is_bottom: whether the distance has a minimum along the curve there.
    """

    distances: Array
    s: Array
    pairs: NDArray[np.intp]
    leaves: NDArray[np.intp]
    is_bottom: NDArray[np.bool_]

    @property
    def least(self) -> float:
        """The smallest distance [m]; inf where nothing is near."""
        return float(self.distances[0]) if len(self.distances) else np.inf


class DistanceSearch:
    """Searches along curves for the places where pairs of bodies are near; for one thread."""

    def __init__(self, model: CollisionModel) -> None:
        """`model` is the arm among its obstacles."""
        kernel = model.kernel_copy()
        self.model, self._kernel = model, kernel
        self._dips = struct("near_pairs", "Dips")(
            n=kernel.n,
            curve_at=load_kernel("curves").address("curve"),
            spacing=FINE,
            world=kernel.world,
            distance=kernel.address("pair"),
            distance_of_leaf=kernel.address("leaf"),
            grid=FINE_DISTANCE,
            enough=BOTTOM,
            most_steps=BOTTOM_STEPS,
        )
        self._arrays: dict[str, NDArray[Any]] = {}
        self._found = np.empty(0, dtype=_FOUND)
        self._scan = self._with_room(ROOM * (INTERVALS + 1), 0)

    def find_near(self, curve: Curve, target: float, band: float, known: Sequence[Place] = ()) -> ProximitySamples:
        """Places where a pair is near.

        These are the places of the grid nearer than the target plus CLOSE, every SPACING-th place nearer than the target plus
        `band`, and the bottoms of dips.

        Args:
            curve: the curve of configurations, of a degree of at most `curves.MOST_DEGREE`.
            target: distance to keep [m].
            band: see above [m].
            known: places (s, pair) around which there is always a search for a dip.
        """
        at, pairs = np.array([x for x, _ in known], dtype=float), np.array([pair for _, pair in known], dtype=np.int64)
        if len(self._arrays["bracket"]) < self._scan.room + len(known):
            self._scan = self._with_room(self._scan.room, len(known))
        self._dips.curve = curve.address
        while True:
            scan = self._scan
            scan.stage, scan.target = 0, target
            scan.known, scan.known_s, scan.known_pair = len(known), at.ctypes.data, pairs.ctypes.data
            arguments = (ctypes.addressof(self._dips), ctypes.addressof(scan), band, self._found.ctypes.data)
            while (count := _call()(*arguments)) == ASKING:
                self._answer(curve)
            if count != MORE_ROOM:
                break
            self._scan = self._with_room(2 * scan.room, len(known))
        found = self._found[:count].copy()
        return ProximitySamples(
            distances=found["distance"],
            s=found["s"],
            pairs=found["pair"],
            leaves=found["leaf"],
            is_bottom=found["is_bottom"].astype(bool),
        )

    def _answer(self, curve: Curve) -> None:
        """Put distances in place of those that the kernel cannot tell."""
        if self._scan.stage == 1:
            where, distances = (self._arrays[name][: self._scan.entries] for name in ("where", "distance"))
            asked = np.flatnonzero(np.isnan(distances))
            rows, pairs = np.divmod(where[asked], self._kernel.pairs)
            distances[asked] = self.model.pair_distances(self._arrays["q"][rows], pairs)
            return
        brackets = self._arrays["bracket"][: self._scan.dips]
        pairs = brackets["pair"]
        for name, at in (("left", "low"), ("least", "middle"), ("right", "high")):
            self._measure(curve, brackets, pairs, name, at, np.isnan(brackets[name]))
        self._measure(curve, brackets, pairs, "found", "next", ~np.isnan(brackets["next"]))

    def _measure(
        self, curve: Curve, brackets: NDArray[np.void], pairs: NDArray[np.int64], name: str, at: str, asked: NDArray[np.bool_]
    ) -> None:
        """Put the distances at places of the brackets that are asked for, rounded as `near_pairs.c` rounds its own."""
        q = curve(brackets[at][asked], FINE)
        brackets[name][asked] = on_grid(self.model.pair_distances(q, pairs[asked]), FINE_DISTANCE)

    def _with_room(self, room: int, known: int) -> ctypes.Structure:
        """Working memory for a number of near pairs, `room`, and of `known` places."""
        count, pairs = INTERVALS + 1, self._kernel.pairs
        self._found = np.empty(room + (1 + MOST_LEAVES) * (2 * room + known), dtype=_FOUND)
        self._arrays = {
            "bodies": self._kernel.bodies(np.arange(pairs)),
            "s": np.linspace(0.0, 1.0, count),
            "q": np.empty((count, self._kernel.n)),
            "reach": np.empty(count),
            "where": np.empty(room, dtype=np.int64),
            "distance": np.empty(room),
            "bracket": np.empty(room + known, dtype=_BRACKET),
            "bracket_bodies": np.empty((room + known, 2), dtype=np.int64),
        }
        return struct("near_pairs", "Scan")(
            pairs=pairs,
            near=self._kernel.address("near"),
            leaves=self._kernel.address("leaves"),
            most_leaves=MOST_LEAVES,
            farther=FARTHER,
            places=count,
            spacing=SPACING,
            close=CLOSE,
            deep=DEEP,
            farthest=FARTHEST,
            most_dips=MOST_DIPS,
            room=room,
            **{name: array.ctypes.data for name, array in self._arrays.items()},
        )
