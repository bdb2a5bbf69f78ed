"""Whether a process that is killed while it saves a plan over another one leaves a mixture of both, or files behind.

Writes docs/benchmarks/killed_saves.md.
"""

import argparse
import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from rich.progress import track

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "killed_saves.md"
#: Saves two plans with different goals in turn.
SAVER = """
import sys, manipplan as mp
arm = mp.planar_arm([1.0, 1.0, 1.0])
plans = [mp.plan(arm, [0, -1.1, -1.6], [1.0 + 0.1 * k, 0.5, 1.5]) for k in range(2)]
plans[1].save(sys.argv[1])
print("ready", flush=True)
while True:
    for plan in plans:
        plan.save(sys.argv[1])
"""


def goals(folder: Path) -> set[float]:
    """The last angles of the first joint in all files that are there; one if they are of one plan."""
    found = []
    if (folder / "trajectory.csv").is_file():
        found.append(mp.Trajectory.from_csv(folder / "trajectory.csv").q[-1, 0])
    if (folder / "trajectory.json").is_file():
        found.append(mp.Trajectory.from_json(folder / "trajectory.json").q[-1, 0])
    if (folder / "trajectory.yaml").is_file():
        found.append(mp.Trajectory.from_ros(folder / "trajectory.yaml").q[-1, 0])
    if (folder / "plan.json").is_file():
        found.append(mp.Plan.load(folder / "plan.json").trajectory.q[-1, 0])
    return {round(float(each), 6) for each in found}


def mixed_and_left(kills: int, folder: Path) -> tuple[int, int]:
    """The number of kills after which the folder holds files of two plans, or hidden files after the next save."""
    rng = np.random.default_rng(0)
    mixed = left = 0
    for _ in track(range(kills), description="kills", disable=kills < 10):
        child = subprocess.Popen([sys.executable, "-c", SAVER, str(folder)], stdout=subprocess.PIPE, text=True)
        assert child.stdout is not None and child.stdout.readline() == "ready\n"
        time.sleep(rng.uniform(0.0, 1.0))  # some three saves
        os.kill(child.pid, signal.SIGKILL)
        child.wait()
        child.stdout.close()
        mixed += len(goals(folder)) > 1
        plan = mp.Plan.load(folder)
        mixed += goals(folder) != {round(float(plan.trajectory.q[-1, 0]), 6)}
        plan.save(folder)
        left += any(folder.glob(".*"))
    return mixed, left


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--kills", type=int, default=100, help="number of killed processes")
    parser.add_argument("--out", type=Path, default=OUT, help="the table's file")
    options = parser.parse_args(arguments)
    with tempfile.TemporaryDirectory() as folder:
        mixed, left = mixed_and_left(options.kills, Path(folder))
    lines = ["| processes killed while they save | folders with files of two plans | hidden files after the next save |"]
    lines += ["|---|---|---|", f"| {options.kills} | {mixed} | {left} |", ""]
    lines += ["Killed by SIGKILL at random times; command: `.venv/bin/python benchmarks/killed_saves.py`."]
    options.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
