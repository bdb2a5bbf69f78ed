"""The courses that the arm follows: tool poses along a path, the start posture, and the duration."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation, RotationSpline

import manipplan as mp
from studies.dufour2020 import config

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True, eq=False)
class Course:
    """A path T(s) of the tool, followed from `start` (n,) in `duration` [s]; `origin` says how the path was made."""

    name: str
    origin: str
    path: mp.CartesianPath
    start: Array
    duration: float


@dataclass(frozen=True, kw_only=True, eq=False)
class Recorded(mp.CartesianPath):
    """The cubic splines through recorded poses (k, 4, 4) at s (k,), also where they leave the neighbourhood of the polygon."""

    s: Array
    poses: Array

    @property
    def knots(self) -> Array:
        return self.s

    @cached_property
    def _curve(self) -> tuple[CubicSpline, RotationSpline]:
        rotations = Rotation.from_matrix(self.poses[:, :3, :3])
        return CubicSpline(self.s, self.poses[:, :3, 3]), RotationSpline(self.s, rotations)

    def _at(self, s: Array) -> tuple[Array, Array]:
        positions, rotations = self._curve
        return positions(s), rotations(s).as_matrix()


def load_courses(kinematics: mp.Kinematics) -> dict[str, Course]:
    """S1, S2 and T1 to T5 by name."""
    start = np.array(config.UNTUCKED)
    low = kinematics.pose(start)
    high = low.copy()
    high[2, 3] += config.LINE_HEIGHT
    line = mp.CartesianPath.line(low, high)
    courses = [Course(name="S1", origin="vertical line", path=line, start=start, duration=config.LINE_DURATION)]
    planned = {each.name for each in config.PLANNED}
    for name in ("S2", *config.TABLE_1):
        table = np.loadtxt(config.PATHS / f"{name}.csv", delimiter=",", skiprows=1)
        given = mp.CartesianPath.through(kinematics.pose(table[:, 1:]))
        path = Recorded(s=given.s, poses=given.poses)
        origin = "OMPL" if name in planned else "demonstration"
        courses.append(Course(name=name, origin=origin, path=path, start=table[0, 1:], duration=float(table[-1, 0])))
    return {course.name: course for course in courses}
