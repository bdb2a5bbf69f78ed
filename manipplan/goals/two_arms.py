"""Configurations that reach a goal of several tools: the solutions of each arm, joined where they are free of each other."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.model import CollisionModel
from manipplan.cost.integral import PathIntegral
from manipplan.goals.goal import PoseGoal
from manipplan.goals.solutions import PoseResidual, beyond_links, first_apart, nearest, reaching
from manipplan.ik.newton import descend
from manipplan.robots.arms import arm_of, own_joints, shared_joints
from manipplan.robots.limits import nearest_turns
from manipplan.robots.model_tree import frame_index
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError
from manipplan.support.memo import once_per_owner
from manipplan.symbolic.task import Task


@dataclass(frozen=True, kw_only=True, eq=False)
class OwnArm:
    """The joints that move one tool alone, as an arm whose other joints are locked at the robot's neutral posture.

    `carrier` is the index in the model of the last joint before those of the arm; 0: the world. `home` is the pose (4, 4) of
    that joint in the neutral posture.
    """

    arm: Robot
    joints: tuple[int, ...]
    carrier: int
    home: Array

    def seen(self, robot: Robot, goal: PoseGoal, q: Array, data: pin.Data) -> PoseGoal:
        """The tool's goal where the arm has to reach with the shared joints at their neutral posture instead of at q (n,)."""
        if self.carrier == 0:
            return goal
        pin.forwardKinematics(robot.model, data, q)
        return replace(goal, pose=self.home @ np.linalg.inv(data.oMi[self.carrier].homogeneous) @ goal.matrix)


@dataclass(frozen=True, kw_only=True, eq=False)
class OfTool:
    """Configurations q (k, n) in which one tool reaches its goal, each with the index `torso` (k,) of its torso posture.

    A torso posture is a set of values of the shared joints.
    """

    q: Array
    torso: NDArray[np.int64]

    def rows(self, rows: NDArray[np.int64] | NDArray[np.bool_]) -> "OfTool":
        """These rows only."""
        return OfTool(q=self.q[rows], torso=self.torso[rows])

    def at(self, torso: int) -> "OfTool":
        """Those of the torso posture with this index."""
        return self.rows(self.torso == torso)


@once_per_owner
def own_arms(robot: Robot) -> Mapping[str, OwnArm]:
    """The arm of each tool without the joints that it shares."""
    shared, data, found = set(shared_joints(robot)), robot.model.createData(), {}
    pin.forwardKinematics(robot.model, data, np.asarray(robot.neutral))
    for tool in robot.tools:
        joints = own_joints(robot, tool)
        joint = robot.model.frames[frame_index(robot.model, tool)].parentJoint
        chain = [int(i) for i in robot.model.supports[joint]]  # the first is the world
        common = [i for i in chain if i == 0 or robot.model.joints[i].idx_q in shared]
        if common != chain[: len(common)]:
            last = robot.model.names[common[-1]]
            wanted = f"a robot whose joints that move several tools come before those of each arm, unlike {last}"
            raise InvalidInputError("robot", robot.name, wanted)
        carrier = common[-1]
        arm = arm_of(robot, tool, joints, robot.neutral)
        found[tool] = OwnArm(arm=arm, joints=tuple(joints), carrier=carrier, home=data.oMi[carrier].homogeneous)
    return found


