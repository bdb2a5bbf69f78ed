"""First paths of MotionBenchMaker's problems: our compiled RRT-Connect, and RRTConnect of OMPL on the same collision check.

Run with `make benchmark`. Start and goal of all problems that count are inside the limits and free. Both searches first look
for a path with few crossings of singularities where the arm has six joints; all paths are proven free of collision. Writes
docs/benchmarks/seeds.md.
"""

import argparse
import platform
import time
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from outside import problems
from rich.progress import track

import manipplan as mp
from manipplan.cost.crossings import least_crossings
from manipplan.kinematics.sides import sides_of
from manipplan.seeds.acceptance import SIDES_STEP

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "seeds.md"
PLANNERS = {"auto": "ours", "RRTConnect": "OMPL"}


@dataclass(frozen=True, kw_only=True)
class Outcome:
    """Of one problem and planner.

    Attributes:
        seconds: wall time, with its proof.
        length: of the path [rad]; NaN where none was found.
        more: crossings of singularities above the lower bound; NaN for seven joints, and where no path was found.
        proven: the path is proven free on the whole curve.
    """

    seconds: float
    length: float = np.nan
    more: float = np.nan
    proven: bool = False


def outcome(robot: mp.Robot, problem: problems.Problem, planner: str) -> Outcome:
    """The figures of one problem with one planner."""
    began = time.perf_counter()
    try:
        path = mp.seed_path(
            robot, problem.start, problem.goal, problem.scene, fewest_crossings=True, seeding=mp.Seeding(planner=planner)
        )
    except mp.PlanningError:
        return Outcome(seconds=time.perf_counter() - began)
    seconds = time.perf_counter() - began
    kinematics, more = robot.kinematics(), np.nan
    sides = sides_of(kinematics)
    if sides is not None:
        more = sides.changes(path(path.fine_samples(SIDES_STEP))) - least_crossings(kinematics, problem.start, problem.goal)
    proven = problem.scene.path_clearance(robot, path).proven
    return Outcome(seconds=seconds, length=path.length, more=more, proven=proven)


def is_valid(robot: mp.Robot, problem: problems.Problem) -> bool:
    """Whether start and goal are inside the limits and free."""
    ends = np.array([problem.start, problem.goal])
    inside = all((robot.limits.outside(q) <= 0).all() for q in ends)
    return inside and not problem.scene.in_collision(robot, ends).any()


def row(arm: str, planner: str, found: Sequence[Outcome]) -> str:
    """The line of a table."""
    seconds, lengths = np.array([each.seconds for each in found]), np.array([each.length for each in found])
    more = np.array([each.more for each in found])
    paths = np.isfinite(lengths)
    fewest = "–" if np.isnan(more).all() else f"{(more == 0).sum()}"
    times = f"{np.median(seconds) * 1e3:.0f} ms | {np.quantile(seconds, 0.95) * 1e3:.0f} ms | {seconds.max():.1f} s"
    counts = f"{len(found)} | {paths.sum()} | {sum(each.proven for each in found)} | {fewest}"
    return f"| {arm}, {planner} | {counts} | {times} | {np.nanmean(lengths):.2f} rad |"


def main(arguments: Sequence[str] | None = None) -> dict[tuple[str, str], list[Outcome]]:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--problems", type=int, default=8, help="number of problems of each set, at most 50")
    parser.add_argument("--out", type=Path, default=OUT, help="file of the table")
    given = parser.parse_args(arguments)
    made: dict[tuple[str, str], list[Outcome]] = defaultdict(list)
    for arm in ("panda", "ur5"):
        robot, sets = problems.robot(arm), defaultdict(list)
        for problem in problems.load(arm):
            sets[problem.set].append(problem)
        chosen = [problem for several in sets.values() for problem in several[: given.problems]]
        mp.seed_path(robot, chosen[0].start, chosen[0].goal, chosen[0].scene)  # compiles, which no row counts
        for problem in track(chosen, description=arm):
            if is_valid(robot, problem):
                for planner, name in PLANNERS.items():
                    made[arm, name].append(outcome(robot, problem, planner))
    lines = [
        "| arm, planner | problems | paths | proven free | fewest crossings | wall time: median | 95 % | worst | mean length |",
        "|---" * 9 + "|",
        *(row(*key, found) for key, found in made.items()),
        "",
        f"The first {given.problems} of each set; Python {platform.python_version()}, {platform.machine()}; command: "
        f"`.venv/bin/python benchmarks/seeds.py --problems {given.problems}`.",
    ]
    given.out.parent.mkdir(parents=True, exist_ok=True)
    given.out.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print("\n".join(lines))
    return made


if __name__ == "__main__":
    main()
