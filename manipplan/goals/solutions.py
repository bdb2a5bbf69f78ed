"""Configurations that reach poses: all solutions of inverse kinematics, for samples of what is free, refined where it pays.

How far a pose is out of reach: the nearest configurations to it inside the limits.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from manipplan.goals.goal import PoseGoal
from manipplan.ik.form import Enumeration
from manipplan.ik.newton import Nearest, descend, descend_to_best, random_near, stopped_at
from manipplan.ik.solutions import distinct
from manipplan.ik.solver import Solver
from manipplan.kinematics.kinematics import Kinematics
from manipplan.robots.arms import tool_reach
from manipplan.robots.limits import nearest_turns
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.deadline import NEVER, Deadline
from manipplan.symbolic.task import Task

#: Smallest and largest number of starts per pose, and of all; the same for poses that none of these reaches.
STARTS, ALL_STARTS = (8, 24), 600
MORE_STARTS, ALL_MORE = (24, 384), 1200
#: Weight of an angle against a distance [m/rad].
RADIAN = 1.0
#: Weights of the six rows of a Jacobian [m or m/rad].
LENGTHS = np.array([1.0] * 3 + [RADIAN] * 3)
#: Size of the miss that counts as none [m].
REACHED = 1e-9
#: Configurations are the same when no joint differs by more than this [rad or m].
DUPLICATE_DISTANCE = 1e-3


@dataclass(frozen=True, kw_only=True, eq=False)
class NearestToGoal(Nearest):
    """The configuration found that comes nearest to a goal: `position` and `rotation` are beyond its tolerance.

    Attributes:
        reaching: (k, n) different configurations found that reach the goal; (0, n) where none does.
    """

    reaching: Array

    @property
    def missed(self) -> str:
        """How far it is away, and what stops it."""
        joints = f"with {' and '.join(self.stopped)} at a limit" if self.stopped else "with no joint at a limit"
        return f"the nearest configuration found leaves the tool {self.away}, {joints}"

    def __str__(self) -> str:
        return f"out of reach: {self.missed}"


def nearest(
    robot: Robot,
    goals: Sequence[PoseGoal],
    near: Array,
    held: NDArray[np.bool_],
    *,
    thorough: bool = True,
    deadline: Deadline = NEVER,
) -> list[NearestToGoal]:
    """The nearest configuration found to each goal, by damped steps inside the limits from `near` (n,) and random starts.

    The held joints (n,) keep their values of `near`. If `thorough`, more starts follow for goals that are not reached.
    Raises OutOfTimeError after the deadline.
    """
    if not goals:
        return []
    kinematics = robot.kinematics(Task.pose(length=1.0), threads=1)
    count = int(np.clip(ALL_STARTS // len(goals), *STARTS))
    starts = [[near, robot.neutral, *random_near(robot, goal.matrix, np.random.default_rng(0), count - 2)] for goal in goals]
    q, owners = np.where(held, near, np.concatenate(starts)), np.repeat(np.arange(len(goals)), count)
    missing = PoseResidual.of(kinematics, goals)

    def slopes(rows: NDArray[np.intp], q: Array) -> tuple[Array, Array]:
        deadline.check()
        return missing.slopes(owners[rows], q)

    q, miss = descend(robot.limits, slopes, q, held)
    size = np.linalg.norm(miss, axis=1)
    close = [q[(owners == k) & (size <= REACHED)] for k in range(len(goals))]
    reached = [each[first_apart(each, DUPLICATE_DISTANCE)] for each in close]
    far = [k for k, each in enumerate(reached) if not len(each)]
    found = []
    for k, goal in enumerate(goals):
        best = q[owners == k][size[owners == k].argmin()]
        if k in far and thorough:
            deadline.check()
            more = random_near(robot, goal.matrix, np.random.default_rng(1), int(np.clip(ALL_MORE // len(far), *MORE_STARTS)))
            begins = np.where(held, near, np.vstack([q[owners == k], more]))
            best, left = descend_to_best(robot.limits, _to_goal(missing, k), begins, held)
            reached[k] = best[None][: int(np.linalg.norm(left) <= REACHED)]
        position, rotation = (float(each[0]) for each in goal.distances(kinematics.pose(best[None])))
        found.append(
            NearestToGoal(
                q=best,
                position=max(position - goal.allowed[0], 0.0),
                rotation=max(rotation - goal.allowed[1], 0.0),
                reaching=reached[k],
                stopped=stopped_at(robot, best),
            )
        )
    return found


def _to_goal(missing: "PoseResidual", goal: int) -> Callable[[NDArray[np.intp], Array], tuple[Array, Array]]:
    """What configurations miss of one goal, for `descend`."""
    return lambda rows, q: missing.slopes(np.full(len(rows), goal), q)


def beyond_links(robot: Robot, tool: str, goal: PoseGoal) -> str:
    """Why no configuration brings a tool to its goal: its place is beyond the length of all links; "" where it is not."""
    place, length = tool_reach(robot, tool)
    length += goal.allowed[0]
    away = float(np.linalg.norm(goal.matrix[:3, 3] - place))
    if away <= length:
        return ""
    first = robot.joint_names[robot.joints_of(tool)[0]]
    return f"out of reach: {away:.3g} m from {first}, and the links up to the tool are {length:.3g} m long"


@dataclass(frozen=True, kw_only=True, eq=False)
class PoseResidual:
    """What is missing to g goals: `targets` (g, 4, 4), free axes (g, 3) or zero, and tolerances `allowed` (g, 2) [m, rad]."""

    kinematics: Kinematics
    targets: Array
    axes: Array
    allowed: Array

    @classmethod
    def of(cls, kinematics: Kinematics, goals: Sequence[PoseGoal]) -> "PoseResidual":
        return cls(
            kinematics=kinematics,
            targets=np.array([each.matrix for each in goals]),
            axes=np.array([np.zeros(3) if each.axis is None else each.axis for each in goals]),
            allowed=np.array([each.allowed for each in goals]),
        )

    def __call__(self, owners: NDArray[np.intp], q: Array) -> tuple[Array, Array]:
        """What q (k, n) miss of their goals (k,), and the part of a motion of the tool that counts.

        Distances, and angles times RADIAN, in the world's axes (k, 6); and projections (k, 6, 6) of such motions: no rotation
        about a free axis, and nothing inside a tolerance.
        """
        from scipy.spatial.transform import Rotation

        poses, targets, axes = self.kinematics.pose(q), self.targets[owners], self.axes[owners]
        turns = Rotation.from_matrix(targets[:, :3, :3] @ np.swapaxes(poses[:, :3, :3], 1, 2)).as_rotvec()
        have, want = (np.einsum("kij,kj->ki", each[:, :3, :3], axes) for each in (poses, targets))
        across = np.cross(have, want)
        sine = np.linalg.norm(across, axis=1)
        leans = across / np.maximum(sine, 1e-12)[:, None] * np.arctan2(sine, (have * want).sum(axis=1))[:, None]
        free = (np.abs(axes).max(axis=1) > 0)[:, None]
        counting = np.zeros((len(q), 6, 6))
        position, counting[:, :3, :3] = _beyond(targets[:, :3, 3] - poses[:, :3, 3], self.allowed[owners, 0])
        rotation, counting[:, 3:, 3:] = _beyond(np.where(free, leans, turns), self.allowed[owners, 1])
        counting[:, 3:, 3:] -= counting[:, 3:, 3:] @ (have[:, :, None] * have[:, None])  # have is zero where no axis is free
        return np.hstack([position, RADIAN * rotation]), counting

    def slopes(self, owners: NDArray[np.intp], q: Array) -> tuple[Array, Array]:
        """What q (k, n) miss of their goals (k,), (k, 6), and its change with the joints (k, 6, n)."""
        miss, counting = self(owners, q)
        return miss, counting @ (self.kinematics.jacobian(q) * LENGTHS[:, None])


def first_apart(q: Array, spacing: float, most: int | None = None) -> list[int]:
    """Indices of the first rows of q (k, n), at most `most`, of which none is within `spacing` of one before in all joints."""
    chosen: list[int] = []
    for k, each in enumerate(q):
        if len(chosen) != most and all(np.abs(each - q[j]).max() > spacing for j in chosen):
            chosen.append(k)
    return chosen


def _beyond(vectors: Array, most: Array) -> tuple[Array, Array]:
    """Vectors (k, 3) shortened by lengths (k,), and projections (k, 3, 3) on the motions that change their length."""
    length = np.linalg.norm(vectors, axis=1)
    unit = vectors / np.maximum(length, 1e-300)[:, None]
    along = unit[:, :, None] * unit[:, None] * (length > most)[:, None, None]
    shortened = vectors * np.maximum(1 - most / np.maximum(length, 1e-300), 0.0)[:, None]
    return np.asarray(shortened), np.where((most > 0)[:, None, None], along, np.eye(3))


#: Number of samples of redundancy parameters and free angles for all goals together, with a closed form and without; the
#: smallest number of one of one, two, and more parameters of each pose, and the largest number.
SAMPLES, SEARCHED = 512, 16
FEWEST, MOST = (16, 6, 4), 64
#: The same smallest number without a closed form.
FEWEST_SEARCHED = 3
#: Number of poses inside the tolerance of one goal, and of all goals together.
INSIDE, ALL_INSIDE = 12, 120
#: Share of the tolerance inside which they lie.
SHARE = 0.9
#: Number of times that the parameters of the best solutions are sampled more finely, and number of values on either side.
ROUNDS, BESIDE = 10, 4
#: Solutions whose figure is below this share of the best one are not refined further.
PROMISING = 0.8
#: Largest difference of a joint between a solution and a finer sample of it, in steps of the parameters, and at least [rad, m].
FOLLOWS, LEAST_FOLLOWS = 6.0, 1e-3


@dataclass(frozen=True, kw_only=True, eq=False)
class Reaching:
    """Configurations that reach goals.

    Attributes:
        q: (k, n) inside the limits.
        goals: (k,) index of the goal that each reaches.
        solvers: (k,) index of the entry of `families` that each comes from.
        poses: (k, 4, 4) the pose that each reaches, inside the tolerance of its goal.
        values: one array (r,) per row: the parameters.
        families: the solvers, with the steps (r,) between their samples.
    """

    q: Array
    goals: NDArray[np.int64]
    solvers: NDArray[np.int64]
    poses: Array
    values: tuple[Array, ...]
    families: tuple[tuple[Solver, Array], ...]

    def rows(self, indices: NDArray[np.int64]) -> "Reaching":
        """These rows only, in this order."""
        arrays = {name: getattr(self, name)[indices] for name in ("q", "goals", "solvers", "poses")}
        return replace(self, **arrays, values=tuple(self.values[k] for k in indices))


def reaching(robot: Robot, goals: dict[int, PoseGoal], near: Array) -> Reaching:
    """All solutions for each goal, by its index; of those that differ by full turns the nearest to `near` (n,)."""
    inside = min(INSIDE, ALL_INSIDE // max(sum(goal.tolerance is not None for goal in goals.values()), 1))
    groups: dict[tuple[float, ...] | None, list[int]] = {}
    for k, goal in goals.items():
        groups.setdefault(None if goal.axis is None else tuple(goal.axis), []).append(k)
    found: list[tuple[Array, NDArray[np.int64], NDArray[np.int64], Array, Array]] = []
    families: list[tuple[Solver, Array]] = []
    total = sum(1 if goal.tolerance is None else 1 + inside for goal in goals.values())
    for members in groups.values():
        task = goals[members[0]].task(robot)
        solver = Solver.of(robot, task=task, held=None, method="auto", seed=0)
        targets = [poses_inside(goals[k], inside) for k in members]
        poses, owners = np.concatenate(targets), np.repeat(members, [len(each) for each in targets])
        names = len(solver.names)
        most, fewest = SEARCHED, FEWEST_SEARCHED
        if solver.form is not None:
            most, fewest = SAMPLES, FEWEST[min(max(names, 1), len(FEWEST)) - 1]
        count = int(np.clip((most / total) ** (1 / max(names, 1)), fewest, MOST))
        values = solver.grid(count, (count,), poses)
        widths = np.ptp(values, axis=0) / max(count - 1, 1) if names else np.zeros(0)
        samples, sources = np.tile(values, (len(poses), 1)), np.repeat(np.arange(len(poses)), len(values))
        solved = solver.solve_once(poses, sources, samples)
        q = nearest_turns(robot, solved.q, near)
        unique = distinct(q, sources[solved.source])
        pose = sources[solved.source[unique]]
        family = np.full(len(unique), len(families))
        found.append((q[unique], owners[pose], family, poses[pose], samples[solved.source[unique]]))
        families.append((solver, widths))
    whole = np.zeros(0, dtype=np.int64)
    return Reaching(
        q=np.concatenate([np.zeros((0, robot.n)), *(each[0] for each in found)]),
        goals=np.concatenate([whole, *(each[1] for each in found)]),
        solvers=np.concatenate([whole, *(each[2] for each in found)]),
        poses=np.concatenate([np.zeros((0, 4, 4)), *(each[3] for each in found)]),
        values=tuple(row for each in found for row in each[4]),
        families=tuple(families),
    )


def beyond_limits(robot: Robot, goals: dict[int, PoseGoal]) -> list[tuple[int, Array]]:
    """Solutions (n,) outside the limits, with the index of their goal, of arms that have few: those without a parameter."""
    found: list[tuple[int, Array]] = []
    free = np.full(robot.n, np.inf)
    for k, goal in goals.items():
        solver = Solver.of(robot, task=goal.task(robot), held=None, method="auto", seed=0)
        if solver.form is None or solver.names:
            continue
        every = Enumeration(solver.form, -free, free, None)
        blocks = list(every(goal.matrix[None], np.zeros(1, dtype=np.int64), np.zeros((1, 0))))
        q = np.concatenate([each[0] for each in blocks])
        q = nearest_turns(robot, q, robot.limits.middle, within_limits=False)
        found += [(k, each) for each in q if (robot.limits.outside(each) > 0).any()]
    return found


def refined(
    robot: Robot, best: Reaching, near: Array, figure: Callable[[Array], Array], enough: float
) -> tuple[Array, NDArray[np.int64]]:
    """Configurations (k, n) like those of `best`, with other parameters where that raises a figure, and their rows in `best`.

    Args:
        best: the solutions to begin with; those without a parameter or a closed form are left out.
        near: (n,) of those that differ by full turns the nearest to it is taken.
        figure: of configurations (k, n), (k,); -inf where one is not free.
        enough: a figure that need not be raised.
    """
    q, rows = best.q.copy(), []
    top = figure(q)
    for family, (solver, widths) in enumerate(best.families):
        if solver.form is None or not len(widths):
            continue
        active, step = np.flatnonzero(best.solvers == family), widths
        values = dict(zip(active.tolist(), (best.values[k] for k in active), strict=True))
        shares = np.arange(-BESIDE, BESIDE + 1) / (BESIDE + 1)
        for _ in range(ROUNDS):
            active = active[(top[active] < enough) & (top[active] >= PROMISING * top.max())]
            if not len(active):
                break
            offsets = np.concatenate([np.outer(shares[shares != 0], each) for each in np.diag(step)])
            samples = np.concatenate([values[k] + offsets for k in active.tolist()])
            owners = np.repeat(active, len(offsets))
            solved = solver.solve_once(best.poses, owners, samples)
            others, of = nearest_turns(robot, solved.q, near), owners[solved.source]
            follows = np.abs(others - q[of]).max(axis=1) <= max(FOLLOWS * float(step.max()), LEAST_FOLLOWS)
            others, of, source = others[follows], of[follows], solved.source[follows]
            figures = figure(others) if len(others) else np.zeros(0)
            for k in active.tolist():
                mine = np.flatnonzero(of == k)
                first = mine[figures[mine].argmax()] if len(mine) else -1
                if first >= 0 and figures[first] > top[k]:
                    q[k], top[k], values[k] = others[first], figures[first], samples[source[first]]
                    rows.append(k)
            step = step / BESIDE
    better = np.unique(np.array(rows, dtype=np.int64))
    return q[better], better


def poses_inside(goal: PoseGoal, count: int) -> Array:
    """The pose of a goal and `count` poses inside its tolerance, evenly spread and the same each time, (1 + count, 4, 4)."""
    from scipy.spatial.transform import Rotation

    if goal.tolerance is None:
        return goal.matrix[None]
    position, rotation = goal.allowed
    u = _spread(count, 6)
    poses = np.tile(goal.matrix, (count + 1, 1, 1))
    poses[1:, :3, 3] += SHARE * position * _ball(u[:, :3])
    turns = Rotation.from_rotvec(SHARE * rotation * _ball(u[:, 3:]))
    poses[1:, :3, :3] = goal.matrix[:3, :3] @ turns.as_matrix()
    return poses


def _spread(count: int, dimensions: int) -> Array:
    """Points (count, dimensions) of [0, 1), evenly spread: multiples of powers of a generalised golden ratio."""
    ratio = 2.0
    for _ in range(50):
        ratio = (1 + ratio) ** (1 / (dimensions + 1))
    steps = ratio ** -np.arange(1.0, dimensions + 1)
    return np.asarray((0.5 + np.arange(1, count + 1)[:, None] * steps) % 1.0)


def _ball(u: Array) -> Array:
    """Points of the unit ball (k, 3), uniform for uniform u (k, 3)."""
    z, angle = 2 * u[:, 1] - 1, 2 * np.pi * u[:, 2]
    across = np.sqrt(1 - z**2)
    return np.asarray(np.cbrt(u[:, :1]) * np.stack([across * np.cos(angle), across * np.sin(angle), z], axis=1))
