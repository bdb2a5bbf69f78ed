"""Drawing in space: lit surfaces, skeletons and names on axes with projection="3d", and what these show."""

from collections.abc import Iterable
from typing import Any

import numpy as np

from manipplan.checks import Array
from manipplan.viz import style
from manipplan.viz.shapes import Surface

#: Where the light comes from.
LIGHT = np.array([0.35, -0.5, 0.8])
#: How far beyond what is drawn the axes go, and the least share of their longest side that a side has.
MARGIN, LEAST = 0.04, 0.3
#: What is drawn over surfaces.
LINES, NAMES = 60, 70


def draw_surface(ax: Any, surface: Surface, colour: str, *, alpha: float, edges: bool = False) -> list[Any]:
    """Draw a surface, lit from one side, on 3D axes, and its edges if asked for; returns what was added."""
    from matplotlib.colors import to_rgb
    from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

    if not surface.faces:
        return []
    shades = _brightness(surface.faces)[:, None] * to_rgb(colour)
    lit = np.concatenate([np.clip(shades, 0, 1), np.full((len(shades), 1), alpha)], axis=1)
    drawn = [Poly3DCollection(surface.faces, facecolors=lit, edgecolors="none", linewidths=0)]
    if edges:
        drawn.append(Line3DCollection(surface.edges, colors=colour, linewidths=0.8))
    for each in drawn:
        ax.add_collection3d(each)
    return drawn


def draw_skeleton(ax: Any, points: Array, *, alpha: float = 1.0, colour: str = style.ARM) -> list[Any]:
    """Draw the lines between joints (k, 3) and dots at all but the last; returns what was added."""
    return [
        *ax.plot(*points.T, color=colour, linewidth=1.4, alpha=alpha, solid_capstyle="round", zorder=LINES),
        *ax.plot(*points[:-1].T, "o", color=colour, markersize=2.5, alpha=alpha, zorder=LINES),
    ]


def write(ax: Any, at: Array, text: str, colour: str) -> None:
    """A name at a point (2,) or (3,), on a white rim so that it can be read over what it names."""
    from matplotlib.patheffects import withStroke

    rim = [withStroke(linewidth=2, foreground="white")]
    ax.text(*at, text, color=colour, fontsize=8, ha="center", va="bottom", zorder=NAMES, path_effects=rim)


def look_at(ax: Any, seen: Iterable[Array]) -> None:
    """Set the limits of 3D axes around points, with the same scale along all three."""
    from matplotlib.ticker import MaxNLocator

    low, high = box_around(seen)
    for axis, side in zip((ax.xaxis, ax.yaxis, ax.zaxis), high - low, strict=True):
        axis.set_major_locator(MaxNLocator(max(2, round(6 * side / (high - low).max()))))
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    ax.set_box_aspect(high - low, zoom=1.0)
    ax.view_init(elev=22, azim=-55)
    style.name_axes(ax)


def points_of(surfaces: Iterable[Surface]) -> list[Array]:
    """Corners of the surfaces that have faces."""
    return [surface.points for surface in surfaces if surface.faces]


def box_around(seen: Iterable[Array]) -> tuple[Array, Array]:
    """The lower and upper corner of what the axes show so that all points (k, 3) are seen."""
    points = np.concatenate(list(seen))
    low, high = points.min(axis=0), points.max(axis=0)
    longest = (high - low).max()
    spare = MARGIN * longest + np.maximum(LEAST * longest - (high - low), 0.0) / 2
    return low - spare, high + spare


def _brightness(faces: tuple[Array, ...]) -> Array:
    """How light each polygon is drawn, (k,), from how it faces the light on either side."""
    normals = np.array([np.cross(face[1] - face[0], face[2] - face[1]) for face in faces])
    long = np.linalg.norm(normals, axis=1)
    facing = np.abs(normals @ LIGHT) / np.maximum(long * np.linalg.norm(LIGHT), 1e-15)
    return np.asarray(0.72 + 0.28 * facing)
