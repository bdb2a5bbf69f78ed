"""Courses: the motions of a leg along paths of the tool, from a configuration in which it begins."""

from dataclasses import dataclass, replace

import numpy as np

from manipplan.cost.objective import PathObjective
from manipplan.jobs.following.course import CourseFinder
from manipplan.jobs.following.straight import STRAIGHT_EPSILON, positions_on, straight_on
from manipplan.jobs.programs.legs import Leg
from manipplan.jobs.programs.states import State
from manipplan.jobs.programs.steps import Attach, Detach, MoveAlong, Wait
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import Tolerance, with_defaults
from manipplan.search.candidates.sampling import sample_layers
from manipplan.search.max_min import SearchResult, max_min_search
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError
from manipplan.support.progress import silent
from manipplan.symbolic.task import Task

#: Maximum step of a joint between neighbouring positions of a path [rad or m].
EPSILON = 0.2


@dataclass(frozen=True, kw_only=True, eq=False)
class Motion:
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
class Course:
    """What follows a free motion: the configuration where it ends (n,), the motions and stops, and the last configuration.

    `state` is that afterwards, and `minimum` the smallest manipulability on the motions.
    """

    entry: Array
    items: tuple[Motion | Stop, ...]
    exit: Array
    state: State
    minimum: float


def course_of(
    leg: Leg,
    q: Array,
    state: State,
    objective: PathObjective,
    clearance: float,
    found: tuple[CourseFinder, SearchResult] | None,
) -> Course | str:
    """The course of a leg whose goal is reached at q (n,), or why there is none.

    `found`: for a leg that begins on a path, the finder of its first path, and a motion along it that begins at q.
    """
    items: list[Motion | Stop] = []
    entry = q
    if leg.approach is not None:
        pose = state.robot.kinematics(Task.pose()).pose(q)
        back = straight_on(pose, -leg.approach)
        made = _along(leg.number, MoveAlong(-leg.approach), back, q, state, objective, clearance)
        made = made if isinstance(made, str) else _outside(made) or made
        if isinstance(made, str):
            return f"no straight approach: {made}"
        path = made.path.backwards()
        workspace = CartesianPath.line(back(1.0), pose)
        items.append(replace(made, path=path, workspace_path=workspace))
        entry = path.start
    for number, step in leg.rest:
        if isinstance(step, MoveAlong):
            if found is not None and not items:
                finder, search = found
                made = _motion(number, step, finder, search, state)
            else:
                pose = state.robot.kinematics(Task.pose()).pose(q)
                workspace = step.path if isinstance(step.path, CartesianPath) else straight_on(pose, np.array(step.path))
                made = _along(number, step, workspace, q, state, objective, clearance)
            made = made if isinstance(made, str) else _outside(made) or made
            if isinstance(made, str):
                return f"steps[{number}]: {made}"
            items.append(made)
            q = made.path.goal
            entry = made.path.start if len(items) == 1 else entry
        elif isinstance(step, Attach | Detach):
            items.append(Stop(step=number, q=q, state=state))
            before, state = state, state.after(step, q)
            touching = before.touching(q, clearance) or state.touching(q, clearance)
            if touching:
                return f"steps[{number}]: {touching}"
        elif isinstance(step, Wait):
            items.append(Stop(step=number, q=q, state=state, seconds=step.seconds))
    integral = objective.integral(state.robot)
    least = [integral.cost(each.path).min_manipulability for each in items if isinstance(each, Motion)]
    at_entry = float(integral.kinematics.manipulability(entry))
    return Course(entry=entry, items=tuple(items), exit=q, state=state, minimum=min([at_entry, *least]))


def _outside(motion: Motion) -> str:
    """Which joint of a motion leaves its limits between the positions that were searched; "" where none does."""
    robot = motion.state.robot
    outside = robot.limits.outside(np.array(motion.path.bounds())).max(axis=0)
    joint = int(outside.argmax())
    return f"{robot.joint_names[joint]} is {outside[joint]:.2g} outside its limits" if outside[joint] > 0 else ""


def finder_of(step: MoveAlong, path: CartesianPath, state: State, objective: PathObjective, clearance: float) -> CourseFinder:
    """The finder of motions along a path; raises InvalidInputError for a position that is out of reach or not free."""
    straight = not isinstance(step.path, CartesianPath)
    positions = positions_on(path) if straight else step.positions
    layers = sample_layers(
        state.robot, path, positions, task=step.task, measure=objective.measure, scene=state.scene, clearance=clearance
    )
    return CourseFinder(path=path, layers=layers, tolerance=step.tolerance)


def _along(
    number: int, step: MoveAlong, path: CartesianPath, q: Array, state: State, objective: PathObjective, clearance: float
) -> Motion | str:
    """The best motion along a path that begins at q (n,), or why there is none."""
    try:
        finder = finder_of(step, path, state, objective, clearance).beginning(q)
    except InvalidInputError as error:
        return f"{error.argument} is not {error.allowed}"
    search = max_min_search(finder.layers, EPSILON if isinstance(step.path, CartesianPath) else STRAIGHT_EPSILON, throw=False)
    if not search.connected:
        return search.message
    return _motion(number, step, finder, search, state)


def _motion(number: int, step: MoveAlong, finder: CourseFinder, search: SearchResult, state: State) -> Motion:
    course = finder.along(search, silent, hold_start=True)
    return Motion(
        step=number,
        path=course.path,
        state=state,
        workspace_path=finder.path,
        task=step.task or Task.pose(),
        tolerance=with_defaults(step.tolerance),
        tool_speed=step.tool_speed,
    )
