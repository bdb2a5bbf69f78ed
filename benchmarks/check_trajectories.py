"""`mp.check` beside an independent judge: 1,000 trajectories of three arms, half of them spoilt in one respect.

Run with `make benchmark`. Writes docs/benchmarks/check_trajectories.md. The other judge is trajectory_judge.py. Both judge
every respect of every motion: a faster one also needs more acceleration, and one with a shifted joint may collide.
"""

import argparse
import os
import platform
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import numpy as np
from path_suite import PAIRS, load
from rich.progress import track
from trajectory_judge import Array, Judge, dense

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "check_trajectories.md"
ARMS, SCENES = ("panda", "ur5", "xarm7"), ("free", "table", "shelf")
#: Respects in which a motion is spoilt, and how `mp.check` begins its sentences about them.
RESPECTS = {
    "position": "position:",
    "velocity": "velocity:",
    "acceleration": "acceleration:",
    "jerk": "jerk:",
    "start": "start:",
    "goal": "goal:",
    "collision": ("collision:", "clearance:"),
    "tool error": "tool:",
}
#: Tolerance of `mp.check`, and margin around it in which the two may disagree [rad, m, share of a limit].
TOLERANCE, MARGIN = 1e-6, 1e-6
#: Jerk limits of an arm that has none [rad/s³], largest distance of waypoints from each other [rad], and number of waypoints.
JERK, REACH, WAYPOINTS = 5e3, 0.35, 4
#: Every PLANNED-th motion is planned, every INTERPOLATED-th one interpolates waypoints; the others are retimed. Period [s].
PLANNED, INTERPOLATED, RATE = 10, 3, 0.008


@dataclass(frozen=True, kw_only=True)
class Case:
    """A motion, what is asked of it, in which respect it is spoilt ("" for none), and the judge's excess in each respect."""

    robot: mp.Robot
    scene: mp.Scene
    motion: mp.Trajectory
    start: Array | None
    goal: Array | None
    clearance: float
    path: mp.CartesianPath | None
    tolerance: mp.Tolerance | None
    spoilt: str
    excesses: dict[str, float]


