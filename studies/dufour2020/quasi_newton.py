"""Quasi-Newton estimates of the Hessian H_m of the manipulability, learned from step to step."""

from dataclasses import dataclass

import casadi as ca

import manipplan as mp

#: Minimum cosine between step and secant for a BFGS update.
SLANTED = 0.01
#: Minimum |eᵀ s| / (‖e‖ ‖s‖) for an SR1 update with the error e = y - B s.
NEGLIGIBLE = 1e-8


@dataclass(frozen=True)
class QuasiNewton(mp.formulations.Formulation):
    """(10) with H_m by an update from gradients.

    Attributes:
        alpha: α >= 0 [1/(unit of m)].
        update: "bfgs" (direct, damped), "sr1", or "bfgs-literal" for the paper's (20).
        convexify: make Q - α T² H_m positive definite where it is not (and count it).
    """

    alpha: float
    update: str
    convexify: bool = True

    def drive(self, measure: mp.formulations.SymbolicMeasure, dt: float) -> mp.formulations.Drive:
        """(11): H = - α T² H_m, g = - α T ∇m. The memory is H_m, ∇m, q, and whether there was a step."""
        q, slope = measure.q, measure.gradient
        n = q.shape[0]
        memory = ca.SX.sym("memory", n * n + 2 * n + 1)
        hessian = learn(self.update, memory, q, slope)
        return mp.formulations.Drive(
            hessian=-self.alpha * dt**2 * hessian,
            gradient=-self.alpha * dt * slope,
            memory=memory,
            next_memory=ca.vertcat(ca.vec(hessian), slope, q, 1),
        )


#: Methods for H_m: those of the package, and the updates.
HESSIANS: dict[str, mp.formulations.Formulation] = {
    "exact": mp.formulations.Objective(1.0),
    "central": mp.formulations.Objective(1.0, hessian="central"),
    "sr1": QuasiNewton(1.0, "sr1"),
    "bfgs": QuasiNewton(1.0, "bfgs"),
    "bfgs-literal": QuasiNewton(1.0, "bfgs-literal"),
}


def learn(name: str, memory: ca.SX, q: ca.SX, slope: ca.SX) -> ca.SX:
    """H_m from that of the last step and the secant s = q - q₋, y = ∇m - ∇m₋; zero at the first step."""
    n = q.shape[0]
    before = ca.reshape(memory[: n * n], n, n)
    y = slope - memory[n * n : n * n + n]
    s = q - memory[n * n + n : n * n + 2 * n]
    update = {"bfgs": _update_bfgs, "sr1": _update_sr1, "bfgs-literal": _update_literally}[name](before, s, y)
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


def _update_sr1(before: ca.SX, s: ca.SX, y: ca.SX) -> ca.SX:
    """The symmetric rank-one update, skipped where it is not defined [nocedal2006, (6.26)]."""
    error = y - before @ s
    along = ca.dot(error, s)
    defined = ca.fabs(along) >= NEGLIGIBLE * ca.sqrt(ca.sumsqr(s) * ca.sumsqr(error)) + 1e-300
    return before + ca.if_else(defined, error @ error.T / ca.if_else(defined, along, 1), 0)


def _update_literally(before: ca.SX, s: ca.SX, y: ca.SX) -> ca.SX:
    """(20) in dufour2020 as printed, which is the update of an inverse Hessian; it starts from the identity."""
    n = s.shape[0]
    first = ca.sumsqr(ca.vec(before)) < 1e-300
    h = ca.if_else(first, ca.SX.eye(n), before)
    along = ca.dot(y, s)
    defined = ca.fabs(along) >= 1e-14 * ca.sqrt(ca.sumsqr(s) * ca.sumsqr(y)) + 1e-300
    rho = 1 / ca.if_else(defined, along, 1)
    left = ca.SX.eye(n) - rho * s @ y.T
    return ca.if_else(defined, left @ h @ left.T + rho * s @ s.T, h)
