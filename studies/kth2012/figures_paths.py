"""Figures of chapter 6: paths on the map and in the workspace."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

import manipplan as mp
from manipplan.planar import inverse_condition, manipulability
from studies.kth2012 import config
from studies.kth2012.config import ARM as UNIT
from studies.kth2012.config import THIRD, Example
from studies.kth2012.drawing import (
    DEGREE_COLOURS,
    OPTIMUM,
    STRAIGHT,
    STYLE,
    blank,
    draw_arm,
    manipulability_map,
    rc_context,
    save,
    workspace_axes,
)
from studies.kth2012.results import Results

S = np.linspace(0.0, 1.0, 201)


def window(curves: Sequence[np.ndarray], margin: float = 0.5) -> tuple[tuple[float, float], tuple[float, float]]:
    """Corners of a square that contains the curves (m, 3) on the map."""
    points = np.concatenate(curves)[:, 1:]
    low, high = points.min(axis=0), points.max(axis=0)
    half, middle = (high - low).max() / 2 + margin, (low + high) / 2
    return tuple(middle - half), tuple(middle + half)  # type: ignore[return-value]  # two numbers each


def by_degree(results: Results, example: Example, file: Path) -> None:
    """Figures 6.1 and 6.2: the paths of degree 1 to 6."""
    paths = [results.path(example, degree).path for degree in config.DEGREES]
    _paths(paths, [f"degree {degree}" for degree in config.DEGREES], DEGREE_COLOURS, file)


def line_and_optimum(results: Results, file: Path) -> None:
    """Figure 6.3: the line and the path of degree 6."""
    paths = [results.path(THIRD, degree).path for degree in (1, config.BEST_DEGREE)]
    _paths(paths, ["line", "degree 6"], (STRAIGHT, OPTIMUM), file)


def _paths(paths: list[mp.JointPath], labels: list[str], colours: Sequence[str], file: Path) -> None:
    curves = [path(S) for path in paths]
    with rc_context(STYLE):
        figure = blank(9.4, 4.5)
        left, right = figure.subplots(1, 2)
        figure.colorbar(manipulability_map(left, *window(curves)), ax=left, label="μ [m²]")
        for k, (q, label, colour) in enumerate(zip(curves, labels, colours, strict=True)):
            dash = "--" if k == 0 else "-"
            left.plot(q[:, 1], q[:, 2], color="white", linewidth=2.8)
            left.plot(q[:, 1], q[:, 2], dash, color=colour, label=label)
            right.plot(*UNIT.position(q).T, dash, color=colour)
        for share in (0.0, 1.0):
            draw_arm(right, curves[-1][round(share * (len(S) - 1))], alpha=0.45)
        start, goal = curves[0][0], curves[0][-1]
        for ax, points in ((left, (start[1:], goal[1:])), (right, (UNIT.position(start), UNIT.position(goal)))):
            for point, name, face in zip(points, ("start", "goal"), ("white", "black"), strict=True):
                ax.plot(*point, "o", color=face, markeredgecolor="black", markersize=6, zorder=6)
                ax.annotate(
                    name,
                    point,
                    (6, 6),
                    textcoords="offset points",
                    fontsize=8,
                    bbox={"facecolor": "white", "alpha": 0.7, "edgecolor": "none", "pad": 1},
                )
        workspace_axes(right)
        left.set_title("a) θ₂ and θ₃", loc="left", fontsize=9)
        right.set_title("b) the tool", loc="left", fontsize=9)
        figure.legend(*left.get_legend_handles_labels(), loc="outside lower center", ncols=6, fontsize=8)
        save(figure, file)


def along(results: Results, file: Path) -> None:
    """Figure 6.4: μ and κ along the line and the optimum, over the share of the path length."""
    with rc_context(STYLE):
        figure = blank(8.4, 3.3)
        axes: Any = figure.subplots(1, 2)
        for degree, colour, dash, label in ((1, STRAIGHT, "--", "line"), (config.BEST_DEGREE, OPTIMUM, "-", "degree 6")):
            q = results.path(THIRD, degree).path(S)
            share = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(q, axis=0), axis=1))])
            for ax, measure in zip(axes, (manipulability, inverse_condition), strict=True):
                ax.plot(share / share[-1], measure(UNIT, q), dash, color=colour, label=label)
        for ax, name in zip(axes, ("μ [m²]", "κ"), strict=True):
            ax.set(xlabel="share of the path length", ylabel=name, ylim=(0, None), xlim=(0, 1))
        axes[0].legend(loc="lower right")
        save(figure, file)
