"""Joints, frames and bodies of a Pinocchio model, as one plain number per joint.

Joints that mimic another, by <mimic> of URDF or <equality> of MJCF: position = multiplier * leader's position + offset.
"""

import math
import xml.etree.ElementTree as ET
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.support.checks import Array
from manipplan.support.errors import FileFormatError, InvalidInputError, UnknownNameError

#: Maximum number of active joints: Pinocchio's data hold several numbers for every three of them.
MOST_ACTIVE = 100


def is_revolute(joint: pin.JointModel) -> bool:
    """Whether the joint turns about one fixed axis."""
    return bool(joint.shortname().startswith("JointModelR") and joint.nv == 1)


def is_prismatic(joint: pin.JointModel) -> bool:
    """Whether the joint slides along one fixed axis."""
    return bool(joint.shortname().startswith("JointModelP") and joint.nv == 1)


def axis_of(joint: pin.JointModel) -> Array:
    """Unit axis (3,) of a revolute or prismatic joint in its own frame."""
    name = joint.shortname()
    if name.endswith("Unaligned"):
        data = joint.createData()
        joint.calc(data, np.eye(joint.nq)[0])  # the motion at angle 0, or at (cos, sin) = (1, 0)
        motion = np.array(data.S).reshape(-1)
        return motion[:3] if is_prismatic(joint) else motion[3:]
    return np.asarray(np.eye(3)["XYZ".index(name[-1])])


def joint_about(axis: Array, *, slides: bool) -> pin.JointModel:
    """The prismatic or revolute joint with a unit axis (3,), of the kind that Pinocchio takes for it when it reads a file."""
    for unit, name in zip(np.eye(3), "XYZ", strict=True):
        if np.array_equal(axis, unit):
            return getattr(pin, f"JointModel{'P' if slides else 'R'}{name}")()
    return (pin.JointModelPrismaticUnaligned if slides else pin.JointModelRevoluteUnaligned)(axis)


@dataclass(frozen=True, kw_only=True, eq=False)
class JointTree:
    """The joints of a model of plain angles as arrays; some of its N joints may follow others.

    Joint i, counted from 1 as in Pinocchio, is at ratio * q[leader] + offset of entry i - 1. Joints that lead themselves have
    ratio 1 and offset 0.

    Attributes:
        before: (N,) the joint before each; 0: the world.
        carries: (N + 1, N + 1) whether joint j carries joint i, at [i, j]; a joint carries itself, the world every joint.
        fixed: (N, 12) rotation by rows and origin of each joint in the frame of the joint before it, at position 0.
        axes: (N, 3) unit axis in the joint's own frame.
        slides: (N,) whether the joint is prismatic.
        leader: (N,) the entry of q (n,) that moves each joint.
        ratio, offset: (N,) see above [1 or rad/m, rad or m].
    """

    before: NDArray[np.int64]
    carries: NDArray[np.int64]
    fixed: Array
    axes: Array
    slides: NDArray[np.bool_]
    leader: NDArray[np.int64]
    ratio: Array
    offset: Array

    @property
    def has_followers(self) -> bool:
        """Whether a joint follows another."""
        return len(self.leader) > self.leads

    @property
    def leads(self) -> int:
        """The number n of the joints that follow no other, the entries of q."""
        return int(self.leader.max(initial=-1)) + 1

    @property
    def matrix(self) -> Array:
        """The derivatives (N, n) of the joints' positions by q."""
        found = np.zeros((len(self.leader), self.leads))
        found[np.arange(len(self.leader)), self.leader] = self.ratio
        return found

    def alone(self) -> "JointTree":
        """The same joints, none of which follows another: each has an entry of its own."""
        count = len(self.leader)
        return replace(self, leader=np.arange(count), ratio=np.ones(count), offset=np.zeros(count))

    def positions(self, q: Array) -> Array:
        """The positions (..., N) of all joints at q (..., n)."""
        return self.ratio * q[..., self.leader] + self.offset if self.has_followers else q

    def sizes(self, change: Array) -> Array:
        """The sizes (..., N) of the joints' changes, speeds or accelerations where those of q are (..., n), without sign."""
        return np.abs(self.ratio) * change[..., self.leader] if self.has_followers else change

    def carriers(self, joint: int) -> list[int]:
        """The entries of q that move what a joint carries, ascending."""
        return sorted({int(self.leader[i - 1]) for i in np.flatnonzero(self.carries[joint]) if i > 0})


