"""Time of one step of `mp.Servo`, called from Python, far from singular postures and near them.

Run with `make benchmark`, on a quiet machine: the times are microseconds. The tool of each arm moves away from its base and
back at up to 0.5 m/s, while it turns; it reaches the edge of the arm's reach. First the motion is recorded, with what the gauge
says about each step. Then its states and commands are given to the servo again, in several rounds, and each step is timed. Far
from singular postures means that all singular values are above 0.12 m and no bound is active; near one, that one is below, and
a bound is active. The longest times are those of the machine, which interrupts a step from time to time; what the law takes
at most is told by the median over the rounds of each step. A step of `mp.Controller` is timed in the same run, as in
control_step.py, to compare machines. Writes docs/benchmarks/servo_step.md.
"""

import os

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import argparse
import platform
import time
from collections.abc import Sequence
from pathlib import Path

import control_step
import numpy as np
from rich.progress import track
from servo import NAMES

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "servo_step.md"
DT, SPEED, TURN = 0.002, 0.5, 0.3
#: Singular value below which a posture is near a singular one [m], as in servo.c.
SMALL = 0.12
Step = tuple[np.ndarray, np.ndarray, np.ndarray]


def recorded(servo: mp.Servo, seconds: float) -> tuple[list[Step], np.ndarray, np.ndarray]:
    """Positions, velocities and twist of each step, and whether it is far from singular postures, or near one."""
    servo.reset()
    q, qd, steps, far, near = servo.robot.neutral.copy(), np.zeros(servo.robot.n), [], [], []
    outward = servo.robot.kinematics().pose(q)[:3, 3] - servo.robot.base[:3, 3]
    outward /= np.linalg.norm(outward)
    for k in range(round(seconds / DT)):
        twist = np.append(SPEED * np.sin(np.pi / 2 * k * DT) * outward, [TURN * np.sin(k * DT), 0.0, 0.0])
        steps.append((q, qd, twist))
        qd = servo.step(q, qd, twist, "world")
        q, gauge = q + DT * qd, servo.gauge
        far.append(gauge.smallest >= SMALL and gauge.reason == mp.results.ServoLimit.NOTHING)
        near.append(gauge.smallest < SMALL and gauge.reason != mp.results.ServoLimit.NOTHING)
    return steps, np.array(far), np.array(near)


def timed(servo: mp.Servo, steps: list[Step]) -> np.ndarray:
    """Time of each step [s]."""
    servo.reset()
    times = np.empty(len(steps))
    for k, (q, qd, twist) in enumerate(steps):
        began = time.perf_counter()
        servo.step(q, qd, twist, "world")
        times[k] = time.perf_counter() - began
    return times


def main(arguments: Sequence[str] | None = None) -> dict[str, np.ndarray]:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=15, help="number of rounds of every arm")
    parser.add_argument("--seconds", type=float, default=20.0, help="duration of the motion [s]")
    parser.add_argument("--out", type=Path, default=OUT, help="file of the table")
    given = parser.parse_args(arguments)
    servos = {name: mp.Servo(mp.load_robot(name), dt=DT) for name in NAMES}
    motions = {name: recorded(servo, given.seconds) for name, servo in servos.items()}
    rounds: dict[str, list[np.ndarray]] = {name: [] for name in NAMES}
    panda, steps = mp.load_robot("panda"), []
    controller = mp.Controller(panda, control_step.FORMULATIONS["LogDrive"], dt=0.01)
    poses = control_step.targets(panda, control_step.PATH, 0.01)
    for _ in track(range(given.rounds + 1), description="measuring"):  # the first round warms up
        for name, servo in servos.items():
            rounds[name].append(timed(servo, motions[name][0]))
        steps.append(control_step.one_round(panda, controller, control_step.PATH, 0.01, poses).median)
    lines = [
        "| arm | far from singular postures: steps, median | near one, with a bound active: steps, median "
        "| all steps, median of the rounds: 99.9 %, longest | every single step: 99 %, 99.9 % |",
        "|---|---|---|---|---|",
    ]
    found = {}
    for name, every in rounds.items():
        _, far, near = motions[name]
        found[name] = kept = np.array(every[1:])  # (rounds, steps)
        medians = [
            f"{chosen.sum()}, {1e6 * np.median(kept[:, chosen]):.1f} µs" if chosen.any() else "0" for chosen in (far, near)
        ]
        high = (np.percentile(np.median(kept, axis=0), (99.9, 100)), np.percentile(kept, (99, 99.9)))
        lines.append(f"| {name} | {' | '.join([*medians, *(f'{1e6 * low:.1f}, {1e6 * most:.1f} µs' for low, most in high)])} |")
    lines += [
        "",
        "In the same run a step of `mp.Controller` with LogDrive, for the Panda along a path at 10 ms, takes "
        f"{1e6 * np.median(steps[1:]):.1f} µs.",
        "",
        f"One step called from Python, compiled, {given.rounds} rounds; Python {platform.python_version()}, "
        f"{platform.machine()}; command: `.venv/bin/python benchmarks/servo_step.py`.",
    ]
    given.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))
    return found


if __name__ == "__main__":
    main()
