"""A line of progress when something compiles for long."""

import logging
import threading
from collections.abc import Iterator
from contextlib import contextmanager

#: The command line shows what this log tells.
log = logging.getLogger(__name__)

#: Time after which the line is told [s].
PATIENCE = 1.0


@contextmanager
def told_when_slow(subject: str) -> Iterator[None]:
    """Log one line when the block takes longer than `PATIENCE`; `subject` names what is compiled."""
    timer = threading.Timer(PATIENCE, log.info, args=("... compiling %s", subject))
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()
