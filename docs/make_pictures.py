"""Write the picture and the animation of the README and the start page: `make pictures`, or `python docs/make_pictures.py`."""

from pathlib import Path

import manipplan as mp
from manipplan import viz

FOLDER = Path(__file__).parent / "_static"

problem = mp.demo.panda_among_boxes()
plan = mp.plan(
    problem.robot,
    problem.start,
    problem.goal,
    problem.scene,
    objective=mp.PathObjective(power=problem.power),
    clearance=problem.clearance,
)
viz.save_figure(plan, FOLDER / "demo.png")
viz.animate(plan, FOLDER / "demo.gif", fps=12.5, speed=0.75, size=(8.0, 4.0), dpi=80, colours=64)
for file in (FOLDER / "demo.png", FOLDER / "demo.gif"):
    print(f"{file}: {file.stat().st_size // 1000} kB")
