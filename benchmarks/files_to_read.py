"""Number of the package's files whose functions run in one call of a job: what a reader of that job has to open.

Only the folders of the job itself count, as WANTED lists them. Each job runs once before it is counted, so that what is built
once does not count. Run with `make benchmark`.
"""

import argparse
import sys
from collections import Counter
from collections.abc import Callable, Sequence
from pathlib import Path
from types import FrameType
from typing import Any

import numpy as np

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "files_to_read.md"
PACKAGE = Path(mp.__file__).parent
#: The folders that count for a job, and the number that it must not exceed.
JOBS_ROOMS = ("goals", "tool_path", "plans", "programs", "jobs")
WANTED = {
    "plan": (JOBS_ROOMS, 12),
    "follow": ((*JOBS_ROOMS, "search"), 14),
    "sequence": (JOBS_ROOMS, 18),
    "optimize_path": (("optimize",), 9),
}


def jobs() -> dict[str, Callable[[], Any]]:
    """One call of each job: with a pose as goal, a line, a pick and place, and two configurations."""
    demo = mp.demo.panda_among_boxes()
    robot, start, scene = demo.robot, demo.start, demo.scene
    kinematics = robot.kinematics()
    pose = kinematics.pose(demo.goal)
    end = pose.copy()
    end[2, 3] += 0.05
    line = mp.CartesianPath.line(pose, end)
    steps = [mp.MoveTo(pose), mp.MoveAlong(line), mp.MoveTo(start)]
    return {
        "plan": lambda: mp.plan(robot, start, pose, scene),
        "follow": lambda: mp.follow(robot, line, scene),
        "sequence": lambda: mp.sequence(robot, start, steps, scene),
        "optimize_path": lambda: mp.optimize_path(robot, start, demo.goal),
    }


def executed(call: Callable[[], Any]) -> set[Path]:
    """The package's files whose functions run in a call."""
    found: set[str] = set()

    def note(frame: FrameType, event: str, _: Any) -> None:
        if event == "call":
            found.add(frame.f_code.co_filename)

    sys.setprofile(note)
    try:
        call()
    finally:
        sys.setprofile(None)
    return {Path(each).relative_to(PACKAGE) for each in found if Path(each).is_relative_to(PACKAGE)}


def main(arguments: Sequence[str] | None = None) -> dict[str, int]:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=OUT, help="the table's file")
    options = parser.parse_args(arguments)
    lines = ["| job | files | wanted | of which |", "|---|---|---|---|"]
    numbers = {}
    for name, call in jobs().items():
        call()
        rooms, wanted = WANTED[name]
        files = [each for each in executed(call) if each.parts[0] in rooms]
        counts = Counter(each.parts[0] for each in files)
        numbers[name] = len(files)
        parts = ", ".join(f"{room} {counts[room]}" for room in rooms if counts[room])
        lines.append(f"| `{name}` | {len(files)} | at most {wanted} | {parts} |")
    lines += ["", "Command: `.venv/bin/python benchmarks/files_to_read.py`."]
    options.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))
    return numbers


if __name__ == "__main__":
    np.set_printoptions(precision=4)
    main()
