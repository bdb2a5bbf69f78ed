"""A constant speed of the tool: paths are timed at it, or the fastest one is named; it is measured on the motion."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
from numpy.typing import NDArray

from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.joint import JointPath
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.arms import lengths_to
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, number
from manipplan.support.display import one_line, round_down
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.timing.dynamics import ArcLength, path_dynamics
from manipplan.timing.retime import retime
from manipplan.timing.stops import STANDSTILL, LimitsAlong, MovingPath, Segment, ToolSpeed, stops

#: Share by which a constant speed may be below the one that was asked for, unless more is allowed, and the most that can be.
STEADY, MOST_SLOWDOWN = 0.01, 0.99
#: Largest share of the tool's way that a ramp may take. Until SETTLES times the way to the speed, and on the share SHORT of the
#: whole way, dips still belong to the ramp.
RAMP, SETTLES, SHORT = 0.1, 4.0, 1e-3
#: Number of times per sample interval at which speeds are measured, and of places at which a path's speed is compared.
BETWEEN, SPEED_PLACES = 8, 2001
#: The tool turns in place where it moves slower along the path than this share of the mean, and turns back where the cosine
#: between two steps is below the second, also between steps that are finer by the third.
IN_PLACE, BACK, FINER = 0.01, -0.98, 100


@one_line
@dataclass(frozen=True, kw_only=True)
class SteadySpeed:
    """The speed of the tool on a motion that is to have a constant one, measured on the motion.

    A ramp ends where the speed has settled at the one asked for, to a hundredth, or to the share `slowdown` where limits allow
    no more. It is at most a tenth of the way.

    Attributes:
        asked: the constant speed asked for [m/s].
        slowdown: share by which the tool may be slower.
        slowest, fastest: smallest and largest speed between the ramps [m/s].
        slowest_at: time of the smallest one [s].
        begin, end: times at which the first ramp ends and the last one begins [s].
        ramps: lengths of the tool's way on the two ramps [m].
        length: length of the tool's way [m].
    """

    asked: float
    slowdown: float
    slowest: float
    slowest_at: float
    fastest: float
    begin: float
    end: float
    ramps: tuple[float, float]
    length: float

    @property
    def is_steady(self) -> bool:
        """Whether the speed is the one asked for between the ramps, to the share `slowdown`."""
        return self.slowest >= (1 - self.slowdown) * self.asked

    def later(self, by: float) -> "SteadySpeed":
        """The same with times from an earlier zero [s]."""
        return replace(self, slowest_at=self.slowest_at + by, begin=self.begin + by, end=self.end + by)

    def __str__(self) -> str:
        slowest = f", slowest at {self.slowest_at:.3f} s" if self.slowest < (1 - STEADY) * self.asked else ""
        return (
            f"{1e3 * self.slowest:.4g} to {1e3 * self.fastest:.4g} mm/s from {self.begin:.3f} s to {self.end:.3f} s "
            f"({1e3 * self.asked:.4g} asked for{slowest}); ramps of {1e3 * self.ramps[0]:.2g} and {1e3 * self.ramps[1]:.2g} mm"
        )


def check_tool_speed(speed: float, path: CartesianPath) -> float:
    """The speed [m/s] of a tool along a path.

    Raises InvalidInputError for no such speed, or where the tool turns in place or back.
    """
    value = number("tool_speed", speed, above=0.0)
    if not isinstance(path, CartesianPath):
        raise InvalidInputError("path", path, "a CartesianPath")
    s = np.linspace(0.0, 1.0, SPEED_PLACES)
    positions = path(s)[:, :3, 3]
    steps = np.linalg.norm(np.diff(positions, axis=0), axis=1)
    at = None
    for k in np.flatnonzero(_turns(positions) < BACK):
        finer = np.linspace(s[k], s[k + 2], 2 * FINER + 1)
        turns = _turns(path(finer)[:, :3, 3])
        if turns.min() < BACK:
            at = float(finer[turns.argmin() + 1])
            break
    if at is None and not (steps > IN_PLACE * steps.mean()).all():
        at = float(s[steps.argmin()] + s[1] / 2)
    if at is not None:
        where = place(at, path(at)[:3, 3])
        wanted = f"a path that moves the tool all along: {where}, it turns the tool in place or back; split it there"
        raise InvalidInputError("tool_speed", speed, wanted)
    return value


def _turns(positions: Array) -> Array:
    """Cosines (k - 2,) of the angles between steps from one position (k, 3) to the next; 1 where a step has no length."""
    steps = np.diff(positions, axis=0)
    before, after = steps[:-1], steps[1:]
    lengths = np.linalg.norm(before, axis=1) * np.linalg.norm(after, axis=1)
    return np.asarray(np.divide((before * after).sum(axis=1), lengths, out=np.ones(len(lengths)), where=lengths > 0))


def place(s: float, position: Array) -> str:
    """A place of a path, for a message: s and the position (3,) of the tool [m]."""
    return f"at s = {s:.3f}, x y z = {' '.join(f'{each:.3f}' for each in position)} m"


def measure_speed(
    trajectory: Trajectory,
    robot: Robot,
    asked: float,
    *,
    slowdown: float = STEADY,
    begin: float = 0.0,
    end: float | None = None,
    short: float = SHORT,
) -> SteadySpeed:
    """The speed of the tool from time `begin` to time `end` [s] of a motion, by Pinocchio's Jacobians; None: to its end.

    `slowdown`: the share by which the tool may be slower. `short`: the share of the tool's way at either end on which dips
    belong to the ramp in any case.
    """
    end = trajectory.duration if end is None else end
    samples = np.unique(np.append(trajectory.t[(trajectory.t > begin) & (trajectory.t < end)], [begin, end]))
    t = np.unique(np.concatenate([samples[:-1] + np.diff(samples) * share / BETWEEN for share in range(BETWEEN + 1)]))
    t = np.minimum(t, end)
    speeds = ToolSpeed(robot)(trajectory(t), trajectory(t, 1))
    way = np.concatenate([[0.0], np.cumsum((speeds[1:] + speeds[:-1]) / 2 * np.diff(t))])
    shares = (STEADY, slowdown)
    back = way[-1] - way[::-1]
    ends = [[_ramp_end(v < (1 - each) * asked, w, short) for each in shares] for v, w in ((speeds, way), (speeds[::-1], back))]
    first, last = _settled(ends[0], way), len(t) - 1 - _settled(ends[1], back)
    between = speeds[first : last + 1]
    return SteadySpeed(
        asked=asked,
        slowdown=slowdown,
        slowest=float(between.min()),
        slowest_at=float(t[first + int(between.argmin())]),
        fastest=float(between.max()),
        begin=float(t[first]),
        end=float(t[last]),
        ramps=(float(way[first]), float(way[-1] - way[last])),
        length=float(way[-1]),
    )


def _settled(ends: list[int], way: Array) -> int:
    """The sample at which a ramp ends: where it has reached the speed or, if that is much later, the share it may be slower."""
    steady, slowed = ends
    return steady if way[steady] <= SETTLES * way[slowed] else slowed


def _ramp_end(slow: NDArray[np.bool_], way: Array, short: float) -> int:
    """The sample at which the first ramp ends: after it reached the speed, dips close behind belong to it."""
    reached = int(slow.argmin())
    near = way <= min(max(SETTLES * way[reached], short * way[-1]), RAMP * way[-1])
    dips = np.flatnonzero(slow & near)
    return int(dips[-1]) + 1 if len(dips) else 0


#: Number of intervals of the tool's way, and of places from which they are interpolated.
INTERVALS, CORNER_PLACES = 8192, 20001


def check_corners(
    speed: float,
    path: CartesianPath,
    robot: Robot,
    *,
    position: float,
    slowdown: float = STEADY,
    margin: float = 0.0,
    interruptions: int = 0,
) -> tuple[float, ...]:
    """The s at which the tool has to stop as corners of the path do not allow a constant speed [m/s].

    Args:
        position: tolerance δ on the tool's position [m].
        slowdown: share by which the tool may be slower.
        margin: way at either end that is left out [m]; so are the ramps. 0: the motion is one from rest to rest.
        interruptions: number of stops that are allowed.

    Raises InvalidInputError where these are too few, and for a speed that the arm never has. The message names the place.
    """
    _check_fastest(speed, path, robot, slowdown=slowdown, from_rest=not margin)
    stops, most, at = _corners(speed, path, robot, position=position, slowdown=slowdown, margin=margin)
    if len(stops) > interruptions:
        wanted = (
            f"at most {round_down(most, 3):g} m/s: {place(at, path(at)[:3, 3])}, the path turns a corner that no "
            "motion within the acceleration limits takes faster. Round the corner, allow a larger tolerance, split the path "
            f"there into two steps with a blend, or follow it with interruptions={len(stops)}"
        )
        raise InvalidInputError("tool_speed", speed, wanted)
    return stops


def _check_fastest(speed: float, path: CartesianPath, robot: Robot, *, slowdown: float, from_rest: bool) -> None:
    """Raise InvalidInputError for a speed [m/s] that the arm never has, or does not reach from rest on a tenth of the path."""
    most, why = most_velocity(robot), "no motion within the velocity limits is faster"
    ramp = np.sqrt(2 * RAMP * path.length * most_acceleration(robot))
    if from_rest and ramp < most:
        most, why = ramp, "no motion within the acceleration limits reaches more from rest on a tenth of the path"
    if speed * (1 - slowdown) > most:
        raise InvalidInputError("tool_speed", speed, f"at most {round_down(most / (1 - slowdown), 3):g} m/s: {why}")


def _corners(
    speed: float, path: CartesianPath, robot: Robot, *, position: float, slowdown: float, margin: float = 0.0
) -> tuple[tuple[float, ...], float, float]:
    """The fewest s at which corners make stops necessary for a constant speed; the fastest one without stops, and its corner.

    A tool that passes three places of the path, a way h apart, at speed v and within the tolerance δ, is accelerated by at
    least v² (‖p₁ - 2 p₂ + p₃‖ - 4 δ) / (h + 2 δ)². No motion within the limits accelerates it by more than `most_acceleration`.
    """
    s = np.linspace(0.0, 1.0, CORNER_PLACES)
    points = path(s)[:, :3, 3]
    way = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    left_out = margin + RAMP * way[-1]
    if way[-1] <= 2 * left_out:
        return (), np.inf, 0.0
    at = np.linspace(left_out, way[-1] - left_out, INTERVALS + 1)
    points = np.stack([np.interp(at, way, points[:, k]) for k in range(3)], axis=1)
    allowed = most_acceleration(robot) / (speed * (1 - slowdown)) ** 2  # acceleration at 1 m/s
    worst, at_worst, ends = 0.0, 0, list[tuple[int, int]]()
    for lag in 2 ** np.arange(int(np.log2(INTERVALS))):
        second = np.linalg.norm(points[2 * lag :] - 2 * points[lag:-lag] + points[: -2 * lag], axis=1)
        bend = (second - 4 * position) / (lag * (at[1] - at[0]) + 2 * position) ** 2  # acceleration at 1 m/s
        if bend.max() > worst:
            worst, at_worst = float(bend.max()), int(lag + bend.argmax())
        ends += [(k + 2 * int(lag), k) for k in np.flatnonzero(bend > allowed).tolist()]
    stops = list[float]()
    shared: tuple[int, int] | None = None  # where a stop is in all ranges so far that have none before
    for end, begin in sorted(ends):
        if shared is not None and begin <= shared[1]:
            shared = max(shared[0], begin), shared[1]
            continue
        stops += [] if shared is None else [sum(shared) / 2]
        shared = begin, end
    stops += [] if shared is None else [sum(shared) / 2]
    most = float(np.sqrt(most_acceleration(robot) / worst)) / (1 - slowdown) if worst > 0 else np.inf
    places = np.interp(np.interp([*stops, at_worst], np.arange(len(at)), at), way, s)
    return tuple(float(each) for each in places[:-1]), most, float(places[-1])


def most_velocity(robot: Robot) -> float:
    """An upper bound on the speed of the tool's origin within the limits, in any configuration [m/s]."""
    levers, velocity, _ = _levers(robot)
    return float(velocity @ levers)