def joint_tree(model: pin.Model) -> JointTree:
    """The tree of a model whose joints are revolute (plain angle) or prismatic, or Pinocchio's mimic joints of these."""
    n = model.njoints
    carries = np.zeros((n, n), dtype=np.int64)
    for i in range(n):
        carries[i, list(model.supports[i])] = 1
    axes, slides, ratio, offset = np.zeros((n - 1, 3)), np.zeros(n - 1, dtype=bool), np.ones(n - 1), np.zeros(n - 1)
    for i, joint in enumerate(list(model.joints)[1:]):
        if joint.nq == 0:
            follower, data = joint.extract(), joint.createData()
            joint.calc(data, np.zeros(model.nq))
            motion = np.array(data.S).reshape(-1) / follower.scaling
            slides[i], ratio[i], offset[i] = bool(motion[:3].any()), follower.scaling, follower.offset
            axes[i] = motion[:3] if slides[i] else motion[3:]
        else:
            axes[i], slides[i] = axis_of(joint), is_prismatic(joint)
    placements = [np.concatenate([np.ravel(each.rotation), each.translation]) for each in list(model.jointPlacements)[1:]]
    return JointTree(
        before=np.array(list(model.parents)[1:], dtype=np.int64),
        carries=carries,
        fixed=np.array(placements).reshape(-1, 12),
        axes=axes,
        slides=slides,
        leader=np.array([joint.idx_q for joint in list(model.joints)[1:]], dtype=np.int64),
        ratio=ratio,
        offset=offset,
    )


def joint_names(model: pin.Model) -> tuple[str, ...]:
    """Names of the joints that follow no other, in the order of q."""
    return tuple(name for name, joint in zip(model.names, model.joints, strict=True) if joint.nq > 0 and joint.idx_q >= 0)


def joint_types(model: pin.Model, unlimited: Sequence[bool]) -> tuple[str, ...]:
    """'revolute', 'continuous' or 'prismatic' for each joint that follows no other, of which some have no position limits."""
    kinds = {False: "revolute", True: "continuous"}
    joints = zip((joint for joint in list(model.joints)[1:] if joint.nq > 0), unlimited, strict=True)
    return tuple("prismatic" if is_prismatic(joint) else kinds[endless] for joint, endless in joints)


def plain_angles(model: pin.Model) -> pin.Model:
    """The same tree with unbounded revolute joints as plain angles, so that each is one number.

    Pinocchio stores a continuous joint as cosine and sine; planning variables must be free.
    """
    if not any("RUB" in joint.shortname() or "RevoluteUnbounded" in joint.shortname() for joint in model.joints):
        return model
    plain = pin.Model()
    plain.name = model.name
    plain.gravity = model.gravity
    for i in range(1, model.njoints):
        joint = model.joints[i]
        lower = model.lowerPositionLimit[joint.idx_q : joint.idx_q + joint.nq]
        upper = model.upperPositionLimit[joint.idx_q : joint.idx_q + joint.nq]
        effort = model.effortLimit[joint.idx_v : joint.idx_v + joint.nv]
        velocity = model.velocityLimit[joint.idx_v : joint.idx_v + joint.nv]
        if is_revolute(joint) and joint.nq == 2:
            joint = pin.JointModelRevoluteUnaligned(axis_of(joint))
            lower, upper = np.array([-np.inf]), np.array([np.inf])
        index = plain.addJoint(
            model.parents[i], joint, model.jointPlacements[i], model.names[i], effort, velocity, lower, upper
        )
        plain.inertias[index] = model.inertias[i]
    plain.armature = model.armature
    for frame in list(model.frames)[1:]:
        plain.addFrame(frame, False)
    return plain


def parent_bodies(model: pin.Model) -> dict[int, int]:
    """The body that carries each body, through whatever joint, both by their frames; 0: the world. Parents come first."""
    frames = model.frames
    bodies = [i for i, frame in enumerate(frames) if frame.type == pin.FrameType.BODY and i > 0]
    found = dict[int, int]()
    for body in bodies:
        above = int(frames[body].parentFrame)
        while above and frames[above].type != pin.FrameType.BODY:
            above = int(frames[above].parentFrame)
        found[body] = above
    return found


def frame_index(model: pin.Model, name: str) -> int:
    """Index of the frame called `name`; a link takes precedence over a site of the same name, and a site over a joint."""
    found = [i for i, frame in enumerate(model.frames) if frame.name == name]
    order = {pin.FrameType.BODY: 0, pin.FrameType.OP_FRAME: 1}
    return min(found, key=lambda i: order.get(model.frames[i].type, 2))


