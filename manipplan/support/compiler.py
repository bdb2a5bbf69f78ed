"""Compile source code to a shared library with the machine's own compiler and keep it in the user's cache folder.

The name of a library is a hash of its source, compiler, options and, if it is built only for this processor, the processor.
It is built in a temporary folder and renamed, so several processes may build at once. Beside each file is its checksum: it is
rebuilt when that does not match, when another user could have written it, or when it cannot be loaded. The folder may be
deleted at any time.

A line of progress when something that is done once takes long.
"""

import hashlib
import logging
import os
import platform
import shlex
import shutil
import subprocess
import tempfile
import threading
import time
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from functools import cache
from pathlib import Path
from typing import TypeVar

from manipplan.support.commands import run
from manipplan.support.deadline import building
from manipplan.support.errors import CompilerError, CompilerWarning
from manipplan.support.files import cache_folder, is_private, private_folder
from manipplan.support.untrusted import terminal_text

log = logging.getLogger("manipplan")


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


#: Time after which the line is logged [s].
PATIENCE = 1.0


@contextmanager
def log_when_slow(work: str) -> Iterator[None]:
    """Log one line when the block takes longer than `PATIENCE`; `work` says what it does."""
    timer = threading.Timer(PATIENCE, log.info, args=("... %s", work))
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()


Loaded = TypeVar("Loaded")

#: Options for functions that only this machine runs. Products and sums are not fused, as in CasADi's virtual machine.
NATIVE = ("-O2", "-fno-fast-math", "-ffp-contract=off", "-march=native", "-fno-math-errno", "-fno-trapping-math")

#: Time limit of `--version` [s]: a compiler answers within milliseconds, one on a network drive within a second.
VERSION_LIMIT = 10.0

#: Time limit of one build [s]: the longest build, of Pinocchio's headers, takes two minutes, or ten on a small computer.
BUILD_LIMIT = 1200.0
#: The variables that name a compiler, and the commands that are tried without them.
VARIABLES = {"c": "CC", "c++": "CXX"}
USUAL = {"c": ("cc", "gcc", "clang"), "c++": ("c++", "g++", "clang++")}


@cache
def find_compiler(language: str = "c") -> tuple[str, ...] | None:
    """The command that $CC or $CXX names, with options, otherwise the first usual one on the PATH that runs; None for none.

    An empty $CC or $CXX means no compiler.
    """
    variable = VARIABLES[language]
    broken = []
    for command in _commands(language):
        try:
            _check_runs(command)
            return command
        except CompilerError as error:
            broken.append(error.output)
    if os.environ.get(variable):
        reason = "".join(f": {each}" for each in broken)
        problem = f"${variable} = {os.environ[variable]!r} is not a working compiler{reason}"
        warnings.warn(problem, CompilerWarning, stacklevel=2)
    elif broken:
        warnings.warn(f"no working {language.upper()} compiler was found: {'; '.join(broken)}", CompilerWarning, stacklevel=2)
    return None


def _commands(language: str) -> list[tuple[str, ...]]:
    """The commands of compilers that are on this machine, the preferred one first; whether they work is not known."""
    variable = VARIABLES[language]
    try:
        commands = [shlex.split(os.environ[variable])] if variable in os.environ else [[name] for name in USUAL[language]]
    except ValueError:
        commands = [[os.environ[variable]]]
    found = [(shutil.which(command[0]) if command else None, command) for command in commands]
    return [(path, *command[1:]) for path, command in found if path is not None]


def _check_runs(command: Sequence[str]) -> None:
    """Raise CompilerError when a compiler does not tell its version."""
    question = [*command, "--version"]
    try:
        answer = run(question, limit=VERSION_LIMIT)
    except subprocess.TimeoutExpired as error:
        raise CompilerError(command[0], f"{shlex.join(question)} did not end within {VERSION_LIMIT:g} s") from error
    except OSError as error:
        raise CompilerError(command[0], f"{shlex.join(question)} cannot be run ({error.strerror})") from error
    if answer.returncode != 0:
        raise CompilerError(command[0], f"{shlex.join(question)} failed with exit code {answer.returncode}")


def install_line(language: str = "c") -> str:
    """The command that installs a compiler, on systems with apt and on macOS."""
    package = "gcc" if language == "c" else "g++"
    return "xcode-select --install" if platform.system() == "Darwin" else f"apt install {package}"


