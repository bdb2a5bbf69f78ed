"""Twenty random start-goal pairs of the Panda among five boxes: `mp.plan` against the simplified RRTConnect seed.

Run with `make benchmark`. Writes docs/benchmarks/panda_boxes.md and the table in README.md; times are of this machine,
ratios travel better.
"""

import platform
import time
from pathlib import Path

import numpy as np
from rich.progress import track

import manipplan as mp

PAIRS = 20
ROOT = Path(__file__).parents[1]
OUT = ROOT / "docs" / "benchmarks" / "panda_boxes.md"
README, BEGIN, END = ROOT / "README.md", "<!-- benchmark -->", "<!-- /benchmark -->"


def pairs(problem):
    rng = np.random.default_rng(7)
    found = 0
    while found < PAIRS:
        start, goal = problem.robot.random_configuration(rng, size=2)
        if problem.scene.in_collision(problem.robot, np.array([start, goal])).any():
            continue
        try:
            mp.seed_path(problem.robot, start, goal, problem.scene, seeding=mp.Seeding(time_limit=3.0))
        except mp.errors.PlanningError:
            continue
        found += 1
        yield start, goal


def main() -> None:
    problem = mp.demo.panda_among_boxes()
    began = time.perf_counter()
    mp.plan(problem.robot, problem.start, problem.goal, problem.scene)
    first = time.perf_counter() - began
    rows = []
    for start, goal in track(list(pairs(problem)), description="planning"):
        began = time.perf_counter()
        plan = mp.plan(problem.robot, start, goal, problem.scene)
        rows.append((time.perf_counter() - began, plan.status.name, plan.report))
    reports = [report for *_, report in rows]
    times = np.array([each for each, *_ in rows])
    ratio = np.array([report.g / report.seed_g for report in reports])
    least = np.array([report.min_manipulability / report.seed_min_manipulability for report in reports])
    worst = max(use.ratio for report in reports for kind, use in report.limits.items() if kind != "position")
    optimised = sum(plan_status in ("OPTIMAL", "STOPPED_EARLY") for _, plan_status, _ in rows)
    lines = [
        "| figure | value |",
        "|---|---|",
        f"| trajectories that are collision-free at 1 mrad | {sum(r.collision_free for r in reports)} of {PAIRS} |",
        f"| trajectories within their limits (worst ratio {worst:.7f}) | {sum(r.passed for r in reports)} of {PAIRS} |",
        f"| optimised; the rest are the safe seed, and say so | {optimised} of {PAIRS} |",
        f"| g over the simplified seed's g: median, worst | {np.median(ratio):.3f}, {ratio.max():.3f} |",
        f"| minimum manipulability over the seed's: worst, median, best | {least.min():.3g}, {np.median(least):.3g}, "
        f"{least.max():.3g} |",
        f"| wall time after the first call: median, worst | {np.median(times):.2f} s, {times.max():.2f} s |",
        f"| first call, with building programs | {first:.2f} s |",
        "",
        f"Python {platform.python_version()}, {platform.machine()}, two shared cores; command: `make benchmark`.",
    ]
    OUT.parent.mkdir(parents=True, exist_ok=True)
    OUT.write_text("\n".join(lines) + "\n")
    before, rest = README.read_text().split(BEGIN)
    README.write_text(f"{before}{BEGIN}\n" + "\n".join(lines) + f"\n{END}{rest.split(END)[1]}")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
