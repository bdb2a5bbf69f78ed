"""Sequential quadratic programming on g itself, or on its energy, in a trust region [nocedal2006, sec. 18.5].

Each step minimises a quadratic model of g in a trust region, with linear rows for the joint limits and for the clearance at
every place where the path is near something. A step is accepted only when the merit function φ = g + ν v falls. Here v is the
largest violation of limits, clearance and constraints, measured on the whole path with the true distances, and ν is the penalty
parameter.

The Hessian of the model is that of the Lagrangian. It includes the second derivatives of the clearance: the turn of the plane
between two bodies, and the shift of the place where they are nearest. The model is made convex before it is minimised.

DAQP solves the quadratic program of one step. Rows that contradict each other are relaxed.
"""

import logging
from collections import deque
from dataclasses import dataclass, replace
from enum import Enum
from functools import cached_property
from typing import Any

import daqp
import numpy as np
from numpy.typing import NDArray

from manipplan.optimize import steps
from manipplan.optimize.rows import (
    ClearanceSearch,
    ConstraintSearch,
    FixedRows,
    LimitRows,
    LinearRows,
    NonlinearRows,
    RowSource,
)
from manipplan.optimize.steps import LengthModel
from manipplan.paths.rounding import with_bits
from manipplan.support.checks import Array
from manipplan.support.deadline import NEVER, Deadline
from manipplan.support.progress import interruptible

log = logging.getLogger("manipplan")


@dataclass(frozen=True, kw_only=True, eq=False)
class DescentProgram:
    """Objective and constraints of a descent.

    Attributes:
        length: g as a function of the unknowns.
        limits: the joint limits.
        clearance: distances of the true bodies, or clearance rows that stay where they are; None: nothing is checked.
        constraints: what is kept beside limits and clearance; None: nothing.
        held: (n,) whether a joint keeps its value.
    """

    length: LengthModel
    limits: LimitRows
    clearance: ClearanceSearch | FixedRows | None = None
    constraints: ConstraintSearch | None = None
    held: NDArray[np.bool_] | None = None

    @cached_property
    def moving(self) -> Any:
        """Index of the unknowns (f n,) that steps may change."""
        if self.held is None or not self.held.any():
            return slice(None)
        return np.flatnonzero(np.tile(~self.held, self.length.curves.directions.shape[1]))

    @property
    def is_checked(self) -> bool:
        """Whether distances are measured."""
        return isinstance(self.clearance, ClearanceSearch)


@dataclass(frozen=True, kw_only=True, eq=False)
class Point:
    """A path that was tried: its unknowns z (f, n), and its value g over g₀, inf where that is not finite.

    `rows` are those of clearance and of constraints that a step can make negative; none where nothing is checked.
    """

    program: DescentProgram
    z: Array
    value: float
    rows: tuple[NonlinearRows, ...]

    @classmethod
    def of(cls, program: DescentProgram, z: Array, radius: float) -> "Point":
        """The path at z (f, n), with the rows that a step of `radius` can reach."""
        curves, value = program.length.curves, program.length.value(z)
        kinds: tuple[RowSource | None, ...] = (program.clearance, program.constraints)
        sources = [each for each in kinds if each is not None]
        rows: tuple[NonlinearRows, ...] = ()
        if sources:
            curve = curves.curve(z)
            rows = tuple(each.at(curves, z, curve, radius) for each in sources)
        return cls(program=program, z=z, value=value if np.isfinite(value) else np.inf, rows=rows)

    @cached_property
    def violation(self) -> float:
        """Largest violation of limits, target clearance and constraints [rad or m]."""
        return max(self.program.limits.violation(self._control), *(each.violation for each in self.rows), 0.0)

    @cached_property
    def linear(self) -> LinearRows:
        """All these rows for steps from here."""
        return LinearRows.stacked([each.linear for each in self.rows], self.z.size)

    def curvature(self, multipliers: Array) -> Array:
        """Σ_i λ_i ∇²c_i (f n, f n) of these rows, with multipliers λ (r,)."""
        total, first = np.zeros((self.z.size, self.z.size)), 0
        for each in self.rows:
            total += each.curvature(multipliers[first : first + len(each.s)])
            first += len(each.s)
        return total

    def limits(self, radius: float) -> LinearRows:
        """The joint limits that a step whose entries are at most `radius` can reach."""
        return self.program.limits.near(self._control, radius)

    def merit(self, penalty: float) -> float:
        """φ = g + ν v."""
        return self.value + penalty * self.violation

    @cached_property
    def _control(self) -> Array:
        """The control points (r, n) that keep the joint limits."""
        return self.program.limits.points(self.z)


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
    unchanged = steps.convex_part(hessian, LEAST_CURVATURE)
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
    within, least, jacobian = steps.rows_within(rows.value, jacobian, radius, ROW_SPACING, QP_BITS)
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
            hessian, gradient, jacobian, upper, lower, sense, primal_tol=tolerance, dual_tol=tolerance, iter_limit=QP_STEPS
        )
        if flag > 0:
            multipliers = np.maximum(-np.asarray(info["lam"])[len(gradient) :], 0.0)
            return QuadraticStep(p=np.asarray(x), slack=0.0, multipliers=multipliers)
    return None


