"""Collision screening of many configurations: a quick lower bound of all distances saves most of the exact checks."""

import math
from dataclasses import dataclass

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.model import CollisionModel
from manipplan.collision.primitives import core_of
from manipplan.ik.geometry import Screws
from manipplan.ik.spherical import row
from manipplan.ik.subproblems import add, cross, dot, sub, turn_by, turned
from manipplan.support.checks import Array
from manipplan.support.kernels import kernel

#: Half the size of unbounded shapes [m].
ENDLESS = 1e6
#: Number of configurations screened at a time.
BLOCK = 2048


@dataclass(frozen=True, kw_only=True, eq=False)
class Screening:
    """A capsule and a box around every body of a collision model, at q = 0; g bodies, k pairs.

    Attributes:
        screws: the arm.
        carriers: (g,) number of joints, from the base, that move each body.
        ends: (2 g, 3) ends of the capsules' axes [m].
        radii: (g,) radii of the capsules [m].
        boxes: (4 g, 3) centre and three axes of each box.
        halves: (g, 3) half sides of the boxes [m].
        pairs: (k, 2) bodies of each checked pair.
    """

    screws: Screws
    carriers: NDArray[np.int64]
    ends: Array
    radii: Array
    boxes: Array
    halves: Array
    pairs: NDArray[np.int64]

    @classmethod
    def of(cls, model: CollisionModel) -> "Screening":
        """Build the screening of a collision model."""
        robot = model.robot
        data = robot.model.createData()
        pin.forwardKinematics(robot.model, data, np.zeros(robot.model.nq))
        carriers, ends, radii, boxes, halves = [], [], [], [], []
        for item in model.geometry.geometryObjects:
            place = data.oMi[item.parentJoint] * item.placement
            end, radius, box, half = _around(item.geometry)
            carriers.append(item.parentJoint)
            ends += [place.act(point) for point in end]
            radii.append(radius)
            boxes += [place.act(box[0]), *(place.rotation @ axis for axis in box[1:])]
            halves.append(half)
        return cls(
            screws=Screws.of(robot),
            carriers=np.array(carriers, dtype=np.int64),
            ends=np.array(ends).reshape(-1, 3),
            radii=np.array(radii),
            boxes=np.array(boxes).reshape(-1, 3),
            halves=np.array(halves).reshape(-1, 3),
            pairs=np.array([(p.first, p.second) for p in model.geometry.collisionPairs], dtype=np.int64).reshape(-1, 2),
        )

    def suspects(self, q: Array, clearance: float) -> NDArray[np.bool_]:
        """Pairs that may be as near as `clearance` [m] at q (k, n), a mask (k, pairs); the others certainly are not."""
        screws = self.screws
        found = np.empty((len(q), len(self.pairs)), dtype=np.bool_)
        _suspects(
            screws.axes,
            screws.points,
            screws.slides,
            self.carriers,
            self.ends,
            self.radii,
            self.boxes,
            self.halves,
            self.pairs,
            np.ascontiguousarray(q),
            clearance,
            found,
        )
        return found


def free_rows(screening: Screening, model: CollisionModel, q: Array, clearance: float) -> NDArray[np.bool_]:
    """Whether no pair touches, or comes nearer than `clearance` [m], at each row of q (k, n); exact."""
    free = np.ones(len(q), dtype=np.bool_)
    for begin in range(0, len(q), BLOCK):
        suspects = screening.suspects(q[begin : begin + BLOCK], clearance)
        for k in np.flatnonzero(suspects.any(axis=1)):
            free[begin + k] = not model.touches(q[begin + k], np.flatnonzero(suspects[k]), clearance=clearance)
    return free


def _around(shape: coal.CollisionGeometry) -> tuple[list[Array], float, list[Array], Array]:
    """Ends and radius of a capsule, centre with axes and half sides of a box; both contain the shape."""
    if isinstance(shape, coal.Halfspace | coal.Plane):
        normal = np.array(shape.n)
        across = np.linalg.svd(normal[None])[2]
        centre = normal * (shape.d - ENDLESS)
        return [centre, centre], 2 * ENDLESS, [centre, *across], np.full(3, ENDLESS)
    points, radius = core_of(shape)
    middle = (points.max(axis=0) + points.min(axis=0)) / 2
    axes = np.linalg.svd(points - points.mean(axis=0), full_matrices=True)[2]
    along = (points - middle) @ axes.T
    low, high = along.min(axis=0), along.max(axis=0)
    off = np.linalg.norm(along[:, 1:] - (low[1:] + high[1:]) / 2, axis=1).max()
    spine = np.array([(low[1:] + high[1:]) / 2] * 2)
    inner = min(off, (high[0] - low[0]) / 2)  # the hemispheres cover the ends
    ends = np.column_stack([[low[0] + inner, high[0] - inner], spine])
    nearest = np.column_stack([np.clip(along[:, 0], *ends[:, 0]), np.broadcast_to(spine[0], (len(along), 2))])
    thick = float(np.linalg.norm(along - nearest, axis=1).max()) + radius
    centre = middle + ((low + high) / 2) @ axes
    return list(middle + ends @ axes), thick, [centre, *axes], (high - low) / 2 + radius


