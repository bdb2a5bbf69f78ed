"""Robot descriptions: read URDF, MJCF and SRDF files into Pinocchio models with one plain number per joint."""

import xml.etree.ElementTree as ET
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

import coal
import numpy as np
import pinocchio as pin

from manipplan.robots import mjcf_bodies, urdf_links
from manipplan.robots.hulls import FARTHEST
from manipplan.robots.ply import fault_of
from manipplan.support.checks import Array
from manipplan.support.errors import FileFormatError

T = TypeVar("T")
#: Maximum depth of nested XML elements and maximum number of links in a chain: Pinocchio reads both recursively.
DEEPEST = 500
#: Pinocchio's name for the world, as a joint and as a frame.
WORLD = "universe"
_LINK = " (link)"


@dataclass(frozen=True, kw_only=True)
class Description:
    """Contents of a robot file: the whole robot, its collision geometry, and which joint mimics which."""

    file: Path
    source: str
    model: pin.Model
    geometry: pin.GeometryModel
    mimics: Mapping[str, "Mimic"]


@dataclass(frozen=True, kw_only=True)
class Mimic:
    """A joint that follows another: multiplier * leader + offset."""

    leader: str
    multiplier: float
    offset: float


@dataclass(frozen=True, kw_only=True)
class Semantics:
    """Contents of an SRDF: the end effector, pairs that are not checked, and named states.

    `states` holds name and joint values in the order of the file; groups of one robot may use the same name.
    """

    end_effector: str | None
    disabled: frozenset[frozenset[str]]
    states: tuple[tuple[str, Mapping[str, float]], ...]


def read_urdf(file: Path, package_dirs: Sequence[str | Path] = ()) -> Description:
    """The robot of a URDF; continuous joints become plain angles."""
    root = _xml("file", file, "robot")
    if root.find("link") is None:
        raise FileFormatError("file", str(file), "a URDF with at least one <link>")
    mimics = {}
    for joint in root.iter("joint"):
        leader = joint.find("mimic")
        if leader is not None:
            try:
                factor, offset = float(leader.get("multiplier", "1")), float(leader.get("offset", "0"))
            except ValueError as error:
                raise FileFormatError("file", str(file), f"numbers in <mimic> of {joint.get('name')} ({error})") from error
            mimics[str(joint.get("name"))] = Mimic(leader=str(leader.get("joint")), multiplier=factor, offset=offset)
    _check_names(file, root)
    _check_chain(file, root)
    urdf_links.check_links(file, root)
    folders = [str(folder) for folder in package_dirs] + [str(folder) for folder in file.resolve().parents]
    _check_ply(file, root, folders)
    model = _pinocchio(file, "a URDF", lambda: pin.buildModelFromUrdf(str(file)))
    geometry = _pinocchio(
        file,
        "a URDF whose meshes can be found (package_dirs= says where package:// starts)",
        lambda: pin.buildGeomFromUrdf(model, str(file), pin.GeometryType.COLLISION, package_dirs=folders),
    )
    urdf_links.check_loaded(file, root, model, geometry)
    _check_meshes(file, geometry)
    return Description(file=file, source="URDF", model=plain_angles(model), geometry=geometry, mimics=mimics)


def read_mjcf(file: Path) -> Description:
    """The robot of a MuJoCo MJCF file; unlimited hinges become plain angles."""
    root = _xml("file", file, "mujoco")
    _check_names(file, root)
    mjcf_bodies.check_bodies(file, root)
    _check_ply(file, root, [str(file.parent / each.get("meshdir", "")) for each in (root, *root.iter("compiler"))])
    model = _pinocchio(file, "an MJCF file", lambda: pin.buildModelFromMJCF(str(file)))
    geometry = _pinocchio(
        file,
        "an MJCF file whose meshes can be found",
        lambda: pin.buildGeomFromMJCF(model, str(file), pin.GeometryType.COLLISION),
    )
    mjcf_bodies.check_loaded(file, root, model, geometry)
    _check_meshes(file, geometry)
    return Description(file=file, source="MJCF", model=plain_angles(model), geometry=geometry, mimics={})


