"""The values of leading slides at which an arm can reach poses: a base on rails can be far from most of what it reaches."""

import numpy as np
import pinocchio as pin

from manipplan.ik.geometry import Screws
from manipplan.robots.arms import lengths_to, tool_reach
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.memo import once_per_owner


def window(robot: Robot, poses: Array) -> tuple[Array, Array]:
    """Limits lower and upper (n,), in which leading prismatic joints are held near enough for one of poses (k, 4, 4)."""
    lower, upper = robot.limits.lower.copy(), robot.limits.upper.copy()
    directions, centre, radius = _reach(robot)
    count = len(directions)
    if count:
        back = np.linalg.pinv(directions.T)
        values = (poses[:, :3, 3] - centre) @ back.T
        spread = radius * np.linalg.norm(back, axis=1)
        lower[:count] = np.clip(values.min(axis=0) - spread, robot.limits.lower[:count], robot.limits.upper[:count])
        upper[:count] = np.clip(values.max(axis=0) + spread, robot.limits.lower[:count], robot.limits.upper[:count])
    return lower, upper


def reach_in(robot: Robot, limits: tuple[Array, Array]) -> tuple[Array, float]:
    """A ball that holds every place of the tool with leading slides inside limits (n,): centre (3,) and radius [m]."""
    directions, centre, radius = _reach(robot)
    lower, upper = (limit[: len(directions)] for limit in limits)
    return centre + (lower + upper) / 2 @ directions, radius + float(np.abs((upper - lower) / 2 @ np.abs(directions)).sum())


def random_near(robot: Robot, pose: Array, rng: np.random.Generator, count: int) -> Array:
    """Random configurations (count, n) in the window of a pose (4, 4)."""
    q = robot.random_configuration(rng, size=count)
    lower, upper = window(robot, pose[None])
    slides = len(_reach(robot)[0])
    q[:, :slides] = rng.uniform(lower[:slides], upper[:slides], (count, slides))
    return q


@once_per_owner
def _reach(robot: Robot) -> tuple[Array, Array, float]:
    """Directions (k, 3) of the leading slides, and the ball in which the tool is with them at 0: centre (3,) and radius [m]."""
    screws = Screws.of(robot)
    if screws.follow is not None:
        return np.zeros((0, 3)), *tool_reach(robot, robot.tool)
    count = int(np.argmin(np.append(screws.slides, False)))
    if np.linalg.matrix_rank(screws.axes[:count]) < count:
        count = 0  # slides in parallel can make up for each other
    if count == robot.n:
        return screws.axes, screws.home[:3, 3], 0.0
    data = robot.model.createData()
    pin.forwardKinematics(robot.model, data, np.zeros(robot.n))
    joint, length = lengths_to(robot, robot.tool)[count]
    return screws.axes[:count], data.oMi[joint].translation.copy(), length
