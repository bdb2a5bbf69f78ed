"""Solver: finds and verifies all inverse kinematics solutions of one arm."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import product

import numpy as np
from numpy.typing import ArrayLike, NDArray

from manipplan.ik.enumeration import AT_LIMIT, MOST, Enumeration
from manipplan.ik.form import SWIVEL, ClosedForm, closed_form, held_indices
from manipplan.ik.geometry import Screws
from manipplan.ik.native import swivels_of
from manipplan.ik.newton import MovingArm
from manipplan.ik.onto_rows import onto_rows, search_rows
from manipplan.ik.solutions import Completeness
from manipplan.ik.statistical import Sampled, best_held, in_range, merged, random_answers
from manipplan.ik.verify import residuals
from manipplan.ik.window import reach_in, window
from manipplan.kinematics.kinematics import Kinematics
from manipplan.robots.arms import has_few_joints, one_tool
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, finite_array, instance, random_seed, whole_number
from manipplan.support.errors import InvalidInputError, UnknownNameError
from manipplan.support.memo import once_per_owner
from manipplan.symbolic.free_motion import NOTHING, FreeMotion
from manipplan.symbolic.task import Task

#: A configuration reaches a pose when no entry of the two matrices differs by more than this [m or 1].
REACHED = 1e-10
#: Maximum residual that rounding leaves in an exact closed form near a singularity, to be refined; more is no solution.
ROUNDED = 1e-6
#: Maximum number of refinement steps; near a singularity they are short.
STEPS = 200
#: Default number of samples per parameter, for one to six parameters.
SAMPLES = (64, 24, 12, 8, 6, 5)
#: Number of joints that a pose takes, and one in a plane.
POSE, PLANAR_POSE = 6, 3
#: Number of random starts per sample, and at least of all, of an arm with few joints.
STARTS, ALL_STARTS = 8, 64
METHODS = ("auto", "closed-form", "newton")


@dataclass(frozen=True, kw_only=True, eq=False)
class Found:
    """Rows q (k, n), the sample (k,) of each, the residual (k,), and the estimated share of missing solutions."""

    q: Array
    source: NDArray[np.int64]
    residual: Array
    missing: float = 0.0


@dataclass(frozen=True, kw_only=True, eq=False)
class Solver:
    """Finds all inverse kinematics solutions of one arm.

    Attributes:
        robot: the arm.
        task: the part of a pose that must be reached.
        kinematics: forward kinematics that verify solutions.
        form: the closed form; None for Newton steps from random starts.
        screws: the arm.
        held: indices of the joints that are held.
        free: motions of the tool that the task leaves free.
        seed: seed of the random starts.
    """

    robot: Robot
    task: Task
    kinematics: Kinematics
    form: ClosedForm | None
    screws: Screws = field(repr=False)
    held: tuple[int, ...]
    free: FreeMotion
    seed: int

    @classmethod
    def of(cls, robot: Robot, *, task: Task | None, held: Sequence[str] | None, method: str, seed: int) -> "Solver":
        """The solver for an arm; arguments and errors as in `inverse_kinematics`."""
        one_tool(instance("robot", robot, Robot), "inverse kinematics")
        usual = robot.default_task if robot.planar else Task.pose()
        task = instance("task", task if task is not None else usual, Task)
        if method not in METHODS:
            raise UnknownNameError("method", str(method), METHODS)
        if task.relative_to is not None:
            raise InvalidInputError("task", task, "a task in the world: solutions are enumerated for poses there")
        free = FreeMotion.of(task, planar=robot.planar)
        _check_limits(robot)
        few = _solves_rows(robot, free)
        if few and robot.n < task.rows:
            raise InvalidInputError("task", task.name, f"at most {robot.n} rows, as many as {robot.name} has joints")
        form = closed_form(robot, held) if method != "newton" and not few else None
        if form is None and method == "closed-form":
            told = "only rows are solved for, as it has too few joints for a free motion" if few else "has no closed form"
            raise InvalidInputError("method", method, f"'newton': {robot.name} {told}")
        screws = form.screws if form is not None else Screws.of(robot)
        if form is not None:
            indices = form.held
        else:
            count = robot.n - task.rows if few else spare(robot)
            best_for = task if few else Task.pose()
            indices = held_indices(robot, held, count) if held is not None else best_held(robot, count, best_for)
        return cls(
            robot=robot,
            task=task,
            kinematics=robot.kinematics(Task.pose(), threads=1),
            form=form,
            screws=screws,
            held=indices,
            free=free,
            seed=random_seed("seed", seed),
        )

    @property
    def by_rows(self) -> bool:
        """Whether the arm has too few joints to reach a pose at each value of a free motion: then only rows are solved for."""
        return _solves_rows(self.robot, self.free)

    @property
    def method(self) -> str:
        """Name of the method."""
        return "newton" if self.form is None else self.form.name

    @property
    def complete(self) -> Completeness | None:
        """The completeness of every result, where the method alone determines it."""
        if self.form is None:
            return Completeness.STATISTICAL
        return None if self.form.exact else Completeness.TO_RESOLUTION

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Names of the parameters."""
        held = tuple(self.robot.joint_names[k] for k in self.held)
        swivel = ("swivel",) if self.form is not None and self.form.solver == SWIVEL else ()
        return held + swivel + (() if self.by_rows else self.free.names)

    @cached_property
    def _enumeration(self) -> Enumeration:
        assert self.form is not None
        axis = self.free.only_axis
        return _enumeration(self.robot, self.form, None if axis is None else tuple(axis.tolist()))

    @cached_property
    def _holding(self) -> MovingArm:
        """All joints move but those that are held."""
        moves = np.ones(self.robot.n, dtype=np.bool_)
        moves[list(self.held)] = False
        return MovingArm(self.screws, moves)

    def values(
        self, parameters: ArrayLike | None, samples: int | Sequence[int] | None, poses: Array
    ) -> tuple[Array, Completeness]:
        """Parameters (s, r): the given ones, or a grid for poses (p, 4, 4)."""
        r = len(self.names)
        if parameters is not None:
            if samples is not None:
                raise InvalidInputError("samples", samples, "nothing where parameters are given")
            values = finite_array(
                "parameters", np.atleast_1d(np.asarray(parameters)), (r,) if np.ndim(parameters) < 2 else (None, r)
            )
            return np.atleast_2d(values), Completeness.EXACT
        return self.grid(samples, SAMPLES, poses), Completeness.TO_RESOLUTION if r else Completeness.EXACT

    def grid(self, samples: int | Sequence[int] | None, usual: Sequence[int], poses: Array) -> Array:
        """A grid of parameters (s, r) for poses (p, 4, 4).

        `usual` has the default number of values per parameter, by number of parameters.
        """
        counts, limits = sample_counts(samples, self.names, usual), window(self.robot, poses)
        return np.array(list(product(*(self._line(k, count, limits, poses) for k, count in enumerate(counts)))))

    def _line(self, parameter: int, count: int, limits: tuple[Array, Array], poses: Array) -> Array:
        """Values of one parameter: a joint's range with its ends, a full turn, or those of a free motion."""
        free = parameter - len(self.names) + len(self.free.names)
        if free >= 0 and not self.by_rows:
            return self.free.line(free, count, *reach_in(self.robot, limits), poses)
        if parameter < len(self.held):
            lower, upper = (float(limit[self.held[parameter]]) for limit in limits)
            if np.isfinite(lower):
                return np.linspace(lower, upper, count) if count > 1 else np.array([(lower + upper) / 2])
        return -np.pi + 2 * np.pi * np.arange(count) / count

    def whole_poses(self, usual: Sequence[int], poses: Array) -> list[Array]:
        """For each of poses (p, 4, 4) a grid of parameters (s, r) that keep the whole pose; empty without a free motion."""
        free = 0 if self.by_rows else len(self.free.names)
        if not free:
            return [np.zeros((0, len(self.names)))] * len(poses)
        own = len(self.names) - free
        rows = self.grid([usual[own - 1]] * own + [1] * free, usual, poses)
        return [np.hstack([rows[:, :own], np.tile(each, (len(rows), 1))]) for each in self.free.values(poses, poses)]

    def parameters_of(self, q: Array, poses: Array) -> Array:
        """The parameters (k, r) of configurations (k, n) that reach poses (k, 4, 4)."""
        columns = [q[:, list(self.held)]]
        if self.form is not None and self.form.solver == SWIVEL:
            free, screws = list(self.form.free), self.screws
            wrist, shoulder = self.form.meeting
            columns.append(swivels_of(screws.axes[free], screws.points[free], shoulder, wrist, q[:, free])[:, None])
        if self.free.names and not self.by_rows:
            columns.append(self.free.values(self.kinematics.pose(q), poses))
        return np.hstack(columns)

    def onto(self, q: Array, poses: Array, *, inside: float = 0.0) -> Array:
        """Configurations (k, n) moved onto poses (k, 4, 4) by minimum-norm Newton steps; inside the limits.

        Joints of a redundant arm that would come nearer to a limit than `inside` [rad or m] stop there, and the others move on.
        """
        limits = self.robot.limits
        moved = self._moved(q, poses, np.ones(self.robot.n, dtype=np.bool_))
        inner = np.clip(moved, limits.lower + inside, limits.upper - inside)
        beyond = inner != moved
        for stopped in np.unique(beyond[beyond.any(axis=1)], axis=0):
            if self.robot.n - stopped.sum() >= (PLANAR_POSE if self.robot.planar else POSE) - len(self.free.names):
                rows = np.flatnonzero((beyond == stopped).all(axis=1))
                moved[rows] = self._moved(inner[rows], poses[rows], ~stopped)
        return np.clip(moved, limits.lower, limits.upper)

    def _moved(self, q: Array, poses: Array, moves: NDArray[np.bool_]) -> Array:
        """Configurations (k, n) after minimum-norm Newton steps of the joints `moves` (n,) onto poses (k, 4, 4)."""
        if self.free.names and (self.by_rows or not self.robot.planar):
            return onto_rows(self.kinematics, self.free, q, poses, moves, REACHED / 100)
        targets = self.free.nearest(self.kinematics.pose(q), poses)
        return MovingArm(self.screws, moves).refine(q, targets, np.arange(len(q)), steps=STEPS, tolerance=REACHED / 100)

    def solve(self, poses: Array, owners: NDArray[np.int64], samples: Array) -> Found:
        """All solutions for samples (s, r), with duplicates; `owners` (s,) is the pose index of each sample."""
        found = self.solve_once(poses, owners, samples)
        rows, q = self.with_turns(found.q)
        return Found(q=q, source=found.source[rows], residual=found.residual[rows], missing=found.missing)

    def with_turns(self, q: Array) -> tuple[NDArray[np.int64], Array]:
        """Solutions of `solve_once` (k, n) at each full turn inside the limits, (l, n), and the row (l,) that each is of."""
        rows = np.arange(len(q))
        for joint in self._turning:
            upper = self.robot.limits.upper[joint]
            counts = ((upper - q[:, joint] + REACHED / 10) // (2 * np.pi)).astype(np.int64) + 1
            again = np.repeat(np.arange(len(q)), counts)
            turns = np.arange(len(again)) - np.repeat(np.cumsum(counts) - counts, counts)
            q, rows = q[again], rows[again]
            q[:, joint] = np.minimum(q[:, joint] + 2 * np.pi * turns, upper)
        return rows, q

    @property
    def most(self) -> int:
        """Maximum number of solutions of one sample; a guess for arms without closed form."""
        ranges = self.robot.limits.upper - self.robot.limits.lower
        return MOST * math.prod(int((ranges[k] + AT_LIMIT) // (2 * np.pi)) + 1 for k in self._turning)

    @cached_property
    def _turning(self) -> list[int]:
        """The joints that can make more than a full turn, but are not endless; none of an arm without closed form."""
        ranges = self.robot.limits.upper - self.robot.limits.lower
        return [] if self.form is None else [k for k in self.form.free if 2 * np.pi - 2 * AT_LIMIT <= ranges[k] < np.inf]

    def solve_once(self, poses: Array, owners: NDArray[np.int64], samples: Array) -> Found:
        """As `solve`, but of configurations that differ by full turns only that with the smallest values inside the limits."""
        if self.by_rows:
            return self._by_rows(poses[owners], self.free, samples)
        if self.robot.planar:
            targets, rows = self._targets(poses, owners, samples, np.arange(len(samples)))
            return self._by_rows(targets[rows], NOTHING, samples)
        if self.form is None:
            return self._by_search(poses, owners, samples)
        asked = poses, owners, samples
        if self.free.names and self.free.only_axis is None:
            every = np.arange(len(samples))
            asked = self._targets(poses, owners, samples, every)[0], every, samples[:, : -len(self.free.names)]
        blocks = [
            self._judged(q, source, *self._targets(poses, owners, samples, source)) for q, source in self._enumeration(*asked)
        ]
        return _joined(blocks, self.robot.n)

    def _targets(
        self, poses: Array, owners: NDArray[np.int64], samples: Array, source: NDArray[np.int64]
    ) -> tuple[Array, NDArray[np.int64]]:
        """Poses (p, 4, 4), and the index (k,) of the one that each row must reach."""
        if not self.free.names:
            return poses, owners[source]
        values = samples[source, -len(self.free.names) :]
        return self.free.poses(poses[owners[source]], values), np.arange(len(source))

    def _judged(self, q: Array, source: NDArray[np.int64], targets: Array, rows: NDArray[np.int64]) -> Found:
        """The rows of q that reach their pose, targets[rows], after refinement where rounding requires it."""
        residual = self._residual(q, targets, rows)
        off = residual > REACHED
        if self.form is not None and self.form.exact:
            off &= residual < ROUNDED
        if off.any():
            better = self._holding.refine(q[off], targets, rows[off], steps=STEPS, tolerance=REACHED / 100)
            q = q.copy()
            q[off] = np.clip(better, self.robot.limits.lower, self.robot.limits.upper)
            residual[off] = self._residual(q[off], targets, rows[off])
        good = residual <= REACHED
        return Found(q=q[good], source=source[good], residual=residual[good])

    def _residual(self, q: Array, targets: Array, rows: NDArray[np.int64]) -> Array:
        if not len(q):
            return np.zeros(0)
        return residuals(self.kinematics.pose(q), targets, rows)

    def _by_rows(self, poses: Array, free: FreeMotion, samples: Array) -> Found:
        """Solutions of what counts of poses (s, 4, 4), the pose of each sample (s, r), from random starts."""
        rng, limits = np.random.default_rng(self.seed), self.robot.limits
        source = np.repeat(np.arange(len(samples)), max(STARTS, ALL_STARTS // max(len(samples), 1)))
        q = self.robot.random_configuration(rng, size=len(source))
        q[:, list(self.held)] = samples[source, : len(self.held)]
        moves = np.ones(self.robot.n, dtype=np.bool_)
        moves[list(self.held)] = False
        q, residual = search_rows(self.kinematics, free, q, poses[source], moves)
        found = (residual <= REACHED) & (limits.outside(q) <= 0).all(axis=1)
        q, source = in_range(q[found], limits), source[found]
        kept, hits = merged(q, source)
        missing = float((hits == 1).sum() / hits.sum()) if len(hits) else 1.0
        return Found(q=q[kept], source=source[kept], residual=residual[found][kept], missing=missing)

    def _by_search(self, poses: Array, owners: NDArray[np.int64], samples: Array) -> Found:
        blocks, missing = [], []
        rng = np.random.default_rng(self.seed)
        targets, rows = self._targets(poses, owners, samples, np.arange(len(samples)))
        for k, target in enumerate(targets[rows]):
            setup = Sampled(screws=self.screws, held=self.held, values=samples[k, : len(self.held)], limits=self.robot.limits)
            q, share = random_answers(setup, target, rng)
            blocks.append(self._judged(q, np.full(len(q), k), targets, np.full(len(q), rows[k])))
            missing.append(share)
        found = _joined(blocks, self.robot.n)
        return Found(
            q=found.q, source=found.source, residual=found.residual, missing=float(np.mean(missing)) if missing else 0.0
        )


def sample_counts(samples: int | Sequence[int] | None, names: tuple[str, ...], usual: Sequence[int]) -> tuple[int, ...]:
    """Number of grid values of each parameter."""
    r = len(names)
    if samples is None:
        return (usual[min(r, len(usual)) - 1],) * r
    if not isinstance(samples, list | tuple):
        return (whole_number("samples", samples, least=1),) * r
    if len(samples) != r:
        wanted = f"one whole number, or one for each of {', '.join(names) or 'no parameters'}"
        raise InvalidInputError("samples", samples, wanted)
    return tuple(whole_number(f"samples[{k}] ({names[k]})", each, least=1) for k, each in enumerate(samples))


def _solves_rows(robot: Robot, free: FreeMotion) -> bool:
    """Whether an arm has too few joints to reach a pose at each value of a free motion."""
    return bool(free.names) and has_few_joints(robot)


@once_per_owner
def _enumeration(robot: Robot, form: ClosedForm, axis: tuple[float, ...] | None) -> Enumeration:
    """The enumeration of solutions in the first full turn of each joint that is free."""
    lower, upper = robot.limits.lower, robot.limits.upper.copy()
    free = list(form.free)
    upper[free] = np.minimum(upper[free], lower[free] + 2 * np.pi)
    return Enumeration(form, lower, upper, None if axis is None else np.array(axis))


def spare(robot: Robot) -> int:
    """Degree of redundancy: number of joints beyond those that the arm's poses need."""
    q = robot.random_configuration(np.random.default_rng(0), size=5)
    ranks = np.linalg.matrix_rank(robot.kinematics(Task.pose()).jacobian(q), tol=1e-8)
    return robot.n - int(ranks.max())


def _check_limits(robot: Robot) -> None:
    """Raises InvalidInputError where a joint has a limit on one side only, or a prismatic joint has none."""
    limits = robot.limits
    half = (np.isinf(limits.lower) | np.isinf(limits.upper)) & ~robot.endless
    if half.any():
        k = int(half.argmax())
        wanted = "limits on both sides; revolute joints, unless a follower slides or makes no whole turns, may have none at all"
        raise InvalidInputError(f"limits of {robot.joint_names[k]}", (float(limits.lower[k]), float(limits.upper[k])), wanted)


def _joined(blocks: list[Found], n: int) -> Found:
    if not blocks:
        return Found(q=np.zeros((0, n)), source=np.zeros(0, dtype=np.int64), residual=np.zeros(0))
    return Found(
        q=np.concatenate([block.q for block in blocks]),
        source=np.concatenate([block.source for block in blocks]),
        residual=np.concatenate([block.residual for block in blocks]),
    )
