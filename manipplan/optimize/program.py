"""The program of a path in one basis: solves of the energy by IPOPT, and the program of g for the descent.

Everything that changes from one solve of the energy to the next (ends, guess, rows) is a parameter, so IPOPT is set up once
per objective and basis. Unknowns z: coefficients along the free directions, joint after joint for each direction, then
one slack [m] per clearance row. Parameters p: start, goal, 1 / size and floor of the objective, the coefficients that are
kept, and the table of rows. First and second derivatives are exact.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import casadi as ca
import numpy as np

from manipplan.cost.density import Density, energy_density, length_density
from manipplan.cost.integral import PathIntegral, gauss
from manipplan.optimize.clearance import ClearanceRow, column_height, met_column, row_functions
from manipplan.optimize.constraints import LimitRows, RowFunctions
from manipplan.optimize.descent import DescentProgram
from manipplan.optimize.step_models import BatchDensity, Curves, LengthModel, MovingLengthModel, Surroundings
from manipplan.paths.basis import Basis, free_directions
from manipplan.paths.rounding import FINE, FIXED, on_grid, with_bits
from manipplan.support.checks import Array
from manipplan.support.interrupts import interruptible
from manipplan.symbolic.batch_function import BatchFunction

#: Cost of a slack of one metre, in units of the first energy: large enough that a path meets the rows if it can.
SLACK_COST = 1e3


#: Maximum number of IPOPT iterations with clearance rows, which are renewed after each solve.
STEPS_WITH_ROWS = 60


@dataclass(frozen=True, kw_only=True, eq=False)
class Integral:
    """A density, its quadrature points and weights over s, (m,) each, and IPOPT's tolerance and maximum number of steps."""

    density: Density
    s: Array
    weights: Array
    tolerance: float
    steps: int


@dataclass(frozen=True, kw_only=True, eq=False)
class Hull:
    """Points start + line (goal - start) + rows x, whose joint limits are those of the curve: (r,) and (r, size)."""

    line: Array
    rows: Array

    def none(self) -> "Hull":
        """A hull without points, for no limits."""
        return Hull(line=self.line[:0], rows=self.rows[:0])


@dataclass(frozen=True, kw_only=True, eq=False)
class _Curve:
    """The curve start + s (goal - start) + Σ_j x_j φ_j(s) in symbols; x (n, size) depends on the unknowns through `free`."""

    start: ca.MX
    goal: ca.MX
    x: ca.MX
    free: Array

    @property
    def n(self) -> int:
        return int(self.start.numel())

    def at(self, s: ca.MX | ca.DM, values: ca.MX | ca.DM) -> ca.MX:
        """q (n, m) at s (1, m), where the functions have the values (size, m)."""
        return self.start @ ca.DM.ones(1, s.numel()) + (self.goal - self.start) @ s + self.x @ values


