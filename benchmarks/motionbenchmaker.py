"""MotionBenchMaker's problems of an arm through `mp.plan`: what is solved, in what time, and how well.

Run with `make benchmark-peers`, which plans the first 8 of each set of the Panda and puts mplib's timed motions of the same
problems beside; `make benchmark` does the UR5's, without mplib. `--problems 50` plans all 350. Writes
docs/benchmarks/motionbenchmaker.md, for the UR5 motionbenchmaker_ur5.md, and a picture to docs/pictures/. The problems and
their licence: benchmarks/outside/README.md. Times are of this machine; the mesh check is no part of them.
"""

import argparse
import os
import platform
from collections import Counter, defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import numpy as np
from meshes import MeshModel
from motions import BESIDE, ENVIRONMENTS, Motion, beside, of_mplib, of_ours, spread
from outside import problems
from rich.progress import track

import manipplan as mp
from manipplan.viz.style import ARM, OPTIMUM, SEED, STRAIGHT, shared

DOCS = Path(__file__).parents[1] / "docs"
OUT = {"panda": DOCS / "benchmarks" / "motionbenchmaker.md", "ur5": DOCS / "benchmarks" / "motionbenchmaker_ur5.md"}
PICTURE = {arm: DOCS / "pictures" / f"{out.stem}.png" for arm, out in OUT.items()}
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
        problem: which one.
        result: one of BEYOND, TOUCHES and OUTCOMES.
        motion: what `mp.plan` made of it; None where it was refused.
        meshes_free: of one that is not free, whether the meshes of the arm touch no obstacle.
    """

    problem: problems.Problem
    result: str
    motion: Motion | None = None
    meshes_free: bool = False

    @property
    def good(self) -> bool:
        """The motion was returned, is proven and free by the meshes."""
        return self.result in SOLVED and self.motion is not None and self.motion.proven and self.motion.free


def refusal(robot: mp.Robot, problem: problems.Problem) -> Outcome | None:
    """Why `mp.plan` does not accept a start or a goal; None where it does."""
    ends = np.array([problem.start, problem.goal])
    if (robot.limits.outside(ends) > 0).any():
        return Outcome(problem=problem, result=BEYOND)
    touching = ends[problem.scene.in_collision(robot, ends)]
    if len(touching):
        return Outcome(problem=problem, result=TOUCHES, meshes_free=MeshModel(robot, problem.scene).is_free(touching))
    return None


def outcome(robot: mp.Robot, problem: problems.Problem) -> Outcome:
    """What `mp.plan` makes of a problem."""
    refused = refusal(robot, problem)
    if refused is not None:
        return refused
    motion = of_ours(robot, problem)
    [result] = [name for name, statuses in OUTCOMES.items() if motion.status in statuses]
    return Outcome(problem=problem, result=result, motion=motion)


def becomes(name: str, found: Sequence[Outcome]) -> str:
    """The line of a set in the table of what becomes of the problems."""
    counts = Counter(each.result for each in found)
    refused = f"{counts[BEYOND]} | {counts[TOUCHES]} | {sum(each.meshes_free for each in found)}"
    results = " | ".join(str(counts[each]) for each in OUTCOMES)
    return f"| {name} | {len(found)} | {refused} | {results} |"


def figures(name: str, found: Sequence[Outcome]) -> str:
    """The line of a set in the table of times and qualities."""
    planned = [each.motion for each in found if each.motion is not None]
    solved = [each.motion for each in found if each.result in SOLVED and each.motion is not None]
    g = [each.over_seed for each in solved if np.isfinite(each.over_seed)]
    least = [each.least_over_seed for each in solved if np.isfinite(each.least_over_seed)]
    cells = [
        f"{len(solved)} of {len(planned)}",
        f"{sum(each.proven for each in solved)}",
        f"{sum(each.free for each in solved)}",
        spread([each.seconds for each in planned]),
        spread([each.cpu for each in planned]),
        spread([each.seed_cpu for each in solved]),
        f"{np.median(g):.2f}, {np.quantile(g, 0.95):.2f}" if g else "",
        f"{np.median(least):.2f}, {np.quantile(least, 0.05):.2f}" if least else "",
    ]
    return f"| {name} | {' | '.join(cells)} |"


def tables(found: Sequence[Outcome]) -> list[str]:
    """Both tables, with a line per set and one for all, and the sentence that sums them up."""
    by_set = grouped(found)
    solved = [each for each in found if each.result in SOLVED]
    optimised = sum(each.result in OPTIMISED for each in found)
    inside = [each.motion for each in found if each.motion is not None]
    return [
        f"| set | problems | refused: {BEYOND} | refused: {TOUCHES} | of these free by the meshes | {' | '.join(OUTCOMES)} |",
        "|---" * (5 + len(OUTCOMES)) + "|",
        *(becomes(name, each) for name, each in by_set.items()),
        becomes("all", found),
        "",
        "| set | solved, of those planned | proven | free by the meshes | wall time: median, 95 % "
        "| processor time: median, 95 % | first path, processor time: median, 95 % | g over the first path's: median, 95 % "
        "| minimum manipulability over the first path's: median, 5 % |",
        "|---" * 9 + "|",
        *(figures(name, each) for name, each in by_set.items()),
        figures("all", found),
        "",
        f"{len(solved)} of {len(found)} get a motion, {optimised} an optimised one; {sum(each.good for each in found)} of the "
        f"{len(inside)} inside the limits get one that is proven, and free by the meshes at 1 mrad. Wall time, median and "
        f"95 %: {spread([each.seconds for each in inside])}.",
    ]


def grouped(found: Sequence[Outcome]) -> dict[str, list[Outcome]]:
    """The outcomes of each set."""
    by_set: dict[str, list[Outcome]] = defaultdict(list)
    for each in found:
        by_set[each.problem.set].append(each)
    return by_set


def compared(found: Sequence[Outcome], theirs: Sequence[Motion]) -> list[str]:
    """The table beside a peer's motions of the problems that were planned, in the same order."""
    planned = [each for each in found if each.motion is not None]
    of_set: dict[str, list[int]] = defaultdict(list)
    for k, each in enumerate(planned):
        of_set[each.problem.set].append(k)
    sets = dict(of_set) | {"all": list(range(len(planned)))}
    return [
        f"| set | {' | '.join(BESIDE)} |",
        "|---" * (1 + len(BESIDE)) + "|",
        *(
            f"| {name} | {beside([planned[k].motion for k in places], [theirs[k] for k in places])} |"
            for name, places in sets.items()
        ),
    ]


