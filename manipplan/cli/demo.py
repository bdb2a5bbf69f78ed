"""`manipplan demo`: the two problems of `manipplan.demo`."""

from pathlib import Path

from manipplan.cli import terminal
from manipplan.demo import Problem, panda_among_boxes, planar_path
from manipplan.files import writable_folder
from manipplan.jobs.planning import plan
from manipplan.progress import part


def demo(out: Path = Path("demo"), seed: int = 0) -> None:
    """Plan on the Panda through five boxes, and improve the planar three-link path (6.13) of kth2012.

    Args:
        out: Folder for trajectories, reports and pictures.
        seed: Of the planner; the same seed gives the same result.
    """
    folder = writable_folder("out", out)
    with terminal.progress() as tell:
        tell(0.0, "loading the Panda")
        panda = panda_among_boxes()
    _solve(panda, folder / "panda", seed)
    _solve(planar_path(), folder / "planar", seed)


def _solve(problem: Problem, folder: Path, seed: int) -> None:
    with terminal.progress() as tell:
        made = plan(
            problem.robot,
            problem.start,
            problem.goal,
            problem.scene,
            power=problem.power,
            seed=seed,
            progress=part(tell, 0.0, 0.95),
        )
        tell(1.0, "writing files")
        files = made.save(folder)
    terminal.show_plan(made, files)
