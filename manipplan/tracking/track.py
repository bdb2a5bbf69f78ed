"""track: follows a whole path with a controller, step by step, and returns the result."""

import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import pinocchio as pin

from manipplan.kinematics.kinematics import Kinematics
from manipplan.measures.measure import Measure
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.tolerance import Stiffness, StiffnessProfile, Tolerance
from manipplan.paths.trajectory import Trajectory
from manipplan.plans.result import Plan
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, ArrayLike, instance, number
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError
from manipplan.support.status import Status
from manipplan.symbolic.task import Task
from manipplan.tracking.avoidance import Avoidance
from manipplan.tracking.controller import Controller, StepReport
from manipplan.tracking.formulations import Formulation

#: Tolerance within which the final pose counts as reached [m, rad], and speed below which the arm is at rest [rad/s, m/s].
REACHED = (1e-4, 1e-3)
AT_REST = 1e-6
#: Share of the tolerance by which a step may exceed it, for the path's curvature within one step.
BENT = 0.02
#: Stiffness that holds the final pose, and the maximum time to reach it [s].
HOLD = 1e4
SETTLING = 2.0
#: Share of the joint limits that the default duration uses.
PACE = 0.5
#: Maximum number of time steps of one motion; more take hours and come from wrong limits or durations.
MOST_STEPS = 1_000_000


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class Tracking:
    """Result of following a path; N samples, the first of which is the start, at rest.

    Attributes:
        t: (N,) times [s].
        q, qd: (N, n) positions and the velocities that led to them [rad or m, and per s].
        manipulability: (N,) m.
        targets: (N, 4, 4) desired poses.
        deviation, rotation_deviation: (N,) of the tool from the targets, by forward kinematics [m, rad]; in the task's rows.
        clearance: minimum distance that avoidance measured at each step [m]; inf without avoidance.
        reports: result of each step, except the last few that brake.
        solve_times: wall time of each of these steps [s].
        duration: of the path itself, without the settling at its end [s].
        status, message: outcome.
        joint_names: (n,).
    """

    t: Array
    q: Array
    qd: Array
    manipulability: Array
    targets: Array
    deviation: Array
    rotation_deviation: Array
    clearance: Array
    reports: tuple[StepReport, ...]
    solve_times: Array
    duration: float
    status: Status
    message: str
    joint_names: tuple[str, ...]

    def trajectory(self) -> Trajectory:
        """The motion in continuous time, with velocity linear between the samples, so acceleration limits hold throughout.

        It is the commanded motion, whose velocity jumps at every step, averaged over one step and thus half a step later.
        """
        dt = float(self.t[1])
        return Trajectory(t=self.t, q=self.q - dt * self.qd / 2, qd=self.qd, joint_names=self.joint_names)

    @property
    def convexified(self) -> int:
        """Number of steps whose cost was indefinite and made convex."""
        return sum(report.convexified > 0 for report in self.reports)

    @property
    def braked(self) -> int:
        """Number of steps without a valid solution."""
        return sum(report.status.brakes for report in self.reports)

    def __str__(self) -> str:
        times = 1e6 * self.solve_times
        lines = [
            f"{self.status.name.lower().replace('_', ' ')}: {self.message}",
            f"  time         {self.t[-1]:.3f} s in {len(self.reports)} steps, {np.median(times):.1f} us per step "
            f"(99 %: {np.percentile(times, 99):.1f} us)",
            f"  m            minimum {self.manipulability.min():.4g}, mean {self.manipulability.mean():.4g}",
            f"  deviation    at most {1e3 * self.deviation.max():.2f} mm and {np.rad2deg(self.rotation_deviation.max()):.2f}°, "
            f"at the end {1e3 * self.deviation[-1]:.4f} mm and {np.rad2deg(self.rotation_deviation[-1]):.4f}°",
        ]
        if np.isfinite(self.clearance).any():
            lines.append(f"  clearance    at least {1e3 * self.clearance.min():.1f} mm")
        if self.convexified or self.braked:
            lines.append(f"  steps        {self.convexified} made convex, {self.braked} braked")
        return "\n".join(lines)


