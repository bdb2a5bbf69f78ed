"""Source code to a shared library by the machine's own compiler, kept in the user's cache folder.

A library's folder is named by a hash of all that it is made of: source, compiler, options and, where it is built for this
processor alone, the processor. It is built in a temporary folder and renamed, so several processes may build at once; a
checksum beside it is read before it is loaded, and one that does not fit is built again.
"""

import hashlib
import logging
import os
import platform
import shutil
import subprocess
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import casadi as ca
import platformdirs

from manipplan.errors import CompilerError

log = logging.getLogger("manipplan")

LIBRARY = "library.so"
CHECKSUM = "library.sha256"

#: For functions that only this machine runs.
NATIVE = ("-O2", "-march=native", "-fno-math-errno", "-fno-trapping-math")


@dataclass(frozen=True, kw_only=True)
class Compiler:
    """A C or C++ compiler: its path and the first line of what it says about its version."""

    path: str
    version: str


@cache
def find_compiler(language: str = "c") -> Compiler | None:
    """The compiler that $CC or $CXX names, otherwise the first of the usual ones on the PATH; None without one.

    An empty $CC or $CXX means none.
    """
    variable, usual = {"c": ("CC", ("cc", "gcc", "clang")), "c++": ("CXX", ("c++", "g++", "clang++"))}[language]
    names = [os.environ[variable]] if variable in os.environ else usual
    for path in filter(None, (shutil.which(name) for name in names if name)):
        answer = subprocess.run([path, "--version"], capture_output=True, text=True, check=False)
        if answer.returncode == 0:
            return Compiler(path=path, version=answer.stdout.partition("\n")[0])
    return None


def install_line(language: str = "c") -> str:
    """How to get a compiler on this machine."""
    package = "gcc" if language == "c" else "g++"
    return "xcode-select --install" if platform.system() == "Darwin" else f"apt install {package}"


def cache_folder() -> Path:
    """Where libraries are kept: $MANIPPLAN_CACHE, or the user's cache folder."""
    return Path(os.environ.get("MANIPPLAN_CACHE") or platformdirs.user_cache_path("manipplan"))


def shared_library(
    source: str, *, flags: Sequence[str] = NATIVE, language: str = "c", subject: str, announce: bool = False
) -> Path:
    """The library of `source`, from the cache or built now.

    Args:
        source: one file of C or C++.
        flags: options of the compiler, libraries included.
        language: "c" or "c++".
        subject: what is built, for messages.
        announce: show a line of progress on stderr while it is built.

    Raises:
        CompilerError: there is no compiler, or it fails; its message is kept.
    """
    compiler = find_compiler(language)
    if compiler is None:
        raise CompilerError(subject, f"there is no {language.upper()} compiler; install one with: {install_line(language)}")
    parts = [source, compiler.path, compiler.version, *flags, _processor() if "-march=native" in flags else platform.machine()]
    folder = cache_folder() / hashlib.sha256("\0".join(parts).encode()).hexdigest()[:32]
    if not _sound(folder):
        try:
            with _announced(subject) if announce else nullcontext():
                _build(folder, source, compiler, flags, language, subject)
        except OSError as error:
            raise CompilerError(subject, f"the cache folder {cache_folder()} cannot be written ({error.strerror})") from error
    return folder / LIBRARY


def compiled(function: ca.Function, subject: str) -> ca.Function:
    """The same function as machine code; raises CompilerError as `shared_library`."""
    generator = ca.CodeGenerator(function.name(), {"casadi_real": "double"})
    generator.add(function)
    return ca.external(function.name(), str(shared_library(generator.dump(), flags=(*NATIVE, "-lm"), subject=subject)))


def _build(folder: Path, source: str, compiler: Compiler, flags: Sequence[str], language: str, subject: str) -> None:
    folder.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="building-", dir=folder.parent) as name:
        place = Path(name) / "made"
        place.mkdir()
        code = place / f"source.{'c' if language == 'c' else 'cpp'}"
        code.write_text(source)
        log.debug("compiling %s", subject)
        options = [flag for flag in flags if not flag.startswith(("-l", "-L", "-Wl,"))]
        libraries = [flag for flag in flags if flag not in options]
        command = [compiler.path, *options, "-shared", "-fPIC", str(code), "-o", str(place / LIBRARY), *libraries]
        answer = subprocess.run(command, capture_output=True, text=True, check=False)
        if answer.returncode != 0:
            raise CompilerError(subject, f"{' '.join(command)}\n{answer.stderr.strip()}")
        (place / CHECKSUM).write_text(_digest(place / LIBRARY))
        _put(place, folder)


@contextmanager
def _announced(subject: str) -> Iterator[None]:
    from rich.console import Console

    console = Console(stderr=True)
    if not console.is_terminal:
        console.print(f"compiling {subject} ...")
    with console.status(f"compiling {subject} ..."):
        yield


def _put(made: Path, folder: Path) -> None:
    """Rename `made` to `folder`; one that another process put there meanwhile stays, one that is damaged goes."""
    try:
        made.rename(folder)
    except OSError:
        if _sound(folder):
            return
        damaged = made.with_name("damaged")
        folder.rename(damaged)
        made.rename(folder)


def _sound(folder: Path) -> bool:
    try:
        return (folder / CHECKSUM).read_text() == _digest(folder / LIBRARY)
    except (OSError, UnicodeDecodeError):
        return False


def _digest(file: Path) -> str:
    return hashlib.sha256(file.read_bytes()).hexdigest()


def first_failure() -> bool:
    """Whether this is asked for the first time with this compiler and cache folder, so that a failure is told once."""
    return next(_once(find_compiler(), cache_folder()), False)


@cache
def _once(*_: object) -> Iterator[bool]:
    return iter((True,))


@cache
def _processor() -> str:
    """What -march=native depends on."""
    listing = Path("/proc/cpuinfo")
    if not listing.is_file():
        return f"{platform.machine()} {platform.processor()}"
    lines = listing.read_text().splitlines()
    return "\n".join(sorted({line for line in lines if line.startswith(("model name", "flags", "Features", "CPU part"))}))
