"""carry: two tools of a robot hold an object, such as a tray, and move it along a path."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import permutations
from typing import Any, Literal, overload

import numpy as np
import pinocchio as pin

from manipplan.collision.scene import Scene
from manipplan.cost.integral import PathIntegral
from manipplan.cost.objective import PathObjective
from manipplan.goals.goal import PoseGoal, read_configuration
from manipplan.goals.solutions import beyond_links
from manipplan.ik.solver import Solver
from manipplan.optimize.result import make_result
from manipplan.paths.cartesian import CartesianPath, Offset
from manipplan.paths.deviation import angles_between, deviation_from
from manipplan.paths.joint import JointPath, side_by_side
from manipplan.paths.tolerance import Tolerance, with_defaults
from manipplan.paths.trajectory import Trajectory
from manipplan.plans.report import PlanReport, with_errors
from manipplan.plans.result import PartialPlan, Plan, failed, finish
from manipplan.robots.arms import arm_of, known_tool, own_joints, shared_joints
from manipplan.robots.attached import without_bodies
from manipplan.robots.limits import TakenToLimit, taken_to_limits
from manipplan.robots.model_tree import frame_index
from manipplan.robots.robot import Robot
from manipplan.search.layers import SPARE_CLEARANCE, STRIDE, check_positions, choose_positions
from manipplan.search.sampling import default_samples, sample_layers
from manipplan.search.sweep import check_epsilon
from manipplan.seeds.task import CHECK_STEP
from manipplan.support.checks import Array, ArrayLike, flag, instance, number, pose_matrix, random_seed, whole_number
from manipplan.support.deadline import Deadline, OutOfTimeError, TimeLimit, until
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.support.memo import once_per_owner
from manipplan.support.progress import Progress, as_callback, interruptible, part
from manipplan.support.status import Failure, Status
from manipplan.support.workers import one_thread
from manipplan.symbolic.task import Task
from manipplan.timing.retime import check_timing_limits, retime
from manipplan.tool_path.engine import MORE_POSITIONS, SPACING, RefinedToolPath, ToolPathPlanner
from manipplan.tool_path.parts import connect

#: Share of a tolerance that one tool may use on its own path: the errors of two add up, and timing needs some of it.
SHARE = 0.2


def tool_poses(robot: Robot, q: Array) -> dict[str, Array]:
    """The poses (k, 4, 4) of all tools at configurations (k, n), by Pinocchio's own kinematics."""
    data, frames = robot.model.createData(), [frame_index(robot.model, tool) for tool in robot.tools]
    found = np.empty((len(frames), len(q), 4, 4))
    for row, each in enumerate(q):
        pin.framesForwardKinematics(robot.model, data, np.asarray(each))
        for k, frame in enumerate(frames):
            found[k, row] = data.oMf[frame].homogeneous
    return dict(zip(robot.tools, found, strict=True))


def held_errors(poses: Mapping[str, Array], grasps: Mapping[str, Array]) -> dict[str, tuple[float, float]]:
    """Largest distance [m] and angle [rad] of each further tool from where the grasps have it, seen from the first tool.

    Args:
        poses: (k, 4, 4) of each tool.
        grasps: (4, 4) of each tool in the object.
    """
    first, *others = grasps
    errors = {}
    for tool in others:
        wanted = np.linalg.inv(grasps[first]) @ grasps[tool]
        seen = np.linalg.inv(poses[first]) @ poses[tool]
        position = np.linalg.norm(seen[:, :3, 3] - wanted[:3, 3], axis=1)
        errors[tool] = float(position.max()), float(angles_between(seen[:, :3, :3], wanted[:3, :3], None).max())
    return errors


def tool_tolerance(tolerance: Tolerance, grasps: Mapping[str, Array]) -> Tolerance:
    """The tolerance of each tool on its own path, with which the tools keep theirs to each other.

    An angle of one tool moves the place of another, seen from it, by the angle times their distance.
    """
    assert tolerance.position is not None and tolerance.rotation is not None
    origins = [grasp[:3, 3] for grasp in grasps.values()]
    far = max(float(np.linalg.norm(a - b)) for a in origins for b in origins)
    position = SHARE * tolerance.position
    return Tolerance(position=position, rotation=min(SHARE * tolerance.rotation, position / max(far, 1e-3)))


#: Smallest number of joints with which an arm reaches all poses near one.
LEAST = 6
#: Number of poses of the path whose distance from the arms is looked at.
POSE_SAMPLES = 51


