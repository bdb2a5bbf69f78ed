"""CartesianPath: the poses T(s) of a tool along a path in space, s in [0, 1]."""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
import pinocchio as pin
from numpy.typing import ArrayLike

from manipplan.paths.distinct import distinct
from manipplan.paths.pose_curve import PoseCurve, PoseSpline, curve_through, rotation_vectors
from manipplan.paths.tables import Table
from manipplan.support.checks import (
    Array,
    existing_file,
    finite_array,
    flag,
    number,
    number_array,
    pose_matrix,
    unit_quaternion,
    whole_number,
)
from manipplan.support.display import one_line
from manipplan.support.errors import FileFormatError, InvalidInputError
from manipplan.support.tolerances import SAME

#: Way that an angle of 1 rad counts as, between the poses that a path goes through [m].
RADIAN = 0.1
#: Distance within which a path returns to its first pose [m, or entry of the rotation].
RETURNS = 1e-9
#: Distance in s within which two knots are one.
SAME_KNOT = 1e-12
#: Maximum number of poses of a sample.
MOST_SAMPLES = 1_000_000
#: Columns of a CSV file of poses: position [m], then the quaternion.
COLUMNS = ("x", "y", "z", "qw", "qx", "qy", "qz")


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
        axis = finite_array("axis", axis, (3,))
        length = number("the length of axis", float(np.linalg.norm(axis)), above=1e-9)
        return ArcPath(
            start=pose_matrix("start", start),
            centre=finite_array("centre", centre, (3,)),
            axis=axis / length,
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
            wanted = f"at least two poses that differ: all are within {SAME:g} m and rad of the first one"
            raise InvalidInputError("poses", f"{len(poses)} poses", wanted)
        turns = rotation_vectors(np.swapaxes(matrices[:-1, :3, :3], 1, 2) @ matrices[1:, :3, :3])
        steps = np.linalg.norm(np.diff(matrices[:, :3, 3], axis=0), axis=1) + RADIAN * np.linalg.norm(turns, axis=1)
        s = np.concatenate([[0.0], np.cumsum(steps) / steps.sum()])
        s[-1] = 1.0
        return SplinePath(s=s, poses=matrices)

    @classmethod
    def from_csv(cls, file: str | Path) -> "CartesianPath":
        """The path through the poses of a CSV file with the columns x, y, z [m], qw, qx, qy, qz, as by `through`.

        Lines that begin with # are left out. Raises a FileFormatError that shows the faulty row.
        """
        path = existing_file("file", file)
        table = Table.read(path, comments=True)
        if table.header != COLUMNS:
            found = f"{path} with the first line {','.join(table.header)}"
            raise FileFormatError("file", found, f"a first line {','.join(COLUMNS)}")
        poses = []
        for (row, cells), values in zip(table.rows, table.numbers(range(len(COLUMNS))), strict=True):
            try:
                w, x, y, z = unit_quaternion("quaternion", values[3:], "qw, qx, qy, qz")
            except InvalidInputError as error:
                raise FileFormatError("file", f"{path}, row {row}: {','.join(cells)}", error.allowed) from error
            poses.append(pin.SE3(pin.Quaternion(w, x, y, z).matrix(), values[:3]).homogeneous)
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
        rotations = np.array([self.start[:3, :3] @ pin.exp3(each * turn) for each in s]).reshape(-1, 3, 3)
        if not turn.any():
            rotations = np.broadcast_to(self.start[:3, :3], rotations.shape)
        return positions, rotations


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
        return np.concatenate([[0.0], np.unique(inner[(inner > SAME_KNOT) & (inner < 1.0 - SAME_KNOT)]), [1.0]])

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
