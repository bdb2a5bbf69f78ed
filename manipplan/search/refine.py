"""refine: improve the best path through the samples beyond the sampling grid."""

from dataclasses import dataclass, replace
from itertools import product
from typing import TYPE_CHECKING

import numpy as np

from manipplan.paths.tolerance import Tolerance
from manipplan.search.layers import Layers, step_limits
from manipplan.search.max_min import SearchResult, max_min_search
from manipplan.search.sweep import path_length, path_steps, steps_between, within
from manipplan.support.checks import Array, flag, instance, number, whole_number
from manipplan.support.deadline import NEVER, Deadline, OutOfTimeError, work_time
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError
from manipplan.support.progress import Progress, as_callback, interruptible

if TYPE_CHECKING:
    from manipplan.search.sampling import CandidateSampler

#: Number of values per parameter around the current path, for one, two, three and more parameters, and the factor on their
#: spread from round to round.
AROUND, CLOSER = (5, 5, 3), 0.4
#: Maximum number of rounds of finer samples.
MOST_RESAMPLED = 20
#: Trust region of the program at first, also its largest one while the minimum is raised, and its largest one while the path
#: is shortened; the smallest one [rad or m], and the factors by which it changes.
TRUST, WIDE_TRUST, LEAST_TRUST = 0.3, 1.2, 1e-4
SHRINK, GROW = 0.35, 2.0
#: Maximum number of solves of the program, and minimum relative gain in the minimum manipulability for another solve.
SOLVES, GAIN = 30, 1e-7
#: Relative margin of steps and tolerances, for rounding.
SPARE = 1e-9
#: Minimum relative decrease of the sum of squared steps for another solve that shortens the path.
SHORTER = 1e-3
#: Share of the minimum manipulability that is given up for a shorter path: at the maximum itself the path has no freedom.
GIVEN = 1e-4
#: Share of the level by which the program's result may be below it, for rounding.
ROUNDED = 1e-8
#: Margin above the clearance below which a distance gets a constraint [m].
NEAR = 0.05
#: Tolerance on a pose, in position [m] and rotation [rad].
MET = 1e-9
#: Tolerance within which a configuration equals a candidate of the layers [rad or m]: full turns cause rounding.
CANDIDATE_TOLERANCE = 1e-9


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class Refinement:
    """A refined path through all positions; each value belongs to a path that was checked again.

    Attributes:
        q: (L, n) configurations [rad or m].
        manipulability: (L,) manipulability.
        discrete: minimum manipulability of the path that was found among the samples.
        resampled: the same, after finer samples around that path.
        refined: minimum manipulability of q, at least as large as the other two, to 1e-8 of it.
        bound: smallest over the positions of the largest manipulability among all samples, raised by ascent from them: an
            estimate of the upper bound on every path; it is certain only for the samples.
        length: Σ ‖Δq‖ of q [rad or m].
        history: minimum manipulability after each accepted step.
    """

    q: Array
    manipulability: Array
    discrete: float
    resampled: float
    refined: float
    bound: float
    length: float
    history: tuple[float, ...]

    @property
    def gap(self) -> float:
        """bound - refined."""
        return self.bound - self.refined

    def __str__(self) -> str:
        return (
            f"minimum manipulability {self.discrete:.6g} among the samples, {self.resampled:.6g} with finer ones, "
            f"{self.refined:.6g} refined; bound {self.bound:.6g}"
        )


@interruptible()
def refine(
    layers: Layers,
    found: SearchResult,
    *,
    tolerance: Tolerance | None = None,
    resample: int = 2,
    hold_start: bool = False,
    time_limit: float | None = None,
    progress: Progress | None = None,
) -> Refinement:
    """Raise the minimum manipulability of a searched path beyond what its samples allow, within all constraints of the search.

    Finer samples around the path are searched first. Then a nonlinear program over all positions at once raises the minimum
    manipulability, and finally shortens the path, for which it gives up at most 1e-4 of that minimum. A step is accepted only
    when an independent check of poses, limits, ε and collisions passes: the result is never worse than the given path. With an
    inverse kinematics of the user the path stays as it is.

    Args:
        layers: made by `sample_layers`.
        found: result of `max_min_search` in these layers.
        tolerance: deviation of the tool allowed at each pose, in a box inside this ball; None: no deviation.
        resample: number of rounds of finer samples.
        hold_start: whether the first configuration stays as it is.
        time_limit: time [s] after which the best path so far is returned; None: none. What is built once does not count.
        progress: called with the share done in [0, 1] and a text.

    Raises InvalidInputError for layers without robot and poses, or a search that found no path.
    """
    instance("layers", layers, Layers)
    instance("found", found, SearchResult)
    if layers.sampler is None or layers.poses is None:
        raise InvalidInputError("layers", "layers of given arrays", "layers of sample_layers, which hold their robot and poses")
    if not found.connected or len(found.q) != len(layers.q):
        raise InvalidInputError(
            "found", found.status.name, f"the result of a search through these {len(layers.q)} layers that found a path"
        )
    for k, (q, index) in enumerate(zip(layers.q, found.indices, strict=True)):
        same = index < len(q) and q.shape[1] == found.q.shape[1]
        if not same or np.abs(steps_between(q[index], found.q[k], layers.continuous)).max() > CANDIDATE_TOLERANCE:
            raise InvalidInputError("found", f"another candidate at position {k}", "the result of a search in these layers")
    whole_number("resample", resample, least=0, most=MOST_RESAMPLED)
    if tolerance is not None:
        instance("tolerance", tolerance, Tolerance)
    flag("hold_start", hold_start)
    deadline = NEVER if time_limit is None else Deadline.within(number("time_limit", time_limit, above=0.0))
    refiner = _Refiner(layers, found, layers.sampler, layers.poses, tolerance, hold_start, deadline)
    return refiner.run(resample, as_callback(progress))


