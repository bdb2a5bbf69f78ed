"""Distances of only those pairs that are near: among a thousand obstacles these are few."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from manipplan.support.checks import Array

#: Distance below which two bodies touch, for messages [m].
CONTACT = 1e-6


@dataclass(frozen=True, kw_only=True, eq=False)
class NearPairs:
    """Distances below a limit at m configurations, ordered by row, then pair; (e,) each.

    Attributes:
        shape: number of configurations and of all pairs.
        rows: indices of the configurations.
        pairs: indices of the pairs.
        distances: signed distances [m].
    """

    shape: tuple[int, int]
    rows: NDArray[np.intp]
    pairs: NDArray[np.intp]
    distances: Array

    @classmethod
    def of(cls, shape: tuple[int, int], where: NDArray[np.intp], distances: Array) -> "NearPairs":
        """From row * number of pairs + pair (e,), sorted, and distances (e,) [m]."""
        rows, pairs = np.divmod(where, max(shape[1], 1))
        return cls(shape=shape, rows=rows, pairs=pairs, distances=distances)

    def at(self, rows: NDArray[np.intp], pairs: NDArray[np.intp], default: float | Array) -> Array:
        """Distances (k,) of pairs (k,) at rows (k,) [m]; `default` for those that are not near."""
        where, wanted = self.rows * self.shape[1] + self.pairs, rows * self.shape[1] + pairs
        place = np.minimum(np.searchsorted(where, wanted), max(len(where) - 1, 0))
        known = where[place] == wanted if len(where) else np.zeros(len(wanted), dtype=bool)
        found = np.array(np.broadcast_to(default, wanted.shape), dtype=float)
        found[known] = self.distances[place[known]]
        return found

    def beside(self, default: float) -> tuple[Array, Array]:
        """Distances (e,) of the same pairs at the configurations before and after [m]; inf where there is none."""
        before, after = (self.at(self.rows + step, self.pairs, default) for step in (-1, 1))
        before[self.rows == 0] = after[self.rows == self.shape[0] - 1] = np.inf
        return before, after


def apart_text(distance: float) -> str:
    """What messages say of the distance of two bodies [m], such as "are 3.2 mm apart"."""
    if abs(distance) < CONTACT:
        return "touch"
    return f"are {1e3 * distance:.3g} mm apart" if distance > 0 else f"overlap by {-1e3 * distance:.3g} mm"
