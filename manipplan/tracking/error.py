"""Error between a tool and its target, position and rotation, in the rows of a task."""

import casadi as ca
import numpy as np

from manipplan.support.checks import Array
from manipplan.support.tolerances import POSE
from manipplan.symbolic.chain import Placement
from manipplan.symbolic.task import Task


def task_error(task: Task, tool: Placement, target: Placement) -> ca.SX:
    """The displacement (m, 1) that brings the tool to its target, in the units of the task's rows; v T and ω T of (1).

    If the task leaves the rotation about one axis of the tool free, the rotation is the shortest that aligns this axis with
    the target's.
    """
    free = task.free_axis
    rotation = rotation_vector(target.rotation @ tool.rotation.T) if free is None else _aligning(tool, target, free)
    return task.rows_of(ca.vertcat(target.origin - tool.origin, rotation), tool.rotation)


def nearest_rotation(matrix: ca.SX) -> tuple[ca.SX, ca.SX]:
    """The rotation nearest to a matrix (3, 3), and whether it differs from that by no more than rounding.

    One Newton step of the polar decomposition, which leaves the square of a difference.
    """
    change = matrix @ (ca.SX.eye(3) - matrix.T @ matrix) / 2
    return matrix + change, ca.logic_and(ca.mmax(ca.fabs(change)) <= POSE, ca.det(matrix) > 0.5)


def rotation_vector(rotation: ca.SX) -> ca.SX:
    """ω (3, 1) [rad] with exp([ω]^) = R, of a length up to π; computed via the quaternion, so it is correct at π as well."""
    r = rotation
    # four times the products of a quaternion (w, x, y, z) with itself; the row of its largest entry has no cancellation
    rows = [
        (1 + r[0, 0] + r[1, 1] + r[2, 2], r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]),
        (r[2, 1] - r[1, 2], 1 + r[0, 0] - r[1, 1] - r[2, 2], r[1, 0] + r[0, 1], r[0, 2] + r[2, 0]),
        (r[0, 2] - r[2, 0], r[1, 0] + r[0, 1], 1 - r[0, 0] + r[1, 1] - r[2, 2], r[2, 1] + r[1, 2]),
        (r[1, 0] - r[0, 1], r[0, 2] + r[2, 0], r[2, 1] + r[1, 2], 1 - r[0, 0] - r[1, 1] + r[2, 2]),
    ]
    best, top = ca.vertcat(*rows[0]), rows[0][0]
    for k in range(1, 4):
        best = ca.if_else(rows[k][k] > top, ca.vertcat(*rows[k]), best)
        top = ca.fmax(top, rows[k][k])
    best = ca.if_else(best[0] < 0, -best, best)
    length = ca.sqrt(ca.sumsqr(best[1:]))
    small = length < 1e-12 * best[0]
    angle = 2 * ca.atan2(length, best[0])
    return ca.if_else(small, 2 / ca.if_else(small, best[0], 1), angle / ca.if_else(small, 1, length)) * best[1:]


def _aligning(tool: Placement, target: Placement, axis: Array) -> ca.SX:
    """The shortest rotation vector that aligns an axis of the tool with the target's; any half turn if they are opposed."""
    have, want = tool.rotation @ ca.DM(axis), target.rotation @ ca.DM(axis)
    across = ca.cross(have, want)
    sine, cosine = ca.sqrt(ca.sumsqr(across)), ca.dot(have, want)
    small = sine < 1e-12
    other = tool.rotation @ ca.DM(np.linalg.svd(axis[None, :])[2][1])
    turned = ca.atan2(sine, cosine) / ca.if_else(small, 1, sine) * across
    return ca.if_else(ca.logic_and(small, cosine < 0), np.pi * other, turned)
