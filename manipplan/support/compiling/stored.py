"""Machine code in the user's cache folder, each file with its checksum beside it. The folder may be deleted at any time."""

import hashlib
import shutil
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from manipplan.support.errors import CompilerError
from manipplan.support.files import cache_folder, is_private, private_folder


def cache_for(subject: str) -> Path:
    """The folder; raises CompilerError about `subject` where it cannot be used."""
    with cache_errors(cache_folder(), subject):
        return private_folder()


@contextmanager
def cache_errors(folder: Path, subject: str) -> Iterator[None]:
    """Raise errors of the file system as CompilerError."""
    try:
        yield
    except OSError as error:
        raise CompilerError(subject, f"the cache folder {folder} cannot be written ({error.strerror})") from error


@contextmanager
def place_to_build(folder: Path, subject: str) -> Iterator[Path]:
    """A temporary folder inside the cache folder; removes folders that killed builds left more than a day ago."""
    with cache_errors(folder, subject):
        for left in folder.glob("building-*"):
            with suppress(FileNotFoundError):  # another process may have removed it
                if left.stat().st_mtime < time.time() - 86400:
                    shutil.rmtree(left, ignore_errors=True)
        place = tempfile.TemporaryDirectory(prefix="building-", dir=folder)
    with place as name:
        yield Path(name)


def publish(built: Path, file: Path) -> None:
    """Move a file that was built to its place in the cache.

    Each rename is atomic. Between the two, and after two concurrent builds, the checksum may not match; then the next caller
    builds the file again.
    """
    checksum = built.with_name("checksum")
    checksum.write_text(digest(built.read_bytes(), file))
    built.chmod(0o755)  # whatever the umask: a file that a group can write is not loaded
    checksum.chmod(0o644)
    built.replace(file)
    checksum.replace(file.with_suffix(".sha256"))


def is_sound(file: Path) -> bool:
    """Whether a file exists, is complete, and cannot have been written by another user."""
    checksum = file.with_suffix(".sha256")
    try:
        if file.is_symlink() or not (is_private(file) and is_private(checksum)):
            return False
        return checksum.read_text() == digest(file.read_bytes(), file)
    except (OSError, UnicodeDecodeError):
        return False


def digest(content: bytes, file: Path) -> str:
    """Hash of a file's content and name, so that no file is mistaken for another."""
    return hashlib.sha256(file.name.encode() + content).hexdigest()
