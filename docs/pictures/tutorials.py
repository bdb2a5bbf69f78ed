"""Draws pictures of tutorials and how-tos from the code on their pages: python docs/pictures/tutorials.py [tutorials/cell ...].

Writes docs/pictures/tutorial_*.jpg and .png, and scene.jpg. The arms need the extra `film`.
"""

import os
import re
import sys
import tempfile
from pathlib import Path
from typing import Any

import matplotlib as mpl

mpl.use("agg")
import matplotlib.pyplot as plt
import numpy as np
from PIL import Image

from manipplan.viz.motions import skeleton
from manipplan.viz.render import DrawnWay, Renderer
from manipplan.viz.style import OPTIMUM, SEED

HERE = Path(__file__).parent
SIZE, QUALITY = (900, 520), 84
#: Steps of a motion, distance of the points by which its way is drawn, and space around it in each direction [m].
STEPS, STEP, MARGIN = 600, 0.02, 0.12


def run(page: str) -> dict[str, Any]:
    """Run the Python blocks of a page in a folder of their own; returns their names."""
    text = (HERE.parent / f"{page}.md").read_text(encoding="utf-8")
    names: dict[str, Any] = {"__name__": "__main__"}
    here = Path.cwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            for code in re.findall(r"```python\n(.*?)```", text, re.DOTALL):
                exec(compile(code, page, "exec"), names)
        finally:
            os.chdir(here)
    return names


def still(file: Path, plan: Any, q: Any, way: Any, *corners: Any) -> None:
    """The arm of a plan at q (n,) among its obstacles, with the way (k, n) of its tool; corners (3,) have to be in it."""
    points = plan.robot.kinematics().pose(way)[:, :3, 3]
    gone = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    even = np.searchsorted(gone, np.linspace(0.0, gone[-1], 2 + int(gone[-1] / STEP))).clip(max=len(points) - 1)
    shown = np.concatenate([points, skeleton(plan.robot, q), np.reshape(corners, (-1, 3))])
    around = np.concatenate([shown - MARGIN, shown + MARGIN])
    with Renderer(plan.robot, plan.scene, around, SIZE) as renderer:
        picture = renderer.draw(q, [DrawnWay(points=points[even], colour=OPTIMUM)])
    Image.fromarray(picture).save(file, quality=QUALITY, optimize=True)


def cell(names: dict[str, Any]) -> None:
    part = names["program"].parts[1]
    t = part.trajectory.duration * np.linspace(0.0, 1.0, STEPS)
    still(HERE / "tutorial_cell.jpg", part, part.trajectory(0.72 * t[-1]), part.trajectory(t))


def weld(names: dict[str, Any]) -> None:
    plan = names["plan"]
    t = np.linspace(plan.path_begin, plan.trajectory.duration, STEPS)
    still(
        HERE / "tutorial_weld.jpg", plan, plan.trajectory(t[STEPS // 3]), plan.trajectory(t), (0.0, -1.2, 0.1), (0.0, 1.2, 0.1)
    )


def teleoperation(names: dict[str, Any]) -> None:
    figure, (above, below) = plt.subplots(2, 1, figsize=(8.0, 4.4), sharex=True, layout="constrained")
    for log, label, colour in (("usual", "damped least squares", SEED), ("smooth", "mp.Servo", OPTIMUM)):
        above.plot(names["t"], 100 * names[log]["followed"], color=colour, label=label)
        below.plot(names["t"], 100 * names[log]["speed"], color=colour)
    above.set(ylabel="followed [%]", ylim=(-5, 105), xlim=(0, names["t"][-1]))
    below.set(ylabel="fastest joint [% of its limit]", xlabel="time [s]", ylim=(0, 105))
    above.legend(frameon=False)
    for ax in (above, below):
        ax.spines[["top", "right"]].set_visible(False)
    figure.savefig(HERE / "tutorial_teleoperation.png", dpi=120)


def scene(names: dict[str, Any]) -> None:
    robot, corners = names["robot"], np.array([[0.05, -0.7, 0.0], [0.95, 0.7, 0.0]])
    around = np.concatenate([skeleton(robot, robot.neutral) + side for side in (-MARGIN, MARGIN)])
    with Renderer(robot, names["scene"], np.concatenate([around, corners]), SIZE) as renderer:
        Image.fromarray(renderer.draw(robot.neutral, [])).save(HERE / "scene.jpg", quality=QUALITY, optimize=True)


PAGES = {"tutorials/cell": cell, "tutorials/weld": weld, "tutorials/teleoperation": teleoperation, "howto/scene": scene}

if __name__ == "__main__":
    for page in sys.argv[1:] or PAGES:
        PAGES[page](run(page))
