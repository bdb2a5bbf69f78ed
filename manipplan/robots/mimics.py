"""Joints that mimic another, by <mimic> of URDF or <equality> of MJCF: position = multiplier * leader's position + offset."""

import math
import xml.etree.ElementTree as ET
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

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
