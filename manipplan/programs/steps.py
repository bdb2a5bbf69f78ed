"""The steps of a program.

Programs in a YAML file.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from manipplan.collision.scene import Scene
from manipplan.constraints.constraint import Constraint, constraint_of_entry, constraint_tuple
from manipplan.goals.goal import Goal, goal_of_entry
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.tolerance import Tolerance
from manipplan.robots.attached import Solid
from manipplan.robots.robot import Robot
from manipplan.support.checks import ArrayLike, existing_file, finite_array, instance, number, whole_number
from manipplan.support.data_files import read_yaml
from manipplan.support.display import one_line
from manipplan.support.errors import FileFormatError, InvalidInputError, UnknownNameError
from manipplan.symbolic.task import Task
from manipplan.timing.constant_speed import MOST_SLOWDOWN, STEADY


class ProgramStep:
    """A step of a program: MoveTo, MoveAlong, Attach, Detach or Wait."""


@one_line
@dataclass(frozen=True, eq=False)
class MoveTo(ProgramStep):
    """A free motion to a goal.

    Attributes:
        goal: as for `plan`: a configuration, the name of a state, a pose, a PoseGoal, or a list of these. A PoseGoal may be one
            of a part that the arm carries then (`of`).
        approach: straight way of the tool by which the motion ends [m]: a distance along the tool's z-axis, or a vector (3,) in
            the tool frame. Its goals are poses.
        constraints: what the motion keeps, as for `plan`; an approach does not count.
        blend: radius within which the arm goes around the corners of the move, at the approach and at its end, without a stop
            [m]; 0: it stops there; None: that of the program.
    """

    goal: Goal
    approach: float | ArrayLike | None = field(default=None, kw_only=True)
    constraints: Sequence[Constraint] = field(default=(), kw_only=True)
    blend: float | None = field(default=None, kw_only=True)

    def __post_init__(self) -> None:
        if self.approach is not None:
            object.__setattr__(self, "approach", _way("approach", self.approach))
        object.__setattr__(self, "constraints", constraint_tuple(self.constraints))
        _check_blend(self)


@one_line
@dataclass(frozen=True, eq=False)
class MoveAlong(ProgramStep):
    """A motion of the tool along a path, or straight on. A free motion to its first pose comes first where one is needed.

    Attributes:
        path: a CartesianPath in the world; or a vector (3,) by which the tool moves straight on, in the tool frame [m].
        tool_speed: constant speed of the tool's origin [m/s], kept to a hundredth between the ramps or blends at its ends, and
            not exceeded; None: as fast as the limits allow. The error for one that is too fast names the fastest.
        slowdown: share by which the tool may be slower than the tool speed where limits do not allow it, as for `follow`.
        tolerance: largest deviation from the path, as for `follow`.
        task: what of the path's poses the tool follows, as for `follow`; None: Task.pose(), of a planar arm Task.planar().
        positions: number of positions at which configurations are enumerated; None: as for `follow`. A vector has its own.
        blend: as for `MoveTo`, at the first pose, where a free motion leads there, and at the end. At least half of the path
            is left.
    """

    path: CartesianPath | ArrayLike
    tool_speed: float | None = field(default=None, kw_only=True)
    slowdown: float = field(default=STEADY, kw_only=True)
    tolerance: Tolerance | None = field(default=None, kw_only=True)
    task: Task | None = field(default=None, kw_only=True)
    positions: int | None = field(default=None, kw_only=True)
    blend: float | None = field(default=None, kw_only=True)

    def __post_init__(self) -> None:
        if not isinstance(self.path, CartesianPath):
            object.__setattr__(self, "path", _way("path", self.path))
        if self.tool_speed is not None:
            object.__setattr__(self, "tool_speed", number("tool_speed", self.tool_speed, above=0.0))
        object.__setattr__(self, "slowdown", number("slowdown", self.slowdown, least=STEADY, most=MOST_SLOWDOWN))
        if self.tool_speed is None and self.slowdown != STEADY:
            raise InvalidInputError("slowdown", self.slowdown, f"{STEADY:g} where no tool_speed is asked for")
        for name, kind in (("tolerance", Tolerance), ("task", Task)):
            if getattr(self, name) is not None:
                instance(name, getattr(self, name), kind)
        if self.positions is not None:
            whole_number("positions", self.positions, least=2)
        _check_blend(self)


@one_line
@dataclass(frozen=True, eq=False)
class Attach(ProgramStep):
    """The hand picks up a part, which the arm carries from then on.

    Attributes:
        part: the name of an obstacle, which is no longer in the scene; or a shape posed in the tool frame.
        name: name of a part that is given as a shape; default: its own, or "part".
        tool: the tool that picks it up, of a robot with several; "": the only one.
    """

    part: str | Solid
    name: str = field(default="", kw_only=True)
    tool: str = field(default="", kw_only=True)

    def __post_init__(self) -> None:
        if not isinstance(self.part, str) and (isinstance(self.part, type) or not isinstance(self.part, Solid)):
            raise InvalidInputError("part", self.part, "the name of an obstacle, or a shape such as a Box")
        instance("name", self.name, str)
        instance("tool", self.tool, str)

    @property
    def part_name(self) -> str:
        """What the part is called from then on."""
        return self.part if isinstance(self.part, str) else self.name or self.part.name or "part"


@one_line
@dataclass(frozen=True, eq=False)
class Detach(ProgramStep):
    """The hand puts down a part, which is an obstacle of the scene from then on.

    Attributes:
        name: of the part.
    """

    name: str = "part"

    def __post_init__(self) -> None:
        instance("name", self.name, str)


@one_line
@dataclass(frozen=True, eq=False)
class Wait(ProgramStep):
    """The arm stands still.

    Attributes:
        seconds: how long [s].
    """

    seconds: float

    def __post_init__(self) -> None:
        object.__setattr__(self, "seconds", number("seconds", self.seconds, above=0.0))


def _check_blend(step: MoveTo | MoveAlong) -> None:
    if step.blend is not None:
        object.__setattr__(step, "blend", number("blend", step.blend, least=0.0))


def _way(argument: str, value: float | ArrayLike) -> tuple[float, float, float]:
    """A vector (3,) in the tool frame; a number is a distance along its z-axis."""
    if isinstance(value, int | float | np.number) and not isinstance(value, bool):
        return 0.0, 0.0, number(argument, value, above=0.0)
    x, y, z = finite_array(argument, value, (3,))
    if np.linalg.norm([x, y, z]) < 1e-6:
        raise InvalidInputError(argument, value, "a way that is not zero [m]")
    return float(x), float(y), float(z)


#: Keys of the file, and of a move along a path.
KEYS = ("robot", "locked", "scene", "start", "steps", "blend", "clearance")
MOVE_KEYS = ("goal", "approach", "constraints", "blend")
ALONG_KEYS = ("way", "file", "tool_speed", "slowdown", "tolerance", "pointing", "positions", "blend")


@dataclass(frozen=True, kw_only=True)
class ProgramFile:
    """What a file says, before the robot is loaded.

    Attributes:
        path: of the file.
        robot: name or file of the robot, "" where the file has none.
        locked: values of joints that do not belong to the arm, such as those of a hand [rad or m].
        scene: the obstacles; None where the file has none.
        start: as for `sequence`.
        blend, clearance: in metres.
        entries: the steps as they stand in the file.
    """

    path: Path
    robot: str
    locked: dict[str, float]
    scene: Scene | None
    start: Any
    blend: float
    clearance: float
    entries: list[Any]

    @classmethod
    def read(cls, file: str | Path) -> "ProgramFile":
        """Read a program: ``{robot: panda, scene: scene.yaml, start: ready, blend: 0.05, steps: [...]}``.

        Names of files are relative to it. ``locked: {name: value}`` holds joints of the description. Steps are
        ``{move_to: {goal: ..., approach: 0.1, constraints: [...], blend: 0.02}}``, with one goal or a list of them as in
        `goals_from_yaml` and constraints as in `constraints_from_yaml`; ``{move_along: {way: [0, 0, -0.1]}}`` or
        ``{move_along: {file: poses.csv, tool_speed: 0.02, blend: 0.01}}``; ``{attach: name}``, with several tools
        ``{attach: {part: name, tool: left_gripper}}``; ``{detach: name}`` and ``{wait: 0.5}``.

        Raises FileFormatError, which names the entry and the key.
        """
        path = existing_file("program", file)
        data = read_yaml("program", path)
        if not isinstance(data, Mapping) or not {"start", "steps"} <= set(data):
            raise FileFormatError("program", str(path), "a mapping with the keys start and steps")
        for key in data:
            if key not in KEYS:
                raise FileFormatError(f"{key} in {path}", str(key), UnknownNameError("key", str(key), KEYS).allowed)
        if not isinstance(data["steps"], list) or not data["steps"]:
            raise FileFormatError(f"steps in {path}", str(data["steps"]), "a list of at least one step")
        scene = data.get("scene")
        numbers = {}
        for key in ("blend", "clearance"):
            value = data.get(key, 0.0)
            if isinstance(value, bool) or not isinstance(value, int | float):
                raise FileFormatError(f"{key} in {path}", str(value), "a number [m]")
            numbers[key] = float(value)
        locked = data.get("locked", {})
        if not isinstance(locked, Mapping) or not all(isinstance(each, int | float) for each in locked.values()):
            raise FileFormatError(f"locked in {path}", str(locked), "a mapping of names of joints to values [rad or m]")
        return cls(
            path=path,
            robot=str(data.get("robot", "")),
            locked={str(name): float(value) for name, value in locked.items()},
            scene=None if scene is None else Scene.from_yaml(path.parent / str(scene)),
            start=data["start"],
            entries=data["steps"],
            **numbers,
        )

    def steps(self, robot: Robot) -> list[ProgramStep]:
        """The steps for a robot; raises FileFormatError, which names the entry and the key."""
        return [self._step(f"steps[{k}]", entry, robot) for k, entry in enumerate(self.entries)]

    def _step(self, argument: str, entry: Any, robot: Robot) -> ProgramStep:
        makers: dict[str, Callable[[Any], ProgramStep]] = {
            "move_to": lambda value: _move_to(argument, value, robot, self.path),
            "move_along": self._move_along,
            "attach": _attach,
            "detach": Detach,
            "wait": Wait,
        }
        if not isinstance(entry, Mapping) or len(entry) != 1:
            raise FileFormatError(
                f"{argument} in {self.path}", str(entry), f"a mapping with one of the keys {', '.join(makers)}"
            )
        key, value = next(iter(entry.items()))
        if key not in makers:
            wanted = UnknownNameError(argument, str(key), makers).allowed
            raise FileFormatError(f"{argument} in {self.path}", str(key), wanted)
        try:
            return makers[key](value)
        except FileFormatError:
            raise
        except InvalidInputError as error:
            name = error.argument if error.argument.startswith(argument) else f"{argument}.{key}.{error.argument}"
            raise FileFormatError(f"{name} in {self.path}", str(error.value), error.allowed) from error

    def _move_along(self, value: Any) -> MoveAlong:
        if not isinstance(value, Mapping) or not set(value) <= set(ALONG_KEYS) or ("way" in value) == ("file" in value):
            raise InvalidInputError("path", value, f"a mapping with either way or file, and of {', '.join(ALONG_KEYS[2:])}")
        path = value["way"] if "way" in value else CartesianPath.from_csv(self.path.parent / str(value["file"]))
        options = {key: value[key] for key in ("tool_speed", "slowdown", "positions", "blend") if key in value}
        if "tolerance" in value:
            tolerance = value["tolerance"]
            if not isinstance(tolerance, Mapping) or not set(tolerance) <= {"position", "rotation"}:
                raise InvalidInputError("tolerance", tolerance, "position [m], rotation [rad], or both")
            options["tolerance"] = Tolerance(**{str(key): each for key, each in tolerance.items()})
        if "pointing" in value:
            options["task"] = Task.pointing(value["pointing"])
        return MoveAlong(path, **options)


def _attach(value: Any) -> Attach:
    if isinstance(value, str):
        return Attach(value)
    if not isinstance(value, Mapping) or "part" not in value or not set(value) <= {"part", "tool"}:
        raise InvalidInputError("part", value, "the name of an obstacle, or a mapping with part and, where wanted, tool")
    if not isinstance(value["part"], str):
        raise InvalidInputError("part", value["part"], "the name of an obstacle")
    return Attach(value["part"], tool=value.get("tool", ""))


def _move_to(argument: str, value: Any, robot: Robot, path: Path) -> MoveTo:
    if not isinstance(value, Mapping) or "goal" not in value:
        raise InvalidInputError("goal", value, "a mapping with goal and, where wanted, approach, constraints and blend")
    for key in value:
        if key not in MOVE_KEYS:
            raise InvalidInputError(str(key), value[key], UnknownNameError("key", str(key), MOVE_KEYS).allowed)
    constraints = value.get("constraints", [])
    if not isinstance(constraints, list):
        raise InvalidInputError("constraints", constraints, "a list of constraints")
    entries = value["goal"]
    where = f"{argument}.move_to.goal"
    goal: Goal = (
        [goal_of_entry(f"{where}[{k}]", each, robot) for k, each in enumerate(entries)]
        if isinstance(entries, list)
        else goal_of_entry(where, entries, robot)
    )
    found = [constraint_of_entry(f"{argument}.move_to.constraints[{k}]", each, path) for k, each in enumerate(constraints)]
    return MoveTo(goal, approach=value.get("approach"), constraints=found, blend=value.get("blend"))
