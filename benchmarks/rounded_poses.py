"""Rounded poses: does inverse kinematics find for a rounded pose what it finds for the exact one?

Run with `make benchmark`. Poses are those of random configurations, and of configurations with joints at a limit or at zero,
by Pinocchio from the original file. Each is given exactly, in float32, with seven decimals and with seven digits. A solution
of the exact pose counts as found where one of the rounded pose is within 1e-3 rad of it and within 1e-6 m and rad of the exact
pose; two within 1e-3 rad count once, as at a singularity. Writes docs/benchmarks/rounded_poses.md.
"""

import argparse
import platform
import time
from pathlib import Path

import numpy as np
import pinocchio as pin
from rich.progress import track
from scipy.spatial import cKDTree

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "rounded_poses.md"
ARMS = ("ur5", "panda", "xarm7")
SEED, NEAR, WITHIN = 45, 1e-3, 1e-6


def seven_digits(pose: np.ndarray) -> np.ndarray:
    return np.array([[float(f"{x:.7g}") for x in row] for row in pose])


ROUNDINGS = {
    "float32": lambda pose: pose.astype(np.float32),
    "seven decimals": lambda pose: np.round(pose, 7),
    "seven digits": seven_digits,
}


class Judge:
    """Forward kinematics of the original file."""

    def __init__(self, robot: mp.Robot) -> None:
        self.model = pin.buildModelFromUrdf(str(robot.source.file))
        self.data, self.robot = self.model.createData(), robot
        self.frame = self.model.getFrameId(robot.tool)

    def pose(self, q: np.ndarray) -> np.ndarray:
        full = pin.neutral(self.model)
        for name, value in [*zip(self.robot.joint_names, q, strict=True), *self.robot.locked.items()]:
            joint = self.model.joints[self.model.getJointId(name)]
            full[joint.idx_q : joint.idx_q + joint.nq] = value if joint.nq == 1 else (np.cos(value), np.sin(value))
        pin.framesForwardKinematics(self.model, self.data, full)
        return self.data.oMf[self.frame].homogeneous

    def distance(self, q: np.ndarray, pose: np.ndarray) -> float:
        """The larger of the distance [m] and the angle [rad] from a pose."""
        reached = self.pose(q)
        turned = np.linalg.norm(reached[:3, :3] - pose[:3, :3]) / np.sqrt(2)
        return max(float(np.linalg.norm(reached[:3, 3] - pose[:3, 3])), float(turned))


def configurations(robot: mp.Robot, count: int, special: bool) -> np.ndarray:
    rng = np.random.default_rng(SEED)
    lower, upper = (np.where(np.isfinite(x), x, s * np.pi) for x, s in ((robot.limits.lower, -1), (robot.limits.upper, 1)))
    q = rng.uniform(lower, upper, (count, robot.n))
    if special:
        kind = rng.integers(0, 6, q.shape)
        q = np.where(kind == 0, lower, np.where(kind == 1, upper, np.where(kind == 2, np.clip(0.0, lower, upper), q)))
    return q


def lost(found: np.ndarray, others: np.ndarray) -> int:
    """Number of the configurations (k, n) beside which there is none of the others (l, n)."""
    if not len(found) or not len(others):
        return len(found)
    return int((cKDTree(others).query(found, p=np.inf)[0] > NEAR).sum())


def row(name: str, count: int, special: bool) -> list[str]:
    robot = mp.load_robot(name)
    judge = Judge(robot)
    poses = [judge.pose(q) for q in configurations(robot, count, special)]
    label = f"{name}, {'joints at limits and at zero' if special else 'random'}"
    exact = [mp.inverse_kinematics(robot, pose).q for pose in track(poses, label)]
    lines = []
    for rounding, rounded in ROUNDINGS.items():
        began, missing, more, none, worst = time.process_time(), 0, 0, 0, 0.0
        found = [mp.inverse_kinematics(robot, rounded(pose)).q for pose in track(poses, f"{label}, {rounding}")]
        took = 1e3 * (time.process_time() - began) / count
        for pose, before, after in zip(poses, exact, found, strict=True):
            missing, more = missing + lost(before, after), more + lost(after, before)
            none += len(before) > 0 and len(after) == 0
            worst = max([worst, *(judge.distance(q, pose) for q in after)])
        cells = (label, rounding, f"{count:,}", f"{sum(map(len, exact)):,}", missing, more, none, f"{worst:.2g}", f"{took:.1f}")
        lines.append("| " + " | ".join(map(str, cells)) + " |")
    return lines


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=1000, help="poses per arm")
    parser.add_argument("--special", type=int, default=200, help="poses per arm with joints at limits and at zero")
    options = parser.parse_args()
    lines = [
        "| arm, configurations | rounding | poses | solutions | not found | beyond those | poses without any "
        "| farthest from the exact pose [m, rad] | ms per pose |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    for name in ARMS:
        lines += row(name, options.count, False)
        lines += row(name, options.special, True)
    command = f"`.venv/bin/python benchmarks/rounded_poses.py --count {options.count} --special {options.special}`"
    text = "\n".join([*lines, "", f"Python {platform.python_version()}, {platform.machine()}; command: {command}.", ""])
    OUT.write_text(text)
    print(text)


if __name__ == "__main__":
    main()
