"""Measures that include the arm's inertia M(q): the tool accelerations that the motors can produce."""

from dataclasses import dataclass
from typing import ClassVar

import casadi as ca

from manipplan.measures.manipulability import yoshikawa
from manipplan.measures.measure import Dimensionless, Posture, Regularised, product_unit
from manipplan.measures.spectral import SingularValues, ratio_gradient, ratio_hessian
from manipplan.symbolic.motion import MatrixMotion, manipulability_gradient, manipulability_hessian
from manipplan.symbolic.task import Task


@dataclass(frozen=True, kw_only=True)
class DynamicManipulability(Regularised):
    """w_d = sqrt(det(J M⁻² Jᵀ)) of the arm at rest without gravity: tool accelerations for joint torques of norm 1.

    ρ = `regularisation` > 0 as for `Yoshikawa`, in the unit of the rows of J M⁻¹.
    """

    name: ClassVar[str] = "dynamic"
    formula: ClassVar[str] = "sqrt(det(J M⁻² Jᵀ))"
    source: ClassVar[str] = "yoshikawa1985b"

    def unit(self, task: Task) -> str:
        return product_unit(task, "kg m²")

    def value(self, posture: Posture) -> ca.SX:
        return yoshikawa(_accelerations(posture))

    def gradient(self, posture: Posture) -> ca.SX:
        return manipulability_gradient(*_moving(_accelerations(posture), posture), self.regularisation)

    def hessian(self, posture: Posture) -> ca.SX:
        return manipulability_hessian(*_moving(_accelerations(posture), posture), self.regularisation)


@dataclass(frozen=True, kw_only=True)
class Asada(Dimensionless):
    """Isotropy of the generalised inertia ellipsoid: smallest over largest eigenvalue of the tool's inertia (J M⁻¹ Jᵀ)⁻¹.

    From 0 (singular) to 1 (the tool feels equally heavy in all directions).
    """

    name: ClassVar[str] = "asada"
    formula: ClassVar[str] = "λ_min / λ_max of (J M⁻¹ Jᵀ)⁻¹"
    source: ClassVar[str] = "asada1983"

    def value(self, posture: Posture) -> ca.SX:
        values = SingularValues.of(_mobility_root(posture))
        return (values.sigma[-1] / ca.fmax(values.sigma[0], 1e-300)) ** 2

    def gradient(self, posture: Posture) -> ca.SX:
        matrix, motion = _moving(_mobility_root(posture), posture)
        values = SingularValues.of(matrix)
        return 2 * values.sigma[-1] / values.sigma[0] * ratio_gradient(values, motion)

    def hessian(self, posture: Posture) -> ca.SX:
        matrix, motion = _moving(_mobility_root(posture), posture)
        values = SingularValues.of(matrix)
        slope = ratio_gradient(values, motion)
        return 2 * (slope @ slope.T + values.sigma[-1] / values.sigma[0] * ratio_hessian(values, motion))


def _moving(matrix: ca.SX, posture: Posture) -> tuple[ca.SX, MatrixMotion]:
    return matrix, MatrixMotion(matrix=matrix, q=posture.q)


def _accelerations(posture: Posture) -> ca.SX:
    """J M⁻¹, (m, n): the tool's acceleration for unit joint torques."""
    factor = ca.chol(posture.mass_matrix())  # M = factorᵀ factor
    return ca.solve(factor, ca.solve(factor.T, posture.jacobian.T)).T


def _mobility_root(posture: Posture) -> ca.SX:
    """B (m, n) with B Bᵀ = J M⁻¹ Jᵀ."""
    return ca.solve(ca.chol(posture.mass_matrix()).T, posture.jacobian.T).T
