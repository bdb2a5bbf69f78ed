"""CasADi Functions compiled by the machine's own compiler; without a compiler, CasADi's virtual machine runs them.

Evaluate a CasADi Function at many points at once, with reused buffers.
"""

import math
import threading
import warnings
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import casadi as ca
import numpy as np

from manipplan.support.checks import Array
from manipplan.support.compiler import NATIVE, find_compiler, load_library, load_stored
from manipplan.support.errors import CompilerError, CompilerWarning, InvalidInputError, ManipplanError
from manipplan.support.files import cache_folder
from manipplan.support.untrusted import is_identifier, printable

#: Minimum number of characters of source for -O1, which compiles three times faster; the code runs a tenth slower.
LONG = 200_000

#: Number of instructions of CasADi's virtual machine after which machine code is built: a quarter of a second of work.
PAYS_OFF = 1e8
#: Maximum number of instructions that "auto" compiles: these take a few seconds.
SOON_DONE = 60_000


def native_flags(source: str) -> tuple[str, ...]:
    """Compiler options for code that only this machine runs, chosen by the length of the source."""
    return NATIVE if len(source) < LONG else ("-O1", *NATIVE[1:])


def compiled(function: ca.Function, subject: str) -> ca.Function:
    """The same function as machine code; raises CompilerError as `load_library`."""
    return compile_together([function], subject)[0]


def compile_together(functions: Sequence[ca.Function], subject: str) -> tuple[ca.Function, ...]:
    """Several functions as one library of machine code; raises as `compiled`."""
    source = generate_source(functions)
    return load_library(source, _loader(functions), flags=(*native_flags(source), "-lm"), subject=subject)


def _stored_together(functions: Sequence[ca.Function], subject: str) -> tuple[ca.Function, ...] | None:
    """The same where an earlier process built it."""
    source = generate_source(functions)
    return load_stored(source, _loader(functions), flags=(*native_flags(source), "-lm"), subject=subject)


def _loader(functions: Sequence[ca.Function]) -> Callable[[Path], tuple[ca.Function, ...]]:
    return lambda file: tuple(ca.external(function.name(), str(file)) for function in functions)


def generate_source(functions: Sequence[ca.Function]) -> str:
    """C source of CasADi Functions. All names must be identifiers: CasADi writes those of arguments unchanged."""
    generator = ca.CodeGenerator(functions[0].name(), {"casadi_real": "double"})
    for function in functions:
        for name in (function.name(), *function.name_in(), *function.name_out()):
            if not is_identifier(name):
                raise ManipplanError(f"{name!r} cannot be written to C source: it is not an identifier")
        generator.add(function)
    source: str = generator.dump()
    return source


def check_compiled(compiled: bool | str) -> None:
    """Raise InvalidInputError for anything but True, False and "auto"."""
    if not (isinstance(compiled, bool) or (isinstance(compiled, str) and compiled == "auto")):
        raise InvalidInputError("compiled", compiled, "'auto', True or False")


def wants_machine_code(compiled: bool | str) -> bool:
    """Whether the option `compiled` (True, False or "auto") selects machine code on this machine."""
    return compiled is True or (compiled == "auto" and find_compiler("c") is not None)


class PendingCode:
    """Machine code of functions that is built once they were evaluated so often that this is likely to save time.

    CasADi's virtual machine gives the same numbers to the last bit, so that it does not matter when. Threads may share it.
    """

    def __init__(self, functions: Sequence[ca.Function], subject: str, count: float | None = None) -> None:
        """`count`: number of evaluations after which it is built; None: when these cost PAYS_OFF."""
        self._functions, self._subject, self._lock = functions, subject, threading.Lock()
        self._left = PAYS_OFF / sum(function.n_instructions() for function in functions) if count is None else count
        self._made: tuple[ca.Function, ...] | None = None

    def after(self, count: int) -> tuple[ca.Function, ...] | None:
        """Note `count` evaluations of one of the functions; their machine code once there is any."""
        with self._lock:
            self._left -= count
            if self._left < 0 and self._made is None:
                try:
                    self._made = compile_together(self._functions, self._subject)
                except CompilerError as error:
                    do_without(error, "auto")
                    self._left = math.inf
            return self._made


@dataclass(frozen=True, kw_only=True)
class CodedFunctions:
    """Functions, and their machine code that is still to be built; None for no such."""

    functions: tuple[ca.Function, ...]
    pending: PendingCode | None = None

    def batches(self) -> tuple["BatchFunction", ...]:
        """Each of them at many points, with buffers of its own."""
        return tuple(BatchFunction(each, self.pending, k) for k, each in enumerate(self.functions))


def as_asked(
    functions: Sequence[ca.Function], compiled: bool | str, subject: str, *, at_once: bool = False, count: float | None = None
) -> CodedFunctions:
    """The functions as machine code where `compiled` (True, False or "auto") selects it, otherwise unchanged.

    "auto" builds it only when they are evaluated often, see `PendingCode`, or `at_once`. It leaves functions of more than
    SOON_DONE instructions unchanged.

    Raises CompilerError when `compiled` is True and there is no compiler, or it fails.
    """
    soon = sum(function.n_instructions() for function in functions) <= SOON_DONE
    try:
        if compiled is True or (soon and at_once and wants_machine_code(compiled)):
            return CodedFunctions(functions=compile_together(functions, subject))
        if soon and wants_machine_code(compiled):
            stored = _stored_together(functions, subject)
            pending = None if stored is not None else PendingCode(functions, subject, count)
            return CodedFunctions(functions=stored or tuple(functions), pending=pending)
    except CompilerError as error:
        do_without(error, compiled)
    return CodedFunctions(functions=tuple(functions))


def do_without(error: CompilerError, compiled: bool | str) -> None:
    """Go on without machine code, with a CompilerWarning the first time; raises `error` when compiled is True."""
    if compiled is True:
        raise error
    if first_failure():
        warnings.warn(printable(f"the work goes on without machine code, more slowly: {error}"), CompilerWarning, stacklevel=6)


def first_failure() -> bool:
    """Whether this is the first call for this compiler and cache folder, so that a failure is reported once."""
    return next(_once(find_compiler("c"), cache_folder()), False)


@cache
def _once(*_: object) -> Iterator[bool]:
    return iter((True,))


#: Numbers of points per call of a mapped Function, the largest first; a quadrature panel has ten.
CHUNKS = (160, 40, 10, 4, 1)


class BatchFunction:
    """Evaluates a Function of several vectors at many points. Threads must not share it: it holds its buffers."""

    def __init__(self, function: ca.Function, pending: PendingCode | None = None, index: int = 0) -> None:
        """`function` takes dense vectors and returns one dense matrix; it is the one of `index` in `pending`."""
        self._function, self._pending, self._index = function, pending, index
        self._shape = function.size1_out(0), function.size2_out(0)
        self._chunks: dict[int, _Chunk] = {}

    def __call__(self, *points: Array) -> Array:
        """The matrices (m, rows, columns) at m points, given as one array (m, k_i) per argument, or (k_i,) for all points."""
        rows, columns = self._shape
        return self.by_columns(*points).reshape(-1, columns, rows).transpose(0, 2, 1)

    def by_columns(self, *points: Array) -> Array:
        """The same as (m, rows times columns), each matrix column after column, as CasADi stores it."""
        begin, count = 0, len(points[0])
        if self._pending is not None and (made := self._pending.after(count)) is not None:
            self._function, self._pending = made[self._index], None
            self._chunks.clear()
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
