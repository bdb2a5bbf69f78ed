"""Robots of other collections by name: robot_descriptions, MuJoCo Menagerie, and the entry points of installed packages.

`ur5e_description` is a module of the package robot_descriptions, which keeps clones of the robots' repositories in a cache.
`menagerie:franka_fr3` is a folder of MuJoCo Menagerie: of the checkout that the environment variable MUJOCO_MENAGERIE names, or
downloaded by the package mujoco-menagerie. An entry point of the group `manipplan.robots` names a function that takes the
options of `load_robot` and returns a Robot, or the path of a robot's file.
"""

import importlib
import os
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass, field
from importlib.metadata import EntryPoint, entry_points
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from manipplan.support import commands
from manipplan.support.errors import (
    FileFormatError,
    InvalidInputError,
    MissingExtraError,
    RobotNotFetchedError,
    UnknownNameError,
)

#: Ending of the names of robot_descriptions, and its package; its cache folder.
ENDING, DESCRIPTIONS, DESCRIPTIONS_CACHE = "_description", "robot_descriptions", "ROBOT_DESCRIPTIONS_CACHE"
#: Beginning of the names of MuJoCo Menagerie's folders; the variable with a checkout; the package that downloads them.
MENAGERIE, CHECKOUT, DOWNLOADER = "menagerie:", "MUJOCO_MENAGERIE", "mujoco_menagerie"
#: Group of the entry points of other packages.
GROUP = "manipplan.robots"
#: Longest time in which a robot is fetched [s].
TIME_LIMIT = 3600.0
#: Beginnings of names of Menagerie's files that hold no robot, or one for another engine.
NO_ROBOT = ("scene", "mjx_")


@dataclass(frozen=True, kw_only=True)
class RobotFile:
    """A file of a collection, with the options of `Robot.from_urdf` or `Robot.from_mjcf` with which it is read."""

    file: Path
    options: Mapping[str, Any] = field(default_factory=dict)


def robot_file(name: str) -> RobotFile | None:
    """The file of a name of robot_descriptions or of MuJoCo Menagerie; None for another name. Raises as `load_robot`."""
    if name.startswith(MENAGERIE):
        return _of_menagerie(name)
    return _of_descriptions(name) if name.endswith(ENDING) else None


def own_robots() -> dict[str, list[EntryPoint]]:
    """The entry points of installed packages, by name; no package is imported for it. Several packages may use one name."""
    found: dict[str, list[EntryPoint]] = {}
    for each in entry_points(group=GROUP):
        found.setdefault(each.name, []).append(each)
    return found


def package_of(point: EntryPoint) -> str:
    """Name and version of the package that has an entry point."""
    return "a package without a name" if point.dist is None else f"{point.dist.name} {point.dist.version}"


def names_of_collections() -> dict[str, list[str]]:
    """The names that can be had on this machine, by collection; a collection whose package is missing has none."""
    found: dict[str, list[str]] = {"robot_descriptions": [], "MuJoCo Menagerie": []}
    if find_spec(DESCRIPTIONS) is not None:
        found["robot_descriptions"] = sorted(importlib.import_module(DESCRIPTIONS).DESCRIPTIONS)
    checkout = os.environ.get(CHECKOUT)
    if checkout:
        found["MuJoCo Menagerie"] = [f"{MENAGERIE}{each}" for each in _folders(_checkout(checkout))]
    elif find_spec(DOWNLOADER) is not None:
        found["MuJoCo Menagerie"] = [f"{MENAGERIE}{each}" for each in importlib.import_module(DOWNLOADER).names()]
    return found


