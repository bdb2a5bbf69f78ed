"""Deviation: how far the tool leaves a workspace path, measured independently of how the motion was computed."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.tolerance import Tolerance
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError

#: Number of poses on the path, and weight of an angle in the search for the nearest of them [m/rad].
POSES = 2001
RADIAN = 0.1
#: Number of tool poses compared at a time.
BLOCK = 256


@dataclass(frozen=True, kw_only=True)
class Deviation:
    """The largest distances of a tool from a path.

    Attributes:
        position: [m]; `position_at` is where it occurs, as a fraction of the samples.
        rotation: [rad], of the tool or of its pointing axis; `rotation_at` is where it occurs.
    """

    position: float
    position_at: float
    rotation: float
    rotation_at: float

    def excess(self, tolerance: Tolerance, of: str) -> str:
        """Which part of a tolerance is exceeded, and after which share `of` what; "" if it is kept."""
        for name, value, limit, unit, at in (
            ("position", self.position, tolerance.position, "m", self.position_at),
            ("rotation", self.rotation, tolerance.rotation, "rad", self.rotation_at),
        ):
            if limit is not None and value > limit:
                where = f"the tool's {name} leaves the path by {value:.3g} {unit} after {at:.2f} of the {of}"
                return f"{where}; allowed: {limit:g} {unit}"
        return ""

    def __str__(self) -> str:
        return f"at most {1e3 * self.position:.3g} mm and {np.rad2deg(self.rotation):.2g}° from the path"


def deviation_from(path: CartesianPath, poses: Array, axis: Array | None = None) -> Deviation:
    """Deviation of tool poses (k, 4, 4) from a path, regardless of time; only the direction of `axis` (3,) counts if given."""
    return _largest(*deviations(path, poses, axis))


def deviations(path: CartesianPath, poses: Array, axis: Array | None = None) -> tuple[Array, Array]:
    """Distances [m] and angles [rad], (k,) each, of tool poses (k, 4, 4) from a path, as in `deviation_from`.

    Each pose is compared with the nearest of 2000 pieces of the path.
    """
    if not len(poses):
        raise InvalidInputError("poses", f"an array of shape {poses.shape}", "at least one pose (4, 4)")
    return distances_from(path.sample(POSES), poses, axis)


def distances_from(line: Array, poses: Array, axis: Array | None = None) -> tuple[Array, Array]:
    """Distances [m] and angles [rad], (k,) each, of poses (k, 4, 4) from the pieces between the poses of a line (m, 4, 4)."""
    position, rotation = np.empty(len(poses)), np.empty(len(poses))
    for begin in range(0, len(poses), BLOCK):
        some = poses[begin : begin + BLOCK]
        pieces = [np.clip(k + side, 0, len(line) - 2) for k in _nearest(some, line, axis) for side in (-1, 0)]
        found = np.array([_from_piece(some, line[k], line[k + 1], axis) for k in pieces])  # (4, 2, …)
        best = (found[:, 0] + RADIAN * found[:, 1]).argmin(axis=0)
        position[begin : begin + BLOCK], rotation[begin : begin + BLOCK] = found[best, :, np.arange(len(some))].T
    return position, rotation


def _nearest(poses: Array, line: Array, axis: Array | None) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """The nearest of the poses (m, 4, 4) on a path to each of poses (k, 4, 4), and the next one not beside it; (k,) each.

    Where a path closes or meets itself, rounding decides which of the two is nearer.
    """
    middle = line[:, :3, 3].mean(axis=0)  # the squares of small vectors lose fewer digits
    squares = _squares(poses[:, :3, 3] - middle, line[:, :3, 3] - middle)
    turns = [each[:, :3, :3].reshape(-1, 9) if axis is None else each[:, :3, :3] @ axis for each in (poses, line)]
    chords = _squares(*turns) / (8.0 if axis is None else 4.0 * float(axis @ axis))  # sin² of half the angle
    apart = np.sqrt(squares) + 2 * RADIAN * np.arcsin(np.sqrt(np.minimum(chords, 1.0)))
    first, rows = apart.argmin(axis=1), np.arange(len(apart))
    for side in (-1, 0, 1):
        apart[rows, np.clip(first + side, 0, len(line) - 1)] = np.inf
    return first, apart.argmin(axis=1)


def _squares(first: Array, second: Array) -> Array:
    """Squared distances (k, m) of vectors (k, d) and (m, d)."""
    squares = (first**2).sum(axis=1)[:, None] + (second**2).sum(axis=1) - 2 * first @ second.T
    return np.asarray(np.maximum(squares, 0.0))


def deviation_at(path: CartesianPath, s: Array, poses: Array, axis: Array | None = None) -> Deviation:
    """Deviation of tool poses (k, 4, 4) from those of a path at s (k,): small only if all of the path is followed, in order."""
    targets = path(s)
    position = np.linalg.norm(poses[:, :3, 3] - targets[:, :3, 3], axis=1)
    return _largest(position, angles_between(poses[:, :3, :3], targets[:, :3, :3], axis))


def _largest(position: Array, rotation: Array) -> Deviation:
    worst, turned = int(position.argmax()), int(rotation.argmax())
    last = max(len(position) - 1, 1)
    return Deviation(
        position=float(position[worst]),
        position_at=worst / last,
        rotation=float(rotation[turned]),
        rotation_at=turned / last,
    )


def _from_piece(poses: Array, begins: Array, ends: Array, axis: Array | None) -> tuple[Array, Array]:
    """Distances (k,) and angles (k,) of poses from straight pieces, each between two poses."""
    from scipy.spatial.transform import Rotation

    along = ends[:, :3, 3] - begins[:, :3, 3]
    turn = Rotation.from_matrix(np.swapaxes(begins[:, :3, :3], 1, 2) @ ends[:, :3, :3]).as_rotvec()
    offset = poses[:, :3, 3] - begins[:, :3, 3]
    leaning = Rotation.from_matrix(np.swapaxes(begins[:, :3, :3], 1, 2) @ poses[:, :3, :3]).as_rotvec()
    turns, leans = (turn, leaning) if axis is None else ((each[:, :3, :3] - begins[:, :3, :3]) @ axis for each in (ends, poses))
    length = (along**2).sum(axis=1) + RADIAN**2 * (turns**2).sum(axis=1)
    share = (offset * along).sum(axis=1) + RADIAN**2 * (leans * turns).sum(axis=1)
    share = np.clip(share / np.maximum(length, 1e-30), 0.0, 1.0)[:, None]
    rotations = begins[:, :3, :3] @ Rotation.from_rotvec(share * turn).as_matrix()
    return np.linalg.norm(offset - share * along, axis=1), angles_between(poses[:, :3, :3], rotations, axis)


def angles_between(first: Array, second: Array, axis: Array | None = None) -> Array:
    """Angles between rotations (..., 3, 3), or between the directions to which they turn `axis`."""
    if axis is not None:
        a, b = first @ axis, second @ axis
        return np.asarray(np.arctan2(np.linalg.norm(np.cross(a, b), axis=-1), (a * b).sum(axis=-1)))
    chord = np.linalg.norm(first - second, axis=(-2, -1)) / np.sqrt(8)  # |R - S| = √8 sin(angle / 2)
    return np.asarray(2 * np.arcsin(np.minimum(chord, 1.0)))