@building()
def load_library(
    source: str,
    load: Callable[[Path], Loaded],
    *,
    flags: Sequence[str] = NATIVE,
    language: str = "c",
    subject: str,
    announce: bool = False,
) -> Loaded:
    """Build the library of `source`, or find it in the cache, and return what `load` returns for it; no time limit counts this.

    `load` takes the library's file and raises OSError, RuntimeError or AttributeError when it is unusable. The flags include
    libraries. With `announce` a progress line about the `subject` is shown on stderr during the build.

    Raises CompilerError, with the compiler's message, where there is none, it fails or hangs, or its library cannot be loaded.
    """
    folder = cache_for(subject)
    stored = load_stored(source, load, flags=flags, language=language, subject=subject)
    if stored is not None:
        return stored
    compiler = find_compiler(language)
    if compiler is None:
        raise CompilerError(subject, _why_none(language))
    for earlier in _given_up(compiler, folder):
        raise CompilerError(subject, earlier.output)
    file = folder / f"{_key(source, compiler, flags)}.so"
    with _announce(subject) if announce else log_when_slow(f"compiling {subject}"):
        _build(file, source, compiler, flags, language, subject)
    try:
        return load(file)
    except _UNLOADABLE as error:
        raise _give_up(compiler, folder, subject, f"{file} cannot be loaded: {error}") from error


def load_stored(
    source: str, load: Callable[[Path], Loaded], *, flags: Sequence[str] = NATIVE, language: str = "c", subject: str
) -> Loaded | None:
    """The same from the cache, None where it is not there; a library that is there needs no compiler that works."""
    folder = cache_for(subject)
    for command in _commands(language):
        file = folder / f"{_key(source, command, flags)}.so"
        if is_sound(file):
            try:
                return load(file)
            except _UNLOADABLE as error:
                log.debug("%s cannot be loaded and is rebuilt: %s", file, error)
    return None


#: What ctypes raises when the file or a function in it is missing, and what CasADi raises.
_UNLOADABLE = (OSError, RuntimeError, AttributeError)


def _key(source: str, command: Sequence[str], flags: Sequence[str]) -> str:
    """The name of a library in the cache, which depends on all that it is built from."""
    file = Path(command[0]).stat()
    parts = [source, *command, f"{file.st_size} {file.st_mtime_ns}", *flags]
    parts.append(_processor() if "-march=native" in flags else platform.machine())
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:32]


def _why_none(language: str) -> str:
    variable = VARIABLES[language]
    if os.environ.get(variable):
        return f"${variable} = {os.environ[variable]!r} is not a working compiler"
    return f"there is no {language.upper()} compiler; install one with: {install_line(language)}"


@cache
def _given_up(_compiler: tuple[str, ...], _folder: Path) -> list[CompilerError]:
    """Errors after which this process gives up this compiler and folder: each attempt would take as long and fail again."""
    return []


def _give_up(compiler: tuple[str, ...], folder: Path, subject: str, reason: str) -> CompilerError:
    error = CompilerError(subject, reason)
    _given_up(compiler, folder).append(error)
    return error


def _build(file: Path, source: str, compiler: tuple[str, ...], flags: Sequence[str], language: str, subject: str) -> None:
    with place_to_build(file.parent, subject) as place:
        code, library = place / f"source.{'c' if language == 'c' else 'cpp'}", place / file.name
        log.debug("compiling %s", subject)
        options = [flag for flag in flags if not (flag.startswith(("-l", "-L", "-Wl,")) or flag.endswith(".a"))]
        libraries = [flag for flag in flags if flag not in options]
        named = ["-x", language, str(code), "-x", "none"]  # so that a C++ compiler also treats C as C
        command = [*compiler, *options, "-shared", "-fPIC", *named, "-o", str(library), *libraries]
        with cache_errors(file.parent, subject):
            code.write_text(source, encoding="utf-8")
        try:
            answer = run(command, limit=BUILD_LIMIT)
        except subprocess.TimeoutExpired as error:
            reason = f"{shlex.join(command)}\ndid not end within {BUILD_LIMIT:g} s"
            raise _give_up(compiler, file.parent, subject, reason) from error
        except OSError as error:
            raise CompilerError(subject, f"{shlex.join(command)}\ncannot be run ({error.strerror})") from error
        if answer.returncode != 0 or not library.is_file():
            raise CompilerError(subject, f"{shlex.join(command)}\n{answer.stderr.strip()}")
        with cache_errors(file.parent, subject):
            publish(library, file)


@contextmanager
def _announce(subject: str) -> Iterator[None]:
    from rich.console import Console

    console, text = Console(stderr=True), terminal_text(f"compiling {subject} ...")
    if not console.is_terminal:
        console.print(text)
    with console.status(text):
        yield


@cache
def _processor() -> str:
    """The processor's description, on which -march=native depends."""
    listing = Path("/proc/cpuinfo")
    if not listing.is_file():
        return f"{platform.machine()} {platform.processor()}"
    lines = listing.read_text().splitlines()
    return "\n".join(sorted({line for line in lines if line.startswith(("model name", "flags", "Features", "CPU part"))}))
