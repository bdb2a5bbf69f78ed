"""Generates the joint paths of the study: `python -m studies.dufour2020.make_paths` writes paths/*.csv again.

The paper's paths are not public. A "demonstration" imitates an arm that is guided by hand: a smooth path through postures
with the slow wobble of a hand, sampled at 10 Hz and rounded to 0.1 mrad. It is computed; nobody guided an arm. The paths of
OMPL go around obstacles.
"""

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

import manipplan as mp
from studies.dufour2020.config import DEMONSTRATIONS, PATHS, PLANNED, ROBOT, SHELF, TABLE, Demonstration, Planned

Array = NDArray[np.float64]

RATE = 10.0  # [Hz]
RESOLUTION = 4  # digits of a radian
WOBBLE = 0.015  # [rad]
WOBBLE_FREQUENCIES = (0.4, 0.9)  # [Hz]
PLANNED_SAMPLES = 60


def main() -> None:
    """Write every path."""
    robot = mp.load_robot(ROBOT)
    for demonstration in DEMONSTRATIONS:
        t, q = demonstrated(robot, demonstration)
        write(robot, demonstration.name, t, q)
    for planned in PLANNED:
        t, q = found(robot, planned)
        write(robot, planned.name, t, q)


def demonstrated(robot: mp.Robot, demonstration: Demonstration) -> tuple[Array, Array]:
    """Times (k,) [s] and postures (k, n) [rad] of a path through the postures, from rest to rest, with a wobble."""
    via = np.array(demonstration.postures)
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(via, axis=0), axis=1))])
    curve = CubicSpline(along / along[-1], via)
    t = np.arange(0.0, demonstration.duration + 0.5 / RATE, 1 / RATE)
    u = t / demonstration.duration
    rng = np.random.default_rng(demonstration.seed)
    phases = rng.uniform(0, 2 * np.pi, (len(WOBBLE_FREQUENCIES), robot.n))
    waves = sum(np.sin(2 * np.pi * f * t[:, None] + phase) for f, phase in zip(WOBBLE_FREQUENCIES, phases, strict=True))
    q = curve(10 * u**3 - 15 * u**4 + 6 * u**5) + WOBBLE * np.sin(np.pi * u)[:, None] ** 2 * waves
    return t, np.clip(q, robot.limits.lower, robot.limits.upper)


def found(robot: mp.Robot, planned: Planned) -> tuple[Array, Array]:
    """Times and postures of OMPL's path around the obstacles, at even steps along it."""
    scene = mp.Scene([mp.Box(size=size, position=position) for size, position in (TABLE, SHELF)])
    path = mp.seed_path(
        robot, planned.start, planned.goal, scene, seeding=mp.Seeding(seed=planned.seed), clearance=planned.clearance
    )
    s = np.linspace(0.0, 1.0, PLANNED_SAMPLES)
    return s * planned.duration, path(s)


def write(robot: mp.Robot, name: str, t: Array, q: Array) -> None:
    """Write t and q as CSV."""
    rows = np.column_stack([np.round(t, 3), np.round(q, RESOLUTION)])
    header = ",".join(["t", *robot.joint_names])
    np.savetxt(
        PATHS / f"{name}.csv", rows, fmt=["%.3f", *[f"%.{RESOLUTION}f"] * robot.n], delimiter=",", header=header, comments=""
    )


if __name__ == "__main__":
    main()
