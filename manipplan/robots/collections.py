"""Robots of other collections by name: robot_descriptions, MuJoCo Menagerie, and the entry points of installed packages.

`ur5e_description` is a module of the package robot_descriptions, which keeps clones of the robots' repositories in a cache.
`menagerie:franka_fr3` is a folder of MuJoCo Menagerie: of the checkout that the environment variable MUJOCO_MENAGERIE names, or
downloaded by the package mujoco-menagerie. An entry point of the group `manipplan.robots` names a function that takes the
options of `load_robot` and returns a Robot.
"""

import contextlib
import importlib
import io
import logging
import os
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from importlib.metadata import EntryPoint, entry_points
from importlib.util import find_spec
from pathlib import Path
from typing import Any

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
#: Beginnings of names of Menagerie's files that hold no robot, or one for another engine.
NO_ROBOT = ("scene", "mjx_")


@dataclass(frozen=True, kw_only=True)
class RobotFile:
    """A file of a collection, with the options of `Robot.from_urdf` or `Robot.from_mjcf` with which it is read."""

    file: Path
    options: Mapping[str, Any] = field(default_factory=dict)


def robot_file(name: str) -> RobotFile | None:
    """The file of a name of robot_descriptions or of MuJoCo Menagerie; None for another name.

    Raises:
        UnknownNameError: the collection has no such robot, or the folder no such file; the nearest names are listed.
        MissingExtraError: the package is not installed.
        RobotNotFetchedError: the files are not in the cache, and could not be fetched.
        FileFormatError: the folder has no file of a robot, or several.
    """
    if name.startswith(MENAGERIE):
        return _of_menagerie(name)
    return _of_descriptions(name) if name.endswith(ENDING) else None


def own_robots() -> dict[str, EntryPoint]:
    """The entry points of installed packages, by name."""
    return {each.name: each for each in entry_points(group=GROUP)}


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
    module = _fetched(name, lambda: importlib.import_module(f"{DESCRIPTIONS}.{name}"))
    above = [Path(module.PACKAGE_PATH), Path(module.REPOSITORY_PATH)]
    folders = [*above, *(folder.parent for folder in above)]
    if not (hasattr(module, "URDF_PATH") or hasattr(module, "XACRO_PATH")):
        return RobotFile(file=Path(module.MJCF_PATH))
    options: dict[str, Any] = {"package_dirs": list(dict.fromkeys(folders))}
    if hasattr(module, "SRDF_PATH"):
        options["srdf"] = Path(module.SRDF_PATH)
    if hasattr(module, "URDF_PATH"):
        return RobotFile(file=Path(module.URDF_PATH), options=options)
    packages = {package: Path(folder) for package, folder in getattr(module, "XACRO_PACKAGE_PATHS", {}).items()}
    options |= {"arguments": dict(getattr(module, "XACRO_ARGS", {})), "packages": packages}
    return RobotFile(file=Path(module.XACRO_PATH), options={key: value for key, value in options.items() if value})


def _fetched(name: str, fetch: Callable[[], Any]) -> Any:
    """What `fetch` returns, quietly; whatever it raises is one of our errors, as it is another package's network code."""
    try:
        with _quiet():
            return fetch()
    except Exception as error:
        reason = getattr(error, "stderr", None) or str(error) or type(error).__name__
        if name.startswith(MENAGERIE):
            remedy = f"run: mujoco-menagerie prefetch {name.removeprefix(MENAGERIE)}   or set {CHECKOUT} to a checkout"
        else:
            remedy = f"run: python -m robot_descriptions pull {name}   or copy its folder from another machine"
            remedy += f" ({DESCRIPTIONS_CACHE}, by default ~/.cache/robot_descriptions)"
        raise RobotNotFetchedError(name, " ".join(str(reason).split()), remedy) from error


@contextlib.contextmanager
def _quiet() -> Iterator[None]:
    """Nothing on the terminal: no progress bar, no question of git for a password, no handler of its log."""
    before, asks = logging.root.manager.disable, os.environ.get("GIT_TERMINAL_PROMPT")
    os.environ["GIT_TERMINAL_PROMPT"] = "0"
    logging.disable(logging.WARNING)
    try:
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
            yield
    finally:
        logging.disable(before)
        if asks is None:
            del os.environ["GIT_TERMINAL_PROMPT"]
        else:
            os.environ["GIT_TERMINAL_PROMPT"] = asks


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
    folder = _fetched(f"{MENAGERIE}{folder_name}", lambda: robot.path(progress=None))
    return RobotFile(file=_robot_of(Path(folder), file_name, robot.entry(robot.default_model).file))


def _checkout(place: str) -> Path:
    root = Path(place).expanduser()
    if not root.is_dir():
        raise InvalidInputError(CHECKOUT, place, "the folder of a checkout of MuJoCo Menagerie, in this environment variable")
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
