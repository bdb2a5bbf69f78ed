"""Descents among obstacles, repeated until the path is proven free and g is at a minimum."""

import logging
from dataclasses import dataclass, field, replace
from enum import Enum
from functools import cached_property
from typing import NoReturn

import numpy as np

from manipplan.collision.model import CollisionModel
from manipplan.collision.path_clearance import PathClearance, path_clearance
from manipplan.constraints.constraint_set import ConstraintProof, ConstraintSet, prove
from manipplan.cost.integral import PathCost
from manipplan.optimize.certificate import UNKNOWN, Optimality, measure_optimality
from manipplan.optimize.descent import LATE, descend
from manipplan.optimize.program import PathProgram
from manipplan.optimize.result import Step
from manipplan.optimize.rows import MARGIN, ClearanceSearch, ConstraintSearch
from manipplan.paths.basis import EndConditions
from manipplan.paths.joint import JointPath
from manipplan.support.checks import Array
from manipplan.support.deadline import NEVER, Deadline, OutOfTimeError

log = logging.getLogger("manipplan")

#: Maximum number of descents from one path with the final margin. Another one follows when the proof fails, when the
#: quadrature panels do not resolve g on the path reached, or when the first-order conditions do not hold and this one lowered g
#: by more than the share SETTLED: a new trust region may get past a kink of the clearance where the last one became too small.
DESCENTS, SETTLED = 8, 2e-4
#: Final margins after the second, third, ... path that is not proven free, such as along the bumps of a point cloud, except
#: where descents go on until they settle [m]. With the first of them the first-order conditions can still be met.
WIDER = (9e-5, 3e-4, 1e-3, 3e-3)
#: After this number of paths whose g the panels of the descents did not resolve, the panels follow each path: its dip of m is
#: narrow, and moves.
UNRESOLVED = 2
#: Floors of the first two descents from a path whose m falls below the last of them, in units of the objective's floor: with a
#: larger floor the place of a crossing moves more easily.
SOFTER = (100.0, 10.0)
#: Tolerance of descents with a larger floor or margin, as a share of g: the next one starts where they end.
ROUGH = 1e-4
#: A converged descent whose path still misses the required clearance by more than this [m] is stuck in an obstacle.
STUCK = 5e-3
#: With a required clearance below the first value, descents keep these wider margins first [m]: a descent is slow around a
#: corner that it passes at only a tenth of a millimetre. Descents that settle at a kink, where the first-order conditions do
#: not hold, start once more from a path with the last of these margins.
ROUND, WIDE_MARGINS = 5e-3, (2e-3, 3e-4)
#: A confirmed optimum is preferred to a path whose g is lower by less than this share.
CONFIRMED = 1e-3
#: Tolerance on the joint limits of paths that are returned [rad or m].
INSIDE = 1e-7
#: Relative tolerance within which a descent's g, without its share of the energy, agrees with the path's g.
AGREEMENT = 1e-6


@dataclass(frozen=True, kw_only=True)
class Candidate:
    """An optimised path, inside the limits and proven free: coefficients (n, size), cost, first-order conditions, solver."""

    path: JointPath
    coefficients: Array
    cost: PathCost
    optimality: Optimality
    solver: str


class Until(Enum):
    """When the descents from one path end."""

    #: At the first path that is proven free.
    PROVEN = "proven"
    #: When the first-order conditions hold or another descent no longer lowers g; with a wider margin where the proof fails.
    OPTIMAL = "optimal"
    #: The same, with the final margin to the end, after wider ones.
    SETTLED = "settled"

    @property
    def wide_margins(self) -> int:
        """Number of margins wider than the final one that descents keep first."""
        return {Until.PROVEN: 1, Until.OPTIMAL: 0, Until.SETTLED: len(WIDE_MARGINS)}[self]


