"""PLY files, text and binary, read strictly: counts and indices are checked before anything uses them.

By hand: trimesh 5.2 reads a text file that is cut off as a smaller mesh.
"""

import struct
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from manipplan.support.checks import Array

TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d"}
SIZED = {"int8": "b", "uint8": "B", "int16": "h", "uint16": "H", "int32": "i", "uint32": "I", "float32": "f", "float64": "d"}
CODES = {**TYPES, **SIZED}
#: Names of the property that holds the corners of a face.
CORNERS = ("vertex_indices", "vertex_index")
#: Text formats of the header, with the byte order of the body.
FORMATS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}

Rows = list[NDArray[np.float64]]


@dataclass(frozen=True, kw_only=True)
class _Property:
    """A property: its name, the code of its values and, for a list, the code of the list's length."""

    name: str
    code: str
    length: str | None = None


@dataclass(frozen=True, kw_only=True)
class _Element:
    """An element, such as vertex or face: its name, its number of rows and their properties."""

    name: str
    count: int
    properties: list[_Property]


@dataclass(frozen=True, kw_only=True)
class Ply:
    """The contents of a PLY file: vertices (v, 3), and the corners of each face."""

    vertices: Array
    faces: Rows


def read_ply(file: Path, *, rows: int, faces: int) -> Ply:
    """The vertices and faces of a PLY file with at most `rows` of an element, and `faces`; raises ValueError with the fault."""
    data = file.read_bytes()
    head, mark, body = data.partition(b"end_header")
    if not mark:
        raise ValueError("not a PLY file, or cut off (no end_header)")
    try:
        form, elements = _header(head.decode("ascii"))
        if len({each.name for each in elements}) < len(elements):
            raise ValueError("two elements of the same name")
        for each in elements:
            most = faces if each.name == "face" else rows
            if each.count > most:
                raise ValueError(f"{each.count:,} rows of {each.name}, of at most {most:,}")
        body = body[body.index(b"\n") + 1 :]
        reader = _Text(body) if form == "ascii" else _Binary(body, FORMATS[form])
        values: dict[str, Mapping[str, Array | Rows]] = {}
        for element in elements:
            values[element.name] = reader.element(element)
        if not reader.ended:
            raise ValueError("it holds more than its header announces")
    except (ValueError, OverflowError, KeyError, IndexError, MemoryError, struct.error) as error:
        raise ValueError(f"not a PLY file, or cut off ({type(error).__name__}: {error})") from error
    vertex = values.get("vertex", {})
    columns = [np.asarray(vertex.get(axis, ()), dtype=float) for axis in "xyz"]
    if len({len(column) for column in columns}) > 1 or any(column.ndim != 1 for column in columns):
        raise ValueError("its vertices lack x, y or z")
    vertices = np.stack(columns, axis=1)
    corners: Rows = []
    if any(each.name == "face" and each.count for each in elements) and not any(key in values["face"] for key in CORNERS):
        raise ValueError(f"a face without one list called {' or '.join(CORNERS)}")
    if any(each.name == "tristrips" and each.count for each in elements):
        raise ValueError("it has triangle strips (tristrips), which are not read")
    for key in CORNERS:
        found = list(values.get("face", {}).get(key, ()))
        _check_corners(found, len(vertices))
        corners += found
    return Ply(vertices=vertices, faces=corners)


def _check_corners(rows: Rows, corners: int) -> None:
    flat = np.concatenate(rows) if rows else np.empty(0)
    wrong = flat[~((flat >= 0) & (flat < corners) & (flat == np.floor(flat)))]
    if len(wrong):
        raise ValueError(f"a face names corner {wrong[0]:g} of {corners}")


def _header(text: str) -> tuple[str, list[_Element]]:
    form, elements = "", list[_Element]()
    for line in text.splitlines():
        words = line.split()
        if words[:1] == ["format"]:
            form = words[1]
        elif words[:1] == ["element"]:
            elements.append(_Element(name=words[1], count=int(words[2]), properties=[]))
        elif words[:2] == ["property", "list"]:
            elements[-1].properties.append(_Property(name=words[4], code=CODES[words[3]], length=CODES[words[2]]))
        elif words[:1] == ["property"]:
            elements[-1].properties.append(_Property(name=words[2], code=CODES[words[1]]))
    if form not in FORMATS:
        raise ValueError(f"format {form!r}")
    if any(element.count < 0 for element in elements):
        raise ValueError("a negative number of elements")
    return form, elements


