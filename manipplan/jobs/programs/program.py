"""Program: the result of `sequence`."""

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from manipplan.collision.scene import Scene
from manipplan.jobs.reports.report import Report, shown
from manipplan.paths.joint import JointPath
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.display import one_line
from manipplan.support.files import writable_folder, write_text
from manipplan.support.json_data import json_ready


@one_line
@dataclass(frozen=True, kw_only=True)
class Mark:
    """When a step of a program begins.

    Attributes:
        step: its index.
        name: of its class, such as MoveTo.
        begin: when it begins [s]; the step before ends then.
    """

    step: int
    name: str
    begin: float


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class ProgramPart:
    """The motion between two stops at which something is taken up or put down, or the arm waits.

    Attributes:
        begin: when it begins [s].
        robot, scene: the arm with what it carries, and the obstacles, during this part.
        path: the joint path.
        trajectory: the timed motion, from rest to rest, beginning at 0 s.
        report: measured on it.
    """

    begin: float
    robot: Robot
    scene: Scene
    path: JointPath
    trajectory: Trajectory
    report: Report


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class Program:
    """A program of moves, timed and checked.

    Attributes:
        robot, scene: as they are at the beginning.
        parts: the motions between stops.
        marks: when each step begins.
        trajectory: the whole motion; the arm stands still while it waits.
        goals: for each MoveTo with several goals, by the index of the step: the index of the one that was chosen.
        stops: times at which the arm stands still although nothing is taken up, put down or waited for [s].
        warnings: what may not be meant, such as a part that is let go in the air.
    """

    robot: Robot
    scene: Scene
    parts: tuple[ProgramPart, ...]
    marks: tuple[Mark, ...]
    trajectory: Trajectory
    goals: dict[int, int]
    stops: tuple[float, ...]
    warnings: tuple[str, ...] = ()

    @property
    def duration(self) -> float:
        """Of the whole motion [s]."""
        return self.trajectory.duration

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
        """Arm, scene and configuration (n,) at the end of the last motion."""
        last = self.parts[-1]
        return last.robot, last.scene, last.trajectory.q[-1]

    def __str__(self) -> str:
        verdict = "all checks passed" if self.passed else "CHECK FAILED"
        lines = [
            f"{self.robot.name}: {len(self.marks)} steps, {verdict}",
            f"  duration     {self.duration:.3f} s",
            f"  minimum m    {shown(self.min_manipulability)}",
            f"  stops        {len(self.stops)} at corners{_times(self.stops)}",
        ]
        lines += [f"  {each.begin:8.3f} s  steps[{each.step}] {each.name}" for each in self.marks]
        lines += [f"  warning      {each}" for each in self.warnings]
        for k, each in enumerate(self.parts):
            lines += [f"part {k}, from {each.begin:.3f} s", *(f"  {line}" for line in str(each.report).splitlines())]
        return "\n".join(lines)

    def save(self, folder: str | Path) -> list[Path]:
        """Write trajectory.csv, .json and .yaml (ROS), program.json (marks, reports) and report.txt; returns the files."""
        to = writable_folder("folder", folder)
        self.trajectory.to_csv(to / "trajectory.csv")
        self.trajectory.to_json(to / "trajectory.json")
        self.trajectory.to_ros(to / "trajectory.yaml")
        data = {
            "marks": self.marks,
            "goals": {str(step): goal for step, goal in self.goals.items()},
            "stops": self.stops,
            "warnings": self.warnings,
            "parts": [{"begin": each.begin, "report": each.report} for each in self.parts],
        }
        write_text(to / "program.json", json.dumps(json_ready(data), indent=1, allow_nan=False) + "\n")
        write_text(to / "report.txt", f"{self}\n")
        return [to / name for name in ("trajectory.csv", "trajectory.json", "trajectory.yaml", "program.json", "report.txt")]


def _times(stops: Sequence[float]) -> str:
    return f", at {', '.join(f'{each:.2f}' for each in stops)} s" if stops else ""
