"""A joint path through the positions of a search that stays on the workspace path between them as well."""

import numpy as np

from manipplan.checks import Array
from manipplan.ik.solver import Solver
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.joint import JointPath
from manipplan.search.program import PoseRows

#: Places between two knots at which the deviation is looked at, and how often knots are doubled.
PLACES = 4
DOUBLINGS = 6


def joint_path(
    solver: Solver, rows: PoseRows, path: CartesianPath, s: Array, q: Array, *, closed: bool, allowed: Array
) -> JointPath:
    """A smooth joint path through q (k, n) at s (k,), which meets `path` to `allowed` (rows,) between the positions, too.

    Where it does not, knots are added half-way, moved onto the workspace path by the shortest way; after `DOUBLINGS`
    rounds the path is returned as it is, for the caller to judge.
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
        q = np.insert(q, wide + 1, solver.onto(joints(middle), path(middle)), axis=0)
    return JointPath.spline(s, q, closed=closed)
