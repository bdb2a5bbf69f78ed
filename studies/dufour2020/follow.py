"""The arm, which follows courses with any formulation, and the results of its runs."""

import time
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
import pinocchio as pin
from scipy.optimize import minimize

import manipplan as mp
from studies.dufour2020 import config
from studies.dufour2020.courses import Array, Course, load_courses

#: The formulations with a strength of 1. The drive of `Controller` multiplies it: k₀, α or β of a run.
FORMULAS: dict[str, mp.formulations.Formulation] = {
    "(7)": mp.formulations.Classical(1.0),
    "(10)": mp.formulations.Objective(1.0),
    "(10) as it is": mp.formulations.Objective(1.0, convexify=False),
    "(14)": mp.formulations.Equality(1.0),
    "LogDrive": mp.formulations.LogDrive(1.0, rate=config.LOG_RATE),
}


@dataclass(frozen=True, kw_only=True, eq=False)
class Run:
    """Result of following a course; the first `steps` + 1 samples are on the path, then the arm settles at its end.

    Attributes:
        course, formula, strength: the course, the formulation and its parameter.
        t, q, qd: (N,) [s], (N, 7) [rad, rad/s].
        manipulability: (N,) divided by the arm's largest.
        poses, targets: (N, 4, 4).
        deviation, rotation: (N,) of the tool from its target [m, rad].
        rollout: the steps' reports.
    """

    course: Course
    formula: str
    strength: float
    t: Array
    q: Array
    qd: Array
    manipulability: Array
    poses: Array
    targets: Array
    deviation: Array
    rotation: Array
    rollout: mp.results.Rollout
    steps: int

    @property
    def mean(self) -> float:
        """Mean normalised manipulability along the path."""
        return float(self.manipulability[: self.steps + 1].mean())

    @property
    def least(self) -> float:
        """Minimum normalised manipulability along the path."""
        return float(self.manipulability[: self.steps + 1].min())

    @property
    def worst(self) -> float:
        """Largest deviation on the path [m]."""
        return float(self.deviation[: self.steps + 1].max())

    @property
    def turned(self) -> float:
        """Largest deviation of the rotation on the path [rad]."""
        return float(self.rotation[: self.steps + 1].max())

    @property
    def reached(self) -> bool:
        """Whether the run ends at the final pose."""
        return bool(self.deviation[-1] <= config.REACHED[0] and self.rotation[-1] <= config.REACHED[1])

    @property
    def unsolved(self) -> int:
        """Number of steps without a valid solution."""
        return int(np.count_nonzero(self.rollout["status"]))

    @property
    def convexified(self) -> int:
        """Number of steps whose cost was indefinite and made convex."""
        return int(np.count_nonzero(self.rollout["convexified"]))

    @property
    def acceleration(self) -> Array:
        """Joint accelerations (steps, 7) on the path [rad/s²]."""
        return np.asarray(np.diff(self.qd[: self.steps + 1], axis=0) / self.t[1])

    @property
    def chatter(self) -> float:
        """Share of joints and steps in which a large acceleration follows one of the opposite sign."""
        hard = np.where(np.abs(self.acceleration) > config.ACCELERATION / 2, np.sign(self.acceleration), 0)
        return float((hard[1:] * hard[:-1] < 0).mean())

    @property
    def sound(self) -> bool:
        """Whether the run counts: it reached the end without braking and chatter, and (7) kept its path."""
        kept = self.formula != "(7)" or self.worst <= config.KEPT
        return self.reached and not self.unsolved and self.chatter <= config.CHATTER and kept

    @property
    def roughness(self) -> float:
        """Root mean square of the joint accelerations on the path [rad/s²]."""
        return float(np.sqrt((self.acceleration**2).mean()))


