"""Whether threads may share a robot and a scene: plans in several threads at once against the same plans one by one.

Each run is a new process, since a fault would kill it: it plans in threads first, then one by one, and compares every path and
every solution of inverse kinematics, to the last bit. Writes docs/benchmarks/threads.md.
"""

import argparse
import json
import os
import subprocess
import sys
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from rich.progress import track

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "threads.md"
#: Long enough that no plan is ended by the clock: threads of Python take turns.
PATIENT = mp.Seeding(time_limit=600.0)
COLUMN = mp.Scene([mp.Cylinder(radius=0.2, length=1.0, position=(1.0, 1.0, 0.0))])
POST = mp.Scene([mp.Box(size=(0.1, 0.1, 0.6), position=(0.45, 0.0, 0.3))])
Work = tuple[mp.Robot, mp.Scene, NDArray[np.float64], NDArray[np.float64]]


def problems(count: int) -> list[Work]:
    """Problems of three arms, each with one scene for all: starts and goals at random near a given pair."""
    pairs = [
        (mp.planar_arm([1.0, 1.0, 1.0]), COLUMN, [0.0, -1.1, -1.6], [1.57, 0.5, 1.5]),
        (mp.load_robot("panda"), POST, [-0.6, 0.3, 0.0, -2.0, 0.0, 2.3, 0.8], [0.9, 0.2, -0.2, -2.1, 0.3, 2.2, 0.8]),
        (mp.load_robot("ur5"), POST, [-0.8, -1.4, 1.6, -1.77, -1.57, 0.0], [0.8, -1.4, 1.6, -1.77, -1.57, 0.0]),
    ]
    rng = np.random.default_rng(1)
    made = []
    while len(made) < count:
        robot, scene, start, goal = pairs[len(made) % len(pairs)]
        ends = np.array([start, goal]) + rng.uniform(-0.1, 0.1, (2, robot.n))
        if not scene.in_collision(robot, ends).any():
            made.append((robot, scene, ends[0], ends[1]))
    return made


def solved(work: Work) -> tuple[str, bytes]:
    """The status and the path of a plan, and the solutions of inverse kinematics at its middle."""
    robot, scene, start, goal = work
    plan = mp.plan(robot, start, goal, scene, seeding=PATIENT, throw=False)
    if plan.path is None:
        return plan.status.name, b""
    q = plan.path(np.linspace(0.0, 1.0, 21))
    solutions = mp.inverse_kinematics(robot, robot.kinematics().pose(q[10]), samples=20).q
    return plan.status.name, q.tobytes() + solutions.tobytes()


def compare(threads: int, plans: int) -> tuple[int, int]:
    """The number of plans, and of those that are equal in threads and one by one, in this process."""
    work = problems(plans)
    with ThreadPoolExecutor(threads) as pool:
        together = list(pool.map(solved, work))
    return plans, sum(one == solved(each) for one, each in zip(together, work, strict=True))


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--threads", type=int, default=4, help="number of threads")
    parser.add_argument("--plans", type=int, default=200, help="number of plans of each run")
    parser.add_argument("--runs", type=int, default=10, help="number of runs, each in a new process")
    parser.add_argument("--inside", action="store_true", help="do one run in this process, and print it")
    parser.add_argument("--out", type=Path, default=OUT, help="the table's file")
    options = parser.parse_args(arguments)
    if options.inside:
        print(json.dumps(compare(options.threads, options.plans)))
        return
    command = [sys.executable, __file__, "--inside", f"--threads={options.threads}", f"--plans={options.plans}"]
    lines = ["| run | plans | equal to those one by one |", "|---|---|---|"]
    for k in track(range(options.runs), description="runs"):
        run = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
        plans, equal = json.loads(run.stdout.splitlines()[-1]) if run.returncode == 0 else (options.plans, "crashed")
        lines.append(f"| {k + 1} | {plans} | {equal} |")
        print(lines[-1], flush=True)
    setting = f"{options.threads} threads, planar arm, Panda and UR5, one scene each, {os.cpu_count()} cores"
    lines += ["", f"{setting}; command: `.venv/bin/python benchmarks/threads.py`."]
    options.out.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
