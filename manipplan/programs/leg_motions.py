"""The motions of a leg along paths of the tool, from a configuration in which it begins.

Nodes: the configurations in which the free motion of a leg may end, with bounds on the manipulability that they allow.
"""

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from itertools import zip_longest

import numpy as np

from manipplan.cost.objective import PathObjective
from manipplan.goals.candidates import find_candidates
from manipplan.goals.goal import Target
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import Tolerance, with_defaults
from manipplan.programs.legs import NOWHERE, Leg, PartPoses, State, different, rounded
from manipplan.programs.steps import Attach, Detach, MoveAlong, Wait
from manipplan.search.layers import choose_positions
from manipplan.search.sampling import sample_layers
from manipplan.support.checks import Array
from manipplan.support.deadline import NEVER, Deadline
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.support.status import Failure
from manipplan.symbolic.free_motion import FreeMotion
from manipplan.symbolic.task import Task
from manipplan.timing.constant_speed import STEADY, SpeedDemand
from manipplan.tool_path.engine import SPACING, ToolPathPlanner, outside_limits
from manipplan.tool_path.entry import FirstConfigurations
from manipplan.tool_path.gap import explain_gap
from manipplan.tool_path.parts import NotConnected, connect, find_whole, raise_minimum
from manipplan.tool_path.transit import STRAIGHT_EPSILON, straight_on, straight_planner

#: Maximum step of a joint between neighbouring positions of a path [rad or m].
EPSILON = 0.2
#: Maximum number of planners that are stored: each may hold a hundred thousand configurations.
STORED_PLANNERS = 32


@dataclass(frozen=True, kw_only=True, eq=False)
class RawMotion:
    """A motion of a program, before it is timed.

    Attributes:
        step: index of its step.
        path: the joint path.
        state: arm and scene during it.
        workspace_path, task, tolerance: the path of the tool that it follows; None for a free motion.
        tool_speed: constant speed of the tool [m/s]; None for no such.
        slowdown: share by which the tool may be slower than that.
    """

    step: int
    path: JointPath
    state: State
    workspace_path: CartesianPath | None = None
    task: Task | None = None
    tolerance: Tolerance | None = None
    tool_speed: float | None = None
    slowdown: float = STEADY


@dataclass(frozen=True, kw_only=True, eq=False)
class Stop:
    """A step at which the arm stands still.

    Attributes:
        step: index of its step.
        q: (n,) where the arm stands.
        state: arm and scene before it.
        seconds: how long the arm waits [s].
    """

    step: int
    q: Array
    state: State
    seconds: float = 0.0


@dataclass(frozen=True, kw_only=True, eq=False)
class LegMotion:
    """What follows a free motion: the configuration where it ends (n,), the motions and stops, and the last configuration.

    `state` is that afterwards, and `minimum` the smallest manipulability on the motions.
    """

    entry: Array
    items: tuple[RawMotion | Stop, ...]
    exit: Array
    state: State
    minimum: float


@dataclass(frozen=True, kw_only=True, eq=False)
class LegFailure(Failure):
    """Why there is no motion, and whether there is none from any configuration with the tool in the same pose either."""

    always: bool = False