#: Maximum number of steps with collision checks, and without them, where a step takes a tenth of the time.
STEPS, FREE_STEPS = 100, 300
#: First, largest and smallest radius of the trust region: the maximum change of each unknown [rad or m].
RADIUS, LARGEST_RADIUS, SMALLEST_RADIUS = 0.1, 0.8, 1e-8
#: The descent ends when the model predicts that the merit function falls by less than this share of g: with collision checks,
#: and without. Between ends less than 1 rad or m apart the first falls with their squared distance: a gradient per radian that
#: the certificate does not accept lowers g by that share only.
TOLERANCE, FREE_TOLERANCE = 5e-7, 1e-9
#: Before it ends, the radius is set back to its first value for at most this number of steps. At a saddle of g the gradient is
#: zero, and only a long step along negative curvature lowers g. A descent with a larger tolerance than this ends at once:
#: another one follows it.
WIDE_STEPS, MOST_TOLERANCE = 3, 1e-5
#: While the violation is above the first value, a radius below the second one is set back as well [rad or m]: deep in an
#: obstacle short steps lead nowhere.
DEEP, SHORT = 5e-3, 1e-3
#: The descent ends where the violation stays above DEEP and falls by less than this share over this number of steps: paths that
#: come out of an obstacle do so much faster.
LITTLE, WINDOW = 0.1, 5
#: A step is accepted when the actual decrease is more than this share of the predicted one. Up to the second share, a
#: second-order correction is tried.
ACCEPTED, CORRECTED = 1e-4, 0.75
#: A violation below this is ignored by the update of ν [rad or m].
EXACT = 1e-9
#: Smallest penalty parameter ν, which is also the first, in units of g per metre or radian.
LEAST_PENALTY = 2.0
#: 1 - ρ in (18.36) of nocedal2006: the share of ν times the restored violation that g may rise by.
MENDED = 0.7


class Ending(Enum):
    """Why a descent ended."""

    CONVERGED = "no step lowers g"
    SHORT = "steps became too short"
    STUCK = "stuck in an obstacle"
    #: DAQP could not minimise the model, or it is not finite.
    FAILED = "the quadratic program failed"
    MOST_STEPS = "the maximum number of steps was reached"
    LATE = "the time limit was reached"


@dataclass(frozen=True, kw_only=True)
class Descent:
    """Where a descent ended: unknowns z (f, n), the number of steps that were tried, and the largest violation [rad or m]."""

    z: Array
    steps: int
    ending: Ending
    violation: float

    @property
    def exhausted(self) -> bool:
        """Whether it ended before it converged."""
        return self.ending in (Ending.MOST_STEPS, Ending.LATE)


