"""CartesianPath: the poses T(s) of a tool along a path in space, s in [0, 1].

Curves through given poses, twice continuously differentiable, that stay near the polygon of the given ones.

That is the cubic spline through them where it does so. Elsewhere, as at poses that are nearly repeated, it is a PoseCurve.

Between two given poses the tool moves on the straight piece of the polygon, p + u Δp and R exp(u Δω), plus a small shift δ(u)
of its own, a quintic polynomial (3,) that is zero at both ends. Its slopes there follow from the velocity m that the curve has
at the given pose, δ' = m - Δ / h, and its second derivatives from the acceleration there. So both are continuous by
construction, and the distance from the polygon is at most ‖δ‖, which bounds on velocities and accelerations keep small.
Position and rotation are done alike; velocities of a rotation are those in the tool frame.

At each pose the velocity depends on its two neighbours alone: a mean of the velocities of both pieces, as long as on the circle
through poses of equal distance, and shorter at sharp turns. Where one piece is much shorter than the other, as at a pose that
is there twice but for rounding, it counts by its length: its direction means nothing for the longer one.
"""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
import pinocchio as pin

from manipplan.paths.table import Table
from manipplan.paths.tolerance import distinct
from manipplan.support.checks import (
    COINCIDENT,
    Array,
    ArrayLike,
    existing_file,
    finite_array,
    flag,
    number,
    number_array,
    pose_matrix,
    unit_quaternion,
    unit_vector,
    whole_number,
)
from manipplan.support.display import one_line
from manipplan.support.errors import FileFormatError, InvalidInputError
from manipplan.symbolic.free_motion import rotation_vectors, rotations_of

#: Distance from the polygon that counts as near, as a share of the longest of a piece and its two neighbours.
NEAR = 1 / 8
#: Samples of a spline on each piece, the share of the distance that they may use, and its largest length over the polygon's.
INSIDE, CERTAIN, LONGEST = 12, 0.9, 1.01
#: Largest slope of the curve across a piece of the polygon, as a share of its slope along it: as on a circle through poses
#: every 22°. It is larger on the shorter of two pieces, which adds less to the length, and smaller at turns beyond 90°.
ACROSS = 0.19
#: Largest velocity at a pose, as a multiple of that on either piece, and largest change of it over a piece.
FASTEST, CHANGE = 1.1, 2.0
#: How many times shorter a piece is whose direction does not count.
MUCH_SHORTER = 40
#: Largest factor by which a velocity is longer than the chord between the neighbours of a pose says.
LONGER = 1.25
#: What a ratio to zero counts as.
LARGE = 1e100


class PoseSpline:
    """The cubic splines of positions and rotations through poses (k, 4, 4) at increasing s (k,); k >= 2."""

    def __init__(self, s: Array, poses: Array) -> None:
        from scipy.interpolate import CubicSpline
        from scipy.spatial.transform import Rotation, RotationSpline

        self.s, self.poses = s, poses
        self._positions = CubicSpline(s, poses[:, :3, 3])
        self._rotations = RotationSpline(s, Rotation.from_matrix(poses[:, :3, :3]))

    def __call__(self, s: Array) -> tuple[Array, Array]:
        """Positions (m, 3) and rotations (m, 3, 3) at s (m,)."""
        return np.asarray(self._positions(s)), np.asarray(self._rotations(s).as_matrix()).reshape(-1, 3, 3)

    @property
    def stays_near(self) -> bool:
        """Whether each piece stays within `NEAR` of that of the polygon, and the length within `LONGEST`, at samples."""
        count = len(self.s) - 1
        u = np.linspace(0.0, 1.0, INSIDE + 1)[1:-1]
        positions, rotations = self((self.s[:-1, None] + np.diff(self.s)[:, None] * u).ravel())
        turned = rotation_vectors(np.swapaxes(np.repeat(self.poses[:-1, :3, :3], len(u), axis=0), 1, 2) @ rotations)
        moved = positions - np.repeat(self.poses[:-1, :3, 3], len(u), axis=0)
        for chords, along in ((np.diff(self.poses[:, :3, 3], axis=0), moved), (turns_between(self.poses), turned)):
            sizes = _norms(chords)[:, 0]
            whole = np.repeat(chords, len(u), axis=0)
            share = np.clip(_ratio((along * whole).sum(axis=1, keepdims=True), _norms(whole) ** 2), 0.0, 1.0)
            off = _norms(along - share * whole).reshape(count, len(u)).max(axis=1)
            points = np.concatenate([np.zeros((count, 1, 3)), along.reshape(count, len(u), 3), chords[:, None]], axis=1)
            length = float(np.linalg.norm(np.diff(points, axis=1), axis=2).sum())
            if (off > CERTAIN * neighbourhood(sizes) + 1e-12).any() or length > LONGEST * sizes.sum() + 1e-12:
                return False
        return True


