"""What a plan shows over time: configurations, index and tool of the motion, and of the seed beside it."""

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from manipplan.checks import Array, instance
from manipplan.errors import InvalidInputError, PlanningError
from manipplan.kinematics.kinematics import Kinematics
from manipplan.measures.task import Task
from manipplan.paths.joint import JointPath
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.robot import Robot
from manipplan.status import Status
from manipplan.viz.viewer.figures import corners, principal

if TYPE_CHECKING:
    from manipplan.jobs.result import Plan

#: Powers of units as a page shows them.
SUPERSCRIPT = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")
#: Curves are drawn through so many times.
SAMPLES = 201
#: Ellipsoids are drawn at so many of them.
PLACES = 7
#: The largest ellipsoid is drawn with this half length, as a share of the half diagonal of the space the arm takes.
LARGEST = 0.12


@dataclass(frozen=True, kw_only=True, eq=False)
class Motion:
    """The numbers behind the pictures of a plan, at SAMPLES even times.

    Attributes:
        plan: the plan.
        trajectory: its motion.
        kinematics: whose measure is the index.
        position: kinematics of the tool's position, whose ellipsoids are drawn.
        name, seed_name: what the motion and the seed are called.
        t: (k,) [s].
        q, seed_q: (k, n); the seed's at the same share of its length, None without a seed.
        index, seed_index: (k,).
        tool, seed_tool: (k, 3) [m].
        box: (2, 3) corners of the space that the arm takes [m].
        scale: metres to draw for one unit of an ellipsoid's radii.
    """

    plan: "Plan"
    trajectory: Trajectory
    kinematics: Kinematics
    position: Kinematics
    name: str
    seed_name: str
    t: Array
    q: Array
    index: Array
    tool: Array
    seed_q: Array | None
    seed_index: Array | None
    seed_tool: Array | None
    box: Array
    scale: float

    @classmethod
    def of(cls, plan: "Plan") -> "Motion":
        """The motion of a plan; raises PlanningError when it has none."""
        from manipplan.jobs.result import Plan

        instance("plan", plan, Plan)
        robot, trajectory, result = plan.robot, plan.trajectory, plan.result
        if trajectory is None:
            raise PlanningError(f"there is no motion to show: {plan.message or plan.status.value}", plan)
        if trajectory.n != robot.n:
            raise InvalidInputError("plan.trajectory", f"a motion of {trajectory.n} joints", f"one of the robot's {robot.n}")
        kinematics = robot.kinematics(result.task, measure=result.measure) if result is not None else robot.kinematics()
        position = robot.kinematics(Task.planar() if robot.planar else Task.position())
        t = np.linspace(0.0, trajectory.duration, SAMPLES)
        q = trajectory(t)
        seed = result.seed if result is not None else None
        seed_q = None if seed is None or seed is plan.path else _beside(q, seed)
        box = _box(robot, q if seed_q is None else np.concatenate([q, seed_q]))
        largest = max(principal(position, each)[1].max() for each in q[:: SAMPLES // 20])
        reach = float(np.linalg.norm(box[1] - box[0])) / 2
        names = ("optimised", "seed")
        if plan.status is Status.FOLLOWED or plan.refinement is not None:
            names = ("refined", "best of the samples")
        elif plan.status in (Status.IMPROVED, Status.NOT_BETTER) or plan.tracking is not None:
            names = ("improved", "recorded")
        return cls(
            plan=plan,
            trajectory=trajectory,
            kinematics=kinematics,
            position=position,
            name=names[0],
            seed_name=names[1],
            t=t,
            q=q,
            index=kinematics.manipulability(q),
            tool=position.pose(q)[:, :3, 3],
            seed_q=seed_q,
            seed_index=None if seed_q is None else kinematics.manipulability(seed_q),
            seed_tool=None if seed_q is None else position.pose(seed_q)[:, :3, 3],
            box=box,
            scale=LARGEST * reach / largest if largest > 0 else 1.0,
        )

    @property
    def robot(self) -> Robot:
        """The arm."""
        return self.plan.robot

    @property
    def places(self) -> Array:
        """Configurations (PLACES, n) at which ellipsoids are drawn."""
        return np.asarray(self.q[np.linspace(0, SAMPLES - 1, PLACES).round().astype(int)])

    def seed_at(self, t: float) -> Array | None:
        """Where the seed is (n,) while the motion is at time t [s]."""
        if self.seed_q is None:
            return None
        return np.array([np.interp(t, self.t, column) for column in self.seed_q.T])

    def values(self, t: float) -> list[tuple[str, str]]:
        """Name and value of what the panel tells at time t [s]."""
        q, qd = self.trajectory(t), self.trajectory(t, order=1)
        unit = unit_of(self.kinematics).replace("[", "").replace("]", "")
        index = float(self.kinematics.manipulability(q))
        rows = [("time", f"{t:.2f} of {self.trajectory.duration:.2f} s"), ("index now", f"{index:.4g}{unit}")]
        least = int(self.index.argmin())
        rows.append(("least index", f"{self.index[least]:.4g}{unit} at {self.t[least]:.2f} s"))
        if self.seed_index is not None:
            rows.append((f"{self.seed_name}, least", f"{self.seed_index.min():.4g}{unit}"))
        return rows + limits_now(self.robot, q, qd)


def unit_of(kinematics: Kinematics) -> str:
    """Unit of the index in brackets, after a space; "" where it has none."""
    unit = kinematics.measure.unit(kinematics.task)
    shown = re.sub(r"\^(\d+)", lambda power: power[1].translate(SUPERSCRIPT), unit)
    return "" if unit == "1" else f" [{shown}]"


def limits_now(robot: Robot, q: Array, qd: Array) -> list[tuple[str, str]]:
    """Which joint is nearest to its position limit, and which uses most of its velocity limit, at q and qd (n,)."""
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


def _beside(q: Array, seed: JointPath) -> Array:
    """The seed (k, n) at the shares of its length that the motion q (k, n) has covered."""
    s = np.linspace(0.0, 1.0, 801)
    return np.asarray(seed(np.interp(_shares(q), _shares(seed(s)), s)))


def _shares(q: Array) -> Array:
    """Share of the length covered at each sample; of a motion that stands still, of the samples."""
    covered = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(q, axis=0), axis=1))])
    return np.asarray(covered / covered[-1] if covered[-1] > 0 else np.linspace(0.0, 1.0, len(q)))


def _box(robot: Robot, q: Array) -> Array:
    boxes = np.array([corners(robot, each, moving=True) for each in q[:: max(len(q) // 12, 1)]])
    return np.array([boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)])
