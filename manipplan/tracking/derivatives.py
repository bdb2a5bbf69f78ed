"""Gradient and Hessian of a measure in a control step: exact, by differences, or quasi-Newton.

Symmetric matrices of the cost: products that use symmetry, and convexification.
"""

from collections.abc import Callable
from dataclasses import dataclass

import casadi as ca

from manipplan.kinematics.kinematics import SymbolicKinematics
from manipplan.measures.manipulability import REGULARISATION, Yoshikawa
from manipplan.symbolic.derivatives import Factor, log_gradient, log_hessian

GRADIENTS = ("exact", "central")
#: Methods for H_m; the last three are quasi-Newton updates.
CURVATURES = ("exact", "central", "bfgs", "sr1", "bfgs-literal")

#: δq of (17) and (19) [rad or m]; the paper names 1e-4 to 1e-3.
DIFFERENCE = 1e-4

#: Minimum cosine between step and secant for a BFGS update.
SLANTED = 0.01
#: Minimum |eᵀ s| / (‖e‖ ‖s‖) for an SR1 update with the error e = y - B s.
NEGLIGIBLE = 1e-8


@dataclass(frozen=True, kw_only=True)
class SymbolicMeasure:
    """The manipulability m at symbolic q, with the derivatives that a formulation needs.

    Attributes:
        q: (n, 1) symbols.
        value: the manipulability m.
        gradient: ∇m, (n, 1).
        hessian: H_m, (n, n); zero if it is not used.
        log_gradient: function of a regularisation r: the gradient (n, 1) of log sqrt(det(J Jᵀ + r² I)) for Yoshikawa's measure,
            and of log sqrt(m² + r²) for any other.
        memory: symbols of the last step's H_m column by column, ∇m, q, and whether there was a step.
        next_memory: the same of this step.
    """

    q: ca.SX
    value: ca.SX
    gradient: ca.SX
    hessian: ca.SX
    log_gradient: Callable[[float], ca.SX]
    memory: ca.SX
    next_memory: ca.SX

    @classmethod
    def of(cls, symbolic: SymbolicKinematics, gradient: str, hessian: str | None) -> "SymbolicMeasure":
        """The measure of `symbolic`; gradient and hessian by name, hessian None: not used."""
        q = symbolic.chain.q
        n = q.shape[0]
        value, slope, exact_hessian, log_slope = _yoshikawa(symbolic) if symbolic.measure == Yoshikawa() else _any(symbolic)
        if gradient == "central":
            slope = _central_gradient(symbolic.manipulability, q)
        memory = next_memory = ca.SX(0, 1)
        if hessian is None:
            bend = ca.SX(n, n)
        elif hessian == "exact":
            bend = exact_hessian()
        elif hessian == "central":
            bend = _central_hessian(symbolic.manipulability, q)
        else:
            memory = ca.SX.sym("memory", n * n + 2 * n + 1)
            bend = _learn(hessian, memory, q, slope)
            next_memory = ca.vertcat(ca.vec(bend), slope, q, 1)
        return cls(
            q=q, value=value, gradient=slope, hessian=bend, log_gradient=log_slope, memory=memory, next_memory=next_memory
        )


#: m, ∇m, and functions that build H_m and the gradient of log m with a regularisation.
Parts = tuple[ca.SX, ca.SX, Callable[[], ca.SX], Callable[[float], ca.SX]]


def _yoshikawa(symbolic: SymbolicKinematics) -> Parts:
    """From one Cholesky factor of J Jᵀ."""
    jacobian, motion = symbolic.posture.smooth
    factor = Factor.of(jacobian, REGULARISATION)
    slope = log_gradient(factor, motion)

    def hessian() -> ca.SX:
        return factor.manipulability * (log_hessian(factor, motion) + slope @ slope.T)

    return factor.manipulability, factor.manipulability * slope, hessian, lambda r: log_gradient(Factor.of(jacobian, r), motion)


def _any(symbolic: SymbolicKinematics) -> Parts:
    """From the measure's own derivatives."""
    q = symbolic.chain.q
    value, slope = symbolic.manipulability(q), symbolic.gradient(q)
    return value, slope, lambda: symbolic.hessian(q), lambda r: value * slope / (value**2 + r**2)