def most_acceleration(robot: Robot) -> float:
    """An upper bound on the acceleration of the tool's origin within the limits, in any configuration [m/s²].

    Each joint that carries the tool adds its own acceleration times its lever, and each pair of them the product of their
    velocities times the lever of the later one. A lever is at most the sum of the lengths of the links beyond the joint.
    """
    levers, velocity, acceleration = _levers(robot)
    later = np.maximum.outer(np.arange(len(levers)), np.arange(len(levers)))
    return float(acceleration @ levers + (np.outer(velocity, velocity) * levers[later]).sum())


def _levers(robot: Robot) -> tuple[Array, Array, Array]:
    """Of the joints (k,) that carry the tool: lever [m], or 1 for a slide, and limits of velocity and acceleration."""
    tree, lengths = robot.tree, lengths_to(robot, robot.tool)
    joints = np.array([joint - 1 for joint, _ in lengths])
    levers = np.array([1.0 if tree.slides[joint - 1] else length for joint, length in lengths])
    velocity, acceleration = (tree.sizes(each)[joints] for each in (robot.limits.velocity, robot.limits.acceleration))
    return levers, velocity, acceleration


#: Places near the start, and as far from the end, at which a ramp can end: they lie between the first two points of the grid.
EDGES = tuple(1.5 ** -np.arange(16.0) / 300)
#: Numbers of grid points that are tried in turn, up to this multiple of the speed that limits allow by estimate.
GRIDS, HOPELESS = (300, 600, 1200), 1.2
#: Number of points at which limits are compared.
LIMIT_POINTS = 2000
#: Share to which the fastest speed is found, maximum number of motions timed for it, share of the speed before where none is
#: kept, and factor by which a speed that is kept is raised, squared each time.
CLOSE, TRIES, LESS, MORE = 1.02, 14, 0.6, 1.1
#: Share of the limits' bound above which the limits are said to bind: it is an estimate.
BINDS = 0.9


