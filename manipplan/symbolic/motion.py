"""Derivatives of a Jacobian with respect to q: the kinematic Hessian D_k = ∂J/∂q_k from the Jacobian's own columns.

S_j = (v_j, w_j) is the tool's linear and angular velocity for unit speed of joint j. A joint moves all that follow it: with
world axes ∂_k S_j = (w_k x v_j, w_k x w_j) for k <= j and (w_j x v_k, 0) for k > j; with tool axes
∂_k S_j = (w_j x v_k + v_j x w_k, w_j x w_k) for k > j and 0 for k <= j.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass

import casadi as ca

from manipplan.robots.model_tree import JointTree
from manipplan.symbolic.chain import SymbolicChain
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
        n = len(self.v)
        f, t = _split(weights)
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
        n = len(self.v)
        f, t = _split(weights)
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


def _split(weights: ca.SX) -> tuple[list[ca.SX], list[ca.SX]]:
    n = weights.shape[1]
    return [weights[:3, j] for j in range(n)], [weights[3:, j] for j in range(n)]


def _triple(moment: ca.SX, u: ca.SX) -> ca.SX:
    """Σ b x (a x u) = (N - tr N) u, with `moment` N = Σ a bᵀ."""
    return moment @ u - ca.trace(moment) * u
