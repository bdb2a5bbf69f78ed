"""Linear algebra on one thread: the matrices of a plan are so small that more threads only wait for each other.

On a busy machine the waiting takes several times the time of the work.
"""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from functools import lru_cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from threadpoolctl import ThreadpoolController


@contextmanager
def one_thread() -> Iterator[None]:
    """Let BLAS use one thread in the block, and as many as before after it; also usable as a decorator.

    Where BLAS has one setting for the process, the first of several threads decides, as threadpoolctl says.
    """
    with _libraries(len(sys.modules)).limit(limits=1, user_api="blas"):
        yield


@lru_cache(maxsize=1)
def _libraries(_modules: int) -> "ThreadpoolController":
    """The libraries of the process, which are searched for again when more modules have been imported: it takes 2 ms."""
    from threadpoolctl import ThreadpoolController

    return ThreadpoolController()
