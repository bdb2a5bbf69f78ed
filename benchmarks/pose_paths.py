"""Paths through random poses, some of them nearly repeated: how far do they leave the polygon, and how long are they?

Run with `make benchmark`. Poses lie anywhere in a box of 0.6 m, turned by some 1 rad from one to the next; after each one
further poses may come that are 1e-12 to 1e-3 m and rad from it. Distances from the polygon are measured by own means: of
positions from its straight pieces, of rotations from the turns about one axis, with the positions densely on short pieces,
too. The duration at a constant speed is the length of the way over the speed. Writes docs/benchmarks/pose_paths.md.
"""

import argparse
import itertools
import platform
import time
from pathlib import Path

import numpy as np
import pinocchio as pin
from rich.progress import track
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "pose_paths.md"
SEED, BOX, RADIAN = 45, 0.3, 0.1
#: Distance up to which the cubic spline takes a pose for the one before.
DOUBLE = 1e-9


def poses_at_random(rng: np.random.Generator, smooth: bool) -> list[np.ndarray]:
    count = int(rng.integers(3, 12))
    steps = rng.normal(size=(count, 3))
    if smooth:  # neighbouring pieces turn by some 30 degrees
        for k in range(1, count):
            steps[k] = steps[k - 1] / np.linalg.norm(steps[k - 1]) + 0.3 * steps[k]
    places = np.cumsum(0.1 * steps, axis=0) if smooth else rng.uniform(-BOX, BOX, (count, 3))
    turns = itertools.accumulate((pin.exp3(0.6 * rng.normal(size=3)) for _ in range(count)), np.matmul)
    return [pin.SE3(turn, place).homogeneous for turn, place in zip(turns, places, strict=True)]


def with_repeats(poses: list[np.ndarray], rng: np.random.Generator, turned: bool) -> list[np.ndarray]:
    made = []
    for pose in poses:
        made.append(pose)
        while rng.random() < 0.4:
            gap, angle = 10 ** rng.uniform(-12, -3, 2)
            change = pin.SE3(pin.exp3(angle * unit(rng)) if turned else np.eye(3), gap * unit(rng))
            made.append(made[-1] @ change.homogeneous)
    return made


def unit(rng: np.random.Generator) -> np.ndarray:
    vector = rng.normal(size=3)
    return vector / np.linalg.norm(vector)


