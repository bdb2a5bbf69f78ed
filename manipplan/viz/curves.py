"""Curves along a motion: joints and their limits over time, manipulability and singular values over the share of length.

How a result was found: the layered search with its candidates, and the optimiser solve by solve. The tool's
deviation from the path it follows.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from manipplan.kinematics.kinematics import Kinematics
from manipplan.optimize.result import PathResult
from manipplan.paths.deviation import deviations
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import Tolerance
from manipplan.paths.trajectory import Trajectory
from manipplan.plans.report import pose_distances
from manipplan.robots.limits import JointLimits
from manipplan.search.layers import Layers
from manipplan.search.max_min import SearchResult
from manipplan.search.refine import Refinement
from manipplan.support.checks import COINCIDENT, Array, flag, instance, number, whole_number
from manipplan.support.errors import InvalidInputError
from manipplan.symbolic.free_motion import FreeMotion
from manipplan.tracking.track import Tracking
from manipplan.viz import style
from manipplan.viz.motions import Motion, ShownMotion, joint_path, length_shares
from manipplan.viz.shapes import evenly_chosen

if TYPE_CHECKING:
    from manipplan.plans.result import Plan

#: Number of points per curve.
POINTS = 801
#: Names of a joint's position and its derivatives, and the suffixes of their units.
ORDERS = (("position", ""), ("velocity", "/s"), ("acceleration", "/s²"), ("jerk", "/s³"))


def plot_joints(
    trajectory: Trajectory,
    limits: JointLimits | None = None,
    *,
    order: int = 0,
    share: bool = False,
    unit: str = "rad",
    ax: Any = None,
) -> Any:
    """Joint positions, velocities, accelerations or jerks over time; finite limits as dashed lines in the joint's colour.

    Args:
        limits: `robot.limits`; None: no limits are drawn.
        order: 0 position, 1 velocity, 2 acceleration, 3 jerk.
        share: draw each joint relative to its limits: to its range for positions, to ± its limit for derivatives.
        unit: unit of the joints, for the axis label.

    Raises InvalidInputError for `share` unless every joint has finite limits, or for limits of other joints.
    """
    trajectory = instance("trajectory", trajectory, Trajectory)
    order = whole_number("order", order, least=0, most=3)
    low, high = np.full(trajectory.n, -np.inf), np.full(trajectory.n, np.inf)
    if limits is not None:
        if instance("limits", limits, JointLimits).n != trajectory.n:
            raise InvalidInputError("limits", f"limits of {limits.n} joints", f"limits of {trajectory.n} joints")
        high = (limits.upper, limits.velocity, limits.acceleration, limits.jerk)[order]
        low = -high if order else limits.lower
    if flag("share", share) and not np.isfinite([low, high]).all():
        raise InvalidInputError("share", share, "False where a joint has no finite limit, or no limits are given")
    t = np.linspace(0.0, trajectory.duration, POINTS)
    values = trajectory(t, order)
    if share:
        values = (values - low) / (high - low)
    ax = style.axes_for(ax)
    with style.shared():
        for joint, name in enumerate(trajectory.joint_names):
            line = ("-", "--")[joint // len(style.JOINTS) % 2]
            colour = style.JOINTS[joint % len(style.JOINTS)]
            ax.plot(t, values[:, joint], color=colour, linestyle=line, label=name)
            for bound in (low[joint], high[joint]):
                if np.isfinite(bound) and not share:
                    ax.axhline(bound, color=colour, linestyle=(0, (4, 3)), linewidth=0.8, alpha=0.7)
        kind, per = ORDERS[order]
        if share:
            ends = ["- limit", "0", "+ limit"] if order else ["lower\nlimit", "middle", "upper\nlimit"]
            ax.set(ylim=(-0.03, 1.03), yticks=[0, 0.5, 1], yticklabels=ends)
        else:
            ax.set_ylabel(f"{kind} [{unit}{per}]")
        ax.set(xlabel="time [s]", xlim=(0, trajectory.duration))
        limited = np.isfinite([low, high]).any() and not share
        ax.set_title(f"joint {kind}" + ("; dashed: limits" if limited else ""))
        ax.legend(fontsize=7, ncols=4, loc="upper center", bbox_to_anchor=(0.5, -0.16))
    return ax


def plot_manipulability(
    kinematics: Kinematics,
    paths: Mapping[str, Motion],
    *,
    straight: bool = True,
    bound: float | None = None,
    ax: Any = None,
) -> Any:
    """The measure of `kinematics` along motions, over the share of their length; a dot marks each minimum.

    Args:
        kinematics: of the arm, with task and measure.
        paths: a JointPath, Trajectory or Tracking per name; paths with the same values of the measure share a curve.
        straight: whether the straight line in joint space between the ends of the first path is drawn for comparison.
        bound: a value of the measure to draw as a line, such as `Refinement.bound`.
    """
    instance("kinematics", kinematics, Kinematics)
    if not isinstance(paths, Mapping) or not paths:
        raise InvalidInputError("paths", paths, "a mapping of names to paths, at least one")
    curves = {name: joint_path(f"paths[{name!r}]", motion, kinematics.robot) for name, motion in paths.items()}
    colours = dict(zip(curves, (style.OPTIMUM, style.SEED, *style.JOINTS[2:]), strict=False))
    bound = None if bound is None else number("bound", bound)
    if flag("straight", straight):
        first = next(iter(curves.values()))
        colours["straight"] = style.STRAIGHT
        if first.length >= COINCIDENT:  # unless the arm stands still
            curves["straight"] = JointPath.line(first.start, first.goal)
    s = np.linspace(0.0, 1.0, POINTS)
    drawn: list[tuple[Array, Any]] = []
    ax = style.axes_for(ax)
    with style.shared():
        for name, path in curves.items():
            shares, m = length_shares(path, s), kinematics.manipulability(path(s))
            same = next((line for other, line in drawn if np.allclose(m, other, atol=1e-9)), None)
            if same is not None:
                same.set_label(f"{same.get_label()}, {name}")
                continue
            colour = colours.get(name, style.STRAIGHT)
            [line] = ax.plot(shares, m, color=colour, label=name, linestyle=":" if name == "straight" else "-")
            draw_least(ax, shares, m, colour)
            drawn.append((m, line))
        if bound is not None:
            ax.axhline(bound, color=style.LIMIT, linestyle=(0, (1, 1)), linewidth=1.2, label="bound")
        ax.set(xlabel="share of the path's length", xlim=(0, 1))
        ax.set_ylabel(style.measure_label(kinematics))
        if min(m.min() for m, _ in drawn) >= 0:
            ax.set_ylim(0, None)
        ax.set_title("measure along the path; dots: minimum")
        ax.legend(loc="best")
    return ax


def draw_least(ax: Any, x: Array, values: Array, colour: str) -> None:
    """Draw a dot at the minimum of a curve."""
    ax.plot(x[values.argmin()], values.min(), "o", color=colour, markersize=4, clip_on=False)


def draw_measure(shown: ShownMotion, ax: Any) -> None:
    """Draw the measure of a motion, and of its initial path beside it, over time."""
    for each in shown.motions:
        ax.plot(shown.t, each.manipulability, color=each.colour, label=each.name)
    ax.set(xlabel="time [s]", xlim=(0, shown.trajectory.duration))
    if ax.dataLim.ymin >= 0:
        ax.set_ylim(0, None)
    ax.set_ylabel(style.measure_label(shown.kinematics))


def plot_singular_values(kinematics: Kinematics, path: Motion, *, ax: Any = None) -> Any:
    """All singular values of the task's Jacobian along a motion, over the share of its length; a dot marks each minimum."""
    instance("kinematics", kinematics, Kinematics)
    curve = joint_path("path", path, kinematics.robot)
    s = np.linspace(0.0, 1.0, POINTS)
    shares, values = length_shares(curve, s), np.linalg.svd(kinematics.jacobian(curve(s)), compute_uv=False)
    ax = style.axes_for(ax)
    with style.shared():
        for k, value in enumerate(values.T):
            label = f"σ{str(k + 1).translate(style.SUBSCRIPTS)}" + (" (smallest)" if k == len(values.T) - 1 else "")
            [line] = ax.plot(shares, value, color=style.JOINTS[k % len(style.JOINTS)], label=label)
            draw_least(ax, shares, value, line.get_color())
        unit = "m" if kinematics.task.metres == kinematics.task.rows else "1"
        ax.set(xlabel="share of the path's length", xlim=(0, 1), ylim=(0, None))
        ax.set_ylabel(style.with_unit("singular value", unit))
        ax.set_title(f"singular values of the Jacobian, task {kinematics.task.name}", parse_math=False)
        ax.legend(loc="best", ncols=2)
    return ax


