"""Integrals over quadrature panels, and the minimum manipulability, by the compiled `panels.c`.

It calls the compiled curve and the compiled measure.
"""

import ctypes
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from manipplan.kinematics.kinematics import Kinematics
from manipplan.paths.curves import curve_code
from manipplan.paths.joint import JointPath
from manipplan.paths.rounding import gauss_rule
from manipplan.support.checks import Array
from manipplan.support.compiling.native import native_code

#: Initial room for edges.
ROOM = 4096

_P, _N, _D = ctypes.c_void_p, ctypes.c_long, ctypes.c_double
#: Result and arguments of the functions of panels.c.
SIGNATURES: dict[str, tuple[Any, ...]] = {
    "panels": (ctypes.c_int, _P, _P, _P, _N, _P),
    "fine_panels": (_N, _P, _P, _N, _N, _N, _D),
    "integral": (ctypes.c_int, _P, _P, _N, _N, _N, _D, _P),
    "minimum": (ctypes.c_int, _P, *[_N] * 4, _P),
}


class _IntegralStruct(ctypes.Structure):
    """`Integral` of panels.c."""

    _fields_ = [
        *((name, _P) for name in ("path", "slope", "evaluate", "measure")),
        *(("n", _N), ("points", _N), ("nodes", _P), ("weights", _P), ("floor", _D), ("power", _D)),
    ]


@cache
def _calls() -> dict[str, Callable[..., Any]] | None:
    """The compiled functions; None where they cannot be compiled."""
    code = native_code(Path(__file__).with_name("panels.c"), "integrals along paths")
    return None if code is None else code.functions("manipplan_", SIGNATURES)


@dataclass(frozen=True, kw_only=True, eq=False)
class Panels:
    """The integral of one path on panels.

    Attributes:
        integral: `Integral` of panels.c.
        functions: those of panels.c.
        owners: what has to live as long as this object.
    """

    integral: _IntegralStruct
    functions: dict[str, Callable[..., Any]]
    owners: tuple[object, ...]

    @classmethod
    def of(cls, path: JointPath, kinematics: Kinematics, power: float, floor: float, points: int) -> "Panels | None":
        """The integral of a path with Euclidean speed and `points` Gauss points a panel; None where it is not compiled."""
        functions, curves, measure = _calls(), curve_code(), kinematics.batch_code("manipulability")
        curve, slope = path.curve(), path.curve(1)
        compiled = curve.address and slope.address and power in (1, 2)
        if functions is None or curves is None or measure is None or not compiled:
            return None
        nodes, weights = gauss_rule(points)
        integral = _IntegralStruct(
            path=curve.address,
            slope=slope.address,
            evaluate=curves.address("manipplan_curve"),
            measure=measure,
            n=path.n,
            points=points,
            nodes=nodes.ctypes.data,
            weights=weights.ctypes.data,
            floor=floor,
            power=power,
        )
        return cls(integral=integral, functions=functions, owners=(curve, slope, curves, kinematics, nodes, weights))

    def integrals(self, begin: Array, end: Array) -> Array | None:
        """The integral over each panel from `begin` to `end` (k,); None where the measure cannot be evaluated."""
        begin, end, out = np.ascontiguousarray(begin), np.ascontiguousarray(end), np.empty(len(begin))
        places = (begin.ctypes.data, end.ctypes.data, len(begin), out.ctypes.data)
        return None if self.functions["panels"](ctypes.addressof(self.integral), *places) else out

    def halved(self, edges: Array, halvings: int, accuracy: float) -> Array | None:
        """The edges (k + 1,) of panels, halved until that changes each by at most `accuracy` of the whole; None as above."""
        room = max(ROOM, len(edges))
        while True:
            found = np.empty(room)
            found[: len(edges)] = edges
            places = (ctypes.addressof(self.integral), found.ctypes.data, len(edges) - 1)
            count = self.functions["fine_panels"](*places, room, halvings, accuracy)
            if count <= room:
                return np.sort(found[:count]) if count >= 0 else None
            room = count

    def integral_of(self, edges: Array, most: int, halvings: int, accuracy: float) -> float | None:
        """The whole integral from panels between edges (k + 1,), as `manipplan_integral` says; None as above."""
        edges, out = np.ascontiguousarray(edges), np.empty(1)
        places = (ctypes.addressof(self.integral), edges.ctypes.data, len(edges) - 1)
        failed = self.functions["integral"](*places, most, halvings, accuracy, out.ctypes.data)
        return None if failed else float(out[0])

    def minimum(self, intervals: int, deepest: int, grids: int, grid_intervals: int) -> tuple[float, float, float] | None:
        """The minimum of m, its s, and the maximum, as `manipplan_minimum` says; None where the measure cannot be evaluated."""
        out = np.empty(3)
        at = ctypes.addressof(self.integral)
        if self.functions["minimum"](at, intervals, deepest, grids, grid_intervals, out.ctypes.data):
            return None
        least, place, largest = out.tolist()
        return least, place, largest
