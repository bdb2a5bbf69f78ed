"""Local optima between one start and goal: first a path of low energy, then descents on g among the true obstacles.

Descents are repeated until the path is proven free and g is at a minimum.
"""

import logging
from dataclasses import dataclass, field, replace
from enum import Enum
from functools import cached_property
from typing import NamedTuple, NoReturn

import numpy as np

from manipplan.collision.model import CollisionModel, NearPairs
from manipplan.collision.path_clearance import PathClearance, path_clearance
from manipplan.constraints.constraint_set import ConstraintProof, ConstraintSet, prove
from manipplan.cost.crossings import NO_COST, find_crossings, is_beside_singular_end, runs_along
from manipplan.cost.integral import PathCost
from manipplan.optimize import clearance as near
from manipplan.optimize.certificate import SINGLE, UNKNOWN, Optimality, measure_optimality
from manipplan.optimize.clearance import ClearanceRows
from manipplan.optimize.descent import Ending, descend
from manipplan.optimize.program import PathProgram, Solution
from manipplan.optimize.result import Step
from manipplan.optimize.rows import MARGIN, ClearanceSearch, ConstraintSearch
from manipplan.paths.basis import EndConditions
from manipplan.paths.joint import JointPath
from manipplan.support.checks import Array
from manipplan.support.deadline import NEVER, Deadline, OutOfTimeError

log = logging.getLogger("manipplan")

#: Even places of a path.
EVEN = np.linspace(0.0, 1.0, near.DISTANCE_INTERVALS + 1)
#: Maximum number of rounds of solving and renewing clearance rows, per first path.
ROUNDS = 8
#: Rounds end when one lowers g by less than this share.
SMALL_GAIN = 1e-2
#: A solution is nearly free if it misses the required clearance by less than this [m].
NEARLY_FREE = 0.1
#: Two solutions of the energy are the same when no coefficient differs by more than this [rad or m].
SAME_SOLUTION = 1e-3
#: Rounds end at a solution whose g is above the lowest g of an optimum found by this factor.
WORSE = 1.1
#: A nearly free solution starts another descent if its g is below this share of the lowest g of an optimum found.
PROMISING = 0.8
#: Largest displacement of the paths from which descents begin beside an optimum that meets several singularities at once or
#: runs along one [rad or m], and number of directions, each to both sides.
ASIDE, DIRECTIONS = 0.5, 3
#: Maximum deviation of the fit to a path at which the basis counts as containing the path [rad or m].
FIT_TOLERANCE = 1e-9
#: The descent is repeated from the fit to the optimum at an even pace while that lowers g by more than this share.
WORTH = 1e-3
#: Tolerance on the joint limits of rounded solutions of the energy, from which a descent moves back inside [rad or m].
NEARLY_INSIDE = 1e-4
#: Tolerance of the descent to the unconstrained optimum, as a share of g: it is used only for comparison.
COMPARED = 1e-6


class LowEnergy(NamedTuple):
    """A minimum of the energy, g of its path, the clearance that it misses [m], and whether it is inside and proven free."""

    solution: Solution
    g: float
    missing: float
    is_free: bool


