"""Joint limits on the torus: an angle is inside when it is inside after some number of full turns."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from manipplan.support.checks import Array, number_array
from manipplan.support.errors import InvalidInputError

#: An angle that exceeds a limit by less than this is on the limit [rad].
ON_LIMIT = 1e-9


@dataclass(frozen=True, kw_only=True, eq=False)
class AngleLimits:
    """lower <= θ <= upper for each joint; a range of 2π or more is no limit.

    Attributes:
        lower: (n,) [rad], -inf where there is none.
        upper: (n,) [rad], inf where there is none.
    """

    lower: Array
    upper: Array

    @classmethod
    def of(cls, lower: ArrayLike | None, upper: ArrayLike | None, n: int) -> "AngleLimits":
        """Limits from one number for all joints, n of them, or None.

        Raises InvalidInputError for NaN, other shapes, or a lower limit above the upper one.
        """
        low, high = (_one_side(name, value, n) for name, value in (("lower", lower), ("upper", upper)))
        if (low > high).any() or np.isposinf(low).any() or np.isneginf(high).any():
            raise InvalidInputError(
                "lower, upper", [low.tolist(), high.tolist()], "lower limits that are not above the upper ones"
            )
        return cls(lower=low, upper=high)

    @property
    def bounded(self) -> Array:
        """(n,) whether each joint's range is less than a full turn."""
        return np.asarray(self.upper - self.lower < 2 * np.pi)

    def placed(self, q: ArrayLike) -> Array:
        """q (..., n), each angle shifted by full turns into its range, as near to zero as possible; NaN where none fits.

        An angle that exceeds a limit by less than `ON_LIMIT` is set to it.
        """
        angles = np.asarray(q, dtype=np.float64)
        turn = 2 * np.pi
        wrapped = angles - turn * np.round(angles / turn)
        least = np.ceil((self.lower - ON_LIMIT - wrapped) / turn)
        most = np.floor((self.upper + ON_LIMIT - wrapped) / turn)
        turns = np.clip(0.0, least, most)
        placed = np.clip(wrapped + turn * np.where(np.isfinite(turns), turns, 0.0), self.lower, self.upper)
        return np.where(least <= most, placed, np.nan)

    def contain(self, q: ArrayLike) -> Array:
        """(...,) whether all angles of q (..., n) are inside, up to full turns."""
        return np.asarray(np.isfinite(self.placed(q)).all(axis=-1))


def _one_side(name: str, value: ArrayLike | None, n: int) -> Array:
    if value is None:
        return np.full(n, -np.inf if name == "lower" else np.inf)
    array = number_array(name, value)
    if array.shape not in ((), (n,)) or np.isnan(array).any():
        raise InvalidInputError(name, value, f"one angle or {n} angles [rad], without NaN")
    return np.broadcast_to(array, (n,)).copy()
