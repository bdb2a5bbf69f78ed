"""plan: a motion from start to goal."""

from concurrent.futures import Executor
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from manipplan.collision.scene import Scene
from manipplan.jobs.result import Plan, failed, finish
from manipplan.measures.measure import Measure
from manipplan.optimize.optimize import MOST_DEGREE, optimize_from, optimize_path
from manipplan.optimize.result import PathResult
from manipplan.paths.joint import JointPath
from manipplan.robots.robot import Robot
from manipplan.support.checks import instance
from manipplan.support.errors import PlanningError
from manipplan.support.interrupts import interruptible
from manipplan.support.progress import Progress, part, teller
from manipplan.support.status import Status
from manipplan.symbolic.task import Task
from manipplan.timing.retime import check_timing_limits, retime

#: Number of pieces of the B-spline that is tried if single polynomials fail.
SPLINE_PIECES = 8


@interruptible()
def plan(
    robot: Robot,
    start: ArrayLike,
    goal: ArrayLike,
    scene: Scene | None = None,
    *,
    task: Task | None = None,
    measure: Measure | str | None = None,
    metric: ArrayLike | None = None,
    power: float = 1.0,
    degree: int = 6,
    shifts: str = "none",
    clearance: float = 0.0,
    torque: bool = False,
    seed: int = 0,
    seeds: int = 1,
    time_limit: float = 10.0,
    executor: Executor | None = None,
    throw: bool = True,
    progress: Progress | None = None,
) -> Plan:
    """Plan a motion from start to goal: collision-free, far from singularities, timed, and checked when finished.

    OMPL finds a first path, and the path optimiser searches for a local optimum of g near it (see `optimize_path`). If no
    polynomial of `degree` is collision-free with a lower g than the first path, three more degrees are tried, then a cubic
    B-spline of eight pieces, which starts from the fit to the first path. If that fails too, the first path itself is timed,
    and the status says so. A path that is checked but not at its optimum is timed with Status.STOPPED_EARLY.

    Args:
        robot: the arm.
        start, goal: (n,) inside the limits and collision-free [rad or m].
        scene: obstacles; None: none. The arm is always checked against itself.
        task: task whose manipulability counts; default `robot.default_task`.
        measure: m in g = ∫ ‖q'‖_W / m^power ds, by name or as a Measure; default Yoshikawa's.
        metric: W, the weights of the joints in the length, (n,) or (n, n); default the identity.
        power: exponent of m.
        degree: of the path's polynomial.
        shifts: "within-limits" also tries goals a full turn away in any revolute joint.
        clearance: distance [m] to keep from obstacles and between the arm's own links.
        torque: keep the joints' effort limits as well.
        seed: random seed of the planner; the same seed gives the same plan.
        seeds: number of first paths to search for; see `optimize_path`.
        time_limit: of the planner, per first path [s].
        executor: runs first paths and solves in parallel. Default: one after the other, in this process.
        throw: raise PlanningError if no trajectory is found; False: return a Plan whose status says why.
        progress: called with the fraction done in [0, 1] and a text.

    Raises:
        InvalidInputError: an argument is invalid (also with throw=False).
        PlanningError: no collision-free path, or no motion within the limits; its `result` is the Plan so far.
    """
    instance("robot", robot, Robot)
    scene = instance("scene", scene if scene is not None else Scene(), Scene)
    tell = teller(progress)
    check_timing_limits(robot.limits)
    optimise = partial(
        optimize_path, robot, scene=scene, power=power, task=task, measure=measure, metric=metric, clearance=clearance
    )
    optimise_from = partial(
        optimize_from, robot, scene=scene, power=power, task=task, measure=measure, metric=metric, clearance=clearance
    )
    draft = Plan(robot=robot, scene=scene, status=Status.NO_PATH)
    try:
        result = optimise(
            start,
            goal,
            degree,
            shifts=shifts,
            seed=seed,
            seeds=seeds,
            time_limit=time_limit,
            executor=executor,
            progress=part(tell, 0.0, 0.6),
        )
    except PlanningError as error:
        result = instance("result", error.result, PathResult)  # without a path, or with a singular one
        if result.path is None or result.seed is None:
            return failed(draft, throw, str(error))
    if result.status is Status.INTERRUPTED:
        raise KeyboardInterrupt
    first = instance("seed", result.seed, JointPath)
    for tried, basis, pieces in ((min(degree + 3, MOST_DEGREE), "legendre", 1), (3, "bspline", SPLINE_PIECES)):
        certificate = result.certificate
        descended = certificate is not None and np.isfinite(certificate.projected_gradient)
        if (descended and result.status.ok) or result.status is Status.SINGULAR:  # another degree crosses the same singularity
            break
        tell(0.6, f"{basis} of degree {tried}")
        more = optimise_from(first, degree=tried, basis=basis, pieces=pieces)
        if more.status is Status.INTERRUPTED:
            raise KeyboardInterrupt
        result = min(result, more, key=lambda each: (not each.status.ok, each.g))
    path = instance("path", result.path, JointPath)
    draft = replace(draft, path=path, result=result, status=result.status)
    try:
        tell(0.8, "timing the motion")
        trajectory = retime(path, robot.limits, joint_names=robot.joint_names, torque_model=robot.model if torque else None)
    except PlanningError as error:
        return failed(replace(draft, status=Status.NO_TIMING), throw, str(error))
    tell(0.9, "checking the result")
    model = scene.collision_model(robot)
    made = finish(draft, trajectory, result, model, path.goal, clearance=clearance, torque=torque, jerk=True, throw=throw)
    tell(1.0, "done")
    return made
