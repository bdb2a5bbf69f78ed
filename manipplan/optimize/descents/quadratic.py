"""The quadratic program of one step, by DAQP: a convex model, and rows that are relaxed where they contradict each other."""

from dataclasses import dataclass
from typing import Any

import daqp
import numpy as np

from manipplan.optimize.descents import arithmetic
from manipplan.optimize.descents.rows import LinearRows
from manipplan.paths.rounding import with_bits
from manipplan.support.checks import Array

#: Minimum eigenvalue of a convex model, as a share of the largest absolute one.
LEAST_CURVATURE = 1e-6
#: When no step meets all rows: curvature that is added to the model, as a share of its largest and of ν, and the minimum ν.
SOFT, SOFT_PENALTY = 1e-5, 1e3
#: Largest penalty parameter ν, in units of g per metre or radian.
LARGEST_PENALTY = 1e6
#: Inputs of DAQP are rounded to this number of bits, values of rows to multiples of a spacing [rad or m], and steps to fewer
#: bits, so that rounding errors are not amplified from step to step.
QP_BITS, ROW_SPACING, STEP_BITS = 24, 2.0**-30, 12
#: For DAQP: the value of an absent bound, the tolerances that are tried in turn, and the maximum number of iterations.
NONE, QP_TOLERANCES, QP_STEPS = 1e30, (1e-10, 1e-8), 3000


@dataclass(frozen=True, kw_only=True)
class QuadraticStep:
    """A step p (f n,), the violation that its linear rows leave [rad or m], and the multipliers (r,) of these rows."""

    p: Array
    slack: float
    multipliers: Array


def convex(hessian: Array) -> Array:
    """The symmetric part of a matrix, with its negative and small eigenvalues raised to a small positive one."""
    unchanged = arithmetic.convex_part(hessian, LEAST_CURVATURE)
    if unchanged is not None:
        return unchanged
    values, vectors = np.linalg.eigh((hessian + hessian.T) / 2)
    values = np.maximum(values, LEAST_CURVATURE * np.abs(values).max())
    return np.asarray((vectors * values) @ vectors.T)


def solve_step(
    hessian: Array, gradient: Array, rows: LinearRows, radius: float, penalty: float, moving: Any = slice(None)
) -> QuadraticStep | None:
    """Minimise ½ pᵀ H p + gᵀ p with value + jacobian p >= 0 and |p_i| <= radius, up to rounding; None where DAQP fails.

    Only the entries of p at the index `moving` change; the others are 0. Where no p meets these, or the multipliers are very
    large, the rows are relaxed to value + jacobian p + t >= 0 with one slack t >= 0 that costs ν t [nocedal2006, sec. 18.3].
    """
    # rows that no step reaches cannot be active
    jacobian = np.ascontiguousarray(rows.jacobian[:, moving])
    within, least, jacobian = arithmetic.rows_within(rows.value, jacobian, radius, ROW_SPACING, QP_BITS)
    multipliers, p = np.zeros(len(rows.value)), np.zeros(len(gradient))
    hessian, gradient = (
        with_bits(np.ascontiguousarray(hessian[moving][:, moving]), QP_BITS),
        with_bits(gradient[moving], QP_BITS),
    )
    size = len(gradient)
    bound = np.full(size, radius)
    step = _daqp(hessian, gradient, jacobian, least, -bound, bound)
    if step is not None and step.multipliers.sum() < LARGEST_PENALTY:
        multipliers[within], p[moving] = step.multipliers, with_bits(step.p, STEP_BITS)
        return QuadraticStep(p=p, slack=0.0, multipliers=multipliers)
    # where rows contradict each other DAQP needs some curvature in every unknown, the slack included
    largest = float(np.abs(np.diag(hessian)).max())
    penalty = max(penalty, SOFT_PENALTY)
    whole = np.diag(np.append(np.full(size, SOFT * largest), SOFT * penalty))
    whole[:size, :size] += hessian
    jacobian = np.hstack([jacobian, np.ones((len(least), 1))])
    soft = _daqp(whole, np.append(gradient, penalty), jacobian, least, np.append(-bound, 0.0), np.append(bound, NONE))
    if soft is None:
        return None
    multipliers[within], p[moving] = soft.multipliers, with_bits(soft.p[:size], STEP_BITS)
    return QuadraticStep(p=p, slack=float(soft.p[size]), multipliers=multipliers)


def _daqp(hessian: Array, gradient: Array, jacobian: Array, least: Array, low: Array, high: Array) -> QuadraticStep | None:
    """Minimise ½ xᵀ H x + gᵀ x with jacobian x >= least and low <= x <= high; None where DAQP finds no solution."""
    lower, upper = np.concatenate([low, least]), np.concatenate([high, np.full(len(least), NONE)])
    sense = np.zeros(len(lower), dtype=np.int32)
    for tolerance in QP_TOLERANCES:
        x, _, flag, info = daqp.solve(
            hessian,
            gradient,
            jacobian,
            upper,
            lower,
            sense,
            primal_tol=tolerance,
            dual_tol=tolerance,
            iter_limit=QP_STEPS,
        )
        if flag > 0:
            multipliers = np.maximum(-np.asarray(info["lam"])[len(gradient) :], 0.0)
            return QuadraticStep(p=np.asarray(x), slack=0.0, multipliers=multipliers)
    return None
