"""Inverse kinematics of the user, which a robot carries along when it gets another base or tool frame."""

import threading
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from manipplan.robots.model_tree import frame_index
from manipplan.support.checks import Array, ArrayLike, finite_array, flag, number_array
from manipplan.support.errors import InvalidInputError

if TYPE_CHECKING:
    from manipplan.robots.robot import Robot

#: From a pose (4, 4) of the tool to configurations (k, n) that reach it [rad or m]; None or nothing where there is none.
PoseSolver: TypeAlias = Callable[[Array], ArrayLike | None]

#: A solver of the user need not be safe to share between threads.
_ONE_AT_A_TIME = threading.RLock()


@dataclass(frozen=True, kw_only=True, eq=False)
class OwnInverseKinematics:
    """A solver of the user; `complete`: whether it returns every solution, up to full turns.

    It was given for poses (4, 4) of the base in the world, and of the tool frame in the last link.
    """

    solver: PoseSolver = field(repr=False)
    complete: bool
    base: Array
    tool: Array

    @classmethod
    def of(cls, robot: "Robot", solver: PoseSolver, complete: bool) -> "OwnInverseKinematics":
        """A solver for a robot as it is; raises InvalidInputError where it cannot be called."""
        if isinstance(solver, type) or not callable(solver):
            raise InvalidInputError("solver", solver, "a function of a pose (4, 4), or None for the library's own method")
        return cls(solver=solver, complete=flag("complete", complete), base=robot.base, tool=_tool_in_link(robot))

    @property
    def name(self) -> str:
        """Name of the function or class."""
        return str(getattr(self.solver, "__qualname__", type(self.solver).__qualname__))

    def configurations(self, robot: "Robot", pose: Array) -> Array:
        """What the solver returns for a pose (4, 4) of the robot's tool in the world: (k, n) finite numbers.

        The solver gets the pose that its own tool frame has at its own base. Raises InvalidInputError, which names the solver,
        where it raises, or returns something else.
        """
        of_solver = self.base @ np.linalg.inv(robot.base) @ pose @ np.linalg.inv(_tool_in_link(robot)) @ self.tool
        try:
            with _ONE_AT_A_TIME:
                answer = self.solver(of_solver)
        except Exception as error:  # whatever the user's function raises
            wanted = f"one that returns configurations (k, {robot.n}) or None; it raised {type(error).__name__}: {error}"
            raise InvalidInputError("inverse kinematics", self.name, wanted) from error
        argument = f"configurations of {self.name}"
        q = np.zeros(0) if answer is None else number_array(argument, answer)
        return finite_array(argument, q if q.size else q.reshape(0, robot.n), (None, robot.n)).copy()


def _tool_in_link(robot: "Robot") -> Array:
    """The pose (4, 4) of the tool frame in the last link."""
    placement: Array = robot.model.frames[frame_index(robot.model, robot.tool)].placement.homogeneous
    return placement
