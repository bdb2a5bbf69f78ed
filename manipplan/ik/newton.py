"""Newton steps on the arm as described, by `newton.h`: they refine solutions of closed forms, and find others without."""

import ctypes

import numpy as np
from numpy.typing import NDArray

from manipplan.ik.geometry import Screws
from manipplan.ik.native import calls, real, truth, whole
from manipplan.support.checks import Array

_N, _P = ctypes.c_long, ctypes.c_void_p


class _ScrewsStruct(ctypes.Structure):
    """`Screws` of newton.h."""

    _fields_ = [
        ("n", _N),
        *((name, _P) for name in ("axes", "points", "slides", "home", "moves")),
        ("links", _N),
        *((name, _P) for name in ("leader", "ratio", "offset")),
    ]


class MovingArm:
    """An arm whose joints `moves` (n,) may move, the others hold their positions; threads may share it."""

    def __init__(self, screws: Screws, moves: NDArray[np.bool_]) -> None:
        self._n, self._links = screws.n, 0 if screws.follow is None else len(screws.axes)
        self._arrays = (real(screws.axes), real(screws.points), truth(screws.slides), real(screws.home), truth(moves))
        self._screws = _ScrewsStruct(screws.n, *(each.ctypes.data for each in self._arrays), len(screws.axes))
        if screws.follow is not None:
            leader, ratio, offset = screws.follow
            self._led = whole(leader), real(ratio), real(offset)
            self._screws.leader, self._screws.ratio, self._screws.offset = (each.ctypes.data for each in self._led)
        self._address = ctypes.addressof(self._screws)

    def refine(self, q: Array, targets: Array, owners: NDArray[np.int64], *, steps: int, tolerance: float) -> Array:
        """Rows (k, n) after minimum-norm Newton steps from each row of q (k, n) to the pose targets[owners[k]].

        A row ends once its pose is reached to `tolerance` [m, rad], after `steps` steps at the latest; a step that does not
        reduce the error is rejected.
        """
        q, targets, owners = np.array(q, dtype=np.float64, order="C"), real(targets), whole(owners)
        work, held = self._scratch()
        calls()["refine"](
            self._address,
            targets.ctypes.data,
            owners.ctypes.data,
            q.ctypes.data,
            len(q),
            steps,
            tolerance,
            work.ctypes.data,
            held.ctypes.data,
        )
        return q

    def search(
        self, q: Array, target: Array, lower: Array, upper: Array, *, steps: int, tolerance: float
    ) -> tuple[Array, Array]:
        """Rows (k, n) after damped Newton steps from each row of q (k, n), and their largest errors (k,) [m, rad].

        Levenberg-Marquardt steps [sugihara2011] towards one pose (4, 4), inside the limits (n,). Joints stop at their limits
        and leave them when the step leads back. A row ends once its pose is reached to `tolerance`, or after `steps` steps.
        """
        q, target, lower, upper = np.array(q, dtype=np.float64, order="C"), real(target), real(lower), real(upper)
        miss, (work, held) = np.empty(len(q)), self._scratch()
        calls()["search"](
            self._address,
            target.ctypes.data,
            lower.ctypes.data,
            upper.ctypes.data,
            q.ctypes.data,
            len(q),
            steps,
            tolerance,
            miss.ctypes.data,
            work.ctypes.data,
            held.ctypes.data,
        )
        return q, miss

    def _scratch(self) -> tuple[Array, NDArray[np.bool_]]:
        return np.empty(7 * self._n + 6 * self._links), np.empty(self._n, dtype=np.bool_)
