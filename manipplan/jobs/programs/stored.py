"""A program in files: program.json, and one file for each part."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from manipplan.jobs.archive import checked_json, checksum, plan_of, write_plan
from manipplan.jobs.programs.program import Mark
from manipplan.jobs.result import Plan
from manipplan.jobs.stored import robot_data, robot_of, scene_data, scene_of, with_parts
from manipplan.measures.measure import Measure
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.robot import Robot
from manipplan.support.checks import existing_file, instance
from manipplan.support.errors import FileFormatError, InvalidInputError
from manipplan.support.files import write_text
from manipplan.support.json_data import from_json, json_ready
from manipplan.support.saving import finish

if TYPE_CHECKING:
    from manipplan.jobs.programs.program import Program

FORMAT, VERSION, NAME = "manipplan-program", 1, "program.json"


def write_program(program: "Program", place: Path, *, home: Path) -> list[Path]:
    """Write program.json and part_0.json, ... to a place, for the folder `home`; returns the files."""
    folder = home.expanduser().resolve()
    files = [place / NAME, *(place / f"part_{k}.json" for k in range(len(program.parts)))]
    for part, file in zip(program.parts, files[1:], strict=True):
        write_plan(part, file, home=home)
    data = json_ready(
        {
            "format": FORMAT,
            "version": VERSION,
            "robot": robot_data(program.robot, folder),
            "scene": scene_data(program.scene, folder),
            "final_robot": robot_data(program.final_robot, folder),
            "final_scene": scene_data(program.final_scene, folder),
            "parts": len(program.parts),
            "begins": program.begins,
            "marks": program.marks,
            "trajectory": program.trajectory,
            "goals": {str(step): goal for step, goal in program.goals.items()},
            "stops": program.stops,
            "warnings": program.warnings,
        }
    )
    write_text(files[0], json.dumps({**data, "sha256": checksum(data)}, allow_nan=False) + "\n")
    return files


def read_program(folder: str | Path, *, robot: Robot | None, measure: Measure | None) -> "Program":
    """Read what `write_program` wrote; see `Program.load`."""
    from manipplan.jobs.programs.program import Program

    given = Path(folder).expanduser() if isinstance(folder, str | Path) else folder
    if isinstance(given, Path) and given.is_dir():
        finish(given)
    path = existing_file("folder", given / NAME if isinstance(given, Path) and given.is_dir() else given)
    data = checked_json(path, FORMAT, VERSION)
    home = path.resolve().parent
    if robot is not None:
        instance("robot", robot, Robot)

    def arm_of(file: Path, stored: Mapping[str, Any]) -> Robot:
        """The arm of some data: the one given carries what the data say."""
        return robot_of(file, stored, home, None if robot is None else with_parts(robot, file, stored, home))

    def part_of(file: Path) -> Plan:
        plan = checked_json(file)
        made = plan_of(file, plan, robot=arm_of(file, plan["robot"]), scene=None, measure=measure)
        if not isinstance(made, Plan):
            raise FileFormatError("folder", str(file), "a part of a program, with a trajectory")
        return made

    try:
        return Program(
            robot=arm_of(path, data["robot"]),
            scene=scene_of(path, data["scene"], home, None),
            final_robot=arm_of(path, data["final_robot"]),
            final_scene=scene_of(path, data["final_scene"], home, None),
            parts=tuple(part_of(existing_file("folder", home / f"part_{k}.json")) for k in range(int(data["parts"]))),
            begins=_numbers(data["begins"]),
            marks=tuple(from_json(each, Mark) for each in data["marks"]),
            trajectory=from_json(data["trajectory"], Trajectory),
            goals={int(step): int(goal) for step, goal in data["goals"].items()},
            stops=_numbers(data["stops"]),
            warnings=tuple(str(each) for each in data["warnings"]),
        )
    except FileFormatError:
        raise
    except (InvalidInputError, KeyError, TypeError, ValueError, AttributeError, OverflowError, OSError) as error:
        reason = " ".join(f"{type(error).__name__}: {error}".split())[:200]
        raise FileFormatError("folder", str(path), f"a program written by Program.save, unchanged since ({reason})") from error


def _numbers(data: Any) -> tuple[float, ...]:
    return tuple(float(each) for each in data)
