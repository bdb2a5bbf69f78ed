"""The part of a description that is the arm: its tool, active joints, values of the locked joints, limits, usual posture.

The model of an arm within its description: joints are locked, and followers become Pinocchio's mimic joints.

A mimic joint has no number of its own: nq = nv = n stays the number of independent joints, and every algorithm of Pinocchio
that knows mimic joints takes q (n,). Pinocchio wants a leader before its followers. Where it comes after one, a joint without
a body stands for it in front of that follower, and the leader itself follows this joint.
"""

import logging
from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
import pinocchio as pin

from manipplan.robots import model_tree
from manipplan.robots.description import Description
from manipplan.robots.ends import default_tool
from manipplan.robots.limits import LIMIT_TOLERANCE, JointLimits
from manipplan.robots.model_tree import WORLD, Mimic, follow, joint_about, joint_names, joint_tree, moves_with
from manipplan.robots.srdf import Semantics
from manipplan.support.checks import Array, ArrayLike, configurations, number, one_of, read_only, texts
from manipplan.support.errors import FileFormatError, InvalidInputError, UnsupportedJointError

log = logging.getLogger("manipplan")


def choose_tools(read: Description, tool: str | Sequence[str] | None, semantic: Semantics | None) -> tuple[str, ...]:
    """The given tool frames, or that which `robots.ends` finds."""
    given = [default_tool(read, semantic)] if tool is None else list(tool) if isinstance(tool, list | tuple) else [tool]
    if not given:
        raise InvalidInputError("tool", tool, "at least one frame")
    frames = [str(frame.name) for frame in read.model.frames if frame.name != WORLD]
    for each in given:
        one_of("tool", each, frames)
    return tuple(map(str, given))


def choose_joints(
    model: pin.Model,
    tools: Sequence[str],
    chain: list[str],
    joints: Sequence[str] | None,
    mimics: Mapping[str, Mimic],
    locked: Mapping[str, float],
) -> list[str]:
    """Names of the active joints, in the order of q: the given ones, or all that move a tool.

    A joint that mimics another moves a tool by its leader, which need not be in the `chain` of joints that carry one; such a
    leader is not chosen where it is `locked`. A leader has the place of its first follower if that comes before it.
    """
    chosen = None if joints is None else texts("joints", joints)
    tool = " or ".join(tools)
    known = list(model.names)[1:]
    leaders = {name: mimic.leader for name, mimic in mimics.items() if name in known and moves_with(mimic, known)}
    fixed = [name for name in mimics if name not in leaders]
    moving = {leaders.get(joint, joint) for joint in chain if joint not in fixed}
    order = list(dict.fromkeys(leaders.get(joint, joint) for joint in known))
    movers = [joint for joint in order if joint in moving]
    active = list(chosen) if chosen is not None else [joint for joint in movers if joint in chain or joint not in locked]
    for joint in active:
        one_of("joints", joint, known)
        if joint in mimics:
            wanted = f"independent joints; {joint} mimics another, as {mimics[joint]}, and moves with it: name"
            raise UnsupportedJointError("joints", joint, f"{wanted} {mimics[joint].leader} instead")
        if joint not in movers:
            raise InvalidInputError("joints", joint, f"joints that move the tool {tool}: {', '.join(movers)}")
        kind = model.joints[model.getJointId(joint)]
        if kind.nv != 1 or not (model_tree.is_prismatic(kind) or model_tree.is_revolute(kind)):
            others = [each for each in movers if model.joints[model.getJointId(each)].nv == 1]
            wanted = f"revolute, continuous and prismatic joints; joints={others} leaves it where it is"
            raise UnsupportedJointError("joints", f"{joint} ({kind.shortname()})", wanted)
    for name, leader in leaders.items():
        kind = model.joints[model.getJointId(name)]
        if leader in active and not (model_tree.is_prismatic(kind) or model_tree.is_revolute(kind)):
            wanted = f"revolute, continuous and prismatic joints as followers of the active {leader}"
            raise UnsupportedJointError("joints", f"{name} ({kind.shortname()})", wanted)
    ordered = [joint for joint in movers if joint in active]
    if active != ordered:
        raise InvalidInputError("joints", active, f"each joint once, from base to tool: {', '.join(ordered)}")
    count = len(active) + sum(leader in active for leader in leaders.values())
    if count > model_tree.MOST_ACTIVE:
        raise InvalidInputError("joints", f"{count} joints", f"at most {model_tree.MOST_ACTIVE} active joints and followers")
    if not active:
        if joints is None:
            raise InvalidInputError("tool", tool, "a frame that a joint moves; this one stands still")
        raise InvalidInputError("joints", active, f"at least one joint that moves the tool {tool}")
    return active


