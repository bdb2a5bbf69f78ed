"""A recorded motion in the robot's joints and units; what cannot be one is named by its row, joint and value.

The smooth motion under a recording's noise: least squares with as many pieces as cross-validation wants. Cubic B-splines over
the share u of a duration: velocity, acceleration and jerk of one are bounded by its control points.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

import numpy as np

from manipplan.paths.joint import JointPath
from manipplan.paths.table import Table
from manipplan.paths.trajectory import JUMP, READERS, TOO_FAST, Trajectory, read_trajectory, unwrapped
from manipplan.robots.limits import NO_DEGREES, JointLimits, TakenToLimit, limits_missed
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, flag
from manipplan.support.errors import InvalidInputError
from manipplan.timing.retime import retime

#: Largest distance outside a joint limit that counts as noise [rad or m].
OUTSIDE = 0.01
#: Multiple of its largest speed at which an arm was driven.
DRIVEN = 1.0
#: How much slower than the limits allow a path is timed: at the limits there is no room for smoother motions.
SLOWER = 1.25
#: Smallest motion of a joint [rad or m].
STILL = 1e-6


def read_motion(
    robot: Robot,
    argument: str,
    given: Trajectory | str | Path,
    *,
    joints: Sequence[str] | None,
    degrees: bool,
    columns: Mapping[str, str] | None,
    fastest: float = TOO_FAST,
) -> Trajectory:
    """A motion, or the file of one, with its columns in the robot's order, in rad and m, without jumps by full turns.

    `joints`, `columns`: as for `Trajectory.from_csv`; `fastest`: as for `unwrapped`. With `degrees` the angles of all revolute
    joints are converted.
    """
    degrees = flag("degrees", degrees)
    entries = ValueNames(argument, given, degrees, robot)
    if columns is not None and entries.csv is None:
        raise InvalidInputError("columns", columns, "None but for a CSV file")
    if isinstance(given, str | Path):
        given = Trajectory.from_csv(given, joints=joints, columns=columns) if entries.csv else read_trajectory(argument, given)
    if not isinstance(given, Trajectory):
        raise InvalidInputError(argument, given, f"a Trajectory, or the path of a trajectory file ({', '.join(READERS)})")
    for name in given.joint_names:
        if name in robot.locked:
            wanted = f"the joints {', '.join(robot.joint_names)} alone; {name} is locked at {robot.locked[name]:g}"
            raise InvalidInputError(f"{argument}.joint_names", name, wanted)
    motion = given.in_order(robot.joint_names)
    if degrees:
        scale = np.where([kind == "prismatic" for kind in robot.joint_types], 1.0, np.pi / 180)
        motion = replace(motion, q=motion.q * scale, qd=motion.qd * scale)

    def place(row: int, joint: int) -> tuple[str, float]:
        return entries.name(row, joint), entries.value(float(motion.q[row, joint]), joint)

    return unwrapped(robot, motion, place, fastest=fastest)


def read_recording(
    robot: Robot, recorded: Trajectory | JointPath | str | Path, *, degrees: bool, columns: Mapping[str, str] | None = None
) -> Trajectory:
    """The recorded motion, its columns in the robot's order; see `improve`."""
    if isinstance(recorded, JointPath):
        if flag("degrees", degrees):
            raise InvalidInputError("degrees", degrees, "False with a JointPath, which is in radians")
        if recorded.n != robot.n:
            raise InvalidInputError(
                "recorded", f"a path of {recorded.n} joints", f"a path of the {robot.n} joints of {robot.name}"
            )
        recorded = retime(recorded, robot).slower(SLOWER)
    motion = read_motion(
        robot, "recorded", recorded, joints=robot.joint_names, degrees=degrees, columns=columns, fastest=DRIVEN
    )
    _check(robot, motion, ValueNames("recorded", recorded, degrees, robot))
    return motion


def noise_beyond_limits(robot: Robot, motion: Trajectory) -> tuple[TakenToLimit, ...]:
    """The joints of a recording that are outside a limit, where they are farthest."""
    outside = robot.limits.outside(motion.q)
    rows = outside.argmax(axis=0)
    return tuple(
        TakenToLimit.of(robot, f"recorded.q[{rows[joint]}, {joint}]", joint, float(motion.q[rows[joint], joint]))
        for joint in np.flatnonzero(outside.max(axis=0) > 0).tolist()
    )


class ValueNames:
    """Names and values of single numbers of a motion, as its user gave them."""

    def __init__(self, argument: str, given: Trajectory | str | Path, degrees: bool, robot: Robot) -> None:
        self.argument, self.robot = argument, robot
        file = Path(given) if isinstance(given, str | Path) else Path()
        self.csv = file if file.suffix.lower() == ".csv" else None
        self.degrees = np.array([degrees and kind != "prismatic" for kind in robot.joint_types])

    def name(self, row: int, joint: int) -> str:
        """Name of a position."""
        name = self.robot.joint_names[joint]
        if self.csv is None:
            return f"{self.argument}.q[{row}, {joint}] ({name})"
        return f"{self.argument}: {self.csv}, row {Table.read(self.csv).rows[row][0]}, {name}"

    def value(self, q: float, joint: int) -> float:
        """A position in the unit of the recording."""
        return float(np.rad2deg(q)) if self.degrees[joint] else float(q)


