"""JointLimits: the limits of each joint, and the source of each number."""

from collections.abc import Mapping
from dataclasses import dataclass, field, fields

import numpy as np

from manipplan.support.checks import Array, ArrayLike, configurations, number_array, one_of, positive_array, text
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError

#: Time to full speed [s], which sets the acceleration limit where neither the user nor the catalogue gives one.
DEFAULT_RAMP_TIME = 0.2


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class JointLimits:
    """Limits of n joints, each (n,), in SI units (rad or m, s, N m or N); inf where there is none.

    `robots.subchain.limits_of` reads them from a description.

    `sources` gives the source of the numbers of each kind: the robot's file, a data sheet, the user, or the default.
    Raises InvalidInputError when a limit is NaN, not above zero, or a lower bound is not below its upper bound.
    """

    lower: Array
    upper: Array
    velocity: Array
    acceleration: Array
    jerk: Array
    effort: Array
    sources: Mapping[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        n = number_array("limits.lower", self.lower).size
        for name in ("lower", "upper"):
            bound = number_array(f"limits.{name}", getattr(self, name))
            if bound.shape != (n,) or np.isnan(bound).any():
                raise InvalidInputError(f"limits.{name}", bound, f"{n} numbers, one per joint, no NaN")
            bound.flags.writeable = False
            object.__setattr__(self, name, bound)
        if not (self.lower < self.upper).all():
            raise InvalidInputError("limits.lower", self.lower, f"below limits.upper = {self.upper.tolist()}")
        for name in ("velocity", "acceleration", "jerk", "effort"):
            object.__setattr__(self, name, positive_array(f"limits.{name}", getattr(self, name), n))

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.lower)

    @property
    def middle(self) -> Array:
        """The middle of each joint's position limits (n,) [rad or m]; 0, or the nearer limit, where they are not finite."""
        is_bounded = np.isfinite(self.lower) & np.isfinite(self.upper)
        low, high = (np.where(is_bounded, each, 0.0) for each in (self.lower, self.upper))
        return np.where(is_bounded, (low + high) / 2, np.clip(0.0, self.lower, self.upper))

    def with_changes(self, changes: Mapping[str, ArrayLike], *, source: str = "given") -> "JointLimits":
        """A copy with other limits, e.g. ``{"acceleration": 5.0}``; one number applies to all joints."""
        known = {f.name for f in fields(self)} - {"sources"}
        if not isinstance(changes, Mapping):
            raise InvalidInputError("changes", changes, f"a mapping with the keys {', '.join(sorted(known))}")
        values, source = {}, text("source", source)
        for name, value in changes.items():
            given = number_array(f"limits.{one_of('limit', name, known)}", value)
            values[name] = np.broadcast_to(given, (self.n,)) if given.ndim == 0 else given
        sources = {**self.sources, **dict.fromkeys(changes, source)}
        return JointLimits(**{name: values.get(name, getattr(self, name)) for name in known}, sources=sources)

    def outside(self, q: Array) -> Array:
        """How far each joint of q (..., n) is outside its position limits [rad or m]; 0 inside."""
        q = configurations("q", q, self.n)
        return np.maximum(np.maximum(self.lower - q, q - self.upper), 0.0)
