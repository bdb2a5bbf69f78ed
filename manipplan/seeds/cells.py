"""A proof that two points of a box cannot be joined: the box is divided into cells, and cells without a free point are blocked.

A distance that changes by at most D within a cell is too small in all of it if it is so at the centre by D or more; the cell is
then blocked. Where D does not decide, the cell is halved along every axis [brooks1985; zhang2008]. A continuous curve of free
points visits a chain of cells that are not blocked, each of which touches the next one, at least at a corner. So if those cells
do not join two points, no curve does. Where they do, nothing is proven.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from manipplan.support.checks import Array

#: Margin on every distance [m].
SLACK = 1e-5
#: Initial and maximum number of halvings of a box, by its number of dimensions.
FIRST, LAST = {1: 6, 2: 3, 3: 2, 4: 2}, {1: 13, 2: 9, 3: 7, 4: 5}
#: In place of the index of a pair: no pair blocks the cell; it is out of reach.
OPEN, OUTSIDE = -1, -2

Indices = NDArray[np.int64]


@dataclass(frozen=True, kw_only=True, eq=False)
class Space(ABC):
    """A box of points, and distances that are to be kept in it.

    Attributes:
        low, high: (k,) corners of the box, 1 <= k <= 4.
        goes_on: (k,) whether points beyond both ends of an axis exist: the cells at one end then count as joined out there.
        ends: two free points (k,).
        pairs: (p,) indices of the distances.
        least: what every distance must be at free points [m].
        most: maximum number of distances that are measured; then nothing is proven.
    """

    low: Array
    high: Array
    goes_on: NDArray[np.bool_]
    ends: tuple[Array, Array]
    pairs: Indices
    least: float
    most: int

    @abstractmethod
    def measure(self, centres: Array, half: Array, rows: Indices, pairs: Indices) -> tuple[Array, Array]:
        """Distances of `pairs` (e,) at centres[rows], (m, k) and (e,), nan where they are not known, and bounds D (e,) [m].

        No distance changes by more than D within `half` (k,) of the centre along each axis. Distances above `least` + D + SLACK
        may be cut off there.
        """

    def is_outside(self, centres: Array, _half: Array) -> NDArray[np.bool_]:
        """Which cells around centres (m, k) no curve can visit; (m,)."""
        return np.zeros(len(centres), dtype=bool)

    def cell_of(self, point: Array, count: int) -> tuple[int, ...]:
        """The cell of a point (k,), of `count` along every axis."""
        share = (point - self.low) / (self.high - self.low)
        return tuple(np.clip(np.floor(count * share).astype(int), 0, count - 1).tolist())


@dataclass(frozen=True, kw_only=True)
class Barrier:
    """What separates two points.

    Attributes:
        pairs: the distances that are too small in the cells around the smaller of both parts.
        end: the point in that part: 0 or 1.
    """

    pairs: tuple[int, ...]
    end: int


def find_barrier(space: Space) -> Barrier | None:
    """What separates both ends of a space; None where nothing is proven."""
    return _Division(space).run() if len(space.pairs) and (space.high > space.low).all() else None


class _Division:
    """The cells of one level after another.

    `blocker` and `is_free` are arrays with one axis per dimension: the pair that blocks each cell, and whether all its points
    are free.
    """

    def __init__(self, space: Space) -> None:
        self.space = space
        self.k = len(space.low)
        self.level = FIRST[self.k]
        shape = (2**self.level,) * self.k
        self.blocker, self.is_free = np.full(shape, OPEN, dtype=np.int64), np.zeros(shape, dtype=bool)
        self.cells: Indices = np.indices(shape).reshape(self.k, -1).T.astype(np.int64)
        count = len(space.pairs)
        self.rows, self.pairs = np.repeat(np.arange(len(self.cells)), count), np.tile(space.pairs, len(self.cells))
        self.left = space.most

    def run(self) -> Barrier | None:
        while len(self.rows) and len(self.rows) <= self.left:
            self.left -= len(self.rows)
            self._measure()
            places = [self.space.cell_of(end, 2**self.level) for end in self.space.ends]
            if any(self.blocker[place] != OPEN for place in places):
                return None  # an end nearly touches
            part = _part(self.blocker == OPEN, self.space.goes_on, places[0])
            if not part[places[1]]:
                return self._barrier(part, places)
            if self._is_joined(places) or self.level == LAST[self.k]:
                return None
            self._halve(part)
        return None

    def _measure(self) -> None:
        """Close the cells of this level that a distance decides, and keep the open ones with the distances that do not."""
        space = self.space
        half = (space.high - space.low) / 2 ** (self.level + 1)
        centres = space.low + (2 * self.cells + 1) * half
        distances, change = space.measure(centres, half, self.rows, self.pairs)
        blocks = distances + change <= space.least - SLACK  # nan is not
        self.blocker[tuple(self.cells[self.rows[blocks]].T)] = self.pairs[blocks]
        outside = space.is_outside(centres, half)
        self.blocker[tuple(self.cells[outside].T)] = OUTSIDE
        near = ~(distances - change >= space.least + SLACK)
        is_near = np.zeros(len(self.cells), dtype=bool)
        is_near[self.rows[near]] = True
        at = tuple(self.cells.T)
        self.is_free[at] = ~is_near & (self.blocker[at] == OPEN)
        kept = near & (self.blocker[at] == OPEN)[self.rows]
        self.rows, self.pairs = self.rows[kept], self.pairs[kept]

    def _is_joined(self, places: list[tuple[int, ...]]) -> bool:
        """Whether free cells join both ends, so that no level can separate them."""
        if not all(self.is_free[place] for place in places):
            return False
        from scipy.ndimage import label

        labels = label(self.is_free)[0]
        return bool(labels[places[0]] == labels[places[1]])

    def _halve(self, part: NDArray[np.bool_]) -> None:
        """Go on to the next level, with the cells of one part that are neither blocked nor free."""
        kept = part[tuple(self.cells[self.rows].T)]
        self.rows, self.pairs = self.rows[kept], self.pairs[kept]
        known, position = np.unique(self.rows, return_inverse=True)
        corners = np.indices((2,) * self.k).reshape(self.k, -1).T
        self.cells = (2 * self.cells[known][None] + corners[:, None]).reshape(-1, self.k)
        self.rows = (position[None] + len(known) * np.arange(len(corners))[:, None]).ravel()
        self.pairs = np.tile(self.pairs, len(corners))
        for axis in range(self.k):
            self.blocker, self.is_free = self.blocker.repeat(2, axis=axis), self.is_free.repeat(2, axis=axis)
        self.level += 1

    def _barrier(self, part: NDArray[np.bool_], places: list[tuple[int, ...]]) -> Barrier:
        from scipy.ndimage import binary_dilation

        other = _part(self.blocker == OPEN, self.space.goes_on, places[1])
        end = int(other.sum() <= part.sum())
        around = self.blocker[binary_dilation(other if end else part, np.ones((3,) * self.k))]
        found = around[around >= 0] if (around >= 0).any() else self.blocker[self.blocker >= 0]
        return Barrier(pairs=tuple(np.unique(found).tolist()), end=end)


def _part(is_open: NDArray[np.bool_], goes_on: NDArray[np.bool_], place: tuple[int, ...]) -> NDArray[np.bool_]:
    """The open cells that are joined to the one at `place`, where cells that share a corner are joined.

    A curve that leaves the box at one end of an axis comes back at that end, if at all.
    """
    from scipy.ndimage import label

    labels, count = label(is_open, structure=np.ones((3,) * is_open.ndim))
    joined = np.zeros(count + 1, dtype=bool)
    joined[labels[place]] = True
    faces = [np.unique(labels.take(end, axis=axis)) for axis in np.flatnonzero(goes_on) for end in (0, -1)]
    before = 0
    while before != joined.sum():
        before = joined.sum()
        for face in faces:
            joined[face] |= joined[face].any()
            joined[0] = False
    return np.asarray(joined[labels])
