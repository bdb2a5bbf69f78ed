"""UrdfFiles: the options for reading a URDF or xacro file, and where its meshes are; `read_urdf` in description.py reads it.

Expands xacro files to URDF, in a process of its own: with a time limit, and without changes to this process.
"""

import importlib.util
import logging
import posixpath
import tempfile
import xml.etree.ElementTree as ET
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from manipplan.robots.packages import PackageFolders
from manipplan.robots.xml_files import read_xml
from manipplan.support import commands
from manipplan.support.checks import flag, one_of, path_of
from manipplan.support.errors import FileFormatError, InvalidInputError, MissingExtraError, UnknownNameError
from manipplan.support.untrusted import printable

log = logging.getLogger("manipplan")

#: Longest time for one file [s]: of the processor, and until it ends. Large robots take less than 2 s.
PROCESSOR, TIME_LIMIT = 4, 60.0


def expand(folders: PackageFolders, arguments: Mapping[str, object], *, trust: bool) -> str:
    """The URDF that `folders.file` expands to, with values of its `xacro:arg` elements by name; `trust`: see `trust_file`.

    Raises FileFormatError with xacro's reason, and the files and macros concerned; and as `Robot.from_urdf`.
    """
    if importlib.util.find_spec("xacro") is None:
        raise MissingExtraError("xacro", "xacro")
    file = folders.file
    request = {
        "file": str(file),
        "arguments": dict(arguments),
        "packages": {name: str(folder) for name, folder in folders.packages.items()},
        "package_dirs": [str(folder) for folder in folders.package_dirs],
        "trust": trust,
        "processor": PROCESSOR,
    }
    with tempfile.TemporaryDirectory() as folder:
        try:
            child = "manipplan.robots.xacro_child"
            answer, said = commands.ask_module(child, folder, request, limit=TIME_LIMIT, program="xacro")
        except commands.NoAnswerError as error:
            raise _fault(file, str(error)) from error
    if "error" in answer:
        where = " > ".join(answer["where"][1:])
        raise _fault(file, answer["error"] + (f"; in {where}" if where else ""))
    if said.strip():
        log.warning("%s: xacro says: %s", file, " ".join(said[:2000].split()))
    for name in arguments:
        if name not in answer["arguments"]:
            raise UnknownNameError("arguments", name, answer["arguments"], empty="none: the file has no arguments")
    return str(answer["urdf"])


def _fault(file: Path, reason: str) -> FileFormatError:
    return FileFormatError("file", str(file), f"a xacro file that can be expanded; {printable(reason)}")


#: Elements of a link that can be its bodies.
BODIES = ("collision", "visual")


