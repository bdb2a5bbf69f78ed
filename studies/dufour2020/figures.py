"""The figures, after those of the paper, in the library's style."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pinocchio as pin
from matplotlib import rc_context
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullFormatter

import manipplan as mp
from manipplan.viz.render import DrawnWay, Renderer
from manipplan.viz.style import JOINTS, STRAIGHT, STYLE, label_powers
from studies.dufour2020 import config
from studies.dufour2020.courses import Array
from studies.dufour2020.follow import Arm, Run
from studies.dufour2020.pareto import SPACES, SWEEPS, Fronts, Priced, front, own_best
from studies.dufour2020.scenarios import Comparison, Obstacle, Scenario
from studies.tables import Table

DPI = 110
MARKS = {"(7)": "s", "(10)": "o", "(14)": "^", "LogDrive": "D"}
COLOURS = {"(7)": "#E69F00", "(10)": "#0072B2", "(14)": "#D55E00", "LogDrive": "#009E73"}
DASHES = ("-", "--", "-.", ":")


def name_of(run: Run) -> str:
    """A run for a legend."""
    symbol = {"(7)": "k₀", "LogDrive": "β"}.get(run.formula, "α")
    if run.strength == 0:
        return "(2), no manipulability" if run.formula == "(7)" else f"{run.formula}, α = 0"
    return f"{run.formula.removesuffix(' as it is')}, {symbol} = {run.strength:g}"


def save(figure: Figure, file: Path) -> None:
    """Write it as PNG."""
    label_powers(figure)
    figure.savefig(file, dpi=DPI, metadata={"Software": None})


def blank(width: float, height: float) -> Figure:
    """A figure [inches]."""
    return Figure(figsize=(width, height), layout="constrained")


def manipulability_axes(ax: Any, runs: Sequence[Run], colours: Sequence[str]) -> None:
    """Normalised manipulability over time."""
    for run, colour, dash in zip(runs, colours, _dashes(len(runs)), strict=True):
        part = slice(0, run.steps + 1)
        ax.plot(run.t[part], run.manipulability[part], color=colour, linestyle=dash, label=name_of(run))
    ax.set(xlabel="time [s]", ylabel="normalised manipulability m / m_max", ylim=(0, 1))


def path_axes(ax: Any, runs: Sequence[Run], colours: Sequence[str]) -> None:
    """Path of the tool in space: reference and result."""
    wanted = runs[0].targets[:, :3, 3]
    ax.plot(*wanted.T, color="black", linewidth=3, alpha=0.35, label="reference")
    for run, colour, dash in zip(runs, colours, _dashes(len(runs)), strict=True):
        ax.plot(*run.poses[:, :3, 3].T, color=colour, linestyle=dash, linewidth=1.4, label=name_of(run))
    ax.scatter(*wanted[0], color="black", s=18)
    spans = np.concatenate([wanted, *(run.poses[:, :3, 3] for run in runs)])
    middle, half = (spans.max(axis=0) + spans.min(axis=0)) / 2, np.ptp(spans, axis=0).max() / 2
    for label, centre, axis in zip("xyz", middle, (ax.set_xlim, ax.set_ylim, ax.set_zlim), strict=True):
        axis(centre - half, centre + half)
        getattr(ax, f"set_{label}label")(f"{label} [m]", labelpad=2)
    ax.locator_params(nbins=4)
    ax.tick_params(pad=0, labelsize=8)


def scenario(found: Scenario, file: Path) -> None:
    """Fig. 3 or 4: manipulability over time, and path of the tool."""
    with rc_context(STYLE):
        figure = blank(10.5, 4.2)
        parts: Any = figure.subfigures(1, 2, width_ratios=(1.2, 1))
        left, right = parts
        colours = [STRAIGHT, COLOURS["(7)"], "#56B4E9", "#0072B2", "#000000"]
        runs = [run for run in (found.plain, found.classical, *found.relaxed) if run is not None]
        ax = left.subplots()
        manipulability_axes(ax, runs, colours)
        ax.legend(loc="lower right", fontsize=8)
        ax.set_title("a) manipulability", loc="left")
        space = right.add_subplot(projection="3d")
        path_axes(space, found.relaxed, colours[2:])
        space.set_title("b) path of the tool; the dot is its start", loc="left")
        space.legend(loc="upper left", fontsize=8)
        save(figure, file)


def stiffness(file: Path) -> None:
    """Fig. 1: the stiffness of the task along the path."""
    share = np.linspace(0.0, 1.0, 401)
    with rc_context(STYLE):
        figure = blank(6.0, 3.0)
        ax = figure.subplots()
        ax.plot(share, [config.STIFFNESS(float(each)) for each in share], color=COLOURS["(10)"])
        for value, label in ((config.STIFFNESS.high, "Q_high"), (config.STIFFNESS.low, "Q_low")):
            ax.axhline(value, color="black", linestyle=":", linewidth=0.9)
            ax.text(0.5, 1.15 * value, label, ha="center", va="bottom", fontsize=8)
        ax.set(xlabel="share of the duration t / t_f", ylabel="stiffness of the task", yscale="log", ylim=(5, 4e4), xlim=(0, 1))
        ax.set_yticks((10, 100, 1000, 10_000), ("10", "100", "1000", "10000"))
        save(figure, file)


def postures(arm: Arm, first: Scenario, second: Scenario, sphere: Obstacle, file: Path) -> None:
    """Fig. 2, 5 and 7: the arm at the ends of scenario 1, at the end of S2 by (7) and by (10), and next to the sphere."""
    place = mp.Scene([config.SPHERE])
    shown = [
        ("S1, start", first.plain, 0, mp.Scene([])),
        ("S1, end, (10)", first.at_alpha, -1, mp.Scene([])),
        ("S2, end, (7)", second.classical or second.plain, -1, mp.Scene([])),
        ("S2, end, (10)", second.at_alpha, -1, mp.Scene([])),
        ("S3, end, α = 0", sphere.runs[0], -1, place),
        ("S3, end, α = 15000", sphere.runs[1], -1, place),
    ]
    with rc_context(STYLE):
        figure = blank(10.5, 7.4)
        axes = figure.subplots(2, 3).ravel()
        for ax, (title, run, k, scene) in zip(axes, shown, strict=True):
            way = run.targets[:: max(len(run.targets) // 60, 1), :3, 3]
            chain = np.array([place.translation for place in _placements(arm, run.q[k])])
            points = np.concatenate([way, chain, [[0.0, 0.0, -0.3], [0.4, 0.3, 1.2]]])
            with Renderer(arm.robot, scene, points, (520, 540), direction=(150.0, -15.0)) as renderer:
                ax.imshow(renderer.draw(run.q[k], [DrawnWay(points=way, colour="#D55E00")]))
            ax.set_title(f"{title}, m = {run.manipulability[k]:.2f}", loc="left", fontsize=9)
            ax.set_axis_off()
        save(figure, file)


def _placements(arm: Arm, q: Array) -> list[Any]:
    model = arm.robot.model
    data = model.createData()
    pin.forwardKinematics(model, data, q)
    return list(data.oMi)


def times(series: dict[str, Array], dt: float, file: Path) -> None:
    """Fig. 6: computation time of every step."""
    with rc_context(STYLE):
        figure = blank(8, 3.2)
        ax = figure.subplots()
        for (label, values), colour in zip(series.items(), JOINTS, strict=False):
            ax.plot(dt * np.arange(1, len(values) + 1), 1e6 * values, color=colour, linewidth=0.9, label=label)
        ax.axhline(1e6 * dt, color="black", linestyle="--", linewidth=1)
        ax.text(0.02, 1e6 * dt * 0.8, "sampling time T = 10 ms", va="top", fontsize=8)
        ax.set(xlabel="time [s]", ylabel="time of one step [µs]", yscale="log", ylim=(1, 2e4))
        ax.legend(loc="upper right", ncols=2, fontsize=8, bbox_to_anchor=(1, 0.88))
        save(figure, file)


def obstacle(found: Obstacle, seconds: Sequence[Array], file: Path) -> None:
    """Fig. 8: distance, manipulability, computation time."""
    with rc_context(STYLE):
        figure = blank(11.5, 3.4)
        near, middle, took = figure.subplots(1, 3)
        colours = ("#E69F00", "#0072B2")
        for run, colour, dash in zip(found.runs, colours, DASHES, strict=False):
            near.plot(run.t[:-1], 1e3 * run.rollout["clearance"], color=colour, linestyle=dash, label=f"α = {run.strength:g}")
        near_end = found.runs[0].t[-1]
        for value, label in ((config.INFLUENCE, "d_i"), (config.SECURITY, "d_s")):
            near.axhline(1e3 * value, color="black", linewidth=0.9, linestyle=":")
            near.text(near_end, 1e3 * value + 2, label, va="bottom", ha="right")
        near.set(
            xlabel="time [s]",
            ylabel="minimum distance [mm]",
            ylim=(0, 1.05e3 * max(run.rollout["clearance"].max() for run in found.runs)),
        )
        near.set_title("a) robot to sphere", loc="left")
        near.legend(loc="upper right", fontsize=8)
        manipulability_axes(middle, found.runs, colours)
        middle.set_title("b) manipulability", loc="left")
        for values, run, colour in zip(seconds, found.runs, colours, strict=True):
            took.plot(config.DT * np.arange(1, len(values) + 1), 1e6 * values, color=colour, linewidth=0.9, label=name_of(run))
        took.axhline(1e6 * config.DT, color="black", linestyle="--", linewidth=1)
        took.set(xlabel="time [s]", ylabel="time of one step [µs]", yscale="log", ylim=(1, 2e4))
        took.set_title("c) computation; dashed: T", loc="left")
        middle.legend(loc="lower right", fontsize=8)
        save(figure, file)


def comparison(found: Comparison, file: Path) -> None:
    """Fig. 9 for all five paths: (10) at the paper's α of each path against (14) at the one α."""
    with rc_context(STYLE):
        figure = blank(11.5, 5.6)
        axes = figure.subplots(2, 3).ravel()
        for ax, name in zip(axes, config.TABLE_1, strict=False):
            pair = (found.papers[name], found.one[name], found.most[name])
            manipulability_axes(ax, pair, ("#0072B2", "#D55E00", STRAIGHT))
            ax.set_title(name, loc="left")
            ax.legend(loc="lower right", fontsize=7.5)
        last = axes[5]
        for name, colour in zip(config.TABLE_1, JOINTS, strict=False):
            for runs, dash in ((found.objective[name], "-"), (found.equality[name], "--")):
                sound = [run for run in runs if run.sound]
                last.plot([run.strength for run in sound], [run.mean for run in sound], color=colour, linestyle=dash)
            last.plot([], [], color=colour, label=name)
        last.set(xscale="log", xlabel="α", ylabel="mean normalised manipulability", ylim=(0.25, 1))
        last.set_title("sound runs: (10) solid, (14) dashed", loc="left")
        last.legend(fontsize=7.5, ncols=3, loc="upper left")
        save(figure, file)


