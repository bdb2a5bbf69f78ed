"""The description of a motion that pictures and viewer draw: ShownMotion, of a plan or a program.

Its parts: joint path and initial path, samples over time, skeleton and tools, and MovedPart, a part that a program takes up or
puts down, with where it is over time.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import pinocchio as pin

from manipplan.collision.model import CollisionModel
from manipplan.collision.scene import Scene
from manipplan.kinematics.kinematics import Kinematics
from manipplan.paths.joint import JointPath
from manipplan.paths.trajectory import Trajectory
from manipplan.plans.result import PartialPlan, Plan
from manipplan.programs.program import Mark, Program
from manipplan.robots.attached import Solid
from manipplan.robots.model_tree import frame_index, frame_pose
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, ArrayLike, instance
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.support.status import RECORDED
from manipplan.symbolic.task import Task
from manipplan.tracking.track import Tracking
from manipplan.viz import style

#: Number of times at which curves are sampled.
SAMPLES = 201
#: Default length of the largest radius of an ellipsoid, as a share of the length of the stretched arm.
SHARE = 0.08

Motion = JointPath | Trajectory | Tracking


def joint_path(argument: str, motion: Motion, robot: Robot) -> JointPath:
    """The joint path of a motion of this robot; raises InvalidInputError that names `argument`."""
    if isinstance(motion, Tracking):
        motion = motion.trajectory()
    if isinstance(motion, Trajectory):
        motion = motion.path()
    if not isinstance(motion, JointPath) or motion.n != robot.n:
        raise InvalidInputError(argument, motion, f"a JointPath, Trajectory or Tracking of {robot.n} joints")
    return motion


def name_paths(plan: Plan) -> dict[str, JointPath]:
    """A plan's path and its initial path, under the names that fit the plan's job; one entry if they are the same."""
    if plan.refinement is not None:
        ours, first = "refined", "best of the samples"
    elif plan.result.status in RECORDED:
        ours, first = "improved", "recorded"
    else:
        ours, first = "optimised", "seed"
    seed = plan.result.seed
    return {first: plan.path} if seed is plan.path else {ours: plan.path, first: seed}


def length_shares(path: JointPath, s: Array) -> Array:
    """The share (k,) of the path's length at increasing s (k,) from 0 to 1; s itself for a path of zero length."""
    speed = np.linalg.norm(path(s, 1), axis=1)
    gained = np.concatenate([[0.0], np.cumsum(np.diff(s) * (speed[1:] + speed[:-1]) / 2)])
    return np.asarray(gained / gained[-1]) if gained[-1] > 0 else s


def beside(trajectory: Trajectory, seed: JointPath) -> Callable[[ArrayLike], Array]:
    """`seed` at times [s] of a trajectory, at the same share of its length as the trajectory.

    The seed has no timing of its own.
    """
    s = np.linspace(0.0, 1.0, 2001)
    ours, theirs = length_shares(trajectory.path(), s), length_shares(seed, s)
    return lambda t: seed(np.interp(np.interp(np.asarray(t) / trajectory.duration, s, ours), theirs, s))


@dataclass(frozen=True, kw_only=True, eq=False)
class DrawnTool:
    """A tool with a way and ellipsoids: the kinematics of its arm, and the indices of the arm's joints."""

    kinematics: Kinematics
    joints: tuple[int, ...]

    def pose(self, q: Array) -> Array:
        """Its pose (..., 4, 4) at configurations (..., n) of the robot."""
        return self.kinematics.pose(q[..., self.joints])

    def jacobian(self, q: Array) -> Array:
        """The Jacobian (..., m, k) of its arm at configurations (..., n) of the robot."""
        return self.kinematics.jacobian(q[..., self.joints])


def drawn_tools(robot: Robot, task: Task | None = None) -> tuple[DrawnTool, ...]:
    """All tools of a robot, by default with the task whose ellipsoids are drawn: position; for a planar arm, in its plane."""
    task = task if task is not None else Task.planar() if robot.planar else Task.position()
    return tuple(DrawnTool(kinematics=robot.arm(tool).kinematics(task), joints=robot.joints_of(tool)) for tool in robot.tools)


