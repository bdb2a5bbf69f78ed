"""A controller as a C project that needs neither Python nor CasADi at run time."""

import shutil
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from manipplan.support.checks import Array
from manipplan.support.files import writable_folder, write_text
from manipplan.tracking.machine import daqp_folder

if TYPE_CHECKING:
    from manipplan.tracking.controller import Controller


def export_c(controller: "Controller", folder: str | Path) -> list[Path]:
    """Write controller.h, controller.c, step.c, example.c, CMakeLists.txt, DAQP's headers and static library (MIT licence).

    Returns the files; raises InvalidInputError when the folder cannot be written.
    """
    to = writable_folder("folder", folder)
    sources = controller.sources()
    here = files("manipplan.tracking")
    texts = {
        "controller.h": sources.header,
        "controller.c": sources.wrapper,
        "step.c": sources.step,
        "example.c": _filled((here / "example.c.in").read_text(), _example(controller)),
        "CMakeLists.txt": (here / "CMakeLists.txt.in").read_text(),
    }
    for name, text in texts.items():
        write_text(to / name, text)
    written = [to / name for name in texts]
    daqp = daqp_folder()
    for header in sorted((daqp / "include" / "daqp").glob("*.h")):
        written.append(to / "include" / "daqp" / header.name)
        written[-1].parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(header, written[-1])
    written.append(to / "lib" / "libdaqpstat.a")
    written[-1].parent.mkdir(exist_ok=True)
    shutil.copyfile(daqp / "libdaqpstat.a", written[-1])
    return written


def _example(controller: "Controller") -> dict[str, str]:
    """Values for the template of the example program: neutral configuration, its pose, defaults."""
    robot = controller.robot
    pose = robot.kinematics(controller.task).pose(robot.neutral)
    return {
        "START": _numbers(robot.neutral),
        "POSE": _numbers(pose.ravel()),
        "STIFFNESS": repr(controller.stiffness),
        "TOLERANCE": _numbers(controller.defaults["tolerance"]),
        "AROUND": _numbers(np.append(controller.defaults["obstacles"], 0.0)),
    }


def _filled(text: str, values: dict[str, str]) -> str:
    for name, value in values.items():
        text = text.replace(f"@{name}@", value)
    return text


def _numbers(values: Array) -> str:
    return ", ".join(repr(float(value)) for value in values)