#: Maximum number of candidates drawn per position.
CANDIDATES = 120


def plot_layers(layers: Layers, result: SearchResult | Refinement | None = None, *, ax: Any = None) -> Any:
    """The manipulability of the candidates at each position, and the path that was found among them.

    Args:
        layers: the candidates; at most 120 per position are drawn, evenly by rank.
        result: a SearchResult or a Refinement of these layers: its manipulability at each position, its minimum and its
            bound. For a search that found no path, the position that no path reaches.

    Raises InvalidInputError for a result with another number of positions.
    """
    instance("layers", layers, Layers)
    if result is not None and not isinstance(result, SearchResult | Refinement):
        raise InvalidInputError("result", result, "a SearchResult, a Refinement or None")
    count = len(layers.m)
    if result is not None and len(result.manipulability) not in (0, count):
        raise InvalidInputError("result", f"{len(result.manipulability)} positions", f"a result of these {count} layers")
    shown = [evenly_chosen(np.sort(m), CANDIDATES) for m in layers.m]  # with the smallest and the largest
    place = np.repeat(np.arange(count), [len(each) for each in shown])
    ax = style.axes_for(ax)
    with style.shared():
        ax.plot(place, np.concatenate(shown), ".", color=style.CANDIDATE, markersize=2.5, label="candidates", zorder=1.5)
        ax.plot([each.max() for each in layers.m], color=style.STRAIGHT, linestyle=":", label="largest per position")
        if result is not None and len(result.manipulability):
            m = result.manipulability
            name = "refined path" if isinstance(result, Refinement) else "best continuous path"
            ax.plot(m, color=style.OPTIMUM, linewidth=2.0, label=name)
            ax.plot(m.argmin(), m.min(), "o", color=style.OPTIMUM, markersize=5, label=f"minimum: {m.min():.4g}")
        if result is not None:
            ax.axhline(
                result.bound, color=style.LIMIT, linestyle=(0, (4, 3)), linewidth=1.2, label=f"bound: {result.bound:.4g}"
            )
        breaks_at = getattr(result, "breaks_at", None)
        if breaks_at is not None:
            ax.axvline(breaks_at, color=style.ARM, linewidth=1.2, label="no continuous path reaches this position")
        ax.set(xlabel="position along the path", xlim=(-0.5, count - 0.5))
        ax.set_ylabel("manipulability" if layers.sampler is None else style.measure_label(layers.sampler.kinematics))
        if min(each.min() for each in shown) >= 0:
            ax.set_ylim(0, None)
        ax.set_title(f"{layers.count} candidates at {count} positions")
        ax.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14), ncols=3)
    return ax


