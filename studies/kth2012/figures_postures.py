"""Figures of chapter 5: joint space, workspace, and optimal postures."""

from pathlib import Path
from typing import Any

import numpy as np

from manipplan.planar import (
    Arc,
    force_ellipse,
    manipulability,
    reachable_annulus,
    stationary_kind,
    velocity_ellipse,
    workspace_boundary,
)
from studies.kth2012 import config
from studies.kth2012.config import ARM as UNIT
from studies.kth2012.config import QUARTER
from studies.kth2012.drawing import (
    FEASIBLE,
    FORCE,
    OPTIMUM,
    SEED,
    STYLE,
    blank,
    draw_arm,
    draw_ellipse,
    manipulability_map,
    marked,
    radius_map,
    rc_context,
    save,
    workspace_axes,
)
from studies.kth2012.results import Results

FULL = ((-np.pi, -np.pi), (np.pi, np.pi))
INSIDE = ((-QUARTER, -QUARTER), (QUARTER, QUARTER))
SHADE = "#A9CCE3"
KINDS = {"saddle": ("D", "#FFFFFF"), "minimum": ("x", "#000000")}


def spaces(file: Path, *, limited: bool) -> None:
    """Figures 5.1 and 5.6: joint space and workspace."""
    low, high = (-QUARTER, QUARTER) if limited else (0.0, 2 * np.pi)
    marks, names = ([-QUARTER, 0, QUARTER], ["-π/2", "0", "π/2"]) if limited else ([0, np.pi, 2 * np.pi], ["0", "π", "2π"])
    with rc_context(STYLE):
        figure = blank(8.0, 3.7)
        cube: Any = figure.add_subplot(1, 2, 1, projection="3d")
        corners = np.array([[x, y, z] for x in (low, high) for y in (low, high) for z in (low, high)])
        for a in corners:
            for b in corners:
                if np.count_nonzero(a != b) == 1 and a.sum() < b.sum():
                    cube.plot(*np.stack([a, b]).T, color=OPTIMUM, linewidth=1.4)
        for axis, name in zip("xyz", "₁₂₃", strict=True):
            getattr(cube, f"set_{axis}ticks")(marks, names)
            getattr(cube, f"set_{axis}label")(f"θ{name} [rad]")
        cube.set_title("joint space", fontsize=9)
        cube.set_box_aspect(None, zoom=0.85)
        flat: Any = figure.add_subplot(1, 2, 2)
        if limited:
            arcs = workspace_boundary(UNIT, -QUARTER, QUARTER)
            for outline in outlines(arcs):
                flat.fill(*outline.T, facecolor=SHADE)
            for arc in arcs:
                flat.plot(*arc(np.linspace(0.0, 1.0, 100)).T, color=OPTIMUM)
        else:
            turn, ring = np.linspace(0.0, 2 * np.pi, 361), reachable_annulus(UNIT)
            flat.fill(ring.outer * np.cos(turn), ring.outer * np.sin(turn), facecolor=SHADE, edgecolor=OPTIMUM, linewidth=1.6)
        workspace_axes(flat, 3.3)
        flat.plot(0, 0, "o", color="black", markersize=4)
        flat.set_title("workspace", fontsize=9)
        save(figure, file)


def outlines(arcs: tuple[Arc, ...]) -> list[np.ndarray]:
    """Closed outlines (m, 2) from arcs whose ends meet."""
    left = [arc(np.linspace(0.0, 1.0, 100)) for arc in arcs]
    loops = []
    while left:
        loop = left.pop(0)
        while left:
            gaps = [(np.hypot(*(each[end] - loop[-1])), k, end) for k, each in enumerate(left) for end in (0, -1)]
            gap, k, end = min(gaps)
            if gap > 1e-3:
                break
            piece = left.pop(k)
            loop = np.concatenate([loop, piece if end == 0 else piece[::-1]])
        loops.append(loop)
    return loops


