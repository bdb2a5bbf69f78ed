"""The energy of a path minimised by IPOPT, to compare with the descent of `manipplan.optimize`.

Everything that changes from one solve to the next (ends, guess, rows) is a parameter, so IPOPT is set up once per objective and
basis. Unknowns z: coefficients along the free directions, joint after joint for each direction, then one slack [m] per
clearance row. Parameters p: start, goal, 1 / size and floor of the objective, the coefficients that are kept, and the table of
rows. First and second derivatives are exact.
"""

from dataclasses import dataclass

import casadi as ca
import numpy as np

from manipplan.cost.density import energy_density, hessian_of
from manipplan.optimize.clearance import ClearanceRows, row_functions
from manipplan.optimize.program import SPACING, LimitHull, PathProgram
from manipplan.paths.basis import Basis
from manipplan.paths.rounding import FINE, on_grid, with_bits
from manipplan.support.checks import Array

#: Bits of the factor by which the objective is scaled.
SCALE_BITS = 24
#: Cost of a slack of one metre, in units of the first energy: large enough that a path meets the rows if it can.
SLACK_COST = 1e3
#: Tolerance, and maximum number of iterations without and with clearance rows, which are renewed after each solve.
TOLERANCE, STEPS, STEPS_WITH_ROWS = 1e-7, 100, 60


@dataclass(frozen=True, kw_only=True, eq=False)
class Integral:
    """A density, and its quadrature points and weights over s, (m,) each."""

    density: tuple[ca.Function, ...]
    s: Array
    weights: Array

    @classmethod
    def of(cls, program: PathProgram) -> "Integral":
        """The energy of a program."""
        s, weights = program._energy_rule
        return cls(density=energy_density(program.integral).functions, s=s, weights=weights)


@dataclass(frozen=True, kw_only=True, eq=False)
class _SymbolicCurve:
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
    hull: LimitHull,
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
    size, height = n * free.shape[1], basis.size + 1 + (rows[0].size1_in(1) if capacity else 0)
    z = ca.MX.sym("z", size + capacity)
    fixed = 2 * n + 2 + n * basis.size
    p = ca.MX.sym("p", fixed + height * capacity)
    kept = ca.reshape(p[2 * n + 2 : fixed], n, basis.size)
    x = kept + ca.reshape(z[:size], n, free.shape[1]) @ ca.sparsify(ca.DM(free)).T
    curve = _SymbolicCurve(start=p[:n], goal=p[n : 2 * n], x=x, free=free)
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
            "max_iter": STEPS_WITH_ROWS if capacity else STEPS,
            "tol": TOLERANCE,
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


def _objective(
    integral: Integral, basis: Basis, curve: _SymbolicCurve, scale: ca.MX, numbers: ca.MX
) -> tuple[ca.MX, ca.MX, ca.MX]:
    """scale · Σ_i w_i e(q_i, v_i) over the nodes, with gradient (n f) and Hessian (n f, n f)."""
    n, nodes = curve.n, len(integral.s)
    values, slopes = basis.values(integral.s), basis.values(integral.s, 1)
    q = curve.at(ca.DM(integral.s).T, ca.DM(values).T)
    v = (curve.goal - curve.start) @ ca.DM.ones(1, nodes) + curve.x @ ca.DM(slopes).T
    density, slope, derivatives = integral.density
    functions = (density, slope, hessian_of(derivatives))
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


def _limits(hull: LimitHull, curve: _SymbolicCurve) -> tuple[ca.MX, ca.DM]:
    """The hull's points (n r), which are linear in the unknowns, and their Jacobian."""
    points = curve.at(ca.DM(hull.line).T, ca.DM(hull.rows).T)
    return ca.vec(points), ca.kron(ca.sparsify(ca.DM(hull.rows @ curve.free)), ca.DM.eye(curve.n))