def frame_pose(model: pin.Model, name: str, q: Array) -> Array:
    """The pose (4, 4) of a frame in the world at q (n,)."""
    data = model.createData()
    pin.framesForwardKinematics(model, data, q)
    return np.asarray(data.oMf[frame_index(model, name)].homogeneous)


#: Pinocchio's name for the world, as a joint and as a frame.
WORLD = "universe"


@dataclass(frozen=True, kw_only=True)
class Mimic:
    """A joint that follows another: multiplier * leader + offset [rad or m]. The leader itself follows no joint."""

    leader: str
    multiplier: float
    offset: float

    def position(self, leader: float) -> float:
        """The follower's position for one of its leader [rad or m]."""
        return self.multiplier * leader + self.offset

    def __str__(self) -> str:
        return f"{self.multiplier:g} * {self.leader} + {self.offset:g}"


def read_mimics(file: Path, root: ET.Element) -> dict[str, Mimic]:
    """The followers of a URDF; one that follows a follower gets the first leader of all.

    Raises FileFormatError when a leader is not a joint, a factor is not a finite number, a joint follows itself through others,
    or a floating or planar joint is a leader or a follower.
    """
    kinds = {str(joint.get("name")): joint.get("type") for joint in root.findall("joint")}
    direct = {}
    for joint in root.findall("joint"):
        mimic = joint.find("mimic")
        if mimic is None:
            continue
        name, leader = str(joint.get("name")), mimic.get("joint", "")
        try:
            factor, offset = float(mimic.get("multiplier", "1")), float(mimic.get("offset", "0"))
        except ValueError as error:
            raise FileFormatError("file", str(file), f"numbers in <mimic> of {name} ({error})") from error
        if not (math.isfinite(factor) and math.isfinite(offset)):
            raise FileFormatError("file", str(file), f"finite numbers in <mimic> of {name}")
        if leader not in kinds:
            raise FileFormatError(
                "file", str(file), f"joints as leaders; <mimic> of {name}: {UnknownNameError('joint', leader, kinds)}"
            )
        for each in (name, leader):
            if kinds[each] in ("floating", "planar"):
                wanted = f"<mimic> between joints of one number each; in that of {name}, {each} is {kinds[each]}"
                raise FileFormatError("file", str(file), wanted)
        direct[name] = Mimic(leader=leader, multiplier=factor, offset=offset)
    return first_leaders(file, direct)


def first_leaders(file: Path, direct: Mapping[str, Mimic]) -> dict[str, Mimic]:
    """The followers in `direct`, with the first leader of all in place of a leader that follows another joint.

    Raises FileFormatError when a joint follows itself through others.
    """
    return {name: _first_leader(file, name, direct) for name in direct}


def _first_leader(file: Path, name: str, direct: Mapping[str, Mimic]) -> Mimic:
    mimic, passed = direct[name], {name}
    while mimic.leader in direct:
        if mimic.leader in passed:
            raise FileFormatError(
                "file", str(file), f"joints that do not mimic themselves; {name} mimics {', '.join(sorted(passed))}"
            )
        passed.add(mimic.leader)
        above = direct[mimic.leader]
        offset = mimic.multiplier * above.offset + mimic.offset
        mimic = Mimic(leader=above.leader, multiplier=mimic.multiplier * above.multiplier, offset=offset)
    return mimic


def moves_with(mimic: Mimic, joints: Collection[str]) -> bool:
    """Whether a follower moves: its leader is a joint of the model, not fixed and not the world, and the multiplier not 0."""
    return mimic.multiplier != 0.0 and mimic.leader in joints


def follow(held: Mapping[str, float], given: Mapping[str, float], mimics: Mapping[str, Mimic]) -> dict[str, float]:
    """All locked joints, as in `held` [rad or m], with every follower among them at the position that its leader gives it.

    A leader that is not locked is a fixed joint or the world: its position is 0. Raises InvalidInputError when the value of a
    follower that the user has given differs; the message gives the leader's.
    """
    positions = dict(held)
    for name in mimics.keys() & held.keys():
        mimic = mimics[name]
        leader = held.get(mimic.leader, 0.0)
        positions[name] = mimic.position(leader)
        if name in given and not np.isclose(given[name], positions[name], rtol=1e-6, atol=1e-9):
            wanted = f"{positions[name]:g}: it mimics another joint, as {mimic}; lock {mimic.leader}, which is at {leader:g}"
            raise InvalidInputError(f"locked[{name!r}]", given[name], wanted)
    return positions
