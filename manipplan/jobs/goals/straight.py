"""Straight lines from one configuration to others: what is known about motions before any is planned."""

from dataclasses import dataclass

import numpy as np

from manipplan.cost.crossings import least_crossings_to
from manipplan.cost.integral import PathIntegral, speeds
from manipplan.support.checks import Array

#: Number of places of a straight line at which m is evaluated.
PLACES = 17


@dataclass(frozen=True, kw_only=True, eq=False)
class StraightLines:
    """Straight lines from one configuration to k others.

    Attributes:
        m: (k, PLACES) the measure on each.
        g: (k,) of each, estimated.
        crossings: lower bound on the singularities that any path between its ends crosses; None for redundant arms.
        bound: (k,) upper bound on the minimum m of any path between its ends: the smaller m of both; 0 in another aspect.
    """

    m: Array
    g: Array
    crossings: list[int] | list[None]
    bound: Array


def straight_lines(start: Array, ends: Array, integral: PathIntegral) -> StraightLines:
    """The straight lines from start (n,) to ends (k, n)."""
    kinematics = integral.kinematics
    m = kinematics.manipulability(start + (ends[:, None] - start) * np.linspace(0.0, 1.0, PLACES)[:, None])
    with np.errstate(divide="ignore"):
        weights = 1.0 / np.hypot(m, integral.floor) ** integral.power
    g = speeds(ends - start, integral.metric) * (weights[:, 1:] + weights[:, :-1]).mean(axis=1) / 2
    crossings = least_crossings_to(kinematics, start, ends)
    bound = np.where([bool(each) for each in crossings], 0.0, np.minimum(m[:, 0], m[:, -1]))
    return StraightLines(m=m, g=g, crossings=crossings, bound=bound)
