"""All inverse kinematics solutions of a pose: every configuration that reaches it, for sampled redundancy parameters."""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, instance, pose_matrix
from manipplan.support.display import Pictured, one_line
from manipplan.symbolic.task import Task


class Completeness(StrEnum):
    """How complete a set of solutions is."""

    EXACT = "exact"
    """All solutions for each given value of the parameters; one of a continuum, at a singularity."""
    TO_RESOLUTION = "to-resolution"
    """All solutions for each value on a grid of parameters, with more between the grid points; or all for given values, except
    solutions near a singularity of an arm whose description rounds its axes."""
    STATISTICAL = "statistical"
    """Found from many random starts; `SolutionSet.missing` estimates the share that is not found."""


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class SolutionSet(Pictured):
    """Configurations that reach a pose, or one of several; each verified by forward kinematics to 1e-10.

    Attributes:
        q: (k, n) [rad or m], inside the position limits.
        pose_index: (k,) index of the pose that each row reaches.
        parameters: (k, r) values of the redundancy parameters of each row.
        parameter_names: (r,) held joints, then "swivel", then those of the free motion.
        residual: (k,) largest entry of the pose error [m or 1].
        complete: "exact", "to-resolution" or "statistical"; see `Completeness`.
        method: "spherical", "parallel", "swivel" or "newton".
        missing: estimated share of solutions that is not found, 0 to 1; 0 for closed forms.
    """

    q: Array
    pose_index: NDArray[np.int64]
    parameters: Array
    parameter_names: tuple[str, ...]
    residual: Array
    complete: Completeness
    method: str
    missing: float = 0.0

    def __len__(self) -> int:
        return len(self.q)

    def for_pose(self, pose: int) -> Array:
        """The rows of q that reach the pose with this index, (k, n)."""
        return np.asarray(self.q[self.pose_index == pose])

    def __str__(self) -> str:
        return f"{len(self)} solutions ({self.method}, {self.complete.value})"


def inverse_kinematics(
    robot: Robot,
    pose: Any,
    parameters: ArrayLike | None = None,
    *,
    task: Task | None = None,
    samples: int | Sequence[int] | None = None,
    held: Sequence[str] | None = None,
    method: str = "auto",
    turns: bool = True,
    seed: int = 0,
) -> SolutionSet:
    """Every configuration that reaches a pose.

    A redundant arm has finitely many solutions once some joints are held or, with a spherical shoulder and wrist, once the
    swivel angle of the elbow is fixed: these values are the parameters. A joint angle that fits its limits at several full
    turns is listed at each of them; joints without limits are in [-π, π].

    Closed forms [pieper1968], built from Paden-Kahan subproblems [murray1994], cover every arm with three joint axes that meet
    at the wrist or the shoulder, and arms with three parallel axes and two that meet (UR). Others are solved by Newton steps
    from random starts.

    Args:
        robot: the arm.
        pose: (4, 4) or pin.SE3 of the tool, or several, (p, 4, 4).
        parameters: (r,), or (s, r) to be tried for each pose: held joints [rad or m] in the order of the arm, then the
            swivel, then the motions that the task leaves free: shifts [m], rotation about an axis [rad], or azimuth, tilt and
            tool rotation (Euler angles ZYZ) of a free orientation. Default: a grid.
        task: Task.pose(), the default; Task.pointing(axis), whose rotation about the axis is free; or any other whose rows fix
            a set of poses, such as Task.position(). For planar arms Task.planar(), their default: the position alone.
        samples: number of grid points, one number or one per parameter.
        held: names of the joints to hold instead of those that the arm's closed form prefers.
        method: "closed-form", "newton", or "auto": the closed form where there is one.
        turns: False lists only one of the configurations that differ by full turns, the one with the smallest angles.
        seed: seed of the random starts.

    Raises:
        InvalidInputError: a pose with NaN or without a rotation matrix, parameters of a wrong shape, a task whose rows fix no
            set of poses, or "closed-form" for an arm without one.
        UnknownNameError: unknown method or joint.

    The set is empty for a pose out of reach.
    """
    from manipplan.ik.distinct import distinct
    from manipplan.ik.solver import Solver

    poses = pose_stack("pose", pose)
    solver = Solver.of(robot, task=task, held=held, method=method, seed=seed)
    values, complete = solver.values(parameters, samples, poses)
    owners = np.repeat(np.arange(len(poses)), len(values))
    found = solver.solve(poses, owners, np.tile(values, (len(poses), 1)))
    keep = distinct(found.q, found.source)
    if not instance("turns", turns, bool):
        keep = keep[np.argsort(np.linalg.norm(found.q[keep], axis=1), kind="stable")]
        keep = np.sort(keep[distinct(_directions(robot, found.q[keep]), found.source[keep])])
    return SolutionSet(
        q=found.q[keep],
        pose_index=owners[found.source[keep]],
        parameters=np.tile(values, (len(poses), 1))[found.source[keep]],
        parameter_names=solver.names,
        residual=found.residual[keep],
        complete=solver.complete or complete,
        method=solver.method,
        missing=found.missing,
    )


def pose_stack(argument: str, pose: Any) -> Array:
    """One or several poses as (p, 4, 4); each is checked."""
    from manipplan.ik.verify import are_poses

    matrix = getattr(pose, "homogeneous", pose)
    if isinstance(matrix, np.ndarray) and matrix.dtype == np.float64 and matrix.shape[1:] == (4, 4):
        stack = np.array(matrix, order="C")
        if are_poses(stack):
            return stack
    first = matrix[0] if isinstance(matrix, list | tuple) and len(matrix) else None
    if getattr(matrix, "ndim", 0) == 3 or _is_matrix(getattr(first, "homogeneous", first)):
        checked = [pose_matrix(f"{argument}[{k}]", each) for k, each in enumerate(matrix)]
        return np.array(checked, dtype=np.float64).reshape(-1, 4, 4)
    return pose_matrix(argument, pose)[None].copy()


def _is_matrix(value: Any) -> bool:
    try:
        return np.ndim(value) == 2
    except ValueError:  # rows of different lengths
        return False


def _directions(robot: Robot, q: Array) -> Array:
    """Equal rows for configurations (k, n) that differ by full turns: lengths, then cosines and sines of angles."""
    turns = robot.turns
    return np.hstack([q[:, ~turns], np.cos(q[:, turns]), np.sin(q[:, turns])])
