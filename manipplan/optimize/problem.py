"""The path program in one basis: solves of the energy, which find a first path, and the true program of g for the descent.

Everything that changes from one solve of the energy to the next (ends, guess, rows) is a parameter of the program in `nlp`, so
it is built once for an objective and a basis.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import casadi as ca
import numpy as np

from manipplan.checks import Array
from manipplan.interrupts import interruptible
from manipplan.optimize.basis import Basis
from manipplan.optimize.batch import BatchFunction
from manipplan.optimize.constraints import LimitRows, RowFunctions
from manipplan.optimize.density import energy_density, length_density
from manipplan.optimize.descent import TrueProgram
from manipplan.optimize.ends import free_directions
from manipplan.optimize.length_model import BatchDensity, Curves, LengthModel
from manipplan.optimize.nlp import Hull, Integral, ipopt_solver
from manipplan.optimize.objective import PathObjective, gauss
from manipplan.optimize.rounding import FINE, FIXED, on_grid, with_bits
from manipplan.optimize.rows import ClearanceRow, column_height, met_column, row_functions
from manipplan.optimize.surroundings import Surroundings

#: Gauss points of the energy on the whole path, and at least on each piece.
NODES, PIECE_NODES = 40, 8
#: Minimum number of parts the curve is cut into, for the energy and for g. Their control points obey the joint limits, and so
#: does the whole curve. With more parts the curve can come nearer to the limits.
LIMIT_PARTS, FINE_PARTS = 6, 32
#: Unknowns where a solve or a descent begins are rounded to multiples of this [rad or m]. It is no power of two: results of
#: rounded steps would often lie halfway between two of these.
SPACING = 1.5e-8
#: Solutions of the energy are rounded to multiples of this [rad or m]: far above IPOPT's own accuracy, so that processors
#: hardly ever round to different ones.
SOLVED_SPACING = 2.0**-16
#: Bits of the factor by which IPOPT's objective is scaled.
SCALE_BITS = 24


@dataclass(frozen=True, kw_only=True)
class Solution:
    """Result of one solve of the energy: coefficients (n, size) and IPOPT's return status."""

    coefficients: Array
    status: str

    @property
    def converged(self) -> bool:
        """Whether IPOPT converged."""
        return self.status in ("Solve_Succeeded", "Solved_To_Acceptable_Level")


