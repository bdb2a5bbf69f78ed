"""Velocity and force ellipses of the planar arm, their duality, and the ellipsoid of a matrix (appendices A, B in kth2012)."""

import numpy as np
from numpy.typing import ArrayLike

from manipplan.measures.ellipsoid import Ellipsoid, force_ellipsoid, velocity_ellipsoid
from manipplan.planar.arm import PlanarArm
from manipplan.support.checks import Array, configurations, finite_array, instance
from manipplan.support.errors import InvalidInputError


def velocity_ellipse(arm: PlanarArm, q: ArrayLike) -> Ellipsoid:
    """Tool velocities for joint speeds of norm 1 at one posture q (n,); (2.22) in kth2012. Its area is π μ."""
    instance("arm", arm, PlanarArm)
    return velocity_ellipsoid(arm.jacobian(_posture(arm, q)))


def force_ellipse(arm: PlanarArm, q: ArrayLike) -> Ellipsoid:
    """Tool forces for joint torques of norm 1 at one posture q (n,); (2.25) in kth2012.

    It has the axes of the velocity ellipse and the inverse radii: fast directions are weak ones.
    """
    instance("arm", arm, PlanarArm)
    return force_ellipsoid(arm.jacobian(_posture(arm, q)))


def matrix_ellipsoid(matrix: ArrayLike) -> Ellipsoid:
    """The ellipsoid {x : xᵀ A x <= 1} on its principal axes; appendix A in kth2012.

    Its radii are 1/sqrt(λ_i) (A.5), inf where λ_i = 0, and its volume K sqrt(det A⁻¹) (B.3).

    Args:
        matrix: A (m, m), symmetric and positive semidefinite.

    Raises InvalidInputError for any other matrix.
    """
    a = finite_array("matrix", matrix, (None, None))
    size = float(np.abs(a).max(initial=0.0))
    if not size or a.shape[0] != a.shape[1] or np.abs(a - a.T).max() > 1e-12 * size:
        raise InvalidInputError("matrix", a.tolist(), "a symmetric matrix that is not zero")
    values, axes = np.linalg.eigh(a)  # (A.3); ascending, so that the radii descend
    floor = len(a) * np.finfo(float).eps * size
    if values[0] < -floor:
        raise InvalidInputError("matrix", a.tolist(), f"no negative eigenvalue, not {values[0]:.3g}")
    flat = values <= floor
    radii = np.where(flat, np.inf, 1.0 / np.sqrt(np.where(flat, 1.0, values)))
    return Ellipsoid(axes=np.asarray(axes), radii=radii)


def _posture(arm: PlanarArm, q: ArrayLike) -> Array:
    one = configurations("q", q, arm.n)
    if one.ndim != 1:
        raise InvalidInputError("q", one.tolist(), f"one posture, shape ({arm.n},)")
    return one
