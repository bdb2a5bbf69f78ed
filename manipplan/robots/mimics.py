"""Joints that mimic another, by <mimic> of URDF or <equality> of MJCF: position = multiplier * leader's position + offset."""

import math
import xml.etree.ElementTree as ET
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pinocchio as pin

from manipplan.robots.formats.xml_files import numbers
from manipplan.support.errors import FileFormatError, InvalidInputError, UnknownNameError

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
    return {name: _first_leader(file, name, direct) for name in direct}


def read_couplings(file: Path, root: ET.Element, model: pin.Model) -> dict[str, Mimic]:
    """The followers of an MJCF file: joint1 of each active <equality><joint>, whose leader is joint2.

    MuJoCo measures both from their reference positions. Without joint2, joint1 stays where it is, as if it mimicked the world.

    Raises FileFormatError when a joint does not exist or has several numbers, the polynomial is not a straight line, or a joint
    follows itself through others.
    """
    direct = {}
    for coupling in (each for equality in root.findall("equality") for each in equality.findall("joint")):
        if coupling.get("active") == "false":
            continue
        name, leader = str(coupling.get("joint1")), coupling.get("joint2", WORLD)
        text = coupling.get("polycoef", "0 1 0 0 0")
        line = numbers(text, len(text.split()))
        if line is None or not 1 <= len(line) <= 5 or any(line[2:]):
            wanted = (
                f"<equality> joints with a polycoef that is a straight line, such as '0 1 0 0 0'; that of {name} is {text!r}"
            )
            raise FileFormatError("file", str(file), wanted)
        zero, slope = line[0], (*line, 1.0)[1] if leader != WORLD else 0.0
        offset = zero + _reference(file, model, name)
        if leader != WORLD:
            offset -= slope * _reference(file, model, leader)
        direct[name] = Mimic(leader=leader, multiplier=slope, offset=offset)
    return {name: _first_leader(file, name, direct) for name in direct}


def _reference(file: Path, model: pin.Model, name: str) -> float:
    """Position of a joint in the reference configuration of an MJCF file [rad or m]."""
    if name not in list(model.names)[1:]:
        unknown = UnknownNameError("joint", name, list(model.names)[1:])
        raise FileFormatError("file", str(file), f"<equality> between joints; {unknown}")
    joint = model.joints[model.getJointId(name)]
    if joint.nv != 1:
        raise FileFormatError(
            "file", str(file), f"<equality> between joints of one number each; {name} is a {joint.shortname()}"
        )
    reference = {each.key(): each.data() for each in model.referenceConfigurations}.get("qpos0", pin.neutral(model))
    values = reference[joint.idx_q : joint.idx_q + joint.nq]
    return float(values[0] if joint.nq == 1 else np.arctan2(values[1], values[0]))


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
    """The locked joints with every follower among them at the position that its leader gives it.

    Args:
        held: values of all locked joints [rad or m].
        given: those of the user, among which no follower may differ from its leader.
        mimics: the followers. A leader that is not locked is a fixed joint or the world: its position is 0.

    Raises InvalidInputError when the user's value of a follower differs; the message gives the leader's.
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
