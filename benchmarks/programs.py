"""Programs: pick-and-place of eight motions, given by poses alone, beside choosing the configurations move by move.

Run with `make benchmark`. Writes docs/benchmarks/programs.md. Scenes of a table, a shelf and a bin for three arms by turns: the
arm goes to a pose from which it looks at the part, to the part with an approach, takes it up and lifts it, carries it to its
place with an approach, puts it down, retreats and goes home. Every grasp may be turned about the hand's axis in steps of 45°.
A second set of programs has grasps from above and from the side, tilted by up to 70°, and its place is one pose of the part:
the grasp determines how the arm can put it down. Move by move is the same planner, which gets each free motion with what
follows it by itself, so that it takes the grasp that is best for picking. Times are CPU times of whole calls of `mp.sequence`.
"""

from __future__ import annotations  # an older version lacks mp.results

import argparse
import os
import platform
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import numpy as np
from numpy.typing import NDArray
from rich.progress import track
from scipy.spatial.transform import Rotation

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "programs.md"
#: The arms, how far parts may be from the base [m], and how far the tool's origin is above the part it holds [m].
ARMS = {"panda": ((0.35, 0.6), 0.03), "ur5": ((0.35, 0.65), 0.07), "xarm7": ((0.3, 0.55), 0.07)}
#: The Panda's hand, open.
OPEN = {"panda_finger_joint1": 0.04, "panda_finger_joint2": 0.04}
PLACES = ("table", "shelf", "bin")
#: Size of the part [m], number of turns of a grasp, length of approach and retreat [m], and blend [m].
PART, TURNS, WAY, BLEND = np.array([0.04, 0.04, 0.08]), 8, 0.08, 0.04
#: Tilts of the grasps of parts that are placed by their own pose [rad].
TILTS = (0.0, 0.6, 1.2)
#: The sets of programs: whether places are poses of the part.
SETS = {"tool": False, "part": True}
#: Minima that differ by less than this share count as equal.
SAME = 0.01
#: Manipulability below this is rounding noise.
VANISHING = 1e-12


@dataclass(frozen=True, kw_only=True)
class Pair:
    """One program, chosen as a whole and move by move.

    Attributes:
        set: arm and place.
        of_part: whether the place is a pose of the part.
        together, by_moves: minimum manipulability, nan where there is no program, and CPU time [s].
        stops: number of stops at corners of the first.
        message: why there is no program.
    """

    set: str
    of_part: bool
    together: tuple[float, float]
    by_moves: tuple[float, float]
    stops: int
    message: str

    @property
    def both(self) -> bool:
        """Whether both were found."""
        return not np.isnan([self.together[0], self.by_moves[0]]).any()

    @property
    def gain(self) -> float:
        """The ratio of the minima; 1 where both cross singularities."""
        if max(self.together[0], self.by_moves[0]) < VANISHING:
            return 1.0
        return self.together[0] / max(self.by_moves[0], VANISHING)


def world(place: str, at: NDArray[np.float64], rng: np.random.Generator) -> list[mp.Obstacle]:
    """What stands where the part is put down at `at`, the middle of its bottom: nothing more, a shelf over it, or a bin."""
    side = np.arctan2(at[1], at[0])
    turn = Rotation.from_euler("z", side).as_matrix()

    def plate(size: Sequence[float], middle: Sequence[float], name: str) -> mp.Box:
        return mp.Box(size=size, position=at + turn @ np.array(middle), rotation=turn, name=name)

    if place == "shelf":
        deep, high = rng.uniform(0.18, 0.24), rng.uniform(0.5, 0.6)
        back = plate((0.02, 0.5, high), (deep / 2 + 0.05, 0.0, high / 2 - 0.02), "back")
        return [plate((deep, 0.5, 0.02), (0.02, 0.0, high), "upper board"), back]
    if place == "bin":
        wide, high = rng.uniform(0.24, 0.3), rng.uniform(0.06, 0.1)
        walls = [((0.01, wide, high), (sign * wide / 2, 0.0, high / 2)) for sign in (-1, 1)]
        walls += [((wide, 0.01, high), (0.0, sign * wide / 2, high / 2)) for sign in (-1, 1)]
        return [plate(size, middle, f"wall {k}") for k, (size, middle) in enumerate(walls)]
    return []


