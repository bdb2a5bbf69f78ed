"""Where pairs of bodies are near along a curve, by the compiled `look.c`, otherwise by NumPy with the same numbers."""

import ctypes
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from manipplan.collision.kernel import DistanceKernel
from manipplan.collision.model import CollisionModel
from manipplan.collision.near_pairs import NearPairs
from manipplan.paths.curves import Curve, curve_code
from manipplan.paths.rounding import FINE, FINE_DISTANCE, on_grid
from manipplan.support.checks import Array
from manipplan.support.compiling.native import native_code

#: Number of intervals of the grid along the curve. A band around the target is only looked at in every SPACING-th place.
INTERVALS, SPACING = 160, 4
#: Distance above the target at which distances are cut off [m]; at every SPACING-th place a wider band raises it.
FARTHEST = 0.03
#: Distance above the target below which dips are located [m].
DEEP = 1e-3
#: Distance above the target below which every place of the grid is returned [m].
CLOSE = 2e-3
#: Accuracy of the place of a bottom in s.
BOTTOM = 1e-6
#: Maximum number of steps to the bottom of a dip.
BOTTOM_STEPS = 12
#: As in look.c.
MOST_JOINTS, MORE_ROOM = 64, -2
#: Initial room for near pairs per place of the grid.
ROOM = 16

_P, _N, _D = ctypes.c_void_p, ctypes.c_long, ctypes.c_double
#: Result and arguments of the functions of look.c.
SIGNATURES: dict[str, tuple[Any, ...]] = {"bottoms": (_N, _P, _P, _N, _P), "look": (_N, _P, _P, _D, _P)}
_BRACKET = np.dtype(
    [*((name, float) for name in ("low", "middle", "high", "left", "least", "right", "next", "found")), ("steps", int)]
)
_FOUND = np.dtype([("distance", float), ("s", float), ("pair", int), ("is_bottom", int)])

Place = tuple[float, int]


class _Dips(ctypes.Structure):
    """`Dips` of look.c."""

    _fields_ = [
        *((name, _P) for name in ("curve", "curve_at")),
        ("spacing", _D),
        *((name, _P) for name in ("world", "distance")),
        *((name, _D) for name in ("grid", "enough")),
        ("most_steps", _N),
    ]


class _Look(ctypes.Structure):
    """`Look` of look.c."""

    _fields_ = [
        *((name, _N) for name in ("n", "pairs")),
        *((name, _P) for name in ("bodies", "near")),
        *((name, _N) for name in ("places", "spacing")),
        ("s", _P),
        *((name, _D) for name in ("target", "close", "deep", "farthest")),
        ("known", _N),
        *((name, _P) for name in ("known_s", "known_pair", "q", "reach")),
        ("room", _N),
        *((name, _P) for name in ("where", "distance", "bracket", "bracket_pair", "bracket_bodies")),
    ]


@cache
def _calls() -> dict[str, Callable[..., Any]] | None:
    """The compiled functions; None where they cannot be compiled."""
    code = native_code(Path(__file__).with_name("look.c"), "distances along paths")
    return None if code is None else code.functions("manipplan_", SIGNATURES)


@dataclass(frozen=True, kw_only=True)
class Look:
    """Distances measured on one curve, the smallest first; (k,) each.

    Attributes:
        distances: signed distances [m].
        s: places on the curve.
        pairs: indices of the pairs.
        is_bottom: whether the distance has a minimum along the curve there.
    """

    distances: Array
    s: Array
    pairs: NDArray[np.intp]
    is_bottom: NDArray[np.bool_]

    @classmethod
    def of(cls, *found: "Look") -> "Look":
        """All that was found, in order."""
        distances, s, pairs, is_bottom = (
            np.concatenate([np.empty(0, dtype=kind), *(getattr(each, name) for each in found)])
            for name, kind in (("distances", float), ("s", float), ("pairs", np.intp), ("is_bottom", bool))
        )
        order = np.lexsort((is_bottom, pairs, s, distances))
        return cls(distances=distances[order], s=s[order], pairs=pairs[order], is_bottom=is_bottom[order])

    @property
    def least(self) -> float:
        """The smallest distance [m]; inf where nothing is near."""
        return float(self.distances[0]) if len(self.distances) else np.inf


#: What is found where nothing is near.
NOTHING = Look.of()


