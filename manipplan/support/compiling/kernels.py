"""Numba kernels: compiled once per state of the files they depend on, and kept in the user's cache folder."""

import ast
import errno
import hashlib
import logging
import tempfile
import warnings
from collections.abc import Callable, Collection, Iterable, Iterator
from functools import cache
from pathlib import Path
from typing import Any, TypeVar

import numba

from manipplan.support.errors import CompilerWarning
from manipplan.support.files import cache_folder, is_private, private_folder

log = logging.getLogger(__name__)
Function = TypeVar("Function", bound=Callable[..., Any])

#: Kernels of other packages are compiled in each process: the files they depend on are not known.
PACKAGE = Path(__file__).parents[2]


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
    files = import_closure(file, package, leaves=[package / "support" / "compiling" / Path(__file__).name])
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


def import_closure(file: Path, root: Path, *, leaves: Collection[Path] = ()) -> frozenset[Path]:
    """`file` and all files of the package in folder `root` that are needed to import it.

    Imports inside functions or only for type checkers do not count: they set no value of the module. `leaves` belong to the
    closure, but their imports do not.
    """
    found: set[Path] = set()
    waiting = [file]
    while waiting:
        each = waiting.pop()
        if each not in found:
            found.add(each)
            if each not in leaves:
                waiting += _imported(each, root)
    return frozenset(found)


def _imported(file: Path, root: Path) -> list[Path]:
    """The files of the package that `file` itself imports."""
    package = [root.name, *file.parent.relative_to(root).parts]
    names: list[list[str]] = []
    for statement in _at_import(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(statement, ast.Import):
            names += [each.name.split(".") for each in statement.names]
        elif isinstance(statement, ast.ImportFrom):
            above = package[: len(package) + 1 - statement.level] if statement.level else []
            module = [*above, *(statement.module.split(".") if statement.module else ())]
            names += [module, *([*module, each.name] for each in statement.names)]
    files = [_file_of(name, root) for name in names]
    return [each for each in files if each is not None]


def _at_import(node: ast.AST) -> Iterator[ast.AST]:
    """All nodes below `node` that run while the module is imported."""
    children: Iterable[ast.AST] = ast.iter_child_nodes(node)
    if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda):
        children = ()
    elif isinstance(node, ast.If) and ast.unparse(node.test) in ("TYPE_CHECKING", "typing.TYPE_CHECKING"):
        children = node.orelse
    for child in children:
        yield child
        yield from _at_import(child)


def _file_of(name: list[str], root: Path) -> Path | None:
    """The file of a module or package of the package `root`; None for anything else."""
    if name[0] != root.name:
        return None
    place = root.joinpath(*name[1:])
    return next((each for each in (place.with_suffix(".py"), place / "__init__.py") if each.is_file()), None)
