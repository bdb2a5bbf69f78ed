"""HeldJoints: joints that keep the value they have at the start."""

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from manipplan.constraints.constraint import Constraint, SymbolicPose
from manipplan.robots.robot import Robot
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError, UnknownNameError


@one_line
@dataclass(frozen=True)
class HeldJoints(Constraint):
    """Joints that do not move: a motion keeps their values of its start. The manipulability is still that of the whole arm.

    Attributes:
        joints: their names, at least one, and not all of the arm's.

    Raises InvalidInputError: no names, or one twice.
    """

    joints: str | Sequence[str]

    def __post_init__(self) -> None:
        joints = (self.joints,) if isinstance(self.joints, str) else self.joints
        if not isinstance(joints, list | tuple) or not joints or not all(isinstance(each, str) for each in joints):
            raise InvalidInputError("joints", self.joints, "names of joints, at least one")
        if len(set(joints)) < len(joints):
            raise InvalidInputError("joints", self.joints, "each name once")
        object.__setattr__(self, "joints", tuple(joints))

    @property
    def name(self) -> str:
        return f"held: {', '.join(self.joints)}"

    def rows(self, at: SymbolicPose) -> ca.SX:
        return at.q[:0]  # held joints are left out of the unknowns

    def figure(self, value: float) -> str:
        return "not moved" if value == 0 else f"moved by {abs(value):.4g} rad or m"

    def check(self, robot: Robot) -> None:
        for each in self.joints:
            if each not in robot.joint_names:
                raise UnknownNameError("constraints.joints", each, robot.joint_names)
        if len(self.joints) == robot.n:
            raise InvalidInputError(
                "constraints.joints", list(self.joints), "some of the joints: an arm that holds all is still"
            )

    def mask(self, robot: Robot) -> NDArray[np.bool_]:
        """Which joints (n,) are held."""
        return np.isin(robot.joint_names, self.joints)