def curve_through(s: Array, poses: Array) -> "PoseSpline | PoseCurve":
    """The spline through poses where that stays near their polygon, since it needs less acceleration; else the PoseCurve."""
    spline = PoseSpline(s, poses)
    return spline if spline.stays_near else PoseCurve(s, poses)


class PoseCurve:
    """The curve through poses (k, 4, 4) at increasing s (k,); k >= 2."""

    def __init__(self, s: Array, poses: Array) -> None:
        self.s, self.poses = s, poses
        widths = np.diff(s)[:, None]
        moves = np.diff(poses[:, :3, 3], axis=0)
        self.turns = turns_between(poses)
        self.shifts = _shifts(widths, moves, turns=False), _shifts(widths, self.turns, turns=True)

    def __call__(self, s: Array) -> tuple[Array, Array]:
        """Positions (m, 3) and rotations (m, 3, 3) at s (m,)."""
        piece = np.clip(np.searchsorted(self.s, s, side="right") - 1, 0, len(self.s) - 2)
        u = ((s - self.s[piece]) / (self.s[piece + 1] - self.s[piece]))[:, None]
        begins, ends = self.poses[piece], self.poses[piece + 1]
        weights = np.stack([u * (1 - u) ** 3 * (1 + 3 * u), (u - 1) * u**3 * (4 - 3 * u)], axis=1)
        weights = np.concatenate([weights, np.stack([u**2 * (1 - u) ** 3 / 2, (1 - u) ** 2 * u**3 / 2], axis=1)], axis=1)
        moved, turned = ((weights * shifts[piece]).sum(axis=1) for shifts in self.shifts)
        positions = (1 - u) * begins[:, :3, 3] + u * ends[:, :3, 3] + moved
        return positions, begins[:, :3, :3] @ rotations_of(u * self.turns[piece]) @ rotations_of(turned)


def turns_between(poses: Array) -> Array:
    """Rotation vectors (k - 1, 3) from each of poses (k, 4, 4) to the next one, in the frame of the first."""
    return rotation_vectors(np.swapaxes(poses[:-1, :3, :3], 1, 2) @ poses[1:, :3, :3])


def neighbourhood(sizes: Array) -> Array:
    """How far a path may be from the pieces of a polygon whose lengths or angles are `sizes` (..., p)."""
    wide = np.pad(sizes, [(0, 0)] * (sizes.ndim - 1) + [(1, 1)])
    return np.asarray(NEAR * np.maximum(np.maximum(wide[..., :-2], wide[..., 1:-1]), wide[..., 2:]))


def _shifts(widths: Array, chords: Array, *, turns: bool) -> Array:
    """First derivatives at both ends of each piece and second ones, over u, of the shift δ: (p, 4, 3).

    For widths (p, 1) of the pieces in s, and their moves or, with `turns`, their rotation vectors (p, 3).
    """
    speeds = chords / widths
    velocity = _velocities(widths, chords, speeds)
    acceleration = _accelerations(widths, chords, speeds, velocity)
    slopes = [widths * (each - speeds) for each in (velocity[:-1], velocity[1:])]
    bends = [widths**2 * each for each in (acceleration[:-1], acceleration[1:])]
    if turns:  # the tool frame turns along the piece
        bends = [bend - np.cross(chords, slope) for bend, slope in zip(bends, slopes, strict=True)]
    return np.stack([*slopes, *bends], axis=1)


def _velocities(widths: Array, chords: Array, speeds: Array) -> Array:
    """The velocity at each pose, (p + 1, 3)."""
    before, after = speeds[:-1], speeds[1:]
    left, right = widths[:-1], widths[1:]
    mean = (chords[:-1] + chords[1:]) / (left + right)
    smooth = (right * before + left * after) / (left + right)
    slower = np.minimum(_norms(before), _norms(after))
    bent = smooth - mean
    room = slower * np.minimum(left, right) / np.maximum(left, right)
    mean = mean + bent * np.minimum(1.0, _ratio(room, _norms(bent)))
    straight = _ratio(_norms(chords[:-1] + chords[1:]), _norms(chords[:-1]) + _norms(chords[1:]))
    mean = mean * np.minimum(_ratio(2.0, straight * (1 + straight)), LONGER)
    velocity = np.empty((len(chords) + 1, 3))
    velocity[1:-1] = mean * _limited(mean, chords, speeds)
    for end, beside, piece in ((0, 1, 0), (-1, -2, -1)):  # mirrored: as on a circle
        velocity[end] = speeds[piece]
        if len(chords) > 1:
            velocity[end] -= _across(velocity[beside], speeds[piece])
    return velocity