def convexity(table: Table, file: Path) -> None:
    """Claim 1: shares of steps against α."""
    alphas, inner, whole, _, raw, equal, chatter, other, _ = zip(*table.rows, strict=True)
    with rc_context(STYLE):
        figure = blank(10.5, 3.6)
        left, right = figure.subplots(1, 2)
        for values, label, colour, mark in (
            (inner, "(10): Q - αT²H indefinite", "#56B4E9", "v"),
            (raw, "(10) as it is: not solved", "#0072B2", "o"),
            (whole, "(10): whole cost indefinite, made convex", "#000000", "s"),
            (equal, "(14): not solved", "#D55E00", "^"),
        ):
            left.plot(alphas, values, color=colour, marker=mark, markersize=4, label=label)
        left.set(xscale="log", xlabel="α", ylabel="share of the steps [%]", ylim=(-3, 100))
        left.legend(fontsize=8, loc="upper left")
        left.set_title("a) convexity", loc="left")
        right.plot(alphas, chatter, color="#0072B2", marker="o", markersize=4, label="(10), made convex")
        right.plot(alphas, other, color="#D55E00", marker="^", markersize=4, label="(14)")
        right.set(xscale="log", xlabel="α", ylabel="chatter: share of joints and steps [%]")
        right.legend(fontsize=8, loc="upper left")
        right.set_title("b) large accelerations that change sign in one step", loc="left")
        save(figure, file)


