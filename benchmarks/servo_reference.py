"""A plan as the reference of `mp.Servo` and `mp.track`: how near a motion without foresight comes to the optimum.

Run with `.venv/bin/python benchmarks/servo_reference.py`; it takes half an hour to two hours. --folder keeps the
tasks. Writes docs/benchmarks/servo_reference.md.

A task is a line of the tool of 0.6 to 0.9 of the arm's reach, on which the tool turns by up to 0.8 rad about each axis. The
plan is that of `mp.follow`, with its start free. The tool then moves on a disturbed path, which begins at the same pose: it is
displaced by sines of 20 mm and 0.05 rad (standard deviation of the amplitudes) that swing 1.2 to 4.8 times along it. Arms of
seven joints follow poses, those of six the position and the tool's axis. The timing is cubic, such that the optimum would need
at most half of the joint speeds. The servo gets the velocity of the target and ten times the deviation as a twist.

The figure is the minimum manipulability of the motion over that of the optimum: `mp.follow` of the disturbed path itself, with
its start free. The judge computes manipulability, deviation and limits by Pinocchio alone, from the arm's URDF file.
"""

import os

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import argparse
import itertools
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pinocchio as pin
from servo import described
from servo_judge import SCALE, Arm, Array
from servo_laws import robot_of

import manipplan as mp

ROOT = Path(__file__).resolve().parents[1]
OUT = ROOT / "docs" / "benchmarks" / "servo_reference.md"
NAMES = ("panda", "ur5", "xarm7", "kinova")
#: Time step [s], gain on the deviation of the tool [1/s], and share of the joint speeds that the optimum needs at most.
DT, GAIN, PACE = 0.004, 10.0, 0.5
#: A motion that deviates more has not followed the path [m, with 0.3 m per radian].
FOLLOWED = 5e-3
#: Minimum manipulability over the optimum's that is wanted.
WANTED = 0.95


@dataclass(frozen=True, kw_only=True)
class Case:
    """A task: `poses` (121, 4, 4) of the disturbed path, the plan without disturbance, samples (600, n) of the optimum's
    motion, its duration [s], and the configuration (n,) at the first pose that is nearest to the neutral one."""

    arm: str
    poses: Array
    plan: mp.Plan
    optimum: Array
    seconds: float
    nearest: Array


def task_of(robot: mp.Robot) -> mp.Task:
    return mp.Task.pose(0.3) if robot.n > 6 else mp.Task.pointing((0.0, 0.0, 1.0), length=0.3)


def plan_for(robot: mp.Robot, path: mp.CartesianPath, positions: tuple[int, int]) -> mp.Plan | None:
    """The plan of a path, or None where there is none."""
    grid = {"positions": positions[0]} if robot.n > 6 else {"positions": positions[1], "samples": 48}
    try:
        return mp.follow(robot, path, objective=mp.PathObjective(task=task_of(robot)), **grid)  # type: ignore[call-overload,no-any-return]
    except (mp.errors.InvalidInputError, mp.errors.PlanningError):  # out of reach, not connected
        return None


def disturbed(path: mp.CartesianPath, seed: int) -> Array:
    """Poses (121, 4, 4) of the disturbed path."""
    rng = np.random.default_rng(seed)
    size = np.concatenate([0.02 * rng.standard_normal(3), 0.05 * rng.standard_normal(3)])
    phase, swings, poses = rng.uniform(0, 2 * np.pi, 6), rng.uniform(1.2, 4.8, 6), []
    for u in np.linspace(0, 1, 121):
        pose = np.array(path(u))
        shift = size * (np.sin(2 * np.pi * swings * u + phase) - np.sin(phase)) * min(1, u / 0.1)
        pose[:3, :3] = pin.exp3(shift[3:]) @ pose[:3, :3]
        pose[:3, 3] += shift[:3]
        poses.append(pose)
    return np.array(poses)


def along(motion: mp.Trajectory, count: int = 600) -> Array:
    return np.asarray(motion(np.linspace(0, motion.duration, count)))


def duration(robot: mp.Robot, path: mp.CartesianPath, optimum: Array, least: float) -> float:
    """Seconds in which the optimum needs at most PACE of the joint speeds, with the timing of a motion."""
    s = np.linspace(0, 1, 801)
    points, tool = path(s)[:, :3, 3], robot.kinematics(task_of(robot)).pose(optimum)[:, :3, 3]
    at, places = 0, []
    for point in tool:
        near = points[at : at + 40]
        at += int(np.argmin(np.linalg.norm(near - point, axis=1)))
        places.append(s[at])
    where, first = np.unique(places, return_index=True)
    grid = np.linspace(0, 1, 81)
    change = 80 * np.diff([np.interp(grid, where, joint) for joint in optimum[first].T]).T
    u = 0.5 - np.sin(np.arcsin(1 - (grid[1:] + grid[:-1])) / 3)
    return max(least, float((np.abs(change) * (6 * u * (1 - u))[:, None] / robot.limits.velocity).max()) / PACE)


