"""The path objective g = ∫ ‖θ'‖ / μ^p ds of kth2012, measured on a fine rule, and the least index of a path."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from manipplan.checks import Array
from manipplan.kinematics.kinematics import Kinematics
from manipplan.optimize.metric import metric_matrix
from manipplan.paths.joint import JointPath

#: An index below this share of the path's largest counts as zero.
SINGULAR = 1e-9


@dataclass(frozen=True, kw_only=True)
class PathCost:
    """g and the least index of one path.

    Attributes:
        g: ∫ ‖q'‖_W / m^p ds, (6.6) in kth2012; inf when the path meets a singularity.
        length: ∫ ‖q'‖ ds [rad], (6.5), without W.
        min_manipulability: least index m, found by ever finer grids around its dips.
        at: the parameter s where it is least.
    """

    g: float
    length: float
    min_manipulability: float
    at: float


@dataclass(frozen=True, kw_only=True, eq=False)
class PathObjective:
    """What is minimised: g = ∫ ‖q'‖_W / m^p ds.

    Attributes:
        kinematics: whose measure m is.
        power: p > 0.
        metric: W (n, n), symmetric and positive definite; None: the identity.
    """

    kinematics: Kinematics
    power: float
    metric: Array | None = None

    def cost(self, path: JointPath, *, panels: int = 40) -> PathCost:
        """g and the least index of a path, as `path_cost`."""
        return path_cost(path, self.kinematics, self.power, metric=self.metric, panels=panels)

    def constant_speed(self, path: JointPath, count: int) -> Array:
        """Parameters s (count,) at which equal shares of g have been gained."""
        s = np.linspace(0.0, 1.0, 1001)
        with np.errstate(divide="ignore"):
            density = speeds(path(s, 1), self.metric) / self.kinematics.manipulability(path(s)) ** self.power
        density = np.minimum(density, 1e3 * np.median(density))
        gained = np.concatenate([[0.0], np.cumsum((density[1:] + density[:-1]) / 2)])
        return np.interp(np.linspace(0.0, gained[-1], count), gained, s)


def speeds(v: Array, metric: Array | None) -> Array:
    """‖v‖_W = sqrt(vᵀ W v) of rows v (m, n), (m,); Euclidean for None."""
    if metric is None:
        return np.asarray(np.linalg.norm(v, axis=1))
    return np.asarray(np.sqrt(np.einsum("mi,ij,mj->m", v, metric, v)))


def path_cost(
    path: JointPath, kinematics: Kinematics, power: float, *, metric: ArrayLike | None = None, panels: int = 40
) -> PathCost:
    """Measure g on a rule of at least ten Gauss points a panel, ten times finer than the solver's, and the least index.

    Args:
        path: the path.
        kinematics: whose measure counts.
        power: exponent of the measure.
        metric: W in ‖q'‖_W, weights (n,) or a matrix (n, n); None: the identity.
        panels: of ten Gauss points each.

    Raises:
        InvalidInputError: `metric` is no metric.
    """
    matrix = metric_matrix("metric", metric, path.n)
    s, weights = path.quadrature(panels=panels)
    v = path(s, 1)
    index = kinematics.manipulability(path(s))
    least, at, largest = _least_index(path, kinematics)
    # a singularity, which Gauss points can pass by, makes the integral diverge for p >= 1
    singular = power >= 1 and least <= SINGULAR * largest
    with np.errstate(divide="ignore"):
        g = np.inf if singular else float(weights @ (speeds(v, matrix) / index**power))
    return PathCost(g=g, length=float(weights @ speeds(v, None)), min_manipulability=least, at=at)


def _least_index(path: JointPath, kinematics: Kinematics) -> tuple[float, float, float]:
    """The least index on the path, where it is, and the largest: local minima of 2001 points are looked at ever closer.

    Where a path crosses a singularity the index has a sharp kink, which no fixed grid would hit.
    """
    s = np.linspace(0.0, 1.0, 2001)
    values = kinematics.manipulability(path(s))
    padded = np.concatenate([[np.inf], values, [np.inf]])
    dips = np.flatnonzero((values <= padded[:-2]) & (values <= padded[2:]))
    least, at = np.inf, 0.0
    deepest = dips[np.argsort(values[dips])[:5]]
    low, high = s[np.maximum(deepest - 1, 0)], s[np.minimum(deepest + 1, 2000)]
    for _ in range(8):
        grid = np.linspace(low, high, 41)  # a column a dip
        inside = kinematics.manipulability(path(grid))
        lowest, dip = inside.argmin(axis=0), np.arange(len(deepest))
        column = int(inside[lowest, dip].argmin())
        if inside[lowest[column], column] < least:
            least, at = float(inside[lowest[column], column]), float(grid[lowest[column], column])
        low, high = grid[np.maximum(lowest - 1, 0), dip], grid[np.minimum(lowest + 1, 40), dip]
    return least, at, float(values.max())
