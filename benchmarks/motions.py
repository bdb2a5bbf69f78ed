"""Timed motions of `mp.plan` and of mplib on the same problems, all judged by the same measures.

g and the minimum manipulability are those of our own integral, without a floor. Whether a motion is free is measured on the
arm's own meshes (meshes.py), after the planning, whose time it does not lengthen.
"""

import json
import os
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import numpy as np
from meshes import MeshModel
from numpy.typing import NDArray
from outside.problems import Problem
from scipy.spatial.transform import Rotation

import manipplan as mp

sys.path.insert(0, str(Path(__file__).parent / "peers"))
from run import run_peer  # its folder is put on the path first
from world import write_description  # the same

ENVIRONMENTS = Path(__file__).parents[1] / ".peers"
#: Limits count as kept up to this share of them.
KEPT = 1e-2
NAN = float("nan")


@dataclass(frozen=True, kw_only=True)
class Motion:
    """One motion, or none.

    Attributes:
        status: of our plan, or what a peer says.
        found: there is a timed motion.
        seconds, cpu: wall and processor time of planning [s].
        seed_cpu: the part of it until there is a first path [s].
        g, least: g and minimum manipulability along the motion.
        seed_g, seed_least: the same of our first path; g of both with the floor that was planned with.
        planned_g: our g with that floor.
        proven: our proof says that the motion is free between all samples.
        free: the meshes touch no obstacle; see meshes.py.
        kept: limits of position, velocity and acceleration are kept, for a peer up to KEPT.
    """

    status: str
    found: bool
    seconds: float
    cpu: float
    seed_cpu: float = NAN
    g: float = NAN
    least: float = NAN
    seed_g: float = NAN
    seed_least: float = NAN
    planned_g: float = NAN
    proven: bool = False
    free: bool = False
    kept: bool = False

    @property
    def over_seed(self) -> float:
        """g over that of the first path; NaN where it has none, or there is no motion."""
        return self.planned_g / self.seed_g if np.isfinite(self.seed_g) else NAN

    @property
    def least_over_seed(self) -> float:
        """Minimum manipulability over that of the first path."""
        return self.least / self.seed_least if self.seed_least > 0 else NAN


def of_ours(robot: mp.Robot, problem: Problem) -> Motion:
    """What `mp.plan` makes of a problem."""
    marks: dict[str, float] = {}

    def mark(_: float, step: str) -> None:
        marks.setdefault(step, time.process_time())

    began, used = time.perf_counter(), time.process_time()
    plan = mp.plan(robot, problem.start, problem.goal, problem.scene, throw=False, progress=mark)
    cpu, seconds = time.process_time() - used, time.perf_counter() - began
    times = {"status": plan.status.name, "seconds": seconds, "cpu": cpu}
    if plan.trajectory is None or plan.report is None:
        return Motion(found=False, **times)
    path, report = plan.trajectory.path(), plan.report
    cost = mp.path_cost(path, robot.kinematics(), 1.0)
    return Motion(
        found=True,
        seed_cpu=marks.get("optimising the path", used) - used,
        g=cost.g,
        least=cost.min_manipulability,
        seed_g=report.seed_g,
        seed_least=report.seed_min_manipulability,
        planned_g=report.g,
        proven=report.proven_clearance >= 0,
        free=MeshModel(robot, problem.scene).motion_is_free(path),
        kept=report.passed,
        **times,
    )