def ipopt_solver(
    integral: Integral,
    *,
    basis: Basis,
    free: Array,
    hull: Hull,
    rows: tuple[ca.Function, ...],
    capacity: int,
    n: int,
    power: float,
) -> ca.Function:
    """IPOPT solver for the program of `n` joints.

    Args:
        integral: what is minimised.
        basis, free: the functions φ_j, and directions (size, f) of their coefficients.
        hull: points that have to keep the joint limits.
        rows: `row_functions`; not used when `capacity` is 0.
        capacity: number of columns in the table of clearance rows.
        n, power: number of joints, and exponent of the measure.
    """
    size, height = n * free.shape[1], basis.size + 1 + column_height(n)
    z = ca.MX.sym("z", size + capacity)
    fixed = 2 * n + 2 + n * basis.size
    p = ca.MX.sym("p", fixed + height * capacity)
    kept = ca.reshape(p[2 * n + 2 : fixed], n, basis.size)
    x = kept + ca.reshape(z[:size], n, free.shape[1]) @ ca.sparsify(ca.DM(free)).T
    curve = _Curve(start=p[:n], goal=p[n : 2 * n], x=x, free=free)
    scale, floor = p[2 * n], p[2 * n + 1]
    slack = z[size:]

    value, gradient, hessian = _objective(integral, basis, curve, scale, ca.vertcat(1.0, power, floor))
    f = value + SLACK_COST * ca.sum1(slack)
    grad_f = ca.vertcat(gradient, SLACK_COST * ca.MX.ones(capacity))
    g, jacobian = _limits(hull, curve)
    jac_g = ca.horzcat(ca.MX(jacobian), ca.MX(g.numel(), capacity))
    lam_f, lam = ca.MX.sym("lam_f"), ca.MX.sym("lam", g.numel() + capacity)
    hess_rows = ca.MX(size, size)
    if capacity:
        table = ca.reshape(p[fixed:], height, capacity)
        distance, jac_rows, hess_rows = _clearance(rows, curve, table, lam[g.numel() :])
        g = ca.vertcat(g, distance + slack)
        jac_g = ca.vertcat(jac_g, ca.horzcat(jac_rows, ca.DM.eye(capacity)))
    hess_lag = ca.diagcat(ca.densify(lam_f * hessian + hess_rows), ca.MX(capacity, capacity))
    options = {
        "grad_f": ca.Function("grad_f", [z, p], [f, grad_f]),
        "jac_g": ca.Function("jac_g", [z, p], [g, jac_g]),
        "hess_lag": ca.Function("hess_lag", [z, p, lam_f, lam], [ca.triu(hess_lag)]),
        "print_time": False,
        "error_on_fail": False,
        "calc_lam_p": False,
        "no_nlp_grad": True,
        "show_eval_warnings": False,  # IPOPT halves a step to a point where g is not a number
        "ipopt": {
            "print_level": 0,
            "sb": "yes",
            "max_iter": min(integral.steps, STEPS_WITH_ROWS) if capacity else integral.steps,
            "tol": integral.tolerance,
            "mu_strategy": "adaptive",
            "constr_viol_tol": 1e-9,
            "bound_relax_factor": 0.0,
            "acceptable_iter": 0,
            # most of the time of a small solve would go into an ordering and a scaling that this matrix does not need
            "mumps_permuting_scaling": 0,
            "mumps_scaling": 0,
        },
    }
    return ca.nlpsol("path", "ipopt", {"x": z, "p": p, "f": f, "g": g}, options)


def _objective(integral: Integral, basis: Basis, curve: _Curve, scale: ca.MX, numbers: ca.MX) -> tuple[ca.MX, ca.MX, ca.MX]:
    """scale · Σ_i w_i e(q_i, v_i) over the nodes, with gradient (n f) and Hessian (n f, n f)."""
    n, nodes = curve.n, len(integral.s)
    values, slopes = basis.values(integral.s), basis.values(integral.s, 1)
    q = curve.at(ca.DM(integral.s).T, ca.DM(values).T)
    v = (curve.goal - curve.start) @ ca.DM.ones(1, nodes) + curve.x @ ca.DM(slopes).T
    density = integral.density
    functions = (density.value, density.gradient, density.hessian)
    value, gradient, hessian = (f.map(nodes)(q, v, ca.repmat(numbers, 1, nodes)) for f in functions)
    weights = scale * ca.DM(integral.weights).T
    weighed = gradient * ca.repmat(weights, 2 * n, 1)
    grad_x = weighed[:n, :] @ ca.DM(values @ curve.free) + weighed[n:, :] @ ca.DM(slopes @ curve.free)
    # (q_i, v_i) is linear in the unknowns, with one block of rows per node
    maps = [
        ca.vertcat(*(ca.kron(ca.DM((row @ curve.free)[None, :]), ca.DM.eye(n)) for row in (values[i], slopes[i])))
        for i in range(nodes)
    ]
    stacked = ca.sparsify(ca.vertcat(*maps))
    blocks = ca.diagcat(*(w * h for w, h in zip(ca.horzsplit(weights), ca.horzsplit(hessian, 2 * n), strict=True)))
    return ca.dot(value, weights), ca.vec(grad_x), stacked.T @ blocks @ stacked


