"""Speed along a piece of path as a function of time, and the trajectory it makes."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from manipplan.checks import Array
from manipplan.paths.trajectory import Trajectory
from manipplan.timing.arc import ArcLength


@dataclass(frozen=True, kw_only=True, eq=False)
class Profile:
    """Samples of a motion along a piece of path.

    Attributes:
        curve: the piece by arc length.
        time: (k,) from 0 [s].
        length: (k,) way gone [rad or m].
        speed: (k,) dl/dt.
    """

    curve: ArcLength
    time: Array
    length: Array
    speed: Array

    def sampled(self, names: Sequence[str], factor: float = 1.0) -> tuple[Trajectory, Array]:
        """The cubic trajectory `factor` times slower, sample times in whole nanoseconds, and s of its samples (k,)."""
        time = self.time * factor
        t = np.round(time, 9)
        distinct = np.concatenate([[True], np.diff(t) > 0])
        distinct[-1] = True
        if len(t) > 2 and not t[-1] > t[distinct][-2]:
            distinct[np.flatnonzero(distinct)[-2]] = False
        pace = self.speed / factor
        # where the motion is at the rounded times
        length = np.clip(self.length + pace * (t - time), 0.0, self.curve.length)
        length[0], length[-1] = 0.0, self.curve.length
        t, length, pace = t[distinct], length[distinct], pace[distinct]
        if len(t) == 1 or t[-1] <= 0:
            t = np.array([0.0, 1e-9])
            length, pace = np.array([0.0, self.curve.length]), self.speed[[0, -1]] / factor
        s = self.curve.s(length)
        qd = self.curve.tangent(length) * pace[:, None]
        return Trajectory(t=t, q=self.curve.path(s), qd=qd, joint_names=tuple(names)), s


def constant_steps(curve: ArcLength, points: Array, speed: Array) -> Profile:
    """Two samples a grid interval, on which dl/dt changes at a constant rate."""
    duration = 2 * np.diff(points) / (speed[:-1] + speed[1:])
    rate = np.diff(speed) / duration
    half = duration / 2
    between = points[:-1] + speed[:-1] * half + rate * half**2 / 2
    length = np.insert(points, np.arange(1, len(points)), between)
    pace = np.insert(speed, np.arange(1, len(speed)), speed[:-1] + rate * half)
    times = np.concatenate([[0.0], np.cumsum(np.repeat(half, 2))])
    return Profile(curve=curve, time=times, length=np.clip(length, 0.0, curve.length), speed=pace)
