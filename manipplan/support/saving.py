"""The files of a result in a folder, replaced as one: at no time does the folder hold files of two results."""

import os
import shutil
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from manipplan.support.errors import InvalidInputError
from manipplan.support.files import writable_folder

if sys.platform != "win32":
    import fcntl

#: Hidden folders of new files: still written; all there, while the old files are removed; moved in, when these are gone.
WRITING, WRITTEN, MOVING = ".manipplan-writing-", ".manipplan-written-", ".manipplan-moving-"
#: Files of a plan or a program.
RESULT = (
    *("trajectory.csv", "trajectory.json", "trajectory.yaml", "report.json", "report.txt", "plan.png", "plan.json"),
    *("marks.csv", "program.png", "program.json", "part_*.json"),
)


@contextmanager
def replacing(folder: str | Path) -> Iterator[tuple[Path, Path]]:
    """The folder, created if it does not exist, and a new one in it, whose files then replace the result of the folder.

    A process that is killed leaves the old files or the new ones or, for about a millisecond, some of one kind: the next call
    of this or of `finish` puts the others in place. Other processes wait meanwhile. Files that belong to no result stay. If the
    block raises, the old files stay.

    Raises InvalidInputError when the folder cannot be written.
    """
    to = writable_folder("folder", folder)
    with _errors(to), _locked(to):
        _finish(to)
        new = Path(tempfile.mkdtemp(prefix=WRITING, dir=to))
        try:
            yield to, new
        except BaseException:
            shutil.rmtree(new, ignore_errors=True)
            raise
        new.rename(_renamed(new, WRITING, WRITTEN))
        _finish(to)


def finish(folder: Path) -> None:
    """Put in place the files that a killed process had written, but not all put in place.

    Raises InvalidInputError when that is needed, and the folder cannot be written.
    """
    if any(left for each in (WRITTEN, MOVING) for left in folder.glob(f"{each}*")):
        with _errors(folder), _locked(folder):
            _finish(folder)


def _finish(folder: Path) -> None:
    for left in folder.glob(f"{WRITING}*"):
        shutil.rmtree(left)
    for name in RESULT:
        for part in folder.glob(f".{name}.*.part"):  # of version 0.1
            part.unlink()
    for written in folder.glob(f"{WRITTEN}*"):
        for name in RESULT:
            for old in folder.glob(name):
                old.unlink()
        written.rename(_renamed(written, WRITTEN, MOVING))
    for moving in folder.glob(f"{MOVING}*"):
        for file in moving.iterdir():
            file.replace(folder / file.name)
        moving.rmdir()


def _renamed(folder: Path, old: str, new: str) -> Path:
    return folder.with_name(new + folder.name.removeprefix(old))


@contextmanager
def _errors(folder: Path) -> Iterator[None]:
    """Raise errors of the file system as InvalidInputError."""
    try:
        yield
    except OSError as error:
        raise InvalidInputError("folder", str(folder), f"a folder that can be written ({error.strerror or error})") from error


@contextmanager
def _locked(folder: Path) -> Iterator[None]:
    """One process or thread at a time, where the system has locks for folders."""
    if sys.platform == "win32":
        yield
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        fcntl.flock(handle, fcntl.LOCK_EX)
        yield
    finally:
        os.close(handle)