def whole_map(results: Results, file: Path) -> None:
    """Figure 5.2: μ, with all stationary postures."""
    with rc_context(STYLE):
        figure = blank(5.6, 4.6)
        ax: Any = figure.subplots()
        filled = manipulability_map(ax, *FULL)
        figure.colorbar(filled, ax=ax, label="μ [m²]")
        q = results.free.q
        kinds = np.array([stationary_kind(UNIT, each) for each in q])
        for kind, (mark, colour) in KINDS.items():
            rows = q[kinds == kind]
            if mark == "x":
                ax.plot([], [], mark, color=colour, linestyle="", label="minimum, μ = 0")
            else:
                ax.plot(rows[:, 1], rows[:, 2], mark, color=colour, markeredgecolor="black", linestyle="", label=kind)
        marked(ax, results.free.best.q, "maximum")
        figure.legend(loc="outside lower center", ncols=3, fontsize=8)
        save(figure, file)


def by_radius(results: Results, file: Path) -> None:
    """Figure 5.3: the largest μ over the distance of the tool."""
    with rc_context(STYLE):
        figure = blank(5.6, 3.4)
        ax: Any = figure.subplots()
        for limited, colour, dash, label in ((False, OPTIMUM, "-", "free"), (True, SEED, "--", "|θᵢ| ≤ π/2")):
            radii = np.linspace(1.0 if limited else 0.0, 3.0, 41 if limited else 61)
            best = [results.at_radius(round(float(each), 6), limited=limited).manipulability[0] for each in radii]
            ax.plot(radii, best, dash, color=colour, label=label)
        best = results.free.best
        ax.plot(best.radius[0], best.manipulability[0], "*", color="#D55E00", markersize=13, markeredgecolor="white")
        ax.annotate(
            f"R = {best.radius[0]:.4f} m",
            (best.radius[0], best.manipulability[0]),
            (0, 7),
            textcoords="offset points",
            ha="center",
        )
        ax.set(xlabel="radius R [m]", ylabel="largest μ [m²]", xlim=(0, 3.05), ylim=(0, 3.0))
        ax.legend(loc="lower center")
        save(figure, file)


def feasible(results: Results, file: Path) -> None:
    """Figure 5.4: the feasible set at the optimal radius."""
    with rc_context(STYLE):
        figure = blank(8.4, 3.9)
        left, right = figure.subplots(1, 2)
        filled = manipulability_map(left, *FULL)
        figure.colorbar(filled, ax=left, label="μ [m²]")
        for ax in (left, right):
            ax.contour(*radius_map(*FULL), [config.FIGURE_5_4_RADIUS], colors=FEASIBLE, linewidths=1.6)
        best = results.at_radius(config.FIGURE_5_4_RADIUS, limited=False).best
        marked(left, best.q)
        right.set(xlabel="θ₂ [rad]", ylabel="θ₃ [rad]", xticks=left.get_xticks(), yticks=left.get_yticks())
        right.set_xticklabels([each.get_text() for each in left.get_xticklabels()])
        right.set_yticklabels([each.get_text() for each in left.get_yticklabels()])
        right.set(xlim=left.get_xlim(), ylim=left.get_ylim())
        right.set_aspect("equal")
        left.set_title("a) with μ", loc="left", fontsize=9)
        right.set_title(f"b) ‖f‖ = {config.FIGURE_5_4_RADIUS} m alone", loc="left", fontsize=9)
        save(figure, file)


