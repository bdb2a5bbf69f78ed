"""A URDF as Pinocchio's model, by urdfdom, which sees links and joints alone; and its bodies as Pinocchio's geometry.

What a URDF must be before urdfdom reads it, which passes over misspelt names and what it cannot read, or prints its reasons:
every element and attribute that moves a link, limits a joint or shapes a body is known here; a name that resembles one of them
is refused. What other programs write into a URDF is passed over.
"""

import difflib
import logging
import math
import sys
import xml.etree.ElementTree as ET
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from pathlib import Path
from typing import TypeVar

import coal
import numpy as np
import pinocchio as pin

from manipplan.robots.hulls import FARTHEST
from manipplan.robots.mesh_files import read_mesh, triangle_tree, welded
from manipplan.robots.model_tree import WORLD
from manipplan.robots.urdf_files import UrdfFiles
from manipplan.robots.xml_files import DEEPEST, LARGEST, MOST_BODIES, MOST_JOINTS, numbers
from manipplan.support.checks import Array
from manipplan.support.errors import FileFormatError, UnknownNameError

log = logging.getLogger("manipplan")

#: Attributes of each shape, with the number of values of each.
SHAPES = {
    "box": {"size": 3},
    "sphere": {"radius": 1},
    "cylinder": {"radius": 1, "length": 1},
    "capsule": {"radius": 1, "length": 1},
    "mesh": {},
}
#: Attributes with numbers of other elements, with the number of values of each.
NUMBERS = {
    "origin": {"xyz": 3, "rpy": 3},
    "axis": {"xyz": 3},
    "limit": dict.fromkeys(("lower", "upper", "effort", "velocity"), 1),
    "dynamics": {"damping": 1, "friction": 1},
    "mass": {"value": 1},
    "inertia": dict.fromkeys(("ixx", "ixy", "ixz", "iyy", "iyz", "izz"), 1),
}
#: Kinds of joints; the first three need an axis, and the first two limits.
TYPES = ("revolute", "prismatic", "continuous", "planar", "fixed", "floating")
#: The elements that count in an element. Those of `ONCE` occur at most once.
COUNTED = {
    "robot": ("link", "joint"),
    "link": ("inertial", "collision", "visual"),
    "joint": ("parent", "child", "origin", "axis", "limit", "mimic"),
    "collision": ("origin", "geometry"),
    "inertial": ("origin", "mass", "inertia"),
}
ONCE = ("inertial", "parent", "child", "origin", "axis", "limit", "mimic", "geometry", "mass", "inertia")
#: The attributes of elements in which each one counts, and those that other programs add and that change nothing here.
ATTRIBUTES = {
    **{tag: tuple(NUMBERS[tag]) for tag in ("origin", "axis", "limit")},
    "parent": ("link",),
    "child": ("link",),
    "mimic": ("joint", "multiplier", "offset"),
    "mesh": ("filename", "scale"),
    **{shape: tuple(sizes) for shape, sizes in SHAPES.items() if sizes},
}
ADDED_ATTRIBUTES = {
    "axis": ("rpy",),
    "limit": (
        *("acceleration", "deceleration", "jerk", "command_effort", "current", "gear_velocity"),
        *("k_position", "k_velocity", "soft_lower_limit", "soft_upper_limit"),
    ),
}
#: Elements of other programs and of URDF itself that change neither motion nor collision: passed over, also by the log.
PASSED = {
    "robot": (
        *("material", "gazebo", "transmission", "ros2_control", "sensor", "mujoco", "frame", "force_element", "cable"),
        *("bullet", "collision_filter_group", "self_collision_checking", "collision_checking", "gripper", "group"),
        "parameter",
    ),
    "link": (
        *("contact", "self_collision_checking", "collision_checking", "gravity", "kinematic", "surface", "self_filter"),
        *("sensor", "material", "gazebo", "selfCollide", "audio_source", "bullet"),
    ),
    "joint": ("dynamics", "calibration", "safety_controller", "controller_gains", "joint_properties", "traits", "anchor"),
    "collision": ("material", "verbose", "surface", "contact", "contact_coefficients", "max_contacts"),
    "inertial": (),
}
#: Share of letters in common from which a name counts as a misspelt one, as difflib counts it.
NEAR = 0.75
#: Angles between these are probably degrees: eight half turns in radians, four turns in degrees. What is larger means no limit.
MOST_RADIANS, MOST_DEGREES = 8 * math.pi, 1440.0
#: Fastest plausible speed of a joint [rad/s]; 100 is common where there is no limit.
MOST_SPEED = 100.0
#: Share of a turn by which a limit of whole turns may differ from it: it is no angle in degrees.
WHOLE = 1e-3
#: Largest limit of a joint; some files write 1e16 where there is none.
LARGEST_LIMIT = sys.float_info.max
#: Smallest length of an axis, along its longest coordinate.
SMALLEST_AXIS = 1e-9