@dataclass(frozen=True, kw_only=True)
class UrdfFiles:
    """How a URDF or xacro file is read, and where its meshes are: the arguments of `Robot.from_urdf` of these names.

    Numbers and booleans in `arguments` become text, as in ROS.

    Raises InvalidInputError when an attribute has another type, or a folder of `packages` does not exist.
    """

    package_dirs: Sequence[str | Path] = ()
    packages: Mapping[str, str | Path] = field(default_factory=dict)
    meshes: bool = True
    collision: str = "collision"
    arguments: Mapping[str, str | float | bool] = field(default_factory=dict)
    trust_file: bool = False

    def __post_init__(self) -> None:
        if isinstance(self.package_dirs, str | Path) or not isinstance(self.package_dirs, Sequence):
            raise InvalidInputError("package_dirs", self.package_dirs, "a list of folders")
        for k, folder in enumerate(self.package_dirs):
            path_of(f"package_dirs[{k}]", folder)
        if not isinstance(self.packages, Mapping):
            raise InvalidInputError("packages", self.packages, "a mapping from names of packages to their folders")
        for name, folder in self.packages.items():
            if not isinstance(folder, str | Path) or not Path(folder).expanduser().is_dir():
                raise InvalidInputError(f"packages[{name!r}]", str(folder), "an existing folder")
        flag("meshes", self.meshes)
        one_of("collision", self.collision, BODIES)
        flag("trust_file", self.trust_file)
        if not isinstance(self.arguments, Mapping):
            raise InvalidInputError("arguments", self.arguments, "a mapping from names of xacro arguments to their values")
        texts = {str(name): _text(f"arguments[{name!r}]", value) for name, value in self.arguments.items()}
        object.__setattr__(self, "arguments", texts)

    def root(self, file: Path) -> ET.Element:
        """The root of a URDF; a xacro file, and a URDF with expressions or elements of xacro, is expanded first.

        Raises as `expand`, and InvalidInputError where arguments are given for a file that has none by its kind.
        """
        if file.suffix != ".xacro":
            root = read_xml("file", file, "robot")
            if not _is_xacro(file, root):
                if self.arguments:
                    wanted = "none: only a xacro file has arguments"
                    raise InvalidInputError("arguments", self.arguments, wanted)
                return root
        text = expand(self._package_folders(file), self.arguments, trust=self.trust_file)
        return read_xml("file", file, "robot", text)

    def without_meshes(self, file: Path, root: ET.Element, kind: str) -> None:
        """Leave out the bodies that are meshes if `meshes` is False."""
        left_out = 0
        for link in root.findall("link") if not self.meshes else ():
            for body in link.findall(kind):
                if body.find("geometry/mesh") is not None:
                    link.remove(body)
                    left_out += 1
        if left_out:
            log.warning("%s: %d %s meshes are left out, and nothing is checked for them", file, left_out, kind)

    def mesh_file(self, file: Path, name: str) -> Path | None:
        """The file of a mesh by its name in a URDF; None if there is none.

        A name without package:// is looked for beside the URDF. One with it stays inside its package.
        """
        scheme, mark, rest = name.partition("://")
        folders = [*map(Path, self.package_dirs), *file.resolve().parents]
        if mark and scheme in ("package", "model"):
            rest = rest.lstrip("/")
            package, _, inner = rest.partition("/")
            if package in (".", "..") or posixpath.normpath(inner.lstrip("/")).split("/")[0] == "..":
                wanted = f"names of meshes that stay inside their package, unlike {name}"
                raise FileFormatError("file", str(file), wanted)
            found = self._package_folders(file).find(package)
            candidates = [found / inner] if found is not None else []
            if package not in self.packages:
                candidates += [folder / rest for folder in folders]
        elif mark and scheme != "file":
            raise FileFormatError("file", str(file), f"meshes named by package://, model://, file:// or a path, unlike {name}")
        else:
            path = Path(rest if mark else name)
            candidates = [path] if path.is_absolute() else [folder / path for folder in (file.resolve().parent, *folders)]
        try:
            return next((each for each in candidates if each.is_file()), None)
        except OSError as error:
            wanted = f"names of meshes that can be files ({error.strerror}), unlike {name}"
            raise FileFormatError("file", str(file), wanted) from error

    def _package_folders(self, file: Path) -> PackageFolders:
        return PackageFolders(
            file=file.expanduser().absolute(),
            packages={name: Path(folder).expanduser().resolve() for name, folder in self.packages.items()},
            package_dirs=[Path(folder).expanduser().resolve() for folder in self.package_dirs],
        )


def _is_xacro(file: Path, root: ET.Element) -> bool:
    """Whether a URDF has something that xacro expands: an element of it, or an expression where xacro is declared.

    ROS's parser passes over elements with the prefix xacro where it is not declared.
    """
    declared = [(name, space) for each in root.iter() for name, space in each.attrib.items() if name.startswith("xmlns:")]
    prefixes = {name.removeprefix("xmlns:") for name, space in declared if "xacro" in space}  # it has several namespaces
    elements = [each.tag for each in root.iter() if each.tag.partition(":")[0] in {*prefixes, "xacro"} and ":" in each.tag]
    if not prefixes:
        if elements:
            log.warning("%s: %d elements <xacro:...> are passed over: the file has no xmlns:xacro", file, len(elements))
        return False
    return bool(elements) or any("${" in text or "$(" in text for each in root.iter() for text in each.attrib.values())


def _text(argument: str, value: object) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str | int | float):
        return str(value)
    raise InvalidInputError(argument, value, "text, a number or a boolean")