def _limits(hull: Hull, curve: _Curve) -> tuple[ca.MX, ca.DM]:
    """The hull's points (n r), which are linear in the unknowns, and their Jacobian."""
    points = curve.at(ca.DM(hull.line).T, ca.DM(hull.rows).T)
    return ca.vec(points), ca.kron(ca.sparsify(ca.DM(hull.rows @ curve.free)), ca.DM.eye(curve.n))


def _clearance(
    functions: tuple[ca.Function, ...], curve: _Curve, table: ca.MX, multipliers: ca.MX
) -> tuple[ca.MX, ca.MX, ca.MX]:
    """Distances of the rows (c), their Jacobian, and the sum of their Hessians times multipliers (c)."""
    size, capacity = curve.x.size2(), table.size2()
    values, columns = table[:size, :], table[size + 1 :, :]
    q = curve.at(table[size, :], values)
    distance, gradient, hessian = (f.map(capacity)(q, columns) for f in functions)
    free, eye = ca.sparsify(ca.DM(curve.free)), ca.DM.eye(curve.n)
    chain = [ca.kron(column.T @ free, eye) for column in ca.horzsplit(values)]
    jacobian = ca.vertcat(*(column.T @ link for column, link in zip(ca.horzsplit(gradient), chain, strict=True)))
    chained = ca.vertcat(*chain)
    weighed = zip(ca.vertsplit(multipliers), ca.horzsplit(hessian, curve.n), strict=True)
    return distance.T, jacobian, chained.T @ ca.diagcat(*(m * h for m, h in weighed)) @ chained


#: Number of Gauss points of the energy on the whole path, and minimum number on each piece.
NODES, PIECE_NODES = 40, 8
#: Minimum number of parts the curve is cut into, for the energy and for g. Their control points obey the joint limits, and so
#: does the whole curve. With more parts the curve can come nearer to the limits.
LIMIT_PARTS, FINE_PARTS = 6, 32
#: First unknowns of a solve or a descent are rounded to multiples of this [rad or m]. It is not a power of two, because then
#: results of rounded steps would often lie halfway between two multiples.
SPACING = 1.5e-8
#: Solutions of the energy are rounded to multiples of this [rad or m]: far above IPOPT's own accuracy, so that processors
#: hardly ever round to different multiples.
SOLVED_SPACING = 2.0**-16
#: Bits of the factor by which IPOPT's objective is scaled.
SCALE_BITS = 24


@dataclass(frozen=True, kw_only=True)
class Solution:
    """Result of one solve of the energy: coefficients (n, size) and IPOPT's return status."""

    coefficients: Array
    status: str

    @property
    def converged(self) -> bool:
        """Whether IPOPT converged."""
        return self.status in ("Solve_Succeeded", "Solved_To_Acceptable_Level")


