"""The command `manipplan`: the jobs from a shell. Exit codes: 0 done, 1 no result, 2 wrong input, 130 interrupted."""

import logging
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path

import tyro
from rich.console import Console
from rich.markup import escape
from rich.table import Table
from tyro.conf import Positional

from manipplan.demo import Problem, panda_among_boxes, planar_path
from manipplan.errors import InvalidInputError, ManipplanError, MissingExtraError
from manipplan.files import writable_folder
from manipplan.jobs import plan as plan_job
from manipplan.robots.catalog import available_robots, load_robot
from manipplan.robots.scene import Scene


def demo(out: Path = Path("demo"), seed: int = 0) -> None:
    """Plan on the Panda through five boxes, and improve the planar three-link path (6.13) of kth2012.

    Args:
        out: Folder for trajectories, reports and pictures.
        seed: Of the planner; the same seed gives the same result.
    """
    folder = writable_folder("out", out)
    with _progress() as say:
        say("loading the Panda")
        panda = panda_among_boxes()
    _solve(panda, folder / "panda", seed)
    _solve(planar_path(), folder / "planar", seed)


def plan(
    robot: Positional[str],
    /,
    start: tuple[float, ...],
    goal: tuple[float, ...],
    scene: Path | None = None,
    out: Path = Path("plan"),
    tool: str | None = None,
    srdf: Path | None = None,
    power: float = 1.0,
    degree: int = 6,
    clearance: float = 0.0,
    torque: bool = False,
    seed: int = 0,
    time_limit: float = 10.0,
) -> None:
    """Plan a motion and write it as CSV, JSON and ROS JointTrajectory, with a report and a picture.

    Args:
        robot: A name that `manipplan robots` lists, or a URDF or MJCF file.
        start: One angle [rad] or length [m] a joint.
        goal: One angle [rad] or length [m] a joint.
        scene: YAML file with obstacles.
        out: Folder for what is written.
        tool: Frame whose motion counts, when the robot is a file.
        srdf: Semantic description, when the robot is a file.
        power: Exponent of the index in the objective.
        degree: Of the path's polynomial.
        clearance: Distance [m] to keep.
        torque: Limit the motion by the joints' effort, too.
        seed: Of the planner.
        time_limit: For the planner's search [s].
    """
    folder = writable_folder("out", out)
    options: dict[str, object] = {"tool": tool, "srdf": srdf}
    with _progress() as say:
        say("loading the robot")
        arm = load_robot(robot, **{key: value for key, value in options.items() if value is not None})
        world = Scene.from_yaml(scene) if scene is not None else Scene()
        made = plan_job(
            arm,
            start,
            goal,
            world,
            power=power,
            degree=degree,
            clearance=clearance,
            torque=torque,
            seed=seed,
            time_limit=time_limit,
            progress=say,
        )
        say("writing files")
        files = made.save(folder)
    _notice(arm.locked)
    _print_result(str(made.report), files)


def robots(name: Positional[str | None] = None, /) -> None:
    """List the known arms, or print the table of one.

    Args:
        name: An arm's name, or a URDF or MJCF file.
    """
    console = Console()
    if name is not None:
        console.print(escape(str(load_robot(name))), highlight=False)
        return
    table = Table("name", "joints", "tool frame", box=None)
    with _progress() as say:
        for each in available_robots():
            say(f"loading {each}")
            robot = load_robot(each)
            table.add_row(each, str(robot.n), robot.tool)
    console.print(table)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns its exit code and prints errors in one line, without a traceback."""
    logging.basicConfig(level=logging.WARNING, format="%(message)s")
    logging.getLogger("toppra").setLevel(logging.ERROR)
    errors = Console(stderr=True)
    try:
        tyro.extras.subcommand_cli_from_dict(
            {"demo": demo, "plan": plan, "robots": robots},
            prog="manipplan",
            description="Robot-arm motion that stays far from singularities.",
            args=arguments,
        )
    except (InvalidInputError, MissingExtraError) as error:
        errors.print(f"manipplan: {escape(str(error))}", style="red", highlight=False, soft_wrap=True)
        return 2
    except ManipplanError as error:
        errors.print(f"manipplan: {escape(str(error))}", style="red", highlight=False, soft_wrap=True)
        return 1
    except KeyboardInterrupt:
        errors.print("manipplan: interrupted; finished files are whole, nothing half-written is left", style="red")
        return 130
    return 0


def _solve(problem: Problem, folder: Path, seed: int) -> None:
    with _progress() as say:
        made = plan_job(problem.robot, problem.start, problem.goal, problem.scene, power=problem.power, seed=seed, progress=say)
        say("writing files")
        files = made.save(folder)
    _notice(problem.robot.locked)
    _print_result(str(made.report), files)


def _notice(locked: Mapping[str, float]) -> None:
    if locked:
        shown = ", ".join(f"{name} at {value:g}" for name, value in locked.items())
        Console().print(f"locked joints: {escape(shown)}", style="dim", highlight=False)


def _print_result(report: str, files: list[Path]) -> None:
    console = Console()
    console.print(escape(report), highlight=False, soft_wrap=True)
    console.print("wrote " + " ".join(escape(str(file)) for file in files) + "\n", highlight=False, soft_wrap=True)


@contextmanager
def _progress() -> Iterator[Callable[[str], None]]:
    """A spinner with the present step and the time since it began; plain lines where there is no terminal."""
    console = Console(stderr=True)
    if not console.is_terminal:
        yield lambda text: console.print(f"... {escape(text)}", highlight=False)
        return
    from rich.progress import Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

    columns = (SpinnerColumn(), TextColumn("{task.description}"), TimeElapsedColumn())
    with Progress(*columns, console=console, transient=True) as bar:
        task = bar.add_task("")
        yield lambda text: bar.reset(task, description=text)


def run() -> None:
    """Entry point of the console script."""
    sys.exit(main())
