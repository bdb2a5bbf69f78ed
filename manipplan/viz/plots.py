"""Pictures of a plan: joint curves, the index along the path, and the arm with its ellipsoids along the way."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pinocchio as pin

from manipplan.checks import Array
from manipplan.errors import PlanningError
from manipplan.files import write_bytes
from manipplan.interrupts import uninterrupted
from manipplan.kinematics.kinematics import Kinematics
from manipplan.measures.ellipsoid import velocity_ellipsoid
from manipplan.measures.task import Task
from manipplan.paths.joint import JointPath
from manipplan.robots.description import frame_index
from manipplan.robots.robot import Robot
from manipplan.robots.scene import Scene
from manipplan.viz import style
from manipplan.viz.ellipsoids import plot_ellipsoid

if TYPE_CHECKING:
    from manipplan.jobs.result import Plan

#: A shape larger than this [m] is a plane, whose bounding box has no end.
ENDLESS = 1e6
#: Figures drawn of the arm along a path.
POSTURES = 7


def save_plan(plan: "Plan", file: str | Path) -> None:
    """Write the picture of a plan as PNG; see `plan_figure`."""
    with uninterrupted():  # Matplotlib and its parser of formulae are imported and built while the first figure is drawn
        figure = plan_figure(plan)
        write_bytes(file, lambda stream: figure.savefig(stream, format="png", dpi=110))


def plan_figure(plan: "Plan", figure: Any = None) -> Any:
    """Draw a plan: the arm along the path, the index against the seed's, and the joints over time.

    `figure` is a Matplotlib figure to draw into; default, a new one of 11.5 x 6 inches. Returns the figure.
    """
    from matplotlib import rc_context
    from matplotlib.figure import Figure

    if plan.trajectory is None or plan.result is None or plan.report is None or plan.path is None:
        raise PlanningError(f"there is no trajectory to draw: {plan.status.value}", plan)
    with rc_context(style.STYLE):
        figure = figure if figure is not None else Figure(figsize=(11.5, 6.0))
        figure.set_layout_engine("constrained")
        parts: Any = figure.subfigures(1, 2, width_ratios=(1.15, 1))
        left, right = parts
        title = f"{plan.robot.name}: {plan.trajectory.duration:.2f} s, least index {plan.report.min_manipulability:.3g}"
        left.suptitle(title, fontsize=11, x=0.02, ha="left")
        if plan.robot.planar:
            plot_planar_arm(plan.robot, plan.path, plan.scene, ax=left.subplots())
        else:
            plot_arm(plan.robot, plan.path, plan.scene, seed=plan.result.seed, ax=left.add_subplot(projection="3d"))
        top, bottom = right.subplots(2, 1)
        first, second = ("refined", "best of the samples") if plan.refinement is not None else ("optimised", "seed")
        paths = {first: plan.path}
        if plan.result.seed is not None:
            paths[second] = plan.result.seed
        kinematics = plan.robot.kinematics(plan.result.task, measure=plan.result.measure)
        plot_index(kinematics, paths, straight=plan.refinement is None, ax=top)
        if plan.refinement is not None:
            top.axhline(plan.refinement.bound, color=style.STRAIGHT, linestyle=":", label="bound")
            top.legend(loc="best", fontsize=8)
        plot_joints(plan, ax=bottom)
    return figure


def plot_index(kinematics: Kinematics, paths: dict[str, JointPath], *, straight: bool = True, ax: Any) -> None:
    """The measure of `kinematics` along paths, by share of their length, by default with the straight line for comparison."""
    first = next(iter(paths.values()))
    colours = dict(zip(paths, (style.OPTIMUM, style.SEED), strict=False))
    if straight:
        paths = {**paths, "straight": JointPath.line(first.start, first.goal)}
    drawn: list[tuple[Array, Any]] = []
    for name, path in paths.items():
        s, index = _by_length(path, kinematics)
        same = next((line for other, line in drawn if np.allclose(index, other, atol=1e-9)), None)
        if same is not None:
            same.set_label(f"{same.get_label()}, {name}")
            continue
        colour = colours.get(name, style.STRAIGHT)
        [line] = ax.plot(s, index, color=colour, label=name, linestyle=":" if name == "straight" else "-")
        ax.plot(s[index.argmin()], index.min(), "o", color=colour, markersize=4, clip_on=False)
        drawn.append((index, line))
    unit = kinematics.measure.unit(kinematics.task)
    shown = "" if unit == "1" else f" [${unit}$]".replace("m^", r"\mathrm{m}^") if "^" in unit else f" [{unit}]"
    ax.set(xlabel="share of the path's length", ylabel=f"{kinematics.measure.name}{shown}", xlim=(0, 1), ylim=(0, None))
    ax.set_title("manipulability along the path; dots: the least", fontsize=9, loc="left")
    ax.legend(loc="best", fontsize=8)


def plot_joints(plan: "Plan", *, ax: Any) -> None:
    """Joint positions over time, each as a share of its range (angles themselves where there is no limit)."""
    trajectory, limits = plan.trajectory, plan.robot.limits
    if trajectory is None:
        raise PlanningError(f"there is no trajectory to draw: {plan.status.value}", plan)
    t = np.linspace(0.0, trajectory.duration, 300)
    q = trajectory(t)
    limited = bool(np.isfinite(limits.lower).all() and np.isfinite(limits.upper).all())
    if limited:
        q = (q - limits.lower) / (limits.upper - limits.lower)
    for joint, name in enumerate(trajectory.joint_names):
        ax.plot(t, q[:, joint], color=style.JOINTS[joint % len(style.JOINTS)], label=name)
    if limited:
        ax.set(ylim=(-0.03, 1.03), yticks=[0, 0.5, 1], yticklabels=["lower\nlimit", "middle", "upper\nlimit"])
    else:
        ax.set_ylabel("joint angle [rad]")
    ax.set(xlabel="time [s]", xlim=(0, trajectory.duration))
    ax.set_title("joint positions", fontsize=9, loc="left")
    ax.legend(fontsize=7, ncols=4, loc="upper center", bbox_to_anchor=(0.5, -0.16))


def plot_arm(robot: Robot, path: JointPath, scene: Scene | None = None, *, seed: JointPath | None = None, ax: Any) -> None:
    """The arm in 3D along a path, from light to dark, with its velocity ellipsoids, the obstacles and the seed's trace."""
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    kinematics = robot.kinematics(Task.position())
    places = np.linspace(0.0, 1.0, POSTURES)
    seen = []
    for place, q in zip(places, path(places), strict=True):
        skeleton = _skeleton(robot, q)
        seen.append(skeleton)
        end = place in (0.0, 1.0)
        ax.plot(*skeleton.T, color=style.ARM, linewidth=3.0 if end else 1.4, alpha=0.25 + 0.7 * place, solid_capstyle="round")
        ax.plot(*skeleton[:-1].T, "o", color=style.ARM, markersize=2.5, alpha=0.25 + 0.7 * place)
        plot_ellipsoid(velocity_ellipsoid(kinematics.jacobian(q)), skeleton[-1], ax=ax, scale=0.12)
    trace = kinematics.pose(path(np.linspace(0.0, 1.0, 120)))[:, :3, 3]
    ax.plot(*trace.T, color=style.OPTIMUM, linewidth=2.0, label="tool, optimised")
    if seed is not None:
        before = kinematics.pose(seed(np.linspace(0.0, 1.0, 120)))[:, :3, 3]
        ax.plot(*before.T, color=style.SEED, linewidth=1.2, label="tool, seed")
        seen.append(before)
        ax.legend(fontsize=8, loc="upper right")
    for faces in _obstacle_faces(scene):
        seen.append(faces.reshape(-1, 3))
        ax.add_collection3d(
            Poly3DCollection(faces, facecolor=style.OBSTACLE, edgecolor=style.OBSTACLE, alpha=0.22, linewidth=0.6)
        )
    points = np.concatenate([*seen, trace])
    middle, reach = (points.min(axis=0) + points.max(axis=0)) / 2, np.ptp(points, axis=0).max() / 2
    ax.set(xlim=(middle[0] - reach, middle[0] + reach), ylim=(middle[1] - reach, middle[1] + reach))
    ax.set(zlim=(middle[2] - reach, middle[2] + reach), xlabel="x [m]", ylabel="y [m]", zlabel="z [m]")
    ax.set_box_aspect((1, 1, 1), zoom=1.05)
    ax.view_init(elev=22, azim=-55)


