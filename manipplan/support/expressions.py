"""CasADi's expressions in several threads: one thread at a time makes them, and only that one frees them.

Expressions share constants, whose counts and whose table CasADi changes without the interpreter's lock and without one of its
own: two threads that make, or free, expressions with the same constants end the process. Evaluation is safe.
"""

import os
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import casadi as ca


class _Turn:
    """The lock of the thread that makes or frees expressions, and what is `unused`: whoever has the lock frees it."""

    def __init__(self) -> None:
        self.unused: list[object] = []
        self.forget_threads()

    def forget_threads(self) -> None:
        """Go on in a forked process, where no other thread has the lock."""
        self.lock = threading.RLock()


_turn = _Turn()
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_turn.forget_threads)


@contextmanager
def making_expressions() -> Iterator[None]:
    """Make expressions and functions of them in this block, while no other thread does; also usable as a decorator."""
    with _turn.lock:
        try:
            yield
        finally:
            _turn.unused.clear()


def _free(owner: Any, turn: _Turn = _turn) -> None:
    """Free what belongs to an expression or a function now, or when another thread has made its own.

    It does not wait: the garbage collector may call it where this thread has a lock that the other one needs. It may be called
    when the interpreter ends and this module's names are gone.
    """
    owned = vars(owner).pop("this", None)
    if owned is None:
        return
    turn.unused.append(owned)
    del owned
    if turn.lock.acquire(blocking=False):
        try:
            turn.unused.clear()
        finally:
            turn.lock.release()


for _kind in (ca.SX, ca.Function):
    _kind.__del__ = _free
