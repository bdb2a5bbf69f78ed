"""Sequential quadratic programming on g itself, among the true obstacles.

Each step minimises a quadratic model of g in a trust region, with linear rows for the joint limits and for the clearance at
every place where the path is near something. It is taken when a merit falls: g and ν times the largest violation of limits
and clearance, which is measured on the whole path with the true distances. So g does not go up and down between steps, and
the rows follow the nearest points until both settle [nocedal2006, ch. 18].

The Hessian of the model is that of the Lagrangian. Its part of the clearance is exact: it has the turn of the plane between
two bodies, and the shift of the place where they are nearest. Along active rows it is made convex by adding ρ AᵀA, which
does not change the step while these rows stay active.
"""

import logging
from dataclasses import dataclass, replace

import daqp
import numpy as np

from manipplan.checks import Array
from manipplan.interrupts import interruptible
from manipplan.optimize.constraints import ClearanceTable, LimitRows, LinearRows, RowFunctions
from manipplan.optimize.length_model import LengthModel
from manipplan.optimize.surroundings import Look, Surroundings
from manipplan.paths.joint import JointPath

log = logging.getLogger("manipplan")

#: Maximum number of steps among obstacles, and where nothing is in the way, which takes a tenth of the time.
STEPS, FREE_STEPS = 100, 300
#: First, largest and smallest radius of the trust region, in every unknown [rad or m].
RADIUS, LARGEST_RADIUS, SMALLEST_RADIUS = 0.1, 0.8, 1e-8
#: The descent ends when the model promises to lower the merit by a smaller share of g than this: among obstacles, and without.
PROMISE, FREE_PROMISE = 5e-7, 1e-9
#: Before it does, it tries longer steps up to this number of times: where g has a saddle the gradient does not show the way.
WIDE_TRIES = 3
#: A step is taken when the merit falls by this share of what the model promised; a second-order correction is tried below this.
TAKEN, CORRECTED = 1e-4, 0.75
#: A violation below this needs no correction [rad or m].
EXACT = 1e-9
#: Curvatures of the model are at least this share of the largest.
LEAST_CURVATURE = 1e-7
#: The same where no step meets all rows.
SOFT, SOFT_PENALTY = 1e-5, 1e3
#: First, smallest and largest ν, in units of g per metre.
PENALTY, LEAST_PENALTY, LARGEST_PENALTY = 10.0, 10.0, 1e6
#: Share of the merit's fall by mended violations that may be spent on g.
MENDED = 0.7
#: Distance from the target that a step can use up [m per rad of the radius], at least and at most [m].
BAND, LEAST_BAND, MOST_BAND = 1.0, 2e-3, 0.1
#: Bound that stands for none, for DAQP; its tolerances, the next where it fails with one; its maximum number of iterations.
NONE, TOLERANCES, QP_STEPS = 1e30, (1e-10, 1e-8), 3000


@dataclass(frozen=True, kw_only=True)
class Descent:
    """Where a descent ended.

    Attributes:
        z: unknowns (f, n).
        violation: the largest violation of limits and target clearance there [rad or m].
        steps: how many were tried.
        reason: why it ended.
    """

    z: Array
    violation: float
    steps: int
    reason: str


@dataclass(frozen=True, kw_only=True, eq=False)
class TrueProgram:
    """g of the curves, joint limits, and the clearance of the true bodies."""

    length: LengthModel
    limits: LimitRows
    functions: RowFunctions
    surroundings: Surroundings | None

    def path(self, z: Array) -> JointPath:
        """The path of unknowns z (f, n)."""
        curves = self.length.curves
        return curves.basis.path(curves.start, curves.goal, curves.coefficients(z))

    def look(self, z: Array, radius: float) -> Look:
        """What is near the path at z, as far as a step of `radius` can come."""
        if self.surroundings is None:
            return Look(places=(), distances=np.empty(0), bottoms=frozenset())
        return self.surroundings.look(self.path(z), min(max(BAND * radius, LEAST_BAND), MOST_BAND))

    def violation(self, z: Array, look: Look) -> float:
        """The largest violation at z [rad or m]."""
        short = 0.0 if self.surroundings is None else max(self.surroundings.target - look.least, 0.0)
        return max(short, self.limits.violation(z))

    def seen(self, here: "_Point", there: "_Point") -> ClearanceTable | None:
        """Rows at `here` of planes that separate bodies `there`, where they say nothing that is not true `here`."""
        if self.surroundings is None:
            return None
        table = ClearanceTable.seen(self.functions, self.length.curves, self.surroundings, self.path(there.z), there.look)
        return table.usable(here.z)

    def table(self, z: Array, look: Look) -> ClearanceTable:
        """The clearance rows at z."""
        return ClearanceTable.of(self.functions, self.length.curves, self.surroundings, self.path(z), look)


