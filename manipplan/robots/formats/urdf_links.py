"""Checks on the links of a URDF: when urdfdom cannot read one body of a link it drops all of them, and only prints a line on
the terminal.
"""

import xml.etree.ElementTree as ET
from collections import Counter
from pathlib import Path

import pinocchio as pin

from manipplan.robots.formats.xml_files import MOST_BODIES, MOST_JOINTS, numbers
from manipplan.support.errors import FileFormatError

#: Attributes of each shape, with the number of values of each.
SHAPES = {"box": {"size": 3}, "sphere": {"radius": 1}, "cylinder": {"radius": 1, "length": 1}, "mesh": {}}
INERTIA = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")


def check_links(file: Path, root: ET.Element) -> None:
    """Raise FileFormatError for the first place of a joint, collision or inertial element that is not valid.

    The message names the joint or link, the element and its fault.
    """
    bodies = len(root.findall("link/collision"))
    if bodies > MOST_BODIES:
        raise FileFormatError("file", str(file), f"a URDF with at most {MOST_BODIES} collision elements, not {bodies}")
    joints = root.findall("joint")
    if len(joints) > MOST_JOINTS:
        raise FileFormatError("file", str(file), f"a URDF with at most {MOST_JOINTS} joints, not {len(joints)}")
    for joint in joints:
        _raise(file, f"joint {joint.get('name')}", _origin_fault(joint) or _axis_fault(joint))
    for link in root.findall("link"):
        name = link.get("name")
        for k, element in enumerate(link.findall("collision"), start=1):
            _raise(file, f"collision element {k} of link {name}", _collision_fault(element))
        for element in link.findall("inertial"):
            _raise(file, f"the inertial element of link {name}", _inertial_fault(element))


def check_loaded(file: Path, root: ET.Element, model: pin.Model, geometry: pin.GeometryModel) -> None:
    """Raise FileFormatError when a link does not have as many collision bodies as collision elements in the file."""
    loaded = Counter(model.frames[item.parentFrame].name for item in geometry.geometryObjects)
    for link in root.findall("link"):
        name, described = str(link.get("name")), len(link.findall("collision"))
        if loaded[name] != described:
            fault = f"{described} in the file, {loaded[name]} loaded; one of them, or a visual element, is not valid URDF"
            _raise(file, f"the collision elements of link {name}", fault)


def _raise(file: Path, where: str, fault: str | None) -> None:
    if fault is not None:
        raise FileFormatError("file", str(file), f"a URDF whose links and joints can all be read; {where}: {fault}")


def _collision_fault(collision: ET.Element) -> str | None:
    fault = _origin_fault(collision)
    if fault is not None:
        return fault
    geometries = collision.findall("geometry")
    if len(geometries) != 1 or len(geometries[0]) != 1:
        return "it needs one <geometry> with one shape"
    shape = geometries[0][0]
    if shape.tag not in SHAPES:
        return f"<{shape.tag}> is not a shape of URDF ({', '.join(SHAPES)})"
    for attribute, count in SHAPES[shape.tag].items():
        values = numbers(shape.get(attribute), count)
        if values is None or min(values) <= 0:
            wanted = f"{count} numbers" if count > 1 else "a number"
            return f"<{shape.tag}> needs {attribute} with {wanted} above zero, not {shape.get(attribute)!r}"
    if shape.tag == "mesh":
        if not shape.get("filename"):
            return "<mesh> needs a filename"
        scale = numbers(shape.get("scale", "1 1 1"), 3)
        if scale is None or 0.0 in scale:
            return f"<mesh> needs a scale with 3 numbers other than zero, not {shape.get('scale')!r}"
    return None


def _inertial_fault(inertial: ET.Element) -> str | None:
    fault = _origin_fault(inertial)
    if fault is not None:
        return fault
    mass, inertia = inertial.find("mass"), inertial.find("inertia")
    if mass is None or numbers(mass.get("value"), 1) is None:
        return f"<mass> needs a value with a number, not {None if mass is None else mass.get('value')!r}"
    if inertia is None:
        return "it needs an <inertia>"
    for attribute in INERTIA:
        if numbers(inertia.get(attribute), 1) is None:
            return f"<inertia> needs {attribute} with a number, not {inertia.get(attribute)!r}"
    return None


def _axis_fault(joint: ET.Element) -> str | None:
    for axis in joint.findall("axis"):
        if axis.get("xyz") is not None and numbers(axis.get("xyz"), 3) is None:
            return f"<axis> needs xyz with 3 numbers, not {axis.get('xyz')!r}"
    return None


def _origin_fault(element: ET.Element) -> str | None:
    origins = element.findall("origin")
    if len(origins) > 1:
        return "it has more than one <origin>"
    for origin in origins:
        for attribute in ("xyz", "rpy"):
            if numbers(origin.get(attribute, "0 0 0"), 3) is None:
                return f"<origin> needs {attribute} with 3 numbers, not {origin.get(attribute)!r}"
    return None