def hessians(runs: dict[tuple[str, str, float], Run], file: Path) -> None:
    """(10) with each method for the Hessian, on scenario 2."""
    names = [hessian for path, hessian, alpha in runs if path == "S2" and alpha == config.ALPHA]
    labels = {
        "bfgs": "BFGS, direct and damped",
        "bfgs-literal": "(20), made convex",
        "sr1": "SR1",
        "central": "differences (19)",
    }
    with rc_context(STYLE):
        figure = blank(10.5, 3.6)
        left, right = figure.subplots(1, 2)
        for name, colour, dash in zip(names, JOINTS, ("-", "--", ":", "-.", "-"), strict=False):
            run = runs["S2", name, config.ALPHA]
            label, width = labels.get(name, name), 3.0 if name == "exact" else 1.5
            part = slice(0, run.steps + 1)
            left.plot(run.t[part], run.manipulability[part], color=colour, linestyle=dash, linewidth=width, label=label)
            right.plot(run.t, 1e3 * run.deviation, color=colour, linestyle=dash, linewidth=width, label=label)
        left.set(xlabel="time [s]", ylabel="normalised manipulability m / m_max", ylim=(0, 1))
        right.set(xlabel="time [s]", ylabel="deviation [mm]")
        left.set_title(f"S2, α = {config.ALPHA:g}: manipulability", loc="left")
        right.set_title("deviation", loc="left")
        left.legend(fontsize=8, ncols=2)
        save(figure, file)


