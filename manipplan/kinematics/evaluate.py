"""Fast evaluation of one configuration: one Function for all requested quantities, with buffers allocated once."""

from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import ArrayLike

from manipplan.support.checks import Array, configurations
from manipplan.support.errors import InvalidInputError


class Evaluator:
    """Several quantities at one q (n,) in one call; created by `Kinematics.evaluator`.

    The returned arrays are views that the next call overwrites: copy them to keep them. Threads must not share an
    Evaluator.
    """

    def __init__(self, function: ca.Function, shapes: list[tuple[int, ...]]) -> None:
        """`function` takes q and returns the quantities (dense), then the sum of q, which reveals NaN and inf."""
        self._n = function.nnz_in(0)
        self._q: Any = np.zeros(self._n).data
        flat = [np.zeros(function.nnz_out(i)) for i in range(function.n_out())]
        self._buffer, self._run = function.buffer()
        self._buffer.set_arg(0, self._q)
        for i, out in enumerate(flat):
            self._buffer.set_res(i, out.data)
        self._sum = flat[-1].data
        views = (out.reshape(shape, order="F") for out, shape in zip(flat[:-1], shapes, strict=True))
        self._views: tuple[Array, ...] = tuple(views)

    def __call__(self, q: ArrayLike) -> tuple[Array, ...]:
        """The quantities at q; raises InvalidInputError for another shape, NaN or inf."""
        try:
            self._q[:] = None if isinstance(q, np.ma.MaskedArray) else q  # a memoryview accepts exactly n doubles
        except (TypeError, ValueError):
            q = configurations("q", q, self._n)
            if q.ndim != 1:
                raise InvalidInputError("q", q, f"one configuration of shape ({self._n},)") from None
            np.asarray(self._q)[:] = q
        self._run()
        total = self._sum[0]
        if total - total != 0.0:  # NaN for NaN and inf
            configurations("q", q, self._n)
        return self._views
