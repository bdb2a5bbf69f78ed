"""Linear algebra on one thread: the matrices of a plan are so small that more threads only wait for each other.

On a busy machine the waiting takes several times the time of the work.
"""

from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def one_thread() -> Iterator[None]:
    """Let BLAS use one thread in the block, and as many as before after it; also usable as a decorator.

    Where BLAS has one setting for the process, the first of several threads decides, as threadpoolctl says.
    """
    from threadpoolctl import threadpool_limits

    with threadpool_limits(limits=1, user_api="blas"):
        yield
