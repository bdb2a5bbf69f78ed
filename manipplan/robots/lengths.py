"""How far the tool of a robot can be from its joints."""

import numpy as np

from manipplan.robots.model_tree import frame_index
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array


def lengths_beyond(robot: Robot, tool: str) -> Array:
    """An upper bound on the distance of a tool from the origin of each joint (n,) [m]; 0 for joints that do not move it.

    It is the sum of the lengths of the links beyond the joint and of the travel of slides, its own included.
    """
    model, lengths = robot.model, np.zeros(robot.n)
    frame = model.frames[frame_index(model, tool)]
    length, joint = float(np.linalg.norm(frame.placement.translation)), int(frame.parentJoint)
    while joint > 0:
        if robot.joint_types[joint - 1] == "prismatic":
            length += float(max(abs(robot.limits.lower[joint - 1]), abs(robot.limits.upper[joint - 1])))
        lengths[joint - 1] = length
        length += float(np.linalg.norm(model.jointPlacements[joint].translation))
        joint = int(model.parents[joint])
    return lengths