#: Maximum number of descents from one path with the final margin. Another one follows when the proof fails, when the
#: quadrature panels do not resolve g on the path reached, or when the first-order conditions do not hold and this one lowered g
#: by more than the share SETTLED: a new trust region may get past a kink of the clearance where the last one became too small.
DESCENTS, SETTLED = 8, 2e-4
#: The tolerance of a descent from a path at which the first-order conditions did not clearly hold, as a share of the usual one:
#: where g bends much, as beside a singularity, a path may miss them although hardly more than the usual one is left to gain.
FURTHER = 0.02
#: Final margins after the first, second, ... path that is not proven free, such as along the bumps of a point cloud, except
#: where descents go on until they settle [m]. With the first four the first-order conditions can still be met, and each such
#: path adds a place that is watched.
WIDER = (7e-5, 9e-5, 9e-5, 9e-5, 3e-4, 1e-3, 3e-3)
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
class LocalSearch:
    """Searches for local optima of one program between one start and goal.

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
        known: the solution of the energy without obstacles is appended to it if it led to an optimum.
        repaces: whether optima are fitted again at an even pace.
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
    known: list[Solution] = field(default_factory=list)
    repaces: bool = True

    def single_path(self) -> list[Candidate]:
        """The only path of this basis, such as the straight line of degree 1; none when it is not free."""
        return self._checked(self._path(self._straight()), self._straight(), SINGLE, "no unknowns")

    def from_straight_line(self) -> list[Candidate]:
        """The local optimum reached from the straight line, through the minimum of the energy without obstacles.

        The descent among the obstacles starts at that minimum although it may collide; none when it ends in an obstacle.
        """
        line = self._straight()
        solution = self._solve(line, self._energy_floor(self._path(line)))
        is_free, *_ = self._check_solution("straight", solution)
        if not (is_free or solution.converged):
            return []
        found = self.optimum_from("straight", solution.coefficients)
        if found:
            self.known.append(solution)
        return found or (self._low_energy_path(solution) if is_free else [])

    def nearest_to(self, first: JointPath) -> list[Candidate]:
        """The local optimum reached from a path or, when the basis does not contain it, from a fit.

        The fit is that at an even pace or, where that is deeper in an obstacle, that at the pace of the path.
        """
        coefficients = self._fit(first)
        off = np.abs(self._path(coefficients)(EVEN) - first(EVEN)).max()
        if off < FIT_TOLERANCE:  # a margin wider than that of the path would first lead away from it, such as from an optimum
            found = self.descend("path", coefficients, start_path=first, softens=False)
            return [] if found is None else [found]
        fits = (self._followed(first)[1], coefficients)
        return self.optimum_from("path", max(fits, key=lambda fit: min(self._least_distance(fit), self.clearance)))

    def _least_distance(self, coefficients: Array) -> float:
        """The smallest distance along the path of coefficients (n, size), at even places [m]; inf where nothing is checked."""
        if self.model is None:
            return np.inf
        return self.model.least_distance(self._path(coefficients)(EVEN))[0]

    def from_optimum(self, found: Candidate) -> list[Candidate]:
        """The local optimum near that of the coarse scene.

        Where no descent gives one, it is the coarse optimum itself, if that is proven free in this scene.
        """
        near_it = self.descend("coarse", found.coefficients)
        if near_it is not None:
            return [near_it]
        kept = self._checked(found.path, found.coefficients, UNKNOWN, "the optimum of a coarse copy of the scene")
        self.accepted.extend(kept)
        return kept

    def embedded(self, path: JointPath) -> list[Candidate]:
        """The local optimum reached from a path of a lower degree."""
        return self.optimum_from("lower degree", self._fit(path))

    def optimum_from(self, name: str, coefficients: Array) -> list[Candidate]:
        """The local optimum of the true problem reached from coefficients (n, size); none when it is not free.

        With `repaces` and no active clearance, the optimum is fitted again at an even pace. The fit differs, so another descent
        from it may reach a lower g. Confirmed optima of arms with more joints than task rows are not: of 81 only three became
        more than 0.1 % lower, for half of the time. Those of other arms often become much lower.
        """
        best = self.descend(name, coefficients)
        is_square = self.program.kinematics.is_square
        while self.repaces and best is not None and best.optimality.active_clearance == 0.0 and np.isfinite(best.cost.g):
            if best.optimality.reached and not is_square:
                break
            again = self.descend("even pace", self._followed(best.path)[1], softens=False)
            if again is None or again.cost.g >= best.cost.g:
                break
            gain = best.cost.g - again.cost.g
            is_worth = gain > WORTH * again.cost.g
            if is_worth or again.optimality.reached or not best.optimality.reached:
                best = again
            if not is_worth:
                break
        if best is not None and self.nearly_singular(best.cost):
            best = self._beside(best)
        return [] if best is None else [best]

    def _beside(self, found: Candidate) -> Candidate:
        """The best of an optimum and those reached from beside it, where it is likely to be a saddle.

        Descents end at saddles, too: where det J has a zero of higher order, g is much larger than with one crossing after the
        other.
        """
        best, rng = found, np.random.default_rng(0)
        shape = self.program.basis.values(EVEN) @ self.program.free[:, :1]
        for _ in range(DIRECTIONS):
            if not self._is_wedged(best):
                break
            aside = rng.normal(size=(self.program.n, 1))
            if self.constraints is not None:
                aside[self.constraints.held] = 0.0
            step = ASIDE / np.abs(shape).max() * aside / np.linalg.norm(aside) @ self.program.free[:, :1].T
            for sign in (1.0, -1.0):
                beside, most = best.coefficients + sign * step, best.cost.g * (1 - WORTH)
                other = self.descend("aside", beside, softens=False, below=most)  # a larger floor would lead back
                if other is not None and other.cost.g < most:
                    best = other
        return best

    def _is_wedged(self, found: Candidate) -> bool:
        """Whether a path runs along singularities, or meets several of them at once between its ends.

        The latter is told by a crossing without a cost, which for powers from 3 on none has. Crossings right beside a singular
        end do not count: no path from there does without them.
        """
        along = runs_along(found.path, self.program.integral, found.cost)
        if along or self.program.integral.power >= NO_COST[2]:
            return along
        kinematics = self.program.kinematics
        inner = [each for each in find_crossings(found.path, self.program.integral, found.cost) if not each.at_end]
        without_cost = [each for each in inner if np.isnan(each.cost) and np.isfinite(each.steepness)]
        return any(not is_beside_singular_end(found.path, kinematics, each.at) for each in without_cost)

    def from_safe_path(self, first: JointPath) -> list[Candidate]:
        """The local optimum near a free path, through a path of low energy that passes each body on the same side.

        The descent starts from the free path of the lowest g or, if there is none, from those that miss the clearance by the
        least. A nearly free path of much lower g than all optima found starts a descent of its own.
        """
        near_first = self._low_energies(first)
        free = [each for each in near_first if each.is_free]
        nearly_free = [each for each in near_first if not each.is_free and each.missing < NEARLY_FREE and np.isfinite(each.g)]
        nearly_free.sort(key=lambda each: (each.missing, each.g))
        found: list[Candidate] = []
        if free:
            best = min(free, key=lambda each: each.g).solution
            try:
                found = self.optimum_from("seed", best.coefficients) or self._low_energy_path(best)
            except OutOfTimeError:
                self._low_energy_path(best)
                raise
        else:
            for each in nearly_free[: 1 if self.accepted else 2]:
                nearly_free.remove(each)
                found = self.optimum_from("seed", each.solution.coefficients)
                if found:
                    break
        if found:
            most = PROMISING * min(each.cost.g for each in self.accepted)
            lower = [each for each in nearly_free if each.g < most]
            if lower:
                found += self.optimum_from("nearly free", lower[0].solution.coefficients)
        return found

    def _low_energies(self, first: JointPath) -> list[LowEnergy]:
        """Minima of the energy near a free path, with clearance rows that keep them on the same side of each body.

        The rows are computed again at each minimum, until one is free and the next one lowers g only slightly. Rounds end
        early at a minimum from which an optimum was found before, or whose g is much higher than that of an optimum found.
        """
        s, initial = self._followed(first)
        coefficients = initial
        places: tuple[near.Place, ...] = ()
        if self.model is not None:
            limit = self.clearance + near.NEAR
            places = tuple(near.dips(near.distance_profile(self.model, first(s), limit), limit))
        floor = self._energy_floor(first)
        found: list[LowEnergy] = []
        free: list[float] = []  # g of those that are free
        for _ in range(ROUNDS):
            rows: ClearanceRows | None = None
            if self.model is not None:
                path = self._path(coefficients)
                watched = near.nearest(self.model, path, places, most=np.inf if free else self.clearance + near.FAR)
                rows = near.rows_for(self.model, path, lambda at: first(np.interp(at, EVEN, s)), watched, self.clearance)
            solution = self._solve(coefficients, floor, rows)
            if not solution.converged and np.array_equal(coefficients, initial):
                break
            if not solution.converged:  # where it stopped depends on rounding errors: restart with the same places
                coefficients = initial
                continue
            coefficients = solution.coefficients
            if any(np.abs(coefficients - each.coefficients).max() < SAME_SOLUTION for each in self.known):
                break
            is_free, profile, failed_at = self._check_solution("seed", solution)
            step = self.history[-1]
            if self.accepted and step.g > WORSE * min(each.cost.g for each in self.accepted):
                break
            missing = max(self.clearance - step.clearance, 0.0)
            found.append(LowEnergy(solution=solution, g=step.g, missing=missing, is_free=is_free))
            free = [each.g for each in found if each.is_free]
            if is_free and (not places or (len(free) > 1 and free[-2] - free[-1] < SMALL_GAIN * free[-1])):
                break
            places = near.more_places(places, profile, failed_at, self.clearance, is_free=is_free)
        return found

    def _low_energy_path(self, solution: Solution) -> list[Candidate]:
        """The free path of low energy itself, when no descent from it gave a free path; none when it leaves the limits."""
        path, coefficients = self._path(solution.coefficients), solution.coefficients
        if not self.inside_limits(path):
            return []
        solver = f"no descent on g gave a collision-free path; this one has a low energy ({solution.status})"
        cost = self.program.integral.cost(path)
        found = Candidate(path=path, coefficients=coefficients, cost=cost, optimality=UNKNOWN, solver=solver)
        self.accepted.append(found)
        return [found]

    def unconstrained_g(self, path: JointPath) -> float:
        """g of the local optimum near a path, without limits and obstacles."""
        same_breaks = np.isin(path.breaks, self.program.basis.breaks).all()  # then the fit at even places is the path itself
        coefficients = self._fit(path) if same_breaks else self._followed(path)[1]
        if not self.program.free.size:
            return self.program.integral.cost(self._path(coefficients)).g
        moving = self.nearly_singular(self.program.integral.cost(path))
        true, z = self.program.descent_program(self.start, self.goal, coefficients, None, limited=False, moving=moving)
        nearby = true.length.curves.path(descend(true, z, tolerance=COMPARED).z)
        return min(self.program.integral.cost(each).g for each in (path, nearby))

    def _check_solution(self, name: str, solution: Solution) -> tuple[bool, NearPairs, tuple[near.Place, ...]]:
        """Whether a solution of the energy is inside the limits and proven free, and its distance profile.

        The third value is the place where the proof failed although the path is free at all places of the profile. The
        solution is appended to `history`.
        """
        path = self._path(solution.coefficients)
        profile, least = NearPairs.of((near.DISTANCE_INTERVALS + 1, 0), np.empty(0, dtype=np.intp), np.empty(0)), np.inf
        if self.model is not None and self.model.pair_names:
            q = path(EVEN)
            profile = near.distance_profile(self.model, q, self.clearance + near.NEAR)
            least = float(profile.distances.min()) if len(profile.distances) else self.model.least_distance(q)[0]
        failed_at: tuple[near.Place, ...] = ()
        g = self.program.integral.cost(path).g
        self.history.append(Step(first=name, g=g, clearance=least, solver=solution.status))
        constraints = self.constraint_proof(path)
        keeps = constraints is None or constraints.kept
        if keeps and least > self.clearance and self.inside_limits(path, NEARLY_INSIDE):
            proof = self.proof(path)
            if proof is None or proof.proven:
                return True, profile, ()
            failed_at = ((proof.at, proof.pair_id),)
        return False, profile, failed_at

    def _energy_floor(self, path: JointPath) -> float:
        """Floor of the energy near a path: a large one where the path nearly meets a singularity, otherwise none."""
        return SOFTER[0] * self.program.integral.floor if self.nearly_singular(self.program.integral.cost(path)) else 0.0

    def _straight(self) -> Array:
        """Coefficients (n, size) of the path nearest to the straight line that meets the end conditions."""
        return self.ends.met(self.program.basis, np.zeros((self.program.n, self.program.basis.size)), self.start, self.goal)

    def _followed(self, path: JointPath) -> tuple[Array, Array]:
        """Places s (m,) at equal shares of a path's g, and the coefficients (n, size) of the fit to it there."""
        s = self.program.integral.constant_speed(path, len(EVEN))
        return s, self._fit(path, s)

    def _fit(self, path: JointPath, s: Array = EVEN) -> Array:
        """The coefficients (n, size) of the fit to a path at s (m,) that meets the end conditions."""
        return self.ends.met(self.program.basis, self.program.basis.fit(path, s), self.start, self.goal)

    def _path(self, coefficients: Array) -> JointPath:
        return self.program.basis.path(self.start, self.goal, coefficients)

    def _solve(self, guess: Array, floor: float, rows: ClearanceRows | None = None) -> Solution:
        """The minimum of the energy reached from a guess (n, size)."""
        return self.program.solve(self.start, self.goal, guess, floor, rows, self.deadline, self.constraint_search())

    def descend(
        self,
        name: str,
        coefficients: Array,
        *,
        start_path: JointPath | None = None,
        softens: bool = True,
        below: float = np.inf,
    ) -> Candidate | None:
        """The path at which descents from coefficients (n, size) end; None when it is not free or leaves the limits.

        Descents are repeated until the path is proven free, the quadrature panels resolve its g, and the descent has
        converged, or as `until` says. Each starts with the panels of the one before it, and also watches the place where the
        proof failed. Before the final margin only those are taken that `start_path` has, if it is given.
        With `softens` a path near a singularity is first moved with larger floors. Elsewhere a floor counts only with the final
        margin, so that it changes the path little. None as well when g is not below `below` with a wider margin than the final
        one. After the deadline, what the last descent reached is accepted if it is proven free, and OutOfTimeError is raised.
        """
        program, integral = self.program, self.program.integral
        clearance_search = None
        if self.model is not None:
            clearance_search = ClearanceSearch(model=self.model, functions=program.row_functions, clearance=self.clearance)
        kept_rows = self.constraint_search()
        path = self._path(coefficients)
        first_cost = integral.cost(path)
        if not np.isfinite(first_cost.g):  # without a floor, a path through a singularity has no finite g
            return None
        best: Candidate | None = None
        edges: Array | None = None
        steps = 0
        failed_g, failures = np.nan, 0  # g of the last path that was not proven free, and number of such paths
        backed_off = False
        unresolved = 0  # number of paths whose g the panels did not resolve
        *wide, final = self.margins(start_path)
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
            if start_path is not None and not wide and best is None and not preliminary:
                optimality, solver = measure_optimality(true, z), "the first-order conditions hold where the descent began"
                known_optimum = self._checked(start_path, coefficients, optimality, solver) if optimality.reached else []
                best = known_optimum[0] if known_optimum else None
            descent = descend(
                true,
                z,
                tolerance=ROUGH if preliminary else None,
                accuracy=1.0 if best is None else FURTHER,
                patient=self.patient,
                deadline=self.deadline,
            )
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
            self.history.append(Step(first=name, g=cost.g, clearance=least, solver=descent.ending.value))
            if clearance_search is not None and proof is not None and not proof.proven:
                known = (proof.at, proof.pair_id) in clearance_search.always
                stuck = proof.upper < self.clearance - STUCK and not descent.exhausted
                if stuck or (known and cost.g == failed_g):
                    log.debug("descent: stuck in an obstacle at s = %g", proof.at)
                    break
                clearance_search.always += [] if known else [(proof.at, proof.pair_id)]
                failed_g, failures = cost.g, failures + 1
                if self.until is not Until.SETTLED:
                    wider = WIDER[min(failures, len(WIDER)) - 1]
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
            solver = f"{descent.ending.value} after {steps} steps"
            optimality = measure_optimality(true, descent.z)
            candidate = Candidate(path=path, coefficients=coefficients, cost=cost, optimality=optimality, solver=solver)
            agrees = abs(true.length.without_energy.value(descent.z) * true.length.g0 - cost.g) <= AGREEMENT * cost.g
            candidate = candidate if agrees else replace(candidate, optimality=UNKNOWN)
            unresolved += not agrees
            moving = moving or unresolved >= UNRESOLVED
            clear = optimality.is_clear if self.until is Until.SETTLED else optimality.reached
            settled = clear or (best is not None and best.cost.g - cost.g <= SETTLED * cost.g)
            # a confirmed optimum may have a slightly larger g
            worth = CONFIRMED if agrees and (optimality.reached or not backed_off) else 0.0
            if best is not None and best.optimality.reached:
                worth = 0.0 if candidate.optimality.reached else -CONFIRMED
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

    def _checked(self, path: JointPath, coefficients: Array, optimality: Optimality, solver: str) -> list[Candidate]:
        """A path as a candidate; none where it is not inside the limits and proven free."""
        if not (self.inside_limits(path) and self.keeps(path)):
            return []
        cost = self.program.integral.cost(path)
        return [Candidate(path=path, coefficients=coefficients, cost=cost, optimality=optimality, solver=solver)]

    def _accept_late(self, path: JointPath, coefficients: Array, best: Candidate | None) -> NoReturn:
        """Accept the path that is reached at the deadline if it is proven free, and the best one before it."""
        if best is not None:
            self.accepted.append(best)
        self.accepted.extend(self._checked(path, coefficients, UNKNOWN, Ending.LATE.value))
        raise OutOfTimeError

    def margins(self, start_path: JointPath | None) -> list[float]:
        """Margins [m] of the descents from one path, in turn; none is wider than start and goal allow.

        Wide ones come before the final one, with `start_path` only those that it has. One of them is enough for a path that
        only has to be proven, and a path near an optimum needs none.
        """
        wide = [margin for margin in WIDE_MARGINS if margin < self.room] if self.clearance < ROUND else []
        wide = wide[: self.until.wide_margins]
        wide = [margin for margin in wide if start_path is None or self.keeps(start_path, margin)]
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
