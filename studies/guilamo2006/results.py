"""Shared by tables, figures and claims: the courses, grids and ε that are run."""

from dataclasses import dataclass
from functools import cached_property

from studies.guilamo2006 import config, tables
from studies.guilamo2006.courses import Course
from studies.guilamo2006.runs import Grid, Refined, Restarted, Runs, Sampled, Searched


@dataclass(frozen=True, kw_only=True, eq=False)
class Results:
    """The runs of the study; with `quick` only those of the coarse grids."""

    runs: Runs
    courses: tuple[Course, Course]
    second: tuple[Course, Course]
    quick: bool

    @property
    def grid(self) -> Grid:
        """The finest grid that is run in all parts."""
        return config.COARSE if self.quick else config.FULL

    @property
    def table_grids(self) -> tuple[Grid, ...]:
        """Grids of Table I."""
        return (config.COARSE,) if self.quick else (config.FULL, config.COARSE)

    @property
    def grids(self) -> tuple[Grid, ...]:
        """Grids of the sweep."""
        return config.GRIDS if self.quick else config.FULL_GRIDS

    @property
    def even_grids(self) -> tuple[Grid, ...]:
        """Grids of the sweep whose steps are about equal in all sampled joints."""
        return tuple(grid for grid in self.grids if grid != config.UNEVEN)

    def sample(self) -> None:
        """Sample the candidates that are used most."""
        for course in self.courses:
            for grid in self.table_grids:
                self.runs.sampled(course, grid)

    def sampled(self, course: Course, grid: Grid | None = None) -> Sampled:
        """Candidates of a course on a grid, by default the finest."""
        return self.runs.sampled(course, grid or self.grid)

    def best(self, course: Course, grid: Grid | None = None, prefer: str = "shortest") -> Searched:
        """The exact optimum at the ε of Table I."""
        sampled = self.sampled(course, grid)
        return self.runs.searched(sampled, tables.epsilon_of(course, sampled.grid), prefer)

    def refined(self, course: Course, grid: Grid | None = None) -> Refined:
        """The exact optimum, refined."""
        return self.runs.refined(self.best(course, grid))

    def restarted(self, course: Course, grid: Grid | None = None, *, memoised: bool) -> Restarted:
        """The paper's search at the ε of Table I."""
        sampled = self.sampled(course, grid)
        epsilon, most = tables.epsilon_of(course, sampled.grid), tables.most_of(sampled.grid)
        return self.runs.restarted(sampled, epsilon, memoised=memoised, most=most)

    @cached_property
    def branching(self) -> list[Restarted]:
        """The paper's search on the circle for all ε and grids."""
        return tables.branching_runs(self.runs, self.courses[0])

    @property
    def wide(self) -> Restarted:
        """The paper's search on the circle on the finest grid at an ε of 5 degrees."""
        return self.runs.restarted(self.sampled(self.courses[0]), config.COMPARED_EPSILONS[-1], memoised=False)

    @cached_property
    def refinable(self) -> list[Searched]:
        """The searches whose paths are refined."""
        return [self.best(course, grid) for grid in self.table_grids for course in self.courses]

    @cached_property
    def ties(self) -> list[Searched]:
        """Searches for the shortest path, at the ε of Table I and at 10 degrees."""
        wide = [
            self.runs.searched(self.sampled(course, grid), config.EPSILONS[-1])
            for grid in self.table_grids
            for course in self.courses
        ]
        return [*self.refinable, *wide]

    @cached_property
    def cycles(self) -> list[tuple[Searched, Searched]]:
        """The circle as an open and as a closed path."""
        circle = self.courses[0]
        pairs = []
        for grid in self.table_grids:
            epsilon = tables.epsilon_of(circle, grid)
            closed = self.runs.sampled(circle, grid, closed=True)
            pairs.append((self.best(circle, grid), self.runs.searched(closed, epsilon)))
        return pairs
