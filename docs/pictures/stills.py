"""Draws the thumbnails of the gallery: an arm at one moment, the way of its tool, and an ellipsoid; or one plot.

Run: python docs/pictures/stills.py [plan/cell ...]. Each page is run first, and gives what is drawn. Writes JPEG files into
this folder. Needs the extra `film`.
"""

import io
import runpy
import sys
from contextlib import redirect_stdout
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import matplotlib as mpl

mpl.use("agg")
import matplotlib.pyplot as plt
import numpy as np
from PIL import Image

import manipplan as mp
from manipplan.measures.ellipsoid import velocity_ellipsoid
from manipplan.support.checks import Array
from manipplan.viz.motions import drawn_tools, ellipsoid_scale, skeleton
from manipplan.viz.render import DrawnWay, Renderer
from manipplan.viz.style import OPTIMUM, SEED

HERE = Path(__file__).parent
EXAMPLES = HERE.parent / "examples"
SIZE, QUALITY = (720, 480), 82
#: Pixels per inch of a plot.
DPI = 150
#: Samples of a path, distance of the points by which a way is drawn [m], and postures that have to be in the picture.
SAMPLES, STEP, POSTURES = 2000, 0.02, 12
#: Around the joints and the ways, in each direction [m].
MARGIN = 0.09


@dataclass(frozen=True)
class Still:
    """One picture; texts are expressions of names of the page."""

    path: str = "plan.path"
    robot: str = "robot"
    scene: str = "scene"
    #: The share of the path at which the arm is shown.
    at: float = 0.5
    #: Another path, whose way is drawn beside it.
    other: str = ""
    #: Whether the velocity ellipsoid is drawn; it would hide what the hand carries.
    ellipsoid: bool = True
    #: Azimuth and elevation in which the camera looks [°].
    direction: tuple[float, float] = (140.0, -20.0)


@dataclass(frozen=True)
class Panel:
    """One of the plots of a page, without the words that are too small in a thumbnail."""

    axes: str


#: What each page shows.
PROGRAM = Still(path="program.parts[1].path", robot="program.parts[1].robot", scene="program.parts[1].scene", ellipsoid=False)
STILLS: dict[str, Still | Panel] = {
    "plan/rivals": Panel("left"),
    "plan/power_and_degree": Panel("left"),
    "measure/workspace_map": Panel("middle"),
    "measure/planar_postures": Panel("left"),
    "deploy/export_c": Panel("left"),
    "first_steps/first_plan": Still(at=0.55, other="plan.result.seed"),
    "first_steps/own_robot": Still(at=0.3, other="plan.result.seed"),
    "first_steps/trajectory_files": Still(path="path", scene="mp.Scene()", at=0.3),
    "plan/shelf": Still(at=0.5, other="plan.result.seed", direction=(50.0, -20.0)),
    "plan/cell": Still(robot="carrying", scene="free", at=0.8, ellipsoid=False),
    "plan/pick_and_place": replace(PROGRAM, at=0.6),
    "plan/eight_moves": replace(PROGRAM, at=0.6),
    "plan/level_cup": Still(
        path="plans['level'].path", other="plans['free'].path", at=0.6, ellipsoid=False, direction=(235.0, -25.0)
    ),
    "plan/tray": Still(ellipsoid=False),
    "plan/singular": Still(path="best.path", scene="mp.Scene()", at=1.0),
    "plan/home": Still(at=0.85, other="plan.result.seed", direction=(60.0, -20.0)),
    "follow/all_solutions": Still(path="mp.JointPath.through(branch)", robot="panda", scene="mp.Scene()", at=0.0),
    "follow/weld_seam": Still(scene="mp.Scene()"),
    "follow/talos_circle": Still(path="mp.JointPath.through(refined.q)", scene="mp.Scene()", at=0.3),
    "follow/interruptions": Still(scene="mp.Scene()", at=0.6),
    "follow/no_motion": Still(path="less.path", scene="mp.Scene()"),
    "track/tracking": Still(path="trajectory.path()", scene="mp.Scene()"),
    "track/improve_recording": Still(scene="mp.Scene()", other="recorded.path()"),
    "track/avoidance": Still(
        path="mp.JointPath.through(postures)",
        scene="mp.Scene([mp.Sphere(radius=ball.radius, position=balls[200])])",
        at=1 / 6,
        ellipsoid=False,
    ),
    "track/servo_mujoco": Still(path="mp.JointPath.through(runs['mp.Servo']['q'][::25])", scene="mp.Scene()", at=0.5),
    "track/lerobot": Still(path="mp.JointPath.through([each['goal'] for each in log])", scene="mp.Scene()", at=0.6),
    "measure/own_measure": Still(path="ours.path", scene="mp.Scene()", other="theirs.path"),
    "deploy/certificate": Still(at=0.4),
    "deploy/mujoco_playback": Still(robot="robot", scene="problem.scene", at=0.7, other="plan.result.seed"),
}


