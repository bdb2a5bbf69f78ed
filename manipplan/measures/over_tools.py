"""A measure of a robot with several tools: the minimum over its tools, or their weighted mean."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar

import casadi as ca

from manipplan.measures.manipulability import MeasureOfMeasure
from manipplan.measures.measure import Measure, Posture, ToolPosture
from manipplan.support.checks import entries, number
from manipplan.support.errors import InvalidInputError, UnknownNameError

#: Number of times the power 2 is doubled in the smooth minimum: its exponent is 2^DOUBLED.
DOUBLED = 4
#: Values below this count as this in ratios.
VANISHING = 1e-150


@dataclass(frozen=True, kw_only=True)
class OverTools(MeasureOfMeasure):
    """A measure over all tools of a robot, where each tool has that of the joints that move it.

    Without weights it is the smooth minimum s = (Σ_k m_k^-16)^(-1/16), which has the derivatives that optimisers need. With K
    tools, K^(-1/16) min m_k <= s <= min m_k: for two tools it is at most 4.3 % below the minimum. It is zero where one of the
    m_k is. With weights it is the mean Σ_k w_k m_k / Σ_k w_k, in which one tool may be singular.

    It is the default of a robot with several tools. Reports also give the minimum of each tool alone.

    Attributes:
        measure: the measure of each tool.
        weights: a number > 0 for each tool, by its name; None: the minimum.
    """

    weights: Mapping[str, float] | Sequence[tuple[str, float]] | None = None
    name: ClassVar[str] = "over_tools"
    formula: ClassVar[str] = "(Σ m_k^-16)^(-1/16), or Σ w_k m_k / Σ w_k"
    source: ClassVar[str] = "lee1989"
    over_tools: ClassVar[bool] = True

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.measure.over_tools or not self.measure.larger_is_better:
            raise InvalidInputError(
                "measure", self.measure.name, "a measure of one tool that is at least 0 and better when larger"
            )
        if self.weights is None:
            return
        given = self.weights.items() if isinstance(self.weights, Mapping) else self.weights
        wanted = "a mapping from names of tools to numbers above zero, such as {'left': 1.0, 'right': 2.0}"
        listed = entries("weights", given if isinstance(given, Iterable) else None, wanted)
        pairs = [tuple(each) for each in listed if _is_pair(each)]
        names = [name for name, _ in pairs]
        if not pairs or len(pairs) < len(listed) or len(set(names)) < len(names):
            raise InvalidInputError("weights", self.weights, wanted)
        checked = tuple((name, number(f"weights[{name!r}]", weight, above=0.0)) for name, weight in sorted(pairs))
        object.__setattr__(self, "weights", checked)

    def of_one_tool(self) -> Measure:
        return self.measure

    def check_tools(self, tools: Sequence[str]) -> None:
        """Raise an error unless the weights are those of these tools."""
        if self.weights is None:
            return
        given = dict(self.weights)
        for name in given:
            if name not in tools:
                raise UnknownNameError("weights", name, tools)
        missing = [tool for tool in tools if tool not in given]
        if missing:
            raise InvalidInputError("weights", given, f"a weight for each tool; {' and '.join(missing)} has none")

    def value(self, posture: Posture) -> ca.SX:
        tools = posture.tools()
        return self._combine(list(tools), [each.placed(self.measure.value) for each in tools.values()])[0]

    def gradient(self, posture: Posture) -> ca.SX:
        slopes, _, _ = self._derivatives(posture)
        return slopes

    def hessian(self, posture: Posture) -> ca.SX:
        _, bends, outer = self._derivatives(posture, second=True)
        return bends + outer

    def _derivatives(self, posture: Posture, *, second: bool = False) -> tuple[ca.SX, ca.SX, ca.SX]:
        """Σ_k c_k ∇m_k, Σ_k c_k ∇²m_k and Σ_kl c_kl ∇m_k ∇m_lᵀ, with c_k, c_kl the derivatives by m_k, and by m_k and m_l."""
        tools, n = posture.tools(), posture.q.shape[0]
        values = [each.placed(self.measure.value) for each in tools.values()]
        _, first, mixed = self._combine(list(tools), values)
        gradients = [_column(each, self.measure.gradient, n) for each in tools.values()]
        slopes = sum((c * slope for c, slope in zip(first, gradients, strict=True)), ca.SX(n, 1))
        bends, outer = ca.SX(n, n), ca.SX(n, n)
        if second:
            for c, each in zip(first, tools.values(), strict=True):
                bends[list(each.joints), list(each.joints)] += c * each.placed(self.measure.hessian)
            for k, a in enumerate(gradients):
                for j, b in enumerate(gradients):
                    outer += mixed[k][j] * a @ b.T
        return slopes, bends, outer

    def _combine(self, tools: list[str], m: list[ca.SX]) -> tuple[ca.SX, list[ca.SX], list[list[ca.SX]]]:
        """The value, its derivatives by each m_k, and by each two."""
        if self.weights is not None:
            given = dict(self.weights)
            total = sum(given.values())
            shares = [ca.SX(given[tool] / total) for tool in tools]
            value = sum((share * each for share, each in zip(shares, m, strict=True)), ca.SX(0.0))
            return value, shares, [[ca.SX(0.0)] * len(m) for _ in m]
        least = m[0]
        for each in m[1:]:
            least = ca.fmin(least, each)
        safe = [ca.fmax(each, VANISHING) for each in m]
        floor = ca.fmax(least, VANISHING)
        root = sum((_double_power(floor / each) for each in safe), ca.SX(0.0))
        for _ in range(DOUBLED):
            root = ca.sqrt(root)
        value = least / root
        # with t_k = s / m_k, whose 16th powers add up to 1: ∂s/∂m_k = t_k^17; ∂²s/∂m_k∂m_l = 17 t_k^17 t_l^17 / s for k ≠ l,
        # -17 t_k^17 / m_k Σ_{l≠k} t_l^16 for k = l
        power = 2**DOUBLED + 1
        ratios = [floor / root / each for each in safe]
        powers = [_double_power(t) for t in ratios]
        first = [each * t for each, t in zip(powers, ratios, strict=True)]
        mixed = [[power * a * b / (floor / root) for b in first] for a in first]
        for k, each in enumerate(safe):
            mixed[k][k] = -power * first[k] / each * sum((p for j, p in enumerate(powers) if j != k), ca.SX(0.0))
        return value, first, mixed


def _is_pair(given: object) -> bool:
    """Whether something is a name and one more value."""
    return isinstance(given, list | tuple) and len(given) == 2 and isinstance(given[0], str)


def _double_power(base: ca.SX) -> ca.SX:
    """base^(2^DOUBLED)."""
    for _ in range(DOUBLED):
        base = base * base
    return base


def _column(tool: ToolPosture, quantity: Callable[[Posture], ca.SX], n: int) -> ca.SX:
    """A gradient in the joints of a tool as one in all n joints."""
    column = ca.SX(n, 1)
    column[list(tool.joints)] = tool.placed(quantity)
    return column