def track(
    robot: Robot,
    path: CartesianPath,
    start: ArrayLike | None,
    formulation: Formulation,
    *,
    dt: float,
    duration: float | None = None,
    task: Task | None = None,
    measure: Measure | str | None = None,
    stiffness: Stiffness | None = None,
    tolerance: Tolerance | Callable[[float], Tolerance] | None = None,
    weights: ArrayLike = 1.0,
    approach: float = 2.0,
    avoidance: Avoidance | None = None,
    reference: Plan | None = None,
    compiled: bool | str = "auto",
) -> Tracking:
    """Follow a path from rest to rest, with cubic timing s = 3u² - 2u³ along it, and raise manipulability on the way.

    Args:
        robot: the arm, with its limits.
        path: the poses T(s).
        start: (n,) inside the limits, with the tool at or near T(0); None: where the reference begins.
        formulation: Classical, General, Objective, Equality or LogDrive of `manipplan.formulations`, or your own.
        dt: time step [s] > 0.
        duration: of the path [s]; default: one at which exact tracking would use half of the joint limits.
        task: task that is tracked, and whose manipulability counts; default `robot.default_task`.
        measure: the manipulability that is raised; default Yoshikawa's. See `Controller`.
        stiffness: Q_δ: a number, or a function of the share of the time such as StiffnessProfile. Default 1e4, which holds
            the path closely; with a tolerance StiffnessProfile(), which lets the formulation use the tube.
        tolerance: tube around the path, constant or a function of s. Without one, a low stiffness lets the formulation pull
            the arm decimetres away.
        weights: diagonal of Q.
        approach: deceleration [m/s²] at which corrections are braked, as in Controller; inf: dead-beat, as in the paper.
        avoidance: collision avoidance; its moving obstacles stand still here.
        reference: a plan along this path, or along the one from which it is displaced; see `Controller`.
        compiled: as in `Robot.kinematics`.

    At the end of the path the drive is switched off and the final pose is approached for up to two seconds more.

    Raises InvalidInputError for invalid arguments. The status of the result reports any other failure.
    """
    if not isinstance(path, CartesianPath):
        raise InvalidInputError("path", path, "a CartesianPath")
    instance("robot", robot, Robot)
    tube = _tolerance_along(tolerance)
    controller = Controller(
        robot,
        formulation,
        dt=dt,
        task=task,
        measure=measure,
        weights=weights,
        approach=approach,
        tolerance=None if tube is None else tube(0.0),
        avoidance=avoidance,
        reference=reference,
        compiled=compiled,
    )
    if start is None:
        if controller.reference is None:
            raise InvalidInputError("start", start, "a configuration (n,), or a reference, at whose beginning it starts")
        start = controller.reference.start
    q = robot.configuration("start", start)
    if stiffness is None:
        stiffness = HOLD if tube is None or not formulation.solves_qp else StiffnessProfile()
    if duration is None:
        duration = default_duration(controller.kinematics, path, q)
    steps = step_count(number("duration", duration, above=0.0), dt)
    u = np.arange(steps + 1) / steps
    s = 3 * u**2 - 2 * u**3
    return follow_poses(controller, q, path(s), s, along(stiffness), tube)


def step_count(duration: float, dt: float) -> int:
    """Number of time steps in a duration, rounded up; raises InvalidInputError above `MOST_STEPS`."""
    least = duration / dt - 1e-9
    if not least <= MOST_STEPS:
        wanted = f"at most {MOST_STEPS:,} time steps of dt = {dt:g} s: a shorter duration, a longer dt, or higher joint limits"
        raise InvalidInputError("duration", duration, wanted)
    return max(int(np.ceil(least)), 1)


