"""FollowingMotion: paths along the parts of a workspace path, and the free motions to and between them.

The parts of a workspace path along which there are continuous motions: all of it or, where none is, the fewest.
"""

from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property, partial
from itertools import chain, pairwise

import numpy as np
from numpy.typing import NDArray

from manipplan.collision.scene import Scene
from manipplan.cost.integral import PathIntegral
from manipplan.goals.candidates import GoalCandidate
from manipplan.kinematics.kinematics import Kinematics
from manipplan.optimize.result import PathResult, make_result
from manipplan.paths.deviation import deviation_at
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import Tolerance
from manipplan.search.interruptions import fewest_interruptions, find_gaps
from manipplan.search.layers import step_limits
from manipplan.search.max_min import SearchResult, max_min_search, path_above
from manipplan.search.sweep import check_epsilon, path_steps
from manipplan.support.checks import COINCIDENT, Array, ArrayLike
from manipplan.support.deadline import Deadline, OutOfTimeError, until
from manipplan.support.errors import InvalidInputError, OutOfReachError, PlanningError
from manipplan.support.progress import Progress, part, silent
from manipplan.support.status import Failure, Status
from manipplan.timing.constant_speed import RAMP, SpeedDemand
from manipplan.tool_path.engine import CALM, CALM_SHARE, CLOSER, RefinedToolPath, ToolPathPlanner
from manipplan.tool_path.entry import choose_entry
from manipplan.tool_path.transit import Transit, TransitPlanner


@dataclass(frozen=True, kw_only=True, eq=False)
class FoundPart:
    """A part of a workspace path, and a motion along it.

    Attributes:
        s_begin, s_end: where on the path it begins and ends; beyond 1 where it goes on around a closed one.
        first: the index of its first position among those of the whole path.
        planner: of motions along it.
        found: the best motion through its positions.
        is_held: whether its first configuration is given.
    """

    s_begin: float
    s_end: float
    first: int
    planner: ToolPathPlanner
    found: SearchResult
    is_held: bool

    @cached_property
    def refined(self) -> RefinedToolPath:
        """The joint path along the best motion or, where a tool speed is asked for, along one that keeps it."""
        along = self.planner.along if self.planner.demand is None else self.planner.closely_along
        return along(self.found, silent, hold_start=self.is_held)

    def split(self, stops: Sequence[float], demand: SpeedDemand, epsilon: ArrayLike) -> "list[FoundPart]":
        """The parts between those of `stops`, s of the whole path, that are inside this one, for a tool speed."""
        planner, width = self.planner.at_speed(demand), self.s_end - self.s_begin
        inside = np.sort((np.asarray(stops) - self.s_begin) % 1.0 / width)
        inside = inside[(inside > COINCIDENT) & (inside < 1 - COINCIDENT)]
        assert planner.layers.s is not None
        new = inside[np.abs(inside[:, None] - planner.layers.s).min(axis=1) > COINCIDENT]
        with suppress(InvalidInputError):  # no configuration keeps what candidates have to spare: stop at a position beside
            planner = planner.with_positions(new, silent) if len(new) else planner
        assert planner.layers.s is not None
        at = {int(np.abs(each - planner.layers.s).argmin()) for each in inside}
        if planner.layers.closed:
            edges = sorted(at or {0})
            edges.append(edges[0] + len(planner.layers.q))
        else:
            edges = sorted(at | {0, len(planner.layers.q) - 1})
        if len(edges) == 2 and not planner.layers.closed:
            return [self if self.planner.demand is not None else replace(self, planner=planner)]
        pieces = [
            _part(planner, *ends, epsilon, (k + 1) / len(edges), is_held=self.is_held and ends[0] == 0)
            for k, ends in enumerate(pairwise(edges))
        ]
        begins = [self.s_begin + width * each.s_begin for each in pieces]
        turns = np.floor(np.array(begins) + COINCIDENT).tolist()  # around a closed path
        return [
            replace(each, s_begin=max(begin - turn, 0.0), s_end=self.s_begin + width * each.s_end - turn)
            for each, begin, turn in zip(pieces, begins, turns, strict=True)
        ]

    def stops(self, epsilon: ArrayLike, most: int) -> list[float]:
        """Up to `most` values s of the whole path at which a tool that is too slow along this part has to stop; [] for none.

        The fewest between which joints have the time for every step from one position to the next. Where they have it anyway,
        or more would be needed, the one where limits make the tool slowest, if that is not where ramps are anyway.
        """
        slowest, layers = self.refined.slowest_at, self.planner.at_speed(self.planner.demand).layers
        at = [slowest] if layers.closed or RAMP < slowest < 1 - RAMP else []
        if not max_min_search(layers, epsilon, prefer="first", explain=False, throw=False).connected:
            with suppress(PlanningError):  # a single step takes too long: limits bind there
                edges = np.array(fewest_interruptions(layers, epsilon).edges[not layers.closed : -1])
                assert layers.s is not None
                at = layers.s[edges % len(layers.q)].tolist() if len(edges) <= most else at
        return [self.s_begin + (self.s_end - self.s_begin) * each for each in at if most]


