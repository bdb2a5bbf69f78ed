"""MoveIt's semantic description of a robot (SRDF): end effector, named states, pairs that need no check; read and written."""

import xml.etree.ElementTree as ET
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from manipplan.robots.formats.xml_files import read_xml
from manipplan.support.checks import Array, distinct_names, finite_array
from manipplan.support.errors import FileFormatError, InvalidInputError, UnknownNameError
from manipplan.support.files import write_bytes

if TYPE_CHECKING:
    from manipplan.robots.robot import Robot


@dataclass(frozen=True, kw_only=True)
class Semantics:
    """Contents of an SRDF: the end effector, base and tip of each chain, pairs that are not checked, and named states.

    `states` holds name and joint values in the order of the file; groups of one robot may use the same name.
    """

    end_effector: str | None
    chains: tuple[tuple[str, str], ...]
    disabled: frozenset[frozenset[str]]
    states: tuple[tuple[str, Mapping[str, float]], ...]


class NamedStates(dict[str, Array]):
    """Configurations (n,) [rad or m] by name; an unknown name raises UnknownNameError with the nearest names."""

    @classmethod
    def of(cls, states: Iterable[tuple[str, Mapping[str, float]]], joints: Sequence[str]) -> "NamedStates":
        """The states of an SRDF that give each of `joints` a value; of several with the same name, the first."""
        found = cls()
        for name, values in states:
            if name not in found and all(joint in values for joint in joints):
                q = np.array([values[joint] for joint in joints])
                q.flags.writeable = False
                found[name] = q
        return found

    def __missing__(self, name: str) -> Array:
        raise UnknownNameError("named state", str(name), self, empty="none: the robot was read without an SRDF that names any")


def read_srdf(file: Path) -> Semantics:
    """End effector, disabled pairs and named states of an SRDF."""
    root = read_xml("srdf", file, "robot")
    effector = root.find("end_effector")
    disabled = {frozenset((str(pair.get("link1")), str(pair.get("link2")))) for pair in root.findall("disable_collisions")}
    states = []
    for state in root.findall("group_state"):
        # a floating base has several values: it is not a joint of an arm
        single = [j for j in state.findall("joint") if len(str(j.get("value")).split()) == 1]
        try:
            values = {str(j.get("name")): float(str(j.get("value"))) for j in single}
        except ValueError as error:
            raise FileFormatError("srdf", str(file), f"numbers as joint values ({error})") from error
        for name, value in values.items():
            if not np.isfinite(value):
                raise FileFormatError("srdf", str(file), f"finite joint values; {name} is {value}")
        called = state.get("name")
        if not called:
            raise FileFormatError("srdf", str(file), "a name for every <group_state>")
        states.append((called, values))
    return Semantics(
        end_effector=effector.get("parent_link") if effector is not None else None,
        chains=tuple((str(chain.get("base_link")), str(chain.get("tip_link"))) for chain in root.findall("group/chain")),
        disabled=frozenset(disabled),
        states=tuple(states),
    )


def write_srdf(
    robot: "Robot",
    file: str | Path,
    states: Mapping[str, ArrayLike] | None = None,
    *,
    group: str = "arm",
    disabled: Mapping[frozenset[str], str] | None = None,
) -> None:
    """Write an SRDF with the arm as one group and disabled pairs, each with its reason; see `Robot.to_srdf`."""
    states = robot.states if states is None else states
    if not isinstance(states, Mapping):
        raise InvalidInputError("states", states, "a mapping of names to configurations")
    distinct_names("group", [group], 1)
    distinct_names("states", list(states), len(states))
    values = {name: finite_array(f"states[{name!r}]", q, (robot.n,)) for name, q in states.items()}
    root = ET.Element("robot", name=robot.model.name or robot.name)
    arm = ET.SubElement(root, "group", name=group)
    for joint in robot.joint_names:
        ET.SubElement(arm, "joint", name=joint)
    ET.SubElement(root, "end_effector", name="tool", parent_link=robot.tool, group=group)
    for name, q in values.items():
        state = ET.SubElement(root, "group_state", name=name, group=group)
        for joint, value in zip(robot.joint_names, q.tolist(), strict=True):
            ET.SubElement(state, "joint", name=joint, value=repr(value))
    pairs = dict.fromkeys(robot.disabled_pairs or (), "User") if disabled is None else disabled
    for pair, reason in sorted(pairs.items(), key=lambda each: sorted(each[0])):
        ET.SubElement(root, "disable_collisions", link1=min(pair), link2=max(pair), reason=reason)
    ET.indent(root)
    write_bytes(file, lambda stream: ET.ElementTree(root).write(stream, encoding="utf-8", xml_declaration=True))
