"""Optimal postures: where μ is stationary, unconstrained, at a fixed distance and within joint limits; chapter 5 of kth2012.

All stationary postures are found, with proof: unconstrained ones by subdivision with Krawczyk's test (`zeros`), those at a
fixed distance by Sturm's theorem on a polynomial of degree 12 (`fixed_radius`). The maximum is one of them.

Three links with the tool at a fixed distance from the base: all stationary postures of μ, by exact algebra.

With the tool at distance R from the base and at distance d from the second joint, u = d², the minors of J are areas of
triangles: 4 M_12² = H_1 = 4 l_1² u - (l_1² + u - R²)², 4 M_23² = H_2 = 4 l_2² l_3² - (u - l_2² - l_3²)², and
2 u M_13 = A M_23 + B M_12 with A = R² + u - l_1², B = u + l_3² - l_2². Thus, with H = H_1 H_2 and the sign s of M_12 M_23,

    16 u² μ² = E + 2 s A B sqrt(H),   E = 4 u² (H_1 + H_2) + A² H_2 + B² H_1,

and dμ²/du = 0 reads N_1 sqrt(H) + s N_2 = 0 with N_1 = u E' - 2 E and N_2 = 2 u (A B)' H + u A B H' - 4 A B H. Squaring
it gives N_1² H - N_2², a polynomial of degree 12 in u with rational coefficients. Where the curve of postures turns back in u
(H = 0), this polynomial vanishes exactly where μ is stationary along the curve. Hence its real roots, counted by Sturm's
theorem, are all solutions except u = 0, a special case: l_2 = l_3 fold the tool onto the second joint and θ_2 is free.
"""

import itertools
import math
from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np
from numpy.polynomial.polynomial import polyder, polyval
from numpy.typing import NDArray

from manipplan.planar.arm import PlanarArm, check_links, elbow_between, rigid_part, wrapped
from manipplan.planar.manipulability import inverse_condition, manipulability, squared_manipulability_hessian
from manipplan.planar.workspace import AngleLimits, reachable_radii
from manipplan.planar.zeros import (
    Polynomial,
    TrigonometricPolynomial,
    multiply,
    real_roots,
    squared_manipulability_series,
    torus_zeros,
)
from manipplan.support.checks import Array, ArrayLike, configurations, instance, number
from manipplan.support.errors import InvalidInputError

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
    h1 = np.array([-((l1**2 - v) ** 2), 2 * (l1**2 + v), Fraction(-1)])
    h2 = np.array([4 * l2**2 * l3**2 - (l2**2 + l3**2) ** 2, 2 * (l2**2 + l3**2), Fraction(-1)])
    a, b = [v - l1**2, Fraction(1)], [l3**2 - l2**2, Fraction(1)]
    h, ab, u = multiply(h1, h2), multiply(a, b), [Fraction(0), Fraction(1)]
    # no leading coefficient vanishes, so sums are of arrays of one length
    e = 4 * multiply(u, u, h1 + h2) + multiply(a, a, h2) + multiply(b, b, h1)
    n1 = multiply(u, polyder(e)) - 2 * e
    n2 = 2 * multiply(u, polyder(ab), h) + multiply(u, ab, polyder(h)) - 4 * multiply(ab, h)
    rows = []
    for square in real_roots(multiply(n1, n1, h) - multiply(n2, n2), least, most):
        if square:
            areas = _root_of(h1, square), _root_of(h2, square)
            for sign in _signs(n1, n2, square):
                rows += _mirror_pair(lengths, v, square, areas, sign)
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
    return math.sqrt(max(float(polyval(u, h)), 0.0))


def _signs(n1: Polynomial, n2: Polynomial, u: Fraction) -> tuple[int, ...]:
    """The signs s for which N_1 sqrt(H) + s N_2 = 0, given that the squares of the two terms agree."""
    first, second = polyval(u, n1), polyval(u, n2)
    if abs(second) <= _ZERO * sum(abs(c) * u**i for i, c in enumerate(n2)):
        return (1, -1)
    return (-1,) if first * second > 0 else (1,)


