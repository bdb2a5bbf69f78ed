"""The arm in space along a path, with the obstacles around it."""

from itertools import chain
from typing import Any

import numpy as np

from manipplan.collision.scene import Scene
from manipplan.paths.joint import JointPath
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, instance, whole_number
from manipplan.viz import style
from manipplan.viz.ellipsoids import plot_ellipsoids
from manipplan.viz.motions import Motion, joint_path, skeleton, tool_ways
from manipplan.viz.shapes import Surface, arm_surfaces, feet_on_planes, joined, obstacle_surfaces, plane_patches
from manipplan.viz.space import box_around, draw_skeleton, draw_surface, draw_ways, look_at, points_of, write, write_ends

#: Number of postures of the arm drawn along a path.
PLACES = 7
#: Offset of an obstacle's name from its centre towards the viewer, as a share of its size: less is in front of it there.
FORWARD = np.array([0.28, -0.28, 0.0])


def plot_arm(
    robot: Robot,
    path: Motion,
    scene: Scene | None = None,
    *,
    seed: Motion | None = None,
    names: tuple[str, str] = ("path", "seed"),
    places: int = PLACES,
    ax: Any = None,
) -> Any:
    """The arm in 3D along a motion, from light to dark, with velocity ellipsoids, obstacles and its tool path.

    Collision bodies are drawn at the start and the goal, the skeleton between them. Obstacles are drawn in their true shape
    with their names; a plane is a patch as large as the picture. Everything is drawn as vector graphics.

    Args:
        robot: the arm.
        path: a JointPath, Trajectory or Tracking.
        scene: obstacles; default None.
        seed: another motion, of which the tool path is drawn.
        names: names of the two motions in the legend.
        places: number of postures drawn, at least 2, evenly spaced in the path's parameter.
        ax: Matplotlib axes with projection="3d"; None: those of a new figure.

    Returns the axes.
    """
    curve, other, world = check_motions(robot, path, scene, seed)
    shares = np.linspace(0.0, 1.0, whole_number("places", places, least=2, most=style.MOST_PLACES))
    ways = {name: tool_ways(robot, each) for name, each in zip(names, (curve, other), strict=True) if each is not None}
    first, last = (joined(arm_surfaces(robot, q)) for q in (curve.start, curve.goal))
    ax = style.axes_for(ax, solid=True, size=(7.0, 6.0))
    with style.shared():
        seen = draw_scene(
            ax, world, [*chain(*ways.values()), *(skeleton(robot, q) for q in curve(shares)), *points_of((first, last))]
        )
        draw_surface(ax, first, style.BODY_FIRST, alpha=0.45)
        draw_surface(ax, last, style.BODY_LAST, alpha=0.9)
        for share, q in zip(shares, curve(shares), strict=True):
            draw_skeleton(ax, skeleton(robot, q), alpha=0.25 + 0.6 * share)
        plot_ellipsoids(robot.kinematics(), curve, places, ax=ax)
        draw_ways(ax, ways)
        for way in next(iter(ways.values())):
            write_ends(ax, way)
        look_at(ax, seen)
        ax.legend(loc="upper right")
    return ax


def draw_scene(ax: Any, scene: Scene, seen: list[Array]) -> list[Array]:
    """Draw obstacles and their names on 3D axes; returns the points (k, 3) `seen` in the picture, extended by theirs."""
    seen = list(seen)
    for name, surface in obstacle_surfaces(scene):
        draw_surface(ax, surface, style.OBSTACLE, alpha=0.22, edges=True)
        seen.append(surface.points)
        low, high = surface.points.min(axis=0), surface.points.max(axis=0)
        write(ax, np.append(((low + high) / 2 + FORWARD * (high - low))[:2], high[2]), name, style.OBSTACLE_NAME)
    seen += [foot[None] for foot in feet_on_planes(scene, np.concatenate(seen))]
    for name, patch in plane_patches(scene, *box_around(seen)):
        draw_surface(ax, Surface(faces=(patch,), edges=(np.vstack([patch, patch[:1]]),)), style.FLOOR, alpha=0.35, edges=True)
        write(ax, 0.85 * patch[0] + 0.15 * patch.mean(axis=0), name, style.OBSTACLE_NAME)
    return seen


def check_motions(
    robot: Robot, path: Motion, scene: Scene | None, seed: Motion | None
) -> tuple[JointPath, JointPath | None, Scene]:
    """The paths of both motions, and the scene; raises InvalidInputError for a wrong type or another arm's motion."""
    instance("robot", robot, Robot)
    world = Scene() if scene is None else instance("scene", scene, Scene)
    return joint_path("path", path, robot), None if seed is None else joint_path("seed", seed, robot), world
