"""Robot descriptions: Pinocchio models with one plain number per joint, and how a URDF becomes one.

Implausible bodies and links: what is in millimetres and read in metres is 1,000 times too large and too far away.
"""

import logging
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import coal
import numpy as np
import pinocchio as pin

from manipplan.robots.hulls import FARTHEST, box_around
from manipplan.robots.model_tree import Mimic, is_prismatic, parent_bodies, plain_angles, read_mimics
from manipplan.robots.urdf import build_bodies, build_model, check_urdf, check_visuals, find_joined_links
from manipplan.robots.urdf_files import UrdfFiles
from manipplan.support.checks import Array
from manipplan.support.errors import FileFormatError, UnknownNameError

if TYPE_CHECKING:
    from manipplan.robots.robot import Robot

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


KINDS = ("catalogue", "urdf", "mjcf", "planar")
#: Options of `Robot.from_urdf` that are paths of files and folders.
FILES, FOLDERS, FOLDERS_BY_NAME = ("srdf",), ("package_dirs",), ("packages",)
#: Option that maps names to text.
TEXTS = "arguments"
#: Option that lets a file run code. It is never stored in a saved plan, nor read from one.
TRUST = "trust_file"


@dataclass(frozen=True, kw_only=True)
class RobotSource:
    """What an arm was read from, with the options that were given.

    Attributes:
        kind: one of `KINDS`.
        name: of kind "catalogue" the name that `load_robot` was given, also one of another collection; else "".
        file: absolute path of the URDF, xacro or MJCF file that was read; None for the planar arm.
        options: other given options, as plain numbers, strings, tuples and paths: tool, joints, srdf, name, locked, neutral,
            package_dirs, packages, meshes, collision, arguments, trust_file and limits of `Robot.from_urdf`; lengths and
            radius of `planar_arm`.
    """

    kind: str
    name: str = ""
    file: Path | None = None
    options: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise UnknownNameError("kind of a robot's source", str(self.kind), KINDS)

    @classmethod
    def of(cls, kind: str, file: str | Path | None, options: Mapping[str, Any], *, name: str = "") -> "RobotSource":
        """The source for the user's options; those that are None or empty are left out."""
        plain = {key: _plain(key, value) for key, value in options.items() if value is not None}
        given = {key: value for key, value in plain.items() if value not in ((), {})}
        path = Path(file).expanduser().resolve() if file is not None else None
        return cls(kind=kind, name=name, file=path, options=given)

    @property
    def urdf_files(self) -> UrdfFiles:
        """How a URDF or xacro file is read, and where its meshes are."""
        names = ("package_dirs", "packages", "collision", "arguments", "trust_file")
        return UrdfFiles(**{name: self.options[name] for name in names if name in self.options})

    def load(self) -> "Robot":
        """Build the arm again, with the limits and the neutral posture with which it was read.

        Raises FileFormatError or another InvalidInputError when a file no longer exists, or no longer fits the options.
        """
        from manipplan.robots.catalog import load_robot, planar_arm
        from manipplan.robots.robot import Robot

        if self.kind == "planar":
            return planar_arm(**self.options)
        if self.kind == "catalogue" or self.file is None:
            return load_robot(self.name, **self.options)
        return Robot.from_mjcf(self.file, **self.options) if self.kind == "mjcf" else Robot.from_urdf(self.file, **self.options)


def _plain(key: str, value: Any) -> Any:
    """The value of an option as plain numbers, strings, tuples and paths, independent of the caller's objects."""
    if key in FILES:
        return Path(value).expanduser().resolve()
    if key in FOLDERS:
        return tuple(Path(folder).expanduser().resolve() for folder in value)
    if key in FOLDERS_BY_NAME:
        return {str(name): Path(folder).expanduser().resolve() for name, folder in value.items()}
    if key == TEXTS:
        return {str(name): str(each) for name, each in value.items()}
    if isinstance(value, bool):
        return value
    if isinstance(value, Mapping):
        return {str(name): float(each) for name, each in value.items()}
    if isinstance(value, str):
        return value
    return tuple(_plain("", each) for each in value) if np.ndim(value) else float(value)


#: What to do about a description without collision elements.
VISUAL_HINT = "collision='visual' checks the visual elements, if there are any"


@dataclass(frozen=True, kw_only=True)
class Description:
    """Contents of a robot file: the whole robot, one plain number per joint, and the joints that follow another one, by name.

    The parent frame of each collision body in `geometry` is the frame of its link. `unchecked` has the pairs of bodies (names)
    that the description itself exempts from checks, with the reason. `source` is the kind of the file, for messages.
    """

    file: Path
    source: str
    model: pin.Model
    geometry: pin.GeometryModel
    mimics: Mapping[str, Mimic]
    unchecked: Mapping[frozenset[str], str]


def read_urdf(file: Path, files: UrdfFiles) -> Description:
    """The robot of a URDF or xacro file; continuous joints become plain angles."""
    root = files.root(file)
    check_urdf(file, root)
    if files.collision == "visual":
        check_visuals(file, root)
    elif root.find("link/collision") is None and root.find("link/visual") is not None:
        log.warning("%s: no link has a collision element, so nothing of the robot is checked; %s", file, VISUAL_HINT)
    mimics = read_mimics(file, root)
    files.without_meshes(file, root, files.collision)
    model = build_model(file, root)
    geometry = build_bodies(file, root, model, files, files.collision)
    check_origins(file, model, geometry)
    check_sizes(file, model, geometry)
    return Description(
        file=file,
        source="URDF",
        model=plain_angles(model),
        geometry=geometry,
        mimics=mimics,
        unchecked=_adjacent_bodies(model, geometry, find_joined_links(root)),
    )


def read_visuals(file: Path, files: UrdfFiles) -> tuple[pin.Model, pin.GeometryModel]:
    """The model of a URDF or xacro file with its visual bodies."""
    root = files.root(file)
    check_urdf(file, root)
    check_visuals(file, root)
    files.without_meshes(file, root, "visual")
    model = build_model(file, root)
    return model, build_bodies(file, root, model, files, "visual")


def _adjacent_bodies(
    model: pin.Model, geometry: pin.GeometryModel, joined: Collection[tuple[str, str]]
) -> dict[frozenset[str], str]:
    """The pairs of bodies on one link, or on the parent and the child link of one joint: these touch by construction."""
    bodies = [(item.name, str(model.frames[item.parentFrame].name)) for item in geometry.geometryObjects]
    return {
        frozenset((first, second)): "one link" if a == b else "parent and child link of one joint"
        for j, (second, b) in enumerate(bodies)
        for first, a in bodies[:j]
        if a == b or (a, b) in joined or (b, a) in joined
    }
