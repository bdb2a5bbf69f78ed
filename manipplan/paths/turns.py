"""Jumps of a full turn between the samples of a motion, where the positions of a joint were reported in (-π, π]."""

import logging
from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from manipplan.paths.trajectory import Trajectory
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError

log = logging.getLogger("manipplan")

#: Largest step between two samples that noise makes [rad or m], and the multiple of a joint's largest speed that no motion has.
JUMP, TOO_FAST = 0.05, 5.0


def unwrapped(
    robot: Robot, motion: Trajectory, describe: Callable[[int, int], tuple[str, float]], *, fastest: float
) -> Trajectory:
    """The motion as it was driven, where continuous joints jump by full turns from one sample to the next.

    A step of more than half a turn is such a jump where the joint cannot move so far in the time between the samples, but can
    without the full turns. Velocities that belong to the jump, as those of a spline through it do, are replaced by those of the
    cubic spline through the positions as driven.

    Args:
        robot: the arm, whose joints are the columns of the motion.
        motion: the samples.
        describe: name and value of a position, by its row and joint, for messages.
        fastest: multiple of its largest speed beyond which a joint cannot move; where it has no such limit, the largest speed
            between the other samples counts.

    Raises InvalidInputError for such a jump of a joint that is not continuous.
    """
    jumps = _full_turns(robot, motion, fastest)
    if not jumps.any():
        return motion
    wrong = np.argwhere((jumps != 0) & ~robot.continuous_joints)
    if len(wrong):
        row, joint = (int(k) for k in wrong[0])
        name, limits = robot.joint_names[joint], robot.limits
        argument, value = describe(row + 1, joint)
        step, dt = (float(each[row + 1] - each[row]) for each in (motion.q[:, joint], motion.t))
        wanted = (
            f"a position that {name} reaches in {1e3 * dt:.4g} ms: it jumps by {step:.6g} rad, about "
            f"{_turns(int(jumps[row, joint]))}, and is not continuous (limits {limits.lower[joint]:.6g} to "
            f"{limits.upper[joint]:.6g} rad). If it was recorded in (-π, π], numpy.unwrap gives its positions as driven"
        )
        raise InvalidInputError(argument, value, wanted)
    q = motion.q.copy()
    q[1:] -= 2 * np.pi * np.cumsum(jumps, axis=0)
    qd = motion.qd.copy()
    for joint in np.flatnonzero(jumps.any(axis=0)).tolist():
        log.info("%s: %d jumps by full turns taken out", robot.joint_names[joint], np.count_nonzero(jumps[:, joint]))
        if _belong_to_jumps(motion, joint, jumps[:, joint]):
            from scipy.interpolate import CubicSpline

            qd[:, joint] = CubicSpline(motion.t, q[:, joint])(motion.t, 1)
    return replace(motion, q=q, qd=qd)


def _full_turns(robot: Robot, motion: Trajectory, fastest: float) -> NDArray[np.int64]:
    """The full turns by which revolute joints jump from each sample to the next (k - 1, n)."""
    step, dt = np.diff(motion.q, axis=0), np.diff(motion.t)[:, None]
    turns = np.round(step / (2 * np.pi))
    turns[:, [kind == "prismatic" for kind in robot.joint_types]] = 0
    fastest_seen = np.where(turns == 0, np.abs(step) / dt, -np.inf).max(axis=0)
    fastest_seen = np.where(np.isneginf(fastest_seen), np.inf, fastest_seen)
    reach = fastest * np.where(np.isfinite(robot.limits.velocity), robot.limits.velocity, fastest_seen) * dt
    rest = np.abs(step - 2 * np.pi * turns)
    is_jump = (np.abs(step) > reach) & (rest <= np.maximum(reach, JUMP))
    return np.where(is_jump, turns, 0).astype(np.int64)


def _belong_to_jumps(motion: Trajectory, joint: int, jumps: NDArray[np.int64]) -> bool:
    """Whether the velocities at some jump differ from the slope without it by more than a quarter of the jump's own.

    Those of a spline differ by nearly all of it, central differences by half of it.
    """
    rows = np.flatnonzero(jumps)
    dt = motion.t[rows + 1] - motion.t[rows]
    given: Array = (motion.qd[rows, joint] + motion.qd[rows + 1, joint]) / 2 * dt
    driven = motion.q[rows + 1, joint] - motion.q[rows, joint] - 2 * np.pi * jumps[rows]
    return bool((np.abs(given - driven) > np.pi / 2 * np.abs(jumps[rows])).any())


def _turns(count: int) -> str:
    return "a full turn" if abs(count) == 1 else f"{abs(count)} full turns"
