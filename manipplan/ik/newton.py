"""Newton steps on the arm as described, by `newton.h`: they refine solutions of closed forms, and find others without.

descend: damped steps of joints inside their limits that reduce the error of a goal.

Newton and damped steps to the constrained components of a pose; `FreeMotion` gives the free ones.

The intervals in which random starts for a pose lie: prismatic joints near where the others can reach it.

Solutions by Newton steps from random starts, until few are likely to be missing; and the configuration inside the limits that
comes nearest to a pose.
"""

import ctypes
from collections.abc import Callable
from dataclasses import dataclass
from itertools import combinations, pairwise

import numpy as np
from numpy.typing import NDArray

from manipplan.ik.bridge import (
    as_bool,
    as_float64,
    as_int64,
    bridge,
    ik_functions,
    in_turn,
    reach_in,
    slides_of,
    span,
    within_reach,
)
from manipplan.ik.geometry import Screws
from manipplan.kinematics.kinematics import Kinematics
from manipplan.paths.deviation import distances_between
from manipplan.robots.limits import JointLimits
from manipplan.robots.robot import Robot
from manipplan.support.checks import COINCIDENT, Array
from manipplan.support.deadline import NEVER, Deadline
from manipplan.support.display import one_line
from manipplan.support.kernels import struct
from manipplan.symbolic.free_motion import FreeMotion, Turns
from manipplan.symbolic.task import Task


class MovingArm:
    """An arm whose joints `moves` (n,) may move, the others hold their positions; threads may share it."""

    def __init__(self, screws: Screws, moves: NDArray[np.bool_]) -> None:
        self._n, self._links = screws.n, 0 if screws.follow is None else len(screws.axes)
        self._arrays = {name: as_float64(getattr(screws, name)) for name in ("axes", "points", "home")}
        self._truths = {"slides": as_bool(screws.slides), "moves": as_bool(moves)}
        places = {name: array.ctypes.data for name, array in (self._arrays | self._truths).items()}
        self._screws = struct("inverse", "Screws")(n=screws.n, links=len(screws.axes), **places)
        if screws.follow is not None:
            leader, ratio, offset = screws.follow
            self._led = as_int64(leader), as_float64(ratio), as_float64(offset)
            self._screws.leader, self._screws.ratio, self._screws.offset = (each.ctypes.data for each in self._led)
        self._address = ctypes.addressof(self._screws)

    def refine(self, q: Array, targets: Array, owners: NDArray[np.int64], *, steps: int, tolerance: float) -> Array:
        """Rows (k, n) after minimum-norm Newton steps from each row of q (k, n) to the pose targets[owners[k]].

        A row ends once its pose is reached to `tolerance` [m, rad], after `steps` steps at the latest; a step that does not
        reduce the error is rejected.
        """
        q, targets, owners = np.array(q, dtype=np.float64, order="C"), as_float64(targets), as_int64(owners)
        work, held = self._scratch()
        ik_functions()["refine"](
            self._address,
            targets.ctypes.data,
            owners.ctypes.data,
            q.ctypes.data,
            len(q),
            steps,
            tolerance,
            work.ctypes.data,
            held.ctypes.data,
        )
        return q

    def search(
        self, q: Array, target: Array, lower: Array, upper: Array, *, steps: int, tolerance: float
    ) -> tuple[Array, Array]:
        """Rows (k, n) after damped Newton steps from each row of q (k, n), and their largest errors (k,) [m, rad].

        Levenberg-Marquardt steps [sugihara2011] towards one pose (4, 4), inside the limits (n,). Joints stop at their limits
        and leave them when the step leads back. A row ends once its pose is reached to `tolerance`, or after `steps` steps.
        """
        q, target = np.array(q, dtype=np.float64, order="C"), as_float64(target)
        lower, upper = as_float64(lower), as_float64(upper)
        miss, (work, held) = np.empty(len(q)), self._scratch()
        ik_functions()["search"](
            self._address,
            target.ctypes.data,
            lower.ctypes.data,
            upper.ctypes.data,
            q.ctypes.data,
            len(q),
            steps,
            tolerance,
            miss.ctypes.data,
            work.ctypes.data,
            held.ctypes.data,
        )
        return q, miss

    def _scratch(self) -> tuple[Array, NDArray[np.bool_]]:
        return np.empty(7 * self._n + 6 * self._links), np.empty(self._n, dtype=np.bool_)


