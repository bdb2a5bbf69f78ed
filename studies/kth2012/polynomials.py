"""Path polynomials Θ_i(t) = Σ_j a_ij t^j of (6.2), and the means that the thesis prints."""

from dataclasses import dataclass
from math import comb

import numpy as np
from numpy.typing import ArrayLike, NDArray

import manipplan as mp
from manipplan.planar import inverse_condition, manipulability
from studies.kth2012.config import ARM

Array = NDArray[np.float64]


def polynomial(a: ArrayLike) -> mp.JointPath:
    """The path with coefficients a (n, k + 1)."""
    rows = np.asarray(a, dtype=float)
    k = rows.shape[1] - 1
    to_bernstein = [[comb(i, j) / comb(k, j) for j in range(k + 1)] for i in range(k + 1)]
    return mp.JointPath(breaks=np.array([0.0, 1.0]), control=(np.array(to_bernstein) @ rows.T)[None])


@dataclass(frozen=True, kw_only=True)
class Means:
    """Means of μ and κ along a path: over its parameter t, as in Table 6.4, and over its length."""

    mu: float
    kappa: float
    mu_by_length: float
    kappa_by_length: float


def means(path: mp.JointPath) -> Means:
    """Means along a path of the unit arm."""
    s, weights = path.quadrature()
    q, by_length = path(s), weights * np.linalg.norm(path(s, 1), axis=1)
    mu, kappa = manipulability(ARM, q), inverse_condition(ARM, q)
    length = by_length.sum()
    return Means(
        mu=float(weights @ mu),
        kappa=float(weights @ kappa),
        mu_by_length=float(by_length @ mu / length),
        kappa_by_length=float(by_length @ kappa / length),
    )
