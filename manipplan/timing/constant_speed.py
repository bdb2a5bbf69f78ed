"""retime_steady: times a path at a constant speed of the tool, or names the fastest such speed that it has.

check_corners: refuses a constant speed of the tool around a corner that no motion of the arm can keep there.

SteadySpeed: the speed of the tool on a motion that is to have a constant one, measured on the motion.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.joint import JointPath
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.arms import lengths_to
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, number
from manipplan.support.display import one_line, round_down
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.timing.retime import retime
from manipplan.timing.stops import Segment, ToolSpeed

#: Share by which a constant speed may be below the one that was asked for.
STEADY = 0.01
#: Largest share of the tool's way that a ramp may take. Until SETTLES times the way to the speed, and on the share SHORT of the
#: whole way, dips still belong to the ramp.
RAMP, SETTLES, SHORT = 0.1, 4.0, 1e-3
#: Number of times per sample interval at which speeds are measured, and of places at which a path's speed is compared.
BETWEEN, SPEED_PLACES = 4, 2001
#: The tool turns in place where it moves slower along the path than this share of the mean.
IN_PLACE = 0.01


@one_line
@dataclass(frozen=True, kw_only=True)
class SteadySpeed:
    """The speed of the tool on a motion that is to have a constant one, measured on the motion.

    A ramp ends where the speed has settled at the one asked for, to a hundredth; it is at most a tenth of the tool's way.

    Attributes:
        asked: the constant speed asked for [m/s].
        slowest, fastest: smallest and largest speed between the ramps [m/s].
        begin, end: times at which the first ramp ends and the last one begins [s].
        ramps: lengths of the tool's way on the two ramps [m].
        length: length of the tool's way [m].
    """

    asked: float
    slowest: float
    fastest: float
    begin: float
    end: float
    ramps: tuple[float, float]
    length: float

    @property
    def is_steady(self) -> bool:
        """Whether the speed is the one asked for, to a hundredth, between the ramps."""
        return self.slowest >= (1 - STEADY) * self.asked

    def later(self, by: float) -> "SteadySpeed":
        """The same with times from an earlier zero [s]."""
        return replace(self, begin=self.begin + by, end=self.end + by)

    def __str__(self) -> str:
        return (
            f"{1e3 * self.slowest:.4g} to {1e3 * self.fastest:.4g} mm/s from {self.begin:.3f} s to {self.end:.3f} s "
            f"({1e3 * self.asked:.4g} asked for); ramps of {1e3 * self.ramps[0]:.2g} and {1e3 * self.ramps[1]:.2g} mm"
        )


def check_tool_speed(speed: float, path: CartesianPath) -> float:
    """The speed [m/s] of a tool along a path. Raises InvalidInputError for no such speed, or where the tool turns in place."""
    value = number("tool_speed", speed, above=0.0)
    if not isinstance(path, CartesianPath):
        raise InvalidInputError("path", path, "a CartesianPath")
    steps = np.linalg.norm(np.diff(path.sample(SPEED_PLACES)[:, :3, 3], axis=0), axis=1)
    if not (steps > IN_PLACE * steps.mean()).all():
        s = (int(steps.argmin()) + 0.5) / len(steps)
        wanted = f"None for this path: at s = {s:.3f} it turns the tool in place, where its speed cannot be constant; split it"
        raise InvalidInputError("tool_speed", speed, wanted)
    return value


def measure_speed(
    trajectory: Trajectory, robot: Robot, asked: float, *, begin: float = 0.0, end: float | None = None, short: float = SHORT
) -> SteadySpeed:
    """The speed of the tool from time `begin` to time `end` [s] of a motion, by Pinocchio's Jacobians; None: to its end.

    `short`: the share of the tool's way at either end on which dips belong to the ramp in any case.
    """
    end = trajectory.duration if end is None else end
    samples = np.unique(np.append(trajectory.t[(trajectory.t > begin) & (trajectory.t < end)], [begin, end]))
    t = np.unique(np.concatenate([samples[:-1] + np.diff(samples) * share / BETWEEN for share in range(BETWEEN + 1)]))
    t = np.minimum(t, end)
    speeds = ToolSpeed(robot)(trajectory(t), trajectory(t, 1))
    way = np.concatenate([[0.0], np.cumsum((speeds[1:] + speeds[:-1]) / 2 * np.diff(t))])
    slow = speeds < (1 - STEADY) * asked
    first = _ramp_end(slow, way, short)
    last = len(t) - 1 - _ramp_end(slow[::-1], way[-1] - way[::-1], short)
    between = speeds[first : last + 1]
    return SteadySpeed(
        asked=asked,
        slowest=float(between.min()),
        fastest=float(between.max()),
        begin=float(t[first]),
        end=float(t[last]),
        ramps=(float(way[first]), float(way[-1] - way[last])),
        length=float(way[-1]),
    )


def _ramp_end(slow: NDArray[np.bool_], way: Array, short: float) -> int:
    """The sample at which the first ramp ends: after it reached the speed, dips close behind belong to it."""
    reached = int(slow.argmin())
    near = way <= min(max(SETTLES * way[reached], short * way[-1]), RAMP * way[-1])
    dips = np.flatnonzero(slow & near)
    return int(dips[-1]) + 1 if len(dips) else 0


#: Number of intervals of the tool's way, and of places from which they are interpolated.
INTERVALS, CORNER_PLACES = 8192, 20001


def check_corners(speed: float, path: CartesianPath, robot: Robot, *, position: float, margin: float = 0.0) -> None:
    """Raise InvalidInputError, which names the place, for a constant speed [m/s] that a corner of the path does not allow.

    A tool that passes three places of the path, a way h apart, at speed v and within the tolerance δ, is accelerated by at
    least v² (‖p₁ - 2 p₂ + p₃‖ - 4 δ) / (h + 2 δ)². No motion within the limits accelerates it by more than `most_acceleration`.

    Args:
        position: tolerance δ on the tool's position [m].
        margin: way at either end that is left out [m]; so are the ramps.
    """
    s = np.linspace(0.0, 1.0, CORNER_PLACES)
    points = path(s)[:, :3, 3]
    way = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    left_out = margin + RAMP * way[-1]
    if way[-1] <= 2 * left_out:
        return
    at = np.linspace(left_out, way[-1] - left_out, INTERVALS + 1)
    points = np.stack([np.interp(at, way, points[:, k]) for k in range(3)], axis=1)
    worst, place = 0.0, 0.0
    for lag in 2 ** np.arange(int(np.log2(INTERVALS))):
        second = np.linalg.norm(points[2 * lag :] - 2 * points[lag:-lag] + points[: -2 * lag], axis=1)
        bend = (second - 4 * position) / (lag * (at[1] - at[0]) + 2 * position) ** 2  # acceleration at 1 m/s
        if bend.max() > worst:
            worst, place = float(bend.max()), float(np.interp(at[lag + int(bend.argmax())], way, s))
    most = np.sqrt(most_acceleration(robot) / worst) / (1 - STEADY) if worst > 0 else np.inf
    if speed > most:
        wanted = (
            f"at most {most:.3g} m/s: at s = {place:.3f} the path turns a corner that no motion within the acceleration limits "
            "takes faster. Round the corner, allow a larger tolerance, or split the path there into two steps with a blend"
        )
        raise InvalidInputError("tool_speed", speed, wanted)


def most_acceleration(robot: Robot) -> float:
    """An upper bound on the acceleration of the tool's origin within the limits, in any configuration [m/s²].

    Each joint that carries the tool adds its own acceleration times its lever, and each pair of them the product of their
    velocities times the lever of the later one. A lever is at most the sum of the lengths of the links beyond the joint.
    """
    tree, lengths = robot.tree, lengths_to(robot, robot.tool)
    joints = np.array([joint - 1 for joint, _ in lengths])
    levers = np.array([1.0 if tree.slides[joint - 1] else length for joint, length in lengths])
    velocity, acceleration = (tree.sizes(each)[joints] for each in (robot.limits.velocity, robot.limits.acceleration))
    later = np.maximum.outer(np.arange(len(joints)), np.arange(len(joints)))
    return float(acceleration @ levers + (np.outer(velocity, velocity) * levers[later]).sum())


#: Number of places at which limits are compared.
DEVIATION_PLACES = 2001
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
    s = np.linspace(0.0, 1.0, DEVIATION_PLACES)
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
    low, high, speed = 0.0, most, round_down(0.999 * guess, 3)
    for _ in range(TRIES):
        try:
            holds = keep(speed) is not None
        except PlanningError:
            holds = False
        low, high = (speed, high) if holds else (low, speed)
        if high <= CLOSE * low:
            break
        speed = round_down(np.sqrt(low * high) if low else LESS * high, 3)
        if speed <= low:
            break
    return low or None