def _central_gradient(measure: ca.Function, q: ca.SX) -> ca.SX:
    """(17) in dufour2020."""
    shifts = ca.horzsplit(DIFFERENCE * ca.DM.eye(q.shape[0]))
    return ca.vertcat(*((measure(q + shift) - measure(q - shift)) / (2 * DIFFERENCE) for shift in shifts))


def _central_hessian(measure: ca.Function, q: ca.SX) -> ca.SX:
    """(19) in dufour2020."""
    n = q.shape[0]
    shifts = ca.horzsplit(DIFFERENCE * ca.DM.eye(n))
    hessian = ca.SX(n, n)
    for i in range(n):
        for j in range(i + 1):
            corners = [s * t * measure(q + s * shifts[i] + t * shifts[j]) for s in (1, -1) for t in (1, -1)]
            hessian[i, j] = hessian[j, i] = sum(corners) / (4 * DIFFERENCE**2)
    return hessian


def _learn(name: str, memory: ca.SX, q: ca.SX, slope: ca.SX) -> ca.SX:
    """H_m from that of the last step and the secant s = q - q₋, y = ∇m - ∇m₋; zero at the first step."""
    n = q.shape[0]
    before = ca.reshape(memory[: n * n], n, n)
    y = slope - memory[n * n : n * n + n]
    s = q - memory[n * n + n : n * n + 2 * n]
    update = {"bfgs": _update_bfgs, "sr1": _sr1, "bfgs-literal": _literal}[name](before, s, y)
    known, moved = memory[-1] > 0, ca.sumsqr(s) > 1e-16
    return ca.if_else(ca.logic_and(known, moved), update, before)


def _update_bfgs(before: ca.SX, s: ca.SX, y: ca.SX) -> ca.SX:
    """The direct update of B = -H_m, the Hessian of -m, with damping that keeps it positive definite [powell1978].

    If B = 0, it starts from ‖y‖/‖s‖ I.
    """
    n = s.shape[0]
    first = ca.sumsqr(ca.vec(before)) < 1e-300
    scale = ca.sqrt(ca.sumsqr(y) / ca.fmax(ca.sumsqr(s), 1e-300)) + 1e-12
    b = ca.if_else(first, scale * ca.SX.eye(n), -before)
    bs = b @ s
    curvature = ca.fmax(ca.dot(s, bs), 1e-300)
    along = -ca.dot(s, y)
    theta = ca.if_else(along >= 0.2 * curvature, 1, 0.8 * curvature / ca.fmax(curvature - along, 1e-300))
    damped = -theta * y + (1 - theta) * bs
    along = ca.dot(s, damped)
    # a secant perpendicular to the step would make B grow without bound
    is_curved = along > SLANTED * ca.sqrt(ca.sumsqr(s) * ca.sumsqr(damped))
    updated = b - bs @ bs.T / curvature + damped @ damped.T / ca.if_else(is_curved, along, 1)
    return -ca.if_else(is_curved, updated, b)


def _sr1(before: ca.SX, s: ca.SX, y: ca.SX) -> ca.SX:
    """The symmetric rank-one update, skipped where it is not defined [nocedal2006, (6.26)]."""
    error = y - before @ s
    along = ca.dot(error, s)
    defined = ca.fabs(along) >= NEGLIGIBLE * ca.sqrt(ca.sumsqr(s) * ca.sumsqr(error)) + 1e-300
    return before + ca.if_else(defined, error @ error.T / ca.if_else(defined, along, 1), 0)


def _literal(before: ca.SX, s: ca.SX, y: ca.SX) -> ca.SX:
    """(20) in dufour2020 as printed, which is the update of an inverse Hessian; it starts from the identity."""
    n = s.shape[0]
    first = ca.sumsqr(ca.vec(before)) < 1e-300
    h = ca.if_else(first, ca.SX.eye(n), before)
    along = ca.dot(y, s)
    defined = ca.fabs(along) >= 1e-14 * ca.sqrt(ca.sumsqr(s) * ca.sumsqr(y)) + 1e-300
    rho = 1 / ca.if_else(defined, along, 1)
    left = ca.SX.eye(n) - rho * s @ y.T
    return ca.if_else(defined, left @ h @ left.T + rho * s @ s.T, h)


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