@dataclass(frozen=True, kw_only=True, eq=False)
class DistanceSearch:
    """Searches along curves for the places where pairs of bodies are near; for one thread.

    Attributes:
        model: the arm among its obstacles.
    """

    model: CollisionModel

    @cached_property
    def _kernel(self) -> DistanceKernel | None:
        return self.model.kernel_copy() if self.model.robot.n <= MOST_JOINTS else None

    @cached_property
    def _compiled(self) -> "_Compiled | None":
        """The compiled search; None where it is not compiled."""
        calls, curves, kernel = _calls(), curve_code(), self._kernel
        if calls is None or curves is None or kernel is None:
            return None
        return _Compiled(calls=calls, curve_at=curves.address("manipplan_curve"), kernel=kernel)

    def look(self, curve: Curve, target: float, band: float, known: Sequence[Place] = ()) -> Look:
        """Places where a pair is near.

        These are the places of the grid nearer than the target plus CLOSE, every SPACING-th place nearer than the target plus
        `band`, and the bottoms of dips.

        Args:
            curve: the curve of configurations.
            target: distance to keep [m].
            band: see above [m].
            known: places (s, pair) around which there is always a search for a dip.
        """
        if self._compiled is not None and curve.address:
            compiled = self._compiled.look(curve, target, band, known)
            if compiled is not None:
                return compiled
        s = np.linspace(0.0, 1.0, INTERVALS + 1)
        reach = np.full(len(s), target + FARTHEST)
        reach[::SPACING] = target + max(band, FARTHEST)
        near = self.model.near_pairs(curve(s, FINE), reach)
        distances = on_grid(near.distances, FINE_DISTANCE)
        wanted = distances < target + CLOSE
        wanted |= (near.rows % SPACING == 0) & (distances < target + band)
        at_places = Look(
            distances=distances[wanted],
            s=s[near.rows[wanted]],
            pairs=near.pairs[wanted],
            is_bottom=np.zeros(int(wanted.sum()), dtype=bool),
        )
        profile = NearPairs(shape=near.shape, rows=near.rows, pairs=near.pairs, distances=distances)
        found = [at_places, self._dips(curve, s, profile, target)]
        if known:
            at, pairs = np.array([x for x, _ in known]), np.array([pair for _, pair in known])
            bracket = np.maximum(at - 1 / INTERVALS, 0.0), np.minimum(at + 1 / INTERVALS, 1.0)
            found.append(self._bottoms(curve, bracket, at, self.distances(curve, at, pairs), pairs, None))
        return Look.of(*found)

    def distances(self, curve: Curve, s: Array, pairs: NDArray[np.intp]) -> Array:
        """Distances [m] of pairs (k,) at s (k,), rounded, since the place of a minimum depends on the last bits."""
        return on_grid(self.model.pair_distances(curve(s, FINE), pairs), FINE_DISTANCE)

    def bottoms(
        self,
        curve: Curve,
        bracket: tuple[Array, Array],
        middle: Array,
        least: Array,
        pairs: NDArray[np.intp],
        *,
        sides: tuple[Array, Array] | None = None,
    ) -> tuple[Array, Array]:
        """Where pairs are nearest inside their brackets, (k,), and the distances there [m], (k,).

        Args:
            curve: the curve of configurations.
            bracket: low and high ends (k,) in s.
            middle: s (k,) between them.
            least: distances (k,) at `middle` [m].
            pairs: (k,) indices.
            sides: distances (k,) at the ends of the brackets [m]; nan, or None, where they are not known.
        """
        measured = (np.full(len(pairs), np.nan),) * 2 if sides is None else sides
        dips = np.zeros(len(pairs), dtype=_BRACKET)
        dips["low"], dips["high"], dips["middle"], dips["least"], dips["next"] = *bracket, middle, least, np.nan
        for name, end, distances in zip(("left", "right"), bracket, measured, strict=True):
            dips[name] = distances
            missing = np.flatnonzero(np.isnan(distances))
            if len(missing):
                dips[name][missing] = self.distances(curve, end[missing], pairs[missing])
        if self._compiled is None or not curve.address:
            self._narrow(curve, dips, pairs)
        else:
            while self._compiled.narrow(curve, dips, pairs):
                asked = np.flatnonzero(~np.isnan(dips["next"]))
                dips["found"][asked] = self.distances(curve, dips["next"][asked], pairs[asked])
        return dips["middle"], dips["least"]

    def _dips(self, curve: Curve, s: Array, profile: NearPairs, target: float) -> Look:
        """The bottom of every dip of a profile that may be near the target."""
        most = target + FARTHEST
        before, after = (np.where(np.isfinite(side), np.minimum(side, most), side) for side in profile.beside(most))
        here, sides = np.minimum(profile.distances, most), np.stack([before, after])
        # a dip between places is rarely further below its middle than the higher side is above it
        rise = np.where(np.isfinite(sides), sides, -np.inf).max(axis=0) - here
        dip = (before >= here) & (after > here) & (here - rise < target + DEEP)
        k, pairs = profile.rows[dip], profile.pairs[dip]
        bracket = s[np.maximum(k - 1, 0)], s[np.minimum(k + 1, INTERVALS)]
        # what is cut off is measured; at an end of the curve the bracket ends at the dip itself
        left, right = (
            np.where(at == s[k], here[dip], np.where(side < most, side, np.nan))
            for at, side in zip(bracket, sides[:, dip], strict=True)
        )
        return self._bottoms(curve, bracket, s[k], here[dip], pairs, (left, right))

    def _bottoms(
        self,
        curve: Curve,
        bracket: tuple[Array, Array],
        middle: Array,
        least: Array,
        pairs: NDArray[np.intp],
        sides: tuple[Array, Array] | None,
    ) -> Look:
        at, distances = self.bottoms(curve, bracket, middle, least, pairs, sides=sides)
        return Look(distances=distances, s=at, pairs=pairs, is_bottom=np.ones(len(pairs), dtype=bool))

    def _narrow(self, curve: Curve, dips: NDArray[np.void], pairs: NDArray[np.intp]) -> None:
        """Narrow all brackets together."""
        for step in range(BOTTOM_STEPS):
            k = np.flatnonzero(dips["high"] - dips["low"] >= BOTTOM)
            if not len(k):
                break
            low, middle, high, left, least, right = (
                dips[name][k] for name in ("low", "middle", "high", "left", "least", "right")
            )
            a, b = middle - low, high - middle
            longer = np.where(a > b, -a / 2, b / 2)
            with np.errstate(divide="ignore", invalid="ignore"):
                falls, rises = (left - least) / a, (right - least) / b
                parabola = (b * falls - a * rises) / (2 * (falls + rises))
            usable = np.isfinite(parabola) & (parabola > -a) & (parabola < b) & (step % 3 < 2)
            change = np.where(usable, parabola, longer)
            gap = np.maximum(0.02 * (a + b), BOTTOM / 4)
            change = np.where(np.abs(change) < gap, np.copysign(gap, longer), change)
            new = np.clip(middle + change, low, high)
            value = self.distances(curve, new, pairs[k])
            better, after = value < least, new > middle
            # the nearer of the two becomes the middle, the other an end of the bracket
            end, end_value = np.where(better, middle, new), np.where(better, least, value)
            is_low = better == after
            dips["low"][k], dips["left"][k] = np.where(is_low, end, low), np.where(is_low, end_value, left)
            dips["high"][k], dips["right"][k] = np.where(is_low, high, end), np.where(is_low, right, end_value)
            dips["middle"][k], dips["least"][k] = np.where(better, new, middle), np.where(better, value, least)


