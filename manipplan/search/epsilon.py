"""The step ε between neighbouring positions: its check, and the least one that connects."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from manipplan.checks import Array, number_array
from manipplan.errors import InvalidInputError


def checked_epsilon(value: ArrayLike, continuous: NDArray[np.bool_]) -> Array:
    """`value`, one number or n of them, as read-only (n,): finite, above zero, below π for joints that turn without end."""
    n = len(continuous)
    array = number_array("epsilon", value)
    if array.shape not in ((), (n,)):
        raise InvalidInputError("epsilon", value, f"one number or {n} of them, one per joint")
    if not (np.isfinite(array) & (array > 0)).all():
        raise InvalidInputError("epsilon", value, "finite numbers above zero [rad or m]")
    array = np.broadcast_to(array, (n,)).copy()
    if (array[continuous] >= np.pi).any():
        raise InvalidInputError("epsilon", value, "below π for joints that turn without end")
    array.flags.writeable = False
    return array


def exclusive(epsilon: Array, *, strict: bool) -> Array:
    """What each step has to be below (n,): with strict=False the next larger number, so that ε itself is allowed."""
    return epsilon if strict else np.nextafter(epsilon, np.inf)
