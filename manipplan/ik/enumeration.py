"""All solutions of a closed form for many poses and values of the held joints, compiled."""

import math
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from manipplan.ik.form import PARALLEL, SPHERICAL, ClosedForm
from manipplan.ik.parallel import solve_parallel
from manipplan.ik.spherical import AT_LIMIT, MOST, least_above, lie, row, solve_spherical, wrapped
from manipplan.ik.subproblems import Vector, turn_by, turned, turned_about
from manipplan.ik.swivel import solve_swivel
from manipplan.support.checks import Array
from manipplan.support.compiling.kernels import kernel

#: Number of samples that a block of solutions is sized for.
CHUNK = 8192


def answers(
    form: ClosedForm,
    poses: Array,
    owners: NDArray[np.int64],
    samples: Array,
    lower: Array,
    upper: Array,
    axis: Array | None,
) -> Iterator[tuple[Array, NDArray[np.int64]]]:
    """Blocks of solutions q (k, n) inside the limits, with the sample (k,) of each.

    Joints without limits are in [-π, π]; others are listed at every full turn inside the limits.

    Args:
        form: the arm's closed form.
        poses: (p, 4, 4).
        owners: (s,) pose index of each sample.
        samples: (s, r) values of the held joints, then the swivel, then the rotation about `axis` where it is free.
        lower, upper: (n,) limits [rad or m]; infinite on both sides for continuous joints.
        axis: (3,) tool axis about which the tool is free to rotate; None for a full pose.
    """
    free = np.array(form.free)
    home = np.asarray(np.linalg.inv(form.screws.home), dtype=np.float64)
    axes, points = form.screws.axes.copy(), form.screws.points.copy()
    bounded_lower = np.where(np.isfinite(lower), lower, -np.pi)
    bounded_upper = np.where(np.isfinite(upper), upper, np.pi)
    endless = np.isinf(lower)
    turns = np.where(endless, 0, (bounded_upper - bounded_lower + 2 * AT_LIMIT) // (2 * np.pi))
    most = MOST * int(np.prod(np.maximum(turns[free] + 1, 1)))
    rows = max(4 * most, min(len(samples) * MOST, CHUNK * MOST))
    begin = 0
    while begin < len(samples):
        out, source = np.empty((rows, form.screws.n)), np.empty(rows, dtype=np.int64)
        begin, filled = _fill(
            form.solver,
            axes,
            points,
            np.array(form.held, dtype=np.int64),
            free,
            form.backward,
            form.moves_axes,
            form.meeting,
            form.triple,
            form.screws.slides,
            home,
            poses,
            owners,
            samples,
            axis if axis is not None else np.zeros(3),
            bounded_lower,
            bounded_upper,
            endless,
            begin,
            most,
            out,
            source,
        )
        yield out[:filled], source[:filled]


@kernel
def _shift_left(motion: Array, h: Vector, p: Vector, slides: bool, value: float) -> None:
    """motion <- e^(joint at value) motion."""
    if slides:
        for i in range(3):
            motion[i, 3] += value * h[i]
        return
    turn = turn_by(value)
    for k in range(3):
        v = turned(h, turn, (motion[0, k], motion[1, k], motion[2, k]))
        motion[0, k], motion[1, k], motion[2, k] = v[0], v[1], v[2]
    v = turned_about(h, p, turn, (motion[0, 3], motion[1, 3], motion[2, 3]))
    motion[0, 3], motion[1, 3], motion[2, 3] = v[0], v[1], v[2]


@kernel
def _multiply(a: Array, b: Array, out: Array) -> None:
    """out <- a b, for motions (4, 4)."""
    for i in range(3):
        for j in range(4):
            out[i, j] = a[i, 0] * b[0, j] + a[i, 1] * b[1, j] + a[i, 2] * b[2, j]
        out[i, 3] += a[i, 3]


@kernel
def _copy(source: Array, out: Array) -> None:
    for i in range(source.shape[0]):
        for j in range(source.shape[1]):
            out[i, j] = source[i, j]


@kernel
def _invert(motion: Array) -> None:
    x, y, z = motion[0, 3], motion[1, 3], motion[2, 3]
    for i in range(3):
        for j in range(i):
            motion[i, j], motion[j, i] = motion[j, i], motion[i, j]
    for i in range(3):
        motion[i, 3] = -(motion[i, 0] * x + motion[i, 1] * y + motion[i, 2] * z)


@kernel
def _fill(
    solver: int,
    home_axes: Array,
    home_points: Array,
    held: NDArray[np.int64],
    free: NDArray[np.int64],
    backward: bool,
    moves_axes: bool,
    home_meeting: Array,
    triple: int,
    slides: NDArray[np.bool_],
    home: Array,
    poses: Array,
    owners: NDArray[np.int64],
    samples: Array,
    free_axis: Array,
    lower: Array,
    upper: Array,
    endless: NDArray[np.bool_],
    begin: int,
    most: int,
    out: Array,
    source: NDArray[np.int64],
) -> tuple[int, int]:
    """Solves samples from `begin` on until `out` is nearly full; returns the next sample and the number of filled rows."""
    n, f = len(home_axes), len(free)
    axes, points, meeting = home_axes.copy(), home_points.copy(), home_meeting.copy()
    free_axes, free_points = np.empty((f, 3)), np.empty((f, 3))
    low, high = lower[free], upper[free]
    motion, tool, turn, identity = np.eye(4), np.eye(4), np.eye(4), np.eye(4)
    found, work = np.empty((MOST + 1, f)), np.empty((16, 6))
    sign = -1.0 if backward else 1.0
    any_axis = free_axis[0] != 0 or free_axis[1] != 0 or free_axis[2] != 0
    first, last = free.min(), free.max()
    for k in range(f):
        for i in range(3):
            free_axes[k, i], free_points[k, i] = sign * axes[free[k], i], points[free[k], i]
    kind, crossing, _ = lie(free_axes, free_points)
    filled = 0
    for sample in range(begin, len(samples)):
        if filled + most > len(out):
            return sample, filled
        if any_axis:
            _copy(identity, turn)
            _shift_left(turn, (free_axis[0], free_axis[1], free_axis[2]), (0.0, 0.0, 0.0), False, samples[sample, -1])
            _multiply(poses[owners[sample]], turn, tool)
            _multiply(tool, home, motion)
        else:
            _multiply(poses[owners[sample]], home, motion)
        if moves_axes:
            _copy(home_axes, axes)
            _copy(home_points, points)
            _copy(home_meeting, meeting)
        inside = True
        for k in range(len(held)):
            value = samples[sample, k]
            joint = held[k]
            inside = inside and (endless[joint] or lower[joint] <= value <= upper[joint])
            if joint < first:
                _shift_left(motion, row(axes, joint), row(points, joint), slides[joint], -value)
        if not inside:
            continue
        if backward:
            _invert(motion)
        # with joints held after the first free one: S = A E B = A (E B E⁻¹) E
        for k in range(len(held)):
            joint, value = held[k], samples[sample, k]
            if joint < first:
                continue
            h, p = row(axes, joint), row(points, joint)
            if moves_axes and joint < last:
                by = turn_by(value)
                for j in range(joint + 1, n):
                    shift = (0.0, 0.0, 0.0)
                    if slides[joint]:
                        moved = (points[j, 0] + value * h[0], points[j, 1] + value * h[1], points[j, 2] + value * h[2])
                    else:
                        moved = turned_about(h, p, by, row(points, j))
                        shift = turned(h, by, row(axes, j))
                        axes[j, 0], axes[j, 1], axes[j, 2] = shift[0], shift[1], shift[2]
                    points[j, 0], points[j, 1], points[j, 2] = moved[0], moved[1], moved[2]
                if triple > joint:
                    point = row(meeting, 0)
                    if slides[joint]:
                        point = (point[0] + value * h[0], point[1] + value * h[1], point[2] + value * h[2])
                    else:
                        point = turned_about(h, p, by, point)
                    meeting[0, 0], meeting[0, 1], meeting[0, 2] = point[0], point[1], point[2]
            # S E⁻¹; read backward: S⁻¹ becomes E S⁻¹
            if backward:
                _shift_left(motion, h, p, slides[joint], value)
            else:
                _invert(motion)
                _shift_left(motion, h, p, slides[joint], value)
                _invert(motion)
        if moves_axes:
            for k in range(f):
                for i in range(3):
                    free_axes[k, i], free_points[k, i] = sign * axes[free[k], i], points[free[k], i]
            kind, crossing, _ = lie(free_axes, free_points)
        wrist = row(meeting, 0)
        if solver == SPHERICAL:
            count = solve_spherical(kind, crossing, free_axes, free_points, wrist, motion, low, high, found, work)
        elif solver == PARALLEL:
            count = solve_parallel(free_axes, free_points, wrist, motion, low, high, found)
        else:
            swivel = samples[sample, len(held)]
            shoulder = row(meeting, 1)
            count = solve_swivel(free_axes, free_points, shoulder, wrist, motion, swivel, low, high, found, work)
        for a in range(count):
            # the smallest value of each joint inside its limits, then every further full turn
            before = filled
            for k in range(f):
                if endless[free[k]]:
                    found[a, k] = wrapped(found[a, k])
                else:
                    found[a, k] = min(max(least_above(found[a, k], low[k]), low[k]), high[k])
                out[filled, free[k]] = found[a, k]
            for k in range(len(held)):
                out[filled, held[k]] = samples[sample, k]
            filled += 1
            for k in range(f):
                rows = filled
                extra = found[a, k] + 2 * math.pi
                while extra <= high[k] + AT_LIMIT and not endless[free[k]]:
                    for r in range(before, rows):
                        for j in range(n):
                            out[filled, j] = out[r, j]
                        out[filled, free[k]] = min(extra, high[k])
                        filled += 1
                    extra += 2 * math.pi
            for r in range(before, filled):
                source[r] = sample
    return len(samples), filled
