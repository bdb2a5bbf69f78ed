"""Kinematics: pose, Jacobian, manipulability index and its derivatives of one arm for one task."""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

import casadi as ca
import numpy as np
from numpy.typing import ArrayLike

from manipplan.checks import Array, configurations
from manipplan.errors import InvalidInputError
from manipplan.kinematics.chain import SymbolicChain
from manipplan.measures.indices import yoshikawa
from manipplan.measures.task import Task

if TYPE_CHECKING:
    from manipplan.robots.robot import Robot


class SymbolicKinematics:
    """The CasADi Functions of one arm and task, each built when first asked for; every one takes q (n,)."""

    def __init__(self, chain: SymbolicChain, task: Task) -> None:
        self.chain = chain
        self.task = task
        self._jacobian = task.rows_of(chain.jacobian, chain.tool.rotation)
        self._index = yoshikawa(self._jacobian)

    @cached_property
    def pose(self) -> ca.Function:
        """T_world_tool (4, 4)."""
        return ca.Function("pose", [self.chain.q], [self.chain.tool.matrix()], ["q"], ["T"])

    @cached_property
    def jacobian(self) -> ca.Function:
        """Task Jacobian (m, n)."""
        return ca.Function("jacobian", [self.chain.q], [ca.densify(self._jacobian)], ["q"], ["J"])

    @cached_property
    def manipulability(self) -> ca.Function:
        """Index m (1, 1)."""
        return ca.Function("manipulability", [self.chain.q], [ca.densify(self._index)], ["q"], ["m"])

    @cached_property
    def gradient(self) -> ca.Function:
        """∇m (n, 1)."""
        gradient = ca.gradient(self._index, self.chain.q)
        return ca.Function("gradient", [self.chain.q], [ca.densify(gradient)], ["q"], ["grad"])

    @cached_property
    def hessian(self) -> ca.Function:
        """∇²m (n, n)."""
        hessian, _ = ca.hessian(self._index, self.chain.q)
        return ca.Function("hessian", [self.chain.q], [ca.densify(hessian)], ["q"], ["H"])


@dataclass(frozen=True, kw_only=True, eq=False)
class Kinematics:
    """Kinematics of `robot` for `task`. Every method takes q (n,) or (..., n) [rad or m] and raises InvalidInputError
    for another shape, NaN or inf.

    The Jacobian is LOCAL_WORLD_ALIGNED: velocity of the tool's origin along world axes, then angular velocity about
    world axes times `task.length`. The index is Yoshikawa's, m = sqrt(det(J Jᵀ)), in `task.unit`; with fewer joints
    than rows it is identically zero. At a singular q, where m has a kink, gradient and Hessian are one element of its
    generalised derivative or not finite.
    """

    robot: "Robot"
    task: Task
    symbolic: SymbolicKinematics = field(init=False, repr=False)

    def __post_init__(self) -> None:
        if not isinstance(self.task, Task):
            raise InvalidInputError("task", self.task, "a Task, such as mp.Task.pose(length=0.5)")
        chain = SymbolicChain.of(self.robot.model, self.robot.tool)
        object.__setattr__(self, "symbolic", SymbolicKinematics(chain, self.task))

    def pose(self, q: ArrayLike) -> Array:
        """T_world_tool, (..., 4, 4)."""
        return self._evaluate(self.symbolic.pose, q, (4, 4))

    def jacobian(self, q: ArrayLike) -> Array:
        """Task Jacobian, (..., m, n) [m per rad or m]."""
        return self._evaluate(self.symbolic.jacobian, q, (self.task.rows, self.robot.n))

    def manipulability(self, q: ArrayLike) -> Array:
        """Yoshikawa index m, (...) [task.unit]; a scalar array for one q."""
        return self._evaluate(self.symbolic.manipulability, q, ())

    def gradient(self, q: ArrayLike) -> Array:
        """∇m, (..., n) [task.unit per rad or m]."""
        return self._evaluate(self.symbolic.gradient, q, (self.robot.n,))

    def hessian(self, q: ArrayLike) -> Array:
        """∇²m, exact, (..., n, n)."""
        return self._evaluate(self.symbolic.hessian, q, (self.robot.n, self.robot.n))

    def _evaluate(self, function: Callable[[ca.DM], ca.DM], q: ArrayLike, shape: tuple[int, ...]) -> Array:
        q = configurations("q", q, self.robot.n)
        batch = q.reshape(-1, self.robot.n)
        if len(batch) == 0:
            return np.empty((*q.shape[:-1], *shape))
        # CasADi evaluates all columns in one call and sets the results side by side.
        out = np.asarray(function(ca.DM(batch.T)))
        rows, columns = (*shape, 1, 1)[:2]
        out = out.reshape(rows, len(batch), columns).transpose(1, 0, 2)
        return np.array(out.reshape((*q.shape[:-1], *shape)))
