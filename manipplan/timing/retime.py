"""Fastest motion along a joint path under velocity, acceleration and torque limits, through toppra, then verified.

toppra works on the path by arc length l; the result is a cubic spline whose exact extremes are compared with the
limits, and which is slowed down by the little that discretisation left over. A path that stands still or turns a
corner inside is cut there: the arm stops.
"""

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np
import pinocchio as pin

from manipplan.checks import Array, distinct_names, instance, whole_number
from manipplan.errors import InvalidInputError, PlanningError
from manipplan.paths.joint import SHORTEST, JointPath
from manipplan.paths.trajectory import Trajectory, joined
from manipplan.robots.limits import JointLimits
from manipplan.timing.verify import limit_use, torque_use

#: Below this share of the mean speed ‖q'‖ the path stands still; above this angle [rad] it turns a corner.
STANDSTILL = 1e-6
CORNER = 1e-4
#: Where a grid is too coarse for a bend as sharp as a corner, a stop where ‖q'‖ is below this share is tried.
NEAR_STANDSTILL = 0.02
#: What the verified trajectory stays below each limit by, relative.
SPARE = 1e-9
#: A grid point this near to a break, as a share of the mean distance of grid points, is left out in its favour.
BESIDE = 0.1
#: A grid is refined while what it left over slows the whole motion by more than this.
ENOUGH = 1.02


def retime(
    path: JointPath,
    limits: JointLimits,
    *,
    joint_names: Sequence[str] | None = None,
    torque_model: pin.Model | None = None,
    grid: int = 300,
) -> Trajectory:
    """Fastest verified trajectory along `path`, from rest to rest.

    Args:
        path: q(s), a curve in space: its parameter is not time. (What `Trajectory.path` gives starts and ends so slowly
            that timing it anew is slower than it need be.)
        limits: velocity and acceleration count; effort too when `torque_model` is given. Jerk is not limited.
        joint_names: (n,) default q0, q1, ...
        torque_model: Pinocchio model of the arm, whose inverse dynamics limit the motion by `limits.effort`.
        grid: points along the path on which toppra works; more are taken where they make the motion faster.

    Returns:
        A Trajectory whose samples lie on the path and that exceeds none of these limits, by the exact extremes of its
        pieces (torque: on a dense grid).

    Raises:
        InvalidInputError: the path has no length, the limits do not fit it, or a velocity or acceleration limit is
            infinite.
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
    names = distinct_names("joint_names", joint_names or [f"q{i}" for i in range(path.n)], path.n)
    if path.length < SHORTEST:
        raise InvalidInputError("path", f"length {path.length:g}", f"a path with a length of at least {SHORTEST:g}")
    if torque_model is not None:
        _check_statics(path, limits, torque_model, names)
    path = _without_standstills(path)
    found = []
    for points, standstill in ((grid, STANDSTILL), (4 * grid, STANDSTILL), (grid, NEAR_STANDSTILL)):
        trajectory = _timed(path, _stops(path, standstill), limits, names, torque_model, points)
        found.append(_slowed_to_limits(trajectory, limits, torque_model))
        if found[-1].duration <= ENOUGH * trajectory.duration:
            break
    return min(found, key=lambda each: each.duration)


def _timed(
    path: JointPath, stops: list[float], limits: JointLimits, names: tuple[str, ...], torque_model: pin.Model | None, grid: int
) -> Trajectory:
    """toppra's motion between all stops, before it is compared with the limits."""
    parts = [
        _retime_piece(path, a, b, limits, names, torque_model, max(20, int(np.ceil(grid * (b - a)))))
        for a, b in pairwise(stops)
    ]
    return joined(parts)


def check_timing_limits(limits: JointLimits) -> None:
    """Raise InvalidInputError when a velocity or acceleration limit is infinite: there would be no fastest motion."""
    for kind in ("velocity", "acceleration"):
        values = getattr(limits, kind)
        if not np.isfinite(values).all():
            raise InvalidInputError(
                f"limits.{kind}", values.tolist(), f"a finite {kind} for each joint; give {kind}= to set it"
            )


def _slowed_to_limits(trajectory: Trajectory, limits: JointLimits, torque_model: pin.Model | None) -> Trajectory:
    for _ in range(20):
        use = limit_use(trajectory, limits)
        factor = max(use["velocity"].ratio, np.sqrt(use["acceleration"].ratio))
        if torque_model is not None:
            # gravity does not shrink with time, so torque gets a small step each round
            excess = torque_use(trajectory, torque_model, limits.effort).ratio - 1
            factor = max(factor, 1 + 2 * excess if excess > 0 else 0.0)
        if factor <= 1:
            return trajectory
        trajectory = trajectory.slower(factor * (1 + SPARE))
    raise PlanningError(f"the trajectory still exceeds a limit by a factor of {factor:g} after slowing it down")


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


