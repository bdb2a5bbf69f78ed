"""A measure that also falls towards the position limits of the joints."""

from dataclasses import dataclass, field, replace
from typing import ClassVar

import casadi as ca
import numpy as np

from manipplan.measures.manipulability import Yoshikawa
from manipplan.measures.measure import Measure, Posture
from manipplan.support.checks import number
from manipplan.support.errors import InvalidInputError
from manipplan.symbolic.task import Task


@dataclass(frozen=True, kw_only=True)
class JointLimitPenalised(Measure):
    """A measure times P(q) = 1 - exp(-k Π_i 4 (q_i - l_i)(u_i - q_i)/(u_i - l_i)²), which is 0 at a position limit.

    Joints without limits are left out. The source does not have the factors 4, which here scale the product to 0 ... 1.

    Attributes:
        measure: the measure that is penalised.
        k: steepness of P; P = 1 - exp(-k) in the middle of all joint ranges.
    """

    measure: Measure = field(default_factory=Yoshikawa)
    k: float = 10.0
    name: ClassVar[str] = "joint_limit_penalised"
    formula: ClassVar[str] = "measure · (1 - exp(-k Π 4 (q - l)(u - q)/(u - l)²))"
    source: ClassVar[str] = "tsai1986"

    def __post_init__(self) -> None:
        if not isinstance(self.measure, Measure):
            raise InvalidInputError("measure", self.measure, "a Measure, such as mp.measures.Yoshikawa()")
        if not self.measure.larger_is_better:
            raise InvalidInputError("measure", self.measure.name, "a measure that is at least 0 and better when larger")
        number("k", self.k, above=0.0)

    @property
    def over_tools(self) -> bool:  # type: ignore[override]  # that of the measure inside
        return self.measure.over_tools

    def of_one_tool(self) -> Measure:
        return replace(self, measure=self.measure.of_one_tool())

    def check(self, m: int, n: int) -> None:
        self.measure.check(m, n)

    def unit(self, task: Task) -> str:
        return self.measure.unit(task)

    def value(self, posture: Posture) -> ca.SX:
        return self.measure.value(posture) * self._penalty(posture)

    def gradient(self, posture: Posture) -> ca.SX:
        penalty = self._penalty(posture)
        slope = ca.gradient(penalty, posture.q)
        return penalty * self.measure.gradient(posture) + self.measure.value(posture) * slope

    def hessian(self, posture: Posture) -> ca.SX:
        penalty = self._penalty(posture)
        bend, slope = ca.hessian(penalty, posture.q)
        both = self.measure.gradient(posture) @ slope.T
        return penalty * self.measure.hessian(posture) + both + both.T + self.measure.value(posture) * bend

    def _penalty(self, posture: Posture) -> ca.SX:
        product = ca.SX(1.0)
        for i in np.flatnonzero(np.isfinite(posture.lower) & np.isfinite(posture.upper)):
            low, high, q = float(posture.lower[i]), float(posture.upper[i]), posture.q[int(i)]
            product *= ca.fmax(4 * (q - low) * (high - q) / (high - low) ** 2, 0.0)
        return 1 - ca.exp(-self.k * product)
