"""The singular set: the postures with all links on one line."""

import itertools

import numpy as np
from numpy.typing import ArrayLike

from manipplan.planar.arm import PlanarArm
from manipplan.support.checks import Array, configurations


def singular_postures(arm: PlanarArm) -> Array:
    """One posture per line of singular postures, (2^(n-1), n) [rad]: θ_1, which is free, is 0; θ_2 ... θ_n are 0 or π.

    J loses rank only there: M_(n-1)n = l_(n-1) l_n sin θ_n must vanish, then M_(n-2)n, and so on down to θ_2. The first row
    is the stretched arm, the boundary singularity of section 2.5 in kth2012; the others are internal singularities, where
    the tool is still at a boundary of its motion for a subset of the joints.
    """
    rows = itertools.product((0.0, np.pi), repeat=arm.n - 1)
    return np.array([(0.0, *row) for row in rows])


def singular_radii(arm: PlanarArm) -> Array:
    """Distances of the tool from the base at `singular_postures`, (2^(n-1),) [m]: abs(l_1 ± l_2 ± ... ± l_n)."""
    signs = np.cumprod(np.cos(singular_postures(arm)), axis=-1)
    return np.abs(np.round(signs) @ arm.lengths)


def singular_distance(arm: PlanarArm, q: ArrayLike) -> Array:
    """Euclidean distance in joint space from q (..., n) to the nearest singular posture, (...,) [rad]."""
    bent = configurations("q", q, arm.n)[..., 1:]
    return np.asarray(np.linalg.norm(bent - np.pi * np.round(bent / np.pi), axis=-1))
