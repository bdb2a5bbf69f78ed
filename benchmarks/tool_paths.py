"""Tool paths by `mp.follow`: whether a motion is found where there is one, the fewest interruptions, and time.

Run with `make benchmark`. Writes docs/benchmarks/tool_paths.md. Paths that others made: CppFlow's and TORM's on an arm of
Fetch's geometry, CppFlow's of a Panda, and IKLink's recording; paths of that kind by a seeded script: 200 poses of a smooth
path with two cubes beside it, for a Panda, an xArm7, a UR5 whose tool may turn about its axis, and the arm of Fetch's geometry.
All arguments are at their defaults but a tolerance of 0.1 mm and 0.1°.

They are judged by CppFlow's rule: each pose is met to 0.1 mm and 0.1°, no joint moves more than 7° from one pose to the next,
and the motion is free, all by Pinocchio and coal on the original description. A grid ten times finer, of 7,200 samples at each
given pose, tells whether a motion may exist: its steps are not compared with bodies, so some of its motions do not exist. Times
are CPU times.
"""

import argparse
import os
import platform
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import coal
import numpy as np
import pinocchio as pin
from description_judge import Judge
from numpy.typing import NDArray
from outside import tool_paths
from rich.progress import track
from scipy.optimize import minimize_scalar
from scipy.spatial.transform import Rotation

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "tool_paths.md"
#: CppFlow's rule: distance of each pose [m, rad] and joint step between poses [rad].
MET, STEP = (1e-4, np.deg2rad(0.1)), np.deg2rad(7.0)
#: The largest step of a joint between neighbouring poses on the finer grid [rad], the default of `mp.follow`, and how many
#: times finer it is.
EPSILON, FINER = 0.2, 10
#: Number of poses of a path made here, and of poses through which it is laid.
POSES, VIA = 200, 5
#: Corners of the long path [m].
CORNERS = np.array([[0.45, -0.2, 0.35], [0.6, -0.2, 0.35], [0.6, 0.2, 0.35], [0.45, 0.2, 0.45], [0.45, -0.1, 0.45]])
#: Number of times at which the tool is compared with the poses, of those beside the nearest one where a pose may be met, of
#: configurations that are checked for collisions, and of random postures that show which links always touch.
TIMES, BESIDE, CHECKED, POSTURES = 4000, 40, 400, 100
#: Depth of an overlap that counts as contact [m].
CONTACT = 1e-6


@dataclass(frozen=True, kw_only=True)
class Case:
    """A path to follow among obstacles; `frame` is the frame of the description that is the tool."""

    name: str
    robot: mp.Robot
    path: mp.CartesianPath
    scene: mp.Scene
    task: mp.Task
    frame: str


@dataclass(frozen=True, kw_only=True)
class Result:
    """What `mp.follow` made of a case.

    Attributes:
        parts: number of parts; 0 without a motion.
        kept: whether CppFlow's rule holds.
        worst: largest distance of a pose [m, rad] and joint step [rad].
        least: minimum manipulability along the path.
        seconds: CPU time.
        finer: number of parts on the finer grid, 0 where no interruption helps, minimum manipulability, and that with the joint
            steps of CppFlow's rule, NaN where these take more parts; None: not searched.
    """

    parts: int
    kept: bool
    worst: tuple[float, float, float]
    least: float
    seconds: float
    finer: tuple[int, float, float] | None


def planned(case: Case, interruptions: int) -> tuple[mp.Plan, float]:
    """The motion along the path, and its CPU time."""
    began = time.process_time()
    plan = mp.follow(
        case.robot,
        case.path,
        case.scene,
        tolerance=mp.Tolerance(position=MET[0], rotation=MET[1]),
        objective=mp.PathObjective(task=case.task),
        interruptions=interruptions,
        retreat=0.0,
        throw=False,
    )
    return plan, time.process_time() - began


