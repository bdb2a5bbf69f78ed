"""Mesh files of robots and scenes: their triangles, and the unit and the vertical axis that they state.

STL and OBJ are read by hand: trimesh 5.2 passes over the lines of an OBJ file that it does not know (F for f), takes corner 0
for the last one, and covers the dents of concave polygons. A robot with a face less, or one more, passes through things.
"""

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import coal
import numpy as np
from numpy.typing import NDArray

from manipplan.robots.meshes.ply import read_ply
from manipplan.robots.meshes.polygons import MOST_TRIANGLES, check_count, numbers, split_polygons
from manipplan.support.checks import Array
from manipplan.support.errors import FileFormatError, MissingExtraError

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
    """The contents of a mesh file, with the transforms of its scene graph applied.

    Attributes:
        triangles: (t, 3, 3), in the numbers of the file.
        unit: length of the unit that the file states [m]; 1 when it states none.
        up: axis that the file states as vertical; "" when it states none.
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
            from manipplan.robots.meshes.collada import read_collada  # it imports what reads descriptions

            triangles, unit, up = read_collada(argument, file)
            mesh = MeshFile(triangles=triangles, unit=unit, up=up)
        else:
            from manipplan.robots.meshes.gltf import read_gltf

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
    if len(data) == HEADER + FACET.itemsize * count:
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