def _without_standstills(path: JointPath) -> JointPath:
    """The path without pieces on which nothing moves."""
    moving = np.abs(path.control - path.control[:, :1]).max(axis=(1, 2)) > 1e-12
    if moving.all():
        return path
    widths = np.diff(path.breaks)[moving]
    breaks = np.concatenate([[0.0], np.cumsum(widths) / widths.sum()])
    breaks[-1] = 1.0
    return JointPath(breaks=breaks, control=path.control[moving])


def _stops(path: JointPath, standstill: float) -> list[float]:
    """Parameters at which the arm must stop: the ends, corners between pieces, and points where q' vanishes."""
    stops = [0.0]
    for s, before, after in zip(path.breaks[1:-1], path.control[:-1], path.control[1:], strict=True):
        arriving, leaving = before[-1] - before[-2], after[1] - after[0]
        cosine = arriving @ leaving / max(np.linalg.norm(arriving) * np.linalg.norm(leaving), 1e-300)
        if cosine < np.cos(CORNER):
            stops.append(float(s))
    s = np.linspace(0.0, 1.0, 2001)
    speed = np.linalg.norm(path(s, 1), axis=1)
    mean = speed.mean()
    for k in np.flatnonzero((speed[1:-1] <= speed[:-2]) & (speed[1:-1] < speed[2:]) & (speed[1:-1] < 0.05 * mean)) + 1:
        low, high = s[k - 1], s[k + 1]
        for _ in range(60):
            thirds = low + (high - low) * np.array([1 / 3, 2 / 3])
            left, right = np.linalg.norm(path(thirds, 1), axis=1)
            low, high = (low, thirds[1]) if left < right else (thirds[0], high)
        middle = (low + high) / 2
        if np.linalg.norm(path(middle, 1)) < standstill * mean:
            stops.append(float(middle))
    stops.sort()
    apart = [s for k, s in enumerate(stops) if k == 0 or (s - stops[k - 1] > 1e-9 and s < 1 - 1e-9)]
    return [*apart, 1.0]


class _ByArcLength:
    """The path between two stops as q(l), l its arc length: what toppra takes as a geometric path."""

    def __init__(self, path: JointPath, a: float, b: float) -> None:
        from scipy.interpolate import CubicSpline

        self.path = path
        nodes_along = max(1200, 12 * len(path.control))
        # dense near the ends, where a path may start from q' = 0
        s = a + (b - a) * (1 - np.cos(np.linspace(0.0, np.pi, nodes_along + 1))) / 2
        nodes, weights = np.polynomial.legendre.leggauss(6)
        half = np.diff(s) / 2
        inside = (s[:-1] + s[1:])[:, None] / 2 + half[:, None] * nodes
        length = np.concatenate([[0.0], np.cumsum(half * (np.linalg.norm(path(inside, 1), axis=2) @ weights))])
        self.length = float(length[-1])
        rises = np.concatenate([[True], np.diff(length) > 1e-14 * self.length])
        rises[-1] = True
        self._at = length[rises]
        self._s = CubicSpline(self._at, s[rises])
        self._range = (a, b)
        # directions are taken a little inside, since q' may vanish at the ends
        margin = 1e-6 * (b - a)
        self._inside = (a + margin, b - margin)

    def grid(self, count: int) -> Array:
        """Lengths (count + 1,) from 0 to the end: evenly spaced, and twice as dense where the path turns on average."""
        s = np.linspace(*self._inside, max(4000, 10 * count))
        tangent = self.path(s, 1)
        tangent /= np.maximum(np.linalg.norm(tangent, axis=1, keepdims=True), 1e-300)
        turned = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(tangent, axis=0), axis=1))])
        length = np.interp(s, self._s(self._at), self._at)
        share = length / self.length + turned / max(turned[-1], 0.1)
        points = np.asarray(np.interp(np.linspace(share[0], share[-1], count + 1), share, length), dtype=float)
        points[0], points[-1] = 0.0, self.length
        return points

    def s(self, length: Array) -> Array:
        return np.asarray(np.clip(self._s(length), *self._range))

    def tangent(self, length: Array) -> Array:
        derivative = self.path(np.clip(self.s(length), *self._inside), 1)
        norm = np.linalg.norm(derivative, axis=-1, keepdims=True)
        return np.asarray(derivative / np.maximum(norm, 1e-300))

    def curvature(self, length: Array) -> Array:
        """d²q/dl² = (q'' - t (t·q'')) / ‖q'‖² with the unit tangent t."""
        s = np.clip(self.s(length), *self._inside)
        first, second = self.path(s, 1), self.path(s, 2)
        norm = np.maximum(np.linalg.norm(first, axis=-1, keepdims=True), 1e-300)
        tangent = first / norm
        along = (tangent * second).sum(axis=-1, keepdims=True)
        return np.asarray((second - along * tangent) / norm**2)


