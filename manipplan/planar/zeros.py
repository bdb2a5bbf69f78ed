"""All zeros of a square system of trigonometric polynomials on the torus, found with proof by subdivision.

A box is discarded when bounds prove that one equation has no zero in it; it is done when Krawczyk's operator proves that it
contains exactly one [krawczyk1969]; otherwise it is halved along every angle. No zero is lost: a box for which neither can
be proven down to `SMALLEST` is returned as unresolved.

Trigonometric polynomials on a torus; μ² and the squared radius of the planar arm in this form.

Real roots of a polynomial with rational coefficients, counted by Sturm's theorem in exact arithmetic, so none is missed.
"""

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from itertools import pairwise
from math import gcd, lcm

import numpy as np
from numpy.polynomial.polynomial import polyder, polydiv, polymul
from numpy.typing import NDArray

from manipplan.planar.arm import PlanarArm
from manipplan.support.checks import LARGEST_ANGLE, Array, ArrayLike, configurations, entries, instance, number, whole_number
from manipplan.support.errors import InvalidInputError


@dataclass(frozen=True, kw_only=True, eq=False)
class TrigonometricPolynomial:
    """f(x) = Σ_k cosine_k cos(k · x) + sine_k sin(k · x) for x in R^d.

    Attributes:
        frequencies: (m, d) integer vectors k.
        cosine: (m,) coefficients.
        sine: (m,) coefficients.
    """

    frequencies: Array
    cosine: Array
    sine: Array

    @property
    def dimension(self) -> int:
        """Number d of angles."""
        return int(self.frequencies.shape[1])

    def __call__(self, x: ArrayLike) -> Array:
        """Values (...,) at x (..., d) [rad]."""
        phases = configurations("x", x, self.dimension) @ self.frequencies.T
        return np.asarray(np.cos(phases) @ self.cosine + np.sin(phases) @ self.sine)

    def derivative(self, variable: int) -> "TrigonometricPolynomial":
        """∂f/∂x_variable."""
        k = self.frequencies[:, whole_number("variable", variable, least=0, most=self.dimension - 1)]
        return TrigonometricPolynomial(frequencies=self.frequencies, cosine=k * self.sine, sine=-k * self.cosine)

    def restricted(self, variable: int, value: float) -> "TrigonometricPolynomial":
        """f with x_variable held at `value` [rad], a polynomial in the others."""
        variable = whole_number("variable", variable, least=0, most=self.dimension - 1)
        phase = self.frequencies[:, variable] * number("value", value, least=-LARGEST_ANGLE, most=LARGEST_ANGLE)
        c, s = np.cos(phase), np.sin(phase)
        return TrigonometricPolynomial(
            frequencies=np.delete(self.frequencies, variable, axis=1),
            cosine=self.cosine * c + self.sine * s,
            sine=self.sine * c - self.cosine * s,
        )


def squared_manipulability_series(arm: PlanarArm) -> TrigonometricPolynomial:
    """μ² as a cosine polynomial in (θ_2, ..., θ_n), for any link lengths [m⁴].

    From the squared minors with sin a sin b = (cos(a - b) - cos(a + b))/2. For unit links this is (5.2) in kth2012, corrected:
    5/2 + cos θ_2 - cos 2θ_2/2 + cos θ_3 - cos 2θ_3 - cos(2θ_2 + 2θ_3) - cos(2θ_2 + θ_3) - cos(θ_2 + 2θ_3). The printed version
    has 3/2 and -cos 2θ_3/2.
    """
    instance("arm", arm, PlanarArm)
    n, lengths = arm.n, arm.lengths
    terms: defaultdict[tuple[int, ...], float] = defaultdict(float)
    for i in range(n):
        for j in range(i + 1, n):
            minor = [(_sum(n, p, m), lengths[p] * lengths[m]) for p in range(i, j) for m in range(j, n)]
            for a, first in minor:
                for b, second in minor:
                    terms[_upward(a - b)] += first * second / 2
                    terms[_upward(a + b)] -= first * second / 2
    return _cosines(terms)


def squared_radius_series(arm: PlanarArm) -> TrigonometricPolynomial:
    """R² = Σ_i l_i² + 2 Σ_(p<m) l_p l_m cos(θ_(p+1) + ... + θ_m) as a cosine polynomial in (θ_2, ..., θ_n) [m²]."""
    instance("arm", arm, PlanarArm)
    n, lengths = arm.n, arm.lengths
    terms: defaultdict[tuple[int, ...], float] = defaultdict(float)
    terms[(0,) * (n - 1)] = float(lengths @ lengths)
    for p in range(n):
        for m in range(p + 1, n):
            terms[_upward(_sum(n, p, m))] += 2 * lengths[p] * lengths[m]
    return _cosines(terms)


