"""What controllers that look one step ahead reach of the best motion along a whole path.

Run with `make benchmark`. Writes docs/benchmarks/online_global.csv, online_global.md and docs/pictures/online_global.png.
Paths of five shapes by a seeded script, for four arms. `mp.follow` plans each motion as a whole; the controllers are those of
dufour2020, and ours. All get the path alone, and then a tube about it. Pinocchio on the original description judges them:
minimum manipulability, deviation from the pose of the moment, and limits.
"""

import argparse
import csv
import os
import platform
import sys
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import product
from pathlib import Path
from typing import Any

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import numpy as np
from description_judge import Judge
from matplotlib import rc_context
from matplotlib.figure import Figure
from numpy.typing import NDArray
from rich.progress import Progress
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation

import manipplan as mp
from manipplan.viz.style import STYLE

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT))
from studies.dufour2020 import config  # noqa: E402
from studies.dufour2020.quasi_newton import QuasiNewton  # noqa: E402

CSV = ROOT / "docs" / "benchmarks" / "online_global.csv"
PICTURE = ROOT / "docs" / "pictures" / "online_global.png"
Array = NDArray[np.float64]
f = mp.formulations

ARMS = ("panda", "ur5", "talos_right_arm", "baxter_left")
SHAPES = ("line", "circle", "wave", "turn", "random")
#: Time step [s], duration of a path over that of the fastest best motion along it, its minimum [s], and the duration in which
#: it is tried whether a motion exists [s].
DT, SLOWER, SHORTEST, SLOW = config.DT, 3.0, 2.0, 10.0
#: Tubes about the path that controllers keep and `mp.follow` may use: the default tolerance of `mp.follow`, and a wide one.
PATH = mp.Tolerance(position=1e-4, rotation=1e-3)
TUBE = mp.Tolerance(position=0.01, rotation=float(np.deg2rad(5)))
#: Stiffness of the task on the path and in the tube: the library's default, and Q_low of the study.
STIFFNESS = {"path": 1e4, "tube": config.STIFFNESS.low}
#: Deviation up to which a motion counts as on the path [m, rad], and share by which it may exceed the tube.
KEPT, OVER = (1e-3, 1e-2), 0.02
#: Random configurations among which the largest manipulability of an arm is found.
POSTURES = 100_000
#: Largest manipulability of the arm for which the study states α.
STUDIED = 0.14017
#: Gain k₀ of (7), the one that is best on two of the study's seven paths.
GAIN = 30.0
#: Samples of a best motion that are judged, and relative error of limits that counts as rounding.
JUDGED, ROUNDED = 400, 1e-6
#: Every how many samples self-collisions are looked for.
BESIDE = 5
#: Arguments of `mp.follow` for an arm without a closed form, whose configurations take seconds per position.
GRIDS: dict[str, dict[str, Any]] = {"baxter_left": {"positions": 10, "samples": 24, "epsilon": 0.5}}
#: What is allowed, and the starts, in words.
ALLOWED = {"path": "on the path", "tube": "in a tube of 10 mm and 5°"}
STARTS = {"best": "where the best motion starts", "posture": "posture of largest m"}
#: Share of the best minimum manipulability that counts as reached.
NEAR = 0.99
FORMULATIONS = ("(2)", "(7)", "(3)", "(10)", "(20)", "(14)", "LogDrive")
#: Those that cannot use a tube.
BARE = ("(2)", "(7)")
HEAD = (
    *("arm", "shape", "seed", "allowed", "status", "start", "best m", "bound", "best kept", "duration [s]"),
    *(column for name in FORMULATIONS for column in (name, f"{name} path")),
    "touching",
)
#: Colour and dash of each formulation.
LINES = {
    "(2)": ("#999999", ":"),
    "(7)": ("#E69F00", "-."),
    "(3)": ("#000000", "--"),
    "(10)": ("#0072B2", "-"),
    "(20)": ("#CC79A7", ":"),
    "(14)": ("#D55E00", "-"),
    "LogDrive": ("#009E73", "-"),
}


