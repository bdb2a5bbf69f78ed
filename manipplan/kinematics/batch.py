"""Evaluation of many configurations: a kernel that interprets a CasADi Function, its machine code, and threads.

An SX Function is a list of instructions: for csrc/batch.c, which interprets them, and as C source, which is faster.

Fast evaluation of one configuration: one Function for all requested quantities, with buffers allocated once.
"""

import ctypes
import math
import os
import re
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np

from manipplan.support.checks import Array, ArrayLike, configurations
from manipplan.support.compiler import NATIVE, load_library, load_stored
from manipplan.support.errors import CompilerError, InvalidInputError
from manipplan.support.kernel_library import FOLDER
from manipplan.support.kernels import load_kernel, struct
from manipplan.symbolic.machine_code import PendingCode, do_without, wants_machine_code

#: Code for the sine and cosine of one angle together; all other operations have CasADi's codes.
SINE_COSINE = -1


@dataclass(frozen=True, kw_only=True)
class Instruction:
    """One operation.

    Attributes:
        code: CasADi's operation code, or SINE_COSINE, or ca.OP_OUTPUT.
        result: index of the value: t0, t1, ...; of a pair s0 and c0, s1 and c1, ...; or of the output.
        arguments: names of values: t0, s0, c0, ... or inputs x0, x1, ...
        constant: value of ca.OP_CONST.
    """

    code: int
    result: int
    arguments: tuple[str, ...] = ()
    constant: float = 0.0


def instructions(function: ca.Function) -> list[Instruction]:
    """The operations of `function`, which has one input and one output, in order; each value is assigned once."""
    found: list[Instruction] = []
    held: dict[int, str] = {}  # CasADi's work vector: the value now in each slot
    angles: dict[str, int] = {}
    for k in range(function.n_instructions()):
        code, inputs, outputs = function.instruction_id(k), function.instruction_input(k), function.instruction_output(k)
        if code == ca.OP_INPUT:
            held[outputs[0]] = f"x{inputs[1]}"
        elif code == ca.OP_OUTPUT:
            found.append(Instruction(code=code, result=outputs[1], arguments=(held[inputs[0]],)))
        elif code == ca.OP_CONST:
            found.append(Instruction(code=code, result=k, constant=float(function.instruction_constant(k))))
            held[outputs[0]] = f"t{k}"
        elif code in (ca.OP_SIN, ca.OP_COS):
            angle = held[inputs[0]]
            if angle not in angles:
                angles[angle] = len(angles)
                found.append(Instruction(code=SINE_COSINE, result=angles[angle], arguments=(angle,)))
            held[outputs[0]] = f"{'s' if code == ca.OP_SIN else 'c'}{angles[angle]}"
        else:
            found.append(Instruction(code=code, result=k, arguments=tuple(held[i] for i in inputs)))
            held[outputs[0]] = f"t{k}"
    return found


@cache
def operations() -> dict[int, str]:
    """The names of the operations of csrc/vectors.h in their order, by CasADi's codes."""
    names = re.findall(r"\bX\((\w+), ", (FOLDER / "vectors.h").read_text(encoding="utf-8"))
    return {getattr(ca, f"OP_{name.upper()}"): name for name in names if name != "name"}


def pure_angles(found: list[Instruction]) -> set[str]:
    """Inputs that are used only in sines and cosines, so that full turns make no difference."""
    used = {name for each in found if each.code != SINE_COSINE for name in each.arguments}
    turned = {name for each in found if each.code == SINE_COSINE for name in each.arguments if name.startswith("x")}
    return turned - used


#: Codes of csrc/batch.c beside the operations.
KERNEL_CONSTANT, KERNEL_SINE_COSINES, KERNEL_OUTPUT = -1, {True: -2, False: -3}, -4


class BatchProgram:
    """An SX Function of one input and one output for `manipplan_batch`; `data` is that of csrc/batch.c."""

    def __init__(self, function: ca.Function) -> None:
        found, n = instructions(function), function.nnz_in(0)
        turning = pure_angles(found)
        numbers = {code: k for k, code in enumerate(operations())}
        last = {name: k for k, each in enumerate(found) for name in each.arguments}
        slots = {f"x{i}": i for i in range(n)}
        free: list[int] = []
        count = n

        def new(name: str) -> int:
            nonlocal count
            slots[name] = free.pop() if free else count
            count += slots[name] == count
            return slots[name]

        rows = (struct("batch", "Instruction") * len(found))()
        for k, (row, each) in enumerate(zip(rows, found, strict=True)):
            first, second = (*(slots[name] for name in each.arguments), 0, 0)[:2]
            if each.code == ca.OP_OUTPUT:
                values: tuple[Any, ...] = (KERNEL_OUTPUT, each.result, 0, first, 0, 0.0)
            elif each.code == SINE_COSINE:
                sine, cosine = new(f"s{each.result}"), new(f"c{each.result}")
                values = (KERNEL_SINE_COSINES[each.arguments[0] in turning], sine, cosine, first, 0, 0.0)
            else:
                code = KERNEL_CONSTANT if each.code == ca.OP_CONST else numbers[each.code]
                values = (code, new(f"t{each.result}"), 0, first, second, each.constant)
            row.code, row.result, row.second, row.a, row.b, row.value = values
            # a result never takes the slot of its arguments, which are read after it is begun
            free += [slots[name] for name in dict.fromkeys(each.arguments) if last[name] == k and not name.startswith("x")]
        marks = np.array([f"x{i}" in turning for i in range(n)], dtype=ctypes.c_long)
        self._owners = rows, marks
        self.data = struct("batch", "Program")(
            n=n,
            outputs=function.nnz_out(0),
            count=len(found),
            slots=count,
            instructions=ctypes.addressof(rows),
            turning=marks.ctypes.data,
        )
        self.address = ctypes.addressof(self.data)


