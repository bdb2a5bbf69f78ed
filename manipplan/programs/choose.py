"""Chooses the configurations of a whole program: the largest minimum manipulability, and of those that tie the shortest motion.

Each leg has nodes, the configurations in which it reaches its goal. A free motion leads from a node of one leg to a node of
the next. The manipulability at a node, and the minimum that a planned motion keeps, are upper bounds on the minimum
manipulability of each program through them. The search begins with the program whose motions keep most on straight lines, and
goes on with those of larger bounds. It is repeated with what the planned motions keep, until no other program could be better.
"""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from itertools import pairwise

import numpy as np

from manipplan.goals.candidates import straight_lines
from manipplan.goals.goal import Target
from manipplan.goals.solutions import nearest
from manipplan.optimize.result import PathResult
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.joint import JointPath
from manipplan.programs.leg_motions import LegFailure, LegMotion, Node, RawMotion, ToolPathPlanners, motion_of_leg
from manipplan.programs.legs import Leg, State, rounded
from manipplan.programs.steps import MoveAlong
from manipplan.robots.limits import nearest_turns
from manipplan.robots.robot import Robot
from manipplan.support.checks import COINCIDENT, Array
from manipplan.support.deadline import OutOfTimeError, work_time
from manipplan.support.progress import Progress
from manipplan.support.status import Failure

#: Gain in the minimum manipulability below which another program is not tried; bounds that differ by less count as equal.
GAIN = 0.01
#: Maximum number of free motions that are planned, and of failures of motions, per leg.
MOTIONS, FAILURES = 5, 12
#: Largest change of a joint by which a node is moved to reach its goal exactly [rad or m].
NEARBY = 0.05
#: Cost of a motion that is not planned yet, added to g of its straight line.
UNPLANNED = 1e9

#: Shares of the time that a program takes to be found: for timing and checking it; of that left for its free motions.
ENDING, FREE = 0.65, 0.6

#: Plans a free motion of a leg from one configuration (n,) to another, in a state, within a time [s].
Planner = Callable[[Leg, Array, Array, State, float], PathResult | Failure]


@dataclass(frozen=True, kw_only=True, eq=False)
class Chosen:
    """A complete program: for each leg its node, its free motion (None where there is none) and the motion along its paths."""

    nodes: tuple[int, ...]
    free: tuple[PathResult | None, ...]
    along: tuple[LegMotion, ...]

    @property
    def minimum(self) -> float:
        """The smallest manipulability on all its motions."""
        return min(
            *(each.min_manipulability for each in self.free if each is not None),
            *(each.minimum for each in self.along),
            np.inf,
        )


