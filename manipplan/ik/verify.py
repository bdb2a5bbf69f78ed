"""Compiled checks of every pose and every solution: a pose is a rigid motion, and a solution reaches it."""

import numpy as np
from numpy.typing import NDArray

from manipplan.ik.native import calls, real, whole
from manipplan.support.checks import Array
from manipplan.support.tolerances import EXACT


def are_poses(poses: Array) -> bool:
    """Whether every matrix of poses (p, 4, 4) is a rotation and a translation, up to the rounding of double precision."""
    poses = real(poses)
    return bool(calls()["are_poses"](poses.ctypes.data, len(poses), EXACT))


def residuals(reached: Array, targets: Array, owners: NDArray[np.int64]) -> Array:
    """The largest entry (k,) of reached - targets[owners], of poses reached (k, 4, 4), targets (p, 4, 4) and owners (k,)."""
    reached, targets, owners, out = real(reached), real(targets), whole(owners), np.empty(len(reached))
    calls()["residuals"](reached.ctypes.data, targets.ctypes.data, owners.ctypes.data, len(reached), out.ctypes.data)
    return out
