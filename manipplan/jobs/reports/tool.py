"""How far the tool of a motion is from a workspace path, and the path from where the tool comes past."""

from collections.abc import Sequence

import numpy as np

from manipplan.jobs.reports.along import PathPart
from manipplan.kinematics.kinematics import Kinematics
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.deviation import Deviation, beyond_polygon, deviations, distances_between, distances_from
from manipplan.paths.joint import JointPath
from manipplan.support.checks import Array

#: Maximum joint motion between two poses of the tool that are compared [rad or m], minimum number of these poses, and number of
#: evenly spaced poses of the path that the tool has to come past, beside those through which it was laid.
STEP, LEAST, POSES = 2e-3, 1500, 2001


def tool_distances(
    path: JointPath, duration: float, kinematics: Kinematics, workspace_path: CartesianPath, along: Sequence[PathPart]
) -> tuple[Deviation, Deviation]:
    """The largest distances of the tool from a workspace path, and of the path's poses from where the tool comes past.

    `..._at` is s of the joint path, and s of the workspace path. The first and the last pose of each part are compared with
    those of the motion: a tool that stops early, or goes backwards, misses one. What the task leaves free does not count.
    Where the path was laid through given poses, the tool is compared with these, too: it must not leave the neighbourhood of
    their polygon, and come past each of them.

    Args:
        path: the motion over its time, in shares of the duration [s].
        kinematics: with the task.
        along: the parts of the motion on which the tool follows the path; (): all of it.
    """
    free, fine = kinematics.free_motion, path.fine_samples(STEP)
    parts = along or (PathPart(begin=0.0, end=duration),)
    left, missed, ways = [], [], []
    for part in parts:
        begin, end = part.begin / duration, min(part.end / duration, 1.0)
        s = np.union1d(np.linspace(begin, end, LEAST // len(parts)), fine[(fine > begin) & (fine < end)])
        way, stretch = kinematics.pose(path(s)), workspace_path.part(part.s_begin, part.s_end)
        ways.append(way)
        left.append((s, *deviations(stretch, way, free)))
        places = np.union1d(np.linspace(0.0, 1.0, POSES // len(parts)), stretch.knots)
        poses = stretch(places)
        position, rotation = distances_from(way, poses, free)
        ends = [0, -1]
        position[ends], rotation[ends] = distances_between(way[ends], poses[ends], free)
        missed.append((part.s_begin + places * (part.s_end - part.s_begin), position, rotation))
    if workspace_path.given is not None:
        whole = np.concatenate(ways)
        left.append((np.concatenate([s for s, *_ in left]), *beyond_polygon(workspace_path.given, whole, free)))
        missed.append((workspace_path.knots, *distances_from(whole, workspace_path.given, free)))
    return _largest(left), _largest(missed)


def _largest(parts: list[tuple[Array, Array, Array]]) -> Deviation:
    """The largest distances of parts, each with the places and the distances there."""
    at, position, rotation = (np.concatenate(each) for each in zip(*parts, strict=True))
    far, turned = int(position.argmax()), int(rotation.argmax())
    return Deviation(
        position=float(position[far]),
        position_at=float(at[far]),
        rotation=float(rotation[turned]),
        rotation_at=float(at[turned]),
    )
