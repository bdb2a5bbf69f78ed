"""How long work tells how far it is: a share done in [0, 1] and what is being done."""

from collections.abc import Callable

from manipplan.support.errors import InvalidInputError

Progress = Callable[[float, str], None]


def silent(_share: float, _text: str) -> None:
    """Tell nobody."""


def teller(progress: Progress | None) -> Progress:
    """What to tell progress to; raises InvalidInputError for what cannot be called."""
    if progress is not None and not callable(progress):
        raise InvalidInputError("progress", progress, "a function of (share, text), or None")
    return progress or silent


def part(tell: Progress, begin: float, end: float) -> Progress:
    """Tells a part of the work, whose own shares run from 0 to 1, as that from `begin` to `end` of the whole.

    That the part is done is not told: what comes next tells its own beginning.
    """
    return lambda share, text: tell(begin + share * (end - begin), text) if share < 1 else None
