"""`manipplan follow`: follow a path of the tool with the largest minimum manipulability."""

from pathlib import Path
from typing import Literal

from tyro.conf import Positional

from manipplan.cli import terminal
from manipplan.cli.arm import RobotOptions, WithRobotOptions, configuration_of, task_of
from manipplan.cost.objective import PathObjective
from manipplan.jobs.follow import follow as follow_job
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.tolerance import Tolerance
from manipplan.seeds.seeding import Seeding
from manipplan.support.files import place_for
from manipplan.support.progress import part


def follow(
    robot: Positional[str],
    poses: Positional[Path],
    /,
    start: tuple[str, ...] = (),
    tool_speed: float | None = None,
    positions: int | None = None,
    interruptions: int = 0,
    retreat: tuple[float, ...] = (0.05,),
    epsilon: float = 0.2,
    samples: tuple[int, ...] = (),
    pointing: tuple[float, float, float] | None = None,
    only: Literal["position", "orientation"] | None = None,
    tolerance: tuple[float, float] | None = None,
    out: Path = Path("follow"),
    options: WithRobotOptions = RobotOptions(),
    jerk: tuple[float, ...] = (),
    clearance: float = 0.0,
    closed: bool = False,
    torque: bool = False,
    measure: str | None = None,
    seed: int = 0,
    time_limit: float = 10.0,
) -> int:
    """Follow a workspace path with the largest minimum manipulability; write the motion as CSV, JSON and ROS JointTrajectory.

    Args:
        options: Options of the robot and its scene.
        robot: A name that `manipplan robots` lists, or a URDF, xacro or MJCF file.
        poses: CSV file with the columns x, y, z [m], qx, qy, qz, qw.
        start: Where the motion begins: one angle [rad] or length [m] per joint, or the name of a state in the robot's SRDF.
        tool_speed: Constant speed of the tool along the path [m/s].
        positions: Number of positions at which configurations are enumerated; default: at most 3 cm apart.
        interruptions: Maximum number of times that the tool leaves the path, if no continuous motion follows it.
        retreat: Straight way of the tool off the path and back [m]: a distance against its z-axis, or a vector in its frame.
        epsilon: Maximum step of a joint between neighbouring positions [rad or m].
        samples: Number of grid points of the redundancy, one number or one per parameter.
        pointing: Tool axis about which the tool may turn.
        only: What of the poses the tool follows; the rest is chosen for the manipulability.
        tolerance: Maximum deviation of the tool from the path [m] [rad].
        out: Folder for the files that are written.
        jerk: Jerk limits [rad/s³ or m/s³] instead of the robot's, one number or one per joint.
        clearance: Minimum distance to keep [m].
        closed: The path returns to its start, and so does the motion.
        torque: Keep the joints' effort limits as well.
        measure: Name of the manipulability measure; default: Yoshikawa's.
        seed: Random seed of free motions, and of inverse kinematics without a closed form.
        time_limit: Time limit of the free motions to each part of the path [s].
    """
    folder = place_for("out", out)
    path = CartesianPath.from_csv(poses)
    with terminal.progress() as notify:
        notify(0.0, "loading the robot")
        arm, world = options.load(robot, jerk=jerk)
        made = follow_job(
            arm,
            path,
            world,
            start=configuration_of("start", start, arm) if start else None,
            tool_speed=tool_speed,
            positions=positions,
            interruptions=interruptions,
            retreat=retreat[0] if len(retreat) == 1 else retreat,
            objective=PathObjective(task=task_of(pointing, only), measure=measure),
            epsilon=epsilon,
            samples=samples[0] if len(samples) == 1 else samples or None,
            tolerance=Tolerance(position=tolerance[0], rotation=tolerance[1]) if tolerance is not None else None,
            clearance=clearance,
            closed=closed,
            torque=torque,
            seeding=Seeding(seed=seed, time_limit=time_limit),
            progress=part(notify, 0.0, 0.95),
        )
        notify(1.0, "writing files")
        files = made.save(folder)
    return terminal.show_plan(made, files, f"search       {made.refinement}", f"deviation    {made.deviation}")
