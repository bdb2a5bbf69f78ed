"""Results that are computed once: per owner, such as a robot, and thread, and stored on the owner; or by content, in a file.

The key of a value, or of this package's code, is equal for equal content, in every process.
"""

import hashlib
import threading
from collections.abc import Callable, Mapping, Set
from dataclasses import fields, is_dataclass
from enum import Enum
from functools import cache, wraps
from pathlib import Path, PurePath
from types import BuiltinFunctionType, CodeType, FunctionType
from typing import Any, Concatenate, ParamSpec, TypeVar
from weakref import WeakKeyDictionary

import numpy as np

from manipplan.support.deadline import building
from manipplan.support.expressions import making_expressions

#: The package, and those of its folders on which no result depends.
PACKAGE = Path(__file__).parents[1]
FACES = ("cli", "viz")


@cache
def code_key() -> str:
    """SHA-256 of the code of this package on which results depend, in hexadecimal digits."""
    digest = hashlib.sha256()
    for file in sorted(PACKAGE.rglob("*")):
        name = file.relative_to(PACKAGE)
        if file.suffix in (".py", ".c", ".h") and name.parts[0] not in FACES:
            digest.update(_join(name.as_posix(), file.read_bytes()))
    return digest.hexdigest()


def content_key(value: Any) -> str:
    """SHA-256 of the content of a value, in hexadecimal digits.

    Dataclasses count by their fields, sets and mappings whatever their order, other objects by what pickle takes of them. The
    bytes of pickle itself differ from process to process, with the order of sets and with texts that are one object.
    """
    return _digest(value).hex()


def _digest(value: Any) -> bytes:
    kind = type(value)
    name = f"{kind.__module__}.{kind.__qualname__}"
    if value is None or kind in (bool, int, float, complex, str, bytes):
        return _join(name, repr(value).encode())
    if isinstance(value, np.generic):
        return _digest(value.item())
    if isinstance(value, np.ndarray) and value.dtype != object:
        return _join(name, f"{value.dtype.str}{value.shape}".encode(), np.ascontiguousarray(value).tobytes())
    if isinstance(value, Enum):
        return _join(name, value.name.encode())
    if isinstance(value, PurePath):
        return _join("path", str(value).encode())
    if isinstance(value, FunctionType) and "<" in value.__qualname__:  # a lambda or a local function: no name tells which
        return _join("function", f"{value.__module__}.{value.__qualname__}".encode(), *map(_digest, _code_of(value)))
    if isinstance(value, type | FunctionType | BuiltinFunctionType):
        return _join("name", f"{value.__module__}.{value.__qualname__}".encode())
    if isinstance(value, Mapping):
        return _join(name, *sorted(_digest(key) + _digest(each) for key, each in value.items()))
    if isinstance(value, Set):
        return _join(name, *sorted(map(_digest, value)))
    if isinstance(value, list | tuple):
        return _join(name, *map(_digest, value))
    if is_dataclass(value) and not _pickles_itself(kind):
        return _join(name, *(each.name.encode() + _digest(getattr(value, each.name)) for each in fields(value)))
    if callable(getattr(value, "computeLocalAABB", None)):  # a shape of coal, whose state has its box once it was computed
        value.computeLocalAABB()
    reduced = value.__reduce_ex__(4)
    if isinstance(reduced, str):
        return _join(name, reduced.encode())
    make, arguments, *state = reduced
    lists = [list(each) if k > 0 and each is not None else each for k, each in enumerate(state)]
    return _join(name, _digest(make), _digest(arguments), _digest(lists))


def _code_of(function: FunctionType) -> tuple[object, ...]:
    """What a function without a name of its own does: its instructions, constants, names, defaults and captured values."""
    code = function.__code__
    constants = tuple(each if not isinstance(each, CodeType) else each.co_code for each in code.co_consts)
    captured = tuple(cell.cell_contents for cell in function.__closure__ or ())
    return code.co_code, constants, code.co_names, function.__defaults__, function.__kwdefaults__, captured


def _pickles_itself(kind: type) -> bool:
    return any("__reduce__" in vars(each) or "__reduce_ex__" in vars(each) for each in kind.__mro__[:-1])


def _join(name: str, *parts: bytes) -> bytes:
    """The digest of some parts: their lengths count, too, so that no two lists of parts are the same bytes."""
    digest = hashlib.sha256()
    for part in (name.encode(), *parts):
        digest.update(len(part).to_bytes(8, "big"))
        digest.update(part)
    return digest.digest()


Owner = TypeVar("Owner")
Other = TypeVar("Other")
Made = TypeVar("Made")
Arguments = ParamSpec("Arguments")

#: The attributes that hold the results, by function and arguments, and the owner whose results are shared.
MEMO, SOURCE = "_memo", "_source"


def once_per_owner(make: Callable[Concatenate[Owner, Arguments], Made]) -> Callable[Concatenate[Owner, Arguments], Made]:
    """Store the results of `make(owner, *arguments)` on the owner, one per set of arguments, which must be hashable.

    No time limit counts the time of `make`. A copy of the owner, by pickle or `dataclasses.replace`, starts without results;
    its class leaves them out of its state with `state_without_memo`.
    """

    @wraps(make)
    def call_once(owner: Owner, /, *arguments: Arguments.args, **options: Arguments.kwargs) -> Made:
        memo = _memo(owner)
        key = (make, arguments, tuple(sorted(options.items())))
        if key not in memo:
            with building(), making_expressions():
                memo[key] = make(owner, *arguments, **options)
        found: Made = memo[key]
        return found

    return call_once


def once_per_source(make: Callable[Concatenate[Owner, Arguments], Made]) -> Callable[Concatenate[Owner, Arguments], Made]:
    """The same for results that an owner shares with its source; see `share_results`."""
    stored = once_per_owner(make)

    @wraps(make)
    def call_once(owner: Owner, /, *arguments: Arguments.args, **options: Arguments.kwargs) -> Made:
        return stored(source_of(owner), *arguments, **options)

    return call_once


def share_results(made: Owner, source: Owner) -> Owner:
    """Let what was made from a source have its results of `once_per_source`: nothing that these depend on differs."""
    vars(made)[SOURCE] = source_of(source)
    return made


def source_of(owner: Owner) -> Owner:
    """The owner whose results are shared: the source, or the owner itself."""
    source: Owner = vars(owner).get(SOURCE, owner)
    return source


def once_per_pair(make: Callable[[Owner, Other], Made]) -> Callable[[Owner, Other], Made]:
    """Store the results of `make(owner, other)` on the owner for as long as the other one is in use.

    A result may refer to its owner, but not to the other one, which would then never be freed. No time limit counts `make`.
    """

    @wraps(make)
    def call_once(owner: Owner, other: Other, /) -> Made:
        found: WeakKeyDictionary[Other, Made] = _memo(owner).setdefault(make, WeakKeyDictionary())
        if other not in found:
            with building(), making_expressions():
                found[other] = make(owner, other)
        return found[other]

    return call_once


def _memo(owner: object) -> dict[Any, Any]:
    """What this thread has stored on an owner."""
    memo: dict[Any, Any] = vars(owner).setdefault(MEMO, {}).setdefault(threading.get_ident(), {})
    return memo


def state_without_memo(owner: object) -> dict[str, Any]:
    """The state of an owner for pickle, without results: they hold pointers into Pinocchio, which cannot be copied."""
    return {name: value for name, value in vars(owner).items() if name not in (MEMO, SOURCE)}
