"""UrdfFiles: how a URDF or xacro file is read, and where its meshes are."""

import logging
import xml.etree.ElementTree as ET
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from manipplan.robots.formats import xacro_files
from manipplan.robots.formats.packages import PackageFolders
from manipplan.robots.formats.xml_files import read_xml
from manipplan.support.checks import instance
from manipplan.support.errors import FileFormatError, InvalidInputError

log = logging.getLogger("manipplan")


@dataclass(frozen=True, kw_only=True)
class UrdfFiles:
    """How a URDF or xacro file is read, and where its meshes are.

    Attributes:
        package_dirs: folders in which packages are searched.
        packages: folder of each package, by name.
        meshes: whether collision meshes are read; without them only the primitives of the description are checked.
        arguments: values of a xacro file's arguments, by name; numbers and booleans become text as in ROS.
        trust_file: whether a xacro file may run Python code, and read any file and environment variable.

    Raises InvalidInputError when an attribute has another type, or a folder of `packages` does not exist.
    """

    package_dirs: Sequence[str | Path] = ()
    packages: Mapping[str, str | Path] = field(default_factory=dict)
    meshes: bool = True
    arguments: Mapping[str, str | float | bool] = field(default_factory=dict)
    trust_file: bool = False

    def __post_init__(self) -> None:
        if isinstance(self.package_dirs, str | Path) or not isinstance(self.package_dirs, Sequence):
            raise InvalidInputError("package_dirs", self.package_dirs, "a list of folders")
        if not isinstance(self.packages, Mapping):
            raise InvalidInputError("packages", self.packages, "a mapping from names of packages to their folders")
        for name, folder in self.packages.items():
            if not isinstance(folder, str | Path) or not Path(folder).expanduser().is_dir():
                raise InvalidInputError(f"packages[{name!r}]", str(folder), "an existing folder")
        instance("meshes", self.meshes, bool)
        instance("trust_file", self.trust_file, bool)
        if not isinstance(self.arguments, Mapping):
            raise InvalidInputError("arguments", self.arguments, "a mapping from names of xacro arguments to their values")
        texts = {str(name): _text(f"arguments[{name!r}]", value) for name, value in self.arguments.items()}
        object.__setattr__(self, "arguments", texts)

    def folders(self, file: Path) -> list[str]:
        """The folders in which packages are searched: `package_dirs`, and those above the file."""
        return [str(folder) for folder in (*self.package_dirs, *file.resolve().parents)]

    def root(self, file: Path) -> ET.Element:
        """The root of a URDF; a file whose name ends in .xacro is expanded first.

        Raises:
            FileFormatError: the file is not XML, is a xacro file of another name, or cannot be expanded.
            InvalidInputError: arguments are given for a file that has none by its kind.
            MissingExtraError: the file is a xacro file, and the package xacro is not installed.
        """
        if file.suffix == ".xacro":
            text = xacro_files.expand(self._package_folders(file), self._texts(), trust=self.trust_file)
            return read_xml("file", file, "robot", text)
        root = read_xml("file", file, "robot")
        if any("xacro}" in each.tag for each in root.iter()):  # the library takes several namespaces
            raise FileFormatError(
                "file", str(file), "a URDF without elements of xacro; rename a xacro file so that it ends in .xacro"
            )
        if self.arguments:
            raise InvalidInputError("arguments", self.arguments, "none: only a file whose name ends in .xacro has arguments")
        return root

    def read(self, file: Path) -> str:
        """The text of a URDF as `resolve` leaves it."""
        root = self.root(file)
        self.resolve(file, root)
        return ET.tostring(root, encoding="unicode")

    def resolve(self, file: Path, root: ET.Element) -> None:
        """Put the folders of packages into the paths of a URDF, and leave out collision meshes if `meshes` is False."""
        folders = self._package_folders(file)
        for mesh in root.iter("mesh"):
            name, _, rest = str(mesh.get("filename", "")).removeprefix("package://").partition("/")
            if mesh.get("filename", "").startswith("package://"):
                folder = folders.find(name)
                if folder is not None and (name in self.packages or (folder / rest).is_file()):
                    mesh.set("filename", str(folder / rest))
        left_out = 0
        for link in root.findall("link") if not self.meshes else ():
            for collision in link.findall("collision"):
                if collision.find("geometry/mesh") is not None:
                    link.remove(collision)
                    left_out += 1
        if left_out:
            log.warning("%s: %d collision meshes are left out, and nothing is checked for them", file, left_out)

    def _package_folders(self, file: Path) -> PackageFolders:
        return PackageFolders(
            file=file.expanduser().absolute(),
            packages={name: Path(folder).expanduser().resolve() for name, folder in self.packages.items()},
            package_dirs=[Path(folder).expanduser().resolve() for folder in self.package_dirs],
        )

    def _texts(self) -> dict[str, str]:
        return {name: str(value) for name, value in self.arguments.items()}


def _text(argument: str, value: object) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str | int | float):
        return str(value)
    raise InvalidInputError(argument, value, "text, a number or a boolean")
