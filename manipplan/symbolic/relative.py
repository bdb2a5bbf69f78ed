"""The tool seen from another frame of the robot: its placement there, and the Jacobian of its motion relative to that frame.

Symbols: R, p rotation and origin of the reference frame in the world; v, ω velocity and angular velocity of a frame.
"""

from dataclasses import dataclass

import casadi as ca
import pinocchio as pin

from manipplan.robots.model_tree import frame_index
from manipplan.symbolic.chain import Placement, SymbolicChain, constant, jacobian_of
from manipplan.symbolic.motion import LedMotion, MatrixMotion, Motion, TaskMotion
from manipplan.symbolic.task import Task


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