@dataclass(frozen=True, kw_only=True, eq=False)
class Request:
    """What is to be carried, by which tools, and how.

    Attributes:
        robot, scene: with several tools, and the obstacles.
        path: of the object.
        grasps: (4, 4) of both tools in the object.
        start: (n,) where the motion begins; None: where the best one does.
        still: (n,) where the joints are that do not move along.
        taken: the joints of start or posture that were taken to a limit.
        positions: s (L,); None: chosen for a stride.
        integral: of the objective.
        epsilon: (n,) maximum step between positions [rad or m].
        samples: as in `sample_layers`.
        tolerance, own_tolerance: of the object, and of each tool on its own path.
        clearance, torque, seed: as in `carry`.
    """

    robot: Robot
    scene: Scene
    path: CartesianPath
    grasps: Mapping[str, Array]
    start: Array | None
    still: Array
    taken: tuple[TakenToLimit, ...]
    positions: Array | None
    integral: PathIntegral
    epsilon: Array
    samples: int | Sequence[int] | None
    tolerance: Tolerance
    own_tolerance: Tolerance
    clearance: float
    torque: bool
    seed: int

    @classmethod
    def of(
        cls,
        robot: Robot,
        path: CartesianPath,
        grasps: Mapping[str, Any],
        scene: Scene | None,
        *,
        start: ArrayLike | str | None,
        posture: ArrayLike | str | None,
        positions: int | ArrayLike | None,
        objective: PathObjective,
        epsilon: ArrayLike,
        samples: int | Sequence[int] | None,
        tolerance: Tolerance | None,
        clearance: float,
        torque: bool,
        seed: int,
    ) -> "Request":
        """The request; raises InvalidInputError, which names the argument."""
        if len(instance("robot", robot, Robot).tools) < 2:
            wanted = (
                "a robot with several tools, such as mp.load_robot('baxter') or mp.Robot.from_urdf(file, tool=(left, right))"
            )
            raise InvalidInputError("robot", f"{robot.name}, with the one tool {robot.tool}", wanted)
        for tool in robot.tools:
            if len(own_joints(robot, tool)) < LEAST:
                wanted = f"arms of at least {LEAST} joints each, besides those that move both, for all poses of the object"
                raise InvalidInputError(
                    "robot", f"{robot.name}: {len(own_joints(robot, tool))} joints move {tool} alone", wanted
                )
        if not isinstance(path, CartesianPath):
            raise InvalidInputError("path", path, "a CartesianPath of the object, such as CartesianPath.line(begin, end)")
        held = _grasps(robot, grasps)
        _check_reach(robot, path, held)
        scene = instance("scene", scene if scene is not None else Scene(), Scene)
        _check_task(instance("objective", objective, PathObjective).task)
        clearance = number("clearance", clearance, least=0.0)
        tolerance = with_defaults(None if tolerance is None else instance("tolerance", tolerance, Tolerance))
        own = tool_tolerance(tolerance, held)
        for each in samples if isinstance(samples, list | tuple) else () if samples is None else (samples,):
            whole_number("samples", each, least=1)
        check_timing_limits(robot.limits)
        still, begin = robot.neutral, None
        taken: tuple[TakenToLimit, ...] = ()
        if start is not None:
            if posture is not None:
                raise InvalidInputError("posture", posture, "None with a start, where the joints that stand still are")
            free = read_configuration("start", start, robot)
            still = begin = scene.collision_model(robot).free_configuration("start", free, clearance)
            taken = taken_to_limits(robot, "start", free)
            _check_start(robot, begin, path, held, own)
        elif posture is not None:
            given = read_configuration("posture", posture, robot)
            still, taken = robot.configuration("posture", given), taken_to_limits(robot, "posture", given)
        return cls(
            robot=robot,
            scene=scene,
            path=path,
            grasps=held,
            start=begin,
            still=still,
            taken=taken,
            positions=None if positions is None else check_positions(positions, closed=False),
            integral=objective.integral(robot),
            epsilon=check_epsilon(epsilon, robot.turns),
            samples=samples,
            tolerance=tolerance,
            own_tolerance=own,
            clearance=clearance,
            torque=flag("torque", torque),
            seed=random_seed("seed", seed),
        )

    def way(self, tool: str) -> Offset:
        """The path of a tool."""
        return Offset(path=self.path, offset=self.grasps[tool])

    def at(self, stride: float) -> Array:
        """The s (L,) of the positions: at most a stride apart on the path of every tool where none were given [m]."""
        if self.positions is not None:
            return self.positions
        return max((choose_positions(self.way(tool), stride=stride) for tool in self.grasps), key=len)


def _grasps(robot: Robot, grasps: Mapping[str, Any]) -> dict[str, Array]:
    """The grasps of both tools as matrices."""
    if not isinstance(grasps, Mapping) or len(grasps) != 2:
        wanted = f"a mapping from two of the tools {', '.join(robot.tools)} to poses in the object's frame"
        raise InvalidInputError("grasps", grasps, wanted)
    return {known_tool(robot, "grasps", tool): pose_matrix(f"grasps[{tool!r}]", pose) for tool, pose in grasps.items()}