@dataclass(frozen=True, kw_only=True)
class Arm:
    """An arm, the task whose manipulability counts, and its judge."""

    name: str
    robot: mp.Robot
    task: mp.Task
    judge: Judge
    largest: float

    @classmethod
    @cache
    def of(cls, name: str) -> "Arm":
        """By its name in the catalogue."""
        robot = mp.load_robot(name)
        task = mp.Task.pose(length=1.0)
        if name == "ur5":  # with the turn about its axis free it has one redundant joint, as the other arms
            robot, task = robot.with_limits(lower=-np.pi, upper=np.pi), mp.Task.pointing([0, 0, 1], length=1.0)
        q = robot.random_configuration(np.random.default_rng(0), size=POSTURES)
        largest = float(robot.kinematics(task).manipulability(q).max())
        return cls(name=name, robot=robot, task=task, judge=Judge(robot.source.file, robot), largest=largest)

    def formulation(self, name: str) -> mp.formulations.Formulation:
        """With the α of the study, for a manipulability that is divided by its largest value."""
        share = STUDIED / self.largest
        return {
            "(2)": f.Classical(0.0),
            "(7)": f.Classical(GAIN * share),
            "(3)": f.General(),
            "(10)": f.Objective(config.ALPHA * share),
            "(20)": QuasiNewton(config.ALPHA * share, "bfgs-literal"),
            "(14)": f.Equality(config.ONE_ALPHA * share**2),
            "LogDrive": f.LogDrive(config.LOG_WEIGHT, rate=config.LOG_RATE),
        }[name]

    @cache  # noqa: B019  # the arms are few and live as long as the process
    def controller(self, name: str, allowed: str) -> mp.Controller:
        """The controller of a formulation on the path or in the tube."""
        tube = None if name in BARE else {"path": PATH, "tube": TUBE}[allowed]
        return mp.Controller(
            self.robot, self.formulation(name), dt=DT, task=self.task, stiffness=STIFFNESS[allowed], tolerance=tube
        )

    def __hash__(self) -> int:
        return hash(self.name)


@dataclass(frozen=True, kw_only=True)
class Case:
    """A path, and the best motions along it: on the path, and in the tube."""

    arm: Arm
    shape: str
    seed: int
    path: mp.CartesianPath
    best: dict[str, mp.Plan | mp.results.PartialPlan]

    @property
    def is_followed(self) -> bool:
        """Whether both motions were found."""
        return all(plan.status is mp.Status.FOLLOWED for plan in self.best.values())

    @property
    def duration(self) -> float:
        """Of the path for the controllers [s]."""
        return max(SHORTEST, SLOWER * self.best["path"].trajectory.duration)


@dataclass(frozen=True, kw_only=True)
class Judged:
    """A motion by the judge.

    Attributes:
        least: minimum manipulability; nan where it does not complete the path.
        share: s at which it leaves what is allowed; 1 where it does not.
        limits: whether limits hold.
        touches: whether links touch each other.
    """

    least: float
    share: float
    limits: bool
    touches: bool

    @property
    def whole(self) -> bool:
        """Whether it completes the path within limits."""
        return self.share == 1.0 and self.limits


def shape_of(shape: str, begin: Array, rng: np.random.Generator) -> mp.CartesianPath:
    """A path of a shape from a pose, mostly 0.2 to 0.6 m long; "turn" turns the tool by a radian nearly on the spot."""
    axis = rng.normal(size=3)
    axis /= np.linalg.norm(axis)
    across = np.cross(axis, rng.normal(size=3))
    across /= np.linalg.norm(across)
    length = rng.uniform(0.2, 0.6)

    def moved(shift: Array, turn: Array) -> Array:
        pose = begin.copy()
        pose[:3, 3] += shift
        pose[:3, :3] = pose[:3, :3] @ Rotation.from_rotvec(turn).as_matrix()
        return pose

    u = np.linspace(0.0, 1.0, 60)
    if shape == "line":
        return mp.CartesianPath.line(begin, moved(length * axis, rng.uniform(-0.5, 0.5, 3)))
    if shape == "circle":
        return mp.CartesianPath.circle(begin, begin[:3, 3] + length / (2 * np.pi) * across, axis)
    if shape == "wave":
        return mp.CartesianPath.through(
            [moved(0.7 * length * (x * axis + 0.15 * np.sin(4 * np.pi * x) * across), 0 * axis) for x in u]
        )
    if shape == "turn":
        return mp.CartesianPath.line(begin, moved(0.05 * axis, across))
    via = np.vstack([np.zeros(6), rng.uniform(-1, 1, (4, 6)).cumsum(axis=0) * np.repeat((0.15, 0.3), 3)])
    return mp.CartesianPath.through([moved(each[:3], each[3:]) for each in CubicSpline(np.linspace(0, 1, 5), via)(u)])


