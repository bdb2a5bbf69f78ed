"""Numba kernels: compiled once for all that change together, and kept in the user's cache folder."""

import hashlib
import tempfile
import warnings
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any, TypeVar

import numba

from manipplan.errors import CompilerWarning
from manipplan.kinematics.compile import cache_folder

Function = TypeVar("Function", bound=Callable[..., Any])


def kernel(function: Function) -> Function:
    """Machine code that runs without Python's lock. Only modules that a computation has asked for may import this one."""
    # numba looks for changes in a kernel's own file only, not in the files of kernels that it calls
    folder = _folder()
    before, numba.config.CACHE_DIR = numba.config.CACHE_DIR, str(folder)
    try:
        made: Function = numba.njit(cache=folder is not None, nogil=True)(function)
    finally:
        numba.config.CACHE_DIR = before
    return made


@cache
def _folder() -> Path | None:
    """Where machine code is kept; None, with a CompilerWarning, where nothing can be."""
    folder = cache_folder() / f"numba-{_sources()}"
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            return folder
    except OSError as error:
        told = f"{folder} cannot be written ({error.strerror}): kernels are compiled in each process again"
        warnings.warn(told, CompilerWarning, stacklevel=2)
        return None


@cache
def _sources() -> str:
    """A name for the state of all source files that hold kernels."""
    root = Path(__file__).parent
    digest = hashlib.sha256()
    for file in sorted(root.rglob("*.py")):
        text = file.read_bytes()
        if b"manipplan.kernels" in text:
            digest.update(text)
    return digest.hexdigest()[:16]
