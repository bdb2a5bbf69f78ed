"""explain_gap: where no motion leads on along a workspace path, down to which resolution, and what ends the motions there."""

from collections import Counter
from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from manipplan.paths.deviation import angles_between
from manipplan.search.interruptions import find_gaps
from manipplan.search.layers import INSIDE_LIMITS
from manipplan.search.max_min import minimum_to_each
from manipplan.search.sweep import check_epsilon, steps_between
from manipplan.support.checks import Array, ArrayLike
from manipplan.tool_path.engine import ToolPathPlanner

#: Maximum number of configurations whose way on is tried, and of reasons that are listed.
TRIED, LISTED = 2000, 4


def explain_gap(planner: ToolPathPlanner, epsilon: ArrayLike) -> str:
    """Where no motion through the candidates leads on, at which resolution, and what ends the motions that come there.

    Args:
        planner: of motions along the whole path, with as many positions as there will be; no motion goes through all of them.
        epsilon: as in `max_min_search`.
    """
    layers, s = planner.layers, planner.layers.s
    assert layers.sampler is not None and layers.poses is not None and s is not None
    count = len(layers.q)
    ranges = find_gaps(layers, epsilon).ranges
    if not ranges or ranges[0][1] >= count:
        where = "motions along the closed path lead once around it, but none returns to the configuration in which it began"
        return f"{where}; {_resolution(planner, np.arange(count))}"
    first, beyond = ranges[0]
    there = layers.poses[beyond, :3, 3]
    x, y, z = (f"{each:.4g}" for each in there)
    where = f"no motion leads on from s = {s[beyond - 1]:.5g} to s = {s[beyond]:.5g} (x = {x}, y = {y}, z = {z} m)"
    reached = minimum_to_each(layers.part(0, beyond - 1), epsilon) > -np.inf
    q = layers.q[beyond - 1][reached]
    reasons = _reasons(planner, q[:: -(-len(q) // TRIED)], beyond, check_epsilon(epsilon, layers.continuous))
    ends = f"the {len(q):,} configurations in which motions come there end at {reasons}"
    return f"{where}; {ends}; {_resolution(planner, np.arange(first, beyond))}"


def _resolution(planner: ToolPathPlanner, intervals: NDArray[np.int64]) -> str:
    """How close the samples are in intervals between positions."""
    layers = planner.layers
    assert layers.poses is not None and layers.sampling is not None
    begins, ends = layers.poses[intervals], layers.poses[(intervals + 1) % len(layers.poses)]
    moved = np.linalg.norm(ends[:, :3, 3] - begins[:, :3, 3], axis=1).max()
    turned = angles_between(begins[:, :3, :3], ends[:, :3, :3]).max()
    text = [f"positions at most {1e3 * moved:.3g} mm and {np.rad2deg(turned):.3g}° apart"]
    solver, values = layers.sampling.sampler.solver, layers.sampling.values
    bounded = 0 if solver.free.bounds is None else len(solver.free.bounds)
    kinds = dict(zip(solver.robot.joint_names, solver.robot.joint_types, strict=True))
    for name, column in zip(solver.names[: len(values.T) - bounded], values.T, strict=False):
        different = np.unique(column)
        if len(different) > 1:
            unit = "m" if kinds.get(name) == "prismatic" or name.startswith("shift") else "rad"
            text.append(f"values of {name} {np.median(np.diff(different)):.3g} {unit} apart, or closer")
    if bounded:
        text.append(f"{len(np.unique(values[:, -bounded:], axis=0))} poses of the region")
    return f"this was searched with {' and '.join(text)}"


def _reasons(planner: ToolPathPlanner, q: Array, beyond: int, epsilon: Array) -> str:
    """What ends the motions at configurations q (k, n), with the share of each, largest first."""
    layers = planner.layers
    assert layers.sampler is not None and layers.poses is not None
    sampler, limits = layers.sampler, layers.sampler.spec.robot.limits
    names = sampler.spec.robot.joint_names
    poses = np.repeat(layers.poses[beyond : beyond + 1], len(q), axis=0)
    moved, reached = sampler.solver.moved_onto(q, poses)
    found: list[str] = []
    far = (np.abs(steps_between(q, moved, layers.continuous)) >= epsilon).any(axis=1)
    far |= ~reached
    low, high = limits.lower + INSIDE_LIMITS - moved, moved - limits.upper + INSIDE_LIMITS
    free = sampler.free(np.clip(moved, limits.lower, limits.upper))
    pairs = _pairs(planner, moved)
    # a motion that leads on inside the limits, but to no sample, goes along a limit
    nearly = np.where(free & (np.maximum(low, high).max(axis=1) <= 0), -epsilon.min() / 2, 0.0)
    for k in range(len(q)):
        joint = int(np.maximum(low[k], high[k]).argmax())
        if far[k]:
            found.append("the end of a branch of solutions")
        elif max(low[k, joint], high[k, joint]) > nearly[k]:
            found.append(f"the {'lower' if low[k, joint] > high[k, joint] else 'upper'} limit of {names[joint]}")
        elif not free[k]:
            found.append(f"a collision of {pairs[k]}")
        else:
            found.append("a place with no sample near enough")
    return _shares(found)


def _pairs(planner: ToolPathPlanner, q: Array) -> list[str]:
    """The nearest two bodies at each of configurations (k, n); "" where no two are checked."""
    sampler = planner.layers.sampler
    assert sampler is not None
    if sampler.collision is None or not sampler.collision.pair_names:
        return [""] * len(q)
    distances = sampler.collision.distance_rows(q, beyond=sampler.spec.clearance)
    return [" and ".join(sampler.collision.pair_names[int(k)]) for k in distances.argmin(axis=1)]


def _shares(found: Iterable[str]) -> str:
    """Texts with the share of each, largest first."""
    counts = Counter(found).most_common()
    total = sum(count for _, count in counts)
    listed = [f"{text} ({count / total:.0%})" for text, count in counts[:LISTED]]
    return ", ".join(listed) + (", and others" if len(counts) > LISTED else "")
