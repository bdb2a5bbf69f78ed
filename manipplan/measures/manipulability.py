"""Measures that are smooth functions of J Jᵀ: Yoshikawa's manipulability, its logarithm, the Frobenius norm, isotropy.

Transmission of velocity and force from the joints to the tool along one direction [chiu1988].

A measure that also falls towards the position limits of the joints.
"""

from dataclasses import dataclass, field, replace
from typing import ClassVar

import casadi as ca
import numpy as np

from manipplan.measures.measure import Dimensionless, JacobianMeasure, Measure, Posture, Regularised, row_unit
from manipplan.support.checks import ArrayLike, finite_array, number, number_array, positive_array
from manipplan.support.errors import InvalidInputError
from manipplan.symbolic.motion import Factor, log_gradient, log_hessian, manipulability_gradient, manipulability_hessian
from manipplan.symbolic.task import Task

#: ρ of the logarithm: with more rows than joints, ρ² has to stay above the rounding errors of J Jᵀ.
LOG_REGULARISATION = 1e-6


@dataclass(frozen=True, kw_only=True)
class Yoshikawa(Regularised, JacobianMeasure):
    """The manipulability m = sqrt(det(J Jᵀ)), the product of the singular values.

    The value is exact. The derivatives are those of sqrt(det(J Jᵀ + ρ² I)), which also exist where m = 0. For a full-pose
    task, J is taken in the frame of a middle joint, where m is the same. ρ = `regularisation` > 0 is in the unit of its rows.
    """

    name: ClassVar[str] = "yoshikawa"
    formula: ClassVar[str] = "sqrt(det(J Jᵀ))"
    source: ClassVar[str] = "yoshikawa1985"

    def unit(self, task: Task) -> str:
        return task.unit

    def of(self, jacobian: ca.SX) -> ca.SX:
        return yoshikawa(jacobian)

    def value(self, posture: Posture) -> ca.SX:
        return yoshikawa(posture.isometric)

    def gradient(self, posture: Posture) -> ca.SX:
        return manipulability_gradient(*posture.smooth, self.regularisation)

    def hessian(self, posture: Posture) -> ca.SX:
        return manipulability_hessian(*posture.smooth, self.regularisation)


@dataclass(frozen=True, kw_only=True)
class LogDet(Regularised, JacobianMeasure):
    """The logarithm log m_ρ = log sqrt(det(J Jᵀ + ρ² I)); smooth and finite even at a singularity.

    ρ = `regularisation` > 0 is in the unit of the Jacobian's rows.
    """

    regularisation: float = LOG_REGULARISATION
    name: ClassVar[str] = "log_det"
    formula: ClassVar[str] = "log sqrt(det(J Jᵀ + ρ² I))"
    source: ClassVar[str] = "dufour2020"
    needs_full_rank: ClassVar[bool] = False
    larger_is_better: ClassVar[bool] = False

    def unit(self, task: Task) -> str:
        return f"log {task.unit}"

    def of(self, jacobian: ca.SX) -> ca.SX:
        return ca.sum1(ca.log(ca.diag(Factor.of(jacobian, self.regularisation).L)))

    def gradient(self, posture: Posture) -> ca.SX:
        return log_gradient(Factor.of(posture.jacobian, self.regularisation), posture.motion)

    def hessian(self, posture: Posture) -> ca.SX:
        return log_hessian(Factor.of(posture.jacobian, self.regularisation), posture.motion)


@dataclass(frozen=True, kw_only=True)
class FrobeniusNorm(JacobianMeasure):
    """The weighted Frobenius norm sqrt(tr(J W Jᵀ)), definition 2.9 in kth2012. It does not vanish at singularities.

    Attributes:
        weights: diagonal of W: one number > 0, or n of them, one per joint.
    """

    weights: ArrayLike = 1.0
    name: ClassVar[str] = "frobenius"
    formula: ClassVar[str] = "sqrt(tr(J W Jᵀ))"
    source: ClassVar[str] = "kth2012"
    needs_full_rank: ClassVar[bool] = False

    def __post_init__(self) -> None:
        weights = number_array("weights", self.weights)
        if weights.ndim > 1 or not weights.size or not (np.isfinite(weights) & (weights > 0)).all():
            raise InvalidInputError("weights", self.weights, "one finite number above zero, or one per joint")
        plain = float(weights) if weights.ndim == 0 else tuple(weights.tolist())
        object.__setattr__(self, "weights", plain)

    def check(self, m: int, n: int) -> None:
        super().check(m, n)
        positive_array("weights", self.weights, n)

    def unit(self, task: Task) -> str:
        return row_unit(task)

    def of(self, jacobian: ca.SX) -> ca.SX:
        weights = positive_array("weights", self.weights, jacobian.shape[1])
        return ca.sqrt(ca.sum2(ca.sum1(jacobian**2) * ca.DM(weights).T))


