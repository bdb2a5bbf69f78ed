"""Evaluation of large batches: kernels generated from a CasADi Function, and threads that share the work."""

import ctypes
import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np

from manipplan.kinematics.instructions import expressible
from manipplan.kinematics.simd import OPERATIONS, kernel_source
from manipplan.support.checks import Array
from manipplan.support.compiling.compiler import NATIVE, load_library
from manipplan.support.errors import CompilerError
from manipplan.symbolic.machine_code import do_without, wants_machine_code

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


def wanted_kernel(function: ca.Function, compiled: bool | str, subject: str) -> NativeKernel | None:
    """The same where `compiled` asks for machine code and the function's operations are known; None otherwise."""
    if not (wants_machine_code(compiled) and expressible(function, OPERATIONS)):
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