def _sum(n: int, p: int, m: int) -> Array:
    """The frequency of φ_m - φ_p in (θ_2, ..., θ_n), with p < m counted from 0."""
    k = np.zeros(n - 1)
    k[p:m] = 1.0
    return k


def _upward(k: Array) -> tuple[int, ...]:
    """k or -k, whichever has a positive first nonzero entry: their cosines are the same."""
    lead = k[np.flatnonzero(k)[:1]]
    return tuple(int(x) for x in (-k if lead.size and lead[0] < 0 else k))


def _cosines(terms: dict[tuple[int, ...], float]) -> TrigonometricPolynomial:
    nonzero = {k: c for k, c in sorted(terms.items()) if c}
    frequencies = np.array(list(nonzero), dtype=np.float64)
    cosine = np.array([float(c) for c in nonzero.values()])
    return TrigonometricPolynomial(frequencies=frequencies, cosine=cosine, sine=np.zeros(len(cosine)))


#: Half width at which boxes are no longer split [rad].
SMALLEST = 1e-8
#: Maximum number of boxes examined; the rest is returned as unresolved.
MOST = 4_000_000
#: Factor by which a box is enlarged for Krawczyk's test, so that a zero on an edge can be proven.
MARGIN = 1.25
#: Proven zeros closer than this are one, found by neighbouring boxes: two would lie in one enlarged box [rad].
ZERO_DISTANCE = 1e-9
#: Maximum number of boxes per batch.
_BATCH = 60_000


@dataclass(frozen=True, kw_only=True, eq=False)
class Zeros:
    """All zeros of a system on the torus.

    Attributes:
        points: (k, d) in (-π, π] [rad], each in a box that contains no other.
        unresolved: (u, d) centres of boxes of half width at most `half_width` that may contain any number of zeros; there
            are no zeros elsewhere.
        half_width: largest half width of the unresolved boxes [rad], 0 when there are none.
        boxes: number of boxes examined.
    """

    points: Array
    unresolved: Array
    half_width: float
    boxes: int

    @property
    def complete(self) -> bool:
        """Whether `points` is proven to contain all zeros."""
        return not len(self.unresolved)


def torus_zeros(system: Sequence[TrigonometricPolynomial]) -> Zeros:
    """All x on the torus with f_i(x) = 0 for the d polynomials f_i of d angles."""
    system = entries("system", system, "a list of TrigonometricPolynomial")
    if not system or not all(isinstance(f, TrigonometricPolynomial) and f.dimension == len(system) for f in system):
        raise InvalidInputError("system", system, "as many TrigonometricPolynomial as each has angles")
    form = _System.of(system)
    d = form.dimension
    grid = (np.arange(8) + 0.5) / 8 * 2 * np.pi - np.pi
    work = [(np.stack(np.meshgrid(*[grid] * d, indexing="ij"), axis=-1).reshape(-1, d), np.pi / 8)]
    found: list[Array] = []
    left: list[tuple[Array, float]] = []
    boxes = 0
    while work:
        centres, half = work.pop()
        if len(centres) > _BATCH:
            work.append((centres[_BATCH:], half))
            centres = centres[:_BATCH]
        boxes += len(centres)
        points, open_ones = form.judge(centres, half)
        found.extend(points)
        if not len(open_ones):
            continue
        if half <= SMALLEST or boxes > MOST:
            left.append((open_ones, half))
            continue
        corners = np.stack(np.meshgrid(*[(-half / 2, half / 2)] * d, indexing="ij"), axis=-1).reshape(-1, d)
        work.append(((open_ones[:, None] + corners).reshape(-1, d), half / 2))
    proven = form.distinct(found)
    return Zeros(
        points=proven,
        unresolved=np.concatenate([each for each, _ in left]) if left else np.zeros((0, d)),
        half_width=max((half for _, half in left), default=0.0),
        boxes=boxes,
    )


