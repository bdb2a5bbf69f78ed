"""Compiled checks of every pose and every solution: a pose is a rigid motion, and a solution reaches it."""

import math

import numpy as np
from numpy.typing import NDArray

from manipplan.ik.spherical import row
from manipplan.ik.subproblems import cross, dot
from manipplan.support.checks import ROTATION, Array
from manipplan.support.compiling.kernels import kernel


@kernel
def are_poses(poses: Array) -> bool:
    """Whether every matrix of poses (p, 4, 4) is a rotation and a translation."""
    for k in range(len(poses)):
        pose = poses[k]
        for i in range(4):
            for j in range(4):
                if not math.isfinite(pose[i, j]):
                    return False
            if abs(pose[3, i] - (1.0 if i == 3 else 0.0)) > ROTATION:
                return False
        for i in range(3):
            for j in range(i + 1):
                product = pose[0, i] * pose[0, j] + pose[1, i] * pose[1, j] + pose[2, i] * pose[2, j]
                if not abs(product - (1.0 if i == j else 0.0)) < ROTATION:
                    return False
        if dot(cross(row(pose, 0), row(pose, 1)), row(pose, 2)) <= 0:
            return False
    return True


@kernel
def residuals(reached: Array, targets: Array, owners: NDArray[np.int64]) -> Array:
    """The largest entry (k,) of reached - targets[owners], of poses reached (k, 4, 4), targets (p, 4, 4) and owners (k,)."""
    out = np.empty(len(reached))
    for k in range(len(reached)):
        worst = 0.0
        for i in range(3):
            for j in range(4):
                worst = max(worst, abs(reached[k, i, j] - targets[owners[k], i, j]))
        out[k] = worst
    return out
