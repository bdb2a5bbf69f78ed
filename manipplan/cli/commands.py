"""The commands of `manipplan`, each a function whose arguments are those of the shell."""

import importlib
import json as json_module
import time
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Literal

from rich.console import Console
from rich.table import Column, Table
from tyro.conf import Positional

from manipplan.cli import terminal
from manipplan.cli.arm import (
    Address,
    Axis,
    Configuration,
    Count,
    Counts,
    Distances,
    Folder,
    InputFile,
    JerkLimits,
    MeasureName,
    Metres,
    Number,
    Numbers,
    OptionalCount,
    OptionalDistances,
    OptionalFile,
    OptionalRobot,
    OptionalSeconds,
    OptionalSpeed,
    OutFolder,
    Part,
    RobotName,
    RobotOptions,
    Seconds,
    WithRobotOptions,
    Words,
    columns_of,
    configuration_of,
    task_of,
)
from manipplan.constraints.constraint import constraints_from_yaml
from manipplan.cost.objective import PathObjective
from manipplan.goals.goal import Goal, goals_from_yaml, pose_of_numbers
from manipplan.jobs.check import check as check_job
from manipplan.jobs.demo import panda_among_boxes, planar_path
from manipplan.jobs.follow import follow as follow_job
from manipplan.jobs.improve import improve as improve_job
from manipplan.jobs.plan import plan as plan_job
from manipplan.jobs.sequence import sequence
from manipplan.paths.basis import PathShape
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.tolerance import Tolerance
from manipplan.plans.result import Plan
from manipplan.programs.program import NAME as PROGRAM
from manipplan.programs.program import Program
from manipplan.programs.steps import ProgramFile
from manipplan.robots.catalog import CATALOG, load_robot, refusal
from manipplan.robots.collections import CHECKOUT, names_of_collections, own_robots, package_of
from manipplan.robots.robot import Robot
from manipplan.seeds.seeding import Seeding
from manipplan.support.data_files import json_ready
from manipplan.support.errors import InvalidInputError, MissingSourcesError, PlanningError
from manipplan.support.files import place_for
from manipplan.support.progress import part
from manipplan.support.untrusted import terminal_text
from manipplan.timing.constant_speed import STEADY
from manipplan.viz import viewer


def plan(
    robot: Positional[RobotName],
    /,
    start: Configuration,
    goal: Configuration = (),
    goal_pose: Numbers = (),
    goals: OptionalFile = None,
    constraints: OptionalFile = None,
    out: OutFolder = Path("plan"),
    options: WithRobotOptions = RobotOptions(),
    jerk: JerkLimits = (),
    power: Number = 1.0,
    measure: MeasureName = None,
    degree: Count = 6,
    shifts: Literal["none", "nearest", "within-limits"] = "none",
    clearance: Metres = 0.0,
    torque: bool = False,
    seed: Count = 0,
    seeds: Count = 1,
    time_limit: Seconds = 10.0,
) -> int:
    """Plan a motion and write it as CSV, JSON and ROS JointTrajectory, with a report and a picture.

    Args:
        start: One angle [rad] or length [m] per joint, or the name of a state in the robot's SRDF.
        goal: As `start`. Give one of goal, goal-pose and goals.
        goal_pose: Pose of the tool in the world: x y z [m], then roll pitch yaw [rad] or a quaternion x y z w.
        goals: YAML file, under the key goals a list of position and rotation, q or state; the one with the best motion wins.
        constraints: YAML file with what the motion keeps, under the key constraints: tilt_limit, position_box and held_joints.
        power: Exponent of the manipulability in the objective.
        degree: Degree of the path's polynomial.
        shifts: Full turns of the goal's joints: none, those nearest to the start, or all that are within the limits.
        clearance: Minimum distance to keep [m].
        torque: Keep the joints' effort limits as well.
        seed: Random seed of the planner.
        seeds: Number of first paths to search for.
        time_limit: Time limit of the planner's search [s].
    """
    folder = place_for("out", out)
    with terminal.progress("loading the robot") as notify:
        arm, world = options.load(robot, jerk=jerk)
        begin = configuration_of("start", start, arm)
        end = _goal(arm, goal, goal_pose, goals)
        found = constraints_from_yaml(constraints) if constraints is not None else ()
        objective = PathObjective(power=power, measure=measure)
        made = plan_job(
            arm,
            begin,
            end,
            world,
            constraints=found,
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


def run(
    program: Positional[InputFile],
    /,
    robot: OptionalRobot = None,
    out: OutFolder = Path("program"),
    options: WithRobotOptions = RobotOptions(),
    jerk: JerkLimits = (),
    torque: bool = False,
    time_limit: OptionalSeconds = None,
) -> int:
    """Plan a program of moves and write its trajectory as CSV, JSON and ROS JointTrajectory, with a report.

    Args:
        program: YAML file with the keys start and steps and, where wanted, robot, locked, scene, blend and clearance.
        robot: A name that `manipplan robots` lists, or a URDF, xacro or MJCF file, instead of that of the program.
        options: Options of the robot, and a scene instead of that of the program.
        torque: Keep the joints' effort limits as well.
        time_limit: Time limit of the whole job [s]; the best program that was found by then is written.
    """
    folder = place_for("out", out)
    with terminal.progress("loading the robot") as notify:
        file = ProgramFile.read(program)
        if not (robot or file.robot):
            raise InvalidInputError("robot", robot or "", "--robot, or the key robot in the program")
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
            time_limit=time_limit,
            progress=part(notify, 0.05, 0.95),
        )
        notify(0.95, "writing files")
        files = made.save(folder)
        notify(1.0, "done")
    terminal.show_assumptions(Console(), arm)
    terminal.show_result(str(made), files, folder)
    return 0


