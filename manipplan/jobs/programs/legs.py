"""Legs: each free motion of a program, with the steps that follow it until the next one."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from manipplan.constraints.constraint_set import ConstraintSet
from manipplan.goals.pose_goal import PoseGoal
from manipplan.goals.read import Target, read_goals
from manipplan.jobs.following.transit import moved_by
from manipplan.jobs.programs.steps import Attach, Detach, MoveAlong, MoveTo, ProgramStep, Wait
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.tolerance import with_defaults
from manipplan.robots.arms import one_tool
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError
from manipplan.support.tolerances import SAME
from manipplan.timing.constant_speed import check_corners, check_tool_speed


@dataclass(frozen=True, kw_only=True, eq=False)
class Leg:
    """A free motion, and what follows it.

    Attributes:
        number: index of its first step.
        targets: the goals of the free motion; none where it leads to the first pose of `rest`, whose first step is a path.
        approach: straight way of the tool by which the free motion ends, in the tool frame [m]; None for none.
        constraints: what the free motion keeps.
        rest: the steps that follow, with their indices.
        is_free: False for what begins at the start of the program, without a free motion.
    """

    number: int
    targets: tuple[Target, ...]
    approach: Array | None
    constraints: ConstraintSet
    rest: tuple[tuple[int, ProgramStep], ...]
    is_free: bool = True

    @property
    def along(self) -> MoveAlong | None:
        """The path to whose first pose the free motion leads; None where it has goals of its own."""
        first = self.rest[0][1] if self.rest and not self.targets else None
        return first if isinstance(first, MoveAlong) and self.is_free else None


def read_steps(
    steps: Sequence[ProgramStep], robot: Robot, start: Array, *, blend: float = 0.0, turns: bool = False
) -> list[Leg]:
    """The legs of a program that begins at start (n,) and has blends of a size [m].

    With `turns`, full turns of configurations reach a goal as well.

    Raises InvalidInputError, which names the step, for what is no step or does not fit the robot.
    """
    if not isinstance(steps, list | tuple) or not steps:
        raise InvalidInputError("steps", steps, "a list of at least one step, such as mp.MoveTo(goal)")
    for k, step in enumerate(steps):
        if not isinstance(step, MoveTo | MoveAlong | Attach | Detach | Wait):
            raise InvalidInputError(f"steps[{k}]", step, "a MoveTo, MoveAlong, Attach, Detach or Wait")
    kinematics = robot.kinematics()
    none = ConstraintSet.of(robot, ())
    legs = [Leg(number=0, targets=(), approach=None, constraints=none, rest=(), is_free=False)]
    at: Array | None = kinematics.pose(start)  # the tool's pose where it is known
    for k, step in enumerate(steps):
        if isinstance(step, MoveTo):
            targets, at = _targets(k, step, robot, turns), None
            only = targets[0] if len(targets) == 1 else None
            if only is not None and only.q is not None:
                at = kinematics.pose(only.q)
            elif only is not None and only.pose is not None and only.pose.is_exact:
                at = only.pose.matrix
            approach = None if step.approach is None else np.array(step.approach)
            constraints = ConstraintSet.of(robot, step.constraints)
            legs.append(Leg(number=k, targets=targets, approach=approach, constraints=constraints, rest=()))
            continue
        if isinstance(step, MoveAlong):
            _check_tool(k, robot)
        if isinstance(step, MoveAlong) and isinstance(step.path, CartesianPath):
            if step.tool_speed is not None:
                before = steps[k - 1] if k else step
                radii = [each.blend for each in (before, step) if isinstance(each, MoveTo | MoveAlong)]
                _check_speed(k, step, robot, max(blend if each is None else each for each in radii))
            if at is None or max(PoseGoal(step.path(0.0)).distances(at[None])) > SAME:
                legs.append(Leg(number=k, targets=(), approach=None, constraints=none, rest=()))
            at = step.path(1.0)
        elif isinstance(step, MoveAlong) and at is not None:
            at = at @ moved_by(np.array(step.path))
        legs[-1] = replace(legs[-1], rest=(*legs[-1].rest, (k, step)))
    return legs if legs[0].rest else legs[1:]


def _check_tool(k: int, robot: Robot) -> None:
    try:
        one_tool(robot, "following a path of the tool")
    except InvalidInputError as error:
        raise InvalidInputError(f"steps[{k}].path", error.value, error.allowed) from error


def _check_speed(k: int, step: MoveAlong, robot: Robot, blend: float) -> None:
    assert step.tool_speed is not None and isinstance(step.path, CartesianPath)
    try:
        check_tool_speed(step.tool_speed, step.path)
        position = with_defaults(step.tolerance).position
        assert position is not None
        check_corners(step.tool_speed, step.path, robot, position=position, margin=blend)
    except InvalidInputError as error:
        raise InvalidInputError(f"steps[{k}].tool_speed", error.value, error.allowed) from error


def _targets(k: int, step: MoveTo, robot: Robot, turns: bool) -> tuple[Target, ...]:
    targets, _ = read_goals(f"steps[{k}].goal", step.goal, robot)
    for each in targets:
        if each.q is not None:
            robot.configuration(each.argument, each.q)
        if step.approach is not None and each.pose is None:
            given = sorted(each.tools) if each.q is None and each.tools else np.array(each.q).tolist()
            raise InvalidInputError(each.argument, given, "a pose of the tool, since there is an approach")
    return tuple(replace(each, turns=turns) for each in targets)
