"""The best path among posts as a polyline, by an independent method: IPOPT on its corners.

Where a geodesic would run into a post, the best path follows the outline of the post, and the boundary value problem of
`geodesics` does not hold there. The corners of a polyline of n pieces minimise its energy n Σ w_i² ‖Δθ_i‖², with w = 1/μ^p by
Simpson's rule. The energy is at least g², and equal to it where g grows evenly. Corners and middles keep the distance from the
posts, and no piece is long enough to pass over a post. The path optimiser is not used.
"""

from collections.abc import Sequence

import casadi as ca
import numpy as np
from numpy.typing import NDArray

import manipplan as mp
from manipplan.planar import PlanarArm

Array = NDArray[np.float64]
#: Largest length of a piece in mean lengths of the first path's.
LONGEST = 1.5


def polyline_among(
    arm: PlanarArm, first: mp.JointPath, power: float, posts: Sequence[tuple[float, float]], reach: float, pieces: int
) -> float:
    """g of the best polyline of `pieces` pieces near a first path.

    The axis of every link keeps `reach` [m] from all posts, (x, y) [m]. Raises RuntimeError if IPOPT does not converge.
    """
    weight, distances = _functions(arm, power, posts)
    corners = first(np.linspace(0.0, 1.0, pieces + 1))
    free = ca.MX.sym("corners", arm.n, pieces - 1)
    q = ca.horzcat(corners[0], free, corners[-1])
    middles, steps = (q[:, 1:] + q[:, :-1]) / 2, q[:, 1:] - q[:, :-1]
    at_corners, squares = weight.map(pieces + 1)(q), ca.sum1(steps**2)
    w = (at_corners[:, :-1] + 4 * weight.map(pieces)(middles) + at_corners[:, 1:]) / 6
    mean = float(np.linalg.norm(np.diff(corners, axis=0), axis=1).mean())
    kept = ca.vertcat(ca.vec(distances.map(pieces - 1)(free)), ca.vec(distances.map(pieces)(middles)))
    problem = {"x": ca.vec(free), "f": pieces * ca.sum2(w**2 * squares), "g": ca.vertcat(kept, -ca.vec(squares) / mean**2)}
    options = {"expand": True, "print_time": False, "ipopt": {"print_level": 0, "sb": "yes", "mu_strategy": "adaptive"}}
    solver = ca.nlpsol("polyline", "ipopt", problem, options)
    low = np.concatenate([np.full(kept.shape[0], reach**2), np.full(pieces, -(LONGEST**2))])
    found = solver(x0=corners[1:-1].ravel(), lbg=low, ubg=np.inf)
    if not solver.stats()["success"]:
        raise RuntimeError(f"polyline from {corners[0]} to {corners[-1]}: {solver.stats()['return_status']}")
    return float(ca.Function("g", [ca.vec(free)], [ca.sum2(w * ca.sqrt(squares))])(found["x"]))


def _functions(arm: PlanarArm, power: float, posts: Sequence[tuple[float, float]]) -> tuple[ca.Function, ca.Function]:
    """1/μ^p of q, and the squared distances of all links' axes from all posts."""
    q = ca.SX.sym("q", arm.n)
    angles, tip, distances = ca.cumsum(q), ca.SX.zeros(2), []
    for k, length in enumerate(arm.lengths):
        along = ca.vertcat(ca.cos(angles[k]), ca.sin(angles[k]))
        for post in posts:
            offset = ca.DM(post) - tip
            distances.append(ca.sumsqr(offset - ca.fmin(ca.fmax(ca.dot(offset, along), 0.0), length) * along))
        tip += length * along
    jacobian = ca.jacobian(tip, q)
    mu_squared = ca.det(jacobian @ jacobian.T)
    return ca.Function("weight", [q], [mu_squared ** (-power / 2)]), ca.Function("distances", [q], [ca.vertcat(*distances)])