def _limited(velocity: Array, chords: Array, speeds: Array) -> Array:
    """Factors (p - 1, 1) that keep velocities at inner poses within bounds on the pieces before and after."""
    factor, lengths = np.ones((len(velocity), 1)), _norms(chords)
    ahead = speeds * _ratio(1.0, _norms(speeds))
    half_turn = _norms(ahead[:-1] + ahead[1:]) / 2  # the cosine of half the angle by which the polygon turns
    uneven = np.maximum(_ratio(lengths[:-1], lengths[1:]), _ratio(lengths[1:], lengths[:-1])) - 1
    turning = np.minimum(1.0, np.sqrt(2) * half_turn + (np.minimum(uneven, MUCH_SHORTER) / MUCH_SHORTER) ** 2)
    for mine, other in ((slice(None, -1), slice(1, None)), (slice(1, None), slice(None, -1))):
        fastest, ratio = turning * _norms(speeds[mine]), np.maximum(1.0, _ratio(lengths[other], lengths[mine]))
        across = _norms(_across(velocity, speeds[mine]))
        factor = np.minimum(factor, _ratio(FASTEST * fastest, _norms(velocity)))
        factor = np.minimum(factor, _ratio(ACROSS * fastest * np.sqrt((1 + ratio) / 2), across))
    return factor


def _accelerations(widths: Array, chords: Array, speeds: Array, velocity: Array) -> Array:
    """The acceleration at each pose, (p + 1, 3): between those of cubic pieces, nearer to that of the longer one."""
    ends = 6 * speeds - 2 * velocity[:-1] - 2 * velocity[1:]
    first, last = ends - 2 * velocity[:-1], 2 * velocity[1:] - ends
    made = np.concatenate([first[:1] / widths[:1], np.empty((len(chords) - 1, 3)), last[-1:] / widths[-1:]])
    made[1:-1] = (widths[:-1] * last[:-1] + widths[1:] * first[1:]) / (widths[:-1] ** 2 + widths[1:] ** 2)
    bound = CHANGE * _norms(speeds) / widths
    most = np.minimum(np.concatenate([bound[:1], bound]), np.concatenate([bound, bound[-1:]]))
    return np.asarray(made * np.minimum(1.0, _ratio(most, _norms(made))))


def _across(vectors: Array, along: Array) -> Array:
    """The parts of vectors (..., 3) across directions (..., 3)."""
    square = (along**2).sum(axis=-1, keepdims=True)
    return np.asarray(vectors - along * _ratio((vectors * along).sum(axis=-1, keepdims=True), square))


def _norms(vectors: Array) -> Array:
    return np.asarray(np.linalg.norm(vectors, axis=-1, keepdims=True))


def _ratio(above: ArrayLike, below: Array) -> Array:
    """above / below, where `below` is not zero; a large number there."""
    shape = np.broadcast_shapes(np.shape(above), below.shape)
    return np.asarray(np.divide(above, below, out=np.full(shape, LARGE), where=np.broadcast_to(below > 1 / LARGE, shape)))


#: Way that an angle of 1 rad counts as, between the poses that a path goes through [m].
RADIAN = 0.1
#: Distance within which a path returns to its first pose [m, or entry of the rotation].
RETURNS = 1e-9
#: Distance in s within which two knots are one.
KNOT_TOLERANCE = 1e-12
#: Maximum number of poses of a sample.
MOST_SAMPLES = 1_000_000
#: Columns of a CSV file of poses: position [m], then the quaternion.
COLUMNS = ("x", "y", "z", "qx", "qy", "qz", "qw")