class _Refiner:
    """State shared by the steps of a refinement."""

    def __init__(
        self,
        layers: Layers,
        found: SearchResult,
        sampler: "CandidateSampler",
        poses: Array,
        tolerance: Tolerance | None,
        hold_start: bool,
        deadline: Deadline,
    ) -> None:
        from manipplan.search.program import level_program

        self.layers, self.found, self.sampler, self.poses = layers, found, sampler, poses
        self.robot, self.clearance = sampler.spec.robot, sampler.spec.clearance
        self.model, self.kinematics = sampler.collision, sampler.kinematics
        self.hold_start, self.deadline = hold_start, deadline
        self.program = level_program(self.kinematics, len(self.poses), closed=layers.closed)
        self.tolerance, self.is_exact = self.program.rows.box(tolerance), tolerance is None
        self.step_limits = step_limits(layers, found.epsilon)
        self.history = [found.minimum]
        self.longest = 0.0  # time of the longest solve so far [s]
        self.bound = self._bound()

    def run(self, resample: int, progress: Progress) -> Refinement:
        q = self.found.q
        fixed = self.sampler.solver.own is not None  # the user's inverse kinematics may leave out what is in between
        for k in range(0 if fixed else resample):
            if self.deadline.passed:
                break
            progress(0.3 * k / max(resample, 1), f"finer samples, minimum manipulability {self.least(q):.6g}")
            q = self._resample(q, self.found.epsilon * CLOSER**k)
        resampled = self.least(q)
        if not fixed:
            q = self._raise_minimum(q, progress)
            q = self._shorten(q, resampled, progress)
        m = self.kinematics.manipulability(q)
        return Refinement(
            q=q,
            manipulability=m,
            discrete=self.found.minimum,
            resampled=resampled,
            refined=float(m.min()),
            bound=max(self.bound, float(m.min())),
            length=path_length(q, self.layers.continuous, closed=self.layers.closed),
            history=tuple(self.history),
        )

    def least(self, q: Array) -> float:
        return float(self.kinematics.manipulability(q).min())

    def _resample(self, q: Array, width: Array) -> Array:
        """The best path through samples around `q` (L, n) and the configurations of `q` itself."""
        solver = self.sampler.solver
        parameters = solver.parameters_of(q, self.poses)
        own = len(solver.sampled_names) - (solver.free.bounds is not None)  # the program moves the poses within a region
        if own == 0:
            return q
        spread = float(width.max())
        around = np.linspace(-spread, spread, AROUND[min(own, len(AROUND)) - 1])
        offsets = np.array(list(product(around, repeat=own)))
        offsets = np.hstack([offsets, np.zeros((len(offsets), parameters.shape[1] - own))])
        sets, values = [], []
        try:
            sampled = self.sampler.sample(self.poses, [each + offsets for each in parameters], deadline=self.deadline)
        except OutOfTimeError:
            return q
        for k, (near, m) in enumerate((each.q, each.m) for each in sampled):
            step = steps_between(q[k], near, self.layers.continuous)
            beside = np.abs(step).max(axis=1) < (10 * spread if k or not self.hold_start else 0.0)
            sets.append(np.vstack([q[k], q[k] + step[beside]]))
            values.append(np.append(self.kinematics.manipulability(q[k]), m[beside]))
        finer = replace(self.layers, q=tuple(sets), m=tuple(values), turn_middles=None)
        found = max_min_search(finer, self.found.epsilon, strict=self.found.strict, throw=False)
        return self._better(q, found.q) if found.connected else q

    def _better(self, q: Array, new: Array) -> Array:
        """The new path if it is valid and has a larger minimum manipulability, else q."""
        if self.least(new) <= self.least(q) or not self.sound(new):
            return q
        self.history.append(self.least(new))
        return new

    def _raise_minimum(self, q: Array, progress: Progress) -> Array:
        trust = TRUST
        for k in range(SOLVES):
            progress(0.3 + 0.6 * k / SOLVES, f"raising the minimum manipulability, {self.least(q):.6g}")
            before = self.least(q)
            if self.is_late or before >= self.bound - GAIN * abs(self.bound):
                break
            new, _ = self._solve(q, trust, None)
            new = self._on_poses(new)
            if before < self.least(new) < before + GAIN * abs(before):
                break  # the gain is negligible
            new = self._better(q, new)
            if new is q:
                trust *= SHRINK
                if trust < LEAST_TRUST:
                    break
                continue
            moved = np.abs(new - q).max()
            q = new
            trust = min(trust * GROW, TRUST) if moved > 0.9 * trust else trust
        return q

    @property
    def is_late(self) -> bool:
        """Whether the time that is left is over, or may not be enough for another solve."""
        return self.deadline.left <= self.longest

    def _shorten(self, q: Array, resampled: float, progress: Progress) -> Array:
        level = max(self.least(q) - GIVEN * abs(self.least(q)), resampled)
        trust = TRUST
        while trust > LEAST_TRUST and not self.is_late:
            progress(0.9, "shortening the path")
            new, _ = self._solve(q, trust, level)
            new = self._on_poses(new)
            if self._squares(new) > self._squares(q) * (1 - SHORTER):
                return q  # the program's objective falls no further
            if self.least(new) >= level - ROUNDED * abs(level) and self.sound(new):
                trust = min(trust * GROW, WIDE_TRUST) if np.abs(new - q).max() > 0.9 * trust else trust
                q = new
            else:
                trust *= SHRINK
        return q

    def _squares(self, q: Array) -> float:
        """Σ ‖Δq‖² of a path (L, n), which the program minimises."""
        return float(np.square(path_steps(q, self.layers.continuous, closed=self.layers.closed)).sum())

    def _solve(self, q: Array, trust: float, level: float | None) -> tuple[Array, float]:
        began = work_time()
        slopes, slack = self._near_pairs(q, trust)
        found = self.program.solve(
            q,
            self.poses,
            epsilon=self.step_limits * (1 - SPARE),
            tolerance=self.tolerance * (1 - SPARE),
            trust=trust,
            slopes=slopes,
            slack=slack,
            level=level,
            hold_start=self.hold_start,
        )
        self.longest = max(self.longest, work_time() - began)
        return found

    def _near_pairs(self, q: Array, trust: float) -> tuple[Array, Array]:
        """Gradients (L, ROWS, n) of the distances of the nearest pairs, and by how much each may shrink (L, ROWS) [m]."""
        from manipplan.search.program import ROWS

        slopes, slack = np.zeros((len(q), ROWS, self.robot.n)), np.ones((len(q), ROWS))
        if self.model is None:
            return slopes, slack
        distances = self.model.distance_rows(q, beyond=self.clearance + NEAR)
        nearest = np.argsort(distances, axis=1)[:, :ROWS]
        apart = np.take_along_axis(distances, nearest, axis=1)
        where, rows = np.nonzero(apart < self.clearance + NEAR)
        if len(where):
            slopes[where, rows] = self.model.witnesses(q[where], nearest[where, rows]).gradients
            slack[where, rows] = np.maximum(apart[where, rows] - self.clearance - 0.05 * trust * NEAR, 0.0)
        return slopes, slack

    def _on_poses(self, q: Array) -> Array:
        """Each configuration projected onto its pose by the smallest correction, unless there is a tolerance."""
        if not self.is_exact and self.tolerance.any():
            return q
        projected = self.sampler.solver.onto(q, self.poses)
        if self.hold_start:
            projected[0] = q[0]
        return projected

    def sound(self, q: Array) -> bool:
        """Whether poses, limits, ε and clearance hold; independent of the program."""
        if (self.robot.limits.outside(q) > 0).any() or not np.isfinite(q).all():
            return False
        if not within(q, self.step_limits, self.layers.continuous, strict=self.found.strict, closed=self.layers.closed):
            return False
        errors = self.program.rows.errors(q, self.poses)
        if (np.abs(errors) > np.maximum(self.tolerance, MET)).any():
            return False
        free = q[1:] if self.hold_start else q  # the start may be nearer than candidates are
        return self.model is None or not self.model.in_collision_rows(free, clearance=self.clearance).any()

    def _bound(self) -> float:
        """The bound of the samples, raised by ascent at the positions that determine it."""
        from manipplan.search.program import ROWS, level_program

        single = level_program(self.kinematics, 1, closed=False)
        highest = np.array([m.max() for m in self.layers.m])
        best = [self.layers.q[k][int(m.argmax())] for k, m in enumerate(self.layers.m)]
        done = {0} if self.hold_start else set[int]()
        while (k := int(highest.argmin())) not in done:
            done.add(k)
            _, level = single.solve(
                best[k][None],
                self.poses[k : k + 1],
                epsilon=np.ones(self.robot.n),
                tolerance=self.tolerance,
                trust=10 * TRUST,
                slopes=np.zeros((1, ROWS, self.robot.n)),
                slack=np.ones((1, ROWS)),
            )
            highest[k] = max(highest[k], level)
        return float(highest.min())
