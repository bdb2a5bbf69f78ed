"""Gradient and Hessian of a measure in a control step: exact, or by differences.

Symmetric matrices of the cost: products that use symmetry, and convexification.
"""

from functools import cached_property

import casadi as ca

from manipplan.kinematics.kinematics import SymbolicKinematics
from manipplan.measures.manipulability import Yoshikawa
from manipplan.measures.measure import REGULARISATION
from manipplan.symbolic.motion import Factor, log_gradient, log_hessian

#: δq of (17) and (19) in dufour2020 [rad or m]; the paper names 1e-4 to 1e-3.
DIFFERENCE = 1e-4


class SymbolicMeasure:
    """The manipulability m at symbolic q, with the derivatives that a formulation may use.

    Attributes:
        q: (n, 1) symbols.
        value: the manipulability m.
        gradient: ∇m, (n, 1).
    """

    def __init__(self, symbolic: SymbolicKinematics) -> None:
        """The measure of `symbolic`; Yoshikawa's from one Cholesky factor of J Jᵀ, any other from its own derivatives."""
        self._symbolic = symbolic
        self.q: ca.SX = symbolic.chain.q
        self._factor: Factor | None = None
        if symbolic.measure == Yoshikawa():
            jacobian, motion = symbolic.posture.smooth
            self._factor = Factor.of(jacobian, REGULARISATION)
            self.value: ca.SX = self._factor.manipulability
            self.gradient: ca.SX = self.value * log_gradient(self._factor, motion)
        else:
            self.value, self.gradient = symbolic.manipulability(self.q), symbolic.gradient(self.q)

    @cached_property
    def hessian(self) -> ca.SX:
        """H_m, (n, n)."""
        if self._factor is None:
            return self._symbolic.hessian(self.q)
        motion = self._symbolic.posture.smooth[1]
        slope = log_gradient(self._factor, motion)
        return self.value * (log_hessian(self._factor, motion) + slope @ slope.T)

    @cached_property
    def central_gradient(self) -> ca.SX:
        """∇m (n, 1) by differences, (17) in dufour2020."""
        measure, q = self._symbolic.manipulability, self.q
        shifts = ca.horzsplit(DIFFERENCE * ca.DM.eye(q.shape[0]))
        return ca.vertcat(*((measure(q + shift) - measure(q - shift)) / (2 * DIFFERENCE) for shift in shifts))

    @cached_property
    def central_hessian(self) -> ca.SX:
        """H_m (n, n) by differences, (19) in dufour2020."""
        measure, q = self._symbolic.manipulability, self.q
        n = q.shape[0]
        shifts = ca.horzsplit(DIFFERENCE * ca.DM.eye(n))
        hessian = ca.SX(n, n)
        for i in range(n):
            for j in range(i + 1):
                corners = [s * t * measure(q + s * shifts[i] + t * shifts[j]) for s in (1, -1) for t in (1, -1)]
                hessian[i, j] = hessian[j, i] = sum(corners) / (4 * DIFFERENCE**2)
        return hessian

    def log_gradient(self, regularisation: float) -> ca.SX:
        """Gradient (n, 1) of log sqrt(det(J Jᵀ + r² I)) for Yoshikawa's measure, and of log sqrt(m² + r²) for any other."""
        if self._factor is None:
            return self.value * self.gradient / (self.value**2 + regularisation**2)
        jacobian, motion = self._symbolic.posture.smooth
        return log_gradient(Factor.of(jacobian, regularisation), motion)


#: Minimum pivot, as a share of the largest entries; smaller ones are raised to it.
PIVOT = 1e-8


def gram(matrix: ca.SX) -> ca.SX:
    """matrixᵀ matrix; entries that are equal by symmetry are computed once."""
    columns = ca.horzsplit(matrix)
    product = ca.SX(len(columns), len(columns))
    for i, first in enumerate(columns):
        for j, second in enumerate(columns[: i + 1]):
            product[i, j] = product[j, i] = ca.dot(first, second)
    return product


def convexified(matrix: ca.SX) -> tuple[ca.SX, ca.SX]:
    """`matrix` (n, n) plus a diagonal >= 0 that makes it positive definite, and the largest entry of that diagonal.

    The diagonal is zero if the matrix is positive definite already. The method is L D Lᵀ with pivots raised so that no
    entry of L D^½ exceeds a bound [gill1981, section 4.4.2.2].
    """
    n = matrix.shape[0]
    largest = _largest([ca.fabs(matrix[i, i]) for i in range(n)])
    across = _largest([ca.fabs(matrix[i, j]) for i in range(n) for j in range(i)]) if n > 1 else ca.SX(0)
    bound = _largest([largest, across / max((n**2 - 1) ** 0.5, 1.0), ca.SX(1e-300)])
    least = PIVOT * ca.fmax(largest + across, 1e-300)
    columns = ca.SX(matrix)
    pivots: list[ca.SX] = []
    added: list[ca.SX] = []
    for j in range(n):
        below = [columns[i, j] for i in range(j + 1, n)]
        widest = _largest([ca.fabs(each) for each in below]) if below else ca.SX(0)
        pivot = _largest([ca.fabs(columns[j, j]), widest**2 / bound, least])
        added.append(pivot - columns[j, j])
        pivots.append(pivot)
        for i in range(j + 1, n):
            for k in range(j + 1, i + 1):
                columns[i, k] -= columns[i, j] * columns[k, j] / pivot
    extra = _largest(added)
    return matrix + ca.diag(ca.vertcat(*added)), ca.if_else(extra > least, extra, 0)


def _largest(values: list[ca.SX]) -> ca.SX:
    top = values[0]
    for each in values[1:]:
        top = ca.fmax(top, each)
    return top
