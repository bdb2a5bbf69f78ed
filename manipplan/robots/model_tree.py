"""Joints, frames and bodies of a Pinocchio model, as one plain number per joint."""

from collections.abc import Mapping, Sequence

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.support.checks import Array
from manipplan.support.errors import FileFormatError

#: Maximum number of active joints: Pinocchio's data hold several numbers for every three of them.
MOST_ACTIVE = 100
#: Before the number of a frame while joints are locked. No name in an XML file can have it.
_NUMBER = "\x1f"


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


def joint_types(model: pin.Model, unlimited: Sequence[bool]) -> tuple[str, ...]:
    """'revolute', 'continuous' or 'prismatic' for each joint, of which some have no position limits."""
    kinds = {False: "revolute", True: "continuous"}
    joints = zip(list(model.joints)[1:], unlimited, strict=True)
    return tuple("prismatic" if is_prismatic(joint) else kinds[endless] for joint, endless in joints)


def joint_tree(model: pin.Model) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """The joint before each joint (n,), 0: the world, and whether joint j carries joint i, as [i, j] of (n + 1, n + 1).

    A joint carries itself; the world, 0, carries every joint.
    """
    carries = np.zeros((model.njoints, model.njoints), dtype=np.int64)
    for i in range(model.njoints):
        carries[i, list(model.supports[i])] = 1
    return np.array(list(model.parents)[1:], dtype=np.int64), carries


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


def reduce(
    model: pin.Model, geometry: pin.GeometryModel, active: Sequence[str], held: Mapping[str, float]
) -> tuple[pin.Model, pin.GeometryModel]:
    """Lock every joint of `held` at its value; the geometry follows its link."""
    q = pin.neutral(model)
    for name, value in held.items():
        joint = model.joints[model.getJointId(name)]
        if joint.nq == 1:
            q[joint.idx_q] = value
    # Pinocchio looks up a locked joint, and the frame below it, by name alone: frames are called by numbers meanwhile.
    model, called = model.copy(), dict[str, str]()
    for i, frame in enumerate(model.frames):
        if i > 0 and frame.type != pin.FrameType.JOINT:
            called[f"{_NUMBER}{i}"] = frame.name
            frame.name = f"{_NUMBER}{i}"
    reduced, [geometry] = pin.buildReducedModel(model, [geometry], [model.getJointId(name) for name in held], q)
    for frame in reduced.frames:
        frame.name = called.get(frame.name, frame.name)
    for item in geometry.geometryObjects:
        if item.parentFrame >= reduced.nframes:  # Pinocchio does not find the frame of the world again
            item.parentFrame = 0
    if list(reduced.names)[1:] != list(active):
        raise FileFormatError("joints", list(active), f"the order of the description: {list(reduced.names)[1:]}")
    return reduced, geometry


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
