"""Limits that manufacturers publish for arms that are recognised by the names of their joints."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import Any

from manipplan.robots.robot import Robot

#: Limits that hold together: a velocity holds on its range of positions.
RANGE = ("lower", "upper", "velocity")


@dataclass(frozen=True, kw_only=True)
class DataSheet:
    """Published limits of one arm.

    Attributes:
        joints: names of its joints in the maker's description.
        limits: limits in SI units, by their names in JointLimits.
        source: where they are published.
    """

    joints: tuple[str, ...]
    limits: Mapping[str, tuple[float, ...]]
    source: str


PANDA = DataSheet(
    joints=tuple(f"panda_joint{k}" for k in range(1, 8)),
    limits={
        "acceleration": (15.0, 7.5, 10.0, 12.5, 15.0, 20.0, 20.0),
        "jerk": (7500.0, 3750.0, 5000.0, 6250.0, 7500.0, 10000.0, 10000.0),
    },
    source="Franka Emika control interface, robot and interface specifications",
)
#: The FR3's velocity limits depend on the position and fall to zero at the position limits. These are the constants that its
#: maker publishes for planners, with the narrower range of positions on which they hold; `paths.controllers.franka` has the
#: whole rule.
FR3 = DataSheet(
    joints=tuple(f"fr3_joint{k}" for k in range(1, 8)),
    limits={
        "lower": (-2.3093, -1.5133, -2.4937, -2.7478, -2.4800, 0.8521, -2.6895),
        "upper": (2.3093, 1.5133, 2.4937, -0.4461, 2.4800, 4.2094, 2.6895),
        "velocity": (2.0, 1.0, 1.5, 1.25, 3.0, 1.5, 3.0),
        "acceleration": (10.0,) * 7,
        "jerk": (5000.0,) * 7,
    },
    source="Franka Robotics control interface, robot limits of the FR3: constant velocities on a narrower range of positions",
)
SHEETS = (PANDA, FR3)


def with_published_limits(robot: Robot, given: Collection[str]) -> Robot:
    """The robot with the limits of its data sheet, if there is one, but for the kinds in `given`.

    Where one of lower, upper and velocity is given, the sheet's other two are left out as well: they hold together.
    """
    sheet = next((each for each in SHEETS if each.joints == robot.joint_names), None)
    if sheet is None:
        return robot
    left_out = {*given, *(RANGE if set(RANGE) & set(given) else ())}
    limits: dict[str, Any] = {kind: value for kind, value in sheet.limits.items() if kind not in left_out}
    return robot.with_limits(source=sheet.source, **limits) if limits else robot
