"""Constant speeds of the tool: the largest that `mp.follow` keeps on a seam, and that of its best joint path at any speed.

Run with `make benchmark`. Writes docs/benchmarks/constant_speed.md. Seams: a winding one of 3.4 m with a free tool axis,
and the first paths of tool_paths.py for a Panda, an xArm7, a UR5 whose tool may turn about its axis, and an arm of Fetch's
geometry, smooth and through 200 poses with two cubes beside them.

Speeds that are refused are lowered to the one that the refusal names, and ones that are kept are raised, in at most two
calls. A motion counts where finite differences of Pinocchio's kinematics along it find the tool's speed constant to the share
that is allowed, between a tenth and nine tenths of the way of each part, and nowhere above it, and finite differences of the
joints find positions, velocities and accelerations within their limits. Times are CPU times.
"""

import os
import platform
import re
import time
from dataclasses import dataclass
from pathlib import Path

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray
from rich.progress import track
from tool_paths import Case, made

import manipplan as mp
from manipplan.timing.constant_speed import SpeedDemand

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "constant_speed.md"
#: Slowdown and interruptions that are allowed in turn, the default first, and way of the tool off the path [m].
ALLOWED, RETREAT = ((0.01, 0), (0.3, 0), (0.01, 2)), 0.0
#: Maximum number of calls for the largest speed, without those that are refused before work, which take less than a time [s];
#: and factor by which speeds rise, first with slowdown or interruptions above the largest one without.
CALLS, NO_WORK, RISE = 2, 0.2, 1.4
#: Number of times at which a motion is judged, so close that the tool moves straight between them, and by how much speeds and
#: limits may be exceeded for rounding.
TIMES, ROUNDED = 40001, 5e-3
#: A speed that no seam allows [m/s].
TOO_FAST = 20.0


@dataclass(frozen=True, kw_only=True)
class Result:
    """The largest speed that was kept, 0 for none.

    Attributes:
        speed: of the tool [m/s].
        parts: number of parts.
        least: minimum manipulability.
        seconds, refused: CPU time of the call, and of one that was refused [s].
        sound: whether the judge confirms the motion.
    """

    speed: float
    parts: int
    least: float
    seconds: float
    refused: float
    sound: bool


def winding() -> Case:
    """A seam of 3.4 m around the base, the tool pointing down and free to turn about its axis."""
    u = np.linspace(0, 1, 400)
    angle, radius = -2.6 + 7.4 * u, 0.45 + 0.05 * np.sin(9 * u)
    poses = np.tile(np.diag([1.0, -1.0, -1.0, 1.0]), (400, 1, 1))
    poses[:, :3, 3] = np.stack([radius * np.cos(angle), radius * np.sin(angle), 0.25 + 0.25 * u], axis=1)
    path, panda = mp.CartesianPath.through(poses), mp.load_robot("panda")
    return Case(name="winding", robot=panda, path=path, scene=mp.Scene(), task=mp.Task.pointing([0, 0, 1]), frame=panda.tool)


def cases() -> list[Case]:
    """The seams."""
    return [winding(), *made(4)]


def of_best_path(case: Case) -> tuple[float, float]:
    """The largest constant speed on the joint path that is chosen without a speed [m/s], and its minimum manipulability."""
    plan = mp.follow(case.robot, case.path, case.scene, objective=mp.PathObjective(task=case.task), throw=False)
    if plan.status is not mp.Status.FOLLOWED:
        return 0.0, np.nan
    try:
        SpeedDemand(speed=TOO_FAST).timed(plan.path, case.robot)
    except mp.errors.InvalidInputError as error:
        return named(error), float(plan.result.min_manipulability)
    return TOO_FAST, float(plan.result.min_manipulability)


def named(error: mp.errors.InvalidInputError) -> float:
    """The speed that a refusal names [m/s]; 0 for none."""
    found = re.search(r"at most ([\d.]+) m/s", str(error))
    return float(found.group(1)) if found else 0.0


