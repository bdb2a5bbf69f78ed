"""Robot descriptions: read URDF and MJCF files into Pinocchio models with one plain number per joint."""

import xml.etree.ElementTree as ET
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from pathlib import Path

import coal
import numpy as np
import pinocchio as pin

from manipplan.robots import attached
from manipplan.robots.formats import mjcf_bodies
from manipplan.robots.formats.urdf_check import check_urdf, joined_links
from manipplan.robots.formats.urdf_files import UrdfFiles
from manipplan.robots.formats.urdf_model import build_bodies, build_model, check_sizes, check_visuals, pinocchio_says
from manipplan.robots.formats.xml_files import read_xml
from manipplan.robots.hulls import FARTHEST
from manipplan.robots.mimics import WORLD, Mimic, read_couplings, read_mimics
from manipplan.robots.model_tree import plain_angles
from manipplan.support.errors import FileFormatError


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
    check_urdf(file, root)
    if files.collision == "visual":
        check_visuals(file, root)
    mimics = read_mimics(file, root)
    files.without_meshes(file, root, files.collision)
    model = build_model(file, root)
    geometry = build_bodies(file, root, model, files, files.collision)
    check_sizes(file, model, geometry)
    return Description(
        file=file,
        source="URDF",
        model=plain_angles(model),
        geometry=geometry,
        mimics=mimics,
        unchecked=_adjacent_bodies(model, geometry, joined_links(root)),
    )


def read_visuals(file: Path, files: UrdfFiles) -> tuple[pin.Model, pin.GeometryModel]:
    """The model of a URDF or xacro file with its visual bodies."""
    root = files.root(file)
    check_urdf(file, root)
    check_visuals(file, root)
    files.without_meshes(file, root, "visual")
    model = build_model(file, root)
    return model, build_bodies(file, root, model, files, "visual")


def read_mjcf(file: Path) -> Description:
    """The robot of a MuJoCo MJCF file; unlimited hinges become plain angles."""
    root = read_xml("file", file, "mujoco")
    _check_names(file, root)
    mjcf_bodies.check_bodies(file, root)
    model = pinocchio_says(file, "an MJCF file", lambda: pin.buildModelFromMJCF(str(file)))
    geometry = pinocchio_says(
        file,
        "an MJCF file whose meshes can be found",
        lambda: pin.buildGeomFromMJCF(model, str(file), pin.GeometryType.COLLISION),
    )
    mjcf_bodies.check_loaded(file, root, model, geometry)
    mimics = read_couplings(file, root, model)
    model, geometry = attached.move_base(model, geometry, mjcf_bodies.root_pose(root))
    _check_meshes(file, geometry)
    joined = {(str(body.get("name")), str(child.get("name"))) for body in root.iter("body") for child in body.findall("body")}
    return Description(
        file=file,
        source="MJCF",
        model=plain_angles(model),
        geometry=geometry,
        mimics=mimics,
        unchecked=_adjacent_bodies(model, geometry, joined),
    )


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


def _check_meshes(file: Path, geometry: pin.GeometryModel) -> None:
    """Raise FileFormatError for a mesh with a vertex that is not finite, or farther away than `FARTHEST`."""
    for item in geometry.geometryObjects:
        if isinstance(item.geometry, coal.BVHModelBase) and not (np.abs(np.array(item.geometry.vertices())) <= FARTHEST).all():
            wanted = (
                f"a description whose meshes have finite vertices within {FARTHEST:g} m, unlike {item.meshPath} of {item.name}"
            )
            raise FileFormatError("file", str(file), wanted)
