"""The time by which work has to end."""

import time
from dataclasses import dataclass

import numpy as np


class OutOfTimeError(Exception):
    """The deadline has passed. It does not leave the package: whoever set the deadline goes on with what was found."""


@dataclass(frozen=True, kw_only=True)
class Deadline:
    """A time by which work has to end, also in other processes.

    Attributes:
        at: in time.monotonic() [s]; inf: never.
    """

    at: float = np.inf

    @classmethod
    def within(cls, seconds: float) -> "Deadline":
        """The deadline that passes after a number of seconds."""
        return cls(at=time.monotonic() + seconds)

    @property
    def left(self) -> float:
        """The time that is left [s], at least 0."""
        return max(self.at - time.monotonic(), 0.0)

    @property
    def passed(self) -> bool:
        """Whether no time is left."""
        return time.monotonic() >= self.at

    def check(self) -> None:
        """Raise OutOfTimeError if no time is left."""
        if self.passed:
            raise OutOfTimeError

    def __reduce__(self) -> tuple[object, ...]:
        return _of_clock, (time.time() + self.left,)  # monotonic clocks of two machines begin at different times


def _of_clock(at: float) -> Deadline:
    """The deadline at a time of the system's clock [s]."""
    return Deadline.within(at - time.time())


#: No deadline.
NEVER = Deadline()
