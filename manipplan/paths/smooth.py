"""Rounding of the corners of a path through waypoints; the path stays collision-free."""

from collections.abc import Callable

import numpy as np

from manipplan.paths.joint import JointPath
from manipplan.support.checks import Array

#: Maximum reach of a rounded corner, as a share of the shorter of its two edges, and minimum reach [rad].
WIDEST = 0.45
LEAST = 1e-4


def rounded(waypoints: Array, is_free: Callable[[JointPath], bool]) -> JointPath:
    """A path of straight pieces and rounded corners, twice continuously differentiable in its arc length.

    Every corner starts as wide as its edges allow and is halved until `is_free` accepts it with its two edges. A corner
    that cannot even be rounded over `LEAST` stays sharp; the arm will stop there.

    Args:
        waypoints: (k, n), whose straight pieces `is_free` accepts.
        is_free: whether a path may be used.
    """
    if len(waypoints) == 2:
        return JointPath.through(waypoints)
    edges = np.linalg.norm(np.diff(waypoints, axis=0), axis=1)
    reach = WIDEST * np.minimum(edges[:-1], edges[1:])
    for i in range(len(reach)):
        while reach[i] > LEAST and not is_free(_path(waypoints[i : i + 3], reach[i : i + 1])):
            reach[i] /= 2
    reach[reach <= LEAST] = 0.0
    return _path(waypoints, reach)


def _path(waypoints: Array, reach: Array) -> JointPath:
    """Straight pieces and corners as quartic Bernstein pieces.

    A corner of reach b turns from direction u to v over the parameter length 2b: q' = u + (v - u)(3x² - 2x³), x in
    [0, 1], so q'' vanishes at both ends; since the mean of 3x² - 2x³ is 1/2 it ends at distance b after the corner.
    """
    directions = np.diff(waypoints, axis=0)
    edges = np.linalg.norm(directions, axis=1)
    directions = directions / edges[:, None]
    pieces, lengths = [], []
    position = waypoints[0]
    done = 0.0
    for i, edge in enumerate(edges):
        ahead = reach[i] if i < len(reach) else 0.0
        straight = edge - done - ahead
        if straight > 1e-12:
            end = waypoints[i + 1] - ahead * directions[i]
            pieces.append(position + np.linspace(0.0, 1.0, 5)[:, None] * (end - position))
            lengths.append(straight)
            position = end
        if ahead > 0:
            u, v = directions[i], directions[i + 1]
            # Bernstein coefficients of the integral of u + (v - u)(3x² - 2x³) from 0, times 2b
            steps = 2 * ahead * np.array([u, u, v, v]) / 4
            pieces.append(position + np.vstack([np.zeros_like(u), np.cumsum(steps, axis=0)]))
            lengths.append(2 * ahead)
            position = pieces[-1][-1]
        done = ahead
    breaks = np.concatenate([[0.0], np.cumsum(lengths)]) / np.sum(lengths)
    breaks[-1] = 1.0
    return JointPath(breaks=breaks, control=np.array(pieces))