@dataclass(frozen=True, kw_only=True)
class Isotropy(Regularised, Dimensionless, JacobianMeasure):
    """Geometric over arithmetic mean of the squared singular values, det(J Jᵀ)^(1/m) / (tr(J Jᵀ) / m), from 0 to 1.

    It is 1 where the tool moves equally well in all directions and 0 at a singularity. The derivatives are those of m_ρ
    with ρ = `regularisation` > 0 in the unit of the Jacobian's rows.
    """

    name: ClassVar[str] = "isotropy"
    formula: ClassVar[str] = "det(J Jᵀ)^(1/m) / (tr(J Jᵀ) / m)"
    source: ClassVar[str] = "kim1991"

    def of(self, jacobian: ca.SX) -> ca.SX:
        m = jacobian.shape[0]
        return m * yoshikawa(jacobian) ** (2 / m) / ca.fmax(ca.sumsqr(jacobian), 1e-300)

    def gradient(self, posture: Posture) -> ca.SX:
        return self._regular(posture)[2]

    def hessian(self, posture: Posture) -> ca.SX:
        factor, value, slope = self._regular(posture)
        log_bend = 2 / posture.jacobian.shape[0] * log_hessian(factor, posture.motion)
        log_bend -= ca.hessian(ca.log(ca.sumsqr(posture.jacobian)), posture.q)[0]
        return value * log_bend + slope @ slope.T / value

    def _regular(self, posture: Posture) -> tuple[Factor, ca.SX, ca.SX]:
        """Factor, value and gradient, from log Δ = (2/m) log m_ρ - log tr(J Jᵀ) + constant."""
        m = posture.jacobian.shape[0]
        factor = Factor.of(posture.jacobian, self.regularisation)
        trace = ca.sumsqr(posture.jacobian)
        value = m * factor.manipulability ** (2 / m) / trace
        slope = 2 / m * log_gradient(factor, posture.motion) - ca.gradient(ca.log(trace), posture.q)
        return factor, value, value * slope


@dataclass(frozen=True, kw_only=True)
class Constant(Dimensionless):
    """The number 1: with it g is the length of the path, and no configuration counts as singular."""

    name: ClassVar[str] = "constant"
    formula: ClassVar[str] = "1"
    source: ClassVar[str] = "kth2012"
    needs_full_rank: ClassVar[bool] = False
    constant: ClassVar[bool] = True

    def value(self, posture: Posture) -> ca.SX:  # noqa: ARG002
        return ca.SX(1.0)


def yoshikawa(jacobian: ca.SX) -> ca.SX:
    """The manipulability sqrt(det(J Jᵀ)) of a Jacobian (m, n), m <= n; zero for linearly dependent rows [yoshikawa1985].

    Computed by Gram-Schmidt on the rows, without square roots: m² is the product of the squared lengths of the orthogonal
    rows. No digits are lost by squaring, as they are in J Jᵀ.
    """
    if jacobian.shape[0] > jacobian.shape[1]:
        return ca.SX(0.0)
    square = ca.SX(1.0)
    rows = ca.vertsplit(jacobian)
    for i, row in enumerate(rows):
        left = ca.sumsqr(row)
        square *= left
        inverse = 1 / ca.fmax(left, 1e-300)  # a zero row has no direction
        for j in range(i + 1, len(rows)):
            rows[j] -= ca.dot(row, rows[j]) * inverse * row
    return ca.sqrt(square)


#: Tolerance on the length of a direction that is already normalised.
UNIT = 1e-15