def largest(case: Case, speed: float, slowdown: float, interruptions: int) -> Result:
    """The largest speed that `mp.follow` keeps, as far as CALLS of it find one, the first one at a given speed [m/s]."""
    best, refused = Result(speed=0.0, parts=0, least=np.nan, seconds=np.nan, refused=np.nan, sound=True), np.nan
    calls = 0
    while calls < CALLS:
        began = time.process_time()
        try:
            plan = mp.follow(
                case.robot,
                case.path,
                case.scene,
                tool_speed=speed,
                slowdown=slowdown,
                objective=mp.PathObjective(task=case.task),
                interruptions=interruptions,
                retreat=RETREAT,
                throw=False,
            )
        except mp.errors.InvalidInputError as error:
            seconds, speed = time.process_time() - began, named(error)
            calls, refused = (calls, refused) if seconds < NO_WORK else (calls + 1, seconds)
            if speed <= best.speed:
                break
            continue
        calls += 1
        if plan.status not in (mp.Status.FOLLOWED, mp.Status.FOLLOWED_IN_PARTS):
            break
        parts = plan.report.along
        best = Result(
            speed=speed,
            parts=len(parts),
            least=min(each.min_manipulability for each in parts),
            seconds=time.process_time() - began,
            refused=refused,
            sound=plan.report.passed
            and all(is_steady(case.robot, plan.trajectory, each.begin, each.end, speed, slowdown) for each in parts),
        )
        if np.isfinite(refused):
            break
        speed *= RISE
    return best


def is_steady(robot: mp.Robot, trajectory: mp.Trajectory, begin: float, end: float, speed: float, slowdown: float) -> bool:
    """Whether the tool has the speed, to a share, from a tenth of its way to nine tenths, and joints keep their limits."""
    t = np.linspace(begin, end, TIMES)
    data, frame, places = robot.model.createData(), robot.model.getFrameId(robot.tool), list[NDArray[np.float64]]()
    for each in trajectory(t):
        pin.framesForwardKinematics(robot.model, data, each)
        places.append(data.oMf[frame].translation.copy())
    steps = np.linalg.norm(np.diff(places, axis=0), axis=1)
    speeds, way = steps / np.diff(t), np.cumsum(steps) / steps.sum()
    between = speeds[(way > 0.1) & (way < 0.9)]
    q, limits, step = trajectory(t), robot.limits, t[1] - t[0]
    rates, changes = np.abs(np.diff(q, axis=0)) / step, np.abs(np.diff(q, 2, axis=0)) / step**2
    return bool(
        (limits.outside(q) <= ROUNDED).all()
        and (rates <= limits.velocity * (1 + ROUNDED)).all()
        and (changes <= limits.acceleration * (1 + ROUNDED)).all()
        and between.min() >= (1 - slowdown - ROUNDED) * speed
        and speeds.max() <= (1 + ROUNDED) * speed
    )


def main() -> None:
    lines = [
        "| seam | length | on its best joint path | chosen for the speed | times | minimum m: best, chosen | with slowdown=0.3 "
        "| with interruptions=2 | confirmed | time of a call: kept, refused |",
        "|---" * 10 + "|",
    ]
    for case in track(cases(), description="seams"):
        known, least = of_best_path(case)
        known = known or 0.1
        whole = largest(case, TOO_FAST, *ALLOWED[0])
        slowed, parted = (largest(case, RISE * (whole.speed or known), *each) for each in ALLOWED[1:])
        results = [whole, slowed, parted]
        parts = {0: "", 1: ", whole", 2: ", 2 parts", 3: ", 3 parts"}[parted.parts]
        cells = [
            case.name,
            f"{case.path.length:.2f} m",
            f"{known:.3g} m/s" if np.isfinite(least) else "-",
            f"{whole.speed:.3g} m/s" if whole.parts else "-",
            f"{whole.speed / known:.2f}" if whole.parts else "-",
            f"{least:.3g}, {whole.least:.3g}" if whole.parts else "-",
            f"{slowed.speed:.3g} m/s" if slowed.parts else "-",
            f"{parted.speed:.3g} m/s{parts}",
            f"{sum(each.sound for each in results if each.parts)} of {sum(each.parts > 0 for each in results)}",
            f"{whole.seconds:.1f} s, {whole.refused:.1f} s" if whole.parts else "-",
        ]
        lines.append("| " + " | ".join(cells) + " |")
        print(lines[-1], flush=True)
    lines += [
        "",
        "Speeds are those of the tool between ramps of at most a tenth of the way, kept to 1 % but with slowdown. "
        f"CPU time on one core; Python {platform.python_version()}, {platform.machine()}; command: `make benchmark`.",
    ]
    OUT.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
