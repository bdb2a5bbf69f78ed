"""Evaluate a CasADi Function at many points at once, with reused buffers."""

import casadi as ca
import numpy as np

from manipplan.support.checks import Array

#: Numbers of points per call of a mapped Function, the largest first.
CHUNKS = (64, 16, 4, 1)


class BatchFunction:
    """Evaluates a Function of several vectors at many points. Threads must not share it: it holds its buffers."""

    def __init__(self, function: ca.Function) -> None:
        """`function` takes dense vectors and returns one dense matrix."""
        self._function = function
        self._shape = function.size1_out(0), function.size2_out(0)
        self._chunks: dict[int, _Chunk] = {}

    def __call__(self, *points: Array) -> Array:
        """The matrices (m, rows, columns) at m points, given as one array (m, k_i) per argument, or (k_i,) for all points."""
        rows, columns = self._shape
        return self.by_columns(*points).reshape(-1, columns, rows).transpose(0, 2, 1)

    def by_columns(self, *points: Array) -> Array:
        """The same as (m, rows times columns), each matrix column after column, as CasADi stores it."""
        begin, count = 0, len(points[0])
        out = np.empty((count, self._shape[0] * self._shape[1]))
        for size in CHUNKS:
            while count - begin >= size:
                if size not in self._chunks:
                    self._chunks[size] = _Chunk(self._function, size)
                out[begin : begin + size] = self._chunks[size](points, begin)
                begin += size
        return out


class _Chunk:
    """A Function mapped to `size` points."""

    def __init__(self, function: ca.Function, size: int) -> None:
        self._size = size
        self._inputs = [np.zeros((size, function.nnz_in(i))) for i in range(function.n_in())]
        self._output = np.zeros((size, function.nnz_out(0)))
        self._buffer, self._run = function.map(size).buffer()
        for i, array in enumerate(self._inputs):
            self._buffer.set_arg(i, array.reshape(-1).data)
        self._buffer.set_res(0, self._output.reshape(-1).data)

    def __call__(self, points: tuple[Array, ...], begin: int) -> Array:
        """The outputs (size, k) at the points from `begin` on; the next call overwrites them."""
        for array, values in zip(self._inputs, points, strict=True):
            array[:] = values if values.ndim == 1 else values[begin : begin + self._size]
        self._run()
        return self._output