def _check(robot: Robot, motion: Trajectory, entries: ValueNames) -> None:
    """Raise InvalidInputError for positions that the robot cannot have had, or that do not change."""
    limits, names = robot.limits, robot.joint_names
    outside, allowed = limits.outside(motion.q), max(OUTSIDE, robot.limit_tolerance)
    if (outside > allowed).any():
        row, joint = (int(k) for k in np.argwhere(outside > allowed)[0])
        far = bool((outside > NO_DEGREES).any())
        prismatic = robot.joint_types[joint] == "prismatic"
        unit = "m" if prismatic else "rad"
        from_degrees = np.where([kind == "prismatic" for kind in robot.joint_types], motion.q, np.deg2rad(motion.q))
        hint = ""
        if entries.degrees[joint] and not limits.outside(np.rad2deg(motion.q)).any():
            hint = "; all positions are inside the limits if they are in radians: leave degrees=True (--degrees) out"
        if far and not prismatic and not entries.degrees.any() and not limits.outside(from_degrees).any():
            hint = "; all positions are inside the limits if they are in degrees: say degrees=True (--degrees)"
        value, low, high = (entries.value(each[joint], joint) for each in (motion.q[row], limits.lower, limits.upper))
        missed = limits_missed(low, high, value, "°" if entries.degrees[joint] else unit)
        raise InvalidInputError(entries.name(row, joint), value, f"positions inside the limits {missed}{hint}")
    step = np.abs(np.diff(motion.q, axis=0))
    jumps = (step > JUMP) & (step > TOO_FAST * limits.velocity * np.diff(motion.t)[:, None])
    if jumps.any():
        row, joint = (int(k) for k in np.argwhere(jumps)[0])
        raise InvalidInputError(
            entries.name(row + 1, joint),
            entries.value(motion.q[row + 1, joint], joint),
            f"a position that {names[joint]} reaches at {limits.velocity[joint]:g} per second from "
            f"{entries.value(motion.q[row, joint], joint):g}, {1e3 * float(motion.t[row + 1] - motion.t[row]):.4g} ms before",
        )
    if np.ptp(motion.q, axis=0).max() < STILL:
        raise InvalidInputError("recorded", "a motion in which no joint moves", "a motion")


#: Number of samples per piece at which a spline is fitted to a curve.
FIT_SAMPLES = 4


@dataclass(frozen=True, kw_only=True)
class SplineBasis:
    """The cubic B-splines over [0, 1] with `pieces` pieces of equal width, clamped at both ends."""

    pieces: int

    @property
    def size(self) -> int:
        """Number of control points."""
        return self.pieces + 3

    @cached_property
    def knots(self) -> Array:
        """(size + 4,) knots."""
        return np.concatenate([np.zeros(3), np.linspace(0.0, 1.0, self.pieces + 1), np.ones(3)])

    def slopes(self, order: int) -> Array:
        """(size - order, size): the control points of a derivative, from those of the curve."""
        from scipy.interpolate import BSpline

        if order == 0:
            return np.eye(self.size)
        return np.asarray(BSpline(self.knots, np.eye(self.size), 3).derivative(order).c[: self.size - order])

    def values(self, u: Array, order: int = 0) -> Array:
        """(m, size): the functions, or their derivatives, at u (m,)."""
        from scipy.interpolate import BSpline

        return np.asarray(BSpline(self.knots, np.eye(self.size), 3)(u, nu=order))

    def fit(self, shares: Array, values: Array, ends: "Ends") -> Array:
        """Control points (size, n) of the curve with these ends that is nearest to values (m, n) at parameters u (m,)."""
        from scipy.interpolate import BSpline
        from scipy.sparse.linalg import spsolve

        control = ends.control(self)
        free = np.isnan(control[:, 0])
        design = BSpline.design_matrix(shares, self.knots, 3).tocsc()
        rest = values - design[:, ~free] @ control[~free]
        inner = design[:, free]
        control[free] = spsolve((inner.T @ inner).tocsc(), inner.T @ rest).reshape(-1, values.shape[1])
        return control

    @property
    def shares(self) -> Array:
        """Evenly spaced parameters u for `fit`."""
        return np.linspace(0.0, 1.0, FIT_SAMPLES * self.pieces + 1)

    def trajectory(self, control: Array, duration: float, spacing: float, joint_names: tuple[str, ...]) -> Trajectory:
        """The curve with control points (size, n) in a duration [s], with samples at most `spacing` [s] apart; exact."""
        from scipy.interpolate import BSpline

        parts = max(int(np.ceil(duration / self.pieces / spacing - 1e-6)), 1)
        u = np.linspace(0.0, 1.0, parts * self.pieces + 1)
        curve = BSpline(self.knots, control, 3)
        return Trajectory(t=u * duration, q=curve(u), qd=curve(u, nu=1) / duration, joint_names=joint_names)


