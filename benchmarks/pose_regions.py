"""Freedom about each pose of a tool path: what boxes and cones give `mp.follow`, and what they cost.

Run with `make benchmark`. Writes docs/benchmarks/pose_regions.md. The paths are those of tool_paths.py: what others made, and
random ones with two cubes beside them. Each is followed as it is, and within regions about its poses; defaults, but up to nine
interruptions. Motions are judged by Pinocchio and coal on the original description: every given pose is met within its region
to 0.1 mm and 1 mrad, in order, and nothing touches. Times are CPU times.
"""

import argparse
import platform
import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from rich.progress import track
from scipy.spatial.transform import Rotation
from tool_paths import Case, is_free, judge_of, made, others

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "pose_regions.md"
#: The regions: label, and arguments of `Task.within`.
REGIONS: dict[str, dict[str, object]] = {
    "the poses themselves": {},
    "±5 mm, ±3°": {"position": 0.005, "rotation": np.deg2rad(3)},
    "turn about the tool axis by ±30°": {"rotation": (0.0, 0.0, np.deg2rad(30))},
    "cone of 15°, any spin": {"cone": np.deg2rad(15)},
    "±2 cm along the tool, cone of 15°, spin ±30°": {
        "position": (0.0, 0.0, 0.02),
        "cone": np.deg2rad(15),
        "spin": np.deg2rad(30),
    },
}
#: Excess up to which a pose counts as within its region [m, rad], and number of times at which the tool is looked at.
MET, TIMES = (1e-4, 1e-3), 6000


def excess(reached: NDArray[np.float64], pose: NDArray[np.float64], region: dict[str, object]) -> NDArray[np.float64]:
    """By how much tool poses (k, 4, 4) exceed a region about a pose, as shares of MET, (k,)."""
    back = pose[:3, :3].T
    moved = (reached[:, :3, 3] - pose[:3, 3]) @ pose[:3, :3]
    turned = back @ reached[:, :3, :3]
    beyond = np.linalg.norm(np.maximum(np.abs(moved) - np.broadcast_to(region.get("position", 0.0), 3), 0.0), axis=1)
    if "cone" in region:
        z = turned[:, :, 2]
        tilt = np.arctan2(np.hypot(z[:, 0], z[:, 1]), z[:, 2])
        lean = Rotation.from_rotvec(np.cross([0.0, 0.0, 1.0], z) / np.maximum(np.sin(tilt), 1e-12)[:, None] * tilt[:, None])
        spin = np.abs((lean.inv() * Rotation.from_matrix(turned)).as_rotvec()[:, 2])
        angle = np.maximum(np.maximum(tilt - region["cone"], spin - region.get("spin", np.pi)), 0.0)
    else:
        vector = np.abs(Rotation.from_matrix(turned).as_rotvec())
        angle = np.linalg.norm(np.maximum(vector - np.broadcast_to(region.get("rotation", 0.0), 3), 0.0), axis=1)
    return np.maximum(beyond / MET[0], angle / MET[1])


def is_kept(case: Case, plan: mp.Plan, region: dict[str, object]) -> bool:
    """Whether the tool comes past all given poses in order, within their regions, and nothing touches."""
    judge = judge_of(case)
    for part in plan.report.along:
        t = np.linspace(part.begin, part.end, TIMES)
        reached = np.array([judge.pose_and_jacobian(plan.trajectory(each), case.frame)[0] for each in t])
        # between two of the times the tool moves by less than this share of what counts as met
        moved = np.linalg.norm(np.diff(reached[:, :3, 3], axis=0), axis=1).max() / MET[0]
        turned = np.linalg.norm(np.diff(reached[:, :3, :3], axis=0), axis=(1, 2)).max() / np.sqrt(2) / MET[1]
        room, last = 1.0 + max(moved, turned) / 2, 0
        for s in case.path.knots[(case.path.knots >= part.s_begin - 1e-12) & (case.path.knots <= part.s_end + 1e-12)]:
            within = np.flatnonzero(excess(reached[last:], case.path(s), region) <= room)
            if not len(within):
                return False
            last += int(within[0])
    return is_free(plan, judge)


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--paths", type=int, default=12, help="number of paths made here")
    parser.add_argument("--out", type=Path, default=OUT, help="the table's file")
    options = parser.parse_args(arguments)
    cases = [*others(), *(replace(each, task=mp.Task.pose()) for each in made(options.paths))]
    rows = [
        "| poses that count | paths | followed without interruption | parts, all paths | kept by the judge "
        "| minimum m over that of the poses themselves: median, least, largest | CPU time: median, 95 %, largest |",
        "|---" * 7 + "|",
    ]
    alone: list[tuple[int, float]] = []
    for label, region in REGIONS.items():
        found, times, kept = [], [], 0
        for case in track(cases, label):
            task = case.task.within(**region) if region else case.task
            began = time.process_time()
            plan = mp.follow(
                case.robot,
                case.path,
                case.scene,
                objective=mp.PathObjective(task=task),
                interruptions=9,
                retreat=0.0,
                throw=False,
            )
            times.append(time.process_time() - began)
            moves = plan.status in (mp.Status.FOLLOWED, mp.Status.FOLLOWED_IN_PARTS)
            least = min(each.min_manipulability for each in plan.report.along) if moves else np.nan
            found.append((len(plan.report.along) if moves else 0, least))
            good = moves and is_kept(case, plan, region)
            kept += good
            if not good:
                print(f"{case.name}: {plan.status.name} {plan.message[:300]}")
        alone = alone or found
        ratios = sorted(m / own for (parts, m), (own_parts, own) in zip(found, alone, strict=True) if parts == own_parts > 0)
        rows.append(
            f"| {label} | {len(cases)} | {sum(parts == 1 for parts, _ in found)} | {sum(parts for parts, _ in found)} "
            f"| {kept} of {sum(parts > 0 for parts, _ in found)} | {np.median(ratios):.2f}, {ratios[0]:.3f}, {ratios[-1]:.2f} "
            f"| {np.median(times):.1f} s, {np.percentile(times, 95):.1f} s, {max(times):.1f} s |"
        )
        print(rows[-1])
    rows += [
        "",
        "Ratios are of motions in as many parts. Manipulability of the whole pose in all rows. Where the tool leaves the path, "
        f"the time has the planning of free motions in it. Python {platform.python_version()}, {platform.machine()}; command: "
        "`make benchmark`.",
    ]
    options.out.write_text("\n".join(rows) + "\n")


if __name__ == "__main__":
    main()
