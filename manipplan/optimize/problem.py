"""The nonlinear program: coefficients in a basis that minimise the energy, or g, within joint limits and clearance rows.

Unknowns: coefficients x (n, size) of a path, and one slack e >= 0 [m] a clearance row. Everything that
changes between solves - ends, rows - is a parameter, so a program is built once for an objective and a basis.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import casadi as ca
import numpy as np

from manipplan.checks import Array
from manipplan.interrupts import interruptible
from manipplan.kinematics.compile import as_asked
from manipplan.kinematics.kinematics import Kinematics
from manipplan.optimize.basis import Basis
from manipplan.optimize.density import Density, energy_density, length_density
from manipplan.optimize.ends import free_directions
from manipplan.optimize.objective import PathObjective
from manipplan.paths.joint import JointPath
from manipplan.robots.description import axis_of, is_prismatic

#: Gauss points of the energy on the whole path, and at least on each piece.
NODES, PIECE_NODES = 40, 8
#: Panels of ten Gauss points each on which g is polished: the next where these do not see how narrow a dip of the index is.
POLISH_PANELS = (12, 48, 192)
#: A rule sees all of a path when it agrees with g to this share.
AGREEMENT = 1e-7
#: The curve is cut into at least so many parts, whose control points all obey the joint limits: so does the curve.
LIMIT_PARTS = 6
#: Cost of a slack of one metre, in units of the first energy: a path that can be clear is.
SLACK_COST = 1e3


@dataclass(frozen=True, kw_only=True)
class ClearanceRow:
    """A point of the robot that has to stay on its side of a plane, at one place of the path.

    The plane is fixed in the frame of joint `other` (0: the world); row: normal · (point - plane) >= distance.

    Attributes:
        s: place on the path.
        joint, point: index of the joint that carries the point, and the point (3,) in its frame [m].
        other, normal, offset: index of the joint that carries the plane, its unit normal (3,) and offset [m] there.
        distance: to keep from the plane [m].
    """

    s: float
    joint: int
    point: Array
    other: int
    normal: Array
    offset: float
    distance: float


@dataclass(frozen=True, kw_only=True)
class Solution:
    """What one solve gave: coefficients (n, size), the largest slack [m] and IPOPT's word."""

    coefficients: Array
    slack: float
    status: str


@dataclass(frozen=True, kw_only=True, eq=False)
class _Objective:
    """A density, the rule (m,), (m,) by which it is integrated over s, IPOPT's tolerance, and how many steps it may take."""

    density: Density
    s: Array
    weights: Array
    tolerance: float
    steps: int


