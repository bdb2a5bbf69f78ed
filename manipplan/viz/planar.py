"""The planar arm along a path, seen from above."""

from itertools import chain
from typing import Any

import numpy as np

from manipplan.collision.scene import Scene
from manipplan.collision.shapes import Plane
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, whole_number
from manipplan.support.errors import InvalidInputError
from manipplan.symbolic.task import Task
from manipplan.viz import style
from manipplan.viz.arm import PLACES, check_motions, plot_ellipsoids
from manipplan.viz.motions import Motion, skeleton, tool_ways
from manipplan.viz.shapes import arm_surfaces, draw_skeleton, draw_ways, feet_on_planes, obstacle_surfaces, write, write_ends


def plot_planar_arm(
    robot: Robot,
    path: Motion,
    scene: Scene | None = None,
    *,
    seed: Motion | None = None,
    names: tuple[str, str] = ("path", "seed"),
    places: int = PLACES,
    ax: Any = None,
) -> Any:
    """The planar arm along a motion, from light to dark, with velocity ellipses, obstacles and its tool path.

    Obstacles are seen from above; a plane is drawn as the part of the picture that it fills at z = 0. Arguments are those of
    `plot_arm`, but with axes without projection="3d".

    Returns the axes. Raises InvalidInputError for an arm that is not planar.
    """
    curve, other, world = check_motions(robot, path, scene, seed)
    if not robot.planar:
        raise InvalidInputError("robot", robot.name, "a planar arm; plot_arm draws any other")
    shares = np.linspace(0.0, 1.0, whole_number("places", places, least=2, most=style.MOST_PLACES))
    motions = {name: each for name, each in zip(names, (curve, other), strict=True) if each is not None}
    ways = {name: [way[:, :2] for way in tool_ways(robot, each)] for name, each in motions.items()}
    ax = style.axes_for(ax, size=(6.0, 6.0))
    with style.shared():
        seen = [*chain(*ways.values()), *(skeleton(robot, q)[:, :2] for q in curve(shares))]
        draw_flat_scene(ax, world, seen)
        draw_flat_bodies(ax, robot, curve.start, style.BODY_FIRST, alpha=0.9)
        draw_flat_bodies(ax, robot, curve.goal, style.BODY_LAST, alpha=0.9)
        for share, q in zip(shares, curve(shares), strict=True):
            draw_skeleton(ax, skeleton(robot, q)[:, :2], alpha=0.25 + 0.6 * share)
        plot_ellipsoids(robot.kinematics(Task.planar()), curve, places, ax=ax)
        draw_ways(ax, ways)
        write_ends(ax, next(iter(ways.values()))[0])
        style.name_axes(ax)
        ax.legend(loc="best")
    return ax


def draw_flat_scene(ax: Any, scene: Scene, seen: list[Array]) -> None:
    """Draw obstacles from above, with their names, on equally scaled axes that show them and the points (k, 2) `seen`."""
    from matplotlib.patches import Polygon

    seen = list(seen)
    for name, surface in obstacle_surfaces(scene):
        outline = outline_of(surface.points)
        seen.append(outline)
        ax.fill(*outline.T, facecolor=style.OBSTACLE, edgecolor=style.OBSTACLE, alpha=0.4, linewidth=0.8)
        write(ax, outline.mean(axis=0), name, style.OBSTACLE_NAME)
    flat = np.concatenate(seen)
    points = np.concatenate([flat, *(foot[None, :2] for foot in feet_on_planes(scene, np.pad(flat, ((0, 0), (0, 1)))))])
    low, high = points.min(axis=0), points.max(axis=0)
    size = (high - low).max()
    for name, obstacle in zip(scene.names, scene.obstacles, strict=True):
        if isinstance(obstacle, Plane):
            filled = _below(obstacle, low - size, high + size)  # larger than the data: equal scales widen the picture
            if len(filled) >= 3:
                patch = Polygon(filled, facecolor=style.FLOOR, edgecolor=style.OBSTACLE, alpha=0.35, zorder=0.5)
                ax.add_artist(patch)  # an artist does not affect the axis limits
                write(ax, np.clip(filled.mean(axis=0), low, high), name, style.OBSTACLE_NAME)
    ax.update_datalim(points)
    ax.set_aspect("equal", adjustable="datalim")
    ax.autoscale_view()


def draw_flat_bodies(ax: Any, robot: Robot, q: Array, colour: str, *, alpha: float) -> None:
    """Draw the arm's collision bodies at q (n,) from above."""
    for surface in arm_surfaces(robot, q):
        ax.fill(*outline_of(surface.points).T, facecolor=colour, edgecolor="none", alpha=alpha)


def outline_of(points: Array) -> Array:
    """Corners (m, 2) of the convex outline of points (k, 3) seen from above, in order."""
    from scipy.spatial import ConvexHull

    flat = points[:, :2]
    return np.asarray(flat[ConvexHull(flat).vertices])


def _below(plane: Plane, low: Array, high: Array) -> Array:
    """The corners (m, 2) of the part of the rectangle from `low` to `high` (2,) that lies below a plane at z = 0."""
    corners = np.array([low, (high[0], low[1]), high, (low[0], high[1])])
    normal = plane.pose.rotation[:, 2]
    height = corners @ normal[:2] - normal @ plane.pose.translation
    kept = []
    for k in range(4):
        a, b = height[k], height[(k + 1) % 4]
        if a <= 0:
            kept.append(corners[k])
        if a * b < 0:
            kept.append(corners[k] + a / (a - b) * (corners[(k + 1) % 4] - corners[k]))
    return np.array(kept)
