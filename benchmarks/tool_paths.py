"""Tool paths by `mp.follow`: whether a connected motion is found where there is one, the fewest interruptions, and time.

Run with `make benchmark`. Writes docs/benchmarks/tool_paths.md. Paths that others made: CppFlow's two cubes and IKLink's
recording; paths of that kind by a seeded script: 200 poses of a smooth path with two cubes beside it, for a Panda, an xArm7,
and a UR5 whose tool may turn about its axis. They are judged by CppFlow's rule: each pose is met to 0.1 mm and 0.1°, no joint
moves more than 7° from one pose to the next, and the motion is free, here by Pinocchio and coal alone. Whether a connected
motion exists is searched on a grid ten times finer. Times are CPU times of whole calls.
"""

import argparse
import os
import platform
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray
from outside import tool_paths
from rich.progress import track
from scipy.optimize import minimize_scalar
from scipy.spatial.transform import Rotation

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "tool_paths.md"
#: CppFlow's rule: distance of each pose [m, rad] and joint step between poses [rad].
MET, STEP = (1e-4, np.deg2rad(0.1)), np.deg2rad(7.0)
#: How many times finer the grid is on which a connected motion is searched.
FINER = 10
#: Number of poses of a path made here, and of poses through which it is laid.
POSES, VIA = 200, 5
#: Corners of the long path [m].
CORNERS = np.array([[0.45, -0.2, 0.35], [0.6, -0.2, 0.35], [0.6, 0.2, 0.35], [0.45, 0.2, 0.45], [0.45, -0.1, 0.45]])
#: Number of times at which the tool is compared with the poses.
TIMES = 4000


@dataclass(frozen=True, kw_only=True)
class Case:
    """A path to follow among obstacles."""

    name: str
    robot: mp.Robot
    path: mp.CartesianPath
    scene: mp.Scene
    task: mp.Task


@dataclass(frozen=True, kw_only=True)
class Result:
    """What `mp.follow` made of a case.

    Attributes:
        parts: number of parts; 0 without a motion.
        kept: whether CppFlow's rule holds.
        worst: largest distance of a pose [m, rad] and joint step [rad].
        seconds: CPU time.
        finer: number of parts on the finer grid; 0 where no interruption helps.
    """

    parts: int
    kept: bool
    worst: tuple[float, float, float]
    seconds: float
    finer: int


def follow(case: Case, interruptions: int) -> Result:
    """Follow the path with positions at its poses, and judge the motion."""
    began = time.process_time()
    plan = mp.follow(
        case.robot,
        case.path,
        case.scene,
        positions=case.path.knots,
        epsilon=STEP,
        objective=mp.PathObjective(task=case.task),
        interruptions=interruptions,
        retreat=0.0,
        throw=False,
    )
    seconds = time.process_time() - began
    parts, worst, free = 0, (np.nan, np.nan, np.nan), False
    if plan.status in (mp.Status.FOLLOWED, mp.Status.FOLLOWED_IN_PARTS):
        parts = len(plan.report.along)
        worst = judge(case, plan)
        q = plan.trajectory(np.linspace(0, plan.trajectory.duration, TIMES))
        free = not case.scene.collision_model(case.robot).in_collision_rows(q).any()
    kept = free and worst[0] <= MET[0] and worst[1] <= MET[1] and worst[2] <= STEP
    return Result(parts=parts, kept=kept, worst=worst, seconds=seconds, finer=on_finer_grid(case))