def read_srdf(file: Path) -> Semantics:
    """End effector, disabled pairs and named states of an SRDF."""
    root = _xml("srdf", file, "robot")
    effector = root.find("end_effector")
    disabled = {frozenset((str(pair.get("link1")), str(pair.get("link2")))) for pair in root.findall("disable_collisions")}
    states = []
    for state in root.findall("group_state"):
        # a floating base has several values: it is not a joint of an arm
        single = [j for j in state.findall("joint") if len(str(j.get("value")).split()) == 1]
        try:
            values = {str(j.get("name")): float(str(j.get("value"))) for j in single}
        except ValueError as error:
            raise FileFormatError("srdf", str(file), f"numbers as joint values ({error})") from error
        for name, value in values.items():
            if not np.isfinite(value):
                raise FileFormatError("srdf", str(file), f"finite joint values; {name} is {value}")
        called = state.get("name")
        if not called:
            raise FileFormatError("srdf", str(file), "a name for every <group_state>")
        states.append((called, values))
    return Semantics(
        end_effector=effector.get("parent_link") if effector is not None else None,
        disabled=frozenset(disabled),
        states=tuple(states),
    )


def is_revolute(joint: pin.JointModel) -> bool:
    """Whether the joint turns about one fixed axis."""
    return bool(joint.shortname().startswith("JointModelR") and joint.nv == 1)


def is_prismatic(joint: pin.JointModel) -> bool:
    """Whether the joint slides along one fixed axis."""
    return bool(joint.shortname().startswith("JointModelP") and joint.nv == 1)


def axis_of(joint: pin.JointModel) -> Array:
    """Unit axis (3,) of a revolute or prismatic joint in its own frame."""
    name = joint.shortname()
    if name.endswith("Unaligned"):
        data = joint.createData()
        joint.calc(data, np.eye(joint.nq)[0])  # the motion at angle 0, or at (cos, sin) = (1, 0)
        motion = np.array(data.S).reshape(-1)
        return motion[:3] if is_prismatic(joint) else motion[3:]
    return np.asarray(np.eye(3)["XYZ".index(name[-1])])


def plain_angles(model: pin.Model) -> pin.Model:
    """The same tree with unbounded revolute joints as plain angles, so that each is one number.

    Pinocchio stores a continuous joint as cosine and sine; planning variables must be free.
    """
    if not any("RUB" in joint.shortname() or "RevoluteUnbounded" in joint.shortname() for joint in model.joints):
        return model
    plain = pin.Model()
    plain.name = model.name
    plain.gravity = model.gravity
    for i in range(1, model.njoints):
        joint = model.joints[i]
        lower = model.lowerPositionLimit[joint.idx_q : joint.idx_q + joint.nq]
        upper = model.upperPositionLimit[joint.idx_q : joint.idx_q + joint.nq]
        effort = model.effortLimit[joint.idx_v : joint.idx_v + joint.nv]
        velocity = model.velocityLimit[joint.idx_v : joint.idx_v + joint.nv]
        if is_revolute(joint) and joint.nq == 2:
            joint = pin.JointModelRevoluteUnaligned(axis_of(joint))
            lower, upper = np.array([-np.inf]), np.array([np.inf])
        index = plain.addJoint(
            model.parents[i], joint, model.jointPlacements[i], model.names[i], effort, velocity, lower, upper
        )
        plain.inertias[index] = model.inertias[i]
    plain.armature = model.armature
    for frame in list(model.frames)[1:]:
        plain.addFrame(frame, False)
    return plain


def reduce(
    model: pin.Model, geometry: pin.GeometryModel, active: Sequence[str], held: Mapping[str, float]
) -> tuple[pin.Model, pin.GeometryModel]:
    """Lock every joint of `held` at its value; the geometry follows its link."""
    q = pin.neutral(model)
    for name, value in held.items():
        joint = model.joints[model.getJointId(name)]
        if joint.nq == 1:
            q[joint.idx_q] = value
    # Pinocchio looks up a locked joint by name alone, so a link of the same name is renamed meanwhile.
    model = model.copy()
    joints = set(model.names)
    for frame in model.frames:
        if frame.type == pin.FrameType.BODY and frame.name in joints:
            frame.name = frame.name + _LINK
    reduced, [geometry] = pin.buildReducedModel(model, [geometry], [model.getJointId(name) for name in held], q)
    for frame in reduced.frames:
        frame.name = frame.name.removesuffix(_LINK)
    if list(reduced.names)[1:] != list(active):
        raise FileFormatError("joints", list(active), f"the order of the description: {list(reduced.names)[1:]}")
    return reduced, geometry


def frame_index(model: pin.Model, name: str) -> int:
    """Index of the frame called `name`; a link takes precedence over a joint of the same name."""
    found = [i for i, frame in enumerate(model.frames) if frame.name == name]
    return min(found, key=lambda i: model.frames[i].type != pin.FrameType.BODY)


