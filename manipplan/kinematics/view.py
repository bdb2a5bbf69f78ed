"""Jacobians in the frame of a middle joint: the same manipulability with far fewer operations.

Rotating all rows does not change Yoshikawa's manipulability; nor does another reference point if the task has all six rows.
In such a frame base and tool angle do not occur, and the columns near the middle are short.
"""

from dataclasses import dataclass

import casadi as ca

from manipplan.symbolic.chain import WORLD, SymbolicChain, constant, jacobian_of, step
from manipplan.symbolic.motion import LedMotion, Motion
from manipplan.symbolic.relative import task_rows
from manipplan.symbolic.task import Task


@dataclass(frozen=True, kw_only=True)
class View:
    """Jacobians with the manipulability of a task.

    Attributes:
        jacobian: (m, n), the one with the fewest operations that we know.
        smooth: a Jacobian (m, n) with that manipulability, and its motion, for derivatives of functions of det(J Jᵀ) alone.
    """

    jacobian: ca.SX
    smooth: tuple[ca.SX, Motion]

    @classmethod
    def of(cls, chain: SymbolicChain, task: Task) -> "View":
        """The best view of `chain` for `task`; the plain Jacobian if the task depends on the world axes."""
        n = len(chain.joints) - 1
        smooth = task_rows(chain, task)
        plain = smooth[0]
        if not (task.turns_freely and _straight(chain) and task.relative_to is None):
            return cls(jacobian=plain, smooth=smooth)
        if task.tool_rows:
            return cls(jacobian=_led(chain, task.rows_of(*_seen_from(chain, n, None))), smooth=smooth)
        middle = (n + 1) // 2
        if len(task.world_rows) < 6:
            return cls(jacobian=_led(chain, task.rows_of(*_seen_from(chain, middle, None))), smooth=smooth)
        places = [(f, at) for f in (middle, max(middle - 1, 1)) for at in range(1, n + 1)]
        views = [(_seen_from(chain, f, at)[0], f) for f, at in places]
        seen, f = min(views, key=lambda view: int(view[0].nnz()))
        rows = ca.sparsify(ca.DM(task.matrices[0]))
        smooth = LedMotion.of(rows @ seen, ViewMotion(jacobian=seen, f=f, rows=rows), chain.tree)
        return cls(jacobian=smooth[0], smooth=smooth)


def steady(chain: SymbolicChain, task: Task) -> tuple[ca.SX, Motion]:
    """A Jacobian (m, n) with the manipulability of `task` and its true derivatives, for functions of J Jᵀ + ρ² I.

    Such functions depend on the reference point of J. Here it is the origin of the middle joint, at rest in that frame.
    This takes a third more operations than `View.smooth`, and a third of those of the plain Jacobian.
    """
    n = len(chain.joints) - 1
    is_pose = task.turns_freely and not task.tool_rows and len(task.world_rows) == 6
    if not (_straight(chain) and is_pose and task.relative_to is None):
        return task_rows(chain, task)
    middle = (n + 1) // 2
    seen, _ = _seen_from(chain, middle, middle)
    rows = ca.sparsify(ca.DM(task.matrices[0]))
    return LedMotion.of(rows @ seen, ViewMotion(jacobian=seen, f=middle, rows=rows), chain.tree)


