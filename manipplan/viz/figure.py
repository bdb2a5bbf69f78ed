"""The figure of a plan or program: the arm along the motion, and its manipulability and joints over it.

The pictures of other values in notebooks, as HTML with an embedded PNG.
"""

import base64
import logging
import re
import warnings
from html import escape
from io import BytesIO
from itertools import pairwise
from pathlib import Path
from typing import IO, Any

import numpy as np

from manipplan.collision.scene import Scene
from manipplan.ik.solutions import SolutionSet
from manipplan.paths.trajectory import Trajectory
from manipplan.plans.result import PartialPlan, Plan
from manipplan.programs.program import Program
from manipplan.robots.robot import Robot
from manipplan.support.files import write_bytes
from manipplan.support.progress import uninterrupted
from manipplan.support.status import RECORDED
from manipplan.viz import style
from manipplan.viz.arm import (
    POSTURES,
    draw_scene,
    draw_skeleton,
    draw_surface,
    fit_view,
    plot_arm,
    points_of,
    write,
)
from manipplan.viz.curves import POINTS, draw_least, draw_measure, plot_joints, plot_manipulability
from manipplan.viz.motions import MovedPart, ShownMotion, skeleton
from manipplan.viz.shapes import arm_surfaces, evenly_chosen, joined, surface_of

log = logging.getLogger("manipplan")

#: What Matplotlib says of a character that no font has.
GLYPH = re.compile(r"Glyph (\d+) .* missing from font")
#: Number of postures of the arm that are drawn of a program, and of places of a part while it is carried.
PROGRAM_POSTURES, CARRIED = 9, 4
#: Steps that begin within this share of the duration share a label.
TOGETHER = 0.015
#: Resolution of the pictures in notebooks [dots per inch], and maximum number of solutions that are drawn.
RESOLUTION, MOST_SOLUTIONS = 80, 200


def save_figure(plan: Plan | Program, file: str | Path) -> None:
    """Write the picture of a plan or program as PNG; see `draw_figure`."""
    with uninterrupted():  # drawing the first figure imports Matplotlib and builds its formula parser
        figure = draw_figure(plan)
        write_bytes(file, lambda stream: _write_png(figure, stream, 110))


def draw_figure(plan: Plan | Program, figure: Any = None) -> Any:
    """Draw a plan or program: the arm along the motion, its manipulability, and the joints over time.

    A plan shows its manipulability and that of its initial path over the fraction of the path's length; a program over time,
    with the steps. Parts are drawn where they are at the start, on their way, and where they are
    put down. `figure` is a Matplotlib figure to draw into; default: a new one of 11.5 x 6 inches. Returns the figure.

    Raises PlanningError for a plan without a trajectory.
    """
    from matplotlib.figure import Figure

    shown = ShownMotion.of(plan, POINTS)
    robot = shown.robot
    with style.shared():
        figure = figure if figure is not None else Figure(figsize=(11.5, 6.0))
        figure.set_layout_engine("constrained")
        left, right = figure.subfigures(1, 2, width_ratios=(1.15, 1))
        title = f"{shown.trajectory.duration:.2f} s"
        if isinstance(plan, Program):
            title = f"{len(plan.marks)} steps, {title}, minimum m {plan.min_manipulability:.3g}"
        elif plan.report.counts:
            title += f", minimum manipulability {plan.report.min_manipulability:.3g}"
        left.suptitle(f"{robot.name}: {title}", fontsize=11, x=0.02, ha="left")
        space = left.subplots() if robot.planar else left.add_subplot(projection="3d")
        top, bottom = right.subplots(2, 1)
        seed = shown.seed.path if shown.seed is not None else None
        names, places = (shown.ours.name, shown.motions[-1].name), PROGRAM_POSTURES if shown.marks else POSTURES
        plot_arm(robot, shown.ours.path, plan.scene, seed=seed, names=names, places=places, ax=space)
        if isinstance(plan, Program):
            if not robot.planar:
                _write_blends(space, plan)
                for part in shown.moved:
                    _draw_part(space, shown, part)
            draw_measure(shown, top)
            draw_least(top, shown.t, shown.ours.manipulability, shown.ours.colour)
            top.set_title("measure over time; dot: minimum")
        else:
            free = plan.refinement is None and plan.result.status not in RECORDED  # a tool path allows no straight line
            bound = plan.refinement.bound if plan.refinement is not None else None
            paths = {each.name: each.path for each in shown.motions}
            plot_manipulability(shown.kinematics, paths, straight=free, bound=bound, ax=top)
        ranged = bool(np.isfinite([robot.limits.lower, robot.limits.upper]).all())
        units = {"m" if kind == "prismatic" else "rad" for kind in robot.joint_types}
        plot_joints(shown.trajectory, robot.limits, share=ranged, unit=" or ".join(sorted(units, reverse=True)), ax=bottom)
        _draw_marks(shown, top, names=True)
        _draw_marks(shown, bottom, names=False)
        for begin, end in () if isinstance(plan, Program) else plan.off_path:
            bottom.axvspan(begin, end, color=style.ARM, alpha=0.12, linewidth=0)
            _annotate(bottom, begin, "off the path", xytext=(3, 3), fontsize=8)
    return figure


