"""Where an arm has to stop on a path, and the path without pieces on which no joint moves."""

import numpy as np

from manipplan.paths.joint import JointPath
from manipplan.support.checks import Array

#: Below this share of the mean speed ‖q'‖ the path stands still; above this angle [rad] it turns a corner.
STANDSTILL = 1e-6
CORNER = 1e-4


class MovingPath:
    """A path without pieces that stand still, and the conversion between its parameter and that of the given path."""

    def __init__(self, path: JointPath) -> None:
        self._given = self._kept = np.array([0.0, 1.0])
        self.path = path
        moving = np.abs(path.control - path.control[:, :1]).max(axis=(1, 2)) > 1e-12
        if moving.all():
            return
        widths = np.diff(path.breaks)
        gained = np.concatenate([[0.0], np.cumsum(np.where(moving, widths, 0.0))]) / widths[moving].sum()
        gained[-1] = 1.0
        self._given, self._kept = path.breaks, gained
        breaks = np.concatenate([[0.0], gained[1:][moving]])
        breaks[-1] = 1.0
        self.path = JointPath(breaks=breaks, control=path.control[moving])

    def here(self, s: Array) -> Array:
        """The parameter on `path` for s on the given path."""
        return np.asarray(np.interp(s, self._given, self._kept))

    def given(self, s: float) -> float:
        """The parameter on the given path for s on `path`."""
        return float(np.interp(s, self._kept, self._given))


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