class CartesianPath(ABC):
    """Poses T(s), (4, 4), of a tool for s in [0, 1]; build one with `line`, `circle`, `through` or `from_csv`."""

    def __call__(self, s: ArrayLike) -> Array:
        """T(s), (..., 4, 4) for s (...); raises InvalidInputError for s outside [0, 1]."""
        s = number_array("s", s)
        if not ((s >= 0) & (s <= 1)).all():
            raise InvalidInputError("s", s, "numbers from 0 to 1")
        positions, rotations = self._at(s.ravel())
        poses = np.tile(np.eye(4), (s.size, 1, 1))
        poses[:, :3, :3], poses[:, :3, 3] = rotations, positions
        return np.asarray(poses.reshape(*s.shape, 4, 4))

    def sample(self, n: int) -> Array:
        """Poses (n, 4, 4) at equally spaced s, including both ends; n >= 2."""
        return self(np.linspace(0.0, 1.0, whole_number("n", n, least=2, most=MOST_SAMPLES)))

    @property
    def length(self) -> float:
        """Length of the tool's path [m], from 2000 chords."""
        positions, _ = self._at(np.linspace(0.0, 1.0, 2001))
        return float(np.linalg.norm(np.diff(positions, axis=0), axis=1).sum())

    @property
    def closes(self) -> bool:
        """Whether the last pose is the first one."""
        first, last = self(np.array([0.0, 1.0]))
        return bool(np.abs(first - last).max() <= RETURNS)

    @property
    def knots(self) -> Array:
        """Parameters s (k,) of the poses through which the path was laid, with 0 and 1."""
        return np.array([0.0, 1.0])

    @property
    def given(self) -> Array | None:
        """The poses (k, 4, 4) through which the path was laid, near whose polygon it stays; None where there are none."""
        return None

    def part(self, begin: float, end: float) -> "CartesianPath":
        """The part from s = begin to s = end > begin. On a closed path the end may be beyond 1, at most one round farther."""
        begin = number("begin", begin, least=0.0, most=1.0)
        end = number("end", end, above=begin, most=1.0 + begin)
        if end > 1.0 and not self.closes:
            raise InvalidInputError("end", end, "at most 1, as the path's last pose is not its first")
        return Stretch(path=self, begin=begin, end=end)

    @abstractmethod
    def _at(self, s: Array) -> tuple[Array, Array]:
        """Positions (k, 3) and rotations (k, 3, 3) at s (k,)."""

    @classmethod
    def line(cls, start: Any, end: Any) -> "CartesianPath":
        """The straight path from pose `start` to `end`, each (4, 4) or pin.SE3, turning at a constant rate about one axis."""
        return Line(start=pose_matrix("start", start), end=pose_matrix("end", end))

    @classmethod
    def circle(
        cls, start: Any, centre: ArrayLike, axis: ArrayLike, angle: float = 2 * np.pi, *, turning: bool = False
    ) -> "CartesianPath":
        """An arc from pose `start` about an axis.

        Args:
            start: pose (4, 4) or pin.SE3.
            centre: a point on the axis (3,) [m].
            axis: its direction (3,).
            angle: of the arc [rad], positive by the right-hand rule.
            turning: whether the tool turns with the arc; otherwise it keeps its rotation.
        """
        return ArcPath(
            start=pose_matrix("start", start),
            centre=finite_array("centre", centre, (3,)),
            axis=unit_vector("axis", axis),
            angle=number("angle", angle),
            turning=flag("turning", turning),
        )

    @classmethod
    def through(cls, poses: Sequence[Any] | Array) -> "CartesianPath":
        """A path through poses, each (4, 4) or pin.SE3, at least two; it is twice continuously differentiable.

        It stays near the polygon of the poses, whose pieces are straight and turn about one axis each: its positions within an
        eighth of the longest of a piece and its neighbours, usually a twentieth, and its rotations within an eighth of the
        largest of their angles. Its length is that of the polygon, to some 1 %. So it is round like a circle through the poses
        where they turn by up to 22° each, and turns sharper corners near the pose. Of poses nearer than 1e-6 m and rad to the
        one before it takes one.

        s is proportional to the distance between neighbours, in which 1 rad counts as 0.1 m.
        """
        if not isinstance(poses, list | tuple | np.ndarray) or len(poses) < 2:
            raise InvalidInputError("poses", poses, "at least two poses")
        matrices = np.array([pose_matrix(f"poses[{k}]", pose) for k, pose in enumerate(poses)])
        positions, rotations = matrices[:, :3, 3], matrices[:, :3, :3].reshape(-1, 9)
        matrices = matrices[
            distinct(
                len(matrices),
                lambda i, j: np.maximum(
                    np.linalg.norm(positions[i] - positions[j], axis=1),
                    np.linalg.norm(rotations[i] - rotations[j], axis=1) / np.sqrt(2),  # √8 sin(angle / 2) / √2
                ),
            )
        ]
        if len(matrices) < 2:
            wanted = f"at least two poses that differ: all are within {COINCIDENT:g} m and rad of the first one"
            raise InvalidInputError("poses", f"{len(poses)} poses", wanted)
        turns = np.linalg.norm(turns_between(matrices), axis=1)
        steps = np.linalg.norm(np.diff(matrices[:, :3, 3], axis=0), axis=1) + RADIAN * turns
        s = np.concatenate([[0.0], np.cumsum(steps) / steps.sum()])
        s[-1] = 1.0
        return SplinePath(s=s, poses=matrices)

    @classmethod
    def from_csv(cls, file: str | Path) -> "CartesianPath":
        """The path through the poses of a CSV file with the columns x, y, z [m], qx, qy, qz, qw, in any order, as by `through`.

        Lines that begin with # are left out. Raises a FileFormatError that shows the faulty row.
        """
        path = existing_file("file", file)
        table = Table.read(path, comments=True)
        if sorted(table.header) != sorted(COLUMNS):
            found = f"{path} with the first line {','.join(table.header)}"
            raise FileFormatError("file", found, f"a first line {','.join(COLUMNS)}, in any order")
        poses, columns = [], [table.header.index(name) for name in COLUMNS]
        for (row, cells), values in zip(table.rows, table.numbers(columns), strict=True):
            try:
                quaternion = unit_quaternion("quaternion", values[3:], "qx, qy, qz, qw")
            except InvalidInputError as error:
                raise FileFormatError("file", f"{path}, row {row}: {','.join(cells)}", error.allowed) from error
            poses.append(pin.SE3(pin.Quaternion(quaternion).matrix(), values[:3]).homogeneous)
        return cls.through(poses)


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class Line(CartesianPath):
    """The straight path between two poses (4, 4)."""

    start: Array
    end: Array

    def _at(self, s: Array) -> tuple[Array, Array]:
        positions = self.start[:3, 3] + s[:, None] * (self.end - self.start)[:3, 3]
        turn = pin.log3(self.start[:3, :3].T @ self.end[:3, :3])
        if not turn.any():
            return positions, np.broadcast_to(self.start[:3, :3], (len(s), 3, 3))
        return positions, np.array([self.start[:3, :3] @ pin.exp3(each * turn) for each in s]).reshape(-1, 3, 3)

    @property
    def length(self) -> float:
        """Length of the tool's path [m]."""
        return float(np.linalg.norm((self.end - self.start)[:3, 3]))


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class ArcPath(CartesianPath):
    """An arc of a circle from pose `start` (4, 4) by `angle` about an axis through `centre`."""

    start: Array
    centre: Array
    axis: Array
    angle: float
    turning: bool

    def _at(self, s: Array) -> tuple[Array, Array]:
        turns = np.array([pin.exp3(each * self.angle * self.axis) for each in s]).reshape(-1, 3, 3)
        positions = self.centre + turns @ (self.start[:3, 3] - self.centre)
        still = np.broadcast_to(self.start[:3, :3], turns.shape)
        return positions, turns @ self.start[:3, :3] if self.turning else still


