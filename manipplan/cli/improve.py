"""`manipplan improve`: make a recorded motion smooth and raise its manipulability."""

from pathlib import Path

from tyro.conf import Positional

from manipplan.cli import terminal
from manipplan.cli.arm import RobotOptions, WithRobotOptions, columns_of
from manipplan.cost.objective import PathObjective
from manipplan.jobs.improve import improve as improve_job
from manipplan.paths.tolerance import Tolerance
from manipplan.support.files import place_for
from manipplan.support.progress import part


def improve(
    robot: Positional[str],
    recorded: Positional[Path],
    /,
    tolerance: tuple[float, float] = (0.02, 0.2),
    duration: float | None = None,
    degrees: bool = False,
    column: tuple[str, ...] = (),
    clearance: float = 0.0,
    measure: str | None = None,
    out: Path = Path("improve"),
    options: WithRobotOptions = RobotOptions(),
) -> int:
    """Make a recorded joint motion smooth and raise its manipulability, and write it as CSV, JSON and ROS JointTrajectory.

    Args:
        options: Options of the robot and its scene.
        robot: A name that `manipplan robots` lists, or a URDF, xacro or MJCF file.
        recorded: CSV file with the columns time [s] and q_JOINT [rad or m] of each joint, in any order; or a trajectory file
            that manipplan wrote.
        tolerance: Maximum deviation of the tool from the recorded poses [m] [rad].
        duration: Duration of the new motion [s]; default: that of the recording.
        degrees: The angles of the recording are in degrees.
        column: Column of the CSV file for a joint, or for time, that has another name: joint=column, time=column.
        clearance: Distance to keep from obstacles and between the arm's own links [m].
        measure: Name of the manipulability measure; default: Yoshikawa's.
        out: Folder for the files that are written.
    """
    folder = place_for("out", out)
    with terminal.progress() as notify:
        notify(0.0, "loading the robot")
        arm, world = options.load(robot)
        made = improve_job(
            arm,
            recorded,
            world,
            objective=PathObjective(measure=measure),
            duration=duration,
            degrees=degrees,
            columns=columns_of(column),
            clearance=clearance,
            tolerance=Tolerance(position=tolerance[0], rotation=tolerance[1]),
            progress=part(notify, 0.0, 0.95),
        )
        notify(1.0, "writing files")
        files = made.save(folder)
    return terminal.show_plan(made, files)
