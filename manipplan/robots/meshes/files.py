"""The mesh files of a robot, each judged before the mesh loader reads it."""

import xml.etree.ElementTree as ET
from collections.abc import Sequence
from pathlib import Path

from manipplan.robots.meshes import collada, ply
from manipplan.support.errors import FileFormatError

#: Formats of collision meshes, by the end of their names: by the contents of a file with another name the mesh loader would
#: choose one of its many other formats.
URDF_MESHES = (".stl", ".obj", ".dae", ".ply")


def fault_of(file: Path) -> str | None:
    """The fault in a mesh file on which the mesh loader could crash; None if there is none."""
    name = file.name.lower()
    if name.endswith(".ply"):
        return ply.fault_of(file)
    return collada.fault_of(file) if name.endswith(".dae") else None


def check_urdf_meshes(file: Path, root: ET.Element, folders: Sequence[str], place: Path) -> None:
    """Judge the meshes of a URDF's collision elements. PLY files are replaced by copies in `place`, also in `root`.

    Raises FileFormatError for a mesh that is not valid, or not in one of the formats `URDF_MESHES`.
    """
    for k, mesh in enumerate(root.iterfind("link/collision/geometry/mesh")):
        name = mesh.get("filename", "")
        _check_format(file, name, URDF_MESHES)
        for scheme in ("package://", "model://", "file://"):  # the first two mean the same to Pinocchio
            name = name.removeprefix(scheme)
        path = Path(name)
        try:
            found = next((each for each in (Path(folder) / name for folder in folders) if each.is_file()), None)
            if found is None:
                continue  # Pinocchio has an error for a missing file
            path = found
            if name.lower().endswith(".ply"):
                ply.write_ply(ply.read_surface(path), place / f"{k}.ply")
                mesh.set("filename", str(place / f"{k}.ply"))
            elif (fault := fault_of(path)) is not None:
                raise ValueError(fault)
        except (ValueError, OSError) as error:
            fault = getattr(error, "strerror", None) or str(error)
            wanted = f"a description whose meshes can be read; {str(path)[-200:]}: {fault}"
            raise FileFormatError("file", str(file), wanted) from error


def _check_format(file: Path, name: str, formats: Sequence[str]) -> None:
    if not name.lower().endswith(tuple(formats)):
        wanted = f"a description whose collision meshes are {', '.join(formats)} files, unlike {name}"
        raise FileFormatError("file", str(file), wanted)
