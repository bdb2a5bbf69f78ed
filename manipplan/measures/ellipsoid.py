"""The velocity manipulability ellipsoid: tool velocities that joint speeds of unit norm can give."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from manipplan.checks import Array, finite_array


@dataclass(frozen=True, kw_only=True)
class Ellipsoid:
    """{v : vᵀ (J Jᵀ)⁻¹ v <= 1}, section 2.7.1 of kth2012.

    Attributes:
        axes: (m, m) orthonormal columns, the longest first.
        radii: (m,) their lengths, the singular values of J, falling; 0 where the arm cannot move.
    """

    axes: Array
    radii: Array


def velocity_ellipsoid(jacobian: ArrayLike) -> Ellipsoid:
    """The ellipsoid of a Jacobian (m, n), for instance its three linear rows. Raises InvalidInputError for NaN or inf."""
    matrix = finite_array("jacobian", jacobian, (None, None))
    axes, radii, _ = np.linalg.svd(matrix, full_matrices=True)
    padded = np.zeros(len(axes))
    padded[: len(radii)] = radii
    return Ellipsoid(axes=axes, radii=padded)