def judge(case: Case, plan: mp.Plan) -> tuple[float, float, float]:
    """The largest distance of the given poses from the motion [m, rad], and joint step from one to the next [rad]."""
    robot, axis = case.robot, case.task.free_axis
    data, frame = robot.model.createData(), robot.model.getFrameId(robot.tool)

    def apart(t: float, pose: NDArray[np.float64]) -> tuple[float, float]:
        pin.framesForwardKinematics(robot.model, data, plan.trajectory(t))
        reached = data.oMf[frame].homogeneous
        if axis is not None:
            angle = float(np.arccos(np.clip((reached[:3, :3] @ axis) @ (pose[:3, :3] @ axis), -1, 1)))
        else:
            angle = float(Rotation.from_matrix(reached[:3, :3].T @ pose[:3, :3]).magnitude())
        return float(np.linalg.norm(reached[:3, 3] - pose[:3, 3])), angle

    far = turned = step = 0.0
    for part in plan.report.along:
        t = np.linspace(part.begin, part.end, TIMES)
        points = robot.kinematics().pose(plan.trajectory(t))[:, :3, 3]
        knots = case.path.knots[(case.path.knots >= part.s_begin - 1e-12) & (case.path.knots <= part.s_end + 1e-12)]
        before, last = None, 0
        for pose in case.path(knots):
            near = np.linalg.norm(points[last:] - pose[:3, 3], axis=1)
            best = last + int(near[: max(20, TIMES // 4)].argmin())
            last = best
            window = t[max(best - 1, 0)], t[min(best + 1, TIMES - 1)]
            found = minimize_scalar(
                lambda x, pose=pose: sum(apart(x, pose)), bounds=window, method="bounded", options={"xatol": 1e-9}
            )
            position, angle = min((apart(each, pose) for each in (found.x, *window)), key=sum)
            far, turned = max(far, position), max(turned, angle)
            q = plan.trajectory(found.x)
            step = max(step, 0.0 if before is None else float(np.abs(q - before).max()))
            before = q
    return far, turned, step


def on_finer_grid(case: Case) -> int:
    """The fewest parts on the finer grid; 0 where no interruption helps."""
    layers = mp.sample_layers(
        case.robot,
        case.path,
        case.path.knots,
        task=case.task,
        samples=FINER * 720,
        scene=case.scene,
    )
    try:
        return mp.fewest_interruptions(layers, STEP).parts
    except mp.errors.PlanningError:
        return 0


def others() -> list[Case]:
    """The paths that others made."""
    hand = tool_paths.robot()
    return [
        Case(name=each.name, robot=hand, path=each.path, scene=each.scene, task=mp.Task.pose()) for each in tool_paths.load()
    ]


def made(count: int) -> list[Case]:
    """Random smooth paths with two cubes beside them, whose poses are all within reach."""
    arms = [("panda", mp.Task.pose()), ("xarm7", mp.Task.pose()), ("ur5", mp.Task.pointing([0, 0, 1]))]
    rng, cases = np.random.default_rng(0), []
    while len(cases) < count:
        name, task = arms[len(cases) % len(arms)]
        robot = mp.load_robot(name)
        if name == "ur5":
            robot = robot.with_limits(lower=-np.pi, upper=np.pi)  # two turns of each joint give up to 64 times the candidates
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
        case = Case(name=f"made, {name}", robot=robot, path=path, scene=mp.Scene(cubes), task=task)
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
    connected = [each for each in results if each.parts == 1]
    possible = [each for each in results if each.finer == 1]
    cut = [each for each in results if each.finer > 1]
    moved = [each for each in results if each.parts]
    times = [[each.seconds for each in results if (each.parts == 1) is whole] for whole in (True, False)]
    worst = np.max([each.worst for each in moved], axis=0) if moved else np.full(3, np.nan)
    cells = [
        name,
        len(results),
        f"{len(connected)} of {len(possible)}",
        f"{sum(each.parts == each.finer for each in cut)} of {len(cut)}",
        f"{max((each.parts for each in moved), default=1) - 1}",
        f"{sum(each.kept for each in moved)} of {len(moved)}",
        f"{1e3 * worst[0]:.3f} mm, {np.rad2deg(worst[1]):.3f}°, {np.rad2deg(worst[2]):.1f}°",
        *(f"{np.median(each):.1f} s, {max(each):.1f} s" if each else "" for each in times),
    ]
    return "| " + " | ".join(map(str, cells)) + " |"


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--paths", type=int, default=12, help="number of paths made here")
    parser.add_argument("--out", type=Path, default=OUT, help="the table's file")
    options = parser.parse_args(arguments)
    follow(others()[0], 0)  # what is compiled at the first call does not count
    outside = [follow(case, 2) for case in track(others(), "paths of others")]
    cases = made(options.paths)
    own = [follow(case, 9) for case in track(cases, "paths made here")]
    lines = [
        "| paths | number | connected, of those connected on the finer grid | as few parts as on the finer grid, of the others "
        "| most interruptions | CppFlow's rule kept | worst pose, and joint step | time where connected: median, largest "
        "| time of the others |",
        "|---" * 9 + "|",
        *(line(case.name, [result]) for case, result in zip(others(), outside, strict=True)),
        *(
            line(name, [result for case, result in zip(cases, own, strict=True) if case.name == name])
            for name in dict.fromkeys(case.name for case in cases)
        ),
        "",
        f"Positions at the given poses, joint steps below 7°, no retreat; finer grid: {FINER * 720} samples at each pose "
        "and no spare clearance; the UR5's joints turn by ±180°. Where the tool leaves the path, the time has the planning of "
        f"free motions in it. CPU time; Python {platform.python_version()}, "
        f"{platform.machine()}; command: `make benchmark`.",
        "",
        *free_rows(),
        "",
        "Manipulability m of the rows that count, on both motions.",
    ]
    options.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
