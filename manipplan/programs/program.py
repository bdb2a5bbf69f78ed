"""Program: the result of `sequence`.

A program in files: program.json, and one file for each part.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from manipplan.collision.scene import Scene
from manipplan.measures.measure import Measure
from manipplan.paths.trajectory import Trajectory
from manipplan.plans.archive import (
    plan_of,
    read_checked_json,
    robot_data,
    robot_of,
    scene_data,
    scene_of,
    with_parts,
    write_checked_json,
    write_plan,
)
from manipplan.plans.report import shown
from manipplan.plans.result import Plan
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, existing_file, instance, is_folder, path_of
from manipplan.support.data_files import from_json
from manipplan.support.display import Pictured, one_line
from manipplan.support.errors import FileFormatError, reading
from manipplan.support.files import finish, replacing, write_text
from manipplan.timing.constant_speed import SteadySpeed

if TYPE_CHECKING:
    from manipplan.viz.viewer import PlanViewer

#: Columns of marks.csv.
COLUMNS = ("step", "name", "begin", "path_begin", "tool_speed", "blend", "path_blend")


@one_line
@dataclass(frozen=True, kw_only=True)
class Mark:
    """When a step of a program begins.

    Attributes:
        step: its index.
        name: of its class, such as MoveTo.
        begin: when it begins [s]; the step before ends then.
        path_begin: when the tool comes onto the path or straight way of the step, after a free motion to it [s]; None without.
        tool_speed: of a MoveAlong with a tool speed: the speed of the tool, measured on the motion; None for others.
        blend: radius of the blend with the step after it [m]; 0 where the arm stops at the corner; None without a corner.
        path_blend: the same where the tool reaches its path or straight way.
    """

    step: int
    name: str
    begin: float
    path_begin: float | None = None
    tool_speed: SteadySpeed | None = None
    blend: float | None = None
    path_blend: float | None = None

    @property
    def row(self) -> str:
        """The row of marks.csv; empty cells for None, and the constant speed asked for."""
        speed = None if self.tool_speed is None else self.tool_speed.asked
        cells = (self.step, self.name, self.begin, self.path_begin, speed, self.blend, self.path_blend)
        return ",".join("" if each is None else str(each) for each in cells)

    def lines(self) -> list[str]:
        """Lines of a report."""
        speed = [f"  tool speed   {self.tool_speed}"] if self.tool_speed is not None else []
        radii = ((self.path_blend, "where its path begins"), (self.blend, "at its end"))
        blends = [f"{1e3 * radius:.3g} mm {where}" for radius, where in radii if radius]
        blend = [f"  blend        {', '.join(blends)}"] if blends else []
        return [f"  {self.begin:8.3f} s  steps[{self.step}] {self.name}", *blend, *speed]


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class Program(Pictured):
    """A program of moves, timed and checked; the result of `sequence`.

    Attributes:
        robot, scene: as they are at the beginning.
        final_robot, final_scene: as they are at the end.
        parts: the motions between stops at which something is taken up or put down, or the arm waits: each a Plan from rest to
            rest, of the arm with what it carries then, among the obstacles that are there then.
        begins: times at which the parts begin [s].
        marks: when each step begins.
        trajectory: the whole motion; the arm stands still while it waits.
        goals: for each MoveTo with several goals, by the index of the step: the index of the one that was chosen.
        stops: times at which the arm stands still although nothing is taken up, put down or waited for [s].
        warnings: probable mistakes, such as a part that is released in the air, or a blend that is smaller than asked for.
    """

    robot: Robot
    scene: Scene
    final_robot: Robot
    final_scene: Scene
    parts: tuple[Plan, ...]
    begins: tuple[float, ...]
    marks: tuple[Mark, ...]
    trajectory: Trajectory
    goals: dict[int, int]
    stops: tuple[float, ...]
    warnings: tuple[str, ...] = ()

    def __repr__(self) -> str:
        verdict = "all checks passed" if self.passed else "CHECK FAILED"
        minimum = shown(self.min_manipulability)
        return f"Program({self.robot.name!r}, {len(self.marks)} steps, {self.duration:.3f} s, minimum m {minimum}, {verdict})"

    @property
    def duration(self) -> float:
        """Of the whole motion [s]."""
        return self.trajectory.duration

    @property
    def in_order(self) -> tuple[Plan | Mark, ...]:
        """The parts and, before, between and after them, the marks of the steps at which the arm stands still.

        A controller that moves its hand only between motions executes them one after the other.
        """
        rows: list[tuple[float, int, Plan | Mark]] = [
            (each.begin, 0, each) for each in self.marks if each.name in ("Attach", "Detach", "Wait")
        ]
        rows += [(begin, 1, each) for begin, each in zip(self.begins, self.parts, strict=True)]
        return tuple(each for _, _, each in sorted(rows, key=lambda row: row[:2]))

    @property
    def passed(self) -> bool:
        """Whether all parts passed their checks."""
        return all(each.report.passed for each in self.parts)

    @property
    def min_manipulability(self) -> float:
        """The smallest manipulability on all motions."""
        return min(each.report.min_manipulability for each in self.parts)

    @property
    def final_state(self) -> tuple[Robot, Scene, Array]:
        """Arm, scene and configuration (n,) at the end: what a following program begins with."""
        return self.final_robot, self.final_scene, self.trajectory.q[-1]

    def __str__(self) -> str:
        verdict = "all checks passed" if self.passed else "CHECK FAILED"
        lines = [
            f"{self.robot.name}: {len(self.marks)} steps, {verdict}",
            f"  duration     {self.duration:.3f} s",
            f"  minimum m    {shown(self.min_manipulability)}{self.parts[0].report.unit}",
            f"  stops        {len(self.stops)} at corners{_times(self.stops)}",
        ]
        lines += [line for each in self.marks for line in each.lines()]
        lines += [f"  goal         steps[{step}]: number {index} of its list" for step, index in self.goals.items()]
        lines += [f"  warning      {each}" for each in self.warnings]
        for k, (each, begin) in enumerate(zip(self.parts, self.begins, strict=True)):
            lines += [f"part {k}, from {begin:.3f} s", *(f"  {line}" for line in str(each.report).splitlines())]
        return "\n".join(lines)

    def save(self, folder: str | Path) -> list[Path]:
        """Write trajectory.csv, .json and .yaml (ROS), marks.csv, report.txt, program.png and what `load` reads.

        marks.csv has a row for each mark, with times in s, the tool speed in m/s and the radii of blends in m. `load` reads
        program.json and one file for each part. All files of a plan or program that was saved there before are replaced in one
        step. Raises InvalidInputError when the folder cannot be written.
        """
        from manipplan.viz import save_figure

        with replacing(folder) as (to, new):
            self.trajectory.to_csv(new / "trajectory.csv")
            self.trajectory.to_json(new / "trajectory.json")
            self.trajectory.to_ros(new / "trajectory.yaml")
            write_text(new / "report.txt", f"{self}\n")
            write_text(new / "marks.csv", "\n".join([",".join(COLUMNS), *(each.row for each in self.marks)]) + "\n")
            written = [to / each.name for each in write_program(self, new, home=to)]
        save_figure(self, to / "program.png")  # last: the data are on disk even if the picture fails
        names = ("trajectory.csv", "trajectory.json", "trajectory.yaml", "report.txt", "marks.csv")
        return [*(to / name for name in names), *written, to / "program.png"]

    def show(self, *, port: int = 8080, host: str = "localhost", open_browser: bool = True) -> "PlanViewer":
        """Show the whole motion in the browser, with the parts; see `manipplan.viz.viewer.show`."""
        from manipplan.viz.viewer import show

        return show(self, port=port, host=host, open_browser=open_browser)

    def record(self, file: str | Path) -> Path:
        """Write the whole motion as an HTML file that plays in any browser; see `manipplan.viz.viewer.record`."""
        from manipplan.viz.viewer import record

        return record(self, file)

    @staticmethod
    def load(folder: str | Path, *, robot: Robot | None = None, measure: Measure | None = None) -> "Program":
        """Read a program that `save` wrote: all numbers are the same, and nothing is measured again.

        Args:
            folder: the folder, or program.json in it.
            robot: used instead of the stored one, if files of the robot are missing, or it is one arm of a robot
                (`robot.arm`) or was put together by hand. It has to be the one that was planned for; whatever it carries, each
                part of the program has the parts that were carried then.
            measure: used instead of the stored one, if it is of a class of your own.

        Raises:
            FileFormatError: a file is missing, truncated, changed or of another version, or one of the robot is; or the robot
                is another one.
            MissingExtraError: the robot is from the catalogue, whose package is not installed.
        """
        return read_program(folder, robot=robot, measure=measure)


def _times(stops: Sequence[float]) -> str:
    return f", at {', '.join(f'{each:.2f}' for each in stops)} s" if stops else ""


FORMAT, VERSION, NAME = "manipplan-program", 1, "program.json"


def write_program(program: "Program", place: Path, *, home: Path) -> list[Path]:
    """Write program.json and part_0.json, ... to a place, for the folder `home`; returns the files."""
    folder = home.expanduser().resolve()
    files = [place / NAME, *(place / f"part_{k}.json" for k in range(len(program.parts)))]
    for part, file in zip(program.parts, files[1:], strict=True):
        write_plan(part, file, home=home)
    data = {
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
    write_checked_json(files[0], data)
    return files


def read_program(folder: str | Path, *, robot: Robot | None, measure: Measure | None) -> "Program":
    """Read what `write_program` wrote; see `Program.load`."""
    given = path_of("folder", folder)
    if is_folder(given):
        finish(given)
    path = existing_file("folder", given / NAME if is_folder(given) else given)
    data = read_checked_json(path, FORMAT, VERSION)
    home = path.resolve().parent
    if robot is not None:
        instance("robot", robot, Robot)

    def arm_of(file: Path, stored: Mapping[str, Any]) -> Robot:
        """The arm of some data: the one given carries what the data say."""
        return robot_of(file, stored, home, None if robot is None else with_parts(robot, file, stored, home))

    def part_of(file: Path) -> Plan:
        plan = read_checked_json(file)
        made = plan_of(file, plan, robot=arm_of(file, plan["robot"]), scene=None, measure=measure)
        if not isinstance(made, Plan):
            raise FileFormatError("folder", str(file), "a part of a program, with a trajectory")
        return made

    with reading("folder", path, "a program written by Program.save, unchanged since"):
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


def _numbers(data: Any) -> tuple[float, ...]:
    return tuple(float(each) for each in data)
