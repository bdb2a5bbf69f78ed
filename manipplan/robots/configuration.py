"""The check of one configuration, with an error that names the joint, its value and its limits."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from manipplan.support.checks import Array, configurations, number
from manipplan.support.errors import InvalidInputError

if TYPE_CHECKING:
    from manipplan.robots.robot import Robot


def checked_configuration(robot: "Robot", argument: str, q: ArrayLike, tolerance: float) -> Array:
    """One configuration (n,), finite and inside the position limits but for `tolerance`; see `Robot.configuration`."""
    tolerance = number("tolerance", tolerance, least=0.0)
    q = configurations(argument, q, robot.n)
    if q.ndim != 1:
        raise InvalidInputError(argument, q, f"one configuration of shape ({robot.n},)")
    outside = robot.limits.outside(q)
    if (outside > tolerance).any():
        i = int(outside.argmax())
        raise InvalidInputError(
            f"{argument}[{i}] ({robot.joint_names[i]})",
            float(q[i]),
            f"{robot.limits.lower[i]:g} to {robot.limits.upper[i]:g} {_unit_hint(robot, i, float(q[i]))}",
        )
    return q


def _unit_hint(robot: "Robot", joint: int, value: float) -> str:
    """The joint's unit and, for a value beyond a full turn that may be in degrees, its value in radians."""
    if robot.joint_types[joint] == "prismatic":
        return "m"
    turned = np.deg2rad(value)
    if abs(value) > 2 * np.pi and robot.limits.lower[joint] <= turned <= robot.limits.upper[joint]:
        return f"rad; {value:g} degrees are {turned:.4g} rad"
    return "rad"
