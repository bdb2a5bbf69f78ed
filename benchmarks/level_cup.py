"""Level cup: a cup that a hand holds is carried among obstacles and must not spill. How often solved, how level, and time.

Run with `make benchmark`. Writes docs/benchmarks/level_cup.md. Scenes: three arms by turns; a cup is attached to the hand,
which holds it from its side or from above; start and goal are places over a table among random boxes, the goal with any turn
about the cup's axis; the limit is 5° to 20°. Outside problems: those of MotionBenchMaker, where the tool's axis stays within 5°
more than start and goal need around the direction between both. The tilt is measured by Pinocchio at samples between which no
joint moves by more than 1e-3 rad. Beside each stands the plan without the limit, by turns. Times are CPU times of whole calls
of `mp.plan`. A plan that is OPTIMAL is optimised again with the same limit, from its own path.
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
from outside import problems
from rich.progress import track
from scipy.spatial.transform import Rotation

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "level_cup.md"
#: The arms, with how far a cup may be from the base [m].
ARMS = {"panda": (0.3, 0.65), "ur5": (0.35, 0.7), "xarm7": (0.3, 0.6)}
#: Distance between samples of the tilt [rad], and how much more than the limit counts as kept [rad].
STEP, KEPT = 1e-3, 1e-6
#: What a limit of an outside problem leaves beyond the tilt of start and goal [rad].
ROOM = np.deg2rad(5.0)


@dataclass(frozen=True, kw_only=True)
class Carry:
    """A motion with a level tool.

    Attributes:
        set: name of the set.
        status: of the plan; "" without a motion that passed its check.
        excess: largest tilt beyond the limit [rad].
        minimum: minimum manipulability.
        seconds, free_seconds: CPU time with and without the limit [s].
        free_excess: largest tilt beyond the limit of the plan without one [rad]; nan without a plan.
        again, fall: status of an OPTIMAL plan optimised again, and the share by which g fell; "" and nan for others.
    """

    set: str
    status: str
    excess: float
    minimum: float
    seconds: float
    free_seconds: float
    free_excess: float
    again: str
    fall: float


def tilt_excess(robot: mp.Robot, trajectory: mp.Trajectory, limit: mp.TiltLimit) -> float:
    """The largest angle beyond a limit on a trajectory [rad], by Pinocchio."""
    data, frame = robot.model.createData(), robot.model.getFrameId(robot.tool)
    path, worst = trajectory.path(), -np.inf
    for q in path(path.fine_samples(STEP)):
        pin.forwardKinematics(robot.model, data, q)
        rotation = pin.updateFramePlacement(robot.model, data, frame).rotation
        axis, direction = rotation @ np.array(limit.axis), np.array(limit.direction)
        angle = np.arctan2(np.linalg.norm(np.cross(axis, direction)), axis @ direction)
        worst = max(worst, float(angle) - limit.angle)
    return worst


def planned(
    robot: mp.Robot, start: NDArray[np.float64], goal: object, scene: mp.Scene, constraints: Sequence[mp.Constraint]
) -> tuple[mp.results.PartialPlan | None, float]:
    """A plan, None where no goal can be used, and its CPU time [s]."""
    began = time.process_time()
    try:
        plan = mp.plan(robot, start, goal, scene, constraints=constraints, throw=False)
    except mp.errors.InvalidInputError:
        plan = None
    return plan, time.process_time() - began


def carried(
    name: str, robot: mp.Robot, start: NDArray[np.float64], goal: object, scene: mp.Scene, limit: mp.TiltLimit, k: int
) -> Carry:
    """The motion with a limit and without, of every other problem that without first."""
    made = {}
    for constrained in (True, False) if k % 2 == 0 else (False, True):
        made[constrained] = planned(robot, start, goal, scene, [limit] if constrained else [])
    (plan, seconds), (free, free_seconds) = made[True], made[False]
    passed = isinstance(plan, mp.Plan) and plan.report.passed
    again, fall = "", np.nan
    if passed and plan.status is mp.Status.OPTIMAL:
        seeding = mp.Seeding(initial=plan.path)
        ends = plan.path.start, plan.path.goal
        second = mp.optimize_path(robot, *ends, scene, constraints=[limit], seeding=seeding, throw=False)
        again, fall = second.status.name, 1 - second.g / plan.result.g
    return Carry(
        set=name,
        status=plan.status.name if passed else "",
        excess=tilt_excess(robot, plan.trajectory, limit) if passed else np.nan,
        minimum=plan.report.min_manipulability if passed else np.nan,
        seconds=seconds,
        free_seconds=free_seconds,
        free_excess=tilt_excess(robot, free.trajectory, limit) if isinstance(free, mp.Plan) else np.nan,
        again=again,
        fall=fall,
    )


def cup_scene(rng: np.random.Generator, reach: tuple[float, float]) -> tuple[mp.Scene, list[NDArray[np.float64]]]:
    """A table with boxes, and two places of the cup's middle above it."""
    height = rng.uniform(-0.05, 0.2)
    obstacles: list[mp.Obstacle] = [mp.Box(size=(0.9, 1.8, 0.04), position=(0.65, 0.0, height - 0.12), name="table")]
    places = []
    for side in (-1, 1):
        far, angle = rng.uniform(*reach), side * rng.uniform(0.2, 1.2)
        places.append(np.array([far * np.cos(angle), far * np.sin(angle), height + rng.uniform(0.0, 0.25)]))
    for k in range(rng.integers(2, 6)):
        size = rng.uniform([0.05, 0.05, 0.1], [0.15, 0.2, 0.45])
        place = np.array([rng.uniform(0.3, 0.9), rng.uniform(-0.6, 0.6), height - 0.1 + size[2] / 2])
        if all(np.linalg.norm((place - each)[:2]) > 0.2 for each in places):
            obstacles.append(mp.Box(size=size, position=place, name=f"box {k}"))
    return mp.Scene(obstacles), places


