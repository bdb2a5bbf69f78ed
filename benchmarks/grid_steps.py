"""The search of guilamo2006 and ours, as the grid is refined towards the optimum of the continuum.

Run with `make benchmark`. Writes docs/benchmarks/grid_steps.md and docs/pictures/grid_steps.png. A circle of 20 cm with 50
positions in front of TALOS, as in the study, of a Panda and of a UR5 on a rail of 2 m. Both searches get the same candidates.
The optimum of the continuum is that of `mp.refine` from the finest grid, whose upper bound stands beside it.
"""

import argparse
import os
import platform
import tempfile
import time
import xml.etree.ElementTree as ET
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import sys

import numpy as np
from matplotlib import rc_context
from matplotlib.figure import Figure
from rich.progress import track

import manipplan as mp
from manipplan.viz.style import STYLE, label_powers

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT))
from studies.guilamo2006 import config, courses, search  # noqa: E402

OUT = ROOT / "docs" / "benchmarks" / "grid_steps.md"
PICTURE = ROOT / "docs" / "pictures" / "grid_steps.png"
#: Bound on each joint's step between neighbouring positions [degrees; the rail: the same number of radians, in metres].
EPSILON = 5.0
#: Number of grid points of an arm with one redundant joint.
SAMPLES = tuple((12 * 2**k,) for k in range(9))
#: Number of branches after which the paper's search is stopped.
MOST_BRANCHES = 300_000
#: Length of the rail [m], and centre of the circle of the other arms [m].
RAIL, CENTRE = 2.0, (0.5, 0.0, 0.4)
COLOUR, OTHER = "#0072B2", "#D55E00"


@dataclass(frozen=True, kw_only=True)
class Case:
    """A circle, the grids of the held joints, and their ranges [rad or m]."""

    name: str
    robot: mp.Robot
    path: mp.CartesianPath
    grids: tuple[tuple[int, ...], ...]
    spans: tuple[float, ...]
    unit: str

    def step(self, grid: tuple[int, ...]) -> float:
        """The largest step of the grid [degrees or mm]."""
        widest = max(span / (count - 1) for span, count in zip(self.spans, grid, strict=True))
        return 1e3 * widest if self.unit == "mm" else float(np.rad2deg(widest))


@dataclass(frozen=True, kw_only=True)
class Row:
    """Both searches on one grid; minima are nan where the search finds no path or is stopped."""

    grid: tuple[int, ...]
    step: float
    candidates: int
    bound: float
    exact: float
    seconds: float
    paper: search.Found


@dataclass(frozen=True, kw_only=True)
class Curve:
    """The rows of a case, and the refined path of the finest grid."""

    case: Case
    rows: tuple[Row, ...]
    refined: float
    bound: float


def on_rail(folder: Path) -> mp.Robot:
    """A UR5 whose base slides sideways, without bodies."""
    tree = ET.parse(mp.load_robot("ur5").source.file)
    root = tree.getroot()
    for link in root.findall("link"):
        for body in [*link.findall("visual"), *link.findall("collision")]:
            link.remove(body)
    held = {joint.find("child").get("link") for joint in root.findall("joint")}
    [base] = [link.get("name") for link in root.findall("link") if link.get("name") not in held]
    ET.SubElement(root, "link", name="rail")
    joint = ET.SubElement(root, "joint", name="rail_joint", type="prismatic")
    ET.SubElement(joint, "parent", link="rail")
    ET.SubElement(joint, "child", link=base)
    ET.SubElement(joint, "axis", xyz="0 1 0")
    ET.SubElement(joint, "limit", lower=f"{-RAIL / 2}", upper=f"{RAIL / 2}", velocity="1", effort="1000")
    file = folder / "ur5_on_rail.urdf"
    tree.write(file)
    robot = mp.Robot.from_urdf(file, tool="tool0")
    half = np.array([RAIL / 2, *[np.pi] * 6])
    return robot.with_limits(lower=-half, upper=half)


def cases(folder: Path) -> list[Case]:
    """The three circles."""
    talos = courses.courses()[0]
    even = tuple(grid for grid in config.FULL_GRIDS if grid != config.UNEVEN)
    top = np.diag([1.0, -1.0, -1.0, 1.0])
    top[:3, 3] = np.add(CENTRE, (0.0, 0.0, config.DIAMETER / 2))
    circle = mp.CartesianPath.circle(top, CENTRE, (1.0, 0.0, 0.0))
    found = [one_joint("Panda", mp.load_robot("panda"), circle), one_joint("UR5 on a rail", on_rail(folder), circle)]
    limits = talos.robot.limits
    spans = tuple((limits.upper - limits.lower)[: len(even[0])])
    return [Case(name="TALOS", robot=talos.robot, path=talos.path, grids=even, spans=spans, unit="°"), *found]


