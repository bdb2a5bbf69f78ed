"""Time and processor time of the first calls in a new process: with an empty cache folder, and with that of an earlier process.

Each figure is of one call in a process where `manipplan` is imported and the robot is loaded; the import has a row of its own.
The last row is the same call once more in the same process. Run with `make benchmark`.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "cold_start.md"

#: What is prepared before a call, and the call.
ROBOT = "import numpy as np; robot = mp.load_robot({!r}); pose = robot.kinematics(compiled=False).pose(robot.neutral + 0.3)"
LINE = "; end = pose.copy(); end[1, 3] += 0.1; line = mp.CartesianPath.line(pose, end)"
JOBS = {
    "inverse_kinematics, panda": (ROBOT.format("panda"), "mp.inverse_kinematics(robot, pose)"),
    "inverse_kinematics, ur5": (ROBOT.format("ur5"), "mp.inverse_kinematics(robot, pose)"),
    "inverse_kinematics, xarm7": (ROBOT.format("xarm7"), "mp.inverse_kinematics(robot, pose)"),
    "follow, panda, line of 20 positions": (ROBOT.format("panda") + LINE, "mp.follow(robot, line, positions=20, samples=120)"),
    "plan, panda among five boxes": (
        "job = mp.demo.panda_among_boxes()",
        "mp.plan(job.robot, job.start, job.goal, job.scene, clearance=job.clearance)",
    ),
}
PROGRAM = """
import json, resource, time

def now():
    own, others = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return time.perf_counter(), own.ru_utime + own.ru_stime + others.ru_utime + others.ru_stime

def timed(run):
    (wall, work), _, (end, done) = now(), run(), now()
    return end - wall, done - work

imported = timed(lambda: __import__("manipplan"))
import manipplan as mp
{setup}
print(json.dumps([imported, timed(lambda: {call}), timed(lambda: {call})]))
"""


def measure(name: str, cache: Path) -> list[list[float]]:
    """Time and processor time [s] of import, first call and second call in a new process."""
    setup, call = JOBS[name]
    code = PROGRAM.format(setup=setup, call=call)
    environment = os.environ | {"MANIPPLAN_CACHE": str(cache)}
    run = subprocess.run([sys.executable, "-c", code], env=environment, check=True, capture_output=True, text=True)
    return json.loads(run.stdout)


def shown(samples: Sequence[Sequence[float]]) -> str:
    """Median and worst time, and median processor time, of rows of both."""
    times, works = zip(*samples, strict=True)
    return f"{statistics.median(times):.2f} s | {max(times):.2f} s | {statistics.median(works):.2f} s"


def main(arguments: Sequence[str] | None = None) -> dict[str, dict[str, list[list[float]]]]:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=5, help="number of empty cache folders for each job")
    parser.add_argument("--jobs", nargs="*", default=list(JOBS), help="the jobs to measure")
    parser.add_argument("--out", type=Path, default=OUT, help="the table's file")
    options = parser.parse_args(arguments)
    found: dict[str, dict[str, list[list[float]]]] = {}
    imports = []
    for name in options.jobs:
        rows = found[name] = {"first call ever": [], "first call of a later process": [], "second call of that process": []}
        for _ in range(options.runs):
            with tempfile.TemporaryDirectory() as cache:
                _, ever, _ = measure(name, Path(cache))
                imported, later, again = measure(name, Path(cache))
            imports.append(imported)
            for row, value in zip(rows.values(), (ever, later, again), strict=True):
                row.append(value)
    lines = ["| call | when | median | worst | processor time |", "|---|---|---|---|---|"]
    lines += [f"| `import manipplan` | in a later process | {shown(imports)} |"]
    lines += [f"| {name} | {when} | {shown(samples)} |" for name, rows in found.items() for when, samples in rows.items()]
    command = "command: `.venv/bin/python benchmarks/cold_start.py`"
    lines += ["", f"{options.runs} runs each, {os.cpu_count()} cores; {command}."]
    options.out.parent.mkdir(parents=True, exist_ok=True)
    options.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))
    return found


if __name__ == "__main__":
    main()
