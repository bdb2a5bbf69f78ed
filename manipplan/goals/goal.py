"""PoseGoal: a pose of the tool, or of a carried part, in which a motion ends, with what is free about it.

Reads start and goal in every form that a user may give, from a YAML file and from the words of a shell, too.
"""

import numbers
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np
import pinocchio as pin
from typing_extensions import TypeAliasType

from manipplan.paths.deviation import angles_between
from manipplan.paths.tolerance import Tolerance
from manipplan.robots.arms import known_tool
from manipplan.robots.attached import check_in_hand
from manipplan.robots.limits import TakenToLimit, nearest_turns, taken_to_limits, to_limits
from manipplan.robots.model_tree import frame_pose
from manipplan.robots.robot import Robot
from manipplan.support.checks import (
    COINCIDENT,
    Array,
    ArrayLike,
    configurations,
    existing_file,
    finite_array,
    instance,
    pose_matrix,
    read_only,
    rotation_matrix,
    unit_quaternion,
)
from manipplan.support.data_files import read_yaml
from manipplan.support.display import one_line
from manipplan.support.errors import FileFormatError, InvalidInputError, UnknownNameError, inside
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
            object.__setattr__(self, "free_axis", read_only(axis / length))
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


#: The forms of a goal, for messages.
FORMS = (
    "a configuration (n,), the name of a state, a pose (4, 4) or pin.SE3, a PoseGoal, a mapping from tools to poses, or a list "
    "of these"
)


@dataclass(frozen=True, kw_only=True, eq=False)
class Target:
    """One goal: a configuration, a pose, or a pose of each of several tools.

    Attributes:
        argument: what messages call it, such as goal[3].
        q: (n,) [rad or m], outside the limits only by more than the robot's tolerance; None for a pose.
        pose: the pose of an arm with one tool; None otherwise.
        tools: the pose of each tool that has one, of a robot with several; None otherwise.
        given: (n,) the configuration as it was given; None for a pose.
        taken: the joints that were taken to a limit.
        turns: whether full turns of a configuration reach the goal as well, also of joints with limits.
    """

    argument: str
    q: Array | None = None
    pose: PoseGoal | None = None
    tools: Mapping[str, PoseGoal] | None = None
    given: Array | None = None
    taken: tuple[TakenToLimit, ...] = ()
    turns: bool = False

    @classmethod
    def of_configuration(cls, argument: str, q: Array, robot: Robot) -> "Target":
        """The goal of a configuration (n,), taken to the limits."""
        taken = taken_to_limits(robot, argument, q)
        return cls(argument=argument, q=to_limits(robot, argument, q), given=q, taken=taken)

    def nearest(self, robot: Robot, start: Array) -> "Target":
        """The same goal; each joint of a configuration is turned to the nearest to start (n,) inside the limits."""
        return self if self.q is None else replace(self, q=nearest_turns(robot, self.q[None], start)[0])

    @property
    def goal(self) -> OneGoal:
        """The goal as a user may give it."""
        if self.given is not None:
            return self.given
        return self.pose if self.pose is not None else dict(self.tools or {})

    def of_tool(self, robot: Robot) -> "Target":
        """The goal as one of the tool; raises as `check_in_hand` where it is one of a part that the tool does not carry."""
        if self.pose is None or not self.pose.of:
            return self
        hands = {name: part.frame for name, part in robot.carried.items()}
        check_in_hand(f"{self.argument}.of", self.pose.of, hands, robot.tool)
        return self.with_grip(robot.carried[self.pose.of].solid.pose.homogeneous)

    def with_grip(self, grip: Array) -> "Target":
        """The goal of the tool that this one of a part is, with the part at `grip` (4, 4) in the tool frame."""
        assert self.pose is not None
        with inside(self.argument):
            return Target(argument=self.argument, pose=self.pose.of_tool(grip))

    def missed_by(self, robot: Robot, q: Array) -> str:
        """How far q (n,) is from the goal, up to full turns of joints without limits; "" where it is reached."""
        if self.pose is not None:
            return self.pose.missed_by(robot, q)
        if self.tools is not None:
            return "; ".join(filter(None, (pose.missed_by(robot, q, tool) for tool, pose in self.tools.items())))
        assert self.q is not None
        off = q - self.q
        off = np.abs(
            np.where(robot.turns if self.turns else robot.continuous_joints, off - 2 * np.pi * np.round(off / (2 * np.pi)), off)
        )
        joint = int(off.argmax())
        return "" if off[joint] <= COINCIDENT else f"{robot.joint_names[joint]} ends {off[joint]:.3g} from the goal"