#: Number of steps, first damping of a step, its factors after a good and a bad step, and the largest change of a joint in one
#: step [rad or m].
DESCENT_STEPS, DAMPING, BETTER, WORSE, LONGEST = 60, 1e-2, 1 / 3, 4.0, 0.5
#: Size of the error at which no more steps are made [m].
DONE = 1e-11
#: Steps towards a solution end where a number of them did not reduce the error to this share: the start leads nowhere.
PATIENCE, STALLED = 10, 0.99


def descend(
    limits: JointLimits,
    error_of: Callable[[NDArray[np.intp], Array], tuple[Array, Array]],
    q: Array,
    held: NDArray[np.bool_],
    *,
    stalled: float = 1.0,
) -> tuple[Array, Array]:
    """Configurations (k, n) inside the limits after damped steps from q (k, n), and their errors (k, r) [m].

    `error_of(rows, q)` returns the error (j, r), target minus current, of rows (j,) at q (j, n), and the task Jacobian
    (j, r, n). Held joints do not move. Where PATIENCE steps do not reduce the size of the error to a share `stalled`, no more
    are made.
    """
    q, lower, upper = q.copy(), limits.lower, limits.upper
    rows = np.arange(len(q))
    error, jacobian = error_of(rows, q)
    damping = np.full(len(q), DAMPING)
    before, moves = np.full(len(q), np.inf), np.ones(len(q), dtype=np.bool_)
    for k in range(DESCENT_STEPS):
        slope = jacobian[rows] * ~held
        step = _compute_damped_step(slope, error[rows], damping[rows])
        # a joint at a limit that the step would take further does not move
        stuck = ((q[rows] <= lower) & (step < 0)) | ((q[rows] >= upper) & (step > 0))
        some = stuck.any(axis=1)
        if some.any():
            held_back = slope[some] * ~stuck[some, None, :]
            step[some] = _compute_damped_step(held_back, error[rows[some]], damping[rows[some]])
        moved = np.clip(q[rows] + step, lower, upper)
        new_error, new_jacobian = error_of(rows, moved)
        good = (new_error**2).sum(axis=1) < (error[rows] ** 2).sum(axis=1)
        q[rows[good]], error[rows[good]], jacobian[rows[good]] = moved[good], new_error[good], new_jacobian[good]
        damping[rows] = np.clip(np.where(good, BETTER, WORSE) * damping[rows], 1e-12, 1e6)
        size = np.linalg.norm(error, axis=1)
        if k % PATIENCE == PATIENCE - 1:
            moves, before = size <= stalled * before, size
        rows = np.flatnonzero((size > DONE) & moves)
        if not len(rows):
            break
    return q, error


def _compute_damped_step(jacobian: Array, error: Array, damping: Array) -> Array:
    """Damped steps (k, n) of the joints that reduce the error (k, r)."""
    jacobian_t = np.swapaxes(jacobian, 1, 2)
    y = np.linalg.solve(jacobian @ jacobian_t + damping[:, None, None] * np.eye(error.shape[1]), error[:, :, None])
    return np.asarray(np.clip((jacobian_t @ y)[:, :, 0], -LONGEST, LONGEST))


#: Maximum number of steps, and largest change of a joint in one of them [rad or m].
MOST_ROW_STEPS, LONGEST_ROW_STEP = 50, 0.3
#: Smallest damping, as a part of the sum of the squared singular values, for configurations where the task itself is singular.
ROW_DAMPING = 1e-14


