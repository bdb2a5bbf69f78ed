"""Motions as files that robot controllers run.

URScript, whose program follows a motion by servoj, and tables at 1 kHz, as a Franka arm's position interface takes them.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from manipplan.paths.trajectory import Trajectory
from manipplan.support.checks import Array, number
from manipplan.support.errors import InvalidInputError
from manipplan.support.files import write_text
from manipplan.support.untrusted import is_identifier

#: Speed at the ends up to which a motion counts as one from rest to rest [rad/s or m/s].
AT_REST = 1e-6
#: Largest number of positions in a file.
MOST = 300_000


@dataclass(frozen=True, kw_only=True, eq=False)
class ControllerFormat:
    """What a controller takes: of each joint in its order the ends of its possible names, and joint limits (n,) [rad]."""

    name: str
    joints: tuple[tuple[str, ...], ...]
    lower: Array
    upper: Array


def sampled(trajectory: Trajectory, controller: ControllerFormat, rate: float) -> Array:
    """The positions (m, n) at multiples of 1 / rate [s], in the controller's order; the last one is the end of the motion.

    Raises InvalidInputError for other joints, positions outside the limits, a motion that does not begin and end at rest, or
    one of more than MOST positions.
    """
    columns = _columns(trajectory.joint_names, controller)
    for name, speeds in (("start", trajectory.qd[0]), ("end", trajectory.qd[-1])):
        joint = int(np.abs(speeds).argmax())
        if abs(speeds[joint]) > AT_REST:
            got = f"{trajectory.joint_names[joint]} moves at {speeds[joint]:.4g} rad/s at its {name}"
            raise InvalidInputError("trajectory", got, f"a motion from rest to rest: {controller.name} begins and ends at rest")
    steps = int(np.ceil(trajectory.duration * rate - 1e-9))
    if steps >= MOST:
        wanted = f"at most {MOST / rate:g} s: {MOST:,} positions at {rate:g} Hz"
        raise InvalidInputError("trajectory", f"a motion of {trajectory.duration:.4g} s", wanted)
    q = trajectory(np.minimum(np.arange(steps + 1) / rate, trajectory.duration))[:, columns]
    outside = np.maximum(q - controller.upper, controller.lower - q)
    row, joint = (int(k) for k in np.unravel_index(int(outside.argmax()), outside.shape))
    if outside[row, joint] > 0:
        raise InvalidInputError(
            f"trajectory ({trajectory.joint_names[columns[joint]]} at {row / rate:.3f} s)",
            float(q[row, joint]),
            f"joint values of {controller.name} from {controller.lower[joint]:.4f} to {controller.upper[joint]:.4f} rad",
        )
    return q


def _columns(names: Sequence[str], controller: ControllerFormat) -> list[int]:
    """For each joint of the controller the column of the trajectory."""
    found = [[k for k, name in enumerate(names) if name.endswith(ends)] for ends in controller.joints]
    if len(names) != len(found) or any(len(each) != 1 for each in found):
        wanted = ", ".join(f"...{ends[0]}" for ends in controller.joints)
        raise InvalidInputError(
            "trajectory.joint_names", ", ".join(names), f"the joints of {controller.name}: names that end in {wanted}"
        )
    return [each[0] for each in found]


#: Rate of the interface [Hz].
RATE = 1000
UNITS = {"velocity": "rad/s", "acceleration": "rad/s²", "jerk": "rad/s³"}
#: Share of a limit that counts as kept: positions are written to 1e-12 rad, whose third difference is 8e-3 rad/s³.
LIMIT_MARGIN = 1 + 1e-5


@dataclass(frozen=True, kw_only=True, eq=False)
class Arm:
    """What an arm accepts, by differences of neighbouring positions: (7,) in rad/s, rad/s² and rad/s³.

    `braking` is a, b, upper, lower (7,) each: towards a limit the velocity is at most sqrt(b d) - a, with d the distance from
    `upper` or `lower` [rad]; None where the velocity limits do not depend on the position.
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
        excess = np.abs(values) - LIMIT_MARGIN * allowed
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


#: Rates of the controllers: CB3, and e-Series [Hz].
RATES = (125, 500)
#: Distance of a joint from the first configuration up to which the program begins [rad].
NEAR = 0.01
#: The arms, and the largest speed of any of their joints, that of the UR3's wrist [rad/s].
UR = ControllerFormat(
    name="a UR arm",
    joints=tuple((f"{each}_joint",) for each in ("shoulder_pan", "shoulder_lift", "elbow", "wrist_1", "wrist_2", "wrist_3")),
    lower=np.full(6, -2 * np.pi - 1e-9),
    upper=np.full(6, 2 * np.pi + 1e-9),
)
FASTEST = 2 * np.pi
#: Ranges of servoj's arguments, by the manual of URScript.
LOOKAHEAD, GAIN = (0.03, 0.2), (100, 2000)


def to_urscript(trajectory: Trajectory, file: str | Path, *, rate: int, name: str, lookahead_time: float, gain: float) -> None:
    """Write the program; see `Trajectory.to_urscript`."""
    if isinstance(rate, bool) or not isinstance(rate, int | np.integer) or rate not in RATES:
        raise InvalidInputError("rate", rate, "125 (CB3) or 500 (e-Series) [Hz]")
    if not isinstance(name, str) or not is_identifier(name):
        raise InvalidInputError("name", name, "a name of letters, digits and underscores that begins with a letter")
    lookahead_time = number("lookahead_time", lookahead_time, least=LOOKAHEAD[0], most=LOOKAHEAD[1])
    gain = number("gain", gain, least=GAIN[0], most=GAIN[1])
    q = sampled(trajectory, UR, rate)
    speed = np.abs(np.diff(q, axis=0)).max(initial=0.0) * rate
    if speed > FASTEST:
        raise InvalidInputError("trajectory", f"a joint speed of {speed:.4g} rad/s", f"at most {FASTEST:.4g} rad/s")
    away = " or ".join(f"norm(here[{k}] - ({value!r})) > {NEAR!r}" for k, value in enumerate(q[0].tolist()))
    order = f"t={1 / rate!r}, lookahead_time={lookahead_time!r}, gain={gain:g}"
    lines = [
        f"# {len(q)} positions at {rate} Hz, {trajectory.duration:.4f} s",
        f"def {name}():",
        "  here = get_actual_joint_positions()",
        f"  if {away}:",
        '    popup("The arm is not where this motion begins.", title="manipplan", error=True, blocking=True)',
        "    halt",
        "  end",
        *(f"  servoj([{', '.join(repr(value) for value in each)}], {order})" for each in q.tolist()),
        "  stopj(2.0)",
        "end",
        f"{name}()",
    ]
    write_text(file, "\n".join(lines) + "\n")
