"""Write a robot as MoveIt's semantic description (SRDF): joint group, tool, named states, pairs that need no check."""

import xml.etree.ElementTree as ET
from collections.abc import Mapping
from pathlib import Path

from numpy.typing import ArrayLike

from manipplan.robots.robot import Robot
from manipplan.support.checks import distinct_names, finite_array
from manipplan.support.errors import InvalidInputError
from manipplan.support.files import write_bytes


def to_srdf(robot: Robot, file: str | Path, states: Mapping[str, ArrayLike] | None = None, *, group: str = "arm") -> None:
    """Write an SRDF with the arm as one group; see `Robot.to_srdf`."""
    states = robot.named_states if states is None else states
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
    for pair in sorted(sorted(pair) for pair in robot.disabled_pairs or ()):
        ET.SubElement(root, "disable_collisions", link1=pair[0], link2=pair[-1], reason="User")
    ET.indent(root)
    write_bytes(file, lambda stream: ET.ElementTree(root).write(stream, encoding="utf-8", xml_declaration=True))
