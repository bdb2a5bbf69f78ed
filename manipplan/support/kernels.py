"""The kernels, `manipplan/csrc/*.c`: from the library that was built with the package, or by LLVM where there is none.

What a C source of ours declares, for ctypes: its structs, and the functions that this package calls. So fields and arguments
are written down once, in C. It reads what our own sources contain: structs of numbers, pointers, other structs and arrays of
these, and functions whose names begin with `manipplan_`.

Machine code from LLVM's language, by the LLVM of llvmlite, is kept in the user's cache folder.
"""

import ctypes
import hashlib
import logging
import lzma
import re
from collections.abc import Callable, Collection
from functools import cache
from typing import Any

from manipplan.support.compiler import cache_errors, cache_for, is_sound, log_when_slow, place_to_build, publish
from manipplan.support.deadline import building
from manipplan.support.errors import CompilerError
from manipplan.support.kernel_library import FOLDER, digest_of, find_library

log = logging.getLogger("manipplan")

PREFIX = "manipplan_"
#: Types of numbers.
TYPES: dict[str, Any] = {
    "char": ctypes.c_char,
    "signed char": ctypes.c_byte,
    "unsigned char": ctypes.c_ubyte,
    "int": ctypes.c_int,
    "long": ctypes.c_long,
    "unsigned long long": ctypes.c_ulonglong,
    "double": ctypes.c_double,
}
_COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.DOTALL)
#: A line that includes a header of ours.
_INCLUDE = re.compile(r'^#include "(\w+\.h)"\n', re.MULTILINE)
_FUNCTION = re.compile(rf"^(?!static)(\w[\w ]*?)\s*(\*?){PREFIX}(\w+)\(([^()]*)\)\s*{{", re.MULTILINE)
_POINTER_TO_FUNCTION = re.compile(r".*\(\*(\w+)\)\(.*\)", re.DOTALL)
_FIELD = re.compile(r"(?:const )?((?:signed |unsigned )?\w+(?: long)?)\b(.*)", re.DOTALL)
_NAME = re.compile(r"\s*(\**)\s*(\w+)\s*((?:\[\d+\])*)\s*")


def source_text(name: str) -> str:
    """The source `csrc/<name>.c` with our headers in place of the lines that include them, each once."""
    seen: set[str] = set()

    def expand(file: str) -> str:
        text = (FOLDER / file).read_text(encoding="utf-8").replace("#pragma once\n", "")
        return _INCLUDE.sub(lambda line: include(line[1]), text)

    def include(header: str) -> str:
        if header in seen:
            return ""
        seen.add(header)
        return expand(header)

    return expand(f"{name}.c")


@cache
def _code(source: str) -> str:
    return _COMMENT.sub("", source_text(source))


@cache
def signatures(source: str) -> dict[str, tuple[Any, ...]]:
    """The types of result and arguments of each function, by its name without prefix. Pointers are addresses."""
    return {
        name: (_type(source, result, star), *(_type(source, *_argument(each)) for each in arguments.split(",")))
        for result, star, name, arguments in _FUNCTION.findall(_code(source))
    }


def _argument(text: str) -> tuple[str, str]:
    """The type of an argument, and "*" for a pointer."""
    kind, _, _ = text.replace("*", " * ").strip().removeprefix("const ").partition(" *")
    return (kind, "*") if "*" in text else (kind.rpartition(" ")[0], "")


def _type(source: str, kind: str, star: str) -> Any:
    if star:
        return ctypes.c_void_p
    kind = kind.removeprefix("const ").strip()
    return None if kind == "void" else TYPES[kind] if kind in TYPES else struct(source, kind)


@cache
def struct(source: str, name: str) -> type[ctypes.Structure]:
    """The struct of that name; raises CompilerError where the source has none that can be read."""
    found = re.search(rf"typedef struct {{([^{{}}]*)}} {name};", _code(source))
    if found is None:
        raise CompilerError(f"the struct {name}", f"{source}.c declares none that can be read")
    fields = [field for line in found[1].split(";") if line.strip() for field in _fields(source, line.strip())]
    return type(name, (ctypes.Structure,), {"_fields_": fields, "__doc__": f"`{name}` of {source}.c."})


def _fields(source: str, declaration: str) -> list[tuple[str, Any]]:
    """Names and types of what one declaration of a struct declares."""
    if pointer := _POINTER_TO_FUNCTION.fullmatch(declaration):
        return [(pointer[1], ctypes.c_void_p)]
    fields = []
    kind = _FIELD.fullmatch(declaration)
    for declarator in kind[2].split(",") if kind else [""]:
        found = _NAME.fullmatch(declarator)
        if kind is None or found is None:
            raise CompilerError(f"the field {declaration!r}", f"{source}.c declares it in a way that cannot be read")
        field = _type(source, kind[1], found[1])
        for length in reversed(re.findall(r"\d+", found[3])):
            field = field * int(length)
        fields.append((found[2], field))
    return fields


#: Level of optimisation.
LEVEL = 3


def compile_by_llvm(text: str, subject: str) -> Any:
    """An execution engine with the functions of a module in LLVM's language, for the processor of this machine.

    Addresses are given by `get_function_address(name)`; the code lives as long as the engine. The module needs no optimisation
    before it becomes machine code. Raises CompilerError where LLVM does not accept it; `subject` names it.
    """
    import llvmlite
    from llvmlite import binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    target = llvm.Target.from_default_triple()
    cpu, features = llvm.get_host_cpu_name(), llvm.get_host_cpu_features().flatten()
    machine = target.create_target_machine(cpu=cpu, features=features, opt=LEVEL, jit=True)
    key = "\0".join([text, llvmlite.__version__, target.triple, cpu, features, str(LEVEL)])
    with log_when_slow(f"compiling {subject}, by LLVM"):
        code = _stored(key, subject, lambda: _machine_code(text, subject, machine, target.triple))
    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), machine)
    engine.add_object_file(llvm.ObjectFileRef.from_data(code))
    engine.finalize_object()
    return engine


def _machine_code(text: str, subject: str, machine: Any, triple: str) -> bytes:
    """An object file."""
    from llvmlite import binding as llvm

    try:
        module = llvm.parse_assembly(text)
        module.triple, module.data_layout = triple, str(machine.target_data)
        module.verify()
    except RuntimeError as error:
        raise CompilerError(subject, str(error)) from error
    return bytes(machine.emit_object(module))


def _stored(key: str, subject: str, compile_now: Callable[[], bytes]) -> bytes:
    """The machine code of that key from the cache, or made now and put there."""
    file = None
    try:
        file = cache_for(subject) / f"{hashlib.sha256(key.encode()).hexdigest()[:32]}.o"
        if is_sound(file):
            return file.read_bytes()
    except CompilerError as error:
        log.info("%s: compiled by LLVM in each process: %s", subject, error)
    code = compile_now()
    if file is not None:
        try:
            with place_to_build(file.parent, subject) as place, cache_errors(file.parent, subject):
                (place / file.name).write_bytes(code)
                publish(place / file.name, file)
        except CompilerError as error:
            log.info("%s: compiled by LLVM in each process: %s", subject, error)
    return code


#: All kernels in LLVM's language, which `make kernels` writes: of each a line with its name and hash, and its text.
LLVM_TEXTS = FOLDER / "kernels.ll.xz"


class Kernel:
    """Functions of one C source, such as "curves", by their addresses; `owner` holds their code."""

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
