"""YAML files from untrusted sources, by the core rules of YAML 1.2.

No repeated key, no value that contains itself, bounds on depth and size. What YAML 1.1 and 1.2 read as different values, such
as 010, 1:30, 1_000, yes or a date, is refused: the file has to put it into quotes, or write it out.
"""

import re
from pathlib import Path
from typing import Any

import yaml

from manipplan.support.errors import FileFormatError

#: Maximum depth of nested values, and maximum number of values, with those of every alias counted again.
DEEPEST, MOST = 100, 500_000
#: Maximum size of a file [bytes].
LARGEST = 32 * 2**20

_Parser: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)  # in C where available
_INT = re.compile(r"[-+]?(?:0|[1-9][0-9]*)")
_FLOAT = re.compile(r"[-+]?(?:\.[0-9]+|(?:0|[1-9][0-9]*)(?:\.[0-9]*)?)(?:[eE][-+]?[0-9]+)?")
_RADIX = re.compile(r"0o[0-7]+|0x[0-9a-fA-F]+")
#: Plain scalars that are a number, a date or a truth value by the one version and something else by the other.
_AMBIGUOUS = re.compile(
    r"[-+]?0[0-9_]*[0-9](?:\.[0-9_]*)?(?:[eE][-+]?[0-9]+)?|[-+]?[0-9][0-9_.]*_[0-9_.]*(?:[eE][-+]?[0-9]+)?|[-+]?0b[01_]+"
    r"|[-+]?0x[0-9a-fA-F_]*_[0-9a-fA-F_]*|[-+]0[xo][0-9a-fA-F]+|[-+]?[0-9][0-9_]*(?::[0-5]?[0-9])+(?:\.[0-9_]*)?"
    r"|[0-9]{4}-[0-9]{1,2}-[0-9]{1,2}(?:[Tt\s].*)?|yes|Yes|YES|no|No|NO|on|On|ON|off|Off|OFF"
)
_WORDS: dict[str, Any] = {
    **dict.fromkeys(("", "~", "null", "Null", "NULL")),
    **dict.fromkeys(("true", "True", "TRUE"), True),
    **dict.fromkeys(("false", "False", "FALSE"), False),
    **{sign + word: float(sign + "inf") for word in (".inf", ".Inf", ".INF") for sign in ("", "+", "-")},
    **dict.fromkeys((".nan", ".NaN", ".NAN"), float("nan")),
}
_STANDARD = "tag:yaml.org,2002:"


def read_yaml(argument: str, path: Path) -> Any:
    """The value of a YAML file.

    Raises FileFormatError when it is not YAML in UTF-8, a key is repeated in a mapping, a value contains itself or is
    ambiguous, or it is nested too deeply or too large.
    """
    try:
        size = path.stat().st_size
        if size > LARGEST:
            raise FileFormatError(argument, f"{path} of {size:,} bytes", f"at most {LARGEST:,} bytes of YAML")
        return _Reader(path.read_text(encoding="utf-8")).document()
    except yaml.YAMLError as error:
        reason = " ".join(str(error).replace('"<unicode string>", ', "").split())
    except UnicodeDecodeError as error:
        reason = f"in UTF-8; {error}"
    except OSError as error:
        reason = str(error.strerror)
    raise FileFormatError(argument, str(path), f"YAML ({reason})")


