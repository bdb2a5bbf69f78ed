"""Exact max-min search: the continuous path through the layers with the largest minimum manipulability.

The value of a candidate b of layer i is W_i(b) = min(m(b), max over its neighbours a in layer i - 1 of W_{i-1}(a)), and the
optimum is the largest value in the last layer. This is a bottleneck path, found in one pass over the layers (`sweep` in
sweep.py); guilamo2006 searches for the same optimum by restarts. Two things make it fast. Neighbours are looked up in a grid
whose cells are as wide as the largest step. Rounds proceed from high thresholds to low ones: a round over only the candidates
with m >= t either finds the optimum, or proves that it is below t.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from typing import Literal, overload

import numpy as np
from numpy.typing import NDArray

from manipplan.kinematics.batch import all_cores
from manipplan.search.layers import Layers
from manipplan.search.search import CandidatePath, ThresholdSearch
from manipplan.search.sweep import (
    TAU,
    Lexicographic,
    Shortest,
    Subset,
    ThreadPool,
    Widest,
    check_epsilon,
    exclusive,
    full_turns,
    path_length,
    steps_between,
    without_jumps,
)
from manipplan.support.checks import COINCIDENT, MOST_THREADS, Array, ArrayLike, flag, instance, one_of, whole_number
from manipplan.support.display import one_line
from manipplan.support.errors import PlanningError
from manipplan.support.progress import Progress, as_callback, part, silent
from manipplan.support.status import Status


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class SearchResult:
    """The path that a search chose; where there is none, its arrays are empty and its minimum is -inf.

    Attributes:
        q: configurations (L, n) [rad or m]; continuous joints are unwrapped beyond ±π, so that their steps are small.
        indices: the chosen candidate of each layer (L,).
        manipulability: manipulability at each position (L,).
        minimum: the smallest of these values.
        bound: the smallest of the layers' largest manipulabilities: no path has a larger minimum, whatever its steps.
        certified_bound: no continuous path through these candidates has a larger minimum; equals minimum for an optimal path.
        connected: whether there is a path.
        status: return status.
        length: Σ ‖Δq‖ along the path, including the closing step of a cycle; inf where there is no path.
        epsilon, strict, closed: the arguments of the search; epsilon (n,) [rad or m].
        rounds: number of passes over the layers.
        nodes: number of candidates in the last pass.
        breaks_at: the first position, counted from 0, that no continuous path from the first one reaches; 0 when all are
            reached but no cycle closes; None when there is a path.
        smallest_epsilon: (n,) the limiting multiple of epsilon: with strict=False it connects the layers, with strict=True
            every larger multiple does. None when there is a path, or if it was not asked for.
        message: text of the status, with the numbers of this search.
    """

    q: Array
    indices: NDArray[np.int64]
    manipulability: Array
    minimum: float
    bound: float
    certified_bound: float
    connected: bool
    status: Status
    length: float
    epsilon: Array
    strict: bool
    closed: bool
    rounds: int
    nodes: int
    breaks_at: int | None = None
    smallest_epsilon: Array | None = None
    message: str = ""

    @property
    def gap(self) -> float:
        """Upper limit of what a larger epsilon could add to the minimum: bound - minimum."""
        return self.bound - self.minimum

    @property
    def certified_gap(self) -> float:
        """How far the optimum of these candidates can be above the minimum: 0 once it is found."""
        return self.certified_bound - self.minimum


#: Minimum number of candidates in the first round: fewer hardly save time.
FIRST = 20_000
GROWTH = 4
#: Minimum share of the candidates at which a round takes all of them.
MOST = 0.5
#: Share of candidates up to which rounds lower the threshold; beyond it they take samples.
TOP = 1 / 64
#: Number of candidates from which quantiles are estimated.
SAMPLE = 100_000


@dataclass(frozen=True, kw_only=True, eq=False)
class Quantiles:
    """Quantiles of the manipulability over all layers, estimated on a sample.

    Attributes:
        sample: manipulability values, descending.
        count: total number of candidates.
        bound: the smallest of the layers' largest manipulabilities.
    """

    sample: Array
    count: int
    bound: float

    @classmethod
    def of(cls, m: Sequence[Array], bound: float) -> "Quantiles":
        """Quantiles of layers m[i] (k_i,)."""
        count = sum(map(len, m))
        stride = max(1, count // SAMPLE)
        sample = np.sort(np.concatenate([each[::stride] for each in m]))[::-1]
        return cls(sample=sample, count=count, bound=bound)

    def first(self) -> float:
        """The first threshold: at most the bound, above which a layer is empty."""
        share = max(FIRST / self.count, self.share(self.bound))
        return -np.inf if share >= MOST else min(self.bound, self._quantile(share))

    def next(self, before: float) -> float:
        """The next threshold: about GROWTH times as many candidates reach it as reach `before`; -inf for the last."""
        share = GROWTH * self.share(before)
        lower = self.sample[self.sample < before]
        return -np.inf if share >= MOST or len(lower) == 0 else min(float(lower[0]), self._quantile(share))

    def share(self, threshold: float) -> float:
        """The share of candidates with a manipulability of at least the threshold."""
        return float(np.searchsorted(-self.sample, -threshold, side="right") / len(self.sample))

    def sampled(self, nodes: float, threshold: float) -> float:
        """Share of the candidates at or above the threshold that gives about `nodes` candidates; 1 for all."""
        share = nodes / max(self.share(threshold) * self.count, 1)
        return 1.0 if share >= MOST else share

    def _quantile(self, share: float) -> float:
        return float(self.sample[int(share * len(self.sample))])


#: Minimum number of candidates at which several threads are used.
THREADED = 50_000


class Prefer(Enum):
    """Which of the paths with the largest minimum manipulability is returned."""

    FIRST = "first"
    SHORTEST = "shortest"
    LEXICOGRAPHIC = "lexicographic"


@overload
def max_min_search(
    layers: Layers,
    epsilon: ArrayLike,
    *,
    strict: bool = True,
    prefer: str = "shortest",
    anytime: Literal[False] = False,
    explain: bool = True,
    throw: bool = True,
    progress: Progress | None = None,
    threads: int | None = None,
) -> SearchResult: ...
@overload
def max_min_search(
    layers: Layers,
    epsilon: ArrayLike,
    *,
    strict: bool = True,
    prefer: str = "shortest",
    anytime: Literal[True],
    explain: bool = True,
    throw: bool = True,
    progress: Progress | None = None,
    threads: int | None = None,
) -> Iterator[SearchResult]: ...
def max_min_search(
    layers: Layers,
    epsilon: ArrayLike,
    *,
    strict: bool = True,
    prefer: str = "shortest",
    anytime: bool = False,
    explain: bool = True,
    throw: bool = True,
    progress: Progress | None = None,
    threads: int | None = None,
) -> SearchResult | Iterator[SearchResult]:
    """Find the continuous path through the layers with the largest minimum manipulability; exact, in float64.

    Args:
        layers: candidates with their manipulability; if the layers are closed, the path is a cycle.
        epsilon: each joint's step between neighbouring layers is smaller than this [rad or m]: one number, or (n,).
        strict: with False, a step of exactly epsilon is allowed as well.
        prefer: choice among the paths with that minimum manipulability: "first" takes any; "shortest" the one with the
            smallest Σ ‖Δq‖; "lexicographic" the one with the largest second smallest manipulability, then the third, and so on;
            on ties the shortest. "lexicographic" sorts the vectors of values at each layer: it takes the most time and memory.
        anytime: return an iterator instead of a result. It yields results during the search, with a rising minimum or a
            falling certified_bound; the last one is the optimum, the same as with False.
        explain: if no path is continuous, find `smallest_epsilon`, which can take far longer than the search.
        throw: raise PlanningError, which holds the result, if no path is continuous. With False, that result is returned;
            it tells where the layers are disconnected.
        progress: called several times per second with the share done in [0, 1], which never falls, and a text. The share
            refers to the worst-case work: if the search ends early, it jumps to 1.
        threads: number of threads; by default one per core.

    A cycle is found exactly, by branch and bound over its first candidate. For the largest minimum manipulability this takes a
    few more passes than an open path does; the shortest cycle can take hundreds.

    Raises InvalidInputError for bad arguments, PlanningError where no path is continuous.
    """
    instance("layers", layers, Layers)
    steps = check_epsilon(epsilon, layers.continuous)
    for name, value in {"strict": strict, "anytime": anytime, "explain": explain, "throw": throw}.items():
        flag(name, value)
    one_of("prefer", prefer, [each.value for each in Prefer])
    notify = as_callback(progress)
    if threads is None:
        threads = all_cores()
    whole_number("threads", threads, least=1, most=MOST_THREADS)
    results = _results(layers, steps, bool(strict), Prefer(prefer), explain, notify, threads if layers.count >= THREADED else 1)
    results = _raise_if_not_connected(results) if throw else results
    if anytime:
        return results
    *_, last = results
    return last


#: Step between labels that no path may take.
SAME = 0.5


def _labelled(layers: Layers, labels: Sequence[NDArray[np.int64]], epsilon: ArrayLike) -> tuple[Layers, Array]:
    """The layers with the label of each candidate (k_i,) as one more joint, and steps (n + 1,) that keep it."""
    pace = None if layers.joint_pace is None else np.append(layers.joint_pace, np.inf)
    q = tuple(np.column_stack([q, each]).astype(np.float64) for q, each in zip(layers.q, labels, strict=True))
    middles = None if layers.turn_middles is None else np.append(layers.turn_middles, np.nan)
    made = replace(layers, q=q, continuous=np.append(layers.continuous, False), joint_pace=pace, turn_middles=middles)
    return made, np.append(check_epsilon(epsilon, layers.continuous), SAME)


def search_within(
    layers: Layers,
    labels: Sequence[NDArray[np.int64]] | None,
    epsilon: ArrayLike,
    *,
    prefer: str = "shortest",
    strict: bool = True,
) -> SearchResult:
    """`max_min_search` for paths of candidates with one label, those of each layer (k_i,); None: any. It does not throw."""
    if labels is None:
        return max_min_search(layers, epsilon, strict=strict, prefer=prefer, explain=False, throw=False)
    labelled, steps = _labelled(layers, labels, epsilon)
    found = max_min_search(labelled, steps, strict=strict, prefer=prefer, explain=False, throw=False)
    return replace(found, q=found.q[:, :-1], epsilon=found.epsilon[:-1])


def minimum_to_each(layers: Layers, epsilon: ArrayLike, *, strict: bool = True, cap: float = np.inf) -> Array:
    """For each candidate of the last layer (k,), the largest minimum manipulability of a continuous path that ends there.

    At most `cap`; -inf where no path leads there from the first layer. One pass. The paths need not close.
    """
    reach = exclusive(check_epsilon(epsilon, layers.continuous), strict=strict)
    with ThreadPool(all_cores() if layers.count >= THREADED else 1) as pool:
        return ThresholdSearch(replace(layers, closed=False), pool, silent, work=layers.count).last_values(
            Subset(cap=cap), reach
        )


def minimum_from_each(
    layers: Layers,
    epsilon: ArrayLike,
    *,
    labels: Sequence[NDArray[np.int64]] | None = None,
    strict: bool = True,
    cap: float = np.inf,
) -> Array:
    """The same for each candidate of the first layer (k,), of the paths that begin there and lead to the last layer.

    `labels` as in `search_within`.
    """
    if labels is not None:
        layers, epsilon = _labelled(layers, labels, epsilon)
    s = None if layers.s is None else layers.s[::-1]
    backwards = replace(layers, q=layers.q[::-1], m=layers.m[::-1], s=s, closed=False)
    return minimum_to_each(backwards, epsilon, strict=strict, cap=cap)


def path_above(layers: Layers, reach: Array, least: float, progress: Progress) -> Array | None:
    """The shortest of the paths (L, n) with the largest minimum manipulability, if that is at least `least`; None for none.

    Each step is below its own row of `reach`, (L - 1, n) or, for closed layers, (L, n).
    """
    text = "a better path with faster joints"
    with ThreadPool(all_cores() if layers.count >= THREADED else 1) as pool:
        search = ThresholdSearch(layers, pool, progress, work=3 * layers.count)
        if search.best(Widest(), Subset(threshold=least, cap=least), reach, text) is None:  # told sooner
            return None
        best = search.best(Widest(), Subset(threshold=least), reach, text)
        assert best is not None
        path = search.best(Shortest(), Subset(threshold=search.minimum_manipulability(best)), reach, text)
        assert path is not None
        return search.configurations(path)


def _results(
    layers: Layers, epsilon: Array, strict: bool, prefer: Prefer, explain: bool, notify: Progress, threads: int
) -> Iterator[SearchResult]:
    """Yields results during the search, or the last one of a far smaller search in one full turn, if it is the same."""
    fewer = layers.in_one_turn
    if fewer is not None and (epsilon[fewer.continuous] < np.pi).all():
        some = threads if fewer.count >= THREADED else 1
        *_, found = _results(fewer, epsilon, strict, prefer, False, part(notify, 0.0, 0.1), some)
        at_turns = _at_full_turns(layers, found)
        if at_turns is not None:
            yield at_turns
            return
        notify = part(notify, 0.1, 1.0)
    reach = exclusive(epsilon, strict=strict)
    # samples and rounds grow fourfold up to all candidates; a preference other than "first" takes one more pass
    with ThreadPool(threads) as pool:
        search = ThresholdSearch(layers, pool, notify, work=layers.count * (4 / 3 + (prefer is not Prefer.FIRST)))
        search.notify(0.0, "searching")
        path, certified = None, layers.bound
        for path, certified, exact in _rounds(search, reach):
            if exact:
                break
            yield _result(search, path, Status.IMPROVING, epsilon, strict, certified)
        if path is None:
            yield _not_connected(search, epsilon, reach, strict, explain)
            return
        if prefer is not Prefer.FIRST:
            objective = Shortest() if prefer is Prefer.SHORTEST else Lexicographic()
            path = search.best(objective, Subset(threshold=certified), reach, f"{prefer.value} path")
        final = _result(search, path, Status.PROVEN_OPTIMAL, epsilon, strict, certified)
        search.notify(1.0, "done")
        yield final


def _at_full_turns(layers: Layers, found: SearchResult) -> SearchResult | None:
    """A path found through `in_one_turn` of the layers at full turns inside the limits, the middle ones; None without any."""
    assert layers.turn_middles is not None
    turning = ~np.isnan(layers.turn_middles)
    if not found.connected or (layers.closed and full_turns(found.q, turning).any()):
        return None
    middle = (found.q.min(axis=0) + found.q.max(axis=0)) / 2
    away = layers.q[0][0] - found.q[0] if len(layers.q[0]) == 1 else layers.turn_middles - middle
    q, indices = found.q + np.where(turning, TAU * np.round(away / TAU), 0.0), np.empty_like(found.indices)
    for k, (candidates, m) in enumerate(zip(layers.q, layers.m, strict=True)):
        alike = np.flatnonzero(m == found.manipulability[k])
        steps = steps_between(candidates[alike], q[k], layers.continuous)
        same = alike[(np.abs(steps) < COINCIDENT).all(axis=1)]
        if not len(same):
            return None
        indices[k], q[k] = same[0], candidates[same[0]]
    return replace(found, q=without_jumps(q, layers.continuous), indices=indices)


def _rounds(search: ThresholdSearch, reach: Array) -> Iterator[tuple[CandidatePath | None, float, bool]]:
    """Rounds up to the exact one: each yields the best path so far, the certified bound, and whether the path is optimal."""
    layers = search.layers
    quantiles = Quantiles.of(layers.m, layers.bound)
    path: CandidatePath | None = None
    certified, least, nodes = layers.bound, -np.inf, FIRST
    threshold = quantiles.first()
    # from the top: either the optimum is found, or it is below the threshold
    while threshold > -np.inf and quantiles.share(threshold) < max(TOP, 2 * FIRST / layers.count):
        path = search.best(Widest(), Subset(threshold=threshold, cap=certified), reach, f"candidates with m >= {threshold:.6g}")
        if path is not None:
            yield path, search.minimum_manipulability(path), True
            return
        certified = min(certified, threshold)
        yield None, certified, False
        nodes = max(nodes, search.nodes)
        threshold = quantiles.next(threshold)
    # samples of the candidates: each may raise the best minimum found; later ones leave out candidates below it
    while True:
        share = quantiles.sampled(GROWTH * nodes, least)
        part = Subset(threshold=least, share=share, cap=certified)
        text = "all candidates" if share == 1 else f"a sample of {share:.1%} of the candidates"
        found = search.best(Widest(), part, reach, text if path is None else f"{text} with m >= {least:.6g}")
        path = found or path
        nodes = GROWTH * nodes
        if path is not None:
            least = search.minimum_manipulability(path)
        exact = share == 1 or least == certified
        if exact and path is not None:
            certified = least
        yield path, certified, exact
        if exact:
            return


def _raise_if_not_connected(results: Iterator[SearchResult]) -> Iterator[SearchResult]:
    for result in results:
        if result.status is Status.NOT_CONNECTED:
            raise PlanningError(result.message, result)
        yield result


def _result(
    search: ThresholdSearch, path: CandidatePath | None, status: Status, epsilon: Array, strict: bool, certified: float
) -> SearchResult:
    layers = search.layers
    if path is None:
        q, indices, values = np.empty((0, layers.n)), np.empty(0, dtype=np.int64), np.empty(0)
    else:
        q, indices = without_jumps(search.configurations(path), layers.continuous), path.indices
        values = np.array([m[i] for m, i in zip(layers.m, indices, strict=True)])
    minimum = float(values.min()) if path is not None else -np.inf
    return SearchResult(
        q=q,
        indices=indices,
        manipulability=values,
        minimum=minimum,
        bound=layers.bound,
        certified_bound=certified,
        connected=path is not None,
        status=status,
        length=np.inf if path is None else path_length(q, layers.continuous, closed=layers.closed),
        epsilon=epsilon,
        strict=strict,
        closed=layers.closed,
        rounds=search.rounds,
        nodes=search.nodes,
        message=f"{status.value} (minimum {minimum:.6g}, bound {layers.bound:.6g}, certified {certified:.6g})",
    )


def _not_connected(search: ThresholdSearch, epsilon: Array, reach: Array, strict: bool, explain: bool) -> SearchResult:
    result = _result(search, None, Status.NOT_CONNECTED, epsilon, strict, -np.inf)
    count = len(search.layers.q)
    place = search.reached(reach) % count  # 0: all reached, but no cycle closes
    if place:
        where = f"no candidate of position {place} can be reached from position {place - 1}"
    else:
        where = f"no path closes: none ends at position {count - 1} within epsilon of its start at position 0"
    smallest, remedy = None, ""
    if explain and search.layers.joint_pace is None:  # a larger ε does not help a joint that is too slow
        smallest = search.least_epsilon(epsilon)
        factor = float((smallest / epsilon).max())
        least = ", ".join(f"{each:.6g}" for each in smallest)
        which = f"for values above {factor:.6g} times epsilon" if strict else f"for {factor:.6g} times epsilon or more"
        remedy = f"the layers are connected {which} ({least}); "
    message = f"{where}; {remedy}{Status.NOT_CONNECTED.value}"
    search.notify(1.0, "done")
    return replace(result, breaks_at=place, smallest_epsilon=smallest, message=message)
