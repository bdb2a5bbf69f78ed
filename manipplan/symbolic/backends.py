"""Choice of a robot's symbolic kinematics: our own chain, or Pinocchio's algorithms with CasADi scalars."""

from typing import TYPE_CHECKING, ClassVar

import casadi as ca

from manipplan.robots.model_tree import frame_index
from manipplan.support.checks import one_of
from manipplan.support.errors import InvalidInputError
from manipplan.support.memo import once_per_source
from manipplan.symbolic.chain import Placement, SymbolicChain
from manipplan.symbolic.pinocchio_casadi import bindings_installed, pinocchio_casadi

if TYPE_CHECKING:
    from manipplan.robots.robot import Robot

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
