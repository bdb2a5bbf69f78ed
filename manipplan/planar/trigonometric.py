"""Trigonometric polynomials on a torus; μ² and the squared radius of the planar arm in this form."""

from collections import defaultdict
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from manipplan.planar.arm import PlanarArm
from manipplan.support.checks import LARGEST_ANGLE, Array, configurations, instance, number, whole_number


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
    kept = {k: c for k, c in sorted(terms.items()) if c}
    frequencies = np.array(list(kept), dtype=np.float64)
    cosine = np.array([float(c) for c in kept.values()])
    return TrigonometricPolynomial(frequencies=frequencies, cosine=cosine, sine=np.zeros(len(cosine)))