def check_urdf(file: Path, root: ET.Element) -> None:
    """Raise FileFormatError for the first fault of a URDF; the message names the link or joint, the value and what is allowed.

    Elements that are passed over without being known are named in the log.
    """
    links, joints = root.findall("link"), root.findall("joint")
    if not links:
        hint = "; this one has none, as a file of macros: give the file that includes it" if file.suffix == ".xacro" else ""
        raise FileFormatError("file", str(file), f"a URDF with at least one <link>{hint}")
    if not root.get("name"):
        raise FileFormatError("file", str(file), "a URDF whose <robot> has a name")
    strange = _check_elements(file, root, "<robot>")
    bodies = len(root.findall("link/collision"))
    if bodies > MOST_BODIES:
        raise FileFormatError("file", str(file), f"a URDF with at most {MOST_BODIES} collision elements, not {bodies}")
    if len(joints) > MOST_JOINTS:
        raise FileFormatError("file", str(file), f"a URDF with at most {MOST_JOINTS} joints, not {len(joints)}")
    _check_names(file, "link", links)
    _check_names(file, "joint", joints)
    if any(joint.get("name") == WORLD for joint in joints):
        raise FileFormatError("file", str(file), f"joints with other names than {WORLD!r}, Pinocchio's name for the world")
    degrees, one_sided, fast = list[str](), list[str](), list[str]()
    places = [(joint, f"joint {joint.get('name')}") for joint in joints]
    for link in links:
        name = link.get("name")
        places += [(link, f"link {name}")]
        places += [(each, f"collision element {k} of link {name}") for k, each in enumerate(link.findall("collision"), start=1)]
        places += [(each, f"the inertial element of link {name}") for each in link.findall("inertial")]
    for element, where in places:
        strange |= _check_elements(file, element, where)
        _raise(file, where, _origin_fault(element) or FAULTS[element.tag](element))
        degrees += _degrees(where, element) if element.tag != "inertial" else []
        one_sided += _one_sided(where, element)
        fast += _fast(where, element)
    for what, found in (
        ("elements that URDF does not have are passed over:", ", ".join(sorted(strange)[:12])),
        ("angles in a URDF are in radians; these look like degrees:", "; ".join(degrees[:12])),
        (f"speeds above {MOST_SPEED:g} rad/s are in degrees per second, or stand for no limit:", "; ".join(fast[:12])),
        ("a URDF's limit that is not given is 0, here of", "; ".join(one_sided[:12])),
    ):
        if found:
            log.warning("%s: %s %s", file, what, found)
    _check_tree(file, {str(link.get("name")) for link in links}, joints)


def _degrees(where: str, element: ET.Element) -> list[str]:
    """The angles of a joint or a body that are probably degrees, each with the place where it is."""
    texts = [("rpy", text) for origin in element.findall("origin") if (text := origin.get("rpy"))]
    if element.get("type") == "revolute":
        texts += [(name, text) for each in element.findall("limit") for name in ("lower", "upper") if (text := each.get(name))]
    return [
        f'{where}: {name}="{text}"'
        for name, text in texts
        if any(_looks_like_degrees(angle) for angle in numbers(text, len(text.split())) or ())
    ]


def _looks_like_degrees(angle: float) -> bool:
    """Whether an angle is large in radians, not in degrees, and no whole number of turns."""
    turns = angle / (2 * math.pi)
    return MOST_RADIANS < abs(angle) <= MOST_DEGREES and abs(turns - round(turns)) > WHOLE


def _fast(where: str, joint: ET.Element) -> list[str]:
    """The velocity limit of a turning joint that is larger than any arm's."""
    limit = joint.find("limit")
    if limit is None or joint.get("type") not in ("revolute", "continuous"):
        return []
    velocity = numbers(limit.get("velocity"), 1, largest=LARGEST_LIMIT)
    return [f'{where}: velocity="{limit.get("velocity")}"'] if velocity and MOST_SPEED < velocity[0] <= MOST_DEGREES else []


def _one_sided(where: str, joint: ET.Element) -> list[str]:
    """The limit that a joint does not give beside the other one."""
    limit = joint.find("limit")
    if limit is None or joint.get("type") not in TYPES[:2]:
        return []
    given = [name for name in ("lower", "upper") if limit.get(name) is not None]
    return [f"{where}: {'upper' if given == ['lower'] else 'lower'}"] if len(given) == 1 else []


