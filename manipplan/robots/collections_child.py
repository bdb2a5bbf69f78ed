"""Fetches a robot of another collection in a process of its own: see `collections`, which starts it.

The packages robot_descriptions and mujoco-menagerie clone repositories and download files. On the way they print progress bars
and log, and git asks for passwords; here nobody sees that.
"""

import importlib
import os
from collections.abc import Mapping
from typing import Any

from manipplan.support.commands import request_in, write_answer

#: Attributes of a module of robot_descriptions: paths, and mappings.
PATHS = ("URDF_PATH", "XACRO_PATH", "MJCF_PATH", "SRDF_PATH", "PACKAGE_PATH", "REPOSITORY_PATH")
MAPPINGS = ("XACRO_PACKAGE_PATHS", "XACRO_ARGS")


def main(folder: str) -> None:
    """Fetch the robot of the request in `folder`; the answer has its files, or the error."""
    request = request_in(folder)
    os.environ["GIT_TERMINAL_PROMPT"] = "0"
    try:
        answer = fetched(request["package"], request["name"])
    except Exception as error:  # whatever the network code of another package raises
        answer = {"error": str(getattr(error, "stderr", None) or error or type(error).__name__)}
    write_answer(folder, answer)


def fetched(package: str, name: str) -> Mapping[str, Any]:
    """The files of a module of robot_descriptions, by attribute, or `path`, the folder of a robot of mujoco_menagerie."""
    if package == "mujoco_menagerie":
        return {"path": str(importlib.import_module(package).get(name).path(progress=None))}
    module = importlib.import_module(f"{package}.{name}")
    paths = {each: str(getattr(module, each)) for each in PATHS if hasattr(module, each)}
    mappings = {each: getattr(module, each) for each in MAPPINGS if hasattr(module, each)}
    return paths | {each: {str(key): _plain(value) for key, value in items.items()} for each, items in mappings.items()}


def _plain(value: Any) -> Any:
    """A value of a xacro argument, or a path as text."""
    return value if isinstance(value, bool | int | float) else str(value)
