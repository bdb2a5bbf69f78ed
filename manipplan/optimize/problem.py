"""Solves of the path program: coefficients in a basis that minimise the energy, or g, within joint limits and clearance rows.

Everything that changes from one solve to the next (ends, guess, rows) is a parameter of the program in `nlp`, so it is built
once for an objective and a basis.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import casadi as ca
import numpy as np

from manipplan.checks import Array
from manipplan.interrupts import interruptible
from manipplan.optimize.basis import Basis
from manipplan.optimize.density import Density, energy_density, length_density
from manipplan.optimize.ends import free_directions
from manipplan.optimize.nlp import Hull, Integral, ipopt_solver
from manipplan.optimize.objective import PathObjective
from manipplan.optimize.rows import ClearanceRow, column_height, met_column, row_functions
from manipplan.paths.joint import JointPath

#: Gauss points of the energy on the whole path, and at least on each piece.
NODES, PIECE_NODES = 40, 8
#: Panels of ten Gauss points each on which g is polished: the next where these do not see how narrow a dip of the index is.
POLISH_PANELS = (12, 48, 192)
#: A rule sees all of a path when it agrees with g to this share.
AGREEMENT = 1e-7
#: The curve is cut into at least so many parts, whose control points all obey the joint limits: so does the curve.
LIMIT_PARTS = 6


@dataclass(frozen=True, kw_only=True)
class Solution:
    """What one solve gave: coefficients (n, size) and IPOPT's word."""

    coefficients: Array
    status: str


