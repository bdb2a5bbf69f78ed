"""Transmission of velocity and force from the joints to the tool along one direction [chiu1988]."""

from dataclasses import dataclass
from typing import ClassVar

import casadi as ca
import numpy as np

from manipplan.measures.manipulability import REGULARISATION
from manipplan.measures.measure import JacobianMeasure, row_unit
from manipplan.support.checks import ArrayLike, finite_array, number
from manipplan.support.errors import InvalidInputError
from manipplan.symbolic.motion import Factor
from manipplan.symbolic.task import Task

#: Tolerance on the length of a direction that is already normalised.
UNIT = 1e-15


@dataclass(frozen=True, kw_only=True)
class _Transmission(JacobianMeasure):
    direction: ArrayLike

    def __post_init__(self) -> None:
        direction = finite_array("direction", self.direction, (None,))
        size = number("the length of direction", float(np.linalg.norm(direction)), above=1e-9)
        unit = direction if abs(size - 1.0) <= UNIT else direction / size  # dividing again would change the last digit
        object.__setattr__(self, "direction", tuple(unit.tolist()))

    def check(self, m: int, n: int) -> None:
        super().check(m, n)
        if np.size(self.direction) != m:
            raise InvalidInputError("direction", self.direction, f"{m} numbers, one per task row")

    @property
    def _unit_vector(self) -> ca.DM:
        return ca.DM(np.array(self.direction))


@dataclass(frozen=True, kw_only=True)
class VelocityTransmission(_Transmission):
    """β = (uᵀ (J Jᵀ + ρ² I)⁻¹ u)^(-1/2): the largest speed along u alone for joint speeds of norm 1.

    It is the distance from the centre to the surface of the velocity ellipsoid along u.

    Attributes:
        direction: u (m,) in task rows, of any length > 0.
        regularisation: ρ > 0, in the unit of the Jacobian's rows; where no motion along u is possible, β falls to ρ, not to 0.
    """

    regularisation: float = REGULARISATION
    name: ClassVar[str] = "velocity_transmission"
    formula: ClassVar[str] = "(uᵀ (J Jᵀ + ρ² I)⁻¹ u)^(-1/2)"
    source: ClassVar[str] = "chiu1988"
    needs_full_rank: ClassVar[bool] = False

    def __post_init__(self) -> None:
        super().__post_init__()
        number("regularisation", self.regularisation, above=0.0)

    def unit(self, task: Task) -> str:
        return row_unit(task)

    def of(self, jacobian: ca.SX) -> ca.SX:
        lower = Factor.of(jacobian, self.regularisation).L
        return 1 / ca.norm_2(ca.solve(lower, self._unit_vector))


@dataclass(frozen=True, kw_only=True)
class ForceTransmission(_Transmission):
    """α = (uᵀ J Jᵀ u)^(-1/2): the largest force along u that joint torques of norm 1 can hold; inf where it needs no torque.

    It is the distance from the centre to the surface of the force ellipsoid along u.

    Attributes:
        direction: u (m,) in task rows, of any length > 0.
    """

    name: ClassVar[str] = "force_transmission"
    formula: ClassVar[str] = "(uᵀ J Jᵀ u)^(-1/2)"
    source: ClassVar[str] = "chiu1988"
    needs_full_rank: ClassVar[bool] = False
    larger_is_better: ClassVar[bool] = False

    def unit(self, task: Task) -> str:
        return {"m": "1/m"}.get(row_unit(task), row_unit(task))

    def of(self, jacobian: ca.SX) -> ca.SX:
        return 1 / ca.norm_2(jacobian.T @ self._unit_vector)