def draw(found: Sequence[Outcome], theirs: Sequence[Motion], file: Path) -> None:
    """The picture: for each set the times of all problems, and g over that of the first path and of mplib's motion."""
    import matplotlib as mpl

    mpl.use("agg")
    import matplotlib.pyplot as plt
    from matplotlib.ticker import LogLocator, NullFormatter

    planned = [each for each in found if each.motion is not None]
    sets = list(dict.fromkeys(each.problem.set for each in planned))
    rng = np.random.default_rng(0)
    with shared():
        figure, axes = plt.subplots(
            1, 2 + bool(theirs), figsize=(9.2, 0.42 * len(sets) + 1.5), sharey=True, layout="constrained"
        )
        series = [
            ("wall time of mp.plan [s]", [each.motion.seconds for each in planned], OPTIMUM, "log"),
            ("g over the first path's", [each.motion.over_seed for each in planned], SEED, "linear"),
        ]
        if theirs:
            ratios = [a.motion.g / b.g if b.found and a.motion.found else np.nan for a, b in zip(planned, theirs, strict=True)]
            series.append(("g over that of mplib's motion", ratios, ARM, "linear"))
        for ax, (label, values, colour, scale) in zip(axes, series, strict=True):
            ax.set_xscale(scale)
            for place, name in enumerate(sets):
                some = np.array([v for v, each in zip(values, planned, strict=True) if each.problem.set == name], float)
                some = some[np.isfinite(some)]
                ax.scatter(some, place + rng.uniform(-0.22, 0.22, len(some)), s=11, color=colour, alpha=0.55, linewidths=0)
                if len(some):
                    ax.plot([np.median(some)] * 2, [place - 0.36, place + 0.36], color=colour, linewidth=2.2)
            if scale == "linear":
                ax.axvline(1.0, color=STRAIGHT, linewidth=1.0, linestyle="--", zorder=0)
                ax.set_xlim(left=0.0)
            else:
                ax.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
                ax.xaxis.set_major_formatter("{x:g}")
                ax.xaxis.set_minor_formatter(NullFormatter())
            ax.set(xlabel=label, yticks=range(len(sets)), yticklabels=sets)
            ax.grid(axis="y", visible=False)
            ax.tick_params(axis="y", length=0)
        axes[0].invert_yaxis()
        figure.get_layout_engine().set(wspace=0.05)
        file.parent.mkdir(parents=True, exist_ok=True)
        figure.savefig(file, dpi=130)
        plt.close(figure)


