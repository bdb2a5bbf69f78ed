"""Speed along a piece of path as a function of time, in steps or as a cubic spline, and the resulting trajectory.

A cubic spline with continuous second derivative has constant jerk on each piece, so its limits are checked exactly and a
file needs only positions and velocities.
"""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from manipplan.paths.trajectory import Trajectory
from manipplan.support.checks import Array
from manipplan.timing.arc import ArcLength
from manipplan.timing.dynamics import PathDynamics
from manipplan.timing.jerk import SquaredSpeed


@dataclass(frozen=True, kw_only=True, eq=False)
class Profile(ABC):
    """Samples of a motion along a piece of path.

    Attributes:
        curve: the piece as a function of its arc length.
        time: (k,) sample times, from 0 [s].
        length: (k,) arc length travelled [rad or m].
        speed: (k,) dl/dt.
    """

    curve: ArcLength
    time: Array
    length: Array
    speed: Array

    @abstractmethod
    def joints(self, t: Array, s: Array, length: Array, pace: Array) -> tuple[Array, Array]:
        """q and qd (k, n) at times t, where the path parameter is s and dl/dt is `pace`, (k,) each."""

    def sampled(self, names: Sequence[str], factor: float = 1.0) -> tuple[Trajectory, Array]:
        """The cubic trajectory, `factor` times slower and sampled at whole nanoseconds, and s at its samples (k,)."""
        time = self.time * factor
        t = np.round(time, 9)
        distinct = np.concatenate([[True], np.diff(t) > 0])
        distinct[-1] = True
        if len(t) > 2 and not t[-1] > t[distinct][-2]:
            distinct[np.flatnonzero(distinct)[-2]] = False
        pace = self.speed / factor
        # position of the motion at the rounded times
        length = np.clip(self.length + pace * (t - time), 0.0, self.curve.length)
        length[0], length[-1] = 0.0, self.curve.length
        t, length, pace = t[distinct], length[distinct], pace[distinct]
        if len(t) == 1 or t[-1] <= 0:
            t = np.array([0.0, 1e-9])
            length, pace = np.array([0.0, self.curve.length]), self.speed[[0, -1]] / factor
        s = self.curve.s(length)
        q, qd = self.joints(t, s, length, pace)
        return Trajectory(t=t, q=q, qd=qd, joint_names=tuple(names)), s


@dataclass(frozen=True, kw_only=True, eq=False)
class SteppedProfile(Profile):
    """A motion whose dl/dt changes at a constant rate on each grid interval: acceleration jumps between them."""

    @classmethod
    def of(cls, curve: ArcLength, points: Array, speed: Array) -> "SteppedProfile":
        """From dl/dt at grid points (k,), with two samples per interval."""
        duration = 2 * np.diff(points) / (speed[:-1] + speed[1:])
        rate = np.diff(speed) / duration
        half = duration / 2
        between = points[:-1] + speed[:-1] * half + rate * half**2 / 2
        length = np.insert(points, np.arange(1, len(points)), between)
        pace = np.insert(speed, np.arange(1, len(speed)), speed[:-1] + rate * half)
        times = np.concatenate([[0.0], np.cumsum(np.repeat(half, 2))])
        return cls(curve=curve, time=times, length=np.clip(length, 0.0, curve.length), speed=pace)

    def joints(self, _t: Array, s: Array, length: Array, pace: Array) -> tuple[Array, Array]:
        return self.curve.path(s), self.curve.tangent(length) * pace[:, None]


@dataclass(frozen=True, kw_only=True, eq=False)
class SmoothProfile(Profile):
    """A motion whose acceleration is continuous, and zero where it begins or ends at rest."""

    @classmethod
    def of(cls, demands: PathDynamics, motion: SquaredSpeed) -> "SmoothProfile":
        """From a solution in the units of the demands."""
        time = np.concatenate([[0.0], np.cumsum(motion.steps)]) * demands.time_unit
        speed = np.sqrt(np.maximum(motion.a, 0.0)) * demands.speed_unit
        return cls(curve=demands.curve, time=time, length=demands.length, speed=speed)

    def joints(self, t: Array, s: Array, length: Array, pace: Array) -> tuple[Array, Array]:
        q = np.array(self.curve.path(s))
        ends = self.curve.tangent(length[[0, -1]]) * pace[[0, -1], None]
        qd = smooth_velocities(t, q, ends, (pace[0] == 0, pace[-1] == 0))
        return q, qd


def smooth_velocities(t: Array, q: Array, ends: Array, stops: tuple[bool, bool]) -> Array:
    """Velocities (k, n) of the cubic spline with continuous acceleration through q (k, n), which is modified in place.

    At an end that is a stop, velocity and acceleration are zero; for this the sample next to it is moved, by much less than
    its distance from the end. At other ends the velocity is that in `ends` (2, n).

    The unknowns are the accelerations M at the samples: h M_k-1 / 6 + (h + h') M_k / 3 + h' M_k+1 / 6 is the change of the
    mean velocity from one piece to the next.
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
        # the sample next to the stop is at q_end + h² M / 6, which makes velocity and acceleration at the stop zero
        far = q[2 if k == 0 else -3]
        step = (far - q[end]) / h[second] * sign
        band[1, beside] += h[first] ** 2 / (6 * h[second]) + h[first] / 6
        right[beside] = sign * step
        row = 2 if k == 0 else count - 3
        band[(2 if k == 0 else 0), beside] -= h[first] ** 2 / (6 * h[second])
        right[row] += sign * (mean[second] - step)
    M = solve_banded((1, 1), band, right, overwrite_ab=True, overwrite_b=True, check_finite=False)
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
