"""How far the tool of a motion is from a workspace path, and the path from where the tool comes past."""

import numpy as np

from manipplan.kinematics.kinematics import Kinematics
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.deviation import Deviation, angles_between, deviations, distances_from
from manipplan.paths.joint import JointPath
from manipplan.support.checks import Array

#: Maximum joint motion between two poses of the tool that are compared [rad or m], minimum number of these poses, and number of
#: poses of the path that the tool has to come past.
STEP, LEAST, POSES = 2e-3, 1500, 2001


def tool_deviation(
    path: JointPath, kinematics: Kinematics, workspace_path: CartesianPath, axis: Array | None, begin: float
) -> Deviation:
    """The largest distances of the tool from a workspace path, regardless of time; `..._at` is s of the joint path.

    What comes before s = `begin` of the joint path does not count. Of the tool's orientation only the direction of `axis` (3,)
    counts if given.
    """
    s = _samples(path, begin)
    return _largest(s, *deviations(workspace_path, kinematics.pose(path(s)), axis))


def missed_by(
    path: JointPath, kinematics: Kinematics, workspace_path: CartesianPath, axis: Array | None, begin: float
) -> Deviation:
    """The largest distances of poses of a workspace path from where the tool comes past; `..._at` is s of the workspace path.

    The first and the last pose are compared with those of the motion: a tool that stops early, or goes backwards, misses one.
    """
    way, poses = kinematics.pose(path(_samples(path, begin))), workspace_path.sample(POSES)
    position, rotation = distances_from(way, poses, axis)
    ends = [0, -1]
    position[ends] = np.linalg.norm(way[ends, :3, 3] - poses[ends, :3, 3], axis=1)
    rotation[ends] = angles_between(way[ends, :3, :3], poses[ends, :3, :3], axis)
    return _largest(np.linspace(0.0, 1.0, POSES), position, rotation)


def _samples(path: JointPath, begin: float) -> Array:
    """The s of the poses that are compared, from `begin` on."""
    s = np.unique(np.concatenate([np.linspace(begin, 1.0, LEAST), path.fine_samples(STEP)]))
    return np.asarray(s[s >= begin])


def _largest(at: Array, position: Array, rotation: Array) -> Deviation:
    far, turned = int(position.argmax()), int(rotation.argmax())
    return Deviation(
        position=float(position[far]),
        position_at=float(at[far]),
        rotation=float(rotation[turned]),
        rotation_at=float(at[turned]),
    )
