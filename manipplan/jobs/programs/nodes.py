"""Nodes: the configurations in which the free motion of a leg may end, with bounds on the manipulability that they allow."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from manipplan.cost.objective import PathObjective
from manipplan.jobs.following.course import CourseFinder
from manipplan.jobs.following.lead_in import best_courses
from manipplan.jobs.goals.candidates import find_candidates
from manipplan.jobs.programs.courses import EPSILON, finder_of
from manipplan.jobs.programs.legs import Leg
from manipplan.jobs.programs.states import State
from manipplan.paths.cartesian import CartesianPath
from manipplan.search.max_min import SearchResult, max_min_search
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError, PlanningError

#: Maximum number of nodes of a leg, the best by their bounds.
MOST_NODES = 48


@dataclass(frozen=True, kw_only=True, eq=False)
class Node:
    """A configuration in which the goal of a leg is reached.

    Attributes:
        q: (n,) [rad or m].
        goal_index: index of the goal in its list.
        bound: no motion through it has a larger minimum manipulability.
        found: for a leg that begins on a path: its finder, and the best motion along the path from q.
    """

    q: Array
    goal_index: int
    bound: float
    found: tuple[CourseFinder, SearchResult] | None = None


def nodes_of(leg: Leg, state: State, start: Array, objective: PathObjective, clearance: float) -> list[Node]:
    """The nodes of a leg, those with the largest bound first, as far as `state` is known before anything is planned.

    Raises InvalidInputError, which names the step, where there is none.
    """
    kinematics = objective.kinematics(state.robot)
    if not leg.is_free:
        return [Node(q=start, goal_index=0, bound=float(kinematics.manipulability(start)))]
    if leg.along is not None:
        return list(_on_path(leg, state, objective, clearance))[:MOST_NODES]
    model = state.scene.collision_model(state.robot)
    nodes = [
        Node(q=each.q, goal_index=k, bound=float(kinematics.manipulability(each.q)))
        for k, each in enumerate(leg.targets)
        if each.q is not None
    ]
    if nodes:
        touching = model.in_collision_rows(np.array([each.q for each in nodes]), clearance=clearance)
        nodes = [node for node, touches in zip(nodes, touching, strict=True) if not touches]
    poses = [(k, each) for k, each in enumerate(leg.targets) if each.pose is not None]
    if poses:
        try:
            found = find_candidates(
                [each for _, each in poses], start, model, objective.integral(state.robot), clearance, leg.constraints
            )
        except InvalidInputError as error:
            if not nodes:
                raise InvalidInputError(f"steps[{leg.number}].goal", error.value, error.allowed) from error
            found = []
        free = [each for each in found if each.is_free]
        nodes += [Node(q=each.q, goal_index=poses[each.goal_index][0], bound=each.manipulability) for each in free]
    if not nodes:
        q = leg.targets[0].q
        assert q is not None
        model.free_configuration(f"steps[{leg.number}].goal", q, clearance)
    nodes.sort(key=lambda each: -each.bound)
    return _different_bounds(nodes)


def _on_path(leg: Leg, state: State, objective: PathObjective, clearance: float) -> Iterator[Node]:
    number, along = leg.rest[0][0], leg.along
    assert along is not None and isinstance(along.path, CartesianPath)
    try:
        finder = finder_of(along, along.path, state, objective, clearance)
    except InvalidInputError as error:
        raise InvalidInputError(f"steps[{number}].path", error.value, error.allowed) from error
    first = max_min_search(finder.layers, EPSILON, throw=False)
    if not first.connected:
        raise PlanningError(f"steps[{number}]: {first.message}{finder.in_the_way(first)}", first)
    for found in best_courses(finder, first):
        yield Node(q=found.q[0], goal_index=0, bound=found.minimum, found=(finder, found))


def _different_bounds(nodes: list[Node]) -> list[Node]:
    """The best nodes of each goal in turn, so that no goal with many configurations displaces all others."""
    kept: list[Node] = []
    for rank in range(len(nodes)):
        for goal in dict.fromkeys(each.goal_index for each in nodes):
            of_goal = [each for each in nodes if each.goal_index == goal]
            kept += of_goal[rank : rank + 1]
        if len(kept) >= MOST_NODES:
            break
    return kept[:MOST_NODES]
