"""Times of single calls beside version 0.1, whose checkout `--old` names: `git worktree add PATH 6f9afba`.

One worker process per version has everything built; they take turns call by call, so that a slow moment of the machine meets
both. The figure is the median over the rounds of the ratio of the two times. `mp.plan` is measured by convergence.py, and the
import by import_time.py. Writes docs/benchmarks/version_01.md.
"""

import argparse
import json
import platform
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from convergence import ROOT, Worker, no_package, speaker
from rich.progress import track

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "version_01.md"
START = np.array([0.0, -0.3, 0.0, -2.2, 0.0, 2.0, np.pi / 4])
GOAL = np.array([0.9, 0.2, -0.2, -2.1, 0.3, 2.2, 0.8])
#: Wanted: at most this ratio.
MOST = 1.05
#: Share of the rounds whose times count: on a shared machine the others are lengthened by other work.
QUIET = 0.1
#: Each timing repeats a call for about this time [s].
LONG = 0.1
Call = Callable[[], object]


# The worker: it uses only names that version 0.1 has, too.


def calls() -> dict[str, Call]:
    """What is timed, with everything built that a first call builds."""
    robot = mp.load_robot("panda")
    q, many = START, robot.random_configuration(np.random.default_rng(1), size=100_000)
    kinematics = robot.kinematics(mp.Task.pose(length=0.5))
    step, hessian = kinematics.evaluator("jacobian", "manipulability", "gradient"), kinematics.evaluator("hessian")
    formulations = getattr(mp, "formulations", mp)  # version 0.1 has them at the top
    controller = mp.Controller(robot, formulations.LogDrive(), dt=0.01)
    pose = robot.kinematics().pose(START)
    target = pose.copy()
    target[1, 3] += 1e-3
    spheres = [mp.Sphere(radius=0.05, position=(0.6, 0.2 * k - 0.4, 0.1), name=f"ball{k}") for k in range(5)]
    scene = mp.Scene(spheres)
    path = mp.JointPath.through(np.stack([START, (START + GOAL) / 2 + 0.2, GOAL]))
    away = pose.copy()
    away[1, 3] += 0.2
    tool = mp.CartesianPath.line(pose, away)
    layers = mp.sample_layers(robot, tool, 30, samples=24)
    without_jerk = replace(robot.limits, jerk=np.full(robot.n, np.inf))

    def retime(limits: mp.JointLimits) -> object:
        return mp.retime(path, robot, limits=limits) if hasattr(mp, "PathObjective") else mp.retime(path, limits)

    return {
        "J, m, ∇m of one configuration": lambda: step(q),
        "Hessian of m, one configuration": lambda: hessian(q),
        "m of 100,000 configurations": lambda: kinematics.manipulability(many),
        "tool pose of 100,000 configurations": lambda: kinematics.pose(many),
        "control step": lambda: controller.step(START, np.zeros(7), target),
        "all configurations of a pose": lambda: mp.inverse_kinematics(robot, pose),
        "samples of 30 poses of the tool": lambda: mp.sample_layers(robot, tool, 30, samples=24),
        "exact search among them": lambda: mp.max_min_search(layers, 0.2),
        "proven clearance of a path": lambda: scene.path_clearance(robot, path),
        "timing of a path, no jerk limit": lambda: retime(without_jerk),
        "timing of a path with jerk limits": lambda: retime(robot.limits),
        "optimised path without obstacles": lambda: mp.optimize_path(robot, START, GOAL),
    }


def work() -> None:
    """Answer each call's name by its time [s], from a number of repetitions that takes about LONG, and None by all names."""
    say = speaker()
    made = calls()
    repeats: dict[str, int] = {}
    for line in sys.stdin:
        name = json.loads(line)["call"]
        if name is None:
            say({"names": list(made)})
            continue
        if name not in repeats:
            made[name]()
            repeats[name] = max(1, round(LONG / seconds(made[name], 1)))
        say({"seconds": seconds(made[name], repeats[name])})


def seconds(call: Call, repeats: int) -> float:
    """Time of one call [s]."""
    began = time.perf_counter()
    for _ in range(repeats):
        call()
    return (time.perf_counter() - began) / repeats


# The parent


def shown(duration: float) -> str:
    """A duration [s] with a unit that suits it."""
    for unit, factor in (("s", 1.0), ("ms", 1e3)):
        if duration * factor >= 1:
            return f"{duration * factor:.3g} {unit}"
    return f"{duration * 1e6:.3g} µs"


def main(arguments: Sequence[str] | None = None) -> dict[str, float]:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--old", type=Path, required=True, help="checkout of version 0.1")
    parser.add_argument("--rounds", type=int, default=40, help="number of rounds")
    parser.add_argument("--out", type=Path, default=OUT, help="file of the table")
    given = parser.parse_args(arguments)
    if not (given.old / "manipplan").is_dir():
        parser.error(no_package(given.old))
    times: dict[str, list[dict[str, float]]] = {}
    with Worker(ROOT, script=__file__) as new, Worker(given.old, script=__file__) as old:
        workers = {"new": new, "old": old}
        names = new({"call": None})["names"]
        for number in track(range(given.rounds + 1), description="measuring"):
            order = list(workers) if number % 2 else list(reversed(workers))
            for name in names:
                times.setdefault(name, []).append({version: workers[version]({"call": name})["seconds"] for version in order})
    lines = [
        f"| call | version 0.1 | this version | ratio, wanted at most {MOST:g} | ratio in a round: median, lowest, highest |",
        "| --- | --- | --- | --- | --- |",
    ]
    ratios: dict[str, float] = {}
    for name, every in times.items():
        kept = every[1:]  # the first round warms up
        several = np.array([each["new"] / each["old"] for each in kept])
        before, now = (float(np.quantile([each[version] for each in kept], QUIET)) for version in ("old", "new"))
        ratios[name] = now / before
        rounds = ", ".join(f"{value:.2f}" for value in (np.median(several), several.min(), several.max()))
        lines.append(f"| {name} | {shown(before)} | {shown(now)} | {ratios[name]:.2f} | {rounds} |")
    lines += [
        "",
        f"Times that a tenth of {given.rounds} rounds stay below; Panda, compiled. "
        f"Python {platform.python_version()}, {platform.machine()}; command: "
        "`.venv/bin/python benchmarks/version_01.py --old PATH`.",
    ]
    given.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))
    return ratios


if __name__ == "__main__":
    if sys.argv[1:] == ["--worker"]:
        work()
    else:
        main()
