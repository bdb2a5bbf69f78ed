"""Progress of long computations: the share done, in [0, 1], and a text that names the current step.

Interrupts: one that arrives while CasADi computes is not lost; one that would leave a half-finished import is delayed.

CasADi turns an interrupt, at random, into a failed evaluation, a stopped solver, a SystemError or an error about the type of
an argument. It also reports the interrupt on standard error, where it is of no use.
"""

import io
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType
from typing import TextIO

from manipplan.support.errors import InvalidInputError

Progress = Callable[[float, str], None]


def silent(_share: float, _text: str) -> None:
    """Ignore progress."""


def as_callback(progress: Progress | None) -> Progress:
    """The progress callback, `silent` for None; raises InvalidInputError when it cannot be called."""
    if progress is not None and not callable(progress):
        raise InvalidInputError("progress", progress, "a function of (share, text), or None")
    return progress or silent


def part(notify: Progress, begin: float, end: float) -> Progress:
    """The callback for a part of the work: its shares 0 to 1 are reported as `begin` to `end` of the whole.

    The end of the part is not reported: the next part reports its own start.
    """
    return lambda share, text: notify(begin + share * (end - begin), text) if share < 1 else None


def rising(notify: Progress) -> Progress:
    """The callback, for work that may be done more than once: shares that would fall stay as they were."""
    most = 0.0

    def report(share: float, text: str) -> None:
        nonlocal most
        most = max(most, share)
        notify(most, text)

    return report


@contextmanager
def interruptible() -> Iterator[None]:
    """Raise KeyboardInterrupt by the end of the block if an interrupt arrived in it; also usable as a decorator."""
    previous = signal.getsignal(signal.SIGINT)
    if threading.current_thread() is not threading.main_thread() or not callable(previous):
        yield
        return
    before = previous
    came = False
    quiet: _WithoutCasadi | None = None

    def remember(number: int, frame: FrameType | None) -> None:
        nonlocal came, quiet
        came = True
        if not isinstance(sys.stderr, _WithoutCasadi):
            quiet = sys.stderr = _WithoutCasadi(sys.stderr)
        before(number, frame)

    signal.signal(signal.SIGINT, remember)
    try:
        yield
    except Exception as error:
        if came:
            raise KeyboardInterrupt from error
        raise
    finally:
        signal.signal(signal.SIGINT, previous)
        if quiet is not None:
            quiet.finish()
            sys.stderr = quiet.stream
    if came:
        raise KeyboardInterrupt


@contextmanager
def uninterrupted() -> Iterator[None]:
    """Delay an interrupt until the block ends: for a second of imports, which report errors if left half-finished."""
    previous = signal.getsignal(signal.SIGINT)
    if threading.current_thread() is not threading.main_thread() or not callable(previous):
        yield
        return
    held: list[tuple[int, FrameType | None]] = []
    signal.signal(signal.SIGINT, lambda number, frame: held.append((number, frame)))
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, previous)
    if held:
        previous(*held[0])


class _WithoutCasadi(io.TextIOBase):
    """A stream that drops the lines in which CasADi reports the interrupt; CasADi writes them piece by piece."""

    def __init__(self, stream: TextIO) -> None:
        self.stream = stream
        self._begun = ""

    def write(self, text: str) -> int:
        *lines, self._begun = (self._begun + text).split("\n")
        for line in lines:
            if not line.startswith("CasADi - "):
                self.stream.write(line + "\n")
        return len(text)

    def finish(self) -> None:
        """Write the last, unfinished line."""
        self.stream.write(self._begun)
        self._begun = ""
