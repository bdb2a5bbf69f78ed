"""The command `manipplan`: the jobs from a shell. Exit codes: 0 done, 1 no result, 2 wrong input, 130 interrupted."""

import logging
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Literal

import tyro
from rich.console import Console
from rich.markup import escape
from rich.table import Table
from tyro.conf import Positional

from manipplan.demo import Problem, panda_among_boxes, planar_path
from manipplan.errors import InvalidInputError, ManipplanError, MissingExtraError
from manipplan.files import writable_folder
from manipplan.jobs.following import follow as follow_job
from manipplan.jobs.planning import plan as plan_job
from manipplan.measures.task import Task
from manipplan.paths.cartesian import CartesianPath
from manipplan.progress import part
from manipplan.robots.catalog import available_robots, load_robot
from manipplan.robots.scene import Scene
from manipplan.tracking.relaxation import Tolerance


def demo(out: Path = Path("demo"), seed: int = 0) -> None:
    """Plan on the Panda through five boxes, and improve the planar three-link path (6.13) of kth2012.

    Args:
        out: Folder for trajectories, reports and pictures.
        seed: Of the planner; the same seed gives the same result.
    """
    folder = writable_folder("out", out)
    with _progress() as tell:
        tell(0.0, "loading the Panda")
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
    measure: str | None = None,
    degree: int = 6,
    shifts: Literal["none", "within-limits"] = "none",
    clearance: float = 0.0,
    torque: bool = False,
    seed: int = 0,
    seeds: int = 1,
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
        measure: Of manipulability, by name; default Yoshikawa's.
        degree: Of the path's polynomial.
        shifts: within-limits tries goals a full turn away, too.
        clearance: Distance [m] to keep.
        torque: Limit the motion by the joints' effort, too.
        seed: Of the planner.
        seeds: How many first paths are looked for.
        time_limit: For the planner's search [s].
    """
    folder = writable_folder("out", out)
    options: dict[str, object] = {"tool": tool, "srdf": srdf}
    with _progress() as tell:
        tell(0.0, "loading the robot")
        arm = load_robot(robot, **{key: value for key, value in options.items() if value is not None})
        world = Scene.from_yaml(scene) if scene is not None else Scene()
        made = plan_job(
            arm,
            start,
            goal,
            world,
            power=power,
            measure=measure,
            degree=degree,
            shifts=shifts,
            clearance=clearance,
            torque=torque,
            seed=seed,
            seeds=seeds,
            time_limit=time_limit,
            progress=part(tell, 0.0, 0.95),
        )
        tell(1.0, "writing files")
        files = made.save(folder)
    _notice(arm.locked)
    _print_result(str(made.report), files)


def follow(
    robot: Positional[str],
    poses: Positional[Path],
    /,
    positions: int = 50,
    epsilon: float = 0.2,
    samples: tuple[int, ...] = (),
    pointing: tuple[float, float, float] | None = None,
    tolerance: tuple[float, float] | None = None,
    scene: Path | None = None,
    out: Path = Path("follow"),
    tool: str | None = None,
    srdf: Path | None = None,
    clearance: float = 0.0,
    closed: bool = False,
    torque: bool = False,
    seed: int = 0,
) -> None:
    """Follow a workspace path with the highest least index, and write the motion as CSV, JSON and ROS JointTrajectory.

    Args:
        robot: A name that `manipplan robots` lists, or a URDF or MJCF file.
        poses: CSV file with the columns x, y, z [m], qw, qx, qy, qz.
        positions: At which configurations are enumerated.
        epsilon: Longest step of a joint between neighbouring positions [rad or m].
        samples: Of what the arm has to spare, a number or one for each parameter.
        pointing: Tool axis about which the tool may turn.
        tolerance: How far the tool may leave the path [m] [rad].
        scene: YAML file with obstacles.
        out: Folder for what is written.
        tool: Frame whose motion counts, when the robot is a file.
        srdf: Semantic description, when the robot is a file.
        clearance: Distance [m] to keep.
        closed: The path returns to its start, and so does the motion.
        torque: Limit the motion by the joints' effort, too.
        seed: Of random starts, for arms without a closed form.
    """
    folder = writable_folder("out", out)
    path = CartesianPath.from_csv(poses)
    options: dict[str, object] = {"tool": tool, "srdf": srdf}
    with _progress() as tell:
        tell(0.0, "loading the robot")
        arm = load_robot(robot, **{key: value for key, value in options.items() if value is not None})
        world = Scene.from_yaml(scene) if scene is not None else Scene()
        made = follow_job(
            arm,
            path,
            positions,
            epsilon=epsilon,
            task=Task.pointing(pointing) if pointing is not None else None,
            samples=samples[0] if len(samples) == 1 else samples or None,
            tolerance=Tolerance(position=tolerance[0], rotation=tolerance[1]) if tolerance is not None else None,
            scene=world,
            clearance=clearance,
            closed=closed,
            torque=torque,
            seed=seed,
            progress=part(tell, 0.0, 0.95),
        )
        tell(1.0, "writing files")
        files = made.save(folder)
    _notice(arm.locked)
    _print_result(f"{made.report}\n  search       {made.refinement}\n  deviation    {made.deviation}", files)


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
    names = available_robots()
    with _progress() as tell:
        for k, each in enumerate(names):
            tell(k / len(names), f"loading {each}")
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
            {"demo": demo, "plan": plan, "follow": follow, "robots": robots},
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
    with _progress() as tell:
        made = plan_job(
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
def _progress() -> Iterator[Callable[[float, str], None]]:
    """A bar with the share done and the time that is left; where there is no terminal a line for every tenth."""
    console = Console(stderr=True)
    if not console.is_terminal:
        last = -1

        def line(share: float, text: str) -> None:
            nonlocal last
            if int(10 * share) > last:
                last = int(10 * share)
                console.print(f"... {10 * last} % {escape(text)}", highlight=False)

        yield line
        return
    from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn, TimeRemainingColumn

    columns = (TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn(), TimeRemainingColumn())
    with Progress(*columns, console=console, transient=True) as bar:
        task = bar.add_task("", total=1.0)
        yield lambda share, text: bar.update(task, completed=share, description=text)


def run() -> None:
    """Entry point of the console script."""
    sys.exit(main())
