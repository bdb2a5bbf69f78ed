"""`mp.follow` from where the arm stands: lead-ins from random starts, and how constant a constant speed of the tool is.

Run with `make benchmark`. Writes docs/benchmarks/follow_starts.md and follow_speeds.md. Beside `follow` with a start stands the
motion without it: the best one along the path, and `mp.plan` from the start to where it begins. Times are CPU times.
"""

import argparse
import os
import platform
import re
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import numpy as np
from numpy.typing import NDArray
from outside import tool_paths
from rich.progress import track

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks"
#: Constant speeds of the tool that are asked for [m/s].
SPEEDS = (0.005, 0.02, 0.1, 0.3)
#: Two minima of m that differ by less than this share count as equal.
SAME = 0.01


@dataclass(frozen=True, kw_only=True)
class Case:
    """A path to follow among obstacles, and the options for it."""

    name: str
    robot: mp.Robot
    path: mp.CartesianPath
    scene: mp.Scene
    task: mp.Task
    positions: int = 50

    def follow(self, **options: object) -> mp.Plan:
        """The motion along the path."""
        objective = mp.PathObjective(task=self.task)
        return mp.follow(
            self.robot, self.path, self.scene, positions=self.positions, objective=objective, throw=False, **options
        )


def seam() -> tuple[mp.CartesianPath, mp.Scene]:
    """A wavy seam of 300 poses above a table, beside a post."""
    u = np.linspace(0.0, 1.0, 300)
    poses = np.tile(np.diag([1.0, -1.0, -1.0, 1.0]), (len(u), 1, 1))
    poses[:, :3, 3] = np.stack([0.5 + 0.05 * np.sin(6 * u), -0.3 + 0.6 * u, np.full(len(u), 0.3)], axis=1)
    table = mp.Box(size=(0.8, 1.2, 0.04), position=(0.6, 0.0, 0.15), name="table")
    return mp.CartesianPath.through(poses), mp.Scene(
        [table, mp.Box(size=(0.1, 0.1, 0.4), position=(0.6, 0.1, 0.75), name="post")]
    )


def cases() -> list[Case]:
    """Our seam and the paths of others, with the whole pose where a motion keeps it, and with a free tool axis."""
    pose, free = mp.Task.pose(), mp.Task.pointing([0, 0, 1])
    panda, hand = mp.load_robot("panda"), tool_paths.robot()
    path, scene = seam()
    paths = {each.name: each for each in tool_paths.load()}
    cubes, recorded = paths["CppFlow, panda__2cubes"], paths["IKLink"]
    return [
        Case(name="seam", robot=panda, path=path, scene=scene, task=pose),
        Case(name="seam, free axis", robot=panda, path=path, scene=scene, task=free),
        Case(name=cubes.name, robot=hand, path=cubes.path, scene=cubes.scene, task=pose),
        Case(name=f"{cubes.name}, free axis", robot=hand, path=cubes.path, scene=cubes.scene, task=free),
        Case(
            name=f"{recorded.name}, free axis", robot=hand, path=recorded.path, scene=recorded.scene, task=free, positions=100
        ),
    ]


def starts(case: Case, count: int) -> list[NDArray[np.float64]]:
    """Random configurations, free of collisions."""
    rng, model, found = np.random.default_rng(0), case.scene.collision_model(case.robot), []
    while len(found) < count:
        q = case.robot.random_configuration(rng, size=20)
        found += list(q[~model.in_collision_rows(q)])
    return found[:count]


def line_of_starts(case: Case, best: mp.Plan, count: int) -> str:
    """How lead-ins from random starts end, beside plans to where the best motion along the path begins."""
    times, gains, found, usual = [], [], 0, 0
    m = case.robot.kinematics(case.task).manipulability
    for start in starts(case, count):
        began = time.process_time()
        plan = case.follow(start=start)
        times.append(time.process_time() - began)
        passed = plan.report is not None and plan.report.passed
        found += passed
        lead_in = mp.plan(
            case.robot, start, best.trajectory.q[0], case.scene, objective=mp.PathObjective(task=case.task), throw=False
        )
        reached = lead_in.report is not None and lead_in.report.passed
        usual += reached
        if passed and reached:
            least = min(lead_in.report.min_manipulability, best.report.min_manipulability)
            gains.append(
                (plan.report.min_manipulability / least, plan.report.min_manipulability / min(m(start), best.search.bound))
            )
    ratio, share = np.array(gains).T
    cells = [case.name, count, usual, found, f"{100 * (ratio >= 1 - SAME).mean():.0f} %", f"{ratio.min():.3f}"]
    cells += [f"{np.median(ratio):.2f}", f"{ratio.max():.2f}", f"{np.median(share):.2f}"]
    cells += [f"{np.median(times):.1f} s", f"{max(times):.1f} s"]
    return "| " + " | ".join(map(str, cells)) + " |"


def lines_of_speeds(case: Case) -> list[str]:
    """How constant the tool's speed is between its ramps; where it is refused, at the fastest speed that the message names."""
    lines = []
    for asked in SPEEDS:
        speed, named = asked, ""
        try:
            kept = case.follow(tool_speed=asked).report.along[0].tool_speed
        except mp.errors.InvalidInputError as error:
            most = re.search(r"at most ([\d.]+) m/s", str(error))
            if most is None:
                lines.append(f"| {case.name} | {1e3 * asked:g} | none | | | |")
                continue
            speed, named = float(most.group(1)), f"refused: at most {1e3 * float(most.group(1)):.4g}"
            kept = case.follow(tool_speed=speed).report.along[0].tool_speed
        cells = [case.name, f"{1e3 * asked:g}", named or "kept", f"{100 * (kept.slowest / speed - 1):z.2f} %"]
        cells += [f"{100 * (kept.fastest / speed - 1):z.2f} %", f"{1e3 * max(kept.ramps):.2g}"]
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--starts", type=int, default=10, help="number of random starts for each path")
    parser.add_argument("--out", type=Path, default=OUT, help="the tables' folder")
    options = parser.parse_args(arguments)
    of_starts = [
        "| path | starts | reached by a plan to the best motion | by `follow` | minimum m at least as high "
        "| its ratio: smallest | median | largest | share of the bound: median | time: median | largest |",
        "|---" * 11 + "|",
    ]
    of_speeds = [
        "| path | asked for [mm/s] | result [mm/s] | slowest between ramps | fastest | longest ramp [mm] |",
        "|---" * 6 + "|",
    ]
    for case in track(cases(), description="paths"):
        best = case.follow()
        of_starts.append(line_of_starts(case, best, options.starts))
        of_speeds += lines_of_speeds(case)
    machine = f"CPU time; Python {platform.python_version()}, {platform.machine()}; command: `make benchmark`."
    for name, lines in (("follow_starts.md", of_starts), ("follow_speeds.md", of_speeds)):
        (options.out / name).write_text("\n".join([*lines, "", machine]) + "\n")
        print("\n".join(lines))


if __name__ == "__main__":
    main()
