"""Newton and damped steps of an arm until what counts of poses is reached; the rest of them is free."""

import numpy as np
from numpy.typing import NDArray

from manipplan.ik.descend import descend
from manipplan.kinematics.kinematics import Kinematics
from manipplan.support.checks import Array
from manipplan.symbolic.free_motion import FreeMotion

#: Maximum number of steps, and largest change of a joint in one of them [rad or m].
STEPS, LONGEST = 50, 0.3
#: Smallest damping, as a part of the sum of the squared singular values, for configurations where the task itself is singular.
DAMPING = 1e-14


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
    q, best, least, rows = q.copy(), q.copy(), np.full(len(q), np.inf), np.arange(len(q))
    for _ in range(STEPS):
        error, jacobian = errors_to(kinematics, free, q[rows], poses[rows])
        size = np.abs(error).max(axis=1, initial=0.0)
        better = size < least[rows]
        best[rows[better]], least[rows[better]] = q[rows[better]], size[better]
        rows, jacobian, error = (each[better & (size > tolerance)] for each in (rows, jacobian, error))
        if not len(rows):
            break
        jacobian = jacobian * moves
        square = jacobian @ np.swapaxes(jacobian, 1, 2)
        square += DAMPING * np.trace(square, axis1=1, axis2=2)[:, None, None] * np.eye(square.shape[1])
        step = (np.swapaxes(jacobian, 1, 2) @ np.linalg.solve(square, error[:, :, None]))[:, :, 0]
        q[rows] += step * np.minimum(LONGEST / np.maximum(np.abs(step).max(axis=1), 1e-300), 1.0)[:, None]
    return best


def search_rows(
    kinematics: Kinematics, free: FreeMotion, q: Array, poses: Array, moves: NDArray[np.bool_]
) -> tuple[Array, Array]:
    """Configurations (k, n) inside the limits after damped steps from far-away ones, and their largest errors (k,) [m, rad]."""
    q, error = descend(kinematics.robot.limits, lambda rows, q: errors_to(kinematics, free, q, poses[rows]), q, ~moves)
    return q, np.abs(error).max(axis=1, initial=0.0)


def errors_to(kinematics: Kinematics, free: FreeMotion, q: Array, poses: Array) -> tuple[Array, Array]:
    """What is missing (k, r) to poses (k, 4, 4) at q (k, n) [m, rad], and the rows (k, r, n) by which joints reduce it."""
    from scipy.spatial.transform import Rotation

    scale = np.array([1.0] * 3 + [1.0 / kinematics.task.length] * 3)
    reached = kinematics.pose(q)
    nearest = free.nearest(reached, poses)
    turns = Rotation.from_matrix(nearest[:, :3, :3] @ np.swapaxes(reached[:, :3, :3], 1, 2)).as_rotvec()
    counting = free.fixed_rows(nearest)
    error = counting @ np.hstack([nearest[:, :3, 3] - reached[:, :3, 3], turns])[:, :, None]
    return error[:, :, 0], counting @ (kinematics.jacobian(q) * scale[:, None])
