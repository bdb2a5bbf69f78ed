"""Steps between neighbouring positions: their bound ε, their size, and configurations without jumps of 2π."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from manipplan.support.checks import LARGEST, Array, number_array
from manipplan.support.errors import InvalidInputError

TAU = 2 * np.pi
#: Smallest step that is allowed [rad or m].
LEAST_EPSILON = 1e-300


def steps_between(a: Array, b: Array, continuous: NDArray[np.bool_]) -> Array:
    """Steps from configurations a to b (..., n); continuous joints take the shorter way."""
    d = b - a
    return np.where(continuous, d - TAU * np.floor(d / TAU + 0.5), d)


def path_steps(q: Array, continuous: NDArray[np.bool_], *, closed: bool) -> Array:
    """Steps along the path q (L, n), including the closing step of a cycle: (L - 1, n) or (L, n)."""
    following = np.roll(q, -1, axis=0) if closed else q[1:]
    return steps_between(q if closed else q[:-1], following, continuous)


def path_length(q: Array, continuous: NDArray[np.bool_], *, closed: bool) -> float:
    """Σ ‖Δq‖ along the path q (L, n)."""
    return float(np.linalg.norm(path_steps(q, continuous, closed=closed), axis=1).sum())


def without_jumps(q: Array, continuous: NDArray[np.bool_]) -> Array:
    """The path q (L, n) with continuous joints unwrapped, starting at their first value."""
    steps = steps_between(q[:-1], q[1:], continuous)
    turned = np.vstack([q[:1], q[0] + np.cumsum(steps, axis=0)])
    return np.where(continuous, turned, q)


def within(q: Array, epsilon: Array, continuous: NDArray[np.bool_], *, strict: bool, closed: bool) -> bool:
    """Whether every step of the path q (L, n) is below ε (n,), or, without `strict`, at most ε."""
    steps = np.abs(path_steps(q, continuous, closed=closed))
    return bool((steps < epsilon if strict else steps <= epsilon).all())


def full_turns(q: Array, continuous: NDArray[np.bool_]) -> Array:
    """Net rotation of each joint (n,) over the cycle q (L, n) [rad]: full turns of continuous joints, else 0."""
    return np.where(continuous, 2 * np.pi * np.round((q[-1] - q[0]) / (2 * np.pi)), 0.0)


def check_epsilon(value: ArrayLike, continuous: NDArray[np.bool_]) -> Array:
    """`value`, one number or n of them, as read-only (n,): finite, above zero, below π for continuous joints."""
    n = len(continuous)
    array = number_array("epsilon", value)
    if array.shape not in ((), (n,)):
        raise InvalidInputError("epsilon", value, f"one number or {n} of them, one per joint")
    if not ((array >= LEAST_EPSILON) & (array <= LARGEST)).all():
        raise InvalidInputError("epsilon", value, f"finite numbers above zero, {LEAST_EPSILON:g} to {LARGEST:g} [rad or m]")
    array = np.broadcast_to(array, (n,)).copy()
    if (array[continuous] >= np.pi).any():
        raise InvalidInputError("epsilon", value, "below π for continuous joints")
    array.flags.writeable = False
    return array


def exclusive(epsilon: Array, *, strict: bool) -> Array:
    """Exclusive bound on each step (n,): with strict=False the next larger number, so that ε itself is allowed."""
    return epsilon if strict else np.nextafter(epsilon, np.inf)
