"""A trajectory at the rate of a controller, and what every such format asks for."""

import numpy as np

from manipplan.paths.trajectory import Trajectory
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError

#: Speed at the ends up to which a motion counts as one from rest to rest [rad/s or m/s].
AT_REST = 1e-6


def sampled(trajectory: Trajectory, joints: int, rate: float, controller: str) -> Array:
    """The positions (m, n) at multiples of 1 / rate [s]; the last one is the end, and comes at most one step late.

    Raises InvalidInputError for another number of joints, or a motion that does not begin and end at rest.
    """
    if trajectory.n != joints:
        wanted = f"a motion of the {joints} joints of {controller}"
        raise InvalidInputError("trajectory", f"{trajectory.n} joints: {', '.join(trajectory.joint_names)}", wanted)
    for name, speeds in (("start", trajectory.qd[0]), ("end", trajectory.qd[-1])):
        joint = int(np.abs(speeds).argmax())
        if abs(speeds[joint]) > AT_REST:
            got = f"{trajectory.joint_names[joint]} moves at {speeds[joint]:.4g} rad/s at its {name}"
            raise InvalidInputError("trajectory", got, f"a motion from rest to rest: {controller} begins and ends at rest")
    steps = int(np.ceil(trajectory.duration * rate - 1e-9))
    times = np.minimum(np.arange(steps + 1) / rate, trajectory.duration)
    return trajectory(times)
