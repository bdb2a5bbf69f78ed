"""JointLimits: the limits of each joint, and the source of each number.

One configuration against the position limits: taken to a limit that it misses by at most the tolerance, refused beyond.
"""

import logging
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING

import numpy as np

from manipplan.support.checks import Array, ArrayLike, configurations, number, number_array, one_of, positive_array, text
from manipplan.support.display import one_line, round_up
from manipplan.support.errors import InvalidInputError

if TYPE_CHECKING:
    from manipplan.robots.robot import Robot

log = logging.getLogger("manipplan")

#: Time to full speed [s], which sets the acceleration limit where neither the user nor the catalogue gives one.
DEFAULT_RAMP_TIME = 0.2


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class JointLimits:
    """Limits of n joints, each (n,), in SI units (rad or m, s, N m or N); inf where there is none.

    `robots.subchain.limits_of` reads them from a description.

    `sources` gives the source of the numbers of each kind: the robot's file, a data sheet, the user, or the default.
    Raises InvalidInputError when a limit is NaN, not above zero, or a lower bound is not below its upper bound.
    """

    lower: Array
    upper: Array
    velocity: Array
    acceleration: Array
    jerk: Array
    effort: Array
    sources: Mapping[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        n = number_array("limits.lower", self.lower).size
        for name in ("lower", "upper"):
            bound = number_array(f"limits.{name}", getattr(self, name))
            if bound.shape != (n,) or np.isnan(bound).any():
                raise InvalidInputError(f"limits.{name}", bound, f"{n} numbers, one per joint, no NaN")
            bound.flags.writeable = False
            object.__setattr__(self, name, bound)
        if not (self.lower < self.upper).all():
            raise InvalidInputError("limits.lower", self.lower, f"below limits.upper = {self.upper.tolist()}")
        for name in ("velocity", "acceleration", "jerk", "effort"):
            object.__setattr__(self, name, positive_array(f"limits.{name}", getattr(self, name), n))

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.lower)

    @property
    def middle(self) -> Array:
        """The middle of each joint's position limits (n,) [rad or m]; 0, or the nearer limit, where they are not finite."""
        is_bounded = np.isfinite(self.lower) & np.isfinite(self.upper)
        low, high = (np.where(is_bounded, each, 0.0) for each in (self.lower, self.upper))
        return np.where(is_bounded, (low + high) / 2, np.clip(0.0, self.lower, self.upper))

    def with_changes(self, changes: Mapping[str, ArrayLike], *, source: str = "given") -> "JointLimits":
        """A copy with other limits, e.g. ``{"acceleration": 5.0}``; one number applies to all joints."""
        known = {f.name for f in fields(self)} - {"sources"}
        if not isinstance(changes, Mapping):
            raise InvalidInputError("changes", changes, f"a mapping with the keys {', '.join(sorted(known))}")
        values, source = {}, text("source", source)
        for name, value in changes.items():
            given = number_array(f"limits.{one_of('limit', name, known)}", value)
            values[name] = np.broadcast_to(given, (self.n,)) if given.ndim == 0 else given
        sources = {**self.sources, **dict.fromkeys(changes, source)}
        return JointLimits(**{name: values.get(name, getattr(self, name)) for name in known}, sources=sources)

    def outside(self, q: Array) -> Array:
        """How far each joint of q (..., n) is outside its position limits [rad or m]; 0 inside."""
        q = configurations("q", q, self.n)
        return np.maximum(np.maximum(self.lower - q, q - self.upper), 0.0)


#: Default of `Robot.limit_tolerance`, what encoders read at a stop, and the largest, beyond which a posture is another one
#: [rad or m].
LIMIT_TOLERANCE, LARGEST_TOLERANCE = 1e-6, 0.1
#: Distance from the limits [rad] up to which a value is no angle in degrees.
NO_DEGREES = 0.5


@dataclass(frozen=True, kw_only=True)
class TakenToLimit:
    """A joint that was given outside a position limit, by at most the tolerance, and was taken to it.

    Attributes:
        argument: what was given, such as start.
        joint: its name.
        value, limit: as given, and where it was taken [rad or m].
        unit: "rad" or "m".
    """

    argument: str
    joint: str
    value: float
    limit: float
    unit: str

    @classmethod
    def of(cls, robot: "Robot", argument: str, joint: int, value: float) -> "TakenToLimit":
        """That of a joint, given by its index."""
        limit = float(np.clip(value, robot.limits.lower[joint], robot.limits.upper[joint]))
        unit = "m" if robot.joint_types[joint] == "prismatic" else "rad"
        return cls(argument=argument, joint=robot.joint_names[joint], value=value, limit=limit, unit=unit)

    @property
    def outside(self) -> float:
        """How far it was outside [rad or m]."""
        return abs(self.value - self.limit)

    def __str__(self) -> str:
        side = "above" if self.value > self.limit else "below"
        limit = enough_digits(self.limit, self.outside)
        return f"{self.argument}: {self.joint} was {self.outside:.3g} {self.unit} {side} its limit {limit}, and was taken to it"


