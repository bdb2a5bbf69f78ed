"""A proof that no collision-free path joins two configurations, from two necessary conditions for one.

- How two bodies are to each other depends on the joints between them alone. A path of the arm is also a path of some of its
  joints among configurations at which the bodies that depend on no other joint are free. Tried are the first 1 to 4 joints, and
  any one or two joints between two bodies, such as those of the upper arm and the head.
- A ball inside a body moves along a curve in the world on which it keeps clear of all obstacles that are checked against the
  body, and its centre stays within reach of the base.

Where cells prove that there is no such curve, there is no path. Only distances of the compiled kernel count: those of
separate bodies and the depths of convex ones have proven bounds, and change by no more than the bodies' points move. Meshes and
clouds that a body overlaps count as free.

A proof that two points of a box cannot be joined: the box is divided into cells, and cells without a free point are blocked.

A distance that changes by at most D within a cell is too small in all of it if it is so at the centre by D or more; the cell is
then blocked. Where D does not decide, the cell is halved along every axis [brooks1985; zhang2008]. A continuous curve of free
points visits a chain of cells that are not blocked, each of which touches the next one, at least at a corner. So if those cells
do not join two points, no curve does. Where they do, nothing is proven.

The balls inside the bodies of an arm.
"""

import itertools
from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.kernel import DistanceKernel, kernel_of
from manipplan.collision.model import CollisionModel
from manipplan.collision.path_clearance import BodyMotion, body_motion
from manipplan.robots.arms import farthest
from manipplan.robots.limits import JointLimits
from manipplan.robots.robot import Robot
from manipplan.seeds.task import SeedTask
from manipplan.support.checks import Array
from manipplan.support.deadline import NEVER, Deadline

#: Margin on every distance [m].
SLACK = 1e-5
#: Initial and maximum number of halvings of a box, by its number of dimensions.
FIRST, LAST = {1: 6, 2: 3, 3: 2, 4: 2}, {1: 13, 2: 9, 3: 7, 4: 5}
#: In place of the index of a pair: no pair blocks the cell; it is out of reach.
OPEN, OUTSIDE = -1, -2

Indices = NDArray[np.int64]


@dataclass(frozen=True, kw_only=True, eq=False)
class Space(ABC):
    """A box of points, and distances that are to be kept in it.

    Attributes:
        low, high: (k,) corners of the box, 1 <= k <= 4.
        goes_on: (k,) whether points beyond both ends of an axis exist: the cells at one end then count as joined out there.
        ends: two free points (k,).
        pairs: (p,) indices of the distances.
        least: what every distance must be at free points [m].
        most: maximum number of distances that are measured; then nothing is proven.
    """

    low: Array
    high: Array
    goes_on: NDArray[np.bool_]
    ends: tuple[Array, Array]
    pairs: Indices
    least: float
    most: int

    @abstractmethod
    def measure(self, centres: Array, half: Array, rows: Indices, pairs: Indices) -> tuple[Array, Array]:
        """Distances of `pairs` (e,) at centres[rows], (m, k) and (e,), nan where they are not known, and bounds D (e,) [m].

        No distance changes by more than D within `half` (k,) of the centre along each axis. Distances above `least` + D + SLACK
        may be cut off there.
        """

    def is_outside(self, centres: Array, _half: Array) -> NDArray[np.bool_]:
        """Which cells around centres (m, k) no curve can visit; (m,)."""
        return np.zeros(len(centres), dtype=bool)

    def cell_of(self, point: Array, count: int) -> tuple[int, ...]:
        """The cell of a point (k,), of `count` along every axis."""
        share = (point - self.low) / (self.high - self.low)
        return tuple(np.clip(np.floor(count * share).astype(int), 0, count - 1).tolist())


@dataclass(frozen=True, kw_only=True)
class Barrier:
    """What separates two points.

    Attributes:
        pairs: the distances that are too small in the cells around the smaller of both parts.
        end: the point in that part: 0 or 1.
    """

    pairs: tuple[int, ...]
    end: int


def find_barrier(space: Space, deadline: Deadline = NEVER) -> Barrier | None:
    """What separates both ends of a space; None where nothing is proven, as after the deadline."""
    return _Division(space).run(deadline) if len(space.pairs) and (space.high > space.low).all() else None


