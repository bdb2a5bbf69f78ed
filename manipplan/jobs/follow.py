"""follow: a timed motion along a workspace path."""

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import replace
from typing import Literal, overload

import numpy as np
from numpy.typing import ArrayLike

from manipplan.collision.model import CollisionModel
from manipplan.collision.scene import Scene
from manipplan.cost.floor import floor_of
from manipplan.cost.integral import PathIntegral
from manipplan.cost.metric import metric_matrix
from manipplan.cost.objective import PathObjective, check_measure
from manipplan.jobs.result import PartialPlan, Plan, check_failed, failed, finish
from manipplan.optimize.result import PathResult, make_result
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.deviation import Deviation, deviation_at, deviation_from
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import BETWEEN, Tolerance
from manipplan.robots.robot import Robot
from manipplan.search.layers import Layers
from manipplan.search.max_min import SearchResult, max_min_search
from manipplan.search.refine import Refinement, refine
from manipplan.search.sampling import sample_layers
from manipplan.search.steps import check_epsilon
from manipplan.support.checks import Array, instance, number
from manipplan.support.compiling.native import compile_ahead
from manipplan.support.errors import PlanningError
from manipplan.support.interrupts import interruptible
from manipplan.support.progress import Progress, part, teller
from manipplan.support.status import Status
from manipplan.symbolic.task import Task
from manipplan.timing.retime import check_timing_limits, retime

#: Share of a tolerance that is used at the positions, and between them before knots are added: timing needs some of it, too.
AT_POSITIONS, IN_TUBE = 0.9, 0.97
#: The latter if no tolerance is given.
AT_KNOTS = 0.5
#: Clearance that candidates keep beyond the required one, for the motion between positions [m].
SPARE = 0.003
#: C sources of this job that are compiled while inverse kinematics is, at the first call ever.
SOURCES = ("collision/distances.c", "search/sweep.c", "cost/panels.c", "paths/curves.c", "timing/barrier.c")
#: Number of times at which the tool is compared with the path.
TIMES = 1500


@overload
def follow(
    robot: Robot,
    path: CartesianPath,
    scene: Scene | None = ...,
    *,
    positions: int = ...,
    objective: PathObjective = ...,
    epsilon: ArrayLike = ...,
    samples: int | Sequence[int] | None = ...,
    tolerance: Tolerance | None = ...,
    clearance: float = ...,
    closed: bool = ...,
    torque: bool = ...,
    executor: Executor | None = ...,
    seed: int = ...,
    throw: Literal[True] = True,
    progress: Progress | None = ...,
) -> Plan: ...


@overload
def follow(
    robot: Robot,
    path: CartesianPath,
    scene: Scene | None = ...,
    *,
    positions: int = ...,
    objective: PathObjective = ...,
    epsilon: ArrayLike = ...,
    samples: int | Sequence[int] | None = ...,
    tolerance: Tolerance | None = ...,
    clearance: float = ...,
    closed: bool = ...,
    torque: bool = ...,
    executor: Executor | None = ...,
    seed: int = ...,
    throw: bool,
    progress: Progress | None = ...,
) -> Plan | PartialPlan: ...


