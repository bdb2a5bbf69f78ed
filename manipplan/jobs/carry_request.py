"""Request: the checked arguments of `carry`.

How well the tools of a motion keep their poses to each other.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import pinocchio as pin

from manipplan.collision.scene import Scene
from manipplan.cost.integral import PathIntegral
from manipplan.cost.objective import PathObjective
from manipplan.goals.goal import PoseGoal, read_configuration
from manipplan.goals.solutions import beyond_links
from manipplan.paths.cartesian import CartesianPath, Offset
from manipplan.paths.deviation import angles_between
from manipplan.paths.tolerance import Tolerance, with_defaults
from manipplan.robots.arms import known_tool, own_joints
from manipplan.robots.limits import TakenToLimit, taken_to_limits
from manipplan.robots.model_tree import frame_index
from manipplan.robots.robot import Robot
from manipplan.search.layers import check_positions, choose_positions
from manipplan.search.sweep import check_epsilon
from manipplan.support.checks import Array, ArrayLike, flag, instance, number, pose_matrix, random_seed, whole_number
from manipplan.support.errors import InvalidInputError
from manipplan.symbolic.task import Task
from manipplan.timing.retime import check_timing_limits

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
            epsilon=check_epsilon(epsilon, robot.continuous_joints),
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
