"""The nonlinear program for a motion inside the tube around a recording, as a cubic B-spline over the share u of its duration.

Minimises

    energy · ∫ ‖q'‖_W² / (m² + ε²)^p du  +  room · ∫ 1 / (m² + ε²)^p du  +  jerk · ∫ ‖d³q/du³‖² du  +  time · τ

over the control points c (size, n) and τ, the duration as a multiple of a given one. The first integral is the energy of g (see
`manipplan.cost.objective`), the second raises m at all times, also where the arm hardly moves. They and the tube are taken at
both ends and in the middle of each piece. Control points of the first, second and third derivative bound velocity, acceleration
and jerk at all times. First and second derivatives are exact. Each control point has its own τ, equal to the next one, which
keeps all matrices banded.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, partial

import casadi as ca
import numpy as np

from manipplan.cost.integral import PathIntegral
from manipplan.cost.objective import energy_density, hessian_of
from manipplan.optimize.clearance import ClearanceRows, row_functions
from manipplan.recordings.recording import Ends, SplineBasis
from manipplan.robots.limits import JointLimits
from manipplan.search.program import pose_error
from manipplan.support.checks import Array
from manipplan.support.deadline import NEVER, Deadline
from manipplan.support.expressions import making_expressions

#: Tolerance and maximum number of iterations of IPOPT, and margin by which the tube is kept, as a share.
CONVERGED, STEPS, SPARE = 1e-5, 150, 1e-3
#: Smallest time that IPOPT accepts [s].
LEAST_TIME = 1e-3
#: Largest change of the duration when it is free, as a multiple.
LONGEST = 1e4


@dataclass(frozen=True, kw_only=True, eq=False)
class Weights:
    """Weights of the integrals, each over that of the first curve, and of τ."""

    energy: float = 0.0
    room: float = 0.0
    jerk: float = 0.0
    time: float = 0.0


class TubeProgram:
    """The program for one recording; `duration` [s] is at τ = 1. Solved with different weights, tubes and clearance rows."""

    def __init__(self, integral: PathIntegral, basis: SplineBasis, ends: Ends, duration: float, limits: JointLimits) -> None:
        self.integral, self.basis, self.ends, self.duration, self.limits = integral, basis, ends, duration, limits
        self.u = np.linspace(0.0, 1.0, 2 * basis.pieces + 1)
        simpson = np.where(np.arange(len(self.u)) % 2, 4.0, 2.0)
        simpson[[0, -1]] = 1.0
        self.weights = simpson / simpson.sum()
        self.values, self.slopes = basis.values(self.u), basis.values(self.u, 1)

    def solve(
        self,
        control: Array,
        weights: Weights,
        *,
        poses: Array,
        tube: Array,
        least: float = 0.0,
        rows: ClearanceRows | None = None,
        deadline: Deadline = NEVER,
    ) -> tuple[Array, float]:
        """Control points (size, n) and τ of the solution from `control`; what they keep has to be checked.

        At the deadline it is the last iterate; OutOfTimeError is raised where it passes before the first one.

        Args:
            control: (size, n) first curve.
            weights: of the objective; without one of the duration τ is 1.
            poses, tube: (k, 4, 4) centres and (k, 2) radii [m, rad] of the tube at `u`; inf: not bounded.
            least, rows: minimum manipulability and clearance rows to keep.
            deadline: no iteration is begun after it.
        """
        n = self.limits.n
        z = ca.MX.sym("z", control.size + self.basis.size)
        c, tau = ca.reshape(z[: control.size], n, self.basis.size), z[control.size :]
        lam_f = ca.MX.sym("lam_f")
        makers: list[Callable[[], _Rows]] = []
        if self._bounds:
            makers.append(lambda: self._limits(c, tau))
        if weights.time > 0:
            makers.append(lambda: self._equal(tau))
        makers.append(lambda: self._tube(c, poses, tube))
        if least > 0:
            makers.append(lambda: self._least(c, least))
        if rows is not None:
            makers.append(partial(self._clearance, c, rows))
        parts = []
        for make in makers:
            deadline.check()
            parts.append(make())
        f, grad_f, hess_f = self._objective(c, tau, control, weights, deadline)
        g = ca.vertcat(*(part.value for part in parts))
        jac_g = ca.vertcat(*(part.jacobian for part in parts))
        lam_g = ca.MX.sym("lam_g", g.numel())
        hessian, begin = lam_f * hess_f, 0
        for part in parts:
            hessian += part.hessian(lam_g[begin : begin + part.value.numel()])
            begin += part.value.numel()
        p = ca.MX.sym("p", 0)
        deadline.check()
        options = {
            "grad_f": ca.Function("grad_f", [z, p], [f, grad_f]),
            "jac_g": ca.Function("jac_g", [z, p], [g, jac_g]),
            "hess_lag": ca.Function("hess_lag", [z, p, lam_f, lam_g], [ca.triu(hessian)]),
            "print_time": False,
            "error_on_fail": False,
            "calc_lam_p": False,
            "no_nlp_grad": True,
            "show_eval_warnings": False,
            "ipopt": {
                "print_level": 0,
                "sb": "yes",
                "max_iter": STEPS,
                "tol": CONVERGED,
                "mu_strategy": "adaptive",
                "adaptive_mu_globalization": "kkt-error",  # the default takes up to a hundred times as long here
                "constr_viol_tol": 1e-9,
                "bound_relax_factor": 0.0,
                "acceptable_iter": 0,
                **({"max_wall_time": max(deadline.left, LEAST_TIME)} if np.isfinite(deadline.at) else {}),
                "max_hessian_perturbation": 1e6,  # beyond it the factors of the matrix fill up: a step takes seconds
            },
        }
        solver = ca.nlpsol("tube", "ipopt", {"x": z, "p": p, "f": f, "g": g}, options)
        free = weights.time > 0
        fixed = self.ends.control(self.basis)
        lower = np.where(np.isnan(fixed), self.limits.lower, fixed).ravel()
        upper = np.where(np.isnan(fixed), self.limits.upper, fixed).ravel()
        deadline.check()
        result = solver(
            x0=np.append(control.ravel(), np.full(self.basis.size, self.used(control) if free else 1.0)),
            lbx=np.append(lower, np.full(self.basis.size, 0.0 if free else 1.0)),
            ubx=np.append(upper, np.full(self.basis.size, LONGEST if free else 1.0)),
            lbg=np.concatenate([part.lower for part in parts]),
            ubg=np.concatenate([part.upper for part in parts]),
        )
        x = np.asarray(result["x"]).ravel()
        return x[: control.size].reshape(control.shape), float(x[control.size :].max())

    def used(self, control: Array) -> float:
        """The smallest τ with which a curve keeps the limits of velocity, acceleration and jerk."""
        used = (float(np.abs(rows @ control / most).max() ** (1 / order)) for order, rows, most in self._bounds)
        return max(used, default=0.0)

    @cached_property
    def _bounds(self) -> list[tuple[int, Array, Array]]:
        """Order, matrix and limits of the derivatives' control points, per share of the duration."""
        kinds = ((1, self.limits.velocity), (2, self.limits.acceleration), (3, self.limits.jerk))
        return [
            (order, self.basis.slopes(order), most * self.duration**order) for order, most in kinds if np.isfinite(most).any()
        ]

    def _objective(
        self, c: ca.MX, tau: ca.MX, control: Array, weights: Weights, deadline: Deadline
    ) -> tuple[ca.MX, ca.MX, ca.MX]:
        """Value, gradient and Hessian in (c, τ)."""
        n = self.limits.n
        third = self.basis.slopes(3)
        square = third.T @ third
        scale = weights.jerk / max(float(np.trace(control.T @ square @ control)), 1e-12)
        bending = ca.kron(ca.sparsify(ca.DM(2 * scale * square)), ca.DM.eye(n))
        x = ca.vec(c)
        slope, hessian = bending @ x, ca.MX(bending)
        value = ca.dot(x, slope) / 2 + weights.time * ca.sum1(tau) / tau.numel()
        one_way = np.zeros((n, len(self.u)))
        one_way[0] = 1.0
        for weight, fixed in ((weights.energy, None), (weights.room, one_way)):
            if weight > 0:
                deadline.check()
                one, gradient, curved = self._energy(c, control, fixed)
                value += weight * one
                slope += weight * gradient
                hessian += weight * curved
        time = ca.MX(weights.time / tau.numel() * ca.DM.ones(tau.numel()))
        return value, ca.vertcat(slope, time), ca.diagcat(hessian, ca.MX(tau.numel(), tau.numel()))

    def _energy(self, c: ca.MX, control: Array, fixed: Array | None) -> tuple[ca.MX, ca.MX, ca.MX]:
        """The energy of g over that of the curve `control`, with gradient and Hessian in c; q' is `fixed` (n, k) if given."""
        n, count = self.limits.n, len(self.u)
        density, slope, derivatives = energy_density(self.integral, at_once=True).functions
        numbers = ca.repmat(ca.DM([1.0, self.integral.power, self.integral.floor]), 1, count)
        slopes = self.slopes if fixed is None else np.zeros_like(self.slopes)
        about = ca.DM(np.zeros((n, count)) if fixed is None else fixed)
        at = ca.DM((self.values @ control).T), ca.DM((slopes @ control).T) + about
        first = float(ca.dot(density.map(count)(*at, numbers), ca.DM(self.weights).T))
        weights = ca.DM(self.weights).T / first
        q, v = c @ ca.DM(self.values.T), c @ ca.sparsify(ca.DM(slopes.T)) + about
        value, gradient, hessian = (
            function.map(count)(q, v, numbers) for function in (density, slope, hessian_of(derivatives))
        )
        blocks = ca.diagcat(*(w * h for w, h in zip(ca.horzsplit(weights), ca.horzsplit(hessian, 2 * n), strict=True)))
        weighed = gradient * ca.repmat(weights, 2 * n, 1)
        stacked = ca.sparsify(
            ca.vertcat(
                *(
                    ca.vertcat(*(ca.kron(ca.DM(rows[k][None, :]), ca.DM.eye(n)) for rows in (self.values, slopes)))
                    for k in range(count)
                )
            )
        )
        return ca.dot(value, weights), stacked.T @ ca.vec(weighed), stacked.T @ blocks @ stacked

    def _limits(self, c: ca.MX, tau: ca.MX) -> "_Rows":
        """τ^k ± the control points of the k-th derivative over their limits, which are not negative."""
        size, unknowns = self.basis.size, self.limits.n * self.basis.size
        values, jacobians, curved, of = [], [], [], []
        for order, rows, most in self._bounds:
            limited = np.isfinite(most)
            inverse = ca.sparsify(ca.DM(np.diag(np.where(limited, 1 / most, 0.0))[limited]))
            part = ca.kron(ca.sparsify(ca.DM(rows)), inverse)
            index = np.repeat(np.arange(size - order), limited.sum())
            own = ca.sparsify(ca.DM(np.eye(size)[index]))
            each = own @ tau
            for sign in (1.0, -1.0):
                values.append(each**order + sign * (part @ ca.vec(c)))
                jacobians.append(ca.horzcat(ca.MX(sign * part), ca.diag(order * each ** (order - 1)) @ own))
                curved.append(order * (order - 1) * each ** max(order - 2, 0))
                of.append(own)
        value, bend, own = ca.vertcat(*values), ca.vertcat(*curved), ca.vertcat(*of)
        return _Rows(
            value=value,
            jacobian=ca.vertcat(*jacobians),
            lower=np.zeros(value.numel()),
            hessian=lambda lam: ca.diagcat(ca.MX(unknowns, unknowns), ca.diag(own.T @ (lam * bend))),
        )

    def _equal(self, tau: ca.MX) -> "_Rows":
        """Differences of τ, which are zero."""
        size, unknowns = self.basis.size, self.limits.n * self.basis.size
        differences = ca.sparsify(ca.DM(np.diff(np.eye(size), axis=0)))
        empty = ca.MX(unknowns + size, unknowns + size)
        return _Rows(
            value=differences @ tau,
            jacobian=ca.MX(ca.horzcat(ca.DM(size - 1, unknowns), differences)),
            lower=np.zeros(size - 1),
            most=0.0,
            hessian=lambda _: empty,
        )

    @making_expressions()
    def _tube(self, c: ca.MX, poses: Array, tube: Array) -> "_Rows":
        """One minus the squares of distance and sine of the angle over those of the radii, which are not negative."""
        kinematics = self.integral.kinematics
        error = pose_error(kinematics)
        q, pose, radii = (ca.SX.sym(name, size) for name, size in (("q", self.limits.n), ("pose", 16), ("radii", 2)))
        rows = error(q, pose)
        moves = len(kinematics.free_motion.fixed_directions) - kinematics.robot.planar
        squares = [ca.sumsqr(rows[:moves]) * radii[0] ** 2]
        turns = rows.size1() > moves and np.isfinite(tube[:, 1]).any()
        if turns:
            squares.append(ca.sumsqr(rows[moves:]) * radii[1] ** 2)
        sines = np.where(np.isfinite(tube[:, 1]), np.sin(np.minimum(tube[:, 1], np.pi / 2)), np.inf)
        parameters = ca.DM(np.vstack([poses.transpose(0, 2, 1).reshape(len(poses), 16).T, 1 / tube[:, 0], 1 / sines]))
        return self._at_places(1 - ca.vertcat(*squares), q, ca.vertcat(pose, radii), c, parameters)

    def _least(self, c: ca.MX, least: float) -> "_Rows":
        """m over the least value, which is at least one."""
        symbolic = self.integral.kinematics.symbolic
        count, values = len(self.u), self.values
        q = c @ ca.DM(values.T)
        value = symbolic.manipulability.map(count)(q).T / least
        return _Rows(
            value=value,
            jacobian=self._chain(symbolic.gradient.map(count)(q) / least, values),
            lower=np.ones(count),
            hessian=lambda lam: self._chain_twice(symbolic.hessian.map(count)(q) / least, lam, values),
        )

    def _clearance(self, c: ca.MX, rows: ClearanceRows) -> "_Rows":
        """Distances of clearance rows [m]."""
        distance, gradient, hessian = row_functions(self.integral.kinematics, at_once=True).functions
        columns, values, count = ca.DM(rows.columns.T), self.basis.values(rows.s), len(rows.s)
        q = c @ ca.DM(values.T)
        return _Rows(
            value=distance.map(count)(q, columns).T,
            jacobian=self._chain(gradient.map(count)(q, columns), values),
            lower=np.zeros(count),
            hessian=lambda lam: self._chain_twice(hessian.map(count)(q, columns), lam, values),
        )

    def _at_places(self, value: ca.SX, q: ca.SX, p: ca.SX, c: ca.MX, parameters: ca.DM) -> "_Rows":
        """Rows of a function of (q, p) at all places u, with derivatives by CasADi."""
        count, values = len(self.u), self.values
        height = value.size1()
        lam = ca.SX.sym("lam", height)
        jacobian = ca.jacobian(value, q).T  # (n, height)
        bend, _ = ca.hessian(ca.dot(lam, value), q)
        at = c @ ca.DM(values.T)
        found = ca.Function("value", [q, p], [value]).map(count)(at, parameters)
        slope = ca.Function("slope", [q, p], [ca.densify(jacobian)]).map(count)(at, parameters)
        curved = ca.Function("bend", [q, p, lam], [ca.densify(bend)]).map(count)

        def hessian(multipliers: ca.MX) -> ca.MX:
            each = curved(at, parameters, ca.reshape(multipliers, height, count))
            return self._chain_twice(each, ca.MX.ones(count), values)

        repeated = np.repeat(values, height, axis=0)
        return _Rows(
            value=ca.vec(found), jacobian=self._chain(slope, repeated), lower=np.full(height * count, SPARE), hessian=hessian
        )

    def _chain(self, gradients: ca.MX, values: Array) -> ca.MX:
        """Jacobian of k rows in (c, τ), from their gradients (n, k) in q and the basis (k, size) there."""
        n = self.limits.n
        chain = ca.kron(ca.sparsify(ca.DM(values)), ca.DM.eye(n))  # (k n, size n)
        rows = ca.diagcat(*(column.T for column in ca.horzsplit(gradients)))
        return ca.horzcat(rows @ chain, ca.MX(len(values), self.basis.size))

    def _chain_twice(self, hessians: ca.MX, lam: ca.MX, values: Array) -> ca.MX:
        """The sum over k rows of lam (k,) times their Hessian, in (c, τ), from those in q (n, n k)."""
        n = self.limits.n
        chain = ca.kron(ca.sparsify(ca.DM(values)), ca.DM.eye(n))
        blocks = ca.diagcat(*(each * h for each, h in zip(ca.vertsplit(lam), ca.horzsplit(hessians, n), strict=True)))
        return ca.diagcat(chain.T @ blocks @ chain, ca.MX(self.basis.size, self.basis.size))


@dataclass(frozen=True, kw_only=True, eq=False)
class _Rows:
    """Constraint rows (k,) from `lower` to `most`, their Jacobian in (c, τ), and their Hessian for given multipliers (k,)."""

    value: ca.MX
    jacobian: ca.MX
    lower: Array
    hessian: Callable[[ca.MX], ca.MX]
    most: float = np.inf

    @property
    def upper(self) -> Array:
        return np.full(len(self.lower), self.most)
