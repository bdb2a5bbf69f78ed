"""Local optima between one start and goal: solve, look where the path comes near something, renew rows there, repeat."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np

from manipplan.checks import Array
from manipplan.interrupts import interruptible
from manipplan.optimize import clearance as near
from manipplan.optimize.ends import EndConditions
from manipplan.optimize.objective import PathCost
from manipplan.optimize.problem import AGREEMENT, POLISH_PANELS, PathProgram, Solution
from manipplan.optimize.rows import ClearanceRow
from manipplan.paths.joint import JointPath
from manipplan.robots.collision import CollisionModel
from manipplan.robots.continuous import path_clearance
from manipplan.robots.robot import Robot

#: Rounds of solving and renewing clearance rows, from one first path.
ROUNDS = 8
#: Rounds end when one lowers g by less than this share.
SMALL_GAIN = 1e-2
#: Clearance rows are added at so many places a round, the deepest dips first.
NEW_PLACES = 10
#: Steps from one free path to the next, and how far one may go, at first and least: see `PathProgram.solve`.
STEPS, REACH, LEAST_REACH = 20, 0.3, 0.02


@dataclass(frozen=True, kw_only=True)
class Step:
    """One solve of the optimiser: from which first path, its g, its clearance [m] and IPOPT's word."""

    first: str
    g: float
    clearance: float
    solver: str


@dataclass(frozen=True, kw_only=True)
class Candidate:
    """An optimised path that is inside the limits and proven free, with its coefficients and the places its rows were at."""

    path: JointPath
    coefficients: Array
    cost: PathCost
    places: tuple[near.Place, ...]
    converged: bool
    solver: str


