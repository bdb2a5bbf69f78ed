"""Rounds of the exact search: who takes part in which pass."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from manipplan.checks import Array

#: Candidates of the first round, at least: fewer take hardly less time.
FIRST = 20_000
GROWTH = 4
#: From this share on, all take part.
MOST = 0.5
#: Rounds go down from high indices until so large a share takes part; then they take samples.
TOP = 1 / 64
#: Indices from which quantiles are taken.
SAMPLE = 100_000


@dataclass(frozen=True, kw_only=True, eq=False)
class Quantiles:
    """Quantiles of the index over all layers, estimated on a sample in descending order.

    Attributes:
        sample: indices, descending.
        count: number of candidates in all.
        bound: least over the layers of the largest index.
    """

    sample: Array
    count: int
    bound: float

    @classmethod
    def of(cls, m: Sequence[Array], bound: float) -> "Quantiles":
        """Of layers m[i] (k_i,)."""
        count = sum(map(len, m))
        stride = max(1, count // SAMPLE)
        sample = np.sort(np.concatenate([each[::stride] for each in m]))[::-1]
        return cls(sample=sample, count=count, bound=bound)

    def first(self) -> float:
        """The first threshold: at most the bound, above which a layer is empty."""
        share = max(FIRST / self.count, self.share(self.bound))
        return -np.inf if share >= MOST else min(self.bound, self._quantile(share))

    def next(self, before: float) -> float:
        """The threshold after `before`: about GROWTH times as many candidates reach it; -inf for the last."""
        share = GROWTH * self.share(before)
        lower = self.sample[self.sample < before]
        return -np.inf if share >= MOST or len(lower) == 0 else min(float(lower[0]), self._quantile(share))

    def share(self, threshold: float) -> float:
        """The share of candidates with an index of at least the threshold."""
        return float(np.searchsorted(-self.sample, -threshold, side="right") / len(self.sample))

    def sampled(self, nodes: float, threshold: float) -> float:
        """The share of the candidates with an index of at least the threshold that makes about so many `nodes`; 1 for all."""
        share = nodes / max(self.share(threshold) * self.count, 1)
        return 1.0 if share >= MOST else share

    def _quantile(self, share: float) -> float:
        return float(self.sample[int(share * len(self.sample))])
