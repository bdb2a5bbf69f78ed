"""A table of joint positions at 1 kHz, as the position interface of a Franka arm takes them."""

from pathlib import Path

import numpy as np

from manipplan.paths.controllers.sampled import Controller, sampled
from manipplan.paths.trajectory import Trajectory
from manipplan.support.errors import InvalidInputError
from manipplan.support.files import write_text

#: Rate of the interface [Hz].
RATE = 1000
#: The arm, by the names of its joints in franka_description, with its joint limits.
PANDA = Controller(
    name="a Franka Panda",
    joints=tuple((f"panda_joint{k}", f"fer_joint{k}") for k in range(1, 8)),
    lower=np.array([-2.8973, -1.7628, -2.8973, -3.0718, -2.8973, -0.0175, -2.8973]) - 1e-9,
    upper=np.array([2.8973, 1.7628, 2.8973, -0.0698, 2.8973, 3.7525, 2.8973]) + 1e-9,
)
#: Largest joint velocities [rad/s], accelerations [rad/s²] and jerks [rad/s³] that libfranka 0.9 accepts for a Panda
#: (franka/rate_limiting.h), by differences of neighbouring positions.
LIMITS = {
    "velocity": np.array([2.175, 2.175, 2.175, 2.175, 2.61, 2.61, 2.61]),
    "acceleration": np.array([15.0, 7.5, 10.0, 12.5, 15.0, 20.0, 20.0]),
    "jerk": np.array([7500.0, 3750.0, 5000.0, 6250.0, 7500.0, 10000.0, 10000.0]),
}
UNITS = {"velocity": "rad/s", "acceleration": "rad/s²", "jerk": "rad/s³"}
#: Share of a limit that counts as kept: positions are written to 1e-12 rad, whose third difference is 8e-3 rad/s³.
KEPT = 1 + 1e-5


def to_franka_csv(trajectory: Trajectory, file: str | Path) -> None:
    """Write the table; see `Trajectory.to_franka_csv`."""
    q = sampled(trajectory, PANDA, RATE)
    still = np.repeat(q[:1], 3, axis=0), np.repeat(q[-1:], 3, axis=0)
    values = np.concatenate([still[0], q, still[1]])  # the arm stands before and afterwards
    for order, (kind, most) in enumerate(LIMITS.items(), start=1):
        values = np.diff(values, axis=0) * RATE
        share = np.abs(values) / most
        row, joint = (int(k) for k in np.unravel_index(int(share.argmax()), share.shape))
        if share[row, joint] > KEPT:
            at = max(row - 3 + order // 2, 0) / RATE
            raise InvalidInputError(
                f"trajectory (joint {joint + 1} at {at:.3f} s)",
                f"a {kind} of {abs(values[row, joint]):.5g} {UNITS[kind]}",
                f"at most {most[joint]:g} {UNITS[kind]}; retime it with jerk limits, or make it slower",
            )
    header = ",".join(["time", *(f"joint{k}" for k in range(1, 8))])
    rows = [f"{k / RATE:.3f}," + ",".join(f"{value:.12f}" for value in each) for k, each in enumerate(q.tolist())]
    write_text(file, "\n".join([header, *rows]) + "\n")
