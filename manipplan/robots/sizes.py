"""Bodies of implausible size: a mesh in millimetres that is read in metres is 1,000 times too large and too far away."""

from pathlib import Path

import coal
import numpy as np
import pinocchio as pin

from manipplan.robots.hulls import FARTHEST, box_around
from manipplan.robots.model_tree import is_prismatic
from manipplan.support.errors import FileFormatError

#: A body may be as long, and as far from its link, as this many times the length of the arm, or as `ROOM` [m].
REACHES, ROOM = 10.0, 5.0
#: Widest range of a slide that counts as a length of the arm [m]; wider ones are written where there is no limit.
TRAVEL = 1000.0


def check_sizes(file: Path, model: pin.Model, geometry: pin.GeometryModel) -> None:
    """Raise FileFormatError for a body that is larger, or farther from its link, than the arm makes plausible.

    Such a body is drawn in another unit. What stands on no joint, such as a floor, may be large if it is no mesh.
    """
    reach, travel = _reach(model)
    most = max(REACHES * reach, travel, ROOM)
    for item in geometry.geometryObjects:
        if isinstance(item.geometry, coal.Halfspace | coal.Plane) or item.parentFrame == 0:  # the world of an MJCF
            continue
        low, high = box_around(item.geometry)
        frame = model.frames[item.parentFrame]
        link = (frame.placement.inverse() * item.placement).inverse().translation  # the origin of the link in the body
        distance = float(np.linalg.norm(np.clip(link, low, high) - link))
        size = float((high - low).max())
        is_mesh = isinstance(item.geometry, coal.BVHModelBase)
        largest = most if item.parentJoint or is_mesh else FARTHEST
        if size > largest or distance > most:
            fault = f"is {size:.3g} m long" if size > largest else f"is {distance:.3g} m away from its link"
            which = f"mesh {item.meshPath}".strip() if is_mesh else f"a {type(item.geometry).__name__}"
            unit = 'scale="0.001 0.001 0.001" in its <mesh> reads millimetres' if is_mesh else "lengths are in metres"
            wanted = (
                f"bodies within {most:.3g} m, {REACHES:g} times the length of the arm or {ROOM:g} m; "
                f"body {item.name} of link {frame.name} ({which}) {fault}. Is it in another unit? {unit}"
            )
            raise FileFormatError("file", str(file), wanted)


def _reach(model: pin.Model) -> tuple[float, float]:
    """The length of the longest chain of links, and the widest range of a slide below `TRAVEL` [m]."""
    lengths, travel = [0.0], 0.0
    for k in range(1, model.njoints):
        joint = model.joints[k]
        lengths.append(lengths[model.parents[k]] + float(np.linalg.norm(model.jointPlacements[k].translation)))
        if is_prismatic(joint):
            width = float(model.upperPositionLimit[joint.idx_q] - model.lowerPositionLimit[joint.idx_q])
            travel = max(travel, width) if width < TRAVEL else travel
    ends = (lengths[frame.parentJoint] + float(np.linalg.norm(frame.placement.translation)) for frame in model.frames)
    return max(ends), travel