@dataclass(frozen=True, kw_only=True, eq=False)
class _Model:
    """The quadratic model of the Lagrangian about a point.

    Attributes:
        gradient: (f n,) of g.
        hessian: (f n, f n) of the Lagrangian: that of g minus `curvature`. It may be indefinite.
        near: linear rows of clearance and constraints about the point.
        active: the active rows.
        bend: largest diagonal entry of the Hessian of g.
        curvature: (f n, f n) Σ_i λ_i ∇²d_i of these rows.
        is_lasting: whether another model about the same point would be the same, as no row bends.
        first: where no row is active, the convex Hessian of the first quadratic program, its radius and its step, which are
            those of the model itself; otherwise None.
    """

    gradient: Array
    hessian: Array
    near: LinearRows
    active: LinearRows
    bend: float
    curvature: Array
    is_lasting: bool
    first: tuple[Array, float, QuadraticStep] | None

    @classmethod
    def of(cls, program: DescentProgram, at: Point, radius: float, penalty: float, previous: Array) -> "_Model | None":
        """The model about a point; None where DAQP fails, or a derivative of g is not finite.

        The multipliers come from a first quadratic program, with the `previous` curvature (f n, f n) of the rows.
        """
        slope, hessian = program.length.derivatives(at.z)
        gradient = slope.ravel()
        if not (np.isfinite(gradient).all() and np.isfinite(hessian).all()):
            return None
        near = at.linear
        rows = LinearRows.stacked([at.limits(radius), near])
        quadratic = convex(hessian - previous)
        step = solve_step(quadratic, gradient, rows, radius, penalty, program.moving)
        if step is None:
            return None
        multipliers = step.multipliers
        curvature = at.curvature(multipliers[len(multipliers) - len(near.value) :])
        active = multipliers > 0
        is_lasting = not (previous.any() or curvature.any())
        return cls(
            gradient=gradient,
            hessian=hessian - curvature,
            near=near,
            active=LinearRows(value=rows.value[active], jacobian=rows.jacobian[active]),
            bend=float(np.abs(np.diag(hessian)).max()),
            curvature=curvature,
            is_lasting=is_lasting,
            first=(quadratic, radius, step) if is_lasting and not active.any() else None,
        )

    def step(self, here: Point, radius: float, penalty: float, *, is_plain: bool) -> QuadraticStep | None:
        """The step of the model in a trust region; None where DAQP fails."""
        if self.first is not None and self.first[1] == radius:
            return self.first[2]
        quadratic = self.plain if is_plain else self.augmented
        rows = LinearRows.stacked([here.limits(radius), self.near])
        return solve_step(*quadratic, rows, radius, penalty, here.program.moving)

    @cached_property
    def augmented(self) -> tuple[Array, Array]:
        """A convex Hessian (f n, f n) and a gradient (f n,), with ½ ρ ‖A p + c‖² added for the active rows A p + c.

        The addition does not change the step while these rows stay active.
        """
        if self.first is not None:
            return self.first[0], self.gradient
        value, jacobian = self.active.value, self.active.jacobian
        rho = self.bend / max(float((jacobian**2).sum(axis=1).max(initial=0.0)), 1e-12)
        return convex(self.hessian + rho * jacobian.T @ jacobian), self.gradient + rho * jacobian.T @ value

    @cached_property
    def plain(self) -> tuple[Array, Array]:
        """The same without the addition: tried where `augmented` gives no step that lowers the merit function."""
        return self.augmented if self.first is not None else (convex(self.hessian), self.gradient)

    def with_rejected(self, here: Point, there: Point) -> "_Model":
        """The same model about `here`, with rows for the bodies that a rejected step met at `there`."""
        more = [each.violated_from(here.z) for each in there.rows]
        found = [each for each in more if each is not None]
        return replace(self, near=LinearRows.stacked([self.near, *found]), first=None) if found else self

    def predict_decrease(self, step: QuadraticStep, restored: float, penalty: float) -> float:
        """Decrease of the merit function that the model predicts for a step that lowers the violation by `restored`.

        -(∇gᵀ p + ½ pᵀ H p) + ν restored, where H is the Hessian of the Lagrangian and not a convex one.
        """
        return float(-(self.gradient @ step.p + 0.5 * step.p @ self.hessian @ step.p) + penalty * restored)


