"""The compiled arithmetic of a step, `steps.c`, on NumPy arrays."""

import ctypes
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from manipplan.support.checks import Array
from manipplan.support.compiling.native import needed_code

_P, _N, _D = ctypes.c_void_p, ctypes.c_long, ctypes.c_double
#: Result and arguments of the functions of steps.c.
SIGNATURES: dict[str, tuple[Any, ...]] = {
    "points": (None, *[_N] * 3, *[_P] * 4),
    "gradient": (None, *[_N] * 3, *[_P] * 5),
    "derivatives": (None, *[_N] * 3, *[_P] * 7),
    "violation": (_D, *[_N] * 2, *[_P] * 3),
    "limits": (_N, *[_N] * 3, *[_P] * 7),
    "curvature": (None, *[_N] * 3, *[_P] * 8, _D, *[_P] * 2),
    "within": (_N, *[_N] * 2, *[_P] * 2, *[_D] * 2, _N, *[_P] * 3),
    "is_convex": (ctypes.c_int, _N, _P, _D, *[_P] * 2),
}


@cache
def _calls() -> dict[str, Callable[..., Any]]:
    """They keep the GIL: to release it would take longer than most calls."""
    code = needed_code(Path(__file__).with_name("steps.c"), "steps of descents")
    return {name: ctypes.PYFUNCTYPE(*types)(code.address(f"manipplan_{name}")) for name, types in SIGNATURES.items()}


#: What a compiled function takes for an array, which has to be contiguous and writable; `array.ctypes` takes much longer.
_at: Callable[[NDArray[Any]], Any] = (ctypes.c_char * 0).from_buffer  # type: ignore[assignment]  # mypy knows no buffers


def points(line: Array, values: Array, z: Array) -> Array:
    """line + values z (m, n), for line (m, n), values (m, f) and z (f, n)."""
    out, z = np.empty(line.shape), np.ascontiguousarray(z)
    _calls()["points"](*line.shape, len(z), _at(line), _at(values), _at(z), _at(out))
    return out


def gradient(weights: Array, values: Array, slopes: Array, each: Array) -> Array:
    """The gradient (f, n) of Σ_i w_i e(q_i, q'_i) by z.

    Args:
        weights: (m,).
        values, slopes: (m, f) change of q and q' with z.
        each: (m, 2 n) derivatives of e.
    """
    n, f = each.shape[1] // 2, values.shape[1]
    out = np.empty((f, n))
    _calls()["gradient"](len(weights), n, f, _at(weights), _at(values), _at(slopes), _at(each), _at(out))
    return out


def derivatives(n: int, weights: Array, values: Array, slopes: Array, each: Array) -> tuple[Array, Array]:
    """The same gradient (f, n), and the Hessian (f n, f n).

    Args:
        n: number of joints.
        weights, values, slopes: as above.
        each: (m, 2 n + 4 n²) gradients and Hessians of e.
    """
    f = values.shape[1]
    first, second, work = np.empty((f, n)), np.empty((f * n, f * n)), np.empty((f * f + 6) * n * n)
    _calls()["derivatives"](len(weights), n, f, *map(_at, (weights, values, slopes, each, work, first, second)))
    return first, second


def violation(points: Array, lower: Array, upper: Array) -> float:
    """Largest violation of limits (n,) by points (r, n); 0 when there is none."""
    return float(_calls()["violation"](*points.shape, _at(points), _at(lower), _at(upper)))


def limit_rows(points: Array, directions: Array, lower: Array, upper: Array, change: Array) -> tuple[Array, Array]:
    """Distances (k,) to the limits (n,) that are below change (r,) at points (r, n), and their derivatives by z (k, f n).

    `directions` (r, f): change of the points with z.
    """
    (r, n), f = points.shape, directions.shape[1]
    values, rows = np.empty(2 * r * n), np.empty((2 * r * n, f * n))
    count = _calls()["limits"](r, n, f, *map(_at, (points, directions, lower, upper, change, values, rows)))
    return values[:count], rows[:count]


def curvature(
    multipliers: Array,
    values: Array,
    slopes: Array,
    speeds: Array,
    bends: Array,
    gradients: Array,
    hessians: Array,
    moves: NDArray[np.bool_],
    least: float,
) -> Array:
    """Σ_i λ_i ∇²d_i (f n, f n) of distances d_i as functions of z, as `manipplan_curvature` says."""
    (r, f), n = values.shape, gradients.shape[1]
    arrays = [np.ascontiguousarray(each, dtype=float) for each in (multipliers, values, slopes, speeds, bends, gradients)]
    hessians, moves = np.ascontiguousarray(hessians), np.ascontiguousarray(moves, dtype=np.int8)
    work, total = np.empty(f * n), np.zeros((f * n, f * n))
    _calls()["curvature"](r, n, f, *map(_at, arrays), _at(hessians), _at(moves), least, _at(work), _at(total))
    return total


def rows_within(
    values: Array, jacobian: Array, radius: float, spacing: float, bits: int
) -> tuple[NDArray[np.int64], Array, Array]:
    """The rows values (r,) + jacobian (r, k) p >= 0 that a p with |p_i| <= radius can come within `spacing` of.

    Returns:
        Indices of the rows (c,); their negative values, rounded to multiples of the spacing (c,); and their jacobian (c, k),
        rounded to `bits` bits.
    """
    (r, k), values, jacobian = jacobian.shape, np.ascontiguousarray(values), np.ascontiguousarray(jacobian)
    chosen, least, rows = np.empty(r, dtype=np.int64), np.empty(r), np.empty((r, k))
    count = _calls()["within"](r, k, _at(values), _at(jacobian), radius, spacing, bits, _at(chosen), _at(least), _at(rows))
    return chosen[:count], least[:count], rows[:count]


def convex_part(matrix: Array, share: float) -> Array | None:
    """The symmetric part of a matrix, if its eigenvalues are all above a share of its largest absolute one; None otherwise."""
    k, matrix = len(matrix), np.ascontiguousarray(matrix)
    out, work = np.empty((k, k)), np.empty((k, k))
    return out if _calls()["is_convex"](k, _at(matrix), share, _at(work), _at(out)) else None
