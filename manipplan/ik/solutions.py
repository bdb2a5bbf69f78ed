"""All inverse kinematics solutions of a pose: every configuration that reaches it, for sampled redundancy parameters.

Duplicate solutions: at a double root a closed form gives the same configuration twice.

Compiled checks of every pose and every solution: a pose is a rigid motion, and a solution reaches it.
"""

import logging
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from manipplan.ik.bridge import as_bool, as_float64, as_int64, ik_functions
from manipplan.robots.robot import Robot
from manipplan.support.checks import COINCIDENT, EXACT, Array, ArrayLike, flag, number, pose_matrix, whole_number
from manipplan.support.deadline import NEVER, Deadline, work_time
from manipplan.support.display import Pictured, one_line
from manipplan.symbolic.task import Task

if TYPE_CHECKING:
    from manipplan.ik.solver import Solver

log = logging.getLogger(__name__)
#: Number of samples that are solved first where a deadline is set, and time that the next ones may take at once [s].
FIRST, STEP = 256, 0.02
#: Time to put one solution of such samples into its place among all, by estimate [s].
JOIN = 6e-7
#: Time for one pose from which on the log says how to get its solutions faster [s].
SLOW = 1.0


class Completeness(StrEnum):
    """How complete a set of solutions is."""

    EXACT = "exact"
    """All solutions for each given value of the parameters; one of a continuum, at a singularity."""
    TO_RESOLUTION = "to-resolution"
    """All solutions for each value on a grid of parameters, with more between the grid points; or all for given values, except
    solutions near a singularity of an arm whose description rounds its axes."""
    STATISTICAL = "statistical"
    """Not all: found from random starts, until a time limit, or on a grid whose steps exceed what the arm bridges between them;
    `SolutionSet.missing` estimates the share that is not found."""


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class SolutionSet(Pictured):
    """Configurations that reach a pose, or one of several; each verified by forward kinematics to 1e-10.

    Beyond 10 km from the world's origin the tolerance is 1e-14 of the distance. If rounding puts a pose just beyond a joint
    limit or the workspace, the solutions at that limit are returned; they miss it by at most 1e-6 m and rad.

    Attributes:
        q: (k, n) [rad or m], inside the position limits.
        pose_index: (k,) index of the pose that each row reaches.
        parameters: (k, r) values of the redundancy parameters of each row.
        parameter_names: (r,) held joints, then "swivel", then those of the free motion.
        residual: (k,) largest entry of the pose error [m or 1].
        complete: "exact", "to-resolution" or "statistical"; see `Completeness`.
        method: "spherical", "parallel", "swivel" or "newton"; or the name of inverse kinematics of your own.
        missing: estimated share of solutions that is not found, 0 to 1; 0 for closed forms; nan, unknown, for inverse
            kinematics of your own that do not return every solution.
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
        return np.asarray(self.q[self.pose_index == whole_number("pose", pose, least=0)])

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
    time_limit: float | None = None,
    seed: int = 0,
) -> SolutionSet:
    """Find every configuration that reaches a pose.

    A redundant arm has finitely many solutions once some joints are held or, with a spherical shoulder and wrist, once the
    swivel angle of the elbow is fixed: these values are the parameters. A joint angle that fits its limits at several full
    turns is listed at each of them; joints without limits, or with limits more than eight turns apart, are in one turn, [-π, π]
    where the limits hold it.

    The grid of a slide is confined to where the other joints can bridge what is left to the pose, however long it is.

    Closed forms [pieper1968], built from Paden-Kahan subproblems [murray1994], cover every arm with three joint axes that meet
    at the wrist or the shoulder, and arms with three parallel axes and two that meet (UR). Others are solved by Newton steps
    from random starts.

    Args:
        robot: the arm.
        pose: (4, 4) or pin.SE3 of the tool, or several, (p, 4, 4).
        parameters: (r,), or (s, r) to be tried for each pose: held joints [rad or m] in the order of the arm, then the
            swivel, then the motions that the task leaves free: shifts [m], rotation about an axis [rad], or azimuth, tilt and
            tool rotation (Euler angles ZYZ) of a free orientation. Default: a grid, made finer where it finds nothing; if that
            does not help, values of configurations to which random starts lead.
        task: Task.pose(), the default; Task.pointing(axis), whose rotation about the axis is free; or any other whose rows fix
            a set of poses, such as Task.position(). For planar arms Task.planar(), their default: the position alone.
        samples: number of grid points, one number or one per parameter.
        held: names of the joints to hold instead of those that the arm's closed form prefers.
        method: "closed-form", "newton", or "auto": what `Robot.with_inverse_kinematics` was given, or the closed form where
            there is one.
        turns: False lists only one of the configurations that differ by full turns, the one with the smallest angles.
        time_limit: time after which the search ends [s]; None: no limit. What was found until then is returned, as
            "statistical" with `missing` above zero if the search was cut off. The grid of parameters is made and at least one
            part of it solved, also if that takes longer.
        seed: seed of the random starts.

    Raises:
        InvalidInputError: a pose with NaN or without a rotation matrix, parameters of a wrong shape, a task whose rows fix no
            set of poses, or "closed-form" for an arm without one.
        UnknownNameError: unknown method or joint.

    The set is empty for a pose out of reach.
    """
    from manipplan.ik.solver import Solver

    flag("turns", turns)
    poses = pose_stack("pose", pose)
    began = time.monotonic()
    deadline = NEVER if time_limit is None else Deadline.within(number("time_limit", time_limit, above=0.0))
    solver = Solver.of(robot, task=task, held=held, method=method, seed=seed)
    found = _solve(solver, poses, parameters, samples, turns, deadline)
    if parameters is None and samples is None:
        finer = solver.finer_counts()
        for count in finer:
            none = np.setdiff1d(np.arange(len(poses)), found.owners)
            if not len(none) or found.cut or deadline.passed:
                break
            found = found.with_more(_solve(solver, poses[none], None, count, turns, deadline), none)
        for k in np.setdiff1d(np.arange(len(poses)), found.owners):
            if solver.samples_redundancy and (found.cut or deadline.passed):  # more work might have reached this pose
                share = 1 - len(np.unique(found.owners)) / len(poses)
                found = replace(found, complete=Completeness.STATISTICAL, missing=max(found.missing, share))
                break
            q = solver.random_solutions(poses[k])
            if len(q):
                more = _with_these(solver, poses[k], q, turns, deadline)
                part = replace(more, complete=Completeness.STATISTICAL, missing=max(found.missing, 1 / (1 + len(more.q))))
                found = found.with_more(part, np.array([k]))
    if (np.diff(found.owners) < 0).any():
        found = found.of(np.argsort(found.owners, kind="stable"))
    if parameters is None and samples is None and time_limit is None:
        count = max(len(poses), 1)
        _hint(robot, solver.method, (time.monotonic() - began) / count, found.tried // count)
    return SolutionSet(
        q=found.q,
        pose_index=found.owners,
        parameters=found.parameters,
        parameter_names=solver.names,
        residual=found.residual,
        complete=found.complete,
        method=solver.method,
        missing=found.missing,
    )


#: Attributes of a `_Solved` with one row per configuration.
ARRAYS = ("q", "owners", "source", "parameters", "residual")


@dataclass(frozen=True, eq=False)
class _Solved:
    """Configurations (k, n) with the pose (k,), sample (k,), parameters (k, r) and residual (k,) of each.

    Besides the number of samples, how complete their solutions are, and whether the deadline cut off some samples.
    """

    q: Array
    owners: NDArray[np.int64]
    source: NDArray[np.int64]
    parameters: Array
    residual: Array
    tried: int
    complete: Completeness = Completeness.STATISTICAL
    missing: float = 0.0
    cut: bool = False

    def of(self, rows: NDArray[np.int64]) -> "_Solved":
        """Some of the configurations."""
        return self.with_arrays(lambda name: getattr(self, name)[rows])

    def with_arrays(self, make: Callable[[str], Any]) -> "_Solved":
        """The same with other configurations: `make` gives each array by its name."""
        arrays: dict[str, Any] = {name: make(name) for name in ARRAYS}
        return replace(self, **arrays)

    def with_more(self, more: "_Solved", poses: NDArray[np.int64]) -> "_Solved":
        """Together with the solutions `more` of further samples; `poses` maps its pose indices to ours."""
        both = _joined([self, replace(more, owners=poses[more.owners], source=self.tried + more.source)])
        missing = max(self.missing, more.missing) if more.complete == Completeness.STATISTICAL else more.missing
        return replace(both, tried=self.tried + more.tried, complete=more.complete, missing=missing, cut=more.cut)


def _joined(parts: Sequence[_Solved]) -> _Solved:
    """The configurations of several parts, with the number of samples and the completeness of the first."""
    return parts[0].with_arrays(lambda name: np.concatenate([getattr(each, name) for each in parts]))


def _solve(
    solver: "Solver",
    poses: Array,
    parameters: ArrayLike | None,
    samples: int | Sequence[int] | None,
    turns: bool,
    deadline: Deadline,
) -> _Solved:
    """All solutions of poses (p, 4, 4) for given parameters or a grid; each pose has its own grid where slides are in it.

    Those found until the deadline are of samples that are spread over the grid.
    """
    each = poses[:, None] if solver.sweeps_slides and len(poses) else poses[None]
    grids = [solver.values(parameters, samples, some) for some in each]
    if len(grids) == 1:
        owners, values = np.repeat(np.arange(len(poses)), len(grids[0].values)), np.tile(grids[0].values, (len(poses), 1))
    else:
        owners = np.repeat(np.arange(len(poses)), [len(grid.values) for grid in grids])
        values = np.concatenate([grid.values for grid in grids])
    count, timed = len(values), np.isfinite(deadline.at) and solver.solves_together
    order, size = (np.random.default_rng(0).permutation(count), FIRST) if timed else (np.arange(count), count)
    parts: list[_Solved] = []
    begin, missing, cut = 0, 0.0, False
    while not parts or (begin < count and deadline.left > JOIN * sum(len(each.q) for each in parts)):
        some, began = order[begin : begin + size], work_time()
        found = solver.solve(poses, owners[some], values[some], deadline)
        keep = _different(solver.robot, found.q, found.source, turns)
        source = some[found.source[keep]]
        parts.append(_Solved(found.q[keep], owners[source], source, values[source], found.residual[keep], tried=count))
        missing += len(some) * (1 - found.solved * (1 - found.missing))
        cut = cut or found.solved < 1
        begin += len(some)
        size = max(min(int(size * STEP / max(work_time() - began, 1e-6)), 2 * size), 1)
    cut = cut or begin < count
    missing = 1 - (1 - (missing + count - begin) / max(count, 1)) * (1 - float(np.mean([grid.missing for grid in grids])))
    whole = _joined(parts)
    if timed:
        whole = whole.of(np.argsort(whole.source, kind="stable"))
    coarse = cut or any(grid.complete == Completeness.STATISTICAL for grid in grids)
    label = Completeness.STATISTICAL if coarse else solver.complete or grids[0].complete
    return replace(whole, complete=label, missing=missing, cut=cut)


def _different(robot: Robot, q: Array, source: NDArray[np.int64], turns: bool) -> NDArray[np.int64]:
    """Rows of q (k, n) without duplicates of one sample; without `turns` only one of those that differ by full turns."""
    keep = distinct(q, source)
    if not turns:
        keep = keep[np.argsort(np.linalg.norm(q[keep], axis=1), kind="stable")]
        keep = np.sort(keep[distinct(_directions(robot, q[keep]), source[keep])])
    return keep


def _with_these(solver: "Solver", pose: Array, q: Array, turns: bool, deadline: Deadline) -> _Solved:
    """All solutions of a pose (4, 4) with the parameters of known ones, q (k, n), and these themselves."""
    values = solver.parameters_of(q, np.tile(pose, (len(q), 1, 1)))
    found, own = _solve(solver, pose[None], values, None, turns, deadline), solver.judged(q, pose)
    here = np.zeros(len(own.q), dtype=np.int64)
    both = _joined([found, _Solved(own.q, here, own.source, values[own.source], own.residual, tried=found.tried)])
    both = both.of(_different(solver.robot, both.q, both.source, turns))
    return replace(both, complete=found.complete, missing=found.missing)


def _hint(robot: Robot, method: str, seconds: float, samples: int) -> None:
    """Log how to get solutions faster where one pose took long [s]."""
    if seconds > SLOW and samples > 1:
        log.warning(
            "%s: inverse kinematics by %s of one pose took %.1f s for %d samples of its redundancy; samples= takes fewer, and "
            "time_limit= ends it earlier",
            robot.name,
            method,
            seconds,
            samples,
        )


def pose_stack(argument: str, pose: Any) -> Array:
    """One or several poses as (p, 4, 4), each the rigid transform nearest to the one given; raises as `pose_matrix`."""
    matrix = getattr(pose, "homogeneous", pose)
    if type(matrix) is np.ndarray and matrix.dtype == np.float64 and matrix.shape[1:] == (4, 4):
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
    except Exception:  # rows of different lengths, or a foreign object: the check of one pose says so
        return False


def _directions(robot: Robot, q: Array) -> Array:
    """Equal rows for configurations (k, n) that differ by full turns: lengths, then cosines and sines of angles."""
    turns = robot.turns
    return np.hstack([q[:, ~turns], np.cos(q[:, turns]), np.sin(q[:, turns])])


def distinct(q: Array, source: NDArray[np.int64]) -> NDArray[np.int64]:
    """Indices of the rows of q (k, n), only the first of those of one sample that differ by less than `COINCIDENT`."""
    order = np.argsort(source, kind="stable")
    q, source, keep = as_float64(q[order]), as_int64(source[order]), np.empty(len(order), dtype=np.bool_)
    ik_functions()["first_ones"](q.ctypes.data, source.ctypes.data, *q.shape, COINCIDENT, keep.ctypes.data)
    return order[keep]


def apart(
    q: Array, source: NDArray[np.int64], owners: NDArray[np.int64], turns: NDArray[np.bool_], spacing: Array
) -> NDArray[np.bool_]:
    """Whether neighbouring samples of one owner are apart, (s - 1,): a solution of one has none of the other within `spacing`.

    q (k, n) are solutions in the order of their samples `source` (k,); owners (s,). Joints that turn, as `turns` (n,) says, are
    compared up to full turns. spacing (n,) [rad or m].
    """
    start, owners = as_int64(np.searchsorted(source, np.arange(len(owners) + 1))), as_int64(owners)
    q, spacing, turns, result = as_float64(q), as_float64(spacing), as_bool(turns), np.zeros(len(owners) - 1, dtype=np.bool_)
    arrays = (q.ctypes.data, start.ctypes.data, owners.ctypes.data, len(owners), q.shape[1])
    ik_functions()["apart"](*arrays, turns.ctypes.data, spacing.ctypes.data, result.ctypes.data)
    return result


def are_poses(poses: Array) -> bool:
    """Whether every matrix of poses (p, 4, 4) is a rotation and a translation, up to the rounding of double precision."""
    poses = as_float64(poses)
    return bool(ik_functions()["are_poses"](poses.ctypes.data, len(poses), EXACT))


def residuals(reached: Array, targets: Array, owners: NDArray[np.int64]) -> Array:
    """The largest entry (k,) of reached - targets[owners], of poses reached (k, 4, 4), targets (p, 4, 4) and owners (k,)."""
    reached, targets, owners, out = as_float64(reached), as_float64(targets), as_int64(owners), np.empty(len(reached))
    ik_functions()["residuals"](reached.ctypes.data, targets.ctypes.data, owners.ctypes.data, len(reached), out.ctypes.data)
    return out