def read_goals(argument: str, goal: Any, robot: Robot) -> tuple[tuple[Target, ...], bool]:
    """The goals of one argument, and whether they were given as a list.

    Raises InvalidInputError, which names the entry of the list, for what is no goal, and UnknownNameError for no state's name.
    """
    if not isinstance(goal, list | tuple) and not (isinstance(goal, np.ndarray) and goal.ndim == 3):
        return (read_goal(argument, goal, robot),), False
    if len(goal) == 0:
        raise InvalidInputError(argument, goal, f"at least one goal: {FORMS}")
    if _is_configuration(goal) or (isinstance(goal, list | tuple) and _is_pose(goal, robot.n)):
        return (read_goal(argument, goal, robot),), False
    return tuple(read_goal(f"{argument}[{k}]", each, robot) for k, each in enumerate(goal)), True


def read_goal(argument: str, goal: Any, robot: Robot) -> Target:
    """One goal; raises as `read_goals`."""
    if isinstance(goal, Mapping):
        return _read_tools(argument, goal, robot)
    if isinstance(goal, str):
        return Target.of_configuration(argument, read_configuration(argument, goal, robot), robot)
    pose = _read_pose(argument, goal, robot)
    if pose is not None:
        if len(robot.tools) > 1:
            each = ", ".join(f"{tool!r}: pose" for tool in robot.tools)
            raise InvalidInputError(argument, "one pose", f"which tool reaches it, as {{{each}}}; one of them alone will do")
        return Target(argument=argument, pose=pose)
    if not isinstance(goal, list | tuple | np.ndarray):
        raise InvalidInputError(argument, goal, FORMS)
    if getattr(goal, "ndim", 1) == 1 and len(goal) in (3, 6, 7) and len(goal) != robot.n and _is_configuration(goal):
        as_pose = "a pose of the tool as a (4, 4) matrix or pin.SE3"
        wanted = f"one value per joint, shape ({robot.n},), or {as_pose}, not {len(goal)} numbers"
        raise InvalidInputError(argument, goal, wanted)
    return Target.of_configuration(argument, _one_configuration(argument, goal, robot), robot)


def _read_tools(argument: str, goal: Mapping[Any, Any], robot: Robot) -> Target:
    """A goal of one tool or several."""
    if not goal:
        raise InvalidInputError(argument, goal, f"a pose for at least one of the tools {', '.join(robot.tools)}")
    poses = {}
    for tool, given in goal.items():
        if tool in robot.joint_names:
            wanted = f"poses by tool ({', '.join(robot.tools)}); a configuration is one value per joint, shape ({robot.n},)"
            raise InvalidInputError(argument, goal, wanted)
        name = f"{argument}[{tool!r}]"
        pose = _read_pose(name, given, robot.arm(known_tool(robot, argument, tool)))
        if pose is None:
            raise InvalidInputError(name, given, "a pose (4, 4) or pin.SE3, or a PoseGoal")
        if pose.of and len(robot.tools) > 1:
            raise InvalidInputError(f"{name}.of", pose.of, "'': in a goal of several tools each pose is that of a tool")
        poses[tool] = pose
    return Target(argument=argument, tools=poses) if len(robot.tools) > 1 else Target(argument=argument, pose=poses[robot.tool])


