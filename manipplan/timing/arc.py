"""A path between two stops as a function of its arc length l: q(l), unit tangents, curvature, and a grid along it."""

from itertools import pairwise

import numpy as np

from manipplan.paths.joint import JointPath
from manipplan.paths.rounding import gauss_rule
from manipplan.support.checks import Array
from manipplan.support.deadline import building

#: Share by which ‖q'‖ jumps where it does not count as continuous, and minimum number of nodes between two such jumps.
JUMP, EACH = 1e-6, 60
#: Minimum number of nodes per polynomial piece: a sharp bend may be a short piece of a long path.
PER_PIECE = 24
#: Number of samples that tell where the path turns: a thousand per piece up to the first number, at least the second per piece.
MOST_SAMPLES, EACH_SAMPLES = 200_000, 20
#: Grid points closer to a break than this share of the mean grid spacing are dropped.
BESIDE = 0.1


class ArcLength:
    """The path from s = a to s = b as q(l), where l is its arc length: a geometric path in toppra's terms."""

    def __init__(self, path: JointPath, a: float, b: float) -> None:
        with building():
            from scipy.interpolate import CubicSpline, PPoly

        self.path = path
        #: where polynomial pieces begin or end, between the ends
        self.breaks = path.breaks[np.searchsorted(path.breaks, a, side="right") : np.searchsorted(path.breaks, b)]
        pieces = 1 + len(self.breaks)
        nodes_along = max(1200, 12 * pieces)
        self._samples = max(4000, min(1000 * pieces, MOST_SAMPLES), EACH_SAMPLES * pieces)
        nodes, weights = gauss_rule(6)
        ends = np.concatenate([[a], _jumps(path, self.breaks), [b]])
        at, splines = [0.0], []
        for begin, end in pairwise(ends):
            inside = np.searchsorted(self.breaks, end) - np.searchsorted(self.breaks, begin, side="right")
            count = max(EACH, PER_PIECE * (1 + int(inside)), int(np.ceil(nodes_along * (end - begin) / (b - a))))
            # dense near the ends, where a path may start from q' = 0
            s = begin + (end - begin) * (1 - np.cos(np.linspace(0.0, np.pi, count + 1))) / 2
            half = np.diff(s) / 2
            between = (s[:-1] + s[1:])[:, None] / 2 + half[:, None] * nodes
            length = at[-1] + np.concatenate([[0.0], np.cumsum(half * (_norms(path(between, 1)) @ weights))])
            rises = np.concatenate([[True], np.diff(length) > 1e-14 * length[-1]])
            rises[-1] = True
            splines.append(CubicSpline(length[rises], s[rises]))
            at += length[rises][1:].tolist()
        self.length = at[-1]
        self._at = np.array(at)
        self._s = PPoly(np.concatenate([each.c for each in splines], axis=1), self._at)
        self.ends = (a, b)
        # derivatives are evaluated slightly inside, since q' may vanish at the ends
        margin = 1e-6 * (b - a)
        self._inside = (a + margin, b - margin)
        self._shares: dict[int, tuple[Array, Array]] = {}

    def s(self, length: Array) -> Array:
        """Path parameter at lengths."""
        return np.asarray(np.clip(self._s(length), *self.ends))

    def q(self, length: Array) -> Array:
        """Configurations (k, n) at lengths (k,)."""
        return self.path(self.s(length))

    def tangent(self, length: Array) -> Array:
        """dq/dl, a unit vector."""
        derivative = self.path(np.clip(self.s(length), *self._inside), 1)
        return np.asarray(derivative / np.maximum(_norms(derivative), 1e-300)[..., None])

    def bends(self, s: Array) -> tuple[Array, Array]:
        """Unit tangents t and curvatures d²q/dl² = (q'' - t (t·q'')) / ‖q'‖² at path parameters (k,), (k, n) each."""
        s = np.clip(s, *self._inside)
        first, second = self.path(s, 1), self.path(s, 2)
        norm = np.maximum(_norms(first), 1e-300)[..., None]
        tangent = first / norm
        along = np.einsum("...i,...i->...", tangent, second)[..., None]
        return tangent, (second - along * tangent) / norm**2

    def lengths_of(self, s: Array) -> Array:
        """Lengths at which the path parameter is s, for each s strictly between the ends."""
        s = s[(s > self.ends[0]) & (s < self.ends[1])]
        if not len(s):
            return s
        even = np.linspace(0, self.length, 4001)
        length = np.interp(s, self.s(even), even)
        for _ in range(3):
            length += (s - self.s(length)) * _norms(self.path(s, 1))
            length = np.clip(length, 0.0, self.length)
        return np.asarray(length)

    def grid(self, count: int, edges: Array) -> Array:
        """About `count` + 1 lengths from 0 to the end, evenly spaced, but twice as dense where the path turns at its mean rate.

        They include the ends of the polynomial pieces, where the curvature may jump, and `edges` (path parameters), where
        limits change.
        """
        return self._marked(self._even(count, max(4000, 10 * count)), edges)

    def fine(self, count: int) -> Array:
        """The same without edges, for `count` far above what is needed to tell where the path turns."""
        return self._marked(self._even(count, self._samples), np.empty(0))

    def _marked(self, points: Array, edges: Array) -> Array:
        """The points, and breaks and edges instead of those close to them."""
        marks = self.lengths_of(np.union1d(self.breaks, edges))
        if len(marks):  # a motion would pass points very close to a mark in less time than samples resolve
            beside = np.abs(points[:, None] - marks).min(axis=1) < BESIDE * self.length / (len(points) - 1)
            beside[[0, -1]] = False
            points = np.union1d(points[~beside], marks)
        points = points[np.concatenate([[True], np.diff(points) > 1e-7 * self.length])]
        points[-1] = self.length
        return np.asarray(points)

    def _even(self, count: int, samples: int) -> Array:
        if samples not in self._shares:
            self._shares[samples] = self._measured(samples)
        share, length = self._shares[samples]
        points = np.asarray(np.interp(np.linspace(share[0], share[-1], count + 1), share, length), dtype=float)
        points[0], points[-1] = 0.0, self.length
        return points

    def _measured(self, samples: int) -> tuple[Array, Array]:
        """The sum of the shares of length and turn up to each of the samples, in which a grid is even, and lengths there."""
        s = np.linspace(*self._inside, samples)
        tangent = self.path(s, 1)
        tangent /= np.maximum(_norms(tangent), 1e-300)[:, None]
        turned = np.concatenate([[0.0], np.cumsum(_norms(np.diff(tangent, axis=0)))])
        length = np.interp(s, self._s(self._at), self._at)
        return length / self.length + turned / max(turned[-1], 0.1), length


def _jumps(path: JointPath, breaks: Array) -> Array:
    """The inner breaks at which ‖q'‖ jumps, as where two paths were joined: the parameter has a kink there over the length."""
    at = np.searchsorted(path.breaks, breaks)
    before, after = path.control[at - 1], path.control[at]
    last = _norms(before[:, -1] - before[:, -2]) / (breaks - path.breaks[at - 1])
    first = _norms(after[:, 1] - after[:, 0]) / (path.breaks[at + 1] - breaks)
    return np.asarray(breaks[np.abs(last - first) > JUMP * np.maximum(last, first)])


def _norms(vectors: Array) -> Array:
    """Euclidean norms of vectors (..., n), (...)."""
    return np.asarray(np.sqrt(np.einsum("...i,...i->...", vectors, vectors)))