@dataclass(kw_only=True, eq=False)
class ToolPathPlanners:
    """The planners of motions along paths of the tool, each stored for all configurations in which a path begins.

    Attributes:
        objective, clearance: of all motions.
        deadline: after which none is searched.
    """

    objective: PathObjective
    clearance: float
    deadline: Deadline = NEVER
    stored: dict[tuple[object, ...], ToolPathPlanner | LegFailure] = field(default_factory=dict)

    def along(self, number: int, step: MoveAlong, path: CartesianPath, state: State) -> ToolPathPlanner | LegFailure:
        """The planner of motions along a path of a step in a state, or why a position is out of reach or not free."""
        key = (number, rounded(path(0.0)), state.history)
        if key not in self.stored:
            try:
                made: ToolPathPlanner | LegFailure = self.made(step, path, state)
            except InvalidInputError as error:
                made = LegFailure(message=f"{error.argument} is not {error.allowed}", always=True)
            if len(self.stored) >= STORED_PLANNERS:
                del self.stored[next(iter(self.stored))]
            self.stored[key] = made
        return self.stored[key]

    def made(
        self, step: MoveAlong, path: CartesianPath, state: State, *, near: Array | None = None, spacing: float | None = None
    ) -> ToolPathPlanner:
        """The same, not stored, with samples near a configuration (n,) if it is given, and `spacing` as in `sample_layers`.

        Raises InvalidInputError for a position that is out of reach or not free.
        """
        measure, clearance = self.objective.measure, self.clearance
        if not isinstance(step.path, CartesianPath):
            return straight_planner(
                state.robot, state.scene, path, measure=measure, clearance=clearance, task=step.task, tolerance=step.tolerance
            )
        positions = step.positions
        layers = sample_layers(
            state.robot,
            path,
            choose_positions(path) if positions is None else positions,
            task=step.task,
            measure=measure,
            scene=state.scene,
            clearance=clearance,
            spacing=spacing,
            near=near,
            progress=self.check,
        )
        inside, improves_until = layers.inside(state.robot.limits), Deadline.within(self.deadline.left / 2)
        demand = None if step.tool_speed is None else SpeedDemand(speed=step.tool_speed, slowdown=step.slowdown)
        return ToolPathPlanner(path=path, layers=inside, tolerance=step.tolerance, deadline=improves_until).at_speed(demand)

    def check(self, _share: float, _text: str) -> None:
        """Raise OutOfTimeError after the deadline."""
        self.deadline.check()


def motion_of_leg(
    leg: Leg, q: Array, state: State, planners: ToolPathPlanners, found: tuple[FirstConfigurations, int] | None
) -> LegMotion | LegFailure:
    """The motion of a leg whose goal is reached at q (n,), or why there is none.

    `found`: for a leg that begins on a path, the configurations in which it can begin, and the index of q among them.
    """
    items: list[RawMotion | Stop] = []
    entry = q
    if leg.approach is not None:
        pose = state.robot.kinematics(Task.pose()).pose(q)
        back = straight_on(pose, -leg.approach)
        made = _along(leg.number, MoveAlong(-leg.approach), back, q, state, planners)
        if isinstance(made, LegFailure):
            return replace(made, message=f"steps[{leg.number}]: no straight approach: {made.message}")
        path = made.path.backwards()
        items.append(replace(made, path=path, workspace_path=CartesianPath.line(back(1.0), pose)))
        entry = path.start
    for number, step in leg.rest:
        if isinstance(step, MoveAlong):
            if found is not None and not items:
                made = _found(number, step, *found, state, planners)
            else:
                pose = state.robot.kinematics(Task.pose()).pose(q)
                workspace = step.path if isinstance(step.path, CartesianPath) else straight_on(pose, np.array(step.path))
                made = _along(number, step, workspace, q, state, planners)
            if isinstance(made, LegFailure):
                # where the tool is after a path that leaves a motion free depends on the configuration
                tasks = [each.task for each in items if isinstance(each, RawMotion) and each.task is not None]
                turned = any(FreeMotion.of(task, planar=state.robot.planar).names for task in tasks)
                return LegFailure(message=f"steps[{number}]: {made.message}", always=made.always and not turned)
            items.append(made)
            q = made.path.goal
            entry = made.path.start if len(items) == 1 else entry
        elif isinstance(step, Attach | Detach):
            items.append(Stop(step=number, q=q, state=state))
            before, state = state, state.after(step, q)
            touching = before.touching(q, planners.clearance) or state.touching(q, planners.clearance)
            if touching:
                return LegFailure(message=f"steps[{number}]: {touching}")
        elif isinstance(step, Wait):
            items.append(Stop(step=number, q=q, state=state, seconds=step.seconds))
    integral = planners.objective.integral(state.robot)
    least = [integral.cost(each.path).min_manipulability for each in items if isinstance(each, RawMotion)]
    at_entry = float(integral.kinematics.manipulability(entry))
    return LegMotion(entry=entry, items=tuple(items), exit=q, state=state, minimum=min([at_entry, *least]))


