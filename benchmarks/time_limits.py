"""How well jobs keep their time limit and how soon they end after an interrupt.

`mp.plan` on MotionBenchMaker's problems of the Panda; `mp.follow` on paths for an arm of Fetch's geometry to 0.1 mm and 0.1°;
`mp.sequence` on programs of programs.py; `mp.carry` with Baxter's arms and a tray.

Run with `make benchmark`. Writes docs/benchmarks/time_limits.md. What is built once per robot or scene is there before a
problem is timed. Interrupts are SIGINT at random times of a plan; the time is that from the signal to KeyboardInterrupt.
"""

import argparse
import os
import platform
import signal
import threading
import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import numpy as np
import programs
from outside import problems, tool_paths
from rich.progress import track
from scipy.spatial.transform import Rotation

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "time_limits.md"
LIMITS = (0.1, 0.2, 0.5, 1.0, 10.0)
#: The same for other jobs.
JOB_LIMITS = (0.5, 1.0, 2.0, 4.0, 8.0)
#: Number of interrupts of each problem.
INTERRUPTS = 3
#: Paths for the arm of Fetch's geometry, and number of programs.
PATHS, PROGRAMS = ("fetch_arm__circle", "fetch_arm__hello", "fetch_arm__rot_yz"), 3
#: A job with a time limit [s].
Job = Callable[[float | None], "mp.Plan | mp.results.PartialPlan | mp.Program"]


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


def following() -> list[Job]:
    """Follow paths."""
    close = mp.Tolerance(position=1e-4, rotation=np.deg2rad(0.1))
    paths = [each for each in tool_paths.load() if each.name.removeprefix("like ") in PATHS]
    return [
        lambda limit, at=at: mp.follow(at.robot, at.path, at.scene, tolerance=close, time_limit=limit, throw=False)
        for at in paths
    ]


def programmed() -> list[Job]:
    """Programs of three arms."""
    rng, jobs = np.random.default_rng(1), list[Job]()
    for name in list(programs.ARMS)[:PROGRAMS]:
        robot = mp.load_robot(name, locked=programs.OPEN if name == "panda" else {})
        steps, scene = programs.problem(robot, name, "shelf", rng, of_part=True)

        def make(limit: float | None, robot: mp.Robot = robot, steps: list = steps, scene: mp.Scene = scene) -> mp.Program:
            return mp.sequence(robot, robot.neutral, steps, scene, blend=programs.BLEND, time_limit=limit)

        jobs.append(make)
    return jobs


def carrying() -> Job:
    """Carry a tray."""
    grasps = {}
    for side, tool in ((1, "left_gripper"), (-1, "right_gripper")):
        grasps[tool] = np.eye(4)
        turned = Rotation.from_euler("x", np.pi - side * np.pi / 4) * Rotation.from_euler("z", side * np.pi / 2)
        grasps[tool][:3, :3], grasps[tool][:3, 3] = turned.as_matrix(), (0.0, 0.22 * side, 0.02)
    begin, end = np.eye(4), np.eye(4)
    begin[:3, 3], end[:3, 3] = (0.6, -0.05, 0.05), (0.65, 0.05, 0.15)
    robot = mp.load_robot("baxter")
    return lambda limit: mp.carry(robot, mp.CartesianPath.line(begin, end), grasps, time_limit=limit, throw=False)


def job_lines(name: str, jobs: Sequence[Job]) -> list[str]:
    """The lines of some jobs: how long they take without a limit, and with each."""
    rows = []
    for limit in (None, None, *JOB_LIMITS):  # what is built once is there after the first
        seconds, found, least = [], 0, []
        for job in jobs:
            began, made = time.perf_counter(), None
            with suppress(mp.errors.PlanningError):
                made = job(limit)
            seconds.append(time.perf_counter() - began)
            if isinstance(made, mp.Program | mp.Plan):
                found += 1
                least.append(made.min_manipulability if isinstance(made, mp.Program) else made.report.min_manipulability)
        over = [f"{100 * each / limit:.0f} %" for each in seconds] if limit else [f"{each:.2f} s" for each in seconds]
        m = f"{np.mean(least):.4f}" if least else ""
        text = "none" if limit is None else f"{limit:g} s"
        rows.append(f"| {name} | {text} | {', '.join(over)} | {found} of {len(jobs)} | {m} |")
    return rows[1:]


def interrupted(run: Callable[[], object], usual: float, rng: np.random.Generator) -> float | None:
    """The time from an interrupt to KeyboardInterrupt [s]; None if the job had ended before."""
    sent: list[float] = []

    def interrupt() -> None:
        sent.append(time.perf_counter())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(rng.uniform(0.0, 0.95) * usual, interrupt)
    try:
        timer.start()
        run()
        timer.cancel()
        timer.join()
    except KeyboardInterrupt:
        return time.perf_counter() - sent[0]
    return None


def interrupts(name: str, tried: Sequence[float | None]) -> str:
    """How long a job went on after interrupts."""
    ms = 1e3 * np.array([each for each in tried if each is not None])
    worst = f": median {np.median(ms):.0f} ms, worst {ms.max():.0f} ms" if len(ms) else ""
    return f"{name}: time from an interrupt to KeyboardInterrupt, {len(ms)} interrupts{worst}."


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--problems", type=int, default=4, help="number of problems of each set")
    parser.add_argument("--out", type=Path, default=OUT, help="the table's file")
    options = parser.parse_args(arguments)
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a job in the background of a shell ignores interrupts
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
        interrupted(lambda each=each: mp.plan(robot, each.start, each.goal, each.scene, throw=False), seconds, rng)
        for _ in range(INTERRUPTS)
        for each, seconds in zip(work, usual, strict=True)
    ]
    lines += [interrupts("plan", tried), ""]
    lines += ["| job | limit | time: without a limit, or share of it | found | mean of the minima |", "|---" * 5 + "|"]
    jobs = {"follow": following(), "sequence": programmed(), "carry": [carrying()]}
    for name, some in jobs.items():
        lines += job_lines(name, some)
    lines += [""]
    for name, some in jobs.items():
        taken = []
        for job in some:
            began = time.perf_counter()
            job(None)
            seconds = time.perf_counter() - began
            taken += [interrupted(lambda job=job: job(None), seconds, rng) for _ in range(INTERRUPTS)]
        lines += [interrupts(name, taken), ""]
    lines += [
        f"{len(work)} problems of MotionBenchMaker, the first {options.problems} of each set. Wall time, also of what is "
        f"built once, which the limits do not count: here for the arm with each part that a program picks up; "
        f"Python {platform.python_version()}, {platform.machine()}; command: `make benchmark`.",
    ]
    options.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
