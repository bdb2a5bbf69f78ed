"""All inverse kinematics of a pose: every configuration that reaches it, for sampled values of what the arm has to spare."""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, instance, pose_matrix
from manipplan.symbolic.task import Task


class Completeness(StrEnum):
    """How far a set of solutions is all of them."""

    EXACT = "exact"
    """All, for each given value of the parameters; of a continuum, at a singularity, one."""
    TO_RESOLUTION = "to-resolution"
    """All for each value on a grid of parameters, between which there are more; or for given values, but for answers next to a
    singularity of an arm whose description rounds its axes."""
    STATISTICAL = "statistical"
    """Found by many random starts; `SolutionSet.missing` estimates the share that is not found."""


@dataclass(frozen=True, kw_only=True, eq=False)
class SolutionSet:
    """Configurations that reach a pose, or one of several; each verified by forward kinematics to 1e-10.

    Attributes:
        q: (k, n) [rad or m], inside the position limits.
        pose_index: (k,) which pose a row is of.
        parameters: (k, r) the values of what the arm has to spare, by which the row was found.
        parameter_names: (r,) held joints, then "swivel", then "tool rotation".
        residual: (k,) largest entry by which the pose is missed [m or 1].
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

    def of(self, pose: int) -> Array:
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

    An arm with more joints than the pose asks for has finitely many answers once some joints are held, or, with a spherical
    shoulder and wrist, once the swivel of the elbow is chosen: these values are the parameters. Joints that fit into their
    limits at several full turns are listed with each; joints without limits in [-π, π].

    Closed forms [pieper1968], of Paden-Kahan subproblems [murray1994], know every arm with three joint axes that meet at the
    wrist or the shoulder, and those with three parallel axes and two that meet (UR). Others are solved by Newton steps from
    random starts.

    Args:
        robot: the arm.
        pose: (4, 4) or pin.SE3 of the tool, or several, (p, 4, 4).
        parameters: (r,), or (s, r) to be tried for each pose: held joints [rad or m] in the order of the arm, then the
            swivel, then the turn about a free tool axis [rad]. Default: a grid.
        task: Task.pose(), the default, or Task.pointing(axis) whose rotation about the axis is free. For planar arms
            Task.planar(), their default: the position alone.
        samples: points of that grid, one number or one for each parameter.
        held: names of the joints that are held instead of the ones that the arm's closed form prefers.
        method: "closed-form", "newton", or "auto": the closed form where there is one.
        turns: False lists configurations that differ by full turns of joints once: the one with the smallest angles.
        seed: of the random starts.

    Raises:
        InvalidInputError: a pose with NaN or without a rotation matrix, parameters of a wrong shape, a task that is no
            pose, no closed form although asked for.
        UnknownNameError: no such method or joint.

    A pose out of reach gives an empty set.
    """
    from manipplan.ik.distinct import distinct
    from manipplan.ik.solver import Solver

    poses = pose_stack("pose", pose)
    solver = Solver.of(robot, task=task, held=held, method=method, seed=seed)
    values, complete = solver.values(parameters, samples)
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
    """One pose, or several, as (p, 4, 4); every one is checked."""
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
    """Equal for configurations (k, n) that differ by full turns: lengths as they are, for angles their cosine and sine."""
    revolute = np.array([kind != "prismatic" for kind in robot.joint_types])
    return np.hstack([q[:, ~revolute], np.cos(q[:, revolute]), np.sin(q[:, revolute])])
