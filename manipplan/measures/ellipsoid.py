"""Ellipsoids of tool velocity, force and acceleration for joint speeds or torques of norm 1."""

import math
from dataclasses import dataclass

import numpy as np

from manipplan.support.checks import Array, ArrayLike, finite_array
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError


@one_line
@dataclass(frozen=True, kw_only=True)
class Ellipsoid:
    """{Σ_i x_i radii_i axes_i : ‖x‖ <= 1}.

    Attributes:
        axes: (m, m) orthonormal columns.
        radii: (m,) semi-axis lengths in descending order; 0 where no motion is possible, inf where no torque is needed.
    """

    axes: Array
    radii: Array

    @property
    def volume(self) -> float:
        """π^(m/2)/Γ(m/2 + 1) times the product of the radii; appendix B of kth2012."""
        m = len(self.radii)
        return float(math.pi ** (m / 2) / math.gamma(m / 2 + 1) * np.prod(self.radii))


def velocity_ellipsoid(jacobian: ArrayLike) -> Ellipsoid:
    """Tool velocities for joint speeds of norm 1, from a Jacobian (m, n), for instance its three linear rows.

    It is {v : vᵀ (J Jᵀ)⁻¹ v <= 1}, section 2.7.1 of kth2012; its radii are the singular values of J. Raises
    InvalidInputError for NaN or inf.
    """
    return _image(finite_array("jacobian", jacobian, (None, None)))


def force_ellipsoid(jacobian: ArrayLike) -> Ellipsoid:
    """Tool forces that joint torques of norm 1 can hold, from a Jacobian (m, n): {f : fᵀ J Jᵀ f <= 1}.

    It has the axes of the velocity ellipsoid and the radii 1/σ: the tool is strong where it is slow. Where it cannot move,
    the structure bears any force (radius inf).
    """
    velocity = velocity_ellipsoid(jacobian)
    floor = velocity.radii[0] * np.finfo(float).eps * max(np.shape(jacobian))
    lost = velocity.radii <= floor
    radii = np.where(lost, np.inf, 1.0 / np.where(lost, 1.0, velocity.radii))
    return Ellipsoid(axes=velocity.axes[:, ::-1].copy(), radii=radii[::-1].copy())


def dynamic_ellipsoid(jacobian: ArrayLike, mass_matrix: ArrayLike) -> Ellipsoid:
    """Tool accelerations from rest for joint torques of norm 1 beyond gravity compensation: image of J M⁻¹ [yoshikawa1985b].

    Args:
        jacobian: (m, n).
        mass_matrix: M (n, n), symmetric and positive definite; `Kinematics.mass_matrix`.

    Raises InvalidInputError for other shapes, NaN, inf, or an M that is not positive definite.
    """
    matrix = finite_array("jacobian", jacobian, (None, None))
    mass = finite_array("mass_matrix", mass_matrix, (matrix.shape[1], matrix.shape[1]))
    if not np.allclose(mass, mass.T, rtol=1e-9, atol=1e-9 * np.abs(mass).max()) or np.linalg.eigvalsh(mass)[0] <= 0:
        raise InvalidInputError("mass_matrix", mass.tolist(), "a symmetric matrix with eigenvalues above zero")
    return _image(np.asarray(np.linalg.solve(mass, matrix.T).T, dtype=np.float64))


def _image(matrix: Array) -> Ellipsoid:
    if not (matrix.size and np.isfinite(matrix).all()):
        raise InvalidInputError("jacobian", matrix.tolist(), "a matrix with rows and columns, and finite accelerations")
    axes, radii, _ = np.linalg.svd(matrix, full_matrices=True)
    padded = np.zeros(len(axes))
    padded[: len(radii)] = radii
    return Ellipsoid(axes=axes, radii=padded)
