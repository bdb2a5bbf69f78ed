"""Configurations that reach a goal of several tools: the solutions of each arm, joined where they are free of each other."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.model import CollisionModel
from manipplan.cost.integral import PathIntegral
from manipplan.jobs.goals.pose_goal import PoseGoal
from manipplan.jobs.goals.reach import nearest
from manipplan.jobs.goals.samples import nearest_turns, reaching
from manipplan.jobs.goals.torsos import shared_joints, torsos
from manipplan.measures.over_tools import OverTools
from manipplan.robots.arms import arm_of
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.memo import once_per_owner

#: Number of the best solutions of each arm that are joined, and largest difference of a joint below which two count as one.
JOINED, APART = 48, 0.25
#: Number of joined configurations that are kept: free ones, and others where none is free.
FREE, OTHERS = 64, 16
#: Distance below which bodies of one arm touch [m].
TOUCHING = 1e-9


@dataclass(frozen=True, kw_only=True, eq=False)
class OwnArm:
    """The joints that move one tool alone, as an arm whose other joints are locked at the robot's neutral posture.

    Attributes:
        arm: the arm.
        joints: indices of its joints.
        carrier: index, from 1, of the last joint that moves it and another tool; 0: the world.
        home: (4, 4) place of that joint in the neutral posture.
    """

    arm: Robot
    joints: tuple[int, ...]
    carrier: int
    home: Array


@dataclass(frozen=True, kw_only=True, eq=False)
class Joined:
    """Configurations (k, n) that reach a goal of several tools, perhaps in collision; those that do not, with the reason."""

    q: Array
    useless: tuple[tuple[Array, str], ...]


@once_per_owner
def own_arms(robot: Robot) -> Mapping[str, OwnArm]:
    """The arm of each tool without the joints that it shares."""
    shared, data, found = shared_joints(robot), robot.model.createData(), {}
    pin.forwardKinematics(robot.model, data, np.asarray(robot.neutral))
    for tool in robot.tools:
        joints = tuple(i for i in robot.joints_of(tool) if i not in shared)
        carrier = max((i + 1 for i in robot.joints_of(tool) if i in shared), default=0)
        arm = arm_of(robot, tool, joints, robot.neutral)
        found[tool] = OwnArm(arm=arm, joints=joints, carrier=carrier, home=data.oMi[carrier].homogeneous)
    return found


def reaching_tools(
    goals: Mapping[str, PoseGoal],
    start: Array,
    model: CollisionModel,
    integral: PathIntegral,
    clearance: float,
    held: NDArray[np.bool_],
) -> Joined:
    """Configurations that reach the goal of each tool named; the arms of the others stay where they are at `start` (n,).

    Each arm's solutions are those of its own joints, for some values of the joints that it shares. Of those that are free alone
    the best are joined: those whose manipulability is largest, up to that of the start, then the nearest to the start.
    """
    robot = model.robot
    places = torsos(robot, goals, start, held)
    solutions, useless = [], []
    for tool, goal in goals.items():
        q, torso, missed = _solutions(robot, tool, goal, places, start, held)
        if not len(q):
            useless.append(missed)
            continue
        free = ~_touching(model, q, tool, clearance)
        if not free.any():  # the reasons tell which bodies touch
            return Joined(q=q[:OTHERS], useless=())
        q, torso = q[free], torso[free]
        best = _best(robot, tool, q, start, integral)
        solutions.append((robot.joints_of(tool), q[best], torso[best]))
    if useless:
        return Joined(q=np.zeros((0, robot.n)), useless=tuple(useless))
    joined = _joined(robot, solutions, places)
    figures = np.minimum(integral.kinematics.manipulability(joined), integral.kinematics.manipulability(start[None]))
    joined = joined[np.lexsort((np.linalg.norm(joined - start, axis=1), -figures.round(12)))]
    touching = model.in_collision_rows(joined, clearance=clearance)
    return Joined(q=joined[~touching][:FREE] if not touching.all() else joined[:OTHERS], useless=())


def _solutions(
    robot: Robot, tool: str, goal: PoseGoal, places: Array, start: Array, held: NDArray[np.bool_]
) -> tuple[Array, NDArray[np.int64], tuple[Array, str]]:
    """Configurations (k, n) that reach the goal of one tool, the torso (k,) of each, and the nearest one if there is none."""
    own = own_arms(robot)[tool]
    joints, near = list(own.joints), start[list(own.joints)]
    moved = [_seen_from(robot, own, goal, torso) for torso in places]
    if held[joints].any():
        found, rows = [], []
        for k, each in enumerate(nearest(own.arm, moved, near, held[joints])):
            found.append(each.reaching)
            rows += [k] * len(each.reaching)
        q, torso = np.concatenate(found), np.array(rows, dtype=np.int64)
    else:
        reached = reaching(own.arm, dict(enumerate(moved)), near)
        q, torso = reached.q, reached.goals
    if not len(q):
        first = nearest(own.arm, moved[:1], near, held[joints])[0]
        if len(first.reaching):
            q, torso = first.reaching, np.zeros(len(first.reaching), dtype=np.int64)
        else:
            away = start.copy()
            away[joints] = first.q
            return np.zeros((0, robot.n)), torso, (away, f"left out: {tool} is {first}")
    whole = places[torso].copy()
    whole[:, joints] = nearest_turns(own.arm, q, near)
    return whole, torso, (start, "")


def _seen_from(robot: Robot, own: OwnArm, goal: PoseGoal, torso: Array) -> PoseGoal:
    """The goal of a tool where its own arm would have to reach with the shared joints at their neutral posture."""
    if own.carrier == 0:
        return goal
    data = robot.model.createData()
    pin.forwardKinematics(robot.model, data, torso)
    return replace(goal, pose=own.home @ np.linalg.inv(data.oMi[own.carrier].homogeneous) @ goal.matrix)


def _touching(model: CollisionModel, q: Array, tool: str, clearance: float) -> NDArray[np.bool_]:
    """Whether the arm of one tool touches itself or what stands still, whatever the others do, at q (k, n); (k,)."""
    joints = {0, *(i + 1 for i in model.robot.joints_of(tool))}
    objects, pairs = model.geometry.geometryObjects, model.geometry.collisionPairs
    alone = np.array([{objects[p.first].parentJoint, objects[p.second].parentJoint} <= joints for p in pairs], dtype=bool)
    near = model.near_pairs(q, max(clearance, TOUCHING))
    touching = np.zeros(len(q), dtype=bool)
    touching[near.rows[alone[near.pairs] & ~(near.distances > clearance)]] = True
    return touching


def _best(robot: Robot, tool: str, q: Array, start: Array, integral: PathIntegral) -> list[int]:
    """Rows of the best solutions (k, n) of one tool, none near another."""
    kinematics, measure = integral.kinematics, integral.kinematics.measure
    figures = np.zeros(len(q))
    if isinstance(measure, OverTools):
        joints = list(robot.joints_of(tool))
        one = robot.arm(tool).kinematics(kinematics.task, measure=measure.measure, threads=1)
        figures = np.minimum(one.manipulability(q[:, joints]), one.manipulability(start[None, joints]))
    chosen: list[int] = []
    for k in np.lexsort((np.linalg.norm(q - start, axis=1), -figures.round(12))).tolist():
        if all(np.abs(q[k] - q[j]).max() > APART for j in chosen):
            chosen.append(k)
        if len(chosen) == JOINED:
            break
    return chosen


def _joined(robot: Robot, solutions: Sequence[tuple[tuple[int, ...], Array, NDArray[np.int64]]], places: Array) -> Array:
    """All configurations (k, n) that have a solution of each arm with the same torso."""
    found = [np.zeros((0, robot.n))]
    for number, torso in enumerate(places):
        q = torso[None]
        for joints, rows, of in solutions:
            own = rows[of == number][:, list(joints)]
            q = np.repeat(q, len(own), axis=0)
            q[:, list(joints)] = np.tile(own, (len(q) // max(len(own), 1), 1))
        found.append(q)
    return np.concatenate(found)
