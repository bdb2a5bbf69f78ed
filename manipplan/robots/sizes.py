"""Implausible bodies and links: what is in millimetres and read in metres is 1,000 times too large and too far away."""

import logging
from pathlib import Path

import coal
import numpy as np
import pinocchio as pin

from manipplan.robots.hulls import FARTHEST, box_around
from manipplan.robots.model_tree import is_prismatic, parent_bodies
from manipplan.support.checks import Array
from manipplan.support.errors import FileFormatError

log = logging.getLogger("manipplan")

#: A body may be as long, and as far from its link, as this many times the length of the arm, or as `ROOM` [m].
REACHES, ROOM = 10.0, 5.0
#: A moving body longer than this many times the arm, and a mesh shorter than this share of it, are named in the log.
LONG, SHORT = 2.0, 1e-3
#: Widest range of a slide that counts as a length of the arm [m]; wider ones are written where there is no limit.
TRAVEL = 1000.0
#: A moving link may be as far from its parent as this many times the median of the robot's links, or as `ROOM` [m].
MEDIANS = 30.0
#: Largest distance of any link from its parent, and largest length of an arm [m].
LONGEST = 100.0


def check_origins(file: Path, model: pin.Model, geometry: pin.GeometryModel) -> None:
    """Raise FileFormatError for a link that is farther from its parent than the rest of the robot makes plausible.

    The origin of its joint is in another unit. As far as a slide travels, or a moving body is long, a link may always be away;
    where the robot stands, by links that no joint moves, it may be anywhere within `LONGEST`.
    """
    parents, offsets = parent_bodies(model), _offsets(model)
    lengths = {body: float(np.linalg.norm(offset)) for body, offset in offsets.items()}
    sizes = (float(np.ptp(box_around(item.geometry), axis=0).max()) for item in geometry.geometryObjects if item.parentJoint)
    span = max(_travel(model), max((size for size in sizes if size <= LONGEST), default=0.0))
    arm = {0: 0.0}
    for body, above in parents.items():
        arm[body] = arm[above] + lengths[body] if model.frames[body].parentJoint and above else 0.0
    for body in sorted((each for each in parents if lengths[each] > ROOM), key=lambda each: -lengths[each]):
        others = [length for each, length in lengths.items() if each != body and length > 0]
        most = max(LONGEST, span)
        if arm[body] and others:
            most = max(min(max(MEDIANS * float(np.median(others)), ROOM), LONGEST), span)
        wanted = f"links within {most:.3g} m of their parents"
        if lengths[body] <= most:
            if not arm[body] or max(arm.values()) <= max(LONGEST, span):
                continue
            wanted = f"an arm of at most {max(LONGEST, span):g} m, not {max(arm.values()):.3g} m"
        xyz = " ".join(f"{each:g}" for each in np.round(offsets[body], 9) + 0.0)
        joint, link = (model.frames[each].name for each in (model.frames[body].parentFrame, body))
        wanted += f"; joint {joint} has link {link} at {xyz} in its parent. Origins are in metres; "
        wanted += f"{np.abs(offsets[body]).max():g} looks like millimetres"
        raise FileFormatError("file", str(file), wanted)


def _offsets(model: pin.Model) -> dict[int, Array]:
    """The origin (3,) [m] of each body, by its frame, in the frame of its parent, all joints at 0."""
    frames = [pin.SE3.Identity()]
    for j in range(1, model.njoints):
        frames.append(frames[model.parents[j]] * model.jointPlacements[j])
    parents = parent_bodies(model)
    poses = {body: frames[model.frames[body].parentJoint] * model.frames[body].placement for body in (0, *parents)}
    return {body: np.asarray(poses[above].actInv(poses[body].translation)) for body, above in parents.items()}


def check_sizes(file: Path, model: pin.Model, geometry: pin.GeometryModel) -> None:
    """Raise FileFormatError for a body that is larger, or farther from its link, than the arm makes plausible.

    Such a body is drawn in another unit. What stands on no joint, such as a floor, may be large if it is no mesh. Bodies that
    are large or small, but not as much, are named in the log.
    """
    most, reach = largest_size(model), _reach(model)
    odd = []
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
        if (item.parentJoint and size > max(LONG * reach, _travel(model))) or (is_mesh and size < SHORT * reach):
            odd.append(f"{item.name} of link {frame.name} is {size:.2g} m long")
    if odd and _reach(model, base=False) > 0:
        log.warning(
            "%s: lengths are in metres; beside an arm of %.2g m these look like another unit: %s",
            file,
            reach,
            "; ".join(odd[:12]),
        )


def largest_size(model: pin.Model) -> float:
    """The size [m] up to which a body of this arm is plausible."""
    return max(REACHES * _reach(model), _travel(model), ROOM)


def _reach(model: pin.Model, *, base: bool = True) -> float:
    """The length of the longest chain of links [m], with or without the way from the base to the first joint."""
    lengths = [0.0]
    for k in range(1, model.njoints):
        link = float(np.linalg.norm(model.jointPlacements[k].translation)) if base or model.parents[k] else 0.0
        lengths.append(lengths[model.parents[k]] + link)
    ends = (lengths[frame.parentJoint] + float(np.linalg.norm(frame.placement.translation)) for frame in model.frames)
    return max(ends, default=0.0)


def _travel(model: pin.Model) -> float:
    """The widest range of a slide below `TRAVEL` [m]; 0 without one."""
    slides = [joint.idx_q for joint in list(model.joints)[1:] if is_prismatic(joint)]
    ranges = (float(model.upperPositionLimit[k] - model.lowerPositionLimit[k]) for k in slides)
    return max((width for width in ranges if width < TRAVEL), default=0.0)
