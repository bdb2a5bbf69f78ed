"""The best motion inside the tube around a recording that keeps the limits, the duration and the clearance."""

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from manipplan.collision.model import CollisionModel, apart_text
from manipplan.collision.path_clearance import PathClearance, path_clearance
from manipplan.cost.integral import PathIntegral
from manipplan.optimize.clearance import (
    DISTANCE_INTERVALS,
    NEAR,
    ClearanceRows,
    Place,
    distance_profile,
    more_places,
    nearest,
    rows_for,
)
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import Tolerance
from manipplan.paths.trajectory import Trajectory
from manipplan.plans.report import VANISHING, Comparison, MotionFigures, deviation_between, held, pose_distances
from manipplan.recordings.program import TubeProgram, Weights
from manipplan.recordings.recording import Smooth
from manipplan.robots.model_tree import frame_index
from manipplan.support.checks import Array
from manipplan.support.deadline import NEVER, Deadline, OutOfTimeError, work_time
from manipplan.support.display import round_up
from manipplan.support.errors import InvalidInputError
from manipplan.symbolic.task import Task

#: Maximum number of samples of a recording that are looked at.
SAMPLES = 2000


def blocked(model: CollisionModel, motion: Trajectory, tolerance: Tolerance, task: Task, clearance: float) -> str:
    """Why the tube leaves no motion: the two bodies, their overlap, the time, and how far the one can move; "" where it may.

    A point of a body that moves with the tool moves by at most r + 2 sin(ρ/2) d inside a tube of the radii r and ρ, with its
    distance d from the tool. The distances of convex bodies, and their depths where they overlap, change by no more than that.
    """
    robot, kernel = model.robot, model.kernel_copy()
    pairs, levers = _pairs_of_tool(model)
    if not len(pairs) or len(robot.tools) > 1:
        return ""
    position, rotation = held(task)
    if not position or tolerance.position is None or task.relative_to is not None:
        return ""
    is_turned = rotation and tolerance.rotation is not None and task.free_axis is None
    angle = tolerance.rotation if is_turned and tolerance.rotation is not None else np.pi
    reach = tolerance.position + 2 * np.sin(min(angle, np.pi) / 2) * levers
    rows = np.unique(np.linspace(0, len(motion.t) - 1, SAMPLES).astype(np.int64))
    q = np.repeat(motion.q[rows], len(pairs), axis=0)
    found = kernel.pair_distances(q, np.tile(pairs, len(rows)), np.full(len(q), max(clearance, 0.0)))
    short = clearance - reach - found.reshape(len(rows), len(pairs))
    short = np.where(np.isnan(short), -np.inf, short)
    row, pair = (int(k) for k in np.unravel_index(np.argmax(short), short.shape))
    if short[row, pair] <= 0:
        return ""
    first, second = model.pair_names[pairs[pair]]
    apart = apart_text(float(found.reshape(short.shape)[row, pair]))
    return (
        f"on the recording {first} and {second} {apart} at {motion.t[rows[row]]:.3f} s, and inside the tolerance no point of "
        f"{first} moves by more than {1e3 * reach[pair]:.3g} mm"
    )


def _pairs_of_tool(model: CollisionModel) -> tuple[NDArray[np.int64], Array]:
    """Indices (k,) of the pairs of a convex body that moves with the tool and an obstacle, and levers (k,) [m].

    A lever is the largest distance of the body's points from the tool.
    """
    robot = model.robot
    frame = robot.model.frames[frame_index(robot.model, robot.tool)]
    objects = model.geometry.geometryObjects
    pairs, levers = [], []
    for k, pair in enumerate(model.geometry.collisionPairs):
        first, second = objects[pair.first], objects[pair.second]
        mine, other = (first, second) if second.parentJoint == 0 else (second, first)
        if mine.parentJoint != frame.parentJoint or other.parentJoint != 0 or {pair.first, pair.second} & set(model.solids):
            continue
        mine.geometry.computeLocalAABB()
        centre = mine.placement.act(np.asarray(mine.geometry.aabb_center).ravel())
        around = mine.geometry.aabb_radius + max(model.radii.get(pair.first, 0.0), model.radii.get(pair.second, 0.0))
        pairs.append(k)
        levers.append(float(np.linalg.norm(centre - frame.placement.translation)) + around)
    return np.array(pairs, dtype=np.int64), np.array(levers)


#: Weights for the best motion, for the smoothest one, and for the shortest duration.
BEST, SMOOTHEST, SHORTEST = Weights(energy=1.0, room=1.0, jerk=1.0), Weights(jerk=1.0), Weights(time=1.0, jerk=1e-4)
#: Share of the tolerance that noise may take.
NOISE = 0.9
#: Maximum number of solves with other clearance rows or a narrower tube, by how much more than needed the tube narrows,
#: and its smallest share.
ROUNDS, NARROWER, LEAST = 8, 1.5, 0.02
#: Shares of the tube in which the best motion is looked for, until it is valid and better than the recording.
SHARES = (1.0, 0.5, 0.25)
#: Time that the ending takes, as a multiple of that of the proof and the comparison of one motion.
ENDING = 5.0
#: Factors by which the number of pieces rises while no motion keeps the limits, and share by which a limit counts as kept.
FINER, ROUNDING = (1, 2, 4), 1e-8


