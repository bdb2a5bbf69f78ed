"""Where slides, and the joints that are held with them, can be so that the rest of an arm still reaches a pose.

A slide may be far longer than the arm. Its grid, and random starts, are confined to boxes of joint values. A box is left out
where a bound proves that no value in it lets the other joints bridge the distance to the pose:

The axis of each other revolute joint carries a point. Neighbouring points have a distance that only swept joints between them
change, and so has the pose from the last of them, once the swept joints behind it are undone. These distances close a polygon,
which is impossible where one side is longer than the others together. A swept joint changes a side by at most its lever arm
times its angle, or by its travel.

The compiled code of inverse kinematics: `inverse.c`, with its headers.

The values in which an arm's joints are enumerated, one turn of a joint that goes around, and how far the tool is in them.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from typing import Any

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.ik.geometry import Screws
from manipplan.robots.arms import lengths_to, tool_reach
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.kernels import load_kernel
from manipplan.support.memo import once_per_source

#: Revolute joints whose limits span more full turns than this are enumerated in one turn, like those without limits.
TURNS = 8


def span(robot: Robot) -> tuple[Array, Array]:
    """Limits (n,) in which each joint is enumerated: one turn of a revolute joint with no limits or with more than `TURNS`."""
    lower, upper = robot.limits.lower, robot.limits.upper
    around = spans_turn(robot)
    inside = around & (lower <= -np.pi) & (upper >= np.pi)
    low = np.where(inside | np.isinf(lower), -np.pi, lower)
    return low, np.where(around, low + 2 * np.pi, upper)


def spans_turn(robot: Robot) -> NDArray[np.bool_]:
    """Whether each joint (n,) is enumerated in one turn only, which brings the arm back to the same posture."""
    return np.asarray(robot.turns & (robot.limits.upper - robot.limits.lower > 2 * np.pi * TURNS))


def in_turn(robot: Robot, q: Array) -> Array:
    """Configurations (k, n) with the joints that are enumerated in one turn brought into it."""
    low = span(robot)[0]
    return np.where(spans_turn(robot), low + (q - low) % (2 * np.pi), q)


def line(lower: float, upper: float, count: int) -> Array:
    """Evenly spaced values between two limits, with both; one alone in their middle."""
    return np.linspace(lower, upper, count) if count > 1 else np.array([(lower + upper) / 2])


def slides_of(robot: Robot) -> tuple[int, ...]:
    """Indices of the prismatic joints."""
    return tuple(k for k, kind in enumerate(robot.joint_types) if kind == "prismatic")


def within_reach(robot: Robot) -> tuple[Array, Array]:
    """Limits (n,) as of `span`, with slides no farther out than the other links are long."""
    (lower, upper), slides = span(robot), list(slides_of(robot))
    if slides:
        still = robot.with_limits(
            lower=np.where(np.isin(np.arange(robot.n), slides), -1e-9, robot.limits.lower),
            upper=np.where(np.isin(np.arange(robot.n), slides), 1e-9, robot.limits.upper),
        )
        length = max(each for _, each in lengths_to(still, robot.tool))
        middle = np.clip(0.0, lower[slides], upper[slides])
        lower[slides], upper[slides] = np.maximum(lower[slides], middle - length), np.minimum(upper[slides], middle + length)
    return lower, upper


def reach_in(robot: Robot, limits: tuple[Array, Array]) -> tuple[Array, float]:
    """A ball that holds every place of the tool with slides inside limits (n,): centre (3,) and radius [m]."""
    screws = Screws.of(robot)
    slides, (lower, upper) = list(slides_of(robot)), limits
    low, high = robot.limits.lower.copy(), robot.limits.upper.copy()
    low[slides], high[slides] = lower[slides], upper[slides]
    if screws.follow is not None:
        return tool_reach(robot.with_limits(lower=low, upper=high), robot.tool)
    leading = int(np.argmin(np.append(screws.slides, False)))
    middle = np.zeros(robot.n)
    middle[:leading] = (lower + upper)[:leading] / 2
    data = robot.model.createData()
    pin.forwardKinematics(robot.model, data, middle)
    radius = float(np.abs((upper - lower)[:leading] / 2).sum())
    if leading == robot.n:
        return screws.home[:3, 3] + middle @ screws.axes, radius
    length = lengths_to(robot.with_limits(lower=low, upper=high), robot.tool)[leading][1]
    return data.oMi[joints_moved(robot)[leading]].translation.copy(), radius + length


def joints_moved(robot: Robot) -> list[int]:
    """For each entry of q the joint of the model that it moves, where it moves only one between base and tool."""
    return [joint for joint, _ in lengths_to(robot, robot.tool)] if robot.followers else list(range(1, robot.n + 1))


#: Number of boxes for random values and for the window of slides.
BOXES = 256
#: Weight of the angle of a swept joint beside the travel that it causes, as a share of the length that the others bridge.
ANGLE = 0.2
#: Maximum number of times that boxes are halved, and of numbers that are compared at once.
HALVINGS, AT_ONCE = 400, 2_000_000
#: Reach assumed for joints that move together [m]: the bound assumes independent joints, so it is disabled for them.
UNBOUNDED = 1e9
#: Violation of the bound that rounding may cause [m].
CLOSE = 1e-9
#: Smallest share of a regular grid that the bound may leave; below it, values are taken from boxes.
REGULAR = 0.25


@dataclass(frozen=True, kw_only=True, eq=False)
class HeldValues:
    """Values (s, g) of swept joints.

    Attributes:
        values: (s, g) [rad or m].
        missing: share of the values for which the bound decides nothing, where their step exceeds what the other joints bridge,
            so that solutions in between may be missed; otherwise 0.
    """

    values: Array
    missing: float


@dataclass(frozen=True, kw_only=True, eq=False)
class _Boxes:
    """Boxes of values of swept joints: their limits (k, g), the violation (k,) of the bound at their middles [m], the sum (k,)
    by which it changes at most inside, and the travel per unit (k, g) that each joint causes.
    """

    lower: Array
    upper: Array
    violation: Array
    change: Array
    levers: Array

    def rows(self, indices: NDArray[np.bool_] | NDArray[np.intp]) -> "_Boxes":
        return _Boxes(**{name: each[indices] for name, each in vars(self).items()})


class Bridge:
    """What an arm's other joints can bridge while some joints are swept over boxes of values.

    Args:
        robot: the arm.
        swept: indices of the swept joints, ascending.
        whole_pose: whether the orientation of the tool is given too; otherwise its position alone.
    """

    def __init__(self, robot: Robot, swept: Sequence[int], *, whole_pose: bool) -> None:
        self._screws, self._swept, lower, upper = Screws.of(robot), tuple(swept), *span(robot)
        self.lower, self.upper = lower[list(swept)], upper[list(swept)]
        self._decides, self.reach = self._screws.follow is None, UNBOUNDED
        if not self._decides:
            return
        slides = self._screws.slides
        turning = [k for k in range(robot.n) if k not in swept and not slides[k]]
        self._whole = whole_pose and bool(turning)
        points = _points_on_axes(robot, self._screws, turning)
        if not self._whole:
            turning, points = [*turning, robot.n], np.vstack([points, self._screws.home[:3, 3]])
        self._points = points
        edges = [-1, *turning, robot.n]
        groups = [[j for j in swept if before < j < after] for before, after in pairwise(edges)]
        self._leading, self._between, self._trailing = groups[0], groups[1:-1], groups[-1]
        travel = np.maximum(np.abs(robot.limits.lower), np.abs(robot.limits.upper))
        self._slack = float(sum(travel[k] for k in range(robot.n) if slides[k] and k not in swept))
        sides = np.linalg.norm(np.diff(points, axis=0), axis=1)
        self.reach = self._slack + float(
            sum(side for side, group in zip(sides, self._between, strict=True) if not slides[group].any())
        )

    def values(self, counts: Sequence[int], poses: Array) -> HeldValues:
        """A grid of the swept joints for poses (p, 4, 4): counts (g,) values of each inside its limits or its window there, or
        as many in all, one per box, where the bound leaves little of a regular grid.
        """
        regular = self._regular(self.lower, self.upper, counts, poses)
        if regular is not None and not regular.missing:
            return regular
        boxes = self._boxes(int(np.prod(counts)), poses)
        narrowed = self._regular(boxes.lower.min(axis=0), boxes.upper.max(axis=0), counts, poses)
        if narrowed is not None and not narrowed.missing:
            return narrowed
        middles, step = (boxes.lower + boxes.upper) / 2, boxes.upper - boxes.lower
        return HeldValues(values=middles, missing=self._missing(boxes.violation, boxes.levers, step))

    def window(self, poses: Array) -> tuple[Array, Array]:
        """Limits (g,) that hold every value of the swept joints with which one of poses (p, 4, 4) is reached."""
        boxes = self._boxes(BOXES, poses)
        return boxes.lower.min(axis=0), boxes.upper.max(axis=0)

    def around(self, pose: Array) -> tuple[Array, Array]:
        """Limits (k, g) of boxes that hold every value of the swept joints with which a pose (4, 4) is reached."""
        boxes = self._boxes(BOXES, pose[None])
        return boxes.lower, boxes.upper

    def allows(self, values: Array, pose: Array) -> bool:
        """Whether the bound allows that a pose (4, 4) is reached with values (g,) of the swept joints."""
        at = self._bound_boxes(values[None], values[None], pose[None])
        return bool(at.violation[0] <= CLOSE)

    def _regular(self, lower: Array, upper: Array, counts: Sequence[int], poses: Array) -> HeldValues | None:
        """A regular grid between limits (g,); None where the bound leaves little of it."""
        lines = [line(*each) for each in zip(lower, upper, counts, strict=True)]
        values = np.stack(np.meshgrid(*lines, indexing="ij"), axis=-1).reshape(-1, len(lines))
        at = self._bound_boxes(values, values, poses)
        if (at.violation <= 0).mean() < REGULAR:
            return None
        step = (upper - lower) / np.maximum(np.array(counts) - 1, 1)
        return HeldValues(values=values, missing=self._missing(at.violation, at.levers, np.broadcast_to(step, values.shape)))

    def _missing(self, violation: Array, levers: Array, step: Array) -> float:
        """The share of values without a solution for certain, where a step (k, g) exceeds what the others bridge; else 0."""
        travel = levers * step
        if not (travel > self.reach).any():
            return 0.0
        slides = self._screws.slides[list(self._swept)]
        coarse = (travel > self.reach) & (slides | (levers > self.reach))
        return max(float((violation > 0).mean()), 1 / (1 + len(step))) if coarse.any() else 0.0

    def _boxes(self, count: int, poses: Array) -> _Boxes:
        """At least `count` boxes that hold every value with which one of poses (p, 4, 4) is reached; else the nearest."""
        boxes = self._feasible(self._bound_boxes(self.lower[None], self.upper[None], poses))
        for _ in range(HALVINGS):
            sizes = (boxes.levers + ANGLE * self.reach) * (boxes.upper - boxes.lower)
            largest = sizes.max(axis=1)
            if len(boxes.lower) >= count or not largest.max() > 1e-12:
                break
            halved = largest > largest.max() / 2
            some, joints = boxes.rows(halved), sizes[halved].argmax(axis=1)
            rows = np.arange(len(joints))
            middle = (some.lower + some.upper)[rows, joints] / 2
            lower, upper = some.lower.copy(), some.upper.copy()
            upper[rows, joints], lower[rows, joints] = middle, middle
            new = self._bound_boxes(np.vstack([some.lower, lower]), np.vstack([upper, some.upper]), poses)
            rest = boxes.rows(~halved)
            every = {name: np.concatenate([each, vars(new)[name]]) for name, each in vars(rest).items()}
            boxes = self._feasible(_Boxes(**every))
        return boxes

    def _feasible(self, boxes: _Boxes) -> _Boxes:
        """The boxes that the bound does not exclude; if it excludes all, the one with the smallest violation."""
        beyond = boxes.violation - boxes.change
        left = beyond <= CLOSE * (1 + boxes.change)
        return boxes.rows(left if left.any() else np.array([int(beyond.argmin())]))

    def _bound_boxes(self, lower: Array, upper: Array, poses: Array) -> _Boxes:
        """The boxes between lower and upper (k, g), with what the bound says about them."""
        if not self._decides:
            none = np.zeros(len(lower))
            return _Boxes(lower=lower, upper=upper, violation=none, change=none, levers=np.ones(lower.shape))
        middle, half = (lower + upper) / 2, (upper - lower) / 2
        first, levers = self._sweep_point(self._leading, 1.0, self._points[0], middle, half)
        sides = np.empty((len(middle), len(self._between)))
        for k, group in enumerate(self._between):
            point, own = self._sweep_point(group, 1.0, self._points[k + 1], middle, half)
            sides[:, k] = np.linalg.norm(point - self._points[k], axis=1)
            other = self._sweep_point(group[::-1], -1.0, self._points[k], middle, half)[1]
            levers = levers + np.minimum(own, other)  # to turn one end of the side is to turn the other end back
        targets = poses[:, :3, 3]
        if self._whole:
            behind, own = self._sweep_point(self._trailing[::-1], -1.0, self._points[-1], middle, half)
            levers = levers + own
            undone = poses @ np.linalg.inv(self._screws.home)
        total, longest = sides.sum(axis=1) + self._slack, sides.max(axis=1, initial=0.0)
        violation = np.full(len(middle), np.inf)
        for begin in range(0, len(poses), max(1, AT_ONCE // len(middle))):
            some = slice(begin, begin + max(1, AT_ONCE // len(middle)))
            if self._whole:
                ends = np.einsum("pij,kj->pki", undone[some, :3, :3], behind) + undone[some, None, :3, 3]
            else:
                ends = targets[some, None]
            apart = np.linalg.norm(ends - first, axis=2)
            violation = np.minimum(violation, np.maximum(apart - total, 2 * longest - total - apart).min(axis=0))
        change = np.minimum(levers * half, np.where(self._screws.slides[list(self._swept)], np.inf, 2 * levers)).sum(axis=1)
        return _Boxes(lower=lower, upper=upper, violation=violation, change=change, levers=levers)

    def _sweep_point(self, joints: Sequence[int], sign: float, point: Array, middle: Array, half: Array) -> tuple[Array, Array]:
        """Places (k, 3) of a point that swept joints carry, the first of them outermost, and the travel per unit (k, g) that
        each causes at most in boxes with these middles and half widths (k, g).
        """
        place, moved, levers = np.tile(point, (len(middle), 1)), np.zeros(len(middle)), np.zeros(middle.shape)
        for joint in reversed(joints):
            column, h, p = self._swept.index(joint), self._screws.axes[joint], self._screws.points[joint]
            value = sign * middle[:, column, None]
            if self._screws.slides[joint]:
                place, lever = place + value * h, np.ones(len(middle))
            else:
                arm = place - p
                across = np.cross(h, arm)
                lever = np.linalg.norm(across, axis=1) + moved
                place = p + arm * np.cos(value) + across * np.sin(value) + (arm @ h)[:, None] * h * (1 - np.cos(value))
            levers[:, column] = lever
            moved = moved + lever * half[:, column]
        return place, levers


@once_per_source
def bridge(robot: Robot, swept: tuple[int, ...], whole_pose: bool) -> Bridge:
    """The `Bridge` of an arm; built once."""
    return Bridge(robot, swept, whole_pose=whole_pose)


def _points_on_axes(robot: Robot, screws: Screws, joints: list[int]) -> Array:
    """A point (j, 3) on the axis of each joint, near those on the axes before and behind it."""
    data = robot.model.createData()
    pin.forwardKinematics(robot.model, data, pin.neutral(robot.model))
    carriers = joints_moved(robot)
    points = np.array([data.oMi[carriers[joint]].translation for joint in joints]).reshape(-1, 3)
    for _ in range(20 if len(joints) > 1 else 0):
        for k, joint in enumerate(joints):
            beside = np.concatenate([points[k - 1 : k] if k else points[:0], points[k + 1 : k + 2]])
            h, p = screws.axes[joint], screws.points[joint]
            points[k] = p + (beside.mean(axis=0) - p) @ h * h
    return points


#: As in spherical.h: arrangement of the axes of the three joints a, b, c that place the point where the others meet.
A_MEETS_B, B_MEETS_C, A_PARALLEL_B, B_PARALLEL_C, SKEW = range(5)


@cache
def ik_functions() -> Mapping[str, Callable[..., Any]]:
    """The functions of inverse.c: closed forms and Newton steps."""
    return load_kernel("inverse").functions()


def as_float64(values: Any) -> Array:
    """A contiguous float64 array; not copied if it already is one."""
    return np.ascontiguousarray(values, dtype=np.float64)


def as_int64(values: Any) -> NDArray[np.int64]:
    """A contiguous int64 array."""
    return np.ascontiguousarray(values, dtype=np.int64)


def as_bool(values: Any) -> NDArray[np.bool_]:
    """A contiguous bool array."""
    return np.ascontiguousarray(values, dtype=np.bool_)


def arrangement(axes: Array, points: Array) -> tuple[int, Array, float]:
    """Arrangement of the first three of axes and points (k, 3), the point (3,) where two meet, and the deviation [m].

    The arrangement is A_MEETS_B, ... or SKEW; for parallel axes the deviation is the sine of their angle.
    """
    axes, points, out = as_float64(axes), as_float64(points), np.empty(4)
    kind = ik_functions()["arrangement"](axes.ctypes.data, points.ctypes.data, out.ctypes.data)
    return int(kind), out[:3], float(out[3])


def quartic_roots(coefficients: Array) -> NDArray[np.complex128]:
    """The roots (4,) of x⁴ + a[3] x³ + a[2] x² + a[1] x + a[0] for a (4,); none where a is not finite."""
    a, out = as_float64(coefficients), np.empty((4, 2))
    count = ik_functions()["quartic"](a.ctypes.data, out.ctypes.data)
    return np.asarray(out[:count, 0] + 1j * out[:count, 1])


def swivels_of(axes: Array, points: Array, shoulder: Array, wrist: Array, q: Array) -> Array:
    """The swivel [rad] of each row of q (k, 7), for axes and points (7, 3), a shoulder (3,) and a wrist (3,)."""
    axes, points, shoulder, wrist, q = (as_float64(each) for each in (axes, points, shoulder, wrist, q))
    out = np.empty(len(q))
    addresses = (each.ctypes.data for each in (axes, points, shoulder, wrist, q))
    ik_functions()["swivels"](*addresses, len(q), out.ctypes.data)
    return out
