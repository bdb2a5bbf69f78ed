"""Both arms of a robot over a table: problems given by the poses of both tools, planned together and one arm after the other.

Run with `make benchmark`. Writes docs/benchmarks/two_arms.md. Poses are random, over a table with a few boxes; in every second
problem of Baxter the hands change sides, so that the arms have to pass each other. A problem counts as solved when the motion
passed its report and a judge: the robot's own meshes in coal at dense samples, arm against arm and among the obstacles,
Pinocchio's poses of both tools at the end, and the limits. Times are CPU times of whole calls of `mp.plan`; what is built once
per robot is there before.
"""

import argparse
import os
import platform
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import numpy as np
import pinocchio as pin
from meshes import STEP
from numpy.typing import NDArray
from rich.progress import track
from scipy.spatial.transform import Rotation

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "two_arms.md"
#: Number of boxes on the table, and distance that starts and goals keep from everything [m].
BOXES, ROOM = (1, 4), 0.01
#: The same distance for robots with links of their own that are always near each other [m].
LITTLE = 1e-3
#: Distance [m] and angle [rad] from the goal, and share or amount by which limits may be exceeded, that the judge allows.
REACHED, KEPT = 2e-6, 1e-6
#: Where the tools are over the table [m]: x, and y on either side and, crossed, on the other.
DEPTH, SIDE, ACROSS = (0.55, 0.8), (0.12, 0.45), (0.05, 0.2)
#: Where the tools of other robots are [m]: x at least, |y| at most, and height above the table at least.
OVER = (0.3, 0.5, 0.05)
#: Number of pairs of solutions that are tried for a free configuration of a pair of poses.
TRIES = 60
#: Number of values of the redundant joint for which they are solved.
SAMPLES = 8

Array = NDArray[np.float64]
Goal = dict[str, Array]


@dataclass(frozen=True, kw_only=True)
class Case:
    """A start, the poses of both tools to reach, and the table."""

    robot: mp.Robot
    scene: mp.Scene
    start: Array
    goal: Goal


@dataclass(frozen=True, kw_only=True)
class Outcome:
    """CPU time [s], the smallest manipulability of a tool, nan where the motion did not pass, and its duration [s]."""

    seconds: float
    minimum: float
    duration: float

    @property
    def solved(self) -> bool:
        """Whether the motion passed its report and the judge."""
        return not np.isnan(self.minimum)


class TwoArmJudge:
    """Both arms as the meshes of the description, each against the other and all obstacles."""

    def __init__(self, robot: mp.Robot, scene: mp.Scene) -> None:
        self.robot, self.data = robot, robot.model.createData()
        geometry = robot.geometry.copy()
        left, right = (set(robot.joints_of(tool)) for tool in robot.tools)
        sides = [self._side(item.parentJoint - 1, left, right) for item in geometry.geometryObjects]
        for i, one in enumerate(sides):
            for j, two in enumerate(sides[:i]):
                if {one, two} == {"left", "right"}:
                    geometry.addCollisionPair(pin.CollisionPair(i, j))
        for obstacle in scene.obstacles:
            for shape in obstacle.shapes():
                added = geometry.addGeometryObject(pin.GeometryObject(obstacle.name, 0, obstacle.pose, shape))
                for i, side in enumerate(sides):
                    if side:
                        geometry.addCollisionPair(pin.CollisionPair(i, added))
        self.geometry, self.placed = geometry, geometry.createData()

    @staticmethod
    def _side(joint: int, left: set[int], right: set[int]) -> str:
        if joint < 0:
            return ""
        return "both" if joint in left and joint in right else "left" if joint in left else "right"

    def accepts(self, motion: mp.Trajectory, goal: Goal) -> bool:
        """Whether limits, distances and both goals are kept."""
        limits, path = self.robot.limits, motion.path()
        q = path(path.fine_samples(STEP))
        t = np.linspace(0.0, motion.duration, 20_001)
        within = (limits.outside(q) <= KEPT).all()
        within &= (np.abs(motion(t, 1)) <= limits.velocity * (1 + KEPT)).all()
        within &= (np.abs(motion(t, 2)) <= limits.acceleration * (1 + KEPT)).all()
        parts = self.robot.model, self.data, self.geometry, self.placed
        if not within or any(pin.computeCollisions(*parts, each, True) for each in q):
            return False
        pin.framesForwardKinematics(self.robot.model, self.data, motion.q[-1])
        for tool, pose in goal.items():
            place = self.data.oMf[self.robot.model.getFrameId(tool)]
            apart = place.inverse() * pin.SE3(pose)
            if np.linalg.norm(apart.translation) > REACHED or np.linalg.norm(pin.log3(apart.rotation)) > REACHED:
                return False
        return True


