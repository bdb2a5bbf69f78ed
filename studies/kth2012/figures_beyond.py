"""Figures on the questions that the thesis leaves open."""

from pathlib import Path
from typing import Any

import numpy as np

from manipplan.planar import PlanarArm, velocity_ellipse
from manipplan.viz.style import OBSTACLE
from studies.kth2012 import classes, config, eikonal
from studies.kth2012.config import ARM as UNIT
from studies.kth2012.config import EXAMPLES, FIRST
from studies.kth2012.drawing import (
    JOINTS,
    OPTIMUM,
    STRAIGHT,
    STYLE,
    blank,
    draw_arm,
    draw_ellipse,
    manipulability_map,
    rc_context,
    save,
    workspace_axes,
)
from studies.kth2012.figures_paths import S, window
from studies.kth2012.results import Results
from studies.kth2012.tables_beyond import gap, links

EVERY = 40  # every 40th point of a geodesic is drawn


def class_map(results: Results, file: Path) -> None:
    """The best path of every class."""
    with rc_context(STYLE):
        figure = blank(9.6, 4.9)
        axes: Any = figure.subplots(1, 3)
        for ax, example in zip(axes, EXAMPLES, strict=True):
            found = sorted((each for each in results.classes if each.example is example), key=lambda each: each.found.g)
            low, high = window([each.found.q for each in found], 0.4)
            filled = manipulability_map(ax, low, high, every=np.pi)
            for each, colour in zip(found, JOINTS, strict=False):
                q = each.found.q[::EVERY]
                ax.plot(q[:, 1], q[:, 2], color="white", linewidth=2.6)
                label = f"{classes.arrows(each.walk)}  g = {each.found.g:.3f}"
                ax.plot(q[:, 1], q[:, 2], color=colour, label=label)
            ax.plot(*example.start[1:], "o", color="white", markeredgecolor="black", zorder=6)
            ax.plot(*example.goal[1:], "o", color="black", markeredgecolor="black", zorder=6)
            ax.set_title(example.name, loc="left", fontsize=9)
            ax.legend(loc="upper center", bbox_to_anchor=(0.5, -0.2), fontsize=9)
        figure.colorbar(filled, ax=axes, label="μ [m²]", shrink=0.6)
        save(figure, file)


def turned(results: Results, file: Path) -> None:
    """The first example: the best path to its goal, and to the goal that differs by a full turn of θ_2."""
    plain, best = (results.best_crossing(FIRST, shifted=each).found.q[::EVERY] for each in (False, True))
    with rc_context(STYLE):
        figure = blank(9.4, 4.4)
        left, right = figure.subplots(1, 2)
        low, high = window([plain, best])
        figure.colorbar(manipulability_map(left, low, high, every=np.pi), ax=left, label="μ [m²]")
        for q, colour, label in ((plain, STRAIGHT, "goal (6.10)"), (best, OPTIMUM, "goal with θ₂ less a full turn")):
            left.plot(q[:, 1], q[:, 2], color="white", linewidth=2.8)
            left.plot(q[:, 1], q[:, 2], color=colour, label=label)
            left.plot(*q[-1, 1:], "o", color="black", zorder=6)
            right.plot(*UNIT.position(q).T, color=colour, label=label)
        left.plot(*plain[0, 1:], "o", color="white", markeredgecolor="black", zorder=6)
        draw_arm(right, plain[0], alpha=0.45)
        draw_arm(right, plain[-1], alpha=0.9)
        workspace_axes(right)
        figure.legend(*left.get_legend_handles_labels(), loc="outside lower center", ncols=2, fontsize=8)
        save(figure, file)


def convergence(results: Results, file: Path) -> None:
    """How far polynomials are from the geodesic."""
    with rc_context(STYLE):
        figure = blank(6.2, 3.8)
        ax: Any = figure.subplots()
        degrees = range(1, config.MOST_DEGREE + 1)
        for example, colour, mark in zip(EXAMPLES, JOINTS, "os^", strict=False):
            for power, dash in ((config.TABLE_POWER, "-"), (config.TEXT_POWER, ":")):
                values = [max(gap(results, example, power, degree), 1e-11) for degree in degrees]
                label = f"{example.name}, p = {power:g}"
                ax.plot(degrees, values, dash, marker=mark, markersize=4, color=colour, label=label)
        ax.set(xlabel="degree", ylabel="g of the polynomial less that of the geodesic", yscale="log")
        ax.legend(fontsize=8)
        save(figure, file)