def onto_rows(
    kinematics: Kinematics, free: FreeMotion, q: Array, poses: Array, moves: NDArray[np.bool_], tolerance: float
) -> Array:
    """Configurations (k, n) after minimum-norm steps from q (k, n) to the constrained components of poses (k, 4, 4).

    A row ends where its error [m, rad] is below the tolerance, or stops decreasing.

    Args:
        kinematics: of the whole pose.
        free: the unconstrained motions of the tool.
        q: where the steps begin.
        poses: targets.
        moves: (n,) the joints that may move.
        tolerance: largest accepted error [m, rad].
    """
    q, best, least, rows = q.copy(), q.copy(), np.full(len(q), np.inf), np.arange(len(q))
    for _ in range(MOST_ROW_STEPS):
        error, jacobian = errors_to(kinematics, free, q[rows], poses[rows])
        size = np.abs(error).max(axis=1, initial=0.0)
        better = size < least[rows]
        best[rows[better]], least[rows[better]] = q[rows[better]], size[better]
        rows, jacobian, error = (each[better & (size > tolerance)] for each in (rows, jacobian, error))
        if not len(rows):
            break
        jacobian = jacobian * moves
        square = jacobian @ np.swapaxes(jacobian, 1, 2)
        square += ROW_DAMPING * np.trace(square, axis1=1, axis2=2)[:, None, None] * np.eye(square.shape[1])
        step = (np.swapaxes(jacobian, 1, 2) @ np.linalg.solve(square, error[:, :, None]))[:, :, 0]
        q[rows] += step * np.minimum(LONGEST_ROW_STEP / np.maximum(np.abs(step).max(axis=1), 1e-300), 1.0)[:, None]
    return best


def search_rows(
    kinematics: Kinematics, free: FreeMotion, q: Array, poses: Array, moves: NDArray[np.bool_]
) -> tuple[Array, Array]:
    """Configurations (k, n) inside the limits after damped steps from far-away ones, and their largest errors (k,) [m, rad]."""
    limits = kinematics.robot.limits
    q, error = descend(limits, lambda rows, q: errors_to(kinematics, free, q, poses[rows]), q, ~moves, stalled=STALLED)
    return q, np.abs(error).max(axis=1, initial=0.0)


def errors_to(kinematics: Kinematics, free: FreeMotion, q: Array, poses: Array) -> tuple[Array, Array]:
    """What is missing (k, r) to poses (k, 4, 4) at q (k, n) [m, rad], and the rows (k, r, n) by which joints reduce it."""
    from scipy.spatial.transform import Rotation

    reached = kinematics.pose(q)
    if free.turns is Turns.ANY and free.bounds is None and not len(free.shifts):
        return poses[:, :3, 3] - reached[:, :3, 3], kinematics.jacobian(q)[:, :3]
    scale = np.array([1.0] * 3 + [1.0 / kinematics.task.length] * 3)
    nearest = free.nearest(reached, poses)
    turns = Rotation.from_matrix(nearest[:, :3, :3] @ np.swapaxes(reached[:, :3, :3], 1, 2)).as_rotvec()
    counting = free.fixed_rows(nearest)
    error = counting @ np.hstack([nearest[:, :3, 3] - reached[:, :3, 3], turns])[:, :, None]
    return error[:, :, 0], counting @ (kinematics.jacobian(q) * scale[:, None])


#: Poses farther than FAR_AWAY times the arm's reach are approached through intermediate ones, each FARTHER times farther.
FAR_AWAY, FARTHER = 30.0, 10.0


def window(robot: Robot, poses: Array) -> tuple[Array, Array]:
    """Limits lower and upper (n,), in which slides are confined to where one of poses (k, 4, 4) may be reached."""
    (lower, upper), slides = span(robot), list(slides_of(robot))
    if slides:
        lower[slides], upper[slides] = bridge(robot, tuple(slides), True).window(poses)
    return lower, upper


