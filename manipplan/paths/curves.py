"""Evaluation of curves in Bernstein form: by the compiled `curves.c`, otherwise by NumPy, with the same numbers."""

import ctypes
from collections.abc import Callable
from functools import cache
from math import comb
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from manipplan.support.checks import Array
from manipplan.support.compiling.native import NativeCode, native_code
from manipplan.support.errors import InvalidInputError

#: Curves of a higher degree are evaluated by NumPy; as in curves.c.
MOST_DEGREE = 30

_P, _N = ctypes.c_void_p, ctypes.c_long
#: Result and arguments of `manipplan_curve`. It keeps the GIL: to release it would take longer than most calls.
_CALL = ctypes.PYFUNCTYPE(_N, _P, _P, _N, ctypes.c_double, _P)


class _CurveStruct(ctypes.Structure):
    """`Curve` of curves.c."""

    _fields_ = [("pieces", _N), ("degree", _N), ("n", _N), ("breaks", _P), ("control", _P)]


@cache
def curve_code() -> NativeCode | None:
    """The compiled code, for calls from other compiled code by the address of `manipplan_curve`; None without it."""
    return native_code(Path(__file__).with_name("curves.c"), "evaluation of paths")


@cache
def _call() -> Callable[..., int] | None:
    code = curve_code()
    return None if code is None else _CALL(code.address("manipplan_curve"))


class Curve:
    """Polynomial pieces between breaks (p + 1,), which increase from 0 to 1, with control points (p, k + 1, n), k >= 0.

    Attributes:
        address: of the curve as compiled code knows it, for as long as this object lives; 0 without compiled code.
    """

    __slots__ = ("_breaks", "_control", "_curve", "address")

    def __init__(self, breaks: Array, control: Array) -> None:
        self._breaks, self._control = np.ascontiguousarray(breaks), np.ascontiguousarray(control)
        pieces, points, n = control.shape
        self._curve, self.address = None, 0
        if points - 1 <= MOST_DEGREE and _call() is not None:
            self._curve = _CurveStruct(pieces, points - 1, n, self._breaks.ctypes.data, self._control.ctypes.data)
            self.address = ctypes.addressof(self._curve)

    def __reduce__(self) -> tuple[object, ...]:
        return Curve, (self._breaks, self._control)

    def __call__(self, s: Array, spacing: float = 0.0) -> Array:
        """The curve (..., n) at s (...), to multiples of `spacing` unless that is 0; InvalidInputError outside [0, 1]."""
        call = _call()
        if not self.address or call is None:
            return self._by_numpy(s, spacing)
        s = np.ascontiguousarray(s, dtype=float).reshape(s.shape)  # ascontiguousarray makes a number a row
        out = np.empty((*s.shape, self._control.shape[2]))
        if call(self.address, s.ctypes.data, s.size, spacing, out.ctypes.data):
            raise _outside(s)
        return out

    def _by_numpy(self, s: Array, spacing: float) -> Array:
        if s.size and not (s.min() >= 0 and s.max() <= 1):  # also NaN
            raise _outside(s)
        piece = np.clip(np.searchsorted(self._breaks, s, side="right") - 1, 0, len(self._control) - 1)
        u = (s - self._breaks[piece]) / np.diff(self._breaks)[piece]
        weights = bernstein(self._control.shape[1] - 1, u)
        out = weights[..., 0, None] * self._control[piece, 0]
        for j in range(1, self._control.shape[1]):
            out += weights[..., j, None] * self._control[piece, j]
        return np.asarray(np.round(out / spacing) * spacing if spacing > 0 else out)

    @property
    def derivative(self) -> "Curve":
        """The curve of the derivative, of degree k - 1; zero for k = 0."""
        k = self._control.shape[1] - 1
        if k == 0:
            return Curve(self._breaks, np.zeros_like(self._control))
        control = self._control
        return Curve(self._breaks, (control[:, 1:] - control[:, :-1]) * (k / np.diff(self._breaks)[:, None, None]))


def bernstein(degree: int, u: ArrayLike) -> Array:
    """Values of the Bernstein polynomials of `degree` at u (...), (..., degree + 1)."""
    u = np.asarray(u, dtype=float)[..., None]
    powers, rest = (np.cumprod(np.concatenate([np.ones_like(x), *[x] * degree], axis=-1), axis=-1) for x in (u, 1 - u))
    return np.asarray(_binomials(degree) * powers * rest[..., ::-1])


@cache
def _binomials(degree: int) -> Array:
    """The binomial coefficients of `degree`, (degree + 1,)."""
    return np.array([comb(degree, i) for i in range(degree + 1)], dtype=float)


def _outside(s: Array) -> InvalidInputError:
    return InvalidInputError("s", s, "numbers from 0 to 1")
