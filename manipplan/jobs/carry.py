"""carry: two tools of a robot hold an object, such as a tray, and move it along a path."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import permutations
from typing import Any, Literal, overload

import numpy as np

from manipplan.collision.scene import Scene
from manipplan.cost.objective import PathObjective
from manipplan.ik.solver import Solver
from manipplan.jobs.carry_request import Request, held_errors, tool_poses
from manipplan.optimize.result import make_result
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.deviation import deviation_from
from manipplan.paths.joint import JointPath, side_by_side
from manipplan.paths.tolerance import Tolerance
from manipplan.paths.trajectory import Trajectory
from manipplan.plans.report import PlanReport, with_errors
from manipplan.plans.result import PartialPlan, Plan, failed, finish
from manipplan.robots.arms import arm_of, own_joints
from manipplan.robots.attached import without_bodies
from manipplan.robots.robot import Robot
from manipplan.search.layers import SPARE_CLEARANCE, STRIDE
from manipplan.search.sampling import default_samples, sample_layers
from manipplan.seeds.task import CHECK_STEP
from manipplan.support.checks import Array, ArrayLike, flag
from manipplan.support.deadline import Deadline, OutOfTimeError, TimeLimit, until
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.support.progress import Progress, as_callback, interruptible, part
from manipplan.support.status import Failure, Status
from manipplan.support.workers import one_thread
from manipplan.timing.retime import retime
from manipplan.tool_path.engine import MORE_POSITIONS, SPACING, RefinedToolPath, ToolPathPlanner
from manipplan.tool_path.parts import connect

#: Number of times at which the tools are compared with each other and with the path.
TIMES = 4001


@overload
def carry(
    robot: Robot,
    path: CartesianPath,
    grasps: Mapping[str, Any],
    scene: Scene | None = ...,
    *,
    start: ArrayLike | str | None = ...,
    posture: ArrayLike | str | None = ...,
    positions: int | ArrayLike | None = ...,
    objective: PathObjective = ...,
    epsilon: ArrayLike = ...,
    samples: int | Sequence[int] | None = ...,
    tolerance: Tolerance | None = ...,
    clearance: float = ...,
    torque: bool = ...,
    seed: int = ...,
    time_limit: float | None = ...,
    throw: Literal[True] = True,
    progress: Progress | None = ...,
) -> Plan: ...


@overload
def carry(
    robot: Robot,
    path: CartesianPath,
    grasps: Mapping[str, Any],
    scene: Scene | None = ...,
    *,
    start: ArrayLike | str | None = ...,
    posture: ArrayLike | str | None = ...,
    positions: int | ArrayLike | None = ...,
    objective: PathObjective = ...,
    epsilon: ArrayLike = ...,
    samples: int | Sequence[int] | None = ...,
    tolerance: Tolerance | None = ...,
    clearance: float = ...,
    torque: bool = ...,
    seed: int = ...,
    time_limit: float | None = ...,
    throw: bool,
    progress: Progress | None = ...,
) -> Plan | PartialPlan: ...


@interruptible()
@one_thread()
def carry(
    robot: Robot,
    path: CartesianPath,
    grasps: Mapping[str, Any],
    scene: Scene | None = None,
    *,
    start: ArrayLike | str | None = None,
    posture: ArrayLike | str | None = None,
    positions: int | ArrayLike | None = None,
    objective: PathObjective = PathObjective(),
    epsilon: ArrayLike = 0.2,
    samples: int | Sequence[int] | None = None,
    tolerance: Tolerance | None = None,
    clearance: float = 0.0,
    torque: bool = False,
    seed: int = 0,
    time_limit: float | None = None,
    throw: bool = True,
    progress: Progress | None = None,
) -> Plan | PartialPlan:
    """Plan the timed and checked motion of two arms that hold an object, such as a tray, and move it along a path.

    The arms are searched one after the other, each as in `follow`, at positions at which each can move alone. The first one has
    the best motion among all its configurations, the other one among those that are free of the first. Where that fails, the
    other one is first, and then closer positions and finer samples are tried once. The joined motion is timed and checked arm
    against arm. The report gives the largest distance and angle by which the second tool leaves its pose relative to the
    first, by Pinocchio's kinematics.

    Joints that move both tools, such as a torso, stand still.

    Args:
        robot: a robot with several tools. Attach the object to one of them, so that it is checked, too.
        path: of the object in the world; `CartesianPath.line(begin, end)` for two poses.
        grasps: for both tools that hold the object their poses (4, 4), or pin.SE3, in the object's frame.
        scene: obstacles; None: none. The arms are always checked against themselves and each other.
        start: (n,) where the motion begins, with both tools at their grasps of the first pose, or the name of one of
            `robot.states`; None: the motion begins where the best one does.
        posture: (n,) where the joints stand still that do not move along, or the name of a state; default: those of the start,
            or `robot.neutral`.
        positions: number of positions at which configurations are enumerated, or their s (L,) from 0 to 1; None: those of
            `follow`, for the tool whose way is longer.
        objective: as in `follow`; its measure is that of each tool, its task None or Task.pose(length=...).
        epsilon: maximum step of a joint between neighbouring positions [rad or m], one number or (n,).
        samples: number of grid points of each arm's redundancy; None: as in `follow`, and 32 for an arm of seven joints without
            a closed form, such as Baxter's, as each takes a search.
        tolerance: how far the object may leave the path, and the tools their poses relative to each other. Default 0.1 mm and
            1 mrad.
        clearance: distance [m] to keep from obstacles and between the robot's own links. The positions keep 3 mm more.
        torque: keep the joints' effort limits as well; the weight of the object is not known.
        seed: of random starts, for arms without closed-form inverse kinematics.
        time_limit: time [s] for all of it; None: none. Motions are improved while timing and checks are likely to end in time.
            Where no motion passed its checks by then, the status is NOT_IN_TIME. What is built once does not count.
        throw: raise PlanningError if there is no motion; False: return a PartialPlan, or a Plan with Status.CHECK_FAILED.
        progress: called with the fraction done in [0, 1] and a text.

    Raises:
        InvalidInputError: an argument is invalid, or a tool cannot reach a position: the message names the tool.
        UnknownNameError: no tool or state has that name; the nearest names are listed.
        PlanningError: no continuous motion, or none free of the other arm; its `result` is the plan so far.
    """
    request = Request.of(
        robot,
        path,
        grasps,
        scene,
        start=start,
        posture=posture,
        positions=positions,
        objective=objective,
        epsilon=epsilon,
        samples=samples,
        tolerance=tolerance,
        clearance=clearance,
        torque=torque,
        seed=seed,
    )
    flag("throw", throw)
    limit = TimeLimit(time_limit, "sampling positions")
    notify = limit.noting(as_callback(progress))
    held, allowed, integral = request.grasps, request.tolerance, request.integral
    first = request.way(next(iter(held)))
    draft = PartialPlan(robot=robot, scene=request.scene, status=Status.NO_PATH, workspace_path=first, tolerance=allowed)
    try:
        joint, seed_path, ending = _motion_of_both(request, limit.deadline, until(limit.deadline, part(notify, 0.0, 0.9)))
        limit.check_ending(ending)
    except OutOfTimeError:
        return failed(replace(draft, status=Status.NOT_IN_TIME), throw, limit.missed("motion of both arms"))
    except PlanningError as error:
        return failed(draft, throw, str(error))
    result = make_result(
        joint,
        integral,
        cost=integral.cost(joint),
        seed=seed_path,
        seed_cost=integral.cost(seed_path),
        model=request.scene.collision_model(robot),
        clearance=request.clearance,
        status=Status.CARRIED,
    )

    def compare_tools(report: PlanReport, trajectory: Trajectory) -> PlanReport:
        poses = tool_poses(robot, trajectory(np.linspace(0.0, trajectory.duration, TIMES)))
        deviation, errors = deviation_from(first, poses[next(iter(held))]), held_errors(poses, held)
        left = filter(None, (deviation.excess(allowed, "time"), _excess(errors, allowed)))
        faults = (*report.faults, *(f"{each}. {MORE_POSITIONS}" for each in left))
        return replace(report, deviation=deviation, tools=with_errors(report.tools, errors, "held"), faults=faults)

    return finish(
        replace(draft, status=Status.CARRIED, path=joint, result=result),
        lambda: (retime(joint, robot, torque=torque), ()),
        taken=request.taken,
        clearance=request.clearance,
        torque=torque,
        throw=throw,
        notify=notify,
        begins=0.9,
        amend=compare_tools,
    )


def _excess(errors: Mapping[str, tuple[float, float]], allowed: Tolerance) -> str:
    """What is wrong where the tools leave their poses to each other; "" where they keep them."""
    assert allowed.position is not None and allowed.rotation is not None
    for tool, (position, rotation) in errors.items():
        if position > allowed.position or rotation > allowed.rotation:
            return (
                f"{tool} leaves its pose relative to the first tool by {1e3 * position:.3g} mm and {1e3 * rotation:.3g} mrad; "
                f"allowed: {1e3 * allowed.position:.3g} mm and {1e3 * allowed.rotation:.3g} mrad"
            )
    return ""


@dataclass(frozen=True, kw_only=True, eq=False)
class LoneArm:
    """The joints that move one tool alone, and the candidates along the path of this tool, without the other arms.

    Attributes:
        joints: indices of the joints among those of the robot.
        planner: along the path; candidates in collision with what stands still or moves with this tool are left out.
    """

    joints: list[int]
    planner: ToolPathPlanner

    @property
    def tool(self) -> str:
        """The tool frame."""
        assert self.planner.layers.sampler is not None
        return self.planner.layers.sampler.spec.robot.tool

    def best(self, request: Request, deadline: Deadline) -> RefinedToolPath:
        """The best motion through the candidates, improved until a deadline; raises PlanningError where none is continuous."""
        planner = replace(self.planner, deadline=deadline)
        found = planner.best(request.epsilon[self.joints], hold_start=request.start is not None)
        if isinstance(found, Failure):
            raise PlanningError(f"{self.tool}: {found.message}")
        return found


def lone_robot(robot: Robot, tool: str, joints: list[int], posture: Array) -> Robot:
    """The arm of some joints of one tool, with the others locked at `posture` (n,) and without the bodies of other arms."""
    others = {i for i in range(robot.n) if i not in robot.joints_of(tool)}
    away = [item.name for item in robot.geometry.geometryObjects if robot.model.joints[item.parentJoint].idx_q in others]
    arm = arm_of(robot, tool, joints, posture)
    return replace(arm, geometry=without_bodies(arm.geometry, away), source=None)


#: Number of samples of a path among which the nearest bodies are found.
PROXIMITY_SAMPLES = 401
#: How many times as many samples are taken where those of the default do not connect.
FINER = 4


#: The joint path of the whole robot, the same as searched, and the time that timing and checks are likely to take [s].
Carried = tuple[JointPath, JointPath, float]


def _motion_of_both(request: Request, deadline: Deadline, notify: Progress) -> Carried:
    """The motion of both arms; where nothing connects, with closer positions and samples.

    Raises PlanningError with the reason, and InvalidInputError for a position that a tool cannot reach.
    """
    if request.positions is not None and request.samples is not None:
        return _tried(request, deadline, notify, finer=False)
    try:
        return _tried(request, deadline, part(notify, 0.0, 0.5), finer=False)
    except PlanningError as first:
        try:
            return _tried(request, deadline, part(notify, 0.5, 1.0), finer=True)
        except InvalidInputError as error:  # the positions and samples are not the caller's
            raise first from error
        except PlanningError as error:
            if str(error) == str(first):
                raise
            raise PlanningError(f"{first}; with closer positions and finer samples: {error}") from error


def _tried(request: Request, deadline: Deadline, notify: Progress, *, finer: bool) -> Carried:
    """The same with the default positions and samples, or finer ones."""
    s = request.at(STRIDE / 2 if finer else STRIDE)
    arms = _arms(request, s, part(notify, 0.0, 0.5), finer=finer)
    if request.positions is None:
        more = _connecting(request, arms, part(notify, 0.5, 0.6))
        if len(more) > len(s):
            arms = _arms(request, more, part(notify, 0.6, 0.8), finer=finer)
    if request.start is not None:
        arms = [replace(arm, planner=arm.planner.starting_at(request.start[arm.joints])) for arm in arms]
    notify(0.8, "searching for motions of the arms")
    return _motion(request, arms, deadline, part(notify, 0.8, 1.0))


def _connecting(request: Request, arms: Sequence[LoneArm], notify: Progress) -> Array:
    """The positions s (L,) that each of the arms needs for a motion by itself."""
    s = []
    for arm in arms:
        start = None if request.start is None else request.start[arm.joints]
        planner = connect(arm.planner, request.epsilon[arm.joints], notify, start=start)
        assert planner.layers.s is not None
        s.append(planner.layers.s)
    return np.unique(np.concatenate(s))


def _arms(request: Request, s: Array, notify: Progress, *, finer: bool) -> list[LoneArm]:
    """Both arms with all their configurations at positions s (L,)."""
    arms, robot = [], request.robot
    for k, tool in enumerate(request.grasps):
        joints = own_joints(robot, tool)
        lone = lone_robot(robot, tool, joints, request.still)
        try:
            layers = sample_layers(
                lone,
                request.way(tool),
                s,
                measure=request.integral.kinematics.measure.of_one_tool(),
                task=request.integral.kinematics.task,
                samples=request.samples if request.samples is not None else _count(lone) * (FINER if finer else 1),
                scene=request.scene,
                clearance=request.clearance,
                spare=SPARE_CLEARANCE,
                spacing=SPACING,
                seed=request.seed,
                progress=part(notify, k / len(request.grasps), (k + 1) / len(request.grasps)),
            )
        except InvalidInputError as error:
            argument = error.argument if error.argument == "samples" else f"{tool}: {error.argument}"
            raise InvalidInputError(argument, error.value, error.allowed) from error
        planner = ToolPathPlanner(path=request.way(tool), layers=layers.inside(lone.limits), allowed=request.own_tolerance)
        arms.append(LoneArm(joints=joints, planner=planner))
    return arms


def _count(lone: Robot) -> int:
    """Default number of samples per parameter of redundancy."""
    solver = Solver.of(lone, task=None, held=None, method="auto", seed=0)
    counts = default_samples(solver)
    return counts[min(max(len(solver.names), 1), len(counts)) - 1]


def _motion(request: Request, arms: Sequence[LoneArm], deadline: Deadline, notify: Progress) -> Carried:
    """The motion of the first order of the arms that gives one; raises PlanningError with the reasons where none does."""
    reasons = []
    for k, (lead, follow) in enumerate(permutations(arms)):
        notify(k / 2, f"searching for motions of the arms, first of {lead.tool}")
        try:
            return _in_order(request, lead, follow, deadline)
        except PlanningError as error:
            reasons.append(f"{lead.tool} leads: {error}")
    raise PlanningError("; ".join(reasons))


def _in_order(request: Request, lead: LoneArm, follow: LoneArm, deadline: Deadline) -> Carried:
    model, s, still = request.scene.collision_model(request.robot), lead.planner.layers.s, request.still
    assert s is not None
    first = lead.best(request, Deadline.within(deadline.left / 2))
    q = np.tile(still, (len(s), 1))
    q[:, lead.joints] = first.path(s)
    beside = follow.planner.beside(model, follow.joints, q, request.clearance + SPARE_CLEARANCE)
    deadline.check()
    second = replace(follow, planner=beside).best(request, deadline)
    seed = side_by_side([(first.seed, lead.joints), (second.seed, follow.joints)], still)
    for own in (second.path, second.seed):  # what is refined knows nothing of the other arm
        joint = side_by_side([(first.path, lead.joints), (own, follow.joints)], still)
        if model.path_is_free(joint, CHECK_STEP, request.clearance):
            return joint, seed, first.ending + second.ending
    bodies, _ = model.nearest_bodies(joint(np.linspace(0.0, 1.0, PROXIMITY_SAMPLES)))
    raise PlanningError(f"between the positions {bodies}; take more positions")