@dataclass(frozen=True, kw_only=True, eq=False)
class SplinePath(CartesianPath):
    """The path through `poses` (k, 4, 4) at s (k,), near their polygon."""

    s: Array
    poses: Array

    @property
    def knots(self) -> Array:
        return self.s

    @property
    def given(self) -> Array:
        return self.poses

    @cached_property
    def _curve(self) -> PoseSpline | PoseCurve:
        return curve_through(self.s, self.poses)

    def _at(self, s: Array) -> tuple[Array, Array]:
        return self._curve(s)


@dataclass(frozen=True, kw_only=True, eq=False)
class Stretch(CartesianPath):
    """The part of a path from s = begin to s = end, which goes around a closed path where it is beyond 1."""

    path: CartesianPath
    begin: float
    end: float

    @property
    def knots(self) -> Array:
        whole = self.path.knots
        inner = (np.concatenate([whole, 1.0 + whole]) - self.begin) / (self.end - self.begin)
        return np.concatenate([[0.0], np.unique(inner[(inner > KNOT_TOLERANCE) & (inner < 1.0 - KNOT_TOLERANCE)]), [1.0]])

    def _at(self, s: Array) -> tuple[Array, Array]:
        at = self.begin + s * (self.end - self.begin)
        return self.path._at(np.where(at > 1.0, at - 1.0, at))


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class Offset(CartesianPath):
    """The path of a frame at `offset` (4, 4) in the frame that moves along `path`, such as a tool that holds an object."""

    path: CartesianPath
    offset: Array

    @property
    def knots(self) -> Array:
        return self.path.knots

    def _at(self, s: Array) -> tuple[Array, Array]:
        poses = self.path(s) @ self.offset
        return np.asarray(poses[:, :3, 3]), np.asarray(poses[:, :3, :3])


#: The subclasses by name.
PATHS: dict[str, type[CartesianPath]] = {kind.__name__: kind for kind in (Line, ArcPath, SplinePath, Stretch, Offset)}