def at_radii(results: Results, file: Path) -> None:
    """Figure 5.5: velocity ellipses of the optimal postures for several radii, with their mirror images."""
    with rc_context(STYLE):
        figure = blank(9.6, 2.9)
        axes: Any = figure.subplots(1, len(config.FIGURE_5_5_RADII), sharey=True)
        for ax, radius in zip(axes, config.FIGURE_5_5_RADII, strict=True):
            best = results.at_radius(radius, limited=False).best
            q = best.q[best.q[:, 1].argmax()].copy()
            for sign, colour in ((1, OPTIMUM), (-1, SEED)):
                posture = _towards(sign * q, 0.0)
                draw_arm(ax, posture, colour=colour, alpha=0.75, linewidth=1.8, markersize=3.5)
                draw_ellipse(ax, velocity_ellipse(UNIT, posture), UNIT.position(posture), colour=colour)
            ax.set_title(f"R = {radius:g} m, μ = {best.manipulability[0]:.2f} m²", loc="left", fontsize=8.5)
            ax.set(xlim=(-1.2, 3.6), ylim=(-1.7, 1.7), xlabel="x [m]")
            ax.set_aspect("equal")
        axes[0].set_ylabel("y [m]")
        save(figure, file)


def _towards(q: np.ndarray, direction: float) -> np.ndarray:
    """A posture turned so that its tool lies in a given direction from the base; unchanged if the tool is at the base."""
    x, y = UNIT.position(q)
    turned = q.copy()
    if np.hypot(x, y) > 1e-9:
        turned[0] += direction - np.arctan2(y, x)
    return turned


def limited_map(results: Results, file: Path) -> None:
    """Figure 5.7: μ inside the angle limits."""
    with rc_context(STYLE):
        figure = blank(4.9, 3.9)
        ax: Any = figure.subplots()
        figure.colorbar(manipulability_map(ax, *INSIDE), ax=ax, label="μ [m²]")
        marked(ax, results.free.best.q)
        save(figure, file)


def limited_feasible(results: Results, file: Path) -> None:
    """Figure 5.8: feasible sets for two radii inside the limits."""
    with rc_context(STYLE):
        figure = blank(8.4, 3.7)
        axes: Any = figure.subplots(1, 2)
        for ax, radius in zip(axes, config.FIGURE_5_8_RADII, strict=True):
            filled = manipulability_map(ax, *INSIDE)
            ax.contour(*radius_map(*INSIDE), [radius], colors=FEASIBLE, linewidths=1.8)
            marked(ax, results.at_radius(radius, limited=True).best.q)
            ax.set_title(f"R = {radius:g} m", loc="left", fontsize=9)
        figure.colorbar(filled, ax=axes, label="μ [m²]")
        save(figure, file)


def both_ellipses(results: Results, file: Path) -> None:
    """Figure 5.9: velocity and force ellipses of the postures of Table 5.2."""
    with rc_context(STYLE):
        figure = blank(9.6, 5.6)
        axes: Any = figure.subplots(2, 3, sharex=True, sharey=True)
        for ax, radius in zip(axes.ravel(), config.TABLE_5_2, strict=True):
            best = results.at_radius(radius, limited=True).best
            q = _towards(best.q[best.q[:, 1].argmax()], 0.0)
            draw_arm(ax, q)
            draw_ellipse(ax, velocity_ellipse(UNIT, q), UNIT.position(q), colour=OPTIMUM)
            draw_ellipse(ax, force_ellipse(UNIT, q), UNIT.position(q), colour=FORCE)
            mu, kappa = float(manipulability(UNIT, q)), float(best.inverse_condition[0])
            ax.set_title(f"R = {radius:g} m, μ = {mu:.2f} m², κ = {kappa:.2f}", loc="left", fontsize=9)
            ax.set(xlim=(-0.6, 4.3), ylim=(-1.6, 1.6))
            ax.set_aspect("equal")
        for ax in axes[1]:
            ax.set_xlabel("x [m]")
        for ax in axes[:, 0]:
            ax.set_ylabel("y [m]")
        axes[0, 0].plot([], [], color=OPTIMUM, label="velocity [3 m/s]")
        axes[0, 0].plot([], [], color=FORCE, label="force [3 N]")
        axes[0, 0].legend(loc="upper left", fontsize=8)
        save(figure, file)
