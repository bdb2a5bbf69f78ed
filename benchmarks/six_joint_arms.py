"""Random pairs of six-joint arms without an obstacle through `mp.optimize_path`: do paths cross singularities well?

Run with `make benchmark`. Start and goal are uniform inside the joint limits, of joints that turn more than once within half a
turn of zero, and free of self-collision. Between most of them every path crosses singularities. Counted are the paths that are
OPTIMAL, those that cross no more often than the lower bound from the factors of det J, and those whose g is at most that of
the straight line. Each path that is OPTIMAL is optimised again, as the first path. Writes docs/benchmarks/six_joint_arms.md.
"""

import argparse
import platform
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from rich.progress import track

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "six_joint_arms.md"
SEED = 6
ARMS = ("ur5", "ur10", "z1", "kinova")
HEAD = (
    "| arm | pairs | crossings needed: mean, most | `OPTIMAL` | other | crossings as few as the bound | at most 2 more "
    "| g over the straight line's: median, largest | wall time: median, worst | optimised again, g falls by: median, most |"
)


@dataclass(frozen=True, kw_only=True)
class Outcome:
    """Of one pair.

    Attributes:
        status, crossings, least: of the path, and the lower bound on the number of its crossings.
        ratio: g over that of the straight line.
        seconds: wall time [s].
        fall: share by which g falls when an OPTIMAL path is optimised again; nan for others.
    """

    status: mp.Status
    crossings: int
    least: int
    ratio: float
    seconds: float
    fall: float


def pairs(robot: mp.Robot, count: int) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Start and goal of `count` pairs."""
    rng, scene = np.random.default_rng(SEED), mp.Scene()
    low, high = np.maximum(robot.limits.lower, -np.pi), np.minimum(robot.limits.upper, np.pi)
    found = 0
    while found < count:
        start, goal = rng.uniform(low, high, size=(2, robot.n))
        if not scene.in_collision(robot, np.array([start, goal])).any():
            found += 1
            yield start, goal


def outcome(robot: mp.Robot, start: np.ndarray, goal: np.ndarray) -> Outcome:
    """Optimise one pair."""
    began = time.perf_counter()
    result = mp.optimize_path(robot, start, goal, throw=False)
    seconds = time.perf_counter() - began
    certificate = result.certificate
    fall = np.nan
    if result.status is mp.Status.OPTIMAL:
        again = mp.optimize_path(robot, start, goal, seeding=mp.Seeding(initial=result.path))
        fall = 1 - again.g / result.g
    return Outcome(
        status=result.status,
        crossings=len(certificate.crossings),
        least=certificate.least_crossings,
        ratio=result.g / result.seed_cost.g,
        seconds=seconds,
        fall=fall,
    )


def row(name: str, found: Sequence[Outcome]) -> str:
    """The line of a table."""
    optimal = sum(each.status is mp.Status.OPTIMAL for each in found)
    least = [each.least for each in found]
    few = [sum(each.crossings <= each.least + more for each in found) for more in (0, 2)]
    ratios, seconds = [each.ratio for each in found], [each.seconds for each in found]
    cells = [
        name,
        str(len(found)),
        f"{np.mean(least):.1f}, {max(least)}",
        str(optimal),
        ", ".join(sorted({each.status.name for each in found if each.status is not mp.Status.OPTIMAL})) or "–",
        *(f"{100 * count / len(found):.0f} %" for count in few),
        f"{np.median(ratios):.2f}, {max(ratios):.2f}",
        f"{np.median(seconds):.2f} s, {max(seconds):.2f} s",
        f"{np.nanmedian([each.fall for each in found]):.1e}, {np.nanmax([each.fall for each in found]):.1e}",
    ]
    return f"| {' | '.join(cells)} |"


def main(arguments: Sequence[str] | None = None) -> list[Outcome]:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--pairs", type=int, default=50, help="number of pairs of each arm")
    parser.add_argument("--out", type=Path, default=OUT, help="file of the table")
    given = parser.parse_args(arguments)
    lines, every = [HEAD, "|" + "---|" * 10], []
    for name in ARMS:
        robot = mp.load_robot(name)
        mp.optimize_path(robot, robot.neutral, robot.neutral + 0.1)  # compiles, which no row counts
        found = [outcome(robot, *pair) for pair in track(list(pairs(robot, given.pairs)), description=name)]
        lines.append(row(f"`{name}`", found))
        every += found
    lines += [
        row("all", every),
        "",
        f"Python {platform.python_version()}, {platform.machine()}; command: "
        f"`.venv/bin/python benchmarks/six_joint_arms.py --pairs {given.pairs}`.",
    ]
    given.out.parent.mkdir(parents=True, exist_ok=True)
    given.out.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print("\n".join(lines))
    return every


if __name__ == "__main__":
    main()