def _read_pose(argument: str, goal: Any, arm: Robot) -> PoseGoal | None:
    """A pose of the tool of an arm; None where the goal is no pose."""
    if isinstance(goal, PoseGoal):
        if goal.axis is not None:
            with inside(argument):
                goal.task(arm)  # whether the arm can turn about the free axis
        return goal
    if hasattr(goal, "homogeneous") or np.shape(goal if _has_shape(goal) else ()) == (4, 4):
        try:
            return PoseGoal(goal)
        except InvalidInputError as error:
            raise InvalidInputError(argument, error.value, error.allowed) from error
    return None


def read_configuration(argument: str, q: Any, robot: Robot) -> Array:
    """A configuration (n,), perhaps outside the limits, given by its numbers or by the name of a state.

    Raises InvalidInputError for a wrong shape, and UnknownNameError, with the nearest names, for an unknown one.
    """
    if not isinstance(q, str):
        return _one_configuration(argument, q, robot)
    if q not in robot.states:
        none = "one number per joint: the robot has no named states with a value for each joint"
        raise UnknownNameError(argument, q, robot.states, empty=none)
    return robot.states[q]


def _one_configuration(argument: str, q: Any, robot: Robot) -> Array:
    checked = configurations(argument, q, robot.n)
    if checked.ndim != 1:
        raise InvalidInputError(argument, q, f"one configuration of shape ({robot.n},)")
    return checked


def _is_configuration(goal: Any) -> bool:
    return all(isinstance(each, numbers.Number | np.generic) for each in goal)


def _is_pose(goal: Sequence[Any], n: int) -> bool:
    """Whether four rows of four numbers are one pose: for an arm of four joints only if they are a rigid transform."""
    if not _has_shape(goal) or np.shape(goal) != (4, 4) or any(isinstance(each, str) for each in goal):
        return False
    if n != 4:
        return True
    try:
        pose_matrix("goal", goal)
    except InvalidInputError:
        return False
    return True


def _has_shape(goal: Any) -> bool:
    """Whether the value is one array, not rows of different lengths."""
    try:
        np.shape(goal)
    except Exception:  # of a foreign object any exception
        return False
    return True


#: Keys of an entry: those of a pose, and the two others, each of which stands alone.
POSE_KEYS, ALONE = ("position", "rotation", "free_axis", "tolerance", "of"), ("q", "state")
#: Key of an entry with poses of several tools, by their names.
TOOLS = "tools"


def goals_from_yaml(file: str | Path, robot: Robot) -> list[OneGoal]:
    """Read goals: ``goals: [{position: [0.5, 0, 0.3], rotation: [3.1416, 0, 0]}, {q: [0, 1, ...]}, {state: ready}, ...]``.

    A pose of the tool in the world has `position` [m] and `rotation`: roll, pitch, yaw [rad], a quaternion x, y, z, w, or a
    matrix (3, 3); and, where wanted, `free_axis` (3,), `tolerance: {position: [m], rotation: [rad]}` and `of`, the name of a
    carried part whose pose it is. `q` is one number per joint, `state` the name of one of `robot.states`, and `tools` maps the
    tools of a robot with several to such poses.

    Raises FileFormatError or InvalidInputError, which name the file, the entry, the key and what is allowed.
    """
    path = existing_file("goals", file)
    data = read_yaml("goals", path)
    entries = data.get("goals") if isinstance(data, Mapping) and set(data) == {"goals"} else None
    if not isinstance(entries, list) or not entries:
        raise FileFormatError("goals", str(path), "a list of at least one goal under the single key goals")
    goals = []
    for k, entry in enumerate(entries):
        try:
            goals.append(goal_of_entry(f"goals[{k}]", entry, robot))
        except FileFormatError:
            raise
        except InvalidInputError as error:
            argument = error.argument if error.argument.startswith("goals[") else f"goals[{k}].{error.argument}"
            raise FileFormatError(f"{argument} in {path}", str(error.value), error.allowed) from error
    return goals


