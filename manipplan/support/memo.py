"""Results that are computed once per owner, such as a robot, and thread, and stored on the owner."""

import threading
from collections.abc import Callable
from functools import wraps
from typing import Any, Concatenate, ParamSpec, TypeVar
from weakref import WeakKeyDictionary

from manipplan.support.deadline import building
from manipplan.support.expressions import making_expressions

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
