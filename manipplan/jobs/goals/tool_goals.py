"""Configurations that reach a goal of several tools: the solutions of each arm, joined where they are free of each other."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from manipplan.collision.model import CollisionModel
from manipplan.cost.integral import PathIntegral
from manipplan.jobs.goals.own_arm import OfTool, own_arms, solutions
from manipplan.jobs.goals.pose_goal import PoseGoal
from manipplan.jobs.goals.ranking import Ranking
from manipplan.jobs.goals.reach import beyond_links, nearest
from manipplan.jobs.goals.torsos import meeting, torso_grid
from manipplan.robots.arms import shared_joints
from manipplan.robots.configuration import nearest_turns
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array

#: Number of places of the shared joints that are looked at together, and of configurations that are joined at all of them.
TOGETHER, JOINED = 12, 2400
#: Largest difference of a joint below which two solutions of one arm count as one.
APART = 0.25
#: Number of joined configurations that are kept: free ones, and others where none is free.
FREE, OTHERS = 64, 16
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
    values are joined, the best first: those whose manipulability is largest, up to that of the start, then the nearest to the
    start.
    """
    robot = model.robot
    far = [(tool, beyond_links(robot, tool, goal)) for tool, goal in goals.items()]
    if any(proof for _, proof in far):
        rejected = tuple((start, f"left out: {tool} is {proof}") for tool, proof in far if proof)
        return Joined(q=np.zeros((0, robot.n)), rejected=rejected)
    ranking = Ranking(robot=robot, start=start, integral=integral)
    by_steps = any(held[list(own_arms(robot)[tool].joints)].any() for tool in goals)
    places = start[None] if by_steps else torso_grid(robot, start, held)
    found = {tool: solutions(robot, tool, goal, places, start, held) for tool, goal in goals.items()}
    joined = _free_together(model, ranking, places, found, clearance)
    if by_steps or not joined.is_free:
        common = places[ranking.places(places, found)[:TOGETHER]]
        moves = not held[shared_joints(robot)].all()
        met = meeting(robot, goals, places, found, start, held) if moves else np.zeros((0, robot.n))
        more = _closer(robot, goals, common if moves else start[None], met, start, held)
        closer = _free_together(model, ranking, *more, clearance)
        joined = closer if closer.is_free or not len(joined.q) else joined
    rejected = () if len(joined.q) else tuple(_missed(robot, goals, found, start, held))
    return Joined(q=joined.q, rejected=rejected)


def _free_together(
    model: CollisionModel, ranking: Ranking, places: Array, found: Mapping[str, OfTool], clearance: float
) -> _Together:
    """Configurations with a solution of each arm at the same place: the free ones; if there are none, some in collision."""
    touching = [np.zeros((0, places.shape[1]))]
    order = ranking.places(places, found)
    for begin in range(0, len(order), TOGETHER):
        some = order[begin : begin + TOGETHER]
        sets = {tool: each.rows(np.isin(each.place, some)) for tool, each in found.items()}
        free = {tool: each.rows(~_touching(model, each.q, tool, clearance)) for tool, each in sets.items()}
        touching += [sets[tool].q[:OTHERS] for tool, each in free.items() if not len(each.q)]
        joined = _joined(ranking, places, some, free)
        is_free = ~model.in_collision_rows(joined, clearance=clearance)
        if is_free.any():
            return _Together(q=joined[is_free][:FREE], is_free=True)
        touching.append(joined[:OTHERS])
    return _Together(q=np.concatenate(touching)[:OTHERS], is_free=False)


def _closer(
    robot: Robot, goals: Mapping[str, PoseGoal], common: Array, met: Array, start: Array, held: NDArray[np.bool_]
) -> tuple[Array, dict[str, OfTool]]:
    """Places (p, n), which are `common` (c, n) and those of `met` (k, n), and more solutions at them, also by damped steps.

    The configurations `met` reach all goals, and are solutions themselves.
    """
    shared = np.isin(np.arange(robot.n), shared_joints(robot)) & ~held
    places, found = np.vstack([common, np.where(shared, met, start)]), {}
    for tool, goal in goals.items():
        own = own_arms(robot)[tool]
        stepped = places[len(common) :].copy()
        stepped[:, own.joints] = nearest_turns(own.arm, met[:, own.joints], start[list(own.joints)])
        itself = OfTool(q=stepped, place=np.arange(len(common), len(places)))
        more = solutions(robot, tool, goal, places, start, held, by_steps=True) if len(places) else itself
        found[tool] = itself.with_more(more)
    return places, found


def _missed(
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


def _joined(ranking: Ranking, places: Array, some: NDArray[np.int64], free: Mapping[str, OfTool]) -> Array:
    """Configurations (k, n) with a solution of each arm at the same one of some places (p, n), the best first."""
    count, found = int((JOINED / len(some)) ** (1 / len(free))), [np.zeros((0, places.shape[1]))]
    for place in some.tolist():
        q = places[place][None]
        for tool, each in free.items():
            own, joints = each.at(place).q, list(ranking.robot.joints_of(tool))
            own = own[_different(own, ranking.of_tool(tool, own), count)][:, joints]
            q = np.repeat(q, len(own), axis=0)
            q[:, joints] = np.tile(own, (len(q) // max(len(own), 1), 1))
        found.append(q)
    joined = np.concatenate(found)
    return joined[ranking.whole(joined)]


def _different(q: Array, order: NDArray[np.int64], count: int) -> list[int]:
    """The first rows of q (k, n) in this order, none near another, at most a number of them."""
    chosen: list[int] = []
    for k in order.tolist():
        if len(chosen) < count and all(np.abs(q[k] - q[j]).max() > APART for j in chosen):
            chosen.append(k)
    return chosen
