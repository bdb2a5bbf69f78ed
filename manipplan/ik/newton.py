"""Newton steps on the arm as described: they refine closed-form solutions, and find solutions where there is no closed form."""

import math

import numpy as np
from numpy.typing import NDArray

from manipplan.ik.spherical import row
from manipplan.ik.subproblems import add, cross, sub, turn_by, turned, turned_about
from manipplan.support.checks import Array
from manipplan.support.compiling.kernels import kernel

#: Damping of the first step of a search, as a factor of the squared error.
DAMPING = 1e-2
#: Minimum damping relative to the trace of J Jᵀ: less is lost in rounding and does not keep the matrix regular.
LEAST = 1e-14


@kernel
def forward(axes: Array, points: Array, slides: NDArray[np.bool_], home: Array, q: Array, pose: Array, jacobian: Array) -> None:
    """Pose (4, 4) and Jacobian (6, n), LOCAL_WORLD_ALIGNED, at q (n,)."""
    n = len(q)
    for j in range(3):
        pose[0, j], pose[1, j], pose[2, j] = home[0, j], home[1, j], home[2, j]
    tip = (home[0, 3], home[1, 3], home[2, 3])
    for k in range(n - 1, -1, -1):
        h, p = row(axes, k), row(points, k)
        # the columns of later joints, the tip and the tool rotate with this joint
        if slides[k]:
            tip = (tip[0] + q[k] * h[0], tip[1] + q[k] * h[1], tip[2] + q[k] * h[2])
            jacobian[0, k], jacobian[1, k], jacobian[2, k] = h[0], h[1], h[2]
            jacobian[3, k], jacobian[4, k], jacobian[5, k] = 0.0, 0.0, 0.0
            continue
        turn = turn_by(q[k])
        tip = turned_about(h, p, turn, tip)
        for j in range(3):
            v = turned(h, turn, (pose[0, j], pose[1, j], pose[2, j]))
            pose[0, j], pose[1, j], pose[2, j] = v[0], v[1], v[2]
        for j in range(k + 1, n):
            v = turned(h, turn, (jacobian[0, j], jacobian[1, j], jacobian[2, j]))
            w = turned(h, turn, (jacobian[3, j], jacobian[4, j], jacobian[5, j]))
            jacobian[0, j], jacobian[1, j], jacobian[2, j] = v[0], v[1], v[2]
            jacobian[3, j], jacobian[4, j], jacobian[5, j] = w[0], w[1], w[2]
        v = cross(h, sub(tip, p))
        jacobian[0, k], jacobian[1, k], jacobian[2, k] = v[0], v[1], v[2]
        jacobian[3, k], jacobian[4, k], jacobian[5, k] = h[0], h[1], h[2]
    pose[0, 3], pose[1, 3], pose[2, 3] = tip[0], tip[1], tip[2]


@kernel
def _error(pose: Array, target: Array, out: Array) -> float:
    """Writes displacement and rotation vector (6,) from pose to target to `out`; returns the largest entry."""
    for i in range(3):
        out[i] = target[i, 3] - pose[i, 3]
    # R = target poseᵀ; its skew part is sin(angle) axis
    trace = 0.0
    skew = (0.0, 0.0, 0.0)
    for j in range(3):
        a = (pose[0, j], pose[1, j], pose[2, j])
        b = (target[0, j], target[1, j], target[2, j])
        trace += a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
        skew = add(skew, cross(a, b))
    sine = 0.5 * math.sqrt(skew[0] ** 2 + skew[1] ** 2 + skew[2] ** 2)
    angle = math.atan2(sine, 0.5 * (trace - 1.0))
    factor = 0.5 * (angle / sine if sine > 1e-9 else 1.0)
    largest = 0.0
    for i in range(3):
        out[3 + i] = factor * skew[i]
        largest = max(largest, abs(out[i]), abs(out[3 + i]))
    return largest