def follow(case: Case, interruptions: int, *, finer: bool) -> Result:
    """Follow the path, and judge the motion."""
    plan, seconds = planned(case, interruptions)
    parts, worst, kept, least = 0, (np.nan, np.nan, np.nan), False, np.nan
    if plan.status in (mp.Status.FOLLOWED, mp.Status.FOLLOWED_IN_PARTS):
        parts, least = len(plan.report.along), min(each.min_manipulability for each in plan.report.along)
        judge = judge_of(case)
        worst = deviations(case, plan, judge)
        kept = worst[0] <= MET[0] and worst[1] <= MET[1] and worst[2] <= STEP and is_free(plan, judge)
    return Result(
        parts=parts, kept=kept, worst=worst, least=least, seconds=seconds, finer=on_finer_grid(case) if finer else None
    )


def judge_of(case: Case) -> Judge:
    """Pinocchio and coal on the description of the arm, with the boxes."""
    judge = Judge(case.robot.source.file, case.robot)
    links = judge.geometry.ngeoms
    for box in case.scene.obstacles:
        placement = pin.SE3(box.pose)
        shape = pin.GeometryObject(box.name, 0, 0, placement, coal.Box(*np.asarray(box.size)))
        k = judge.geometry.addGeometryObject(shape)
        for link in range(links):
            if judge.geometry.geometryObjects[link].parentJoint:
                judge.geometry.addCollisionPair(pin.CollisionPair(link, k))
                judge.links.append(frozenset((judge.geometry.geometryObjects[link].name, box.name)))
    judge.geometry_data = pin.GeometryData(judge.geometry)
    return judge


def is_free(plan: mp.Plan, judge: Judge) -> bool:
    """Whether no links and boxes touch at CHECKED times but links that touch by construction."""
    postures = plan.robot.random_configuration(np.random.default_rng(0), size=POSTURES)
    always = judge.verdicts(postures).always
    q = plan.trajectory(np.linspace(0, plan.trajectory.duration, CHECKED))
    return min(judge.least(each, always) for each in q) > -CONTACT


def times_in_order(apart: NDArray[np.float64]) -> NDArray[np.int64]:
    """For each pose one of the times, none before that of the pose before, with the smallest sum of distances apart (k, t)."""
    every, least, first = np.arange(apart.shape[1]), np.zeros(apart.shape[1]), []
    for row in apart:
        total = row + least
        least = np.minimum.accumulate(total)
        first.append(np.maximum.accumulate(np.where(total == least, every, 0)))  # where the least so far is
    chosen = [int(first[-1][-1])]
    for until in reversed(first[:-1]):
        chosen.append(int(until[chosen[-1]]))
    return np.array(chosen[::-1])


def deviations(case: Case, plan: mp.Plan, judge: Judge) -> tuple[float, float, float]:
    """The largest distance of the given poses from the motion [m, rad], and joint step from one to the next [rad]."""
    axis = case.task.free_axis

    def pose_at(t: float) -> NDArray[np.float64]:
        return judge.pose_and_jacobian(plan.trajectory(t), case.frame)[0]

    def apart(t: float, pose: NDArray[np.float64]) -> tuple[float, float]:
        reached = pose_at(t)
        if axis is not None:
            angle = float(np.arccos(np.clip((reached[:3, :3] @ axis) @ (pose[:3, :3] @ axis), -1, 1)))
        else:
            angle = float(Rotation.from_matrix(reached[:3, :3].T @ pose[:3, :3]).magnitude())
        return float(np.linalg.norm(reached[:3, 3] - pose[:3, 3])), angle

    far = turned = step = 0.0
    for part in plan.report.along:
        t = np.linspace(part.begin, part.end, TIMES)
        reached = np.array([pose_at(each) for each in t])
        knots = case.path.knots[(case.path.knots >= part.s_begin - 1e-12) & (case.path.knots <= part.s_end + 1e-12)]
        poses, before = case.path(knots), None
        moved = np.linalg.norm(reached[None, :, :3, 3] - poses[:, None, :3, 3], axis=2)
        turns = (each[..., :3, :3] if axis is None else (each[..., :3, :3] @ axis)[..., None] for each in (reached, poses))
        there, wanted = (each.reshape(len(each), -1) for each in turns)
        turned_by = np.array([np.linalg.norm(there - each, axis=1) for each in wanted])
        for pose, rough in zip(poses, times_in_order(moved + MET[0] / MET[1] * turned_by), strict=True):
            beside = np.arange(max(rough - BESIDE, 0), min(rough + BESIDE + 1, TIMES))
            best = int(beside[np.argmin([max(np.divide(apart(t[k], pose), MET)) for k in beside])])
            window = t[max(best - 1, 0)], t[min(best + 1, TIMES - 1)]
            found = minimize_scalar(
                lambda x, pose=pose: max(np.divide(apart(x, pose), MET)),
                bounds=window,
                method="bounded",
                options={"xatol": 1e-9},
            )
            position, angle = min(
                (apart(each, pose) for each in (found.x, *window)), key=lambda each: max(np.divide(each, MET))
            )
            far, turned = max(far, position), max(turned, angle)
            q = plan.trajectory(found.x)
            step = max(step, 0.0 if before is None else float(np.abs(q - before).max()))
            before = q
    return far, turned, step


