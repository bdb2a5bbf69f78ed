"""Run a program with a time limit, and stop it together with all processes that it has started."""

import os
import signal
import subprocess
import tempfile
from collections.abc import Sequence
from contextlib import suppress


def run(command: Sequence[str], *, limit: float) -> subprocess.CompletedProcess[str]:
    """Run `command` without a shell and return its exit code and output.

    Raises OSError when it cannot be started and subprocess.TimeoutExpired when it takes longer than `limit` [s]. On a
    timeout or an interrupt it is killed together with its children.
    """
    # files, not pipes: a child that outlives the command would keep a pipe open
    with tempfile.TemporaryFile() as output, tempfile.TemporaryFile() as errors:
        group = 0 if os.name == "posix" else None
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=output, stderr=errors, process_group=group)
        try:
            code = process.wait(limit)
        except BaseException:
            _kill_group(process)
            raise
        texts = []
        for stream in (output, errors):
            stream.seek(0)
            texts.append(stream.read().decode(errors="replace"))
    return subprocess.CompletedProcess(command, code, *texts)


def _kill_group(process: subprocess.Popen[bytes]) -> None:
    if os.name == "posix":
        with suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
    else:
        process.kill()
    process.wait()
