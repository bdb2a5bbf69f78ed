"""The user's cache folder, and which files in it are safe to load: another user's machine code would run as this user."""

import errno
import os
from pathlib import Path

import platformdirs


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