class _Reader:
    """Makes the value of a document from the parser's events, within the bounds.

    Attributes:
        values: value and number of values in it, by anchor.
        open: anchors of the values that contain the next one.
        count: number of values so far.
    """

    def __init__(self, text: str) -> None:
        self.parser = _Parser(text)
        self.values: dict[str, tuple[Any, int]] = {}
        self.open: list[str | None] = []
        self.count = 0

    def document(self) -> Any:
        """The value of the only document; None where there is none."""
        self._next()  # the stream's start
        event = self._next()
        if isinstance(event, yaml.StreamEndEvent):
            return None
        value = self._value(self._next())
        self._next()  # the document's end
        event = self._next()
        if not isinstance(event, yaml.StreamEndEvent):
            raise _error("a second document begins", event)
        return value

    def _next(self) -> Any:
        return self.parser.get_event()

    def _value(self, event: Any) -> Any:
        kind = type(event)
        before, anchor = self.count, event.anchor
        self.count += 1
        if kind is yaml.AliasEvent:
            if anchor in self.open:
                raise _error(f"the value of *{anchor} contains itself", event)
            if anchor not in self.values:
                raise _error(f"found undefined alias {anchor!r}", event)
            value, size = self.values[anchor]
            self.count += size
        if self.count > MOST:
            raise _error(f"more than {MOST:,} values, counting those of aliases", event)
        if kind is yaml.AliasEvent:
            return value
        if kind is yaml.ScalarEvent:
            value = self._scalar(event)
        else:
            if len(self.open) >= DEEPEST:
                raise _error(f"values nested more than {DEEPEST} deep", event)
            wanted = "seq" if kind is yaml.SequenceStartEvent else "map"
            if event.tag not in (None, "!", _STANDARD + wanted):
                raise _error(f"could not determine a constructor for the tag {event.tag!r}", event)
            self.open.append(anchor)
            value = self._sequence() if wanted == "seq" else self._mapping()
            self.open.pop()
        if anchor is not None:
            self.values[anchor] = value, self.count - before
        return value

    def _sequence(self) -> list[Any]:
        values = []
        while type(event := self._next()) is not yaml.SequenceEndEvent:
            values.append(self._value(event))
        return values

    def _mapping(self) -> dict[Any, Any]:
        values, merged, lines = dict[Any, Any](), dict[Any, Any](), dict[Any, int]()
        while type(event := self._next()) is not yaml.MappingEndEvent:
            key, line = self._value(event), event.start_mark.line + 1
            is_merge = key == "<<" and type(event) is yaml.ScalarEvent and event.implicit[0]
            try:
                first = lines.setdefault((type(key), key), line)
            except TypeError as error:
                raise _error("found unhashable key", event) from error
            if first != line or key in values:
                raise _error(f"the key {key!r} of line {first} is repeated", event)
            following = self._next()
            value = self._value(following)
            if not is_merge:
                values[key] = value
                continue
            for each in value if isinstance(value, list) else [value]:
                if not isinstance(each, dict):
                    raise _error("expected a mapping, or a list of mappings, to merge", following)
                merged = {**each, **merged}
        return {**merged, **values} if merged else values

    def _scalar(self, event: Any) -> Any:
        text: str = event.value
        if event.implicit[0]:
            return _plain(text, event)
        if event.tag in (None, "!", _STANDARD + "str"):
            return text
        kind = {"int": int, "float": float, "bool": bool, "null": type(None)}.get(event.tag.removeprefix(_STANDARD))
        if kind is None:
            raise _error(f"could not determine a constructor for the tag {event.tag!r}", event)
        value = _plain(text, event)
        if kind is float and type(value) is int:
            value = float(value)
        if type(value) is not kind:
            raise _error(f"{text!r} is not of the type of its tag, {event.tag}", event)
        return value


def _plain(text: str, event: Any) -> Any:
    """The value of a scalar without quotes and tag."""
    if text in _WORDS:
        return _WORDS[text]
    if text[0] in "+-.0123456789":
        try:
            if _INT.fullmatch(text):
                return int(text)
            if _FLOAT.fullmatch(text):
                return float(text)
            if _RADIX.fullmatch(text):
                return int(text, 0)
        except ValueError as error:  # more digits than Python converts
            raise _error(" ".join(str(error).split()), event) from error
    if _AMBIGUOUS.fullmatch(text):
        raise _error(
            f"{text[:40]!r} is ambiguous: versions of YAML differ in what it means; put a text into quotes, and write a number "
            "or true and false out",
            event,
        )
    return text


def _error(problem: str, event: Any) -> yaml.YAMLError:
    return yaml.composer.ComposerError(None, None, f"{problem}, in line {event.start_mark.line + 1}", None)
