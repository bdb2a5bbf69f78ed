"""glTF files, text and binary, read by trimesh after a look at what they need."""

import struct
from pathlib import Path
from typing import Any

import numpy as np

from manipplan.robots.meshes.polygons import check_count, move_triangles
from manipplan.support.checks import Array
from manipplan.support.data_files import parsed
from manipplan.support.errors import MissingExtraError

#: Extensions that say nothing about the shape.
HARMLESS = ("KHR_materials", "KHR_texture", "KHR_lights", "EXT_texture", "EXT_lights")
#: Modes of a primitive: points and lines have no triangles; 4, the default, are triangles, 5 are strips of them.
LINES, TRIANGLES = (0, 1, 2, 3), (4, 5)
#: Component type of floats.
FLOAT = 5126


def read_gltf(file: Path) -> Array:
    """Triangles (t, 3, 3) of the default scene, in its root frame.

    Raises:
        ValueError: the file is not valid, or needs an extension or a kind of primitive that is not read.
        MissingExtraError: trimesh is not installed.
    """
    count = _count_primitives(_document(file.read_bytes()))
    try:
        import trimesh
    except ImportError as error:
        raise MissingExtraError("trimesh", "mesh") from error
    try:
        scene = trimesh.load_scene(file, process=False)
        found = [
            move_triangles(np.asarray(mesh.vertices, dtype=float)[np.asarray(mesh.faces)], transform)
            for transform, mesh in _place_meshes(scene)
        ]
    except Exception as error:  # trimesh raises whatever happens to it on a broken file
        raise ValueError(f"trimesh says: {type(error).__name__}: {error}") from error
    triangles = np.concatenate([np.empty((0, 3, 3)), *found])
    if count and not len(triangles):
        raise ValueError("none of its triangles can be read")
    return triangles


def _place_meshes(scene: Any) -> list[tuple[Array, Any]]:
    """Transform (4, 4) and mesh of each node that has triangles."""
    placed = []
    for node in scene.graph.nodes_geometry:
        transform, name = scene.graph[node]
        mesh = scene.geometry[name]
        if hasattr(mesh, "faces"):
            placed.append((np.asarray(transform, dtype=float), mesh))
    return placed


def _document(data: bytes) -> Any:
    """The JSON of a file."""
    if data[:4] == b"glTF":
        try:
            _, version, length, size, kind = struct.unpack_from("<4sIIII", data)
        except struct.error as error:
            raise ValueError("it is cut off") from error
        if version != 2 or length > len(data) or kind != 0x4E4F534A:
            raise ValueError("it is cut off, or not version 2")
        data = data[20 : 20 + size]
    try:
        return parsed(data)
    except (ValueError, RecursionError) as error:
        raise ValueError(f"its JSON cannot be read ({error})") from error


def _count_primitives(document: Any) -> int:
    """The number of primitives with triangles."""
    if not isinstance(document, dict):
        raise ValueError("its JSON is not an object")
    for name in _list_of(document, "extensionsRequired"):
        if not str(name).startswith(HARMLESS):
            raise ValueError(f"it needs the extension {name}, which is not read")
    if "EXT_mesh_gpu_instancing" in _list_of(document, "extensionsUsed"):
        raise ValueError("it uses the extension EXT_mesh_gpu_instancing, which is not read")
    if any(isinstance(each, dict) and "sparse" in each for each in _list_of(document, "accessors")):
        raise ValueError("it has sparse accessors, which are not read")
    if document.get("skins"):
        raise ValueError("it has skins, which are not read")
    count, corners = 0, 0
    for mesh in _list_of(document, "meshes"):
        if not isinstance(mesh, dict):
            raise ValueError("one of its meshes is not an object")
        for primitive in _list_of(mesh, "primitives"):
            mode = primitive.get("mode", TRIANGLES[0]) if isinstance(primitive, dict) else None
            if isinstance(primitive, dict) and primitive.get("targets"):
                raise ValueError("it has morph targets, which are not read")
            if mode not in (*LINES, *TRIANGLES):
                raise ValueError(f"it has primitives of mode {mode!r}; triangles (4) and strips (5) are read")
            count += mode in TRIANGLES
            if mode in TRIANGLES:
                corners += _corners(document, primitive)
    check_count(corners // 3)
    return count


def _corners(document: dict[str, Any], primitive: Any) -> int:
    """The number of corners of a primitive's triangles; raises ValueError for positions that are not floats, or not there."""
    attributes = primitive.get("attributes") if isinstance(primitive, dict) else None
    if not isinstance(attributes, dict) or "POSITION" not in attributes:
        raise ValueError("it has a primitive without POSITION")
    positions = _accessor(document, attributes["POSITION"])
    if positions.get("componentType") != FLOAT or positions.get("type") != "VEC3":
        raise ValueError(f"it has positions of the component type {positions.get('componentType')!r}: only floats are read")
    indices = _accessor(document, primitive["indices"]) if "indices" in primitive else positions
    return max(int(positions["count"]), int(indices["count"]))


def _accessor(document: dict[str, Any], index: Any) -> dict[str, Any]:
    """An accessor by its number; raises ValueError for one without numbers in the file."""
    accessors, views = _list_of(document, "accessors"), _list_of(document, "bufferViews")
    if type(index) is not int or not 0 <= index < len(accessors) or not isinstance(accessors[index], dict):
        raise ValueError(f"it has no accessor {index!r}")
    accessor: dict[str, Any] = accessors[index]
    view, count = accessor.get("bufferView"), accessor.get("count")
    if type(view) is not int or not 0 <= view < len(views) or not isinstance(views[view], dict):
        raise ValueError(f"its accessor {index} has no bufferView")
    length = views[view].get("byteLength")
    if type(count) is not int or type(length) is not int or not 0 <= count <= length:
        raise ValueError(f"its accessor {index} has {count!r} elements in {length!r} bytes")
    return accessor


def _list_of(holder: dict[str, Any], name: str) -> list[Any]:
    found = holder.get(name, [])
    if not isinstance(found, list):
        raise ValueError(f"its {name} is not a list")
    return found