def find_joined_links(root: ET.Element) -> set[tuple[str, str]]:
    """Parent and child link of each joint of a URDF, fixed joints included."""
    return {ends_of(joint) for joint in root.findall("joint")}


def body_fault(body: ET.Element) -> str | None:
    """The fault in a collision or visual element; None if there is none."""
    fault = _origin_fault(body)
    if fault is not None:
        return fault
    shapes = shapes_of(body)
    if len(shapes) != 1:
        return "it needs one <geometry> with one shape"
    [shape] = shapes
    if shape.tag not in SHAPES:
        return f"<{shape.tag}> is not a shape of URDF ({', '.join(SHAPES)})"
    fault = _attribute_fault(shape)
    if fault is not None:
        return fault
    for attribute, count in SHAPES[shape.tag].items():
        values = numbers(shape.get(attribute), count)
        if values is None or (min(values) <= 0 and not is_empty(shape)):
            wanted = f"{count} numbers" if count > 1 else "a number"
            return f"<{shape.tag}> needs {attribute} with {wanted} above zero, not {shape.get(attribute)!r}"
    if shape.tag == "mesh":
        if not shape.get("filename"):
            return "<mesh> needs a filename"
        scale = numbers(shape.get("scale", "1 1 1"), 3)
        if scale is None or 0.0 in scale:
            return f"<mesh> needs a scale with 3 numbers other than zero, not {shape.get('scale')!r}"
    return None


def shapes_of(body: ET.Element) -> list[ET.Element]:
    """The shapes of a collision or visual element, without what other programs add."""
    return [shape for shape in body.iterfind("geometry/*") if ":" not in shape.tag]


def is_empty(shape: ET.Element) -> bool:
    """Whether each length of a shape is 0, as of a box of size 0 0 0, which stands for no body."""
    sizes = SHAPES[shape.tag]
    values = [numbers(shape.get(attribute), count) for attribute, count in sizes.items()]
    return bool(sizes) and all(value is not None and not any(value) for value in values)


def _raise(file: Path, where: str, fault: str | None) -> None:
    if fault is not None:
        raise FileFormatError("file", str(file), f"a URDF whose links and joints can all be read; {where}: {fault}")


def _check_elements(file: Path, element: ET.Element, where: str) -> set[str]:
    """The names of the elements in an element that nobody knows; one that resembles a known one, or is doubled, is refused."""
    counted, strange = COUNTED[element.tag], set[str]()
    for child in element:
        prefix, _, name = child.tag.rpartition(":")
        if child.tag in counted:
            if child.tag in ONCE and len(element.findall(child.tag)) > 1:
                _raise(file, where, f"it has more than one <{child.tag}>")
            _raise(file, where, _attribute_fault(child))
        elif prefix in ("drake", "xacro", "gazebo") or child.tag in PASSED[element.tag]:
            continue
        else:
            near = _nearest(name, counted)
            if near is not None:
                _raise(file, where, f"<{child.tag}> is not an element of URDF; did you mean <{near}>?")
            strange.add(f"<{child.tag}> in <{element.tag}>")
    return strange


def _attribute_fault(element: ET.Element) -> str | None:
    known = ATTRIBUTES.get(element.tag, ())
    for name in element.attrib if known else ():
        if name not in (*known, *ADDED_ATTRIBUTES.get(element.tag, ())) and ":" not in name and name != "xmlns":
            near = _nearest(name, known)
            remedy = f"did you mean {near}?" if near is not None else f"it has {', '.join(known)}"
            return f"<{element.tag}> has no attribute {name!r}; {remedy}"
    return None


def _nearest(name: str, known: Collection[str]) -> str | None:
    near = difflib.get_close_matches(name.lower(), known, n=1, cutoff=NEAR if len(name) > 3 else 0.6)
    return near[0] if near else None


def _check_names(file: Path, kind: str, elements: Iterable[ET.Element]) -> None:
    seen = set()
    for k, element in enumerate(elements, start=1):
        name = element.get("name")
        if not name:
            _raise(file, f"{kind} number {k}", "it has no name")
        if name in seen:
            _raise(file, f"{kind} {name}", f"several {kind}s have this name")
        seen.add(name)


def ends_of(joint: ET.Element) -> tuple[str, str]:
    """The parent and the child link of a joint."""
    ends = (joint.find("parent"), joint.find("child"))
    return (str(ends[0].get("link")) if ends[0] is not None else "", str(ends[1].get("link")) if ends[1] is not None else "")


