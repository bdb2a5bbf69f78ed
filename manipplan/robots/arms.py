"""The arms of a robot: which joints move a tool, how far from them it can be, and the arm of one of several tools."""

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
import pinocchio as pin

from manipplan.robots.limits import JointLimits
from manipplan.robots.model_tree import JointTree, frame_index
from manipplan.robots.srdf import NamedStates
from manipplan.robots.subchain import reduce
from manipplan.support.checks import Array, one_of
from manipplan.support.errors import InvalidInputError
from manipplan.support.memo import once_per_owner

if TYPE_CHECKING:
    from manipplan.robots.robot import Robot


def check_tools(model: pin.Model, tools: Sequence[str]) -> None:
    """Raise InvalidInputError unless each tool has a joint that moves it and not all of the others."""
    if len(set(tools)) < len(tools):
        raise InvalidInputError("tool", list(tools), "each tool frame once")
    for tool in tools if len(tools) > 1 else ():
        for other in tools:
            if tool != other and set(carriers(model, tool)) <= set(carriers(model, other)):
                wanted = f"tools of different arms: every joint that moves {tool} also moves {other}"
                raise InvalidInputError("tool", list(tools), wanted)


def supports(model: pin.Model, frame: str) -> list[int]:
    """Indices in the model of the joints that carry a frame, from base to frame."""
    return [int(i) for i in model.supports[model.frames[frame_index(model, frame)].parentJoint] if i > 0]


def carriers(model: pin.Model, frame: str) -> list[int]:
    """Entries of q of the joints that move a frame: those that carry it and the leaders of those."""
    return sorted({int(model.joints[i].idx_q) for i in supports(model, frame)})


def shared_joints(robot: "Robot") -> list[int]:
    """Indices of the joints that move several tools, such as those of a torso."""
    moved = np.zeros(robot.n, dtype=int)
    for tool in robot.tools:
        moved[list(robot.joints_of(tool))] += 1
    found: list[int] = np.flatnonzero(moved > 1).tolist()
    return found


def own_joints(robot: "Robot", tool: str) -> list[int]:
    """Indices of the joints that move one tool and no other."""
    shared = shared_joints(robot)
    return [i for i in robot.joints_of(tool) if i not in shared]


def known_tool(robot: "Robot", argument: str, tool: Any) -> str:
    """The name of one of the robot's tools; raises UnknownNameError, which names the argument and the nearest names."""
    return one_of(argument, tool, robot.tools)


def led_by(robot: "Robot", tool: str) -> "Robot":
    """The same robot with one of its tools as the first."""
    others = tuple(each for each in robot.tools if each != tool)
    return robot if tool == robot.tool else replace(robot, tool=tool, other_tools=others)


def one_tool(robot: "Robot", work: str) -> "Robot":
    """The robot itself if it has one tool; otherwise raises InvalidInputError: `work` is done with one arm."""
    if len(robot.tools) > 1:
        each = " or ".join(f"robot.arm({tool!r})" for tool in robot.tools)
        raise InvalidInputError(
            "robot", f"{robot.name}, with {len(robot.tools)} tools", f"an arm with one tool: {work}. Use {each}"
        )
    return robot


def find_disabled_within_arms(
    model: pin.Model, tools: Sequence[str], disabled: frozenset[frozenset[str]]
) -> frozenset[frozenset[str]]:
    """The disabled pairs of links but for those of two arms, which are checked: arms meet where their SRDF expects it least.

    Baxter's disables forearm against forearm.
    """
    joints = [set(carriers(model, tool)) for tool in tools]
    own = [each.difference(*(joints[:k] + joints[k + 1 :])) for k, each in enumerate(joints)]
    carrier = {frame.name: model.joints[frame.parentJoint].idx_q for frame in model.frames if frame.type == pin.FrameType.BODY}

    def arms(pair: frozenset[str]) -> set[int]:
        return {k for link in pair for k, each in enumerate(own) if carrier.get(link) in each}

    return frozenset(pair for pair in disabled if len(arms(pair)) < 2) if len(tools) > 1 else disabled


@once_per_owner
def neutral_arm(robot: "Robot", tool: str) -> "Robot":
    """The arm of one tool, with the other joints at the neutral posture; built once."""
    return arm_of(robot, tool, carriers(robot.model, tool), robot.neutral)


def arm_of(robot: "Robot", tool: str, joints: Sequence[int], q: Array) -> "Robot":
    """The arm with one tool and some of the joints, by index; the others are locked at q (n,) and remain bodies to check."""
    names = robot.joint_names
    held = {name: float(q[i]) for i, name in enumerate(names) if i not in joints}
    held |= {name: mimic.position(held[mimic.leader]) for name, mimic in robot.followers.items() if mimic.leader in held}
    model, geometry = reduce(robot.model, robot.geometry, [names[i] for i in joints], held)
    columns = list(joints)
    limits = {
        kind: getattr(robot.limits, kind)[columns] for kind in ("lower", "upper", "velocity", "acceleration", "jerk", "effort")
    }
    states = NamedStates({name: state[columns] for name, state in robot.states.items()})
    return replace(
        robot,
        name=f"{robot.name} {tool}",
        model=model,
        geometry=geometry,
        tool=tool,
        other_tools=(),
        limits=JointLimits(**limits, sources=robot.limits.sources),
        neutral=robot.neutral[columns],
        locked={**robot.locked, **held},
        states=states,
        source=None,
        own_ik=None,
    )


def tool_reach(robot: "Robot", tool: str) -> tuple[Array, float]:
    """The place (3,) of the first joint that carries a tool, and the largest distance of the tool from there [m]."""
    joint, length = lengths_to(robot, tool)[0]
    return np.array(robot.model.jointPlacements[joint].translation), length


def lengths_to(robot: "Robot", tool: str) -> list[tuple[int, float]]:
    """The joints of the tree that carry a tool, from base to tool, and how far from the origin of each it is at most [m].

    It is the sum of the lengths of the links beyond the joint and of the travel of slides, its own included.
    """
    tree, model, found = robot.tree, robot.model, list[tuple[int, float]]()
    travel = farthest(robot, tree)
    frame = model.frames[frame_index(model, tool)]
    length, joint = float(np.linalg.norm(frame.placement.translation)), int(frame.parentJoint)
    while joint > 0:
        if tree.slides[joint - 1]:
            length += float(travel[joint - 1])
        found.insert(0, (joint, length))
        length += float(np.linalg.norm(model.jointPlacements[joint].translation))
        joint = int(model.parents[joint])
    return found


def farthest(robot: "Robot", tree: JointTree) -> Array:
    """The largest distance of each joint of the tree from its position 0 within the limits (N,) [rad or m]."""
    ends = np.array([tree.positions(limit) for limit in (robot.limits.lower, robot.limits.upper)])
    return np.asarray(np.abs(ends).max(axis=0))


def has_few_joints(robot: "Robot") -> bool:
    """Whether an arm has fewer joints than a pose of its tool needs: six, or three in a plane."""
    return robot.n < (3 if robot.planar else 6)