def _check_reach(robot: Robot, path: CartesianPath, grasps: Mapping[str, Array]) -> None:
    """Raise InvalidInputError where a pose of the path is farther away from an arm than its links are long."""
    for s in np.linspace(0.0, 1.0, POSE_SAMPLES):
        for tool, grasp in grasps.items():
            proof = beyond_links(robot, tool, PoseGoal(path(s) @ grasp))
            if proof:
                wanted = f"a path on which both tools reach their grasps; at s = {s:.2g} {tool} is {proof}"
                raise InvalidInputError("path", path, wanted)


def _check_task(task: Task | None) -> None:
    """Raise InvalidInputError for a task that lets a tool move against the object."""
    if task is not None and task != Task.pose(length=task.length):
        wanted = "None or mp.Task.pose(length=...): both tools hold the object, and cannot turn or slide on it"
        raise InvalidInputError(
            "objective.task", f"Task.{task.name}" + ("" if task.relative_to is None else ", relative"), wanted
        )


def _check_start(robot: Robot, start: Array, path: CartesianPath, grasps: Mapping[str, Array], own: Tolerance) -> None:
    """Raise InvalidInputError where a tool is not at its grasp of the first pose at the start (n,)."""
    assert own.position is not None and own.rotation is not None
    poses = tool_poses(robot, start[None])
    for tool, grasp in grasps.items():
        wanted, got = path(0.0) @ grasp, poses[tool][0]
        position = float(np.linalg.norm(got[:3, 3] - wanted[:3, 3]))
        rotation = float(angles_between(got[None, :3, :3], wanted[:3, :3], None)[0])
        if position > own.position or rotation > own.rotation:
            found = f"{tool} is {1e3 * position:.3g} mm and {np.rad2deg(rotation):.2g}° from its grasp of the path's first pose"
            needed = f"at most {1e3 * own.position:.2g} mm and {np.rad2deg(own.rotation):.2g}°"
            raise InvalidInputError(
                "start", start.tolist(), f"a configuration that holds the object: {found}; needed: {needed}"
            )


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
        epsilon: maximum step of a joint between neighbouring positions [rad or m], one number or (n,); below π where it turns.
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
    limit = TimeLimit(time_limit, "sampling positions")
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

    def best(self, request: Request, deadline: Deadline, progress: Progress) -> RefinedToolPath:
        """The best motion through the candidates, improved until a deadline; raises PlanningError where none is continuous."""
        planner = replace(self.planner, deadline=deadline)
        found = planner.best(request.epsilon[self.joints], hold_start=request.start is not None, progress=progress)
        if isinstance(found, Failure):
            raise PlanningError(f"{self.tool}: {found.message}")
        return found


def lone_robot(robot: Robot, tool: str, posture: Array) -> Robot:
    """The joints of one tool alone, with those that move both tools locked as in `posture` (n,), without bodies of other arms.

    It is built once where they are locked at the neutral posture.
    """
    held = robot.neutral.copy()
    shared = list(shared_joints(robot))
    held[shared] = posture[shared]
    return _neutral_lone_robot(robot, tool) if (held == robot.neutral).all() else _lone_robot_at(robot, tool, held)


@once_per_owner
def _neutral_lone_robot(robot: Robot, tool: str) -> Robot:
    return _lone_robot_at(robot, tool, robot.neutral)


def _lone_robot_at(robot: Robot, tool: str, held: Array) -> Robot:
    others = {i for i in range(robot.n) if i not in robot.joints_of(tool)}
    away = [item.name for item in robot.geometry.geometryObjects if robot.model.joints[item.parentJoint].idx_q in others]
    arm = arm_of(robot, tool, own_joints(robot, tool), held)
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
        lone = lone_robot(robot, tool, request.still)
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
            return _in_order(request, lead, follow, deadline, part(notify, k / 2, (k + 1) / 2))
        except PlanningError as error:
            reasons.append(f"{lead.tool} leads: {error}")
    raise PlanningError("; ".join(reasons))


def _in_order(request: Request, lead: LoneArm, follow: LoneArm, deadline: Deadline, notify: Progress) -> Carried:
    model, s, still = request.scene.collision_model(request.robot), lead.planner.layers.s, request.still
    assert s is not None
    first = lead.best(request, Deadline.within(deadline.left / 2), part(notify, 0.0, 0.5))
    q = np.tile(still, (len(s), 1))
    q[:, lead.joints] = first.path(s)
    beside = follow.planner.beside(model, follow.joints, q, request.clearance + SPARE_CLEARANCE)
    deadline.check()
    second = replace(follow, planner=beside).best(request, deadline, part(notify, 0.5, 1.0))
    seed = side_by_side([(first.seed, lead.joints), (second.seed, follow.joints)], still)
    for own in (second.path, second.seed):  # what is refined knows nothing of the other arm
        joint = side_by_side([(first.path, lead.joints), (own, follow.joints)], still)
        if model.path_is_free(joint, CHECK_STEP, request.clearance):
            return joint, seed, first.ending + second.ending
    bodies, _ = model.nearest_bodies(joint(np.linspace(0.0, 1.0, PROXIMITY_SAMPLES)))
    raise PlanningError(f"between the positions {bodies}; take more positions")
