"""The compiled code of inverse kinematics: `inverse.c`, with its headers."""

import ctypes
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from manipplan.support.checks import Array
from manipplan.support.compiling.native import needed_code

#: As in spherical.h: arrangement of the axes of the three joints a, b, c that place the point where the others meet.
A_MEETS_B, B_MEETS_C, A_PARALLEL_B, B_PARALLEL_C, SKEW = range(5)

_P, _N, _D = ctypes.c_void_p, ctypes.c_long, ctypes.c_double
#: Result and arguments of the functions of inverse.c.
SIGNATURES: dict[str, tuple[Any, ...]] = {
    "solutions": (_N, _P, _P, _N, _N, _P, _P),
    "arrangement": (_N, _P, _P, _P),
    "quartic": (_N, _P, _P),
    "swivels": (None, _P, _P, _P, _P, _P, _N, _P),
    "refine": (None, _P, _P, _P, _P, _N, _N, _D, _P, _P),
    "search": (None, _P, _P, _P, _P, _P, _N, _N, _D, _P, _P, _P),
    "are_poses": (_N, _P, _N, _D),
    "residuals": (None, _P, _P, _P, _N, _P),
    "first_ones": (None, _P, _P, _N, _N, _D, _P),
}


@cache
def calls() -> Mapping[str, Callable[..., Any]]:
    """The functions of inverse.c, by their names without prefix; raises CompilerError where it cannot be compiled."""
    return needed_code(Path(__file__).with_name("inverse.c"), "inverse kinematics").functions("manipplan_", SIGNATURES)


def real(values: Any) -> Array:
    """The array as compiled code reads it; the same object where it is already so."""
    return np.ascontiguousarray(values, dtype=np.float64)


def whole(values: Any) -> NDArray[np.int64]:
    """The same for indices."""
    return np.ascontiguousarray(values, dtype=np.int64)


def truth(values: Any) -> NDArray[np.bool_]:
    """The same for yes and no."""
    return np.ascontiguousarray(values, dtype=np.bool_)


def arrangement(axes: Array, points: Array) -> tuple[int, Array, float]:
    """Arrangement of the first three of axes and points (k, 3), the point (3,) where two meet, and the deviation [m].

    The arrangement is A_MEETS_B, ... or SKEW; for parallel axes the deviation is the sine of their angle.
    """
    axes, points, out = real(axes), real(points), np.empty(4)
    kind = calls()["arrangement"](axes.ctypes.data, points.ctypes.data, out.ctypes.data)
    return int(kind), out[:3], float(out[3])


def quartic_roots(coefficients: Array) -> NDArray[np.complex128]:
    """The roots (4,) of x⁴ + a[3] x³ + a[2] x² + a[1] x + a[0] for a (4,); none where a is not finite."""
    a, out = real(coefficients), np.empty((4, 2))
    count = calls()["quartic"](a.ctypes.data, out.ctypes.data)
    return np.asarray(out[:count, 0] + 1j * out[:count, 1])


def swivels_of(axes: Array, points: Array, shoulder: Array, wrist: Array, q: Array) -> Array:
    """The swivel [rad] of each row of q (k, 7), for axes and points (7, 3), a shoulder (3,) and a wrist (3,)."""
    axes, points, shoulder, wrist, q = (real(each) for each in (axes, points, shoulder, wrist, q))
    out = np.empty(len(q))
    addresses = (each.ctypes.data for each in (axes, points, shoulder, wrist, q))
    calls()["swivels"](*addresses, len(q), out.ctypes.data)
    return out
