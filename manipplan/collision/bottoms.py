"""The bottoms of dips: where pairs of bodies are nearest along a path, by the compiled `bottoms.c`, otherwise by NumPy."""

import ctypes
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from manipplan.collision.kernel import DistanceKernel
from manipplan.collision.model import CollisionModel
from manipplan.paths.curves import curve_code
from manipplan.paths.joint import JointPath
from manipplan.paths.rounding import FINE, FINE_DISTANCE, configurations, on_grid
from manipplan.support.checks import Array
from manipplan.support.compiling.native import native_code

#: Accuracy of the place of a bottom in s.
BOTTOM = 1e-6
#: Maximum number of steps to the bottom of a dip.
BOTTOM_STEPS = 12
#: As in bottoms.c.
MOST_JOINTS = 64

_P, _N, _D = ctypes.c_void_p, ctypes.c_long, ctypes.c_double
_BRACKET = np.dtype(
    [*((name, float) for name in ("low", "middle", "high", "left", "least", "right", "next", "found")), ("steps", int)]
)


class _Dips(ctypes.Structure):
    """`Dips` of bottoms.c."""

    _fields_ = [
        ("curve", _P),
        ("curve_at", _P),
        ("spacing", _D),
        ("world", _P),
        ("distance", _P),
        ("grid", _D),
        ("enough", _D),
        ("most_steps", _N),
    ]


@cache
def _narrow() -> Callable[..., int] | None:
    """The compiled search; None where it cannot be compiled."""
    code = native_code(Path(__file__).with_name("bottoms.c"), "distances along paths")
    return None if code is None else code.functions("manipplan_", {"bottoms": (_N, _P, _P, _N, _P)})["bottoms"]


@dataclass(frozen=True, kw_only=True, eq=False)
class DipSearch:
    """Searches along paths for the places where pairs of bodies are nearest; for one thread.

    Attributes:
        model: the arm among its obstacles.
    """

    model: CollisionModel

    @cached_property
    def _kernel(self) -> DistanceKernel | None:
        return self.model.kernel_copy() if self.model.robot.n <= MOST_JOINTS else None

    def distances(self, path: JointPath, s: Array, pairs: NDArray[np.intp]) -> Array:
        """Distances [m] of pairs (k,) at s (k,), rounded, since the place of a minimum depends on the last bits."""
        return on_grid(self.model.pair_distances(configurations(path, s), pairs), FINE_DISTANCE)

    def bottoms(
        self,
        path: JointPath,
        bracket: tuple[Array, Array],
        middle: Array,
        least: Array,
        pairs: NDArray[np.intp],
        *,
        sides: tuple[Array, Array] | None = None,
    ) -> tuple[Array, Array]:
        """Where pairs are nearest inside their brackets, (k,), and the distances there [m], (k,).

        Args:
            path: the path.
            bracket: low and high ends (k,) in s.
            middle: s (k,) between them.
            least: distances (k,) at `middle` [m].
            pairs: (k,) indices.
            sides: distances (k,) at the ends of the brackets [m]; nan, or None, where they are not known.
        """
        known = (np.full(len(pairs), np.nan),) * 2 if sides is None else sides
        dips = np.zeros(len(pairs), dtype=_BRACKET)
        dips["low"], dips["high"], dips["middle"], dips["least"], dips["next"] = *bracket, middle, least, np.nan
        for name, end, distances in zip(("left", "right"), bracket, known, strict=True):
            dips[name] = distances
            missing = np.flatnonzero(np.isnan(distances))
            if len(missing):
                dips[name][missing] = self.distances(path, end[missing], pairs[missing])
        narrow, curves, kernel, curve = _narrow(), curve_code(), self._kernel, path.curve()
        if narrow is None or curves is None or kernel is None or not curve.address:
            self._by_numpy(path, dips, pairs)
            return dips["middle"], dips["least"]
        search = _Dips(
            curve=curve.address,
            curve_at=curves.address("manipplan_curve"),
            spacing=FINE,
            world=kernel.world,
            distance=kernel.pairs_address,
            grid=FINE_DISTANCE,
            enough=BOTTOM,
            most_steps=BOTTOM_STEPS,
        )
        bodies = kernel.bodies(pairs)
        while narrow(ctypes.addressof(search), bodies.ctypes.data, len(dips), dips.ctypes.data):
            asked = np.flatnonzero(~np.isnan(dips["next"]))
            dips["found"][asked] = self.distances(path, dips["next"][asked], pairs[asked])
        return dips["middle"], dips["least"]

    def _by_numpy(self, path: JointPath, dips: NDArray[np.void], pairs: NDArray[np.intp]) -> None:
        """The same for all brackets together."""
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
            value = self.distances(path, new, pairs[k])
            better, after = value < least, new > middle
            # the nearer of the two becomes the middle, the other an end of the bracket
            end, end_value = np.where(better, middle, new), np.where(better, least, value)
            is_low = better == after
            dips["low"][k], dips["left"][k] = np.where(is_low, end, low), np.where(is_low, end_value, left)
            dips["high"][k], dips["right"][k] = np.where(is_low, high, end), np.where(is_low, right, end_value)
            dips["middle"][k], dips["least"][k] = np.where(better, new, middle), np.where(better, value, least)
