"""Run a program, or a module of this package, with limits, and stop it together with all processes that it has started."""

import json
import os
import signal
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

#: An empty package `manipplan`, because the whole one takes a second to import; then the module's `main`.
_START = """
import importlib, sys, types
package = types.ModuleType("manipplan")
package.__path__ = [sys.argv[1]]
sys.modules["manipplan"] = package
importlib.import_module(sys.argv[2]).main(sys.argv[3])
"""

#: Files with the request to a module, and with its answer.
_REQUEST, _ANSWER = "request.json", "answer.json"


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


def run_module(module: str, folder: str | Path, *, limit: float) -> subprocess.CompletedProcess[str]:
    """Run `main(folder)` of a module in a Python process of its own, as `run` does.

    The module and what it imports need nothing but the standard library, until `main` sets `sys.path`.
    """
    package = str(Path(__file__).parents[1])
    return run([sys.executable, "-I", "-S", "-X", "utf8", "-c", _START, package, module, str(folder)], limit=limit)


class NoAnswerError(Exception):
    """A module gave no answer; the text says why."""


def ask_module(
    module: str, folder: str | Path, request: Mapping[str, Any], *, limit: float, program: str
) -> tuple[dict[str, Any], str]:
    """Run a module as `run_module` does, with a request that its `main` gets by `request_in`, both in an empty `folder`.

    Returns the answer that it gives by `write_answer`, and what it wrote on standard error. Raises NoAnswerError, which calls
    the process `program`.
    """
    path = [each if each else str(Path.cwd()) for each in sys.path]
    Path(folder, _REQUEST).write_text(json.dumps({**request, "path": path}), encoding="utf-8")
    try:
        run = run_module(module, folder, limit=limit)
    except subprocess.TimeoutExpired as error:
        raise NoAnswerError(f"it takes more than {limit:g} s") from error
    except OSError as error:
        raise NoAnswerError(f"{program} cannot be started ({error.strerror})") from error
    try:
        return json.loads(Path(folder, _ANSWER).read_text(encoding="utf-8")), run.stderr
    except (OSError, ValueError) as error:
        last = (run.stderr.strip().splitlines() or ["no message"])[-1]
        reason = f"{program} ended with code {run.returncode}: {last}"
        if run.returncode < 0:
            name = signal.Signals(-run.returncode).name
            reason = f"{program} ended by {name}"
            if name == "SIGKILL":
                reason += ", as the system does where memory is short"
            if name == "SIGXCPU" and "processor" in request:
                seconds = f"{request['processor']} s of the processor"
                reason = f"it takes {program} more than {seconds}, as a file that repeats itself without end does"
        raise NoAnswerError(reason) from error


def request_in(folder: str) -> dict[str, Any]:
    """The request for this process, which from now on finds modules where the one that asks does."""
    request: dict[str, Any] = json.loads(Path(folder, _REQUEST).read_text(encoding="utf-8"))
    sys.path[:] = request["path"]
    return request


def write_answer(folder: str, answer: Mapping[str, Any]) -> None:
    """Answer the request in `folder`."""
    Path(folder, _ANSWER).write_text(json.dumps(answer), encoding="utf-8")


def set_limits(*, memory: int, written: int, processor: int | None = None) -> None:
    """Limit this process's memory and the size of the files it writes [bytes], and its processor time [s]."""
    import resource

    limits = [(resource.RLIMIT_AS, memory), (resource.RLIMIT_FSIZE, written)]
    limits += [(resource.RLIMIT_CPU, processor)] if processor is not None else []
    for kind, most in limits:
        soft, hard = resource.getrlimit(kind)
        with suppress(OSError, ValueError):  # macOS does not limit memory
            resource.setrlimit(kind, (most if soft == resource.RLIM_INFINITY else min(most, soft), hard))


def _kill_group(process: subprocess.Popen[bytes]) -> None:
    if os.name == "posix":
        with suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
    else:
        process.kill()
    process.wait()
