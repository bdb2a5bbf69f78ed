"""`manipplan plan`: plan a motion from start to goal among obstacles."""

from collections.abc import Sequence
from pathlib import Path
from typing import Literal

from tyro.conf import Positional

from manipplan.cli import terminal
from manipplan.cli.arm import RobotOptions, WithRobotOptions, configuration_of
from manipplan.constraints.constraint import constraints_from_yaml
from manipplan.cost.objective import PathObjective
from manipplan.goals.pose_goal import Goal
from manipplan.goals.read import goals_from_yaml, pose_of_numbers
from manipplan.jobs.plan import plan as plan_job
from manipplan.paths.basis import PathShape
from manipplan.robots.robot import Robot
from manipplan.seeds.seeding import Seeding
from manipplan.support.errors import InvalidInputError
from manipplan.support.files import place_for
from manipplan.support.progress import part


def plan(
    robot: Positional[str],
    /,
    start: tuple[str, ...],
    goal: tuple[str, ...] = (),
    goal_pose: tuple[float, ...] = (),
    goals: Path | None = None,
    constraints: Path | None = None,
    out: Path = Path("plan"),
    options: WithRobotOptions = RobotOptions(),
    jerk: tuple[float, ...] = (),
    power: float = 1.0,
    measure: str | None = None,
    degree: int = 6,
    shifts: Literal["none", "nearest", "within-limits"] = "none",
    clearance: float = 0.0,
    torque: bool = False,
    seed: int = 0,
    seeds: int = 1,
    time_limit: float = 10.0,
) -> int:
    """Plan a motion and write it as CSV, JSON and ROS JointTrajectory, with a report and a picture.

    Args:
        options: Options of the robot and its scene.
        robot: A name that `manipplan robots` lists, or a URDF, xacro or MJCF file.
        start: One angle [rad] or length [m] per joint, or the name of a state in the robot's SRDF.
        goal: As `start`. Give one of goal, goal-pose and goals.
        goal_pose: Pose of the tool in the world: x y z [m], then roll pitch yaw [rad] or a quaternion x y z w.
        goals: YAML file with a list of goals under the key goals, of which the one with the best motion is chosen: each a
            position [m] and rotation (roll pitch yaw [rad] or quaternion x y z w), a q, or a state.
        constraints: YAML file with what the motion keeps, under the key constraints: tilt_limit, position_box and held_joints.
        out: Folder for the files that are written.
        jerk: Jerk limits [rad/s³ or m/s³] instead of the robot's, one number or one per joint.
        power: Exponent of the manipulability in the objective.
        measure: Name of the manipulability measure; default: Yoshikawa's.
        degree: Degree of the path's polynomial.
        shifts: nearest takes the full turn of each joint that is nearest to the start; within-limits also tries goals a full
            turn away.
        clearance: Minimum distance to keep [m].
        torque: Keep the joints' effort limits as well.
        seed: Random seed of the planner.
        seeds: Number of first paths to search for.
        time_limit: Time limit of the planner's search [s].
    """
    folder = place_for("out", out)
    with terminal.progress() as notify:
        notify(0.0, "loading the robot")
        arm, world = options.load(robot, jerk=jerk)
        begin = configuration_of("start", start, arm)
        end = _goal(arm, goal, goal_pose, goals)
        kept = constraints_from_yaml(constraints) if constraints is not None else ()
        objective = PathObjective(power=power, measure=measure)
        made = plan_job(
            arm,
            begin,
            end,
            world,
            constraints=kept,
            objective=objective,
            shape=PathShape(degree=degree),
            seeding=Seeding(seed=seed, count=seeds, time_limit=time_limit, shifts=shifts),
            clearance=clearance,
            torque=torque,
            progress=part(notify, 0.0, 0.95),
        )
        notify(1.0, "writing files")
        files = made.save(folder)
    chosen = [f"goal {made.goal_index} of {goals} was chosen"] if goals is not None else []
    return terminal.show_plan(made, files, *chosen)


def _goal(arm: Robot, words: Sequence[str], pose: Sequence[float], file: Path | None) -> Goal:
    """The goal from the one option that gives it."""
    given = sum(map(bool, (words, pose, file is not None)))
    if given != 1:
        raise InvalidInputError("goal", f"{given} of --goal, --goal-pose and --goals", "exactly one of them")
    if file is not None:
        return goals_from_yaml(file, arm)
    return pose_of_numbers("goal_pose", pose) if pose else configuration_of("goal", words, arm)
