"""`mp.Servo` on twist streams through, along and out of singularities, beside our controller and rules of the literature.

Run with `.venv/bin/python benchmarks/servo.py` [number of random streams, 1000]. Writes docs/benchmarks/servo.md. The streams
are those of servo_streams.py, the judge is servo_judge.py: 17 designed streams of 20 s for all laws, 20 mm from rest along 12
directions out of five singular postures, and random streams that begin at or near random singular postures of six arms, for
`mp.Servo` alone. Arms have no jerk limits here.

- share near: tool speed along the command over the largest that joint speeds and braking allow with at most 0.3 of it across,
  within 1 s of a smallest singular value below 0.05 m (0.3 m per radian)
- followed: share of the command over everything, at the edge of the reach as well
- stalled: time in windows of 0.25 s with less than 5 % followed, although a pose 5 mm ahead is reachable
- backward: share of samples that move backward by more than 2 % of the command
- chatter: changes of sign of joint accelerations above 2 % of their limits, per second and joint
- leaving: of 45 cases that a posture exists for, and time over a lower bound joint by joint
"""

import os

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import json
import platform
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from pathlib import Path

import example_robot_data as erd
import numpy as np
import pinocchio as pin
from rich.progress import track
from servo_judge import DT, LENGTH, Arm, Array, Law, arms, judge, leaving_bound, simulate
from servo_laws import LAWS, Ours, robot_of
from servo_streams import POSTURES, designed, is_walk, steady, touching

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "servo.md"
NAMES = ("panda", "ur5", "xarm7", "kinova", "so100", "baxter_left")
DISTANCE = 0.02
Figures = dict[str, float]


def described() -> dict[str, Arm]:
    """The arms as their own URDF files describe them; of the package the accelerations and the rows of the task."""
    found = {}
    for name in NAMES:
        robot, file = robot_of(name), erd.load("baxter" if name == "baxter_left" else name).urdf
        rows = [0, 1, 2] if robot.default_task.name == "position" else list(range(6))
        found[name] = {
            "name": name,
            "urdf": str(file),
            "tool": robot.tool,
            "joints": list(robot.joint_names),
            "rows": rows,
            "acceleration": robot.limits.acceleration.tolist(),
        }
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "arms.json"
        path.write_text(json.dumps(found))
        return arms(path)