def solutions(
    robot: Robot, tool: str, goal: PoseGoal, torsos: Array, start: Array, held: NDArray[np.bool_], *, by_steps: bool = False
) -> OfTool:
    """The solutions of a tool's own arm with the shared joints as in each of `torsos` (p, n); others as there.

    They are those of inverse kinematics, nearest to start (n,). With `by_steps`, solutions found by damped steps are added.
    Where joints of the arm are held, only these are returned.
    """
    own = own_arms(robot)[tool]
    joints, near = list(own.joints), start[list(own.joints)]
    data = robot.model.createData()
    goals = [own.seen(robot, goal, each, data) for each in torsos]
    q, torso = np.zeros((0, len(joints))), np.zeros(0, dtype=np.int64)
    if not held[joints].any():
        found = reaching(own.arm, dict(enumerate(goals)), near)
        q, torso = found.q, found.goals
    if by_steps or held[joints].any():
        stepped = [each.reaching for each in nearest(own.arm, goals, near, held[joints])]
        q = np.concatenate([q, *stepped])
        torso = np.concatenate([torso, np.repeat(np.arange(len(torsos)), [len(each) for each in stepped])])
    whole = torsos[torso]
    whole[:, joints] = nearest_turns(own.arm, q, near)
    return OfTool(q=whole, torso=torso)


@dataclass(frozen=True, kw_only=True, eq=False)
class Ranking:
    """Orders configurations by manipulability, of which more than at the start (n,) counts as equal, then by nearness to it."""

    robot: Robot
    start: Array
    integral: PathIntegral

    def whole(self, q: Array) -> NDArray[np.int64]:
        """The order of configurations (k, n), the best first."""
        return self._order(self.integral.kinematics.manipulability(np.vstack([self.start, q])), q)

    def of_tool(self, tool: str, q: Array) -> NDArray[np.int64]:
        """The same by the arm of one tool alone."""
        return self._order(self._figures(tool, np.vstack([self.start, q])), q)

    def torsos(self, torsos: Array, found: Mapping[str, OfTool]) -> NDArray[np.int64]:
        """The order of the torsos (p, n) at which every tool has a solution: the first one first, then the best."""
        least = np.full(len(torsos), np.inf)
        for tool, each in found.items():
            figures, best = self._figures(tool, np.vstack([self.start, each.q])), np.full(len(torsos), -np.inf)
            np.maximum.at(best, each.torso, np.minimum(figures[1:], figures[0]))
            least = np.minimum(least, best)
        order = np.lexsort((np.linalg.norm(torsos - self.start, axis=1), -least.round(12), np.arange(len(torsos)) > 0))
        return np.asarray(order[np.isfinite(least[order])])

    def _figures(self, tool: str, q: Array) -> Array:
        """Manipulability of one arm at q (k, n); zero where that of the robot is not made of those of its arms."""
        kinematics, joints = self.integral.kinematics, list(self.robot.joints_of(tool))
        if not kinematics.measure.over_tools:
            return np.zeros(len(q))
        one = self.robot.arm(tool).kinematics(kinematics.task, measure=kinematics.measure.of_one_tool(), threads=1)
        return one.manipulability(q[:, joints])

    def _order(self, figures: Array, q: Array) -> NDArray[np.int64]:
        """The order of q (k, n) by figures (1 + k,), the first of which is that of the start."""
        capped = np.minimum(figures[1:], figures[0])
        return np.lexsort((np.linalg.norm(q - self.start, axis=1), -capped.round(12)))


#: Number of values of all shared joints together, and at least of each.
GRID, FEWEST = 25, 3
#: The same for two joints and more.
GRID_OF_SEVERAL = 121
#: Number of random starts of damped steps, of values of the grid beside them, and of starts at each of these.
RANDOM, NEAREST, STARTS = 96, 16, 6
#: Size of the miss that counts as none [m], and difference of shared joints, as a share of their range, of equal values.
REACHED, SAME = 1e-9, 0.005


def torso_grid(robot: Robot, start: Array, held: NDArray[np.bool_]) -> Array:
    """Configurations (k, n) like start (n,) but for the shared joints, which are first as there, then on a grid."""
    free = [i for i in shared_joints(robot) if not held[i]]
    if not free:
        return start[None]
    count = GRID if len(free) == 1 else max(FEWEST, round(GRID_OF_SEVERAL ** (1 / len(free))))
    lower, width = _ranges(robot, free)
    values = np.array(list(product(np.linspace(0.0, 1.0, count), repeat=len(free))))
    torsos = np.tile(start, (1 + len(values), 1))
    torsos[1:, free] = np.clip(lower + values * width, robot.limits.lower[free], robot.limits.upper[free])
    return torsos


