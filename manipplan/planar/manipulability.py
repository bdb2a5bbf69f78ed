"""Manipulability in closed form: μ² as a sum of squared minors of J, its derivatives, norm, condition and zeros.

None of the measures depends on the first angle (theorems 4.1, 4.2, 4.4 in kth2012): θ_1 rotates the whole arm.

Velocity and force ellipses of the planar arm, their duality, and the ellipsoid of a matrix (appendices A, B in kth2012).
"""

import itertools

import numpy as np

from manipplan.measures.ellipsoid import Ellipsoid, force_ellipsoid, velocity_ellipsoid
from manipplan.planar.arm import PlanarArm
from manipplan.support.checks import Array, ArrayLike, configurations, finite_array, instance
from manipplan.support.errors import InvalidInputError


def minors(arm: PlanarArm, q: ArrayLike) -> Array:
    """The 2x2 minors of the Jacobian, M_ij = r_i × r_j, (..., n, n) [m²], skew-symmetric, at q (..., n).

    In relative angles M_ij = Σ_(i<=p<j) Σ_(m>=j) l_p l_m sin(θ_(p+1) + ... + θ_m) for i < j: θ_1 does not appear.
    """
    instance("arm", arm, PlanarArm)
    return _cross(arm.levers(q))


def squared_manipulability(arm: PlanarArm, q: ArrayLike) -> Array:
    """μ² = det(J Jᵀ) = Σ_(i<j) M_ij², (...,) [m⁴], at q (..., n), by the Cauchy-Binet formula.

    (5.2) in kth2012 is this for unit links, with two misprints: the constant must be 5/2 and the 2θ_3 term -cos 2θ_3.
    """
    return np.asarray((minors(arm, q) ** 2).sum(axis=(-2, -1)) / 2)


def squared_manipulability_gradient(arm: PlanarArm, q: ArrayLike) -> Array:
    """∇μ² with respect to the angles, (..., n) [m⁴], at q (..., n); its first entry is zero."""
    instance("arm", arm, PlanarArm)
    minor, first = _slopes(arm.levers(q))
    return np.asarray(np.einsum("...ij,...ijk->...k", minor, first))


def squared_manipulability_hessian(arm: PlanarArm, q: ArrayLike) -> Array:
    """∇²μ² with respect to the angles, (..., n, n) [m⁴], at q (..., n); its first row and column are zero."""
    instance("arm", arm, PlanarArm)
    r = arm.levers(q)
    minor, first = _slopes(r)
    second = _bends(minor, arm.n)
    outer = np.einsum("...ijk,...ijl->...kl", first, first)
    return np.asarray(outer + np.einsum("...ij,...ijkl->...kl", minor, second))


def manipulability(arm: PlanarArm, q: ArrayLike) -> Array:
    """The manipulability measure μ = sqrt(det(J Jᵀ)), (...,) [m²], at q (..., n); (2.19) in kth2012."""
    return np.asarray(np.sqrt(squared_manipulability(arm, q)))


def manipulability_gradient(arm: PlanarArm, q: ArrayLike) -> Array:
    """∇μ = ∇μ² / (2 μ), (..., n) [m²], at q (..., n).

    Raises InvalidInputError at a singular posture, where μ has a kink. `squared_manipulability_gradient` exists everywhere.
    """
    return np.asarray(squared_manipulability_gradient(arm, q) / (2 * _regular(arm, q)[..., None]))


def manipulability_hessian(arm: PlanarArm, q: ArrayLike) -> Array:
    """∇²μ = (∇²μ² / 2 - ∇μ ∇μᵀ) / μ, (..., n, n) [m²], at q (..., n). Raises like `manipulability_gradient`."""
    m = _regular(arm, q)
    slope = manipulability_gradient(arm, q)
    bend = squared_manipulability_hessian(arm, q) / 2 - slope[..., :, None] * slope[..., None, :]
    return np.asarray(bend / m[..., None, None])


def frobenius_norm(arm: PlanarArm, q: ArrayLike) -> Array:
    """The weighted Frobenius norm sqrt(tr(J Jᵀ)/2), (...,) [m], at q (..., n).

    (4.2) in kth2012, whose innermost sum must start at m = p + 1, not at i + 1. The terms do not depend on i, so each
    appears p times: tr(J Jᵀ)/2 = Σ_p p l_p²/2 + Σ_(p<m) p l_p l_m cos(θ_(p+1) + ... + θ_m).
    """
    instance("arm", arm, PlanarArm)
    return np.asarray(np.sqrt(np.maximum(_half_trace(arm, q), 0.0)))