def on_finer_grid(case: Case) -> tuple[int, float, float]:
    """What `Result.finer` says."""
    layers = mp.sample_layers(
        case.robot,
        case.path,
        case.path.knots,
        task=case.task,
        samples=FINER * 720,
        scene=case.scene,
    )
    (parts, least), (kept_parts, kept_least) = (fewest_parts(layers, each) for each in (EPSILON, STEP))
    return parts, least, kept_least if kept_parts == parts else np.nan


def fewest_parts(layers: mp.Layers, epsilon: float) -> tuple[int, float]:
    """The fewest parts, 0 where no interruption helps, and the largest minimum manipulability with so few."""
    try:
        found = mp.fewest_interruptions(layers, epsilon)
        return found.parts, found.minimum
    except mp.errors.PlanningError:
        return 0, np.nan


def others() -> list[Case]:
    """The paths that others made."""
    return [
        Case(name=each.name, robot=each.robot, path=each.path, scene=each.scene, task=mp.Task.pose(), frame=each.frame)
        for each in tool_paths.load()
    ]


def made(count: int) -> list[Case]:
    """Random smooth paths with two cubes beside them, whose poses are all within reach."""
    panda, xarm7, ur5 = (mp.load_robot(name) for name in ("panda", "xarm7", "ur5"))
    ur5 = ur5.with_limits(lower=-np.pi, upper=np.pi)  # two turns of each joint give up to 64 times the candidates
    whole, pointing = mp.Task.pose(), mp.Task.pointing([0, 0, 1])
    arms = [
        ("panda", panda, whole, panda.tool),
        ("xarm7", xarm7, whole, xarm7.tool),
        ("ur5", ur5, pointing, ur5.tool),
        ("like Fetch", tool_paths.fetch_like(), whole, "gripper"),
    ]
    rng, cases = np.random.default_rng(0), []
    while len(cases) < count:
        name, robot, task, frame = arms[len(cases) % len(arms)]
        begin = robot.kinematics(mp.Task.pose()).pose(robot.random_configuration(rng))
        via = [begin]
        for _ in range(VIA - 1):
            moved = via[-1].copy()
            moved[:3, 3] += rng.uniform(-0.25, 0.25, 3)
            moved[:3, :3] = moved[:3, :3] @ Rotation.from_rotvec(rng.uniform(-0.6, 0.6, 3)).as_matrix()
            via.append(moved)
        path = mp.CartesianPath.through(mp.CartesianPath.through(via).sample(POSES))
        points = path(path.knots)[:, :3, 3]
        cubes: list[mp.Box] = []
        while len(cubes) < 2:
            centre, side = points[rng.integers(POSES)] + rng.normal(0, 0.2, 3), rng.uniform(0.1, 0.2)
            if np.linalg.norm(points - centre, axis=1).min() > side and np.linalg.norm(centre[:2]) > 0.3:
                cubes.append(mp.Box(size=(side,) * 3, position=centre, name=f"cube {len(cubes)}"))
        case = Case(name=f"made, {name}", robot=robot, path=path, scene=mp.Scene(cubes), task=task, frame=frame)
        try:
            mp.sample_layers(robot, path, 40, task=task, samples=180, scene=case.scene, spare=0.003)
            mp.sample_layers(robot, path, path.knots, task=task, scene=case.scene, spare=0.003)
        except mp.errors.InvalidInputError:
            continue  # out of reach, or no room
        cases.append(case)
    return cases


