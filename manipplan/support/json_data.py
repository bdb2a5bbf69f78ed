"""Values of this package in a form that JSON can represent, and back.

Infinite numbers and nan are strings, since JSON has none; an enum is its name, a dataclass the mapping of its fields.
"""

import json
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar, get_origin

import numpy as np

from manipplan.support.checks import Array
from manipplan.support.errors import FileFormatError

if TYPE_CHECKING:
    from cattrs import Converter

Value = TypeVar("Value")
#: Maximum size of a file [bytes].
LARGEST = 64 * 2**20
#: Numbers that are strings in JSON.
NOT_FINITE = ("inf", "-inf", "nan")


def read_json(argument: str, path: Path) -> Any:
    """The value of a JSON file.

    Raises FileFormatError for a file that is too large, is no JSON in UTF-8, repeats a key, or holds NaN or Infinity.
    """
    try:
        size = path.stat().st_size
        if size > LARGEST:
            raise FileFormatError(argument, f"{path} of {size:,} bytes", f"at most {LARGEST:,} bytes of JSON")
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
