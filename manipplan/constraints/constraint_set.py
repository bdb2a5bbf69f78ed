"""ConstraintSet: the constraints of one motion, evaluated for a robot."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from manipplan.constraints.constraint import KEPT, Constraint, SymbolicPose, constraint_tuple
from manipplan.constraints.held import HeldJoints
from manipplan.constraints.tilt import TiltLimit, contradiction
from manipplan.constraints.tool_frame import POSE, ToolFrame, tool_frame
from manipplan.robots.arms import led_by
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError
from manipplan.support.expressions import making_expressions
from manipplan.symbolic.backends import chain_of
from manipplan.symbolic.batch_function import BatchFunction

#: Held joints whose values differ by no more than this are the same [rad or m].
SAME = 1e-9


@dataclass(frozen=True, kw_only=True, eq=False)
class OwnRows:
    """Rows of constraints of a user's class: values (r), and values with gradients and Hessians, as functions of q."""

    count: int
    value: BatchFunction
    gradient: BatchFunction
    hessian: BatchFunction

    @classmethod
    @making_expressions()
    def of(cls, robot: Robot, constraints: Sequence[Constraint]) -> tuple["OwnRows", list[int]]:
        """The rows of all of them, and the number of rows of each; raises InvalidInputError for anything but a column."""
        chain = chain_of(robot, "auto")
        columns = []
        for each in constraints:
            made = each.rows(_symbolic_pose(robot, each.of_tool or robot.tool))
            if not isinstance(made, ca.SX) or made.shape[1] != 1 or not made.shape[0]:
                raise InvalidInputError("constraints", each.name, "constraints whose rows are a ca.SX (r, 1), r at least 1")
            if set(_names(ca.symvar(made))) - set(_names(ca.symvar(chain.q))):
                raise InvalidInputError("constraints", each.name, "rows of the symbols q, position and rotation alone")
            columns.append(ca.densify(made))
        rows = ca.vertcat(*columns)
        jacobian = ca.densify(ca.jacobian(rows, chain.q))
        second = [ca.reshape(ca.densify(ca.hessian(rows[k], chain.q)[0]), robot.n**2, 1) for k in range(rows.shape[0])]
        made = [rows, ca.reshape(jacobian.T, rows.shape[0] * robot.n, 1), ca.vertcat(*second)]
        value, gradient, hessian = (
            BatchFunction(ca.Function(f"own_{name}", [chain.q], [ca.densify(each)]))
            for name, each in zip(("rows", "gradients", "hessians"), made, strict=True)
        )
        own = cls(count=rows.shape[0], value=value, gradient=gradient, hessian=hessian)
        return own, [each.shape[0] for each in columns]