@dataclass(frozen=True, kw_only=True, eq=False)
class _System:
    """f_i with common frequencies (m, d) and coefficients (m, d), one column per equation.

    Bounds: `bends` (d, d, d) on |∂_j ∂_l f_i|, and `rounding` on the rounding error, (d,) of a value and (d, d) of a slope.
    """

    frequencies: Array
    cosine: Array
    sine: Array
    bends: Array
    rounding: tuple[Array, Array]

    @classmethod
    def of(cls, system: Sequence[TrigonometricPolynomial]) -> "_System":
        frequencies = np.concatenate([f.frequencies for f in system])
        starts = np.cumsum([0, *(len(f.frequencies) for f in system)])
        cosine, sine = np.zeros((2, len(frequencies), len(system)))
        for i, f in enumerate(system):
            cosine[starts[i] : starts[i + 1], i] = f.cosine
            sine[starts[i] : starts[i + 1], i] = f.sine
        frequencies, position = np.unique(frequencies, axis=0, return_inverse=True)
        merge = np.equal.outer(np.arange(len(frequencies)), position.ravel()).astype(np.float64)
        cosine, sine = merge @ cosine, merge @ sine
        size, k = np.hypot(cosine, sine), np.abs(frequencies)
        # Relative rounding error of a term: sum of m terms, its coefficient, and the error of k · x with |x| <= 4.
        share = np.finfo(float).eps * (len(k) + 8 * (1 + k.sum(axis=1)))
        return cls(
            frequencies=frequencies,
            cosine=cosine,
            sine=sine,
            bends=np.einsum("mi,mj,ml->ijl", size, k, k),
            rounding=(np.einsum("mi,m->i", size, share), np.einsum("mi,mj,m->ij", size, k, share)),
        )

    @property
    def dimension(self) -> int:
        return int(self.frequencies.shape[1])

    def values(self, x: Array) -> tuple[Array, Array]:
        """f (B, d) and its Jacobian (B, d, d) at x (B, d)."""
        phases = x @ self.frequencies.T
        c, s = np.cos(phases), np.sin(phases)
        k = self.frequencies
        slopes = np.einsum("bm,mi,mj->bij", c, self.sine, k, optimize=True)
        slopes -= np.einsum("bm,mi,mj->bij", s, self.cosine, k, optimize=True)
        return c @ self.cosine + s @ self.sine, slopes

    def judge(self, centres: Array, half: float) -> tuple[list[Array], Array]:
        """Zeros (d,) of boxes proven to contain just one when enlarged, and the centres of boxes that stay open."""
        value, slope = self.values(centres)
        # |f_i(x) - f_i(c)| <= Σ_j |∂_j f_i(c)| h + Σ_jl bends_ijl h²/2 in the box
        steepness = np.abs(slope) + self.rounding[1]
        span = steepness.sum(axis=2) * half + self.bends.sum(axis=(1, 2)) * half**2 / 2 + self.rounding[0]
        alive = (np.abs(value) <= span).all(axis=1)
        centres, value, slope = centres[alive], value[alive], slope[alive]
        size = np.linalg.norm(slope, axis=(1, 2))
        regular = np.abs(np.linalg.det(slope)) > 1e-9 * size**self.dimension
        inverse = np.zeros_like(slope)
        inverse[regular] = np.linalg.inv(slope[regular])
        step, reach = self._krawczyk(value, slope, inverse, half * MARGIN)
        empty = regular & (np.abs(step) > reach + half).any(axis=1)  # all zeros of the enlarged box are outside the box
        single = regular & ~empty & (np.abs(step) + reach < half * MARGIN).all(axis=1)
        points = [self._refined(c - s) for c, s in zip(centres[single], step[single], strict=True)]
        return points, centres[~empty & ~single]

    def _krawczyk(self, value: Array, slope: Array, inverse: Array, half: float) -> tuple[Array, Array]:
        """Y f(c) and the radius of (I - Y J(box)) (box - c): zeros in the box are in c - Y f(c) ± the radius.

        If that is inside the box, the box contains exactly one. The radius includes a bound on rounding.
        """
        y = np.abs(inverse)
        step = np.einsum("bij,bj->bi", inverse, value)
        spread = self.bends.sum(axis=2) * half + self.rounding[1]  # of the entries of J in the box
        identity = np.abs(np.eye(self.dimension) - inverse @ slope) + np.einsum("bij,jk->bik", y, spread)
        return step, identity.sum(axis=2) * half + y @ self.rounding[0]

    def _refined(self, x: Array) -> Array:
        for _ in range(6):
            value, slope = self.values(x[None])
            x = x - np.linalg.solve(slope[0], value[0])
        return x

    def distinct(self, found: list[Array]) -> Array:
        """The zeros in (-π, π], without duplicates from neighbouring boxes."""
        zeros: list[Array] = []
        for x in found:
            turned = np.pi - np.mod(np.pi - x + 1e-9, 2 * np.pi) + 1e-9
            if all(np.abs(np.remainder(turned - y + np.pi, 2 * np.pi) - np.pi).max() > ZERO_DISTANCE for y in zeros):
                zeros.append(turned)
        return np.array(zeros).reshape(-1, self.dimension)


