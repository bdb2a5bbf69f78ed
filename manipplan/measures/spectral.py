"""Measures that use individual singular values: the smallest, the condition number, its inverse.

The singular values are computed in the expression graph by one-sided Jacobi rotations, so that these measures compile and
are as accurate as an SVD. Derivatives follow from perturbation theory rather than from differentiating the rotations.
"""

from dataclasses import dataclass
from typing import ClassVar

import casadi as ca

from manipplan.measures.measure import Dimensionless, JacobianMeasure, Posture, row_unit
from manipplan.symbolic.motion import Motion
from manipplan.symbolic.task import Task

#: Number of sweeps of rotations over all pairs of rows; six rows need at most seven to reach rounding error.
SWEEPS = 9

#: Minimum difference of squared singular values in second derivatives, as a share of the largest squared singular value.
GAP = 1e-12

_TINY = 1e-150


@dataclass(frozen=True, kw_only=True)
class SingularValues:
    """J = Σ σ_i u_i v_iᵀ with σ_i in descending order.

    Attributes:
        u: (m, m) left singular vectors, one per column.
        sigma: m values.
        v: (n, m) right singular vectors, one per column; zero where σ_i = 0.
    """

    u: ca.SX
    sigma: list[ca.SX]
    v: ca.SX

    @classmethod
    def of(cls, matrix: ca.SX) -> "SingularValues":
        m = matrix.shape[0]
        rows = ca.vertsplit(ca.densify(matrix))
        left = ca.vertsplit(ca.SX.eye(m))
        for _ in range(SWEEPS if m > 1 else 0):
            for i in range(m):
                for j in range(i + 1, m):
                    c, s = _rotation(rows[i], rows[j])
                    rows[i], rows[j] = c * rows[i] + s * rows[j], c * rows[j] - s * rows[i]
                    left[i], left[j] = c * left[i] + s * left[j], c * left[j] - s * left[i]
        sigma = [ca.norm_2(row.T) for row in rows]
        v = ca.horzcat(*(row.T / ca.fmax(value, _TINY) for row, value in zip(rows, sigma, strict=True)))
        return cls(u=ca.vertcat(*left).T, sigma=sigma, v=v)

    def gradient(self, i: int, motion: Motion) -> ca.SX:
        """∂_k σ_i = u_iᵀ D_k v_i, (n, 1)."""
        return motion.first(self.u[:, i] @ self.v[:, i].T)

    def hessian(self, i: int, motion: Motion) -> ca.SX:
        """The second derivatives of σ_i, (n, n), from those of the eigenvalue σ_i² of J Jᵀ.

        ∂_k ∂_l σ_i = u_iᵀ ∂_l D_k v_i + (D_kᵀ u_i · D_lᵀ u_i + Σ_(j≠i) x_kj x_lj / (σ_i² - σ_j²) - ∂_k σ_i ∂_l σ_i) / σ_i with
        x_kj = σ_i u_jᵀ D_k v_i + σ_j u_iᵀ D_k v_j.
        """
        derivatives = motion.kinematic_hessian()
        across = ca.horzcat(*(derivative.T @ self.u[:, i] for derivative in derivatives))
        slope = self.gradient(i, motion)
        bend = across.T @ across - slope @ slope.T
        least = ca.fmax(GAP * self.sigma[0] ** 2, _TINY)
        for j in range(len(self.sigma)):
            if j == i:
                continue
            x = ca.vertcat(
                *(
                    self.sigma[i] * (self.u[:, j].T @ d @ self.v[:, i]) + self.sigma[j] * (self.u[:, i].T @ d @ self.v[:, j])
                    for d in derivatives
                )
            )
            gap = ca.fmax(ca.fabs(self.sigma[i] ** 2 - self.sigma[j] ** 2), least)
            bend += (1 if i < j else -1) * (x @ x.T) / gap
        return motion.second(self.u[:, i] @ self.v[:, i].T) + bend / ca.fmax(self.sigma[i], _TINY)