def follow_poses(
    controller: Controller,
    start: Array,
    poses: Array,
    s: Array,
    stiffness: Callable[[float], float],
    tube: Callable[[float], Tolerance] | None,
) -> Tracking:
    """Follow poses (N + 1, 4, 4), one per time step and the first at the start, at the path parameters s (N + 1,).

    `stiffness` is a function of the share of the time, `tube` a function of s.
    """
    loop = _Loop(controller, start)
    for k in range(1, len(poses)):
        loop.step(poses[k], stiffness(k / (len(poses) - 1)), 1.0, tube(float(s[k])) if tube is not None else None)
    loop.settle(poses[-1], tube(1.0) if tube is not None else None)
    return loop.result(len(poses) - 1, poses[0], tube, s)


def default_duration(kinematics: Kinematics, path: CartesianPath, start: Array) -> float:
    """Duration [s] at which following `path` exactly from `start` uses `PACE` of the velocity and acceleration limits."""
    poses = path.sample(200)
    limits = kinematics.robot.limits
    q, fastest, hardest = start, 1e-3, 1e-3
    before = None
    for pose in poses[1:]:
        error = _error(kinematics.task, kinematics.pose(q), pose)
        step = np.linalg.pinv(kinematics.jacobian(q), rcond=1e-2) @ error
        rate = step * (len(poses) - 1)
        fastest = max(fastest, float((np.abs(rate) / limits.velocity).max()))
        if before is not None:
            hardest = max(hardest, float((np.abs(rate) / limits.acceleration).max()))
        before, q = rate, np.clip(q + step, limits.lower, limits.upper)
    # cubic timing: ds/dt is at most 1.5 / D, d²s/dt² at most 6 / D²
    return float(max(1.5 * fastest / PACE, (6 * hardest / PACE) ** 0.5))


class _Loop:
    """The control loop with a simulated arm that moves exactly as commanded."""

    def __init__(self, controller: Controller, start: Array) -> None:
        self.controller = controller
        self.q, self.qd = [start], [np.zeros(controller.robot.n)]
        self.targets: list[Array] = []
        self.reports: list[StepReport] = []
        self.times: list[float] = []

    def step(self, target: Array, stiffness: float, drive: float, tolerance: Tolerance | None) -> None:
        began = time.perf_counter()
        velocity = self.controller.step(self.q[-1], self.qd[-1], target, stiffness=stiffness, drive=drive, tolerance=tolerance)
        self.times.append(time.perf_counter() - began)
        self.reports.append(self.controller.report)
        self.q.append(self.q[-1] + self.controller.dt * velocity)
        self.qd.append(velocity)
        self.targets.append(target)

    def settle(self, target: Array, tolerance: Tolerance | None) -> None:
        """Approach the final pose without a drive, then stop."""
        for _ in range(int(SETTLING / self.controller.dt)):
            if np.abs(self.qd[-1]).max() < AT_REST:
                break
            self.step(target, HOLD, 0.0, tolerance)
        for _ in range(int(SETTLING / self.controller.dt)):
            if not self.qd[-1].any():
                break
            velocity = self.controller.brake(self.q[-1], self.qd[-1])
            self.q.append(self.q[-1] + self.controller.dt * velocity)
            self.qd.append(velocity)
            self.targets.append(target)

    def result(self, steps: int, first: Array, tube: Callable[[float], Tolerance] | None, s: Array) -> Tracking:
        controller = self.controller
        kinematics = controller.kinematics
        q, targets = np.array(self.q), np.array([first, *self.targets])
        errors = np.array(
            [_error(controller.task, pose, target) for pose, target in zip(kinematics.pose(q), targets, strict=True)]
        )
        deviation, rotation = _lengths(controller.task, errors)
        braked = sum(report.status.brakes for report in self.reports)
        status, message = _outcome(deviation, rotation, tube, s, braked, controller.dt)
        return Tracking(
            t=controller.dt * np.arange(len(q), dtype=float),
            q=q,
            qd=np.array(self.qd),
            manipulability=kinematics.manipulability(q),
            targets=targets,
            deviation=deviation,
            rotation_deviation=rotation,
            clearance=np.array([report.clearance for report in self.reports]),
            reports=tuple(self.reports),
            solve_times=np.array(self.times),
            duration=steps * controller.dt,
            status=status,
            message=message,
            joint_names=controller.robot.joint_names,
        )


