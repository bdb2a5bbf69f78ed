"""Blends: rounded corners between motions, so that the arm need not stop there."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from manipplan.collision.path_clearance import path_clearance
from manipplan.constraints.constraint_set import ConstraintSet
from manipplan.constraints.proof import prove
from manipplan.jobs.programs.courses import Motion
from manipplan.paths.joint import JointPath, cut
from manipplan.support.checks import Array
from manipplan.timing.stops import CORNER, turn_cosine

#: Number of places of a motion at which the tool's distance from a corner is measured, and of a blend.
PLACES, ALONG_BLEND = 400, 100
#: Largest share of a motion that a blend takes at either end, and number of halvings of a blend that is not free.
MOST, HALVINGS = 0.45, 4
#: Cosine of a turn below which a motion goes straight back.
BACK = -0.98


@dataclass(frozen=True, kw_only=True, eq=False)
class Blend:
    """A rounded corner: the s at which it leaves the motion before and joins that after, and its path."""

    leaves: float
    joins: float
    path: JointPath


def blend_of(
    before: Motion, after: Motion, distance: float, clearance: float, constraints: tuple[ConstraintSet, ...]
) -> Blend | None:
    """The widest blend of two motions whose tool stays within a distance [m] of their corner and that is proven free.

    None where no blend is free, or the second motion goes straight back: then the arm stops there.
    """
    if _turn(before.path, after.path) < BACK:
        return None
    robot, corner = before.state.robot, before.path.goal[None]
    tools = [(robot.arm(tool).kinematics(), list(robot.joints_of(tool))) for tool in robot.tools]

    def away(path: JointPath, s: Array) -> Array:
        """Distances (k,) of the tool from the corner; of several the largest."""
        q = np.concatenate([corner, path(s)])
        places = [kinematics.pose(q[:, joints])[:, :3, 3] for kinematics, joints in tools]
        return np.asarray(np.max([np.linalg.norm(each[1:] - each[0], axis=1) for each in places], axis=0))

    for _ in range(HALVINGS + 1):
        leaves = 1 - _reach(lambda s: away(before.path, 1 - s), distance)
        joins = _reach(lambda s: away(after.path, s), distance)
        path = _quintic(before.path, leaves, after.path, joins)
        if _is_allowed(path, before, clearance, constraints) and away(path, _evenly(ALONG_BLEND)).max() <= distance:
            return Blend(leaves=leaves, joins=joins, path=path)
        distance /= 2
    return None


def is_corner(before: JointPath, after: JointPath) -> bool:
    """Whether the arm has to stop between two paths."""
    return bool(_turn(before, after) < np.cos(CORNER))


def _turn(before: JointPath, after: JointPath) -> float:
    return turn_cosine(before.control[-1], after.control[0])


def unblended(blends: list[Blend | None]) -> list[tuple[float, float]]:
    """The s between which each of the motions keeps its own path."""
    begins = [0.0, *(0.0 if each is None else each.joins for each in blends)]
    ends = [*(1.0 if each is None else each.leaves for each in blends), 1.0]
    return list(zip(begins, ends, strict=True))


def with_blends(motions: list[Motion], blends: list[Blend | None]) -> tuple[JointPath, list[tuple[float, float]]]:
    """One path through motions with their blends, and the s of it between which it keeps the path of each motion."""
    pieces: list[JointPath] = []
    kept: list[tuple[float, float]] = []  # in lengths from the start
    length = 0.0
    for motion, own, blend in zip(motions, unblended(blends), [*blends, None], strict=True):
        pieces.append(cut(motion.path, *own))
        kept.append((length, length + pieces[-1].length))
        length = kept[-1][1]
        if blend is not None:
            pieces.append(blend.path)
            length += blend.path.length
    return JointPath.joined(pieces), [(begin / length, end / length) for begin, end in kept]


def _reach(away: Callable[[Array], Array], distance: float) -> float:
    """The s up to which the tool stays within a distance [m] of s = 0, at most MOST."""
    s = _evenly(PLACES) * MOST
    outside = np.flatnonzero(away(s) > distance)
    return float(s[max(outside[0] - 1, 1)]) if len(outside) else MOST


def _evenly(count: int) -> Array:
    return np.linspace(0.0, 1.0, count + 1)


def _quintic(before: JointPath, leaves: float, after: JointPath, joins: float) -> JointPath:
    """The curve between two paths that has their tangents and curvatures at its ends."""
    (p, u, a), (q, v, b) = (_arc(before, leaves), _arc(after, joins))
    length = float(np.linalg.norm(q - p)) * 1.05
    u, v, a, b = length * u, length * v, length**2 * a, length**2 * b
    control = np.array([p, p + u / 5, p + 2 * u / 5 + a / 20, q - 2 * v / 5 + b / 20, q - v / 5, q])
    return JointPath(breaks=np.array([0.0, 1.0]), control=control[None])


def _arc(path: JointPath, s: float) -> tuple[Array, Array, Array]:
    """Place, unit tangent and curvature vector of a path."""
    at, first, second = (path(np.array([s]), order)[0] for order in (0, 1, 2))
    speed = np.linalg.norm(first)
    tangent = first / speed
    return at, tangent, (second - (second @ tangent) * tangent) / speed**2


def _is_allowed(path: JointPath, motion: Motion, clearance: float, constraints: tuple[ConstraintSet, ...]) -> bool:
    if (motion.state.robot.limits.outside(np.array(path.bounds())) > 0).any():
        return False
    if not all(prove(each, path).kept for each in constraints if each.constraints):
        return False
    model = motion.state.scene.collision_model(motion.state.robot)
    return not model.pair_names or path_clearance(model, path, clearance=clearance, tolerance=None).proven
