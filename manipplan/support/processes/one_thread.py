"""Linear algebra on one thread: the matrices of a plan are so small that more threads only wait for each other.

On a busy machine the waiting takes several times the time of the work. Other work of the process is limited as well meanwhile.
"""

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

_lock = threading.Lock()
#: An entry per open block of any thread: the limit for the first one, None for the others.
_open: list[Any] = []


@contextmanager
def one_thread() -> Iterator[None]:
    """Let BLAS use one thread in the block, and as many as before after the last open block; also usable as a decorator."""
    from threadpoolctl import threadpool_limits

    with _lock:
        _open.append(None if _open else threadpool_limits(limits=1, user_api="blas"))
    try:
        yield
    finally:
        with _lock:
            if len(_open) == 1:
                _open[0].restore_original_limits()
            _open.pop()
