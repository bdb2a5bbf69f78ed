"""Numba kernels: compiled once for each state of the package, and kept in the user's cache folder."""

import hashlib
import logging
import tempfile
import warnings
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any, TypeVar

import numba

from manipplan.errors import CompilerWarning
from manipplan.kinematics.compile import cache_folder

log = logging.getLogger(__name__)
Function = TypeVar("Function", bound=Callable[..., Any])


def kernel(function: Function) -> Function:
    """Machine code that runs without Python's lock. Only modules that a computation has asked for may import this one."""
    # numba looks for changes in a kernel's own file only, not in the files of kernels that it calls
    folder = _folder()
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
def _folder() -> Path | None:
    """Where machine code is kept; None, with a CompilerWarning, where nothing can be."""
    folder = cache_folder() / f"numba-{_sources()}"
    try:
        if not folder.exists():
            log.info("... compiling kernels, once for this version of manipplan: about half a minute")
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            return folder
    except OSError as error:
        told = f"{folder} cannot be written ({error.strerror}): kernels are compiled in each process again"
        warnings.warn(told, CompilerWarning, stacklevel=2)
        return None


@cache
def _sources() -> str:
    """A name for the state of the package: kernels hold constants of files without kernels, too."""
    digest = hashlib.sha256()
    for file in sorted(Path(__file__).parent.rglob("*.py")):
        digest.update(file.read_bytes())
    return digest.hexdigest()[:16]
