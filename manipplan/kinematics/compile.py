"""Source code to a shared library by the machine's own compiler, kept in the user's cache folder.

A library is named by a hash of all that it is made of: source, compiler, options and, where it is built for this processor
alone, the processor. It is built in a temporary folder and renamed, so several processes may build at once; a checksum
beside it is read before it is loaded, and one that does not fit is built again. The folder may be deleted at any time.
"""

import ctypes
import hashlib
import logging
import os
import platform
import shlex
import shutil
import subprocess
import tempfile
import time
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, nullcontext, suppress
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import casadi as ca
import platformdirs

from manipplan.errors import CompilerError, CompilerWarning

log = logging.getLogger("manipplan")

#: For functions that only this machine runs.
NATIVE = ("-O2", "-fno-fast-math", "-march=native", "-fno-math-errno", "-fno-trapping-math")

#: From so many characters on, -O1 is chosen: it compiles three times faster for code that runs a tenth slower.
LONG = 200_000

#: Functions of so many instructions are compiled in a few seconds; a user who did not ask for it waits no longer.
SOON_DONE = 60_000


@dataclass(frozen=True, kw_only=True)
class Compiler:
    """A C or C++ compiler: the command that calls it and the first line of what it says about its version."""

    command: tuple[str, ...]
    version: str


@cache
def find_compiler(language: str = "c") -> Compiler | None:
    """The compiler that $CC or $CXX names, with options, otherwise the first of the usual ones on the PATH; None without.

    An empty $CC or $CXX means none.
    """
    variable, usual = {"c": ("CC", ("cc", "gcc", "clang")), "c++": ("CXX", ("c++", "g++", "clang++"))}[language]
    try:
        commands = [shlex.split(os.environ[variable])] if variable in os.environ else [[name] for name in usual]
    except ValueError:
        commands = [[os.environ[variable]]]
    for command in commands:
        path = shutil.which(command[0]) if command else None
        version = _version((path, *command[1:])) if path is not None else None
        if path is not None and version is not None:
            return Compiler(command=(path, *command[1:]), version=version)
    if os.environ.get(variable):
        warnings.warn(f"${variable} = {os.environ[variable]!r} is not a compiler that runs", CompilerWarning, stacklevel=2)
    return None


def _version(command: tuple[str, ...]) -> str | None:
    """The first line of what a compiler says about itself; None for what does not run."""
    try:
        answer = _run([*command, "--version"])
    except OSError:
        return None
    return answer.stdout.partition("\n")[0] if answer.returncode == 0 else None


def _run(command: Sequence[str]) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command, capture_output=True, text=True, errors="replace", check=False)


def install_line(language: str = "c") -> str:
    """How to get a compiler on systems with apt, and on macOS."""
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
    parts = [source, *compiler.command, compiler.version, *flags]
    parts.append(_processor() if "-march=native" in flags else platform.machine())
    key = hashlib.sha256("\0".join(parts).encode()).hexdigest()[:32]
    file = cache_folder() / f"{key}.so"
    if not _sound(file):
        with _announced(subject) if announce else nullcontext():
            _build(file, source, compiler, flags, language, subject)
    return file


def native_flags(source: str) -> tuple[str, ...]:
    """Options for code that only this machine runs, by its length."""
    return NATIVE if len(source) < LONG else ("-O1", *NATIVE[1:])


def compiled(function: ca.Function, subject: str) -> ca.Function:
    """The same function as machine code; raises CompilerError as `shared_library`, or when it cannot be loaded."""
    return compiled_together([function], subject)[0]


def compiled_together(functions: Sequence[ca.Function], subject: str) -> tuple[ca.Function, ...]:
    """Several functions as one library of machine code; raises as `compiled`."""
    generator = ca.CodeGenerator(functions[0].name(), {"casadi_real": "double"})
    for function in functions:
        generator.add(function)
    source = generator.dump()
    file = shared_library(source, flags=(*native_flags(source), "-lm"), subject=subject)
    try:
        return tuple(ca.external(function.name(), str(file)) for function in functions)
    except RuntimeError as error:
        raise CompilerError(subject, f"{file} cannot be loaded: {error}") from error