def main(arguments: Sequence[str] | None = None) -> list[Outcome]:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--problems", type=int, default=8, help="number of problems of each set, at most 50")
    parser.add_argument("--arm", choices=tuple(OUT), default="panda", help="whose problems")
    parser.add_argument("--peers", nargs="*", choices=("mplib",), default=(), help="whose motions are put beside")
    parser.add_argument("--environments", type=Path, default=ENVIRONMENTS, help="folder of the peers' environments")
    parser.add_argument("--out", type=Path, help="file of the tables")
    parser.add_argument("--picture", type=Path, help="file of the picture")
    given = parser.parse_args(arguments)
    out = OUT[given.arm] if given.out is None else given.out
    picture = PICTURE[given.arm] if given.picture is None else given.picture
    every, robot = problems.load(given.arm), problems.robot(given.arm)
    by_set: dict[str, list[problems.Problem]] = defaultdict(list)
    for problem in every:
        by_set[problem.set].append(problem)
    chosen = [problem for of_set in by_set.values() for problem in of_set[: given.problems]]
    refused = [each for each in (refusal(robot, problem) for problem in every) if each is not None]
    counts = Counter(each.result for each in refused)
    mp.plan(robot, robot.neutral, robot.neutral + 0.1)  # compiles, which no row counts
    found = [outcome(robot, problem) for problem in track(chosen, description="planning")]
    lines, theirs = tables(found), []
    if "mplib" in given.peers:
        accepted = [each.problem for each in found if each.motion is not None]
        theirs = of_mplib(
            robot, accepted, environments=given.environments, notify=lambda some: track(some, description="judging mplib")
        )
        lines += ["", "Beside mplib 0.2.1:", "", *compared(found, theirs)]
    draw(found, theirs, picture)
    lines += [
        "",
        f"Of all {len(every)} problems {len(refused)} are refused before any planning: {counts[BEYOND]} with an end {BEYOND}, "
        f"{counts[TOUCHES]} with an end that is {TOUCHES}. "
        f"The meshes of the links touch nothing in {sum(each.meshes_free for each in refused)} of these {counts[TOUCHES]}.",
        "",
        f"The first {given.problems} of each set; Python {platform.python_version()}, {platform.machine()}; command: "
        f"`.venv/bin/python benchmarks/motionbenchmaker.py --arm {given.arm} --problems {given.problems}"
        f"{' --peers ' + ' '.join(given.peers) if given.peers else ''}`.",
    ]
    out.parent.mkdir(parents=True, exist_ok=True)
    out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))
    return found


if __name__ == "__main__":
    main()
