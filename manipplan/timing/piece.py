"""The verified motion along one piece of path, from a stop or a given speed to the next.

It is solved, sampled as a cubic spline, compared with the limits by the spline's exact extremes, and solved again with limits
made stricter where it exceeded them; what is left over is taken away by going slower.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import pinocchio as pin

from manipplan.paths.trajectory import Trajectory
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.timing.arc import ArcLength
from manipplan.timing.barrier import fastest_motion
from manipplan.timing.demands import Demands, demands
from manipplan.timing.easing import Easing, Use, slowdown
from manipplan.timing.grids import first_grid, next_grid
from manipplan.timing.jerk import JerkProblem, SquaredSpeed
from manipplan.timing.profile import Profile, SteppedProfile
from manipplan.timing.segment import LimitsAlong, ToolSpeed
from manipplan.timing.smooth import SmoothProfile
from manipplan.timing.speeds import DIGITS, fastest_speeds
from manipplan.timing.stops import Course
from manipplan.timing.verify import piece_use

#: What the verified trajectory stays below each limit by, relative.
SPARE = 1e-9
#: Limits are made stricter this often, without and with limited jerk, while the motion is off by more than `CLOSE`.
ROUNDS, ROUNDS_SMOOTH, CLOSE = 8, 6, 1.002
#: As often for a piece that begins or ends moving, which cannot be slowed as a whole.
ROUNDS_MOVING = 25
#: Grid intervals of a piece with limited jerk, least.
SMOOTH_LEAST = 40
#: The time a grid interval takes on average [s], least: below it whole nanoseconds would show in the jerk.
SHORTEST_STEP = 2e-5
#: A jerk limit of which no more than this share is used is too high for the grid: a finer one lets acceleration rise faster.
COARSE = 0.7


@dataclass(frozen=True, kw_only=True, eq=False)
class TimingProblem:
    """What every piece of a path shares."""

    course: Course
    limits: LimitsAlong
    names: tuple[str, ...]
    torque_model: pin.Model | None
    tool: ToolSpeed | None

    def demands(self, curve: ArcLength, points: Array) -> Demands:
        """What motion asks of the joints at grid points of a piece."""
        return demands(curve, points, self.limits, self.torque_model, self.tool)

    def use(self, trajectory: Trajectory, s: Array) -> Use:
        """Largest demand over limit on each piece of the trajectory, whose samples are at s."""
        bounds = self.limits.at((s[:-1] + s[1:]) / 2)
        return piece_use(trajectory, bounds, self.torque_model, self.tool)


@dataclass(frozen=True, kw_only=True, eq=False)
class Piece:
    """The verified motion between two stops, and how long it would take had discretisation left nothing over [s]."""

    trajectory: Trajectory
    ideal: float


def stepped_piece(problem: TimingProblem, a: float, b: float, grid: int, start: float, end: float) -> Piece:
    """The motion from s = a to s = b without jerk limits, by toppra. `start` and `end` are speeds [rad/s]; 0: a stop."""
    curve = ArcLength(problem.course.path, a, b)
    points = curve.grid(grid, problem.limits.edges)
    asked = problem.demands(curve, points)
    moving = start > 0 or end > 0

    def solve(easing: Easing) -> Profile | None:
        try:
            speed = fastest_speeds(easing.of(asked), problem.names, problem.course.given, start, end)
        except (InvalidInputError, PlanningError):
            if not easing.rounds:
                raise
            return None  # limits were made too strict
        return SteppedProfile.of(curve, points, speed)

    def failure(use: Use, s: Array) -> Exception:
        worst = max(use, key=lambda kind: float(use[kind].max()))
        k = int(np.argmax(use[worst]))
        remedy = "; a lower start_speed or end_speed may help" if moving else ""
        return PlanningError(
            f"no motion within the limits was found: {worst} stays at {use[worst][k]:.6g} times its limit at "
            f"s = {problem.course.given(float(s[k])):.4f}{remedy}"
        )

    easing = Easing(len(points), (start > 0, end > 0))
    return _verified(problem, solve, easing, ROUNDS, moving=moving, failure=failure)


def smooth_piece(problem: TimingProblem, a: float, b: float, grid: int, start: float, end: float) -> Piece:
    """The same with jerk limits: on two grids, the second made for the motion found on the first."""
    curve = ArcLength(problem.course.path, a, b)
    edges = problem.limits.edges
    grid = max(grid, SMOOTH_LEAST)
    moving = start > 0 or end > 0

    def motion(asked: Demands, factors: Array, guess: Array | None = None) -> SquaredSpeed | None:
        s, unit = curve.s((asked.length[:-1] + asked.length[1:]) / 2), asked.speed_unit
        jerk = problem.limits.at(s).jerk / factors[:, None]
        return fastest_motion(JerkProblem(asked, jerk, (start / unit) ** 2, (end / unit) ** 2), guess)

    def failure(*_: object) -> Exception:
        if not moving:
            return PlanningError("no motion within the jerk limits was found")
        name, value = ("start_speed", start) if start > 0 else ("end_speed", end)
        return InvalidInputError(name, value, "a lower speed: with this one no motion within the jerk limits was found")

    points = first_grid(curve, grid, edges, (start == 0, end == 0))
    asked = problem.demands(curve, points)
    fastest_speeds(asked, problem.names, problem.course.given, start, end)  # raises where nothing is within the limits
    first = motion(asked, np.ones(len(points) - 1))
    if first is None:
        raise failure()
    profile = SmoothProfile.of(asked, first)
    used = float(problem.use(*profile.sampled(problem.names))["jerk"].max())
    finer = 2 * grid if used < COARSE else grid
    points = next_grid(curve, profile, int(np.clip(profile.time[-1] / SHORTEST_STEP, SMOOTH_LEAST, finer)), edges)
    asked = problem.demands(curve, points)
    guess = np.interp(points, profile.length, profile.speed**2) / asked.speed_unit**2

    def solve(easing: Easing) -> Profile | None:
        nonlocal guess
        found = motion(easing.of(asked), easing.jerk, guess)
        if found is None:
            return None
        guess = found.a
        return SmoothProfile.of(asked, found)

    easing = Easing(len(points), (start > 0, end > 0))
    return _verified(problem, solve, easing, ROUNDS_SMOOTH, moving=moving, failure=failure)


def _verified(
    problem: TimingProblem,
    solve: Callable[[Easing], Profile | None],
    easing: Easing,
    rounds: int,
    *,
    moving: bool,
    failure: Callable[[Use, Array], Exception],
) -> Piece:
    """The fastest motion of all rounds that keeps every limit; `failure` of the last one's use and s is raised for none.

    A piece that begins and ends at rest is made slower until it does; one that begins or ends moving has to as it is.
    """
    best: Piece | None = None
    use: Use = {}
    ideal, s = np.inf, np.empty(0)
    for _ in range(1 + (ROUNDS_MOVING if moving else rounds)):
        profile = solve(easing)
        if profile is None:
            break
        ideal = min(ideal, float(profile.time[-1]))
        trajectory, s = profile.sampled(problem.names)
        use = problem.use(trajectory, s)
        factor = slowdown(use)
        if moving:
            if factor <= 1 + DIGITS:
                return Piece(trajectory=trajectory, ideal=ideal)
        else:
            slowed = _slowed(problem, profile, factor, trajectory)
            if slowed is not None and (best is None or slowed.duration < best.trajectory.duration):
                best = Piece(trajectory=slowed, ideal=ideal)
            if best is not None and factor <= CLOSE:
                break
        easing.tighten(use)
    if best is None:
        raise failure(use, s)
    return best


def _slowed(problem: TimingProblem, profile: Profile, factor: float, trajectory: Trajectory) -> Trajectory | None:
    """The motion slowed until every limit holds; None where it does not get there."""
    total = 1.0
    for _ in range(20):
        if factor <= 1:
            return trajectory
        total *= factor * (1 + SPARE)
        trajectory, s = profile.sampled(problem.names, total)
        factor = slowdown(problem.use(trajectory, s))
    return None