def approach(robot: Robot, pose: Array) -> list[tuple[Array, float]]:
    """Intermediate poses (4, 4) from near the arm to `pose`, in the same direction, and the fraction of its distance of each.

    Only `pose` itself, with 1.0, unless prismatic joints carry the tool far beyond the other links.
    """
    (lower, upper), slides = within_reach(robot), list(slides_of(robot))
    shares = [1.0]
    if slides:
        base = np.asarray(robot.model.jointPlacements[1].translation)
        away, reach = pose[:3, 3] - base, reach_in(robot, (lower, upper))[1]
        while shares[0] * np.linalg.norm(away) > FAR_AWAY * reach:
            shares.insert(0, shares[0] / FARTHER)
    poses = [pose] * len(shares)
    if len(shares) > 1:
        poses = [pose.copy() for _ in shares]
        for each, share in zip(poses, shares, strict=True):
            each[:3, 3] = base + share * away
    return list(zip(poses, shares, strict=True))


@dataclass(frozen=True, kw_only=True, eq=False)
class Starts:
    """Where random starts for a pose lie: between limits (n,), with the joints `slides` in one of boxes (k, g)."""

    limits: tuple[Array, Array]
    slides: tuple[int, ...]
    boxes: tuple[Array, Array]

    @classmethod
    def near(cls, robot: Robot, pose: Array, *, whole_pose: bool) -> "Starts":
        """Those for a pose (4, 4), or for its position alone."""
        slides = slides_of(robot)
        none = np.zeros((1, 0))
        boxes = bridge(robot, slides, whole_pose).around(pose) if slides else (none, none)
        return cls(limits=span(robot), slides=slides, boxes=boxes)

    def random(self, rng: np.random.Generator, count: int) -> Array:
        """Random configurations (count, n)."""
        q = rng.uniform(*self.limits, (count, len(self.limits[0])))
        if self.slides:
            chosen = rng.integers(len(self.boxes[0]), size=count)
            q[:, list(self.slides)] = rng.uniform(self.boxes[0][chosen], self.boxes[1][chosen])
        return q


class StartsOfPoses:
    """The `Starts` of poses, kept for the pose asked for last, as samples of one pose follow each other."""

    def __init__(self, robot: Robot, *, whole_pose: bool) -> None:
        self._robot, self._whole = robot, whole_pose
        self._pose: Array = np.zeros(0)
        self._starts: Starts | None = None

    def of(self, pose: Array) -> Starts:
        """Those of a pose (4, 4)."""
        if self._starts is None or not np.array_equal(pose, self._pose):
            self._pose, self._starts = pose.copy(), Starts.near(self._robot, pose, whole_pose=self._whole)
        return self._starts

    def random(self, poses: Array, rng: np.random.Generator) -> Array:
        """A random configuration (k, n) for each of poses (k, 4, 4)."""
        changes = np.flatnonzero(np.abs(np.diff(poses, axis=0)).max(axis=(1, 2), initial=0.0)) + 1
        edges = [0, *changes.tolist(), len(poses)]
        if not slides_of(self._robot):
            edges = [0, len(poses)]
        return np.concatenate([self.of(poses[a]).random(rng, b - a) for a, b in pairwise(edges)])


def random_near(robot: Robot, pose: Array, rng: np.random.Generator, count: int, *, whole_pose: bool = True) -> Array:
    """Random configurations (count, n), with slides where a pose (4, 4), or its position alone, may be reached."""
    return Starts.near(robot, pose, whole_pose=whole_pose).random(rng, count)


#: Number of random starts per round, and their maximum number in total.
ROUND = 64
MOST = 4096
#: Number of starts without a solution after which the pose counts as unreachable.
FRUITLESS = 512
#: Rounds continue until each solution was found SEEN times on average and none less than OFTEN times.
SEEN, OFTEN = 16, 3
#: Number of steps of each start, and of further ones where these came so near [m, rad].
FIRST, PROMISING, STEPS = 20, 0.2, 60
#: Where nothing is found, starts that came this near [m, rad] get more steps: near a singularity, steps are short.
NEAR, MORE_STEPS = 1e-2, 500
#: Error at which a pose is reached [m, rad]. Beyond FAR [m] from the world's origin, where rounding is larger, it grows with
#: the distance.
TOLERANCE, FAR = 1e-12, 1e3
#: The same where nothing reaches a pose any nearer: a limit or the reach of the arm may end just before a rounded pose.
REACHED = COINCIDENT / 3
#: Solutions that differ by less than this are the same [rad or m].
ALIKE = 1e-5