def timed(path: mp.CartesianPath, duration: float) -> tuple[Array, Array]:
    """Poses (N, 4, 4) after each step, with the cubic timing of `mp.track`, and their s (N,)."""
    steps = int(np.ceil(duration / DT - 1e-9))
    u = np.arange(1, steps + 1) / steps
    s = 3 * u**2 - 2 * u**3
    return path(s), s


def cases(name: str, count: int, *, number: int = 0, seed: int = -1) -> Iterator[Case]:
    """Paths that the arm follows from a random posture without a drive, so motions exist, in equal parts of each shape.

    Those after a `seed` begin with the shape of this `number`.
    """
    arm = Arm.of(name)
    kinematics = arm.robot.kinematics(mp.Task.pose())
    while number < count:
        seed += 1
        rng, shape = np.random.default_rng((ARMS.index(name), seed)), SHAPES[number % len(SHAPES)]
        q = arm.robot.random_configuration(rng)
        path = shape_of(shape, kinematics.pose(q), rng)
        exists = judge_steps(arm, path, arm.controller("(3)", "path"), q, SLOW, "path")
        if not exists.whole or exists.touches:
            continue
        try:
            case = Case(arm=arm, shape=shape, seed=seed, path=path, best=best_motions(arm, path))
        except mp.errors.InvalidInputError:
            continue  # a pose that the arm reaches only by touching itself, or with a link less than 0.1 mm from another
        number += case.is_followed
        yield case


def best_motions(arm: Arm, path: mp.CartesianPath) -> dict[str, mp.Plan | mp.results.PartialPlan]:
    """The motions of `mp.follow` on the path and in the tube."""
    return {
        allowed: mp.follow(
            arm.robot,
            path,
            objective=mp.PathObjective(task=arm.task),
            tolerance=tolerance,
            throw=False,
            **GRIDS.get(arm.name, {}),
        )
        for allowed, tolerance in (("path", None), ("tube", TUBE))
    }


def start_of(case: Case, start: str, allowed: str) -> Array:
    """Where a controller starts: as the best motion does, or at the collision-free posture of largest manipulability there."""
    if start == "best":
        return case.best[allowed].path(0.0)
    robot, task = case.arm.robot, case.arm.task
    q = mp.inverse_kinematics(robot, case.path(0.0), task=task, samples=GRIDS.get(case.arm.name, {}).get("samples")).q
    q = q[~mp.Scene([]).collision_model(robot).in_collision_rows(q)]
    return q[robot.kinematics(task).manipulability(q).argmax()]


def judge_steps(
    arm: Arm, path: mp.CartesianPath, controller: mp.Controller, start: Array, duration: float, allowed: str
) -> Judged:
    """What a controller makes of a path, up to its end."""
    targets, s = timed(path, duration)
    motion = controller.rollout(start, targets)
    acceleration = np.diff(motion.qd, axis=0) / DT
    limits, room = arm.robot.limits, 1 + ROUNDED
    kept = (
        (motion.q >= limits.lower - ROUNDED).all()
        and (motion.q <= limits.upper + ROUNDED).all()
        and (np.abs(motion.qd) <= room * limits.velocity).all()
        and (np.abs(acceleration) <= room * limits.acceleration).all()
    )
    return judge(arm, motion.q, np.concatenate([path(0.0)[None], targets]), np.append(0.0, s), allowed, limits=bool(kept))