def follow(
    robot: Positional[RobotName],
    poses: Positional[InputFile],
    /,
    start: Configuration = (),
    tool_speed: OptionalSpeed = None,
    slowdown: Number = STEADY,
    positions: OptionalCount = None,
    interruptions: Count = 0,
    retreat: Numbers = (0.05,),
    epsilon: Number = 0.2,
    samples: Counts = (),
    pointing: Axis = None,
    only: Part = None,
    tolerance: OptionalDistances = None,
    out: OutFolder = Path("follow"),
    options: WithRobotOptions = RobotOptions(),
    jerk: JerkLimits = (),
    clearance: Metres = 0.0,
    closed: bool = False,
    torque: bool = False,
    measure: MeasureName = None,
    seed: Count = 0,
    time_limit: OptionalSeconds = None,
) -> int:
    """Follow a workspace path with the largest minimum manipulability; write the motion as CSV, JSON and ROS JointTrajectory.

    Args:
        poses: CSV file with the columns x, y, z [m], qx, qy, qz, qw.
        start: Where the motion begins: one angle [rad] or length [m] per joint, or the name of a state in the robot's SRDF.
        tool_speed: Constant speed of the tool along the path [m/s].
        slowdown: Share by which the tool may be slower than that where the arm's limits do not allow it.
        positions: Number of positions at which configurations are enumerated; default: at most 3 cm apart.
        interruptions: Maximum number of times that the tool leaves the path, if no continuous motion follows it.
        retreat: Straight way of the tool off the path and back [m]: a distance against its z-axis, or a vector in its frame.
        epsilon: Maximum step of a joint between neighbouring positions [rad or m].
        samples: Number of grid points of the redundancy, one number or one per parameter.
        pointing: Tool axis about which the tool may turn.
        only: What of the poses the tool follows; the rest is chosen for the manipulability.
        tolerance: Maximum deviation of the tool from the path [m] [rad].
        clearance: Minimum distance to keep [m].
        closed: The path returns to its start, and so does the motion.
        torque: Keep the joints' effort limits as well.
        seed: Random seed of free motions, and of inverse kinematics without a closed form.
        time_limit: Time limit of the whole job [s]; what was found by then is written.
    """
    folder = place_for("out", out)
    path = CartesianPath.from_csv(poses)
    with terminal.progress("loading the robot") as notify:
        arm, world = options.load(robot, jerk=jerk)
        made = follow_job(
            arm,
            path,
            world,
            start=configuration_of("start", start, arm) if start else None,
            tool_speed=tool_speed,
            slowdown=slowdown,
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
            seeding=Seeding(seed=seed),
            time_limit=time_limit,
            progress=part(notify, 0.0, 0.95),
        )
        notify(1.0, "writing files")
        files = made.save(folder)
    return terminal.show_plan(made, files, f"search       {made.refinement}", f"deviation    {made.deviation}")