def locked_values(
    model: pin.Model, active: list[str], given: Mapping[str, float], semantic: Semantics | None, mimics: Mapping[str, Mimic]
) -> dict[str, float]:
    """Every joint of the description that is neither active nor follows one, with its locked value [rad or m]."""
    followers = {name: mimic.leader for name, mimic in mimics.items() if mimic.leader in active and mimic.multiplier}
    others = [name for name in list(model.names)[1:] if name not in active and name not in followers]
    if not isinstance(given, Mapping):
        raise InvalidInputError("locked", given, "a mapping from names of joints to their values")
    for name, value in given.items():
        if name in followers:
            wanted = f"joints that can be locked: {name} mimics another, as {mimics[name]}; lock {followers[name]} instead"
            raise InvalidInputError(f"locked[{name!r}]", value, wanted)
        if name in active:
            wanted = f"joints that are not active; {name} is active, as it moves the tool: joints= without it locks it"
            raise InvalidInputError(f"locked[{name!r}]", value, wanted)
        one_of("locked", name, [*others, *active])
        number(f"locked[{name!r}]", value)
        joint = model.joints[model.getJointId(name)]
        if joint.nq != 1:
            raise InvalidInputError(f"locked[{name!r}]", value, f"no value: a {joint.shortname()} stays at its origin")
    usual = semantic.states[0][1] if semantic is not None and semantic.states else {}
    held = {}
    for name in others:
        joint = model.joints[model.getJointId(name)]
        if joint.nq == 1:
            low, high = model.lowerPositionLimit[joint.idx_q], model.upperPositionLimit[joint.idx_q]
            held[name] = float(given.get(name, np.clip(usual.get(name, 0.0), low, high)))
        else:
            held[name] = float(given.get(name, 0.0))
    held = follow(held, given, mimics)
    for name, value in held.items():
        joint = model.joints[model.getJointId(name)]
        low, high = (limit[joint.idx_q] for limit in (model.lowerPositionLimit, model.upperPositionLimit))
        if joint.nq == 1 and not low <= value <= high:
            log.warning("%s is locked at %g, outside its limits %g to %g", name, value, low, high)
    return held


def limits_of(model: pin.Model, source: str, given: Mapping[str, ArrayLike]) -> JointLimits:
    """The limits of the description, replaced by the given ones where there are any."""
    inf = np.full(model.nv, np.inf)
    lower, upper, velocity = model.lowerPositionLimit, model.upperPositionLimit, model.velocityLimit
    for i, name in enumerate(model_tree.joint_names(model)):
        if "velocity" not in given and not velocity[i] > 0:
            raise InvalidInputError(f"velocity limit of {name}", float(velocity[i]), "above zero; give velocity= to set it")
        if not {"lower", "upper"} & set(given) and not lower[i] < upper[i]:
            raise InvalidInputError(
                f"position limits of {name}", [lower[i], upper[i]], "lower below upper; give lower= and upper= to set them"
            )
    effort = np.where(model.effortLimit > 0, model.effortLimit, np.inf)
    sources = dict.fromkeys(("lower", "upper"), source)
    for kind, values in (("velocity", velocity), ("effort", effort)):
        sources[kind] = source if np.isfinite(values).any() else f"none in the {source}; {kind}= gives them"
    described = JointLimits(
        lower=-inf if "lower" in given else lower,
        upper=inf if "upper" in given else upper,
        velocity=inf if "velocity" in given else velocity,
        acceleration=inf,
        jerk=inf,
        effort=effort,
        sources=sources,
    )
    return described.with_changes(given) if given else described