def leave(make: Callable[[Arm], Law], models: dict[str, Arm], bounds: dict[str, float | None]) -> list[float | None]:
    """Time over its bound of each case that has one; None where the arm does not get there within 4 s."""
    found: list[float | None] = []
    for name, (arm_name, posture) in POSTURES.items():
        arm, start = models[arm_name], np.array(posture)
        law: Law = make(arm)
        for i in range(12):
            twist = np.zeros(6)
            twist[i // 2] = (0.1 if i < 6 else 0.1 / LENGTH) * (1 - 2 * (i % 2))
            key = f"{name} {i}"
            if key not in bounds:
                bounds[key] = leaving_bound(arm, start, twist, DISTANCE, i)
            bound = bounds[key]
            if bound is None:
                continue
            begin, direction = arm.pose(start), arm.scaled(twist) / np.linalg.norm(arm.scaled(twist))

            def left(q: Array, arm: Arm = arm, begin: pin.SE3 = begin, direction: Array = direction) -> bool:
                return bool(direction @ arm.error(arm.pose(q), begin) >= DISTANCE)

            run = simulate(law, arm, start, steady(twist), 4.0, left)
            found.append(len(run.raw) * DT / bound if left(run.q[-1]) else None)
    return found


def row(name: str, figures: Sequence[Figures], walks: Sequence[bool], leaving: Sequence[float | None]) -> str:
    values = {key: np.array([each[key] for each in figures]) for key in figures[0]}
    walk, chatter = np.array(walks), values["chatter"]
    times = [each for each in leaving if each is not None]
    cells = [
        name,
        f"{np.nanmedian(values['near']):.2f}, {np.nanmin(values['near']):.2f}",
        f"{values['followed'].mean():.3f}",
        f"{values['stalled'].sum():.2f} s",
        f"{100 * values['backward'].mean():.2f} %",
        f"{values['angle'].mean():.0f}°, {values['slip'].mean():.2f}",
        f"{np.median(chatter[~walk]):.1f}, {chatter[~walk].max():.1f}; {chatter[walk].mean():.1f}",
        f"{values['over_velocity'].max():.1e}, {values['over_acceleration'].max():.1e}, {values['over_position'].max():.1e}",
        f"{len(times)} of {len(leaving)}; {np.median(times):.2f}, {max(times):.2f}" if times else f"0 of {len(leaving)}",
    ]
    return "| " + " | ".join(cells) + " |"


def steps_from_python(models: dict[str, Arm]) -> list[str]:
    """Time of a step called from Python at one state: far from singularities, beside one, and there with joints at bounds."""
    lines = ["| state of the Panda | median | 99.9 % |", "|---|---|---|"]
    law = Ours(models["panda"])
    far = np.array([0.3, -0.3, 0.2, -2.0, 0.1, 1.8, 0.5])
    near = np.array(POSTURES["panda shoulder and wrist"][1]) + 0.02
    slow, fast = np.array([0.02, 0.01, 0.0, 0.0, 0.05, 0.0]), np.array([1.0, 0.5, 0.2, 1.0, 1.0, 0.0])
    for name, q, twist in (("far", far, slow), ("near", near, slow), ("near, joints at bounds", near, fast)):
        times = []
        qd = np.zeros(7)
        for _ in range(200):
            law.servo.step(q, qd, twist, "world")
        for _ in range(20_000):
            begin = time.perf_counter_ns()
            law.servo.step(q, qd, twist, "world")
            times.append(time.perf_counter_ns() - begin)
        lines.append(f"| {name} | {np.median(times) / 1e3:.1f} µs | {np.quantile(times, 0.999) / 1e3:.1f} µs |")
    return lines


def main() -> None:
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
    models = described()
    streams, bounds = designed(models), dict[str, float | None]()
    head = "| law | share near: median, worst | followed | stalled | backward | angle, slip "
    head += "| chatter: designed median, worst; walks "
    head += (
        "| over limits: velocity, acceleration (shares), position (rad) | leaving: cases; time over its bound: median, worst |"
    )
    lines = ["## Designed streams", "", head, "|" + "---|" * 9]
    walks = ["walk" in name for name in streams]
    for name, make in LAWS.items():
        found = []
        for key, stream in track(streams.items(), description=name):
            arm = models[stream.arm]
            found.append(judge(arm, simulate(make(arm), arm, stream.start, stream.twist, stream.seconds)))
            print(name, key, {k: round(v, 3) for k, v in found[-1].items()}, flush=True)
        lines.append(row(name, found, walks, leave(make, models, bounds)))
        print(lines[-1], flush=True)
    lines += ["", f"## {count} random streams from singular postures", ""]
    lines += [head.rpartition("| leaving")[0] + "|", "|" + "---|" * 8]
    laws = {name: Ours(arm) for name, arm in models.items()}
    by_arm: dict[str, list[Figures]] = {name: [] for name in NAMES}
    halts, walking = 0, {name: list[bool]() for name in NAMES}
    for k in track(range(count), description="random streams"):
        arm = models[NAMES[k % len(NAMES)]]
        stream = touching(arm, k)
        figures = judge(arm, simulate(laws[arm.name], arm, stream.start, stream.twist, stream.seconds))
        by_arm[arm.name].append(figures)
        walking[arm.name].append(is_walk(k))
        halts += int(figures["halts"] + figures["errors"])
        if figures["stalled"] or figures["backward"] or figures["halts"]:
            print(k, arm.name, {k: round(v, 3) for k, v in figures.items()}, flush=True)
    for name, each in by_arm.items():
        if each:
            lines.append(row(name, each, walking[name], []).rpartition("| 0 of 0")[0] + "|")
    every = [each for part in by_arm.values() for each in part]
    lines += [
        "",
        f"Of {len(every)} streams of 20 s, {sum(each['stalled'] > 0 for each in every)} have a stall, "
        f"{sum(each['backward'] > 0 for each in every)} a sample that moves backward, and {halts} steps halted or raised.",
        "",
        "## Time of a step",
        "",
        *steps_from_python(models),
        "",
        f"Called from Python {platform.python_version()}, {platform.machine()}; "
        "command: `.venv/bin/python benchmarks/servo.py`.",
    ]
    OUT.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
