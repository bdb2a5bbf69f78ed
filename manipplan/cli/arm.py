"""The arm and the scene that a command was given, and configurations of the arm."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from manipplan.checks import Array
from manipplan.errors import InvalidInputError, UnknownNameError
from manipplan.robots.catalog import load_robot
from manipplan.robots.robot import Robot
from manipplan.robots.scene import Scene


def load_cell(name: str, scene: Path | None, **options: str | Path | tuple[float, ...] | None) -> tuple[Robot, Scene]:
    """A known arm or that of a file, with the options of `load_robot` that were given, and the obstacles around it.

    Limits are a number for all joints, or one a joint.
    """
    given = {key: value for key, value in options.items() if value is not None and value != ()}
    plain = {key: value[0] if isinstance(value, tuple) and len(value) == 1 else value for key, value in given.items()}
    robot = load_robot(name, **plain)
    return robot, Scene.from_yaml(scene) if scene is not None else Scene()


def configuration_of(argument: str, words: Sequence[str], robot: Robot) -> Array:
    """The configuration that words name: one number a joint, or one named state of the robot."""
    try:
        numbers = np.array([float(word) for word in words])
    except ValueError as error:
        if len(words) != 1:
            raise InvalidInputError(argument, " ".join(words), "one number a joint, or the name of one state") from error
    else:
        if len(numbers) != robot.n:
            joints = ", ".join(robot.joint_names)
            raise InvalidInputError(argument, " ".join(words), f"{robot.n} numbers, one a joint ({joints}), not {len(words)}")
        return numbers
    if not robot.named_states:
        raise InvalidInputError(argument, words[0], "one number a joint: the robot has no named states")
    if words[0] not in robot.named_states:
        raise UnknownNameError(argument, words[0], robot.named_states)
    return robot.named_states[words[0]]