def _rotation(first: ca.SX, second: ca.SX) -> tuple[ca.SX, ca.SX]:
    """Cosine and sine of the rotation that makes two rows orthogonal, the longer one first."""
    difference = ca.sumsqr(first) - ca.sumsqr(second)
    overlap = ca.dot(first, second)
    span = ca.sqrt(difference**2 + 4 * overlap**2)
    larger = ca.sqrt((span + ca.fabs(difference)) / (2 * ca.fmax(span, _TINY)))
    smaller = overlap / (ca.fmax(span, _TINY) * ca.fmax(larger, 0.5))
    turned = ca.if_else(overlap < 0, -larger, larger)
    cosine = ca.if_else(difference >= 0, larger, ca.fabs(smaller))
    sine = ca.if_else(difference >= 0, smaller, turned)
    return ca.if_else(span > 0, cosine, 1.0), ca.if_else(span > 0, sine, 0.0)


@dataclass(frozen=True, kw_only=True)
class SmallestSingularValue(JacobianMeasure):
    """σ_min of J: the tool's speed in its worst direction for joint speeds of norm 1."""

    name: ClassVar[str] = "smallest_singular_value"
    formula: ClassVar[str] = "σ_min(J)"
    source: ClassVar[str] = "klein1987"

    def unit(self, task: Task) -> str:
        return row_unit(task)

    def of(self, jacobian: ca.SX) -> ca.SX:
        return SingularValues.of(jacobian).sigma[-1]

    def gradient(self, posture: Posture) -> ca.SX:
        return SingularValues.of(posture.jacobian).gradient(posture.jacobian.shape[0] - 1, posture.motion)

    def hessian(self, posture: Posture) -> ca.SX:
        return SingularValues.of(posture.jacobian).hessian(posture.jacobian.shape[0] - 1, posture.motion)


@dataclass(frozen=True, kw_only=True)
class InverseCondition(Dimensionless, JacobianMeasure):
    """σ_min / σ_max of J, from 0 (singular) to 1 (isotropic)."""

    name: ClassVar[str] = "inverse_condition"
    formula: ClassVar[str] = "σ_min(J) / σ_max(J)"
    source: ClassVar[str] = "salisbury1982"

    def of(self, jacobian: ca.SX) -> ca.SX:
        return _ratio(SingularValues.of(jacobian))

    def gradient(self, posture: Posture) -> ca.SX:
        return ratio_gradient(SingularValues.of(posture.jacobian), posture.motion)

    def hessian(self, posture: Posture) -> ca.SX:
        return ratio_hessian(SingularValues.of(posture.jacobian), posture.motion)


@dataclass(frozen=True, kw_only=True)
class ConditionNumber(Dimensionless, JacobianMeasure):
    """κ = σ_max / σ_min of J, from 1 (isotropic) to inf (singular)."""

    name: ClassVar[str] = "condition_number"
    formula: ClassVar[str] = "σ_max(J) / σ_min(J)"
    source: ClassVar[str] = "salisbury1982"
    larger_is_better: ClassVar[bool] = False

    def of(self, jacobian: ca.SX) -> ca.SX:
        return 1 / _ratio(SingularValues.of(jacobian))

    def gradient(self, posture: Posture) -> ca.SX:
        values = SingularValues.of(posture.jacobian)
        return -ratio_gradient(values, posture.motion) / _ratio(values) ** 2

    def hessian(self, posture: Posture) -> ca.SX:
        values = SingularValues.of(posture.jacobian)
        ratio, slope = _ratio(values), ratio_gradient(values, posture.motion)
        return 2 * (slope @ slope.T) / ratio**3 - ratio_hessian(values, posture.motion) / ratio**2


def _ratio(values: SingularValues) -> ca.SX:
    return values.sigma[-1] / ca.fmax(values.sigma[0], _TINY)


def ratio_gradient(values: SingularValues, motion: Motion) -> ca.SX:
    """The gradient of r = σ_min/σ_max: (∇σ_min - r ∇σ_max)/σ_max."""
    m = len(values.sigma)
    return (values.gradient(m - 1, motion) - _ratio(values) * values.gradient(0, motion)) / values.sigma[0]


def ratio_hessian(values: SingularValues, motion: Motion) -> ca.SX:
    """Hessian of r = σ_min/σ_max, from r σ_max = σ_min differentiated twice."""
    m = len(values.sigma)
    slope, largest = ratio_gradient(values, motion), values.gradient(0, motion)
    both = slope @ largest.T
    bend = values.hessian(m - 1, motion) - _ratio(values) * values.hessian(0, motion) if m > 1 else ca.SX(*both.shape)
    return (bend - both - both.T) / values.sigma[0]