@kernel
def refine(
    axes: Array,
    points: Array,
    slides: NDArray[np.bool_],
    home: Array,
    targets: Array,
    owners: NDArray[np.int64],
    moves: NDArray[np.bool_],
    q: Array,
    steps: int,
    tolerance: float,
) -> None:
    """Minimum-norm Newton steps from each row of q (k, n), in place, with the joints marked in `moves`.

    A row ends once its pose is reached to `tolerance` [m, rad]; a step that does not reduce the error is rejected.
    """
    n = q.shape[1]
    pose, jacobian, error = np.eye(4), np.empty((6, n)), np.empty(6)
    trial = np.empty(n)
    for k in range(len(q)):
        target = targets[owners[k]]
        forward(axes, points, slides, home, q[k], pose, jacobian)
        miss = _error(pose, target, error)
        damping = LEAST
        for _ in range(steps):
            if miss <= tolerance or damping > 1e-2:
                break
            for j in range(n):
                if not moves[j]:
                    jacobian[:, j] = 0.0
            gram = jacobian @ jacobian.T
            size = np.trace(gram)
            for i in range(6):
                gram[i, i] += damping * size
            trial[:] = q[k] + jacobian.T @ np.linalg.solve(gram, error)
            forward(axes, points, slides, home, trial, pose, jacobian)
            nearer = _error(pose, target, error)
            if nearer < miss:
                miss, damping = nearer, max(damping / 100, LEAST)
                q[k] = trial
            else:  # near a singularity, where only short steps reduce the error
                damping *= 10
                forward(axes, points, slides, home, q[k], pose, jacobian)
                _error(pose, target, error)


@kernel
def search(
    axes: Array,
    points: Array,
    slides: NDArray[np.bool_],
    home: Array,
    target: Array,
    moves: NDArray[np.bool_],
    lower: Array,
    upper: Array,
    q: Array,
    steps: int,
    tolerance: float,
) -> Array:
    """Damped Newton steps (Levenberg-Marquardt, [sugihara2011]) from each row of q (k, n), in place, inside the limits.

    Joints stop at their limits and leave them when the step leads back. A row ends once its pose is reached to `tolerance`.
    Returns the largest entry (k,) of each row's error [m, rad].
    """
    n = q.shape[1]
    pose, jacobian, error = np.eye(4), np.empty((6, n)), np.empty(6)
    miss = np.empty(len(q))
    trial = np.empty(n)
    held = np.empty(n, dtype=np.bool_)
    for k in range(len(q)):
        damping = DAMPING
        forward(axes, points, slides, home, q[k], pose, jacobian)
        _error(pose, target, error)
        square = (error * error).sum()
        for _ in range(steps):
            if np.abs(error).max() <= tolerance:
                break
            gradient = jacobian.T @ error
            for j in range(n):
                at_limit = (q[k, j] <= lower[j] and gradient[j] < 0) or (q[k, j] >= upper[j] and gradient[j] > 0)
                held[j] = at_limit or not moves[j]
                if held[j]:
                    jacobian[:, j] = 0.0
            gram = jacobian @ jacobian.T
            least = LEAST * np.trace(gram)
            for i in range(6):
                gram[i, i] += damping * square + least
            trial[:] = q[k] + jacobian.T @ np.linalg.solve(gram, error)
            for j in range(n):
                if not held[j]:
                    trial[j] = min(max(trial[j], lower[j]), upper[j])
            forward(axes, points, slides, home, trial, pose, jacobian)
            _error(pose, target, error)
            now = (error * error).sum()
            if now < square:
                stalled = now > 0.999 * square and damping > 1e3
                q[k], square, damping = trial, now, max(damping / 4, 1e-6)
                if stalled:
                    break
            else:
                damping *= 8
                forward(axes, points, slides, home, q[k], pose, jacobian)
                _error(pose, target, error)
                if damping > 1e6:
                    break
        miss[k] = np.abs(error).max()
    return miss
