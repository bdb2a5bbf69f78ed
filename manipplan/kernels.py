"""Numba kernels: compiled once for all that change together, and kept in the user's cache folder."""

import hashlib
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any, TypeVar

import numba

from manipplan.kinematics.compile import cache_folder

Function = TypeVar("Function", bound=Callable[..., Any])


def kernel(function: Function) -> Function:
    """Machine code that runs without Python's lock. Only modules that a computation has asked for may import this one."""
    return _compiled(function, inline="never")


def inlined(function: Function) -> Function:
    """The same, put into the kernels that call it."""
    return _compiled(function, inline="always")


def _compiled(function: Function, inline: str) -> Function:
    # numba looks for changes in a kernel's own file only, not in the files of kernels that it calls
    before, numba.config.CACHE_DIR = numba.config.CACHE_DIR, str(cache_folder() / f"numba-{_sources()}")
    try:
        made: Function = numba.njit(cache=True, nogil=True, inline=inline)(function)
    finally:
        numba.config.CACHE_DIR = before
    return made


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
