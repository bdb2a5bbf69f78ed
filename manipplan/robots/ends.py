"""The tool frame of a description where the user names none: the one end of its only arm, or the body that carries its fingers.

The rule, in this order:

1. An SRDF decides: its first `<end_effector>`, or the tip of its only `<chain>`.
2. An end that no joint moves, such as `base` on the base link, does not count. Neither does an end on a body that carries
   further joints, such as a camera on the forearm of an arm that goes on.
3. Fingers are not ends; the body that carries them is. Fingers are several sibling branches, and no other branch, on one body
   that at least two joints move. Each has at most two joints that are not followers, all of limited travel (or with the name of
   a gripper, as a motor has), and reaches no further than 0.25 m and half the length of the arm. One branch alone is a jaw if,
   besides, it is a single joint of less than half a turn or 0.2 m, carries no tool frame, and has the name of a jaw: finger,
   jaw, claw, knuckle or thumb in the joint or its link, gripper in the joint, or gripper in the links on both sides. A joint
   called roll, pitch, yaw, wrist or similar is none.
4. Of several ends on one rigid body, the name decides, in the order of `NAMES`; then it is the only frame without collision
   geometry that is no sensor's. Where the body carries fingers, only ends fixed beyond the link of the fingers count, and
   otherwise it is that link.
5. A site of an MJCF file on the body that is chosen is the tool where its name decides, in the order of `NAMES` and `SITES`,
   with or without `_site` at its end. A body whose own name comes no later remains the tool.
6. Linkages do not count beside others, such as the piston of a balancer: ends that are moved, apart from joints of the arm,
   only by followers of joints inside the arm, and whose names are not those of fingers.

Anything else, such as two arms, or an arm and a head, is an error, which lists the ends.
"""

import logging
import re
from collections.abc import Iterable, Sequence
from functools import cached_property

import numpy as np
import pinocchio as pin

from manipplan.robots.description import Description
from manipplan.robots.hulls import box_corners
from manipplan.robots.model_tree import frame_index, is_prismatic, is_revolute, parent_bodies
from manipplan.robots.srdf import Semantics
from manipplan.support.errors import FileFormatError, InvalidInputError

log = logging.getLogger("manipplan")

#: Patterns of names of tool frames; of several ends on one rigid body the first pattern that one matches decides.
NAMES = (
    r"tool0",
    r"tcp",
    r".*_tcp",
    r".*tcp.*",
    r"flange",
    r".*tool0",
    r".*flange",
    r"ee_link",
    r".*ee_link",
    r".*(eef|end_?effector.*|_ee)",
    r".*grasp.*",
    r".*gripper_?frame.*",
    r".*tool.*",
)
#: Further patterns, of names of sites of an MJCF file.
SITES = ("pinch", "attachment", "ee", "end", "tip", "gripper")
#: Largest reach of a finger [m], and as a share of the length of the arm that carries it.
FINGER, FINGER_SHARE = 0.25, 0.5
#: Largest number of joints of a finger that follow no other, and with those that do; smallest number that carries a hand.
JOINTS, LINKAGE, CARRIED = 2, 4, 2
#: Travel below which a single joint can be that of a jaw [rad], [m].
JAW_TURN, JAW_SLIDE = np.pi, 0.2
#: Words that name a finger, and those that name a joint of a wrist.
FINGERS = re.compile("finger|jaw|knuckle|claw|thumb|pincer", re.IGNORECASE)
WRIST = re.compile("roll|pitch|yaw|rot|wrist|pan|tilt|twist|turn|spin", re.IGNORECASE)
GRIP = re.compile("grip", re.IGNORECASE)
#: Words that name a sensor, whose frame is no tool.
SENSORS = re.compile("camera|optical|sensor|imu|depth|color|infra", re.IGNORECASE)
#: Number of ends that a message lists.
LISTED = 8


