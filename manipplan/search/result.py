"""SearchResult: the best path through layers, with the bound that certifies it."""

from dataclasses import dataclass
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from manipplan.checks import Array


class SearchStatus(Enum):
    """How a search ended. The value is the text for people; `ok` tells whether the optimum was found."""

    OPTIMAL = "optimal: no continuous path through these candidates has a higher least index"
    IMPROVING = "improving: the search goes on; certified_gap tells how far the optimum can still be above the minimum"
    NOT_CONNECTED = (
        "failed: no continuous path leads through the layers; raise epsilon to more than smallest_epsilon, "
        "or take more candidates or more positions"
    )

    @property
    def ok(self) -> bool:
        """Whether the path is the optimum."""
        return self is SearchStatus.OPTIMAL


@dataclass(frozen=True, kw_only=True, eq=False)
class SearchResult:
    """The path that a search chose; where there is none, its arrays are empty and its minimum is -inf.

    Attributes:
        q: configurations (L, n) [rad or m]; joints that turn without end go on beyond ±π, so that their steps are small.
        indices: the chosen candidate of each layer (L,).
        manipulability: index at each position (L,).
        minimum: the least of them.
        bound: least over the layers of the largest index: no path, whatever its steps, has a higher minimum.
        certified_bound: no continuous path through these candidates has a higher minimum; equal to it once it is optimal.
        connected: whether there is a path.
        status: how the search ended.
        length: Σ ‖Δq‖ along the path, of a cycle the step back to its begin included; inf where there is no path.
        epsilon, strict, closed: what was asked for; epsilon (n,) [rad or m].
        rounds: passes over the layers.
        nodes: candidates that took part in the last of them.
        breaks_at: the first position, counted from 0, that no continuous path from the first one reaches; 0 when all are
            reached but no cycle closes; None when there is a path.
        smallest_epsilon: (n,) the least multiple of epsilon that connects the layers: with strict=False it does, with
            strict=True it does not, but anything above does. None when there is a path.
        message: what the status says, with the figures of this search.
    """

    q: Array
    indices: NDArray[np.int64]
    manipulability: Array
    minimum: float
    bound: float
    certified_bound: float
    connected: bool
    status: SearchStatus
    length: float
    epsilon: Array
    strict: bool
    closed: bool
    rounds: int
    nodes: int
    breaks_at: int | None = None
    smallest_epsilon: Array | None = None
    message: str = ""

    @property
    def gap(self) -> float:
        """How far an optimum of more candidates could be above the minimum: bound - minimum."""
        return self.bound - self.minimum

    @property
    def certified_gap(self) -> float:
        """How far the optimum of these candidates can be above the minimum: 0 once it is found."""
        return self.certified_bound - self.minimum