@interruptible()
def descend(
    program: DescentProgram,
    z: Array,
    *,
    tolerance: float | None = None,
    accuracy: float = 1.0,
    steps: int | None = None,
    first_radius: float = RADIUS,
    least_penalty: float = LEAST_PENALTY,
    patient: bool = False,
    deadline: Deadline = NEVER,
) -> Descent:
    """Minimise g from z (f, n) to a local optimum of the true problem.

    Args:
        program, z: what is minimised, and the first unknowns (f, n).
        tolerance: the descent ends when the predicted decrease of the merit function is below this share of g; default
            TOLERANCE, for short paths less, or FREE_TOLERANCE without collision checks.
        accuracy: factor of the default tolerance.
        steps: maximum number of steps; default: STEPS, or FREE_STEPS without collision checks.
        first_radius: first radius of the trust region [rad or m].
        least_penalty: first and smallest penalty parameter ν.
        patient: the descent goes on where the violation hardly falls; a few come out of an obstacle only after many steps.
        deadline: no step is begun after it.
    """
    usual_steps, usual_tolerance = FREE_STEPS, FREE_TOLERANCE
    if program.is_checked:
        curves = program.length.curves
        apart = float(np.linalg.norm(curves.goal - curves.start))
        usual_steps, usual_tolerance = STEPS, TOLERANCE * min(1.0, apart) ** 2
    steps = usual_steps if steps is None else steps
    tolerance = accuracy * usual_tolerance if tolerance is None else tolerance
    radius, penalty = first_radius, least_penalty
    here = Point.of(program, z, radius)
    model: _Model | None = None
    curvature = np.zeros((z.size, z.size))
    widens = tolerance <= MOST_TOLERANCE
    is_plain = False  # whether model.plain gives the step
    wide_steps = 0  # steps left since the radius was set back to RADIUS, 0 before that
    violations = deque([here.violation], maxlen=WINDOW + 1)

    def ended(steps: int, ending: Ending) -> Descent:
        log.debug("descent: %s after %d steps", ending.value, steps)
        return Descent(z=here.z, steps=steps, ending=ending, violation=here.violation)

    for count in range(steps):
        if deadline.passed:
            return ended(count, Ending.LATE)
        if model is None:
            model, is_plain = _Model.of(program, here, radius, penalty, curvature), False
            if model is None:
                return ended(count, Ending.FAILED)
            curvature = model.curvature
        step = model.step(here, radius, penalty, is_plain=is_plain)
        if step is None:
            return ended(count, Ending.FAILED)
        if step.slack == 0.0:  # φ is exact where ν is larger than Σ λ [nocedal2006, sec. 17.2]
            penalty = max(penalty, min(2 * float(step.multipliers.sum()), LARGEST_PENALTY))
        restored = here.violation - step.slack
        if restored > EXACT:  # a step that restores feasibility may raise g, and φ must fall: (18.36) in nocedal2006
            penalty = max(penalty, min(-model.predict_decrease(step, restored, 0.0) / (MENDED * restored), LARGEST_PENALTY))
        predicted = model.predict_decrease(step, restored, penalty)
        if predicted < tolerance * here.value or (here.violation > DEEP and radius < SHORT):
            is_same = model.is_lasting and radius >= first_radius  # a new model with the first radius
            if not is_plain and model.first is None:
                is_plain = True
            elif widens and wide_steps == 0 and not is_same:
                radius, wide_steps = first_radius, WIDE_STEPS
                here, model = Point.of(program, here.z, radius), None
            else:
                return ended(count, Ending.CONVERGED)
            continue
        quadratic = model.plain if is_plain else model.augmented
        new, decrease = _tried(program, quadratic, here, step, predicted, radius, penalty)
        size = float(np.abs(step.p).max())
        if decrease <= ACCEPTED * predicted:
            model = model.with_rejected(here, new)
        else:
            here, model, wide_steps = new, None, 0
            penalty = max(penalty / 2, least_penalty)
            if decrease > 0.5 * predicted and size > 0.7 * radius:
                radius = min(2 * radius, LARGEST_RADIUS)
        violations.append(here.violation)
        if not patient and len(violations) > WINDOW and min(violations) > max(DEEP, (1 - LITTLE) * violations[0]):
            return ended(count + 1, Ending.STUCK)
        if decrease < 0.25 * predicted:  # as in algorithm 4.1 of nocedal2006
            radius = size / 4
            if wide_steps > 0:
                wide_steps -= 1
                if wide_steps == 0:
                    return ended(count + 1, Ending.CONVERGED)
            if radius < SMALLEST_RADIUS:
                return ended(count + 1, Ending.SHORT)
    return ended(steps, Ending.MOST_STEPS)


def _tried(
    program: DescentProgram,
    quadratic: tuple[Array, Array],
    here: Point,
    step: QuadraticStep,
    predicted: float,
    radius: float,
    penalty: float,
) -> tuple[Point, float]:
    """The point a step leads to, and the actual decrease of the merit function.

    Where the decrease is small a second-order correction is tried, with rows from that point: the step near the first one that
    keeps them, and takes up the slack that distances leave where they grow faster than their rows. Its point is returned if it
    is better [nocedal2006, sec. 15.6].
    """
    before = here.merit(penalty)
    new = Point.of(program, here.z + step.p.reshape(here.z.shape), radius)
    decrease = before - new.merit(penalty)
    if decrease > CORRECTED * predicted or not new.linear.value.size or not np.isfinite(new.value):
        return new, decrease
    rows = LinearRows.stacked([here.limits(radius), new.linear.from_step((here.z - new.z).ravel())])
    hessian, gradient = quadratic
    even = float(np.abs(np.diag(hessian)).max()) * np.eye(len(step.p))
    corrected = solve_step(even, gradient + (hessian - even) @ step.p, rows, radius, penalty, program.moving)
    if corrected is not None:
        other = Point.of(program, here.z + corrected.p.reshape(here.z.shape), radius)
        if before - other.merit(penalty) > decrease:
            return other, before - other.merit(penalty)
    return new, decrease
