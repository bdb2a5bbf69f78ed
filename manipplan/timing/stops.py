"""Where an arm has to stop on a path, and the path without pieces on which no joint moves.

Limits that change along a path: tighter ones on segments, and limits of the tool speed there.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import pinocchio as pin

from manipplan.paths.joint import JointPath
from manipplan.robots.limits import JointLimits
from manipplan.robots.model_tree import frame_index
from manipplan.robots.robot import Robot
from manipplan.support.checks import COINCIDENT, Array, instance, number
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError

#: Below this share of the mean speed ‖q'‖ the path stands still; above this angle [rad] it turns a corner.
STANDSTILL = 1e-6
CORNER = 1e-4


class MovingPath:
    """A path without pieces that stand still, and the conversion between its parameter and that of the given path.

    A piece stands still where it stays within `COINCIDENT` of where the one kept before ends. The next one begins there.
    """

    def __init__(self, path: JointPath) -> None:
        self._given = self._stretched = np.array([0.0, 1.0])
        self.path = path
        if (_extents(path.control, path.control[:, :1]) >= COINCIDENT).all():
            return
        pieces: list[Array] = []
        moving, at = np.zeros(len(path.control), dtype=bool), path.start
        for k, piece in enumerate(path.control):
            moving[k] = _extents(piece, at) >= COINCIDENT
            if moving[k]:
                pieces.append(_begun(piece, at))
                at = piece[-1]
        pieces[-1] = _begun(pieces[-1][::-1], path.goal)[::-1]
        widths = np.diff(path.breaks)
        gained = np.concatenate([[0.0], np.cumsum(np.where(moving, widths, 0.0))]) / widths[moving].sum()
        gained[-1] = 1.0
        self._given, self._stretched = path.breaks, gained
        breaks = np.concatenate([[0.0], gained[1:][moving]])
        breaks[-1] = 1.0
        self.path = JointPath(breaks=breaks, control=np.array(pieces))

    def here(self, s: Array) -> Array:
        """The parameter on `path` for s on the given path."""
        return np.asarray(np.interp(s, self._given, self._stretched))

    def given(self, s: float) -> float:
        """The parameter on the given path for s on `path`."""
        return float(np.interp(s, self._stretched, self._given))


def _extents(control: Array, at: Array) -> Array:
    """Largest distance (...) of control points (..., d + 1, n) from a point."""
    return np.asarray(np.linalg.norm(control - at, axis=-1).max(axis=-1))


def _begun(piece: Array, at: Array) -> Array:
    """The control points (d + 1, n) of a piece that begins at a point close by, in the same direction if it is curved."""
    moved = piece.copy()
    moved[: 2 if len(piece) > 3 else 1] += at - piece[0]
    moved[0] = at
    return moved


def turn_cosine(before: Array, after: Array) -> float:
    """The cosine of the angle between two pieces, given by their control points (d + 1, n), where the first ends."""
    arriving, leaving = before[-1] - before[-2], after[1] - after[0]
    return float(arriving @ leaving / max(np.linalg.norm(arriving) * np.linalg.norm(leaving), 1e-300))


def stops(path: JointPath, standstill: float) -> list[float]:
    """Parameters at which the arm must stop: the ends, corners between pieces, and points where q' vanishes."""
    arriving = path.control[:-1, -1] - path.control[:-1, -2]
    leaving = path.control[1:, 1] - path.control[1:, 0]
    sizes = np.maximum(np.linalg.norm(arriving, axis=1) * np.linalg.norm(leaving, axis=1), 1e-300)
    turned = np.einsum("ij,ij->i", arriving, leaving) < np.cos(CORNER) * sizes
    found = [0.0, *path.breaks[1:-1][turned].tolist()]
    s = np.linspace(0.0, 1.0, 2001)
    speed = np.linalg.norm(path(s, 1), axis=1)
    mean = speed.mean()
    for k in np.flatnonzero((speed[1:-1] <= speed[:-2]) & (speed[1:-1] < speed[2:]) & (speed[1:-1] < 0.05 * mean)) + 1:
        low, high = s[k - 1], s[k + 1]
        for _ in range(60):
            thirds = low + (high - low) * np.array([1 / 3, 2 / 3])
            left, right = np.linalg.norm(path(thirds, 1), axis=1)
            low, high = (low, thirds[1]) if left < right else (thirds[0], high)
        middle = (low + high) / 2
        if np.linalg.norm(path(middle, 1)) < standstill * mean:
            found.append(float(middle))
    found.sort()
    apart = [s for k, s in enumerate(found) if k == 0 or (s - found[k - 1] > 1e-9 and s < 1 - 1e-9)]
    return [*apart, 1.0]


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class Segment:
    """A part of a path on which tighter limits hold; where segments overlap, the tightest limit of each kind applies.

    Attributes:
        begin, end: path parameter s where it begins and ends, 0 <= begin < end <= 1.
        limits: joint limits there, which apply where they are tighter than the whole path's; None: those of the whole path.
        velocity, acceleration, jerk: shares in (0, 1] of these limits.
        tool_speed: maximum speed of the tool's origin there [m/s]; inf: no limit.
    """

    begin: float
    end: float
    limits: JointLimits | None = None
    velocity: float = 1.0
    acceleration: float = 1.0
    jerk: float = 1.0
    tool_speed: float = np.inf

    def __post_init__(self) -> None:
        begin = number("segment.begin", self.begin, least=0.0, most=1.0)
        end = number("segment.end", self.end, least=0.0, most=1.0)
        if not begin < end:
            raise InvalidInputError("segment.end", self.end, f"a number above begin = {begin:g}, at most 1")
        for name in ("velocity", "acceleration", "jerk"):
            number(f"segment.{name}", getattr(self, name), above=0.0, most=1.0)
        if not (isinstance(self.tool_speed, float) and self.tool_speed == np.inf):
            number("segment.tool_speed", self.tool_speed, above=0.0)
        if self.limits is not None:
            instance("segment.limits", self.limits, JointLimits)


