"""A controller or a servo as a C project that needs neither Python nor CasADi at run time.

A step in C: the source that CasADi generates, its wrapper, and both compiled as a library for this machine.
"""

import ctypes
import shutil
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np

from manipplan.support.checks import Array
from manipplan.support.compiler import load_library
from manipplan.support.errors import ManipplanError
from manipplan.support.files import writable_folder, write_text
from manipplan.support.kernels import source_text
from manipplan.support.untrusted import identifier
from manipplan.symbolic.machine_code import generate_source, native_flags
from manipplan.tracking.step import REPORT, STEP_NAME

if TYPE_CHECKING:
    from manipplan.tracking.controller import Controller
    from manipplan.tracking.servo import Servo


@dataclass(frozen=True, kw_only=True)
class Sources:
    """C sources of a controller: the generated step, and header and source of its wrapper."""

    step: str
    header: str
    wrapper: str

    @classmethod
    def of(cls, function: ca.Function, robot: str, dt: float) -> "Sources":
        """The sources of a step's Function."""
        step = _going_on(generate_source([function]))
        here = files("manipplan.tracking")
        numbers = {
            "ROBOT": identifier(robot),
            "JOINTS": function.size1_in("q"),
            "DT": repr(dt),
            "OBSTACLES": function.nnz_in("obstacles"),
            "MEMORY": function.nnz_in("memory"),
            "REPORT": len(REPORT),
            "FIGURES": ",\n".join(f"    CONTROLLER_{name.upper()} = {k}" for k, name in enumerate(REPORT)),
        }
        header = (here / "controller.h.in").read_text()
        for name, value in numbers.items():
            header = header.replace(f"@{name}@", str(value))
        return cls(step=step, header=header, wrapper=(here / "controller.c").read_text())


def _going_on(step: str) -> str:
    """The generated step, changed to return NaN where DAQP fails.

    CasADi's code returns there and keeps the outputs of the last step, which would look like a solution.
    """
    if "casadi_daqp_solve" not in step:  # a closed form, without a QP
        return step
    solve = "  casadi_daqp_solve(d, arg, res, iw, w);\n"
    leave = "  if (!d_qp.success) {\n    return -1;\n  }\n"
    if step.count(solve + leave) != 1 or step.count(solve) != 1:
        raise ManipplanError(f"CasADi {ca.__version__} generates other code for DAQP than is known; please report it")
    return step.replace(solve + leave, f"  d_qp.success = 0;\n{solve}  if (!d_qp.success) d_qp.x[0] = 0.0 / 0.0;\n")


class MachineCode:
    """A controller's compiled library.

    Attributes:
        function: the step as a CasADi Function that runs machine code.
    """

    def __init__(self, sources: Sources, subject: str) -> None:
        """Compile; raises CompilerError without a compiler or when it fails."""
        wrapper = sources.wrapper.replace('#include "controller.h"', sources.header)
        folder = daqp_folder()
        flags = (
            *native_flags(sources.step),
            f"-I{folder / 'include'}",
            f"-I{folder / 'include' / 'daqp'}",
            str(folder / "libdaqpstat.a"),
            "-lm",
        )

        def load(file: Path) -> tuple[ca.Function, ctypes.CDLL]:
            library = ctypes.CDLL(str(file))
            for name in ("controller_new", "controller_rollout", "controller_free", "controller_reset"):
                getattr(library, name).restype = ctypes.c_void_p if name == "controller_new" else ctypes.c_int
            return ca.external(STEP_NAME, str(file)), library

        self.function, self._library = load_library(f"{sources.step}\n{wrapper}", load, flags=flags, subject=subject)
        self._controller = ctypes.c_void_p(self._library.controller_new())

    def rollout(self, inputs: list[Array], q: Array, qd: Array, qdd: Array, report: Array) -> None:
        """Run N steps in C from the first rows of q and qd (N + 1, n); per step: target, stiffness, drive, tube, obstacles."""
        self._library.controller_reset(self._controller)
        arrays = [np.ascontiguousarray(each, dtype=np.float64) for each in inputs]
        pointers = [ctypes.c_void_p(each.ctypes.data) for each in (*arrays, q, qd, qdd, report)]
        if self._library.controller_rollout(self._controller, ctypes.c_int(len(q) - 1), *pointers) != 0:
            raise ManipplanError("the generated code of a step failed")

    def __del__(self) -> None:
        if hasattr(self, "_controller"):
            self._library.controller_free(self._controller)


def daqp_folder() -> Path:
    """Folder of DAQP in casadi's wheel: headers in `include`, and the static library."""
    return Path(ca.__file__).parent


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
        "example.c": _fill((here / "example.c.in").read_text(), _example(controller)),
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


def export_servo(servo: "Servo", folder: str | Path) -> list[Path]:
    """Write servo.h, servo.c, problem.c, example.c and CMakeLists.txt.

    Returns the files; raises InvalidInputError when the folder cannot be written.
    """
    to, here = writable_folder("folder", folder), files("manipplan.tracking")
    values = _values_of(servo)
    law = source_text("servo") + (here / "servo.c.in").read_text()
    texts = {
        "servo.h": _fill((here / "servo.h.in").read_text(), values),
        "servo.c": _fill(law, values),
        "problem.c": generate_source([servo.symbolic]),
        "example.c": _fill((here / "servo_example.c.in").read_text(), values),
        "CMakeLists.txt": (here / "servo_CMakeLists.txt.in").read_text(),
    }
    for name, text in texts.items():
        write_text(to / name, text)
    return [to / name for name in texts]


def _values_of(servo: "Servo") -> dict[str, str]:
    """Values for the templates of a servo."""
    from manipplan.tracking.servo import OUTPUTS, ServoStatus

    law: Any = servo.law
    sizes = [servo.symbolic.nnz_out(name) for name in OUTPUTS]
    constants = {name: _numbers(values.ravel()) for name, values in servo.constants.items() if name != "leader"}
    return {
        "ROBOT": identifier(servo.robot.name),
        "JOINTS": str(law.joints),
        "PHYSICAL": str(law.physical),
        "PAIRS": str(law.pairs),
        "KNOTS": str(law.knots),
        "DT": repr(servo.dt),
        "LONGEST": repr(law.slowest),
        "TIMEOUT": repr(law.timeout),
        "SMOOTHING": repr(law.smoothing),
        "SIDE": str(law.side),
        "WORLD_ROWS": str(len(servo.task.world_rows)),
        "TOOL_ROWS": str(len(servo.task.tool_rows)),
        "FREE_TURNS": str(law.free_turns),
        "OBSTACLES": str(servo.symbolic.nnz_in("obstacles")),
        "STATUSES": ",\n".join(f"    SERVO_{status.name} = {status.value}" for status in ServoStatus),
        "SIZES": ", ".join(map(str, sizes)),
        "NUMBERS": str(sum(sizes) + 1),
        "AROUND": _numbers(np.append(servo.obstacles, 0.0)),
        "START": _numbers(servo.robot.neutral),
        "LEADER": ", ".join(map(str, servo.constants["leader"].tolist())),
        **{name.upper(): text for name, text in constants.items()},
    }


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


def _fill(text: str, values: dict[str, str]) -> str:
    for name, value in values.items():
        text = text.replace(f"@{name}@", value)
    return text


def _numbers(values: Array) -> str:
    return ", ".join(repr(float(value)).replace("inf", "INFINITY") for value in values)
