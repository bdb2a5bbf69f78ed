"""The symbolic chain: a Pinocchio model of plain angles as CasADi SX expressions.

Symbols: R, p rotation (3, 3) and origin (3,) of a frame in the world; S_i = (v_i, w_i) the i-th joint's motion.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import ClassVar

import casadi as ca
import numpy as np
import pinocchio as pin

from manipplan.robots.model_tree import JointTree, frame_index, joint_tree
from manipplan.support.checks import Array


@dataclass(frozen=True, kw_only=True)
class Placement:
    """A frame in the world: rotation (3, 3) and origin (3,), symbolic."""

    rotation: ca.SX
    origin: ca.SX

    def __matmul__(self, other: "Placement") -> "Placement":
        return Placement(rotation=self.rotation @ other.rotation, origin=self.origin + self.rotation @ other.origin)

    def inverse(self) -> "Placement":
        """The world in this frame."""
        return Placement(rotation=self.rotation.T, origin=-(self.rotation.T @ self.origin))

    def matrix(self) -> ca.SX:
        """The homogeneous matrix (4, 4)."""
        return ca.vertcat(ca.horzcat(self.rotation, self.origin), ca.DM([[0.0, 0.0, 0.0, 1.0]]))


@dataclass(frozen=True, kw_only=True, eq=False)
class SymbolicChain:
    """The arm at symbolic q (n,): every joint's frame, the tool frame, the tool's Jacobian, the arm's inertia.

    Attributes:
        model: the Pinocchio model of the arm.
        tree: its N >= n joints, some of which may follow others.
        frame: Pinocchio's description of the tool frame.
        q: (n, 1) symbols [rad or m].
        joints: N + 1 placements in the world; the first is the world itself, as in Pinocchio.
        tool: placement of the tool frame.
        jacobian: (6, n) LOCAL_WORLD_ALIGNED Jacobian of the tool, linear rows [m/rad] first.
        own: whether the expressions are our own, so that they can also be built in other frames.
    """

    own: ClassVar[bool] = True
    model: pin.Model
    tree: JointTree
    frame: pin.Frame
    q: ca.SX
    joints: tuple[Placement, ...]
    tool: Placement
    jacobian: ca.SX

    @classmethod
    def of(cls, model: pin.Model, tool: str) -> "SymbolicChain":
        """Build the chain of `model`, whose joints are revolute (plain angle) or prismatic."""
        q, tree = ca.SX.sym("q", model.nv), joint_tree(model)
        placements = [WORLD]
        for i in range(1, model.njoints):
            placements.append(placements[model.parents[i]] @ step(tree, i, q))
        frame = model.frames[frame_index(model, tool)]
        end = placements[frame.parentJoint] @ constant(frame.placement)
        carriers = carriers_of(tree, frame.parentJoint, placements)
        jacobian = jacobian_of(tree, carriers, end.origin)
        return cls(model=model, tree=tree, frame=frame, q=q, joints=tuple(placements), tool=end, jacobian=jacobian)

    def carriers(self, joint: int) -> list[Placement | None]:
        """The placements of the joints that carry one joint, None for the others."""
        return carriers_of(self.tree, joint, self.joints)

    @cached_property
    def alone(self) -> "SymbolicChain":
        """The same chain as if no joint followed another: its Jacobian (6, N) has a column for each joint."""
        tree = self.tree.alone()
        jacobian = jacobian_of(tree, self.carriers(self.frame.parentJoint), self.tool.origin)
        return replace(self, tree=tree, jacobian=jacobian)

    @cached_property
    def mass_matrix(self) -> ca.SX:
        """M(q), (n, n), with the rotors' inertia (armature): the sum of Jᵀ I J over the bodies."""
        model = self.model
        matrix = ca.diag(_sparse(model.armature))
        for i in range(1, model.njoints):
            inertia, body = model.inertias[i], self.joints[i]
            centre = body.origin + body.rotation @ _sparse(inertia.lever)
            jacobian = jacobian_of(self.tree, self.carriers(i), centre)
            spin = body.rotation.T @ jacobian[3:, :]
            matrix += inertia.mass * (jacobian[:3, :].T @ jacobian[:3, :]) + spin.T @ _sparse(inertia.inertia) @ spin
        return matrix


WORLD = Placement(rotation=ca.SX.eye(3), origin=ca.SX(3, 1))


def step(tree: JointTree, i: int, q: ca.SX) -> Placement:
    """Placement of joint i of the tree, moved by q (n,), relative to the joint before it."""
    fixed = tree.fixed[i - 1]
    position = q[int(tree.leader[i - 1])]
    if tree.has_followers:
        position = float(tree.ratio[i - 1]) * position + float(tree.offset[i - 1])
    placement = Placement(rotation=_sparse(fixed[:9].reshape(3, 3)), origin=_sparse(fixed[9:]))
    return placement @ _joint_motion(tree.axes[i - 1], bool(tree.slides[i - 1]), position)


def carriers_of(tree: JointTree, joint: int, placements: Sequence[Placement]) -> list[Placement | None]:
    """Of the placements of the world and of all joints those of the joints that carry one joint, None for the others."""
    return [placements[i] if tree.carries[joint, i] else None for i in range(1, len(placements))]


def jacobian_of(tree: JointTree, carriers: Sequence[Placement | None], point: ca.SX) -> ca.SX:
    """Jacobian (6, n) of a point; `carriers` are the placements of the joints, None for those that do not carry it."""
    columns = [ca.SX(6, 1)] * tree.leads
    for i, joint in enumerate(carriers):
        if joint is None:
            continue
        axis = joint.rotation @ _sparse(tree.axes[i])
        moved = (axis, ca.SX(3, 1)) if tree.slides[i] else (ca.cross(axis, point - joint.origin), axis)
        columns[tree.leader[i]] += float(tree.ratio[i]) * ca.vertcat(*moved)
    return ca.horzcat(*columns)


def _joint_motion(axis: Array, slides: bool, q: ca.SX) -> Placement:
    if slides:
        return Placement(rotation=ca.SX.eye(3), origin=_sparse(axis) * q)
    # Rodrigues: R = a aᵀ + cos q (I - a aᵀ) + sin q [a]x
    outer = np.outer(axis, axis)
    cross = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    rotation = _sparse(outer) + ca.cos(q) * _sparse(np.eye(3) - outer) + ca.sin(q) * _sparse(cross)
    return Placement(rotation=rotation, origin=ca.SX.zeros(3))


def constant(placement: pin.SE3) -> Placement:
    """A placement that does not depend on q."""
    return Placement(rotation=_sparse(placement.rotation), origin=_sparse(placement.translation))


def _sparse(array: Array) -> ca.SX:
    """Constants as sparse SX; a value within 1e-14 of 0, 1 or -1 becomes exactly that, which removes rounding errors."""
    nearest = np.round(array)
    snapped = np.where((np.abs(array - nearest) < 1e-14) & (np.abs(nearest) <= 1), nearest, array)
    return ca.SX(ca.sparsify(ca.DM(snapped)))
