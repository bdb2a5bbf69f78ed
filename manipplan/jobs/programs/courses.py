"""Courses: the motions of a leg along paths of the tool, from a configuration in which it begins."""

from dataclasses import dataclass, field, replace

import numpy as np

from manipplan.cost.objective import PathObjective
from manipplan.jobs.following.course import ToolPathPlanner
from manipplan.jobs.following.first_configurations import FirstConfigurations
from manipplan.jobs.following.straight import (
    STRAIGHT_EPSILON,
    motion_from,
    outside_limits,
    straight_finder,
    straight_on,
)
from manipplan.jobs.programs.legs import Leg
from manipplan.jobs.programs.places import rounded
from manipplan.jobs.programs.states import State
from manipplan.jobs.programs.steps import Attach, Detach, MoveAlong, Wait
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import Tolerance, with_defaults
from manipplan.search.candidates.positions import STRIDE, choose_positions
from manipplan.search.candidates.sampling import sample_layers
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError
from manipplan.support.progress import silent
from manipplan.symbolic.free_motion import FreeMotion
from manipplan.symbolic.task import Task

#: Maximum step of a joint between neighbouring positions of a path [rad or m].
EPSILON = 0.2
#: Maximum number of finders that are kept: each may hold a hundred thousand configurations.
KEPT = 32


@dataclass(frozen=True, kw_only=True, eq=False)
class RawMotion:
    """A motion of a program, before it is timed.

    Attributes:
        step: index of its step.
        path: the joint path.
        state: arm and scene during it.
        workspace_path, task, tolerance: the path of the tool that it follows; None for a free motion.
        tool_speed: constant speed of the tool [m/s]; None for no such.
    """

    step: int
    path: JointPath
    state: State
    workspace_path: CartesianPath | None = None
    task: Task | None = None
    tolerance: Tolerance | None = None
    tool_speed: float | None = None


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
class LegFailure:
    """Why there is no course, and whether there is none from any configuration with the tool in the same pose either."""

    message: str
    always: bool = False


@dataclass(kw_only=True, eq=False)
class Finders:
    """The finders of motions along paths of the tool, each kept for all configurations in which a path begins.

    Attributes:
        objective, clearance: of all motions.
    """

    objective: PathObjective
    clearance: float
    kept: dict[tuple[object, ...], ToolPathPlanner | LegFailure] = field(default_factory=dict)

    def along(
        self, number: int, step: MoveAlong, path: CartesianPath, state: State, *, closer: bool = False
    ) -> ToolPathPlanner | LegFailure:
        """The finder of motions along a path of a step in a state, or why a position is out of reach or not free.

        `closer`: with half the distance between positions.
        """
        key = (number, closer, rounded(path(0.0)), state.history)
        if key not in self.kept:
            try:
                made: ToolPathPlanner | LegFailure = self.made(step, path, state, closer=closer)
            except InvalidInputError as error:
                made = LegFailure(message=f"{error.argument} is not {error.allowed}", always=True)
            if len(self.kept) >= KEPT:
                del self.kept[next(iter(self.kept))]
            self.kept[key] = made
        return self.kept[key]

    def made(
        self, step: MoveAlong, path: CartesianPath, state: State, *, closer: bool = False, near: Array | None = None
    ) -> ToolPathPlanner:
        """The same, not kept, with samples near a configuration (n,) if it is given.

        Raises InvalidInputError for a position that is out of reach or not free.
        """
        measure, clearance = self.objective.measure, self.clearance
        if not isinstance(step.path, CartesianPath):
            return straight_finder(
                state.robot, state.scene, path, measure=measure, clearance=clearance, task=step.task, tolerance=step.tolerance
            )
        positions = step.positions
        layers = sample_layers(
            state.robot,
            path,
            choose_positions(path, stride=STRIDE / 2 if closer else STRIDE) if positions is None else positions,
            task=step.task,
            measure=measure,
            scene=state.scene,
            clearance=clearance,
            near=near,
        )
        return ToolPathPlanner(path=path, layers=layers, tolerance=step.tolerance)