def outcome(case: Case, plans: Callable[[], Sequence[mp.Plan]]) -> Outcome:
    """The result of a call that makes motions, the last of which ends at the goal."""
    began = time.process_time()
    try:
        made = plans()
    except (mp.errors.InvalidInputError, mp.errors.PlanningError):
        return Outcome(seconds=time.process_time() - began, minimum=np.nan, duration=np.nan)
    seconds = time.process_time() - began
    judge = TwoArmJudge(case.robot, case.scene)
    goals = [{}] * (len(made) - 1) + [case.goal]
    accepted = all(each.report.passed for each in made)
    accepted = accepted and all(judge.accepts(each.trajectory, goal) for each, goal in zip(made, goals, strict=True))
    least = min(figure.min_manipulability for each in made for figure in each.report.tools)
    duration = sum(each.trajectory.duration for each in made)
    return Outcome(seconds=seconds, minimum=least if accepted else np.nan, duration=duration)


def together(case: Case) -> Sequence[mp.Plan]:
    """Both arms at once."""
    return [mp.plan(case.robot, case.start, case.goal, case.scene)]


def one_after_the_other(case: Case) -> Sequence[mp.Plan]:
    """First one arm, then the other; in the other order where that fails."""
    tools = list(case.goal)
    for k, order in enumerate((tools, tools[::-1])):
        made: list[mp.Plan] = []
        start = case.start
        try:
            for tool in order:
                made.append(mp.plan(case.robot, start, {tool: case.goal[tool]}, case.scene))
                start = made[-1].trajectory.q[-1]
        except (mp.errors.InvalidInputError, mp.errors.PlanningError):
            if k == 1:
                raise
            continue
        return made
    return []


def table(rng: np.random.Generator, height: float) -> mp.Scene:
    """A table in front of the robot with a few boxes on it."""
    obstacles = [mp.Box(size=(0.6, 1.6, 0.05), position=(0.8, 0.0, height - 0.025), name="table")]
    for k in range(rng.integers(*BOXES)):
        size = rng.uniform([0.05, 0.05, 0.05], [0.12, 0.12, 0.25])
        place = [rng.uniform(0.6, 0.95), rng.uniform(-0.5, 0.5), height + size[2] / 2 + 1e-3]
        obstacles.append(mp.Box(size=size, position=place, name=f"box {k}"))
    return mp.Scene(obstacles)


def over_the_table(rng: np.random.Generator, height: float, *, crossed: bool) -> list[Array]:
    """Poses of the left and the right hand that look down at the table, each on its own side or on the other's."""
    poses = []
    for sign in (1, -1):
        y = -sign * rng.uniform(*ACROSS) if crossed else sign * rng.uniform(*SIDE)
        pose = np.eye(4)
        turn, tilt = rng.uniform([-np.pi, np.pi - 0.5], [np.pi, np.pi + 0.5])
        pose[:3, :3] = Rotation.from_euler("ZX", [turn, tilt]).as_matrix()
        pose[:3, 3] = rng.uniform(*DEPTH), y, height + rng.uniform(0.1, 0.35)
        poses.append(pose)
    return poses


def free_pair(robot: mp.Robot, scene: mp.Scene, poses: Sequence[Array], rng: np.random.Generator) -> Array | None:
    """A random free configuration with both tools at their poses; None where none was found."""
    ends = zip(robot.tools, poses, strict=True)
    sets = [mp.inverse_kinematics(robot.arm(tool), pose, samples=SAMPLES).q for tool, pose in ends]
    if not all(map(len, sets)):
        return None
    model = scene.collision_model(robot)
    for _ in range(TRIES):
        q = np.empty(robot.n)
        for tool, solutions in zip(robot.tools, sets, strict=True):
            q[list(robot.joints_of(tool))] = solutions[rng.integers(len(solutions))]
        if not model.in_collision(q, clearance=ROOM):
            return q
    return None


def baxter_case(robot: mp.Robot, number: int, seed: int) -> Case:
    """A problem of Baxter; with an odd number the hands change sides."""
    rng = np.random.default_rng([seed, number])
    while True:
        height = rng.uniform(-0.25, -0.1)
        scene = table(rng, height)
        crossed = (False, bool(number % 2))[:: rng.choice([1, -1])]
        ends = [over_the_table(rng, height, crossed=each) for each in crossed]
        found = [free_pair(robot, scene, poses, rng) for poses in ends]
        if found[0] is not None and found[1] is not None:
            return Case(robot=robot, scene=scene, start=found[0], goal=dict(zip(robot.tools, ends[1], strict=True)))


