"""Measures that are smooth functions of J Jᵀ: Yoshikawa's manipulability, its logarithm, the Frobenius norm, isotropy."""

from dataclasses import dataclass
from typing import ClassVar

import casadi as ca
import numpy as np

from manipplan.measures.measure import JacobianMeasure, Measure, Posture, row_unit
from manipplan.support.checks import ArrayLike, number, number_array, positive_array
from manipplan.support.errors import InvalidInputError
from manipplan.symbolic.motion import Factor, log_gradient, log_hessian, manipulability_gradient, manipulability_hessian
from manipplan.symbolic.task import Task

#: ρ of the regularised form m_ρ = sqrt(det(J Jᵀ + ρ² I)), in units of the Jacobian's rows.
REGULARISATION = 1e-9
#: ρ of the logarithm: with more rows than joints, ρ² has to stay above the rounding errors of J Jᵀ.
LOG_REGULARISATION = 1e-6


@dataclass(frozen=True, kw_only=True)
class Yoshikawa(JacobianMeasure):
    """The manipulability m = sqrt(det(J Jᵀ)), the product of the singular values.

    The value is exact. The derivatives are those of sqrt(det(J Jᵀ + ρ² I)), which also exist where m = 0. For a full-pose
    task, J is taken in the frame of a middle joint, where m is the same.

    Attributes:
        regularisation: ρ > 0, in the unit of the Jacobian's rows.
    """

    regularisation: float = REGULARISATION
    name: ClassVar[str] = "yoshikawa"
    formula: ClassVar[str] = "sqrt(det(J Jᵀ))"
    source: ClassVar[str] = "yoshikawa1985"

    def __post_init__(self) -> None:
        number("regularisation", self.regularisation, above=0.0)

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
class LogDet(JacobianMeasure):
    """The logarithm log m_ρ = log sqrt(det(J Jᵀ + ρ² I)); smooth and finite even at a singularity.

    Attributes:
        regularisation: ρ > 0, in the unit of the Jacobian's rows.
    """

    regularisation: float = LOG_REGULARISATION
    name: ClassVar[str] = "log_det"
    formula: ClassVar[str] = "log sqrt(det(J Jᵀ + ρ² I))"
    source: ClassVar[str] = "dufour2020"
    needs_full_rank: ClassVar[bool] = False
    larger_is_better: ClassVar[bool] = False

    def __post_init__(self) -> None:
        number("regularisation", self.regularisation, above=0.0)

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
class Isotropy(JacobianMeasure):
    """Geometric over arithmetic mean of the squared singular values, det(J Jᵀ)^(1/m) / (tr(J Jᵀ) / m), from 0 to 1.

    It is 1 where the tool moves equally well in all directions and 0 at a singularity. The derivatives are those of m_ρ.

    Attributes:
        regularisation: ρ > 0, in the unit of the Jacobian's rows.
    """

    regularisation: float = REGULARISATION
    name: ClassVar[str] = "isotropy"
    formula: ClassVar[str] = "det(J Jᵀ)^(1/m) / (tr(J Jᵀ) / m)"
    source: ClassVar[str] = "kim1991"

    def __post_init__(self) -> None:
        number("regularisation", self.regularisation, above=0.0)

    def unit(self, task: Task) -> str:  # noqa: ARG002
        return "1"

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
class Constant(Measure):
    """The number 1: with it g is the length of the path, and no configuration counts as singular."""

    name: ClassVar[str] = "constant"
    formula: ClassVar[str] = "1"
    source: ClassVar[str] = "kth2012"
    needs_full_rank: ClassVar[bool] = False
    constant: ClassVar[bool] = True

    def unit(self, task: Task) -> str:  # noqa: ARG002
        return "1"

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