def cases(name: str, count: int, folder: Path) -> Iterator[Case]:
    """The first tasks that have a plan without and with the disturbance; those that are in the folder are read."""
    robot = mp.load_robot(name)
    kinematics = robot.kinematics(task_of(robot))
    rng = np.random.default_rng(7)
    lower, upper = np.maximum(robot.limits.lower, -np.pi), np.minimum(robot.limits.upper, np.pi)
    reach = max(np.linalg.norm(kinematics.pose(q)[:3, 3]) for q in rng.uniform(lower, upper, (2000, robot.n)))
    attempt = found = 0

    def inside(pose: Array) -> bool:
        return bool(0.25 * reach < np.linalg.norm(pose[:3, 3]) < 0.75 * reach and pose[2, 3] > 0.1 * reach)

    while found < count:
        attempt += 1
        q = rng.uniform(lower + 0.2 * (upper - lower), upper - 0.2 * (upper - lower))
        begin = np.array(kinematics.pose(q))
        shift = rng.standard_normal(3)
        shift *= reach * rng.uniform(0.6, 0.9) / np.linalg.norm(shift)
        end = np.eye(4)
        end[:3, :3], end[:3, 3] = begin[:3, :3] @ pin.exp3(0.8 * rng.uniform(-1, 1, 3)), begin[:3, 3] + shift
        if not (inside(begin) and inside(end) and inside((begin + end) / 2)):
            continue
        here, path = folder / f"{name}_{attempt}", mp.CartesianPath.line(begin, end)
        if not (here / "case.npz").is_file():
            here.mkdir(parents=True, exist_ok=True)
            poses, plan = disturbed(path, attempt), plan_for(robot, path, (40, 30))
            best = None if plan is None else plan_for(robot, mp.CartesianPath.through(poses), (60, 45))
            if plan is None or best is None:
                np.savez(here / "case.npz", solved=False)
            else:
                plan.save(here)
                solutions = mp.inverse_kinematics(robot, begin, task=task_of(robot), samples=24).q
                nearest = solutions[np.argmin(np.abs(solutions - robot.neutral).max(axis=1))]
                least = max(4.0, 2 * plan.trajectory.duration, 2 * best.trajectory.duration)
                optimum = along(best.trajectory)
                np.savez(here / "case.npz", solved=True, poses=poses, optimum=optimum, least=least, nearest=nearest)
        stored = np.load(here / "case.npz")
        if not stored["solved"]:
            continue
        found += 1
        through, optimum = mp.CartesianPath.through(stored["poses"]), stored["optimum"]
        yield Case(
            arm=name, poses=stored["poses"], plan=mp.Plan.load(here), optimum=optimum, nearest=stored["nearest"],
            seconds=duration(robot, through, optimum, float(stored["least"])),
        )  # fmt: skip


class Judge:
    """Manipulability, deviation and limits by Pinocchio alone."""

    def __init__(self, arm: Arm) -> None:
        self.arm, self.points = arm, arm.n == 6

    def manipulability(self, motion: Array) -> Array:
        """Of the rows that are followed (N,)."""
        found = []
        for q in motion:
            arm = self.arm
            whole = arm.configuration(q)
            J = pin.computeFrameJacobian(arm.model, arm.data, whole, arm.frame, pin.LOCAL) * SCALE[:, None]
            rows = J[: 5 if self.points else 6, arm.columns]
            found.append(np.sqrt(max(np.linalg.det(rows @ rows.T), 0)))
        return np.array(found)

    def error(self, target: Array, q: Array) -> Array:
        """Displacement (6,) of the tool to a target in world axes [m, rad], without a turn about a free axis."""
        pose = self.arm.pose(q)
        if self.points:
            turn = pin.log3(pin.Quaternion.FromTwoVectors(pose.rotation[:, 2], target[:3, 2]).matrix())
        else:
            turn = pin.log3(target[:3, :3] @ pose.rotation.T)
        return np.concatenate([target[:3, 3] - pose.translation, turn])

    def figures(self, case: Case, targets: Array, motion: Array, rates: Array) -> tuple[float, float, float]:
        """Minimum manipulability over the optimum's, largest deviation, and the largest excess over a limit as a share."""
        arm = self.arm
        ratio = self.manipulability(motion).min() / self.manipulability(case.optimum).min()
        far = max(np.linalg.norm(SCALE * self.error(*each)) for each in zip(targets[::5], motion[::5], strict=False))
        over = [np.abs(rates) / arm.velocity - 1, np.abs(np.diff(rates, axis=0)) / DT / arm.acceleration - 1]
        outside = max(float((arm.lower - motion).max()), float((motion - arm.upper).max()))
        return float(ratio), float(far), max(float(each.max()) for each in (*over, np.array([outside])))


