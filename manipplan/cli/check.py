"""`manipplan check`: judge a trajectory, whoever made it."""

import json as json_module
from pathlib import Path
from typing import Literal

from rich.console import Console
from tyro.conf import Positional

from manipplan.cli import terminal
from manipplan.cli.arm import RobotOptions, WithRobotOptions, columns_of, configuration_of, task_of
from manipplan.constraints.constraint import constraints_from_yaml
from manipplan.cost.objective import PathObjective
from manipplan.jobs.check import check as check_job
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.tolerance import Tolerance
from manipplan.support.json_data import json_ready


def check(
    trajectory: Positional[Path],
    /,
    robot: str,
    start: tuple[str, ...] = (),
    goal: tuple[str, ...] = (),
    options: WithRobotOptions = RobotOptions(),
    jerk: tuple[float, ...] = (),
    path: Path | None = None,
    path_begin: float = 0.0,
    tolerance: tuple[float, float] | None = None,
    pointing: tuple[float, float, float] | None = None,
    only: Literal["position", "orientation"] | None = None,
    constraints: Path | None = None,
    clearance: float = 0.0,
    torque: bool = False,
    power: float = 1.0,
    measure: str | None = None,
    degrees: bool = False,
    column: tuple[str, ...] = (),
    json: bool = False,
) -> int:
    """Judge a trajectory and print its report; the exit code is 0 if every check passed, and 1 if not.

    Args:
        trajectory: A file: .csv, .json, .yaml (ROS JointTrajectory) or .npz; or the folder of a saved plan or program.
        robot: A name that `manipplan robots` lists, or a URDF, xacro or MJCF file.
        start: Where the motion has to begin: one angle [rad] or length [m] per joint, or the name of a state in the SRDF.
        goal: Where it has to end, as `start`.
        options: Options of the robot and its scene.
        jerk: Jerk limits [rad/s³ or m/s³] instead of the robot's, one number or one per joint; inf: not checked.
        path: CSV file of poses that the tool has to follow, with the columns x, y, z [m], qx, qy, qz, qw.
        path_begin: Time from which the tool follows that path [s], after a lead-in.
        tolerance: Maximum distance of the tool from that path [m] [rad].
        pointing: Tool axis about which the tool may turn.
        only: What of the poses of the path counts.
        constraints: YAML file with what the motion has to keep, as for `manipplan plan`.
        clearance: Minimum distance to keep [m].
        torque: Check the joints' effort limits as well.
        power: Exponent of the manipulability in g.
        measure: Name of the manipulability measure; default: Yoshikawa's.
        degrees: The angles of the trajectory are in degrees.
        column: Column of a CSV file for a joint, or for time, that has another name: joint=column, time=column.
        json: Print the report as JSON.
    """
    with terminal.progress() as notify:
        notify(0.0, "loading the robot")
        arm, world = options.load(robot, jerk=jerk)
        notify(0.3, "checking the motion")
        report = check_job(
            arm,
            trajectory / "trajectory.csv" if trajectory.is_dir() else trajectory,
            world,
            start=configuration_of("start", start, arm) if start else None,
            goal=configuration_of("goal", goal, arm) if goal else None,
            path=CartesianPath.from_csv(path) if path is not None else None,
            path_begin=path_begin,
            tolerance=Tolerance(position=tolerance[0], rotation=tolerance[1]) if tolerance is not None else None,
            constraints=constraints_from_yaml(constraints) if constraints is not None else (),
            clearance=clearance,
            objective=PathObjective(task=task_of(pointing, only), measure=measure, power=power),
            torque=torque,
            degrees=degrees,
            columns=columns_of(column),
        )
        notify(1.0, "done")
    console = Console()
    if json:
        terminal.show_line(console, json_module.dumps(json_ready(report), indent=1, allow_nan=False))
    else:
        terminal.show_assumptions(console, arm)
        terminal.show_line(console, str(report))
    return 0 if report.passed else 1
