"""A URDF as Pinocchio's model, by urdfdom, which sees links and joints alone; and its bodies as Pinocchio's geometry."""

import logging
import xml.etree.ElementTree as ET
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TypeVar

import coal
import numpy as np
import pinocchio as pin

from manipplan.robots.formats.urdf_check import (
    ATTRIBUTES,
    INERTIA,
    LARGEST_LIMIT,
    TYPES,
    body_fault,
    ends_of,
    is_empty,
    shapes_of,
)
from manipplan.robots.formats.urdf_files import UrdfFiles
from manipplan.robots.formats.xml_files import numbers
from manipplan.robots.hulls import FARTHEST
from manipplan.robots.meshes.files import read_mesh, triangle_tree, welded
from manipplan.support.checks import Array
from manipplan.support.errors import FileFormatError

log = logging.getLogger("manipplan")

T = TypeVar("T")

#: Colour of a visual body without a material, as Pinocchio has it.
PLAIN = (0.9, 0.9, 0.9, 1.0)


def build_model(file: Path, root: ET.Element) -> pin.Model:
    """Pinocchio's model of a URDF that `check_urdf` accepts.

    urdfdom gets links, joints and their numbers alone, each number written anew: it prints what it cannot read.
    """
    plain = ET.Element("robot", name=str(root.get("name")))
    for link in root.findall("link"):
        copy = ET.SubElement(plain, "link", name=str(link.get("name")))
        for inertial in link.findall("inertial"):
            inner = ET.SubElement(copy, "inertial")
            _add(inner, inertial, "origin", {"xyz": 3, "rpy": 3})
            _add(inner, inertial, "mass", {"value": 1})
            _add(inner, inertial, "inertia", dict.fromkeys(INERTIA, 1))
    for joint in root.findall("joint"):
        copy = ET.SubElement(plain, "joint", name=str(joint.get("name")), type=str(joint.get("type")))
        parent, child = ends_of(joint)
        ET.SubElement(copy, "parent", link=parent)
        ET.SubElement(copy, "child", link=child)
        _add(copy, joint, "origin", {"xyz": 3, "rpy": 3})
        if joint.get("type") in TYPES[:4]:
            _add(copy, joint, "axis", {"xyz": 3})
        if joint.get("type") in TYPES[:3]:
            _add(copy, joint, "limit", dict.fromkeys(ATTRIBUTES["limit"], 1))
            _add(copy, joint, "dynamics", {"damping": 1, "friction": 1})
    for kind, meaning in (("effort", "no limit"), ("velocity", "0")):
        found = [(str(joint.get("name")), limit) for joint in plain.findall("joint") for limit in joint.findall("limit")]
        below = [(name, limit) for name, limit in found if float(limit.get(kind, "0")) < 0]
        if below:
            joints = ", ".join(f"{name} ({limit.get(kind)})" for name, limit in below)
            log.warning("%s: %s limits below zero count as %s: joint %s", file, kind, meaning, joints)
        for _, limit in below:
            limit.set(kind, "0")
    text = ET.tostring(plain, encoding="unicode")
    return pinocchio_says(file, "a URDF", lambda: pin.buildModelFromXML(text))


def _add(copy: ET.Element, original: ET.Element, tag: str, sizes: dict[str, int]) -> None:
    """Add the numbers of an element that `original` has, in full precision; those that are not numbers are left out."""
    element = original.find(tag)
    if element is not None:
        values = {name: numbers(element.get(name), size, largest=LARGEST_LIMIT) for name, size in sizes.items()}
        texts = {name: " ".join(map(repr, value)) for name, value in values.items() if value is not None}
        if texts:
            ET.SubElement(copy, tag, texts)


def build_bodies(
    file: Path, root: ET.Element, model: pin.Model, files: UrdfFiles, kind: str = "collision"
) -> pin.GeometryModel:
    """The collision or visual bodies of a URDF, placed on its model and named `<link>_<k>`, as Pinocchio does it.

    Meshes are in metres: the unit of a COLLADA file and the scale of the URDF are applied, a vertical axis is not, as in RViz.

    Raises FileFormatError for a mesh that is missing, cannot be read or is too large for the robot.
    """
    geometry = pin.GeometryModel()
    frames = {frame.name: k for k, frame in enumerate(model.frames) if frame.type == pin.FrameType.BODY}
    links = sorted(root.findall("link"), key=lambda link: frames[str(link.get("name"))])
    mesh_files = _find_meshes(file, links, files, kind)
    read: dict[Path, Array] = {}
    colours = {each.get("name"): each for each in root.findall("material") if each.find("color") is not None}
    for link in links:
        name = str(link.get("name"))
        index = frames[name]
        frame = model.frames[index]
        for k, element in enumerate(link.findall(kind)):
            [shape] = shapes_of(element)
            if is_empty(shape):
                log.warning("%s: %s element %d of link %s has size 0 and is left out", file, kind, k + 1, name)
                continue
            body = pin.GeometryObject(
                f"{name}_{k}", frame.parentJoint, index, frame.placement * _pose(element.find("origin")), coal.Sphere(1.0)
            )
            if shape.tag == "mesh":
                path = mesh_files[shape.get("filename", "")]
                scale = np.array(numbers(shape.get("scale", "1 1 1"), 3))
                if path not in read:
                    mesh = read_mesh(f"mesh of link {name} in {file}", path)
                    with np.errstate(over="ignore"):  # what becomes inf is refused below
                        read[path] = mesh.unit * mesh.triangles
                body.geometry = _tree(file, body.name, path, read[path], scale)
                body.meshPath, body.meshScale = str(path), scale
            else:
                body.geometry = _primitive(shape)
            _paint(body, element.find("material"), colours)
            geometry.addGeometryObject(body)
    return geometry