@dataclass(frozen=True, kw_only=True, eq=False)
class NotConnected(Failure):
    """Why there is no motion with so few interruptions.

    Attributes:
        message: whether more interruptions help.
        search: through the candidates of all positions.
        planner: of motions along the path, with the positions that were added.
    """

    search: SearchResult
    planner: ToolPathPlanner


#: How often the distance between positions is halved where no motion leads on, and where not even one step does.
HALVED, HALVED_STEP = 3, 6
#: Maximum number of gaps from whose ends small steps are tried.
CONTINUED = 4
#: Relative gain in the minimum manipulability for which positions are added, and largest step of a continuous joint that is
#: considered there [rad].
GAIN, LONGEST = 0.01, 3.0
#: Maximum number of candidates up to which positions are added.
MOST = 20_000_000
#: What `ToolPathPlanner.search` returns.
Searched = tuple[ToolPathPlanner, SearchResult]


def connect(planner: ToolPathPlanner, epsilon: ArrayLike, notify: Progress, *, start: Array | None = None) -> ToolPathPlanner:
    """The planner with as many more positions as a motion along the path needs.

    They are added where a gap has to be closed, until there is none or they are as close as they may be. Where samples of
    several parameters do not connect, small steps from some of them are tried first. Joints that are too slow for the tool
    speed make no gap: more positions do not help them.
    """
    is_continued = not planner.has_several_parameters
    while True:
        begun = (planner if start is None else planner.starting_at(start)).at_any_pace()
        gaps = find_gaps(begun.layers.in_one_turn or begun.layers, epsilon, progress=part(notify, 0.0, 0.0))
        if gaps.ranges and not is_continued:
            ends = {k % len(planner.layers.q) for each in gaps.ranges[:CONTINUED] for k in each}
            planner, is_continued = planner.continued(sorted(ends), epsilon, notify), True
            continue
        wide = [np.zeros(0, dtype=np.int64)]
        for first, last in gaps.ranges:
            spanned = np.arange(first, last) % (len(planner.layers.q) - (not planner.layers.closed))
            wide.append(planner.intervals(HALVED_STEP if last - first == 1 else HALVED, spanned))
        if planner.layers.closed and not gaps.ranges:  # motions lead around, but perhaps none returns to where it began
            if max_min_search(begun.layers, epsilon, prefer="first", explain=False, throw=False).connected:
                return planner
            wide.append(planner.intervals(1, np.arange(len(planner.layers.q))))
        intervals = np.unique(np.concatenate(wide))
        if not len(intervals) or planner.layers.count * (1 + len(intervals) / len(planner.layers.q)) > MOST:
            return planner
        notify(0.0, f"positions half-way in {len(intervals)} intervals")
        planner = planner.halved(intervals, notify)


