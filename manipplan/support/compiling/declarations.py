"""What a C source of ours declares, for ctypes: its structs, and the functions that this package calls.

So fields and arguments are written down once, in C. It reads what our own sources contain: structs of numbers, pointers, other
structs and arrays of these, and functions whose names begin with `manipplan_`.
"""

import ctypes
import re
from functools import cache
from typing import Any

from manipplan.support.compiling.kernel_library import FOLDER
from manipplan.support.errors import CompilerError

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
