"""Short texts of values: every public value has a `repr` of one line."""

from collections.abc import Callable, Collection, Mapping
from dataclasses import fields, is_dataclass
from decimal import ROUND_CEILING, ROUND_FLOOR, Context
from enum import Enum
from typing import Any, TypeVar

import numpy as np

Value = TypeVar("Value", bound=type)
#: Maximum number of characters of a text, of the numbers that are printed one by one, and of characters of a string in it.
LONGEST, MOST_NUMBERS, LONGEST_STRING = 200, 8, 40


def one_line(kind: Value) -> Value:
    """Class decorator for dataclasses: `repr` gives the class and its fields in one line, without large arrays.

    Fields that are None or empty are left out; nested values are named by their class or their `name`.
    """
    assert is_dataclass(kind)
    kind.__repr__ = _repr  # type: ignore[method-assign]
    return kind


class Pictured:
    """Base of values that notebooks show with a picture."""

    def _repr_html_(self) -> str:
        """HTML with the value's text and picture."""
        from manipplan.viz.figure import html_of

        return html_of(self)


def _repr(value: Any) -> str:
    given = ((each.name, getattr(value, each.name)) for each in fields(value) if each.repr and not each.name.startswith("_"))
    parts = [f"{name}={short(part)}" for name, part in given if not _is_empty(part)]
    text = f"{type(value).__name__}({', '.join(parts)})"
    return text if len(text) <= LONGEST else text[: LONGEST - 4] + "...)"


def round_up(value: float, digits: int) -> float:
    """`value` rounded up to a number of significant digits."""
    return float(Context(prec=digits, rounding=ROUND_CEILING).create_decimal_from_float(value))


def round_down(value: float, digits: int) -> float:
    """`value` rounded down to a number of significant digits."""
    return float(Context(prec=digits, rounding=ROUND_FLOOR).create_decimal_from_float(value))


def short(value: Any) -> str:
    """A value in a few words."""
    if isinstance(value, np.ndarray) and (value.ndim != 1 or value.size > MOST_NUMBERS):
        return f"<{' x '.join(map(str, value.shape))} array>"
    if isinstance(value, np.ndarray):
        return f"[{', '.join(map(short, value.tolist()))}]"
    if isinstance(value, Enum):
        return value.name
    if isinstance(value, bool) or value is None:
        return str(value)
    if isinstance(value, float | np.floating):
        return f"{value:.4g}"
    if isinstance(value, int | np.integer):
        return str(value)
    if isinstance(value, str):
        return repr(value if len(value) <= LONGEST_STRING else value[: LONGEST_STRING - 3] + "...")
    name = getattr(value, "name", None)
    if isinstance(name, str):
        return f"{type(value).__name__}({name!r})"
    if isinstance(value, Mapping | tuple | list | set | frozenset):
        return _several(value)
    return f"{type(value).__name__}(...)" if is_dataclass(value) or isinstance(value, Callable) else _plain(value)  # type: ignore[arg-type]


def _several(value: Mapping[Any, Any] | Collection[Any]) -> str:
    are_short = len(value) <= MOST_NUMBERS and isinstance(value, tuple | list)
    if are_short and all(isinstance(each, int | float | str) for each in value):
        return f"({', '.join(map(short, value))})"
    return f"<{len(value)} entries>"


def _plain(value: object) -> str:
    text = repr(value)
    return text if "\n" not in text and len(text) <= LONGEST_STRING else f"<{type(value).__name__}>"


def _is_empty(value: Any) -> bool:
    return value is None or (isinstance(value, str | tuple | list | Mapping) and len(value) == 0)
