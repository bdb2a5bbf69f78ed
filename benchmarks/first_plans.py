"""Whether the first plan of a new process ends as its second one: no cache, loaded cores and a short time limit.

Each problem is planned twice in a process of its own, beside busy processes. What is built once per machine, process, robot or
scene must not count against the time limit, so that both plans have the same status. Writes docs/benchmarks/first_plans.md.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from outside import problems
from rich.progress import track

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "first_plans.md"
LIMIT = 1.0
#: Number of sets of MotionBenchMaker of which one problem is planned for each of its robots.
SETS = 7
#: What `mp.plan` is called with: robot, start, goal, scene and clearance [m].
Arguments = tuple[mp.Robot, Any, Any, mp.Scene | None, float]

POST = mp.Box(size=(0.1, 0.1, 0.6), position=(0.45, 0.0, 0.3))
TABLE = mp.Box(size=(0.9, 1.4, 0.04), position=(0.6, 0.0, -0.02))
HIGH = mp.Box(size=(0.1, 0.1, 0.1), position=(0.6, 0.6, 0.2))
COLUMN = mp.Cylinder(radius=0.2, length=1.0, position=(1.0, 1.0, 0.0))


def down(x: float, y: float, z: float) -> np.ndarray:
    """The pose of a tool that points down at a place [m]."""
    pose = np.diag([1.0, -1.0, -1.0, 1.0])
    pose[:3, 3] = x, y, z
    return pose


def outside(arm: str, k: int) -> Arguments:
    """A problem of the k-th set of MotionBenchMaker, the first inside the limits."""
    robot, found = problems.robot(arm), problems.load(arm)
    name = list(dict.fromkeys(each.set for each in found))[k]
    inside = (each for each in found if not (robot.limits.outside(np.array([each.start, each.goal])) > 0).any())
    chosen = next(each for each in inside if each.set == name)
    return robot, chosen.start, chosen.goal, chosen.scene, 0.0


def demo() -> Arguments:
    """The problem of `manipplan demo`."""
    job = mp.demo.panda_among_boxes()
    return job.robot, job.start, job.goal, job.scene, job.clearance


def moved(name: str, by: float, scene: mp.Scene | None) -> Arguments:
    """A motion of all joints of a robot of the catalogue from its neutral posture."""
    robot = mp.load_robot(name)
    return robot, robot.neutral, robot.neutral + by, scene, 0.0


PROBLEMS: dict[str, Callable[[], Arguments]] = {
    f"MotionBenchMaker, {arm}, set {k + 1}": lambda arm=arm, k=k: outside(arm, k)
    for arm in ("panda", "ur5")
    for k in range(SETS)
} | {
    "Panda, a pose beside a post": lambda: (
        mp.load_robot("panda"),
        "default",
        down(0.45, 0.25, 0.3),
        mp.Scene([POST, TABLE]),
        0.01,
    ),
    "Panda, the demo": demo,
    "xArm7, no obstacles": lambda: moved("xarm7", 0.6, None),
    "Kinova, a box": lambda: moved("kinova", 0.5, mp.Scene([HIGH])),
    "UR10, a pose": lambda: (mp.load_robot("ur10"), [0, -1.4, 1.6, -1.77, -1.57, 0], down(0.5, 0.4, 0.3), None, 0.0),
    "planar arm, a column": lambda: (
        mp.planar_arm([1.0, 1.0, 1.0]),
        [0, -1.1, -1.6],
        [1.57, 0.5, 1.5],
        mp.Scene([COLUMN]),
        0.0,
    ),
}


def plan_twice(name: str, limit: float) -> list[tuple[str, float | None, float]]:
    """Status, g and wall time [s] of two plans in this process."""
    robot, start, goal, scene, clearance = PROBLEMS[name]()
    rows = []
    for _ in range(2):
        began = time.perf_counter()
        plan = mp.plan(robot, start, goal, scene, clearance=clearance, seeding=mp.Seeding(time_limit=limit), throw=False)
        g = None if plan.result is None else plan.result.g
        rows.append((plan.status.name, g, time.perf_counter() - began))
    return rows


def measure(name: str, limit: float) -> list[tuple[str, float | None, float]]:
    """The same in a new process with an empty cache folder."""
    command = [sys.executable, __file__, "--inside", name, "--limit", str(limit)]
    with tempfile.TemporaryDirectory() as cache:
        run = subprocess.run(
            command, env=os.environ | {"MANIPPLAN_CACHE": cache}, stdout=subprocess.PIPE, text=True, check=True
        )
    return [(status, g, seconds) for status, g, seconds in json.loads(run.stdout.splitlines()[-1])]


@contextmanager
def busy(count: int) -> Iterator[None]:
    """Processes that keep cores busy."""
    runs = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(count)]
    try:
        yield
    finally:
        for each in runs:
            each.kill()
            each.wait()


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--busy", type=int, default=os.cpu_count() or 1, help="number of busy processes")
    parser.add_argument("--limit", type=float, default=LIMIT, help="time limit of each plan [s]")
    parser.add_argument("--only", default="", help="only problems whose names hold this text")
    parser.add_argument("--inside", choices=list(PROBLEMS), help="plan this problem twice in this process, and print that")
    parser.add_argument("--out", type=Path, default=OUT, help="the table's file")
    options = parser.parse_args(arguments)
    if options.inside:
        print(json.dumps(plan_twice(options.inside, options.limit)))
        return
    names = [name for name in PROBLEMS if options.only in name]
    lines = ["| problem | first plan | second plan | g of both |", "|---|---|---|---|"]
    same = 0
    with busy(options.busy):
        for name in track(names, description="planning"):
            (first, *_), (second, *_) = rows = measure(name, options.limit)
            same += first == second
            lines.append(
                f"| {name} | {first} | {second} | {', '.join('none' if g is None else f'{g:.5g}' for _, g, _ in rows)} |"
            )
            print(lines[-1], flush=True)
    setting = (
        f"Time limit {options.limit:g} s, empty cache folders, {os.cpu_count()} cores with {options.busy} other busy processes"
    )
    command = "command: `.venv/bin/python benchmarks/first_plans.py`"
    lines += ["", f"The same status in {same} of {len(names)}. {setting}; {command}."]
    options.out.write_text("\n".join(lines) + "\n")
    print(lines[-1])


if __name__ == "__main__":
    main()
