"""SteadySpeed: the speed of the tool on a motion that is to have a constant one, measured on the motion."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, number
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError
from manipplan.timing.segment import ToolSpeed

#: Share by which a constant speed may be below the one that was asked for.
STEADY = 0.01
#: Largest share of the tool's way that a ramp may take. Until SETTLES times the way to the speed, and on the share SHORT of the
#: whole way, dips still belong to the ramp.
RAMP, SETTLES, SHORT = 0.1, 4.0, 1e-3
#: Number of times per sample interval at which speeds are measured, and of places at which a path's speed is compared.
BETWEEN, PLACES = 4, 2001
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
    steps = np.linalg.norm(np.diff(path.sample(PLACES)[:, :3, 3], axis=0), axis=1)
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