class PathProgram:
    """The program for one objective, basis and pattern of fixed end derivatives; see the module's text."""

    def __init__(self, objective: PathObjective, basis: Basis, fixed: tuple[tuple[float, int], ...] = ()) -> None:
        self.objective = objective
        self.kinematics = kinematics = objective.kinematics
        self.basis = basis
        self.n = kinematics.robot.n
        #: coefficients (n, size) move along these directions (size, f), which keep the fixed end derivatives
        self.free = free_directions(fixed, basis)
        self._along = np.linalg.pinv(self.free).T
        line, rows = basis.hull(LIMIT_PARTS)
        moving = np.abs(rows @ self.free).max(axis=1, initial=0.0) > 1e-9
        self._hull = Hull(line=line[moving], rows=rows[moving])
        self._lengths: dict[int, Integral] = {}
        self._solvers: dict[tuple[Integral, int, bool], ca.Function] = {}

    @cached_property
    def _rows(self) -> tuple[ca.Function, ...]:
        return row_functions(self.kinematics)

    @cached_property
    def _energy(self) -> Integral:
        s, weights = self.basis.gauss(max(-(-NODES // (len(self.basis.breaks) - 1)), PIECE_NODES))
        return Integral(density=energy_density(self.objective), s=s, weights=weights, tolerance=1e-7, steps=100)

    @cached_property
    def _length_density(self) -> Density:
        return length_density(self.objective)

    def _length(self, panels: int) -> Integral:
        if panels not in self._lengths:
            line = JointPath(breaks=self.basis.breaks, control=self.basis.line[..., None])
            s, weights = line.quadrature(panels=panels)
            self._lengths[panels] = Integral(density=self._length_density, s=s, weights=weights, tolerance=1e-9, steps=300)
        return self._lengths[panels]

    def solve(
        self,
        start: Array,
        goal: Array,
        guess: Array,
        rows: Sequence[ClearanceRow] = (),
        *,
        reach: float = np.inf,
        limited: bool = True,
    ) -> Solution:
        """Minimise the energy from a guess (n, size), which has the fixed end derivatives.

        Rows that cannot hold come back with their slack. No unknown moves further than `reach` from the guess: in a basis of
        several pieces, by which each moves a joint's slope, in the mean square over s [rad or m]. With `limited` False as if
        there were no joint limits.
        """
        size = self._energy_of(start, goal, guess)
        return self._solve(self._energy, start, goal, guess, rows, size, 1.0, limited=limited, reach=reach)

    def polish(
        self,
        start: Array,
        goal: Array,
        guess: Array,
        rows: Sequence[ClearanceRow] = (),
        *,
        panels: int = POLISH_PANELS[0],
        limited: bool = True,
    ) -> Solution:
        """Minimise g itself from a guess (n, size), with so little of the energy that its minimum is one point.

        Args:
            start, goal, guess, rows, limited: as in `solve`.
            panels: of ten Gauss points each, on which g is integrated.
        """
        size = np.sqrt(self._energy_of(start, goal, guess))
        return self._solve(self._length(panels), start, goal, guess, rows, size, size, limited=limited)

    @interruptible()
    def _solve(
        self,
        integral: Integral,
        start: Array,
        goal: Array,
        guess: Array,
        rows: Sequence[ClearanceRow],
        size: float,
        g0: float,
        *,
        limited: bool,
        reach: float = np.inf,
    ) -> Solution:
        """Minimise an integral in units of `size`, the slacks' cost beside it; `g0` is about the path's g."""
        capacity = 0 if not rows else 32 * 2 ** int(np.ceil(np.log2(max(len(rows) / 32, 1))))
        limits = self.kinematics.robot.limits
        limited = limited and bool(np.isfinite([limits.lower, limits.upper]).any())
        solver = self._solver(integral, capacity, limited)
        unknowns = guess @ self._along
        kept = guess - unknowns @ self.free.T
        numbers = [start, goal, [1 / size, g0], kept.ravel(order="F")]
        parameters = np.concatenate([*numbers, self._row_parameters(rows, capacity).ravel(order="F")])
        count = len(self._hull.line) if limited else 0
        joint_limits = [np.tile(each, count) for each in (limits.lower, limits.upper)]
        result = solver(
            x0=np.concatenate([unknowns.ravel(order="F"), np.zeros(capacity)]),
            p=parameters,
            lbx=np.concatenate([unknowns.ravel(order="F") - reach, np.zeros(capacity)]),
            ubx=np.concatenate([unknowns.ravel(order="F") + reach, np.full(capacity, np.inf)]),
            lbg=np.concatenate([joint_limits[0], np.zeros(capacity)]),
            ubg=np.concatenate([joint_limits[1], np.full(capacity, np.inf)]),
        )
        status = str(solver.stats()["return_status"])
        x = np.asarray(result["x"]).ravel()
        return Solution(
            coefficients=kept + x[: unknowns.size].reshape(unknowns.shape, order="F") @ self.free.T,
            status=status,
        )

    def _energy_of(self, start: Array, goal: Array, guess: Array) -> float:
        """The energy of a guess, by the rule of the program; 1 where it is not a number above zero."""
        s = self._energy.s
        q = start[:, None] + np.outer(goal - start, s) + guess @ self.basis.values(s).T
        v = (goal - start)[:, None] + guess @ self.basis.values(s, 1).T
        density = np.asarray(self._energy.density.value(q, v, np.array([[1.0], [self.objective.power]]))).ravel()
        value = float(density @ self._energy.weights)
        return value if np.isfinite(value) and value > 0 else 1.0

    def _row_parameters(self, rows: Sequence[ClearanceRow], capacity: int) -> Array:
        """The table of rows: values of the functions at the row's place, the place, and the row's column.

        Unused columns hold a row that is always met.
        """
        table = np.zeros((self.basis.size + 1 + column_height(self.n), capacity))
        table[self.basis.size + 1 :] = met_column(self.n)[:, None]
        at = np.array([row.s for row in rows])
        for k, (row, values) in enumerate(zip(rows, self.basis.values(at), strict=True)):
            table[:, k] = [*values, row.s, *row.column(self.n)]
        return table

    def _solver(self, integral: Integral, capacity: int, limited: bool) -> ca.Function:
        """IPOPT with room for `capacity` clearance rows, built when it is first asked for."""
        key = (integral, capacity, limited)
        if key not in self._solvers:
            self._solvers[key] = ipopt_solver(
                integral,
                basis=self.basis,
                free=self.free,
                hull=self._hull if limited else self._hull.none(),
                rows=self._rows if capacity else (),
                capacity=capacity,
                n=self.n,
                power=self.objective.power,
            )
        return self._solvers[key]