def improve(
    robot: Positional[RobotName],
    recorded: Positional[InputFile],
    /,
    tolerance: Distances = (0.02, 0.2),
    duration: OptionalSeconds = None,
    degrees: bool = False,
    column: Words = (),
    clearance: Metres = 0.0,
    measure: MeasureName = None,
    time_limit: OptionalSeconds = None,
    out: OutFolder = Path("improve"),
    options: WithRobotOptions = RobotOptions(),
) -> int:
    """Make a recorded joint motion smooth and raise its manipulability, and write it as CSV, JSON and ROS JointTrajectory.

    Args:
        recorded: CSV file with the columns time [s] and q_JOINT [rad or m] of each joint, in any order; or a trajectory file
            that manipplan wrote.
        tolerance: Maximum deviation of the tool from the recorded poses [m] [rad].
        duration: Duration of the new motion [s]; default: that of the recording.
        degrees: The angles of the recording are in degrees.
        column: Column of the CSV file for a joint, or for time, that has another name: joint=column, time=column.
        clearance: Distance to keep from obstacles and between the arm's own links [m].
        time_limit: Time after which the search ends [s]; the best motion that was proven by then is written.
    """
    folder = place_for("out", out)
    with terminal.progress("loading the robot") as notify:
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
            time_limit=time_limit,
            progress=part(notify, 0.0, 0.95),
        )
        notify(1.0, "writing files")
        files = made.save(folder)
    return terminal.show_plan(made, files)


def check(
    trajectory: Positional[InputFile],
    /,
    robot: RobotName,
    start: Configuration = (),
    goal: Configuration = (),
    options: WithRobotOptions = RobotOptions(),
    jerk: Numbers = (),
    path: OptionalFile = None,
    path_begin: Seconds = 0.0,
    tolerance: OptionalDistances = None,
    pointing: Axis = None,
    only: Part = None,
    constraints: OptionalFile = None,
    clearance: Metres = 0.0,
    torque: bool = False,
    power: Number = 1.0,
    measure: MeasureName = None,
    degrees: bool = False,
    column: Words = (),
    json: bool = False,
) -> int:
    """Judge a trajectory and print its report; the exit code is 0 if every check passed, and 1 if not.

    Args:
        trajectory: A file: .csv, .json, .yaml (ROS JointTrajectory) or .npz; or the folder of a saved plan or program.
        start: Where the motion has to begin: one angle [rad] or length [m] per joint, or the name of a state in the SRDF.
        goal: Where it has to end, as `start`.
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
        degrees: The angles of the trajectory are in degrees.
        column: Column of a CSV file for a joint, or for time, that has another name: joint=column, time=column.
        json: Print the report as JSON.
    """
    with terminal.progress("loading the robot") as notify:
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


