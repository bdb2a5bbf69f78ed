"""The steps of a program."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from manipplan.constraints.constraint import Constraint, constraint_tuple
from manipplan.jobs.goals.pose_goal import Goal
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.tolerance import Tolerance
from manipplan.robots.attached import Solid
from manipplan.support.checks import finite_array, instance, number, whole_number
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError
from manipplan.symbolic.task import Task


class ProgramStep:
    """A step of a program: MoveTo, MoveAlong, Attach, Detach or Wait."""


@one_line
@dataclass(frozen=True, eq=False)
class MoveTo(ProgramStep):
    """A free motion to a goal.

    Attributes:
        goal: as for `plan`: a configuration, the name of a state, a pose, a PoseGoal, or a list of these. A PoseGoal may be one
            of a part that the arm carries then (`of`).
        approach: straight way of the tool by which the motion ends [m]: a distance along the tool's z-axis, or a vector (3,) in
            the tool frame. Its goals are poses.
        constraints: what the motion keeps, as for `plan`; an approach does not count.
        blend: radius within which the arm goes around the corners of the move, at the approach and at its end, without a stop
            [m]; 0: it stops there; None: that of the program.
    """

    goal: Goal
    approach: float | ArrayLike | None = field(default=None, kw_only=True)
    constraints: Sequence[Constraint] = field(default=(), kw_only=True)
    blend: float | None = field(default=None, kw_only=True)

    def __post_init__(self) -> None:
        if self.approach is not None:
            object.__setattr__(self, "approach", _way("approach", self.approach))
        object.__setattr__(self, "constraints", constraint_tuple(self.constraints))
        _check_blend(self)


@one_line
@dataclass(frozen=True, eq=False)
class MoveAlong(ProgramStep):
    """A motion of the tool along a path, or straight on. A free motion to its first pose comes first where one is needed.

    Attributes:
        path: a CartesianPath in the world; or a vector (3,) by which the tool moves straight on, in the tool frame [m].
        tool_speed: constant speed of the tool's origin [m/s], kept to a hundredth between the ramps or blends at its ends, and
            not exceeded; None: as fast as the limits allow. The error for one that is too fast names the fastest.
        tolerance: largest deviation from the path, as for `follow`.
        task: what of the path's poses the tool follows, as for `follow`; None: Task.pose(), of a planar arm Task.planar().
        positions: number of positions at which configurations are enumerated; None: as for `follow`. A vector has its own.
        blend: as for `MoveTo`, at the first pose, where a free motion leads there, and at the end. At least half of the path
            is left.
    """

    path: CartesianPath | ArrayLike
    tool_speed: float | None = field(default=None, kw_only=True)
    tolerance: Tolerance | None = field(default=None, kw_only=True)
    task: Task | None = field(default=None, kw_only=True)
    positions: int | None = field(default=None, kw_only=True)
    blend: float | None = field(default=None, kw_only=True)

    def __post_init__(self) -> None:
        if not isinstance(self.path, CartesianPath):
            object.__setattr__(self, "path", _way("path", self.path))
        if self.tool_speed is not None:
            object.__setattr__(self, "tool_speed", number("tool_speed", self.tool_speed, above=0.0))
        for name, kind in (("tolerance", Tolerance), ("task", Task)):
            if getattr(self, name) is not None:
                instance(name, getattr(self, name), kind)
        if self.positions is not None:
            whole_number("positions", self.positions, least=2)
        _check_blend(self)


@one_line
@dataclass(frozen=True, eq=False)
class Attach(ProgramStep):
    """The hand takes up a part, which the arm carries from then on.

    Attributes:
        part: the name of an obstacle, which is no longer in the scene; or a shape posed in the tool frame.
        name: name of a part that is given as a shape; default: its own, or "part".
        tool: of a robot with several tools the one that takes it up; "": the only one.
    """

    part: str | Solid
    name: str = field(default="", kw_only=True)
    tool: str = field(default="", kw_only=True)

    def __post_init__(self) -> None:
        if not isinstance(self.part, str) and (isinstance(self.part, type) or not isinstance(self.part, Solid)):
            raise InvalidInputError("part", self.part, "the name of an obstacle, or a shape such as a Box")
        instance("name", self.name, str)
        instance("tool", self.tool, str)

    @property
    def part_name(self) -> str:
        """What the part is called from then on."""
        return self.part if isinstance(self.part, str) else self.name or self.part.name or "part"


@one_line
@dataclass(frozen=True, eq=False)
class Detach(ProgramStep):
    """The hand puts down a part, which is an obstacle of the scene from then on.

    Attributes:
        name: of the part.
    """

    name: str = "part"

    def __post_init__(self) -> None:
        instance("name", self.name, str)


@one_line
@dataclass(frozen=True, eq=False)
class Wait(ProgramStep):
    """The arm stands still.

    Attributes:
        seconds: how long [s].
    """

    seconds: float

    def __post_init__(self) -> None:
        object.__setattr__(self, "seconds", number("seconds", self.seconds, above=0.0))


def _check_blend(step: MoveTo | MoveAlong) -> None:
    if step.blend is not None:
        object.__setattr__(step, "blend", number("blend", step.blend, least=0.0))


def _way(argument: str, value: float | ArrayLike) -> tuple[float, float, float]:
    """A vector (3,) in the tool frame; a number is a distance along its z-axis."""
    if isinstance(value, int | float | np.number) and not isinstance(value, bool):
        return 0.0, 0.0, number(argument, value, above=0.0)
    x, y, z = finite_array(argument, value, (3,))
    if np.linalg.norm([x, y, z]) < 1e-6:
        raise InvalidInputError(argument, value, "a way that is not zero [m]")
    return float(x), float(y), float(z)
