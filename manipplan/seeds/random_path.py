"""First paths without obstacles: the straight line, and paths through random configurations."""

import numpy as np

from manipplan.paths.joint import JointPath
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array


def random_path(robot: Robot, start: Array, goal: Array, seed: int) -> JointPath:
    """The straight line for seed 0, else a path through a random configuration within half a turn of its middle per joint."""
    if seed == 0:
        return JointPath.line(start, goal)
    via = (start + goal) / 2 + np.random.default_rng(seed).uniform(-np.pi, np.pi, robot.n)
    return JointPath.through(np.stack([start, np.clip(via, robot.limits.lower, robot.limits.upper), goal]))