@kernel
def _suspects(
    axes: Array,
    points: Array,
    slides: NDArray[np.bool_],
    carriers: NDArray[np.int64],
    ends: Array,
    radii: Array,
    boxes: Array,
    halves: Array,
    pairs: NDArray[np.int64],
    q: Array,
    clearance: float,
    found: NDArray[np.bool_],
) -> None:
    n, bodies = q.shape[1], len(carriers)
    turns, shifts = np.empty((n + 1, 3, 3)), np.zeros((n + 1, 3))
    turns[0] = np.eye(3)
    moved_ends, moved_boxes = np.empty_like(ends), np.empty_like(boxes)
    for k in range(len(q)):
        for j in range(n):  # e_1 ... e_j; its columns are the images of the unit vectors
            h, p = row(axes, j), row(points, j)
            before = turns[j]
            if slides[j]:
                turns[j + 1] = before
                move = (q[k, j] * h[0], q[k, j] * h[1], q[k, j] * h[2])
            else:
                turn_j = turn_by(q[k, j])
                for column in range(3):
                    unit = (1.0 * (column == 0), 1.0 * (column == 1), 1.0 * (column == 2))
                    v = turned(h, turn_j, unit)
                    for i in range(3):
                        turns[j + 1, i, column] = before[i, 0] * v[0] + before[i, 1] * v[1] + before[i, 2] * v[2]
                move = sub(p, turned(h, turn_j, p))
            for i in range(3):
                shifts[j + 1, i] = shifts[j, i] + before[i, 0] * move[0] + before[i, 1] * move[1] + before[i, 2] * move[2]
        for body in range(bodies):
            turn, shift = turns[carriers[body]], shifts[carriers[body]]
            for i in range(3):
                for a in (2 * body, 2 * body + 1):
                    moved_ends[a, i] = shift[i] + turn[i, 0] * ends[a, 0] + turn[i, 1] * ends[a, 1] + turn[i, 2] * ends[a, 2]
                for a in range(4 * body, 4 * body + 4):
                    moved_boxes[a, i] = turn[i, 0] * boxes[a, 0] + turn[i, 1] * boxes[a, 1] + turn[i, 2] * boxes[a, 2]
                moved_boxes[4 * body, i] += shift[i]
        for pair in range(len(pairs)):
            first, second = pairs[pair, 0], pairs[pair, 1]
            found[k, pair] = not (
                _apart(moved_ends, radii, first, moved_boxes, halves, second, clearance)
                or _apart(moved_ends, radii, second, moved_boxes, halves, first, clearance)
                or _spines_apart(moved_ends, first, second, radii[first] + radii[second] + clearance)
            )


@kernel
def _apart(ends: Array, radii: Array, capsule: int, boxes: Array, halves: Array, box: int, clearance: float) -> bool:
    """Whether a capsule and a box are farther apart than `clearance`, by the gaps along the box's axes."""
    centre = row(boxes, 4 * box)
    a, b = sub(row(ends, 2 * capsule), centre), sub(row(ends, 2 * capsule + 1), centre)
    square = 0.0
    for i in range(3):
        axis = row(boxes, 4 * box + 1 + i)
        one, two = dot(a, axis), dot(b, axis)
        gap = max(min(one, two), -max(one, two)) - halves[box, i]
        if gap > 0:
            square += gap * gap
    reach = radii[capsule] + clearance
    return bool(square > reach * reach)


@kernel
def _spines_apart(ends: Array, first: int, second: int, reach: float) -> bool:
    """Whether the axes of two capsules are farther apart than `reach`, by the gap along two directions."""
    a, b, c, d = row(ends, 2 * first), row(ends, 2 * first + 1), row(ends, 2 * second), row(ends, 2 * second + 1)
    middle = sub(add(a, b), add(c, d))
    normal = cross(sub(b, a), sub(d, c))
    for v in (middle, normal):
        size = math.sqrt(dot(v, v))
        if size > 1e-9:
            low, high = min(dot(a, v), dot(b, v)), max(dot(a, v), dot(b, v))
            under, over = min(dot(c, v), dot(d, v)), max(dot(c, v), dot(d, v))
            if max(low - over, under - high) > reach * size:
                return True
    return False