def limits_of_leaders(
    limits: JointLimits, model: pin.Model, followers: Mapping[str, Mimic], active: Sequence[str], given: Mapping[str, ArrayLike]
) -> JointLimits:
    """The limits of the active joints, so narrow that their followers stay within those of the description.

    Limits that are `given` remain. Those of effort are the leader's own, for the load of all that moves with it.

    Raises InvalidInputError when a follower leaves its leader no room, or has no velocity limit above zero.
    """
    lower, upper, velocity = limits.lower.copy(), limits.upper.copy(), limits.velocity.copy()
    for name, mimic in followers.items():
        joint, k = model.joints[model.getJointId(name)], list(active).index(mimic.leader)
        low, high = model.lowerPositionLimit[joint.idx_q], model.upperPositionLimit[joint.idx_q]
        ends = sorted((end - mimic.offset) / mimic.multiplier for end in (low, high))
        fastest = float(model.velocityLimit[joint.idx_v])
        if "velocity" not in given and not fastest > 0:
            raise InvalidInputError(f"velocity limit of {name}", fastest, "above zero; give velocity= to set it")
        changes = {}
        if "lower" not in given and ends[0] > lower[k]:
            changes["lower"] = lower[k] = ends[0]
        if "upper" not in given and ends[1] < upper[k]:
            changes["upper"] = upper[k] = ends[1]
        if "velocity" not in given and fastest / abs(mimic.multiplier) < velocity[k]:
            changes["velocity"] = velocity[k] = fastest / abs(mimic.multiplier)
        if not lower[k] < upper[k]:
            wanted = f"limits that leave its leader room: it moves as {mimic}; lower= and upper= set those of the leader"
            raise InvalidInputError(f"position limits of {name}", [float(low), float(high)], wanted)
        strength = float(model.effortLimit[joint.idx_v])
        if "effort" not in given and 0 < strength < np.inf:
            why = f"as it moves as {mimic}, by the motor of its leader"
            log.info("%s: its effort limit of %g is not taken, %s", name, strength, why)
        if changes:
            narrowed = ", ".join(f"{kind} {value:g}" for kind, value in changes.items())
            log.info("%s: limits narrowed by %s, which moves as %s: %s", mimic.leader, name, mimic, narrowed)
    return replace(limits, lower=lower, upper=upper, velocity=velocity) if followers else limits


def usual_posture(limits: JointLimits, given: ArrayLike | None) -> Array:
    """The given posture, or the middle of the limits, (n,)."""
    lower = np.where(np.isfinite(limits.lower), limits.lower, -np.pi)
    upper = np.where(np.isfinite(limits.upper), limits.upper, np.pi)
    neutral = (lower + upper) / 2 if given is None else configurations("neutral", given, limits.n)
    if not (limits.outside(neutral) <= LIMIT_TOLERANCE).all():
        raise InvalidInputError("neutral", neutral.tolist(), "a posture inside the position limits")
    return read_only(np.clip(neutral, limits.lower, limits.upper))


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
    """Lock every joint of `held` at its value [rad or m], and let the others that mimic follow; the geometry follows its link.

    Followers of the model are locked with their leader, and the joints of `mimics` become followers if they are not locked.
    `active` names the independent joints, in the order of q.
    """
    model, geometry, followers = uncouple(model, geometry)
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
    together, geometry = _rebuild(model, geometry, order, {})
    mimics = {leader + _ITSELF: Mimic(leader=leader, multiplier=1.0, offset=0.0) for leader in first} | dict(followers)
    for name, mimic in mimics.items():
        leads, follows = together.getJointId(mimic.leader), together.getJointId(name)
        entry, own = together.joints[leads].idx_v, together.joints[follows].idx_v
        armature = np.array(together.armature)
        armature[entry] += mimic.multiplier**2 * armature[own]  # the rotor turns with its leader
        together.armature = armature
        together = pin.transformJointIntoMimic(together, leads, follows, mimic.multiplier, mimic.offset)
    return together, geometry


def uncouple(model: pin.Model, geometry: pin.GeometryModel) -> tuple[pin.Model, pin.GeometryModel, dict[str, Mimic]]:
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
    return *_rebuild(model, geometry, order, kinds), followers


def _rebuild(
    model: pin.Model, geometry: pin.GeometryModel, order: Sequence[tuple[str, int, bool]], kinds: Mapping[int, pin.JointModel]
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
        before, placement = (index[model.parents[i]], model.jointPlacements[i]) if whole else (0, pin.SE3.Identity())
        made = built.addJoint(before, joint, placement, name, *limits)
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