def ellipsoid_scale(robot: Robot, tools: Sequence[DrawnTool], q: Array) -> float:
    """Scale at which the largest radius of the ellipsoids of all tools at q (k, n) is `SHARE` of the longest arm's length."""
    largest = max(np.linalg.norm(tool.jacobian(q), ord=2, axis=(1, 2)).max() for tool in tools)
    return float(SHARE * arm_length(robot) / max(largest, 1e-9))


def arm_length(robot: Robot) -> float:
    """The length of the longest arm from base to tool along its joints [m]."""
    arms = [(robot.arm(tool), list(robot.joints_of(tool))) for tool in robot.tools]
    return float(max(np.linalg.norm(np.diff(skeleton(arm, robot.neutral[own]), axis=0), axis=1).sum() for arm, own in arms))


def skeleton(robot: Robot, q: Array) -> Array:
    """Origins of base, joints and tool at q (n,), (k, 3) [m]; of several arms along each, and back between them."""
    data = robot.model.createData()
    pin.framesForwardKinematics(robot.model, data, q)
    line: list[Array] = []
    for tool in robot.tools:
        frame = frame_index(robot.model, tool)
        joints = [data.oMi[i].translation for i in robot.model.supports[robot.model.frames[frame].parentJoint]]
        line += [*line[::-1], *joints, data.oMf[frame].translation]
    return np.array(line)


#: Since when [s], and the arm with what it carries and the scene from then on.
State = tuple[float, Robot, Scene]


def state_at(states: Sequence[State], t: float) -> int:
    """The index of the state at time t [s]."""
    return max(k for k, (since, _, _) in enumerate(states) if since <= t)


@dataclass(frozen=True, kw_only=True, eq=False)
class MovedPart:
    """A part that a program takes up or puts down; `states` as in `ShownMotion`."""

    name: str
    states: tuple[State, ...]

    def at(self, t: float, robot: Robot, q: Array) -> Solid | None:
        """The part at time t [s], posed in the world, with the arm at q (n,); None where it is nowhere."""
        arm, scene = self._state(t)
        solid, held = self._solid(arm, scene), arm.carried.get(self.name)
        return solid.at(frame_pose(robot.model, held.frame, q)) if solid is not None and held is not None else solid

    def is_held(self, t: float) -> bool:
        """Whether the hand carries it at time t [s]."""
        return self.name in self._state(t)[0].carried

    @property
    def solid(self) -> Solid:
        """The part, wherever it is first."""
        found = (self._solid(arm, scene) for _, arm, scene in self.states)
        return next(each for each in found if each is not None)

    def _state(self, t: float) -> tuple[Robot, Scene]:
        return self.states[state_at(self.states, t)][1:]

    def _solid(self, arm: Robot, scene: Scene) -> Solid | None:
        if self.name in arm.carried:
            return arm.carried[self.name].solid
        return next((each for each in scene.named if each.name == self.name), None)


def find_moved_parts(program: Program) -> tuple[MovedPart, ...]:
    """The parts that a program takes up or puts down, or carries at the start."""
    states = _states(program)
    names = dict.fromkeys(name for _, robot, _ in states for name in robot.carried)
    return tuple(MovedPart(name=name, states=states) for name in names)


def _states(program: Program) -> tuple[State, ...]:
    """Arm and scene, and since when they are so: parts change hands at the marks between two motions."""
    changes = [mark.begin for mark in program.marks if mark.name in ("Attach", "Detach")]
    states = [(0.0, program.robot, program.scene)]
    ends = [begin + part.trajectory.duration for part, begin in zip(program.parts, program.begins, strict=True)]
    later = [(begin, part.robot, part.scene) for part, begin in zip(program.parts, program.begins, strict=True)]
    for before, (begin, robot, scene) in zip(
        [0.0, *ends], [*later, (np.inf, program.final_robot, program.final_scene)], strict=True
    ):
        at = [each for each in changes if before - 1e-9 <= each <= begin + 1e-9]
        if at:
            states.append((min(at), robot, scene))
    return tuple(states)


