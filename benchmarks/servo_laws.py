"""Laws beside which servo.py measures `mp.Servo`: our controller, and rules of the literature as papers state them."""

from collections.abc import Callable

import numpy as np
from servo_judge import DT, SCALE, Arm, Array, Law, moved

import manipplan as mp


def robot_of(name: str) -> mp.Robot:
    """The arm without jerk limits, which no law of the comparison but ours keeps."""
    return mp.load_robot(name).with_limits(jerk=np.inf)


class Ours:
    """`mp.Servo` with its defaults."""

    def __init__(self, arm: Arm) -> None:
        self.servo, self.halted = mp.Servo(robot_of(arm.name), dt=DT), False

    def reset(self) -> None:
        self.servo.reset()

    def step(self, q: Array, qd: Array, twist: Array) -> Array:
        velocity = self.servo.step(q, qd, twist, "world")
        self.halted = self.servo.status != 0
        return velocity


class General:
    """`mp.Controller` towards the pose one step ahead, without a drive and without a braked approach."""

    def __init__(self, arm: Arm) -> None:
        task = mp.Task.pose(0.3) if len(arm.rows) == 6 else None
        self.arm = arm
        self.controller = mp.Controller(robot_of(arm.name), mp.formulations.General(), dt=DT, approach=np.inf, task=task)

    def reset(self) -> None:
        self.controller.reset()

    def step(self, q: Array, qd: Array, twist: Array) -> Array:
        return self.controller.step(q, qd, moved(self.arm.pose(q), twist, DT).homogeneous)


class Rule:
    """A rule that knows no limits but slows down uniformly until the velocity limits hold."""

    def __init__(self, arm: Arm) -> None:
        self.arm = arm

    def reset(self) -> None:
        pass

    def slower(self, velocity: Array) -> Array:
        return np.asarray(velocity / max(1.0, (np.abs(velocity) / self.arm.velocity).max()))


class PseudoInverse(Rule):
    def step(self, q: Array, qd: Array, twist: Array) -> Array:  # noqa: ARG002
        return self.slower(np.linalg.pinv(self.arm.jacobian(q), rcond=1e-10) @ self.arm.scaled(twist))


class Damped(Rule):
    """Least squares damped by the smallest singular value [nakamura1986]: λ² = (1 - (σ / ε)²) λ₀² below ε = λ₀ = 0.04."""

    def step(self, q: Array, qd: Array, twist: Array) -> Array:  # noqa: ARG002
        left, sigma, right = np.linalg.svd(self.arm.jacobian(q), full_matrices=False)
        damping = max(0.0, 1 - (sigma[-1] / 0.04) ** 2) * 0.04**2
        return self.slower(right.T @ (sigma / (sigma**2 + damping + 1e-15) * (left.T @ self.arm.scaled(twist))))


class JParse(Rule):
    """J-PARSE (arXiv 2505.00306) with γ = 0.1 and gain 1, on the rows in metres and radians."""

    def step(self, q: Array, qd: Array, twist: Array) -> Array:  # noqa: ARG002
        jacobian = self.arm.jacobian(q) / SCALE[self.arm.rows, None]
        left, sigma, right = np.linalg.svd(jacobian, full_matrices=False)
        ratio = sigma / sigma[0]
        small = ratio <= 0.1
        along = left.T @ twist[self.arm.rows]
        rates = np.where(small, ratio / 0.1 * along, along) / np.where(small, 0.1 * sigma[0], sigma)
        return self.slower(right.T @ rates)


class MoveItServo(Rule):
    """The rule of MoveIt Servo's documentation: slower between condition numbers 17 and 30, leaving twice as far."""

    def step(self, q: Array, qd: Array, twist: Array) -> Array:  # noqa: ARG002
        jacobian = self.arm.jacobian(q) / SCALE[self.arm.rows, None]
        left, sigma, right = np.linalg.svd(jacobian, full_matrices=False)
        inverse = (right.T / np.maximum(sigma, 1e-12)) @ left.T
        condition, toward = sigma[0] / max(sigma[-1], 1e-12), left[:, -1]
        ahead = np.linalg.svd(self.arm.jacobian(q + inverse @ toward / 100) / SCALE[self.arm.rows, None], compute_uv=False)
        if ahead[0] / max(ahead[-1], 1e-12) <= condition:
            toward = -toward
        hard = 30.0 if toward @ twist[self.arm.rows] > 0 else 17.0 + 2 * (30.0 - 17.0)
        share = 1.0 if condition <= 17 else 0.0 if condition >= 30 else 1 - (condition - 17) / (hard - 17)
        velocity = self.slower(inverse @ twist[self.arm.rows] * share)
        stops = ((velocity < 0) & (q < self.arm.lower + 0.1)) | ((velocity > 0) & (q > self.arm.upper - 0.1))
        return np.zeros_like(velocity) if stops.any() else velocity


LAWS: dict[str, Callable[[Arm], Law]] = {
    "`mp.Servo`": Ours,
    "`mp.Controller`, `General`, one step ahead": General,
    "damped least squares, adaptive": Damped,
    "pseudo-inverse, scaled": PseudoInverse,
    "J-PARSE, γ = 0.1": JParse,
    "MoveIt Servo's rule": MoveItServo,
}
