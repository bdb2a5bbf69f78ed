"""Nodes: the configurations in which the free motion of a leg may end, with bounds on the manipulability that they allow."""

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import zip_longest

import numpy as np

from manipplan.cost.objective import PathObjective
from manipplan.jobs.following.first_configurations import FirstConfigurations
from manipplan.jobs.goals.candidates import find_candidates
from manipplan.jobs.goals.read import Target
from manipplan.jobs.programs.courses import EPSILON, Finders, has_closer
from manipplan.jobs.programs.legs import Leg
from manipplan.jobs.programs.places import NOWHERE, PartPoses, different, rounded
from manipplan.jobs.programs.states import State
from manipplan.paths.cartesian import CartesianPath
from manipplan.search.max_min import max_min_search
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError, PlanningError

#: Maximum number of nodes of a leg, and of one before which parts may be in several places: those with the largest bounds.
MOST_NODES, MOST_OF_PLACES = 48, 192
#: Number of poses of the tool for which configurations are enumerated together.
TOGETHER = 4


@dataclass(frozen=True, kw_only=True, eq=False)
class Node:
    """A configuration in which the goal of a leg is reached.

    Attributes:
        q: (n,) [rad or m].
        goal_index: index of the goal in its list.
        bound: no motion through it has a larger minimum manipulability.
        found: for a leg that begins on a path: the configurations in which it can begin, and the index of this one.
        turned: (t, n) those of them that differ from q by full turns; None for other legs.
        is_given: whether the goal is this configuration, so that its joints may not be turned by full turns.
        before, after: where the parts are before and after its leg, as far as later goals depend on that.
    """

    q: Array
    goal_index: int
    bound: float
    found: tuple[FirstConfigurations, int] | None = None
    turned: Array | None = None
    is_given: bool = False
    before: PartPoses = NOWHERE
    after: PartPoses = NOWHERE


def nodes_of(
    leg: Leg,
    state: State,
    start: Array,
    objective: PathObjective,
    clearance: float,
    places: Sequence[PartPoses],
    needed: set[str],
) -> list[Node]:
    """The nodes of a leg, those with the largest bound first.

    Args:
        state: what is known of arm and scene at the leg before anything is planned.
        places: where parts may be before the leg.
        needed: the parts on which goals of later legs depend.

    Raises InvalidInputError, which names the step, where there is none.
    """
    pose = state.robot.kinematics().pose
    if any(each.pose is not None and each.pose.of for each in leg.targets):
        nodes = _at_targets(leg, state, start, objective, clearance, places)
    else:
        nodes = [replace(node, before=each) for node in _nodes(leg, state, start, objective, clearance) for each in places]
    nodes = _different_bounds(nodes, MOST_NODES if len(places) == 1 else MOST_OF_PLACES)
    return [replace(node, after=node.before.after(leg, pose(node.q)).of(needed)) for node in nodes]


def places_after(nodes: Sequence[Node]) -> list[PartPoses]:
    """Where parts may be after a leg with these nodes."""
    return different([each.after for each in nodes])


def _nodes(leg: Leg, state: State, start: Array, objective: PathObjective, clearance: float) -> list[Node]:
    """The nodes of a leg whose goals do not depend on where parts are."""
    kinematics = objective.kinematics(state.robot)
    if not leg.is_free:
        return [Node(q=start, goal_index=0, bound=float(kinematics.manipulability(start)))]
    if leg.along is not None:
        return list(_on_path(leg, state, Finders(objective=objective, clearance=clearance)))
    return _at_targets(leg, state, start, objective, clearance, [NOWHERE])


