"""`manipplan demo`: the two problems of `manipplan.jobs.demo`."""

from pathlib import Path

from manipplan.cli import terminal
from manipplan.cost.objective import PathObjective
from manipplan.jobs.demo import DemoProblem, panda_among_boxes, planar_path
from manipplan.jobs.plan import plan
from manipplan.seeds.seeding import Seeding
from manipplan.support.files import place_for
from manipplan.support.progress import part


def demo(out: Path = Path("demo"), seed: int = 0) -> int:
    """Plan for a Panda among five boxes, and for a planar arm of three links between the configurations of (6.13) in kth2012.

    Args:
        out: Folder for trajectories, reports and pictures.
        seed: Random seed of the planner; the same seed gives the same result.
    """
    folder = place_for("out", out)
    with terminal.progress() as notify:
        notify(0.0, "loading the Panda")
        panda = panda_among_boxes()
    return max(_solve(panda, folder / "panda", seed), _solve(planar_path(), folder / "planar", seed))


def _solve(problem: DemoProblem, folder: Path, seed: int) -> int:
    with terminal.progress() as notify:
        made = plan(
            problem.robot,
            problem.start,
            problem.goal,
            problem.scene,
            objective=PathObjective(power=problem.power),
            seeding=Seeding(seed=seed),
            clearance=problem.clearance,
            progress=part(notify, 0.0, 0.95),
        )
        notify(1.0, "writing files")
        files = made.save(folder)
    return terminal.show_plan(made, files)
