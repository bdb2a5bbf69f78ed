"""An SX Function as a list of operations on named values, for code generation in another language."""

from collections.abc import Collection
from dataclasses import dataclass

import casadi as ca

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
