"""Numba kernels: compiled once per state of the files they depend on, and kept in the user's cache folder."""

import errno
import hashlib
import logging
import tempfile
import warnings
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any, TypeVar

import numba

from manipplan.support.cache_folder import cache_folder, is_private, private_folder
from manipplan.support.errors import CompilerWarning
from manipplan.support.import_closure import import_closure

log = logging.getLogger(__name__)
Function = TypeVar("Function", bound=Callable[..., Any])

#: Kernels of other packages are compiled in each process: the files they depend on are not known.
PACKAGE = Path(__file__).parents[1]


def kernel(function: Function) -> Function:
    """Machine code that runs without Python's lock. Only modules that are imported on demand may import this one."""
    # numba checks only a kernel's own file for changes, not the files of the kernels and constants that it uses
    file = Path(function.__code__.co_filename)
    folder = _folder(state_of(file)) if file.is_relative_to(PACKAGE) else None
    if folder is None:
        uncached: Function = numba.njit(nogil=True)(function)
        return uncached
    before, numba.config.CACHE_DIR = numba.config.CACHE_DIR, str(folder)
    try:
        made: Function = numba.njit(cache=True, nogil=True)(function)
    finally:
        numba.config.CACHE_DIR = before
    return made


@cache
def state_of(file: Path, package: Path = PACKAGE) -> str:
    """A hash of all files on which the kernels in `file` depend; `package` is the package's folder."""
    # the imports of this module determine where code is kept, not what it computes
    files = import_closure(file, package, leaves=[package / "support" / Path(__file__).name])
    digest = hashlib.sha256()
    for each in sorted(files):
        digest.update(f"{each.relative_to(package)}\0{each.stat().st_size}\0".encode())
        digest.update(each.read_bytes())
    return digest.hexdigest()[:16]


@cache
def _folder(state: str) -> Path | None:
    """The folder for machine code; None, with a CompilerWarning, when none can be written."""
    folder = cache_folder()
    try:
        folder = private_folder() / f"numba-{state}"
        new = not folder.exists()
        folder.mkdir(mode=0o700, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            pass
        if not is_private(folder):
            raise PermissionError(errno.EPERM, "another user can write to it")
    except OSError as error:
        _warn_once(f"{folder} cannot be written ({error.strerror}): each process compiles the kernels again")
        return None
    if new:
        _tell_once("... compiling kernels, once per version of manipplan: up to half a minute")
    return folder


@cache
def _warn_once(told: str) -> None:
    warnings.warn(told, CompilerWarning, stacklevel=4)


@cache
def _tell_once(told: str) -> None:
    log.info(told)
