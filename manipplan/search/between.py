"""A joint path through the positions of a search that stays on the workspace path between them as well."""

import numpy as np

from manipplan.checks import Array
from manipplan.ik.solver import Solver
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.joint import JointPath
from manipplan.search.program import PoseRows
from manipplan.tracking.relaxation import Tolerance

#: Places between two knots at which the deviation is looked at, and how often knots are doubled.
PLACES = 4
DOUBLINGS = 6


def joint_path(
    solver: Solver,
    rows: PoseRows,
    path: CartesianPath,
    s: Array,
    q: Array,
    *,
    closed: bool,
    allowed: Array,
    tube: Tolerance | None = None,
) -> JointPath:
    """A smooth joint path through q (k, n) at s (k,), which meets `path` to `allowed` (rows,) between the positions, too.

    Where it does not, knots are added half-way, moved onto the workspace path by the shortest way, or into a `tube` around
    it; after `DOUBLINGS` rounds the path is returned as it is, for the caller to judge.
    """
    for _ in range(DOUBLINGS):
        joints = JointPath.spline(s, q, closed=closed)
        shares = np.arange(1, 2 * PLACES, 2) / (2 * PLACES)
        places = s[:-1, None] + np.diff(s)[:, None] * shares
        errors = rows.errors(joints(places.ravel()), path(places.ravel())).reshape(len(s) - 1, PLACES, -1)
        wide = np.flatnonzero((np.abs(errors) > allowed).any(axis=(1, 2)))
        if not len(wide):
            break
        middle = (s[wide] + s[wide + 1]) / 2
        s = np.insert(s, wide + 1, middle)
        between, targets = joints(middle), path(middle)
        if tube is not None and solver.axis is None:
            targets = _into(tube, targets, solver.kinematics.pose(between))
        q = np.insert(q, wide + 1, solver.onto(between, targets), axis=0)
    return JointPath.spline(s, q, closed=closed)


def _into(tube: Tolerance, targets: Array, poses: Array) -> Array:
    """Poses (k, 4, 4) moved towards targets until they are inside the tube; onto them in what it leaves out."""
    from scipy.spatial.transform import Rotation

    moved = targets.copy()
    offset = poses[:, :3, 3] - targets[:, :3, 3]
    turn = Rotation.from_matrix(np.swapaxes(targets[:, :3, :3], 1, 2) @ poses[:, :3, :3]).as_rotvec()
    moved[:, :3, 3] += _shortened(offset, tube.position)
    moved[:, :3, :3] = targets[:, :3, :3] @ Rotation.from_rotvec(_shortened(turn, tube.rotation)).as_matrix()
    return moved


def _shortened(vectors: Array, longest: float | None) -> Array:
    """Vectors (k, 3) none of which is longer than that; zeros for None."""
    lengths = np.maximum(np.linalg.norm(vectors, axis=1, keepdims=True), 1e-300)
    return np.asarray(vectors * np.minimum((longest or 0.0) / lengths, 1.0))
