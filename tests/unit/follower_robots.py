"""Robots with joints that follow others, written for the tests, and Pinocchio's model of the whole file as their oracle."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pinocchio as pin

import manipplan as mp

BOX = '<collision><origin xyz="{at}"/><geometry><box size="{size}"/></geometry></collision>'
MASS = (
    '<inertial><origin xyz="0.02 0.01 0.05"/><mass value="{mass}"/>'
    '<inertia ixx="0.02" iyy="0.03" izz="0.01" ixy="0.001" ixz="0" iyz="0"/></inertial>'
)


def link(name, *boxes, mass=2.0):
    return f'<link name="{name}">{MASS.format(mass=mass)}{"".join(BOX.format(at=at, size=size) for at, size in boxes)}</link>'


def joint(name, parent, child, xyz, axis, *, rpy="0 0 0", limit=(-2.6, 2.6), velocity=2.0, kind="revolute", mimic=None):
    follows = "" if mimic is None else '<mimic joint="{}" multiplier="{}" offset="{}"/>'.format(*mimic)
    return (
        f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/><origin xyz="{xyz}" rpy="{rpy}"/>'
        f'<axis xyz="{axis}"/><limit lower="{limit[0]}" upper="{limit[1]}" velocity="{velocity}" effort="400"/>{follows}</joint>'
    )


def fixed(name, parent, child, xyz, rpy="0 0 0"):
    return f'<joint name="{name}" type="fixed"><parent link="{parent}"/><child link="{child}"/><origin xyz="{xyz}" rpy="{rpy}"/></joint>'


def arm(prefix, base, xyz, rpy="0 0 0"):
    """Five joints and a hand; the first axis is upright."""
    p = prefix
    return (
        joint(f"{p}1", base, f"{p}l1", xyz, "0 0 1", rpy=rpy)
        + link(f"{p}l1", ("0 0 0.08", "0.1 0.1 0.16"))
        + joint(f"{p}2", f"{p}l1", f"{p}l2", "0 0 0.2", "0 1 0")
        + link(f"{p}l2", ("0.15 0 0", "0.3 0.08 0.08"))
        + joint(f"{p}3", f"{p}l2", f"{p}l3", "0.35 0 0", "0 1 0")
        + link(f"{p}l3", ("0.13 0 0", "0.24 0.07 0.07"))
        + joint(f"{p}4", f"{p}l3", f"{p}l4", "0.3 0 0", "1 0 0")
        + link(f"{p}l4", ("0.03 0 0", "0.05 0.06 0.06"))
        + joint(f"{p}5", f"{p}l4", f"{p}l5", "0.08 0 0", "0 1 0")
        + link(f"{p}l5", ("0.04 0 0", "0.06 0.04 0.04"))
        + joint(f"{p}6", f"{p}l5", f"{p}l6", "0.08 0 0", "1 0 0")
        + link(f"{p}l6", ("0.03 0 0", "0.05 0.05 0.05"))
        + fixed(f"{p}t", f"{p}l6", f"{p}tool", "0.1 0 0")
        + f'<link name="{p}tool"/>'
    )


SHOULDER = (
    link("base", ("0 0 0.1", "0.3 0.3 0.2"))
    + joint("j1", "base", "l1", "0 0 0.3", "0 0 1")
    + link("l1", ("0 0 0.1", "0.16 0.16 0.2"))
    + joint("j2", "l1", "l2", "0.1 0 0.25", "0 1 0", limit=(-1.5, 1.5))
    + link("l2", ("0 0 0.25", "0.1 0.1 0.5"))
)
#: As on a painting robot: the hollow wrist has three axes, the middle ones at a slant and one motor for both.
HOLLOW = (
    SHOULDER
    + joint("j3", "l2", "l3", "0 0 0.6", "0 1 0", limit=(-2.0, 1.2))
    + link("l3", ("0.25 0 0", "0.5 0.1 0.1"))
    + joint("j4", "l3", "l4", "0.6 0 0", "1 0 0")
    + link("l4", ("0.03 0 0", "0.06 0.08 0.08"))
    + joint("j5", "l4", "l5", "0.08 0 0", "0.8 0 0.6", velocity=3.0)
    + link("l5", ("0.02 0 0", "0.04 0.06 0.06"))
    + joint("j5b", "l5", "l5b", "0.07 0 0", "0.8 0 -0.6", velocity=1.5, limit=(-2.0, 2.0), mimic=("j5", 1.0, 0.0))
    + link("l5b", ("0.02 0 0", "0.04 0.06 0.06"))
    + joint("j6", "l5b", "l6", "0.07 0 0", "1 0 0")
    + link("l6", ("0.03 0 0", "0.06 0.05 0.05"))
    + fixed("jt", "l6", "tool", "0.1 0 0.02")
    + '<link name="tool"/>'
)
#: Four joints and two followers that keep the tool level, as parallel linkages do.
PALLETISER = (
    SHOULDER
    + joint("j3", "l2", "l3", "0 0 0.6", "0 1 0", limit=(-1.4, 1.4))
    + link("l3", ("0.3 0 0", "0.6 0.1 0.1"))
    + joint("level2", "l3", "w2", "0.7 0 0", "0 1 0", limit=(-1.3, 1.6), mimic=("j2", -1.0, 0.0))
    + link("w2", mass=0.5)
    + joint("level3", "w2", "w3", "0 0 0", "0 1 0", limit=(-3, 3), mimic=("j3", -1.0, 0.0))
    + link("w3", ("0.06 0 0", "0.12 0.1 0.08"))
    + joint("j4", "w3", "l4", "0.15 0 -0.05", "0 0 1", limit=(-3, 3), velocity=4.0)
    + link("l4", ("0 0 -0.06", "0.1 0.1 0.1"))
    + fixed("jt", "l4", "tool", "0 0 -0.15", "3.14159265358979 0 0")
    + '<link name="tool"/>'
)
#: Two arms on a torso, each half of which has an axis of its own; the second mimics the first.
TORSO = (
    link("base", ("0 0 0.2", "0.2 0.2 0.4"))
    + joint("b1", "base", "torso1", "0 0 0.45", "0 0 1", limit=(-1.5, 1.5))
    + link("torso1", ("0 0 0.15", "0.1 0.1 0.3"))
    + arm("left", "torso1", "0 0.25 0.3", "0 0 0.4")
    + joint("b2", "base", "torso2", "0 0 0.45", "0 0 1", limit=(-1.2, 1.5), velocity=1.0, mimic=("b1", 1.0, 0.0))
    + link("torso2", ("0 0 0.35", "0.12 0.12 0.1"))
    + arm("right", "torso2", "0 -0.25 0.3", "0 0 -0.4")
)
#: A wrist whose second half turns twice as far the other way, from an offset.
DOUBLE = (
    SHOULDER
    + joint("j3", "l2", "l3", "0 0 0.6", "0 1 0", limit=(-2.0, 1.2))
    + link("l3", ("0.25 0 0", "0.5 0.1 0.1"))
    + joint("j4", "l3", "l4", "0.6 0 0", "1 0 0")
    + link("l4", ("0.03 0 0", "0.06 0.08 0.08"))
    + joint("j5", "l4", "l5", "0.1 0 0", "0 1 0")
    + link("l5", ("0.03 0 0", "0.06 0.06 0.06"))
    + joint("j5b", "l5", "l5b", "0.1 0 0", "0 0.6 0.8", rpy="0.2 0 0", limit=(-1.4, 2.2), velocity=2.5, mimic=("j5", -1.5, 0.4))
    + link("l5b", ("0.03 0 0", "0.06 0.05 0.05"))
    + joint("j6", "l5b", "l6", "0.1 0 0", "1 0 0")
    + link("l6", ("0.03 0 0", "0.06 0.05 0.05"))
    + fixed("jt", "l6", "tool", "0.1 0 0")
    + '<link name="tool"/>'
)
#: A finger-like arm: each joint follows the one before, the last by two steps and a slide.
CHAIN = (
    link("base", ("0 0 0.1", "0.2 0.2 0.2"))
    + joint("j1", "base", "l1", "0 0 0.3", "0 0 1")
    + link("l1", ("0 0 0.1", "0.1 0.1 0.2"))
    + joint("j2", "l1", "l2", "0 0 0.3", "0 1 0", limit=(-1.5, 1.5))
    + link("l2", ("0.12 0 0", "0.24 0.06 0.06"))
    + joint("j3", "l2", "l3", "0.3 0 0", "0 1 0", limit=(-2, 2), mimic=("j2", 0.8, 0.1))
    + link("l3", ("0.12 0 0", "0.24 0.06 0.06"))
    + joint("j4", "l3", "l4", "0.3 0 0", "0 1 0", limit=(-2, 2), mimic=("j3", 0.7, -0.2))
    + link("l4", ("0.08 0 0", "0.16 0.05 0.05"))
    + joint("reach", "l4", "l5", "0.2 0 0", "1 0 0", kind="prismatic", limit=(-0.4, 0.4), velocity=1.0, mimic=("j4", 0.1, 0.05))
    + link("l5", ("0.05 0 0", "0.1 0.04 0.04"))
    + joint("j5", "l5", "l6", "0.15 0 0", "0 0 1", limit=(-2, 2))
    + link("l6", ("0.05 0 0", "0.1 0.04 0.04"))
    + fixed("jt", "l6", "tool", "0.12 0 0")
    + '<link name="tool"/>'
)


def telescope(first, second):
    """A mast of two equal stages; one of them mimics the other."""
    return (
        link("base", ("0 0 0.1", "0.3 0.3 0.2"))
        + joint("stage1", "base", "s1", "0 0 0.3", "0 0 1", kind="prismatic", limit=(0, 0.5), velocity=0.5, mimic=first)
        + link("s1", ("0 0 0.1", "0.14 0.14 0.3"))
        + joint("stage2", "s1", "s2", "0 0 0.1", "0 0 1", kind="prismatic", limit=(0, 0.5), velocity=0.5, mimic=second)
        + link("s2", ("0 0 0.15", "0.1 0.1 0.3"))
        + arm("a", "s2", "0 0 0.35")
    )


#: The second stage mimics the first, or the first, which carries it, mimics the second.
TELESCOPE = telescope(None, ("stage1", 1.0, 0.0))
UPSTREAM = telescope(("stage2", 1.0, 0.0), None)
ROBOTS = {
    "hollow": (HOLLOW, "tool"),
    "palletiser": (PALLETISER, "tool"),
    "torso-left": (TORSO, "lefttool"),
    "torso-right": (TORSO, "righttool"),
    "double": (DOUBLE, "tool"),
    "chain": (CHAIN, "tool"),
    "telescope": (TELESCOPE, "atool"),
    "upstream": (UPSTREAM, "atool"),
    "torso": (TORSO, ("lefttool", "righttool")),
}
ONE_TOOL = [name for name in ROBOTS if name != "torso"]


@dataclass(frozen=True)
class Whole:
    """The whole file as Pinocchio reads it, each joint with a number of its own; followers are placed by hand.

    `matrix` and `offset` give all positions of q (n,): matrix @ q + offset.
    """

    model: pin.Model
    geometry: pin.GeometryModel
    matrix: np.ndarray
    offset: np.ndarray

    @classmethod
    def of(cls, file: Path, robot: mp.Robot) -> "Whole":
        """The joints of a file by those of a robot; what it neither moves nor lets follow is at 0."""
        model = pin.buildModelFromUrdf(str(file))
        geometry = pin.buildGeomFromUrdf(model, str(file), pin.GeometryType.COLLISION)
        matrix, offset = np.zeros((model.nq, robot.n)), np.zeros(model.nq)
        import xml.etree.ElementTree as ET

        mimics = {}
        for each in ET.parse(file).getroot().findall("joint"):
            mimic = each.find("mimic")
            if mimic is not None:
                mimics[each.get("name")] = mimic.get("joint"), float(mimic.get("multiplier")), float(mimic.get("offset"))

        def row(name):
            if name in robot.joint_names:
                return np.eye(robot.n)[robot.joint_names.index(name)], 0.0
            if name in mimics:
                leader, ratio, offset = mimics[name]
                line, start = row(leader)
                return ratio * line, ratio * start + offset
            return np.zeros(robot.n), robot.locked[name]

        for i, name in enumerate(list(model.names)[1:]):
            matrix[i], offset[i] = row(name)
        return cls(model, geometry, matrix, offset)

    def all(self, q):
        """All positions (..., N) at q (..., n)."""
        return np.asarray(q) @ self.matrix.T + self.offset

    def pose(self, q, frame):
        data = self.model.createData()
        pin.framesForwardKinematics(self.model, data, self.all(q))
        return data.oMf[self.model.getFrameId(frame, pin.FrameType.BODY)].homogeneous

    def jacobian(self, q, frame):
        data = self.model.createData()
        index = self.model.getFrameId(frame, pin.FrameType.BODY)
        return pin.computeFrameJacobian(self.model, data, self.all(q), index, pin.LOCAL_WORLD_ALIGNED) @ self.matrix


def written(folder, name):
    """The file of one of `ROBOTS`, the robot and its oracle."""
    text, tool = ROBOTS[name]
    file = Path(folder) / f"{name}.urdf"
    file.write_text(f'<robot name="{name}">{text}</robot>')
    robot = mp.Robot.from_urdf(file, tool=tool)
    return file, robot, Whole.of(file, robot)