def _at_targets(
    leg: Leg, state: State, start: Array, objective: PathObjective, clearance: float, places: Sequence[PartPoses]
) -> list[Node]:
    """Nodes at the goals of a leg, for each of the places where parts may be."""
    kinematics = objective.kinematics(state.robot)
    model = state.scene.collision_model(state.robot)
    nodes = [
        Node(q=each.q, goal_index=k, bound=float(kinematics.manipulability(each.q)), is_given=not each.turns, before=before)
        for k, each in enumerate(leg.targets)
        if each.q is not None
        for before in places
    ]
    if nodes:
        touching = model.in_collision_rows(np.array([each.q for each in nodes]), clearance=clearance)
        nodes = [node for node, touches in zip(nodes, touching, strict=True) if not touches]
    poses, owners = _tool_goals(leg, places)
    integral = objective.integral(state.robot)

    def found(first: int, count: int) -> list[Node]:
        """Nodes at some of the poses, which share samples and refinements."""
        some = poses[first : first + count]
        return [
            Node(q=each.q, goal_index=k, bound=each.manipulability, before=before)
            for each in find_candidates(some, start, model, integral, clearance, leg.constraints)
            if each.is_free
            for k, before in owners[first + each.goal_index]
        ]

    for first in range(0, len(poses), TOGETHER):
        with suppress(InvalidInputError):
            nodes += found(first, TOGETHER)
    if not nodes and poses:
        try:  # the error names the reasons of all goals
            nodes = found(0, len(poses))
        except InvalidInputError as error:
            raise InvalidInputError(f"steps[{leg.number}].goal", error.value, error.allowed) from error
    if not nodes:
        q = leg.targets[0].q
        assert q is not None
        model.free_configuration(f"steps[{leg.number}].goal", q, clearance)
    return nodes


def _tool_goals(leg: Leg, places: Sequence[PartPoses]) -> tuple[list[Target], list[list[tuple[int, PartPoses]]]]:
    """The goals of a leg that are poses as poses of the tool, each once, and for each the goals and places that it stands for.

    Raises InvalidInputError where no place allows any.
    """
    owners: dict[object, tuple[Target, list[tuple[int, PartPoses]]]] = {}
    refused: list[InvalidInputError] = []
    for k, target in enumerate(leg.targets):
        for before in places:
            if target.tools is not None:
                owners.setdefault(k, (target, []))[1].append((k, before))
            if target.pose is None:
                continue
            try:
                made = target.with_grip(before.held[target.pose.of]) if target.pose.of else target
            except InvalidInputError as error:
                refused.append(error)
                continue
            assert made.pose is not None
            axis = () if made.pose.axis is None else tuple(made.pose.axis)
            key = (*rounded(made.pose.matrix), axis, made.pose.tolerance)
            owners.setdefault(key, (made, []))[1].append((k, before))
    if refused and not owners:
        raise refused[0]
    return [each for each, _ in owners.values()], [each for _, each in owners.values()]


def _on_path(leg: Leg, state: State, finders: Finders) -> Iterator[Node]:
    number, along = leg.rest[0][0], leg.along
    assert along is not None and isinstance(along.path, CartesianPath)
    try:
        finder = finders.made(along, along.path, state)
        first = max_min_search(finder.layers, EPSILON, throw=False)
        if not first.connected and has_closer(along):
            finder = finders.made(along, along.path, state, closer=True)
            first = max_min_search(finder.layers, EPSILON, throw=False)
    except InvalidInputError as error:
        raise InvalidInputError(f"steps[{number}].{error.argument}", error.value, error.allowed) from error
    if not first.connected:
        raise PlanningError(f"steps[{number}]: {first.message}{finder.in_the_way(first)}", first)
    configurations = FirstConfigurations(finder=finder, best=first)
    for k in configurations.different(state.robot, MOST_NODES):
        yield Node(
            q=finder.layers.q[0][k],
            goal_index=0,
            bound=float(configurations.minimum[k]),
            found=(configurations, k),
            turned=configurations.turned(state.robot, k),
        )


def _different_bounds(nodes: list[Node], most: int) -> list[Node]:
    """The best nodes of each goal and each of the places before in turn, so that none displaces all others."""
    groups: dict[tuple[object, ...], list[Node]] = {}
    for node in sorted(nodes, key=lambda each: -each.bound):
        groups.setdefault((node.goal_index, node.before.key), []).append(node)
    ranked = [node for row in zip_longest(*groups.values()) for node in row if node is not None]
    return ranked[:most]