def _of_descriptions(name: str) -> RobotFile:
    if find_spec(DESCRIPTIONS) is None:
        raise MissingExtraError("robot_descriptions", "descriptions")
    known = importlib.import_module(DESCRIPTIONS).DESCRIPTIONS
    if name not in known:
        raise UnknownNameError("name", name, known)
    found = _fetch(name, DESCRIPTIONS, name)
    above = [Path(found["PACKAGE_PATH"]), Path(found["REPOSITORY_PATH"])]
    if not {"URDF_PATH", "XACRO_PATH"} & set(found):
        return RobotFile(file=Path(found["MJCF_PATH"]))
    options: dict[str, Any] = {"package_dirs": list(dict.fromkeys([*above, *(folder.parent for folder in above)]))}
    if "SRDF_PATH" in found:
        options["srdf"] = Path(found["SRDF_PATH"])
    if "URDF_PATH" in found:
        return RobotFile(file=Path(found["URDF_PATH"]), options=options)
    packages = {package: Path(folder) for package, folder in found.get("XACRO_PACKAGE_PATHS", {}).items()}
    options |= {"arguments": found.get("XACRO_ARGS", {}), "packages": packages}
    return RobotFile(file=Path(found["XACRO_PATH"]), options={key: value for key, value in options.items() if value})


def _fetch(name: str, package: str, robot: str) -> dict[str, Any]:
    """The files of a robot of a package, from its cache or the network, by `collections_child` in a process of its own."""
    child, program = "manipplan.robots.collections_child", "the process that fetches it"
    with tempfile.TemporaryDirectory() as folder:
        try:
            request = {"package": package, "name": robot}
            answer, _ = commands.ask_module(child, folder, request, limit=TIME_LIMIT, program=program)
        except commands.NoAnswerError as error:
            answer = {"error": str(error)}
    if "error" not in answer:
        return answer
    if name.startswith(MENAGERIE):
        remedy = f"run: mujoco-menagerie prefetch {robot}   or set {CHECKOUT} to a checkout"
    else:
        remedy = f"run: python -m robot_descriptions pull {name}   or copy its folder from another machine"
        remedy += f" ({DESCRIPTIONS_CACHE}, by default ~/.cache/robot_descriptions)"
    raise RobotNotFetchedError(name, " ".join(answer["error"].split()), remedy)


def _of_menagerie(name: str) -> RobotFile:
    folder_name, _, file_name = name.removeprefix(MENAGERIE).partition("/")
    checkout = os.environ.get(CHECKOUT)
    if checkout:
        root = _checkout(checkout)
        folders = _folders(root)
        if folder_name not in folders:
            raise UnknownNameError(f"name ({root})", folder_name, folders)
        return RobotFile(file=_robot_of(root / folder_name, file_name, None))
    if find_spec(DOWNLOADER) is None:
        raise MissingExtraError(f"mujoco-menagerie (or a checkout of MuJoCo Menagerie in {CHECKOUT})", "menagerie")
    package = importlib.import_module(DOWNLOADER)
    if folder_name not in package.names():
        raise UnknownNameError("name", folder_name, package.names())
    robot = package.get(folder_name)
    folder = _fetch(f"{MENAGERIE}{folder_name}", DOWNLOADER, folder_name)["path"]
    return RobotFile(file=_robot_of(Path(folder), file_name, robot.entry(robot.default_model).file))


def _checkout(folder: str) -> Path:
    root = Path(folder).expanduser()
    if not root.is_dir():
        raise InvalidInputError(CHECKOUT, folder, "the folder of a checkout of MuJoCo Menagerie, in this environment variable")
    return root


def _folders(root: Path) -> list[str]:
    """Names of the folders with robots of a checkout."""
    return sorted(each.name for each in root.iterdir() if each.is_dir() and any(each.glob("*.xml")))


def _robot_of(folder: Path, file_name: str, usual: str | None) -> Path:
    """The file of a robot in a folder: the given one, the usual one, the only one, or that with the folder's name."""
    files = sorted(each.name for each in folder.glob("*.xml"))
    if file_name:
        if file_name not in files:
            raise UnknownNameError(f"name ({folder.name})", file_name, files)
        return folder / file_name
    robots = [each for each in files if not each.startswith(NO_ROBOT)]
    named = [each for each in robots if f"_{folder.name}".endswith(f"_{Path(each).stem}")]
    for choice in ([usual] if usual is not None else [], robots, named):
        if len(choice) == 1:
            return folder / choice[0]
    calls = ", ".join(f"{MENAGERIE}{folder.name}/{each}" for each in robots)
    raise FileFormatError("name", f"{MENAGERIE}{folder.name}", f"a folder with one robot; choose one: {calls or 'it has none'}")