class _Text:
    """The numbers of a text file, element by element: each row is a line."""

    def __init__(self, body: bytes) -> None:
        self.lines = [line for line in body.splitlines() if line.strip()]
        self.at = 0

    @property
    def ended(self) -> bool:
        """Whether nothing follows."""
        return self.at == len(self.lines)

    def element(self, element: _Element) -> Mapping[str, Array | Rows]:
        """The values of each property: (count,), or one array per row for a list."""
        names = [each.name for each in element.properties]
        if element.count > len(self.lines) - self.at:
            raise ValueError(f"{element.count} lines where {len(self.lines) - self.at} are left")
        rows = [line.split() for line in self.lines[self.at : self.at + element.count]]
        self.at += element.count
        if all(each.length is None for each in element.properties):
            for row in rows:
                _check_length(row, len(names))
            return dict(zip(names, np.array(rows, dtype=float).reshape(element.count, len(names)).T, strict=True))
        values: dict[str, Rows] = {name: [] for name in names}
        for row in rows:
            numbers, at = np.array(row, dtype=float), 0
            for each in element.properties:
                size = 1
                if each.length is not None:
                    size = int(numbers[at])
                    at += 1
                if not 0 <= size <= len(numbers) - at:
                    raise ValueError(f"a line of {len(numbers)} numbers, too few")
                values[each.name].append(numbers[at : at + size])
                at += size
            _check_length(row, at)
        return values


def _check_length(row: list[bytes], length: int) -> None:
    if len(row) != length:
        raise ValueError(f"a line of {len(row)} numbers where {length} are expected")


class _Binary:
    """The numbers of a binary file, element by element."""

    def __init__(self, body: bytes, order: str) -> None:
        self.body = body
        self.order = order
        self.at = 0

    @property
    def ended(self) -> bool:
        """Whether nothing but white space follows."""
        return not self.body[self.at :].strip()

    def element(self, element: _Element) -> Mapping[str, Array | Rows]:
        """The values of each property: (count,), or one array per row for a list."""
        if not element.properties or not element.count:
            return {}
        sizes = self._sizes(element)
        kind = self._row(element, sizes)
        whole = element.count * kind.itemsize
        if whole <= len(self.body) - self.at:
            rows = np.frombuffer(self.body, kind, element.count, self.at)
            if all((rows[f"length of {name}"] == size).all() for name, size in sizes.items()):
                self.at += whole
                return {
                    each.name: list(rows[each.name].astype(float)) if each.length else rows[each.name].astype(float)
                    for each in element.properties
                }
        elif not sizes:
            raise ValueError(f"{whole} bytes where {len(self.body) - self.at} are left")
        return self._row_by_row(element)

    def _sizes(self, element: _Element) -> dict[str, int]:
        """The length of each list in the first row."""
        at, sizes = self.at, {}
        for each in element.properties:
            size = 1
            if each.length is not None:
                [size] = struct.unpack_from(self.order + each.length, self.body, at)
                at += struct.calcsize(each.length)
                sizes[each.name] = int(size)
            if not 0 <= size <= len(self.body):
                raise ValueError(f"a list of {size} numbers")
            at += int(size) * struct.calcsize(each.code)
        return sizes

    def _row(self, element: _Element, sizes: Mapping[str, int]) -> "np.dtype[np.void]":
        """The type of a row whose lists have these lengths."""
        parts: list[tuple[str, str, tuple[int, ...]]] = []
        for each in element.properties:
            if each.length is not None:
                parts.append((f"length of {each.name}", self.order + each.length, ()))
            parts.append((each.name, self.order + each.code, () if each.length is None else (sizes[each.name],)))
        return np.dtype(parts)

    def _row_by_row(self, element: _Element) -> Mapping[str, Rows]:
        values: dict[str, Rows] = {each.name: [] for each in element.properties}
        for _ in range(element.count):
            for each in element.properties:
                size = 1
                if each.length is not None:
                    [size] = struct.unpack_from(self.order + each.length, self.body, self.at)
                    self.at += struct.calcsize(each.length)
                kind = np.dtype(self.order + each.code)
                if not 0 <= size * kind.itemsize <= len(self.body) - self.at:
                    raise ValueError(f"a list of {size} numbers where {len(self.body) - self.at} bytes are left")
                values[each.name].append(np.frombuffer(self.body, kind, int(size), self.at).astype(float))
                self.at += int(size) * kind.itemsize
        return values
