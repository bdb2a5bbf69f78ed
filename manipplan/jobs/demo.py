"""The two problems of `manipplan demo`: a Panda among five boxes, and the planar path (6.13) of kth2012."""

from dataclasses import dataclass

import numpy as np

from manipplan.collision.scene import Scene
from manipplan.collision.shapes import Box
from manipplan.robots.catalog import load_robot, planar_arm
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array

__all__ = ["DemoProblem", "panda_among_boxes", "planar_path"]


@dataclass(frozen=True, kw_only=True)
class DemoProblem:
    """A robot, its scene, start and goal (n,), the exponent of m, and the clearance [m]."""

    robot: Robot
    scene: Scene
    start: Array
    goal: Array
    power: float
    clearance: float


def panda_among_boxes() -> DemoProblem:
    """From beside a post on one side of a table to the other side; the straight motion passes close to a singularity."""
    scene = Scene(
        [
            Box(size=(0.9, 1.4, 0.05), position=(0.5, 0.0, -0.03), name="table"),
            Box(size=(0.10, 0.10, 0.45), position=(0.5, 0.0, 0.22), name="post"),
            Box(size=(0.35, 0.30, 0.03), position=(0.55, 0.42, 0.5), name="shelf"),
            Box(size=(0.22, 0.22, 0.2), position=(0.5, -0.45, 0.1), name="crate"),
            Box(size=(0.30, 0.30, 0.06), position=(0.25, 0.0, 1.15), name="lamp"),
        ]
    )
    return DemoProblem(
        robot=load_robot("panda"),
        scene=scene,
        start=np.array([-0.18, 0.07, -0.53, -2.09, -0.28, 1.93, -0.86]),
        goal=np.array([-1.53, -0.03, 2.63, -2.03, -0.5, 2.14, -0.63]),
        power=1.0,
        clearance=0.01,
    )


def planar_path() -> DemoProblem:
    """Problem (6.13) of kth2012: three unit links; its tables use the exponent 2."""
    return DemoProblem(
        robot=planar_arm([1.0, 1.0, 1.0]),
        scene=Scene(),
        start=np.array([0.0, 1.5, -2.0]),
        goal=np.array([np.pi, -2.0, 2.0]),
        power=2.0,
        clearance=0.0,
    )
