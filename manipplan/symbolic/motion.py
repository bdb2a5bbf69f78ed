"""Derivatives of a Jacobian with respect to q: the kinematic Hessian D_k = ∂J/∂q_k from the Jacobian's own columns.

S_j = (v_j, w_j) is the tool's linear and angular velocity for unit speed of joint j. A joint moves all that follow it: with
world axes ∂_k S_j = (w_k x v_j, w_k x w_j) for k <= j and (w_j x v_k, 0) for k > j; with tool axes
∂_k S_j = (w_j x v_k + v_j x w_k, w_j x w_k) for k > j and 0 for k <= j.

From it and trace identities follow gradient and Hessian of Yoshikawa's manipulability m. m_ρ = sqrt(det(J Jᵀ + ρ² I)) is m with
the regularisation ρ: it equals m up to a relative error of Σ ρ²/(2 σ_i²), with σ_i the singular values, and stays smooth at
m = 0, where m has a kink. Symbols: L Lᵀ = J Jᵀ + ρ² I, J = L Qᵀ; P = L⁻ᵀ Qᵀ, so that Pᵀ = J⁺ for ρ = 0.

The determinant of a sparse symbolic matrix as a polynomial in its entries: smooth, signed, and cheap to differentiate.

The tool seen from another frame of the robot: its placement there, and the Jacobian of its motion relative to that frame. There
R, p are rotation and origin of the reference frame in the world, v, ω velocity and angular velocity of a frame.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass

import casadi as ca
import pinocchio as pin

from manipplan.robots.model_tree import JointTree, frame_index
from manipplan.symbolic.chain import Placement, SymbolicChain, constant, jacobian_of
from manipplan.symbolic.task import Task


class Motion(ABC):
    """The derivatives of a symbolic matrix J (m, n') with respect to q (n,)."""

    @abstractmethod
    def kinematic_hessian(self) -> list[ca.SX]:
        """D_k = ∂J/∂q_k, n matrices (m, n')."""

    @abstractmethod
    def first(self, weights: ca.SX) -> ca.SX:
        """The derivatives ∂_k <weights, J>, (n, 1), for constant weights (m, n')."""

    @abstractmethod
    def second(self, weights: ca.SX) -> ca.SX:
        """The derivatives ∂_k ∂_l <weights, J>, (n, n), for constant weights (m, n')."""


@dataclass(frozen=True, kw_only=True)
class MatrixMotion(Motion):
    """Any expression `matrix` of q, by automatic differentiation."""

    matrix: ca.SX
    q: ca.SX

    def kinematic_hessian(self) -> list[ca.SX]:
        columns = ca.jacobian(ca.vec(self.matrix), self.q)
        return [ca.reshape(columns[:, k], *self.matrix.shape) for k in range(self.q.shape[0])]

    def first(self, weights: ca.SX) -> ca.SX:
        return self._derivatives(weights)[1]

    def second(self, weights: ca.SX) -> ca.SX:
        return self._derivatives(weights)[0]

    def _derivatives(self, weights: ca.SX) -> tuple[ca.SX, ca.SX]:
        constant = ca.SX.sym("weights", *self.matrix.shape)
        hessian, gradient = ca.hessian(ca.dot(constant, self.matrix), self.q)
        function = ca.Function("linear", [self.q, constant], [ca.densify(hessian), ca.densify(gradient)])
        hessian, gradient = function.call([self.q, weights], True, False)
        return hessian, gradient


@dataclass(frozen=True, kw_only=True)
class Columns:
    """The Jacobian's columns, in world or tool axes: lists of n vectors (3,)."""

    v: list[ca.SX]
    w: list[ca.SX]

    @classmethod
    def of(cls, jacobian: ca.SX) -> "Columns":
        n = jacobian.shape[1]
        return cls(v=[jacobian[:3, j] for j in range(n)], w=[jacobian[3:, j] for j in range(n)])

    def derivative(self, k: int, *, in_tool: bool) -> ca.SX:
        """∂S/∂q_k, (6, n)."""
        columns = []
        for j, (v, w) in enumerate(zip(self.v, self.w, strict=True)):
            if in_tool:
                moved = (ca.cross(w, self.v[k]) + ca.cross(v, self.w[k]), ca.cross(w, self.w[k]))
                column = ca.vertcat(*moved) if k > j else ca.SX(6, 1)
            elif k <= j:
                column = ca.vertcat(ca.cross(self.w[k], v), ca.cross(self.w[k], w))
            else:
                column = ca.vertcat(ca.cross(w, self.v[k]), ca.SX(3, 1))
            columns.append(column)
        return ca.horzcat(*columns)

    def first(self, weights: ca.SX, *, in_tool: bool) -> ca.SX:
        """The derivatives ∂_k Σ_j weights_j · S_j for constant weights (6, n), as (n, 1)."""
        n, forces = len(self.v), Columns.of(weights)
        f, t = forces.v, forces.w
        slopes = []
        if in_tool:
            before_v, before_w = ca.SX.zeros(3), ca.SX.zeros(3)
            for k in range(n):
                slopes.append(ca.dot(self.v[k], before_v) + ca.dot(self.w[k], before_w))
                before_v += ca.cross(f[k], self.w[k])
                before_w += ca.cross(f[k], self.v[k]) + ca.cross(t[k], self.w[k])
            return ca.vertcat(*slopes)
        after = ca.SX.zeros(3)
        carried: list[ca.SX] = []
        for k in reversed(range(n)):
            after += ca.cross(self.v[k], f[k]) + ca.cross(self.w[k], t[k])
            carried.insert(0, after)
        before = ca.SX.zeros(3)
        for k in range(n):
            slopes.append(ca.dot(self.w[k], carried[k]) + ca.dot(self.v[k], before))
            before += ca.cross(f[k], self.w[k])
        return ca.vertcat(*slopes)

    def second(self, weights: ca.SX, *, in_tool: bool) -> ca.SX:
        """The derivatives ∂_k ∂_l Σ_j weights_j · S_j for constant weights (6, n), as (n, n).

        Triple products of cross products become (N - tr N) u with N = Σ a bᵀ, summed once along the chain.
        """
        n, forces = len(self.v), Columns.of(weights)
        f, t = forces.v, forces.w
        out = ca.SX.zeros(n, n)
        if in_tool:
            spin, screw = ca.SX.zeros(3, 3), ca.SX.zeros(3, 3)
            for j in range(n):
                by_v = _triple(spin, self.w[j])
                by_w = _triple(spin, self.v[j]) + _triple(screw, self.w[j])
                for k in range(j, n):
                    out[j, k] = out[k, j] = ca.dot(self.v[k], by_v) + ca.dot(self.w[k], by_w)
                spin += self.w[j] @ f[j].T
                screw += self.v[j] @ f[j].T + self.w[j] @ t[j].T
            return out
        screw = ca.SX.zeros(3, 3)
        carried: list[ca.SX] = []
        for j in reversed(range(n)):
            screw += self.v[j] @ f[j].T + self.w[j] @ t[j].T
            carried.insert(0, _triple(screw, self.w[j]))
        before = ca.SX.zeros(3)
        for k in range(n):
            between = ca.SX.zeros(3, 3)
            for j in range(k, n):
                turned = carried[j] - _triple(between, self.v[j])
                out[k, j] = out[j, k] = ca.dot(self.w[k], turned) + ca.dot(ca.cross(self.w[k], self.v[j]), before)
                between += self.w[j] @ f[j].T
            before += ca.cross(f[k], self.w[k])
        return out


@dataclass(frozen=True, kw_only=True)
class TaskMotion(Motion):
    """A task's Jacobian, by the rules for its columns, without finite differences or automatic differentiation."""

    chain: SymbolicChain
    task: Task

    def _groups(self) -> list[tuple[ca.DM, Columns, bool, slice]]:
        """The task's rows in world axes, and those in tool axes: (matrix, columns, in_tool, position in the task)."""
        world, tool = self.task.matrices
        jacobian, rotation = self.chain.jacobian, self.chain.tool.rotation
        groups = []
        if len(world):
            groups.append((ca.sparsify(ca.DM(world)), Columns.of(jacobian), False, slice(0, len(world))))
        if len(tool):
            turned = ca.vertcat(rotation.T @ jacobian[:3, :], rotation.T @ jacobian[3:, :])
            groups.append((ca.sparsify(ca.DM(tool)), Columns.of(turned), True, slice(len(world), self.task.rows)))
        return groups

    def kinematic_hessian(self) -> list[ca.SX]:
        n = self.chain.jacobian.shape[1]
        groups = self._groups()
        return [
            ca.vertcat(*(rows @ columns.derivative(k, in_tool=in_tool) for rows, columns, in_tool, _ in groups))
            for k in range(n)
        ]

    def first(self, weights: ca.SX) -> ca.SX:
        return sum(columns.first(rows.T @ weights[at, :], in_tool=in_tool) for rows, columns, in_tool, at in self._groups())

    def second(self, weights: ca.SX) -> ca.SX:
        return sum(columns.second(rows.T @ weights[at, :], in_tool=in_tool) for rows, columns, in_tool, at in self._groups())


@dataclass(frozen=True, kw_only=True)
class LedMotion(Motion):
    """A matrix J G (m, n) of the positions G q + b of N joints, of which some follow others, by the motion of J (m, N)."""

    inner: Motion
    matrix: ca.DM

    @classmethod
    def of(cls, jacobian: ca.SX, inner: Motion, tree: JointTree) -> tuple[ca.SX, Motion]:
        """J G and its motion; J and its own where no joint follows another."""
        if not tree.has_followers:
            return jacobian, inner
        matrix = ca.sparsify(ca.DM(tree.matrix))
        return jacobian @ matrix, cls(inner=inner, matrix=matrix)

    def kinematic_hessian(self) -> list[ca.SX]:
        derivatives = self.inner.kinematic_hessian()
        led = [self.matrix[:, k] for k in range(self.matrix.shape[1])]
        return [sum(float(c[i]) * derivatives[i] for i in c.row()) @ self.matrix for c in led]

    def first(self, weights: ca.SX) -> ca.SX:
        return self.matrix.T @ self.inner.first(weights @ self.matrix.T)

    def second(self, weights: ca.SX) -> ca.SX:
        return self.matrix.T @ self.inner.second(weights @ self.matrix.T) @ self.matrix


def _triple(moment: ca.SX, u: ca.SX) -> ca.SX:
    """Σ b x (a x u) = (N - tr N) u, with `moment` N = Σ a bᵀ."""
    return moment @ u - ca.trace(moment) * u


@dataclass(frozen=True, kw_only=True)
class Factor:
    """J = L Qᵀ with L Lᵀ = J Jᵀ + ρ² I: L (m, m) lower triangular; Q (n, m) has orthonormal columns when ρ = 0."""

    L: ca.SX
    Q: ca.SX

    @classmethod
    def of(cls, jacobian: ca.SX, regularisation: float) -> "Factor":
        """By Gram-Schmidt on the rows of [J, ρ I], so that no digits are lost by squaring in J Jᵀ."""
        m, n = jacobian.shape
        lower = ca.SX(m, m)
        rows: list[ca.SX] = []
        for i, row in enumerate(ca.vertsplit(ca.horzcat(jacobian, regularisation * ca.SX.eye(m)))):
            for j, before in enumerate(rows):
                lower[i, j] = ca.dot(before, row)
                row = row - lower[i, j] * before  # noqa: PLW2901
            lower[i, i] = ca.sqrt(ca.sumsqr(row))
            rows.append(row / lower[i, i])
        return cls(L=lower, Q=ca.vertcat(*rows)[:, :n].T)

    @property
    def manipulability(self) -> ca.SX:
        """m_ρ."""
        product = self.L[0, 0]
        for i in range(1, self.L.shape[0]):
            product *= self.L[i, i]
        return product

    @property
    def weights(self) -> ca.SX:
        """P, (m, n)."""
        return ca.solve(self.L.T, self.Q.T)


def log_gradient(factor: Factor, motion: Motion) -> ca.SX:
    """∇ log m_ρ, (n, 1): its entries are tr((J Jᵀ + ρ² I)⁻¹ D_k Jᵀ) = <P, D_k>, (18) in dufour2020."""
    return motion.first(factor.weights)


def log_hessian(factor: Factor, motion: Motion) -> ca.SX:
    """The Hessian of log m_ρ, (n, n).

    With E_k = L⁻¹ D_k and F_k = E_k Q its entries are tr(∂_l D_k Pᵀ) + <E_k, E_l> - tr(F_k F_l) - <F_k, F_l>.
    """
    inverse = ca.solve(factor.L, ca.SX.eye(factor.L.shape[0]))
    scaled = [inverse @ derivative for derivative in motion.kinematic_hessian()]
    turned = [each @ factor.Q for each in scaled]
    symmetric = [each + each.T for each in turned]  # tr(F_k F_l) + <F_k, F_l> = <F_k + F_kᵀ, F_l + F_lᵀ> / 2
    hessian = motion.second(factor.weights)
    for k in range(len(scaled)):
        for j in range(k + 1):
            entry = hessian[k, j] + ca.dot(scaled[k], scaled[j]) - ca.dot(symmetric[k], symmetric[j]) / 2
            hessian[k, j] = hessian[j, k] = entry
    return hessian


def manipulability_gradient(jacobian: ca.SX, motion: Motion, regularisation: float) -> ca.SX:
    """∇m_ρ, (n, 1)."""
    factor = Factor.of(jacobian, regularisation)
    return factor.manipulability * log_gradient(factor, motion)


def manipulability_hessian(jacobian: ca.SX, motion: Motion, regularisation: float) -> ca.SX:
    """∇²m_ρ = m_ρ (∇² log m_ρ + ∇ log m_ρ ∇ log m_ρᵀ), (n, n)."""
    factor = Factor.of(jacobian, regularisation)
    slope = log_gradient(factor, motion)
    return factor.manipulability * (log_hessian(factor, motion) + slope @ slope.T)


def determinant(matrix: ca.SX) -> ca.SX:
    """det of a matrix (n, n) by Laplace's expansion, with each minor computed once; zero entries cost nothing.

    No division occurs, so the expression and its derivatives are exact at singular matrices too.
    """
    n = matrix.shape[0]
    minors: dict[tuple[int, ...], ca.SX] = {(): ca.SX(1.0)}  # of the first rows, by their columns
    for i in range(n):
        larger: dict[tuple[int, ...], ca.SX] = {}
        for columns, minor in minors.items():
            for j in range(n):
                if j in columns or matrix[i, j].is_zero():
                    continue
                chosen = tuple(sorted((*columns, j)))
                sign = (-1) ** sum(column > j for column in columns)
                larger[chosen] = larger.get(chosen, ca.SX(0.0)) + sign * minor * matrix[i, j]
        minors = larger
    return minors.get(tuple(range(n)), ca.SX(0.0))


@dataclass(frozen=True, kw_only=True)
class Seen:
    """A tool seen from the frame that a task refers to, which is the world by default.

    Attributes:
        tool: placement of the tool in that frame.
        jacobian: (6, n) of the tool's origin and rotation relative to that frame, along its axes, linear rows first.
    """

    tool: Placement
    jacobian: ca.SX

    @classmethod
    def of(cls, chain: SymbolicChain, task: Task) -> "Seen":
        """The tool of a chain; the frame exists."""
        if task.relative_to is None:
            return cls(tool=chain.tool, jacobian=chain.jacobian)
        frame, carrier = _place_frame(chain, task.relative_to)
        own = jacobian_of(chain.tree, chain.carriers(carrier), chain.tool.origin)  # of the tool's origin, were it fixed there
        turned = frame.rotation.T
        apart = chain.jacobian - own
        jacobian = ca.vertcat(turned @ apart[:3, :], turned @ apart[3:, :])
        return cls(tool=frame.inverse() @ chain.tool, jacobian=ca.sparsify(jacobian))


def task_rows(chain: SymbolicChain, task: Task) -> tuple[ca.SX, Motion]:
    """The task's Jacobian (m, n), and how it changes with q."""
    if task.relative_to is None:
        alone = chain.alone if chain.tree.has_followers else chain
        return LedMotion.of(task.rows_of(alone.jacobian, chain.tool.rotation), TaskMotion(chain=alone, task=task), chain.tree)
    seen = Seen.of(chain, task)
    jacobian = task.rows_of(seen.jacobian, seen.tool.rotation)
    return jacobian, MatrixMotion(matrix=jacobian, q=chain.q)


def _place_frame(chain: SymbolicChain, name: str) -> tuple[Placement, int]:
    """A frame in the world, and the index of the joint that carries it."""
    frame: pin.Frame = chain.model.frames[frame_index(chain.model, name)]
    return chain.joints[frame.parentJoint] @ constant(frame.placement), int(frame.parentJoint)