@dataclass(frozen=True, kw_only=True, eq=False)
class ArmWithHeldJoints:
    """An arm with some joints held.

    Attributes:
        robot, screws: the arm.
        held: indices of the joints that are held at `values` [rad or m].
        values: (h,) positions of the held joints.
    """

    robot: Robot
    screws: Screws
    held: tuple[int, ...]
    values: Array


def random_answers(
    setup: ArmWithHeldJoints, target: Array, places: Starts, rng: np.random.Generator, deadline: Deadline = NEVER
) -> tuple[Array, float]:
    """Configurations (k, n) that reach `target` (4, 4), and an estimate of the share that was not found until the deadline.

    The steps begin at random configurations of `places`. The estimate is the Good-Turing one [good1953]: the share of the hits
    whose solution was found only once.
    """
    limits, screws, held = setup.robot.limits, setup.screws, list(setup.held)
    if ((setup.values < limits.lower[held]) | (setup.values > limits.upper[held])).any():
        return np.zeros((0, screws.n)), 0.0
    tolerance = TOLERANCE * max(1.0, float(np.abs(target[:3, 3]).max()) / FAR)
    moves = np.ones(screws.n, dtype=bool)
    moves[held] = False
    found, hits, starts = np.zeros((0, screws.n)), np.zeros(0), 0
    near = np.zeros((0, screws.n))

    arm = MovingArm(screws, moves)

    def advance(q: Array, steps: int) -> tuple[Array, Array]:
        return arm.search(q, target, limits.lower, limits.upper, steps=steps, tolerance=tolerance)

    while starts < MOST:
        within = tolerance
        if len(found) or starts < FRUITLESS:
            q = places.random(rng, ROUND)
            q[:, held] = setup.values
            q, miss = advance(q, FIRST)
            further = (miss > tolerance) & (miss < PROMISING)
            q[further], miss[further] = advance(q[further], STEPS)
            starts += ROUND
            near = np.vstack([near, q[(miss > tolerance) & (miss < NEAR)]])
        elif len(near):
            q, miss = advance(near[:ROUND], MORE_STEPS)
            near, within = near[:0], max(tolerance, REACHED)
        else:
            break
        for each in in_turn(setup.robot, q[miss <= within]):
            same = np.flatnonzero(np.abs(found - each).max(axis=1) < ALIKE)
            if len(same):
                hits[same[0]] += 1
            else:
                found, hits = np.vstack([found, each]), np.append(hits, 1)
        if (hits.sum() >= SEEN * max(len(found), 1) and not (hits < OFTEN).any()) or deadline.passed:
            break
    missing = float((hits == 1).sum() / hits.sum()) if len(found) else 1.0
    return found, missing