def _check_tree(file: Path, links: set[str], joints: list[ET.Element]) -> None:
    """Raise FileFormatError unless the joints make one tree of the links, with chains of at most `DEEPEST` links."""
    above: dict[str, tuple[str, str]] = {}
    for joint in joints:
        name, (parent, child) = str(joint.get("name")), ends_of(joint)
        for link in (parent, child):
            if link not in links:
                _raise(file, f"joint {name}", str(UnknownNameError("link", link, links)))
        if child in above:
            _raise(file, f"joint {name}", f"link {child} is the child of joint {above[child][1]} already")
        above[child] = parent, name
    roots = sorted(links - above.keys())
    if len(roots) != 1:
        found = f"{len(roots)}: {', '.join(roots[:12])}" if roots else "none: the joints form a loop"
        raise FileFormatError("file", str(file), f"a URDF with one root link, which is the child of no joint; it has {found}")
    for first in sorted(links):
        link, passed = first, list[str]()
        while link in above:
            passed.append(link)
            link = above[link][0]
            if link == first:
                raise FileFormatError(
                    "file", str(file), f"a URDF without a closed loop, unlike that of {', '.join(passed[:12])}"
                )
            if len(passed) > DEEPEST:
                wanted = f"a URDF with at most {DEEPEST} links in one chain, and no closed loop"
                raise FileFormatError("file", str(file), wanted)


def _joint_fault(joint: ET.Element) -> str | None:
    kind = joint.get("type")
    if kind not in TYPES:
        return str(UnknownNameError("type", str(kind), TYPES))
    for end in ("parent", "child"):
        if joint.find(end) is None:
            return f"it needs a <{end}>"
    axis, limit = joint.find("axis"), joint.find("limit")
    if axis is not None and kind in TYPES[:4]:
        xyz = numbers(axis.get("xyz"), 3)
        if xyz is None or max(map(abs, xyz)) < SMALLEST_AXIS:
            return f"<axis> needs xyz with 3 numbers, not all zero, not {axis.get('xyz')!r}"
    if limit is None:
        return f"a {kind} joint needs a <limit> with lower, upper, velocity and effort" if kind in TYPES[:2] else None
    return _number_fault(limit, {"lower": "0", "upper": "0"}, LARGEST_LIMIT) if kind in TYPES[:3] else None


def _inertial_fault(inertial: ET.Element) -> str | None:
    for tag in ("mass", "inertia"):
        element = inertial.find(tag)
        fault = f"it needs one <{tag}>" if element is None else _number_fault(element)
        if fault is not None:
            return fault
    return None


def _origin_fault(element: ET.Element) -> str | None:
    faults = (_number_fault(origin, {"xyz": "0 0 0", "rpy": "0 0 0"}) for origin in element.findall("origin"))
    return next(filter(None, faults), None)


def _number_fault(element: ET.Element, defaults: Mapping[str, str] | None = None, largest: float = LARGEST) -> str | None:
    """The first attribute of `NUMBERS` whose numbers cannot be read; one without a default is needed."""
    for attribute, count in NUMBERS[element.tag].items():
        text = element.get(attribute, (defaults or {}).get(attribute))
        if numbers(text, count, largest=largest) is None:
            return f"<{element.tag}> needs {attribute} with {f'{count} numbers' if count > 1 else 'a number'}, not {text!r}"
    return None


#: What finds the fault in an element beside those of its origin.
FAULTS = {"joint": _joint_fault, "link": lambda _: None, "collision": body_fault, "inertial": _inertial_fault}

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
            _add(inner, inertial, "origin", "mass", "inertia")
    for joint in root.findall("joint"):
        copy = ET.SubElement(plain, "joint", name=str(joint.get("name")), type=str(joint.get("type")))
        parent, child = ends_of(joint)
        ET.SubElement(copy, "parent", link=parent)
        ET.SubElement(copy, "child", link=child)
        _add(copy, joint, "origin")
        if joint.get("type") in TYPES[:4]:
            _add(copy, joint, "axis")
        if joint.get("type") in TYPES[:3]:
            _add(copy, joint, "limit", "dynamics")
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


def _add(copy: ET.Element, original: ET.Element, *tags: str) -> None:
    """Add the numbers of elements that `original` has, in full precision; those that are not numbers are left out."""
    for element in (each for each in map(original.find, tags) if each is not None):
        values = {name: numbers(element.get(name), size, largest=LARGEST_LIMIT) for name, size in NUMBERS[element.tag].items()}
        texts = {name: " ".join(map(repr, value)) for name, value in values.items() if value is not None}
        if texts:
            ET.SubElement(copy, element.tag, texts)


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
