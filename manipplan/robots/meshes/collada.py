"""COLLADA files (DAE): the triangles of their visual scene, and their colours.

By hand: pycollada, which trimesh uses, drops what it cannot read and only notes it as an error of the document.
"""

import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from manipplan.robots.formats.xml_files import DEEPEST, read_bounded_xml
from manipplan.robots.meshes.polygons import move_triangles, numbers, split_polygons
from manipplan.support.checks import Array

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
    x, y, z = axis / length
    K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.asarray(np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K)