def cup_problem(arms: dict[str, mp.Robot], name: str, rng: np.random.Generator):
    """A robot that holds a cup, a start, a goal, a scene, and the limit."""
    while True:
        from_above = rng.random() < 0.5
        axis = np.array([0.0, 0.0, -1.0]) if from_above else np.array([rng.choice([-1.0, 1.0]), 0.0, 0.0])
        turn = Rotation.align_vectors([axis], [[0.0, 0.0, 1.0]])[0]
        middle = np.array([0.0, 0.0, 0.06 if from_above else 0.03])
        cup = mp.Cylinder(radius=0.03, length=0.1, position=middle, rotation=turn.as_matrix())
        robot = arms[name].attach(cup, name="cup")
        scene, places = cup_scene(rng, ARMS[name])
        poses = []
        for place in places:
            pose = np.eye(4)
            upright = Rotation.align_vectors([[0.0, 0.0, 1.0]], [axis])[0]
            pose[:3, :3] = (Rotation.from_euler("z", rng.uniform(-np.pi, np.pi)) * upright).as_matrix()
            pose[:3, 3] = place
            poses.append(pose)
        model = scene.collision_model(robot)
        ways = [mp.inverse_kinematics(robot, pose).q for pose in poses]
        free = [q[~model.in_collision_rows(q, clearance=0.002)] if len(q) else q for q in ways]
        if all(len(q) for q in free):
            start = free[0][rng.integers(len(free[0]))]
            limit = mp.TiltLimit(axis, (0.0, 0.0, 1.0), np.deg2rad(rng.uniform(5.0, 20.0)))
            return robot, start, mp.PoseGoal(poses[1], free_axis=axis), scene, limit


def scenes(count: int) -> list[Carry]:
    """The cups of our scenes."""
    rng, arms = np.random.default_rng(0), {name: mp.load_robot(name) for name in ARMS}
    found = []
    for k in track(range(count), description="cups"):
        name = list(ARMS)[k % len(ARMS)]
        robot, start, goal, scene, limit = cup_problem(arms, name, rng)
        found.append(carried(name, robot, start, goal, scene, limit, k))
    return found


def outside(count: int) -> list[Carry]:
    """The first problems of each set of MotionBenchMaker whose start and goal are free."""
    robot, left, found = problems.robot("panda"), {}, []
    kinematics = robot.kinematics()
    for each in track(problems.load("panda"), description="MotionBenchMaker"):
        ends = np.array([each.start, each.goal])
        if left.setdefault(each.set, count) == 0 or (robot.limits.outside(ends) > 0).any():
            continue
        if each.scene.collision_model(robot).in_collision_rows(ends).any():
            continue
        left[each.set] -= 1
        axes = kinematics.pose(ends)[:, :3, 2]
        between = axes.sum(axis=0)
        angle = float(np.arccos(np.clip(axes[0] @ axes[1], -1.0, 1.0))) / 2 + ROOM
        if angle >= np.pi / 2 or np.linalg.norm(between) < 0.1:
            continue
        limit = mp.TiltLimit((0.0, 0.0, 1.0), between, angle)
        found.append(carried(each.set, robot, each.start, each.goal, each.scene, limit, len(found)))
    return found


def line(name: str, cups: Sequence[Carry]) -> str:
    """The line of a set."""
    solved = [each for each in cups if each.status]
    cells = [name, len(cups), len(solved), sum(each.status == "OPTIMAL" for each in solved)]
    if solved:
        excess = max(each.excess for each in solved)
        cells += ["none" if excess <= KEPT else f"{excess:.1e} rad"]
        cells += [sum(each.free_excess > KEPT for each in cups)]
        times, ratios = (np.array(x) for x in zip(*((e.seconds, e.seconds / e.free_seconds) for e in solved), strict=True))
        cells += [
            f"{np.median(times):.2f} s",
            f"{np.quantile(times, 0.9):.2f} s",
            f"{times.max():.1f} s",
            f"{np.median(ratios):.1f}",
        ]
        falls = [each.fall for each in solved if each.again]
        kept = sum(each.again == "OPTIMAL" for each in solved)
        cells += [f"{kept} of {len(falls)}; {max(falls):.0e}" if falls else "none OPTIMAL"]
    return "| " + " | ".join(map(str, cells)) + " |"


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scenes", type=int, default=100, help="number of scenes with a cup")
    parser.add_argument("--problems", type=int, default=6, help="number of problems of each set of MotionBenchMaker")
    parser.add_argument("--out", type=Path, default=OUT, help="the table's file")
    options = parser.parse_args(arguments)
    cups, others = scenes(options.scenes), outside(options.problems)
    lines = [
        "| problems | number | solved | OPTIMAL | tilt above the limit | plans without a limit that tilt more | median time "
        "| 90 % | largest | median ratio to the time without | OPTIMAL again; largest share by which g falls |",
        "|---" * 11 + "|",
        *(line(f"cup, {name}", [each for each in cups if each.set == name]) for name in ARMS),
        line("**all cups**", cups),
        *(line(name, [each for each in others if each.set == name]) for name in dict.fromkeys(each.set for each in others)),
        line("**MotionBenchMaker**", others),
        "",
        f"{options.scenes} scenes with a cup; the first {options.problems} free problems of each set of MotionBenchMaker. "
        f"Tilts at samples {STEP:g} rad apart; up to {KEPT:g} rad above the limit counts as none. CPU time of plans solved; "
        f"of which each has 10 s; Python {platform.python_version()}, {platform.machine()}; command: `make benchmark`.",
    ]
    options.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
