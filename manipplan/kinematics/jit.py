"""An SX Function for many q in LLVM's language, compiled in the process: for machines without a C compiler.

An SX Function as a list of operations on named values, for code generation in another language.

C source that evaluates an SX Function for as many q as fit a vector register.
"""

import ctypes
import math
import struct
from collections.abc import Collection
from dataclasses import dataclass

import casadi as ca
import numpy as np

from manipplan.support.checks import Array
from manipplan.support.compiling.llvm import compile_by_llvm

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


def expressible(function: ca.Function, operations: Collection[int]) -> bool:
    """Whether `function` uses only these operations, sine, cosine and constants."""
    basic = {ca.OP_INPUT, ca.OP_OUTPUT, ca.OP_CONST, ca.OP_SIN, ca.OP_COS}
    used = {function.instruction_id(k) for k in range(function.n_instructions())}
    return used <= basic | set(operations)


def pure_angles(found: list[Instruction]) -> set[str]:
    """Inputs that are used only in sines and cosines, so that full turns make no difference."""
    used = {name for each in found if each.code != SINE_COSINE for name in each.arguments}
    turned = {name for each in found if each.code == SINE_COSINE for name in each.arguments if name.startswith("x")}
    return turned - used


#: Number of instructions from which a Function is long; see `kernel_source`.
LONG = 3000


def kernel_source(function: ca.Function) -> str:
    """C source with `int manipplan_batch(const double *q, double *out, long count)`.

    Every instruction becomes a vector instruction (structure of arrays). Two vectors are interleaved, so that the
    instructions of one fill the latencies of the other; long Functions, whose values do not fit the registers, use one.
    """
    found = instructions(function)
    copies = 2 if len(found) < LONG else 1
    n, turning = function.nnz_in(0), pure_angles(found)
    body = [_c_statement(each, copy, turning) for each in found for copy in "ab"[:copies]]
    marks = ", ".join("1" if f"x{i}" in turning else "0" for i in range(n))
    values = {
        "@N@": n,
        "@M@": function.nnz_out(0),
        "@COPIES@": copies,
        "@ANGLES@": marks,
        "@BODY@": "\n  ".join(body),
    }
    kernel = _KERNEL
    for placeholder, value in values.items():
        kernel = kernel.replace(placeholder, str(value))
    return _HEAD + kernel


def _c_statement(each: Instruction, copy: str, turning: set[str]) -> str:
    """The C statement for one copy; names of copy a end in a, those of copy b in b."""
    names = [f"x{copy}[{name[1:]}]" if name.startswith("x") else name + copy for name in each.arguments]
    if each.code == ca.OP_OUTPUT:
        return f"y{copy}[{each.result}] = {names[0]};"
    if each.code == SINE_COSINE:
        sine, cosine = f"s{each.result}{copy}", f"c{each.result}{copy}"
        call = "sine_cosine" if each.arguments[0] in turning else "far_sine_cosine"
        return f"vec {sine}, {cosine}; {call}({names[0]}, &{sine}, &{cosine});"
    value = f"zero + {_constant(each.constant)}" if each.code == ca.OP_CONST else C_OPERATIONS[each.code].format(*names)
    return f"const vec t{each.result}{copy} = {value};"


def _constant(value: float) -> str:
    if math.isinf(value):
        return "INFINITY" if value > 0 else "-INFINITY"
    return "NAN" if math.isnan(value) else f"({value.hex()})"