def meeting(
    robot: Robot,
    goals: Mapping[str, PoseGoal],
    torsos: Array,
    found: Mapping[str, OfTool],
    start: Array,
    held: NDArray[np.bool_],
) -> Array:
    """Configurations (k, n) that reach all goals, by damped steps; no two have the same values of shared joints.

    The steps begin at random, and where the torsos (p, n) with which each tool has solutions are nearest to each other. They
    are sorted by the distance of their shared joints from start (n,).
    """
    shared = shared_joints(robot)
    random = robot.random_configuration(np.random.default_rng(0), size=RANDOM)
    begins = np.vstack([start, robot.neutral, random, *_between(robot, torsos, found)])
    q = _reaching(robot, goals, np.where(held, start, begins), held)
    _, width = _ranges(robot, shared)
    q = q[np.argsort(np.linalg.norm((q - start)[:, shared] / width, axis=1), kind="stable")]
    return q[first_apart(q[:, shared] / width, SAME)]


def _between(robot: Robot, torsos: Array, found: Mapping[str, OfTool]) -> list[Array]:
    """Starts (n,) at the torsos that are nearest to those with which the tools have solutions, each tool at such a solution."""
    shared = shared_joints(robot)
    _, width = _ranges(robot, shared)
    values = torsos[:, shared] / width
    solved = {tool: each for tool, each in found.items() if len(each.q)}
    apart, nearest = np.zeros(len(torsos)), {}
    for tool, each in solved.items():
        own = np.unique(each.torso)
        distances = np.linalg.norm(values[:, None] - values[own], axis=2)
        nearest[tool] = own[distances.argmin(axis=1)]
        apart += distances.min(axis=1)
    starts, rng = [], np.random.default_rng(1)
    for k in np.argsort(apart, kind="stable")[: NEAREST if solved else 0]:
        for _ in range(STARTS):
            q = torsos[k].copy()
            for tool, each in solved.items():
                joints, rows = list(own_arms(robot)[tool].joints), each.at(nearest[tool][k]).q
                q[joints] = rows[rng.integers(len(rows))][joints]
            starts.append(q)
    return starts


def _reaching(robot: Robot, goals: Mapping[str, PoseGoal], q: Array, held: NDArray[np.bool_]) -> Array:
    """Those of the configurations q (k, n) that reach all goals after damped steps, in collision or not."""
    parts = []
    for tool, goal in goals.items():
        kinematics = robot.arm(tool).kinematics(Task.pose(length=1.0), threads=1)
        parts.append((list(robot.joints_of(tool)), PoseResidual.of(kinematics, [goal])))

    def missing(rows: NDArray[np.intp], q: Array) -> tuple[Array, Array]:
        miss, slopes = np.empty((len(rows), 6 * len(parts))), np.zeros((len(rows), 6 * len(parts), robot.n))
        for k, (joints, of_tool) in enumerate(parts):
            own = slice(6 * k, 6 * k + 6)
            miss[:, own], slopes[:, own, joints] = of_tool.slopes(np.zeros_like(rows), np.ascontiguousarray(q[:, joints]))
        return miss, slopes

    q, miss = descend(robot.limits, missing, q, held)
    return np.asarray(q[np.linalg.norm(miss, axis=1) <= REACHED])


def _ranges(robot: Robot, joints: list[int]) -> tuple[Array, Array]:
    """The smallest value of some joints and the width of their ranges (k,): a full turn of those without limits."""
    lower, upper = robot.limits.lower[joints], robot.limits.upper[joints]
    limited = np.isfinite(lower) & np.isfinite(upper)
    return np.where(limited, lower, -np.pi), np.where(limited, np.maximum(upper - lower, 1e-9), 2 * np.pi)


