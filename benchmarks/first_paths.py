"""Pairs of benchmarks/pairs with one first path and with twelve, and with and without a floor in g.

Run with `make benchmark`. More first paths must never give a larger g. On seven-joint arms a path with m above ten floors
should be that of the objective without a floor. Writes docs/benchmarks/first_paths.md.
"""

import argparse
import csv
import platform
import time
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from rich.progress import track

import manipplan as mp

PAIRS = Path(__file__).parent / "pairs"
OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "first_paths.md"
COUNT = 12
#: Number of places, at equal shares of their lengths, at which two paths are compared.
PLACES = 201


@dataclass(frozen=True, kw_only=True)
class Outcome:
    """Of one pair.

    Attributes:
        ratio: g with twelve first paths over g with one.
        found, missing: number of different paths, and the estimate of what is missing.
        seconds: wall times with one and with twelve [s].
        clear: m of the path without a floor is above ten floors.
        apart: largest difference between the paths with and without a floor, at equal shares of their lengths [rad]; nan for
            six joints.
        gained: g without a floor of the path with one, over that of the path without one.
    """

    ratio: float
    found: int
    missing: float
    seconds: tuple[float, float]
    clear: bool = False
    apart: float = np.nan
    gained: float = np.nan


def load() -> dict[tuple[str, str], list[tuple[np.ndarray, np.ndarray]]]:
    """Start and goal of the pairs, by arm and scene."""
    groups = defaultdict(list)
    with (PAIRS / "pairs.csv").open() as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            ends = [np.array(row[end].split(), dtype=float) for end in ("start", "goal")]
            groups[row["arm"], row["scene"]].append(tuple(ends))
    return groups


def even(path: mp.JointPath) -> np.ndarray:
    """Configurations (PLACES, n) at equal shares of the length of a path."""
    s = np.linspace(0.0, 1.0, 20_001)
    gained = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(path(s), axis=0), axis=1))])
    return path(np.interp(np.linspace(0.0, gained[-1], PLACES), gained, s))


def outcome(robot: mp.Robot, scene: mp.Scene, start: np.ndarray, goal: np.ndarray) -> Outcome | None:
    """The figures of a pair; None where there is no path."""
    began = time.perf_counter()
    one = mp.optimize_path(robot, start, goal, scene, throw=False)
    middle = time.perf_counter()
    several = mp.optimize_path(robot, start, goal, scene, seeding=mp.Seeding(count=COUNT), throw=False)
    ended = time.perf_counter()
    if one.path is None or several.path is None:
        return None
    clear, apart, gained = False, np.nan, np.nan
    if robot.n > 6:
        without = mp.optimize_path(robot, start, goal, scene, objective=mp.PathObjective(floor=0.0))
        clear = without.min_manipulability > 10 * one.floor
        apart = float(np.abs(even(without.path) - even(one.path)).max())
        gained = mp.path_cost(one.path, robot.kinematics(), 1.0).g / without.g
    return Outcome(
        ratio=several.g / one.g,
        found=1 + len(several.rivals),
        missing=several.missing,
        seconds=(middle - began, ended - middle),
        clear=clear,
        apart=apart,
        gained=gained,
    )


def row(name: str, found: Sequence[Outcome]) -> str:
    """The line of a table."""
    ratios, counts = np.array([each.ratio for each in found]), [each.found for each in found]
    missing = np.nanmean([each.missing for each in found])
    times = [f"{np.median([each.seconds[k] for each in found]):.1f} s" for k in (0, 1)]
    compared = [each for each in found if each.clear]
    same = "– | –"
    if compared:
        apart = [each.apart for each in compared]
        change = max(abs(each.gained - 1) for each in compared)
        same = f"{sum(each <= 1e-3 for each in apart)} of {len(apart)}, {max(apart):.1e} rad | {change:.1e}"
    worse = f"{(ratios > 1 + 1e-5).sum()} | {ratios.max() - 1:.1e}"
    return (
        f"| {name} | {len(found)} | {worse} | {ratios.mean():.3f}, {ratios.min():.3f} "
        f"| {np.mean(counts):.1f}, {max(counts)} | {missing:.2f} | {', '.join(times)} | {same} |"
    )


def main(arguments: Sequence[str] | None = None) -> dict[tuple[str, str], list[Outcome]]:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--pairs", type=int, default=4, help="number of pairs of each arm and scene, at most 16")
    parser.add_argument("--out", type=Path, default=OUT, help="file of the table")
    given = parser.parse_args(arguments)
    made: dict[tuple[str, str], list[Outcome]] = {}
    robots: dict[str, mp.Robot] = {}
    for (arm, name), pairs in load().items():
        robot = robots.setdefault(arm, mp.load_robot(arm))
        scene = mp.Scene() if name == "free" else mp.Scene.from_yaml(PAIRS / f"{name}_{arm}.yaml")
        mp.optimize_path(robot, *pairs[0], scene, throw=False)  # compiles, which no row counts
        found = [outcome(robot, scene, *pair) for pair in track(pairs[: given.pairs], description=f"{arm}, {name}")]
        made[arm, name] = [each for each in found if each is not None]
    every = [each for found in made.values() for each in found]
    lines = [
        f"| arm, scene | pairs | g larger with {COUNT} | largest g ratio, minus 1 | g ratio: mean, smallest "
        "| different paths: mean, most | estimated probability of a new path | wall time: one, twelve "
        "| floor or not, m above ten floors: same path to 1e-3 rad, largest difference | largest change of its g |",
        "|---" * 10 + "|",
        *(row(f"{arm}, {name}", found) for (arm, name), found in made.items()),
        row("all", every),
        "",
        f"The first {given.pairs} pairs of each. Python {platform.python_version()}, {platform.machine()}; command: "
        f"`.venv/bin/python benchmarks/first_paths.py --pairs {given.pairs}`.",
    ]
    given.out.parent.mkdir(parents=True, exist_ok=True)
    given.out.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print("\n".join(lines))
    return made


if __name__ == "__main__":
    main()