class Cell:
    """An arm in a scene: its motions, and those that are spoilt."""

    def __init__(self, arm: str, scene: str, rng: np.random.Generator) -> None:
        robot = mp.load_robot(arm)
        self.robot = robot.with_limits(jerk=np.where(np.isinf(robot.limits.jerk), JERK, robot.limits.jerk))
        self.scene = mp.Scene() if scene == "free" else mp.Scene.from_yaml(PAIRS / f"{scene}_{arm}.yaml")
        self.judge = Judge(self.robot, self.scene.collision_model(self.robot).geometry)
        pairs = [(pair["start"], pair["goal"]) for pair in load() if (pair["arm"], pair["scene"]) == (arm, scene)]
        self.pairs, self.rng = iter(pairs), rng

    def cases(self, numbers: Sequence[int], respects: Iterator[str]) -> Iterator[Case]:
        """Motions, those of odd numbers spoilt."""
        for k, number in enumerate(numbers):
            respect = next(respects) if number % 2 else ""
            through = respect == "collision" and number % 4 == 1  # through an obstacle, or too near to one
            yield self.case(self.motion(k, through=through), respect, through=through)

    def motion(self, k: int, *, through: bool) -> mp.Trajectory:
        """A motion slower than the limits allow, free of collisions unless it has to go `through` something."""
        pair = next(self.pairs, None) if k % PLANNED == 0 and not through else None
        if pair is not None:
            made = mp.plan(self.robot, *pair, self.scene, throw=False).trajectory
            if made is not None:
                return made.slower(1.1)
        low, high = self.robot.limits.lower + 0.3, self.robot.limits.upper - 0.3
        while True:
            centre = np.clip(self.robot.neutral + self.rng.uniform(-1.0, 1.0, self.robot.n), low, high)
            reach = REACH * (2 if through else 1)
            q = np.clip(centre + reach * self.rng.uniform(-1.0, 1.0, (WAYPOINTS, self.robot.n)), low, high)
            path = mp.JointPath.spline(np.linspace(0.0, 1.0, WAYPOINTS), q)
            if self.judge.touches(path(np.linspace(0.0, 1.0, 60))) == through:
                return self.interpolated(path) if k % INTERPOLATED == 0 else mp.retime(path, self.robot).slower(1.1)

    def interpolated(self, path: mp.JointPath) -> mp.Trajectory:
        """The spline at a constant rate of its parameter, sampled as a recorder would, at most as fast as the limits allow."""
        speed = np.abs(path(np.linspace(0.0, 1.0, 500), 1)) / self.robot.limits.velocity
        bend = np.abs(path(np.linspace(0.0, 1.0, 500), 2)) / self.robot.limits.acceleration
        duration = 1.2 * max(speed.max(), np.sqrt(bend.max()), 0.5)
        s = np.linspace(0.0, 1.0, int(duration / RATE) + 2)
        return mp.Trajectory(t=s * duration, q=path(s), qd=path(s, 1) / duration, joint_names=self.robot.joint_names)

    def case(self, motion: mp.Trajectory, respect: str, *, through: bool) -> Case:
        """A motion spoilt in one respect, by 1e-5 to 0.3 of a limit or in rad, or asked for more than it keeps."""
        size = 10.0 ** self.rng.uniform(-5.0, np.log10(0.3))
        if respect in SPOILS:
            motion = SPOILS[respect](self, motion, size)
        found, distance = self.judge.excesses(motion), self.judge.smallest_distance(dense(motion))
        ends = {"start": motion.q[0].copy(), "goal": motion.q[-1].copy()}
        ends = {end: q for end, q in ends.items() if not self.robot.limits.outside(q).any()}  # no such end can be asked for
        if respect in ends:
            joint = self.rng.integers(self.robot.n)  # moved towards the middle of its range, so that the end can be asked for
            ends[respect][joint] -= (
                size * np.sign(ends[respect] - (self.robot.limits.lower + self.robot.limits.upper) / 2)[joint]
            )
        gap = max(size / 10, 10 * MARGIN)
        near = 0.0 if through else max(distance + (gap if respect == "collision" else -gap), 0.0)
        found |= {end: np.abs(motion.q[0 if end == "start" else -1] - q).max() for end, q in ends.items()}
        found["collision"] = near - distance
        path = tolerance = None
        if respect in ("", "tool error") and self.rng.random() < (1.0 if respect else 0.25):
            path, tolerance, found["tool error"] = self.asked_of_the_tool(motion, spoilt=bool(respect))
        return Case(
            robot=self.robot,
            scene=self.scene,
            motion=motion,
            start=ends.get("start"),
            goal=ends.get("goal"),
            clearance=near,
            path=path,
            tolerance=tolerance,
            spoilt=respect,
            excesses=found,
        )

    def asked_of_the_tool(self, motion: mp.Trajectory, *, spoilt: bool) -> tuple[mp.CartesianPath, mp.Tolerance, float]:
        """A straight path between the ends, tolerances around what the tool keeps of it, and the excess."""
        begin, end = self.judge.poses(motion.q[[0, -1]])
        end[:3, :3] = begin[:3, :3]
        errors = np.array(self.judge.tool_errors(dense(motion), begin, end))
        allowed = errors * (1 + self.rng.uniform(0.05, 1.0, 2))
        if spoilt:
            which = self.rng.integers(2)
            allowed[which] = errors[which] / (1 + self.rng.uniform(0.05, 1.0))
        tolerance = mp.Tolerance(position=float(allowed[0]), rotation=float(allowed[1]))
        return mp.CartesianPath.line(begin, end), tolerance, float((errors - allowed).max())


def outside(cell: Cell, motion: mp.Trajectory, size: float) -> mp.Trajectory:
    """A joint shifted beyond its limit."""
    joint = cell.rng.integers(cell.robot.n)
    q = motion.q.copy()
    q[:, joint] += cell.robot.limits.upper[joint] + size - dense(motion)[:, joint].max()
    return replace(motion, q=q)


def too_fast(kind: str, order: int) -> Callable[[Cell, mp.Trajectory, float], mp.Trajectory]:
    """In less time, so that a limit is exceeded."""

    def spoil(cell: Cell, motion: mp.Trajectory, size: float) -> mp.Trajectory:
        ratio = 1 + cell.judge.excesses(motion)[kind]
        factor = (ratio / (1 + size)) ** (1 / order)
        return replace(motion, t=motion.t * factor, qd=motion.qd / factor)

    return spoil


