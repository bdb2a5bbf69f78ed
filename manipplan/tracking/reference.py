"""Reference: a planned motion along a tool path, which tells a servo or a controller in which branch to stay."""

from dataclasses import dataclass

import casadi as ca
import numpy as np
import pinocchio as pin

from manipplan.paths.trajectory import Trajectory
from manipplan.plans.archive import fingerprint
from manipplan.plans.result import Plan
from manipplan.robots.robot import Robot
from manipplan.support.checks import COINCIDENT, Array, instance
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError
from manipplan.symbolic.chain import Placement
from manipplan.symbolic.motion import Factor
from manipplan.symbolic.task import Task

#: Number of knots of a reference, samples of the motion from which they are chosen, and which enter expressions: each 4th.
KNOTS, SAMPLES, THINNED = 201, 2001, 4
#: Metres per radian of joints in the distance between knots.
SPACING = 0.1
#: Of the return to a reference through the null space, as in servo.c: rate [1/s], distance from which on the arm is taken to
#: be in another branch [rad], and metres per radian of joints where the nearest knot is sought.
RETURN, BRANCH, BESIDE = 20.0, 0.5, 0.02
#: Damping of the null space's projector [m].
DAMPING = 1e-3
#: Tolerance within which two arms have the same kinematics [m, rad].
SAME_ARM = 1e-6


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class Reference:
    """The part of a plan on which the tool follows its path, at K knots that are equally far from each other.

    Attributes:
        q: (K, n) positions [rad or m].
        poses: (K, 4, 4) of the tool there, in the world.
        lead_in: motion from the start of the plan to the first of them; None where the plan begins there.
    """

    q: Array
    poses: Array
    lead_in: Trajectory | None

    @property
    def start(self) -> Array:
        """Configuration (n,) in which the reference begins; move the arm there before it follows the tool path."""
        return np.asarray(self.q[0])


def planned_beside(reference: Reference, q: ca.SX, tool: Placement, task: Task) -> ca.SX:
    """The planned configuration (n, 1) where the tool is: at the least of a parabola through three knots' distances."""
    planned, poses = reference.q[::THINNED], reference.poses[::THINNED]
    count = len(planned)
    across = [np.zeros((3 * count, 3)) for _ in range(3)]  # half the sum of the cross products of the axes, in the tool's
    for k, pose in enumerate(poses):
        for axis in range(3):
            across[axis][3 * k : 3 * k + 3] = -pin.skew(pose[:3, axis]) / 2
    turns = ca.reshape(sum(ca.DM(across[axis]) @ tool.rotation[:, axis] for axis in range(3)), 3, count)
    shifts = ca.DM(poses[:, :3, 3].T) - ca.repmat(tool.origin, 1, count)
    world, own = (ca.sparsify(ca.DM(rows)) for rows in task.matrices)
    turned = ca.vertcat(tool.rotation.T @ shifts, tool.rotation.T @ turns)
    rows = ca.vertcat(world @ ca.vertcat(shifts, turns), own @ turned, BESIDE * (ca.DM(planned.T) - ca.repmat(q, 1, count)))
    far = ca.sum1(rows * rows)
    least, place = far[1], ca.SX(0)
    for k in range(1, count - 1):
        change = (far[k - 1] - far[k + 1]) / (2 * ca.fmax(far[k - 1] - 2 * far[k] + far[k + 1], 1e-18))
        nearer = far[k] < least if k > 1 else True
        place = ca.if_else(nearer, k + ca.fmax(-1, ca.fmin(1, change)), place)
        least = ca.if_else(nearer, far[k], least)
    hats = ca.fmax(0, 1 - ca.fabs(place - ca.DM(np.arange(count))))
    return ca.DM(planned.T) @ hats


def return_rate(reference: Reference, q: ca.SX, tool: Placement, task: Task, jacobian: ca.SX, dt: float) -> tuple[ca.SX, ca.SX]:
    """The joint velocity (n, 1) that returns to the reference through the null space, and the projector (n, n) on that."""
    factor = Factor.of(jacobian, DAMPING)
    null = ca.SX.eye(q.shape[0]) - factor.Q @ ca.solve(factor.L, jacobian)
    back = null @ (planned_beside(reference, q, tool, task) - q)
    share = ca.fmax(0, ca.fmin(1, 2 - ca.sqrt(ca.sumsqr(back) + 1e-300) / BRANCH))
    return min(RETURN, 0.5 / dt) * share * back, null


def reference_of(plan: Plan, robot: Robot, task: Task) -> Reference:
    """The reference of a plan for an arm and its task; raises InvalidInputError where the plan is of no use."""
    instance("reference", plan, Plan)
    if plan.workspace_path is None or plan.report is None or not plan.report.along:
        raise InvalidInputError("reference", plan, "a plan along a tool path, such as mp.follow(robot, path)")
    if len(plan.report.along) > 1:
        raise InvalidInputError("reference", plan, "a plan without interruptions: with one of them the arm changes its branch")
    theirs, ours = fingerprint(plan.robot), fingerprint(robot)
    if any(a.shape != b.shape or not np.allclose(a, b, rtol=0, atol=SAME_ARM) for a, b in zip(theirs, ours, strict=True)):
        wanted = f"a plan for the robot that is moved, {robot.name}, with the same tool and base"
        raise InvalidInputError("reference.robot", plan.robot.name, wanted)
    planned = plan.result.task
    if not _same_rows(planned, task):
        wanted = f"a plan whose task leaves the same motions of the tool free as {task.name!r}"
        raise InvalidInputError("reference.task", planned.name, wanted)
    part = plan.report.along[0]
    motion = plan.trajectory(np.linspace(part.begin, part.end, SAMPLES))
    outside = ((motion < robot.limits.lower - COINCIDENT) | (motion > robot.limits.upper + COINCIDENT)).any(axis=0)
    if outside.any():
        names = ", ".join(np.array(robot.joint_names)[outside])
        raise InvalidInputError("reference", plan, f"a plan inside the position limits; it exceeds those of {names}")
    kinematics = robot.kinematics(task, compiled=False)
    origins = kinematics.pose(motion)[:, :3, 3]
    steps = np.linalg.norm(np.diff(origins, axis=0), axis=1) + SPACING * np.linalg.norm(np.diff(motion, axis=0), axis=1)
    way = np.concatenate([[0.0], np.cumsum(steps)])
    knots = np.linspace(0.0, way[-1], KNOTS)
    q = np.array([np.interp(knots, way, joint) for joint in motion.T]).T.copy()
    return Reference(q=q, poses=kinematics.pose(q), lead_in=_until(plan.trajectory, part.begin))


def _same_rows(first: Task, second: Task) -> bool:
    """Whether two tasks fix the same motions of the tool: their rows span the same spaces."""

    def spaces(task: Task) -> list[Array]:
        return [np.linalg.pinv(rows) @ rows if len(rows) else np.zeros((6, 6)) for rows in task.matrices]

    return all(np.allclose(a, b, atol=1e-9) for a, b in zip(spaces(first), spaces(second), strict=True))


def _until(motion: Trajectory, end: float) -> Trajectory | None:
    """The part of a motion up to a time; None where this is its beginning."""
    if end <= 0.0:
        return None
    t = np.append(motion.t[motion.t < end - COINCIDENT], end)
    return Trajectory(t=t, q=motion(t), qd=motion(t, 1), joint_names=motion.joint_names)
