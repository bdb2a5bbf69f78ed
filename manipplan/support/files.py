"""Files that are written completely or not at all, files whose folder has moved, and the user's cache folder."""

import errno
import os
import tempfile
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import IO

import platformdirs

from manipplan.support.errors import InvalidInputError


def write_text(file: str | Path, text: str) -> None:
    """Write `text` to `file` atomically: an interrupted call leaves the previous file."""
    write_bytes(file, lambda stream: stream.write(text.encode()))


def write_bytes(file: str | Path, write: Callable[[IO[bytes]], object]) -> None:
    """Let `write` fill a temporary file beside `file`, then rename it to `file`.

    Raises InvalidInputError when the folder does not exist or cannot be written, or the disk is full.
    """
    if not isinstance(file, str | Path):
        raise InvalidInputError("file", file, "the path of a file")
    path = Path(file).expanduser()
    try:
        if path.is_dir():
            raise InvalidInputError("file", str(path), "a file, not a folder")
        handle, name = tempfile.mkstemp(prefix=f".{path.name}.", suffix=".part", dir=path.parent)
    except InvalidInputError:
        raise
    except (OSError, ValueError) as error:  # ValueError: a zero byte in the name
        raise InvalidInputError("file", str(path), f"a path that can be written ({_reason(error)})") from error
    part = Path(name)
    try:
        with os.fdopen(handle, "wb") as stream:
            write(stream)
        part.chmod(0o644)
        part.replace(path)
    except BaseException as error:
        part.unlink()
        if isinstance(error, OSError):  # a full disk
            raise InvalidInputError("file", str(path), f"a path that can be written ({_reason(error)})") from error
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
