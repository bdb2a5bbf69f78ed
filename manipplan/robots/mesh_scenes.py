"""Mesh files that hold a scene: COLLADA (DAE), with its colours, and glTF, text and binary.

COLLADA is read by hand: pycollada, which trimesh uses, drops what it cannot read and only notes it as an error of the document.
glTF is read by trimesh after a look at what it needs.

What all readers of mesh files share: numbers of a text, counts, and polygons split into triangles.
"""

import struct
import xml.etree.ElementTree as ET
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.robots.xml_files import DEEPEST, read_bounded_xml
from manipplan.support.checks import Array
from manipplan.support.data_files import parsed
from manipplan.support.errors import MissingExtraError

#: Maximum number of corners that are tried in all searches for a next ear; a polygon that crosses itself may have none.
MOST_SEARCHES = 20_000
#: Maximum number of corners of a polygon: the time grows with its square.
MOST_CORNERS = 10_000
#: Maximum number of corners of all concave polygons of one size: each takes some 25 µs.
MOST_CONCAVE = 100_000
#: Maximum number of triangles that are read.
MOST_TRIANGLES = 500_000


def check_count(triangles: int) -> None:
    """Raise ValueError for more triangles, or polygons, than are read, before they are made."""
    if triangles > MOST_TRIANGLES:
        raise ValueError(f"it has {triangles:,} triangles, of at most {MOST_TRIANGLES:,}")


def numbers(text: str, kind: type = float) -> NDArray[Any]:
    """The numbers of a text, (k,), whole ones if `kind` is int. Raises ValueError with the first word that is none."""
    words = text.split()
    if not text.isascii() or "_" in text:  # Python reads ١ and 1_0
        raise ValueError(f"numbers are needed, not {next(word for word in words if not word.isascii() or '_' in word)[:40]!r}")
    return np.array(words, dtype=kind)


def split_polygons(vertices: Array, polygons: Sequence[Sequence[int] | NDArray[Any]]) -> Array:
    """Triangles (t, 3, 3) of polygons, each given by the indices of its corners in `vertices` (v, 3).

    Polygons with fewer than three corners are lines or points and have no triangles.
    """
    sizes = np.array([len(each) for each in polygons], dtype=np.int64)
    if sizes.max(initial=0) > MOST_CORNERS:
        raise ValueError(f"a face with {sizes.max():,} corners, of at most {MOST_CORNERS:,}")
    found = []
    for size in np.unique(sizes[sizes >= 3]):
        corners = vertices[np.array([polygons[k] for k in np.flatnonzero(sizes == size).tolist()], dtype=np.int64)]
        found.append(_triangles(corners))
    return np.concatenate([np.empty((0, 3, 3)), *found])


@np.errstate(over="ignore", invalid="ignore")
def move_triangles(triangles: Array, transform: Array) -> Array:
    """Triangles (t, 3, 3) moved by a transform (4, 4); one that mirrors them keeps their outward sides.

    Corners that become inf or NaN are refused with the mesh.
    """
    moved = triangles @ transform[:3, :3].T + transform[:3, 3]
    return np.asarray(moved[:, ::-1] if np.linalg.det(transform[:3, :3]) < 0 else moved)


@np.errstate(over="ignore", invalid="ignore")
def _triangles(corners: Array) -> Array:
    """Triangles (t, 3, 3) of polygons (k, c, 3) with c corners each. Corners that are too large are refused with the mesh."""
    if corners.shape[1] == 3:
        return corners
    along = np.roll(corners, -1, axis=1) - corners
    normal = np.cross(corners, np.roll(corners, -1, axis=1)).sum(axis=1)
    turns = np.einsum("kci,ki->kc", np.cross(np.roll(along, 1, axis=1), along), normal)
    convex = (turns >= -1e-9 * np.abs(turns).max(axis=1, keepdims=True)).all(axis=1)
    if (~convex).sum() * corners.shape[1] > MOST_CONCAVE:
        raise ValueError(f"concave faces with more than {MOST_CONCAVE:,} corners in all")
    once = np.arange(1, corners.shape[1] - 1)
    fans = [corners[convex][:, [0, k, k + 1]] for k in once]
    ears = [_ears(polygon, n) for polygon, n in zip(corners[~convex], normal[~convex], strict=True)]
    return np.concatenate([*fans, *ears])