@dataclass(frozen=True, kw_only=True, eq=False)
class _Point:
    """A path that was tried: its unknowns, g in units of g₀, what is near it, and its largest violation."""

    z: Array
    value: float
    look: Look
    violation: float

    @classmethod
    def of(cls, program: TrueProgram, z: Array, radius: float) -> "_Point":
        look = program.look(z, radius)
        value = program.length.value(z)
        return cls(z=z, value=value if np.isfinite(value) else np.inf, look=look, violation=program.violation(z, look))

    def merit(self, penalty: float) -> float:
        return self.value + penalty * self.violation


@dataclass(frozen=True, kw_only=True)
class _Step:
    """A step p (f n,), how far its rows stay violated, and the multipliers of its rows."""

    p: Array
    slack: float
    multipliers: Array


@dataclass(frozen=True, kw_only=True, eq=False)
class _Model:
    """The quadratic model of the Lagrangian about a point.

    Attributes:
        gradient: of g (f n,).
        hessian: of the Lagrangian (f n, f n).
        clearance: rows about the point.
        forms: Hessians with positive eigenvalues and gradients by which steps are looked for, one after the other.
        curvature: the part of `hessian` that the clearance has.
    """

    gradient: Array
    hessian: Array
    clearance: LinearRows
    forms: tuple[tuple[Array, Array], ...]
    curvature: Array

    @classmethod
    def of(cls, program: TrueProgram, at: _Point, radius: float, penalty: float, known: Array) -> "_Model | None":
        """The model about a point; `known` is the curvature of the point before it. None where DAQP fails."""
        table = program.table(at.z, at.look)
        clearance = table.linear(at.z, at.z)
        gradient, hessian = program.length.gradient(at.z).ravel(), program.length.hessian(at.z)
        rows = program.limits.near(at.z, radius).with_rows(clearance)
        step = _solve(_convex(hessian - known), gradient, rows, radius, penalty)
        if step is None:
            return None
        multipliers = step.multipliers
        curvature = table.curvature(at.z, multipliers[len(multipliers) - len(clearance.value) :])
        whole = hessian - curvature
        active = multipliers > 0
        jacobian = rows.jacobian[active]
        stiff = float(np.abs(np.diag(hessian)).max()) / max(float((jacobian**2).sum(axis=1).max(initial=0.0)), 1e-12)
        firm = _convex(whole + stiff * jacobian.T @ jacobian)
        return cls(
            gradient=gradient,
            hessian=whole,
            clearance=clearance,
            forms=((firm, gradient + stiff * jacobian.T @ rows.value[active]), (_convex(whole), gradient)),
            curvature=curvature,
        )

    def with_seen(self, program: TrueProgram, here: _Point, there: _Point) -> "_Model":
        """The same with rows of the planes between bodies that a step from `here` met `there`."""
        table = program.seen(here, there)
        if table is None:
            return self
        return replace(self, clearance=self.clearance.with_rows(table.linear(here.z, here.z)))

    def promise(self, step: _Step, restored: float, penalty: float) -> float:
        """By how much the model lowers the merit with a step that lowers the violation by `restored`."""
        return float(-(self.gradient @ step.p + 0.5 * step.p @ self.hessian @ step.p) + penalty * restored)