def plot_planar_arm(robot: Robot, path: JointPath, scene: Scene | None = None, *, ax: Any) -> None:
    """The planar arm along a path, from light to dark, with its velocity ellipses and the obstacles' bounding boxes."""
    from matplotlib.patches import Polygon
    from scipy.spatial import ConvexHull

    kinematics = robot.kinematics(Task.planar())
    places = np.linspace(0.0, 1.0, POSTURES)
    for place, q in zip(places, path(places), strict=True):
        skeleton = _skeleton(robot, q)
        width = 3.0 if place in (0.0, 1.0) else 1.6
        ax.plot(skeleton[:, 0], skeleton[:, 1], "o-", color=style.ARM, alpha=0.2 + 0.7 * place, linewidth=width, markersize=3)
        plot_ellipsoid(velocity_ellipsoid(kinematics.jacobian(q)), skeleton[-1, :2], ax=ax, scale=0.15)
    trace = kinematics.pose(path(np.linspace(0.0, 1.0, 200)))[:, :2, 3]
    ax.plot(trace[:, 0], trace[:, 1], color=style.OPTIMUM, label="tool, optimised")
    straight = JointPath.line(path.start, path.goal)
    trace = kinematics.pose(straight(np.linspace(0.0, 1.0, 200)))[:, :2, 3]
    ax.plot(trace[:, 0], trace[:, 1], ":", color=style.STRAIGHT, label="tool, straight in joint space")
    for faces in _obstacle_faces(scene):
        corners = faces.reshape(-1, 3)[:, :2]
        ax.add_patch(Polygon(corners[ConvexHull(corners).vertices], color=style.OBSTACLE, alpha=0.4))
    ax.set_aspect("equal", adjustable="datalim")
    ax.set(xlabel="x [m]", ylabel="y [m]")
    ax.legend(fontsize=8, loc="upper right")


