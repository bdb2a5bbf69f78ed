"""Generated arms: are poses reached however long a slide is, and is the nearest configuration of a refusal the nearest?

Run with `make benchmark`. The first table has arms of seven revolute joints with slides and turntables at several places of the
chain, with limits of ±1 to ±1,000,000 m and rad. Half of the poses are made with slides within 2 m of their middle, half with
slides anywhere. A set of solutions is counted as honest if it holds one, or says that it is not complete. The second table
compares the nearest configuration that `mp.follow` reports with the best end of 150 random starts of damped least squares
inside the limits, by Pinocchio. Writes docs/benchmarks/slide_arms.md.
"""

import argparse
import platform
import tempfile
import time
from pathlib import Path

import numpy as np
import pinocchio as pin
from rich.progress import track

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "slide_arms.md"
SEED, STARTS, STEPS = 12, 150, 150
LENGTHS = (1.0, 5.0, 100.0, 1e6)
H = "1.57079632679"
#: Place, turn and limits of each joint of a base arm.
SHOULDER = (
    ("0 0 0.33", "0 0 0", -2.9, 2.9),
    ("0 0 0", f"-{H} 0 0", -1.76, 1.76),
    ("0 -0.32 0", f"{H} 0 0", -2.9, 2.9),
    ("0.08 0 0", f"{H} 0 0", -3.0, -0.07),
    ("-0.08 0.38 0", f"-{H} 0 0", -2.9, 2.9),
    ("0 0 0", f"{H} 0 0", -0.02, 3.7),
    ("0.09 0 0", f"{H} 0 0", -2.9, 2.9),
)
#: The same without axes that meet, and of six joints without a closed form.
SKEW = (
    ("0 0 0.1", "0 0 0", -2.94, 2.94),
    ("0.03 0 0.1", f"{H} 0 0", -2.5, 0.75),
    ("-0.03 0.17 0", f"-{H} 0 0", -2.94, 2.94),
    ("-0.04 0 0.08", f"{H} -{H} 0", -2.15, 1.39),
    ("0.041 0.09 0", f"-{H} 0 0", -5.06, 5.06),
    ("-0.027 0 0.17", f"{H} 0 0", -1.53, 2.4),
    ("0.027 0.03 0", f"-{H} 0 0", -3.99, 3.99),
)
OFFSET = (
    ("0 0 0.27", "0 0 0", -6.28, 6.28),
    ("0 0 0", f"-{H} 0 0", -2.06, 2.09),
    ("0.05 -0.28 0", "0 0 0", -3.93, 0.19),
    ("0.08 0.34 0", f"-{H} 0 0", -6.28, 6.28),
    ("0 0 0", f"{H} 0 0", -1.69, 3.14),
    ("0.08 0.1 0", f"-{H} 0 0", -6.28, 6.28),
)
#: Joints put in front of an index of the chain: kind and axis.
KINDS = {
    "turntable, slide": ((0, "prismatic", "1 0 0"), (0, "revolute", "0 0 1")),
    "slide": ((0, "prismatic", "1 0 0"),),
    "slide, turntable": ((0, "revolute", "0 0 1"), (0, "prismatic", "1 0 0")),
    "two slides": ((0, "prismatic", "1 0 0"), (0, "prismatic", "0 1 0")),
    "slide as second joint": ((1, "prismatic", "1 0 0"),),
    "slide as third joint": ((2, "prismatic", "1 0 0"),),
    "slide in the middle": ((4, "prismatic", "0 1 0"),),
    "slide at the end": ((7, "prismatic", "1 0 0"),),
}
#: Without a closed form, for which fewer samples and poses are taken.
SEARCHED = ("slide as second joint", "slide as third joint")
NEAREST = {"closed form, 7 joints": SHOULDER, "no closed form, 7 joints": SKEW, "no closed form, 6 joints": OFFSET}


def described(folder: Path, parts, extra=(), length=1.0) -> Path:
    """The URDF of an arm with further joints."""
    joints = [("revolute", place, turn, "0 0 1", low, high) for place, turn, low, high in parts]
    for at, kind, axis in extra:
        joints.insert(at, (kind, "0 0 0.05", "0 0 0", axis, -length, length))
    text = '<link name="l0"/>'
    for k, (kind, place, turn, axis, low, high) in enumerate(joints):
        text += (
            f'<link name="l{k + 1}"/><joint name="j{k + 1}" type="{kind}"><parent link="l{k}"/><child link="l{k + 1}"/>'
            f'<origin xyz="{place}" rpy="{turn}"/><axis xyz="{axis}"/>'
            f'<limit lower="{low}" upper="{high}" velocity="1" effort="1"/></joint>'
        )
    text += f'<link name="tool"/><joint name="t" type="fixed"><parent link="l{len(joints)}"/><child link="tool"/>'
    file = folder / "arm.urdf"
    file.write_text(f'<robot name="arm">{text}<origin xyz="0 0 0.1"/></joint></robot>')
    return file