def _outcome(
    deviation: Array,
    rotation: Array,
    tube: Callable[[float], Tolerance] | None,
    s: Array,
    braked: int,
    dt: float,
) -> tuple[Status, str]:
    worst = f"it is {1e3 * deviation[-1]:.3g} mm and {np.rad2deg(rotation[-1]):.3g}° from the final pose"
    if tube is not None:
        parameters = np.concatenate([s, np.ones(len(deviation) - len(s))])
        before = tube(float(parameters[0]))
        for k, at in enumerate(parameters):
            allowed, last = tube(float(at)), before
            before = allowed
            for name, value, limits, unit in (
                ("position", deviation[k], (allowed.position, last.position), "m"),
                ("rotation", rotation[k], (allowed.rotation, last.rotation), "rad"),
            ):
                limit = max((each for each in limits if each is not None), default=None)  # a smaller limit holds one step later
                if limit is not None and value > limit * (1 + BENT):
                    text = f"{name} deviates by {value:.4g} {unit} at s = {at:.3f}, t = {k * dt:.3f} s; allowed {limit:g}"
                    return Status.LEFT_TOLERANCE, text
    if braked:
        return Status.BRAKED, f"{braked} steps had no valid solution"
    if deviation[-1] > REACHED[0] or rotation[-1] > REACHED[1]:
        return Status.NOT_REACHED, worst
    return Status.TRACKED, f"largest deviation {1e3 * deviation.max():.3g} mm, {np.rad2deg(rotation.max()):.3g}°"


def _error(task: Task, pose: Array, target: Array) -> Array:
    """The displacement in the rows of a task (m,), the numerical form of `task_error`."""
    axis = task.free_axis
    if axis is None:
        turn = pin.log3(target[:3, :3] @ pose[:3, :3].T)
    else:
        turn = pin.log3(pin.Quaternion.FromTwoVectors(pose[:3, :3] @ axis, target[:3, :3] @ axis).matrix())
    world, tool = task.matrices
    straight = target[:3, 3] - pose[:3, 3]
    turned = np.concatenate([pose[:3, :3].T @ straight, pose[:3, :3].T @ turn])
    return np.concatenate([world @ np.concatenate([straight, turn]), tool @ turned])


def _lengths(task: Task, errors: Array) -> tuple[Array, Array]:
    """Lengths [m] and angles [rad] of displacements (k, m) in the rows of a task."""
    turns = np.array([any(row[3:]) for row in (*task.world_rows, *task.tool_rows)])
    return np.linalg.norm(errors[:, ~turns], axis=1), np.linalg.norm(errors[:, turns], axis=1) / task.length


def _tolerance_along(
    tolerance: Tolerance | Callable[[float], Tolerance] | None,
) -> Callable[[float], Tolerance] | None:
    if tolerance is None:
        return None
    if isinstance(tolerance, Tolerance):
        return lambda _: tolerance
    if not callable(tolerance) or not isinstance(tolerance(0.0), Tolerance):
        raise InvalidInputError("tolerance", tolerance, "a Tolerance, or a function of s that returns one")
    return tolerance


def along(stiffness: Stiffness) -> Callable[[float], float]:
    """The stiffness as a function of the share of the time; raises InvalidInputError for a number that is not positive."""
    if callable(stiffness):
        return stiffness
    value = number("stiffness", stiffness, above=0.0)
    return lambda _: value
