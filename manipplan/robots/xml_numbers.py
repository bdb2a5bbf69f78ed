"""Numbers in the attributes of XML elements."""

import math


def numbers(text: str | None, count: int) -> tuple[float, ...] | None:
    """The `count` finite numbers in `text`, separated by spaces; None if `text` is anything else."""
    words = text.split() if text is not None else []
    try:
        values = tuple(float(word) for word in words)
    except ValueError:
        return None
    return values if len(values) == count and all(map(math.isfinite, values)) else None
