"""Mesh files of robots and scenes: their triangles, and the unit and the vertical axis that they state.

STL and OBJ are read by hand: trimesh 5.2 passes over the lines of an OBJ file that it does not know (F for f), takes corner 0
for the last one, and covers the dents of concave polygons. A robot with a face less, or one more, passes through things. So are
PLY files, text and binary, strictly (counts and indices are checked before anything uses them): trimesh 5.2 reads a text file
that is cut off as a smaller mesh.
"""

import math
import re
import struct
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import coal
import numpy as np
from numpy.typing import NDArray

from manipplan.robots.mesh_scenes import MOST_TRIANGLES, check_count, numbers, split_polygons
from manipplan.support.checks import Array
from manipplan.support.errors import FileFormatError, MissingExtraError

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
        corners += list(values.get("face", {}).get(key, ()))
    flat = np.concatenate(corners) if corners else np.empty(0)
    wrong = flat[~((flat >= 0) & (flat < len(vertices)) & (flat == np.floor(flat)))]
    if len(wrong):
        raise ValueError(f"a face names corner {wrong[0]:g} of {len(vertices)}")
    return Ply(vertices=vertices, faces=corners)


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
        kind = self._row(element)
        whole = element.count * kind.itemsize
        lists = [each.name for each in element.properties if each.length is not None]
        if whole <= len(self.body) - self.at:
            rows = np.frombuffer(self.body, kind, element.count, self.at)
            if all((rows[f"length of {name}"] == rows[name].shape[1]).all() for name in lists):
                self.at += whole
                columns = {each.name: rows[each.name].astype(float) for each in element.properties}
                return {name: list(column) if name in lists else column for name, column in columns.items()}
        elif not lists:
            raise ValueError(f"{whole} bytes where {len(self.body) - self.at} are left")
        return self._row_by_row(element)

    def _row(self, element: _Element) -> "np.dtype[np.void]":
        """The type of a row whose lists are as long as those of the first one."""
        at, parts = self.at, list[tuple[str, str, tuple[int, ...]]]()
        for each in element.properties:
            shape: tuple[int, ...] = ()
            if each.length is not None:
                shape = struct.unpack_from(self.order + each.length, self.body, at)
                at += struct.calcsize(each.length)
                parts.append((f"length of {each.name}", self.order + each.length, ()))
            if not 0 <= math.prod(shape) <= len(self.body):
                raise ValueError(f"a list of {shape[0]} numbers")
            at += math.prod(shape) * struct.calcsize(each.code)
            parts.append((each.name, self.order + each.code, shape))
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


#: Endings of the files that are read.
ENDINGS = (".stl", ".obj", ".ply", ".dae", ".gltf", ".glb")
#: A facet of a binary STL: normal, three corners, two bytes.
FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
HEADER = 84
#: Lines of an OBJ file that change no triangle; those of free-form curves and surfaces, and of other files, are not among them.
PASSED = (
    *("vt", "vn", "vp", "p", "l", "g", "o", "s", "mg", "usemtl", "mtllib", "usemap", "maplib", "bevel", "c_interp", "d_interp"),
    *("lod", "shadow_obj", "trace_obj"),
)

#: Maximum size of a file [bytes].
LARGEST = 100_000_000

Faces = NDArray[np.int64]


@dataclass(frozen=True, kw_only=True)
class MeshFile:
    """Triangles (t, 3, 3) of a mesh file in its own numbers, with the transforms of its scene graph applied.

    `unit` [m] and the vertical axis `up` are those that the file states; 1 and "" when it states none.
    """

    triangles: Array
    unit: float = 1.0
    up: str = ""


def read_mesh(argument: str, file: Path) -> MeshFile:
    """Read a mesh file by its ending; raises FileFormatError with the fault."""
    ending = file.suffix.lower()
    if ending not in ENDINGS:
        raise FileFormatError(argument, str(file), f"a mesh in a file that ends with {', '.join(ENDINGS)}")
    try:
        size = file.stat().st_size
        if size > LARGEST:
            raise ValueError(f"it has {size:,} bytes, of at most {LARGEST:,}")
        if ending == ".stl":
            mesh = MeshFile(triangles=_stl(file.read_bytes()))
        elif ending == ".obj":
            mesh = MeshFile(triangles=_obj(file.read_text(encoding="utf-8-sig", errors="replace")))
        elif ending == ".ply":
            content = read_ply(file, rows=3 * MOST_TRIANGLES, faces=MOST_TRIANGLES)
            if content.faces and min(map(len, content.faces)) < 3:
                raise ValueError(f"a face with {min(map(len, content.faces))} corners")
            mesh = MeshFile(triangles=split_polygons(content.vertices, content.faces))
        elif ending == ".dae":
            from manipplan.robots.mesh_scenes import read_collada  # it imports what reads descriptions

            triangles, unit, up = read_collada(argument, file)
            mesh = MeshFile(triangles=triangles, unit=unit, up=up)
        else:
            from manipplan.robots.mesh_scenes import read_gltf

            mesh = MeshFile(triangles=read_gltf(file), up="y")
        check_count(len(mesh.triangles))
    except (FileFormatError, MissingExtraError):
        raise
    except (ValueError, OSError, OverflowError, MemoryError) as error:
        reason = " ".join(str(error).split())[:160]
        raise FileFormatError(argument, str(file), f"a mesh in the format {ending[1:].upper()}; {reason}") from error
    if not len(mesh.triangles):
        raise FileFormatError(argument, str(file), "a mesh with at least one triangle")
    return mesh