def serve(judge: Judge, targets: Array, servo: mp.Servo, start: Array) -> tuple[Array, Array]:
    """Positions and velocities (N, n) of a servo that gets the twist of the target and GAIN times the deviation."""
    q, rate = np.array(start), np.zeros(servo.robot.n)
    servo.reset()
    motion, rates = [q], [rate]
    for before, target in itertools.pairwise(targets):
        turn = pin.log3(target[:3, :3] @ before[:3, :3].T)
        forward = np.concatenate([target[:3, 3] - before[:3, 3], turn]) / DT
        rate = servo.step(q, rate, forward + GAIN * judge.error(before, q), "world")
        q = q + DT * rate
        motion.append(q)
        rates.append(rate)
    return np.array(motion), np.array(rates)


def laws(judge: Judge, case: Case) -> dict[str, Callable[[], tuple[Array, Array, Array]]]:
    """Each way to follow the disturbed path: targets, positions and velocities."""
    robot = robot_of(case.arm)
    task, path = task_of(robot), mp.CartesianPath.through(case.poses)
    u = np.linspace(0, 1, round(case.seconds / DT) + 1)
    targets = path(3 * u**2 - 2 * u**3)
    begin = case.plan.trajectory(case.plan.path_begin)

    def by_servo(start: Array, reference: mp.Plan | None) -> tuple[Array, Array, Array]:
        servo = mp.Servo(robot, dt=DT, task=task, reference=reference)
        return (targets, *serve(judge, targets, servo, start))

    def by_track(start: Array, reference: mp.Plan | None) -> tuple[Array, Array, Array]:
        formulation = mp.formulations.LogDrive()
        options = {"dt": DT, "duration": case.seconds, "task": task, "compiled": reference is None}
        made = mp.track(robot, path, start, formulation, reference=reference, **options)  # type: ignore[arg-type]
        return made.targets, made.q, made.qd

    ways = {
        "start nearest to neutral": (case.nearest, None),
        "start of the plan": (begin, None),
        "reference": (begin, case.plan),
    }
    calls = {"`mp.Servo`": by_servo, "`mp.track`, `LogDrive`": by_track}
    return {f"{tool}, {way}": lambda c=call, w=given: c(*w) for tool, call in calls.items() for way, given in ways.items()}  # type: ignore[misc]


def row(*cells: str) -> str:
    return "| " + " | ".join(cells) + " |"


def summary(name: str, figures: Array) -> str:
    """A row of the table of figures (k, 3)."""
    ratio, far, over = figures.T
    good = ratio >= WANTED
    return row(
        name,
        f"{np.median(ratio):.3f}, {np.quantile(ratio, 0.1):.3f}, {ratio.min():.3f}",
        f"{good.sum()} of {len(good)}",
        f"{(good & (far <= FOLLOWED)).sum()}",
        f"{1e3 * np.median(far):.1f}, {1e3 * far.max():.0f} mm",
        f"{over.max():.0e}",
    )


def measure(name: str, arm: Arm, count: int, folder: Path) -> dict[str, list[tuple[float, float, float]]]:
    """The figures of each law in all tasks of an arm."""
    judge, found = Judge(arm), dict[str, list[tuple[float, float, float]]]()
    for k, case in enumerate(cases(name, count, folder)):
        for law, move in laws(judge, case).items():
            found.setdefault(law, []).append(judge.figures(case, *move()))
        print(name, k, {law: [round(x, 4) for x in each[-1]] for law, each in found.items()}, flush=True)
    return found


def measure_of(name: str, description: dict[str, object], *given: Any) -> dict[str, list[tuple[float, float, float]]]:
    """The same from the arm's description, as models of Pinocchio stay in their process."""
    return measure(name, Arm(description), *given)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=25, help="number of tasks of each arm")
    parser.add_argument("--folder", type=Path, default=ROOT / ".servo_reference", help="folder that keeps the tasks")
    parser.add_argument("--workers", type=int, default=2, help="number of arms at a time")
    given = parser.parse_args()
    descriptions = {name: arm.description for name, arm in described().items()}
    with ProcessPoolExecutor(given.workers) as pool:
        futures = {name: pool.submit(measure_of, name, descriptions[name], given.count, given.folder) for name in NAMES}
        by_name = {name: future.result() for name, future in futures.items()}
    found = {law: {name: by_name[name][law] for name in NAMES} for law in by_name[NAMES[0]]}
    head = row(
        "law",
        "over the optimum: median, 10 %, worst",
        f"at least {WANTED:g}",
        "of these within 5 mm",
        "deviation",
        "over limits",
    )
    lines = [head, "|" + "---|" * 6]
    lines += [summary(law, np.array([each for arm in by_arm.values() for each in arm])) for law, by_arm in found.items()]
    lines += ["", "With the reference, arm by arm:", "", head, "|" + "---|" * 6]
    for law, by_arm in found.items():
        if law.endswith("reference"):
            lines += [summary(f"{law.partition(',')[0]}, {name}", np.array(each)) for name, each in by_arm.items()]
    lines += ["", f"Command: `.venv/bin/python benchmarks/servo_reference.py --count {given.count}`."]
    OUT.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
