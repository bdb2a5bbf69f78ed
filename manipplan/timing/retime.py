"""Fastest motion along a joint path under velocity, acceleration, jerk and torque limits, then verified.

By arc length l the speed is found by toppra, or where jerk is limited by `jerk`; the result is a cubic spline whose exact
extremes are compared with the limits. Where it exceeds them by what discretisation left over, limits are made stricter, and
what is left is taken away by going slower. A path that stands still or turns a corner inside is cut there: the arm stops.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import pinocchio as pin

from manipplan.checks import Array, distinct_names, instance, number, whole_number
from manipplan.errors import InvalidInputError, PlanningError
from manipplan.paths.joint import SHORTEST, JointPath
from manipplan.paths.trajectory import Trajectory, joined
from manipplan.robots.limits import JointLimits
from manipplan.robots.robot import Robot
from manipplan.timing.arc import ArcLength
from manipplan.timing.demands import Demands, demands
from manipplan.timing.jerk import JerkProblem
from manipplan.timing.profile import Profile, constant_steps
from manipplan.timing.segment import LimitsAlong, Segment, ToolSpeed, checked_segments
from manipplan.timing.smooth import SHORTEST_STEP, SmoothProfile, first_grid, next_grid
from manipplan.timing.speeds import DIGITS, fastest_speeds
from manipplan.timing.stops import STANDSTILL, Course, stops
from manipplan.timing.verify import piece_use

#: Where a grid is too coarse for a bend as sharp as a corner, a stop where ‖q'‖ is below this share is tried.
NEAR_STANDSTILL = 0.02
#: What the verified trajectory stays below each limit by, relative.
SPARE = 1e-9
#: Grid points for each polynomial piece, least, up to four times the grid asked for; one alone has the whole grid.
EACH = 40
#: A grid is refined while what it left over slows the whole motion by more than this.
ENOUGH = 1.02
#: Limits are made stricter where the motion exceeded them this often, while it is off by more than `CLOSE`.
ROUNDS, CLOSE = 8, 1.002
ROUNDS_SMOOTH = 6
#: Grid intervals of a piece with limited jerk, least.
SMOOTH_LEAST = 40
#: A jerk limit of which no more than this share is used is too high for the grid: a finer one lets acceleration rise faster.
COARSE = 0.7
#: Limits that make sense lie far inside these [SI units].
LEAST_LIMIT, MOST_LIMIT = 1e-9, 1e12
#: As often for a piece that begins or ends moving, which cannot be slowed as a whole.
ROUNDS_MOVING = 25


def retime(
    path: JointPath,
    limits: JointLimits,
    *,
    joint_names: Sequence[str] | None = None,
    torque_model: pin.Model | None = None,
    grid: int = 300,
    start_speed: float = 0.0,
    end_speed: float = 0.0,
    segments: Sequence[Segment] | None = None,
    robot: Robot | None = None,
) -> Trajectory:
    """Fastest verified trajectory along `path`, from rest to rest unless a speed is given.

    Args:
        path: q(s), a curve in space: its parameter is not time. (What `Trajectory.path` gives starts and ends so slowly
            that timing it anew is slower than it need be.)
        limits: velocity and acceleration count;
            jerk where it is finite: then acceleration is
            continuous, and zero at stops; effort too when `torque_model` is given.
        joint_names: (n,) default q0, q1, ...
        torque_model: Pinocchio model of the arm, whose inverse dynamics limit the motion by `limits.effort`.
        grid: points along the path on which toppra works; more are taken where they make the motion faster.
        start_speed, end_speed: ‖qd‖ at the ends [rad/s or m/s], along the path's tangent.
        segments: parts of the path with tighter limits.
        robot: whose tool is meant where a segment limits its speed.

    Returns:
        A Trajectory whose samples lie on the path and that exceeds none of these limits, by the exact extremes of its
        pieces (torque and speed of the tool: on a dense grid).

    Raises:
        InvalidInputError: the path has no length, the limits do not fit it, a velocity or acceleration limit is
            infinite, or `start_speed` or `end_speed` is more than limits allow: then it says how much they do.
        PlanningError: no motion obeys the limits; says which joint, where and why when it can be known.
    """
    instance("path", path, JointPath)
    instance("limits", limits, JointLimits)
    grid = whole_number("grid", grid, least=50)
    if limits.n != path.n:
        raise InvalidInputError("limits", f"limits of {limits.n} joints", f"limits of the path's {path.n} joints")
    check_timing_limits(limits)
    if torque_model is not None and instance("torque_model", torque_model, pin.Model).nv != path.n:
        raise InvalidInputError(
            "torque_model", f"a model of {torque_model.nv} joints", f"a model of the path's {path.n} joints"
        )
    if robot is not None and instance("robot", robot, Robot).n != path.n:
        raise InvalidInputError("robot", f"an arm of {robot.n} joints", f"an arm of the path's {path.n} joints")
    names = distinct_names("joint_names", joint_names or [f"q{i}" for i in range(path.n)], path.n)
    speeds = (number("start_speed", start_speed, least=0.0), number("end_speed", end_speed, least=0.0))
    parts = checked_segments(segments, limits, robot)
    if path.length < SHORTEST:
        raise InvalidInputError("path", f"length {path.length:g}", f"a path with a length of at least {SHORTEST:g}")
    course = Course(path)
    places = course.here(np.array([[part.begin, part.end] for part in parts]).reshape(-1, 2))
    along = LimitsAlong(limits, parts, places)
    if torque_model is not None:
        _check_statics(path, limits, torque_model, names)
    tool = ToolSpeed(robot) if robot is not None and along.has_tool_speed else None
    task = _Task(course=course, limits=along, names=names, torque_model=torque_model, tool=tool)
    found = []
    for points, standstill in ((grid, STANDSTILL), (4 * grid, STANDSTILL), (grid, NEAR_STANDSTILL)):
        pieces = _pieces(task, stops(course.path, standstill), points, speeds)
        found.append(joined([piece.trajectory for piece in pieces]))
        if found[-1].duration <= ENOUGH * sum(piece.ideal for piece in pieces):
            break
    return min(found, key=lambda each: each.duration)


@dataclass(frozen=True, kw_only=True, eq=False)
class _Task:
    """What every piece of a path shares."""

    course: Course
    limits: LimitsAlong
    names: tuple[str, ...]
    torque_model: pin.Model | None
    tool: ToolSpeed | None


@dataclass(frozen=True, kw_only=True, eq=False)
class _Piece:
    """The verified motion between two stops, and how long it would take had discretisation left nothing over."""

    trajectory: Trajectory
    ideal: float


def _pieces(task: _Task, at: list[float], grid: int, speeds: tuple[float, float]) -> list[_Piece]:
    """The motion between all stops."""
    pieces = []
    for k, (a, b) in enumerate(pairwise(at)):
        start = speeds[0] if k == 0 else 0.0
        end = speeds[1] if k == len(at) - 2 else 0.0
        share = max(20, int(np.ceil(grid * (b - a))))
        if task.limits.has_jerk:
            pieces.append(_smooth_piece(task, a, b, share, start, end))
            continue
        inside = int(np.count_nonzero((task.course.path.breaks > a) & (task.course.path.breaks < b)))
        pieces.append(_piece(task, a, b, max(share, min(EACH * (1 + inside), 4 * grid)), start, end))
    return pieces


def _piece(task: _Task, a: float, b: float, grid: int, start: float, end: float) -> _Piece:
    """One piece without jerk limits: fastest by toppra, stricter where its spline exceeds a limit, slowed by the rest."""
    curve = ArcLength(task.course.path, a, b)
    points = curve.grid(grid, task.limits.edges)
    asked = demands(curve, points, task.limits, task.torque_model, task.tool)
    moving = start > 0 or end > 0
    velocity = np.ones(len(points))
    rows = np.ones(len(points))
    ideal = np.inf
    best: _Piece | None = None
    for k in range(1 + (ROUNDS_MOVING if moving else ROUNDS)):
        try:
            speed = fastest_speeds(asked.eased(velocity, rows) if k else asked, task.names, task.course.given, start, end)
        except (InvalidInputError, PlanningError):
            if k == 0:
                raise
            break
        profile = constant_steps(curve, points, speed)
        ideal = min(ideal, float(profile.time[-1]))
        trajectory, s = profile.sampled(task.names)
        use = _use(task, trajectory, s)
        factor = _factor(use)
        if moving:
            if factor <= 1 + DIGITS:
                return _Piece(trajectory=trajectory, ideal=ideal)
        else:
            slowed = _slowed(task, profile, factor, trajectory)
            if slowed is not None and (best is None or slowed.duration < best.trajectory.duration):
                best = _Piece(trajectory=slowed, ideal=ideal)
            if best is not None and factor <= CLOSE:
                break
        _ease_all(velocity, rows, use, k, (start, end))
    if best is None:
        worst = max(use, key=lambda kind: float(use[kind].max()))
        piece = int(np.argmax(use[worst]))
        raise PlanningError(
            f"no motion within the limits was found: {worst} stays at {use[worst][piece]:.6g} times its limit at "
            f"s = {task.course.given(float(s[piece])):.4f}" + ("; a lower start_speed or end_speed may help" if moving else "")
        )
    return best


def _smooth_piece(task: _Task, a: float, b: float, grid: int, start: float, end: float) -> _Piece:
    """One piece with limited jerk: on two grids, the second made for the motion found on the first."""
    curve = ArcLength(task.course.path, a, b)
    edges = task.limits.edges
    grid = max(grid, SMOOTH_LEAST)
    points = first_grid(curve, grid, edges, (start == 0, end == 0))
    asked = demands(curve, points, task.limits, task.torque_model, task.tool)
    fastest_speeds(asked, task.names, task.course.given, start, end)  # raises where nothing is within the limits
    motion = _jerk_problem(task, asked, np.ones(len(points) - 1), start, end).solved()
    if motion is None:
        raise _jerk_error(start, end)
    profile = SmoothProfile.of(asked, motion)
    used = float(_use(task, *profile.sampled(task.names))["jerk"].max())
    finer = 2 * grid if used < COARSE else grid
    count = int(np.clip(profile.time[-1] / SHORTEST_STEP, SMOOTH_LEAST, finer))
    points = next_grid(curve, profile, count, edges)
    asked = demands(curve, points, task.limits, task.torque_model, task.tool)
    velocity, rows, jerk = np.ones(len(points)), np.ones(len(points)), np.ones(len(points) - 1)
    guess = np.interp(points, profile.length, profile.speed**2) / asked.speed_unit**2
    moving = start > 0 or end > 0
    best: _Piece | None = None
    ideal = np.inf
    for k in range(1 + (ROUNDS_MOVING if moving else ROUNDS_SMOOTH)):
        motion = _jerk_problem(task, asked.eased(velocity, rows) if k else asked, jerk, start, end).solved(guess)
        if motion is None:
            break
        profile = SmoothProfile.of(asked, motion)
        ideal = min(ideal, float(profile.time[-1]))
        trajectory, s = profile.sampled(task.names)
        use = _use(task, trajectory, s)
        factor = _factor(use)
        if moving:
            if factor <= 1 + DIGITS:
                return _Piece(trajectory=trajectory, ideal=ideal)
        else:
            slowed = _slowed(task, profile, factor, trajectory)
            if slowed is not None and (best is None or slowed.duration < best.trajectory.duration):
                best = _Piece(trajectory=slowed, ideal=ideal)
            if best is not None and factor <= CLOSE:
                break
        guess = motion.a
        more = _ease_all(velocity, rows, use, k, (start, end))
        excess = use["jerk"] if len(use["jerk"]) == len(jerk) else np.full(len(jerk), use["jerk"].max())
        jerk *= np.where(excess > 1, excess * (1 + more), 1.0)
    if best is None:
        raise _jerk_error(start, end)
    return best


def _jerk_problem(task: _Task, asked: Demands, factors: Array, start: float, end: float) -> JerkProblem:
    s = asked.curve.s((asked.length[:-1] + asked.length[1:]) / 2)
    unit = asked.speed_unit
    return JerkProblem(asked, task.limits.at(s).jerk / factors[:, None], (start / unit) ** 2, (end / unit) ** 2)


def _jerk_error(start: float, end: float) -> Exception:
    if start > 0 or end > 0:
        name, value = ("start_speed", start) if start > 0 else ("end_speed", end)
        return InvalidInputError(name, value, "a lower speed: with this one no motion within the jerk limits was found")
    return PlanningError("no motion within the jerk limits was found")


def _use(task: _Task, trajectory: Trajectory, s: Array) -> dict[str, Array]:
    bounds = task.limits.at((s[:-1] + s[1:]) / 2)
    return dict(piece_use(trajectory, bounds, task.torque_model, task.tool))


def _factor(use: dict[str, Array]) -> float:
    """How many times slower the motion has to be; 1 when every limit holds."""
    factor = max(float(use["velocity"].max()), float(np.sqrt(use["acceleration"].max())), float(np.cbrt(use["jerk"].max())))
    if "tool speed" in use:
        factor = max(factor, float(use["tool speed"].max()))
    if "torque" in use and (excess := float(use["torque"].max()) - 1) > 0:
        # gravity does not shrink with time, so torque gets a small step each round
        factor = max(factor, 1 + 2 * excess)
    return max(factor, 1.0)


def _ease_all(velocity: Array, rows: Array, use: dict[str, Array], k: int, ends: tuple[float, float]) -> float:
    """Make limits stricter where the motion of round k exceeds them; returns by what margin."""
    more = 1e-7 * 4.0 ** min(k, 7)  # neighbours answer to each other
    for factors, kinds in ((velocity, ("velocity", "tool speed")), (rows, ("acceleration", "torque"))):
        for kind in kinds:
            if kind in use:
                _ease(factors, use[kind], more)
    # a speed that is given stays
    velocity[0] = 1.0 if ends[0] > 0 else velocity[0]
    velocity[-1] = 1.0 if ends[1] > 0 else velocity[-1]
    return more


def _ease(factors: Array, use: Array, more: float) -> None:
    """Raise the factors of grid points beside pieces (one or two a grid interval) that exceed a limit."""
    pieces, over = divmod(len(use), len(factors) - 1)
    # samples at the same nanosecond were left out: then nobody knows which
    excess = use.reshape(-1, pieces).max(axis=1) if pieces and not over else np.full(len(factors) - 1, use.max())
    excess = np.where(excess > 1, excess * (1 + more), 1.0)
    factors[:-1] *= excess
    factors[1:] *= excess


def _slowed(task: _Task, profile: Profile | SmoothProfile, factor: float, trajectory: Trajectory) -> Trajectory | None:
    """The motion slowed until every limit holds; None where it does not get there."""
    total = 1.0
    for _ in range(20):
        if factor <= 1:
            return trajectory
        total *= factor * (1 + SPARE)
        trajectory, s = profile.sampled(task.names, total)
        factor = _factor(_use(task, trajectory, s))
    return None


def check_timing_limits(limits: JointLimits) -> None:
    """Raise InvalidInputError when a velocity or acceleration limit is infinite, for there would be no fastest motion, or a
    limit is so small or so large that its square is lost in rounding.
    """
    for kind in ("velocity", "acceleration"):
        values = getattr(limits, kind)
        if not np.isfinite(values).all():
            raise InvalidInputError(
                f"limits.{kind}", values.tolist(), f"a finite {kind} for each joint; give {kind}= to set it"
            )
        if values.max() > MOST_LIMIT:
            raise InvalidInputError(f"limits.{kind}", values.tolist(), f"at most {MOST_LIMIT:g} for each joint")
    for kind in ("velocity", "acceleration", "jerk"):
        values = getattr(limits, kind)
        if values.min() < LEAST_LIMIT:
            raise InvalidInputError(f"limits.{kind}", values.tolist(), f"at least {LEAST_LIMIT:g} for each joint")


def _check_statics(path: JointPath, limits: JointLimits, model: pin.Model, names: tuple[str, ...]) -> None:
    data = model.createData()
    for s in np.linspace(0.0, 1.0, 201):
        ratio = np.abs(pin.computeGeneralizedGravity(model, data, path(s))) / limits.effort
        joint = int(np.argmax(ratio))
        if ratio[joint] >= 1:
            raise PlanningError(
                f"gravity alone asks {names[joint]} for {ratio[joint]:.3g} times its effort limit at s = {s:.3f}; "
                "raise effort, or choose another path"
            )
