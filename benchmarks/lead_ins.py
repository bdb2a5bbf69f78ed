"""Lead-ins: how `mp.follow` with a start and a leading `mp.MoveAlong` enter a line of the tool, beside all ways to enter it.

Run with `make benchmark`. Writes docs/benchmarks/lead_ins.md. Random lines are followed from random starts. Beside each motion
stand all configurations of the first pose, one by one: the plan from the start to each, and the best motion along the line
that begins there. Manipulability, signs of det J and joint travel are measured with Pinocchio on the finished motions at dense
times. Times are CPU times.
"""

import argparse
import os
import platform
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray
from rich.progress import track
from scipy.spatial.transform import Rotation

import manipplan as mp

Array = NDArray[np.float64]
OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "lead_ins.md"
#: The arms, and how far from the base lines are [m].
ARMS = {"ur3": (0.2, 0.4), "ur5": (0.35, 0.7), "ur10": (0.45, 1.0), "panda": (0.35, 0.6)}
#: Lengths of lines [m], heights of their ends, and largest tilt of the tool from straight down [rad].
LENGTHS, HEIGHTS, TILT = (0.15, 0.5), (0.1, 0.5), 0.6
#: Maximum number of configurations of the first pose that are planned one by one, and times at which motions are measured.
CANDIDATES, TIMES = 24, 2000
#: Share of the best minimum that a motion has to keep, and travel of a joint beyond what is needed that it may have [rad].
ENOUGH, HALF_TURN = 0.9, np.pi


@dataclass(frozen=True, kw_only=True)
class Entry:
    """How one call enters a line.

    Attributes:
        minimum: smallest manipulability of the motion.
        crossings: number of changes of the sign of det J; 0 for an arm with more than six joints.
        excess: largest travel of a joint on the lead-in beyond its nearest turn [rad].
        seconds: CPU time.
    """

    minimum: float
    crossings: int
    excess: float
    seconds: float


class Judge:
    """Measures motions of an arm with Pinocchio alone."""

    def __init__(self, robot: mp.Robot) -> None:
        self.model, self.limits = robot.model, robot.limits
        self.data, self.frame = robot.model.createData(), robot.model.getFrameId(robot.tool)

    def jacobians(self, q: Array) -> Array:
        """Jacobians (k, 6, n) of the tool at q (k, n)."""
        rows = [pin.computeFrameJacobian(self.model, self.data, each, self.frame, pin.LOCAL_WORLD_ALIGNED).copy() for each in q]
        return np.array(rows)

    def minimum(self, motion: mp.Trajectory) -> float:
        """Smallest Yoshikawa index on a motion."""
        jacobians = self.jacobians(motion(np.linspace(0.0, motion.duration, TIMES)))
        products = jacobians @ jacobians.transpose(0, 2, 1)
        return float(np.sqrt(np.maximum(np.linalg.det(products), 0.0)).min())

    def crossings(self, motion: mp.Trajectory) -> int:
        """How often det J changes its sign on a motion."""
        jacobians = self.jacobians(motion(np.linspace(0.0, motion.duration, TIMES)))
        if jacobians.shape[2] != 6:
            return 0
        return int(np.count_nonzero(np.diff(np.linalg.det(jacobians) >= 0)))

    def excess(self, motion: mp.Trajectory, begin: float) -> float:
        """Largest travel of a joint up to a time beyond the way to the nearest turn that the limits allow the rest."""
        q = motion(np.linspace(0.0, begin, TIMES))
        rest = motion(np.linspace(begin, motion.duration, TIMES))
        excess = -np.inf
        for joint, (low, high) in enumerate(zip(self.limits.lower, self.limits.upper, strict=True)):
            turned = rest[:, joint, None] + 2 * np.pi * np.arange(-3, 4)
            inside = (turned.min(axis=0) >= low - 1e-6) & (turned.max(axis=0) <= high + 1e-6)
            needed = np.abs(turned[0, inside] - q[0, joint]).min()
            excess = max(excess, float(np.ptp(q[:, joint]) - needed))
        return excess


def down(position: Sequence[float], turn: Rotation) -> Array:
    """A pose whose tool points down but for a rotation."""
    pose = np.eye(4)
    pose[:3, :3] = turn.as_matrix() @ np.diag([1.0, -1.0, -1.0])
    pose[:3, 3] = position
    return pose


