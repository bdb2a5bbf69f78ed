"""First paths of MotionBenchMaker's problems: our compiled searches, and those of OMPL on the same compiled check of motions.

Run with `make benchmark`. Start and goal of all problems that count are inside the limits and free; those whose straight line
is free need no search and do not count either. Where the arm has six joints, our RRT-Connect first looks for a path with few
crossings of singularities; OMPL only tells paths without crossings from others. All times but that limit are CPU times. Writes
docs/benchmarks/seeds.md.
"""

import argparse
import platform
import time
from collections import defaultdict
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from outside import problems
from rich.progress import track

import manipplan as mp
from manipplan.cost.crossings import least_crossings
from manipplan.kinematics.factors import singularity_signs
from manipplan.seeds import task
from manipplan.seeds.connect import TreeSearch
from manipplan.seeds.ompl import OmplSearch
from manipplan.seeds.task import SIGNS_STEP

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "seeds.md"
PLANNERS = {"auto": "ours", "RRTConnect": "OMPL's RRTConnect"}
#: Planners that lower g, their time limit per problem, which is wall time [s], and a number of checks that they do not reach.
OPTIMISING, SECONDS, CHECKS = ("connect-star", "BITstar"), 0.1, 50_000_000


@dataclass(frozen=True, kw_only=True)
class Outcome:
    """Of one problem and planner.

    Attributes:
        shelf: whether the arm reaches into a bookshelf.
        seconds: CPU time of the whole, with its proof.
        search: CPU time of the search alone, with what it does to shorten its path.
        proof: CPU time of the proofs.
        length: of the path [rad]; NaN where none was found.
        more: crossings of singularities above the lower bound; NaN for seven joints, and where no path was found.
        proven: the path is proven free on the whole curve.
    """

    shelf: bool
    seconds: float
    search: float
    proof: float
    length: float = np.nan
    more: float = np.nan
    proven: bool = False


class Clock:
    """CPU times of functions, whose names in their modules or classes it takes over."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = defaultdict(float)

    def watch(self, owner: Any, name: str, part: str) -> None:
        """Add the CPU time of each call to a part."""
        called: Callable[..., Any] = getattr(owner, name)

        def timed(*arguments: Any, **options: Any) -> Any:
            began = time.thread_time()
            try:
                return called(*arguments, **options)
            finally:
                self.seconds[part] += time.thread_time() - began

        setattr(owner, name, timed)


def outcome(robot: mp.Robot, problem: problems.Problem, planner: str, clock: Clock) -> Outcome:
    """The figures of one problem with one planner."""
    clock.seconds.clear()
    began, found, path = time.thread_time(), {}, None
    seeding = mp.Seeding(planner=planner)
    with suppress(mp.errors.PlanningError):
        path = mp.seed_path(robot, problem.start, problem.goal, problem.scene, fewest_crossings=True, seeding=seeding)
    seconds, parts = time.thread_time() - began, dict(clock.seconds)
    if path is not None:
        found = {"length": path.length, "proven": problem.scene.path_clearance(robot, path).proven}
        kinematics = robot.kinematics()
        signs = singularity_signs(kinematics)
        if signs is not None:
            changes = signs.changes(path(path.fine_samples(SIGNS_STEP)))
            found["more"] = changes - least_crossings(kinematics, problem.start, problem.goal)
    return Outcome(
        shelf=problem.set.startswith("bookshelf"),
        seconds=seconds,
        search=parts.get("search", 0.0),
        proof=parts.get("proof", 0.0),
        **found,
    )


def lowered(robot: mp.Robot, problem: problems.Problem, planner: str) -> float:
    """g of a planner's path after SECONDS, as a share of that of our RRT-Connect's path; NaN where it found none."""
    ends, objective = (problem.start, problem.goal, problem.scene), mp.PathObjective()
    integral = objective.integral(robot)
    first = integral.cost(mp.seed_path(robot, *ends)).g
    try:
        seeding = mp.Seeding(planner=planner, time_limit=SECONDS)
        path = mp.seed_path(robot, *ends, seeding=seeding, objective=objective, checks=CHECKS)
    except mp.errors.PlanningError:
        return np.nan
    return integral.cost(path).g / first


def needs_search(robot: mp.Robot, problem: problems.Problem) -> bool:
    """Whether start and goal are inside the limits and free, and the straight line is not."""
    ends = np.array([problem.start, problem.goal])
    inside = all((robot.limits.outside(q) <= 0).all() for q in ends)
    if not inside or problem.scene.in_collision(robot, ends).any():
        return False
    line = mp.JointPath.line(problem.start, problem.goal)
    return bool(problem.scene.in_collision(robot, line(line.fine_samples(0.01))).any())


def milliseconds(values: Sequence[float], *, worst: bool = True) -> str:
    """Median, 95 % and worst in a table."""
    cells = [np.median(values), np.quantile(values, 0.95), *([np.max(values)] if worst else [])]
    return " | ".join(f"{1e3 * value:.1f}" if value < 0.1 else f"{1e3 * value:.0f}" for value in cells)


def row(arm: str, planner: str, sets: str, found: Sequence[Outcome]) -> str:
    """The line of a table."""
    more, lengths = np.array([each.more for each in found]), np.array([each.length for each in found])
    fewest = "–" if np.isnan(more).all() else f"{(more == 0).sum()}"
    counts = f"{len(found)} | {np.isfinite(lengths).sum()} | {sum(each.proven for each in found)} | {fewest}"
    times = " | ".join(
        (
            milliseconds([each.search for each in found]),
            milliseconds([each.proof for each in found], worst=False),
            milliseconds([each.seconds for each in found]),
        )
    )
    return f"| {arm}, {planner}, {sets} | {counts} | {times} | {np.nanmean(lengths):.2f} |"


def ratio(arm: str, made: dict[tuple[str, str], list[Outcome]]) -> str:
    """How much faster our search is than OMPL's."""
    ours, other = (np.array([each.search for each in made[arm, name]]) for name in PLANNERS.values())
    return (
        f"{arm}: OMPL's RRTConnect takes {other.sum() / ours.sum():.1f} times the CPU time of ours for all problems together; "
        f"per problem {np.median(other / ours):.1f} times in the median, for the slowest 5 % "
        f"{np.quantile(other, 0.95) / np.quantile(ours, 0.95):.1f} times."
    )


