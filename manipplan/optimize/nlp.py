"""The path program as IPOPT takes it: objective, joint limits and clearance rows, with exact first and second derivatives.

Unknowns z: coefficients along the free directions, joint after joint for each direction, then one slack [m] a clearance row.
Parameters p: start, goal, 1 / size and g₀ of the objective, the coefficients that are kept, and the table of rows.
"""

from dataclasses import dataclass

import casadi as ca

from manipplan.checks import Array
from manipplan.optimize.basis import Basis
from manipplan.optimize.density import Density
from manipplan.optimize.rows import column_height

#: Cost of a slack of one metre, in units of the first energy: a path that can be clear is.
SLACK_COST = 1e3


#: With clearance rows, which are made anew after each solve, it may take no more than this.
STEPS_WITH_ROWS = 60


@dataclass(frozen=True, kw_only=True, eq=False)
class Integral:
    """A density, the rule (m,), (m,) by which it is integrated over s, IPOPT's tolerance, and how many steps it may take."""

    density: Density
    s: Array
    weights: Array
    tolerance: float
    steps: int


@dataclass(frozen=True, kw_only=True, eq=False)
class Hull:
    """Points line (goal - start) + rows x above start whose joint limits are those of the curve: (r,) and (r, size)."""

    line: Array
    rows: Array

    def none(self) -> "Hull":
        """No points: no limits."""
        return Hull(line=self.line[:0], rows=self.rows[:0])


@dataclass(frozen=True, kw_only=True, eq=False)
class _Curve:
    """The curve start + s (goal - start) + Σ_j x_j φ_j(s) in symbols; x (n, size) depends on the unknowns by `free`."""

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
    """IPOPT on the program of `n` joints.

    Args:
        integral: what is minimised.
        basis, free: the functions φ_j, and directions (size, f) of their coefficients.
        hull: whose points keep the joint limits.
        rows: `row_functions`; not used without capacity.
        capacity: columns of the table of clearance rows.
        n, power: joints, and exponent of the index.
    """
    size, height = n * free.shape[1], basis.size + 1 + column_height(n)
    z = ca.MX.sym("z", size + capacity)
    fixed = 2 * n + 2 + n * basis.size
    p = ca.MX.sym("p", fixed + height * capacity)
    kept = ca.reshape(p[2 * n + 2 : fixed], n, basis.size)
    x = kept + ca.reshape(z[:size], n, free.shape[1]) @ ca.sparsify(ca.DM(free)).T
    curve = _Curve(start=p[:n], goal=p[n : 2 * n], x=x, free=free)
    scale, g0 = p[2 * n], p[2 * n + 1]
    slack = z[size:]

    value, gradient, hessian = _objective(integral, basis, curve, scale, ca.vertcat(g0, power))
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
        "show_eval_warnings": False,  # a step to where g is no number is halved
        "ipopt": {
            "print_level": 0,
            "sb": "yes",
            "max_iter": min(integral.steps, STEPS_WITH_ROWS) if capacity else integral.steps,
            "tol": integral.tolerance,
            "mu_strategy": "adaptive",
            "constr_viol_tol": 1e-9,
            "bound_relax_factor": 0.0,
            "acceptable_iter": 0,
            # most of a small solve is the search for an order and a scaling that this matrix does not need
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
    # (q_i, v_i) is linear in the unknowns, by one block of rows a node
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
    """Distances of the rows (c), their Jacobian, and the sum of their Hessians by multipliers (c)."""
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