def run(page: str) -> dict[str, Any]:
    """The names in a page of the gallery after it ran."""
    folder, name = page.split("/")
    with redirect_stdout(io.StringIO()):
        names = runpy.run_path(str(EXAMPLES / folder / f"plot_{name}.py"))
    plt.close("all")
    return names


def picture(still: Still | Panel, names: dict[str, Any]) -> Image.Image:
    """What a page shows."""
    return panel(names[still.axes]) if isinstance(still, Panel) else rendered(still, names)


def panel(axes: plt.Axes) -> Image.Image:
    """One plot of a figure, as large as it fits, with thicker lines and without words."""
    figure = axes.figure
    for other in figure.axes:
        if other is not axes:
            other.remove()
    if legend := axes.get_legend():
        legend.remove()
    axes.set(title="", xlabel="", ylabel="")
    for title in ("left", "right"):
        axes.set_title("", loc=title)
    axes.tick_params(bottom=False, left=False, labelbottom=False, labelleft=False)
    if axes.get_aspect() != "auto":
        axes.set_aspect(axes.get_aspect(), adjustable="datalim")
    for line in axes.lines:
        line.set(linewidth=2.0 * line.get_linewidth(), markersize=1.5 * line.get_markersize())
    figure.set_size_inches(SIZE[0] / DPI, SIZE[1] / DPI)
    figure.set_layout_engine("none")
    axes.set_position((0.01, 0.015, 0.98, 0.97))
    stream = io.BytesIO()
    figure.savefig(stream, dpi=DPI)
    return Image.open(stream).convert("RGB")


def rendered(still: Still, names: dict[str, Any]) -> Image.Image:
    """An arm of a page."""
    names = {"mp": mp, **names}
    robot, scene, path = (eval(text, names) for text in (still.robot, still.scene, still.path))
    paths = [(path, OPTIMUM, still.at)]
    if still.other:
        paths.append((eval(still.other, names), SEED, 0.0))
    s = np.linspace(0.0, 1.0, SAMPLES)
    ways, shown = [], []
    tools = drawn_tools(robot)
    for each, colour, at in paths:
        q = each(s)
        shown += [skeleton(robot, posture) for posture in q[:: SAMPLES // POSTURES]]
        ways += [way(tool.pose(q)[:, :3, 3], colour, at) for tool in tools]
    shown += [each.points for each in ways]
    q = path(still.at)
    scale = ellipsoid_scale(robot, tools, path(s[:: SAMPLES // POSTURES]))
    ellipsoids = [(velocity_ellipsoid(tool.jacobian(q)), tool.pose(q)[:3, 3], scale, OPTIMUM) for tool in tools]
    points = np.concatenate([part + side for part in shown for side in (-MARGIN, MARGIN)])
    with Renderer(robot, scene, points, SIZE, direction=still.direction) as renderer:
        return Image.fromarray(renderer.draw(q, ways, ellipsoids if still.ellipsoid else []))


def way(points: Array, colour: str, at: float) -> DrawnWay:
    """A way through points (k, 3) [m], thick up to a share of them, by points at a constant distance."""
    gone = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    places = np.searchsorted(gone, np.linspace(0.0, gone[-1], 2 + int(gone[-1] / STEP)))
    done = gone[round(at * (len(points) - 1))] / max(gone[-1], 1e-9)
    return DrawnWay(points=points[places.clip(max=len(points) - 1)], colour=colour, done=done)


def main(pages: list[str]) -> None:
    """Draw the pictures of the pages named, or all."""
    for page in pages or STILLS:
        file = HERE / f"{Path(page).name}.jpg"
        picture(STILLS[page], run(page)).save(file, quality=QUALITY, optimize=True)
        print(f"wrote {file.name}, {file.stat().st_size // 1000} kB")


if __name__ == "__main__":
    main(sys.argv[1:])