def lines(robot: mp.Robot, reach: tuple[float, float], count: int, rng: np.random.Generator) -> list[mp.CartesianPath]:
    """Random lines that the arm can follow."""
    found: list[mp.CartesianPath] = []
    while len(found) < count:
        ends = []
        for _ in range(2):
            radius, angle = rng.uniform(*reach), rng.uniform(-np.pi, np.pi)
            turn = Rotation.from_euler("zyx", [rng.uniform(-np.pi, np.pi), *rng.uniform(-TILT, TILT, 2)])
            ends.append(down([radius * np.cos(angle), radius * np.sin(angle), rng.uniform(*HEIGHTS)], turn))
        ends[1][:3, :3] = ends[0][:3, :3]
        if not LENGTHS[0] < np.linalg.norm(ends[1][:3, 3] - ends[0][:3, 3]) < LENGTHS[1]:
            continue
        path = mp.CartesianPath.line(*ends)
        try:
            plan = mp.follow(robot, path, throw=False)
        except mp.errors.InvalidInputError:
            continue
        if plan.report is not None and plan.report.passed:
            found.append(path)
    return found


def starts(robot: mp.Robot, count: int, rng: np.random.Generator) -> list[Array]:
    """Random configurations that are free of collisions and not nearly singular."""
    model, m = mp.Scene().collision_model(robot), robot.kinematics().manipulability
    usual = float(np.median(m(robot.random_configuration(rng, size=1000))))
    found: list[Array] = []
    while len(found) < count:
        q = robot.random_configuration(rng, size=20)
        found += list(q[~model.in_collision_rows(q) & (m(q) > 0.1 * usual)])
    return found[:count]


def nearest(q: Array, start: Array, robot: mp.Robot) -> Array:
    """A configuration with each joint by full turns as near to the start as the limits allow."""
    turned = q + 2 * np.pi * np.arange(-2, 3)[:, None]
    outside = (turned < robot.limits.lower) | (turned > robot.limits.upper)
    best = np.where(outside, np.inf, np.abs(turned - start)).argmin(axis=0)
    return turned[best, np.arange(len(q))]


@dataclass(frozen=True, kw_only=True)
class Way:
    """A configuration in which a line can begin, and the best motion along the line from there."""

    q: Array
    minimum: float
    crossings: int


def ways(robot: mp.Robot, path: mp.CartesianPath, judge: Judge) -> list[Way]:
    """The configurations of the first pose from which the line can be followed, each but for full turns once."""
    solutions = mp.inverse_kinematics(robot, path(0.0), samples=64 if robot.n > 6 else None).q
    middle = np.where(np.isfinite(robot.limits.lower), (robot.limits.lower + robot.limits.upper) / 2, 0.0)
    distinct: list[Array] = []
    rng = np.random.default_rng(0)
    for q in rng.permutation(solutions):
        away = [(q - other + np.pi) % (2 * np.pi) - np.pi for other in distinct]
        if all(np.abs(each).max() > 0.05 for each in away) and len(distinct) < CANDIDATES:
            distinct.append(nearest(q, middle, robot))
    found = []
    for q in distinct:
        try:
            plan = mp.follow(robot, path, start=q, throw=False)
        except mp.errors.InvalidInputError:
            continue
        if plan.report is not None and plan.report.passed:
            crossings = judge.crossings(plan.trajectory)
            found.append(Way(q=q, minimum=judge.minimum(plan.trajectory), crossings=crossings))
    return found


def best_of(robot: mp.Robot, start: Array, found: list[Way], judge: Judge) -> tuple[float, bool]:
    """The largest minimum over all ways, planned one by one, and whether one of them crosses no singularity."""
    best, free = 0.0, False
    for way in sorted(found, key=lambda each: -each.minimum):
        if way.minimum <= best and (free or robot.n > 6):
            break
        plan = mp.plan(robot, start, nearest(way.q, start, robot), throw=False)
        if plan.report is None or not plan.report.passed:
            continue
        best = max(best, min(way.minimum, judge.minimum(plan.trajectory)))
        free = free or judge.crossings(plan.trajectory) + way.crossings == 0
    return best, free


