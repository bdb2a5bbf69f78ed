"""Positions of the tool at the edge of the reach, along which a motion is known: are they followed?

Run with `.venv/bin/python benchmarks/edge_of_reach.py`. Of each arm a random configuration is stretched in a random direction
as far as its limits allow, and moved away from there by 0.15 rad in the mean: a straight line of joints between two such
configurations, free of collisions, gives 12 positions of the tool. So a motion exists. `mp.follow` with `Task.position()`
gets the positions alone. The judge is Pinocchio with the arm's own URDF file: the tool passes all positions in their order,
to 0.1 mm, and the joints stay inside the limits of the file. Writes docs/benchmarks/edge_of_reach.md.
"""

import os

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import argparse
import platform
import time
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import example_robot_data as erd
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray
from rich.progress import track
from scipy.optimize import minimize

import manipplan as mp

Array = NDArray[np.float64]
OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "edge_of_reach.md"
#: Arms, with the tool of one of several. Files of those that are part of another robot.
ARMS = {"so100": "", "ur5": "", "panda": "", "xarm7": "", "tiago": "", "talos_right_arm": "", "pr2": "l_gripper_tool_frame"}
FILES = {"talos_right_arm": "talos"}
POSITIONS, TOLERANCE = 12, 1e-4


class Judge:
    """Forward kinematics and limits of the file alone; other joints rest where they are locked."""

    def __init__(self, name: str, tool: str, joints: Sequence[str], locked: Mapping[str, float]) -> None:
        self.model = erd.load(FILES.get(name, name)).model
        self.data, self.frame = self.model.createData(), self.model.getFrameId(tool, pin.FrameType.BODY)
        self.joints = [self.model.joints[self.model.getJointId(each)] for each in joints]
        self.locked = [(self.model.joints[self.model.getJointId(each)], value) for each, value in locked.items()]
        self.has_limits = np.array([each.nq == 1 for each in self.joints])
        places = [each.idx_q for each in self.joints]
        self.lower, self.upper = self.model.lowerPositionLimit[places], self.model.upperPositionLimit[places]

    def position(self, q: Array) -> Array:
        whole = pin.neutral(self.model)
        for joint, value in [*self.locked, *zip(self.joints, q, strict=True)]:
            turn = [value] if joint.nq == 1 else [np.cos(value), np.sin(value)]
            whole[joint.idx_q : joint.idx_q + joint.nq] = turn
        pin.framesForwardKinematics(self.model, self.data, whole)
        return np.array(self.data.oMf[self.frame].translation)

    def fault(self, q: Array, positions: Array) -> str:
        """What is wrong with samples q (k, n) of a motion through positions (p, 3); "" for nothing."""
        outside = np.where(self.has_limits, np.maximum(self.lower - q, q - self.upper), -np.inf).max()
        if outside > 1e-9:
            return f"{outside:.1e} rad outside the limits"
        way, begin = np.array([self.position(each) for each in q]), 0
        for k, wanted in enumerate(positions):
            off = _distances_to(way[begin:], wanted)
            near = np.flatnonzero(off <= TOLERANCE)
            if not len(near):
                return f"position {k} missed by {1e3 * off.min():.2f} mm"
            begin += int(near[0])
        return ""


def _distances_to(way: Array, point: Array) -> Array:
    """Distances (k,) of a point from the straight pieces that end at each of way (k, 3)."""
    before = np.vstack([way[:1], way[:-1]])
    along = way - before
    share = np.clip(((point - before) * along).sum(axis=1) / np.maximum((along**2).sum(axis=1), 1e-300), 0, 1)
    return np.asarray(np.linalg.norm(point - before - share[:, None] * along, axis=1))


def paths(robot: mp.Robot, count: int, seed: int) -> Iterator[Array]:
    """Positions (POSITIONS, 3) along motions at the edge of the reach."""
    rng, kinematics = np.random.default_rng(seed), robot.kinematics()
    low, high = (getattr(robot.limits, each).clip(-3.1, 3.1) for each in ("lower", "upper"))
    model = mp.Scene().collision_model(robot)
    while count:
        direction = rng.normal(size=3)
        some = rng.uniform(low, high, (500, robot.n))
        first = some[np.argmax(kinematics.pose(some)[:, :3, 3] @ direction)]

        def reached(q: Array, direction: Array = direction) -> float:
            return float(-(kinematics.pose(q)[:3, 3] @ direction))

        stretched = minimize(reached, first, bounds=list(zip(low, high, strict=True))).x
        begin = np.clip(stretched + 0.15 * rng.normal(size=robot.n), low, high)
        end = np.clip(begin + 0.2 * rng.normal(size=robot.n), low, high)
        if not model.in_collision_rows(begin + (end - begin) * np.linspace(0, 1, 200)[:, None], clearance=0.001).any():
            count -= 1
            yield kinematics.pose(begin + (end - begin) * np.linspace(0, 1, POSITIONS)[:, None])[:, :3, 3]


def row(name: str, tool: str, count: int, seed: int) -> str:
    robot = mp.load_robot(name)
    robot = robot.arm(tool) if tool else robot
    objective = mp.PathObjective(task=mp.Task.position())
    judge, followed, faults, seconds = Judge(name, robot.tool, robot.joint_names, robot.locked), 0, list[str](), list[float]()
    for positions in track(paths(robot, count, seed), description=name, total=count):
        poses = np.tile(np.eye(4), (POSITIONS, 1, 1))
        poses[:, :3, 3] = positions
        begin = time.process_time()
        plan = mp.follow(robot, mp.CartesianPath.through(poses), objective=objective, throw=False)
        seconds.append(time.process_time() - begin)
        if not isinstance(plan, mp.Plan):
            print(name, plan.status.name, plan.message, flush=True)
            continue
        followed += 1
        times = np.linspace(0.0, plan.trajectory.duration, 4000)
        if fault := judge.fault(plan.trajectory(times), positions):
            print(name, fault, flush=True)
            faults.append(fault)
    return f"| {robot.name} | {count} | {followed} | {len(faults)} | {np.median(seconds):.1f}, {max(seconds):.1f} s |"


def main(argv: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--arms", nargs="+", choices=ARMS, default=list(ARMS))
    parser.add_argument("--count", type=int, default=10, help="number of paths of each arm")
    parser.add_argument("--seed", type=int, default=47)
    parser.add_argument("--out", type=Path, default=OUT)
    given = parser.parse_args(argv)
    lines = ["| arm | paths | followed | faults found by the judge | time: median, most |", "|---|---|---|---|---|"]
    lines += [row(name, ARMS[name], given.count, given.seed) for name in given.arms]
    made = f"Processor times with Python {platform.python_version()}, {platform.machine()}; seed {given.seed}."
    given.out.write_text("\n".join([*lines, "", f"{made} Command: `.venv/bin/python benchmarks/edge_of_reach.py`."]) + "\n")
    print(given.out.read_text())


if __name__ == "__main__":
    main()