#: Number of instructions from which a Function is long; see `kernel_source`.
LONG = 3000


def kernel_source(function: ca.Function) -> str:
    """C source with the `run` of csrc/batch.h.

    Every instruction becomes a vector instruction (structure of arrays). Two vectors are interleaved, so that the
    instructions of one fill the latencies of the other; long Functions, whose values do not fit the registers, use one.
    """
    found = instructions(function)
    copies = 2 if len(found) < LONG else 1
    n, turning = function.nnz_in(0), pure_angles(found)
    body = [_c_statement(each, copy, turning) for each in found for copy in "ab"[:copies]]
    marks = ", ".join("1" if f"x{i}" in turning else "0" for i in range(n))
    values = {"@N@": n, "@M@": function.nnz_out(0), "@COPIES@": copies, "@ANGLES@": marks, "@BODY@": "\n  ".join(body)}
    kernel = _KERNEL
    for placeholder, value in values.items():
        kernel = kernel.replace(placeholder, str(value))
    return (FOLDER / "vectors.h").read_text(encoding="utf-8").replace("#pragma once\n", "") + kernel


def _c_statement(each: Instruction, copy: str, turning: set[str]) -> str:
    """The C statement for one copy; names of copy a end in a, those of copy b in b."""
    names = [f"x{copy}[{name[1:]}]" if name.startswith("x") else name + copy for name in each.arguments]
    if each.code == ca.OP_OUTPUT:
        return f"y{copy}[{each.result}] = {names[0]};"
    if each.code == SINE_COSINE:
        sine, cosine = f"s{each.result}{copy}", f"c{each.result}{copy}"
        call = "sine_cosine" if each.arguments[0] in turning else "far_sine_cosine"
        return f"vec {sine}, {cosine}; {call}({names[0]}, &{sine}, &{cosine});"
    value = f"zero + {_constant(each.constant)}"
    if each.code != ca.OP_CONST:
        value = f"op_{operations()[each.code]}({', '.join((*names, 'zero')[:2])})"
    return f"const vec t{each.result}{copy} = {value};"


def _constant(value: float) -> str:
    if math.isinf(value):
        return "INFINITY" if value > 0 else "-INFINITY"
    return "NAN" if math.isnan(value) else f"({value.hex()})"


_KERNEL = r"""
#include <string.h>
enum { ONCE = @COPIES@ * W };

static inline void block(const vec x[@COPIES@][@N@], vec y[@COPIES@][@M@]) {
  const vec *xa = x[0], *xb = x[@COPIES@ - 1];
  vec *ya = y[0], *yb = y[@COPIES@ - 1];
  (void)xb, (void)yb;
  @BODY@
}

/* out (ONCE, @M@) of q (ONCE, @N@) */
static inline void batch(const double *q, double *out, int *bad) {
  static const long turning[@N@] = {@ANGLES@};
  vec x[@COPIES@][@N@], y[@COPIES@][@M@];
  for (int copy = 0; copy < @COPIES@; ++copy)
    for (int i = 0; i < @N@; ++i)
      for (int l = 0; l < W; ++l) x[copy][i][l] = q[(copy * W + l) * @N@ + i];
  if (__builtin_expect(some_far(q, @COPIES@ * @N@), 0))
    for (int copy = 0; copy < @COPIES@; ++copy)
      for (int i = 0; i < @N@; ++i)
        for (int l = 0; l < W; ++l) x[copy][i][l] = tamed(x[copy][i][l], turning[i], bad);
  block(x, y);
  for (int copy = 0; copy < @COPIES@; ++copy)
    for (int i = 0; i < @M@; ++i)
      for (int l = 0; l < W; ++l) out[(copy * W + l) * @M@ + i] = y[copy][i][l];
}

/* out (count, @M@) of q (count, @N@); returns 1 when an entry of q is not finite */
int manipplan_batch(const void *program, const double *q, double *out, long count) {
  int bad = 0;
  long k = 0;
  for (; k + ONCE <= count; k += ONCE) batch(q + k * @N@, out + k * @M@, &bad);
  if (k < count) {
    double last[ONCE * @N@] = {0}, results[ONCE * @M@];
    memcpy(last, q + k * @N@, (count - k) * @N@ * sizeof(double));
    batch(last, results, &bad);
    memcpy(out + k * @M@, results, (count - k) * @M@ * sizeof(double));
  }
  return bad;
}
"""


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
    used = {function.instruction_id(k) for k in range(function.n_instructions())}
    known = {ca.OP_INPUT, ca.OP_OUTPUT, ca.OP_CONST, ca.OP_SIN, ca.OP_COS, *operations()}
    return BatchKernel(function, compiled, subject) if compiled is not False and used <= known else None


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