def pareto(found: Fronts, name: str, file: Path) -> None:
    """Deviation against mean and minimum manipulability, without a tube and inside three."""
    with rc_context(STYLE):
        figure = blank(11.5, 5.2)
        axes = figure.subplots(2, len(SPACES), sharey="row", sharex="col")
        for column, tube in enumerate(SPACES):
            for formula in SWEEPS:
                runs = found.get((name, tube, formula), [])
                for row, figure_of in enumerate(("mean", "least")):
                    _front(axes[row][column], runs, figure_of, formula)
            head = "no tube" if tube is None else f"tube {1e3 * tube:g} mm"
            axes[0][column].set_title(head, loc="left")
            axes[1][column].set_xlabel("largest deviation [mm]")
            if tube is None:
                axes[1][column].set_xscale("log")
                axes[1][column].set_xlim(3e-3, 2e3)
                axes[1][column].xaxis.set_major_locator(LogLocator(numticks=7))
                axes[1][column].xaxis.set_minor_formatter(NullFormatter())
            else:
                axes[1][column].set_xlim(-0.04e3 * tube, 1.25e3 * tube)
        axes[0][0].set_ylabel("mean m / m_max")
        axes[1][0].set_ylabel("minimum m / m_max")
        handles, labels = axes[0][0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside upper right", ncols=len(labels), fontsize=8)
        figure.suptitle(f"{name}; hollow: chatter, or (7) off its path", x=0.01, ha="left", fontsize=10)
        save(figure, file)


def price(found: dict[tuple[str, str], list[Priced]], file: Path) -> None:
    """Mean manipulability against deviation and against torque: Pareto fronts of the sound runs without a tube."""
    with rc_context(STYLE):
        figure = blank(11.5, 5.4)
        axes = figure.subplots(2, len(config.TABLE_1), sharey="col")
        for column, name in enumerate(config.TABLE_1):
            for formula in SWEEPS:
                runs, colour = found[name, formula], COLOURS[formula]
                for ax, price_of in zip(
                    axes[:, column], (lambda each: 1e3 * each.run.worst, lambda each: each.torque), strict=True
                ):
                    chosen = front(runs, price_of)
                    x, y = [price_of(each) for each in chosen], [each.run.mean for each in chosen]
                    ax.plot(x, y, color=colour, marker=MARKS[formula], markersize=3, linewidth=1.2, label=formula)
                    own = own_best(runs)
                    if own is not None:
                        at = (price_of(own), own.run.mean)
                        ax.scatter(*at, facecolors="none", edgecolors=colour, marker=MARKS[formula], s=90, linewidths=1.4)
            axes[0][column].set(title=name, xscale="log", xlim=(3e-3, 2e3), xlabel="largest deviation [mm]")
            axes[0][column].xaxis.set_major_locator(LogLocator(numticks=4))
            axes[0][column].xaxis.set_minor_formatter(NullFormatter())
            axes[1][column].set_xlabel("rms torque [N m]")
        for ax in axes[:, 0]:
            ax.set_ylabel("mean m / m_max")
        handles, labels = axes[0][0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside upper right", ncols=len(labels), fontsize=8)
        figure.suptitle(
            "Pareto fronts without a tube; large marks: best parameter of each path", x=0.01, ha="left", fontsize=10
        )
        save(figure, file)


def _front(ax: Any, runs: Sequence[Run], figure_of: str, formula: str) -> None:
    kept = [run for run in runs if run.reached and not run.unsolved and run.worst > 0]
    x, y = [1e3 * run.worst for run in kept], [getattr(run, figure_of) for run in kept]
    colour, mark = COLOURS[formula], MARKS[formula]
    faces = [colour if run.sound else "white" for run in kept]
    ax.plot(x, y, color=colour, linewidth=0.8, alpha=0.6)
    ax.scatter(x, y, c=faces, edgecolors=colour, marker=mark, s=16, linewidths=0.9, zorder=3)
    ax.plot([], [], color=colour, marker=mark, markersize=4, label=formula)


def _dashes(count: int) -> list[Any]:
    kinds: list[Any] = ["-", "--", "-.", ":", (0, (5, 1, 1, 1, 1, 1))]
    return kinds[:count]