def loaded(file: Path, subject: str) -> ctypes.CDLL:
    """A library of our own; raises CompilerError when it cannot be loaded."""
    try:
        return ctypes.CDLL(str(file))
    except OSError as error:
        raise CompilerError(subject, f"it cannot be loaded: {error}") from error


def _build(file: Path, source: str, compiler: Compiler, flags: Sequence[str], language: str, subject: str) -> None:
    with _place_to_build(file.parent, subject) as place:
        code, library = place / f"source.{'c' if language == 'c' else 'cpp'}", place / file.name
        log.debug("compiling %s", subject)
        options = [flag for flag in flags if not (flag.startswith(("-l", "-L", "-Wl,")) or flag.endswith(".a"))]
        libraries = [flag for flag in flags if flag not in options]
        named = ["-x", language, str(code), "-x", "none"]  # a C++ compiler takes C for C, too
        command = [*compiler.command, *options, "-shared", "-fPIC", *named, "-o", str(library), *libraries]
        with _cache_errors(file.parent, subject):
            code.write_text(source, encoding="utf-8")
        answer = _run(command)
        if answer.returncode != 0 or not library.is_file():
            raise CompilerError(subject, f"{' '.join(command)}\n{answer.stderr.strip()}")
        checksum = place / "checksum"
        # Each rename is one step. Between the two, and after two builds that crossed, the checksum does not fit, and the
        # next one who asks builds again.
        with _cache_errors(file.parent, subject):
            checksum.write_text(_digest(library))
            library.replace(file)
            checksum.replace(file.with_suffix(".sha256"))


@contextmanager
def _cache_errors(folder: Path, subject: str) -> Iterator[None]:
    """What the file system refuses, as a CompilerError."""
    try:
        yield
    except OSError as error:
        raise CompilerError(subject, f"the cache folder {folder} cannot be written ({error.strerror})") from error


@contextmanager
def _place_to_build(folder: Path, subject: str) -> Iterator[Path]:
    """A temporary folder inside the cache folder; removes those that killed builds left there more than a day ago."""
    with _cache_errors(folder, subject):
        folder.mkdir(parents=True, exist_ok=True)
        for left in folder.glob("building-*"):
            with suppress(FileNotFoundError):  # another process may have removed it
                if left.stat().st_mtime < time.time() - 86400:
                    shutil.rmtree(left, ignore_errors=True)
        place = tempfile.TemporaryDirectory(prefix="building-", dir=folder)
    with place as name:
        yield Path(name)


@contextmanager
def _announced(subject: str) -> Iterator[None]:
    from rich.console import Console

    console = Console(stderr=True)
    if not console.is_terminal:
        console.print(f"compiling {subject} ...")
    with console.status(f"compiling {subject} ..."):
        yield


def _sound(file: Path) -> bool:
    try:
        return file.with_suffix(".sha256").read_text() == _digest(file)
    except (OSError, UnicodeDecodeError):
        return False


def _digest(file: Path) -> str:
    return hashlib.sha256(file.read_bytes()).hexdigest()


def wants_machine_code(compiled: bool | str) -> bool:
    """Whether the option `compiled` (True, False or "auto") asks for a compiler on this machine."""
    return compiled is True or (compiled == "auto" and find_compiler() is not None)


def as_asked(functions: Sequence[ca.Function], compiled: bool | str, subject: str) -> tuple[ca.Function, ...]:
    """The functions as machine code where `compiled` (True, False or "auto") asks for it, else as they are.

    "auto" leaves those of more than SOON_DONE instructions as they are. Raises CompilerError when `compiled` is True and
    there is no compiler, or it fails.
    """
    soon = sum(function.n_instructions() for function in functions) <= SOON_DONE
    if compiled is True or (soon and wants_machine_code(compiled)):
        try:
            return compiled_together(functions, subject)
        except CompilerError as error:
            do_without(error, compiled)
    return tuple(functions)


def do_without(error: CompilerError, compiled: bool | str) -> None:
    """Go on in CasADi's virtual machine, with a CompilerWarning the first time; raises `error` when compiled is True."""
    if compiled is True:
        raise error
    if first_failure():
        warnings.warn(f"CasADi's virtual machine is used instead: {error}", CompilerWarning, stacklevel=6)


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