@dataclass(frozen=True, kw_only=True)
class ViewMotion(Motion):
    """The six rows of a pose along the axes of joint f, for a reference point frozen in that frame at q.

    A column only changes with the joints between it and f: ∂_k S_j = ± [S_k, S_j], plus for f < k < j, minus for
    j < k <= f, with the bracket (w_k x v_j + v_k x w_j, w_k x w_j). So most of the kinematic Hessian is zero. If the
    reference point of `jacobian` moves with q, this is not the derivative of `jacobian`. But det(J Jᵀ) does not depend
    on the point, so its gradient and Hessian are still correct.

    Attributes:
        jacobian: (6, n), not weighted.
        f: the joint, counted from 1.
        rows: the task's rows (6, 6), including the task's length.
    """

    jacobian: ca.SX
    f: int
    rows: ca.DM

    def kinematic_hessian(self) -> list[ca.SX]:
        n = self.jacobian.shape[1]
        derivatives = []
        for k in range(n):
            moved = self._moved(k)
            derivatives.append(self.rows @ ca.horzcat(*(moved.get(j, ca.SX(6, 1)) for j in range(n))))
        return derivatives

    def first(self, weights: ca.SX) -> ca.SX:
        plain = self.rows.T @ weights
        n = self.jacobian.shape[1]
        return ca.vertcat(*(sum((ca.dot(plain[:, j], s) for j, s in self._moved(k).items()), ca.SX(0.0)) for k in range(n)))

    def second(self, weights: ca.SX) -> ca.SX:
        plain = self.rows.T @ weights
        n = self.jacobian.shape[1]
        out = ca.SX(n, n)
        for k in range(n):
            after = k >= self.f
            # <weights_j, [S_i, [S_k, S_j]]> = S_i · Σ_j (dual of [S_k, S_j] with weights_j), for every i nearer to f
            dual = sum((_dual(s, plain[:, j]) for j, s in self._moved(k).items()), ca.SX(6, 1))
            for i in range(self.f, k + 1) if after else range(k, self.f):
                entry = ca.dot(self.jacobian[:, i], dual)
                out[i, k] = out[k, i] = entry if after else -entry
        return out

    def _moved(self, k: int) -> dict[int, ca.SX]:
        """∂_k S_j for the j that joint k moves; joints counted from 0."""
        n = self.jacobian.shape[1]
        if k >= self.f:
            return {j: _bracket(self.jacobian[:, k], self.jacobian[:, j]) for j in range(k + 1, n)}
        return {j: -_bracket(self.jacobian[:, k], self.jacobian[:, j]) for j in range(k)}


def _straight(chain: SymbolicChain) -> bool:
    """Whether each joint carries the next and the last one the tool, and the expressions are our own."""
    n = len(chain.joints) - 1
    return chain.own and list(chain.model.parents)[1:] == list(range(n)) and chain.frame.parentJoint == n


def _led(chain: SymbolicChain, jacobian: ca.SX) -> ca.SX:
    """The Jacobian by q of one with a column for each joint."""
    return jacobian @ ca.sparsify(ca.DM(chain.tree.matrix)) if chain.tree.has_followers else jacobian


def _bracket(a: ca.SX, b: ca.SX) -> ca.SX:
    return ca.vertcat(ca.cross(a[3:], b[:3]) + ca.cross(a[:3], b[3:]), ca.cross(a[3:], b[3:]))


def _dual(b: ca.SX, weights: ca.SX) -> ca.SX:
    """The vector d with <weights, [a, b]> = a · d for every a."""
    f, t = weights[:3], weights[3:]
    return ca.vertcat(ca.cross(b[3:], f), ca.cross(b[:3], f) + ca.cross(b[3:], t))


def _seen_from(chain: SymbolicChain, f: int, at: int | None) -> tuple[ca.SX, ca.SX]:
    """The Jacobian (6, N) along the axes of joint f for the origin of joint `at` (None: the tool), and the tool's rotation.

    It has a column for each joint, whether it follows another or not.
    """
    tree, n = chain.tree, len(chain.joints) - 1
    frames = {f: WORLD}
    for i in range(f + 1, n + 1):
        frames[i] = frames[i - 1] @ step(tree, i, chain.q)
    for i in range(f - 1, 0, -1):
        frames[i] = frames[i + 1] @ step(tree, i + 1, chain.q).inverse()
    end = frames[n] @ constant(chain.frame.placement)
    point = end.origin if at is None else frames[at].origin
    return ca.sparsify(jacobian_of(tree.alone(), [frames[i] for i in range(1, n + 1)], point)), end.rotation
