"""The same polynomial problem from random starts, with another formulation and another solver: the study's own check."""

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray
from scipy.optimize import minimize

import manipplan as mp
from manipplan.planar import squared_manipulability, squared_manipulability_gradient
from studies.kth2012.config import ARM, Example

Array = NDArray[np.float64]


def best_of_random_starts(example: Example, degree: int, power: float, count: int) -> float:
    """The smallest g of polynomials of `degree` from start to goal, by BFGS from the line and from random coefficients.

    The basis is the line and integrals of Legendre polynomials; g itself is minimised, not an energy.
    """
    start, goal = np.array(example.start), np.array(example.goal)
    integrals = [legendre.legint(row, lbnd=-1) / 2 for row in np.eye(degree)[1:]]

    def rule(panels: int) -> tuple[Array, Array, Array, Array]:
        s, weights = mp.JointPath.line(start, goal).quadrature(panels=panels)
        values = np.column_stack([legendre.legval(2 * s - 1, each) for each in integrals])
        return s, weights, values, legendre.legvander(2 * s - 1, degree - 1)[:, 1:]

    def cost(flat: Array, s: Array, weights: Array, values: Array, slopes: Array) -> tuple[float, Array]:
        c = flat.reshape(degree - 1, -1)
        q, v = start + s[:, None] * (goal - start) + values @ c, goal - start + slopes @ c
        square = squared_manipulability(ARM, q)
        speed = np.linalg.norm(v, axis=1)
        part = weights * speed / square ** (power / 2)
        by_q = -(power / 2 * part / square)[:, None] * squared_manipulability_gradient(ARM, q)
        return float(part.sum()), (values.T @ by_q + slopes.T @ ((part / speed**2)[:, None] * v)).ravel()

    coarse, fine, rng = rule(24), rule(200), np.random.default_rng(0)
    best = np.inf
    for k in range(count):
        guess = rng.normal(size=3 * (degree - 1)) * (0.0, 0.6, 2.0)[min(k, 1 + k % 2)]
        found = minimize(cost, guess, args=coarse, jac=True, method="BFGS", options={"gtol": 1e-9, "maxiter": 400})
        checked = cost(found.x, *fine)[0]
        if abs(checked - found.fun) < 1e-6 * checked:  # otherwise the path crossed a singularity between the Gauss points
            best = min(best, checked)
    return best