class Judge:
    """Pinocchio alone on the file."""

    def __init__(self, file: Path) -> None:
        self.model = pin.buildModelFromUrdf(str(file))
        self.data, self.frame = self.model.createData(), self.model.getFrameId("tool")
        self.lower, self.upper = self.model.lowerPositionLimit, self.model.upperPositionLimit

    def pose(self, q: np.ndarray) -> np.ndarray:
        pin.framesForwardKinematics(self.model, self.data, q)
        return self.data.oMf[self.frame].homogeneous.copy()

    def error(self, q: np.ndarray, pose: np.ndarray) -> np.ndarray:
        """Displacement [m] and rotation vector [rad] to a pose."""
        own = self.pose(q)
        return np.concatenate([pose[:3, 3] - own[:3, 3], pin.log3(pose[:3, :3] @ own[:3, :3].T)])

    def nearest(self, pose: np.ndarray, rng: np.random.Generator) -> float:
        """The smallest norm of the error that damped least squares inside the limits reach from random starts."""
        best = np.inf
        for start in rng.uniform(self.lower, self.upper, (STARTS, self.model.nq)):
            q, damping, error = start, 1e-2, self.error(start, pose)
            for _ in range(STEPS):
                jacobian = pin.computeFrameJacobian(self.model, self.data, q, self.frame, pin.LOCAL_WORLD_ALIGNED)
                slope = jacobian.T @ error
                moves = ~(((q <= self.lower) & (slope < 0)) | ((q >= self.upper) & (slope > 0)))
                part = jacobian[:, moves]
                step = np.zeros(len(q))
                step[moves] = part.T @ np.linalg.solve(part @ part.T + damping * np.eye(6), error)
                moved = np.clip(q + np.clip(step, -0.5, 0.5), self.lower, self.upper)
                left = self.error(moved, pose)
                if left @ left < error @ error:
                    q, error, damping = moved, left, max(damping / 3, 1e-9)
                else:
                    damping *= 4
                if damping > 1e6:
                    break
            best = min(best, float(np.linalg.norm(error)))
        return best


def reached(folder: Path, kind: str, length: float, count: int) -> str:
    """A row of the first table."""
    file = described(folder, SHOULDER, KINDS[kind], length)
    robot, judge, rng = mp.Robot.from_urdf(file, tool="tool"), Judge(file), np.random.default_rng(SEED)
    slides = [k for k, sort in enumerate(robot.joint_types) if sort == "prismatic"]
    options = {"samples": 8, "time_limit": 10.0} if kind in SEARCHED else {}
    count = max(count // 5, 2) if kind in SEARCHED else count
    found = honest = wrong = 0
    labels: set[str] = set()
    began = time.perf_counter()
    for k in range(count):
        q = rng.uniform(np.maximum(judge.lower, -np.pi), np.minimum(judge.upper, np.pi))
        most = min(length, 2.0) if k % 2 else length
        q[slides] = rng.uniform(-most, most, len(slides))
        pose = judge.pose(q)
        solutions = mp.inverse_kinematics(robot, pose, **options)
        found += len(solutions) > 0
        honest += len(solutions) > 0 or solutions.missing > 0
        labels.add(solutions.complete.value)
        allowed = 2e-10 * max(1.0, np.abs(pose[:3, 3]).max() / 1e4)
        wrong += sum(np.abs(judge.pose(each) - pose).max() > allowed for each in solutions.q)
        wrong += int((robot.limits.outside(solutions.q) > 0).any(axis=1).sum())
    seconds = (time.perf_counter() - began) / count
    return (
        f"| {kind} | ±{length:,.0f} | {found} of {count} | {honest} of {count} | {', '.join(sorted(labels))} | {wrong} "
        f"| {1e3 * seconds:.0f} |"
    )


def compared(folder: Path, name: str, count: int) -> str:
    """A row of the second table."""
    from scipy.spatial.transform import Rotation

    file = described(folder, NEAREST[name])
    robot, judge, rng = mp.Robot.from_urdf(file, tool="tool"), Judge(file), np.random.default_rng(SEED)
    ratios, tried = [], 0
    seconds = 0.0
    while len(ratios) < count:
        pose, tried = judge.pose(robot.random_configuration(rng)), tried + 1
        if tried % 2:
            pose[:3, 3] *= rng.uniform(1.0, 2.5)
        else:
            pose[:3, :3] = Rotation.random(random_state=tried).as_matrix()
        began = time.perf_counter()
        try:
            beside = pose.copy()
            beside[:3, 3] += [0.01, 0.0, 0.0]
            mp.follow(robot, mp.CartesianPath.line(pose, beside), positions=[0.0, 1.0])
        except mp.errors.OutOfReachError as error:
            seconds += time.perf_counter() - began
            target = pose if "position 0 " in error.argument else beside
            ours = float(np.hypot(error.nearest.position, error.nearest.rotation))
            own = float(np.linalg.norm(judge.error(error.nearest.q, target)))
            ratios.append(max(ours, own) / judge.nearest(target, rng))
        except mp.errors.ManipplanError:
            continue  # within reach
    worst = max(ratios)
    farther = sum(ratio > 1.01 for ratio in ratios)
    return f"| {name} | {count} | {np.median(ratios):.4f} | {worst:.4f} | {farther} | {1e3 * seconds / count:.0f} |"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=30, help="poses per arm and length of the slide")
    parser.add_argument("--refused", type=int, default=30, help="poses out of reach per arm")
    options = parser.parse_args()
    lines = [
        "| joints before or in the arm | limits [m, rad] | poses with solutions | or said to be incomplete | label | wrong "
        "| ms per pose |",
        "|---|---|---|---|---|---|---|",
    ]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for kind in track(KINDS, "slides"):
            lines += [reached(folder, kind, length, options.count) for length in LENGTHS]
        lines += [
            "",
            "| arm | poses out of reach | error of the nearest over that of 150 starts: median | largest "
            "| more than 1 % farther | ms per refusal |",
            "|---|---|---|---|---|---|",
        ]
        lines += [compared(folder, name, options.refused) for name in track(NEAREST, "nearest")]
    command = f"`.venv/bin/python benchmarks/slide_arms.py --count {options.count} --refused {options.refused}`"
    text = "\n".join([*lines, "", f"Python {platform.python_version()}, {platform.machine()}; command: {command}.", ""])
    OUT.write_text(text)
    print(text)


if __name__ == "__main__":
    main()