@dataclass(frozen=True, kw_only=True, eq=False)
class Bounds:
    """Limits at k places of a path: (k, n) each, `tool_speed` (k,); inf where there is no limit."""

    velocity: Array
    acceleration: Array
    jerk: Array
    effort: Array
    tool_speed: Array


class LimitsAlong:
    """The limits at every s of a path; segments include their ends, so the tighter side applies there.

    `places` are the parameters of segment ends on the path that is timed, which may differ from those on the given path.
    """

    def __init__(self, limits: JointLimits, segments: Sequence[Segment], places: Array) -> None:
        self.n = limits.n
        self.limits = limits
        self.segments = tuple(segments)
        self.places = places
        self._rows = [self._tighten(limits, segment) for segment in self.segments]

    @property
    def edges(self) -> Array:
        """Path parameters at which limits change, sorted."""
        return np.unique(self.places)

    @property
    def has_jerk(self) -> bool:
        """Whether a jerk limit is finite anywhere."""
        return bool(np.isfinite([self.limits.jerk, *(row["jerk"] for row in self._rows)]).any())

    @property
    def has_tool_speed(self) -> bool:
        """Whether the tool's speed is limited anywhere."""
        return any(np.isfinite(segment.tool_speed) for segment in self.segments)

    def at(self, s: Array, *, around: float = 0.0) -> Bounds:
        """Limits at s (k,); each segment is extended by `around` at both ends."""
        kinds = ("velocity", "acceleration", "jerk", "effort")
        values = {kind: np.broadcast_to(getattr(self.limits, kind), (len(s), self.n)) for kind in kinds}
        tool = np.full(len(s), np.inf)
        if self.segments:
            values = {kind: np.array(each) for kind, each in values.items()}
        for segment, row, (begin, end) in zip(self.segments, self._rows, self.places, strict=True):
            inside = (s >= begin - around) & (s <= end + around)
            for kind in kinds:
                values[kind][inside] = np.minimum(values[kind][inside], row[kind])
            tool[inside] = np.minimum(tool[inside], segment.tool_speed)
        return Bounds(**values, tool_speed=tool)

    @staticmethod
    def _tighten(limits: JointLimits, segment: Segment) -> dict[str, Array]:
        row = {}
        for kind in ("velocity", "acceleration", "jerk", "effort"):
            value = getattr(limits, kind)
            if segment.limits is not None:
                value = np.minimum(value, getattr(segment.limits, kind))
            row[kind] = value * getattr(segment, kind, 1.0)
        return row


def check_segments(segments: Any, limits: JointLimits) -> tuple[Segment, ...]:
    """The segments given to `retime` as a tuple. Raises InvalidInputError when one does not fit."""
    if isinstance(segments, Segment):
        segments = (segments,)
    if not isinstance(segments, list | tuple):
        raise InvalidInputError("segments", segments, "a list of Segment")
    for k, segment in enumerate(segments):
        instance(f"segments[{k}]", segment, Segment)
        if segment.limits is not None and segment.limits.n != limits.n:
            raise InvalidInputError(
                f"segments[{k}].limits", f"limits of {segment.limits.n} joints", f"limits of the path's {limits.n} joints"
            )
    return tuple(segments)


class ToolSpeed:
    """Speed of a robot's tool: ‖v‖ with the velocity v = J(q) qd of its origin."""

    def __init__(self, robot: Robot) -> None:
        self.model = robot.model
        self.data = robot.model.createData()
        self.frame = frame_index(robot.model, robot.tool)

    def __call__(self, q: Array, qd: Array) -> Array:
        """Speeds [m/s] (k,) at q, qd (k, n)."""
        found = np.empty((len(q), 3))
        for k, state in enumerate(zip(q, qd, strict=True)):
            pin.forwardKinematics(self.model, self.data, *state)
            found[k] = self._velocity()
        return np.asarray(np.linalg.norm(found, axis=1))

    def rises(self, q: Array, qd: Array, qdd: Array) -> Array:
        """Rates of change of these speeds [m/s²] (k,) at accelerations qdd (k, n)."""
        found = np.empty(len(q))
        for k, state in enumerate(zip(q, qd, qdd, strict=True)):
            pin.forwardKinematics(self.model, self.data, *state)
            velocity = self._velocity()
            acceleration = pin.getFrameClassicalAcceleration(self.model, self.data, self.frame, pin.LOCAL_WORLD_ALIGNED).linear
            found[k] = velocity @ acceleration / max(float(np.linalg.norm(velocity)), 1e-300)
        return found

    def _velocity(self) -> Array:
        return np.asarray(pin.getFrameVelocity(self.model, self.data, self.frame, pin.LOCAL_WORLD_ALIGNED).linear)
