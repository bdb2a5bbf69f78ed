"""Robot descriptions: Pinocchio models with one plain number per joint, and how a URDF becomes one.

RobotSource: what an arm was read from, so that the same arm can be built again.
"""

import logging
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pinocchio as pin

from manipplan.robots.formats.urdf_check import check_urdf, find_joined_links
from manipplan.robots.formats.urdf_files import UrdfFiles
from manipplan.robots.formats.urdf_model import build_bodies, build_model, check_visuals
from manipplan.robots.model_tree import Mimic, plain_angles, read_mimics
from manipplan.robots.sizes import check_origins, check_sizes
from manipplan.support.errors import UnknownNameError

if TYPE_CHECKING:
    from manipplan.robots.robot import Robot

KINDS = ("catalogue", "urdf", "mjcf", "planar")
#: Options of `Robot.from_urdf` that are paths of files and folders.
FILES, FOLDERS, FOLDERS_BY_NAME = ("srdf",), ("package_dirs",), ("packages",)
#: Option that maps names to text.
TEXTS = "arguments"
#: Option that lets a file run code. It is never stored in a saved plan, nor read from one.
TRUST = "trust_file"


@dataclass(frozen=True, kw_only=True)
class RobotSource:
    """What an arm was read from, with the options that were given.

    Attributes:
        kind: "catalogue", "urdf", "mjcf" or "planar".
        name: of kind "catalogue" the name that `load_robot` was given, also one of another collection; else "".
        file: absolute path of the URDF, xacro or MJCF file that was read; None for the planar arm.
        options: other given options, as plain numbers, strings, tuples and paths: tool, joints, srdf, name, locked, neutral,
            package_dirs, packages, meshes, collision, arguments, trust_file and limits of `Robot.from_urdf`; lengths and
            radius of `planar_arm`.
    """

    kind: str
    name: str = ""
    file: Path | None = None
    options: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise UnknownNameError("kind of a robot's source", str(self.kind), KINDS)

    @classmethod
    def of(cls, kind: str, file: str | Path | None, options: Mapping[str, Any], *, name: str = "") -> "RobotSource":
        """The source for the user's options; those that are None or empty are left out."""
        plain = {key: _plain(key, value) for key, value in options.items() if value is not None}
        given = {key: value for key, value in plain.items() if value not in ((), {})}
        path = Path(file).expanduser().resolve() if file is not None else None
        return cls(kind=kind, name=name, file=path, options=given)

    @property
    def urdf_files(self) -> UrdfFiles:
        """How a URDF or xacro file is read, and where its meshes are."""
        names = ("package_dirs", "packages", "collision", "arguments", "trust_file")
        return UrdfFiles(**{name: self.options[name] for name in names if name in self.options})

    def load(self) -> "Robot":
        """Build the arm again, with the limits and the neutral posture with which it was read.

        Raises FileFormatError or another InvalidInputError when a file no longer exists, or no longer fits the options.
        """
        from manipplan.robots.catalog import load_robot, planar_arm
        from manipplan.robots.robot import Robot

        if self.kind == "planar":
            return planar_arm(**self.options)
        if self.kind == "catalogue" or self.file is None:
            return load_robot(self.name, **self.options)
        return Robot.from_mjcf(self.file, **self.options) if self.kind == "mjcf" else Robot.from_urdf(self.file, **self.options)


def _plain(key: str, value: Any) -> Any:
    """The value of an option as plain numbers, strings, tuples and paths, independent of the caller's objects."""
    if key in FILES:
        return Path(value).expanduser().resolve()
    if key in FOLDERS:
        return tuple(Path(folder).expanduser().resolve() for folder in value)
    if key in FOLDERS_BY_NAME:
        return {str(name): Path(folder).expanduser().resolve() for name, folder in value.items()}
    if key == TEXTS:
        return {str(name): str(each) for name, each in value.items()}
    if isinstance(value, bool):
        return value
    if isinstance(value, Mapping):
        return {str(name): float(each) for name, each in value.items()}
    if isinstance(value, str):
        return value
    return tuple(_plain("", each) for each in value) if np.ndim(value) else float(value)


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
        unchecked=_adjacent_bodies(model, geometry, find_joined_links(root)),
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
