"""Whether optima stay optima: MotionBenchMaker's problems of the Panda are planned, and those that are OPTIMAL optimised again.

Run with `make benchmark`. Writes docs/benchmarks/again.md. The second call starts from the path of the first one
(`Seeding.initial`), with the same scene and options.
"""

import argparse
import os
import platform
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import numpy as np
from outside import problems
from rich.progress import track
from time_limits import chosen

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "again.md"


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--problems", type=int, default=6, help="number of problems of each set")
    parser.add_argument("--out", type=Path, default=OUT, help="the table's file")
    options = parser.parse_args(arguments)
    robot = problems.robot("panda")
    work = chosen(robot, options.problems)
    falls, statuses = [], Counter[str]()
    for each in track(work, description="optimising again"):
        first = mp.plan(robot, each.start, each.goal, each.scene, throw=False)
        if first.status is not mp.Status.OPTIMAL:
            continue
        again = mp.optimize_path(robot, each.start, each.goal, each.scene, seeding=mp.Seeding(initial=first.path), throw=False)
        falls.append(1 - again.g / first.result.g)
        statuses[again.status.name] += 1
    fall = np.array(falls)
    told = ", ".join(f"{count} {name}" for name, count in statuses.most_common())
    lines = [
        "| problems | OPTIMAL | status of the second call | share by which g falls: median, worst "
        "| g falls by more than 1e-6; 1e-4 |",
        "|---" * 5 + "|",
        f"| {len(work)} | {len(fall)} | {told} | {np.median(fall):.1e}, {fall.max():.1e} "
        f"| {(fall > 1e-6).sum()}; {(fall > 1e-4).sum()} |",
        "",
        f"The first {options.problems} problems of each set; Python {platform.python_version()}, {platform.machine()}; "
        "command: `make benchmark`.",
    ]
    options.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