@dataclass(frozen=True, kw_only=True, eq=False)
class MotionSamples:
    """The motion, or the seed beside it, at the times of a `ShownMotion`.

    Attributes:
        name, colour: in legends.
        path: the path, or the trajectory of a program.
        at: function from times (...) [s] to configurations (..., n).
        q: (k, n) configurations.
        manipulability: (k,) values of the measure.
        tools: (k, 3) positions of each tool [m].
    """

    name: str
    colour: str
    path: Motion
    at: Callable[[ArrayLike], Array]
    q: Array
    manipulability: Array
    tools: tuple[Array, ...]


@dataclass(frozen=True, kw_only=True, eq=False)
class ShownMotion:
    """The data behind the pictures of a plan or program, at evenly spaced times.

    Attributes:
        robot: the arm; for a program without what it carries.
        scene: the obstacles that stay where they are.
        states: arm and scene, and since when they are so, from 0 on; of a plan one.
        moved: the parts that a program moves.
        marks: when the steps of a program begin.
        status: what the motion is.
        kinematics: kinematics with the measure that is drawn.
        tools: the tools whose ways and ellipsoids are drawn.
        t: (k,) times [s].
        motions: the motion, and the initial path at the same share of its length where it is another path.
        scale: metres drawn per unit of an ellipsoid's radii.
    """

    plan: Plan | Program
    robot: Robot
    scene: Scene
    states: tuple[State, ...]
    moved: tuple[MovedPart, ...]
    marks: tuple[Mark, ...]
    status: str
    trajectory: Trajectory
    kinematics: Kinematics
    tools: tuple[DrawnTool, ...]
    t: Array
    motions: tuple[MotionSamples, ...]
    scale: float

    @classmethod
    def of(cls, plan: PartialPlan | Program, samples: int = SAMPLES) -> "ShownMotion":
        """The motion of a plan or program at a number of times; raises PlanningError when it has none."""
        paths: dict[str, Motion]
        if isinstance(plan, Program):
            robot, moved, marks, result = plan.robot, find_moved_parts(plan), plan.marks, plan.parts[0].result
            states = moved[0].states if moved else ((0.0, plan.robot, plan.scene),)
            for name in robot.carried:
                robot = robot.detach(name)
            names = {each.name for each in moved}
            scene = Scene([each for each in plan.scene.named if each.name not in names])
            paths, status = {"motion": plan.trajectory}, "A program of moves"
        else:
            instance("plan", plan, PartialPlan)
            if not isinstance(plan, Plan):
                raise PlanningError(f"there is no trajectory to show: {plan.message or plan.status.value}", plan)
            robot, moved, marks, result, scene = plan.robot, (), (), plan.result, plan.scene
            states = ((0.0, robot, scene),)
            paths, status = {**name_paths(plan)}, plan.status.value[0].upper() + plan.status.value[1:]
        trajectory, tools = plan.trajectory, drawn_tools(robot)
        if trajectory.n != robot.n:
            raise InvalidInputError("plan.trajectory", f"a motion of {trajectory.n} joints", f"one of the robot's {robot.n}")
        kinematics = robot.kinematics(result.task, measure=result.measure)
        t = np.linspace(0.0, trajectory.duration, samples)
        motions: list[MotionSamples] = []
        for (name, path), colour in zip(paths.items(), (style.OPTIMUM, style.SEED), strict=False):
            at = beside(trajectory, path) if motions and isinstance(path, JointPath) else trajectory
            q = at(t)
            ways = tuple(tool.pose(q)[:, :3, 3] for tool in tools)
            m = kinematics.manipulability(q)
            motions.append(MotionSamples(name=name, colour=colour, path=path, at=at, q=q, manipulability=m, tools=ways))
        return cls(
            plan=plan,
            robot=robot,
            scene=scene,
            states=states,
            moved=moved,
            marks=marks,
            status=status,
            trajectory=trajectory,
            kinematics=kinematics,
            tools=tools,
            t=t,
            motions=tuple(motions),
            scale=ellipsoid_scale(robot, tools, motions[0].q[:: samples // 20]),
        )

    @property
    def ours(self) -> MotionSamples:
        """The motion."""
        return self.motions[0]

    @property
    def seed(self) -> MotionSamples | None:
        """The initial path; None where there is no other path."""
        return self.motions[1] if len(self.motions) > 1 else None

    @property
    def worst(self) -> float:
        """The time at which the motion's manipulability is smallest [s]."""
        return float(self.t[self.ours.manipulability.argmin()])

    def minimum(self, samples: MotionSamples, digits: int = 4) -> str:
        """The minimum manipulability of the motion or of the seed, with its unit."""
        return self._with_unit(float(samples.manipulability.min()), digits)

    def values(self, t: float, by_hand: Array | None = None) -> list[tuple[str, str]]:
        """Names and values of the panel at time t [s], or of a posture (n,) to which the arm is moved by hand."""
        q = self.trajectory(t) if by_hand is None else by_hand
        now = self._with_unit(float(self.kinematics.manipulability(q)))
        time = f"{t:.2f} of {self.trajectory.duration:.2f} s" if by_hand is None else "moved by hand"
        rows = [
            ("time", time),
            *self._step(t),
            ("m now", now),
            ("minimum m", f"{self.minimum(self.ours)} at {self.worst:.2f} s"),
        ]
        if self.seed is not None:
            rows.append((f"minimum m, {self.seed.name}", self.minimum(self.seed)))
        rows += nearest_now(self._models[state_at(self.states, t)], q)
        return rows + limits_now(self.robot, q, self.trajectory(t, order=1) if by_hand is None else None)

    @cached_property
    def _models(self) -> tuple[CollisionModel, ...]:
        """Collision models of all states, which no other thread uses."""
        return tuple(scene.collision_model(robot).copy() for _, robot, scene in self.states)

    def _step(self, t: float) -> list[tuple[str, str]]:
        """The step of a program and what is carried at time t [s]."""
        if not self.marks:
            return []
        mark = [each for each in self.marks if each.begin <= t + 1e-9][-1]
        carried = [part.name for part in self.moved if part.is_held(t)]
        return [("step", f"{mark.step} {mark.name}"), ("carries", ", ".join(carried) or "nothing")]

    def _with_unit(self, value: float, digits: int = 4) -> str:
        unit = style.raised(self.kinematics.measure.unit(self.kinematics.task))
        return f"{value:.{digits}g} {unit}".rstrip()


def nearest_now(model: CollisionModel, q: Array) -> list[tuple[str, str]]:
    """The nearest obstacle at q (n,) and the link or carried part that is near it; without obstacles, the nearest two links."""
    if not len(model.pairs):
        return []
    is_outside = (model.pairs >= model.bodies).any(axis=1)
    chosen = np.flatnonzero(is_outside if is_outside.any() else ~is_outside)
    apart = model.pair_distances(np.broadcast_to(q, (len(chosen), len(q))), chosen)
    first, second = (model.links[k] for k in model.pairs[chosen[apart.argmin()]])
    distance = 1e3 * float(apart.min())
    size = f"{abs(distance):.{1 if abs(distance) < 100 else 0}f}"
    words = f"{size} mm from" if distance > 0 else f"{size} mm inside"
    return [("nearest obstacle" if is_outside.any() else "nearest links", f"{first} {words} {second}")]


def limits_now(robot: Robot, q: Array, qd: Array | None) -> list[tuple[str, str]]:
    """The joint nearest to a position limit, and the joint with the largest share of its velocity limit, at q and qd (n,)."""
    rows = []
    room = np.array([q - robot.limits.lower, robot.limits.upper - q])
    if np.isfinite(room).any():
        side, i = divmod(int(room.argmin()), robot.n)
        unit = "m" if robot.joint_types[i] == "prismatic" else "rad"
        limit = "upper" if side else "lower"
        rows.append(("nearest limit", f"{robot.joint_names[i]} at {room[side, i]:.3f} {unit} from its {limit} limit"))
    if qd is not None and np.isfinite(robot.limits.velocity).any():
        use = np.abs(qd) / robot.limits.velocity
        i = int(use.argmax())
        rows.append(("fastest joint", f"{robot.joint_names[i]}, {100 * use[i]:.0f} % of its limit"))
    return rows
