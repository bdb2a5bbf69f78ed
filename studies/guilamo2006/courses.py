"""The workspace paths: a circle in front of the robot, and a line to the edge of its reach."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import pinocchio as pin
from numpy.typing import ArrayLike, NDArray

import manipplan as mp
from studies.guilamo2006 import config

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True, eq=False)
class Course:
    """A path of the wrist with the number of its positions, and the robot that follows it."""

    name: str
    robot: mp.Robot
    path: mp.CartesianPath
    positions: int

    @cached_property
    def kinematics(self) -> mp.Kinematics:
        """Kinematics of the study's task."""
        return self.robot.kinematics(config.TASK)


def pose(position: ArrayLike, side: ArrayLike = config.SIDE) -> Array:
    """Pose of the wrist at `position` (3,), with the hand forward and horizontal and its x axis along `side` (3,)."""
    x, z = np.asarray(side, dtype=float), np.asarray(config.FORWARD)
    matrix = np.eye(4)
    matrix[:3, :3] = np.column_stack([x, np.cross(z, x), z])
    matrix[:3, 3] = position
    return matrix


def courses() -> tuple[Course, Course]:
    """Circle and line of the paper on TALOS."""
    robot = mp.load_robot(config.ROBOT)
    return _pair(robot, "", config.CENTRE, config.SIDE, config.LINE_END, 1.0)


def second_courses() -> tuple[Course, Course]:
    """The same on the second robot, scaled to its arm."""
    robot = mp.load_robot(config.SECOND)
    return _pair(robot, "second ", config.SECOND_CENTRE, config.SECOND_SIDE, config.SECOND_LINE_END, second_scale(robot))


def second_scale(robot: mp.Robot) -> float:
    """Arm length of the second robot, from shoulder to wrist, divided by that of TALOS."""
    return arm_length(robot, config.SECOND_SHOULDER) / arm_length(mp.load_robot(config.ROBOT), config.SHOULDER)


def arm_length(robot: mp.Robot, shoulder: str) -> float:
    """Largest distance [m] of the tool from a joint's origin, over random postures."""
    q = np.random.default_rng(0).uniform(robot.limits.lower, robot.limits.upper, (20_000, robot.n))
    data, joint, tool = robot.model.createData(), robot.model.getJointId(shoulder), robot.model.getFrameId(robot.tool)
    far = 0.0
    for each in q:
        pin.framesForwardKinematics(robot.model, data, each)
        far = max(far, float(np.linalg.norm(data.oMf[tool].translation - data.oMi[joint].translation)))
    return far


def furthest(course: Course, side: ArrayLike, samples: tuple[int, ...] | int) -> float:
    """How far forward [m] the line could end: the last whole centimetre that has a candidate on the grid."""
    x, y, z = course.path(1.0)[:3, 3]
    centimetre = round(100 * float(x)) - 10
    while len(mp.inverse_kinematics(course.robot, pose((centimetre / 100 + 0.01, y, z), side), samples=samples)):
        centimetre += 1
    return centimetre / 100


def _pair(robot: mp.Robot, prefix: str, centre: ArrayLike, side: ArrayLike, end: float, scale: float) -> tuple[Course, Course]:
    middle = np.asarray(centre, dtype=float)
    top = pose(middle + np.array([0.0, 0.0, scale * config.DIAMETER / 2]), side)
    circle = mp.CartesianPath.circle(top, middle, (1.0, 0.0, 0.0))
    last = np.array([end, *middle[1:]])
    line = mp.CartesianPath.line(pose(last - np.array([scale * config.LENGTH, 0.0, 0.0]), side), pose(last, side))
    return (
        Course(name=f"{prefix}circle", robot=robot, path=circle, positions=config.CIRCLE_POSITIONS),
        Course(name=f"{prefix}line", robot=robot, path=line, positions=config.LINE_POSITIONS),
    )