def default_tool(read: Description, semantic: Semantics | None) -> str:
    """The tool frame by the rule above; raises InvalidInputError, which lists the ends, where it does not decide."""
    tree = _LinkTree(read)
    if semantic is not None and semantic.end_effector is not None:
        return semantic.end_effector
    if semantic is not None and semantic.chains:
        tips = tree.tips(semantic.chains)
        if len(tips) > 1:
            raise _several(tree, "the SRDF has chains to several tips", tips)
        if tips:
            log.info("%s: the tool is %s, the tip of the SRDF's chain", read.file.name, tips[0])
            return tips[0]
    end_joints = tree.find_end_joints()
    if not end_joints:
        raise FileFormatError("file", str(read.file), "a robot with at least one body")
    if len(end_joints) > 1:
        end_joints.sort(key=lambda joint: -len(tree.model.supports[joint]))  # the arm before the wheels
        raise _several(tree, "the description has several ends", [name for joint in end_joints for name in tree.shown(joint)])
    [joint] = end_joints
    chosen = tree.chosen(joint)
    if chosen is None:
        raise _several(tree, "the description has several ends on one body", tree.shown(joint))
    if joint in tree.hands:
        fingers = [str(tree.model.names[k]) for kid in tree.hands[joint] for k in tree.below(kid)]
        log.info(
            "%s: the tool is %s, on the body that carries the fingers; locked: %s", read.file.name, chosen, ", ".join(fingers)
        )
    elif len(tree.ends) > 1:
        others = ", ".join(name for name in map(tree.name, tree.ends) if name != chosen)
        log.info("%s: the tool is %s; other ends: %s", read.file.name, chosen, others)
    sites = tree.sites(joint)
    if not sites:
        return chosen
    others = ", ".join(list(sites)[:LISTED])
    near = [name for name, body in sites.items() if body == chosen and not SENSORS.search(name)]
    site = _first_named([chosen, *near], (*NAMES, *SITES))
    if site is None or site == chosen:
        log.info("%s: the tool is the body %s; sites that move with it: %s", read.file.name, chosen, others)
        return chosen
    log.info("%s: the tool is the site %s of the body %s; sites that move with it: %s", read.file.name, site, chosen, others)
    return site


def _several(tree: "_LinkTree", what: str, names: Sequence[str]) -> InvalidInputError:
    """The error that lists the ends, with the calls that work."""
    shown = ", ".join(names[:LISTED]) + (f" and {len(names) - LISTED} more" if len(names) > LISTED else "")
    call = f"tool={names[0]!r}"
    other = next((name for name in names[1:] if tree.are_alike(names[0], name)), None)
    two = f", or tool=[{names[0]!r}, {other!r}] for both" if other is not None else ""
    return InvalidInputError("tool", None, f"a frame name; {what}: {shown}. Choose one, as in {call}{two}")