class PathProgram:
    """The program for one objective, basis and pattern of fixed end derivatives; see the module's text."""

    def __init__(self, objective: PathObjective, basis: Basis, fixed: tuple[tuple[float, int], ...] = ()) -> None:
        self.objective = objective
        self.kinematics = kinematics = objective.kinematics
        self.basis = basis
        self.n = kinematics.robot.n
        self._solvers: dict[tuple[int, int, bool], ca.Function] = {}
        self._lengths: dict[int, _Objective] = {}
        line, rows = basis.hull(LIMIT_PARTS)
        #: coefficients (n, size) move along these directions (size, f), which keep the fixed end derivatives
        self.free = free_directions(fixed, basis)
        self._along = np.linalg.pinv(self.free).T
        moving = np.abs(rows @ self.free).max(axis=1, initial=0.0) > 1e-9
        self._limit_rows, self._limit_line = rows[moving], line[moving]

    @cached_property
    def _rows(self) -> tuple[ca.Function, ...]:
        return _row_functions(self.kinematics)

    @cached_property
    def _energy(self) -> "_Objective":
        s, weights = self.basis.gauss(max(-(-NODES // (len(self.basis.breaks) - 1)), PIECE_NODES))
        return _Objective(density=energy_density(self.objective), s=s, weights=weights, tolerance=1e-7, steps=100)

    @cached_property
    def _length_density(self) -> Density:
        return length_density(self.objective)

    def _length(self, panels: int) -> "_Objective":
        if panels not in self._lengths:
            line = JointPath(breaks=self.basis.breaks, control=self.basis.line[..., None])
            s, weights = line.quadrature(panels=panels)
            self._lengths[panels] = _Objective(density=self._length_density, s=s, weights=weights, tolerance=1e-9, steps=300)
        return self._lengths[panels]

    def solve(
        self,
        start: Array,
        goal: Array,
        guess: Array,
        rows: Sequence[ClearanceRow] = (),
        *,
        reach: float = np.inf,
        limited: bool = True,
    ) -> Solution:
        """Minimise the energy from a guess (n, size), which has the fixed end derivatives.

        Rows that cannot hold come back with their slack. No unknown moves further than `reach` from the guess: in a basis of
        several pieces, by which each moves a joint's slope, in the mean square over s [rad or m]. With `limited` False as if
        there were no joint limits.
        """
        size = self._integral(self._energy, start, goal, guess, 1.0)
        return self._solve(0, start, goal, guess, rows, size, 1.0, limited=limited, reach=reach)

    def polish(
        self,
        start: Array,
        goal: Array,
        guess: Array,
        rows: Sequence[ClearanceRow] = (),
        *,
        panels: int = POLISH_PANELS[0],
        limited: bool = True,
    ) -> Solution:
        """Minimise g itself from a guess (n, size), with so little of the energy that its minimum is one point.

        Args:
            start, goal, guess, rows: as in `solve`.
            panels: of ten Gauss points each, on which g is integrated.
            limited: False: as if there were no joint limits.
        """
        size = np.sqrt(self._integral(self._energy, start, goal, guess, 1.0))
        return self._solve(panels, start, goal, guess, rows, size, size, limited=limited)

    @interruptible()
    def _solve(
        self,
        panels: int,
        start: Array,
        goal: Array,
        guess: Array,
        rows: Sequence[ClearanceRow],
        size: float,
        g0: float,
        *,
        limited: bool = True,
        reach: float = np.inf,
    ) -> Solution:
        """Minimise g on so many panels, or the energy for 0."""
        capacity = 0 if not rows else 32 * 2 ** int(np.ceil(np.log2(max(len(rows) / 32, 1))))
        limits = self.kinematics.robot.limits
        limited = limited and bool(np.isfinite([limits.lower, limits.upper]).any())
        solver = self._solver(panels, capacity, limited)
        unknowns = guess @ self._along
        kept = guess - unknowns @ self.free.T
        numbers = [start, goal, [1 / size, g0], kept.ravel(order="F")]
        parameters = np.concatenate([*numbers, self._row_parameters(rows, capacity).ravel(order="F")])
        count = len(self._limit_line) if limited else 0
        joint_limits = [np.tile(each, count) for each in (limits.lower, limits.upper)]
        result = solver(
            x0=np.concatenate([unknowns.ravel(order="F"), np.zeros(capacity)]),
            p=parameters,
            lbx=np.concatenate([unknowns.ravel(order="F") - reach, np.zeros(capacity)]),
            ubx=np.concatenate([unknowns.ravel(order="F") + reach, np.full(capacity, np.inf)]),
            lbg=np.concatenate([joint_limits[0], np.zeros(capacity)]),
            ubg=np.concatenate([joint_limits[1], np.full(capacity, np.inf)]),
        )
        status = str(solver.stats()["return_status"])
        x = np.asarray(result["x"]).ravel()
        return Solution(
            coefficients=kept + x[: unknowns.size].reshape(unknowns.shape, order="F") @ self.free.T,
            slack=float(x[unknowns.size : unknowns.size + len(rows)].max(initial=0.0)),
            status=status,
        )

    def _integral(self, objective: "_Objective", start: Array, goal: Array, guess: Array, g0: float) -> float:
        """The objective at a guess; 1 where it is not a number above zero."""
        s = objective.s
        q = start[:, None] + np.outer(goal - start, s) + guess @ self.basis.values(s).T
        v = (goal - start)[:, None] + guess @ self.basis.values(s, 1).T
        value = float(
            np.asarray(objective.density.value(q, v, np.array([[g0], [self.objective.power]]))).ravel() @ objective.weights
        )
        return value if np.isfinite(value) and value > 0 else 1.0

    def _row_parameters(self, rows: Sequence[ClearanceRow], capacity: int) -> Array:
        """One column a row; unused columns hold a row that is always met."""
        joints = self.n + 1
        bubbles = self.basis.size
        table = np.zeros((bubbles + 1 + 2 * joints + 8, capacity))
        table[bubbles + 1, :] = table[bubbles + 1 + joints, :] = 1.0
        table[-2, :] = -1.0  # offset -1 m and no normal: 0 >= -1
        at = np.array([row.s for row in rows])
        for k, (row, values) in enumerate(zip(rows, self.basis.values(at), strict=True)):
            carrier, other = np.eye(joints)[row.joint], np.eye(joints)[row.other]
            table[:, k] = [*values, row.s, *carrier, *other, *row.point, *row.normal, row.offset, row.distance]
        return table

    def _solver(self, panels: int, capacity: int, limited: bool) -> ca.Function:
        key = (panels, capacity, limited)
        if key not in self._solvers:
            self._solvers[key] = self._build(self._length(panels) if panels else self._energy, capacity, limited)
        return self._solvers[key]

    def _build(self, objective: "_Objective", capacity: int, limited: bool) -> ca.Function:
        """IPOPT on the program with `capacity` clearance rows, with exact first and second derivatives."""
        n, bubbles = self.n, self.basis.size
        free = ca.sparsify(ca.DM(self.free))
        size = n * self.free.shape[1]
        z = ca.MX.sym("z", size + capacity)
        slack = z[size:]
        width = bubbles + 1 + 2 * (n + 1) + 8
        fixed = 2 * n + 2 + n * bubbles
        p = ca.MX.sym("p", fixed + width * capacity)
        start, goal, scale, g0 = p[:n], p[n : 2 * n], p[2 * n], p[2 * n + 1]
        x = ca.reshape(p[2 * n + 2 : fixed], n, bubbles) + ca.reshape(z[:size], n, self.free.shape[1]) @ free.T
        table = ca.reshape(p[fixed:], width, capacity)
        nodes = len(objective.s)
        values, slopes = self.basis.values(objective.s), self.basis.values(objective.s, 1)

        # the objective: e(q_i, v_i) at the nodes, q = line + x φ, v = line' + x φ'
        q = start @ ca.DM.ones(1, nodes) + (goal - start) @ ca.DM(objective.s).T + x @ ca.DM(values).T
        v = (goal - start) @ ca.DM.ones(1, nodes) + x @ ca.DM(slopes).T
        numbers = ca.repmat(ca.vertcat(g0, self.objective.power), 1, nodes)
        density = objective.density
        value, gradient, hessian = (f.map(nodes)(q, v, numbers) for f in (density.value, density.gradient, density.hessian))
        weights = scale * ca.DM(objective.weights).T
        f = ca.dot(value, weights) + SLACK_COST * ca.sum1(slack)
        weighed = gradient * ca.repmat(weights, 2 * n, 1)
        grad_x = weighed[:n, :] @ ca.DM(values @ self.free) + weighed[n:, :] @ ca.DM(slopes @ self.free)
        grad_f = ca.vertcat(ca.vec(grad_x), SLACK_COST * ca.MX.ones(capacity))
        maps = [
            ca.vertcat(*(ca.kron(ca.DM((row @ self.free)[None, :]), ca.DM.eye(n)) for row in (values[i], slopes[i])))
            for i in range(nodes)
        ]
        stacked = ca.sparsify(ca.vertcat(*maps))
        blocks = ca.diagcat(*(w * h for w, h in zip(ca.horzsplit(weights), ca.horzsplit(hessian, 2 * n), strict=True)))
        hess_x = stacked.T @ blocks @ stacked

        # joint limits: control points of the pieces, linear in x
        rows = len(self._limit_line) if limited else 0
        line, matrix = self._limit_line[:rows], self._limit_rows[:rows]
        points = start @ ca.DM.ones(1, rows) + (goal - start) @ ca.DM(line).T + x @ ca.DM(matrix).T
        limits = ca.vec(points)
        jac_limits = ca.kron(ca.sparsify(ca.DM(matrix @ self.free)), ca.DM.eye(n))

        # clearance: one row function of q a column of the table
        g = limits
        jac_g = ca.horzcat(ca.MX(jac_limits), ca.MX(n * rows, capacity))
        lam = ca.MX.sym("lam", n * rows + capacity)
        if capacity:
            place, at = table[:bubbles, :], table[bubbles, :]
            q_rows = start @ ca.DM.ones(1, capacity) + (goal - start) @ at + x @ place
            distance, slope, bend = (f.map(capacity)(q_rows, table[bubbles + 1 :, :]) for f in self._rows)
            g = ca.vertcat(g, distance.T + slack)
            chain = [ca.kron(column.T @ free, ca.DM.eye(n)) for column in ca.horzsplit(place)]
            jac_rows = [column.T @ link for column, link in zip(ca.horzsplit(slope), chain, strict=True)]
            jac_g = ca.vertcat(jac_g, ca.horzcat(ca.vertcat(*jac_rows), ca.DM.eye(capacity)))
            chained = ca.vertcat(*chain)
            multipliers = ca.vertsplit(lam[n * rows :])
            bends = ca.diagcat(*(m * h for m, h in zip(multipliers, ca.horzsplit(bend, n), strict=True)))
            row_hessian = chained.T @ bends @ chained
        else:
            row_hessian = ca.MX(size, size)
        lam_f = ca.MX.sym("lam_f")
        full = ca.diagcat(ca.densify(lam_f * hess_x + row_hessian), ca.MX(capacity, capacity))
        options = {
            "grad_f": ca.Function("grad_f", [z, p], [f, grad_f]),
            "jac_g": ca.Function("jac_g", [z, p], [g, jac_g]),
            "hess_lag": ca.Function("hess_lag", [z, p, lam_f, lam], [ca.triu(full)]),
            "print_time": False,
            "error_on_fail": False,
            "calc_lam_p": False,
            "no_nlp_grad": True,
            "show_eval_warnings": False,  # a step to where g is no number is halved
            "ipopt": {
                "print_level": 0,
                "sb": "yes",
                "max_iter": objective.steps,
                "tol": objective.tolerance,
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


def _row_functions(kinematics: Kinematics) -> tuple[ca.Function, ...]:
    """Signed distance of a clearance row [m], its gradient (n) and Hessian (n, n) in q, a Function each, compiled as asked.

    The second argument is a column of the row table: which joint carries the point, which the plane (one-hot), point,
    normal, offset, distance to keep. Only joints between the two move the point against the plane: sign σ_i is 1 where
    joint i carries the point alone, -1 where it carries the plane alone. Then with c_i the velocity of the point as
    carried by joint i, ∂_i d = σ_i n · c_i, and for i <= j ∂_i ∂_j d = n · (z_i x c_j), or n · (z_j x c_i) for the plane.
    """
    chain, model = kinematics.symbolic.chain, kinematics.robot.model
    q, n = chain.q, kinematics.robot.n
    carrier, other = ca.SX.sym("carrier", n + 1), ca.SX.sym("other", n + 1)
    point, normal = ca.SX.sym("point", 3), ca.SX.sym("normal", 3)
    offset, keep = ca.SX.sym("offset"), ca.SX.sym("keep")
    position, plane_origin, plane_normal = ca.SX.zeros(3), ca.SX.zeros(3), ca.SX.zeros(3)
    for k, placement in enumerate(chain.joints):
        position += carrier[k] * (placement.origin + placement.rotation @ point)
        plane_origin += other[k] * placement.origin
        plane_normal += other[k] * (placement.rotation @ normal)
    distance = ca.dot(plane_normal, position - plane_origin) - offset - keep

    spin, velocity, sign = [], [], []
    for i in range(1, n + 1):
        axis = chain.joints[i].rotation @ ca.DM(axis_of(model.joints[i]))
        slides = is_prismatic(model.joints[i])
        spin.append(ca.SX.zeros(3) if slides else axis)
        velocity.append(axis if slides else ca.cross(axis, position - chain.joints[i].origin))
        sign.append(ca.sum1(carrier[i:]) - ca.sum1(other[i:]))
    gradient = ca.vertcat(*(sign[i] * ca.dot(plane_normal, velocity[i]) for i in range(n)))
    hessian = ca.SX.zeros(n, n)
    for j in range(n):
        for i in range(j + 1):
            both = sign[i] * sign[j] / 2
            bend = both * ca.dot(
                plane_normal,
                (1 + sign[i]) * ca.cross(spin[i], velocity[j]) + (1 - sign[i]) * ca.cross(spin[j], velocity[i]),
            )
            hessian[i, j] = hessian[j, i] = bend
    column = ca.vertcat(carrier, other, point, normal, offset, keep)
    functions = [
        ca.Function("path_row", [q, column], [distance]),
        ca.Function("path_row_gradient", [q, column], [ca.densify(gradient)]),
        ca.Function("path_row_hessian", [q, column], [ca.densify(hessian)]),
    ]
    return as_asked(functions, kinematics.compiled, f"clearance rows of paths of {kinematics.robot.name}")
