"""Goals from a YAML file and from the words of a shell."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pinocchio as pin

from manipplan.jobs.goals.pose_goal import OneGoal, PoseGoal
from manipplan.jobs.goals.read import read_goal
from manipplan.paths.tolerance import Tolerance
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, existing_file, finite_array, rotation_matrix, unit_quaternion
from manipplan.support.errors import FileFormatError, InvalidInputError
from manipplan.support.yaml_files import read_yaml

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
