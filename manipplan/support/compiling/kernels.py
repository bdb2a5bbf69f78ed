"""The kernels, `manipplan/csrc/*.c`: from the library that was built with the package, or by LLVM where there is none."""

import ctypes
import logging
import lzma
import re
from collections.abc import Callable, Collection
from functools import cache
from typing import Any

from manipplan.support.compiling.declarations import PREFIX, signatures
from manipplan.support.compiling.kernel_library import FOLDER, digest_of, find_library
from manipplan.support.compiling.llvm import compile_by_llvm
from manipplan.support.deadline import building
from manipplan.support.errors import CompilerError

log = logging.getLogger("manipplan")
#: All kernels in LLVM's language, which `make kernels` writes: of each a line with its name and hash, and its text.
LLVM_TEXTS = FOLDER / "kernels.ll.xz"


class Kernel:
    """Functions of one C source.

    Args:
        name: the file without suffix, such as "curves".
        address: the address of a function by its whole name.
        owner: what holds their code.
    """

    def __init__(self, name: str, address: Callable[[str], int], owner: object) -> None:
        self.name, self._address, self._owner = name, address, owner

    def address(self, name: str) -> int:
        """The address of a function, by its name without prefix."""
        return self._address(PREFIX + name)

    def functions(self, *, quick: Collection[str] = ()) -> dict[str, Callable[..., Any]]:
        """The functions, by their names without prefix.

        They release the GIL, but for the `quick` ones: to release it would take longer than what these do.
        """
        found: dict[str, Any] = {
            name: (ctypes.PYFUNCTYPE if name in quick else ctypes.CFUNCTYPE)(*types)(self.address(name))
            for name, types in signatures(self.name).items()
        }
        for each in found.values():
            each.owner = self._owner  # the code lives as long as its functions
        return found


@cache
def load_kernel(name: str) -> Kernel:
    """The kernel of `csrc/<name>.c`, for this process."""
    library = _library()
    return kernel_by_llvm(name) if library is None else Kernel(name, _addresses(library), library)


@cache
def _library() -> ctypes.CDLL | None:
    file = find_library()
    if file is None:
        log.info("the library of kernels was not built with the package: LLVM compiles them, which are up to a fifth slower")
        return None
    try:
        return ctypes.CDLL(str(file))
    except OSError as error:
        log.warning("%s cannot be loaded, so LLVM compiles the kernels: %s", file, error)
        return None


def _addresses(library: ctypes.CDLL) -> Callable[[str], int]:
    return lambda name: ctypes.cast(getattr(library, name), ctypes.c_void_p).value or 0


@building()
def kernel_by_llvm(name: str) -> Kernel:
    """The same as LLVM compiles it; raises CompilerError where the C source was edited since `make kernels`."""
    digest, text = llvm_texts()[name]
    if digest != digest_of(name):
        raise CompilerError(f"{name}.c", "it was edited and not built; build it with: make kernels")
    engine = compile_by_llvm(text, f"kernel {name}")
    return Kernel(name, engine.get_function_address, engine)


@cache
def llvm_texts() -> dict[str, tuple[str, str]]:
    """The hash and the text of each kernel in LLVM's language, by its name."""
    _, *parts = re.split(r"^; (\w+) (\w{64})\n", lzma.decompress(LLVM_TEXTS.read_bytes()).decode(), flags=re.MULTILINE)
    return {name: (digest, text) for name, digest, text in zip(parts[::3], parts[1::3], parts[2::3], strict=True)}
