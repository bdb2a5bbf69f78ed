"""Compiles MJCF files by MuJoCo, in a process of its own: a file from outside can take all memory or end the process.

MuJoCo expands a few lines into millions of bodies (`<replicate>`), prints warnings and writes a log into the working directory.
So repetitions are counted first, the file is compiled under limits of memory and time, without textures, sensors and keyframes,
and this process reads the model.
"""

import importlib.util
import logging
import math
import os
import tempfile
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Any

from manipplan.robots.xml_files import LARGEST, numbers, read_bounded_xml, read_xml
from manipplan.support import commands
from manipplan.support.errors import FileFormatError, MissingExtraError
from manipplan.support.untrusted import printable

log = logging.getLogger("manipplan")

#: Longest processor time, and longest time of a process that waits for others [s]. Robots with 100 MB of meshes take 1 to 3 s.
PROCESSOR, TIME_LIMIT = 20, 120.0
#: Largest memory of that process, and largest model [bytes].
MEMORY, WRITTEN = 4 * 2**30, 2**30
#: Largest number of elements after repetitions (MuJoCo takes minutes for a million), of heights of a height field, and of steps
#: of a mesh that MuJoCo makes.
MOST_ELEMENTS, MOST_HEIGHTS, RESOLUTION = 100_000, 250_000, 500.0
#: Elements with a count of repetitions, and as many elements as one repetition is worth.
REPEATED = {"replicate": 1, "flexcomp": 20, "composite": 20}
#: Numbers of a model that are checked, by the kind of element that they belong to.
CHECKED = {
    "body": ("body_pos", "body_quat", "body_ipos", "body_iquat"),
    "joint": ("jnt_pos", "jnt_axis", "jnt_range", "jnt_actfrcrange"),
    "geom": ("geom_pos", "geom_quat", "geom_size"),
    "site": ("site_pos", "site_quat"),
}


def compile_mjcf(file: Path) -> Any:
    """The `mujoco.MjModel` of an MJCF file; raises MissingExtraError where MuJoCo is not installed.

    Raises FileFormatError where MuJoCo cannot read the file, needs too much memory or time, or a number in it is too large.
    """
    _check_size(file, read_xml("file", file, "mujoco"))
    if importlib.util.find_spec("mujoco") is None:
        raise MissingExtraError("mujoco", "mujoco")
    with tempfile.TemporaryDirectory() as folder:
        request = {"file": str(file.expanduser().absolute()), "processor": PROCESSOR}
        try:
            answer, said = commands.ask_module(__name__, folder, request, limit=TIME_LIMIT, program="MuJoCo")
        except commands.NoAnswerError as error:
            raise _fault(file, str(error)) from error
        if "error" in answer:
            raise _fault(file, f"MuJoCo says: {answer['error']}")
        import mujoco

        model = mujoco.MjModel.from_binary_path(str(Path(folder, "model.mjb")))
    if said.strip():
        log.warning("%s: MuJoCo says: %s", file, printable(" ".join(said[:2000].split())))
    try:
        model.names.decode()
    except UnicodeDecodeError as error:  # in an included file
        raise _fault(file, f"its names are not in UTF-8 ({error})") from error
    _check_numbers(file, model)
    return model


def main(folder: str) -> None:
    """Compile the file of the request in `folder` into `model.mjb`; the answer has an error, if there is one."""
    request = commands.request_in(folder)
    commands.set_limits(memory=MEMORY, written=WRITTEN, processor=request["processor"])
    os.chdir(folder)  # for MuJoCo's log
    commands.write_answer(folder, _compile(request["file"]))


def _compile(file: str) -> dict[str, str]:
    os.environ["MUJOCO_GL"] = "disable"
    import mujoco

    try:
        spec = mujoco.MjSpec.from_file(file)
        _leave_out(spec, mujoco.mjtBuiltin.mjBUILTIN_FLAT)
        model = spec.compile()
        size = mujoco.mj_sizeModel(model)
        if size > WRITTEN:
            return {"error": f"the model has {size / 2**20:,.0f} MiB, at most {WRITTEN / 2**20:,.0f} are allowed"}
        mujoco.mj_saveModel(model, "model.mjb")
    except Exception as error:
        return {"error": " ".join(str(error).split()) or type(error).__name__}
    return {}


def _leave_out(spec: Any, flat: Any) -> None:
    """Take away from a model what no robot and no scene needs, whatever its size; materials need their textures' names."""
    for texture in spec.textures:
        texture.builtin, texture.width, texture.height, texture.nchannel = flat, 1, 1, 3
        texture.file, texture.cubefiles = "", [""] * 6
    for each in [*spec.sensors, *spec.keys]:
        spec.delete(each)
    spec.nkey = spec.nuserdata = 0
    spec.memory = spec.njmax = spec.nconmax = -1  # for a simulation
    for kind in ("body", "jnt", "geom", "site", "cam", "tendon", "actuator", "sensor"):
        setattr(spec, f"nuser_{kind}", -1)  # as many as there are


def _check_size(file: Path, root: ET.Element) -> None:
    """Raise FileFormatError where MuJoCo would make too many elements or too fine a mesh, those of included files counted."""
    included = {file.absolute()}

    def count(element: ET.Element) -> float:
        inner = [*element]
        if element.tag == "include":
            path = (file.parent / element.get("file", "")).absolute()
            if path not in included and path.is_file():  # MuJoCo includes a file once
                included.add(path)
                inner += [*read_bounded_xml("file", path)]
        name = element.get("name")
        if element.tag == "mesh" and element.get("builtin") and max(_numbers(element.get("params")), default=0) > RESOLUTION:
            raise _fault(file, f"meshes made with at most {RESOLUTION:g} steps; {name} has {element.get('params')}")
        rows, columns = element.get("nrow"), element.get("ncol")
        if element.tag == "hfield" and math.prod((*_numbers(rows), *_numbers(columns))) > MOST_HEIGHTS:
            raise _fault(file, f"height fields of at most {MOST_HEIGHTS} heights; {name} has {rows} x {columns}")
        repeats = math.prod(max(1.0, each) for each in _numbers(element.get("count"))) if element.tag in REPEATED else 1.0
        return repeats * (REPEATED.get(element.tag, 1) + sum(map(count, inner)))

    found = count(root)
    if not found <= MOST_ELEMENTS:
        raise _fault(file, f"at most {MOST_ELEMENTS} elements, and more than that stand in it once it is expanded")


def _numbers(text: str | None) -> tuple[float, ...]:
    """The numbers in an attribute; none where it holds anything else, which MuJoCo refuses."""
    return numbers(text, len((text or "").split()), largest=math.inf) or ()


def _check_numbers(file: Path, model: Any) -> None:
    """Raise FileFormatError, which names the element, where a number is not finite or larger than `LARGEST`."""
    import numpy as np

    for kind, names in CHECKED.items():
        for name in names:
            values = np.abs(getattr(model, name))
            wrong = np.flatnonzero(~(values <= LARGEST).all(axis=tuple(range(1, values.ndim))))
            if len(wrong):
                k = int(wrong[0])
                called = getattr(model, kind)(k).name or f"number {k}"
                wanted = f"{name.split('_')[1]} of the {kind} {called} is {getattr(model, name)[k].tolist()}"
                raise _fault(file, f"finite numbers up to {LARGEST:g}; {wanted}")


def _fault(file: Path, reason: str) -> FileFormatError:
    return FileFormatError("file", str(file), f"an MJCF file that MuJoCo can read; {printable(reason)[:600]}")
