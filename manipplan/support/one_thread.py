"""Linear algebra on one thread: the matrices of a plan are so small that more threads only wait for each other.

On a busy machine the waiting takes several times the time of the work. Other work of the process is limited as well meanwhile.
"""

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

_lock = threading.Lock()
#: One limit, that of the outermost block of all threads, and the number of blocks that are open.
_held: list[Any] = []
_open = 0


@contextmanager
def one_thread() -> Iterator[None]:
    """Let BLAS use one thread in the block, and as many as before after the last open block; also usable as a decorator."""
    global _open
    from threadpoolctl import threadpool_limits

    with _lock:
        if not _open:
            _held.append(threadpool_limits(limits=1, user_api="blas"))
        _open += 1
    try:
        yield
    finally:
        with _lock:
            _open -= 1
            if not _open:
                _held.pop().restore_original_limits()