def main(arguments: Sequence[str] | None = None) -> dict[tuple[str, str], list[Outcome]]:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--problems", type=int, default=8, help="number of problems of each set, at most 50")
    parser.add_argument("--out", type=Path, default=OUT, help="file of the table")
    given = parser.parse_args(arguments)
    clock = Clock()
    for owner, name, part in (
        (TreeSearch, "path", "search"),
        (OmplSearch, "run", "search"),
        (task, "path_clearance", "proof"),
    ):
        clock.watch(owner, name, part)
    made: dict[tuple[str, str], list[Outcome]] = defaultdict(list)
    shares: dict[tuple[str, str], list[float]] = defaultdict(list)
    for arm in ("panda", "ur5"):
        robot, sets = problems.robot(arm), defaultdict(list)
        for problem in problems.load(arm):
            sets[problem.set].append(problem)
        chosen = [problem for several in sets.values() for problem in several[: given.problems] if needs_search(robot, problem)]
        for planner in (*PLANNERS, *OPTIMISING):  # compiles and loads, which no row counts
            mp.seed_path(
                robot, chosen[0].start, chosen[0].goal, chosen[0].scene, seeding=mp.Seeding(planner=planner), checks=50_000
            )
        for problem in track(chosen, description=arm):
            for planner, name in PLANNERS.items():
                made[arm, name].append(outcome(robot, problem, planner, clock))
            for planner in OPTIMISING:
                shares[arm, planner].append(lowered(robot, problem, planner))
    lines = [
        "| arm, planner, sets | problems | paths | proven free | fewest crossings | search, CPU ms: median | 95 % | worst "
        "| proof: median | 95 % | in all: median | 95 % | worst | mean length, rad |",
        "|---" * 14 + "|",
    ]
    for (arm, planner), found in made.items():
        lines += [
            row(arm, planner, sets, [each for each in found if each.shelf in wanted])
            for sets, wanted in (("all", (True, False)), ("bookshelves", (True,)))
        ]
    lines += ["", *(f"- {ratio(arm, made)}" for arm in ("panda", "ur5")), ""]
    lines += [f"g after {SECONDS:g} s of wall time, as a share of that of our RRT-Connect's path:", ""]
    lines += ["| arm, planner | problems | paths | median | mean |", "|---" * 5 + "|"]
    for (arm, planner), values in shares.items():
        ok = np.array(values)[np.isfinite(values)]
        shares_of = f"{np.median(ok):.2f} | {ok.mean():.2f}" if len(ok) else "– | –"
        lines.append(f"| {arm}, {planner} | {len(values)} | {len(ok)} | {shares_of} |")
    lines += [
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