@dataclass(frozen=True, kw_only=True)
class SpeedDemand:
    """A constant speed of the tool's origin along a path [m/s], from which it may be slower by a share.

    With `torque` the joints' effort limits are kept as well.
    """

    speed: float
    slowdown: float = STEADY
    torque: bool = False

    @property
    def least(self) -> float:
        """The smallest speed that is allowed between the ramps [m/s]."""
        return (1 - self.slowdown) * self.speed

    def joint_pace(self, robot: Robot) -> Array:
        """The largest motion of each joint per metre of the tool's way (n,) [rad/m or 1]: faster joints exceed their limits."""
        return robot.limits.velocity / self.least

    def fastest(self, path: JointPath, robot: Robot) -> tuple[float, float]:
        """An estimate of the fastest speed that limits allow on a joint path [m/s], and the s that binds."""
        still = standing(path, robot)
        if still is not None:
            return 0.0, still
        bound = min(limits_bound(path, robot, torque=self.torque, at_ramps=False), key=lambda each: each.speed)
        return bound.speed, bound.s

    def is_hopeless(self, fastest: float) -> bool:
        """Whether the speed is far above an estimate of the fastest one [m/s]."""
        return self.least > HOPELESS * fastest

    def steadiest(self, path: JointPath, robot: Robot, fastest: Callable[[], float]) -> tuple[Trajectory, SteadySpeed]:
        """The motion along a joint path by the first grid on which the speed is constant, else the one that slows least.

        `fastest` gives the estimate: no finer grid helps where that is hopeless. Raises PlanningError as `retime`.
        """
        segments = steady_segments(0.0, 1.0, self.speed)
        best: tuple[Trajectory, SteadySpeed] | None = None
        for grid in GRIDS:
            trajectory = retime(path, robot, torque=self.torque, segments=segments, grid=grid)
            found = measure_speed(trajectory, robot, self.speed, slowdown=self.slowdown)
            if best is None or found.slowest > best[1].slowest:
                best = trajectory, found
            if found.is_steady or self.is_hopeless(fastest()):
                break
        assert best is not None
        return best

    def timed(self, path: JointPath, robot: Robot, *, ends: tuple[float, float] = (0.0, 1.0)) -> tuple[Trajectory, SteadySpeed]:
        """The motion along a joint path from rest to rest, with the constant speed but for the ramps at its ends.

        Ramps are as short as the limits allow. Where the limits do not allow the speed the tool slows, by at most the share.
        Messages count s between `ends`, those of the path of the tool.

        Raises:
            InvalidInputError: the speed is not reached, or not kept; the message names the fastest that is, and what limits it.
            PlanningError: as in `retime`.
        """

        @cache
        def fastest() -> float:
            return self.fastest(path, robot)[0]

        made = self.steadiest(path, robot, fastest)
        if made[1].is_steady:
            return made

        def keep(each: float) -> bool:
            return replace(self, speed=each).steadiest(path, robot, fastest)[1].is_steady

        wanted = slower(path, robot, self.speed, keep, torque=self.torque, ends=ends, slowest=made[1].slowest)
        raise InvalidInputError("tool_speed", self.speed, wanted)


