"""The picture of a plan: the arm along the path, its manipulability and that of the initial path, and the joints over time.

The tool path beside the workspace path it follows, and its deviation from that path.
"""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from manipplan.jobs.recordings.comparison import pose_distances
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.deviation import deviations
from manipplan.paths.tolerance import Tolerance
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, instance
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.support.files import write_bytes
from manipplan.support.progress import uninterrupted
from manipplan.support.status import RECORDED
from manipplan.symbolic.free_motion import FreeMotion
from manipplan.tracking.track import Tracking
from manipplan.viz import style
from manipplan.viz.arm import plot_arm, plot_planar_arm
from manipplan.viz.curves import plot_joints, plot_manipulability
from manipplan.viz.motions import Motion, joint_path, named_paths
from manipplan.viz.shapes import LINES, look_at, write_ends

if TYPE_CHECKING:
    from manipplan.jobs.result import Plan


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
    paths = named_paths(plan)
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


#: Number of points at which the tool's z axis is drawn, and its length as a share of the picture.
AXES, LONG = 9, 0.08
#: Number of times at which a plan's tool is compared with its workspace path.
TIMES = 801


def plot_tool_path(robot: Robot, motion: Motion, workspace_path: CartesianPath | None = None, *, ax: Any = None) -> Any:
    """The tool path with its z axis at points along it, beside the workspace path that it follows.

    Args:
        robot: the arm.
        motion: a JointPath, Trajectory or Tracking.
        workspace_path: the path that is followed; None: no comparison.
        ax: Matplotlib axes, with projection="3d" unless the arm is planar; None: those of a new figure.

    Returns the axes.
    """
    curve = joint_path("motion", motion, instance("robot", robot, Robot))
    if workspace_path is not None and not isinstance(workspace_path, CartesianPath):
        raise InvalidInputError("workspace_path", workspace_path, "a CartesianPath or None")
    m = 2 if robot.planar else 3
    pose = robot.kinematics().pose
    way = pose(curve(np.linspace(0.0, 1.0, 400)))[:, :3, 3]
    seen = [way]
    ax = style.axes_for(ax, solid=m == 3, size=(6.0, 5.0))
    with style.shared():
        if workspace_path is not None:
            wanted = workspace_path.sample(400)[:, :3, 3]
            seen.append(wanted)
            ax.plot(*wanted[:, :m].T, color=style.STRAIGHT, linewidth=4.0, alpha=0.6, label="workspace path")
        ax.plot(*way[:, :m].T, color=style.OPTIMUM, label="tool", zorder=LINES)
        if m == 3:
            long = LONG * np.ptp(np.concatenate(seen), axis=0).max()
            for each in pose(curve(np.linspace(0.0, 1.0, AXES))):
                ray = np.stack([each[:3, 3], each[:3, 3] + long * each[:3, 2]])
                seen.append(ray)
                ax.plot(*ray.T, color=style.ELLIPSOID, linewidth=1.2)
            ax.plot([], [], [], color=style.ELLIPSOID, linewidth=1.2, label="tool's z axis")
            look_at(ax, seen)
        else:
            ax.set_aspect("equal", adjustable="datalim")
            style.name_axes(ax)
        write_ends(ax, way[:, :m])
        ax.legend(loc="upper right")
    return ax


def plot_deviation(motion: "Tracking | Plan", *, tolerance: Tolerance | None = None, ax: Any = None) -> Any:
    """Deviation of the tool from the path it follows over time, in mm, and on a second scale in degrees.

    Args:
        motion: a Tracking, or a Plan of `follow` or `improve`: a Tracking is compared with its target of the same time, a Plan
            of `follow` with the nearest point of the workspace path while it follows it, one of `improve` with the recorded
            pose of the same share of the time.
        tolerance: drawn as dashed lines; default: the tolerance of the plan.
        ax: Matplotlib axes; None: those of a new figure. The scale in degrees gets axes of its own over these.

    Returns the axes of the scale in mm. Raises InvalidInputError for a plan that follows no path.
    """
    if tolerance is not None:
        instance("tolerance", tolerance, Tolerance)
    elif not isinstance(motion, Tracking):
        tolerance = getattr(motion, "tolerance", None)
    t, position, rotation = _over_time(motion)
    ax = style.axes_for(ax)
    with style.shared():
        ax.set(xlabel="time [s]", xlim=(t[0], t[-1]), title="deviation of the tool from its path")
        limits = (None, None) if tolerance is None else (tolerance.position, tolerance.rotation)
        kinds = [(ax, 1e3 * position, "position [mm]", style.OPTIMUM, limits[0], 1e3)]
        if np.nan_to_num(rotation).any():
            twin = ax.twinx()
            twin.grid(False)
            twin.spines["right"].set_visible(True)
            kinds.append((twin, np.rad2deg(rotation), "rotation [°]", style.LIMIT, limits[1], 180 / np.pi))
        for axes, values, label, colour, limit, unit in kinds:
            axes.plot(t, values, color=colour)
            if limit is not None:
                axes.axhline(limit * unit, color=colour, linestyle=(0, (4, 3)), linewidth=1.0)
            axes.set_ylim(0, 1.08 * max(np.nanmax(values), 0.0 if limit is None else limit * unit, 1e-9))
            axes.set_ylabel(label + ("; dashed: allowed" if limit is not None else ""), color=colour)
            axes.tick_params(axis="y", colors=colour)
    return ax


def _over_time(motion: Any) -> tuple[Array, Array, Array]:
    """Times [s] and deviations [m, rad], (k,) each."""
    if isinstance(motion, Tracking):
        return motion.t, motion.deviation, motion.rotation_deviation
    workspace_path, trajectory = getattr(motion, "workspace_path", None), getattr(motion, "trajectory", None)
    if trajectory is not None and motion.comparison is not None:
        u = np.linspace(0.0, 1.0, TIMES)
        kinematics = motion.robot.kinematics(motion.result.task)
        first, second = kinematics.pose(motion.result.seed(u)), kinematics.pose(motion.path(u))
        return u * trajectory.duration, *pose_distances(first, second, kinematics.task)
    if trajectory is None or workspace_path is None:
        raise InvalidInputError("motion", motion, "a Tracking, or a Plan of follow or improve that has a trajectory")
    t = np.linspace(motion.path_begin, trajectory.duration, TIMES)
    poses = motion.robot.kinematics().pose(trajectory(t))
    distances = deviations(workspace_path, poses, FreeMotion.of(motion.result.task, planar=motion.robot.planar))
    for begin, end in motion.off_path:
        for values in distances:
            values[(t > begin) & (t < end)] = np.nan
    return t, *distances