def taken_to_limits(robot: "Robot", argument: str, q: Array, tolerance: float | None = None) -> tuple[TakenToLimit, ...]:
    """The joints of q (n,) outside a limit, if none is by more than the tolerance; by default that of the robot."""
    limits, tolerance = robot.limits, robot.limit_tolerance if tolerance is None else tolerance
    # bounds and sums, not differences: a value made as limit + tolerance is within the tolerance
    if not ((q >= limits.lower - tolerance) & (q <= limits.upper + tolerance)).all():
        return ()
    inside = np.clip(q, limits.lower, limits.upper)
    return tuple(TakenToLimit.of(robot, argument, i, float(q[i])) for i in np.flatnonzero(inside != q).tolist())


def to_limits(robot: "Robot", argument: str, q: Array, tolerance: float | None = None) -> Array:
    """A configuration (n,) taken to the limits that it misses by at most the tolerance; the log names the joints.

    One that misses a limit by more is returned as it is.
    """
    taken = taken_to_limits(robot, argument, q, tolerance)
    for each in taken:
        log.info("%s", each)
    if not taken:
        return q
    inside = np.clip(q, robot.limits.lower, robot.limits.upper)
    inside.flags.writeable = False
    return inside


def check_configuration(robot: "Robot", argument: str, q: ArrayLike, tolerance: float | None) -> Array:
    """One configuration (n,), finite and inside the position limits; see `Robot.configuration`."""
    tolerance = robot.limit_tolerance if tolerance is None else number("tolerance", tolerance, least=0.0)
    q = configurations(argument, q, robot.n)
    if q.ndim != 1:
        raise InvalidInputError(argument, q, f"one configuration of shape ({robot.n},)")
    outside = robot.limits.outside(q)
    if outside.any() and not taken_to_limits(robot, argument, q, tolerance):
        joint = int(outside.argmax())
        name = f"{argument}[{joint}] ({robot.joint_names[joint]})"
        raise InvalidInputError(name, float(q[joint]), _describe_limits(robot, joint, float(q[joint])))
    return to_limits(robot, argument, q, tolerance)


def nearest_turns(robot: "Robot", q: Array, near: Array, *, within_limits: bool = True) -> Array:
    """Configurations (k, n) with each revolute joint at the full turn nearest to `near` (n,), by default inside its limits."""
    turn = np.where(robot.turns, 2 * np.pi, np.inf)
    if not within_limits:
        turns = np.round((near - q) / turn)
        return q + np.where(np.isinf(turn), 0.0, turn) * turns
    most = np.floor((robot.limits.upper - q) / turn)
    least = np.ceil((robot.limits.lower - q) / turn)
    turns = np.clip(np.round((near - q) / turn), np.minimum(least, 0.0), np.maximum(most, 0.0))
    return np.where(turns == 0, q, q + np.where(np.isinf(turn), 0.0, turn) * turns)


def enough_digits(value: float, difference: float) -> str:
    """The number with as many digits, at least six, as tell it from one that differs by `difference`."""
    for digits in range(6, 17):
        text = f"{value:.{digits}g}"
        if not np.isfinite(value) or abs(float(text) - value) <= difference / 100:
            return text
    return repr(value)


def limits_missed(lower: float, upper: float, value: float, unit: str) -> str:
    """The limits that a value is outside of, and by how much."""
    off = max(lower - value, value - upper)
    side = "above" if value > upper else "below"
    return f"{enough_digits(lower, off)} to {enough_digits(upper, off)} {unit}; it is {off:.3g} {unit} {side}"


def _describe_limits(robot: "Robot", joint: int, value: float) -> str:
    """The limits that a value is outside of, by how much, and what helps."""
    lower, upper = float(robot.limits.lower[joint]), float(robot.limits.upper[joint])
    slides = robot.joint_types[joint] == "prismatic"
    off = max(lower - value, value - upper)
    missed = limits_missed(lower, upper, value, "m" if slides else "rad")
    if off <= LARGEST_TOLERANCE:
        return f"{missed}; robot.with_limits(limit_tolerance={round_up(off, 1):g}) takes it to the limit"
    if slides:
        far = off > upper - lower and lower <= value / 1e3 <= upper
        return f"{missed}; {value:g} mm are {value / 1e3:.4g} m" if far else missed
    angle = float(np.deg2rad(value))
    if off > NO_DEGREES and abs(value) > 2 * np.pi and lower <= angle <= upper:
        return f"{missed}; {value:g} degrees are {angle:.4g} rad"
    turned = value + 2 * np.pi * (
        np.ceil((lower - value) / (2 * np.pi)) if value < lower else np.floor((upper - value) / (2 * np.pi))
    )
    if robot.turns[joint] and lower <= turned <= upper:
        return f"{missed}; {turned:.9g} rad is the same posture"
    return missed
