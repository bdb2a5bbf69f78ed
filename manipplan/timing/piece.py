"""The verified motion along one piece of path, from a stop or a given speed to the next.

It is solved, sampled as a cubic spline, and compared with the limits at the spline's exact extremes. Where it exceeds them,
it is solved again with tighter limits; what still exceeds them is removed by slowing down.

The fastest motion from rest to rest along a straight line in joint space, in closed form.

On a line q = q_0 + t l with a unit tangent t every limit of a joint is one of l: the motion is that of a single axis. It
accelerates with the largest jerk, acceleration and speed, and brakes in the same way. Jerk is constant in each of at most seven
phases, so that few samples of a cubic trajectory are the whole motion.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import pinocchio as pin

from manipplan.paths.joint import JointPath
from manipplan.paths.trajectory import Trajectory
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.timing.dynamics import (
    DIGITS,
    ArcLength,
    LimitTightening,
    PathDynamics,
    Use,
    fastest_speeds,
    path_dynamics,
    slowdown,
)
from manipplan.timing.jerk import JerkProblem, Profile, SmoothProfile, SquaredSpeed, SteppedProfile, fastest_motion
from manipplan.timing.stops import Bounds, LimitsAlong, MovingPath, ToolSpeed
from manipplan.timing.verify import jerk_of_pieces, piece_use

#: Control points farther than this share of the length from the line through their ends do not count as straight.
STRAIGHT = 1e-12
#: Shortest phase: time [s] and share of the motion, but at most one part in the last number. Rounding shows in shorter ones.
SHORTEST, SHARE, MOST_PHASES = 1e-4, 1e-5, 200
#: Largest time between samples [s], unless that makes more samples than the number.
SPACING, MOST_SAMPLES = 0.02, 300


@dataclass(frozen=True, kw_only=True, eq=False)
class StraightMotion:
    """A motion from rest to rest along a line: it speeds up, goes on at a steady speed, and slows down as it sped up.

    Attributes:
        start, goal: (n,) [rad or m].
        rise: time in which acceleration rises or falls; 0 without limited jerk [s].
        hold: time of constant acceleration [s].
        steady: time of constant speed [s].
    """

    start: Array
    goal: Array
    rise: float
    hold: float
    steady: float

    @classmethod
    def between(cls, start: Array, goal: Array, bounds: Bounds) -> "StraightMotion":
        """The fastest motion between two configurations (n,) within bounds of one row each, in whole nanoseconds.

        Acceleration jumps where no jerk is limited.
        """
        length = float(np.linalg.norm(goal - start))
        unit = np.abs(goal - start) / length
        with np.errstate(divide="ignore"):
            v, a, j = (float(np.min(kind[0] / unit)) for kind in (bounds.velocity, bounds.acceleration, bounds.jerk))
        rise, hold = _phases(length, v, a, j)
        peak = min(a, j * rise) if rise else a
        steady = length / (peak * (rise + hold)) - (2 * rise + hold)
        # longer phases need less speed, acceleration and jerk, and so does one that takes over the time of a very short one
        duration = 4 * rise + 2 * hold + steady
        shortest = min(max(SHORTEST, SHARE * duration), duration / MOST_PHASES)
        if steady < shortest:
            hold, rise, steady = (hold + steady, rise, 0.0) if hold > 0 or not rise else (0.0, rise + steady / 2, 0.0)
        if rise and hold < shortest:
            rise, hold = rise + hold, 0.0
        rise = max(rise, shortest) if rise else 0.0
        return cls(
            start=start,
            goal=goal,
            rise=_whole_nanoseconds(rise),
            hold=_whole_nanoseconds(hold),
            steady=_whole_nanoseconds(steady),
        )

    @property
    def duration(self) -> float:
        """Duration [s]."""
        return 4 * self.rise + 2 * self.hold + self.steady

    def sampled(self, names: Sequence[str], factor: float) -> Trajectory:
        """The cubic trajectory, `factor` times slower, with samples where phases begin or end, and some between.

        Those between serve controllers that interpolate samples otherwise.
        """
        rise, hold, steady = (_whole_nanoseconds(each * factor) for each in (self.rise, self.hold, self.steady))
        parts = np.array([rise, hold, rise, steady, rise, hold, rise])
        # the way is jerk · rise (rise + hold) (2 rise + hold + steady); shares of it are used as unit of length
        speed = 1 / (2 * rise + hold + steady)
        peak = speed / (rise + hold)
        rate = peak / rise if rise else 0.0
        jerk = np.array([rate, 0.0, -rate, 0.0, -rate, 0.0, rate])
        begins = np.array([0.0, peak, peak, 0.0, 0.0, -peak, -peak])
        speeds = np.append(0.0, np.cumsum(parts * (begins + parts * jerk / 2))[:-1])
        shares = np.append(0.0, np.cumsum(parts * (speeds + parts * (begins / 2 + parts * jerk / 6)))[:-1])
        ends = np.round(np.append(0.0, np.cumsum(parts)), 9)
        counts = np.ceil(parts / max(SPACING, ends[-1] / MOST_SAMPLES)).astype(int)
        phase = np.repeat(np.arange(len(parts)), counts)
        step = np.arange(len(phase)) - np.repeat(np.cumsum(counts) - counts, counts)
        t = np.round(ends[phase] + parts[phase] * step / counts[phase], 9)
        u = t - ends[phase]
        share = shares[phase] + u * (speeds[phase] + u * (begins[phase] / 2 + u * jerk[phase] / 6))
        pace = speeds[phase] + u * (begins[phase] + u * jerk[phase] / 2)
        way = self.goal - self.start
        q = np.vstack([self.start + share[:, None] * way, self.goal])
        qd = np.append(pace, 0.0)[:, None] * way
        return Trajectory(t=np.append(t, ends[-1]), q=q, qd=qd, joint_names=tuple(names))


def _phases(length: float, v: float, a: float, j: float) -> tuple[float, float]:
    """Times in which acceleration rises, 0 without limited jerk, and is constant, from rest to the largest speed [s]."""
    if np.isinf(j):
        return 0.0, float(min(v / a, np.sqrt(length / a)))
    rise = min(a / j, np.sqrt(v / j))
    ramp = rise + v / min(a, j * rise)
    if ramp * v > length:  # the largest speed is not reached
        rise = a / j
        ramp = (rise + np.sqrt(rise**2 + 4 * length / a)) / 2
        if ramp < 2 * rise:  # nor is the largest acceleration
            rise = np.cbrt(length / (2 * j))
            ramp = 2 * rise
    return float(rise), float(ramp - 2 * rise)


def _whole_nanoseconds(seconds: float) -> float:
    """The next multiple of a nanosecond, of a time that rounding made at most 1e-12 s too long, or negative."""
    return max(float(np.ceil(seconds * 1e9 - 1e-3)), 0.0) / 1e9


def straight_ends(path: JointPath, first: int, last: int) -> tuple[Array, Array] | None:
    """Start and goal (n,) of the pieces `first` to `last` - 1 of a path if they lie on a line and never go back; else None."""
    points = path.control[first:last].reshape(-1, path.n)
    start, goal = points[0], points[-1]
    length = float(np.linalg.norm(goal - start))
    if length == 0.0:
        return None
    tangent = (goal - start) / length
    along = (points - start) @ tangent
    off = np.abs(points - start - np.outer(along, tangent)).max()
    return (start, goal) if off <= STRAIGHT * length and (np.diff(along) >= -STRAIGHT * length).all() else None


#: Grid points closer to a mark than this share of the grid spacing are dropped.
BESIDE = 0.4
#: Minimum mean time between grid points that are placed by changes of speed [s]: rounding shows in the jerk of shorter steps.
RAMP_STEP = 2e-4
#: Largest ratio of neighbouring steps in time where the tool's speed is limited.
GRADE = 3.0


def first_grid(curve: ArcLength, count: int, edges: Array, stops: tuple[bool, bool]) -> Array:
    """A grid for the first solve, when no speed is known: even, denser where the path turns, and with l ~ t³ at stops."""
    points = curve.fine(8 * count)
    share = points / curve.length
    even = np.linspace(0.0, 1.0, len(points))
    near = np.cbrt(share) if stops[0] else np.ones_like(share)
    far = np.cbrt(1 - share) if stops[1] else np.ones_like(share)
    ramp = near / (near + far) if all(stops) else (near if stops[0] else 1 - far if stops[1] else share)
    return _thin(curve, points, (even + ramp) / 2, count, edges)


def next_grid(curve: ArcLength, profile: Profile, count: int, edges: Array, *, ramps: float = 0.0) -> Array:
    """A grid that is even in the time of an earlier motion, and denser where the path turns.

    A share `ramps` of the points is placed by changes of speed: a motion at a constant speed has most of its time elsewhere.
    """
    fine = curve.fine(8 * count)
    even = np.linspace(0.0, 1.0, len(fine))
    # l ~ t³ at stops: the cube root is interpolated there
    lengths, times = profile.length, profile.time / profile.time[-1]
    at = np.interp(fine, lengths, times)
    for k, (i, j) in enumerate(((0, 1), (-1, -2))):
        if profile.speed[i] == 0:
            inside = fine < lengths[j] if k == 0 else fine > lengths[j]
            gone = np.abs(fine[inside] - lengths[i]) / abs(lengths[j] - lengths[i])
            at[inside] = times[i] + (times[j] - times[i]) * np.cbrt(gone)
    # at a stop the first or last interval has constant jerk
    ramp = np.linspace(0, 1, 9) ** 3
    begin, end = lengths[1] * ramp, curve.length - (curve.length - lengths[-2]) * ramp
    dense = np.sort(np.concatenate([fine, np.interp(np.linspace(0, 1, 8 * count), times, lengths), begin, end]))
    in_time = 0.3 if ramps else 0.7
    share = np.interp(dense, fine, in_time * at + (1 - in_time) * even)
    if ramps:
        changes = np.abs(np.diff(profile.speed))
        changed = np.append(0.0, np.cumsum(changes))
        shortest = float(changed[-1] / (changes / np.diff(profile.time)).max())  # time that all changes take at least
        ramps = min(ramps, shortest / (RAMP_STEP * count))
        share = (1 - ramps) * share + ramps * np.interp(dense, lengths, changed / changed[-1])
        return _graded(_thin(curve, dense, share, count, edges), fine, at)
    return _thin(curve, dense, share, count, edges)


def _graded(grid: Array, lengths: Array, times: Array) -> Array:
    """The grid with more points beside short steps: a spline that is continued over a much longer step leaves the path there.

    `times` at `lengths` are those of an earlier motion.
    """
    for _ in range(30):
        steps = np.diff(np.interp(grid, lengths, times))
        least = np.minimum(np.append(np.inf, steps[:-1]), np.append(steps[1:], np.inf))
        wide = steps > GRADE * least
        wide[[0, -1]] = False
        if not wide.any():
            break
        k = np.flatnonzero(wide)
        grid = np.insert(grid, k + 1, (grid[k] + grid[k + 1]) / 2)
    return grid


def _thin(curve: ArcLength, points: Array, share: Array, count: int, edges: Array) -> Array:
    """About `count` + 1 lengths, evenly spaced in `share`, which increases along `points`; they include the marks."""
    rising = np.concatenate([[True], np.diff(share) > 0])
    points, share = points[rising], share[rising]
    share = (share - share[0]) / (share[-1] - share[0])
    wanted = np.linspace(0.0, 1.0, count + 1)
    grid = np.interp(wanted, share, points)
    marks = curve.lengths_of(np.union1d(curve.breaks, edges))
    marks = marks[(marks > grid[1]) & (marks < grid[-2])]
    if len(marks):
        at = np.interp(marks, points, share)
        apart = np.concatenate([[True], np.diff(at) > 1e-3 / count])
        marks, at = marks[apart], at[apart]
        beside = np.abs(wanted[:, None] - at).min(axis=1) < BESIDE / count
        beside[[0, 1, -2, -1]] = False
        grid = np.union1d(grid[~beside], marks)
    grid = grid[np.concatenate([[True], np.diff(grid) > 1e-12 * curve.length])]
    grid[0], grid[-1] = 0.0, curve.length
    return np.asarray(grid, dtype=float)


#: Relative margin to the limits that slowing down leaves.
SPARE = 1e-9
#: Maximum number of rounds of tightening, without and with limited jerk, and the slowdown factor at which they end.
ROUNDS, ROUNDS_SMOOTH, CLOSE = 8, 6, 1.002
#: The same for a piece that begins or ends moving, which cannot be slowed down as a whole.
ROUNDS_MOVING = 25
#: Minimum number of grid intervals of a piece with limited jerk.
SMOOTH_LEAST = 40
#: Minimum mean time per grid interval [s]: below it, rounding to nanoseconds would show in the jerk.
SHORTEST_STEP = 2e-5
#: Number of places at which the tool's speed along a path is compared with its mean, and the share of it that is near zero.
TOOL_SAMPLES, LEAST_PACE = 1001, 1e-3
#: Share of the grid points that are placed by changes of speed where the tool's speed is limited.
RAMPS = 0.3
#: When a motion uses less than this share of the jerk limit, a finer grid lets acceleration rise faster.
COARSE = 0.7


@dataclass(frozen=True, kw_only=True, eq=False)
class TimingProblem:
    """Data shared by all pieces of a path."""

    moving: MovingPath
    limits: LimitsAlong
    names: tuple[str, ...]
    torque_model: pin.Model | None
    tool: ToolSpeed | None

    def is_plain(self, a: float, b: float) -> bool:
        """Whether only limits of velocity, acceleration and jerk hold between two s, and they do not change."""
        edges = self.limits.edges
        inside = np.searchsorted(edges, b) > np.searchsorted(edges, a, side="right")
        tool = self.limits.at(np.array([(a + b) / 2])).tool_speed[0]
        return self.torque_model is None and not inside and bool(np.isinf(tool))

    def curve(self, a: float, b: float, *, moving: bool) -> ArcLength:
        """The path from s = a to s = b: along the tool's way where the tool's speed is limited all along and never near zero.

        Then this limit is constant, and no grid is too coarse for it. Given speeds are those of the joints.
        """
        if self.tool is not None and not moving:
            s = np.linspace(a, b, TOOL_SAMPLES)
            path = self.moving.path
            pace = self.tool(path(s), path(s, 1))
            if np.isfinite(self.limits.at(s).tool_speed).all() and pace[1:-1].min() > LEAST_PACE * pace.mean():
                return ArcLength(path, a, b, self.tool)
        return ArcLength(self.moving.path, a, b)

    def dynamics(self, curve: ArcLength, points: Array) -> PathDynamics:
        """The demand rows at grid points of a piece."""
        return path_dynamics(curve, points, self.limits, self.torque_model, self.tool)

    def use(self, trajectory: Trajectory, s: Array) -> Use:
        """Largest ratio of demand to limit per piece of the trajectory, whose samples are at s."""
        return piece_use(*self.bounded(trajectory, s), self.torque_model, self.tool)

    def bounded(self, trajectory: Trajectory, s: Array) -> tuple[Trajectory, Bounds]:
        """A trajectory, whose samples are at s, with the limits of each piece."""
        return trajectory, self.limits.at((s[:-1] + s[1:]) / 2)


@dataclass(frozen=True, kw_only=True, eq=False)
class TimedPiece:
    """The verified motion between two stops, and its duration without losses from discretisation [s]."""

    trajectory: Trajectory
    ideal: float


def stepped_piece(problem: TimingProblem, a: float, b: float, grid: int, start: float, end: float) -> TimedPiece:
    """The motion from s = a to s = b without jerk limits, by toppra. `start` and `end` are speeds [rad/s]; 0: a stop."""
    moving = start > 0 or end > 0
    curve = problem.curve(a, b, moving=moving)
    points = curve.grid(grid, problem.limits.edges)
    asked = problem.dynamics(curve, points)

    def solve(tightening: LimitTightening) -> Profile | None:
        try:
            speed = fastest_speeds(tightening.of(asked), problem.names, problem.moving.given, start, end)
        except (InvalidInputError, PlanningError):
            if not tightening.rounds:
                raise
            return None  # the tightened limits allow no motion
        return SteppedProfile.of(curve, points, speed)

    def failure(use: Use, s: Array) -> Exception:
        worst = max(use, key=lambda kind: float(use[kind].max()))
        k = int(np.argmax(use[worst]))
        remedy = "; a lower start_speed or end_speed may help" if moving else ""
        return PlanningError(
            f"no motion within the limits was found: {worst} stays at {use[worst][k]:.6g} times its limit at "
            f"s = {problem.moving.given(float(s[k])):.4f}{remedy}"
        )

    tightening = LimitTightening(len(points), (start > 0, end > 0))
    return _verify(problem, solve, tightening, ROUNDS, moving=moving, failure=failure)


def straight_piece(problem: TimingProblem, a: float, b: float, ends: tuple[Array, Array]) -> TimedPiece:
    """The motion from rest at s = a to rest at s = b, where the path is straight and `is_plain`; `ends`: q there, (n,) each."""
    motion = StraightMotion.between(*ends, problem.limits.at(np.array([(a + b) / 2])))
    factor = 1.0
    for _ in range(20):
        trajectory = motion.sampled(problem.names, factor)
        slower = slowdown(problem.use(trajectory, np.linspace(a, b, len(trajectory.t))))
        if slower <= 1:
            return TimedPiece(trajectory=trajectory, ideal=motion.duration)
        factor *= slower * (1 + SPARE)
    raise PlanningError(f"no motion within the limits was found on the straight line from s = {problem.moving.given(a):.4f}")


def smooth_piece(problem: TimingProblem, a: float, b: float, grid: int, start: float, end: float) -> TimedPiece:
    """As `stepped_piece`, with jerk limits: solved on two grids, the second made for the motion found on the first."""
    edges = problem.limits.edges
    grid = max(grid, SMOOTH_LEAST)
    moving = start > 0 or end > 0
    curve = problem.curve(a, b, moving=moving)

    def motion(asked: PathDynamics, factors: Array, guess: Array | None = None) -> SquaredSpeed | None:
        s, unit = curve.s((asked.length[:-1] + asked.length[1:]) / 2), asked.speed_unit
        jerk = problem.limits.at(s).jerk / factors[:, None]
        return fastest_motion(JerkProblem(asked, jerk, (start / unit) ** 2, (end / unit) ** 2), guess)

    def check_other_limits() -> None:
        """Raises, with the reason, when no motion is within the limits other than jerk."""
        fastest_speeds(asked, problem.names, problem.moving.given, start, end)

    def failure(*_: object) -> Exception:
        if not moving:
            check_other_limits()
            return PlanningError("no motion within the jerk limits was found")
        name, value = ("start_speed", start) if start > 0 else ("end_speed", end)
        return InvalidInputError(name, value, "a lower speed; no motion within the jerk limits was found with this one")

    points = first_grid(curve, grid, edges, (start == 0, end == 0))
    asked = problem.dynamics(curve, points)
    if moving:  # otherwise the motion that is found shows that there is one
        check_other_limits()
    first = motion(asked, np.ones(len(points) - 1))
    if first is None:
        raise failure()
    profile = SmoothProfile.of(asked, first)
    used = float(jerk_of_pieces(*problem.bounded(*profile.sampled(problem.names))).max())
    finer = 2 * grid if used < COARSE else grid
    count = int(np.clip(profile.time[-1] / SHORTEST_STEP, SMOOTH_LEAST, finer))
    points = next_grid(curve, profile, count, edges, ramps=RAMPS if problem.tool is not None else 0.0)
    asked = problem.dynamics(curve, points)
    guess = np.interp(points, profile.length, profile.speed**2) / asked.speed_unit**2

    def solve(tightening: LimitTightening) -> Profile | None:
        nonlocal guess
        found = motion(tightening.of(asked), tightening.jerk, guess)
        if found is None:
            return None
        guess = found.a
        return SmoothProfile.of(asked, found)

    tightening = LimitTightening(len(points), (start > 0, end > 0))
    return _verify(problem, solve, tightening, ROUNDS_SMOOTH, moving=moving, failure=failure)


def _verify(
    problem: TimingProblem,
    solve: Callable[[LimitTightening], Profile | None],
    tightening: LimitTightening,
    rounds: int,
    *,
    moving: bool,
    failure: Callable[[Use, Array], Exception],
) -> TimedPiece:
    """The fastest motion of all rounds that keeps every limit; without any, raises `failure` of the last use and s.

    A piece that begins and ends at rest is slowed down until it keeps them; one that begins or ends moving is not slowed.
    """
    best: TimedPiece | None = None
    use: Use = {}
    ideal, s = np.inf, np.empty(0)
    for _ in range(1 + (ROUNDS_MOVING if moving else rounds)):
        profile = solve(tightening)
        if profile is None:
            break
        ideal = min(ideal, float(profile.time[-1]))
        trajectory, s = profile.sampled(problem.names)
        use = problem.use(trajectory, s)
        factor = slowdown(use)
        if moving:
            if factor <= 1 + DIGITS:
                return TimedPiece(trajectory=trajectory, ideal=ideal)
        else:
            slowed = _slow_down(problem, profile, factor, trajectory)
            if slowed is not None and (best is None or slowed.duration < best.trajectory.duration):
                best = TimedPiece(trajectory=slowed, ideal=ideal)
            if best is not None and factor <= CLOSE:
                break
        tightening.tighten(use)
    if best is None:
        raise failure(use, s)
    return best


def _slow_down(problem: TimingProblem, profile: Profile, factor: float, trajectory: Trajectory) -> Trajectory | None:
    """The motion slowed down until every limit holds; None when that fails."""
    total = 1.0
    for _ in range(20):
        if factor <= 1:
            return trajectory
        total *= factor * (1 + SPARE)
        trajectory, s = profile.sampled(problem.names, total)
        factor = slowdown(problem.use(trajectory, s))
    return None
