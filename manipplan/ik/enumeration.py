"""All solutions of a closed form for many poses and values of the held joints, by `inverse.c`."""

import ctypes
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from manipplan.ik.form import ClosedForm
from manipplan.ik.native import calls, real, truth, whole
from manipplan.support.checks import Array

#: Number of samples that a block of solutions is sized for.
CHUNK = 8192
#: As in spherical.h: amount by which a solution may exceed a limit [rad], and maximum number of solutions.
AT_LIMIT, MOST = 1e-5, 8

_N, _P = ctypes.c_long, ctypes.c_void_p


class _Form(ctypes.Structure):
    """`Form` of inverse.c."""

    _fields_ = [
        *((name, _N) for name in ("n", "helds", "frees", "solver", "backward", "moves_axes", "triple")),
        *((name, _P) for name in ("axes", "points", "slides", "held", "free", "meeting", "home", "lower", "upper", "endless")),
        ("turning", _P),
    ]


class _Samples(ctypes.Structure):
    """`Samples` of inverse.c."""

    _fields_ = [("poses", _P), ("owners", _P), ("values", _P), ("count", _N), ("width", _N)]


class _Solutions(ctypes.Structure):
    """`Solutions` of inverse.c."""

    _fields_ = [("out", _P), ("source", _P), ("rows", _N), ("filled", _N)]


class Enumeration:
    """Enumerates the solutions of one closed form inside limits; threads may share it.

    Joints without limits are in [-π, π]; others are listed at every full turn inside the limits.

    Args:
        form: the arm's closed form.
        lower, upper: (n,) limits [rad or m]; infinite on both sides for continuous joints.
        axis: (3,) tool axis about which the tool is free to rotate; None for a full pose.
    """

    def __init__(self, form: ClosedForm, lower: Array, upper: Array, axis: Array | None) -> None:
        screws, endless = form.screws, np.isinf(lower)
        # inverse.c undoes the held joints in this order: of those behind all free joints, the outermost comes first
        behind = [k for k, joint in enumerate(form.held) if joint > max(form.free)]
        self._order = [*(k for k in range(len(form.held)) if k not in behind), *reversed(behind)]
        low, high = np.where(endless, -np.pi, lower), np.where(endless, np.pi, upper)
        turns = np.where(endless, 0, (high - low + 2 * AT_LIMIT) // (2 * np.pi))[list(form.free)]
        self._n, self._most = screws.n, MOST * int(np.prod(np.maximum(turns + 1, 1)))
        self._arrays: tuple[NDArray[Any], ...] = (
            real(screws.axes),
            real(screws.points),
            truth(screws.slides),
            whole([form.held[k] for k in self._order]),
            whole(form.free),
            real(form.meeting),
            real(np.linalg.inv(screws.home)),
            real(low),
            real(high),
            truth(endless),
            real(axis if axis is not None else np.zeros(3)),
        )
        numbers = (screws.n, len(form.held), len(form.free), form.solver, form.backward, form.moves_axes, form.triple)
        self._form = _Form(*numbers, *(each.ctypes.data for each in self._arrays))

    def __call__(
        self, poses: Array, owners: NDArray[np.int64], samples: Array
    ) -> Iterator[tuple[Array, NDArray[np.int64], int]]:
        """Blocks of solutions q (k, n), with the sample (k,) of each, and the number of samples solved so far.

        Args:
            poses: (p, 4, 4).
            owners: (s,) pose index of each sample.
            samples: (s, r) values of the held joints, then the swivel, then the rotation about `axis` where it is free.
        """
        columns = [*self._order, *range(len(self._order), samples.shape[1])]
        poses, owners, samples = real(poses), whole(owners), real(samples[:, columns])
        asked = _Samples(poses.ctypes.data, owners.ctypes.data, samples.ctypes.data, *samples.shape)
        rows = max(4 * self._most, min(len(samples) * MOST, CHUNK * MOST))
        work, begin, call = np.empty(6 * self._n), 0, calls()["solutions"]
        while begin < len(samples):
            out, source = np.empty((rows, self._n)), np.empty(rows, dtype=np.int64)
            found = _Solutions(out.ctypes.data, source.ctypes.data, rows, 0)
            begin = call(
                ctypes.addressof(self._form),
                ctypes.addressof(asked),
                begin,
                self._most,
                work.ctypes.data,
                ctypes.addressof(found),
            )
            yield out[: found.filled], source[: found.filled], begin