def raise_minimum(
    planner: ToolPathPlanner, epsilon: ArrayLike, notify: Progress, *, start: Array | None = None
) -> tuple[ToolPathPlanner, Searched]:
    """The planner with more positions where joints have to be faster for a larger minimum manipulability, and its search.

    The same one for a tool speed, which the joints may not keep there, and for arms with several parameters.

    A search in which steps may be longer tells where a better motion needs that. Positions are put there, and beside, where
    such a motion may go as well: first where joints have to be up to twice as fast, then faster. This ends when no motion has
    a minimum larger by GAIN, even with the longest steps that positions can be put between, positions did not raise it, or
    the time is needed for timing and checks. A calm motion stays calm.
    """
    begun, found = _search_from(planner, epsilon, notify, start)
    if planner.demand is not None or planner.has_several_parameters or not found.connected:
        return planner, (begun, found)
    in_time = until(begun.improving_until(found), part(notify, 0.0, 0.0))
    step = CALM_SHARE * CALM if begun.is_calm(found) else None
    with suppress(OutOfTimeError):
        while True:
            least = found.minimum + GAIN * abs(found.minimum)
            needed = _pieces_needed(begun.with_pose_step(step), epsilon, least, in_time)
            if not (needed > 1).any() or planner.layers.count * needed.mean() > MOST:
                break
            in_time(0.0, f"positions in {np.count_nonzero(needed > 1)} intervals, where joints have to be faster")
            try:
                divided = planner.with_pose_step(step).divided(needed, in_time)
            except InvalidInputError:  # a pose is out of reach, or no configuration keeps what candidates have to spare there
                break
            raised, higher = _search_from(divided, epsilon, in_time, start)
            if higher.minimum <= least or raised.layers.pose_step != step:  # the search went on without the step
                break
            planner, begun, found = divided, raised, higher
    return planner, (begun, found)


def _search_from(planner: ToolPathPlanner, epsilon: ArrayLike, notify: Progress, start: Array | None) -> Searched:
    """The search from a start (n,) at the first pose; None: from any configuration there."""
    return (planner if start is None else planner.starting_at(start)).search(epsilon, progress=notify)


def _pieces_needed(planner: ToolPathPlanner, epsilon: ArrayLike, least: float, notify: Progress) -> NDArray[np.int64]:
    """Into how many pieces each interval between positions (k,) has to be divided for a minimum manipulability of `least`.

    All 1 where none is possible with the longest steps.
    """
    layers, most = planner.layers.in_one_turn or planner.layers, planner.pieces(HALVED)
    steps = check_epsilon(epsilon, layers.continuous)
    for faster in 2 ** np.arange(1, HALVED + 1):
        reach = steps * np.minimum(faster, most)[:, None]
        reach[:, layers.continuous] = np.minimum(reach[:, layers.continuous], LONGEST)
        q = path_above(layers, step_limits(layers, reach), least, notify)
        if q is not None:
            needed = np.abs(path_steps(q, layers.continuous, closed=layers.closed) / steps).max(axis=1)
            pieces = 2 ** (np.floor(np.log2(np.maximum(needed, 0.5))).astype(np.int64) + 1)
            wide = np.pad(pieces > 1, 1, mode="wrap" if layers.closed else "constant")
            return np.asarray(np.minimum(np.where(wide[:-2] | wide[2:], np.maximum(pieces, 2), pieces), most))
    return np.ones_like(most)


def find_whole(
    planner: ToolPathPlanner, epsilon: ArrayLike, notify: Progress, *, start: Array | None = None
) -> FoundPart | NotConnected:
    """The best motion along all of a path, with as many positions as it needs; see `find_parts`."""
    planner = connect(planner, epsilon, part(notify, 0.0, 0.3), start=start)
    planner, searched = raise_minimum(planner, epsilon, part(notify, 0.3, 0.5), start=start)
    options = _find_parts(planner, epsilon, 0, notify, start, searched)
    return options if isinstance(options, NotConnected) else next(options)[0]


