"""Local optima between one start and goal: first a path of low energy, then a descent on g among the true obstacles."""

import logging
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from manipplan.collision.model import CollisionModel
from manipplan.collision.near_pairs import NearPairs
from manipplan.collision.path_clearance import PathClearance, path_clearance
from manipplan.cost.integral import PathCost
from manipplan.optimize import clearance as near
from manipplan.optimize.basis import EndConditions
from manipplan.optimize.certificate import SINGLE, UNKNOWN, Optimality, measure_optimality
from manipplan.optimize.clearance import ClearanceRow
from manipplan.optimize.descent import descend
from manipplan.optimize.program import PathProgram, Solution
from manipplan.optimize.result import Step
from manipplan.optimize.step_models import MARGIN, Surroundings
from manipplan.paths.joint import JointPath
from manipplan.support.checks import Array

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
#: Maximum deviation of the fit to a path at which the basis counts as containing the path [rad or m].
SAME = 1e-9
#: The descent is repeated from the fit to the optimum at an even pace while that lowers g by more than this share.
WORTH = 1e-3
#: Tolerances on the joint limits [rad or m]: of rounded solutions of the energy, from which a descent moves back inside, and
#: of paths that are returned.
NEARLY_INSIDE, INSIDE = 1e-4, 1e-7
#: Tolerance of the descent to the unconstrained optimum, as a share of g: it is used only for comparison.
ROUGH = 1e-6
#: Maximum number of descents from one path with the final margin. Another one follows when the proof fails, when the
#: quadrature panels do not resolve g on the path reached, or when this one lowered g by more than the share SETTLED: a new
#: trust region may get past a kink of the clearance where the last one became too small.
DESCENTS, SETTLED = 8, 2e-4
#: After this number of paths that are not proven free, such as along the bumps of a point cloud, the final margin grows by the
#: second value each time.
FAILURES, WIDER = 2, 4.0
#: A converged descent whose path still misses the required clearance by more than this [m] is stuck in an obstacle.
STUCK = 5e-3
#: With a required clearance below the first value, descents keep these wider margins first [m]: a descent is slow around a
#: corner that it passes at only a tenth of a millimetre. Descents that settle at a kink, where the first-order conditions do
#: not hold, start once more from a path with the last of these margins.
ROUND, WIDE_MARGINS = 5e-3, (2e-3, 3e-4)
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
class LocalSearch:
    """Searches for local optima of one program between one start and goal.

    Attributes:
        program: the objective in one basis.
        start, goal: (n,) [rad or m].
        model: the arm among its obstacles; None: nothing is checked for collision.
        clearance: required distance [m].
        history: every solve is appended to it.
        ends: fixed derivatives at start and goal.
        known: the solution of the energy without obstacles is appended to it if it led to an optimum.
        accepted: every candidate is appended to it, so that an interrupt loses none.
        repaces: whether optima are fitted again at an even pace.
        brief: whether a descent ends at its first path that is proven free.
    """

    program: PathProgram
    start: Array
    goal: Array
    model: CollisionModel | None
    clearance: float
    history: list[Step]
    ends: EndConditions = field(default_factory=EndConditions)
    known: list[Solution] = field(default_factory=list)
    accepted: list[Candidate] = field(default_factory=list)
    repaces: bool = True
    brief: bool = False

    def single_path(self) -> list[Candidate]:
        """The only path of this basis, such as the straight line of degree 1; none when it is not free."""
        path = self.program.basis.path(self.start, self.goal, self._straight())
        if not (self._inside_limits(path) and self._keeps(path)):
            return []
        cost = self.program.integral.cost(path)
        return [Candidate(path=path, coefficients=self._straight(), cost=cost, optimality=SINGLE, solver="no unknowns")]

    def from_straight_line(self) -> list[Candidate]:
        """The local optimum reached from the straight line, through the minimum of the energy without obstacles.

        The descent among the obstacles starts at that minimum although it may collide; none when it ends in an obstacle.
        """
        solution = self.program.solve(self.start, self.goal, self._straight())
        is_free, *_ = self._judged("straight", solution)
        if not (is_free or solution.converged):
            return []
        found = self.optimum_from("straight", solution.coefficients)
        if found:
            self.known.append(solution)
        return found or (self._low_energy_path(solution) if is_free else [])

    def nearest_to(self, first: JointPath) -> list[Candidate]:
        """The local optimum reached from a path, or from its fit at an even pace when the basis does not contain it."""
        basis, even = self.program.basis, np.linspace(0.0, 1.0, near.PLACES + 1)
        coefficients = self.ends.met(basis, basis.fit(first, even), self.start, self.goal)
        off = np.abs(basis.path(self.start, self.goal, coefficients)(even) - first(even)).max()
        if off < SAME:  # a margin wider than the path's own would first lead away from it, such as from an optimum
            found = self._descend("path", coefficients, kept=first)
        else:
            found = self._descend("path", self._followed(first)[1])
        return [] if found is None else [found]

    def from_optimum(self, found: Candidate) -> list[Candidate]:
        """The local optimum reached from that of a similar scene; if there is none, that one itself if it is free here too."""
        near_it = self._descend("coarse", found.coefficients, is_optimum=True)
        if near_it is not None:
            return [near_it]
        if not self._keeps(found.path):
            return []
        self.accepted.append(replace(found, optimality=UNKNOWN, solver="the optimum of a coarse copy of the scene"))
        return [self.accepted[-1]]

    def embedded(self, path: JointPath) -> list[Candidate]:
        """The local optimum reached from a path of a lower degree."""
        basis = self.program.basis
        coefficients = basis.fit(path, np.linspace(0.0, 1.0, near.PLACES + 1))
        return self.optimum_from("lower degree", self.ends.met(basis, coefficients, self.start, self.goal))

    def optimum_from(self, name: str, coefficients: Array) -> list[Candidate]:
        """The local optimum of the true problem reached from coefficients (n, size); none when it is not free.

        With `repaces` and no active clearance, the optimum is fitted again at an even pace. The fit differs slightly, so
        another descent from it may reach a lower g.
        """
        best = self._descend(name, coefficients)
        while self.repaces and best is not None and best.optimality.active_clearance == 0.0 and np.isfinite(best.cost.g):
            again = self._descend("even pace", self._followed(best.path)[1])
            if again is None or again.cost.g >= best.cost.g:
                break
            gain = best.cost.g - again.cost.g
            if again.optimality.reached or not best.optimality.reached:
                best = again
            if gain <= WORTH * best.cost.g:
                break
        return [] if best is None else [best]

    def _descend(
        self, name: str, coefficients: Array, *, kept: JointPath | None = None, is_optimum: bool = False
    ) -> Candidate | None:
        """The path at which a descent from coefficients (n, size) ends; None when it is not free or leaves the limits.

        Descents are repeated until the path is proven free, the quadrature panels resolve its g, and the descent has
        converged. Each starts with the panels of the one before it, and also watches the place where the proof failed.
        Before the final margin only those are taken that the path `kept` has, if it is given. Near an optimum no other margin
        is taken, and the first path that meets the first-order conditions is returned.
        """
        program, integral = self.program, self.program.integral
        surroundings = None if self.model is None else Surroundings(model=self.model, clearance=self.clearance)
        path = program.basis.path(self.start, self.goal, coefficients)
        if not np.isfinite(integral.cost(path).g):  # a path that crosses a singularity has no finite g to descend from
            return None
        best: Candidate | None = None
        edges: Array | None = None
        steps = 0
        failed_g, failures = np.nan, 0  # g of the last path that was not proven free, and number of such paths
        backed_off = False
        *wide, final = self._margins(kept)
        waiting = [*([] if is_optimum else wide[:1] if self.brief else wide), *[final] * DESCENTS]
        while waiting:
            margin = waiting.pop(0)
            if surroundings is not None:
                surroundings.margin = margin
            true, z = program.descent_program(self.start, self.goal, coefficients, surroundings, edges=edges)
            refined = edges is None or len(true.length.edges) > len(edges)
            edges = true.length.edges
            if not np.isfinite(true.length.g0):
                break
            descent = descend(true, z)
            steps += descent.steps
            coefficients = true.length.curves.coefficients(descent.z)
            if margin > final:
                continue
            path = true.path(descent.z)
            cost, proof = integral.cost(path), self._proof(path)
            least = np.inf if proof is None else proof.upper
            self.history.append(Step(first=name, g=cost.g, clearance=least, solver=descent.reason))
            if surroundings is not None and proof is not None and not proof.proven:
                known = (proof.at, proof.pair_id) in surroundings.always
                stuck = proof.upper < self.clearance - STUCK and not descent.exhausted
                if stuck or (known and cost.g == failed_g):
                    log.debug("descent: stuck in an obstacle at s = %g", proof.at)
                    break
                surroundings.always += [] if known else [(proof.at, proof.pair_id)]
                failed_g, failures = cost.g, failures + 1
                if failures >= FAILURES:
                    final, backed_off = min(WIDER * final, max(self.room, final)), True
                    waiting = [final] * len(waiting)
                continue
            if not self._inside_limits(path):
                log.debug("descent: the path leaves the joint limits")
                break
            solver = f"{descent.reason} after {steps} steps"
            optimality = measure_optimality(true, descent.z)
            candidate = Candidate(path=path, coefficients=coefficients, cost=cost, optimality=optimality, solver=solver)
            agrees = abs(true.length.without_energy.value(descent.z) * true.length.g0 - cost.g) <= AGREEMENT * cost.g
            candidate = candidate if agrees else replace(candidate, optimality=UNKNOWN)
            settled = best is not None and best.cost.g - cost.g <= SETTLED * cost.g
            # a confirmed optimum may have a slightly larger g
            worth = WORTH if agrees and (optimality.reached or not backed_off) else 0.0
            best = candidate if best is None or cost.g < best.cost.g * (1 + worth) else best
            converged = optimality.reached or not descent.exhausted
            if not np.isfinite(cost.g) or self.brief:
                break
            if (settled or (is_optimum and optimality.reached)) and converged and (agrees or not refined):
                if best.optimality.reached or backed_off or not WIDE_MARGINS[-1] < self.room:
                    break
                backed_off, waiting = True, [WIDE_MARGINS[-1], *waiting]
        if best is not None:
            self.accepted.append(best)
        return best

    def _margins(self, kept: JointPath | None) -> list[float]:
        """Margins [m] of the descents from one path, in turn; none is wider than start and goal allow.

        Wide ones come before the final one, with `kept` only those that this path has.
        """
        wide = [margin for margin in WIDE_MARGINS if margin < self.room] if self.clearance < ROUND else []
        wide = [margin for margin in wide if kept is None or self._keeps(kept, margin)]
        return [*wide, max(min(MARGIN, self.room), 0.0)]

    @cached_property
    def room(self) -> float:
        """The smaller of the distances of start and goal beyond the required clearance [m]; 0 where nothing is checked."""
        if self.model is None:
            return 0.0
        return self.model.least_distance(np.array([self.start, self.goal]))[0] - self.clearance

    def _keeps(self, path: JointPath, margin: float = 0.0) -> bool:
        """Whether a path is proven to keep the required clearance plus a margin [m], or nothing is checked."""
        proof = self._proof(path, margin)
        return proof is None or proof.proven

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
            found = self.optimum_from("seed", best.coefficients) or self._low_energy_path(best)
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
        s, beginning = self._followed(first)
        coefficients = beginning
        even = np.linspace(0.0, 1.0, len(s))
        places: tuple[near.Place, ...] = ()
        if self.model is not None:
            limit = self.clearance + near.NEAR
            places = tuple(near.dips(near.distance_profile(self.model, first(s), limit), limit))
        found: list[LowEnergy] = []
        free: list[float] = []  # g of those that are free
        for _ in range(ROUNDS):
            path = self.program.basis.path(self.start, self.goal, coefficients)
            rows: list[ClearanceRow] = []
            if self.model is not None:
                watched = near.nearest(self.model, path, places, most=np.inf if free else self.clearance + near.FAR)
                rows = near.rows_for(self.model, path, lambda at: first(np.interp(at, even, s)), watched, self.clearance)
            solution = self.program.solve(self.start, self.goal, coefficients, rows)
            if not solution.converged and np.array_equal(coefficients, beginning):
                break
            if not solution.converged:  # where it stopped depends on rounding errors: restart with the same places
                coefficients = beginning
                continue
            coefficients = solution.coefficients
            if any(np.abs(coefficients - each.coefficients).max() < SAME_SOLUTION for each in self.known):
                break
            is_free, profile, failed_at = self._judged("seed", solution)
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
        if not self._inside_limits(path):
            return []
        candidate = Candidate(
            path=path,
            coefficients=solution.coefficients,
            cost=self.program.integral.cost(path),
            optimality=UNKNOWN,
            solver=f"no descent on g gave a collision-free path; this one has a low energy (IPOPT: {solution.status})",
        )
        self.accepted.append(candidate)
        return [candidate]

    def unconstrained_g(self, path: JointPath) -> float:
        """g of the local optimum near a path, without limits and obstacles."""
        basis = self.program.basis
        same_breaks = np.isin(path.breaks, basis.breaks).all()  # then the fit at even places is the path itself
        even = np.linspace(0.0, 1.0, near.PLACES + 1)
        s = even if same_breaks else self.program.integral.constant_speed(path, near.PLACES + 1)
        coefficients = self.ends.met(basis, basis.fit(path, s), self.start, self.goal)
        if not self.program.free.size:
            return self.program.integral.cost(basis.path(self.start, self.goal, coefficients)).g
        true, z = self.program.descent_program(self.start, self.goal, coefficients, None, limited=False)
        costs = [self.program.integral.cost(each).g for each in (path, true.path(descend(true, z, tolerance=ROUGH).z))]
        return min(costs)

    def _judged(self, name: str, solution: Solution) -> tuple[bool, NearPairs, tuple[near.Place, ...]]:
        """Whether a solution of the energy is inside the limits and proven free, and its distance profile.

        The third value is the place where the proof failed although the path is free at all places of the profile. The
        solution is appended to `history`.
        """
        path = self.program.basis.path(self.start, self.goal, solution.coefficients)
        profile, least = NearPairs.of((near.PLACES + 1, 0), np.empty(0, dtype=np.intp), np.empty(0)), np.inf
        if self.model is not None and self.model.pair_names:
            q = path(np.linspace(0.0, 1.0, near.PLACES + 1))
            profile = near.distance_profile(self.model, q, self.clearance + near.NEAR)
            least = float(profile.distances.min()) if len(profile.distances) else self.model.least_distance(q)[0]
        failed_at: tuple[near.Place, ...] = ()
        g = self.program.integral.cost(path).g
        self.history.append(Step(first=name, g=g, clearance=least, solver=solution.status))
        if least > self.clearance and self._inside_limits(path, NEARLY_INSIDE):
            proof = self._proof(path)
            if proof is None or proof.proven:
                return True, profile, ()
            failed_at = ((proof.at, proof.pair_id),)
        return False, profile, failed_at

    def _proof(self, path: JointPath, margin: float = 0.0) -> PathClearance | None:
        """The proof that a path keeps its clearance plus a margin [m]; None where nothing is checked."""
        if self.model is None or not self.model.pair_names:
            return None
        return path_clearance(self.model, path, clearance=self.clearance + margin, tolerance=None)

    def _inside_limits(self, path: JointPath, tolerance: float = INSIDE) -> bool:
        return all((self.program.kinematics.robot.limits.outside(q) <= tolerance).all() for q in path.bounds())

    def _straight(self) -> Array:
        """Coefficients (n, size) of the path nearest to the straight line that meets the end conditions."""
        return self.ends.met(self.program.basis, np.zeros((self.program.n, self.program.basis.size)), self.start, self.goal)

    def _followed(self, path: JointPath) -> tuple[Array, Array]:
        """Places s (m,) at equal shares of a path's g, and the coefficients (n, size) of the fit to it there."""
        s = self.program.integral.constant_speed(path, near.PLACES + 1)
        basis = self.program.basis
        return s, self.ends.met(basis, basis.fit(path, s), self.start, self.goal)
