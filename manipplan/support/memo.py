"""Results that are computed once per owner, such as a robot, and thread, and stored on the owner."""

import threading
from collections.abc import Callable
from functools import wraps
from typing import Any, Concatenate, ParamSpec, TypeVar

from manipplan.support.deadline import building

Owner = TypeVar("Owner")
Made = TypeVar("Made")
Arguments = ParamSpec("Arguments")

#: The attribute that holds the results, by function and arguments.
MEMO = "_memo"


def once_per_owner(make: Callable[Concatenate[Owner, Arguments], Made]) -> Callable[Concatenate[Owner, Arguments], Made]:
    """Store the results of `make(owner, *arguments)` on the owner, one per set of arguments, which must be hashable.

    No time limit counts the time of `make`. A copy of the owner, by pickle or `dataclasses.replace`, starts without results;
    its class leaves them out of its state with `state_without_memo`.
    """

    @wraps(make)
    def kept(owner: Owner, /, *arguments: Arguments.args, **options: Arguments.kwargs) -> Made:
        memo: dict[Any, Made] = vars(owner).setdefault(MEMO, {}).setdefault(threading.get_ident(), {})
        key = (make, arguments, tuple(sorted(options.items())))
        if key not in memo:
            with building():
                memo[key] = make(owner, *arguments, **options)
        return memo[key]

    return kept


def state_without_memo(owner: object) -> dict[str, Any]:
    """The state of an owner for pickle, without results: they hold pointers into Pinocchio, which cannot be copied."""
    return {name: value for name, value in vars(owner).items() if name != MEMO}
