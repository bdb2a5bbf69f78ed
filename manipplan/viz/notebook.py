"""Pictures of values in notebooks, as HTML with an embedded PNG."""

import base64
from html import escape
from io import BytesIO
from typing import Any

import numpy as np

from manipplan.collision.scene import Scene
from manipplan.ik.solutions import SolutionSet
from manipplan.jobs.programs.program import Program
from manipplan.jobs.result import PartialPlan
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.robot import Robot
from manipplan.viz import style
from manipplan.viz.arm import draw_scene, draw_skeleton, draw_surface, look_at, points_of
from manipplan.viz.curves import plot_joints
from manipplan.viz.figure import plan_figure, program_figure
from manipplan.viz.motions import skeleton
from manipplan.viz.shapes import arm_surfaces, joined

#: Resolution of the pictures [dots per inch], and maximum number of solutions that are drawn.
RESOLUTION, MOST_SOLUTIONS = 80, 200


def html_of(value: object) -> str:
    """A value's text and its picture; only the text where there is nothing to draw."""
    text = f"<pre>{escape(_text(value))}</pre>"
    figure = _figure(value)
    if figure is None:
        return text
    stream = BytesIO()
    figure.savefig(stream, format="png", dpi=RESOLUTION)
    data = base64.b64encode(stream.getvalue()).decode("ascii")
    return f'{text}<img alt="{escape(repr(value))}" src="data:image/png;base64,{data}">'


def _text(value: object) -> str:
    if isinstance(value, PartialPlan):
        return f"{value.status.name}: {value.message}" if value.report is None else str(value.report)
    return str(value) if isinstance(value, Robot | SolutionSet | Program) else repr(value)


def _figure(value: object) -> Any:
    from matplotlib.figure import Figure

    if isinstance(value, Program):
        return program_figure(value)
    if isinstance(value, PartialPlan):
        return None if value.trajectory is None else plan_figure(value)  # type: ignore[arg-type]  # then it is a Plan
    with style.shared():
        figure = Figure(figsize=(6.0, 4.0), layout=None if isinstance(value, Robot | Scene) else "constrained")
        if isinstance(value, Robot):
            _draw_robot(_solid_axes(figure), value)
        elif isinstance(value, Scene) and value.obstacles:
            ax = _solid_axes(figure)
            look_at(ax, draw_scene(ax, value, [np.zeros((1, 3))]))
        elif isinstance(value, Trajectory):
            plot_joints(value, ax=figure.subplots())
        elif isinstance(value, SolutionSet) and len(value):
            _draw_solutions(figure.subplots(), value)
        else:
            return None
    return figure


def _solid_axes(figure: Any) -> Any:
    """3D axes over the whole figure, with room for the labels at the bottom."""
    figure.subplots_adjust(left=0.0, right=1.0, bottom=0.12, top=1.0)
    return figure.add_subplot(projection="3d")


def _draw_robot(ax: Any, robot: Robot) -> None:
    """The arm in its neutral configuration."""
    surface, line = joined(arm_surfaces(robot, robot.neutral)), skeleton(robot, robot.neutral)
    draw_surface(ax, surface, style.BODY_LAST, alpha=0.6)
    draw_skeleton(ax, line)
    look_at(ax, [line, *points_of((surface,))])


def _draw_solutions(ax: Any, solutions: SolutionSet) -> None:
    """Each solution as a line over the joints."""
    shown = solutions.q[np.linspace(0, len(solutions) - 1, min(len(solutions), MOST_SOLUTIONS)).round().astype(int)]
    joints = np.arange(1, shown.shape[1] + 1)
    ax.plot(joints, shown.T, "o-", color=style.OPTIMUM, alpha=max(0.15, 1 / len(shown)), markersize=2.5)
    ax.set_xticks(joints)
    ax.set_xlabel("joint")
    ax.set_ylabel("position (rad or m)")
