"""Choice of a robot's symbolic kinematics: our own chain, or Pinocchio's algorithms with CasADi scalars.

Pinocchio's algorithms as CasADi Functions, without conda: pose, Jacobian, mass matrix, inverse and forward dynamics. The wheel
of `pin` lacks the module pinocchio.casadi but contains all headers. A small C++ bridge is compiled with them once on this
machine and kept in the user's cache folder; it returns serialised CasADi Functions as text.
"""

import ctypes
import importlib.metadata
import logging
import platform
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar

import casadi as ca

from manipplan.robots.model_tree import frame_index
from manipplan.support.checks import one_of
from manipplan.support.compiler import load_library
from manipplan.support.display import one_line
from manipplan.support.errors import CompilerError, InvalidInputError, ManipplanError
from manipplan.support.memo import once_per_owner, once_per_source
from manipplan.symbolic.chain import Placement, SymbolicChain

if TYPE_CHECKING:
    from manipplan.robots.robot import Robot

log = logging.getLogger("manipplan")

SOURCES = ("auto", "bindings", "bridge")


@one_line
@dataclass(frozen=True, kw_only=True)
class PinocchioCasadi:
    """CasADi Functions (SX) of one robot; q, qd, qdd and tau are (n,), SI units.

    Attributes:
        pose: T_world_tool (4, 4) of q.
        jacobian: LOCAL_WORLD_ALIGNED Jacobian of the tool (6, n) of q, linear rows first.
        joints: placements of the world and of all joints side by side, (4, 4 (n + 1)), of q.
        mass_matrix: M (n, n) of q, by the composite-rigid-body algorithm.
        rnea: tau = M qdd + C qd + g of (q, qd, qdd), inverse dynamics by recursive Newton-Euler.
        aba: qdd of (q, qd, tau), forward dynamics by the articulated-body algorithm.
        source: "bindings" (pinocchio.casadi) or "bridge".
    """

    pose: ca.Function
    jacobian: ca.Function
    joints: ca.Function
    mass_matrix: ca.Function
    rnea: ca.Function
    aba: ca.Function
    source: str


def pinocchio_casadi(robot: "Robot", *, source: str = "auto") -> PinocchioCasadi:
    """Build Pinocchio's CasADi algorithms for a robot.

    Args:
        robot: the arm.
        source: "bindings" uses the module pinocchio.casadi, "bridge" compiles the wheel's headers with the machine's C++
            compiler (about two minutes, once), "auto" takes the bindings where they can be imported, otherwise the bridge.

    Raises:
        CompilerError: the bridge is needed and there is no C++ compiler, or it fails; the error holds its message.
        UnknownNameError: no such source.
        InvalidInputError: source is "bindings" and pinocchio.casadi cannot be imported.
    """
    from manipplan.robots.robot import Robot

    if not isinstance(robot, Robot):
        raise InvalidInputError("robot", robot, "a Robot, such as mp.load_robot('panda')")
    one_of("source", source, SOURCES)
    if robot.followers:
        wanted = f"a robot without joints that follow others, unlike {', '.join(robot.followers)}: backend='chain' has them"
        raise InvalidInputError("robot", robot.name, f"{wanted}; Pinocchio's mimic joints cannot be handed over")
    if source == "auto":
        source = "bindings" if bindings_installed() else "bridge"
    return _by_bindings(robot) if source == "bindings" else _by_bridge(robot)


@cache
def bindings_installed() -> bool:
    """Whether the module pinocchio.casadi can be imported."""
    try:
        import pinocchio.casadi  # noqa: F401
    except ImportError:
        return False
    return True


@once_per_owner
def _by_bindings(robot: "Robot") -> PinocchioCasadi:
    if not bindings_installed():
        raise InvalidInputError(
            "source", "bindings", "'bridge' here: this Pinocchio has no pinocchio.casadi (conda-forge builds have it)"
        )
    import pinocchio.casadi as cpin

    n = robot.n
    q, qd, qdd, tau = (ca.SX.sym(name, n) for name in ("q", "qd", "qdd", "tau"))
    model = cpin.Model(robot.model)
    data, frame = model.createData(), frame_index(robot.model, robot.tool)
    cpin.computeJointJacobians(model, data, q)
    cpin.updateFramePlacements(model, data)
    jacobian = cpin.getFrameJacobian(model, data, frame, cpin.ReferenceFrame.LOCAL_WORLD_ALIGNED)
    joints = ca.horzcat(*(data.oMi[i].homogeneous for i in range(n + 1)))
    pose = data.oMf[frame].homogeneous
    mass = ca.triu(cpin.crba(model, data, q))
    mass = mass + ca.triu(mass, False).T
    return PinocchioCasadi(
        pose=ca.Function("pose", [q], [pose], ["q"], ["T"]),
        jacobian=ca.Function("jacobian", [q], [jacobian], ["q"], ["J"]),
        joints=ca.Function("joints", [q], [joints], ["q"], ["T"]),
        mass_matrix=ca.Function("mass_matrix", [q], [mass], ["q"], ["M"]),
        rnea=ca.Function("rnea", [q, qd, qdd], [cpin.rnea(model, data, q, qd, qdd)], ["q", "qd", "qdd"], ["tau"]),
        aba=ca.Function("aba", [q, qd, tau], [cpin.aba(model, data, q, qd, tau)], ["q", "qd", "tau"], ["qdd"]),
        source="bindings",
    )


