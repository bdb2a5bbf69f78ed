"""PLY files, checked before a mesh loader reads them: it does not check the indices of the faces, and crashes."""

import struct
from collections.abc import Generator
from pathlib import Path

TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d"}
SIZED = {"int8": "b", "uint8": "B", "int16": "h", "uint16": "H", "int32": "i", "uint32": "I", "float32": "f", "float64": "d"}
CODES = {**TYPES, **SIZED}

#: An element's name, its count and, for each property, its code and, for a list, the code of the list's length.
Element = tuple[str, int, list[tuple[str, str | None]]]


def fault_of(file: Path) -> str | None:
    """The fault in the faces of a PLY file; None if there is none."""
    data = file.read_bytes()
    head, mark, body = data.partition(b"end_header")
    try:
        form, elements = _header(head.decode("ascii"))
        body = body[body.index(b"\n") + 1 :]
        values = _text(body) if form == "ascii" else _binary(body, "<" if form == "binary_little_endian" else ">")
        next(values)
        corners = sum(count for name, count, _ in elements if name == "vertex")
        for name, count, properties in elements:
            for _ in range(count if properties else 0):
                for code, length in properties:
                    size = 1 if length is None else int(values.send(length))
                    for _ in range(size):
                        value = values.send(code)
                        if name == "face" and length is not None and not 0 <= value < corners:
                            return f"a face names corner {value:g} of {corners}"
    except (ValueError, OverflowError, KeyError, IndexError, StopIteration, struct.error) as error:
        return f"not a PLY file, or cut off ({type(error).__name__}: {error})"
    return None if mark else "no end_header"


def _header(text: str) -> tuple[str, list[Element]]:
    form, elements = "", list[Element]()
    for line in text.splitlines():
        words = line.split()
        if words[:1] == ["format"]:
            form = words[1]
        elif words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), []))
        elif words[:2] == ["property", "list"]:
            elements[-1][2].append((CODES[words[3]], CODES[words[2]]))
        elif words[:1] == ["property"]:
            elements[-1][2].append((CODES[words[1]], None))
    if form not in ("ascii", "binary_little_endian", "binary_big_endian"):
        raise ValueError(f"format {form!r}")
    return form, elements


def _text(body: bytes) -> Generator[float, str, None]:
    """The numbers of an ASCII file, one per code that is sent."""
    yield 0.0
    for word in body.split():
        yield float(word)


def _binary(body: bytes, order: str) -> Generator[float, str, None]:
    """The numbers of a binary file, each of the type of the code that is sent."""
    code, at = (yield 0.0), 0
    while True:
        [value] = struct.unpack_from(order + code, body, at)
        at += struct.calcsize(code)
        code = yield value