@dataclass(frozen=True, kw_only=True, eq=False)
class Ends:
    """Where a motion begins and ends: (n,) configurations, and (n,) slopes per share of the duration; None: at rest."""

    start: Array
    goal: Array
    start_slope: Array | None = None
    goal_slope: Array | None = None

    def control(self, basis: SplineBasis) -> Array:
        """Control points (size, n), nan where they are free. At rest the acceleration is zero, too."""
        control = np.full((basis.size, len(self.start)), np.nan)
        first = 1 / (3 * basis.pieces)  # from the first to the second control point, per slope
        for end, q, slope, inward in ((0, self.start, self.start_slope, 1), (-1, self.goal, self.goal_slope, -1)):
            control[end] = q
            if slope is None:
                control[end + inward] = control[end + 2 * inward] = q
            else:
                control[end + inward] = q + inward * first * slope
        return control


#: Smallest and largest number of pieces, factor from one number to the next, and smallest number of samples per piece.
FEWEST, MOST, FINER, PER_PIECE = 16, 2000, 1.3, 3
#: Widest distance between the samples at which a recording is read, as a share of its duration.
WIDEST = 0.01
#: The smallest number of pieces is taken whose score is at most this multiple of the best.
NEARLY = 1.02
#: Share of the largest speed below which the recording counts as at rest at an end.
AT_REST = 0.05


@dataclass(frozen=True, kw_only=True, eq=False)
class Smooth:
    """A smooth curve with control points (size, n), and the ends of a motion along it."""

    basis: SplineBasis
    control: Array
    ends: Ends

    def finer(self, factor: int) -> "Smooth":
        """The curve with the same ends and `factor` times as many pieces."""
        if factor == 1:
            return self
        basis = SplineBasis(pieces=factor * self.basis.pieces)
        curve = self.basis.values(basis.shares) @ self.control
        return Smooth(basis=basis, control=basis.fit(basis.shares, curve, self.ends), ends=self.ends)


def smooth(motion: Trajectory, limits: JointLimits, enough: float) -> Smooth:
    """The smooth motion under the noise, from the recorded start to the recorded goal; noise beyond a limit is cut off there.

    It is at rest at an end where the recording nearly is. The number of pieces is the smallest that leaves a mean residual of
    at most `enough` [rad or m] or else, nearly, the smallest score RSS / (1 - size / m)² of generalised cross-validation over
    m samples [craven1978].
    """
    from scipy.interpolate import make_lsq_spline

    u, q = _places(motion)
    found, scores = [], []
    count, most = float(FEWEST), min(len(u) / PER_PIECE, 1 / np.diff(u).max(), MOST)
    while count <= max(most, FEWEST):
        basis = SplineBasis(pieces=round(count))
        curve = make_lsq_spline(u, q, basis.knots)
        found.append((basis, np.asarray(curve.c)))
        residual = np.sqrt(np.mean((curve(u) - q) ** 2))
        scores.append(float(residual) / (1 - basis.size / len(u)))
        if residual <= enough:
            break
        count *= FINER
    best = next(k for k, score in enumerate(scores) if score <= NEARLY * min(scores))
    basis, control = found[best]
    slopes = basis.values(np.linspace(0.0, 1.0, 201), 1) @ control
    fast = AT_REST * np.linalg.norm(slopes, axis=1).max()
    first, last = np.clip(motion.q[[0, -1]], limits.lower, limits.upper)
    start, goal = (
        _inside(basis, q, slope, inward, limits) if np.linalg.norm(slope) > fast else None
        for q, slope, inward in ((first, slopes[0], 1), (last, slopes[-1], -1))
    )
    ends = Ends(start=first, goal=last, start_slope=start, goal_slope=goal)
    curve = basis.values(basis.shares) @ control
    return Smooth(basis=basis, control=basis.fit(basis.shares, curve, ends), ends=ends)


def _inside(basis: SplineBasis, q: Array, slope: Array, inward: int, limits: JointLimits) -> Array:
    """A slope at an end q (n,), smaller where its control point would be outside the joint limits."""
    step = inward / (3 * basis.pieces)
    return np.asarray((np.clip(q + step * slope, limits.lower, limits.upper) - q) / step)


def _places(motion: Trajectory) -> tuple[Array, Array]:
    """Shares of the duration (m,) and configurations (m, n): the samples, and some between those that are far apart."""
    u = motion.t / motion.duration
    parts = np.ceil(np.diff(u) / WIDEST - 1e-6).astype(int)
    between = [np.linspace(a, b, k, endpoint=False) for a, b, k in zip(u[:-1], u[1:], parts, strict=True)]
    shares = np.append(np.concatenate(between), 1.0)
    return shares, motion(np.minimum(shares * motion.duration, motion.duration))