@dataclass(frozen=True, kw_only=True, eq=False)
class Tube:
    """What a motion of a duration [s] has to keep: the tolerance of the recorded poses, and a clearance [m].

    `figures` are those of the recording; the deadline is when the search has to end.
    """

    recorded: Trajectory
    figures: MotionFigures
    integral: PathIntegral
    model: CollisionModel
    tolerance: Tolerance
    clearance: float
    duration: float
    deadline: Deadline = NEVER

    @property
    def radii(self) -> Array:
        """Radii of the tube in position [m] and rotation [rad]; inf: not bounded."""
        both, counts = (self.tolerance.position, self.tolerance.rotation), held(self.integral.kinematics.task)
        return np.array([r if r is not None and c else np.inf for r, c in zip(both, counts, strict=True)])

    def judge(self, motion: Trajectory) -> Comparison:
        """The recording and a motion side by side."""
        return Comparison(
            recorded=self.figures,
            improved=MotionFigures.of(motion, self.integral),
            measure_unit=self.integral.kinematics.measure.unit(self.integral.kinematics.task),
            deviation=deviation_between(self.recorded, motion, self.integral),
            tolerance=self.tolerance,
        )

    def proof(self, path: JointPath) -> PathClearance:
        """The proof of the clearance on a path."""
        return path_clearance(self.model, path, clearance=self.clearance, tolerance=None)


@dataclass(frozen=True, kw_only=True, eq=False)
class MotionFound:
    """A motion in the tube, its comparison with the recording, and whether the deadline ended the search for a better one."""

    motion: Trajectory
    comparison: Comparison
    out_of_time: bool = False


def best_motion(tube: Tube, smooth: Smooth) -> MotionFound | None:
    """The best motion in the tube, at the deadline the best that was proven; None if none is clear of collisions or in time.

    Raises InvalidInputError where noise takes most of the tolerance, and for a duration that is too short for the limits.
    """
    shortest = np.inf
    for factor in FINER:
        search = _PieceSearch(tube, smooth.finer(factor))
        first, ratio = search.within_limits()
        if ratio <= 1.0:
            return search.run(first)
        if tube.deadline.passed:
            return None
        shortest = min(shortest, ratio)
    robot = tube.model.robot.name
    least = f"{round_up(shortest * tube.duration, 4):g}"
    kept = f"the shortest found in which {robot} keeps its limits and the tolerance"
    if tube.duration == tube.recorded.duration:
        wanted = f"duration={least} or longer, {kept}"
        raise InvalidInputError("recorded", f"a motion of {tube.duration:g} s without a duration", wanted)
    raise InvalidInputError("duration", tube.duration, f"at least {least} s, {kept}")


