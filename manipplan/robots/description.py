"""Robot descriptions: read URDF and MJCF files into Pinocchio models with one plain number per joint."""

import logging
import xml.etree.ElementTree as ET
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TypeVar

import coal
import numpy as np
import pinocchio as pin

from manipplan.robots import attached, mjcf_bodies, urdf_links
from manipplan.robots.hulls import FARTHEST
from manipplan.robots.model_tree import plain_angles
from manipplan.robots.ply import fault_of
from manipplan.robots.xml_files import DEEPEST, read_xml
from manipplan.support.checks import instance
from manipplan.support.errors import FileFormatError, InvalidInputError

log = logging.getLogger("manipplan")

T = TypeVar("T")
#: Pinocchio's name for the world, as a joint and as a frame.
WORLD = "universe"


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
class MeshFiles:
    """Where the meshes of a URDF are, and whether its collision meshes are read.

    Attributes:
        package_dirs: folders in which packages are searched.
        packages: folder of each package, by name.
        meshes: whether collision meshes are read; without them only the primitives of the description are checked.
    """

    package_dirs: Sequence[str | Path] = ()
    packages: Mapping[str, str | Path] = field(default_factory=dict)
    meshes: bool = True

    def __post_init__(self) -> None:
        if isinstance(self.package_dirs, str | Path) or not isinstance(self.package_dirs, Sequence):
            raise InvalidInputError("package_dirs", self.package_dirs, "a list of folders")
        if not isinstance(self.packages, Mapping):
            raise InvalidInputError("packages", self.packages, "a mapping from names of packages to their folders")
        for name, folder in self.packages.items():
            if not isinstance(folder, str | Path) or not Path(folder).expanduser().is_dir():
                raise InvalidInputError(f"packages[{name!r}]", str(folder), "an existing folder")
        instance("meshes", self.meshes, bool)

    def folders(self, file: Path) -> list[str]:
        """The folders in which packages are searched: `package_dirs`, and those above the file."""
        return [str(folder) for folder in (*self.package_dirs, *file.resolve().parents)]

    def read(self, file: Path) -> str:
        """The text of a URDF as `resolve` gives it."""
        return self.resolve(file, read_xml("file", file, "robot"))

    def resolve(self, file: Path, root: ET.Element) -> str:
        """The URDF as text, with the folders of `packages` in its paths, and without collision meshes if `meshes` is False.

        This changes `root`.
        """
        for mesh in root.iter("mesh"):
            name, _, rest = str(mesh.get("filename", "")).removeprefix("package://").partition("/")
            if mesh.get("filename", "").startswith("package://") and name in self.packages:
                mesh.set("filename", str(Path(self.packages[name]).expanduser().resolve() / rest))
        left_out = 0
        for link in root.findall("link") if not self.meshes else ():
            for collision in link.findall("collision"):
                if collision.find("geometry/mesh") is not None:
                    link.remove(collision)
                    left_out += 1
        if left_out:
            log.warning("%s: %d collision meshes are left out, and nothing is checked for them", file, left_out)
        return ET.tostring(root, encoding="unicode")


def read_urdf(file: Path, mesh_files: MeshFiles) -> Description:
    """The robot of a URDF; continuous joints become plain angles."""
    root = read_xml("file", file, "robot")
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
    text = mesh_files.resolve(file, root)
    folders = mesh_files.folders(file)
    _check_ply(file, root, folders)
    model = _pinocchio(file, "a URDF", lambda: pin.buildModelFromXML(text))
    geometry = _pinocchio(
        file,
        "a URDF whose meshes can be found (packages= and package_dirs= say where, meshes=False leaves them out)",
        lambda: pin.buildGeomFromUrdfString(model, text, pin.GeometryType.COLLISION, package_dirs=folders),
    )
    urdf_links.check_loaded(file, root, model, geometry)
    _check_meshes(file, geometry)
    return Description(file=file, source="URDF", model=plain_angles(model), geometry=geometry, mimics=mimics)


def read_mjcf(file: Path) -> Description:
    """The robot of a MuJoCo MJCF file; unlimited hinges become plain angles."""
    root = read_xml("file", file, "mujoco")
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
    model, geometry = attached.move_base(model, geometry, mjcf_bodies.root_pose(root))
    _check_meshes(file, geometry)
    return Description(file=file, source="MJCF", model=plain_angles(model), geometry=geometry, mimics={})


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
