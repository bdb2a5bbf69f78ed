"""The figures, after those of the paper, in the library's style."""

from pathlib import Path
from typing import Any

import numpy as np
from matplotlib import rc_context
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from manipplan.viz.style import JOINTS, OPTIMUM, SEED, STRAIGHT, STYLE, label_powers
from studies.guilamo2006 import config, tables
from studies.guilamo2006.bodies import Bodies
from studies.guilamo2006.courses import Array
from studies.guilamo2006.results import Results
from studies.guilamo2006.runs import Sampled, Searched

DPI = 110
REFINED, BOUND, PAPERS = "#009E73", "#000000", "#CC79A7"
BODY, MOVING, EDGE = "#E9E9E9", "#A9CCE3", "#7A7A7A"
AXES = "xyz"
FRONT, SIDE, TOP = (1, 2), (0, 2), (1, 0)
MARKS = "os^Dv<>"
#: Range of each axis that is shown [m].
SPANS = {0: (-0.45, 1.15), 1: (-0.65, 0.6), 2: (-0.45, 0.75)}


def all_figures(results: Results, out: Path) -> None:
    """Write all figures."""
    circle, line = results.courses
    views = (("front", FRONT), ("side", SIDE), ("top", TOP))
    postures(results.best(circle), results.refined(circle).refinement.q, views, out / "circle.png")
    postures(results.best(line), results.refined(line).refinement.q, (("front", FRONT), ("top", TOP)), out / "line.png")
    curves(results, out / "index.png")
    layered(results, out / "search.png")
    sampling(results, out / "sampling.png")
    joints(results, out / "joints.png")


def save(figure: Figure, file: Path) -> None:
    """Write the figure as PNG."""
    label_powers(figure)
    figure.savefig(file, dpi=DPI, metadata={"Software": None})


def blank(width: float, height: float) -> Figure:
    """A figure [inches]."""
    return Figure(figsize=(width, height), layout="constrained")


def postures(searched: Searched, q: Array, views: tuple[tuple[str, tuple[int, int]], ...], file: Path) -> None:
    """Fig. 2, 4 and 6 to 8: four postures of the refined path (L, n) in some views, with the path of the tool."""
    course = searched.sampled.course
    bodies = Bodies(robot=course.robot)
    # a circle ends where it begins
    last = len(q) - 1 if course.name == "line" else len(q) * 3 // 4
    places = np.linspace(0, last, config.POSTURES).round().astype(int)
    path = course.path(np.linspace(0.0, 1.0, 200))[:, :3, 3]
    with rc_context(STYLE):
        figure = blank(11, sum(4.2 if view is TOP else 2.8 for _, view in views))
        heights = [np.ptp(SPANS[view[1]]) for _, view in views]
        axes: Any = figure.subplots(len(views), config.POSTURES, sharex="row", sharey="row", height_ratios=heights)
        for row, (name, view) in zip(axes, views, strict=True):
            for ax, k in zip(row, places, strict=True):
                for moves, outline in bodies.outlines(q[k], view):
                    ax.fill(*outline.T, facecolor=MOVING if moves else BODY, edgecolor=EDGE, linewidth=0.5)
                ax.plot(*bodies.chain(q[k], view).T, "o-", color="#333333", linewidth=1.6, markersize=3)
                ax.plot(*path[:, view].T, color=SEED, linewidth=2)
                ax.plot(*path[round(k / (len(q) - 1) * 199), view], "o", color="#D55E00", markersize=6)
                ax.set_aspect("equal")
                ax.grid(visible=False)
                ax.set_xlabel(f"{AXES[view[0]]} [m]")
            row[0].set_ylabel(f"{name} view\n{AXES[view[1]]} [m]")
            row[0].set(xlim=SPANS[view[0]], ylim=SPANS[view[1]])
            if view is TOP:
                row[0].invert_xaxis()  # from above, with x upwards, y points to the left
        for ax, k in zip(axes[0], places, strict=True):
            ax.set_title(f"position {k}, m = {course.kinematics.manipulability(q[k]):.3f}", loc="left", fontsize=9)
        save(figure, file)


