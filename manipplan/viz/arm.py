"""The arm along a path, in space or seen from above, with the obstacles around it.

Ellipsoids of velocity, force and acceleration, in the plane and in space, alone and along a path.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from itertools import chain
from typing import Any

import numpy as np

from manipplan.collision.scene import Scene
from manipplan.collision.shapes import Plane
from manipplan.kinematics.kinematics import Kinematics
from manipplan.measures.ellipsoid import Ellipsoid, velocity_ellipsoid
from manipplan.paths.cartesian import CartesianPath
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, ArrayLike, finite_array, instance, number, whole_number
from manipplan.support.errors import InvalidInputError
from manipplan.symbolic.task import Task
from manipplan.viz import style
from manipplan.viz.motions import DrawnTool, Motion, drawn_tools, ellipsoid_scale, joint_path, skeleton
from manipplan.viz.shapes import Surface, arm_surfaces, feet_on_planes, joined, obstacle_surfaces, plane_patches

#: Direction towards the light.
LIGHT = np.array([0.35, -0.5, 0.8])
#: Margin of the axes around their contents, and minimum side of the axes, as shares of the longest side.
MARGIN, LEAST = 0.04, 0.3
#: Drawing order of lines and names, above surfaces.
LINES, NAMES = 60, 70
#: Maximum distance between the ends of a closed tool path, as a share of its extent.
CLOSED = 0.05
#: Maximum difference of two tool paths that are drawn as one, as a share of their size.
EQUAL_PATHS = 1e-2


def draw_surface(ax: Any, surface: Surface, colour: str, *, alpha: float, edges: bool = False) -> None:
    """Draw a surface, lit from one side, on 3D axes, optionally with its edges."""
    from matplotlib.colors import to_rgb
    from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

    if not surface.faces:
        return
    shades = _brightness(surface.faces)[:, None] * to_rgb(colour)
    lit = np.concatenate([np.clip(shades, 0, 1), np.full((len(shades), 1), alpha)], axis=1)
    ax.add_collection3d(Poly3DCollection(_equal(surface.faces), facecolors=lit, edgecolors="none", linewidths=0))
    if edges and surface.edges:  # a cloud has none
        ax.add_collection3d(Line3DCollection(surface.edges, colors=colour, linewidths=0.8))


def draw_skeleton(ax: Any, points: Array, *, alpha: float = 1.0, colour: str = style.ARM) -> None:
    """Draw the lines between joints (k, 2) or (k, 3), and dots at all but the last."""
    ax.plot(*points.T, color=colour, linewidth=1.4, alpha=alpha, solid_capstyle="round", zorder=LINES)
    ax.plot(*points[:-1].T, "o", color=colour, markersize=2.5, alpha=alpha, zorder=LINES)


def draw_ways(ax: Any, ways: Mapping[str, Sequence[Array]]) -> None:
    """Draw the paths (k, 2) or (k, 3) of all tools in one or two motions by name; the second is the first's initial path.

    If both are the same, as along a workspace path that is followed, one line gets both names.
    """
    first, *others = (np.concatenate(each) for each in ways.values())
    if others and np.abs(others[0] - first).max() < EQUAL_PATHS * np.ptp(first, axis=0).max():
        ways = {" and ".join(ways): next(iter(ways.values()))}
    for (name, tools), colour, width in zip(ways.items(), (style.OPTIMUM, style.SEED), (2.0, 1.3), strict=False):
        label = f"{'tools' if len(tools) > 1 else 'tool'}, {name}"
        for k, way in enumerate(tools):
            ax.plot(*way.T, color=colour, linewidth=width, label=None if k else label, zorder=LINES)


def write(ax: Any, at: Array, text: str, colour: str) -> None:
    """Write a name at a point (2,) or (3,), with a white outline so that it is legible over the object it names."""
    from matplotlib.patheffects import withStroke

    rim = [withStroke(linewidth=2, foreground="white")]
    ax.text(*at, text, color=colour, fontsize=8, ha="center", va="bottom", zorder=NAMES, path_effects=rim)


def write_ends(ax: Any, way: Array) -> None:
    """Write "start" and "goal" at the ends of a tool path (k, 2) or (k, 3), or both in one label for a closed path."""
    if np.linalg.norm(way[-1] - way[0]) > CLOSED * np.ptp(way, axis=0).max():
        write(ax, way[0], "start", style.ARM)
        write(ax, way[-1], "goal", style.ARM)
    else:
        write(ax, way[0], "start and goal", style.ARM)


def fit_view(ax: Any, seen: Iterable[Array], *, zoom: float = 1.0) -> None:
    """Set the limits of 3D axes around points, with the same scale along all three."""
    from matplotlib.ticker import MaxNLocator

    low, high = box_around(seen)
    for axis, side in zip((ax.xaxis, ax.yaxis, ax.zaxis), high - low, strict=True):
        axis.set_major_locator(MaxNLocator(max(3, round(7 * side / (high - low).max())), steps=[1, 2, 5, 10], prune="both"))
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    ax.set_box_aspect(high - low, zoom=zoom)
    ax.view_init(elev=22, azim=-55)
    style.name_axes(ax)


def points_of(surfaces: Iterable[Surface]) -> list[Array]:
    """Corners of the surfaces that have faces."""
    return [surface.points for surface in surfaces if surface.faces]


def box_around(seen: Iterable[Array]) -> tuple[Array, Array]:
    """Lower and upper corner of the axes that show all points (k, 3)."""
    points = np.concatenate(list(seen))
    low, high = points.min(axis=0), points.max(axis=0)
    longest = (high - low).max()
    spare = MARGIN * longest + np.maximum(LEAST * longest - (high - low), 0.0) / 2
    return low - spare, high + spare


def _equal(faces: tuple[Array, ...]) -> Array:
    """Polygons as one array (f, k, 3); polygons with fewer corners repeat some of them.

    From polygons of different sizes Matplotlib makes an array with uninitialised memory, and takes axis limits from it.
    """
    most = max(map(len, faces))
    return np.array([face[np.arange(most) * len(face) // most] for face in faces])


def _brightness(faces: tuple[Array, ...]) -> Array:
    """Brightness of each polygon, (k,), from the angle of its normal to the light, for either side."""
    normals = np.array([np.cross(face[1] - face[0], face[2] - face[1]) for face in faces])
    long = np.linalg.norm(normals, axis=1)
    facing = np.abs(normals @ LIGHT) / np.maximum(long * np.linalg.norm(LIGHT), 1e-15)
    return np.asarray(0.72 + 0.28 * facing)


#: Number of points of a tool path.
WAY = 160


def plot_ellipsoid(
    ellipsoid: Ellipsoid,
    centre: ArrayLike,
    *,
    ax: Any = None,
    scale: float = 1.0,
    largest: float | None = None,
    axes: bool = False,
    **options: Any,
) -> Any:
    """Draw an ellipsoid of two rows as an ellipse, an ellipsoid of three rows as a surface on 3D axes.

    Args:
        ellipsoid: with 2 or 3 radii.
        centre: position of the centre, (2,) or (3,) [m].
        ax: Matplotlib axes, with projection="3d" for three rows; None: those of a new figure.
        scale: metres drawn per unit of the radii.
        largest: limit on the drawn radii; required if one is infinite.
        axes: whether the principal axes are drawn as well.
        **options: color, alpha, label and other properties of the patch or surface.

    Raises InvalidInputError for other numbers of rows, or an infinite radius without `largest`.
    """
    m = len(instance("ellipsoid", ellipsoid, Ellipsoid).radii)
    if m not in (2, 3):
        raise InvalidInputError("ellipsoid", ellipsoid.radii.tolist(), "2 or 3 radii; select those rows of the Jacobian")
    middle = finite_array("centre", centre, (m,))
    number("scale", scale, above=0.0)
    radii = ellipsoid.radii if largest is None else np.minimum(ellipsoid.radii, number("largest", largest, above=0.0))
    if not np.isfinite(radii).all():
        raise InvalidInputError("largest", None, "a length to draw the infinite radius with")
    options = {"color": style.ELLIPSOID, "alpha": 0.3, "linewidth": 0, **options}
    spokes = scale * radii * ellipsoid.axes
    new = ax is None
    ax = style.axes_for(ax, solid=m == 3, size=(5.0, 5.0))
    with style.shared():
        if axes:
            for spoke in spokes.T:
                ax.plot(*np.stack([middle - spoke, middle + spoke]).T, color=options["color"], linewidth=1.0)
        if m == 2:
            around = np.linspace(0.0, 2 * np.pi, 90)
            outline = middle + np.stack([np.cos(around), np.sin(around)], axis=1) @ spokes.T
            ax.fill(*outline.T, **options)
        else:
            ax.plot_surface(*np.moveaxis(_ball() @ spokes.T + middle, 2, 0), **{"rcount": 11, "ccount": 19, **options})
        if new:
            ax.set_aspect("equal", adjustable="datalim")
    return ax


def plot_ellipsoids(
    kinematics: Kinematics, path: Motion, places: int = 7, *, scale: float | None = None, ax: Any = None, **options: Any
) -> Any:
    """Velocity ellipsoids at each tool, evenly spaced in the parameter of a motion, with the tool path.

    Args:
        kinematics: of the robot; each tool has the ellipsoids of its own arm. A task of three rows gives ellipsoids,
            Task.planar() ellipses in the x-y plane; for any other task the ellipsoids of the tool's linear velocity are drawn.
        places: number of ellipsoids, at least 2.
        scale: metres drawn per unit of the radii; default: the largest radius is a twelfth of the arm's length.
        ax: Matplotlib axes, with projection="3d" for three rows; None: those of a new figure.
        **options: as in `plot_ellipsoid`.
    """
    robot = instance("kinematics", kinematics, Kinematics).robot
    curve = joint_path("path", path, robot)
    task = kinematics.task
    is_drawn = task.rows == 3 or replace(task, relative_to=None) == Task.planar()
    if is_drawn and task.relative_to is not None:
        tools: Sequence[DrawnTool] = [DrawnTool(kinematics=kinematics, joints=tuple(range(robot.n)))]
    else:
        tools = drawn_tools(robot, task if is_drawn else None)
    m = tools[0].kinematics.task.rows
    q, fine = (
        curve(np.linspace(0.0, 1.0, count)) for count in (whole_number("places", places, least=2, most=style.MOST_PLACES), WAY)
    )
    scale = ellipsoid_scale(robot, tools, q) if scale is None else number("scale", scale, above=0.0)
    ax = style.axes_for(ax, solid=m == 3, size=(5.5, 5.0))
    with style.shared():
        for tool in tools:
            ax.plot(*tool.pose(fine)[:, :m, 3].T, color=style.OPTIMUM, linewidth=1.2, zorder=LINES)
            for jacobian, centre in zip(tool.jacobian(q), tool.pose(q)[:, :m, 3], strict=True):
                plot_ellipsoid(velocity_ellipsoid(jacobian), centre, ax=ax, scale=scale, **options)
        style.name_axes(ax)
        ax.set_aspect("equal", adjustable="datalim")
    return ax


def _ball() -> Any:
    """Points of the unit sphere, (11, 19, 3)."""
    around, up = np.meshgrid(np.linspace(0, 2 * np.pi, 19), np.linspace(0, np.pi, 11))
    return np.stack([np.cos(around) * np.sin(up), np.sin(around) * np.sin(up), np.cos(up)], axis=2)


#: Number of postures of the arm drawn along a path.
POSTURES = 7
#: Offset of an obstacle's name from its centre towards the viewer, as a share of its size: less is in front of it there.
FORWARD = np.array([0.28, -0.28, 0.0])


def plot_arm(
    robot: Robot,
    path: Motion,
    scene: Scene | None = None,
    *,
    seed: Motion | None = None,
    names: tuple[str, str] = ("path", "seed"),
    places: int = POSTURES,
    ax: Any = None,
) -> Any:
    """The arm along a motion, from light to dark, with velocity ellipsoids, obstacles and its tool path.

    Collision bodies are drawn at the start and the goal, the skeleton between them. Obstacles are drawn in their true shape
    with their names; a plane is a patch as large as the picture. A planar arm is seen from above; a plane is then the part of
    the picture that it fills at z = 0. Everything is drawn as vector graphics.

    Args:
        seed: another motion, of which the tool path is drawn.
        names: names of the two motions in the legend.
        places: number of postures drawn, at least 2, evenly spaced in the path's parameter.
        ax: Matplotlib axes, with projection="3d" unless the arm is planar and seen from above; None: those of a new figure.
    """
    curve = joint_path("path", path, instance("robot", robot, Robot))
    other = None if seed is None else joint_path("seed", seed, robot)
    world = Scene() if scene is None else instance("scene", scene, Scene)
    shares = np.linspace(0.0, 1.0, whole_number("places", places, least=2, most=style.MOST_PLACES))
    solid = not robot.planar or getattr(ax, "name", "") == "3d"
    m, ax = 3 if solid else 2, style.axes_for(ax, solid=solid, size=(7.0, 6.0) if solid else (6.0, 6.0))
    motions = {name: each for name, each in zip(names, (curve, other), strict=True) if each is not None}
    s = np.linspace(0.0, 1.0, WAY)
    ways = {name: [tool.pose(each(s))[:, :m, 3] for tool in drawn_tools(robot)] for name, each in motions.items()}
    lines = [skeleton(robot, q)[:, :m] for q in curve(shares)]
    with style.shared():
        seen = [*chain(*ways.values()), *lines]
        if m == 3:
            first, last = (joined(arm_surfaces(robot, q)) for q in (curve.start, curve.goal))
            seen = draw_scene(ax, world, [*seen, *points_of((first, last))])
            draw_surface(ax, first, style.BODY_FIRST, alpha=0.45)
            draw_surface(ax, last, style.BODY_LAST, alpha=0.9)
        else:
            draw_flat_scene(ax, world, seen)
            draw_flat_bodies(ax, robot, curve.start, style.BODY_FIRST, alpha=0.9)
            draw_flat_bodies(ax, robot, curve.goal, style.BODY_LAST, alpha=0.9)
        for share, line in zip(shares, lines, strict=True):
            draw_skeleton(ax, line, alpha=0.25 + 0.6 * share)
        plot_ellipsoids(robot.kinematics(Task.planar() if m == 2 else Task.position()), curve, places, ax=ax)
        draw_ways(ax, ways)
        for way in next(iter(ways.values())):
            write_ends(ax, way)
        if m == 3:
            fit_view(ax, seen)
        else:
            style.name_axes(ax)
        ax.legend(loc="upper right" if m == 3 else "best")
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
    found = []
    for k in range(4):
        a, b = height[k], height[(k + 1) % 4]
        if a <= 0:
            found.append(corners[k])
        if a * b < 0:
            found.append(corners[k] + a / (a - b) * (corners[(k + 1) % 4] - corners[k]))
    return np.array(found)


#: Number of points at which the tool's z axis is drawn, and its length as a share of the picture.
AXES, LONG = 9, 0.08


def plot_tool_path(robot: Robot, motion: Motion, workspace_path: CartesianPath | None = None, *, ax: Any = None) -> Any:
    """The tool path with its z axis at points along it, beside the workspace path that it follows.

    Args:
        workspace_path: the path that is followed; None: no comparison.
        ax: Matplotlib axes, with projection="3d" unless the arm is planar; None: those of a new figure.
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
            fit_view(ax, seen)
        else:
            ax.set_aspect("equal", adjustable="datalim")
            style.name_axes(ax)
        write_ends(ax, way[:, :m])
        ax.legend(loc="upper right")
    return ax
