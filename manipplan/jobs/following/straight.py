"""Straight ways of the tool: the path, how densely it is searched, and the best motion along it from a configuration."""

import numpy as np

from manipplan.collision.scene import Scene
from manipplan.ik.solver import Solver
from manipplan.jobs.following.course import ToolPathPlanner
from manipplan.measures.measure import Measure
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import Tolerance
from manipplan.robots.robot import Robot
from manipplan.search.candidates.sampling import default_samples, sample_layers
from manipplan.search.max_min import max_min_search
from manipplan.support.checks import Array
from manipplan.support.progress import silent
from manipplan.symbolic.task import Task

#: Maximum step of a joint between neighbouring positions of a straight way [rad or m].
STRAIGHT_EPSILON = 0.4
#: Distance between positions on a straight way [m], their smallest number, and the largest number of samples per parameter.
STRIDE, FEWEST, SAMPLES = 0.015, 6, 144


def moved_by(way: Array) -> Array:
    """The pose (4, 4) in the tool frame that is a way (3,) off [m]."""
    pose = np.eye(4)
    pose[:3, 3] = way
    return pose


def straight_on(pose: Array, way: Array) -> CartesianPath:
    """The straight path from a pose (4, 4) by a way (3,) in the tool frame [m]."""
    return CartesianPath.line(pose, pose @ moved_by(way))


def straight_finder(
    robot: Robot,
    scene: Scene,
    path: CartesianPath,
    *,
    measure: Measure | str | None,
    clearance: float,
    task: Task | None = None,
    tolerance: Tolerance | None = None,
) -> ToolPathPlanner:
    """The finder of motions along a straight path; raises InvalidInputError for a position that is out of reach or not free."""
    count = max(FEWEST, int(np.ceil(path.length / STRIDE - 1e-6)))  # without the rounding of a length
    solver = Solver.of(robot, task=task, held=None, method="auto", seed=0)
    names, usual = len(solver.names), default_samples(solver)
    samples = min(SAMPLES, usual[max(names, 1) - 1]) if names < 3 else None
    layers = sample_layers(robot, path, count, task=task, measure=measure, samples=samples, scene=scene, clearance=clearance)
    return ToolPathPlanner(path=path, layers=layers, tolerance=tolerance)


def motion_from(finder: ToolPathPlanner, q: Array, robot: Robot, epsilon: float) -> JointPath | str:
    """The best motion along a path that begins at q (n,) and stays inside the limits, or why there is none."""
    beginning = finder.starting_at(q)
    found = max_min_search(beginning.layers, epsilon, explain=False, throw=False)
    if not found.connected:
        return found.message
    path = beginning.along(found, silent, hold_start=True).path
    return outside_limits(path, robot) or path


def outside_limits(path: JointPath, robot: Robot) -> str:
    """Which joint of a path leaves its limits between the positions that were searched; "" where none does."""
    outside = robot.limits.outside(np.array(path.bounds())).max(axis=0)
    joint = int(outside.argmax())
    return f"{robot.joint_names[joint]} is {outside[joint]:.2g} outside its limits" if outside[joint] > 0 else ""
