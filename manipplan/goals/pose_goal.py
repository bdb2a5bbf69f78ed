"""PoseGoal: a pose of the tool, or of a carried part, in which a motion ends, with what is free about it."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
import pinocchio as pin
from typing_extensions import TypeAliasType

from manipplan.paths.deviation import angles_between
from manipplan.paths.tolerance import Tolerance
from manipplan.robots.arms import known_tool
from manipplan.robots.model_tree import frame_pose
from manipplan.robots.robot import Robot
from manipplan.support.checks import COINCIDENT, Array, ArrayLike, finite_array, instance, pose_matrix
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError
from manipplan.symbolic.task import Task


@one_line
@dataclass(frozen=True, eq=False)
class PoseGoal:
    """A pose of the tool or of a carried part in the world, exact or with a free axis or a tolerance.

    Attributes:
        pose: (4, 4) or pin.SE3, in the world; kept as a read-only matrix.
        free_axis: (3,) axis of the tool, in the tool's frame, about which the tool may end at any angle; None: no such axis.
            With `of`, an axis of the part in its own frame, on which the tool's origin has to lie.
        tolerance: how far it may end from the pose [m, rad]; the angle is that of the rotation or, with a free axis, that
            between the axes. A tolerance without a rotation leaves the rotation free, and one without a position is no goal.
            None: exact.
        of: name of a part that the arm carries when it reaches the goal: the pose is that of the part's own frame. "": that of
            the tool.

    Raises InvalidInputError: not a rigid transform, an axis of zero length, or a tolerance without a position.
    """

    pose: ArrayLike | pin.SE3
    free_axis: ArrayLike | None = field(default=None, kw_only=True)
    tolerance: Tolerance | None = field(default=None, kw_only=True)
    of: str = field(default="", kw_only=True)

    def __post_init__(self) -> None:
        object.__setattr__(self, "pose", pose_matrix("pose", self.pose))
        if self.free_axis is not None:
            axis = finite_array("free_axis", self.free_axis, (3,))
            length = float(np.linalg.norm(axis))
            if length < 1e-9:
                raise InvalidInputError("free_axis", self.free_axis, "an axis (3,) that is not zero")
            axis = axis / length
            axis.flags.writeable = False
            object.__setattr__(self, "free_axis", axis)
        instance("of", self.of, str)
        if self.tolerance is not None and instance("tolerance", self.tolerance, Tolerance).position is None:
            raise InvalidInputError("tolerance", self.tolerance, "one with a position [m]: without it any place would do")

    @property
    def matrix(self) -> Array:
        """The pose as a matrix (4, 4)."""
        return np.asarray(self.pose)

    @property
    def axis(self) -> Array | None:
        """The free axis (3,), of unit length; None where there is none."""
        return None if self.free_axis is None else np.asarray(self.free_axis)

    @property
    def is_exact(self) -> bool:
        """Whether it is one pose of the tool."""
        return not self.of and self.free_axis is None and self.tolerance is None

    @property
    def allowed(self) -> tuple[float, float]:
        """Largest distance [m] and angle [rad] from the pose."""
        if self.tolerance is None:
            return 0.0, 0.0
        rotation = self.tolerance.rotation
        return self.tolerance.position or 0.0, np.pi if rotation is None else min(rotation, np.pi)

    def of_tool(self, grip: Array) -> "PoseGoal":
        """What this goal of a part is as one of the tool, where the part is at `grip` (4, 4) in the tool frame.

        Its tolerance allows nothing that the one of the part does not: turning the tool moves a part that is beside it.
        Raises InvalidInputError where the tool's origin is not on the free axis.
        """
        axis, tolerance = self.axis, self.tolerance
        beside = float(np.linalg.norm(grip[:3, 3]))
        if axis is not None:
            axis = grip[:3, :3] @ axis
            beside = float(np.linalg.norm(np.cross(grip[:3, 3], axis)))
            if beside > COINCIDENT:
                wanted = f"an axis on which the tool's origin lies: it is {1e3 * beside:.3g} mm beside that of {self.of}"
                raise InvalidInputError("free_axis", self.free_axis, f"{wanted}. Give a list of turned poses")
            beside = abs(float(grip[:3, 3] @ axis))
        if tolerance is not None:
            position, rotation = self.allowed
            if beside > 0:
                rotation = min(rotation, position / (2 * beside))
            tolerance = Tolerance(position=position - rotation * beside, rotation=rotation)
        return PoseGoal(self.matrix @ np.linalg.inv(grip), free_axis=axis, tolerance=tolerance)

    def task(self, robot: Robot) -> Task:
        """The task whose inverse kinematics reach the pose.

        Raises InvalidInputError where a planar arm cannot turn about the free axis.
        """
        instance("robot", robot, Robot)
        if self.axis is None:
            return Task.pose()
        if not robot.planar:
            return Task.pointing(self.axis)
        if abs(self.axis[2]) < 1 - COINCIDENT:
            raise InvalidInputError("free_axis", self.axis.tolist(), "the axis z: a planar arm turns its tool about no other")
        return Task.planar()

    def distances(self, poses: Array) -> tuple[Array, Array]:
        """Distances (k,) [m] and angles (k,) [rad] of poses (k, 4, 4) from this one; of the axes if one is free."""
        position = np.linalg.norm(poses[:, :3, 3] - self.matrix[:3, 3], axis=1)
        return position, angles_between(poses[:, :3, :3], self.matrix[:3, :3], self.axis)

    def errors(self, robot: Robot, q: Array, tool: str) -> tuple[float, float]:
        """Distance [m] and angle [rad] of a tool, or of a carried part, from the pose at q (n,), by Pinocchio."""
        q, tool = finite_array("q", q, (instance("robot", robot, Robot).n,)), known_tool(robot, "tool", tool)
        if self.of:
            part = robot.carried[self.of]
            place = frame_pose(robot.model, part.frame, q) @ part.solid.pose.homogeneous
        else:
            place = frame_pose(robot.model, tool, q)
        position, rotation = (float(each[0]) for each in self.distances(place[None]))
        return position, rotation

    def missed_by(self, robot: Robot, q: Array, tool: str | None = None) -> str:
        """How far a tool, by default the first, or the part miss the goal at q (n,); "" where it is reached."""
        position, rotation = self.errors(robot, q, instance("robot", robot, Robot).tool if tool is None else tool)
        most = self.allowed
        if position <= most[0] + COINCIDENT and rotation <= most[1] + COINCIDENT:
            return ""
        name = "the tool" if tool is None or len(robot.tools) == 1 else tool
        return f"{self.of or name} ends {1e3 * position:.3g} mm and {np.rad2deg(rotation):.2g}° from the pose of the goal"


#: One goal: (n,) [rad or m], the name of a state, a pose of the tool, a PoseGoal, or one of these two for several tools each.
OneGoal = TypeAliasType("OneGoal", ArrayLike | str | pin.SE3 | PoseGoal | Mapping[str, ArrayLike | pin.SE3 | PoseGoal])
#: A goal, or several, of which one is chosen.
Goal = TypeAliasType("Goal", OneGoal | Sequence[OneGoal])
