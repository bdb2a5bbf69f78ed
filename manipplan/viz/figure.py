"""The figures of a plan and of a program: the arm along the motion, and its manipulability and joints over it."""

from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from manipplan.paths.trajectory import Trajectory
from manipplan.robots.robot import Robot
from manipplan.support.checks import instance
from manipplan.support.errors import PlanningError
from manipplan.support.files import write_bytes
from manipplan.support.progress import uninterrupted
from manipplan.support.status import RECORDED
from manipplan.viz import style
from manipplan.viz.arm import draw_surface, plot_arm, plot_planar_arm, write
from manipplan.viz.curves import POINTS, plot_joints, plot_manipulability
from manipplan.viz.motions import MovedPart, bare, find_moved_parts, name_paths
from manipplan.viz.shapes import joined, surface_of

if TYPE_CHECKING:
    from manipplan.jobs.programs.program import Program
    from manipplan.jobs.result import Plan

#: Number of postures of the arm that are drawn, and of places of a part while it is carried.
POSTURES, CARRIED = 9, 4
#: Steps that begin within this share of the duration share a label.
TOGETHER = 0.015


def save_plan(plan: "Plan", file: str | Path) -> None:
    """Write the picture of a plan as PNG; see `plan_figure`."""
    save_figure(lambda: plan_figure(plan), file)


def save_figure(draw: Callable[[], Any], file: str | Path) -> None:
    """Write the figure that `draw` returns as PNG."""
    with uninterrupted():  # drawing the first figure imports Matplotlib and builds its formula parser
        figure = draw()
        write_bytes(file, lambda stream: figure.savefig(stream, format="png", dpi=110))


def plan_figure(plan: "Plan", figure: Any = None) -> Any:
    """Draw a plan: the arm along the path, its manipulability and that of the initial path, and the joints over time.

    `figure` is a Matplotlib figure to draw into; default: a new one of 11.5 x 6 inches. Returns the figure. Raises
    PlanningError for a plan without a trajectory.
    """
    finished(plan)
    paths = name_paths(plan)
    seed, names = plan.result.seed if len(paths) > 1 else None, (next(iter(paths)), list(paths)[-1])
    title = f"{plan.robot.name}: {plan.trajectory.duration:.2f} s"
    if plan.report.counts:
        title += f", minimum manipulability {plan.report.min_manipulability:.3g}"
    with style.shared():
        figure, space, top, bottom = draw_motion(figure, title, plan.robot, plan.trajectory)
        plot = plot_planar_arm if plan.robot.planar else plot_arm
        plot(plan.robot, plan.path, plan.scene, seed=seed, names=names, ax=space)
        kinematics = plan.robot.kinematics(plan.result.task, measure=plan.result.measure)
        bound = plan.refinement.bound if plan.refinement is not None else None
        started_free = plan.refinement is None and plan.result.status not in RECORDED  # a tool path allows no straight line
        plot_manipulability(kinematics, paths, straight=started_free, bound=bound, ax=top)
        for begin, end in plan.off_path:
            bottom.axvspan(begin, end, color=style.ARM, alpha=0.12, linewidth=0)
            bottom.annotate(
                "off the path",
                (begin, 0.0),
                xycoords=("data", "axes fraction"),
                xytext=(3, 3),
                textcoords="offset points",
                fontsize=8,
                color=style.ARM,
            )
    return figure


def draw_motion(figure: Any, title: str, robot: Robot, trajectory: Trajectory) -> tuple[Any, Any, Any, Any]:
    """Draw the title and the joints over time; returns the figure, and its axes for the arm, its measure and its joints.

    `figure` is a Matplotlib figure to draw into, or None for a new one of 11.5 x 6 inches.
    """
    from matplotlib.figure import Figure

    figure = figure if figure is not None else Figure(figsize=(11.5, 6.0))
    figure.set_layout_engine("constrained")
    parts: Any = figure.subfigures(1, 2, width_ratios=(1.15, 1))
    left, right = parts
    left.suptitle(title, fontsize=11, x=0.02, ha="left")
    space = left.subplots() if robot.planar else left.add_subplot(projection="3d")
    top, bottom = right.subplots(2, 1)
    ranged = bool(np.isfinite([robot.limits.lower, robot.limits.upper]).all())
    units = {"m" if kind == "prismatic" else "rad" for kind in robot.joint_types}
    plot_joints(trajectory, robot.limits, share=ranged, unit=" or ".join(sorted(units, reverse=True)), ax=bottom)
    return figure, space, top, bottom


def finished(plan: "Plan") -> None:
    """Raises InvalidInputError for an object that is not a plan, PlanningError for a plan without trajectory."""
    from manipplan.jobs.result import PartialPlan, Plan

    instance("plan", plan, PartialPlan)
    if not isinstance(plan, Plan):
        raise PlanningError(f"there is no trajectory to draw: {plan.status.value}", plan)


