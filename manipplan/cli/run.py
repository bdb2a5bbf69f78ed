"""`manipplan run`: plan a program of moves."""

from pathlib import Path

from rich.console import Console
from tyro.conf import Positional

from manipplan.cli import terminal
from manipplan.cli.arm import RobotOptions, WithRobotOptions
from manipplan.jobs.sequence import sequence
from manipplan.programs.steps import ProgramFile
from manipplan.support.errors import InvalidInputError
from manipplan.support.files import place_for
from manipplan.support.progress import part


def run(
    program: Positional[Path],
    /,
    robot: str = "",
    out: Path = Path("program"),
    options: WithRobotOptions = RobotOptions(),
    jerk: tuple[float, ...] = (),
    torque: bool = False,
) -> int:
    """Plan a program of moves and write its trajectory as CSV, JSON and ROS JointTrajectory, with a report.

    Args:
        program: YAML file with the keys start and steps and, where wanted, robot, locked, scene, blend and clearance.
        robot: A name that `manipplan robots` lists, or a URDF, xacro or MJCF file, instead of that of the program.
        out: Folder for the files that are written.
        options: Options of the robot, and a scene instead of that of the program.
        jerk: Jerk limits [rad/s³ or m/s³] instead of the robot's, one number or one per joint.
        torque: Keep the joints' effort limits as well.
    """
    folder = place_for("out", out)
    with terminal.progress() as notify:
        notify(0.0, "loading the robot")
        file = ProgramFile.read(program)
        if not (robot or file.robot):
            raise InvalidInputError("robot", robot, "--robot, or the key robot in the program")
        beside = file.path.parent / file.robot
        name = robot or (str(beside) if beside.is_file() else file.robot)
        arm, world = options.load(name, jerk=jerk, locked=file.locked)
        made = sequence(
            arm,
            file.start,
            file.steps(arm),
            world if options.scene is not None or file.scene is None else file.scene,
            blend=file.blend,
            clearance=file.clearance,
            torque=torque,
            progress=part(notify, 0.05, 0.95),
        )
        notify(0.95, "writing files")
        files = made.save(folder)
        notify(1.0, "done")
    terminal.show_assumptions(Console(), arm)
    terminal.show_result(str(made), files)
    return 0