def find_parts(
    planner: ToolPathPlanner,
    epsilon: ArrayLike,
    most: int,
    notify: Progress,
    *,
    connects: bool = True,
    start: Array | None = None,
    stops: Sequence[float] = (),
) -> Iterator[list[FoundPart]] | NotConnected:
    """The fewest parts, with the largest minimum manipulability, or why there are none with so few interruptions.

    As many parts with other edges follow, for where the arm cannot leave the path at the edges of the first. Positions are
    added where the joint path of the first part is loose between those there are.

    Where a constant tool speed is asked for joint paths keep it, if the search finds such; see `ToolPathPlanner.along`. If not
    the path is parted where the speed demands it, as `most` allows: one part after the other, the slowest one first.

    Args:
        planner: of motions along the whole path.
        epsilon: as in `max_min_search`.
        most: maximum number of interruptions.
        notify: called with the share done.
        connects: whether positions are added where no motion through the given ones is continuous.
        start: (n,) at the first pose of the path, where the motion begins. An interrupted motion around a closed path begins
            elsewhere.
        stops: s at which a tool that has the speed has to stop.

    Raises InvalidInputError where the tool speed is not kept; the message names the fastest one, and what limits it where.
    """
    demand = planner.demand
    options = _closely(planner.at_speed(None) if stops else planner, epsilon, most, notify, connects=connects, start=start)
    if demand is None or isinstance(options, NotConnected):
        return options
    keep = partial(_keeping_speed, demand=demand, epsilon=epsilon, most=most, stops=stops, closed=planner.layers.closed)
    found = next(options)
    first = keep(found)
    interruptions = len(first) - (not planner.layers.closed or first[0].planner.layers.closed)
    if interruptions > most:
        raise InvalidInputError("interruptions", most, f"at least {interruptions}, at corners and where no motion leads on")
    slow, unsplit = _slowest(first), _slowest(found)
    if slow is not None:
        if unsplit is not None and unsplit.refined.fastest > slow.refined.fastest:
            slow = unsplit
        with suppress(PlanningError):  # of other limits: found when the whole motion is timed
            demand.timed(slow.refined.path, planner.robot, ends=(slow.s_begin, slow.s_end))
    return chain([first], map(keep, options))


def _keeping_speed(
    parts: list[FoundPart], demand: SpeedDemand, epsilon: ArrayLike, most: int, stops: Sequence[float], *, closed: bool
) -> list[FoundPart]:
    """The same parts, split at stops and where the tool is too slow, with at most `most` interruptions."""
    if stops:
        parts = [piece for each in parts for piece in each.split(stops, demand, epsilon)]
    while (slow := _slowest(parts)) is not None and not slow.planner.deadline.passed:
        interruptions = len(parts) - (not closed or slow.planner.layers.closed)
        pieces = slow.split(at, demand, epsilon) if (at := slow.stops(epsilon, most - interruptions)) else [slow]
        if pieces[0] is slow:
            break
        k = parts.index(slow)
        parts = [*parts[:k], *pieces, *parts[k + 1 :]]
    return parts


def _slowest(parts: list[FoundPart]) -> FoundPart | None:
    """Of the parts on which the tool does not keep its speed the one on which it is slowest; None for none."""
    slow = [each for each in parts if not each.refined.keeps_speed]
    return min(slow, key=lambda each: each.refined.fastest, default=None)


