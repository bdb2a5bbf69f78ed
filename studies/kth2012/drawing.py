"""Shared by the figures: arms, ellipses, the map of μ over θ_2 and θ_3, and writing files."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib import rc_context
from matplotlib.figure import Figure
from numpy.typing import ArrayLike, NDArray

import manipplan as mp
from manipplan.planar import PlanarArm, manipulability
from manipplan.viz.style import ARM, ELLIPSOID, JOINTS, OPTIMUM, SEED, STRAIGHT, STYLE, label_powers
from studies.kth2012 import config

Array = NDArray[np.float64]
DPI = 130  # of the rasterised parts
FORCE = JOINTS[3]
FEASIBLE = "#000000"
DEGREE_COLOURS = (STRAIGHT, *JOINTS[:5])
PI = {k: {0: "0", 1: "π", -1: "-π"}.get(k, f"{k}π") for k in range(-8, 9)}
LEVELS = np.arange(0.0, 2.71, 0.3)
__all__ = ["ARM", "ELLIPSOID", "FORCE", "JOINTS", "OPTIMUM", "SEED", "STRAIGHT", "STYLE", "rc_context"]


def blank(width: float, height: float) -> Figure:
    """A figure [inches]."""
    return Figure(figsize=(width, height), layout="constrained")


def save(figure: Figure, file: Path) -> None:
    """Write the figure as SVG, with the same bytes in every run."""
    label_powers(figure)
    with rc_context({"svg.hashsalt": file.stem, "svg.fonttype": "path"}):
        figure.savefig(file, dpi=DPI, metadata={"Date": None, "Creator": None})


def draw_arm(ax: Any, q: ArrayLike, arm: PlanarArm = config.ARM, *, colour: str = ARM, **options: Any) -> None:
    """Draw the links and joints."""
    points = arm.joint_positions(q)
    options = {"linewidth": 2.2, "markersize": 4.5, "alpha": 1.0, **options}
    ax.plot(*points.T, "-", color=colour, solid_capstyle="round", linewidth=options["linewidth"], alpha=options["alpha"])
    ax.plot(*points[:-1].T, "o", color=colour, markersize=options["markersize"], alpha=options["alpha"])


def draw_ellipse(
    ax: Any,
    ellipse: mp.measures.Ellipsoid,
    centre: Array,
    *,
    colour: str,
    scale: float = config.ELLIPSE_SCALE,
    axes: bool = False,
) -> None:
    """Draw a scaled ellipse; an infinite radius is cut off outside every figure."""
    radii = np.minimum(ellipse.radii * scale, 20.0)
    turn = np.linspace(0.0, 2 * np.pi, 181)
    ax.plot(*(centre[:, None] + ellipse.axes @ (radii[:, None] * [np.cos(turn), np.sin(turn)])), color=colour, linewidth=1.4)
    if axes:
        for axis, radius in zip(ellipse.axes.T, radii, strict=True):
            ax.plot(*(centre[:, None] + np.outer(axis, [-radius, radius])), color=colour, linewidth=0.9, linestyle="--")


def workspace_axes(ax: Any, reach: float = 3.2) -> None:
    """Axes with equal scales in metres."""
    ax.set(xlim=(-reach, reach), ylim=(-reach, reach), xlabel="x [m]", ylabel="y [m]")
    ax.set_aspect("equal")


def angle_axes(ax: Any, low: Sequence[float], high: Sequence[float], every: float = np.pi / 2) -> None:
    """Axes of θ_2 and θ_3 with marks at parts of π."""
    for name, first, last in zip("xy", low, high, strict=True):
        marks = np.arange(np.ceil(first / every - 1e-9), np.floor(last / every + 1e-9) + 1) * every
        getattr(ax, f"set_{name}ticks")(marks, [_part_of_pi(mark) for mark in marks])
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), xlabel="θ₂ [rad]", ylabel="θ₃ [rad]")
    ax.set_aspect("equal")
    ax.grid(visible=False)


def manipulability_map(ax: Any, low: Sequence[float], high: Sequence[float], points: int = 97, every: float = np.pi / 2) -> Any:
    """Filled contours of μ over θ_2 and θ_3 with crosses on singular postures."""
    second, third = np.linspace(low[0], high[0], points), np.linspace(low[1], high[1], points)
    q = np.stack(np.broadcast_arrays(0.0, second[None, :], third[:, None]), axis=-1)
    filled = ax.contourf(second, third, manipulability(config.ARM, q), LEVELS, cmap="cividis", alpha=0.75)
    filled.set_rasterized(True)  # its outlines alone would be a quarter of a megabyte
    singular(ax, low, high)
    angle_axes(ax, low, high, every)
    return filled


def singular(ax: Any, low: Sequence[float], high: Sequence[float]) -> None:
    """Crosses on singular postures."""
    columns, rows = (
        np.arange(np.ceil(a / np.pi - 1e-9), np.floor(b / np.pi + 1e-9) + 1) * np.pi for a, b in zip(low, high, strict=True)
    )
    for third in rows:
        ax.plot(columns, np.full(len(columns), third), "x", color="white", markersize=7, markeredgewidth=3.4, clip_on=False)
        ax.plot(columns, np.full(len(columns), third), "x", color="black", markersize=6, markeredgewidth=1.4, clip_on=False)


def marked(ax: Any, q: Array, label: str = "") -> None:
    """Optimal postures (k, 3) on the map."""
    style = {"color": "#D55E00", "markeredgecolor": "white", "markersize": 13, "linestyle": "", "zorder": 5}
    ax.plot(q[:, 1], q[:, 2], "*", label=label or None, **style)


def radius_map(low: Sequence[float], high: Sequence[float], points: int = 241) -> tuple[Array, Array, Array]:
    """θ_2, θ_3 and the tool's distance from the base [m]."""
    second, third = np.linspace(low[0], high[0], points), np.linspace(low[1], high[1], points)
    q = np.stack(np.broadcast_arrays(0.0, second[None, :], third[:, None]), axis=-1)
    return second, third, config.ARM.radius(q)


def _part_of_pi(angle: float) -> str:
    half = round(2 * angle / np.pi)
    if half % 2 == 0:
        return PI[half // 2]
    return {1: "π/2", -1: "-π/2"}.get(half, f"{half}π/2")
