"""The model of an arm within its description: joints are locked, and followers become Pinocchio's mimic joints.

A mimic joint has no number of its own: nq = nv = n stays the number of independent joints, and every algorithm of Pinocchio
that knows mimic joints takes q (n,). Pinocchio wants a leader before its followers. Where it comes after one, a joint without
a body stands for it in front of that follower, and the leader itself follows this joint.
"""

from collections.abc import Mapping, Sequence

import numpy as np
import pinocchio as pin

from manipplan.robots.mimics import Mimic
from manipplan.robots.model_tree import joint_about, joint_names, joint_tree
from manipplan.support.errors import FileFormatError

#: Before the number of a frame while joints are locked. No name in an XML file can have it.
_NUMBER = "\x1f"
#: Added to the name of a leader that follows a joint which stands for it.
_ITSELF = " (itself)"


def reduce(
    model: pin.Model,
    geometry: pin.GeometryModel,
    active: Sequence[str],
    held: Mapping[str, float],
    mimics: Mapping[str, Mimic] | None = None,
) -> tuple[pin.Model, pin.GeometryModel]:
    """Lock every joint of `held` at its value, and let the others that mimic follow; the geometry follows its link.

    Args:
        model, geometry: the arm; it may have followers, which are locked with their leader.
        active: names of the independent joints, in the order of q.
        held: values of locked joints [rad or m].
        mimics: joints of the model that become followers if they are not locked.
    """
    model, geometry, followers = uncoupled(model, geometry)
    known = set(model.names)
    held = dict(held)
    for name, mimic in followers.items():
        if mimic.leader in held:
            held[name] = mimic.position(held[mimic.leader])
    followers |= {name: mimic for name, mimic in (mimics or {}).items() if name in known}
    followers = {name: mimic for name, mimic in followers.items() if name not in held}
    model, geometry = _locked(model, geometry, held)
    model, geometry = coupled(model, geometry, followers)
    if joint_names(model) != tuple(active):
        raise FileFormatError("joints", list(active), f"the order of the description: {list(joint_names(model))}")
    return model, geometry


def _locked(model: pin.Model, geometry: pin.GeometryModel, held: Mapping[str, float]) -> tuple[pin.Model, pin.GeometryModel]:
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
    return reduced, geometry


def followers_of(model: pin.Model) -> dict[str, Mimic]:
    """The joints of a model that follow others, by name."""
    found = dict[str, Mimic]()
    if all(joint.nq > 0 for joint in model.joints):
        return found
    tree, leaders = joint_tree(model), joint_names(model)
    for i, name in enumerate(list(model.names)[1:]):
        if model.joints[i + 1].nq == 0 and not name.endswith(_ITSELF):
            found[name] = Mimic(leader=leaders[tree.leader[i]], multiplier=float(tree.ratio[i]), offset=float(tree.offset[i]))
    return found


def coupled(
    model: pin.Model, geometry: pin.GeometryModel, followers: Mapping[str, Mimic]
) -> tuple[pin.Model, pin.GeometryModel]:
    """The arm whose joints `followers` follow their leaders."""
    if not followers:
        return model, geometry
    joints = {name: i for i, name in enumerate(model.names)}
    order, first = [], set[str]()
    for name in list(model.names)[1:]:
        leader = followers[name].leader if name in followers else name
        if leader != name and joints[leader] > joints[name] and leader not in first:
            first.add(leader)
            order.append((leader, joints[leader], False))
        order.append((name + _ITSELF if name in first else name, joints[name], True))
    together, geometry = _rebuilt(model, geometry, order, {})
    mimics = {leader + _ITSELF: Mimic(leader=leader, multiplier=1.0, offset=0.0) for leader in first} | dict(followers)
    for name, mimic in mimics.items():
        leads, follows = together.getJointId(mimic.leader), together.getJointId(name)
        entry, own = together.joints[leads].idx_v, together.joints[follows].idx_v
        armature = np.array(together.armature)
        armature[entry] += mimic.multiplier**2 * armature[own]  # the rotor turns with its leader
        together.armature = armature
        together = pin.transformJointIntoMimic(together, leads, follows, mimic.multiplier, mimic.offset)
    return together, geometry


def uncoupled(model: pin.Model, geometry: pin.GeometryModel) -> tuple[pin.Model, pin.GeometryModel, dict[str, Mimic]]:
    """The arm with an independent joint for each follower, and the followers."""
    followers = followers_of(model)
    if not followers:
        return model, geometry, {}
    names, kinds, tree, order = list(model.names), {}, joint_tree(model), []
    for i, name in enumerate(names[1:], start=1):
        if name + _ITSELF in names:
            continue  # it only stands for the leader
        if model.joints[i].nq == 0:
            kinds[i] = joint_about(tree.axes[i - 1], slides=bool(tree.slides[i - 1]))
        order.append((name.removesuffix(_ITSELF), i, True))
    return *_rebuilt(model, geometry, order, kinds), followers


def _rebuilt(
    model: pin.Model,
    geometry: pin.GeometryModel,
    order: Sequence[tuple[str, int, bool]],
    kinds: Mapping[int, pin.JointModel],
) -> tuple[pin.Model, pin.GeometryModel]:
    """The arm with the joints in `order`: new name, index in the model, and whether it has its place and its links.

    Joints in `kinds` get another kind: they followed others, whose armature holds theirs. Limits are those of the joint that
    moves them.
    """
    built, geometry = pin.Model(), geometry.copy()
    built.name, built.gravity = model.name, model.gravity
    index, armature = {0: 0}, []
    for name, i, whole in order:
        joint, at = kinds.get(i, model.joints[i]), model.joints[i].idx_q
        limits = [
            np.array(each[at : at + 1])
            for each in (model.effortLimit, model.velocityLimit, model.lowerPositionLimit, model.upperPositionLimit)
        ]
        before, place = (index[model.parents[i]], model.jointPlacements[i]) if whole else (0, pin.SE3.Identity())
        made = built.addJoint(before, joint, place, name, *limits)
        armature.append(model.armature[at] if whole and (i not in kinds or name + _ITSELF in model.names) else 0.0)
        if whole:
            index[i] = made
            built.inertias[made] = model.inertias[i]
    built.armature = np.array(armature)
    built.inertias[0] = model.inertias[0]
    for frame in list(model.copy().frames)[1:]:
        frame.parentJoint = index[frame.parentJoint]
        built.addFrame(frame, False)
    for item in geometry.geometryObjects:
        item.parentJoint = index[item.parentJoint]
    return built, geometry