def followed(robot: mp.Robot, start: Array, path: mp.CartesianPath, judge: Judge) -> Entry | str:
    """The motion of `follow` with a start, or why there is none."""
    began = time.process_time()
    plan = mp.follow(robot, path, start=start, throw=False)
    if plan.report is None or not plan.report.passed:
        return plan.message
    return _entry(plan.trajectory, plan.path_begin, time.process_time() - began, judge)


def composed(robot: mp.Robot, start: Array, path: mp.CartesianPath, judge: Judge) -> Entry | str:
    """The motion of a program of one MoveAlong, or why there is none."""
    began = time.process_time()
    try:
        program = mp.sequence(robot, start, [mp.MoveAlong(path)])
    except mp.errors.PlanningError as error:
        return str(error)
    (mark,) = program.marks
    return _entry(program.trajectory, mark.path_begin or 0.0, time.process_time() - began, judge)


def _entry(motion: mp.Trajectory, begin: float, seconds: float, judge: Judge) -> Entry:
    excess = judge.excess(motion, begin)
    return Entry(minimum=judge.minimum(motion), crossings=judge.crossings(motion), excess=excess, seconds=seconds)


def rows(name: str, count: int, of_starts: int) -> list[str]:
    """The rows of one arm."""
    robot, rng = mp.load_robot(name), np.random.default_rng(0)
    judge = Judge(robot)
    jobs = {"`follow`": followed, "`MoveAlong`": composed}
    made: dict[str, list[tuple[Entry | str, float, bool]]] = {each: [] for each in jobs}
    for path in track(lines(robot, ARMS[name], count, rng), description=name):
        found = ways(robot, path, judge)
        for start in starts(robot, of_starts, rng):
            best, free = best_of(robot, start, found, judge)
            for job, call in jobs.items():
                made[job].append((call(robot, start, path, judge), best, free))
    return [_row(name, job, each) for job, each in made.items()]


def _row(name: str, job: str, made: list[tuple[Entry | str, float, bool]]) -> str:
    entries = [(entry, best, free) for entry, best, free in made if isinstance(entry, Entry)]
    for entry, _, _ in made:
        if isinstance(entry, str):
            print(f"{name}, {job}: {entry}")
    ratios = np.array([entry.minimum / best for entry, best, free in entries if best > 0 and free])
    shares = [f"{100 * (ratios >= ENOUGH).mean():.1f} %", f"{ratios.min():.3f}"] if len(ratios) else ["", ""]
    needless = sum(entry.crossings > 0 and free for entry, _, free in entries)
    must = sum(not free for _, _, free in entries)
    excess = np.array([entry.excess for entry, _, _ in entries])
    times = np.array([entry.seconds for entry, _, _ in entries])
    cells = [name, job, len(made), len(entries), *shares]
    cells += [must, needless, f"{np.maximum(excess, 0.0).max():.2f}", int((excess > HALF_TURN).sum())]
    cells += [f"{np.median(times):.1f} s", f"{times.max():.1f} s"]
    return "| " + " | ".join(map(str, cells)) + " |"


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--lines", type=int, default=50, help="number of lines of each arm")
    parser.add_argument("--starts", type=int, default=10, help="number of random starts of each line")
    parser.add_argument("--arms", nargs="+", default=list(ARMS), choices=list(ARMS), help="the arms")
    parser.add_argument("--out", type=Path, default=OUT, help="the table's file")
    options = parser.parse_args(arguments)
    table = [
        f"| arm | call | motions | found | minimum m at least {ENOUGH:g} of the best | smallest ratio "
        "| no way without a crossing | needless crossings | joint beyond its nearest turn: largest [rad] "
        "| by more than half a turn | time: median | largest |",
        "|---" * 12 + "|",
    ]
    for name in options.arms:
        table += rows(name, options.lines, options.starts)
    setting = f"{options.lines} lines of each arm, {options.starts} starts of each line"
    options.out.write_text(
        "\n".join(
            [*table, "", f"{setting}; CPU time; Python {platform.python_version()}, {platform.machine()}; `make benchmark`."]
        )
        + "\n"
    )
    print("\n".join(table))


if __name__ == "__main__":
    main()
