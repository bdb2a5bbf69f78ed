"""retime: the fastest motion along a joint path under velocity, acceleration, jerk and torque limits, verified.

The path is split where it stands still or turns a corner, since the arm has to stop there; `piece` times each part.
"""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import pinocchio as pin

from manipplan.paths.joint import JointPath
from manipplan.paths.trajectory import Trajectory, joined
from manipplan.robots.limits import JointLimits
from manipplan.robots.robot import Robot
from manipplan.support.checks import COINCIDENT, distinct_names, flag, instance, number, whole_number
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.timing.piece import TimedPiece, TimingProblem, smooth_piece, stepped_piece, straight_ends, straight_piece
from manipplan.timing.stops import STANDSTILL, LimitsAlong, MovingPath, Segment, ToolSpeed, check_segments, stops

#: Where a grid is too coarse for a bend as sharp as a corner, a stop is tried where ‖q'‖ is below this share of its mean.
NEAR_STANDSTILL = 0.02
#: Minimum number of grid points per polynomial piece, up to 4 `grid` in total; a single piece gets the whole grid.
EACH = 40
#: Maximum number of grid points.
MOST_GRID = 100_000
#: A grid is refined when discretisation makes the whole motion slower by more than this factor.
CLOSE_TO_IDEAL = 1.02
#: Smallest and largest accepted limits; realistic ones lie far inside [SI units].
LEAST_LIMIT, MOST_LIMIT = 1e-9, 1e12


def retime(
    path: JointPath,
    robot: Robot,
    *,
    limits: JointLimits | None = None,
    torque: bool = False,
    segments: Sequence[Segment] = (),
    start_speed: float = 0.0,
    end_speed: float = 0.0,
    grid: int = 300,
) -> Trajectory:
    """Find the fastest motion of a robot along `path` within its limits, and verify it.

    The limits are those of velocity, acceleration, jerk and torque. The path is taken as it is, also outside the position
    limits or in collision: `check` judges the motion. It goes from rest to rest unless a speed is given. The arm stops where
    the path turns a corner or stands still.

    Args:
        path: the curve q(s), whose parameter is not time. `Trajectory.path` starts and ends so slowly that timing it again
            gives a slower motion than necessary.
        robot: the arm.
        limits: limits instead of the robot's. Velocity and acceleration have to be finite. If a jerk limit is finite,
            acceleration is continuous, and zero at stops.
        torque: keep the joints' effort limits as well, by inverse dynamics.
        segments: parts of the path with tighter limits.
        start_speed, end_speed: ‖qd‖ along the path at its ends [rad/s or m/s].
        grid: number of points along the path, at least 50; more are used where they make the motion faster.

    Returns:
        A Trajectory whose samples lie on the path and that exceeds no limit. Velocity, acceleration and jerk are checked at
        their exact extremes, torque and tool speed on a dense grid.

    Raises:
        InvalidInputError: the path has no length, the limits do not fit it, a velocity or acceleration limit is infinite, or
            limits do not allow `start_speed` or `end_speed`; the message gives the allowed speed if it is known.
        PlanningError: no motion is within the limits; the message names the joint, s and limit if they are known.
    """
    instance("path", path, JointPath)
    if instance("robot", robot, Robot).n != path.n:
        raise InvalidInputError("robot", f"an arm of {robot.n} joints", f"an arm of the path's {path.n} joints")
    limits = robot.limits if limits is None else instance("limits", limits, JointLimits)
    if limits.n != path.n:
        raise InvalidInputError("limits", f"limits of {limits.n} joints", f"limits of the path's {path.n} joints")
    check_timing_limits(limits)
    torque_model = robot.model if flag("torque", torque) else None
    grid = whole_number("grid", grid, least=50, most=MOST_GRID)
    names = distinct_names("robot.joint_names", robot.joint_names, robot.n)  # a file of the trajectory holds them
    speeds = (number("start_speed", start_speed, least=0.0), number("end_speed", end_speed, least=0.0))
    parts = check_segments(segments, limits)
    if path.length < COINCIDENT:
        raise InvalidInputError("path", f"length {path.length:g}", f"a path with a length of at least {COINCIDENT:g}")
    moving = MovingPath(path)
    places = moving.here(np.array([[part.begin, part.end] for part in parts]).reshape(-1, 2))
    along = LimitsAlong(limits, parts, places)
    if torque_model is not None:
        _check_statics(path, limits, torque_model, names)
    tool = ToolSpeed(robot) if along.has_tool_speed else None
    problem = TimingProblem(moving=moving, limits=along, names=names, torque_model=torque_model, tool=tool)
    found = []
    for points, standstill in ((grid, STANDSTILL), (4 * grid, STANDSTILL), (grid, NEAR_STANDSTILL)):
        pieces = _pieces(problem, stops(moving.path, standstill), points, speeds)
        found.append(joined([piece.trajectory for piece in pieces]))
        if found[-1].duration <= CLOSE_TO_IDEAL * sum(piece.ideal for piece in pieces):
            break
    return min(found, key=lambda each: each.duration)


def _pieces(problem: TimingProblem, at: list[float], grid: int, speeds: tuple[float, float]) -> list[TimedPiece]:
    """The motions between all stops."""
    pieces = []
    path = problem.moving.path
    for k, (a, b) in enumerate(pairwise(at)):
        start = speeds[0] if k == 0 else 0.0
        end = speeds[1] if k == len(at) - 2 else 0.0
        first, last = np.searchsorted(path.breaks, (a, b))
        if start == end == 0 and problem.is_plain(a, b) and path.breaks[first] == a and path.breaks[last] == b:
            ends = straight_ends(path, int(first), int(last))
            if ends is not None:
                pieces.append(straight_piece(problem, a, b, ends))
                continue
        share = max(20, int(np.ceil(grid * (b - a))))
        if problem.limits.has_jerk:
            pieces.append(smooth_piece(problem, a, b, share, start, end))
            continue
        pieces.append(stepped_piece(problem, a, b, max(share, min(EACH * (last - first), 4 * grid)), start, end))
    return pieces


def check_timing_limits(limits: JointLimits) -> None:
    """Raise InvalidInputError for an infinite velocity or acceleration limit, as no motion is then the fastest, or a limit so
    small or so large that its square is lost in rounding.
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
                f"gravity alone loads {names[joint]} with {ratio[joint]:.3g} times its effort limit at s = {s:.3f}; "
                "raise effort, or choose another path"
            )