def steady_segments(begin: float, end: float, speed: float) -> list[Segment]:
    """Segments that limit the tool's speed between two s of a path, and make short ramps possible at both.

    The ends of segments are points of the grid of `retime`: these are dense near both ends.
    """
    width = end - begin
    return [Segment(begin=begin + edge * width, end=end - edge * width, tool_speed=speed) for edge in (0.0, *EDGES)]


def slower(
    path: JointPath,
    robot: Robot,
    speed: float,
    keep: Callable[[float], bool],
    *,
    torque: bool,
    ends: tuple[float, float] = (0.0, 1.0),
    slowest: float = 0.0,
) -> str:
    """What is allowed instead of a constant speed [m/s] that is not possible on a path: the fastest that is, and why.

    `keep` tells whether a speed is kept; `ends` are the s of the ends on the path of the tool. It slows to `slowest` [m/s]
    where it may; 0: it may not.
    """

    def where(s: float) -> str:
        pose = np.array(robot.kinematics().pose(path(np.array([s]))))[0]
        return place(ends[0] + s * (ends[1] - ends[0]), pose[:3, 3])

    still = standing(path, robot)
    if still is not None:
        return f"a path that is split {where(still)}: the tool stands still there on this motion, or nearly"
    inside, ramp = limits_bound(path, robot, torque=torque)
    fastest = _fastest(keep, min(inside.speed, ramp.speed), speed)
    if fastest is None:
        return f"a slower one: {inside.reason(where)}"
    binds = inside if fastest >= BINDS * inside.speed else ramp
    wanted = f"at most {fastest:g} m/s, the fastest constant speed of the tool on this motion: {binds.reason(where)}"
    share = np.ceil(1e3 * (1 - slowest / speed) + 1) / 1e3
    if slowest >= BINDS * fastest and share <= MOST_SLOWDOWN:
        wanted += f". With slowdown={share:g} the tool slows to {slowest:.3g} m/s where limits demand it"
    return wanted