@dataclass(frozen=True, kw_only=True)
class _Transmission(JacobianMeasure):
    direction: ArrayLike

    def __post_init__(self) -> None:
        direction = finite_array("direction", self.direction, (None,))
        size = number("the length of direction", float(np.linalg.norm(direction)), above=1e-9)
        unit = direction if abs(size - 1.0) <= UNIT else direction / size  # dividing again would change the last digit
        object.__setattr__(self, "direction", tuple(unit.tolist()))

    def check(self, m: int, n: int) -> None:
        super().check(m, n)
        if np.size(self.direction) != m:
            raise InvalidInputError("direction", self.direction, f"{m} numbers, one per task row")


@dataclass(frozen=True, kw_only=True)
class VelocityTransmission(Regularised, _Transmission):
    """β = (uᵀ (J Jᵀ + ρ² I)⁻¹ u)^(-1/2): the largest speed along u alone for joint speeds of norm 1.

    It is the distance from the centre to the surface of the velocity ellipsoid along u.

    Attributes:
        direction: u (m,) in task rows, of any length > 0.
        regularisation: ρ > 0, in the unit of the Jacobian's rows; where no motion along u is possible, β falls to ρ, not to 0.
    """

    name: ClassVar[str] = "velocity_transmission"
    formula: ClassVar[str] = "(uᵀ (J Jᵀ + ρ² I)⁻¹ u)^(-1/2)"
    source: ClassVar[str] = "chiu1988"
    needs_full_rank: ClassVar[bool] = False

    def __post_init__(self) -> None:
        _Transmission.__post_init__(self)
        super().__post_init__()

    def unit(self, task: Task) -> str:
        return row_unit(task)

    def of(self, jacobian: ca.SX) -> ca.SX:
        lower = Factor.of(jacobian, self.regularisation).L
        return 1 / ca.norm_2(ca.solve(lower, ca.DM(self.direction)))


@dataclass(frozen=True, kw_only=True)
class ForceTransmission(_Transmission):
    """α = (uᵀ J Jᵀ u)^(-1/2): the largest force along u that joint torques of norm 1 can hold; inf where it needs no torque.

    It is the distance from the centre to the surface of the force ellipsoid along u.

    Attributes:
        direction: u (m,) in task rows, of any length > 0.
    """

    name: ClassVar[str] = "force_transmission"
    formula: ClassVar[str] = "(uᵀ J Jᵀ u)^(-1/2)"
    source: ClassVar[str] = "chiu1988"
    needs_full_rank: ClassVar[bool] = False
    larger_is_better: ClassVar[bool] = False

    def unit(self, task: Task) -> str:
        return {"m": "1/m"}.get(row_unit(task), row_unit(task))

    def of(self, jacobian: ca.SX) -> ca.SX:
        return 1 / ca.norm_2(jacobian.T @ ca.DM(self.direction))


@dataclass(frozen=True, kw_only=True)
class MeasureOfMeasure(Measure):
    """A measure made of another one, `measure`, whose unit it has."""

    measure: Measure = field(default_factory=Yoshikawa)

    def __post_init__(self) -> None:
        if not isinstance(self.measure, Measure):
            raise InvalidInputError("measure", self.measure, "a Measure, such as mp.measures.Yoshikawa()")

    def check(self, m: int, n: int) -> None:
        self.measure.check(m, n)

    def unit(self, task: Task) -> str:
        return self.measure.unit(task)


@dataclass(frozen=True, kw_only=True)
class JointLimitPenalised(MeasureOfMeasure):
    """A measure times P(q) = 1 - exp(-k Π_i 4 (q_i - l_i)(u_i - q_i)/(u_i - l_i)²), which is 0 at a position limit.

    Joints without limits are left out. The source does not have the factors 4, which here scale the product to 0 ... 1.

    Attributes:
        measure: the measure that is penalised.
        k: steepness of P; P = 1 - exp(-k) in the middle of all joint ranges.
    """

    k: float = 10.0
    name: ClassVar[str] = "joint_limit_penalised"
    formula: ClassVar[str] = "measure · (1 - exp(-k Π 4 (q - l)(u - q)/(u - l)²))"
    source: ClassVar[str] = "tsai1986"

    def __post_init__(self) -> None:
        super().__post_init__()
        if not self.measure.larger_is_better:
            raise InvalidInputError("measure", self.measure.name, "a measure that is at least 0 and better when larger")
        number("k", self.k, above=0.0)

    @property
    def over_tools(self) -> bool:  # type: ignore[override]  # that of the measure inside
        return self.measure.over_tools

    def of_one_tool(self) -> Measure:
        return replace(self, measure=self.measure.of_one_tool())

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