def plot_convergence(result: PathResult, *, ax: Any = None) -> Any:
    """g after each solve of the optimiser: filled for a collision-free path, hollow for a path in collision.

    `result` is that of `optimize_path`, or `plan.result`. Raises InvalidInputError for a result without solves.
    """
    history = instance("result", result, PathResult).history
    if not history:
        raise InvalidInputError("result", result.status.name, "the result of an optimisation that made at least one solve")
    solve = np.arange(1, len(history) + 1)
    g = np.array([step.g for step in history])
    free = np.array([step.clearance > 0 for step in history])
    first = np.array([step.first for step in history])
    ax = style.axes_for(ax)
    with style.shared():
        for name, marker in zip(dict.fromkeys(first.tolist()), "osD^", strict=False):
            for which, fill in ((free, style.OPTIMUM), (~free, "none")):
                chosen = (first == name) & which & np.isfinite(g)
                text = f"from {name}, {'collision-free' if fill != 'none' else 'in collision'}"
                if chosen.any():
                    ax.plot(solve[chosen], g[chosen], marker, color=style.OPTIMUM, markerfacecolor=fill, label=text)
        ax.axhline(result.g, color=style.ARM, linestyle="--", linewidth=1.2, label=f"result: {result.g:.4g}")
        values = np.append(g[np.isfinite(g)], result.g)
        low, high = values.min(), values.max()
        spare = max(0.15 * (high - low), 1e-3 * high)
        ax.set_ylim(low - spare, high + spare)
        above = result.seed_cost.g > high + spare  # usually by far: drawn to scale, it would compress the solves
        text = f"seed: {result.seed_cost.g:.4g}" + (", above the picture" if above else "")
        ax.axhline(result.seed_cost.g if not above else np.nan, color=style.SEED, linestyle=":", linewidth=1.2, label=text)
        ax.set(xlabel="solve", ylabel="g, the cost of the path", xlim=(0.5, len(history) + 0.5))
        ax.xaxis.get_major_locator().set_params(integer=True)
        ax.set_title(f"{len(history)} solves")
        ax.legend(loc="best")
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
        u = np.linspace(0.0, 1.0, POINTS)
        kinematics = motion.robot.kinematics(motion.result.task)
        first, second = kinematics.pose(motion.result.seed(u)), kinematics.pose(motion.path(u))
        return u * trajectory.duration, *pose_distances(first, second, kinematics.task)
    if trajectory is None or workspace_path is None:
        raise InvalidInputError("motion", motion, "a Tracking, or a Plan of follow or improve that has a trajectory")
    t = np.linspace(motion.path_begin, trajectory.duration, POINTS)
    poses = motion.robot.kinematics().pose(trajectory(t))
    distances = deviations(workspace_path, poses, FreeMotion.of(motion.result.task, planar=motion.robot.planar))
    for begin, end in motion.off_path:
        for values in distances:
            values[(t > begin) & (t < end)] = np.nan
    return t, *distances
