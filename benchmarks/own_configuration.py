"""Does inverse kinematics find the configuration that a pose was made from, for every arm of the catalogue?

Run with `make benchmark`. A random configuration inside the limits gives a pose by Pinocchio alone, on the whole model of the
original file. `mp.inverse_kinematics` is asked for all configurations that reach it; of redundant arms, with the values of
their parameters that the configuration has. Counted are the poses whose configuration is among them, modulo full turns, and the
solutions that miss their pose by Pinocchio, or a limit. Writes docs/benchmarks/own_configuration.md.
"""

import argparse
import platform
import time
from pathlib import Path

import numpy as np
import pinocchio as pin
from rich.progress import Progress

import manipplan as mp
from manipplan.ik.solver import Solver

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "own_configuration.md"
SEED = 44
#: A configuration is found when no joint differs by more than this [rad or m]; next to a singularity, by what 1e-10 of the pose
#: is worth there.
SAME, REACHED = 1e-6, 1e-10
#: A solution that misses its pose by more than this [m or 1] is wrong.
WRONG = 2e-10


class Judge:
    """Forward kinematics of a robot by Pinocchio on the whole model of its file."""

    def __init__(self, robot: mp.Robot, tool: str, locked: dict[str, float]) -> None:
        file = str(robot.source.file)
        read = pin.buildModelFromMJCF if robot.source.kind == "mjcf" else pin.buildModelFromUrdf
        self.model, self.tool = read(file), tool
        self.data, self.locked = self.model.createData(), locked

    def pose(self, names: tuple[str, ...], q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The pose (4, 4) of the tool at q (n,), and the Jacobian (6, n) of the joints `names`."""
        full, columns = pin.neutral(self.model), []
        for name, value in {**self.locked, **dict(zip(names, q, strict=True))}.items():
            joint = self.model.joints[self.model.getJointId(name)]
            if joint.nq == joint.nv:
                full[joint.idx_q] = value
            else:  # a continuous joint has cosine and sine
                full[joint.idx_q : joint.idx_q + 2] = np.cos(value), np.sin(value)
        columns = [self.model.joints[self.model.getJointId(name)].idx_v for name in names]
        frame = self.model.getFrameId(self.tool, pin.FrameType.BODY)
        jacobian = pin.computeFrameJacobian(self.model, self.data, full, frame, pin.LOCAL_WORLD_ALIGNED)
        pin.updateFramePlacement(self.model, self.data, frame)
        return self.data.oMf[frame].homogeneous.copy(), jacobian[:, columns]


def measured(robot: mp.Robot, judge: Judge, count: int, tick) -> tuple[int, int, int, float, str]:
    """Poses whose configuration is found, solutions, wrong ones, seconds per pose, and the method."""
    rng, names = np.random.default_rng(SEED), robot.joint_names
    solver = Solver.of(robot, task=mp.Task.pose(), held=None, method="auto", seed=0)
    turns = np.array([kind != "prismatic" for kind in robot.joint_types])
    hits = rows = wrong = 0
    seconds = 0.0
    for q in robot.random_configuration(rng, size=count):
        pose, jacobian = judge.pose(names, q)
        parameters = solver.parameters_of(q[None], pose[None])
        began = time.perf_counter()
        found = mp.inverse_kinematics(
            robot, pose, parameters if parameters.shape[1] else None, task=mp.Task.pose(), turns=False
        )
        seconds += time.perf_counter() - began
        moving = np.delete(jacobian, solver.held, axis=1)
        least = np.linalg.svd(moving, compute_uv=False)[-1]
        apart = found.q - q
        apart = np.where(turns, (apart + np.pi) % (2 * np.pi) - np.pi, apart)
        hits += bool((np.abs(apart).max(axis=1) < max(SAME, REACHED / max(least, 1e-12))).any()) if len(found) else 0
        rows += len(found)
        missed = [np.abs(judge.pose(names, each)[0] - pose).max() > WRONG for each in found.q]
        wrong += int(np.sum(np.array(missed, dtype=bool) | (robot.limits.outside(found.q) > 0).any(axis=1)))
        tick()
    return hits, rows, wrong, seconds / count, solver.method


def arms(names: list[str]):
    """Each arm of the catalogue with its judge: one per tool of robots with several."""
    for name in names:
        robot = mp.load_robot(name)
        for tool in robot.tools:
            arm = robot.arm(tool) if len(robot.tools) > 1 else robot
            if not arm.planar:
                label = name if len(robot.tools) == 1 else f"{name}, {tool}"
                yield label, arm, Judge(robot, tool, dict(arm.locked))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=1000, help="poses per arm")
    parser.add_argument("--arms", nargs="*", default=None, help="names of the catalogue; default: all")
    parser.add_argument("--print", action="store_true", help="write no page")
    options = parser.parse_args()
    lines = [
        "| arm | joints | method | poses | configuration found | solutions | wrong | ms per pose |",
        "|---|---|---|---|---|---|---|---|",
    ]
    total = np.zeros(4, dtype=int)
    with Progress() as progress:
        for label, robot, judge in arms(options.arms or mp.available_robots()):
            bar = progress.add_task(label, total=options.count)
            hits, rows, wrong, seconds, method = measured(robot, judge, options.count, lambda bar=bar: progress.advance(bar))
            total += [options.count, hits, rows, wrong]
            lines.append(
                f"| `{label}` | {robot.n} | {method} | {options.count} | {100 * hits / options.count:.2f} % | {rows} | {wrong} "
                f"| {1e3 * seconds:.2f} |"
            )
    poses, hits, rows, wrong = total.tolist()
    lines.append(f"| all | | | {poses} | {100 * hits / poses:.3f} % | {rows} | {wrong} | |")
    command = f"`.venv/bin/python benchmarks/own_configuration.py --count {options.count}`"
    text = "\n".join([*lines, "", f"Python {platform.python_version()}, {platform.machine()}; command: {command}.", ""])
    if not options.print:
        OUT.write_text(text)
    print(text)


if __name__ == "__main__":
    main()
