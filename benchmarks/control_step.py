"""Time of one control step of the Panda, with few and with many active bounds.

Run with `make benchmark`, on a quiet machine: the times are microseconds. A quadratic program takes longer the more bounds are
active, so two cases stand side by side: along a path, where hardly any bound is active, and at rest with a target 0.2 mm away,
where some joints are at their acceleration limit. Every case is measured in several rounds that take turns; the table has the
median round. Writes docs/benchmarks/control_step.md.
"""

import argparse
import platform
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from rich.progress import track

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "control_step.md"
START = np.array([0.0, -0.3, 0.0, -2.2, 0.0, 2.0, np.pi / 4])
FORMULATIONS = {
    "LogDrive": mp.formulations.LogDrive(),
    "(14)": mp.formulations.Equality(5e5),
    "(10), exact Hessian": mp.formulations.Objective(15e3),
}
#: Distance of the target from the arm at rest [m].
AWAY = 2e-4
REST, PATH = "at rest, target 0.2 mm away", "along a path of 0.3 m"
CASES = ((PATH, 0.01), (PATH, 0.001), (REST, 0.001))


@dataclass(frozen=True, kw_only=True)
class Round:
    """One round: median and 99th percentile of the step [s], and the mean number of joints at their acceleration limit."""

    median: float
    high: float
    active: float


def five_spheres() -> mp.Avoidance:
    """Five spheres that the hand keeps away from: five rows."""
    spheres = [mp.Sphere(radius=0.05, position=(0.5, 0.1 * k - 0.2, 0.15), name=f"ball{k}") for k in range(5)]
    return mp.Avoidance(scene=mp.Scene(spheres), links=["panda_hand"], itself=False)


def targets(robot: mp.Robot, case: str, dt: float) -> np.ndarray:
    """The target pose (N, 4, 4) of every step."""
    start = robot.kinematics().pose(START)
    end = start.copy()
    if case == REST:
        end[2, 3] += AWAY
        return np.repeat(end[None], 2000, axis=0)
    end[1, 3] += 0.3
    steps = round(2.0 / dt)
    u = np.arange(1, steps + 1) / steps
    return mp.CartesianPath.line(start, end)(10 * u**3 - 15 * u**4 + 6 * u**5)


def one_round(robot: mp.Robot, controller: mp.Controller, case: str, dt: float, poses: np.ndarray) -> Round:
    """Steps one by one from Python: along the path, or again and again from rest."""
    seconds, active = np.zeros(len(poses)), np.zeros(len(poses))
    limit = dt * robot.limits.acceleration * (1 - 1e-6)
    q, qd = START.copy(), np.zeros(robot.n)
    controller.reset()
    for k, pose in enumerate(poses):
        if case == REST:
            q, qd = START.copy(), np.zeros(robot.n)
        began = time.perf_counter()
        following = controller.step(q, qd, pose)
        seconds[k] = time.perf_counter() - began
        active[k] = np.count_nonzero(np.abs(following - qd) >= limit)
        q, qd = q + dt * following, following
    return Round(median=float(np.median(seconds)), high=float(np.percentile(seconds, 99)), active=float(active.mean()))


def main(arguments: Sequence[str] | None = None) -> list[tuple[str, float, str, int, Round]]:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=15, help="number of rounds of every case")
    parser.add_argument("--interpreted", action="store_true", help="without the compiler")
    parser.add_argument("--out", type=Path, default=OUT, help="file of the table")
    given = parser.parse_args(arguments)
    robot = mp.load_robot("panda")
    compiled = False if given.interpreted else "auto"
    made = {
        (case, dt, name, rows): mp.Controller(
            robot, formulation, dt=dt, avoidance=five_spheres() if rows else None, compiled=compiled
        )
        for case, dt in CASES
        for name, formulation in FORMULATIONS.items()
        for rows in (0, 5)
    }
    poses = {(case, dt): targets(robot, case, dt) for case, dt in CASES}
    rounds: dict[tuple[str, float, str, int], list[Round]] = {key: [] for key in made}
    for _ in track(range(given.rounds + 1), description="measuring"):
        for (case, dt, name, rows), controller in made.items():
            rounds[case, dt, name, rows].append(one_round(robot, controller, case, dt, poses[case, dt]))
    found = []
    for key, every in rounds.items():
        kept = sorted(every[1:], key=lambda each: each.median)  # the first round warms up
        found.append((*key, kept[len(kept) // 2]))
    spread = {key: (min(e.median for e in every[1:]), max(e.median for e in every[1:])) for key, every in rounds.items()}
    lines = [
        "| case | time step | formulation | collision rows | joints at their acceleration limit, of 7 | median "
        "| fastest to slowest round | 99 % |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for case, dt, name, rows, middle in found:
        low, high = spread[case, dt, name, rows]
        lines.append(
            f"| {case} | {1e3 * dt:g} ms | {name} | {rows} | {middle.active:.1f} | {1e6 * middle.median:.1f} µs "
            f"| {1e6 * low:.1f} to {1e6 * high:.1f} µs | {1e6 * middle.high:.1f} µs |"
        )
    made_by = "without a compiler" if given.interpreted else "compiled"
    lines += [
        "",
        f"One step called from Python, {made_by}, {given.rounds} rounds; Python {platform.python_version()}, "
        f"{platform.machine()}; command: `.venv/bin/python benchmarks/control_step.py`.",
    ]
    given.out.parent.mkdir(parents=True, exist_ok=True)
    given.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))
    return found


if __name__ == "__main__":
    main()
