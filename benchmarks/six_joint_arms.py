"""Random pairs of the UR5 without an obstacle through `mp.plan`: how many of them cross a singularity.

Run with `make benchmark`. Start and goal are uniform inside the joint limits, of joints that turn more than once within half a
turn of zero, and free of self-collision. det J of the UR5 is a product of three factors: shoulder, elbow, wrist. Where each of
them has one sign at start and goal, the two lie in one aspect, and a path without a singularity can be there; from one aspect
to another every path crosses one, and g is infinite. So the pairs are counted by aspect, too. Writes
docs/benchmarks/six_joint_arms.md.
"""

import argparse
import platform
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from rich.progress import track

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "six_joint_arms.md"
SEED = 6
ROWS = {True: "start and goal in one aspect", False: "in different aspects"}


@dataclass(frozen=True, kw_only=True)
class Outcome:
    """Of one pair: whether its ends lie in one aspect, the plan's status, and the wall time [s]."""

    one_aspect: bool
    status: mp.Status
    seconds: float


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


def aspect(kinematics: mp.Kinematics, q: np.ndarray) -> tuple[float, float, float]:
    """Which aspect q lies in: the signs of det J and of its elbow and wrist factors, which leave that of the shoulder."""
    shoulder_elbow_wrist = np.linalg.det(kinematics.jacobian(q))
    elbow, wrist = np.sin(q[2]), np.sin(q[4])
    return float(np.sign(shoulder_elbow_wrist)), float(np.sign(elbow)), float(np.sign(wrist))


def row(name: str, found: Sequence[Outcome]) -> str:
    """The line of a table."""
    counts = Counter(each.status for each in found)
    optimised = sum(count for status, count in counts.items() if status.ok)
    other = len(found) - optimised - counts[mp.Status.SINGULAR]
    seconds = [each.seconds for each in found]
    times = f"{np.median(seconds):.2f} s, {max(seconds):.2f} s" if found else ""
    return f"| {name} | {len(found)} | {counts[mp.Status.SINGULAR]} | {other} | {optimised} | {times} |"


def main(arguments: Sequence[str] | None = None) -> list[Outcome]:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--pairs", type=int, default=100)
    parser.add_argument("--out", type=Path, default=OUT, help="file of the table")
    given = parser.parse_args(arguments)
    robot = mp.load_robot("ur5")
    kinematics = robot.kinematics()
    mp.plan(robot, robot.neutral, robot.neutral + 0.1)  # compiles, which no row counts
    found = []
    for start, goal in track(list(pairs(robot, given.pairs)), description="planning"):
        one_aspect = aspect(kinematics, start) == aspect(kinematics, goal)
        began = time.perf_counter()
        plan = mp.plan(robot, start, goal, throw=False)
        seconds = time.perf_counter() - began
        found.append(Outcome(one_aspect=one_aspect, status=plan.status, seconds=seconds))
    lines = [
        "| random pairs of the UR5 | pairs | `SINGULAR` | seed or no path | optimised | wall time: median, worst |",
        "|---|---|---|---|---|---|",
        *(row(name, [each for each in found if each.one_aspect is same]) for same, name in ROWS.items()),
        row("all", found),
        "",
        f"Python {platform.python_version()}, {platform.machine()}; command: "
        f"`.venv/bin/python benchmarks/six_joint_arms.py --pairs {given.pairs}`.",
    ]
    given.out.parent.mkdir(parents=True, exist_ok=True)
    given.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))
    return found


if __name__ == "__main__":
    main()
