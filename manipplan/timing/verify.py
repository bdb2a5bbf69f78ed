"""Demands of a trajectory on each joint compared with its limits: exact extremes of the cubic pieces, not samples."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import pinocchio as pin

from manipplan.paths.trajectory import Trajectory
from manipplan.robots.limits import JointLimits
from manipplan.support.checks import Array, instance, positive_array, whole_number
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError
from manipplan.timing.stops import Bounds, ToolSpeed

#: A sudden change of acceleration counts as a jump above this share of its limit and above what the rounding of times to whole
#: nanoseconds explains [s], but always above the larger share.
JUMP, NANOSECOND, MOST_JUMP = 1e-5, 1e-9, 1e-2
#: Maximum number of times inside each piece at which torques are computed.
MOST_INSIDE = 1000


@one_line
@dataclass(frozen=True, kw_only=True)
class LimitUse:
    """The largest use of one kind of limit.

    Attributes:
        ratio: largest ratio of demand to limit; at most 1 when the limit holds. For position: largest excess [rad or m], at
            most 0 when it holds.
        joint: name of the joint that reaches it; "" when no joint has this limit.
        time: time at which it is reached [s].
    """

    ratio: float
    joint: str
    time: float


NO_USE = LimitUse(ratio=0.0, joint="", time=0.0)


def limit_use(trajectory: Trajectory, limits: JointLimits) -> Mapping[str, LimitUse]:
    """Compute the largest use of the position, velocity and acceleration limits over a trajectory, in closed form.

    On a cubic piece velocity is a parabola and acceleration a line, so each extreme is at an end of the piece, or at
    the vertex of the parabola. For jerk see `jerk_use`.
    """
    _matching(trajectory, limits)
    at, velocity, acceleration = _extremes(*trajectory.segments())
    return {
        "position": _position_use(trajectory, limits),
        "velocity": _largest_ratio(trajectory, velocity, limits.velocity, at),
        "acceleration": _largest_ratio(trajectory, acceleration, limits.acceleration, at),
    }


def piece_use(
    trajectory: Trajectory, bounds: Bounds, model: pin.Model | None, tool: ToolSpeed | None, *, inside: int = 6
) -> Mapping[str, Array]:
    """Largest ratio of demand to limit per cubic piece (k - 1,), by kind; each piece has its own `bounds`.

    Velocity, acceleration and jerk are exact, but jerk leaves out jumps of acceleration between pieces. Torque and tool
    speed are sampled at both ends and at `inside` points between, and bounded between samples by second differences.
    """
    coefficients = trajectory.segments()
    _, velocity, acceleration = _extremes(*coefficients)
    found = {
        "jerk": (6 * np.abs(coefficients[1][3]) / bounds.jerk).max(axis=1),
        "velocity": (_largest(velocity) / bounds.velocity).max(axis=1),
        "acceleration": (_largest(acceleration) / bounds.acceleration).max(axis=1),
    }
    if model is None and tool is None:
        return found
    states = list(_within(trajectory, inside))
    if model is not None:
        torques = np.stack([_torques(model, *state) for _, *state in states])
        found["torque"] = (_bent(torques) / bounds.effort).max(axis=1)
    if tool is not None:
        speeds = np.stack([tool(q, qd) for _, q, qd, _ in states])
        found["tool speed"] = _bent(speeds) / bounds.tool_speed
    return found


def jerk_of_pieces(trajectory: Trajectory, bounds: Bounds) -> Array:
    """Largest ratio of jerk to its limit per cubic piece (k - 1,)."""
    return np.asarray((6 * np.abs(trajectory.segments()[1][3]) / bounds.jerk).max(axis=1))


def _bent(values: Array) -> Array:
    """The largest magnitude of a function between evenly spaced samples (m, ...), by its second differences."""
    return np.asarray(np.abs(values).max(axis=0) + np.abs(np.diff(values, 2, axis=0)).max(axis=0) / 8)


def jerk_use(trajectory: Trajectory, limits: JointLimits) -> LimitUse:
    """Compute the largest use of the jerk limits; each cubic piece has one jerk. The ratio is inf where acceleration jumps.

    Acceleration jumps between pieces of most splines. A change at a sample counts as a jump above 1e-5 of the acceleration
    limit, and above what times in whole nanoseconds explain: 6e-9 v (1 / h² + 1 / k²) at the speed v between pieces of the
    widths h and k, at most 1e-2 of the limit. Raises InvalidInputError for limits of a different number of joints.
    """
    _matching(trajectory, limits)
    widths, (_, _, second, third) = trajectory.segments()
    if np.isinf(limits.jerk).all():
        return NO_USE
    ratios = 6 * np.abs(third) / limits.jerk
    begins, ends = 2 * second, 2 * second + 6 * third * widths[:, None]
    unit = np.where(np.isfinite(limits.acceleration), limits.acceleration, np.abs([begins, ends]).max())
    explained = 6 * np.abs(trajectory.qd[1:-1]) * (NANOSECOND / widths[1:] ** 2 + NANOSECOND / widths[:-1] ** 2)[:, None]
    jumps = np.abs(begins[1:] - ends[:-1]) > np.clip(explained, JUMP * unit, MOST_JUMP * unit)
    ratios[1:][jumps & np.isfinite(limits.jerk)] = np.inf
    return _largest_use(trajectory, ratios[None], [np.zeros_like(ratios)])


def _matching(trajectory: Trajectory, limits: JointLimits) -> None:
    n = instance("trajectory", trajectory, Trajectory).n
    if instance("limits", limits, JointLimits).n != n:
        raise InvalidInputError("limits", f"limits of {limits.n} joints", f"limits of the trajectory's {n} joints")


def torque_use(trajectory: Trajectory, model: pin.Model, effort: Array, *, inside: int = 6) -> LimitUse:
    """Compute the largest use of effort limits, at both ends of each piece and `inside` times between, by Pinocchio.

    `effort` (n,), or one number, is above zero; inf where there is no limit. Raises InvalidInputError for other arguments.
    """
    n = instance("trajectory", trajectory, Trajectory).n
    if instance("model", model, pin.Model).nv != n:
        raise InvalidInputError("model", f"a model of {model.nv} joints", f"a model of the trajectory's {n} joints")
    effort, inside = positive_array("effort", effort, n), whole_number("inside", inside, least=0, most=MOST_INSIDE)
    worst = NO_USE
    for u, *state in _within(trajectory, inside):
        ratios = np.abs(_torques(model, *state)) / effort
        found = _largest_use(trajectory, ratios[None], [np.broadcast_to(u[:, None], ratios.shape)])
        worst = found if found.ratio > worst.ratio else worst
    return worst


def _extremes(widths: Array, coefficients: Array) -> tuple[list[Array], list[Array], list[Array]]:
    """Times in each piece where velocity may be largest, velocities there, and accelerations at the first two (both ends)."""
    _, first, second, third = coefficients
    h = widths[:, None]
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        vertex = -second / (3 * third)
        vertex = np.where((vertex > 0) & (vertex < h), vertex, 0.0)  # also where there is none
    at = [np.zeros_like(first), np.broadcast_to(h, first.shape), vertex]
    velocity = [first, *(first + u * (2 * second + 3 * third * u) for u in at[1:])]
    return at, velocity, [2 * second, 2 * second + 6 * third * h]


def _largest(values: list[Array]) -> Array:
    """The largest magnitude of several arrays, place by place."""
    largest = np.abs(values[0])
    for each in values[1:]:
        np.maximum(largest, np.abs(each), out=largest)
    return np.asarray(largest)


def _within(trajectory: Trajectory, inside: int) -> Iterator[tuple[Array, Array, Array, Array]]:
    """Time in the piece (k - 1,), q, qd and qdd (k - 1, n) at both ends of each piece and at `inside` points between."""
    widths, (c0, c1, c2, c3) = trajectory.segments()
    for fraction in np.linspace(0.0, 1.0, inside + 2):
        u = (widths * fraction)[:, None]
        yield u[:, 0], c0 + u * (c1 + u * (c2 + u * c3)), c1 + u * (2 * c2 + 3 * u * c3), 2 * c2 + 6 * u * c3


def _torques(model: pin.Model, q: Array, qd: Array, qdd: Array) -> Array:
    data = model.createData()
    return np.array([pin.rnea(model, data, *state) for state in zip(q, qd, qdd, strict=True)])


def _largest_use(trajectory: Trajectory, ratios: Array, at: Sequence[Array]) -> LimitUse:
    """The largest of ratios (m, k - 1, n) at m times (k - 1, n) in each piece."""
    which, segment, joint = (int(k) for k in np.unravel_index(int(np.argmax(ratios)), ratios.shape))
    time = trajectory.t[segment] + at[which][segment, joint]
    return LimitUse(ratio=float(ratios[which, segment, joint]), joint=trajectory.joint_names[joint], time=float(time))


def _largest_ratio(trajectory: Trajectory, values: list[Array], limit: Array, at: list[Array]) -> LimitUse:
    return NO_USE if np.isinf(limit).all() else _largest_use(trajectory, np.abs(np.stack(values)) / limit, at)


def _position_use(trajectory: Trajectory, limits: JointLimits) -> LimitUse:
    widths, (c0, c1, c2, c3) = trajectory.segments()
    h = widths[:, None]
    with np.errstate(divide="ignore", invalid="ignore"):
        root = np.sqrt(np.maximum(c2**2 - 3 * c1 * c3, 0.0))
        # roots of c1 + 2 c2 u + 3 c3 u² without cancellation, also where c3 is almost zero
        sum_ = -(c2 + np.copysign(root, c2))
        turning = [sum_ / (3 * c3), c1 / sum_]
    at = [np.zeros_like(c0), np.broadcast_to(h, c0.shape), *(np.clip(np.nan_to_num(u), 0.0, h) for u in turning)]
    q = np.stack([c0 + u * (c1 + u * (c2 + u * c3)) for u in at])
    excess = np.maximum(limits.lower - q, q - limits.upper)
    found = _largest_use(trajectory, excess, at)
    return LimitUse(ratio=-np.inf, joint="", time=0.0) if np.isinf(found.ratio) else found