class _LinkTree:
    """The bodies and joints of a description, by the index of their frame and joint."""

    def __init__(self, read: Description) -> None:
        self.model, self.mimics, self.bodies = read.model, read.mimics, read.geometry.geometryObjects

    def name(self, body: int) -> str:
        """Name of a body."""
        return str(self.model.frames[body].name)

    def joint(self, body: int) -> int:
        """The joint that moves a body; 0: none."""
        return int(self.model.frames[body].parentJoint)

    @cached_property
    def parents(self) -> dict[int, int]:
        """The body that carries each body, through whatever joint; 0: the world."""
        return parent_bodies(self.model)

    @cached_property
    def ends(self) -> list[int]:
        """The bodies that carry no further body and that a joint moves; all, where none is moved."""
        leaves = [body for body in sorted(self.parents) if body not in self.parents.values()]
        return [body for body in leaves if self.joint(body)] or leaves

    @cached_property
    def kids(self) -> dict[int, list[int]]:
        """The joints on the rigid body of each joint."""
        found: dict[int, list[int]] = {j: [] for j in range(self.model.njoints)}
        for j in range(1, self.model.njoints):
            found[int(self.model.parents[j])].append(j)
        return found

    @cached_property
    def hands(self) -> dict[int, list[int]]:
        """The first joint of each finger, by the joint whose rigid body carries them; the outermost hands."""
        found: dict[int, list[int]] = {}
        for j in range(1, self.model.njoints):  # Pinocchio numbers a joint after the one that carries it
            above = [k for k in self.model.supports[j] if k in found]
            if not above and self._is_hand(j):
                found[j] = self.kids[j]
        return found

    def find_end_joints(self) -> list[int]:
        """The joints on whose rigid bodies the ends are, fingers and bodies that carry further joints left out."""
        held = {k: hand for hand, fingers in self.hands.items() for kid in fingers for k in self.below(kid)}
        joints = sorted({held.get(self.joint(body), self.joint(body)) for body in self.ends})
        joints = [j for j in joints if not self._is_linkage(j, joints)] or joints
        inner = {int(k) for j in joints for k in self.model.supports[j] if k != j}
        return [j for j in joints if j not in inner]

    def _is_linkage(self, joint: int, joints: Sequence[int]) -> bool:
        """Whether all joints that move an end, and not another end beside it as well, follow joints elsewhere."""
        shared = {int(k) for j in joints if j != joint for k in self.model.supports[j]}
        own = [str(self.model.names[k]) for k in self.model.supports[joint] if k not in shared]
        bodies = [self.name(body) for body in self.ends if self.joint(body) == joint]
        if not own or any(FINGERS.search(name) or GRIP.search(name) for name in (*own, *bodies)):
            return False
        leaders = [self.mimics[name].leader if name in self.mimics else name for name in own]
        inner = [name for name in leaders if name not in own and self.model.existJointName(name)]
        return len(inner) == len(own) and all(len(self.below(self.model.getJointId(name))) > JOINTS for name in inner)

    def chosen(self, joint: int) -> str | None:
        """The tool frame on the rigid body of a joint; None where several ends have names that do not decide."""
        ends, carrier = [body for body in self.ends if self.joint(body) == joint], None
        if joint in self.hands:
            carrier = self._carrier(self.hands[joint])
            ends = [body for body in ends if carrier in self._above(body)]
        elif len(ends) == 1:
            return self.name(ends[0])
        solid = {item.parentFrame for item in self.bodies}
        bare = [body for body in ends if body not in solid and not SENSORS.search(self.name(body))]
        only = bare[0] if len(bare) == 1 else carrier
        return _first_named(list(map(self.name, ends))) or (None if only is None else self.name(only))

    def shown(self, joint: int) -> list[str]:
        """The ends on the rigid body of a joint, for a message."""
        chosen = self.chosen(joint)
        return [self.name(body) for body in self.ends if self.joint(body) == joint] if chosen is None else [chosen]

    def sites(self, joint: int) -> dict[str, str]:
        """The sites of an MJCF file on the rigid body of a joint, and the body of each; not those that share a body's name."""
        frames = self.model.frames
        names = dict.fromkeys(str(each.name) for each in frames if each.parentJoint == joint)
        found = {name: frames[frame_index(self.model, name)] for name in names}
        sites = {name: frame for name, frame in found.items() if frame.type == pin.FrameType.OP_FRAME}
        return {name: str(frames[frame.parentFrame].name) for name, frame in sites.items()}

    def tips(self, chains: Iterable[tuple[str, str]]) -> list[str]:
        """Tips of an SRDF's chains, but for those without a joint and those in a finger; each once."""
        fingers = {k for each in self.hands.values() for kid in each for k in self.below(kid)}
        found: list[str] = []
        for base, tip in chains:
            if self.model.existFrame(base) and self.model.existFrame(tip):
                first, last = (int(self.model.frames[frame_index(self.model, name)].parentJoint) for name in (base, tip))
                if first == last or last in fingers:
                    continue
            if tip not in found:
                found.append(tip)
        return found

    def are_alike(self, one: str, other: str) -> bool:
        """Whether two frames are moved by as many joints each, not all of them the same."""
        if not (self.model.existFrame(one) and self.model.existFrame(other)):
            return False
        a, b = (set(self.model.supports[self.model.frames[frame_index(self.model, name)].parentJoint]) for name in (one, other))
        return a != b and len(a) == len(b)

    def below(self, joint: int) -> list[int]:
        """A joint and all that it carries."""
        return [j for j in range(1, self.model.njoints) if joint in self.model.supports[j]]

    def _is_hand(self, joint: int) -> bool:
        """Whether all that the rigid body of a joint carries are fingers, or one jaw."""
        kids, carried_by = self.kids[joint], len(self.model.supports[joint]) - 1
        if not kids or carried_by < CARRIED or not all(self._is_finger(kid, joint) for kid in kids):
            return False
        return len(kids) > 1 or self._is_jaw(kids[0], joint)

    def _is_finger(self, kid: int, carrier: int) -> bool:
        """Whether a branch has the few joints, the limits and the reach of a finger."""
        length = sum(
            float(np.linalg.norm(self.model.jointPlacements[k].translation)) for k in self.model.supports[carrier] if k
        )
        before, reach = set(self.model.supports[carrier]), 0.0
        for j in self.below(kid):
            path = [k for k in self.model.supports[j] if k not in before]
            free = [k for k in path if self.model.names[k] not in self.mimics]
            is_limited = np.isfinite(self._travel(j)) or self._is_named(j)
            if len(free) > JOINTS or len(path) > LINKAGE or not is_limited:
                return False
            steps = [float(np.linalg.norm(self.model.jointPlacements[k].translation)) for k in path[1:]]
            slides = [self._travel(k) for k in path if is_prismatic(self.model.joints[k])]
            reach = max(reach, sum(steps) + sum(slides) + self._extent(j))
        return reach <= min(FINGER, FINGER_SHARE * length)

    def _is_named(self, joint: int) -> bool:
        """Whether a joint without limits turns, and its name is that of a gripper, as that of a motor beside the fingers."""
        name = str(self.model.names[joint])
        return (
            is_revolute(self.model.joints[joint]) and bool(FINGERS.search(name) or GRIP.search(name)) and not WRIST.search(name)
        )

    def _is_jaw(self, kid: int, carrier: int) -> bool:
        """Whether a single branch is a jaw: its names say so, and a last joint of a wrist would not have its travel."""
        bodies = [body for body in self.parents if self.joint(body) == kid]
        if len(self.below(kid)) > 1 or any(_rank(self.name(body)) < len(NAMES) for body in bodies):
            return False
        if self._travel(kid) >= (JAW_SLIDE if is_prismatic(self.model.joints[kid]) else JAW_TURN):
            return False
        joint, moving = str(self.model.names[kid]), " ".join(map(self.name, bodies))
        standing = " ".join(self.name(body) for body in self.parents if self.joint(body) == carrier)
        if WRIST.search(joint):
            return False
        return bool(
            FINGERS.search(f"{joint} {moving}") or GRIP.search(joint) or (GRIP.search(moving) and GRIP.search(standing))
        )

    def _travel(self, joint: int) -> float:
        """Range of a joint [rad or m]; inf without limits, and for joints of several numbers."""
        kind = self.model.joints[joint]
        if not (is_revolute(kind) or is_prismatic(kind)):
            return float(np.inf)
        return float(self.model.upperPositionLimit[kind.idx_q] - self.model.lowerPositionLimit[kind.idx_q])

    def _extent(self, joint: int) -> float:
        """Largest distance of a frame or body on the rigid body of a joint from the joint's origin [m]."""
        found = [
            float(np.linalg.norm(frame.placement.translation)) for frame in self.model.frames if frame.parentJoint == joint
        ]
        for item in self.bodies:
            if item.parentJoint == joint:
                placed = box_corners(item.geometry) @ item.placement.rotation.T + item.placement.translation
                found.append(float(np.linalg.norm(placed, axis=1).max()))
        return max(found, default=0.0)

    def _above(self, body: int) -> list[int]:
        """A body and those that carry it, up to the root."""
        found = [body]
        while self.parents[found[-1]]:
            found.append(self.parents[found[-1]])
        return found

    def _carrier(self, fingers: Sequence[int]) -> int:
        """The last body that carries all fingers, given by their first joints."""
        roots = [body for body in self.parents if self.joint(body) in fingers and self.joint(self.parents[body]) not in fingers]
        common = [set(self._above(self.parents[body])) for body in roots]
        return next(body for body in self._above(self.parents[roots[0]]) if all(body in each for each in common))


def _rank(name: str, patterns: Sequence[str] = NAMES) -> int:
    """Place of the first pattern that a name matches, without a prefix such as `left/` and `_site`; their number for none."""
    name = re.sub("^.*[/:]|_?site$", "", name, flags=re.IGNORECASE)
    return next((k for k, pattern in enumerate(patterns) if re.fullmatch(pattern, name, re.IGNORECASE)), len(patterns))


def _first_named(names: Sequence[str], patterns: Sequence[str] = NAMES) -> str | None:
    """The name that comes first in `patterns`; None where none or several do."""
    best = min((_rank(name, patterns) for name in names), default=len(patterns))
    found = [name for name in names if _rank(name, patterns) == best]
    return found[0] if len(found) == 1 and best < len(patterns) else None