def grasps(middle: NDArray[np.float64], above: float, tilt: float = 0.0) -> list[NDArray[np.float64]]:
    """Poses of the hand at a distance from the middle of a part, turned about the vertical; tilted [rad]: beside it."""
    poses = []
    for k in range(TURNS):
        pose = np.eye(4)
        pose[:3, :3] = Rotation.from_euler("ZX", [2 * np.pi * k / TURNS, np.pi - tilt]).as_matrix()
        pose[:3, 3] = middle - above * pose[:3, 2]
        poses.append(pose)
    return poses


def problem(
    robot: mp.Robot, name: str, place: str, rng: np.random.Generator, of_part: bool
) -> tuple[list[mp.results.ProgramStep], mp.Scene]:
    """The steps of a program, and its scene; `of_part`: its place is a pose of the part."""
    reach, above = ARMS[name]
    height = rng.uniform(0.0, 0.15)
    spots = []
    for side in (-1, 1):
        far, angle = rng.uniform(*reach), side * rng.uniform(0.4, 1.3)
        spots.append(np.array([far * np.cos(angle), far * np.sin(angle), height + 1e-3]))
    if rng.random() < 0.5:
        spots.reverse()
    begin, end = spots
    up = np.array([0.0, 0.0, PART[2] / 2])
    obstacles = [
        mp.Box(size=(1.0, 1.8, 0.04), position=(0.6, 0.0, height - 0.02), name="table"),
        mp.Box(size=PART, position=begin + up, name="part"),
        mp.Box(
            size=(0.08, 0.08, 0.25), position=(rng.uniform(0.35, 0.6), rng.uniform(-0.08, 0.08), height + 0.125), name="post"
        ),
        *world(place, end, rng),
    ]
    scene = mp.Scene(obstacles).allow("part", "table")
    look = grasps(begin + up + np.array([0.0, 0.0, 0.25]), above)
    picks, places = grasps(begin + up, above), grasps(end + up, above)
    if of_part:
        picks = [pose for tilt in TILTS for pose in grasps(begin + up, above, tilt)]
        pose = np.eye(4)
        pose[:3, :3] = Rotation.from_euler("z", rng.uniform(-np.pi, np.pi)).as_matrix()
        pose[:3, 3] = end + up
        places = [mp.PoseGoal(pose, of="part")]
    steps: list[mp.results.ProgramStep] = [
        mp.MoveTo(look),
        mp.MoveTo(picks, approach=WAY),
        mp.Attach("part"),
        mp.MoveAlong([0.0, 0.0, -WAY]),
        mp.MoveTo(places, approach=WAY),
        mp.Detach("part"),
        mp.MoveAlong([0.0, 0.0, -WAY]),
        mp.MoveTo(robot.neutral),
    ]
    return steps, scene


def together(robot: mp.Robot, steps: Sequence[mp.results.ProgramStep], scene: mp.Scene) -> tuple[mp.Program | None, float, str]:
    """The program as a whole, its CPU time [s], and why there is none."""
    began = time.process_time()
    try:
        program, message = mp.sequence(robot, robot.neutral, steps, scene, blend=BLEND), ""
    except (mp.errors.PlanningError, mp.errors.InvalidInputError) as error:
        program, message = None, str(error)
    return program, time.process_time() - began, message