def march(results: Results, file: Path) -> None:
    """V of the first example over (θ₂, θ₃) at the goal's θ₁, and the two best paths, for both exponents."""
    with rc_context(STYLE):
        figure = blank(9.6, 4.4)
        axes: Any = figure.subplots(1, 2, sharey=True)
        for ax, power in zip(axes, (config.TABLE_POWER, config.TEXT_POWER), strict=True):
            goals = [np.array(FIRST.goal), results.shifted_goal(FIRST)]
            field = eikonal.solve(UNIT, FIRST.start, goals, power, config.SHIFT_STEP)
            level = round((FIRST.goal[0] - field.low[0]) / field.step)
            values = field.values[level]
            second, third = (field.low[k] + field.step * np.arange(values.shape[k - 1]) for k in (1, 2))
            top = 2 * float(field(goals[0])[0])
            filled = ax.contourf(second, third, values.T, levels=np.linspace(0, top, 25), cmap="viridis_r", extend="max")
            filled.set_rasterized(True)
            for shifted, colour in ((False, STRAIGHT), (True, OPTIMUM)):
                path = results.global_optimum(FIRST, power, shifted=shifted).path
                q = path.q[::EVERY]
                ax.plot(q[:, 1], q[:, 2], color="white", linewidth=2.8)
                ax.plot(q[:, 1], q[:, 2], color=colour, label=f"g = {path.g:.4f}")
                ax.plot(*q[-1, 1:], "o", color="black", zorder=6)
            ax.plot(*FIRST.start[1:], "o", color="white", markeredgecolor="black", zorder=6)
            ax.set(xlabel="θ₂ [rad]", title=f"p = {power:g}")
            ax.legend(loc="lower right", fontsize=8, frameon=True)
            figure.colorbar(filled, ax=ax, label="V at θ₁ = π")
        axes[0].set_ylabel("θ₃ [rad]")
        save(figure, file)


def obstacles(results: Results, file: Path) -> None:
    """Paths among posts: the arm at 13 places, and the path of the tool."""
    with rc_context(STYLE):
        figure = blank(9.6, 3.3)
        axes: Any = figure.subplots(1, len(config.POSTS), sharey=True)
        for ax, (example, posts) in zip(axes, config.POSTS, strict=True):
            found, free = results.among(example, posts), results.path(example, config.OBSTACLE_DEGREE)
            for s in np.linspace(0.0, 1.0, 13):
                draw_arm(ax, found.path(s), alpha=0.25 + 0.6 * (s in (0.0, 1.0)), linewidth=1.4, markersize=2)
            ax.plot(*UNIT.position(free.path(S)).T, "--", color=STRAIGHT, label="no posts")
            ax.plot(*UNIT.position(found.path(S)).T, color=OPTIMUM, label="among posts")
            turn = np.linspace(0.0, 2 * np.pi, 60)
            for x, y in posts:
                ax.fill(x + config.POST_RADIUS * np.cos(turn), y + config.POST_RADIUS * np.sin(turn), color=OBSTACLE)
            ax.set_title(f"{example.name}, g = {found.g:.3f}", loc="left", fontsize=9)
            workspace_axes(ax, 3.1)
        for ax in axes[1:]:
            ax.set_ylabel("")
        figure.legend(*axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=2, fontsize=8)
        save(figure, file)


def more_links(results: Results, file: Path) -> None:
    """Optimal postures of more links, drawn with the same total length."""
    with rc_context(STYLE):
        figure = blank(9.6, 2.7)
        found = links(results)
        axes: Any = figure.subplots(1, len(found), sharey=True)
        for ax, each in zip(axes, found, strict=True):
            n = each.arm.n
            same = PlanarArm(np.full(n, 1.0 / n))
            q = each.q.copy()
            x, y = same.position(q)
            q[0] -= np.arctan2(y, x)
            draw_arm(ax, q, same)
            draw_ellipse(ax, velocity_ellipse(same, q), same.position(q), colour=OPTIMUM)
            ax.set_title(f"n = {n}, μ = {each.manipulability / n**2:.3f} L²", loc="left", fontsize=9)
            ax.set(xlim=(-0.1, 1.05), ylim=(-0.75, 0.55), xlabel="x / L")
            ax.set_aspect("equal")
        axes[0].set_ylabel("y / L")
        save(figure, file)
