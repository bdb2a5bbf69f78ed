"""check_corners: refuses a constant speed of the tool around a corner that no motion of the arm can keep there."""

import numpy as np

from manipplan.paths.cartesian import CartesianPath
from manipplan.robots.arms import lengths_to
from manipplan.robots.robot import Robot
from manipplan.support.errors import InvalidInputError
from manipplan.timing.steady.speed import RAMP, STEADY

#: Number of intervals of the tool's way, and of places from which they are interpolated.
INTERVALS, PLACES = 8192, 20001


def check_corners(speed: float, path: CartesianPath, robot: Robot, *, position: float, margin: float = 0.0) -> None:
    """Raise InvalidInputError, which names the place, for a constant speed [m/s] that a corner of the path does not allow.

    A tool that passes three places of the path, a way h apart, at speed v and within the tolerance δ, is accelerated by at
    least v² (‖p₁ - 2 p₂ + p₃‖ - 4 δ) / (h + 2 δ)². No motion within the limits accelerates it by more than `most_acceleration`.

    Args:
        position: tolerance δ on the tool's position [m].
        margin: way at either end that is left out [m]; so are the ramps.
    """
    s = np.linspace(0.0, 1.0, PLACES)
    points = path(s)[:, :3, 3]
    way = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    left_out = margin + RAMP * way[-1]
    if way[-1] <= 2 * left_out:
        return
    at = np.linspace(left_out, way[-1] - left_out, INTERVALS + 1)
    points = np.stack([np.interp(at, way, points[:, k]) for k in range(3)], axis=1)
    worst, place = 0.0, 0.0
    for lag in 2 ** np.arange(int(np.log2(INTERVALS))):
        second = np.linalg.norm(points[2 * lag :] - 2 * points[lag:-lag] + points[: -2 * lag], axis=1)
        bend = (second - 4 * position) / (lag * (at[1] - at[0]) + 2 * position) ** 2  # acceleration at 1 m/s
        if bend.max() > worst:
            worst, place = float(bend.max()), float(np.interp(at[lag + int(bend.argmax())], way, s))
    most = np.sqrt(most_acceleration(robot) / worst) / (1 - STEADY) if worst > 0 else np.inf
    if speed > most:
        wanted = (
            f"at most {most:.3g} m/s: at s = {place:.3f} the path turns a corner that no motion within the acceleration limits "
            "takes faster. Round the corner, allow a larger tolerance, or split the path there into two steps with a blend"
        )
        raise InvalidInputError("tool_speed", speed, wanted)


def most_acceleration(robot: Robot) -> float:
    """An upper bound on the acceleration of the tool's origin within the limits, in any configuration [m/s²].

    Each joint that carries the tool adds its own acceleration times its lever, and each pair of them the product of their
    velocities times the lever of the later one. A lever is at most the sum of the lengths of the links beyond the joint.
    """
    tree, lengths = robot.tree, lengths_to(robot, robot.tool)
    joints = np.array([joint - 1 for joint, _ in lengths])
    levers = np.array([1.0 if tree.slides[joint - 1] else length for joint, length in lengths])
    velocity, acceleration = (tree.sizes(each)[joints] for each in (robot.limits.velocity, robot.limits.acceleration))
    later = np.maximum.outer(np.arange(len(joints)), np.arange(len(joints)))
    return float(acceleration @ levers + (np.outer(velocity, velocity) * levers[later]).sum())