#: Number of torso postures that are tried together, and of configurations that are joined over all of them.
TOGETHER, JOINED = 12, 2400
#: Largest difference of a joint below which two solutions of one arm count as one.
APART = 0.25
#: Number of joined configurations that are kept: free ones, and others where none is free.
FREE_PAIRS, OTHER_PAIRS = 64, 16
#: Distance below which bodies of one arm touch [m].
TOUCHING = 1e-9
#: What to try where no configuration was found.
REMEDY = "Allow a tolerance or a free axis by mp.PoseGoal, or give several goals in a list"


@dataclass(frozen=True, kw_only=True, eq=False)
class Joined:
    """Configurations (k, n) that reach a goal of several tools, perhaps in collision; those that do not, with the reason."""

    q: Array
    rejected: tuple[tuple[Array, str], ...]


@dataclass(frozen=True, kw_only=True, eq=False)
class _Together:
    """Configurations (k, n) with a solution of every arm, all free of collisions or none."""

    q: Array
    is_free: bool


def reaching_tools(
    goals: Mapping[str, PoseGoal],
    start: Array,
    model: CollisionModel,
    integral: PathIntegral,
    clearance: float,
    held: NDArray[np.bool_],
) -> Joined:
    """Configurations that reach the goal of each tool named; the arms of the others stay where they are at `start` (n,).

    Each arm's solutions are those of its own joints. The joints that it shares are at their values of the start and on a grid,
    or, where nothing on the grid is free, where damped steps of all joints lead. Solutions of the arms with the same shared
    values are joined, in the order of `Ranking`.
    """
    robot = model.robot
    far = [(tool, beyond_links(robot, tool, goal)) for tool, goal in goals.items()]
    if any(proof for _, proof in far):
        rejected = tuple((start, f"left out: {tool} is {proof}") for tool, proof in far if proof)
        return Joined(q=np.zeros((0, robot.n)), rejected=rejected)
    ranking = Ranking(robot=robot, start=start, integral=integral)
    by_steps = any(held[list(own_arms(robot)[tool].joints)].any() for tool in goals)
    torsos = start[None] if by_steps else torso_grid(robot, start, held)
    found = {tool: solutions(robot, tool, goal, torsos, start, held) for tool, goal in goals.items()}
    joined = _free_together(model, ranking, torsos, found, clearance)
    if by_steps or not joined.is_free:
        common = torsos[ranking.torsos(torsos, found)[:TOGETHER]]
        moves = not held[shared_joints(robot)].all()
        met = meeting(robot, goals, torsos, found, start, held) if moves else np.zeros((0, robot.n))
        more = _closer(robot, goals, common if moves else start[None], met, start, held)
        closer = _free_together(model, ranking, *more, clearance)
        joined = closer if closer.is_free or not len(joined.q) else joined
    rejected = () if len(joined.q) else tuple(_find_misses(robot, goals, found, start, held))
    return Joined(q=joined.q, rejected=rejected)


def _free_together(
    model: CollisionModel, ranking: Ranking, torsos: Array, found: Mapping[str, OfTool], clearance: float
) -> _Together:
    """Configurations with a solution of each arm for one torso posture: the free ones; if there are none, some in collision."""
    touching = [np.zeros((0, torsos.shape[1]))]
    order = ranking.torsos(torsos, found)
    for begin in range(0, len(order), TOGETHER):
        some = order[begin : begin + TOGETHER]
        sets = {tool: each.rows(np.isin(each.torso, some)) for tool, each in found.items()}
        free = {tool: each.rows(~_touching(model, each.q, tool, clearance)) for tool, each in sets.items()}
        touching += [sets[tool].q[:OTHER_PAIRS] for tool, each in free.items() if not len(each.q)]
        joined = _join(ranking, torsos, some, free)
        is_free = ~model.in_collision_rows(joined, clearance=clearance)
        if is_free.any():
            return _Together(q=joined[is_free][:FREE_PAIRS], is_free=True)
        touching.append(joined[:OTHER_PAIRS])
    return _Together(q=np.concatenate(touching)[:OTHER_PAIRS], is_free=False)


