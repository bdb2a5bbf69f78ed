"""Grids along a piece of path for motions with limited jerk: dense where it takes time, and where the path turns."""

import numpy as np

from manipplan.support.checks import Array
from manipplan.timing.arc import ArcLength
from manipplan.timing.profile import Profile

#: Grid points nearer to a mark than this share of their distance are left out in its favour.
BESIDE = 0.4


def first_grid(curve: ArcLength, count: int, edges: Array, stops: tuple[bool, bool]) -> Array:
    """A grid before anything is known of the speed: even, denser in turns, and like l ~ t³ at stops."""
    points = curve.grid(8 * count, np.empty(0))
    share = points / curve.length
    even = np.linspace(0.0, 1.0, len(points))
    near = np.cbrt(share) if stops[0] else np.ones_like(share)
    far = np.cbrt(1 - share) if stops[1] else np.ones_like(share)
    ramp = near / (near + far) if all(stops) else (near if stops[0] else 1 - far if stops[1] else share)
    return _thinned(curve, points, (even + ramp) / 2, count, edges)


def next_grid(curve: ArcLength, profile: Profile, count: int, edges: Array) -> Array:
    """A grid even in the time of a motion found before, and denser in turns."""
    fine = curve.grid(8 * count, np.empty(0))
    even = np.linspace(0.0, 1.0, len(fine))
    # l ~ t³ at stops: the cube root is interpolated there
    lengths, times = profile.length, profile.time / profile.time[-1]
    at = np.interp(fine, lengths, times)
    for k, (i, j) in enumerate(((0, 1), (-1, -2))):
        if profile.speed[i] == 0:
            inside = fine < lengths[j] if k == 0 else fine > lengths[j]
            gone = np.abs(fine[inside] - lengths[i]) / abs(lengths[j] - lengths[i])
            at[inside] = times[i] + (times[j] - times[i]) * np.cbrt(gone)
    dense = np.union1d(fine, np.interp(np.linspace(0, 1, 8 * count), times, lengths))
    # the first interval of the motion is passed with constant jerk
    begin, end = lengths[1] * np.linspace(0, 1, 9) ** 3, curve.length - (curve.length - lengths[-2]) * np.linspace(0, 1, 9) ** 3
    dense = np.union1d(dense, np.concatenate([begin, end]))
    return _thinned(curve, dense, 0.7 * np.interp(dense, fine, at) + 0.3 * np.interp(dense, fine, even), count, edges)


def _thinned(curve: ArcLength, points: Array, share: Array, count: int, edges: Array) -> Array:
    """About `count` + 1 lengths, evenly spaced in `share`, which rises along `points`; marks are among them."""
    rising = np.concatenate([[True], np.diff(share) > 0])
    points, share = points[rising], share[rising]
    share = (share - share[0]) / (share[-1] - share[0])
    wanted = np.linspace(0.0, 1.0, count + 1)
    grid = np.interp(wanted, share, points)
    marks = curve.lengths_of(np.union1d(curve.path.breaks, edges))
    marks = marks[(marks > grid[1]) & (marks < grid[-2])]
    if len(marks):
        at = np.interp(marks, points, share)
        apart = np.concatenate([[True], np.diff(at) > 1e-3 / count])
        marks, at = marks[apart], at[apart]
        beside = np.abs(wanted[:, None] - at).min(axis=1) < BESIDE / count
        beside[[0, 1, -2, -1]] = False
        grid = np.union1d(grid[~beside], marks)
    grid = grid[np.concatenate([[True], np.diff(grid) > 1e-12 * curve.length])]
    grid[0], grid[-1] = 0.0, curve.length
    return np.asarray(grid, dtype=float)
