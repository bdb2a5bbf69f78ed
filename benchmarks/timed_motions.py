"""`mp.plan` beside mplib's timed motions on four kinds of problems of the Panda.

Free pairs are the first random ones of panda_pairs.py, those among five boxes are of panda_boxes.py, those over the table and
in the shelf of benchmarks/pairs. mplib has no clearance, so none is asked of ours. Run with `make benchmark-peers`, which makes
mplib's environment first. Writes docs/benchmarks/timed_motions.md. Both run in one process and thread, one after the other.
"""

import argparse
import os
import platform
from collections.abc import Sequence
from itertools import islice
from pathlib import Path

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import numpy as np
from motions import BESIDE, ENVIRONMENTS, Motion, beside, of_mplib, of_ours
from outside.problems import Problem
from panda_boxes import pairs as boxes_pairs
from path_suite import PAIRS, load
from rich.progress import track

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "timed_motions.md"
#: Largest number of problems of each kind: that of the smallest suite.
MOST = 17


def kinds(count: int) -> dict[str, list[Problem]]:
    """The first `count` problems of each kind."""
    rng, robot, boxes = np.random.default_rng(2012), mp.load_robot("panda"), mp.demo.panda_among_boxes()
    ends = {
        "free pairs": [(mp.Scene(), *robot.random_configuration(rng, size=2)) for _ in range(count)],
        "five boxes": [(boxes.scene, *pair) for pair in islice(boxes_pairs(boxes), count)],
    }
    for name in ("table", "shelf"):
        scene = mp.Scene.from_yaml(PAIRS / f"{name}_panda.yaml")
        of_scene = [pair for pair in load() if pair["arm"] == "panda" and pair["scene"] == name]
        ends[name] = [(scene, pair["start"], pair["goal"]) for pair in of_scene[:count]]
    return {
        kind: [Problem(set=kind, number=k, scene=scene, start=a, goal=b) for k, (scene, a, b) in enumerate(some)]
        for kind, some in ends.items()
    }


def main(arguments: Sequence[str] | None = None) -> dict[str, tuple[list[Motion], list[Motion]]]:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--problems", type=int, default=MOST, help=f"number of problems of each kind, at most {MOST}")
    parser.add_argument("--environments", type=Path, default=ENVIRONMENTS, help="folder of the peers' environments")
    parser.add_argument("--out", type=Path, default=OUT, help="file of the table")
    given = parser.parse_args(arguments)
    robot, found = mp.load_robot("panda"), {}
    lines = [f"| kind | {' | '.join(BESIDE)} |", "|---" * (1 + len(BESIDE)) + "|"]
    for kind, problems in kinds(given.problems).items():
        of_ours(robot, problems[0])  # compiles, which no row counts
        mine = [of_ours(robot, each) for each in track(problems, description=kind)]
        theirs = of_mplib(robot, problems, environments=given.environments)
        found[kind] = mine, theirs
        lines.append(f"| {kind} | {beside(mine, theirs)} |")
    all_of = ([each for pair in found.values() for each in pair[k]] for k in (0, 1))
    lines += [
        f"| all | {beside(*all_of)} |",
        "",
        f"{given.problems} problems of each kind; mplib 0.2.1; Python {platform.python_version()}, {platform.machine()}, one "
        f"thread; command: `.venv/bin/python benchmarks/timed_motions.py --problems {given.problems}`.",
    ]
    given.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))
    return found


if __name__ == "__main__":
    main()
