"""The global optimum of a path problem: V, the smallest g from the start to every posture, by fast marching.

V satisfies the eikonal equation |∇V| = 1/μ^p with V = 0 at the start. scikit-fmm solves it with second-order differences on a
grid of (θ_1, θ_2, θ_3); every path of every class competes. The path optimiser is not used, and μ is the closed form of
`manipplan.planar`.

The grid is a box. V is that of all paths, and not only of those in the box: a path that leaves it through a wall of θ_2 or θ_3
costs at least the smallest V at the walls plus the smallest V at the walls of a second field that begins at the goal, and this
sum has to be above V at the goal. The walls of θ_1 need no such check: μ does not depend on θ_1, so along a shortest path
θ_1'/μ^(2p) is constant in the parameter of even g, and θ_1 never turns back. Posts do depend on θ_1: with them the optimum is
that of the box.
"""

import importlib
from collections.abc import Sequence
from dataclasses import dataclass
from types import ModuleType

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.ndimage import map_coordinates

import manipplan as mp
from manipplan.planar import PlanarArm, manipulability
from studies.kth2012.geodesics import Geodesic, geodesic

Array = NDArray[np.float64]
#: Room [rad] of the box around start and goal in θ_2 and θ_3, and in θ_1, which only the differences need.
ROOM, THIN = 1.6, 0.3
#: Room [rad] and grid step [rad] of the box in which paths through the walls are excluded.
WIDE, WIDE_STEP = 5.0, 0.1
#: Radius of the first front in grid steps.
FRONT = 3.0
#: The smallest μ [m²] on the grid; singular postures are infinitely far away.
LEAST = 1e-3


@dataclass(frozen=True, kw_only=True, eq=False)
class Field:
    """V on a grid: `values` at `low` + `step` * index [rad], for the power p of μ."""

    arm: PlanarArm
    power: float
    start: Array
    low: Array
    step: float
    values: Array

    def __call__(self, q: Array) -> Array:
        """V at configurations (k, 3), by splines through the grid around each, cubic ones where no post is near."""
        found = []
        for place in (np.atleast_2d(q) - self.low) / self.step:
            first = np.clip(np.floor(place).astype(int) - 4, 0, np.array(self.values.shape) - 9)
            patch = self.values[tuple(slice(each, each + 9) for each in first)]
            smooth = 3 if np.isfinite(patch).all() else 1  # next to a post
            found.append(map_coordinates(patch, (place - first)[:, None], order=smooth, mode="nearest")[0])
        return np.array(found)

    @property
    def wall(self) -> float:
        """The smallest V on the walls of θ_2 and θ_3."""
        v = self.values
        return float(min(v[:, 0].min(), v[:, -1].min(), v[:, :, 0].min(), v[:, :, -1].min()))

    def back(self, goal: Array) -> mp.JointPath:
        """The path down the slope of V from a goal to the start."""
        finite = np.where(np.isfinite(self.values), self.values, 2 * self.values[np.isfinite(self.values)].max())
        slope = np.gradient(finite, self.step)
        q, points = np.array(goal, dtype=float), [np.array(goal, dtype=float)]
        while np.linalg.norm(q - self.start) > 2 * FRONT * self.step:
            place = ((q - self.low) / self.step)[:, None]
            down = np.array([map_coordinates(each, place, order=1, mode="nearest")[0] for each in slope])
            q = q - 0.5 * self.step * down / np.linalg.norm(down)
            points.append(q)
            if len(points) > 100 / self.step:
                raise RuntimeError(f"the way back from {goal} does not reach {self.start}")
        return mp.JointPath.through(np.array([self.start, *points[::-1][:: round(0.2 / self.step)][:-1], goal]))


def marching() -> ModuleType:
    """scikit-fmm; raises ModuleNotFoundError with the line that installs it."""
    try:
        return importlib.import_module("skfmm")
    except ModuleNotFoundError as error:
        raise ModuleNotFoundError("the global optimum needs scikit-fmm: python -m pip install scikit-fmm") from error


