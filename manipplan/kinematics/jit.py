"""An SX Function for many q in LLVM's language, compiled in the process: for machines without a C compiler."""

import ctypes
import struct

import casadi as ca
import numpy as np

from manipplan.kinematics.instructions import SINE_COSINE, Instruction, instructions
from manipplan.support.checks import Array
from manipplan.support.compiling.llvm import compiled_by_llvm
from manipplan.support.compiling.patience import logged_when_slow

#: Functions of the C library, with their numbers of arguments.
LIBRARY = {
    **dict.fromkeys(("sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "log"), 1),
    **dict.fromkeys(("sqrt", "fabs", "floor", "ceil"), 1),
    **dict.fromkeys(("atan2", "pow"), 2),
}

#: Statements that set {r} from {0} and {1}; names that begin with {r} are free for what is between.
OPERATIONS = {
    ca.OP_ASSIGN: "{r} = fadd double {0}, -0.0",
    ca.OP_ADD: "{r} = fadd double {0}, {1}",
    ca.OP_SUB: "{r} = fsub double {0}, {1}",
    ca.OP_MUL: "{r} = fmul double {0}, {1}",
    ca.OP_DIV: "{r} = fdiv double {0}, {1}",
    ca.OP_NEG: "{r} = fneg double {0}",
    ca.OP_SQ: "{r} = fmul double {0}, {0}",
    ca.OP_TWICE: "{r} = fadd double {0}, {0}",
    ca.OP_INV: "{r} = fdiv double 1.0, {0}",
    ca.OP_FMIN: "{r}a = fcmp olt double {0}, {1}\n  {r} = select i1 {r}a, double {0}, double {1}",
    ca.OP_FMAX: "{r}a = fcmp ogt double {0}, {1}\n  {r} = select i1 {r}a, double {0}, double {1}",
    ca.OP_LT: "{r}a = fcmp olt double {0}, {1}\n  {r} = uitofp i1 {r}a to double",
    ca.OP_LE: "{r}a = fcmp ole double {0}, {1}\n  {r} = uitofp i1 {r}a to double",
    ca.OP_EQ: "{r}a = fcmp oeq double {0}, {1}\n  {r} = uitofp i1 {r}a to double",
    ca.OP_NE: "{r}a = fcmp une double {0}, {1}\n  {r} = uitofp i1 {r}a to double",
    ca.OP_NOT: "{r}a = fcmp oeq double {0}, 0.0\n  {r} = uitofp i1 {r}a to double",
    ca.OP_IF_ELSE_ZERO: "{r}a = fcmp une double {0}, 0.0\n  {r} = select i1 {r}a, double {1}, double 0.0",
    ca.OP_AND: (
        "{r}a = fcmp une double {0}, 0.0\n  {r}b = fcmp une double {1}, 0.0\n  {r}c = and i1 {r}a, {r}b\n"
        "  {r} = uitofp i1 {r}c to double"
    ),
    ca.OP_OR: (
        "{r}a = fcmp une double {0}, 0.0\n  {r}b = fcmp une double {1}, 0.0\n  {r}c = or i1 {r}a, {r}b\n"
        "  {r} = uitofp i1 {r}c to double"
    ),
    ca.OP_SIGN: (
        "{r}a = fcmp ogt double {0}, 0.0\n  {r}b = fcmp olt double {0}, 0.0\n"
        "  {r}c = select i1 {r}b, double -1.0, double {0}\n  {r} = select i1 {r}a, double 1.0, double {r}c"
    ),
    **{
        code: f"{{r}} = call double @{name}(double {{0}})"
        for code, name in {
            ca.OP_SQRT: "sqrt",
            ca.OP_FABS: "fabs",
            ca.OP_EXP: "exp",
            ca.OP_LOG: "log",
            ca.OP_FLOOR: "floor",
            ca.OP_CEIL: "ceil",
            ca.OP_SINH: "sinh",
            ca.OP_COSH: "cosh",
            ca.OP_TANH: "tanh",
            ca.OP_TAN: "tan",
            ca.OP_ASIN: "asin",
            ca.OP_ACOS: "acos",
            ca.OP_ATAN: "atan",
        }.items()
    },
    **{
        code: f"{{r}} = call double @{name}(double {{0}}, double {{1}})"
        for code, name in {ca.OP_POW: "pow", ca.OP_CONSTPOW: "pow", ca.OP_ATAN2: "atan2"}.items()
    },
}


class JitKernel:
    """A kernel, as `manipplan.kinematics.batch.Kernel`, of one Function."""

    def __init__(self, function: ca.Function) -> None:
        with logged_when_slow(f"compiling {function.name()}, by LLVM in each process"):
            self._engine = compiled_by_llvm(kernel_text(function))  # the code lives as long
        address = self._engine.get_function_address("kernel")
        self._call = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int64)(address)

    def __call__(self, q: Array, out: Array) -> bool:
        """Evaluate q (count, n) into out (count, outputs); returns whether all of q was finite."""
        self._call(q.ctypes.data, out.ctypes.data, len(q))
        return bool(np.isfinite(q).all())


def kernel_text(function: ca.Function) -> str:
    """A module with `void kernel(const double *q, double *out, int64 count)` in LLVM's language."""
    n, outputs = function.nnz_in(0), function.nnz_out(0)
    body = [_statement(each) for each in instructions(function)]
    inputs = [f"%p{i} = getelementptr double, ptr %q, i64 {i}\n  %x{i} = load double, ptr %p{i}" for i in range(n)]
    declared = [f"declare double @{name}({', '.join(['double'] * count)}) #0" for name, count in LIBRARY.items()]
    lines = [
        *declared,
        "define void @kernel(ptr noalias %first, ptr noalias %found, i64 %count) {",
        "start:",
        "  %some = icmp sgt i64 %count, 0",
        "  br i1 %some, label %row, label %end",
        "row:",
        "  %q = phi ptr [ %first, %start ], [ %q.next, %row ]",
        "  %out = phi ptr [ %found, %start ], [ %out.next, %row ]",
        "  %k = phi i64 [ 0, %start ], [ %k.next, %row ]",
        *(f"  {line}" for line in (*inputs, *body)),
        f"  %q.next = getelementptr double, ptr %q, i64 {n}",
        f"  %out.next = getelementptr double, ptr %out, i64 {outputs}",
        "  %k.next = add i64 %k, 1",
        "  %more = icmp slt i64 %k.next, %count",
        "  br i1 %more, label %row, label %end",
        "end:",
        "  ret void",
        "}",
        "attributes #0 = { nounwind willreturn memory(none) }",
    ]
    return "\n".join(lines) + "\n"


def _statement(each: Instruction) -> str:
    arguments = [f"%{name}" for name in each.arguments]
    if each.code == ca.OP_OUTPUT:
        place = f"%o{each.result}"
        return f"{place} = getelementptr double, ptr %out, i64 {each.result}\n  store double {arguments[0]}, ptr {place}"
    if each.code == SINE_COSINE:
        return "\n  ".join(f"%{name[0]}{each.result} = call double @{name}(double {arguments[0]})" for name in ("sin", "cos"))
    if each.code == ca.OP_CONST:
        bits = struct.pack(">d", each.constant).hex().upper()
        return f"%t{each.result} = fadd double 0x{bits}, -0.0"
    return OPERATIONS[each.code].format(*arguments, r=f"%t{each.result}")
