"""ToolFrame: the tool's pose and Jacobian in one call, and bounds on how fast both change."""

from dataclasses import dataclass

import casadi as ca
import numpy as np

from manipplan.kinematics.batch import NativeKernel, run_kernel, wanted_kernel
from manipplan.robots.arms import led_by
from manipplan.robots.model_tree import JointTree, frame_index
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.memo import once_per_owner
from manipplan.symbolic.backends import chain_of
from manipplan.symbolic.batch_function import BatchFunction

#: Number of entries of a pose: position and columns of the rotation.
POSE = 12


@dataclass(frozen=True, kw_only=True, eq=False)
class ToolFrame:
    """The tool of an arm.

    Attributes:
        function: POSE + 6 n numbers of q (n,): position, columns of the rotation, then linear and angular part of the Jacobian
            of each joint, in the world's axes.
        kernel: its machine code for batches; None where there is no compiler.
        batch: the function on arrays, for that case.
        tree: the arm's N joints.
        turns, slides: (N,) whether a joint carries the tool and is revolute, or prismatic; 1 or 0.
        lengths: (N + 1,) distances from the origin of the joint before to that of each joint, and of the tool [m].
    """

    function: ca.Function
    kernel: NativeKernel | None
    batch: BatchFunction
    tree: JointTree
    turns: Array
    slides: Array
    lengths: Array

    def at(self, q: Array) -> tuple[Array, Array]:
        """Poses (m, POSE) and Jacobians (m, n, 6) at configurations (m, n)."""
        n, q = q.shape[1], np.ascontiguousarray(q, dtype=float)
        found = None if self.kernel is None else run_kernel(self.kernel, q, POSE + 6 * n, threads=1)
        found = self.batch.by_columns(q) if found is None else found
        return found[:, :POSE], found[:, POSE:].reshape(-1, n, 6)

    def bend(self, q: Array, speed: Array, acceleration: Array) -> tuple[Array, Array]:
        """Upper bounds (m,) on |u''| of any unit vector u that the tool carries, and on |p''| of its position [m].

        For absolute joint values, speeds and accelerations of at most `q`, `speed` and `acceleration` (m, n). Of joints i <= j,
        in their order from the base, ∂²u = z_i x (z_j x u), and ∂²p = z_i x ∂_j p, which is 0 where i is prismatic.
        """
        tree = self.tree
        q, speed, acceleration = tree.sizes(q) + np.abs(tree.offset), tree.sizes(speed), tree.sizes(acceleration)
        # from the origin of each joint to that of the tool, at most
        far = self.lengths[-1] + np.cumsum((self.lengths[:-1] + self.slides * q)[:, ::-1], axis=1)[:, ::-1]
        far = np.hstack([far[:, 1:], np.full((len(q), 1), self.lengths[-1])])
        reach = self.turns * far + self.slides
        turning = speed * self.turns
        unit = turning.sum(axis=1) ** 2 + (acceleration * self.turns).sum(axis=1)
        # Σ_j (2 Σ_{i<j} turning_i + turning_j) speed_j reach_j
        before = 2 * np.cumsum(turning, axis=1) - turning
        position = (before * speed * reach).sum(axis=1) + (acceleration * reach).sum(axis=1)
        return unit, position


@once_per_owner
def tool_frame(robot: Robot, tool: str) -> ToolFrame:
    """One tool of a robot."""
    robot = led_by(robot, tool)
    chain = chain_of(robot, "auto")
    pose = ca.vertcat(chain.tool.origin, ca.reshape(chain.tool.rotation, 9, 1))
    values = ca.vertcat(pose, ca.reshape(chain.jacobian, 6 * robot.n, 1))
    function = ca.Function("tool_frame", [chain.q], [ca.densify(values)], ["q"], ["values"])
    model = robot.model
    frame = model.frames[frame_index(model, robot.tool)]
    turns, slides, lengths = np.zeros(model.njoints - 1), np.zeros(model.njoints - 1), np.zeros(model.njoints)
    lengths[-1] = np.linalg.norm(frame.placement.translation)
    for i in model.supports[frame.parentJoint]:
        if i > 0:
            (slides if chain.tree.slides[i - 1] else turns)[i - 1] = 1.0
            lengths[i - 1] = np.linalg.norm(model.jointPlacements[i].translation)
    return ToolFrame(
        function=function,
        kernel=wanted_kernel(function, "auto", f"{tool} of {robot.name}, in batches"),
        batch=BatchFunction(function),
        tree=chain.tree,
        turns=turns,
        slides=slides,
        lengths=lengths,
    )