class _Division:
    """The cells of one level after another.

    `blocker` and `is_free` are arrays with one axis per dimension: the pair that blocks each cell, and whether all its points
    are free.
    """

    def __init__(self, space: Space) -> None:
        self.space = space
        self.k = len(space.low)
        self.level = FIRST[self.k]
        shape = (2**self.level,) * self.k
        self.blocker, self.is_free = np.full(shape, OPEN, dtype=np.int64), np.zeros(shape, dtype=bool)
        self.cells: Indices = np.indices(shape).reshape(self.k, -1).T.astype(np.int64)
        count = len(space.pairs)
        self.rows, self.pairs = np.repeat(np.arange(len(self.cells)), count), np.tile(space.pairs, len(self.cells))
        self.left = space.most

    def run(self, deadline: Deadline) -> Barrier | None:
        while len(self.rows) and len(self.rows) <= self.left and not deadline.passed:
            self.left -= len(self.rows)
            self._measure()
            places = [self.space.cell_of(end, 2**self.level) for end in self.space.ends]
            if any(self.blocker[place] != OPEN for place in places):
                return None  # an end nearly touches
            part = _part(self.blocker == OPEN, self.space.goes_on, places[0])
            if not part[places[1]]:
                return self._barrier(part, places)
            if self._is_joined(places) or self.level == LAST[self.k]:
                return None
            self._halve(part)
        return None

    def _measure(self) -> None:
        """Close the cells of this level that a distance decides, and keep the open ones with the distances that do not."""
        space = self.space
        half = (space.high - space.low) / 2 ** (self.level + 1)
        centres = space.low + (2 * self.cells + 1) * half
        distances, change = space.measure(centres, half, self.rows, self.pairs)
        blocks = distances + change <= space.least - SLACK  # nan is not
        self.blocker[tuple(self.cells[self.rows[blocks]].T)] = self.pairs[blocks]
        outside = space.is_outside(centres, half)
        self.blocker[tuple(self.cells[outside].T)] = OUTSIDE
        near = ~(distances - change >= space.least + SLACK)
        is_near = np.zeros(len(self.cells), dtype=bool)
        is_near[self.rows[near]] = True
        at = tuple(self.cells.T)
        self.is_free[at] = ~is_near & (self.blocker[at] == OPEN)
        chosen = near & (self.blocker[at] == OPEN)[self.rows]
        self.rows, self.pairs = self.rows[chosen], self.pairs[chosen]

    def _is_joined(self, places: list[tuple[int, ...]]) -> bool:
        """Whether free cells join both ends, so that no level can separate them."""
        if not all(self.is_free[place] for place in places):
            return False
        from scipy.ndimage import label

        labels = label(self.is_free)[0]
        return bool(labels[places[0]] == labels[places[1]])

    def _halve(self, part: NDArray[np.bool_]) -> None:
        """Go on to the next level, with the cells of one part that are neither blocked nor free."""
        inside = part[tuple(self.cells[self.rows].T)]
        self.rows, self.pairs = self.rows[inside], self.pairs[inside]
        known, position = np.unique(self.rows, return_inverse=True)
        corners = np.indices((2,) * self.k).reshape(self.k, -1).T
        self.cells = (2 * self.cells[known][None] + corners[:, None]).reshape(-1, self.k)
        self.rows = (position[None] + len(known) * np.arange(len(corners))[:, None]).ravel()
        self.pairs = np.tile(self.pairs, len(corners))
        for axis in range(self.k):
            self.blocker, self.is_free = self.blocker.repeat(2, axis=axis), self.is_free.repeat(2, axis=axis)
        self.level += 1

    def _barrier(self, part: NDArray[np.bool_], places: list[tuple[int, ...]]) -> Barrier:
        from scipy.ndimage import binary_dilation

        other = _part(self.blocker == OPEN, self.space.goes_on, places[1])
        end = int(other.sum() <= part.sum())
        around = self.blocker[binary_dilation(other if end else part, np.ones((3,) * self.k))]
        found = around[around >= 0] if (around >= 0).any() else self.blocker[self.blocker >= 0]
        return Barrier(pairs=tuple(np.unique(found).tolist()), end=end)


def _part(is_open: NDArray[np.bool_], goes_on: NDArray[np.bool_], place: tuple[int, ...]) -> NDArray[np.bool_]:
    """The open cells that are joined to the one at `place`, where cells that share a corner are joined.

    A curve that leaves the box at one end of an axis comes back at that end, if at all.
    """
    from scipy.ndimage import label

    labels, count = label(is_open, structure=np.ones((3,) * is_open.ndim))
    joined = np.zeros(count + 1, dtype=bool)
    joined[labels[place]] = True
    faces = [np.unique(labels.take(end, axis=axis)) for axis in np.flatnonzero(goes_on) for end in (0, -1)]
    before = 0
    while before != joined.sum():
        before = joined.sum()
        for face in faces:
            joined[face] |= joined[face].any()
            joined[0] = False
    return np.asarray(joined[labels])