def _closely(
    planner: ToolPathPlanner, epsilon: ArrayLike, most: int, notify: Progress, *, connects: bool, start: Array | None
) -> Iterator[list[FoundPart]] | NotConnected:
    """The fewest parts, with positions added where nothing connects or a joint path is loose between those there are."""
    found: tuple[list[FoundPart], Iterator[list[FoundPart]]] | None = None
    for k in range(CLOSER + 1):
        share = part(notify, 1 - 0.5**k, 1 - 0.5 ** (k + 1))
        try:
            if connects:
                planner = connect(planner, epsilon, part(share, 0.0, 0.2), start=start)
            if connects and not k:
                planner, searched = raise_minimum(planner, epsilon, part(share, 0.2, 0.4), start=start)
            else:
                searched = _search_from(planner, epsilon, part(share, 0.2, 0.4), start)
            options = _find_parts(planner, epsilon, most, part(share, 0.4, 1.0), start, searched)
        except OutOfTimeError:
            if found is None or found[0][0].refined.outside.any():
                raise
            break
        if isinstance(options, NotConnected):
            if found is None:
                return options
            break  # what is loose is left to the check
        found = next(options), options
        count = len(planner.layers.q)
        first = found[0][0]  # what is loose of the others is seen from the configurations in which they begin
        loose = planner.intervals(HALVED_STEP, np.unique((first.first + first.refined.loose) % count))
        if not len(loose) or k == CLOSER:
            break
        if planner.deadline.left < first.refined.ending:
            if first.refined.outside.any():  # it would not pass its check
                raise OutOfTimeError
            break
        if len(first.refined.search.q) != len(first.planner.layers.q):  # for a tool speed, which more positions did not help
            break
        if k:  # halves alone did not help
            outside, steps = first.refined.steps_outside
            planner = planner.with_shorter_steps((first.first + outside) % count, steps)
        try:
            planner = planner.halved(loose, silent)
        except OutOfReachError:  # of poses of the path: no motion follows it
            raise
        except InvalidInputError:  # no configuration keeps what candidates have to spare there
            break
    assert found is not None
    return chain([found[0]], found[1])


def _find_parts(
    planner: ToolPathPlanner, epsilon: ArrayLike, most: int, notify: Progress, start: Array | None, searched: Searched
) -> Iterator[list[FoundPart]] | NotConnected:
    """The same for the positions there are, after the search through them."""
    begun, found = searched
    if found.connected:
        return iter([[FoundPart(s_begin=0.0, s_end=1.0, first=0, planner=begun, found=found, is_held=start is not None)]])
    best = planner.at_any_pace() if planner.layers.closed else begun
    parts = find_gaps(best.layers, epsilon).parts
    if parts is None:
        return NotConnected(search=found, planner=begun, message="no interruption helps")
    interruptions = parts if best.layers.closed else parts - 1
    if interruptions > most:
        times, them = ("1 interruption", "it") if interruptions == 1 else (f"{interruptions} interruptions", "them")
        allowed = f"interruptions={most} does not allow {them}" if most else f"interruptions={interruptions} allows {them}"
        return NotConnected(search=found, planner=begun, message=f"with {times} there is a motion: {allowed}")
    fewest = fewest_interruptions(best.layers, epsilon, progress=part(notify, 0.4, 0.6))
    return (
        [
            _part(best, *ends, epsilon, (k + 1) / len(edges), is_held=k == 0 and best is begun and start is not None)
            for k, ends in enumerate(pairwise(edges))
        ]
        for edges in (fewest.edges, *fewest.others)
    )


def _part(planner: ToolPathPlanner, first: int, last: int, epsilon: ArrayLike, time: float, *, is_held: bool) -> FoundPart:
    """The part from one position to another, improved until a share of the time that is left is over."""
    of_part, s = planner.between(first, last), planner.layers.s
    of_part, found = of_part.search(epsilon)
    of_part = replace(of_part, deadline=Deadline.within(time * planner.deadline.left))
    assert s is not None
    count = len(s)
    return FoundPart(
        s_begin=float(s[first % count]),
        s_end=float(s[last % count]) + last // count - first // count,
        first=first,
        planner=of_part,
        found=found,
        is_held=is_held,
    )