def _along(
    number: int, step: MoveAlong, path: CartesianPath, q: Array, state: State, planners: ToolPathPlanners
) -> RawMotion | LegFailure:
    """The best motion along a path that begins at q (n,), or why there is none."""
    planners.deadline.check()
    is_straight = not isinstance(step.path, CartesianPath)
    epsilon = STRAIGHT_EPSILON if is_straight else EPSILON
    planner = planners.along(number, step, path, state)
    if isinstance(planner, LegFailure):
        return planner
    made = planner.best_from(q, epsilon, planners.check)
    if isinstance(made, Failure) and not is_straight and planner.has_several_parameters:
        made = planners.made(step, path, state, near=q).best_from(q, epsilon, planners.check)
    if isinstance(made, Failure) and step.positions is None:
        planner = planner if is_straight else planners.made(step, path, state, near=q, spacing=SPACING)
        made = _connected(planner, q, epsilon, state, planners)
    return _motion(number, step, path, made, state) if isinstance(made, JointPath) else LegFailure(message=made.message)


def _connected(
    planner: ToolPathPlanner, q: Array, epsilon: float, state: State, planners: ToolPathPlanners
) -> JointPath | Failure:
    """The best motion from q (n,) through as many positions as it needs, or why there is none."""
    try:
        whole = find_whole(planner, epsilon, planners.check, start=q)
    except InvalidInputError as error:  # a pose between the positions that is out of reach or not free
        return Failure(message=f"{error.argument} is not {error.allowed}")
    if isinstance(whole, NotConnected):
        return Failure(message=explain_gap(whole.planner, epsilon))
    path = whole.planner.closely_along(whole.found, planners.check, hold_start=True).path
    outside = outside_limits(path, state.robot)
    return Failure(message=outside) if outside else path


def _found(
    number: int, step: MoveAlong, configurations: FirstConfigurations, k: int, state: State, planners: ToolPathPlanners
) -> RawMotion | LegFailure:
    """The best motion along a path from the k-th of the configurations in which it can begin."""
    path = configurations.planner.closely_along(configurations.motion(k), planners.check, hold_start=True).path
    outside = outside_limits(path, state.robot)
    return LegFailure(message=outside) if outside else _motion(number, step, configurations.planner.path, path, state)


def _motion(number: int, step: MoveAlong, workspace: CartesianPath, path: JointPath, state: State) -> RawMotion:
    return RawMotion(
        step=number,
        path=path,
        state=state,
        workspace_path=workspace,
        task=step.task or (state.robot.default_task if state.robot.planar else Task.pose()),
        tolerance=with_defaults(step.tolerance),
        tool_speed=step.tool_speed,
        slowdown=step.slowdown,
    )


#: Maximum number of nodes of a leg, and of one before which parts may have different poses: those with the largest bounds.
MOST_NODES, MOST_OF_POSES = 48, 192
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
    leg: Leg, state: State, start: Array, planners: ToolPathPlanners, part_poses: Sequence[PartPoses], needed: set[str]
) -> list[Node]:
    """The nodes of a leg, those with the largest bound first.

    Args:
        state: what is known of arm and scene at the leg before anything is planned.
        planners: of motions along paths of the tool.
        part_poses: where parts may be before the leg.
        needed: the parts on which goals of later legs depend.

    Raises InvalidInputError, which names the step, where there is none.
    """
    pose = state.robot.kinematics().pose
    if any(each.pose is not None and each.pose.of for each in leg.targets):
        nodes = _at_targets(leg, state, start, planners, part_poses)
    else:
        nodes = [replace(node, before=each) for node in _nodes(leg, state, start, planners) for each in part_poses]
    nodes = _different_bounds(nodes, MOST_NODES if len(part_poses) == 1 else MOST_OF_POSES)
    return [replace(node, after=node.before.after(leg, pose(node.q)).of(needed)) for node in nodes]


def part_poses_after(nodes: Sequence[Node]) -> list[PartPoses]:
    """Where parts may be after a leg with these nodes."""
    return different([each.after for each in nodes])


