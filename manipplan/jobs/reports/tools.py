"""ToolFigure: what a report says of each tool of a robot with several."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from manipplan.cost.integral import PathIntegral
from manipplan.jobs.goals.pose_goal import PoseGoal
from manipplan.paths.joint import JointPath
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.display import one_line
from manipplan.support.tolerances import SAME


@one_line
@dataclass(frozen=True, kw_only=True)
class ToolFigure:
    """Figures of one tool of a robot with several.

    Attributes:
        tool: the tool frame.
        min_manipulability, min_at: minimum of the measure of its arm alone, and the share of the duration at which it occurs;
            of a relative task that of its motion in the world. 0 where its arm has fewer joints than the task has rows.
        goal_position, goal_rotation: distance [m] and angle [rad] from the pose of the goal at the end; None where the goal has
            no pose for this tool.
        held_position, held_rotation: for `carry`: largest distance [m] and angle [rad] from its pose relative to the first
            tool; None for the first tool and for other jobs.
    """

    tool: str
    min_manipulability: float
    min_at: float
    goal_position: float | None = None
    goal_rotation: float | None = None
    held_position: float | None = None
    held_rotation: float | None = None

    def __str__(self) -> str:
        text = f"{self.tool}: minimum m {self.min_manipulability:.4g}"
        if self.goal_position is not None and self.goal_rotation is not None:
            text += f"; ends {1e3 * self.goal_position:.2g} mm, {np.rad2deg(self.goal_rotation):.2g}° from its pose"
        if self.held_position is not None and self.held_rotation is not None:
            held = f"{1e3 * self.held_position:.2g} mm, {1e3 * self.held_rotation:.2g} mrad"
            text += f"; keeps its pose relative to the first tool to {held}"
        return text


def tool_figures(path: JointPath, integral: PathIntegral) -> tuple[ToolFigure, ...]:
    """The figures of each tool on a path; none for a robot with one."""
    kinematics = integral.kinematics
    robot, task, measure = kinematics.robot, replace(kinematics.task, relative_to=None), kinematics.measure.of_one_tool()
    if len(robot.tools) == 1:
        return ()
    found = []
    for tool in robot.tools:
        joints = list(robot.joints_of(tool))
        if measure.needs_full_rank and task.rows > len(joints):  # of a relative task, which the joints of both tools serve
            found.append(ToolFigure(tool=tool, min_manipulability=0.0, min_at=0.0))
            continue
        one = robot.arm(tool).kinematics(task, measure=measure, compiled=kinematics.compiled, threads=1)
        own = JointPath(breaks=path.breaks, control=path.control[:, :, joints])
        if own.length < SAME:
            found.append(ToolFigure(tool=tool, min_manipulability=float(one.manipulability(own.start)), min_at=0.0))
            continue
        cost = replace(integral, kinematics=one, metric=None).cost(own)
        found.append(ToolFigure(tool=tool, min_manipulability=cost.min_manipulability, min_at=cost.at))
    return tuple(found)


def with_goals(
    figures: tuple[ToolFigure, ...], robot: Robot, q: Array, goals: Mapping[str, PoseGoal] | None
) -> tuple[ToolFigure, ...]:
    """The figures with the distances of the tools from their goals at the last configuration q (n,)."""
    if goals is None:
        return figures
    errors = {tool: goal.errors(robot, q, tool) for tool, goal in goals.items()}
    return tuple(
        replace(each, goal_position=errors[each.tool][0], goal_rotation=errors[each.tool][1]) if each.tool in errors else each
        for each in figures
    )
