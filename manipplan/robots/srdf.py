"""MoveIt's semantic description of a robot (SRDF): end effector, named states, pairs that need no check; read and written."""

import difflib
import logging
import xml.etree.ElementTree as ET
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pinocchio as pin

from manipplan.robots.xml_files import numbers, read_xml
from manipplan.support.checks import Array, ArrayLike, distinct_names, finite_array, one_of, read_only
from manipplan.support.errors import FileFormatError, InvalidInputError, UnknownNameError
from manipplan.support.files import write_bytes

if TYPE_CHECKING:
    from manipplan.robots.robot import Robot

log = logging.getLogger("manipplan")

#: Pinocchio's name for the joint of a floating base.
FLOATING = "root_joint"
#: Elements of an SRDF that are read; and others, which change nothing here.
READ = ("disable_collisions", "group_state", "end_effector")
PASSED = ("enable_collisions", "disable_default_collisions", "group", "gripper", "virtual_joint", "passive_joint")


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
                found[name] = read_only(np.array([values[joint] for joint in joints]))
        return found

    def __missing__(self, name: str) -> Array:
        raise UnknownNameError("named state", str(name), self, empty="none: the robot was read without an SRDF that names any")


def state_of_others(semantic: Semantics | None, name: str, carrying: Sequence[str]) -> dict[str, float]:
    """The joint values of a named state without those of the joints that carry a tool: that of a gripper, or of another arm.

    Raises UnknownNameError where no state of that name has any, with the names of those that do.
    """
    found: dict[str, dict[str, float]] = {}
    for each, values in semantic.states if semantic is not None else ():
        others = {joint: value for joint, value in values.items() if joint not in carrying}
        if others:
            found.setdefault(each, others)
    none = "a mapping from names of joints to values: no SRDF was given that names a state of joints beside the arm's"
    return found[one_of("locked", name, found, empty=none)]


def read_srdf(file: Path, model: pin.Model) -> Semantics:
    """End effector, disabled pairs and named states of an SRDF for the robot of `model`.

    An SRDF is often shared by variants of a robot: another robot's name and joints that this one does not have are in the log
    (level INFO). A pair with a link that it does not have is a warning, as that pair is checked.

    Raises FileFormatError for a misspelt element or attribute, for a state or a joint of a state that is given twice, and for
    values that are not finite numbers, one per joint.
    """
    root = read_xml("srdf", file, "robot")
    if root.get("name", model.name) != model.name:
        log.info("%s is for the robot %s, not for %s", file, root.get("name"), model.name)
    if root.find("link") is not None:
        raise FileFormatError("srdf", str(file), "an SRDF; this file has <link> elements, as a URDF has")
    for element in root:
        near = difflib.get_close_matches(element.tag.lower(), READ, n=1, cutoff=0.8)
        if near and element.tag not in (*READ, *PASSED):
            raise FileFormatError("srdf", str(file), f"elements of SRDF; <{element.tag}>: did you mean <{near[0]}>?")
    links = {frame.name for frame in model.frames if frame.type == pin.FrameType.BODY}
    effector = root.find("end_effector")
    disabled = {_read_pair(file, pair) for pair in root.findall("disable_collisions")}
    unknown = {link for pair in disabled for link in pair} - links
    _log_unknown(logging.WARNING, file, "links in <disable_collisions>", unknown)
    states = _states(file, root, model)
    return Semantics(
        end_effector=effector.get("parent_link") if effector is not None else None,
        chains=tuple((str(chain.get("base_link")), str(chain.get("tip_link"))) for chain in root.findall("group/chain")),
        disabled=frozenset(disabled),
        states=states,
    )


def _read_pair(file: Path, pair: ET.Element) -> frozenset[str]:
    """The two links of a <disable_collisions>."""
    for name in ("link1", "link2", *pair.attrib):
        if name not in pair.attrib or name not in ("link1", "link2", "reason"):
            wanted = f"<disable_collisions> with link1, link2 and a reason, not with {', '.join(pair.attrib)}"
            raise FileFormatError("srdf", str(file), wanted)
    return frozenset((pair.attrib["link1"], pair.attrib["link2"]))


def _states(file: Path, root: ET.Element, model: pin.Model) -> tuple[tuple[str, Mapping[str, float]], ...]:
    """Name and joint values of each named state."""
    sizes = {name: model.joints[k].nq for k, name in enumerate(model.names)}
    known = (
        {frame.name for frame in model.frames} | {FLOATING} | {str(each.get("name")) for each in root.findall("virtual_joint")}
    )
    states, seen, unknown = [], set[tuple[str, str | None]](), set[str]()
    for state in root.findall("group_state"):
        called = state.get("name")
        if not called:
            raise FileFormatError("srdf", str(file), "a name for every <group_state>")
        if (called, state.get("group")) in seen:
            raise FileFormatError("srdf", str(file), f"each state of a group once; {called} is there twice")
        seen.add((called, state.get("group")))
        values: dict[str, float] = {}
        for joint in state.findall("joint"):
            name, text = str(joint.get("name")), joint.get("value")
            value = numbers(text, 1)
            if name in values and value != (values[name],):
                wanted = f"one value per joint of a state; {name} of {called} is {values[name]:g} and {text!r}"
                raise FileFormatError("srdf", str(file), wanted)
            if name not in known:
                unknown.add(name)
            several = numbers(text, len(str(text).split())) is not None and sizes.get(name, 0) != 1
            if value is not None:
                values[name] = value[0]
            elif not several:  # a floating base has several values: it is not a joint of an arm
                wanted = f"finite joint values, one number per joint; {name} of the state {called} is {text!r}"
                raise FileFormatError("srdf", str(file), wanted)
        states.append((called, values))
    _log_unknown(logging.INFO, file, "joints in <group_state>", unknown)
    return tuple(states)


def _log_unknown(level: int, file: Path, where: str, unknown: set[str]) -> None:
    if unknown:
        more = f" and {len(unknown) - 12} more" if len(unknown) > 12 else ""
        log.log(level, "%s: %s that the robot does not have: %s%s", file, where, ", ".join(sorted(unknown)[:12]), more)


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
