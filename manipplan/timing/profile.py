"""Speed along a piece of path as a function of time, and the trajectory it makes."""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from manipplan.paths.trajectory import Trajectory
from manipplan.support.checks import Array
from manipplan.timing.arc import ArcLength


@dataclass(frozen=True, kw_only=True, eq=False)
class Profile(ABC):
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

    @abstractmethod
    def joints(self, t: Array, s: Array, length: Array, pace: Array) -> tuple[Array, Array]:
        """q and qd (k, n) of samples at times t, where the parameter is s and dl/dt is `pace`, (k,) each."""

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
        q, qd = self.joints(t, s, length, pace)
        return Trajectory(t=t, q=q, qd=qd, joint_names=tuple(names)), s


@dataclass(frozen=True, kw_only=True, eq=False)
class SteppedProfile(Profile):
    """A motion on whose grid intervals dl/dt changes at a constant rate: acceleration jumps."""

    @classmethod
    def of(cls, curve: ArcLength, points: Array, speed: Array) -> "SteppedProfile":
        """From dl/dt at grid points (k,): two samples an interval."""
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