#: Parameters s at which the tool is compared with the path.
S_SAMPLES = np.linspace(0.0, 1.0, 1500)


@dataclass(frozen=True, kw_only=True, eq=False)
class FollowedPart:
    """A part of the path, the joint path along it, and the transit to its beginning; None where the motion begins there."""

    part: FoundPart
    refined: RefinedToolPath
    transit: Transit | None

    def missed(self, kinematics: Kinematics, tolerance: Tolerance) -> str:
        """By how much the joint path misses poses of the path, the given ones among them, in their order; "" for none."""
        path = self.part.planner.path
        s = np.union1d(S_SAMPLES, path.knots)
        return deviation_at(path, s, kinematics.pose(self.refined.path(s)), kinematics.free_motion).excess(tolerance, "path")


@dataclass(frozen=True, kw_only=True, eq=False)
class FollowingMotion:
    """The parts of a motion and, for a closed path, the transit back to the configuration in which the path began.

    Attributes:
        parts: along the path, in their order.
        candidates: the configurations in which the motion can begin after a lead-in.
        back: see above.
    """

    parts: tuple[FollowedPart, ...]
    candidates: tuple[GoalCandidate, ...]
    back: Transit | None = None

    @property
    def status(self) -> Status:
        """Whether the tool leaves the path between."""
        return Status.FOLLOWED if len(self.parts) == 1 and self.back is None else Status.FOLLOWED_IN_PARTS

    def result(self, integral: PathIntegral, scene: Scene, clearance: float) -> PathResult:
        """The figures of its path, compared with those of the path that the search found."""
        transits = [each.transit for each in self.parts] + [self.back]
        pairs: list[tuple[JointPath, JointPath]] = []
        for k, each in enumerate(self.parts):
            if each.transit is not None:
                pairs.append((each.transit.path, each.transit.path))
            control, path = each.refined.seed.control.copy(), each.refined.path
            if k or transits[0] is not None:  # the seed begins and ends where transits and other parts do
                control[0, 0] = path.start
            if k + 1 < len(self.parts) or self.back is not None:
                control[-1, -1] = path.goal
            pairs.append((path, JointPath(breaks=each.refined.seed.breaks, control=control)))
        if self.back is not None:
            pairs.append((self.back.path, self.back.path))
        path, seed = (each[0] if len(each) == 1 else JointPath.joined(each) for each in zip(*pairs, strict=True))
        return make_result(
            path,
            integral,
            cost=integral.cost(path),
            seed=seed,
            seed_cost=integral.cost(seed),
            model=scene.collision_model(integral.kinematics.robot),
            clearance=clearance,
            status=self.status,
        )


@dataclass(frozen=True, kw_only=True, eq=False)
class PartsFailure(Failure):
    """Why parts cannot be joined.

    Attributes:
        message: what is wrong.
        search: the search of the first part.
        candidates: the configurations in which the motion can begin.
        at_cut: whether other edges can help.
    """

    search: SearchResult
    candidates: tuple[GoalCandidate, ...]
    at_cut: bool


