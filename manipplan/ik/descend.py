"""descend: damped steps of joints inside their limits that reduce what is missing to a goal."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from manipplan.robots.limits import JointLimits
from manipplan.support.checks import Array

#: Number of steps, first damping of a step, its factors after a good and a bad step, and the largest change of a joint in one
#: step [rad or m].
STEPS, DAMPING, BETTER, WORSE, LONGEST = 60, 1e-2, 1 / 3, 4.0, 0.5
#: Size of the miss at which no more steps are made [m].
DONE = 1e-11


def descend(
    limits: JointLimits, missing: Callable[[NDArray[np.intp], Array], tuple[Array, Array]], q: Array, held: NDArray[np.bool_]
) -> tuple[Array, Array]:
    """Configurations (k, n) inside the limits after damped steps from q (k, n), and what they miss (k, r) [m].

    `missing` gives what rows (j,) with configurations (j, n) miss (j, r), and its slopes (j, r, n). The held joints stay.
    """
    q, lower, upper = q.copy(), limits.lower, limits.upper
    rows = np.arange(len(q))
    miss, slopes = missing(rows, q)
    damping = np.full(len(q), DAMPING)
    for _ in range(STEPS):
        slope = slopes[rows] * ~held
        step = _damped_step(slope, miss[rows], damping[rows])
        # a joint at a limit that the step would take further does not move
        stuck = ((q[rows] <= lower) & (step < 0)) | ((q[rows] >= upper) & (step > 0))
        step = _damped_step(slope * ~stuck[:, None, :], miss[rows], damping[rows])
        moved = np.clip(q[rows] + step, lower, upper)
        left, bent = missing(rows, moved)
        good = (left**2).sum(axis=1) < (miss[rows] ** 2).sum(axis=1)
        q[rows[good]], miss[rows[good]], slopes[rows[good]] = moved[good], left[good], bent[good]
        damping[rows] = np.clip(np.where(good, BETTER, WORSE) * damping[rows], 1e-12, 1e6)
        rows = np.flatnonzero(np.linalg.norm(miss, axis=1) > DONE)
        if not len(rows):
            break
    return q, miss


def _damped_step(jacobian: Array, miss: Array, damping: Array) -> Array:
    """Damped steps (k, n) of the joints that reduce the miss (k, r)."""
    turned = np.swapaxes(jacobian, 1, 2)
    solved = np.linalg.solve(jacobian @ turned + damping[:, None, None] * np.eye(miss.shape[1]), miss[:, :, None])
    return np.asarray(np.clip((turned @ solved)[:, :, 0], -LONGEST, LONGEST))
