"""Poses of a hand and of a part in the cell of the tests of programs."""

import numpy as np
import pinocchio as pin

import manipplan as mp

DOWN = np.diag([1.0, -1.0, -1.0, 1.0])


def pose_at(x, y, z, turn=0.0):
    pose = DOWN.copy()
    pose[:3, :3] = pin.rpy.rpyToMatrix(0, 0, turn) @ DOWN[:3, :3]
    pose[:3, 3] = x, y, z
    return pose


UPRIGHT = [pose_at(0.45, 0.3, 0.09, turn) for turn in np.arange(4) * np.pi / 2]


def carried_to(goal, *, first=None):
    """Steps that take up the part and bring it to a goal."""
    first = first or [mp.MoveTo(UPRIGHT, approach=0.1)]
    return [*first, mp.Attach("part"), mp.MoveAlong([0, 0, -0.1]), mp.MoveTo(goal, approach=0.1), mp.Detach("part")]


def part_pose(x, y, z, turn):
    pose = np.eye(4)
    pose[:3, :3] = pin.rpy.rpyToMatrix(0, 0, turn)
    pose[:3, 3] = x, y, z
    return pose


def placed_part(program):
    _, scene, _ = program.final_state
    return scene.obstacles[scene.names.index("part")].pose.homogeneous
