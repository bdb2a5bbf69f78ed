"""The values in which an arm's joints are enumerated, one turn of a joint that goes around, and how far the tool is in them."""

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.ik.geometry import Screws
from manipplan.robots.arms import lengths_to, tool_reach
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array

#: Revolute joints whose limits span more full turns than this are enumerated in one turn, like those without limits.
TURNS = 8


def span(robot: Robot) -> tuple[Array, Array]:
    """Limits (n,) in which each joint is enumerated: one turn of a revolute joint with no limits or with more than `TURNS`."""
    lower, upper = robot.limits.lower, robot.limits.upper
    around = spans_turn(robot)
    inside = around & (lower <= -np.pi) & (upper >= np.pi)
    low = np.where(inside | np.isinf(lower), -np.pi, lower)
    return low, np.where(around, low + 2 * np.pi, upper)


def spans_turn(robot: Robot) -> NDArray[np.bool_]:
    """Whether each joint (n,) is enumerated in one turn only, which brings the arm back to the same posture."""
    return np.asarray(robot.turns & (robot.limits.upper - robot.limits.lower > 2 * np.pi * TURNS))


def in_turn(robot: Robot, q: Array) -> Array:
    """Configurations (k, n) with the joints that are enumerated in one turn brought into it."""
    low = span(robot)[0]
    return np.where(spans_turn(robot), low + (q - low) % (2 * np.pi), q)


def line(lower: float, upper: float, count: int) -> Array:
    """Evenly spaced values between two limits, with both; one alone in their middle."""
    return np.linspace(lower, upper, count) if count > 1 else np.array([(lower + upper) / 2])


def slides_of(robot: Robot) -> tuple[int, ...]:
    """Indices of the prismatic joints."""
    return tuple(k for k, kind in enumerate(robot.joint_types) if kind == "prismatic")


def within_reach(robot: Robot) -> tuple[Array, Array]:
    """Limits (n,) as of `span`, with slides no farther out than the other links are long."""
    (lower, upper), slides = span(robot), list(slides_of(robot))
    if slides:
        still = robot.with_limits(
            lower=np.where(np.isin(np.arange(robot.n), slides), -1e-9, robot.limits.lower),
            upper=np.where(np.isin(np.arange(robot.n), slides), 1e-9, robot.limits.upper),
        )
        length = max(each for _, each in lengths_to(still, robot.tool))
        middle = np.clip(0.0, lower[slides], upper[slides])
        lower[slides], upper[slides] = np.maximum(lower[slides], middle - length), np.minimum(upper[slides], middle + length)
    return lower, upper


def reach_in(robot: Robot, limits: tuple[Array, Array]) -> tuple[Array, float]:
    """A ball that holds every place of the tool with slides inside limits (n,): centre (3,) and radius [m]."""
    screws = Screws.of(robot)
    slides, (lower, upper) = list(slides_of(robot)), limits
    low, high = robot.limits.lower.copy(), robot.limits.upper.copy()
    low[slides], high[slides] = lower[slides], upper[slides]
    if screws.follow is not None:
        return tool_reach(robot.with_limits(lower=low, upper=high), robot.tool)
    leading = int(np.argmin(np.append(screws.slides, False)))
    middle = np.zeros(robot.n)
    middle[:leading] = (lower + upper)[:leading] / 2
    data = robot.model.createData()
    pin.forwardKinematics(robot.model, data, middle)
    radius = float(np.abs((upper - lower)[:leading] / 2).sum())
    if leading == robot.n:
        return screws.home[:3, 3] + middle @ screws.axes, radius
    length = lengths_to(robot.with_limits(lower=low, upper=high), robot.tool)[leading][1]
    return data.oMi[joints_moved(robot)[leading]].translation.copy(), radius + length


def joints_moved(robot: Robot) -> list[int]:
    """For each entry of q the joint of the model that it moves, where it moves only one between base and tool."""
    return [joint for joint, _ in lengths_to(robot, robot.tool)] if robot.followers else list(range(1, robot.n + 1))
