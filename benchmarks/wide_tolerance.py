"""`mp.follow` in a tube on the paths of online_global.csv on which a controller exceeded it by more than 5 %.

Run with `make benchmark`. Writes docs/benchmarks/wide_tolerance.md. online_global.csv was made when `follow` searched the poses
alone and used a tolerance only to refine what it found. Pinocchio on the original description judges the motions.
"""

import argparse
import csv
import time
from pathlib import Path

import numpy as np
from online_global import ARMS, CSV, FORMULATIONS, GRIDS, TUBE, Arm, Case, judge_best, shape_of
from rich.progress import track

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "wide_tolerance.md"
#: Share by which a controller exceeded the motion.
MORE = 1.05


def rows() -> list[dict[str, str]]:
    """Of the paths, with what the best controller reached of the motion."""
    with CSV.open(newline="") as file:
        tubes = [row for row in csv.DictReader(file) if row["allowed"] == "tube" and row["start"] == "best"]
    best = [max([float(row[name]) for name in FORMULATIONS if row[name]], default=0.0) for row in tubes]
    return [row | {"controller": f"{share:g}"} for row, share in zip(tubes, best, strict=True) if share > MORE]


def main(arguments: list[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--arms", nargs="+", choices=ARMS, default=ARMS)
    parser.add_argument("--out", type=Path, default=OUT)
    options = parser.parse_args(arguments)
    head = ("arm", "path", "m, poses searched", "best controller", "m, tube searched", "bound", "kept", "[s]")
    lines = [f"| {' | '.join(head)} |", "|---" * len(head) + "|"]
    for row in track([row for row in rows() if row["arm"] in options.arms], "following", transient=True):
        arm, seed = Arm.of(row["arm"]), int(row["seed"])
        rng = np.random.default_rng((ARMS.index(arm.name), seed))
        q = arm.robot.random_configuration(rng)
        path = shape_of(row["shape"], arm.robot.kinematics(mp.Task.pose()).pose(q), rng)
        began = time.process_time()
        objective = mp.PathObjective(task=arm.task)
        plan = mp.follow(arm.robot, path, objective=objective, tolerance=TUBE, throw=False, **GRIDS.get(arm.name, {}))
        seconds = time.process_time() - began
        before = float(row["best m"])
        cells = [arm.name, f"{row['shape']} {seed}", f"{before:.5f}", f"{before * float(row['controller']):.5f}"]
        if plan.status is mp.Status.FOLLOWED:
            found = judge_best(Case(arm=arm, shape=row["shape"], seed=seed, path=path, best={"tube": plan}), "tube")
            cells += [f"{found.least:.5f}", f"{plan.refinement.bound:.5f}", "yes" if found.whole else "no", f"{seconds:.1f}"]
        else:
            cells += [plan.status.name, "", "", f"{seconds:.1f}"]
        lines.append(f"| {' | '.join(cells)} |")
    options.out.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(options.out.read_text(encoding="utf-8"))


if __name__ == "__main__":
    main()
