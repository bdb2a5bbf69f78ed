"""The robot, scene and configurations given to a command."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Annotated, Literal, TypeAlias

import numpy as np
from tyro.conf import OmitArgPrefixes, arg

from manipplan.collision.scene import Scene
from manipplan.goals.goal import read_configuration
from manipplan.paths.table import NUMBER
from manipplan.robots.catalog import load_robot
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError
from manipplan.symbolic.task import Task


def _default(text: str) -> str:
    """The hint at the end of a help text: nothing where the default is to give nothing."""
    return "" if text in ("", "None") else f"(default: {text})"


_option = partial(arg, help_behavior_hint=_default)

ROBOT = "A name that `manipplan robots` lists, or a URDF, xacro or MJCF file."
JERK = "Jerk limits [rad/s³ or m/s³] instead of the robot's, one number or one per joint."
MEASURE = "Name of the manipulability measure; default: Yoshikawa's."
RobotName: TypeAlias = Annotated[str, arg(metavar="ROBOT", help=ROBOT)]
JerkLimits: TypeAlias = Annotated[tuple[float, ...], _option(metavar="X [X ...]", help=JERK)]
MeasureName: TypeAlias = Annotated[str | None, _option(metavar="NAME", help=MEASURE)]
OutFolder: TypeAlias = Annotated[Path, arg(metavar="FOLDER", help="Folder for the files that are written.")]
OptionalRobot: TypeAlias = Annotated[str | None, _option(metavar="ROBOT")]
Folder: TypeAlias = Annotated[Path, arg(metavar="FOLDER")]
InputFile: TypeAlias = Annotated[Path, arg(metavar="FILE")]
OptionalFile: TypeAlias = Annotated[Path | None, _option(metavar="FILE")]
Configuration: TypeAlias = Annotated[tuple[str, ...], _option(metavar="Q [Q ...]")]
Numbers: TypeAlias = Annotated[tuple[float, ...], _option(metavar="X [X ...]")]
Counts: TypeAlias = Annotated[tuple[int, ...], _option(metavar="N [N ...]")]
Count: TypeAlias = Annotated[int, arg(metavar="N")]
OptionalCount: TypeAlias = Annotated[int | None, _option(metavar="N")]
Number: TypeAlias = Annotated[float, arg(metavar="X")]
OptionalSpeed: TypeAlias = Annotated[float | None, _option(metavar="METRES/SECOND")]
Words: TypeAlias = Annotated[tuple[str, ...], _option(metavar="NAME=VALUE [...]")]
OptionalName: TypeAlias = Annotated[str | None, _option(metavar="NAME")]
Axis: TypeAlias = Annotated[tuple[float, float, float] | None, _option(metavar="X Y Z")]
Metres: TypeAlias = Annotated[float, arg(metavar="METRES")]
Seconds: TypeAlias = Annotated[float, arg(metavar="SECONDS")]
OptionalSeconds: TypeAlias = Annotated[float | None, _option(metavar="SECONDS")]
Address: TypeAlias = Annotated[str, arg(metavar="ADDRESS")]
Part: TypeAlias = Annotated[Literal["position", "orientation"] | None, _option(metavar="{position,orientation}")]
Distances: TypeAlias = Annotated[tuple[float, float], arg(metavar="METRES RADIANS")]
OptionalDistances: TypeAlias = Annotated[tuple[float, float] | None, _option(metavar="METRES RADIANS")]


@dataclass(frozen=True, kw_only=True)
class RobotOptions:
    """Options of the robot and its scene."""

    scene: OptionalFile = None
    """YAML file with obstacles."""
    tool: OptionalName = None
    """Tool frame, if the robot is a file."""
    srdf: OptionalFile = None
    """Semantic description (SRDF), if the robot is a file."""
    locked: Words = ()
    """Joints that do not belong to the arm, such as those of a hand: name=value [rad or m], or the name of an SRDF state."""
    velocity: Numbers = ()
    """Velocity limits [rad/s or m/s] instead of the robot's, one number or one per joint."""
    acceleration: Numbers = ()
    """Acceleration limits [rad/s² or m/s²], in the same form."""

    def load(
        self, name: str, *, jerk: tuple[float, ...] = (), locked: Mapping[str, float] | None = None
    ) -> tuple[Robot, Scene]:
        """A known arm or one from a file, and the obstacles around it; `jerk` limits as the others.

        `locked` are values of joints beside those of the option.
        """
        held: dict[str, float] | str = {**(locked or {}), **dict(_value(each) for each in self.locked if "=" in each)}
        states = [each for each in self.locked if "=" not in each]
        if states:
            if held or len(states) > 1:
                wanted = "values name=value, or the name of one state of the SRDF"
                raise InvalidInputError("locked", " ".join(self.locked), wanted)
            held = states[0]
        limits = {"velocity": self.velocity, "acceleration": self.acceleration, "jerk": jerk}
        options = {kind: value[0] if len(value) == 1 else value or None for kind, value in limits.items()}
        given = {"tool": self.tool, "srdf": self.srdf, "locked": held or None, **options}
        arm = load_robot(name, **{key: value for key, value in given.items() if value is not None})
        return arm, Scene() if self.scene is None else Scene.from_yaml(self.scene)


#: The options without a prefix, in a box of their own in the help.
WithRobotOptions: TypeAlias = OmitArgPrefixes[Annotated[RobotOptions, arg(name="robot")]]


def configuration_of(argument: str, words: Sequence[str], robot: Robot) -> Array:
    """The configuration from words: one number per joint, or one named state of the robot."""
    if all(map(NUMBER.fullmatch, words)):
        numbers = np.array([float(word) for word in words])
        if len(numbers) != robot.n:
            joints = ", ".join(robot.joint_names)
            raise InvalidInputError(argument, " ".join(words), f"{robot.n} numbers, one per joint ({joints}), not {len(words)}")
        return numbers
    if len(words) != 1:
        raise InvalidInputError(argument, " ".join(words), "one number per joint, or the name of one state")
    return read_configuration(argument, words[0], robot)


def _value(text: str) -> tuple[str, float]:
    """Name and value of `name=value`."""
    name, _, value = text.partition("=")
    if not NUMBER.fullmatch(value):
        raise InvalidInputError("locked", text, "name=value, such as panda_finger_joint1=0.04")
    return name, float(value)


def columns_of(given: Sequence[str]) -> dict[str, str] | None:
    """The columns of a CSV file by joint, from words `joint=column`; None where there are none."""
    pairs = [each.partition("=") for each in given]
    if not all(name and mark and column for name, mark, column in pairs):
        raise InvalidInputError("column", " ".join(given), "joint=column, such as shoulder_pan_joint=J1, or time=timestamp")
    return {name: column for name, _, column in pairs} or None


def task_of(pointing: tuple[float, float, float] | None, only: str | None) -> Task | None:
    """The task of a path of the tool: with a free tool axis (3,), or of the position or the orientation only."""
    if pointing is not None and only is not None:
        raise InvalidInputError("only", only, "nothing where a tool axis is given by --pointing")
    if pointing is not None:
        return Task.pointing(pointing)
    return {"position": Task.position(), "orientation": Task.orientation(), None: None}[only]
