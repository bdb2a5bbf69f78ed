"""Grid: cells over up to three joints, wide enough that neighbours within ε lie in the same or in adjacent cells."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from manipplan.search.steps import TAU
from manipplan.support.checks import Array

#: Maximum number of joints that are hashed.
AXES = 3
#: Minimum number of cells of a hashed joint: three of them are searched anyway.
FEWEST = 4
#: Relative margin of the cell width over the largest step, so that rounding never puts neighbours two cells apart.
HAIR = 1e-6
#: Number of configurations from which the joints to hash are chosen.
SAMPLE = 4096


@dataclass(frozen=True, kw_only=True, eq=False)
class Grid:
    """Cells of equal width over three joints; a joint with a single cell is not hashed.

    Attributes:
        joints: (3,) joints that are hashed.
        low: (3,) lower edge of the first cell [rad or m].
        per: (3,) cells per rad or m.
        count: (3,) number of cells.
        wraps: (3,) whether the last cell is adjacent to the first.
        order: (n,) order in which joints are compared: joints that are not hashed come first, as they reject more pairs.
        reach: (n,) upper bound on a step, exclusive, in that order.
        turns: (n,) whether the joint is continuous, in that order.
    """

    joints: NDArray[np.int64]
    low: Array
    per: Array
    count: NDArray[np.int64]
    wraps: NDArray[np.bool_]
    order: NDArray[np.int64]
    reach: Array
    turns: NDArray[np.bool_]

    @property
    def cells(self) -> int:
        """Number of cells."""
        return int(self.count.prod())


def choose_grid(sample: Array, extent: Array, reach: Array, continuous: NDArray[np.bool_], most: int) -> Grid:
    """The grid of at most `most` cells that separates the most pairs of `sample` (S, n).

    extent (2, n): smallest and largest joint values of all configurations; reach (n,): bound on a step, exclusive. Joints are
    added one by one; a joint triples the cells to search, so it has to leave less than a third of the pairs in a common cell.
    """
    n = sample.shape[1]
    low, high = extent
    rounding = 8 * np.finfo(np.float64).eps * np.maximum(np.abs(low), np.abs(high))
    with np.errstate(over="ignore"):
        width = reach * (1 + HAIR) + rounding
        span = np.where(continuous, TAU, high - low)
        full = np.where(continuous, np.floor(TAU / width), np.floor(span / width) + 1)
    joints: list[int] = []
    counts: list[int] = []
    key = np.zeros(len(sample), dtype=np.int64)
    together = _pairs(key)
    room = most
    while len(joints) < AXES and together > 0:
        best = (together / 3, -1, 0, key)
        for j in range(n):
            cells = int(min(full[j], room))
            if j in joints or cells < FEWEST or not np.isfinite(span[j]):
                continue
            share = (sample[:, j] - low[j]) / span[j] if not continuous[j] else sample[:, j] / TAU
            trial = key * cells + np.minimum((share % 1.0 if continuous[j] else share) * cells, cells - 1).astype(np.int64)
            left = _pairs(trial)
            if left < best[0]:
                best = (left, j, cells, trial)
        if best[1] < 0:
            break
        together, key = best[0], best[3]
        joints.append(best[1])
        counts.append(best[2])
        room //= best[2]
    hashed = np.array(joints + [0] * (AXES - len(joints)), dtype=np.int64)
    count = np.array(counts + [1] * (AXES - len(counts)), dtype=np.int64)
    wraps = continuous[hashed] & (count > 1)
    with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
        even = count / span[hashed]
    # an unhashed axis has one cell; cells that divide the span evenly are never narrower than `width`
    per = np.where(count == 1, 0.0, np.where(wraps, count / TAU, np.minimum(1 / width[hashed], even)))
    order = np.argsort([(j in joints) * 1e18 - min(full[j], 1e17) for j in range(n)], kind="stable")
    return Grid(
        joints=hashed,
        low=low[hashed].copy(),
        per=per,
        count=count,
        wraps=wraps,
        order=order.astype(np.int64),
        reach=np.ascontiguousarray(reach[order]),
        turns=np.ascontiguousarray(continuous[order]),
    )


def _pairs(key: NDArray[np.int64]) -> float:
    sizes = np.unique(key, return_counts=True)[1].astype(np.float64)
    return float((sizes * (sizes - 1)).sum())