class _Compiled:
    """The functions of look.c with the working memory of one search."""

    def __init__(self, *, calls: dict[str, Callable[..., Any]], curve_at: int, kernel: DistanceKernel) -> None:
        self._narrow, self._look, self._kernel = calls["bottoms"], calls["look"], kernel
        self._dips = _Dips(
            curve_at=curve_at,
            spacing=FINE,
            world=kernel.world,
            distance=kernel.address("pairs"),
            grid=FINE_DISTANCE,
            enough=BOTTOM,
            most_steps=BOTTOM_STEPS,
        )
        self._of_all: _Look | None = None
        self._kept: dict[str, NDArray[Any]] = {}
        self._found = np.empty(0, dtype=_FOUND)

    def narrow(self, curve: Curve, dips: NDArray[np.void], pairs: NDArray[np.intp]) -> int:
        """Narrow brackets; the number of those that wait for a distance that the kernel cannot tell."""
        self._dips.curve = curve.address
        bodies = self._kernel.bodies(pairs)
        return int(self._narrow(ctypes.addressof(self._dips), bodies.ctypes.data, len(dips), dips.ctypes.data))

    def look(self, curve: Curve, target: float, band: float, known: Sequence[Place]) -> Look | None:
        """As `DistanceSearch.look`; None where the kernel cannot tell a distance."""
        at, pairs = np.array([x for x, _ in known], dtype=float), np.array([pair for _, pair in known], dtype=np.int64)
        if self._of_all is None:
            self._of_all = self._with_room(ROOM * (INTERVALS + 1), len(known))
        self._dips.curve = curve.address
        while True:
            look = self._of_all
            if len(self._found) < 2 * look.room + len(known):
                look = self._of_all = self._with_room(look.room, len(known))
            look.target, look.known, look.known_s, look.known_pair = target, len(known), at.ctypes.data, pairs.ctypes.data
            places = (ctypes.addressof(self._dips), ctypes.addressof(look), band, self._found.ctypes.data)
            count = self._look(*places)
            if count != MORE_ROOM:
                break
            self._of_all = self._with_room(2 * look.room, len(known))
        if count < 0:
            return None
        found = self._found[:count].copy()
        return Look(distances=found["distance"], s=found["s"], pairs=found["pair"], is_bottom=found["is_bottom"].astype(bool))

    def _with_room(self, room: int, known: int) -> _Look:
        """Working memory for so many near pairs and known places."""
        places, pairs = INTERVALS + 1, self._kernel.pairs
        self._found = np.empty(2 * room + known, dtype=_FOUND)
        self._kept = {
            "bodies": self._kernel.bodies(np.arange(pairs)),
            "s": np.linspace(0.0, 1.0, places),
            "q": np.empty((places, self._kernel.n)),
            "reach": np.empty(places),
            "where": np.empty(room, dtype=np.int64),
            "distance": np.empty(room),
            "bracket": np.empty(room + known, dtype=_BRACKET),
            "bracket_pair": np.empty(room + known, dtype=np.int64),
            "bracket_bodies": np.empty((room + known, 2), dtype=np.int64),
        }
        return _Look(
            n=self._kernel.n,
            pairs=pairs,
            near=self._kernel.address("near"),
            places=places,
            spacing=SPACING,
            close=CLOSE,
            deep=DEEP,
            farthest=FARTHEST,
            room=room,
            **{name: array.ctypes.data for name, array in self._kept.items()},
        )
