"""Drawing in space: lit surfaces, skeletons and names on axes with projection="3d", and the limits of these axes."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from manipplan.support.checks import Array
from manipplan.viz import style
from manipplan.viz.shapes import Surface

#: Direction towards the light.
LIGHT = np.array([0.35, -0.5, 0.8])
#: Margin of the axes around their contents, and minimum side of the axes, as shares of the longest side.
MARGIN, LEAST = 0.04, 0.3
#: Drawing order of lines and names, above surfaces.
LINES, NAMES = 60, 70
#: Maximum distance between the ends of a closed tool path, as a share of its extent.
CLOSED = 0.05
#: Maximum difference of two tool paths that are drawn as one, as a share of their size.
SAME = 1e-2


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
    if others and np.abs(others[0] - first).max() < SAME * np.ptp(first, axis=0).max():
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


def look_at(ax: Any, seen: Iterable[Array], *, zoom: float = 1.0) -> None:
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
