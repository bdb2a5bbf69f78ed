"""The task of a robot where the user names none: the motions of its tool that its joints can make."""

from typing import TYPE_CHECKING

import casadi as ca
import numpy as np

from manipplan.support.checks import Array
from manipplan.support.memo import once_per_source
from manipplan.symbolic.backends import chain_of
from manipplan.symbolic.motion import task_rows
from manipplan.symbolic.task import Task

if TYPE_CHECKING:
    from manipplan.robots.robot import Robot

#: Number of random configurations at which Jacobians are compared, with a fixed seed.
SAMPLES = 24
#: Share of the largest singular value below which one counts as zero, and the least largest one [m or 1].
ZERO, SMALLEST = 1e-9, 1e-3


def usual_task(robot: "Robot") -> Task:
    """Task.planar() for a planar arm, Task.pose() from six joints on (per tool), otherwise Task.position()."""
    if robot.planar:
        return Task.planar()
    return Task.pose() if min(len(robot.joints_of(tool)) for tool in robot.tools) >= 6 else Task.position()


@once_per_source
def default_task(robot: "Robot") -> Task:
    """`Robot.default_task`: the usual task, or its part that the joints span.

    Where the rows of the usual task's Jacobian are dependent in every configuration, as always with fewer joints than rows, the
    task is cut: to the directions in which the joints can move the tool, if these are as many as the rank, and fixed in the
    world or in the tool. A gantry's are x and y of the world, those of a pan-tilt head two axes of the tool. Where no fixed
    rows have that property, as for a positioner with its tool on the last axis, the usual task remains, and its manipulability
    is identically zero.
    """
    usual = usual_task(robot)
    if robot.planar or not is_always_singular(robot, usual) or len(robot.tools) > 1:
        return usual
    for frame in ("world", "tool"):
        rows = _find_span(_jacobians(robot, Task.custom(np.eye(6)[: usual.rows], frame=frame)))
        if rows is not None:
            name = f"{usual.name} in {len(rows)} direction{'s' * (len(rows) > 1)}"
            padded = np.hstack([rows, np.zeros((len(rows), 6 - usual.rows))])
            return Task.custom(padded, frame=frame, length=usual.length, name=name)
    return usual


@once_per_source
def is_always_singular(robot: "Robot", task: Task) -> bool:
    """Whether the Jacobian of a task has dependent rows in every configuration of the arm of some tool."""
    for each in robot.tools:
        arm = robot.arm(each)
        if max(map(_rank, _jacobians(arm, task))) < task.rows:
            return True
    return False


def _jacobians(robot: "Robot", task: Task) -> Array:
    """Jacobians (SAMPLES, m, n) of the rows of a task at random configurations."""
    chain = chain_of(robot, "auto")
    rows = ca.Function("rows", [chain.q], [ca.densify(task_rows(chain, task)[0])])
    q = robot.random_configuration(np.random.default_rng(0), size=SAMPLES)
    return np.array([np.asarray(rows(each)).reshape(task.rows, robot.n) for each in q])


def _find_span(samples: Array) -> Array | None:
    """Orthonormal rows (r, m) of the space of all columns of Jacobians (k, m, n) of rank r; None if it is larger, or r is 0."""
    rank = max(map(_rank, samples))
    columns = np.concatenate(list(samples), axis=1)
    if rank == 0 or _rank(columns) > rank:
        return None
    basis = np.linalg.svd(columns)[0][:, :rank].T
    projector = basis.T @ basis
    units = np.eye(len(projector))[np.diag(projector) > 0.5]
    if np.allclose(projector, np.diag(np.round(np.diag(projector))), atol=1e-9):
        return np.asarray(units)
    return np.asarray(basis * np.sign(basis[np.arange(rank), np.abs(basis).argmax(axis=1)])[:, None])


def _rank(matrix: Array) -> int:
    """Number of singular values that are not zero."""
    values = np.linalg.svd(matrix, compute_uv=False)
    return int((values > ZERO * max(float(values[0]), SMALLEST)).sum())