def curves(results: Results, file: Path) -> None:
    """Fig. 3 and 5: manipulability along circle and line."""
    with rc_context(STYLE):
        figure = blank(11, 4.2)
        axes: Any = figure.subplots(1, 2)
        for ax, course in zip(axes, results.courses, strict=True):
            best, first = results.best(course), results.best(course, prefer="first")
            layers = best.sampled.layers
            places = np.arange(len(layers.m))
            top = max(float(m.max()) for m in layers.m)
            edges = np.linspace(0, 1.05 * top, 90)
            density = np.array([np.histogram(m, edges)[0] / len(m) for m in layers.m]).T
            ax.pcolormesh(np.arange(len(places) + 1) - 0.5, edges, np.sqrt(density), cmap="Greys", vmax=0.6, rasterized=True)
            bound = [m.max() for m in layers.m]
            refined = results.refined(course).refinement.manipulability
            ax.plot(places, bound, ":", color=BOUND, label="largest candidate of each position")
            ax.plot(places, first.found.manipulability, "--", color=SEED, linewidth=1.2, label="first optimum found")
            restarted = results.restarted(course, memoised=True)
            if restarted.ended:
                ax.plot(places, restarted.found.manipulability, "-.", color=PAPERS, linewidth=1.2, label="the paper's search")
            elif results.wide.ended:
                label = f"the paper's search, ε = {results.wide.epsilon:g}°"
                [wide] = ax.plot(places, results.wide.found.manipulability, "-.", color=PAPERS, linewidth=1.2, label=label)
                ax.legend(handles=[wide], loc="lower left", fontsize=8, frameon=True)
            ax.plot(places, best.found.manipulability, color=OPTIMUM, label="shortest of the same minimum manipulability")
            ax.plot(places, refined, color=REFINED, linewidth=2, label="refined")
            ax.axhline(best.found.minimum, color=OPTIMUM, linewidth=0.7)
            ax.xaxis.set_major_locator(MaxNLocator(integer=True))
            low = min(best.found.minimum, refined.min())
            ax.set(xlabel="position", ylabel=f"manipulability m [{course.kinematics.task.unit}]".replace("m^3", "m³"))
            ax.set(ylim=(0.55 * low, 1.05 * top), xlim=(-0.5, len(places) - 0.5))
            ax.set_title(
                f"{course.name}, ε = {best.epsilon:g}°, minimum {best.found.minimum:.4f}, refined {refined.min():.4f}",
                loc="left",
                fontsize=9,
            )
        axes[1].legend(loc="lower left", fontsize=8, frameon=True)
        save(figure, file)


def layered(results: Results, file: Path) -> None:
    """How the search works: the candidates of each position, ordered by manipulability, and the path among them."""
    with rc_context(STYLE):
        figure = blank(11, 4.4)
        axes: Any = figure.subplots(1, 2)
        for ax, course in zip(axes, results.courses, strict=True):
            best = results.best(course, config.COARSE)
            mesh = _ranked(ax, best.sampled, best)
            figure.colorbar(mesh, ax=ax, label="manipulability m [m³]")
            ax.set_title(
                f"{course.name}, {best.sampled.layers.count} candidates, ε = {best.epsilon:g}°", loc="left", fontsize=9
            )
        axes[0].legend(loc="upper right", fontsize=8, frameon=True)
        save(figure, file)


def _ranked(ax: Any, sampled: Sampled, best: Searched) -> Any:
    layers = sampled.layers
    height = int(layers.sizes.max())
    image = np.full((height, len(layers.m)), np.nan)
    ranks, left = [], []
    for k, (m, chosen) in enumerate(zip(layers.m, best.found.indices, strict=True)):
        image[: len(m), k] = np.sort(m)[::-1]
        ranks.append(int(np.count_nonzero(m > m[chosen])) + 1)
        left.append(int(np.count_nonzero(m >= best.found.minimum)))
    edges = np.arange(len(ranks) + 1) - 0.5
    mesh = ax.pcolormesh(edges, np.arange(height + 1) + 0.5, image, cmap="cividis", rasterized=True)
    ax.step(np.append(edges[:-1], edges[-1]), np.append(left, left[-1]), where="post", color="white", linewidth=2.2)
    ax.step(
        np.append(edges[:-1], edges[-1]),
        np.append(left, left[-1]),
        where="post",
        color="#D55E00",
        linewidth=1.2,
        label="candidates not below the optimum",
    )
    ax.plot(ranks, "o-", color="white", markeredgecolor="black", markersize=3.5, linewidth=1, label="the path's rank")
    ax.set(xlabel="position", ylabel="candidate, by falling manipulability", yscale="log", ylim=(0.8, height))
    ax.xaxis.set_major_locator(MaxNLocator(integer=True))
    ax.grid(visible=False)
    return mesh