def demo(out: Folder = Path("demo"), seed: Count = 0) -> int:
    """Plan for a Panda among five boxes, and for a planar arm of three links between the configurations of (6.13) in kth2012.

    Args:
        out: Folder for trajectories, reports and pictures.
        seed: Random seed of the planner; the same seed gives the same result.
    """
    folder, codes = place_for("out", out), []
    for name, make in (("panda", panda_among_boxes), ("planar", planar_path)):
        with terminal.progress("loading the robot"):
            problem = make()
        with terminal.progress() as notify:
            made = plan_job(
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
            files = made.save(folder / name)
        codes.append(terminal.show_plan(made, files))
    return max(codes)


def view(
    result: Positional[InputFile],
    /,
    port: Count = 8080,
    host: Address = "localhost",
    browser: bool = True,
    record: OptionalFile = None,
) -> None:
    """Show a saved plan or program in the browser until Ctrl-C, or record it as an HTML file.

    Args:
        result: Folder that `manipplan plan`, `follow`, `improve` or `run` wrote, or its plan.json or program.json.
        port: Port of the page; 0 takes any free port.
        host: Address on which the page is served; 0.0.0.0 lets other machines see it.
        browser: Open the page in the browser.
        record: Write this HTML file, which plays anywhere, instead of showing the page.
    """
    console = Console()
    with terminal.progress("loading the result") as notify:
        is_program = result.name == PROGRAM or (result / PROGRAM).is_file()
        shown = Program.load(result) if is_program else Plan.load(result)
        notify(0.3, "preparing the page")
        if record is not None:
            file = viewer.record(shown, record, progress=part(notify, 0.3, 1.0))
            page = None
        else:
            page = viewer.show(shown, port=port, host=host, open_browser=False)
        notify(1.0, "done")
    if page is None:
        terminal.show_line(console, f"wrote {file}; open it in a browser")
        return
    with page, suppress(KeyboardInterrupt):
        terminal.show_line(console, f"{shown.robot.name} at {page.url}; press Ctrl-C to stop")
        if browser:
            page.open()
        page.wait()


Paper = Literal["kth2012", "dufour2020", "guilamo2006", "singularities"]


def study(paper: Positional[Paper], /, quick: bool = False, out: OptionalFile = None) -> None:
    """Reproduce all tables and figures of a paper or of a study of our own, and collect them in report.html.

    Args:
        paper: kth2012 (paths of a planar arm), dufour2020 (QP inverse kinematics), guilamo2006 (search along a path), or our
            own study: singularities (g of paths that cross them).
        quick: Skip what takes long; the report says what is skipped.
        out: Folder for tables, figures and report. Default: study/PAPER.
    """
    folder = place_for("out", out if out is not None else Path("study") / paper)
    try:
        made = importlib.import_module(f"studies.{paper}.run").STUDY
        write_report = importlib.import_module("studies.report").write_report
    except ModuleNotFoundError as error:
        if error.name != "studies":
            raise
        raise MissingSourcesError("the studies") from error
    began = time.monotonic()
    with terminal.progress() as notify:
        found = made.run(folder, quick=quick, progress=notify)
    seconds = time.monotonic() - began
    report = write_report(made.pages.with_suffix(".md"), folder, quick=quick, seconds=seconds, found=found)
    told = found.differences or [f"{paper}: all figures are as expected: {found.summary}"]
    terminal.show_result("\n".join(told), [report])
    if found.differences:
        raise PlanningError(f"{len(found.differences)} figures of {paper} are not as expected; see {report}")


#: How the robots of each collection become available.
REMEDIES = {
    "robot_descriptions": "pip install 'manipplan[descriptions]'",
    "MuJoCo Menagerie": f"pip install 'manipplan[menagerie]', or set {CHECKOUT} to a checkout",
}


def robots(name: Positional[OptionalRobot] = None, /, *, names: bool = False) -> None:
    """List the known arms, or print the table of one.

    Args:
        name: An arm's name, or a URDF, xacro or MJCF file.
        names: Also list all names of robot_descriptions and of MuJoCo Menagerie.
    """
    console = Console()
    if name is not None:
        with terminal.progress("loading the robot"):
            text = str(load_robot(name))
        terminal.show_line(console, text)
        return
    table = Table(Column("name", no_wrap=True), "joints", Column("tool frame", no_wrap=True), "IK", box=None)
    for each, entry in CATALOG.items():
        tools = (entry.tool,) if isinstance(entry.tool, str) else entry.tool
        table.add_row(each, str(entry.joints), terminal_text("\n".join(tools)), entry.ik)
    console.print(table)
    for each, points in own_robots().items():
        reason = refusal(each, points)
        source = f"{package_of(points[0])}: {points[0].value}" if reason is None else f"cannot be loaded; allowed: {reason}"
        terminal.show_line(console, f" {each}: {source}")
    for line in _collections(names):
        terminal.show_line(console, line)


def _collections(all_names: bool) -> Iterator[str]:
    """What can be had of other collections, or how."""
    for collection, found in names_of_collections().items():
        if not found:
            yield f"{collection}: {REMEDIES[collection]}"
            continue
        yield f"{collection}: {len(found)} names, such as {found[0]}" + ("" if all_names else "   (--names lists them)")
        if all_names:
            yield from (f"  {each}" for each in found)
