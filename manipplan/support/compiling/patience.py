"""A line of progress when something that is done once takes long."""

import logging
import threading
from collections.abc import Iterator
from contextlib import contextmanager

#: The command line shows this log.
log = logging.getLogger(__name__)

#: Time after which the line is logged [s].
PATIENCE = 1.0


@contextmanager
def logged_when_slow(work: str) -> Iterator[None]:
    """Log one line when the block takes longer than `PATIENCE`; `work` says what it does."""
    timer = threading.Timer(PATIENCE, log.info, args=("... %s", work))
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()