#: Subtracted from every radius [m].
BALL_ROUNDING = 1e-6
#: Number of steps towards the centre of a hull.
STEPS = 60


@dataclass(frozen=True, kw_only=True, eq=False)
class Ball:
    """A ball inside a body: centre (3,) in the frame of the body's joint, and radius [m]."""

    centre: Array
    radius: float


def find_inscribed_ball(item: pin.GeometryObject, around: float = 0.0) -> Ball | None:
    """A large ball inside a convex body; None where none is known.

    Args:
        item: a coal Sphere, Capsule, Cylinder, Box or convex hull, posed in its joint's frame.
        around: distance around the shape that belongs to the body as well [m].
    """
    shape, place = item.geometry, item.placement
    middle, radius = np.zeros(3), 0.0
    if isinstance(shape, coal.Sphere | coal.Capsule):
        radius = float(shape.radius)
    elif isinstance(shape, coal.Cylinder):
        radius = float(min(shape.radius, shape.halfLength))
    elif isinstance(shape, coal.Box):
        radius = float(np.min(shape.halfSide))
    elif isinstance(shape, coal.ConvexBase):
        middle, radius = _in_hull(np.array(shape.points()))
    radius += around - BALL_ROUNDING
    if radius <= 0:
        return None
    return Ball(centre=np.asarray(place.rotation @ middle + place.translation), radius=radius)