def first_of_rows(rows: NDArray[Any]) -> tuple[Faces, Faces]:
    """Of equal rows (k, c) the index of one, and for each row its place in that list."""
    order = np.lexsort(rows.T)
    new = np.concatenate([np.ones(min(len(rows), 1), dtype=bool), (np.diff(rows[order], axis=0) != 0).any(axis=1)])
    index = np.empty(len(rows), dtype=np.int64)
    index[order] = np.cumsum(new) - 1
    return order[new], index


def welded(triangles: Array) -> tuple[Array, Faces]:
    """The corners (v, 3) of triangles (t, 3, 3), each once, and the triangles with three different ones as indices (f, 3)."""
    points = triangles.reshape(-1, 3)
    first, index = first_of_rows(points)
    faces = index.reshape(-1, 3)
    return points[first], faces[(faces != np.roll(faces, 1, axis=1)).all(axis=1)]


def triangle_tree(corners: Array, faces: Faces) -> coal.BVHModelOBBRSS:
    """A tree over triangles, each three indices of corners (v, 3) [m].

    Its attribute `arrays` has both, as coal gives triangles back only one by one. Copies by C++ or pickle do not have it.
    """
    tree = coal.BVHModelOBBRSS()
    tree.beginModel(len(faces), len(corners))
    tree.addVertices(np.ascontiguousarray(corners))
    tree.addTriangles(np.ascontiguousarray(faces))
    tree.endModel()
    tree.computeLocalAABB()
    vars(tree).update(arrays=(corners, faces), __getstate_manages_dict__=True)  # without the second, it could not be pickled
    return tree


def _stl(data: bytes) -> Array:
    """Triangles of an STL file, binary or text; the length tells which of the two it is."""
    count = int.from_bytes(data[80:HEADER], "little") if len(data) >= HEADER else -1
    if len(data) == HEADER + FACET.itemsize * count:
        check_count(count)
        return np.asarray(np.frombuffer(data, FACET, count, HEADER)["corners"], dtype=float)
    if b"\0" in data or not re.match(rb"\s*solid", data, re.IGNORECASE):  # a binary header may begin with "solid", too
        held = max(len(data) - HEADER, 0) / FACET.itemsize
        raise ValueError(f"its header announces {max(count, 0)} facets, but it holds {held:g}")
    if len(re.findall(rb"(?i)^\s*endsolid", data, re.MULTILINE)) != len(re.findall(rb"(?i)^\s*solid", data, re.MULTILINE)):
        raise ValueError("it is cut off: a solid without endsolid")
    check_count(len(re.findall(rb"(?i)\bfacet\s+normal", data)))
    words = re.sub(rb"(?i)^\s*(end)?solid.*$", b"", data, flags=re.MULTILINE).lower().split()
    pattern = b"facet normal . . . outer loop vertex . . . vertex . . . vertex . . . endloop endfacet".split()
    if len(words) % len(pattern):
        raise ValueError("a facet is cut off, or is not a triangle")
    table = np.array(words, dtype=object).reshape(-1, len(pattern))
    for column, word in enumerate(pattern):
        wrong = table[:, column][table[:, column] != word] if word != b"." else []
        if len(wrong):
            raise ValueError(f"{wrong[0].decode(errors='replace')[:40]!r} where {word.decode()!r} is expected")
    corners = table[:, [8, 9, 10, 12, 13, 14, 16, 17, 18]].ravel()
    return numbers(b" ".join(corners.tolist()).decode("utf-8", "replace")).reshape(-1, 3, 3)


def _obj(text: str) -> Array:
    """Triangles of all objects of an OBJ file; lines and points are left out."""
    check_count(text.count("\nf "))
    coordinates: list[str] = []
    polygons: list[list[int]] = []
    for line in text.replace("\\\r\n", " ").replace("\\\n", " ").splitlines():
        words = line.partition("#")[0].split()
        if not words:
            continue
        if words[0] == "v":
            if len(words) < 4:
                raise ValueError(f"vertex {len(coordinates) // 3 + 1} has fewer than three coordinates")
            coordinates += words[1:4]
        elif words[0] == "f":
            if len(words) < 4:
                raise ValueError(f"a face with {len(words) - 1} corners")
            corners = numbers(" ".join(word.partition("/")[0] for word in words[1:]), int)
            if not corners.all():
                raise ValueError("a face names vertex 0; they count from 1")
            polygons.append([k - 1 if k > 0 else k + len(coordinates) // 3 for k in corners.tolist()])
        elif words[0] not in PASSED:
            raise ValueError(f"it has lines {words[0][:40]!r}, which are not read")
    vertices = numbers(" ".join(coordinates)).reshape(-1, 3)
    flat = [k for polygon in polygons for k in polygon]
    if flat and not 0 <= min(flat) <= max(flat) < len(vertices):
        raise ValueError(f"a face names a vertex outside 1 to {len(vertices)}")
    return split_polygons(vertices, polygons)
