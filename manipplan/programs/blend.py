"""Blends: rounded corners between motions, so that the arm need not stop there.

A blend is a curve in joint space that has the tangents and curvatures of the two motions at its ends. Its inner control points
are moved until each tool stays in the convex hull of the two pieces of its way that the blend replaces.

Convex hulls of points, also flat ones, and how far other points are beyond them.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from manipplan.collision.path_clearance import path_clearance
from manipplan.constraints.constraint_set import ConstraintSet, prove
from manipplan.kinematics.kinematics import Kinematics
from manipplan.paths.joint import JointPath, bernstein, cut, raised
from manipplan.programs.leg_motions import RawMotion
from manipplan.support.checks import Array
from manipplan.support.status import Failure
from manipplan.timing.stops import CORNER, turn_cosine

#: Weight of the sum of shares in the distances that are minimised; points are scaled to the size of the hull.
WEIGHT = 1e3
#: Smallest size to which points are scaled [m].
SMALLEST = 1e-4


@dataclass(frozen=True, kw_only=True, eq=False)
class BlendHull:
    """The convex hull of points.

    Attributes:
        points: (k, 3) [m].
        size: largest distance of one of them from the first [m].
    """

    points: Array
    size: float

    @classmethod
    def of(cls, points: Array) -> "BlendHull":
        """The hull of points (k, 3)."""
        return cls(points=points, size=max(float(np.linalg.norm(points - points[0], axis=1).max()), SMALLEST))

    def beyond(self, points: Array) -> Array:
        """The vectors (k, 3) from the nearest point of the hull to each of some points (k, 3) [m]; zero for those inside."""
        from scipy.optimize import nnls

        made = np.zeros(points.shape)
        goal = np.array([0.0, 0.0, 0.0, WEIGHT])
        for row, point in enumerate(points):
            columns = np.vstack([(self.points - point).T / self.size, np.full(len(self.points), WEIGHT)])
            shares, _ = nnls(columns, goal)
            made[row] = point - shares @ self.points / shares.sum()
        return made


#: Number of samples of a motion at which the tool's distance from a corner is measured, of a blend, and of a piece it replaces.
CORNER_SAMPLES, BLEND_SAMPLES, PIECE_SAMPLES = 400, 100, 50
#: Largest share of a free motion that a blend takes at either end, and of the tool's way along a path that all its blends take.
MOST, OF_PATH = 0.45, 0.5
#: Number of halvings of a blend that is not allowed.
HALVINGS = 4
#: Cosine of a turn below which a motion goes straight back.
BACK = -0.98
#: Largest distance of the tool from the convex hull [m], and share of it at which a blend is found.
HULL, ENOUGH = 1e-4, 0.5
#: Degree of a blend, number of times its control points are moved, and largest distance that is mended, as share of its size.
DEGREE, ROUNDS, MENDED = 9, 12, 0.5
#: Weight of the control points in the distances that are minimised [m per rad or m].
DAMPING = 1e-4


@dataclass(frozen=True, kw_only=True, eq=False)
class Blend:
    """A rounded corner.

    Attributes:
        leaves, joins: the s at which it leaves the motion before and joins that after.
        path: the curve between.
        radius: the tool stays within it from the corner [m].
        note: why it is smaller than asked for; "" if it is not.
        tools, hulls: how the arm moves each tool, and the convex hull of the pieces of its way that the blend replaces.
    """

    leaves: float
    joins: float
    path: JointPath
    radius: float
    note: str
    tools: Sequence["ToolWay"]
    hulls: Sequence[BlendHull]

    def beyond(self, q: Array) -> float:
        """Largest distance of a tool from its hull at configurations (k, n) [m]."""
        off = [hull.beyond(tool.points(q)) for hull, tool in zip(self.hulls, self.tools, strict=True)]
        return float(np.linalg.norm(off, axis=2).max())


@dataclass(frozen=True, kw_only=True, eq=False)
class ToolWay:
    """How a motion moves one of the arm's tools.

    Attributes:
        kinematics: of the tool's arm.
        joints: those of the robot that move it.
    """

    kinematics: Kinematics
    joints: Sequence[int]

    def points(self, q: Array) -> Array:
        """Positions (k, 3) of the tool at q (k, n)."""
        return np.asarray(self.kinematics.pose(q[:, self.joints])[:, :3, 3])

    def jacobians(self, q: Array) -> Array:
        """Derivatives (k, 3, n) of these positions."""
        made = np.zeros((len(q), 3, q.shape[1]))
        made[:, :, self.joints] = self.kinematics.jacobian(q[:, self.joints])[:, :3]
        return made


def blend_of(
    before: RawMotion,
    after: RawMotion,
    asked: float,
    clearance: float,
    constraints: tuple[ConstraintSet, ...],
    *,
    alone: tuple[bool, bool] = (False, False),
) -> Blend | Failure:
    """The widest blend of two motions whose tool stays within the radius asked for [m] of their corner and that is proven free.

    `alone`: whether it is the only blend of the motion before, and of that after. Failure tells why there is none: then the arm
    stops at the corner.
    """
    if _turn(before.path, after.path) < BACK:
        return Failure(message="the second motion goes straight back")
    distance = asked
    for motion, only in zip((before, after), alone, strict=True):
        if motion.workspace_path is not None and motion.workspace_path.length > 0:
            distance = min(distance, OF_PATH * (1.0 if only else 0.5) * motion.workspace_path.length)
    robot, corner = before.state.robot, before.path.goal[None]
    tools = [ToolWay(kinematics=robot.arm(tool).kinematics(), joints=list(robot.joints_of(tool))) for tool in robot.tools]

    def away(path: JointPath, s: Array) -> Array:
        """Distances (k,) of the tool from the corner; of several the largest."""
        q = np.concatenate([corner, path(s)])
        points = [each.points(q) for each in tools]
        return np.asarray(np.max([np.linalg.norm(each[1:] - each[0], axis=1) for each in points], axis=0))

    refused = "half of each path along which the tool moves is left" if distance < asked else ""
    for _ in range(HALVINGS + 1):
        leaves = 1 - _reach(lambda s: away(before.path, 1 - s), distance)
        joins = _reach(lambda s: away(after.path, s), distance)
        replaced = np.concatenate([before.path(_between(leaves, 1.0)), after.path(_between(0.0, joins))])
        hulls = [BlendHull.of(each.points(replaced)) for each in tools]
        path = _inside(_quintic(before.path, leaves, after.path, joins), hulls, tools, distance)
        if path is None:
            reason = "it would leave the convex hull of the pieces that it replaces"
        elif away(path, _evenly(BLEND_SAMPLES)).max() > distance:
            reason = "it would leave the neighbourhood of the corner"
        else:
            reason = _forbidden(path, before, clearance, constraints)
        if path is not None and not reason:
            return Blend(leaves=leaves, joins=joins, path=path, radius=distance, note=refused, tools=tools, hulls=hulls)
        refused = reason
        distance /= 2
    return Failure(message=refused)


def is_corner(before: JointPath, after: JointPath) -> bool:
    """Whether the arm has to stop between two paths."""
    return bool(_turn(before, after) < np.cos(CORNER))


def _turn(before: JointPath, after: JointPath) -> float:
    return turn_cosine(before.control[-1], after.control[0])


def find_unblended(blends: list[Blend | None]) -> list[tuple[float, float]]:
    """The s between which each of the motions keeps its own path."""
    begins = [0.0, *(0.0 if each is None else each.joins for each in blends)]
    ends = [*(1.0 if each is None else each.leaves for each in blends), 1.0]
    return list(zip(begins, ends, strict=True))


def with_blends(motions: list[RawMotion], blends: list[Blend | None]) -> tuple[JointPath, list[tuple[float, float]]]:
    """One path through motions with their blends, and the s of it between which it keeps the path of each motion."""
    pieces: list[JointPath] = []
    spans: list[tuple[float, float]] = []  # in lengths from the start
    length = 0.0
    for motion, own, blend in zip(motions, find_unblended(blends), [*blends, None], strict=True):
        pieces.append(cut(motion.path, *own))
        spans.append((length, length + pieces[-1].length))
        length = spans[-1][1]
        if blend is not None:
            pieces.append(blend.path)
            length += blend.path.length
    return JointPath.joined(pieces), [(begin / length, end / length) for begin, end in spans]


def _reach(away: Callable[[Array], Array], distance: float) -> float:
    """The s up to which the tool stays within a distance [m] of s = 0, at most MOST."""
    s = _evenly(CORNER_SAMPLES) * MOST
    outside = np.flatnonzero(away(s) > distance)
    return float(s[max(outside[0] - 1, 1)]) if len(outside) else MOST


def _evenly(count: int) -> Array:
    return np.linspace(0.0, 1.0, count + 1)


def _between(begin: float, end: float) -> Array:
    return np.linspace(begin, end, PIECE_SAMPLES + 1)


def _inside(path: JointPath, hulls: Sequence[BlendHull], tools: Sequence[ToolWay], size: float) -> JointPath | None:
    """A path with the same ends on which each tool stays in its hull, found from one of degree 5; None where none was found.

    The points where a tool is outside are moved to the nearest of the hull, by Gauss-Newton steps of the control points that do
    not change the ends, their tangents and their curvatures.
    """
    control = raised(path.control, DEGREE)[0]
    basis = bernstein(DEGREE, _evenly(BLEND_SAMPLES))
    inner = basis[:, 3:-3]
    for _ in range(ROUNDS):
        q = basis @ control
        off = np.array([hull.beyond(tool.points(q)) for hull, tool in zip(hulls, tools, strict=True)])
        worst = float(np.linalg.norm(off, axis=2).max())
        if worst <= ENOUGH * HULL:
            return JointPath(breaks=path.breaks, control=control[None])
        if worst > MENDED * size:
            return None
        jacobians = np.array([tool.jacobians(q) for tool in tools])
        rows = np.einsum("ki,tkcj->tkcij", inner, jacobians).reshape(off.size, -1)
        rows = np.concatenate([rows, DAMPING * np.eye(rows.shape[1])])
        wanted = np.concatenate([-off.ravel(), np.zeros(rows.shape[1])])
        control[3:-3] += np.linalg.lstsq(rows, wanted, rcond=None)[0].reshape(inner.shape[1], -1)
    return None


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


def _forbidden(path: JointPath, motion: RawMotion, clearance: float, constraints: tuple[ConstraintSet, ...]) -> str:
    """What a path violates; "" for nothing."""
    if (motion.state.robot.limits.outside(np.array(path.bounds())) > 0).any():
        return "it would leave the joint limits"
    if not all(prove(each, path).kept for each in constraints if each.constraints):
        return "it would break a constraint"
    model = motion.state.scene.collision_model(motion.state.robot)
    if model.pair_names and not path_clearance(model, path, clearance=clearance, tolerance=None).proven:
        return "it would come too near to a body"
    return ""