def one_joint(name: str, robot: mp.Robot, path: mp.CartesianPath) -> Case:
    """A case with one held joint."""
    [held] = mp.inverse_kinematics(robot, path(0.0), task=config.TASK, samples=2).parameter_names
    k = robot.joint_names.index(held)
    span = float(robot.limits.upper[k] - robot.limits.lower[k])
    unit = "mm" if held == "rail_joint" else "°"
    return Case(name=name, robot=robot, path=path, grids=SAMPLES, spans=(span,), unit=unit)


def curve(case: Case, epsilon: float = EPSILON, most: int = MOST_BRANCHES) -> Curve:
    """Both searches on all grids, and the refined path."""
    rows, bound = [], np.radians(epsilon)
    for grid in track(case.grids, case.name):
        layers = mp.sample_layers(
            case.robot, case.path, config.CIRCLE_POSITIONS, task=config.TASK, samples=grid, collisions=False
        )
        began = time.process_time()
        found = mp.max_min_search(layers, bound, throw=False)
        seconds = time.process_time() - began
        paper = search.search(layers, bound, memoised=False, most_branches=most)
        rows.append(
            Row(
                grid=grid,
                step=case.step(grid),
                candidates=layers.count,
                bound=layers.bound,
                exact=found.minimum if found.connected else np.nan,
                seconds=seconds,
                paper=paper,
            )
        )
    refinement = mp.refine(layers, found)
    return Curve(case=case, rows=tuple(rows), refined=refinement.refined, bound=refinement.bound)


def table(curves: Sequence[Curve]) -> list[str]:
    """The table of all grids, and that of the continuum."""
    lines = [
        "| arm | samples per position | widest step | candidates | bound | ours | below the continuum | CPU time of ours "
        "| the paper's search | starts | branches |",
        "|---" * 11 + "|",
    ]
    for each in curves:
        for row in each.rows:
            paper = f"{row.paper.minimum:.5f}" if row.paper.end == "found" else row.paper.end
            counts = f"{row.paper.new_starts} | {row.paper.branches}"
            ours = (
                "not connected | " if np.isnan(row.exact) else f"{row.exact:.5f} | {100 * (1 - row.exact / each.refined):.2f} %"
            )
            lines.append(
                f"| {each.case.name} | {np.prod(row.grid)} | {row.step:.3g} {each.case.unit} | {row.candidates} "
                f"| {row.bound:.5f} | {ours} | {1e3 * row.seconds:.0f} ms | {paper} | {counts} |"
            )
    lines += ["", "| arm | refined from the finest grid | upper bound | refined below it |", "|---|---|---|---|"]
    lines += [
        f"| {each.case.name} | {each.refined:.6f} | {each.bound:.6f} | {100 * (1 - each.refined / each.bound):.3f} % |"
        for each in curves
    ]
    return lines


def draw(curves: Sequence[Curve], file: Path) -> None:
    """Minimum manipulability against the widest step of the grid."""
    with rc_context(STYLE):
        figure = Figure(figsize=(10.5, 3.6), layout="constrained")
        axes = figure.subplots(1, len(curves))
        for ax, each in zip(axes, curves, strict=True):
            steps = [row.step for row in each.rows]
            ax.axhline(each.refined, color="black", linewidth=1.0, linestyle="--", label="continuum, refined")
            ax.plot(steps, [row.bound for row in each.rows], color="#999999", linestyle=":", label="bound of the samples")
            ax.plot(steps, [row.exact for row in each.rows], color=COLOUR, marker="o", markersize=4, label="ours")
            ended = [row for row in each.rows if row.paper.end == "found"]
            ax.scatter(
                [row.step for row in ended],
                [row.paper.minimum for row in ended],
                s=70,
                facecolors="none",
                edgecolors=OTHER,
                linewidths=1.4,
                zorder=3,
                label="the paper's, where it ends",
            )
            ax.set(xscale="log", title=each.case.name, xlabel=f"widest step of the grid [{each.case.unit}]")
            ax.invert_xaxis()
        axes[0].set_ylabel("minimum manipulability")
        handles, labels = axes[0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside upper center", ncols=len(labels))
        label_powers(figure)
        figure.savefig(file, dpi=110, metadata={"Software": None})


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=OUT, help="the table's file")
    parser.add_argument("--picture", type=Path, default=PICTURE, help="file of the picture")
    options = parser.parse_args(arguments)
    with tempfile.TemporaryDirectory() as folder:
        curves = [curve(case) for case in cases(Path(folder))]
    about = (
        f"ε = {EPSILON:g}°, without collision checks; the paper's search is stopped after {MOST_BRANCHES:,} branches. "
        f"CPU times; Python {platform.python_version()}, {platform.machine()}; command: `make benchmark`."
    )
    lines = [*table(curves), "", about]
    options.out.write_text("\n".join(lines) + "\n")
    draw(curves, options.picture)
    print("\n".join(lines))


if __name__ == "__main__":
    main()