def random_case(robot: mp.Robot, number: int, seed: int, height: float) -> Case:
    """A problem of a robot with a torso: poses of random free configurations with both tools over the table."""
    rng = np.random.default_rng([seed, number])
    scene = table(rng, height)
    model, arms = scene.collision_model(robot), [robot.arm(tool) for tool in robot.tools]
    shared = sorted(set.intersection(*(set(robot.joints_of(tool)) for tool in robot.tools)))

    def free() -> tuple[Array, list[Array]]:
        while True:
            many = robot.random_configuration(rng, size=4000)
            q, poses = many[0].copy(), []  # one torso for all
            for arm, tool in zip(arms, robot.tools, strict=True):
                joints = list(robot.joints_of(tool))
                own = np.where(np.isin(joints, shared), q[joints], many[:, joints])
                places = arm.kinematics().pose(own)
                x, y, z = places[:, :3, 3].T
                over = np.flatnonzero((x > OVER[0]) & (np.abs(y) < OVER[1]) & (z > height + OVER[2]))
                if len(over):
                    q[joints] = own[over[0]]
                    poses.append(places[over[0]])
            if len(poses) == len(arms) and not model.in_collision(q, clearance=LITTLE):
                return q, poses

    start, (_, poses) = free()[0], free()
    return Case(robot=robot, scene=scene, start=start, goal=dict(zip(robot.tools, poses, strict=True)))


def line(name: str, both: Sequence[Outcome], single: Sequence[Outcome]) -> str:
    """The line of a set of problems."""
    times = np.array([each.seconds for each in both])
    pairs = [(a, b) for a, b in zip(both, single, strict=True) if a.solved and b.solved]
    ratios = np.array([a.minimum / b.minimum for a, b in pairs])
    shorter = np.array([a.duration / b.duration for a, b in pairs])
    cells = [name, len(both), sum(each.solved for each in both)]
    cells += [f"{np.median(times):.1f} s", f"{np.quantile(times, 0.9):.1f} s", f"{times.max():.1f} s"]
    cells += [sum(each.solved for each in single), f"{np.median([each.seconds for each in single]):.1f} s"]
    cells += [f"{ratios.min():.2f}", f"{np.median(ratios):.2f}", f"{ratios.max():.1f}"] if pairs else ["-"] * 3
    cells += [f"{np.median(shorter):.2f}", f"{shorter.max():.2f}"] if pairs else ["-"] * 2
    return "| " + " | ".join(map(str, cells)) + " |"


def solve(name: str, cases: Sequence[Case]) -> str:
    """Plan all problems of a set both ways; returns its line."""
    warm = cases[0]
    outcome(warm, lambda: together(warm))  # builds what is built once per robot
    both, single = [], []
    for case in track(cases, description=name):
        both.append(outcome(case, lambda case=case: together(case)))
        single.append(outcome(case, lambda case=case: one_after_the_other(case)))
    return line(name, both, single)


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--problems", type=int, default=50, help="number of problems of Baxter, of which half change sides")
    parser.add_argument("--others", type=int, default=10, help="number of problems of each other robot")
    parser.add_argument("--seed", type=int, default=0, help="seed of the problems")
    parser.add_argument("--out", type=Path, default=OUT, help="the table's file")
    options = parser.parse_args(arguments)
    baxter = mp.load_robot("baxter")
    cases = [baxter_case(baxter, k, options.seed) for k in track(range(options.problems), description="problems")]
    rows = [solve("baxter, own sides", cases[::2]), solve("baxter, hands change sides", cases[1::2])]
    for name, height in (("tiago_dual", 0.6), ("talos", 0.0)) if options.others else ():
        robot = mp.load_robot(name)
        rows.append(solve(name, [random_case(robot, k, options.seed, height) for k in range(options.others)]))
    lines = [
        "| robot | problems | solved and proven | time: median | 90 % | largest | solved one arm after the other | its median "
        "time | minimum m over that: smallest | median | largest | duration over that: median | largest |",
        "|---" * 13 + "|",
        *rows,
        "",
        f"CPU time; Python {platform.python_version()}, {platform.machine()}; command: `make benchmark`.",
    ]
    options.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