def _ears(corners: Array, normal: Array) -> Array:
    """Triangles (c - 2, 3, 3) of one concave polygon (c, 3), by cutting off ears in the plane of `normal` (3,).

    Only corners that turn right can lie in an ear. Of a polygon that crosses itself, any triangles are returned.
    """
    away = int(np.abs(normal).argmax())
    flat = np.delete(corners, away, axis=1) * [1.0, 1.0 if (away == 1) ^ (normal[away] > 0) else -1.0]
    count = len(corners)
    before, after = np.roll(np.arange(count), 1).tolist(), np.roll(np.arange(count), -1).tolist()
    right = np.array([not _turn(flat[before[k]], flat[k], flat[after[k]]) > 0 for k in range(count)])
    left, found, waiting, searches = dict.fromkeys(range(count)), [], list(range(count))[::-1], 0
    while len(left) > 3:
        k = waiting.pop() if waiting else -1
        if k < 0:  # the ears that were found are cut off: others may have become free
            searches += len(left)
            k = next((each for each in left if _is_ear(flat, before[each], each, after[each], right)), -1)
            if k < 0 and searches < MOST_SEARCHES:
                k = next(iter(left))
            elif k < 0:
                rest = list(left)
                found += [[rest[0], rest[j], rest[j + 1]] for j in range(1, len(rest) - 2)]
                left = dict.fromkeys([rest[0], *rest[-2:]])
                break
        elif k not in left or not _is_ear(flat, before[k], k, after[k], right):
            continue
        found.append([before[k], k, after[k]])
        del left[k]
        right[k] = False
        after[before[k]], before[after[k]] = after[k], before[k]
        for each in (before[k], after[k]):
            right[each] = not _turn(flat[before[each]], flat[each], flat[after[each]]) > 0
            waiting.append(each)
    return np.asarray(corners[[*found, list(left)]])


def _is_ear(flat: Array, first: int, k: int, last: int, right: NDArray[np.bool_]) -> bool:
    """Whether corner k of the polygon, between two others, can be cut off: it turns left, and no corner is inside."""
    if right[k]:
        return False
    a, b, c = flat[first], flat[k], flat[last]
    others = flat[right]
    sides = np.array([_turn(p, q, others) for p, q in ((a, b), (b, c), (c, a))])
    inside = others[(sides >= 0).all(axis=0)]
    return bool(all(any((other == corner).all() for corner in (a, b, c)) for other in inside))


def _turn(p: Array, q: Array, r: Array) -> Array:
    """Positive where p, q and r (..., 2) turn left."""
    return np.asarray((q[0] - p[0]) * (r[..., 1] - p[1]) - (q[1] - p[1]) * (r[..., 0] - p[0]))


Indices = NDArray[np.int64]
#: Red, green and blue in [0, 1].
Colour = tuple[float, float, float]
#: The material of triangles (t, 3, 3), and these.
Part = tuple[str | None, Array]

#: Kinds of primitives with an area that are read.
PRIMITIVES = ("triangles", "polylist", "polygons", "tristrips", "trifans")
#: Elements that hold numbers.
NUMBERS = ("p", "vcount", "float_array", "matrix", "translate", "rotate", "scale")
#: Maximum number of nodes that instances of nodes may unfold to.
MOST_NODES = 100_000


