"""Evaluate a CasADi Function at many points at once, with reused buffers."""

from typing import Any

import casadi as ca
import numpy as np

from manipplan.support.checks import Array

#: Number of points per call of the mapped Function.
CHUNK = 40


class BatchFunction:
    """Evaluates a Function of several vectors at many points. Threads must not share it: it holds its buffers."""

    def __init__(self, function: ca.Function) -> None:
        """`function` takes dense vectors and returns one dense matrix."""
        mapped = function.map(CHUNK)
        self._shape = function.size1_out(0), function.size2_out(0)
        self._inputs = [np.zeros((CHUNK, function.nnz_in(i))) for i in range(function.n_in())]
        self._output = np.zeros((CHUNK, function.nnz_out(0)))
        self._buffer, self._run = mapped.buffer()
        self._views: list[Any] = [array.reshape(-1).data for array in (*self._inputs, self._output)]
        for i, view in enumerate(self._views[:-1]):
            self._buffer.set_arg(i, view)
        self._buffer.set_res(0, self._views[-1])

    def __call__(self, *points: Array) -> Array:
        """The matrices (m, rows, columns) at m points, given as one array (m, k_i) per argument."""
        count = len(points[0])
        out = np.empty((count, self._output.shape[1]))
        for begin in range(0, count, CHUNK):
            size = min(CHUNK, count - begin)
            for array, values in zip(self._inputs, points, strict=True):
                array[:size] = values[begin : begin + size]
                array[size:] = array[:1]  # the rest of the last chunk is computed, too, and must be valid
            self._run()
            out[begin : begin + size] = self._output[:size]
        rows, columns = self._shape
        return out.reshape(count, columns, rows).transpose(0, 2, 1)  # CasADi stores matrices by columns