def adjacent_pairs(model: pin.Model, geometry: pin.GeometryModel) -> frozenset[frozenset[str]]:
    """Names of geometry objects whose links are the same or joined by one joint: these touch by construction."""
    objects = list(geometry.geometryObjects)
    pairs = set()
    for j, second in enumerate(objects):
        for first in objects[:j]:
            a, b = first.parentJoint, second.parentJoint
            if a == b or model.parents[a] == b or model.parents[b] == a:
                pairs.add(frozenset((first.name, second.name)))
    return frozenset(pairs)


def leaf_bodies(model: pin.Model) -> list[str]:
    """Names of the body frames that carry no further body."""
    bodies = [i for i, frame in enumerate(model.frames) if frame.type == pin.FrameType.BODY]
    inner = set()
    for frame in model.frames:
        if frame.type in (pin.FrameType.JOINT, pin.FrameType.FIXED_JOINT):
            inner.add(frame.parentFrame)
    return [model.frames[i].name for i in bodies if i not in inner]


def _xml(argument: str, file: Path, root_tag: str) -> ET.Element:
    """The root of an XML file in UTF-8, the encoding that Pinocchio assumes for every file."""
    try:
        file.read_text(encoding="utf-8")
        root = _bounded(argument, file)
    except FileFormatError:
        raise
    except ET.ParseError as error:
        raise FileFormatError(argument, str(file), f"well-formed XML ({error})") from error
    except (ValueError, LookupError) as error:  # bytes that are not UTF-8, or an unknown encoding
        raise FileFormatError(argument, str(file), f"XML in UTF-8 ({error})") from error
    except OSError as error:
        raise FileFormatError(argument, str(file), f"a file that can be read ({error.strerror})") from error
    if root.tag != root_tag:
        raise FileFormatError(argument, str(file), f"an XML file whose root is <{root_tag}>, not <{root.tag}>")
    return root


def _bounded(argument: str, file: Path) -> ET.Element:
    """The root of an XML file whose elements are not nested deeper than `DEEPEST`."""
    depth = 0
    root: ET.Element | None = None
    for event, element in ET.iterparse(file, events=("start", "end")):
        depth += 1 if event == "start" else -1
        root = element if root is None else root
        if depth > DEEPEST:
            raise FileFormatError(argument, str(file), f"XML with elements nested at most {DEEPEST} deep")
    if root is None:
        raise ET.ParseError("no element found")
    return root


def _check_names(file: Path, root: ET.Element) -> None:
    if any(joint.get("name") == WORLD for joint in root.iter("joint")):
        raise FileFormatError("file", str(file), f"joints with other names than {WORLD!r}, Pinocchio's name for the world")


def _check_chain(file: Path, root: ET.Element) -> None:
    """Raise FileFormatError when a chain has more than `DEEPEST` links, or links form a closed loop."""
    parents = {}
    for joint in root.findall("joint"):
        parent, child = joint.find("parent"), joint.find("child")
        if parent is not None and child is not None:
            parents[child.get("link")] = parent.get("link")
    for first in list(parents):
        link, above = first, 0
        while link in parents:
            link, above = parents[link], above + 1
            if above > DEEPEST:
                wanted = f"a URDF with at most {DEEPEST} links in one chain, and no closed loop"
                raise FileFormatError("file", str(file), wanted)


def _check_ply(file: Path, root: ET.Element, folders: Sequence[str]) -> None:
    """Raise FileFormatError for a PLY mesh on which the mesh loader would crash."""
    for mesh in root.iter("mesh"):
        name = mesh.get("filename") or mesh.get("file") or ""
        if not name.lower().endswith(".ply"):
            continue
        name = name.removeprefix("package://").removeprefix("file://")
        for path in (Path(folder) / name for folder in folders):
            fault = fault_of(path) if path.is_file() else None
            if fault is not None:
                raise FileFormatError("file", str(file), f"a description whose meshes can be read; {path}: {fault}")


def _check_meshes(file: Path, geometry: pin.GeometryModel) -> None:
    """Raise FileFormatError for a mesh with a vertex that is not finite, or farther away than `FARTHEST`."""
    for item in geometry.geometryObjects:
        if isinstance(item.geometry, coal.BVHModelBase) and not (np.abs(np.array(item.geometry.vertices())) <= FARTHEST).all():
            wanted = (
                f"a description whose meshes have finite vertices within {FARTHEST:g} m, unlike {item.meshPath} of {item.name}"
            )
            raise FileFormatError("file", str(file), wanted)


def _pinocchio(file: Path, wanted: str, build: Callable[[], T]) -> T:
    try:
        return build()
    except (ValueError, RuntimeError, IndexError) as error:
        reason = " ".join(str(error).split())[:200]
        raise FileFormatError("file", str(file), f"{wanted}; Pinocchio says: {reason}") from error