@interruptible()
def descend(program: TrueProgram, z: Array, *, promise: float | None = None) -> Descent:
    """Minimise g from z (f, n) to a local optimum of the true problem.

    Args:
        program: what is minimised.
        z: unknowns (f, n) to begin with.
        promise: by which share of g the model has to promise to lower the merit; default PROMISE or FREE_PROMISE.
    """
    is_free = program.surroundings is None
    steps, least_promise = (FREE_STEPS, FREE_PROMISE) if is_free else (STEPS, PROMISE)
    least_promise = promise if promise is not None else least_promise
    radius, penalty = RADIUS, PENALTY
    here = _Point.of(program, z, radius)
    model: _Model | None = None
    curvature = np.zeros((z.size, z.size))
    form, wide_tries = 0, 0

    def ended(steps: int, reason: str) -> Descent:
        log.debug("descent: %s after %d steps", reason, steps)
        return Descent(z=here.z, violation=here.violation, steps=steps, reason=reason)

    for count in range(steps):
        if model is None:
            model, form = _Model.of(program, here, radius, penalty, curvature), 0
            if model is None:
                return ended(count, "the quadratic program failed")
            curvature = model.curvature
        rows = program.limits.near(here.z, radius).with_rows(model.clearance)
        step = _solve(*model.forms[form], rows, radius, penalty)
        if step is None:
            return ended(count, "the quadratic program failed")
        if step.slack == 0.0:
            penalty = max(penalty, min(2 * float(step.multipliers.sum()), LARGEST_PENALTY))
        restored = here.violation - step.slack
        if restored > EXACT:  # the merit must fall where a step mends a violation at the cost of g
            penalty = max(penalty, min(-model.promise(step, restored, 0.0) / (MENDED * restored), LARGEST_PENALTY))
        promised = model.promise(step, restored, penalty)
        if promised < least_promise:
            if form + 1 < len(model.forms):
                form += 1
            elif wide_tries == 0:
                radius, form, wide_tries = RADIUS, 0, WIDE_TRIES
            else:
                return ended(count, "no step lowers g")
            continue
        new, gain = _tried(program, model, form, here, step, promised, radius, penalty)
        size = float(np.abs(step.p).max())
        if gain <= TAKEN * promised:
            model = model.with_seen(program, here, new)
        else:
            here, model, wide_tries = new, None, 0
            penalty = max(penalty / 2, LEAST_PENALTY)
            if gain > 0.5 * promised and size > 0.7 * radius:
                radius = min(2 * radius, LARGEST_RADIUS)
        if gain < 0.25 * promised:
            radius = size / 4
            if wide_tries > 0:
                wide_tries -= 1
                if wide_tries == 0:
                    return ended(count + 1, "no step lowers g")
            if radius < SMALLEST_RADIUS:
                return ended(count + 1, "steps became too short")
    return ended(steps, "the maximum number of steps was reached")


def _tried(
    program: TrueProgram, model: _Model, form: int, here: _Point, step: _Step, promise: float, radius: float, penalty: float
) -> tuple[_Point, float]:
    """Where a step leads, or its second-order correction when that is better, and by how much the merit falls."""
    before = here.merit(penalty)
    new = _Point.of(program, here.z + step.p.reshape(here.z.shape), radius)
    gain = before - new.merit(penalty)
    if gain > CORRECTED * promise or new.violation < EXACT or not np.isfinite(new.value):
        return new, gain
    moved = program.table(new.z, new.look).linear(new.z, here.z)
    rows = program.limits.near(here.z, radius).with_rows(moved)
    corrected = _solve(*model.forms[form], rows, radius, penalty)
    if corrected is not None:
        other = _Point.of(program, here.z + corrected.p.reshape(here.z.shape), radius)
        if before - other.merit(penalty) > gain:
            return other, before - other.merit(penalty)
    return new, gain


def _convex(hessian: Array) -> Array:
    """The matrix with its small and negative eigenvalues raised to a small positive one."""
    values, vectors = np.linalg.eigh((hessian + hessian.T) / 2)
    values = np.maximum(values, LEAST_CURVATURE * np.abs(values).max())
    return np.asarray((vectors * values) @ vectors.T)


def _solve(hessian: Array, gradient: Array, rows: LinearRows, radius: float, penalty: float) -> _Step | None:
    """Minimise ½ pᵀ H p + gᵀ p with value + jacobian p >= 0 and |p| <= radius; None where DAQP fails.

    Where that cannot be, with value + jacobian p + t >= 0 and ν t beside it, t >= 0.
    """
    size = len(gradient)
    bound = np.full(size, radius)
    step = _daqp(hessian, gradient, rows.jacobian, -rows.value, -bound, bound)
    if step is not None and step.multipliers.sum() < LARGEST_PENALTY:
        return step
    # DAQP wants some curvature in every unknown where rows contradict each other
    largest = float(np.abs(np.diag(hessian)).max())
    penalty = max(penalty, SOFT_PENALTY)
    whole = np.diag(np.append(np.full(size, SOFT * largest), SOFT * penalty))
    whole[:size, :size] += hessian
    jacobian = np.hstack([rows.jacobian, np.ones((len(rows.value), 1))])
    soft = _daqp(whole, np.append(gradient, penalty), jacobian, -rows.value, np.append(-bound, 0.0), np.append(bound, NONE))
    return None if soft is None else _Step(p=soft.p[:size], slack=float(soft.p[size]), multipliers=soft.multipliers)


def _daqp(hessian: Array, gradient: Array, jacobian: Array, least: Array, low: Array, high: Array) -> _Step | None:
    """Minimise ½ xᵀ H x + gᵀ x with jacobian x >= least and low <= x <= high; None where DAQP finds no solution."""
    lower, upper = np.concatenate([low, least]), np.concatenate([high, np.full(len(least), NONE)])
    sense = np.zeros(len(lower), dtype=np.int32)
    for tolerance in TOLERANCES:
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
            return _Step(p=np.asarray(x), slack=0.0, multipliers=multipliers)
    return None
