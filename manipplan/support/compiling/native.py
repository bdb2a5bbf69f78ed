"""Machine code of our own C sources: by the C compiler, or by LLVM from the same source in its language."""

import ctypes
import logging
import lzma
import os
import re
import threading
from collections import defaultdict
from collections.abc import Callable, Collection
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from manipplan.support.compiling.compiler import NATIVE, compile_by_llvm, find_compiler, load_library, log_when_slow
from manipplan.support.compiling.declarations import PREFIX, signatures, source_text
from manipplan.support.deadline import building
from manipplan.support.errors import CompilerError

log = logging.getLogger("manipplan")


@dataclass(frozen=True, kw_only=True, eq=False)
class NativeCode:
    """Compiled functions.

    Attributes:
        address: the address of a function by its name.
        owner: what keeps their code alive.
        source: the C file.
    """

    address: Callable[[str], int]
    owner: object
    source: Path

    def functions(self, *, quick: Collection[str] = ()) -> dict[str, Callable[..., Any]]:
        """The functions of the source, by their names without prefix.

        They release the GIL, but for the `quick` ones: to release it would take longer than what these do.
        """
        return {
            name: (ctypes.PYFUNCTYPE if name in quick else ctypes.CFUNCTYPE)(*types)(self.address(PREFIX + name))
            for name, types in signatures(self.source).items()
        }


PACKAGE = Path(__file__).parents[2]
#: All sources in LLVM's language, which `make kernel` writes: of each a line with its name and hash, and its text.
LLVM_TEXTS = PACKAGE / "kernels.ll.xz"

#: The code of each source, None where it cannot be compiled, and locks of the sources that a thread is looking after.
_found: dict[Path, NativeCode | None] = {}
_locks: defaultdict[Path, threading.Lock] = defaultdict(threading.Lock)
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_locks.clear)  # the threads that hold them stay behind


def native_code(source: Path, subject: str) -> NativeCode | None:
    """The functions of a C source, for this process; None, with a message in the log, where it cannot be compiled.

    Without a C compiler, LLVM compiles its text in `LLVM_TEXTS`.

    Args:
        source: the C file.
        subject: what it does, for messages.
    """
    if source not in _found:
        with building(), _locks[source]:  # a second thread waits for the first one's build
            if source not in _found:
                _found[source] = _compile(source, subject)
    return _found[source]


def _compile(source: Path, subject: str) -> NativeCode | None:
    flags = [flag for flag in NATIVE if flag != "-O2"] + ["-O3", "-lm"]
    try:
        return load_library(
            source_text(source), lambda file: _load(file, source), flags=flags, subject=f"{subject}, once per machine"
        )
    except CompilerError as error:
        log.info("%s: compiled by LLVM in each process: %s", subject, error)
    try:
        with log_when_slow(f"compiling {subject}, by LLVM in each process"):
            return llvm_code(source)
    except RuntimeError as error:
        log.warning("%s: cannot be compiled, so slower code is used: %s", subject, error)
        return None


def llvm_code(source: Path) -> NativeCode:
    """The functions of a C source of this package as LLVM compiles them; raises RuntimeError where it cannot."""
    engine = compile_by_llvm(llvm_texts()[source.relative_to(PACKAGE).as_posix()][1])
    return NativeCode(address=engine.get_function_address, owner=engine, source=source)


@cache
def llvm_texts() -> dict[str, tuple[str, str]]:
    """The hash and the text of each source in LLVM's language, by its path in the package."""
    _, *parts = re.split(r"^; (\S+) (\w{64})\n", lzma.decompress(LLVM_TEXTS.read_bytes()).decode(), flags=re.MULTILINE)
    return {name: (digest, text) for name, digest, text in zip(parts[::3], parts[1::3], parts[2::3], strict=True)}


def compile_ahead(*sources: str) -> None:
    """Start to compile C sources of this package, such as "paths/curves.c", in the background, one after the other.

    Whoever needs one of them earlier waits for it; the end of the process does not. Without a C compiler nothing is done ahead.
    """
    waiting = [PACKAGE / source for source in sources if PACKAGE / source not in _found]
    if not waiting or find_compiler() is None:
        return

    def compile_all() -> None:
        for source in waiting:
            native_code(source, source.name)

    threading.Thread(target=compile_all, name="compile", daemon=True).start()


def require_code(source: Path, subject: str) -> NativeCode:
    """The same for a source that nothing can replace; raises CompilerError where it cannot be compiled."""
    code = native_code(source, subject)
    if code is None:
        raise CompilerError(subject, f"neither a C compiler nor LLVM can compile {source.name}")
    return code


def _load(file: Path, source: Path) -> NativeCode:
    library = ctypes.CDLL(str(file))
    address = lambda name: ctypes.cast(getattr(library, name), ctypes.c_void_p).value or 0  # noqa: E731
    return NativeCode(address=address, owner=library, source=source)