@once_per_owner
def _by_bridge(robot: "Robot") -> PinocchioCasadi:
    library = _bridge()
    text = ctypes.c_void_p()
    frame = frame_index(robot.model, robot.tool)
    failed = library.manipplan_functions(robot.model.saveToString().encode(), frame, ctypes.byref(text))
    answer = ctypes.string_at(text.value or 0).decode()
    library.manipplan_free(text)
    if failed:
        raise ManipplanError(f"Pinocchio's symbolic algorithms for {robot.name}: {answer}")
    pose, jacobian, joints, mass_matrix, rnea, aba = ca.StringDeserializer(answer).unpack()
    return PinocchioCasadi(
        pose=pose, jacobian=jacobian, joints=joints, mass_matrix=mass_matrix, rnea=rnea, aba=aba, source="bridge"
    )


@cache
def _bridge() -> ctypes.CDLL:
    """The compiled bridge, loaded."""
    source = Path(__file__).with_name("pinocchio_bridge.cpp").read_text(encoding="utf-8")
    pinocchio = _prefix("libpinocchio", "include/pinocchio/autodiff/casadi.hpp")
    casadi = Path(ca.__file__).parent
    # part of the cache key: each version needs its own library
    packages = {"PINOCCHIO": "libpinocchio", "CASADI": "casadi", "BOOST": "cmeel-boost"}
    versions = [f"-DMANIPPLAN_{name}={_version(package)}" for name, package in packages.items()]
    flags = [
        "-std=c++17",
        "-O1",
        "-w",
        *versions,
        f"-I{pinocchio / 'include'}",
        f"-I{casadi / 'include'}",
        f"-I{casadi / 'include' / 'eigen3'}",
        *(f"-L{folder}" for folder in (pinocchio / "lib", casadi)),
        *(f"-Wl,-rpath,{folder}" for folder in (pinocchio / "lib", casadi)),
        *(["-Wl,--no-as-needed"] if platform.system() == "Linux" else []),
        "-lpinocchio_default",
        "-lboost_serialization",
        "-lcasadi",
    ]
    subject = "Pinocchio's algorithms for CasADi, once per machine, about two minutes"
    return load_library(source, _load, flags=flags, language="c++", subject=subject, announce=True)


def _load(file: Path) -> ctypes.CDLL:
    library = ctypes.CDLL(str(file))
    library.manipplan_functions.argtypes = [ctypes.c_char_p, ctypes.c_ulong, ctypes.POINTER(ctypes.c_void_p)]
    library.manipplan_functions.restype = ctypes.c_int
    library.manipplan_free.argtypes = [ctypes.c_void_p]
    return library


def _version(package: str) -> str:
    try:
        return importlib.metadata.version(package)
    except importlib.metadata.PackageNotFoundError as error:
        wanted = f"the bridge needs the wheel {package}, which is not installed; install it with: pip install pin casadi"
        raise CompilerError("Pinocchio's algorithms for CasADi", wanted) from error


def _prefix(package: str, header: str) -> Path:
    """The folder above include/ and lib/ in an installed wheel."""
    for file in importlib.metadata.files(package) or ():
        if str(file).endswith(header):
            return Path(str(file.locate())).parents[len(Path(header).parts) - 1]
    raise CompilerError(package, f"its wheel does not contain {header}; run: pip install --force-reinstall {package}")


BACKENDS = ("auto", "chain", "bindings", "bridge")


def chain_of(robot: "Robot", backend: str) -> SymbolicChain:
    """The arm at symbolic q from one of `BACKENDS`, built once per robot."""
    one_of("backend", backend, BACKENDS)
    if backend == "bindings" and not bindings_installed():
        wanted = "'auto', 'chain' or 'bridge': this Pinocchio has no pinocchio.casadi (conda-forge builds have it)"
        raise InvalidInputError("backend", backend, wanted)
    if backend == "auto":
        backend = "bindings" if bindings_installed() and not robot.followers else "chain"
    return _chain(robot, backend)


@once_per_source
def _chain(robot: "Robot", backend: str) -> SymbolicChain:
    return SymbolicChain.of(robot.model, robot.tool) if backend == "chain" else PinocchioChain.by(robot, backend)


class PinocchioChain(SymbolicChain):
    """A symbolic chain with every expression built by Pinocchio."""

    own: ClassVar[bool] = False

    @classmethod
    def by(cls, robot: "Robot", source: str) -> "PinocchioChain":
        """Build the chain with "bindings" or "bridge"."""
        functions = pinocchio_casadi(robot, source=source)
        q = ca.SX.sym("q", robot.n)
        matrices = ca.horzsplit(functions.joints(q), 4)
        chain = cls(
            model=robot.model,
            tree=robot.tree,
            frame=robot.model.frames[frame_index(robot.model, robot.tool)],
            q=q,
            joints=tuple(_placement(matrix) for matrix in matrices),
            tool=_placement(functions.pose(q)),
            jacobian=ca.sparsify(functions.jacobian(q)),
        )
        chain.__dict__["mass_matrix"] = functions.mass_matrix(q)
        return chain


def _placement(matrix: ca.SX) -> Placement:
    return Placement(rotation=ca.sparsify(matrix[:3, :3]), origin=ca.sparsify(matrix[:3, 3]))
