"""Many plans: 1,000 problems by `mp.plan_many` on one process and on two, without obstacles and among them.

Run with `make benchmark`. Writes docs/benchmarks/plan_many.md. Without obstacles: random pairs of the Panda, as in
panda_pairs.py. Among obstacles: MotionBenchMaker's 350 problems of the Panda (outside/), each with a scene of its own, then the
same from goal to start, then the first ones with another seed of the planner. One process and two plan the same problems, one
after the other. The call without an executor is timed on the first problems only, beside one process on the same.
"""

import argparse
import hashlib
import os
import platform
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from outside import problems as outside

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "plan_many.md"
#: Number of problems, and of those that are planned without an executor as well.
PROBLEMS, FIRST = 1000, 100
#: Who plans, and the executor.
ONE, TWO = ("one process", 1), ("two processes", 2)
HERE, BRIEF = ("without an executor", None), ("one process, first ones", 1)


@dataclass(frozen=True, kw_only=True)
class Run:
    """One call of plan_many: wall time [s], statuses, and a digest of each motion's numbers."""

    kind: str
    who: str
    problems: int
    seconds: float
    statuses: Counter
    digests: Sequence[str]


def without_obstacles(number: int) -> list[mp.Problem]:
    robot, rng = mp.load_robot("panda"), np.random.default_rng(2012)
    pairs = [robot.random_configuration(rng, size=2) for _ in range(number)]
    return [mp.Problem(robot=robot, start=start, goal=goal) for start, goal in pairs]


def among_obstacles(number: int) -> list[mp.Problem]:
    robot, given = outside.robot("panda"), outside.load("panda")

    order = np.random.default_rng(2012).permutation(len(given))  # the first ones are of every set

    def problem(k: int) -> mp.Problem:
        turn, each = k // len(given), given[order[k % len(given)]]
        ends = {"start": each.start, "goal": each.goal} if turn % 2 == 0 else {"start": each.goal, "goal": each.start}
        return mp.Problem(robot=robot, scene=each.scene, seeding=mp.Seeding(seed=turn // 2), **ends)

    return [problem(k) for k in range(number)]


KINDS = {"without obstacles": without_obstacles, "among obstacles": among_obstacles}


def digest(plan: mp.results.PartialPlan) -> str:
    numbers = b"" if plan.trajectory is None else plan.trajectory.t.tobytes() + plan.trajectory.q.tobytes()
    return hashlib.sha256(plan.status.name.encode() + numbers).hexdigest()


def run(kind: str, problems: Sequence[mp.Problem], who: tuple[str, int | None]) -> Run:
    name, executor = who
    began = time.perf_counter()
    plans = mp.plan_many(problems, executor)
    seconds = time.perf_counter() - began
    statuses = Counter(plan.status.name for plan in plans)
    print(f"{kind}, {name}: {len(problems)} problems, {seconds:.0f} s, load {os.getloadavg()[0]:.1f}", flush=True)
    digests = [digest(plan) for plan in plans]
    return Run(kind=kind, who=name, problems=len(problems), seconds=seconds, statuses=statuses, digests=digests)


def row(found: Sequence[Run]) -> str:
    by = {each.who: each for each in found}
    one, two, here, brief = (by[name] for name, _ in (ONE, TWO, HERE, BRIEF))
    same = sum(len(set(each)) == 1 for each in zip(one.digests, two.digests, strict=True))
    told = ", ".join(f"{number} {name}" for name, number in one.statuses.most_common())
    cells = [
        one.kind,
        f"{one.problems}",
        f"{one.seconds:.0f} s",
        f"{two.seconds:.0f} s",
        f"**{one.seconds / two.seconds:.2f}**",
        f"{1e3 * two.seconds / two.problems:.0f} ms",
        f"{here.seconds / brief.seconds:.2f}",
        f"{same} of {one.problems}",
        told,
    ]
    return f"| {' | '.join(cells)} |"


def main(arguments: Sequence[str] | None = None) -> list[Run]:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--problems", type=int, default=PROBLEMS)
    parser.add_argument("--out", type=Path, default=OUT)
    options = parser.parse_args(arguments)
    lines = [
        "| problems of the Panda | number | one process | two processes | one over two | per problem, two | "
        "without an executor, over one process | same motion to the last bit | statuses |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    runs, before = [], os.getloadavg()[0]
    for kind, make in KINDS.items():
        problems = make(options.problems)
        found = [run(kind, problems, who) for who in (ONE, TWO)] + [run(kind, problems[:FIRST], who) for who in (HERE, BRIEF)]
        lines.append(row(found))
        runs += found
    machine = f"Python {platform.python_version()}, {platform.machine()}, {os.cpu_count()} shared cores"
    load = f"load average {before:.1f} before, {os.getloadavg()[0]:.1f} after"
    lines += ["", f"Wall time, with the start of the processes; {load}. {machine}; command: `make benchmark`."]
    options.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))
    return runs


if __name__ == "__main__":
    main()