@dataclass(frozen=True, kw_only=True)
class ProvenDescents:
    """Descents of one program between one start and goal.

    Attributes:
        program: the objective in one basis.
        start, goal: (n,) [rad or m].
        model: the arm among its obstacles; None: nothing is checked for collision.
        clearance: required distance [m].
        history: every solve is appended to it.
        ends: fixed derivatives at start and goal.
        accepted: every candidate is appended to it, so that an interrupt loses none.
        until: when the descents from one path end.
        patient: descents go on where they hardly come out of an obstacle.
        deadline: when descents end.
        constraints: what is kept beside limits and clearance; None: nothing.
    """

    program: PathProgram
    start: Array
    goal: Array
    model: CollisionModel | None
    clearance: float
    history: list[Step]
    ends: EndConditions = field(default_factory=EndConditions)
    accepted: list[Candidate] = field(default_factory=list)
    until: Until = Until.SETTLED
    patient: bool = False
    deadline: Deadline = NEVER
    constraints: ConstraintSet | None = None

    def descend(
        self, name: str, coefficients: Array, *, kept: JointPath | None = None, softens: bool = True, below: float = np.inf
    ) -> Candidate | None:
        """The path at which descents from coefficients (n, size) end; None when it is not free or leaves the limits.

        Descents are repeated until the path is proven free, the quadrature panels resolve its g, and the descent has
        converged, or as `until` says. Each starts with the panels of the one before it, and also watches the place where the
        proof failed. Before the final margin only those are taken that the path `kept` has, if it is given.
        With `softens` a path near a singularity is first moved with larger floors. Elsewhere a floor counts only with the final
        margin, so that it changes the path little. None as well when g is not below `below` with a wider margin than the final
        one. After the deadline, what the last descent reached is accepted if it is proven free, and OutOfTimeError is raised.
        """
        program, integral = self.program, self.program.integral
        clearance_search = None if self.model is None else ClearanceSearch(model=self.model, clearance=self.clearance)
        kept_rows = self.constraint_search()
        path = program.basis.path(self.start, self.goal, coefficients)
        first_cost = integral.cost(path)
        if not np.isfinite(first_cost.g):  # without a floor, a path through a singularity has no finite g
            return None
        best: Candidate | None = None
        edges: Array | None = None
        steps = 0
        failed_g, failures = np.nan, 0  # g of the last path that was not proven free, and number of such paths
        backed_off = False
        unresolved = 0  # number of paths whose g the panels did not resolve
        *wide, final = self.margins(kept)
        moving = self.nearly_singular(first_cost)
        usual = integral.floor if moving else 0.0
        waiting = [*((margin, usual) for margin in wide), *[(final, integral.floor)] * DESCENTS]
        if moving and softens:
            waiting = [*((waiting[0][0], softer * integral.floor) for softer in SOFTER), *waiting]
        if self.deadline.passed:
            self._accept_late(path, coefficients, None)
        while waiting:
            margin, floor = waiting.pop(0)
            if clearance_search is not None:
                clearance_search.margin = margin
            true, z = program.descent_program(
                self.start,
                self.goal,
                coefficients,
                clearance_search,
                edges=edges,
                floor=floor,
                moving=moving,
                constraints=kept_rows,
            )
            refined = edges is None or len(true.length.edges) > len(edges)
            edges = true.length.edges
            if not np.isfinite(true.length.g0):
                break
            preliminary = margin > final or floor > integral.floor
            descent = descend(true, z, tolerance=ROUGH if preliminary else None, patient=self.patient, deadline=self.deadline)
            if self.deadline.passed:
                self._accept_late(true.length.curves.path(descent.z), true.length.curves.coefficients(descent.z), best)
            steps += descent.steps
            coefficients = true.length.curves.coefficients(descent.z)
            if preliminary and clearance_search is not None and descent.violation - margin > STUCK and not descent.exhausted:
                log.debug("descent: stuck in an obstacle before the final margin")
                break
            if preliminary:
                if true.length.without_energy.value(descent.z) * true.length.g0 >= below:
                    return None
                continue
            path = true.length.curves.path(descent.z)
            cost, proof = integral.cost(path), self.proof(path)
            least = np.inf if proof is None else proof.upper
            self.history.append(Step(first=name, g=cost.g, clearance=least, solver=descent.reason))
            if clearance_search is not None and proof is not None and not proof.proven:
                known = (proof.at, proof.pair_id) in clearance_search.always
                stuck = proof.upper < self.clearance - STUCK and not descent.exhausted
                if stuck or (known and cost.g == failed_g):
                    log.debug("descent: stuck in an obstacle at s = %g", proof.at)
                    break
                clearance_search.always += [] if known else [(proof.at, proof.pair_id)]
                failed_g, failures = cost.g, failures + 1
                if self.until is not Until.SETTLED and failures > 1:
                    wider = WIDER[min(failures - 2, len(WIDER) - 1)]
                    final, backed_off = max(min(wider, self.room), final), True
                    waiting = [(final, floor)] * len(waiting)
                continue
            kept_everywhere = self.constraint_proof(path)
            if kept_rows is not None and kept_everywhere is not None and not kept_everywhere.kept:
                if kept_everywhere.failed_at in kept_rows.always:
                    log.debug("descent: a constraint is not kept at s = %g", kept_everywhere.failed_at)
                    break
                kept_rows.always.append(kept_everywhere.failed_at)
                continue
            if not self.inside_limits(path):
                log.debug("descent: the path leaves the joint limits")
                break
            solver = f"{descent.reason} after {steps} steps"
            optimality = measure_optimality(true, descent.z)
            candidate = Candidate(path=path, coefficients=coefficients, cost=cost, optimality=optimality, solver=solver)
            agrees = abs(true.length.without_energy.value(descent.z) * true.length.g0 - cost.g) <= AGREEMENT * cost.g
            candidate = candidate if agrees else replace(candidate, optimality=UNKNOWN)
            unresolved += not agrees
            moving = moving or unresolved >= UNRESOLVED
            settled = optimality.reached or (best is not None and best.cost.g - cost.g <= SETTLED * cost.g)
            # a confirmed optimum may have a slightly larger g
            worth = CONFIRMED if agrees and (optimality.reached or not backed_off) else 0.0
            best = candidate if best is None or cost.g < best.cost.g * (1 + worth) else best
            converged = optimality.reached or not descent.exhausted
            if not np.isfinite(cost.g) or self.until is Until.PROVEN:
                break
            if settled and converged and (agrees or not refined):
                if best.optimality.reached or backed_off or not WIDE_MARGINS[-1] < self.room:
                    break
                backed_off, waiting = True, [(WIDE_MARGINS[-1], floor), *waiting]
        if best is not None:
            self.accepted.append(best)
        return best

    def _accept_late(self, path: JointPath, coefficients: Array, best: Candidate | None) -> NoReturn:
        """Accept the path that is reached at the deadline if it is proven free, and the best one before it."""
        if best is not None:
            self.accepted.append(best)
        if self.inside_limits(path) and self.keeps(path):
            cost = self.program.integral.cost(path)
            self.accepted.append(Candidate(path=path, coefficients=coefficients, cost=cost, optimality=UNKNOWN, solver=LATE))
        raise OutOfTimeError

    def margins(self, kept: JointPath | None) -> list[float]:
        """Margins [m] of the descents from one path, in turn; none is wider than start and goal allow.

        Wide ones come before the final one, with `kept` only those that this path has. One of them is enough for a path that
        only has to be proven, and a path near an optimum needs none.
        """
        wide = [margin for margin in WIDE_MARGINS if margin < self.room] if self.clearance < ROUND else []
        wide = wide[: self.until.wide_margins]
        wide = [margin for margin in wide if kept is None or self.keeps(kept, margin)]
        return [*wide, max(min(MARGIN, self.room), 0.0)]

    @cached_property
    def room(self) -> float:
        """The smaller of the distances of start and goal beyond the required clearance [m]; 0 where nothing is checked."""
        if self.model is None:
            return 0.0
        return self.model.least_distance(np.array([self.start, self.goal]))[0] - self.clearance

    def nearly_singular(self, cost: PathCost) -> bool:
        """Whether m comes near the floor somewhere on a path of known cost."""
        return bool(cost.min_manipulability < SOFTER[-1] * self.program.integral.floor)

    def keeps(self, path: JointPath, margin: float = 0.0) -> bool:
        """Whether a path keeps the constraints, and is proven to keep the required clearance plus a margin [m]."""
        constraints = self.constraint_proof(path)
        if constraints is not None and not constraints.kept:
            return False
        proof = self.proof(path, margin)
        return proof is None or proof.proven

    def constraint_search(self) -> ConstraintSearch | None:
        """A new search for the smallest rows of constraints; None without any."""
        return None if self.constraints is None else ConstraintSearch.of(self.constraints, self.start, self.goal)

    def constraint_proof(self, path: JointPath) -> ConstraintProof | None:
        """What is known about the constraints on a path; None without any."""
        return None if self.constraints is None else prove(self.constraints, path)

    def proof(self, path: JointPath, margin: float = 0.0) -> PathClearance | None:
        """The proof that a path keeps its clearance plus a margin [m]; None where nothing is checked."""
        if self.model is None or not self.model.pair_names:
            return None
        return path_clearance(self.model, path, clearance=self.clearance + margin, tolerance=None)

    def inside_limits(self, path: JointPath, tolerance: float = INSIDE) -> bool:
        """Whether the whole curve keeps the joint limits, as it does where its control points keep them."""
        if (self.program.kinematics.robot.limits.outside(path.control.reshape(-1, path.n)) <= tolerance).all():
            return True
        return all((self.program.kinematics.robot.limits.outside(q) <= tolerance).all() for q in path.bounds())
