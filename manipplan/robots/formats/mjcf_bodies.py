"""Checks on the bodies of an MJCF file: Pinocchio leaves out elements that it does not know, and reads missing numbers from
uninitialised memory.
"""

import tempfile
import xml.etree.ElementTree as ET
from collections import Counter
from collections.abc import Iterator, Mapping
from pathlib import Path

import pinocchio as pin

from manipplan.robots.formats.xml_files import MOST_BODIES, MOST_JOINTS, numbers
from manipplan.support.errors import FileFormatError

#: Elements with bodies or geoms in them that Pinocchio leaves out.
LEFT_OUT = ("include", "frame", "replicate", "composite", "flexcomp", "attach")
#: Number of values of each attribute, in the elements of `PLACED`.
COUNTS = {
    "pos": 3,
    "quat": 4,
    "euler": 3,
    "axisangle": 4,
    "xyaxes": 6,
    "zaxis": 3,
    "fromto": 6,
    "axis": 3,
    "range": 2,
    "mass": 1,
    "diaginertia": 3,
    "fullinertia": 6,
    "scale": 3,
}
PLACED = ("body", "geom", "joint", "inertial", "mesh")
#: Number of sizes that each shape needs; one where `fromto` gives its length.
SIZES = {"sphere": 1, "capsule": 2, "cylinder": 2, "box": 3, "ellipsoid": 3}
#: Maximum number of joints of one body, as in MuJoCo: the memory that Pinocchio takes for them grows without bounds.
BODY_JOINTS = 6

#: Formats of meshes; by the contents of a file with another name the mesh loader would choose one of its many other formats.
MESHES = (".stl", ".obj")

Attributes = Mapping[str, str]


def check_bodies(file: Path, root: ET.Element) -> None:
    """Raise FileFormatError for the first element that would be left out or misread; the message names it."""
    for element in root.iter():
        if element.tag in LEFT_OUT:
            raise _error(file, f"<{element.tag}> is not supported, its contents would be left out: expand it with MuJoCo")
        for attribute, count in COUNTS.items() if element.tag in PLACED else ():
            value = element.get(attribute)
            if value is not None and numbers(value, count) is None:
                wanted = f"{count} finite numbers" if count > 1 else "a finite number"
                raise _error(file, f"{_called(element)} needs {attribute} with {wanted}, not {value!r}")
        joints = len(element.findall("joint")) if element.tag == "body" else 0
        if joints > BODY_JOINTS:
            raise _error(file, f"at most {BODY_JOINTS} joints in {_called(element)}, not {joints}")
        if element.tag == "default":
            twice = [tag for tag, count in Counter(each.tag for each in element).items() if count > 1 and tag != "default"]
            if twice:
                raise _error(file, f"<default> with each element once, not several <{twice[0]}>")
        if element.tag == "mesh" and not element.get("file", MESHES[0]).lower().endswith(MESHES):
            raise _error(file, f"collision meshes are {', '.join(MESHES)} files, unlike {element.get('file')}")
    for tag in ("body", "joint", "default"):
        count = sum(1 for _ in root.iter(tag))
        if count > MOST_JOINTS:
            raise _error(file, f"at most {MOST_JOINTS} <{tag}>, not {count}")
    if len(root.findall("worldbody")) != 1:
        raise _error(file, f"one <worldbody>, not {len(root.findall('worldbody'))}")
    first = root.findall("worldbody/body")
    if len(first) > 1:
        raise _error(file, f"one <body> in <worldbody>, not {len(first)}: Pinocchio leaves out all but the first")
    colliding = [each for each in _geoms(root) if _collides(each[2])]
    if len(colliding) > MOST_BODIES:
        raise _error(file, f"at most {MOST_BODIES} colliding geoms, not {len(colliding)}")
    for body, geom, attributes in colliding:
        fault = _size_fault(attributes)
        if fault is not None:
            raise _error(file, f"{_called(geom)} of {body}: {fault}")


def check_loaded(file: Path, root: ET.Element, model: pin.Model, geometry: pin.GeometryModel) -> None:
    """Raise FileFormatError when a body does not have as many collision shapes as colliding geoms in the file."""
    loaded = Counter(model.frames[item.parentFrame].name for item in geometry.geometryObjects)
    described = Counter(body for body, _, attributes in _geoms(root) if _collides(attributes))
    for body in described | loaded:
        if loaded[body] != described[body]:
            hint = "" if body else "; give the body a name"
            fault = f"{described[body]} in the file, {loaded[body]} loaded{hint}"
            raise _error(file, f"the collision geoms of body {body!r}: {fault}")


def root_pose(root: ET.Element) -> pin.SE3:
    """The pose of the only body of the world if no joint moves it, otherwise the identity: Pinocchio leaves that pose out.

    Pinocchio itself reads it, from a copy with one more body around it.
    """
    bodies = [body for world in root.findall("worldbody") for body in world.findall("body")]
    if len(bodies) != 1 or any(bodies[0].find(joint) is not None for joint in ("joint", "freejoint")):
        return pin.SE3.Identity()
    copied = ET.Element("mujoco")
    copied.extend(root.findall("compiler"))
    around = ET.SubElement(ET.SubElement(copied, "worldbody"), "body", name="around")
    ET.SubElement(
        around, "body", {key: value for key, value in bodies[0].attrib.items() if key != "childclass"} | {"name": "root"}
    )
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "root.xml"
        ET.ElementTree(copied).write(file)
        model = pin.buildModelFromMJCF(str(file))
    return model.frames[model.getFrameId("root")].placement


def _error(file: Path, fault: str) -> FileFormatError:
    return FileFormatError("file", str(file), f"an MJCF file whose bodies can all be read; {fault}")


def _called(element: ET.Element) -> str:
    return f"<{element.tag} name={element.get('name')!r}>" if element.get("name") else f"<{element.tag}>"


def _geoms(root: ET.Element) -> Iterator[tuple[str, ET.Element, Attributes]]:
    """Body name, element, and attributes with defaults of every geom."""
    defaults = _geom_defaults(root)
    bodies = [("universe", world, "") for world in root.findall("worldbody")]
    while bodies:
        name, body, usual = bodies.pop()
        usual = body.get("childclass", usual)
        for geom in body.findall("geom"):
            yield name, geom, {**defaults.get(geom.get("class", usual), {}), **geom.attrib}
        bodies += [(child.get("name", ""), child, usual) for child in body.findall("body")]


def _geom_defaults(root: ET.Element) -> dict[str, Attributes]:
    """Default attributes of the geoms of each class; "" is the class of geoms without one."""
    classes: dict[str, Attributes] = {}
    waiting: list[tuple[ET.Element, Attributes, str]] = [(each, {}, "") for each in root.findall("default")]
    while waiting:
        element, above, name = waiting.pop()
        own = dict(above)
        for geom in element.findall("geom"):
            own |= geom.attrib
        classes[name] = classes[element.get("class", name)] = own
        waiting += [(child, own, child.get("class", name)) for child in element.findall("default")]
    return classes


def _collides(attributes: Attributes) -> bool:
    return any(numbers(attributes.get(key, "1"), 1) != (0.0,) for key in ("contype", "conaffinity"))


def _size_fault(attributes: Attributes) -> str | None:
    count = 1 if "fromto" in attributes else SIZES.get(attributes.get("type", "sphere"), 0)
    text = attributes.get("size", "")
    sizes = numbers(text, max(count, len(text.split())))
    if count and (sizes is None or min(sizes[:count]) <= 0):
        return f"it needs a size with {count} number{'s' if count > 1 else ''} above zero, not {text!r}"
    return None
