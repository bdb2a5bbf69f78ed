"""Goals given as poses of the tool, and sets of grasps: how often solved, minimum manipulability of the motion, and time.

Run with `make benchmark`. Writes docs/benchmarks/pose_goals.md. Poses: the Panda's problems of MotionBenchMaker, once with the
goal's joint values and once with nothing but the tool's pose, by turns. Grasps: the same problems, where the hand may also be
turned about its approach axis in steps of 36°; and a part on a table among random boxes, with ten poses of the hand around it.
Beside the plan to a set stands one to the free configuration of any grasp that is nearest to the start in joint space. Times
are CPU times of whole calls of `mp.plan`; what is built once per scene is there before.
"""

import argparse
import os
import platform
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import numpy as np
from numpy.typing import NDArray
from outside import problems
from rich.progress import track
from scipy.spatial.transform import Rotation

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "pose_goals.md"
#: Number of grasps per scene, and of boxes beside the part.
GRASPS, BOXES = 10, (3, 7)
#: Two minima of m that differ by less than this share count as equal.
SAME = 1e-6
#: Scenes in which at least this gain is possible have a line of their own.
ROOM = 1.5
#: Share of the bound by which a motion may miss it.
NEARLY = 0.01


@dataclass(frozen=True, kw_only=True)
class Pair:
    """Two plans of one problem.

    Attributes:
        set: name of the set of problems.
        usual, ours: minimum manipulability, nan without a motion that passed its check, and CPU time [s].
        bound: upper bound on the minimum manipulability of any motion to any of the goals, by the candidates of ours.
    """

    set: str
    usual: tuple[float, float]
    ours: tuple[float, float]
    bound: float

    @property
    def both(self) -> bool:
        """Whether both were solved."""
        return not np.isnan([self.usual[0], self.ours[0]]).any()

    @property
    def gain(self) -> float:
        """Our minimum manipulability over the usual one."""
        return self.ours[0] / self.usual[0]

    @property
    def most(self) -> float:
        """The largest gain that any motion to any goal could have."""
        return self.bound / self.usual[0]

    @property
    def is_best(self) -> bool:
        """Whether our motion reaches the bound, to NEARLY."""
        return self.ours[0] >= (1 - NEARLY) * self.bound

    @property
    def slower(self) -> float:
        """Our time over the usual one."""
        return self.ours[1] / self.usual[1]


def planned(robot: mp.Robot, start: NDArray[np.float64], goal: object, scene: mp.Scene) -> tuple[float, float, float]:
    """Minimum manipulability, CPU time [s] and largest bound of a plan."""
    began = time.process_time()
    try:
        plan = mp.plan(robot, start, goal, scene, throw=False)
    except mp.errors.InvalidInputError:  # no candidate is free
        return np.nan, time.process_time() - began, np.nan
    seconds = time.process_time() - began
    passed = plan.report is not None and plan.report.passed
    bound = max(each.bound for each in plan.candidates if each.is_free)
    return plan.report.min_manipulability if passed else np.nan, seconds, bound


def by_turns(robot: mp.Robot, name: str, start: NDArray[np.float64], goals: Sequence[object], scene: mp.Scene, k: int) -> Pair:
    """Plans to two goals; of every other problem the second goal comes first."""
    order = (0, 1) if k % 2 == 0 else (1, 0)
    made = {which: planned(robot, start, goals[which], scene) for which in order}
    return Pair(set=name, usual=made[0][:2], ours=made[1][:2], bound=made[1][2])


def outside(robot: mp.Robot, count: int) -> Iterator[Any]:
    """The first problems of each set of MotionBenchMaker whose start and goal are allowed."""
    left: dict[str, int] = {}
    for each in track(problems.load("panda"), description="MotionBenchMaker"):
        if left.setdefault(each.set, count) == 0 or (robot.limits.outside(np.array([each.start, each.goal])) > 0).any():
            continue
        model = each.scene.collision_model(robot)
        if model.in_collision_rows(np.array([each.start, each.goal])).any():
            continue
        left[each.set] -= 1
        yield each


def poses(robot: mp.Robot, count: int) -> list[Pair]:
    """Joint values beside the pose of the tool."""
    kinematics, pairs = robot.kinematics(), []
    for each in outside(robot, count):
        pose = kinematics.pose(each.goal)
        pairs.append(by_turns(robot, each.set, each.start, (each.goal, pose), each.scene, len(pairs)))
    return pairs


def turned_grasps(robot: mp.Robot, count: int) -> list[Pair]:
    """The hand of each problem's goal, turned about its approach axis, beside the nearest of these grasps."""
    kinematics, pairs = robot.kinematics(), []
    for each in outside(robot, count):
        grasps_of_it = []
        for k in range(GRASPS):
            pose = kinematics.pose(each.goal).copy()
            pose[:3, :3] = pose[:3, :3] @ Rotation.from_euler("z", 2 * np.pi * k / GRASPS).as_matrix()
            grasps_of_it.append(pose)
        usual = nearest(robot, each.start, grasps_of_it, each.scene)
        pairs.append(by_turns(robot, "turned", each.start, (usual, grasps_of_it), each.scene, len(pairs)))
    return pairs


