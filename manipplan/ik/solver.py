"""Solver: finds and verifies all inverse kinematics solutions of one arm."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import product

import numpy as np
from numpy.typing import NDArray

from manipplan.ik.bridge import HeldValues, bridge, in_turn, line, reach_in, slides_of, span, spans_turn, swivels_of
from manipplan.ik.form import AT_LIMIT, MOST, SWIVEL, ClosedForm, Enumeration, closed_form, held_indices
from manipplan.ik.geometry import Screws
from manipplan.ik.newton import (
    ArmWithHeldJoints,
    MovingArm,
    StartsOfPoses,
    approach,
    best_held,
    merged,
    onto_rows,
    random_answers,
    random_near,
    search_rows,
    window,
)
from manipplan.ik.solutions import Completeness, residuals
from manipplan.kinematics.kinematics import Kinematics
from manipplan.robots.arms import has_few_joints, one_tool
from manipplan.robots.own_ik import OwnInverseKinematics
from manipplan.robots.robot import Robot
from manipplan.support.checks import (
    COINCIDENT,
    Array,
    ArrayLike,
    finite_array,
    instance,
    number_array,
    one_of,
    random_seed,
    whole_number,
)
from manipplan.support.deadline import NEVER, Deadline
from manipplan.support.errors import InvalidInputError
from manipplan.support.memo import once_per_source
from manipplan.symbolic.free_motion import NOTHING, BoundedMotion, FreeMotion
from manipplan.symbolic.task import Task

#: A configuration reaches a pose when no entry of the two matrices differs by more than this [m or 1]; beyond FAR [m] from the
#: world's origin, where rounding is larger, by more than this share of FAR.
REACHED, FAR = 1e-10, 1e4
#: Relaxed tolerance for poses that rounding puts just beyond a joint limit or the workspace; errors stay below COINCIDENT.
NEARLY = COINCIDENT / 3
#: Maximum residual of a configuration of the user's own inverse kinematics [m or 1]; it is refined.
MISSED = 1e-3
#: Distance beyond a limit within which such a configuration is refined from the limit [rad or m].
NEAR_LIMIT = 1e-2
#: Maximum residual that rounding leaves in an exact closed form near a singularity, to be refined; more is no solution.
ROUNDED = 1e-6
#: Maximum number of refinement steps; near a singularity they are short.
STEPS = 200
#: Default number of samples per parameter, for one to six parameters.
SAMPLES = (64, 24, 12, 8, 6, 5)
#: Maximum number of samples of all parameters together.
MOST_SAMPLES = 50_000_000
#: Maximum number of samples when a default grid that found nothing is refined.
FINEST = 20_000
#: Number of random starts where no grid finds anything.
AT_RANDOM = 128
#: Number of joints that a pose takes, and one in a plane.
POSE, PLANAR_POSE = 6, 3
#: Number of random starts per sample, and minimum of all of a pose, for an arm with few joints.
STARTS, ALL_STARTS = 8, 64
#: Number of samples of an arm with few joints that are solved together, if each has STARTS starts.
TOGETHER = 128
METHODS = ("auto", "closed-form", "newton")


@dataclass(frozen=True, kw_only=True, eq=False)
class Found:
    """Rows q (k, n), the sample (k,) of each, the residual (k,), the estimated share of missing solutions, and the share of the
    samples that was solved until a deadline.
    """

    q: Array
    source: NDArray[np.int64]
    residual: Array
    missing: float = 0.0
    solved: float = 1.0


@dataclass(frozen=True, kw_only=True, eq=False)
class ParameterGrid:
    """Parameters (s, r), how complete their solutions are, and the share that is missing for certain or by estimate."""

    values: Array
    complete: Completeness
    missing: float = 0.0


@dataclass(frozen=True, kw_only=True, eq=False)
class Solver:
    """Finds all inverse kinematics solutions of one arm.

    Attributes:
        robot: the arm.
        task: the part of a pose that must be reached.
        kinematics: forward kinematics that verify solutions.
        own: inverse kinematics of the user; None: the library's.
        form: the closed form; None for Newton steps from random starts, or those of the user.
        screws: the arm.
        held: indices of the joints that are held.
        free: motions of the tool that the task leaves free.
        seed: seed of the random starts.
    """

    robot: Robot
    task: Task
    kinematics: Kinematics
    own: OwnInverseKinematics | None
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
        one_of("method", method, METHODS)
        if task.relative_to is not None:
            raise InvalidInputError("task", task, "a task in the world: solutions are enumerated for poses there")
        free = FreeMotion.of(task, planar=robot.planar)
        _check_limits(robot)
        few = _solves_rows(robot, free)
        if few and task.region is not None:
            wanted = f"a task without a region: {robot.name} has {robot.n} joints, so that only rows are solved for"
            raise InvalidInputError("task", task.name, wanted)
        if few and robot.n < task.rows:
            raise InvalidInputError("task", task.name, f"at most {robot.n} rows, as many as {robot.name} has joints")
        own = robot.own_ik if method == "auto" and not few else None
        if own is not None and held is not None:
            wanted = f"None with the inverse kinematics {own.name}; method='newton' is the library's"
            raise InvalidInputError("held", held, wanted)
        form = closed_form(robot, held) if method != "newton" and not few and own is None else None
        if form is None and method == "closed-form":
            reason = "only rows are solved for, as it has too few joints for a free motion" if few else "has no closed form"
            raise InvalidInputError("method", method, f"'newton': {robot.name} {reason}")
        screws = form.screws if form is not None else Screws.of(robot)
        if own is not None:
            indices: tuple[int, ...] = ()
        elif form is not None:
            indices = form.held
        else:
            count = robot.n - task.rows if few else spare(robot)
            best_for = task if few else Task.pose()
            indices = held_indices(robot, held, count) if held is not None else best_held(robot, count, best_for)
        return cls(
            robot=robot,
            task=task,
            kinematics=robot.kinematics(Task.pose(), threads=1),
            own=own,
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
    def solves_together(self) -> bool:
        """Whether many samples are solved at once by a closed form, each as if it were alone."""
        return self.form is not None and self.own is None and not self.by_rows and not self.robot.planar

    @property
    def method(self) -> str:
        """Name of the method."""
        if self.own is not None:
            return self.own.name
        return "newton" if self.form is None else self.form.name

    @property
    def complete(self) -> Completeness | None:
        """The completeness of every result, where the method alone determines it."""
        if self.own is not None and self.own.complete:
            return None
        if self.form is None:
            return Completeness.STATISTICAL
        return None if self.form.exact else Completeness.TO_RESOLUTION

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Names of the parameters."""
        held = tuple(self.robot.joint_names[k] for k in self.held)
        swivel = ("swivel",) if self.form is not None and self.form.solver == SWIVEL else ()
        return held + swivel + (() if self.by_rows else self.free.names)

    @property
    def samples_redundancy(self) -> bool:
        """Whether parameters are sampled, so that random starts of all joints may reach a pose that no sample does."""
        return bool(self.names) and self.own is None

    @property
    def sampled_names(self) -> tuple[str, ...]:
        """Names of what has a number of samples: the parameters, or those of the arm and the poses of a region."""
        bounded = self.free.bounds
        return self.names if bounded is None else (*self.names[: -len(bounded)], "poses of the region")

    @property
    def is_line(self) -> bool:
        """Whether the arm itself has one parameter, so that solutions of a pose are lines over it; or one motion is free."""
        return len(self.names) == 1 or (self.free.bounds is not None and len(self.sampled_names) == 2)

    @property
    def has_several_parameters(self) -> bool:
        """Whether a configuration is likely to be between samples, since solutions of a pose are more than lines."""
        return len(self.names) > 1 and not self.is_line

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

    def values(self, parameters: ArrayLike | None, samples: int | Sequence[int] | None, poses: Array) -> ParameterGrid:
        """Parameters (s, r): the given ones, or a grid for poses (p, 4, 4)."""
        r = len(self.names)
        if parameters is None:
            return self._grid(samples, SAMPLES, poses)
        if samples is not None:
            raise InvalidInputError("samples", samples, "nothing where parameters are given")
        given = np.atleast_1d(number_array("parameters", parameters))
        values = finite_array("parameters", given, (r,) if given.ndim < 2 else (None, r))
        return ParameterGrid(values=np.atleast_2d(values), complete=Completeness.EXACT)

    def grid(self, samples: int | Sequence[int] | None, usual: Sequence[int], poses: Array) -> Array:
        """A grid of parameters (s, r) for poses (p, 4, 4).

        `usual` has the default number of values per parameter, by number of parameters.
        """
        return self._grid(samples, usual, poses).values

    def finer_counts(self) -> list[int]:
        """Numbers of samples per parameter to be tried where the default finds nothing; none without a closed form."""
        r = len(self.sampled_names)
        if self.form is None or not r:
            return []
        usual = SAMPLES[min(r, len(SAMPLES)) - 1]
        return [count for k in range(1, 9) if (count := usual * 2**k) ** r <= FINEST]

    def random_solutions(self, pose: Array) -> Array:
        """Configurations (k, n) to which random starts lead, and that reach a pose (4, 4).

        They serve where so few parameters have a solution that a grid misses them all, as at the edge of the reach, or far
        along a slide, where a direction has to be met that leaves the slide little room. Such a pose is approached: the slides
        of solutions for a nearer one are made longer.
        """
        q = np.zeros((0, self.robot.n))
        if not self.samples_redundancy:
            return q
        limits, whole_pose = self.robot.limits, not self.free.turns.value
        slides, ratio = list(slides_of(self.robot)), 1.0
        for target, share in approach(self.robot, pose):
            if not len(q):
                q = random_near(self.robot, target, np.random.default_rng(self.seed), AT_RANDOM, whole_pose=whole_pose)
            q[:, slides] = np.clip(q[:, slides] * (share / ratio), limits.lower[slides], limits.upper[slides])
            allowed, ratio = float(_allow_residual(target[None])[0]), share
            q, miss = self.search_from(q, target, allowed / 100)
            q = q[miss <= allowed]
            if not len(q):
                break
        return in_turn(self.robot, q)

    def search_from(self, q: Array, pose: Array, tolerance: float) -> tuple[Array, Array]:
        """Configurations (k, n) after damped steps of all joints towards a pose (4, 4), and their errors (k,) [m, rad]."""
        moves, limits = np.ones(self.robot.n, dtype=np.bool_), self.robot.limits
        if self.free.names:
            return search_rows(self.kinematics, self.free, q, np.tile(pose, (len(q), 1, 1)), moves)
        return MovingArm(self.screws, moves).search(q, pose, limits.lower, limits.upper, steps=STEPS, tolerance=tolerance)

    def move_to(self, q: Array, pose: Array, tolerance: float) -> tuple[Array, Array]:
        """The same, faster for a single q: without motions that are free, but where that does not reach the pose."""
        arm, limits = MovingArm(self.screws, np.ones(self.robot.n, dtype=np.bool_)), self.robot.limits
        targets = self.free.nearest(self.kinematics.pose(q), np.tile(pose, (len(q), 1, 1)))
        bounds = limits.lower, limits.upper
        found = [
            arm.search(each[None], target, *bounds, steps=STEPS, tolerance=tolerance)
            for each, target in zip(q, targets, strict=True)
        ]
        moved, miss = (np.concatenate(each) for each in zip(*found, strict=True))
        far = miss > tolerance
        if far.any() and self.free.names:
            moved[far], miss[far] = self.search_from(q[far], pose, tolerance)
        return moved, miss

    @property
    def sweeps_slides(self) -> bool:
        """Whether the grid holds slides, so that it depends on the poses."""
        return not set(self.held).isdisjoint(slides_of(self.robot))

    def _grid(self, samples: int | Sequence[int] | None, usual: Sequence[int], poses: Array) -> ParameterGrid:
        counts = sample_counts(samples, self.sampled_names, usual)
        if math.prod(counts) > MOST_SAMPLES:
            raise InvalidInputError("samples", samples, f"at most {MOST_SAMPLES:,} in all, not {' x '.join(map(str, counts))}")
        limits = window(self.robot, poses)
        own = len(self.held)
        held = self._held_values(counts[:own], poses)
        lines = counts[own:] if self.free.bounds is None else counts[own:-1]
        rest = np.array(list(product(*(self._line(k, count, limits, poses) for k, count in enumerate(lines, own)))))
        if isinstance(self.free, BoundedMotion):
            spread = self.free.spread(counts[-1])
            rest = np.hstack([np.repeat(rest, len(spread), axis=0), np.tile(spread, (len(rest), 1))])
        values = np.hstack([np.repeat(held.values, len(rest), axis=0), np.tile(rest, (len(held.values), 1))])
        usual_label = Completeness.TO_RESOLUTION if self.names else Completeness.EXACT
        label = Completeness.STATISTICAL if held.missing else usual_label
        return ParameterGrid(values=values, complete=label, missing=held.missing)

    def _held_values(self, counts: Sequence[int], poses: Array) -> HeldValues:
        """Values of the held joints: their ranges with both ends, or where slides let the others reach one of the poses."""
        if self.sweeps_slides and len(poses):
            whole = not self.free.turns.value
            return bridge(self.robot, self.held, whole).values(counts, poses)
        lines = [self._joint_line(joint, count) for joint, count in zip(self.held, counts, strict=True)]
        return HeldValues(values=np.array(list(product(*lines))), missing=0.0)

    def _joint_line(self, joint: int, count: int) -> Array:
        lower, upper = span(self.robot)
        if spans_turn(self.robot)[joint]:
            return np.asarray(lower[joint] + 2 * np.pi * np.arange(count) / count)
        return line(float(lower[joint]), float(upper[joint]), count)

    def _line(self, parameter: int, count: int, limits: tuple[Array, Array], poses: Array) -> Array:
        """Values of one parameter that is no held joint: a full turn of the swivel, or those of a free motion."""
        free = parameter - len(self.names) + len(self.free.names)
        if free >= 0 and not self.by_rows:
            return self.free.line(free, count, *reach_in(self.robot, limits), poses)
        return -np.pi + 2 * np.pi * np.arange(count) / count

    def whole_poses(self, usual: Sequence[int], poses: Array) -> list[Array]:
        """For each of poses (p, 4, 4) a grid of parameters (s, r) that keep the whole pose; empty without a free motion."""
        free = 0 if self.by_rows else len(self.free.names)
        if not free:
            return [np.zeros((0, len(self.names)))] * len(poses)
        own = len(self.names) - free
        rows = self.grid([usual[own - 1]] * own + [1] * (len(self.sampled_names) - own), usual, poses)
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
        moved = self._move_onto(q, poses, np.ones(self.robot.n, dtype=np.bool_))
        inner = np.clip(moved, limits.lower + inside, limits.upper - inside)
        beyond = inner != moved
        for stopped in np.unique(beyond[beyond.any(axis=1)], axis=0):
            free = len(self.free.names) if self.free.bounds is None else 0
            if self.robot.n - stopped.sum() >= (PLANAR_POSE if self.robot.planar else POSE) - free:
                rows = np.flatnonzero((beyond == stopped).all(axis=1))
                moved[rows] = self._move_onto(inner[rows], poses[rows], ~stopped)
        return np.clip(moved, limits.lower, limits.upper)

    def moved_onto(self, q: Array, poses: Array) -> tuple[Array, NDArray[np.bool_]]:
        """As `onto`, without the limits, and which of the rows (k,) reach their pose."""
        moved = self._move_onto(q, poses, np.ones(self.robot.n, dtype=np.bool_))
        targets, rows = self.free.nearest(self.kinematics.pose(moved), poses), np.arange(len(q))
        return moved, self._residual(moved, targets, rows) <= _allow_residual(poses)

    def _move_onto(self, q: Array, poses: Array, moves: NDArray[np.bool_]) -> Array:
        """Configurations (k, n) after minimum-norm Newton steps of the joints `moves` (n,) onto poses (k, 4, 4)."""
        if self.free.names and self.free.bounds is None and (self.by_rows or not self.robot.planar):
            return onto_rows(self.kinematics, self.free, q, poses, moves, REACHED / 100)
        targets = self.free.nearest(self.kinematics.pose(q), poses)
        return MovingArm(self.screws, moves).refine(q, targets, np.arange(len(q)), steps=STEPS, tolerance=REACHED / 100)

    def solve(self, poses: Array, owners: NDArray[np.int64], samples: Array, deadline: Deadline = NEVER) -> Found:
        """All solutions for samples (s, r), with duplicates; `owners` (s,) is the pose index of each sample.

        Those found until the deadline are of samples in random order, so that they are spread over the grid.
        """
        order = np.random.default_rng(0).permutation(len(samples)) if np.isfinite(deadline.at) else np.arange(len(samples))
        found = self.solve_once(poses, owners[order], samples[order], deadline)
        rows, q = self.with_turns(found.q)
        source, residual = found.source[rows], found.residual[rows]
        turning = self.turning
        limits = self.robot.limits  # where a turn may end just before the pose
        stopped = ((q[:, turning] == limits.lower[turning]) | (q[:, turning] == limits.upper[turning])).any(axis=1)
        if stopped.any():
            targets, at = self._targets(poses, owners[order], samples[order], source[stopped])
            residual[stopped] = self._residual(q[stopped], targets, at)
        allowed = _allow_residual(poses)[owners[order][source]]
        source = order[source]
        rows = np.lexsort((residual > allowed, source))  # exact solutions first: `distinct` takes the first of duplicates
        rows = rows[self._is_solution(q, source, residual, allowed)[rows]]
        return replace(found, q=q[rows], source=source[rows], residual=residual[rows])

    def _is_solution(self, q: Array, source: NDArray[np.int64], residual: Array, allowed: Array) -> NDArray[np.bool_]:
        """Whether q (k, n) are solutions: within `allowed`, or within NEARLY at a limit or for samples without an exact one."""
        good, limits = residual <= allowed, self.robot.limits
        stopped = ((q == limits.lower) | (q == limits.upper)).any(axis=1)
        return np.asarray(good | ((residual <= NEARLY) & (stopped | ~np.isin(source, source[good]))))

    def with_turns(self, q: Array) -> tuple[NDArray[np.int64], Array]:
        """Solutions of `solve_once` (k, n) at each full turn inside the limits, (l, n), and the row (l,) that each is of."""
        rows = np.arange(len(q))
        for joint in self.turning:
            lower, upper = self.robot.limits.lower[joint], self.robot.limits.upper[joint]
            first = q[:, joint] - np.where(q[:, joint] - 2 * np.pi >= lower - NEARLY, 2 * np.pi, 0.0)
            counts = ((upper - first + NEARLY) // (2 * np.pi)).astype(np.int64) + 1
            again = np.repeat(np.arange(len(q)), counts)
            turns = np.arange(len(again)) - np.repeat(np.cumsum(counts) - counts, counts)
            q, rows = q[again], rows[again]
            q[:, joint] = np.clip(first[again] + 2 * np.pi * turns, lower, upper)
        return rows, q

    @property
    def most(self) -> int:
        """Maximum number of solutions of one sample; a guess for arms without closed form."""
        ranges = self.robot.limits.upper - self.robot.limits.lower
        return MOST * math.prod(int((ranges[k] + AT_LIMIT) // (2 * np.pi)) + 1 for k in self.turning)

    @cached_property
    def turning(self) -> list[int]:
        """The joints that are listed at more than one full turn; none where Newton steps find the solutions."""
        ranges = self.robot.limits.upper - self.robot.limits.lower
        once = spans_turn(self.robot)
        free = (
            np.flatnonzero(self.robot.turns).tolist() if self.own is not None else () if self.form is None else self.form.free
        )
        return [k for k in free if 2 * np.pi - 2 * AT_LIMIT <= ranges[k] and not once[k]]

    def solve_once(self, poses: Array, owners: NDArray[np.int64], samples: Array, deadline: Deadline = NEVER) -> Found:
        """As `solve`, but of configurations that differ by full turns only that with the smallest values inside the limits."""
        if self.by_rows:
            return self._by_rows(poses[owners], owners, self.free, samples, deadline)
        if self.own is not None:
            return self._by_own(self.own, poses, owners, samples, deadline)
        if self.robot.planar:
            targets, rows = self._targets(poses, owners, samples, np.arange(len(samples)))
            return self._by_rows(targets[rows], owners, NOTHING, samples, deadline)
        if self.form is None:
            return self._by_search(poses, owners, samples, deadline)
        asked = poses, owners, samples
        if self.free.names and self.free.only_axis is None:
            every = np.arange(len(samples))
            asked = self._targets(poses, owners, samples, every)[0], every, samples[:, : -len(self.free.names)]
        blocks: list[Found] = []
        for q, source, solved in self._enumeration(*asked):
            blocks.append(self._check_solutions(q, source, *self._targets(poses, owners, samples, source)))
            if deadline.passed:
                return replace(_join(blocks, self.robot.n), solved=solved / len(samples))
        return _join(blocks, self.robot.n)

    def _targets(
        self, poses: Array, owners: NDArray[np.int64], samples: Array, source: NDArray[np.int64]
    ) -> tuple[Array, NDArray[np.int64]]:
        """Poses (p, 4, 4), and the index (k,) of the one that each row must reach."""
        if not self.free.names:
            return poses, owners[source]
        values = samples[source, -len(self.free.names) :]
        return self.free.poses(poses[owners[source]], values), np.arange(len(source))

    def judged(self, q: Array, pose: Array) -> Found:
        """The rows of q (k, n) that reach a pose (4, 4), after refinement where rounding requires it."""
        targets = self.free.nearest(self.kinematics.pose(q), np.tile(pose, (len(q), 1, 1)))
        return self._check_solutions(q, np.arange(len(q)), targets, np.arange(len(q)))

    def _check_solutions(self, q: Array, source: NDArray[np.int64], targets: Array, rows: NDArray[np.int64]) -> Found:
        """The rows of q that reach their pose, targets[rows], after refinement where rounding requires it."""
        residual, allowed = self._residual(q, targets, rows), _allow_residual(targets)[rows]
        off = residual > allowed
        if self.form is not None and self.form.exact:
            off &= residual < ROUNDED * allowed / REACHED
        if off.any():
            better = self._holding.refine(q[off], targets, rows[off], steps=STEPS, tolerance=REACHED / 100)
            better = np.clip(better, self.robot.limits.lower, self.robot.limits.upper)
            left, q = self._residual(better, targets, rows[off]), q.copy()
            nearer = np.flatnonzero(off)[left < residual[off]]
            q[nearer], residual[nearer] = better[left < residual[off]], left[left < residual[off]]
        good = self._is_solution(q, source, residual, allowed)
        return Found(q=q[good], source=source[good], residual=residual[good])

    def _residual(self, q: Array, targets: Array, rows: NDArray[np.int64]) -> Array:
        if not len(q):
            return np.zeros(0)
        return residuals(self.kinematics.pose(q), targets, rows)

    def _by_rows(self, poses: Array, owners: NDArray[np.int64], free: FreeMotion, samples: Array, deadline: Deadline) -> Found:
        """Solutions of what counts of poses (s, 4, 4), the pose of each sample (s, r), from random starts.

        Samples of the same pose have the same one of `owners` (s,).
        """
        rng, limits, robot = np.random.default_rng(self.seed), self.robot.limits, self.robot
        count, begin = max(STARTS, ALL_STARTS // max(int(np.bincount(owners).max(initial=0)), 1)), 0
        together = TOGETHER * STARTS // count
        blocks: list[Found] = []
        moves = np.ones(robot.n, dtype=np.bool_)
        moves[list(self.held)] = False
        places = StartsOfPoses(robot, whole_pose=not free.turns.value)
        while begin < len(samples) and not (blocks and deadline.passed):
            source = np.repeat(np.arange(begin, min(begin + together, len(samples))), count)
            q = places.random(poses[source], rng)
            q[:, list(self.held)] = samples[source, : len(self.held)]
            q, residual = search_rows(self.kinematics, free, q, poses[source], moves)
            good = (residual <= _allow_residual(poses)[source]) & (limits.outside(q) <= 0).all(axis=1)
            blocks.append(Found(q=in_turn(robot, q[good]), source=source[good], residual=residual[good]))
            begin += together
        found = _join(blocks, robot.n)
        unique, hits = merged(found.q, found.source)
        missing = float((hits == 1).sum() / hits.sum()) if len(hits) else 1.0
        solved = min(begin / max(len(samples), 1), 1.0)
        return Found(
            q=found.q[unique], source=found.source[unique], residual=found.residual[unique], missing=missing, solved=solved
        )

    def _by_own(
        self, own: OwnInverseKinematics, poses: Array, owners: NDArray[np.int64], samples: Array, deadline: Deadline
    ) -> Found:
        """What the user's solver returns for each sample, checked, refined, and inside the limits."""
        targets, rows = self._targets(poses, owners, samples, np.arange(len(samples)))
        blocks, solved, limits = list[Found](), 1.0, self.robot.limits
        (low, _), turns = span(self.robot), self.robot.turns
        for k, target in enumerate(targets[rows]):
            q = own.configurations(self.robot, target)
            residual = self._residual(q, targets, np.full(len(q), rows[k]))
            if len(q) and residual.max() > MISSED:
                worst = int(residual.argmax())
                missed = f"one that reaches {target.tolist()}; it misses it by {residual[worst]:.3g} m or rad"
                raise InvalidInputError(f"configurations of {own.name}[{worst}]", q[worst].tolist(), missed)
            q[:, turns] = (low + (q - low) % (2 * np.pi))[:, turns]
            q[:, turns] -= np.where(q - 2 * np.pi >= low - NEARLY, 2 * np.pi, 0.0)[:, turns]
            q = q[(limits.outside(q) <= NEAR_LIMIT).all(axis=1)]  # refinement moves them back to where they reach the pose
            q = np.clip(q, limits.lower, limits.upper)
            blocks.append(self._check_solutions(q, np.full(len(q), k), targets, np.full(len(q), rows[k])))
            if deadline.passed:
                solved = (k + 1) / len(samples)
                break
        return replace(_join(blocks, self.robot.n), missing=0.0 if own.complete else np.nan, solved=solved)

    def _by_search(self, poses: Array, owners: NDArray[np.int64], samples: Array, deadline: Deadline) -> Found:
        blocks, missing, solved = [], [], 1.0
        rng, places = np.random.default_rng(self.seed), StartsOfPoses(self.robot, whole_pose=True)
        targets, rows = self._targets(poses, owners, samples, np.arange(len(samples)))
        bound = bridge(self.robot, self.held, True)
        for k, target in enumerate(targets[rows]):
            if not bound.allows(samples[k, : len(self.held)], target):
                continue
            setup = ArmWithHeldJoints(robot=self.robot, screws=self.screws, held=self.held, values=samples[k, : len(self.held)])
            q, share = random_answers(setup, target, places.of(target), rng, deadline)
            blocks.append(self._check_solutions(q, np.full(len(q), k), targets, np.full(len(q), rows[k])))
            missing.append(share)
            if deadline.passed:
                solved = (k + 1) / len(samples)
                break
        found = _join(blocks, self.robot.n)
        return replace(found, missing=float(np.mean(missing)) if missing else 0.0, solved=solved)


def _allow_residual(poses: Array) -> Array:
    """The largest entry (p,) by which a configuration may miss each of poses (p, 4, 4)."""
    return np.asarray(REACHED * np.maximum(np.abs(poses[:, :3, 3]).max(axis=1, initial=0.0) / FAR, 1.0))


def sample_counts(samples: int | Sequence[int] | None, names: tuple[str, ...], usual: Sequence[int]) -> tuple[int, ...]:
    """Number of grid values of each parameter."""
    r = len(names)
    if samples is None:
        return (usual[min(r, len(usual)) - 1],) * r
    if not isinstance(samples, list | tuple):
        return (whole_number("samples", samples, least=1, most=10**12),) * r
    if len(samples) != r:
        wanted = f"one whole number, or one for each of {', '.join(names) or 'no parameters'}"
        raise InvalidInputError("samples", samples, wanted)
    return tuple(whole_number(f"samples[{k}] ({names[k]})", each, least=1, most=10**12) for k, each in enumerate(samples))


def _solves_rows(robot: Robot, free: FreeMotion) -> bool:
    """Whether an arm has too few joints to reach a pose at each value of a free motion."""
    return bool(free.names) and has_few_joints(robot)


@once_per_source
def _enumeration(robot: Robot, form: ClosedForm, axis: tuple[float, ...] | None) -> Enumeration:
    """The enumeration of solutions in the first full turn of each joint that is free."""
    lower, upper = robot.limits.lower.copy(), robot.limits.upper.copy()
    for k in form.free:
        if spans_turn(robot)[k] and lower[k] <= -np.pi and upper[k] >= np.pi:
            lower[k], upper[k] = -np.inf, np.inf
        upper[k] = min(upper[k], lower[k] + 2 * np.pi) if np.isfinite(lower[k]) else upper[k]
    return Enumeration(form, lower, upper, None if axis is None else np.array(axis))


def spare(robot: Robot) -> int:
    """Degree of redundancy: number of joints beyond those that the arm's poses need."""
    q = robot.random_configuration(np.random.default_rng(0), size=5)
    ranks = np.linalg.matrix_rank(robot.kinematics(Task.pose()).jacobian(q), tol=1e-8)
    return robot.n - int(ranks.max())


def _check_limits(robot: Robot) -> None:
    """Raises InvalidInputError where a joint has a limit on one side only, or a prismatic joint has none."""
    limits = robot.limits
    half = (np.isinf(limits.lower) | np.isinf(limits.upper)) & ~robot.continuous_joints
    if half.any():
        k = int(half.argmax())
        wanted = "finite limits on both sides; only a revolute joint whose followers make whole turns with it may have none"
        raise InvalidInputError(f"limits of {robot.joint_names[k]}", (float(limits.lower[k]), float(limits.upper[k])), wanted)


def _join(blocks: list[Found], n: int) -> Found:
    if not blocks:
        return Found(q=np.zeros((0, n)), source=np.zeros(0, dtype=np.int64), residual=np.zeros(0))
    return Found(
        q=np.concatenate([block.q for block in blocks]),
        source=np.concatenate([block.source for block in blocks]),
        residual=np.concatenate([block.residual for block in blocks]),
    )