def solve(
    arm: PlanarArm,
    start: ArrayLike,
    goals: ArrayLike,
    power: float,
    step: float,
    *,
    room: float = ROOM,
    posts: Sequence[tuple[float, float]] = (),
    reach: float = 0.0,
) -> Field:
    """V in a box around a start and its goals (k, 3), with grid steps of `step` [rad].

    Postures are left out in which a link's axis is less than `reach` [m] from one of the `posts`, (x, y) [m].
    """
    skfmm = marching()
    ends = np.vstack([np.asarray(start, dtype=float), np.asarray(goals, dtype=float)])
    # with posts θ_1 can turn back
    around = np.array([THIN if not posts else room, room, room])
    low, high = ends.min(axis=0) - around, ends.max(axis=0) + around
    counts = np.ceil((high - low) / step).astype(int) + 1
    axes = [first + step * np.arange(count) for first, count in zip(low, counts, strict=True)]
    plane = np.stack(np.broadcast_arrays(0.0, axes[1][:, None], axes[2]), axis=-1)
    mu = np.maximum(manipulability(arm, plane), LEAST)
    speed = np.ascontiguousarray(np.broadcast_to(mu**power, counts))

    def density(q: Array) -> Array:
        return np.asarray(np.maximum(manipulability(arm, q), LEAST) ** -power)

    # the first front is a level of the cost of straight lines, which is that of V up to the third order
    origin, slowest = ends[0], float(density(ends[:1])[0])
    first, second, third = (np.square(axis - each) for axis, each in zip(axes, origin, strict=True))
    away = np.sqrt(first[:, None, None] + second[:, None] + third)
    middle = density((plane + np.array([0.0, *origin[1:]])) / 2)
    line = away * (slowest + 4 * middle + mu**-power) / 6
    front = FRONT * step * slowest
    field: Array | np.ma.MaskedArray = line - front
    if posts:
        field = np.ma.MaskedArray(field, ~free(arm, axes, posts, reach))
    values = np.ma.filled(skfmm.travel_time(field, speed, dx=step, order=2), np.inf) + front
    inside = (line < front) & np.isfinite(values)
    values[inside] = line[inside]
    return Field(arm=arm, power=power, start=origin, low=low, step=step, values=values)


def free(arm: PlanarArm, axes: Sequence[Array], posts: Sequence[tuple[float, float]], reach: float) -> NDArray[np.bool_]:
    """Whether the axis of every link is at least `reach` [m] from all posts, on a grid."""
    angles = np.cumsum(np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1), axis=-1)
    kept = np.ones(angles.shape[:-1], dtype=bool)
    for post in posts:
        x, y = np.full(kept.shape, -post[0]), np.full(kept.shape, -post[1])
        for k, length in enumerate(arm.lengths):
            cos, sin = np.cos(angles[..., k]), np.sin(angles[..., k])
            along = np.clip(-(x * cos + y * sin), 0.0, length)
            kept &= np.hypot(x + along * cos, y + along * sin) >= reach
            x, y = x + length * cos, y + length * sin
    return kept


@dataclass(frozen=True, kw_only=True, eq=False)
class Global:
    """V at a goal by grid step, the smallest g of a path through the walls of the box, and the geodesic near the way back."""

    values: tuple[float, ...]
    outside: float
    path: Geodesic

    @property
    def proven(self) -> bool:
        """Whether no path through the walls of the wide box is better."""
        return self.outside > self.path.g


def global_optimum(arm: PlanarArm, start: Array, goal: Array, power: float, steps: Sequence[float]) -> Global:
    """The global optimum of one problem (3,) to (3,), with grids of decreasing steps [rad]."""
    fields = [solve(arm, start, [goal], power, step) for step in steps]
    there, back = (
        solve(arm, first, [last], power, WIDE_STEP, room=WIDE).wall for first, last in ((start, goal), (goal, start))
    )
    path = geodesic(arm, fields[-1].back(goal), power)
    return Global(values=tuple(float(each(goal)[0]) for each in fields), outside=there + back, path=path)