def jerky(cell: Cell, motion: mp.Trajectory, size: float) -> mp.Trajectory:
    """In less time, or with a velocity at one sample that makes the acceleration jump."""
    if cell.rng.random() < 0.5:
        return too_fast("jerk", 3)(cell, motion, size)
    qd, k = motion.qd.copy(), cell.rng.integers(1, len(motion.t) - 1)
    qd[k] += size * 1e-2 * cell.robot.limits.velocity
    return replace(motion, qd=qd)


SPOILS = {
    "position": outside,
    "velocity": too_fast("velocity", 1),
    "acceleration": too_fast("acceleration", 2),
    "jerk": jerky,
}


def judged(case: Case) -> tuple[mp.results.Report, float]:
    """The report of `mp.check`, and its time [s]."""
    began = time.perf_counter()
    asked = {"start": case.start, "goal": case.goal, "path": case.path, "tolerance": case.tolerance}
    report = mp.check(case.robot, case.motion, case.scene, clearance=case.clearance, **asked)
    return report, time.perf_counter() - began


def table(cases: Sequence[Case], reports: Sequence[tuple[mp.results.Report, float]]) -> tuple[list[str], int]:
    """The lines of the table, and the number of disagreements."""
    lines = [
        "| respect | spoilt in it | judged | exceeded, by the other judge | same verdict | within the margin | disagreements |",
        "|---|---|---|---|---|---|---|",
    ]
    total: Counter[str] = Counter()
    for respect, begins in RESPECTS.items():
        row: Counter[str] = Counter()
        for case, (report, _) in zip(cases, reports, strict=True):
            if respect not in case.excesses:
                continue
            excess, found = case.excesses[respect], any(each.startswith(begins) for each in report.faults)
            row["judged"] += 1
            row["spoilt"] += case.spoilt == respect
            row["exceeded"] += excess > TOLERANCE
            same = found == (excess > TOLERANCE)
            near = abs(excess - TOLERANCE) < MARGIN
            row["same"] += same and not near
            row["near"] += near
            if not same and not near:
                row["different"] += 1
                print(f"{respect}: excess {excess:.9g}, {case.robot.name}, {report.faults}")
        total += row
        columns = ("spoilt", "judged", "exceeded", "same", "near", "different")
        lines.append(f"| {respect} | {' | '.join(str(row[each]) for each in columns)} |")
    lines.append(f"| all | {' | '.join(str(total[each]) for each in columns)} |")
    return lines, total["different"]


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=1000, help="number of trajectories")
    parser.add_argument("--out", type=Path, default=OUT, help="file of the table")
    given = parser.parse_args(arguments)
    rng = np.random.default_rng(20)
    respects = (each for _ in range(given.count) for each in RESPECTS)
    cells = [Cell(arm, scene, rng) for arm in ARMS for scene in SCENES]
    cases = []
    for k, cell in enumerate(cells):
        numbers = range(k, given.count, len(cells))
        cases += track(cell.cases(numbers, respects), total=len(numbers), description=cell.robot.name)
    for case in cases[:: max(len(cases) // 18, 1)]:
        judged(case)  # compiles, which no time counts
    reports = [judged(case) for case in track(cases, description="judging")]
    lines, different = table(cases, reports)
    times = 1e3 * np.array([seconds for _, seconds in reports])
    passed = sum(report.passed for report, _ in reports)
    lines += [
        "",
        f"{len(cases)} trajectories of {', '.join(ARMS)}, in no scene, over a table and in a shelf; {passed} pass, "
        f"{sum(bool(case.spoilt) for case in cases)} are spoilt. Time of a check: median {np.median(times):.0f} ms, 95 % "
        f"{np.percentile(times, 95):.0f} ms. Python {platform.python_version()}, {platform.machine()}, one thread; command: "
        f"`.venv/bin/python benchmarks/check_trajectories.py --count {given.count}`.",
    ]
    given.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))
    return different


if __name__ == "__main__":
    raise SystemExit(main())