def inverse_condition(arm: PlanarArm, q: ArrayLike) -> Array:
    """κ = σ_min/σ_max of J, from 0 (singular) to 1 (isotropic), (...,), at q (..., n).

    kth2012 calls it the condition number (2.23). Computed from trace and determinant as in (4.38), but the smaller
    eigenvalue is det/λ_max, since the difference in (4.38) loses digits near a singularity.
    """
    instance("arm", arm, PlanarArm)
    half = _half_trace(arm, q)
    square = squared_manipulability(arm, q)
    largest = half + np.sqrt(np.maximum(half**2 - square, 0.0))  # (4.38)
    return np.asarray(np.sqrt(square) / largest)


def _half_trace(arm: PlanarArm, q: ArrayLike) -> Array:
    phi = np.cumsum(configurations("q", q, arm.n), axis=-1)
    weights = np.arange(1, arm.n + 1) * arm.lengths
    pairs = np.triu(weights[:, None] * arm.lengths, 1)
    cosines = np.cos(phi[..., None, :] - phi[..., :, None])
    return np.asarray((pairs * cosines).sum(axis=(-2, -1)) + weights @ arm.lengths / 2)


def _regular(arm: PlanarArm, q: ArrayLike) -> Array:
    m = manipulability(arm, q)
    if (m <= 1e-12 * arm.lengths.sum() ** 2).any():
        raise InvalidInputError("q", q, "postures that are not singular: at a singular one μ has no derivative, but μ² does")
    return m


def _cross(r: Array) -> Array:
    x, y = r[..., 0], r[..., 1]
    return np.asarray(x[..., :, None] * y[..., None, :] - y[..., :, None] * x[..., None, :])


def _slopes(r: Array) -> tuple[Array, Array]:
    """M_ij (..., n, n), and ∂_k M_ij = r_i · r_max(j,k) - r_max(i,k) · r_j, (..., n, n, n), since ∂_k r_i = ⊥ r_max(i,k)."""
    dots = r @ np.swapaxes(r, -1, -2)
    i, j, k = np.ogrid[: r.shape[-2], : r.shape[-2], : r.shape[-2]]
    return _cross(r), dots[..., i, np.maximum(j, k)] - dots[..., np.maximum(i, k), j]


def _bends(minor: Array, n: int) -> Array:
    """∂_l ∂_k M_ij, (..., n, n, n, n), by ∂_l (r_a · r_b) = M_(max(a,l) b) + M_(max(b,l) a)."""
    i, j, k, m = np.ogrid[:n, :n, :n, :n]

    def slope(a: Array, b: Array) -> Array:
        return np.asarray(minor[..., np.maximum(a, m), b] + minor[..., np.maximum(b, m), a])

    return slope(i, np.maximum(j, k)) - slope(np.maximum(i, k), j)


def singular_postures(arm: PlanarArm) -> Array:
    """One posture per line of singular postures, (2^(n-1), n) [rad]: θ_1, which is free, is 0; θ_2 ... θ_n are 0 or π.

    J loses rank only there: M_(n-1)n = l_(n-1) l_n sin θ_n must vanish, then M_(n-2)n, and so on down to θ_2. The first row
    is the stretched arm, the boundary singularity of section 2.5 in kth2012; the others are internal singularities, where
    the tool is still at a boundary of its motion for a subset of the joints.
    """
    instance("arm", arm, PlanarArm)
    rows = itertools.product((0.0, np.pi), repeat=arm.n - 1)
    return np.array([(0.0, *row) for row in rows])


def singular_radii(arm: PlanarArm) -> Array:
    """Distances of the tool from the base at `singular_postures`, (2^(n-1),) [m]: abs(l_1 ± l_2 ± ... ± l_n)."""
    signs = np.cumprod(np.cos(singular_postures(arm)), axis=-1)
    return np.abs(np.round(signs) @ arm.lengths)


def singular_distance(arm: PlanarArm, q: ArrayLike) -> Array:
    """Euclidean distance in joint space from q (..., n) to the nearest singular posture, (...,) [rad]."""
    instance("arm", arm, PlanarArm)
    bent = configurations("q", q, arm.n)[..., 1:]
    return np.asarray(np.linalg.norm(bent - np.pi * np.round(bent / np.pi), axis=-1))


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
