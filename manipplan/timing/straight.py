"""The fastest motion from rest to rest along a straight line in joint space, in closed form.

On a line q = q_0 + t l with a unit tangent t every limit of a joint is one of l: the motion is that of a single axis. It
accelerates with the largest jerk, acceleration and speed, and brakes in the same way. Jerk is constant in each of at most seven
phases, so that few samples of a cubic trajectory are the whole motion.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from manipplan.paths.joint import JointPath
from manipplan.paths.trajectory import Trajectory
from manipplan.support.checks import Array
from manipplan.timing.segment import Bounds

#: Control points farther than this share of the length from the line through their ends do not count as straight.
STRAIGHT = 1e-12
#: Shortest phase: time [s] and share of the motion, but at most one part in the last number. Rounding shows in shorter ones.
SHORTEST, SHARE, MOST_PHASES = 1e-4, 1e-5, 200
#: Largest time between samples [s], unless that makes more samples than the number.
SPACING, MOST_SAMPLES = 0.02, 300


@dataclass(frozen=True, kw_only=True, eq=False)
class StraightMotion:
    """A motion from rest to rest along a line: it speeds up, goes on at a steady speed, and slows down as it sped up.

    Attributes:
        start, goal: (n,) [rad or m].
        rise: time in which acceleration rises or falls; 0 without limited jerk [s].
        hold: time of constant acceleration [s].
        steady: time of constant speed [s].
    """

    start: Array
    goal: Array
    rise: float
    hold: float
    steady: float

    @classmethod
    def between(cls, start: Array, goal: Array, bounds: Bounds) -> "StraightMotion":
        """The fastest motion between two configurations (n,) within bounds of one row each, in whole nanoseconds.

        Acceleration jumps where no jerk is limited.
        """
        length = float(np.linalg.norm(goal - start))
        unit = np.abs(goal - start) / length
        with np.errstate(divide="ignore"):
            v, a, j = (float(np.min(kind[0] / unit)) for kind in (bounds.velocity, bounds.acceleration, bounds.jerk))
        rise, hold = _phases(length, v, a, j)
        peak = min(a, j * rise) if rise else a
        steady = length / (peak * (rise + hold)) - (2 * rise + hold)
        # longer phases need less speed, acceleration and jerk, and so does one that takes over the time of a very short one
        duration = 4 * rise + 2 * hold + steady
        shortest = min(max(SHORTEST, SHARE * duration), duration / MOST_PHASES)
        if steady < shortest:
            hold, rise, steady = (hold + steady, rise, 0.0) if hold > 0 or not rise else (0.0, rise + steady / 2, 0.0)
        if rise and hold < shortest:
            rise, hold = rise + hold, 0.0
        rise = max(rise, shortest) if rise else 0.0
        return cls(start=start, goal=goal, rise=_rounded_up(rise), hold=_rounded_up(hold), steady=_rounded_up(steady))

    @property
    def duration(self) -> float:
        """Duration [s]."""
        return 4 * self.rise + 2 * self.hold + self.steady

    def sampled(self, names: Sequence[str], factor: float) -> Trajectory:
        """The cubic trajectory, `factor` times slower, with samples where phases begin or end, and some between.

        Those between serve controllers that interpolate samples otherwise.
        """
        rise, hold, steady = (_rounded_up(each * factor) for each in (self.rise, self.hold, self.steady))
        parts = np.array([rise, hold, rise, steady, rise, hold, rise])
        # the way is jerk · rise (rise + hold) (2 rise + hold + steady); shares of it are used as unit of length
        speed = 1 / (2 * rise + hold + steady)
        peak = speed / (rise + hold)
        rate = peak / rise if rise else 0.0
        jerk = np.array([rate, 0.0, -rate, 0.0, -rate, 0.0, rate])
        begins = np.array([0.0, peak, peak, 0.0, 0.0, -peak, -peak])
        speeds = np.append(0.0, np.cumsum(parts * (begins + parts * jerk / 2))[:-1])
        shares = np.append(0.0, np.cumsum(parts * (speeds + parts * (begins / 2 + parts * jerk / 6)))[:-1])
        ends = np.round(np.append(0.0, np.cumsum(parts)), 9)
        counts = np.ceil(parts / max(SPACING, ends[-1] / MOST_SAMPLES)).astype(int)
        phase = np.repeat(np.arange(len(parts)), counts)
        step = np.arange(len(phase)) - np.repeat(np.cumsum(counts) - counts, counts)
        t = np.round(ends[phase] + parts[phase] * step / counts[phase], 9)
        u = t - ends[phase]
        share = shares[phase] + u * (speeds[phase] + u * (begins[phase] / 2 + u * jerk[phase] / 6))
        pace = speeds[phase] + u * (begins[phase] + u * jerk[phase] / 2)
        way = self.goal - self.start
        q = np.vstack([self.start + share[:, None] * way, self.goal])
        qd = np.append(pace, 0.0)[:, None] * way
        return Trajectory(t=np.append(t, ends[-1]), q=q, qd=qd, joint_names=tuple(names))


def _phases(length: float, v: float, a: float, j: float) -> tuple[float, float]:
    """Times in which acceleration rises, 0 without limited jerk, and is constant, from rest to the largest speed [s]."""
    if np.isinf(j):
        return 0.0, float(min(v / a, np.sqrt(length / a)))
    rise = min(a / j, np.sqrt(v / j))
    ramp = rise + v / min(a, j * rise)
    if ramp * v > length:  # the largest speed is not reached
        rise = a / j
        ramp = (rise + np.sqrt(rise**2 + 4 * length / a)) / 2
        if ramp < 2 * rise:  # nor is the largest acceleration
            rise = np.cbrt(length / (2 * j))
            ramp = 2 * rise
    return float(rise), float(ramp - 2 * rise)


def _rounded_up(seconds: float) -> float:
    """The next multiple of a nanosecond, of a time that rounding made at most 1e-12 s too long, or negative."""
    return max(float(np.ceil(seconds * 1e9 - 1e-3)), 0.0) / 1e9


def straight_ends(path: JointPath, first: int, last: int) -> tuple[Array, Array] | None:
    """Start and goal (n,) of the pieces `first` to `last` - 1 of a path if they lie on a line and never go back; else None."""
    points = path.control[first:last].reshape(-1, path.n)
    start, goal = points[0], points[-1]
    length = float(np.linalg.norm(goal - start))
    if length == 0.0:
        return None
    tangent = (goal - start) / length
    along = (points - start) @ tangent
    off = np.abs(points - start - np.outer(along, tangent)).max()
    return (start, goal) if off <= STRAIGHT * length and (np.diff(along) >= -STRAIGHT * length).all() else None