def read_collada(argument: str, file: Path) -> tuple[Array, float, str]:
    """Triangles (t, 3, 3) in the root frame, the unit that the file states [m] and its vertical axis.

    Raises ValueError with the fault, or FileFormatError for XML that cannot be read.
    """
    document = _read_document(argument, file)
    up = (document.root.findtext("asset/up_axis") or "").strip().lower().removesuffix("_up")
    parts = [triangles for _, triangles in document.parts()]
    return np.concatenate([np.empty((0, 3, 3)), *parts]), document.unit, up


def read_coloured(argument: str, file: Path) -> list[tuple[Colour | None, Array]]:
    """The triangles (t, 3, 3) [m] of each diffuse colour, in the root frame; None: of those without one, such as textured ones.

    Raises as `read_collada`.
    """
    document = _read_document(argument, file)
    by_colour: dict[Colour | None, list[Array]] = {}
    for material, triangles in document.parts():
        by_colour.setdefault(document.colour_of(material), []).append(triangles)
    return [(colour, document.unit * np.concatenate(some)) for colour, some in by_colour.items()]


def _read_document(argument: str, file: Path) -> "_Document":
    root = read_bounded_xml(argument, file)
    for element in root.iter():
        element.tag = element.tag.rpartition(":")[2]
        if element.tag in NUMBERS and len(element):
            raise ValueError(f"<{element.tag}> needs numbers, not <{element[0].tag}>")
    if root.tag != "COLLADA":
        raise ValueError(f"its root is <{root.tag}>")
    return _Document(root)


