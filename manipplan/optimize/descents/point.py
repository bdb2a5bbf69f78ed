"""The program of a descent, and the paths it tries."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from manipplan.collision.look import NOTHING, Look
from manipplan.optimize.descents.fixed_rows import FixedRows, FixedRowsAt
from manipplan.optimize.descents.length import LengthModel
from manipplan.optimize.descents.rows import LimitRows, LinearRows, MeasuredRows, RowFunctions
from manipplan.optimize.descents.surroundings import Surroundings
from manipplan.paths.curves import Curve
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
        surroundings: distances of the true bodies; None: nothing is checked for collision.
        rows: without surroundings, clearance rows that stay where they are; None: there are none.
    """

    length: LengthModel
    limits: LimitRows
    functions: RowFunctions
    surroundings: Surroundings | None
    rows: FixedRows | None = None

    def look(self, curve: Curve, radius: float) -> Look:
        """The bodies near a curve, within the distance that a step of `radius` can use up."""
        if self.surroundings is None:
            return NOTHING
        return self.surroundings.look(curve, min(max(BAND * radius, LEAST_BAND), MOST_BAND))

    def measured(self, z: Array) -> MeasuredRows:
        """The rows at z (f, n) of the bodies near there."""
        assert self.surroundings is not None
        curve = self.length.curves.curve(z)
        return MeasuredRows.of(self.length.curves, self.surroundings, z, curve, self.look(curve, 0.0))


@dataclass(frozen=True, kw_only=True, eq=False)
class Point:
    """A path that was tried.

    Attributes:
        program: what is minimised.
        z: its unknowns (f, n).
        value: g over g₀; inf where it is not finite.
        curve: the path.
        look: the bodies near it.
    """

    program: DescentProgram
    z: Array
    value: float
    curve: Curve
    look: Look

    @classmethod
    def of(cls, program: DescentProgram, z: Array, radius: float) -> "Point":
        """The path at z (f, n), with the bodies that a step of `radius` can reach."""
        curve, value = program.length.curves.curve(z), program.length.value(z)
        return cls(
            program=program,
            z=z,
            value=value if np.isfinite(value) else np.inf,
            curve=curve,
            look=program.look(curve, radius),
        )

    @cached_property
    def violation(self) -> float:
        """Largest violation of limits and target clearance [rad or m]."""
        program, short = self.program, 0.0
        if program.surroundings is not None:
            short = max(program.surroundings.target - self.look.least, 0.0)
        elif isinstance(self.rows, FixedRowsAt):
            short = self.rows.violation
        return max(short, program.limits.violation(self._control))

    @cached_property
    def rows(self) -> MeasuredRows | FixedRowsAt | None:
        """The clearance rows here; None where nothing is checked."""
        program = self.program
        if program.rows is not None:
            return program.rows.at(self.z)
        if program.surroundings is None:
            return None
        return MeasuredRows.of(program.length.curves, program.surroundings, self.z, self.curve, self.look)

    @property
    def clearance(self) -> LinearRows:
        """The clearance rows for steps from here."""
        return LinearRows.none(self.z.size) if self.rows is None else self.rows.linear

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