C_OPERATIONS = {
    ca.OP_ASSIGN: "{0}",
    ca.OP_ADD: "{0} + {1}",
    ca.OP_SUB: "{0} - {1}",
    ca.OP_MUL: "{0} * {1}",
    ca.OP_DIV: "{0} / {1}",
    ca.OP_NEG: "-{0}",
    ca.OP_SQ: "{0} * {0}",
    ca.OP_TWICE: "{0} + {0}",
    ca.OP_INV: "inverse({0})",
    ca.OP_SQRT: "root({0})",
    ca.OP_FABS: "choose({0} < 0.0, -{0}, {0})",
    ca.OP_FMIN: "choose({0} < {1}, {0}, {1})",
    ca.OP_FMAX: "choose({0} > {1}, {0}, {1})",
    ca.OP_LT: "truth({0} < {1})",
    ca.OP_LE: "truth({0} <= {1})",
    ca.OP_EQ: "truth({0} == {1})",
    ca.OP_NE: "truth({0} != {1})",
    ca.OP_NOT: "truth({0} == 0.0)",
    ca.OP_IF_ELSE_ZERO: "choose({0} != 0.0, {1}, zero)",
    ca.OP_EXP: "lanes(exp, {0})",
    ca.OP_LOG: "lanes(log, {0})",
    ca.OP_AND: "truth(({0} != 0.0) & ({1} != 0.0))",
    ca.OP_OR: "truth(({0} != 0.0) | ({1} != 0.0))",
    ca.OP_SIGN: "choose({0} > 0.0, zero + 1.0, choose({0} < 0.0, zero - 1.0, {0}))",
    ca.OP_FLOOR: "lanes(floor, {0})",
    ca.OP_CEIL: "lanes(ceil, {0})",
    ca.OP_SINH: "lanes(sinh, {0})",
    ca.OP_COSH: "lanes(cosh, {0})",
    ca.OP_TAN: "lanes(tan, {0})",
    ca.OP_ASIN: "lanes(asin, {0})",
    ca.OP_ACOS: "lanes(acos, {0})",
    ca.OP_ATAN: "lanes(atan, {0})",
    ca.OP_TANH: "lanes(tanh, {0})",
    ca.OP_POW: "lanes2(pow, {0}, {1})",
    ca.OP_CONSTPOW: "lanes2(pow, {0}, {1})",
    ca.OP_ATAN2: "lanes2(atan2, {0}, {1})",
}


# Sine and cosine: x = k π/2 + r in three parts of π/2 [cody1980], then the minimax polynomials of the Cephes library
# for |r| <= π/4. Angles above NEAR, where this loses digits, go to the C library.
_HEAD = r"""
#include <math.h>
#include <string.h>
#if defined(__AVX512F__)
#define W 8
#elif defined(__AVX__)
#define W 4
#else
#define W 2
#endif
typedef double vec __attribute__((vector_size(8 * W)));
typedef double unaligned __attribute__((vector_size(8 * W), aligned(8), may_alias));
typedef long long mask __attribute__((vector_size(8 * W)));
static const vec zero = {0};
#define NEAR 1e5
#if defined(__AVX512F__)
#include <immintrin.h>
#endif

static inline vec choose(mask m, vec a, vec b) { return (vec)(((mask)a & m) | ((mask)b & ~m)); }
static inline vec truth(mask m) { return choose(m, zero + 1.0, zero); }
#define lanes(f, a) ({ const vec a_ = (a); vec r_; for (int l = 0; l < W; ++l) r_[l] = f(a_[l]); r_; })
#define lanes2(f, a, b) ({ const vec a_ = (a), b_ = (b); vec r_; for (int l = 0; l < W; ++l) r_[l] = f(a_[l], b_[l]); r_; })

static inline int any(mask m) {
#if defined(__AVX512DQ__)
  return _mm512_movepi64_mask((__m512i)m) != 0;
#else
  long long all = 0;
  for (int l = 0; l < W; ++l) all |= m[l];
  return all != 0;
#endif
}

static inline vec root(vec a) {
#if defined(__AVX512F__)
  return (vec)_mm512_sqrt_pd((__m512d)a);
#else
  return lanes(__builtin_sqrt, a);
#endif
}

static inline vec inverse(vec a) {
#if defined(__AVX512F__)
  /* two steps of Newton from 14 bits take less time than a division; 0 and infinity keep the first guess */
  const vec guess = (vec)_mm512_rcp14_pd((__m512d)a);
  vec r = guess + guess * (1.0 - a * guess);
  r = r + r * (1.0 - a * r);
  return choose(r == r, r, guess);
#else
  return 1.0 / a;
#endif
}

static inline void sine_cosine(vec x, vec *s, vec *c) {
  const vec magic = zero + 0x1.8p52;
  vec turns = x * 0x1.45f306dc9c883p-1 + magic;
  const mask k = (mask)turns;
  turns -= magic;
  vec r = x - turns * 0x1.921fb544p+0;
  r -= turns * 0x1.0b4611a6p-34;
  r -= turns * 0x1.3198a2e037073p-69;
  const vec z = r * r;
  const vec ps = ((((1.58962301576546568060e-10 * z - 2.50507477628578072866e-8) * z + 2.75573136213857245213e-6) * z
      - 1.98412698295895385996e-4) * z + 8.33333333332211858878e-3) * z - 1.66666666666666307295e-1;
  const vec pc = ((((-1.13585365213876817300e-11 * z + 2.08757008419747316778e-9) * z - 2.75573141792967388112e-7) * z
      + 2.48015872888517045348e-5) * z - 1.38888888888730564116e-3) * z + 4.16666666666665929218e-2;
  const vec sine = r + r * z * ps, cosine = 1.0 - 0.5 * z + z * z * pc;
  const mask odd = -(k & 1);
  *s = (vec)((mask)choose(odd, cosine, sine) ^ ((k & 2) << 62));
  *c = (vec)((mask)choose(odd, sine, cosine) ^ (((k + 1) & 2) << 62));
}

/* the same for an angle of any size */
static inline void far_sine_cosine(vec x, vec *s, vec *c) {
  sine_cosine(x, s, c);
  const mask far = ~((x < NEAR) & (x > -NEAR));
  if (__builtin_expect(any(far), 0)) {
    *s = choose(far, lanes(sin, x), *s);
    *c = choose(far, lanes(cos, x), *c);
  }
}
"""

