"""Where an arm has to stop on a path, and the path without pieces on which no joint moves."""

import numpy as np

from manipplan.paths.joint import JointPath
from manipplan.support.checks import Array
from manipplan.support.tolerances import SAME

#: Below this share of the mean speed ‖q'‖ the path stands still; above this angle [rad] it turns a corner.
STANDSTILL = 1e-6
CORNER = 1e-4


class MovingPath:
    """A path without pieces that stand still, and the conversion between its parameter and that of the given path.

    A piece stands still where it stays within `SAME` of where the one kept before ends. The next one begins there.
    """

    def __init__(self, path: JointPath) -> None:
        self._given = self._kept = np.array([0.0, 1.0])
        self.path = path
        if (_extents(path.control, path.control[:, :1]) >= SAME).all():
            return
        pieces: list[Array] = []
        moving, at = np.zeros(len(path.control), dtype=bool), path.start
        for k, piece in enumerate(path.control):
            moving[k] = _extents(piece, at) >= SAME
            if moving[k]:
                pieces.append(_begun(piece, at))
                at = piece[-1]
        pieces[-1] = _begun(pieces[-1][::-1], path.goal)[::-1]
        widths = np.diff(path.breaks)
        gained = np.concatenate([[0.0], np.cumsum(np.where(moving, widths, 0.0))]) / widths[moving].sum()
        gained[-1] = 1.0
        self._given, self._kept = path.breaks, gained
        breaks = np.concatenate([[0.0], gained[1:][moving]])
        breaks[-1] = 1.0
        self.path = JointPath(breaks=breaks, control=np.array(pieces))

    def here(self, s: Array) -> Array:
        """The parameter on `path` for s on the given path."""
        return np.asarray(np.interp(s, self._given, self._kept))

    def given(self, s: float) -> float:
        """The parameter on the given path for s on `path`."""
        return float(np.interp(s, self._kept, self._given))


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
