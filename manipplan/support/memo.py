"""Results that are made once per owner, such as a robot, and kept on it as long as it lives."""

from collections.abc import Callable
from functools import wraps
from typing import Any, Concatenate, ParamSpec, TypeVar

Owner = TypeVar("Owner")
Made = TypeVar("Made")
Arguments = ParamSpec("Arguments")

#: The attribute that holds what was made, by function and arguments.
MEMO = "_memo"


def once_per_owner(make: Callable[Concatenate[Owner, Arguments], Made]) -> Callable[Concatenate[Owner, Arguments], Made]:
    """Keep the results of `make(owner, *arguments)` on the owner, one for each set of arguments; these have to be hashable.

    A copy of the owner, by pickle or `dataclasses.replace`, begins without results; its class leaves them out of its state by
    `state_without_memo`.
    """

    @wraps(make)
    def kept(owner: Owner, /, *arguments: Arguments.args, **options: Arguments.kwargs) -> Made:
        memo: dict[Any, Made] = vars(owner).setdefault(MEMO, {})
        key = (make, arguments, tuple(sorted(options.items())))
        if key not in memo:
            memo[key] = make(owner, *arguments, **options)
        return memo[key]

    return kept


def state_without_memo(owner: object) -> dict[str, Any]:
    """What pickle takes of an owner. Results that are kept hold pointers into Pinocchio, which cannot be copied."""
    return {name: value for name, value in vars(owner).items() if name != MEMO}
