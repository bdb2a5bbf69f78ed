"""A trajectory at the rate of a controller, and what every such format asks for."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from manipplan.paths.trajectory import Trajectory
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError

#: Speed at the ends up to which a motion counts as one from rest to rest [rad/s or m/s].
AT_REST = 1e-6
#: Largest number of positions in a file.
MOST = 300_000


@dataclass(frozen=True, kw_only=True, eq=False)
class ControllerFormat:
    """What a controller takes.

    Attributes:
        name: for messages.
        joints: for each joint in its order, the ends of the names by which it is known.
        lower, upper: (n,) joint limits [rad].
    """

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
