"""Write the picture and the films of the README and the start page: python docs/make_pictures.py, part of `make pictures`."""

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
viz.film(plan, FOLDER / "demo.webp")
viz.film(plan, FOLDER / "demo_dark.webp", dark=True)
for name in ("demo.png", "demo.webp", "demo_dark.webp"):
    print(f"{name}: {(FOLDER / name).stat().st_size // 1000} kB")