def _annotate(ax: Any, t: float, text: str, **options: Any) -> None:
    """Write at the bottom of axes over time."""
    ax.annotate(text, (t, 0.0), xycoords=("data", "axes fraction"), textcoords="offset points", color=style.ARM, **options)


def _draw_marks(shown: ShownMotion, ax: Any, *, names: bool) -> None:
    """Draw when the steps of a program begin, as lines on axes over its time, and where wanted their names."""
    near: dict[float, list[str]] = {}
    for mark in shown.marks:
        changes = mark.name in ("Attach", "Detach")
        ax.axvline(mark.begin, color=style.LIMIT if changes else style.ARM, linewidth=1.0, linestyle="-" if changes else ":")
        begin = next((each for each in near if mark.begin - each < TOGETHER * shown.trajectory.duration), mark.begin)
        near.setdefault(begin, []).append(f"{mark.step} {mark.name}")
    for begin, texts in near.items() if names else ():
        _annotate(ax, begin, ", ".join(texts), xytext=(2, 2), fontsize=7, rotation=90, va="bottom", ha="left")


def _write_blends(ax: Any, program: Program) -> None:
    """The radius of each blend, at its corner."""
    following = [mark.begin for mark in program.marks[1:]]
    for mark, end in zip(program.marks, [*following, program.duration], strict=True):
        for radius, t in ((mark.path_blend, mark.path_begin), (mark.blend, end)):
            if radius and t is not None:
                q = program.trajectory(t)
                for tool in program.robot.tools:
                    place = program.robot.arm(tool).kinematics().pose(q[list(program.robot.joints_of(tool))])[:3, 3]
                    write(ax, place, f"{1e3 * radius:.3g} mm", style.ARM)


def _draw_part(ax: Any, shown: ShownMotion, part: MovedPart) -> None:
    """A part on its way in the hand, and where it is put down."""
    times = [since for since, _, _ in part.states]
    for k, (begin, end) in enumerate(pairwise([*times, shown.trajectory.duration])):
        held = part.is_held(begin)
        for t in np.linspace(begin, end, CARRIED + 2)[1:-1] if held else [begin] if k else []:
            solid = part.at(float(t), shown.robot, shown.trajectory(float(t)))
            if solid is None:
                continue
            surface = joined(surface_of(shape).placed(solid.pose) for shape in solid.shapes())
            draw_surface(ax, surface, style.OPTIMUM, alpha=0.25 if held else 0.7, edges=True)
            if not held:
                low, high = surface.points.min(axis=0), surface.points.max(axis=0)
                write(ax, np.append((low + high)[:2] / 2, high[2]), f"{part.name}, put down", style.OPTIMUM)


def _write_png(figure: Any, stream: IO[bytes], dpi: int) -> None:
    """Write a figure; one line of the log tells which characters of names no font has."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.filterwarnings("always", message=GLYPH.pattern)
        figure.savefig(stream, format="png", dpi=dpi)
    missing = [int(found[1]) for each in caught if (found := GLYPH.match(str(each.message)))]
    if missing:
        characters = "".join(map(chr, dict.fromkeys(missing)))
        remedy = "install one that has, such as fonts-noto-cjk, and put its name into matplotlib.rcParams['font.family']"
        log.warning("the font of the pictures has no %s: %s", characters, remedy)
    for each in caught:
        if not GLYPH.match(str(each.message)):
            warnings.warn_explicit(each.message, each.category, each.filename, each.lineno)


def html_of(value: object) -> str:
    """A value's text and its picture; only the text where there is nothing to draw."""
    text = f"<pre>{escape(_text(value))}</pre>"
    figure = _figure(value)
    if figure is None:
        return text
    stream = BytesIO()
    _write_png(figure, stream, RESOLUTION)
    data = base64.b64encode(stream.getvalue()).decode("ascii")
    return f'{text}<img alt="{escape(repr(value))}" src="data:image/png;base64,{data}">'


def _text(value: object) -> str:
    if isinstance(value, PartialPlan):
        return f"{value.status.name}: {value.message}" if value.report is None else str(value.report)
    return str(value) if isinstance(value, Robot | SolutionSet | Program) else repr(value)


def _figure(value: object) -> Any:
    from matplotlib.figure import Figure

    if isinstance(value, Program | Plan):
        return draw_figure(value)
    with style.shared():
        figure = Figure(figsize=(6.0, 4.0), layout=None if isinstance(value, Robot | Scene) else "constrained")
        if isinstance(value, Robot):
            _draw_robot(_solid_axes(figure), value)
        elif isinstance(value, Scene) and value.obstacles:
            ax = _solid_axes(figure)
            fit_view(ax, draw_scene(ax, value, [np.zeros((1, 3))]))
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
    fit_view(ax, [line, *points_of((surface,))])


def _draw_solutions(ax: Any, solutions: SolutionSet) -> None:
    """Each solution as a line over the joints."""
    shown = evenly_chosen(solutions.q, MOST_SOLUTIONS)
    joints = np.arange(1, shown.shape[1] + 1)
    ax.plot(joints, shown.T, "o-", color=style.OPTIMUM, alpha=max(0.15, 1 / len(shown)), markersize=2.5)
    ax.set_xticks(joints)
    ax.set_xlabel("joint")
    ax.set_ylabel("position (rad or m)")