class _PieceSearch:
    """The search for the best motion over the pieces of a smooth one."""

    def __init__(self, tube: Tube, smooth: Smooth) -> None:
        self.tube, self.smooth = tube, smooth
        self.robot = tube.model.robot
        self.program = TubeProgram(tube.integral, smooth.basis, smooth.ends, tube.duration, self.robot.limits)
        self.poses = tube.integral.kinematics.pose(self.program.values @ smooth.control)
        self.spacing = float(np.median(np.diff(tube.recorded.t))) * max(tube.duration / tube.recorded.duration, 1.0)
        self.room = tube.radii - self._scatter()
        self.deadline = tube.deadline

    def run(self, first: Array) -> MotionFound | None:
        """The first valid motion that is better than the recording, or else the first that is valid; None if there is none."""
        valid: list[MotionFound] = []
        timed = np.isfinite(self.tube.deadline.at)
        if timed:  # the one that needs no search is proven first, and shows how long the ending takes
            began = work_time()
            valid += self._judged(first)
            self.deadline = replace(self.deadline, at=self.deadline.at - ENDING * (work_time() - began))
        for control in self._candidates(first, last=not timed):
            valid += self._judged(control)
            if valid and valid[-1].comparison.better:
                break
        # from the last candidate on, those in which nothing got worse first
        best = min(reversed(valid), key=lambda each: len(each.comparison.worse), default=None)
        return None if best is None else replace(best, out_of_time=self.deadline.passed)

    def _judged(self, control: Array) -> list[MotionFound]:
        """The motion with its comparison if it is valid, else nothing."""
        motion = self._motion(control)
        return [MotionFound(motion=motion, comparison=self.tube.judge(motion))] if self._is_valid(motion) else []

    def _candidates(self, first: Array, *, last: bool) -> Iterator[Array]:
        """Control points of the best motion in narrower and narrower tubes, of the smoothest one, and the first ones.

        None is sought after the deadline. `last`: whether the first ones are among them.
        """
        for weights, share in (*((BEST, share) for share in SHARES), (SMOOTHEST, 1.0)):
            if self.deadline.passed:
                return
            yield self._solve_share(first, weights, self._least, share)
        if last:
            yield first

    @property
    def _least(self) -> float:
        """The minimum manipulability to keep; 0 for rounding noise at a singularity."""
        least = self.tube.figures.min_manipulability
        return least if least >= VANISHING else 0.0

    def _motion(self, control: Array) -> Trajectory:
        return self.smooth.basis.trajectory(control, self.tube.duration, self.spacing, self.robot.joint_names)

    def _is_valid(self, motion: Trajectory) -> bool:
        """Whether a motion is inside the tube, and its clearance is proven."""
        off = deviation_between(self.tube.recorded, motion, self.tube.integral)
        inside = (np.array([off.position, off.rotation]) <= self.tube.radii).all()
        return bool(inside) and self.tube.proof(motion.path()).proven

    def _scatter(self) -> Array:
        """Largest distances [m, rad] (k, 2) of recorded poses from the smooth motion, around each place of the program.

        Raises InvalidInputError where they take most of the tolerance.
        """
        recorded, kinematics = self.tube.recorded, self.tube.integral.kinematics
        u = recorded.t / recorded.duration
        curve = self.smooth.basis.values(u) @ self.smooth.control
        off = np.stack(pose_distances(kinematics.pose(recorded.q), kinematics.pose(curve), kinematics.task), axis=1)
        row, kind = (int(k) for k in np.unravel_index((off / self.tube.radii).argmax(), off.shape))
        if off[row, kind] > NOISE * self.tube.radii[kind]:
            name, unit = (("position", "m"), ("rotation", "rad"))[kind]
            least = float(off[row, kind]) / NOISE
            raise InvalidInputError(
                f"tolerance.{name}",
                float(self.tube.radii[kind]),
                f"at least {round_up(least, 4):g} {unit}: so far is the recorded pose of row {row} ({recorded.t[row]:.4g} s) "
                "from the smooth motion under the noise",
            )
        index = np.clip(np.searchsorted(u, self.program.u), 0, len(u))
        reach = 1.0 / self.smooth.basis.pieces
        first, last = np.searchsorted(u, self.program.u - reach), np.searchsorted(u, self.program.u + reach)
        around = [off[min(a, i) : max(b, i + 1)] for a, b, i in zip(first, last, np.minimum(index, len(u) - 1), strict=True)]
        return np.array([each.max(axis=0) for each in around])

    def within_limits(self) -> tuple[Array, float]:
        """Control points of the smooth motion or, if that exceeds limits, of the fastest one in the tube.

        Beside them stands the duration that they need, as a multiple of the wanted one: at most 1 if the limits hold.
        """
        limits, control = self.robot.limits, self.smooth.control
        inside = ((control >= limits.lower) & (control <= limits.upper)).all()
        if inside and self.program.used(control) <= 1.0:
            return control, 1.0
        first = np.clip(control, limits.lower, limits.upper)
        with suppress(OutOfTimeError):
            first, _ = self.program.solve(first, SHORTEST, poses=self.poses, tube=self.room, deadline=self.deadline)
        return first, self.program.used(first) * (1 - ROUNDING)

    def _solve_share(self, first: Array, weights: Weights, least: float, share: float) -> Array:
        """The solution in this share of the tube, with more clearance rows and a narrower tube until it is free and inside."""
        model, clearance = self.tube.model, self.tube.clearance
        safe = self._motion(first).path()
        rows: ClearanceRows | None = None
        places: tuple[Place, ...] = ()
        room, control = share * self.room, first
        for _ in range(ROUNDS):
            try:
                control, _ = self.program.solve(
                    first, weights, poses=self.poses, tube=room, least=least, rows=rows, deadline=self.deadline
                )
            except OutOfTimeError:
                break
            if self.deadline.passed:
                break
            motion = self._motion(control)
            path = motion.path()
            proof = self.tube.proof(path)
            found = deviation_between(self.tube.recorded, motion, self.tube.integral)
            excess = np.array([found.position, found.rotation]) - self.tube.radii
            more = places
            if not proof.proven:
                profile = distance_profile(model, path(np.linspace(0.0, 1.0, DISTANCE_INTERVALS + 1)), clearance + NEAR)
                failed_at = ((proof.at, proof.pair_id),) if proof.refuted else ()
                more = more_places(places, profile, failed_at, clearance, is_free=False)
            if more == places and not (excess > 0).any():
                break
            places, room = more, np.maximum(room - NARROWER * np.maximum(excess, 0.0), LEAST * self.room)
            rows = rows_for(model, path, safe, nearest(model, path, places), clearance)
        return control
