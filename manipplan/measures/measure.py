"""Base classes of the manipulability measures: a scalar per posture, with unit, definition, source and derivatives."""

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import ClassVar

import casadi as ca
import numpy as np

from manipplan.support.checks import Array, ArrayLike, number, number_array
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError
from manipplan.support.expressions import making_expressions
from manipplan.symbolic.motion import Motion
from manipplan.symbolic.task import Task

#: ρ of the regularised form m_ρ = sqrt(det(J Jᵀ + ρ² I)), in units of the Jacobian's rows.
REGULARISATION = 1e-9


@one_line
@dataclass(frozen=True, kw_only=True)
class Posture:
    """The symbolic quantities that a measure may depend on.

    Attributes:
        q: (n, 1) symbols [rad or m].
        jacobian: the task's rows (m, n).
        motion: how `jacobian` changes with q.
        isometric: a Jacobian (m, n) with the same Yoshikawa manipulability, in the frame on the arm where it is simplest.
        smooth: a Jacobian with the same manipulability, and its motion, for derivatives of functions of det(J Jᵀ) alone.
        mass_matrix: M(q), (n, n), built when called.
        lower, upper: position limits (n,) [rad or m]; infinite where there are none.
        tools: the posture of each tool of the robot, by its name, built when called.
    """

    q: ca.SX
    jacobian: ca.SX
    motion: Motion
    isometric: ca.SX
    smooth: tuple[ca.SX, Motion]
    mass_matrix: Callable[[], ca.SX]
    lower: Array
    upper: Array
    tools: Callable[[], Mapping[str, "ToolPosture"]]


@one_line
@dataclass(frozen=True, kw_only=True)
class ToolPosture:
    """The posture of the arm that moves one tool of a robot.

    Attributes:
        posture: that of the arm, with symbols of its own.
        joints: indices of its joints among those of the robot.
        q: (n, 1) symbols of the robot.
    """

    posture: Posture
    joints: tuple[int, ...]
    q: ca.SX

    def placed(self, quantity: Callable[[Posture], ca.SX]) -> ca.SX:
        """A quantity of the arm as an expression of the robot's q."""
        made = ca.Function("placed", [self.posture.q], [quantity(self.posture)])
        return made.call([self.q[list(self.joints)]], True, False)[0]


class Measure(ABC):
    """A measure of manipulability; subclasses are frozen and hold their options.

    Attributes:
        name: the name that `Robot.kinematics(measure=...)` accepts.
        formula: its definition.
        source: citation key of its source.
        needs_full_rank: whether it is constant (zero, or not defined) for every arm with fewer joints than task rows.
        larger_is_better: whether it is at least zero and larger is better.
        over_tools: whether it combines the measures of all tools of a robot.
        constant: whether it is the same in every configuration, so that no configuration counts as singular.
    """

    name: ClassVar[str]
    formula: ClassVar[str]
    source: ClassVar[str]
    needs_full_rank: ClassVar[bool] = True
    larger_is_better: ClassVar[bool] = True
    over_tools: ClassVar[bool] = False
    constant: ClassVar[bool] = False

    @abstractmethod
    def unit(self, task: Task) -> str:
        """The unit of the value for a task of an arm with revolute joints."""

    @abstractmethod
    def value(self, posture: Posture) -> ca.SX:
        """The value, a scalar expression."""

    def gradient(self, posture: Posture) -> ca.SX:
        """The gradient with respect to q, (n, 1)."""
        return ca.gradient(self.value(posture), posture.q)

    def hessian(self, posture: Posture) -> ca.SX:
        """The Hessian with respect to q, (n, n)."""
        return ca.hessian(self.value(posture), posture.q)[0]

    def of_one_tool(self) -> "Measure":
        """The measure of each tool where this one combines those of several; otherwise the measure itself."""
        return self

    def check(self, m: int, n: int) -> None:
        """Raise InvalidInputError if the measure cannot be used for m task rows and n joints."""
        if self.needs_full_rank and m > n:
            raise InvalidInputError(
                "measure",
                self.name,
                f"at most as many task rows as joints; with {m} rows and {n} joints it is identically zero or not defined",
            )


class JacobianMeasure(Measure):
    """A measure that depends on the Jacobian alone; called with Jacobians (..., m, n), it returns their values (...)."""

    @abstractmethod
    def of(self, jacobian: ca.SX) -> ca.SX:
        """The value of a Jacobian (m, n), a scalar expression."""

    def value(self, posture: Posture) -> ca.SX:
        return self.of(posture.jacobian)

    def __call__(self, jacobian: ArrayLike) -> Array:
        """Values (...) of Jacobians (..., m, n).

        Raises InvalidInputError for NaN or inf, and for more rows than columns if the measure `needs_full_rank`.
        """
        matrices = number_array("jacobian", jacobian)
        if matrices.ndim < 2 or 0 in matrices.shape[-2:] or not np.isfinite(matrices).all():
            raise InvalidInputError("jacobian", jacobian, "finite matrices of shape (..., m, n)")
        m, n = matrices.shape[-2:]
        self.check(m, n)
        with making_expressions():
            symbols = ca.SX.sym("J", m, n)
            function = ca.Function("measure", [ca.vec(symbols)], [self.of(symbols)])
            del symbols
        columns = matrices.reshape(-1, m, n).transpose(0, 2, 1).reshape(-1, m * n)
        values = np.asarray(function(ca.DM(columns.T))) if len(columns) else np.empty(0)
        return np.array(values.reshape(matrices.shape[:-2]))


@dataclass(frozen=True, kw_only=True)
class Regularised(Measure):
    """A measure, or its derivatives, of J Jᵀ + ρ² I with ρ = `regularisation` > 0, so that they exist at a singularity."""

    regularisation: float = REGULARISATION

    def __post_init__(self) -> None:
        number("regularisation", self.regularisation, above=0.0)


class Dimensionless(Measure):
    """A measure without a unit."""

    def unit(self, task: Task) -> str:  # noqa: ARG002
        return "1"


def row_unit(task: Task) -> str:
    """Unit of a singular value; "mixed" if some rows are in metres and some in radians."""
    return {task.rows: "m", 0: "1"}.get(task.metres, "mixed")


def product_unit(task: Task, divisor: str) -> str:
    """Unit of a product of one value per row, each divided by `divisor`."""
    return f"{task.unit}/({divisor})" + (f"^{task.rows}" if task.rows > 1 else "")
