"""Text from a file or a user, made safe before it reaches generated source or a terminal.

Names of robots, joints and frames may contain anything. A name enters generated source only through `identifier`, and a
terminal only through `terminal_text`. HTML pages use `html.escape`.
"""

import keyword
import re
import unicodedata
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.text import Text

#: Number of characters by which every C99 compiler distinguishes identifiers.
LONGEST = 63

_OF_C_AND_CXX = """
    alignas alignof and and_eq asm auto bitand bitor bool break case catch char char8_t char16_t char32_t class compl concept
    const consteval constexpr constinit const_cast continue co_await co_return co_yield decltype default delete do double
    dynamic_cast else enum explicit export extern false float for friend goto if inline int long mutable namespace new
    noexcept not not_eq nullptr operator or or_eq private protected public register reinterpret_cast requires restrict return
    short signed sizeof static static_assert static_cast struct switch template this thread_local throw true try typedef
    typeid typename typeof typeof_unqual union unsigned using virtual void volatile wchar_t while xor xor_eq
"""
#: Reserved words of C, C++ and Python.
KEYWORDS = frozenset(_OF_C_AND_CXX.split()) | frozenset(keyword.kwlist)


def identifier(name: str) -> str:
    """`name` as an identifier of C, C++ and Python: ASCII letters, digits and single underscores, a letter first.

    It is never empty, never a keyword and never longer than `LONGEST`. Two names may become the same identifier.
    """
    text = "_".join(re.findall("[A-Za-z0-9]+", name)) or "unnamed"
    if text[0].isdigit():
        text = f"n{text}"
    if text in KEYWORDS:
        text += "_name"
    return text[:LONGEST].rstrip("_")


def is_identifier(name: str) -> bool:
    """Whether `identifier` leaves `name` as it is."""
    return identifier(name) == name


def printable(text: str) -> str:
    """`text` with control characters, which a terminal obeys, as escapes; line ends and tabs are kept."""
    return "".join(_escape(character) for character in text)


def terminal_text(text: str, style: str = "") -> "Text":
    """`text` for rich, which prints it as it is: no markup, no emoji codes, no control characters."""
    from rich.text import Text

    return Text(printable(text), style=style)


def _escape(character: str) -> str:
    hidden = unicodedata.category(character) in ("Cc", "Cf", "Cs", "Zl", "Zp") and character not in "\n\t"
    return character.encode("unicode_escape").decode() if hidden else character
