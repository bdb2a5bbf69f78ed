"""Python source that evaluates an SX Function for many q, compiled by numba."""

from collections.abc import Callable
from typing import Any

import casadi as ca
import numpy as np

from manipplan.kinematics.instructions import SINE_COSINE, Instruction, instructions
from manipplan.support.checks import Array


def jit_kernel(function: ca.Function) -> Callable[[Array, Array], bool]:
    """A kernel that evaluates q (count, n) into out (count, outputs); returns whether all of q was finite."""
    import numba

    body = "\n        ".join(_statement(each) for each in instructions(function))
    inputs = "; ".join(f"x{i} = q[k, {i}]" for i in range(function.nnz_in(0)))
    source = f"def kernel(q, out):\n    for k in range(len(q)):\n        {inputs}\n        {body}\n"
    names: dict[str, Any] = {name: getattr(np, name) for name in _FUNCTIONS}
    exec(source, names)  # generated above, from operations and numbers alone
    compiled = numba.njit(nogil=True, error_model="numpy")(names["kernel"])

    def run(q: Array, out: Array) -> bool:
        compiled(q, out)
        return bool(np.isfinite(q).all())

    return run


def _statement(each: Instruction) -> str:
    if each.code == ca.OP_OUTPUT:
        return f"out[k, {each.result}] = {each.arguments[0]}"
    if each.code == SINE_COSINE:
        return f"s{each.result} = sin({each.arguments[0]}); c{each.result} = cos({each.arguments[0]})"
    if each.code == ca.OP_CONST:
        return f"t{each.result} = {each.constant!r}"
    return f"t{each.result} = {OPERATIONS[each.code].format(*each.arguments)}"


_FUNCTIONS = (
    *("sin", "cos", "tan", "arcsin", "arccos", "arctan", "arctan2", "sinh", "cosh", "tanh"),
    *("sqrt", "exp", "log", "floor", "ceil", "inf", "nan"),
)

OPERATIONS = {
    ca.OP_ASSIGN: "{0}",
    ca.OP_ADD: "{0} + {1}",
    ca.OP_SUB: "{0} - {1}",
    ca.OP_MUL: "{0} * {1}",
    ca.OP_DIV: "{0} / {1}",
    ca.OP_NEG: "-{0}",
    ca.OP_SQ: "{0} * {0}",
    ca.OP_TWICE: "{0} + {0}",
    ca.OP_INV: "1.0 / {0}",
    ca.OP_SQRT: "sqrt({0})",
    ca.OP_FABS: "abs({0})",
    ca.OP_FMIN: "{0} if {0} < {1} else {1}",
    ca.OP_FMAX: "{0} if {0} > {1} else {1}",
    ca.OP_LT: "1.0 if {0} < {1} else 0.0",
    ca.OP_LE: "1.0 if {0} <= {1} else 0.0",
    ca.OP_EQ: "1.0 if {0} == {1} else 0.0",
    ca.OP_NE: "1.0 if {0} != {1} else 0.0",
    ca.OP_NOT: "1.0 if {0} == 0.0 else 0.0",
    ca.OP_IF_ELSE_ZERO: "{1} if {0} != 0.0 else 0.0",
    ca.OP_EXP: "exp({0})",
    ca.OP_LOG: "log({0})",
    ca.OP_AND: "1.0 if {0} != 0.0 and {1} != 0.0 else 0.0",
    ca.OP_OR: "1.0 if {0} != 0.0 or {1} != 0.0 else 0.0",
    ca.OP_SIGN: "1.0 if {0} > 0.0 else -1.0 if {0} < 0.0 else {0}",
    ca.OP_FLOOR: "floor({0})",
    ca.OP_CEIL: "ceil({0})",
    ca.OP_SINH: "sinh({0})",
    ca.OP_COSH: "cosh({0})",
    ca.OP_TAN: "tan({0})",
    ca.OP_ASIN: "arcsin({0})",
    ca.OP_ACOS: "arccos({0})",
    ca.OP_ATAN: "arctan({0})",
    ca.OP_TANH: "tanh({0})",
    ca.OP_POW: "{0} ** {1}",
    ca.OP_CONSTPOW: "{0} ** {1}",
    ca.OP_ATAN2: "arctan2({0}, {1})",
}
