"""Data of a plan or program over time: configurations, manipulability and tool positions of the motion and of its seed."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from manipplan.collision.scene import Scene
from manipplan.kinematics.kinematics import Kinematics
from manipplan.optimize.result import PathResult
from manipplan.paths.joint import JointPath
from manipplan.paths.trajectory import Trajectory
from manipplan.plans.result import PartialPlan, Plan
from manipplan.programs.program import Mark, Program
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, instance
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.viz import style
from manipplan.viz.motions import DrawnTool, MovedPart, bare, beside, drawn_tools, find_moved_parts, fixed, name_paths
from manipplan.viz.viewer.figures import corners, ellipsoid_scale

#: Number of times at which curves are sampled.
SAMPLES = 201
#: Number of these times at which ellipsoids are drawn.
ELLIPSOID_TIMES = 7


@dataclass(frozen=True, kw_only=True, eq=False)
class MotionSamples:
    """The motion, or the seed beside it, at the times of a `ShownMotion`.

    Attributes:
        name: name in the legend.
        at: function from times (...) [s] to configurations (..., n).
        q: (k, n) configurations.
        manipulability: (k,) values of the measure.
        tools: (k, 3) positions of each tool [m].
    """

    name: str
    at: Callable[[float], Array]
    q: Array
    manipulability: Array
    tools: tuple[Array, ...]


@dataclass(frozen=True, kw_only=True, eq=False)
class ShownMotion:
    """The data behind the pictures of a plan or program, at SAMPLES evenly spaced times.

    Attributes:
        robot: the arm; for a program without what it carries.
        scene: the obstacles that stay where they are.
        status: what the motion is.
        marks: when the steps of a program begin.
        moved: the parts that a program moves.
        trajectory: its motion.
        kinematics: kinematics with the measure that is drawn.
        tools: the tools whose ways and ellipsoids are drawn.
        t: (k,) times [s].
        ours: the motion.
        seed: the initial path, at the same share of its length as the motion; None where there is no other path.
        box: (2, 3) corners of the box that the arm moves in [m].
        scale: metres drawn per unit of an ellipsoid's radii.
    """

    robot: Robot
    scene: Scene
    status: str
    trajectory: Trajectory
    kinematics: Kinematics
    tools: tuple[DrawnTool, ...]
    t: Array
    ours: MotionSamples
    seed: MotionSamples | None
    box: Array
    scale: float
    marks: tuple[Mark, ...] = ()
    moved: tuple[MovedPart, ...] = ()

    @classmethod
    def of(cls, shown: "Plan | Program") -> "ShownMotion":
        """The motion of a plan or program; raises PlanningError when it has none."""
        if isinstance(shown, Program):
            robot, moved = bare(shown.robot), find_moved_parts(shown)
            made = cls._make(robot, fixed(shown.scene, moved), shown.trajectory, shown.parts[0].result, {"motion": None}, "")
            return replace(made, status="A program of moves", marks=shown.marks, moved=moved)
        instance("plan", shown, PartialPlan)
        if not isinstance(shown, Plan):
            raise PlanningError(f"there is no motion to show: {shown.message or shown.status.value}", shown)
        status = shown.status.value[0].upper() + shown.status.value[1:]
        return cls._make(shown.robot, shown.scene, shown.trajectory, shown.result, name_paths(shown), status)

    @classmethod
    def _make(
        cls,
        robot: Robot,
        scene: Scene,
        trajectory: Trajectory,
        result: PathResult,
        paths: Mapping[str, JointPath | None],
        status: str,
    ) -> "ShownMotion":
        """A motion under the first name of `paths`, beside the path of the second name where there is one."""
        if trajectory.n != robot.n:
            raise InvalidInputError("plan.trajectory", f"a motion of {trajectory.n} joints", f"one of the robot's {robot.n}")
        kinematics = robot.kinematics(result.task, measure=result.measure)
        tools = drawn_tools(robot)
        t = np.linspace(0.0, trajectory.duration, SAMPLES)

        def samples(name: str, at: Callable[..., Array]) -> MotionSamples:
            q = at(t)
            ways = tuple(tool.pose(q)[:, :3, 3] for tool in tools)
            return MotionSamples(name=name, at=at, q=q, manipulability=kinematics.manipulability(q), tools=ways)

        (name, _), *others = paths.items()
        ours = samples(name, trajectory)
        seed = next((samples(name, beside(trajectory, path)) for name, path in others if path is not None), None)
        box = _box(robot, ours.q if seed is None else np.concatenate([ours.q, seed.q]))
        return cls(
            robot=robot,
            scene=scene,
            status=status,
            trajectory=trajectory,
            kinematics=kinematics,
            tools=tools,
            t=t,
            ours=ours,
            seed=seed,
            box=box,
            scale=ellipsoid_scale(tools, ours.q[:: SAMPLES // 20], box),
        )

    @property
    def motions(self) -> tuple[MotionSamples, ...]:
        """The motion, and the seed where there is one."""
        return (self.ours,) if self.seed is None else (self.ours, self.seed)

    @property
    def places(self) -> Array:
        """Configurations (ELLIPSOID_TIMES, n) at which ellipsoids are drawn."""
        return np.asarray(self.ours.q[np.linspace(0, SAMPLES - 1, ELLIPSOID_TIMES).round().astype(int)])

    def least(self) -> list[tuple[str, str]]:
        """Names and values of the minimum manipulability of the motion and of the seed."""
        k = int(self.ours.manipulability.argmin())
        rows = [("minimum m", f"{self._with_unit(self.ours.manipulability[k])} at {self.t[k]:.2f} s")]
        if self.seed is not None:
            rows.append((f"minimum m, {self.seed.name}", self._with_unit(self.seed.manipulability.min())))
        return rows

    def values(self, t: float) -> list[tuple[str, str]]:
        """Names and values of the panel at time t [s]."""
        q, qd = self.trajectory(t), self.trajectory(t, order=1)
        now = self._with_unit(float(self.kinematics.manipulability(q)))
        rows = [("time", f"{t:.2f} of {self.trajectory.duration:.2f} s"), *self._step(t), ("measure now", now)]
        return rows + self.least() + limits_now(self.robot, q, qd)

    def _step(self, t: float) -> list[tuple[str, str]]:
        """The step of a program and what is carried at time t [s]."""
        if not self.marks:
            return []
        mark = [each for each in self.marks if each.begin <= t + 1e-9][-1]
        carried = [part.name for part in self.moved if part.is_held(t)]
        return [("step", f"{mark.step} {mark.name}"), ("carries", ", ".join(carried) or "nothing")]

    def _with_unit(self, value: float) -> str:
        unit = style.raised(self.kinematics.measure.unit(self.kinematics.task))
        return f"{value:.4g} {unit}".rstrip()


def limits_now(robot: Robot, q: Array, qd: Array) -> list[tuple[str, str]]:
    """The joint nearest to a position limit, and the joint with the largest share of its velocity limit, at q and qd (n,)."""
    rows = []
    room = np.minimum(q - robot.limits.lower, robot.limits.upper - q)
    if np.isfinite(room).any():
        i = int(room.argmin())
        unit = "m" if robot.joint_types[i] == "prismatic" else "rad"
        rows.append(("nearest joint limit", f"{robot.joint_names[i]}, {room[i]:.3f} {unit} away"))
    if np.isfinite(robot.limits.velocity).any():
        use = np.abs(qd) / robot.limits.velocity
        i = int(use.argmax())
        rows.append(("fastest joint", f"{robot.joint_names[i]}, {100 * use[i]:.0f} % of its limit"))
    return rows


def _box(robot: Robot, q: Array) -> Array:
    boxes = np.array([corners(robot, each, moving=True) for each in q[:: max(len(q) // 12, 1)]])
    return np.array([boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)])