def _by_length(path: JointPath, kinematics: Any) -> tuple[Array, Array]:
    s = np.linspace(0.0, 1.0, 801)
    speed = np.linalg.norm(path(s, 1), axis=1)
    gained = np.concatenate([[0.0], np.cumsum((speed[1:] + speed[:-1]) / 2)])
    return gained / gained[-1], kinematics.manipulability(path(s))


def _skeleton(robot: Robot, q: Array) -> Array:
    """Origins of base, joints and tool (k, 3)."""
    data = robot.model.createData()
    pin.framesForwardKinematics(robot.model, data, q)
    origins = [data.oMi[i].translation for i in range(robot.model.njoints)]
    return np.array([*origins, data.oMf[frame_index(robot.model, robot.tool)].translation])


def _obstacle_faces(scene: Scene | None) -> list[Array]:
    """Faces of each obstacle (f, 4, 3): a box's own, the bounding box of any other shape in its frame. Planes have none."""
    drawn = []
    for obstacle in scene.obstacles if scene is not None else ():
        for shape in obstacle.shapes():
            shape.computeLocalAABB()
            low, high = np.array(shape.aabb_local.min_), np.array(shape.aabb_local.max_)
            if not np.abs([low, high]).max() < ENDLESS:
                continue
            corners = np.array([[x, y, z] for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])])
            world = corners @ obstacle.pose.rotation.T + obstacle.pose.translation
            faces = [(0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5)]
            drawn.append(np.array([world[list(face)] for face in faces]))
    return drawn
