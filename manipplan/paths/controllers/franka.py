"""A table of joint positions at 1 kHz, as the position interfaces of the Franka Panda and the Franka Research 3 take them."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from manipplan.paths.controllers.sampled import ControllerFormat, sampled
from manipplan.paths.trajectory import Trajectory
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError
from manipplan.support.files import write_text

#: Rate of the interface [Hz].
RATE = 1000
UNITS = {"velocity": "rad/s", "acceleration": "rad/s²", "jerk": "rad/s³"}
#: Share of a limit that counts as kept: positions are written to 1e-12 rad, whose third difference is 8e-3 rad/s³.
KEPT = 1 + 1e-5


@dataclass(frozen=True, kw_only=True, eq=False)
class Arm:
    """What an arm accepts, by differences of neighbouring positions.

    Attributes:
        controller: its joints, by the names in franka_description, with their position limits.
        velocity, acceleration, jerk: (7,) largest joint velocities [rad/s], accelerations [rad/s²] and jerks [rad/s³].
        braking: a, b, upper, lower (7,) each: towards a limit the velocity is at most sqrt(b d) - a, with d the
            distance from `upper` or `lower` [rad]; None where the velocity limits do not depend on the position.
    """

    controller: ControllerFormat
    velocity: Array
    acceleration: Array
    jerk: Array
    braking: tuple[Array, Array, Array, Array] | None = None

    def velocities(self, q: Array) -> tuple[Array, Array]:
        """The lowest and the highest velocity (m - 1, 7) between neighbouring positions q (m, 7), the stricter of both."""
        if self.braking is None:
            return -self.velocity + 0 * q[1:], self.velocity + 0 * q[1:]
        a, b, upper, lower = self.braking
        room = upper - np.maximum(q[:-1], q[1:]), np.minimum(q[:-1], q[1:]) - lower
        high, low = (np.clip(np.sqrt(b * np.maximum(each, 0.0)) - a, 0.0, self.velocity) for each in room)
        return -low, high


#: libfranka 0.9, franka/rate_limiting.h.
PANDA = Arm(
    controller=ControllerFormat(
        name="a Franka Panda",
        joints=tuple((f"panda_joint{k}", f"fer_joint{k}") for k in range(1, 8)),
        lower=np.array([-2.8973, -1.7628, -2.8973, -3.0718, -2.8973, -0.0175, -2.8973]) - 1e-9,
        upper=np.array([2.8973, 1.7628, 2.8973, -0.0698, 2.8973, 3.7525, 2.8973]) + 1e-9,
    ),
    velocity=np.array([2.175, 2.175, 2.175, 2.175, 2.61, 2.61, 2.61]),
    acceleration=np.array([15.0, 7.5, 10.0, 12.5, 15.0, 20.0, 20.0]),
    jerk=np.array([7500.0, 3750.0, 5000.0, 6250.0, 7500.0, 10000.0, 10000.0]),
)
#: Franka Robotics, control interface, limits of the Franka Research 3; libfranka 0.10, franka/rate_limiting.h.
FR3 = Arm(
    controller=ControllerFormat(
        name="a Franka Research 3",
        joints=tuple((f"fr3_joint{k}",) for k in range(1, 8)),
        lower=np.array([-2.7437, -1.7837, -2.9007, -3.0421, -2.8065, 0.5445, -3.0159]) - 1e-9,
        upper=np.array([2.7437, 1.7837, 2.9007, -0.1518, 2.8065, 4.5169, 3.0159]) + 1e-9,
    ),
    velocity=np.array([2.62, 2.62, 2.62, 2.62, 5.26, 4.18, 5.26]),
    acceleration=np.full(7, 10.0),
    jerk=np.full(7, 5000.0),
    braking=(
        np.array([0.30, 0.20, 0.20, 0.30, 0.35, 0.35, 0.35]),
        np.array([12.0, 5.17, 7.0, 8.0, 34.0, 11.0, 34.0]),
        np.array([2.7501, 1.7918, 2.9065, -0.1458, 2.8101, 4.5205, 3.0196]),
        np.array([-2.7501, -1.7918, -2.9065, -3.0481, -2.8101, 0.54092, -3.0196]),
    ),
)


def to_franka_csv(trajectory: Trajectory, file: str | Path) -> None:
    """Write the table; see `Trajectory.to_franka_csv`."""
    arm = FR3 if any(name.endswith("fr3_joint1") for name in trajectory.joint_names) else PANDA
    q = sampled(trajectory, arm.controller, RATE)
    values = np.concatenate([np.repeat(q[:1], 3, axis=0), q, np.repeat(q[-1:], 3, axis=0)])  # it stands before and afterwards
    low, high = arm.velocities(values)
    bounds = {"velocity": (low, high), "acceleration": (-arm.acceleration, arm.acceleration), "jerk": (-arm.jerk, arm.jerk)}
    for order, (kind, (least, most)) in enumerate(bounds.items(), start=1):
        values = np.diff(values, axis=0) * RATE
        allowed = np.where(values < 0, -least, most)
        excess = np.abs(values) - KEPT * allowed
        row, joint = (int(k) for k in np.unravel_index(int((excess / getattr(arm, kind)).argmax()), excess.shape))
        if excess[row, joint] > 0:
            at = max(row - 3 + order // 2, 0) / RATE
            where = " at this position" if kind == "velocity" and arm.braking is not None else ""
            raise InvalidInputError(
                f"trajectory (joint {joint + 1} at {at:.3f} s)",
                f"{'an' if kind == 'acceleration' else 'a'} {kind} of {abs(values[row, joint]):.5g} {UNITS[kind]}",
                f"at most {allowed[row, joint]:.6g} {UNITS[kind]}{where}; retime it with jerk limits, or make it slower",
            )
    header = ",".join(["time", *(f"joint{k}" for k in range(1, 8))])
    rows = [f"{k / RATE:.3f}," + ",".join(f"{value:.12f}" for value in each) for k, each in enumerate(q.tolist())]
    write_text(file, "\n".join([header, *rows]) + "\n")