def by_moves(robot: mp.Robot, steps: Sequence[mp.results.ProgramStep], scene: mp.Scene) -> tuple[float, float]:
    """Minimum manipulability and CPU time [s] where each free motion with what follows is a program of its own."""
    began, least, q = time.process_time(), np.inf, robot.neutral
    groups: list[list[mp.results.ProgramStep]] = []
    for step in steps:
        groups += [[]] if isinstance(step, mp.MoveTo) else []
        groups[-1].append(step)
    try:
        for group in groups:
            made = mp.sequence(robot, q, group, scene, blend=BLEND)
            least = min(least, made.min_manipulability)
            robot, scene, q = made.final_state
    except (mp.errors.PlanningError, mp.errors.InvalidInputError):
        least = np.nan
    return least, time.process_time() - began


def line(name: str, pairs: Sequence[Pair]) -> str:
    """The line of a set."""
    solved = [each for each in pairs if not np.isnan(each.together[0])]
    both = [each for each in pairs if each.both]
    gains = np.array([each.gain for each in both])
    apart = gains[np.abs(np.log(gains)) > SAME]
    times = np.array([each.together[1] for each in solved])
    cells = [name, len(pairs), len(solved), sum(each.stops for each in solved), sum(not np.isnan(e.by_moves[0]) for e in pairs)]
    if not both:
        return "| " + " | ".join(map(str, cells)) + " |"
    cells += [f"{100 * (gains >= 1 - SAME).mean():.1f} %", f"{gains.min():.3f}", len(apart)]
    cells += [f"{np.median(apart):.2f}" if len(apart) else ""]
    cells += [f"{np.median(times):.2f} s", f"{np.quantile(times, 0.9):.2f} s", f"{times.max():.1f} s"]
    return "| " + " | ".join(map(str, cells)) + " |"


def pairs_of(count: int, of_part: bool) -> list[Pair]:
    """The programs of a set."""
    rng, pairs = np.random.default_rng(int(of_part)), []
    arms = {name: mp.load_robot(name, locked=OPEN if name == "panda" else {}) for name in ARMS}
    for k in track(range(count), description="programs"):
        name, place = list(ARMS)[k % len(ARMS)], PLACES[k // len(ARMS) % len(PLACES)]
        while True:
            steps, scene = problem(arms[name], name, place, rng, of_part)
            if not scene.in_collision(arms[name], arms[name].neutral):
                break
        made, seconds, message = together(arms[name], steps, scene)
        least = np.nan if made is None else made.min_manipulability
        if message:
            print(f"{name}, {place}: {message[:300]}")
        pairs.append(
            Pair(
                set=f"{name}, {place}",
                of_part=of_part,
                together=(least, seconds),
                by_moves=by_moves(arms[name], steps, scene),
                stops=0 if made is None else len(made.stops),
                message=message,
            )
        )
    return pairs


def table(pairs: Sequence[Pair], of_part: bool) -> list[str]:
    """The lines of a set of programs."""
    what = "place by the part's pose" if of_part else "place by the tool's pose"
    return [
        f"| {what} | number | solved and proven | stops at corners | solved move by move | minimum m at least as high as "
        "move by move | its ratio: smallest | number that differ | median of those | median time | 90 % | largest |",
        "|---" * 12 + "|",
        *(line(name, [each for each in pairs if each.set.startswith(name)]) for name in ARMS),
        *(line(place, [each for each in pairs if each.set.endswith(place)]) for place in PLACES),
        line("**all**", pairs),
        "",
    ]


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--programs", type=int, default=100, help="number of programs of each set")
    parser.add_argument("--sets", nargs="+", choices=SETS, default=list(SETS), help="whose poses the places are")
    parser.add_argument("--out", type=Path, default=OUT, help="the table's file")
    options = parser.parse_args(arguments)
    lines: list[str] = []
    for name in options.sets:
        lines += table(pairs_of(options.programs, SETS[name]), SETS[name])
    lines += [
        f"{options.programs} programs of eight motions in each table; blend {1e3 * BLEND:g} mm. Minima that differ by less "
        f"than {100 * SAME:g} % count as equal. CPU time; Python {platform.python_version()}, {platform.machine()}; "
        "command: `make benchmark`.",
    ]
    options.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
