"""carry: two tools of a robot hold an object, such as a tray, and move it along a path."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import permutations
from typing import Any, Literal, overload

import numpy as np
from numpy.typing import ArrayLike

from manipplan.collision.scene import Scene
from manipplan.cost.integral import PathIntegral
from manipplan.cost.objective import PathObjective
from manipplan.jobs.carrying.held import held_errors, tool_poses, tool_tolerance
from manipplan.jobs.carrying.lone_arm import LoneArm, lone_robot
from manipplan.jobs.goals.read import named_configuration
from manipplan.jobs.result import PartialPlan, Plan, check_failed, failed, finish
from manipplan.measures.over_tools import OverTools
from manipplan.optimize.result import make_result
from manipplan.paths.cartesian import CartesianPath, Offset
from manipplan.paths.deviation import deviation_from
from manipplan.paths.joint import JointPath, side_by_side
from manipplan.paths.tolerance import Tolerance, with_defaults
from manipplan.robots.arms import known_tool, shared_joints
from manipplan.robots.robot import Robot
from manipplan.search.candidates.sampling import sample_layers
from manipplan.seeds.acceptance import CHECK_STEP
from manipplan.support.checks import Array, instance, number, pose_matrix
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.support.interrupts import interruptible
from manipplan.support.progress import Progress, part, teller
from manipplan.support.status import Status
from manipplan.timing.retime import check_timing_limits, retime

#: Clearance that configurations keep beyond the required one, for the motion between positions [m].
SPARE = 0.003
#: Number of places at which the nearest bodies are looked for.
PLACES = 401
#: Number of times at which the tools are compared with each other and with the path.
TIMES = 4001


@overload
def carry(
    robot: Robot,
    path: CartesianPath,
    grasps: Mapping[str, Any],
    scene: Scene | None = ...,
    *,
    posture: ArrayLike | str | None = ...,
    positions: int = ...,
    objective: PathObjective = ...,
    epsilon: ArrayLike = ...,
    samples: int | Sequence[int] | None = ...,
    tolerance: Tolerance | None = ...,
    clearance: float = ...,
    torque: bool = ...,
    seed: int = ...,
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
    posture: ArrayLike | str | None = ...,
    positions: int = ...,
    objective: PathObjective = ...,
    epsilon: ArrayLike = ...,
    samples: int | Sequence[int] | None = ...,
    tolerance: Tolerance | None = ...,
    clearance: float = ...,
    torque: bool = ...,
    seed: int = ...,
    throw: bool,
    progress: Progress | None = ...,
) -> Plan | PartialPlan: ...


@interruptible()
def carry(
    robot: Robot,
    path: CartesianPath,
    grasps: Mapping[str, Any],
    scene: Scene | None = None,
    *,
    posture: ArrayLike | str | None = None,
    positions: int = 50,
    objective: PathObjective = PathObjective(),
    epsilon: ArrayLike = 0.2,
    samples: int | Sequence[int] | None = None,
    tolerance: Tolerance | None = None,
    clearance: float = 0.0,
    torque: bool = False,
    seed: int = 0,
    throw: bool = True,
    progress: Progress | None = None,
) -> Plan | PartialPlan:
    """Move an object that two tools hold along a path: timed, and checked with both arms together.

    One arm leads: its motion is the best continuous one through all configurations at the positions, as in `follow`. The other
    arm has those of its configurations that are free of the first; where that fails, the other arm leads. The arms are joined
    into one motion, which is checked arm against arm. From Pinocchio's kinematics at many times the report gives the largest
    distance and angle by which the second tool leaves its pose relative to the first.

    Joints that move several tools, such as a torso, stand still.

    Args:
        robot: a robot with several tools. Attach the object to one of them, so that it is checked, too.
        path: of the object in the world; `CartesianPath.line(start, goal)` for two poses.
        grasps: for both tools that hold the object their poses (4, 4), or pin.SE3, in the object's frame.
        scene: obstacles; None: none. The arms are always checked against themselves and each other.
        posture: (n,) where the joints stand still that do not move along; default `robot.neutral`.
        positions, epsilon, samples, seed: as in `follow`.
        objective: as in `follow`; the measure of each tool, whose minimum over the motion is maximised.
        tolerance: how far the object may leave the path, and the tools their poses to each other. Default 0.1 mm and 1 mrad.
        clearance: distance [m] to keep from obstacles and between the robot's own links.
        torque: keep the joints' effort limits as well.
        throw: raise PlanningError if there is no motion; False: return a PartialPlan, or a Plan with Status.CHECK_FAILED.
        progress: called with the fraction done in [0, 1] and a text.

    Raises:
        InvalidInputError: an argument is invalid, or a tool cannot reach a position: the message names the tool.
        UnknownNameError: no tool or state has that name; the nearest names are listed.
        PlanningError: no continuous motion, or none free of the other arms; its `result` is the plan so far.
    """
    instance("robot", robot, Robot)
    if not isinstance(path, CartesianPath):
        raise InvalidInputError("path", path, "a CartesianPath of the object")
    held = _grasps(robot, grasps)
    scene = instance("scene", scene if scene is not None else Scene(), Scene)
    instance("objective", objective, PathObjective)
    still = robot.neutral if posture is None else named_configuration("posture", posture, robot)
    still = robot.configuration("posture", still)
    allowed = with_defaults(None if tolerance is None else instance("tolerance", tolerance, Tolerance))
    clearance = number("clearance", clearance, least=0.0)
    check_timing_limits(robot.limits)
    integral = objective.integral(robot)
    tell = teller(progress)
    first = next(iter(held))
    draft = PartialPlan(
        robot=robot, scene=scene, status=Status.NO_PATH, workspace_path=Offset(path=path, offset=held[first]), tolerance=allowed
    )
    arms = []
    for k, (tool, grasp) in enumerate(held.items()):
        joints = [i for i in robot.joints_of(tool) if i not in shared_joints(robot)]
        way, options = Offset(path=path, offset=grasp), {"samples": samples, "clearance": clearance, "seed": seed}
        try:
            layers = sample_layers(
                lone_robot(robot, tool, joints, still),
                way,
                positions,
                task=objective.task,
                measure=_measure(integral),
                scene=scene,
                spare=SPARE,
                progress=part(tell, 0.4 * k / len(held), 0.4 * (k + 1) / len(held)),
                **options,  # type: ignore[arg-type]  # checked by sample_layers itself
            )
        except InvalidInputError as error:
            raise InvalidInputError(f"{tool}: {error.argument}", error.value, error.allowed) from error
        arms.append(LoneArm(tool=tool, joints=joints, path=way, layers=layers))
    together = _Together(
        robot=robot,
        scene=scene,
        still=still,
        epsilon=epsilon,
        clearance=clearance,
        tolerance=tool_tolerance(allowed, held),
    )
    tell(0.4, "searching for motions of the arms")
    try:
        joint, seed_path = together.motion(arms)
    except PlanningError as error:
        return failed(draft, throw, str(error))
    tell(0.9, "timing the motion")
    model = scene.collision_model(robot)
    result = make_result(
        joint,
        integral,
        cost=integral.cost(joint),
        seed=seed_path,
        seed_cost=integral.cost(seed_path),
        model=model,
        clearance=clearance,
        status=Status.CARRIED,
    )
    draft = replace(draft, status=Status.CARRIED, path=joint, result=result)
    try:
        trajectory = retime(joint, robot, torque=torque)
    except PlanningError as error:
        return failed(replace(draft, status=Status.NO_TIMING), throw, str(error))
    tell(0.95, "checking the result")
    poses = tool_poses(robot, trajectory(np.linspace(0.0, trajectory.duration, TIMES)))
    deviation = deviation_from(Offset(path=path, offset=held[first]), poses[first])
    made = finish(
        replace(draft, deviation=deviation),
        joint,
        trajectory,
        result,
        model,
        joint.goal,
        clearance=clearance,
        torque=torque,
        jerk=True,
        throw=False,
    )
    errors = held_errors(poses, held)
    tools = tuple(
        replace(each, held_position=errors[each.tool][0], held_rotation=errors[each.tool][1]) if each.tool in errors else each
        for each in made.report.tools
    )
    made = replace(made, report=replace(made.report, tools=tools))
    if made.status is not Status.CARRIED:
        return failed(made, throw, str(made.report))
    fault = deviation.excess(allowed, "time") or _excess(errors, allowed)
    if fault:
        return check_failed(made, throw, f"{fault}. Take more positions")
    tell(1.0, "done")
    return made


def _grasps(robot: Robot, grasps: Mapping[str, Any]) -> dict[str, Array]:
    """The grasps of both tools as matrices."""
    if not isinstance(grasps, Mapping) or len(grasps) != 2:
        wanted = f"a mapping from two of the tools {', '.join(robot.tools)} to poses in the object's frame"
        raise InvalidInputError("grasps", grasps, wanted)
    return {known_tool(robot, "grasps", tool): pose_matrix(f"grasps[{tool!r}]", pose) for tool, pose in grasps.items()}


def _measure(integral: PathIntegral) -> Any:
    """The measure of one tool."""
    measure = integral.kinematics.measure
    return measure.measure if isinstance(measure, OverTools) else measure


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
class _Together:
    """What the motions of both arms have in common.

    Attributes:
        still: (n,) where the joints are that do not move along.
        epsilon: (1,) or one per joint of an arm: maximum step between positions [rad or m].
        tolerance: of each tool on its own path.
    """

    robot: Robot
    scene: Scene
    still: Array
    epsilon: ArrayLike
    clearance: float
    tolerance: Tolerance

    def motion(self, arms: Sequence[LoneArm]) -> tuple[JointPath, JointPath]:
        """The joint path of the whole robot, and the same as searched; the first order of the arms that gives one.

        Raises PlanningError with the reason of the first order where none does.
        """
        reasons = []
        for lead, follow in permutations(arms):
            try:
                return self._in_order(lead, follow)
            except PlanningError as error:
                reasons.append(f"{lead.tool} leads: {error}")
        raise PlanningError("; ".join(reasons))

    def _in_order(self, lead: LoneArm, follow: LoneArm) -> tuple[JointPath, JointPath]:
        model, s = self.scene.collision_model(self.robot), lead.layers.s
        assert s is not None
        refined, searched = lead.courses(self.epsilon, self.tolerance)
        q = np.tile(self.still, (len(s), 1))
        q[:, lead.joints] = refined(s)
        beside = follow.beside(model, q, self.clearance + SPARE)
        refined_beside, searched_beside = beside.courses(self.epsilon, self.tolerance)
        seed = self._of_both((searched, lead.joints), (searched_beside, follow.joints))
        for own in (refined_beside, searched_beside):  # what is refined knows nothing of the other arm
            joint = self._of_both((refined, lead.joints), (own, follow.joints))
            if model.path_is_free(joint, CHECK_STEP, self.clearance):
                return joint, seed
        bodies, _ = model.nearest_bodies(joint(np.linspace(0.0, 1.0, PLACES)))
        raise PlanningError(f"between the positions {bodies}; take more positions")

    def _of_both(self, *parts: tuple[JointPath, list[int]]) -> JointPath:
        return side_by_side(parts, self.still)