def _in_hull(points: Array) -> tuple[Array, float]:
    """Centre and radius of a ball inside the hull of points (k, 3): step by step the centre leaves the nearest face."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        hull = ConvexHull(points, qhull_options="Qt")
    except QhullError:
        return np.zeros(3), 0.0
    faces, centre = hull.equations, points[hull.vertices].mean(axis=0)
    best, most = centre, -np.inf
    for step in range(STEPS):
        inside = -(faces[:, :3] @ centre + faces[:, 3])
        nearest = int(inside.argmin())
        if inside[nearest] > most:
            best, most = centre, float(inside[nearest])
        centre = centre - abs(most) / (2 + step) * faces[nearest, :3]
    return best, most


#: Added to the reach of a ball [m].
ROUNDING = 1e-3
#: Radius of the point that stands for a ball's centre [m]; it only adds to the ball.
POINT = 1e-9
#: Maximum number of triangles and points of the obstacles for which balls are tried: a tree of them has to be built.
MOST_TRIANGLES = 20_000
#: Maximum number of distances that are measured for the first joints, and for a ball: 1 to 4 µs each.
MOST_FOR_JOINTS, MOST_FOR_BALL = 50_000, 100_000
#: Number of joints up to which those between any two bodies are tried.
FEW = 2
ENDS = "start", "goal"


def why_unreachable(task: SeedTask) -> str | None:
    """Why no path joins start and goal, with the names of the bodies; None where that is not proven.

    It takes up to about 0.3 s, and ends where the deadline of the task and its grace are over.
    """
    deadline = Deadline(at=task.late)
    kernel = task.model.kernel_copy()
    if not task.model.pair_names:
        return None
    between = body_motion(task.model).joints_between()
    first = [frozenset(range(k)) for k in range(1, min(task.model.robot.n, max(LAST)) + 1)]
    few = {joints for joints in between if 0 < len(joints) <= FEW} | set(first[:FEW])
    quick, slow = (
        (_SomeJoints.of(task, kernel, joints, between) for joints in each)
        for each in (sorted(few, key=lambda joints: (len(joints), sorted(joints))), first[FEW:])
    )
    for each in itertools.chain[_SomeJoints | _Centres](quick, _balls(task), slow):
        if deadline.passed:
            return None
        barrier = find_barrier(each, deadline)
        if barrier is not None:
            return each.reason(task, barrier)
    return None


@dataclass(frozen=True, kw_only=True, eq=False)
class _SomeJoints(Space):
    """The configurations of k joints, and the pairs of bodies that depend on no other joint.

    Attributes:
        joints: (k,) their indices.
        start: (n,) values of the other joints, which do not matter.
        slides: (k, 3) axes in the world, if all of these joints are prismatic.
    """

    joints: Indices
    kernel: DistanceKernel
    motion: BodyMotion
    start: Array
    slides: Array | None

    @classmethod
    def of(
        cls, task: SeedTask, kernel: DistanceKernel, joints: frozenset[int], between: Sequence[frozenset[int]]
    ) -> "_SomeJoints":
        """Those of a task, within the bounds of its searches; beyond them, where the limits allow it, nothing is blocked.

        `between` has the joints between the bodies of each pair.
        """
        robot, (low, high), chosen = task.model.robot, task.bounds(), np.array(sorted(joints), dtype=np.int64)
        limits, tree = robot.limits, robot.tree
        slide = not tree.has_followers and tree.slides[chosen].all()
        return cls(
            low=low[chosen],
            high=high[chosen],
            goes_on=~((low <= limits.lower) & (high >= limits.upper))[chosen],
            pairs=np.array([pair for pair, each in enumerate(between) if each <= joints], dtype=np.int64),
            least=task.clearance,
            most=MOST_FOR_JOINTS,
            joints=chosen,
            kernel=kernel,
            motion=body_motion(task.model),
            start=task.start,
            slides=_axes(task, chosen) if slide else None,
            ends=(task.start[chosen], task.goal[chosen]),
        )

    def measure(self, centres: Array, half: Array, rows: Indices, pairs: Indices) -> tuple[Array, Array]:
        q, change = np.tile(self.start, (len(centres), 1)), np.zeros((len(centres), len(self.start)))
        q[:, self.joints], change[:, self.joints] = centres, half
        motion = self.motion.motion(q, change, rows, pairs)
        if self.slides is not None:  # the diagonal of a box is shorter than its edges together
            signs = np.array(list(itertools.product((-1.0, 1.0), repeat=len(half))))
            motion = np.minimum(motion, np.linalg.norm((signs * half) @ self.slides, axis=1).max())
        return self.kernel.pair_distances(q[rows], pairs, np.maximum(self.least + motion + 1e-4, 0.0)), motion

    def reason(self, task: SeedTask, barrier: Barrier) -> str:
        names = [task.model.robot.joint_names[joint] for joint in self.joints]
        several = f"{', '.join(names[:-1])} and {names[-1]} within their limits"
        joints = several if len(names) > 1 else f"{names[0]} within its limits"
        q = np.tile((task.start, task.goal)[barrier.end], (len(barrier.pairs), 1))
        nearest = int(np.argmin(task.model.pair_distances(q, barrier.pairs)))
        first, second = task.model.pair_names[barrier.pairs[nearest]]
        contact = f"closer than the clearance of {1e3 * task.clearance:.3g} mm" if task.clearance else "into contact"
        turns = task.model.robot.turns[self.joints] & (self.high - self.low >= 2 * np.pi)
        turned = "; goals a full turn away are other goals (Seeding.shifts)" if turns.any() else ""
        one = f"{first} and {second} {contact}"
        several = f"two bodies {contact}; at the {ENDS[barrier.end]} {first} and {second} are the nearest of them"
        return (
            f"it is proven that the goal cannot be reached: every motion of {joints} from start to goal brings "
            f"{one if len(barrier.pairs) == 1 else several}{turned}"
        )


@dataclass(frozen=True, kw_only=True, eq=False)
class _Centres(Space):
    """The places in the world of the centre of a ball inside a body, and the obstacles of this body.

    Attributes:
        radius: that of the ball [m].
        link: the link or carried part that contains it.
        obstacles: the name of each obstacle, by the index of its pair.
        kernel: of a point among the obstacles.
        base: (3,) the place of the first joint.
        reach: largest distance of the centre from there [m].
    """

    radius: float
    link: str
    obstacles: Sequence[str]
    kernel: DistanceKernel
    base: Array
    reach: float

    def measure(self, centres: Array, half: Array, rows: Indices, pairs: Indices) -> tuple[Array, Array]:
        change = np.full(len(rows), np.linalg.norm(half))
        return self.kernel.pair_distances(centres[rows], pairs, self.least + change + 1e-4), change

    def is_outside(self, centres: Array, half: Array) -> NDArray[np.bool_]:
        nearest = np.maximum(np.abs(centres - self.base) - half, 0.0)
        return np.asarray(np.linalg.norm(nearest, axis=1) > self.reach)

    def reason(self, task: SeedTask, barrier: Barrier) -> str:
        pairs = np.array(barrier.pairs)
        at = np.tile(self.ends[barrier.end], (len(pairs), 1))
        distances = self.kernel.pair_distances(at, pairs, np.full(len(pairs), np.inf))
        nearest = self.obstacles[barrier.pairs[int(np.nanargmin(distances))]]
        clearance = f" and the clearance of {1e3 * task.clearance:.3g} mm" if task.clearance else ""
        return (
            f"it is proven that the goal cannot be reached: {self.link} is enclosed at the {ENDS[barrier.end]}, and {nearest} "
            f"is the nearest obstacle around it; no gap lets out a ball of radius {1e3 * self.radius:.3g} mm, which the body "
            f"contains{clearance}"
        )


def _axes(task: SeedTask, joints: Indices) -> Array:
    """Axes (k, 3) of some sliding joints in the world at the start."""
    data = task.model.robot.model.createData()
    return np.asarray(pin.computeJointJacobians(task.model.robot.model, data, task.start)[:3, joints].T)


def _balls(task: SeedTask) -> Iterator[_Centres]:
    """The largest ball on each joint, those nearest to the tool first."""
    model, objects = task.model, task.model.objects
    still = [k for k, item in enumerate(objects) if item.parentJoint == 0]
    size = sum(item.geometry.num_tris for k, item in enumerate(objects) if k in still and _is_surface(item))
    if not still or size > MOST_TRIANGLES:
        return
    known = {pair for first, second in model.pairs.tolist() for pair in ((first, second), (second, first))}
    kernel = _point_kernel(model, still)
    names = [objects[k].name for k in still]
    for joint in range(model.robot.model.njoints - 1, 0, -1):
        largest: tuple[int, Ball] | None = None
        for body in range(model.bodies):
            if objects[body].parentJoint == joint and any((body, k) in known for k in still):
                ball = find_inscribed_ball(objects[body], model.radii.get(body, 0.0))
                if ball is not None and (largest is None or ball.radius > largest[1].radius):
                    largest = body, ball
        if largest is None:
            continue
        body, ball = largest
        base, reach = _reach(model.robot, joint, ball.centre)
        if not np.isfinite(reach):
            continue
        yield _Centres(
            low=base - reach,
            high=base + reach,
            goes_on=np.zeros(3, dtype=bool),
            ends=(_place(model.robot, task.start, joint, ball), _place(model.robot, task.goal, joint, ball)),
            pairs=np.array([number for number, k in enumerate(still) if (body, k) in known], dtype=np.int64),
            least=ball.radius + task.clearance,
            most=MOST_FOR_BALL,
            radius=ball.radius,
            link=model.robot.link_of(_find_described(model.robot, objects[body])),
            obstacles=names,
            kernel=kernel,
            base=base,
            reach=reach,
        )


def _is_surface(item: pin.GeometryObject) -> bool:
    return isinstance(item.geometry, coal.BVHModelBase)


def _find_described(robot: Robot, body: pin.GeometryObject) -> pin.GeometryObject:
    """The object of the robot's description that a body of the collision model is, or is a piece of."""
    whole = [item for item in robot.geometry.geometryObjects if item.name in (body.name, body.name.rpartition(".")[0])]
    return whole[0] if whole else body


