"""The arm and the scene that a command was given, and configurations of the arm."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from manipplan.checks import Array
from manipplan.errors import InvalidInputError, UnknownNameError
from manipplan.robots.catalog import load_robot
from manipplan.robots.robot import Robot
from manipplan.robots.scene import Scene


def load_cell(name: str, tool: str | None, srdf: Path | None, scene: Path | None) -> tuple[Robot, Scene]:
    """A known arm or that of a file, with the options that were given, and the obstacles around it."""
    given = {"tool": tool, "srdf": srdf}
    robot = load_robot(name, **{key: value for key, value in given.items() if value is not None})
    return robot, Scene.from_yaml(scene) if scene is not None else Scene()


def configuration_of(argument: str, words: Sequence[str], robot: Robot) -> Array:
    """The configuration that words name: one number a joint, or one named state of the robot."""
    try:
        return np.array([float(word) for word in words])
    except ValueError as error:
        if len(words) != 1:
            raise InvalidInputError(argument, " ".join(words), "one number a joint, or the name of one state") from error
    if not robot.named_states:
        raise InvalidInputError(argument, words[0], "one number a joint: the robot has no named states")
    if words[0] not in robot.named_states:
        raise UnknownNameError(argument, words[0], robot.named_states)
    return robot.named_states[words[0]]