def course_of(
    leg: Leg, q: Array, state: State, finders: Finders, found: tuple[FirstConfigurations, int] | None
) -> LegMotion | LegFailure:
    """The course of a leg whose goal is reached at q (n,), or why there is none.

    `found`: for a leg that begins on a path, the configurations in which it can begin, and the index of q among them.
    """
    items: list[RawMotion | Stop] = []
    entry = q
    if leg.approach is not None:
        pose = state.robot.kinematics(Task.pose()).pose(q)
        back = straight_on(pose, -leg.approach)
        made = _along(leg.number, MoveAlong(-leg.approach), back, q, state, finders)
        if isinstance(made, LegFailure):
            return replace(made, message=f"steps[{leg.number}]: no straight approach: {made.message}")
        path = made.path.backwards()
        items.append(replace(made, path=path, workspace_path=CartesianPath.line(back(1.0), pose)))
        entry = path.start
    for number, step in leg.rest:
        if isinstance(step, MoveAlong):
            if found is not None and not items:
                made = _found(number, step, *found, state)
            else:
                pose = state.robot.kinematics(Task.pose()).pose(q)
                workspace = step.path if isinstance(step.path, CartesianPath) else straight_on(pose, np.array(step.path))
                made = _along(number, step, workspace, q, state, finders)
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
            touching = before.touching(q, finders.clearance) or state.touching(q, finders.clearance)
            if touching:
                return LegFailure(message=f"steps[{number}]: {touching}")
        elif isinstance(step, Wait):
            items.append(Stop(step=number, q=q, state=state, seconds=step.seconds))
    integral = finders.objective.integral(state.robot)
    least = [integral.cost(each.path).min_manipulability for each in items if isinstance(each, RawMotion)]
    at_entry = float(integral.kinematics.manipulability(entry))
    return LegMotion(entry=entry, items=tuple(items), exit=q, state=state, minimum=min([at_entry, *least]))


def has_closer(step: MoveAlong) -> bool:
    """Whether closer positions are tried where no motion along a path is found."""
    return isinstance(step.path, CartesianPath) and step.positions is None


def _along(
    number: int, step: MoveAlong, path: CartesianPath, q: Array, state: State, finders: Finders
) -> RawMotion | LegFailure:
    """The best motion along a path that begins at q (n,), or why there is none."""
    epsilon = EPSILON if isinstance(step.path, CartesianPath) else STRAIGHT_EPSILON
    failure = LegFailure(message="")
    for closer in (False, True) if has_closer(step) else (False,):
        finder = finders.along(number, step, path, state, closer=closer)
        if isinstance(finder, LegFailure):
            return finder
        made = motion_from(finder, q, state.robot, epsilon)
        if not isinstance(made, str):
            return _motion(number, step, finder.path, made, state)
        failure = LegFailure(message=made)
        if isinstance(step.path, CartesianPath) and has_several_parameters(finder):
            near = motion_from(finders.made(step, path, state, closer=closer, near=q), q, state.robot, epsilon)
            if not isinstance(near, str):
                return _motion(number, step, finder.path, near, state)
    return failure


def has_several_parameters(finder: ToolPathPlanner) -> bool:
    """Whether a configuration is likely to be no sample, so that samples around it can connect it."""
    return finder.layers.sampler is not None and len(finder.layers.sampler.solver.names) > 1


def _found(number: int, step: MoveAlong, configurations: FirstConfigurations, k: int, state: State) -> RawMotion | LegFailure:
    """The best motion along a path from the k-th of the configurations in which it can begin."""
    path = configurations.finder.along(configurations.motion(k), silent, hold_start=True).path
    outside = outside_limits(path, state.robot)
    return LegFailure(message=outside) if outside else _motion(number, step, configurations.finder.path, path, state)


def _motion(number: int, step: MoveAlong, workspace: CartesianPath, path: JointPath, state: State) -> RawMotion:
    return RawMotion(
        step=number,
        path=path,
        state=state,
        workspace_path=workspace,
        task=step.task or (state.robot.default_task if state.robot.planar else Task.pose()),
        tolerance=with_defaults(step.tolerance),
        tool_speed=step.tool_speed,
    )
