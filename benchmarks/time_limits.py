"""How well `mp.plan` keeps its time limit and how soon it ends after an interrupt, on MotionBenchMaker's problems of the Panda.

Run with `make benchmark`. Writes docs/benchmarks/time_limits.md. What is built once per robot or scene is there before a
problem is timed. Interrupts are SIGINT at random times of a plan; the time is that from the signal to KeyboardInterrupt.
"""

import argparse
import os
import platform
import signal
import threading
import time
from collections.abc import Sequence
from pathlib import Path

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import numpy as np
from outside import problems
from rich.progress import track

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "time_limits.md"
LIMITS = (0.1, 0.2, 0.5, 1.0, 10.0)
#: Number of interrupts of each problem.
INTERRUPTS = 3


def chosen(robot: mp.Robot, count: int) -> list[problems.Problem]:
    """The first problems of each set that are inside the limits."""
    by_set: dict[str, list[problems.Problem]] = {}
    for each in problems.load("panda"):
        if not (robot.limits.outside(np.array([each.start, each.goal])) > 0).any():
            by_set.setdefault(each.set, []).append(each)
    return [each for some in by_set.values() for each in some[:count]]


def planned(robot: mp.Robot, problem: problems.Problem, limit: float) -> tuple[float, mp.Plan]:
    """The wall time of a plan with a time limit [s], and the plan."""
    began = time.perf_counter()
    plan = mp.plan(robot, problem.start, problem.goal, problem.scene, seeding=mp.Seeding(time_limit=limit), throw=False)
    return time.perf_counter() - began, plan


def limited(robot: mp.Robot, work: Sequence[problems.Problem], limit: float) -> str:
    """The line of a time limit."""
    rows = [planned(robot, each, limit) for each in track(work, description=f"limit {limit:g} s")]
    over = np.array([seconds / limit for seconds, _ in rows])
    plans = [plan for _, plan in rows if plan.report is not None]
    passed = sum(plan.report.passed for plan in plans)
    g = [plan.report.g / plan.report.seed_g for plan in plans if np.isfinite(plan.report.seed_g)]
    optimal = sum(plan.status is mp.Status.OPTIMAL for plan in plans)
    return (
        f"| {limit:g} s | {100 * np.median(over):.0f} %, {100 * over.max():.0f} % | {(over > 1.1).sum()} of {len(rows)} "
        f"| {passed} of {len(rows)} | {optimal} | {np.median(g):.2f} |"
    )


def interrupted(robot: mp.Robot, problem: problems.Problem, usual: float, rng: np.random.Generator) -> float | None:
    """The time from an interrupt to KeyboardInterrupt [s]; None if the plan had ended before."""
    sent: list[float] = []

    def interrupt() -> None:
        sent.append(time.perf_counter())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(rng.uniform(0.0, 0.95) * usual, interrupt)
    try:
        timer.start()
        mp.plan(robot, problem.start, problem.goal, problem.scene, throw=False)
        timer.cancel()
        timer.join()
    except KeyboardInterrupt:
        return time.perf_counter() - sent[0]
    return None


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--problems", type=int, default=4, help="number of problems of each set")
    parser.add_argument("--out", type=Path, default=OUT, help="the table's file")
    options = parser.parse_args(arguments)
    robot = problems.robot("panda")
    work = chosen(robot, options.problems)
    usual = [planned(robot, each, 100.0)[0] for each in track(work, description="without a limit")]
    lines = [
        "| time limit | time over the limit: median, worst | over 110 % | plans that passed every check | of these OPTIMAL "
        "| g over the first path's, median |",
        "|---" * 6 + "|",
        *(limited(robot, work, limit) for limit in LIMITS),
        "",
    ]
    rng = np.random.default_rng(0)
    tried = [
        interrupted(robot, each, seconds, rng) for _ in range(INTERRUPTS) for each, seconds in zip(work, usual, strict=True)
    ]
    ms = 1e3 * np.array([each for each in tried if each is not None])
    lines += [
        f"Time from an interrupt to KeyboardInterrupt, {len(ms)} interrupts: median {np.median(ms):.0f} ms, "
        f"worst {ms.max():.0f} ms.",
        "",
        f"{len(work)} problems of MotionBenchMaker, the first {options.problems} of each set. Wall time; "
        f"Python {platform.python_version()}, {platform.machine()}; command: `make benchmark`.",
    ]
    options.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
