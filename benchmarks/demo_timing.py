"""How long it takes to time the path of the demo's Panda, beside toppra alone and beside what Ruckig does.

Run with `make benchmark-peers`; Ruckig's environment is made on the first run. The path of the Panda among five boxes of
`manipplan demo` is planned once, then timed in rounds that take turns. The table has processor times, since other work on the
machine does not change these much. Writes docs/benchmarks/demo_timing.md.
"""

import argparse
import logging
import platform
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

import numpy as np
from rich.progress import track
from timing import optimum

import manipplan as mp

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "benchmarks" / "peers"))
from run import run_peer  # noqa: E402

OUT = ROOT / "docs" / "benchmarks" / "demo_timing.md"
#: Grid points of toppra and of `mp.retime`, and straight pieces of Ruckig's motion along the path.
POINTS, PIECES = 300, 20


@dataclass(frozen=True, kw_only=True)
class Row:
    """One way to time the path: its name, the limits it keeps, its duration [s], processor times [s], and q at samples."""

    name: str
    limits: str
    duration: float
    seconds: list[float]
    q: np.ndarray | None = None


def rounds_of(calls: dict[str, Callable[[], object]], rounds: int) -> dict[str, list[float]]:
    """Processor times [s] of calls that take turns, each called once before."""
    for call in calls.values():
        call()
    found: dict[str, list[float]] = {name: [] for name in calls}
    for _ in track(range(rounds), description="timing"):
        for name, call in calls.items():
            began = time.process_time()
            call()
            found[name].append(time.process_time() - began)
    return found


def away(path: mp.JointPath, q: np.ndarray) -> float:
    """Largest distance [rad] of configurations (m, n) from a path, which is sampled densely."""
    points = path(np.linspace(0.0, 1.0, 5001))
    worst = 0.0
    for each in q:
        k = int(np.clip(np.argmin(((points - each) ** 2).sum(axis=1)), 1, len(points) - 2))
        beside = []
        for a, b in ((points[k - 1], points[k]), (points[k], points[k + 1])):
            share = np.clip((each - a) @ (b - a) / ((b - a) @ (b - a)), 0.0, 1.0)
            beside.append(float(np.linalg.norm(a + share * (b - a) - each)))
        worst = max(worst, min(beside))
    return worst


def rows(path: mp.JointPath, robot: mp.Robot, rounds: int, environments: Path) -> list[Row]:
    """All ways, measured in this run."""
    free = robot.limits.with_changes({"jerk": np.inf})
    calls: dict[str, Callable[[], object]] = {
        "jerk": lambda: mp.retime(path, robot),
        "none": lambda: mp.retime(path, robot, limits=free),
        "toppra": lambda: optimum(path, free, points=POINTS),
    }
    seconds = rounds_of(calls, rounds)
    found = []
    for key, name, kept in (
        ("jerk", "`mp.retime`", "velocity, acceleration, jerk"),
        ("none", "`mp.retime`, no jerk limit", "velocity, acceleration"),
    ):
        motion = mp.retime(path, robot, limits=robot.limits if key == "jerk" else free)
        q = motion(np.linspace(0.0, motion.duration, 1000))
        found.append(Row(name=name, limits=kept, duration=motion.duration, seconds=seconds[key], q=q))
    fastest = optimum(path, free, points=POINTS)
    if fastest is None:
        raise RuntimeError("toppra found no motion")
    told = f"toppra {version('toppra')}: speeds on {POINTS} grid points, no trajectory"
    found.append(Row(name=told, limits="velocity, acceleration, at grid points", duration=fastest, seconds=seconds["toppra"]))
    pins = (ROOT / "benchmarks" / "peers" / "ruckig.txt").read_text().split()
    release = next(pin.split("==")[1] for pin in pins if pin.startswith("ruckig"))
    for pieces, name in (
        (1, "start to goal"),
        (PIECES, f"{PIECES} straight pieces along the path, a stop after each"),
    ):
        problem = {"waypoints": path(np.linspace(0.0, 1.0, pieces + 1)), "straight": pieces > 1, "rounds": rounds}
        problem |= {kind: getattr(robot.limits, kind) for kind in ("velocity", "acceleration", "jerk")}
        answer = run_peer("ruckig", problem | {"samples": 1000 // pieces}, environments, "motions")
        found.append(
            Row(
                name=f"Ruckig {release}: {name}",
                limits="velocity, acceleration, jerk",
                duration=float(answer["duration"]),
                seconds=answer["seconds"].tolist(),
                q=answer["q"],
            )
        )
    return found


def page(found: list[Row], path: mp.JointPath, robot: mp.Robot, scene: mp.Scene, rounds: int) -> str:
    """The rows as a page."""
    lines = [
        "| | limits it keeps | duration [s] | farthest from the path [rad] | nearest to a box or itself [mm] "
        "| processor time: median, worst [ms] |",
        "|---|---|---|---|---|---|",
    ]
    for row in found:
        far = "–" if row.q is None else f"{away(path, row.q):.3f}"
        near = "–" if row.q is None else f"{1e3 * scene.distances(robot, row.q).min():.0f}"
        milliseconds = 1e3 * np.array(row.seconds)
        times = f"{np.median(milliseconds):.3g}, {milliseconds.max():.3g}"
        lines.append(f"| {row.name} | {row.limits} | {row.duration:.4f} | {far} | {near} | {times} |")
    ratio = np.median(found[0].seconds) / np.median(found[2].seconds)
    return "\n".join(
        [
            *lines,
            "",
            f"With jerk limits `mp.retime` takes {ratio:.2f} times as long as toppra without them, and verifies what it "
            "returns. Ruckig follows no path: its own mode for points on the way asks a server, which was not done here.",
            "",
            f"{rounds} rounds; negative distances are depths. Python {platform.python_version()}, {platform.machine()}; "
            "command: `make benchmark-peers`.",
            "",
        ]
    )


def main(arguments: list[str] | None = None) -> list[Row]:
    """Run, and write the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=100)
    parser.add_argument("--environments", type=Path, default=ROOT / ".peers", help="folder of the peers' environments")
    parser.add_argument("--out", type=Path, default=OUT)
    options = parser.parse_args(arguments)
    logging.getLogger("toppra").setLevel(logging.ERROR)
    problem = mp.demo.panda_among_boxes()
    plan = mp.plan(problem.robot, problem.start, problem.goal, problem.scene, clearance=problem.clearance)
    found = rows(plan.path, problem.robot, options.rounds, options.environments)
    text = page(found, plan.path, problem.robot, problem.scene, options.rounds)
    options.out.parent.mkdir(parents=True, exist_ok=True)
    options.out.write_text(text)
    print(text)
    return found


if __name__ == "__main__":
    main()