def _place(robot: Robot, q: Array, joint: int, ball: Ball) -> Array:
    """The centre (3,) of a ball in the world at q (n,)."""
    data = robot.model.createData()
    pin.forwardKinematics(robot.model, data, q)
    return np.asarray(data.oMi[joint].act(ball.centre))


def _reach(robot: Robot, joint: int, centre: Array) -> tuple[Array, float]:
    """The place (3,) of the first joint that carries a joint, and the largest distance from there of a point it carries [m]."""
    model, tree = robot.model, robot.tree
    travel = farthest(robot, tree)
    _, first, *others = model.supports[joint]
    links = sum(float(np.linalg.norm(model.jointPlacements[j].translation)) for j in others)
    slid = sum(float(travel[j - 1]) for j in (first, *others) if tree.slides[j - 1])
    return np.array(model.jointPlacements[first].translation), float(np.linalg.norm(centre)) + links + slid + ROUNDING


def _point_kernel(model: CollisionModel, still: Sequence[int]) -> DistanceKernel:
    """Distances of a point, placed by three sliding joints, to the bodies `still`, one pair each."""
    sliding, joint = pin.Model(), 0
    for name, kind in (("x", pin.JointModelPX), ("y", pin.JointModelPY), ("z", pin.JointModelPZ)):
        joint = sliding.addJoint(joint, kind(), pin.SE3.Identity(), name)
    ball = pin.GeometryObject("point", joint, 0, pin.SE3.Identity(), coal.Sphere(POINT))
    objects = [ball, *(model.objects[k] for k in still)]
    radii = np.array([0.0, *(model.radii.get(k, 0.0) for k in still)])
    pairs = np.array([(0, number) for number in range(1, len(objects))])
    endless = np.full(3, np.inf)
    limits = JointLimits(
        lower=-endless, upper=endless, velocity=endless, acceleration=endless, jerk=endless, effort=endless, sources={}
    )
    point = Robot(name="point", model=sliding, geometry=pin.GeometryModel(), tool="", limits=limits, neutral=np.zeros(3))
    return kernel_of(point, objects, pairs, radii, [number for number, k in enumerate(still, start=1) if k in model.solids])