@interruptible()
def follow(
    robot: Robot,
    path: CartesianPath,
    scene: Scene | None = None,
    *,
    positions: int = 50,
    objective: PathObjective = PathObjective(),
    epsilon: ArrayLike = 0.2,
    samples: int | Sequence[int] | None = None,
    tolerance: Tolerance | None = None,
    clearance: float = 0.0,
    closed: bool = False,
    torque: bool = False,
    executor: Executor | None = None,
    seed: int = 0,
    throw: bool = True,
    progress: Progress | None = None,
) -> Plan | PartialPlan:
    """Plan the motion along a workspace path with the largest minimum manipulability, timed and checked.

    All configurations at a number of positions are searched for the best continuous path. It is refined between the samples,
    joined by a spline that stays on the workspace path, timed, and checked independently.

    Args:
        robot: the arm.
        path: workspace path of the tool.
        scene: obstacles; None: none. The arm is always checked against itself.
        positions: number of positions at which configurations are enumerated.
        objective: its task, Task.pose() by default or Task.pointing(axis), and its measure define the manipulability whose
            minimum is maximised; power and metric only count in the g that is reported.
        epsilon: maximum step of a joint between neighbouring positions [rad or m], one number or (n,).
        samples: number of grid points of the redundancy; see `sample_layers`.
        tolerance: maximum deviation of the tool from the path. Default: 0.1 mm and 1 mrad between the positions, which are
            met exactly; a tolerance that gives only one of the two has the default for the other.
        clearance: distance [m] to keep from obstacles and between the arm's own links.
        closed: the path returns to its start, and the motion to its first configuration.
        torque: keep the joints' effort limits as well.
        executor: runs the sampling of positions; see `sample_layers`.
        seed: of random starts, for arms without closed-form inverse kinematics.
        throw: raise PlanningError if no motion is found; False: return a PartialPlan, or a Plan with Status.CHECK_FAILED.
        progress: called with the fraction done in [0, 1] and a text.

    Raises:
        InvalidInputError: an argument is invalid, or a position is out of reach (also with throw=False).
        PlanningError: no continuous motion, or none that passes its checks; its `result` is the Plan so far.
    """
    instance("robot", robot, Robot)
    scene = instance("scene", scene if scene is not None else Scene(), Scene)
    instance("objective", objective, PathObjective)
    metric_matrix("metric", objective.metric, robot.n)
    if objective.measure is not None:
        check_measure(robot.kinematics(objective.task or Task.pose(), measure=objective.measure))
    if tolerance is not None:
        instance("tolerance", tolerance, Tolerance)
    for name, value in (("torque", torque), ("throw", throw)):
        instance(name, value, bool)
    tell = teller(progress)
    epsilon = check_epsilon(epsilon, robot.endless)
    clearance = number("clearance", clearance, least=0.0)
    check_timing_limits(robot.limits)
    compile_ahead(*SOURCES)
    layers = sample_layers(
        robot,
        path,
        positions,
        task=objective.task,
        measure=objective.measure,
        samples=samples,
        scene=scene,
        clearance=clearance + SPARE,
        closed=closed,
        executor=executor,
        seed=seed,
        progress=part(tell, 0.0, 0.5),
    )
    allowed = _allowed(tolerance)
    draft = PartialPlan(robot=robot, scene=scene, status=Status.NOT_CONNECTED, workspace_path=path, tolerance=allowed)
    found = max_min_search(layers, epsilon, throw=False, progress=part(tell, 0.5, 0.6))
    draft = replace(draft, search=found)
    if not found.connected:
        return failed(draft, throw, found.message)
    inner = tolerance.scaled(AT_POSITIONS) if tolerance is not None else None
    refined = refine(layers, found, tolerance=inner, progress=part(tell, 0.6, 0.9))
    tell(0.9, "joining the positions")
    world = scene.collision_model(robot)
    joints, result, axis = _joined(path, layers, found, refined, objective, tolerance, world, clearance)
    draft = replace(draft, status=Status.FOLLOWED, refinement=refined, path=joints, result=result)
    tell(0.95, "timing the motion")
    try:
        trajectory = retime(joints, robot, torque=torque)
    except PlanningError as error:
        return failed(replace(draft, status=Status.NO_TIMING), throw, str(error))
    tell(0.97, "checking the result")
    motion = trajectory(np.linspace(0.0, trajectory.duration, TIMES))
    pose, s = robot.kinematics(result.task).pose, np.linspace(0.0, 1.0, TIMES)
    deviation = deviation_from(path, pose(motion), axis)
    draft = replace(draft, deviation=deviation)
    made = finish(
        draft, joints, trajectory, result, world, joints.goal, clearance=clearance, torque=torque, jerk=True, throw=throw
    )
    excess = _excess(deviation, allowed, "time") or _excess(deviation_at(path, s, pose(joints(s)), axis), allowed, "path")
    if excess and made.status is Status.FOLLOWED:
        return check_failed(made, throw, excess)
    tell(1.0, "done")
    return made


def _joined(
    path: CartesianPath,
    layers: Layers,
    found: SearchResult,
    refined: Refinement,
    objective: PathObjective,
    tolerance: Tolerance | None,
    model: CollisionModel,
    clearance: float,
) -> tuple[JointPath, PathResult, Array | None]:
    """The joint path through the refined positions, its figures compared with those of the path that the search found, and
    the tool's axis if only its direction counts.

    With a tolerance the refined positions are joined as they are, as long as their spline stays inside it.
    """
    from manipplan.search.program import PoseRows, joint_path
    from manipplan.search.steps import full_turns

    assert layers.sampler is not None
    assert layers.s is not None
    solver, kinematics = layers.sampler.solver, layers.sampler.kinematics
    rows = PoseRows(kinematics)
    paths = []
    exact = AT_KNOTS * rows.box(BETWEEN)
    wide = exact if tolerance is None else np.maximum(exact, IN_TUBE * rows.box(tolerance))
    tube = tolerance.scaled(AT_POSITIONS / np.sqrt(3)) if tolerance is not None else None  # inside the box of the rows
    for positions, allowed, inside in ((refined.q, wide, tube), (found.q, exact, None)):
        s, q = layers.s, positions
        if layers.closed:
            s, q = np.append(s, 1.0), np.vstack([q, q[0] + full_turns(q, layers.continuous)])  # the way back to the start
        paths.append(joint_path(solver, rows, path, s, q, closed=layers.closed, allowed=allowed, tube=inside))
    metric = metric_matrix("metric", objective.metric, kinematics.robot.n)
    floor = floor_of(kinematics, objective.floor)
    integral = PathIntegral(kinematics=kinematics, power=objective.power, floor=floor, metric=metric)
    result = make_result(
        paths[0],
        integral,
        cost=integral.cost(paths[0]),
        seed=paths[1],
        seed_cost=integral.cost(paths[1]),
        model=model,
        clearance=clearance,
        status=Status.FOLLOWED,
    )
    return paths[0], result, solver.axis


def _allowed(tolerance: Tolerance | None) -> Tolerance:
    """The tolerance, with the default for a missing part."""
    if tolerance is None:
        return BETWEEN
    position = BETWEEN.position if tolerance.position is None else tolerance.position
    return Tolerance(position=position, rotation=BETWEEN.rotation if tolerance.rotation is None else tolerance.rotation)


def _excess(deviation: Deviation, tolerance: Tolerance, of: str) -> str:
    """Message on the part of a tolerance that is exceeded, and after which share `of` what; empty if it is kept."""
    for name, value, limit, unit, at in (
        ("position", deviation.position, tolerance.position, "m", deviation.position_at),
        ("rotation", deviation.rotation, tolerance.rotation, "rad", deviation.rotation_at),
    ):
        if limit is not None and value > limit:
            where = f"the tool's {name} leaves the path by {value:.3g} {unit} after {at:.2f} of the {of}"
            return f"{where}; allowed: {limit:g} {unit}. Take more positions"
    return ""