class _Document:
    """The elements of a file by their id."""

    def __init__(self, root: ET.Element) -> None:
        self.root = root
        self.by_id = {str(each.get("id")): each for each in root.iter() if each.get("id") is not None}
        self.meshes: dict[ET.Element, list[Part]] = {}
        self.nodes = 0
        self.found: list[Part] = []
        unit = root.find("asset/unit")
        self.unit = float(unit.get("meter", "1")) if unit is not None else 1.0
        if not 0.0 < self.unit < np.inf:
            raise ValueError(f"its unit is {self.unit:g} m")

    def parts(self) -> list[Part]:
        """The triangles of the scene with their materials; without a scene, of all geometries as they are."""
        instance = self.root.find("scene/instance_visual_scene")
        if instance is None:
            self.found = [part for each in self.root.findall("library_geometries/geometry") for part in self._mesh(each)]
        else:
            for node in self._find_named(instance.get("url"), "visual_scene").findall("node"):
                self._add(node, np.eye(4), 0)
        return self.found

    def colour_of(self, material: str | None) -> Colour | None:
        """The diffuse colour of a material, its id; None where it has none."""
        found = self.by_id.get(str(material))
        link = found.find("instance_effect") if found is not None else None
        effect = self.by_id.get(str(link.get("url")).removeprefix("#")) if link is not None else None
        diffuse = next((each for each in effect.iter("diffuse")), None) if effect is not None else None
        text = diffuse.findtext("color") if diffuse is not None else None
        values = numbers(text or "")
        if len(values) != 4 or not ((values >= 0) & (values <= 1)).all():
            return None
        red, green, blue, _ = values.tolist()
        return red, green, blue

    def _find_named(self, url: str | None, tag: str) -> ET.Element:
        element = self.by_id.get(str(url).removeprefix("#"))
        if element is None or element.tag != tag:
            raise ValueError(f"it refers to a {tag} {url}, which is not there")
        return element

    def _add(self, node: ET.Element, parent: Array, depth: int) -> None:
        self.nodes += 1
        if self.nodes > MOST_NODES or depth > DEEPEST:
            raise ValueError(f"more than {MOST_NODES} nodes, nodes nested deeper than {DEEPEST}, or a node inside itself")
        transform = parent @ _transform(node)
        for child in node:
            if child.tag == "instance_geometry":
                bound = {str(each.get("symbol")): str(each.get("target")) for each in child.iter("instance_material")}
                for symbol, mesh in self._mesh(self._find_named(child.get("url"), "geometry")):
                    material = bound.get(str(symbol), str(symbol)).removeprefix("#")
                    self.found.append((material, move_triangles(mesh, transform)))
            elif child.tag == "instance_node":
                self._add(self._find_named(child.get("url"), "node"), transform, depth + 1)
            elif child.tag == "node":
                self._add(child, transform, depth + 1)
            elif child.tag == "instance_controller":
                raise ValueError("it has skins or morphs, which are not read")

    def _mesh(self, geometry: ET.Element) -> list[Part]:
        """The triangles of each primitive of a geometry, in its own frame, with the symbol of its material."""
        if geometry not in self.meshes:
            mesh = geometry.find("mesh")
            if mesh is None:
                raise ValueError("it has a <geometry> without <mesh>, which is not read")
            primitives = [each for each in mesh if each.tag in PRIMITIVES]
            self.meshes[geometry] = [(each.get("material"), self._primitive(each)) for each in primitives]
        return self.meshes[geometry]

    def _primitive(self, primitive: ET.Element) -> Array:
        inputs = primitive.findall("input")
        offsets = [int(each.get("offset", "0")) for each in inputs]
        vertex = next((each for each in inputs if each.get("semantic") == "VERTEX"), None)
        if [each.get("semantic") for each in inputs].count("VERTEX") != 1 or vertex is None or min(offsets) < 0:
            raise ValueError(f"<{primitive.tag}> without one input of VERTEX")
        vertices = self._positions(self._find_named(vertex.get("source"), "vertices"))
        if primitive.find("ph") is not None:
            raise ValueError("it has polygons with holes (<ph>), which are not read")
        lists = []
        for text in (each.text for each in primitive.findall("p")):
            values = numbers(text or "", int)
            if len(values) % (max(offsets) + 1):
                raise ValueError(f"<p> of <{primitive.tag}> is cut off")
            lists.append(values.reshape(-1, max(offsets) + 1)[:, int(vertex.get("offset", "0"))])
        corners = np.concatenate([np.empty(0, dtype=int), *lists])
        if len(corners) and not 0 <= corners.min() <= corners.max() < len(vertices):
            raise ValueError(f"<{primitive.tag}> names a vertex outside 0 to {len(vertices) - 1}")
        return split_polygons(vertices, _polygons(primitive, lists))

    def _positions(self, vertices: ET.Element) -> Array:
        """Positions (v, 3) of <vertices>."""
        for each in vertices.findall("input"):
            if each.get("semantic") == "POSITION":
                source = self._find_named(each.get("source"), "source")
                values = numbers(source.findtext("float_array") or "")
                accessor = source.find("technique_common/accessor")
                given = accessor.attrib if accessor is not None else {}
                named = [each.get("name", "").upper() for each in accessor.findall("param")] if accessor is not None else []
                array = source.find("float_array")
                held = array is not None and given.get("source", "#").removeprefix("#") in ("", array.get("id", ""))
                if not held or named[:3] not in ([], ["X", "Y", "Z"]):
                    raise ValueError(f"the accessor of {each.get('source')} is not one of X, Y, Z in its own numbers")
                stride, first = int(given.get("stride", "3")), int(given.get("offset", "0"))
                count = int(given.get("count", str(len(values) // max(stride, 1))))
                if stride < 3 or first < 0 or count < 0 or first + count * stride > len(values):
                    raise ValueError(f"the accessor of {each.get('source')} does not fit its numbers")
                return values[first : first + count * stride].reshape(count, stride)[:, :3]
        raise ValueError("<vertices> without positions")


def _polygons(primitive: ET.Element, lists: list[Indices]) -> list[Indices]:
    """Corners of each polygon of a primitive, from its lists of indices."""
    if primitive.tag == "polygons":
        return lists
    if primitive.tag == "tristrips":
        return [row[[k, k + 1, k + 2] if k % 2 == 0 else [k + 1, k, k + 2]] for row in lists for k in range(len(row) - 2)]
    if primitive.tag == "trifans":
        return [row[[0, k, k + 1]] for row in lists for k in range(1, len(row) - 1)]
    [row] = lists or [np.empty(0, dtype=int)]
    if primitive.tag == "polylist":
        sizes = numbers(primitive.findtext("vcount") or "", int)
        if sizes.sum() != len(row) or (sizes < 0).any():
            raise ValueError("<vcount> of <polylist> does not fit <p>")
        return np.split(row, np.cumsum(sizes)[:-1]) if len(sizes) else []
    if len(row) % 3:
        raise ValueError("<p> of <triangles> is cut off")
    return list(row.reshape(-1, 3))


def _transform(node: ET.Element) -> Array:
    """The transform (4, 4) of a node in its parent: its elements one after the other."""
    transform = np.eye(4)
    sizes = {"matrix": 16, "translate": 3, "rotate": 4, "scale": 3, "lookat": 9, "skew": 7}
    for child in node:
        if child.tag not in sizes:
            continue
        values = numbers(child.text or "")
        if len(values) != sizes[child.tag] or not np.isfinite(values).all():
            raise ValueError(f"<{child.tag}> with {len(values)} finite numbers instead of {sizes[child.tag]}")
        step = np.eye(4)
        if child.tag == "matrix":
            step = values.reshape(4, 4)
            if not np.array_equal(step[3], [0.0, 0.0, 0.0, 1.0]):
                raise ValueError("a <matrix> whose last row is not 0 0 0 1")
        elif child.tag == "translate":
            step[:3, 3] = values
        elif child.tag == "scale":
            step[:3, :3] = np.diag(values)
        elif child.tag == "rotate":
            step[:3, :3] = _rotation(values[:3], np.deg2rad(values[3]))
        else:
            raise ValueError(f"a transform <{child.tag}>, which is not read")
        transform = transform @ step
    return transform


def _rotation(axis: Array, angle: float) -> Array:
    """The rotation by an angle [rad] about an axis (3,)."""
    length = np.linalg.norm(axis)
    if not length > 0:
        raise ValueError("a rotation about an axis of length zero")
    return np.asarray(pin.AngleAxis(angle, axis / length).toRotationMatrix())


#: Extensions that say nothing about the shape.
HARMLESS = ("KHR_materials", "KHR_texture", "KHR_lights", "EXT_texture", "EXT_lights")
#: Modes of a primitive: points and lines have no triangles; 4, the default, are triangles, 5 are strips of them.
LINES, TRIANGLES = (0, 1, 2, 3), (4, 5)
#: Component type of floats.
FLOAT = 5126


def read_gltf(file: Path) -> Array:
    """Triangles (t, 3, 3) of the default scene, in its root frame; raises MissingExtraError without trimesh.

    Raises ValueError where the file is not valid, or needs an extension or a kind of primitive that is not read.
    """
    count = _count_primitives(_document(file.read_bytes()))
    try:
        import trimesh
    except ImportError as error:
        raise MissingExtraError("trimesh", "mesh") from error
    found = [np.empty((0, 3, 3))]
    try:
        scene = trimesh.load_scene(file, process=False)
        for transform, name in map(scene.graph.get, scene.graph.nodes_geometry):
            mesh = scene.geometry[name]
            if hasattr(mesh, "faces"):
                corners = np.asarray(mesh.vertices, dtype=float)[np.asarray(mesh.faces)]
                found.append(move_triangles(corners, np.asarray(transform, dtype=float)))
    except Exception as error:  # trimesh raises whatever happens to it on a broken file
        raise ValueError(f"trimesh says: {type(error).__name__}: {error}") from error
    triangles = np.concatenate(found)
    if count and not len(triangles):
        raise ValueError("none of its triangles can be read")
    return triangles


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