def long_path() -> mp.CartesianPath:
    """A polyline with four corners, the tool pointing down, through a thousand poses: steps of micrometres to centimetres."""
    way = np.append(0.0, np.linalg.norm(np.diff(CORNERS, axis=0), axis=1).cumsum())
    u = np.sort(np.append(way, way[-1] * np.random.default_rng(3).beta(0.4, 0.6, 1000)))
    u = u[np.append(True, np.diff(u) > 2e-6)]
    poses = np.tile(np.diag([1.0, -1.0, -1.0, 1.0]), (len(u), 1, 1))
    poses[:, :3, 3] = np.array([np.interp(u, way, column) for column in CORNERS.T]).T
    return mp.CartesianPath.through(poses)


def free_rows() -> list[str]:
    """The table of the long path."""
    path, eye = long_path(), np.eye(6)
    tasks = {
        "pose": (mp.Task.pose(), [0, 1, 2]),
        "one tool axis free": (mp.Task.pointing([0, 0, 1]), [0, 1, 2]),
        "orientation free": (mp.Task.position(), [0, 1, 2]),
        "height free": (mp.Task.custom(eye[[0, 1, 3, 4, 5]]), [0, 1]),
        "depth and turn of the tool free": (mp.Task.custom(eye[[0, 1, 3, 4]], frame="tool"), [0, 1]),
    }
    lines = [
        f"| rows that count, of {len(path.knots)} poses | arm | status | farthest given pose "
        "| minimum m of the motion through whole poses | minimum m with free rows | time |",
        "|---" * 7 + "|",
    ]
    for name in ("panda", "ur5"):
        robot = mp.load_robot(name)
        if name == "ur5":
            robot = robot.with_limits(lower=-np.pi, upper=np.pi)
        whole = mp.follow(robot, path)
        for label, (task, given) in tasks.items():
            began = time.process_time()
            plan = mp.follow(robot, path, objective=mp.PathObjective(task=task), throw=False)
            seconds = time.process_time() - began
            far, before = np.nan, np.nan
            if plan.status is mp.Status.FOLLOWED:
                data, frame, far = robot.model.createData(), robot.model.getFrameId(robot.tool), 0.0
                for q, pose in zip(plan.path(path.knots), path(path.knots), strict=True):
                    pin.framesForwardKinematics(robot.model, data, q)
                    far = max(far, float(np.abs((data.oMf[frame].translation - pose[:3, 3])[given]).max()))
                q = whole.trajectory(np.linspace(0, whole.trajectory.duration, TIMES))
                before = float(robot.kinematics(task).manipulability(q).min())
            reached = "-" if plan.report is None else f"{plan.report.min_manipulability:.3g}"
            lines.append(
                f"| {label} | {name} | {plan.status.name} | {1e3 * far:.4f} mm | {before:.3g} | {reached} | {seconds:.1f} s |"
            )
    return lines