#: Width of the interval that encloses a root: a square root of it keeps 64-bit accuracy.
WIDTH = Fraction(1, 2**120)

#: Coefficients from the constant term up, each a Fraction, for the functions of `numpy.polynomial.polynomial`.
Polynomial = NDArray[np.object_]


def real_roots(coefficients: Sequence[Fraction] | Polynomial, lower: Fraction, upper: Fraction) -> list[Fraction]:
    """All real roots in [lower, upper], ascending, each to within 2⁻¹²⁰ and listed once whatever its multiplicity.

    The coefficients, from the constant term up, are not all zero.
    """
    p = _primitive(coefficients)
    if len(p) < 2 or lower > upper:
        return []
    chain = _sturm_chain(_square_free(p))
    roots = [lower] if not _value(chain[0], lower) else []
    work = [(lower, upper)]  # Sturm counts the roots in (a, b]
    while work:
        a, b = work.pop()
        count = _changes(chain, a) - _changes(chain, b)
        if count == 1:
            roots.append(_refined(chain[0], a, b))
        elif count > 1:
            middle = (a + b) / 2
            work += [(a, middle), (middle, b)]
    return sorted(roots)


def multiply(*polynomials: Sequence[Fraction] | Polynomial) -> Polynomial:
    """The product."""
    return reduce(polymul, polynomials, np.array([Fraction(1)]))


def _primitive(p: Sequence[Fraction] | Polynomial) -> list[int]:
    """A positive multiple with integer coefficients that have no common factor, without leading zeros."""
    coefficients = [Fraction(a) for a in p]
    while coefficients and not coefficients[-1]:
        coefficients.pop()
    common = lcm(*(a.denominator for a in coefficients))
    whole = [int(a * common) for a in coefficients]
    shared = gcd(*whole)
    return [a // shared for a in whole]


def _divided(p: list[int], d: list[int]) -> tuple[list[int], list[int]]:
    """Positive multiples of the quotient and of the remainder of p divided by d."""
    quotient, remainder = polydiv(*([Fraction(a) for a in each] for each in (p, d)))
    return _primitive(quotient), _primitive(remainder)


def _derivative(p: list[int]) -> list[int]:
    """A positive multiple of p'."""
    return _primitive(polyder([Fraction(a) for a in p]))


def _square_free(p: list[int]) -> list[int]:
    """p divided by its greatest common divisor with p': the same roots, each simple."""
    a, b = p, _derivative(p)
    while b:
        a, b = b, _divided(a, b)[1]
    return p if len(a) == 1 else _divided(p, a)[0]


def _sturm_chain(p: list[int]) -> list[list[int]]:
    chain = [p, _derivative(p)]
    while len(chain[-1]) > 1:
        chain.append([-c for c in _divided(chain[-2], chain[-1])[1]])
    return chain


def _value(p: list[int], x: Fraction) -> int:
    """p(x) times the positive power denominator(x)^degree."""
    result, power = 0, 1
    for a in reversed(p):
        result = result * x.numerator + a * power
        power *= x.denominator
    return result


def _changes(chain: list[list[int]], x: Fraction) -> int:
    signs = [value > 0 for value in (_value(p, x) for p in chain) if value]
    return sum(a != b for a, b in pairwise(signs))


def _refined(p: list[int], a: Fraction, b: Fraction) -> Fraction:
    """The one root of the square-free p in (a, b]."""
    end = _value(p, b)
    if not end:
        return b
    while b - a > WIDTH:
        middle = _round_fraction((a + b) / 2, b - a)
        value = _value(p, middle)
        if not value:
            return middle
        a, b = (a, middle) if (value > 0) == (end > 0) else (middle, b)
    return (a + b) / 2


def _round_fraction(x: Fraction, width: Fraction) -> Fraction:
    """A fraction with a small denominator within an eighth of `width` of x."""
    digits = 8 * (width.denominator // width.numerator + 1)
    digits = 1 << digits.bit_length()
    return Fraction(round(x * digits), digits)
