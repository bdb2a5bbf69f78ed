"""How well the tools of a motion keep their poses to each other."""

from collections.abc import Mapping

import numpy as np
import pinocchio as pin

from manipplan.paths.deviation import angles_between
from manipplan.paths.tolerance import Tolerance
from manipplan.robots.model_tree import frame_index
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array

#: Share of a tolerance that one tool may use on its own path: the errors of two add up, and timing needs some of it.
SHARE = 0.2


def tool_poses(robot: Robot, q: Array) -> dict[str, Array]:
    """The poses (k, 4, 4) of all tools at configurations (k, n), by Pinocchio's own kinematics."""
    data, frames = robot.model.createData(), [frame_index(robot.model, tool) for tool in robot.tools]
    found = np.empty((len(frames), len(q), 4, 4))
    for row, each in enumerate(q):
        pin.framesForwardKinematics(robot.model, data, np.asarray(each))
        for k, frame in enumerate(frames):
            found[k, row] = data.oMf[frame].homogeneous
    return dict(zip(robot.tools, found, strict=True))


def held_errors(poses: Mapping[str, Array], grasps: Mapping[str, Array]) -> dict[str, tuple[float, float]]:
    """Largest distance [m] and angle [rad] of each further tool from where the grasps have it, seen from the first tool.

    Args:
        poses: (k, 4, 4) of each tool.
        grasps: (4, 4) of each tool in the object.
    """
    first, *others = grasps
    errors = {}
    for tool in others:
        wanted = np.linalg.inv(grasps[first]) @ grasps[tool]
        seen = np.linalg.inv(poses[first]) @ poses[tool]
        position = np.linalg.norm(seen[:, :3, 3] - wanted[:3, 3], axis=1)
        errors[tool] = float(position.max()), float(angles_between(seen[:, :3, :3], wanted[:3, :3], None).max())
    return errors


def tool_tolerance(tolerance: Tolerance, grasps: Mapping[str, Array]) -> Tolerance:
    """The tolerance of each tool on its own path, with which the tools keep theirs to each other.

    An angle of one tool moves the place of another, seen from it, by the angle times their distance.
    """
    assert tolerance.position is not None and tolerance.rotation is not None
    places = [grasp[:3, 3] for grasp in grasps.values()]
    far = max(float(np.linalg.norm(a - b)) for a in places for b in places)
    position = SHARE * tolerance.position
    return Tolerance(position=position, rotation=min(SHARE * tolerance.rotation, position / max(far, 1e-3)))