def judge(arm: Arm, q: Array, targets: Array, s: Array, allowed: str, *, limits: bool) -> Judged:
    """A motion (N, n) beside the targets (N, 4, 4), at s (N,), by Pinocchio on the original description."""
    far = KEPT if allowed == "path" else ((1 + OVER) * TUBE.position, (1 + OVER) * TUBE.rotation)
    touches = bool(mp.Scene([]).collision_model(arm.robot).in_collision_rows(q[::BESIDE]).any())
    found = [arm.judge.pose_and_jacobian(each, arm.robot.tool) for each in q]
    poses, jacobians = np.array([pose for pose, _ in found]), np.array([jacobian for _, jacobian in found])
    moved = np.linalg.norm(poses[:, :3, 3] - targets[:, :3, 3], axis=1)
    if arm.task.free_axis is None:
        turned = 2 * np.arcsin(np.minimum(np.linalg.norm(poses[:, :3, :3] - targets[:, :3, :3], axis=(1, 2)) / np.sqrt(8), 1))
    else:  # of the tool's z-axis, about which the tool may turn
        turned = 2 * np.arcsin(np.minimum(np.linalg.norm(poses[:, :3, 2] - targets[:, :3, 2], axis=1) / 2, 1))
        turns = np.swapaxes(poses[:, :3, :3], 1, 2) @ jacobians[:, 3:]
        jacobians = np.concatenate([jacobians[:, :3], turns[:, :2]], axis=1)
    left = (moved > far[0]) | (turned > far[1])
    if left.any():
        return Judged(least=np.nan, share=float(s[left.argmax()]), limits=limits, touches=touches)
    least = float(np.linalg.svd(jacobians, compute_uv=False).prod(axis=1).min())
    return Judged(least=least, share=1.0, limits=limits, touches=touches)


def judge_best(case: Case, allowed: str) -> Judged:
    """The best motion; its joint path has the parameter s of the path."""
    s, plan = np.linspace(0.0, 1.0, JUDGED), case.best[allowed]
    return judge(case.arm, plan.path(s), case.path(s), s, allowed, limits=plan.report.passed)


def rows_of(case: Case) -> list[dict[str, object]]:
    """A row of the CSV for the path and the tube, and for each start; one without motions where `mp.follow` found none."""
    rows = []
    for allowed, plan in case.best.items():
        about = {"arm": case.arm.name, "shape": case.shape, "seed": case.seed, "allowed": allowed}
        if not case.is_followed:
            rows.append(about | {"status": plan.status.name})
            continue
        best = judge_best(case, allowed)
        for start in STARTS:
            q = start_of(case, start, allowed)
            row = about | {"status": plan.status.name, "start": start, "best m": f"{best.least:.5g}"}
            row |= {"bound": f"{plan.refinement.bound:.5g}", "best kept": best.whole, "duration [s]": f"{case.duration:.3g}"}
            touching = []
            for name in FORMULATIONS:
                if allowed == "tube" and name in BARE:
                    continue
                found = judge_steps(case.arm, case.path, case.arm.controller(name, allowed), q, case.duration, allowed)
                row |= {name: f"{found.least / best.least:.4f}" if found.whole else "", f"{name} path": f"{found.share:.3f}"}
                touching += [name] * found.touches
            rows.append(row | {"touching": "; ".join(touching)})
    return rows


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--paths", type=int, default=50, help="number of paths of each arm; 0: only table and picture again")
    parser.add_argument("--arms", nargs="+", choices=ARMS, default=ARMS, help="arms that are measured again")
    parser.add_argument("--further", action="store_true", help="continue an interrupted run")
    parser.add_argument("--csv", type=Path, default=CSV, help="file of all motions; its table is next to it")
    parser.add_argument("--picture", type=Path, default=PICTURE, help="file of the picture")
    options = parser.parse_args(arguments)
    with Progress() as progress:
        for name in options.arms if options.paths else ():
            found: list[Mapping[str, object]] = []
            if options.further:
                found += [row for row in read(options.csv) if row["arm"] == name]
            number = len({row["seed"] for row in found if row.get("start")})
            last = max((int(str(row["seed"])) for row in found), default=-1)
            bar = progress.add_task(name, total=options.paths, completed=number)
            for case in cases(name, options.paths, number=number, seed=last):
                found += rows_of(case)
                progress.advance(bar, int(case.is_followed))
                others = [row for row in read(options.csv) if row["arm"] != name]
                write(options.csv, sorted([*others, *found], key=lambda row: ARMS.index(str(row["arm"]))))
    rows = read(options.csv)
    lines = [*table(rows), "", f"Python {platform.python_version()}, {platform.machine()}; command: `make benchmark`."]
    options.csv.with_suffix(".md").write_text("\n".join(lines) + "\n")
    draw(rows, options.picture)
    print("\n".join(lines))


def shares(rows: Sequence[Mapping[str, str]], name: str) -> Array:
    """The minimum manipulability of a formulation over the best one, for each path; 0 where it does not complete the path."""
    return np.array([float(row[name] or 0.0) for row in rows])


def chosen(rows: Sequence[Mapping[str, str]], **wanted: str) -> list[Mapping[str, str]]:
    """The rows of paths with both motions that have the given values."""
    return [row for row in rows if row["start"] and all(row[key] == value for key, value in wanted.items())]


