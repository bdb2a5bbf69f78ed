"""MotionBenchMaker's problems of an arm through `mp.plan`: how many are refused, solved and optimised, and in what time.

Run with `make benchmark`, which plans the first 8 of each set of the Panda and of the UR5; `--problems 50` plans all 350.
Writes docs/benchmarks/motionbenchmaker.md, for the UR5 motionbenchmaker_ur5.md. The problems and their licence:
benchmarks/outside/README.md. Times are wall times of this machine.
"""

import argparse
import platform
import time
from collections import Counter, defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import coal
import numpy as np
import pinocchio as pin
from outside import problems
from rich.progress import track

import manipplan as mp

TABLES = Path(__file__).parents[1] / "docs" / "benchmarks"
OUT = {"panda": TABLES / "motionbenchmaker.md", "ur5": TABLES / "motionbenchmaker_ur5.md"}
BEYOND, TOUCHES = "beyond a joint limit", "not free"
#: What becomes of a problem: the column's head, and the statuses that count there.
OUTCOMES = {
    "no path": ("NO_PATH",),
    "singular": ("SINGULAR",),
    "seed, timed": ("SEED_IS_SAFE", "SEED_IS_BETTER"),
    "optimised, stopped early": ("STOPPED_EARLY",),
    "optimised, converged": ("OPTIMAL",),
    "failed": ("NO_TIMING", "CHECK_FAILED"),
}
OPTIMISED = ("optimised, stopped early", "optimised, converged")
SOLVED = tuple(name for name in OUTCOMES if name not in ("no path", "failed"))


@dataclass(frozen=True, kw_only=True)
class Outcome:
    """What became of one problem.

    Attributes:
        set, result: its set, and one of BEYOND, TOUCHES and OUTCOMES.
        seconds: wall time of `mp.plan`; NaN where it was refused.
        ratio: g over the seed's; NaN where there is no motion.
        proven: the motion is proven free of collision between all samples.
        meshes_free: of one that is not free, whether the meshes of the arm touch no obstacle.
    """

    set: str
    result: str
    seconds: float = np.nan
    ratio: float = np.nan
    proven: bool = False
    meshes_free: bool = False


def free_by_meshes(robot: mp.Robot, scene: mp.Scene, q: np.ndarray) -> bool:
    """Whether no mesh of a moving link touches an obstacle at q."""
    data, placed = robot.model.createData(), robot.geometry.createData()
    pin.updateGeometryPlacements(robot.model, data, robot.geometry, placed, q)
    for link, pose in zip(robot.geometry.geometryObjects, placed.oMg, strict=True):
        if link.parentJoint == 0:
            continue  # the base stands where it stands
        at = coal.Transform3s(pose.rotation, pose.translation)
        for obstacle in scene.obstacles:
            there = coal.Transform3s(obstacle.pose.rotation, obstacle.pose.translation)
            for shape in obstacle.shapes():
                if coal.collide(link.geometry, at, shape, there, coal.CollisionRequest(), coal.CollisionResult()):
                    return False
    return True


def refusal(robot: mp.Robot, problem: problems.Problem) -> Outcome | None:
    """Why `mp.plan` does not accept a start or a goal; None where it does."""
    ends = np.array([problem.start, problem.goal])
    if (robot.limits.outside(ends) > 0).any():
        return Outcome(set=problem.set, result=BEYOND)
    touching = ends[problem.scene.in_collision(robot, ends)]
    if len(touching):
        meshes = all(free_by_meshes(robot, problem.scene, q) for q in touching)
        return Outcome(set=problem.set, result=TOUCHES, meshes_free=meshes)
    return None


def outcome(robot: mp.Robot, problem: problems.Problem) -> Outcome:
    """What `mp.plan` makes of a problem."""
    refused = refusal(robot, problem)
    if refused is not None:
        return refused
    began = time.perf_counter()
    plan = mp.plan(robot, problem.start, problem.goal, problem.scene, throw=False)
    seconds = time.perf_counter() - began
    [result] = [name for name, statuses in OUTCOMES.items() if plan.status.name in statuses]
    ratio = plan.report.g / plan.report.seed_g if result in SOLVED and plan.report is not None else np.nan
    proven = result in SOLVED and plan.report is not None and plan.report.proven_clearance >= 0
    return Outcome(set=problem.set, result=result, seconds=seconds, ratio=ratio, proven=proven)


def row(name: str, found: Sequence[Outcome]) -> str:
    """The line of a table."""
    counts = Counter(each.result for each in found)
    refused = f"{counts[BEYOND]} | {counts[TOUCHES]} | {sum(each.meshes_free for each in found)}"
    seconds = np.array([each.seconds for each in found if np.isfinite(each.seconds)])
    ratios = np.array([each.ratio for each in found if np.isfinite(each.ratio)])
    times = f"{np.median(seconds):.1f} s, {seconds.max():.1f} s" if len(seconds) else ""
    gains = f"{np.median(ratios):.2f}, {ratios.max():.2f}" if len(ratios) else ""
    results = " | ".join(str(counts[each]) for each in OUTCOMES)
    return f"| {name} | {len(found)} | {refused} | {results} | {times} | {gains} |"


def main(arguments: Sequence[str] | None = None) -> list[Outcome]:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--problems", type=int, default=8, help="number of problems of each set, at most 50")
    parser.add_argument("--arm", choices=tuple(OUT), default="panda", help="whose problems")
    parser.add_argument("--out", type=Path, help="file of the table")
    given = parser.parse_args(arguments)
    out = OUT[given.arm] if given.out is None else given.out
    every, robot = problems.load(given.arm), problems.robot(given.arm)
    by_set: dict[str, list[problems.Problem]] = defaultdict(list)
    for problem in every:
        by_set[problem.set].append(problem)
    chosen = [problem for of_set in by_set.values() for problem in of_set[: given.problems]]
    refused = [each for each in (refusal(robot, problem) for problem in every) if each is not None]
    counts = Counter(each.result for each in refused)
    mp.plan(robot, robot.neutral, robot.neutral + 0.1)  # compiles, which no row counts
    found = [outcome(robot, problem) for problem in track(chosen, description="planning")]
    solved, optimised = (sum(each.result in names for each in found) for names in (SOLVED, OPTIMISED))
    proven = sum(each.proven for each in found)
    lines = [
        f"| set | problems | refused: {BEYOND} | refused: {TOUCHES} | of these free by the meshes | {' | '.join(OUTCOMES)} "
        "| wall time: median, worst | g over the seed's: median, worst |",
        "|---" * (7 + len(OUTCOMES)) + "|",
        *(row(name, [each for each in found if each.set == name]) for name in by_set),
        row("all", found),
        "",
        f"{solved} of {len(found)} get a motion, {proven} a proven one, and {optimised} an optimised one.",
        "",
        f"Of all {len(every)} problems {len(refused)} are refused before any planning: {counts[BEYOND]} with an end {BEYOND}, "
        f"{counts[TOUCHES]} with an end that is {TOUCHES}. "
        f"The meshes of the links touch nothing in {sum(each.meshes_free for each in refused)} of these {counts[TOUCHES]}.",
        "",
        f"The first {given.problems} of each set; Python {platform.python_version()}, {platform.machine()}; command: "
        f"`.venv/bin/python benchmarks/motionbenchmaker.py --arm {given.arm} --problems {given.problems}`.",
    ]
    out.parent.mkdir(parents=True, exist_ok=True)
    out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))
    return found


if __name__ == "__main__":
    main()
