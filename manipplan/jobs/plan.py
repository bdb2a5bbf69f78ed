"""plan: a motion from start to goal."""

from concurrent.futures import Executor
from dataclasses import replace
from typing import Literal, overload

import numpy as np
from numpy.typing import ArrayLike

from manipplan.collision.scene import Scene
from manipplan.cost.objective import PathObjective
from manipplan.jobs.result import PartialPlan, Plan, failed, finish
from manipplan.optimize.optimize import optimize_from, optimize_path
from manipplan.optimize.result import PathResult
from manipplan.paths.basis import MOST_DEGREE, PathShape
from manipplan.robots.robot import Robot
from manipplan.seeds.seeding import Seeding
from manipplan.support.checks import instance
from manipplan.support.compiling.native import compile_ahead
from manipplan.support.deadline import Deadline
from manipplan.support.errors import PlanningError
from manipplan.support.interrupts import interruptible
from manipplan.support.processes.one_thread import one_thread
from manipplan.support.progress import Progress, part, teller
from manipplan.support.status import Status
from manipplan.timing.retime import check_timing_limits, retime

#: Degrees that are added where a path of the given degree fails, and number of pieces of the cubic B-spline tried after that.
MORE_DEGREES, SPLINE_PIECES = 3, 8
#: Share of the time limit, and at least so much, that is kept for timing and checking the motion [s].
RESERVE, LEAST_RESERVE = 0.05, 0.05
#: C sources of this job that are compiled while it prepares collision shapes and generates code, at the first call ever.
SOURCES = (
    *(
        "collision/distances.c",
        "paths/curves.c",
        "seeds/connect.c",
        "cost/panels.c",
        "collision/look.c",
        "optimize/descents/steps.c",
    ),
    *("collision/body_motion.c", "timing/barrier.c"),
)


@overload
def plan(
    robot: Robot,
    start: ArrayLike,
    goal: ArrayLike,
    scene: Scene | None = ...,
    *,
    objective: PathObjective = ...,
    shape: PathShape = ...,
    seeding: Seeding = ...,
    clearance: float = ...,
    torque: bool = ...,
    executor: Executor | None = ...,
    throw: Literal[True] = True,
    progress: Progress | None = ...,
) -> Plan: ...


@overload
def plan(
    robot: Robot,
    start: ArrayLike,
    goal: ArrayLike,
    scene: Scene | None = ...,
    *,
    objective: PathObjective = ...,
    shape: PathShape = ...,
    seeding: Seeding = ...,
    clearance: float = ...,
    torque: bool = ...,
    executor: Executor | None = ...,
    throw: bool,
    progress: Progress | None = ...,
) -> Plan | PartialPlan: ...


@interruptible()
@one_thread()
def plan(
    robot: Robot,
    start: ArrayLike,
    goal: ArrayLike,
    scene: Scene | None = None,
    *,
    objective: PathObjective = PathObjective(),
    shape: PathShape = PathShape(),
    seeding: Seeding = Seeding(),
    clearance: float = 0.0,
    torque: bool = False,
    executor: Executor | None = None,
    throw: bool = True,
    progress: Progress | None = None,
) -> Plan | PartialPlan:
    """Plan a motion from start to goal: collision-free, far from singularities, timed, and checked when finished.

    A planner finds a first path, and the path optimiser searches for a local optimum of g near it (see `optimize_path`). If no
    path of this `shape` is collision-free with a lower g than the first path, a polynomial of three more degrees is tried, then
    a cubic B-spline of eight pieces, which starts from the fit to the first path. If that fails too, the first path itself is
    timed, and the status says so. A path that is checked but not at its optimum is timed with Status.STOPPED_EARLY.

    The call takes at most `Seeding.time_limit` for each first path, 10 s by default, but for what is built once per machine,
    robot or scene. What was found by then is timed.

    Args:
        robot: the arm.
        start, goal: (n,) inside the limits and collision-free [rad or m].
        scene: obstacles; None: none. The arm is always checked against itself.
        objective: power, task, measure, metric and floor of g = ∫ ‖q'‖_W / (m² + floor²)^(power/2) ds.
        shape: degree, basis, pieces and end derivatives of the path.
        seeding: how first paths are found, or a given one.
        clearance: distance [m] to keep from obstacles and between the arm's own links.
        torque: keep the joints' effort limits as well.
        executor: runs first paths and solves in parallel. Default: one after the other, in this process.
        throw: raise PlanningError if no trajectory is found; False: return a PartialPlan, or a Plan with Status.CHECK_FAILED.
        progress: called with the fraction done in [0, 1] and a text.

    Raises:
        InvalidInputError: an argument is invalid (also with throw=False).
        PlanningError: no collision-free path, or no motion within the limits; its `result` is the Plan so far.
    """
    instance("robot", robot, Robot)
    limit = instance("seeding", seeding, Seeding).time_limit
    reserve = max(RESERVE * limit, min(LEAST_RESERVE, limit / 2))
    deadline = Deadline.within(limit - reserve)
    scene = instance("scene", scene if scene is not None else Scene(), Scene)
    tell = teller(progress)
    check_timing_limits(robot.limits)
    draft = PartialPlan(robot=robot, scene=scene, status=Status.NO_PATH)
    compile_ahead(*SOURCES)
    try:
        result = optimize_path(
            robot,
            start,
            goal,
            scene,
            objective=objective,
            shape=shape,
            seeding=replace(seeding, time_limit=limit - reserve),
            clearance=clearance,
            executor=executor,
            progress=part(tell, 0.0, 0.6),
        )
    except PlanningError as error:
        if not isinstance(error.result, PathResult):
            return failed(draft, throw, str(error))
        result = error.result  # a singular one
    if result.status is Status.INTERRUPTED:
        raise KeyboardInterrupt
    for other in _other_shapes(shape):
        descended = result.certificate is not None and np.isfinite(result.certificate.projected_gradient)
        crosses = not np.isfinite(result.g)  # another degree crosses the same singularity
        if (descended and result.status.ok) or crosses or deadline.passed:
            break
        tell(0.6, f"{other.basis} of degree {other.degree}")
        more = optimize_from(
            robot, result.seed, scene, objective=objective, shape=other, clearance=clearance, deadline=deadline
        )
        if more.status is Status.INTERRUPTED:
            raise KeyboardInterrupt
        result = min(result, more, key=lambda each: (not each.status.ok, each.g))
    path = result.path
    draft = replace(draft, path=path, result=result, status=result.status)
    try:
        tell(0.8, "timing the motion")
        trajectory = retime(path, robot, torque=torque)
    except PlanningError as error:
        return failed(replace(draft, status=Status.NO_TIMING), throw, str(error))
    tell(0.9, "checking the result")
    model = scene.collision_model(robot)
    made = finish(draft, path, trajectory, result, model, path.goal, clearance=clearance, torque=torque, jerk=True, throw=throw)
    tell(1.0, "done")
    return made


def _other_shapes(shape: PathShape) -> tuple[PathShape, ...]:
    """The shapes that are tried in turn where `shape` gives no path, with the same derivatives at start and goal."""
    higher = replace(shape, basis="legendre", degree=min(shape.degree + MORE_DEGREES, MOST_DEGREE), pieces=1)
    return higher, replace(shape, basis="bspline", degree=3, pieces=SPLINE_PIECES)
