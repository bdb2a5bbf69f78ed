"""Progress of long computations: the share done, in [0, 1], and a text that names the current step."""

from collections.abc import Callable

from manipplan.support.errors import InvalidInputError

Progress = Callable[[float, str], None]


def silent(_share: float, _text: str) -> None:
    """Ignore progress."""


def teller(progress: Progress | None) -> Progress:
    """The progress callback, `silent` for None; raises InvalidInputError when it cannot be called."""
    if progress is not None and not callable(progress):
        raise InvalidInputError("progress", progress, "a function of (share, text), or None")
    return progress or silent


def part(tell: Progress, begin: float, end: float) -> Progress:
    """The callback for a part of the work: its shares 0 to 1 are reported as `begin` to `end` of the whole.

    The end of the part is not reported: the next part reports its own start.
    """
    return lambda share, text: tell(begin + share * (end - begin), text) if share < 1 else None
