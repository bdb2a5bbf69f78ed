"""Expands xacro files to URDF, in a process of its own: with a time limit, and without changes to this process."""

import importlib.util
import logging
import signal
import subprocess
import tempfile
from collections.abc import Mapping
from pathlib import Path

from manipplan.robots.formats.packages import PackageFolders
from manipplan.support.errors import FileFormatError, MissingExtraError, UnknownNameError
from manipplan.support.processes import commands
from manipplan.support.untrusted import printable

log = logging.getLogger("manipplan")

#: Longest time for one file [s]: of the processor, and until it ends. Large robots take less than 2 s.
PROCESSOR, TIME_LIMIT = 4, 60.0


def expand(folders: PackageFolders, arguments: Mapping[str, str], *, trust: bool) -> str:
    """The URDF that `folders.file` expands to.

    Args:
        folders: the file, and where its packages are.
        arguments: values of its `xacro:arg` elements, by name.
        trust: whether the file may run Python code and read any file and environment variable.

    Raises:
        MissingExtraError: the package xacro is not installed.
        FileFormatError: the file cannot be expanded; the message gives xacro's reason, and the files and macros concerned.
        UnknownNameError: no file has an argument of that name; the nearest names are listed.
    """
    if importlib.util.find_spec("xacro") is None:
        raise MissingExtraError("xacro", "xacro")
    file = folders.file
    request = {
        "file": str(file),
        "arguments": dict(arguments),
        "packages": {name: str(folder) for name, folder in folders.packages.items()},
        "package_dirs": [str(folder) for folder in folders.package_dirs],
        "trust": trust,
        "processor": PROCESSOR,
    }
    with tempfile.TemporaryDirectory() as folder:
        try:
            answer, run = commands.ask_module("manipplan.robots.formats.xacro_child", folder, request, limit=TIME_LIMIT)
        except subprocess.TimeoutExpired as error:
            raise _fault(file, f"it takes more than {TIME_LIMIT:g} s") from error
        except OSError as error:
            raise _fault(file, f"xacro cannot be started ({error.strerror})") from error
    if answer is None and run.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        raise _fault(file, f"it takes more than {PROCESSOR} s of the processor")
    if answer is None:
        last = (run.stderr.strip().splitlines() or ["no message"])[-1]
        raise _fault(file, f"xacro ended with code {run.returncode}: {last}")
    if "error" in answer:
        where = " > ".join(answer["where"][1:])
        raise _fault(file, answer["error"] + (f"; in {where}" if where else ""))
    if run.stderr.strip():
        log.warning("%s: xacro says: %s", file, " ".join(run.stderr[:2000].split()))
    for name in arguments:
        if name not in answer["arguments"]:
            raise UnknownNameError("arguments", name, answer["arguments"], empty="none: the file has no arguments")
    return str(answer["urdf"])


def _fault(file: Path, reason: str) -> FileFormatError:
    return FileFormatError("file", str(file), f"a xacro file that can be expanded; {printable(reason)}")