def _closer(
    robot: Robot, goals: Mapping[str, PoseGoal], common: Array, met: Array, start: Array, held: NDArray[np.bool_]
) -> tuple[Array, dict[str, OfTool]]:
    """Places (p, n), which are `common` (c, n) and those of `met` (k, n), and more solutions at them, also by damped steps.

    The configurations `met` reach all goals, and are solutions themselves.
    """
    shared = np.isin(np.arange(robot.n), shared_joints(robot)) & ~held
    torsos, found = np.vstack([common, np.where(shared, met, start)]), {}
    for tool, goal in goals.items():
        own = own_arms(robot)[tool]
        stepped = torsos[len(common) :].copy()
        stepped[:, own.joints] = nearest_turns(own.arm, met[:, own.joints], start[list(own.joints)])
        found[tool] = itself = OfTool(q=stepped, torso=np.arange(len(common), len(torsos)))
        if len(torsos):
            more = solutions(robot, tool, goal, torsos, start, held, by_steps=True)
            found[tool] = OfTool(q=np.vstack([itself.q, more.q]), torso=np.concatenate([itself.torso, more.torso]))
    return torsos, found


def _find_misses(
    robot: Robot, goals: Mapping[str, PoseGoal], found: Mapping[str, OfTool], start: Array, held: NDArray[np.bool_]
) -> Iterator[tuple[Array, str]]:
    """The nearest configuration found of each tool that none brought to its goal; the start where each reaches it alone."""
    alone = True
    for tool, goal in goals.items():
        joints = list(robot.joints_of(tool))
        near = None if len(found[tool].q) else nearest(robot.arm(tool, start), [goal], start[joints], held[joints])[0]
        if near is not None and not len(near.reaching):
            q, alone = start.copy(), False
            q[joints] = near.q
            yield q, f"left out: {tool} may be out of reach: {near.missed}. {REMEDY}"
    if alone:
        names = " and ".join(robot.joint_names[i] for i in shared_joints(robot))
        yield (
            start,
            f"left out: each tool reaches its pose alone, but no value of {names} was found with which all do. {REMEDY}",
        )


def _touching(model: CollisionModel, q: Array, tool: str, clearance: float) -> NDArray[np.bool_]:
    """Whether the arm of one tool touches itself or what stands still, whatever the others do, at q (k, n); (k,)."""
    tree, own = model.robot.tree, set(model.robot.joints_of(tool))
    joints = {joint for joint in range(len(tree.carries)) if own.issuperset(tree.carriers(joint))}
    of_tool = np.array([item.parentJoint in joints for item in model.objects], dtype=bool)
    alone = np.asarray(of_tool[model.pairs].all(axis=1))
    near = model.near_pairs(q, max(clearance, TOUCHING))
    touching = np.zeros(len(q), dtype=bool)
    touching[near.rows[alone[near.pairs] & ~(near.distances > clearance)]] = True
    return touching


def _join(ranking: Ranking, torsos: Array, some: NDArray[np.int64], free: Mapping[str, OfTool]) -> Array:
    """Configurations (k, n) with a solution of each arm at the same one of some torso postures (p, n), the best first."""
    count, found = int((JOINED / len(some)) ** (1 / len(free))), [np.zeros((0, torsos.shape[1]))]
    for torso in some.tolist():
        q = torsos[torso][None]
        for tool, each in free.items():
            own, joints = each.at(torso).q, list(ranking.robot.joints_of(tool))
            own = own[ranking.of_tool(tool, own)]
            own = own[first_apart(own, APART, count)][:, joints]
            q = np.repeat(q, len(own), axis=0)
            q[:, joints] = np.tile(own, (len(q) // max(len(own), 1), 1))
        found.append(q)
    joined = np.concatenate(found)
    return joined[ranking.whole(joined)]
