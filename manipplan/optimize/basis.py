"""The polynomial basis of a path: the straight line plus integrated Legendre polynomials that vanish at both ends."""

import numpy as np
from numpy.polynomial import legendre

from manipplan.checks import Array
from manipplan.paths.joint import bernstein


def bubbles(degree: int, s: Array) -> Array:
    """φ_j(s), j = 1 .. degree - 1, (m, degree - 1): integrals of the Legendre polynomials P_j over [0, s].

    Their derivatives are orthogonal, so the energy is well conditioned; φ_j(0) = φ_j(1) = 0 keeps the ends.
    """
    columns = [np.asarray(legendre.legval(2 * s - 1, _integral(j)), dtype=float) for j in range(1, degree)]
    return np.column_stack(columns or [np.empty((len(s), 0))])


def bubble_slopes(degree: int, s: Array) -> Array:
    """φ_j'(s) = P_j(2s - 1), (m, degree - 1)."""
    return np.asarray(legendre.legvander(2 * s - 1, max(degree - 1, 1)), dtype=float)[:, 1:degree]


def control_points(degree: int, start: Array, goal: Array, coefficients: Array) -> Array:
    """Bernstein control points (degree + 1, n) of start + s (goal - start) + Σ_j c_j φ_j(s); coefficients (n, degree - 1)."""
    line = start + np.linspace(0.0, 1.0, degree + 1)[:, None] * (goal - start)
    control = line + to_bernstein(degree) @ coefficients.T
    control[0], control[-1] = start, goal
    return control


def to_bernstein(degree: int) -> Array:
    """The matrix (degree + 1, degree - 1) from coefficients of φ_j to Bernstein control points."""
    s = (1 - np.cos(np.linspace(0.0, np.pi, degree + 1))) / 2
    return np.asarray(np.linalg.solve(bernstein(degree, s), bubbles(degree, s)), dtype=float)


def subdivision(degree: int, pieces: int) -> Array:
    """The matrix (pieces (degree + 1), degree + 1) from control points of a curve to those of its equal pieces."""
    rows = []
    rest = np.eye(degree + 1)
    for k in range(pieces - 1, 0, -1):
        left, rest = _split(rest, 1 / (k + 1))
        rows.append(left)
    return np.concatenate([*rows, rest])


def _split(control: Array, u: float) -> tuple[Array, Array]:
    """Control points of the two parts of a curve cut at u: de Casteljau."""
    left, right = [control[0]], [control[-1]]
    while len(control) > 1:
        control = (1 - u) * control[:-1] + u * control[1:]
        left.append(control[0])
        right.append(control[-1])
    return np.array(left), np.array(right[::-1])


def _integral(j: int) -> Array:
    # ∫ P_j(ξ) dξ = (P_{j+1} - P_{j-1}) / (2j + 1); ds = dξ / 2
    coefficients = np.zeros(j + 2)
    coefficients[j + 1], coefficients[j - 1] = 1.0, -1.0
    return coefficients / (2 * (2 * j + 1))
