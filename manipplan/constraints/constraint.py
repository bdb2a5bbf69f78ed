"""Constraint: rows c(q) >= 0 that every configuration of a motion keeps."""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca

from manipplan.robots.arms import known_tool
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError

#: Value of a row, negative, up to which it counts as kept [rad or m].
ROW_TOLERANCE = 1e-6


@dataclass(frozen=True, kw_only=True, eq=False)
class SymbolicPose:
    """A configuration as symbols, and the pose of the tool there.

    Attributes:
        q: (n, 1) joint values [rad or m].
        position: (3, 1) of the tool in the world [m]; of several tools the first, or the one that the constraint names.
        rotation: (3, 3) of the tool in the world.
    """

    q: ca.SX
    position: ca.SX
    rotation: ca.SX


class Constraint(ABC):
    """A constraint on every configuration of a free motion; derive from it for one of your own.

    A row is a smooth function c of the configuration, and is kept where c(q) >= 0. Scale rows so that a change by 1e-6 is
    negligible, as it is in radians and metres: a row counts as kept down to -1e-6. The set of allowed configurations needs some
    width, since searches go through its inside: write an equation as two rows some 1e-3 apart.

    Rows of a class of your own hold at samples between which no joint moves by more than 1e-3 rad or m. Those of TiltLimit and
    PositionBox are proven on the whole motion; where they are about different tools, those of one tool, and the others are
    sampled.
    """

    @property
    @abstractmethod
    def name(self) -> str:
        """What messages and reports call it."""

    @abstractmethod
    def rows(self, at: SymbolicPose) -> ca.SX:
        """The rows (r, 1), as expressions of the configuration."""

    def figure(self, value: float) -> str:
        """What the smallest value of its rows means, for messages and reports."""
        return f"smallest row {value:.4g}" if value >= 0 else f"smallest row {value:.4g}, below 0"

    @property
    def of_tool(self) -> str | None:
        """The tool whose pose its rows take; None: the first one of the robot."""
        return None

    def tool_rows(self) -> Array | None:
        """Rows that are linear in the tool's pose, as weights (r, 13); None for other rows.

        The first three weigh the position, the next nine the columns of the rotation, the last one is added.
        """
        return None

    def check(self, robot: Robot) -> None:
        """Raise InvalidInputError where the constraint does not fit the robot."""
        if self.of_tool is not None:
            known_tool(robot, "constraints.tool", self.of_tool)


def tool_name(tool: object) -> str | None:
    """A tool that a constraint names; raises InvalidInputError for anything but text or None."""
    if tool is not None and (not isinstance(tool, str) or not tool):
        raise InvalidInputError("tool", tool, "the name of one of the robot's tools, or None for the first one")
    return tool


def constraint_tuple(constraints: Sequence[Constraint]) -> tuple[Constraint, ...]:
    """The constraints of a call; raises InvalidInputError, which names the entry, for anything else."""
    if isinstance(constraints, Constraint) or not isinstance(constraints, list | tuple):
        raise InvalidInputError("constraints", constraints, "a list or tuple of constraints, such as [mp.TiltLimit(...)]")
    for k, each in enumerate(constraints):
        if not isinstance(each, Constraint):
            raise InvalidInputError(f"constraints[{k}]", each, "a TiltLimit, PositionBox, HeldJoints or Constraint of yours")
    return tuple(constraints)
