"""Plans paths to the best candidates of a goal and chooses among them, while better ones are possible."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from manipplan.goals.candidates import APART, TIE, GoalCandidate
from manipplan.optimize.result import PathResult
from manipplan.support.checks import Array
from manipplan.support.deadline import Deadline
from manipplan.support.progress import Progress, part
from manipplan.support.status import Failure

#: Maximum number of paths that are planned, and of candidates to which one is tried.
PATHS, TRIES = 4, 8
#: Share of the remaining time that one candidate gets while there are others.
SHARE = 0.75

#: Plans a path to a configuration (n,) within a time [s]: the result, or a Failure with the reason.
Planner = Callable[[Array, float, Progress], PathResult | Failure]


@dataclass(frozen=True, kw_only=True, eq=False)
class GoalChoice:
    """The path that was chosen, None where none was found, and all candidates with what became of them.

    Attributes:
        failures: for each candidate that was tried without success, in their order, why there is no path to it.
    """

    result: PathResult | None
    candidates: tuple[GoalCandidate, ...]
    failures: tuple[str, ...]

    @property
    def goal_index(self) -> int:
        """Index of the goal that the chosen path reaches; 0 where there is none."""
        return next((each.goal_index for each in self.candidates if each.chosen), 0)

    @property
    def failure(self) -> str:
        """Why there is no path."""
        first = self.failures[0] if self.failures else "the time limit ended the search"
        if len(self.candidates) == 1:
            return first
        return f"no path to any of the {len(self.failures)} candidates tried; the first: {first}"


def choose(candidates: Sequence[GoalCandidate], planner: Planner, deadline: Deadline, notify: Progress) -> GoalChoice:
    """The motion of the largest minimum manipulability and, of those that tie, of the smallest g.

    Candidates are tried in their order. After the first path only those are tried whose bound is above its minimum
    manipulability: first the one nearest to it, then the others, at most PATHS paths in all. Each candidate gets SHARE of
    the time that is left, the last one all of it.
    """
    search = _Search(rows=list(candidates), tried=[], paths={}, failures={})
    if len(candidates) == 1:
        search.take(0, planner(candidates[0].q, deadline.left, notify))
        return search.choice()
    while (k := search.following()) is not None and not (search.tried and deadline.passed):
        only = sum(each.is_free for each in candidates) == 1 or len(search.paths) == PATHS - 1
        share = deadline.left * (1.0 if only else SHARE)
        done = len(search.tried) / (len(search.tried) + 1)
        found = planner(candidates[k].q, share, part(notify, done, (2 * done + 1) / 3 if not only else 1.0))
        search.take(k, found)
    return search.choice()


@dataclass(kw_only=True, eq=False)
class _Search:
    """The state of a search: the candidates, those tried, and by the index of a candidate its path, or why it has none."""

    rows: list[GoalCandidate]
    tried: list[int]
    paths: dict[int, PathResult]
    failures: dict[int, str]

    @property
    def best(self) -> int | None:
        """The index of the best candidate with a path."""
        best: int | None = None
        for k, path in self.paths.items():
            if best is None or _is_better(path, self.paths[best]):
                best = k
        return best

    def following(self) -> int | None:
        """The candidate to be tried next; None where none can be better, or enough were tried."""
        if len(self.paths) >= PATHS or len(self.tried) >= TRIES:
            return None
        left = [k for k, each in enumerate(self.rows) if each.is_free and k not in self.tried and self._can_win(each)]
        if not left:
            return None
        best = self.best
        if best is not None and len(self.paths) == 1:
            return min(left, key=lambda k: self.rows[k].straight_length)
        others = [k for k in left if all(self._apart(k, j) for j in self.tried)]
        if best is None:  # the nearby ones may still give a path
            others = others or left
        return others[0] if others else None

    def _can_win(self, candidate: GoalCandidate) -> bool:
        best = self.best
        return best is None or candidate.bound > self.paths[best].min_manipulability * (1 + TIE)

    def _apart(self, first: int, second: int) -> bool:
        a, b = self.rows[first], self.rows[second]
        return a.goal_index != b.goal_index or bool(np.abs(a.q - b.q).max() > APART)

    def take(self, k: int, found: PathResult | Failure) -> None:
        """Take what planning to a candidate gave."""
        self.tried.append(k)
        if isinstance(found, Failure):
            self.failures[k] = found.message
            self.rows[k] = replace(self.rows[k], status=f"left out: no path: {found.message}")
            return
        self.paths[k] = found
        least, g = found.min_manipulability, found.g
        status = f"planned: minimum manipulability {least:.4g}, g {g:.4g}"
        self.rows[k] = replace(self.rows[k], q=found.path.goal, status=status, min_manipulability=least, g=g)

    def choice(self) -> GoalChoice:
        """The best path, and what became of every candidate."""
        best = self.best
        rows = [self._with_outcome(k, best) for k in range(len(self.rows))]
        failures = tuple(self.failures[k] for k in sorted(self.failures))
        return GoalChoice(result=None if best is None else self.paths[best], candidates=tuple(rows), failures=failures)

    def _with_outcome(self, k: int, best: int | None) -> GoalCandidate:
        row = self.rows[k]
        if best is not None and k == best:
            aspect = ""
            if row.least_crossings:
                same = any(each.is_free and not each.least_crossings for each in self.rows)
                why = "no path was found to one in the same" if same else "none in the same is free"
                aspect = f"; in another aspect than the start, since {why}"
            return replace(row, chosen=True, status=f"chosen, {row.status}{aspect}")
        if not row.is_free or k in self.tried:
            return row
        if best is None:
            return replace(row, status="left out: the time or the number of tries was used up")
        minimum = self.paths[best].min_manipulability
        if row.least_crossings and not self.rows[best].least_crossings:
            return replace(row, status="left out: in another aspect than the start")
        if row.bound > minimum * (1 + TIE):
            return replace(row, status=f"left out: bound {row.bound:.4g}, but enough were tried, or it is near one of those")
        return replace(row, status=f"left out: bound {row.bound:.4g} is not above {minimum:.4g}, which the motion keeps")


def _is_better(path: PathResult, other: PathResult) -> bool:
    """Whether a path has the larger minimum manipulability or, where the two tie, the smaller g."""
    least, most = sorted((path.min_manipulability, other.min_manipulability))
    if least >= most * (1 - TIE):
        return path.g < other.g
    return path.min_manipulability > other.min_manipulability