def save_program(program: "Program", file: str | Path) -> None:
    """Write the picture of a program as PNG; see `program_figure`."""
    save_figure(lambda: program_figure(program), file)


def program_figure(program: "Program", figure: Any = None) -> Any:
    """Draw a program: the arm and its parts along the motion, and manipulability and joints over time, with the steps.

    Parts are drawn where they are at the start, on their way, and where they are put down. `figure` is a Matplotlib figure
    to draw into; default: a new one of 11.5 x 6 inches. Returns the figure.
    """
    from manipplan.jobs.programs.program import Program

    instance("program", program, Program)
    robot = bare(program.robot)
    title = f"{robot.name}: {len(program.marks)} steps, {program.duration:.2f} s, minimum m {program.min_manipulability:.3g}"
    with style.shared():
        figure, space, top, bottom = draw_motion(figure, title, robot, program.trajectory)
        plot = plot_planar_arm if robot.planar else plot_arm
        plot(robot, program.trajectory, program.scene, places=POSTURES, ax=space)
        if not robot.planar:
            _write_blends(space, program)
            for part in find_moved_parts(program):
                _draw_part(space, program, part)
        _plot_measure(program, top)
        draw_marks(program, top, names=True)
        draw_marks(program, bottom, names=False)
    return figure


def draw_marks(program: "Program", ax: Any, *, names: bool) -> None:
    """Draw when the steps of a program begin, as lines on axes over its time, and where wanted their names."""
    near: dict[float, list[str]] = {}
    for mark in program.marks:
        changes = mark.name in ("Attach", "Detach")
        ax.axvline(mark.begin, color=style.LIMIT if changes else style.ARM, linewidth=1.0, linestyle="-" if changes else ":")
        begin = next((each for each in near if mark.begin - each < TOGETHER * program.duration), mark.begin)
        near.setdefault(begin, []).append(f"{mark.step} {mark.name}")
    for begin, texts in near.items() if names else ():
        at = {"xycoords": ("data", "axes fraction"), "xytext": (2, 2), "textcoords": "offset points"}
        ax.annotate(", ".join(texts), (begin, 0.0), **at, fontsize=7, color=style.ARM, rotation=90, va="bottom", ha="left")


def _write_blends(ax: Any, program: "Program") -> None:
    """The radius of each blend, at its corner."""
    following = [mark.begin for mark in program.marks[1:]]
    for mark, end in zip(program.marks, [*following, program.duration], strict=True):
        for radius, t in ((mark.path_blend, mark.path_begin), (mark.blend, end)):
            if radius and t is not None:
                q = program.trajectory(t)
                for tool in program.robot.tools:
                    place = program.robot.arm(tool).kinematics().pose(q[list(program.robot.joints_of(tool))])[:3, 3]
                    write(ax, place, f"{1e3 * radius:.3g} mm", style.ARM)


def _plot_measure(program: "Program", ax: Any) -> None:
    """The measure over time; a dot marks its minimum."""
    result = program.parts[0].result
    kinematics = program.parts[0].robot.kinematics(result.task, measure=result.measure)
    t = np.linspace(0.0, program.duration, POINTS)
    m = kinematics.manipulability(program.trajectory(t))
    ax.plot(t, m, color=style.OPTIMUM)
    ax.plot(t[m.argmin()], m.min(), "o", color=style.OPTIMUM, markersize=4, clip_on=False)
    ax.set(xlabel="time [s]", xlim=(0, program.duration), title="measure over time; dot: minimum")
    ax.set_ylabel(style.measure_label(kinematics))
    ax.set_ylim(min(0.0, m.min()), None)


def _draw_part(ax: Any, program: "Program", part: MovedPart) -> None:
    """A part on its way in the hand, and where it is put down."""
    robot = bare(program.robot)
    edges = [*part.times, program.duration]
    for k, (begin, end) in enumerate(pairwise(edges)):
        times = np.linspace(begin, end, CARRIED + 2)[1:-1] if part.held[k] else [begin] if k else []
        for t in times:
            solid = part.at(float(t), robot, program.trajectory(float(t)))
            if solid is None:
                continue
            surface = joined(surface_of(shape).placed(solid.pose) for shape in solid.shapes())
            draw_surface(ax, surface, style.OPTIMUM, alpha=0.25 if part.held[k] else 0.7, edges=True)
            if not part.held[k]:
                low, high = surface.points.min(axis=0), surface.points.max(axis=0)
                write(ax, np.append((low + high)[:2] / 2, high[2]), f"{part.name}, put down", style.OPTIMUM)