def of_mplib(
    robot: mp.Robot,
    problems: Sequence[Problem],
    *,
    time_limit: float = 10.0,
    environments: Path = ENVIRONMENTS,
    notify: Callable[[Sequence[int]], Sequence[int]] = list,
) -> list[Motion]:
    """What mplib makes of the problems; `notify` wraps the loop that judges its motions. RuntimeError: it does not run."""
    with tempfile.TemporaryDirectory() as folder:
        given = write_description(robot, Path(folder)) | {
            "starts": np.array([each.start for each in problems]),
            "goals": np.array([each.goal for each in problems]),
            "scenes": np.array([json.dumps([entry(obstacle) for obstacle in each.scene.obstacles]) for each in problems]),
            "time_limit": time_limit,
        }
        found = run_peer("mplib", given, environments, "paths")
    motions = []
    for k in notify(range(len(problems))):
        times = {"status": str(found["said"][k]), "seconds": float(found["time"][k]), "cpu": float(found["cpu"][k])}
        rows = found["row"] == k
        if not rows.any():
            motions.append(Motion(found=False, **times))
            continue
        q, qd, qdd = (found[name][rows] for name in ("q", "qd", "qdd"))
        path = through(found["t"][rows], q, qd)
        low, high = path.bounds()
        inside = max(robot.limits.outside(low).max(), robot.limits.outside(high).max()) <= KEPT
        use = max((np.abs(qd) / robot.limits.velocity).max(), (np.abs(qdd) / robot.limits.acceleration).max())
        ends = np.abs(np.array([q[0] - problems[k].start, q[-1] - problems[k].goal])).max()
        cost = mp.path_cost(path, robot.kinematics(), 1.0)
        motions.append(
            Motion(
                found=bool(ends <= 1e-6),
                g=cost.g,
                least=cost.min_manipulability,
                free=MeshModel(robot, problems[k].scene).motion_is_free(path),
                kept=bool(inside and use <= 1 + KEPT),
                **times,
            )
        )
    return motions


def entry(obstacle: mp.Obstacle) -> dict:
    """A box, cylinder or sphere for JSON."""
    turn = Rotation.from_matrix(obstacle.pose.rotation).as_quat(scalar_first=True)
    placed = {"position": obstacle.pose.translation.tolist(), "quaternion": turn.tolist()}
    if isinstance(obstacle, mp.Box):
        return placed | {"kind": "box", "size": [float(each) for each in obstacle.size]}
    if isinstance(obstacle, mp.Cylinder):
        return placed | {"kind": "cylinder", "radius": obstacle.radius, "length": obstacle.length}
    if isinstance(obstacle, mp.Sphere):
        return placed | {"kind": "sphere", "radius": obstacle.radius}
    raise TypeError(f"{obstacle.name} is a {type(obstacle).__name__}; allowed: boxes, cylinders and spheres")


def through(t: NDArray[np.float64], q: NDArray[np.float64], qd: NDArray[np.float64]) -> mp.JointPath:
    """The path of a motion with positions and velocities (k, n) at times t (k,) [s], by cubic pieces."""
    third = np.diff(t)[:, None] / 3
    control = np.stack([q[:-1], q[:-1] + third * qd[:-1], q[1:] - third * qd[1:], q[1:]], axis=1)
    return mp.JointPath(breaks=(t - t[0]) / (t[-1] - t[0]), control=control)


#: The columns of `beside`.
BESIDE = (
    "both solve",
    "ours free by the meshes",
    "mplib's free by the meshes",
    "mplib's within 1 % of its limits",
    "ours: processor time median, 95 %",
    "mplib's: processor time median, 95 %",
    "ours over mplib's, of each problem: median",
    "ours has lower g",
    "its g over ours: median",
    "its minimum manipulability over ours: median",
)


def beside(mine: Sequence[Motion], theirs: Sequence[Motion]) -> str:
    """The cells of a row that compares our motions with a peer's; the last four are of problems that both solve."""
    pairs = [(a, b) for a, b in zip(mine, theirs, strict=True) if a.found and b.found]
    lower = sum(a.g < b.g for a, b in pairs)
    g = [b.g / a.g for a, b in pairs if np.isfinite([a.g, b.g]).all()]
    least = [b.least / a.least for a, b in pairs if a.least > 0]
    clocks = [a.cpu / b.cpu for a, b in pairs]
    cells = [
        f"{len(pairs)} of {len(mine)}",
        f"{sum(each.free for each in mine)} of {sum(each.found for each in mine)}",
        f"{sum(each.free for each in theirs)} of {sum(each.found for each in theirs)}",
        f"{sum(each.kept for each in theirs)} of {sum(each.found for each in theirs)}",
        spread([each.cpu for each in mine]),
        spread([each.cpu for each in theirs]),
        middle(clocks),
        f"{lower} of {len(pairs)}",
        middle(g),
        middle(least),
    ]
    return " | ".join(cells)


def spread(seconds: Sequence[float]) -> str:
    """Median and 95 % of times [s]."""
    some = np.array(seconds)[np.isfinite(seconds)]
    return f"{np.median(some):.2f} s, {np.quantile(some, 0.95):.2f} s" if len(some) else ""


def middle(values: Sequence[float]) -> str:
    return f"{np.median(values):.2f}" if len(values) else ""
