"""Local optima between one start and goal: first a path of low energy, then a descent on g among the true obstacles."""

import logging
from dataclasses import dataclass, field, replace

import numpy as np

from manipplan.collision.model import NearPairs
from manipplan.cost.crossings import NO_COST, find_crossings, is_beside_singular_end, runs_along
from manipplan.optimize import clearance as near
from manipplan.optimize.certificate import SINGLE, UNKNOWN
from manipplan.optimize.clearance import ClearanceRow
from manipplan.optimize.descent import descend
from manipplan.optimize.program import Solution
from manipplan.optimize.proven import SOFTER, Candidate, ProvenDescents
from manipplan.optimize.result import Step
from manipplan.paths.joint import JointPath
from manipplan.support.checks import Array
from manipplan.support.deadline import OutOfTimeError

log = logging.getLogger("manipplan")

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
ROUGH = 1e-6


@dataclass(frozen=True, kw_only=True, eq=False)
class LowEnergy:
    """A minimum of the energy among clearance rows.

    Attributes:
        solution: what the solver found.
        g: g of its path.
        missing: required clearance that its path misses [m].
        is_free: its path is inside the joint limits and proven free.
    """

    solution: Solution
    g: float
    missing: float
    is_free: bool


@dataclass(frozen=True, kw_only=True)
class LocalSearch(ProvenDescents):
    """Searches for local optima of one program between one start and goal.

    Attributes:
        known: the solution of the energy without obstacles is appended to it if it led to an optimum.
        repaces: whether optima are fitted again at an even pace.
    """

    known: list[Solution] = field(default_factory=list)
    repaces: bool = True

    def single_path(self) -> list[Candidate]:
        """The only path of this basis, such as the straight line of degree 1; none when it is not free."""
        path = self.program.basis.path(self.start, self.goal, self._straight())
        if not (self.inside_limits(path) and self.keeps(path)):
            return []
        cost = self.program.integral.cost(path)
        return [Candidate(path=path, coefficients=self._straight(), cost=cost, optimality=SINGLE, solver="no unknowns")]

    def from_straight_line(self) -> list[Candidate]:
        """The local optimum reached from the straight line, through the minimum of the energy without obstacles.

        The descent among the obstacles starts at that minimum although it may collide; none when it ends in an obstacle.
        """
        line = self._straight()
        floor = self._energy_floor(self.program.basis.path(self.start, self.goal, line))
        solution = self.program.solve(
            self.start, self.goal, line, floor, deadline=self.deadline, constraints=self.constraint_search()
        )
        is_free, *_ = self._check_solution("straight", solution)
        if not (is_free or solution.converged):
            return []
        found = self.optimum_from("straight", solution.coefficients)
        if found:
            self.known.append(solution)
        return found or (self._low_energy_path(solution) if is_free else [])

    def nearest_to(self, first: JointPath) -> list[Candidate]:
        """The local optimum reached from a path, or from its fit at an even pace when the basis does not contain it."""
        basis, even = self.program.basis, np.linspace(0.0, 1.0, near.DISTANCE_INTERVALS + 1)
        coefficients = self.ends.met(basis, basis.fit(first, even), self.start, self.goal)
        off = np.abs(basis.path(self.start, self.goal, coefficients)(even) - first(even)).max()
        same = (
            off < FIT_TOLERANCE
        )  # then a margin wider than the path's own would first lead away from it, such as from an optimum
        found = self.descend(
            "path", coefficients if same else self._followed(first)[1], kept=first if same else None, softens=not same
        )
        return [] if found is None else [found]

    def from_optimum(self, found: Candidate) -> list[Candidate]:
        """The local optimum near that of the coarse scene.

        Where no descent gives one, it is the coarse optimum itself, if that is proven free in this scene.
        """
        near_it = self.descend("coarse", found.coefficients)
        if near_it is not None:
            return [near_it]
        if not (self.keeps(found.path) and self.inside_limits(found.path)):
            return []
        self.accepted.append(replace(found, optimality=UNKNOWN, solver="the optimum of a coarse copy of the scene"))
        return [self.accepted[-1]]

    def embedded(self, path: JointPath) -> list[Candidate]:
        """The local optimum reached from a path of a lower degree."""
        basis = self.program.basis
        coefficients = basis.fit(path, np.linspace(0.0, 1.0, near.DISTANCE_INTERVALS + 1))
        return self.optimum_from("lower degree", self.ends.met(basis, coefficients, self.start, self.goal))

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
        shape = self.program.basis.values(np.linspace(0.0, 1.0, near.DISTANCE_INTERVALS + 1)) @ self.program.free[:, :1]
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
        even = np.linspace(0.0, 1.0, len(s))
        places: tuple[near.Place, ...] = ()
        if self.model is not None:
            limit = self.clearance + near.NEAR
            places = tuple(near.dips(near.distance_profile(self.model, first(s), limit), limit))
        floor = self._energy_floor(first)
        found: list[LowEnergy] = []
        free: list[float] = []  # g of those that are free
        for _ in range(ROUNDS):
            path = self.program.basis.path(self.start, self.goal, coefficients)
            rows: list[ClearanceRow] = []
            if self.model is not None:
                watched = near.nearest(self.model, path, places, most=np.inf if free else self.clearance + near.FAR)
                rows = near.rows_for(self.model, path, lambda at: first(np.interp(at, even, s)), watched, self.clearance)
            solution = self.program.solve(
                self.start, self.goal, coefficients, floor, rows, self.deadline, self.constraint_search()
            )
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
        path = self.program.basis.path(self.start, self.goal, solution.coefficients)
        if not self.inside_limits(path):
            return []
        candidate = Candidate(
            path=path,
            coefficients=solution.coefficients,
            cost=self.program.integral.cost(path),
            optimality=UNKNOWN,
            solver=f"no descent on g gave a collision-free path; this one has a low energy ({solution.status})",
        )
        self.accepted.append(candidate)
        return [candidate]

    def unconstrained_g(self, path: JointPath) -> float:
        """g of the local optimum near a path, without limits and obstacles."""
        basis = self.program.basis
        same_breaks = np.isin(path.breaks, basis.breaks).all()  # then the fit at even places is the path itself
        even = np.linspace(0.0, 1.0, near.DISTANCE_INTERVALS + 1)
        s = even if same_breaks else self.program.integral.constant_speed(path, near.DISTANCE_INTERVALS + 1)
        coefficients = self.ends.met(basis, basis.fit(path, s), self.start, self.goal)
        if not self.program.free.size:
            return self.program.integral.cost(basis.path(self.start, self.goal, coefficients)).g
        moving = self.nearly_singular(self.program.integral.cost(path))
        true, z = self.program.descent_program(self.start, self.goal, coefficients, None, limited=False, moving=moving)
        nearby = true.length.curves.path(descend(true, z, tolerance=ROUGH).z)
        costs = [self.program.integral.cost(each).g for each in (path, nearby)]
        return min(costs)

    def _check_solution(self, name: str, solution: Solution) -> tuple[bool, NearPairs, tuple[near.Place, ...]]:
        """Whether a solution of the energy is inside the limits and proven free, and its distance profile.

        The third value is the place where the proof failed although the path is free at all places of the profile. The
        solution is appended to `history`.
        """
        path = self.program.basis.path(self.start, self.goal, solution.coefficients)
        profile, least = NearPairs.of((near.DISTANCE_INTERVALS + 1, 0), np.empty(0, dtype=np.intp), np.empty(0)), np.inf
        if self.model is not None and self.model.pair_names:
            q = path(np.linspace(0.0, 1.0, near.DISTANCE_INTERVALS + 1))
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
        s = self.program.integral.constant_speed(path, near.DISTANCE_INTERVALS + 1)
        basis = self.program.basis
        return s, self.ends.met(basis, basis.fit(path, s), self.start, self.goal)
