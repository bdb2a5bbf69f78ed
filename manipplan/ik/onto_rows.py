"""Steps of an arm onto the rows of poses that count; the rest of the poses is free."""

import numpy as np
from numpy.typing import NDArray

from manipplan.kinematics.kinematics import Kinematics
from manipplan.support.checks import Array
from manipplan.symbolic.free_motion import FreeMotion

#: Maximum number of steps, and largest change of a joint in one of them [rad or m].
STEPS, LONGEST = 50, 0.3
#: Smallest damping, as a part of the sum of the squared singular values, for configurations where the task itself is singular.
DAMPING = 1e-14
#: The same from far away: number of steps, largest change, first damping, and its factors after a good and a bad step.
FAR_STEPS, FAR_LONGEST, FAR_DAMPING, BETTER, WORSE = 60, 0.5, 1e-3, 0.2, 4.0


def onto_rows(
    kinematics: Kinematics, free: FreeMotion, q: Array, poses: Array, moves: NDArray[np.bool_], tolerance: float
) -> Array:
    """Configurations (k, n) after minimum-norm steps from q (k, n) until what counts of poses (k, 4, 4) is reached.

    A row ends where its error [m, rad] is below the tolerance, or grows no smaller.

    Args:
        kinematics: of the whole pose.
        free: what does not count.
        q: where the steps begin.
        poses: targets.
        moves: (n,) the joints that may move.
        tolerance: see above.
    """
    best, least, rows = q.copy(), np.full(len(q), np.inf), np.arange(len(q))
    for _ in range(STEPS):
        error, jacobian = _errors(kinematics, free, q[rows], poses[rows])
        size = np.abs(error).max(axis=1, initial=0.0)
        better = size < least[rows]
        best[rows[better]], least[rows[better]] = q[rows[better]], size[better]
        rows, jacobian, error = (each[better & (size > tolerance)] for each in (rows, jacobian, error))
        if not len(rows):
            break
        step = _step(jacobian * moves, error, np.full(len(rows), DAMPING))
        q = q.copy()
        q[rows] += step * np.minimum(LONGEST / np.maximum(np.abs(step).max(axis=1), 1e-300), 1.0)[:, None]
    return best


def search_rows(
    kinematics: Kinematics, free: FreeMotion, q: Array, poses: Array, moves: NDArray[np.bool_], tolerance: float
) -> tuple[Array, Array]:
    """Configurations (k, n) inside the limits after damped steps from far-away ones, and their largest errors (k,) [m, rad].

    Levenberg-Marquardt steps [sugihara2011]; arguments as in `onto_rows`.
    """
    limits = kinematics.robot.limits
    q, rows, damping = q.copy(), np.arange(len(q)), np.full(len(q), FAR_DAMPING)
    error, jacobian = _errors(kinematics, free, q, poses)
    for _ in range(FAR_STEPS):
        step = _step(jacobian[rows] * moves, error[rows], damping[rows])
        tried = np.clip(q[rows] + np.clip(step, -FAR_LONGEST, FAR_LONGEST), limits.lower, limits.upper)
        after, slopes = _errors(kinematics, free, tried, poses[rows])
        good = np.square(after).sum(axis=1) < np.square(error[rows]).sum(axis=1)
        q[rows[good]], error[rows[good]], jacobian[rows[good]] = tried[good], after[good], slopes[good]
        damping[rows] = np.clip(damping[rows] * np.where(good, BETTER, WORSE), DAMPING, 1.0)
        rows = rows[(np.abs(error[rows]).max(axis=1) > tolerance) & (good | (damping[rows] < 1.0))]
        if not len(rows):
            break
    return q, np.abs(error).max(axis=1, initial=0.0)


def _errors(kinematics: Kinematics, free: FreeMotion, q: Array, poses: Array) -> tuple[Array, Array]:
    """What is missing (k, r) to poses (k, 4, 4) at q (k, n) [m, rad], and the rows (k, r, n) by which joints reduce it."""
    from scipy.spatial.transform import Rotation

    scale = np.array([1.0] * 3 + [1.0 / kinematics.task.length] * 3)
    reached = kinematics.pose(q)
    nearest = free.nearest(reached, poses)
    turns = Rotation.from_matrix(nearest[:, :3, :3] @ np.swapaxes(reached[:, :3, :3], 1, 2)).as_rotvec()
    counting = free.fixed_rows(nearest)
    error = counting @ np.hstack([nearest[:, :3, 3] - reached[:, :3, 3], turns])[:, :, None]
    return error[:, :, 0], counting @ (kinematics.jacobian(q) * scale[:, None])


def _step(jacobian: Array, error: Array, damping: Array) -> Array:
    """Minimum-norm steps (k, n), damped by parts (k,) of the trace."""
    square = jacobian @ np.swapaxes(jacobian, 1, 2)
    square += (damping * np.trace(square, axis1=1, axis2=2))[:, None, None] * np.eye(square.shape[1])
    return np.asarray((np.swapaxes(jacobian, 1, 2) @ np.linalg.solve(square, error[:, :, None]))[:, :, 0])
