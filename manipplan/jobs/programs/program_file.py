"""Programs in a YAML file."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from manipplan.collision.scene import Scene
from manipplan.constraints.constraint_file import constraint_of_entry
from manipplan.jobs.goals.goal_file import goal_of_entry
from manipplan.jobs.goals.pose_goal import Goal
from manipplan.jobs.programs.steps import Attach, Detach, MoveAlong, MoveTo, ProgramStep, Wait
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.tolerance import Tolerance
from manipplan.robots.robot import Robot
from manipplan.support.checks import existing_file
from manipplan.support.errors import FileFormatError, InvalidInputError, UnknownNameError
from manipplan.support.yaml_files import read_yaml
from manipplan.symbolic.task import Task

#: Keys of the file, and of a move along a path.
KEYS = ("robot", "locked", "scene", "start", "steps", "blend", "clearance")
MOVE_KEYS = ("goal", "approach", "constraints", "blend")
ALONG_KEYS = ("way", "file", "tool_speed", "tolerance", "pointing", "positions", "blend")


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
        options = {key: value[key] for key in ("tool_speed", "positions", "blend") if key in value}
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
    kept = [constraint_of_entry(f"{argument}.move_to.constraints[{k}]", each, path) for k, each in enumerate(constraints)]
    return MoveTo(goal, approach=value.get("approach"), constraints=kept, blend=value.get("blend"))