def angles(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    return Rotation.from_matrix(np.swapaxes(first, -1, -2) @ second).magnitude()


def lengths(poses: np.ndarray) -> tuple[float, float]:
    way = np.linalg.norm(np.diff(poses[:, :3, 3], axis=0), axis=1).sum()
    return float(way), float(angles(poses[:-1, :3, :3], poses[1:, :3, :3]).sum())


def off(made: np.ndarray, poses: list[np.ndarray]) -> tuple[float, float]:
    """Largest distances from the polygon in position and rotation, as shares of the longest piece beside."""
    best = np.full((2, len(made)), np.inf)
    given = np.array(poses)
    sizes = np.linalg.norm(np.diff(given[:, :3, 3], axis=0), axis=1), angles(given[:-1, :3, :3], given[1:, :3, :3])
    for k, (a, b) in enumerate(itertools.pairwise(given)):
        along = b[:3, 3] - a[:3, 3]
        share = np.clip((made[:, :3, 3] - a[:3, 3]) @ along / max(along @ along, 1e-300), 0, 1)[:, None]
        wide, turned = (max(each[max(k - 1, 0) : k + 2].max(), 1e-6) for each in sizes)
        best[0] = np.minimum(best[0], np.linalg.norm(made[:, :3, 3] - a[:3, 3] - share * along, axis=1) / wide)
        # the nearest of the rotations exp(u ω): with quaternions c + s axis the projection is a half-angle by atan2
        turn = Rotation.from_matrix(a[:3, :3].T @ b[:3, :3]).as_rotvec()
        size = np.linalg.norm(turn)
        own = Rotation.from_matrix(a[:3, :3].T @ made[:, :3, :3]).as_quat()
        half = np.arctan2(own[:, :3] @ turn / max(size, 1e-300), own[:, 3])
        half = np.where(np.abs(half) > np.pi / 2, half - np.pi * np.sign(half), half)
        share = np.clip(2 * half / max(size, 1e-300), 0, 1)[:, None]
        nearest = a[:3, :3] @ Rotation.from_rotvec(share * turn).as_matrix()
        best[1] = np.minimum(best[1], angles(nearest, made[:, :3, :3]) / turned)
    return float(best[0].max()), float(best[1].max())


def cubic_off(poses: list[np.ndarray], s: np.ndarray) -> float:
    """Largest distance from the polygon of a cubic spline of the positions, over the distances between the poses [m]."""
    given = np.array(poses)
    steps = np.linalg.norm(np.diff(given[:, :3, 3], axis=0), axis=1) + RADIAN * angles(given[:-1, :3, :3], given[1:, :3, :3])
    given, steps = given[np.append(True, steps > DOUBLE)], steps[steps > DOUBLE]
    at = np.concatenate([[0.0], np.cumsum(steps)])
    points, best = CubicSpline(at / at[-1], given[:, :3, 3])(s), np.full(len(s), np.inf)
    for a, b in itertools.pairwise(given[:, :3, 3]):
        share = np.clip((points - a) @ (b - a) / max((b - a) @ (b - a), 1e-300), 0, 1)[:, None]
        best = np.minimum(best, np.linalg.norm(points - a - share * (b - a), axis=1))
    return float(best.max())


def samples(path: mp.CartesianPath) -> np.ndarray:
    pieces = [np.linspace(a, b, 60) for a, b in itertools.pairwise(path.knots)]
    return np.unique(np.concatenate([np.linspace(0, 1, 2001), *pieces]))


def measured(rng: np.random.Generator, smooth: bool, turned: bool) -> dict[str, float]:
    plain = poses_at_random(rng, smooth)
    poses = with_repeats(plain, rng, turned)
    began = time.process_time()
    path = mp.CartesianPath.through(poses)
    s = samples(path)
    made = path(s)
    took = 1e3 * (time.process_time() - began)
    long, turn = lengths(made)
    polygon, angle = lengths(np.array(poses))
    without = mp.CartesianPath.through(plain)
    before, _ = lengths(without(samples(without)))
    position, rotation = off(made, poses)
    knots = made[np.searchsorted(s, path.knots)]
    missed = max(float(np.abs(knots - pose).max(axis=(1, 2)).min()) for pose in poses)
    return {
        "position": position,
        "rotation": rotation,
        "missed": missed,
        "length": abs(long / polygon - 1),
        "turn": abs(turn / angle - 1),
        "repeats": abs(long / before - 1),
        "cubic": cubic_off(poses, s),
        "ms": took,
    }


def row(name: str, count: int, smooth: bool, turned: bool) -> str:
    rng = np.random.default_rng([SEED, smooth, turned])
    found = [measured(rng, smooth, turned) for _ in track(range(count), name)]
    value = {key: np.array([each[key] for each in found]) for key in found[0]}

    def share(key: str) -> str:
        return f"{100 * np.median(value[key]):.2f} / {100 * np.quantile(value[key], 0.99):.2f} / {100 * value[key].max():.2f}"

    cells = (
        name,
        f"{count:,}",
        f"{value['position'].max():.3f}",
        f"{value['rotation'].max():.3f}",
        f"{value['missed'].max():.1g}",
        share("length"),
        share("turn"),
        share("repeats"),
        f"{np.median(value['cubic']):.2g} / {value['cubic'].max():.2g}",
        f"{value['ms'].mean():.1f}",
    )
    return "| " + " | ".join(cells) + " |"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=300, help="paths per row")
    options = parser.parse_args()
    lines = [
        "| poses | paths | off the polygon, position (share of the longest piece beside) | rotation "
        "| given poses missed by at most | length over the polygon's: median / 99 % / largest difference [%] "
        "| the same of the angle turned [%] | length over that without the repeats [%] "
        "| off the polygon on a cubic spline: median / largest [m] | ms per path |",
        "|---|---|---|---|---|---|---|---|---|---|",
    ]
    for smooth in (False, True):
        for turned in (False, True):
            name = f"{'in gentle turns' if smooth else 'anywhere'}, repeats {'moved and turned' if turned else 'moved'}"
            lines.append(row(name, options.count, smooth, turned))
    command = f"`.venv/bin/python benchmarks/pose_paths.py --count {options.count}`"
    text = "\n".join([*lines, "", f"Python {platform.python_version()}, {platform.machine()}; command: {command}.", ""])
    OUT.write_text(text)
    print(text)


if __name__ == "__main__":
    main()