@dataclass(frozen=True, kw_only=True)
class LocalSearch:
    """Solves of one program between one start and goal, written down in `history`, and the candidates in `accepted`."""

    program: PathProgram
    start: Array
    goal: Array
    model: CollisionModel | None
    clearance: float
    history: list[Step]
    ends: EndConditions = field(default_factory=EndConditions)
    accepted: list[Candidate] = field(default_factory=list)

    def only_one(self) -> list[Candidate]:
        """The only path of this basis, such as the straight line of degree 1; none when it is not free."""
        solution = Solution(coefficients=self._straight(), status="Solve_Succeeded")
        candidate, *_ = self.judged("straight", solution, ())
        self.history.clear()  # nothing was solved
        return [candidate] if candidate else []

    def unconstrained(self) -> list[Candidate]:
        """The optimum as if nothing were in the way, from the straight line; used when it is free."""
        solution = self.program.solve(self.start, self.goal, self._straight())
        candidate, distances, _ = self.judged("straight", solution, ())
        return [] if candidate is None else [self._watching(candidate, distances)]

    def from_safe_path(self, first: JointPath) -> list[Candidate]:
        """From the fit to a free path, with rows that hold the path on that side of everything it comes near."""
        s, coefficients = self._followed(first)
        even = np.linspace(0.0, 1.0, len(s))
        places: tuple[near.Place, ...] = ()
        if self.model is not None:
            places = tuple(near.dips(near.distance_profile(self.model, first(s)), self.clearance + near.NEAR))
        found: list[Candidate] = []
        for _ in range(ROUNDS):
            path = self.program.basis.path(self.start, self.goal, coefficients)
            watched = places
            if self.model is not None:
                most = np.inf if found else self.clearance + near.FAR
                watched = near.nearest(self.model, path, places, most=most)
            rows = self.rows(path, lambda at: first(np.interp(at, even, s)), watched)
            solution = self.program.solve(self.start, self.goal, coefficients, rows)
            candidate, distances, touched = self.judged("seed", solution, places)
            coefficients = solution.coefficients
            if candidate is not None:
                found.append(candidate)
                if len(found) > 1 and found[-2].cost.g - candidate.cost.g < SMALL_GAIN * candidate.cost.g:
                    break
            if candidate is not None and not places:
                found[-1] = self._watching(candidate, distances)
                break
            places = self.more_places(places, distances, touched, touching=candidate is None)
        return found

    def by_steps(self, first: JointPath) -> list[Candidate]:
        """From the fit to a free path by steps that are short enough to stay free: for a basis that can follow that path.

        Where low degrees have no free path nearby and have to jump, many pieces have too much freedom for it. After a free
        step the next may go twice as far; after another one it starts again from the free path, half as far.
        """
        assert self.model is not None
        s, coefficients = self._followed(first)
        even, far = np.linspace(0.0, 1.0, len(s)), self.clearance + near.FAR
        places = tuple(near.dips(near.distance_profile(self.model, first(s)), far))
        reach = REACH
        found: list[Candidate] = []
        for _ in range(STEPS):
            path = self.program.basis.path(self.start, self.goal, coefficients)
            rows = self.rows(path, lambda at: first(np.interp(at, even, s)), near.nearest(self.model, path, places))
            solution = self.program.solve(self.start, self.goal, coefficients, rows, reach=reach)
            candidate, distances, touched = self.judged("steps", solution, places)
            if candidate is None:
                more = self.more_places(places, distances, touched, touching=True)
                if found and reach == LEAST_REACH and len(more) == len(places):
                    break
                places, reach = more, max(reach / 2, LEAST_REACH)
                coefficients = coefficients if found else solution.coefficients
                continue
            found.append(candidate)
            small = len(found) > 1 and found[-2].cost.g - candidate.cost.g < SMALL_GAIN * candidate.cost.g
            if small and reach >= REACH:
                break
            coefficients, reach = candidate.coefficients, 2 * reach
            places = tuple(near.merged(places, near.dips(distances, far)))
        return found

    def unconstrained_g(self, path: JointPath) -> float:
        """g of the local optimum near a path with neither limits nor obstacles."""
        basis = self.program.basis
        same_breaks = np.isin(path.breaks, basis.breaks).all()  # which the fit gives back as it is
        even = np.linspace(0.0, 1.0, near.PLACES + 1)
        s = even if same_breaks else self.program.objective.constant_speed(path, near.PLACES + 1)
        guess = self.ends.met(basis, basis.fit(path, s), self.start, self.goal)
        objective = self.program.objective
        if not self.program.free.size:
            return objective.cost(basis.path(self.start, self.goal, guess)).g
        first = objective.cost(basis.path(self.start, self.goal, guess)).g
        least = self._polished_g(self.program.solve(self.start, self.goal, guess, limited=False).coefficients)
        if least > first:  # the least energy nearby lies in another basin
            least = min(first, self._polished_g(guess))
        return least

    def _polished_g(self, guess: Array) -> float:
        """The least g that polishing coefficients (n, size) comes to, as if there were no limits."""
        basis, objective = self.program.basis, self.program.objective
        least = np.inf
        for panels in POLISH_PANELS:
            solution = self.program.polish(self.start, self.goal, guess, panels=panels, limited=False)
            found = basis.path(self.start, self.goal, solution.coefficients)
            g = objective.cost(found).g
            if g < least:
                least, guess = g, solution.coefficients
            if objective.agree(found, g, panels, AGREEMENT):
                break
        return least

    def rows(self, path: JointPath, safe: Callable[[float], Array], places: tuple[near.Place, ...]) -> list[ClearanceRow]:
        """Clearance rows at the places of `path`, with planes of the path `safe` where it is not free."""
        if self.model is None:
            return []
        return near.rows_for(self.model, path, safe, places, self.clearance)

    def more_places(
        self, places: tuple[near.Place, ...], distances: Array, touched: tuple[near.Place, ...], *, touching: bool
    ) -> tuple[near.Place, ...]:
        """The places, where the path `touched` something, and where its distance profile (m, k) [m] dips below the clearance.

        Of a path that is `touching` something, though not where it was looked at, those where it is nearest to.
        """
        for spare in (0.0, near.SPARE) if touching else (0.0,):
            deepest = [*touched, *near.dips(distances, self.clearance + spare)][:NEW_PLACES]
            for apart in (near.APART, near.CLOSE) if touching else (near.APART,):
                more = near.merged(places, near.around(deepest), apart)
                if len(more) > len(places):
                    return tuple(more)
        return places

    @interruptible()
    def judged(
        self, name: str, solution: Solution, places: tuple[near.Place, ...]
    ) -> tuple[Candidate | None, Array, tuple[near.Place, ...]]:
        """The candidate when the solution is inside the limits and proven free, and its distance profile (m, k) [m].

        Third the place where the proof failed, of a path that is free where the profile was taken.
        """
        path = self.program.basis.path(self.start, self.goal, solution.coefficients)
        cost = self.program.objective.cost(path)
        distances = np.full((near.PLACES + 1, 1), np.inf)
        if self.model is not None:
            distances = near.distance_profile(self.model, path(np.linspace(0.0, 1.0, near.PLACES + 1)))
        least = float(distances.min(initial=np.inf))
        self.history.append(Step(first=name, g=cost.g, clearance=least, solver=solution.status))
        if least <= self.clearance or not _inside_limits(self.program.kinematics.robot, path):
            return None, distances, ()
        if self.model is not None:
            proof = path_clearance(self.model, path, clearance=self.clearance, tolerance=None)
            if not proof.proven:
                return None, distances, ((proof.at, proof.index),)
        converged = solution.status == "Solve_Succeeded"
        candidate = Candidate(
            path=path,
            coefficients=solution.coefficients,
            cost=cost,
            places=places,
            converged=converged,
            solver=solution.status,
        )
        self.accepted.append(candidate)
        return candidate, distances, ()

    def _straight(self) -> Array:
        """Coefficients (n, size) of the path nearest to the straight line that meets the end conditions."""
        return self.ends.met(self.program.basis, np.zeros((self.program.n, self.program.basis.size)), self.start, self.goal)

    def _followed(self, path: JointPath) -> tuple[Array, Array]:
        """Places s (m,) at equal shares of a path's g, and the coefficients (n, size) of the fit to it there."""
        s = self.program.objective.constant_speed(path, near.PLACES + 1)
        basis = self.program.basis
        return s, self.ends.met(basis, basis.fit(path, s), self.start, self.goal)

    def _watching(self, candidate: Candidate, distances: Array) -> Candidate:
        """The candidate with places where it comes near something, though no row was needed to keep it away."""
        return replace(candidate, places=tuple(near.dips(distances, self.clearance + near.NEAR)))


def _inside_limits(robot: Robot, path: JointPath) -> bool:
    low, high = path.bounds()
    return not (robot.limits.outside(low) > 1e-7).any() and not (robot.limits.outside(high) > 1e-7).any()
