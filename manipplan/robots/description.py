"""Robot descriptions: Pinocchio models with one plain number per joint, and how a URDF becomes one."""

import tempfile
import xml.etree.ElementTree as ET
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

import coal
import numpy as np
import pinocchio as pin

from manipplan.robots.formats import urdf_links
from manipplan.robots.formats.urdf_files import UrdfFiles
from manipplan.robots.formats.xml_files import DEEPEST
from manipplan.robots.hulls import FARTHEST
from manipplan.robots.meshes.files import check_urdf_meshes
from manipplan.robots.mimics import WORLD, Mimic, read_mimics
from manipplan.robots.model_tree import plain_angles
from manipplan.support.errors import FileFormatError

T = TypeVar("T")


@dataclass(frozen=True, kw_only=True)
class Description:
    """Contents of a robot file.

    Attributes:
        file: the file that was read.
        source: kind of the file, for messages.
        model: the whole robot, one plain number per joint.
        geometry: its collision bodies; the parent frame of each is the frame of its link.
        mimics: the joints that follow another one, by name.
        unchecked: pairs of bodies (names of geometry objects) that the description itself exempts from checks, with the reason.
    """

    file: Path
    source: str
    model: pin.Model
    geometry: pin.GeometryModel
    mimics: Mapping[str, Mimic]
    unchecked: Mapping[frozenset[str], str]


def read_urdf(file: Path, files: UrdfFiles) -> Description:
    """The robot of a URDF or xacro file; continuous joints become plain angles."""
    root = files.root(file)
    if root.find("link") is None:
        raise FileFormatError("file", str(file), "a URDF with at least one <link>")
    mimics = read_mimics(file, root)
    _check_names(file, root)
    _check_chain(file, root)
    urdf_links.check_links(file, root)
    files.resolve(file, root)
    folders = files.folders(file)
    with tempfile.TemporaryDirectory() as place:
        check_urdf_meshes(file, root, folders, Path(place))
        text = ET.tostring(root, encoding="unicode")
        model = _pinocchio(file, "a URDF", lambda: pin.buildModelFromXML(text))
        geometry = _pinocchio(
            file,
            "a URDF whose meshes can be found (packages= and package_dirs= say where, meshes=False leaves them out)",
            lambda: pin.buildGeomFromUrdfString(model, text, pin.GeometryType.COLLISION, package_dirs=folders),
        )
    urdf_links.check_loaded(file, root, model, geometry)
    _check_meshes(file, geometry)
    return Description(
        file=file,
        source="URDF",
        model=plain_angles(model),
        geometry=geometry,
        mimics=mimics,
        unchecked=_adjacent_bodies(model, geometry, _joined_links(root)),
    )


def _joined_links(root: ET.Element) -> set[tuple[str, str]]:
    """Parent and child link of each joint of a URDF, fixed joints included."""
    joined = set()
    for joint in root.findall("joint"):
        parent, child = joint.find("parent"), joint.find("child")
        if parent is not None and child is not None:
            joined.add((str(parent.get("link")), str(child.get("link"))))
    return joined


def _adjacent_bodies(
    model: pin.Model, geometry: pin.GeometryModel, joined: Collection[tuple[str, str]]
) -> dict[frozenset[str], str]:
    """The pairs of bodies on one link, or on the parent and the child link of one joint: these touch by construction."""
    bodies = [(item.name, str(model.frames[item.parentFrame].name)) for item in geometry.geometryObjects]
    return {
        frozenset((first, second)): "one link" if a == b else "parent and child link of one joint"
        for j, (second, b) in enumerate(bodies)
        for first, a in bodies[:j]
        if a == b or (a, b) in joined or (b, a) in joined
    }


def _check_names(file: Path, root: ET.Element) -> None:
    if any(joint.get("name") == WORLD for joint in root.iter("joint")):
        raise FileFormatError("file", str(file), f"joints with other names than {WORLD!r}, Pinocchio's name for the world")


def _check_chain(file: Path, root: ET.Element) -> None:
    """Raise FileFormatError when a chain has more than `DEEPEST` links, or links form a closed loop."""
    parents = {child: parent for parent, child in _joined_links(root)}
    for first in list(parents):
        link, above = first, 0
        while link in parents:
            link, above = parents[link], above + 1
            if above > DEEPEST:
                wanted = f"a URDF with at most {DEEPEST} links in one chain, and no closed loop"
                raise FileFormatError("file", str(file), wanted)


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
    except (ValueError, RuntimeError, IndexError, MemoryError) as error:
        reason = " ".join(str(error).split())[:200]
        raise FileFormatError("file", str(file), f"{wanted}; Pinocchio says: {reason}") from error