def merged(q: Array, source: NDArray[np.int64]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """The first of equal rows of q (k, n) with equal source (k,), ascending: their indices, and how often each was found."""
    firsts, hits = [np.zeros(0, dtype=np.int64)], [np.zeros(0, dtype=np.int64)]
    edges = np.flatnonzero(np.diff(source, prepend=-1, append=-1))
    for begin, end in pairwise(edges.tolist()):
        some = q[begin:end]
        same = np.abs(some[:, None] - some).max(axis=2) < ALIKE
        first = np.flatnonzero(same.argmax(axis=1) == np.arange(len(some)))
        firsts.append(begin + first)
        hits.append(same[first].sum(axis=1))
    return np.concatenate(firsts), np.concatenate(hits)


def best_held(robot: Robot, count: int, task: Task) -> tuple[int, ...]:
    """The joints to hold: those without which the others move the tool best, on average over random postures."""
    if count == 0:
        return ()
    q = np.random.default_rng(0).uniform(*within_reach(robot), (200, robot.n))
    jacobians = robot.kinematics(task).jacobian(q)
    rank = robot.n - count

    def mean_volume(held: tuple[int, ...]) -> float:
        left = np.delete(jacobians, held, axis=2)
        return float(np.linalg.svd(left, compute_uv=False)[:, :rank].prod(axis=1).mean())

    return max(combinations(range(robot.n), count), key=mean_volume)


#: Number of random starts, and of the best ends from which the steps go on.
STARTS, BEST = 384, 16
#: Number of restarts, each with the initial damping.
RESTARTS = 4
#: Distance from a limit up to which a joint counts as being at it [rad or m].
AT_LIMIT = 1e-6
#: Position error above which it is tested whether the pose was given in millimetres [m].
OTHER_UNIT = 1.0


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class Nearest:
    """The configuration found that comes nearest to a pose: the norm of distance [m] and angle [rad] is the smallest.

    Attributes:
        q: (n,) inside the limits [rad or m].
        position, rotation: distance [m] and angle [rad] beyond what is allowed.
        stopped: names of the joints that are at a limit there.
    """

    q: Array
    position: float
    rotation: float
    stopped: tuple[str, ...]

    @property
    def away(self) -> str:
        """How far it is away."""
        return f"{1e3 * self.position:.4g} mm and {np.rad2deg(self.rotation):.3g}° away"

    def __str__(self) -> str:
        return self.away + (f", with {' and '.join(self.stopped)} at the limit" if self.stopped else "")


def millimetres_hint(pose: Array, away: float, away_from: Callable[[Array], float]) -> str:
    """What explains that a pose (4, 4) is out of reach by `away` [m], if it is within reach in millimetres; or ""."""
    if away < OTHER_UNIT:
        return ""
    scaled = np.array(pose)
    scaled[:3, 3] /= 1000
    hint = "; its position is within reach if it is in millimetres: divide it by 1000"
    return hint if away_from(scaled) < OTHER_UNIT / 1000 else ""


def nearest_to(kinematics: Kinematics, free: FreeMotion, pose: Array) -> Nearest:
    """The configuration nearest to what counts of a pose (4, 4); `kinematics` is of the whole pose."""
    robot = kinematics.robot
    starts = random_near(robot, pose, np.random.default_rng(0), STARTS, whole_pose=not free.turns.value)

    def missing(rows: NDArray[np.intp], q: Array) -> tuple[Array, Array]:
        return errors_to(kinematics, free, q, np.broadcast_to(pose, (len(rows), 4, 4)))

    q, _ = descend_to_best(robot.limits, missing, starts, np.zeros(robot.n, dtype=np.bool_))
    position, rotation = distances_between(kinematics.pose(q[None]), pose[None], free)
    return Nearest(q=q, position=float(position[0]), rotation=float(rotation[0]), stopped=stopped_at(robot, q))


def descend_to_best(
    limits: JointLimits,
    missing: Callable[[NDArray[np.intp], Array], tuple[Array, Array]],
    starts: Array,
    held: NDArray[np.bool_],
) -> tuple[Array, Array]:
    """The configuration (n,) that misses least after damped steps from starts (k, n), and what it misses (r,); as `descend`."""
    q, miss = descend(limits, missing, starts, held)
    for _ in range(RESTARTS):
        best = np.argsort((miss**2).sum(axis=1), kind="stable")[:BEST]
        q, miss = descend(limits, missing, q[best], held)
    least = int((miss**2).sum(axis=1).argmin())
    return q[least], miss[least]


def stopped_at(robot: Robot, q: Array) -> tuple[str, ...]:
    """Names of the joints that are at a limit at q (n,)."""
    limited = np.minimum(q - robot.limits.lower, robot.limits.upper - q) <= AT_LIMIT
    return tuple(name for name, at in zip(robot.joint_names, limited, strict=True) if at)
