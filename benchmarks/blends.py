"""Blends: how far the tool leaves the convex hull of the two pieces that a blend replaces, at random corners.

Run with `make benchmark`. Writes docs/benchmarks/blends.md. Programs of two moves, straight moves of the tool with corners of
5° to 180° and free motions, are planned with a blend and without. The pieces that the blend replaces are those of the motion
that stops at the corner, within the radius that stands in the mark. The tool is placed by Pinocchio at dense times; hulls are
those of SciPy, flat ones in their plane.
"""

import argparse
import os
import platform
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray
from rich.progress import track
from scipy.spatial import ConvexHull

import manipplan as mp

Array = NDArray[np.float64]
OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "blends.md"
ARMS = ("panda", "ur5", "xarm7")
#: Configurations about which the corners are [rad].
AT = {
    "panda": (0.0, -0.5, 0.0, -2.2, 0.0, 1.8, 0.8),
    "ur5": (0.0, -1.4, 1.6, -1.77, -1.57, 0.0),
    "xarm7": (0.0, -0.3, 0.0, 1.1, 0.0, 1.4, 0.0),
}
#: Kinds of the two moves.
KINDS = {"straight, straight": "ss", "free, straight": "fs", "straight, free": "sf", "free, free": "ff"}
#: Radii asked for, lengths of straight moves [m], smallest angle of a corner, and largest change of a joint [rad].
RADII, LENGTHS, SHARPEST, CHANGE = (0.005, 0.1), (0.04, 0.25), np.radians(5.0), 0.5
#: Times at which a motion is measured, and thickness below which a hull is flat [m].
TIMES, FLAT = 6000, 1e-6
#: Distance beyond the hull that is allowed [m].
ALLOWED = 1e-4


@dataclass(frozen=True, kw_only=True)
class Corner:
    """What became of one corner.

    Attributes:
        asked, used: radius of the blend [m]; 0: the arm stops.
        beyond: largest distance of the tool beyond the hull [m].
        told: whether a warning says that it is smaller, where it is.
        message: why there is no program.
    """

    asked: float = 0.0
    used: float = 0.0
    beyond: float = 0.0
    told: bool = True
    message: str = ""


def placed(robot: mp.Robot, motion: mp.Trajectory) -> Array:
    """Positions (TIMES, 3) of the tool by Pinocchio."""
    data, frame = robot.model.createData(), robot.model.getFrameId(robot.tool)
    places = []
    for q in motion(np.linspace(0.0, motion.duration, TIMES)):
        pin.framesForwardKinematics(robot.model, data, q)
        places.append(data.oMf[frame].translation.copy())
    return np.array(places)


def beyond_hull(points: Array, places: Array) -> float:
    """Largest distance of places (k, 3) beyond the facets of the convex hull of points (l, 3), or of their plane or line."""
    middle = points.mean(axis=0)
    _, spread, axes = np.linalg.svd(points - middle, full_matrices=False)
    rank = max(1, int((spread / np.sqrt(len(points)) > FLAT).sum()))
    inside, across = axes[:rank], axes[rank:]
    flat, at = (points - middle) @ inside.T, (places - middle) @ inside.T
    off = np.linalg.norm((places - middle) @ across.T, axis=1) if len(across) else np.zeros(len(places))
    if rank == 1:
        out = np.maximum(np.maximum(at[:, 0] - flat.max(), flat.min() - at[:, 0]), 0.0)
    else:
        facets = ConvexHull(flat).equations
        out = np.maximum((at @ facets[:, :-1].T + facets[:, -1]).max(axis=1), 0.0)
    return float(np.hypot(out, off).max())


def moves(kind: str, robot: mp.Robot, q: Array, rng: np.random.Generator) -> list[mp.MoveTo | mp.MoveAlong]:
    """Two random moves from q (n,)."""
    first = rng.normal(size=3)
    first /= np.linalg.norm(first)
    across = np.cross(first, rng.normal(size=3))
    across /= np.linalg.norm(across)
    angle = rng.uniform(SHARPEST, np.pi)
    directions = (first, np.cos(angle) * first + np.sin(angle) * across)
    made: list[mp.MoveTo | mp.MoveAlong] = []
    for each, direction in zip(kind, directions, strict=True):
        straight = mp.MoveAlong(rng.uniform(*LENGTHS) * direction)
        made.append(straight if each == "s" else mp.MoveTo(q + rng.uniform(-CHANGE, CHANGE, robot.n)))
    return made


