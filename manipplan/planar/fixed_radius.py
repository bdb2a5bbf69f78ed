"""Three links with the tool at a fixed distance from the base: all stationary postures of μ, by exact algebra.

With the tool at distance R from the base and at distance d from the second joint, u = d², the minors of J are areas of
triangles: 4 M_12² = H_1 = 4 l_1² u - (l_1² + u - R²)², 4 M_23² = H_2 = 4 l_2² l_3² - (u - l_2² - l_3²)², and
2 u M_13 = A M_23 + B M_12 with A = R² + u - l_1², B = u + l_3² - l_2². Thus, with H = H_1 H_2 and the sign s of M_12 M_23,

    16 u² μ² = E + 2 s A B sqrt(H),   E = 4 u² (H_1 + H_2) + A² H_2 + B² H_1,

and dμ²/du = 0 reads N_1 sqrt(H) + s N_2 = 0 with N_1 = u E' - 2 E and N_2 = 2 u (A B)' H + u A B H' - 4 A B H. Squaring
it gives N_1² H - N_2², a polynomial of degree 12 in u with rational coefficients. Where the curve of postures turns back in u
(H = 0), this polynomial vanishes exactly where μ is stationary along the curve. Hence its real roots, counted by Sturm's
theorem, are all solutions except u = 0, a special case: l_2 = l_3 fold the tool onto the second joint and θ_2 is free.
"""

import math
from fractions import Fraction

import numpy as np

from manipplan.planar.arm import PlanarArm
from manipplan.planar.inverse import wrapped
from manipplan.planar.zeros import Polynomial, add, derivative, evaluate, multiply, real_roots, scale
from manipplan.support.checks import Array

#: A radius this close (share of the arm's length) to one with collinear links is set to it: rounding must not decide.
SNAP = Fraction(1, 10**14)
#: N_2 counts as zero below this share of its terms; roots are known to 2⁻¹²⁰, about 1e-36.
_ZERO = Fraction(1, 10**24)


def fixed_radius_postures(arm: PlanarArm, radius: float) -> Array:
    """All (θ_2, θ_3), (k, 2) in (-π, π] [rad], with the tool at `radius` [m] and μ stationary along the curve ‖f‖ = R.

    Points where the curve crosses itself or is a single point count as stationary. Lengths and radius are read as the
    decimal numbers that they print as, so that 0.5 = 0.3 + 0.2. The result is empty for a radius out of reach.
    """
    l1, l2, l3 = lengths = [exact(length) for length in arm.lengths]
    root = snapped(lengths, exact(radius))
    v = root**2
    least, most = max((l1 - root) ** 2, (l2 - l3) ** 2), min((l1 + root) ** 2, (l2 + l3) ** 2)
    if least > most:
        return np.zeros((0, 2))
    h1 = [-((l1**2 - v) ** 2), 2 * (l1**2 + v), Fraction(-1)]
    h2 = [4 * l2**2 * l3**2 - (l2**2 + l3**2) ** 2, 2 * (l2**2 + l3**2), Fraction(-1)]
    a, b = [v - l1**2, Fraction(1)], [l3**2 - l2**2, Fraction(1)]
    h, ab, u = multiply(h1, h2), multiply(a, b), [Fraction(0), Fraction(1)]
    e = add(scale(4, multiply(u, u, add(h1, h2))), multiply(a, a, h2), multiply(b, b, h1))
    n1 = add(multiply(u, derivative(e)), scale(-2, e))
    n2 = add(scale(2, multiply(u, derivative(ab), h)), multiply(u, ab, derivative(h)), scale(-4, multiply(ab, h)))
    rows = []
    for square in real_roots(add(multiply(n1, n1, h), scale(-1, multiply(n2, n2))), least, most):
        if square:
            areas = _root_of(h1, square), _root_of(h2, square)
            for sign in _signs(n1, n2, square):
                rows += _mirrored(lengths, v, square, areas, sign)
    if l2 == l3 and root == l1:  # u = 0: μ = l_1 l_3 |sin θ_2|
        rows += [(turn, np.pi) for turn in (0.0, np.pi / 2, np.pi, -np.pi / 2)]
    return _distinct(wrapped(np.array(rows).reshape(-1, 2)))


def exact(number: float) -> Fraction:
    """The decimal number that a float prints as."""
    return Fraction(repr(float(number)))


def snapped(lengths: list[Fraction], radius: Fraction) -> Fraction:
    """The radius, or the nearest |l_1 ± l_2 ± l_3| when that differs by at most `SNAP` times the arm's length."""
    l1, l2, l3 = lengths
    critical = [abs(l1 + a * l2 + b * l3) for a in (1, -1) for b in (1, -1)]
    nearest = min(critical, key=lambda each: abs(each - radius))
    return nearest if abs(nearest - radius) <= SNAP * sum(lengths) else radius


def _root_of(h: Polynomial, u: Fraction) -> float:
    """sqrt(H(u)); zero where a root u, known to 2⁻¹²⁰, makes H slightly negative."""
    return math.sqrt(max(evaluate(h, u), Fraction(0)))


def _signs(n1: Polynomial, n2: Polynomial, u: Fraction) -> tuple[int, ...]:
    """The signs s for which N_1 sqrt(H) + s N_2 = 0, given that the squares of the two terms agree."""
    first, second = evaluate(n1, u), evaluate(n2, u)
    if abs(second) <= _ZERO * sum(abs(c) * u**i for i, c in enumerate(n2)):
        return (1, -1)
    return (-1,) if first * second > 0 else (1,)


def _mirrored(
    lengths: list[Fraction], v: Fraction, u: Fraction, areas: tuple[float, float], sign: int
) -> list[tuple[float, float]]:
    """(θ_2, θ_3) and its mirror image for sqrt(H_1), sqrt(H_2) and the sign of M_12 M_23."""
    l1, l2, l3 = lengths
    first, second = areas[0], sign * areas[1]
    third = float(np.arctan2(second, float(u - l2**2 - l3**2)))
    # Seen from joint 2, the tool is at angle α = θ_2 + ψ to link 1: M_12 = l_1 d sin α and R² = l_1² + u + 2 l_1 d cos α.
    alpha = float(np.arctan2(first, float(v - l1**2 - u)))
    psi = float(np.arctan2(second, float(u + l2**2 - l3**2)))  # likewise 2 l_2 d (sin ψ, cos ψ)
    return [(alpha - psi, third), (psi - alpha, -third)]


def _distinct(rows: Array) -> Array:
    kept: list[Array] = []
    for row in rows:
        if all(np.abs(wrapped(row - other)).max() > 1e-9 for other in kept):
            kept.append(row)
    return np.array(kept).reshape(-1, 2)
