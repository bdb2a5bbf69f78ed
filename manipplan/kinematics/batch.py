"""Evaluation of many configurations: a kernel that interprets a CasADi Function, its machine code, and threads.

Fast evaluation of one configuration: one Function for all requested quantities, with buffers allocated once.
"""

import ctypes
import math
import os
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np

from manipplan.kinematics.instructions import BatchProgram, is_expressible, kernel_source
from manipplan.support.checks import Array, ArrayLike, configurations
from manipplan.support.compiler import NATIVE, load_library, load_stored
from manipplan.support.errors import CompilerError, InvalidInputError
from manipplan.support.kernels import load_kernel
from manipplan.symbolic.machine_code import PendingCode, do_without, wants_machine_code


class Evaluator:
    """Several quantities at one q (n,) in one call; created by `Kinematics.evaluator`.

    The returned arrays are views that the next call overwrites: copy them to keep them. Threads must not share an
    Evaluator.
    """

    def __init__(self, function: ca.Function, shapes: list[tuple[int, ...]], pending: PendingCode | None = None) -> None:
        """`function` takes q and returns the quantities (dense), then the sum of q, which reveals NaN and inf.

        `pending`: its machine code, where this is still to be built.
        """
        self._n, self._shapes, self._pending = function.nnz_in(0), shapes, pending
        self._q: Any = np.zeros(self._n).data
        self._take(function)

    def _take(self, function: ca.Function) -> None:
        flat = [np.zeros(function.nnz_out(i)) for i in range(function.n_out())]
        self._buffer, self._run = function.buffer()
        self._buffer.set_arg(0, self._q)
        for i, out in enumerate(flat):
            self._buffer.set_res(i, out.data)
        self._sum = flat[-1].data
        views = (out.reshape(shape, order="F") for out, shape in zip(flat[:-1], self._shapes, strict=True))
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
        if self._pending is not None and (made := self._pending.after(1)) is not None:
            self._pending = None
            self._take(made[0])
        self._run()
        total = self._sum[0]
        if total - total != 0.0:  # NaN for NaN and inf
            configurations("q", q, self._n)
        return self._views


#: Compiler options of machine code.
FLAGS = (*NATIVE, "-fschedule-insns", "-lm")
#: Minimum number of configurations per thread.
SHARE = 16384

#: `run` of csrc/batch.h: int (const void *program, const double *q, double *out, long count); 0 if all of q was finite.
BATCH = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_long)
#: Number of instructions, each at one configuration, after which machine code is built: about a tenth of a second of work.
#: To build it takes longer, but it serves later processes, too.
PAYS_OFF = 3e8


class BatchKernel:
    """A Function of q at many configurations, by csrc/batch.c or, where it pays off, in machine code: bit for bit the same."""

    def __init__(self, function: ca.Function, compiled: bool | str, subject: str) -> None:
        """`compiled`: "auto" for machine code where it saves time, False for none; True raises CompilerError without it."""
        self._function, self._subject, self._lock = function, subject, threading.Lock()
        self._program = BatchProgram(function)
        self._most = PAYS_OFF / function.n_instructions() if wants_machine_code(compiled) else math.inf
        self._run: Any = BATCH(load_kernel("batch").address("batch"))
        if self._most < math.inf:
            self._build(load_library if compiled is True else load_stored, compiled)

    @property
    def batch(self) -> tuple[int, int]:
        """The fields of a `Batch` of csrc/batch.h, for other compiled code; this object has to live as long."""
        self._build_if_it_pays()
        return ctypes.cast(self._run, ctypes.c_void_p).value or 0, self._program.address

    def __call__(self, q: Array, out: Array) -> bool:
        """Evaluate q (count, n) into out (count, outputs), both contiguous; returns whether all of q was finite."""
        self._build_if_it_pays()
        return bool(self._run(self._program.address, q.ctypes.data, out.ctypes.data, len(q)) == 0)

    def _build_if_it_pays(self) -> None:
        if self._program.data.evaluations < self._most:
            return
        with self._lock:
            if self._most < math.inf:
                self._build(load_library, "auto")
                self._most = math.inf

    def _build(self, load: Callable[..., Any], compiled: bool | str) -> None:
        """Build or load machine code and use it; if that fails, go on interpreting, unless `compiled` is True, which raises."""
        try:
            run = load(kernel_source(self._function), _load, flags=FLAGS, subject=self._subject)
        except CompilerError as error:
            do_without(error, compiled)
            return
        if run is not None:
            self._run, self._most = run, math.inf


def _load(file: Path) -> Any:
    return BATCH(("manipplan_batch", ctypes.CDLL(str(file))))


def batch_kernel(function: ca.Function, compiled: bool | str, subject: str) -> BatchKernel | None:
    """The kernel where `compiled` is not False and the function's operations are known; None otherwise."""
    return BatchKernel(function, compiled, subject) if compiled is not False and is_expressible(function) else None


def run_kernel(kernel: BatchKernel, q: Array, outputs: int, *, threads: int) -> Array | None:
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
