"""Processor time of `retime` on paths of many pieces: chords with stops, curved pieces with corners, and splines.

Writes docs/benchmarks/many_pieces.md.
"""

import argparse
import time
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from rich.progress import track

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "many_pieces.md"
COUNTS = (1000, 10_000)


def chords(count: int, n: int) -> mp.JointPath:
    """Chords of a circle, with a small motion of all other joints."""
    u = np.linspace(0.0, 2 * np.pi, count + 1)
    return mp.JointPath.through(0.5 * np.column_stack([np.cos(u), np.sin(u), *(0.1 * np.sin(k * u) for k in range(2, n))]))


def random_way(count: int, n: int) -> np.ndarray:
    """Way points (count + 1, n) of a random walk."""
    return np.cumsum(np.random.default_rng(0).uniform(-0.1, 0.1, (count + 1, n)), axis=0)


def arcs(count: int, n: int) -> mp.JointPath:
    """Cubic pieces with corners."""
    points = random_way(count, n)
    bends = np.random.default_rng(1).uniform(-0.03, 0.03, (2, count, n))
    control = np.stack([points[:-1], points[:-1] + bends[0], points[1:] + bends[1], points[1:]], axis=1)
    return mp.JointPath(breaks=np.linspace(0.0, 1.0, count + 1), control=control)


def spline(count: int, n: int) -> mp.JointPath:
    """A spline without stops."""
    return mp.JointPath.spline(np.linspace(0.0, 1.0, count + 1), random_way(count, n))


KINDS = {"chords": chords, "curved pieces with corners": arcs, "spline": spline}


def main(arguments: Sequence[str] | None = None) -> list[tuple[str, float, float]]:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--counts", type=int, nargs=2, default=COUNTS, help="numbers of pieces: few and many")
    parser.add_argument("--out", type=Path, default=OUT, help="the table's file")
    options = parser.parse_args(arguments)
    few, many = options.counts
    planar = mp.planar_arm([1.0, 1.0, 1.0]).with_limits(velocity=2.0, acceleration=4.0)
    arms = {"planar arm, acceleration limited": planar, "Panda, jerk limited": mp.load_robot("panda")}
    lines = [f"| arm | path | {few:,} pieces | {many:,} pieces | time per piece over that of few | samples per piece |"]
    lines.append("|---|---|---|---|---|---|")
    found = []
    for arm, kind in track([(arm, kind) for arm in arms for kind in KINDS], description="timing"):
        seconds = []
        for count in (min(few, 100), few, many):  # the first call imports and compiles
            path, began = KINDS[kind](count, arms[arm].n), time.process_time()
            motion = mp.retime(path, arms[arm])
            seconds.append(time.process_time() - began)
        ratio = seconds[2] / seconds[1] * few / many
        found.append((kind, seconds[2], ratio))
        lines.append(f"| {arm} | {kind} | {seconds[1]:.2f} s | {seconds[2]:.2f} s | {ratio:.2f} | {len(motion.t) / many:.1f} |")
        print(lines[-1], flush=True)
    lines += ["", "Processor time; command: `.venv/bin/python benchmarks/many_pieces.py`."]
    options.out.write_text("\n".join(lines) + "\n")
    return found


if __name__ == "__main__":
    main()