@dataclass(kw_only=True, eq=False)
class ProgramSearch:
    """The search for one program.

    Attributes:
        legs, nodes: the legs, and the nodes of each.
        start: (n,) where the program begins.
        state: arm and scene at the beginning.
        planners: of motions along paths of the tool, with what holds for all motions.
        planner: plans free motions.
        deadline: in `work_time` [s]; after it no further program is tried.
        failures: why free motions or motions along paths failed.
        ending: time that timing and checks of a program are likely to take [s]; 0 before one was found.
    """

    legs: list[Leg]
    nodes: list[list[Node]]
    start: Array
    state: State
    planners: ToolPathPlanners
    planner: Planner
    deadline: float
    failures: list[str] = field(default_factory=list)
    ending: float = 0.0

    def __post_init__(self) -> None:
        self._made_motions: dict[tuple[object, ...], LegMotion | LegFailure] = {}
        self._free: dict[tuple[object, ...], PathResult | Failure] = {}
        self._at = [np.array([each.bound for each in nodes]) for nodes in self.nodes]
        first = Node(q=self.start, goal_index=0, bound=np.inf, after=self.nodes[0][0].before)
        edges = [self._lines(one, other) for one, other in pairwise([[first], *self.nodes])]
        self._between, self._lengths, self._likely = ([each[k] for each in edges] for k in range(3))
        pose = self.state.robot.kinematics().pose
        several = len(self.state.robot.tools) > 1
        keys = [[rounded(each.q if several else pose(each.q)) for each in nodes] for nodes in [[first], *self.nodes]]
        self._tools = [np.array([each.index(key) for key in each]) for each in keys]
        self._planned = [np.zeros(each.shape, dtype=bool) for each in self._between]

    def best(self, notify: Progress) -> Chosen | None:
        """The best program; None where none was found, as `failures` tell.

        Raises OutOfTimeError where the time limit of the job passed before one was found.
        """
        best: Chosen | None = None
        began = work_time()
        while len(self.failures) < FAILURES * len(self.legs):
            nodes, bound = self._chain(None if best is None else best.minimum)
            enough = self.late or len(self._free) >= MOTIONS * len(self.legs)
            if nodes is None or (best is not None and (bound <= best.minimum * (1 + GAIN) or enough)):
                break
            try:
                made = self._made(nodes, -np.inf if best is None else best.minimum * (1 + GAIN), notify)
            except OutOfTimeError:
                if best is None:
                    raise
                break
            if made is not None and best is None:
                self.ending = ENDING * (work_time() - began)
            if made is not None and (best is None or made.minimum > best.minimum * (1 + GAIN)):
                best = made
            elif made is None and self.late:
                break
        return best

    @property
    def late(self) -> bool:
        """Whether the time is over, but for that for timing and checks."""
        return work_time() >= self.deadline or self.planners.deadline.left < self.ending

    @property
    def leads_nowhere(self) -> bool:
        """Whether no motion leads on from the start, which is to begin the first path of the tool."""
        begins_path = any(isinstance(step, MoveAlong) and isinstance(step.path, CartesianPath) for _, step in self.legs[0].rest)
        return not self.legs[0].is_free and begins_path and bool(np.isneginf(self._between[0]).all())

    def _chain(self, reached: float | None) -> tuple[tuple[int, ...] | None, float]:
        """The nodes of a program, and the largest bound of all.

        Without `reached`, the minimum of the best program so far, it is the one that is likely to have the largest minimum, as
        its motions have on straight lines; of those that tie, the one with the smallest g. Otherwise it is one that could be
        better, with a bound in the upper half between both minima: of those the one with the fewest motions that are not
        planned yet.
        """
        bound = self._largest(self._between)
        if bound == -np.inf:
            return None, bound
        edges = self._between
        if reached is None:
            edges = [np.minimum(between, likely) for between, likely in zip(self._between, self._likely, strict=True)]
            most = self._largest(edges)
            least = most * (1 - GAIN) if most > 0 else most
        else:
            least = bound * (1 - GAIN) if bound > 0 else bound
            least = max(min(least, (bound + reached) / 2), np.nextafter(reached * (1 + GAIN), np.inf))
        cost, back = np.zeros(1), []
        for at, edge, lengths, planned in zip(self._at, edges, self._lengths, self._planned, strict=True):
            allowed = (edge >= least) & (at >= least)
            more = lengths if reached is None else lengths + UNPLANNED * ~planned
            total = np.where(allowed, cost[:, None] + more, np.inf)
            back.append(total.argmin(axis=0))
            cost = total.min(axis=0)
        last = int(cost.argmin())
        chain = [last]
        for before in reversed(back[1:]):
            chain.append(int(before[chain[-1]]))
        return tuple(reversed(chain)), bound

    def _largest(self, edges: list[Array]) -> float:
        """The largest of the minima over all chains of nodes, of the figures of their nodes and edges."""
        most = np.full(1, np.inf)
        for at, edge in zip(self._at, edges, strict=True):
            most = np.minimum(np.minimum(most[:, None], edge).max(axis=0), at)
        return float(most.max())

    def _made(self, nodes: tuple[int, ...], least: float, notify: Progress) -> Chosen | None:
        """The program through some nodes; None where a motion fails, or as soon as one keeps no more than `least`.

        The bounds of its nodes and motions are lowered to what they keep.
        """
        q, state, before = self.start, self.state, 0
        free: list[PathResult | None] = []
        along: list[LegMotion] = []
        for k, (leg, node) in enumerate(zip(self.legs, nodes, strict=True)):
            notify(k / len(self.legs), f"step {leg.number}")
            motion = self._motion_of_leg(k, node, state)
            # a part is carried in the same way after all that end with the tool in the same pose
            rows = self._tools[k] == self._tools[k][before] if state.history else np.ones(len(self._tools[k]), dtype=bool)
            if isinstance(motion, LegFailure):
                ends = self._tools[k + 1] if motion.always else np.arange(len(self.nodes[k]))
                self._between[k][np.ix_(rows, ends == ends[node])] = -np.inf
                self.failures.append(motion.message)
                return None
            self._between[k][rows, node] = np.minimum(self._between[k][rows, node], motion.minimum)
            if motion.minimum <= least:
                return None
            if not self.nodes[k][node].is_given:
                motion = _turned(motion, q, state)
            plan = None
            if leg.is_free and np.abs(motion.entry - q).max() >= COINCIDENT:
                made = self._free_motion(k, before, node, q, motion.entry, state)
                self._planned[k][before, node] = True
                minimum = -np.inf if isinstance(made, Failure) else made.min_manipulability
                self._between[k][before, node] = min(self._between[k][before, node], minimum)
                self._likely[k][before, node] = minimum
                if isinstance(made, Failure):
                    self.failures.append(f"steps[{leg.number}]: {made.message}")
                    return None
                if minimum <= least:
                    return None
                plan = made
            free.append(plan)
            along.append(motion)
            q, state, before = motion.exit, motion.state, node
        return Chosen(nodes=nodes, free=tuple(free), along=tuple(along))

    def _motion_of_leg(self, k: int, node: int, state: State) -> LegMotion | LegFailure:
        key = (k, node, state.history)
        if key not in self._made_motions:
            here, leg = self.nodes[k][node], self.legs[k]
            q = here.q if not leg.targets else move_onto(leg.targets[here.goal_index], here.q, state.robot)
            if isinstance(q, Failure):
                self._made_motions[key] = LegFailure(message=f"steps[{leg.number}]: {q.message}")
            else:
                self._made_motions[key] = motion_of_leg(leg, q, state, self.planners, here.found)
        return self._made_motions[key]

    def _free_motion(self, k: int, before: int, node: int, q: Array, entry: Array, state: State) -> PathResult | Failure:
        key = (k, before, node, state.history, q.tobytes(), entry.tobytes())
        if key not in self._free:
            left = self.planners.deadline.left - self.ending
            if not self.ending:  # the motions of the first program share the time
                left *= FREE / sum(each.is_free for each in self.legs[k:])
            if left <= 0:
                raise OutOfTimeError
            self._free[key] = self.planner(self.legs[k], q, entry, state, left)
        return self._free[key]

    def _lines(self, one: list[Node], other: list[Node]) -> tuple[Array, Array, Array]:
        """A bound on m between each of `one` and of `other` (a, b), and g and the smallest m of the straight lines.

        Across singularities the bound is minus their number, so that the search takes few. It is -inf where the parts are
        elsewhere after the one than before the other.
        """
        robot = self.state.robot
        integral = self.planners.objective.integral(robot)
        bounds, lengths = np.full((len(one), len(other)), -np.inf), np.full((len(one), len(other)), np.inf)
        likely = np.zeros((len(one), len(other)))
        ends, keys = np.array([each.q for each in other]), [each.before.key for each in other]
        given = np.array([each.is_given for each in other])
        for k, begin in enumerate(one):
            self.planners.deadline.check()
            after = begin.after.key
            fits = [j for j, key in enumerate(keys) if key == after]
            if fits:
                near = np.where(given[fits, None], ends[fits], nearest_turns(robot, ends[fits], begin.q))
                for row, j in enumerate(fits):
                    turned = other[j].turned
                    if turned is not None:
                        near[row] = turned[np.linalg.norm(turned - begin.q, axis=1).argmin()]
                lines = straight_lines(begin.q, near, integral)
                crossings = np.array([each or 0 for each in lines.crossings])
                bounds[k, fits], lengths[k, fits] = np.where(crossings > 0, -crossings, lines.bound), lines.g
                likely[k, fits] = lines.m.min(axis=1)
        return bounds, lengths, likely