_KERNEL = r"""
enum { ONCE = @COPIES@ * W };

static inline void block(const vec x[@COPIES@][@N@], vec y[@COPIES@][@M@]) {
  const vec *xa = x[0], *xb = x[@COPIES@ - 1];
  vec *ya = y[0], *yb = y[@COPIES@ - 1];
  (void)xb, (void)yb;
  @BODY@
}

/* reports entries that are not finite; wraps angles by full turns */
static void tame(vec x[@COPIES@][@N@], int *bad) {
  static const int angle[@N@] = {@ANGLES@};
  for (int copy = 0; copy < @COPIES@; ++copy)
    for (int i = 0; i < @N@; ++i)
      for (int l = 0; l < W; ++l) {
        const double value = x[copy][i][l];
        if (!(__builtin_fabs(value) < INFINITY)) *bad = 1;
        if (angle[i]) x[copy][i][l] = atan2(sin(value), cos(value));
      }
}

/* out (ONCE, @M@) of q (ONCE, @N@) */
static inline void batch(const double *q, double *out, int *bad) {
  vec x[@COPIES@][@N@], y[@COPIES@][@M@];
  vec squares = zero;
  for (int i = 0; i < @COPIES@ * @N@; ++i) {
    const vec some = *(const unaligned *)(q + i * W);
    squares += some * some;
  }
  for (int copy = 0; copy < @COPIES@; ++copy)
    for (int i = 0; i < @N@; ++i)
      for (int l = 0; l < W; ++l) x[copy][i][l] = q[(copy * W + l) * @N@ + i];
  if (__builtin_expect(any(~(squares < NEAR * NEAR)), 0)) tame(x, bad);
  block(x, y);
  for (int copy = 0; copy < @COPIES@; ++copy)
    for (int i = 0; i < @M@; ++i)
      for (int l = 0; l < W; ++l) out[(copy * W + l) * @M@ + i] = y[copy][i][l];
}

/* out (count, @M@) of q (count, @N@); returns 1 when an entry of q is not finite */
int manipplan_batch(const double *q, double *out, long count) {
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


#: Functions of the C library, with their numbers of arguments.
LIBRARY = {
    **dict.fromkeys(("sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "log"), 1),
    **dict.fromkeys(("sqrt", "fabs", "floor", "ceil"), 1),
    **dict.fromkeys(("atan2", "pow"), 2),
}

#: Statements that set {r} from {0} and {1}; names that begin with {r} are free for what is between.
LLVM_OPERATIONS = {
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
        self._engine = compile_by_llvm(kernel_text(function), function.name())  # the code lives as long
        address = self._engine.get_function_address("kernel")
        self._call = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int64)(address)

    def __call__(self, q: Array, out: Array) -> bool:
        """Evaluate q (count, n) into out (count, outputs); returns whether all of q was finite."""
        self._call(q.ctypes.data, out.ctypes.data, len(q))
        return bool(np.isfinite(q).all())


def kernel_text(function: ca.Function) -> str:
    """A module with `void kernel(const double *q, double *out, int64 count)` in LLVM's language."""
    n, outputs = function.nnz_in(0), function.nnz_out(0)
    body = [_llvm_statement(each) for each in instructions(function)]
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


def _llvm_statement(each: Instruction) -> str:
    arguments = [f"%{name}" for name in each.arguments]
    if each.code == ca.OP_OUTPUT:
        target = f"%o{each.result}"
        return f"{target} = getelementptr double, ptr %out, i64 {each.result}\n  store double {arguments[0]}, ptr {target}"
    if each.code == SINE_COSINE:
        return "\n  ".join(f"%{name[0]}{each.result} = call double @{name}(double {arguments[0]})" for name in ("sin", "cos"))
    if each.code == ca.OP_CONST:
        bits = struct.pack(">d", each.constant).hex().upper()
        return f"%t{each.result} = fadd double 0x{bits}, -0.0"
    return LLVM_OPERATIONS[each.code].format(*arguments, r=f"%t{each.result}")