def _retime_piece(
    path: JointPath, a: float, b: float, limits: JointLimits, names: tuple[str, ...], torque_model: pin.Model | None, grid: int
) -> Trajectory:
    curve = _ByArcLength(path, a, b)
    # the grid holds every end of a polynomial piece, where the curvature may jump
    breaks = path.breaks[(path.breaks > a) & (path.breaks < b)]
    at_breaks = np.interp(breaks, curve.s(np.linspace(0, curve.length, 4001)), np.linspace(0, curve.length, 4001))
    points = curve.grid(grid)
    if len(at_breaks):  # points right beside one of these would be passed in less time than samples resolve
        beside = np.abs(points[:, None] - at_breaks).min(axis=1) < BESIDE * curve.length / grid
        beside[[0, -1]] = False
        points = np.union1d(points[~beside], at_breaks)
    points = points[np.concatenate([[True], np.diff(points) > 1e-7 * curve.length])]
    points[-1] = curve.length
    speed = _speeds(curve, points, limits, torque_model, (a, b))
    return _sampled(curve, points, speed, names)


def _speeds(
    curve: _ByArcLength, points: Array, limits: JointLimits, torque_model: pin.Model | None, interval: tuple[float, float]
) -> Array:
    """Speed dl/dt at each grid point, by toppra."""
    import toppra
    from toppra.interpolator import AbstractGeometricPath

    class Geometric(AbstractGeometricPath):  # type: ignore[misc]  # toppra has no stubs
        def __call__(self, length: Any, order: int = 0) -> Array:
            length = np.asarray(length, dtype=float)
            if order == 0:
                return curve.path(curve.s(length))
            return curve.tangent(length) if order == 1 else curve.curvature(length)

        @property
        def dof(self) -> int:
            return curve.path.n

        @property
        def path_interval(self) -> Array:
            return np.array([0.0, curve.length])

        @property
        def waypoints(self) -> None:
            return None

    scheme = toppra.constraint.DiscretizationType.Interpolation
    velocity = np.column_stack([-limits.velocity, limits.velocity])
    acceleration = np.column_stack([-limits.acceleration, limits.acceleration])
    constraints: list[Any] = [
        toppra.constraint.JointVelocityConstraint(velocity),
        toppra.constraint.JointAccelerationConstraint(acceleration, discretization_scheme=scheme),
    ]
    if torque_model is not None:
        data = torque_model.createData()
        effort = np.minimum(limits.effort, 1e9)
        constraints.append(
            toppra.constraint.JointTorqueConstraint(
                lambda q, qd, qdd: pin.rnea(torque_model, data, q, qd, qdd),
                np.column_stack([-effort, effort]),
                np.zeros(curve.path.n),
                discretization_scheme=scheme,
            )
        )
    algorithm = toppra.algorithm.TOPPRA(
        constraints, Geometric(), gridpoints=points, solver_wrapper="seidel", parametrizer="ParametrizeConstAccel"
    )
    _, speed, _ = algorithm.compute_parameterization(0.0, 0.0)
    if speed is None or not np.isfinite(speed).all():
        raise PlanningError(
            f"no motion along the path from s = {interval[0]:.4f} to {interval[1]:.4f} obeys velocity, acceleration"
            f"{' and torque' if torque_model is not None else ''} limits (toppra failed)"
        )
    return np.asarray(np.maximum(speed, 0.0), dtype=float)


def _sampled(curve: _ByArcLength, points: Array, speed: Array, names: tuple[str, ...]) -> Trajectory:
    """The cubic trajectory through two samples a grid interval, on which dl/dt changes at a constant rate."""
    steps = np.diff(points)
    mean = (speed[:-1] + speed[1:]) / 2
    if (mean <= 0).any():
        raise PlanningError("toppra returned a motion that stands still inside the path")
    duration = steps / mean
    rate = np.diff(speed) / duration
    half = duration / 2
    between = points[:-1] + speed[:-1] * half + rate * half**2 / 2
    length = np.insert(points, np.arange(1, len(points)), between)
    pace = np.insert(speed, np.arange(1, len(speed)), speed[:-1] + rate * half)
    times = np.concatenate([[0.0], np.cumsum(np.repeat(half, 2))])
    length = np.clip(length, 0.0, curve.length)
    q = curve.path(curve.s(length))
    qd = curve.tangent(length) * pace[:, None]
    return Trajectory(t=np.round(times, 9), q=q, qd=qd, joint_names=names)
