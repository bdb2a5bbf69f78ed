"""The program of a path in one basis: minima of the energy, and the program of g for the descent among the true obstacles."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from manipplan.cost.integral import PathIntegral, gauss
from manipplan.cost.objective import energy_density, length_density
from manipplan.optimize.clearance import ClearanceRows, row_functions
from manipplan.optimize.descent import DescentProgram, descend
from manipplan.optimize.rows import ClearanceSearch, ConstraintSearch, FixedRows, LimitRows
from manipplan.optimize.steps import Curves, Derivatives, LengthModel
from manipplan.paths.basis import Basis, free_directions
from manipplan.paths.rounding import FINE, FIXED, on_grid
from manipplan.support.checks import Array
from manipplan.support.deadline import NEVER, Deadline, building
from manipplan.support.progress import interruptible

#: Number of Gauss points of the energy on the whole path, and minimum number on each piece.
NODES, PIECE_NODES = 40, 8
#: Minimum number of parts the curve is cut into, for the energy and for g. Their control points obey the joint limits, and so
#: does the whole curve. With more parts the curve can come nearer to the limits.
LIMIT_PARTS, FINE_PARTS = 6, 32
#: Descents on g narrow the limits by this, but not beyond start and goal [rad or m]: steps are rounded, and a path would end
#: outside by as much.
INSET = 2.5e-7
#: First unknowns of a solve or a descent are rounded to multiples of this [rad or m]. It is not a power of two, because then
#: results of rounded steps would often lie halfway between two multiples.
SPACING = 1.5e-8
#: Solutions of the energy are rounded to multiples of this [rad or m]: far above the accuracy of a solve, so that processors
#: hardly ever round to different multiples.
SOLVED_SPACING = 2.0**-16
#: Descents on the energy: tolerance as a share of it, maximum number of steps with clearance rows, which are renewed after each
#: solve, and without, first radius of the trust region [rad or m], and smallest penalty parameter, in units of the first energy
#: per metre.
ENERGY_TOLERANCE, ENERGY_STEPS, FREE_ENERGY_STEPS, ENERGY_RADIUS, ENERGY_PENALTY = 1e-6, 60, 100, 0.4, 20.0


@dataclass(frozen=True, kw_only=True)
class Solution:
    """Result of one solve of the energy: coefficients (n, size), how it ended, and whether it did before the last step."""

    coefficients: Array
    status: str
    converged: bool


class PathProgram:
    """The program for one objective, basis and pattern of fixed end derivatives; see the docstring of the module."""

    def __init__(self, integral: PathIntegral, basis: Basis, fixed: tuple[tuple[float, int], ...] = ()) -> None:
        self.integral = integral
        self.kinematics = kinematics = integral.kinematics
        self.basis = basis
        self.n = kinematics.robot.n
        #: coefficients (n, size) move along these directions (size, f), which keep the fixed end derivatives
        self.free = free_directions(fixed, basis)
        self._hull, self._fine_hull = self._moving_hull(LIMIT_PARTS), self._moving_hull(FINE_PARTS)

    def _moving_hull(self, parts: int) -> tuple[Array, Array]:
        """As `Basis.hull`, of the control points that can move when the curve is cut into this number of parts."""
        line, rows = self.basis.hull(parts)
        moving = np.abs(rows @ self.free).max(axis=1, initial=0.0) > 1e-9
        return line[moving], rows[moving]

    @cached_property
    @building()
    def row_functions(self) -> Derivatives:
        """The functions of clearance rows."""
        return Derivatives.of(row_functions(self.kinematics))

    @cached_property
    @building()
    def _energy_density(self) -> Derivatives:
        return Derivatives.of(energy_density(self.integral))

    @cached_property
    @building()
    def _length_density(self) -> Derivatives:
        return Derivatives.of(length_density(self.integral))

    @cached_property
    def _energy_rule(self) -> tuple[Array, Array]:
        """Quadrature points and weights of the energy, (m,) each."""
        return self.basis.gauss(max(-(-NODES // (len(self.basis.breaks) - 1)), PIECE_NODES))

    @property
    def _fixes_derivatives(self) -> bool:
        """Whether end derivatives are fixed: they would not survive rounding."""
        return len(self.free.T) < self.basis.size

    def _rounded(self, coefficients: Array) -> Array:
        """Coefficients (n, size) that no unknown changes, rounded to the fine grid unless they fix derivatives."""
        return coefficients if self._fixes_derivatives else on_grid(coefficients, FINE)

    @cached_property
    def _directions(self) -> Array:
        """Combinations of the free directions (size, f) whose slopes are orthonormal."""
        s, weights = self.basis.gauss(self.basis.degree)
        slopes = np.sqrt(weights)[:, None] * (self.basis.values(s, 1) @ self.free)
        directions = np.asarray(self.free @ np.linalg.inv(np.linalg.qr(slopes).R))
        return directions if self._fixes_derivatives else on_grid(directions, FIXED)

    def descent_program(
        self,
        start: Array,
        goal: Array,
        coefficients: Array,
        clearance: ClearanceSearch | None,
        *,
        limited: bool = True,
        edges: Array | None = None,
        floor: float | None = None,
        moving: bool = False,
        constraints: ConstraintSearch | None = None,
    ) -> tuple[DescentProgram, Array]:
        """The program of g among the true obstacles, and the unknowns z (f, n) that give the path of coefficients (n, size).

        The descent begins at that path. g, with the floor of the objective unless another is given, is integrated on quadrature
        panels that are narrow where the path needs it: `edges` (k + 1,), which earlier paths needed, are refined. With `moving`
        the panels follow each path instead. Joint limits do not hold unless `limited`.
        """
        integral = self.integral if floor is None else replace(self.integral, floor=floor)
        curves, z = self._curves(start, goal, coefficients)
        path = self.basis.path(start, goal, coefficients)
        edges = integral.fine_panels(path) if moving else integral.panel_edges(path, edges)
        s, weights = gauss(edges[:-1], edges[1:])
        g0 = integral.on_panels(path, edges)
        length = LengthModel(
            density=self._length_density,
            curves=curves,
            edges=edges,
            s=s.ravel(),
            weights=weights.ravel(),
            g0=g0,
            power=integral.power,
            floor=integral.floor,
            pace=g0,
            integral=integral if moving else None,
        )
        limits = self._limit_rows(self._fine_hull, curves, inset=INSET if limited else -np.inf)
        return DescentProgram(length=length, limits=limits, clearance=clearance, **_kept(constraints)), z

    def _curves(self, start: Array, goal: Array, coefficients: Array) -> tuple[Curves, Array]:
        """The curves with the free directions, and the unknowns z (f, n) of coefficients (n, size)."""
        directions = self._directions
        z: Array = np.asarray(np.linalg.lstsq(directions, coefficients.T, rcond=None)[0], dtype=float)
        base = self._rounded(coefficients - (directions @ z).T)
        return Curves(basis=self.basis, directions=directions, base=base, start=start, goal=goal), on_grid(z, SPACING)

    def _limit_rows(self, hull: tuple[Array, Array], curves: Curves, *, inset: float = 0.0) -> LimitRows:
        """The joint limits of the points of a hull, narrowed by `inset` [rad or m] up to start and goal; -inf: none."""
        (line, rows), limits = hull, self.kinematics.robot.limits
        ends = np.array([curves.start, curves.goal])
        return LimitRows(
            line=curves.start + np.outer(line, curves.goal - curves.start) + rows @ curves.base.T,
            directions=rows @ curves.directions,
            lower=np.minimum(limits.lower + inset, ends.min(axis=0)),
            upper=np.maximum(limits.upper - inset, ends.max(axis=0)),
        )

    @interruptible()
    def solve(
        self,
        start: Array,
        goal: Array,
        guess: Array,
        floor: float,
        rows: ClearanceRows | None = None,
        deadline: Deadline = NEVER,
        constraints: ConstraintSearch | None = None,
    ) -> Solution:
        """Minimise the energy with a floor from a guess (n, size), which has the fixed end derivatives.

        Rows and constraints may be violated, so there is a solution even when they contradict each other. Raises
        OutOfTimeError after the deadline.
        """
        curves, z = self._curves(start, goal, guess)
        s, weights = self._energy_rule
        program = DescentProgram(
            length=LengthModel(
                density=self._energy_density,
                curves=curves,
                edges=np.array([0.0, 1.0]),
                s=s,
                weights=weights,
                g0=self._energy(start, goal, guess, floor),
                power=self.integral.power,
                floor=floor,
                pace=1.0,
            ),
            limits=self._limit_rows(self._hull, curves),
            clearance=None if rows is None else FixedRows.of(self.row_functions, curves, rows),
            **_kept(constraints),
        )
        descent = descend(
            program,
            z,
            tolerance=ENERGY_TOLERANCE,
            steps=ENERGY_STEPS if rows is not None or constraints is not None else FREE_ENERGY_STEPS,
            first_radius=ENERGY_RADIUS,
            least_penalty=ENERGY_PENALTY,
            deadline=deadline,
        )
        deadline.check()
        found = curves.coefficients(on_grid(descent.z, SOLVED_SPACING))
        return Solution(coefficients=found, status=f"energy: {descent.ending.value}", converged=not descent.exhausted)

    def _energy(self, start: Array, goal: Array, guess: Array, floor: float) -> float:
        """The energy of a guess (n, size), by the quadrature of the program; 1 when it is not finite and positive."""
        s, weights = self._energy_rule
        q = start[:, None] + np.outer(goal - start, s) + guess @ self.basis.values(s).T
        v = (goal - start)[:, None] + guess @ self.basis.values(s, 1).T
        numbers = np.array([1.0, self.integral.power, floor])
        value = float(self._energy_density.value.by_columns(q.T, v.T, numbers)[:, 0] @ weights)
        return value if np.isfinite(value) and value > 0 else 1.0


def _kept(constraints: ConstraintSearch | None) -> dict[str, Any]:
    """Attributes of a DescentProgram that keeps constraints."""
    if constraints is None:
        return {}
    return {"constraints": constraints if constraints.constraints.count else None, "held": constraints.constraints.held}