def table(rows: Sequence[Mapping[str, str]]) -> list[str]:
    """The two tables of the page: by formulation, and of the best motions by arm."""
    lines = [
        "| allowed | start | formulation | paths | completed within limits | path until it is left: median, worst tenth "
        "| minimum m over the best: median, worst tenth, worst of those completed | at least 0.99 of the best "
        "| links touch each other |",
        "|---" * 9 + "|",
    ]
    for allowed, start, name in product(ALLOWED, STARTS, FORMULATIONS):
        if allowed == "tube" and name in BARE:
            continue
        some = chosen(rows, allowed=allowed, start=start)
        reached, far = shares(some, name), np.array([float(row[f"{name} path"]) for row in some])
        whole = reached[reached > 0]
        touching = sum(name in row["touching"].split("; ") for row in some)
        lines.append(
            f"| {ALLOWED[allowed]} | {STARTS[start]} | {name} | {len(some)} | {len(whole)} "
            f"| {np.median(far):.2f}, {np.percentile(far, 10):.2f} "
            f"| {np.median(whole):.3f}, {np.percentile(whole, 10):.3f}, {whole.min():.3f} "
            f"| {np.mean(reached >= NEAR):.0%} | {touching} |"
        )
    lines += [
        "",
        "| arm | paths | paths left out, without both motions | best m on the path over its upper bound: median, worst "
        "| in the tube | m in the tube over that on the path: median, largest | both kept by the judge |",
        "|---" * 7 + "|",
    ]
    for arm in ARMS:
        pair = [chosen(rows, arm=arm, allowed=allowed, start="best") for allowed in ALLOWED]
        if not pair[0]:
            continue
        least = [np.array([float(row["best m"]) for row in some]) for some in pair]
        close = [each / np.array([float(row["bound"]) for row in some]) for each, some in zip(least, pair, strict=True)]
        gain = least[1] / least[0]
        kept = sum(all(row["best kept"] == "True" for row in both) for both in zip(*pair, strict=True))
        missing = len({row["seed"] for row in rows if row["arm"] == arm and not row["start"]})
        bounds = " | ".join(f"{np.median(each):.3f}, {each.min():.3f}" for each in close)
        lines.append(
            f"| {arm} | {len(gain)} | {missing} | {bounds} | {np.median(gain):.2f}, {gain.max():.2f} | {kept} of {len(gain)} |"
        )
    return lines


def draw(rows: Sequence[Mapping[str, str]], file: Path) -> None:
    """The share of paths on which each formulation reaches at least a share of the best minimum manipulability."""
    with rc_context(STYLE):
        figure = Figure(figsize=(9.5, 6.4), layout="constrained")
        axes = figure.subplots(len(ALLOWED), len(STARTS), sharex=True, sharey=True, squeeze=False)
        for (i, allowed), (j, start) in product(enumerate(ALLOWED), enumerate(STARTS)):
            some, ax = chosen(rows, allowed=allowed, start=start), axes[i][j]
            for name, (colour, dash) in LINES.items():
                if allowed == "tube" and name in BARE:
                    continue
                reached = np.sort(shares(some, name))[::-1]
                ax.plot(100 * np.arange(1, len(reached) + 1) / len(reached), reached, color=colour, linestyle=dash, label=name)
            ax.axhline(1.0, color="black", linewidth=0.7)
            ax.set(title=f"{ALLOWED[allowed]}; start: {STARTS[start]}", ylim=(-0.02, 1.15), xlim=(0, 100))
        for ax in axes[-1]:
            ax.set_xlabel("share of the paths [%], best first")
        for ax in axes[:, 0]:
            ax.set_ylabel("minimum m over that of the best motion")
        handles, labels = axes[0][0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside upper center", ncols=len(labels))
        figure.savefig(file, dpi=110, metadata={"Software": None})


def read(file: Path) -> list[dict[str, str]]:
    """The rows of the CSV, if there is one."""
    if not file.is_file():
        return []
    with file.open(newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def write(file: Path, rows: Sequence[Mapping[str, object]]) -> None:
    """Write the CSV."""
    with file.open("w", newline="", encoding="utf-8") as stream:
        writer = csv.DictWriter(stream, HEAD, restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


if __name__ == "__main__":
    main()