def move_onto(target: Target, q: Array, robot: Robot) -> Array | Failure:
    """The configuration nearest to q (n,) that reaches a goal exactly, or why there is none.

    A part that was taken up at the end of a path is not quite where it was to be: as far off as the path's tolerance.
    """
    missed = target.missed_by(robot, q)
    if not missed:
        return q
    tool = target.of_tool(robot).pose
    if tool is None:
        return Failure(message=missed)
    near = nearest(robot, [tool], q, np.zeros(robot.n, dtype=bool))[0].reaching
    if len(near):
        best = near[np.abs(near - q).max(axis=1).argmin()]
        if np.abs(best - q).max() <= NEARBY:
            return np.asarray(best)
    return Failure(message=missed)


def _turned(motion: LegMotion, q: Array, state: State) -> LegMotion:
    """The motion with its joints turned to the nearest to q (n,) with which all its motions stay inside the limits."""
    robot = state.robot
    bounds = np.array([each.path.bounds() for each in motion.items if isinstance(each, RawMotion)])
    low, high = (motion.entry, motion.entry) if not len(bounds) else (bounds[:, 0].min(axis=0), bounds[:, 1].max(axis=0))
    turn = np.where(robot.turns, 2 * np.pi, np.inf)
    least, most = np.ceil((robot.limits.lower - low) / turn), np.floor((robot.limits.upper - high) / turn)
    turns = np.clip(np.round((q - motion.entry) / turn), np.minimum(least, 0.0), np.maximum(most, 0.0))
    shift = np.where(turns == 0, 0.0, np.where(robot.turns, turn, 0.0) * turns)
    if not shift.any():
        return motion
    items = tuple(
        replace(each, path=JointPath(breaks=each.path.breaks, control=each.path.control + shift))
        if isinstance(each, RawMotion)
        else replace(each, q=each.q + shift)
        for each in motion.items
    )
    return LegMotion(
        entry=motion.entry + shift, items=items, exit=motion.exit + shift, state=motion.state, minimum=motion.minimum
    )