def _mirror_pair(
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
    distinct: list[Array] = []
    for row in rows:
        if all(np.abs(wrapped(row - other)).max() > 1e-9 for other in distinct):
            distinct.append(row)
    return np.array(distinct).reshape(-1, 2)


#: Share of the arm's length below which a radius counts as 0.
NO_RADIUS = 1e-12
#: Maximum number of links for finding all stationary postures: each further link takes a hundred times as long.
MOST_LINKS = 4
#: Relative tolerance on μ within which a posture counts as best, too.
TIE = 1e-12


@dataclass(frozen=True, kw_only=True, eq=False)
class PostureSet:
    """Postures of one arm with their measures, rows in descending order of μ.

    Attributes:
        q: (k, n) [rad], within the limits; θ_1, which is free, is 0 or the limit nearest to 0.
        manipulability: (k,) μ [m²].
        radius: (k,) distance of the tool from the base [m].
        inverse_condition: (k,) κ.
        on_limit: (k, n) whether each joint was held on a limit.
        complete: whether these are proven to be all stationary postures.
        bound: upper bound on μ over all allowed postures [m²]: the best μ when complete.
    """

    q: Array
    manipulability: Array
    radius: Array
    inverse_condition: Array
    on_limit: NDArray[np.bool_]
    complete: bool
    bound: float

    def __len__(self) -> int:
        return len(self.q)

    @property
    def best(self) -> "PostureSet":
        """The rows with the largest μ: the optimal posture, its mirror image, and others that are equally good."""
        rows = self.manipulability >= self.manipulability[0] * (1 - TIE)
        arrays = ("q", "manipulability", "radius", "inverse_condition", "on_limit")
        return replace(self, **{name: getattr(self, name)[rows] for name in arrays})


def stationary_postures(
    arm: PlanarArm, *, radius: float | None = None, lower: ArrayLike | None = None, upper: ArrayLike | None = None
) -> PostureSet:
    """All allowed postures at which μ is stationary; the optimal ones are `.best`.

    With neither radius nor limits: problem (5.4) in kth2012; `radius`: (5.5); limits: (5.6); both: (5.7), where
    "-θ_i <= -π/2" should read "-θ_i <= π/2". Singular postures (μ = 0) are included, since μ² is stationary there.

    With limits, a posture counts when μ is stationary while the joints on a limit stay on it: these are candidates for
    the maximum, whatever the signs of their multipliers.

    Args:
        arm: two to four links; with `radius`, two or three.
        radius: the tool's distance from the base [m].
        lower: lower joint limits, one number or (n,) [rad]. The limits of θ_1 do not change μ.
        upper: upper joint limits, likewise.

    Raises:
        InvalidInputError: too many links; a radius that is negative or cannot be reached within the limits; limits of a wrong
            shape or order.
    """
    check_links(arm, 2, MOST_LINKS)
    limits = AngleLimits.of(lower, upper, arm.n)
    if radius is None:
        bent, held, complete, bound = _free(arm, limits)
    else:
        check_links(arm, 2, 3)
        radius = number("radius", radius, least=0.0)
        bent, held = _at_radius(arm, limits, radius if radius > NO_RADIUS * float(arm.lengths.sum()) else 0.0)
        complete, bound = True, 0.0
    first = float(np.clip(0.0, limits.lower[0], limits.upper[0]))
    q = np.column_stack([np.full(len(bent), first), bent])
    q, on_limit = limits.placed(q), np.column_stack([np.zeros(len(held), dtype=bool), held])
    allowed = np.isfinite(q).all(axis=1)
    q, on_limit = q[allowed], on_limit[allowed]
    if radius is not None and not len(q):
        least, most = reachable_radii(arm, lower, upper)
        raise InvalidInputError("radius", radius, f"{least:.9g} to {most:.9g} m, the reach of the arm within its limits")
    mu = manipulability(arm, q)
    order = np.argsort(-mu, kind="stable")
    return PostureSet(
        q=q[order],
        manipulability=mu[order],
        radius=arm.radius(q)[order],
        inverse_condition=inverse_condition(arm, q)[order],
        on_limit=on_limit[order],
        complete=complete,
        bound=max(bound, float(mu.max())),
    )


def optimal_radius(arm: PlanarArm, *, lower: ArrayLike | None = None, upper: ArrayLike | None = None) -> float:
    """The distance from the base [m] at which μ is largest; section 5.3 in kth2012. Raises like `stationary_postures`."""
    return float(stationary_postures(arm, lower=lower, upper=upper).best.radius[0])


def stationary_kind(arm: PlanarArm, q: ArrayLike) -> str:
    """Kind of a stationary posture q (n,) without limits, by ∇²μ²: "maximum", "minimum", "saddle" or "degenerate"."""
    instance("arm", arm, PlanarArm)
    posture = configurations("q", q, arm.n)
    if posture.ndim != 1:
        raise InvalidInputError("q", posture.tolist(), f"one posture, shape ({arm.n},)")
    values = np.linalg.eigvalsh(squared_manipulability_hessian(arm, posture)[1:, 1:])
    if np.abs(values).min() <= 1e-9 * float(arm.lengths.sum()) ** 4:
        return "degenerate"
    return "maximum" if values[-1] < 0 else "minimum" if values[0] > 0 else "saddle"


def _free(arm: PlanarArm, limits: AngleLimits) -> tuple[Array, NDArray[np.bool_], bool, float]:
    """(θ_2, ..., θ_n) of all stationary postures inside and on each face of the limits, and which joints are held there.

    Also whether these are all of them, and a bound on μ where that is unresolved.
    """
    series, d = squared_manipulability_series(arm), arm.n - 1
    rows, held_rows, complete, bound = [], [], True, 0.0
    ends = [(None, *_ends(limits, i)) for i in range(1, arm.n)]
    for face in itertools.product(*ends):
        form, held = series, np.array([value is not None for value in face])
        for variable in reversed(range(d)):
            value = face[variable]
            if value is not None:
                form = form.restricted(variable, value)
        points, unresolved, half = _zeros_of_gradient(form)
        bent = np.tile([0.0 if value is None else value for value in face], (len(points), 1))
        bent[:, ~held] = points
        rows.append(bent)
        held_rows.append(np.tile(held, (len(points), 1)))
        if len(unresolved):
            complete = False
            bound = max(bound, _bound(form, unresolved, half))
    return np.concatenate(rows), np.concatenate(held_rows), complete, bound


def _zeros_of_gradient(form: TrigonometricPolynomial) -> tuple[Array, Array, float]:
    if not form.dimension:
        return np.zeros((1, 0)), np.zeros((0, 0)), 0.0
    zeros = torus_zeros([form.derivative(i) for i in range(form.dimension)])
    return zeros.points, zeros.unresolved, zeros.half_width


def _bound(form: TrigonometricPolynomial, centres: Array, half: float) -> float:
    """Upper bound on sqrt(f) in the boxes, by |∂_i f| <= Σ_k |c_k k_i|."""
    steep = float(np.hypot(form.cosine, form.sine) @ np.abs(form.frequencies).sum(axis=1))
    return float(np.sqrt(max(float(form(centres).max()) + steep * half, 0.0)))


def _at_radius(arm: PlanarArm, limits: AngleLimits, radius: float) -> tuple[Array, NDArray[np.bool_]]:
    """The same on the curve ‖f‖ = R: where μ is stationary along it, and where it meets a limit."""
    if arm.n == 2:
        elbow = _bends(float(arm.lengths[0]), float(arm.lengths[1]), radius)
        bent = np.array([[angle] for angle in elbow]).reshape(-1, 1)
        return bent, np.zeros(bent.shape, dtype=bool)
    l1, l2, l3 = (float(length) for length in arm.lengths)
    rows = [(*row, False, False) for row in fixed_radius_postures(arm, radius)]
    for second in _ends(limits, 1):  # links 1 and 2 are one rigid part
        part, offset = rigid_part(l1, l2, second)
        rows += [(second, bend + offset - second, True, False) for bend in _bends(part, l3, radius)]
    for third in _ends(limits, 2):  # links 2 and 3 are one rigid part
        part, offset = rigid_part(l2, l3, third)
        rows += [(bend - offset, third, False, True) for bend in _bends(l1, part, radius)]
    table = np.array(rows, dtype=np.float64).reshape(-1, 4)
    return table[:, :2], table[:, 2:] > 0


def _ends(limits: AngleLimits, joint: int) -> tuple[float, ...]:
    if not limits.bounded[joint]:
        return ()
    return tuple({float(limits.lower[joint]): None, float(limits.upper[joint]): None})


def _bends(first: float, second: float, radius: float) -> tuple[float, ...]:
    """The angles between two parts at which their ends are `radius` apart."""
    found = elbow_between(first, second, radius)
    if found is None:
        return ()
    bend, _ = found
    return (bend, -bend) if 0 < bend < np.pi else (bend,)
