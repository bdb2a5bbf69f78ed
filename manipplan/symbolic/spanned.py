"""The task of a robot where the user names none: the motions of its tool that its joints can make."""

from typing import TYPE_CHECKING

import numpy as np
import pinocchio as pin

from manipplan.robots.model_tree import frame_index
from manipplan.support.checks import Array
from manipplan.support.memo import once_per_owner
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


@once_per_owner
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
    samples = _jacobians(robot, robot.tool)
    for frame in ("world", "tool"):
        rows = _spanned(samples[frame][:, : usual.rows])
        if rows is not None:
            name = f"{usual.name} in {len(rows)} direction{'s' * (len(rows) > 1)}"
            padded = np.hstack([rows, np.zeros((len(rows), 6 - usual.rows))])
            return Task.custom(padded, frame=frame, length=usual.length, name=name)
    return usual


@once_per_owner
def is_always_singular(robot: "Robot", task: Task) -> bool:
    """Whether the Jacobian of a task has dependent rows in every configuration of the arm of some tool."""
    world, tool = task.matrices
    for each in robot.tools:
        samples = _jacobians(robot, each)
        rows = np.concatenate([world @ samples["world"], tool @ samples["tool"]], axis=1)
        if max(map(_rank, rows)) < task.rows:
            return True
    return False


def _jacobians(robot: "Robot", tool: str) -> dict[str, Array]:
    """Jacobians (SAMPLES, 6, k) of a tool by the k joints that move it, along the axes of the world and of the tool."""
    model, joints = robot.model, list(robot.joints_of(tool))
    data, frame = model.createData(), frame_index(model, tool)
    q = robot.random_configuration(np.random.default_rng(0), size=SAMPLES)
    along = {"world": pin.ReferenceFrame.LOCAL_WORLD_ALIGNED, "tool": pin.ReferenceFrame.LOCAL}
    return {
        name: np.array([_columns(pin.computeFrameJacobian(model, data, each, frame, axes), joints) for each in q])
        for name, axes in along.items()
    }


def _columns(jacobian: Array, joints: list[int]) -> Array:
    """Some columns of a Jacobian (6, n); Pinocchio returns that of one joint as (6,)."""
    return np.asarray(jacobian.reshape(6, -1)[:, joints])


def _spanned(samples: Array) -> Array | None:
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
