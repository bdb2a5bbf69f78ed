"""Data in JSON and YAML files from untrusted sources, read strictly; and values of this package in JSON.

In JSON, infinite numbers and nan are strings, since it has none; an enum is its name, a dataclass the mapping of its fields.

YAML is read by the core rules of YAML 1.2: no repeated key, no value that contains itself, bounds on depth and size. What YAML
1.1 and 1.2 read as different values, such as 010, 1:30, 1_000, yes or a date, is refused: the file has to put it into quotes,
or write it out.
"""

import json
import re
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar, get_origin

import numpy as np
import yaml

from manipplan.support.checks import Array
from manipplan.support.errors import FileFormatError

if TYPE_CHECKING:
    from cattrs import Converter

Value = TypeVar("Value")
#: Maximum size of a file [bytes].
LARGEST_JSON = 64 * 2**20
#: Numbers that are strings in JSON.
NOT_FINITE = ("inf", "-inf", "nan")


def read_json(argument: str, path: Path) -> Any:
    """The value of a JSON file.

    Raises FileFormatError for a file that is too large, is no JSON in UTF-8, repeats a key, or holds NaN or Infinity.
    """
    try:
        size = path.stat().st_size
        if size > LARGEST_JSON:
            raise FileFormatError(argument, f"{path} of {size:,} bytes", f"at most {LARGEST_JSON:,} bytes of JSON")
        return parsed(path.read_bytes())
    except (ValueError, OSError, RecursionError) as error:
        if isinstance(error, FileFormatError):
            raise
        reason = " ".join(str(error).split())[:200]
        raise FileFormatError(argument, str(path), f"JSON ({reason})") from error


def parsed(data: bytes | str) -> Any:
    """The value of a text in JSON; raises ValueError for anything else, a repeated key, NaN and Infinity."""
    return json.loads(data, object_pairs_hook=_distinct, parse_constant=_no_constant)


def _distinct(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) < len(pairs):
        names = [name for name, _ in pairs]
        raise ValueError(f"the key {next(name for name in found if names.count(name) > 1)!r} is repeated")
    return found


def _no_constant(name: str) -> float:
    raise ValueError(f"{name} is no number of JSON")


def json_ready(value: Any) -> Any:
    """`value` for JSON."""
    if isinstance(value, np.ndarray):
        value = value.tolist()
    if isinstance(value, Enum):
        return value.name
    if is_dataclass(value) and not isinstance(value, type):
        return {each.name: json_ready(getattr(value, each.name)) for each in fields(value)}
    if isinstance(value, Mapping):
        return {key: json_ready(each) for key, each in value.items()}
    if isinstance(value, list | tuple):
        return [json_ready(each) for each in value]
    if isinstance(value, float | np.floating):
        return float(value) if np.isfinite(value) else str(float(value))
    return value


def from_json(data: Any, kind: type[Value]) -> Value:
    """The value of a class that `json_ready` turned into `data`.

    Raises ValueError, which names the entries, for data of another kind: types are checked, and nothing is converted.
    """
    from cattrs import BaseValidationError, transform_error

    if not isinstance(data, Mapping):
        raise ValueError(f"{data!r} is no {kind.__name__}")
    try:
        return _converter().structure(data, kind)
    except BaseValidationError as error:
        faults = transform_error(error, path=kind.__name__, format_exception=_fault)
        raise ValueError("; ".join(faults[:3])) from error


def _fault(error: BaseException, kind: type | None) -> str:
    from cattrs.v import format_exception

    return str(error) if isinstance(error, TypeError | ValueError) and error.args else format_exception(error, kind)


def read_array(data: Any) -> Array:
    """Numbers of a file, possibly with the strings "inf" and "nan", as a read-only array."""
    array = np.array(data, dtype=float)
    array.flags.writeable = False
    return array


def pack_array(array: Array) -> dict[str, Any]:
    """Many numbers in little space: compressed, and with 32 bits each where that is exact."""
    import base64
    import zlib

    short = array.astype("<f4")
    exact = short if (short == array).all() else array.astype("<f8")
    text = base64.b64encode(zlib.compress(exact.tobytes(), 6)).decode("ascii")
    return {"packed": text, "type": exact.dtype.str, "shape": list(array.shape)}


def unpack_array(data: Mapping[str, Any]) -> Array:
    """The numbers of `pack_array`; raises ValueError for anything else, before more is unpacked than its shape holds."""
    import base64
    import math
    import zlib

    shape, kind = data["shape"], data["type"]
    if kind not in ("<f4", "<f8") or not all(type(k) is int and k >= 0 for k in shape):
        raise ValueError(f"packed numbers of type {kind!r} and shape {shape!r}")
    size = math.prod(shape) * np.dtype(kind).itemsize
    unpacking = zlib.decompressobj()
    try:
        raw = unpacking.decompress(base64.b64decode(data["packed"], validate=True), size + 1)
    except (zlib.error, TypeError) as error:
        raise ValueError(f"packed numbers that cannot be unpacked ({error})") from error
    if len(raw) != size or not unpacking.eof:
        raise ValueError(f"packed numbers that do not fill the shape {shape!r}")
    return read_array(np.frombuffer(raw, kind).reshape(shape))


@cache
def _converter() -> "Converter":
    from cattrs import Converter

    converter = Converter(forbid_extra_keys=True)
    converter.register_structure_hook_func(_is_array, lambda data, _: read_array(data))
    converter.register_structure_hook_func(_is_enum, _member)
    for kind in (str, bool, int):
        converter.register_structure_hook(kind, _check)
    converter.register_structure_hook(float, _number)
    return converter


def _is_array(kind: Any) -> bool:
    origin: Any = get_origin(getattr(kind, "__value__", kind))
    return origin is np.ndarray


def _is_enum(kind: Any) -> bool:
    return isinstance(kind, type) and issubclass(kind, Enum)


def _member(name: Any, kind: type[Enum]) -> Enum:
    if name not in kind.__members__:
        raise ValueError(f"{name!r} is no {kind.__name__}")
    return kind[name]


def _check(data: Any, kind: type) -> Any:
    if type(data) is not kind:
        raise TypeError(f"{data!r} is not of type {kind.__name__}")
    return data


def _number(data: Any, _: type) -> float:
    if type(data) not in (float, int) and data not in NOT_FINITE:
        raise TypeError(f"{data!r} is not a number")
    return float(data)


#: Maximum depth of nested values, and maximum number of values, with those of every alias counted again.
DEEPEST, MOST = 100, 500_000
#: Maximum size of a file [bytes].
LARGEST_YAML = 32 * 2**20

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
        if size > LARGEST_YAML:
            raise FileFormatError(argument, f"{path} of {size:,} bytes", f"at most {LARGEST_YAML:,} bytes of YAML")
        return _Reader(path.read_text(encoding="utf-8")).document()
    except yaml.YAMLError as error:
        reason = " ".join(str(error).replace('"<unicode string>", ', "").split())
    except UnicodeDecodeError as error:
        reason = f"in UTF-8; {error}"
    except OSError as error:
        reason = str(error.strerror)
    raise FileFormatError(argument, str(path), f"YAML ({reason})")


class _Reader:
    """Makes the value of a document from the parser's events, within the bounds."""

    def __init__(self, text: str) -> None:
        self.parser = _Parser(text)
        self.values: dict[str, tuple[Any, int]] = {}  # value and number of values in it, by anchor
        self.open: list[str | None] = []  # anchors of the values that contain the next one
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