class PathProgram:
    """The program for one objective, basis and pattern of fixed end derivatives; see the docstring of the module."""

    def __init__(self, integral: PathIntegral, basis: Basis, fixed: tuple[tuple[float, int], ...] = ()) -> None:
        self.integral = integral
        self.kinematics = kinematics = integral.kinematics
        self.basis = basis
        self.n = kinematics.robot.n
        #: coefficients (n, size) move along these directions (size, f), which keep the fixed end derivatives
        self.free = free_directions(fixed, basis)
        self._along = np.linalg.pinv(self.free).T
        self._hull, self._fine_hull = self._moving_hull(LIMIT_PARTS), self._moving_hull(FINE_PARTS)
        self._solvers: dict[tuple[int, bool], ca.Function] = {}

    def _moving_hull(self, parts: int) -> Hull:
        """The control points that can move when the curve is cut into this number of parts."""
        line, rows = self.basis.hull(parts)
        moving = np.abs(rows @ self.free).max(axis=1, initial=0.0) > 1e-9
        return Hull(line=line[moving], rows=rows[moving])

    @cached_property
    def _rows(self) -> tuple[ca.Function, ...]:
        return row_functions(self.kinematics)

    @cached_property
    def _energy(self) -> Integral:
        s, weights = self.basis.gauss(max(-(-NODES // (len(self.basis.breaks) - 1)), PIECE_NODES))
        return Integral(density=energy_density(self.integral), s=s, weights=weights, tolerance=1e-7, steps=100)

    @cached_property
    def _length_density(self) -> BatchDensity:
        return BatchDensity.of(length_density(self.integral))

    @cached_property
    def _batch_rows(self) -> RowFunctions:
        value, gradient, _ = self._rows
        return RowFunctions(value=BatchFunction(value), gradient=BatchFunction(gradient))

    @property
    def _fixes_derivatives(self) -> bool:
        """Whether end derivatives are fixed: they would not survive rounding."""
        return len(self.free.T) < self.basis.size

    def _rounded(self, kept: Array) -> Array:
        """Coefficients (n, size) that no unknown changes, rounded to the fine grid unless they fix derivatives."""
        return kept if self._fixes_derivatives else on_grid(kept, FINE)

    @cached_property
    def _directions(self) -> Array:
        """Combinations of the free directions (size, f) whose slopes are orthonormal."""
        s, weights = self.basis.gauss(self.basis.degree)
        slopes = np.sqrt(weights)[:, None] * (self.basis.values(s, 1) @ self.free)
        directions = np.asarray(self.free @ np.linalg.inv(np.linalg.qr(slopes).R))
        return directions if self._fixes_derivatives else on_grid(directions, FIXED)

    def descent_program(
        self,
        start: Array,
        goal: Array,
        coefficients: Array,
        surroundings: Surroundings | None,
        *,
        limited: bool = True,
        edges: Array | None = None,
        floor: float | None = None,
        moving: bool = False,
    ) -> tuple[DescentProgram, Array]:
        """The program of g among the true obstacles, and the unknowns z (f, n) that give the path of coefficients (n, size).

        Args:
            start, goal: (n,) [rad or m].
            coefficients: (n, size) of the path where the descent begins. g is integrated on quadrature panels that are narrow
                where this path needs it.
            surroundings: distances of the true bodies; None: nothing is checked for collision.
            limited: False: without joint limits.
            edges: panel edges (k + 1,) that earlier paths needed; they are kept and refined.
            floor: floor of g; None: that of the objective.
            moving: the panels follow each path; `edges` are ignored.
        """
        integral = self.integral if floor is None else replace(self.integral, floor=floor)
        directions = self._directions
        z: Array = np.asarray(np.linalg.lstsq(directions, coefficients.T, rcond=None)[0], dtype=float)
        kept = self._rounded(coefficients - (directions @ z).T)
        z = on_grid(z, SPACING)
        curves = Curves(basis=self.basis, directions=directions, kept=kept, start=start, goal=goal)
        path = self.basis.path(start, goal, coefficients)
        edges = integral.fine_panels(path) if moving else integral.panel_edges(path, edges)
        s, weights = gauss(edges[:-1], edges[1:])
        g0 = integral.on_panels(path, edges)
        length = LengthModel(
            density=self._length_density,
            curves=curves,
            edges=edges,
            s=s.ravel(),
            weights=weights.ravel(),
            g0=g0,
            power=integral.power,
            floor=integral.floor,
            pace=g0,
        )
        if moving:
            length = MovingLengthModel(**vars(length), integral=integral)
        limits = self.kinematics.robot.limits
        unlimited = np.full(self.n, np.inf)
        line = start + np.outer(self._fine_hull.line, goal - start) + self._fine_hull.rows @ kept.T
        limit_rows = LimitRows(
            line=line,
            directions=self._fine_hull.rows @ directions,
            lower=limits.lower if limited else -unlimited,
            upper=limits.upper if limited else unlimited,
        )
        return DescentProgram(length=length, limits=limit_rows, functions=self._batch_rows, surroundings=surroundings), z

    @interruptible()
    def solve(self, start: Array, goal: Array, guess: Array, floor: float, rows: Sequence[ClearanceRow] = ()) -> Solution:
        """Minimise the energy with a floor from a guess (n, size), which has the fixed end derivatives.

        Rows have slacks, so there is a solution even when they contradict each other.
        """
        capacity = 0 if not rows else 32 * 2 ** int(np.ceil(np.log2(max(len(rows) / 32, 1))))
        limits = self.kinematics.robot.limits
        limited = bool(np.isfinite([limits.lower, limits.upper]).any())
        solver = self._solver(capacity, limited)
        # all inputs of IPOPT are rounded: its iterations diverge for inputs that differ in their last bits
        unknowns = on_grid(guess @ self._along, SPACING)
        kept = self._rounded(guess - unknowns @ self.free.T)
        scale = with_bits(np.array([1 / self._energy_of(start, goal, guess, floor)]), SCALE_BITS)
        table = on_grid(self._row_parameters(rows, capacity), FINE)
        parameters = np.concatenate([start, goal, scale, [floor], kept.ravel(order="F"), table.ravel(order="F")])
        count = len(self._hull.line) if limited else 0
        joint_limits = [np.tile(each, count) for each in (limits.lower, limits.upper)]
        result = solver(
            x0=np.concatenate([unknowns.ravel(order="F"), np.zeros(capacity)]),
            p=parameters,
            lbx=np.concatenate([np.full(unknowns.size, -np.inf), np.zeros(capacity)]),
            lbg=np.concatenate([joint_limits[0], np.zeros(capacity)]),
            ubg=np.concatenate([joint_limits[1], np.full(capacity, np.inf)]),
        )
        status = str(solver.stats()["return_status"])
        x = on_grid(np.asarray(result["x"]).ravel()[: unknowns.size], SOLVED_SPACING)
        return Solution(coefficients=kept + x.reshape(unknowns.shape, order="F") @ self.free.T, status=status)

    def _energy_of(self, start: Array, goal: Array, guess: Array, floor: float) -> float:
        """The energy of a guess (n, size), by the quadrature of the program; 1 when it is not finite and positive."""
        s = self._energy.s
        q = start[:, None] + np.outer(goal - start, s) + guess @ self.basis.values(s).T
        v = (goal - start)[:, None] + guess @ self.basis.values(s, 1).T
        density = np.asarray(self._energy.density.value(q, v, np.array([[1.0], [self.integral.power], [floor]]))).ravel()
        value = float(density @ self._energy.weights)
        return value if np.isfinite(value) and value > 0 else 1.0

    def _row_parameters(self, rows: Sequence[ClearanceRow], capacity: int) -> Array:
        """The table of rows: values of the functions at the row's place, the place, and the row's column.

        Unused columns hold a row that is always met.
        """
        table = np.zeros((self.basis.size + 1 + column_height(self.n), capacity))
        table[self.basis.size + 1 :] = met_column(self.n)[:, None]
        at = np.array([row.s for row in rows])
        for k, (row, values) in enumerate(zip(rows, self.basis.values(at), strict=True)):
            table[:, k] = [*values, row.s, *row.column(self.n)]
        return table

    def _solver(self, capacity: int, limited: bool) -> ca.Function:
        """IPOPT with room for `capacity` clearance rows, built on first use."""
        key = (capacity, limited)
        if key not in self._solvers:
            self._solvers[key] = ipopt_solver(
                self._energy,
                basis=self.basis,
                free=self.free,
                hull=self._hull if limited else self._hull.none(),
                rows=self._rows if capacity else (),
                capacity=capacity,
                n=self.n,
                power=self.integral.power,
            )
        return self._solvers[key]