class PathProgram:
    """The program for one objective, basis and pattern of fixed end derivatives; see the docstring of the module."""

    def __init__(self, objective: PathObjective, basis: Basis, fixed: tuple[tuple[float, int], ...] = ()) -> None:
        self.objective = objective
        self.kinematics = kinematics = objective.kinematics
        self.basis = basis
        self.n = kinematics.robot.n
        #: coefficients (n, size) move along these directions (size, f), which keep the fixed end derivatives
        self.free = free_directions(fixed, basis)
        self._along = np.linalg.pinv(self.free).T
        self._hull, self._fine_hull = self._moving_hull(LIMIT_PARTS), self._moving_hull(FINE_PARTS)
        self._solvers: dict[tuple[int, bool], ca.Function] = {}

    def _moving_hull(self, parts: int) -> Hull:
        """The control points that can move when the curve is cut into this number of parts."""
        line, rows = self.basis.hull(parts)
        moving = np.abs(rows @ self.free).max(axis=1, initial=0.0) > 1e-9
        return Hull(line=line[moving], rows=rows[moving])

    @cached_property
    def _rows(self) -> tuple[ca.Function, ...]:
        return row_functions(self.kinematics)

    @cached_property
    def _energy(self) -> Integral:
        s, weights = self.basis.gauss(max(-(-NODES // (len(self.basis.breaks) - 1)), PIECE_NODES))
        return Integral(density=energy_density(self.objective), s=s, weights=weights, tolerance=1e-7, steps=100)

    @cached_property
    def _length_density(self) -> BatchDensity:
        return BatchDensity.of(length_density(self.objective))

    @cached_property
    def _batch_rows(self) -> RowFunctions:
        value, gradient, _ = self._rows
        return RowFunctions(value=BatchFunction(value), gradient=BatchFunction(gradient))

    @property
    def _fixes_derivatives(self) -> bool:
        """Whether end derivatives are fixed: they would not survive rounding."""
        return len(self.free.T) < self.basis.size

    def _rounded(self, kept: Array) -> Array:
        """Coefficients (n, size) that no unknown changes, on the fine grid unless they fix derivatives."""
        return kept if self._fixes_derivatives else on_grid(kept, FINE)

    @cached_property
    def _directions(self) -> Array:
        """Combinations of the free directions (size, f) whose slopes are orthonormal."""
        s, weights = self.basis.gauss(self.basis.degree)
        slopes = np.sqrt(weights)[:, None] * (self.basis.values(s, 1) @ self.free)
        directions = np.asarray(self.free @ np.linalg.inv(np.linalg.qr(slopes).R))
        return directions if self._fixes_derivatives else on_grid(directions, FIXED)

    def true_program(
        self,
        start: Array,
        goal: Array,
        coefficients: Array,
        surroundings: Surroundings | None,
        *,
        limited: bool = True,
        edges: Array | None = None,
    ) -> tuple[TrueProgram, Array]:
        """The program of g among the true obstacles, and the unknowns z (f, n) that give the path of coefficients (n, size).

        Args:
            start, goal: (n,) [rad or m].
            coefficients: (n, size) of the path where the descent begins. g is integrated on quadrature panels that are narrow
                where this path needs it.
            surroundings: distances of the true bodies; None: nothing is checked for collision.
            limited: False: as if there were no joint limits.
            edges: (k + 1,) of panels that earlier paths needed; they are kept and refined.
        """
        directions = self._directions
        z: Array = np.asarray(np.linalg.lstsq(directions, coefficients.T, rcond=None)[0], dtype=float)
        kept = self._rounded(coefficients - (directions @ z).T)
        z = on_grid(z, SPACING)
        curves = Curves(basis=self.basis, directions=directions, kept=kept, start=start, goal=goal)
        path = self.basis.path(start, goal, coefficients)
        edges = self.objective.panels(path, edges)
        s, weights = gauss(edges)
        g0 = self.objective.on_panels(path, edges)
        length = LengthModel(
            density=self._length_density,
            curves=curves,
            edges=edges,
            s=s.ravel(),
            weights=weights.ravel(),
            g0=g0,
            power=self.objective.power,
            pace=g0,
        )
        limits = self.kinematics.robot.limits
        unlimited = np.full(self.n, np.inf)
        line = start + np.outer(self._fine_hull.line, goal - start) + self._fine_hull.rows @ kept.T
        limit_rows = LimitRows(
            line=line,
            directions=self._fine_hull.rows @ directions,
            lower=limits.lower if limited else -unlimited,
            upper=limits.upper if limited else unlimited,
        )
        return TrueProgram(length=length, limits=limit_rows, functions=self._batch_rows, surroundings=surroundings), z

    @interruptible()
    def solve(self, start: Array, goal: Array, guess: Array, rows: Sequence[ClearanceRow] = ()) -> Solution:
        """Minimise the energy from a guess (n, size), which has the fixed end derivatives.

        Rows have slacks, so that there is a solution even where they contradict each other.
        """
        capacity = 0 if not rows else 32 * 2 ** int(np.ceil(np.log2(max(len(rows) / 32, 1))))
        limits = self.kinematics.robot.limits
        limited = bool(np.isfinite([limits.lower, limits.upper]).any())
        solver = self._solver(capacity, limited)
        # all that IPOPT gets is rounded: from inputs that differ in their last bits its iterations go apart
        unknowns = on_grid(guess @ self._along, SPACING)
        kept = self._rounded(guess - unknowns @ self.free.T)
        scale = with_bits(np.array([1 / self._energy_of(start, goal, guess)]), SCALE_BITS)
        table = on_grid(self._row_parameters(rows, capacity), FINE)
        parameters = np.concatenate([start, goal, scale, [1.0], kept.ravel(order="F"), table.ravel(order="F")])
        count = len(self._hull.line) if limited else 0
        joint_limits = [np.tile(each, count) for each in (limits.lower, limits.upper)]
        result = solver(
            x0=np.concatenate([unknowns.ravel(order="F"), np.zeros(capacity)]),
            p=parameters,
            lbx=np.concatenate([np.full(unknowns.size, -np.inf), np.zeros(capacity)]),
            lbg=np.concatenate([joint_limits[0], np.zeros(capacity)]),
            ubg=np.concatenate([joint_limits[1], np.full(capacity, np.inf)]),
        )
        status = str(solver.stats()["return_status"])
        x = on_grid(np.asarray(result["x"]).ravel()[: unknowns.size], SOLVED_SPACING)
        return Solution(coefficients=kept + x.reshape(unknowns.shape, order="F") @ self.free.T, status=status)

    def _energy_of(self, start: Array, goal: Array, guess: Array) -> float:
        """The energy of a guess (n, size), by the quadrature of the program; 1 where it is not a number above zero."""
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

    def _solver(self, capacity: int, limited: bool) -> ca.Function:
        """IPOPT with room for `capacity` clearance rows, built on first use."""
        key = (capacity, limited)
        if key not in self._solvers:
            self._solvers[key] = ipopt_solver(
                self._energy,
                basis=self.basis,
                free=self.free,
                hull=self._hull if limited else self._hull.none(),
                rows=self._rows if capacity else (),
                capacity=capacity,
                n=self.n,
                power=self.objective.power,
            )
        return self._solvers[key]
