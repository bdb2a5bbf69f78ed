"""Robot descriptions: Pinocchio models with one plain number per joint, and how a URDF becomes one."""

import logging
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from pathlib import Path

import pinocchio as pin

from manipplan.robots.formats.urdf_check import check_urdf, joined_links
from manipplan.robots.formats.urdf_files import UrdfFiles
from manipplan.robots.formats.urdf_model import build_bodies, build_model, check_visuals
from manipplan.robots.mimics import Mimic, read_mimics
from manipplan.robots.model_tree import plain_angles
from manipplan.robots.sizes import check_origins, check_sizes

log = logging.getLogger("manipplan")

#: What to do about a description without collision elements.
VISUAL_HINT = "collision='visual' checks the visual elements, if there are any"


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
    elif root.find("link/collision") is None and root.find("link/visual") is not None:
        log.warning("%s: no link has a collision element, so nothing of the robot is checked; %s", file, VISUAL_HINT)
    mimics = read_mimics(file, root)
    files.without_meshes(file, root, files.collision)
    model = build_model(file, root)
    geometry = build_bodies(file, root, model, files, files.collision)
    check_origins(file, model, geometry)
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
