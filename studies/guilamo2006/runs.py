"""Layers, searches and refinements of the study; each is computed once."""

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TypeVar, cast

import numpy as np

import manipplan as mp
from studies.guilamo2006 import config
from studies.guilamo2006.courses import Array, Course
from studies.guilamo2006.search import Found, search

Grid = tuple[int, ...]
Kind = TypeVar("Kind")


@dataclass(frozen=True, kw_only=True, eq=False)
class Sampled:
    """Layers of a course on a grid, and the computation time [s]."""

    course: Course
    grid: Grid
    layers: mp.Layers
    seconds: float

    @property
    def per_position(self) -> int:
        """Number of parameter samples at each position."""
        return int(np.prod(self.grid))

    @property
    def widest(self) -> float:
        """The largest step [degrees] of the grid in a sampled joint."""
        limits = self.course.robot.limits
        spans = np.rad2deg(limits.upper - limits.lower)[: len(self.grid)]
        return float(max(span / (k - 1) for span, k in zip(spans, self.grid, strict=True)))

    def above(self, minimum: float) -> int:
        """Number of starts that the paper's search needs for an optimum of `minimum`: candidates from there to the bound."""
        return sum(int(np.count_nonzero((m > minimum) & (m <= self.layers.bound))) for m in self.layers.m)


@dataclass(frozen=True, kw_only=True, eq=False)
class Searched:
    """The exact search in layers with an ε [degrees], and the computation time [s]."""

    sampled: Sampled
    epsilon: float
    found: mp.results.SearchResult
    seconds: float


@dataclass(frozen=True, kw_only=True, eq=False)
class Restarted:
    """The paper's search with an ε [degrees]."""

    sampled: Sampled
    epsilon: float
    memoised: bool
    found: Found

    @property
    def factor(self) -> float:
        """Branches per new start."""
        return self.found.branches / max(self.found.new_starts, 1)

    @property
    def ended(self) -> bool:
        """Whether the search finished before its limit on branches."""
        return self.found.end == "found"


@dataclass(frozen=True, kw_only=True, eq=False)
class Refined:
    """A refined path, and the computation time [s]."""

    searched: Searched
    refinement: mp.results.Refinement
    seconds: float


@dataclass(frozen=True, kw_only=True)
class Runs:
    """Cache of all runs by their arguments, shared by tables, figures and claims."""

    kept: dict[object, object] = field(default_factory=dict)

    def sampled(
        self, course: Course, grid: Grid, *, positions: int | None = None, closed: bool = False, collisions: bool = False
    ) -> Sampled:
        """All candidates of a course."""

        def run() -> Sampled:
            began = time.perf_counter()
            layers = mp.sample_layers(
                course.robot,
                course.path,
                positions or course.positions,
                task=config.TASK,
                samples=grid,
                collisions=collisions,
                closed=closed,
            )
            return Sampled(course=course, grid=grid, layers=layers, seconds=time.perf_counter() - began)

        return self._once(("sampled", course.name, grid, positions, closed, collisions), run)

    def searched(self, sampled: Sampled, epsilon: float, prefer: str = "shortest") -> Searched:
        """The exact optimum, or the reason why there is none."""

        def run() -> Searched:
            began = time.perf_counter()
            found = mp.max_min_search(sampled.layers, config.radians(epsilon), prefer=prefer, throw=False)
            return Searched(sampled=sampled, epsilon=epsilon, found=found, seconds=time.perf_counter() - began)

        return self._once(("searched", sampled, epsilon, prefer), run)

    def smallest(self, sampled: Sampled) -> float:
        """The smallest ε [degrees] that connects."""
        epsilon = self.searched(sampled, config.TINY, "first").found.smallest_epsilon
        return float("nan") if epsilon is None else float(np.rad2deg(epsilon[0]))

    def restarted(self, sampled: Sampled, epsilon: float, *, memoised: bool, most: int = config.MOST_BRANCHES) -> Restarted:
        """The paper's search, stopped after `most` branches."""

        def run() -> Restarted:
            found = search(sampled.layers, config.radians(epsilon), memoised=memoised, most_branches=most)
            return Restarted(sampled=sampled, epsilon=epsilon, memoised=memoised, found=found)

        return self._once(("restarted", sampled, epsilon, memoised, most), run)

    def refined(self, searched: Searched) -> Refined:
        """The refined path."""

        def run() -> Refined:
            began = time.perf_counter()
            refinement = mp.refine(searched.sampled.layers, searched.found)
            return Refined(searched=searched, refinement=refinement, seconds=time.perf_counter() - began)

        return self._once(("refined", searched), run)

    def thinned(self, sampled: Sampled, every: int) -> Sampled:
        """Layers with every `every`-th candidate only."""

        def run() -> Sampled:
            layers = sampled.layers
            q, m = ([each[::every].copy() for each in sets] for sets in (layers.q, layers.m))
            kept = mp.Layers.from_arrays(q, m, continuous=layers.continuous)
            return Sampled(course=sampled.course, grid=sampled.grid, layers=kept, seconds=sampled.seconds)

        return self._once(("thinned", sampled, every), run)

    def forget(self, sampled: Sampled) -> None:
        """Drop layers and the searches in them to free their memory."""
        searches = [value for value in self.kept.values() if getattr(value, "sampled", None) is sampled]
        gone = [sampled, *searches]
        for key, value in list(self.kept.items()):
            if any(value is each or getattr(value, "searched", None) is each for each in gone):
                del self.kept[key]

    def _once(self, key: object, run: Callable[[], Kind]) -> Kind:
        if key not in self.kept:
            self.kept[key] = run()
        return cast("Kind", self.kept[key])


def warm(runs: Runs, course: Course) -> None:
    """Compile everything once, so that no table includes the compile time."""
    sampled = runs.sampled(course, (8, 5, 8))
    runs.searched(sampled, 30.0)
    runs.searched(sampled, 30.0, "first")
    runs.searched(sampled, config.TINY, "first")


def still_torso(sampled: Sampled) -> tuple[Array, Array]:
    """The largest manipulability (L,) of all candidates, and of those whose torso is upright to half a grid step, or NaN."""
    limits = sampled.course.robot.limits
    half = np.array([(limits.upper[j] - limits.lower[j]) / (sampled.grid[j] - 1) / 2 for j in (0, 1)])
    every = np.array([m.max() for m in sampled.layers.m])
    upright = [
        m[(np.abs(q[:, :2]) <= half * (1 + 1e-9)).all(axis=1)] for q, m in zip(sampled.layers.q, sampled.layers.m, strict=True)
    ]
    return every, np.array([m.max() if len(m) else np.nan for m in upright])


def perturbation(m: Array) -> float:
    """Largest deviation of m (L,) from a smooth curve, a polynomial of degree 5, divided by the largest m."""
    places = np.linspace(-1.0, 1.0, len(m))
    smooth = np.polynomial.Polynomial.fit(places, m, 5)(places)
    return float(np.abs(m - smooth).max() / m.max())