@dataclass(frozen=True, kw_only=True, eq=False)
class ConstraintSet:
    """The constraints of one motion: rows of the tool's pose first, then those of a user's classes, and the held joints.

    Attributes:
        robot: the arm.
        constraints: all of them.
        owners: (r,) index of the constraint of each row.
        weights: (t, 13) the rows of the tool's pose, as `Constraint.tool_rows`; those of other tools are among `own`.
        tool: the pose and Jacobian of the first tool that a constraint is about.
        own: the other rows; None for none.
        held: (n,) whether a joint is held.
    """

    robot: Robot
    constraints: tuple[Constraint, ...]
    owners: NDArray[np.intp]
    weights: Array
    tool: ToolFrame | None
    own: OwnRows | None
    held: NDArray[np.bool_]

    @classmethod
    def of(cls, robot: Robot, constraints: Sequence[Constraint]) -> "ConstraintSet":
        """The set; raises InvalidInputError for what is no constraint, does not fit the robot, or contradicts another one."""
        given, held = constraint_tuple(constraints), np.zeros(robot.n, dtype=bool)
        weights, tool_owners, others, other_owners = [np.empty((0, 13))], [], [], []
        tool = None
        for k, each in enumerate(given):
            each.check(robot)
            of_tool = each.tool_rows()
            if of_tool is not None:
                tool = tool or each.of_tool or robot.tool
            if isinstance(each, HeldJoints):
                held |= each.mask(robot)
            elif of_tool is not None and (each.of_tool or robot.tool) == tool:
                weights.append(of_tool)
                tool_owners += [k] * len(of_tool)
            else:
                others.append(each)
                other_owners.append(k)
        if held.all():
            raise InvalidInputError("constraints", "all joints held", "constraints that leave a joint to move")
        _check_contradictions(robot, given)
        own, counts = OwnRows.of(robot, others) if others else (None, [])
        return cls(
            robot=robot,
            constraints=given,
            owners=np.array(tool_owners + list(np.repeat(other_owners, counts)), dtype=np.intp),
            weights=np.vstack(weights),
            tool=tool_frame(robot, tool) if tool is not None else None,
            own=own,
            held=held,
        )

    def __reduce__(self) -> tuple[Callable[..., Any], tuple[Any, ...]]:
        return ConstraintSet.of, (self.robot, self.constraints)

    @property
    def count(self) -> int:
        """Number of rows."""
        return len(self.owners)

    def values(self, q: Array) -> Array:
        """The rows (m, r) at configurations (m, n)."""
        parts = []
        if self.tool is not None:
            pose, _ = self.tool.at(q)
            parts.append(pose @ self.weights[:, :POSE].T + self.weights[:, POSE])
        if self.own is not None:
            parts.append(self.own.value.by_columns(q))
        return np.hstack(parts) if parts else np.empty((len(q), 0))

    def gradients(self, q: Array) -> Array:
        """Their gradients (m, r, n)."""
        parts = []
        if self.tool is not None:
            pose, jacobian = self.tool.at(q)
            linear, angular = jacobian[:, :, :3], jacobian[:, :, 3:]
            vectors = pose[:, 3:].reshape(-1, 1, 3, 3)  # column k of the rotation in row k
            turned = np.cross(angular[:, :, None], vectors)  # (m, n, 3, 3)
            moved = np.concatenate([linear, turned.reshape(len(q), self.robot.n, 9)], axis=2)
            parts.append(np.swapaxes(moved @ self.weights[:, :POSE].T, 1, 2))
        if self.own is not None:
            parts.append(self.own.gradient.by_columns(q).reshape(len(q), self.own.count, self.robot.n))
        return np.concatenate(parts, axis=1) if parts else np.empty((len(q), 0, self.robot.n))

    def hessians(self, q: Array, rows: NDArray[np.intp]) -> Array:
        """The Hessians (m, n, n) of one row (m,) at each configuration (m, n)."""
        n, tool_rows = self.robot.n, len(self.weights)
        found = np.empty((len(q), n, n))
        of_tool = rows < tool_rows
        if of_tool.any():
            assert self.tool is not None
            pose, jacobian = self.tool.at(q[of_tool])
            linear, angular, weights = jacobian[:, :, :3], jacobian[:, :, 3:], self.weights[rows[of_tool]]
            turned = np.cross(angular[:, :, None], pose[:, 3:].reshape(-1, 1, 3, 3))  # z_j x R_k
            once = np.cross(angular[:, :, None, None], turned[:, None])  # z_i x (z_j x R_k), (m, i, j, k, 3)
            moved = np.cross(angular[:, :, None], linear[:, None])  # z_i x ∂_j p, (m, i, j, 3)
            both = np.einsum("mijkc,mkc->mij", once, weights[:, 3:POSE].reshape(-1, 3, 3))
            both += np.einsum("mijc,mc->mij", moved, weights[:, :3])
            upper = np.triu(both)  # of joints i <= j
            found[of_tool] = upper + np.swapaxes(np.triu(both, 1), 1, 2)
        if not of_tool.all():
            assert self.own is not None
            at = q[~of_tool]
            every = self.own.hessian.by_columns(at).reshape(len(at), self.own.count, n, n)
            found[~of_tool] = every[np.arange(len(at)), rows[~of_tool] - tool_rows]
        return found

    def broken(self, q: Array) -> str:
        """Which constraint a configuration (n,) breaks, and how; "" for none. Held joints do not count."""
        for k, value in enumerate(self.worst(self.values(q[None]))):
            if value < -KEPT:
                return f"{self.constraints[k].name}: {self.constraints[k].figure(float(value))}"
        return ""

    def worst(self, values: Array) -> Array:
        """The smallest value of each constraint (c,) among rows (m, r); inf for held joints."""
        smallest = np.full(len(self.constraints), np.inf)
        np.minimum.at(smallest, self.owners, values.min(axis=0))
        return smallest

    def moved(self, start: Array, q: Array) -> str:
        """Which held joints differ between start and q (n,), and by how much; "" for none."""
        off = np.where(self.held, np.abs(q - start), 0.0)
        if off.max() <= SAME:
            return ""
        joint = int(off.argmax())
        return f"{self.robot.joint_names[joint]} is held, and differs by {off[joint]:.4g} from the start"


@making_expressions()
def _symbolic_pose(robot: Robot, tool: str) -> SymbolicPose:
    """The pose of one tool at the symbols of the robot's chain."""
    chain, own = chain_of(robot, "auto"), chain_of(led_by(robot, tool), "auto")
    made = ca.Function("pose", [own.q], [own.tool.origin, own.tool.rotation])
    position, rotation = made.call([chain.q], True, False)
    return SymbolicPose(q=chain.q, position=position, rotation=rotation)


def _check_contradictions(robot: Robot, constraints: Sequence[Constraint]) -> None:
    """Raise InvalidInputError for two tilt limits that no rotation keeps."""
    tilts = [(k, each) for k, each in enumerate(constraints) if isinstance(each, TiltLimit)]
    for i, (k, one) in enumerate(tilts):
        for j, other in tilts[i + 1 :]:
            if (one.tool or robot.tool) == (other.tool or robot.tool) and contradiction(one, other):
                wanted = f"one that can be kept together with constraints[{k}]: {one.name}"
                raise InvalidInputError(f"constraints[{j}]", other.name, wanted)


def _names(symbols: Sequence[ca.SX]) -> list[int]:
    return [each.element_hash() for each in symbols]
