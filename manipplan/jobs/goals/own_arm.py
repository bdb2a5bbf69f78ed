"""OwnArm: the joints that move one tool alone, and their solutions for its goal with the other joints at given values."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.jobs.goals.pose_goal import PoseGoal
from manipplan.jobs.goals.reach import nearest
from manipplan.jobs.goals.samples import reaching
from manipplan.robots.arms import arm_of, own_joints, shared_joints
from manipplan.robots.configuration import nearest_turns
from manipplan.robots.model_tree import frame_index
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError
from manipplan.support.memo import once_per_owner


@dataclass(frozen=True, kw_only=True, eq=False)
class OwnArm:
    """The joints that move one tool alone, as an arm whose other joints are locked at the robot's neutral posture.

    Attributes:
        arm: the arm.
        joints: indices of its joints.
        carrier: index in the model of the last joint before those of the arm alone; 0: the world.
        home: (4, 4) place of that joint in the neutral posture.
    """

    arm: Robot
    joints: tuple[int, ...]
    carrier: int
    home: Array

    def seen(self, robot: Robot, goal: PoseGoal, q: Array, data: pin.Data) -> PoseGoal:
        """The tool's goal where the arm has to reach with the shared joints at their neutral posture instead of at q (n,)."""
        if self.carrier == 0:
            return goal
        pin.forwardKinematics(robot.model, data, q)
        return replace(goal, pose=self.home @ np.linalg.inv(data.oMi[self.carrier].homogeneous) @ goal.matrix)


@dataclass(frozen=True, kw_only=True, eq=False)
class OfTool:
    """Configurations q (k, n) in which one tool reaches its goal, each with the shared joints of place number `place` (k,)."""

    q: Array
    place: NDArray[np.int64]

    def rows(self, kept: NDArray[np.int64] | NDArray[np.bool_]) -> "OfTool":
        """These rows only."""
        return OfTool(q=self.q[kept], place=self.place[kept])

    def with_more(self, other: "OfTool") -> "OfTool":
        """These rows, then those of another set."""
        return OfTool(q=np.vstack([self.q, other.q]), place=np.concatenate([self.place, other.place]))

    def at(self, place: int) -> "OfTool":
        """Those of one place."""
        return self.rows(self.place == place)


@once_per_owner
def own_arms(robot: Robot) -> Mapping[str, OwnArm]:
    """The arm of each tool without the joints that it shares."""
    shared, data, found = set(shared_joints(robot)), robot.model.createData(), {}
    pin.forwardKinematics(robot.model, data, np.asarray(robot.neutral))
    for tool in robot.tools:
        joints = own_joints(robot, tool)
        joint = robot.model.frames[frame_index(robot.model, tool)].parentJoint
        chain = [int(i) for i in robot.model.supports[joint]]  # the first is the world
        common = [i for i in chain if i == 0 or robot.model.joints[i].idx_q in shared]
        if common != chain[: len(common)]:
            last = robot.model.names[common[-1]]
            wanted = f"a robot whose joints that move several tools come before those of each arm, unlike {last}"
            raise InvalidInputError("robot", robot.name, wanted)
        carrier = common[-1]
        arm = arm_of(robot, tool, joints, robot.neutral)
        found[tool] = OwnArm(arm=arm, joints=tuple(joints), carrier=carrier, home=data.oMi[carrier].homogeneous)
    return found


def solutions(
    robot: Robot,
    tool: str,
    goal: PoseGoal,
    places: Array,
    start: Array,
    held: NDArray[np.bool_],
    *,
    by_steps: bool = False,
) -> OfTool:
    """The solutions of a tool's own arm with the shared joints as in each of the places (p, n); others as there.

    They are those of inverse kinematics, nearest to start (n,). With `by_steps`, solutions found by damped steps are added.
    Where joints of the arm are held, only these are returned.
    """
    own = own_arms(robot)[tool]
    joints, near = list(own.joints), start[list(own.joints)]
    data = robot.model.createData()
    goals = [own.seen(robot, goal, each, data) for each in places]
    q, place = np.zeros((0, len(joints))), np.zeros(0, dtype=np.int64)
    if not held[joints].any():
        found = reaching(own.arm, dict(enumerate(goals)), near)
        q, place = found.q, found.goals
    if by_steps or held[joints].any():
        stepped = [each.reaching for each in nearest(own.arm, goals, near, held[joints])]
        q = np.concatenate([q, *stepped])
        place = np.concatenate([place, np.repeat(np.arange(len(places)), [len(each) for each in stepped])])
    whole = places[place]
    whole[:, joints] = nearest_turns(own.arm, q, near)
    return OfTool(q=whole, place=place)
