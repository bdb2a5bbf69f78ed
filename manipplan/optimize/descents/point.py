"""The program of a descent, and the paths it tries."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from manipplan.collision.proximity import NOTHING, ProximitySamples
from manipplan.optimize.descents.arithmetic import LengthModel
from manipplan.optimize.descents.clearance_search import ClearanceSearch
from manipplan.optimize.descents.rows import (
    ConstraintRows,
    ConstraintSamples,
    ConstraintSearch,
    FixedRows,
    FixedRowsAt,
    LimitRows,
    LinearRows,
    MeasuredRows,
    RowFunctions,
)
from manipplan.paths.joint import Curve
from manipplan.support.checks import Array

#: Rows are made for bodies within this distance of the target: metres per radian of the radius, at least and at most [m].
BAND, LEAST_BAND, MOST_BAND = 1.0, 2e-3, 0.1


@dataclass(frozen=True, kw_only=True, eq=False)
class DescentProgram:
    """Objective and constraints of a descent.

    Attributes:
        length: g as a function of the unknowns.
        limits: the joint limits.
        functions: functions of the clearance rows.
        clearance_search: distances of the true bodies; None: nothing is checked for collision.
        rows: without clearance_search, clearance rows that stay where they are; None: there are none.
        constraints: what is kept beside limits and clearance; None: nothing.
        held: (n,) whether a joint keeps its value.
    """

    length: LengthModel
    limits: LimitRows
    functions: RowFunctions
    clearance_search: ClearanceSearch | None
    rows: FixedRows | None = None
    constraints: ConstraintSearch | None = None
    held: NDArray[np.bool_] | None = None

    @cached_property
    def moving(self) -> Any:
        """Index of the unknowns (f n,) that steps may change."""
        if self.held is None or not self.held.any():
            return slice(None)
        return np.flatnonzero(np.tile(~self.held, self.length.curves.directions.shape[1]))

    def find_near(self, curve: Curve, radius: float) -> ProximitySamples:
        """The bodies near a curve, within the distance that a step of `radius` can use up."""
        if self.clearance_search is None:
            return NOTHING
        return self.clearance_search.find_near(curve, min(max(BAND * radius, LEAST_BAND), MOST_BAND))

    def measured(self, z: Array) -> MeasuredRows:
        """The rows at z (f, n) of the bodies near there."""
        assert self.clearance_search is not None
        curve = self.length.curves.curve(z)
        return MeasuredRows.of(self.length.curves, self.clearance_search, z, curve, self.find_near(curve, 0.0))


@dataclass(frozen=True, kw_only=True, eq=False)
class Point:
    """A path that was tried.

    Attributes:
        program: what is minimised.
        z: its unknowns (f, n).
        value: g over g₀; inf where it is not finite.
        curve: the path.
        samples: the bodies near it.
        constraint_samples: the constraints near their limits; None where there are none.
    """

    program: DescentProgram
    z: Array
    value: float
    curve: Curve
    samples: ProximitySamples
    constraint_samples: ConstraintSamples | None

    @classmethod
    def of(cls, program: DescentProgram, z: Array, radius: float) -> "Point":
        """The path at z (f, n), with the bodies that a step of `radius` can reach."""
        curve, value = program.length.curves.curve(z), program.length.value(z)
        return cls(
            program=program,
            z=z,
            value=value if np.isfinite(value) else np.inf,
            curve=curve,
            samples=program.find_near(curve, radius),
            constraint_samples=None if program.constraints is None else program.constraints.find_near(curve, radius),
        )

    @cached_property
    def violation(self) -> float:
        """Largest violation of limits, target clearance and constraints [rad or m]."""
        program, short = self.program, 0.0
        if program.clearance_search is not None:
            short = max(program.clearance_search.target - self.samples.least, 0.0)
        elif program.rows is not None:
            short = self._fixed.violation
        if self.constraint_samples is not None:
            short = max(short, self.constraint_samples.violation)
        return max(short, program.limits.violation(self._control))

    @cached_property
    def rows(self) -> tuple[MeasuredRows | FixedRowsAt | ConstraintRows, ...]:
        """The rows of clearance and of constraints here, none where nothing is checked."""
        program, curves = self.program, self.program.length.curves
        found: list[MeasuredRows | FixedRowsAt | ConstraintRows] = []
        if program.rows is not None:
            found.append(self._fixed)
        elif program.clearance_search is not None:
            found.append(MeasuredRows.of(curves, program.clearance_search, self.z, self.curve, self.samples))
        if program.constraints is not None and self.constraint_samples is not None:
            found.append(ConstraintRows(curves=curves, search=program.constraints, z=self.z, samples=self.constraint_samples))
        return tuple(found)

    @cached_property
    def linear(self) -> LinearRows:
        """All these rows for steps from here."""
        whole = LinearRows.none(self.z.size)
        for each in self.rows:
            whole = whole.with_rows(each.linear)
        return whole

    def curvature(self, multipliers: Array) -> Array:
        """Σ_i λ_i ∇²c_i (f n, f n) of these rows, with multipliers λ (r,)."""
        total, first = np.zeros((self.z.size, self.z.size)), 0
        for each in self.rows:
            count = len(each.linear.value)
            total += each.curvature(multipliers[first : first + count])
            first += count
        return total

    @cached_property
    def _fixed(self) -> FixedRowsAt:
        assert self.program.rows is not None
        return self.program.rows.at(self.z)

    def limits(self, radius: float) -> LinearRows:
        """The joint limits that a step whose entries are at most `radius` can reach."""
        return self.program.limits.near(self._control, radius)

    def merit(self, penalty: float) -> float:
        """φ = g + ν v."""
        return self.value + penalty * self.violation

    @cached_property
    def _control(self) -> Array:
        """The control points (r, n) that keep the joint limits."""
        return self.program.limits.points(self.z)
