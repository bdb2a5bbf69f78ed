"""The part of a description that is the arm: its tool, active joints, values of the locked joints, limits, usual posture."""

import logging
from collections.abc import Mapping, Sequence

import numpy as np
import pinocchio as pin
from numpy.typing import ArrayLike

from manipplan.robots import model_tree
from manipplan.robots.description import Description
from manipplan.robots.ends import default_tool
from manipplan.robots.limits import JointLimits
from manipplan.robots.mimics import WORLD, Mimic, follow
from manipplan.robots.srdf import Semantics
from manipplan.support.checks import Array, configurations, number
from manipplan.support.errors import InvalidInputError, UnknownNameError, UnsupportedJointError

log = logging.getLogger("manipplan")


def choose_tools(read: Description, tool: str | Sequence[str] | None, semantic: Semantics | None) -> tuple[str, ...]:
    """The given tool frames, or that which `robots.ends` finds."""
    given = [default_tool(read, semantic)] if tool is None else list(tool) if isinstance(tool, list | tuple) else [tool]
    if not given:
        raise InvalidInputError("tool", tool, "at least one frame")
    frames = [str(frame.name) for frame in read.model.frames if frame.name != WORLD]
    for each in given:
        if each not in frames:
            raise UnknownNameError("tool", str(each), frames)
    return tuple(map(str, given))


def choose_joints(
    model: pin.Model, tools: Sequence[str], chain: list[str], joints: Sequence[str] | None, mimics: Mapping[str, Mimic]
) -> list[str]:
    """Names of the active joints: the given ones, or all that move a tool, but for followers of a joint that does not.

    A leader cannot be active: chains, kinematics and collision checks have one joint per number of q.
    """
    if isinstance(joints, str):
        raise InvalidInputError("joints", joints, "a list of names")
    tool = " or ".join(tools)
    held = [joint for joint in chain if joint in mimics and mimics[joint].leader not in chain]
    active = [joint for joint in chain if joint not in held] if joints is None else list(joints)
    for joint in active:
        if joint not in list(model.names)[1:]:
            raise UnknownNameError("joints", str(joint), list(model.names)[1:])
        if joint not in chain:
            raise InvalidInputError("joints", joint, f"joints that move the tool {tool}: {', '.join(chain)}")
        if joint in mimics:
            leader = mimics[joint].leader
            wanted = f"independent joints; {joint} mimics {leader}. Leave both out of joints=, and lock the leader:"
            remedy = f"locked={{{leader!r}: value}} holds {joint} at {mimics[joint]}"
            raise UnsupportedJointError("joints", joint, f"{wanted} {remedy}")
        followers = [follower for follower, mimic in mimics.items() if mimic.leader == joint]
        if followers:
            wanted = (
                f"joints that no other joint mimics; {followers[0]} mimics it, and would have to move with it, which is not"
            )
            remedy = f"leave {joint} out of joints= and lock it: locked={{{joint!r}: value}}"
            raise UnsupportedJointError("joints", joint, f"{wanted} supported; {remedy}")
        kind = model.joints[model.getJointId(joint)]
        if kind.nv != 1 or not (model_tree.is_prismatic(kind) or model_tree.is_revolute(kind)):
            raise UnsupportedJointError(
                "joints", f"{joint} ({kind.shortname()})", "revolute, continuous and prismatic joints; lock it or choose others"
            )
    ordered = [joint for joint in chain if joint in active]
    if active != ordered:
        raise InvalidInputError("joints", active, f"each joint once, from base to tool: {', '.join(ordered)}")
    if len(active) > model_tree.MOST_ACTIVE:
        raise InvalidInputError("joints", f"{len(active)} joints", f"at most {model_tree.MOST_ACTIVE} active joints")
    if not active:
        raise InvalidInputError("joints", active, f"at least one joint that moves the tool {tool}")
    return active


def locked_values(
    model: pin.Model,
    active: list[str],
    given: Mapping[str, float],
    semantic: Semantics | None,
    mimics: Mapping[str, Mimic],
) -> dict[str, float]:
    """Every other joint of the description with its locked value [rad or m]."""
    others = [name for name in list(model.names)[1:] if name not in active]
    if not isinstance(given, Mapping):
        raise InvalidInputError("locked", given, "a mapping from names of joints to their values")
    for name, value in given.items():
        if name not in others:
            raise UnknownNameError("locked", name, others)
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
    for i, name in enumerate(list(model.names)[1:]):
        if "velocity" not in given and not velocity[i] > 0:
            raise InvalidInputError(f"velocity limit of {name}", float(velocity[i]), "above zero; give velocity= to set it")
        if not {"lower", "upper"} & set(given) and not lower[i] < upper[i]:
            raise InvalidInputError(
                f"position limits of {name}", [lower[i], upper[i]], "lower below upper; give lower= and upper= to set them"
            )
    described = JointLimits(
        lower=-inf if "lower" in given else lower,
        upper=inf if "upper" in given else upper,
        velocity=inf if "velocity" in given else velocity,
        acceleration=inf,
        jerk=inf,
        effort=np.where(model.effortLimit > 0, model.effortLimit, np.inf),
        sources=dict.fromkeys(("lower", "upper", "velocity", "effort"), source),
    )
    return described.with_changes(given) if given else described


def usual_posture(limits: JointLimits, given: ArrayLike | None) -> Array:
    """The given posture, or the middle of the limits, (n,)."""
    lower = np.where(np.isfinite(limits.lower), limits.lower, -np.pi)
    upper = np.where(np.isfinite(limits.upper), limits.upper, np.pi)
    neutral = (lower + upper) / 2 if given is None else configurations("neutral", given, limits.n)
    if (limits.outside(neutral) > 0).any():
        raise InvalidInputError("neutral", neutral.tolist(), "a posture inside the position limits")
    neutral.flags.writeable = False
    return neutral
