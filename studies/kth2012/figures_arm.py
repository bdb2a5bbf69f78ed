"""Figures of chapters 2 and 4: the arm, its ellipses, and what the condition number does not show."""

from pathlib import Path
from typing import Any

import numpy as np

from manipplan.planar import force_ellipse, inverse_condition, manipulability, velocity_ellipse
from studies.kth2012.config import ARM as UNIT
from studies.kth2012.drawing import (
    ARM,
    ELLIPSOID,
    FORCE,
    OPTIMUM,
    SEED,
    STRAIGHT,
    STYLE,
    blank,
    draw_arm,
    draw_ellipse,
    rc_context,
    save,
)

POSTURE = np.array([0.6, 0.7, -1.3])


def schematic(file: Path) -> None:
    """Figure 2.1: the three-link arm and its symbols."""
    with rc_context(STYLE):
        figure = blank(5.2, 3.6)
        ax: Any = figure.subplots()
        q = np.array([0.45, 0.6, -0.75])
        points, phi = UNIT.joint_positions(q), np.cumsum(q)
        ax.axhline(0.0, color=STRAIGHT, linewidth=0.8)
        ax.axvline(0.0, color=STRAIGHT, linewidth=0.8)
        draw_arm(ax, q, linewidth=4.0, markersize=9)
        ax.plot(*points[-1], "s", color=OPTIMUM, markersize=8)
        for k, (joint, angle) in enumerate(zip(points[:-1], q, strict=True), start=1):
            before = phi[k - 1] - angle
            ax.plot(*(joint[:, None] + np.outer([np.cos(before), np.sin(before)], [0, 0.55])), ":", color=STRAIGHT)
            turn = np.linspace(before, before + angle, 30)
            ax.plot(*(joint[:, None] + 0.38 * np.array([np.cos(turn), np.sin(turn)])), color=SEED, linewidth=1.8)
            at = joint + 0.52 * np.array([np.cos(before + angle / 2), np.sin(before + angle / 2)])
            ax.text(*at, f"θ{'₁₂₃'[k - 1]}", ha="center", va="center", fontsize=12)
            side = (0.16 if k < 3 else -0.16) * np.array([-np.sin(phi[k - 1]), np.cos(phi[k - 1])])
            ax.text(*(points[k - 1 : k + 1].mean(axis=0) + side), f"l{'₁₂₃'[k - 1]}", ha="center", va="center", fontsize=12)
        ax.text(*(points[-1] + [0.1, 0.05]), "pₑ", fontsize=12, color=OPTIMUM)
        ax.set(xlabel="x [m]", ylabel="y [m]", xlim=(-0.3, 2.9), ylim=(-0.3, 1.95))
        ax.set_aspect("equal")
        ax.grid(visible=False)
        save(figure, file)


def ellipses(file: Path) -> None:
    """Figure 2.2: velocity and force ellipse of one posture."""
    with rc_context(STYLE):
        figure = blank(5.2, 3.9)
        ax: Any = figure.subplots()
        tool = UNIT.position(POSTURE)
        draw_arm(ax, POSTURE, linewidth=3.0)
        draw_ellipse(ax, velocity_ellipse(UNIT, POSTURE), tool, colour=OPTIMUM, axes=True)
        draw_ellipse(ax, force_ellipse(UNIT, POSTURE), tool, colour=ELLIPSOID)
        for colour, label in ((OPTIMUM, "velocity [3 m/s]"), (ELLIPSOID, "force [3 N]")):
            ax.plot([], [], color=colour, label=label)
        ax.legend(loc="upper left")
        ax.set(xlabel="x [m]", ylabel="y [m]")
        ax.set_aspect("equal")
        save(figure, file)


def rounder_and_larger() -> tuple[np.ndarray, np.ndarray]:
    """Two postures: one with a rounder ellipse, the other with an ellipse that contains the first one."""
    angles = np.linspace(-np.pi, np.pi, 181)
    q = np.stack(np.broadcast_arrays(0.0, angles[:, None], angles[None, :]), axis=-1).reshape(-1, 3)
    mu, kappa = manipulability(UNIT, q), inverse_condition(UNIT, q)
    shortest, longest = np.sqrt(mu * kappa), np.sqrt(mu / np.maximum(kappa, 1e-12))  # μ = σ_1 σ_2, κ = σ_2/σ_1
    small = int(np.where(longest <= 1.0 + 1e-9, kappa, 0.0).argmax())
    large = int(np.where(shortest >= longest[small], mu, 0.0).argmax())
    return q[small], q[large]


def condition_number(file: Path) -> None:
    """Figure 4.1: a rounder ellipse inside a better one."""
    small, large = rounder_and_larger()
    with rc_context(STYLE):
        figure = blank(8.4, 3.6)
        axes: Any = figure.subplots(1, 3)
        for ax, q, colour in zip(axes, (small, large), (FORCE, OPTIMUM), strict=False):
            draw_arm(ax, q, colour=ARM)
            draw_ellipse(ax, velocity_ellipse(UNIT, q), UNIT.position(q), colour=colour, axes=True)
            mu, kappa = float(manipulability(UNIT, q)), float(inverse_condition(UNIT, q))
            ax.set_title(f"κ = {kappa:.2f}, μ = {mu:.2f} m²", loc="left", fontsize=9)
            ax.set(xlim=(-0.8, 3.0), ylim=(-2.6, 1.2), xlabel="x [m]", ylabel="y [m]")
            ax.set_aspect("equal")
        for q, colour in ((small, FORCE), (large, OPTIMUM)):
            draw_ellipse(axes[2], velocity_ellipse(UNIT, q), np.zeros(2), colour=colour, scale=1.0)
        axes[2].set_title("both around one point", loc="left", fontsize=9)
        axes[2].set(xlabel="velocity in x [m/s]", ylabel="velocity in y [m/s]")
        axes[2].set_aspect("equal")
        save(figure, file)
