"""Evaluation of large batches: kernels generated from a CasADi Function, and threads that share the work.

Fast evaluation of one configuration: one Function for all requested quantities, with buffers allocated once.
"""

import ctypes
import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np

from manipplan.kinematics.jit import C_OPERATIONS, expressible, kernel_source
from manipplan.support.checks import Array, ArrayLike, configurations
from manipplan.support.compiling.compiler import NATIVE, load_library
from manipplan.support.errors import CompilerError, InvalidInputError
from manipplan.symbolic.machine_code import do_without, wants_machine_code


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


#: Minimum number of configurations per thread.
SHARE = 16384

#: Evaluates q (count, n) into out (count, outputs), both contiguous; returns whether all of q was finite.
Kernel = Callable[[Array, Array], bool]
#: int (const double *q, double *out, long count): the same in C; 0 if all of q was finite.
BATCH = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_long)


class NativeKernel:
    """A kernel in machine code.

    Attributes:
        run: the C function, a BATCH.
        address: of that function, for other compiled code.
    """

    def __init__(self, run: Any) -> None:
        self.run = run
        self.address = ctypes.cast(run, ctypes.c_void_p).value or 0

    def __call__(self, q: Array, out: Array) -> bool:
        """As `Kernel`."""
        return bool(self.run(q.ctypes.data, out.ctypes.data, len(q)) == 0)


def simd_kernel(function: ca.Function, subject: str) -> NativeKernel:
    """A C kernel that uses the processor's vector width; raises CompilerError if it cannot be built."""

    def load(file: Path) -> NativeKernel:
        return NativeKernel(BATCH(("manipplan_batch", ctypes.CDLL(str(file)))))

    return load_library(kernel_source(function), load, flags=(*NATIVE, "-fschedule-insns", "-lm"), subject=subject)


def find_wanted_kernel(function: ca.Function, compiled: bool | str, subject: str) -> NativeKernel | None:
    """The same where `compiled` asks for machine code and the function's operations are known; None otherwise."""
    if not (wants_machine_code(compiled) and expressible(function, C_OPERATIONS)):
        return None
    try:
        return simd_kernel(function, subject)
    except CompilerError as error:
        do_without(error, compiled)
        return None


def run_kernel(kernel: Kernel, q: Array, outputs: int, *, threads: int) -> Array | None:
    """Outputs (count, outputs) of q (count, n), contiguous; None when an entry of q is NaN or infinite."""
    out = np.empty((len(q), outputs))
    shares = max(1, min(threads, len(q) // SHARE))
    parts = [slice(*edges) for edges in pairwise(len(q) * k // shares for k in range(shares + 1))]
    if shares == 1:
        return out if kernel(q, out) else None
    with ThreadPoolExecutor(shares) as pool:
        finite = list(pool.map(lambda part: kernel(q[part], out[part]), parts))
    return out if all(finite) else None


def all_cores() -> int:
    """Number of cores this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
