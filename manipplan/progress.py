"""How long work tells how far it is: a share done in [0, 1] and what is being done."""

from collections.abc import Callable

Progress = Callable[[float, str], None]


def silent(_share: float, _text: str) -> None:
    """Tell nobody."""
