"""Folders of ROS packages, with and without ROS, and which files a xacro file may read."""

import os
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

NAME = re.compile(r"[A-Za-z0-9_.-]*[A-Za-z0-9_-][A-Za-z0-9_.-]*")
MANIFEST = "package.xml"


@dataclass(frozen=True, kw_only=True)
class PackageFolders:
    """Where packages are looked for, in this order, and what may be read.

    1. `packages`. 2. The folders of that name in `package_dirs`. 3. Packages that contain `file`, and those beside it or beside
    a folder above it; they need a package.xml, because a file may ask for any name. 4. What ROS has installed, if its set-up
    script was run: AMENT_PREFIX_PATH and ROS_PACKAGE_PATH.

    `file` is the robot description, an absolute path; `packages` has folders by name, `package_dirs` folders of packages.
    """

    file: Path
    packages: Mapping[str, Path] = field(default_factory=dict)
    package_dirs: Sequence[Path] = ()
    _found: dict[str, Path | None] = field(default_factory=dict, init=False, repr=False, compare=False)

    def find(self, name: str) -> Path | None:
        """The folder of a package, looked for once; None if it is not found."""
        if name not in self._found:
            self._found[name] = self._find(name)
        return self._found[name]

    def _find(self, name: str) -> Path | None:
        if name in self.packages:
            return self.packages[name]
        if not NAME.fullmatch(name):
            return None
        candidates = [folder / name for folder in self.package_dirs]
        for folder in self.file.parents:
            candidates += [each for each in (folder, folder / name) if _name_in_manifest(each) == name]
        candidates += [folder / name for folder in _find_installed()]
        return next((each for each in candidates if each.is_dir()), None)

    def may_read(self, path: Path) -> bool:
        """Whether a file is in the package or folder of `file`, in a package that `find` can name, or installed with ROS.

        Links are followed first, except in what ROS has installed: there they are usual.
        """
        roots = [_package_of(self.file), _package_of(self.file.resolve()), *self.packages.values(), *self.package_dirs]
        real = path.resolve()
        for folder in real.parents:
            if (folder / MANIFEST).is_file() and folder.parent in self.file.parents:
                roots.append(folder)
        plain = Path(os.path.normpath(path.absolute()))
        return any(real.is_relative_to(each.resolve()) for each in roots) or any(map(plain.is_relative_to, _find_installed()))


def _package_of(file: Path) -> Path:
    """The folder of the package that contains a file; without one, the folder of the file."""
    return next((folder for folder in file.parents if (folder / MANIFEST).is_file()), file.parent)


def _name_in_manifest(folder: Path) -> str | None:
    """The name of the package in a folder; None without a package.xml."""
    try:
        text = (folder / MANIFEST).read_text(encoding="utf-8", errors="replace")
    except OSError:
        return None
    found = re.search(r"<name>\s*([^<\s]+)\s*</name>", text)
    return found[1] if found else folder.name


def _find_installed() -> Iterator[Path]:
    """The folders that contain the packages of ROS, from its environment variables."""
    for variable, below in (("AMENT_PREFIX_PATH", "share"), ("ROS_PACKAGE_PATH", "")):
        for folder in os.environ.get(variable, "").split(os.pathsep):
            if folder:
                yield Path(folder) / below