def measured(robot: mp.Robot, kind: str, q: Array, rng: np.random.Generator) -> Corner:
    """One random corner."""
    asked, steps = float(rng.uniform(*RADII)), moves(kind, robot, q, rng)
    try:
        sharp, made = (mp.sequence(robot, q, steps, blend=radius) for radius in (0.0, asked))
    except (mp.errors.PlanningError, mp.errors.InvalidInputError) as error:
        return Corner(message=" ".join(str(error).split())[:120])
    used = made.marks[0].blend
    if not used:
        return Corner(asked=asked, told=bool(made.stops) and bool(made.warnings))
    corner = robot.kinematics().pose(sharp.trajectory(sharp.marks[1].begin))[:3, 3]
    way, blended = placed(robot, sharp.trajectory), placed(robot, made.trajectory)
    near = np.linalg.norm(way - corner, axis=1)
    t = np.linspace(0.0, sharp.duration, TIMES)
    stop = int(np.abs(t - sharp.marks[1].begin).argmin())
    first = stop - int((near[stop::-1] > used).argmax()) if (near[: stop + 1] > used).any() else 0
    last = stop + int((near[stop:] > used).argmax()) if (near[stop:] > used).any() else TIMES - 1
    rounded = blended[np.linalg.norm(blended - corner, axis=1) < used - 1e-4]
    beyond = beyond_hull(way[first : last + 1], rounded) if len(rounded) else 0.0
    return Corner(asked=asked, used=used, beyond=beyond, told=used > 0.999 * asked or bool(made.warnings))


def rows(name: str, count: int) -> list[str]:
    """The rows of one arm, one for each kind of corner."""
    robot, q, rng = mp.load_robot(name), np.array(AT[name]), np.random.default_rng(0)
    made: dict[str, list[Corner]] = {each: [] for each in KINDS}
    for k in track(range(count), description=name):
        kind = list(KINDS)[k % len(KINDS)]
        made[kind].append(measured(robot, KINDS[kind], q, rng))
    lines = []
    for kind, corners in made.items():
        planned = [each for each in corners if not each.message]
        blends = [each for each in planned if each.used]
        for message, times in Counter(each.message for each in corners if each.message).most_common(3):
            print(f"{name}, {kind}: {times} x {message}")
        beyond = np.array([each.beyond for each in blends] or [0.0])
        cells = [name, kind, len(planned), len(blends), sum(each.used > 0.999 * each.asked for each in blends)]
        cells += [len(planned) - len(blends), sum(not each.told for each in planned)]
        cells += [f"{1e3 * beyond.max():.3f}", int((beyond > ALLOWED).sum())]
        lines.append("| " + " | ".join(map(str, cells)) + " |")
    return lines


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--corners", type=int, default=500, help="number of corners, of all arms together")
    parser.add_argument("--arms", nargs="+", default=list(ARMS), choices=list(ARMS), help="the arms")
    parser.add_argument("--out", type=Path, default=OUT, help="the table's file")
    options = parser.parse_args(arguments)
    table = [
        "| arm | moves | corners | blended | with the radius asked for | stops | smaller without a warning "
        f"| beyond the hull: largest [mm] | by more than {1e3 * ALLOWED:g} mm |",
        "|---" * 9 + "|",
    ]
    for name in options.arms:
        table += rows(name, -(-options.corners // len(options.arms)))
    setting = f"{options.corners} corners; radii of {1e3 * RADII[0]:g} to {1e3 * RADII[1]:g} mm"
    options.out.write_text(
        "\n".join([*table, "", f"{setting}; Python {platform.python_version()}, {platform.machine()}; `make benchmark`."])
        + "\n"
    )
    print("\n".join(table))


if __name__ == "__main__":
    main()
