"""The symbolic chain: a Pinocchio model of plain angles as CasADi SX expressions.

Symbols: R, p rotation (3, 3) and origin (3,) of a frame in the world; S_i = (v_i, w_i) the i-th joint's motion.
"""

from dataclasses import dataclass

import casadi as ca
import numpy as np
import pinocchio as pin

from manipplan.checks import Array
from manipplan.robots.description import axis_of, frame_index, is_prismatic


@dataclass(frozen=True, kw_only=True)
class Placement:
    """A frame in the world: rotation (3, 3) and origin (3,), symbolic."""

    rotation: ca.SX
    origin: ca.SX

    def __matmul__(self, other: "Placement") -> "Placement":
        return Placement(
            rotation=self.rotation @ other.rotation,
            origin=self.origin + self.rotation @ other.origin,
        )

    def matrix(self) -> ca.SX:
        """The homogeneous matrix (4, 4)."""
        return ca.vertcat(ca.horzcat(self.rotation, self.origin), ca.DM([[0.0, 0.0, 0.0, 1.0]]))


@dataclass(frozen=True, kw_only=True)
class SymbolicChain:
    """The arm at symbolic q (n,): every joint's frame, the tool frame, and the tool's Jacobian.

    Attributes:
        q: (n, 1) symbols [rad or m].
        joints: n + 1 placements in the world; the first is the world itself, as in Pinocchio.
        tool: placement of the tool frame.
        jacobian: (6, n) LOCAL_WORLD_ALIGNED Jacobian of the tool, linear rows [m/rad] first.
    """

    q: ca.SX
    joints: tuple[Placement, ...]
    tool: Placement
    jacobian: ca.SX

    @classmethod
    def of(cls, model: pin.Model, tool: str) -> "SymbolicChain":
        """Build the chain of `model`, whose joints are revolute (plain angle) or prismatic."""
        q = ca.SX.sym("q", model.nv)
        placements = [Placement(rotation=ca.SX.eye(3), origin=ca.SX.zeros(3))]
        for i in range(1, model.njoints):
            before = placements[model.parents[i]] @ _constant(model.jointPlacements[i])
            placements.append(before @ _joint_motion(model.joints[i], q[i - 1]))
        frame = model.frames[frame_index(model, tool)]
        end = placements[frame.parentJoint] @ _constant(frame.placement)
        supports = set(model.supports[frame.parentJoint])
        columns = []
        for i in range(1, model.njoints):
            if i not in supports:
                columns.append(ca.SX.zeros(6))
                continue
            axis = placements[i].rotation @ _sparse(axis_of(model.joints[i]))
            if is_prismatic(model.joints[i]):
                columns.append(ca.vertcat(axis, ca.SX.zeros(3)))
            else:
                columns.append(ca.vertcat(ca.cross(axis, end.origin - placements[i].origin), axis))
        return cls(q=q, joints=tuple(placements), tool=end, jacobian=ca.horzcat(*columns))


def _joint_motion(joint: pin.JointModel, q: ca.SX) -> Placement:
    axis = axis_of(joint)
    if is_prismatic(joint):
        return Placement(rotation=ca.SX.eye(3), origin=_sparse(axis) * q)
    # Rodrigues: R = a aᵀ + cos q (I - a aᵀ) + sin q [a]x
    outer = np.outer(axis, axis)
    cross = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    rotation = _sparse(outer) + ca.cos(q) * _sparse(np.eye(3) - outer) + ca.sin(q) * _sparse(cross)
    return Placement(rotation=rotation, origin=ca.SX.zeros(3))


def _constant(placement: pin.SE3) -> Placement:
    return Placement(rotation=_sparse(placement.rotation), origin=_sparse(placement.translation))


def _sparse(array: Array) -> ca.SX:
    """Constants as sparse SX; what rounding left within 1e-14 of 0, 1 or -1 becomes exactly that."""
    nearest = np.round(array)
    snapped = np.where((np.abs(array - nearest) < 1e-14) & (np.abs(nearest) <= 1), nearest, array)
    return ca.SX(ca.sparsify(ca.DM(snapped)))