def line(name: str, results: Sequence[Result]) -> str:
    """One row of the table."""
    compared = [each for each in results if each.finer is not None]
    connected = [each for each in compared if each.finer[0] == 1]
    cut = [each for each in compared if each.finer[0] > 1]
    moved = [each for each in results if each.parts]
    worst = np.max([each.worst for each in moved], axis=0) if moved else np.full(3, np.nan)
    alike = [each for each in compared if each.parts and each.parts == each.finer[0]]
    ratios = [np.array([each.least / each.finer[k] for each in alike if np.isfinite(each.finer[k])]) for k in (1, 2)]
    times = [[each.seconds for each in results if (each.parts == 1) is whole] for whole in (True, False)]
    cells = [
        name,
        len(results),
        f"{sum(each.parts == 1 for each in results)}",
        f"{sum(each.parts == 1 for each in connected)} of {len(connected)}",
        f"{sum(0 < each.parts <= each.finer[0] for each in cut)} of {len(cut)}",
        *(f"{np.median(each):.3f}, {each.min():.3f}" if len(each) else "" for each in ratios),
        f"{sum(each.kept for each in moved)} of {len(moved)}",
        f"{1e3 * worst[0]:.3f} mm, {np.rad2deg(worst[1]):.3f}°, {np.rad2deg(worst[2]):.1f}°",
        *(f"{np.median(each):.1f} s, {np.percentile(each, 95):.1f} s, {max(each):.1f} s" if each else "" for each in times),
    ]
    return "| " + " | ".join(map(str, cells)) + " |"


def print_times(cases: Sequence[Case]) -> None:
    """CPU times of the paths that are followed in one and of the others, without a judge."""
    for case in {case.name: case for case in cases}.values():
        planned(case, 9)
    times: dict[str, list[float]] = {}
    for case in track(cases, "paths made here"):
        plan, seconds = planned(case, 9)
        for name in (f"{case.name}: {plan.status.name}", "all"):
            times.setdefault(name, []).append(seconds)
    for name, each in sorted(times.items()):
        print(f"{name}: {len(each)}, {np.median(each):.1f} s, 95 % {np.percentile(each, 95):.1f} s, largest {max(each):.1f} s")


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--paths", type=int, default=200, help="number of paths made here")
    parser.add_argument(
        "--finer", type=int, default=24, help="number of them that are searched on the finer grid; 0: none, nor those of others"
    )
    parser.add_argument(
        "--times", action="store_true", help="only print times of the paths made here, and of the UR5's within ±360°"
    )
    parser.add_argument("--out", type=Path, default=OUT, help="the table's file")
    options = parser.parse_args(arguments)
    given = others()
    planned(given[0], 0)  # what is compiled at the first call does not count
    if options.times:
        cases, ur5 = made(options.paths), mp.load_robot("ur5")
        print_times(cases)
        print_times([replace(each, name="made, ur5, ±360°", robot=ur5) for each in cases if each.name == "made, ur5"])
        return
    outside = [
        follow(case, 2, finer=options.finer > 0 and case.robot.n < 8)  # two parameters would take 7,200² samples
        for case in track(given, "paths of others")
    ]
    cases = made(options.paths)
    own = [follow(case, 9, finer=k < options.finer) for k, case in enumerate(track(cases, "paths made here"))]
    columns = [
        "paths",
        "number",
        "followed without interruption",
        "of those that connect on the finer grid",
        "in as few parts as on the finer grid, of the others",
        "minimum m over that of the finer grid: median, least",
        "over that with joint steps up to 7° there",
        "CppFlow's rule kept",
        "worst pose, and joint step",
        "time without interruption: median, 95 %, largest",
        "time of the others",
    ]
    grid = f"Finer grid: {FINER * 720} samples at each given pose, for the paths of others and {options.finer} made ones; its "
    grid = f"{grid}motions may touch bodies between the poses. " if options.finer else ""
    lines = [
        "| " + " | ".join(columns) + " |",
        "|---" * len(columns) + "|",
        *(line(case.name, [result]) for case, result in zip(given, outside, strict=True)),
        *(
            line(name, [result for case, result in zip(cases, own, strict=True) if case.name == name])
            for name in dict.fromkeys(case.name for case in cases)
        ),
        line("all made", own),
        "",
        "Default arguments, but a tolerance of 0.1 mm and 0.1°, no retreat, and up to 9 interruptions, 2 of the paths of "
        f"others. {grid}The UR5's joints turn by ±180°. Where the tool leaves the path, the "
        "time has the planning of free motions in it. CPU time; "
        f"Python {platform.python_version()}, {platform.machine()}; command: `make benchmark`.",
        "",
        *free_rows(),
        "",
        "Manipulability m of the rows that count, on both motions.",
    ]
    options.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