def _nodes(leg: Leg, state: State, start: Array, planners: ToolPathPlanners) -> list[Node]:
    """The nodes of a leg whose goals do not depend on where parts are."""
    kinematics = planners.objective.kinematics(state.robot)
    if not leg.is_free:
        return [Node(q=start, goal_index=0, bound=float(kinematics.manipulability(start)))]
    if leg.along is not None:
        return list(_on_path(leg, state, planners))
    return _at_targets(leg, state, start, planners, [NOWHERE])


def _at_targets(
    leg: Leg, state: State, start: Array, planners: ToolPathPlanners, part_poses: Sequence[PartPoses]
) -> list[Node]:
    """Nodes at the goals of a leg, for each set of poses that the parts may have."""
    objective, clearance = planners.objective, planners.clearance
    kinematics = objective.kinematics(state.robot)
    model = state.scene.collision_model(state.robot)
    nodes = [
        Node(q=each.q, goal_index=k, bound=float(kinematics.manipulability(each.q)), is_given=not each.turns, before=before)
        for k, each in enumerate(leg.targets)
        if each.q is not None
        for before in part_poses
    ]
    if nodes:
        touching = model.in_collision_rows(np.array([each.q for each in nodes]), clearance=clearance)
        nodes = [node for node, touches in zip(nodes, touching, strict=True) if not touches]
    poses, owners = _tool_goals(leg, part_poses)
    integral = objective.integral(state.robot)

    def found(first: int, count: int) -> list[Node]:
        """Nodes at some of the poses, which share samples and refinements."""
        some = poses[first : first + count]
        return [
            Node(q=each.q, goal_index=k, bound=each.manipulability, before=before)
            for each in find_candidates(some, start, model, integral, clearance, leg.constraints, planners.deadline)
            if each.is_free
            for k, before in owners[first + each.goal_index]
        ]

    for first in range(0, len(poses), TOGETHER):
        planners.deadline.check()
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


def _tool_goals(leg: Leg, part_poses: Sequence[PartPoses]) -> tuple[list[Target], list[list[tuple[int, PartPoses]]]]:
    """The goals of a leg that are poses as poses of the tool, each once, and for each which goals and part poses it stands for.

    Raises InvalidInputError where no poses of the parts allow any.
    """
    owners: dict[object, tuple[Target, list[tuple[int, PartPoses]]]] = {}
    refused: list[InvalidInputError] = []
    for k, target in enumerate(leg.targets):
        for before in part_poses:
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


def _on_path(leg: Leg, state: State, planners: ToolPathPlanners) -> Iterator[Node]:
    number, along = leg.rest[0][0], leg.along
    assert along is not None and isinstance(along.path, CartesianPath)
    try:
        planner = planners.made(along, along.path, state)
        planner, first = planner.search(EPSILON, explain=along.positions is not None)
        if along.positions is None:
            if not first.connected:
                planner = connect(planners.made(along, along.path, state, spacing=SPACING), EPSILON, planners.check)
            _, (planner, first) = raise_minimum(planner, EPSILON, planners.check)
    except InvalidInputError as error:
        raise InvalidInputError(f"steps[{number}].{error.argument}", error.value, error.allowed) from error
    if not first.connected:
        where = first.message if along.positions is not None else explain_gap(planner, EPSILON)
        raise PlanningError(f"steps[{number}]: {where}{planner.in_the_way(first)}", first)
    configurations = FirstConfigurations(planner=planner, best=first)
    for k in configurations.different(state.robot, MOST_NODES):
        yield Node(
            q=planner.layers.q[0][k],
            goal_index=0,
            bound=float(configurations.minimum[k]),
            found=(configurations, k),
            turned=configurations.turned(state.robot, k),
        )


def _different_bounds(nodes: list[Node], most: int) -> list[Node]:
    """The best nodes of each goal and each set of part poses before, in turn, so that none displaces all others."""
    groups: dict[tuple[object, ...], list[Node]] = {}
    for node in sorted(nodes, key=lambda each: -each.bound):
        groups.setdefault((node.goal_index, node.before.key), []).append(node)
    ranked = [node for row in zip_longest(*groups.values()) for node in row if node is not None]
    return ranked[:most]
