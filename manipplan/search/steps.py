"""Steps along a chosen path: their size, and configurations without jumps of 2π."""

import numpy as np
from numpy.typing import NDArray

from manipplan.checks import Array

TAU = 2 * np.pi


def steps_between(a: Array, b: Array, continuous: NDArray[np.bool_]) -> Array:
    """Steps from configurations a to b (..., n), those of joints that turn without end by the shorter way."""
    d = b - a
    return np.where(continuous, d - TAU * np.floor(d / TAU + 0.5), d)


def path_steps(q: Array, continuous: NDArray[np.bool_], *, closed: bool) -> Array:
    """Steps along the path q (L, n), of a cycle the one back to its begin included: (L - 1, n) or (L, n)."""
    following = np.roll(q, -1, axis=0) if closed else q[1:]
    return steps_between(q if closed else q[:-1], following, continuous)


def path_length(q: Array, continuous: NDArray[np.bool_], *, closed: bool) -> float:
    """Σ ‖Δq‖ along the path q (L, n)."""
    return float(np.linalg.norm(path_steps(q, continuous, closed=closed), axis=1).sum())


def without_jumps(q: Array, continuous: NDArray[np.bool_]) -> Array:
    """The path q (L, n) with joints that turn without end going on from their first value."""
    steps = steps_between(q[:-1], q[1:], continuous)
    turned = np.vstack([q[:1], q[0] + np.cumsum(steps, axis=0)])
    return np.where(continuous, turned, q)


def within(q: Array, epsilon: Array, continuous: NDArray[np.bool_], *, strict: bool, closed: bool) -> bool:
    """Whether every step of the path q (L, n) is below ε (n,), or, without `strict`, at most ε."""
    steps = np.abs(path_steps(q, continuous, closed=closed))
    return bool((steps < epsilon if strict else steps <= epsilon).all())


def full_turns(q: Array, continuous: NDArray[np.bool_]) -> Array:
    """By how much each joint (n,) ends the cycle q (L, n) further on than it began: full turns of those without end."""
    return np.where(continuous, 2 * np.pi * np.round((q[-1] - q[0]) / (2 * np.pi)), 0.0)