@dataclass(frozen=True, kw_only=True, eq=False)
class PartsJoiner:
    """Joins parts of a path, each beginning where the one before ends.

    Attributes:
        start: (n,) where the motion begins; None: where the best motion along the path does.
        hold_start: whether the start is at the first pose of the path.
        closed: whether the motion ends in the configuration in which the path begins.
        way: (3,) by which the tool leaves the path between parts, in its frame [m].
        transits: plans motions between parts.
        notify: called with the share done.
    """

    start: Array | None
    hold_start: bool
    closed: bool
    way: Array
    transits: TransitPlanner
    notify: Progress

    def first_of(self, options: Iterable[list[FoundPart]]) -> FollowingMotion | PartsFailure:
        """The motion along the first of several sets of parts that can be joined."""
        failures: list[PartsFailure] = []
        for tried, parts in enumerate(options):
            made = self._joined(parts, part(self.notify, 1 - 0.5**tried, 1 - 0.5 ** (tried + 1)))
            if isinstance(made, FollowingMotion) or not made.at_cut:
                return made
            failures.append(made)
        first, others = failures[0], len(failures) - 1
        if not others:
            return first
        places = "another place does" if others == 1 else f"{others} other places do"
        return replace(first, message=f"{first.message}; {places} not help either")

    def _joined(self, parts: list[FoundPart], notify: Progress) -> FollowingMotion | PartsFailure:
        """The motion along parts of the path, or why there is none."""
        transits, pieces = self.transits, list[FollowedPart]()
        search = parts[0].found
        candidates: tuple[GoalCandidate, ...] = ()
        least = np.inf
        returns = self.closed and not parts[0].planner.layers.closed
        for k, each in enumerate(parts):
            share = part(notify, k / len(parts), (k + 1) / len(parts))
            begin = pieces[-1].refined.path.goal if pieces else self.start
            # an interrupted motion around a closed path begins where that takes the fewest interruptions
            if begin is None or (not pieces and self.hold_start and not returns):
                pieces.append(FollowedPart(part=each, refined=each.refined, transit=None))
                least = transits.integral.cost(each.refined.path).min_manipulability
                continue
            onwards = self._onwards(each, begin, least) if pieces else None
            if onwards is not None:
                pieces.append(FollowedPart(part=each, refined=onwards, transit=None))
                least = min(least, transits.integral.cost(onwards.path).min_manipulability)
                continue
            plan_transit = transits.between(begin, self.way) if pieces else transits.lead_in(begin)
            where = f"no way on after the interruption at s = {each.s_begin % 1.0:.4f}: " if pieces else ""
            failure = partial(PartsFailure, search=search, at_cut=bool(pieces))
            if isinstance(plan_transit, Failure):
                return failure(message=where + plan_transit.message, candidates=candidates)
            choice = choose_entry(
                each.planner,
                each.found,
                begin,
                transits.integral,
                plan_transit,
                transits.seconds,
                share,
                enough=least,
                steady=each.refined.search.q[0] if each.planner.demand is not None and each.refined.is_for_speed else None,
            )
            if not pieces:
                candidates = choice.candidates
            if choice.entry is None:
                return failure(message=where + choice.failure, candidates=candidates)
            pieces.append(FollowedPart(part=each, refined=choice.entry.refined, transit=choice.entry.lead_in))
            least = min(least, choice.entry.minimum)
        if not returns:
            return FollowingMotion(parts=tuple(pieces), candidates=candidates)
        first = pieces[0].refined.path.start
        if not self.way.any() and np.abs(pieces[-1].refined.path.goal - first).max() < COINCIDENT:
            return FollowingMotion(parts=tuple(pieces), candidates=candidates)
        plan_transit = transits.between(pieces[-1].refined.path.goal, self.way)
        back = plan_transit if isinstance(plan_transit, Failure) else plan_transit(first, transits.seconds, silent)
        if isinstance(back, Failure):
            message = f"no way back to the configuration in which the path began: {back.message}"
            return PartsFailure(message=message, search=search, candidates=candidates, at_cut=True)
        return FollowingMotion(parts=tuple(pieces), candidates=candidates, back=back)

    def _onwards(self, part: FoundPart, begin: Array, least: float) -> RefinedToolPath | None:
        """The motion along a part from a configuration (n,) at its first pose, where the tool has only to stop for its speed.

        None where the tool has to leave the path, and where others have a larger minimum manipulability.
        """
        if self.way.any() or part.planner.demand is None or not part.planner.is_at_start(begin):
            return None
        made = part.planner.starting_at(begin).best(part.found.epsilon, hold_start=True, explain=False)
        if isinstance(made, Failure) or not made.keeps_speed or made.refinement.refined < min(least, part.found.minimum):
            return None
        return made
