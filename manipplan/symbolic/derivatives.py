"""Gradient and Hessian of Yoshikawa's manipulability m from the kinematic Hessian and trace identities.

m_ρ = sqrt(det(J Jᵀ + ρ² I)) is m with the regularisation ρ: it equals m up to a relative error of Σ ρ²/(2 σ_i²), with σ_i the
singular values, and stays smooth at m = 0, where m has a kink.
Symbols: L Lᵀ = J Jᵀ + ρ² I, J = L Qᵀ; P = L⁻ᵀ Qᵀ, so that Pᵀ = J⁺ for ρ = 0; D_k = ∂J/∂q_k.

The determinant of a sparse symbolic matrix as a polynomial in its entries: smooth, signed, and cheap to differentiate.
"""

from dataclasses import dataclass

import casadi as ca

from manipplan.symbolic.motion import Motion


@dataclass(frozen=True, kw_only=True)
class Factor:
    """J = L Qᵀ with L Lᵀ = J Jᵀ + ρ² I: L (m, m) lower triangular; Q (n, m) has orthonormal columns when ρ = 0."""

    L: ca.SX
    Q: ca.SX

    @classmethod
    def of(cls, jacobian: ca.SX, regularisation: float) -> "Factor":
        """By Gram-Schmidt on the rows of [J, ρ I], so that no digits are lost by squaring in J Jᵀ."""
        m, n = jacobian.shape
        lower = ca.SX(m, m)
        rows: list[ca.SX] = []
        for i, row in enumerate(ca.vertsplit(ca.horzcat(jacobian, regularisation * ca.SX.eye(m)))):
            for j, before in enumerate(rows):
                lower[i, j] = ca.dot(before, row)
                row = row - lower[i, j] * before  # noqa: PLW2901
            lower[i, i] = ca.sqrt(ca.sumsqr(row))
            rows.append(row / lower[i, i])
        return cls(L=lower, Q=ca.vertcat(*rows)[:, :n].T)

    @property
    def manipulability(self) -> ca.SX:
        """m_ρ."""
        product = self.L[0, 0]
        for i in range(1, self.L.shape[0]):
            product *= self.L[i, i]
        return product

    @property
    def weights(self) -> ca.SX:
        """P, (m, n)."""
        return ca.solve(self.L.T, self.Q.T)


def log_gradient(factor: Factor, motion: Motion) -> ca.SX:
    """∇ log m_ρ, (n, 1): its entries are tr((J Jᵀ + ρ² I)⁻¹ D_k Jᵀ) = <P, D_k>, (18) in dufour2020."""
    return motion.first(factor.weights)


def log_hessian(factor: Factor, motion: Motion) -> ca.SX:
    """The Hessian of log m_ρ, (n, n).

    With E_k = L⁻¹ D_k and F_k = E_k Q its entries are tr(∂_l D_k Pᵀ) + <E_k, E_l> - tr(F_k F_l) - <F_k, F_l>.
    """
    inverse = ca.solve(factor.L, ca.SX.eye(factor.L.shape[0]))
    scaled = [inverse @ derivative for derivative in motion.kinematic_hessian()]
    turned = [each @ factor.Q for each in scaled]
    symmetric = [each + each.T for each in turned]  # tr(F_k F_l) + <F_k, F_l> = <F_k + F_kᵀ, F_l + F_lᵀ> / 2
    hessian = motion.second(factor.weights)
    for k in range(len(scaled)):
        for j in range(k + 1):
            entry = hessian[k, j] + ca.dot(scaled[k], scaled[j]) - ca.dot(symmetric[k], symmetric[j]) / 2
            hessian[k, j] = hessian[j, k] = entry
    return hessian


def manipulability_gradient(jacobian: ca.SX, motion: Motion, regularisation: float) -> ca.SX:
    """∇m_ρ, (n, 1)."""
    factor = Factor.of(jacobian, regularisation)
    return factor.manipulability * log_gradient(factor, motion)


def manipulability_hessian(jacobian: ca.SX, motion: Motion, regularisation: float) -> ca.SX:
    """∇²m_ρ = m_ρ (∇² log m_ρ + ∇ log m_ρ ∇ log m_ρᵀ), (n, n)."""
    factor = Factor.of(jacobian, regularisation)
    slope = log_gradient(factor, motion)
    return factor.manipulability * (log_hessian(factor, motion) + slope @ slope.T)


def determinant(matrix: ca.SX) -> ca.SX:
    """det of a matrix (n, n) by Laplace's expansion, with each minor computed once; zero entries cost nothing.

    No division occurs, so the expression and its derivatives are exact at singular matrices too.
    """
    n = matrix.shape[0]
    minors: dict[tuple[int, ...], ca.SX] = {(): ca.SX(1.0)}  # of the first rows, by their columns
    for i in range(n):
        larger: dict[tuple[int, ...], ca.SX] = {}
        for columns, minor in minors.items():
            for j in range(n):
                if j in columns or matrix[i, j].is_zero():
                    continue
                chosen = tuple(sorted((*columns, j)))
                sign = (-1) ** sum(column > j for column in columns)
                larger[chosen] = larger.get(chosen, ca.SX(0.0)) + sign * minor * matrix[i, j]
        minors = larger
    return minors.get(tuple(range(n)), ca.SX(0.0))
