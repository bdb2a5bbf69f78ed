"""Motion with continuous acceleration: the grid for it, and the cubic spline in time through its samples.

A cubic spline with continuous second derivative has a constant jerk on each piece, so its limits are checked exactly and it
needs no more than positions and velocities in a file.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from manipplan.checks import Array
from manipplan.paths.trajectory import Trajectory
from manipplan.timing.arc import ArcLength
from manipplan.timing.demands import Demands
from manipplan.timing.jerk import SquaredSpeed

#: Grid points nearer to a mark than this share of their distance are left out in its favour.
BESIDE = 0.4
#: The time a grid interval takes on average [s], least: below it whole nanoseconds would show in the jerk.
SHORTEST_STEP = 2e-5


@dataclass(frozen=True, kw_only=True, eq=False)
class SmoothProfile:
    """Samples of a motion whose acceleration is continuous: times [s], lengths, dl/dt (k,), and whether its ends are stops."""

    curve: ArcLength
    time: Array
    length: Array
    speed: Array

    @classmethod
    def of(cls, demands: Demands, motion: SquaredSpeed) -> "SmoothProfile":
        """From a solution in the units of the demands."""
        time = np.concatenate([[0.0], np.cumsum(motion.steps)]) * demands.time_unit
        speed = np.sqrt(np.maximum(motion.a, 0.0)) * demands.speed_unit
        return cls(curve=demands.curve, time=time, length=demands.length, speed=speed)

    def sampled(self, names: Sequence[str], factor: float = 1.0) -> tuple[Trajectory, Array]:
        """The trajectory `factor` times slower, sample times in whole nanoseconds, and s of its samples (k,)."""
        time = self.time * factor
        t = np.round(time, 9)
        distinct = np.concatenate([[True], np.diff(t) > 0])
        pace = self.speed / factor
        length = np.clip(self.length + pace * (t - time), 0.0, self.curve.length)
        length[0], length[-1] = 0.0, self.curve.length
        t, length, pace = t[distinct], length[distinct], pace[distinct]
        length[-1] = self.curve.length
        s = self.curve.s(length)
        q = np.array(self.curve.path(s))
        ends = self.curve.tangent(length[[0, -1]]) * pace[[0, -1], None]
        qd = smooth_velocities(t, q, ends, (pace[0] == 0, pace[-1] == 0))
        return Trajectory(t=t, q=q, qd=qd, joint_names=tuple(names)), s


def smooth_velocities(t: Array, q: Array, ends: Array, stops: tuple[bool, bool]) -> Array:
    """Velocities (k, n) of the cubic spline with continuous acceleration through q (k, n), which is changed.

    At an end that is a stop velocity and acceleration are zero; for this the sample beside it is moved, by far less than
    it is away from the end. At the other ends velocity is that of `ends` (2, n).

    Unknown are the accelerations M at the samples: h M_k-1 / 6 + (h + h') M_k / 3 + h' M_k+1 / 6 is the change of the mean
    velocity from one piece to the next.
    """
    from scipy.linalg import solve_banded

    h = np.diff(t)
    mean = np.diff(q, axis=0) / h[:, None]
    count = len(t)
    band = np.zeros((3, count))  # band[1 + i - j, j] is entry (i, j)
    right = np.zeros_like(q)
    band[1, 1:-1] = (h[:-1] + h[1:]) / 3
    band[2, :-2] = h[:-1] / 6
    band[0, 2:] = h[1:] / 6
    right[1:-1] = np.diff(mean, axis=0)
    band[1, [0, -1]] = 1.0
    for k, stop in enumerate(stops):
        end, beside, first, second = (0, 1, 0, 1) if k == 0 else (-1, -2, -1, -2)
        sign = 1.0 if k == 0 else -1.0
        if not stop:
            band[1, end] = h[first] / 3
            band[(0 if k == 0 else 2), beside] = h[first] / 6
            right[end] = sign * (mean[first] - ends[k])
            continue
        # the sample beside the stop is at q_end + h² M / 6, which keeps velocity and acceleration there at zero
        far = q[2 if k == 0 else -3]
        step = (far - q[end]) / h[second] * sign
        band[1, beside] += h[first] ** 2 / (6 * h[second]) + h[first] / 6
        right[beside] = sign * step
        row = 2 if k == 0 else count - 3
        band[(2 if k == 0 else 0), beside] -= h[first] ** 2 / (6 * h[second])
        right[row] += sign * (mean[second] - step)
    M = solve_banded((1, 1), band, right)
    for k, stop in enumerate(stops):
        if stop:
            end, beside, first = (0, 1, 0) if k == 0 else (-1, -2, -1)
            M[end] = 0.0
            q[beside] = q[end] + h[first] ** 2 * M[beside] / 6
    mean = np.diff(q, axis=0) / h[:, None]
    qd = np.vstack([mean - h[:, None] * (2 * M[:-1] + M[1:]) / 6, [mean[-1] + h[-1] * (M[-2] + 2 * M[-1]) / 6]])
    for k, stop in enumerate(stops):
        qd[-k] = 0.0 if stop else ends[k]
    return qd


def first_grid(curve: ArcLength, count: int, edges: Array, stops: tuple[bool, bool]) -> Array:
    """A grid before anything is known of the speed: even, denser in turns, and like l ~ t³ at stops."""
    points = curve.grid(8 * count, np.empty(0))
    share = points / curve.length
    even = np.linspace(0.0, 1.0, len(points))
    near = np.cbrt(share) if stops[0] else np.ones_like(share)
    far = np.cbrt(1 - share) if stops[1] else np.ones_like(share)
    ramp = near / (near + far) if all(stops) else (near if stops[0] else 1 - far if stops[1] else share)
    return _thinned(curve, points, (even + ramp) / 2, count, edges)


def next_grid(curve: ArcLength, profile: SmoothProfile, count: int, edges: Array) -> Array:
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