def _clearance(
    functions: tuple[ca.Function, ...], curve: _SymbolicCurve, table: ca.MX, multipliers: ca.MX
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


def along(program: PathProgram) -> Array:
    """Directions (size, f) by which coefficients give the unknowns."""
    return np.linalg.pinv(program.free).T


def met_column(n: int) -> Array:
    """The column of a row that is always met: zero normal and offset -1 m, so 0 >= -1."""
    return ClearanceRows.of(n, np.zeros(1), 0, np.zeros(3), 0, np.zeros(3), -1.0, 0.0).columns[0]


def capacity_for(rows: ClearanceRows | None) -> int:
    """Number of columns in a table with room for the rows."""
    return 0 if rows is None else 32 * 2 ** int(np.ceil(np.log2(max(len(rows.s) / 32, 1))))


def row_table(program: PathProgram, rows: ClearanceRows | None, capacity: int) -> Array:
    """The table of rows: values of the functions at the row's place, the place, and the row's column.

    Unused columns hold a row that is always met.
    """
    basis = program.basis
    if rows is None:
        return np.zeros((basis.size + 1, 0))
    count, height = rows.columns.shape
    table = np.zeros((basis.size + 1 + height, capacity))
    table[basis.size + 1 :] = met_column((height - 8) // 2 - 1)[:, None]
    table[:, :count] = np.hstack([basis.values(rows.s), rows.s[:, None], rows.columns]).T
    return table


def solver_of(
    program: PathProgram, capacity: int, integral: Integral | None = None, rows: tuple[ca.Function, ...] = ()
) -> ca.Function:
    """IPOPT for the energy of a program, with room for `capacity` clearance rows."""
    return ipopt_solver(
        integral or Integral.of(program),
        basis=program.basis,
        free=program.free,
        hull=moving_hull(program),
        rows=(rows or row_functions(program.kinematics).functions) if capacity else (),
        capacity=capacity,
        n=program.n,
        power=program.integral.power,
    )


def moving_hull(program: PathProgram) -> LimitHull:
    """The points that have to keep the joint limits; none where there are no limits."""
    limits = program.kinematics.robot.limits
    is_limited = bool(np.isfinite([limits.lower, limits.upper]).any())
    return program._hull if is_limited else LimitHull(line=program._hull.line[:0], rows=program._hull.rows[:0])


def solver_arguments(
    program: PathProgram, start: Array, goal: Array, guess: Array, floor: float, rows: ClearanceRows | None
) -> dict[str, Array]:
    """The arguments of the solver, from a guess (n, size)."""
    capacity, limits = capacity_for(rows), program.kinematics.robot.limits
    unknowns = on_grid(guess @ along(program), SPACING)
    kept = program._rounded(guess - unknowns @ program.free.T)
    # all inputs of IPOPT are rounded: its iterations diverge for inputs that differ in their last bits
    scale = with_bits(np.array([1 / program._energy(start, goal, guess, floor)]), SCALE_BITS)
    table = on_grid(row_table(program, rows, capacity), FINE)
    joint_limits = [np.tile(bound, len(moving_hull(program).line)) for bound in (limits.lower, limits.upper)]
    return {
        "x0": np.concatenate([unknowns.ravel(order="F"), np.zeros(capacity)]),
        "p": np.concatenate([start, goal, scale, [floor], kept.ravel(order="F"), table.ravel(order="F")]),
        "lbx": np.concatenate([np.full(unknowns.size, -np.inf), np.zeros(capacity)]),
        "ubx": np.full(unknowns.size + capacity, np.inf),
        "lbg": np.concatenate([joint_limits[0], np.zeros(capacity)]),
        "ubg": np.concatenate([joint_limits[1], np.full(capacity, np.inf)]),
    }


def solve_by_ipopt(
    program: PathProgram, start: Array, goal: Array, guess: Array, floor: float, rows: ClearanceRows | None
) -> tuple[Array, str]:
    """The coefficients (n, size) of least energy, and IPOPT's return status."""
    solver, arguments = solver_of(program, capacity_for(rows)), solver_arguments(program, start, goal, guess, floor, rows)
    result = solver(**arguments)
    unknowns = on_grid(guess @ along(program), SPACING)
    x = np.asarray(result["x"]).ravel()[: unknowns.size].reshape(unknowns.shape, order="F")
    kept = program._rounded(guess - unknowns @ program.free.T)
    return kept + x @ program.free.T, str(solver.stats()["return_status"])
