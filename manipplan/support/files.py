"""Files that are written completely or not at all, files whose folder has moved, and the user's cache folder.

The files of a result in a folder, replaced as one: at no time does the folder hold files of two results.
"""

import errno
import io
import os
import shutil
import stat
import sys
import tempfile
import uuid
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import IO

import platformdirs

from manipplan.support.errors import InvalidInputError


def write_text(file: str | Path, text: str) -> None:
    """Write `text` to `file` atomically: an interrupted call leaves the previous file."""
    write_bytes(file, lambda stream: stream.write(text.encode()))


def write_bytes(file: str | Path, write: Callable[[IO[bytes]], object]) -> None:
    """Let `write` fill a temporary file beside `file`, then rename it to `file`.

    A symbolic link stays: the file that it names is replaced. A file that is replaced keeps its permissions. What is not
    a file (a pipe, a terminal, a device) is written as it is.

    Raises InvalidInputError when the folder does not exist or cannot be written, or the disk is full.
    """
    if not isinstance(file, str | Path):
        raise InvalidInputError("file", file, "the path of a file")
    path = Path(file).expanduser()
    try:
        if path.is_dir():
            raise InvalidInputError("file", str(path), "a file, not a folder")
        if path.exists() and not path.is_file():
            content = io.BytesIO()  # a pipe cannot be wound back, which some writers need
            write(content)
            path.write_bytes(content.getvalue())
        else:
            target = Path(os.path.realpath(path))
            if target.is_symlink():
                raise OSError(errno.ELOOP, os.strerror(errno.ELOOP))  # links that lead to one another
            _replace(target, write)
    except InvalidInputError:
        raise
    except (OSError, ValueError) as error:  # ValueError: a zero byte in the name
        raise InvalidInputError("file", str(path), f"a path that can be written ({_reason(error)})") from error


def _replace(path: Path, write: Callable[[IO[bytes]], object]) -> None:
    part = path.with_name(f".{path.name[:100]}.{uuid.uuid4().hex}.part")
    with part.open("xb") as stream:
        try:
            write(stream)
            if path.exists():
                part.chmod(stat.S_IMODE(path.stat().st_mode))
            stream.close()  # writes what is still in memory, before the rename
            part.replace(path)
        except BaseException:
            part.unlink()
            raise


def absolute_and_relative(path: Path, folder: Path) -> dict[str, str]:
    """`path` in the form that a file in `folder` stores: absolute, and relative to the folder."""
    whole = path.expanduser().resolve()
    return {"path": str(whole), "relative": os.path.relpath(whole, folder)}


def found_again(remembered: Mapping[str, str], folder: Path) -> Path:
    """The path that `absolute_and_relative` stored: the absolute one or, if only that exists, the one relative to `folder`."""
    whole = Path(remembered["path"])
    beside = folder / remembered["relative"]
    return beside if not whole.exists() and beside.exists() else whole


def place_for(argument: str, folder: str | Path) -> Path:
    """`folder`, which need not exist yet; raises InvalidInputError when it cannot be created and written."""
    path = Path(folder).expanduser()
    try:
        there = next(each for each in (path, *path.absolute().parents) if each.exists())
        with tempfile.TemporaryFile(dir=there):
            return path
    except OSError as error:
        raise InvalidInputError(argument, str(path), f"a folder that can be written ({_reason(error)})") from error


def writable_folder(argument: str, folder: str | Path) -> Path:
    """`folder`, created if it does not exist; raises InvalidInputError when it cannot be written."""
    if not isinstance(folder, str | Path):
        raise InvalidInputError(argument, folder, "the path of a folder")
    path = Path(folder).expanduser()
    try:
        path.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=path):
            pass
    except (OSError, ValueError) as error:
        raise InvalidInputError(argument, str(path), f"a folder that can be written ({_reason(error)})") from error
    return path


def _reason(error: Exception) -> str:
    return getattr(error, "strerror", None) or str(error)


def cache_folder() -> Path:
    """$MANIPPLAN_CACHE, or the user's cache folder."""
    return Path(os.environ.get("MANIPPLAN_CACHE") or platformdirs.user_cache_path("manipplan")).absolute()


def private_folder() -> Path:
    """The folder for this user's machine code, created if it does not exist.

    This is the cache folder or, where others can write to that one, a folder of this user inside it. Raises OSError when
    the folder cannot be created, or when others can write to it as well.
    """
    folder = cache_folder()
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    if is_private(folder):
        return folder
    own = folder / f"user-{os.geteuid()}"
    own.mkdir(mode=0o700, exist_ok=True)
    if not is_private(own):
        raise PermissionError(errno.EPERM, "another user can write to it", str(own))
    return own


def is_private(path: Path) -> bool:
    """Whether only this user or root can have written to `path`; Windows permissions are not checked."""
    if os.name != "posix":
        return True
    status = path.stat()
    return status.st_uid in (0, os.geteuid()) and not status.st_mode & 0o022


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
        new.rename(_rename(new, WRITING, WRITTEN))
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
        for part in folder.glob(f".{name}.*.part"):  # of a file that a killed process was writing
            part.unlink()
    for written in folder.glob(f"{WRITTEN}*"):
        for name in RESULT:
            for old in folder.glob(name):
                old.unlink()
        written.rename(_rename(written, WRITTEN, MOVING))
    for moving in folder.glob(f"{MOVING}*"):
        for file in moving.iterdir():
            file.replace(folder / file.name)
        moving.rmdir()


def _rename(folder: Path, old: str, new: str) -> Path:
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
