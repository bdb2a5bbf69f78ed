"""A first path that the user gives: read, and checked."""

from pathlib import Path

import numpy as np

from manipplan.checks import Array
from manipplan.errors import FileFormatError, InvalidInputError
from manipplan.optimize.solve import PathProblem
from manipplan.paths.joint import JointPath
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.continuous import path_clearance
from manipplan.robots.robot import Robot
from manipplan.seeds.ompl import CHECK_STEP

#: How a recorded motion is read, by the end of the file's name.
READERS = {
    ".csv": Trajectory.from_csv,
    ".json": Trajectory.from_json,
    ".yaml": Trajectory.from_ros,
    ".yml": Trajectory.from_ros,
    ".npz": Trajectory.from_npz,
}


def initial_path(robot: Robot, initial: JointPath | Trajectory | str | Path) -> JointPath:
    """A first path in any form as a JointPath of this robot's joints."""
    if isinstance(initial, JointPath):
        path = initial
    else:
        motion = initial if isinstance(initial, Trajectory) else _recorded(initial)
        if motion.joint_names != robot.joint_names:
            wanted = f"a motion of the joints {', '.join(robot.joint_names)}"
            raise InvalidInputError("initial", f"one of {', '.join(motion.joint_names)}", wanted)
        path = motion.path()
    if path.n != robot.n:
        raise InvalidInputError("initial", f"a path of {path.n} joints", f"a path of the {robot.n} joints of {robot.name}")
    return path


def _recorded(file: str | Path) -> Trajectory:
    if not isinstance(file, str | Path):
        raise InvalidInputError("initial", file, "a JointPath, a Trajectory, or the path of its file")
    read = READERS.get(Path(file).suffix.lower())
    if read is None:
        raise FileFormatError("initial", str(file), f"a file of a trajectory: {', '.join(READERS)}")
    return read(file)


def check_initial(problem: PathProblem, initial: JointPath, start: Array, goal: Array) -> None:
    """Raise InvalidInputError for a first path that does not go from start to goal, inside the limits and free."""
    robot, model = problem.robot, problem.model()
    for name, q, end in (("start", start, initial.start), ("goal", goal, initial.goal)):
        off = np.abs(end - q)
        if off.max() > 1e-9:
            got = f"a path whose {name} is {off.max():.3g} off at {robot.joint_names[int(off.argmax())]}"
            raise InvalidInputError("initial", got, "a path from start to goal")
    low, high = initial.bounds()
    for q in (low, high):
        robot.configuration("initial", q, tolerance=1e-9)
    if model is None:
        return
    proof = path_clearance(model, initial, clearance=problem.clearance, tolerance=None)
    if proof.refuted:
        first, second = proof.pair
        apart = f"{proof.upper:.4g} m apart" if proof.upper > 0 else f"overlapping by {-proof.upper:.4g} m"
        wanted = f"free with a clearance of {problem.clearance:g} m"
        raise InvalidInputError(
            "initial", f"a path with {first} and {second} {apart} at s = {proof.at:.4f}", f"a path {wanted}"
        )
    if not (proof.proven or model.path_is_free(initial, CHECK_STEP, problem.clearance)):
        raise InvalidInputError("initial", "a path in collision", "a path that is free with the demanded clearance")