def grasp_scene(rng: np.random.Generator) -> tuple[mp.Scene, list[NDArray[np.float64]]]:
    """A part on a table among boxes, and poses of the hand around the part: from above to level, from any side."""
    height = rng.uniform(0.0, 0.3)
    part = np.array([rng.uniform(0.35, 0.6), rng.uniform(-0.35, 0.35), height + 0.08])
    obstacles: list[mp.Obstacle] = [
        mp.Box(size=(0.8, 1.2, 0.04), position=(0.7, 0.0, height - 0.02), name="table"),
        mp.Cylinder(radius=0.015, length=0.16, position=part, name="part"),
    ]
    for k in range(rng.integers(*BOXES)):
        size = rng.uniform([0.05, 0.05, 0.1], [0.15, 0.15, 0.4])
        place = np.array([rng.uniform(0.35, 0.9), rng.uniform(-0.5, 0.5), height + size[2] / 2])
        if np.abs(place - part)[:2].max() > 0.2:
            obstacles.append(mp.Box(size=size, position=place, name=f"box {k}"))
    grasps = []
    for _ in range(GRASPS):
        tilt, side, turn = rng.uniform([np.pi / 2, -np.pi, -np.pi], [np.pi, np.pi, np.pi])
        pose = np.eye(4)
        pose[:3, :3] = Rotation.from_euler("ZYZ", [side, tilt, turn]).as_matrix()
        pose[:3, 3] = part + np.array([0.0, 0.0, rng.uniform(-0.02, 0.04)])
        grasps.append(pose)
    return mp.Scene(obstacles), grasps


def nearest(robot: mp.Robot, start: NDArray[np.float64], grasps: Sequence[NDArray[np.float64]], scene: mp.Scene):
    """The free configuration of any grasp that is nearest to the start; None where there is none."""
    q = mp.inverse_kinematics(robot, np.array(grasps)).q
    free = q[~scene.collision_model(robot).in_collision_rows(q)]
    return free[np.linalg.norm(free - start, axis=1).argmin()] if len(free) else None


def grasps(robot: mp.Robot, count: int) -> list[Pair]:
    """Plans in scenes in which some grasp is free."""
    rng, pairs = np.random.default_rng(0), []
    for _ in track(range(count), description="grasps"):
        while True:
            scene, poses_around = grasp_scene(rng)
            start = robot.neutral + rng.uniform(-0.3, 0.3, robot.n)
            if (robot.limits.outside(start) > 0).any() or scene.in_collision(robot, start):
                continue
            usual = nearest(robot, start, poses_around, scene)
            if usual is not None:
                break
        pairs.append(by_turns(robot, "ten grasps", start, (usual, poses_around), scene, len(pairs)))
    return pairs


def line(name: str, pairs: Sequence[Pair]) -> str:
    """The line of a set of problems."""
    both = [pair for pair in pairs if pair.both]
    gains, times = np.array([pair.gain for pair in both]), np.array([pair.slower for pair in both])
    solved = [sum(not np.isnan(getattr(pair, which)[0]) for pair in pairs) for which in ("usual", "ours")]
    cells = [name, len(pairs), *solved]
    if both:
        cells += [f"{100 * (gains >= 1 - SAME).mean():.1f} %", f"{gains.min():.3f}", f"{np.median(gains):.2f}"]
        cells.append(f"{np.median([pair.most for pair in both]):.2f}")
        cells.append(f"{100 * np.mean([pair.is_best for pair in both]):.0f} %")
        cells += [f"{np.median(times):.2f}", f"{np.quantile(times, 0.9):.2f}", f"{times.max():.1f}"]
        cells += [f"{1e3 * np.median([pair.ours[1] for pair in both]):.0f} ms"]
    return "| " + " | ".join(map(str, cells)) + " |"


def grasp_lines(name: str, pairs: Sequence[Pair]) -> list[str]:
    """The line of sets of grasps, and that of those in which a gain is possible."""
    room = [pair for pair in pairs if pair.both and pair.most >= ROOM]
    return [line(f"**{name}**", pairs), line(f"of these where {ROOM:g} is possible", room)]


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--problems", type=int, default=2, help="number of problems of each set")
    parser.add_argument("--scenes", type=int, default=20, help="number of scenes with ten grasps")
    parser.add_argument("--out", type=Path, default=OUT, help="the table's file")
    options = parser.parse_args(arguments)
    held = problems.robot("panda")
    robot = mp.load_robot("panda", locked={"panda_finger_joint1": 0.04, "panda_finger_joint2": 0.04})
    for arm in (held, robot):  # builds what is built once per arm
        goal = arm.neutral + 0.3
        for each in (goal, arm.kinematics().pose(goal)):
            mp.plan(arm, arm.neutral, each, mp.Scene([mp.Sphere(radius=0.05, position=(0.5, 0.5, 0.9))]))
    of_pose, of_grasps = poses(held, options.problems), grasps(robot, options.scenes)
    turned = turned_grasps(held, options.problems)
    names = list(dict.fromkeys(pair.set for pair in of_pose))
    lines = [
        "| problems | number | solved: joint values, or nearest grasp | solved: pose, or set | minimum m at least as high "
        "| its ratio: smallest | median | at most possible | reaches its bound "
        "| time ratio: median | 90 % | largest | median time |",
        "|---" * 13 + "|",
        *(line(name, [pair for pair in of_pose if pair.set == name]) for name in names),
        line("**all poses**", of_pose),
        *grasp_lines("ten grasps, MotionBenchMaker", turned),
        *grasp_lines("ten grasps, our scenes", of_grasps),
        "",
        f"The first {options.problems} free problems of each set of MotionBenchMaker; {options.scenes} scenes with ten grasps. "
        f"CPU time; Python {platform.python_version()}, {platform.machine()}; command: `make benchmark`.",
    ]
    options.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