def _find_meshes(file: Path, links: Sequence[ET.Element], files: UrdfFiles, kind: str) -> dict[str, Path]:
    """The file of each mesh by its name in the URDF; raises FileFormatError with all that are missing."""
    mesh_files: dict[str, Path] = {}
    missing = dict[str, str]()
    for link in links:
        for mesh in link.iterfind(f"{kind}/geometry/mesh"):
            name = mesh.get("filename", "")
            if name not in mesh_files and name not in missing:
                path = files.mesh_file(file, name)
                if path is None:
                    missing[name] = str(link.get("name"))
                else:
                    mesh_files[name] = path
    if missing:
        listed = ", ".join(f"{name} (link {link})" for name, link in list(missing.items())[:12])
        more = f" and {len(missing) - 12} more" if len(missing) > 12 else ""
        wanted = (
            f"a URDF whose meshes can be found; not found: {listed}{more}. packages= gives the folder of a package, "
            "package_dirs= folders of packages, meshes=False leaves the meshes out"
        )
        raise FileFormatError("file", str(file), wanted)
    return mesh_files


def _pose(origin: ET.Element | None) -> pin.SE3:
    given = origin.attrib if origin is not None else {}
    xyz, rpy = (np.array(numbers(given.get(name, "0 0 0"), 3)) for name in ("xyz", "rpy"))
    return pin.SE3(pin.rpy.rpyToMatrix(rpy), xyz)


def _tree(file: Path, name: str, path: Path, triangles: Array, scale: Array) -> coal.BVHModelOBBRSS:
    """The tree over triangles (t, 3, 3) [m] scaled by (3,); a scale that mirrors them keeps their outward sides."""
    with np.errstate(over="ignore", invalid="ignore"):
        scaled = triangles[:, ::-1] * scale if scale.prod() < 0 else triangles * scale
    if not (np.abs(scaled) <= FARTHEST).all():
        wanted = f"meshes with finite vertices within {FARTHEST:g} m, unlike {path} of {name}"
        raise FileFormatError("file", str(file), wanted)
    if not np.cross(scaled[:, 1] - scaled[:, 0], scaled[:, 2] - scaled[:, 0]).any():
        raise FileFormatError("file", str(file), f"meshes with at least one triangle with an area, unlike {path} of {name}")
    return triangle_tree(*welded(scaled))


def _primitive(shape: ET.Element) -> coal.CollisionGeometry:
    def value(name: str) -> float:
        return float(shape.get(name, ""))

    if shape.tag == "box":
        return coal.Box(*(numbers(shape.get("size"), 3) or ()))
    if shape.tag == "sphere":
        return coal.Sphere(value("radius"))
    kind = coal.Capsule if shape.tag == "capsule" else coal.Cylinder
    return kind(value("radius"), value("length"))


def _paint(body: pin.GeometryObject, material: ET.Element | None, named: dict[str | None, ET.Element]) -> None:
    """Give a body the colour of its material, its own or that of the same name."""
    if material is None:
        return
    own = material.find("color")
    source = material if own is not None else named.get(material.get("name"))
    colour = source.find("color") if source is not None else None
    values = numbers(colour.get("rgba"), 4) if colour is not None else None
    body.overrideMaterial = True
    body.meshColor = np.array(values if values is not None else PLAIN)


def check_visuals(file: Path, root: ET.Element) -> None:
    """Raise FileFormatError for a visual element whose shape cannot be read."""
    for link in root.findall("link"):
        for k, element in enumerate(link.findall("visual"), start=1):
            fault = body_fault(element)
            if fault is not None:
                wanted = f"a URDF whose visual elements can be read; visual element {k} of link {link.get('name')}: {fault}"
                raise FileFormatError("file", str(file), wanted)


def pinocchio_says(file: Path, wanted: str, build: Callable[[], T]) -> T:
    """What `build` returns; raises FileFormatError with Pinocchio's reason."""
    try:
        return build()
    except (ValueError, RuntimeError, IndexError, MemoryError) as error:
        reason = " ".join(str(error).split())[:200]
        raise FileFormatError("file", str(file), f"{wanted}; Pinocchio says: {reason}") from error
