"""retime_steady: times a path at a constant speed of the tool, or names the fastest such speed that it has."""

from collections.abc import Callable

import numpy as np
import pinocchio as pin

from manipplan.paths.joint import JointPath
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.display import rounded_down
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.timing.retime import retime
from manipplan.timing.segment import Segment, ToolSpeed
from manipplan.timing.steady.speed import measure_speed

#: Number of places at which limits are compared.
PLACES = 2001
#: Places near the start, and as far from the end, at which a ramp can end: they lie between the first two points of the grid.
EDGES = tuple(1.5 ** -np.arange(16.0) / 300)
#: Numbers of grid points that are tried in turn.
GRIDS = (300, 600, 1200)
#: Share to which the fastest speed is found, maximum number of motions timed for it, and share of the first guess in each.
CLOSE, TRIES, LESS = 1.02, 14, 0.6
#: Shares of the limits' bound above which the limits are said to bind, and up to which speeds are tried: it is an estimate.
BINDS, ABOVE = 0.9, 1.1


def retime_steady(path: JointPath, robot: Robot, speed: float, *, torque: bool = False) -> Trajectory:
    """The motion along a joint path on which the tool has a constant speed [m/s], but for the ramps at its ends.

    Ramps are as short as the limits allow.

    Raises:
        InvalidInputError: the speed is not reached, or not kept; the message names the fastest one that is.
        PlanningError: as in `retime`.
    """
    trajectory = _steady(path, robot, speed, torque=torque)
    if trajectory is not None:
        return trajectory
    raise InvalidInputError(
        "tool_speed", speed, slower(path, robot, speed, lambda each: _steady(path, robot, each, torque=torque), torque=torque)
    )


def slower(path: JointPath, robot: Robot, speed: float, keep: Callable[[float], object | None], *, torque: bool) -> str:
    """What is allowed instead of a constant speed [m/s] that is not possible on a path: the fastest that is, and why.

    `keep` gives None for a speed that is not kept.
    """
    bound, reason = limits_bound(path, robot, torque=torque)
    fastest = _fastest(keep, min(bound, speed), min(ABOVE * bound, speed))
    if fastest is None:
        return f"None for this motion: it has no constant speed of the tool; {reason}"
    if fastest < BINDS * bound:
        reason = "a faster one is not reached from rest, and braked to rest, on a tenth of the path each"
    return f"at most {fastest:g} m/s, the fastest constant speed of the tool on this motion: {reason}"


def steady_segments(begin: float, end: float, speed: float) -> list[Segment]:
    """Segments that limit the tool's speed between two s of a path, and make short ramps possible at both.

    The ends of segments are points of the grid of `retime`: these are dense near both ends.
    """
    width = end - begin
    return [Segment(begin=begin + edge * width, end=end - edge * width, tool_speed=speed) for edge in (0.0, *EDGES)]


def limits_bound(path: JointPath, robot: Robot, *, torque: bool = False) -> tuple[float, str]:
    """Estimate of the fastest constant speed of the tool [m/s] between the ends of a path, and the limit that sets it.

    At a constant speed v of the tool the joints' velocities are v dq/dσ, their accelerations v² d²q/dσ² and their jerks
    v³ d³q/dσ³, where σ is the length of the tool's way.
    """
    s = np.linspace(0.0, 1.0, PLACES)
    q, first, second = path(s), path(s, 1), path(s, 2)
    way = np.maximum(ToolSpeed(robot)(q, first), 1e-12)[:, None]
    slope = first / way
    bend = (second - np.gradient(way[:, 0], s)[:, None] * slope) / way**2
    inside = slice(1, -1)
    limits, names = robot.limits, robot.joint_names
    with np.errstate(divide="ignore"):
        bounds = {"velocity": limits.velocity / np.abs(slope), "acceleration": np.sqrt(limits.acceleration / np.abs(bend))}
        bounds["jerk"] = np.cbrt(limits.jerk * way / np.maximum(np.abs(np.gradient(bend, s, axis=0)), 1e-300))
        if torque:
            bounds["effort"] = np.sqrt(_torque_bounds(robot, q, slope, bend))
    kind = min(bounds, key=lambda each: float(bounds[each][inside].min()))
    k, joint = np.unravel_index(int(bounds[kind][inside].argmin()), bounds[kind][inside].shape)
    place = f"the {kind} limit of {names[joint]} allows no faster one after {100 * s[k + 1]:.0f} % of the path"
    return float(bounds[kind][inside].min()), place


def _torque_bounds(robot: Robot, q: Array, slope: Array, bend: Array) -> Array:
    """Bounds (k, n) on the square of the tool's speed by the effort limits."""
    data, still = robot.model.createData(), np.zeros(robot.n)
    gravity = np.array([pin.rnea(robot.model, data, each, still, still).copy() for each in q])
    moving = np.array([pin.rnea(robot.model, data, *state).copy() for state in zip(q, slope, bend, strict=True)]) - gravity
    return np.asarray(np.maximum(robot.limits.effort - np.sign(moving) * gravity, 0.0) / np.maximum(np.abs(moving), 1e-300))


def _steady(path: JointPath, robot: Robot, speed: float, *, torque: bool) -> Trajectory | None:
    """The motion with a constant speed [m/s]; None where it is not constant on any grid."""
    segments = steady_segments(0.0, 1.0, speed)
    for grid in GRIDS:  # slow motions need more points, as the tool turns between two of them
        trajectory = retime(path, robot, torque=torque, segments=segments, grid=grid)
        if measure_speed(trajectory, robot, speed).is_steady:
            return trajectory
    return None


def _fastest(keep: Callable[[float], object | None], guess: float, most: float) -> float | None:
    """The fastest constant speed, in three digits, found by bisection up to `most`; None for none."""
    low, high, speed = 0.0, most, rounded_down(0.999 * guess, 3)
    for _ in range(TRIES):
        try:
            kept = keep(speed) is not None
        except PlanningError:
            kept = False
        low, high = (speed, high) if kept else (low, speed)
        if high <= CLOSE * low:
            break
        speed = rounded_down(np.sqrt(low * high) if low else LESS * high, 3)
        if speed <= low:
            break
    return low or None
