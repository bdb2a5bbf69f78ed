"""`manipplan improve`: a recorded motion again, with a higher index."""

from pathlib import Path

from tyro.conf import Positional

from manipplan.cli import terminal
from manipplan.cli.arm import load_cell
from manipplan.files import place_for
from manipplan.jobs.improving import improve as improve_job
from manipplan.progress import part
from manipplan.tracking.relaxation import Tolerance


def improve(
    robot: Positional[str],
    recorded: Positional[Path],
    /,
    tolerance: tuple[float, float] = (0.02, 0.2),
    duration: float | None = None,
    dt: float = 0.01,
    scene: Path | None = None,
    out: Path = Path("improve"),
    tool: str | None = None,
    srdf: Path | None = None,
    velocity: tuple[float, ...] = (),
    acceleration: tuple[float, ...] = (),
) -> int:
    """Follow a recorded joint motion with a higher index, and write it as CSV, JSON and ROS JointTrajectory.

    Args:
        robot: A name that `manipplan robots` lists, or a URDF or MJCF file.
        recorded: CSV file with the columns time [s], q_JOINT [rad or m] for each joint; velocities may follow.
        tolerance: How far the tool may leave the recorded poses [m] [rad].
        duration: Of the new motion [s]; default that of the recording.
        dt: Time step [s].
        scene: YAML file with obstacles.
        out: Folder for what is written.
        tool: Frame whose motion counts, when the robot is a file.
        srdf: Semantic description, when the robot is a file.
        velocity: Limits [rad/s or m/s] instead of the robot's, one number or one a joint.
        acceleration: Limits [rad/s² or m/s²], likewise.
    """
    folder = place_for("out", out)
    with terminal.progress() as tell:
        tell(0.0, "loading the robot")
        arm, world = load_cell(robot, scene, tool=tool, srdf=srdf, velocity=velocity, acceleration=acceleration)
        made = improve_job(
            arm,
            recorded,
            dt=dt,
            duration=duration,
            tolerance=Tolerance(position=tolerance[0], rotation=tolerance[1]),
            scene=world,
            progress=part(tell, 0.0, 0.95),
        )
        tell(1.0, "writing files")
        files = made.save(folder)
    return terminal.show_plan(made, files, f"tracking     {made.tracking}")