@dataclass(frozen=True)
class Arm:
    """The paper's arm, its courses, and the controllers made for it."""

    robot: mp.Robot = field(
        default_factory=lambda: mp.load_robot(config.ROBOT).with_limits(acceleration=config.ACCELERATION, source="the study")
    )
    made: dict[tuple[object, ...], mp.Controller] = field(default_factory=dict)

    @cached_property
    def kinematics(self) -> mp.Kinematics:
        """Kinematics of the six rows without weights."""
        return self.robot.kinematics(config.TASK)

    @cached_property
    def courses(self) -> dict[str, Course]:
        """All courses by name."""
        return load_courses(self.kinematics)

    @cached_property
    def maxima(self) -> Array:
        """Local maxima (STARTS,) of the manipulability inside the position limits, largest first."""
        limits, kinematics = self.robot.limits, self.kinematics
        found = [
            -minimize(
                lambda q: -kinematics.manipulability(q),
                start,
                jac=lambda q: -kinematics.gradient(q),
                bounds=list(zip(limits.lower, limits.upper, strict=True)),
                method="L-BFGS-B",
            ).fun
            for start in self.robot.random_configuration(np.random.default_rng(0), size=config.STARTS)
        ]
        return np.sort(found)[::-1]

    def controller(
        self,
        formulation: mp.formulations.Formulation,
        *,
        dt: float = config.DT,
        approach: float = config.DEAD_BEAT,
        tube: bool = False,
        avoidance: mp.Avoidance | None = None,
        compiled: bool = True,
    ) -> mp.Controller:
        """The controller for these options, created once."""
        key = (formulation, dt, approach, tube, avoidance, compiled)
        if key not in self.made:
            self.made[key] = mp.Controller(
                self.robot,
                formulation,
                dt=dt,
                task=config.TASK,
                approach=approach,
                tolerance=mp.Tolerance(position=config.TUBES[0]) if tube else None,
                avoidance=avoidance,
                compiled="auto" if compiled else False,
            )
        return self.made[key]

    def follow(
        self,
        name: str,
        formula: str,
        strength: float,
        *,
        tube: float | None = None,
        formulation: mp.formulations.Formulation | None = None,
        dt: float = config.DT,
        approach: float = config.DEAD_BEAT,
        avoidance: mp.Avoidance | None = None,
        compiled: bool = True,
        nudge: float | Array = 0.0,
    ) -> Run:
        """Follow the course `name` with FORMULAS[formula], or with `formulation` under that name, inside a tube [m] if given.

        `nudge` [rad], a number or one per joint, is added to the first posture.
        """
        course = self.courses[name]
        controller = self.controller(
            formulation or FORMULAS[formula],
            dt=dt,
            approach=approach,
            tube=tube is not None,
            avoidance=avoidance,
            compiled=compiled,
        )
        targets, stiffness, drive, steps = timed(course, dt, strength)
        rollout = controller.rollout(
            course.start + nudge,
            targets,
            stiffness=stiffness,
            drive=drive,
            tolerance=mp.Tolerance(position=tube) if tube is not None else None,
        )
        poses = self.kinematics.pose(rollout.q)
        wanted = np.concatenate([course.path(0.0)[None], targets])
        return Run(
            course=course,
            formula=formula,
            strength=strength,
            t=dt * np.arange(len(poses), dtype=np.float64),
            q=rollout.q,
            qd=rollout.qd,
            manipulability=self.kinematics.manipulability(rollout.q) / self.maxima[0],
            poses=poses,
            targets=wanted,
            deviation=np.linalg.norm(poses[:, :3, 3] - wanted[:, :3, 3], axis=1),
            rotation=angles(poses, wanted),
            rollout=rollout,
            steps=steps,
        )

    def torque(self, run: Run) -> float:
        """Root mean square of the joint torques on the path [N m], by Pinocchio's inverse dynamics."""
        last = len(run.acceleration)
        return rms_torque(self.robot, run.q[:last], run.qd[:last], run.acceleration)

    def step_times(
        self,
        name: str,
        formula: str,
        strength: float,
        *,
        dt: float = config.DT,
        avoidance: mp.Avoidance | None = None,
        compiled: bool = True,
    ) -> Array:
        """Wall time of every step on the path, called one by one from Python [s]."""
        course = self.courses[name]
        controller = self.controller(FORMULAS[formula], dt=dt, avoidance=avoidance, compiled=compiled)
        controller.reset()
        targets, stiffness, drive, steps = timed(course, dt, strength)
        q, qd, times = course.start, np.zeros(self.robot.n), np.zeros(steps)
        for k in range(steps):
            began = time.perf_counter()
            qd = controller.step(q, qd, targets[k], stiffness=stiffness[k], drive=drive[k])
            times[k] = time.perf_counter() - began
            q = q + dt * qd
        return times


def rms_torque(robot: mp.Robot, q: Array, qd: Array, qdd: Array) -> float:
    """Root mean square of the joint torques of a motion (N, n) [N m], by Pinocchio's inverse dynamics."""
    data = robot.model.createData()
    return float(np.sqrt(np.mean([pin.rnea(robot.model, data, *each) ** 2 for each in zip(q, qd, qdd, strict=True)])))


def timed(course: Course, dt: float, strength: float) -> tuple[Array, Array, Array, int]:
    """Targets (N, 4, 4), stiffness and drive (N,) of every step, and the number of steps on the path, with cubic timing."""
    steps, more = round(course.duration / dt), round(config.SETTLING / dt)
    u = np.arange(1, steps + 1) / steps
    on_path = course.path(np.minimum(3 * u**2 - 2 * u**3, 1.0))
    targets = np.concatenate([on_path, np.repeat(on_path[-1:], more, axis=0)])
    stiffness = np.concatenate([[config.STIFFNESS(share) for share in u], np.full(more, config.HOLD)])
    drive = np.concatenate([np.full(steps, strength), np.zeros(more)])
    return targets, stiffness, drive, steps


def angles(poses: Array, targets: Array) -> Array:
    """Angle (N,) [rad] between the rotations of two sequences of poses."""
    chord = np.linalg.norm(poses[:, :3, :3] - targets[:, :3, :3], axis=(1, 2)) / np.sqrt(8)
    return np.asarray(2 * np.arcsin(np.minimum(chord, 1.0)))