def sampling(results: Results, file: Path) -> None:
    """Section VI: optimum, smallest ε and the paper's search over ε and grid."""
    runs, circle = results.runs, results.courses[0]
    with rc_context(STYLE):
        figure = blank(11.5, 4.0)
        optimum, smallest, work = figure.subplots(1, 3)
        for grid, colour, mark in zip(results.grids, JOINTS, MARKS, strict=False):
            if grid == config.UNEVEN:
                continue
            sampled = runs.sampled(circle, grid)
            found = [runs.searched(sampled, each, "first").found for each in config.EPSILONS if each > runs.smallest(sampled)]
            x = [float(np.rad2deg(each.epsilon[0])) for each in found]
            optimum.plot(
                x, [each.minimum for each in found], color=colour, marker=mark, markersize=4, label=tables.grid_name(grid)
            )
            optimum.axhline(sampled.layers.bound, color=colour, linewidth=0.7, linestyle=":")
        best = results.refined(circle).refinement.refined
        optimum.axhline(best, color=REFINED, linewidth=1.2)
        optimum.text(config.EPSILONS[-1], best, "refined", va="bottom", ha="right", fontsize=8, color=REFINED)
        optimum.set(xlabel="ε [°]", ylabel="minimum manipulability of the optimum [m³]", xscale="log")
        _degrees(optimum)
        optimum.legend(fontsize=7.5, loc="lower right")
        optimum.set_title("a) circle; dotted: bound of the samples", loc="left", fontsize=9)
        for course, colour, mark in zip(results.courses, (OPTIMUM, SEED), "os", strict=True):
            pairs = [(runs.sampled(course, grid).widest, runs.smallest(runs.sampled(course, grid))) for grid in results.grids]
            smallest.scatter(*zip(*pairs, strict=True), color=colour, marker=mark, s=22, label=course.name)
        ends = [0.8 * min(runs.sampled(circle, grid).widest for grid in results.grids), 12.0]
        smallest.plot(ends, ends, color=STRAIGHT, linewidth=1, label="ε = step of the grid")
        smallest.set(
            xlabel="widest step of the grid [°]", ylabel="smallest ε that connects [°]", ylim=(0, None), xlim=(0, None)
        )
        smallest.legend(fontsize=8, loc="upper left")
        smallest.set_title("b) connectivity", loc="left", fontsize=9)
        grids = list(dict.fromkeys(run.sampled.grid for run in results.branching))
        for grid in grids:
            k = results.grids.index(grid)
            runs_of = [run for run in results.branching if run.sampled.grid == grid]
            x, y = [run.epsilon for run in runs_of], [run.factor for run in runs_of]
            work.plot(x, y, color=JOINTS[k], linewidth=1.2, label=tables.grid_name(grid))
            faces = [JOINTS[k] if run.ended else "white" for run in runs_of]
            work.scatter(x, y, c=faces, edgecolors=JOINTS[k], marker=MARKS[k], s=24, zorder=3)
        work.axhline(
            config.PAPER_CIRCLE["branches"] / config.PAPER_CIRCLE["starts"], color=STRAIGHT, linestyle="--", linewidth=1
        )
        work.text(config.EPSILONS[-1], 4.2, "paper", ha="right", va="bottom", fontsize=8)
        work.set(xlabel="ε [°]", ylabel="branches per new start", xscale="log", yscale="log")
        _degrees(work)
        work.legend(fontsize=7.5, loc="upper left")
        work.set_title("c) the paper's search, memoised; hollow: stopped", loc="left", fontsize=9)
        save(figure, file)


def _degrees(ax: Any) -> None:
    ax.set_xticks(config.EPSILONS, [f"{each:g}" for each in config.EPSILONS])
    ax.minorticks_off()
    ax.set_xlim(0.9 * config.EPSILONS[0], 1.1 * config.EPSILONS[-1])


def joints(results: Results, file: Path) -> None:
    """Joint angles along the circle: optimum of the coarse and the finest grid, and refined."""
    circle = results.courses[0]
    coarse, best = results.best(circle, config.COARSE), results.best(circle)
    parts = [(f"{tables.grid_name(coarse.sampled.grid)}, ε = {coarse.epsilon:g}°", coarse.found.q)]
    if best is not coarse:
        parts.append((f"{tables.grid_name(best.sampled.grid)}, ε = {best.epsilon:g}°", best.found.q))
    parts.append(("refined", results.refined(circle).refinement.q))
    names = [
        name.removesuffix("_joint").replace("arm_right_", "arm ").replace("torso_", "torso ")
        for name in circle.robot.joint_names
    ]
    with rc_context(STYLE):
        figure = blank(11, 3.8)
        axes: Any = figure.subplots(1, len(parts), sharey=True)
        for ax, (title, q) in zip(axes, parts, strict=True):
            for values, colour, name in zip(np.rad2deg(q).T, JOINTS, names, strict=True):
                ax.plot(values, color=colour, label=name)
            ax.set(xlabel="position")
            ax.set_title(title, loc="left", fontsize=9)
        axes[0].set_ylabel("joint angle [°]")
        figure.legend(*axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=9, fontsize=8)
        save(figure, file)
