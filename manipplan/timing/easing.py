"""What answers limits that a motion exceeds by what discretisation left over: stricter ones there, and a slower motion."""

from collections.abc import Mapping

import numpy as np

from manipplan.support.checks import Array
from manipplan.timing.demands import Demands

Use = Mapping[str, Array]


class Easing:
    """How much stricter limits are made at grid points (k,), and jerk's between them, over rounds of solving.

    Factors are 1 or more. Those of a speed that is given at an end stay 1.
    """

    def __init__(self, count: int, given: tuple[bool, bool]) -> None:
        self.rounds = 0
        self.jerk = np.ones(count - 1)
        self._velocity, self._rows = np.ones(count), np.ones(count)
        self._given = given

    def of(self, demands: Demands) -> Demands:
        """The demands of limits this strict."""
        return demands.eased(self._velocity, self._rows) if self.rounds else demands

    def tighten(self, use: Use) -> None:
        """Make limits stricter where a motion used more than all of them; `use` of each of its pieces."""
        margin = 1 + 1e-7 * 4.0 ** min(self.rounds, 7)  # neighbours answer to each other
        for factors, kinds in ((self._velocity, ("velocity", "tool speed")), (self._rows, ("acceleration", "torque"))):
            for kind in kinds:
                if kind in use:
                    excess = self._excess(use[kind], margin)
                    factors[:-1] *= excess
                    factors[1:] *= excess
        self.jerk *= self._excess(use["jerk"], margin)
        for end, given in zip((0, -1), self._given, strict=True):
            if given:
                self._velocity[end] = 1.0
        self.rounds += 1

    def _excess(self, use: Array, margin: float) -> Array:
        """By what to divide the limits of each grid interval, on which there are one or two pieces."""
        intervals = len(self.jerk)
        pieces, over = divmod(len(use), intervals)
        # samples at the same nanosecond were left out: then nobody knows which
        most = use.reshape(-1, pieces).max(axis=1) if pieces and not over else np.full(intervals, use.max())
        return np.where(most > 1, most * margin, 1.0)


def slowdown(use: Use) -> float:
    """How many times slower a motion has to be; 1 when every limit holds."""
    factor = max(float(use["velocity"].max()), float(np.sqrt(use["acceleration"].max())), float(np.cbrt(use["jerk"].max())))
    if "tool speed" in use:
        factor = max(factor, float(use["tool speed"].max()))
    if "torque" in use and (excess := float(use["torque"].max()) - 1) > 0:
        # gravity does not shrink with time, so torque gets a small step each round
        factor = max(factor, 1 + 2 * excess)
    return max(factor, 1.0)
