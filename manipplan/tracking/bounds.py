"""Bounds on a step's joint velocities that are recursively feasible: they keep every limit and are never empty.

A step sets the velocity v⁺ for a time T, in which the joint moves by T v⁺. A state is viable when the joint can still stop
inside its limits. Each bound keeps the next state viable, so the next interval contains at least the braking velocity.

Error between a tool and its target, position and rotation, in the rows of a task.
"""

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from manipplan.robots.limits import JointLimits
from manipplan.support.checks import POSE, Array
from manipplan.symbolic.chain import Placement
from manipplan.symbolic.task import Task


def velocity_bounds(
    q: ca.SX, qd: ca.SX, qdd: ca.SX, limits: JointLimits, dt: float, *, step: ca.SX | None = None
) -> tuple[ca.SX, ca.SX]:
    """Lower and upper bounds (n,) of the next velocity at (q, qd), each (n,), where the last step accelerated by qdd.

    Where time steps differ, this one takes `step` [s], and a joint then stops in time by steps of any length. Jerk limits are
    kept in steps of `dt`.

    From a viable state all limits hold exactly. From a state that cannot stop in time, position and velocity limits come
    first: the joint exceeds its acceleration limit by as little as necessary. A jerk limit is kept as well, as long as the
    state allows.
    """
    bounds = [_bounds_of(q[i], qd[i], qdd[i], limits, i, dt, step) for i in range(limits.n)]
    return ca.vertcat(*(low for low, _ in bounds)), ca.vertcat(*(high for _, high in bounds))


def limits_jerk(limits: JointLimits, dt: float) -> bool:
    """Whether a jerk limit matters at this time step."""
    return bool(_binds(limits, dt).any())


def _binds(limits: JointLimits, dt: float) -> NDArray[np.bool_]:
    """Where two accelerations within their limit can differ by more than the jerk limit allows in one step, (n,)."""
    return np.asarray(np.isfinite(limits.jerk) & (limits.jerk * dt < 2 * limits.acceleration))


def _bounds_of(q: ca.SX, v: ca.SX, a: ca.SX, limits: JointLimits, i: int, dt: float, step: ca.SX | None) -> tuple[ca.SX, ca.SX]:
    speed, acceleration = float(limits.velocity[i]), float(limits.acceleration[i])

    def fastest(room: ca.SX) -> ca.SX:
        if step is None:
            return _fastest(room, speed, acceleration, dt)
        return _fastest_of_any_steps(room, speed, acceleration, step)

    room_below, room_above = q - float(limits.lower[i]), float(limits.upper[i]) - q
    lowest = -fastest(room_below) if np.isfinite(limits.lower[i]) else ca.SX(-speed)
    highest = fastest(room_above) if np.isfinite(limits.upper[i]) else ca.SX(speed)
    lowest = ca.fmin(lowest, highest)
    low, high = lowest, highest
    if np.isfinite(acceleration):
        change = acceleration * (dt if step is None else step)
        low, high = _clip(v - change, lowest, highest), _clip(v + change, lowest, highest)
    if _binds(limits, dt)[i]:
        inner = _with_jerk((low, high), (q, v, a), limits, i, dt)
        if step is None:
            return inner
        usual = ca.fabs(step - dt) <= 1e-9 * dt
        return ca.if_else(usual, inner[0], low), ca.if_else(usual, inner[1], high)
    return low, high


def _fastest(room: ca.SX, speed: float, acceleration: float, dt: float) -> ca.SX:
    """The largest velocity from which a joint can stop within `room` [rad or m], within ±speed.

    Braking by c = A T per step from v = (K + r) c, 0 <= r < 1, takes T ((K + 1) v - c K (K + 1) / 2). Its inverse is exact.
    Outside the limits (room < 0): the velocity that returns in one step.
    """
    if np.isinf(acceleration):
        return _clip(room / dt, -speed, speed)
    change = acceleration * dt
    steps = ca.floor((ca.sqrt(1 + 8 * ca.fmax(room, 0) / (dt * change)) - 1) / 2)
    return _clip(room / (dt * (steps + 1)) + change * steps / 2, -speed, speed)


def _fastest_of_any_steps(room: ca.SX, speed: float, acceleration: float, step: ca.SX) -> ca.SX:
    """The largest velocity v of a step T from which a joint can stop within `room` by steps of any length, within ±speed.

    v T + v² / 2A = room: short steps brake within v² / 2A, longer ones sooner, and braking by A T keeps the condition, as
    (v - A T) T + (v - A T)² / 2A = v² / 2A - A T² / 2.
    """
    if np.isinf(acceleration):
        return _clip(room / step, -speed, speed)
    change, inside = acceleration * step, ca.fmax(room, 0)
    stopping = 2 * acceleration * inside / (change + ca.sqrt(change**2 + 2 * acceleration * inside))
    return _clip(ca.if_else(room < 0, room / step, stopping), -speed, speed)


def _with_jerk(
    bounds: tuple[ca.SX, ca.SX], state: tuple[ca.SX, ca.SX, ca.SX], limits: JointLimits, i: int, dt: float
) -> tuple[ca.SX, ca.SX]:
    """The bounds within which a joint can always stop by the policy v⁺ = p (v + w), with w = v - p v₋ of the last step.

    Under it w decays by p per step and v_k = p^k (v + k w): its final position and its largest speed, acceleration and jerk
    are linear in the state, so the states from which it keeps all limits are a polytope, which the policy does not leave.
    """
    low, high = bounds
    q, v, a = state
    speed, jerk, acceleration = (float(each[i]) for each in (limits.velocity, limits.jerk, limits.acceleration))
    decay = min(acceleration * dt / speed, dt * np.sqrt(jerk / speed), 0.4)
    p = 1 - decay
    lower, upper = float(limits.lower[i]) - q, float(limits.upper[i]) - q
    intervals = [
        # jerk of this step; w, and thereby the later speeds
        _interval(1.0, v + a * dt, -jerk * dt**2, jerk * dt**2),
        _interval(1.0, p * v, -decay * speed, decay * speed),
        # acceleration and jerk of the policy's next step
        _interval(p - decay, p**2 * v, -acceleration * dt, acceleration * dt),
        _interval(2 * decay, (1 - p**2) * v, -jerk * dt**2, jerk * dt**2),
        # final position, and farthest position before it reverses
        _interval(dt * (1 + (2 * p * decay + p**2) / decay**2), dt * p**2 / decay**2 * v, lower, upper),
        _interval(dt / decay, 0.0, lower, upper),
    ]
    inner_low, inner_high = low, high
    for below, above in intervals:
        inner_low, inner_high = ca.fmax(inner_low, below), ca.fmin(inner_high, above)
    viable = inner_low <= inner_high + 1e-12 * speed
    middle = (inner_low + inner_high) / 2
    inner_low, inner_high = ca.fmin(inner_low, middle), ca.fmax(inner_high, middle)
    return ca.if_else(viable, inner_low, low), ca.if_else(viable, inner_high, high)


def _interval(slope: float, offset: ca.SX, low: ca.SX | float, high: ca.SX | float) -> tuple[ca.SX, ca.SX]:
    """The velocities v with low <= slope v - offset <= high, for slope > 0."""
    return (offset + low) / slope, (offset + high) / slope


def _clip(value: ca.SX, low: ca.SX | float, high: ca.SX | float) -> ca.SX:
    return ca.fmin(ca.fmax(value, low), high)


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
