"""The time by which work has to end. What is built once, such as code and collision models, does not count."""

import os
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field

import numpy as np

from manipplan.support.checks import number


class OutOfTimeError(Exception):
    """The deadline has passed. It does not leave the package: whoever set the deadline goes on with what was found."""


class _WorkClock:
    """A clock of this process that stands still while at least one thread builds something."""

    def __init__(self) -> None:
        self._built = 0.0
        self.forget_builders()

    def forget_builders(self) -> None:
        """Go on in a forked process, where the threads that build are missing."""
        self._lock = threading.Lock()
        self._builders, self._since = 0, 0.0

    def time(self) -> float:
        with self._lock:
            now = time.monotonic()
            return now - self._built - (now - self._since if self._builders else 0.0)

    def stop(self) -> None:
        with self._lock:
            if self._builders == 0:
                self._since = time.monotonic()
            self._builders += 1

    def go_on(self) -> None:
        with self._lock:
            self._builders -= 1
            if self._builders == 0:
                self._built += time.monotonic() - self._since


_clock = _WorkClock()
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_clock.forget_builders)


def work_time() -> float:
    """Time of a clock that stands still while something is built once per machine, process, robot or scene [s]."""
    return _clock.time()


@contextmanager
def building() -> Iterator[None]:
    """The clock of `work_time` stands still in this block."""
    _clock.stop()
    try:
        yield
    finally:
        _clock.go_on()


@dataclass(frozen=True, kw_only=True)
class Deadline:
    """A time by which work has to end, also in other processes: `at` in `work_time` [s]; inf: never."""

    at: float = np.inf

    @classmethod
    def within(cls, seconds: float) -> "Deadline":
        """The deadline that passes after a number of seconds."""
        return cls(at=work_time() + seconds)

    @property
    def left(self) -> float:
        """The time that is left [s], at least 0."""
        return max(self.at - work_time(), 0.0)

    @property
    def passed(self) -> bool:
        """Whether no time is left."""
        return work_time() >= self.at

    def check(self) -> None:
        """Raise OutOfTimeError if no time is left."""
        if self.passed:
            raise OutOfTimeError

    def __reduce__(self) -> tuple[object, ...]:
        return _of_clock, (time.time() + self.left,)  # monotonic clocks of two machines begin at different times


@dataclass(frozen=True, kw_only=True)
class Cancellation(Deadline):
    """A deadline that passes when it is cancelled, for threads of this process."""

    event: threading.Event = field(default_factory=threading.Event)

    def cancel(self) -> None:
        self.event.set()

    @property
    def passed(self) -> bool:
        return self.event.is_set()


def _of_clock(at: float) -> Deadline:
    """The deadline at a time of the system's clock [s]."""
    return Deadline.within(at - time.time())


#: No deadline.
NEVER = Deadline()


def until(deadline: Deadline, notify: Callable[[float, str], None]) -> Callable[[float, str], None]:
    """A progress callback that raises OutOfTimeError once the deadline has passed."""

    def check(share: float, text: str) -> None:
        deadline.check()
        notify(share, text)

    return check


#: Share of a time limit by which it may be exceeded, and share of the likely time for timing and checks without which these are
#: not begun.
EXCESS, LEAST_ENDING = 0.1, 0.9


class TimeLimit:
    """The limit of a job, which ends with timing and checks, in seconds, None for none; `step`: text of the last progress."""

    def __init__(self, seconds: float | None, step: str) -> None:
        """`step`: the first one. Raises InvalidInputError for a limit that is none."""
        self.seconds = None if seconds is None else number("time_limit", seconds, above=0.0)
        self.deadline = NEVER if self.seconds is None else Deadline.within(self.seconds)
        self.step = step
        self._last = NEVER if self.seconds is None else Deadline(at=self.deadline.at + EXCESS * self.seconds)

    def noting(self, notify: Callable[[float, str], None]) -> Callable[[float, str], None]:
        """A progress callback that remembers the step."""

        def note(share: float, text: str) -> None:
            self.step = text
            notify(share, text)

        return note

    def check_ending(self, seconds: float) -> None:
        """Raise OutOfTimeError if timing and checks, which take about this long [s], would end too late."""
        if self._last.left < LEAST_ENDING * seconds:
            self.step = f"timing and checks, which take about {seconds:.1g} s"
            raise OutOfTimeError

    def missed(self, what: str) -> str:
        """The message where nothing was found in time."""
        return f"no {what} was proven within time_limit = {self.seconds:g} s; the last step was {self.step!r}"