def pose_of_numbers(argument: str, values: Sequence[float]) -> Array:
    """The pose (4, 4) of x, y, z [m] and roll, pitch, yaw [rad], or of x, y, z and a unit quaternion x, y, z, w."""
    if len(values) not in (6, 7):
        wanted = "x y z [m] and roll pitch yaw [rad], or x y z and a quaternion x y z w: 6 or 7 numbers"
        raise InvalidInputError(argument, list(values), f"{wanted}, not {len(values)}")
    numbers = finite_array(argument, values, (len(values),))
    return _pose(argument, numbers[:3], numbers[3:])


def goal_of_entry(argument: str, entry: Any, robot: Robot) -> OneGoal:
    """One goal of an entry; raises InvalidInputError, which names the argument."""
    keys = set(entry) if isinstance(entry, Mapping) else set()
    if len(keys) == 1 and keys <= set(ALONE):
        key = next(iter(keys))
        if (key == "state") != isinstance(entry[key], str):
            raise InvalidInputError(f"{argument}.{key}", entry[key], "a name" if key == "state" else "one number per joint")
        target = read_goal(f"{argument}.{key}", entry[key], robot)
        assert target.q is not None
        return target.q
    if keys == {TOOLS}:
        return _tools(f"{argument}.{TOOLS}", entry[TOOLS], robot)
    goal = _pose_goal(argument, entry)
    read_goal(argument, goal, robot)
    return goal


def _tools(argument: str, entry: Any, robot: Robot) -> Mapping[str, PoseGoal]:
    """The poses of several tools."""
    if not isinstance(entry, Mapping):
        raise InvalidInputError(argument, entry, "a mapping from tools to poses")
    goals = {str(tool): _pose_goal(f"{argument}.{tool}", each) for tool, each in entry.items()}
    read_goal(argument, goals, robot)
    return goals


def _pose_goal(argument: str, entry: Any) -> PoseGoal:
    """A pose with what is free about it."""
    keys = set(entry) if isinstance(entry, Mapping) else set()
    if not {"position", "rotation"} <= keys or not keys <= set(POSE_KEYS):
        others = ", ".join((*ALONE, TOOLS))
        wanted = f"position and rotation, with free_axis, tolerance and of where wanted, or one of {others}"
        raise InvalidInputError(argument, entry, f"an entry with the keys {wanted}")
    position = finite_array(f"{argument}.position", entry["position"], (3,))
    pose = _pose(f"{argument}.rotation", position, entry["rotation"])
    tolerance = _tolerance(f"{argument}.tolerance", entry.get("tolerance"))
    return PoseGoal(pose, free_axis=entry.get("free_axis"), tolerance=tolerance, of=entry.get("of", ""))


def _pose(argument: str, position: Array, rotation: Any) -> Array:
    """The pose with a rotation given as roll, pitch, yaw (3,), as a quaternion (4,) or as a matrix (3, 3)."""
    pose = np.eye(4)
    pose[:3, 3] = position
    if not isinstance(rotation, list | tuple | np.ndarray):
        raise InvalidInputError(argument, rotation, "roll, pitch, yaw (3,), a quaternion x, y, z, w (4,) or a matrix (3, 3)")
    if len(rotation) == 4:
        pose[:3, :3] = pin.Quaternion(unit_quaternion(argument, rotation, "x, y, z, w")).toRotationMatrix()
    elif isinstance(rotation[0] if len(rotation) else None, list | tuple):
        pose[:3, :3] = rotation_matrix(argument, rotation)
    else:
        pose[:3, :3] = pin.rpy.rpyToMatrix(*finite_array(argument, rotation, (3,)))
    return pose


def _tolerance(argument: str, entry: Any) -> Tolerance | None:
    if entry is None:
        return None
    if not isinstance(entry, Mapping) or not set(entry) <= {"position", "rotation"}:
        raise InvalidInputError(argument, entry, "position [m], rotation [rad], or both")
    return Tolerance(**{str(key): value for key, value in entry.items()})