@dataclass(frozen=True, kw_only=True)
class SpeedBound:
    """Estimate of the fastest constant speed of the tool [m/s], and the limit that sets it: kind, joint and s of the path."""

    speed: float
    kind: str
    joint: str
    s: float
    on_ramp: bool = False

    def reason(self, where: Callable[[float], str]) -> str:
        """The limit as a clause; `where` names a place."""
        ramp = " to or from rest on a tenth of the path," if self.on_ramp else ""
        return f"the {self.kind} limit of {self.joint} allows no faster one{ramp} {where(self.s)}"


def standing(path: JointPath, robot: Robot) -> float | None:
    """An s inside a joint path at which the tool has to stand still; None for none."""
    moving = MovingPath(path)
    stopped = stops(moving.path, STANDSTILL)[1:-1]
    if stopped:
        return moving.given(stopped[0])
    s = np.linspace(0.0, 1.0, SPEED_PLACES)
    pace = ToolSpeed(robot)(path(s), path(s, 1))[1:-1]
    return float(s[1 + int(pace.argmin())]) if pace.min() <= IN_PLACE * pace.mean() else None


def limits_bound(
    path: JointPath, robot: Robot, *, torque: bool = False, at_ramps: bool = True
) -> tuple[SpeedBound, SpeedBound]:
    """What limits a constant speed of the tool on a path without stops: between its ends, and on the ramps.

    At a constant speed v of the tool the joints' velocities are v dq/dl, their accelerations v² d²q/dl² and their jerks
    v³ d³q/dl³, where l is the length of the tool's way. On a straight ramp of length d, v² <= 2 d a with the acceleration a
    along it, and v³ <= d² j with the jerk j. Between the ends is also where ramps can be, unless `at_ramps` is False.
    """
    curve = ArcLength(path, 0.0, 1.0, ToolSpeed(robot))
    length, limits, n = curve.fine(LIMIT_POINTS), robot.limits, path.n
    along = LimitsAlong(limits, (), np.empty((0, 2)))
    rows = path_dynamics(curve, length, along, robot.model if torque else None, None)
    unit, size, ramp = rows.speed_unit, curve.length, RAMP * curve.length
    tangent, curvature = rows.tangent / size, rows.curvature / size**2
    with np.errstate(divide="ignore"):
        squared = (1 - np.sign(rows.x) * rows.constant) / np.maximum(np.abs(rows.x), 1e-300) * unit**2
        rise = (1 - np.abs(rows.constant)) / np.maximum(np.abs(rows.u), 1e-300) * unit**2 / size
        third = np.gradient(curvature, length, axis=0)
        jerks = {"jerk": np.cbrt(limits.jerk / np.maximum(np.abs(third), 1e-300))}
        inside = {"velocity": limits.velocity / np.maximum(np.abs(tangent), 1e-300)} | jerks
        begun = {"jerk": np.cbrt(ramp**2 * limits.jerk / np.maximum(np.abs(tangent), 1e-300))}
    for k, kind in enumerate(("acceleration", "effort")[: rows.u.shape[1] // n]):
        inside[kind] = np.sqrt(np.maximum(squared[:, k * n : (k + 1) * n], 0.0))
        begun[kind] = np.sqrt(2 * ramp * np.maximum(rise[:, k * n : (k + 1) * n], 0.0))
    on_ramp = (length < ramp) | (length > size - ramp)
    s = curve.s(length)

    def smallest(bounds: dict[str, Array], some: NDArray[np.bool_], on_ramp: bool) -> SpeedBound:
        kind = min(bounds, key=lambda each: float(bounds[each][some].min()))
        k, joint = np.unravel_index(int(bounds[kind][some].argmin()), bounds[kind][some].shape)
        value = float(bounds[kind][some][k, joint])
        return SpeedBound(speed=value, kind=kind, joint=robot.joint_names[joint], s=float(s[some][k]), on_ramp=on_ramp)

    between = np.ones(len(s), dtype=np.bool_)
    between[[0, -1]] = False
    if not at_ramps:
        between[on_ramp] = False
    return smallest(inside, between, False), smallest(begun, on_ramp, True)


def _fastest(keep: Callable[[float], bool], guess: float, asked: float) -> float | None:
    """The fastest constant speed below one that is not kept, in three digits, found by bisection; None for none."""
    low, high, speed, more = 0.0, asked, round_down(min(0.999 * guess, LESS**0.5 * asked), 3), MORE
    for _ in range(TRIES):
        try:
            holds = keep(speed)
        except PlanningError:
            holds = False
        low, high = (speed, high) if holds else (low, speed)
        if high <= CLOSE * low:
            break
        speed = round_down(min(np.sqrt(low * high), more * low) if low else LESS * high, 3)
        more = more**2 if holds else more
        if speed <= low:
            break
    return low or None
