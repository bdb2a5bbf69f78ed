"""Mesh files: their triangles, and the unit and the vertical axis that they state."""

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from manipplan.collision.formats.polygons import split_polygons
from manipplan.robots.meshes.ply import read_ply
from manipplan.support.checks import Array
from manipplan.support.errors import FileFormatError, MissingExtraError

#: Endings of the files that are read.
ENDINGS = (".stl", ".obj", ".ply", ".dae", ".gltf", ".glb")
#: A facet of a binary STL: normal, three corners, two bytes.
FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
HEADER = 84


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
        if ending == ".stl":
            mesh = MeshFile(triangles=_stl(file.read_bytes()))
        elif ending == ".obj":
            mesh = MeshFile(triangles=_obj(file.read_text(encoding="utf-8-sig", errors="replace")))
        elif ending == ".ply":
            content = read_ply(file)
            mesh = MeshFile(triangles=split_polygons(content.vertices, content.faces))
        elif ending == ".dae":
            from manipplan.collision.formats.collada import read_collada

            triangles, unit, up = read_collada(argument, file)
            mesh = MeshFile(triangles=triangles, unit=unit, up=up)
        else:
            from manipplan.collision.formats.gltf import read_gltf

            mesh = MeshFile(triangles=read_gltf(file), up="y")
    except (FileFormatError, MissingExtraError):
        raise
    except (ValueError, OSError, OverflowError, MemoryError) as error:
        reason = " ".join(str(error).split())[:160]
        raise FileFormatError(argument, str(file), f"a mesh in the format {ending[1:].upper()}; {reason}") from error
    if not len(mesh.triangles):
        raise FileFormatError(argument, str(file), "a mesh with at least one triangle")
    return mesh


def _stl(data: bytes) -> Array:
    """Triangles of an STL file, binary or text; the length tells which of the two it is."""
    count = int.from_bytes(data[80:HEADER], "little") if len(data) >= HEADER else -1
    if len(data) == HEADER + FACET.itemsize * count:
        return np.asarray(np.frombuffer(data, FACET, count, HEADER)["corners"], dtype=float)
    if not re.match(rb"\s*solid", data, re.IGNORECASE):
        held = max(len(data) - HEADER, 0) / FACET.itemsize
        raise ValueError(f"its header announces {max(count, 0)} facets, but it holds {held:g}")
    words = re.sub(rb"(?i)^\s*(end)?solid.*$", b"", data, flags=re.MULTILINE).lower().split()
    pattern = b"facet normal . . . outer loop vertex . . . vertex . . . vertex . . . endloop endfacet".split()
    if len(words) % len(pattern):
        raise ValueError("a facet is cut off, or is not a triangle")
    table = np.array(words, dtype=object).reshape(-1, len(pattern))
    for column, word in enumerate(pattern):
        wrong = table[:, column][table[:, column] != word] if word != b"." else []
        if len(wrong):
            raise ValueError(f"{wrong[0].decode(errors='replace')[:40]!r} where {word.decode()!r} is expected")
    return table[:, [8, 9, 10, 12, 13, 14, 16, 17, 18]].astype(float).reshape(-1, 3, 3)


def _obj(text: str) -> Array:
    """Triangles of all objects of an OBJ file; lines and points are left out."""
    vertices: list[list[str]] = []
    polygons: list[list[int]] = []
    for line in text.replace("\\\r\n", " ").replace("\\\n", " ").splitlines():
        words = line.partition("#")[0].split()
        if not words:
            continue
        if words[0] in ("fo", "surf", "call", "csh"):
            raise ValueError(f"it has lines {words[0]!r}, which are not read")
        if words[0] == "v":
            vertices.append(words[1:4])
        elif words[0] == "f":
            numbers = [int(word.partition("/")[0]) for word in words[1:]]
            if len(numbers) < 3:
                raise ValueError(f"a face with {len(numbers)} corners")
            if 0 in numbers:
                raise ValueError("a face names vertex 0; they count from 1")
            polygons.append([k - 1 if k > 0 else k + len(vertices) for k in numbers])
    if any(len(words) < 3 for words in vertices):
        raise ValueError("a vertex with fewer than three coordinates")
    flat = [k for polygon in polygons for k in polygon]
    if flat and not 0 <= min(flat) <= max(flat) < len(vertices):
        raise ValueError(f"a face names a vertex outside 1 to {len(vertices)}")
    return split_polygons(np.array(vertices, dtype=float).reshape(-1, 3), polygons)
